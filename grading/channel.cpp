// SPDX-License-Identifier: MIT
#include "channel.hpp"

#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstring>

#ifndef MSG_NOSIGNAL
#define MSG_NOSIGNAL 0  // macOS: the judge ignores SIGPIPE
#endif

namespace contract {

namespace {

[[noreturn]] void closed() { throw disconnected{disconnected::reason::closed, "ended"}; }

}  // namespace

void channel::wait(short events, clock::time_point until) const {
    for (;;) {
        int milliseconds = -1;
        if (until != no_limit) {
            const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - clock::now()).count();
            if (left <= 0) throw disconnected{disconnected::reason::too_late, "did not answer in time"};
            milliseconds = int(std::min<long long>(left, INT_MAX));
        }
        pollfd waiting{descriptor_, events, 0};
        const int ready = poll(&waiting, 1, milliseconds);
        if (ready > 0) return;
        if (ready < 0 && errno != EINTR) closed();
    }
}

bool channel::has_news() const {
    pollfd waiting{descriptor_, POLLIN, 0};
    return poll(&waiting, 1, 0) != 0;
}

void channel::send(wire::kind what, std::uint64_t serial, std::string_view bytes, clock::time_point until) {
    const wire::header head{std::uint32_t(bytes.size()), what, serial};
    std::string all(reinterpret_cast<const char*>(&head), sizeof head);
    all.append(bytes);
    for (std::string_view rest = all; !rest.empty();) {
        const ssize_t sent = ::send(descriptor_, rest.data(), rest.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
        if (sent >= 0) rest.remove_prefix(std::size_t(sent));
        else if (errno == EAGAIN || errno == EWOULDBLOCK) wait(POLLOUT, until);
        else if (errno != EINTR) closed();
    }
}

channel::message channel::receive(clock::time_point until) {
    const auto fill = [&](char* to, std::size_t size) {
        while (size > 0) {
            // recv, not recvmsg: descriptors that the other side may pass along are dropped by the system.
            const ssize_t got = ::recv(descriptor_, to, size, MSG_DONTWAIT);
            if (got > 0) {
                to += got;
                size -= std::size_t(got);
            } else if (got == 0 || (errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR)) closed();
            else if (errno != EINTR) wait(POLLIN, until);
        }
    };
    wire::header head;
    fill(reinterpret_cast<char*>(&head), sizeof head);
    if (head.size > wire::largest_message) throw disconnected{disconnected::reason::violation, "sent a message that is too large"};
    message received{head.what, head.serial, {}};
    // In pieces, so that a length without its bytes costs no memory.
    constexpr std::size_t piece = 1 << 16;
    while (received.bytes.size() < head.size) {
        const std::size_t had = received.bytes.size();
        received.bytes.resize(std::min<std::size_t>(head.size, had + std::max(piece, had)));
        fill(received.bytes.data() + had, received.bytes.size() - had);
    }
    return received;
}

}  // namespace contract
