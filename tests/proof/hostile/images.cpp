// SPDX-License-Identifier: MIT
//
// The functions over whole images, as tier_a.cpp has the primitives. What comes out is compared with the primitive
// called one by one, here, and its digest with that of the other builds, by table.cpp. Other libraries' encodings are
// tier B: without -ffast-math they are compared with the primitive of the same build, which may fuse as it likes.
//
// Left out: receivers from a camera's depth image are tier C, and blur and tables of floats tier B, of whose sums
// compilers may fuse or reorder the terms; values whose sums need no rounding stand for those. A box's share and the
// planes of depth are tier B too and round as the machine is told to, but to the same bits in every build.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

#include <umbrage/depth/encodings.hpp>
#include <umbrage/images/blur.hpp>
#include <umbrage/images/encode.hpp>
#include <umbrage/images/min_max.hpp>
#include <umbrage/images/summed_area.hpp>
#include <umbrage/images/visibility.hpp>

#include "../../forced_form.hpp"
#include "raster.hpp"

namespace {

using namespace hostile;
using namespace umbrage;

struct suite : raster_suite {
    template <class Encoding>
    void codec(const std::string& name, Encoding encoding, agree where = agree::everywhere) const {
        using texel = typename Encoding::texel;
        const auto depths = images<float>(sizes, [](source& s, std::size_t) { return s.depth(); });
        run<texel>(
            "encode_" + name, [&](int s, glm::ivec2 t) { return encoding.encode(depths[std::size_t(s)][t]); },
            [&](int s, image_view<texel> out, pieces parallel) {
                const laid_out<float> in(depths[std::size_t(s)], parallel.count % 3);
                encode(in.view(), out, encoding, parallel);
            },
            where);
        const auto texels = images<texel>(sizes, [](source& s, std::size_t) {
            if constexpr (std::is_same_v<texel, float>) return s.any();
            else return umbrage::detail::bit_cast<texel>(s.bytes<sizeof(texel)>());
        });
        run<float>(
            "decode_" + name, [&](int s, glm::ivec2 t) { return encoding.decode(texels[std::size_t(s)][t]); },
            [&](int s, image_view<float> out, pieces parallel) {
                const laid_out<texel> in(texels[std::size_t(s)], parallel.count % 3);
                decode(in.view(), out, encoding, parallel);
            },
            where);
    }

    /// Receivers all over the map and around it, on edges, on weights' steps, and wherever coord() goes.
    std::vector<image<glm::vec3>> receivers(bool short_digits) const {
        return images<glm::vec3>(sizes, [&](source& s, std::size_t i) {
            glm::vec3 r;
            for (int k = 0; k < 2; ++k) {
                const auto steps = static_cast<std::uint32_t>(map_sizes[i][k] * 256 + 2048);
                const float on_step = float(int(s.below(steps)) - 1024) * (1.0f / 256.0f);
                std::uint32_t coord = umbrage::detail::bit_cast<std::uint32_t>(s.one_in(2) ? on_step : s.coord());
                if (short_digits) coord &= 0xFFFFFE00u;  // so that a tap's offset is added exactly
                r[k] = from_bits(coord);
            }
            r.z = s.level();
            return r;
        });
    }

    template <class Encoding>
    std::vector<image<typename Encoding::texel>> maps(Encoding encoding) const {
        return images<typename Encoding::texel>(map_sizes, [&](source& s, std::size_t) {
            if constexpr (std::is_same_v<Encoding, depth32f>) return s.level();
            else return encoding.encode(s.level());
        });
    }

