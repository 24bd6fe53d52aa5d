// SPDX-License-Identifier: MIT
//
// Separable blur of images of one to four floats a texel, such as moments.
//
//     umbrage::blur(moments.view(), blurred.view(), umbrage::make_gaussian_kernel(7, 1.5f));
//
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/image.hpp>
#include <umbrage/image_ops/isa.hpp>
#include <umbrage/image_ops/parallel.hpp>

namespace umbrage {

/// A symmetric row of weights. Taps are odd: 2 * weights.size() - 1.
struct blur_kernel {
    std::vector<float> weights;  ///< that of the centre, then those at distance 1, 2, ... on both sides
};

/// Row Taps - 1 of Pascal's triangle, divided by its sum: weights are exact.
/// @formula       weights[i] = C(Taps - 1, (Taps - 1) / 2 + i) / 2^(Taps - 1)
/// @exactness     A
template <int Taps>
[[nodiscard]] blur_kernel make_binomial_kernel() {
    static_assert(Taps >= 1 && Taps <= 25 && Taps % 2 == 1, "an odd number up to 25: beyond, floats do not hold the weights");
    blur_kernel kernel{std::vector<float>(Taps / 2 + 1)};
    double weight = std::ldexp(1.0, 1 - Taps);  // that of the outermost tap
    for (int i = 0; i <= Taps / 2; ++i) {
        kernel.weights[static_cast<std::size_t>(Taps / 2 - i)] = static_cast<float>(weight);
        weight = weight * (Taps - 1 - i) / (i + 1);
    }
    return kernel;
}

/// A Gaussian bell, sampled at the texels and divided by its sum.
/// @param taps    odd, >= 1
/// @param sigma   standard deviation in texels, > 0; infinity gives equal weights
/// @throws std::invalid_argument  otherwise
/// @formula       weights[i] = exp(-i^2 / (2 sigma^2)) / sum, in double
/// @exactness     C: exp
[[nodiscard]] inline blur_kernel make_gaussian_kernel(int taps, float sigma) {
    if (taps < 1 || taps % 2 == 0 || !(sigma > 0.0f))
        throw std::invalid_argument("umbrage::make_gaussian_kernel: taps even or below 1, or sigma not above 0");
    const auto bell = [s = static_cast<double>(sigma)](int i) { return std::exp(-0.5 * (i / s) * (i / s)); };
    double sum = 1.0;
    for (int i = 1; i <= taps / 2; ++i) sum += 2.0 * bell(i);
    blur_kernel kernel;
    for (int i = 0; i <= taps / 2; ++i) kernel.weights.push_back(static_cast<float>(bell(i) / sum));
    return kernel;
}

namespace detail {

template <class T>
inline constexpr int float_channels = static_cast<int>(sizeof(T) / sizeof(float));

/// 64 sums of taps; tap(i) is where those at distance i begin, i from -radius to radius.
template <class Tap, std::size_t... I>
UMBRAGE_INLINE inline void blur_block(const float* weights, const Tap& tap, float* to, std::index_sequence<I...>) {
    // One pointer a tap, known before the loop: what follows is a single pass that leaves nothing in memory.
    const float* const centre = tap(0);
    const std::array<const float*, sizeof...(I)> before{tap(-static_cast<int>(I) - 1)...}, after{tap(static_cast<int>(I) + 1)...};
    const std::array<float, sizeof...(I)> w{weights[I + 1]...};
    const float w0 = weights[0];
    float sums[block];
    for (int x = 0; x < block; ++x) {
        float sum = w0 * centre[x];
        ((sum = sum + w[I] * (before[I][x] + after[I][x])), ...);
        sums[x] = sum;
    }
    std::memcpy(to, sums, sizeof sums);
}

/// The same for any radius.
template <class Tap>
UMBRAGE_INLINE inline void blur_block(const float* weights, int radius, const Tap& tap, float* to) {
    switch (radius) {
        case 1: return blur_block(weights, tap, to, std::make_index_sequence<1>{});
        case 2: return blur_block(weights, tap, to, std::make_index_sequence<2>{});
        case 3: return blur_block(weights, tap, to, std::make_index_sequence<3>{});
        case 4: return blur_block(weights, tap, to, std::make_index_sequence<4>{});
    }
    float sums[block];
    const float* centre = tap(0);
    for (int x = 0; x < block; ++x) sums[x] = weights[0] * centre[x];
    for (int i = 1; i <= radius; ++i) {
        const float *before = tap(-i), *after = tap(i), w = weights[i];
        for (int x = 0; x < block; ++x) sums[x] = sums[x] + w * (before[x] + after[x]);
    }
    std::memcpy(to, sums, sizeof sums);
}

/// Rows first <= y < last. Rows blurred along x are kept while a row of the result needs them.
template <int Channels>
void blur_rows(image_view<const float> from, image_view<float> to, const blur_kernel& kernel, int first, int last) {
    const int radius = static_cast<int>(kernel.weights.size()) - 1, width = from.size.x, height = from.size.y;
    const int length = (width + block - 1) / block * block, kept = 2 * radius + 1;
    std::vector<float> padded(static_cast<std::size_t>(length + 2 * radius * Channels));
    std::vector<float> lines(static_cast<std::size_t>(length) * static_cast<std::size_t>(kept));
    std::vector<const float*> taps(static_cast<std::size_t>(kept));
    const float* weights = kernel.weights.data();
    const auto line = [&](int y) UMBRAGE_INLINE { return lines.data() + std::ptrdiff_t(y % kept) * length; };

    on_best_isa_without_fma([&](auto) UMBRAGE_INLINE {
        int done = first - radius < 0 ? 0 : first - radius;  // rows before it are blurred along x
        for (int y = first; y < last; ++y) {
            for (; done <= y + radius && done < height; ++done) {
                const float* row = from.row(done);
                float* centre = padded.data() + radius * Channels;
                std::memcpy(centre, row, static_cast<std::size_t>(width) * sizeof(float));
                for (int i = 0; i < radius * Channels; ++i) {
                    padded[static_cast<std::size_t>(i)] = row[i % Channels];
                    centre[width + i] = row[width - Channels + i % Channels];
                }
                float* result = line(done);
                for (int x = 0; x < width; x += block)
                    blur_block(weights, radius, [&](int i) UMBRAGE_INLINE { return centre + x + i * Channels; }, result + x);
            }
            for (int i = -radius; i <= radius; ++i) {
                const int k = y + i < 0 ? 0 : (y + i < height ? y + i : height - 1);
                taps[static_cast<std::size_t>(i + radius)] = line(k);
            }
            const float* const* at = taps.data() + radius;
            float* result = to.row(y);
            for (int x = 0; x < width; x += block) {
                const auto tap = [&](int i) UMBRAGE_INLINE { return at[i] + x; };
                if (x + block <= width) {
                    blur_block(weights, radius, tap, result + x);
                } else {
                    float end[block];
                    blur_block(weights, radius, tap, end);
                    std::memcpy(result + x, end, static_cast<std::size_t>(width - x) * sizeof(float));
                }
            }
        }
    });
}

}  // namespace detail

/// Blurs along x, then along y. Outside the image, its border goes on.
///
/// @param from      texels of float, vec2, vec3 or vec4
/// @param to        same size and type, other pixels
/// @param kernel    1 weight at least
/// @param parallel  cuts the rows into pieces, see parallel.hpp
/// @throws std::invalid_argument  sizes differ, same pixels, or no weights
/// @formula         w0 c + w1 (before1 + after1) + w2 (before2 + after2) + ..., in this order, along x and then along y
/// @exactness       B: every instruction set and any pieces give the bits of the written order, as long as the compiler is
///                  not told that it may fuse a multiplication and an addition (-march with FMA without -ffp-contract=off)
template <class From, class T, class ParallelFor = serial>
void blur(image_view<From> from, image_view<T> to, const blur_kernel& kernel, ParallelFor&& parallel = {}) {
    constexpr int channels = detail::float_channels<T>;
    static_assert(std::is_same_v<std::remove_const_t<From>, T> && sizeof(T) == channels * sizeof(float) && alignof(T) == alignof(float) &&
                  (std::is_same_v<T, float> || std::is_same_v<T, glm::vec2> || std::is_same_v<T, glm::vec3> || std::is_same_v<T, glm::vec4>));
    if (from.size != to.size) throw std::invalid_argument("umbrage::blur: sizes differ");
    if (kernel.weights.empty()) throw std::invalid_argument("umbrage::blur: no weights");
    if (from.empty()) return;
    if (from.data == to.data) throw std::invalid_argument("umbrage::blur: same pixels");
    const glm::ivec2 size(from.size.x * channels, from.size.y);
    const image_view<const float> floats_from(reinterpret_cast<const float*>(from.data), size, from.stride);
    const image_view<float> floats_to(reinterpret_cast<float*>(to.data), size, to.stride);
    parallel(size.y, [&](int first, int last) { detail::blur_rows<channels>(floats_from, floats_to, kernel, first, last); });
}

}  // namespace umbrage
