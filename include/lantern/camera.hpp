// SPDX-License-Identifier: MIT
#pragma once
// From a point on the film to a ray: pinhole or lens, one instant or an exposure, in any combination.

#include <lantern/ray.hpp>
#include <lantern/samples.hpp>
#include <lantern/validate.hpp>
#include <lantern/warp.hpp>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <concepts>
#include <cstdint>
#include <numbers>
#include <string>

namespace lantern {

/// Where the camera stands and what it sees. `up` need not be perpendicular to the line of sight.
struct view {
    glm::vec3 eye{0, 0, 1};
    glm::vec3 target{0, 0, 0};
    glm::vec3 up{0, 1, 0};
    float vertical_fov = std::numbers::pi_v<float> * 40 / 180;  ///< the angle between top and bottom; radians
    float aspect = 1;                                           ///< width / height of the film
};

/// All rays start at the eye; everything is in focus.
struct pinhole {};

/// A thin lens: what lies at `focus_distance` along the line of sight is in focus, on a plane parallel to the film.
/// Infinity is a focus distance too. (Cook, Porter and Carpenter, "Distributed ray tracing", 1984.)
struct thin_lens {
    float radius = 0;  ///< of the aperture; scene units
    float focus_distance = 1;
};

/// A thin lens behind an aperture of straight blades: out-of-focus highlights become polygons.
struct bladed_lens {
    float radius = 0;  ///< from the middle to a corner; scene units
    float focus_distance = 1;
    std::uint32_t blades = 6;
    float rotation = 0;  ///< of the first corner, counter-clockwise from the camera's right; radians
};

/// Everything happens at once: the camera shoots rays that know no time.
struct instant {};

/// Open from `open` to `close`: 0 and 1 are the beginning and the end of what moves, as in `timed_ray`. It is open for all
/// of that or for a part; outside nothing says where things are, and their bounds do not reach there.
struct shutter {
    float open = 0;
    float close = 1;
};

/// Where on the aperture, in scene units from its middle: right and up. Uniform by area for xi in the unit square.
[[nodiscard]] inline glm::vec2 on_aperture(const thin_lens& l, glm::vec2 xi) { return l.radius * to_disk(xi); }
[[nodiscard]] inline glm::vec2 on_aperture(const bladed_lens& l, glm::vec2 xi) {
    return l.radius * to_polygon(xi, l.blades, l.rotation);
}

/// A lens of one's own is any type with a `focus_distance`, and with an `on_aperture` and a `validate` beside it.
template <class L>
concept lens = std::same_as<L, pinhole> || requires(const L& l, glm::vec2 xi) {
    { on_aperture(l, xi) } -> std::same_as<glm::vec2>;
    { l.focus_distance } -> std::convertible_to<double>;
    validate(l);
};

template <class S>
concept exposure = std::same_as<S, instant> || std::same_as<S, shutter>;

inline void validate(const view& v) {
    require_finite(v.eye, "view: eye");
    require_finite(v.target, "view: target");
    require_finite(v.up, "view: up");
    if (!(v.vertical_fov > 0 && v.vertical_fov < std::numbers::pi_v<float>))
        refuse("view: vertical_fov", to_text(v.vertical_fov), "between 0 and pi (it is in radians)");
    require_positive(v.aspect, "view: aspect");
    if (v.eye == v.target) refuse("view: target", to_text(v.target), "different from eye");
}
inline void validate(const pinhole&) {}
inline void validate(const thin_lens& l) {
    require_not_negative(l.radius, "thin_lens: radius");
    if (!(l.focus_distance > 0)) refuse("thin_lens: focus_distance", to_text(l.focus_distance), "positive");
}
inline void validate(const bladed_lens& l) {
    require_not_negative(l.radius, "bladed_lens: radius");
    if (!(l.focus_distance > 0)) refuse("bladed_lens: focus_distance", to_text(l.focus_distance), "positive");
    if (l.blades < 3) refuse("bladed_lens: blades", std::to_string(l.blades), "at least 3");
    require_finite(l.rotation, "bladed_lens: rotation");
}
inline void validate(const instant&) {}
inline void validate(const shutter& s) {
    if (!(s.open >= 0 && s.open <= 1)) refuse("shutter: open", to_text(s.open), "between 0 and 1");
    if (!(s.close >= 0 && s.close <= 1)) refuse("shutter: close", to_text(s.close), "between 0 and 1");
    if (s.close < s.open) refuse("shutter: close", to_text(s.close), "no earlier than open, " + to_text(s.open));
}

/// Where the camera is and which way it looks: an orthonormal basis in double, and half the extent of a film that
/// stands at distance 1 along `forward`.
struct camera_frame {
    glm::dvec3 eye, right, up, forward;
    double half_width, half_height;

