// SPDX-License-Identifier: MIT
//
// What the library's encodings and filters are called, in the order of its lists.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace example {

[[nodiscard]] const std::vector<std::string>& encoding_names();
[[nodiscard]] const std::vector<std::string>& filter_names();

/// Reach of a filter by its name, as its default has it.
[[nodiscard]] float reach_of(std::string_view filter);

}  // namespace example
