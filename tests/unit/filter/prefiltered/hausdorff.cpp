// SPDX-License-Identifier: MIT
#include <umbrage/filter/prefiltered/hausdorff.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <glm/matrix.hpp>

#include "linear_program.hpp"
#include "windows.hpp"

using namespace umbrage;

TEST_CASE_TEMPLATE("hausdorff: what no depths have, and NaN, is finite; the near end is lit", T, float, double) {
    using vec = glm::vec<4, T>;
    const T nan = std::numeric_limits<T>::quiet_NaN(), infinity = std::numeric_limits<T>::infinity();
    const glm::vec<2, T> none(0, T(0.375)), bias(msm_bias_32);
    for (const T receiver : {T(-1), T(0), T(0.4), T(0.5), T(0.6), T(1), T(2), nan, infinity}) {
        for (const T v : {infinity, -infinity, T(1e30), T(-1), nan})
            for (int c = 0; c < 4; ++c) {
                vec b(T(0.1));
                b[c] = v;
                const T lit = decode_msm_hausdorff(b, receiver, bias);
                CHECK((lit >= 0 && lit <= 1));
            }
        CHECK(decode_msm_hausdorff(vec(0), receiver, none) == (receiver <= T(0.5) ? 1 : 0));
    }
    CHECK(decode_msm_hausdorff(vec(0, T(0.25), 0, T(0.0625)), T(0), bias) == 1);
    CHECK(decode_msm_hausdorff(vec(0, T(0.25), 0, T(0.0625)), T(0.25), bias, T(0)) ==
          decode_msm_hausdorff(vec(0, T(0.25), 0, T(0.0625)), T(0.75), bias));
}

TEST_CASE("hausdorff: depths on [-1, 1] and shares that return the moments and shadow as much; no depths shadow less") {
    std::mt19937 random(19);
    int taken = 0;
    double worst = 0, least = 1, darker = 0, lighter = 0, gained = 0, in_floats = 0;
    for (int i = 0; i < 20000; ++i) {
        const depth_window w(random);
        const glm::dvec4 unbiased = w.mean([](float d) { return encode_msm(double(d)); });
        const glm::dvec2 bias(1e-3, 0.375);
        const glm::dvec4 b = bias_moments(unbiased, bias);
        const double z = 2 * double(w.receiver) - 1, receiver = w.receiver;
        const double lit = decode_msm_hausdorff(unbiased, receiver, bias), plain = decode_msm(unbiased, receiver, bias);
        darker = std::max(darker, w.lit() - lit);
        lighter = std::max(lighter, lit - plain);
        gained += plain - lit;
        in_floats = std::max(
            in_floats, std::abs(lit - double(decode_msm_hausdorff(glm::vec4(unbiased), w.receiver, glm::vec2(bias)))));
        const glm::dvec4 atoms = moment_atoms(b, z - b.x);
        if (std::abs(atoms.x + b.x) <= 1 && std::abs(atoms.y + b.x) <= 1) continue;
        const double d = (b.z - b.x) - z * (b.y - 1), f = ((b.w - b.y) - z * (b.z - b.x)) / d;
        if (std::abs(z) == 1 || std::abs(f - z) < 1e-3 || std::abs(std::abs(f) - 1) < 1e-3) continue;
        ++taken;
        REQUIRE(std::abs(f) <= 1);
        glm::dmat4 powers;  // columns: depths, rows: powers 0 to 3
        const glm::dvec4 depths(-1, f, z, 1);
        for (int c = 0; c < 4; ++c)
            for (int r = 0; r < 4; ++r) powers[c][r] = std::pow(depths[c], r);
        const glm::dvec4 shares = glm::inverse(powers) * glm::dvec4(1, b.x, b.y, b.z);
        double fourth = 0;
        for (int c = 0; c < 4; ++c) {
            fourth += shares[c] * std::pow(depths[c], 4);
            least = std::min(least, shares[c]);
        }
        worst = std::max(worst, std::abs(fourth - b.w));
        worst = std::max(worst, std::abs((shares[0] + (f < z ? shares[1] : 0)) - (1 - lit)));
    }
    CHECK(taken > 2000);
    CHECK(worst < 1e-9);
    CHECK(least > -1e-9);
    CHECK(darker <= 1e-3 + 1e-9);
    CHECK(lighter <= 1e-9);
    CHECK(gained > 100);
    MESSAGE("taken in ", taken, " of 20000, which lets ", gained / 20000, " less light through; floats off by ",
            in_floats);
}

