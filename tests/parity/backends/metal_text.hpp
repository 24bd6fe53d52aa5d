// SPDX-License-Identifier: MIT
//
// The snippets' Metal, compiled as C++ by clang: what its functions and whoever calls them agree on. Plain data, as the
// two may have different standard libraries.
#pragma once

#include <cstddef>

#include <glm/vec4.hpp>

namespace parity::metal_text {

/// Content of a texture or a sampler, with texels as from filled_texture::bytes().
struct memory {
    const void* texels = nullptr;
    unsigned width = 0, height = 0;
    int compare = 0;  ///< one of texture_image::comparisons
    bool linear = false;
};

/// An entry's call, in the order of entries(); x[i] is xi, units[i] what is bound there.
using function = glm::vec4 (*)(const glm::vec4* x, const memory* units);
extern const function functions[];

/// Calls of a few entries as a printer would give them that wrote something else for `from`; a null call ends them.
struct mistaken {
    const char* from;
    std::size_t entry;
    function call;
};
extern const mistaken mistakes[];

}  // namespace parity::metal_text
