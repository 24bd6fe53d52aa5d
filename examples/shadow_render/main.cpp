// SPDX-License-Identifier: MIT
//
// From a mesh to a shadowed picture, every step a primitive:
//
//     light -> depth pass -> encode -> [map] -> fetch -> decode -> compare -> filter -> visibility -> shade
//
// Start reading at render(). The filter is chosen in filtered(), the bias in biased().
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>

#include <umbrage/filter/box.hpp>
#include <umbrage/filter/four_tap.hpp>
#include <umbrage/filter/hard.hpp>
#include <umbrage/filter/pcf_2x2.hpp>
#include <umbrage/image_ops/rasterize.hpp>
#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/shade/lighting.hpp>
#include <umbrage/view/false_colour.hpp>
#include <umbrage/view/overlay.hpp>

#include <camera.hpp>
#include <command_line.hpp>
#include <encodings.hpp>
#include <png.hpp>
#include <progress.hpp>
#include <scene.hpp>

#include "light.hpp"
#include "options.hpp"

namespace shadow_render {
namespace {

constexpr float ambient = 0.22f;
constexpr glm::vec3 background{0.30f, 0.36f, 0.44f};

/// Visibility of a receiver at `coord` texels. To try another filter, change its line.
template <class Fetch>
float filtered(const options& o, Fetch&& fetch, glm::vec2 coord, float receiver) {
    switch (o.filter) {
        case filter_kind::hard: return umbrage::hard(fetch, coord, receiver);
        case filter_kind::four_tap: {
            const auto& tap = umbrage::default_taps<float>;
            return umbrage::four_tap(fetch, coord + tap[0], coord + tap[1], coord + tap[2], coord + tap[3], receiver);
        }
        case filter_kind::pcf: return umbrage::pcf_2x2(fetch, coord, receiver);
        case filter_kind::box: return umbrage::box(fetch, coord, receiver, o.radius);
    }
    return 1.0f;
}

/// How far from the receiver a filter's farthest texel can be, per direction, in texels.
float reach(const options& o) {
    switch (o.filter) {
        case filter_kind::hard: return 0.5f;
        case filter_kind::four_tap: return 1.0f;
        case filter_kind::pcf: return 1.0f;
        case filter_kind::box: return static_cast<float>(o.radius) + 0.5f;
    }
    return 0.0f;
}

/// The point to look up instead of the surface itself, moved off it so that no texel the filter reads can shadow a
/// plane through it. With t the angle between normal and light, depth changes by tan(t) for each unit across the
/// light, and a move by m along the normal gains m / cos(t): so m = sin(t) times the distance to the farthest texel.
glm::vec3 biased(const options& o, const light& l, const example::surface& s) {
    constexpr float snapping = 1.0f / 128;  // the depth pass moves vertices by up to 1/512 texel
    const float texels = o.bias.value_or(std::numbers::sqrt2_v<float> * (reach(o) + snapping));
    const float cosine = glm::dot(s.face_normal, l.to_light(s.position));
    const float sine = std::sqrt(std::max(0.0f, 1 - cosine * cosine));
    return s.position + s.face_normal * (texels * sine * l.texel_world(s.position, o.map_size));
}

/// Mean of the samples of a pixel.
template <class T, class Sample>
T mean(glm::ivec2 pixel, int samples, Sample&& sample) {
    T sum(0);
    for (int y = 0; y < samples; ++y)
        for (int x = 0; x < samples; ++x) sum += sample(pixel * samples + glm::ivec2(x, y));
    return sum / static_cast<float>(samples * samples);
}

/// The bytes of a texel as people's image viewers can show them: missing channels are 0.
glm::u8vec3 bytes(glm::u8vec2 texel) { return {texel, 0}; }
glm::u8vec3 bytes(glm::u8vec3 texel) { return texel; }
glm::u8vec4 bytes(glm::u8vec4 texel) { return texel; }
glm::u8vec4 bytes(float texel) { return umbrage::encode_float_bits(texel); }

template <class Encoding>
void render(const options& o, const example::scene& scene, Encoding encoding, float below) {
    const glm::ivec2 picture_size(o.width, o.height), sample_size = picture_size * o.samples, map_size(o.map_size);
    constexpr auto for_each_row = [](glm::ivec2 size, auto&& step, auto&& texel) {
        for (int y = 0; y < size.y; ++y, step())
            for (int x = 0; x < size.x; ++x) texel(glm::ivec2(x, y));
    };
    example::progress progress(2ul * static_cast<unsigned>(map_size.y) +
                                   2ul * static_cast<unsigned>(sample_size.y) + static_cast<unsigned>(o.height), o.quiet);
    const auto step = [&] { progress.step(); };

    // 1. The light: its view of the world, and the way from world positions to texels of its map.
    const light light = make_light(o, scene);
    const glm::mat4 world_to_texels = umbrage::texture_matrix(light.space, map_size);

    // 2. Depth pass: the distance to what the light sees first.
    umbrage::image<float> depth(map_size, umbrage::cleared_depth(light.space.clip));
    progress.stage("depth pass", [&] {
        umbrage::rasterize_depth(depth, example::view_of(scene.geometry), light.world_to_clip(), light.space.clip);
        progress.step(static_cast<unsigned>(map_size.y));
    });

    // 3. Encode: depths become the texels that a render target would hold.
    umbrage::image<typename Encoding::texel> map(map_size);
    progress.stage("encode", [&] {
        for_each_row(map_size, step, [&](glm::ivec2 t) { map[t] = encoding.encode(light.even_depth(depth[t])); });
    });

    // 4. Camera pass: the surface behind each sample of the picture.
    const example::camera camera = example::make_camera({.target = scene.target,
                                                         .azimuth = o.camera_azimuth,
                                                         .elevation = o.camera_elevation,
                                                         .distance = o.camera_distance,
                                                         .fov = o.fov,
                                                         .aspect = static_cast<float>(o.width) / static_cast<float>(o.height)});
    const auto seen = progress.stage("camera pass", [&] {
        auto triangles = example::camera_pass(scene.geometry, camera, sample_size);
        progress.step(static_cast<unsigned>(sample_size.y));
        return triangles;
    });

    // 5. Visibility: fetch, decode, compare, filter.
    umbrage::image<float> visibility(sample_size, 1.0f);
    progress.stage("visibility", [&] {
        const auto fetch = umbrage::decoded(map, encoding);
        const float rounding = 0x1p-18f;  // both passes compute the same depth, in float
        for_each_row(sample_size, step, [&](glm::ivec2 t) {
            if (seen[t] == example::nothing) return;
            const glm::vec3 receiver = biased(o, light, example::surface_at(scene, camera, seen, t));
            const glm::vec3 p = umbrage::project_coordinate(umbrage::shadow_coordinate(world_to_texels, receiver));
            visibility[t] = filtered(o, fetch, glm::vec2(p), light.even_depth(p.z) - rounding - below);
        });
    });

    // 6. Shade: diffuse plus ambient, inside the cone.
    umbrage::image<glm::u8vec3> picture(picture_size);
    progress.stage("shade", [&] {
        for_each_row(picture_size, step, [&](glm::ivec2 pixel) {
            picture[pixel] = example::to_srgb(mean<glm::vec3>(pixel, o.samples, [&](glm::ivec2 t) {
                if (seen[t] == example::nothing) return background;
                const example::surface s = example::surface_at(scene, camera, seen, t);
                return umbrage::diffuse_ambient(s.colour, ambient, glm::dot(s.normal, light.to_light(s.position)),
                                                visibility[t] * light.cone(s.position));
            }));
        });
    });

    // 7. What people look at.
    progress.stage("write", [&] {
        const auto save = [&](const char* name, const auto& image) { example::write_png(o.output / name, image.view()); };
        std::filesystem::create_directories(o.output);
        constexpr auto no_step = [] {};

        umbrage::image<float> stored(map_size);
        umbrage::image<glm::u8vec3> false_colours(map_size);
        umbrage::image<decltype(bytes(map[{}]))> packed(map_size);
        for_each_row(map_size, no_step, [&](glm::ivec2 t) { stored[t] = encoding.decode(map[t]); });
        const umbrage::contrast_stretch stretch = umbrage::stretch(stored, encoding.decode(encoding.encode(1.0f)), 0.0);
        for_each_row(map_size, no_step, [&](glm::ivec2 t) {
            packed[t] = bytes(map[t]);
            false_colours[t] = umbrage::store_unorm8(umbrage::false_colour(stretch(stored[t])));
        });
        save("map.png", std::as_const(packed));
        save("depth.png", std::as_const(false_colours));

        umbrage::image<std::uint8_t> mask(picture_size);
        for_each_row(picture_size, no_step, [&](glm::ivec2 pixel) {
            mask[pixel] = umbrage::store_unorm8(mean<float>(pixel, o.samples, [&](glm::ivec2 t) { return visibility[t]; }));
        });
        save("visibility.png", std::as_const(mask));

        umbrage::overlay(picture, stored,
                         {.size = glm::ivec2(std::min(o.width, o.height) / 4), .map_origin = light.space.clip.origin}, stretch);
        save("picture.png", std::as_const(picture));
    });

    if (o.quiet) return;
    progress.print_times();
    std::printf("%zu triangles, %d x %d texels, %s: picture.png, map.png, depth.png, visibility.png in %s\n",
                scene.geometry.triangles.size(), o.map_size, o.map_size, o.encoding.c_str(), o.output.string().c_str());
}

void run(const options& o) {
    const example::scene scene = o.mesh.empty()
                                     ? example::default_scene()
                                     : example::on_floor(example::load_mesh(o.mesh), o.z_up ? example::up_axis::z : example::up_axis::y);
    const float edge = o.edge == edge_kind::lower    ? umbrage::lower_edge<float>
                       : o.edge == edge_kind::centre ? umbrage::centre<float>
                                                     : umbrage::upper_edge<float>;
    example::with_encoding(o.encoding, edge,
                           [&](auto encoding, float below) { render(o, scene, encoding, below); });
}

}  // namespace
}  // namespace shadow_render

int main(int argc, char** argv) {
    return example::run("shadow_render", [&] {
        if (const auto options = shadow_render::parse_options(argc, argv)) shadow_render::run(*options);
    });
}
