// SPDX-License-Identifier: MIT
//
// Integer division that rounds down, exact in floats even if the machine's division is inexact.
//
//     float mean = umbrage::floor_divide(sum, count);
//
// GLSL allows an error of 2.5 ulp in a quotient, and older dialects any error. The floor is then off by one where the
// true quotient is an integer or close to one. A product reveals the error, because products of integers are exact.
#pragma once

#include <cmath>

#include <umbrage/core/scalar.hpp>
#include <umbrage/core/snippet.hpp>

namespace umbrage {

/// Floor of a quotient, from a guess that is off by at most one.
/// @param q     guess: an integer, floor(a / b) - 1 to floor(a / b) + 1
/// @param a     dividend: an integer, 0 <= a < 2^24
/// @param b     divisor: an integer, 1 <= b <= 2^24
/// @return      floor(a / b)
/// @formula     q - 1 where q b > a, q + 1 where (q + 1) b <= a, else q
/// @exactness   A: a product of 2^24 or more exceeds a, even after rounding
template <real T>
[[nodiscard]] constexpr T correct_quotient(T q, T a, T b) {
    const T more = q + T(1);
    return q * b > a ? q - T(1) : (more * b <= a ? more : q);
}

/// Floor of a quotient of two integers. The quotient must be at most 2^18.
/// @param a     dividend: an integer, 0 <= a < 2^24
/// @param b     divisor: an integer, 1 <= b <= 2^24
/// @return      floor(a / b)
/// @exactness   A: a quotient up to 2^18 with an error of 8 ulp is off by less than 1, and correct_quotient mends that
template <real T>
[[nodiscard]] T floor_divide(T a, T b) {
    return correct_quotient(std::floor(a / b), a, b);
}

namespace glsl {

inline constexpr snippet correct_quotient{
    .name = "correct_quotient",
    .summary = "floor of a quotient, from a guess off by at most one",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_correct_quotient: floor(a / b) from a guess q, off by at most one
//   a   integer, 0 to 2^24 - 1
//   b   integer, 1 to 2^24
UMBRAGE_HIGHP float umbrage_correct_quotient(UMBRAGE_HIGHP float q, UMBRAGE_HIGHP float a, UMBRAGE_HIGHP float b) {
    UMBRAGE_HIGHP float more = q + 1.0;
    UMBRAGE_HIGHP float known = more * b <= a ? more : q;
    return q * b > a ? q - 1.0 : known;
}
)GLSL",
};

inline constexpr snippet floor_divide{
    .name = "floor_divide",
    .summary = "integer division that rounds down, exact on any GPU",
    .exactness = tier::a,
    .needs = list<&correct_quotient>,
    .source = R"GLSL(
// umbrage_floor_divide: floor(a / b) of integers; the quotient is at most 2^18
//   a   integer, 0 to 2^24 - 1
//   b   integer, 1 to 2^24
UMBRAGE_HIGHP float umbrage_floor_divide(UMBRAGE_HIGHP float a, UMBRAGE_HIGHP float b) {
    return umbrage_correct_quotient(floor(a / b), a, b);
}
)GLSL",
};

inline constexpr const snippet* floor_divide_snippets[]{&correct_quotient, &floor_divide};

}  // namespace glsl
}  // namespace umbrage
