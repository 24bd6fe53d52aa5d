// SPDX-License-Identifier: MIT
#include <umbrage/filter/pcf/window_hardware.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include <umbrage/shader/glsl.hpp>

#include "windows.hpp"

using namespace umbrage;

namespace {

/// A row's weights along an axis as a sampler makes them of pairs, in shares of the whole; from `exact` ones.
template <class Fraction>
std::vector<double> by_pairs(const std::vector<std::int64_t>& exact, double whole, Fraction fraction) {
    std::vector<double> weights;
    for (std::size_t i = 0; i < exact.size(); i += 2) {
        const double both = double(exact[i] + exact[i + 1]), farther = fraction(double(exact[i + 1]) / both);
        weights.insert(weights.end(), {both * (1 - farther) / whole, both * farther / whole});
    }
    return weights;
}

/// The greatest change of visibility over all maps: texels that gain weight are lit, the others are not.
double greatest_change(const std::vector<double>& x, const std::vector<double>& y, const std::vector<double>& exact_x,
                       const std::vector<double>& exact_y) {
    double change = 0;
    for (std::size_t j = 0; j < y.size(); ++j)
        for (std::size_t i = 0; i < x.size(); ++i) change += std::max(x[i] * y[j] - exact_x[i] * exact_y[j], 0.0);
    return change;
}

/// Over every position of a window.
template <class Fraction>
double worst_change(const row_in_quarters& r, Fraction fraction) {
    std::vector<std::vector<double>> exact, sampled;
    for (int moved = 0; moved < 256; moved += 256 / r.row.steps) {
        const auto weights = whole_weights(r.quarters, r.row.steps, false, moved);
        exact.push_back(by_pairs(weights, double(r.row.whole), [](double f) { return f; }));
        sampled.push_back(by_pairs(weights, double(r.row.whole), fraction));
    }
    double worst = 0;
    for (std::size_t y = 0; y < exact.size(); ++y)
        for (std::size_t x = 0; x < exact.size(); ++x)
            worst = std::max(worst, greatest_change(sampled[x], sampled[y], exact[x], exact[y]));
    return worst;
}

}  // namespace

TEST_CASE_TEMPLATE("window_hardware: by hand", T, float, double) {
    image<T> map({4, 1}, T(0.25));
    map[{2, 0}] = T(0.75), map[{3, 0}] = T(0.75);
    // 1 2 1 halfway between two texels, of which one is lit: weights 4 12 | 12 4 of 32
    CHECK(window_hardware(clamped(map), glm::vec<2, T>(2, 0.5), T(0.5), tent_row<3>) == T(0.5));
    CHECK(window_hardware(clamped(map), glm::vec<2, T>(1.5, 0.5), T(0.5), tent_row<3>) == T(0.25));
    CHECK(window_hardware(clamped(map), glm::vec<2, T>(1.5, 0.5), T(0.5), tent_row<3>, greater_equal{}) == T(0.75));
    CHECK(window_hardware(clamped(map), glm::vec<2, T>(1), T(2), tent_row<3>) == 1);  // beyond the far plane
}

// What a shader's samplers do to it is for parity; here, how far samplers can be off at all.
TEST_CASE("window_hardware: its bound holds for fractions rounded and truncated to 1/256, and not to 1/64") {
    for (const row_in_quarters& r : rows_in_quarters()) {
        const bool floored = r.name == "binomial7" || r.name == "castano_dyadic5" || r.quadratic;
        if (floored || r.row.size % 2 == 0) continue;
        const double rounded = worst_change(r, [](double f) { return std::floor(f * 256 + 0.5) / 256; }),
                     truncated = worst_change(r, [](double f) { return std::floor(f * 256) / 256; }),
                     coarse = worst_change(r, [](double f) { return std::floor(f * 64) / 64; });
        CAPTURE(r.name);
        MESSAGE(r.name << ": rounded " << rounded << ", truncated " << truncated << ", bound 1/128");
        CHECK(rounded <= double(glsl::window_hardware<3>.within) / 2);
        CHECK(truncated <= double(glsl::window_hardware<3>.within));
        CHECK(truncated > double(glsl::window_hardware<3>.within) / 2);
        CHECK(coarse > double(glsl::window_hardware<3>.within));
    }
}

TEST_CASE("window_hardware: so many look-ups") {
    using namespace umbrage::glsl;
    const auto look_ups = [](const snippet& s) {
        const std::string text = glsl::text({bind(s, "sun", {.texture = texture::shadow})});
        int found = 0;
        for (auto at = text.find("umbrage_lit_at_sun(map, "); at != text.npos;
             at = text.find("umbrage_lit_at_sun(map, ", at + 1))
            ++found;
        return found;
    };
    CHECK(look_ups(glsl::window_hardware<3>) == 4);
    CHECK(look_ups(glsl::window_hardware<5>) == 9);
    CHECK(look_ups(glsl::window_hardware<7>) == 16);
}
