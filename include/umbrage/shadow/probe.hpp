// SPDX-License-Identifier: MIT
//
// Debug view of a shadow. Its colors show texels, cascades and pages. A plain color shows each reason why a point
// cannot be shadowed. Use it to find out why a shadow is missing.
//
//     glm::vec3 color = umbrage::probe(sun, world, normal);
//
// bind(sun, "sun", {.debug = true}) gives a shader the same: umbrage_probe_sun(world, normal). See in_shader.hpp.
// Also called: shadow debug view, visualize cascades (probe).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include <umbrage/shadow/look.hpp>
#include <umbrage/shadow/shadow.hpp>
#include <umbrage/view/probe_color.hpp>

namespace umbrage {

/// Debug color of a world position under a shadow. Reads no map.
///
/// @param of              the shadow
/// @param world           position, as for the shadow
/// @param normal          normal, as for the shadow
/// @return      RGB in [0, 1]: colors of probe_color and probe_inputs. Blended cascades blend their colors. The last
///              one fades to white
/// @exactness   C, as project_coordinate; A for the color alone
template <class SetUp, class Filter, class Encoding>
[[nodiscard]] glm::vec3 probe(const shadow<SetUp, Filter, Encoding>& of, glm::vec3 world, glm::vec3 normal) {
    const auto uniforms = of.uniforms();
    glm::vec3 color(0);
    for (glm::length_t channel = 0; channel < 3; ++channel)
        color[channel] = SetUp::visibility(uniforms.maps, uniforms.terms, world, normal, [&](const map_place& place) {
            const float bias = detail::bias_of<Filter>(uniforms.terms, place.slope);
            const auto number = static_cast<float>(place.number);
            return probe_color(place.at, uniforms.terms.map_size, bias, number, of.encoding().direction)[channel];
        });
    return probe_inputs(color, world, normal);
}

namespace detail {

/// GLSL version of probe: umbrage_point_color, after the functions that it calls.
/// @param terms       declarations of shadow_terms
/// @param fields      declarations of the setup's uniforms
/// @param arguments   names of the setup's uniforms, for a call
template <class SetUp, class Filter>
[[nodiscard]] std::vector<glsl::own_text> probe_texts(const std::string& terms, const std::string& fields,
                                                      const std::string& arguments) {
    glsl::own_text place{"place_color",
                         "\n// umbrage_place_color: one channel of a receiver's debug color in one map\n"
                         "UMBRAGE_HIGHP float umbrage_place_color(UMBRAGE_HIGHP float number, " +
                             terms +
                             "UMBRAGE_HIGHP vec3 at, UMBRAGE_HIGHP vec2 slope, UMBRAGE_HIGHP float channel) {\n" +
                             bias_text<Filter>() +
                             "    UMBRAGE_HIGHP vec3 color = umbrage_probe_color(at, vec2(terms.x, terms.y), bias, "
                             "number);\n"
                             "    UMBRAGE_HIGHP float later = channel < 1.5 ? color.y : color.z;\n"
                             "    return channel < 0.5 ? color.x : later;\n}\n",
                         {&bias_snippet<Filter>(), &glsl::probe_color}};
    std::string body = with_argument(SetUp::text(glsl::map_choice{}), "channel");
    const std::string number = SetUp::grid.columns * SetUp::grid.rows > 1 ? "layer" : "0.0";
    const std::string_view look = "umbrage_look(map";
    for (auto i = body.find(look); i != body.npos; i = body.find(look))
        body.replace(i, look.size(), "umbrage_place_color(" + number);
    glsl::own_text channel{"channel_color",
                           "\n// umbrage_channel_color: one channel of a point's debug color\n"
                           "UMBRAGE_HIGHP float umbrage_channel_color(" +
                               fields + terms +
                               "UMBRAGE_HIGHP vec3 world, UMBRAGE_HIGHP vec3 normal, UMBRAGE_HIGHP float channel) {" +
                               body + "}\n"};
    channel.needs.assign(std::begin(SetUp::needs), std::end(SetUp::needs));
    const std::string of = "umbrage_channel_color(" + arguments + "terms, filter_terms, world, normal, ";
    return {std::move(place),
            std::move(channel),
            {"point_color",
             "\n// umbrage_point_color: debug color of a point of the world\n"
             "UMBRAGE_HIGHP vec3 umbrage_point_color(" +
                 fields + terms +
                 "UMBRAGE_HIGHP vec3 world, UMBRAGE_HIGHP vec3 normal) {\n"
                 "    UMBRAGE_HIGHP vec3 color = vec3(" +
                 of + "0.0), " + of + "1.0), " + of + "2.0));\n" +
                 "    return umbrage_probe_inputs(color, world, normal);\n}\n",
             {&glsl::cleared_depth, &glsl::probe_inputs}}};
}

}  // namespace detail
}  // namespace umbrage
