// SPDX-License-Identifier: MIT
//
// Uniforms of a setup as programs get them wrong: members by their names, or those of another map, size or origin.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <string_view>
#include <type_traits>

#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

#include "setups.hpp"
#include "tweaks.hpp"

namespace joints {

/// A hundredth of what a light covers, about: what an origin moves by from frame to frame.
[[nodiscard]] inline glm::dvec3 step_of(const umbrage::light_space<double>& light, glm::dvec3 origin) {
    const auto here = umbrage::detail::relative_to(origin, light);
    const glm::dmat4 back = glm::inverse(here.projection * here.view);
    const glm::dvec4 a = back * glm::dvec4(0, 0, 0.9, 1), b = back * glm::dvec4(0.04, 0.03, 0.9, 1);
    return glm::dvec3(b) / b.w - glm::dvec3(a) / a.w;
}

template <class Setup>
class wrong_uniforms {
public:
    wrong_uniforms(const Setup& s, glm::ivec2 map_size, glm::dvec3 origin, typename Setup::uniforms& u)
        : setup_(s), map_size_(map_size), origin_(origin), u_(u) {}

    /// @param reach   of the filter, texels
    /// @return        false where the setup has no such step
    [[nodiscard]] bool change(const tweaks& t, float reach) {
        if (t.uniforms_drop_origin) u_ = setup_.make_uniforms(map_size_, glm::dvec3(0));
        if (t.uniforms_stale_origin)
            u_ = setup_.make_uniforms(map_size_, origin_ + step_of(setup_.lights().front(), origin_));
        return (!t.drops_slack || drop_slack()) && (!t.drops_slope || drop_slope()) &&
               (!t.other_column || turn_columns()) && (!t.other_size || halve_size(reach)) &&
               (!t.uniforms_drop_added || drop_added()) && (!t.uniforms_drop_anchor || drop_anchor()) &&
               (!t.drops_border || drop_border());
    }

private:
    /// A member by its name, as vectors; empty where there is none.
    [[nodiscard]] std::span<glm::vec4> field(std::string_view name) {
        const std::span<glm::vec4> all(reinterpret_cast<glm::vec4*>(&u_), sizeof u_ / sizeof(glm::vec4));
        std::size_t at = 0;
        for (const umbrage::uniform_field& f : Setup::fields) {
            if (f.name == name) return all.subspan(at, f.vectors());
            at += f.vectors();
        }
        return {};
    }
    bool drop_slack() {
        std::ranges::fill(field("rounding"), glm::vec4(0));
        if (!field("pages").empty()) field("slack")[0].w = 0;  // in others that is the depth to add
        for (glm::vec4& column : field("slack")) column = {0, 0, 0, column.w};
        for (const auto* name : {"scales", "farther_scales", "offsets", "farther_offsets"})
            for (glm::vec4& column : field(name)) column.w = 0;
        return true;
    }
    bool drop_slope() {
        if (const auto face = field("face"); !face.empty()) return face[0].w = 0.0f, true;
        const auto planes = field("planes"), points = field("to_texels");
        if (planes.empty() || points.empty()) return false;
        std::ranges::copy(points, planes.begin());
        return true;
    }
    bool turn_columns() {
        const auto scales = field("scales"), offsets = field("offsets");
        if (scales.empty() || setup_.lights().size() < 2) return false;
        std::rotate(scales.begin(), scales.begin() + 1, scales.end());
        std::rotate(offsets.begin(), offsets.begin() + 1, offsets.end());
        return true;
    }
    bool halve_size(float reach) {
        if constexpr (std::is_same_v<Setup, umbrage::single_map> || std::is_same_v<Setup, umbrage::warped_maps>) {
            const glm::ivec2 half = map_size_ / 2;
            if (2.0f * reach > float(std::min(half.x, half.y))) return false;
            u_ = setup_.make_uniforms(half, origin_);
            return true;
        } else return false;  // refused by name
    }
    bool drop_anchor() {
        const auto anchor = field("anchor");
        if (anchor.empty()) return false;
        anchor[0] = glm::vec4(0);
        return true;
    }
    bool drop_added() {
        const auto slack = field("slack");
        if (slack.empty() || !field("pages").empty() || slack[0].w == 0.0f) return false;
        for (glm::vec4& column : slack) column.w = 0;
        return true;
    }
    bool drop_border() {
        if constexpr (std::is_same_v<Setup, umbrage::cube_maps> || std::is_same_v<Setup, umbrage::tetrahedron_map> ||
                      std::is_same_v<Setup, umbrage::paraboloid_maps>) {
            auto light = setup_.light;
            light.border = 0;
            u_ = Setup(light).make_uniforms(map_size_, origin_);
            return true;
        } else return false;
    }

    const Setup& setup_;
    glm::ivec2 map_size_;
    glm::dvec3 origin_;
    typename Setup::uniforms& u_;
};

}  // namespace joints
