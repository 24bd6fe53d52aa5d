// SPDX-License-Identifier: MIT
//
// Cascaded shadow maps (CSM) of a directional light, with up to eight cascades and one map per cascade.
// A receiver is looked up in the first map that holds it and its filter. Near that map's border the next map blends in,
// if it holds them too. Shadows of the last map fade to light at its border.
//
//     const auto cascades = umbrage::make_stable_cascades<4>(fit, splits);
//     umbrage::shadow sun(cascades, {1024, 1024}, umbrage::filters::tent<3>);
//     umbrage::shadow hard_changes(umbrage::cascaded_maps(cascades, 0.0f), {1024, 1024}, umbrage::filters::tent<3>);
//
#pragma once

#include <array>

#include <umbrage/bias/slope.hpp>
#include <umbrage/core/check.hpp>
#include <umbrage/core/lesser.hpp>
#include <umbrage/light/cascades/blend.hpp>
#include <umbrage/light/cascades/cascades.hpp>
#include <umbrage/light/cascades/select.hpp>
#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/shadow/set_up.hpp>

namespace umbrage {

namespace detail {

/// Uniforms of up to four cascades.
template <int Groups>
struct cascade_block {
    glm::mat4 rotation;         ///< rotation from the world to the light's axes
    glm::mat4 scales, offsets;  ///< one column per cascade, as for cascade_by_projection
    glm::vec4 blending{0};      ///< x: weight of the next cascade per texel, 1 / blend_texels; y: number of the last

    static constexpr uniform_field fields[]{{"rotation"}, {"scales"}, {"offsets"}, {"blending", false}};
    static constexpr std::string_view find = "cascade_by_projection(light, scales, offsets", column = "cascade_column";
    static constexpr std::string_view all_scales = "scales", all_offsets = "offsets";
    static constexpr const glsl::snippet &finder = glsl::cascade_by_projection, &picker = glsl::cascade_column;

    [[nodiscard]] glm::vec4 found(glm::vec3 light, const shadow_terms& terms) const {
        return cascade_by_projection(light, scales, offsets, terms.map_size, terms.reach);
    }
    [[nodiscard]] glm::vec4 scale(float number) const { return cascade_column(scales, number); }
    [[nodiscard]] glm::vec4 offset(float number) const { return cascade_column(offsets, number); }
    void set(glm::length_t i, glm::vec4 scale, glm::vec4 offset) { scales[i] = scale, offsets[i] = offset; }
};
/// Uniforms of five to eight cascades.
template <>
struct cascade_block<2> {
    glm::mat4 rotation, scales, offsets;        ///< columns of the first four cascades
    glm::mat4 farther_scales, farther_offsets;  ///< columns of the others
    glm::vec4 blending{0};

    static constexpr uniform_field fields[]{{"rotation"},       {"scales"},          {"offsets"},
                                            {"farther_scales"}, {"farther_offsets"}, {"blending", false}};
    static constexpr std::string_view find =
        "cascade_by_projection_8(light, scales, offsets, farther_scales, farther_offsets";
    static constexpr std::string_view column = "cascade_column_8";
    static constexpr std::string_view all_scales = "scales, farther_scales", all_offsets = "offsets, farther_offsets";
    static constexpr const glsl::snippet &finder = glsl::cascade_by_projection_8, &picker = glsl::cascade_column_8;

    [[nodiscard]] glm::vec4 found(glm::vec3 light, const shadow_terms& terms) const {
        return cascade_by_projection_8(light, scales, offsets, farther_scales, farther_offsets, terms.map_size,
                                       terms.reach);
    }
    [[nodiscard]] glm::vec4 scale(float number) const { return cascade_column_8(scales, farther_scales, number); }
    [[nodiscard]] glm::vec4 offset(float number) const { return cascade_column_8(offsets, farther_offsets, number); }
    void set(glm::length_t i, glm::vec4 scale, glm::vec4 offset) {
        (i < 4 ? scales : farther_scales)[i % 4] = scale, (i < 4 ? offsets : farther_offsets)[i % 4] = offset;
    }
};

}  // namespace detail

/// Setup of cascades.
/// @tparam Groups   number of groups of four cascades: 1 or 2
template <int Groups = 1>
struct cascaded_maps {
    std::vector<cascade<double>> cascades;
    float blend_texels;  ///< width of the band along a map's border in which the next one takes over; 0: no band

