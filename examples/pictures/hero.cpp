// SPDX-License-Identifier: MIT
#include "pages.hpp"

#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <umbrage/core/unorm.hpp>
#include <umbrage/debug/overlay.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include <camera.hpp>
#include <progress.hpp>
#include <depth_color.hpp>
#include <scene.hpp>

#include <cascades.hpp>
#include <options.hpp>
#include <render.hpp>
#include <shade.hpp>

namespace pictures {
namespace {

using shadow_render::options;

picture tinted(options o, const example::scene& scene) {
    example::progress progress(12, true);
    o.light = shadow_render::light_kind::cascades;
    shadow_render::view v = make_view(o, scene, progress);
    const shadow_render::cascaded by = look_up_cascades(o, v, v.camera, progress);
    return tinted(shade(v, by.visibility, o.samples, progress.bands()), by, v, o.samples);
}

/// The part of the shadow map around the camera's target, as the light sees it: farther is lighter.
picture depths(const options& o, const example::scene& scene) {
    constexpr float world_height = 3.7f;
    example::progress progress(12, true);
    const shadow_render::view v = make_view(o, scene, progress);
    const example::shadow_map map = draw_map(o, v, progress);
    const glm::mat4 to_texels = umbrage::texture_matrix(v.lamp.space, map.depth.size());
    const glm::vec2 center(umbrage::shadow_coordinate(to_texels, scene.target));
    const glm::mat4 rows = glm::transpose(to_texels);
    const float pixel = world_height / static_cast<float>(o.height);
    const glm::vec2 step(glm::length(glm::vec3(rows[0])) * pixel, glm::length(glm::vec3(rows[1])) * pixel);
    picture out({o.width, o.height});
    for (glm::ivec2 p{0}; p.y < o.height; ++p.y)
        for (p.x = 0; p.x < o.width; ++p.x) {
            constexpr int parts = 3;
            float sum = 0;
            for (int i = 0; i < parts * parts; ++i) {
                const glm::vec2 in = (glm::vec2(i % parts, i / parts) + 0.5f) / float(parts);
                const glm::vec2 at = center + (glm::vec2(p) + in - 0.5f * glm::vec2(out.size())) * step;
                sum += map.depth[glm::clamp(glm::ivec2(at), glm::ivec2(0), map.depth.size() - 1)];
            }
            out[p] = umbrage::store_unorm(glm::vec3(sum / (parts * parts)));
        }
    int low = 255, high = 0;
    for (const glm::u8vec3& d : out.texels()) low = std::min<int>(low, d.r), high = std::max<int>(high, d.r);
    for (glm::u8vec3& d : out.texels())
        d = umbrage::store_unorm(
            example::depth_color(static_cast<float>(d.r - low) / static_cast<float>(std::max(high - low, 1))));
    return out;
}

}  // namespace

picture hero(int width) {
    const example::scene scene = example::default_scene();
    const int gap = std::max(width / 200, 1), height = width * 7 / 16, side_height = (height - gap) / 2;
    options o;
    o.quiet = true;
    o.samples = 4;
    o.width = (width - gap) * 2 / 3, o.height = height;
    options side = o;
    side.width = width - gap - o.width, side.height = side_height;
    canvas page({width, height});
    page.paste(photograph(o, scene), {0, 0});
    page.paste(tinted(side, scene), {o.width + gap, 0});
    page.paste(depths(side, scene), {o.width + gap, height - side_height});
    return page.pixels();
}

}  // namespace pictures
