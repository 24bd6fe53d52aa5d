// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <random>
#include <stdexcept>

#include <umbrage/filter/filters.hpp>
#include <umbrage/images/plane_visibility.hpp>

#include "../fusing.hpp"

using umbrage::image;

namespace {

struct sloped {
    glm::ivec2 size;
    image<float> x{size}, y{size}, depth{size}, slope_x{size}, slope_y{size};
    [[nodiscard]] umbrage::sloped_receivers all() const { return {{x, y, depth}, slope_x, slope_y}; }
};

/// Pixels of an image that have not the bits of the filter called along each receiver's plane.
template <class Filter>
int differing(const Filter& filter) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> unit(0, 1);
    image<float> map({67, 45});
    for (float& texel : map.texels()) texel = 0.45f + 0.1f * unit(random);
    sloped of{{192, 40}};
    for (glm::ivec2 p{0}; p.y < of.size.y; ++p.y)
        for (p.x = 0; p.x < of.size.x; ++p.x) {
            of.x[p] = 0.4f * static_cast<float>(p.x) - 3, of.y[p] = 1.2f * static_cast<float>(p.y);
            of.depth[p] = 0.5f;
            of.slope_x[p] = 0.02f * (unit(random) - 0.5f), of.slope_y[p] = 0.02f * (unit(random) - 0.5f);
        }
    image<float> out(of.size);
    umbrage::visibility(map, umbrage::depth32f{}, of.all(), filter, out);
    const auto fetch = umbrage::bordered(umbrage::image_view<const float>(map.view()));
    int differ = 0;
    for (glm::ivec2 p{0}; p.y < of.size.y; ++p.y)
        for (p.x = 0; p.x < of.size.x; ++p.x) {
            const glm::vec3 at(of.x[p], of.y[p], of.depth[p]);
            const auto moved = umbrage::apply_receiver_plane(fetch, {of.slope_x[p], of.slope_y[p]}, at);
            float wanted = 0;
            if constexpr (requires { filter(moved, glm::vec2(at), at.z, p); })
                wanted = filter(moved, glm::vec2(at), at.z, p);
            else wanted = filter(moved, glm::vec2(at), at.z);
            differ += std::bit_cast<std::uint32_t>(wanted) != std::bit_cast<std::uint32_t>(out[p]);
        }
    return differ;
}

}  // namespace

// Every filter, encoding and instruction set: proof/blocks/along_planes.
TEST_CASE("visibility along planes: an image has the filter's bits") {
    const int ties = may_fuse ? 192 * 40 / 20 : 0;  // fused, ties fall either way
    CHECK(differing(umbrage::filters::tent<3>) <= ties);
    CHECK(differing(umbrage::filters::pcss{
              .softness = {.per_code_x = 0.0625f, .per_code_y = 0.03125f, .min_radius = 8, .max_radius = 80}}) <= ties);
}

TEST_CASE("visibility along planes: a callable of one's own, a plane that needs no bias, impossible images") {
    const image<float> flat({40, 40}, 0.5f);
    image<float> map({40, 40});
    for (glm::ivec2 p{0}; p.y < 40; ++p.y)
        for (p.x = 0; p.x < 40; ++p.x) map[p] = 0.25f + 0.0625f * 0.125f * (static_cast<float>(p.x) + 0.5f);
    sloped of{{64, 1}};
    for (int i = 0; i < 64; ++i) {
        of.x[{i, 0}] = 8 + 0.375f * static_cast<float>(i), of.y[{i, 0}] = 20.25f;
        of.depth[{i, 0}] = 0.25f + 0.0625f * 0.125f * of.x[{i, 0}];
        of.slope_x[{i, 0}] = 0.0625f * 0.125f;
    }
    image<float> out(of.size);
    const auto center = [](const auto& fetch, glm::vec2 coord, float receiver) {
        return receiver <= fetch(glm::ivec2(coord)) ? 1.0f : 0.0f;
    };
    const umbrage::filters::pcss soft{
        .softness = {.per_code_x = 0.5f, .per_code_y = 0.5f, .min_radius = 16, .max_radius = 96}};
    const auto dark = [&](const auto& filter) {
        umbrage::visibility(map, umbrage::depth32f{}, of.all(), filter, out);
        return std::ranges::count_if(out.texels(), [](float v) { return v < 1; });
    };
    CHECK(dark(center) == 0);
    CHECK(dark(soft) == 0);
    umbrage::visibility(map, umbrage::depth32f{}, of.all().at, soft, out);
    CHECK(std::ranges::count_if(out.texels(), [](float v) { return v < 1; }) > 50);  // without planes it has acne

    umbrage::sloped_receivers other = of.all();
    other.slope_y = flat;
    CHECK_THROWS_AS(umbrage::visibility(map, umbrage::depth32f{}, other, soft, out), std::invalid_argument);
    CHECK_THROWS_AS(umbrage::visibility(image<float>(), umbrage::depth32f{}, of.all(), soft, out),
                    std::invalid_argument);
}
