// SPDX-License-Identifier: MIT
//
// For machines without the text back end.
#include "backend.hpp"

parity::backends parity::cpp_backends() { return {}; }
