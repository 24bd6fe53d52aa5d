// SPDX-License-Identifier: MIT
//
// How set-up functions refuse bad input.
//
//     detail::require(map_size >= 1, "make_cascades", "map_size", "must be above 0", map_size);
//
#pragma once

#include <cstdio>
#include <string>

#include <umbrage/core/config.hpp>

namespace umbrage::detail {

/// Reports an argument of a set-up function, or several, unless what they need is met.
inline void require(bool met, const char* function, const char* arguments, const char* problem) {
    if (met) return;
    std::string message = "umbrage::";  // appended to: of sums GCC 12 believes at times that they overrun
    for (const char* part : {function, ": ", arguments, " ", problem}) message += part;
    fail(message);
}

/// The same, and the number that was given.
inline void require(bool met, const char* function, const char* argument, const char* condition, double got) {
    if (met) return;
    char problem[128];
    std::snprintf(problem, sizeof problem, "%s; got %g", condition, got);
    require(false, function, argument, problem);
}

}  // namespace umbrage::detail
