// SPDX-License-Identifier: MIT
//
// Stand-in for your window, of the recipes of OpenGL: a context, the scene's mesh as attributes 0 to 2 (position,
// normal, uv), and a target for the picture.
#pragma once

#include <epoxy/gl.h>

#include <vector>

#include "../viewer/headless.hpp"
#include "scene.hpp"

class window {
public:
    explicit window(bool es2) : context_(es2) {
        const std::vector<scene::vertex> mesh = scene::make_mesh();
        vertices_ = GLsizei(mesh.size());
        GLuint names[3];
        if (!es2) glGenVertexArrays(1, names), glBindVertexArray(names[0]);
        glGenBuffers(1, names), glBindBuffer(GL_ARRAY_BUFFER, names[0]);
        glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(sizeof mesh[0] * mesh.size()), mesh.data(), GL_STATIC_DRAW);
        for (const GLuint i : {0u, 1u, 2u}) {
            const void* begin = reinterpret_cast<const void*>(12 * i);
            glEnableVertexAttribArray(i);
            glVertexAttribPointer(i, i < 2 ? 3 : 2, GL_FLOAT, GL_FALSE, sizeof mesh[0], begin);
        }
        glGenFramebuffers(1, &target_), glBindFramebuffer(GL_FRAMEBUFFER, target_);
        glGenRenderbuffers(2, names);
        for (const int i : {0, 1}) {
            const GLenum format = i == 0 ? (es2 ? GL_RGBA8_OES : GL_RGBA8) : GL_DEPTH_COMPONENT24;
            const glm::ivec2 size = scene::picture_size;
            glBindRenderbuffer(GL_RENDERBUFFER, names[i]);
            glRenderbufferStorage(GL_RENDERBUFFER, format, size.x, size.y);
            glFramebufferRenderbuffer(GL_FRAMEBUFFER, i == 0 ? GL_COLOR_ATTACHMENT0 : GL_DEPTH_ATTACHMENT,
                                      GL_RENDERBUFFER, names[i]);
        }
    }
    [[nodiscard]] GLsizei vertices() const { return vertices_; }

    /// Draws into the picture from here on.
    void bind() const {
        glBindFramebuffer(GL_FRAMEBUFFER, target_);
        glViewport(0, 0, scene::picture_size.x, scene::picture_size.y);
        glClearColor(scene::sky.r, scene::sky.g, scene::sky.b, 1);
    }
    void write_picture(const char* file) const {
        const glm::ivec2 size = scene::picture_size;
        std::vector<glm::u8vec4> pixels(std::size_t(size.x * size.y));
        glReadPixels(0, 0, size.x, size.y, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
        scene::write_picture(file, pixels, true);
    }

private:
    viewer::headless context_;
    GLsizei vertices_ = 0;
    GLuint target_ = 0;
};
