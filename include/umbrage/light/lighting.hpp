// SPDX-License-Identifier: MIT
//
// Lighting of the DirectX SDK's ShadowMap sample: a spot cone, and diffuse plus ambient light.
//
//     float cone = umbrage::spot_cone(light_direction, point - light_position, cos_outer_angle);
//     glm::vec3 color = umbrage::diffuse_ambient(albedo, ambient, glm::dot(normal, to_light), visibility * cone);
//
// Also called: spotlight cone, smooth falloff, inner and outer angle (spot_cone).
//
#pragma once

#include <glm/vec3.hpp>

#include <umbrage/core/scalar.hpp>
#include <umbrage/core/snippet.hpp>

namespace umbrage {

/// 1 for points inside a spot light's cone, else 0.
///
/// @param direction   direction of the light, unit length
/// @param to_point    vector from the light to the point, of any length whose square neither overflows nor underflows
/// @param cos_outer   cosine of the angle between axis and edge of the cone, in [0, 1)
/// @return            1 inside the cone, 0 outside
/// @edge              point at the apex, or NaN: 0
/// @formula           d > 0 and d^2 > cos_outer^2 |to_point|^2, d = direction . to_point: the sample's test without its
///                    normalization
/// @exactness         B, n = 11
/// @cite              Microsoft DirectX SDK, ShadowMap sample
template <real T>
[[nodiscard]] constexpr T spot_cone(glm::vec<3, T> direction, glm::vec<3, T> to_point, T cos_outer) {
    const T d = direction.x * to_point.x + direction.y * to_point.y + direction.z * to_point.z;
    const T length2 = to_point.x * to_point.x + to_point.y * to_point.y + to_point.z * to_point.z;
    const T edge2 = cos_outer * cos_outer * length2;
    const bool defined = !is_nan(d) && !is_nan(edge2);
    return defined && d > T(0) && d * d > edge2 ? T(1) : T(0);
}

/// Light that a diffuse surface reflects to the eye.
///
/// @param albedo       albedo of the surface, RGB
/// @param ambient      fraction of the light that reaches shadows, RGB, each in [0, 1]
/// @param n_dot_l      cosine between the normal and the direction to the light
/// @param visibility   visibility of the light, 1 = lit
/// @edge               n_dot_l <= 0 or NaN: ambient light alone
/// @formula            albedo (visibility n_dot_l (1 - ambient) + ambient) for n_dot_l > 0, else albedo ambient
/// @exactness          B, n = 5
/// @cite               Microsoft DirectX SDK, ShadowMap sample
template <real T>
[[nodiscard]] constexpr glm::vec<3, T> diffuse_ambient(glm::vec<3, T> albedo, glm::vec<3, T> ambient, T n_dot_l,
                                                       T visibility) {
    const bool faces = !is_nan(n_dot_l) && n_dot_l > T(0);
    return albedo * (faces ? visibility * n_dot_l * (T(1) - ambient) + ambient : ambient);
}

namespace glsl {

inline constexpr snippet spot_cone{
    .name = "spot_cone",
    .summary = "1 inside a spot light's cone, else 0",
    .exactness = tier::b,
    .operations = 11,
    .source = R"GLSL(
// umbrage_spot_cone: 1.0 inside the cone of a spot light, else 0.0
//   direction  of the light, unit length;   to_point  from the light, any length;   cos_outer  in [0, 1)
UMBRAGE_HIGHP float umbrage_spot_cone(UMBRAGE_HIGHP vec3 direction, UMBRAGE_HIGHP vec3 to_point,
                                      UMBRAGE_HIGHP float cos_outer) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float d =
        direction.x * to_point.x + direction.y * to_point.y + direction.z * to_point.z;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float length2 =
        to_point.x * to_point.x + to_point.y * to_point.y + to_point.z * to_point.z;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float edge2 = cos_outer * cos_outer * length2;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float d2 = d * d;
    return d > 0.0 && d2 > edge2 ? 1.0 : 0.0;
}
)GLSL",
};

inline constexpr snippet diffuse_ambient{
    .name = "diffuse_ambient",
    .summary = "diffuse plus ambient light of a surface",
    .exactness = tier::b,
    .operations = 5,
    .source = R"GLSL(
// umbrage_diffuse_ambient: albedo * (visibility * n_dot_l * (1 - ambient) + ambient)
//   for n_dot_l <= 0.0 and NaN: albedo * ambient
UMBRAGE_HIGHP vec3 umbrage_diffuse_ambient(UMBRAGE_HIGHP vec3 albedo, UMBRAGE_HIGHP vec3 ambient,
                                           UMBRAGE_HIGHP float n_dot_l, UMBRAGE_HIGHP float visibility) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec3 light = visibility * n_dot_l * (1.0 - ambient) + ambient;
    return albedo * (n_dot_l > 0.0 ? light : ambient);  // max gives NaN for a signalling NaN on Mesa
}
)GLSL",
};

inline constexpr const snippet* lighting_snippets[]{&spot_cone, &diffuse_ambient};

}  // namespace glsl
}  // namespace umbrage
