// SPDX-License-Identifier: MIT
#include "gl.hpp"

#include <stdexcept>
#include <utility>

namespace viewer {
namespace {

handle<program_kind> linked(const stages& text) {
    handle<program_kind> id;
    GLint good = GL_TRUE;
    char log[4096] = "";
    const std::pair<GLenum, const std::string*> both[] = {{GL_VERTEX_SHADER, &text.vertex},
                                                          {GL_FRAGMENT_SHADER, &text.fragment}};
    for (const auto& [kind, source] : both) {
        const GLuint shader = glCreateShader(kind);
        const char* characters = source->c_str();
        glShaderSource(shader, 1, &characters, nullptr);
        glCompileShader(shader);
        glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
        if (good != GL_TRUE) glGetShaderInfoLog(shader, sizeof log, nullptr, log);
        glAttachShader(id, shader);
        glDeleteShader(shader);  // goes with the program
        if (good != GL_TRUE)
            throw std::runtime_error("a shader does not compile: " + std::string(log) + '\n' + *source);
    }
    glBindAttribLocation(id, position, "position");
    glBindAttribLocation(id, normal, "normal");
    glBindAttribLocation(id, face_normal, "face_normal");
    glBindAttribLocation(id, color, "color");
    glBindAttribLocation(id, corner, "corner");
    glLinkProgram(id);
    glGetProgramiv(id, GL_LINK_STATUS, &good);
    if (good != GL_TRUE) {
        glGetProgramInfoLog(id, sizeof log, nullptr, log);
        throw std::runtime_error("a program does not link: " + std::string(log));
    }
    return id;
}

void nearest_texel() {
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

}  // namespace

umbrage::glsl::version dialect() {
    return epoxy_is_desktop_gl() ? umbrage::glsl::version::v330 : umbrage::glsl::version::v100;
}

void prepare_context() {
    glDisable(GL_DITHER);  // on by default, would change the map's bytes
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    if (!epoxy_is_desktop_gl()) return;
    GLuint array = 0;  // lives as long as the context
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
}

void attribute_at(GLuint place, GLint size, std::size_t stride, std::size_t offset) {
    glEnableVertexAttribArray(place);
    glVertexAttribPointer(place, size, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                          reinterpret_cast<const void*>(offset));
}

program::program(stages text) : id_(linked(text)), text_(std::move(text)) {}

target::target(glm::ivec2 size_, texels_of kind_) : size(size_), kind(kind_) {
    glBindTexture(GL_TEXTURE_2D, texels);
    nearest_texel();
    struct names {
        int internal;
        GLenum channels, type;
    };
    const names formats[]{{epoxy_is_desktop_gl() ? GL_RGBA8 : GL_RGBA, GL_RGBA, GL_UNSIGNED_BYTE},
                          {GL_RGB10_A2, GL_RGBA, GL_UNSIGNED_INT_2_10_10_10_REV},
                          {GL_RGBA16, GL_RGBA, GL_UNSIGNED_SHORT},
                          {GL_R32F, GL_RED, GL_FLOAT},
                          {GL_RGBA32F, GL_RGBA, GL_FLOAT}};
    const names& format = formats[static_cast<std::size_t>(kind)];
    glTexImage2D(GL_TEXTURE_2D, 0, format.internal, size.x, size.y, 0, format.channels, format.type, nullptr);
    const bool deep = epoxy_is_desktop_gl() || epoxy_has_gl_extension("GL_OES_depth24");
    glBindRenderbuffer(GL_RENDERBUFFER, depth);
    glRenderbufferStorage(GL_RENDERBUFFER, deep ? GL_DEPTH_COMPONENT24 : GL_DEPTH_COMPONENT16, size.x, size.y);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texels, 0);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw std::runtime_error("OpenGL cannot draw into " + std::to_string(size.x) + " x " + std::to_string(size.y) +
                                 (format.type == GL_FLOAT ? " texels of floats here" : " texels here"));
}

handle<texture_kind> make_table(glm::ivec2 size, const void* rgba) {
    handle<texture_kind> texture;
    glBindTexture(GL_TEXTURE_2D, texture);
    nearest_texel();
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, size.x, size.y, 0, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
    return texture;
}

void upload_integers(glm::ivec2 size, const void* rgba) {
    nearest_texel();
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA16UI, size.x, size.y, 0, GL_RGBA_INTEGER, GL_UNSIGNED_SHORT, rgba);
}

void check_errors(const char* after) {
    if (const GLenum error = glGetError())
        throw std::runtime_error("OpenGL error " + std::to_string(error) + " after " + after);
}

}  // namespace viewer
