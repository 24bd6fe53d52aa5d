// SPDX-License-Identifier: MIT
//
// What the four programs share around the shadow map: options, the camera's picture, files. The shadow map itself,
// from light to visibility, is written out in each program.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <umbrage/images/rasterize.hpp>
#include <umbrage/unorm.hpp>
#include <umbrage/images/overlay.hpp>

#include <camera.hpp>
#include <command_line.hpp>
#include <png.hpp>
#include <systems.hpp>

#include "rays.hpp"

namespace example {

struct options {
    std::filesystem::path output = "out", mesh{};
    float azimuth = 0, elevation = 0;
    int size = 960, map_size = 0;
    float lift = 0;
    bool rays = false;
};

/// Nothing when only help was asked for. `more` may add options of the program's own.
template <class More>
std::optional<options> read_options(const shadow_system& s, int argc, char** argv, More&& more) {
    options o{.azimuth = s.azimuth, .elevation = s.elevation, .map_size = s.map_size, .lift = s.lift};
    CLI::App app{std::string(s.title), std::string(s.name)};
    app.option_defaults()->always_capture_default();
    app.add_option("mesh", o.mesh, "OBJ, glTF or PLY file; without one, the built-in scene");
    app.add_option("-o,--output", o.output, "folder for the pictures, made when missing");
    app.add_option("--azimuth", o.azimuth, "of the light, degrees")->check(within(-360, 360));
    app.add_option("--elevation", o.elevation, "90 is straight above")->check(within(5, 90));
    app.add_option("--size", o.size, "width of the picture, pixels; its height is two thirds")->check(within(3, 4096));
    app.add_option("--map-size", o.map_size, "texels along an edge")->check(within(16, 8192));
    app.add_option("--lift", o.lift, "texels along the normal; 0 leaves the original's bias alone")->check(within(0, 16));
    app.add_flag("--rays", o.rays, "compare the shadow with rays to the light; fails where they disagree");
    more(app);
    if (!parse(app, argc, argv)) return std::nullopt;
    return o;
}
inline std::optional<options> read_options(const shadow_system& s, int argc, char** argv) {
    return read_options(s, argc, argv, [](CLI::App&) {});
}

using picture = umbrage::image<glm::u8vec3>;

/// The scene and what the camera sees of it.
struct stage {
    example::scene scene;
    example::camera camera;
    umbrage::image<std::uint32_t> seen;  ///< triangle behind each pixel

    stage(const shadow_system& s, const options& o)
        : scene(make_scene(s, o.mesh)),
          camera(make_camera(make_camera_setup(s, scene, 1.5f))),
          seen(camera_pass(scene.geometry, camera, {o.size, o.size * 2 / 3})) {
        std::error_code error;
        std::filesystem::create_directories(o.output, error);
        if (!std::filesystem::is_directory(o.output))
            throw std::runtime_error("cannot make the folder " + o.output.string());
    }

    /// Calls use(pixel, surface) wherever the camera sees one.
    template <class Use>
    void for_each_surface(Use&& use) const {
        for (glm::ivec2 pixel{0}; pixel.y < seen.size().y; ++pixel.y)
            for (pixel.x = 0; pixel.x < seen.size().x; ++pixel.x)
                if (seen[pixel] != nothing) use(pixel, surface_at(scene, camera, seen, pixel));
    }

    /// An image of lit(surface); 1 where the camera sees nothing.
    template <class Lit>
    [[nodiscard]] umbrage::image<float> visibility(Lit&& lit) const {
        umbrage::image<float> out(seen.size(), 1.0f);
        for_each_surface([&](glm::ivec2 pixel, const surface& s) { out[pixel] = lit(s); });
        return out;
    }

