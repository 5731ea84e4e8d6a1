// SPDX-License-Identifier: MIT
#pragma once
// A scene chosen at run time, cut down to what it needs: one look at its values, one choice of types, one render.

#include <lantern/aabb.hpp>
#include <lantern/any_of.hpp>
#include <lantern/camera.hpp>
#include <lantern/closest.hpp>
#include <lantern/light.hpp>
#include <lantern/object.hpp>
#include <lantern/reduce.hpp>
#include <lantern/surface.hpp>
#include <lantern/validate.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace lantern {

/// All that a picture is made of, in types that are large enough for whatever may be chosen: a file may hold a lens, motion,
/// gloss, and lamps of any kind. A program that knows its scene needs no such thing.
template <class Thing, class Light, class Lens = thin_lens, class Shutter = shutter>
struct ingredients {
    std::vector<Thing> things;
    std::vector<Light> lights;
    view from;
    Lens lens{};
    Shutter exposure{};
};

template <class Thing, class Light, class Lens, class Shutter>
ingredients(std::vector<Thing>, std::vector<Light>, view, Lens, Shutter) -> ingredients<Thing, Light, Lens, Shutter>;

/// Which questions `trim` asks. Each one more doubles the types that the visitor is compiled for.
struct questions {
    bool lens = true;       ///< is the aperture open?
    bool motion = true;     ///< does anything move while the shutter is open?
    bool gloss = true;      ///< is any reflection blurred?
    bool shape = true;      ///< is there more than one kind of shape? Asked of scenes that stand still
    bool light = true;      ///< is there more than one kind of light, or any at all?
};

/// Where no acceleration structure is offered.
struct no_structure {};

/// Up to here `every` costs less than a tree: instructions for a ray through spheres and triangles, the build not counted.
inline constexpr std::size_t few_things = 5;

/// What was found out about one ingredient.
struct finding {
    std::string what;
    bool left_out = false;
    std::string why;
};

namespace detail {

template <class What, class Range>
[[nodiscard]] std::size_t count_that_need(What what, const Range& values) {
    return static_cast<std::size_t>(std::ranges::count_if(values, [&](const auto& value) { return needs(what, value); }));
}

/// Whether leaving `What` out makes another type of T.
template <class What, class T>
inline constexpr bool may_need = !std::same_as<decltype(reduced(What{}, std::declval<const T&>())), T>;

template <class What, class T>
[[nodiscard]] auto all_reduced(What what, const std::vector<T>& values) {
    std::vector<decltype(reduced(what, values[0]))> result;
    result.reserve(values.size());
    for (const T& value : values) result.push_back(reduced(what, value));
    return result;
}

/// Calls next(values), in vectors of the one alternative that they all hold, if they do.
template <class T, class Next>
auto with_one_kind(const std::vector<T>& values, types<>, const Next& next) {
    return next(values);
}
template <class T, class Kind, class... Kinds, class Next>
auto with_one_kind(const std::vector<T>& values, types<Kind, Kinds...>, const Next& next) {
    if (!values.empty() && count_that_need(all_but<Kind>{}, values) == 0) return next(all_reduced(all_but<Kind>{}, values));
    return with_one_kind(values, types<Kinds...>{}, next);
}

/// The alternatives among which a value chooses; none where there is no choice.
template <class T>
struct kinds {
    using type = types<>;
};
template <class... Ts>
struct kinds<std::variant<Ts...>> {
    using type = types<Ts...>;
};
template <class... Ts>
struct kinds<any_of<Ts...>> {
    using type = types<Ts...>;
};
template <class Shape, class Material>
struct kinds<object<Shape, Material>> : kinds<Shape> {};

template <class... Ts, class T>
[[nodiscard]] std::size_t kinds_used(types<Ts...>, const std::vector<T>& values) {
    return ((count_that_need(all_but<Ts>{}, values) < values.size() ? std::size_t{1} : 0) + ... + 0);
}

template <class Lens>
inline constexpr bool may_open = requires(const Lens& l) { l.radius; };

template <class Lens>
[[nodiscard]] bool is_open(const Lens& l) {
    if constexpr (may_open<Lens>) return l.radius != 0;
    else return !std::same_as<Lens, pinhole>;
}

template <class Thing, class Light, class Lens, class Shutter>
[[nodiscard]] bool moves(const ingredients<Thing, Light, Lens, Shutter>& s) {
    return count_that_need(motion{}, s.things) + count_that_need(motion{}, s.lights) > 0;
}

template <class Thing, class Build, class Next>
auto with_structure(const std::vector<Thing>& things, const Build& build, const Next& next) {
    if constexpr (bounded<Thing> && !std::same_as<Build, no_structure>)
        if (things.size() > few_things) return next(build(things));
    return next(every{static_cast<std::uint32_t>(things.size())});
}

template <questions Asked, class Light, class Next>
auto with_lights(const std::vector<Light>& lights, const Next& next) {
    if constexpr (Asked.light) {
        if (lights.empty()) return next(std::vector<point_light>{});  // the simplest kind, and none of it
        return with_one_kind(lights, typename kinds<Light>::type{}, next);
    } else {
        return next(lights);
    }
}

template <questions Asked, class Thing, class Next>
auto with_shapes(const std::vector<Thing>& things, const Next& next) {
    if constexpr (Asked.shape && surface<Thing>) return with_one_kind(things, typename kinds<Thing>::type{}, next);
    else return next(things);
}

template <questions Asked, class Thing, class Next>
auto with_gloss(const std::vector<Thing>& things, const Next& next) {
    if constexpr (Asked.gloss && may_need<gloss, Thing>)
        if (count_that_need(gloss{}, things) == 0) return with_shapes<Asked>(all_reduced(gloss{}, things), next);
    return with_shapes<Asked>(things, next);
}

template <questions Asked, class Lens, class Next>
auto with_lens(const Lens& l, const Next& next) {
    if constexpr (Asked.lens && may_open<Lens>)
        if (!is_open(l)) return next(pinhole{});
    return next(l);
}

}  // namespace detail

