// SPDX-License-Identifier: MIT
//
// Bytes of a fuzzer as numbers, and how a target reports what is wrong. libFuzzer finds what aborts.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <thread>
#include <vector>

#include <glm/vec3.hpp>

#include <umbrage/core/clip_space.hpp>

namespace fuzz {

/// Aborts unless a model holds.
inline void must(bool holds, const char* model) {
    if (holds) return;
    std::fprintf(stderr, "fuzz: %s\n", model);
    std::abort();
}

/// Reads numbers from the front of the bytes; zeros follow the last.
class input {
public:
    input(const std::uint8_t* bytes, std::size_t size) : bytes_(bytes), size_(size) {}

    [[nodiscard]] std::uint32_t bits() {
        std::uint32_t value = 0;
        const std::size_t taken = size_ < sizeof value ? size_ : sizeof value;
        std::memcpy(&value, bytes_, taken);
        bytes_ += taken, size_ -= taken;
        return value;
    }
    [[nodiscard]] int within(int low, int high) {
        return low + static_cast<int>(bits() % (static_cast<std::uint32_t>(high - low) + 1u));
    }
    [[nodiscard]] bool chance(int one_in) { return within(1, one_in) == 1; }
    /// A float in the range; one time in eight any float there is, NaN and infinities too.
    [[nodiscard]] float number(float low, float high) {
        const std::uint32_t kind = bits();
        if (kind % 8 != 0) return low + (high - low) * (static_cast<float>(kind >> 8) / 16777216.0f);
        static constexpr std::array<float, 8> awkward{0.0f,
                                                      -0.0f,
                                                      1.0f,
                                                      std::numeric_limits<float>::infinity(),
                                                      -std::numeric_limits<float>::infinity(),
                                                      std::numeric_limits<float>::quiet_NaN(),
                                                      std::numeric_limits<float>::max(),
                                                      std::numeric_limits<float>::denorm_min()};
        if (kind % 16 == 0) return awkward[(kind >> 4) % 8];
        return std::bit_cast<float>(bits());
    }
    /// A float in the range.
    [[nodiscard]] float tame(float low, float high) {
        return low + (high - low) * (static_cast<float>(bits() >> 8) / 16777216.0f);
    }
    [[nodiscard]] glm::vec3 vec3(float low, float high) {
        return {number(low, high), number(low, high), number(low, high)};
    }
    /// Conventions of an API.
    [[nodiscard]] umbrage::clip_space clip() {
        using namespace umbrage;
        static constexpr std::array all{cpu_clip_space,   opengl_clip_space, direct3d_clip_space, vulkan_clip_space,
                                        unity_clip_space, godot_clip_space,  unreal_clip_space};
        return all[bits() % all.size()];
    }

private:
    const std::uint8_t* bytes_;
    std::size_t size_;
};

/// Hook for threads, see core/parallel.hpp: pieces of one length, from the last to the first or on three threads.
class pieces {
public:
    explicit pieces(input& in) : length_(in.within(1, 9)), on_threads_(in.chance(8)) {}

    template <class Piece>
    void operator()(int count, const Piece& piece) const {
        const auto run = [&](int i) { piece(i * length_, std::min((i + 1) * length_, count)); };
        const int last = (count + length_ - 1) / length_ - 1;
        if (!on_threads_)
            for (int i = last; i >= 0; --i) run(i);
        else {
            std::atomic<int> next = 0;
            std::vector<std::jthread> threads;
            for (int i = 0; i < 3; ++i)
                threads.emplace_back([&] {
                    for (int k = next++; k <= last; k = next++) run(k);
                });
        }
    }

private:
    int length_;
    bool on_threads_;
};

/// True for floats of one value and sign, and for two NaN.
[[nodiscard]] inline bool same(float a, float b) {
    return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b) || (a != a && b != b);
}

/// Calls what may refuse its arguments: a clear message is an answer, anything else is not.
template <class Use>
void answered(const Use& use) {
    try {
        use();
    } catch (const std::invalid_argument& error) {
        const std::string_view message = error.what();
        must(message.starts_with("umbrage::") && message.find("; got ") != message.npos, error.what());
    }
}

}  // namespace fuzz
