// SPDX-License-Identifier: MIT
//
// Functions of Metal's standard library as C++, of scalars and of vectors. What is not here does not compile.
#pragma once

#include <cmath>
#include <cstring>

#include "vectors.hpp"

template <class To, class From>
inline To as_type(const From& from) {
    static_assert(sizeof(To) == sizeof(From));
    To to;
    std::memcpy(static_cast<void*>(&to), static_cast<const void*>(&from), sizeof to);
    return to;
}

namespace metal {
namespace lent {

/// The vector among values, or the type that these scalars have in common.
template <class A, class... Others>
struct joint {
    using rest = typename joint<Others...>::type;
    using type = std::conditional_t<
        (components<A> > 1), A,
        typename std::conditional_t<(components<rest> > 1), std::type_identity<rest>, std::common_type<A, rest>>::type>;
};
template <class A>
struct joint<A> {
    using type = A;
};

template <class Value>
auto component(const Value& v, int i) {
    if constexpr (components < Value >> 1) return v[i];
    else return v;
}

/// A scalar's function, component by component.
template <class Function, class... Values>
auto each(Function f, const Values&... v) {
    using type = typename joint<Values...>::type;
    if constexpr (components < type >> 1) {
        using scalar = std::decay_t<decltype(std::declval<type>()[0])>;
        vec<decltype(f(scalar(component(v, 0))...)), components<type>> all;
        for (int i = 0; i < components<type>; ++i) all[i] = f(scalar(component(v, i))...);
        return all;
    } else return f(type(v)...);
}

template <class T>
T min(T a, T b) {
    return b < a ? b : a;
}
template <class T>
T max(T a, T b) {
    return a < b ? b : a;
}
/// Of a NaN the lower limit, as processors of graphics have it.
template <class T>
T clamp(T v, T low, T high) {
    return min(max(low, v), high);
}
template <class T>
T smoothstep(T low, T high, T v) {
    const T t = clamp((v - low) / (high - low), T(0), T(1));
    return t * t * (T(3) - T(2) * t);
}

}  // namespace lent

#define OF_EACH(name, parameters, result)                                 \
    template <class... Values>                                            \
    auto name(const Values&... v) {                                       \
        return lent::each([] parameters { return result; }, plain(v)...); \
    }
OF_EACH(abs, (auto a), std::abs(a))
OF_EACH(acos, (auto a), std::acos(a))
OF_EACH(asin, (auto a), std::asin(a))
OF_EACH(atan, (auto a), std::atan(a))
OF_EACH(atan2, (auto a, auto b), std::atan2(a, b))
OF_EACH(ceil, (auto a), std::ceil(a))
OF_EACH(clamp, (auto a, auto b, auto c), lent::clamp(a, b, c))
OF_EACH(cos, (auto a), std::cos(a))
OF_EACH(exp, (auto a), std::exp(a))
OF_EACH(exp2, (auto a), std::exp2(a))
OF_EACH(fabs, (auto a), std::abs(a))
OF_EACH(floor, (auto a), std::floor(a))
OF_EACH(fma, (auto a, auto b, auto c), std::fma(a, b, c))
OF_EACH(fmax, (auto a, auto b), std::fmax(a, b))
OF_EACH(fmin, (auto a, auto b), std::fmin(a, b))
OF_EACH(fmod, (auto a, auto b), std::fmod(a, b))
OF_EACH(fract, (auto a), a - std::floor(a))
OF_EACH(isinf, (auto a), std::isinf(a))
OF_EACH(isnan, (auto a), std::isnan(a))
OF_EACH(log, (auto a), std::log(a))
OF_EACH(log2, (auto a), std::log2(a))
OF_EACH(max, (auto a, auto b), lent::max(a, b))
OF_EACH(min, (auto a, auto b), lent::min(a, b))
OF_EACH(mix, (auto a, auto b, auto t), a + (b - a) * t)
OF_EACH(pow, (auto a, auto b), std::pow(a, b))
OF_EACH(powr, (auto a, auto b), std::pow(a, b))
OF_EACH(rint, (auto a), std::rint(a))
OF_EACH(round, (auto a), std::round(a))
OF_EACH(rsqrt, (auto a), 1.0f / std::sqrt(a))
OF_EACH(saturate, (auto a), lent::clamp(a, 0.0f, 1.0f))
OF_EACH(select, (auto a, auto b, auto second), second != 0 ? b : a)
OF_EACH(sign, (auto a), decltype(a)((0 < a) - (a < 0)))
OF_EACH(sin, (auto a), std::sin(a))
OF_EACH(smoothstep, (auto low, auto high, auto a), lent::smoothstep(low, high, a))
OF_EACH(sqrt, (auto a), std::sqrt(a))
OF_EACH(step, (auto edge, auto a), a < edge ? 0.0f : 1.0f)
OF_EACH(tan, (auto a), std::tan(a))
OF_EACH(trunc, (auto a), std::trunc(a))
#undef OF_EACH

namespace lent {

template <int N>
float dot(const vec<float, N>& a, const vec<float, N>& b) {
    float sum = a[0] * b[0];
    for (int i = 1; i < N; ++i) sum += a[i] * b[i];
    return sum;
}

}  // namespace lent

template <class A, class B>
float dot(const A& a, const B& b) {
    return lent::dot(plain(a), plain(b));
}
template <class Vector>
float length_squared(const Vector& v) {
    return dot(v, v);
}
template <class Vector>
float length(const Vector& v) {
    return std::sqrt(dot(v, v));
}
template <class A, class B>
float distance(const A& a, const B& b) {
    return length(b - a);
}
template <class Vector>
auto normalize(const Vector& v) {
    return v * rsqrt(dot(v, v));
}
template <class A, class B>
auto reflect(const A& incident, const B& normal) {
    return incident - normal * (2.0f * dot(normal, incident));
}
inline float3 cross(const float3& a, const float3& b) { return a.yzx * b.zxy - a.zxy * b.yzx; }

inline bool all(bool one) { return one; }
inline bool any(bool one) { return one; }
template <int N>
bool all(const vec<bool, N>& v) {
    bool every = true;
    for (bool each : v.of) every = every && each;
    return every;
}
template <int N>
bool any(const vec<bool, N>& v) {
    return !all(!v);
}

inline void discard_fragment() {}                       // what is returned is looked at all the same
inline float3 dfdx(float3) { return float3(1, 0, 0); }  // no neighbors here
inline float3 dfdy(float3) { return float3(0, 1, 0); }

template <class T, int Columns, int Rows>
matrix<T, Rows, Columns> transpose(const matrix<T, Columns, Rows>& m) {
    matrix<T, Rows, Columns> all;
    for (int i = 0; i < Rows; ++i)
        for (int k = 0; k < Columns; ++k) all[i][k] = m[k][i];
    return all;
}

namespace fast {
using namespace metal;
}
namespace precise {
using namespace metal;
}

}  // namespace metal
