// SPDX-License-Identifier: MIT
#pragma once
// What an integrator is handed, checked before the first ray.

#include <lantern/validate.hpp>

#include <cstddef>
#include <ranges>
#include <string>

namespace lantern {

/// What a tracer may look at without owning it: a vector that has a name, or a span; not a temporary vector.
template <class R>
concept lasting_range = std::ranges::contiguous_range<R> && std::ranges::borrowed_range<R>;

/// Refuses, by std::invalid_argument that says which thing or light it is, every value that the `validate` beside its type
/// refuses, and a structure that was built over more surfaces than there are things: it would offer indices of nothing.
template <class Accelerator, class Background>
void validate_scene(const Accelerator& structure, const std::ranges::input_range auto& things,
                    const std::ranges::input_range auto& lights, const Background& background) {
    if constexpr (requires { structure.size(); }) {
        const std::size_t built_over = structure.size(), count = std::ranges::size(things);
        if (built_over > count)
            refuse("acceleration structure: size", std::to_string(built_over),
                   "no more than the number of things, " + std::to_string(count));
    }
    validate_each(things, "things");
    validate_each(lights, "lights");
    validate_if_possible(background);
}

}  // namespace lantern
