// SPDX-License-Identifier: MIT
//
// The depth test of a shadow map, and the two classic samples' ways to write it.
//
//     bool lit = umbrage::less_equal{}(receiver - bias, stored);
//
// Filters compare once per texel with less_equal and no epsilon inside; for reversed Z pass greater_equal, or
// comparison where the direction is known when the program runs (in shaders: the binding's direction). A NaN on either
// side is in shadow. A receiver beyond the far plane, where no map reaches, is lit: filters ask beyond_far_plane
// before they compare.
#pragma once

#include <umbrage/core/clip_space.hpp>
#include <umbrage/core/scalar.hpp>
#include <umbrage/core/snippet.hpp>

namespace umbrage {

/// Lit when the receiver is no farther than the stored occluder.
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
    template <real T>
    [[nodiscard]] static constexpr T towards_light(T depth, T by) {
        return depth - by;
    }
};

/// The same for reversed Z, where near is 1.
struct greater_equal {
    template <real T>
    [[nodiscard]] constexpr bool operator()(T receiver, T stored) const {
        return !is_nan(receiver) && !is_nan(stored) && receiver >= stored;
    }
    template <real T>
    [[nodiscard]] static constexpr bool beyond_far_plane(T receiver) {
        return !is_nan(receiver) && receiver < T(0);
    }
    template <real T>
    [[nodiscard]] static constexpr T towards_light(T depth, T by) {
        return depth + by;
    }
};

/// less_equal for depths on a scale of their own, as level_rg and decode_ps14 have them, where 1 is not the far plane:
/// receivers beyond it come in as what every texel lights.
struct less_equal_scaled : less_equal {
    template <real T>
    [[nodiscard]] static constexpr bool beyond_far_plane(T) {
        return false;
    }
};

/// less_equal, or greater_equal where depth is reversed.
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
    template <real T>
    [[nodiscard]] constexpr T towards_light(T depth, T by) const {
        return direction == depth_direction::forward ? less_equal::towards_light(depth, by)
                                                     : greater_equal::towards_light(depth, by);
    }
};

/// True for receivers behind the far plane, where no map reaches; never for a comparison on a scale of its own.
/// @exactness     A
template <real T, class Compare = less_equal>
[[nodiscard]] constexpr bool beyond_far_plane(T receiver, const Compare& is_lit = {}) {
    if constexpr (requires { is_lit.beyond_far_plane(receiver); }) return is_lit.beyond_far_plane(receiver);
    else return false;
}

/// True for receivers up to the far plane; false beyond it. For NaN neither this nor beyond_far_plane is true.
/// @exactness     A
template <real T, class Compare = less_equal>
[[nodiscard]] constexpr bool within_far_plane(T receiver, const Compare& is_lit = {}) {
    return !is_nan(receiver) && !beyond_far_plane(receiver, is_lit);
}

/// Visibility of one comparison.
/// @param receiver   depth, biased;   stored  depth from the map
/// @return           1 when lit, 0 in shadow
/// @exactness        A
template <real T, class Compare = less_equal>
[[nodiscard]] constexpr T compare(T receiver, T stored, Compare is_lit = {}) {
    return is_lit(receiver, stored) ? T(1) : T(0);
}

/// Visibility as the DirectX SDK's ShadowMap sample tests it.
/// @param receiver, stored   depths;   epsilon  in depth, added to the stored side
/// @return        0 when stored + epsilon < receiver, else 1: NaN is lit here
/// @exactness     B, n = 1: one sum. S = |stored| + |epsilon|
/// @cite          Microsoft DirectX SDK, ShadowMap sample
template <real T>
[[nodiscard]] constexpr T compare_dx_sdk(T receiver, T stored, T epsilon) {
    const T limit = stored + epsilon;
    return !is_nan(limit) && !is_nan(receiver) && limit < receiver ? T(0) : T(1);
}

/// Visibility as the directional-light exercise tests it.
/// @param current, stored    depths;   epsilon  in depth, added to the stored side
/// @return        1 when current < stored + epsilon, else 0: NaN is in shadow here
/// @exactness     B, n = 1: one sum. S = |stored| + |epsilon|
template <real T>
[[nodiscard]] constexpr T compare_exercise(T current, T stored, T epsilon) {
    const T limit = stored + epsilon;
    return !is_nan(limit) && !is_nan(current) && current < limit ? T(1) : T(0);
}

namespace glsl {

inline constexpr snippet beyond_far_plane{
    .name = "beyond_far_plane",
    .summary = "receivers behind the far plane",
    .exactness = tier::a,
    .role = hook::beyond_far_plane,
    .source = R"GLSL(
// umbrage_beyond_far_plane: whether a receiver is behind the far plane
bool umbrage_beyond_far_plane(UMBRAGE_HIGHP float receiver) {
    return receiver > 1.0;
}
)GLSL",
};

inline constexpr snippet within_far_plane{
    .name = "within_far_plane",
    .summary = "receivers up to the far plane, NaN is none",
    .exactness = tier::a,
    .role = hook::within_far_plane,
    .source = R"GLSL(
// umbrage_within_far_plane: whether a receiver is a number, and not behind the far plane
bool umbrage_within_far_plane(UMBRAGE_HIGHP float receiver) {
    return receiver <= 1.0;
}
)GLSL",
};

inline constexpr snippet compare{
    .name = "compare",
    .summary = "one comparison",
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
    .summary = "stored + epsilon < receiver is shadow",
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
    .summary = "current < stored + epsilon is lit",
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
