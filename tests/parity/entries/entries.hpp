// SPDX-License-Identifier: MIT
//
// The families of entries. A new family is one function here, one file beside it, one line in all.cpp.
#pragma once

#include "../values.hpp"

namespace parity {

void add_scalar(std::vector<entry>& all);

}  // namespace parity
