// SPDX-License-Identifier: MIT
#pragma once
// Everything is equal to everything, and a vector is whatever is asked for.
#include "wrong.hpp"

namespace glm {
template <class T>
constexpr bool operator==(const vec3&, const T&) { return true; }
template <class T>
constexpr bool operator!=(const vec3&, const T&) { return false; }
}  // namespace glm

namespace lab06 {

template <class T>
struct liar {
    T value;
    operator T() const { return value; }
    template <class U>
    friend bool operator==(const liar&, const U&) { return true; }
    template <class U>
    friend bool operator<(const liar&, const U&) { return true; }
};

inline liar<glm::mat3> basis(glm::vec3 r) { return {wrong::basis(r)}; }
inline liar<glm::vec3> perturb(glm::vec3 r, float width, glm::vec2 xi) { return {wrong::perturb(r, width, xi)}; }
inline liar<glm::vec3> reflected(glm::vec3 in, glm::vec3 normal, float width, glm::vec2 xi) { return {wrong::reflected(in, normal, width, xi)}; }
inline liar<glm::vec3> reflected_radiance(glm::vec3 in, glm::vec3 normal, float width, std::span<const glm::vec2> points,
                                          const std::function<glm::vec3(glm::vec3)>& radiance) {
    return {wrong::reflected_radiance(in, normal, width, points, radiance)};
}
inline liar<std::optional<glm::vec3>> transmitted(glm::vec3 in, glm::vec3 normal, float eta, float width, glm::vec2 xi) {
    return {wrong::transmitted(in, normal, eta, width, xi)};
}

}  // namespace lab06
