// SPDX-License-Identifier: MIT
//
// Entries of a setup's places: one for each column of the matrix that its snippet returns.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <umbrage/light/cascades/select.hpp>
#include <umbrage/shadow/setup.hpp>

#include "../entries.hpp"

namespace parity {

/// Column of a place as a snippet returns it: (texels, texels, depth, number) or (slope, slope, weight, slack).
[[nodiscard]] inline vec4 column_of(const umbrage::map_place& place, bool of_slope) {
    if (of_slope) return {place.slope.x, place.slope.y, place.weight, place.slack};
    return vec4(place.at, static_cast<float>(place.number));
}

/// A column of a call's matrix, by a function: what an index means for what a call returns differs by language.
[[nodiscard]] inline std::string column_text(const std::string& call, std::size_t number) {
    return "umbrage_cascade_column(" + call + ", " + std::to_string(number) + ".0)";
}

/// Adds the entries of one snippet.
/// @param call   call of the snippet, a mat4
/// @param twin   (sample) -> array of one place
template <class Twin>
void add_places(std::vector<entry>& all, const snippet& s, const std::vector<input_class>& classes,
                const std::string& call, const Twin& twin) {
    for (const bool of_slope : {false, true})
        all.push_back({.primitive = &s,
                       .variant = of_slope ? "slope" : "",
                       .classes = classes,
                       .twin = [twin, of_slope](const sample& x) { return column_of(twin(x)[0], of_slope); },
                       .call = column_text(call, of_slope),
                       .also = {&umbrage::glsl::cascade_column}});
    all.push_back({.primitive = &s,
                   .variant = "no second place",
                   .classes = {classes.front()},
                   .twin = [](const sample&) { return vec4(0.0f); },
                   .call = column_text(call, 2) + " + " + column_text(call, 3),
                   .also = {&umbrage::glsl::cascade_column}});
}

/// Inputs and a class whose position, x0.xyz, is NaN, in all coordinates, as every rotation leaves it.
[[nodiscard]] inline std::vector<input_class> with_nan_positions(std::vector<input_class> classes) {
    classes.push_back({"NaN position", [ordinary = classes.front().fill](std::uint64_t i, random& r, sample& s) {
                           ordinary(i, r, s);
                           s.x[0].x = s.x[0].y = s.x[0].z = std::numeric_limits<float>::quiet_NaN();
                       }});
    return classes;
}

/// Inputs for points and matrices, without denormals: where those choose a face, hardware that takes them for 0 chooses
/// another.
[[nodiscard]] inline std::vector<input_class> points_and_matrices(std::vector<range> ranges) {
    ranges.resize(24, range{-2.0f, 2.0f});
    return spread(std::move(ranges), large_values());
}

}  // namespace parity
