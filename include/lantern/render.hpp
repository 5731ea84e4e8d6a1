// SPDX-License-Identifier: MIT
#pragma once
// From camera, sampler and shade to an image: tiles, threads, progress.

#include <lantern/camera.hpp>
#include <lantern/filter.hpp>
#include <lantern/image.hpp>
#include <lantern/samples.hpp>
#include <lantern/validate.hpp>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace lantern {

struct render_options {
    unsigned threads = 0;                    ///< 0: as many as the machine has
    std::uint32_t tile = 16;                 ///< side of the squares that are handed to threads; pixels
    std::function<void(double)> progress{};  ///< told the fraction done after each tile; one call at a time; may throw
};

inline void validate(const render_options& o) {
    if (o.tile == 0) refuse("render_options: tile", "0", "at least 1");
    if (o.threads > 1024) refuse("render_options: threads", std::to_string(o.threads), "at most 1024");
}

/// Calls work(i) for i = 0 … count - 1, each once, on several threads: this one and threads - 1 more. When a call
/// throws, no further i is begun, and the first exception is thrown from here once all threads are back.
template <std::invocable<std::size_t> Work>
void in_parallel(std::size_t count, unsigned threads, const Work& work) {
    std::atomic<std::size_t> next = 0;
    std::atomic<bool> failed = false;
    std::exception_ptr problem;
    const auto loop = [&] {
        for (std::size_t i; !failed && (i = next++) < count;) {
            try {
                work(i);
            } catch (...) {
                if (!failed.exchange(true)) problem = std::current_exception();
            }
        }
    };
    {
        std::vector<std::jthread> others;
        const std::size_t wanted = threads != 0 ? threads : std::max(1u, std::thread::hardware_concurrency());
        try {
            while (others.size() + 1 < std::min(wanted, count)) others.emplace_back(loop);
        } catch (const std::system_error&) {  // the system gives no more threads: go on with those we have
        }
        loop();
    }
    if (problem) std::rethrow_exception(problem);
}

/// What a shade is: called as shade(ray, source) it returns radiance. It is called from several threads at once.
template <class Shade, class Camera, class Sampler>
concept shade_for = requires(const Shade& shade, const Camera& cam, const Sampler& samples) {
    {
        shade(shoot(cam, glm::vec2{}, samples.at(glm::uvec2{}, 0)), samples.at(glm::uvec2{}, 0))
    } -> std::convertible_to<glm::vec3>;
};

/// What one sample saw, and what it counts for.
struct weighted_color {
    glm::vec3 color{0};
    float weight = 1;
};

/// Sample i of one pixel. It depends on nothing but the arguments, so an image does not depend on who renders what.
template <class Camera, sampler Sampler, shade_for<Camera, Sampler> Shade, pixel_filter Filter = box_filter>
[[nodiscard]] weighted_color render_sample(glm::uvec2 pixel, glm::uvec2 size, const Camera& cam, const Sampler& samples,
                                           std::uint32_t i, const Shade& shade, const Filter& filter = {}) {
    const auto source = samples.at(pixel, i);
    const auto [offset, weight] = sample(filter, source.draw2(purpose::film));
    const glm::vec2 film = (glm::vec2(pixel) + 0.5f + offset) / glm::vec2(size);
    return {shade(shoot(cam, film, source), source), weight};
}

/// All samples of one pixel.
template <class Camera, sampler Sampler, shade_for<Camera, Sampler> Shade, pixel_filter Filter = box_filter>
[[nodiscard]] accumulator render_pixel(glm::uvec2 pixel, glm::uvec2 size, const Camera& cam, const Sampler& samples,
                                       const Shade& shade, const Filter& filter = {}) {
    accumulator sum;
    const std::uint32_t count = samples.count();
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto [color, weight] = render_sample(pixel, size, cam, samples, i, shade, filter);
        sum.add(color, weight);
    }
    return sum;
}

/// Renders an image. The pixels are the same, to the last bit, for any number of threads and any tile size. Samples
/// that are not finite are left out and counted in image::rejected(). Throws what `shade` or `progress` throws; refuses
/// an image without pixels, a sampler without samples, tiles of size 0, more than 1024 threads, and what
/// the filter's own `validate` refuses.
template <class Camera, sampler Sampler, shade_for<Camera, Sampler> Shade, pixel_filter Filter = box_filter>
[[nodiscard]] image render(glm::uvec2 size, const Camera& cam, const Sampler& samples, const Shade& shade,
                           const render_options& options = {}, const Filter& filter = {}) {
    image picture(size);
    if (samples.count() == 0) refuse("sampler: count", "0", "at least 1");
    validate(options);
    if constexpr (requires { validate(filter); }) validate(filter);

    const glm::uvec2 tiles = (size - 1u) / options.tile + 1u;
    const std::size_t count = std::size_t{tiles.x} * tiles.y;
    std::mutex one_at_a_time;
    std::size_t done = 0;
    in_parallel(count, options.threads, [&](std::size_t i) {
        const auto x0 = static_cast<std::uint32_t>(i % tiles.x) * options.tile;
        const auto y0 = static_cast<std::uint32_t>(i / tiles.x) * options.tile;
        std::uint64_t rejected = 0;
        for (std::uint32_t y = y0; y < size.y && y - y0 < options.tile; ++y) {
            for (std::uint32_t x = x0; x < size.x && x - x0 < options.tile; ++x) {
                const accumulator sum = render_pixel({x, y}, size, cam, samples, shade, filter);
                picture(x, y) = sum.mean();
                rejected += sum.rejected();
            }
        }
        const std::lock_guard lock(one_at_a_time);
        picture.add_rejected(rejected);
        ++done;
        if (options.progress) options.progress(static_cast<double>(done) / static_cast<double>(count));
    });
    return picture;
}

}  // namespace lantern
