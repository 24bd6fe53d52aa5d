// SPDX-License-Identifier: MIT
//
// OpenGL's objects, as few as the viewer needs: they go away by themselves. The same calls serve 3.3 core and ES 2.
//
//     viewer::program p(viewer::depth_stages(...));
//     p.use().set("bias", 0.5f);
//
#pragma once

#include <cstddef>
#include <string>
#include <utility>

#include <epoxy/gl.h>

#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "programs.hpp"

namespace viewer {

/// The same picture for OpenGL, whose z/w runs from -1 to 1.
[[nodiscard]] inline glm::mat4 opengl(glm::mat4 m) {
    for (int column = 0; column < 4; ++column) m[column][2] = 2 * m[column][2] - m[column][3];
    return m;
}

/// Owns a name that OpenGL gave.
template <class Kind>
class handle {
public:
    handle() : id_(Kind::make()) {}
    handle(handle&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
    handle& operator=(handle&& other) noexcept {
        std::swap(id_, other.id_);
        return *this;
    }
    ~handle() {
        if (id_) Kind::drop(id_);
    }
    operator GLuint() const { return id_; }

private:
    GLuint id_;
};

struct buffer_kind {
    static GLuint make() {
        GLuint id = 0;
        glGenBuffers(1, &id);
        return id;
    }
    static void drop(GLuint id) { glDeleteBuffers(1, &id); }
};
struct texture_kind {
    static GLuint make() {
        GLuint id = 0;
        glGenTextures(1, &id);
        return id;
    }
    static void drop(GLuint id) { glDeleteTextures(1, &id); }
};
struct renderbuffer_kind {
    static GLuint make() {
        GLuint id = 0;
        glGenRenderbuffers(1, &id);
        return id;
    }
    static void drop(GLuint id) { glDeleteRenderbuffers(1, &id); }
};
struct framebuffer_kind {
    static GLuint make() {
        GLuint id = 0;
        glGenFramebuffers(1, &id);
        return id;
    }
    static void drop(GLuint id) { glDeleteFramebuffers(1, &id); }
};
struct program_kind {
    static GLuint make() { return glCreateProgram(); }
    static void drop(GLuint id) { glDeleteProgram(id); }
};

/// Which dialect the current context speaks.
[[nodiscard]] umbrage::glsl::version dialect();

/// After a context was made current: what 3.3 core asks for before anything can be drawn.
void prepare_context();

/// Attributes have their places by name.
enum attribute : GLuint { position, normal, face_normal, color, corner };

/// Floats of the bound buffer, `offset` bytes into each of its elements.
void attribute_at(GLuint place, GLint size, std::size_t stride, std::size_t offset);

class program {
public:
    /// @throws std::runtime_error  it does not compile or link: the log, and the text
    explicit program(stages text);

    [[nodiscard]] const stages& text() const { return text_; }
    const program& use() const {
        glUseProgram(id_);
        return *this;
    }

    // A uniform that the program does not use is no fault.
    const program& set(const char* name, int v) const {
        glUniform1i(at(name), v);
        return *this;
    }
    const program& set(const char* name, float v) const {
        glUniform1f(at(name), v);
        return *this;
    }
    const program& set(const char* name, glm::vec2 v) const {
        glUniform2f(at(name), v.x, v.y);
        return *this;
    }
    const program& set(const char* name, glm::vec3 v) const {
        glUniform3f(at(name), v.x, v.y, v.z);
        return *this;
    }
    const program& set(const char* name, glm::vec4 v) const {
        glUniform4f(at(name), v.x, v.y, v.z, v.w);
        return *this;
    }
    const program& set(const char* name, const glm::mat4& m, int count = 1) const {
        glUniformMatrix4fv(at(name), count, GL_FALSE, glm::value_ptr(m));
        return *this;
    }

private:
    [[nodiscard]] GLint at(const char* name) const { return glGetUniformLocation(id_, name); }

    handle<program_kind> id_;
    stages text_;
};

/// Four channels of 8 bits, three of ten and alpha, four of 16; one float, four floats.
enum class texels_of { bytes, tens, shorts, depth, moments };

/// Texels to draw into, with a depth buffer, and to read from.
struct target {
    glm::ivec2 size;
    texels_of kind;
    handle<texture_kind> texels{};
    handle<renderbuffer_kind> depth{};
    handle<framebuffer_kind> framebuffer{};

    /// @throws std::runtime_error  OpenGL has no such target here
    target(glm::ivec2 size_, texels_of kind_);
};

/// A texture of bytes, nearest texel.
[[nodiscard]] handle<texture_kind> make_table(glm::ivec2 size, const void* rgba);

/// Four integers of 16 bits a texel, for the bound texture, nearest texel.
void upload_integers(glm::ivec2 size, const void* rgba);

/// @throws std::runtime_error  OpenGL reports an error
void check_errors(const char* after);

}  // namespace viewer
