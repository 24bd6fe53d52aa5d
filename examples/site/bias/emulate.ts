// SPDX-License-Identifier: MIT
//
// An engine's shadow of a few faces, emulated: its map as the light sees the faces that it has moved, and its filter.
import type { EngineFacts, Light } from '../../../single_include/npm/engines.mjs';
import { cross, dot, normalized, plus, scaled, type Vector } from './vector';

/** A parallelogram. */
export interface Face {
    corner: Vector;
    u: Vector;
    v: Vector;
    normal: Vector;
}

/** Weights of a row of texels that slide with the receiver, by half the side of their square. */
const rows: Record<string, number[]> = { 1.5: [1, 1], 2: [1, 2, 1], 3: [1, 3, 4, 3, 1], 4: [1, 5, 12, 16, 12, 5, 1] };
const golden = Math.PI * (3 - Math.sqrt(5)), spiral = [3, 6, 1, 4, 7, 2, 5, 0];

type Fetch = (x: number, y: number) => number;

function bilinear(fetch: Fetch, x: number, y: number, depth: number): number {
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
    const { points = 1, radius = 0 } = filter;
    let sum = 0;
    for (let i = 0; i < points; ++i) {
        const away = radius * (filter.spiral ? 1 - i / 8 : Math.sqrt((i + 0.5) / points));
        const angle = turn + (filter.spiral ? (spiral[i]! * Math.PI) / 4 : i * golden);
        sum += bilinear(fetch, x + away * Math.cos(angle), y + away * Math.sin(angle), depth);
    }
    return sum / points;
}

/** Depths as the engine's maps hold them. */
const stored_by = (engine: EngineFacts, { range }: Light) => {
    const step = (engine.stored ?? 0) * range;
    return (depth: number) => (step > 0 ? Math.round(depth / step) * step : depth);
};

/** The axes of a map under a light whose up is the world's. */
function axes_of(to_light: Vector): { x: Vector; y: Vector } {
    const x = normalized(cross([0, 1, 0], to_light));
    return { x, y: cross(to_light, x) };
}

/** A shadow map of faces, and the engine's lookup in it. Depths are world units along the light. */
export class Emulation {
    private readonly axes: { x: Vector; y: Vector };
    private readonly depths: Float64Array;

    /** @param size   texels of the part of the map that is kept, around the world's origin */
    constructor(
        private readonly engine: EngineFacts,
        private readonly light: Light,
        private readonly settings: { readonly [name: string]: number },
        private readonly to_light: Vector,
        faces: Face[],
        private readonly size: number,
    ) {
        this.axes = axes_of(to_light);
        this.depths = new Float64Array(size * size).fill(Infinity);
        for (const face of faces) this.draw(face);
    }

    private moves(normal: Vector) {
        const { x, y } = this.axes, cosine = Math.min(Math.max(dot(normal, this.to_light), 0), 1);
        const slope = Math.max(Math.abs(dot(normal, x)), Math.abs(dot(normal, y))) / Math.max(cosine, 1e-6);
        return this.engine.moves(this.settings, this.light, { normal, to_light: this.to_light, cosine, slope });
    }

    private place(p: Vector): Vector {
        const { x, y } = this.axes, middle = this.size / 2 + 0.3;  // texels do not begin at the scene's edges
        return [dot(p, x) / this.light.texel + middle, dot(p, y) / this.light.texel + middle, -dot(p, this.to_light)];
    }

    private draw({ corner, u, v, normal }: Face): void {
        const from = this.place(plus(corner, this.moves(normal).caster ?? [0, 0, 0])), stored = stored_by(this.engine, this.light);
        const along = (edge: Vector): Vector => plus(this.place(edge), this.place([0, 0, 0]), -1);
        const [a, b] = [along(u), along(v)], area = a[0] * b[1] - a[1] * b[0];
        if (Math.abs(area) < 1e-9) return;
        const span = (i: 0 | 1): [number, number] => {
            const ends = [0, a[i], b[i], a[i] + b[i]].map(end => end + from[i]);
            return [Math.max(Math.floor(Math.min(...ends)), 0), Math.min(Math.ceil(Math.max(...ends)), this.size)];
        };
        const [left, right] = span(0), [low, high] = span(1);
        for (let j = low; j < high; ++j)
            for (let i = left; i < right; ++i) {
                const x = i + 0.5 - from[0], y = j + 0.5 - from[1];
                const s = (x * b[1] - y * b[0]) / area, t = (a[0] * y - a[1] * x) / area;
                if (s < 0 || s > 1 || t < 0 || t > 1) continue;
                const depth = stored(from[2] + s * a[2] + t * b[2]), at = j * this.size + i;
                if (depth < this.depths[at]!) this.depths[at] = depth;
            }
    }

    /** Share of the light at a point of a face that faces it. */
    visibility(point: Vector, normal: Vector, turn: number): number {
        const [x, y, depth] = this.place(plus(point, this.moves(normal).receiver ?? [0, 0, 0]));
        const fetch = (i: number, j: number) =>
            i >= 0 && j >= 0 && i < this.size && j < this.size ? this.depths[j * this.size + i]! : Infinity;
        return filtered(this.light, fetch, x, y, depth, turn);
    }
}

/** Falsely dark share of receivers of lone planes, which nothing else shades.
 *  @param tilt   of a plane against the light, radians: of a number between 0 and 1 */
export function falsely_dark(engine: EngineFacts, light: Light, settings: { readonly [name: string]: number },
    tilt: (at: number) => number, count = 2000): number {
    const to_light: Vector = [0, 0, 1], stored = stored_by(engine, light), { texel } = light;
    let seed = 1, dark = 0;
    const random = () => (seed = (seed * 1103515245 + 12345) % 2147483648) / 2147483648;
    for (let k = 0; k < count; ++k) {
        const t = tilt((k + 0.5) / count), turn = 2 * Math.PI * random(), cosine = Math.cos(t);
        const normal: Vector = [Math.sin(t) * Math.cos(turn), Math.sin(t) * Math.sin(turn), cosine];
        const slope = Math.max(Math.abs(normal[0]), Math.abs(normal[1])) / cosine;
        const { receiver = [0, 0, 0], caster = [0, 0, 0] } = engine.moves(settings, light, { normal, to_light, cosine, slope });
        const x = random(), y = random(), depth = (0.3 + 0.4 * random()) * light.range, moved = -dot(normal, caster) / cosine;
        const fetch = (i: number, j: number) =>
            stored(depth + moved + (((i + 0.5 - x) * normal[0] + (j + 0.5 - y) * normal[1]) / cosine) * texel);
        const lit = filtered(light, fetch, x + receiver[0] / texel, y + receiver[1] / texel, depth - receiver[2], 2 * Math.PI * random());
        if (lit < 0.9999) ++dark;
    }
    return dark / count;
}
