// SPDX-License-Identifier: MIT
//
// Whole shaders around an entry's call, in any dialect.
//
// Inputs come as RGBA32F textures x0_texels .. x5_texels, one texel per pixel; `map` and `table` are textures too.
// A triangle (-1,-1), (3,-1), (-1,3) in the attribute `corner` (location 0) covers the target.
// Bindings, in dialects that have them: x0 .. x5 are 0 .. 5, map 6, table 7, and further maps 8 .. 10.
// Separate samplers are 11 .. 15, beginning with the map's. Before GLSL 1.30, map_size is a uniform.
// A compute shader of Vulkan stores into the target, an image at binding 16; a group has 64 pixels of a row.
#pragma once

#include "entry.hpp"

namespace parity {

/// bits: a fragment shader that gives floats as the integers of their bits, for targets that every WebGL 2 has.
enum class shader_stage { fragment, compute, bits };

struct shader {
    std::string vertex, fragment;  ///< or the compute shader, and no vertex shader
};

inline constexpr std::uint32_t group_width = 64;

/// An entry's call, as a snippet that the library prints too: umbrage_call(x0 .. x5, map, map_size, table), or for each
/// of the bound maps umbrage_call_<name>. In GLSL an entry without any calls its primitive itself.
class call_snippet {
public:
    call_snippet(const entry& e, dialect::language in);
    call_snippet(const call_snippet&) = delete;
    call_snippet& operator=(const call_snippet&) = delete;

    /// All that the shader needs, bound to the kinds of maps that the entry has.
    [[nodiscard]] const std::vector<umbrage::glsl::bound>& items() const { return items_; }
    /// Expression of the shader's result, a vec4.
    [[nodiscard]] const std::string& result() const { return result_; }

private:
    std::string source_, result_;
    std::vector<const snippet*> needs_;
    std::vector<umbrage::glsl::bound> items_;
};

/// A mistake that the printers are to make, to see whether it is seen: in their texts each `from` becomes `to`.
struct mistake {
    std::string from, to;
};
inline mistake planted;
[[nodiscard]] std::string with_mistake(std::string text);

/// Format of an image that a compute shader stores to.
[[nodiscard]] inline std::string format_of(target t) { return t == target::rgba8 ? "rgba8" : "rgba32f"; }

/// The fragment or compute shader in HLSL.
[[nodiscard]] std::string make_hlsl(const entry& e, shader_stage of = shader_stage::fragment);

/// @param of   compute: in Vulkan's GLSL and in HLSL alone; bits: from GLSL 3.30 and 300 es
[[nodiscard]] shader make_shader(const entry& e, dialect d, shader_stage of = shader_stage::fragment);

/// The fragment shader in WGSL.
[[nodiscard]] std::string make_wgsl(const entry& e);

inline constexpr std::size_t table_unit = max_inputs + 1, max_textures = max_inputs + max_maps + 1;
[[nodiscard]] constexpr std::size_t map_unit(std::size_t k) { return k == 0 ? max_inputs : table_unit + k; }
/// Binding of a texture's separate sampler. Inputs have none.
[[nodiscard]] constexpr std::size_t sampler_binding(std::size_t unit) { return max_textures + unit - max_inputs; }
inline constexpr std::size_t max_bindings = sampler_binding(max_textures), target_binding = max_bindings;

/// Expression for a map's size from its texture's size: without the surroundings of a region, or with six faces' tiles.
[[nodiscard]] std::string from_texture(const entry& e, dialect::language in);
/// GLSL for the size in texels of an entry's map.
[[nodiscard]] std::string map_size(const entry& e);

/// Uniform of a shader.
struct uniform {
    std::string type{}, name{};
};

/// True if a visitor's text declares this map.
[[nodiscard]] bool declares(const entry& e, const std::string& map);

/// Textures of an entry and samplers on their own, by their bindings; empty where unused.
[[nodiscard]] std::array<uniform, max_bindings> uniforms(const entry& e, dialect::language in = dialect::glsl);

}  // namespace parity
