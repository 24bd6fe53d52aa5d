// SPDX-License-Identifier: MIT
//
// Names of the entries that go from a world position to its visibility.
#pragma once

#include <string>

#include "ray_light.hpp"

namespace parity {

inline constexpr std::array ray_kinds{ray_kind::spot, ray_kind::directional, ray_kind::cascade};
[[nodiscard]] constexpr std::string_view name(ray_kind kind) {
    constexpr std::string_view names[]{"spot light", "directional light", "cascade"};
    return names[static_cast<std::size_t>(kind)];
}

/// An entry's variant.
[[nodiscard]] inline std::string from_world(ray_kind kind, std::string_view filter) {
    return "from world, " + std::string(name(kind)) + ", " + std::string(filter);
}

/// A filter of these entries: what it reads, and where its result changes.
struct filter_steps {
    std::string_view name;
    float reach;  ///< texels
    int steps;    ///< a texel: the result is constant from one to the next
};
inline constexpr filter_steps filters_from_world[]{{"hard", 0.5f, 1}, {"pcf_2x2", 1.0f, 256}, {"binomial5", 3.0f, 256}};

}  // namespace parity
