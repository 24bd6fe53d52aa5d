// SPDX-License-Identifier: MIT
//
// Components of a vector by letters, as Metal has them: v.xy, v.bgr, v.xxyy = w.
#pragma once

#include <type_traits>
#include <utility>

namespace metal {

template <class T, int N>
struct vec;

/// Components of the vector of N in which it lies, by their places: v.xy is a vec<T, 2> of 0 and 1.
template <class T, int N, class Vector, int... Places>
struct swizzle {
    T of[N];

    operator Vector() const { return Vector(of[Places]...); }
    swizzle& operator=(const Vector& v) {
        int i = 0;
        ((of[Places] = v[i++]), ...);
        return *this;
    }
    swizzle& operator=(const swizzle& other) { return *this = Vector(other); }
    swizzle& operator+=(const Vector& v) { return *this = *this + v; }
    swizzle& operator-=(const Vector& v) { return *this = *this - v; }
    swizzle& operator*=(const Vector& v) { return *this = *this * v; }
    swizzle& operator/=(const Vector& v) { return *this = *this / v; }
};

/// The vector that a swizzle gives. Anything else is itself.
template <class Value>
const Value& plain(const Value& v) {
    return v;
}
template <class T, int N, class Vector, int... Places>
Vector plain(const swizzle<T, N, Vector, Places...>& v) {
    return v;
}
template <class Value>
using plain_type = std::decay_t<decltype(plain(std::declval<const Value&>()))>;

// All names of the letters a, b, c and d, of which a vector has the first two, three or four. Each level adds a letter.
#define LAST2(a, b, n, ...)      \
    places<__VA_ARGS__, 0> n##a; \
    places<__VA_ARGS__, 1> n##b;
#define LAST3(a, b, c, n, ...) LAST2(a, b, n, __VA_ARGS__) places<__VA_ARGS__, 2> n##c;
#define LAST4(a, b, c, d, n, ...) LAST3(a, b, c, n, __VA_ARGS__) places<__VA_ARGS__, 3> n##d;

#define NEXT2(a, b, n, ...) \
    LAST2(a, b, n, __VA_ARGS__) LAST2(a, b, n##a, __VA_ARGS__, 0) LAST2(a, b, n##b, __VA_ARGS__, 1)
#define NEXT3(a, b, c, n, ...)     \
    LAST3(a, b, c, n, __VA_ARGS__) \
    LAST3(a, b, c, n##a, __VA_ARGS__, 0) LAST3(a, b, c, n##b, __VA_ARGS__, 1) LAST3(a, b, c, n##c, __VA_ARGS__, 2)
#define NEXT4(a, b, c, d, n, ...)           \
    LAST4(a, b, c, d, n, __VA_ARGS__)       \
    LAST4(a, b, c, d, n##a, __VA_ARGS__, 0) \
    LAST4(a, b, c, d, n##b, __VA_ARGS__, 1) \
    LAST4(a, b, c, d, n##c, __VA_ARGS__, 2) LAST4(a, b, c, d, n##d, __VA_ARGS__, 3)

#define FIRST2(a, b, n, i) LAST2(a, b, n, i) NEXT2(a, b, n##a, i, 0) NEXT2(a, b, n##b, i, 1)
#define FIRST3(a, b, c, n, i) \
    LAST3(a, b, c, n, i) NEXT3(a, b, c, n##a, i, 0) NEXT3(a, b, c, n##b, i, 1) NEXT3(a, b, c, n##c, i, 2)
#define FIRST4(a, b, c, d, n, i)  \
    LAST4(a, b, c, d, n, i)       \
    NEXT4(a, b, c, d, n##a, i, 0) \
    NEXT4(a, b, c, d, n##b, i, 1) NEXT4(a, b, c, d, n##c, i, 2) NEXT4(a, b, c, d, n##d, i, 3)

#define SWIZZLES2(a, b) FIRST2(a, b, a, 0) FIRST2(a, b, b, 1)
#define SWIZZLES3(a, b, c) FIRST3(a, b, c, a, 0) FIRST3(a, b, c, b, 1) FIRST3(a, b, c, c, 2)
#define SWIZZLES4(a, b, c, d) \
    FIRST4(a, b, c, d, a, 0) FIRST4(a, b, c, d, b, 1) FIRST4(a, b, c, d, c, 2) FIRST4(a, b, c, d, d, 3)

/// A vector's components under all their names.
template <class T, int N>
struct letters;

template <class T>
struct letters<T, 2> {
    template <int... Places>
    using places = swizzle<T, 2, vec<T, int(sizeof...(Places))>, Places...>;
    union {
        T of[2];
        struct {
            T x, y;
        };
        struct {
            T r, g;
        };
        SWIZZLES2(x, y)
        SWIZZLES2(r, g)
    };
};
template <class T>
struct letters<T, 3> {
    template <int... Places>
    using places = swizzle<T, 3, vec<T, int(sizeof...(Places))>, Places...>;
    union {
        T of[3];
        struct {
            T x, y, z;
        };
        struct {
            T r, g, b;
        };
        SWIZZLES3(x, y, z)
        SWIZZLES3(r, g, b)
    };
};
template <class T>
struct letters<T, 4> {
    template <int... Places>
    using places = swizzle<T, 4, vec<T, int(sizeof...(Places))>, Places...>;
    union {
        T of[4];
        struct {
            T x, y, z, w;
        };
        struct {
            T r, g, b, a;
        };
        SWIZZLES4(x, y, z, w)
        SWIZZLES4(r, g, b, a)
    };
};

}  // namespace metal
