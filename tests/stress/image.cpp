// SPDX-License-Identifier: MIT
// Sums of very many samples, samples that are none, and what becomes of a pixel.

#include "laws.hpp"

#include <limits>

namespace stress {

void add_image(std::vector<test_case>& cases) {
    const auto with_mean = [](const answers& a) { return bool(a.mean); };
    cases.push_back({"image/mean-of-1e8", "256 different samples 390 625 times over: 1e8 samples", "a sum in float stops growing at 2^24 equal samples", "none", 1, 1,
                     with_mean, [](const answers& a, bool, score& s) {
                         dice d{.state = 600};
                         std::vector<glm::vec3> samples;
                         glm::dvec3 sum(0);
                         for (std::uint32_t i = 0; i < variants; ++i) {
                             samples.push_back(glm::vec3(0.1f) + d.in_cube(0.1) * glm::vec3(1, 0.01f, 0.9f));
                             sum += glm::dvec3(samples.back());
                         }
                         const glm::vec3 expected(sum / double(variants)), got = a.mean(samples, 390'625).mean;
                         for (int k = 0; k < 3; ++k) {
                             s.check(std::isfinite(got[k]), "not finite");
                             s.error(places(got[k], expected[k]), "the mean:" + shown({got, expected}));
                         }
                     }});
    add(cases, "image/mean-of-equals", "as many equal samples as you like: their mean is what they are, exactly", "each pixel of an even grey", "none", with_mean,
        [](const answers& a, score& s, std::uint32_t i) {
            dice d = dice_of(i, 601);
            const glm::vec3 sample = d.magnitude_between(-6, 6) * (d.in_cube() + 1.1f);
            const glm::vec3 got = a.mean({sample}, 1 + d.below(70'000)).mean;
            s.check(got == sample, "another mean:" + shown({sample, got}));
        });
    add(cases, "image/mean-with-a-firefly", "one sample 1e12 times as bright among 65 536 and then gone under the others' sum", "double sums, no clamp", "none", with_mean,
        [](const answers& a, score& s, std::uint32_t i) {
            dice d = dice_of(i, 602);
            std::vector<glm::vec3> samples(16, glm::vec3(1));
            glm::dvec3 sum(0);
            for (glm::vec3& v : samples) v = d.in_cube(0.5) + 1.0f;
            samples[d.below(16)] = glm::vec3(d.magnitude_between(3, 12));
            for (const glm::vec3& v : samples) sum += glm::dvec3(v);
            const glm::vec3 expected(sum / 16.0), got = a.mean(samples, 4096).mean;
            for (int k = 0; k < 3; ++k) s.error(places(got[k], expected[k]), "the mean:" + shown({got, expected}));
            s.right();
        });
    cases.back().gold = 1;
    add(cases, "image/mean-without-nan", "NaN and infinite samples are left out, and counted", "one NaN must not cost a pixel", "none", with_mean,
        [](const answers& a, score& s, std::uint32_t i) {
            dice d = dice_of(i, 603);
            constexpr float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
            std::vector<glm::vec3> samples(8, glm::vec3(0.25f, 0.5f, 1));
            const std::uint32_t bad = 1 + d.below(4);
            for (std::uint32_t k = 0; k < bad; ++k) samples[k][static_cast<int>(d.below(3))] = std::array<float, 3>{nan, inf, -inf}[d.below(3)];
            const total got = a.mean(samples, 3);
            s.check(got.mean == glm::vec3(0.25f, 0.5f, 1), "the mean is" + shown({got.mean}));
            s.check(got.rejected == 3 * bad, std::to_string(got.rejected) + " are said to be left out, of " + std::to_string(3 * bad));
        });
    add(cases, "image/bytes", "negative, NaN, infinite, huge: a byte is 0 to 255, and darker is not brighter", "max(0, ·) before the root", "none",
        [](const answers& a) { return a.to_byte; }, [](const answers& a, score& s, std::uint32_t i) {
            dice d = dice_of(i, 604);
            constexpr float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
            for (const float x : {nan, inf, -inf, 0.0f, -0.0f, 1.0f, -1e-9f, -d.magnitude_between(-30, 30), d.magnitude_between(-30, 30), 3.4e38f, 1e-45f}) {
                const int b = a.to_byte(x);
                s.check(b >= 0 && b <= 255 && (x <= 0 ? b == 0 : x >= 1 ? b == 255 : true), std::to_string(x) + " becomes " + std::to_string(b));
            }
            const float x = d.magnitude_between(-5, 0), y = d.magnitude_between(-5, 0);
            s.check((x < y) == (a.to_byte(x) < a.to_byte(y)) || a.to_byte(x) == a.to_byte(y), "darker is brighter");
        });
    add(cases, "image/size", "no pixel, and more pixels than there can be, are refused", "size_t for width · height", "none",
        [](const answers& a) { return a.image_size_refused; }, [](const answers& a, score& s, std::uint32_t i) {
            const std::uint32_t n = 1 + i * 3;
            s.check(a.image_size_refused(0, n) && a.image_size_refused(n, 0), "an image without pixels");
            s.check(a.image_size_refused(0xffffffffu - i, 0xffffffffu - i), "2^64 pixels");
            s.check(a.image_size_refused(0x10000u + i, 0x10000u), "2^32 pixels, which is 0 in 32 bits");
            s.check(!a.image_size_refused(n % 64 + 1, 1), "a small image is refused");
        });
}

}  // namespace stress
