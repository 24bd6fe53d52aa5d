// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include <scene.hpp>

namespace viewer {

/// Angles are in degrees. What is not given is as the system has it.
struct options {
    std::string system = "radeon_8500";
    std::filesystem::path mesh{};
    example::up_axis up = example::up_axis::y;

    std::optional<float> azimuth{}, elevation{};  ///< angles of the light
    std::optional<std::string> encoding{}, filter{}, bias{};
    glm::ivec2 map_size{0};  ///< 0: the system's own
    std::optional<float> radius{}, light_size{}, reach{}, epsilon{};

    std::string ground = "outdoor";      ///< outdoors, what there is
    std::string placement = "cascades";  ///< placement of an outdoor light's maps

    int width = 960, height = 640;
    bool es2 = false;   ///< OpenGL ES 2 and GLSL 100
    bool mask = false;  ///< visibility alone
    bool tint = false;  ///< cascades, pages, faces in colors
    bool text = true, map = true;

    bool headless = false;
    int frames = 0;  ///< 0: until the window is closed
    std::filesystem::path screenshot{};
};

/// Reads the command line; nothing when only help was asked for.
/// @throws example::usage_error  impossible options, in one line
[[nodiscard]] std::optional<options> parse_options(int argc, const char* const* argv);

}  // namespace viewer
