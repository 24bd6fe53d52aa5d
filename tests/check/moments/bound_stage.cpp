// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "../numbers.hpp"
#include "../stage.hpp"
#include "bound_model.hpp"

namespace check {
namespace {

using glm::vec2;
using glm::vec4;

/// A function's results over one map of moments, whose texels are read in their centers.
struct results {
    const batch& asked;
    std::span<const vec4> out;
    [[nodiscard]] vec2 moments(std::size_t i) const { return {asked.map[i], asked.second[i]}; }
    [[nodiscard]] float receiver(std::size_t i) const { return asked.inputs[i].z; }
};

class bounds final : public stage {
public:
    bounds(std::uint32_t seed, verdict& v) : random_(seed), found_(v) {}

    /// Moments for each second channel, of which its numbers can be measured alone: of a known variance, where the
    /// bound is cut off, and of none, where the minimum shows. Then random moments, to tell what fits.
    std::optional<batch> ask() override {
        if (asked_) return std::nullopt;
        asked_ = true;
        batch b{size, {}, {}};
        for (second_channel second : second_channels) {
            for (int i = 0; i < measured; ++i)
                add(b, {0.5f, second_of(second, 0.5f, 0.0625f)}, 0.5f + float(i - measured / 2) / float(measured));
            for (int i = 0; i < measured; ++i) {
                const float d = std::exp2(-14.0f + float(i / 2) / 5);
                add(b, {0.5f, second_of(second, 0.5f, 0)}, i % 2 ? 0.5f + d : 0.5f - d);
            }
        }
        while (b.inputs.size() < std::size_t(size.x * size.y)) {
            const float mean = random_.unit(), variance = 1.0f / 1024 + random_.unit() * 0.125f;
            add(b, {mean, random_.below(4) ? mean * mean + variance : random_.unit()}, random_.unit());
        }
        return b;
    }

    void learn(const batch& b, std::span<const vec4> out) override {
        const results r{b, out};
        bound_model best;
        std::size_t explained = 0;
        for (second_channel second : second_channels)
            for (int bits = 0; bits < 8; ++bits) {
                bound_model m{second, (bits & 4) != 0, (bits & 2) != 0, (bits & 1) == 0};
                if (!measure(m, r)) continue;
                const std::size_t count = explained_by(m, r);
                if (count > explained) best = m, explained = count;
            }
        found_.inputs = out.size() - first_random;
        found_.explained = explained;
        if (explained < found_.inputs) {
            found_.but.push_back({"closest", "it is no bound of Chebyshev's on moments. The closest explains " +
                                                 shortened(100.0 * double(explained) / double(found_.inputs)) +
                                                 " % of them"});
            return;
        }
        conclude(best, r);
    }

private:
    static constexpr glm::ivec2 size{64, 32};
    static constexpr int measured = 128;
    static constexpr std::size_t first_random = std::size(second_channels) * 2 * measured;
    static constexpr double close = 0x1p-13;  ///< a variance near rounding gives that much

    static void add(batch& b, vec2 moments, float receiver) {
        const auto i = static_cast<int>(b.inputs.size());
        b.map.push_back(moments.x), b.second.push_back(moments.y);
        b.inputs.push_back({float(i % size.x) + 0.5f, float(i / size.x) + 0.5f, receiver, 0});
    }

    /// Sets the numbers of a model; false where the results are none of such a function.
    static bool measure(bound_model& m, const results& r) {
        const std::size_t first = std::size_t(m.second) * 2 * measured;
        const auto is_dark = [&](std::size_t i) { return (r.receiver(i) > 0.5f) != m.reversed; };
        const auto squared = [&](std::size_t i) { return std::pow(double(r.receiver(i)) - 0.5, 2); };
        struct point {
            double bound, seen;
        };
        std::vector<point> line;  // of a known bound
        for (std::size_t i = first; i < first + measured; ++i)
            if (const auto seen = m.bound_of(r.out[i].x); seen && is_dark(i))
                line.push_back({0.0625 / (0.0625 + squared(i)), *seen});
        if (line.size() < 2) return false;
        const auto [a, z] =
            std::minmax_element(line.begin(), line.end(), [](auto& x, auto& y) { return x.bound < y.bound; });
        const double slope = (z->seen - a->seen) / (z->bound - a->bound);
        if (!(slope > 0.1)) return false;
        m.from = written(a->bound - a->seen / slope, 1e4), m.to = written(m.from + 1 / slope, 1e4);
        double sum = 0, count = 0;  // at no variance, the bound tells the minimum
        for (std::size_t i = first + measured; i < first + 2 * measured; ++i)
            if (const auto bound = m.bound_of(r.out[i].x); bound && is_dark(i))
                sum += *bound * squared(i) / (1 - *bound), ++count;
        if (count == 0) return true;
        const double least = sum / count, digit = std::pow(10, std::floor(std::log10(least)) - 2);
        m.min_variance = written(least / digit, 1) * digit;
        return true;
    }

    /// As somebody writes a number: with few digits.
    static double written(double v, double parts) { return std::round(v * parts) / parts; }

    static std::size_t explained_by(const bound_model& m, const results& r) {
        std::size_t count = 0;
        for (std::size_t i = first_random; i < r.out.size(); ++i)
            count += std::abs(m(r.moments(i), r.receiver(i)) - double(r.out[i].x)) <= close;
        return count;
    }

    void conclude(const bound_model& best, const results& r) {
        found_.slips = best.slips();
        found_.function = found_.expected = best.name();
        for (std::size_t i = first_random; i < r.out.size(); ++i) {
            const float expected = best.own(r.moments(i), r.receiver(i)), got = r.out[i].x;
            const bool same = same_bits(expected, got);
            found_.same_bits += same;
            const bool differs = found_.slips.empty() ? !same : std::abs(double(expected) - double(got)) > close;
            if (differs && !found_.first)
                found_.first = {
                    {}, {}, vec4(r.moments(i), r.receiver(i), 0), vec4(r.out[i].x, 0, 0, 0), {expected, 0, 0, 0}};
        }
        if (found_.slips.empty() && found_.same_bits < found_.inputs)
            found_.but.push_back({"rounding", "quotients are rounded otherwise: off by up to 1.2e-4"});
        found_.how = !found_.slips.empty() ? agreement::other
                     : found_.but.empty()  ? agreement::same_bits
                                           : agreement::same_but;
    }

    dice random_;
    verdict& found_;
    bool asked_ = false;
};

}  // namespace

std::unique_ptr<stage> investigate_bound(const expectation&, std::uint32_t seed, verdict& v) {
    return std::make_unique<bounds>(seed, v);
}

}  // namespace check
