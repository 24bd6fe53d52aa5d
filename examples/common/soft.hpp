// SPDX-License-Identifier: MIT
//
// Soft shadows by name: contact hardening over a map of depths, and maps that are filtered ahead.
//
//     const example::look_up soft = example::prefiltered("evsm4", map, 2, progress);
//     soft(receivers, visibility);
//
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <umbrage/core/image.hpp>
#include <umbrage/filter/blocker/penumbra.hpp>
#include <umbrage/images/plane_visibility.hpp>
#include <umbrage/images/receivers.hpp>

#include "progress.hpp"

namespace example {

/// Visibility of receivers, by a filter that was made ready for a map. Slopes count for contact hardening alone.
using look_up = std::function<void(const umbrage::sloped_receivers&, umbrage::image_view<float>)>;

/// Names of umbrage::filters::soft.
[[nodiscard]] const std::vector<std::string>& hardening_names();

/// Names of umbrage::prefilters and of summed-area tables.
[[nodiscard]] const std::vector<std::string>& prefilter_names();

/// Bits of the depths in a summed-area table of variances.
inline constexpr int variance_bits = 12;

/// True for one of hardening_names().
[[nodiscard]] bool hardens(std::string_view filter);
[[nodiscard]] bool filters_ahead(std::string_view filter);

/// Bytes a texel of a prefiltered map.
[[nodiscard]] int prefilter_bytes(std::string_view name);

/// Texels that a bias has to cover: the widest penumbra's; of a prefiltered map what lies between a receiver and the
/// middle of its window, which has the window's mean depth where that is a plane.
/// @param max_radius  texels
/// @return         nothing where no soft shadows are called so
[[nodiscard]] std::optional<float> soft_reach(std::string_view name, float max_radius);

/// @param map      z/w; outlives what is returned, as does progress. Receivers without slopes, which are empty images,
///                 are compared as they are
/// @throws std::invalid_argument  none of hardening_names()
[[nodiscard]] look_up contact_hardening(std::string_view name, umbrage::image_view<const float> map,
                                        const umbrage::penumbra_params& softness, progress& progress);

/// @param map      depths that grow evenly
/// @param radius   of a Gaussian with half of it as deviation, or of a summed-area table's box, texels
/// @throws std::invalid_argument  none of prefilter_names()
[[nodiscard]] look_up prefiltered(std::string_view name, umbrage::image_view<const float> map, int radius,
                                  progress& progress);

}  // namespace example
