// SPDX-License-Identifier: MIT
//
// Spans of triangles into a depth image: the nearer of what is there and the plane's depth, some texels at a time.
//
//     draw_batch<true>(depth, flipped, batch);
//
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#include <umbrage/config.hpp>
#include <umbrage/image.hpp>
#include <umbrage/scalar.hpp>
#include <umbrage/simd/dispatch.hpp>
#include <umbrage/simd/memory.hpp>
#include <umbrage/simd/raster/triangle_batch.hpp>
#include <umbrage/simd/strict_math.hpp>

UMBRAGE_STRICT_MATH
namespace umbrage::detail {

/// A triangle's depths into an image, that many texels of a row at a time.
template <bool Forward, int Lanes>
class span_writer {
public:
    UMBRAGE_INLINE span_writer(image_view<float> depth, bool flipped)
        : bottom_(reinterpret_cast<std::byte*>(depth.row(flipped ? depth.size.y - 1 : 0))),
          up_(flipped ? -depth.stride : depth.stride),
          last_block_(depth.size.x - Lanes) {}

    /// Prefetches the texels of a triangle: their latency is about the time that it takes to draw another small one.
    UMBRAGE_INLINE void expect(const triangle_batch& batch, int i) const {
        const auto bounds = batch.bounds(i);
        for (int y = bounds.first.y; y < std::min(bounds.last.y, bounds.first.y + 16); ++y)
            prefetch_line(row(y) + bounds.first.x);
    }

    UMBRAGE_INLINE void draw(const triangle_batch& batch, int i) const {
        const auto plane = batch.plane(i);
        // Depths of one sign, and none that is flushed: their bits are in their order.
        if (plane.lowest >= 0x1p-126 && plane.highest <= 1.0) {
            const block_writer write(plane);
            const double step = plane.dx * Lanes;
            batch.for_each_row(i, [&](int y, int first, int last) UMBRAGE_INLINE {
                float* const texels = row(y);
                double z = plane.unclamped(first, y);
                for (; first < last; first += Lanes, z += step) {
                    if (first > last_block_) return write.at_border(texels + first, z, last - first);
                    write(texels + first, z, last - first);
                }
            });
        } else {
            batch.for_each_row(i, [&](int y, int first, int last) UMBRAGE_INLINE {
                float* const texels = row(y);
                for (int x = first; x < last; ++x) {
                    const double z = plane(x, y);
                    if (!(z >= 0.0 && z <= 1.0)) continue;
                    const float stored = z > 0.0 ? static_cast<float>(z) : 0.0f;
                    if (!is_nan(texels[x]) && (Forward ? stored <= texels[x] : stored >= texels[x])) texels[x] = stored;
                }
            });
        }
    }

private:
    struct block_writer {
        double ramp[std::size_t(Lanes)];
        std::int32_t lowest, highest;

        UMBRAGE_INLINE explicit block_writer(const depth_plane& plane)
            : lowest(bit_cast<std::int32_t>(static_cast<float>(plane.lowest))),
              highest(bit_cast<std::int32_t>(static_cast<float>(plane.highest))) {
            for (int i = 0; i < Lanes; ++i) ramp[i] = plane.dx * i;
        }

        /// The first `count` of a block's texels; what is there can be anything.
        UMBRAGE_INLINE void operator()(float* texels, double z, int count) const {
            constexpr std::int32_t infinity = 0x7F800000, sign = std::numeric_limits<std::int32_t>::min();
            std::int32_t there[std::size_t(Lanes)], here[std::size_t(Lanes)];
            float rounded[std::size_t(Lanes)];
            for (int i = 0; i < Lanes; ++i) rounded[i] = static_cast<float>(z + ramp[i]);
            std::memcpy(here, rounded, sizeof here);
            std::memcpy(there, texels, sizeof there);
            for (int i = 0; i < Lanes; ++i) {
                const std::int32_t above = here[i] < lowest ? lowest : here[i];
                const std::int32_t depth = above > highest ? highest : above;
                const bool nearer = Forward ? depth <= there[i] : depth >= there[i];
                const bool number = (Forward ? there[i] : there[i] ^ sign) <= infinity;  // or a NaN of the other sign
                const std::int32_t mask = -std::int32_t(nearer & number & (i < count));
                there[i] = (depth & mask) | (there[i] & ~mask);
            }
            std::memcpy(texels, there, sizeof there);
        }

        /// The same where the row ends before the block.
        void at_border(float* texels, double z, int count) const {
            float copy[std::size_t(Lanes)]{};
            for (int i = 0; i < count; ++i) copy[i] = texels[i];
            (*this)(copy, z, count);
            for (int i = 0; i < count; ++i) texels[i] = copy[i];
        }
    };

    [[nodiscard]] UMBRAGE_INLINE float* row(int y) const { return reinterpret_cast<float*>(bottom_ + y * up_); }

    std::byte* bottom_;
    std::ptrdiff_t up_;
    int last_block_;
};

template <bool Forward>
void draw_batch(image_view<float> depth, bool flipped, const triangle_batch& batch) {
    on_best_isa([&](auto set) UMBRAGE_INLINE {
        const span_writer<Forward, decltype(set)::value == isa::avx512 ? 8 : 4> writer(depth, flipped);
        for (int i = 0; i < batch.count; ++i) {
            if (i + 1 < batch.count) writer.expect(batch, i + 1);
            writer.draw(batch, i);
        }
    });
}

}  // namespace umbrage::detail
UMBRAGE_END_STRICT_MATH
