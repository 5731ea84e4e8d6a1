// SPDX-License-Identifier: MIT
#pragma once
// Bounded, wherever nothing else stops it: 128 processes, each of which forks once more and ends after some seconds.
#include <sys/wait.h>
#include <unistd.h>

namespace attack {

inline bool succeeded() {
    static const bool got_through = [] {
        for (int i = 0; i < 128; ++i) {
            const pid_t child = fork();
            if (child < 0) return false;
            if (child == 0) {
                (void)!fork();
                sleep(3);
                _exit(0);
            }
        }
        return true;
    }();
    return got_through;
}

}  // namespace attack

#include "either.hpp"
