// SPDX-License-Identifier: MIT
//
// An OpenGL or OpenGL ES context that draws entries into textures.
#pragma once

#include <EGL/egl.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "../backend.hpp"
#include "gl_names.hpp"
#include "../shader.hpp"
#include "../texture.hpp"

namespace parity {

// The functions in use; EGL finds them for whichever context is current.
#define PARITY_GL(X)                                    \
    X(ACTIVETEXTURE, ActiveTexture)                     \
    X(ATTACHSHADER, AttachShader)                       \
    X(BINDATTRIBLOCATION, BindAttribLocation)           \
    X(BINDBUFFER, BindBuffer)                           \
    X(BINDFRAMEBUFFER, BindFramebuffer)                 \
    X(BINDTEXTURE, BindTexture)                         \
    X(BINDVERTEXARRAY, BindVertexArray)                 \
    X(BUFFERDATA, BufferData)                           \
    X(CHECKFRAMEBUFFERSTATUS, CheckFramebufferStatus)   \
    X(COMPILESHADER, CompileShader)                     \
    X(CREATEPROGRAM, CreateProgram)                     \
    X(CREATESHADER, CreateShader)                       \
    X(DELETEPROGRAM, DeleteProgram)                     \
    X(DELETESHADER, DeleteShader)                       \
    X(DELETETEXTURES, DeleteTextures)                   \
    X(DEPTHFUNC, DepthFunc)                             \
    X(DISABLE, Disable)                                 \
    X(DRAWARRAYS, DrawArrays)                           \
    X(ENABLE, Enable)                                   \
    X(ENABLEVERTEXATTRIBARRAY, EnableVertexAttribArray) \
    X(FRAMEBUFFERTEXTURE2D, FramebufferTexture2D)       \
    X(GENBUFFERS, GenBuffers)                           \
    X(GENFRAMEBUFFERS, GenFramebuffers)                 \
    X(GENTEXTURES, GenTextures)                         \
    X(GENVERTEXARRAYS, GenVertexArrays)                 \
    X(GETERROR, GetError)                               \
    X(GETINTEGERV, GetIntegerv)                         \
    X(GETPROGRAMINFOLOG, GetProgramInfoLog)             \
    X(GETPROGRAMIV, GetProgramiv)                       \
    X(GETSHADERINFOLOG, GetShaderInfoLog)               \
    X(GETSHADERIV, GetShaderiv)                         \
    X(GETSTRING, GetString)                             \
    X(GETUNIFORMLOCATION, GetUniformLocation)           \
    X(LINKPROGRAM, LinkProgram)                         \
    X(PIXELSTOREI, PixelStorei)                         \
    X(READPIXELS, ReadPixels)                           \
    X(SHADERSOURCE, ShaderSource)                       \
    X(TEXIMAGE2D, TexImage2D)                           \
    X(TEXIMAGE3D, TexImage3D)                           \
    X(TEXPARAMETERI, TexParameteri)                     \
    X(UNIFORM1I, Uniform1i)                             \
    X(UNIFORM2F, Uniform2f)                             \
    X(USEPROGRAM, UseProgram)                           \
    X(VERTEXATTRIBPOINTER, VertexAttribPointer)         \
    X(VIEWPORT, Viewport)

struct functions {
#define PARITY_DECLARE(TYPE, NAME) PFNGL##TYPE##PROC NAME = nullptr;
    PARITY_GL(PARITY_DECLARE)
    functions() {
#define PARITY_LOAD(TYPE, NAME) NAME = reinterpret_cast<PFNGL##TYPE##PROC>(eglGetProcAddress("gl" #NAME));
        PARITY_GL(PARITY_LOAD)
    }
};

/// One context with what drawing needs: a target of each kind, a texture per sampler, the programs of one entry.
class context {
public:
    context(EGLDisplay display, EGLContext handle) : display_(display), handle_(handle) {
        make_current();
        gl_ = functions();
        constexpr GLenum dither = 0x0BD0;  // on by default, would change bytes
        gl_.Disable(dither);
        gl_.Enable(GL_DEPTH_TEST);  // all pass; without one, llvmpipe compiles each program once more, for whole tiles
        gl_.DepthFunc(GL_ALWAYS);
        gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
        GLuint array = 0, buffer = 0;
        gl_.GenVertexArrays(1, &array);
        gl_.BindVertexArray(array);
        gl_.GenBuffers(1, &buffer);
        gl_.BindBuffer(GL_ARRAY_BUFFER, buffer);
        const float corners[] = {-1, -1, 3, -1, -1, 3};
        gl_.BufferData(GL_ARRAY_BUFFER, sizeof corners, corners, GL_STATIC_DRAW);
        gl_.EnableVertexAttribArray(0);
        gl_.VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
        gl_.GenTextures(4, target_textures_.data());
        gl_.GenTextures(4, target_depths_.data());
        gl_.GenFramebuffers(4, targets_.data());
        gl_.GetIntegerv(GL_MAX_TEXTURE_SIZE, &max_size_);
    }

