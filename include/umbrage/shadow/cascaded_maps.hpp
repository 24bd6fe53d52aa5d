// SPDX-License-Identifier: MIT
//
// Cascaded shadow maps (CSM) of a directional light, with up to eight cascades and one map per cascade.
// A receiver is looked up in the first map that holds it and its filter. The next map blends in near that map's border,
// if it holds the receiver too. Shadows of the last map fade to light at its border.
//
//     const auto cascades = umbrage::make_stable_cascades<4>(fit, splits);
//     umbrage::shadow sun(cascades, fit.map_size, umbrage::filters::tent<3>);
//     umbrage::shadow hard_changes(umbrage::cascaded_maps(cascades, 0.0f), fit.map_size, umbrage::filters::tent<3>);
//
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <glm/common.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/core/config.hpp>
#include <umbrage/light/cascades/cascades.hpp>
#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/shadow/anchored_map.hpp>
#include <umbrage/shadow/cascade_choice.hpp>
#include <umbrage/shadow/cascade_places.hpp>
#include <umbrage/shadow/setup.hpp>

namespace umbrage {

namespace detail {

/// Uniforms of up to four cascades.
template <int Groups>
struct cascade_block {
    glm::mat4 rotation;         ///< rotation from the world to the light's axes
    glm::mat4 scales, offsets;  ///< one column per cascade; w: slack of a plane, in texels of slope and in depth
    glm::vec4 anchor{0};        ///< xyz: middle of the last map
    glm::vec4 blending{0};      ///< x: weight of the next cascade per texel, 1 / blend_texels; y: number of the last

    static constexpr uniform_field fields[]{
        {"rotation"}, {"scales"}, {"offsets"}, {"anchor", false}, {"blending", false}};
    static constexpr choice_function choosing{&glsl::cascaded_maps_choice,
                                              "rotation, scales, offsets, anchor, blending, terms, "};
    static constexpr const glsl::snippet* placing = &glsl::cascaded_maps_place;

    [[nodiscard]] UMBRAGE_INLINE std::array<map_place, 2> places(const shadow_terms& terms, glm::vec3 world,
                                                                 glm::vec3 normal) const {
        const glm::vec2 choice = cascaded_maps_choice(rotation, scales, offsets, anchor, blending, terms, world);
        return chosen_places(choice, [&](float number) UMBRAGE_INLINE {
            return cascaded_maps_place(rotation, scales, offsets, anchor, blending, terms, world, normal, number);
        });
    }
    void set(glm::length_t i, glm::vec4 scale, glm::vec4 offset) { scales[i] = scale, offsets[i] = offset; }
};
/// Uniforms of five to eight cascades.
template <>
struct cascade_block<2> {
    glm::mat4 rotation, scales, offsets;        ///< columns of the first four cascades
    glm::mat4 farther_scales, farther_offsets;  ///< columns of the others
    glm::vec4 anchor{0}, blending{0};

    static constexpr uniform_field fields[]{{"rotation"},       {"scales"},          {"offsets"},
                                            {"farther_scales"}, {"farther_offsets"}, {"anchor", false},
                                            {"blending", false}};
    static constexpr choice_function choosing{
        &glsl::cascaded_maps_choice_8,
        "rotation, scales, offsets, farther_scales, farther_offsets, anchor, blending, terms, "};
    static constexpr const glsl::snippet* placing = &glsl::cascaded_maps_place_8;

