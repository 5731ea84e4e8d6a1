// SPDX-License-Identifier: MIT
#include <lantern/load.hpp>

#include "catch.hpp"
#include "scratch.hpp"

#include <sstream>

namespace {

/// Runs use(reader) over the text and returns the message of what it throws.
template <class Use>
std::string problem(const std::string& text, Use&& use) {
    std::istringstream in(text);
    lantern::byte_reader from(in, "test");
    try {
        use(from);
    } catch (const std::runtime_error& e) {
        return e.what();
    }
    return "none";
}

}  // namespace

TEST_CASE("words are told apart by any white space, and comments are skipped") {
    std::istringstream in("one\ttwo\r\n# a comment, with a # in it\n  # another\nthree\n\0rest");
    lantern::byte_reader from(in, "test");
    CHECK(from.word() == "one");
    CHECK(from.word() == "two");
    CHECK(from.word() == "three");
}

TEST_CASE("exactly one white-space character behind a word is taken: what follows may be pixels that look like space") {
    std::istringstream in("255\n\n\n ");
    lantern::byte_reader from(in, "test");
    CHECK(from.number(255, "value") == 255);
    CHECK(from.bytes(3) == std::vector<unsigned char>{'\n', '\n', ' '});
}

TEST_CASE("numbers outside the range, and what is no number, are refused by name") {
    const auto number = [](auto& from) { (void)from.number(1000, "width"); };
    CHECK(problem("1000 ", number) == "none");
    CHECK_THAT(problem("0 ", number), containing("test: width is 0, but must be 1 to 1000 at byte 2"));
    CHECK_THAT(problem("1001 ", number), containing("width is 1001"));
    CHECK_THAT(problem("4294967297 ", number), containing("width is 4294967297"));
    CHECK_THAT(problem("99999999999999999999999999999999 ", number), containing("1 to 1000"));
    CHECK_THAT(problem("-1 ", number), containing("\"-1\""));
    CHECK_THAT(problem("1e2 ", number), containing("must be a number"));
    CHECK_THAT(problem("\x01\xff ", number), containing("\"??\""));
    CHECK_THAT(problem("100", number), containing("ends early at byte 3"));
    CHECK_THAT(problem("", number), containing("ends early at byte 0"));
    CHECK_THAT(problem("# only a comment", number), containing("ends early"));
}

TEST_CASE("a word without end is not collected") {
    CHECK_THAT(problem(std::string(1'000'000, 'x'), [](auto& from) { (void)from.word(); }),
               containing("longer than 32"));
}

TEST_CASE("bytes are read to the last one, and memory is not asked for before they arrive") {
    const std::string text(3'000'000, 'x');
    std::istringstream in(text);
    lantern::byte_reader from(in, "test");
    CHECK(from.bytes(0).empty());
    CHECK(from.bytes(2'999'999).size() == 2'999'999);
    CHECK_THROWS_AS(from.bytes(2), std::runtime_error);

    const auto bytes = [](auto& short_file) { (void)short_file.bytes(std::size_t{1} << 60); };  // an exabyte
    CHECK_THAT(problem(text, bytes), containing("ends early"));
}

TEST_CASE("a file that cannot be read is named, with the reason") {
    const scratch_folder folder;
    const auto nothing = [](std::istream&) { return 0; };
    CHECK_THROWS_WITH(lantern::load(folder / "missing", nothing),
                      containing("cannot read " + (folder / "missing").string() + ": No such file"));
    CHECK_THROWS_WITH(lantern::load(folder.path(), nothing), containing("directory"));
    CHECK_THROWS_AS(lantern::load("", nothing), std::runtime_error);

    put_text(folder / "a", "x");
    CHECK(lantern::load(folder / "a", [](std::istream& in) { return in.get(); }) == 'x');
    const auto fails = [](std::istream&) -> int { throw std::runtime_error("no good"); };
    CHECK_THROWS_WITH(lantern::load(folder / "a", fails), containing((folder / "a").string() + ": no good"));
}
