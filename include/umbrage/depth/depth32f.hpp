// SPDX-License-Identifier: MIT
//
// Shadow map of plain floats, with the interface of an encoding.
//
//     umbrage::image<float> map(size, umbrage::depth32f{}.cleared());
//
#pragma once

#include <string_view>

#include <umbrage/core/scalar.hpp>
#include <umbrage/depth/encoding.hpp>

namespace umbrage {

/// Encoding that stores depth itself, clamped to [0, 1].
struct depth32f {
    using target = float_target;
    using texel = target::texel;
    static constexpr std::string_view name = "depth32f";
    static constexpr std::string_view summary = "A float texture: nothing to encode.";
    static constexpr const glsl::snippet* writer = &glsl::saturate;
    static constexpr const glsl::snippet* reader = nullptr;
    static constexpr store_format writes = store_format::depth;
    static constexpr std::uint64_t codes = 0x3F800001;  ///< number of floats from 0 to 1

    depth_direction direction = depth_direction::forward;

    [[nodiscard]] constexpr texel encode(float depth) const { return saturate(depth, cleared_depth(direction)); }
    [[nodiscard]] constexpr float decode(texel t) const { return t; }
    [[nodiscard]] constexpr decoding_error error(unorm_store = {}) const { return {}; }
    [[nodiscard]] constexpr texel cleared() const { return cleared_depth(direction); }
};

}  // namespace umbrage
