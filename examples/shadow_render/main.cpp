// SPDX-License-Identifier: MIT
//
// From a mesh to a shadowed picture, every step a primitive:
//
//     light -> depth pass -> encode -> [map] -> fetch -> decode -> compare -> filter -> visibility -> shade
//
// Start reading at render(). The filter is chosen in with_filter(); the bias is in view.hpp.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <utility>

#include <umbrage/images/encode.hpp>
#include <umbrage/images/rasterize.hpp>
#include <umbrage/images/visibility.hpp>
#include <umbrage/shade/lighting.hpp>
#include <umbrage/view/false_colour.hpp>
#include <umbrage/images/overlay.hpp>

#include <camera.hpp>
#include <command_line.hpp>
#include <encodings.hpp>
#include <png.hpp>
#include <progress.hpp>
#include <scene.hpp>

#include "options.hpp"
#include "view.hpp"

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

/// Diffuse plus ambient light, inside the cone.
template <class Step>
umbrage::image<glm::u8vec3> shade(const options& o, const view& v, const umbrage::image<float>& visibility,
                                  Step&& step) {
    umbrage::image<glm::u8vec3> picture({o.width, o.height});
    for_each_texel(picture.size(), step, [&](glm::ivec2 pixel) {
        picture[pixel] = example::to_srgb(mean<glm::vec3>(pixel, o.samples, [&](glm::ivec2 t) {
            if (v.empty(t)) return background;
            const example::surface s = v.at(t);
            return umbrage::diffuse_ambient(s.colour, ambient, glm::dot(s.normal, v.lamp.to_light(s.position)),
                                            visibility[t] * v.lamp.cone(s.position));
        }));
    });
    return picture;
}

/// The bytes of a texel as image viewers can show them: missing channels are 0.
glm::u8vec3 bytes(glm::u8vec2 texel) { return {texel, 0}; }
glm::u8vec3 bytes(glm::u8vec3 texel) { return texel; }
glm::u8vec4 bytes(glm::u8vec4 texel) { return texel; }
glm::u8vec4 bytes(float texel) { return umbrage::encode_float_bits(texel); }

template <class Texel>
void write_map(const options& o, const umbrage::image<Texel>& map) {
    umbrage::image<decltype(bytes(Texel{}))> packed(map.size());
    std::ranges::transform(map.texels(), packed.texels().begin(), [](Texel t) { return bytes(t); });
    example::write_png(o.output / "map.png", std::as_const(packed).view());
}

/// What people look at; `depth` is the map decoded, `cleared` what its empty texels decode to.
void write(const options& o, const umbrage::image<float>& depth, float cleared, const umbrage::image<float>& visibility,
           umbrage::image<glm::u8vec3> picture) {
    const umbrage::contrast_stretch stretch = umbrage::stretch(depth, cleared);
    umbrage::image<glm::u8vec3> colours(depth.size());
    std::ranges::transform(depth.texels(), colours.texels().begin(), [&](float d) {
        return umbrage::store_unorm8(umbrage::false_colour(stretch(d)));
    });
    umbrage::image<std::uint8_t> mask(picture.size());
    for_each_texel(mask.size(), [] {}, [&](glm::ivec2 pixel) {
        mask[pixel] = umbrage::store_unorm8(mean<float>(pixel, o.samples, [&](glm::ivec2 t) { return visibility[t]; }));
    });
    const int corner = std::min(o.width, o.height) / 4;
    if (corner > 0)
        umbrage::overlay(picture, depth, {.size{corner, corner}, .map_origin = example::picture_clip.origin}, stretch);

    example::write_png(o.output / "depth.png", std::as_const(colours).view());
    example::write_png(o.output / "visibility.png", std::as_const(mask).view());
    example::write_png(o.output / "picture.png", std::as_const(picture).view());
}

/// The whole way, in order.
template <class Encoding>
void render(const options& o, const example::scene& scene, Encoding encoding, float below) {
    const glm::ivec2 map_size(o.map_size), sample_size = glm::ivec2(o.width, o.height) * o.samples;
    example::progress progress(3 * static_cast<unsigned>(sample_size.y) + static_cast<unsigned>(o.height), o.quiet);
    const auto step = [&] { progress.step(); };

    // Light and camera: how they see the world.
    view view{.scene = scene, .lamp = make_light(o, scene), .camera = make_camera(o, scene), .seen{}};

    // Depth pass: the distance to what the light sees first.
    umbrage::image<float> depth(map_size, umbrage::cleared_depth(view.lamp.space.clip));
    progress.stage("depth pass", [&] {
        umbrage::rasterize_depth(depth, example::view_of(scene.geometry), view.lamp.world_to_clip(),
                                 view.lamp.space.clip);
        for (float& d : depth.texels()) d = view.lamp.even_depth(d);
    });

    // Encode: depths become the texels that a render target would hold.
    umbrage::image<typename Encoding::texel> map(map_size);
    progress.stage("encode", [&] { umbrage::encode(std::as_const(depth).view(), map.view(), encoding); });

    // Camera pass: the triangle behind each sample, and where that looks into the map.
    progress.stage("camera pass", [&] {
        view.seen = example::camera_pass(scene.geometry, view.camera, sample_size);
        progress.step(static_cast<unsigned>(sample_size.y));
    });
    const auto receivers = progress.stage("receivers", [&] {
        const float bias = o.bias.value_or(with_filter(o, [](auto, float reach) { return automatic_bias(reach); }));
        return receivers_of(view, o.map_size, bias, below, step);
    });

    // Visibility: fetch, decode, compare, filter; a row at a time, to show progress.
    umbrage::image<float> visibility(sample_size);
    progress.stage("visibility", [&] {
        with_filter(o, [&](auto filter, float) {
            for (int y = 0; y < sample_size.y; ++y, step())
                umbrage::visibility(std::as_const(map).view(), encoding, receivers.view().rows(y, y + 1), filter,
                                    visibility.view().rows(y, y + 1));
        });
    });

    // Shade.
    auto picture = progress.stage("shade", [&] { return shade(o, view, visibility, step); });

    progress.stage("write", [&] {
        write_map(o, map);
        umbrage::decode(std::as_const(map).view(), depth.view(), encoding);
        write(o, depth, encoding.decode(encoding.encode(1.0f)), visibility, std::move(picture));
    });
    if (!o.quiet) progress.print_times();
}

void run(const options& o) {
    const example::scene scene = o.mesh.empty() ? example::default_scene()
                                                : example::on_floor(example::load_mesh(o.mesh), o.up);
    std::error_code error;
    std::filesystem::create_directories(o.output, error);
    if (!std::filesystem::is_directory(o.output))
        throw std::runtime_error("cannot make the folder " + o.output.string());
    example::with_encoding(o.encoding, o.edge, [&](auto encoding, float below) { render(o, scene, encoding, below); });
    if (!o.quiet)
        std::printf("%zu triangles, %d x %d texels of %s: picture.png, map.png, depth.png and visibility.png in %s\n",
                    scene.geometry.triangles.size(), o.map_size, o.map_size, o.encoding.c_str(),
                    o.output.string().c_str());
}

}  // namespace
}  // namespace shadow_render

int main(int argc, char** argv) {
    return example::run("shadow_render", [&] {
        if (const auto options = shadow_render::parse_options(argc, argv)) shadow_render::run(*options);
    });
}
