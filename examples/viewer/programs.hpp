// SPDX-License-Identifier: MIT
//
// Shaders, put together from the library's snippets: the whole of a shadow mapping system is chosen here.
//
//     viewer::stages s = viewer::camera_stages(example::dx_sdk, umbrage::glsl::version::v330, false);
//
#pragma once

#include <string>

#include <umbrage/shader/glsl.hpp>

#include <systems.hpp>

namespace viewer {

/// Text of the two shaders of a program.
struct stages {
    std::string vertex, fragment;
    friend bool operator==(const stages&, const stages&) = default;
};

/// From the light: depth, encoded, into the map.
[[nodiscard]] stages depth_stages(const example::shadow_system& s, umbrage::glsl::version v);

/// Over the whole of another map: the texels of one that is filtered ahead, of the depths in `map`.
[[nodiscard]] stages moments_stages(const example::shadow_system& s, umbrage::glsl::version v);

/// The same texels, blurred `along` (1, 0) or (0, 1).
/// @param taps   3, 5 or 7
[[nodiscard]] stages blur_stages(umbrage::glsl::version v, int taps);

/// From the camera: fetch, decode, compare, filter, shade.
/// @param mask   visibility alone
[[nodiscard]] stages camera_stages(const example::shadow_system& s, umbrage::glsl::version v, bool mask);

/// The map over a rectangle of the picture, `low` to `high` of it stretched to black and white.
/// @param layers   of depths as they are: a square of maps
[[nodiscard]] stages overlay_stages(const example::shadow_system& s, umbrage::glsl::version v, bool layers);

/// The map's depth as three bytes, to be read back on any OpenGL.
[[nodiscard]] stages read_back_stages(const example::shadow_system& s, umbrage::glsl::version v, bool layers);

/// Triangles of one color, in pixels.
[[nodiscard]] stages text_stages(umbrage::glsl::version v);

}  // namespace viewer
