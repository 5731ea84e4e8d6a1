// SPDX-License-Identifier: MIT
// The scorecard. ./lab stress runs it; --help says what it can be asked.

#include "scorecard.hpp"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace stress;

struct wish {
    std::string adapter = "library", mutant, group, only;
    std::filesystem::path data = LANTERN_STRESS_DATA;
    bool json = false, strict = false, list = false, mutants = false;
};

constexpr const char* usage =
    "usage: stress [--adapter library|textbook] [--mutant NAME] [--group NAME] [--case ID] [--strict] [--json] [--list]\n"
    "              [--mutants] [--data FOLDER]\n"
    "  --strict    half an ulp, and right even where the margin is below an ulp of the input: what the library must reach\n"
    "  --list      the cases: what they are about, where it is written, the margin\n"
    "  --mutants   every mutant fails the cases that it names\n";

wish parse(int argc, char** argv) {
    wish w;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        const auto next = [&]() -> std::string {
            if (++i < argc) return argv[i];
            throw std::invalid_argument(word + " needs a word after it");
        };
        if (word == "--adapter") w.adapter = next();
        else if (word == "--mutant") w.mutant = next();
        else if (word == "--group") w.group = next();
        else if (word == "--case") w.only = next();
        else if (word == "--data") w.data = next();
        else if (word == "--json") w.json = true;
        else if (word == "--strict") w.strict = true;
        else if (word == "--list") w.list = true;
        else if (word == "--mutants") w.mutants = true;
        else throw std::invalid_argument("what is '" + word + "'?");
    }
    return w;
}

answers chosen(const wish& w) {
    if (w.adapter != "library" && w.adapter != "textbook") throw std::invalid_argument("no adapter is called '" + w.adapter + "'");
    answers a = w.adapter == "library" ? library() : textbook();
    if (w.mutant.empty()) return a;
    for (const mutant& m : mutants())
        if (m.name == w.mutant) {
            m.put_in(a);
            return a;
        }
    throw std::invalid_argument("no mutant is called '" + w.mutant + "'");
}

/// Each mutant, put into the library, fails what it says, and some case of the library's passes.
bool all_caught(const std::vector<test_case>& cases) {
    bool good = true;
    for (const mutant& m : mutants()) {
        answers a = library();
        m.put_in(a);
        std::printf("%s (%s)\n", m.name.c_str(), m.who.c_str());
        for (const std::string& id : m.caught_by) {
            const auto c = std::find_if(cases.begin(), cases.end(), [&](const test_case& t) { return t.id == id; });
            const result r = c == cases.end() ? result{} : run(*c, a, false);
            const bool caught = r.said == verdict::fail;
            good = good && caught;
            std::printf("  %-8s %s: %zu wrong, %.3g ulp\n", caught ? "caught" : "MISSED", id.c_str(), r.counted.wrongs(), r.counted.largest());
        }
    }
    return good;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const wish w = parse(argc, argv);
        std::vector<test_case> cases = all_cases(w.data);
        if (w.mutants) return all_caught(cases) ? 0 : 1;
        std::erase_if(cases, [&](const test_case& c) {
            return (!w.group.empty() && group_of(c.id) != w.group) || (!w.only.empty() && c.id != w.only);
        });
        if (cases.empty()) throw std::invalid_argument("there is no such case");
        if (w.list) {
            for (const test_case& c : cases)
                std::printf("%s\n  %s\n  source: %s\n  margin: %s\n", c.id.c_str(), c.about.c_str(), c.source.c_str(), c.margin.c_str());
            return 0;
        }
        const answers a = chosen(w);
        std::vector<result> results;
        for (const test_case& c : cases) results.push_back(run(c, a, w.strict));
        const std::string text = w.json ? json_of(results) : table_of(results);
        std::fputs(text.c_str(), stdout);
        return std::none_of(results.begin(), results.end(), [](const result& r) { return r.said == verdict::fail; }) ? 0 : 1;
    } catch (const std::invalid_argument& problem) {
        std::fprintf(stderr, "stress: %s\n%s", problem.what(), usage);
        return 2;
    } catch (const std::exception& problem) {
        std::fprintf(stderr, "stress: %s\n", problem.what());
        return 1;
    }
}
