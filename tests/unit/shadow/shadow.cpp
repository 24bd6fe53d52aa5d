// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <umbrage/bias/light_units.hpp>
#include <umbrage/depth/rg.hpp>
#include <umbrage/images/blur.hpp>
#include <umbrage/light/directional_light.hpp>
#include <umbrage/shadow/shadow.hpp>

#include "scene.hpp"

using namespace umbrage;
using namespace shadow_scene;

namespace {

constexpr clip_space shadow_clips[]{opengl_clip_space, direct3d_clip_space, unity_clip_space, cpu_clip_space};

template <class Shadow>
concept detaches = requires(const Shadow& s, glm::vec3 v) {
    s.peter_panning_distance(v, v);
};

template <class Make>
std::string refused(const Make& make) {
    try {
        make();
    } catch (const std::invalid_argument& e) { return e.what(); }
    return "accepted";
}

/// Points on and above the floor, among them NaN, far away, below, behind the light.
image<glm::vec3> some_points() {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> anywhere(-12, 12);
    image<glm::vec3> points({67, 40});
    for (glm::vec3& p : points.texels()) p = {anywhere(random), 0.0f, anywhere(random)};
    const float nan = std::numeric_limits<float>::quiet_NaN();
    points[{1, 1}] = glm::vec3(nan), points[{2, 1}] = glm::vec3(0.5f, 8, 0.25f), points[{3, 1}] = glm::vec3(1e30f);
    points[{4, 1}] = glm::vec3(0, -300, 0), points[{5, 1}] = glm::vec3(0, 300, 0), points[{6, 1}].y = nan;
    return points;
}

}  // namespace

TEST_CASE("shadow: dark under a table, lit elsewhere, for every setup, clip space and direction of depth") {
    for (const clip_space clip : shadow_clips)
        for_each_shadow(clip, filters::tent<3>, depth32f{}, [&](const auto& s) {
            image<float> map(s.size(), s.cleared());
            s.draw(map, mesh);
            CHECK(s(map, {0, 0, 0}, up) == 0.0f);
            CHECK(s(map, {0, 2, 0}, up) == 1.0f);  // the table's own top
            int dark = 0;
            for (int i = 0; i < 20000; ++i) {
                const glm::vec3 p(float(i % 141) * 0.28f - 19.7f, 0, float(i / 141) * 0.28f - 19.7f);
                if (glm::abs(p.x) > 4 || glm::abs(p.z) > 4) dark += s(map, p, up) < 1.0f;
            }
            CHECK(dark == 0);
        });
}

TEST_CASE("shadow: filters and encodings take the light's direction of depth") {  // all of them: proof/every_shadow
    for (const clip_space clip : {cpu_clip_space, unity_clip_space}) {
        const auto check = [&](const auto& filter, const auto& encoding) {
            const shadow s(shadow_scene::spot(clip), {256, 128}, filter, encoding);
            const auto map = drawn(s);
            CHECK(s(map, {0, 0, 0}, up) < 0.5f);
            CHECK(s(map, {7, 0, 6}, up) == 1.0f);
            CHECK(s(map, {0, 2, 0}, up) == 1.0f);
        };
        check(filters::hard{}, rg<16>{});
        check(filters::disc{}, rg<11>{});
        check(shadow_scene::sized(filters::pcss{}), depth32f{});
    }
}

TEST_CASE("shadow: an encoding's edge follows the light's direction unless it was chosen") {
    const auto edge_of = [](const clip_space& clip, const rg<11>& encoding) {
        return shadow(shadow_scene::spot(clip), {256, 256}, filters::hard{}, encoding).encoding().edge;
    };
    CHECK(edge_of(cpu_clip_space, {}) == 1.0f);
    CHECK(edge_of(unity_clip_space, {}) == 0.0f);
    CHECK(edge_of(unity_clip_space, {.direction = depth_direction::reversed}) == 0.0f);
    CHECK(edge_of(cpu_clip_space, {.direction = depth_direction::reversed}) == 1.0f);
    CHECK(edge_of(unity_clip_space, {.edge = 0.5f}) == 0.5f);
    // the bias is then that of one step on one side: the same for both directions
    const shadow forward(shadow_scene::spot(cpu_clip_space), {256, 256}, filters::hard{}, rg<11>{});
    const shadow reversed(shadow_scene::spot(unity_clip_space), {256, 256}, filters::hard{}, rg<11>{});
    CHECK(forward.uniforms().terms.error == reversed.uniforms().terms.error);
}

