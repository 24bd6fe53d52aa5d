// SPDX-License-Identifier: MIT
//
// Visibility of as many receivers as the map has texels: in bands of some rows, or all at once.
#include <algorithm>
#include <memory>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/depth/rg.hpp>
#include <umbrage/images/prefilter.hpp>
#include <umbrage/images/visibility.hpp>

#include "works.hpp"

namespace {

using namespace umbrage;

constexpr int rows = 16;  // of a band

/// Band of receivers, a quarter of a texel from the corner of each texel of the map.
struct band {
    image<float> x, y, depth, lit;
    explicit band(int width) : x({width, rows}), y(x.size()), depth(x.size()), lit(x.size()) {
        for (glm::ivec2 at{0}; at.y < rows; ++at.y)
            for (at.x = 0; at.x < width; ++at.x)
                x[at] = float(at.x) + 0.25f, depth[at] = float((at.x * 7 + at.y * 5) % 32) / 32;
    }
    void move_to(int row) {
        for (int i = 0; i < rows; ++i) std::fill_n(y.view().row(i), y.size().x, float(row + i) + 0.25f);
    }
    [[nodiscard]] receiver_planes view() const { return {x, y, depth}; }
};

/// Receivers of one map, band by band. Some of each band and all of the last row are compared with the filter alone.
/// @param look    (const receiver_planes&, image_view<float> out): calls the library
/// @param alone   (glm::vec2 coord, float depth, glm::ivec2 pixel) -> visibility
prepared in_bands(glm::ivec2 size, std::size_t most_bytes, const auto& look, const auto& alone) {
    struct state {
        band receivers;
        bool is_right = true;
    };
    const auto of = std::make_shared<state>(state{band(size.x)});
    return {double(area(size)), most_bytes,
            [of, size, look, alone](stopwatch& watch) {
                band& all = of->receivers;
                of->is_right = true;
                for (int row = 0; row < size.y; row += rows) {
                    all.move_to(row);
                    watch.add([&] { look(all.view(), all.lit.view()); });
                    const auto compare = [&](glm::ivec2 at) {
                        const float expected = alone(glm::vec2(all.x[at], all.y[at]), all.depth[at], at);
                        of->is_right = of->is_right && all.lit[at] == expected;
                    };
                    for (int i = 0; i < 16; ++i) compare({(row * 37 + i * 991) % size.x, i});
                    for (int x = 0; x < size.x && row + rows == size.y; ++x) compare({x, rows - 1});
                }
            },
            [of] { return of->is_right; }};
}

template <class Filter>
prepared looks_up(int power, const Filter& filter) {
    const auto map = std::make_shared<image<float>>(depths_of(size_of(power)));
    return in_bands(
        map->size(), std::size_t(3) << 20,
        [map, filter](const receiver_planes& receivers, image_view<float> out) {
            visibility(*map, depth32f{}, receivers, filter, out);
        },
        [map, filter](glm::vec2 coord, float depth, glm::ivec2 pixel) {
            return detail::filtered(filter, bordered(map->view()), coord, depth, pixel);
        });
}

prepared looks_up_packed(int power) {
    static constexpr rg<11> packing{};
    static constexpr filters::pcf_2x2 filter{};
    const auto map = std::make_shared<image<glm::u8vec2>>(size_of(power));
    for (int y = 0; y < map->size().y; ++y)
        for (int x = 0; x < map->size().x; ++x) map->view().row(y)[x] = glm::u8vec2(packing.encode(depth_of(x, y)));
    return in_bands(
        map->size(), small_change,
        [map](const receiver_planes& receivers, image_view<float> out) {
            visibility(*map, packing, receivers, filter, out);
        },
        [map](glm::vec2 coord, float depth, glm::ivec2) {
            const auto fetch = [&](glm::ivec2 at) {
                const bool inside = inside_map(map->size(), at);
                return inside ? float(packing.decode((*map)[at])) : 1.0f;
            };
            return filter(fetch, coord, depth);
        });
}

prepared looks_up_variance(int power) {
    const auto map = std::make_shared<image<glm::vec2>>(size_of(power));
    static constexpr prefilters::vsm filter{};
    for (int y = 0; y < map->size().y; ++y)
        for (int x = 0; x < map->size().x; ++x) map->view().row(y)[x] = filter.encode(depth_of(x, y));
    return in_bands(
        map->size(), small_change,
        [map](const receiver_planes& receivers, image_view<float> out) { visibility(*map, filter, receivers, out); },
        [map](glm::vec2 coord, float depth, glm::ivec2) {
            return filter.decode(fetch_bilinear(clamped(map->view()), coord), depth);
        });
}

/// All receivers at once: those of a camera's depth image as large as the map, eight texels to the left.
/// @param bounds   bytes per texel of the bounds that the filter reads first
template <class Filter>
prepared looks_up_at_once(int power, const Filter& filter, double bounds) {
    struct both {
        image<float> depths, lit{depths.size()};
    };
    const auto of = std::make_shared<both>(both{depths_of(size_of(power))});
    const double texels = double(area(of->depths.size())), padding = 320.0 * of->depths.size().y;
    return {texels, std::size_t(texels * bounds + padding) + small_change,
            [of, filter](stopwatch& watch) {
                glm::mat4 moved(1);
                moved[3].x = 8;
                const depth_receivers seen{of->depths, moved};
                watch.add([&] { visibility(of->depths, depth32f{}, seen, filter, of->lit); });
            },
            [of, filter] {
                return at_probes(of->lit.size(), [&](glm::ivec2 at) {
                    const glm::vec2 coord = glm::vec2(at) + glm::vec2(8.5f, 0.5f);
                    return of->lit[at] == filter(bordered(of->depths.view()), coord, depth_of(at.x, at.y));
                });
            }};
}

const registered here(
    {{"big_receivers", "hard", 30, 4.1, [](int power) { return looks_up(power, filters::hard{}); }},
     {"big_receivers", "pcf_2x2", 30, 4.1, [](int power) { return looks_up(power, filters::pcf_2x2{}); }},
     {"big_receivers", "tent<3>", 30, 4.1, [](int power) { return looks_up(power, filters::tent<3>); }},
     {"big_receivers", "box 5 x 5", 30, 4.1, [](int power) { return looks_up(power, filters::box{2}); }},
     {"big_receivers", "disc of 16", 30, 4.1, [](int power) { return looks_up(power, filters::disc{}); }},
     {"big_receivers_2", "pcf_2x2 of 11 bits", 30, 2.1, looks_up_packed},
     {"big_receivers_2", "variance", 30, 8.1, looks_up_variance},
     {"big_receivers_2", "hard, all at once", 30, 8,
      [](int power) { return looks_up_at_once(power, filters::hard{}, 0); }},
     {"big_receivers_2", "box 7 x 7, all at once", 30, 10.1,
      [](int power) { return looks_up_at_once(power, filters::box{3}, 2); }}});

}  // namespace
