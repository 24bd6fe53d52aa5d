// SPDX-License-Identifier: MIT
//
// Vectors of the bias page.
import type { Vector } from '../../../single_include/npm/engines.mjs';

export type { Vector };

export const dot = (a: Vector, b: Vector): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const plus = (a: Vector, b: Vector, factor = 1): Vector => [a[0] + b[0] * factor, a[1] + b[1] * factor, a[2] + b[2] * factor];
export const scaled = (a: Vector, factor: number): Vector => [a[0] * factor, a[1] * factor, a[2] * factor];
export const cross = (a: Vector, b: Vector): Vector =>
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const normalized = (a: Vector): Vector => scaled(a, 1 / Math.hypot(...a));

/** Axes of length 1 across a direction: the first lies on the floor, where that is not along the direction. */
export function across(z: Vector): [Vector, Vector] {
    const x = normalized(cross(Math.abs(z[1]) < 0.999 ? [0, 1, 0] : [1, 0, 0], z));
    return [x, cross(z, x)];
}
