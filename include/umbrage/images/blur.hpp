// SPDX-License-Identifier: MIT
//
// Separable blur of images with one to four floats per texel, such as moments.
//
//     umbrage::blur(moments, blurred, umbrage::make_gaussian_kernel(7, 1.5f));
//
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/core/config.hpp>
#include <umbrage/core/image.hpp>
#include <umbrage/core/parallel.hpp>
#include <umbrage/simd/dispatch.hpp>
#include <umbrage/simd/memory.hpp>
#include <umbrage/simd/min_max.hpp>

namespace umbrage {

/// Symmetric row of weights. The number of taps is odd: 2 * weights.size() - 1.
struct blur_kernel {
    std::vector<float> weights;  ///< weight of the center, then those at distance 1, 2, ... on both sides
};

/// Binomial kernel: row Taps - 1 of Pascal's triangle, divided by its sum. Its weights are exact.
/// @formula       weights[i] = C(Taps - 1, (Taps - 1) / 2 + i) / 2^(Taps - 1)
/// @exactness     A
template <int Taps>
[[nodiscard]] blur_kernel make_binomial_kernel() {
    static_assert(Taps >= 1 && Taps <= 25 && Taps % 2 == 1,
                  "an odd number up to 25: beyond, floats do not hold the weights");
    blur_kernel kernel{std::vector<float>(Taps / 2 + 1)};
    double weight = std::ldexp(1.0, 1 - Taps);  // weight of the outermost tap
    for (int i = 0; i <= Taps / 2; ++i) {
        kernel.weights[static_cast<std::size_t>(Taps / 2 - i)] = static_cast<float>(weight);
        weight = weight * (Taps - 1 - i) / (i + 1);
    }
    return kernel;
}

/// Gaussian kernel, sampled at the texels and divided by its sum.
/// @param taps    number of taps, odd, >= 1
/// @param sigma   standard deviation in texels, > 0; infinity gives equal weights
/// @throws std::invalid_argument  taps even or below 1; sigma not above 0
/// @formula       weights[i] = exp(-i^2 / (2 sigma^2)) / sum, in double
/// @exactness     C: exp
template <class = detail::on_use>
[[nodiscard]] blur_kernel make_gaussian_kernel(int taps, float sigma) {
    detail::require(taps >= 1 && taps % 2 == 1, "make_gaussian_kernel", "taps", "odd and above 0", taps);
    detail::require(sigma > 0.0f, "make_gaussian_kernel", "sigma", "above 0", sigma);
    const auto bell = [s = static_cast<double>(sigma)](int i) { return std::exp(-0.5 * (i / s) * (i / s)); };
    double sum = 1.0;
    for (int i = 1; i <= taps / 2; ++i) sum += 2.0 * bell(i);
    blur_kernel kernel;
    for (int i = 0; i <= taps / 2; ++i) kernel.weights.push_back(static_cast<float>(bell(i) / sum));
    return kernel;
}

namespace detail {

/// Floats of a texel, with the one behind a vec3 that GLM_FORCE_DEFAULT_ALIGNED_GENTYPES adds. It is blurred too.
template <class T>
inline constexpr int float_channels = static_cast<int>(sizeof(T) / sizeof(float));

/// True if two views of one size have a texel in common. Tiles of one atlas have none.
inline bool overlap(image_view<const float> a, image_view<const float> b) {
    const auto place = [](const void* texel) { return reinterpret_cast<std::uintptr_t>(texel); };
    const auto lowest = [&](const auto& v) { return place(v.row(v.stride < 0 ? v.size.y - 1 : 0)); };
    const auto rows = static_cast<std::uintptr_t>(a.size.y), row_bytes = place(a.data + a.size.x) - place(a.data);
    const auto pitch = [&](const auto& v) {
        return rows == 1 ? row_bytes : static_cast<std::uintptr_t>(v.stride < 0 ? -v.stride : v.stride);
    };
    const std::uintptr_t first_a = lowest(a), pitch_a = pitch(a), first_b = lowest(b), pitch_b = pitch(b);
    for (std::uintptr_t y = 0; y < rows; ++y) {
        const std::uintptr_t row = first_a + y * pitch_a;
        if (row + row_bytes <= first_b) continue;
        // the last row of b that begins before the end of this one
        const std::uintptr_t last = lesser((row + row_bytes - first_b - 1) / pitch_b, rows - 1);
        if (first_b + last * pitch_b + row_bytes > row) return true;
    }
    return false;
}

/// 64 weighted sums. tap(i) points to the first value at distance i, with i from -radius to radius.
template <class Tap, std::size_t... I>
UMBRAGE_INLINE inline void blur_block(const float* weights, const Tap& tap, float* __restrict to,
                                      std::index_sequence<I...>) {
    // Pointers and weights are locals, which stay in registers: one loop has all taps.
    const float* const center = tap(0);
    const std::array<const float*, sizeof...(I)> before{tap(-static_cast<int>(I) - 1)...},
        after{tap(static_cast<int>(I) + 1)...};
    const std::array<float, sizeof...(I)> w{weights[I + 1]...};
    const float w0 = weights[0];
    for (int x = 0; x < block; ++x) {
        float sum = w0 * center[x];
        ((sum = sum + w[I] * (before[I][x] + after[I][x])), ...);
        to[x] = sum;
    }
}

/// Any number of weighted sums, in the way of blur_block.
template <class Tap>
UMBRAGE_INLINE inline void blur_some(const float* weights, int radius, const Tap& tap, float* to, int count) {
    const float* const center = tap(0);
    for (int x = 0; x < count; ++x) to[x] = weights[0] * center[x];
    for (int i = 1; i <= radius; ++i) {
        const float *before = tap(-i), *after = tap(i), w = weights[i];
        for (int x = 0; x < count; ++x) to[x] = to[x] + w * (before[x] + after[x]);
    }
}

/// Weighted sums of a row. tap(i) points to the row at distance i. `next` points to a row that is needed later.
template <class Tap>
UMBRAGE_INLINE inline void blur_row(const float* weights, int radius, const Tap& tap, float* to, int width,
                                    const float* next = nullptr) {
    if (width < block) return blur_some(weights, radius, tap, to, width);
    const auto each = [&](auto&& blur_at) UMBRAGE_INLINE {
        for (int x = 0; x + block <= width; x += block)
            blur_at([&](int i) UMBRAGE_INLINE { return tap(i) + x; }, to + x);
        if (const int x = width - block; width % block)
            blur_at([&](int i) UMBRAGE_INLINE { return tap(i) + x; }, to + x);
    };
    const auto with_radius = [&](auto taps) UMBRAGE_INLINE {
        each([&](const auto& at, float* result) UMBRAGE_INLINE {
            if (next) prefetch_bytes(next + (result - to), 0, block * static_cast<int>(sizeof(float)));
            blur_block(weights, at, result, taps);
        });
    };
    switch (radius) {
        case 1: return with_radius(std::make_index_sequence<1>{});
        case 2: return with_radius(std::make_index_sequence<2>{});
        case 3: return with_radius(std::make_index_sequence<3>{});
        case 4: return with_radius(std::make_index_sequence<4>{});
        case 5: return with_radius(std::make_index_sequence<5>{});
    }
    each([&](const auto& at, float* result) UMBRAGE_INLINE {
        alignas(64) float sums[block];
        blur_some(weights, radius, at, sums, block);
        std::memcpy(result, sums, sizeof sums);
    });
}

/// Rows first <= y < last: each is blurred along y into a line, and that along x. One body serves any number of
/// channels.
template <class = on_use>
void blur_rows(image_view<const float> from, image_view<float> to, const blur_kernel& kernel, int channels, int first,
               int last) {
    const int radius = static_cast<int>(kernel.weights.size()) - 1, width = from.size.x, height = from.size.y;
    const int border = radius * channels;
    std::vector<float> padded(static_cast<std::size_t>(width + 2 * border));
    std::vector<const float*> rows(2 * kernel.weights.size() - 1);
    on_best_isa_without_fma([&](auto) UMBRAGE_INLINE {
        const float* const weights = kernel.weights.data();
        const float** const around = rows.data() + radius;
        float* const line = padded.data() + border;
        const auto row = [&](int y) { return from.row(y < 0 ? 0 : (y < height ? y : height - 1)); };
        for (int y = first; y < last; ++y) {
            for (int i = -radius; i <= radius; ++i) around[i] = row(y + i);
            blur_row(
                weights, radius, [=](int i) UMBRAGE_INLINE { return around[i]; }, line, width, row(y + radius + 1));
            for (int i = 0; i < border; ++i) {
                line[i - border] = line[i % channels];
                line[width + i] = line[width - channels + i % channels];
            }
            const float* const center = line;
            blur_row(
                weights, radius, [=](int i) UMBRAGE_INLINE { return center + i * channels; }, to.row(y), width);
        }
    });
}

}  // namespace detail

/// Blurs along y, then along x. Outside the image, its border is repeated.
///
/// @param from      texels of float, vec2, vec3 or vec4
/// @param to        same size and type, and no texel of `from`; it may be another tile of one atlas
/// @param kernel    1 weight or more
/// @param parallel  cuts the rows into pieces, see parallel.hpp
/// @throws std::invalid_argument  sizes differ, common texels, or no weights
/// @formula         w0 c + w1 (before1 + after1) + w2 (before2 + after2) + ..., in this order, along y and then along x
/// @exactness       B: every instruction set and any pieces give the bits of the written order. The compiler must not
///                  fuse multiplications and additions (-march with FMA needs -ffp-contract=off)
template <class From, class T, class ParallelFor = serial>
void blur(image_view<From> from, image_view<T> to, const blur_kernel& kernel, ParallelFor&& parallel = {}) {
    constexpr int channels = detail::float_channels<T>;
    static_assert(std::is_same_v<std::remove_const_t<From>, T>);
    static_assert(std::is_same_v<T, float> || std::is_same_v<T, glm::vec2> || std::is_same_v<T, glm::vec3> ||
                  std::is_same_v<T, glm::vec4>);
    static_assert(sizeof(T) == channels * sizeof(float), "texels must be floats side by side");
    detail::require_size(to.size, from.size, "blur", "to.size", "from's size");
    detail::require(!kernel.weights.empty(), "blur", "kernel.weights", "one or more", "none",
                    "Make the kernel by make_gaussian_kernel.");
    if (from.empty()) return;
    const glm::ivec2 size(from.size.x * channels, from.size.y);
    const image_view<const float> floats_from(reinterpret_cast<const float*>(from.data), size, from.stride);
    const image_view<float> floats_to(reinterpret_cast<float*>(to.data), size, to.stride);
    detail::require(!detail::overlap(floats_from, floats_to), "blur", "to", "an image of its own", "pixels of from");
    parallel(size.y,
             [&](int first, int last) { detail::blur_rows(floats_from, floats_to, kernel, channels, first, last); });
}

/// Blur for arguments of which one or both are an image.
template <class From, class To, class ParallelFor = serial>
requires detail::some_image<From, To>
void blur(const From& from, To&& to, const blur_kernel& kernel, ParallelFor&& parallel = {}) {
    blur(detail::view_of(from), detail::view_of(to), kernel, parallel);
}

}  // namespace umbrage
