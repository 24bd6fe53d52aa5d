// SPDX-License-Identifier: MIT
//
// Tables and prefiltered maps of images: each texel is what a loop over the image gives, and no pieces change a bit.
#include <cmath>
#include <cstdint>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/filter/bounds_lit.hpp>
#include <umbrage/filter/pcf/box.hpp>
#include <umbrage/filter/pcf/hard.hpp>
#include <umbrage/images/blur.hpp>
#include <umbrage/images/depth_span.hpp>
#include <umbrage/images/filter_bounds.hpp>
#include <umbrage/images/min_max.hpp>
#include <umbrage/images/moment_table.hpp>
#include <umbrage/images/prefilter.hpp>
#include <umbrage/images/summed_area.hpp>
#include <umbrage/images/variance_table.hpp>

#include "input.hpp"

namespace {

using namespace umbrage;

template <class Use>
void for_each_texel(glm::ivec2 size, const Use& use) {
    for (glm::ivec2 p(0); p.y < size.y; ++p.y)
        for (p.x = 0; p.x < size.x; ++p.x) use(p);
}

/// Depths as a map has them, or any floats. The input gives some, and a generator of whole numbers the others.
image<float> depths_of(fuzz::input& in, glm::ivec2 size) {
    const bool any = in.chance(4);
    const int coarse = in.within(1, 1000);
    std::uint32_t state = in.bits();
    image<float> depths(size);
    for (float& d : depths.texels()) {
        state = state * 1664525u + 1013904223u;
        const int code = static_cast<int>(state >> 8) % (coarse + 1);
        d = any && (state >> 30) == 0 ? in.number(-2, 2) : static_cast<float>(code) / static_cast<float>(coarse);
    }
    return depths;
}

image<glm::vec3> receivers_in(fuzz::input& in, glm::ivec2 map_size) {
    image<glm::vec3> receivers({in.within(1, 70), 2});
    const glm::vec2 reach(map_size);
    for (glm::vec3& r : receivers.texels())
        r = {in.number(-3, reach.x + 3), in.number(-3, reach.y + 3), in.number(-0.1f, 1.1f)};
    return receivers;
}

void blurs(fuzz::input& in, image_view<const float> map) {
    blur_kernel kernel{std::vector<float>(static_cast<std::size_t>(in.within(0, 7)))};
    for (float& weight : kernel.weights) weight = in.tame(-1, 1);
    image<float> along_y(map.size), wanted(map.size), blurred(map.size);
    blur(map, blurred.view(), kernel, fuzz::pieces(in));
    const auto line = [&](image_view<const float> from, image<float>& to, glm::ivec2 step) {
        const auto texel = clamped(from);
        for_each_texel(map.size, [&](glm::ivec2 p) {
            float sum = kernel.weights[0] * texel(p);
            for (int i = 1; i < static_cast<int>(kernel.weights.size()); ++i)
                sum += kernel.weights[std::size_t(i)] * (texel(p - i * step) + texel(p + i * step));
            to[p] = sum;
        });
    };
    line(map, along_y, {0, 1});
    line(along_y, wanted, {1, 0});
    for_each_texel(map.size, [&](glm::ivec2 p) {
        fuzz::must(fuzz::same(blurred[p], wanted[p]), "a blur has the bits of its written order");
    });
}

template <class Value>
void sums(fuzz::input& in, image_view<const float> map) {
    image<Value> values(map.size);
    std::uint32_t state = in.bits();
    for (Value& v : values.texels()) v = static_cast<Value>(state = state * 1664525u + 1013904223u);
    image<std::uint32_t> table(map.size);
    summed_area(values, table, fuzz::pieces(in));
    glm::ivec2 first(in.within(-2, map.size.x), in.within(-2, map.size.y)), last = first;
    last.x += in.within(-1, 30), last.y += in.within(-1, 30);
    std::uint32_t sum = 0;
    for_each_texel(map.size, [&](glm::ivec2 p) {
        if (p.x >= first.x && p.y >= first.y && p.x <= last.x && p.y <= last.y) sum += values[p];
    });
    fuzz::must(box_sum(table, first, last) == sum, "a rectangle's sum comes from the table");
}

void bounds(fuzz::input& in, image_view<const float> map) {
    int side = 1;
    for (const auto& level : make_min_max_pyramid(map, in.within(0, 8), fuzz::pieces(in))) {
        side *= 2;
        for_each_texel(level.least.size(), [&](glm::ivec2 at) {
            float least = detail::highest<float>, greatest = -least;
            bool all = true, none = true;
            for (glm::ivec2 p = at * side; p.y < std::min((at.y + 1) * side, map.size.y); ++p.y)
                for (p.x = at.x * side; p.x < std::min((at.x + 1) * side, map.size.x); ++p.x) {
                    const float depth = map[p];
                    if (is_nan(depth)) all = false;
                    else none = false;
                    if (depth < least || (depth == least && std::signbit(depth))) least = depth;
                    if (depth > greatest || (depth == greatest && !std::signbit(depth))) greatest = depth;
                    if (std::isinf(depth)) least = std::fmin(least, depth), greatest = std::fmax(greatest, depth);
                }
            if (none || std::isinf(least) || std::isinf(greatest)) return;
            const float low = level.least[at], high = level.greatest[at];
            fuzz::must(all ? low == least : is_nan(low), "the minimum of a square");
            fuzz::must(high == greatest, "the maximum of a square");
        });
    }
    const depth_span seen = measure_depths(map, 1.0f, fuzz::pieces(in));
    depth_span wanted;
    for_each_texel(map.size, [&](glm::ivec2 p) {
        if (is_nan(map[p]) || map[p] == 1.0f) return;
        wanted.least = std::fmin(wanted.least, map[p]), wanted.greatest = std::fmax(wanted.greatest, map[p]);
    });
    const bool infinite = std::isinf(wanted.least) || std::isinf(wanted.greatest);
    fuzz::must(infinite || (seen.least == wanted.least && seen.greatest == wanted.greatest), "the span of depths");
}

void early_exit(fuzz::input& in, image_view<const float> map) {
    const auto direction = in.chance(2) ? depth_direction::forward : depth_direction::reversed;
    const filters::box filter{.radius = in.within(0, 6), .direction = direction};
    const auto [ends, place] = make_filter_bounds(map, filter.reach(), direction, fuzz::pieces(in));
    const auto receivers = receivers_in(in, map.size);
    for (const glm::vec3& r : receivers.texels()) {
        const float lit = bounds_lit(clamped(ends), glm::vec2(r), r.z, place, comparison{filter.direction});
        if (lit < 0) continue;
        const float whole = filter(bordered(map, cleared_depth(direction)), glm::vec2(r), r.z);
        fuzz::must(lit == whole, "an early exit gives the filter's visibility");
    }
}

template <class Table, class Make>
void box_table(fuzz::input& in, image_view<const float> map, Table of, const Make& make) {
    of.radius = in.within(-1, 12);
    of.direction = in.chance(2) ? depth_direction::forward : depth_direction::reversed;
    const image<glm::u16vec4> table = make(of, fuzz::pieces(in)), again = make(of, serial{});
    fuzz::must(std::ranges::equal(table.texels(), again.texels()), "no pieces change a table");
    const auto receivers = receivers_in(in, map.size);
    image<float> out(receivers.size());
    visibility(table, of, receivers, in.within(0, 12), out, fuzz::pieces(in));
    for (const float v : out.texels()) fuzz::must(v >= 0.0f && v <= 1.0f, "a visibility lies within 0 and 1");
}

/// Gives a prefilter numbers of its own, now and then such as functions over images refuse.
void vary(fuzz::input& in, prefilters::vsm& filter) { filter.min_variance = in.number(0, 1); }
void vary(fuzz::input& in, prefilters::esm& filter) { filter.settings.exponent = in.number(0, 63); }
void vary(fuzz::input& in, prefilters::evsm2& filter) { filter.parameters.exponents.x = in.number(0, 55); }
void vary(fuzz::input& in, prefilters::evsm4& filter) { filter.parameters.exponents.x = in.number(0, 55); }
void vary(fuzz::input& in, auto& msm) { msm.bias = {in.number(0, 1), in.number(0, 1)}; }

template <class Prefilter>
void prefiltered(fuzz::input& in, image_view<const float> map, Prefilter filter) {
    using texel = typename Prefilter::texel;
    filter.direction = in.chance(2) ? depth_direction::forward : depth_direction::reversed;
    if (in.chance(4)) vary(in, filter);
    image<texel> texels(map.size);
    encode_moments(map, texels, filter, fuzz::pieces(in));
    const auto equal = [](const texel& a, const texel& b) { return std::memcmp(&a, &b, sizeof a) == 0; };
    for_each_texel(map.size, [&](glm::ivec2 p) {
        fuzz::must(equal(texels[p], filter.encode(map[p])), "an image's texel has the bits of a depth alone");
    });
    const auto receivers = receivers_in(in, map.size);
    image<float> out(receivers.size());
    const bool is_clamped = in.chance(2);
    visibility(texels, filter, receivers, out, fuzz::pieces(in),
               is_clamped ? outside_map::clamped : outside_map::bordered);
    for_each_texel(receivers.size(), [&](glm::ivec2 p) {
        const glm::vec3 r = receivers[p];
        const auto decode = [&](const texel& mean) { return filter.decode(mean, r.z); };
        const auto alone = [&](const auto& fetch) {
            return detail::look_up(fetch, glm::vec2(r), r.z, cleared_depth(filter.direction), decode);
        };
        fuzz::must(fuzz::same(out[p], is_clamped ? alone(clamped(texels)) : alone(bordered_texels<texel>{texels})),
                   "an image's receiver has the bits of a point");
        fuzz::must(out[p] >= 0.0f && out[p] <= 1.0f, "a visibility lies within 0 and 1");
    });
    glm::ivec2 size = map.size;
    for (const auto& level : make_mip_chain(texels, in.within(0, 4), fuzz::pieces(in))) {
        size = (size + 1) / 2;
        fuzz::must(level.size() == size, "a level has half the size");
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    fuzz::input in(bytes, size);
    const image<float> map = depths_of(in, {in.within(0, 150), in.within(0, 40)});
    const int kind = in.within(0, 14);
    fuzz::answered([&] {
        switch (kind) {
            case 0: return blurs(in, map);
            case 1: return sums<std::uint8_t>(in, map);
            case 2: return sums<std::uint16_t>(in, map);
            case 3: return sums<std::uint32_t>(in, map);
            case 4: return bounds(in, map);
            case 5: return early_exit(in, map);
            case 6:
                return box_table(in, map, moment_table{},
                                 [&](const auto& of, const auto& h) { return make_moment_table(map, of, h); });
            case 7:
                return box_table(in, map, variance_table{.bits = in.within(0, 13)},
                                 [&](const auto& of, const auto& h) { return make_variance_table(map, of, h); });
        }
        int left = kind - 8;
        prefilters::all::for_each([&](const auto& filter) {
            if (left-- == 0) prefiltered(in, map, filter);
        });
    });
    return 0;
}
