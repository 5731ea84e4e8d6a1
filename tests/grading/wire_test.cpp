// SPDX-License-Identifier: MIT
#include <wire.hpp>

#include <catch.hpp>

#include <string>
#include <variant>
#include <vector>

using namespace contract::wire;

namespace {

struct node {
    std::vector<node> below;
};
struct empty {};
enum class mood : std::int8_t { good = 1 };

template <class T>
std::string bytes_of(const T& value) {
    encoder out;
    write(out, value);
    return std::string(out.bytes());
}

/// What the reader says of these bytes; "" when it takes them.
template <class T>
std::string refusal(std::string_view bytes) {
    try {
        decoder in(bytes);
        (void)read<T>(in);
        in.finish();
        return "";
    } catch (const violation& broken) {
        return broken.what;
    }
}

std::string length(std::uint64_t n) { return bytes_of(n); }

node nested(int levels) {
    node n;
    if (levels > 1) n.below.push_back(nested(levels - 1));
    return n;
}

}  // namespace

TEST_CASE("a bool is 0 or 1, and nothing else") {
    CHECK(refusal<bool>(std::string("\0", 1)).empty());
    CHECK(refusal<bool>("\x01").empty());
    CHECK_THAT(refusal<bool>("\x02"), containing("bool"));
    CHECK_THAT(refusal<bool>("\xff"), containing("bool"));
    CHECK_THAT(refusal<std::optional<float>>("\x07"), containing("bool"));
    CHECK_THAT(refusal<std::vector<bool>>(length(2) + "\x01\x03"), containing("bool"));
    CHECK_THAT(refusal<glm::bvec2>("\x01\x03"), containing("bool"));
}

TEST_CASE("a variant's index is one of its types") {
    using choice = std::variant<std::uint8_t, bool>;
    CHECK(refusal<choice>(std::string("\0\x05", 2)).empty());
    CHECK_THAT(refusal<choice>("\x02\x01"), containing("variant"));
}

TEST_CASE("a length is no longer than its message, and no larger than the budget") {
    CHECK(refusal<std::vector<float>>(length(1) + "1234").empty());
    CHECK_THAT(refusal<std::vector<float>>(length(2) + "1234"), containing("longer"));
    CHECK_THAT(refusal<std::vector<float>>(length(~std::uint64_t(0))), containing("longer"));
    CHECK_THAT(refusal<std::string>(length(1u << 31)), containing("longer"));
    CHECK(refusal<std::vector<empty>>(length(1000)).empty());
    CHECK_THAT(refusal<std::vector<empty>>(length(1u << 30)), containing("too large"));
    // Many small sequences together, each within the message.
    std::string many = length(6'000'000);
    for (int i = 0; i < 6'000'000; ++i) many += std::string(8, '\0');
    CHECK_THAT(refusal<std::vector<std::vector<float>>>(many), containing("too large"));
}

TEST_CASE("bytes are neither missing nor left over") {
    CHECK_THAT(refusal<float>("123"), containing("too early"));
    CHECK_THAT(refusal<glm::vec3>("12345678901"), containing("too early"));
    CHECK_THAT(refusal<float>("12345"), containing("behind"));
}

TEST_CASE("values nest 64 levels deep and no deeper") {
    CHECK(refusal<node>(bytes_of(nested(64))).empty());
    CHECK_THAT(refusal<node>(bytes_of(nested(65))), containing("deeply"));
}

TEST_CASE("a message holds 32 MiB and no more") {
    CHECK_NOTHROW(bytes_of(std::string((32u << 20) - 8, 'x')));
    CHECK_THROWS_AS(bytes_of(std::string((32u << 20) - 7, 'x')), std::length_error);
}

TEST_CASE("an enum travels as its number") { CHECK(bytes_of(mood::good) == "\x01"); }
