// SPDX-License-Identifier: MIT
//
// Functions from map to map.
#include <cmath>
#include <memory>
#include <optional>

#include <glm/vec2.hpp>

#include <umbrage/depth/rg.hpp>
#include <umbrage/images/blur.hpp>
#include <umbrage/images/depth_span.hpp>
#include <umbrage/images/encode.hpp>
#include <umbrage/images/min_max.hpp>
#include <umbrage/images/prefilter.hpp>

#include "works.hpp"

namespace {

using namespace umbrage;

constexpr rg<11> packing{};

prepared encodes(int power) {
    struct both {
        image<float> depths;
        image<glm::u8vec2> texels{depths.size()};
    };
    const auto of = std::make_shared<both>(both{depths_of(size_of(power))});
    return {double(area(of->depths.size())), small_change,
            [of](stopwatch& watch) { watch.add([&] { encode(of->depths, of->texels, packing); }); },
            [of] {
                return at_probes(of->texels.size(), [&](glm::ivec2 at) {
                    return of->texels[at] == glm::u8vec2(packing.encode(depth_of(at.x, at.y)));
                });
            }};
}

prepared decodes(int power) {
    struct both {
        image<glm::u8vec2> texels;
        image<float> depths{texels.size()};
    };
    const auto of = std::make_shared<both>(both{image<glm::u8vec2>(size_of(power))});
    for (int y = 0; y < of->texels.size().y; ++y)
        for (int x = 0; x < of->texels.size().x; ++x)
            of->texels.view().row(y)[x] = glm::u8vec2(packing.encode(depth_of(x, y)));
    return {double(area(of->depths.size())), small_change,
            [of](stopwatch& watch) { watch.add([&] { decode(of->texels, of->depths, packing); }); },
            [of] {
                return at_probes(of->depths.size(), [&](glm::ivec2 at) {
                    return of->depths[at] == float(packing.decode(packing.encode(depth_of(at.x, at.y))));
                });
            }};
}

prepared encodes_moments(int power) {
    struct both {
        image<float> depths;
        image<glm::vec2> texels{depths.size()};
    };
    const auto of = std::make_shared<both>(both{depths_of(size_of(power))});
    return {double(area(of->depths.size())), small_change,
            [of](stopwatch& watch) { watch.add([&] { encode_moments(of->depths, of->texels, prefilters::vsm{}); }); },
            [of] {
                return at_probes(of->texels.size(), [&](glm::ivec2 at) {
                    return of->texels[at] == prefilters::vsm{}.encode(depth_of(at.x, at.y));
                });
            }};
}

prepared blurs(int power) {
    struct both {
        image<float> depths, blurred{depths.size()};
    };
    const auto of = std::make_shared<both>(both{depths_of(size_of(power))});
    const blur_kernel kernel = make_binomial_kernel<5>();
    const std::size_t row = sizeof(float) * std::size_t(of->depths.size().x + 4);
    return {double(area(of->depths.size())), row + small_change,
            [of, kernel](stopwatch& watch) { watch.add([&] { blur(of->depths, of->blurred, kernel); }); },
            [of, kernel] {
                const auto tap = clamped(of->depths.view());
                const auto sum = [&](const auto& value) {
                    const auto& w = kernel.weights;
                    return w[0] * value(0) + w[1] * (value(-1) + value(1)) + w[2] * (value(-2) + value(2));
                };
                return at_probes(of->blurred.size(), [&](glm::ivec2 at) {
                    const auto column = [&](int x) {
                        const int inside = x < 0 ? 0 : x < of->depths.size().x ? x : of->depths.size().x - 1;
                        return sum([&](int i) { return tap(glm::ivec2(inside, at.y + i)); });
                    };
                    return std::abs(of->blurred[at] - sum([&](int i) { return column(at.x + i); })) < 1e-6f;
                });
            }};
}

prepared reduces(int power) {
    struct both {
        image<float> depths;
        std::vector<image<float>> levels{};
    };
    const auto of = std::make_shared<both>(both{depths_of(size_of(power))});
    const double texels = double(area(of->depths.size()));
    return {texels, std::size_t(texels * 4 / 3) + small_change,
            [of](stopwatch& watch) {
                of->levels.clear();
                watch.add([&] { of->levels = make_mip_chain(of->depths, 16); });
            },
            [of] {
                return at_probes(of->levels[0].size(), [&](glm::ivec2 at) {
                    const glm::ivec2 coarse = at / 2;
                    return of->levels[0][at] == halve_texels(clamped(of->depths.view()), at) &&
                           of->levels[1][coarse] == halve_texels(clamped(of->levels[0].view()), coarse);
                });
            }};
}

prepared bounds(int power) {
    struct both {
        image<float> depths;
        std::vector<depth_bounds> levels{};
    };
    const auto of = std::make_shared<both>(both{depths_of(size_of(power))});
    const double texels = double(area(of->depths.size()));
    return {texels, std::size_t(texels * 8 / 3) + small_change,
            [of](stopwatch& watch) {
                of->levels.clear();
                watch.add([&] { of->levels = make_min_max_pyramid(of->depths, 16); });
            },
            [of] {
                return at_probes(of->levels[3].least.size(), [&](glm::ivec2 at) {  // squares of two depths a side
                    const glm::ivec2 low = 16 * at, high = low + 8;
                    const float a = depth_of(low.x, low.y), b = depth_of(high.x, low.y);
                    const float c = depth_of(low.x, high.y), d = depth_of(high.x, high.y);
                    return of->levels[3].least[at] == std::min({a, b, c, d}) &&
                           of->levels[3].greatest[at] == std::max({a, b, c, d});
                });
            }};
}

prepared measures(int power) {
    struct both {
        image<float> depths;
        depth_span span{};
    };
    const auto of = std::make_shared<both>(both{depths_of(size_of(power))});
    const glm::ivec2 size = of->depths.size();
    of->depths[size - 1] = 1.5f, of->depths[{0, size.y - 1}] = -0.5f;
    return {double(area(size)), 8 * std::size_t(size.y) + small_change,
            [of](stopwatch& watch) { watch.add([&] { of->span = measure_depths(of->depths, 1.0f); }); },
            [of] { return of->span.least == -0.5f && of->span.greatest == 1.5f; }};
}

const registered here({{"big_maps", "encode, 11 bits", 30, 6, encodes},
                       {"big_maps", "decode, 11 bits", 30, 6, decodes},
                       {"big_maps", "encode_moments, two floats", 30, 12, encodes_moments},
                       {"big_maps", "blur, 5 taps", 30, 8, blurs},
                       {"big_passes", "measure_depths", 30, 4, measures},
                       {"big_passes", "make_mip_chain", 30, 5.4, reduces},
                       {"big_passes", "make_min_max_pyramid", 30, 6.7, bounds}});

}  // namespace
