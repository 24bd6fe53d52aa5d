// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>

#include <umbrage/bias/light_units.hpp>
#include <umbrage/depth/rg.hpp>
#include <umbrage/filter/filters.hpp>
#include <umbrage/images/blur.hpp>
#include <umbrage/shadow/shadow.hpp>

#include "../fusing.hpp"
#include "../images/last_piece_first.hpp"
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

TEST_CASE("shadow: dark under a table, lit elsewhere, for every set-up, clip space and direction of depth") {
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

TEST_CASE("shadow: filters and encodings take the light's direction of depth") {
    for (const clip_space clip : {cpu_clip_space, unity_clip_space})
        for_each_light(clip, [&]<class Light>(const Light& light, glm::ivec2 map_size) {
            image<float> depths;
            const auto check = [&]<class Filter>(const Filter& filter, const auto& encoding) {
                if constexpr (go_together<Light, Filter>) {
                    const shadow s(light, map_size, filter, encoding);
                    if (depths.empty()) depths = depths_of(s);
                    const auto map = stored(s, depths);
                    CHECK(s(map, {0, 0, 0}, up) < 0.5f);
                    CHECK(s(map, {7, 0, 6}, up) == 1.0f);
                    CHECK(s(map, {0, 2, 0}, up) == 1.0f);
                }
            };
            for_each_filter([&]<class Filter>(const Filter& filter) {
                if constexpr (detail::point_filter<Filter>) check(filter, rg<16>{});
            });
            filters::soft::for_each([&](const auto& filter) { check(filter, depth32f{}); });
            check(filters::pcf_2x2{}, depth32f{});
            check(filters::pcf_2x2{}, rg<11>{});
        });
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

TEST_CASE("shadow: a whole image has the bits of its receivers alone, in pieces of any order") {
    const auto points = some_points();
    image<glm::vec3> normals(points.size(), up);
    normals[{9, 9}] = glm::vec3(0), normals[{10, 9}] = glm::vec3(3, 1, -2);
    const auto check = [&](const auto& filter, const auto& encoding) {
        for_each_shadow(unity_clip_space, filter, encoding, [&](const auto& s) {
            const auto map = drawn(s);
            image<float> out(points.size()), split(points.size());
            s.visibility(map, points, normals, out);
            s.visibility(map, points, normals, split, last_piece_first{5});
            int wrong = 0;
            for (int y = 0; y < out.size().y; ++y)
                for (int x = 0; x < out.size().x; ++x) {
                    const glm::ivec2 p(x, y);
                    const auto alone = std::bit_cast<std::uint32_t>(s(map, points[p], normals[p], p));
                    wrong += std::bit_cast<std::uint32_t>(out[p]) != alone;
                    wrong += std::bit_cast<std::uint32_t>(split[p]) != alone;
                }
            // fused, ties fall either way: in 1/20 of each of both images
            CHECK(wrong <= (may_fuse ? 2 * (out.size().x * out.size().y / 20) : 0));
        });
    };
    check(filters::tent<3>, depth32f{});
    check(filters::disc{}, rg<11>{});
    check(filters::pcss{}, depth32f{});
    check(prefilters::vsm{}, moment_texels<prefilters::vsm>{});
    check(prefilters::evsm4{}, moment_texels<prefilters::evsm4>{});
}

TEST_CASE("shadow: each step by hand gives the same bits") {
    const light_space<float> light = spot(cpu_clip_space);
    const filters::box filter{.radius = 2};
    const rg<11> encoding;
    const shadow s(light, {256, 128}, filter, encoding);
    const auto map = drawn(s);

    const glm::dmat4 in_double =
        texture_matrix<double>({glm::dmat4(light.view), glm::dmat4(light.projection), light.clip}, {256, 128});
    const glm::mat4 to_texels(in_double), planes(plane_matrix(in_double));
    const float reach = filter.reach() + rasterizer_snap<float> + 256.0f * 0x1p-24f;
    const float error = float(encoding.error().below) + 0x1p-22f;
    const auto points = some_points();
    for (const glm::vec3& world : points.texels()) {
        const glm::vec3 p = project_coordinate(shadow_coordinate(to_texels, world));
        const float bias = acne_free_bias(receiver_slope(planes, up, world), reach, error);
        const float by_hand = filter(decoded(bordered(map), encoding), glm::vec2(p), biased(p.z, bias));
        CHECK(s(map, world, up) == by_hand);
    }
}

TEST_CASE("shadow: contact hardening compares along the receiver's plane, and darkens no lit plane") {
    const light_space<float> light = spot(cpu_clip_space);
    const filters::pcss filter{.softness = make_penumbra_params(make_light_units(light, {256, 256}), 1.0f)};
    const shadow s(light, {256, 256}, filter);
    const auto map = drawn(s);
    const glm::dmat4 to_texels = texture_matrix<double>(detail::in_double(light), {256, 256});
    int soft = 0, dark = 0, wrong = 0;
    for (int i = 0; i < 4000; ++i) {
        const glm::vec3 world(float(i % 63) * 0.3f - 9.3f, 0, float(i / 63) * 0.3f - 9.3f);
        const float got = s(map, world, up);
        const glm::vec3 p = project_coordinate(shadow_coordinate(glm::mat4(to_texels), world));
        const glm::vec2 slope = receiver_slope(glm::mat4(plane_matrix(to_texels)), up, world);
        const float bias = acne_free_bias(slope, 0.5f, 0x1p-22f);
        wrong += got != filter(apply_receiver_plane(bordered(map), slope, glm::vec2(p)), glm::vec2(p), p.z - bias);
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
            const glm::dmat4 to_texels = texture_matrix<double>(detail::in_double(light), {256, 256});
            auto own = filter;
            own.direction = clip.direction;
            const float cleared = cleared_depth(clip.direction);
            int wrong = 0;
            for (int i = 0; i < 4000; ++i) {
                const glm::vec3 world(float(i % 63) * 0.3f - 9.3f, 0, float(i / 63) * 0.3f - 9.3f);
                const glm::vec3 p = project_coordinate(shadow_coordinate(glm::mat4(to_texels), world));
                const glm::vec2 slope = receiver_slope(glm::mat4(plane_matrix(to_texels)), up, world);
                const float reach = 1.0f + rasterizer_snap<float> + 0x1p-16f;
                const float z = biased(p.z, acne_free_bias(slope, reach, 0x1p-22f), comparison{clip.direction});
                const auto decode = [&](const auto& texel) { return own.decode(texel, z); };
                wrong += s(map, world, up) != detail::look_up(bordered(map), glm::vec2(p), z, cleared, decode);
            }
            CHECK(wrong == 0);
        });
}

TEST_CASE("shadow: points relative to an origin see what the world sees") {
    const auto points = some_points();
    for_each_shadow(cpu_clip_space, filters::hard{}, depth32f{}, [&](const auto& s) {
        const glm::dvec3 origin(1000, 0, -2000);
        const auto here = s.uniforms(), there = s.uniforms({.origin = origin});
        for (const glm::vec3& world : points.texels()) {
            if (!(glm::abs(world.x) < 13 && glm::abs(world.y) < 1)) continue;
            using set_up = std::remove_cvref_t<decltype(s.set_up())>;
            glm::vec3 a(0), b(0);
            const auto keep = [](glm::vec3& to) {
                return [&to](const map_place& place) { return to = place.at, 0.0f; };
            };
            static_cast<void>(set_up::visibility(here.maps, here.terms, world, up, keep(a)));
            static_cast<void>(
                set_up::visibility(there.maps, there.terms, glm::vec3(glm::dvec3(world) - origin), up, keep(b)));
            CHECK(glm::length(glm::vec2(a) - glm::vec2(b)) < 0.05f);  // floats of 2000 have steps of 2^-13
            CHECK(glm::abs(a.z - b.z) < 1e-4f);
        }
    });
}

TEST_CASE("shadow: its bias detaches shadows as far as peter_panning_distance says by hand") {
    const light_space<float> light = spot(cpu_clip_space);
    const glm::vec3 world(1, 0, -2), normal(1, 3, 2);
    const glm::dmat4 to_texels = texture_matrix<double>(detail::in_double(light), {256, 128});
    const glm::vec2 slope = receiver_slope(glm::mat4(plane_matrix(to_texels)), normal, world);
    const shadow box(light, {256, 128}, filters::box{.radius = 2}, rg<11>{});
    const shadow_terms terms = box.uniforms().terms;
    const float bias = acne_free_bias(slope, terms.reach, terms.error);
    CHECK(box.peter_panning_distance(world, normal) == peter_panning_distance(bias + terms.error, slope, terms.reach));
    const shadow disc(light, {256, 128}, filters::disc{});
    const shadow_terms round = disc.uniforms().terms;
    const float disc_bias = acne_free_disc_bias(slope, round.filter_terms.y, round.error);
    CHECK(disc.peter_panning_distance(world, normal) ==
          acne_free_disc_bias(slope, round.filter_terms.y, round.error + disc_bias));
    CHECK(disc.peter_panning_distance(world, glm::vec3(std::numeric_limits<float>::quiet_NaN())) == 1.0f);
    static_assert(detaches<shadow<single_map, filters::hard>> && !detaches<shadow<single_map, filters::pcss>>);
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
    const point_light<float> grazed{.z_near = 1e-40f, .z_far = 3, .map_size = 64, .border = 2, .clip = cpu_clip_space};
    CHECK(
        refused([&] {
            (void)shadow(grazed, {64, 64}, filters::hard{});
        }) ==
        "umbrage::shadow: light, filter and origin must be such that all uniforms are finite in float; got -inf. Tiny "
        "near planes and huge coordinates overflow.");
    image<float> other({32, 32});
    CHECK(refused([&] { s.draw(other, mesh); }).starts_with("umbrage::shadow::draw: depths.size must be"));
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
