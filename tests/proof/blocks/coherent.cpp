// SPDX-License-Identifier: MIT
//
// visibility over images where receivers follow each other: whole blocks inside a map, and at the end of texel space.
#include "../../unit/rounds.hpp"
#include "one_by_one.hpp"

namespace {

using namespace paths;

image<glm::vec3> in_a_row(glm::ivec2 size, glm::ivec2 map_size, glm::vec2 start, glm::vec2 step) {
    image<glm::vec3> receivers(size);
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            receivers[{x, y}] = glm::vec3(start + step * glm::vec2(x, y), 0.3f + 0.02f * static_cast<float>(y));
    receivers[{5, 3}].z = std::numeric_limits<float>::quiet_NaN();
    receivers[{70, 4}].x = -3.0f;
    receivers[{130, 5}].x = static_cast<float>(map_size.x) - 0.5f;
    return receivers;
}

/// Receivers that follow each other through a map, most of them well inside: whole blocks that need no care.
/// Rows of 512 and 1024 floats push each other out of the cache, and large boxes then go through a copy.
template <class Encoding, class Filter>
void check_coherent(Encoding encoding, Filter filter, glm::ivec2 map_size, glm::vec2 start = {12.0f, 9.0f},
                    glm::vec2 step = {1.03f, 1.7f}) {
    if constexpr (requires { encoding.direction = filter.direction; }) encoding.direction = filter.direction;
    CAPTURE(map_size.x);
    CAPTURE(start.x);
    values v;
    image<typename Encoding::texel> map(map_size);
    for (auto& texel : map.texels()) texel = encoding.encode(0.3f + 0.4f * v.unit());
    const image<glm::vec3> receivers = in_a_row({192, 6 + rounds(18)}, map_size, start, step);
    const auto fetch = umbrage::decoded(map, encoding);
    const auto clamped = umbrage::clamped(fetch);
    const one_by_one bordered_one(any_filter(filter), erase(fetch), receivers),
        clamped_one(any_filter(filter), erase(clamped), receivers);
    check_each_path(bordered_one,
                    [&](image<float>& out) { umbrage::visibility(map, encoding, receivers, filter, out, bands{3}); });
    check_each_path(clamped_one, [&](image<float>& out) {
        umbrage::visibility(map, encoding, receivers, filter, out, bands{3}, umbrage::outside_map::clamped);
    });
}

}  // namespace

TEST_CASE("visibility: whole blocks inside the map, and rows that collide in the cache") {
    for (const glm::ivec2 map_size : {glm::ivec2(512, 61), glm::ivec2(600, 61), glm::ivec2(1024, 61)}) {
        check_coherent(umbrage::depth32f{}, umbrage::filters::pcf_2x2{}, map_size);
        check_coherent(umbrage::rg<11>{}, umbrage::filters::pcf_2x2{}, map_size);
        for (int radius : {0, 1, 2, 3, 4, 6, 8}) {
            const forced::every_texel box{umbrage::filters::box{radius}};
            check_coherent(umbrage::depth32f{}, box, map_size);
            check_coherent(umbrage::depth32f{}, forced::by_bounds{umbrage::filters::box{radius}}, map_size);
            check_coherent(umbrage::rg<16>{}, box, map_size);
            // From the far corner of the map on: as near to it as eight lanes can be loaded for every row, and one
            // texel on.
            for (const float beyond : {7.5f, 6.5f}) {
                const auto corner = glm::vec2(map_size - radius) - glm::vec2(beyond, 0.5f);
                check_coherent(umbrage::depth32f{}, box, map_size, corner, {-1.03f, -1.7f});
            }
        }
    }
}

TEST_CASE("visibility: windows, and discs of all radii, in whole blocks inside the map") {
    for (const umbrage::filters::window& filter : umbrage::filters::window::values)
        check_coherent(umbrage::depth32f{}, forced::every_texel{filter}, {600, 61});
    for (umbrage::filters::disc filter : umbrage::filters::disc::values)
        for (const float radius : {0.0f, 0.4f, 3.2f, 5.3f, 300.0f}) {
            filter.radius_texels = radius;
            check_coherent(umbrage::depth32f{}, forced::every_texel{filter}, {600, 61});
        }
}

TEST_CASE("visibility: maps that reach beyond texel space, up to its last texels") {
    for (const glm::ivec2 map_size : {glm::ivec2(32769, 2), glm::ivec2(2, 32770)}) {
        const bool wide = map_size.x > map_size.y;
        const glm::vec2 along = wide ? glm::vec2(1, 0) : glm::vec2(0, 1), start = 32762.0f * along + glm::vec2(0.4f);
        umbrage::for_each_filter([&](const auto& filter) {
            check_coherent(umbrage::depth32f{}, filter, map_size, start, 0.03125f * along);
        });
        check_coherent(umbrage::rg<11>{}, umbrage::filters::pcf_2x2{}, map_size, start, 0.03125f * along);
    }
}
