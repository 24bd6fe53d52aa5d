// SPDX-License-Identifier: MIT
//
// Selection of a receiver's cascade, by depth or by projection, and its coordinate there. One rotation serves all
// cascades, and each has a scale and an offset.
//
//     glm::vec3 light(umbrage::shadow_coordinate(u.rotation, world));
//     float number = umbrage::cascade_by_depth(view_depth, u.ends);
//     glm::vec3 at = umbrage::cascade_coordinate(light, umbrage::cascade_column(u.scales, number),
//                                                umbrage::cascade_column(u.offsets, number));
//     float visibility = umbrage::pcf_2x2(umbrage::bordered(maps[int(number)]), glm::vec2(at), at.z - bias);
//
// In shaders the number is the layer of an array, or selects a tile of an atlas. Uniform arrays can replace
// `cascade_column` if they accept an index that differs per pixel. The cheapest uniform is then one texture matrix per
// cascade, in place of rotation, scale and offset. Round it from double, so that stable cascades stay stable.
// Store it by rows: the shader then loads three rows, not four columns.
//
//     layout(std140, row_major) uniform cascades { mat4 to_texels[4]; vec3 ends; };
//     vec3 at = umbrage_shadow_coordinate(to_texels[int(number)], world).xyz;
//
// With five to eight cascades, from `grouped_cascade_uniforms`:
//
//     float number = 0;
//     for (const glm::vec3& ends : u.ends) number += umbrage::cascade_by_depth(view_depth, ends);
//     glm::vec4 scale = umbrage::cascade_column_8(u.scales[0], u.scales[1], number);
//
// Also called: cascade index, cascade selection (cascade_by_depth, cascade_by_projection); five or more cascades
// (cascade_by_projection_8, cascade_column_8).
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/core/scalar.hpp>
#include <umbrage/core/snippet.hpp>

