// SPDX-License-Identifier: MIT
//
// The built-in scenes by name, each with the light, the camera and the filter that show it well.
//
//     options o = usual(built_in::outdoor);
//     const example::scene scene = scene_of(o);
//
#pragma once

#include <CLI/CLI.hpp>

#include <scene.hpp>

#include "options.hpp"

namespace shadow_render {

/// Options that show a scene well.
[[nodiscard]] options usual(built_in scene);

/// --scene: sets the scene's usual options, whatever else the command line then changes of them.
CLI::Option* add_scene(CLI::App& app, options& o);

[[nodiscard]] example::scene scene_of(const options& o);

/// @throws example::usage_error  too many pixels
void require_drawable(const options& o);

/// Makes the folder for the pictures, if need be.
/// @throws std::runtime_error  it cannot be made
void make_output(const options& o);

}  // namespace shadow_render
