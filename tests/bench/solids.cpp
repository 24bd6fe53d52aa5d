// SPDX-License-Identifier: MIT
#include "solids.hpp"

#include <utility>

#include <umbrage/draw/rasterize.hpp>

#include <progress.hpp>
#include <receivers.hpp>
#include <view.hpp>

#include "data.hpp"

namespace bench {

shadowed_scene solids_scene(int radius) {
    shadow_render::options o;
    o.light = shadow_render::light_kind::spot;
    o.azimuth = 60, o.elevation = 40;
    o.camera_elevation = 30, o.fov = 35;
    o.map_size = map_size.x;
    o.width = screen.x;
    o.height = screen.y;
    o.bias = "normal_offset";  // it moves floors far enough that bounds, which reach beyond the box, are closed there
    const example::scene scene = example::solids_scene();
    shadow_render::view view{.scene = scene, .lamp = make_light(o, scene), .camera = make_camera(o, scene), .seen{}};
    view.seen = example::camera_pass(scene.geometry, view.camera, screen);

    umbrage::image<float> map(map_size, umbrage::cleared_depth(view.lamp.space.clip));
    umbrage::rasterize_depth(map, example::view_of(scene.geometry), view.lamp.world_to_clip(), view.lamp.space.clip);
    for (float& depth : map.texels()) depth = view.lamp.even_depth(depth);
    example::progress progress(1, true);
    const auto planes = receivers_of(view, o, static_cast<float>(radius) + 0.5f, 0.0f, progress);
    umbrage::image<glm::vec3> receivers(screen);
    for (int y = 0; y < screen.y; ++y)
        for (int x = 0; x < screen.x; ++x) {
            const glm::ivec2 t(x, y);
            receivers[t] = {planes.x[t], planes.y[t], planes.depth[t]};
        }
    return {std::move(map), std::move(receivers)};
}

}  // namespace bench
