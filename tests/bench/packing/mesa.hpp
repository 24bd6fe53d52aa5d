// SPDX-License-Identifier: MIT
//
// Codecs with OpenGL ES 3 on Mesa's llvmpipe.
#pragma once

#include <EGL/egl.h>
#include <EGL/eglext.h>
#define GL_GLES_PROTOTYPES 0
#include <GLES3/gl3.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "codecs.hpp"

namespace packing {

#define PACKING_GL(X)                                 \
    X(ACTIVETEXTURE, ActiveTexture)                   \
    X(ATTACHSHADER, AttachShader)                     \
    X(BINDFRAMEBUFFER, BindFramebuffer)               \
    X(BINDTEXTURE, BindTexture)                       \
    X(CHECKFRAMEBUFFERSTATUS, CheckFramebufferStatus) \
    X(COMPILESHADER, CompileShader)                   \
    X(CREATEPROGRAM, CreateProgram)                   \
    X(CREATESHADER, CreateShader)                     \
    X(DELETEPROGRAM, DeleteProgram)                   \
    X(DISABLE, Disable)                               \
    X(DRAWARRAYS, DrawArrays)                         \
    X(FRAMEBUFFERTEXTURE2D, FramebufferTexture2D)     \
    X(GENFRAMEBUFFERS, GenFramebuffers)               \
    X(GENTEXTURES, GenTextures)                       \
    X(GETERROR, GetError)                             \
    X(GETPROGRAMINFOLOG, GetProgramInfoLog)           \
    X(GETPROGRAMIV, GetProgramiv)                     \
    X(GETSHADERINFOLOG, GetShaderInfoLog)             \
    X(GETSHADERIV, GetShaderiv)                       \
    X(GETSTRING, GetString)                           \
    X(GETUNIFORMLOCATION, GetUniformLocation)         \
    X(LINKPROGRAM, LinkProgram)                       \
    X(READPIXELS, ReadPixels)                         \
    X(SHADERSOURCE, ShaderSource)                     \
    X(TEXIMAGE2D, TexImage2D)                         \
    X(TEXPARAMETERI, TexParameteri)                   \
    X(UNIFORM1I, Uniform1i)                           \
    X(USEPROGRAM, UseProgram)                         \
    X(VIEWPORT, Viewport)

class mesa {
public:
    mesa() {
        setenv("LIBGL_ALWAYS_SOFTWARE", "true", 1);
        setenv("GALLIUM_DRIVER", "llvmpipe", 1);
        setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
        const EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
        if (!display || !eglInitialize(display, nullptr, nullptr)) throw std::runtime_error("no EGL display");
        eglBindAPI(EGL_OPENGL_ES_API);
        const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_NONE};
        const EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, version);
        if (!context || eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) != EGL_TRUE)
            throw std::runtime_error("no OpenGL ES 3 context");
#define PACKING_LOAD(TYPE, NAME) NAME = reinterpret_cast<PFNGL##TYPE##PROC>(eglGetProcAddress("gl" #NAME));
        PACKING_GL(PACKING_LOAD)

        constexpr GLenum dither = 0x0BD0;  // on by default, would change bytes
        Disable(dither);
        GenTextures(3, textures_);
        GenFramebuffers(3, targets_);
        for (int i = 0; i < 3; ++i) {
            BindTexture(GL_TEXTURE_2D, textures_[i]);
            for (GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
                TexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
            TexImage2D(GL_TEXTURE_2D, 0, i == bytes ? GL_RGBA8 : GL_RGBA32F, width, height, 0, GL_RGBA,
                       i == bytes ? GL_UNSIGNED_BYTE : GL_FLOAT, nullptr);
            BindFramebuffer(GL_FRAMEBUFFER, targets_[i]);
            FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, textures_[i], 0);
            if (CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
                throw std::runtime_error("no float render targets");
        }
        Viewport(0, 0, width, height);
        truncate_ = link(truncating);
    }

    [[nodiscard]] std::string name() const { return reinterpret_cast<const char*>(GetString(GL_RENDERER)); }

    /// All depths through a codec.
    [[nodiscard]] result run(const codec& c, const way& w) const {
        const GLuint encode = link(encoder(c, w)), decode = link(decoder(c, w));
        std::vector<float> texels(std::size_t(4) * width * height);
        result all;
        for (int first = 0; first <= depths; first += width * height) {
            draw(encode, first, values, w.truncates ? written : bytes);
            if (w.truncates) draw(truncate_, first, written, bytes);
            draw(decode, first, bytes, values);
            const int count = std::min(width * height, depths + 1 - first);
            ReadPixels(0, 0, width, (count + width - 1) / width, GL_RGBA, GL_FLOAT, texels.data());
            if (const GLenum error = GetError()) throw std::runtime_error("GL error " + std::to_string(error));
            for (int i = 0; i < count; ++i) all.add(texels[std::size_t(4) * std::size_t(i)]);
        }
        DeleteProgram(encode);
        DeleteProgram(decode);
        return all;
    }

private:
    enum { bytes, written, values };  // targets

    void draw(GLuint program, int first, int from, int to) const {
        BindFramebuffer(GL_FRAMEBUFFER, targets_[to]);
        BindTexture(GL_TEXTURE_2D, textures_[from]);
        UseProgram(program);
        Uniform1i(GetUniformLocation(program, "first"), first);
        DrawArrays(GL_TRIANGLES, 0, 3);
    }

    [[nodiscard]] GLuint link(const std::string& fragment) const {
        const GLuint program = CreateProgram();
        char log[4096] = "";
        const std::pair<GLenum, const std::string*> stages[] = {{GL_VERTEX_SHADER, &vertex_shader},
                                                                {GL_FRAGMENT_SHADER, &fragment}};
        for (const auto& [kind, text] : stages) {
            const GLuint stage = CreateShader(kind);
            const char* source = text->c_str();
            GLint good = GL_FALSE;
            ShaderSource(stage, 1, &source, nullptr);
            CompileShader(stage);
            GetShaderiv(stage, GL_COMPILE_STATUS, &good);
            if (!good) GetShaderInfoLog(stage, sizeof log, nullptr, log);
            if (!good) throw std::runtime_error(log + *text);
            AttachShader(program, stage);
        }
        GLint good = GL_FALSE;
        LinkProgram(program);
        GetProgramiv(program, GL_LINK_STATUS, &good);
        if (!good) GetProgramInfoLog(program, sizeof log, nullptr, log);
        if (!good) throw std::runtime_error(log + fragment);
        return program;
    }

#define PACKING_DECLARE(TYPE, NAME) PFNGL##TYPE##PROC NAME = nullptr;
    PACKING_GL(PACKING_DECLARE)
    GLuint textures_[3]{}, targets_[3]{}, truncate_ = 0;
};

}  // namespace packing
