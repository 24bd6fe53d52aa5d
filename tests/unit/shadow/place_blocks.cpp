// SPDX-License-Identifier: MIT
#include <umbrage/shadow/place_blocks.hpp>

#include <doctest/doctest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <type_traits>

#include <umbrage/filter/filters.hpp>
#include <umbrage/light/directional_light.hpp>
#include <umbrage/light/spot_light.hpp>
#include <umbrage/shadow/lookup.hpp>
#include <umbrage/shadow/single_map.hpp>

#include "../images/isas.hpp"

using namespace umbrage;

namespace {

using detail::block;

struct placed_block {
    std::array<float, block> x{}, y{}, depth{}, slope_x{}, slope_y{};

    void place(const single_map::uniforms& u, const shadow_terms& terms, const glm::vec3* points,
               const glm::vec3* normals, depth_direction direction) {
        const detail::place_row to{x.data(), y.data(), depth.data(), slope_x.data(), slope_y.data()};
        detail::on_best_isa_without_fma([&](auto) UMBRAGE_INLINE {
            if (direction == depth_direction::forward) single_map::place_block<true>(u, terms, points, normals, to);
            else single_map::place_block<false>(u, terms, points, normals, to);
        });
    }
};

/// The same number, or both NaN: which of two NaNs a sum keeps is open.
bool same(float a, float b) {
    return (is_nan(a) && is_nan(b)) || detail::bit_cast<std::uint32_t>(a) == detail::bit_cast<std::uint32_t>(b) ||
           (a == 0.0f && b == 0.0f);
}

}  // namespace

TEST_CASE("place_block: the places of the receivers alone, on every path, also of what is no receiver") {
    using filter = std::remove_cvref_t<decltype(filters::tent<3>)>;
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
    constexpr std::array<float, 8> odd{0.0f, -0.0f, nan, infinity, -infinity, 1e-40f, 3e38f, -1.0f};
    std::mt19937 engine(5);
    std::uniform_real_distribution<float> anywhere(-30, 30), turned(-1, 1);
    int compared = 0, outside = 0;
    for (const depth_direction direction : {depth_direction::forward, depth_direction::reversed}) {
        clip_space clip = cpu_clip_space;
        clip.direction = direction;
        const single_map spot(make_spot_light<double>({.position = {1, 25, 2},
                                                       .direction = {0, -1, 0},
                                                       .outer_angle_radians = 0.7,
                                                       .z_near = 5,
                                                       .z_far = 40,
                                                       .clip = clip})),
            sun(make_directional_light<double>(
                {.direction = {-1, -4, -2}, .offset = 30, .map_size = {512, 256}, .z_far = 60, .clip = clip}));
        for (const single_map& setup : {spot, sun}) {
            const single_map::uniforms u = setup.make_uniforms({512, 256}, glm::dvec3(0));
            const shadow_terms terms{.map_size = {512, 256}, .reach = 2, .error = 0x1p-22f};
            for (int round = 0; round < 200; ++round) {
                std::array<glm::vec3, block> points, normals;
                for (std::size_t i = 0; i < block; ++i) {
                    points[i] = {anywhere(engine), anywhere(engine) / 4, anywhere(engine)};
                    normals[i] = {turned(engine), i % 4 ? 1.0f : turned(engine), turned(engine)};
                    if (i % 16 == 0) normals[i] = glm::vec3(0);
                    if (i % 16 == 1) normals[i] = glm::vec3(1, 0, 0);  // some are seen edge-on
                    if (i % 8 == 2)
                        (i % 3 ? points : normals)[i][static_cast<glm::length_t>(i % 5 % 3)] =
                            odd[engine() % odd.size()];
                }
                for_each_isa([&] {
                    placed_block got;
                    got.place(u, terms, points.data(), normals.data(), direction);
                    for (std::size_t i = 0; i < block; ++i) {
                        const map_place place = single_map::places(u, terms, points[i], normals[i])[0];
                        const glm::vec3 at = detail::receiver_of<single_map, filter>(terms, place, direction);
                        CAPTURE(i);
                        CAPTURE(round);
                        REQUIRE(same(got.x[i], at.x));
                        REQUIRE(same(got.y[i], at.y));
                        REQUIRE(same(got.depth[i], at.z));
                        REQUIRE(same(got.slope_x[i], place.slope.x));
                        REQUIRE(same(got.slope_y[i], place.slope.y));
                        (at.x == 65536.0f ? outside : compared) += 1;
                    }
                });
            }
        }
    }
    CHECK(compared > 10000);
    CHECK(outside > 1000);
}
