// SPDX-License-Identifier: MIT
//
// OpenGL and OpenGL ES without a window, through EGL.
#include "gl_context.hpp"

#include <EGL/eglext.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <initializer_list>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace parity {
namespace {

EGLContext create(EGLDisplay display, EGLenum api, EGLint profile,
                  std::initializer_list<std::pair<EGLint, EGLint>> versions) {
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
        add(create(display, EGL_OPENGL_API, EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT,
                   {{4, 6}, {4, 5}, {3, 1}, {3, 0}}),
            {v110, v120, v130});
        std::sort(dialects_.begin(), dialects_.end(), [](auto& a, auto& b) { return a.first < b.first; });
    }

    [[nodiscard]] bool empty() const { return dialects_.empty(); }
    [[nodiscard]] std::string name() const override { return contexts_.front()->about().device; }
    [[nodiscard]] identity about(dialect d) const override { return context_of(d).about(); }
    [[nodiscard]] std::vector<dialect> dialects() const override {
        std::vector<dialect> all;
        for (const auto& [v, c] : dialects_) all.push_back(v);
        return all;
    }
    [[nodiscard]] std::string obstacle(const entry& e) const override {
        const auto filtered = [](const bound_map& b) { return b.linear; };
        if (name() == "softpipe" && std::any_of(e.bound.begin(), e.bound.end(), filtered))
            return "softpipe compares with a filtered depth, it does not filter comparisons";
        const int limit = contexts_.front()->max_size();
        if (e.table.size().x <= limit) return {};
        return "its table of " + std::to_string(e.table.size().x) + " texels is wider than a texture here, " +
               std::to_string(limit);
    }
    [[nodiscard]] std::vector<vec4> run(dialect d, const job& j, std::size_t count) override {
        return context_of(d).run(d.of_glsl, j, count);
    }

private:
    [[nodiscard]] context& context_of(dialect d) const {
        for (const auto& [v, c] : dialects_)
            if (d == v) return *c;
        throw std::runtime_error("no context for " + label(d));
    }

    std::vector<std::unique_ptr<context>> contexts_;
    std::vector<std::pair<version, context*>> dialects_;
};

/// True when Mesa draws on the CPU, as it does on a device without another driver.
bool is_software(const backend& b) {
    const std::string name = b.name();
    return name.starts_with("llvmpipe") || name.starts_with("softpipe");
}

bool has(const char* list, const char* word) { return list && std::strstr(list, word); }

void add(backends& all, EGLDisplay display, bool hardware) {
    if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) != EGL_TRUE) return;
    const char* extensions = eglQueryString(display, EGL_EXTENSIONS);
    if (!has(extensions, "EGL_KHR_surfaceless_context") || !has(extensions, "EGL_KHR_no_config_context")) return;
    auto one = std::make_unique<egl>(display);
    if (!one->empty() && is_software(*one) != hardware) all.push_back(std::move(one));
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
            add(all, eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr), false);
        return all;
    }
    const auto query_devices = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
    const auto query_string =
        reinterpret_cast<PFNEGLQUERYDEVICESTRINGEXTPROC>(eglGetProcAddress("eglQueryDeviceStringEXT"));
    if (!has(client, "EGL_EXT_platform_device") || !query_devices || !query_string) return all;
    EGLDeviceEXT devices[32];
    EGLint count = 0;
    if (query_devices(32, devices, &count) != EGL_TRUE) return all;
    for (EGLint i = 0; i < count; ++i)
        if (!has(query_string(devices[i], EGL_EXTENSIONS), "EGL_MESA_device_software"))
            add(all, eglGetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr), true);
    return all;
}

}  // namespace parity
