// SPDX-License-Identifier: MIT
//
// A long ground that a camera sees from two units above it, which setups of lights are measured over.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include <common/quality.hpp>

#include <umbrage/core/image.hpp>
#include <umbrage/light/bounds.hpp>
#include <umbrage/light/cascades/select.hpp>
#include <umbrage/light/pixels_per_texel.hpp>
#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/light/warp/warp_fit.hpp>

namespace reference_view {

using namespace umbrage;

inline const glm::ivec2 screen(1280, 720);
inline const glm::ivec2 map_size(2048, 2048);

/// A camera's matrices over pixels, and the frustum that it sees.
struct view {
    frustum<double> seen;
    glm::dmat4 to_pixels, from_pixels;

    explicit view(const frustum<double>& f) : seen(f) {
        to_pixels = texture_matrix<double>(
            {look_along(f.position, f.direction, f.up, handedness::right),
             perspective(f.tan_half_x, f.tan_half_y, f.z_near, f.z_far, cpu_clip_space), cpu_clip_space},
            screen);
        from_pixels = glm::inverse(to_pixels);
    }
};

inline const double tan_half_y = std::tan(std::numbers::pi / 6);
inline const view reference({.position = {0, 2, 0},
                             .direction = {0, 0, -1},
                             .tan_half_x = tan_half_y * 1280 / 720,
                             .tan_half_y = tan_half_y,
                             .z_near = 0.5,
                             .z_far = 1000});
inline const bounding_box<double> reference_scene{{-600, 0, -1000}, {600, 10, 200}};

/// The way of light from a sun ahead of the camera for azimuth 0, behind it for 180.
inline glm::dvec3 sun(double elevation, double azimuth) {
    const double e = elevation * std::numbers::pi / 180, a = azimuth * std::numbers::pi / 180;
    return {-std::sin(a) * std::cos(e), -std::sin(e), std::cos(a) * std::cos(e)};
}

/// Elevations and azimuths that setups are known for.
inline constexpr std::array<std::array<double, 2>, 8> suns{
    {{90, 0}, {45, 90}, {20, 90}, {45, 180}, {45, 0}, {45, 135}, {15, 180}, {15, 0}}};

/// Input of the warps, without a margin.
inline warp_fit<double> warp_under(std::array<double, 2> s) {
    return {.camera = reference.seen,
            .direction = sun(s[0], s[1]),
            .receivers = intersection(reference.seen, reference_scene),
            .casters = reference_scene,
            .margin = 0,
            .clip = cpu_clip_space};
}

/// Point of the ground that a camera sees through a pixel, up to its far plane.
inline std::optional<glm::dvec3> ground_at(const view& v, glm::dvec2 pixel) {
    const glm::dvec4 h = v.from_pixels * glm::dvec4(pixel, 0.5, 1);
    const glm::dvec3 way = glm::dvec3(h) / h.w - v.seen.position;
    const double share = -v.seen.position.y / way.y;
    if (!(share > 0) || share * glm::dot(way, glm::normalize(v.seen.direction)) > v.seen.z_far) return std::nullopt;
    return v.seen.position + share * way;
}

inline constexpr int ground_step = 4;  ///< from pixel to pixel

/// Points of the ground that the reference sees, computed once for all setups.
inline const image<std::optional<glm::dvec3>>& reference_ground() {
    static const image<std::optional<glm::dvec3>> points = [] {
        image<std::optional<glm::dvec3>> all(screen / ground_step);
        for (glm::ivec2 i(0); i.y < all.size().y; ++i.y)
            for (i.x = 0; i.x < all.size().x; ++i.x) all[i] = ground_at(reference, glm::dvec2(i * ground_step) + 0.5);
        return all;
    }();
    return points;
}

/// @param to_texels   the map's, or the cascades', which meet at ends
inline example::quality_report on_ground(const std::vector<glm::dmat4>& to_texels, glm::ivec2 size = map_size,
                                         glm::dvec3 ends = {}) {
    const example::measured_view view{
        .screen = screen, .map_size = size, .maps = int(to_texels.size()), .step = ground_step};
    return example::measure_quality(view, [&, &points = reference_ground()](glm::ivec2 i) {
        const std::optional<glm::dvec3>& p = points[i / ground_step];
        if (!p) return glm::dmat2(0);
        const double number = to_texels.size() > 1 ? cascade_by_depth(-p->z, ends) : 0;
        return pixels_per_texel(to_texels[std::size_t(number)], reference.to_pixels, *p, glm::dvec3(0, 1, 0));
    });
}

}  // namespace reference_view
