// SPDX-License-Identifier: MIT
//
// For machines without Vulkan or its compiler.
#include "../backend.hpp"

parity::backends parity::vulkan_backends(std::string_view) { return {}; }
parity::backends parity::naga_backends(const naga_files&) { return {}; }
