// SPDX-License-Identifier: MIT
#include <cmath>
#include <string>
#include <vector>

#include <umbrage/bias/acne_free.hpp>
#include <umbrage/bias/slope.hpp>
#include <umbrage/depth/conversions.hpp>
#include <umbrage/draw/rasterize.hpp>
#include <umbrage/filter/pcf/windows.hpp>
#include <umbrage/light/spot_light.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include <progress.hpp>
#include <scene.hpp>

#include <render.hpp>
#include <shade.hpp>

#include "pages.hpp"

namespace pictures {
namespace {

constexpr float z_far = 20;
constexpr glm::ivec2 map_size{1024};

/// What a map holds of a depth.
struct storage {
    std::vector<std::string> words;
    int bits;
    float z_near = 1;
    bool linear = false;

    /// z/w, or linear depth, without a loss.
    [[nodiscard]] float depth(float perspective) const {
        if (!linear) return perspective;
        return umbrage::linear_depth(umbrage::view_z_from_depth(perspective, z_near, z_far), 1 / z_far);
    }
    [[nodiscard]] float stored(float perspective) const {
        const float codes = std::ldexp(1.0f, bits);
        return std::floor(depth(perspective) * codes) / codes;
    }
};

/// Visibility of each sample. The bias covers slopes, and no loss of digits: steps and acne are those of the storage.
umbrage::image<float> visibility(const shadow_render::view& v, const storage& kept) {
    const auto light = umbrage::make_spot_light<float>({.position = v.lamp.position,
                                                        .direction = v.lamp.direction,
                                                        .outer_angle_radians = 0.5f,
                                                        .z_near = kept.z_near,
                                                        .z_far = z_far,
                                                        .clip = example::picture_clip});
    umbrage::image<float> map(map_size, 1.0f);
    umbrage::rasterize_depth(map.view(), view_of(v.scene.geometry), light.projection * light.view, light.clip);
    for (float& depth : map.texels()) depth = depth < 1 ? kept.stored(depth) : 1.0f;

    const glm::mat4 to_texels = umbrage::texture_matrix(light, map_size), planes = umbrage::plane_matrix(to_texels);
    umbrage::image<float> out(v.seen.size(), 1.0f);
    for (int y = 0; y < out.size().y; ++y)
        example::for_each_run(v.seen, y, [&](int first, int last, std::uint32_t triangle) {
            const example::seen_triangle on = v.triangle(triangle);
            for (int x = first; x < last; ++x) {
                const glm::vec3 world = on.position(on.weights({x, y}));
                const glm::vec3 at = umbrage::project_coordinate(umbrage::shadow_coordinate(to_texels, world));
                const glm::vec2 slope = umbrage::receiver_slope(planes, on.face_normal(world), world);
                const float receiver = kept.depth(at.z - umbrage::acne_free_bias(slope, 2.5f, 0x1p-18f));
                out[{x, y}] = umbrage::tent<3>(umbrage::bordered(map), glm::vec2(at), receiver);
            }
        });
    return out;
}

}  // namespace

picture depth_strip(int side) {
    const std::vector<storage> all{
        {{"8 bits", "z/w, near 1"}, 8},           {{"11 bits", "z/w, near 1"}, 11},
        {{"16 bits", "z/w, near 1"}, 16},         {{"24 bits", "z/w, near 1"}, 24},
        {{"z/w", "11 bits, near 0.1"}, 11, 0.1f}, {{"linear", "11 bits, near 0.1"}, 11, 0.1f, true},
        {{"z/w", "8 bits, near 1"}, 8},           {{"linear", "8 bits, near 1"}, 8, 1, true},
        {{"near 3", "11 bits, z/w"}, 11, 3},      {{"near 1", "11 bits, z/w"}, 11, 1},
        {{"near 0.1", "11 bits, z/w"}, 11, 0.1f}, {{"near 0.01", "11 bits, z/w"}, 11, 0.01f}};
    constexpr int columns = 4, gap = 8;
    shadow_render::options o;
    o.quiet = true;
    o.light = shadow_render::light_kind::spot;
    o.samples = 2;
    o.width = side, o.height = side * 3 / 4;
    o.target = glm::vec3(1.5f, 0.6f, -0.8f), o.fov = 16;
    const example::scene scene = example::default_scene();
    example::progress progress(20, true);
    const shadow_render::view v = make_view(o, scene, progress);
    const glm::ivec2 cell(side + gap, o.height + gap + 2 * canvas::line);
    canvas page({columns * cell.x + gap, static_cast<int>(all.size()) / columns * (cell.y + gap)});
    for (int i = 0; const storage& kept : all) {
        glm::ivec2 at = glm::ivec2(i % columns, i / columns) * glm::ivec2(cell.x, cell.y + gap) + gap;
        for (const std::string& words : kept.words) {
            page.write(words, at, &words == &kept.words.front() ? ink : pale_ink);
            at.y += canvas::line;
        }
        page.paste(shade(v, visibility(v, kept), o.samples, progress.bands()), at);
        ++i;
    }
    return page.pixels();
}

}  // namespace pictures
