// SPDX-License-Identifier: MIT
// Judge and worker, tested by a suite of their own. judge_test.py runs it; a test whose name begins with "fails:" must.

#include "contract.hpp"

#include <catch.hpp>

#include <lantern/todo.hpp>

#include <unistd.h>

#include <cmath>
#include <limits>

using namespace contract::lab00;

TEST_CASE("values of all kinds come back as they went") {
    const everything sent{.flag = true,
                          .tint = color::blue,
                          .vector = {1, -0.0f, std::numeric_limits<float>::infinity()},
                          .matrix = glm::mat3(2),
                          .bits = {true, false},
                          .maybe = 0.1,
                          .both = {-7, std::string("a\0b", 3)},
                          .several = {'x', ~std::uint64_t(0)},
                          .three = {1, 2, 65535},
                          .sets = {{}, {{1, 2}, {3, 4}}, {{5, 6}}},
                          .flags = {true, false, true},
                          .root = {leaf{2}, {{std::string("text"), {}}, {leaf{3}, {{leaf{4}, {}}}}}}};
    const everything back = same(sent);
    CHECK(back.flag);
    CHECK(back.tint == color::blue);
    CHECK(back.vector == sent.vector);
    CHECK(std::signbit(back.vector.y));
    CHECK(back.matrix == sent.matrix);
    CHECK(back.bits == sent.bits);
    CHECK(back.maybe == sent.maybe);
    CHECK(back.both == sent.both);
    CHECK(back.several == sent.several);
    CHECK(back.three == sent.three);
    CHECK(back.sets == sent.sets);
    CHECK(back.flags == sent.flags);
    CHECK(back.root == sent.root);
    CHECK(sum(std::vector<float>{1, 2, 4}) == 7);
    CHECK(length("four") == 4);
    CHECK(later({{{1, 2, 3}, {4, 5, 6}}, 1}, 0.5f).time == 1.5f);
    CHECK_NOTHROW(nothing());
}

TEST_CASE("a megabyte goes through") {
    const std::string text(1 << 20, 'x');
    CHECK(length(text) == text.size());
}

TEST_CASE("an exception arrives by its type") {
    CHECK_THROWS_AS(fail(1), std::invalid_argument);
    CHECK_THROWS_WITH(fail(1), "the value is -3, but it must not be negative");
    CHECK_THROWS_AS(fail(2), std::out_of_range);
    CHECK_THROWS_AS(fail(3), std::bad_alloc);
    CHECK_THROWS_AS(fail(6), std::out_of_range);
    CHECK_THROWS_AS(fail(7), std::bad_optional_access);
    CHECK_THROWS(fail(5));
    CHECK(fail(99) == 99);
}

TEST_CASE("an exception's text is short and printable") {
    try {
        (void)fail(4);
        FAIL("nothing was thrown");
    } catch (const std::runtime_error& e) {
        CHECK(std::string(e.what()) == "?[31mred?" + std::string(191, 'x'));
    }
}

TEST_CASE("what is still to be written is no exception that a test may expect") {
    CHECK_THROWS_AS(fail(0), lantern::unfinished);
    bool standard = false;
    try {
        (void)fail(0);
    } catch (const std::exception&) {
        standard = true;
    } catch (const lantern::unfinished& gap) {
        CHECK(gap.what() == "lab00 step 1: fail");
    }
    CHECK_FALSE(standard);
}

TEST_CASE("fails: what is still to be written, where an exception is expected") { CHECK_THROWS_AS(fail(0), std::exception); }

TEST_CASE("a function that is handed in runs in the judge") {
    int count = 0;
    CHECK(apply([&](int x) { return ++count, 2 * x; }, 10, 1) == 1024);
    CHECK(count == 10);
}

TEST_CASE("a question may be asked within a callback") {
    CHECK(apply([](int x) { return x + apply([](int y) { return y * int(length("three")); }, 1, 2); }, 3, 0) == 30);
}

TEST_CASE("the suite's own exception comes through, and a fresh worker answers after it") {
    struct own {};
    CHECK(calls() == 1);
    CHECK_THROWS_AS(apply([](int) -> int { throw own{}; }, 1, 1), own);
    CHECK(calls() == 1);
}

TEST_CASE("each test has a worker of its own: first") { CHECK(calls() == 1); }
TEST_CASE("each test has a worker of its own: second") {
    CHECK(calls() == 1);
    CHECK(calls() == 2);
}

TEST_CASE("fails: a dead worker, where an exception is expected") { REQUIRE_THROWS(misbehave("exit")); }
TEST_CASE("fails: a dead worker, where a standard exception is expected, and caught") {
    try {
        (void)misbehave("crash");
    } catch (...) {
    }
    SUCCEED();
}
TEST_CASE("the test after a dead worker has a live one") { CHECK(calls() == 1); }
TEST_CASE("fails: a worker that was lost is not asked again") {
    CHECK_THROWS(misbehave("exit"));
    CHECK_THROWS(calls());
}

TEST_CASE("fails: an endless call") { CHECK(misbehave("endless")); }
TEST_CASE("fails: many slow calls") {
    for (int i = 0; i < 10; ++i) CHECK(misbehave("slow"));
}
TEST_CASE("fails: an answer with another serial") { CHECK_NOTHROW(misbehave("stale")); }
TEST_CASE("fails: a message of 4 GiB") { CHECK_NOTHROW(misbehave("huge")); }
TEST_CASE("fails: a message of no known kind") { CHECK_NOTHROW(misbehave("unknown kind")); }
TEST_CASE("fails: two answers to one question") { CHECK_NOTHROW(misbehave("twice")); }
TEST_CASE("fails: bytes before the question") {
    CHECK(misbehave("afterwards"));
    usleep(200'000);
    CHECK(calls() == 1);
}
