// SPDX-License-Identifier: MIT
//
// From a scene to a shadowed picture, in memory.
//
//     const umbrage::image<glm::u8vec3> picture = photograph(options, scene);
//
#pragma once

#include <glm/gtc/type_precision.hpp>

#include <umbrage/core/image.hpp>

#include <progress.hpp>
#include <scene.hpp>
#include <shadow_map.hpp>

#include "options.hpp"
#include "view.hpp"

namespace shadow_render {

/// Light and camera, and what the camera sees.
[[nodiscard]] view make_view(const options& o, const example::scene& scene, example::progress& progress);

/// Depth pass, encode, decode: the map of a view's light.
[[nodiscard]] example::shadow_map draw_map(const options& o, const view& v, example::progress& progress);

/// Fetch, compare, filter: visibility of each sample in it.
[[nodiscard]] umbrage::image<float> look_up_map(const options& o, const view& v, const example::shadow_map& map,
                                                example::progress& progress);

/// Visibility of each sample under any kind of light.
/// @param camera   that cascades are made for: the view's, or another
[[nodiscard]] umbrage::image<float> visibility_of(const options& o, view& v, const example::camera& camera,
                                                  example::progress& progress);

/// The whole way, in silence.
[[nodiscard]] umbrage::image<glm::u8vec3> photograph(const options& o, const example::scene& scene);

}  // namespace shadow_render
