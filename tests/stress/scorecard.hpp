// SPDX-License-Identifier: MIT
#pragma once
// Cases, how they are scored, and the card that says so.

#include "adapter.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace stress {

/// What is counted while a case runs.
class score {
public:
    /// Counts a variant. Whatever is not finite in an answer, and whatever is decided wrongly, is wrong.
    void right() { ++variants_; }
    void wrong(const std::string& what);
    void check(bool holds, const std::string& what) { holds ? right() : wrong(what); }

    /// An error in ulp of the truth, beside the decision.
    void error(double ulp, const std::string& what);

    [[nodiscard]] std::size_t variants() const { return variants_; }
    [[nodiscard]] std::size_t wrongs() const { return wrong_; }
    [[nodiscard]] double median() const;
    [[nodiscard]] double largest() const { return largest_; }
    [[nodiscard]] const std::string& first_wrong() const { return first_wrong_; }
    [[nodiscard]] const std::string& worst() const { return worst_; }

private:
    std::size_t variants_ = 0, wrong_ = 0;
    std::vector<double> errors_;
    double largest_ = 0;
    std::string first_wrong_, worst_;
};

/// `bound`: the largest error allowed; `gold`: the largest that the library allows itself.
struct test_case {
    std::string id;  ///< group/name
    std::string about, source, margin;
    double bound = 2, gold = 0.501;
    std::function<bool(const answers&)> asked;  ///< whether the answers have what it asks for
    std::function<void(const answers&, bool strict, score&)> run;
};

[[nodiscard]] std::string_view group_of(std::string_view id);

enum class verdict { pass, fail, not_there };

struct result {
    const test_case* of = nullptr;
    score counted;
    verdict said = verdict::not_there;
};

/// All cases, by group: those with truths from files, and those that are laws.
[[nodiscard]] std::vector<test_case> all_cases(const std::filesystem::path& data);

/// An answer that throws is wrong, but one that throws lantern::unfinished is not there. `strict`: as the library wants it.
[[nodiscard]] result run(const test_case& c, const answers& a, bool strict);

[[nodiscard]] std::string json_of(const std::vector<result>& results);
[[nodiscard]] std::string table_of(const std::vector<result>& results);

/// The library, the formulas of the textbooks, and both of them with one formula exchanged.
[[nodiscard]] answers library();
[[nodiscard]] answers textbook();

struct mutant {
    std::string name, who;
    std::vector<std::string> caught_by;  ///< cases, all of which must fail
    std::function<void(answers&)> put_in;
};
[[nodiscard]] std::vector<mutant> mutants();

// Where the cases come from.
void add_truths(std::vector<test_case>& cases, const std::filesystem::path& file);
void add_watertightness(std::vector<test_case>& cases);
void add_self_intersection(std::vector<test_case>& cases);
void add_twins(std::vector<test_case>& cases);
void add_wild_input(std::vector<test_case>& cases);
void add_bounds(std::vector<test_case>& cases);
void add_accelerators(std::vector<test_case>& cases);
void add_sampling(std::vector<test_case>& cases);
void add_image(std::vector<test_case>& cases);
void add_light(std::vector<test_case>& cases);

}  // namespace stress
