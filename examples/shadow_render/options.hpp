// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include <glm/vec3.hpp>

#include <umbrage/depth/quantize.hpp>

#include <names.hpp>

namespace shadow_render {

enum class light_kind { spot, directional, cascades };
enum class built_in { garden, solids, outdoor, plain };

/// Damage done on purpose, to show what it looks like.
struct damage {
    bool tight = false;     ///< cascades follow the camera by less than a texel, and turn with it
    bool no_fade = false;   ///< from one cascade to the next
    bool no_error = false;  ///< of the encoding is in the bias
};

/// Angles are in degrees. Azimuth 0 is towards the default camera, 90 to its right; elevation 90 is straight above.
struct options {
    std::string mesh{};  ///< empty: a built-in scene
    built_in scene = built_in::garden;
    std::filesystem::path output = "out";

    light_kind light = light_kind::directional;
    float azimuth = -50, elevation = 30, distance = 8;
    float cone = 60;          ///< the spot's full angle
    float light_size = 0.4f;  ///< diameter: what contact hardening knows of it, and rays that filters are compared with

    int map_size = 2048;    ///< of cascades: of the atlas of four
    bool draw_all = false;  ///< instances beside a cascade's map too
    std::string encoding = "rg16";
    float edge = umbrage::upper_edge<float>;  ///< of a code's interval, that decoding answers

    std::string filter = "pcss32";
    float radius = 2;                   ///< of a box, a disc or a map's blur
    float max_radius = 15;              ///< penumbra's radius that contact hardening makes, texels
    std::optional<std::string> bias{};  ///< without one the filter's usual bias
    std::optional<float> reach{};       ///< texels that the bias covers; without one what the filter needs

    int width = 960, height = 640, samples = 2;
    float camera_azimuth = 0, camera_elevation = 20, camera_distance = 7.5f, fov = 34;

    std::optional<glm::vec3> target{};  ///< of the camera; without one the scene's

    bool marks_changes = false;  ///< of visibility, against a camera a step aside
    bool fixed_range = false;    ///< of cascades: all that the camera could see, whatever it does
    damage broken{};

    bool quiet = false;
};

/// The bias of the options, by its name.
[[nodiscard]] inline std::string_view bias_of(const options& o) {
    return o.bias ? std::string_view(*o.bias) : example::usual_bias(o.filter);
}

/// What the scene is called.
[[nodiscard]] inline std::string title_of(const options& o) {
    if (o.scene == built_in::outdoor) return "Outdoor scene";
    if (o.scene == built_in::plain) return "Plain";
    if (o.scene == built_in::solids) return "Solids";
    return o.mesh.empty() ? "Garden" : std::filesystem::path(o.mesh).filename().string();
}

/// Reads the command line; nothing when only help was asked for.
/// @throws example::usage_error  impossible options, in one line
[[nodiscard]] std::optional<options> parse_options(int argc, const char* const* argv);

}  // namespace shadow_render
