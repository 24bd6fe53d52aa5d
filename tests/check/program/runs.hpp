// SPDX-License-Identifier: MIT
//
// Investigates a text on one of the parity suite's implementations.
#pragma once

#include <stdexcept>
#include <string>

#include "backend.hpp"
#include "../values.hpp"
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

/// The text's function against a table. Its call is one of c, the arguments.
/// @throws cannot_run   as above
[[nodiscard]] value_verdict compare_values(const guest_text&, const value_table&, std::uint64_t allowed_ulps,
                                           parity::backend&);

}  // namespace check
