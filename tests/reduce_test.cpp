// SPDX-License-Identifier: MIT
#include <lantern/reduce.hpp>

#include <lantern/diffuse.hpp>
#include <lantern/plane.hpp>
#include <lantern/sphere.hpp>

#include "catch.hpp"

#include <concepts>
#include <limits>
#include <variant>

using lantern::all_but;
using lantern::any_of;
using lantern::coated;
using lantern::diffuse;
using lantern::gloss;
using lantern::glossy;
using lantern::mirror;
using lantern::motion;
using lantern::moving;
using lantern::object;
using lantern::plane;
using lantern::sphere;

namespace mine {

/// A type of one's own that can do without something.
struct wobbling {
    sphere body;
    float amplitude = 0;
};
bool needs(motion, const wobbling& w) { return w.amplitude != 0; }
sphere reduced(motion, const wobbling& w) { return w.body; }

}  // namespace mine

TEST_CASE("types lose what is left out, doubles collapse, and a single alternative is no choice") {
    using paint = std::variant<diffuse, mirror, glossy, coated<diffuse, glossy>>;
    using full = object<any_of<sphere, moving<sphere>, plane, lantern::rotating<plane>>, paint>;
    using still = decltype(reduced(motion{}, full{}));
    STATIC_REQUIRE(std::same_as<still, object<any_of<sphere, plane>, paint>>);
    using sharp = std::variant<diffuse, mirror, coated<diffuse, mirror>>;
    STATIC_REQUIRE(std::same_as<decltype(reduced(gloss{}, still{})), object<any_of<sphere, plane>, sharp>>);
    STATIC_REQUIRE(std::same_as<decltype(reduced(all_but<sphere>{}, still{})), object<sphere, paint>>);
    STATIC_REQUIRE(std::same_as<decltype(reduced(motion{}, any_of<sphere, moving<sphere>>{})), sphere>);
    STATIC_REQUIRE(std::same_as<decltype(reduced(gloss{}, std::variant<lantern::frosted, lantern::glass>{})), lantern::glass>);
    STATIC_REQUIRE(std::same_as<decltype(reduced(motion{}, any_of<plane, mine::wobbling>{})), any_of<plane, sphere>>);
}

TEST_CASE("values are what they were") {
    const object<any_of<sphere, moving<sphere>>, std::variant<diffuse, glossy>> o{moving{sphere{{1, 2, 3}, 4}, glm::vec3(0)},
                                                                                 glossy{.color = glm::vec3(0.5f), .width = 0}};
    CHECK_FALSE(needs(motion{}, o));
    CHECK_FALSE(needs(gloss{}, o));
    CHECK(reduced(motion{}, o).shape == sphere{{1, 2, 3}, 4});
    CHECK(std::get<mirror>(reduced(gloss{}, o).material).color == glm::vec3(0.5f));
    const auto coat = reduced(gloss{}, coated{diffuse{glm::vec3(0.2f)}, lantern::frosted{.body = {.index = 1.3f}, .width = 0}, 0.4f});
    CHECK(coat.share == 0.4f);
    CHECK(coat.coat.index == 1.3f);
    CHECK(coat.body.color == glm::vec3(0.2f));
}

TEST_CASE("what has an influence is needed, be it small, negative or not a number") {
    CHECK(needs(motion{}, moving{sphere{}, glm::vec3(0, 1e-30f, 0)}));
    CHECK(needs(motion{}, moving{sphere{}, glm::vec3(0, std::numeric_limits<float>::quiet_NaN(), 0)}));
    CHECK(needs(motion{}, lantern::rotating{sphere{}, glm::vec3(0), glm::vec3(0, 1, 0), -1.0f}));
    CHECK(needs(gloss{}, glossy{.width = 1e-30f}));
    CHECK(needs(gloss{}, coated{diffuse{}, lantern::frosted{}, 0.5f}));
    CHECK(needs(all_but<sphere>{}, any_of<sphere, plane>{plane{}}));
    CHECK(needs(motion{}, mine::wobbling{{}, 0.1f}));
    CHECK_FALSE(needs(motion{}, any_of<plane, mine::wobbling>{mine::wobbling{}}));
    CHECK_FALSE(needs(gloss{}, diffuse{}));
}
