// SPDX-License-Identifier: MIT
//
// Conversions between the depths that a shadow map can store.
//   z/w               what the rasterizer interpolates: project_depth
//   linear depth      view-space distance along the light's axis over z_far: linear_depth
//   radial distance   distance from the light over its range: distance_depth
//   reversed          1 - depth. Reversed versions keep the precision that 1 - depth would lose
//
//     float d = umbrage::linear_depth(-view_position.z, 1.0f / z_far);
//
// Also called: linearize depth, LinearEyeDepth, perspectiveDepthToViewZ (view_z_from_depth, depth_from_view_z).
//
#pragma once

#include <cmath>

#include <glm/vec3.hpp>

#include <umbrage/core/scalar.hpp>
#include <umbrage/core/snippet.hpp>

namespace umbrage {

/// Linear depth, z_view * inv_z_far: 0 at the light, 1 at the far plane, not clamped.
/// @param z_view      distance along the light's axis in world units, positive in front of the light
/// @param inv_z_far   1 / z_far
/// @exactness         B, n = 1: one product
template <real T>
[[nodiscard]] constexpr T linear_depth(T z_view, T inv_z_far) {
    return z_view * inv_z_far;
}

/// Depth from clip coordinates, z / w.
/// @param z         third component of the clip position
/// @param w         fourth component of the clip position
/// @param cleared   cleared_depth of the clip space: 1, or 0 where depth is reversed
/// @edge            w <= 0 (not in front of the light) or NaN: cleared, the far plane
/// @exactness       C, n = 3: one division. S = |z / w|
template <real T>
[[nodiscard]] constexpr T project_depth(T z, T w, T cleared) {
    return w > T(0) && !is_nan(w) ? z / w : cleared;
}

/// Radial distance, |to_point| * inv_range: 0 at the light, 1 at its range, not clamped.
/// @param to_point    vector from the light to the point, world units
/// @param inv_range   1 / range of the light
/// @exactness         C, n = 9: a square root
template <real T>
[[nodiscard]] T distance_depth(glm::vec<3, T> to_point, T inv_range) {
    return std::sqrt(to_point.x * to_point.x + to_point.y * to_point.y + to_point.z * to_point.z) * inv_range;
}

/// Forward depth from reversed depth, or reversed from forward.
/// @formula       1 - depth
/// @exactness     B, n = 1: one subtraction, exact for depth in [1/2, 2] and for multiples of 2^-24 in [0, 1]
template <real T>
[[nodiscard]] constexpr T reverse_depth(T depth) {
    return T(1) - depth;
}

/// Depth in [0, 1] from z/w in [-1, 1], the OpenGL convention.
/// @formula       ndc / 2 + 1/2
/// @exactness     B, n = 2: one sum
template <real T>
[[nodiscard]] constexpr T depth_from_ndc(T ndc) {
    return ndc * T(0.5) + T(0.5);
}

/// Distance along the light's axis from perspective depth: z_near .. z_far, world units, not clamped.
/// @param depth           z/w in [0, 1], 0 at the near plane
/// @param z_near          near plane, world units, 0 < z_near < z_far
/// @param z_far           far plane, world units; may be infinite
/// @formula               n / (1 - depth (1 - n / f))
/// @exactness             C, n = 8: two divisions. S = n (1 + depth (1 + n / f)) / (1 - depth (1 - n / f))^2
template <real T>
[[nodiscard]] constexpr T view_z_from_depth(T depth, T z_near, T z_far) {
    return z_near / (T(1) - depth * (T(1) - z_near / z_far));
}

/// Perspective depth from the distance along the light's axis: z/w in [0, 1], 0 at the near plane, not clamped.
/// @param z_view          > 0, world units
/// @param z_near          near plane, world units, 0 < z_near < z_far
/// @param z_far           far plane, world units; may be infinite
/// @formula               (1 - n / z) / (1 - n / f)
/// @exactness             C, n = 10: three divisions. S = (1 + n / z) (1 + n / f) / (1 - n / f)^2
template <real T>
[[nodiscard]] constexpr T depth_from_view_z(T z_view, T z_near, T z_far) {
    return (T(1) - z_near / z_view) / (T(1) - z_near / z_far);
}

/// Distance along the light's axis from reversed perspective depth: z_near .. z_far, world units, not clamped.
///
/// It is within 3 ulp of the distance for depth in [0, 1], since nothing cancels. Going through 1 - depth would lose
/// thousands of ulp far from the light.
/// @param depth           z/w in [0, 1], 1 at the near plane
/// @param z_near          near plane, world units, 0 < z_near < z_far
/// @param z_far           far plane, world units; may be infinite
/// @formula               n / (n / f + depth (1 - n / f))
/// @exactness             C, n = 11: two divisions. S = n (n / f + depth (1 + n / f)) / (n / f + depth (1 - n / f))^2
template <real T>
[[nodiscard]] constexpr T view_z_from_reversed_depth(T depth, T z_near, T z_far) {
    return z_near / (z_near / z_far + depth * (T(1) - z_near / z_far));
}

/// Reversed perspective depth from the distance along the light's axis: 1 at the near plane, not clamped.
/// @param z_view          > 0, finite, world units
/// @param z_near          near plane, world units, 0 < z_near < z_far
/// @param z_far           far plane, world units; may be infinite
/// @formula               n / z (1 - z / f) / (1 - n / f)
/// @exactness             C, n = 13: four divisions. S = n / z (1 + z / f) (1 + n / f) / (1 - n / f)^2
template <real T>
[[nodiscard]] constexpr T reversed_depth_from_view_z(T z_view, T z_near, T z_far) {
    return z_near / z_view * (T(1) - z_view / z_far) / (T(1) - z_near / z_far);
}

/// Distance along the light's axis from orthographic depth, as of a directional light: z_near .. z_far, not clamped.
/// @param depth           z/w in [0, 1], 0 at the near plane
/// @param z_near          near plane, world units, z_near < z_far. Exchange them where depth is reversed
/// @param z_far           far plane, world units. The exchange keeps all precision
/// @formula               n + depth (f - n)
/// @exactness             B, n = 3: sums and a product
template <real T>
[[nodiscard]] constexpr T view_z_from_orthographic_depth(T depth, T z_near, T z_far) {
    return z_near + depth * (z_far - z_near);
}

/// Orthographic depth, as of a directional light, from the distance along the light's axis: z/w, not clamped.
/// @param z_view          distance along the axis, world units
/// @param z_near          near plane, world units, z_near < z_far. Exchange them where depth is reversed
/// @param z_far           far plane, world units
/// @formula               (z - n) / (f - n)
/// @exactness             C, n = 5: one division. S = (z + n) (f + n) / (f - n)^2
template <real T>
[[nodiscard]] constexpr T orthographic_depth_from_view_z(T z_view, T z_near, T z_far) {
    return (z_view - z_near) / (z_far - z_near);
}

namespace glsl {

inline constexpr snippet linear_depth{
    .name = "linear_depth",
    .summary = "view-space z over z_far",
    .exactness = tier::b,
    .operations = 1,
    .source = R"GLSL(
// umbrage_linear_depth: distance along the light's axis, positive in front of the light, times 1 / z_far
UMBRAGE_HIGHP float umbrage_linear_depth(UMBRAGE_HIGHP float z_view, UMBRAGE_HIGHP float inv_z_far) {
    return z_view * inv_z_far;
}
)GLSL",
};

inline constexpr snippet project_depth{
    .name = "project_depth",
    .summary = "z / w, and the far plane behind the light",
    .exactness = tier::c,
    .operations = 3,
    .source = R"GLSL(
// umbrage_project_depth: z / w. Returns cleared for w <= 0.0: 1.0, or 0.0 where depth is reversed
UMBRAGE_HIGHP float umbrage_project_depth(UMBRAGE_HIGHP float z, UMBRAGE_HIGHP float w, UMBRAGE_HIGHP float cleared) {
    return w > 0.0 ? z / w : cleared;
}
)GLSL",
};

