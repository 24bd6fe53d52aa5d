// SPDX-License-Identifier: MIT
//
// OpenGL and OpenGL ES without a window, through EGL.
#include <EGL/egl.h>
#include <EGL/eglext.h>
#define GL_GLES_PROTOTYPES 0
#include <GLES3/gl3.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <stdexcept>

#include "backend.hpp"
#include "shader.hpp"

namespace parity {
namespace {

// The functions in use; EGL finds them for whichever context is current.
#define PARITY_GL(X)                                                                                                  \
    X(ACTIVETEXTURE, ActiveTexture) X(ATTACHSHADER, AttachShader) X(BINDATTRIBLOCATION, BindAttribLocation)            \
    X(BINDBUFFER, BindBuffer) X(BINDFRAMEBUFFER, BindFramebuffer) X(BINDTEXTURE, BindTexture)                          \
    X(BINDVERTEXARRAY, BindVertexArray) X(BUFFERDATA, BufferData) X(CHECKFRAMEBUFFERSTATUS, CheckFramebufferStatus)    \
    X(COMPILESHADER, CompileShader) X(CREATEPROGRAM, CreateProgram) X(CREATESHADER, CreateShader)                      \
    X(DELETEPROGRAM, DeleteProgram) X(DELETESHADER, DeleteShader) X(DISABLE, Disable) X(DRAWARRAYS, DrawArrays)        \
    X(ENABLEVERTEXATTRIBARRAY, EnableVertexAttribArray) X(FRAMEBUFFERTEXTURE2D, FramebufferTexture2D)                  \
    X(GENBUFFERS, GenBuffers) X(GENFRAMEBUFFERS, GenFramebuffers) X(GENTEXTURES, GenTextures)                          \
    X(GENVERTEXARRAYS, GenVertexArrays) X(GETERROR, GetError) X(GETINTEGERV, GetIntegerv)                              \
    X(GETPROGRAMINFOLOG, GetProgramInfoLog) X(GETPROGRAMIV, GetProgramiv) X(GETSHADERINFOLOG, GetShaderInfoLog)        \
    X(GETSHADERIV, GetShaderiv) X(GETSTRING, GetString) X(GETUNIFORMLOCATION, GetUniformLocation)                      \
    X(LINKPROGRAM, LinkProgram) X(PIXELSTOREI, PixelStorei) X(READPIXELS, ReadPixels) X(SHADERSOURCE, ShaderSource)    \
    X(TEXIMAGE2D, TexImage2D) X(TEXPARAMETERI, TexParameteri) X(TEXSUBIMAGE2D, TexSubImage2D) X(UNIFORM1I, Uniform1i)  \
    X(UNIFORM2F, Uniform2f) X(USEPROGRAM, UseProgram) X(VERTEXATTRIBPOINTER, VertexAttribPointer) X(VIEWPORT, Viewport)

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
    static constexpr int width = 1024;

    context(EGLDisplay display, EGLContext handle) : display_(display), handle_(handle) {
        make_current();
        gl_ = functions();
        constexpr GLenum dither = 0x0BD0;  // on by default, would change bytes
        gl_.Disable(dither);
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
        gl_.GenTextures(static_cast<GLsizei>(textures_.size()), textures_.data());
        gl_.GenTextures(2, target_textures_.data());
        gl_.GenFramebuffers(2, targets_.data());
        gl_.GetIntegerv(GL_MAX_TEXTURE_SIZE, &max_size_);
    }

    void make_current() const {
        if (eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, handle_) != EGL_TRUE)
            throw std::runtime_error("eglMakeCurrent failed");
    }

    [[nodiscard]] std::string renderer() const {
        make_current();
        return reinterpret_cast<const char*>(gl_.GetString(GL_RENDERER));
    }
    [[nodiscard]] int max_size() const { return max_size_; }

    [[nodiscard]] bool compiles(version v) const {
        make_current();
        const entry nothing{.primitive = &nothing_, .call = "vec4(0.0)"};
        try {
            gl_.DeleteProgram(link(make_shader(nothing, v)));
            return true;
        } catch (const std::runtime_error&) {
            return false;
        }
    }