/// Place of a point in a map, step by step.
static map_place by_hand_in(const anchored_map& own, glm::vec3 world, glm::vec3 normal) {
    const glm::vec3 way = world - glm::vec3(own.anchor);
    return anchored_place(own.to_texels, own.planes, own.rounding, own.slack, way, normal);
}

TEST_CASE("shadow: each step by hand gives the same bits") {
    const light_space<float> light = spot(cpu_clip_space);
    const filters::box filter{.radius = 2};
    const rg<11> encoding;
    const shadow s(light, {256, 128}, filter, encoding);
    const auto map = drawn(s);

    const anchored_map own = make_anchored_map(detail::in_double(light), {256, 128});
    const float error = float(encoding.error().below);
    const auto points = some_points();
    for (const glm::vec3& world : points.texels()) {
        const map_place place = by_hand_in(own, world, up);
        const glm::vec3 at(place.at.x, place.at.y, biased(place.at.z, clamp_bias(error + place.slack)));
        const auto along = apply_receiver_plane(decoded(bordered(map), encoding), place.slope, at);
        CHECK(s(map, world, up) == filter(along, glm::vec2(at), at.z));
    }
}

TEST_CASE("shadow: contact hardening compares along the receiver's plane, and darkens no lit plane") {
    const light_space<float> light = spot(cpu_clip_space);
    const filters::pcss filter{.softness = make_penumbra_params(light, {256, 256}, 1.0f)};
    const shadow s(light, {256, 256}, filters::pcss{.softness = make_penumbra_params(1.0f)});
    const auto map = drawn(s);
    const anchored_map own = make_anchored_map(detail::in_double(light), {256, 256});
    int soft = 0, dark = 0, wrong = 0;
    for (int i = 0; i < 4000; ++i) {
        const glm::vec3 world(float(i % 63) * 0.3f - 9.3f, 0, float(i / 63) * 0.3f - 9.3f);
        const float got = s(map, world, up);
        const map_place place = by_hand_in(own, world, up);
        const glm::vec3 at(place.at.x, place.at.y, place.at.z - place.slack);
        wrong += got != filter(apply_receiver_plane(bordered(map), place.slope, at), glm::vec2(at), at.z);
        soft += got > 0 && got < 1;
        dark += got < 1 && (glm::abs(world.x) > 5 || glm::abs(world.z) > 5);
    }
    CHECK(wrong == 0);
    CHECK(soft > 20);
    CHECK(dark == 0);
}

TEST_CASE("shadow: a prefiltered map holds moments, and by hand the same bits") {
    for (const clip_space clip : {cpu_clip_space, unity_clip_space})
        prefilters::all::for_each([&](const auto& filter) {
            const light_space<float> light = fitted(clip);  // of linear depths, which ESM tells apart
            const shadow s(light, {256, 256}, filter);
            const auto sharp = drawn(s);
            auto map = sharp;
            blur(sharp, map, make_gaussian_kernel(5, 1.0f));
            CHECK(s(map, {0, 0, 0}, up) < 0.2f);
            CHECK(s(map, {7, 0, 6}, up) > 0.99f);
            const anchored_map in = make_anchored_map(detail::in_double(light), {256, 256});
            auto own = filter;
            own.direction = clip.direction;
            const float cleared = cleared_depth(clip.direction);
            int wrong = 0;
            for (int i = 0; i < 4000; ++i) {
                const glm::vec3 world(float(i % 63) * 0.3f - 9.3f, 0, float(i / 63) * 0.3f - 9.3f);
                const map_place place = by_hand_in(in, world, up);
                const float reach = 1.0f + 2.0f / float(1 << clip.subpixel_bits) + 256.0f * 0x1p-21f;
                const float bias = acne_free_bias(place.slope, reach, place.slack - 0x1p-23f);
                const float z = biased(place.at.z, bias, clip.direction);
                const auto decode = [&](const auto& texel) { return own.decode(texel, z); };
                wrong += s(map, world, up) != detail::look_up(bordered(map), glm::vec2(place.at), z, cleared, decode);
            }
            CHECK(wrong == 0);
        });
}

