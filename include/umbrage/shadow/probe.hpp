// SPDX-License-Identifier: MIT
//
// Debug view of a shadow. Its colors show texels, cascades and pages. A plain color shows each reason why a point
// cannot be shadowed. Use it to find out why a shadow is missing.
//
//     glm::vec3 color = umbrage::probe(sun, world, normal);
//
// `bind(sun, "sun", {.debug = true})` gives a shader the same: `umbrage_probe_sun(world, normal)`. See in_shader.hpp.
// Also called: shadow debug view, visualize cascades (probe).
#pragma once

#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include <umbrage/debug/probe_color.hpp>
#include <umbrage/light/cascades/blend.hpp>
#include <umbrage/shadow/frame.hpp>
#include <umbrage/shadow/lookup.hpp>
#include <umbrage/shadow/shadow.hpp>

namespace umbrage {

/// Debug color of a world position under a shadow. Reads no map.
///
/// @param of              the shadow
/// @param world           position, as for the shadow
/// @param normal          normal, as for the shadow
/// @return      RGB in [0, 1]: colors of probe_color and probe_inputs. Blended cascades blend their colors. The last
///              one fades to white
/// @exactness   C, as project_coordinate; A for the color alone
template <class Setup, class Filter, class Encoding>
[[nodiscard]] glm::vec3 probe(const shadow<Setup, Filter, Encoding>& of, glm::vec3 world, glm::vec3 normal) {
    const auto uniforms = of.uniforms();
    const auto places = Setup::places(uniforms.maps, uniforms.terms, world, normal);
    const glm::vec3 color = detail::blended(places, [&](const map_place& place) {
        const float bias = detail::bias_of<Setup, Filter>(uniforms.terms, place);
        const auto number = static_cast<float>(place.number);
        return probe_color(place.at, uniforms.terms.map_size, bias, number, of.encoding().direction);
    });
    return probe_inputs(color, world, normal);
}

namespace detail {

/// GLSL version of probe: umbrage_point_color, after the functions that it calls.
template <class Setup, class Filter>
[[nodiscard]] std::vector<glsl::own_text> probe_texts(frame_words w) {
    w.pixel = {}, w.of_pixel = {};
    const std::string terms = "UMBRAGE_HIGHP vec4 terms, UMBRAGE_HIGHP vec4 filter_terms, ";
    const frame_result color{.head =
                                 "\n// umbrage_blended_color: debug color of a point of the world\n"
                                 "UMBRAGE_HIGHP vec3 umbrage_blended_color(",
                             .type = "vec3",
                             .lit = "vec3(1.0, 1.0, 1.0)",
                             .look = "umbrage_place_color(terms, filter_terms, at, vec3(slope.x, slope.y, slope.w))",
                             .blend =
                                 "vec3(umbrage_blend_cascades(sum.x, next.x, weight), "
                                 "umbrage_blend_cascades(sum.y, next.y, weight), "
                                 "umbrage_blend_cascades(sum.z, next.z, weight))"};
    std::vector<const glsl::snippet*> calls{&glsl::probe_color};
    if (!along_plane<Setup, Filter>) calls.push_back(&kernel_bias_snippet<Filter>());
    return {{"place_color",
             "\n// umbrage_place_color: a receiver's debug color in one map\n"
             "UMBRAGE_HIGHP vec3 umbrage_place_color(" +
                 terms + "UMBRAGE_HIGHP vec4 at, UMBRAGE_HIGHP vec3 slope) {\n" + bias_text<Setup, Filter>() +
                 (along_plane<Setup, Filter> ? "    UMBRAGE_HIGHP float taken = is_seen ? bias : 1.0;\n" : "") +
                 "    return umbrage_probe_color(vec3(at.x, at.y, at.z), vec2(terms.x, terms.y), " +
                 (along_plane<Setup, Filter> ? "taken" : "bias") + ", at.w);\n}\n",
             calls},
            {"blended_color", frame_text(color, w, {}), w.needs()},
            {"point_color",
             "\n// umbrage_point_color: debug color of a point of the world, or what is wrong with it\n"
             "UMBRAGE_HIGHP vec3 umbrage_point_color(" +
                 w.fields + terms +
                 "UMBRAGE_HIGHP vec3 world, UMBRAGE_HIGHP vec3 normal) {\n"
                 "    UMBRAGE_HIGHP vec3 color = umbrage_blended_color(" +
                 w.names +
                 "terms, filter_terms, world, normal);\n"
                 "    return umbrage_probe_inputs(color, world, normal);\n}\n",
             {&glsl::cleared_depth, &glsl::probe_inputs}}};
}

}  // namespace detail
}  // namespace umbrage
