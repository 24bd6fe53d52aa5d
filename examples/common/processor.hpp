// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace example {

/// What this machine's processor is called, where the system tells. Virtual machines call different ones by the same
/// name: family and model tell them apart.
[[nodiscard]] std::string processor();

}  // namespace example
