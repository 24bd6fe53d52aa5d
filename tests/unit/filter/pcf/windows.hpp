// SPDX-License-Identifier: MIT
//
// The rows of windows.hpp once more, as integers: quarters of their weights.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include <umbrage/filter/pcf/windows.hpp>

struct row_in_quarters {
    std::string_view name;
    umbrage::window_row row;
    std::vector<std::int64_t> quarters;  ///< all weights
    bool quadratic = false;
};

inline std::vector<row_in_quarters> rows_in_quarters() {
    using namespace umbrage;
    return {{"tent2", tent_row<2>, {32, 32}},
            {"tent3", tent_row<3>, {16, 32, 16}},
            {"quadratic_b_spline", quadratic_b_spline_row, {32, 32}, true},
            {"binomial5", binomial_row<5>, {4, 16, 24, 16, 4}},
            {"castano_dyadic5", castano_dyadic_row<5>, {5, 16, 22, 16, 5}},
            {"castano5", castano_row<5>, {4, 12, 16, 12, 4}},
            {"binomial7", binomial_row<7>, {1, 6, 15, 20, 15, 6, 1}},
            {"tent7", tent_row<7>, {4, 8, 12, 16, 12, 8, 4}},
            {"castano7", castano_row<7>, {4, 20, 48, 64, 48, 20, 4}}};
}

/// floor(K_i r + K_(i-1) s) in integers, what is left to the middle one.
inline std::vector<std::int64_t> whole_weights(const std::vector<std::int64_t>& quarters, int steps, bool quadratic,
                                               int moved) {
    const std::size_t size = quarters.size();
    const std::int64_t s = std::int64_t(moved) * steps / 256;
    std::vector<std::int64_t> weights(size + 1);
    std::int64_t left = 0;
    for (std::int64_t k : quarters) left += k * steps / 4;
    for (std::size_t i = 0; i <= size; ++i) {
        const std::int64_t here = i < size ? quarters[i] : 0, before = i > 0 ? quarters[i - 1] : 0;
        weights[i] = (here * (steps - s) + before * s) / 4;
        if (quadratic) weights[i] = i == 0 ? (256 - moved) * (256 - moved) / 32 : moved * moved / 32;
        if (i != size / 2) left -= weights[i];
    }
    weights[size / 2] = left;
    return weights;
}

inline bool is_power_of_two(float v) {
    const auto whole = static_cast<std::uint32_t>(v);
    return static_cast<float>(whole) == v && (whole & (whole - 1)) == 0;
}