    template <class Encoding, class Filter>
    void visibility_of(const std::string& name, Encoding encoding, Filter filter) const {
        constexpr bool adds = std::is_same_v<Filter, filters::four_tap>;
        constexpr bool box = std::is_base_of_v<filters::box, Filter>;
        const auto map_of = maps(encoding);
        const auto receivers_of = receivers(adds);
        run<float>(
            "visibility_" + name,
            [&](int s, glm::ivec2 t) {
                const auto& map = map_of[std::size_t(s)];
                const glm::vec3 r = receivers_of[std::size_t(s)][t];
                const auto fetch = [&](glm::ivec2 at) { return encoding.decode(fetch_clamped(map.view(), at)); };
                return filter(fetch, glm::vec2(r.x, r.y), r.z);
            },
            [&](int s, image_view<float> out, pieces parallel) {
                const laid_out map(map_of[std::size_t(s)], (parallel.count + 1) % 3);
                const auto& from = receivers_of[std::size_t(s)];
                if constexpr (std::is_same_v<Filter, filters::pcf_2x2> && std::is_same_v<Encoding, depth32f>)
                    if (parallel.count == 3) {  // as a structure of arrays
                        const laid_out<float> x(from.size(), 0), y(from.size(), 1), depth(from.size(), 2);
                        for (int row = 0; row < out.size.y; ++row)
                            for (int column = 0; column < out.size.x; ++column) {
                                const glm::ivec2 t(column, row);
                                x.view()[t] = from[t].x, y.view()[t] = from[t].y, depth.view()[t] = from[t].z;
                            }
                        const receiver_planes planes{x.view(), y.view(), depth.view()};
                        return visibility(map.view(), encoding, planes, filter, out, parallel, outside_map::clamped);
                    }
                const laid_out<glm::vec3> in(from, parallel.count % 3);
                visibility(map.view(), encoding, in.view(), filter, out, parallel, outside_map::clamped);
            },
            box ? agree::in_a_mode : agree::everywhere);
    }

    void pyramid() const {
        const auto maps = images<float>(sizes, [](source& s, std::size_t) { return s.any(); });
        constexpr int levels = 3;
        // by the definition: least with -0 below 0, NaN if any is; greatest of the numbers
        const auto extreme = [&](int s, glm::ivec2 t, bool least) {
            const auto& map = maps[std::size_t(s)];
            std::int64_t best = 0;
            bool none = true, nan = false;
            for (int y = t.y; y < std::min(t.y + (1 << levels), map.size().y); ++y)
                for (int x = t.x; x < std::min(t.x + (1 << levels), map.size().x); ++x) {
                    const auto bits = umbrage::detail::bit_cast<std::uint32_t>(map[{x, y}]);
                    if (is_nan(map[{x, y}])) {
                        nan = true;
                        continue;
                    }
                    const std::int64_t magnitude = bits & 0x7FFFFFFFu, key = bits >> 31 ? -magnitude - 1 : magnitude;
                    best = none ? key : least ? std::min(best, key) : std::max(best, key);
                    none = false;
                }
            if (none || (nan && least)) return 0xFFFFFFFFu;
            return static_cast<std::uint32_t>(best < 0 ? (-best - 1) | 0x80000000 : best);
        };
        for (const bool least : {true, false})
            run<std::uint32_t>(
                least ? "pyramid_least" : "pyramid_greatest",
                [&](int s, glm::ivec2 t) { return extreme(s, t >> levels << levels, least); },
                [&](int s, image_view<std::uint32_t> out, pieces parallel) {
                    const laid_out<float> in(maps[std::size_t(s)], parallel.count % 3);
                    const auto top = make_min_max_pyramid(in.view(), levels, parallel).back();
                    const image<float>& bounds = least ? top.least : top.greatest;
                    for (int y = 0; y < out.size.y; ++y)
                        for (int x = 0; x < out.size.x; ++x) {
                            const float v = bounds[{x >> levels, y >> levels}];
                            out[{x, y}] = is_nan(v) ? 0xFFFFFFFFu : umbrage::detail::bit_cast<std::uint32_t>(v);
                        }
                });
    }

