// SPDX-License-Identifier: MIT
//
// Investigates a text on one of the parity suite's implementations.
#pragma once

#include <stdexcept>
#include <string>

#include "backend.hpp"
#include "guest_text.hpp"

namespace check {

/// What the user can mend: options, a text that does not compile, an implementation that is not here.
struct cannot_run : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Implementations of a language.
/// @param on   a name of --on, or empty: software that is the same everywhere
[[nodiscard]] parity::backends implementations(parity::dialect, const std::string& on);

/// @throws cannot_run   with the compiler's words and the file's lines
[[nodiscard]] verdict investigate(const guest_text&, const expectation&, parity::backend&);

}  // namespace check
