// SPDX-License-Identifier: MIT
#include "render.hpp"

#include <cmath>
#include <cstddef>

#include <camera.hpp>

#include "cascades.hpp"
#include "filter.hpp"
#include "receivers.hpp"
#include "shade.hpp"

namespace shadow_render {
namespace {

/// Paints red where visibility differs from that under cascades of a camera that stood a step aside.
void mark_changes(const options& o, view& v, const umbrage::image<float>& visibility, example::progress& progress,
                  umbrage::image<glm::u8vec3>& picture) {
    options aside = o;
    aside.camera_azimuth += 0.37f, aside.camera_distance *= 1.003f;
    const auto before = visibility_of(o, v, make_camera(aside, v.scene), progress);
    for (glm::ivec2 p{0}; p.y < picture.size().y; ++p.y)
        for (p.x = 0; p.x < picture.size().x; ++p.x) {
            const float change = mean<float>(p.x, o.samples, [&](int x, int row) {
                const glm::ivec2 at(x, p.y * o.samples + row);
                return std::abs(visibility[at] - before[at]);
            });
            if (change > 1.0f / 16) picture[p] = {214, 40, 40};
        }
}

}  // namespace

view make_view(const options& o, const example::scene& scene, example::progress& progress) {
    view v{.scene = scene, .lamp = make_light(o, scene), .camera = make_camera(o, scene), .seen{}};
    progress.stage("camera pass", [&] {
        v.seen = example::camera_pass(scene.geometry, v.camera, glm::ivec2(o.width, o.height) * o.samples);
    });
    return v;
}

example::shadow_map draw_map(const options& o, const view& v, example::progress& progress) {
    // Depth pass: the distance to what the light sees first.
    const float cleared = umbrage::cleared_depth(v.lamp.space.clip);
    umbrage::image<float> depth(glm::ivec2(o.map_size), cleared);
    progress.stage("depth pass", [&] {
        example::draw_depths(depth.view(), view_of(v.scene.geometry), example::once, v.lamp.world_to_clip());
        for (float& d : depth.texels()) d = v.lamp.even_depth(d);
    });

    // Encode: depths become the texels that a render target would hold. Decode: what a fetch gives back.
    return progress.stage("encode",
                          [&] { return example::store(o.encoding, o.edge, depth, v.lamp.even_depth(cleared)); });
}

umbrage::image<float> look_up_map(const options& o, const view& v, const example::shadow_map& map,
                                  example::progress& progress) {
    const float below = o.broken.no_error ? 0.0f : map.below;
    const receivers receivers = progress.stage(
        "receivers", [&] { return receivers_of(v, o, reach_of(o), below, progress, compares_projected(o)); });

    // Visibility: fetch, compare, filter; some filter the map first.
    const look_up filter = progress.stage("filter", [&] { return prepare(o, map.depth, v.lamp, progress); });
    return progress.stage("visibility", [&] { return filter(receivers); });
}

umbrage::image<float> visibility_of(const options& o, view& v, const example::camera& camera,
                                    example::progress& progress) {
    if (o.light == light_kind::cascades) return look_up_cascades(o, v, camera, progress).visibility;
    return look_up_map(o, v, draw_map(o, v, progress), progress);
}

umbrage::image<glm::u8vec3> photograph(const options& o, const example::scene& scene) {
    example::progress progress(8 + cascade_count, true);
    view v = make_view(o, scene, progress);
    const auto visibility = visibility_of(o, v, v.camera, progress);
    auto picture = shade(v, visibility, o.samples, progress.bands());
    if (o.marks_changes) mark_changes(o, v, visibility, progress, picture);
    return picture;
}

}  // namespace shadow_render
