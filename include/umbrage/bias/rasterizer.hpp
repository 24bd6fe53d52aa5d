// SPDX-License-Identifier: MIT
//
// Slope-scaled depth bias of the rasterizer, in each API's numbers: the depth pass moves casters away from the light.
// With it no plane has shadow acne under a filter, and receivers need no bias of their own.
//
//     auto [factor, units, clamp] = umbrage::make_polygon_offset({.reach = filter.reach()});
//     glPolygonOffset(factor, units);
//
// Rasterizers multiply by the larger slope of depth, |a| or |b|, but a filter needs |a| + |b|. They also multiply by a
// step of the depth buffer. In a float buffer that is the step at the primitive's largest depth.
// Also called: slope-scaled depth bias, glPolygonOffset (make_polygon_offset); vkCmdSetDepthBias, depthBiasSlopeFactor
// (make_vulkan_depth_bias); DepthBias, SlopeScaledDepthBias (make_direct3d_depth_bias).
#pragma once

#include <cmath>
#include <cstdint>

#include <umbrage/core/check.hpp>
#include <umbrage/core/clip_space.hpp>
#include <umbrage/core/scalar.hpp>
#include <umbrage/light/light_space.hpp>

namespace umbrage {

/// Format of the depth buffer.
enum class depth_format { unorm16, unorm24, float32 };

/// Bias that the rasterizer has to add.
struct raster_bias {
    float reach = 0.5f;         ///< filter radius in texels, as for acne_free_bias
    float constant = 0x1p-23f;  ///< depth units: the encoding's error plus 2^-23
    float greatest = 0.0f;      ///< limit of the bias in depth, 0 for none. Steeper slopes may have acne
    float least_depth = 0.5f;   ///< float buffers: primitives wholly below this depth get less than `constant`; > 0
    depth_format format = depth_format::unorm24;
    depth_direction direction = depth_direction::forward;
};

/// Arguments of glPolygonOffset and glPolygonOffsetClamp.
struct polygon_offset {
    float factor, units;  ///< glPolygonOffset
    float clamp;          ///< glPolygonOffsetClamp
};

/// Arguments of vkCmdSetDepthBias, in order.
struct vulkan_depth_bias {
    float constant_factor, clamp, slope_factor;
};

/// Members of D3D11_RASTERIZER_DESC and D3D12_RASTERIZER_DESC.
struct direct3d_depth_bias {
    std::int32_t depth_bias;
    float depth_bias_clamp, slope_scaled_depth_bias;
};

namespace detail {

/// Bias towards the far plane, in steps of the depth buffer, rounded up.
[[nodiscard]] inline vulkan_depth_bias raster_numbers(const raster_bias& bias, const char* function) {
    const auto not_negative = [](float v) { return is_finite(v) && v >= 0.0f; };
    require(not_negative(bias.reach) && is_finite(2.0f * bias.reach), function, "reach", "finite, 0 or more",
            bias.reach);
    require(not_negative(bias.constant), function, "constant", "finite, 0 or more", bias.constant);
    require(not_negative(bias.greatest), function, "greatest", "finite, 0 or more", bias.greatest);
    require(is_normal(bias.least_depth) && bias.least_depth > 0.0f && bias.least_depth <= 1.0f, function, "least_depth",
            "above 0, no denormal, and at most 1", bias.least_depth);
    const int step = bias.format == depth_format::unorm16   ? -16
                     : bias.format == depth_format::unorm24 ? -24
                                                            : std::ilogb(bias.least_depth) - 23;
    const float units = std::ceil(std::scalbn(bias.constant, -step));
    require(is_finite(units), function, "constant and least_depth", "finite in steps of the depth buffer",
            glm::vec2(bias.constant, bias.least_depth));
    const float away = bias.direction == depth_direction::forward ? 1.0f : -1.0f;
    return {away * units, away * bias.greatest, away * 2.0f * bias.reach};
}

}  // namespace detail

/// Arguments of glPolygonOffset, for GL_POLYGON_OFFSET_FILL.
/// @return        factor 2 reach, units constant / step, both negative for reversed depth
/// @throws std::invalid_argument  values that are negative or not finite; a least_depth outside (0, 1]
[[nodiscard]] inline polygon_offset make_polygon_offset(const raster_bias& bias) {
    const auto numbers = detail::raster_numbers(bias, "make_polygon_offset");
    return {numbers.slope_factor, numbers.constant_factor, numbers.clamp};
}

/// Arguments of vkCmdSetDepthBias. A clamp other than 0 needs the feature depthBiasClamp.
/// @return        the same numbers as make_polygon_offset
/// @throws std::invalid_argument  as make_polygon_offset
[[nodiscard]] inline vulkan_depth_bias make_vulkan_depth_bias(const raster_bias& bias) {
    return detail::raster_numbers(bias, "make_vulkan_depth_bias");
}

/// Members of Direct3D's rasterizer state.
/// @return        the same numbers as make_polygon_offset, the constant as an integer
/// @throws std::invalid_argument  as make_polygon_offset, and more than 2^31 - 128 steps
[[nodiscard]] inline direct3d_depth_bias make_direct3d_depth_bias(const raster_bias& bias) {
    const auto numbers = detail::raster_numbers(bias, "make_direct3d_depth_bias");
    detail::require(std::abs(numbers.constant_factor) < 0x1p31f, "make_direct3d_depth_bias", "constant and least_depth",
                    "below 2^31 steps of the depth buffer", numbers.constant_factor);
    return {static_cast<std::int32_t>(numbers.constant_factor), numbers.clamp, numbers.slope_factor};
}

}  // namespace umbrage
