// SPDX-License-Identifier: MIT
//
// The families of entries. A new family is one function here, one file beside it, one line in all.cpp.
#pragma once

#include "../values.hpp"

namespace parity {

void add_scalar(std::vector<entry>& all);
void add_depth_kinds(std::vector<entry>& all);
void add_depth_rg(std::vector<entry>& all);
void add_depth_rgba(std::vector<entry>& all);
void add_depth_foreign(std::vector<entry>& all);
void add_light(std::vector<entry>& all);
void add_fetch(std::vector<entry>& all);
void add_filter(std::vector<entry>& all);
void add_shade(std::vector<entry>& all);

}  // namespace parity
