// SPDX-License-Identifier: MIT
//
// Choice of the function that a map has for each hook.
//
#pragma once

#include <string>

#include <umbrage/core/config.hpp>
#include <umbrage/shader/binding.hpp>
#include <umbrage/shader/hooks/fetch.hpp>
#include <umbrage/shader/hooks/gather.hpp>
#include <umbrage/shader/hooks/sample.hpp>

namespace umbrage::glsl {
namespace hooks {

/// List of all hooks, for printers and packages.
inline constexpr const auto& all =
    list<&reversed_cleared_depth, &clamped_covers, &clamped_texel_inside, &reversed_beyond_far_plane,
         &no_beyond_far_plane, &reversed_within_far_plane, &any_within_far_plane, &reversed_compare, &own_compare,
         &decode, &clamped_depth, &lit_texel, &clamped_lit, &bordered_lit, &planed_lit, &planed_lit_texel,
         &planed_compared_lit, &gather_compared, &gather_one_channel, &gather_two_channels, &gather_clamped,
         &gather_in_region, &gather_lit, &gathered_lit, &planed_compare, &planed_gathered_lit, &gathered,
         &gathered_bordered, &clamped_lit_filtered, &bordered_lit_filtered, &bordered_covered, &sampled_lit,
         &planed_lit_sampled, &planed_lit_between, &sampled_depth, &sampled_bordered_depth>;

}  // namespace hooks

namespace detail {

[[nodiscard]] inline bool has_region(const binding& b) { return b.texture == texture::atlas || !b.origin.empty(); }
[[nodiscard]] constexpr bool is_cube(texture kind) { return kind == texture::cube || kind == texture::cube_faces; }
/// True when texels outside the map count as the far plane.
[[nodiscard]] inline bool is_bordered(const binding& b) {
    const bool tile = has_region(b) || is_cube(b.texture);
    return b.outside.value_or(tile ? outside_map::clamped : outside_map::bordered) == outside_map::bordered;
}
/// True when the map's depths have their own scale, on which 1 is not the far plane.
[[nodiscard]] inline bool is_scaled(const binding& b) {
    for (const snippet& need : b.needs)
        if (need.scaled) return true;
    return false;
}
[[nodiscard]] constexpr bool gathers(texture kind) { return !is_cube(kind) && kind != texture::integer; }
[[nodiscard]] inline bool compares(texture kind) { return kind == texture::shadow || kind == texture::shadow_array; }

/// True when a comparison sampler takes the coordinates of the map itself.
[[nodiscard]] inline bool samples(const binding& b) { return compares(b.texture) && !has_region(b); }

/// True when receivers can be beyond the map's far plane. A user's own comparison handles them itself.
[[nodiscard]] inline bool has_far_plane(const binding& b) { return b.compare.empty() && !is_scaled(b); }

/// Function that a map has instead of a hook's own text. Returns other snippets unchanged.
template <class = umbrage::detail::on_use>
[[nodiscard]] const snippet& chosen(const snippet& s, const binding& b) {
    const bool forward = b.direction == depth_direction::forward;
    switch (s.role) {
        case hook::none:
        case hook::chosen:
        case hook::texel: return s;
        case hook::cleared_depth: return forward ? s : hooks::reversed_cleared_depth;
        case hook::map_covers: return is_bordered(b) ? s : hooks::clamped_covers;
        case hook::beyond_far_plane:
            return !has_far_plane(b) ? hooks::no_beyond_far_plane : forward ? s : hooks::reversed_beyond_far_plane;
        case hook::within_far_plane:
            return !has_far_plane(b) ? hooks::any_within_far_plane : forward ? s : hooks::reversed_within_far_plane;
        case hook::compare:
            if (!b.compare.empty()) return hooks::own_compare;
            return forward ? s : hooks::reversed_compare;
        case hook::texel_inside: return is_bordered(b) ? s : hooks::clamped_texel_inside;
        case hook::fetch_depth: return is_bordered(b) ? s : hooks::clamped_depth;
        case hook::lit:
            if (b.receiver_plane) return compares(b.texture) ? hooks::planed_compared_lit : hooks::planed_lit;
            if (!compares(b.texture)) return s;
            return is_bordered(b) ? hooks::bordered_lit : hooks::clamped_lit;
        case hook::lit_2x2:
            if (!b.gather) return s;
            return is_bordered(b) && !b.receiver_plane ? hooks::gathered_bordered : hooks::gathered;
        case hook::gather_lit:
            if (compares(b.texture)) return s;
            return b.receiver_plane ? hooks::planed_gathered_lit : hooks::gathered_lit;
        case hook::gather_clamped: return has_region(b) ? hooks::gather_in_region : s;
        case hook::gather:
            if (compares(b.texture)) return s;
            return b.channels == 2 ? hooks::gather_two_channels : hooks::gather_one_channel;
        case hook::lit_filtered:
            if (!compares(b.texture)) return s;
            return is_bordered(b) ? hooks::bordered_lit_filtered : hooks::clamped_lit_filtered;
        case hook::covered: return samples(b) && is_bordered(b) ? hooks::bordered_covered : s;
        case hook::lit_between:
            if (!samples(b)) return s;
            return b.receiver_plane ? hooks::planed_lit_between : hooks::sampled_lit;
        case hook::depth_at:
            if (!b.gather || b.receiver_plane || !gathers(b.texture) || compares(b.texture) || has_region(b)) return s;
            return is_bordered(b) ? hooks::sampled_bordered_depth : hooks::sampled_depth;
    }
    return s;
}

/// True when a snippet is a hook of these roles, or calls one.
template <class = umbrage::detail::on_use>
[[nodiscard]] bool calls(const snippet& s, hook first, hook last) {
    for (const snippet* need : s.needs)
        if (calls(*need, first, last)) return true;
    return first <= s.role && s.role <= last;
}

/// True when a snippet's functions belong to a map.
template <class = umbrage::detail::on_use>
[[nodiscard]] bool is_of_map(const snippet& s) {
    return calls(s, hook::map_covers, hook::chosen);
}

/// True when a snippet reads its map.
template <class = umbrage::detail::on_use>
[[nodiscard]] bool reads_map(const snippet& s) {
    return calls(s, hook::texel, hook::depth_at);
}

}  // namespace detail
}  // namespace umbrage::glsl
