// SPDX-License-Identifier: MIT
//
// A file here for each header that defines snippets, of the same path: box.cpp of <umbrage/filter/pcf/box.hpp> stands
// in filter/pcf and defines add_filter_pcf_box, which the build finds.
#pragma once

#include "../values.hpp"

namespace parity {

/// What a user defines for reversed Z.
inline const std::string reversed = "#define UMBRAGE_REVERSED\n";

/// What a user defines for maps outside of which all is lit.
inline const std::string outside_lit = "#define UMBRAGE_OUTSIDE_LIT\n";

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

}  // namespace parity
