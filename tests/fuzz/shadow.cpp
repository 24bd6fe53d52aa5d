// SPDX-License-Identifier: MIT
//
// A shadow of any light: visibilities lie within 0 and 1, images have the bits of points, uniforms are finite, and an
// empty map casts no shadow.
#include <array>
#include <vector>

#include <umbrage/umbrage.hpp>

#include "input.hpp"

namespace {

using namespace umbrage;

void try_shadow(fuzz::input& in, const auto& of) {
    using texel = typename std::decay_t<decltype(of)>::texel;
    const auto uniforms = of.uniforms();
    std::array<float, sizeof uniforms / sizeof(float)> floats;
    std::memcpy(floats.data(), &uniforms, sizeof uniforms);
    for (const float f : floats) fuzz::must(is_finite(f), "a uniform is finite");

    std::vector<glm::vec3> positions(12);
    for (glm::vec3& p : positions) p = in.vec3(-8, 8);
    const std::vector<glm::uvec3> triangles{{0, 1, 2}, {3, 4, 5}, {6, 7, 8}, {9, 10, 11}, {0, 4, 8}};
    image<float> depths(of.size(), cleared_depth(of.setup().clip()));
    of.draw(depths, {positions, triangles});
    image<texel> map(of.size());
    of.store(depths, map);
    const glm::ivec2 size(8, 2);
    image<glm::vec3> points(size), normals(size);
    image<float> out(size);
    for (glm::vec3& p : points.texels()) p = in.vec3(-12, 12);
    for (glm::vec3& n : normals.texels()) n = in.vec3(-1, 1);
    of.visibility(map, points, normals, out);
    const image<texel> empty(of.size(), of.cleared());
    for (glm::ivec2 p(0); p.y < size.y; ++p.y)
        for (p.x = 0; p.x < size.x; ++p.x) {
            const float one = of(map, points[p], normals[p], p);
            fuzz::must(one >= 0.0f && one <= 1.0f, "a visibility lies within 0 and 1");
            fuzz::must(one == out[p], "an image's receiver has the bits of a point");
            fuzz::must(of(empty, points[p], normals[p], p) == 1.0f, "an empty map casts no shadow");
        }
}

void with_filter(fuzz::input& in, const auto& light, glm::ivec2 map_size) {
    switch (in.within(0, 5)) {
        case 0: return try_shadow(in, shadow(light, map_size, filters::hard{}));
        case 1: return try_shadow(in, shadow(light, map_size, filters::tent<3>, rg<11>{}));
        case 2: return try_shadow(in, shadow(light, map_size, filters::box{in.within(0, 3)}));
        case 3:
            return try_shadow(in,
                              shadow(light, map_size, filters::disc{.points = 8, .radius_texels = in.number(0, 4)}));
        case 4: {
            const float low = static_cast<float>(in.within(-1, 32));
            const penumbra_params soft{.per_code_x = in.number(0, 1),
                                       .per_code_y = in.number(0, 1),
                                       .min_radius = low,
                                       .max_radius = low + static_cast<float>(in.within(-1, 64)),
                                       .light_size = in.number(-1, 9)};
            return try_shadow(in,
                              shadow(light, map_size, filters::pcss{.points = 8 * in.within(0, 4), .softness = soft}));
        }
        default: return try_shadow(in, shadow(light, map_size, filters::castano<5>, depth32f{}));
    }
}

/// Point light in maps of its own kind.
template <class Light>
Light at_point(fuzz::input& in, glm::vec3 position, int side, const clip_space& clip) {
    return {.position = position,
            .z_near = in.number(0.1f, 1),
            .z_far = in.number(5, 50),
            .map_size = side,
            .border = in.within(0, 8),
            .clip = clip};
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    fuzz::input in(bytes, size);
    const clip_space clip = in.clip();
    const int side = in.within(0, 48);
    const glm::vec3 position = in.vec3(-9, 9), direction = in.vec3(-1, 1);
    fuzz::answered([&] {
        switch (in.within(0, 4)) {
            case 0:
                return with_filter(in,
                                   make_spot_light<float>({.position = position,
                                                           .direction = direction,
                                                           .outer_angle_radians = in.number(0.1f, 1.5f),
                                                           .z_near = in.number(0.1f, 1),
                                                           .z_far = in.number(5, 50),
                                                           .clip = clip}),
                                   {side, in.within(0, 48)});
            case 1:
                return with_filter(
                    in,
                    fit_directional_light<float>({.direction = direction,
                                                  .receivers = bounding_box<float>{glm::vec3(-8), glm::vec3(8)},
                                                  .casters = bounding_box<float>{glm::vec3(-8), glm::vec3(8)},
                                                  .clip = clip}),
                    {side, in.within(0, 48)});
            case 2: return with_filter(in, at_point<point_light<float>>(in, position, side, clip), glm::ivec2(side));
            case 3:
                return with_filter(in, at_point<tetrahedron_light<float>>(in, position, side, clip), glm::ivec2(side));
            default: {
                const cascade_fit<float> fit{
                    .camera = {.position = position, .direction = in.vec3(-1, 1), .z_near = 0.5f, .z_far = 40},
                    .direction = direction,
                    .scene = {glm::vec3(-8), glm::vec3(8)},
                    .map_size = {side, side},
                    .margin = in.number(0, 4),
                    .clip = clip};
                return with_filter(in, make_stable_cascades<3>(fit, practical_splits<3>(0.5f, 40.0f, 0.7f)),
                                   {side, side});
            }
        }
    });
    return 0;
}