    explicit camera_frame(const view& v) : eye(v.eye) {
        validate(v);
        forward = unit(glm::dvec3(v.target) - eye);
        const glm::dvec3 side = glm::cross(forward, unit(glm::dvec3(v.up)));
        // The sine of the angle between up and the line of sight. Below 2^-40 rounding would turn the camera visibly.
        if (!(glm::length(side) > 0x1p-40)) refuse("view: up", to_text(v.up), "not zero nor parallel to target - eye");
        right = unit(side);
        up = glm::cross(right, forward);
        half_height = std::tan(double{v.vertical_fov} / 2);
        half_width = half_height * v.aspect;
    }

    /// The direction towards a point of the film, (0, 0) its top left corner, (1, 1) the bottom right. Its component
    /// along `forward` is 1, its length is not.
    [[nodiscard]] glm::dvec3 towards(glm::vec2 film) const {
        return forward + (2 * double{film.x} - 1) * half_width * right + (1 - 2 * double{film.y}) * half_height * up;
    }

private:
    [[nodiscard]] static glm::dvec3 unit(glm::dvec3 v) { return v / glm::length(v); }
};

/// T = T0 + ξ(T1 - T0). In double, so that the result, rounded to float, is never beyond T1.
template <sample_source Source>
[[nodiscard]] float moment(const shutter& s, const Source& source) {
    const double open = s.open, close = s.close;
    return static_cast<float>(open + double{source.draw1(purpose::time)} * (close - open));
}

/// A camera is made of what it needs: without a lens nothing about lenses is stored, computed or drawn.
template <lens Lens = pinhole, exposure Shutter = instant>
class camera {
public:
    /// Refuses, by std::invalid_argument: what is not finite, target = eye, `up` along the line of sight, a field of
    /// view outside (0, pi), aspect <= 0, a negative radius, focus distance <= 0, a shutter that closes before it opens.
    explicit camera(const view& v, Lens lens = {}, Shutter shutter = {}) : frame_(v), lens_(lens), shutter_(shutter) {
        validate(lens_);
        validate(shutter_);
    }

    /// A ray of unit direction through a point of the film; film in [0, 1]², (0, 0) is the top left corner. Draws
    /// nothing for a pinhole, draw2(purpose::lens) for a lens, draw1(purpose::time) for a shutter.
    template <sample_source Source>
    [[nodiscard]] friend auto shoot(const camera& c, glm::vec2 film, const Source& source) {
        const ray r = c.through_lens(film, source);
        if constexpr (std::same_as<Shutter, instant>) {
            return r;
        } else {
            return timed_ray{r, moment(c.shutter_, source)};
        }
    }

    /// Without lens and shutter there is nothing to draw.
    [[nodiscard]] friend ray shoot(const camera& c, glm::vec2 film)
        requires std::same_as<Lens, pinhole> && std::same_as<Shutter, instant>
    {
        return c.from(glm::dvec3{0}, c.frame_.towards(film));
    }

private:
    camera_frame frame_;
    [[no_unique_address]] Lens lens_;
    [[no_unique_address]] Shutter shutter_;

    [[nodiscard]] ray from(glm::dvec3 offset, glm::dvec3 direction) const {
        return {glm::vec3(frame_.eye + offset), glm::vec3(direction / glm::length(direction))};
    }

    /// From eye + l towards the point in focus, eye + f·d: along f·d - l, or d - l/f, which also holds at f = infinity.
    [[nodiscard]] ray through_lens(glm::vec2 film, const auto& source) const {
        const glm::dvec3 d = frame_.towards(film);
        if constexpr (std::same_as<Lens, pinhole>) {
            return from(glm::dvec3{0}, d);
        } else {
            const glm::vec2 a = on_aperture(lens_, source.draw2(purpose::lens));
            const glm::dvec3 l = double{a.x} * frame_.right + double{a.y} * frame_.up;
            return from(l, d - l / double{lens_.focus_distance});
        }
    }
};

}  // namespace lantern
