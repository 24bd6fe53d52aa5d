// SPDX-License-Identifier: MIT
//
// GLSL's functions on vectors of numbers: GLM's types, whose own functions know floats alone.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "number.hpp"

namespace parity::arithmetic {

template <int L>
using vector = glm::vec<L, number>;

template <int L, class Function>
[[nodiscard]] vector<L> each(Function of) {
    vector<L> all;
    for (int i = 0; i < L; ++i) all[i] = of(i);
    return all;
}

/// Between literals, a number even of a NaN: Direct3D's `saturate`, which all hardware has.
inline number clamp(number v, number low, number high) {
    if (rules_in_use().assumes_finite && is_literal(low) && is_literal(high) && is_nan(v)) return drawn(2) ? low : high;
    return min(max(low, v), high);
}

template <int L>
vector<L> floor(const vector<L>& v) {
    return each<L>([&](int i) { return floor(v[i]); });
}
template <int L>
vector<L> ceil(const vector<L>& v) {
    return each<L>([&](int i) { return ceil(v[i]); });
}
template <int L>
vector<L> fract(const vector<L>& v) {
    return each<L>([&](int i) { return fract(v[i]); });
}
template <int L>
vector<L> abs(const vector<L>& v) {
    return each<L>([&](int i) { return abs(v[i]); });
}
template <int L>
vector<L> min(const vector<L>& a, const vector<L>& b) {
    return each<L>([&](int i) { return min(a[i], b[i]); });
}
template <int L>
vector<L> max(const vector<L>& a, const vector<L>& b) {
    return each<L>([&](int i) { return max(a[i], b[i]); });
}
template <int L>
vector<L> clamp(const vector<L>& v, const vector<L>& low, const vector<L>& high) {
    return each<L>([&](int i) { return clamp(v[i], low[i], high[i]); });
}
template <int L>
number dot(const vector<L>& a, const vector<L>& b) {
    number sum = a[0] * b[0];
    for (int i = 1; i < L; ++i) sum += a[i] * b[i];
    return sum;
}

}  // namespace parity::arithmetic
