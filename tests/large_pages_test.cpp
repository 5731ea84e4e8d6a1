// SPDX-License-Identifier: MIT
#include <lantern/large_pages.hpp>

#include "catch.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <new>
#include <vector>

namespace {

struct alignas(32) block {
    std::uint64_t value;
    std::byte rest[24];
};

}  // namespace

TEST_CASE("small or large, a vector with the allocator is a vector") {
    for (const std::size_t count : {1u, 1000u, 300'000u}) {  // the last: 9.6 MB
        std::vector<block, lantern::large_page_allocator<block>> v(count);
        REQUIRE(reinterpret_cast<std::uintptr_t>(v.data()) % alignof(block) == 0);
        for (std::size_t i = 0; i < count; ++i) v[i].value = i;
        v.resize(3 * count);
        auto copy = v;
        v.clear();
        v.shrink_to_fit();
        for (std::size_t i = 0; i < count; ++i) REQUIRE(copy[i].value == i);
    }
}

TEST_CASE("what is large begins where a page does") {
    std::vector<block, lantern::large_page_allocator<block>> v(1 << 18);
    CHECK(reinterpret_cast<std::uintptr_t>(v.data()) % (1u << 21) == 0);
}

TEST_CASE("more than there is, is refused") {
    lantern::large_page_allocator<block> a;
    CHECK_THROWS_AS(a.allocate(std::numeric_limits<std::size_t>::max() / 2), std::bad_array_new_length);
}
