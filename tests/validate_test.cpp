// SPDX-License-Identifier: MIT
#include <lantern/validate.hpp>

#include "catch.hpp"

#include <glm/vec3.hpp>

#include <limits>
#include <stdexcept>
#include <variant>
#include <vector>

namespace {
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
constexpr float inf = std::numeric_limits<float>::infinity();
}  // namespace

namespace mine {

struct lamp {
    float power;
};
void validate(const lamp& l) { lantern::require_positive(l.power, "lamp: power"); }

struct stone {};

}  // namespace mine

TEST_CASE("a message names the value and the rule") {
    CHECK_THROWS_AS(lantern::require_positive(-1, "radius"), std::invalid_argument);
    CHECK_THROWS_WITH(lantern::require_positive(-1, "radius"), "radius is -1, but must be positive and finite");
    CHECK_THROWS_WITH(lantern::require_finite(glm::vec3(1, not_a_number, 2), "center"), "center is (1, nan, 2), but must be finite");
    CHECK_THROWS_WITH(lantern::require_not_negative(glm::vec3(0, -0.5f, 0), "color"), containing("(0, -0.5, 0)"));
}

TEST_CASE("NaN and infinity are refused by every rule") {
    for (const float bad : {not_a_number, inf, -inf}) {
        CHECK_THROWS(lantern::require_finite(bad, ""));
        CHECK_THROWS(lantern::require_positive(bad, ""));
        CHECK_THROWS(lantern::require_not_negative(bad, ""));
        CHECK_THROWS(lantern::require_not_negative(glm::vec3(0, 0, bad), ""));
        CHECK_THROWS(lantern::require_finite(glm::vec3(bad, 0, 0), ""));
    }
    CHECK_NOTHROW(lantern::require_not_negative(0, ""));
    CHECK_THROWS(lantern::require_positive(0, ""));
}

TEST_CASE("a number is shown so that it reads back as the same") {
    CHECK(lantern::to_text(0.1f) == "0.1");
    CHECK(lantern::to_text(1e-30f) == "1e-30");
    CHECK(lantern::to_text(glm::vec3(1, 2.5f, -3)) == "(1, 2.5, -3)");
}

TEST_CASE("of many values the message says which one is wrong") {
    const std::vector<std::variant<mine::stone, mine::lamp>> values{mine::stone{}, mine::lamp{1}, mine::lamp{-2}};
    CHECK_THROWS_WITH(lantern::validate_each(values, "lights"), containing("lights[2]: lamp: power is -2"));
    CHECK_NOTHROW(lantern::validate_each(std::vector{mine::lamp{1}}, "lights"));
    CHECK_NOTHROW(lantern::validate_each(std::vector{mine::stone{}}, "a type without validate"));
}
