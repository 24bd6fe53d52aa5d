// SPDX-License-Identifier: MIT
//
// A float as a graphics processor may have it. Sums and products are kept as an expression until their value is used;
// then they are evaluated in an order, with fused operations and roundings that a seed draws.
//
// Beside its value a number carries what the specifications leave to be proven: the result in real arithmetic, the
// bound of its error, and whether every grouping of it is exact.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "accuracy.hpp"

namespace parity::arithmetic {

/// Arithmetic of an implementation. The default is IEEE 754 in written order.
struct rules {
    enum roundings { nearest, up, down, toward_zero, either };

    bool fuses = false;            ///< a * b + c is rounded once
    bool reorders = false;         ///< sums and products are regrouped, common factors taken out or multiplied out
    roundings rounding = nearest;  ///< rounding of + - *; `either`: one of the two neighbors
    bool flushes_inputs = false;   ///< denormal operands act as zeros of their sign
    bool flushes_results = false;
    bool assumes_finite = false;  ///< no NaN, no infinity: comparisons with a NaN give anything, x - x is 0
    bool is_inaccurate = false;   ///< division, roots, exp2 are off by what the table of accuracies allows
    bool reads_beside = false;    ///< UNORM texels arrive an ulp off
    bool reads_halves = false;    ///< UNORM texels arrive in 16 bits, as through a sampler of lowp or mediump
    bool stores_either = false;   ///< a UNORM target keeps any of the two codes beside a result
    int sub_texel_bits = 0;       ///< bits of a linear sampler's weights; 0: exact weights
};

/// Outcome of one call.
struct outcome {
    bool denormal = false;      ///< among the values it used
    bool not_finite = false;    ///< likewise a NaN or an infinity
    bool out_of_range = false;  ///< overflow, or an operand outside the range of an accuracy
    bool unbounded = false;     ///< a divisor that its error may make zero
    int either_side = 0;        ///< comparisons and floors that real arithmetic decides otherwise
    int reads_decided = 0;      ///< of these, those of a texel as it was read
    int out_of_bound = 0;       ///< values farther from the real ones than their bound
    double operations = 0.0;    ///< greatest n of what was decided about
    int unproven = 0;           ///< comparisons and floors whose margin is not above the bound of what they decide
    double least_margin = std::numeric_limits<double>::infinity();  ///< of those with an error, as a multiple of it
    double margin = 0.0, error = 0.0;                               ///< of that one
    std::uint64_t groupings = 0;                                    ///< expressions that have another grouping
    std::uint64_t rewrites = 0;                                     ///< those that were evaluated in it
};

/// Unit of the bounds: a float lies within 2^-23 of a real number that it is rounded from, relative to it.
inline constexpr double unit = 0x1p-23;
/// Magnitudes below count as this one, so that a flushed denormal is within the bound as well.
inline constexpr double least_magnitude = 0x1p-103;

class number {
public:
    number() = default;
    number(float v);  ///< of a literal; an argument is given()
    number(double v) : number(static_cast<float>(v)) {}
    number(int v) : number(static_cast<float>(v)) {}
    number(std::uint32_t v) : number(static_cast<float>(v)) {}

    explicit operator int() const;
    explicit operator std::uint32_t() const;
    explicit operator float() const { return value(); }

    /// By the rules, and decided by them once for all.
    [[nodiscard]] float value() const;

    friend number operator+(number a, number b);
    friend number operator-(number a, number b);
    friend number operator*(number a, number b);
    friend number operator/(number a, number b);
    friend number operator-(number a);
    friend number operator+(number a) { return a; }
    number& operator+=(number b) { return *this = *this + b; }
    number& operator-=(number b) { return *this = *this - b; }
    number& operator*=(number b) { return *this = *this * b; }
    number& operator/=(number b) { return *this = *this / b; }
    friend bool operator<(number a, number b);
    friend bool operator>(number a, number b) { return b < a; }
    friend bool operator<=(number a, number b);
    friend bool operator>=(number a, number b) { return b <= a; }
    friend bool operator==(number a, number b);
    friend bool operator!=(number a, number b);

private:
    friend class expressions;
    std::uint32_t node_;
};

number floor(number v);
number ceil(number v);
number fract(number v);
number abs(number v);
number sqrt(number v);
number exp2(number v);
number min(number a, number b);
number max(number a, number b);
number uintBitsToFloat(std::uint32_t bits);
std::uint32_t floatBitsToUint(number v);

/// An argument of the call.
[[nodiscard]] number given(float v);
/// A texel of a format that holds it as it is, or of a UNORM format of so many bits.
[[nodiscard]] number read(float v, int unorm_bits);
/// The code 0 to 255 that an 8-bit UNORM target keeps of a result.
enum class unorm_store { rounds, truncates };
[[nodiscard]] number stored(number v, unorm_store by);
/// A value of the hardware's own making, e.g. by a linear sampler: within `error` of the real one.
[[nodiscard]] number made(float v, double real, double error);
/// Draws one of n by the seed.
[[nodiscard]] int drawn(int n);

/// Knowledge about a number besides its value.
struct knowledge {
    float value = 0.0f;
    double real = 0.0;        ///< in real arithmetic, after the same decisions
    double magnitude = 0.0;   ///< S: the expression with every value's magnitude and every minus a plus
    double operations = 0.0;  ///< n; |value - real| <= n 2^-23 S
    bool exact = false;       ///< under every grouping
    bool keeps_sign = false;  ///< no difference in it: it is zero or has the sign of the real number

    [[nodiscard]] double bound() const { return exact ? 0.0 : operations * unit * magnitude; }
};
[[nodiscard]] knowledge known(number v);
/// An argument or a texel, passed on as it came.
[[nodiscard]] bool is_argument(number v);
[[nodiscard]] bool is_literal(number v);
[[nodiscard]] bool is_nan(number v);

/// Begins a call; numbers of the one before are gone.
void begin(const rules& by, std::uint64_t seed);
[[nodiscard]] const outcome& result();
[[nodiscard]] const rules& rules_in_use();

}  // namespace parity::arithmetic

template <>
class std::numeric_limits<parity::arithmetic::number> : public std::numeric_limits<float> {};
