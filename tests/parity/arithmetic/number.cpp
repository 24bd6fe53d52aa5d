// SPDX-License-Identifier: MIT
#include "number.hpp"

#include <algorithm>
#include <cmath>

#include "expressions.hpp"

namespace parity::arithmetic {

namespace {

expressions all;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// A function's result: its value, its real value, and its error as n and S.
number inexact(float value, double real, double magnitude, double operations) {
    if (!std::isfinite(real) || !std::isfinite(value)) all.out().out_of_range = true;
    if (!std::isfinite(magnitude)) all.out().unbounded = true;
    return all.inexact({value, real, std::max(magnitude, least_magnitude), operations});
}

template <class Whole>
number whole(number v, Whole to) {
    const auto value = static_cast<float>(to(double(v.value())));
    const knowledge k = known(v);
    const double real = k.real, next = std::round(real);
    // no rounding makes a positive number negative: it stays on its side of zero
    const double margin =
        next == 0.0 && k.keeps_sign && to(0.5 * real) == to(0.0) ? 1.0 - std::abs(real) : std::abs(real - next);
    all.decide(margin, k.bound(), k.operations, double(value) == to(real) || !std::isfinite(value));
    return all.exact(value);
}

template <class Order>
bool decide(number a, number b, Order order) {
    const float x = a.value(), y = b.value();
    if (std::isnan(x) || std::isnan(y))
        return all.by().assumes_finite ? all.draw().below(2) : order(double(x), double(y));
    const knowledge i = known(a), j = known(b);
    const bool is = order(double(x), double(y));
    const bool of_read = (all.is_argument(a) && !i.exact) || (all.is_argument(b) && !j.exact);
    if (of_read && is != order(i.real, j.real)) ++all.out().reads_decided;  // no arithmetic, no proof
    if (std::isfinite(i.real) && std::isfinite(j.real) && !of_read)
        all.decide(std::abs(i.real - j.real), i.bound() + j.bound(), std::max(i.operations, j.operations),
                   is == order(i.real, j.real));
    return is;
}

/// One of two numbers, chosen by their values; closer to each other than their errors, either is the real choice.
number chosen(number a, number b, bool takes_b, const double& (*of_reals)(const double&, const double&)) {
    if (all.by().assumes_finite && (std::isnan(a.value()) || std::isnan(b.value()))) takes_b = all.draw().below(2);
    const knowledge i = known(a), j = known(b), &taken = takes_b ? j : i;
    const bool is_clear = std::abs(i.real - j.real) > i.bound() + j.bound();
    if (taken.exact && (i.exact == j.exact || is_clear || std::isnan(i.real) || std::isnan(j.real)))
        return all.exact(taken.value);
    return inexact(taken.value, of_reals(i.real, j.real), std::max(i.magnitude, j.magnitude),
                   std::max(i.operations, j.operations));
}

}  // namespace

number::number(float v) : node_(all.exact(v, expressions::literal).node_) {}
float number::value() const { return all.value(*this); }
number::operator int() const {
    const float v = whole(*this, [](double x) { return std::trunc(x); }).value();
    return std::abs(v) < 0x1p31f ? static_cast<int>(v) : 0;
}
number::operator std::uint32_t() const {
    const float v = whole(*this, [](double x) { return std::trunc(x); }).value();
    return v >= 0.0f && v < 0x1p32f ? static_cast<std::uint32_t>(v) : 0;
}

number operator+(number a, number b) { return all.sum(a, b); }
number operator-(number a, number b) { return all.sum(a, all.negated(b)); }
number operator*(number a, number b) { return all.product(a, b); }
number operator-(number a) { return all.negated(a); }
number operator/(number a, number b) {
    const float x = a.value(), y = b.value();
    if (all.is_literal(a) && all.is_literal(b)) return number(x / y);  // a compiler does that
    const knowledge i = known(a), j = known(b);
    if (all.by().is_inaccurate && !(std::abs(y) >= 0x1p-126f && std::abs(y) <= 0x1p126f)) all.out().out_of_range = true;
    const bool bounded = j.bound() * 2.0 < std::abs(j.real);
    return inexact(all.round().function(double(x) / double(y), division.worst()), i.real / j.real,
                   bounded ? i.magnitude * j.magnitude / (j.real * j.real) : infinity,
                   i.operations + j.operations + division.worst());
}
bool operator<(number a, number b) {
    return decide(a, b, [](double x, double y) { return x < y; });
}
bool operator<=(number a, number b) {
    return decide(a, b, [](double x, double y) { return x <= y; });
}
bool operator==(number a, number b) {
    return decide(a, b, [](double x, double y) { return x == y; });
}
bool operator!=(number a, number b) {
    return decide(a, b, [](double x, double y) { return x != y; });
}

number floor(number v) {
    return whole(v, [](double x) { return std::floor(x); });
}
number ceil(number v) {
    return whole(v, [](double x) { return std::ceil(x); });
}
number fract(number v) { return v - floor(v); }
number abs(number v) {
    const float value = std::abs(v.value());
    const knowledge k = known(v);
    return k.exact ? all.exact(value) : inexact(value, std::abs(k.real), k.magnitude, k.operations);
}
number sqrt(number v) {
    const float x = v.value();
    const knowledge k = known(v);
    const auto value = all.round().function(std::sqrt(double(x)), square_root.worst());
    if (all.by().is_inaccurate && x < 0x1p-126f && x != 0.0f) all.out().out_of_range = true;
    const double real = std::sqrt(std::max(k.real, 0.0)), bound = k.bound(), accuracy = square_root.worst();
    if (2.0 * bound < k.real) return inexact(value, real, k.magnitude / real, 0.7 * k.operations + accuracy);
    return inexact(value, real, std::sqrt(k.real + bound) / unit, 1.0 + accuracy * unit);  // by the root of the error
}
number exp2(number v) {
    const float x = v.value();
    const knowledge k = known(v);
    if (all.by().is_inaccurate && !(x >= -126.0f && x < 128.0f)) all.out().out_of_range = true;
    const double real = std::exp2(k.real), accuracy = power_of_two.worst() + 2.0 * std::abs(double(x));
    return inexact(all.round().function(std::exp2(double(x)), accuracy), real, real * std::max(1.0, k.magnitude),
                   k.operations + accuracy);
}
number min(number a, number b) { return chosen(a, b, b.value() < a.value(), std::min<double>); }
number max(number a, number b) { return chosen(a, b, a.value() < b.value(), std::max<double>); }
number uintBitsToFloat(std::uint32_t bits) { return all.exact(umbrage::detail::bit_cast<float>(bits)); }
std::uint32_t floatBitsToUint(number v) { return umbrage::detail::bit_cast<std::uint32_t>(v.value()); }

number given(float v) { return all.exact(v, expressions::argument); }
number read(float v, int unorm_bits) {
    const rules& by = all.by();
    if (unorm_bits == 0 || v == 0.0f || v == 1.0f || !(by.reads_beside || by.reads_halves)) return given(v);
    if (by.reads_halves && unorm_bits == 8) {
        const float half = std::ldexp(std::nearbyint(std::ldexp(v, 10 - std::ilogb(v))), std::ilogb(v) - 10);
        return all.inexact({half, v, v, 4096.0}, expressions::argument);
    }
    const float beside[] = {v, std::nextafter(v, 0.0f), std::nextafter(v, 2.0f)};
    return all.inexact({beside[all.draw().below(3)], v, v, 1.0}, expressions::argument);
}
number stored(number v, unorm_store by) {
    const double scaled = double(v.value()) * 255.0, low = std::floor(std::clamp(scaled, 0.0, 255.0));
    const knowledge k = known(v);
    const auto code = [by](double x) {
        x = x > 0.0 ? std::min(x, 255.0) : 0.0;  // of a NaN 0
        return by == unorm_store::rounds ? std::floor(x + 0.5) : std::floor(x);
    };
    if (all.by().stores_either) return scaled > low && all.draw().below(2) ? float(low + 1.0) : float(low);
    const double real = k.real * 255.0 + (by == unorm_store::rounds ? 0.5 : 0.0);
    all.decide(std::abs(real - std::round(real)), 255.0 * k.bound(), k.operations,
               code(scaled) == code(k.real * 255.0));
    return static_cast<float>(code(scaled));
}
number made(float v, double real, double error) { return inexact(v, real, error / unit, 1.0); }
int drawn(int n) { return all.draw().below(n); }
bool is_literal(number v) { return all.is_literal(v); }
bool is_nan(number v) { return std::isnan(v.value()); }
bool is_argument(number v) { return all.is_argument(v); }
knowledge known(number v) { return all.knowledge_of(v); }

void begin(const rules& by, std::uint64_t seed) { all.begin(by, seed); }
const outcome& result() { return all.out(); }
const rules& rules_in_use() { return all.by(); }

}  // namespace parity::arithmetic
