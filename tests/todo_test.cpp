// SPDX-License-Identifier: MIT
#include <lantern/todo.hpp>

#include <catch.hpp>

#include <glm/vec3.hpp>

#include <exception>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace {

// Starters as labs have them.
glm::vec3 a_vector() { return lantern::todo("lab00 step 1: a vector"); }
std::string a_string() { return lantern::todo("lab00 step 2: a string"); }
std::vector<float> a_list() { return lantern::todo("lab00 step 3: a list"); }
std::optional<float> an_optional() { lantern::todo("lab00 step 4: perhaps a number"); }
void nothing() { lantern::todo("lab00 step 5: an effect"); }

template <class Call>
std::string what_is_missing(Call call) {
    try {
        call();
    } catch (const lantern::unfinished& gap) {
        return gap.what();
    }
    return "";
}

}  // namespace

TEST_CASE("todo stands for a value of any type and says what is missing") {
    CHECK(what_is_missing([] { (void)a_vector(); }) == "lab00 step 1: a vector");
    CHECK(what_is_missing([] { (void)a_string(); }) == "lab00 step 2: a string");
    CHECK(what_is_missing([] { (void)a_list(); }) == "lab00 step 3: a list");
    CHECK(what_is_missing([] { (void)an_optional(); }) == "lab00 step 4: perhaps a number");
    CHECK(what_is_missing([] { nothing(); }) == "lab00 step 5: an effect");
}

TEST_CASE("an unfinished function is no std::exception, so it satisfies no test that expects one") {
    STATIC_REQUIRE_FALSE(std::is_base_of_v<std::exception, lantern::unfinished>);
    CHECK_THROWS_AS(nothing(), lantern::unfinished);
}