/// What the scene needs and what it does not, with the reason: for those who ask. It says what `trim` does.
template <questions Asked = questions{}, class Thing, class Light, class Lens, class Shutter>
[[nodiscard]] std::vector<finding> look_at(const ingredients<Thing, Light, Lens, Shutter>& s) {
    using detail::count_that_need;
    std::vector<finding> found;
    const auto number = [](std::size_t n, const char* one, const char* many) { return std::to_string(n) + " " + (n == 1 ? one : many); };
    if constexpr (Asked.lens && detail::may_open<Lens>)
        found.push_back({"lens", !detail::is_open(s.lens), "the radius of its aperture is " + to_text(s.lens.radius)});
    const std::size_t moving = count_that_need(motion{}, s.things) + count_that_need(motion{}, s.lights);
    if constexpr (Asked.motion && std::same_as<Shutter, shutter>)
        found.push_back({"shutter", moving == 0, moving == 0 ? "nothing moves" : number(moving, "thing or light moves", "things and lights move")});
    if constexpr (Asked.gloss && detail::may_need<gloss, Thing>) {
        const std::size_t blurred = count_that_need(gloss{}, s.things);
        found.push_back({"gloss", blurred == 0, blurred == 0 ? "no reflection is blurred" : number(blurred, "thing is", "things are") + " glossy or frosted"});
    }
    if constexpr (Asked.shape) {
        using still = decltype(reduced(motion{}, std::declval<const Thing&>()));
        using kinds = typename detail::kinds<still>::type;
        if (!std::same_as<kinds, detail::types<>> || detail::may_need<motion, Thing>) {
            std::size_t used = 2;
            if (moving == 0) used = detail::kinds_used(kinds{}, detail::all_reduced(motion{}, s.things));
            if (moving > 0) found.push_back({"choice of shapes", false, "some move and others may not"});
            else found.push_back({"choice of shapes", used < 2, used < 2 ? "all are of one kind" : "there are " + std::to_string(used) + " kinds"});
        }
    }
    if constexpr (Asked.light) {
        const std::size_t used = detail::kinds_used(typename detail::kinds<Light>::type{}, s.lights);
        if (s.lights.empty()) found.push_back({"lights", true, "there are none"});
        else found.push_back({"choice of lights", used < 2, used < 2 ? "all are of one kind" : "there are " + std::to_string(used) + " kinds"});
    }
    if constexpr (bounded<Thing>)
        found.push_back({"acceleration structure", s.things.size() <= few_things, number(s.things.size(), "thing", "things")});
    return found;
}

/// Calls visit(structure, things, lights, camera) with the smallest types that hold this scene, and returns what it returns.
/// Looks at the values once: an aperture of 0 is a pinhole; where nothing moves there is no shutter, and a moving sphere is
/// a sphere; gloss of width 0 is a mirror; surfaces, or lights, that are all of one kind need no choice. `build(things)`
/// makes an acceleration structure, [](const auto& t) { return bvh{t}; }, and is called where there are more than a few
/// things, all bounded; without it there is none. The picture is the same, to the last bit. The visitor is compiled for every
/// combination that the types admit. Refuses what the `validate` beside each ingredient refuses, before anything is left out.
template <questions Asked = questions{}, class Thing, class Light, class Lens, class Shutter, class Visitor, class Build = no_structure>
auto trim(const ingredients<Thing, Light, Lens, Shutter>& s, const Visitor& visit, const Build& build = {}) {
    validate(s.from);
    validate(s.lens);
    validate(s.exposure);
    validate_each(s.things, "things");
    validate_each(s.lights, "lights");
    const auto go_on = [&](const auto& all_things, const auto& all_lights, const auto& exposure) {
        return detail::with_gloss<Asked>(all_things, [&](const auto& things) {
            return detail::with_lights<Asked>(all_lights, [&](const auto& lights) {
                return detail::with_lens<Asked>(s.lens, [&](const auto& lens) {
                    const camera cam{s.from, lens, exposure};
                    return detail::with_structure(
                        things, build, [&](const auto& structure) { return visit(structure, things, lights, cam); });
                });
            });
        });
    };
    if constexpr (Asked.motion && !std::same_as<Shutter, instant>)
        if (!detail::moves(s)) return go_on(detail::all_reduced(motion{}, s.things), detail::all_reduced(motion{}, s.lights), instant{});
    return go_on(s.things, s.lights, s.exposure);
}

}  // namespace lantern
