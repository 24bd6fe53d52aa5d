// SPDX-License-Identifier: MIT
//
// Every filter of the library, in one list: what tools, tables, proofs and examples walk.
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

using all = list_of<hard, four_tap, pcf_2x2, pcf_2x2_dx_sdk, box, window, disc>;

/// Beside them those that know the light's size: their maps hold z/w.
using soft = list_of<pcss, dpcf>;

}  // namespace umbrage::filters

namespace umbrage {

/// Calls use(filter) for one after the other.
template <class Use>
void for_each_filter(Use&& use) {
    filters::all::for_each(use);
}

/// Calls use(filter) with the one of that name.
/// @return   false where none is called so
template <class Use>
bool with_filter(std::string_view name, Use&& use) {
    return filters::all::with(name, use);
}

}  // namespace umbrage
