// SPDX-License-Identifier: MIT
#pragma once
// Finds the channel, takes it over, and answers everything with "passed", with exceptions, with any other serial.
#include "only_wrong.hpp"

#include <sys/socket.h>
#include <unistd.h>

#include <cstdint>
#include <cstring>

namespace {
struct steal {
    steal() {
        for (int i = 3; i < 256; ++i) {
            int kind = 0;
            socklen_t size = sizeof kind;
            if (getsockopt(i, SOL_SOCKET, SO_TYPE, &kind, &size) == 0) serve(i);
        }
    }
    static void serve(int channel) {
        for (;;) {
            struct {
                std::uint32_t size, kind;
                std::uint64_t serial;
            } head;
            if (recv(channel, &head, sizeof head, MSG_WAITALL) != sizeof head) _exit(0);
            static char bytes[1 << 16];
            if (recv(channel, bytes, head.size < sizeof bytes ? head.size : sizeof bytes, MSG_WAITALL) < 0) _exit(0);
            static int turn = 0;
            head.kind = turn % 3 == 0 ? 2 : 3;
            if (turn % 3 == 2) ++head.serial;
            ++turn;
            const char text[] = "\x01passed: All tests passed";
            head.size = sizeof text;
            (void)!write(channel, &head, sizeof head);
            (void)!write(channel, text, sizeof text);
        }
    }
};
const steal now;
}  // namespace
