// SPDX-License-Identifier: MIT
//
// The four systems that the library descends from, as values: what their light is, how a depth is stored, how it is
// compared, filtered and shaded. Nothing here draws; the CPU programs and the viewer both read these.
//
//     example::shadow_system system = example::radeon_8500;
//     example::scene scene = example::make_scene(system);
//     example::light light = example::make_light(system, scene);
//     glm::vec3 point = example::lifted(system, light, position, face_normal);  // what to look up
//
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string_view>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <umbrage/bias/light_units.hpp>
#include <umbrage/bias/normal_offset.hpp>
#include <umbrage/depth/conversions.hpp>
#include <umbrage/filter/pcf/four_tap.hpp>
#include <umbrage/filter/pcf/hard.hpp>
#include <umbrage/filter/pcf/pcf_2x2.hpp>
#include <umbrage/light/light_space.hpp>
#include <umbrage/light/lighting.hpp>

#include "biases.hpp"
#include "camera.hpp"
#include "scene.hpp"

namespace example {

enum class light_kind {
    spot,      ///< perspective
    fitted,    ///< orthographic, a tight box around the scene
    exercise,  ///< orthographic, map size / 10 wide, 10 world units from the origin
};
enum class depth_kind {
    projected,  ///< z/w as the rasterizer has it
    linear,     ///< distance along the light's axis over z_far
};
enum class receiver_kind {
    plain,    ///< compared as it is with decode()
    scaled,   ///< receiver_ps14, with decode_ps14: the map's side alone went through the look-up texture
    encoded,  ///< through the look-up texture as well, both sides by decode_ps14
};
enum class test_kind {
    less_equal,  ///< receiver - bias <= stored
    exercise,    ///< compare_exercise, of a single texel: lit when receiver < stored + bias
};
enum class shading_kind {
    diffuse_ambient,  ///< shadow takes the diffuse light away
    darken,           ///< shadow multiplies the lit picture by `ambient`, and so does turning away from the light
};

struct shadow_system {
    std::string_view name;   ///< name of its program
    std::string_view title;  ///< for people

    light_kind light = light_kind::spot;
    float distance = 10;     ///< of a spot from what it looks at, world units
    float outer_angle = 36;  ///< of a spot, degrees between axis and edge of the cone; 36 holds the whole floor
    float azimuth = 60,
          elevation = 40;  ///< of the light, degrees; 0: towards the camera, 90: its right, straight above
    glm::ivec2 map_size{1024};
    float texels_per_unit = 10, offset = 10, z_near = 0.1f, z_far = 40;  ///< of an exercise's light

    depth_kind depth = depth_kind::linear;
    std::string_view encoding = "depth32f";  ///< one of umbrage::encodings
    receiver_kind receiver = receiver_kind::plain;

    std::string_view filter = "hard";  ///< one of umbrage::filters; pcf_2x2_dx_sdk adds epsilon on the map's side
    test_kind test = test_kind::less_equal;
    std::optional<float> radius{};            ///< of a box or a disc, texels; without one as it is by itself
    float light_size = 0.4f, max_radius = 8;  ///< diameter, and texels: what contact hardening makes penumbras of
    float epsilon = 0x1p-18f;                 ///< constant bias, in the map's depth from 0 to 1: see depth_kind
    std::string_view bias = "normal_offset";  ///< one of example::biases; the originals had none
    float reach = covered(umbrage::filters::hard{}.reach());  ///< texels that it covers

    shading_kind shading = shading_kind::diffuse_ambient;
    glm::vec3 ambient{0.22f};  ///< share of the light that reaches shadows
    bool textured = false;     ///< multiply by texture()
    float glass = 0;           ///< alpha of a pane, which takes shadows and casts none; 0: there is none
    float scene_scale = 1;
};

/// ATI SDK, pixel shader 1.4: 11 bits in two channels, four taps with a matrix each.
inline const shadow_system radeon_8500{
    .name = "radeon_8500",
    .title = "Radeon 8500 ShadowMap",
    .light = light_kind::spot,
    .encoding = "rg11",
    .receiver = receiver_kind::scaled,
    .filter = "four_tap",
    .epsilon = 1.5f / 2048,  // the look-up rounds down by up to one code
    .reach = covered(umbrage::filters::four_tap{}.reach()),
};

/// Microsoft DirectX SDK, ShadowMap: a spot light, z/w in a float map, 2x2 percentage-closer filtering.
inline constexpr shadow_system dx_sdk{
    .name = "dx_sdk",
    .title = "DirectX SDK ShadowMap",
    .light = light_kind::spot,
    .distance = 8,
    .outer_angle = 24,
    .map_size = glm::ivec2(512),
    .depth = depth_kind::projected,
    .filter = "pcf_2x2_dx_sdk",
    .epsilon = 0.00005f,
    .reach = covered(umbrage::filters::pcf_2x2_dx_sdk{}.reach()),
    .ambient = glm::vec3(0.20f, 0.22f, 0.30f),
    .textured = true,
    .glass = 0.45f,
};

/// The directional-light exercise: linear depth over the far plane, 10 texels per world unit, one comparison. Its map
/// has the shape of the screen.
inline constexpr shadow_system exercise{
    .name = "exercise",
    .title = "Directional-light exercise",
    .light = light_kind::exercise,
    .map_size = glm::ivec2(480, 320),  // more makes the map wider, not finer
    .filter = "hard",
    .test = test_kind::exercise,
    .epsilon = 0.0005f,
    .scene_scale = 2.5f,
};

/// Self-shadowing under pixel shader 1.x: both sides through the look-up texture, one comparison, darken.
inline constexpr shadow_system self_shadowing{
    .name = "self_shadowing",
    .title = "Self-shadowing under pixel shader 1.x",
    .light = light_kind::fitted,
    .depth = depth_kind::projected,  // an orthographic light's z/w is linear
    .encoding = "rg11",
    .receiver = receiver_kind::encoded,
    .filter = "hard",
    .epsilon = 0.5f / 2048,  // both sides round down alike
    .shading = shading_kind::darken,
    .ambient = glm::vec3(0.4f),
};

inline const std::array systems{radeon_8500, dx_sdk, exercise, self_shadowing};

inline constexpr glm::vec3 sky{0.30f, 0.36f, 0.44f};  ///< where the camera sees nothing; lit in visibility masks

/// The system's scene: a few solids, or a mesh on a floor.
[[nodiscard]] scene make_scene(const shadow_system& s, const std::filesystem::path& mesh_file = {},
                               up_axis up = up_axis::y);

/// First position of the camera.
[[nodiscard]] inline camera_setup make_camera_setup(const shadow_system& s, const scene& scene, float aspect) {
    return {.target = scene.target, .azimuth = 0, .elevation = 30, .distance = 7.5f * s.scene_scale, .aspect = aspect};
}

/// A light in the numbers that each stage asks for.
struct light {
    bool spot = true;
    glm::vec3 position{0}, direction{0, -1, 0};  ///< of length one; a directional light has no position
    float cos_outer = 0, z_near = 0, z_far = 1;
    glm::vec2 units{1};  ///< umbrage::make_light_units of the map
    umbrage::light_space<float> space{};

