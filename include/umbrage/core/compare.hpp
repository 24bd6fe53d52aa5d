// SPDX-License-Identifier: MIT
//
// Depth comparison of a shadow map, and the forms that two well-known samples use.
//
//     bool lit = umbrage::less_equal{}(receiver - bias, stored);
//
// Filters compare once per texel with `less_equal`, without an epsilon. For reversed Z pass `greater_equal`.
// Pass comparison if the direction is known only at run time. In shaders the binding gives the direction.
// NaN on either side is in shadow. A receiver beyond the far plane is lit: filters test `beyond_far_plane` first.
// Also called: shadow test, depth test (compare).
#pragma once

#include <umbrage/core/clip_space.hpp>
#include <umbrage/core/scalar.hpp>
#include <umbrage/core/snippet.hpp>

namespace umbrage {

/// Lit if the receiver is no farther than the stored occluder.
/// @exactness     A
struct less_equal {
    template <real T>
    [[nodiscard]] constexpr bool operator()(T receiver, T stored) const {
        return !is_nan(receiver) && !is_nan(stored) && receiver <= stored;
    }
    template <real T>
    [[nodiscard]] static constexpr bool beyond_far_plane(T receiver) {
        return !is_nan(receiver) && receiver > T(1);
    }
};

/// Lit if the receiver is no farther than the stored occluder, for reversed Z: the near plane is 1.
struct greater_equal {
    template <real T>
    [[nodiscard]] constexpr bool operator()(T receiver, T stored) const {
        return !is_nan(receiver) && !is_nan(stored) && receiver >= stored;
    }
    template <real T>
    [[nodiscard]] static constexpr bool beyond_far_plane(T receiver) {
        return !is_nan(receiver) && receiver < T(0);
    }
};

/// less_equal for depths on another scale, such as those of level_rg and decode_ps14. There 1 is not the far plane.
/// A receiver beyond the far plane arrives as a value that every texel lights.
struct less_equal_scaled : less_equal {
    template <real T>
    [[nodiscard]] static constexpr bool beyond_far_plane(T) {
        return false;
    }
};

/// less_equal, or greater_equal for reversed depth.
struct comparison {
    depth_direction direction = depth_direction::forward;

