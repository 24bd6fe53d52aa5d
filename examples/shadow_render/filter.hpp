// SPDX-License-Identifier: MIT
//
// Visibility: fetch, compare, filter. Which filter is chosen in filter.cpp.
#pragma once

#include <umbrage/image.hpp>

#include <progress.hpp>

#include "options.hpp"
#include "receivers.hpp"

namespace shadow_render {

/// @param map  decoded
[[nodiscard]] umbrage::image<float> visibility_of(const options& o, umbrage::image_view<const float> map,
                                                  const light& lamp, const receivers& receivers,
                                                  example::progress& progress);

}  // namespace shadow_render