    [[nodiscard]] glm::mat4 world_to_clip() const { return space.projection * space.view; }
    [[nodiscard]] glm::vec3 to_light(glm::vec3 p) const { return spot ? glm::normalize(position - p) : -direction; }

    /// 1 within reach of the light.
    [[nodiscard]] float cone(glm::vec3 p) const {
        return spot ? umbrage::spot_cone(direction, p - position, cos_outer) : 1.0f;
    }

    /// Distance along the axis of a spot: w of its shadow coordinates.
    [[nodiscard]] float w(glm::vec3 p) const { return spot ? glm::dot(p - position, direction) : 1.0f; }

    /// Longer edge of a texel's footprint at a point, across the light, in world units.
    [[nodiscard]] float texel_world(glm::vec3 p) const { return umbrage::texels_to_world(1.0f, units, w(p)); }

    /// The system's kind of depth from the depth pass's z/w in [0, 1].
    [[nodiscard]] float depth(const shadow_system& s, float z) const {
        if (s.depth == depth_kind::projected) return z;
        return umbrage::linear_depth(spot ? umbrage::view_z_from_depth(z, z_near, z_far)
                                          : umbrage::view_z_from_orthographic_depth(z, z_near, z_far),
                                     1 / z_far);
    }
};

[[nodiscard]] light make_light(const shadow_system& s, const scene& scene, umbrage::clip_space clip = picture_clip);

/// The pane of systems that have one: upright where the shadow of the solids falls, with two sides.
[[nodiscard]] scene make_pane(const shadow_system& s);

/// The point to look up instead of the surface itself, by a normal offset. With a reach of 0 a system has epsilon
/// alone, as the originals had.
/// @param normal  of the flat triangle, which is what the map holds; of length one, on the camera's side
[[nodiscard]] inline glm::vec3 lifted(const shadow_system& s, const light& l, glm::vec3 position, glm::vec3 normal) {
    const glm::vec3 way = l.spot ? (position - l.position) / l.w(position) : l.direction;
    return position + umbrage::normal_offset(normal, l.direction, way,
                                             umbrage::offset_width(s.reach, l.texel_world(position)), 0.0f);
}

/// Size of a map's picture in the corner of another: three tenths as high, of the map's own shape.
[[nodiscard]] inline glm::ivec2 overlay_size(glm::ivec2 map, int picture_height) {
    const int height = std::max(1, picture_height * 3 / 10);
    return {std::max(1, height * map.x / map.y), height};
}

/// Procedural texture of `textured` systems, a chequered solid that things are cut from: a factor for the color.
[[nodiscard]] inline float texture(glm::vec3 position) {
    const glm::vec3 cell = glm::floor(position * 4.0f + 0.37f);
    return std::fmod(std::abs(cell.x + cell.y + cell.z), 2.0f) == 0 ? 1.0f : 0.6f;
}

/// Color of a surface, as the camera sees it.
/// @param normal, to_light  vectors of length 1
[[nodiscard]] inline glm::vec3 shade(const shadow_system& s, glm::vec3 color, glm::vec3 normal, glm::vec3 to_light,
                                     float visibility) {
    const float n_dot_l = glm::dot(normal, to_light);
    if (s.shading == shading_kind::diffuse_ambient)
        return umbrage::diffuse_ambient(color, s.ambient, n_dot_l, visibility);
    const float facing =
        glm::clamp(4 * n_dot_l, 0.0f, 1.0f);  // ps.1.x: mul_x4_sat; hides the map's teeth where light grazes
    return umbrage::diffuse_ambient(color, s.ambient, n_dot_l, 1.0f) *
           (s.ambient + (1.0f - s.ambient) * facing * visibility);
}

}  // namespace example