    void make_current() const {
        if (eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, handle_) != EGL_TRUE)
            throw std::runtime_error("eglMakeCurrent failed");
    }

    [[nodiscard]] identity about() const {
        make_current();
        const auto text = [&](GLenum what) { return std::string(reinterpret_cast<const char*>(gl_.GetString(what))); };
        const std::string version = text(GL_VERSION);
        return {version.starts_with("OpenGL ES") ? "OpenGL ES" : "OpenGL", version, text(GL_RENDERER), text(GL_VENDOR)};
    }
    [[nodiscard]] int max_size() const { return max_size_; }

    [[nodiscard]] bool compiles(version v) const {
        make_current();
        const entry nothing{.primitive = &nothing_, .call = "vec4(0.0)"};
        try {
            gl_.DeleteProgram(link(make_shader(nothing, v)));
            return true;
        } catch (const std::runtime_error&) { return false; }
    }

    std::vector<vec4> run(version v, const job& j, std::size_t count) {
        make_current();
        const int height = rows(j.count), read_rows = rows(count);
        if (serial_ != j.serial) send(j);
        use(v, j);
        const target to = j.what->output;
        bind_target(to, height);
        gl_.Viewport(0, 0, width, height);  // the whole height, so that positions stay what they are
        gl_.DrawArrays(GL_TRIANGLES, 0, 3);

        std::vector<vec4> result(static_cast<std::size_t>(width * read_rows));
        const auto read = [&]<class Pixel>(std::vector<Pixel> pixels, auto values) {
            gl_.ReadPixels(0, 0, width, read_rows, GL_RGBA, names_of(to).type, pixels.data());
            std::ranges::transform(pixels, result.begin(), values);
        };
        const std::size_t n = result.size();
        switch (to) {
            case target::rgba32f: read(std::vector<vec4>(n), std::identity{}); break;
            case target::rgba8: read(std::vector<glm::u8vec4>(n), [](auto k) { return vec4(k); }); break;
            case target::rgba16: read(std::vector<glm::u16vec4>(n), [](auto k) { return vec4(k); }); break;
            case target::rgb10_a2:
                read(std::vector<std::uint32_t>(n),
                     [](std::uint32_t k) { return vec4(k & 1023, k >> 10 & 1023, k >> 20 & 1023, k >> 30); });
        }
        if (const GLenum error = gl_.GetError()) throw std::runtime_error("GL error " + std::to_string(error));
        result.resize(count);
        return result;
    }

private:
    struct program {
        version v;
        GLuint id;
    };

