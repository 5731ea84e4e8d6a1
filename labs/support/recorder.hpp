// SPDX-License-Identifier: MIT
#pragma once
// Who asks what: every ray that a lab's code sends, what it was tested against, and what it met. For ./lab explain and ./lab heat; the labs'
// own programs know nothing of it.
//
// It listens at the surfaces, for that is where every ray arrives, whoever sends it: shapes that report (told/) stand where the
// library's stood, and a ray is a stretch of questions with the same origin, direction and time. Which ray a ray comes from, and
// why, is told by where it starts and in which direction it goes (rays.hpp), not by the names of the student's functions.

#include <lantern/interval.hpp>
#include <lantern/ray.hpp>
#include <lantern/surface.hpp>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace support {

/// A surface as the recorder knows it: by its kind and its numbers. The card is a surface that no ray meets, unless it is held in its way.
struct figure {
    std::string_view kind;
    std::array<float, 9> numbers{};
    bool card = false;

    [[nodiscard]] bool operator==(const figure&) const = default;
};

[[nodiscard]] inline figure ball_at(glm::vec3 center, float radius) { return {"sphere", {center.x, center.y, center.z, radius}, radius == 0}; }
[[nodiscard]] inline figure plate_at(glm::vec3 corner, glm::vec3 u, glm::vec3 v) {
    return {"rectangle", {corner.x, corner.y, corner.z, u.x, u.y, u.z, v.x, v.y, v.z}, u == glm::vec3(0)};
}
[[nodiscard]] inline figure level_at(float height) { return {"floor", {height}}; }

/// A volume that a ray was tested against, on its way to the surfaces: `t` is where it is entered, nothing when it is missed.
struct box_test {
    glm::vec3 min, max;
    std::uint32_t node, depth;
    std::optional<float> t;
};

struct surface_test {
    figure what;
    std::optional<float> t;
    std::uint32_t count = 1;  ///< how many surfaces stand behind it: the triangles of a mesh
};

/// A ray, and what came of it.
struct asked {
    lantern::ray ray;
    std::optional<float> time;
    lantern::interval range;  ///< as it was when the first surface was asked
    std::vector<surface_test> tests{};
    std::vector<box_test> boxes{};
    std::optional<lantern::hit> met{};  ///< the nearest that was found
    std::optional<figure> what{};       ///< and on what
};

/// How often it was asked.
struct cost {
    std::uint32_t rays = 0, boxes = 0, tests = 0;
};

class recorder {
public:
    /// What is done to one of the rays, to see what it is good for: a card is held in its way, or all surfaces are taken out of it.
    enum class trick : std::uint8_t { none, card, air };

    recorder() = default;
    explicit recorder(bool only_counts) : only_counts_(only_counts) {}

    /// Hears all that this thread asks, from now on, until this one is gone. The shapes cannot be told whom to tell: hence the one
    /// variable of the thread.
    class session {
    public:
        explicit session(recorder& to) : before_(listener()) { listener() = &to; }
        ~session() { listener() = before_; }
        session(const session&) = delete;
        session& operator=(const session&) = delete;

    private:
        recorder* before_;
    };
    [[nodiscard]] static recorder*& listener() {
        thread_local recorder* who = nullptr;
        return who;
    }

    /// The trick is played on rays that are equal to this one, and the card stays in the way of all that starts on it. It is held halfway
    /// where the ray's range ends, else at t.
    void play(trick what, const lantern::ray& r, float t = 1) {
        trick_ = what;
        tricked_ = r;
        card_t_ = t;
    }

    [[nodiscard]] const std::vector<asked>& rays() const { return rays_; }
    [[nodiscard]] cost counted() const { return count_; }

    /// A ray begins, when its sender says so. `meet` finds it out by itself.
    void begin(const lantern::ray& r, lantern::interval range, std::optional<float> time = {}) {
        ++count_.rays;
        current_ = r;
        time_ = time;
        first_.reset();
        if (!only_counts_) rays_.push_back({r, time, range});
    }

    void box(const box_test& b) {
        ++count_.boxes;
        if (!only_counts_) rays_.back().boxes.push_back(b);
    }
    /// A box of which nothing is known.
    void box() { ++count_.boxes; }

    /// A surface was asked in the ray that has begun; nothing that is known of it has to be found again.
    void test(const figure& f, const std::optional<lantern::hit>& h, lantern::interval range, std::uint32_t surfaces = 1) {
        if (f.card && !h) return;
        count_.tests += surfaces;
        if (only_counts_) return;
        asked& ray = rays_.back();
        ray.tests.push_back({f, h ? std::optional(h->t) : std::nullopt, surfaces});
        if (h && contains(range, h->t) && (!ray.met || h->t < ray.met->t)) ray.met = h, ray.what = f;
    }

    /// A surface is asked: its answer is answer(), unless the ray is tricked.
    template <class Answer>
    std::optional<lantern::hit> meet(const figure& f, const lantern::ray& r, lantern::interval range, std::optional<float> time, const Answer& answer) {
        if (count_.rays == 0 || !same(r, current_) || time != time_ || f == first_) begin(r, range, time);
        if (!first_) first_ = f;
        std::optional<lantern::hit> h;
        switch (trick_on(r)) {
            case trick::none:
                if (!f.card) h = answer();
                break;
            case trick::card:
                if (f.card) h = on_card(r, range);
                break;
            case trick::air: break;
        }
        test(f, h, range);
        return h;
    }

    [[nodiscard]] trick trick_on(const lantern::ray& r) const {
        if (trick_ == trick::none || same(r, tricked_)) return trick_;
        return card_at_ && glm::distance(r.origin, *card_at_) <= 1e-3f * glm::distance(tricked_.origin, *card_at_) ? trick_ : trick::none;
    }

private:
    static bool same(glm::vec3 a, glm::vec3 b) {
        const auto equal = [](float x, float y) { return x == y || (std::isnan(x) && std::isnan(y)); };
        return equal(a.x, b.x) && equal(a.y, b.y) && equal(a.z, b.z);
    }
    static bool same(const lantern::ray& a, const lantern::ray& b) { return same(a.origin, b.origin) && same(a.direction, b.direction); }

    lantern::hit on_card(const lantern::ray& r, lantern::interval range) {
        const float t = std::isfinite(range.max) ? 0.5f * (range.min + range.max) : range.min + card_t_;
        const glm::vec3 point = at(r, t);
        if (same(r, tricked_)) card_at_ = point;
        return {.t = t, .point = point, .normal = {0, -1, 0}};
    }

    bool only_counts_ = false;
    std::vector<asked> rays_;
    cost count_;
    lantern::ray current_{};
    std::optional<float> time_;
    std::optional<figure> first_;
    trick trick_ = trick::none;
    lantern::ray tricked_{};
    float card_t_ = 1;
    std::optional<glm::vec3> card_at_;
};

/// A surface is asked, and whoever listens hears of it.
template <class Answer>
[[nodiscard]] std::optional<lantern::hit> tell(const figure& f, const lantern::ray& r, lantern::interval range, const Answer& answer,
                                               std::optional<float> time = {}) {
    recorder* const to = recorder::listener();
    if (to) return to->meet(f, r, range, time, answer);
    return f.card ? std::nullopt : answer();
}

}  // namespace support
