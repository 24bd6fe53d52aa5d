// SPDX-License-Identifier: MIT
//
// Every filter of the library, in one list: what tools, tables, proofs and examples walk. Each comes with its form for
// blocks of receivers.
//
//     umbrage::visibility(map, umbrage::rg<11>{}, receivers, umbrage::filters::box{.radius = 2}, out);
//
#pragma once

#include <tuple>

#include <umbrage/filter/filter.hpp>
#include <umbrage/simd/blocks/box.hpp>
#include <umbrage/simd/blocks/four_tap.hpp>
#include <umbrage/simd/blocks/hard.hpp>
#include <umbrage/simd/blocks/hierarchical_box.hpp>
#include <umbrage/simd/blocks/pcf_2x2.hpp>

namespace umbrage::filters {

/// A tuple of all: filters::all{} has a value of each.
using all = std::tuple<hard, four_tap, pcf_2x2, pcf_2x2_dx_sdk, box, hierarchical_box>;

}  // namespace umbrage::filters

namespace umbrage {

/// Calls use(filter) for one after the other.
template <class Use>
void for_each_filter(Use&& use) {
    std::apply([&](const auto&... filter) { (use(filter), ...); }, filters::all{});
}

/// Calls use(filter) with the one of that name.
/// @return   false where none is called so
template <class Use>
bool with_filter(std::string_view name, Use&& use) {
    bool found = false;
    for_each_filter([&](const auto& filter) {
        if (found || filter.name != name) return;
        found = true;
        use(filter);
    });
    return found;
}

}  // namespace umbrage
