// SPDX-License-Identifier: MIT
//
// --light cascades: a directional light with a map for each of four parts of what the camera sees, all in one atlas.
// Besides the pictures of one map cascades.png, in which each cascade has a color.
#pragma once

#include <array>
#include <cstddef>

#include <glm/gtc/type_precision.hpp>

#include <umbrage/core/image.hpp>
#include <umbrage/light/cascades/cascades.hpp>

#include <camera.hpp>
#include <progress.hpp>
#include <scene.hpp>
#include <shadow_map.hpp>

#include "options.hpp"
#include "view.hpp"

namespace shadow_render {

inline constexpr std::size_t cascade_count = 4;
using cascade_array = std::array<umbrage::cascade<float>, cascade_count>;

/// Work of a cascade's depth pass.
struct drawn {
    std::size_t instances = 0, triangles = 0;
    double ms = 0;  ///< of the processor's time: other programs do not count
};

/// A view under cascades.
struct cascaded {
    cascade_array all;
    umbrage::cascade_uniforms<float> uniforms{};
    std::array<shadow_render::drawn, cascade_count> drawn{};
    example::shadow_map map{};                       ///< the atlas
    umbrage::image<float> distance{}, visibility{};  ///< of each sample
};

/// Draws and looks up cascades.
/// @param v        its lamp becomes the last cascade's
/// @param camera   that cascades are made for: the view's, or another
[[nodiscard]] cascaded look_up_cascades(const options& o, view& v, const example::camera& camera,
                                        example::progress& progress);

/// The depth pass of a map, of the instances that it sees.
/// @param all   of those beside it too
drawn draw_instances(umbrage::image_view<float> map, const example::scene& scene, const glm::mat4& world_to_clip,
                     bool all);

/// Color of a cascade, sRGB.
/// @param weight   weight of the next one's, or of white after the last
[[nodiscard]] glm::vec3 tint_of(std::size_t cascade, float weight = 0);

/// The picture in the cascades' colors, white beyond.
[[nodiscard]] umbrage::image<glm::u8vec3> tinted(umbrage::image<glm::u8vec3> shaded, const cascaded& by, const view& v,
                                                 int samples);

/// @throws std::runtime_error  a file cannot be written
void render_cascades(const options& o, const example::scene& scene);

}  // namespace shadow_render
