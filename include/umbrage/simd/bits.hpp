// SPDX-License-Identifier: MIT
//
// Comparisons, selections and conversions of floats by operations on their bits. They have no branch, so loops over
// blocks vectorize, and they handle NaN even under -ffast-math. Masks have all bits set, or none.
//
//     visibility[i] = select(texel_space_mask(x, y), sum, 1.0f);
//
#pragma once

#include <cstdint>

#include <umbrage/core/config.hpp>
#include <umbrage/simd/strict_math.hpp>

namespace umbrage::detail {

/// Mask of the floats that are not NaN.
[[nodiscard]] UMBRAGE_INLINE inline std::int32_t number_mask(float v) {
    return -std::int32_t((detail::bit_cast<std::int32_t>(v) & 0x7FFFFFFF) <= 0x7F800000);
}

/// Mask of the floats that are neither NaN nor infinite.
[[nodiscard]] UMBRAGE_INLINE inline std::int32_t finite_mask(float v) {
    return -std::int32_t((detail::bit_cast<std::int32_t>(v) & 0x7FFFFFFF) < 0x7F800000);
}

/// inside_texel_space as a mask.
[[nodiscard]] UMBRAGE_INLINE inline std::int32_t texel_space_mask(float x, float y) {
    constexpr auto limit = detail::bit_cast<std::int32_t>(32768.0f);
    return -(std::int32_t((detail::bit_cast<std::int32_t>(x) & 0x7FFFFFFF) < limit) &
             std::int32_t((detail::bit_cast<std::int32_t>(y) & 0x7FFFFFFF) < limit));
}

/// beyond_far_plane of a comparison as a mask.
template <bool Forward>
[[nodiscard]] UMBRAGE_INLINE inline std::int32_t beyond_far_plane_mask(float depth) {
    constexpr std::int32_t one = 0x3F800000, infinity = 0x7F800000;
    const auto bits = detail::bit_cast<std::int32_t>(depth);
    if constexpr (Forward) return -(std::int32_t(bits > one) & std::int32_t(bits <= infinity));
    const std::int32_t magnitude = bits & 0x7FFFFFFF;
    return -(std::int32_t(bits < 0) & std::int32_t(magnitude > 0) & std::int32_t(magnitude <= infinity));
}

[[nodiscard]] UMBRAGE_INLINE inline float masked(float v, std::int32_t mask) {
    return detail::bit_cast<float>(detail::bit_cast<std::int32_t>(v) & mask);
}
[[nodiscard]] UMBRAGE_INLINE inline double masked(double v, std::int64_t mask) {
    return detail::bit_cast<double>(detail::bit_cast<std::int64_t>(v) & mask);
}
[[nodiscard]] UMBRAGE_INLINE inline float select(std::int32_t mask, float a, float b) {
    return detail::bit_cast<float>((detail::bit_cast<std::int32_t>(a) & mask) |
                                   (detail::bit_cast<std::int32_t>(b) & ~mask));
}

/// |v|, also of NaN.
[[nodiscard]] UMBRAGE_INLINE inline float magnitude(float v) {
    return detail::bit_cast<float>(detail::bit_cast<std::int32_t>(v) & 0x7FFFFFFF);
}

/// glm::clamp(v, 0, 1). NaN stays NaN.
[[nodiscard]] UMBRAGE_INLINE inline float clamped_to_one(float v) {
    const float low = select(-std::int32_t(v < 0.0f), 0.0f, v);
    return select(-std::int32_t(low > 1.0f), 1.0f, low);
}

/// less_equal as 0 or 1. NaN gives 0 under any compiler flag.
[[nodiscard]] UMBRAGE_INLINE inline std::int32_t is_lit(float receiver, float stored) {
    if constexpr (finite_math_only)
        return std::int32_t(receiver <= stored) & number_mask(receiver) & number_mask(stored);
    else return std::int32_t(receiver <= stored);
}

/// apply_receiver_plane of one texel.
/// @param plane   depth of the plane at the texel
template <bool Forward>
[[nodiscard]] UMBRAGE_INLINE inline float lit_on_plane(float receiver, float plane, float stored) {
    const float reference = (Forward ? plane < receiver : plane > receiver) ? plane : receiver;
    const std::int32_t lit = Forward ? is_lit(reference, stored) : is_lit(stored, reference);
    return select(-lit, Forward ? 1.0f : 0.0f, stored);
}

/// floor(v), for |v| < 2^31.
[[nodiscard]] UMBRAGE_INLINE inline std::int32_t floor_int(float v) {
    const auto toward_zero = static_cast<std::int32_t>(v);
    return toward_zero - std::int32_t(static_cast<float>(toward_zero) > v);
}

/// v, clamped to 0 .. highest.
[[nodiscard]] UMBRAGE_INLINE inline std::int32_t clamp_int(std::int32_t v, std::int32_t highest) {
    v = v > 0 ? v : 0;
    return v < highest ? v : highest;
}

/// floor(v), clamped to 0 .. highest <= 2^24. NaN gives one of the ends. A float that is not negative truncates to its
/// floor, and has the order of its bits.
[[nodiscard]] UMBRAGE_INLINE inline std::int32_t floor_within(float v, float highest) {
    const auto bits = detail::bit_cast<std::int32_t>(v), top = detail::bit_cast<std::int32_t>(highest);
    const std::int32_t positive = bits > 0 ? bits : 0;
    return static_cast<std::int32_t>(detail::bit_cast<float>(positive < top ? positive : top));
}

/// Magnitude of floor(v), at most `limit`, an integer below 2^24. NaN gives `limit`.
[[nodiscard]] UMBRAGE_INLINE inline std::int32_t floor_magnitude(float v, float limit) {
    const auto bits = detail::bit_cast<std::int32_t>(v), top = detail::bit_cast<std::int32_t>(limit);
    const std::int32_t magnitude = bits & 0x7FFFFFFF;
    const auto within = detail::bit_cast<float>(magnitude < top ? magnitude : top);
    const auto whole = static_cast<std::int32_t>(within);
    return whole + (bits < 0 && static_cast<float>(whole) < within ? 1 : 0);
}

/// Floats as integers in the same order, and back. -0 is below +0, and NaN is below everything.
[[nodiscard]] UMBRAGE_INLINE inline std::int32_t order_key(float v) {
    const auto bits = detail::bit_cast<std::int32_t>(v);
    const std::int32_t number = number_mask(v);
    return ((bits ^ (bits >> 31 & 0x7FFFFFFF)) & number) | (INT32_MIN & ~number);
}
[[nodiscard]] UMBRAGE_INLINE inline float from_order_key(std::int32_t key) {
    return detail::bit_cast<float>(key ^ (key >> 31 & 0x7FFFFFFF));
}
struct least_of {
    UMBRAGE_INLINE std::int32_t operator()(std::int32_t a, std::int32_t b) const { return a < b ? a : b; }
};
struct greatest_of {
    UMBRAGE_INLINE std::int32_t operator()(std::int32_t a, std::int32_t b) const { return a > b ? a : b; }
};

}  // namespace umbrage::detail
