// SPDX-License-Identifier: MIT
// Lab 14: the scorecard, the textbook's formulas beside yours, and pictures of what it means.

#include "pictures.hpp"

#include <lantern/png.hpp>

#include <exception>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace {

support::gaps missing;

std::string told(const extremes::score& s) {
    std::ostringstream out;
    out << std::fixed << std::setprecision(1) << std::setw(7) << 100.0 * s.wrong / s.asked << " %" << std::setw(10);
    if (s.wrong == s.asked) out << '-';
    else if (s.ulp >= 1000) out << std::scientific << std::setprecision(0) << s.ulp;
    else out << std::setprecision(2) << s.ulp;
    return out.str();
}

/// A line of the scorecard: judge(textbook's) beside judge(student's).
template <class Judge, class Textbook, class Own>
void row(const std::string& name, const Judge& judge, const Textbook& textbook, const Own& own) {
    std::cout << "  " << std::left << std::setw(28) << name << std::right << told(judge(textbook)) << "   ";
    try {
        std::cout << told(judge(own)) << '\n';
    } catch (const lantern::unfinished& gap) {
        missing.note(gap);
        std::cout << std::setw(19) << "n/a" << '\n';
    }
}

void scorecard() {
    namespace textbook = lab14::textbook;
    std::cout << "                                  textbook               yours\n"
                 "                                 wrong       ulp       wrong       ulp\n";
    for (int i = 0; i < int(extremes::sphere_names.size()); ++i)
        row(extremes::sphere_names[std::size_t(i)], [=](const auto& hit) { return extremes::judge_spheres(i, hit); }, textbook::hit_sphere,
            lab14::hit_sphere);
    for (int i = 0; i < int(extremes::triangle_names.size()); ++i)
        row(extremes::triangle_names[std::size_t(i)], [=](const auto& hit) { return extremes::judge_triangles(i, hit); },
            textbook::hit_triangle, lab14::hit_triangle);
    for (const auto& [name, vertices, scale] : {std::tuple("leaks at edges", false, 0), std::tuple("leaks at vertices", true, 0),
                                                std::tuple("leaks at edges, mesh × 1e-4", false, -13)})
        row(name, [=, v = vertices, s = scale](const auto& hit) { return extremes::judge_leaks(v, s, hit); }, textbook::hit_triangle,
            lab14::hit_triangle);
    for (int i = 0; i < int(extremes::box_names.size()); ++i)
        row(extremes::box_names[std::size_t(i)], [=](const auto& meets) { return extremes::judge_boxes(i, meets); }, textbook::meets_box,
            lab14::meets_box);
    const auto along_ray = [](const lantern::ray& r, float t) { return lantern::at(r, t); };
    const auto theirs = [&](float size) {
        return extremes::leave_spheres(size, [&](glm::vec3, float, const lantern::ray& r, float t) { return along_ray(r, t); }, textbook::leave);
    };
    const auto own = [&](float size) { return extremes::leave_spheres(size, lab14::on_sphere, lab14::leave); };
    for (const auto& [name, size] : {std::pair("scene of size 1e-3", 1e-3f), std::pair("scene of size 1", 1.0f), std::pair("scene of size 1e6", 1e6f)})
        for (const bool acne : {true, false})
            row(std::string(name) + (acne ? ": acne" : ": lost"), [s = size, acne](const auto& leave) {
                const extremes::departures d = leave(s);
                return extremes::score{d.rays, acne ? d.acne : d.lost, 0};
            }, theirs, own);
    for (int i = 0; i < int(extremes::basis_names.size()); ++i)
        row(std::string("frame: ") + extremes::basis_names[std::size_t(i)],
            [=](const auto& basis) { return extremes::judge_bases(i, basis); }, textbook::basis_around, lab14::basis_around);
    row("total reflection", [](const auto& refracted) { return extremes::judge_refractions(refracted); }, textbook::refracted, lab14::refracted);
    std::cout << std::flush;
}

}  // namespace

int main(int argc, char** argv) try {
    const std::filesystem::path folder = argc > 1 ? argv[1] : "out";
    scorecard();
    using page = std::pair<const char*, lantern::image (*)(support::gaps&)>;
    for (const auto& [name, picture] : {page{"lab14_1_ground.png", pictures::grounds}, page{"lab14_2_cloth.png", pictures::cloths},
                                        page{"lab14_3_wall.png", pictures::walls}, page{"lab14_4_shadows.png", pictures::shadows},
                                        page{"lab14_5_poles.png", pictures::poles}, page{"lab14_6_sums.png", pictures::sums},
                                        page{"lab14_7_critical.png", pictures::critical}}) {
        lantern::write_png(folder / name, picture(missing));
        std::cout << (folder / name).string() << std::endl;  // flushed: the next page may take a while
    }
    missing.tell();
    return 0;
} catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
}
