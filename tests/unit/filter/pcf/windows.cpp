// SPDX-License-Identifier: MIT
#include "windows.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "../maps.hpp"

using namespace umbrage;

namespace {

/// A window on an edge of a shadow: lit from column `first` on.
float on_edge(const window_row& row, double coord, int first) {
    return window([first](glm::ivec2 t) { return t.x >= first ? 1.0f : 0.0f; }, glm::vec2(float(coord), 0.5f), 0.5f,
                  row);
}

/// Castano's form of 5 x 5 along an axis, in reals: what it takes of texels base - 2 .. base + 3.
double merged_5(double coord, const bool* lit) {
    const double s = coord + 0.5 - std::floor(coord + 0.5);
    const double weights[]{4 - 3 * s, 7, 1 + 3 * s};
    const double at[]{(3 - 2 * s) / (4 - 3 * s) - 2, (3 + s) / 7, s / (1 + 3 * s) + 2};
    double sum = 0;
    for (int k = 0; k < 3; ++k) {
        const double left = std::floor(at[k]), f = at[k] - left;
        const auto texel = static_cast<std::size_t>(static_cast<int>(left) + 2);
        sum += weights[k] * ((1 - f) * lit[texel] + f * lit[texel + 1]);
    }
    return sum / 12;
}

}  // namespace

TEST_CASE("windows: the function of a name, the filter's value and the row are one") {
    std::mt19937 random(7);
    const image<float> map = random_map(random, {14, 11});
    const auto fetch = clamped(map);
    const auto rows = rows_in_quarters();
    CHECK(filters::window::values.size() == rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const filters::window& filter = filters::window::values[i];
        CHECK(filter.name == rows[i].name);
        CHECK(filter.snippet->name == rows[i].name);
        CHECK(filter.row.whole == rows[i].row.whole);
        CHECK((filter.snippet->exactness == glsl::tier::a) == is_power_of_two(filter.row.whole));
    }
    for (int i = 0; i < 500; ++i) {
        const glm::vec2 c = glm::vec2(random() % 3600, random() % 3000) / 256.0f;
        const float z = static_cast<float>(i % 9) / 8.0f;
        const float all[]{tent<2>(fetch, c, z),     tent<3>(fetch, c, z),           quadratic_b_spline(fetch, c, z),
                          binomial<5>(fetch, c, z), castano_dyadic<5>(fetch, c, z), castano<5>(fetch, c, z),
                          binomial<7>(fetch, c, z), tent<7>(fetch, c, z),           castano<7>(fetch, c, z)};
        for (std::size_t k = 0; k < rows.size(); ++k) {
            CHECK(filters::window::values[k](fetch, c, z) == all[k]);
            CHECK(window(fetch, c, z, rows[k].row) == all[k]);
        }
    }
}

TEST_CASE("windows: steps along an edge, what is all lit, and how close the exact rows come to Castano's") {
    struct fact {
        std::string_view name;
        double step;  // the largest change in 1/256 texel
    };
    const fact facts[]{{"tent2", .0020},     {"tent3", .0020},           {"quadratic_b_spline", .0039},
                       {"binomial5", .0015}, {"castano_dyadic5", .0017}, {"castano5", .0013},
                       {"binomial7", .0020}, {"tent7", .0010},           {"castano7", .0048}};
    for (std::size_t i = 0; const row_in_quarters& r : rows_in_quarters()) {
        CAPTURE(r.name);
        CHECK(r.name == facts[i].name);
        double largest = 0, before = 0;
        for (int x = 20 * 256 - 1280; x <= 20 * 256 + 1280; ++x) {
            const double now = double(on_edge(r.row, x / 256.0, 20));
            CHECK(now >= before);
            largest = std::max(largest, now - before);
            before = now;
        }
        CHECK(before == 1.0);
        CHECK(std::abs(largest - facts[i++].step) < 0.00006);
    }
    double five = 0, seven = 0;
    for (int x = 0; x < 2560; ++x) {
        const double c = 15 + x / 256.0;
        five = std::max(
            five, std::abs(double(on_edge(castano_dyadic_row<5>, c, 20)) - double(on_edge(castano_row<5>, c, 20))));
        seven =
            std::max(seven, std::abs(double(on_edge(binomial_row<7>, c, 20)) - double(on_edge(castano_row<7>, c, 20))));
    }
    CHECK(five < 0.018);
    CHECK(seven < 0.025);
    CHECK(five > 0.001);
}

TEST_CASE("castano<5>: the merged form in reals, every fraction, every mask of a row of texels") {
    for (int moved = 0; moved < 256; ++moved)
        for (unsigned mask = 0; mask < 64; ++mask) {
            bool lit[7]{};
            for (std::size_t i = 0; i < 6; ++i) lit[i] = mask >> i & 1;
            const double coord = 30.5 + moved / 256.0;
            const auto fetch = [&](glm::ivec2 t) { return lit[static_cast<std::size_t>(t.x - 28)] ? 1.0 : 0.0; };
            CHECK(std::abs(castano<5>(fetch, glm::dvec2(coord, 9.0), 0.5) - merged_5(coord, lit)) < 1e-14);
        }
}
