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
#include <umbrage/images/depth_span.hpp>
#include <umbrage/images/instances.hpp>
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

constexpr std::size_t cascade_count = 4;
constexpr float fade = 0.1f;  ///< share of a cascade over which the next one takes over
using cascades = std::array<umbrage::cascade<float>, cascade_count>;

/// Of what the camera sees, by the distances between which it sees anything.
cascades make_cascades(const options& o, const view& v, float reach) {
    const float cleared = umbrage::cleared_depth(example::picture_clip);
    umbrage::image<float> depths(glm::ivec2(o.width, o.height), cleared);
    example::draw_depths(depths, view_of(v.scene.geometry), example::once, v.camera.world_to_clip);
    const glm::vec2 range = umbrage::seen_range(umbrage::measure_depths(std::as_const(depths).view(), cleared),
                                                v.scene.z_near, v.scene.z_far, example::picture_clip.direction);
    const auto& f = v.camera.frustum;
    const umbrage::cascade_fit<float> fit{
        .camera{v.camera.position, f.direction, f.up, float(f.tan_half_x), float(f.tan_half_y), range.x, range.y},
        .direction = v.lamp.direction,
        .up = example::direction_at(o.azimuth, o.elevation + 90),
        .scene{v.scene.low, v.scene.high},
        .map_size = glm::ivec2(o.map_size / 2),
        .margin = 2 * reach,  // what a bias moves a receiver by, and the filter around it
        .overlap = fade,
        .clip = example::picture_clip};
    return umbrage::make_stable_cascades<cascade_count>(
        fit, umbrage::practical_splits<cascade_count>(range.x, range.y, 0.9f));
}

struct drawn {
    std::size_t instances = 0, triangles = 0;
    double ms = 0;  ///< of the processor's time: other programs do not count
};

/// The depth pass of one cascade.
/// @param all   instances beside the map too
drawn draw_depths(umbrage::image_view<float> map, const example::scene& scene, const umbrage::light_space<float>& light,
                  bool all) {
    const glm::mat4 world_to_clip = light.projection * light.view;
    const std::clock_t start = std::clock();
    drawn out;
    const auto draw = [&](const umbrage::mesh_view& shape, std::span<const glm::mat4> places) {
        example::draw_depths(map, shape, places, world_to_clip);
        out.instances += places.size();
        out.triangles += places.size() * shape.triangles.size();
    };
    for (const example::copies& part : scene.parts) {
        const umbrage::mesh_view shape = view_of(part.shape);
        if (all) draw(shape, part.places);
        else draw(shape, umbrage::instances_in_map(umbrage::bounds_of(shape), part.places, world_to_clip, light.clip));
    }
    if (scene.parts.empty()) draw(view_of(scene.geometry), example::once);
    out.ms = 1000.0 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    return out;
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

/// The picture in the cascades' colors, white beyond.
umbrage::image<glm::u8vec3> tinted(umbrage::image<glm::u8vec3> shaded, const umbrage::cascade_uniforms<float>& u,
                                   const umbrage::image<float>& distances, const view& v, int samples) {
    constexpr std::array<glm::vec3, cascade_count + 1> tints{
        {{1, 0.45f, 0.4f}, {0.5f, 1, 0.4f}, {0.45f, 0.6f, 1}, {1, 0.9f, 0.35f}, {1, 1, 1}}};
    for (glm::ivec2 p{0}; p.y < shaded.size().y; ++p.y)
        for (p.x = 0; p.x < shaded.size().x; ++p.x) {
            if (v.seen[p * samples] == example::nothing) continue;
            const auto [number, weight] = place_of(u, distances[p * samples]);
            const glm::vec3 tint = glm::mix(tints[number], tints[number + 1], weight);
            shaded[p] = umbrage::store_unorm(glm::vec3(shaded[p]) / 255.0f * tint);
        }
    return shaded;
}

}  // namespace

void render_cascades(const options& o, const example::scene& scene) {
    example::progress progress(8 + cascade_count, o.quiet);
    view view{.scene = scene, .lamp = make_light(o, scene), .camera = make_camera(o, scene), .seen{}};
    progress.stage("camera pass", [&] {
        view.seen = example::camera_pass(scene.geometry, view.camera, glm::ivec2(o.width, o.height) * o.samples);
    });
    const cascades all = progress.stage("cascades", [&] { return make_cascades(o, view, reach_of(o)); });
    const auto uniforms = umbrage::make_cascade_uniforms(all, fade);

    options tile = o;
    tile.map_size = o.map_size / 2;
    const float cleared = umbrage::cleared_depth(example::picture_clip);
    umbrage::image<float> atlas(glm::ivec2(2 * tile.map_size), cleared);
    const auto tile_of = [&](std::size_t i, auto& image) {
        const glm::ivec2 size(tile.map_size);
        return image.view().region(umbrage::cascade_tile(static_cast<int>(i), size), size);
    };
    std::array<drawn, cascade_count> drawn;
    progress.stage("depth pass", [&] {
        for (std::size_t i = 0; i < cascade_count; ++i)
            drawn[i] = draw_depths(tile_of(i, atlas), scene, all[i].light, o.draw_all);
    });
    const auto map = progress.stage("encode", [&] { return example::store(o.encoding, o.edge, atlas, cleared); });

    std::vector<umbrage::image<float>> by_cascade;
    for (std::size_t i = 0; i < cascade_count; ++i)
        progress.stage("cascade " + std::to_string(i + 1), [&] {
            view.lamp.space = all[i].light;
            view.lamp.units = umbrage::make_light_units(view.lamp.space, glm::ivec2(tile.map_size));
            const receivers receivers =
                receivers_of(view, tile, reach_of(o), map.below, progress, compares_projected(o));
            by_cascade.push_back(prepare(tile, tile_of(i, map.depth), view.lamp, progress)(receivers));
        });
    by_cascade.emplace_back(view.seen.size(), 1.0f);  // beyond the last all is lit

    umbrage::image<float> distance, visibility(view.seen.size());
    progress.stage("blend", [&] {
        distance = distances(view);
        for (std::size_t i = 0; i < distance.texels().size(); ++i) {
            const auto [number, weight] = place_of(uniforms, distance.texels()[i]);
            visibility.texels()[i] =
                umbrage::blend_cascades(by_cascade[number].texels()[i], by_cascade[number + 1].texels()[i], weight);
        }
    });
    auto shaded = progress.stage("shade", [&] { return shade(view, visibility, o.samples, progress.bands()); });
    progress.stage("write", [&] {
        const auto colored = tinted(shaded, uniforms, distance, view, o.samples);
        example::write_png(o.output / "cascades.png", colored.view());
        write(o, map, visibility, std::move(shaded));
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
        std::printf("%7zu %10.2f %10.2f %7.3f %10zu %10zu %9.2f\n", i + 1, double(all[i].begin), double(all[i].end),
                    1 / double(all[i].scale.x), drawn[i].instances, drawn[i].triangles, drawn[i].ms);
}

}  // namespace shadow_render
