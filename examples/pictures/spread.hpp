// SPDX-License-Identifier: MIT
//
// A view under a light's several maps, each in a color, beside it the maps, and a key to the colors.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <umbrage/core/unorm.hpp>
#include <umbrage/debug/overlay.hpp>

#include <camera.hpp>
#include <depth_color.hpp>
#include <text.hpp>

#include <options.hpp>

#include "canvas.hpp"

namespace pictures {

using example::text;

/// A line of the key: a color and what it stands for.
struct line {
    glm::u8vec3 color;
    std::array<std::string, 3> words;
};

/// The view at the left, the maps at its right, and the key below them.
class spread {
public:
    static constexpr int gap = 8;

    /// @param parts   most lines that a key has below its heading
    spread(int width, int parts) : side(width / 3), view{width - side - gap, side + gap + (1 + parts) * canvas::line} {}

    const int side;         ///< of the maps' picture, pixels
    const glm::ivec2 view;  ///< size of the view's picture

    [[nodiscard]] picture of(const picture& seen, const picture& maps, const std::array<std::string, 3>& heading,
                             const std::vector<line>& key) const {
        canvas page({view.x + gap + side, view.y});
        page.paste(seen, {0, 0});
        glm::ivec2 at(view.x + gap, 0);
        page.paste(maps, at);
        at.y = side + gap;
        const auto write = [&](const std::array<std::string, 3>& words, glm::u8vec3 color) {
            for (int i = 0; i < 3; ++i) page.write(words[std::size_t(i)], at + glm::ivec2(24 + 88 * i, 0), color);
            at.y += canvas::line;
        };
        write(heading, pale_ink);
        for (const line& l : key) {
            page.fill(at + glm::ivec2(0, 4), at + glm::ivec2(14, 18), l.color);
            write(l.words, ink);
        }
        return page.pixels();
    }
};

/// Two digits of a length in meters.
inline std::string length(double m) {
    const double shown = m < 1 ? 100 * m : m;
    return text(shown < 10 ? "%.1f %s" : "%.0f %s", shown, m < 1 ? "cm" : "m");
}

/// The same view for each.
inline shadow_render::options outdoors(glm::ivec2 size) {
    shadow_render::options o;
    o.quiet = true;
    o.scene = shadow_render::built_in::outdoor;
    o.light = shadow_render::light_kind::cascades;
    o.azimuth = 60;
    o.camera_elevation = 9, o.camera_distance = 64, o.fov = 42;
    o.map_size = 4096;
    o.filter = "pcf_2x2";
    o.samples = 3;
    o.width = size.x, o.height = size.y;
    return o;
}

/// In light gray, for tints to be told apart by.
inline picture without_color(picture shaded) {
    for (glm::u8vec3& c : shaded.texels()) {
        const float gray = glm::dot(glm::vec3(c) / 255.0f, {0.3f, 0.55f, 0.15f});
        c = umbrage::store_unorm(glm::vec3(std::pow(gray, 0.6f)));
    }
    return shaded;
}

/// A map as the light sees it, in gray, farther is lighter.
inline picture depths_of(umbrage::image_view<const float> map, int side) {
    constexpr int parts = 3;
    const umbrage::contrast_stretch stretch = umbrage::stretch(map, umbrage::cleared_depth(example::picture_clip));
    picture out(glm::ivec2{side});
    const glm::vec2 step = glm::vec2(map.size) / static_cast<float>(side * parts);
    for (glm::ivec2 p{0}; p.y < side; ++p.y)
        for (p.x = 0; p.x < side; ++p.x) {
            glm::vec3 sum(0);
            for (int i = 0; i < parts * parts; ++i) {
                const glm::vec2 at(p * parts + glm::ivec2(i % parts, i / parts));
                sum += example::depth_color(stretch(map[glm::ivec2((at + 0.5f) * step)]));
            }
            out[p] = umbrage::store_unorm(sum / static_cast<float>(parts * parts));
        }
    return without_color(std::move(out));
}

inline glm::u8vec3 times(glm::u8vec3 color, glm::vec3 tint) {
    return umbrage::store_unorm(glm::vec3(color) / 255.0f * tint);
}

}  // namespace pictures
