// SPDX-License-Identifier: MIT
//
// Whole shaders around an entry's call, in any dialect.
//
// Inputs come as RGBA32F textures x0_texels .. x5_texels, one texel per pixel; `map` and `table` are textures too.
// A triangle (-1,-1), (3,-1), (-1,3) in the attribute `corner` (location 0) covers the target.
// Where there are bindings, in Vulkan: x0 .. x5 are 0 .. 5, map 6, table 7, further maps 8 .. 10. Before 1.30, map_size
// is a uniform.
#pragma once

#include "entry.hpp"

namespace parity {

struct shader {
    std::string vertex, fragment;
};

/// An entry's call as a snippet, so that the library prints it too: vec4 umbrage_call(x0 .. x5, map, map_size, table).
class call_snippet {
public:
    explicit call_snippet(const entry& e);
    call_snippet(const call_snippet&) = delete;
    call_snippet& operator=(const call_snippet&) = delete;

    /// Bound to the kind of map that the entry has.
    [[nodiscard]] const std::vector<umbrage::glsl::bound>& items() const { return items_; }
    [[nodiscard]] const std::string& arguments() const { return arguments_; }

private:
    std::string source_, arguments_;
    std::vector<const snippet*> needs_;
    std::vector<umbrage::glsl::bound> items_;
};

/// A mistake that the printers are to make, to see whether it is seen: in their texts each `from` becomes `to`.
struct mistake {
    std::string from, to;
};
inline mistake planted;
[[nodiscard]] std::string with_mistake(std::string text);

/// The fragment shader in HLSL.
[[nodiscard]] std::string make_hlsl(const entry& e);

[[nodiscard]] shader make_shader(const entry& e, dialect d);

/// The fragment shader in WGSL.
[[nodiscard]] std::string make_wgsl(const entry& e);

inline constexpr std::size_t table_unit = max_inputs + 1, max_textures = max_inputs + max_maps + 1;
[[nodiscard]] constexpr std::size_t map_unit(std::size_t k) { return k == 0 ? max_inputs : table_unit + k; }

/// GLSL for the size in texels of an entry's map.
[[nodiscard]] std::string map_size(const entry& e);

/// A uniform of a shader.
struct sampler {
    std::string type{}, name{};
};

/// Samplers of an entry in order of their bindings, empty where unused.
[[nodiscard]] std::array<sampler, max_textures> samplers(const entry& e);

}  // namespace parity
