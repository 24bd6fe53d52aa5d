// SPDX-License-Identifier: MIT
//
// Inputs of filters whose width comes from blockers.
#pragma once

#include <umbrage/filter/blocker/penumbra.hpp>

#include "../../entries.hpp"

namespace parity {

/// A softness of the receiver's x0.w, for C++ and for GLSL: of no size, small, large, hard and soft where things touch.
[[nodiscard]] inline vec4 softness_of(const sample& s) {
    return {(s.x[0].w + 1.0f) * (1.0f / 512.0f), s.x[0].w * (1.0f / 128.0f), s.x[0].w < 4.0f ? 0.0f : 24.0f, 96.0f};
}
inline constexpr auto soft_arguments =
    ", vec4((x0.w + 1.0) * (1.0 / 512.0), x0.w * (1.0 / 128.0), x0.w < 4.0 ? 0.0 : 24.0, 96.0), "
    "umbrage_disc_rotation(vec2(x0.x, x0.y))";

/// A filter called with a softness and a rotation, forward and reversed.
/// @param alike   to another but for the number of points
/// @param twin    (sample, softness, rotation, is_lit) -> visibility
template <class Twin>
void add_soft_filter(std::vector<entry>& all, const snippet& s, std::size_t share, bool alike, Twin twin) {
    const auto lit = [twin](const sample& x, auto is_lit) {
        return vec4(twin(x, softness_of(x), umbrage::disc_rotation(at(x)), is_lit));
    };
    all.push_back(filter(s, soft_arguments, [lit](const sample& x) { return lit(x, umbrage::less_equal{}); }));
    all.push_back(
        reversed_filter(s, soft_arguments, [lit](const sample& x) { return lit(x, umbrage::greater_equal{}); }));
    for (entry* e : {&all.back() - 1, &all.back()}) {
        e->also = {&umbrage::glsl::disc_rotation};
        e->share = share;
        e->alike = alike;
    }
    all.back().alike = true;
}

}  // namespace parity
