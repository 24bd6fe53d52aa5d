// SPDX-License-Identifier: MIT
//
// An implementation that can run entries. It knows nothing of any primitive.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>

#include "entry.hpp"

namespace parity {

/// Inputs for one run: `count` values in each x that the entry uses, at most 2^20.
struct job {
    const entry* what = nullptr;
    std::vector<const input_class*> classes;  ///< the i-th input is of the (i mod size)-th
    std::array<std::vector<vec4>, max_inputs> x;
    const texels* map = nullptr;
    std::size_t count = 0;
    std::uint64_t serial = 0;  ///< the same for the same inputs, so that they need not be sent again

    [[nodiscard]] sample at(std::size_t i) const {
        sample s;
        for (std::size_t k = 0; k < max_inputs; ++k)
            if (!x[k].empty()) s.x[k] = x[k][i];
        if (map) s.map = map->view();
        s.table = what->table.view();
        return s;
    }
};

/// The inputs from `first` on: entry, map, number and serial decide each of them.
[[nodiscard]] job make_job(const entry& e, const texels* map, std::size_t first, std::size_t count,
                           std::uint64_t serial);

/// As many of the entry's enumeration, in an order in which any part is a fair sample; on the entry's first map.
[[nodiscard]] job make_whole_job(const entry& e, std::size_t first, std::size_t count, std::uint64_t serial);

/// Identity that an implementation reports. All dialects of one API share it.
struct identity {
    std::string api, version{}, device{}, driver{};  ///< what is unknown is empty
};

class backend {
public:
    virtual ~backend() = default;

    [[nodiscard]] virtual std::string name() const = 0;  ///< of the implementation, as it calls itself
    [[nodiscard]] virtual identity about(dialect) const { return {.api = name()}; }
    [[nodiscard]] virtual std::vector<dialect> dialects() const = 0;
    [[nodiscard]] virtual std::string label(dialect d) const { return parity::name(d); }

    /// False where only the shaders of entries() exist.
    [[nodiscard]] virtual bool has_compiler() const { return true; }

    /// Why this entry cannot run here, e.g. a texture that is too large; empty when it can.
    [[nodiscard]] virtual std::string obstacle(const entry&) const { return {}; }

    /// The first `count` results.
    /// @throws std::runtime_error   with the compiler's words
    [[nodiscard]] virtual std::vector<vec4> run(dialect d, const job& j, std::size_t count) = 0;
};

/// The results of an entry that is not one of entries(), with x[k] as inputs.
[[nodiscard]] std::vector<vec4> run_once(backend& b, dialect d, entry e, std::array<std::vector<vec4>, max_inputs> x);

using backends = std::vector<std::unique_ptr<backend>>;

/// Mesa's software drivers ("llvmpipe", "softpipe"), or every other device EGL knows ("hardware"). Empty: none here.
[[nodiscard]] backends egl_backends(std::string_view driver);

/// Vulkan in software ("lavapipe", "lavapipe_compute", which does not draw, or "swiftshader_vulkan", the browser's), or
/// every other device Vulkan knows ("hardware"). Empty: none here.
[[nodiscard]] backends vulkan_backends(std::string_view driver);

/// What translates WGSL to SPIR-V: Node.js, the script naga.js, and the folder of the module naga-wasm.
struct naga_files {
    std::filesystem::path node, script, modules;
};
/// WGSL on lavapipe. Empty, and said why, where one of the files is missing.
[[nodiscard]] backends naga_backends(const naga_files&);

/// WebGL 1 and 2 in a browser, on SwiftShader. Empty, and said why, where the browser or what drives it is missing.
[[nodiscard]] backends webgl_backends();

/// WebGPU without a browser, which compiles WGSL with Tint, on SwiftShader. Empty, and said why, where it is missing.
[[nodiscard]] backends webgpu_backends();

/// The snippets' Metal compiled as C++. Empty: no clang, whose literals can be floats as Metal's.
[[nodiscard]] backends metal_backends();

/// The snippets' text compiled as C++.
[[nodiscard]] backends cpp_backends();

/// The same by a compiler that fuses multiplications and additions. Empty: the processor does not.
[[nodiscard]] backends fused_backends();

}  // namespace parity
