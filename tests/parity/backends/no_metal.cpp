// SPDX-License-Identifier: MIT
//
// Without clang there is no compiler for Metal.
#include "../backend.hpp"

parity::backends parity::metal_backends() { return {}; }
