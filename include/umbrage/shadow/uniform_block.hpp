// SPDX-License-Identifier: MIT
//
// Uniform block of a shadow: the numbers of its setup, filter and encoding that the lookup reads, in C++ and in
// shaders.
#pragma once

#include <array>
#include <cstddef>
#include <cstring>
#include <span>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/core/scalar.hpp>
#include <umbrage/shadow/lookup.hpp>
#include <umbrage/shadow/map_slack.hpp>
#include <umbrage/shadow/setup.hpp>
#include <umbrage/shadow/softness.hpp>

namespace umbrage {

/// Uniform block of a shadow's shader: copy its bytes into the buffer.
/// @tparam Matrices   matrices with the softness of each map, eight maps a matrix, and one of warps (softness.hpp)
template <shadow_setup Setup, int Matrices = 0>
struct shadow_uniforms {
    typename Setup::uniforms maps;
    std::array<glm::mat4, std::size_t(Matrices)> softness;
    shadow_terms terms;
};
template <shadow_setup Setup>
struct shadow_uniforms<Setup, 0> {
    typename Setup::uniforms maps;
    shadow_terms terms;
};

namespace detail {

/// Refuses uniforms that are infinite or NaN in float.
inline void require_finite_uniforms(std::span<const float> uniforms) {
    for (const float number : uniforms)
        require(is_finite(number), "shadow", "light, filter and origin", "such that all uniforms are finite in float",
                number, "Tiny near planes and huge coordinates overflow.");
}

/// Terms at the end of a uniform block, from a filter and the error of its map's depths.
template <class Filter>
[[nodiscard]] shadow_terms make_shadow_terms(glm::ivec2 map_size, const Filter& filter, decoding_error off,
                                             clip_space clip, bent_lines bends) {
    const float more = static_cast<float>(texels_moved(clip, map_size)) + bends.reach;
    // acne_free_bias adds 2^-23 for the rounding of depths, which a place's `slack` already has.
    const double added = point_filter<Filter> && bends.reach == 0.0f ? 0.0 : 0x1p-23;
    const double error = (clip.direction == depth_direction::forward ? off.below : off.above) - added;
    return {glm::vec2(map_size), reach_of(filter) + more, static_cast<float>(error) + bends.error,
            terms_of(filter, more)};
}

/// Uniform block of a shadow.
/// @param off   error of its map's depths
template <shadow_setup Setup, class Filter>
[[nodiscard]] auto make_shadow_uniforms(const Setup& setup, glm::ivec2 map_size, const Filter& filter,
                                        decoding_error off, glm::dvec3 origin) {
    constexpr int matrices = softness_matrices<Setup, Filter>;
    shadow_uniforms<Setup, matrices> all{};
    all.maps = setup.make_uniforms(map_size, origin);
    all.terms = make_shadow_terms(map_size, filter, off, setup.clip(), bends_of<Setup>);
    if constexpr (contact_hardening<Filter>) {
        const auto each = softness_of_maps(setup, map_size, softness_of(filter).light_size);
        all.terms.filter_terms.x = each.front().x;
        all.terms.filter_terms.y = each.front().y;
        if constexpr (!has_like_maps<Setup>) std::memcpy(&all.softness, each.data(), each.size() * sizeof(glm::vec2));
        if constexpr (has_warps<Setup>) all.softness.back() = warps_of(setup, map_size);
    }
    std::array<float, sizeof all / sizeof(float)> numbers;
    std::memcpy(numbers.data(), &all, sizeof all);
    require_finite_uniforms(numbers);
    return all;
}

/// Filter for one map. Contact hardening gets the softness of that map: that of its first texel if it is warped, and
/// that of face 0 in a tetrahedron's.
template <class Setup, class Filter>
[[nodiscard]] Filter filter_of_map(const Filter& filter,
                                   const shadow_uniforms<Setup, softness_matrices<Setup, Filter>>& uniforms,
                                   [[maybe_unused]] int number) {
    if constexpr (!contact_hardening<Filter>) return filter;
    else if constexpr (matrices_of_maps<Setup> == 0)
        return with_per_code(filter, glm::vec2(uniforms.terms.filter_terms));
    else {
        const glm::mat4& eight = uniforms.softness[static_cast<std::size_t>(number) / 8];
        return with_per_code(filter, map_softness(eight, static_cast<float>(number % 8)));
    }
}

}  // namespace detail
}  // namespace umbrage