    /// The surfaces' colours under the light.
    [[nodiscard]] picture shade(const shadow_system& s, const light& l, const umbrage::image<float>& visibility) const {
        picture out(seen.size(), to_srgb(sky));
        for_each_surface([&](glm::ivec2 pixel, const surface& at) {
            const glm::vec3 colour = at.colour * (s.textured ? texture(at.position) : 1.0f);
            out[pixel] = to_srgb(example::shade(s, colour, at.normal, l.to_light(at.position), visibility[pixel]));
        });
        return out;
    }
};

/// The depth pass: the distance to what the light sees first, in the system's kind of depth.
[[nodiscard]] inline umbrage::image<float> depth_pass(const shadow_system& s, const scene& scene, const light& l, int map_size) {
    umbrage::image<float> depth(glm::ivec2(map_size), umbrage::cleared_depth(l.space.clip));
    umbrage::rasterize_depth(depth, view_of(scene.geometry), l.world_to_clip(), l.space.clip);
    for (float& z : depth.texels()) z = l.depth(s, z);
    return depth;
}

/// The map in the top left corner, its histogram stretched.
inline void show_map(picture& on, const umbrage::image<float>& depth) {
    const int edge = std::max(1, on.size().y * 3 / 10);
    umbrage::overlay(on, depth, {.size{edge, edge}, .map_origin = picture_clip.origin}, umbrage::stretch(depth));
}

/// Pictures of one size in a row.
[[nodiscard]] inline picture side_by_side(std::span<const picture> pictures) {
    const glm::ivec2 size = pictures.front().size();
    picture out({size.x * static_cast<int>(pictures.size()), size.y});
    for (int i = 0; i < static_cast<int>(pictures.size()); ++i)
        for (int y = 0; y < size.y; ++y)
            std::copy_n(pictures[static_cast<std::size_t>(i)].view().row(y), size.x, out.view().row(y) + i * size.x);
    return out;
}

[[nodiscard]] inline picture grey(const umbrage::image<float>& values) {
    picture out(values.size());
    std::ranges::transform(values.texels(), out.texels().begin(),
                           [](float v) { return glm::u8vec3(umbrage::store_unorm8(v)); });
    return out;
}

inline void write(const options& o, const char* name, const picture& p) {
    write_png(o.output / name, p.view());
}

/// picture.png, visibility.png and, its histogram stretched, depth.png.
inline void write(const options& o, const picture& p, const umbrage::image<float>& visibility,
                  umbrage::image<float> depth) {
    write(o, "picture.png", p);
    write(o, "visibility.png", grey(visibility));
    std::ranges::transform(depth.texels(), depth.texels().begin(), umbrage::stretch(depth));
    write(o, "depth.png", grey(depth));
}

/// --rays: whether a shadow is where it belongs.
/// @param reach  how far from its edges the filter and the lift may move it, texels
/// @throws std::runtime_error  it is not
inline void compare_with_rays(const stage& on, const light& l, const umbrage::image<float>& visibility, int map_size,
                              float reach) {
    const ray_tracer rays(on.scene.geometry);
    int certain = 0, shadow = 0, leaks = 0, acne = 0;
    on.for_each_surface([&](glm::ivec2 pixel, const surface& s) {
        const glm::vec3 way = l.to_light(s.position);
        if (glm::dot(s.face_normal, way) < 0.05f || l.cone(s.position) == 0) return;  // dark without any shadow
        const float step = reach * l.texel_world(s.position, map_size);
        const glm::vec3 side = glm::normalize(glm::cross(way, s.face_normal + glm::vec3(0.1f, 0.2f, 0.3f)));
        const glm::vec3 across = glm::cross(way, side);
        const glm::vec3 start = s.position + s.face_normal * (1.5f * step);  // no ray aside begins below the surface
        const float distance = l.spot ? glm::length(l.position - s.position) : 1e3f;
        const auto blocked = [&](float i, float j) {
            return rays.blocked(start + step * (way + i * side + j * across), way, distance - 2 * step);
        };
        const bool dark = rays.blocked(s.position + 0.001f * s.face_normal, way, distance);
        for (float i = -1; i <= 1; i += 0.5f)
            for (float j = -1; j <= 1; j += 0.5f)
                if (blocked(i, j) != dark) return;  // near an edge
        ++certain;
        shadow += dark;
        leaks += dark && visibility[pixel] > 0.5f;
        acne += !dark && visibility[pixel] < 0.5f;
    });
    std::printf("rays: %d pixels away from edges, %d of them in shadow; lit there %d, dark elsewhere %d\n", certain, shadow,
                leaks, acne);
    if (shadow == 0 || certain == shadow || (leaks + acne) * 500 > certain)
        throw std::runtime_error("the shadow map disagrees with rays to the light");
}

}  // namespace example
