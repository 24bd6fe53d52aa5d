// SPDX-License-Identifier: MIT
//
// Kinds of values, and ways to spread them over the arguments of a call.
#pragma once

#include <initializer_list>

#include "entry.hpp"

namespace parity {

/// Scalars of one kind.
struct value_class {
    std::string name;
    std::function<float(std::uint64_t i, random& r)> make;
};

/// Range that an argument ordinarily comes from.
struct range {
    float low = 0.0f, high = 1.0f;
};

/// zero, one, out of range, denormal, smallest normal, NaN, infinity: what every primitive must stand.
[[nodiscard]] std::vector<value_class> special_values();

/// special_values without denormals and the smallest normal, whose products hardware may take for 0.
[[nodiscard]] std::vector<value_class> large_values();

/// large_values without NaN and infinity: for functions that take no NaN, and whose sums of infinities would be one.
[[nodiscard]] std::vector<value_class> finite_values();

/// special_values, every bit pattern, and the edges of a code of `bits` bits with the floats beside them.
[[nodiscard]] std::vector<value_class> depth_values(int bits = 11);

/// The arguments x0.x, x0.y, x0.z, x0.w, x1.x .. : a class in which all are ordinary, and one for each kind, which
/// takes turns at the arguments and now and then has them all.
[[nodiscard]] std::vector<input_class> spread(std::vector<range> arguments, const std::vector<value_class>& kinds);

/// Four channels as a texture of so many bits gives them in x0: all codes, off by an ulp, off by a part of a step,
/// beyond the ends, and the special values. `edges`: x1.x is 0, 1/2 or 1.
[[nodiscard]] std::vector<input_class> channels(bool edges = false, int bits = 8);

/// Every depth k / 2^24 below 1 in x0.x.
[[nodiscard]] enumeration all_depths();

/// Every code of three 8-bit channels in x0.xyz, with some fourth; x1.x is 0, 1/2 or 1, each for any two channels.
[[nodiscard]] enumeration all_codes();

/// A receiver before a map: x0.x, x0.y in texels, x0.z depth, x0.w an integer from -1 to 9.
[[nodiscard]] std::vector<input_class> receivers();

/// Whole texel numbers in x0.xy: inside, around the border, far off.
[[nodiscard]] std::vector<input_class> whole_texels();

/// A square map, one of odd size, a tiny one; depths on a lattice of 1/16, some of them 0, 1, NaN, denormal.
[[nodiscard]] std::vector<texels> depth_maps();

/// Depths on that lattice alone, of these sizes.
[[nodiscard]] std::vector<texels> plain_maps(std::initializer_list<ivec2> sizes);

/// The sizes of depth_maps with random bytes k / 255 in every channel.
[[nodiscard]] std::vector<texels> packed_maps();

}  // namespace parity
