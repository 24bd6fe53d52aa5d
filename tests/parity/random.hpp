// SPDX-License-Identifier: MIT
//
// Random numbers that depend on a seed alone, so that any input can be made again.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace parity {

/// One name in `every`, whichever others there are: FNV-1a.
[[nodiscard]] inline bool sampled(std::string_view name, std::size_t every) {
    std::uint64_t hash = 14695981039346656037u;
    for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
    return hash % every == 0;
}

/// Compilers draw the arguments of a call in their own order: two draws stand in braces, or in statements of their own.
class random {
public:
    explicit random(std::uint64_t seed) : state_(seed * 0x9E3779B97F4A7C15u) {}

    std::uint64_t next() {  // splitmix64
        std::uint64_t z = state_ += 0x9E3779B97F4A7C15u;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
        return z ^ (z >> 31);
    }
    std::uint32_t bits() { return static_cast<std::uint32_t>(next() >> 32); }
    int below(int n) { return static_cast<int>((next() >> 32) * static_cast<std::uint64_t>(n) >> 32); }
    float unit() { return static_cast<float>(bits() >> 8) * 0x1p-24f; }
    float between(float low, float high) { return low + unit() * (high - low); }

private:
    std::uint64_t state_;
};

}  // namespace parity
