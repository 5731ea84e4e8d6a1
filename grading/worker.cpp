// SPDX-License-Identifier: MIT
// The worker: the student's code, and nothing else that is worth anything. Answers questions until the judge ends it.

#include "worker.hpp"

#include "channel.hpp"

#include <lantern/todo.hpp>

#include <fcntl.h>
#include <unistd.h>

#include <exception>
#include <functional>
#include <new>
#include <optional>
#include <stdexcept>
#include <typeinfo>
#include <variant>

namespace contract::worker {

namespace {

constexpr int given = 3;  // where the judge puts the channel
int descriptor = given;

// Before the student's static initialisers: what they print to descriptor 3 by mistake is no answer. Whoever means to
// can find the channel still; it carries values, and the judge believes none of them.
[[gnu::constructor(101)]] void move_away() {
    const int moved = fcntl(given, F_DUPFD_CLOEXEC, 100);
    if (moved >= 0) {
        close(given);
        descriptor = moved;
    }
}

std::vector<handler>& handlers() {
    static std::vector<handler> all;
    return all;
}

std::optional<channel> judge;
std::vector<std::uint64_t> serials;  // of the questions that are being answered, the innermost last

/// The judge does not want an answer any more.
struct stopped {};

using wire::thrown;

template <class Exception>
bool is(const std::exception& e) {
    return dynamic_cast<const Exception*>(&e) != nullptr;
}

thrown type_of(const std::exception& e) {
    return is<std::bad_alloc>(e)              ? thrown::bad_alloc
           : is<std::bad_optional_access>(e)  ? thrown::bad_optional_access
           : is<std::bad_variant_access>(e)   ? thrown::bad_variant_access
           : is<std::bad_function_call>(e)    ? thrown::bad_function_call
           : is<std::invalid_argument>(e)     ? thrown::invalid_argument
           : is<std::domain_error>(e)         ? thrown::domain_error
           : is<std::length_error>(e)         ? thrown::length_error
           : is<std::out_of_range>(e)         ? thrown::out_of_range
           : is<std::logic_error>(e)          ? thrown::logic_error
           : is<std::range_error>(e)          ? thrown::range_error
           : is<std::overflow_error>(e)       ? thrown::overflow_error
           : is<std::underflow_error>(e)      ? thrown::underflow_error
           : is<std::runtime_error>(e)        ? thrown::runtime_error
                                              : thrown::exception;
}

void send(wire::kind what, std::uint64_t serial, std::string_view bytes) { judge->send(what, serial, bytes, channel::no_limit); }

void send_exception(std::uint64_t serial, thrown type, std::string_view text) {
    wire::encoder out;
    wire::write(out, std::uint8_t(type));
    wire::write(out, text.substr(0, 1000));
    send(wire::kind::exception, serial, out.bytes());
}

void answer_question(const channel::message& question) {
    serials.push_back(question.serial);
    try {
        wire::decoder in(question.bytes);
        const auto index = in.number<std::uint32_t>();
        wire::encoder out;
        handlers().at(index)(in, out);
        send(wire::kind::answer, question.serial, out.bytes());
    } catch (const disconnected&) {
        throw;
    } catch (const stopped&) {
    } catch (const lantern::unfinished& gap) {
        send_exception(question.serial, thrown::unfinished, gap.what());
    } catch (const std::exception& e) {
        send_exception(question.serial, type_of(e), e.what());
    } catch (...) {
        send_exception(question.serial, thrown::other, "something that is no std::exception");
    }
    serials.pop_back();
}

}  // namespace

void serve(std::uint32_t index, handler one) {
    if (handlers().size() <= index) handlers().resize(index + 1);
    handlers()[index] = std::move(one);
}

std::string call_back(std::uint32_t which, std::string_view arguments) {
    wire::encoder out;
    wire::write(out, which);
    out.raw(arguments.data(), arguments.size());
    send(wire::kind::callback, serials.empty() ? 0 : serials.back(), out.bytes());
    for (;;) {
        channel::message next = judge->receive(channel::no_limit);
        if (next.what == wire::kind::question) answer_question(next);
        else if (next.what == wire::kind::reply) return std::move(next.bytes);
        else throw stopped{};
    }
}

}  // namespace contract::worker

int main() {
    using namespace contract;
    worker::judge.emplace(worker::descriptor);
    try {
        for (;;) worker::answer_question(worker::judge->receive(channel::no_limit));
    } catch (const disconnected&) {
        _exit(0);
    }
}
