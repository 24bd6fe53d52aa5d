// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <vector>

#include <umbrage/core/compare.hpp>

using namespace umbrage;

namespace {

template <class T>
std::vector<T> values() {
    const T infinity = std::numeric_limits<T>::infinity(), nan = std::numeric_limits<T>::quiet_NaN();
    const T least = std::numeric_limits<T>::denorm_min(), eps = std::numeric_limits<T>::epsilon();
    return {nan,
            -nan,
            -infinity,
            T(-2),
            T(-1),
            -least,
            T(-0.0),
            T(0),
            least,
            eps,
            T(0.25),
            T(0.5) - eps / 4,
            T(0.5),
            T(0.5) + eps / 2,
            T(1) - eps / 2,
            T(1),
            T(1) + eps,
            T(2),
            std::numeric_limits<T>::max(),
            infinity};
}

}  // namespace

TEST_CASE_TEMPLATE("compare: every pair of special values, ties lit, NaN in shadow", T, float, double) {
    int lit = 0, tried = 0;
    for (T receiver : values<T>())
        for (T stored : values<T>()) {
            CAPTURE(receiver);
            CAPTURE(stored);
            const bool ordered = !std::isnan(receiver) && !std::isnan(stored);
            CHECK(less_equal{}(receiver, stored) == (ordered && !(receiver > stored)));
            CHECK(greater_equal{}(receiver, stored) == (ordered && !(receiver < stored)));
            CHECK(compare(receiver, stored) == (ordered && !(receiver > stored) ? T(1) : T(0)));
            CHECK(compare(receiver, stored, greater_equal{}) == compare(-receiver, -stored));
            lit += less_equal{}(receiver, stored);
            ++tried;
        }
    // 18 numbers, of which -0 and 0 are one: 18 * 19 / 2 ordered pairs and one tie more
    CHECK(tried == 400);
    CHECK(lit == 172);
    static_assert(compare(T(0.5), T(0.5)) == 1 && compare(T(0.75), T(0.5)) == 0);
}

TEST_CASE_TEMPLATE("beyond_far_plane, within_far_plane: one of them of every number, none of NaN", T, float, double) {
    for (T receiver : values<T>()) {
        CAPTURE(receiver);
        const bool number = !std::isnan(receiver);
        CHECK(beyond_far_plane(receiver) == (number && std::isgreater(receiver, T(1))));
        CHECK(within_far_plane(receiver) == (number && std::islessequal(receiver, T(1))));
        CHECK(within_far_plane(receiver, greater_equal{}) == (number && std::isgreaterequal(receiver, T(0))));
        CHECK(within_far_plane(receiver, less_equal_scaled{}) == number);
    }
}

TEST_CASE_TEMPLATE("compare_dx_sdk, compare_exercise: the samples' tests by hand", T, float, double) {
    // stored + epsilon = 0.5: the first is lit at the limit, the second is not
    CHECK(compare_dx_sdk(T(0.25), T(0.375), T(0.125)) == 1);
    CHECK(compare_dx_sdk(T(0.5), T(0.375), T(0.125)) == 1);
    CHECK(compare_dx_sdk(T(0.625), T(0.375), T(0.125)) == 0);
    CHECK(compare_exercise(T(0.25), T(0.375), T(0.125)) == 1);
    CHECK(compare_exercise(T(0.5), T(0.375), T(0.125)) == 0);
    CHECK(compare_exercise(T(0.625), T(0.375), T(0.125)) == 0);
    CHECK(compare_exercise(T(0.375), T(0.375), T(0)) == 0);
    CHECK(compare_dx_sdk(T(0.375), T(0.375), T(0)) == 1);
}

TEST_CASE_TEMPLATE("compare_dx_sdk, compare_exercise: every triple of special values", T, float, double) {
    int wrong = 0, tried = 0, differ = 0;
    for (T receiver : values<T>())
        for (T stored : values<T>())
            for (T epsilon : values<T>()) {
                const T limit = stored + epsilon;  // may be NaN where neither was
                const bool ordered = !std::isnan(limit) && !std::isnan(receiver);
                const T dx = compare_dx_sdk(receiver, stored, epsilon),
                        exercise = compare_exercise(receiver, stored, epsilon);
                wrong += dx != (ordered && std::isgreater(receiver, limit) ? T(0) : T(1));
                wrong += exercise != (ordered && std::isless(receiver, limit) ? T(1) : T(0));
                if (epsilon == T(0)) wrong += ordered && dx != compare(receiver, stored);
                differ += dx != exercise;
                ++tried;
            }
    CHECK(tried == 8000);
    CHECK(wrong == 0);
    CHECK(differ > 0);  // on ties and NaN
}