    template <class From, class Sum>
    void sums(const std::string& name) const {
        const auto values = images<From>(sizes, [](source& s, std::size_t) {
            return static_cast<From>(std::is_same_v<From, std::uint32_t> ? s.next() : s.below(256));
        });
        std::vector<image<Sum>> tables;
        for (const auto& image_of : values) {
            tables.emplace_back(image_of.size());
            for (int y = 0; y < image_of.size().y; ++y) {
                Sum row{};
                for (int x = 0; x < image_of.size().x; ++x) {
                    row += image_of[{x, y}];
                    tables.back()[{x, y}] = row + (y ? tables.back()[{x, y - 1}] : Sum{});
                }
            }
        }
        run<Sum>(
            "summed_area_" + name, [&](int s, glm::ivec2 t) { return tables[std::size_t(s)][t]; },
            [&](int s, image_view<Sum> out, pieces parallel) {
                const laid_out<From> in(values[std::size_t(s)], parallel.count % 3);
                if (parallel.count == 1) summed_area(in.view(), out);
                else summed_area(in.view(), out, parallel);
            });
    }

    /// @param kernel  weights of few digits
    template <class T>
    void blur_of(const std::string& name, const blur_kernel& kernel) const {
        constexpr int channels = detail::float_channels<T>;
        const auto values = images<T>(sizes, [](source& s, std::size_t) {
            std::array<float, channels> v;
            for (float& channel : v) channel = float(int(s.below(512)) - 256);
            return umbrage::detail::bit_cast<T>(v);
        });
        const int radius = int(kernel.weights.size()) - 1;
        run<T>(
            "blur_" + name,
            [&](int s, glm::ivec2 t) {
                const auto& from = values[std::size_t(s)];
                const auto weight = [&](int i) { return kernel.weights[std::size_t(i < 0 ? -i : i)]; };
                T sum(0.0f);
                for (int j = -radius; j <= radius; ++j)
                    for (int i = -radius; i <= radius; ++i)
                        sum += fetch_clamped(from.view(), t + glm::ivec2(i, j)) * (weight(i) * weight(j));
                return sum;
            },
            [&](int s, image_view<T> out, pieces parallel) {
                const laid_out<T> in(values[std::size_t(s)], parallel.count % 3);
                blur(in.view(), out, kernel, parallel);
            });
    }

    void all() const;
};

// One encoding for each filter and one filter for each encoding: what a filter does with them is one text.
void suite::all() const {
    codec("rg11", rg<11>{});
    visibility_of("pcf_2x2_rg11", rg<11>{}, filters::pcf_2x2{});
#ifndef SAMPLE
    codec("rg16", rg<16>{.edge = 0.5f});
    codec("rgb24", rgb24{});
    codec("float_bits", float_bits{});
    codec("depth32f", depth32f{});
#ifndef __FAST_MATH__
    for_each_encoding([&](auto encoding) {
        if constexpr (!decltype(detail::codec_of(encoding))::exact)
            codec(std::string(encoding.name), encoding, agree::in_a_build);
    });
#endif

    visibility_of("hard_rg16", rg<16>{.edge = 0.5f}, filters::hard{});
    visibility_of("four_tap_rg11", rg<11>{}, filters::four_tap{});
    visibility_of("pcf_2x2_depth32f", depth32f{}, filters::pcf_2x2{});
    visibility_of("pcf_2x2_rgb24", rgb24{}, filters::pcf_2x2{});
    for (const int radius : {0, 1, 2, 3, 5, 8})
        visibility_of("box" + std::to_string(radius) + "_depth32f", depth32f{},
                      forced::every_texel{filters::box{radius}});
    visibility_of("box2_rg11", rg<11>{}, forced::every_texel{filters::box{2}});
    for (const int radius : {1, 8})
        visibility_of("hierarchical" + std::to_string(radius), depth32f{}, forced::by_bounds{filters::box{radius}});
#endif

    pyramid();
    if (what != kind::ordinary) return;  // the rest takes numbers alone
    sums<std::uint8_t, std::uint32_t>("u8");
    sums<std::uint32_t, std::uint32_t>("u32");
    sums<float, float>("float");
    blur_of<glm::vec2>("binomial5", make_binomial_kernel<5>());
    blur_of<glm::vec2>("radius6", {{0.25f, 0.125f, 0.0f, 0.0f, 0.125f, 0.0f, 0.125f}});
    snapping();
    coverage();
    depth_pass();
}

}  // namespace

int main() {
    for_each_setting([](const setting& s) { suite{s}.all(); });
    return all_equal ? 0 : 1;
}
