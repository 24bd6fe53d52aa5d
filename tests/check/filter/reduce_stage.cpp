// SPDX-License-Identifier: MIT
#include <cmath>

#include "stages.hpp"

namespace check {
namespace {

using glm::ivec2;

/// Tries maps from the smallest to larger ones, each with inputs from round numbers to less round ones.
class reduces final : public stage {
public:
    explicit reduces(filter_knowledge& k) : k_(k) {}

    std::optional<batch> ask() override {
        if (at_ == 0) decide();
        if (k_.lost || k_.found->first || k_.found->how == agreement::same_bits) return std::nullopt;
        if (at_ == std::size(trials)) {
            k_.found->first = k_.worst;
            return std::nullopt;
        }
        const trial& t = trials[at_++];
        batch b{t.size, std::vector<float>(std::size_t(t.size.x * t.size.y), t.others), {}};
        b.map[std::size_t(t.texel.y * t.size.x + t.texel.x)] = t.depth;
        for (float z : {0.5f, 0.25f, 0.75f, 0.375f, 0.5078125f})
            for (int parts : {1, 2, 4, 8})
                for (int y = 0; y < t.size.y * parts; ++y)
                    for (int x = 0; x < t.size.x * parts; ++x) {
                        const float step = 1.0f / float(parts), first = parts == 1 ? 0.5f : 0.5f * step;
                        b.inputs.push_back({float(x) * step + first, float(y) * step + first, z, 0});
                    }
        return b;
    }

    void learn(const batch& b, std::span<const glm::vec4> out) override {
        const bool slipped = k_.found->how == agreement::other;
        for (std::size_t i = 0; i < out.size(); ++i) {
            const float wanted = k_.wanted(b, b.inputs[i]), got = out[i].x;
            if (slipped ? beside(k_.wanted, b, b.inputs[i], got) : same_bits(wanted, got)) continue;
            k_.found->first = {b.size, b.map, b.inputs[i], glm::vec4(out[i].x, 0, 0, 0), {wanted, 0, 0, 0}};
            return;
        }
    }

private:
    /// A map of one depth but for one texel.
    struct trial {
        ivec2 size;
        float others;
        ivec2 texel;
        float depth;
    };
    static constexpr trial trials[]{
        {{1, 1}, 0.5f, {0, 0}, 0.5f}, {{2, 1}, 1, {0, 0}, 0}, {{2, 1}, 1, {1, 0}, 0}, {{1, 2}, 1, {0, 0}, 0},
        {{1, 2}, 1, {0, 1}, 0},       {{2, 2}, 1, {0, 0}, 0}, {{2, 2}, 1, {1, 0}, 0}, {{2, 2}, 1, {0, 1}, 0},
        {{4, 4}, 1, {1, 1}, 0},       {{4, 4}, 1, {2, 1}, 0}, {{8, 8}, 1, {3, 3}, 0}, {{16, 16}, 1, {7, 7}, 0},
    };

    /// What is to be shown: a slip, or the least difference of bits.
    void decide() {
        verdict& v = *k_.found;
        if (k_.lost) return;
        const bool slipped = !v.slips.empty() || v.function != v.expected;
        v.how = slipped ? agreement::other : v.but.empty() ? agreement::same_bits : agreement::same_but;
    }

    filter_knowledge& k_;
    std::size_t at_ = 0;
};

/// Stages share what they know.
class filter_investigation final : public stage {
public:
    filter_investigation(const expectation& e, std::uint32_t seed, verdict& v) : k_{e, dice(seed), &v} {
        for (auto make : {compare_stage, geometry_stage, weights_stage, edges_stage, reduce_stage})
            parts_.push_back(make(k_));
    }
    std::optional<batch> ask() override {
        for (; at_ < parts_.size(); ++at_)
            if (auto b = parts_[at_]->ask()) return b;
        return std::nullopt;
    }
    void learn(const batch& b, std::span<const glm::vec4> out) override { parts_[at_]->learn(b, out); }

private:
    filter_knowledge k_;
    std::vector<std::unique_ptr<stage>> parts_{};
    std::size_t at_ = 0;
};

}  // namespace

std::unique_ptr<stage> reduce_stage(filter_knowledge& k) { return std::make_unique<reduces>(k); }

std::unique_ptr<stage> investigate_filter(const expectation& e, std::uint32_t seed, verdict& v) {
    return std::make_unique<filter_investigation>(e, seed, v);
}

}  // namespace check
