// SPDX-License-Identifier: MIT
//
// What a draw is of: setup, filter, encoding, conventions, size, scale, place and scene, each drawn by itself.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <iterator>
#include <string>
#include <string_view>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/core/clip_space.hpp>

#include "dice.hpp"

namespace joints {

enum class setup_kind {
    spot,
    fitted_spot,
    warped_lamp,  ///< by a camera's perspective, or by a plane that it sees
    sun_with_casters,
    sun_alone,  ///< no casters given: those before the near plane are clamped
    sun_by_hand,
    snapped_sun,
    light_space_perspective,
    trapezoidal,
    perspective,
    plane_optimal,
    stable_cascades,
    eight_cascades,
    tight_cascades,
    warped_cascades,
    pages,
    cube,
    tetrahedron,
    paraboloids,
};
inline constexpr std::array<std::string_view, 19> setup_names{
    "spot",           "fitted spot",      "warped lamp",     "sun with casters",
    "sun alone",      "sun by hand",      "snapped sun",     "LiSPSM",
    "trapezoidal",    "perspective warp", "plane-optimal",   "stable cascades",
    "eight cascades", "tight cascades",   "warped cascades", "pages",
    "cube",           "tetrahedron",      "paraboloids"};

inline constexpr std::array<std::string_view, 7> filter_names{"hard", "pcf_2x2", "box", "window",
                                                              "disc", "pcss",    "dpcf"};
/// The fourth is each filter's own (host_of_filter.hpp): compiling all with all takes minutes.
inline constexpr std::array<std::string_view, 4> encoding_names{"depth32f", "depth16", "rg<11>", "another"};

inline constexpr std::array<std::string_view, 7> own_encoding_names{
    "float_bits", "r16", "rgb24", "depth24", "rgb10", "threejs_rgba", "threejs_rgb"};

enum class scene_kind { room, outdoors, huge_ground };
inline constexpr std::array<std::string_view, 3> scene_names{"room", "outdoors", "huge ground"};

/// A filter by its number, and the number that it takes: a radius, or which kernel.
struct filter_choice {
    int number = 0, points = 16;
    double radius = 0;
    double light_size = 0;   ///< of a filter that hardens contacts: the light's in the world, or a tangent
    double most_radius = 0;  ///< of its penumbras, texels

    [[nodiscard]] double least_radius() const { return 0.5 + radius; }
    [[nodiscard]] bool is_pcss() const { return number == 5; }
    [[nodiscard]] bool is_dpcf() const { return number == 6; }
    [[nodiscard]] bool hardens() const { return is_pcss() || is_dpcf(); }
};

struct choices {
    std::uint64_t seed;
    setup_kind setup;
    filter_choice filter;
    int encoding;
    umbrage::clip_space clip;
    bool in_double;    ///< light made in double
    glm::ivec2 size;   ///< of one map, texels; pages and point lights take x
    double scale;      ///< world units a unit of the scene, which has some 10
    double away;       ///< distance from the origin, in sizes of the scene
    bool with_origin;  ///< the shadow is told an origin near the scene
    scene_kind scene;
    bool facing;    ///< the light's axis is the normal of a wall, or of the ground: nothing but rounding is a slope
    bool rotated;   ///< the scene, with its lights
    bool mirrored;  ///< half of the boxes are drawn as instances that mirror their mesh
    int cascades;
    glm::ivec2 image;  ///< of receivers

