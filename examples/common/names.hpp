// SPDX-License-Identifier: MIT
//
// What the library's encodings and filters are called, in the order of its lists.
#pragma once

#include <string>
#include <vector>

namespace example {

[[nodiscard]] const std::vector<std::string>& encoding_names();
[[nodiscard]] const std::vector<std::string>& filter_names();

}  // namespace example
