// SPDX-License-Identifier: MIT
//
// Render targets for encoded depths: bits per channel, channels, format, and layout in memory. An encoding names its
// target. Tools, tables and shaders read these facts from it.
//
//     using target = umbrage::unorm_target<8, 2>;  // RG8
//     glm::u8vec2 texel = target::store(umbrage::to_unorm(glm::vec2(channels)), umbrage::unorm_store::rounds);
//
#pragma once

#include <concepts>
#include <cstdint>
#include <string_view>
#include <type_traits>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/core/snippet.hpp>
#include <umbrage/core/unorm.hpp>

namespace umbrage {

/// Render target and texture for encoded depths.
template <class Target>
concept render_target = requires {
    typename Target::texel;                                       // layout in memory
    { Target::channels } -> std::convertible_to<int>;             // number of channels that a shader writes and reads
    { Target::format } -> std::convertible_to<std::string_view>;  // OpenGL's name
    { Target::depth_format } -> std::convertible_to<std::string_view>;  // of a depth texture; empty: none holds it
    {
        Target::to_unorm
        } -> std::convertible_to<const glsl::snippet*>;  // turns integer channels into values; null: floats
    { Target::load(typename Target::texel{}) } -> std::same_as<glm::vec4>;  // as sampled; missing channels are 0
};

/// Float target, or a float depth texture.
struct float_target {
    using texel = float;
    static constexpr int channels = 1;
    static constexpr std::string_view format = "R32F", depth_format = "DEPTH_COMPONENT32F";
    static constexpr const glsl::snippet* to_unorm = nullptr;

    [[nodiscard]] static glm::vec4 load(texel t) { return {t, 0, 0, 0}; }
};

/// Depth texture of 16 or 24 bits. The GPU converts depths to them, and back where a shader samples or compares.
///
/// A texel of 24 bits has the depth in its low bits, as in Vulkan and Direct3D. Its high bits may hold a stencil.
/// OpenGL's UNSIGNED_INT_24_8 has the depth in the high bits.
template <int Bits>
struct depth_texture {
    static_assert(Bits == 16 || Bits == 24, "depth textures of integers have 16 or 24 bits");
    using texel = std::conditional_t<Bits == 16, std::uint16_t, std::uint32_t>;
    static constexpr int bits = Bits, channels = 1;
    static constexpr std::string_view format = Bits == 16 ? "DEPTH_COMPONENT16" : "DEPTH_COMPONENT24";
    static constexpr std::string_view depth_format = format;
    static constexpr const glsl::snippet* to_unorm = nullptr;
    static constexpr std::uint32_t most = (std::uint32_t(1) << Bits) - 1;

    /// Texel of a depth.
    /// @param depth   in [0, 1]
    /// @param mode    GPUs round to nearest. Vulkan and OpenGL let them truncate
    [[nodiscard]] static constexpr texel store(float depth, unorm_store mode = {}) {
        const double scaled = double(depth) * most;  // a double has the product's 48 bits
        return static_cast<texel>(mode == unorm_store::rounds ? scaled + 0.5 : scaled);
    }
    /// Depth that sampling returns: k / (2^Bits - 1), rounded to a float.
    [[nodiscard]] static constexpr float depth_of(texel t) { return static_cast<float>((t & most) * (1.0 / most)); }
    [[nodiscard]] static glm::vec4 load(texel t) { return {depth_of(t), 0, 0, 0}; }

    /// Largest error of a sampled depth: half a step where the texture rounds, a step where it truncates, and the
    /// rounding to a float.
    [[nodiscard]] static constexpr double error(unorm_store mode) {
        return (mode == unorm_store::rounds ? 0.5 : 1.0) / most + 0x1p-25;
    }
};

namespace detail {

/// Texel of one or more channels. One channel is a number, not a vector.
template <int Bits, int Channels>
using unorm_texel = std::conditional_t<Channels == 1, unorm_channel<Bits>,
                                       glm::vec<(Channels > 1 ? Channels : 2), unorm_channel<Bits>>>;

}  // namespace detail

/// UNORM channels of 8 or 16 bits. For 10 bits there is only the form below. A texel has the target's bytes, but three
/// channels have those of four under GLM_FORCE_DEFAULT_ALIGNED_GENTYPES.
template <int Bits, int Channels>
struct unorm_target {
    static_assert(Bits == 8 || Bits == 16, "of 10 bits a channel there is unorm_target<10, 3> alone");
    using texel = detail::unorm_texel<Bits, Channels>;
    static constexpr int bits = Bits, channels = Channels;
    static constexpr std::string_view formats[2][4]{{"R8", "RG8", "RGB8", "RGBA8"}, {"R16", "RG16", "RGB16", "RGBA16"}};
    static constexpr std::string_view format = formats[Bits == 16][Channels - 1];
    static constexpr std::string_view depth_format = Bits == 16 && Channels == 1 ? "DEPTH_COMPONENT16" : "";
    static constexpr const glsl::snippet* to_unorm = Bits == 16 ? &glsl::to_unorm16 : &glsl::to_unorm;

    /// Texel that a UNORM store makes of the values.
    /// @param values   as a shader writes them
    /// @param mode     rounding of values between two channel steps
    template <class Values>
    [[nodiscard]] static constexpr texel store(Values values, unorm_store mode = {}) {
        return store_unorm<Bits>(values, mode);
    }
    [[nodiscard]] static glm::vec4 load(texel t) {
        glm::vec<4, unorm_channel<Bits>> all(0);
        if constexpr (Channels == 1) all.x = t;
        else
            for (int i = 0; i < Channels; ++i) all[i] = t[i];
        return load_unorm<Bits>(all);
    }
};

/// R10G10B10A2: three 10-bit channels in a word, R in the lowest bits. Alpha is 1.
template <>
struct unorm_target<10, 3> {
    using texel = std::uint32_t;
    static constexpr int bits = 10, channels = 3;
    static constexpr std::string_view format = "RGB10_A2", depth_format = "";
    static constexpr const glsl::snippet* to_unorm = &glsl::to_unorm10;

    [[nodiscard]] static constexpr texel packed(glm::u16vec3 k) {
        return std::uint32_t(k.x) | std::uint32_t(k.y) << 10 | std::uint32_t(k.z) << 20 | 3u << 30;
    }
    [[nodiscard]] static glm::u16vec3 unpacked(texel t) { return {t & 1023, t >> 10 & 1023, t >> 20 & 1023}; }
    [[nodiscard]] static texel store(glm::vec3 values, unorm_store mode = {}) {
        return packed(store_unorm<10>(values, mode));
    }
    [[nodiscard]] static glm::vec4 load(texel t) { return {load_unorm<10>(unpacked(t)), 0}; }
};

}  // namespace umbrage