    [[nodiscard]] std::string_view setup_name() const { return setup_names[std::size_t(setup)]; }
    [[nodiscard]] bool is_point() const { return setup >= setup_kind::cube; }
    [[nodiscard]] bool is_spot() const { return setup <= setup_kind::warped_lamp; }
    [[nodiscard]] std::string_view encoding_name() const {
        return encoding == 3 ? own_encoding_names[std::size_t(filter.number)] : encoding_names[std::size_t(encoding)];
    }
    /// True for setups whose casters are clamped to the near plane.
    [[nodiscard]] bool is_sun() const { return !is_point() && !is_spot(); }
    /// True for setups that hold what a camera sees.
    [[nodiscard]] bool has_camera() const {
        return setup == setup_kind::warped_lamp ||
               (setup >= setup_kind::light_space_perspective && setup <= setup_kind::warped_cascades);
    }
    [[nodiscard]] bool is_warped() const {
        return setup == setup_kind::warped_lamp || setup == setup_kind::warped_cascades ||
               (setup >= setup_kind::light_space_perspective && setup <= setup_kind::plane_optimal);
    }
    /// True for warps in which the ground is as the camera sees it.
    [[nodiscard]] bool warps_for_ground() const {
        return setup == setup_kind::plane_optimal || (setup == setup_kind::warped_lamp && cascades % 2 == 0);
    }
    [[nodiscard]] bool is_reversed() const { return clip.direction == umbrage::depth_direction::reversed; }
};

[[nodiscard]] inline umbrage::clip_space draw_clip_space(dice& d) {
    using namespace umbrage;
    if (d.one_in(2)) return clip_spaces[std::size_t(d.whole(0, int(std::size(clip_spaces)) - 1))].value;
    return {.hand = d.one_in(2) ? handedness::left : handedness::right,
            .range = d.one_in(2) ? depth_range::minus_one_to_one : depth_range::zero_to_one,
            .direction = d.one_in(2) ? depth_direction::reversed : depth_direction::forward,
            .origin = d.one_in(2) ? texture_origin::top : texture_origin::bottom,
            .subpixel_bits = d.one_in(4) ? 4 : 8};
}

[[nodiscard]] inline choices draw_choices(std::uint64_t seed) {
    dice d(seed);
    choices c{};
    c.seed = seed;
    c.setup = setup_kind(d.whole(0, int(setup_names.size()) - 1));
    c.filter = {d.whole(0, int(filter_names.size()) - 1), 8 << d.whole(0, 2), d.real(0, 1)};
    if (c.setup == setup_kind::paraboloids && c.filter.hardens()) c.filter.number = 4;  // which does not compile
    // Contact hardening refuses casters that are clamped to the near plane, which a fit has that knows no casters.
    if (c.setup == setup_kind::sun_alone && c.filter.hardens()) c.setup = setup_kind::sun_with_casters;
    c.encoding = d.whole(0, int(encoding_names.size()) - 1);
    c.clip = draw_clip_space(d);
    c.in_double = d.one_in(2);
    const double largest = d.one_in(20) ? 1500 : 500;
    c.size = {int(d.spread(32, largest)), int(d.spread(32, largest))};
    if (d.one_in(3)) c.size.y = c.size.x;
    c.scale = d.one_in(4) ? 1 : d.spread(1e-6, 1e6);
    c.filter.light_size = d.spread(0.003, 0.3) * (c.is_sun() ? 0.3 : c.scale);
    c.with_origin = d.one_in(3);
    c.away = d.one_in(5)     ? 0
             : c.with_origin ? d.spread(1, 1e7)
             : d.one_in(25)  ? d.spread(1e3, 5e3)
                             : d.spread(0.1, 1e3);
    if (c.with_origin) c.in_double = true;
    const bool is_outdoors = c.is_sun() || c.setup == setup_kind::warped_lamp || d.one_in(3);
    c.scene = scene_kind(is_outdoors ? d.whole(1, 2) : 0);
    c.facing = d.one_in(3);
    c.rotated = !d.one_in(4);
    c.mirrored = d.one_in(2);
    c.cascades = d.whole(1, 4);
    c.image.x = d.whole(5, 90);
    c.image.y = (360 + c.image.x - 1) / c.image.x;
    // At most a quarter of the map, as the reach is a margin on each side.
    c.filter.most_radius = d.real(1.5, std::clamp(0.2 * std::min(c.size.x, c.size.y), 7.5, 24.0));
    return c;
}

/// All choices of a draw in one line.
[[nodiscard]] inline std::string described(const choices& c) {
    const auto number = [](double v) {
        char text[32];
        std::snprintf(text, sizeof text, "%.6g", v);
        return std::string(text);
    };
    using namespace umbrage;
    return "--seed " + std::to_string(c.seed) + ": " + std::string(c.setup_name()) + ", " +
           std::string(filter_names[std::size_t(c.filter.number)]) + " (" + number(c.filter.radius) + ", " +
           std::to_string(c.filter.points) + (c.filter.hardens() ? ", " + number(c.filter.most_radius) : "") + "), " +
           std::string(c.encoding_name()) + ", " + (c.is_reversed() ? "reversed" : "forward") +
           (c.clip.range == depth_range::zero_to_one ? " [0, 1]" : " [-1, 1]") +
           (c.clip.hand == handedness::left ? " left" : " right") +
           (c.clip.origin == texture_origin::top ? " top " : " bottom ") + std::to_string(c.clip.subpixel_bits) +
           " bits, " + (c.in_double ? "double" : "float") + ", map " + std::to_string(c.size.x) + " x " +
           std::to_string(c.size.y) + ", scale " + number(c.scale) + ", " + number(c.away) + " sizes away" +
           (c.with_origin ? " with an origin" : "") + ", " + std::string(scene_names[std::size_t(c.scene)]) +
           (c.facing ? " facing" : "") + (c.rotated ? " rotated" : "") + (c.mirrored ? " mirrored" : "") + ", " +
           std::to_string(c.cascades) + " cascades, image " + std::to_string(c.image.x) + " x " +
           std::to_string(c.image.y);
}

}  // namespace joints
