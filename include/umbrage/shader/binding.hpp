// SPDX-License-Identifier: MIT
//
// What a map is to shaders: what its texels lie in, how they become depths, how they compare.
//
//     using namespace umbrage::glsl;
//     const binding cascades{.texture = texture::array};
//     const binding packed = stored_as(umbrage::rg<11>{});
//
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <umbrage/core/clip_space.hpp>
#include <umbrage/core/snippet.hpp>
#include <umbrage/depth/encoding.hpp>

namespace umbrage::glsl {

/// What a map's texels lie in, and so what functions that take a map are called with first; here in GLSL's words:
///   texture_2d             sampler2D map: depths, or values that `depth` makes depths of
///   atlas                  sampler2D map, vec2 origin: a region, whose first texel the caller gives
///   array                  sampler2DArray map, float layer
///   cube                   samplerCube map, float face: one face of cube_map.hpp, filtered within itself
///   cube_faces             samplerCube map: its faces as the tiles of an atlas, for pcf_2x2_cube, to which the size is
///                          that of the atlas then, (3, 2) times a face's
///   integer                usampler2D map: the value is the whole number, exact up to 2^24
///   depth, depth_array     depth textures that are read as they are; in GLSL texture_2d and array
///   shadow, shadow_array   comparison samplers, sampler2DShadow map: they compare themselves, in the direction that
///                          they were set to; a filter that needs depths cannot be bound to them
/// Samplers clamp to the edge and take the nearest texel, but for pcf_2x2_hardware and window_hardware. A depth texture
/// of floats gives the plain form's bits. Where its depths are whole numbers, a sampler compares with the receiver as
/// one from 0 to 1: filters give the same all the same, as they light what is beyond the far plane; lit() alone does
/// not.
enum class texture { texture_2d, atlas, array, cube, cube_faces, integer, depth, depth_array, shadow, shadow_array };

/// A map for shaders: where its texels are, and how they compare. Texts in it are in the shader's own language.
struct binding {
    glsl::texture texture = glsl::texture::texture_2d;
    depth_direction direction = depth_direction::forward;
    std::optional<outside_map> outside{};  ///< none: bordered, but clamped for tiles, regions and faces of cubes
    bool gather = false;    ///< 2x2 texels at once, and depths at points, by a sampler; it must clamp to the
                            ///< edge, but for regions
    std::string depth{};    ///< of vec4 `value`, as "umbrage_decode_rg11(value.xy, 1.0)"; empty: value.x. Where
                            ///< nothing is gathered also of vec2 `texel`, the number that was asked for
    int channels = 1;       ///< how many of `value` it reads
    std::string compare{};  ///< of `receiver` and `stored`, as "exp(40.0 * (stored - receiver))"; 1.0 is lit. Empty:
                            ///< by direction. With one's own no receiver is beyond the far plane
    bool receiver_plane = false;   ///< moves each depth along the receiver's plane (apply_receiver_plane): functions
                                   ///< take two vec2 behind the map, the plane's slope and the receiver's coordinate.
                                   ///< Not where texels are gathered or compared by the sampler
    std::string origin{};          ///< vec2: the map's first texel in the texture; empty: (0, 0)
    std::string texture_size{};    ///< vec2: for regions of textures that are read by coordinates
    std::string parameters{};      ///< in place of the kind's: what stands for the map in declarations,
    std::string arguments{};       ///< in calls,
    std::string texel{};           ///< and as value, a vec4, of the texture at `at`, a vec2 of whole numbers
    std::vector<snippet> needs{};  ///< what these texts call

    friend bool operator==(const binding&, const binding&) = default;
};

/// The map that an encoding's texels make, in place of `map`'s depth and direction.
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