    /// @param all     cascades from near to far
    /// @param blend   width of the band in which two cascades blend, texels; 0: no band
    /// @throws std::invalid_argument  blend negative or not finite
    template <real T, std::size_t Count>
    explicit cascaded_maps(const std::array<cascade<T>, Count>& all, float blend = 16.0f) : blend_texels(blend) {
        static_assert(Count >= 1 && Count <= 8, "a shadow takes one to eight cascades");
        detail::require(is_finite(blend) && blend >= 0.0f, "cascaded_maps", "blend", "finite, 0 or more", blend);
        for (const cascade<T>& c : all)
            cascades.push_back({detail::in_double(c.light), glm::dvec4(c.scale), glm::dvec4(c.offset), double(c.begin),
                                double(c.end)});
    }

    using uniforms = detail::cascade_block<Groups>;
    static constexpr const auto& fields = uniforms::fields;
    static constexpr map_grid grid{2, 2 * Groups};
    static constexpr outside_map outside = outside_map::bordered;
    static constexpr glsl::map_choice tiles{true, glsl::cascade_tile.name, "vec2(terms.x, terms.y)"};

    /// @throws std::invalid_argument  no cascade, or more than there are maps
    [[nodiscard]] clip_space clip() const { return nearest().light.clip; }
    [[nodiscard]] std::vector<light_space<double>> lights() const {
        std::vector<light_space<double>> all;
        for (const cascade<double>& c : cascades) all.push_back(c.light);
        return all;
    }
    /// @throws std::invalid_argument  as clip()
    [[nodiscard]] uniforms make_uniforms(glm::ivec2, glm::dvec3 origin) const {
        const glm::dmat4 rotation = nearest().light.view;
        const glm::dvec3 start(rotation * glm::dvec4(origin, 1.0));
        uniforms u{};
        u.rotation = glm::mat4(glm::dmat4(glm::dmat3(rotation)));
        for (glm::length_t i = 0; i < 4 * Groups; ++i) {
            u.set(i, glm::vec4(0), {65536.0f, 65536.0f, 0.0f, 0.0f});  // a missing cascade holds no receiver
            if (i >= static_cast<glm::length_t>(cascades.size())) continue;
            const cascade<double>& c = cascades[static_cast<std::size_t>(i)];
            const glm::dvec3 offset = glm::dvec3(c.offset) + start * glm::dvec3(c.scale);
            u.set(i, glm::vec4(c.scale), glm::vec4(glm::dvec4(offset, 0.0)));
        }
        u.blending = {blend_texels > 0.0f ? 1.0f / blend_texels : 0.0f, static_cast<float>(cascades.size() - 1), 0, 0};
        return u;
    }

