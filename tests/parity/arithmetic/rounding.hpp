// SPDX-License-Identifier: MIT
//
// One operation on floats by the rules: what it may return, and which of that is drawn.
#pragma once

#include <cmath>
#include <limits>

#include "../compare.hpp"
#include "../random.hpp"
#include "number.hpp"

namespace parity::arithmetic {

class rounding {
public:
    rounding(const rules& by, random& draw) : by_(by), draw_(draw) {}

    [[nodiscard]] float sum(float a, float b) const {
        a = operand(a), b = operand(b);
        if (by_.assumes_finite && a == -b) return 0.0f;  // infinity less itself, to a compiler that knows of none
        if (by_.rounding == rules::nearest) return result(a + b);
        return result(rounded(double(a), double(b), a + b));
    }
    [[nodiscard]] float product(float a, float b) const {
        a = operand(a), b = operand(b);
        if (by_.assumes_finite && (a == 0.0f || b == 0.0f)) return 0.0f;
        if (by_.rounding == rules::nearest) return result(a * b);
        return result(rounded(double(a) * double(b), 0.0, a * b));
    }
    [[nodiscard]] float fused(float a, float b, float c) const {
        a = operand(a), b = operand(b), c = operand(c);
        if (by_.rounding == rules::nearest) return result(std::fma(a, b, c));
        return result(rounded(double(a) * double(b), double(c), std::fma(a, b, c)));
    }
    /// A function's true result, off by up to `ulp`; or rounded to nearest.
    [[nodiscard]] float function(double real, double ulp) const {
        const auto nearest = static_cast<float>(real);
        if (!by_.is_inaccurate || !std::isfinite(nearest) || nearest == 0.0f) return result(nearest);
        int exponent = 0;
        std::frexp(real, &exponent);
        const double step = std::ldexp(1.0, std::max(exponent, -125) - 24);
        const double off = ulp * (draw_.below(4) == 0 ? (draw_.below(2) ? 1.0 : -1.0) : 2.0 * draw_.unit() - 1.0);
        const auto v = static_cast<float>(real + off * step);
        return result(std::abs(double(v) - real) <= ulp * step ? v : nearest);
    }

    [[nodiscard]] float operand(float v) const { return by_.flushes_inputs ? flush(v) : v; }
    [[nodiscard]] float result(float v) const { return by_.flushes_results ? flush(v) : v; }

private:
    /// a + b where `nearest` is it rounded to nearest: exact as a sum of two doubles (Knuth).
    [[nodiscard]] float rounded(double a, double b, float nearest) const {
        if (!std::isfinite(nearest)) return nearest;
        const double sum = a + b, part = sum - a, rest = (a - (sum - part)) + (b - part);
        const double beyond = (sum - double(nearest)) + rest;
        if (beyond == 0.0) return nearest;
        const float infinity = std::numeric_limits<float>::infinity();
        const float low = beyond > 0.0 ? nearest : std::nextafter(nearest, -infinity);
        const float high = beyond > 0.0 ? std::nextafter(nearest, infinity) : nearest;
        switch (by_.rounding) {
            case rules::up: return high;
            case rules::down: return low;
            case rules::toward_zero: return low < 0.0f ? high : low;
            default: return draw_.below(2) ? high : low;
        }
    }

    const rules& by_;
    random& draw_;
};

}  // namespace parity::arithmetic