    std::vector<vec4> run(version v, const job& j, std::size_t count) {
        make_current();
        const int height = static_cast<int>((j.count + width - 1) / width);
        if (serial_ != j.serial) send(j, height);
        use(v, j);
        const bool bytes = j.what->output == target::rgba8;
        const int rows = static_cast<int>((count + width - 1) / width);
        bind_target(bytes, height);
        gl_.Viewport(0, 0, width, height);  // the whole height, so that positions stay what they are
        gl_.DrawArrays(GL_TRIANGLES, 0, 3);

        std::vector<vec4> result(static_cast<std::size_t>(width * rows));
        if (bytes) {
            std::vector<glm::vec<4, std::uint8_t>> read(result.size());
            gl_.ReadPixels(0, 0, width, rows, GL_RGBA, GL_UNSIGNED_BYTE, read.data());
            std::copy(read.begin(), read.end(), result.begin());
        } else {
            gl_.ReadPixels(0, 0, width, rows, GL_RGBA, GL_FLOAT, result.data());
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

    void upload(std::size_t unit, const vec4* texels_of, glm::ivec2 size, int whole_height) const {
        gl_.ActiveTexture(static_cast<GLenum>(GL_TEXTURE0 + unit));
        gl_.BindTexture(GL_TEXTURE_2D, textures_[unit]);
        for (GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) gl_.TexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
        for (GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) gl_.TexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
        gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, size.x, whole_height, 0, GL_RGBA, GL_FLOAT, nullptr);
        gl_.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size.x, size.y, GL_RGBA, GL_FLOAT, texels_of);
    }

    void send(const job& j, int height) {
        for (std::size_t k = 0; k < max_inputs; ++k) {
            if (j.x[k].empty()) continue;
            std::vector<vec4> padded = j.x[k];
            padded.resize(static_cast<std::size_t>(width * height));
            upload(k, padded.data(), {width, height}, height);
        }
        if (j.map) upload(max_inputs, j.map->texels().data(), j.map->size(), j.map->size().y);
        const texels& table = j.what->table;
        if (!table.empty()) upload(max_inputs + 1, table.texels().data(), table.size(), table.size().y);
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
        const auto names = samplers(*j.what);
        for (std::size_t unit = 0; unit < names.size(); ++unit)
            if (!names[unit].empty())
                gl_.Uniform1i(gl_.GetUniformLocation(found->id, names[unit].c_str()), static_cast<GLint>(unit));
        if (j.map) {
            const vec2 size(j.map->size());
            gl_.Uniform2f(gl_.GetUniformLocation(found->id, "map_size"), size.x, size.y);  // no such uniform: no effect
        }
    }

    void bind_target(bool bytes, int height) {
        const std::size_t kind = bytes ? 1 : 0;
        gl_.BindFramebuffer(GL_FRAMEBUFFER, targets_[kind]);
        if (heights_[kind] == height) return;
        gl_.ActiveTexture(GL_TEXTURE0 + max_inputs + 2);
        gl_.BindTexture(GL_TEXTURE_2D, target_textures_[kind]);
        gl_.TexImage2D(GL_TEXTURE_2D, 0, bytes ? GL_RGBA8 : GL_RGBA32F, width, height, 0, GL_RGBA,
                       bytes ? GL_UNSIGNED_BYTE : GL_FLOAT, nullptr);
        gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target_textures_[kind], 0);
        if (gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
            throw std::runtime_error("the render target is incomplete");
        heights_[kind] = height;
    }

    [[nodiscard]] GLuint link(const shader& s) const {
        const GLuint id = gl_.CreateProgram();
        char log[4096] = "";
        GLint good = GL_TRUE;
        const std::pair<GLenum, const std::string*> stages[] = {{GL_VERTEX_SHADER, &s.vertex}, {GL_FRAGMENT_SHADER, &s.fragment}};
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
    std::array<GLuint, max_inputs + 2> textures_{};
    std::array<GLuint, 2> target_textures_{}, targets_{};
    std::array<int, 2> heights_{};
    GLint max_size_ = 0;
    std::vector<program> programs_;
    const entry* entry_ = nullptr;
    std::uint64_t serial_ = ~std::uint64_t(0);
};

EGLContext create(EGLDisplay display, EGLenum api, EGLint profile, std::initializer_list<std::pair<EGLint, EGLint>> versions) {
    eglBindAPI(api);
    for (const auto& [major, minor] : versions) {
        std::vector<EGLint> wish{EGL_CONTEXT_MAJOR_VERSION, major, EGL_CONTEXT_MINOR_VERSION, minor};
        if (profile) wish.insert(wish.end(), {EGL_CONTEXT_OPENGL_PROFILE_MASK, profile});
        wish.push_back(EGL_NONE);
        const EGLContext c = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wish.data());
        if (c != EGL_NO_CONTEXT) return c;
    }
    return EGL_NO_CONTEXT;
}

