// SPDX-License-Identifier: MIT
//
// What runs shaders of a language here, and what to install where nothing does.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>

#include "backend.hpp"
#include "metal.hpp"

namespace check {

/// What the user can mend: options, a text that does not compile, an implementation that is not here.
struct cannot_run : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// What compiles Metal here: clang++, or g++ where that is missing.
/// @param on            one of them by name, or empty
/// @throws cannot_run   what is missing, and what to do
[[nodiscard]] metal_files metal_here(const std::string& on = {});

/// @param on            one of the language's implementations, by name, or empty: its first, which is software
/// @throws cannot_run   what is missing, and what to do
[[nodiscard]] std::unique_ptr<parity::backend> implementation(parity::dialect, const std::string& on = {});

}  // namespace check
