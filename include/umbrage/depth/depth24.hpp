// SPDX-License-Identifier: MIT
//
// Depth texture of 24 bits, as a GPU's depth pass makes it, with the error of its texels. Comparison samplers read it.
//
//     const umbrage::shadow sun(light, {1024, 1024}, umbrage::filters::tent<3>, umbrage::depth24{});
//     umbrage::image<std::uint32_t> map(sun.size(), sun.cleared());  // depth in the low 24 bits
//
// WebGPU's depth24plus is this texture or a float one, which a browser may choose. The error of 24 bits covers both.
// Also called: D24, D24_UNORM_S8_UINT, X8_D24_UNORM_PACK32, DEPTH_COMPONENT24, depth24plus (depth24).
// See also: depth16.hpp.
#pragma once

#include <cstdint>
#include <string_view>

#include <umbrage/core/scalar.hpp>
#include <umbrage/depth/encoding.hpp>

namespace umbrage {

/// Encoding of a 24-bit depth texture, which the GPU itself writes and reads.
struct depth24 {
    using target = depth_texture<24>;
    using texel = target::texel;
    static constexpr std::string_view name = "depth24";
    static constexpr std::string_view summary = "A depth texture of 24 bits, as the GPU writes it.";
    static constexpr const glsl::snippet* writer = &glsl::saturate;
    static constexpr const glsl::snippet* reader = nullptr;
    static constexpr store_format writes = store_format::depth;
    static constexpr std::uint32_t codes = std::uint32_t(1) << 24;

    depth_direction direction = depth_direction::forward;

    [[nodiscard]] constexpr texel encode(float depth) const {
        return target::store(saturate(depth, cleared_depth(direction)));
    }
    [[nodiscard]] constexpr float decode(texel t) const { return target::depth_of(t); }
    [[nodiscard]] constexpr decoding_error error(unorm_store mode = {}) const {
        return {target::error(mode), target::error(mode)};
    }
    [[nodiscard]] constexpr texel cleared() const { return encode(cleared_depth(direction)); }
};

}  // namespace umbrage
