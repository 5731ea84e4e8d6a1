// SPDX-License-Identifier: MIT
#include <lantern/save.hpp>

#include "catch.hpp"
#include "scratch.hpp"

#include <array>
#include <sstream>
#include <thread>
#include <vector>

#if __has_include(<sys/resource.h>)
#include <sys/resource.h>
#include <unistd.h>
#include <csignal>
#endif

namespace fs = std::filesystem;
using lantern::save;

namespace {

void put(const fs::path& path, const std::string& text) {
    save(path, [&](std::ostream& out) { out << text; });
}

}  // namespace

TEST_CASE("what is saved stands in the file, and the writer's result is returned") {
    const scratch_folder folder;
    const int result = save(folder / "a", [](std::ostream& out) {
        out << "whole";
        return 7;
    });
    CHECK(result == 7);
    CHECK(text_of(folder / "a") == "whole");
    CHECK(folder.entries() == 1);
}

TEST_CASE("missing folders are created") {
    const scratch_folder folder;
    put(folder / "out/of/nowhere/a", "x");
    CHECK(text_of(folder / "out/of/nowhere/a") == "x");
}

TEST_CASE("a file is replaced, longer by shorter") {
    const scratch_folder folder;
    put(folder / "a", "something long");
    put(folder / "a", "short");
    CHECK(text_of(folder / "a") == "short");
}

TEST_CASE("a bare file name goes to the current folder") {
    const scratch_folder folder;
    const fs::path before = fs::current_path();
    fs::current_path(folder.path());
    put("a", "here");
    fs::current_path(before);
    CHECK(text_of(folder / "a") == "here");
}

TEST_CASE("line ends are written as they are, and names may be long or foreign") {
    const scratch_folder folder;
    for (const std::string& name : {std::string("Grüße, 世界 & co.ppm"), std::string(255, 'n')}) {
        put(folder / name, "1\n2\r\n");
        CHECK(text_of(folder / name) == "1\n2\r\n");
    }
}

TEST_CASE("a writer that throws leaves the old file as it was and nothing else") {
    const scratch_folder folder;
    put(folder / "a", "old");
    const auto broken = [](std::ostream& out) {
        out << "half of the n";
        throw std::logic_error("mine");
    };
    CHECK_THROWS_AS(save(folder / "a", broken), std::logic_error);
    CHECK_THROWS_AS(save(folder / "b", broken), std::logic_error);
    CHECK(text_of(folder / "a") == "old");
    CHECK(folder.entries() == 1);
}

TEST_CASE("a writer that leaves its stream in a failed state is an error") {
    const scratch_folder folder;
    const auto broken = [](std::ostream& out) { out.setstate(std::ios::badbit); };
    CHECK_THROWS_WITH(save(folder / "a", broken), containing((folder / "a").string()));
    CHECK(folder.entries() == 0);
}

TEST_CASE("a path that cannot be written is named, with the system's reason") {
    const scratch_folder folder;
    put(folder / "file", "x");
    fs::create_directory(folder / "folder");
    const auto message = [&](const fs::path& path) {
        try {
            put(path, "y");
        } catch (const std::runtime_error& problem) {
            CHECK_THAT(problem.what(), containing("cannot write " + path.string() + ": "));
            return std::string(problem.what());
        }
        return std::string("no error");
    };
    CHECK_THAT(message(folder / "folder"), containing("directory"));
    CHECK_THAT(message(folder / "folder/"), containing("directory"));
    CHECK_THAT(message(folder / "missing/"), containing("directory"));
    CHECK_THAT(message(folder / "file/a"), containing("ot a directory"));
    CHECK_THAT(message(folder / "file/a/b"), containing("ot a directory"));
    CHECK_THAT(message(folder / std::string(256, 'n')), containing("too long"));
    CHECK_THAT(message(""), containing("cannot write"));
    CHECK(folder.entries() == 2);
}

