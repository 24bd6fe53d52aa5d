// SPDX-License-Identifier: MIT
//
// List of every filter in this library, for tools, tables, proofs and examples.
//
//     umbrage::visibility(map, umbrage::rg<11>{}, receivers, umbrage::filters::box{.radius = 2}, out);
//
#pragma once

#include <string_view>

#include <umbrage/core/list.hpp>
#include <umbrage/filter/blocker/dpcf.hpp>
#include <umbrage/filter/blocker/pcss.hpp>
#include <umbrage/filter/filter.hpp>
#include <umbrage/filter/pcf/box.hpp>
#include <umbrage/filter/pcf/disc.hpp>
#include <umbrage/filter/pcf/four_tap.hpp>
#include <umbrage/filter/pcf/hard.hpp>
#include <umbrage/filter/pcf/pcf_2x2.hpp>
#include <umbrage/filter/pcf/windows.hpp>

namespace umbrage::filters {

/// List of the filters that need no size of the light.
using all = list_of<hard, four_tap, pcf_2x2, pcf_2x2_dx_sdk, box, window, disc>;

/// Filters that also know the size of the light. Their maps must store z/w.
using soft = list_of<pcss, dpcf>;

}  // namespace umbrage::filters

namespace umbrage {

/// Calls use(filter) once for each filter of filters::all, in order.
template <class Use>
void for_each_filter(Use&& use) {
    filters::all::for_each(use);
}

/// Calls use(filter) with the filter of that name.
/// @return   false when no filter has that name
template <class Use>
bool with_filter(std::string_view name, Use&& use) {
    return filters::all::with(name, use);
}

}  // namespace umbrage
