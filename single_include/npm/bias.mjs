// SPDX-License-Identifier: MIT
//
// What an engine's own biases must be so that no surface stripes itself, for engines that do not only move receivers along
// their normals as fit.mjs has it. No word of an engine is in here. Lengths are in world units.
import { snapping } from './fit.mjs';

/** Texels by which shadows may detach beyond the filter's radius, so that edges of solids are clear. */
const spare = 2;

/** An engine that moves each caster along its normal by a length times the sine of its angle t to the light, and away from
 *  the light by a second length.
 *
 *  A plane is then n sin t / cos t = n tan t farther from the light, which is what a filter of radius n needs, at any angle.
 *  Not so at an edge between a steep face and one that faces the light: the latter is hardly moved, and the filter on the
 *  steep one compares with it. Only the second length helps there: it frees faces with n tan t <= depth. Of both together a
 *  caster moves by n / 2 + sqrt(n^2 / 4 + depth^2) at most, which is solved for depth.
 *
 *  @param normal   the filter's radius, and what rounding adds
 *  @param texel    of the map
 *  @param error    a stored depth's, which no normal helps against
 *  @return         depth, the second length; detachment; clear_angle: between normal and light, up to which edges are free */
export function bias_of_casters(normal, texel, error) {
    const most = normal + (spare - snapping) * texel, depth = Math.max(Math.sqrt(most * (most - normal)), 2 * error);
    return { depth, detachment: normal / 2 + Math.hypot(normal / 2, depth), clear_angle: Math.atan(depth / normal) };
}

/** An engine that moves each receiver along its normal by a factor times 1 - cos t and its distance to the light, and towards
 *  the light by a length.
 *
 *  Of a receiver at distance 1, needed at each angle t is factor (1 - cos t) + depth cos t >= r sin t, r the filter's radius.
 *  The largest value of r sin t + (factor - depth) cos t is hypot(r, factor - depth); so factor = (r^2 + depth^2) / (2 depth).
 *  Both are r at best, where the receiver's normal distance to its caster is r at any angle.
 *
 *  @param radius     of the filter over the distance, and what rounding adds
 *  @param distance   of the farthest receiver
 *  @param most       that the engine takes as a length
 *  @return           factor, depth: the length; detachment */
export function bias_of_distances(radius, distance, most) {
    const depth = Math.min(radius * distance, most), own = depth / distance;
    const factor = (radius * radius + own * own) / (2 * own);
    return { factor, depth, detachment: Math.max(factor * distance, depth) };
}
