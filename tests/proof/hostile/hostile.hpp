// SPDX-License-Identifier: MIT
//
// Common parts of the programs of hostile arithmetic. Inputs are made only from integers and bit patterns, so no flags
// change them. There are the modes of the machine, and a line to print for table.cpp:
//
//     function  class-of-inputs  mode  inputs  digest  digest-without-the-sign-of-zeros
//
// A mode that is called "itself-..." is to be compared with itself alone, others with rounding to nearest.
#pragma once

#include <array>
#include <cfenv>
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/core/config.hpp>

#include "digest.hpp"

namespace hostile {

inline float from_bits(std::uint32_t bits) { return umbrage::detail::bit_cast<float>(bits); }

// k / most rounded to nearest, by integers.
inline std::uint32_t unorm_bits(std::uint32_t k, std::uint32_t most = 255) {
    if (k == 0) return 0;
    std::uint32_t shift = 23, q = 0;
    for (; q < 1u << 23; ++shift) q = static_cast<std::uint32_t>((2 * (std::uint64_t(k) << shift) + most) / (2 * most));
    return ((150u - (shift - 1)) << 23) + (q - (1u << 23));
}

// Value that is passed on unchanged. A denormal that counted as zero may still be there. A NaN has no defined bits.
inline float passed_on(float v) {
    const auto bits = umbrage::detail::bit_cast<std::uint32_t>(v);
    if ((bits & 0x7FFFFFFFu) > 0x7F800000u) return from_bits(0x7FC00000u);
    return from_bits((bits & 0x7F800000u) == 0 ? bits & 0x80000000u : bits);
}
inline glm::vec3 passed_on(glm::vec3 v) { return {passed_on(v.x), passed_on(v.y), passed_on(v.z)}; }

enum class kind { ordinary, not_a_number, denormal };

struct source {
    kind what;
    bool flush;  // hand denormals over as zero: what a flushing machine makes of them
    std::uint64_t state = 0x9E3779B97F4A7C15ull;

    std::uint32_t next() {
        state = state * 6364136223846793005ull + 1442695040888963407ull;
        return static_cast<std::uint32_t>(state >> 32);
    }
    std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>((std::uint64_t(next()) * n) >> 32); }
    bool one_in(std::uint32_t n) { return below(n) == 0; }

    // The class's own kind of value in one draw of two, else what was asked for, without denormals.
    float classed(std::uint32_t bits) {
        const std::uint32_t sign = next() & 0x80000000u;
        if (what == kind::not_a_number && one_in(2))
            return from_bits(sign | (one_in(8) ? 0x7F800000u : 0x7F800001u + below(0x7FFFFF)));
        if (what == kind::denormal && one_in(2)) {
            const std::uint32_t tiny = 1 + below(0x7FFFFF);
            return from_bits(flush ? sign : sign | tiny);
        }
        return from_bits((bits & 0x7F800000u) == 0 ? bits & 0x80000000u : bits);
    }
    // Within a few ulp of `bits`, which is not near zero.
    std::uint32_t near(std::uint32_t bits) { return bits + below(5) - 2; }

