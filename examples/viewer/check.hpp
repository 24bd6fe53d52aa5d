// SPDX-License-Identifier: MIT
//
// Runs the viewer, and looks at its pictures.
#pragma once

#include <doctest/doctest.h>

#include <filesystem>
#include <string>

#include <glm/gtc/type_precision.hpp>

#include <umbrage/core/image.hpp>

#include <shell.hpp>

namespace viewer_check {

using picture = umbrage::image<glm::u8vec3>;

inline const std::filesystem::path folder = std::filesystem::current_path();  // each test's own: they run side by side

using example::quoted;

/// Picture that the viewer draws.
[[nodiscard]] picture viewed(const std::string& arguments, const std::string& in = {});

[[nodiscard]] int differing(const picture& a, const picture& b);
/// Greatest difference of a channel.
[[nodiscard]] int differing_by_levels(const picture& a, const picture& b);

}  // namespace viewer_check