    template <class Look>
    [[nodiscard]] static float visibility(const uniforms& u, const shadow_terms& terms, glm::vec3 world,
                                          glm::vec3 normal, const Look& look) {
        const glm::vec3 light(shadow_coordinate(u.rotation, world)), across(shadow_coordinate(u.rotation, normal));
        const glm::vec4 found = u.found(light, terms);
        const float last = u.blending.y, number = found.w < last ? found.w : last;
        const glm::vec4 scale = u.scale(number);
        const float nearer = look(map_place{int(number), glm::vec3(found), cascade_slope(across, scale)});
        const float weight = u.blending.x > 0.0f && found.w <= last
                                 ? cascade_border_fade(glm::vec2(found), terms.map_size, terms.reach, u.blending.x)
                                 : 0.0f;
        if (!(weight > 0.0f)) return nearer;
        if (!(number < last)) return blend_cascades(nearer, 1.0f, weight);
        const float next = number + 1.0f;
        const glm::vec4 next_scale = u.scale(next);
        const glm::vec3 at = cascade_coordinate(light, next_scale, u.offset(next));
        if (!inside_cascade(at, terms.map_size, terms.reach)) return nearer;
        const float held = 1.0f - cascade_border_fade(glm::vec2(at), terms.map_size, terms.reach, u.blending.x);
        const float farther = look(map_place{int(next), at, cascade_slope(across, next_scale)});
        return blend_cascades(nearer, farther, detail::lesser(weight, held));
    }
    [[nodiscard]] static std::string text(const glsl::map_choice& choice) {
        const auto column = [](std::string_view all, std::string_view number) {
            return std::string("umbrage_").append(uniforms::column) + '(' + std::string(all) + ", " +
                   std::string(number) + ')';
        };
        return R"GLSL(
    UMBRAGE_HIGHP vec4 turned = umbrage_shadow_coordinate(rotation, world);
    UMBRAGE_HIGHP vec4 across = umbrage_shadow_coordinate(rotation, normal);
    UMBRAGE_HIGHP vec3 light = vec3(turned.x, turned.y, turned.z);
    UMBRAGE_HIGHP vec3 normal_there = vec3(across.x, across.y, across.z);
    UMBRAGE_HIGHP vec2 size = vec2(terms.x, terms.y);
    UMBRAGE_HIGHP vec4 found = umbrage_)GLSL" +
               std::string(uniforms::find) + R"GLSL(, size, terms.z);
    UMBRAGE_HIGHP float number = min(found.w, blending.y);
    UMBRAGE_HIGHP vec4 scale = )GLSL" +
               column(uniforms::all_scales, "number") + ";\n" + choice.first("number") +
               R"GLSL(    UMBRAGE_HIGHP vec2 slope = umbrage_cascade_slope(normal_there, scale);
    UMBRAGE_HIGHP float nearer = umbrage_look(map, terms, filter_terms, vec3(found.x, found.y, found.z), slope);
    UMBRAGE_HIGHP float border = umbrage_cascade_border_fade(vec2(found.x, found.y), size, terms.z, blending.x);
    UMBRAGE_HIGHP float weight = blending.x > 0.0 && found.w <= blending.y ? border : 0.0;
    bool last = number >= blending.y;
    UMBRAGE_HIGHP float next = min(number + 1.0, blending.y);
    UMBRAGE_HIGHP vec4 next_scale = )GLSL" +
               column(uniforms::all_scales, "next") + R"GLSL(;
    UMBRAGE_HIGHP vec3 at = umbrage_cascade_coordinate(light, next_scale, )GLSL" +
               column(uniforms::all_offsets, "next") + ");\n" + choice.again("next") +
               R"GLSL(
    UMBRAGE_HIGHP float fade = umbrage_cascade_border_fade(vec2(at.x, at.y), size, terms.z, blending.x);
    UMBRAGE_HIGHP float held = umbrage_inside_cascade(at, size, terms.z) ? 1.0 - fade : 0.0;
    weight = last ? weight : min(weight, held);
    UMBRAGE_HIGHP float farther = 1.0;
    if (weight > 0.0 && !last) {
        farther = umbrage_look(map, terms, filter_terms, at, umbrage_cascade_slope(normal_there, next_scale));
    }
    return weight > 0.0 ? umbrage_blend_cascades(nearer, farther, weight) : nearer;
)GLSL";
    }
    static constexpr const auto& needs =
        glsl::list<&glsl::shadow_coordinate, &uniforms::finder, &uniforms::picker, &glsl::cascade_slope,
                   &glsl::cascade_coordinate, &glsl::inside_cascade, &glsl::cascade_border_fade, &glsl::blend_cascades,
                   &glsl::cascade_tile>;

private:
    [[nodiscard]] const cascade<double>& nearest() const {
        detail::require(!cascades.empty() && cascades.size() <= 4 * Groups, "shadow", "light.cascades.size()",
                        Groups == 1 ? "from 1 to 4" : "from 1 to 8", cascades.size(),
                        "A setup that was moved from has none.");
        return cascades.front();
    }
};

template <real T, std::size_t Count>
cascaded_maps(const std::array<cascade<T>, Count>&, float = 16.0f) -> cascaded_maps<(Count > 4 ? 2 : 1)>;

/// Setup of an array of cascades.
template <real T, std::size_t Count>
struct set_up_for<std::array<cascade<T>, Count>> {
    using type = cascaded_maps<(Count > 4 ? 2 : 1)>;
};

}  // namespace umbrage
