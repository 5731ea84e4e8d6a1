// SPDX-License-Identifier: MIT
#pragma once
// A part of a picture's samples, rendered by itself: parts from many machines are merged into the very picture that one would make.

#include <lantern/exact_sum.hpp>
#include <lantern/filter.hpp>
#include <lantern/image.hpp>
#include <lantern/load.hpp>
#include <lantern/render.hpp>
#include <lantern/samples.hpp>
#include <lantern/save.hpp>
#include <lantern/validate.hpp>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <istream>
#include <mutex>
#include <ostream>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace lantern {

/// Samples first … last - 1 of every pixel.
struct sample_range {
    std::uint32_t first = 0, last = 0;
    [[nodiscard]] bool operator==(const sample_range&) const = default;
};

/// Exact sums of a pixel's samples: red, green, blue, each times its weight, and the weights; then the plain sums, for filters
/// whose weights sum to nothing.
struct pixel_sums {
    exact_sum color[3], weight, plain[3];
    std::uint64_t count = 0, rejected = 0;

    /// As accumulator::add: what is not finite is left out and counted.
    void add(glm::vec3 sample, float w) {
        if (!(is_finite(sample) && is_finite(w))) {
            ++rejected;
            return;
        }
        for (int i = 0; i < 3; ++i) {
            color[i].add(sample[i], w);
            plain[i].add(sample[i]);
        }
        weight.add(w);
        ++count;
    }
    void add(const pixel_sums& other) {
        for (int i = 0; i < 3; ++i) {
            color[i].add(other.color[i]);
            plain[i].add(other.plain[i]);
        }
        weight.add(other.weight);
        count += other.count;
        rejected += other.rejected;
    }
    /// As accumulator::mean.
    [[nodiscard]] glm::vec3 mean() const {
        const double sum = weight.value();
        glm::vec3 result{0};
        for (int i = 0; i < 3; ++i) {
            if (sum > 0) result[i] = static_cast<float>(color[i].value() / sum);
            else if (count > 0) result[i] = static_cast<float>(plain[i].value() / static_cast<double>(count));
        }
        return result;
    }
};

namespace detail {

// A sum takes a byte that says where its digits begin, one that says how many there are, and these; 0 0 for nothing.
// Most pixels' sums have three or four digits of 21.

inline void put(std::vector<std::uint8_t>& bytes, std::uint64_t x, int count) {
    for (int i = 0; i < count; ++i) bytes.push_back(static_cast<std::uint8_t>(x >> (8 * i)));
}

inline void pack(std::vector<std::uint8_t>& bytes, const exact_sum& s) {
    const auto digits = s.settled();
    std::size_t begin = 0, end = digits.size();
    while (begin < end && digits[begin] == 0) ++begin;
    // Above the last digit that counts there are only zeros, or, for a negative sum, digits that are all ones below a -1.
    const bool negative = digits.back() < 0;
    const auto idle = [&](std::size_t i) {
        return digits[i] == (!negative ? 0 : i + 1 == digits.size() ? -1 : std::int64_t{0xffffffff});
    };
    while (end > begin && idle(end - 1)) --end;
    put(bytes, begin, 1);
    put(bytes, (end - begin) | (negative ? 128u : 0u), 1);
    for (std::size_t i = begin; i < end; ++i) put(bytes, static_cast<std::uint64_t>(digits[i]), i + 1 == digits.size() ? 8 : 4);
}

inline void pack(std::vector<std::uint8_t>& bytes, const pixel_sums& p) {
    for (const exact_sum& s : p.color) pack(bytes, s);
    pack(bytes, p.weight);
    for (const exact_sum& s : p.plain) pack(bytes, s);
    put(bytes, p.count, 8);
    put(bytes, p.rejected, 8);
}

/// Reads bytes, and never beyond their end: std::runtime_error.
class unpacker {
public:
    explicit unpacker(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

    [[nodiscard]] std::uint64_t number(std::size_t count) {
        if (bytes_.size() - at_ < count) throw std::runtime_error("shard: the sums end early, at byte " + std::to_string(at_));
        std::uint64_t x = 0;
        for (std::size_t i = 0; i < count; ++i) x |= std::uint64_t{bytes_[at_++]} << (8 * i);
        return x;
    }
    [[nodiscard]] exact_sum sum() {
        const std::uint64_t begin = number(1), mark = number(1), count = mark & 127;
        constexpr std::size_t all = exact_sum::digits;
        if (begin + count > all) throw std::runtime_error("shard: a sum has digits beyond the last, at byte " + std::to_string(at_));
        std::array<std::int64_t, all> digits{};
        for (std::size_t i = begin; i < begin + count; ++i)
            digits[i] = static_cast<std::int64_t>(number(i + 1 == all ? 8 : 4));
        if ((mark & 128) != 0)
            for (std::size_t i = begin + count; i < all; ++i) digits[i] = i + 1 == all ? -1 : std::int64_t{0xffffffff};
        return exact_sum::from(digits);
    }
    [[nodiscard]] pixel_sums pixel() {
        pixel_sums p;
        for (exact_sum& s : p.color) s = sum();
        p.weight = sum();
        for (exact_sum& s : p.plain) s = sum();
        p.count = number(8);
        p.rejected = number(8);
        return p;
    }
    [[nodiscard]] bool at_end() const { return at_ == bytes_.size(); }

private:
    std::span<const std::uint8_t> bytes_;
    std::size_t at_ = 0;
};

}  // namespace detail

/// What is known so far of a picture: for some of its samples, the exact sums of every pixel. About 100 bytes a pixel.
struct shard {
    std::string scene;                    ///< which picture: shards of different ones are not merged. No line breaks
    glm::uvec2 size{1};                   ///< in pixels
    std::uint32_t samples = 1;            ///< of the whole picture, a pixel
    std::vector<sample_range> ranges;     ///< that are in it, ascending; neighbours are joined
    std::vector<std::uint8_t> sums;       ///< of pixel after pixel, row after row

