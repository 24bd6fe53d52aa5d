// SPDX-License-Identifier: MIT
#include "pictures.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <variant>

#include <umbrage/core/unorm.hpp>
#include <umbrage/debug/overlay.hpp>

#include <depth_color.hpp>
#include <png.hpp>

#include "shade.hpp"

namespace shadow_render {

void write(const options& o, const example::shadow_map& map, const umbrage::image<float>& visibility,
           umbrage::image<glm::u8vec3> lit) {
    const umbrage::contrast_stretch stretch = umbrage::stretch(map.depth, map.cleared);
    umbrage::image<glm::u8vec3> colors(map.depth.size());
    std::ranges::transform(map.depth.texels(), colors.texels().begin(), [&](float d) {
        return umbrage::store_unorm(d == map.cleared ? example::no_depth_color : example::depth_color(stretch(d)));
    });
    umbrage::image<std::uint8_t> mask(lit.size());
    for (int y = 0; y < mask.size().y; ++y)
        for (int x = 0; x < mask.size().x; ++x)
            mask[{x, y}] = umbrage::store_unorm(mean<float>(x, o.samples, [&](int at, int row) {
                return visibility[{at, y * o.samples + row}];
            }));

    std::visit([&](const auto& bytes) { example::write_png(o.output / "map.png", bytes.view()); }, map.bytes);
    example::write_png(o.output / "depth.png", std::as_const(colors).view());
    example::write_png(o.output / "visibility.png", std::as_const(mask).view());
    example::write_png(o.output / "picture.png", std::as_const(lit).view());
}

}  // namespace shadow_render
