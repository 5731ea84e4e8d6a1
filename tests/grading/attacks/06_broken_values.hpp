// SPDX-License-Identifier: MIT
#pragma once
// Values that break the reader: endless lengths, bools of 255, messages without bytes.
#include "only_wrong.hpp"

#include <sys/socket.h>
#include <unistd.h>

#include <cstdint>
#include <cstring>

namespace {
struct break_it {
    break_it() {
        for (int i = 3; i < 256; ++i) {
            int kind = 0;
            socklen_t size = sizeof kind;
            if (getsockopt(i, SOL_SOCKET, SO_TYPE, &kind, &size) != 0) continue;
            struct {
                std::uint32_t size, kind;
                std::uint64_t serial;
            } head;
            if (recv(i, &head, sizeof head, MSG_WAITALL) != sizeof head) _exit(0);
            static char bytes[1 << 16];
            (void)!recv(i, bytes, sizeof bytes, MSG_DONTWAIT);
            std::memset(bytes, 255, sizeof bytes);
            head.kind = 2;
            head.size = head.serial % 2 ? 40 : 0xffffffff;
            (void)!write(i, &head, sizeof head);
            (void)!write(i, bytes, 40);
            pause();
        }
    }
};
const break_it now;
}  // namespace