    template <real T>
    [[nodiscard]] constexpr bool operator()(T receiver, T stored) const {
        return direction == depth_direction::forward ? less_equal{}(receiver, stored)
                                                     : greater_equal{}(receiver, stored);
    }
    template <real T>
    [[nodiscard]] constexpr bool beyond_far_plane(T receiver) const {
        return direction == depth_direction::forward ? less_equal::beyond_far_plane(receiver)
                                                     : greater_equal::beyond_far_plane(receiver);
    }
};

/// True for receivers beyond the far plane, which no map covers. Always false for a comparison on another scale.
/// @exactness     A
template <real T, class Compare = less_equal>
[[nodiscard]] constexpr bool beyond_far_plane(T receiver, const Compare& is_lit = {}) {
    if constexpr (requires { is_lit.beyond_far_plane(receiver); }) return is_lit.beyond_far_plane(receiver);
    else return false;
}

/// True for receivers up to the far plane, false beyond it. For NaN both this and beyond_far_plane are false.
/// @exactness     A
template <real T, class Compare = less_equal>
[[nodiscard]] constexpr bool within_far_plane(T receiver, const Compare& is_lit = {}) {
    return !is_nan(receiver) && !beyond_far_plane(receiver, is_lit);
}

/// Visibility from one comparison.
/// @param receiver   receiver depth, with the bias already applied
/// @param stored     depth from the map
/// @param is_lit     less_equal, or greater_equal for reversed depth
/// @return           1 when lit, 0 in shadow
/// @exactness        A
template <real T, class Compare = less_equal>
[[nodiscard]] constexpr T compare(T receiver, T stored, Compare is_lit = {}) {
    return is_lit(receiver, stored) ? T(1) : T(0);
}

/// Visibility as the DirectX SDK's ShadowMap sample computes it.
/// @param receiver           depth of the receiver
/// @param stored             depth in the map
/// @param epsilon            depth units, added to the stored depth
/// @return        0 when stored + epsilon < receiver, else 1
/// @edge          NaN: 1
/// @exactness     B, n = 1: one sum. S = |stored| + |epsilon|
/// @cite          Microsoft DirectX SDK, ShadowMap sample
template <real T>
[[nodiscard]] constexpr T compare_dx_sdk(T receiver, T stored, T epsilon) {
    const T limit = stored + epsilon;
    return !is_nan(limit) && !is_nan(receiver) && limit < receiver ? T(0) : T(1);
}

/// Visibility as the directional-light exercise computes it.
/// @param current            depth of the receiver
/// @param stored             depth in the map
/// @param epsilon            depth units, added to the stored depth
/// @return        1 when current < stored + epsilon, else 0
/// @edge          NaN: 0
/// @exactness     B, n = 1: one sum. S = |stored| + |epsilon|
template <real T>
[[nodiscard]] constexpr T compare_exercise(T current, T stored, T epsilon) {
    const T limit = stored + epsilon;
    return !is_nan(limit) && !is_nan(current) && current < limit ? T(1) : T(0);
}

namespace glsl {

inline constexpr snippet beyond_far_plane{
    .name = "beyond_far_plane",
    .summary = "receivers beyond the far plane",
    .exactness = tier::a,
    .role = hook::beyond_far_plane,
    .source = R"GLSL(
// umbrage_beyond_far_plane: true if a receiver is beyond the far plane
bool umbrage_beyond_far_plane(UMBRAGE_HIGHP float receiver) {
    return receiver > 1.0;
}
)GLSL",
};

inline constexpr snippet within_far_plane{
    .name = "within_far_plane",
    .summary = "receivers up to the far plane; NaN is not",
    .exactness = tier::a,
    .role = hook::within_far_plane,
    .source = R"GLSL(
// umbrage_within_far_plane: true if a receiver is a number and not beyond the far plane
bool umbrage_within_far_plane(UMBRAGE_HIGHP float receiver) {
    return receiver <= 1.0;
}
)GLSL",
};

inline constexpr snippet compare{
    .name = "compare",
    .summary = "visibility from one comparison",
    .exactness = tier::a,
    .role = hook::compare,
    .source = R"GLSL(
// umbrage_compare: 1.0 when the receiver is no farther than the stored depth
UMBRAGE_HIGHP float umbrage_compare(UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float stored) {
    return receiver <= stored ? 1.0 : 0.0;
}
)GLSL",
};

inline constexpr snippet compare_dx_sdk{
    .name = "compare_dx_sdk",
    .summary = "shadow if stored + epsilon < receiver",
    .exactness = tier::b,
    .operations = 1,
    .source = R"GLSL(
// umbrage_compare_dx_sdk: 0.0 when stored + epsilon < receiver, else 1.0
UMBRAGE_HIGHP float umbrage_compare_dx_sdk(UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float stored,
                                           UMBRAGE_HIGHP float epsilon) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float limit = stored + epsilon;
    return limit < receiver ? 0.0 : 1.0;
}
)GLSL",
};

inline constexpr snippet compare_exercise{
    .name = "compare_exercise",
    .summary = "lit if current < stored + epsilon",
    .exactness = tier::b,
    .operations = 1,
    .source = R"GLSL(
// umbrage_compare_exercise: 1.0 when current < stored + epsilon, else 0.0
UMBRAGE_HIGHP float umbrage_compare_exercise(UMBRAGE_HIGHP float current, UMBRAGE_HIGHP float stored,
                                             UMBRAGE_HIGHP float epsilon) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float limit = stored + epsilon;
    return current < limit ? 1.0 : 0.0;
}
)GLSL",
};

inline constexpr const snippet* compare_snippets[]{&beyond_far_plane, &within_far_plane, &compare, &compare_dx_sdk,
                                                   &compare_exercise};

}  // namespace glsl
}  // namespace umbrage
