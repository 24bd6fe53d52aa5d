// SPDX-License-Identifier: MIT
//
// Text around a call of somebody's function, in each language.
#pragma once

#include <string>

#include "guest_text.hpp"

namespace check {

/// True if such a function takes a map.
[[nodiscard]] bool reads_map(subject);

/// The function whose result is that of the shader. Its names are those that a call is written with.
[[nodiscard]] std::string wrapper(const guest_text&);

/// What makes a compiler of C++ count lines again from 1, in a file of this name. Other languages have no such words.
[[nodiscard]] std::string begins(const guest_text&, const std::string& name);

}  // namespace check
