// SPDX-License-Identifier: MIT
//
// Any system with any encoding, step by step, with a stopwatch. With a system's own encoding the visibility is, bit for
// bit, what its program in examples/originals gives.
//
//     const stored_depth map = stored(depth, "rg11", 1.0f);
//     const umbrage::image<float> visibility = visibility_of(system, stage, light, map.depth);
//
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

#include <umbrage/core/image.hpp>

#include <stage.hpp>

namespace gallery {

/// Runs the work, adds the milliseconds that it took.
template <class Work>
auto timed(double& ms, Work&& work) {
    struct watch {
        double& sum;
        std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
        ~watch() { sum += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count(); }
    } running{ms};
    return work();
}

/// Milliseconds of the fastest of five runs.
template <class Work>
double best_of_5(Work&& work) {
    double best = std::numeric_limits<double>::infinity();
    for (int run = 0; run < 5; ++run) {
        double ms = 0;
        timed(ms, work);
        best = std::min(best, ms);
    }
    return best;
}

/// A depth image that went through an encoding.
struct stored_depth {
    umbrage::image<float> depth{};                         ///< decoded
    std::vector<umbrage::image<std::uint8_t>> channels{};  ///< as stored; none for floats
    std::size_t codes = 0;                                 ///< different texels
    double encode_ms = 0, decode_ms = 0;
    double error = 0;  ///< worst |decoded - depth|
};

/// @param encoding  by name; 8_bits is one channel, what there was before the tricks
/// @param empty     what `depth` holds where nothing was drawn
[[nodiscard]] stored_depth stored(const umbrage::image<float>& depth, std::string_view encoding, float empty);

/// The map as pixel shader 1.x read it back: red shifted right by three, green added.
[[nodiscard]] umbrage::image<float> decoded_ps14(const stored_depth& map);

/// Fetch, compare and filter, wherever the camera sees something.
/// @param map  decoded
[[nodiscard]] umbrage::image<float> visibility_of(const example::shadow_system& s, const example::stage& stage,
                                                  const example::light& light, const umbrage::image<float>& map);

}  // namespace gallery
