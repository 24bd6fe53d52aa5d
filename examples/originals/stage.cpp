// SPDX-License-Identifier: MIT
#include "stage.hpp"

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <system_error>
#include <utility>

#include <umbrage/core/unorm.hpp>
#include <umbrage/debug/overlay.hpp>
#include <umbrage/depth/quantize.hpp>
#include <umbrage/draw/rasterize.hpp>
#include <umbrage/filter/filters.hpp>

#include <choices.hpp>
#include <command_line.hpp>
#include <png.hpp>
#include <shadow_map.hpp>
#include <srgb.hpp>

namespace example {

std::optional<options> read_options(const shadow_system& s, int argc, char** argv,
                                    const std::function<void(CLI::App&)>& more) {
    options o{.azimuth = s.azimuth,
              .elevation = s.elevation,
              .map_size = s.map_size,
              .epsilon = s.epsilon,
              .encoding = std::string(s.encoding),
              .filter = std::string(s.filter)};
    CLI::App app{std::string(s.title), std::string(s.name)};
    app.option_defaults()->always_capture_default();
    add_mesh(app, "mesh", o.mesh);
    app.add_option("-o,--output", o.output, "folder for the pictures, made when missing");
    app.add_option("--azimuth", o.azimuth, "of the light, degrees")->check(within(-360, 360));
    app.add_option("--elevation", o.elevation, "90 is straight above")->check(within(5, 90));
    app.add_option("--size", o.size, "width of the picture, pixels; its height is two thirds")->check(within(3, 4096));
    add_size(app, "--map-size", o.map_size, "texels of the map: 512, or 480x320", 16, 8192);
    app.add_option("--reach", o.reach,
                   "texels that a normal offset covers; 0 leaves the original's bias alone, without it they are what "
                   "the filter's own reach asks for")
        ->check(within(0, 16));
    app.add_option("--epsilon", o.epsilon, "constant bias, in the map's depth from 0 to 1")->check(within(-1, 1));
    add_encoding(app, o.encoding)
        ->description("how a depth is stored; all but the original's own are decoded by their readers");
    add_filter(app, o.filter);
    app.add_flag("--rays", o.rays, "compare the shadow with rays to the light; fails where they disagree");
    if (more) more(app);
    if (!parse(app, argc, argv)) return std::nullopt;
    return o;
}
int run_original(const shadow_system& s, int argc, char** argv, const std::function<void(const options&)>& program) {
    return run(std::string(s.name).c_str(), [&] {
        if (const auto o = read_options(s, argc, argv)) program(*o);
    });
}

stage::stage(const shadow_system& s, const options& o)
    : scene(make_scene(s, o.mesh)),
      camera(make_camera(make_camera_setup(s, scene, 1.5f))),
      seen(camera_pass(scene.geometry, camera, {o.size, o.size * 2 / 3})) {
    std::error_code error;
    std::filesystem::create_directories(o.output, error);
    if (!std::filesystem::is_directory(o.output))
        throw std::runtime_error("cannot make the folder " + o.output.string());
}

stage stage::before(example::scene front) const {
    stage out = *this;
    mesh all = scene.geometry;
    const auto behind = static_cast<std::uint32_t>(all.triangles.size());
    append(all, front.geometry, glm::mat4(1));
    out.seen = camera_pass(all, camera, seen.size());
    for (std::uint32_t& triangle : out.seen.texels())
        triangle = triangle == nothing || triangle < behind ? nothing : triangle - behind;
    out.scene = std::move(front);
    return out;
}

picture stage::shade(const shadow_system& s, const light& l, const umbrage::image<float>& visibility) const {
    picture out(seen.size(), to_srgb(sky));
    for_each_surface([&](glm::ivec2 pixel, const surface& at) {
        const glm::vec3 color = at.color * (s.textured ? texture(at.position) : 1.0f);
        out[pixel] = to_srgb(example::shade(s, color, at.normal, l.to_light(at.position), visibility[pixel]));
    });
    return out;
}

umbrage::image<float> depth_pass(const shadow_system& s, const scene& scene, const light& l) {
    umbrage::image<float> depth(s.map_size, umbrage::cleared_depth(l.space.clip));
    umbrage::rasterize_depth(depth, view_of(scene.geometry), l.world_to_clip(), l.space.clip);
    for (float& z : depth.texels()) z = l.depth(s, z);
    return depth;
}

umbrage::image<float> stored(const shadow_system& s, const light& l, const umbrage::image<float>& depth) {
    const float empty = l.depth(s, umbrage::cleared_depth(l.space.clip));
    return store(s.encoding, umbrage::upper_edge<float>, depth, empty).depth;
}

float filtered(const shadow_system& s, const std::function<float(glm::ivec2)>& fetch, glm::vec2 coord, float receiver) {
    float visibility = 1;
    umbrage::with_filter(s.filter, [&](const auto& filter) { visibility = filter(fetch, coord, receiver); });
    return visibility;
}

void show_map(picture& on, const umbrage::image<float>& depth) {
    const glm::ivec2 size = overlay_size(depth.size(), on.size().y);
    umbrage::overlay(on, depth, {.size = size, .map_origin = picture_clip.origin}, umbrage::stretch(depth));
}

void blend(picture& over, const stage& seen, const picture& with, float alpha) {
    seen.for_each_surface([&](glm::ivec2 pixel, const surface&) {
        over[pixel] = glm::u8vec3(glm::mix(glm::vec3(over[pixel]), glm::vec3(with[pixel]), alpha) + 0.5f);
    });
}

picture side_by_side(std::span<const picture> pictures) {
    const glm::ivec2 size = pictures.front().size();
    picture out({size.x * static_cast<int>(pictures.size()), size.y});
    for (int i = 0; i < static_cast<int>(pictures.size()); ++i)
        for (int y = 0; y < size.y; ++y)
            std::copy_n(pictures[static_cast<std::size_t>(i)].view().row(y), size.x, out.view().row(y) + i * size.x);
    return out;
}

picture gray(const umbrage::image<float>& values) {
    picture out(values.size());
    std::ranges::transform(values.texels(), out.texels().begin(),
                           [](float v) { return glm::u8vec3(umbrage::store_unorm(v)); });
    return out;
}

void write(const options& o, const char* name, const picture& p) { write_png(o.output / name, p.view()); }

void write(const options& o, const picture& p, const umbrage::image<float>& visibility, umbrage::image<float> depth) {
    write(o, "picture.png", p);
    write(o, "visibility.png", gray(visibility));
    std::ranges::transform(depth.texels(), depth.texels().begin(), umbrage::stretch(depth));
    write(o, "depth.png", gray(depth));
}

}  // namespace example
