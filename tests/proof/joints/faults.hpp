// SPDX-License-Identifier: MIT
//
// Faults that programs have where two parts of a shadow join, and a run that shows each of them by wrong receivers.
#pragma once

#include <cstdint>

namespace joints {

/// Plants each fault into draws of the seeds from 0 on, until a receiver is wrong that was right before.
/// @param draws   of each fault, at most
/// @return        true when each fault was seen
[[nodiscard]] bool plant_faults(std::uint64_t draws);

}  // namespace joints