TEST_CASE("shadow: points relative to an origin see what the world sees") {
    const auto points = some_points();
    for_each_shadow(cpu_clip_space, filters::hard{}, depth32f{}, [&](const auto& s) {
        const glm::dvec3 origin(1000, 0, -2000);
        const auto here = s.uniforms(), there = s.relative_to(origin).uniforms();
        for (const glm::vec3& world : points.texels()) {
            if (!(glm::abs(world.x) < 13 && glm::abs(world.y) < 1)) continue;
            using setup = std::remove_cvref_t<decltype(s.setup())>;
            const glm::vec3 a = setup::places(here.maps, here.terms, world, up)[0].at;
            const glm::vec3 from_there(glm::dvec3(world) - origin);
            const glm::vec3 b = setup::places(there.maps, there.terms, from_there, up)[0].at;
            CHECK(glm::length(glm::vec2(a) - glm::vec2(b)) < 0.05f);  // floats of 2000 have steps of 2^-13
            CHECK(glm::abs(a.z - b.z) < 1e-4f);
        }
    });
}

TEST_CASE("shadow: its bias detaches shadows as far as peter_panning_distance says by hand") {
    const light_space<float> light = spot(cpu_clip_space);
    const glm::vec3 world(1, 0, -2), normal(1, 3, 2);
    const map_place place = by_hand_in(make_anchored_map(detail::in_double(light), {256, 128}), world, normal);
    const shadow box(light, {256, 128}, filters::box{.radius = 2}, rg<11>{});
    const shadow_terms terms = box.uniforms().terms;
    const float bias = clamp_bias(terms.error + place.slack);
    const glm::dmat4 to_texels = texture_matrix(detail::in_double(light), {256, 128});
    // acne_free_bias adds 2^-23. What is left of the slack is the error of a caster's own texels
    const float spare = detail::spare_slack(to_texels, {256, 128}, place), less = spare + 0x1p-23f;
    CHECK(spare < place.slack);
    CHECK(spare > 0.8f * place.slack);
    const auto above = float(rg<11>{}.error().above);  // by which a caster may be stored too far from the light
    CHECK(box.peter_panning_distance(world, normal) ==
          acne_free_bias(place.slope, terms.reach, terms.error + (bias + above) - less + place.slack));
    const shadow disc(light, {256, 128}, filters::disc{});
    const shadow_terms round = disc.uniforms().terms;
    CHECK(disc.peter_panning_distance(world, normal) ==
          acne_free_disc_bias(place.slope, round.filter_terms.y, place.slack - less + place.slack));
    CHECK(disc.peter_panning_distance(world, glm::vec3(std::numeric_limits<float>::quiet_NaN())) == 1.0f);
    const shadow soft(light, {256, 128}, filters::pcss{.softness = make_penumbra_params(0.2f, 1.0f, 6.0f)});
    const shadow_terms widest = soft.uniforms().terms;
    CHECK(widest.reach > soft.filter().largest_disc().reach());
    CHECK(soft.peter_panning_distance(world, normal) ==
          acne_free_bias(place.slope, widest.reach, place.slack - less + place.slack));
    static_assert(detaches<shadow<single_map, filters::hard>> && !detaches<shadow<single_map, prefilters::vsm>>);
}

