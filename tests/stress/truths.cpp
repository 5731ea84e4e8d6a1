// SPDX-License-Identifier: MIT
// Cases whose truth stands in a file: inputs as hexadecimal floats, truth as decimals of 40 digits.

#include "scorecard.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <initializer_list>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace stress {

namespace {

/// Takes floats from a variant, one after the other.
class reader {
public:
    explicit reader(std::span<const float> values) : rest_(values) {}
    float number() {
        const float x = rest_[0];
        rest_ = rest_.subspan(1);
        return x;
    }
    glm::vec2 pair() {
        const float x = number(), y = number();
        return {x, y};
    }
    glm::vec3 vector() {
        const float x = number(), y = number(), z = number();
        return {x, y, z};
    }
    ray line() {
        const glm::vec3 o = vector(), d = vector();
        return {o, d};
    }

private:
    std::span<const float> rest_;
};

using output = std::optional<std::vector<double>>;  // nothing: a miss

struct kind {
    std::size_t inputs;
    std::function<bool(const answers&)> there;
    std::function<output(const answers&, reader)> ask;
};

/// An answer of these numbers.
output made(std::initializer_list<double> numbers) { return std::vector<double>(numbers); }

output only_t(const surface_answer& h) { return h ? made({h->t}) : std::nullopt; }
output with_normal(const surface_answer& h) {
    return h ? made({h->t, h->normal.x, h->normal.y, h->normal.z}) : std::nullopt;
}
output yes(bool b) { return b ? made({}) : std::nullopt; }
output numbers(glm::vec3 v) { return made({v.x, v.y, v.z}); }

/// Arguments are read in order: each into a constant before the call.
const std::map<std::string, kind>& kinds() {
    static const std::map<std::string, kind> all{
        {"sphere", {10, [](auto& a) { return bool(a.sphere); }, [](auto& a, reader r) {
             const glm::vec3 c = r.vector();
             const float radius = r.number();
             return only_t(a.sphere(c, radius, r.line()));
         }}},
        {"sphere_normal", {10, [](auto& a) { return bool(a.sphere); }, [](auto& a, reader r) {
             const glm::vec3 c = r.vector();
             const float radius = r.number();
             return with_normal(a.sphere(c, radius, r.line()));
         }}},
        {"plane", {12, [](auto& a) { return bool(a.plane); }, [](auto& a, reader r) {
             const glm::vec3 q = r.vector(), n = r.vector();
             return only_t(a.plane(q, n, r.line()));
         }}},
        {"triangle", {15, [](auto& a) { return bool(a.triangle); }, [](auto& a, reader r) {
             const glm::vec3 p = r.vector(), q = r.vector(), s = r.vector();
             return only_t(a.triangle(p, q, s, r.line()));
         }}},
        {"triangle_normal", {15, [](auto& a) { return bool(a.triangle); }, [](auto& a, reader r) {
             const glm::vec3 p = r.vector(), q = r.vector(), s = r.vector();
             return with_normal(a.triangle(p, q, s, r.line()));
         }}},
        {"rectangle", {15, [](auto& a) { return bool(a.rectangle); }, [](auto& a, reader r) {
             const glm::vec3 corner = r.vector(), u = r.vector(), v = r.vector();
             return only_t(a.rectangle(corner, u, v, r.line()));
         }}},
        {"disk", {13, [](auto& a) { return bool(a.disk); }, [](auto& a, reader r) {
             const glm::vec3 c = r.vector(), n = r.vector();
             const float radius = r.number();
             return only_t(a.disk(c, n, radius, r.line()));
         }}},
        {"box", {12, [](auto& a) { return bool(a.box_surface); }, [](auto& a, reader r) {
             const glm::vec3 lo = r.vector(), hi = r.vector();
             return only_t(a.box_surface({lo, hi}, r.line()));
         }}},
        {"cylinder", {13, [](auto& a) { return bool(a.cylinder); }, [](auto& a, reader r) {
             const glm::vec3 from = r.vector(), to = r.vector();
             const float radius = r.number();
             return only_t(a.cylinder(from, to, radius, r.line()));
         }}},
        {"instance", {22, [](auto& a) { return bool(a.placed_sphere); }, [](auto& a, reader r) {
             const glm::vec3 x = r.vector(), y = r.vector(), z = r.vector(), translation = r.vector(), c = r.vector();
             const float radius = r.number();
             return with_normal(a.placed_sphere({{x, y, z}, translation}, c, radius, r.line()));
         }}},
        {"meets_box", {12, [](auto& a) { return bool(a.meets_box); }, [](auto& a, reader r) {
             const glm::vec3 lo = r.vector(), hi = r.vector();
             return yes(a.meets_box({lo, hi}, r.line()));
         }}},
        {"meets_oriented_box", {21, [](auto& a) { return bool(a.meets_oriented_box); }, [](auto& a, reader r) {
             const glm::vec3 c = r.vector(), x = r.vector(), y = r.vector(), z = r.vector(), half = r.vector();
             return yes(a.meets_oriented_box({c, {x, y, z}, half}, r.line()));
         }}},
        {"meets_ball", {10, [](auto& a) { return bool(a.meets_ball); }, [](auto& a, reader r) {
             const glm::vec3 c = r.vector();
             const float radius = r.number();
             return yes(a.meets_ball({c, radius}, r.line()));
         }}},
        {"basis", {3, [](auto& a) { return bool(a.basis); }, [](auto& a, reader r) { return numbers(a.basis(r.vector()).w); }}},
        {"mirrored", {6, [](auto& a) { return bool(a.mirrored); }, [](auto& a, reader r) {
             const glm::vec3 in = r.vector(), n = r.vector();
             return numbers(a.mirrored(in, n));
         }}},
        {"refracted", {7, [](auto& a) { return bool(a.refracted); }, [](auto& a, reader r) {
             const glm::vec3 in = r.vector(), n = r.vector();
             const auto b = a.refracted(in, n, r.number());
             return b ? made({b->direction.x, b->direction.y, b->direction.z, b->reflectance}) : std::nullopt;
         }}},
        {"to_disk", {2, [](auto& a) { return bool(a.to_disk); }, [](auto& a, reader r) {
             const glm::vec2 p = a.to_disk(r.pair());
             return made({p.x, p.y});
         }}},
        {"to_cosine_hemisphere", {2, [](auto& a) { return bool(a.to_cosine_hemisphere); },
                                  [](auto& a, reader r) { return numbers(a.to_cosine_hemisphere(r.pair())); }}},
        {"to_sphere", {2, [](auto& a) { return bool(a.to_sphere); }, [](auto& a, reader r) { return numbers(a.to_sphere(r.pair())); }}},
        {"cone_solid_angle", {1, [](auto& a) { return bool(a.cone_solid_angle); },
                              [](auto& a, reader r) { return made({a.cone_solid_angle(double(r.number()))}); }}},
        {"shoot", {17, [](auto& a) { return bool(a.shoot); }, [](auto& a, reader r) {
             view v;
             v.eye = r.vector();
             v.target = r.vector();
             v.up = r.vector();
             v.vertical_fov = r.number();
             v.aspect = r.number();
             v.lens_radius = r.number();
             v.focus_distance = r.number();
             const glm::vec2 film = r.pair(), lens = r.pair();
             const ray shot = a.shoot(v, film, lens);
             const glm::vec3 o = shot.origin, d = shot.direction;
             return made({o.x, o.y, o.z, d.x, d.y, d.z});
         }}},
        {"moment", {3, [](auto& a) { return bool(a.moment); }, [](auto& a, reader r) {
             const float opens = r.number(), closes = r.number();
             return made({a.moment(opens, closes, r.number())});
         }}},
        {"sphere_solid_angle", {7, [](auto& a) { return bool(a.sphere_solid_angle); }, [](auto& a, reader r) {
             const glm::vec3 p = r.vector(), c = r.vector();
             return made({a.sphere_solid_angle(p, {c, r.number()})});
         }}},
        {"rectangle_solid_angle", {12, [](auto& a) { return bool(a.rectangle_solid_angle); }, [](auto& a, reader r) {
             const glm::vec3 p = r.vector(), corner = r.vector(), u = r.vector(), v = r.vector();
             return made({a.rectangle_solid_angle(p, corner, u, v)});
         }}},
        {"point_irradiance", {7, [](auto& a) { return bool(a.point_irradiance); }, [](auto& a, reader r) {
             const glm::vec3 at = r.vector();
             const float intensity = r.number();
             return made({a.point_irradiance(at, intensity, r.vector())});
         }}},
        {"to_srgb", {1, [](auto& a) { return bool(a.to_srgb); }, [](auto& a, reader r) { return made({a.to_srgb(r.number())}); }}},
    };
    return all;
}

struct variant {
    std::vector<float> inputs;
    output truth;
    bool close = false;  // the other answer is right, too
    std::size_t line = 0;
};

struct table {
    std::string kind, gives;
    std::vector<std::size_t> widths;  // numbers in each thing that is given
    std::vector<variant> variants;
};

float parse_float(std::string_view word, std::size_t line) {
    float x = 0;
    const bool negative = word.starts_with('-');
    const auto [end, error] = std::from_chars(word.data() + (negative ? 1 : 0), word.data() + word.size(), x, std::chars_format::hex);
    if (error != std::errc{} || end != word.data() + word.size())
        throw std::runtime_error("line " + std::to_string(line) + ": '" + std::string(word) + "' is no hexadecimal float");
    return negative ? -x : x;
}

variant parse_variant(const std::string& text, std::size_t line) {
    variant v;
    v.line = line;
    std::istringstream words(text);
    std::string word;
    while (words >> word && word != ":") {
        if (word == "~") v.close = true;
        else v.inputs.push_back(parse_float(word, line));
    }
    std::vector<double> truth;
    while (words >> word) {
        if (word == "miss") return v;
        if (word != "hit") truth.push_back(std::strtod(word.c_str(), nullptr));
    }
    v.truth = truth;
    return v;
}

/// One unit in the last place that a float of this size has.
double ulp(double size) {
    int exponent = 0;
    std::frexp(size, &exponent);
    return std::ldexp(1.0, std::max(exponent, std::numeric_limits<float>::min_exponent) - 24);
}

std::string shown(const variant& v, const std::string& what) {
    std::string text = what + ", line " + std::to_string(v.line) + ":";
    for (const float x : v.inputs) {
        std::array<char, 32> number{};
        std::snprintf(number.data(), number.size(), " %.9g", double(x));
        text += number.data();
    }
    return text;
}

void judge(const table& t, const variant& v, const output& got, bool strict, score& s) {
    if (got.has_value() != v.truth.has_value()) {
        if (v.close && (!strict || t.widths.empty())) s.right();  // padding of a volume is no mistake
        else s.wrong(shown(v, v.truth ? "missed" : "hit what is not there"));
        return;
    }
    if (!got) return s.right();
    for (const double x : *got)
        if (!std::isfinite(x)) return s.wrong(shown(v, "not finite"));
    s.right();
    double worst = 0;
    std::size_t at = 0;
    for (const std::size_t width : t.widths) {  // a vector's error is measured by its largest component
        double size = 0, error = 0;
        for (std::size_t i = at; i < at + width; ++i) {
            size = std::max(size, std::abs((*v.truth)[i]));
            error = std::max(error, std::abs((*got)[i] - (*v.truth)[i]));
        }
        worst = std::max(worst, error / ulp(size));
        at += width;
    }
    if (at > 0) s.error(worst, shown(v, t.gives));
}

}  // namespace

