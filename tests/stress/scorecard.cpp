// SPDX-License-Identifier: MIT
#include "scorecard.hpp"

#include <lantern/todo.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>

namespace stress {

void score::wrong(const std::string& what) {
    ++variants_;
    ++wrong_;
    if (first_wrong_.empty()) first_wrong_ = what;
}

void score::error(double ulp, const std::string& what) {
    if (!(ulp < 1e30)) ulp = 1e30;
    errors_.push_back(ulp);
    if (ulp > largest_) {
        largest_ = ulp;
        worst_ = what;
    }
}

double score::median() const {
    if (errors_.empty()) return 0;
    std::vector<double> sorted(errors_);
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    return *middle;
}

std::string_view group_of(std::string_view id) { return id.substr(0, id.find('/')); }

std::vector<test_case> all_cases(const std::filesystem::path& data) {
    std::vector<test_case> cases;
    for (const char* group : {"sphere", "plane", "quadrics", "triangle", "transforms", "boxes", "basis", "refraction", "warps",
                              "camera", "image", "light"})
        add_truths(cases, data / (std::string(group) + ".txt"));
    add_twins(cases);
    add_wild_input(cases);
    add_watertightness(cases);
    add_bounds(cases);
    add_self_intersection(cases);
    add_accelerators(cases);
    add_sampling(cases);
    add_image(cases);
    add_light(cases);
    // Groups stay together, in the order of their first case.
    std::vector<std::string> order;
    for (const test_case& c : cases)
        if (std::find(order.begin(), order.end(), group_of(c.id)) == order.end()) order.emplace_back(group_of(c.id));
    std::stable_sort(cases.begin(), cases.end(), [&](const test_case& a, const test_case& b) {
        const auto place = [&](const test_case& c) { return std::find(order.begin(), order.end(), group_of(c.id)); };
        return place(a) < place(b);
    });
    return cases;
}

result run(const test_case& c, const answers& a, bool strict) {
    result r;
    r.of = &c;
    if (!c.asked(a)) return r;
    try {
        c.run(a, strict, r.counted);
    } catch (const lantern::unfinished&) {
        return {&c, {}, verdict::not_there};
    } catch (const std::exception& problem) {
        r.counted.wrong(std::string("an exception: ") + problem.what());
    }
    if (r.counted.variants() == 0) r.counted.wrong("nothing was asked");
    r.said = r.counted.wrongs() == 0 && r.counted.largest() <= (strict ? c.gold : c.bound) ? verdict::pass : verdict::fail;
    return r;
}

namespace {

const char* name_of(verdict v) { return v == verdict::pass ? "pass" : v == verdict::fail ? "fail" : "n/a"; }

template <class... Values>
std::string formatted(const char* format, Values... values) {
    std::array<char, 400> text{};
    std::snprintf(text.data(), text.size(), format, values...);
    return text.data();
}

}  // namespace

std::string json_of(const std::vector<result>& results) {
    std::string text = "{\"cases\":[";
    for (const result& r : results) {
        if (text.back() == '}') text += ',';
        text += formatted("\n{\"id\":\"%s\",\"group\":\"%s\",\"wrong\":%zu,\"ulp_p50\":%.6g,\"ulp_max\":%.6g,\"verdict\":\"%s\"}",
                          r.of->id.c_str(), std::string(group_of(r.of->id)).c_str(), r.counted.wrongs(), r.counted.median(),
                          r.counted.largest(), name_of(r.said));
    }
    return text + "\n]}\n";
}

std::string table_of(const std::vector<result>& results) {
    std::string text;
    std::string_view group;
    std::array<int, 3> counts{};
    for (const result& r : results) {
        if (group_of(r.of->id) != group) {
            group = group_of(r.of->id);
            text += formatted("\n%-46s %7s %8s %8s\n", std::string(group).c_str(), "wrong", "ulp p50", "ulp max");
        }
        ++counts[static_cast<std::size_t>(r.said)];
        const std::string name = r.of->id.substr(group.size() + 1);
        if (r.said == verdict::not_there) {
            text += formatted("  %-44s %7s %8s %8s  n/a\n", name.c_str(), "", "", "");
            continue;
        }
        text += formatted("  %-44s %7zu %8.3g %8.3g  %s\n", name.c_str(), r.counted.wrongs(), r.counted.median(), r.counted.largest(),
                          name_of(r.said));
        if (r.said == verdict::fail) {
            text += "      " + r.of->about + (r.of->source.empty() ? "" : " (" + r.of->source + ")") + "\n";
            if (r.counted.wrongs() > 0)
                text += formatted("      %zu of %zu wrong; the first: ", r.counted.wrongs(), r.counted.variants()) + r.counted.first_wrong() + "\n";
            if (r.counted.largest() > r.of->bound) text += formatted("      %.3g ulp: ", r.counted.largest()) + r.counted.worst() + "\n";
        }
    }
    text += formatted("\n%zu cases: %d pass, %d fail, %d n/a\n", results.size(), counts[0], counts[1], counts[2]);
    return text;
}

}  // namespace stress
