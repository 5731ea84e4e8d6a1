// SPDX-License-Identifier: MIT
#pragma once
// The closest hit of a ray with many surfaces, through any acceleration structure, or through none.

#include <lantern/interval.hpp>
#include <lantern/precise.hpp>
#include <lantern/ray.hpp>
#include <lantern/surface.hpp>

#include <concepts>
#include <cstdint>
#include <optional>
#include <ranges>
#include <span>
#include <type_traits>

namespace lantern {

/// Counts what a traversal does. Handed in by whoever asks; there are no global counters.
struct probe {
    std::uint64_t nodes = 0;   ///< nodes, cells or volumes looked at
    std::uint64_t offers = 0;  ///< surfaces handed back to be intersected
    constexpr void node() { ++nodes; }
    constexpr void offer() { ++offers; }
};

/// The probe of those who do not ask: it compiles to nothing.
struct no_probe {
    constexpr void node() const {}
    constexpr void offer() const {}
};

/// An acceleration structure stands beside the scene and never sees a surface. It offers indices along a ray and is
/// handed back what remains of the interval: shorter after a hit, empty when it may stop. It must offer every surface
/// that the ray meets within what remains, in any order, and it may offer others.
template <class A, class Ray = ray>
concept accelerator = requires(const A& a, const Ray& r, interval range, interval (*offer)(std::uint32_t, interval)) {
    a.traverse(r, range, offer);
};

/// No structure at all: every index from 0 to count - 1. The oracle that all the others are tested against, and the
/// right choice for a handful of surfaces or for unbounded ones.
struct every {
    std::uint32_t count = 0;

    [[nodiscard]] constexpr std::uint32_t size() const { return count; }

    template <class Offer, class Probe = no_probe>
    [[gnu::always_inline]] void traverse(const ray&, interval range, Offer&& offer, Probe&& counter = {}) const {
        for (std::uint32_t i = 0; i < count && !empty(range); ++i) {
            counter.offer();
            range = offer(i, range);
        }
    }
};

/// For structures: offers the surfaces of a leaf until nothing remains of the range, and says what does.
template <class Offer, class Probe>
[[nodiscard]] interval offer_each(std::span<const std::uint32_t> leaf, interval range, Offer& offer, Probe& counter) {
    for (const std::uint32_t i : leaf) {
        counter.offer();
        range = offer(i, range);
        if (empty(range)) break;
    }
    return range;
}

/// A hit, and which surface it is on.
struct nearest : hit {
    std::uint32_t index = 0;
};

/// Traverses with a probe where the structure takes one; a structure without gets its offers counted all the same.
template <class A, class Ray, class Offer, class Probe>
void traverse(const A& structure, const Ray& r, interval range, Offer&& offer, Probe&& counter) {
    if constexpr (requires { structure.traverse(r, range, offer, counter); }) {
        structure.traverse(r, range, offer, counter);
    } else {
        structure.traverse(r, range, [&](std::uint32_t i, interval remaining) -> interval {
            counter.offer();
            return offer(i, remaining);
        });
    }
}

// Offers are inlined always, and so is `every`: what they find then stays in registers.

/// The first hit of the ray within the range. Of two surfaces at the same t the one with the smaller index is taken,
/// so the answer does not depend on the structure, nor on the order in which it offers.
template <class A, std::ranges::random_access_range Surfaces, std::derived_from<ray> Ray, class Probe = no_probe>
    requires(accelerator<A, Ray> && surface<std::ranges::range_value_t<Surfaces>, Ray>)
[[nodiscard]] std::optional<nearest> closest(const A& structure, const Surfaces& surfaces, const Ray& r,
                                             interval range = {}, Probe&& counter = {}) {
    std::optional<nearest> best;
    const auto& ready = ready_for<std::ranges::range_value_t<Surfaces>>(r);
    traverse(structure, r, range, [&](std::uint32_t i, interval remaining) __attribute__((always_inline)) -> interval {
        const auto h = intersect(std::ranges::begin(surfaces)[i], ready, remaining);
        if (!h || !contains(remaining, h->t)) return remaining;  // an answer outside the range, or NaN, is none
        const auto t = static_cast<float>(h->t);
        if (!best || t < best->t || (t == best->t && i < best->index)) best = nearest{rounded(*h), i};
        return {remaining.min, best->t};
    }, counter);
    return best;
}

/// What `occluded` offers: it ends with the first hit.
template <class Surfaces, class Ready>
struct shadow_offer {
    using takes_any_order = void;
    const Surfaces& surfaces;
    const Ready& ray;
    bool found = false;

    [[gnu::always_inline]] interval operator()(std::uint32_t i, interval remaining) {
        const auto h = intersect(std::ranges::begin(surfaces)[i], ray, remaining);
        if (!h || !contains(remaining, h->t)) return remaining;
        found = true;
        return {0, 0};
    }
};

/// Whether an offer says that it ends with the first hit. Then a structure may begin at the far end: what hides a light from a
/// surface is seldom in the surroundings of that surface, where the ray begins.
template <class Offer>
inline constexpr bool takes_any_order = requires { typename std::remove_cvref_t<Offer>::takes_any_order; };

/// Whether anything at all is hit within the range: the shadow ray's question. Stops at the first hit found.
template <class A, std::ranges::random_access_range Surfaces, std::derived_from<ray> Ray, class Probe = no_probe>
    requires(accelerator<A, Ray> && surface<std::ranges::range_value_t<Surfaces>, Ray>)
[[nodiscard]] bool occluded(const A& structure, const Surfaces& surfaces, const Ray& r, interval range,
                            Probe&& counter = {}) {
    const auto& ready = ready_for<std::ranges::range_value_t<Surfaces>>(r);
    shadow_offer<Surfaces, std::remove_cvref_t<decltype(ready)>> offer{surfaces, ready};
    traverse(structure, r, range, offer, counter);
    return offer.found;
}

}  // namespace lantern
