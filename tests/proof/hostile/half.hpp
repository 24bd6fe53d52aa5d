// SPDX-License-Identifier: MIT
//
// IEEE binary16 arithmetic on the CPU, every operation rounded to nearest even: what a mediump that means it computes.
// And enough of GLSL's vectors to compile snippets with it. The numbers of tests/parity/arithmetic do not serve here:
// what they know beside a value, its bound and whether it is exact, holds at 32 bits alone.
#pragma once

#include <cmath>
#include <limits>

/// A binary16 value, held in a float. A float has more than twice its digits, so rounding twice is rounding once.
struct half {
    float v = 0.0f;

    half() = default;
    half(double exact) : v(rounded(exact)) {}

    static float rounded(double x) {
        if (!std::isfinite(x) || x == 0.0) return static_cast<float>(x);
        int exponent = 0;
        std::frexp(x, &exponent);  // |x| in [2^(exponent - 1), 2^exponent)
        const double step = std::ldexp(1.0, (exponent < -13 ? -13 : exponent) - 11);
        const double r = std::nearbyint(x / step) * step;
        if (std::abs(r) > 65504.0) return static_cast<float>(std::copysign(std::numeric_limits<double>::infinity(), x));
        return static_cast<float>(r);
    }

    friend half operator+(half a, half b) { return half(double(a.v) + double(b.v)); }
    friend half operator-(half a, half b) { return half(double(a.v) - double(b.v)); }
    friend half operator*(half a, half b) { return half(double(a.v) * double(b.v)); }
    friend bool operator<(half a, half b) { return a.v < b.v; }
    friend bool operator>(half a, half b) { return a.v > b.v; }
    friend bool operator<=(half a, half b) { return a.v <= b.v; }
    friend bool operator>=(half a, half b) { return a.v >= b.v; }
};

inline half floor(half x) { return half(std::floor(double(x.v))); }
inline half min(half a, half b) { return b < a ? b : a; }

/// GLSL's vec2, vec3 and vec4, which differ in type alone here.
template <int L>
struct half_vector {
    half x, y, z, w;

    half_vector(half x_, half y_, half z_ = 0.0, half w_ = 0.0) : x(x_), y(y_), z(z_), w(w_) {}
    friend half_vector operator+(half_vector a, half b) { return {a.x + b, a.y + b, a.z + b, a.w + b}; }
    friend half_vector operator*(half_vector a, half b) { return {a.x * b, a.y * b, a.z * b, a.w * b}; }
    friend half_vector operator+(half_vector a, half_vector b) { return {a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w}; }
    friend half_vector floor(half_vector a) { return {floor(a.x), floor(a.y), floor(a.z), floor(a.w)}; }
};
