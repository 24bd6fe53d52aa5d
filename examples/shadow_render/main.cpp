// SPDX-License-Identifier: MIT
//
// From a mesh to a shadowed picture, every step a primitive:
//
//     light -> depth pass -> encode -> [map] -> fetch -> decode -> compare -> filter -> visibility -> shade
//
// Start reading at render(). The filter is chosen in with_filter(), the bias in biased().
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numbers>
#include <stdexcept>
#include <system_error>
#include <utility>

#include <umbrage/image_ops/encode.hpp>
#include <umbrage/image_ops/rasterize.hpp>
#include <umbrage/image_ops/visibility.hpp>
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

/// The filter of the options, and how far from a receiver its farthest texel can be, per direction, in texels.
/// Change a line here to try another.
template <class Use>
auto with_filter(const options& o, Use&& use) {
    switch (o.filter) {
        case filter_kind::hard: return use(umbrage::filters::hard{}, 0.5f);
        case filter_kind::four_tap: return use(umbrage::filters::four_tap{}, 1.0f);
        case filter_kind::box: return use(umbrage::filters::box{o.radius}, static_cast<float>(o.radius) + 0.5f);
        case filter_kind::pcf: break;
    }
    return use(umbrage::filters::pcf_2x2{}, 1.0f);
}

/// The point to look up instead of the surface itself, moved off it so that no texel the filter reads can shadow a
/// plane through it. With t the angle between normal and light axis, a texel's step across the map changes the depth
/// of the plane by as much as a move of sin(t) texels along its normal wins: so sin(t) times the farthest texel.
glm::vec3 biased(const example::surface& s, const light& l, float texels, int map_size) {
    const float cosine = glm::dot(s.face_normal, l.direction);
    const float sine = std::sqrt(std::max(0.0f, 1 - cosine * cosine));
    return s.position + s.face_normal * (texels * sine * l.texel_world(s.position, map_size));
}
float automatic_bias(float reach) {
    constexpr float snapping = 1.0f / 128;  // the depth pass moves vertices by up to 1/512 texel
    return std::numbers::sqrt2_v<float> * (reach + snapping);
}

/// Calls work(texel) for every texel and step() after each row.
template <class Step, class Work>
void for_each_texel(glm::ivec2 size, Step&& step, Work&& work) {
    for (int y = 0; y < size.y; ++y, step())
        for (int x = 0; x < size.x; ++x) work(glm::ivec2(x, y));
}

/// Mean of the samples of a pixel.
template <class T, class Sample>
T mean(glm::ivec2 pixel, int samples, Sample&& sample) {
    T sum(0);
    for_each_texel(glm::ivec2(samples), [] {}, [&](glm::ivec2 t) { sum += sample(pixel * samples + t); });
    return sum / static_cast<float>(samples * samples);
}

/// The bytes of a texel as image viewers can show them: missing channels are 0.
glm::u8vec3 bytes(glm::u8vec2 texel) { return {texel, 0}; }
glm::u8vec3 bytes(glm::u8vec3 texel) { return texel; }
glm::u8vec4 bytes(glm::u8vec4 texel) { return texel; }
glm::u8vec4 bytes(float texel) { return umbrage::encode_float_bits(texel); }

