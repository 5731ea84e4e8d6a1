// SPDX-License-Identifier: MIT
// Lab 01: paints every ray in the colour of its direction, then, when all steps are done, the sky that the rays see.

#include "../support/gaps.hpp"

#include <lab01_picture/picture.hpp>

#include <lantern/todo.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

namespace {

support::gaps gaps;

/// One of the student's functions, and what stands in for it while it is unfinished: then it is asked once, not for every pixel.
class step {
public:
    template <class Written, class Instead>
    auto operator()(Written written, Instead instead) -> decltype(instead(0)) {
        if (missing_ == 0) {
            try {
                return written();
            } catch (const lantern::unfinished& gap) {
                gaps.note(gap);
                missing_ = support::step_number(gap.what());
            }
        }
        return instead(missing_);
    }

private:
    int missing_ = 0;
};

glm::vec3 rays_as_colours(glm::vec3 direction) { return 0.5f * direction + 0.5f; }

/// An evening by the sea. The sun is brighter than 1: encode and quantise have to cope.
glm::vec3 evening(glm::vec3 direction) {
    const bool sea = direction.y < 0;
    if (sea) direction += glm::vec3(0.03f * std::sin(3 / (0.01f - direction.y)), -2 * direction.y, 0);  // waves
    const glm::vec3 sun = glm::normalize(glm::vec3(0.25f, 0.075f, -1));
    const float away = glm::length(glm::normalize(direction) - sun);
    glm::vec3 light = glm::mix(glm::vec3(1, 0.42f, 0.13f), glm::vec3(0.05f, 0.12f, 0.36f), std::sqrt(direction.y / 0.45f));
    light += glm::vec3(1, 0.5f, 0.15f) * std::exp(-7 * away);
    if (away < 0.07f) light = {6, 4.5f, 1.6f};
    return sea ? 0.4f * light * glm::vec3(0.7f, 0.8f, 1) : light;
}

std::string picture(glm::uvec2 size, float fov, const std::function<glm::vec3(glm::vec3)>& colour) {
    step direction, encoding, bytes, file;
    std::vector<glm::vec3> pixels;
    for (unsigned y = 0; y < size.y; ++y)
        for (unsigned x = 0; x < size.x; ++x)
            pixels.push_back(direction([&] { return colour(lab01::direction({x, y}, size, fov)); },
                                       [&](int number) { return support::test_card((glm::vec2(x, y) + 0.5f) / glm::vec2(size), number); }));

    const auto encode = [&](float linear) {
        return encoding([&] { return lab01::encode(linear); }, [&](int) { return linear; });
    };
    const auto quantise = [&](float encoded) {  // instead: six levels, as on a poster
        return bytes([&] { return int(lab01::quantise(encoded)); },
                     [&](int) { return 51 * int(5.99f * std::clamp(encoded, 0.0f, 1.0f)); });
    };
    return file([&] { return lab01::ppm(size, pixels); },
                [&](int) {  // PPM has a form in plain text too, P3
                    std::string text = "P3\n" + std::to_string(size.x) + ' ' + std::to_string(size.y) + "\n255\n";
                    for (const glm::vec3& p : pixels)
                        for (const float channel : {p.r, p.g, p.b}) text += std::to_string(quantise(encode(channel))) + '\n';
                    return text;
                });
}

void save(const std::filesystem::path& path, const std::string& file) {
    if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path());
    std::ofstream out(path, std::ios::binary);  // binary: Windows would put a byte before each byte 10 otherwise
    out << file;
    out.close();
    if (!out) throw std::runtime_error("cannot write " + path.string());
    std::cout << path.string() << '\n';
}

}  // namespace

int main(int argc, char** argv) try {
    const std::filesystem::path folder = argc > 1 ? argv[1] : "out";
    save(folder / "lab01.ppm", picture({640, 480}, 1.7f, rays_as_colours));
    if (gaps.none()) save(folder / "lab01_evening.ppm", picture({960, 400}, 0.7f, evening));
    gaps.tell();
} catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
}