namespace umbrage {

/// Cascade that contains a distance from the camera.
/// @param depth   distance along the camera's axis, or any value that grows with it and has matching ends. In shaders
///                gl_FragCoord.z costs nothing
/// @param ends    ends of the first cascades but not of the last, increasing; infinity for a missing cascade
/// @return        0 to 3. With more cascades, add the results for all groups of three ends
/// @edge          NaN depth: 0
/// @exactness     A: comparisons
template <real T>
[[nodiscard]] constexpr T cascade_by_depth(T depth, glm::vec<3, T> ends) {
    const auto reaches = [depth](T end) { return !is_nan(depth) && depth >= end; };
    return T(int(reaches(ends.x)) + int(reaches(ends.y)) + int(reaches(ends.z)));
}

/// One of four columns.
/// @param columns  scales or offsets of the cascades, one a column
/// @param number   index of the column, 0 to 3
/// @edge           above 3: the last column
/// @exactness      A
template <real T>
[[nodiscard]] constexpr glm::vec<4, T> cascade_column(const glm::mat<4, 4, T>& columns, T number) {
    return number < T(1.5) ? (number < T(0.5) ? columns[0] : columns[1]) : (number < T(2.5) ? columns[2] : columns[3]);
}

/// Position of a point in one cascade's map.
/// @param light           the point, rotated into the light's axes
/// @param scale           scale of the cascade, see cascade; its w is not used
/// @param offset          offset of the cascade; its w is not used
/// @return                x and y in texels, z depth, ready for a filter without a division
/// @formula               light scale + offset
/// @exactness             B, n = 2: a product and a sum each
template <real T>
[[nodiscard]] constexpr glm::vec<3, T> cascade_coordinate(glm::vec<3, T> light, glm::vec<4, T> scale,
                                                          glm::vec<4, T> offset) {
    return {light.x * scale.x + offset.x, light.y * scale.y + offset.y, light.z * scale.z + offset.z};
}

/// True if a filter at a coordinate stays inside the map, between the near and the far plane.
/// @param coordinate   position in the cascade's map: texels, texels, depth
/// @param size         size of the map, in texels
/// @param reach        filter radius, in texels
/// @exactness          B, n = 2, S = size + reach: differences, exact where size and reach are multiples of 1/16
template <real T>
[[nodiscard]] constexpr bool inside_cascade(glm::vec<3, T> coordinate, glm::vec<2, T> size, T reach) {
    const auto within = [](T low, T v, T high) { return !is_nan(v) && v >= low && v <= high; };
    return within(reach, coordinate.x, size.x - reach) && within(reach, coordinate.y, size.y - reach) &&
           within(T(0), coordinate.z, T(1));
}

/// Finest cascade that contains a point and the filter around it, which is the first, and the position there.
/// @param light            the point, rotated into the light's axes
/// @param scales           columns of four cascades, as for cascade_coordinate; fewer: see make_cascade_uniforms
/// @param offsets          columns of the same cascades
/// @param size             size of each map, in texels
/// @param reach            filter radius, in texels
/// @return                 (x, y) in texels, depth, index of the cascade
/// @edge                   no cascade contains it: (65536, 65536, 0, 4), which filters take as lit. Shaders read a
///                         texel even then, so use an existing layer: min(number, 3)
/// @exactness              B, n = 4: S as cascade_coordinate and inside_cascade
template <real T>
[[nodiscard]] constexpr glm::vec<4, T> cascade_by_projection(glm::vec<3, T> light, const glm::mat<4, 4, T>& scales,
                                                             const glm::mat<4, 4, T>& offsets, glm::vec<2, T> size,
                                                             T reach) {
    for (glm::length_t i = 0; i < 4; ++i) {
        const glm::vec<3, T> at = cascade_coordinate(light, scales[i], offsets[i]);
        if (inside_cascade(at, size, reach)) return {at.x, at.y, at.z, T(i)};
    }
    return {T(65536), T(65536), T(0), T(4)};
}

/// One of eight columns, for five to eight cascades: see grouped_cascade_uniforms.
/// @param nearer            columns 0 to 3
/// @param farther           columns 4 to 7
/// @param number            index of the column, 0 to 7
/// @edge                    above 7: the last column
/// @exactness               A
template <real T>
[[nodiscard]] constexpr glm::vec<4, T> cascade_column_8(const glm::mat<4, 4, T>& nearer,
                                                        const glm::mat<4, 4, T>& farther, T number) {
    return number < T(3.5) ? cascade_column(nearer, number) : cascade_column(farther, number - T(4));
}

/// cascade_by_projection for up to eight cascades, in groups of four.
/// @edge          no cascade contains the point: number 8. Shaders read layer min(number, 7)
/// @exactness     B, n = 5: S as cascade_coordinate and inside_cascade
template <real T>
[[nodiscard]] constexpr glm::vec<4, T> cascade_by_projection_8(glm::vec<3, T> light, const glm::mat<4, 4, T>& scales,
                                                               const glm::mat<4, 4, T>& offsets,
                                                               const glm::mat<4, 4, T>& farther_scales,
                                                               const glm::mat<4, 4, T>& farther_offsets,
                                                               glm::vec<2, T> size, T reach) {
    const glm::vec<4, T> nearer = cascade_by_projection(light, scales, offsets, size, reach);
    if (nearer.w < T(4)) return nearer;
    const glm::vec<4, T> farther = cascade_by_projection(light, farther_scales, farther_offsets, size, reach);
    return {farther.x, farther.y, farther.z, farther.w + T(4)};
}

/// First texel of a cascade in an atlas with two tiles per row.
/// @param number   index of the cascade, an integer >= 0
/// @param size     size of a tile, in texels. The atlas has sides below 2^31
/// @exactness      A
[[nodiscard]] inline glm::ivec2 cascade_tile(int number, glm::ivec2 size) {
    return glm::ivec2(number % 2, number / 2) * size;
}

namespace glsl {

inline constexpr snippet cascade_by_depth{
    .name = "cascade_by_depth",
    .summary = "cascade that contains a view depth",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_cascade_by_depth: cascade that contains a distance along the camera's axis, 0.0 to 3.0
//   ends  ends of the first three cascades, increasing
UMBRAGE_HIGHP float umbrage_cascade_by_depth(UMBRAGE_HIGHP float depth, UMBRAGE_HIGHP vec3 ends) {
    UMBRAGE_HIGHP int reached = int(depth >= ends.x) + int(depth >= ends.y) + int(depth >= ends.z);
    return float(reached);
}
)GLSL",
};

inline constexpr snippet cascade_column{
    .name = "cascade_column",
    .summary = "one of four columns, without dynamic indexing",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_cascade_column: column of a matrix by its index, 0.0 to 3.0, for languages without dynamic indexing
UMBRAGE_HIGHP vec4 umbrage_cascade_column(UMBRAGE_HIGHP mat4 columns, UMBRAGE_HIGHP float number) {
    UMBRAGE_HIGHP vec4 low = number < 0.5 ? columns[0] : columns[1];
    UMBRAGE_HIGHP vec4 high = number < 2.5 ? columns[2] : columns[3];
    return number < 1.5 ? low : high;
}
)GLSL",
};

