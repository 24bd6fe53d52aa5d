// SPDX-License-Identifier: MIT
//
// Stages of an investigation of a filter, in their order. Each measures what the next one holds fixed, so that slips of
// two stages do not multiply hypotheses.
#pragma once

#include "../numbers.hpp"
#include "../stage.hpp"
#include "model.hpp"

namespace check {

inline constexpr glm::ivec2 map_size{64, 32};  ///< not square: x and y cannot be exchanged without being seen

/// What the stages have found so far.
struct filter_knowledge {
    expectation expected;
    dice random;
    verdict* found;
    compare_model compare{};
    geometry_model geometry{};  ///< without the shift, which depends on the filter's own shape
    glm::vec2 centroid{0};      ///< of the footprint of texel `lone`, in texels, by `geometry`
    filter_model best{}, wanted{};
    std::optional<difference> worst{};  ///< the first random input that differs
    bool lost = false;                  ///< no further stage asks

    /// Ends the investigation: nothing is named.
    void give_up(std::string kind, std::string why) {
        lost = true;
        found->how = agreement::unknown;
        found->but.push_back({std::move(kind), std::move(why)});
    }
};

/// Texel that is alone in shadow where footprints are measured.
inline constexpr glm::ivec2 lone{38, 18};

/// Map that is lit but for one texel, and the receiver depth for which it is so.
[[nodiscard]] batch lone_texel(const compare_model&, glm::ivec2 size, glm::ivec2 texel);
[[nodiscard]] float receiver_between(const compare_model&);

/// Weights, summed: how much shadow, and where.
struct centroid_sum {
    double weight = 0;
    double x = 0, y = 0;
    void add(glm::vec2 at, double w) { weight += w, x += w * at.x, y += w * at.y; }
    [[nodiscard]] glm::vec2 mean() const { return {float(x / weight), float(y / weight)}; }
};

/// Thresholds of the comparison over maps of one depth: direction, strictness, bias, range, which result is lit.
[[nodiscard]] std::unique_ptr<stage> compare_stage(filter_knowledge&);
/// Where the shadow of a lone texel lies: flips, exchanges, ranges; then its weights.
[[nodiscard]] std::unique_ptr<stage> geometry_stage(filter_knowledge&);
/// Which of references(), over a random map, inside it and outside.
[[nodiscard]] std::unique_ptr<stage> weights_stage(filter_knowledge&);
/// NaN, infinity and receivers beyond the far plane.
[[nodiscard]] std::unique_ptr<stage> edges_stage(filter_knowledge&);
/// The smallest map and roundest numbers on which shader and expected filter differ.
[[nodiscard]] std::unique_ptr<stage> reduce_stage(filter_knowledge&);

}  // namespace check
