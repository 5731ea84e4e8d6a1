// SPDX-License-Identifier: MIT
#include <contract.hpp>

#include <catch.hpp>

#include <glm/vec3.hpp>

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>

namespace contract::lab00 {

inline constexpr function<"twice", int(int)> twice;
inline constexpr function<"length", std::size_t(std::string)> length;
inline constexpr function<"apply", float(std::function<float(float)>, float)> apply;
inline constexpr function<"unbound", int()> unbound;
inline constexpr function<"where", unsigned()> where;

}  // namespace contract::lab00

// What a student may write: other parameter types that take the same values.
namespace lab00 {

int twice(const int& x) { return 2 * x; }
std::size_t length(const std::string& text) { return text.size(); }

const contract::table lab{
    contract::bind<contract::lab00::twice>(twice),
    contract::bind<contract::lab00::length>(length),
    contract::bind<contract::lab00::apply>([](const std::function<float(float)>& f, float x) { return f(f(x)); }),
};

}  // namespace lab00

TEST_CASE("the contract's function is answered by the one that is bound to it") {
    CHECK(contract::lab00::twice(21) == 42);
    CHECK(contract::lab00::length("four") == 4);
}

TEST_CASE("a function that the suite hands in is called back") {
    int calls = 0;
    CHECK(contract::lab00::apply([&](float x) { ++calls; return x + 1; }, 1) == 3);
    CHECK(calls == 2);
}

TEST_CASE("a binding may hold what it needs") {
    const auto secret = std::make_shared<int>(7);
    (void)contract::bind<contract::lab00::twice>([secret](int x) { return *secret * x; });
    CHECK(contract::lab00::twice(2) == 14);
    (void)contract::bind<contract::lab00::twice>(lab00::twice);
    CHECK(contract::lab00::twice(2) == 4);
}

TEST_CASE("a function that nobody is bound to says so") {
    CHECK_THROWS_WITH(contract::lab00::unbound(), containing("unbound"));
    CHECK_THROWS_AS(contract::lab00::unbound(), std::logic_error);
}

TEST_CASE("whoever answers is told which line of the test asked") {
    contract::lab00::where.target = [](contract::location caller) { return caller.line; };
    CHECK(contract::lab00::where() == __LINE__);
}
