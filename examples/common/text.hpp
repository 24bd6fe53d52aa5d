// SPDX-License-Identifier: MIT
//
// Numbers in words: printf into a string of less than 400 letters.
//
//     const std::string line = example::text("RMS error %.1f %%", error);
//
#pragma once

#include <array>
#include <cstdio>
#include <string>

namespace example {

template <class... Values>
[[nodiscard]] std::string text(const char* format, Values... values) {
    std::array<char, 400> out{};
    std::snprintf(out.data(), out.size(), format, values...);
    return out.data();
}

}  // namespace example
