// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace example {

/// Name of this machine's processor, if the system gives one. Virtual machines give different processors the same name;
/// family and model distinguish them.
[[nodiscard]] std::string processor();

}  // namespace example
