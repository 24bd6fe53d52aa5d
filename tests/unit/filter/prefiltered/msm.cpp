// SPDX-License-Identifier: MIT
#include <umbrage/filter/prefiltered/msm.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "linear_program.hpp"
#include "windows.hpp"

using namespace umbrage;

namespace {

glm::dvec4 moments(const depth_window& w) {
    return w.mean([](float d) { return encode_msm(double(d)); });
}

}  // namespace

TEST_CASE_TEMPLATE("msm: by hand", T, float, double) {
    using vec = glm::vec<4, T>;
    const T nan = std::numeric_limits<T>::quiet_NaN();
    CHECK(encode_msm(T(0.75)) == vec(T(0.5), T(0.25), T(0.125), T(0.0625)));
    CHECK(encode_msm(T(0.25), T(0)) == encode_msm(T(0.75)));
    for (const T far : {T(0), T(1)}) CHECK(encode_msm(nan, far) == vec(1));  // as cleared
    CHECK(bias_moments(vec(0), glm::vec<2, T>(T(0.5), T(0.375))) == vec(0, T(0.1875), 0, T(0.1875)));

    // half at -1/2, half at 1/2: at the receiver's 0 they shadow half of it
    const vec b(0, T(0.25), 0, T(0.0625));
    const glm::vec<2, T> bias(T(1e-3), T(0.375));
    CHECK(std::abs(decode_msm(b, T(0.5), bias) - T(0.5)) < T(0.005));
    CHECK(decode_msm(b, T(0.1), bias) > T(0.99));
    CHECK(decode_msm(b, T(0.9), bias) < T(0.05));
    CHECK(decode_msm(b, T(0.9), bias, T(0)) == decode_msm(b, T(1) - T(0.9), bias));
    CHECK(decode_msm(b, T(-3), bias) == decode_msm(b, T(0), bias));
    CHECK(decode_msm(b, T(3), bias) == decode_msm(b, T(1), bias));
}

TEST_CASE_TEMPLATE("msm: what no depths have, and NaN, gives what is documented", T, float, double) {
    using vec = glm::vec<4, T>;
    const T nan = std::numeric_limits<T>::quiet_NaN(), infinity = std::numeric_limits<T>::infinity();
    const glm::vec<2, T> none(0, T(0.375)), bias(msm_bias_32);
    for (const T receiver : {T(0), T(0.4), T(0.5), T(0.6), T(1)}) {
        CHECK(decode_msm(vec(0), receiver, none) == (receiver <= T(0.5) ? 1 : 0));  // one depth, no bias: its mean
        CHECK(decode_msm(encode_msm(T(1)), receiver, bias) > T(0.98));              // cleared
        CHECK(decode_msm(vec(nan), receiver, bias) == 0);
        for (const T v : {infinity, -infinity, T(1e30), T(-1)})
            for (int c = 0; c < 4; ++c) {
                vec b(T(0.1));
                b[c] = v;
                const T lit = decode_msm(b, receiver, bias);
                CHECK((lit >= 0 && lit <= 1));
            }
    }
    CHECK(decode_msm(vec(0), nan, bias) == 0);
}

TEST_CASE("to_optimized_moments: turned moments take [0, 1], and turn back") {
    double error = 0;
    glm::vec4 least(1), most(0);
    for (int k = 0; k <= 4096; ++k) {
        const glm::vec4 b = encode_msm(static_cast<float>(k) / 4096), o = to_optimized_moments(b),
                        back = from_optimized_moments(o);
        for (int c = 0; c < 4; ++c) {
            least[c] = std::min(least[c], o[c]), most[c] = std::max(most[c], o[c]);
            error = std::max(error, std::abs(double(back[c]) - double(b[c])));
        }
    }
    CHECK(error <= 0x1p-22);
    for (int c = 0; c < 4; ++c) {
        CHECK((least[c] > -1e-6f && least[c] < 1e-6f));
        CHECK(std::abs(most[c] - 1) < 1e-6f);
    }
}

