// SPDX-License-Identifier: MIT
//
// Whole shaders around an entry's call, in any dialect.
//
// Inputs come as RGBA32F textures x0_texels .. x5_texels, one texel per pixel; `map` and `table` are textures too.
// A triangle (-1,-1), (3,-1), (-1,3) in the attribute `corner` (location 0) covers the target.
// Where there are bindings, in Vulkan: x0 .. x5 are 0 .. 5, map 6, table 7. Before 1.30, map_size is a uniform.
#pragma once

#include "entry.hpp"

namespace parity {

struct shader {
    std::string vertex, fragment;
};

[[nodiscard]] shader make_shader(const entry& e, dialect d);

/// Samplers of an entry in order of their bindings, empty where unused.
[[nodiscard]] std::array<std::string, max_inputs + 2> samplers(const entry& e);

}  // namespace parity
