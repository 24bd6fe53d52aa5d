// SPDX-License-Identifier: MIT
//
// Cube textures in place of an atlas of six faces: the face and texel of an atlas texel, and the direction that reads
// it. Filters for an atlas use this on cubes: see `texture::cube_faces` in bind.hpp.
//
//     glm::vec3 direction = umbrage::cube_atlas_direction(texel, size);  // what a samplerCube takes
//
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/core/scalar.hpp>
#include <umbrage/core/snippet.hpp>
#include <umbrage/light/point/cube_map.hpp>

namespace umbrage {

/// Face of an atlas texel, and the texel's position on it.
/// @param texel   texel in 3 x 2 tiles, as cube_tile places them, integers
/// @param size    size of a tile, in texels, below 2^15
/// @return        (s, t, face), integers
/// @exactness     A: integers
template <real T>
[[nodiscard]] constexpr glm::vec<3, T> cube_atlas_texel(glm::vec<2, T> texel, T size) {
    const T column = texel.x < size ? T(0) : (texel.x < size * T(2) ? T(1) : T(2)), row = T(texel.y < size ? 0 : 1);
    return {texel.x - column * size, texel.y - row * size, column + row * T(3)};
}

/// Direction from the cube's center to the center of an atlas texel.
/// @param texel         as for cube_atlas_texel
/// @param size          as for cube_atlas_texel
/// @return              direction in half texels: its largest component is size or -size
/// @exactness           A: integers. -ffast-math may change a zero's sign
template <real T>
[[nodiscard]] constexpr glm::vec<3, T> cube_atlas_direction(glm::vec<2, T> texel, T size) {
    const glm::vec<3, T> part = cube_atlas_texel(texel, size);
    return cube_point(part.z, glm::vec<3, T>(part.x * T(2) + T(1) - size, part.y * T(2) + T(1) - size, size));
}

namespace glsl {

inline constexpr snippet cube_atlas_texel{
    .name = "cube_atlas_texel",
    .summary = "face of an atlas texel, and the position on it",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_cube_atlas_texel: (s, t, face) of a texel in an atlas of 3 x 2 tiles of size texels; integers
UMBRAGE_HIGHP vec3 umbrage_cube_atlas_texel(UMBRAGE_HIGHP vec2 texel, UMBRAGE_HIGHP float size) {
    UMBRAGE_HIGHP float column = texel.x < size ? 0.0 : (texel.x < size * 2.0 ? 1.0 : 2.0);
    UMBRAGE_HIGHP float row = texel.y < size ? 0.0 : 1.0;
    return vec3(texel - vec2(column, row) * size, column + row * 3.0);
}
)GLSL",
};

inline constexpr snippet cube_atlas_direction{
    .name = "cube_atlas_direction",
    .summary = "direction that reads an atlas texel from a cube texture",
    .exactness = tier::a,
    .needs = list<&cube_atlas_texel, &cube_point>,
    .source = R"GLSL(
// umbrage_cube_atlas_direction: direction from a cube's center to an atlas texel, for 3 x 2 tiles of size texels
UMBRAGE_HIGHP vec3 umbrage_cube_atlas_direction(UMBRAGE_HIGHP vec2 texel, UMBRAGE_HIGHP float size) {
    UMBRAGE_HIGHP vec3 part = umbrage_cube_atlas_texel(texel, size);
    UMBRAGE_HIGHP vec2 uv = vec2(part.x, part.y) * 2.0 + (1.0 - size);
    return umbrage_cube_point(part.z, vec3(uv, size));
}
)GLSL",
};

inline constexpr const snippet* cube_atlas_snippets[]{&cube_atlas_texel, &cube_atlas_direction};

}  // namespace glsl
}  // namespace umbrage