inline constexpr snippet cascade_coordinate{
    .name = "cascade_coordinate",
    .summary = "position of a point in one cascade's map",
    .exactness = tier::b,
    .operations = 2,
    .source = R"GLSL(
// umbrage_cascade_coordinate: position in a cascade's map, texels and depth, of a point rotated into the light's axes
UMBRAGE_HIGHP vec3 umbrage_cascade_coordinate(UMBRAGE_HIGHP vec3 light, UMBRAGE_HIGHP vec4 scale,
                                              UMBRAGE_HIGHP vec4 offset) {
    UMBRAGE_HIGHP vec3 start = vec3(offset.x, offset.y, offset.z);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec3 at = light * vec3(scale.x, scale.y, scale.z) + start;
    return at;
}
)GLSL",
};

inline constexpr snippet inside_cascade{
    .name = "inside_cascade",
    .summary = "true if a filter stays inside a cascade",
    .exactness = tier::b,
    .operations = 2,
    .source = R"GLSL(
// umbrage_inside_cascade: true if a filter of radius reach at a coordinate stays inside a map of size texels
bool umbrage_inside_cascade(UMBRAGE_HIGHP vec3 coordinate, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP float reach) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 end = size - reach;
    // y is doubled because Mesa turns two comparisons with one limit into min(x, y) >= reach, which loses a NaN
    bool in_x = coordinate.x >= reach && coordinate.x <= end.x;
    bool in_y = coordinate.y * 2.0 >= reach * 2.0 && coordinate.y * 2.0 <= end.y * 2.0;
    return in_x && in_y && coordinate.z >= 0.0 && coordinate.z <= 1.0;
}
)GLSL",
};

inline constexpr snippet cascade_by_projection{
    .name = "cascade_by_projection",
    .summary = "first cascade that contains a point and its filter",
    .exactness = tier::b,
    .operations = 4,
    .needs = list<&cascade_coordinate, &inside_cascade>,
    .source = R"GLSL(
// umbrage_cascade_by_projection: (texels, texels, depth, index) in the first of four cascades that contains a point
//   and its filter; if there is none, index 4.0 and a coordinate that every filter takes as lit
//   light            the point, rotated into the light's axes
//   scales, offsets  scales and offsets of the cascades
//   size             size of each map, in texels
//   reach            filter radius, in texels
UMBRAGE_HIGHP vec4 umbrage_cascade_by_projection(UMBRAGE_HIGHP vec3 light, UMBRAGE_HIGHP mat4 scales,
                                                 UMBRAGE_HIGHP mat4 offsets, UMBRAGE_HIGHP vec2 size,
                                                 UMBRAGE_HIGHP float reach) {
    UMBRAGE_HIGHP vec3 a = umbrage_cascade_coordinate(light, scales[0], offsets[0]);
    UMBRAGE_HIGHP vec3 b = umbrage_cascade_coordinate(light, scales[1], offsets[1]);
    UMBRAGE_HIGHP vec3 c = umbrage_cascade_coordinate(light, scales[2], offsets[2]);
    UMBRAGE_HIGHP vec3 d = umbrage_cascade_coordinate(light, scales[3], offsets[3]);
    UMBRAGE_HIGHP vec4 found = vec4(65536.0, 65536.0, 0.0, 4.0);
    found = umbrage_inside_cascade(d, size, reach) ? vec4(d, 3.0) : found;
    found = umbrage_inside_cascade(c, size, reach) ? vec4(c, 2.0) : found;
    found = umbrage_inside_cascade(b, size, reach) ? vec4(b, 1.0) : found;
    return umbrage_inside_cascade(a, size, reach) ? vec4(a, 0.0) : found;
}
)GLSL",
};

