// SPDX-License-Identifier: MIT
//
// Cascaded shadow maps (CSM) for a directional light: one map per slice of the camera's range, all with one rotation.
//
//     const umbrage::cascade_fit<float> fit{
//         .camera = camera, .direction = d, .scene = {low, high}, .overlap = 0.1f, .clip = clip};
//     const auto splits = umbrage::practical_splits<4>(0.5f, 300.0f, 0.9f);
//     const auto cascades = umbrage::make_stable_cascades<4>(fit, splits);
//     for (const auto& c : cascades) draw_depths(c.light);                   // one depth pass each
//     const auto uniforms = umbrage::make_cascade_uniforms(cascades, 0.1f);  // for select.hpp and blend.hpp
//
// Far from the world's origin fit in double, then draw and look up with `relative_to(cascades, origin)`.
// Also called: CSM, PSSM, shadow cascades, sun shadows (make_stable_cascades, make_tight_cascades); stable shadows,
// shimmering fix (make_stable_cascades). See also: splits.hpp, select.hpp, blend.hpp, warped.hpp.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include <glm/common.hpp>
#include <glm/mat4x4.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/core/config.hpp>
#include <umbrage/light/bounds.hpp>
#include <umbrage/light/cascades/scene_depths.hpp>
#include <umbrage/light/directional_fit.hpp>
#include <umbrage/light/light_space.hpp>
#include <umbrage/light/texture_matrix.hpp>