TEST_CASE("moment_atoms: depths and shares that return the moments, so that no bound is better") {
    std::mt19937 random(13);
    double worst = 0, least = 1;
    for (int i = 0; i < 20000; ++i) {
        const depth_window w(random);
        const glm::dvec4 b = bias_moments(moments(w), glm::dvec2(1e-3, 0.375));
        const double z = 2 * double(w.receiver) - 1;
        const glm::dvec4 atoms = moment_atoms(b, z - b.x);
        const double own = 1 - atoms.z - atoms.w;
        least = std::min({least, own, atoms.z, atoms.w});
        for (int power = 1; power <= 4; ++power) {
            const double others = atoms.z * std::pow(atoms.x + b.x, power) + atoms.w * std::pow(atoms.y + b.x, power);
            const double sum = own * std::pow(z, power) + others;
            worst = std::max(worst, std::abs(sum - b[power - 1]) / std::max(1.0, atoms.w * std::pow(atoms.y, power)));
        }
    }
    CHECK(least >= -1e-12);
    CHECK(worst < 1e-9);
}

TEST_CASE("moment_atoms: no masses of depths far and wide shadow less, by a linear program") {
    std::mt19937 random(23);
    double worst = 0, unmet = 0;
    for (int i = 0; i < 200; ++i) {
        const depth_window w(random);
        const glm::dvec4 b = bias_moments(moments(w), glm::dvec2(1e-3, 0.375));
        const double z = 2 * double(w.receiver) - 1, x = z - b.x;
        const glm::dvec4 atoms = moment_atoms(b, x);
        std::vector<double> depths = depth_grid(w, 1);
        for (const double own : {z, atoms.x + b.x, atoms.y + b.x}) depths.push_back(own);
        const moment_program program(std::move(depths), z, {1, b.x, b.y, b.z, b.w});
        const double share = (atoms.x < x ? atoms.z : 0.0) + (atoms.y < x ? atoms.w : 0.0);
        worst = std::max(worst, std::abs(program.least() - share));
        unmet = std::max(unmet, program.unmet());
    }
    CHECK(unmet < 1e-6);
    CHECK(worst < 1e-6);
    MESSAGE("program and atoms apart by ", worst, ", its moments off by ", unmet);
}

TEST_CASE("msm: no darker than the lit share but for the bias and rounding; in floats within its bound") {
    struct setting {
        glm::vec2 bias;
        bool short_store;
        double eigenvalue;  // the least of the matrix of (0, y, 0, y)
    };
    for (const setting& s : {setting{{1e-3f, 0.375f}, false, 0.1994}, setting{{1e-4f, 0.375f}, false, 0.1994},
                             setting{msm_bias_32, false, 0.1994}, setting{msm_bias_16, true, 0.159}}) {
        const double bound = 9 * 0x1p-24 / (double(s.bias.x) * s.eigenvalue);
        std::mt19937 random(17);
        double worst = 0, darker = 0;
        int outside = 0;
        for (int i = 0; i < 50000; ++i) {
            const depth_window w(random);
            glm::vec4 b(moments(w));
            if (s.short_store) {
                glm::vec4 held = to_optimized_moments(b);
                for (int c = 0; c < 4; ++c) held[c] = std::floor(held[c] * 65535.0f + 0.5f) / 65535.0f;
                b = from_optimized_moments(held);
            }
            const double got = decode_msm(b, w.receiver, s.bias);
            const double real = decode_msm(glm::dvec4(b), double(w.receiver), glm::dvec2(s.bias));
            worst = std::max(worst, std::abs(got - real));
            darker = std::max(darker, w.lit() - got);
            outside += !(got >= 0 && got <= 1);
        }
        CHECK(outside == 0);
        CHECK(worst <= bound);
        CHECK(darker <= double(s.bias.x) + bound);
        MESSAGE("bias ", s.bias.x, std::string(s.short_store ? ", 16 bits" : ""), ": off by at most ", bound,
                "; worst seen ", worst, ", darker ", darker);
    }
}