template <class Encoding>
void render(const options& o, const example::scene& scene, Encoding encoding, float below) {
    const glm::ivec2 picture_size(o.width, o.height), sample_size = picture_size * o.samples, map_size(o.map_size);
    example::progress progress(3 * static_cast<unsigned>(sample_size.y) + static_cast<unsigned>(o.height), o.quiet);
    const auto step = [&] { progress.step(); };

    // 1. The light: its view of the world, and the way from world positions to texels of its map.
    const light light = make_light(o, scene);
    const glm::mat4 world_to_texels = umbrage::texture_matrix(light.space, map_size);

    // 2. Depth pass: the distance to what the light sees first.
    umbrage::image<float> depth(map_size, umbrage::cleared_depth(light.space.clip));
    progress.stage("depth pass", [&] {
        umbrage::rasterize_depth(depth, example::view_of(scene.geometry), light.world_to_clip(), light.space.clip);
        for (float& d : depth.texels()) d = light.even_depth(d);
    });

    // 3. Encode: depths become the texels that a render target would hold.
    umbrage::image<typename Encoding::texel> map(map_size);
    progress.stage("encode", [&] { umbrage::encode(std::as_const(depth).view(), map.view(), encoding); });

    // 4. Camera pass: the triangle behind each sample of the picture.
    const example::camera camera = example::make_camera({.target = scene.target,
                                                         .azimuth = o.camera_azimuth,
                                                         .elevation = o.camera_elevation,
                                                         .distance = o.camera_distance,
                                                         .fov = o.fov,
                                                         .aspect = static_cast<float>(o.width) / static_cast<float>(o.height)});
    umbrage::image<std::uint32_t> seen;
    progress.stage("camera pass", [&] { seen = example::camera_pass(scene.geometry, camera, sample_size); });
    progress.step(static_cast<unsigned>(sample_size.y));

    // 5. Receivers: where each sample looks into the map, and the depth it compares with. The bias is part of it.
    umbrage::image<glm::vec3> receivers(sample_size, umbrage::project_coordinate(glm::vec4(0)));  // lit, whatever the map
    progress.stage("receivers", [&] {
        constexpr float rounding = 0x1p-18f;  // both passes compute the same depth, in float
        const float texels = o.bias.value_or(with_filter(o, [](auto, float reach) { return automatic_bias(reach); }));
        for_each_texel(sample_size, step, [&](glm::ivec2 t) {
            if (seen[t] == example::nothing) return;
            const glm::vec3 point = biased(example::surface_at(scene, camera, seen, t), light, texels, o.map_size);
            const glm::vec3 p = umbrage::project_coordinate(umbrage::shadow_coordinate(world_to_texels, point));
            receivers[t] = {p.x, p.y, light.even_depth(p.z) - rounding - below};
        });
    });

    // 6. Visibility: fetch, decode, compare, filter.
    umbrage::image<float> visibility(sample_size);
    progress.stage("visibility", [&] {
        with_filter(o, [&](auto filter, float) {
            for (int y = 0; y < sample_size.y; ++y, step())
                umbrage::visibility(std::as_const(map).view(), encoding, std::as_const(receivers).view().rows(y, y + 1),
                                    filter, visibility.view().rows(y, y + 1));
        });
    });

    // 7. Shade: diffuse plus ambient, inside the cone.
    umbrage::image<glm::u8vec3> picture(picture_size);
    progress.stage("shade", [&] {
        for_each_texel(picture_size, step, [&](glm::ivec2 pixel) {
            picture[pixel] = example::to_srgb(mean<glm::vec3>(pixel, o.samples, [&](glm::ivec2 t) {
                if (seen[t] == example::nothing) return background;
                const example::surface s = example::surface_at(scene, camera, seen, t);
                return umbrage::diffuse_ambient(s.colour, ambient, glm::dot(s.normal, light.to_light(s.position)),
                                                visibility[t] * light.cone(s.position));
            }));
        });
    });

    // 8. What people look at.
    progress.stage("write", [&] {
        const auto save = [&](const char* name, const auto& image) { example::write_png(o.output / name, image.view()); };
        constexpr auto no_step = [] {};

        umbrage::image<decltype(bytes(map[{}]))> packed(map_size);
        for_each_texel(map_size, no_step, [&](glm::ivec2 t) { packed[t] = bytes(map[t]); });
        save("map.png", std::as_const(packed));

        umbrage::image<float> stored(map_size);
        umbrage::decode(std::as_const(map).view(), stored.view(), encoding);
        const umbrage::contrast_stretch stretch = umbrage::stretch(stored, encoding.decode(encoding.encode(1.0f)));
        umbrage::image<glm::u8vec3> colours(map_size);
        for_each_texel(map_size, no_step, [&](glm::ivec2 t) {
            colours[t] = umbrage::store_unorm8(umbrage::false_colour(stretch(stored[t])));
        });
        save("depth.png", std::as_const(colours));

        umbrage::image<std::uint8_t> mask(picture_size);
        for_each_texel(picture_size, no_step, [&](glm::ivec2 pixel) {
            mask[pixel] = umbrage::store_unorm8(mean<float>(pixel, o.samples, [&](glm::ivec2 t) { return visibility[t]; }));
        });
        save("visibility.png", std::as_const(mask));

        umbrage::overlay(picture, stored,
                         {.size = glm::ivec2(std::min(o.width, o.height) / 4), .map_origin = light.space.clip.origin}, stretch);
        save("picture.png", std::as_const(picture));
    });

    if (o.quiet) return;
    progress.print_times();
    std::printf("%zu triangles, %d x %d texels of %s: picture.png, map.png, depth.png and visibility.png in %s\n",
                scene.geometry.triangles.size(), o.map_size, o.map_size, o.encoding.c_str(), o.output.string().c_str());
}

void run(const options& o) {
    const example::scene scene = o.mesh.empty() ? example::default_scene()
                                                : example::on_floor(example::load_mesh(o.mesh), o.up);
    std::error_code error;
    std::filesystem::create_directories(o.output, error);
    if (!std::filesystem::is_directory(o.output)) throw std::runtime_error("cannot make the folder " + o.output.string());
    example::with_encoding(o.encoding, o.edge, [&](auto encoding, float below) { render(o, scene, encoding, below); });
}

}  // namespace
}  // namespace shadow_render

int main(int argc, char** argv) {
    return example::run("shadow_render", [&] {
        if (const auto options = shadow_render::parse_options(argc, argv)) shadow_render::run(*options);
    });
}
