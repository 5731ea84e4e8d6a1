// SPDX-License-Identifier: MIT
// The three samplers of lab 04. All random numbers that they are given are ours.

#include "write.hpp"

#include <lab04_sampling/sampling.hpp>

#include <lantern/hash.hpp>

#include <glm/vec2.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

std::uint32_t side_of(std::size_t count) { return static_cast<std::uint32_t>(std::lround(std::sqrt(double(count)))); }

/// The sets of different purposes have nothing to do with each other only in another order each; lab 04 has no order yet.
void put(const std::vector<glm::vec2>& made, std::uint64_t key, const char* whose, std::span<glm::vec2> set) {
    if (made.size() != set.size())
        throw std::domain_error(std::string(whose) + " gives " + std::to_string(made.size()) + " points where " +
                                std::to_string(set.size()) + " are asked for");
    const auto count = static_cast<std::uint32_t>(set.size());
    for (std::uint32_t i = 0; i < count; ++i) set[lantern::permute(i, count, lantern::hash(key, 9u))] = made[i];
}

void jittered(const points::wanted& w, std::span<glm::vec2> set) {
    const auto xi = points::random_points(set.size(), w.key);
    std::vector<glm::vec2> made;
    for (std::uint32_t i = 0; i < set.size(); ++i) made.push_back(lab04::jittered(i, side_of(set.size()), xi[i]));
    put(made, w.key, "jittered", set);
}

void n_rooks(const points::wanted& w, std::span<glm::vec2> set) {
    const auto count = static_cast<std::uint32_t>(set.size());
    const auto order = lab04::shuffled(count, points::random_numbers(count, lantern::hash(w.key, 1u)));
    if (order.size() != count)
        throw std::domain_error("shuffled gives " + std::to_string(order.size()) + " numbers where " + std::to_string(count) +
                                " are asked for");
    put(lab04::n_rooks(order, points::random_points(count, w.key)), w.key, "n_rooks", set);
}

void multi_jittered(const points::wanted& w, std::span<glm::vec2> set) {
    const auto random = points::random_numbers(2 * set.size(), lantern::hash(w.key, 1u));
    put(lab04::multi_jittered(side_of(set.size()), points::random_points(set.size(), w.key), random), w.key, "multi_jittered", set);
}

constexpr std::array<points::pattern, 3> patterns{{{"jittered", jittered}, {"N-rooks", n_rooks}, {"multi-jittered", multi_jittered}}};

}  // namespace

int main(int argc, char** argv) { return points::write(argc, argv, patterns); }