namespace umbrage {

/// One cascade: a slice of the camera's range, and its map.
template <real T>
struct cascade {
    light_space<T> light;                      ///< light for the depth pass; all cascades share its view, a rotation
    glm::vec<4, T> scale{T(0)}, offset{T(0)};  ///< from rotated points to texels and depth; w is 0
    T begin = T(0), end = T(0);                ///< slice along the camera's axis, world units
    glm::ivec2 map_size{0};                    ///< size of its map, texels: that of the fit
};

/// Camera, light and scene that cascades are fitted to.
template <real T = float>
struct cascade_fit {
    frustum<T> camera{};                           ///< any kind; the splits replace its z_near and z_far
    glm::vec<3, T> direction{T(0), T(-1), T(0)};   ///< direction the light travels; any length > 0
    glm::vec<3, T> up{T(0), T(1), T(0)};           ///< up axis of the maps; keep it constant, maps rotate with it
    bounding_box<T> scene = detail::unset_box<T>;  ///< required: bounds of all casters and receivers. Without the sky
    glm::ivec2 map_size{1024};                     ///< size of each map, texels; the shadow's too
    T margin = T(2);                               ///< texels around the slice: the filter's reach, and a last fade
    T overlap = T(0);                              ///< fraction of a cascade that the next one also covers, 0 to 1
    clip_space clip{};                             ///< required: clip space of your API or engine, see clip_space.hpp
};

namespace detail {

[[nodiscard]] inline int shorter_side(glm::ivec2 size) { return size.x < size.y ? size.x : size.y; }

/// Cascade of a fitted light whose view is a rotation.
template <real T>
[[nodiscard]] cascade<T> as_cascade(const light_space<double>& light, glm::ivec2 map_size, const char* function) {
    const glm::dmat4 m = texture_matrix<double>({glm::dmat4(1), light.projection, light.clip}, map_size);
    const glm::dvec4 scale(m[0][0], m[1][1], m[2][2], 0.0), offset(glm::dvec3(m[3]), 0.0);
    const light_space<T> cast{glm::mat<4, 4, T>(light.view), glm::mat<4, 4, T>(light.projection), light.clip};
    const cascade<T> c{.light = checked(cast, function, "camera, splits and scene"),
                       .scale = glm::vec<4, T>(scale),
                       .offset = glm::vec<4, T>(offset),
                       .map_size = map_size};
    const bool normal = is_normal(c.scale.x) && is_normal(c.scale.y) && is_normal(c.scale.z);
    require(normal && all_finite(c.scale) && all_finite(c.offset), function, "camera, splits and scene",
            "such that a cascade is neither too large nor too small", c.scale);
    return c;
}

/// Slices of the camera's frustum between splits, with their overlap.
template <std::size_t Count, real T>
[[nodiscard]] std::array<frustum<double>, Count> camera_parts(const cascade_fit<T>& fit,
                                                              const std::array<T, Count + 1>& splits,
                                                              const char* function) {
    require_given(fit.clip, function);
    require_given(fit.scene, function, "scene");
    require(is_finite(splits[0]) && splits[0] >= T(0), function, "splits[0]", "finite, 0 or more", splits[0]);
    for (std::size_t i = 0; i < Count; ++i)
        require(is_finite(splits[i + 1]) && splits[i] < splits[i + 1], function, "splits",
                "finite and in ascending order", glm::vec<2, T>(splits[i], splits[i + 1]));
    require(is_finite(fit.margin) && fit.margin >= T(0), function, "margin", "finite, 0 or more", fit.margin);
    require(double(shorter_side(fit.map_size)) - 2 * double(fit.margin) > 1, function, "map_size", "above 2 margin + 1",
            fit.map_size);
    require(fit.overlap >= T(0) && fit.overlap <= T(1), function, "overlap", "from 0 to 1", fit.overlap);
    std::array<frustum<double>, Count> parts;
    for (std::size_t i = 0; i < Count; ++i) {
        const double before = i > 0 ? double(splits[i]) - double(splits[i - 1]) : 0;
        parts[i] = in_double(fit.camera);
        parts[i].z_near = double(splits[i]) - double(fit.overlap) * before, parts[i].z_far = double(splits[i + 1]);
        require_frustum(parts[i], function, "camera");
    }
    return parts;
}

/// Part of a scene that a slice sees. If the slice sees nothing or one point, it is the whole slice.
template <class = on_use>
[[nodiscard]] hull receivers_of(const frustum<double>& part, const bounding_box<double>& scene) {
    const hull seen(intersection(part, scene)), slice(part);
    const double rounding = 0x1p-40 * extent_of(slice.points).diagonal();
    return seen.points.empty() || extent_of(seen.points).diagonal() <= rounding ? slice : seen;
}

/// Margin in texels as a fraction of the map's size inside the margin.
template <real T>
[[nodiscard]] double margin_share(const cascade_fit<T>& fit) {
    return double(fit.margin) / (shorter_side(fit.map_size) - 2 * double(fit.margin));
}

/// One cascade per slice, from its light.
template <std::size_t Count, real T>
[[nodiscard]] std::array<cascade<T>, Count> make_cascades(const cascade_fit<T>& fit,
                                                          const std::array<T, Count + 1>& splits, const char* function,
                                                          const std::array<light_space<double>, Count>& lights) {
    std::array<cascade<T>, Count> all;
    for (std::size_t i = 0; i < Count; ++i) {
        all[i] = as_cascade<T>(lights[i], fit.map_size, function);
        all[i].begin = splits[i];
        all[i].end = splits[i + 1];
    }
    return all;
}

}  // namespace detail

/// Cascades that do not shimmer while the camera moves or rotates. Texels are square, sized by the map's shorter side.
///
/// Each map covers the sphere around its slice, whose size does not depend on the view, and moves by integer texels.
/// In the depth pass rotate points first, then apply the projection: one float matrix for both may move points by 1/100
/// texel.
///
/// Depth spans what a map holds of the scene. It has one scale in all cascades, so a constant bias is equal in world
/// units. The scale depends on the sizes of the scene and of the largest map, and on the light's direction: a wide
/// ground costs no precision, a tall scene does. While the camera moves, a cascade's depths move by multiples of 1/8.
/// @param fit      camera, light and scene
/// @param splits   Count + 1 distances along the camera's axis, increasing, the first >= 0: see splits.hpp
/// @formula        1 / scale.z = 8/7 (L + D/128). L = min of (s_i + |X_i| w + |Y_i| h) / |Z_i| for each axis i of the
///                 world, and of the sum of s_i |Z_i|. s: sides of the scene; w, h: sides of the largest map, world
///                 units; X, Y, Z: the light's axes. D: diagonal of L and the smaller of map and scene across
/// @accuracy       offsets are integers up to 2^23 texels from the world's origin. A world point keeps its place in its
///                 texel, exactly if it is farther from the origin than the map is wide. Else its coordinate rounds, in
///                 float by 2^-14 texel (6e-5) on maps of 1024, which may change a filter's weights by 1/256
/// @throws std::invalid_argument  splits out of order; map_size, margin or overlap out of range; clip or scene unset;
///                                an invalid camera, direction or scene; matrices that would not be finite
template <std::size_t Count, real T>
[[nodiscard]] std::array<cascade<T>, Count> make_stable_cascades(const cascade_fit<T>& fit,
                                                                 const std::array<T, Count + 1>& splits) {
    constexpr auto function = "make_stable_cascades", sides = "camera, splits and margin", depths = "camera and splits";
    const auto parts = detail::camera_parts<Count>(fit, splits, function);
    const double around = double(fit.margin);
    std::array<light_space<double>, Count> lights;
    glm::dvec2 side(0);
    for (std::size_t i = 0; i < Count; ++i) {
        lights[i] =
            detail::fit_directional<double>({.direction = glm::dvec3(fit.direction),
                                             .up = glm::dvec3(fit.up),
                                             .receivers = sphere_around(parts[i]),
                                             .margin = around / (detail::shorter_side(fit.map_size) - 1 - 2 * around),
                                             .snap_texels = fit.map_size,
                                             .clip = fit.clip},
                                            function, sides, depths);
        const glm::dmat4& p = lights[i].projection;
        side = (glm::max)(side, glm::dvec2(2.0 / p[0][0], 2.0 / p[1][1]));
    }
    const detail::scene_depths seen(fit.scene, lights[0], side, function);
    for (light_space<double>& light : lights) light = seen.of(light);
    auto all = detail::make_cascades<Count>(fit, splits, function, lights);
    for (cascade<T>& c : all)
        for (glm::length_t i = 0; i < 2; ++i) c.offset[i] = std::nearbyint(c.offset[i]);
    return all;
}

/// Cascades of the highest resolution: each map covers the part of the scene inside its slice.
/// A slice that misses the scene, or touches it in a point, gets a map of the whole slice. Texels change size and place
/// as the camera moves, so edges shimmer. The margin is fit.margin or more.
/// Parameters, result and errors are those of make_stable_cascades.
template <std::size_t Count, real T>
[[nodiscard]] std::array<cascade<T>, Count> make_tight_cascades(const cascade_fit<T>& fit,
                                                                const std::array<T, Count + 1>& splits) {
    constexpr auto function = "make_tight_cascades", sides = "camera, splits and margin", depths = "splits and scene";
    const auto parts = detail::camera_parts<Count>(fit, splits, function);
    const bounding_box<double> scene{glm::dvec3(fit.scene.low), glm::dvec3(fit.scene.high)};
    std::array<light_space<double>, Count> lights;
    for (std::size_t i = 0; i < Count; ++i)
        lights[i] = detail::fit_directional<double>({.direction = glm::dvec3(fit.direction),
                                                     .up = glm::dvec3(fit.up),
                                                     .receivers = detail::receivers_of(parts[i], scene),
                                                     .casters = scene,
                                                     .margin = detail::margin_share(fit),
                                                     .clip = fit.clip},
                                                    function, sides, depths);
    return detail::make_cascades<Count>(fit, splits, function, lights);
}

/// Cascades for points relative to an origin near the camera. It may change from frame to frame: see texture_matrix.
/// @throws std::invalid_argument  values that would not be finite in float
template <std::size_t Count>
[[nodiscard]] std::array<cascade<float>, Count> relative_to(const std::array<cascade<double>, Count>& cascades,
                                                            glm::dvec3 origin) {
    std::array<cascade<float>, Count> all;
    for (std::size_t i = 0; i < Count; ++i) {
        const cascade<double>& c = cascades[i];
        const glm::vec4 offset(c.scale * (c.light.view * glm::dvec4(origin, 0.0)) + c.offset);
        detail::require(detail::all_finite(offset), "relative_to", "origin", "such that offsets are finite", origin);
        all[i] = {relative_to(c.light, origin), glm::vec4(c.scale), offset, float(c.begin), float(c.end), c.map_size};
    }
    return all;
}

/// Uniforms of a shader with up to four cascades, for select.hpp and blend.hpp.
template <real T>
struct cascade_uniforms {
    glm::mat<4, 4, T> rotation{T(1)};               ///< world to the light's axes, for shadow_coordinate
    glm::mat<4, 4, T> scales{T(0)}, offsets{T(0)};  ///< one column per cascade; w is for cascade_fade
    glm::vec<3, T> ends{T(0)};                      ///< ends of all cascades but the last, for cascade_by_depth
};

namespace detail {

/// Scale and offset for a cascade's cascade_fade; zeros if nothing fades.
template <real T>
[[nodiscard]] glm::vec<2, T> fade_of(T begin, T end, T fade) {
    const T width = fade * (end - begin);
    const auto terms = width > T(0) ? glm::vec<2, T>(T(1) / width, T(1) - end / width) : glm::vec<2, T>(T(0));
    require(all_finite(terms), "make_cascade_uniforms", "fade", "0, or large enough for finite uniforms", fade);
    return terms;
}

template <real T>
void require_fade(T fade) {
    require(fade >= T(0) && fade <= T(1), "make_cascade_uniforms", "fade", "from 0 to 1", fade);
}

/// Number of vec3 for the ends of all cascades but the last.
template <std::size_t Count>
inline constexpr std::size_t ends_groups = Count < 3 ? 1 : (Count + 1) / 3;

/// Ends of all cascades but the last in groups of three, filled up with the highest number.
template <real T, class Cascade, std::size_t Count>
[[nodiscard]] std::array<glm::vec<3, T>, ends_groups<Count>> ends_of(const std::array<Cascade, Count>& cascades) {
    std::array<glm::vec<3, T>, ends_groups<Count>> ends;
    ends.fill(glm::vec<3, T>(highest<T>));
    for (std::size_t i = 0; i + 1 < Count; ++i) ends[i / 3][static_cast<glm::length_t>(i % 3)] = cascades[i].end;
    return ends;
}

/// Columns of scales and offsets for up to four cascades. Columns without a cascade contain no point.
template <real T>
void set_columns(std::span<const cascade<T>> cascades, T fade, glm::mat<4, 4, T>& scales, glm::mat<4, 4, T>& offsets) {
    scales = glm::mat<4, 4, T>(T(0));
    for (glm::length_t i = 0; i < 4; ++i) offsets[i] = {T(65536), T(65536), T(0), T(0)};
    for (std::size_t k = 0; k < cascades.size() && k < 4; ++k) {
        const cascade<T>& c = cascades[k];
        const auto i = static_cast<glm::length_t>(k);
        const glm::vec<2, T> fades = fade_of(c.begin, c.end, fade);
        scales[i] = glm::vec<4, T>(glm::vec<3, T>(c.scale), fades.x);
        offsets[i] = glm::vec<4, T>(glm::vec<3, T>(c.offset), fades.y);
    }
}

}  // namespace detail

/// Uniforms of up to four cascades, for cascade_column and cascade_by_projection. Warped cascades: see warped.hpp.
/// @param cascades   from make_stable_cascades or make_tight_cascades
/// @param fade       fraction of each cascade over which it fades into the next one, 0 to 1. The last one fades to lit.
///                   cascade_fit::overlap must be at least as large
/// @return           uniforms. With fewer than four cascades, no point falls into a missing one by depth or projection
/// @throws std::invalid_argument  fade out of range, or too small for finite uniforms
template <real T, std::size_t Count>
requires(Count >= 1 && Count <= 4)
    [[nodiscard]] cascade_uniforms<T> make_cascade_uniforms(const std::array<cascade<T>, Count>& cascades, T fade) {
    detail::require_fade(fade);
    cascade_uniforms<T> u;
    u.rotation = cascades[0].light.view;
    u.ends = detail::ends_of<T>(cascades)[0];
    detail::set_columns<T>(cascades, fade, u.scales, u.offsets);
    return u;
}

/// Uniforms of a shader with five or more cascades, in groups of four: cascade_column_8, cascade_by_projection_8.
template <real T, std::size_t Count>
struct grouped_cascade_uniforms {
    glm::mat<4, 4, T> rotation{T(1)};                                ///< as in cascade_uniforms
    std::array<glm::mat<4, 4, T>, (Count + 3) / 4> scales, offsets;  ///< a matrix per four cascades
    /// Ends of all cascades but the last, in groups of three. The sum of cascade_by_depth over them is the cascade.
    std::array<glm::vec<3, T>, detail::ends_groups<Count>> ends;
};

/// Uniforms of five or more cascades. Parameters and errors are those of the version for up to four.
template <real T, std::size_t Count>
requires(Count > 4) [[nodiscard]] grouped_cascade_uniforms<T, Count> make_cascade_uniforms(
    const std::array<cascade<T>, Count>& cascades, T fade) {
    detail::require_fade(fade);
    grouped_cascade_uniforms<T, Count> u;
    u.rotation = cascades[0].light.view;
    u.ends = detail::ends_of<T>(cascades);
    for (std::size_t i = 0; i < u.scales.size(); ++i)
        detail::set_columns<T>(std::span(cascades).subspan(4 * i), fade, u.scales[i], u.offsets[i]);
    return u;
}

}  // namespace umbrage
