// SPDX-License-Identifier: MIT
#include <lantern/obj.hpp>

#include <lantern/bvh.hpp>
#include <lantern/closest.hpp>

#include "catch.hpp"
#include "oracle.hpp"
#include "scratch.hpp"

#include <sstream>
#include <stdexcept>
#include <string>

namespace {

lantern::mesh read(const std::string& text) {
    std::istringstream in(text);
    return lantern::read_obj(in);
}

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

}  // namespace

TEST_CASE("vertices and faces arrive, whatever else is in the file") {
    const auto m = read("# a comment\r\nmtllib nowhere.mtl\no thing\n" + square +
                        "vt 0 0\ng first\nusemtl red\ns 1\n  f 1 2 3  # half\n\nf\t1/1 3/1 4/1");
    REQUIRE(m.size() == 2);
    CHECK(m[0].c == glm::vec3(1, 1, 0));
    CHECK(m[1].c == glm::vec3(0, 1, 0));
    CHECK(m.vertices().size() == 4);
    CHECK(m.normals().empty());
}

TEST_CASE("indices may count from the end, and polygons become fans") {
    const auto m = read(square + "f -4 -3 -2 -1\n");
    REQUIRE(m.size() == 2);
    CHECK(m.triangles()[1] == glm::uvec3(0, 2, 3));
    const auto h = closest(lantern::bvh{m}, m, lantern::ray{{0.25f, 0.5f, 1}, {0, 0, -1}});
    REQUIRE(h);
    CHECK(h->normal == glm::vec3(0, 0, 1));
}

TEST_CASE("normals come along; a point with two normals becomes two vertices at one place") {
    const auto m = read(square + "vn 0 0 1\nvn 1 0 1\nf 1//1 2//1 3//1\nf 1//2 3//1 4//2\n");
    REQUIRE(m.size() == 2);
    CHECK(m.vertices().size() == 5);
    REQUIRE(m.normals().size() == 5);
    CHECK(m.normals()[m.triangles()[1].x] == glm::vec3(1, 0, 1));
    CHECK(m[1].a == m[0].a);
    const auto some = read(square + "vn 1 0 1\nf 1//1 2//1 3//1\nf 1 3 4\n");
    CHECK(some.normals()[some.triangles()[1].z] == glm::vec3(0));
}

TEST_CASE("numbers are read in all their forms") {
    const auto m = read("v +1.5 -2e-3 .25\nv 1E2 0 -0\nv 0 1 0 1.0\nf 1 2 3\n");
    CHECK(m[0].a == glm::vec3(1.5f, -2e-3f, 0.25f));
    CHECK(m[0].b == glm::vec3(100, 0, 0));
}

TEST_CASE("a broken file is refused with its line and what is wrong there") {
    CHECK_THROWS_AS(read(""), std::runtime_error);
    CHECK_THROWS_WITH(read(""), containing("no faces"));
    CHECK_THROWS_WITH(read(square), containing("no faces"));
    CHECK_THROWS_WITH(read("v 0 0 0\nv 0 nan 0\n"), containing("line 2: \"nan\" is no finite number"));
    CHECK_THROWS_WITH(read("v 0 0 inf\n"), containing("\"inf\""));
    CHECK_THROWS_WITH(read("v 0 0 1e99\n"), containing("\"1e99\""));
    CHECK_THROWS_WITH(read("v 0 0 1x\n"), containing("\"1x\""));
    CHECK_THROWS_WITH(read("v 0 0\n"), containing("line 1: a vector needs three"));
    CHECK_THROWS_WITH(read("vn 0 zero 1\n"), containing("\"zero\""));
    CHECK_THROWS_WITH(read(square + "f 1 2\n"), containing("line 5: a face needs three"));
    CHECK_THROWS_WITH(read(square + "f 1 2 5\n"), containing("line 5: vertex 5 is asked for, but there are 4"));
    CHECK_THROWS_WITH(read(square + "\r\nf 1 2 -5\n"), containing("line 6: vertex -5"));
    CHECK_THROWS_WITH(read(square + "f 0 1 2\n"), containing("vertex 0"));
    CHECK_THROWS_WITH(read("f 1 2 3\n" + square), containing("vertex 1 is asked for, but there are 0"));
    CHECK_THROWS_WITH(read(square + "f 1//1 2//1 3//1\n"), containing("normal 1"));
    CHECK_THROWS_WITH(read(square + "f 1 2 4294967297\n"), containing("no corner"));
    CHECK_THROWS_WITH(read(square + "f 1 2 \x01\x02\n"), containing("\"??\" is no corner of a face"));
    CHECK_THROWS_WITH(read(square + "f 1 /2 3\n"), containing("no corner"));
    CHECK_THROWS_WITH(read(square + "f 1/1/1/1 2 3\n"), containing("no corner"));
}

TEST_CASE("no bytes at all bring it down") {
    dice d{.state = 5};
    const std::string letters = "vvffn 0123-/.e+#\n\n\r\t\x80";
    for (int i = 0; i < 3000; ++i) {
        std::string text = square;
        for (int k = 0; k < 60; ++k) text += letters[d.below(static_cast<std::uint32_t>(letters.size()))];
        try {
            (void)read(text);
        } catch (const std::runtime_error&) {
        }
    }
    CHECK_THROWS_WITH(read(square + std::string(5, '\0') + "f 1 2 3"), containing("obj"));
}

TEST_CASE("files: a missing one, a folder, and one that is there") {
    const scratch_folder folder;
    CHECK_THROWS_WITH(lantern::read_obj(folder / "none.obj"), containing("none.obj: No such file"));
    CHECK_THROWS_WITH(lantern::read_obj(folder.path()), containing("cannot read"));
    put_text(folder / "bad.obj", square + "f 1 2 9\n");
    CHECK_THROWS_WITH(lantern::read_obj(folder / "bad.obj"), containing("bad.obj: obj: line 5: vertex 9"));
    put_text(folder / "good.obj", square + "f 1 2 3\n");
    CHECK(lantern::read_obj(folder / "good.obj").size() == 1);
}