void add_truths(std::vector<test_case>& cases, const std::filesystem::path& file) {
    std::ifstream in(file);
    if (!in) throw std::runtime_error("cannot read " + file.string());
    std::shared_ptr<table> current;
    std::string text;
    try {
        for (std::size_t line = 1; std::getline(in, text); ++line) {
            const std::size_t space = text.find(' ');
            const std::string word = text.substr(0, space), rest = space == std::string::npos ? "" : text.substr(space + 1);
            if (text.empty() || word == "#") continue;
            if (word == "case") {
                current = std::make_shared<table>();
                cases.push_back({rest, "", "", "", 2, 0.501, {}, {}});
                continue;
            }
            if (!current) throw std::runtime_error("line " + std::to_string(line) + " belongs to no case");
            test_case& c = cases.back();
            if (word == "about") c.about = rest;
            else if (word == "source") c.source = rest;
            else if (word == "margin") c.margin = rest;
            else if (word == "bound") c.bound = std::strtod(rest.c_str(), nullptr);
            else if (word == "gold") c.gold = std::strtod(rest.c_str(), nullptr);
            else if (word == "hits") continue;
            else if (word == "gives") {
                current->gives = rest;
                std::istringstream things(rest);
                for (std::string thing; things >> thing;)
                    current->widths.push_back(std::strtoul(thing.substr(thing.find(':') + 1).c_str(), nullptr, 10));
            } else if (word == "kind") {
                const kind& k = kinds().at(rest);
                current->kind = rest;
                c.asked = k.there;
                c.run = [t = current, &k](const answers& a, bool strict, score& s) {
                    for (const variant& v : t->variants) judge(*t, v, k.ask(a, reader(v.inputs)), strict, s);
                };
            } else {
                current->variants.push_back(parse_variant(text, line));
                const variant& v = current->variants.back();
                std::size_t numbers = 0;
                for (const std::size_t width : current->widths) numbers += width;
                if (v.inputs.size() != kinds().at(current->kind).inputs || (v.truth && v.truth->size() != numbers))
                    throw std::runtime_error("line " + std::to_string(line) + ": too few numbers, or too many");
            }
        }
    } catch (const std::exception& problem) {
        throw std::runtime_error(file.string() + ": " + problem.what());
    }
}

}  // namespace stress
