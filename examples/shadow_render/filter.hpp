// SPDX-License-Identifier: MIT
//
// Visibility: fetch, compare, filter. Which filter is chosen in filter.cpp.
//
//     const look_up filter = prepare(options, map, lamp, progress);
//     const umbrage::image<float> visibility = filter(receivers);
//
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <umbrage/core/image.hpp>

#include <progress.hpp>

#include "light.hpp"
#include "options.hpp"
#include "receivers.hpp"

namespace shadow_render {

/// Every filter: over depths, with contact hardening, and over maps that are filtered ahead.
[[nodiscard]] const std::vector<std::string>& filter_names();

/// Texels that the bias has to cover: the options' own, or what the filter asks for.
[[nodiscard]] float reach_of(const options& o);

/// Whether map and receivers are compared in z/w rather than in depths that grow evenly: under a bias that moves stored
/// depths, which those of a filtered map cannot be, and by contact hardening.
[[nodiscard]] bool compares_projected(const options& o);

/// Bytes a texel of what the filter reads.
[[nodiscard]] int bytes_read(const options& o);

using look_up = std::function<umbrage::image<float>(const receivers&)>;

/// Makes a map ready for the filter: maps that are filtered ahead are filtered here.
/// @param map  decoded; outlives what is returned, as do lamp and progress
[[nodiscard]] look_up prepare(const options& o, umbrage::image_view<const float> map, const light& lamp,
                              example::progress& progress);

}  // namespace shadow_render
