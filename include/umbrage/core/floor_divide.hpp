// SPDX-License-Identifier: MIT
//
// Whole numbers over whole numbers, rounded down: exact in floats, however far off the machine's division is.
//
//     float mean = umbrage::floor_divide(sum, count);
//
// GLSL allows a quotient to be 2.5 ulp off, older dialects anything. Its floor is then one off where the true quotient
// is whole or nearly so; a product tells, and products of whole numbers are exact.
#pragma once

#include <cmath>

#include <umbrage/core/scalar.hpp>
#include <umbrage/core/snippet.hpp>

namespace umbrage {

/// The quotient that a guess is at most one away from.
/// @param q     whole, floor(a / b) - 1 .. floor(a / b) + 1
/// @param a     whole, 0 <= a < 2^24;   b  whole, 1 <= b <= 2^24
/// @return      floor(a / b)
/// @formula     q - 1 where q b > a, q + 1 where (q + 1) b <= a, else q
/// @exactness   A: a product of 2^24 or more is beyond a, however it rounds
template <real T>
[[nodiscard]] constexpr T correct_quotient(T q, T a, T b) {
    const T more = q + T(1);
    return q * b > a ? q - T(1) : (more * b <= a ? more : q);
}

/// @param a     whole, 0 <= a < 2^24;   b  whole, 1 <= b <= 2^24;   their quotient at most 2^18
/// @return      floor(a / b)
/// @exactness   A: with a quotient up to 8 ulp off, less than 1 in so small a one, correct_quotient has all it needs
template <real T>
[[nodiscard]] T floor_divide(T a, T b) {
    return correct_quotient(std::floor(a / b), a, b);
}

namespace glsl {

inline constexpr snippet correct_quotient{
    .name = "correct_quotient",
    .summary = "a quotient of whole numbers, from one at most one off",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_correct_quotient: floor(a / b) from q, at most one off;  whole numbers, a below 2^24, b from 1 to 2^24
UMBRAGE_HIGHP float umbrage_correct_quotient(UMBRAGE_HIGHP float q, UMBRAGE_HIGHP float a, UMBRAGE_HIGHP float b) {
    UMBRAGE_HIGHP float more = q + 1.0;
    UMBRAGE_HIGHP float known = more * b <= a ? more : q;
    return q * b > a ? q - 1.0 : known;
}
)GLSL",
};

inline constexpr snippet floor_divide{
    .name = "floor_divide",
    .summary = "whole numbers divided and rounded down, whatever the division's error",
    .exactness = tier::a,
    .needs = list<&correct_quotient>,
    .source = R"GLSL(
// umbrage_floor_divide: floor(a / b) of whole numbers, a below 2^24, b from 1 to 2^24, the quotient at most 2^18
UMBRAGE_HIGHP float umbrage_floor_divide(UMBRAGE_HIGHP float a, UMBRAGE_HIGHP float b) {
    return umbrage_correct_quotient(floor(a / b), a, b);
}
)GLSL",
};

inline constexpr const snippet* floor_divide_snippets[]{&correct_quotient, &floor_divide};

}  // namespace glsl
}  // namespace umbrage