    /// Whether every sample is in it.
    [[nodiscard]] bool complete() const { return ranges.size() == 1 && ranges[0] == sample_range{0, samples}; }
};

/// Renders some of the samples. `scene` names the picture: its scene, its seed, all that two shards must agree on. Refuses what
/// `render` refuses, ranges that are empty or reach beyond the sampler's count, and names with line breaks.
template <class Camera, sampler Sampler, shade_for<Camera, Sampler> Shade, pixel_filter Filter = box_filter>
[[nodiscard]] shard render_shard(const std::string& scene, glm::uvec2 size, const Camera& cam, const Sampler& samples,
                                 sample_range range, const Shade& shade, const render_options& options = {},
                                 const Filter& filter = {}) {
    if (scene.find('\n') != std::string::npos) refuse("shard: scene", "a name of several lines", "one line");
    if (range.first >= range.last || range.last > samples.count())
        refuse("shard: samples", std::to_string(range.first) + ":" + std::to_string(range.last),
               "a range that is not empty, within 0:" + std::to_string(samples.count()));
    validate(options);
    if constexpr (requires { validate(filter); }) validate(filter);
    static_cast<void>(image::checked(size));
    std::vector<std::vector<std::uint8_t>> rows(size.y);
    std::size_t done = 0;
    std::mutex one_at_a_time;
    in_parallel(size.y, options.threads, [&](std::size_t y) {
        for (std::uint32_t x = 0; x < size.x; ++x) {
            const glm::uvec2 pixel{x, static_cast<std::uint32_t>(y)};
            pixel_sums sum;
            for (std::uint32_t i = range.first; i < range.last; ++i) {
                const auto [color, weight] = render_sample(pixel, size, cam, samples, i, shade, filter);
                sum.add(color, weight);
            }
            detail::pack(rows[y], sum);
        }
        const std::lock_guard lock(one_at_a_time);
        ++done;
        if (options.progress) options.progress(static_cast<double>(done) / size.y);
    });
    shard result{scene, size, samples.count(), {range}, {}};
    for (const auto& row : rows) result.sums.insert(result.sums.end(), row.begin(), row.end());
    return result;
}

/// The two together. Refuses shards of different pictures, and samples that are in both.
[[nodiscard]] inline shard merged(const shard& a, const shard& b) {
    const auto shown = [](const shard& s) {
        return "'" + s.scene + "', " + std::to_string(s.size.x) + " x " + std::to_string(s.size.y) + ", " + std::to_string(s.samples) + " samples";
    };
    if (a.scene != b.scene || a.size != b.size || a.samples != b.samples) refuse("merged: a shard", shown(b), "of the same picture as the first, " + shown(a));
    shard result{a.scene, a.size, a.samples, a.ranges, {}};
    result.ranges.insert(result.ranges.end(), b.ranges.begin(), b.ranges.end());
    std::ranges::sort(result.ranges, {}, &sample_range::first);
    std::vector<sample_range> joined;
    for (const sample_range& r : result.ranges) {
        if (!joined.empty() && r.first < joined.back().last)
            refuse("merged: samples", std::to_string(r.first) + ":" + std::to_string(r.last), "in one of the shards only");
        if (!joined.empty() && r.first == joined.back().last) joined.back().last = r.last;
        else joined.push_back(r);
    }
    result.ranges = std::move(joined);
    detail::unpacker from_a(a.sums), from_b(b.sums);
    for (std::size_t i = 0; i < std::size_t{a.size.x} * a.size.y; ++i) {
        pixel_sums sum = from_a.pixel();
        sum.add(from_b.pixel());
        detail::pack(result.sums, sum);
    }
    if (!from_a.at_end() || !from_b.at_end()) throw std::runtime_error("shard: there are more sums than pixels");
    return result;
}

/// The picture: the mean of the samples that are there.
[[nodiscard]] inline image picture_of(const shard& s) {
    image picture(s.size);
    detail::unpacker from(s.sums);
    for (glm::vec3& pixel : picture.pixels()) {
        const pixel_sums sum = from.pixel();
        pixel = sum.mean();
        picture.add_rejected(sum.rejected);
    }
    if (!from.at_end()) throw std::runtime_error("shard: there are more sums than pixels");
    return picture;
}

/// Lines of text (a mark, the scene, sizes, ranges), then the sums. Throws std::runtime_error when it cannot write; a file
/// appears whole or not at all, so a shard that was killed leaves none.
inline void write_shard(const std::filesystem::path& path, const shard& s) {
    save(path, [&](std::ostream& out) {
        out << "lantern-shard-1\n" << s.scene << '\n' << s.size.x << ' ' << s.size.y << ' ' << s.samples << ' ' << s.ranges.size() << '\n';
        for (const sample_range& r : s.ranges) out << r.first << ' ' << r.last << '\n';
        out << s.sums.size() << '\n';
        out.write(reinterpret_cast<const char*>(s.sums.data()), static_cast<std::streamsize>(s.sums.size()));
    });
}

/// Throws std::runtime_error, naming the file and what is wrong with it, whatever its bytes are.
[[nodiscard]] inline shard read_shard(const std::filesystem::path& path) {
    return load(path, [](std::istream& in) {
        const auto fail = [](const std::string& problem) { throw std::runtime_error("shard: " + problem); };
        std::string mark;
        shard s;
        std::size_t ranges = 0, bytes = 0;
        if (!std::getline(in, mark) || mark != "lantern-shard-1") fail("this is no shard: it does not begin with \"lantern-shard-1\"");
        if (!std::getline(in, s.scene) || !(in >> s.size.x >> s.size.y >> s.samples >> ranges)) fail("the header ends early");
        if (s.samples == 0 || ranges == 0 || ranges > s.samples) fail("the number of samples or of ranges makes no sense");
        std::uint32_t end = 0;
        for (std::size_t i = 0; i < ranges; ++i) {
            sample_range r;
            if (!(in >> r.first >> r.last) || r.first >= r.last || r.last > s.samples || (i > 0 && r.first <= end)) fail("its ranges of samples make no sense");
            end = r.last;
            s.ranges.push_back(r);
        }
        if (!(in >> bytes) || in.get() != '\n') fail("the header ends early");
        // Every pixel has seven sums of two bytes or more, and two numbers of eight: nothing is allocated on the word of a header.
        if (s.size.x == 0 || s.size.y == 0 || std::uint64_t{s.size.x} * s.size.y > bytes / 30) fail("its size makes no sense");
        byte_reader reader(in, "shard");
        s.sums = reader.bytes(bytes);
        if (in.get() != std::istream::traits_type::eof()) fail("there are bytes after its end");
        static_cast<void>(picture_of(s));  // the sums are as many as the pixels, and well formed
        return s;
    });
}

}  // namespace lantern
