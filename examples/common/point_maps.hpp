// SPDX-License-Identifier: MIT
//
// The maps of a point light that stands where the spot does: a cube, two paraboloids, a tetrahedron, all of about as
// many texels.
#pragma once

#include <vector>

#include "setups.hpp"

namespace example {

[[nodiscard]] std::vector<setup> point_setups();

}  // namespace example
