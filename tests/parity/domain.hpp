// SPDX-License-Identifier: MIT
//
// Entries some of whose inputs lie outside what their function promises.
#pragma once

#include "entry.hpp"

namespace parity {

/// True when tier A promises nothing for some inputs: channels that no texture gives, or points that are no integers.
/// tier_a.cpp of the hostile programs has inputs within the promise.
[[nodiscard]] inline bool leaves_domain(const entry& e) { return e.name() == "decode_rgb24" || e.name() == "disc_tap"; }

}  // namespace parity
