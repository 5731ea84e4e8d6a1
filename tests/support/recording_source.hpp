// SPDX-License-Identifier: MIT
#pragma once
// A sample source that passes on another one's numbers and writes down each: the proof that leaving an effect out
// changes no other number.

#include <lantern/samples.hpp>

#include <glm/vec2.hpp>

#include <cstdint>
#include <map>
#include <string>

/// What was drawn: "0/1 purpose 5, which 0" for the second ray of the first ray's vertex, and the numbers.
using recording = std::map<std::string, glm::vec2>;

template <lantern::sample_source Source>
struct recording_source {
    Source source;
    recording* into;
    std::string path = "";

    [[nodiscard]] float draw1(lantern::purpose p, std::uint32_t which = 0) const {
        const float x = source.draw1(p, which);
        (*into)[name(p, which) + ", one"] = {x, 0};
        return x;
    }
    [[nodiscard]] glm::vec2 draw2(lantern::purpose p, std::uint32_t which = 0) const {
        return (*into)[name(p, which)] = source.draw2(p, which);
    }
    [[nodiscard]] recording_source branch(std::uint32_t k) const {
        return {source.branch(k), into, path + std::to_string(k) + "/"};
    }


    [[nodiscard]] std::string name(lantern::purpose p, std::uint32_t which) const {
        return path + " purpose " + std::to_string(static_cast<std::uint32_t>(p)) + ", which " + std::to_string(which);
    }
};

template <lantern::sample_source Source>
recording_source(Source, recording*) -> recording_source<Source>;
