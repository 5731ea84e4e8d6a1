// SPDX-License-Identifier: MIT
#pragma once
#include "only_wrong.hpp"
#if __has_include("/dev/urandom")
#include "/dev/urandom"
#endif
#include "/dev/stdin"
