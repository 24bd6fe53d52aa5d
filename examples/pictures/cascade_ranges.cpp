// SPDX-License-Identifier: MIT
#include <cstddef>
#include <string>
#include <vector>

#include <umbrage/light/cascades/select.hpp>

#include <progress.hpp>
#include <scene.hpp>

#include <cascades.hpp>
#include <render.hpp>
#include <shade.hpp>

#include "pages.hpp"
#include "spread.hpp"

namespace pictures {

picture cascade_ranges(int width) {
    using shadow_render::cascade_count;
    const spread page(width, cascade_count);
    const shadow_render::options o = outdoors(page.view);
    const example::scene scene = example::outdoor_scene();
    example::progress progress(20, true);
    shadow_render::view v = make_view(o, scene, progress);
    const shadow_render::cascaded by = look_up_cascades(o, v, v.camera, progress);

    constexpr int gap = spread::gap / 2;
    const int side = (page.side - gap) / 2;
    canvas maps(glm::ivec2{page.side});
    std::vector<line> key;
    for (std::size_t i = 0; i < cascade_count; ++i) {
        const glm::ivec2 size(o.map_size / 2), first = umbrage::cascade_tile(static_cast<int>(i), size);
        picture map = depths_of(by.map.depth.view().region(first, size), side);
        for (glm::u8vec3& c : map.texels()) c = times(c, shadow_render::tint_of(i));
        maps.paste(map, glm::ivec2(i % 2, i / 2) * (side + gap));
        key.push_back({umbrage::store_unorm(shadow_render::tint_of(i)),
                       {std::to_string(i + 1), length(double(by.all[i].end)), length(1 / double(by.all[i].scale.x))}});
    }
    const picture gray = without_color(shade(v, by.visibility, o.samples, progress.bands()));
    return page.of(tinted(gray, by, v, o.samples), maps.pixels(), {"map", "ends at", "texel"}, key);
}

}  // namespace pictures
