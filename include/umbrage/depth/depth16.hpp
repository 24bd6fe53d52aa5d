// SPDX-License-Identifier: MIT
//
// Depth texture of 16 bits, as a GPU's depth pass makes it, with the error of its texels. Comparison samplers read it.
//
//     const umbrage::shadow sun(light, {1024, 1024}, umbrage::filters::tent<3>, umbrage::depth16{});
//     umbrage::image<std::uint16_t> map(sun.size(), sun.cleared());
//
// depth32f in its place ignores that error, so lit floors shadow themselves in stripes (acne).
// Also called: D16, D16_UNORM, DEPTH_COMPONENT16, depth16unorm, 16-bit depth texture (depth16).
// See also: depth24.hpp, and r16.hpp for a color target.
#pragma once

#include <cstdint>
#include <string_view>

#include <umbrage/core/scalar.hpp>
#include <umbrage/depth/encoding.hpp>

namespace umbrage {

/// Encoding of a 16-bit depth texture, which the GPU itself writes and reads.
struct depth16 {
    using target = depth_texture<16>;
    using texel = target::texel;
    static constexpr std::string_view name = "depth16";
    static constexpr std::string_view summary = "A depth texture of 16 bits, as the GPU writes it.";
    static constexpr const glsl::snippet* writer = &glsl::saturate;
    static constexpr const glsl::snippet* reader = nullptr;
    static constexpr store_format writes = store_format::depth;
    static constexpr std::uint32_t codes = std::uint32_t(1) << 16;

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
