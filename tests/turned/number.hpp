// SPDX-License-Identifier: MIT
//
// Numbers and enumerators of a program, each of which may be another one while the program runs.
#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <exception>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <type_traits>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "enumerations.hpp"

namespace turned {

/// What becomes of a number or, by its name, of an enumerator. A rebuilt program is changed while it is written.
enum class turn { none, twice, half, thousandth, zero, negative, nan, rebuilt, value };
inline constexpr std::array<std::string_view, 7> turn_names{"as it is", "twice",    "half", "a thousandth",
                                                            "zero",     "negative", "NaN"};

/// The number or enumerator that changes in this run.
struct change {
    int place = -1;
    turn what = turn::none;
    std::string_view value{};  ///< that an enumerator becomes
};
inline change chosen;
inline bool is_running = false;  ///< a program is: its numbers outside of functions would not change

/// The change means nothing here: an integer cannot be NaN, and a number may turn into itself.
struct no_change : std::exception {
    [[nodiscard]] const char* what() const noexcept override { return "no change"; }
};

[[nodiscard]] inline double turned(double value) {
    switch (chosen.what) {
        case turn::twice: return 2 * value;
        case turn::half: return value / 2;
        case turn::thousandth: return value / 1000;
        case turn::zero: return 0;
        case turn::negative: return -value;
        case turn::nan: return std::nan("");
        default: return value;
    }
}

/// An integer of a program's text. It becomes what its place takes: of 1, half is 0.5 for a float and 0 for an int.
class integer {
public:
    explicit integer(double value, bool is_turned = false, long long before = 0)
        : value_(value), before_(before), is_turned_(is_turned) {}

    template <class T>
    requires std::is_arithmetic_v<T>
    operator T() const {
        if constexpr (std::is_floating_point_v<T>) return static_cast<T>(value_);
        else {
            if (std::isnan(value_)) throw no_change();
            const auto whole = static_cast<long long>(value_);
            if (is_turned_ && whole == before_) throw no_change();
            return static_cast<T>(whole);
        }
    }
    integer operator-() const { return integer(-value_, is_turned_, -before_); }

private:
    double value_;
    long long before_;
    bool is_turned_;
};

template <class T>
concept plain = std::is_arithmetic_v<T>;
template <class T>
using with_int = std::common_type_t<int, T>;

// As an int among numbers of other types.
#define TURNED_OPERATOR(op)                                                    \
    template <plain T>                                                         \
    auto operator op(integer a, T b) {                                         \
        return static_cast<with_int<T>>(a) op b;                               \
    }                                                                          \
    template <plain T>                                                         \
    auto operator op(T a, integer b) {                                         \
        return a op static_cast<with_int<T>>(b);                               \
    }                                                                          \
    inline auto operator op(integer a, integer b) { return int(a) op int(b); } \
    template <glm::length_t N, class T>                                        \
    auto operator op(const glm::vec<N, T>& a, integer b) {                     \
        return a op static_cast<T>(b);                                         \
    }                                                                          \
    template <glm::length_t N, class T>                                        \
    auto operator op(integer a, const glm::vec<N, T>& b) {                     \
        return static_cast<T>(a) op b;                                         \
    }
TURNED_OPERATOR(+)
TURNED_OPERATOR(-)
TURNED_OPERATOR(*)
TURNED_OPERATOR(<)
TURNED_OPERATOR(>)
TURNED_OPERATOR(==)
#undef TURNED_OPERATOR

/// An integer that another is divided by. A division by zero is the program's own error, and no answer of the library.
template <plain T>
[[nodiscard]] T divisor(integer b) {
    const auto own = static_cast<T>(b);
    if (std::is_integral_v<T> && own == T(0)) throw no_change();
    return own;
}
template <plain T>
auto operator/(integer a, T b) {
    return static_cast<with_int<T>>(a) / b;
}
template <plain T>
auto operator/(T a, integer b) {
    return a / divisor<with_int<T>>(b);
}
inline auto operator/(integer a, integer b) { return int(a) / divisor<int>(b); }
template <glm::length_t N, class T>
auto operator/(const glm::vec<N, T>& a, integer b) {
    return a / divisor<T>(b);
}
inline auto operator%(int a, integer b) { return a % divisor<int>(b); }
template <plain T>
T& operator+=(T& a, integer b) {
    return a = static_cast<T>(a + b);
}

/// The enumerator, or the clip space, at a place of a program.
template <class T>
[[nodiscard]] T enumerator(int place, const T& value) {
    if (!is_running) throw std::logic_error("an enumerator outside of functions, which no run changes");
    if (place != chosen.place || chosen.what == turn::none) return value;
    for (const auto& other : named_values(value))
        if (other.name == chosen.value) return other.value == value ? throw no_change() : other.value;
    throw std::logic_error("no value of this enumeration");
}

/// The number at a place of a program.
template <std::floating_point T>
[[nodiscard]] T number(int place, T value) {
    if (!is_running) throw std::logic_error("a number outside of functions, which no run changes");
    if (place != chosen.place) return value;
    const auto now = static_cast<T>(turned(double(value)));
    return now == value ? throw no_change() : now;
}
[[nodiscard]] inline integer number(int place, int value) {
    if (!is_running) throw std::logic_error("a number outside of functions, which no run changes");
    if (place != chosen.place) return integer(value);
    const double now = turned(value);
    return now == value ? throw no_change() : integer(now, true, value);
}

}  // namespace turned

/// GLM's matrices take numbers that have limits.
template <>
struct std::numeric_limits<turned::integer> : std::numeric_limits<int> {};