/// A display with a context for each family of dialects.
class egl final : public backend {
public:
    explicit egl(EGLDisplay display) {
        using enum version;
        const auto add = [&](EGLContext handle, std::initializer_list<version> dialects) {
            if (handle == EGL_NO_CONTEXT) return;
            contexts_.push_back(std::make_unique<context>(display, handle));
            for (version v : dialects)
                if (contexts_.back()->compiles(v)) dialects_.push_back({v, contexts_.back().get()});
        };
        add(create(display, EGL_OPENGL_ES_API, 0, {{3, 2}, {3, 1}, {3, 0}}), {v100, v300_es, v310_es, v320_es});
        add(create(display, EGL_OPENGL_API, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, {{4, 6}, {4, 5}, {4, 3}, {3, 3}}),
            {v150, v330, v430, v450, v460});
        add(create(display, EGL_OPENGL_API, EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT, {{4, 6}, {4, 5}, {3, 1}, {3, 0}}),
            {v110, v120, v130});
        std::sort(dialects_.begin(), dialects_.end(), [](auto& a, auto& b) { return a.first < b.first; });
    }

    [[nodiscard]] bool empty() const { return dialects_.empty(); }
    [[nodiscard]] std::string name() const override { return contexts_.front()->renderer(); }
    [[nodiscard]] std::vector<version> versions() const override {
        std::vector<version> all;
        for (const auto& [v, c] : dialects_) all.push_back(v);
        return all;
    }
    [[nodiscard]] std::string obstacle(const entry& e) const override {
        const int limit = contexts_.front()->max_size();
        if (e.table.size().x <= limit) return {};
        return "its table of " + std::to_string(e.table.size().x) + " texels is wider than a texture here, " + std::to_string(limit);
    }
    [[nodiscard]] std::vector<vec4> run(version v, const job& j, std::size_t count) override {
        for (const auto& [dialect, c] : dialects_)
            if (dialect == v) return c->run(v, j, count);
        throw std::runtime_error("no context for " + label(v));
    }

private:
    std::vector<std::unique_ptr<context>> contexts_;
    std::vector<std::pair<version, context*>> dialects_;
};

bool has(const char* list, const char* word) { return list && std::strstr(list, word); }

void add(backends& all, EGLDisplay display) {
    if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) != EGL_TRUE) return;
    const char* extensions = eglQueryString(display, EGL_EXTENSIONS);
    if (!has(extensions, "EGL_KHR_surfaceless_context") || !has(extensions, "EGL_KHR_no_config_context")) return;
    auto one = std::make_unique<egl>(display);
    if (!one->empty()) all.push_back(std::move(one));
}

}  // namespace

backends egl_backends(std::string_view driver) {
    // Mesa reads these once, so a process runs one driver. Its cache lets one dialect's program pass for another's.
    setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
    backends all;
    const char* client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    if (driver != "hardware") {
        setenv("LIBGL_ALWAYS_SOFTWARE", "true", 1);
        setenv("GALLIUM_DRIVER", std::string(driver).c_str(), 1);
        if (driver == "llvmpipe") {  // it has all of 4.6 that fragment shaders need, and says 4.5
            setenv("MESA_GL_VERSION_OVERRIDE", "4.6", 1);
            setenv("MESA_GLSL_VERSION_OVERRIDE", "460", 1);
        }
        if (has(client, "EGL_MESA_platform_surfaceless"))
            add(all, eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
        return all;
    }
    const auto query_devices = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
    const auto query_string = reinterpret_cast<PFNEGLQUERYDEVICESTRINGEXTPROC>(eglGetProcAddress("eglQueryDeviceStringEXT"));
    if (!has(client, "EGL_EXT_platform_device") || !query_devices || !query_string) return all;
    EGLDeviceEXT devices[32];
    EGLint count = 0;
    if (query_devices(32, devices, &count) != EGL_TRUE) return all;
    for (EGLint i = 0; i < count; ++i)
        if (!has(query_string(devices[i], EGL_EXTENSIONS), "EGL_MESA_device_software"))
            add(all, eglGetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr));
    return all;
}

}  // namespace parity
