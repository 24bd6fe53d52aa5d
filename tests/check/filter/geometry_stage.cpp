// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>

#include "stages.hpp"

namespace check {
namespace {

using glm::ivec2;
using glm::vec2;

/// All changes of the coordinate that are known, the fewest first.
std::vector<geometry_model> known_geometries() {
    std::vector<geometry_model> all;
    for (float zoom : {1.0f, 2.0f, 0.5f})
        for (int bits = 0; bits < 16; ++bits) {
            const geometry_model g{.swap_uv = (bits & 8) != 0,
                                   .flip_x = (bits & 4) != 0,
                                   .flip_y = (bits & 1) != 0,
                                   .zoom = zoom,
                                   .swap_texel = (bits & 2) != 0};
            if (!(g.swap_uv && g.swap_texel)) all.push_back(g);
        }
    return all;
}

/// Goes on where the comparison gave up: what a function reads is worth seeing then, too.
class finds_place final : public stage {
public:
    explicit finds_place(filter_knowledge& k) : k_(k) {}

    std::optional<batch> ask() override {
        if (at_ > texels.size()) return std::nullopt;
        const bool coarse = at_ < texels.size();
        batch b = lone_texel(k_.compare, map_size, coarse ? texels[at_] : lone);
        const float receiver = receiver_between(k_.compare);
        const auto add = [&](ivec2 count, auto place) {
            for (int y = 0; y < count.y; ++y)
                for (int x = 0; x < count.x; ++x) {
                    const vec2 at = place(vec2(x, y));
                    b.inputs.push_back({at.x, at.y, receiver, 0});
                }
        };
        if (coarse) add(map_size * 2, [](vec2 i) { return (i + 0.5f) / 2.0f; });
        else add(ivec2(across), [&](vec2 i) { return k_.geometry.source(center_ - offset_of(i), map_size); });
        return b;
    }

    void learn(const batch& b, std::span<const glm::vec4> out) override {
        centroid_sum sum;
        const compare_model& c = k_.compare;
        std::vector<float> weights;
        for (std::size_t i = 0; i < out.size(); ++i) {
            const float weight = (out[0].x - out[i].x) / (c.lit - c.shadow);
            weights.push_back(weight);
            if (std::abs(weight) > 1e-4f) sum.add({b.inputs[i].x, b.inputs[i].y}, double(weight));
        }
        if (!(std::abs(sum.weight) > 1e-3)) {
            at_ = texels.size() + 1;
            return give_up("no coordinate inside the map reads its texel in the center");
        }
        if (at_ < texels.size()) centers_[at_] = sum.mean();
        if (++at_ == texels.size()) recognize();
        if (at_ > texels.size()) {
            k_.found->seen = {steps, offset_of(vec2(0)), ivec2(across), std::move(weights)};
            k_.centroid = k_.geometry(sum.mean(), map_size);
        }
    }

private:
    static constexpr std::array<ivec2, 3> texels{lone, lone + ivec2(10, 0), lone + ivec2(0, 5)};
    static constexpr int steps = 8, across = 10 * steps;

    /// From the coordinate to a texel.
    static vec2 offset_of(vec2 i) { return (i + 0.5f) / float(steps) - 5.0f; }

    /// The places of three shadows tell one change of the coordinate from all others.
    void recognize() {
        center_ = glm::floor(centers_[0]) + 0.5f;
        for (const geometry_model& g : known_geometries()) {
            const vec2 a = g(centers_[0], map_size), x = g(centers_[1], map_size) - a, y = g(centers_[2], map_size) - a;
            const auto close = [](vec2 v, vec2 w) { return std::abs(v.x - w.x) < 0.7f && std::abs(v.y - w.y) < 0.7f; };
            const vec2 shift = vec2(lone) + 0.5f - a;
            if (!close(x, {10, 0}) || !close(y, {0, 5}) || std::abs(shift.x) > 5 || std::abs(shift.y) > 5) continue;
            k_.geometry = g;
            center_ = glm::floor(a) + 0.5f;
            return;
        }
        give_up(
            "texels appear at places that no shift, flip or exchange explains: the coordinate may "
            "be scaled or projected otherwise");
    }

    void give_up(const char* why) {
        if (!k_.lost) k_.give_up("geometry", why);
    }

    filter_knowledge& k_;
    std::size_t at_ = 0;
    std::array<vec2, 3> centers_{};
    vec2 center_{0};  ///< of the texel that is seen, without the shift
};

}  // namespace

std::unique_ptr<stage> geometry_stage(filter_knowledge& k) { return std::make_unique<finds_place>(k); }

}  // namespace check
