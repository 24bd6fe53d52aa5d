// SPDX-License-Identifier: MIT
//
// What a program may get wrong between the parts of a shadow. The library is right throughout: tweaks change what a
// program hands from one part to the next, or how it calls them.
#pragma once

#include <optional>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/draw/mesh.hpp>

namespace joints {

struct tweaks {
    // the depth pass
    std::optional<umbrage::cull_mode> cull{};  ///< in place of none
    bool flips_near = false;                   ///< clips in place of clamps, or the other way round
    bool in_float = false;                     ///< one float matrix, of the world
    bool drops_anchor = false;                 ///< positions go to the view as they are
    bool drops_depth_share = false;            ///< w of the view's anchor stays out
    int other_view = 0;                        ///< each map has the view of so many maps on
    bool clears_near = false;                  ///< cleared to the near plane
    bool turns_direction = false;              ///< the farthest depth stays
    bool other_range = false;                  ///< [0, 1] for [-1, 1], or the other way round
    bool other_origin = false;                 ///< the first row at the other end
    bool drops_origin = false;                 ///< the light's view is of the world, positions are not
    bool stale_origin = false;                 ///< the origin of the frame before
    double light_turned = 0;                   ///< drawn for a light that has moved on since, texels
    bool skips_mesh = false, skips_instances = false;

    bool drops_instances_turn = false;  ///< instances at their place, but not turned
    bool exchanges_sides = false;       ///< drawn with width and height exchanged
    // the map
    int other_tile = 0;          ///< each map lies where the one so many maps on should
    int depth_bits = 0;          ///< depths stored with so many bits
    bool stores_linear = false;  ///< depth squared, as a gamma does
    double moves_casters = 0;    ///< depth added by a rasterizer's bias of the wrong sign
    // the uniforms
    float slope = 1;            ///< factor of the plane's slope
    double reach = 1;           ///< of terms, a factor
    bool drops_error = false;   ///< of terms
    bool drops_slack = false;   ///< of places
    bool drops_slope = false;   ///< the matrix of planes is of points
    bool other_column = false;  ///< cascades' columns are one map on
    bool other_size = false;    ///< made for maps of half the size
    bool uniforms_drop_origin = false, uniforms_stale_origin = false;
    bool uniforms_drop_added = false;  ///< slack.w
    bool uniforms_drop_anchor = false;
    // the look
    glm::vec2 moves_texels{0};  ///< added to the place
    bool drops_normal = false;
    bool normal_of_mesh = false;  ///< normals of instances as the mesh has them
    bool other_normal = false;    ///< normals of another space
    bool turns_bias = false;      ///< bias away from the light
    bool turns_comparison = false;
    bool wider_filter = false;  ///< a filter of more reach than the uniforms'
    bool drops_border = false;  ///< border of the uniforms' maps: none
    bool lower_edge = false;    ///< codes decode to their other end
    // contact hardening
    float softness = 1;              ///< factor of the light's size
    bool default_softness = false;   ///< a map's softness as filters have it before it is computed
    bool one_softness = false;       ///< that of the longer edge of a texel along both axes
    bool drops_shape = false;        ///< that of the first texel of a map everywhere
    int other_softness = 0;          ///< each map has the softness of the one so many maps on
    bool searches_least = false;     ///< blockers within the smallest radius
    bool counts_all_points = false;  ///< mean over all points of the search, not over those that found a blocker
    bool drops_blockers = false;     ///< penumbra of the receiver's depth, not of what lies between

    [[nodiscard]] bool draws() const {
        return cull || flips_near || in_float || drops_anchor || drops_depth_share || other_view || clears_near ||
               turns_direction || other_range || other_origin || drops_origin || stale_origin || light_turned != 0 ||
               skips_mesh || skips_instances || drops_instances_turn || exchanges_sides;
    }
};

}  // namespace joints
