// SPDX-License-Identifier: MIT
//
// Description of a shadow map for shaders: its texture type, the conversion of texels to depths, and the comparison.
//
//     using namespace umbrage::glsl;
//     const binding cascades{.texture = texture::array};
//     const binding packed = stored_as(umbrage::rg<11>{});
//
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <umbrage/core/clip_space.hpp>
#include <umbrage/core/snippet.hpp>
#include <umbrage/depth/encoding.hpp>

namespace umbrage::glsl {

/// Texture type of a map. It decides the first parameters of functions that take the map, given here in GLSL:
///   texture_2d             sampler2D map: depths, or values that `depth` converts to depths
///   atlas                  sampler2D map, vec2 origin: a region, whose first texel the caller passes
///   array                  sampler2DArray map, float layer
///   cube                   samplerCube map, float face: one face of cube_map.hpp, filtered within itself
///   cube_faces             samplerCube map: its faces as tiles of an atlas, for pcf_2x2_cube. The size is then that of
///                          the atlas, (3, 2) times a face's
///   integer                usampler2D map: the depth is the integer, exact up to 2^24
///   depth, depth_array     depth textures that are read without comparison. In GLSL the same as texture_2d and array
///   shadow, shadow_array   comparison samplers, sampler2DShadow map. Set the direction of comparison on the sampler. A
///                          filter that needs depths cannot be bound to them
///
/// Samplers must clamp to the edge and read the nearest texel, except for pcf_2x2_hardware and window_hardware. A float
/// depth texture gives the same bits as the plain form. With integer depths, a sampler clamps the receiver to [0, 1]
/// before it compares. Filters give the same bits even then, since they light receivers beyond the far plane. lit()
/// alone does not.
enum class texture { texture_2d, atlas, array, cube, cube_faces, integer, depth, depth_array, shadow, shadow_array };

namespace detail {

/// Name of a texture type, for errors.
[[nodiscard]] inline const char* name_of(texture kind) {
    constexpr std::array names{"texture_2d", "atlas", "array",       "cube",   "cube_faces",
                               "integer",    "depth", "depth_array", "shadow", "shadow_array"};
    const auto number = static_cast<std::size_t>(kind);
    return number < names.size() ? names[number] : "none of them";
}

}  // namespace detail

/// Shadow map for shaders: its texels, and how they compare. Texts in it are in the shader's language.
struct binding {
    glsl::texture texture = glsl::texture::texture_2d;
    depth_direction direction = depth_direction::forward;
    std::optional<outside_map> outside{};  ///< none: bordered, but clamped for tiles, regions and faces of cubes
    bool gather = false;    ///< reads 2x2 texels at once, and depths at points, with a sampler. It must clamp to the
                            ///< edge, except for regions
    std::string depth{};    ///< depth from vec4 `value`, as "umbrage_decode_rg11(value.xy, 1.0)"; empty: value.x.
                            ///< Without gather it may use vec2 `texel`, the index of the texel
    int channels = 1;       ///< number of channels of `value` that `depth` reads
    std::string compare{};  ///< "exp(40.0 * (stored - receiver))", for example: 1.0 is lit. Empty: by
                            ///< direction. With an own comparison no receiver is beyond the far plane
    bool receiver_plane = false;   ///< compares along the receiver's plane (plane_reference). After the map functions
                                   ///< take the plane's slope, a vec2, and a vec3 of the receiver's coordinate and its
                                   ///< depth. Not with gathered comparisons or an own one
    std::string origin{};          ///< vec2: the map's first texel in the texture; empty: (0, 0)
    std::string texture_size{};    ///< vec2: for regions of textures that are read by coordinates
    std::string parameters{};      ///< replaces the texture type's words: the map's parameters in declarations,
    std::string arguments{};       ///< its arguments in calls,
    std::string texel{};           ///< and a vec4 expression that reads the texture at `at`, a vec2 of integers
    std::vector<snippet> needs{};  ///< snippets that these texts call

    friend bool operator==(const binding&, const binding&) = default;
};

/// Binding of a map in an encoding: replaces `map`'s depth and direction.
template <known_encoding Encoding>
[[nodiscard]] binding stored_as(const Encoding& encoding, binding map = {}) {
    map.direction = encoding.direction;
    if constexpr (Encoding::writes != store_format::depth) {
        map.channels = Encoding::target::channels;
        map.depth = "umbrage_" + std::string(Encoding::reader->name) + "(value." +
                    std::string("xyzw").substr(0, static_cast<std::size_t>(map.channels));
        if constexpr (has_edge<Encoding>) {
            std::string edge = std::to_string(encoding.edge);
            while (edge.back() == '0' && edge[edge.size() - 2] != '.') edge.pop_back();
            map.depth += ", " + edge;
        }
        map.depth += ')';
        map.needs.push_back(*Encoding::reader);
    }
    return map;
}

}  // namespace umbrage::glsl
