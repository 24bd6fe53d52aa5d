// SPDX-License-Identifier: MIT
//
// The library's filters by name, with a radius where they have one.
//
//     example::with_filter("disc16", 3.0f, [&](const auto& filter) { reach = filter.reach(); });
//
#pragma once

#include <optional>
#include <string_view>

#include <umbrage/filter/filters.hpp>

namespace example {

/// The filter with that radius, in texels; as it is by itself where it has none, and without one.
template <class Filter>
[[nodiscard]] Filter with_radius(Filter filter, [[maybe_unused]] std::optional<float> radius) {
    if constexpr (requires { filter.radius; })
        if (radius) filter.radius = static_cast<int>(*radius);
    if constexpr (requires { filter.radius_texels; })
        if (radius) filter.radius_texels = *radius;
    return filter;
}

/// Calls use(filter) with the one of that name.
/// @return   false where none is called so
template <class Use>
bool with_filter(std::string_view name, std::optional<float> radius, Use&& use) {
    return umbrage::with_filter(name, [&](const auto& filter) { use(with_radius(filter, radius)); });
}

}  // namespace example