inline constexpr snippet cascade_column_8{
    .name = "cascade_column_8",
    .summary = "one of eight columns, without dynamic indexing",
    .exactness = tier::a,
    .needs = list<&cascade_column>,
    .source = R"GLSL(
// umbrage_cascade_column_8: column of two matrices by its index, 0.0 to 7.0
UMBRAGE_HIGHP vec4 umbrage_cascade_column_8(UMBRAGE_HIGHP mat4 nearer, UMBRAGE_HIGHP mat4 farther,
                                            UMBRAGE_HIGHP float number) {
    UMBRAGE_HIGHP vec4 low = umbrage_cascade_column(nearer, number);
    UMBRAGE_HIGHP vec4 high = umbrage_cascade_column(farther, number - 4.0);
    return number < 3.5 ? low : high;
}
)GLSL",
};

inline constexpr snippet cascade_by_projection_8{
    .name = "cascade_by_projection_8",
    .summary = "first of eight cascades that contains a point and its filter",
    .exactness = tier::b,
    .operations = 5,
    .needs = list<&cascade_by_projection>,
    .source = R"GLSL(
// umbrage_cascade_by_projection_8: umbrage_cascade_by_projection for eight cascades, four and four; index 8.0 for none
UMBRAGE_HIGHP vec4 umbrage_cascade_by_projection_8(UMBRAGE_HIGHP vec3 light, UMBRAGE_HIGHP mat4 scales,
                                                   UMBRAGE_HIGHP mat4 offsets, UMBRAGE_HIGHP mat4 farther_scales,
                                                   UMBRAGE_HIGHP mat4 farther_offsets, UMBRAGE_HIGHP vec2 size,
                                                   UMBRAGE_HIGHP float reach) {
    UMBRAGE_HIGHP vec4 nearer = umbrage_cascade_by_projection(light, scales, offsets, size, reach);
    UMBRAGE_HIGHP vec4 farther = umbrage_cascade_by_projection(light, farther_scales, farther_offsets, size, reach);
    return nearer.w < 3.5 ? nearer : vec4(farther.x, farther.y, farther.z, farther.w + 4.0);
}
)GLSL",
};

inline constexpr snippet cascade_tile{
    .name = "cascade_tile",
    .summary = "first texel of a cascade in an atlas",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_cascade_tile: first texel of a cascade in an atlas with two tiles of size texels per row
UMBRAGE_HIGHP vec2 umbrage_cascade_tile(UMBRAGE_HIGHP float number, UMBRAGE_HIGHP vec2 size) {
    UMBRAGE_HIGHP float row = floor(number * 0.5);
    return vec2(number - row * 2.0, row) * size;
}
)GLSL",
};

inline constexpr const snippet* select_snippets[]{&cascade_by_depth,        &cascade_column, &cascade_column_8,
                                                  &cascade_coordinate,      &inside_cascade, &cascade_by_projection,
                                                  &cascade_by_projection_8, &cascade_tile};

}  // namespace glsl
}  // namespace umbrage
