// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <random>

#include <umbrage/draw/raster/depth_rounding.hpp>
#include <umbrage/simd/lanes.hpp>

using namespace umbrage;

namespace {

/// Doubles of eight texels as `depths` makes floats of them.
template <class Depths>
void check_rounding(const Depths& depths, const double (&z)[8]) {
    using doubles = detail::lanes_of<double, 4>;
    doubles texels[2], lanes[2];
    depths.count(texels[0], texels[1]);
    bool counted[8]{};
    for (int half = 0; half < 2; ++half)
        for (int lane = 0; lane < 4; ++lane) {
            const auto texel = static_cast<std::size_t>(texels[half][lane]);
            lanes[half][lane] = z[texel];
            counted[texel] = true;
        }
    detail::lanes_of<float, 8> rounded;
    depths.round(lanes[0], lanes[1], rounded);
    for (int i = 0; i < 8; ++i) {
        CHECK(counted[i]);
        CHECK(std::bit_cast<std::uint32_t>(rounded[i]) == std::bit_cast<std::uint32_t>(static_cast<float>(z[i])));
    }
}

}  // namespace

TEST_CASE("depth_rounding: the nearest floats, ties to even, at both ends of a binade") {
    if constexpr (detail::has_lanes && std::endian::native == std::endian::little) {
        std::mt19937_64 engine(3);
        for (const int exponent : {0, -1, -2, -20, -126})
            for (int round = 0; round < 500; ++round) {
                const double power = std::ldexp(1.0, exponent), step = std::ldexp(power, -23);
                double z[8];
                for (double& depth : z) depth = power + static_cast<double>(engine() >> 12) * step * 0x1p-29;
                z[0] = power, z[1] = power + step * 0.5, z[2] = power + step * 1.5;
                z[3] = power - step * 0.25, z[4] = 2.0 * power - step, z[5] = 2.0 * power - step * 0.5;
                z[6] = power + step * (static_cast<double>(engine() >> 41) + 0.5);
                check_rounding(detail::depths_of_binade<8>(z[7]), z);
                check_rounding(detail::any_depths<8>(power - step, 2.0 * power), z);
            }
    }
}
