// SPDX-License-Identifier: MIT
//
// Works of many elements, each with a check of its results, a bound of its memory and its cost.
#pragma once

#include <cstddef>
#include <cstdint>
#include <ctime>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

#include <umbrage/core/image.hpp>

/// CPU time of what it runs.
class stopwatch {
public:
    template <class Run>
    void add(const Run& run) {
        const double start = now();
        run();
        seconds_ += now() - start;
    }
    [[nodiscard]] double seconds() const { return seconds_; }

private:
    [[nodiscard]] static double now() {
        timespec time{};
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
        return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
    }
    double seconds_ = 0;
};

/// Work that is ready to run, with its arguments.
struct prepared {
    double elements;
    std::size_t most_bytes;  ///< bound of what the library allocates in a run, results that it returns included
    std::function<void(stopwatch&)> run;  ///< calls the library in the stopwatch
    std::function<bool()> is_right;       ///< compares the results of the last run
};

struct work {
    std::string plot, name;  ///< plot of the cost; none where only results and memory count
    int highest;             ///< power of two of the largest number of elements
    double gib_at_once;      ///< memory at that number, with all arguments
    std::function<prepared(int power)> prepare;
};

/// Works of all files, each of which registers its own.
[[nodiscard]] std::vector<work>& works();
struct registered {
    explicit registered(const std::vector<work>& more) { works().insert(works().end(), more.begin(), more.end()); }
};

inline constexpr std::size_t small_change = 64 << 10;  ///< bytes that a call may allocate once

/// Size of a map with 2^power texels.
[[nodiscard]] inline glm::ivec2 size_of(int power) { return {1 << (power + 1) / 2, 1 << power / 2}; }
[[nodiscard]] inline std::size_t area(glm::ivec2 size) { return std::size_t(size.x) * std::size_t(size.y); }

/// Depth of a texel: random multiples of 2^-11 in squares of 8 x 8.
[[nodiscard]] inline float depth_of(int x, int y) {
    std::uint32_t hash = std::uint32_t(x >> 3) * 0x9E3779B1u ^ std::uint32_t(y >> 3) * 0x85EBCA77u;
    hash = (hash ^ hash >> 15) * 0x2C1B3C6Du;
    return float(hash >> 21) / 2048;
}

[[nodiscard]] inline umbrage::image<float> depths_of(glm::ivec2 size) {
    umbrage::image<float> depths(size);
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) depths.view().row(y)[x] = depth_of(x, y);
    return depths;
}

/// Texels for comparison: those at the image's corners and end, those around its 2^29th, 2^30th, ... byte, and others
/// anywhere.
/// @param holds   (glm::ivec2 texel) -> bool
/// @return        true if it holds for all of them
template <class Holds>
[[nodiscard]] bool at_probes(glm::ivec2 size, const Holds& holds) {
    const std::size_t last = area(size) - 1;
    const auto at = [&](std::size_t i) { return glm::ivec2(i % std::size_t(size.x), i / std::size_t(size.x)); };
    for (std::size_t i = 0; i < 200; ++i)
        if (!holds(at(i)) || !holds(at(last - i))) return false;
    for (std::size_t power = 26; power < 33; ++power)
        for (std::size_t i = (std::size_t(1) << power) - 2; i < (std::size_t(1) << power) + 2; ++i)
            if (i <= last && !holds(at(i))) return false;
    std::uint64_t state = 1;
    for (int i = 0; i < 4000; ++i) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        if (!holds(at(std::size_t(state >> 20) % (last + 1)))) return false;
    }
    return true;
}
