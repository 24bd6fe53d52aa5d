// SPDX-License-Identifier: MIT
#include "opengl.hpp"

#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <utility>

#include <png.hpp>

namespace gallery {

std::optional<opengl_pictures> run_viewer(const std::filesystem::path& viewer, std::string_view system, glm::ivec2 size,
                                          const std::filesystem::path& folder) {
    if (!std::filesystem::exists(viewer)) return std::nullopt;
    opengl_pictures out{.picture = folder / "opengl.png", .mask = folder / "opengl_mask.png"};
    const std::filesystem::path said = folder / "opengl.txt";
    const auto run = [&](const std::string& arguments, const std::filesystem::path& screenshot) {
        const std::string command = '\'' + viewer.string() + "' --headless --system " + std::string(system) +
                                    " --width " + std::to_string(size.x) + " --height " + std::to_string(size.y) +
                                    " --screenshot '" + screenshot.string() + "' " + arguments + " > '" +
                                    said.string() + "'";
        std::filesystem::remove(screenshot);
        return std::system(command.c_str()) == 0;
    };
    if (!run("--mask --no-map", out.mask) || !run("--frames 9", out.picture)) return std::nullopt;
    if (!std::filesystem::exists(out.mask)) return std::nullopt;
    out.visibility = example::read_png<glm::u8vec3>(out.mask);
    if (out.visibility.size() != size) return std::nullopt;
    std::ifstream in(said);
    for (std::string line; std::getline(in, line);)
        if (line.find(" ms a frame") != std::string::npos) out.frame = line;
    return out;
}

}  // namespace gallery