inline constexpr snippet distance_depth{
    .name = "distance_depth",
    .summary = "distance to the light over its range",
    .exactness = tier::c,
    .operations = 9,
    .source = R"GLSL(
// umbrage_distance_depth: length of to_point, the vector from the light, times 1 / range
UMBRAGE_HIGHP float umbrage_distance_depth(UMBRAGE_HIGHP vec3 to_point, UMBRAGE_HIGHP float inv_range) {
    return sqrt(to_point.x * to_point.x + to_point.y * to_point.y + to_point.z * to_point.z) * inv_range;
}
)GLSL",
};

inline constexpr snippet reverse_depth{
    .name = "reverse_depth",
    .summary = "1 - depth",
    .exactness = tier::b,
    .operations = 1,
    .source = R"GLSL(
// umbrage_reverse_depth: forward depth from reversed depth, or reversed from forward
UMBRAGE_HIGHP float umbrage_reverse_depth(UMBRAGE_HIGHP float depth) {
    return 1.0 - depth;
}
)GLSL",
};

inline constexpr snippet depth_from_ndc{
    .name = "depth_from_ndc",
    .summary = "z/w in [-1, 1] to depth in [0, 1]",
    .exactness = tier::b,
    .operations = 2,
    .source = R"GLSL(
// umbrage_depth_from_ndc: depth in [0, 1] from z/w in [-1, 1]
UMBRAGE_HIGHP float umbrage_depth_from_ndc(UMBRAGE_HIGHP float ndc) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float depth = ndc * 0.5 + 0.5;
    return depth;
}
)GLSL",
};

