// SPDX-License-Identifier: MIT
//
// Runs shadow_render as a newcomer would.
#pragma once

#include <doctest/doctest.h>

#include <filesystem>
#include <string>

#include <glm/gtc/type_precision.hpp>

#include <umbrage/core/image.hpp>

#include <scene.hpp>
#include <shell.hpp>

#include "options.hpp"

namespace shadow_render_check {

inline const std::filesystem::path folder = std::filesystem::path(WORK_DIR) / "check";
inline const std::string small = "--size 240x160 --map-size 256 --filter pcf_2x2 ";
inline const std::string spot = "--light spot --azimuth 60 --elevation 40 ";
inline const std::string solids = small + "--scene solids ";

using example::quoted;

[[nodiscard]] example::finished run(const std::string& arguments);

/// A failure that a person can read: the right code, and one line that says `why`.
void fails(const std::string& arguments, int code, const std::string& why);

/// Visibility of each sample, drawn here: of options that the command line has not.
[[nodiscard]] umbrage::image<float> visibility(const shadow_render::options& o, const example::scene& scene);

[[nodiscard]] std::string output(const std::string& name);
[[nodiscard]] umbrage::image<glm::u8vec4> picture(const std::string& name, const char* file);
[[nodiscard]] std::string file(const std::string& name, const std::string& content);

}  // namespace shadow_render_check
