// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include "stages.hpp"

namespace check {
namespace {

/// Last receiver below a threshold and first one above it, over one stored depth.
struct threshold {
    float stored = 0;
    bool seen = false;
    float low = 0, high = 1;       ///< adjacent floats at the end
    float before = 0, behind = 0;  ///< results below and above
};

class compares final : public stage {
public:
    explicit compares(filter_knowledge& k) : k_(k) {}

    std::optional<batch> ask() override {
        if (k_.lost || at_ == rounds) return std::nullopt;
        const threshold& t = now();
        batch b{map_size, std::vector<float>(std::size_t(map_size.x * map_size.y), t.stored), {}};
        for (int i = 0; i <= steps; ++i) {
            const float z = t.low + (t.high - t.low) * (float(i) / steps);
            b.inputs.push_back({float(lone.x) + 0.3125f, float(lone.y) + 0.3125f, z, 0});
        }
        return b;
    }

    void learn(const batch& b, std::span<const glm::vec4> out) override {
        threshold& t = now();
        const auto differs = [](float a, float c) { return !(std::abs(a - c) < 1e-5f); };
        const auto change =
            std::adjacent_find(out.begin(), out.end(), [&](auto& a, auto& c) { return differs(a.x, c.x); });
        if (change != out.end()) {
            const auto i = static_cast<std::size_t>(change - out.begin());
            // back to the first result: a biased receiver beyond the far plane
            const bool third = std::any_of(
                change + 1, out.end(), [&](auto& v) { return differs(v.x, change[1].x) && differs(v.x, change[0].x); });
            if (third)
                return k_.give_up("continuous",
                                  "over a map of one depth its result is no comparison: it takes more "
                                  "than two values, as variance and exponential shadow maps do");
            t.seen = true, t.before = out[i].x, t.behind = out[i + 1].x;
            t.low = b.inputs[i].z, t.high = b.inputs[i + 1].z;
        }
        at_ += t.seen ? 1 : refinements;
        if (at_ == rounds) conclude();
    }

private:
    static constexpr int steps = 1024, refinements = 3;
    static constexpr int rounds = 4 * refinements;
    [[nodiscard]] threshold& now() { return thresholds_[std::size_t(at_ / refinements)]; }

    void conclude() {
        std::vector<threshold> seen;
        std::copy_if(thresholds_.begin(), thresholds_.end(), std::back_inserter(seen), [](auto& t) { return t.seen; });
        if (seen.size() < 2)
            return k_.give_up("constant", "its result does not depend on the receiver over a map of one depth");
        compare_model& c = k_.compare;
        const threshold &a = seen.front(), &z = seen.back();
        const double slope = double(z.stored - a.stored) / (double(z.high) - double(a.high));
        c.scale = static_cast<float>(slope);
        for (float known : {1.0f, 2.0f, 0.5f, -1.0f})
            if (std::abs(c.scale - known) < 1e-3f) c.scale = known;
        const double offset = double(a.stored) - double(c.scale) * double(a.high);
        c.offset = static_cast<float>(offset);
        bool exact = false;
        for (float known : {0.0f, -1.0f, 0.5f, 1.0f})
            if (std::abs(offset - double(known)) < 4e-7) c.offset = known, exact = true;
        if (!exact) {  // a bias that somebody wrote has few digits
            const double rounded = std::round(offset * 1e6) / 1e6;
            if (std::abs(rounded - offset) < 3e-7) c.offset = static_cast<float>(rounded);
        }
        // of the two results, which one is lit? A tie tells reversed depth from 1 in shadow
        const bool upwards = c.scale > 0;
        const float near_side = upwards ? a.before : a.behind, far_side = upwards ? a.behind : a.before;
        const float tie = c.receiver_of(a.stored);  // receivers beside it may round to the same depth
        const bool tie_is_near = !exact || (upwards ? tie <= a.low : tie >= a.high);
        const bool falls = near_side > far_side;
        c.reversed = !falls && !tie_is_near;
        c.strict = falls && !tie_is_near;
        c.lit = c.reversed ? far_side : near_side, c.shadow = c.reversed ? near_side : far_side;
        for (float* level : {&c.lit, &c.shadow})
            for (float known : {0.0f, 1.0f})
                if (std::abs(*level - known) < 2e-6f) *level = known;
    }

    filter_knowledge& k_;
    std::array<threshold, 4> thresholds_{{{.stored = 0.25f}, {.stored = 0.5f}, {.stored = 0.625f}, {.stored = 0.75f}}};
    int at_ = 0;
};

}  // namespace

float receiver_between(const compare_model& c) { return c.receiver_of(0.625f); }

batch lone_texel(const compare_model& c, glm::ivec2 size, glm::ivec2 texel) {
    const float lit = c.reversed ? 0.125f : 0.875f, shadow = c.reversed ? 0.875f : 0.125f;
    batch b{size, std::vector<float>(std::size_t(size.x * size.y), lit), {}};
    b.map[std::size_t(texel.y * size.x + texel.x)] = shadow;
    return b;
}

std::unique_ptr<stage> compare_stage(filter_knowledge& k) { return std::make_unique<compares>(k); }

}  // namespace check
