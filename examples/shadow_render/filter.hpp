// SPDX-License-Identifier: MIT
//
// Visibility: fetch, compare, filter. Which filter is chosen in filter.cpp.
#pragma once

#include <umbrage/image.hpp>

#include <progress.hpp>

#include "options.hpp"
#include "view.hpp"

namespace shadow_render {

/// How far from a receiver the farthest texel of the options' filter can be, per direction, in texels.
[[nodiscard]] float reach_of(const options& o);

/// @param map  decoded
[[nodiscard]] umbrage::image<float> visibility_of(const options& o, const umbrage::image<float>& map,
                                                  const receivers& receivers, example::progress& progress);

}  // namespace shadow_render
