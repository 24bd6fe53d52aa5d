// SPDX-License-Identifier: MIT
#include "pages.hpp"

#include <array>
#include <filesystem>
#include <stdexcept>
#include <string>

#include <png.hpp>
#include <shell.hpp>
#include <systems.hpp>

namespace pictures {
namespace {

/// What an original's program draws of its scene.
picture drawn_by(const example::shadow_system& system, int width) {
    const std::filesystem::path folder = std::filesystem::temp_directory_path() / "umbrage-originals" / system.name;
    const example::finished program = example::run_line(
        example::quoted(std::filesystem::path(ORIGINALS) / system.name) + "--output " + example::quoted(folder) +
        "--size " + std::to_string(width) + (system.name == example::exercise.name ? " --frames 1" : ""));
    if (program.code != 0) throw std::runtime_error(program.said);
    return example::read_png<glm::u8vec3>(folder / "picture.png");
}

}  // namespace

picture originals(int width) {
    constexpr int gap = 8;
    const glm::ivec2 cell(width + gap, width * 2 / 3 + gap + canvas::line);
    canvas page(2 * cell + gap);
    glm::ivec2 next(0);
    for (const example::shadow_system& system : example::systems) {
        const glm::ivec2 at = next * cell + gap;
        page.write(std::string(system.title), at);
        page.paste(drawn_by(system, width), at + glm::ivec2(0, canvas::line));
        next = next.x == 0 ? glm::ivec2(1, next.y) : glm::ivec2(0, next.y + 1);
    }
    return page.pixels();
}

}  // namespace pictures
