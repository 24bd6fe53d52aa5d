// SPDX-License-Identifier: MIT
#include <cmath>

#include <umbrage/depth/rg.hpp>
#include <umbrage/filter/pcf/box.hpp>
#include <umbrage/filter/pcf/four_tap.hpp>
#include <umbrage/filter/pcf/pcf_2x2.hpp>

#include "entries.hpp"

namespace parity {
namespace {

using namespace umbrage;

/// Pairs of depths in x0.x and x0.y, and an epsilon in x0.z; in "ties" the pair is equal, or an ulp or the epsilon apart.
std::vector<input_class> pairs() {
    auto classes = spread({{0.0f, 1.0f}, {0.0f, 1.0f}, {0.0f, 0.01f}}, depth_values());
    classes.push_back({"ties", [](std::uint64_t i, random& r, sample& s) {
                           const float depth = r.unit(), epsilon = static_cast<float>(r.below(64)) / 4096.0f;
                           const float other[] = {depth, std::nextafter(depth, 2.0f), std::nextafter(depth, -1.0f), depth + epsilon};
                           s.x[0] = {other[i % 4], depth, epsilon, 0.0f};
                       }});
    return classes;
}

/// Every fraction of 1/256 in both directions with every outcome of the four comparisons, somewhere on the map.
enumeration all_weights() {
    return {{"256 x 256 fractions, 16 masks", [](std::uint64_t i, random& r, sample& s) {
                 const auto depth = s.depth();
                 for (;;) {
                     const ivec2 texel(r.below(s.map.size.x - 1), r.below(s.map.size.y - 1));
                     const float taps[] = {depth(texel), depth(texel + ivec2(1, 0)), depth(texel + ivec2(0, 1)), depth(texel + ivec2(1, 1))};
                     const float receiver = r.below(8) == 0 ? 2.0f : taps[r.below(4)];
                     std::uint64_t mask = 0;
                     for (int t = 0; t < 4; ++t) mask |= std::uint64_t(receiver <= taps[t]) << t;
                     if (mask != (i & 15)) continue;
                     const vec2 fraction(static_cast<float>(i >> 4 & 255), static_cast<float>(i >> 12));
                     s.x[0] = vec4(vec2(texel) + 0.5f + fraction / 256.0f, receiver, 0.0f);
                     return;
                 }
             }}, 1 << 20};
}

/// receivers() with three more taps beside the first in x1 and x2.xy.
std::vector<input_class> four_taps() {
    auto classes = receivers();
    for (input_class& c : classes)
        c.fill = [one = c.fill](std::uint64_t i, random& r, sample& s) {
            one(i, r, s);
            const auto beside = [&](int lane) { return s.x[0][lane] + r.between(-1.5f, 1.5f); };
            s.x[1] = {beside(0), beside(1), beside(0), beside(1)};
            s.x[2] = {beside(0), beside(1), 0.0f, 0.0f};
        };
    return classes;
}

vec2 at(const sample& s) { return vec2(s.x[0]); }
int radius_of(const sample& s) { return static_cast<int>(s.x[0].w); }

vec4 taps(const sample& s, auto... is_lit) {
    const vec4 x = s.x[1];
    return vec4(four_tap(s.depth(), at(s), vec2(x.x, x.y), vec2(x.z, x.w), vec2(s.x[2]), s.x[0].z, is_lit...));
}

// What a user defines for reversed Z.
const std::string reversed = "#define UMBRAGE_LIT(receiver, stored) ((receiver) >= (stored) ? 1.0 : 0.0)\n";

// And for a map of two channels.
const std::string packed =
    "#define UMBRAGE_FETCH(map, size, texel) umbrage_decode_rg11(vec2(umbrage_fetch_clamped(map, size, texel)), 0.5)\n";

}  // namespace

void add_filter(std::vector<entry>& all) {
    namespace glsl = umbrage::glsl;

    all.push_back({.primitive = &glsl::compare, .classes = pairs(),
                   .twin = [](const sample& s) { return vec4(compare(s.x[0].x, s.x[0].y)); },
                   .call = "vec4(umbrage_compare(x0.x, x0.y))"});
    all.push_back({.primitive = &glsl::compare, .variant = "reversed", .classes = pairs(),
                   .twin = [](const sample& s) { return vec4(compare(s.x[0].x, s.x[0].y, greater_equal{})); },
                   .call = "vec4(umbrage_compare(x0.x, x0.y))", .preamble = reversed});
    all.push_back({.primitive = &glsl::compare_dx_sdk, .classes = pairs(),
                   .twin = [](const sample& s) { return vec4(compare_dx_sdk(s.x[0].x, s.x[0].y, s.x[0].z)); },
                   .call = "vec4(umbrage_compare_dx_sdk(x0.x, x0.y, x0.z))"});
    all.push_back({.primitive = &glsl::compare_exercise, .classes = pairs(),
                   .twin = [](const sample& s) { return vec4(compare_exercise(s.x[0].x, s.x[0].y, s.x[0].z)); },
                   .call = "vec4(umbrage_compare_exercise(x0.x, x0.y, x0.z))"});

    const auto filter = [&](const snippet& s, const std::string& arguments, std::function<vec4(const sample&)> twin,
                            enumeration whole = {}) {
        all.push_back({.primitive = &s, .classes = receivers(), .whole = std::move(whole), .twin = std::move(twin),
                       .call = "vec4(umbrage_" + std::string(s.name) + "(map, map_size, vec2(x0.x, x0.y), x0.z" + arguments + "))",
                       .maps = depth_maps()});
    };
    filter(glsl::hard, "", [](const sample& s) { return vec4(hard(s.depth(), at(s), s.x[0].z)); });
    filter(glsl::pcf_2x2, "", [](const sample& s) { return vec4(pcf_2x2(s.depth(), at(s), s.x[0].z)); },
           all_weights());
    filter(glsl::pcf_2x2_dx_sdk, ", 0.015625",
           [](const sample& s) { return vec4(pcf_2x2_dx_sdk(s.depth(), at(s), s.x[0].z, 0.015625f)); });
    filter(glsl::box_count, ", int(x0.w)",
           [](const sample& s) { return vec4(box_count(s.depth(), at(s), s.x[0].z, radius_of(s))); });
    filter(glsl::box, ", int(x0.w)", [](const sample& s) { return vec4(box(s.depth(), at(s), s.x[0].z, radius_of(s))); });
    all.push_back({.primitive = &glsl::box_scale, .classes = receivers(),
                   .twin = [](const sample& s) { return vec4(box_scale<float>(radius_of(s))); },
                   .call = "vec4(umbrage_box_scale(int(x0.w)))", .maps = depth_maps()});

    const std::string call =
        "vec4(umbrage_four_tap(map, map_size, vec2(x0.x, x0.y), vec2(x1.x, x1.y), vec2(x1.z, x1.w), vec2(x2.x, x2.y), x0.z))";
    all.push_back({.primitive = &glsl::four_tap, .classes = four_taps(), .twin = [](const sample& s) { return taps(s); },
                   .call = call, .maps = depth_maps()});
    all.push_back({.primitive = &glsl::four_tap, .variant = "reversed", .classes = four_taps(),
                   .twin = [](const sample& s) { return taps(s, greater_equal{}); }, .call = call, .maps = depth_maps(),
                   .preamble = reversed});
    all.push_back({.primitive = &glsl::pcf_2x2, .variant = "reversed", .classes = receivers(),
                   .twin = [](const sample& s) { return vec4(pcf_2x2(s.depth(), at(s), s.x[0].z, greater_equal{})); },
                   .call = "vec4(umbrage_pcf_2x2(map, map_size, vec2(x0.x, x0.y), x0.z))", .maps = depth_maps(),
                   .preamble = reversed});
    all.push_back({.primitive = &glsl::pcf_2x2, .variant = "packed map", .classes = receivers(),
                   .twin = [](const sample& s) {
                       const auto depth = [view = s.map](ivec2 texel) {
                           return decode_rg<11>(vec2(fetch_clamped(view, texel)), 0.5f);
                       };
                       return vec4(pcf_2x2(depth, at(s), s.x[0].z));
                   },
                   .call = "vec4(umbrage_pcf_2x2(map, map_size, vec2(x0.x, x0.y), x0.z))", .maps = packed_maps(),
                   .before = {&glsl::decode_rg<11>}, .preamble = packed});
}

}  // namespace parity
