// SPDX-License-Identifier: MIT
#pragma once
// Messages through a socket. The judge trusts nothing that it receives; the worker has nothing to lose.

#include "wire.hpp"

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>

namespace contract {

/// Why no message came.
struct disconnected {
    enum class reason { closed, too_late, violation } why;
    std::string what;
};

class channel {
public:
    using clock = std::chrono::steady_clock;
    static constexpr clock::time_point no_limit = clock::time_point::max();

    explicit channel(int descriptor = -1) : descriptor_(descriptor) {}

    struct message {
        wire::kind what;
        std::uint64_t serial;
        std::string bytes;
    };

    /// Both throw `disconnected`, when `until` has passed at the latest.
    void send(wire::kind, std::uint64_t serial, std::string_view bytes, clock::time_point until);
    [[nodiscard]] message receive(clock::time_point until);

    /// Whether something stands ready to be received, be it the end.
    [[nodiscard]] bool has_news() const;

private:
    /// Waits until the socket can be read, or written; polls for some microseconds before it sleeps.
    void wait(short events, clock::time_point until) const;

    int descriptor_;
};

}  // namespace contract