    void upload(const filled_texture& t) {
        const texture_image& image = t.image;
        GLuint& id = textures_[t.unit];
        gl_.DeleteTextures(1, &id);  // its shape may be another
        gl_.GenTextures(1, &id);
        const gl_names n = names_of(image);
        gl_.ActiveTexture(static_cast<GLenum>(GL_TEXTURE0 + t.unit));
        gl_.BindTexture(n.target, id);
        const auto set = [&](GLenum what, GLenum value) {
            gl_.TexParameteri(n.target, what, static_cast<GLint>(value));
        };
        for (GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
            set(filter, image.linear ? GL_LINEAR : GL_NEAREST);
        for (GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) set(wrap, GL_CLAMP_TO_EDGE);
        if (image.compare != texture_image::none) {
            set(GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
            set(GL_TEXTURE_COMPARE_FUNC, image.compare == texture_image::less_equal ? GL_LEQUAL : GL_GEQUAL);
        }
        const std::string bytes = t.bytes();
        const auto internal = static_cast<GLint>(n.internal);
        const ivec2 size = image.size;
        if (image.shape == texture_image::array) {
            gl_.TexImage3D(n.target, 0, internal, size.x, size.y, image.layers, 0, n.format, n.type, bytes.data());
            return;
        }
        const std::size_t layer = bytes.size() / static_cast<std::size_t>(image.layers);
        for (int l = 0; l < image.layers; ++l) {
            const GLenum face = image.shape == texture_image::cube ? GL_TEXTURE_CUBE_MAP_POSITIVE_X : n.target;
            gl_.TexImage2D(face + static_cast<GLenum>(l), 0, internal, size.x, size.y, 0, n.format, n.type,
                           bytes.data() + static_cast<std::size_t>(l) * layer);
        }
    }

    void send(const job& j) {
        for (const filled_texture& t : textures(j)) upload(t);
        serial_ = j.serial;
    }

    void use(version v, const job& j) {
        if (entry_ != j.what) {
            for (const program& p : programs_) gl_.DeleteProgram(p.id);
            programs_.clear();
            entry_ = j.what;
        }
        auto found = std::find_if(programs_.begin(), programs_.end(), [v](const program& p) { return p.v == v; });
        if (found == programs_.end()) {
            programs_.push_back({v, link(make_shader(*j.what, v))});
            found = programs_.end() - 1;
        }
        gl_.UseProgram(found->id);
        const auto all = uniforms(*j.what);
        for (std::size_t unit = 0; unit < all.size(); ++unit)
            if (!all[unit].name.empty())
                gl_.Uniform1i(gl_.GetUniformLocation(found->id, all[unit].name.c_str()), static_cast<GLint>(unit));
        if (j.map) {
            const vec2 size(j.map->size());
            gl_.Uniform2f(gl_.GetUniformLocation(found->id, "map_size"), size.x, size.y);  // no such uniform: no effect
        }
    }

    void bind_target(target to, int height) {
        const auto kind = static_cast<std::size_t>(to);
        gl_.BindFramebuffer(GL_FRAMEBUFFER, targets_[kind]);
        if (heights_[kind] == height) return;
        gl_.ActiveTexture(GL_TEXTURE0 + max_textures);
        const auto attach = [&](GLenum where, GLuint texture, const gl_names& n) {
            gl_.BindTexture(GL_TEXTURE_2D, texture);
            gl_.TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(n.internal), width, height, 0, n.format, n.type,
                           nullptr);
            gl_.FramebufferTexture2D(GL_FRAMEBUFFER, where, GL_TEXTURE_2D, texture, 0);
        };
        attach(GL_COLOR_ATTACHMENT0, target_textures_[kind], names_of(to));
        attach(GL_DEPTH_ATTACHMENT, target_depths_[kind],
               {GL_TEXTURE_2D, GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT});
        if (gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
            throw std::runtime_error("the render target is incomplete");
        heights_[kind] = height;
    }

    [[nodiscard]] GLuint link(const shader& s) const {
        const GLuint id = gl_.CreateProgram();
        char log[4096] = "";
        GLint good = GL_TRUE;
        const std::pair<GLenum, const std::string*> stages[] = {{GL_VERTEX_SHADER, &s.vertex},
                                                                {GL_FRAGMENT_SHADER, &s.fragment}};
        for (const auto& [kind, text] : stages) {
            const GLuint stage = gl_.CreateShader(kind);
            const char* source = text->c_str();
            gl_.ShaderSource(stage, 1, &source, nullptr);
            gl_.CompileShader(stage);
            gl_.AttachShader(id, stage);
            gl_.GetShaderiv(stage, GL_COMPILE_STATUS, &good);
            if (good != GL_TRUE) gl_.GetShaderInfoLog(stage, sizeof log, nullptr, log);
            gl_.DeleteShader(stage);
            if (good != GL_TRUE) break;
        }
        if (good == GL_TRUE) {
            gl_.BindAttribLocation(id, 0, "corner");
            gl_.LinkProgram(id);
            gl_.GetProgramiv(id, GL_LINK_STATUS, &good);
            if (good != GL_TRUE) gl_.GetProgramInfoLog(id, sizeof log, nullptr, log);
        }
        if (good == GL_TRUE) return id;
        gl_.DeleteProgram(id);
        throw std::runtime_error(std::string(log) + '\n' + s.fragment);
    }

    static constexpr snippet nothing_{.name = "nothing", .summary = {}, .source = "\n"};

    EGLDisplay display_;
    EGLContext handle_;
    functions gl_;
    std::array<GLuint, max_textures> textures_{};
    std::array<GLuint, 4> target_textures_{}, target_depths_{}, targets_{};
    std::array<int, 4> heights_{};
    GLint max_size_ = 0;
    std::vector<program> programs_;
    const entry* entry_ = nullptr;
    std::uint64_t serial_ = ~std::uint64_t(0);
};

}  // namespace parity