inline constexpr snippet view_z_from_depth{
    .name = "view_z_from_depth",
    .summary = "perspective depth to view-space z",
    .exactness = tier::c,
    .operations = 8,
    .source = R"GLSL(
// umbrage_view_z_from_depth: distance along the light's axis from perspective depth in [0, 1], 0.0 at z_near
UMBRAGE_HIGHP float umbrage_view_z_from_depth(UMBRAGE_HIGHP float depth, UMBRAGE_HIGHP float z_near,
                                              UMBRAGE_HIGHP float z_far) {
    return z_near / (1.0 - depth * (1.0 - z_near / z_far));
}
)GLSL",
};

inline constexpr snippet depth_from_view_z{
    .name = "depth_from_view_z",
    .summary = "view-space z to perspective depth",
    .exactness = tier::c,
    .operations = 10,
    .source = R"GLSL(
// umbrage_depth_from_view_z: perspective depth in [0, 1], 0.0 at z_near, from the distance along the light's axis
UMBRAGE_HIGHP float umbrage_depth_from_view_z(UMBRAGE_HIGHP float z_view, UMBRAGE_HIGHP float z_near,
                                              UMBRAGE_HIGHP float z_far) {
    return (1.0 - z_near / z_view) / (1.0 - z_near / z_far);
}
)GLSL",
};

inline constexpr snippet view_z_from_reversed_depth{
    .name = "view_z_from_reversed_depth",
    .summary = "reversed perspective depth to view-space z",
    .exactness = tier::c,
    .operations = 11,
    .source = R"GLSL(
// umbrage_view_z_from_reversed_depth: distance along the light's axis from perspective depth in [0, 1], 1.0 at z_near
UMBRAGE_HIGHP float umbrage_view_z_from_reversed_depth(UMBRAGE_HIGHP float depth, UMBRAGE_HIGHP float z_near,
                                                       UMBRAGE_HIGHP float z_far) {
    return z_near / (z_near / z_far + depth * (1.0 - z_near / z_far));
}
)GLSL",
};

inline constexpr snippet reversed_depth_from_view_z{
    .name = "reversed_depth_from_view_z",
    .summary = "view-space z to reversed perspective depth",
    .exactness = tier::c,
    .operations = 13,
    .source = R"GLSL(
// umbrage_reversed_depth_from_view_z: perspective depth in [0, 1], 1.0 at z_near, from the distance along the light's
// axis
UMBRAGE_HIGHP float umbrage_reversed_depth_from_view_z(UMBRAGE_HIGHP float z_view, UMBRAGE_HIGHP float z_near,
                                                       UMBRAGE_HIGHP float z_far) {
    return z_near / z_view * (1.0 - z_view / z_far) / (1.0 - z_near / z_far);
}
)GLSL",
};

inline constexpr snippet view_z_from_orthographic_depth{
    .name = "view_z_from_orthographic_depth",
    .summary = "orthographic depth to view-space z",
    .exactness = tier::b,
    .operations = 3,
    .source = R"GLSL(
// umbrage_view_z_from_orthographic_depth: distance along the light's axis from orthographic depth in [0, 1]
// Depth is 0.0 at z_near. Exchange z_near and z_far where it is reversed
UMBRAGE_HIGHP float umbrage_view_z_from_orthographic_depth(UMBRAGE_HIGHP float depth, UMBRAGE_HIGHP float z_near,
                                                           UMBRAGE_HIGHP float z_far) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float z_view = z_near + depth * (z_far - z_near);
    return z_view;
}
)GLSL",
};

inline constexpr snippet orthographic_depth_from_view_z{
    .name = "orthographic_depth_from_view_z",
    .summary = "view-space z to orthographic depth",
    .exactness = tier::c,
    .operations = 5,
    .source = R"GLSL(
// umbrage_orthographic_depth_from_view_z: orthographic depth in [0, 1] from the distance along the light's axis
// Depth is 0.0 at z_near. Exchange z_near and z_far where it is reversed
UMBRAGE_HIGHP float umbrage_orthographic_depth_from_view_z(UMBRAGE_HIGHP float z_view, UMBRAGE_HIGHP float z_near,
                                                           UMBRAGE_HIGHP float z_far) {
    return (z_view - z_near) / (z_far - z_near);
}
)GLSL",
};

inline constexpr const auto& conversions_snippets =
    list<&linear_depth, &project_depth, &distance_depth, &reverse_depth, &depth_from_ndc, &view_z_from_depth,
         &depth_from_view_z, &view_z_from_reversed_depth, &reversed_depth_from_view_z, &view_z_from_orthographic_depth,
         &orthographic_depth_from_view_z>;

}  // namespace glsl
}  // namespace umbrage