    float any() {
        const std::uint32_t bits = next();
        return classed((bits & 0x7F800000u) == 0x7F800000u ? 0x3F800000u : bits);
    }
    // A depth: on or around a boundary between codes, around 0 and 1, or anything.
    float depth() {
        switch (below(4)) {
            case 0: return any();
            case 1: return classed(near(0x3F800000u));
            case 2: return classed(umbrage::detail::bit_cast<std::uint32_t>(float(below((1u << 24) + 1)) * 0x1p-24f));
            default: return classed(near(umbrage::detail::bit_cast<std::uint32_t>(float(1 + below(65536)) * 0x1p-16f)));
        }
    }
    // A stored depth or a receiver: few values, so that they often meet exactly or one ulp apart.
    float level() {
        return one_in(8) ? depth()
                         : classed(near(umbrage::detail::bit_cast<std::uint32_t>(float(1 + below(4)) * 0.25f)));
    }
    // A texel coordinate: inside or beside an 8 x 8 map, on multiples of 1/256 and an ulp off, at the end of texel
    // space.
    float coord() {
        switch (below(8)) {
            case 0: return any();
            case 1: return classed(near((next() & 0x80000000u) | 0x47000000u));
            case 2:
                return classed(
                    umbrage::detail::bit_cast<std::uint32_t>(float(int(below(4096)) - 1024) * (1.0f / 256.0f)));
            case 3: return classed(umbrage::detail::bit_cast<std::uint32_t>(float(int(below(16)) - 4)));
            default: {
                const float v = float(int(below(12 * 65536)) - 2 * 65536) * 0x1p-16f;
                return classed(near(umbrage::detail::bit_cast<std::uint32_t>(v)));
            }
        }
    }
    glm::vec2 coords() {
        const float x = coord();
        return {x, coord()};
    }
    // What a texture gives for a byte: k / 255, one ulp off (as k times the rounded 1 / 255 is for 126 bytes) or up to
    // 4096. Values that no byte gives are not tried: rounding decides where between two bytes they fall.
    float read(std::uint32_t k) {
        const std::uint32_t bits = unorm_bits(k);
        if (k == 0) return 0.0f;
        return from_bits(one_in(2) ? bits + below(3) - 1 : bits + below(8193) - 4096);
    }
    float read() { return read(below(256)); }
    glm::ivec2 texel() {
        const int x = int(below(16)) - 4;
        return {x, int(below(16)) - 4};
    }
    float edge() { return float(below(3)) * 0.5f; }
    template <int L>
    glm::vec<L, std::uint8_t> bytes() {
        glm::vec<L, std::uint8_t> v(0);
        for (int i = 0; i < L; ++i) v[i] = static_cast<std::uint8_t>(below(256));
        return v;
    }
    template <int L>
    glm::vec<L, float> reads() {
        glm::vec<L, float> v(0.0f);
        for (int i = 0; i < L; ++i) v[i] = read();
        return v;
    }
};

/// Makes the machine take and give zeros for denormals, or keep them.
inline void set_flushing(bool flushes) {
#if defined(__x86_64__)
    constexpr unsigned flush_to_zero = 0x8000, denormals_are_zero = 0x0040;
    const unsigned rest = _mm_getcsr() & ~(flush_to_zero | denormals_are_zero);
    _mm_setcsr(flushes ? rest | flush_to_zero | denormals_are_zero : rest);
#elif defined(__aarch64__)
    constexpr std::uint64_t flush_to_zero = 1u << 24;
    std::uint64_t state;
    asm volatile("mrs %0, fpcr" : "=r"(state));
    state = flushes ? state | flush_to_zero : state & ~flush_to_zero;
    asm volatile("msr fpcr, %0" : : "r"(state));
#else
    static_cast<void>(flushes);  // WebAssembly, RISC-V and IBM Z never flush
#endif
}

struct setting {
    kind what;
    bool flush;  // inputs, not the machine
    std::string mode;

    void print(std::string_view name, int count, const digest& sum) const {
        constexpr std::array names{"ordinary", "nan", "denormal"};
        std::printf("%s %s %s %d %016" PRIx64 " %016" PRIx64 "\n", std::string(name).c_str(),
                    flush ? "flushed" : names[std::size_t(what)], mode.c_str(), count, sum.hash, sum.unsigned_zeros);
    }
};

/// Every class of inputs in every mode.
template <class Use>
void for_each_setting(Use use) {
    const struct {
        const char* name;
        int rounding;
        bool flushes;
    } modes[] = {
        {"nearest", FE_TONEAREST, false},
#ifndef __wasm__  // which rounds to nearest alone
        {"upward", FE_UPWARD, false},
        {"downward", FE_DOWNWARD, false},
        {"to-zero", FE_TOWARDZERO, false},
#endif
#if defined(__x86_64__) || defined(__aarch64__)
        {"flushing", FE_TONEAREST, true},
#endif
    };
    for (const auto& mode : modes) {
        std::fesetround(mode.rounding);
        set_flushing(mode.flushes);
        for (const kind what : {kind::ordinary, kind::not_a_number, kind::denormal})
            use(setting{what, false, mode.name});
    }
    std::fesetround(FE_TONEAREST);
    set_flushing(false);
    use(setting{kind::denormal, true, "nearest"});
}

}  // namespace hostile
