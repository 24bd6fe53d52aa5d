// SPDX-License-Identifier: MIT
//
// The snippets' Metal, compiled as C++ by clang: what its functions and whoever calls them agree on. Plain data, as the
// two may have different standard libraries.
#pragma once

#include <cstddef>

#include "metal/memory.hpp"

namespace parity::metal_text {

/// An entry's call, in the order of entries(); x[i] is xi, units[i] what is bound there. It sets four floats.
using function = void (*)(const float (*x)[4], const memory* units, float* result);
extern const function functions[];

/// Calls of a few entries as a printer would give them that wrote something else for `from`; a null call ends them.
struct mistaken {
    const char* from;
    std::size_t entry;
    function call;
};
extern const mistaken mistakes[];

}  // namespace parity::metal_text
