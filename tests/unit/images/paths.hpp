// SPDX-License-Identifier: MIT
//
// Common parts of tests that compare image functions with their primitives: every instruction set of this machine,
// every rounding mode, rows with gaps, bands, and values that break conversions.
#pragma once

#include <doctest/doctest.h>

#include <bit>
#include <cfenv>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include <umbrage/core/clip_space.hpp>
#include <umbrage/core/image.hpp>

#include "isas.hpp"

namespace paths {

using umbrage::image;

/// Rounding modes to try: to nearest, and every fifth time all four; always all with UMBRAGE_ALL_BUILDS.
inline std::vector<int> rounding_modes() {
#ifdef UMBRAGE_ALL_BUILDS
    constexpr int every = 1;
#else
    constexpr int every = 5;
#endif
    static int turn = 0;
    if (turn++ % every) return {FE_TONEAREST};
    return {FE_TONEAREST, FE_TOWARDZERO, FE_UPWARD, FE_DOWNWARD};
}

/// Calls use(mode) in each of the rounding modes.
template <class Use>
void each_rounding(const std::vector<int>& modes, Use&& use) {
    for (int mode : modes) {
        std::fesetround(mode);
        use(mode);
        std::fesetround(FE_TONEAREST);
    }
}

/// Calls use() in each of the modes, with each instruction set that this machine has.
template <class Use>
void for_each_path(const std::vector<int>& modes, Use&& use) {
    for_each_isa([&] {
        each_rounding(modes, [&](int mode) {
            CAPTURE(mode);
            use();
        });
    });
}
/// Calls use() in each of the modes, with each instruction set that this machine has.
template <class Use>
void for_each_path(Use&& use) {
    for_each_path(rounding_modes(), use);
}

/// The filter with the other direction, which the map's overrules.
template <class Filter>
Filter contrary(Filter filter) {
    using umbrage::depth_direction;
    if constexpr (requires { filter.direction = umbrage::depth_direction::forward; }) {
        const bool forward = filter.direction == depth_direction::forward;
        filter.direction = forward ? depth_direction::reversed : depth_direction::forward;
    }
    return filter;
}

/// As many pieces, the last first.
struct bands {
    int pieces;
    template <class Piece>
    void operator()(int count, Piece&& piece) const {
        for (int i = pieces - 1; i >= 0; --i)
            if (count * i / pieces < count * (i + 1) / pieces) piece(count * i / pieces, count * (i + 1) / pieces);
    }
};

inline std::uint32_t bits(float v) { return std::bit_cast<std::uint32_t>(v); }

/// Rounding down makes x - x of the primitives -0, which is the same visibility.
inline std::uint32_t visibility_bits(float v) { return v == 0.0f ? 0 : bits(v); }

struct values {
    std::mt19937 engine{20021};
    std::uint32_t word() { return static_cast<std::uint32_t>(engine()); }
    float unit() { return static_cast<float>(word() >> 8) * 0x1p-24f; }
    /// Value that breaks conversions: NaN of either sign, infinities, borders of codes, any pattern of bits.
    float depth() {
        constexpr float infinity = std::numeric_limits<float>::infinity();
        switch (word() % 12) {
            case 0: return std::bit_cast<float>(word());
            case 1: return std::bit_cast<float>(0x7FC00000u | (word() & 0x803FFFFFu));
            case 2: return word() % 2 ? infinity : -infinity;
            case 3: return word() % 2 ? -0.0f : 1.0f;
            case 4: return std::nextafter(static_cast<float>(word() % 2049) / 2048.0f, word() % 2 ? 2.0f : -1.0f);
            case 5: return static_cast<float>(word() % 65537) / 65536.0f;
            default: return unit();
        }
    }
    float coord(int size) {
        const float v = unit() * static_cast<float>(size + 24) - 12.0f;
        switch (word() % 12) {
            case 0: return std::bit_cast<float>(word());
            case 1: return std::floor(v);
            case 2: return std::floor(v * 256.0f) / 256.0f;
            case 3: return std::nextafter(std::floor(v), -1e9f);
            case 4: return word() % 2 ? 32768.0f : std::nextafter(-32768.0f, 0.0f);
            default: return v;
        }
    }
};

/// Rows with a gap behind each, which nobody may touch.
template <class T>
struct gapped {
    glm::ivec2 size;
    std::vector<T> memory;
    explicit gapped(glm::ivec2 s) : size(s), memory(static_cast<std::size_t>((s.x + 5) * s.y), T(7)) {}
    umbrage::image_view<T> view() {
        return {memory.data(), size, (size.x + 5) * static_cast<std::ptrdiff_t>(sizeof(T))};
    }
    bool gaps_untouched() {
        for (int y = 0; y < size.y; ++y)
            for (int x = size.x; x < size.x + 5; ++x)
                if (memory[static_cast<std::size_t>(y * (size.x + 5) + x)] != T(7)) return false;
        return true;
    }
};

}  // namespace paths
