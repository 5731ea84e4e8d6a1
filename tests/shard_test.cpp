// SPDX-License-Identifier: MIT
#include <lantern/shard.hpp>

#include <lantern/camera.hpp>
#include <lantern/sobol.hpp>

#include "catch.hpp"

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

using namespace lantern;

namespace {

constexpr glm::uvec2 size{7, 5};

/// Colours of many sizes, a few NaN; they depend on the numbers drawn alone.
glm::vec3 noise(const ray& r, const auto& source) {
    const glm::vec2 xi = source.draw2(purpose::scatter);
    if (xi.x < 0.01f) return glm::vec3(std::numeric_limits<float>::quiet_NaN());
    return {std::exp(40 * (xi.x - 0.5f)), xi.y - 0.6f, r.direction.x * xi.y};
}

template <class Filter = box_filter>
shard part(std::uint32_t first, std::uint32_t last, unsigned threads = 1, const Filter& filter = {}) {
    return render_shard("noise", size, camera{view{}}, sobol{.samples = 48, .seed = 3}, {first, last},
                        [](const ray& r, const auto& source) { return noise(r, source); }, {.threads = threads}, filter);
}

/// A folder of its own that is gone afterwards.
struct folder {
    std::filesystem::path path = std::filesystem::temp_directory_path() / ("lantern_shard_test_" + std::to_string(std::hash<std::string>{}(__TIME__)));
    folder() { std::filesystem::create_directories(path); }
    ~folder() { std::filesystem::remove_all(path); }
};

std::string bytes_of(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream all;
    all << in.rdbuf();
    return all.str();
}

}  // namespace

TEST_CASE("parts merged in any order are the whole, byte for byte") {
    const shard whole = part(0, 48), a = part(0, 5), b = part(5, 31), c = part(31, 48);
    for (const auto& order : {std::array{&a, &b, &c}, std::array{&c, &a, &b}, std::array{&b, &c, &a}}) {
        const shard all = merged(merged(*order[0], *order[1]), *order[2]);
        CHECK(all.ranges == whole.ranges);
        CHECK(all.sums == whole.sums);
        CHECK(all.complete());
        CHECK(picture_of(all) == picture_of(whole));
    }
    CHECK_FALSE(merged(a, c).complete());
}

TEST_CASE("a single sample a part will do, and a filter with negative lobes") {
    const shard whole = part(0, 48, 1, mitchell_filter{});
    shard all = part(47, 48, 1, mitchell_filter{});
    for (std::uint32_t i = 0; i < 47; ++i) all = merged(all, part(i, i + 1, 1, mitchell_filter{}));
    CHECK(all.sums == whole.sums);
}

TEST_CASE("the number of threads makes no difference") { CHECK(part(3, 40, 7).sums == part(3, 40, 1).sums); }

TEST_CASE("the picture is what render makes, up to the rounding of its sums") {
    const image expected = render(size, camera{view{}}, sobol{.samples = 48, .seed = 3},
                                  [](const ray& r, const auto& source) { return noise(r, source); });
    const image picture = picture_of(part(0, 48));
    CHECK(picture.rejected() == expected.rejected());
    CHECK(picture.rejected() > 0);
    for (std::size_t i = 0; i < picture.pixels().size(); ++i)
        for (int k = 0; k < 3; ++k) CHECK(picture.pixels()[i][k] == Approx(expected.pixels()[i][k]).epsilon(1e-6).margin(1e-7));
}

TEST_CASE("a part comes back from its file, and nothing else does") {
    const folder here;
    const shard written = merged(part(0, 5), part(20, 48));
    write_shard(here.path / "a.shard", written);
    const shard read = read_shard(here.path / "a.shard");
    CHECK(read.scene == written.scene);
    CHECK(read.size == written.size);
    CHECK(read.samples == written.samples);
    CHECK(read.ranges == written.ranges);
    CHECK(read.sums == written.sums);

    const std::string whole = bytes_of(here.path / "a.shard");
    const auto refused = [&](const std::string& bytes) {
        std::ofstream(here.path / "b.shard", std::ios::binary) << bytes;
        CHECK_THROWS_AS(read_shard(here.path / "b.shard"), std::runtime_error);
    };
    for (std::size_t length = 0; length < whole.size(); length += 1 + length / 40) refused(whole.substr(0, length));
    refused(whole + "x");
    refused("P6\n" + whole);
    refused("lantern-shard-1\nscene\n65536 65536 48 1\n0 48\n4000000000\n");
    refused("lantern-shard-1\nscene\n1 1 48 2\n0 5\n4 48\n30\n" + std::string(30, '\0'));
    refused("lantern-shard-1\nscene\n1 1 48 1\n0 49\n30\n" + std::string(30, '\0'));
    refused("lantern-shard-1\nscene\n1 1 48 1\n0 48\n30\n" + std::string(30, '\x7f'));
    CHECK_THROWS_AS(read_shard(here.path / "none.shard"), std::runtime_error);
}

TEST_CASE("what does not belong together is refused") {
    const shard a = part(0, 5);
    CHECK_THROWS_AS(merged(a, part(4, 6)), std::invalid_argument);
    CHECK_THROWS_AS(merged(a, a), std::invalid_argument);
    shard other = part(5, 6);
    other.scene = "another";
    CHECK_THROWS_AS(merged(a, other), std::invalid_argument);
    other = part(5, 6);
    other.samples = 64;
    CHECK_THROWS_AS(merged(a, other), std::invalid_argument);
    CHECK_THROWS_AS(part(5, 5), std::invalid_argument);
    CHECK_THROWS_AS(part(5, 49), std::invalid_argument);
    CHECK_THROWS_AS(render_shard("two\nlines", size, camera{view{}}, sobol{}, {0, 1}, [](const ray&, const auto&) { return glm::vec3(0); }), std::invalid_argument);
}
