// SPDX-License-Identifier: MIT
//
// Entries of a setup's places: one for each column of the matrix that its snippet returns.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include <umbrage/light/cascades/select.hpp>
#include <umbrage/shadow/setup.hpp>

#include "../entries.hpp"

namespace parity {

/// Column of a place as a snippet returns it: (texels, texels, depth, number) or (slope, slope, weight, slack). A
/// place without weight has zeros here.
[[nodiscard]] inline vec4 column_of(const umbrage::map_place& place, bool of_slope) {
    if (!(place.weight > 0.0f)) return vec4(0.0f);
    if (of_slope) return {place.slope.x, place.slope.y, place.weight, place.slack};
    return vec4(place.at, static_cast<float>(place.number));
}

/// A column of a call's matrix, by a function: what an index means for what a call returns differs by language.
[[nodiscard]] inline std::string column_text(const std::string& call, std::size_t number) {
    return "umbrage_cascade_column(" + call + ", " + std::to_string(number) + ".0)";
}

/// Adds the entries of one snippet.
/// @param call   call of the snippet, a mat4
/// @param twin   (sample) -> array of places
template <class Twin>
void add_places(std::vector<entry>& all, const snippet& s, const std::vector<input_class>& classes,
                const std::string& call, const Twin& twin) {
    constexpr std::size_t count = std::tuple_size_v<decltype(twin(sample()))>;
    constexpr const char* names[]{"", "slope", "next", "next slope"};
    for (std::size_t i = 0; i < 2 * count; ++i) {
        const std::string column = column_text(call, i);
        all.push_back(
            {.primitive = &s,
             .variant = names[i],
             .classes = classes,
             .twin = [twin, i](const sample& x) { return column_of(twin(x)[i / 2], i % 2 == 1); },
             .call =
                 i < 2 ? column : "(" + column_text(call, 3) + ".z > 0.0 ? " + column + " : vec4(0.0, 0.0, 0.0, 0.0))",
             .also = {&umbrage::glsl::cascade_column}});
    }
    if (count > 1) return;
    all.push_back({.primitive = &s,
                   .variant = "no second place",
                   .classes = {classes.front()},
                   .twin = [](const sample&) { return vec4(0.0f); },
                   .call = column_text(call, 2) + " + " + column_text(call, 3),
                   .also = {&umbrage::glsl::cascade_column}});
}

/// Inputs for points and matrices, without denormals: where those choose a face, hardware that takes them for 0 chooses
/// another.
[[nodiscard]] inline std::vector<input_class> points_and_matrices(std::vector<range> ranges) {
    ranges.resize(24, range{-2.0f, 2.0f});
    return spread(std::move(ranges), large_values());
}

}  // namespace parity
