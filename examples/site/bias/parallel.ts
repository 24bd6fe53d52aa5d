// SPDX-License-Identifier: MIT
//
// An engine's shadow of a directional light, emulated: its map as the light sees the faces that it has moved, and its filter.
import type { EngineFacts, Light } from '../../../single_include/npm/engines.mjs';
import { filtered, random_from, type Face, type Settings, type Shadow } from './emulate';
import { across, dot, plus, scaled, type Vector } from './vector';

/** Depths as the engine's maps hold them. */
const stored_by = (engine: EngineFacts, { range }: Light) => {
    const step = (engine.stored ?? 0) * range;
    return (depth: number) => (step > 0 ? Math.round(depth / step) * step : depth);
};

/** A directional light's map of faces, and the engine's lookup in it. Depths are world units along the light. */
export class ParallelShadow implements Shadow {
    private readonly axes: [Vector, Vector];
    private readonly depths: Float64Array;

    /** @param size   texels of the part of the map that is kept, around the world's origin */
    constructor(
        private readonly engine: EngineFacts,
        private readonly light: Light,
        private readonly settings: Settings,
        private readonly direction: Vector,
        faces: Face[],
        private readonly size: number,
    ) {
        this.axes = across(direction);
        this.depths = new Float64Array(size * size).fill(Infinity);
        for (const face of faces) this.draw(face);
    }

    to_light(): Vector {
        return this.direction;
    }

    private moves(normal: Vector) {
        const [x, y] = this.axes, to_light = this.direction, cosine = Math.min(Math.max(dot(normal, to_light), 0), 1);
        const slope = Math.max(Math.abs(dot(normal, x)), Math.abs(dot(normal, y))) / Math.max(cosine, 1e-6);
        return this.engine.moves(this.settings, this.light, { normal, to_light, cosine, slope });
    }

    private place(p: Vector): Vector {
        const [x, y] = this.axes, middle = this.size / 2 + 0.3;  // texels do not begin at the scene's edges
        return [dot(p, x) / this.light.texel + middle, dot(p, y) / this.light.texel + middle, -dot(p, this.direction)];
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

    visibility(point: Vector, normal: Vector, turn: number): number {
        const [x, y, depth] = this.place(plus(point, this.moves(normal).receiver ?? [0, 0, 0]));
        const fetch = (i: number, j: number) =>
            i >= 0 && j >= 0 && i < this.size && j < this.size ? this.depths[j * this.size + i]! : Infinity;
        return filtered(this.light, fetch, x, y, depth, turn);
    }
}

/** Falsely dark share of receivers of lone planes, which nothing else shades.
 *  @param tilt   of a plane against the light, radians: of a number between 0 and 1 */
export function falsely_dark(engine: EngineFacts, light: Light, settings: Settings,
    tilt: (at: number) => number, count = 2000): number {
    const to_light: Vector = [0, 0, 1], stored = stored_by(engine, light), { texel } = light;
    const random = random_from(1);
    let dark = 0;
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
