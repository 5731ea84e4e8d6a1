// SPDX-License-Identifier: MIT
#include <lantern/alternative.hpp>

#include "catch.hpp"

#include <variant>

TEST_CASE("a value and the alternative of a variant are handed on alike") {
    const auto twice = [](const auto& x) { return static_cast<double>(2 * x); };
    CHECK(lantern::with_alternative(3, twice) == 6);
    CHECK(lantern::with_alternative(std::variant<int, double>(1.5), twice) == 3);
    STATIC_REQUIRE(lantern::with_alternative(4, [](int x) { return x; }) == 4);
}

TEST_CASE("what is handed on is the value itself, not a copy") {
    const int value = 1;
    CHECK(&lantern::with_alternative(value, [](const int& x) -> const int& { return x; }) == &value);
    const std::variant<int, char> choice = 'c';
    CHECK(lantern::with_alternative(choice, [](const auto& x) -> const void* { return &x; }) == std::get_if<char>(&choice));
}

TEST_CASE("a variant that holds none of its alternatives is refused") {
    struct refuses {
        explicit refuses(int) { throw 1; }
        ~refuses() {}  // NOLINT(modernize-use-equals-default): what is trivial, no variant ever loses
    };
    std::variant<int, refuses> empty;
    CHECK_THROWS_AS(empty.emplace<refuses>(2), int);
    REQUIRE(empty.valueless_by_exception());
    CHECK_THROWS_AS(lantern::with_alternative(empty, [](const auto&) { return 0; }), std::bad_variant_access);
}
