// SPDX-License-Identifier: MIT
#include <umbrage/filter/prefiltered/chebyshev.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "windows.hpp"

using namespace umbrage;

TEST_CASE_TEMPLATE("chebyshev: by hand", T, float, double) {
    using vec = glm::vec<2, T>;
    const T nan = std::numeric_limits<T>::quiet_NaN(), infinity = std::numeric_limits<T>::infinity();
    const vec m(T(0.5), T(0.3125));  // deviation 1/4
    CHECK(chebyshev(m, T(0.5), T(0)) == 1);
    CHECK(chebyshev(m, T(0.75), T(0)) == T(0.5));
    CHECK(chebyshev(m, T(1), T(0)) == T(0.2));
    CHECK(chebyshev(vec(T(0.5), T(0.25)), T(0.75), T(0)) == 0);            // no variance
    CHECK(chebyshev(vec(T(0.5), T(0.25)), T(0.75), T(0.0625)) == T(0.5));  // but the least
    CHECK(chebyshev(vec(T(0.5), T(0)), T(0.75), T(0.0625)) == T(0.5));     // below none
    CHECK(chebyshev(vec(0), T(1e-30), T(0)) == 0);                         // whose square is none
    for (const T v : {nan, infinity, -infinity}) {
        CHECK(std::isfinite(chebyshev(vec(v, T(0.3)), T(0.75), T(0))));
        CHECK(std::isfinite(chebyshev(vec(T(0.5), v), T(0.75), T(0))));
        CHECK(std::isfinite(chebyshev(m, v, T(0))));
    }
    CHECK(chebyshev(vec(nan), T(0.5), T(0)) == 0);
    CHECK(chebyshev(m, nan, T(0)) == 0);

    CHECK(reduce_light_bleeding(T(0.25), T(0.25)) == 0);
    CHECK(reduce_light_bleeding(T(0.625), T(0.25)) == T(0.5));
    CHECK(reduce_light_bleeding(T(1), T(0.25)) == 1);
    CHECK(reduce_light_bleeding(nan, T(0.25)) == 0);
    CHECK(reduce_light_bleeding(T(0.5), T(1)) == 0);
    CHECK(to_forward_depth(T(0.25)) == T(0.25));
    CHECK(to_forward_depth(T(0.25), T(0)) == T(0.75));
}

TEST_CASE("chebyshev: never darker than the lit share, and within its bound of reals") {
    std::mt19937 random(5);
    for (const float least : {1e-6f, 1e-4f}) {
        const double bound = (0.25 / double(least) + 4) * 0x1p-24;
        double worst = 0, darker = 0;
        for (int i = 0; i < 100000; ++i) {
            const depth_window w(random);
            const glm::dvec2 m = w.mean([](float d) { return glm::dvec2(d, double(d) * d); });
            const double got = chebyshev(glm::vec2(m), w.receiver, least);
            const double variance = std::max(m.y - m.x * m.x, double(least)), distance = w.receiver - m.x;
            const double real = distance <= 0 ? 1 : variance / (variance + distance * distance);
            worst = std::max(worst, std::abs(got - real));
            darker = std::max(darker, w.lit() - got);
        }
        CHECK(worst <= bound);
        CHECK(darker <= bound);
        MESSAGE("least variance ", least, ": off by at most ", bound, "; worst seen ", worst, ", darker ", darker);
    }
}

TEST_CASE("chebyshev: what two casters behind each other let through") {
    for (const auto& [a, b] : {std::pair{0.25, 0.125}, {0.5, 0.01}, {0.01, 0.5}}) {
        const double most = (a / (a + 2 * b)) * (a / (a + 2 * b));
        double seen = 0;
        for (int k = 1; k < 10000; ++k) {
            const double share = k / 10000.0, z1 = 0.25, z2 = z1 + a;
            const glm::dvec2 m(share * z1 + (1 - share) * z2, share * z1 * z1 + (1 - share) * z2 * z2);
            seen = std::max(seen, chebyshev(m, z2 + b, 0.0));
        }
        CHECK(seen <= most + 1e-12);
        CHECK(seen > most - 1e-4);
    }
}
