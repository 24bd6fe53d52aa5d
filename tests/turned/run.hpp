// SPDX-License-Identifier: MIT
//
// A run of a program with one number changed, in a process of its own.
#pragma once

#include <cstddef>
#include <string>

#include "program.hpp"

namespace turned {

enum class ending { right, refused, no_change, wrong };

struct outcome {
    ending how;
    std::size_t lit = 0, dark = 0, decided = 0;
    std::string message{};  ///< the refusal, or what is wrong
};

[[nodiscard]] outcome run(const program& p, change c);

}  // namespace turned
