// SPDX-License-Identifier: MIT
//
// From a world position to visibility: one directional light's map, four cascades, a page of an adaptive map. What
// cascades take more than one map: to load the ends, a comparison and an addition for each, an index into uniforms,
// which then come by vector loads with waits of their own, so that three rows of a matrix are cheaper than its four
// columns; a view depth interpolated, but not the depth buffer's; and where one rotation serves all, a product and a
// sum for each of three coordinates, which must not become one multiply-add.
#include "jobs.hpp"

#include <umbrage/filter/pcf/pcf_2x2.hpp>
#include <umbrage/light/adaptive/page_table.hpp>
#include <umbrage/light/cascades/select.hpp>
#include <umbrage/light/texture_matrix.hpp>

namespace bench {

namespace glsl = umbrage::glsl;

job cascades() {
    // World position x0, view depth x1.x.
    const std::string lights = R"GLSL(
layout(binding = 7) uniform lights {
    mat4 one, rotation, scales, offsets, each[4];
    layout(row_major) mat4 by_row[4];
    vec4 scale[4], offset[4];
    vec3 ends;
    vec2 region;
};
layout(binding = 3) uniform sampler2DArray maps;
)GLSL";
    const std::string number = "umbrage_cascade_by_depth(x1.x, ends)";
    const std::string buffered = "umbrage_cascade_by_depth(gl_FragCoord.z, ends)";
    const std::string rotated = "umbrage_shadow_coordinate(rotation, x0.xyz).xyz";
    const auto look_up = [&](std::string name, const std::string& type, const std::string& coordinate,
                             const std::string& where, const std::string& in_map = ", map_size, at.xy, at.z") {
        return shader{
            "umbrage",
            std::move(name),
            lights,
            {glsl::shadow_coordinate, glsl::project_coordinate, glsl::cascade_by_depth, glsl::cascade_column,
             glsl::cascade_coordinate, glsl::cascade_by_projection, glsl::cascade_tile, glsl::page_coordinate,
             glsl::pcf_2x2,
             bind(glsl::pcf_2x2, "layer", {.texture = glsl::texture::array, .outside = umbrage::outside_map::clamped}),
             bind(glsl::pcf_2x2, "tile", {.texture = glsl::texture::atlas})},
            "vec4(0.0); " + type + " at = " + coordinate + "; result = vec4(umbrage_pcf_2x2" + where + in_map + "))"};
    };
    const auto by_depth = [&](const std::string& scale, const std::string& offset) {
        return "umbrage_cascade_coordinate(" + rotated + ", " + scale + ", " + offset + ")";
    };
    const auto indexed = [&](const std::string& of) {
        return by_depth("scale[int(" + of + ")]", "offset[int(" + of + ")]");
    };
    const auto each = [&](const std::string& matrices, const std::string& of) {
        return "umbrage_shadow_coordinate(" + matrices + "[int(" + of + ")], x0.xyz).xyz";
    };
    const std::string unprojected = "umbrage_shadow_coordinate(one, x0.xyz).xyz";
    const std::string page = "umbrage_page_coordinate(table, vec2(1026.0), at.xy, 128.0, 4.0)";
    return {
        "2x2 PCF, from world to visibility",
        {look_up("one map", "vec3", "umbrage_project_coordinate(umbrage_shadow_coordinate(one, x0.xyz))", "(map"),
         look_up("one map, without the division", "vec3", unprojected, "(map"),
         look_up("one map, without the division, in an atlas", "vec3", unprojected, "_tile(map, region"),
         look_up("a page of an adaptive map", "vec3", unprojected + "; vec4 in_page = " + page, "_tile(map, in_page.zw",
                 ", vec2(136.0), in_page.xy, at.z"),
         look_up("cascades by depth, a matrix each", "vec3", each("each", number), "_layer(maps, " + number),
         look_up("cascades by the depth buffer's, a matrix each", "vec3", each("each", buffered),
                 "_layer(maps, " + buffered),
         look_up("cascades by depth, a matrix each, by row", "vec3", each("by_row", number), "_layer(maps, " + number),
         look_up("cascades by the depth buffer's, a matrix each, by row", "vec3", each("by_row", buffered),
                 "_layer(maps, " + buffered),
         look_up("cascades by depth", "vec3", indexed(number), "_layer(maps, " + number),
         look_up("cascades by the depth buffer's", "vec3", indexed(buffered), "_layer(maps, " + buffered),
         look_up("cascades by depth, in an atlas", "vec3", indexed(number),
                 "_tile(map, umbrage_cascade_tile(" + number + ", map_size * 0.5)"),
         look_up("cascades by depth, without an index", "vec3",
                 by_depth("umbrage_cascade_column(scales, " + number + ")",
                          "umbrage_cascade_column(offsets, " + number + ")"),
                 "_layer(maps, " + number),
         look_up("cascades by projection", "vec4",
                 "umbrage_cascade_by_projection(" + rotated + ", scales, offsets, map_size, 1.5)",
                 "_layer(maps, min(at.w, 3.0)")}};
}

}  // namespace bench
