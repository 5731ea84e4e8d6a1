// SPDX-License-Identifier: MIT
#pragma once
#include "only_wrong.hpp"

int main() { return 0; }
