// SPDX-License-Identifier: MIT
//
// A file here for each header that defines snippets, of the same path: box.cpp of <umbrage/filter/pcf/box.hpp> stands
// in filter/pcf and defines add_filter_pcf_box, which the build finds.
#pragma once

#include <umbrage/filter/pcf/hard.hpp>

#include "../values.hpp"

namespace parity {

/// The coordinate that receivers() fills.
[[nodiscard]] inline vec2 at(const sample& s) { return vec2(s.x[0]); }

/// The texel that whole_texels() fills.
[[nodiscard]] inline ivec2 texel_of(const sample& s) { return ivec2(at(s)); }

/// A filter called with map, size, receivers() and what else it takes, e.g. ", 0.5".
[[nodiscard]] inline entry filter(const snippet& s, const std::string& arguments,
                                  std::function<vec4(const sample&)> twin, enumeration whole = {}) {
    return {.primitive = &s,
            .classes = receivers(),
            .whole = std::move(whole),
            .twin = std::move(twin),
            .call = "vec4(umbrage_" + std::string(s.name) + "(map, map_size, vec2(x0.x, x0.y), x0.z" + arguments + "))",
            .maps = depth_maps()};
}
[[nodiscard]] inline entry reversed_filter(const snippet& s, const std::string& arguments,
                                           std::function<vec4(const sample&)> twin) {
    entry e = filter(s, arguments, std::move(twin));
    e.variant = "reversed";
    e.map_kind.direction = umbrage::depth_direction::reversed;
    return e;
}

/// A filter of a map as bind() has it.
/// @param twin   (fetch, sample, is_lit) -> visibility
template <class Twin>
[[nodiscard]] entry bound_filter(const snippet& s, const std::string& arguments, const std::string& variant,
                                 const umbrage::glsl::binding& as, Twin twin) {
    entry e = filter(s, arguments, [as, twin](const sample& x) {
        const umbrage::comparison is_lit{as.direction};
        return vec4(umbrage::glsl::detail::is_bordered(as)
                        ? twin(x.bordered_depth(umbrage::cleared_depth(as.direction)), x, is_lit)
                        : twin(x.depth(), x, is_lit));
    });
    e.variant = variant;
    e.maps = plain_maps({{64, 64}, {37, 21}, {3, 2}, {1, 1}});
    e.bound = {{.name = "map", .as = as}};
    e.share = 16;
    return e;
}
/// Entry whose sampler weights comparisons.
template <class Twin>
[[nodiscard]] entry sampled_filter(const snippet& s, const std::string& arguments, const std::string& variant,
                                   const umbrage::glsl::binding& as, Twin twin) {
    entry e = bound_filter(s, arguments, variant, as, twin);
    e.bound.front().linear = true;
    return e;
}

/// A filter over packed maps that are compared on a scale of their own.
/// @param level      what makes a value a level, and its call of `value`
/// @param receiver   what makes x0.z a receiver, and its call
[[nodiscard]] inline entry levels(const snippet& level, const std::string& of_value, const snippet& receiver,
                                  const std::string& of_depth, std::function<vec4(const sample&)> twin) {
    return {.primitive = &level,
            .variant = "compared",
            .classes = receivers(),
            .twin = std::move(twin),
            .call = "vec4(umbrage_hard(map, map_size, vec2(x0.x, x0.y), " + of_depth + "))",
            .maps = packed_maps(),
            .also = {&umbrage::glsl::hard, &receiver},
            .map_kind = {.outside = umbrage::outside_map::clamped, .depth = of_value, .channels = 2, .needs = {level}}};
}

}  // namespace parity
