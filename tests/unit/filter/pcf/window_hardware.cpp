// SPDX-License-Identifier: MIT
#include <umbrage/filter/pcf/window_hardware.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include <umbrage/shader/glsl.hpp>

#include "../../rounds.hpp"
#include "windows.hpp"

using namespace umbrage;

namespace {

/// Weights along an axis as a sampler makes them of pairs.
template <class Fraction>
std::vector<double> by_pairs(const std::vector<double>& exact, Fraction fraction) {
    std::vector<double> weights;
    for (std::size_t i = 0; i < exact.size(); i += 2) {
        const double both = exact[i] + exact[i + 1], farther = fraction(exact[i + 1] / both);
        weights.insert(weights.end(), {both * (1 - farther), both * farther});
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

/// Weights of an axis' texels for a kernel moved by a fraction of a texel, in real numbers.
std::vector<double> moved_by(double s, const std::vector<std::int64_t>& quarters) {
    std::vector<double> weights;
    const auto sum = double(std::accumulate(quarters.begin(), quarters.end(), std::int64_t(0)));
    for (std::size_t i = 0; i <= quarters.size(); ++i) {
        const double here = i < quarters.size() ? double(quarters[i]) : 0, before = i > 0 ? double(quarters[i - 1]) : 0;
        weights.push_back((here * (1 - s) + before * s) / sum);
    }
    return weights;
}

/// Over 1024 positions of a window along an axis, every 31st of the other.
template <class Fraction>
double worst_change(const std::vector<std::int64_t>& quarters, Fraction fraction) {
    std::vector<std::vector<double>> exact, sampled;
    for (int position = 0; position < 1024; ++position) {
        exact.push_back(moved_by(position / 1024.0, quarters));
        sampled.push_back(by_pairs(exact.back(), fraction));
    }
    double worst = 0;
    for (std::size_t y = 0; y < exact.size(); y += 31)
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
    CHECK(window_hardware(clamped(map), glm::vec<2, T>(1), std::numeric_limits<T>::quiet_NaN(), tent_row<3>) == 0);
    CHECK(window_hardware(clamped(map), glm::vec<2, T>(std::numeric_limits<T>::quiet_NaN()), T(0), tent_row<3>) == 1);
}

TEST_CASE("window_hardware: between texels the sum in real numbers, on the steps of a row without floors its window") {
    for (const row_in_quarters& r : rows_in_quarters()) {
        if (r.quadratic) continue;
        CAPTURE(r.name);
        image<float> map({12, 12});
        unsigned state = 1;
        for (float& texel : map.texels()) texel = float((state = state * 1664525u + 1013904223u) >> 31);
        const bool floored = r.name == "binomial7" || r.name == "castano_dyadic5";
        for (int y = 0; y < 256; y += 15 * one_round_in)
            for (int x = 0; x < 512; ++x) {
                const glm::dvec2 moved(x / 512.0, y / 512.0);
                const auto along_x = moved_by(moved.x, r.quarters), along_y = moved_by(moved.y, r.quarters);
                double wanted = 0;
                for (int j = 0; j <= r.row.size; ++j)
                    for (int i = 0; i <= r.row.size; ++i)
                        wanted += along_x[std::size_t(i)] * along_y[std::size_t(j)] *
                                  double(map[glm::ivec2(5 + i, 5 + j) - r.row.size / 2]);
                const glm::vec2 coord = glm::vec2(moved) + (r.row.size % 2 ? 5.5f : 5.0f);
                const float got = window_hardware(clamped(map), coord, 0.5f, r.row);
                CHECK(std::abs(got - wanted) <= 1e-6);
                CHECK(window_hardware(clamped(map), coord, 0.0f, r.row) <= 1.0f);
                CHECK(window_hardware(clamped(map), coord, 0.0f, r.row) >= 1.0f - 1e-6f);
                if (floored || x * r.row.steps % 512 != 0 || y * r.row.steps % 512 != 0) continue;
                CHECK(std::abs(got - window(clamped(map), coord, 0.5f, r.row)) <= 1e-6f);
            }
    }
}

// Largest errors of samplers. Parity tests the errors of a shader's samplers.
TEST_CASE("window_hardware: its bound holds for fractions rounded and truncated to 1/256, and not to 1/64") {
    for (const row_in_quarters& r : rows_in_quarters()) {
        if (r.row.size % 2 == 0) continue;
        const double rounded = worst_change(r.quarters, [](double f) { return std::floor(f * 256 + 0.5) / 256; }),
                     truncated = worst_change(r.quarters, [](double f) { return std::floor(f * 256) / 256; }),
                     coarse = worst_change(r.quarters, [](double f) { return std::floor(f * 64) / 64; });
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
        for (auto at = text.find("umbrage_lit_between_sun(map, "); at != text.npos;
             at = text.find("umbrage_lit_between_sun(map, ", at + 1))
            ++found;
        return found;
    };
    CHECK(look_ups(glsl::window_hardware<3>) == 4);
    CHECK(look_ups(glsl::window_hardware<5>) == 9);
    CHECK(look_ups(glsl::window_hardware<7>) == 16);
}
