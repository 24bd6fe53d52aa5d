// SPDX-License-Identifier: MIT
//
// A shadow as one object against its parts called by hand: what the door costs.
#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/bias/acne_free.hpp>
#include <umbrage/bias/constant.hpp>
#include <umbrage/bias/slope.hpp>
#include <umbrage/images/visibility.hpp>
#include <umbrage/light/cascades/splits.hpp>
#include <umbrage/light/spot_light.hpp>
#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/shadow/cascaded_maps.hpp>
#include <umbrage/shadow/shadow.hpp>
#include <umbrage/shadow/single_map.hpp>

#include "bench.hpp"
#include "data.hpp"

namespace {

using umbrage::image;
using umbrage::outside_map;

/// A floor under hovering squares, and points all over it.
struct squares {
    std::vector<glm::vec3> vertices;
    std::vector<glm::uvec3> triangles;
    image<glm::vec3> points{bench::screen}, normals{bench::screen, glm::vec3(0, 1, 0)};
    image<float> ours{bench::screen}, theirs{bench::screen};

    squares() {
        add({-20, 0, -20}, 40);
        for (float x = -15; x < 15; x += 3)
            for (float z = -15; z < 15; z += 3) add({x, 1, z}, 1.5f);
        for (glm::ivec2 p(0); p.y < bench::screen.y; ++p.y)
            for (p.x = 0; p.x < bench::screen.x; ++p.x)
                points[p] = {30.0f * float(p.x) / 1920.0f - 15.0f, 0, 30.0f * float(p.y) / 1080.0f - 15.0f};
    }
    void add(glm::vec3 corner, float side) {
        const auto first = static_cast<unsigned>(vertices.size());
        for (const glm::vec2 at : {glm::vec2(0, 0), glm::vec2(side, 0), glm::vec2(side, side), glm::vec2(0, side)})
            vertices.push_back(corner + glm::vec3(at.x, 0, at.y));
        triangles.emplace_back(first, first + 1, first + 2);
        triangles.emplace_back(first, first + 2, first + 3);
    }
    [[nodiscard]] bool same() const { return std::ranges::equal(ours.texels(), theirs.texels()); }
};

constexpr glm::ivec2 map_size(1024);
constexpr const auto& tent = umbrage::filters::tent<3>;

const bench::registration rows([] {
    using namespace umbrage;
    const auto s = std::make_shared<squares>();
    const auto light = make_spot_light<double>({.position = {1, 25, 2},
                                                .direction = {0, -1, 0},
                                                .outer_angle_radians = 0.7,
                                                .z_near = 5,
                                                .z_far = 40,
                                                .clip = cpu_clip_space});
    const shadow spot(light, map_size, tent);
    const auto map = std::make_shared<image<float>>(spot.size(), spot.cleared());
    spot.draw(*map, {s->vertices, s->triangles});

    const anchored_map lamp = make_anchored_map(light, map_size);
    const float reach = tent.reach(), error = -0x1p-23f;
    const auto receiver = [=](glm::vec3 world, glm::vec3 normal) {
        const glm::vec3 way = world - glm::vec3(lamp.anchor);
        const map_place place = anchored_place(lamp.to_texels, lamp.planes, lamp.rounding, lamp.slack, way, normal);
        const float bias = acne_free_bias(place.slope, reach, error + place.slack);
        return glm::vec3(place.at.x, place.at.y, biased(place.at.z, bias));
    };
    bench::add({.work = "shadow, spot, tent 3, whole image 1920 x 1080",
                .peer = "the parts by hand",
                .items = bench::pixels,
                .ours = [=] { spot.visibility(*map, s->points, s->normals, s->ours); },
                .theirs =
                    [=] {
                        image<glm::vec3> receivers(bench::screen);
                        for (glm::ivec2 p(0); p.y < bench::screen.y; ++p.y)
                            for (p.x = 0; p.x < bench::screen.x; ++p.x)
                                receivers[p] = receiver(s->points[p], s->normals[p]);
                        visibility(*map, depth32f{}, receivers, tent, s->theirs);
                    },
                .agree = [s] { return s->same(); }});

    const auto each_point = [s](image<float>& out, const auto& visibility_at) {
        for (glm::ivec2 p(0); p.y < bench::screen.y; ++p.y)
            for (p.x = 0; p.x < bench::screen.x; ++p.x) out[p] = visibility_at(s->points[p], s->normals[p]);
    };
    bench::add(
        {.work = "shadow, spot, tent 3, 1920 x 1080 points one by one",
         .peer = "the parts by hand",
         .items = bench::pixels,
         .ours =
             [=] { each_point(s->ours, [&](glm::vec3 world, glm::vec3 normal) { return spot(*map, world, normal); }); },
         .theirs =
             [=] {
                 const auto fetch = decoded(bordered(*map), depth32f{});
                 each_point(s->theirs, [&](glm::vec3 world, glm::vec3 normal) {
                     const glm::vec3 at = receiver(world, normal);
                     return tent(fetch, glm::vec2(at), at.z);
                 });
             },
         .agree = [s] { return s->same(); }});

    const frustum<double> camera{.position = {0, 3, 18}, .direction = {0, -0.2, -1}, .z_near = 0.5, .z_far = 60};
    const auto cascades = make_stable_cascades<4>(cascade_fit<double>{.camera = camera,
                                                                      .direction = {-1, -4, -2},
                                                                      .scene = {{-20, 0, -20}, {20, 1, 20}},
                                                                      .map_size = map_size,
                                                                      .margin = tent.reach(),
                                                                      .clip = cpu_clip_space},
                                                  practical_splits<4>(0.5, 60.0, 0.9));
    const shadow sun(cascaded_maps(cascades, 0.0f), map_size, tent);
    const auto maps = std::make_shared<image<float>>(sun.size(), sun.cleared());
    sun.draw(*maps, {s->vertices, s->triangles});
    const auto u = sun.uniforms();
    const auto in_cascades = [=](glm::vec3 world, glm::vec3 normal) {
        const glm::vec3 turned(shadow_coordinate(u.maps.rotation, world - glm::vec3(u.maps.anchor))),
            across(shadow_coordinate(u.maps.rotation, normal));
        const glm::vec4 at =
            cascade_by_projection(turned, u.maps.scales, u.maps.offsets, glm::vec2(map_size), u.terms.reach);
        const float number = at.w < 3.0f ? at.w : 3.0f;
        const glm::vec4 scale = cascade_column(u.maps.scales, number);
        const glm::vec2 slope = cascade_slope(across, scale);
        const float slack =
            (glm::abs(slope.x) + glm::abs(slope.y)) * scale.w + cascade_column(u.maps.offsets, number).w;
        const auto own = maps->view().region(cascade_tile(int(number), map_size), map_size);
        const float depth = biased(at.z, acne_free_bias(slope, u.terms.reach, u.terms.error + slack));
        return tent(decoded(bordered(own), depth32f{}), glm::vec2(at), depth);
    };
    bench::add(
        {.work = "shadow, four cascades, tent 3, 1920 x 1080 points one by one",
         .peer = "the parts by hand",
         .items = bench::pixels,
         .ours =
             [=] { each_point(s->ours, [&](glm::vec3 world, glm::vec3 normal) { return sun(*maps, world, normal); }); },
         .theirs = [=] { each_point(s->theirs, in_cascades); },
         .agree = [s] { return s->same(); }});
});

}  // namespace
