// SPDX-License-Identifier: MIT
#include "cascades.hpp"

#include <array>
#include <cstddef>
#include <cstdio>
#include <ctime>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <umbrage/core/unorm.hpp>
#include <umbrage/draw/instances.hpp>
#include <umbrage/images/depth_span.hpp>
#include <umbrage/light/cascades/blend.hpp>
#include <umbrage/light/cascades/cascades.hpp>
#include <umbrage/light/cascades/select.hpp>
#include <umbrage/light/cascades/splits.hpp>

#include <biases.hpp>
#include <camera.hpp>
#include <names.hpp>
#include <png.hpp>
#include <progress.hpp>
#include <shadow_map.hpp>

#include "filter.hpp"
#include "pictures.hpp"
#include "receivers.hpp"
#include "shade.hpp"
#include "view.hpp"

namespace shadow_render {
namespace {

/// Share of a cascade over which the next one takes over.
float fade_of(const options& o) { return o.broken.no_fade ? 0.0f : 0.1f; }

/// Of what a camera sees, by the distances between which it sees anything.
cascade_array make_cascades(const options& o, const view& v, const example::camera& camera, float reach) {
    const float cleared = umbrage::cleared_depth(example::picture_clip);
    umbrage::image<float> depths(glm::ivec2(o.width, o.height), cleared);
    example::draw_depths(depths, view_of(v.scene.geometry), example::once, camera.world_to_clip);
    const glm::vec2 measured = umbrage::seen_range(umbrage::measure_depths(std::as_const(depths).view(), cleared),
                                                   v.scene.z_near, v.scene.z_far, example::picture_clip.direction);
    const glm::vec2 range =
        o.fixed_range ? glm::vec2(v.scene.z_near, v.scene.z_far) : measured;  // the same after a step
    const auto& f = camera.frustum;
    const umbrage::cascade_fit<float> fit{
        .camera{camera.position, f.direction, f.up, float(f.tan_half_x), float(f.tan_half_y), range.x, range.y},
        .direction = v.lamp.direction,
        .up = o.broken.tight ? glm::vec3(f.direction) : example::direction_at(o.azimuth, o.elevation + 90),
        .scene{v.scene.low, v.scene.high},
        .map_size = glm::ivec2(o.map_size / 2),
        .margin = 2 * reach,  // what a bias moves a receiver by, and the filter around it
        .overlap = fade_of(o),
        .clip = example::picture_clip};
    // The last cascade fades out beyond what is farthest.
    const auto splits = umbrage::practical_splits<cascade_count>(range.x, range.y / (1 - fade_of(o)), 0.9f);
    return o.broken.tight ? umbrage::make_tight_cascades<cascade_count>(fit, splits)
                          : umbrage::make_stable_cascades<cascade_count>(fit, splits);
}

/// Distance of each sample along the camera's axis; 0 where it sees nothing.
umbrage::image<float> distances(const view& v) {
    umbrage::image<float> out(v.seen.size());
    const glm::vec3 ahead(v.camera.frustum.direction);
    for (int y = 0; y < out.size().y; ++y)
        example::for_each_run(v.seen, y, [&](int first, int last, std::uint32_t triangle) {
            const example::seen_triangle on = v.triangle(triangle);
            for (int x = first; x < last; ++x)
                out[{x, y}] = glm::dot(on.position(on.weights({x, y})) - v.camera.position, ahead);
        });
    return out;
}

/// The cascade at a distance, and how much of the next one is mixed in.
struct place {
    std::size_t number;
    float weight;
};
place place_of(const umbrage::cascade_uniforms<float>& u, float distance) {
    const float number = umbrage::cascade_by_depth(distance, u.ends);
    return {static_cast<std::size_t>(number),
            umbrage::cascade_fade(distance, umbrage::cascade_column(u.scales, number).w,
                                  umbrage::cascade_column(u.offsets, number).w)};
}

}  // namespace

drawn draw_instances(umbrage::image_view<float> map, const example::scene& scene, const glm::mat4& world_to_clip,
                     bool all) {
    const std::clock_t start = std::clock();
    drawn out;
    const auto draw = [&](const umbrage::mesh_view& shape, std::span<const glm::mat4> places) {
        example::draw_depths(map, shape, places, world_to_clip);
        out.instances += places.size();
        out.triangles += places.size() * shape.triangles.size();
    };
    for (const example::copies& part : scene.parts) {
        const umbrage::mesh_view shape = view_of(part.shape);
        const umbrage::bounding_box<float> box = umbrage::bounds_of(shape);
        if (all) draw(shape, part.places);
        else draw(shape, umbrage::instances_in_map(box, part.places, world_to_clip, example::picture_clip));
    }
    if (scene.parts.empty()) draw(view_of(scene.geometry), example::once);
    out.ms = 1000.0 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    return out;
}

cascaded look_up_cascades(const options& o, view& v, const example::camera& camera, example::progress& progress) {
    cascaded out{.all = progress.stage("cascades", [&] { return make_cascades(o, v, camera, reach_of(o)); })};
    out.uniforms = umbrage::make_cascade_uniforms(out.all, fade_of(o));

    options tile = o;
    tile.map_size = o.map_size / 2;
    const float cleared = umbrage::cleared_depth(example::picture_clip);
    umbrage::image<float> atlas(glm::ivec2(2 * tile.map_size), cleared);
    const auto tile_of = [&](std::size_t i, auto& image) {
        const glm::ivec2 size(tile.map_size);
        return image.view().region(umbrage::cascade_tile(static_cast<int>(i), size), size);
    };
    progress.stage("depth pass", [&] {
        for (std::size_t i = 0; i < cascade_count; ++i) {
            const umbrage::light_space<float>& light = out.all[i].light;
            out.drawn[i] = draw_instances(tile_of(i, atlas), v.scene, light.projection * light.view, o.draw_all);
        }
    });
    out.map = progress.stage("encode", [&] { return example::store(o.encoding, o.edge, atlas, cleared); });

    std::vector<umbrage::image<float>> by_cascade;
    for (std::size_t i = 0; i < cascade_count; ++i)
        progress.stage("cascade " + std::to_string(i + 1), [&] {
            v.lamp.space = out.all[i].light;
            v.lamp.units = umbrage::make_light_units(v.lamp.space, glm::ivec2(tile.map_size));
            const receivers receivers =
                receivers_of(v, tile, reach_of(o), out.map.below, progress, compares_projected(o));
            by_cascade.push_back(prepare(tile, tile_of(i, out.map.depth), v.lamp, progress)(receivers));
        });
    by_cascade.emplace_back(v.seen.size(), 1.0f);  // beyond the last all is lit

    out.visibility = umbrage::image<float>(v.seen.size());
    progress.stage("blend", [&] {
        out.distance = distances(v);
        for (std::size_t i = 0; i < out.distance.texels().size(); ++i) {
            const auto [number, weight] = place_of(out.uniforms, out.distance.texels()[i]);
            out.visibility.texels()[i] =
                umbrage::blend_cascades(by_cascade[number].texels()[i], by_cascade[number + 1].texels()[i], weight);
        }
    });
    return out;
}

glm::vec3 tint_of(std::size_t cascade, float weight) {
    constexpr std::array<glm::vec3, cascade_count + 1> tints{
        {{1, 0.45f, 0.4f}, {0.5f, 1, 0.4f}, {0.45f, 0.6f, 1}, {1, 0.9f, 0.35f}, {1, 1, 1}}};
    return glm::mix(glm::vec3(1), glm::mix(tints[cascade], tints[cascade + 1], weight), 0.7f);
}

umbrage::image<glm::u8vec3> tinted(umbrage::image<glm::u8vec3> shaded, const cascaded& by, const view& v, int samples) {
    for (glm::ivec2 p{0}; p.y < shaded.size().y; ++p.y)
        for (p.x = 0; p.x < shaded.size().x; ++p.x)
            shaded[p] =
                umbrage::store_unorm(glm::vec3(shaded[p]) / 255.0f * mean<glm::vec3>(p.x, samples, [&](int x, int row) {
                                         const glm::ivec2 sample(x, p.y * samples + row);
                                         if (v.seen[sample] == example::nothing) return glm::vec3(1);
                                         const auto [number, weight] = place_of(by.uniforms, by.distance[sample]);
                                         return tint_of(number, weight);
                                     }));
    return shaded;
}

void render_cascades(const options& o, const example::scene& scene) {
    example::progress progress(8 + cascade_count, o.quiet);
    view view{.scene = scene, .lamp = make_light(o, scene), .camera = make_camera(o, scene), .seen{}};
    progress.stage("camera pass", [&] {
        view.seen = example::camera_pass(scene.geometry, view.camera, glm::ivec2(o.width, o.height) * o.samples);
    });
    const cascaded by = look_up_cascades(o, view, view.camera, progress);
    auto shaded = progress.stage("shade", [&] { return shade(view, by.visibility, o.samples, progress.bands()); });
    progress.stage("write", [&] {
        const auto colored = tinted(shaded, by, view, o.samples);
        example::write_png(o.output / "cascades.png", colored.view());
        write(o, by.map, by.visibility, std::move(shaded));
    });
    if (o.quiet) return;

    progress.print_times();
    std::size_t instances = scene.parts.empty();
    for (const example::copies& part : scene.parts) instances += part.places.size();
    std::printf(
        "\n%zu triangles in %zu instances; pictures in %s\ncascade       from         to   texel  instances  "
        "triangles        ms\n",
        scene.geometry.triangles.size(), instances, o.output.string().c_str());
    for (std::size_t i = 0; i < cascade_count; ++i)
        std::printf("%7zu %10.2f %10.2f %7.3f %10zu %10zu %9.2f\n", i + 1, double(by.all[i].begin),
                    double(by.all[i].end), 1 / double(by.all[i].scale.x), by.drawn[i].instances, by.drawn[i].triangles,
                    by.drawn[i].ms);
}

}  // namespace shadow_render
