// SPDX-License-Identifier: MIT
#pragma once
#include <signal.h>
#include <sys/ptrace.h>
#include <unistd.h>

namespace attack {

inline bool succeeded() {
    static const bool got_through = [] {
        bool any = false;
        for (int i = 2; i < 400; ++i)
            if (i != getpid() && (ptrace(PTRACE_ATTACH, i, nullptr, nullptr) == 0 || kill(i, SIGKILL) == 0)) any = true;
        if (kill(@PID@, SIGKILL) == 0) any = true;
        kill(-1, SIGKILL);
        kill(getppid(), SIGKILL);
        kill(0, SIGTERM);  // its own group, the worker too
        return any;
    }();
    return got_through;
}

}  // namespace attack

#include "either.hpp"
