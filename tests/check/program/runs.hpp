// SPDX-License-Identifier: MIT
//
// Investigates a text on one of the parity suite's implementations.
#pragma once

#include "../values.hpp"
#include "guest_text.hpp"
#include "implementation.hpp"

namespace check {

/// @throws cannot_run   with the compiler's words and the file's lines
[[nodiscard]] verdict investigate(const guest_text&, const expectation&, parity::backend&);

/// The text's function against a table. Its call is one of c, the arguments.
/// @throws cannot_run   as above
[[nodiscard]] value_verdict compare_values(const guest_text&, const value_table&, std::uint64_t allowed_ulps,
                                           parity::backend&);

}  // namespace check