    [[nodiscard]] UMBRAGE_INLINE std::array<map_place, 2> places(const shadow_terms& terms, glm::vec3 world,
                                                                 glm::vec3 normal) const {
        const glm::vec2 choice = cascaded_maps_choice_8(rotation, scales, offsets, farther_scales, farther_offsets,
                                                        anchor, blending, terms, world);
        return chosen_places(choice, [&](float number) UMBRAGE_INLINE {
            return cascaded_maps_place_8(rotation, scales, offsets, farther_scales, farther_offsets, anchor, blending,
                                         terms, world, normal, number);
        });
    }
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
    /// @throws std::invalid_argument  blend negative, not finite, or without a finite inverse
    template <real T, std::size_t Count>
    explicit cascaded_maps(const std::array<cascade<T>, Count>& all, float blend = 16.0f) : blend_texels(blend) {
        static_assert(Count >= 1 && Count <= 8, "a shadow takes one to eight cascades");
        detail::require(blend == 0.0f || (is_finite(blend) && blend > 0.0f && is_finite(1.0f / blend)), "cascaded_maps",
                        "blend", "0, or above 0, finite and with a finite inverse", blend);
        for (const cascade<T>& c : all)
            cascades.push_back({detail::in_double(c.light), glm::dvec4(c.scale), glm::dvec4(c.offset), double(c.begin),
                                double(c.end), c.map_size});
    }

    using uniforms = detail::cascade_block<Groups>;
    static constexpr const auto& fields = uniforms::fields;
    static constexpr map_grid grid{2, 2 * Groups};
    static constexpr outside_map outside = outside_map::bordered;

    /// @throws std::invalid_argument  no cascade, or more than there are maps
    [[nodiscard]] clip_space clip() const { return nearest().light.clip; }
    [[nodiscard]] std::vector<light_space<double>> lights() const {
        std::vector<light_space<double>> all;
        for (const cascade<double>& c : cascades) all.push_back(c.light);
        return all;
    }
    /// @throws std::invalid_argument  as clip(); a map_size other than that of the cascades' fit; a light too far from
    ///                                the origin
    [[nodiscard]] uniforms make_uniforms(glm::ivec2 map_size, glm::dvec3 origin) const {
        const glm::dmat3 rotation(nearest().light.view);
        for (const cascade<double>& c : cascades)
            detail::require_size(map_size, c.map_size, "shadow", "map_size", "cascade_fit.map_size");
        const auto in_texels = [&](const cascade<double>& c) {
            return texture_matrix(detail::relative_to(origin, c.light), map_size);
        };
        uniforms u{};
        u.rotation = glm::mat4(glm::dmat4(rotation));
        const glm::dvec3 anchor = detail::in_binary32(detail::anchor_of(in_texels(cascades.back()), map_size));
        u.anchor = glm::vec4(glm::vec3(anchor), 0.0f);
        u.blending = {blend_texels > 0.0f ? 1.0f / blend_texels : 0.0f, static_cast<float>(cascades.size() - 1), 0, 0};
        for (glm::length_t i = 0; i < 4 * Groups; ++i) {
            u.set(i, glm::vec4(0), {65536.0f, 65536.0f, 0.0f, 0.0f});  // a missing cascade holds no receiver
            if (i >= static_cast<glm::length_t>(cascades.size())) continue;
            const cascade<double>& c = cascades[static_cast<std::size_t>(i)];
            // Scale and offset by the light's matrices, which draw the map. In float they round away from the
            // cascade's own.
            const glm::dmat4 m = detail::moved_to(in_texels(c), anchor);
            const glm::dmat3 scale = glm::dmat3(m) * glm::transpose(rotation);
            const glm::dvec4 error = detail::rounding_of(m, map_size, anchor);
            const double texels = detail::texels_beside_plane(c.light.clip, map_size) + error.z,
                         depth = 6.0 * detail::one_rounding + error.w + detail::width_in_depth(m, map_size);
            u.set(i, glm::vec4(glm::dvec4(scale[0][0], scale[1][1], scale[2][2], texels)),
                  glm::vec4(glm::dvec4(glm::dvec3(m[3]), depth)));
        }
        return u;
    }

    [[nodiscard]] UMBRAGE_INLINE static std::array<map_place, 2> places(const uniforms& u, const shadow_terms& terms,
                                                                        glm::vec3 world, glm::vec3 normal) {
        return u.places(terms, world, normal);
    }
    static constexpr choice_function choosing = uniforms::choosing;
    static constexpr const glsl::snippet* placing = uniforms::placing;

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
struct setup_for<std::array<cascade<T>, Count>> {
    using type = cascaded_maps<(Count > 4 ? 2 : 1)>;
};

}  // namespace umbrage
