// SPDX-License-Identifier: MIT
#include "implementation.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <vector>

namespace check {
namespace {

using parity::dialect;
using std::filesystem::path;

/// Where a shell finds a program; empty: nowhere.
path on_path(const char* program) {
    const char* folders = std::getenv("PATH");
    std::istringstream all(folders ? folders : "");
    for (std::string folder; std::getline(all, folder, ':');)
        if (const path file = path(folder) / program; access(file.c_str(), X_OK) == 0) return file;
    return {};
}

const std::vector<std::string> cpp_compilers{"clang++", "clang++-14", "g++"};

path first_on_path(const std::vector<std::string>& programs) {
    for (const std::string& each : programs)
        if (const path file = on_path(each.c_str()); !file.empty()) return file;
    return {};
}

/// Folder of what this program needs. It lies at one place from the program, wherever that is installed.
path own_files() {
    const path program = std::filesystem::read_symlink("/proc/self/exe");
    return (program.parent_path() / UMBRAGE_CHECK_SCRIPTS).lexically_normal();
}

/// Naga's files; Node.js lies where the user has it.
parity::naga_files naga() { return {on_path("node"), own_files() / "naga.js", own_files() / "node_modules"}; }

void require(const parity::naga_files& files) {
    const std::string naga = "naga compiles WGSL here, and ";
    if (files.node.empty())
        throw cannot_run(naga + "needs Node.js: no folder of PATH has a program node. Install it (Debian: nodejs)");
    if (!exists(files.script))
        throw cannot_run(naga + "needs " + files.script.string() +
                         ", which is installed with umbrage-check: install it again");
    if (!exists(files.modules / "naga-wasm"))
        throw cannot_run(naga + "needs its module, which is not in " + files.modules.string() +
                         ". Install it: npm install --prefix " + files.script.parent_path().string() + " naga-wasm@30");
}

struct language {
    const char* name;
    std::vector<std::string> implementations;  ///< for --on
    const char* needs;
};

language language_of(dialect d) {
    constexpr const char* vulkan =
        "a Vulkan driver (Debian: mesa-vulkan-drivers) and a build of umbrage-check that found Vulkan "
        "and glslang (Debian: libvulkan-dev glslang-dev)";
    switch (d.in) {
        case dialect::hlsl: return {"HLSL", {"lavapipe", "hardware"}, vulkan};
        case dialect::wgsl: return {"WGSL", {"naga"}, vulkan};
        case dialect::msl: return {"Metal", cpp_compilers, ""};
        default:
            return {"GLSL",
                    {"llvmpipe", "softpipe", "hardware"},
                    "an OpenGL driver (Debian: libgl1-mesa-dri) and a build of umbrage-check that found EGL (Debian: "
                    "libegl-dev)"};
    }
}

}  // namespace

metal_files metal_here(const std::string& on) {
    const metal_files files{.compiler = first_on_path(on.empty() ? cpp_compilers : std::vector{on}),
                            .headers = own_files() / "metal"};
    const std::string metal = "Metal runs here as C++, and needs ";
    if (files.compiler.empty())
        throw cannot_run(metal + "a compiler of it: no folder of PATH has a program " +
                         (on.empty() ? "clang++ or g++" : on) + ". Install one (Debian: clang or g++)");
    if (!exists(files.headers))
        throw cannot_run(metal + files.headers.string() + ", which is installed with umbrage-check: install it again");
    return files;
}

std::unique_ptr<parity::backend> implementation(dialect d, const std::string& on) {
    const language in = language_of(d);
    const std::string& name = on.empty() ? in.implementations.front() : on;
    if (std::ranges::find(in.implementations, name) == in.implementations.end()) {
        std::string known;
        for (const std::string& each : in.implementations) known += (known.empty() ? "" : ", ") + each;
        throw cannot_run("--on for " + std::string(in.name) + " must be one of: " + known + "; got " + name);
    }
    if (d == dialect::msl) return metal_as_cpp(metal_here(on));
    parity::backends all;
    if (d == dialect::wgsl) {
        const parity::naga_files files = naga();
        require(files);
        all = parity::naga_backends(files);
    } else {
        all = d == dialect::hlsl ? parity::vulkan_backends(name) : parity::egl_backends(name);
    }
    if (all.empty())
        throw cannot_run("nothing here runs " + std::string(in.name) + " on " + name + ". It needs " + in.needs);
    return std::move(all.front());
}

}  // namespace check
