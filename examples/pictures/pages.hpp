// SPDX-License-Identifier: MIT
//
// The pictures of the pages, each made by a function.
#pragma once

#include <string_view>

#include "canvas.hpp"

namespace pictures {

/// The default scene, beside it the same with cascades tinted, and its shadow map.
/// @param width  width of the picture, pixels
[[nodiscard]] picture hero(int width);

/// The default scene as its light and its camera see it, with one point of a shadow marked in both.
/// @param width  width of the picture, pixels
[[nodiscard]] picture two_views(int width);

/// One part of the scene under rays and eight filters, each with its best bias and its costs.
/// @param side  of a part, pixels
[[nodiscard]] picture filter_strip(int side);

/// A mast's shadow from its foot to a wall, under rays, filters of one width and contact hardening.
[[nodiscard]] picture hardening_strip(int side);

/// The same part under one filter and six biases.
[[nodiscard]] picture bias_strip(int side);

/// The same part under depths of few bits: 8 to 24, z/w and linear, near planes, without a bias for what is lost.
[[nodiscard]] picture depth_strip(int side);

/// A view outdoors with its four cascades in colors, and their maps.
/// @param width  width of the picture, pixels
[[nodiscard]] picture cascade_ranges(int width);

/// The same view with the pages of a virtual shadow map in colors of their levels, and the whole map.
[[nodiscard]] picture page_grid(int width);

/// The four original systems, as their programs draw them.
/// @param width  of each, pixels
[[nodiscard]] picture originals(int width);

/// One of shadow_render::troubles, wrong and cured.
[[nodiscard]] picture trouble(std::string_view name, int side);

}  // namespace pictures
