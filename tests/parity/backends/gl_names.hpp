// SPDX-License-Identifier: MIT
//
// OpenGL's names of the textures that entries read, and of the targets that they write.
#pragma once

#define GL_GLES_PROTOTYPES 0
#include <GLES3/gl3.h>

#include "../entry.hpp"
#include "../texture.hpp"

namespace parity {

struct gl_names {
    GLenum target, internal, format, type;
};

[[nodiscard]] inline gl_names names_of(const texture_image& t) {
    const GLenum targets[] = {GL_TEXTURE_2D, GL_TEXTURE_2D_ARRAY, GL_TEXTURE_CUBE_MAP};
    const gl_names formats[] = {{0, GL_RGBA32F, GL_RGBA, GL_FLOAT},
                                {0, GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT},
                                {0, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT},
                                {0, GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT},
                                {0, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE}};
    gl_names n = formats[t.format];
    n.target = targets[t.shape];
    return n;
}

[[nodiscard]] inline gl_names names_of(target to) {
    constexpr GLenum rgba16 = 0x805B;  // of desktop OpenGL
    constexpr gl_names all[]{{GL_TEXTURE_2D, GL_RGBA32F, GL_RGBA, GL_FLOAT},
                             {GL_TEXTURE_2D, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE},
                             {GL_TEXTURE_2D, GL_RGB10_A2, GL_RGBA, GL_UNSIGNED_INT_2_10_10_10_REV},
                             {GL_TEXTURE_2D, rgba16, GL_RGBA, GL_UNSIGNED_SHORT}};
    return all[static_cast<std::size_t>(to)];
}

}  // namespace parity
