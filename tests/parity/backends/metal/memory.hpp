// SPDX-License-Identifier: MIT
//
// Content of a texture or a sampler, for Metal that runs as C++. Plain data: its two sides may be compiled apart.
#pragma once

namespace parity::metal_text {

struct memory {
    const void* texels = nullptr;  ///< as from filled_texture::bytes()
    unsigned width = 0, height = 0;
    int compare = 0;  ///< one of texture_image::comparisons
    bool linear = false;
};

}  // namespace parity::metal_text
