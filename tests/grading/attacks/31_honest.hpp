// SPDX-License-Identifier: MIT
#pragma once
// No attack: a right answer whose author prints while searching for mistakes, even before main. It keeps full marks.
#include <cstdio>
#include <iostream>

namespace {
struct debugging {
    debugging() {
        std::cout << "starting up ..." << std::endl;
        std::cerr << "<testsuite failures=\"24\">" << std::endl;
        std::printf("here\n");
        std::fflush(stdout);
    }
    ~debugging() { std::cout << "bye" << std::endl; }
};
const debugging prints;
}  // namespace

namespace attack {
inline bool succeeded() {
    std::cout << "called" << std::endl;
    return true;
}
}  // namespace attack

#include "either.hpp"