namespace {

/// The fourth of hausdorff_share's depths: 0 / 0 where there is none.
double fourth_depth(const glm::dvec4& b, double z) {
    return ((b.w - b.y) - z * (b.z - b.x)) / ((b.z - b.x) - z * (b.y - 1));
}

/// The sum of the absolute coefficients, but for the constant's, of the polynomial whose mean is the share before z, or
/// where f < z the share from z on.
double coefficients(double z, double f) {
    using polynomial = std::array<double, 5>;
    const auto times = [](const polynomial& a, double root) {  // a (t - root)
        polynomial product{};
        for (std::size_t k = 0; k < 5; ++k) {
            product[k] -= root * a[k];
            if (k < 4) product[k + 1] += a[k];
        }
        return product;
    };
    const auto twice = [&](const polynomial& a) { return times(times(a, f), f); };
    polynomial share{};
    if (f > z) share = twice(times(times({1 / (2 * (1 + z) * (1 + f) * (1 + f))}, z), 1));
    else {
        const double flat = 1 / (2 * (1 - f) * (1 - f)), slope = (1 / ((1 + z) * (z - f) * (z - f)) - flat) / (z - 1);
        share = twice(times({flat - slope, slope}, -1));
    }
    return std::abs(share[1]) + std::abs(share[2]) + std::abs(share[3]) + std::abs(share[4]);
}

}  // namespace

TEST_CASE("hausdorff: no masses of depths on [-1, 1] shadow less, by a linear program") {
    std::mt19937 random(29);
    double worst = 0, unmet = 0;
    int taken = 0;
    for (int i = 0; i < 300; ++i) {
        const depth_window w(random);
        const glm::dvec4 b = bias_moments(w.mean([](float d) { return encode_msm(double(d)); }), {1e-3, 0.375});
        const double z = 2 * double(w.receiver) - 1, share = hausdorff_share(b, z);
        if (z <= -1 || share < 0) continue;
        ++taken;
        std::vector<double> depths = depth_grid(w, 0);
        for (const double own : {z, fourth_depth(b, z)}) depths.push_back(own);
        const moment_program program(std::move(depths), z, {1, b.x, b.y, b.z, b.w});
        worst = std::max(worst, std::abs(program.least() - share));
        unmet = std::max(unmet, program.unmet());
    }
    CHECK(taken > 50);
    CHECK(unmet < 1e-6);
    CHECK(worst < 1e-6);
    MESSAGE("of ", taken, " windows apart by ", worst, ", the program's moments off by ", unmet);
}

TEST_CASE("hausdorff_share: in floats within its bound of reals") {
    for (const float share : {1e-3f, 1e-4f, msm_bias_32.x}) {
        std::mt19937 random(31);
        double worst = 0, part = 0;
        int taken = 0;
        for (int i = 0; i < 50000; ++i) {
            const depth_window w(random);
            const glm::vec4 held(w.mean([](float d) { return encode_msm(double(d)); }));
            const glm::vec2 bias(share, 0.375f);
            const double z = 2 * double(w.receiver) - 1;
            const glm::dvec4 b = bias_moments(glm::dvec4(held), glm::dvec2(bias));
            const double real = hausdorff_share(b, z), f = fourth_depth(b, z);
            const double got = double(hausdorff_share(bias_moments(held, bias), static_cast<float>(z)));
            if (real < 0 || got < 0 || std::abs(z) >= 1) continue;
            ++taken;
            const double away = 1 / ((1 + z) * (1 - f * f)) + 1 / std::abs(z - f);
            const double bound = 24 * 0x1p-24 * (coefficients(z, f) + away), error = std::abs(real - got);
            worst = std::max(worst, error), part = std::max(part, error / bound);
        }
        CHECK(taken > 5000);
        CHECK(part <= 1);
        MESSAGE("bias ", share, ": worst seen ", worst, ", at most ", part, " of its bound");
    }
}
