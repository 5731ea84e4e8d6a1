// SPDX-License-Identifier: MIT
#pragma once
// A camera that moves and turns while its shutter is open.

#include <lantern/camera.hpp>
#include <lantern/ray.hpp>
#include <lantern/samples.hpp>
#include <lantern/validate.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <string>

namespace lantern {

/// The view at a time from 0 to 1: everything in it goes evenly from what it is in `open` to what it is in `close`. At 0
/// and at 1 it is `open` and `close`, to the last bit.
[[nodiscard]] inline view between(const view& open, const view& close, float time) {
    const float before = 1 - time;
    return {.eye = before * open.eye + time * close.eye,
            .target = before * open.target + time * close.target,
            .up = before * open.up + time * close.up,
            .vertical_fov = before * open.vertical_fov + time * close.vertical_fov,
            .aspect = before * open.aspect + time * close.aspect};
}

/// A camera that is at `open` at time 0 and at `close` at time 1. Eye and target move along straight lines, so the camera
/// travels, pans and zooms at once; it shoots timed rays, and whatever moves in the scene moves as well.
template <lens Lens = pinhole>
class moving_camera {
public:
    /// Refuses what `camera` refuses of both views, and lines of sight or `up`s a right angle or more apart: on the way
    /// they might vanish. A way that leads exactly through a line of sight along `up` is refused by the ray that meets it.
    explicit moving_camera(const view& open, const view& close, Lens lens = {}, shutter exposure = {})
        : open_(open), close_(close), lens_(lens), exposure_(exposure) {
        const camera_frame first(open), last(close);
        validate(lens_);
        validate(exposure_);
        if (!(glm::dot(first.forward, last.forward) > 0))
            refuse("moving_camera: target", to_text(close.target), "in a direction less than a right angle from that at time 0");
        if (!(glm::dot(glm::dvec3(open.up), glm::dvec3(close.up)) > 0))
            refuse("moving_camera: up", to_text(close.up), "less than a right angle from that at time 0, " + to_text(open.up));
    }

    /// A ray of unit direction through a point of the film. Draws draw1(purpose::time), and what the lens draws.
    template <sample_source Source>
    [[nodiscard]] friend timed_ray shoot(const moving_camera& c, glm::vec2 film, const Source& source) {
        const float time = moment(c.exposure_, source);
        return {shoot(camera(between(c.open_, c.close_, time), c.lens_), film, source), time};
    }

private:
    view open_, close_;
    [[no_unique_address]] Lens lens_;
    shutter exposure_;
};

}  // namespace lantern