TEST_CASE("a symbolic link stays a link: what it points to is written, be it there or not") {
    const scratch_folder folder;
    fs::create_directory(folder / "sub");
    fs::create_symlink("sub/other", folder / "link");
    fs::create_symlink(folder / "sub/target", folder / "sub/other");
    for (const std::string text : {"new", "newer"}) {
        put(folder / "link", text);
        CHECK(fs::is_symlink(folder / "link"));
        CHECK(fs::is_symlink(folder / "sub/other"));
        CHECK(text_of(folder / "sub/target") == text);
    }
    CHECK(folder.entries() == 4);
    fs::create_symlink("circle", folder / "circle");
    CHECK_THROWS_WITH(put(folder / "circle", "x"), containing("circle: Too many levels"));
    CHECK(folder.entries() == 5);
}

TEST_CASE("a file that is replaced keeps its permissions") {
    const scratch_folder folder;
    put(folder / "private", "x");
    fs::permissions(folder / "private", fs::perms::owner_read | fs::perms::owner_write);
    put(folder / "private", "y");
    CHECK(fs::status(folder / "private").permissions() == (fs::perms::owner_read | fs::perms::owner_write));
}

TEST_CASE("devices are written to, never replaced by a file") {
    if (!fs::is_character_file("/dev/null") || !fs::is_character_file("/dev/full")) return;
    put("/dev/null", "x");
    CHECK(fs::is_character_file("/dev/null"));
    CHECK_THROWS_WITH(put("/dev/full", "x"), containing("/dev/full: No space left on device"));
    CHECK(fs::is_character_file("/dev/full"));
}

#if __has_include(<sys/resource.h>)
TEST_CASE("a pipe is written to, also through a link such as /dev/stdout") {
    std::array<int, 2> ends{};
    if (!fs::exists("/proc/self/fd") || pipe(ends.data()) != 0) return;
    put("/proc/self/fd/" + std::to_string(ends[1]), "through");
    std::array<char, 7> text{};
    CHECK(read(ends[0], text.data(), text.size()) == 7);
    CHECK(std::string(text.data(), text.size()) == "through");
    close(ends[0]);
    close(ends[1]);
}

TEST_CASE("when room runs out midway the old file stands, and nothing else") {
    const scratch_folder folder;
    put(folder / "a", "old");
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    rlimit small = before;
    small.rlim_cur = 100'000;
    setrlimit(RLIMIT_FSIZE, &small);
    std::string problem;
    try {
        put(folder / "a", std::string(1'000'000, 'x'));
    } catch (const std::runtime_error& e) {
        problem = e.what();
    }
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    CHECK_THAT(problem, containing("File too large"));
    CHECK(text_of(folder / "a") == "old");
    CHECK(folder.entries() == 1);
}
#endif

TEST_CASE("writers of one path do not disturb each other: one of them wins, whole") {
    const scratch_folder folder;
    {
        std::vector<std::jthread> writers;
        for (char c : {'a', 'b', 'c', 'd'})
            writers.emplace_back([&, c] {
                for (int i = 0; i < 25; ++i) put(folder / "file", std::string(20'000, c));
            });
    }
    const std::string text = text_of(folder / "file");
    CHECK(text.size() == 20'000);
    CHECK(text == std::string(20'000, text[0]));
    CHECK(folder.entries() == 1);
}

TEST_CASE("a stream that fails is an error that names the system's reason") {
    const auto text = [](std::ostream& out) { out << std::string(100'000, 'x'); };
    std::ostringstream good;
    CHECK(save(good, [](std::ostream& out) { return out << "x", 3; }) == 3);
    CHECK(good.str() == "x");

    good.setstate(std::ios::badbit);
    CHECK_THROWS_WITH(save(good, text), containing("cannot write to the stream: "));

    if (!fs::exists("/dev/full")) return;
    std::ofstream full("/dev/full");
    CHECK_THROWS_WITH(save(full, text), containing("cannot write to the stream: No space left on device"));
    std::ofstream full_later("/dev/full");  // what is small fails only when it is flushed
    CHECK_THROWS_WITH(save(full_later, [](std::ostream& out) { out << "x"; }), containing("No space left on device"));
}
