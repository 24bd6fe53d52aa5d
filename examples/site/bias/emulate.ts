// SPDX-License-Identifier: MIT
//
// Parts of engines' emulated shadows that all lights share: faces, and the engines' filters.
import type { Light } from '../../../single_include/npm/engines.mjs';
import type { Vector } from './vector';

/** A parallelogram. */
export interface Face {
    corner: Vector;
    u: Vector;
    v: Vector;
    normal: Vector;
}

export type Settings = { readonly [name: string]: number };

/** A light's shadow of some faces. */
export interface Shadow {
    /** Direction from a point, of length 1. */
    to_light(point: Vector): Vector;
    /** Share of the light at a point of a face that faces it.
     *  @param turn   of the filter's disc at this pixel, radians */
    visibility(point: Vector, normal: Vector, turn: number): number;
}

/** Numbers from 0 to 1 that look random, the same each time. */
export function random_from(seed: number): () => number {
    return () => (seed = (seed * 1103515245 + 12345) % 2147483648) / 2147483648;
}

/** Weights of a row of texels that slide with the receiver, by half the side of their square. */
const rows: Record<string, number[]> = { 1.5: [1, 1], 2: [1, 2, 1], 3: [1, 3, 4, 3, 1], 4: [1, 5, 12, 16, 12, 5, 1] };
const golden = Math.PI * (3 - Math.sqrt(5)), spiral = [3, 6, 1, 4, 7, 2, 5, 0];
const on_circle = (away: number, angle: number) => [away * Math.cos(angle), away * Math.sin(angle)] as const;

/** Eight points, each farther in than the one before. */
export const spiral_points = (radius: number, turn: number) =>
    spiral.map((eighth, i) => on_circle(radius * (1 - i / 8), turn + (eighth * Math.PI) / 4));
const disc_points = (count: number, radius: number, turn: number) =>
    Array.from({ length: count }, (_, i) => on_circle(radius * Math.sqrt((i + 0.5) / count), turn + i * golden));

type Fetch = (x: number, y: number) => number;

export function bilinear(fetch: Fetch, x: number, y: number, depth: number): number {
    const i = Math.floor(x - 0.5), j = Math.floor(y - 0.5), a = x - 0.5 - i, b = y - 0.5 - j;
    const row = (at: number) => (depth <= fetch(i, at) ? 1 - a : 0) + (depth <= fetch(i + 1, at) ? a : 0);
    return row(j) * (1 - b) + row(j + 1) * b;
}

/** Share of a square's texels that are lit: a row of weights slides with the receiver, along both axes. */
function by_square(half: number, fetch: Fetch, x: number, y: number, depth: number): number {
    if (half === 1) return bilinear(fetch, x, y, depth);
    const row = rows[half];
    if (!row) return depth <= fetch(Math.floor(x), Math.floor(y)) ? 1 : 0;
    const count = row.length, left = x - count / 2, low = y - count / 2, first_x = Math.floor(left), first_y = Math.floor(low);
    const weight = (i: number, moved: number) => (row[i] ?? 0) * (1 - moved) + (row[i - 1] ?? 0) * moved;
    let sum = 0, all = 0;
    for (let j = 0; j <= count; ++j)
        for (let i = 0; i <= count; ++i) {
            const share = weight(i, left - first_x) * weight(j, low - first_y);
            all += share;
            if (depth <= fetch(first_x + i, first_y + j)) sum += share;
        }
    return sum / all;
}

/** Visibility by an engine's filter.
 *  @param turn   of its disc at this pixel, radians */
export function filtered({ filter }: Light, fetch: Fetch, x: number, y: number, depth: number, turn: number): number {
    if (filter.half !== undefined) return by_square(filter.half, fetch, x, y, depth);
    const { points: count = 1, radius = 0 } = filter, points = filter.spiral ? spiral_points(radius, turn) : disc_points(count, radius, turn);
    let sum = 0;
    for (const [right, up] of points) sum += bilinear(fetch, x + right, y + up, depth);
    return sum / points.length;
}
