// SPDX-License-Identifier: MIT
//
// The viewer's pictures, where it was built and finds an OpenGL.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include <glm/gtc/type_precision.hpp>

#include <umbrage/core/image.hpp>

namespace gallery {

struct opengl_pictures {
    std::filesystem::path picture{}, mask{};   ///< PNG files
    umbrage::image<glm::u8vec3> visibility{};  ///< the mask's pixels
    std::string frame{};                       ///< what the viewer says of its time
};

/// Runs the viewer without a window; nothing when it cannot.
[[nodiscard]] std::optional<opengl_pictures> run_viewer(const std::filesystem::path& viewer, std::string_view system,
                                                        glm::ivec2 size, const std::filesystem::path& folder);

}  // namespace gallery
