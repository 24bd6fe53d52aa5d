// SPDX-License-Identifier: MIT
//
// Metal's vectors and matrices as C++. They have Metal's rules, unlike GLM's: swizzles are operands like others,
// scalars act as vectors, and a comparison of vectors compares components.
#pragma once

#include "swizzles.hpp"

namespace metal {

template <class Value>
inline constexpr int components = 1;
template <class T, int N>
inline constexpr int components<vec<T, N>> = N;

template <class T, int N>
struct vec : letters<T, N> {
    using letters<T, N>::of;

    vec() = default;
    vec(const vec&) = default;
    vec(T all) {
        for (T& each : of) each = all;
    }
    /// Of scalars and vectors that have N components together, or of another type's vector.
    template <class... Parts>
    requires((components<plain_type<Parts>> + ...) == N) explicit(sizeof...(Parts) == 1) vec(const Parts&... parts) {
        int i = 0;
        (put(i, plain(parts)), ...);
    }
    vec& operator=(const vec& v) {
        for (int i = 0; i < N; ++i) of[i] = v.of[i];
        return *this;
    }

    T& operator[](int i) { return of[i]; }
    const T& operator[](int i) const { return of[i]; }

    vec& operator+=(const vec& v) { return *this = *this + v; }
    vec& operator-=(const vec& v) { return *this = *this - v; }
    vec& operator*=(const vec& v) { return *this = *this * v; }
    vec& operator/=(const vec& v) { return *this = *this / v; }

// Not templates, so that swizzles and scalars become vectors.
#define BINARY(Result, op)                                          \
    friend vec<Result, N> operator op(const vec& a, const vec& b) { \
        vec<Result, N> all;                                         \
        for (int i = 0; i < N; ++i) all[i] = a[i] op b[i];          \
        return all;                                                 \
    }
    BINARY(T, +)
    BINARY(T, -)
    BINARY(T, *)
    BINARY(T, /)
    BINARY(T, %)
    BINARY(T, &)
    BINARY(T, |)
    BINARY(T, ^)
    BINARY(T, <<)
    BINARY(T, >>)
    BINARY(bool, <)
    BINARY(bool, <=)
    BINARY(bool, >)
    BINARY(bool, >=)
    BINARY(bool, ==)
    BINARY(bool, !=)
    BINARY(bool, &&)
    BINARY(bool, ||)
#undef BINARY
#define UNARY(Result, op)                             \
    friend vec<Result, N> operator op(const vec& v) { \
        vec<Result, N> all;                           \
        for (int i = 0; i < N; ++i) all[i] = op v[i]; \
        return all;                                   \
    }
    UNARY(T, -)
    UNARY(T, ~)
    UNARY(bool, !)
#undef UNARY

private:
    template <class Part>
    void put(int& i, const Part& part) {
        if constexpr (components<Part> == 1) of[i++] = T(part);
        else
            for (int k = 0; k < components<Part>; ++k) of[i++] = T(part[k]);
    }
};

/// Of columns.
template <class T, int Columns, int Rows>
struct matrix {
    using column = vec<T, Rows>;
    using row = vec<T, Columns>;
    column columns[Columns];

    matrix() = default;
    explicit matrix(T diagonal) {
        for (int i = 0; i < Columns; ++i) columns[i] = column(T(0)), columns[i][i] = diagonal;
    }
    template <class... Vectors>
    requires(sizeof...(Vectors) == Columns) matrix(const Vectors&... all) : columns{column(all)...} {}

    column& operator[](int i) { return columns[i]; }
    const column& operator[](int i) const { return columns[i]; }

    friend column operator*(const matrix& m, const row& v) {
        column all(T(0));
        for (int i = 0; i < Columns; ++i) all += m[i] * v[i];
        return all;
    }
    friend row operator*(const column& v, const matrix& m) {
        row all;
        for (int i = 0; i < Columns; ++i) all[i] = dot(v, m[i]);
        return all;
    }
    template <int Others>
    friend matrix<T, Others, Rows> operator*(const matrix& a, const matrix<T, Others, Columns>& b) {
        matrix<T, Others, Rows> all;
        for (int i = 0; i < Others; ++i) all[i] = a * b[i];
        return all;
    }
};

}  // namespace metal

using uint = unsigned;
using float2 = metal::vec<float, 2>;
using float3 = metal::vec<float, 3>;
using float4 = metal::vec<float, 4>;
using int2 = metal::vec<int, 2>;
using int3 = metal::vec<int, 3>;
using int4 = metal::vec<int, 4>;
using uint2 = metal::vec<uint, 2>;
using uint3 = metal::vec<uint, 3>;
using uint4 = metal::vec<uint, 4>;
using bool2 = metal::vec<bool, 2>;
using bool3 = metal::vec<bool, 3>;
using bool4 = metal::vec<bool, 4>;

namespace metal {

using float2x2 = matrix<float, 2, 2>;
using float3x3 = matrix<float, 3, 3>;
using float4x4 = matrix<float, 4, 4>;

}  // namespace metal
