// SPDX-License-Identifier: MIT
#include "llvmpipe.hpp"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#define GL_GLEXT_PROTOTYPES 1
#include <GLES3/gl3.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include <umbrage/depth/rg.hpp>
#include <umbrage/shader/glsl.hpp>

namespace peers::llvmpipe {
namespace {

GLuint stage(GLenum kind, const std::string& text) {
    const GLuint id = glCreateShader(kind);
    const char* source = text.c_str();
    glShaderSource(id, 1, &source, nullptr);
    glCompileShader(id);
    GLint good = GL_FALSE;
    glGetShaderiv(id, GL_COMPILE_STATUS, &good);
    if (good) return id;
    char log[4096];
    glGetShaderInfoLog(id, sizeof log, nullptr, log);
    std::fprintf(stderr, "bench: %s\n%s\n", log, source);
    std::exit(1);
}

GLuint program(const std::vector<umbrage::glsl::snippet>& snippets, const std::string& arguments, bool packed) {
    using namespace umbrage;
    const glsl::binding clamped{.outside = outside_map::clamped};
    const glsl::binding map = packed ? glsl::stored_as(rg<11>{.edge = lower_edge<float>}, clamped) : clamped;
    std::vector<glsl::bound> bound;
    for (const glsl::snippet& s : snippets) bound.push_back(bind(s, "", map));
    const std::string filter = "umbrage_" + std::string(snippets.front().name);
    const std::string fragment = glsl::source(glsl::version::v300_es, bound) +
                                 "uniform highp sampler2D map, receivers;\n"
                                 "out highp vec4 visibility;\n"
                                 "void main() {\n"
                                 "    highp vec3 r = texelFetch(receivers, ivec2(gl_FragCoord.xy), 0).xyz;\n"
                                 "    visibility = vec4(" +
                                 filter + "(map, vec2(textureSize(map, 0)), r.xy, r.z" + arguments +
                                 "), 0.0, 0.0, 1.0);\n"
                                 "}\n";
    const GLuint id = glCreateProgram();
    glAttachShader(id, stage(GL_VERTEX_SHADER,
                             "#version 300 es\nvoid main() { gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, "
                             "gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0); }\n"));
    glAttachShader(id, stage(GL_FRAGMENT_SHADER, fragment));
    glLinkProgram(id);
    glUseProgram(id);
    glUniform1i(glGetUniformLocation(id, "map"), packed ? 1 : 0);
    glUniform1i(glGetUniformLocation(id, "receivers"), 2);
    return id;
}

void texture(GLenum unit, GLenum internal, GLenum format, GLenum type, glm::ivec2 size, const void* texels) {
    GLuint id = 0;
    glGenTextures(1, &id);
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_2D, id);
    for (GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        glTexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(internal), size.x, size.y, 0, format, type, texels);
    if (unit == 3) glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, id, 0);
}

class context final : public pass {
public:
    context(const umbrage::image<float>& map, const umbrage::image<glm::u8vec2>& packed,
            const umbrage::image<glm::vec3>& receivers)
        : size_(receivers.size()) {
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        GLuint frame = 0, array = 0;
        glGenFramebuffers(1, &frame);
        glBindFramebuffer(GL_FRAMEBUFFER, frame);
        glGenVertexArrays(1, &array);
        glBindVertexArray(array);
        texture(0, GL_R32F, GL_RED, GL_FLOAT, map.size(), map.texels().data());
        texture(1, GL_RG8, GL_RG, GL_UNSIGNED_BYTE, packed.size(), packed.texels().data());
        texture(2, GL_RGB32F, GL_RGB, GL_FLOAT, size_, receivers.texels().data());
        texture(3, GL_R32F, GL_RED, GL_FLOAT, size_, nullptr);
        glViewport(0, 0, size_.x, size_.y);
    }

    unsigned compile(const std::vector<umbrage::glsl::snippet>& snippets, const std::string& arguments,
                     bool packed) override {
        return program(snippets, arguments, packed);
    }

    void draw(unsigned filter) override {
        glUseProgram(filter);
        glDrawArrays(GL_TRIANGLES, 0, 3);
        glFinish();
    }

    void read(std::vector<float>& visibility) override {
        std::vector<float> rgba(visibility.size() * 4);
        glReadPixels(0, 0, size_.x, size_.y, GL_RGBA, GL_FLOAT, rgba.data());
        for (std::size_t i = 0; i < visibility.size(); ++i) visibility[i] = rgba[4 * i];
    }

private:
    glm::ivec2 size_;
};

}  // namespace

std::shared_ptr<pass> start(const umbrage::image<float>& map, const umbrage::image<glm::u8vec2>& packed,
                            const umbrage::image<glm::vec3>& receivers) {
    setenv("LP_NUM_THREADS", "0", 1);
    setenv("GALLIUM_DRIVER", "llvmpipe", 1);
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    const EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (!eglInitialize(display, nullptr, nullptr) || !eglBindAPI(EGL_OPENGL_ES_API)) return nullptr;
    const EGLint wanted[] = {EGL_CONTEXT_CLIENT_VERSION, 3, EGL_NONE};
    const EGLContext handle = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted);
    if (!handle || !eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, handle)) return nullptr;
    if (!std::strstr(reinterpret_cast<const char*>(glGetString(GL_RENDERER)), "llvmpipe")) return nullptr;
    return std::make_shared<context>(map, packed, receivers);
}

}  // namespace peers::llvmpipe
