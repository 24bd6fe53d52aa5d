// SPDX-License-Identifier: MIT
#include "opengl.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <utility>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#include <stb/stb_image.h>

namespace gallery {
namespace {

std::optional<umbrage::image<glm::u8vec3>> read_png(const std::filesystem::path& file) {
    int width = 0, height = 0, channels = 0;
    const std::unique_ptr<stbi_uc, void (*)(void*)> data(
        stbi_load(file.string().c_str(), &width, &height, &channels, 3), stbi_image_free);
    if (!data) return std::nullopt;
    umbrage::image<glm::u8vec3> out({width, height});
    for (std::size_t i = 0; i < out.texels().size(); ++i)
        out.texels()[i] = {data.get()[3 * i], data.get()[3 * i + 1], data.get()[3 * i + 2]};
    return out;
}

}  // namespace

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
    auto visibility = read_png(out.mask);
    if (!visibility || visibility->size() != size) return std::nullopt;
    out.visibility = std::move(*visibility);
    std::ifstream in(said);
    for (std::string line; std::getline(in, line);)
        if (line.find(" ms a frame") != std::string::npos) out.frame = line;
    return out;
}

}  // namespace gallery
