// SPDX-License-Identifier: MIT
//
// The maps of a point light that stands where the spot does: a cube, two paraboloids, a tetrahedron, all of about as
// many texels.
#pragma once

#include <vector>

#include "set_ups.hpp"

namespace example {

[[nodiscard]] std::vector<set_up> point_set_ups();

}  // namespace example