TEST_CASE("shadow: beyond the far plane all is lit, also by less than the bias") {
    for (clip_space clip : shadow_clips)
        for (const depth_direction direction : {depth_direction::forward, depth_direction::reversed}) {
            clip.direction = direction;
            const shadow sun(make_directional_light<float>({.direction = {0, -1, 0},
                                                            .offset = 10,
                                                            .map_size = {128, 128},
                                                            .texels_per_unit = 8,
                                                            .z_near = 1,
                                                            .z_far = 10,
                                                            .clip = clip}),
                             {128, 128}, filters::tent<3>);
            image<float> map(sun.size(), sun.cleared());
            sun.draw(map, mesh);
            image<glm::vec3> points({2, 1}), normals({2, 1}, up);
            points[{0, 0}] = {0, 0.01f, 0}, points[{1, 0}] = {0, -0.01f, 0};
            image<float> seen({2, 1});
            sun.visibility(map, points, normals, seen);
            for (const int i : {0, 1}) {
                CHECK(sun(map, points[{i, 0}], up) == float(i));
                CHECK(seen[{i, 0}] == float(i));
            }
        }
}

TEST_CASE("shadow: bad input") {
    const light_space<float> light = spot(cpu_clip_space);
    const shadow s(light, {64, 32}, filters::pcf_2x2{});
    image<float> map(s.size(), s.cleared());
    CHECK(refused([&] {
              (void)shadow(light_space<float>{}, {64, 64}, filters::hard{});
          }).starts_with("umbrage::shadow: light.clip must be given"));
    CHECK(refused([&] {
              (void)shadow(light, {64, 0}, filters::hard{});
          }) == "umbrage::shadow: map_size must be above 0; got 64 x 0");
    CHECK(
        refused([&] {
            (void)shadow(light, {64, 8}, filters::box{.radius = 4});
        }) ==
        "umbrage::shadow: map_size must be twice the filter's reach or more; got 64 x 8. The filter reaches 4.5 texels "
        "to each side.");
    CHECK(refused([&] {
              (void)s(image<float>({64, 64}), {0, 0, 0}, up);
          }) == "umbrage::shadow: map.size must be the shadow's size(), 64 x 32; got 64 x 64");
    clip_space reversed = cpu_clip_space;
    reversed.direction = depth_direction::reversed;
    const point_light<float> grazed{.z_near = 1e-40f, .z_far = 3, .map_size = 64, .border = 2, .clip = reversed};
    CHECK(refused([&] {
              (void)shadow(grazed, {64, 64}, filters::hard{});
          }).starts_with("umbrage::shadow: light.z_near must be far enough for depths in float; got "));
    const tetrahedron_light<float> of_planes{
        .z_near = 1e-40f, .z_far = 3, .map_size = 64, .border = 2, .clip = reversed};
    CHECK(refused([&] {
              (void)shadow(of_planes, {64, 64}, filters::hard{});
          }) ==
          "umbrage::shadow: light, filter and origin must be such that all uniforms are finite in float; got inf. Tiny "
          "near planes and huge coordinates overflow.");
    image<float> other({32, 32});
    CHECK(refused([&] { s.draw(other, mesh); }).starts_with("umbrage::shadow::draw: depths.size must be"));
    CHECK(refused([&] { s.store(other, map); }).starts_with("umbrage::shadow::store: depths.size must be"));
    CHECK(refused([&] { s.store(map, other); }).starts_with("umbrage::shadow::store: map.size must be"));
    const image<glm::vec3> points({4, 4});
    CHECK(refused([&] {
              s.visibility(map, points, image<glm::vec3>({4, 5}), other);
          }).starts_with("umbrage::shadow::visibility: normals.size must be"));
    CHECK(refused([&] {
              s.visibility(map, points, points, other);
          }).starts_with("umbrage::shadow::visibility: out.size must be"));

    s.draw(map, {});  // no triangles: nothing is in shadow
    CHECK(s(map, {0, 0, 0}, up) == 1.0f);
    s.draw(map, mesh);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    CHECK(s(map, {nan, 0, 0}, up) == 1.0f);
    CHECK(s(map, {0, 0, 0}, glm::vec3(nan)) == 1.0f);  // no slope is known: the bias lights it
    CHECK(s(map, {0, 0, 0}, glm::vec3(0)) == 0.0f);    // no normal: the constant part of the bias alone
}
