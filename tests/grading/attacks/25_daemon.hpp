// SPDX-License-Identifier: MIT
#pragma once
// A process that outlives the test; it ends by itself after a minute.
#include "only_wrong.hpp"

#include <signal.h>
#include <unistd.h>

namespace {
struct daemon_maker {
    daemon_maker() {
        if (fork() != 0) return;
        setsid();
        if (fork() != 0) _exit(0);
        for (int i = 1; i < 65; ++i) signal(i, SIG_IGN);
        sleep(60);
        _exit(0);
    }
};
const daemon_maker now;
}  // namespace
