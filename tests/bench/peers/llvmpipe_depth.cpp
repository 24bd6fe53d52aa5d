// SPDX-License-Identifier: MIT
#include "depth_pass.hpp"

#include <cstdlib>
#include <stdexcept>
#include <string_view>

#define GL_GLEXT_PROTOTYPES
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
#include <GL/glext.h>

namespace peers {
namespace {

// One context for the process, current while one of these lives: another peer has a context of its own.
class context {
public:
    context() : before_(eglGetCurrentContext()) {
        // Mesa reads these when it starts.
        setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
        setenv("GALLIUM_DRIVER", "llvmpipe", 1);
        setenv("LP_NUM_THREADS", "0", 1);
        eglBindAPI(EGL_OPENGL_API);
        static const EGLDisplay display = [] {
            const auto d = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
            if (eglInitialize(d, nullptr, nullptr) != EGL_TRUE) throw std::runtime_error("EGL does not start");
            return d;
        }();
        static const EGLContext ours = [] {
            const EGLint wish[] = {EGL_CONTEXT_MAJOR_VERSION, 4, EGL_CONTEXT_MINOR_VERSION, 5, EGL_NONE};
            return eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wish);
        }();
        display_ = display;
        if (eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, ours) != EGL_TRUE)
            throw std::runtime_error("no OpenGL 4.5 without a window");
        const auto* renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
        if (!std::string_view(renderer).starts_with("llvmpipe")) throw std::runtime_error("not llvmpipe");
    }
    ~context() { eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, before_); }
    context(const context&) = delete;
    context& operator=(const context&) = delete;

private:
    EGLContext before_;
    EGLDisplay display_;
};

GLuint compile(GLenum stage, const char* source) {
    const GLuint shader = glCreateShader(stage);
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    return shader;
}

}  // namespace

struct llvmpipe_pass::state {
    glm::ivec2 size;
    GLsizei indices;
    GLuint texture, framebuffer, array, buffers[2], program;
};

llvmpipe_pass::llvmpipe_pass(glm::ivec2 size, std::span<const glm::vec3> positions,
                             std::span<const glm::uvec3> triangles, const glm::mat4& world_to_clip) {
    const context current;
    state_ = std::make_unique<state>();
    state& s = *state_;
    s.size = size;
    s.indices = static_cast<GLsizei>(3 * triangles.size());

    glGenTextures(1, &s.texture);
    glBindTexture(GL_TEXTURE_2D, s.texture);
    glTexStorage2D(GL_TEXTURE_2D, 1, GL_DEPTH_COMPONENT32F, size.x, size.y);
    glGenFramebuffers(1, &s.framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, s.framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, s.texture, 0);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) throw std::runtime_error("framebuffer");

    glGenVertexArrays(1, &s.array);
    glBindVertexArray(s.array);
    glGenBuffers(2, s.buffers);
    glBindBuffer(GL_ARRAY_BUFFER, s.buffers[0]);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(positions.size_bytes()), positions.data(), GL_STATIC_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, s.buffers[1]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(triangles.size_bytes()), triangles.data(),
                 GL_STATIC_DRAW);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);

    s.program = glCreateProgram();
    glAttachShader(s.program, compile(GL_VERTEX_SHADER, R"(#version 450
        layout(location = 0) in vec3 position;
        layout(location = 0) uniform mat4 world_to_clip;
        void main() { gl_Position = world_to_clip * vec4(position, 1.0); })"));
    glAttachShader(s.program, compile(GL_FRAGMENT_SHADER, "#version 450\nvoid main() {}"));
    glLinkProgram(s.program);
    GLint linked = 0;
    glGetProgramiv(s.program, GL_LINK_STATUS, &linked);
    if (!linked) throw std::runtime_error("the shaders do not link");
    glProgramUniformMatrix4fv(s.program, 0, 1, GL_FALSE, &world_to_clip[0][0]);
    glFinish();
}

llvmpipe_pass::~llvmpipe_pass() {
    const context current;
    glDeleteProgram(state_->program);
    glDeleteBuffers(2, state_->buffers);
    glDeleteVertexArrays(1, &state_->array);
    glDeleteFramebuffers(1, &state_->framebuffer);
    glDeleteTextures(1, &state_->texture);
}

void llvmpipe_pass::clear_and_draw() const {
    const context current;
    glBindFramebuffer(GL_FRAMEBUFFER, state_->framebuffer);
    glClearDepth(1.0);
    glClear(GL_DEPTH_BUFFER_BIT);
    glBindVertexArray(state_->array);
    glUseProgram(state_->program);
    glViewport(0, 0, state_->size.x, state_->size.y);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glDrawElements(GL_TRIANGLES, state_->indices, GL_UNSIGNED_INT, nullptr);
    glFinish();
}

std::vector<float> llvmpipe_pass::read() const {
    const context current;
    std::vector<float> depth(std::size_t(state_->size.x) * std::size_t(state_->size.y));
    glBindFramebuffer(GL_FRAMEBUFFER, state_->framebuffer);
    glReadPixels(0, 0, state_->size.x, state_->size.y, GL_DEPTH_COMPONENT, GL_FLOAT, depth.data());
    return depth;
}

}  // namespace peers
