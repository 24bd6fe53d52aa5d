// SPDX-License-Identifier: MIT
//
// Contact hardening over blocks against the same filter called for each receiver, bit by bit.
#include "../../unit/images/paths.hpp"

#include <umbrage/images/blocks/soft.hpp>
#include <umbrage/images/visibility.hpp>

namespace {

using namespace paths;

struct scene {
    image<float> map;
    image<glm::vec3> receivers;
};

/// Maps and receivers of anything.
scene scattered(glm::ivec2 map_size, values& v) {
    scene s{image<float>(map_size), image<glm::vec3>({131, 9})};
    for (float& texel : s.map.texels()) texel = v.depth();
    for (glm::vec3& r : s.receivers.texels()) {
        const float x = v.coord(map_size.x), y = v.coord(map_size.y);
        r = {x, y, v.depth()};
    }
    return s;
}

/// Shadows on a floor, most of it lit.
scene in_order(glm::ivec2 map_size) {
    scene s{image<float>(map_size, 0.75f), image<glm::vec3>({192, 40})};
    for (int y = 0; y < map_size.y; ++y)
        for (int x = 0; x < map_size.x; ++x)
            if (x % 90 < 20 && y % 50 < 30) s.map[{x, y}] = 0.5f + static_cast<float>(y % 3) * 0.05f;
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 192; ++x)
            s.receivers[{x, y}] = {static_cast<float>(x) * 1.13f - 4.0f, static_cast<float>(y) * 2.1f - 3.0f,
                                   y % 5 ? 0.74f : 0.9f};
    return s;
}

/// That none differs, over all paths and rounding modes.
/// @return   how many are neither lit nor dark
template <class Filter>
int check(const Filter& filter, const scene& of, umbrage::outside_map outside) {
    const umbrage::depth32f encoding{.direction = filter.direction};
    const bool bordered = outside == umbrage::outside_map::bordered;
    const auto fetch = [&](glm::ivec2 t) {
        return bordered ? umbrage::fetch_bordered(of.map.view(), t, encoding.cleared())
                        : umbrage::fetch_clamped(of.map.view(), t);
    };
    int differ = 0, partly = 0;
    for_each_path([&] {
        image<float> out(of.receivers.size());
        umbrage::visibility(of.map, encoding, of.receivers, contrary(filter), out, bands{3}, outside);
        for (int y = 0; y < out.size().y; ++y)
            for (int x = 0; x < out.size().x; ++x) {
                const glm::vec3 r = of.receivers[{x, y}];
                const float wanted = filter(fetch, glm::vec2(r), r.z, {x, y});
                differ += visibility_bits(wanted) != visibility_bits(out[{x, y}]);
                partly += wanted > 0.0f && wanted < 1.0f;
            }
    });
    CHECK(differ == 0);
    return partly;
}

template <class Filter>
void check_all() {
    const umbrage::penumbra_params lights[]{
        {.per_code_x = 0.01171875f, .per_code_y = 0.03125f, .min_radius = 5.0f, .max_radius = 96.0f},
        {.per_code_x = 3.5f, .per_code_y = 0.5f, .min_radius = 0.0f, .max_radius = 4095.0f},
        {.per_code_x = 0.0f, .per_code_y = 0.0f, .min_radius = 0.0f, .max_radius = 0.0f}};
    values v;
    int partly = 0;
    for (const glm::ivec2 map_size : {glm::ivec2(1, 1), glm::ivec2(67, 45)}) {
        const scene any = scattered(map_size, v), shadows = in_order(map_size);
        for (Filter filter : Filter::values)
            for (const auto direction : {umbrage::depth_direction::forward, umbrage::depth_direction::reversed}) {
                filter.direction = direction;
                for (const umbrage::penumbra_params& light : lights) {
                    filter.softness = light;
                    CAPTURE(filter.name);
                    CAPTURE(light.max_radius);
                    partly += check(filter, any, umbrage::outside_map::clamped);
                    if (filter.points != 16) break;
                }
                filter.softness = lights[0];
                if (filter.points == 16) partly += check(filter, shadows, umbrage::outside_map::bordered);
            }
    }
    CHECK(partly > 10000);
}

}  // namespace

TEST_CASE("soft_blocks: the bits of pcss and dpcf for each receiver, every path, points and direction") {
    check_all<umbrage::filters::pcss>();
    check_all<umbrage::filters::dpcf>();
}

TEST_CASE("divide_int: integer division") {
    values v;
    int wrong = 0;
    each_rounding(rounding_modes(), [&](int) {
        for (int i = 0; i < 20000; ++i) {
            const auto a = static_cast<std::int32_t>(v.word() >> 8), b = static_cast<std::int32_t>(1 + v.word() % 300);
            if (a / b > 1 << 18) continue;
            const std::int32_t whole = a / b * b;
            for (const std::int32_t c : {a, whole, whole > 0 ? whole - 1 : 0})
                wrong += umbrage::detail::divide_int(c, b) != c / b;
        }
    });
    CHECK(wrong == 0);
}
