// SPDX-License-Identifier: MIT
//
// Digest of results, to compare two builds.
#pragma once

#include <cstdint>

#include <glm/vec2.hpp>

#include <umbrage/core/config.hpp>

namespace hostile {

// FNV-1a over 32-bit words; rounding downwards, x - x is -0, so once more with every -0 taken for 0.
struct digest {
    static constexpr std::uint64_t basis = 14695981039346656037ull, prime = 1099511628211ull;
    std::uint64_t hash = basis, unsigned_zeros = basis;

    void word(std::uint32_t v) { word(v, v); }
    void word(std::uint32_t v, std::uint32_t w) {
        hash = (hash ^ v) * prime;
        unsigned_zeros = (unsigned_zeros ^ w) * prime;
    }
    void operator()(float v) {
        auto bits = umbrage::detail::bit_cast<std::uint32_t>(v);
        if ((bits & 0x7FFFFFFFu) > 0x7F800000u)
            bits |= 0x00400000u;  // 32-bit x86 returns signalling NaNs as quiet ones
        word(bits, bits == 0x80000000u ? 0 : bits);
    }
    void operator()(bool v) { word(v); }
    void operator()(std::uint8_t v) { word(v); }
    void operator()(std::uint16_t v) { word(v); }
    void operator()(std::uint32_t v) { word(v); }
    template <int L, class T>
    void operator()(const glm::vec<L, T>& v) {
        for (int i = 0; i < L; ++i) (*this)(v[i]);
    }
};

}  // namespace hostile
