// SPDX-License-Identifier: MIT
#pragma once
// Bounded: 2^9 processes at most, each of which ends after some seconds, wherever nothing else stops them.
#include <sys/wait.h>
#include <unistd.h>

namespace attack {

inline bool succeeded() {
    static const bool got_through = [] {
        const pid_t first = getpid();
        bool refused = false;
        for (int i = 0; i < 9 && !refused; ++i) refused = fork() < 0;
        if (getpid() != first) {
            sleep(3);
            _exit(0);
        }
        return !refused;
    }();
    return got_through;
}

}  // namespace attack

#include "either.hpp"
