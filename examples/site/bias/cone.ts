// SPDX-License-Identifier: MIT
//
// An engine's shadow of a spot light or point light, emulated: each texel's ray against the faces as the engine moves them, and
// its filter. The light is at the origin.
import type { ConeLight, EngineFacts, LightFacts } from '../../../single_include/npm/engines.mjs';
import { bilinear, filtered, random_from, spiral_points, type Face, type Settings, type Shadow } from './emulate';
import { across, dot, normalized, plus, scaled, type Vector } from './vector';

/** Axes of a map in the world: along its rows, along its columns, to the light. */
type Frame = readonly [Vector, Vector, Vector];

/** The map of a spot light that lies in a direction. */
export const spot_frame = (to_light: Vector): Frame => [...across(to_light), to_light];

/** The six maps of a point light. */
export const cube_frames: Frame[] = [0, 1, 2].flatMap(axis => [1, -1].map(side => {
    const unit = (at: number): Vector => [+(at % 3 === 0), +(at % 3 === 1), +(at % 3 === 2)];
    return [unit(axis + 1), unit(axis + 2), scaled(unit(axis), side)] as const;
}));

/** Of a lookup in a cube, as Bevy has them: points with a weight. */
const gaussian = [[0.125, -0.375, 0.157112], [-0.125, 0.375, 0.157112], [0.625, 0.125, 0.138651], [-0.375, -0.625, 0.130251],
    [-0.625, 0.625, 0.114946], [-0.875, -0.125, 0.114946], [0.375, 0.875, 0.107982], [0.875, -0.875, 0.079001]] as const;
const cube_points: Record<string, (turn: number) => readonly (readonly [number, number, number])[]> = {
    Gaussian: () => gaussian,
    Temporal: turn => spiral_points(0.5, turn).map(([x, y]) => [x, y, 1 / 8] as const),
    Hardware2x2: () => [[0, 0, 1]],
};

const in_frame = (frame: Frame, v: Vector): Vector => [dot(frame[0], v), dot(frame[1], v), dot(frame[2], v)];
const in_world = (frame: Frame, v: Vector): Vector => plus(plus(scaled(frame[0], v[0]), frame[1], v[1]), frame[2], v[2]);

const nowhere: Vector = [0, 0, 0];

/** Depth of a map's texel. */
type Fetch = (map: number, x: number, y: number) => number;

const kept = 512;  // texels of a map that lie so far apart are never both asked for

/** The same depths, each computed once. */
export function remembered(fetch: Fetch): Fetch {
    const maps: Float64Array[] = [];
    return (map, x, y) => {
        const depths = (maps[map] ??= new Float64Array(kept * kept).fill(NaN)), at = (y & (kept - 1)) * kept + (x & (kept - 1));
        if (Number.isNaN(depths[at])) depths[at] = fetch(map, x, y);
        return depths[at]!;
    };
}

export class ConeShadow implements Shadow {
    private readonly fetch: Fetch;
    private readonly near: number;
    private readonly moves_casters: boolean;
    /** Texels to the map's axis. */
    private readonly middle: number;

    constructor(
        private readonly engine: EngineFacts,
        private readonly facts: LightFacts,
        private readonly light: ConeLight,
        private readonly settings: Settings,
        private readonly frames: readonly Frame[],
        private readonly faces: readonly Face[],
        keep: (fetch: Fetch) => Fetch = fetch => fetch,
    ) {
        this.near = (light.scale * light.range) / (light.range + light.scale);
        this.middle = light.size / 2;
        this.moves_casters = this.moves(frames[0]!, scaled(frames[0]![2], -1), frames[0]![2]).caster !== undefined;
        this.fetch = keep((map, x, y) => this.depth_at(map, x, y));
    }

    to_light(point: Vector): Vector {
        return normalized(scaled(point, -1));
    }

    /** How a face moves at one of its points, in a map's space. */
    private moves(frame: Frame, point: Vector, normal: Vector) {
        const at = in_frame(frame, point), n = in_frame(frame, normal), distance = Math.hypot(...at), to_light = scaled(at, -1 / distance);
        const cosine = Math.min(Math.max(dot(n, to_light), 0), 1), slope = Math.max(Math.abs(n[0]), Math.abs(n[1])) / Math.max(cosine, 1e-6);
        return this.facts.moves(this.settings, this.light, { normal: n, to_light, cosine, slope, depth: -at[2], distance });
    }

    /** A depth as the engine's map holds it: near planes are precise. */
    private stored(depth: number): number {
        if (!this.engine.stored) return depth;
        const { range, scale } = this.light, whole = range / (range - this.near), steps = 1 / this.engine.stored - 1;
        return scale / (whole - Math.round((whole - scale / depth) * steps) / steps);
    }

    private depth_at(map: number, x: number, y: number): number {
        const frame = this.frames[map]!, { unit, range } = this.light;
        const ray = in_world(frame, [(x + 0.5 - this.middle) * unit, (y + 0.5 - this.middle) * unit, -1]);
        let nearest = Infinity;
        for (const { corner, u, v, normal } of this.faces) {
            const along = dot(normal, ray), drawn = dot(normal, corner) / along;
            if (!(drawn > 0 && drawn < Infinity)) continue;
            const moved = this.moves_casters ? in_world(frame, this.moves(frame, scaled(ray, drawn), normal).caster!) : nowhere;
            const depth = drawn + dot(normal, moved) / along;
            if (!(depth >= this.near && depth <= range && depth < nearest)) continue;
            const inside = plus(plus(scaled(ray, depth), moved, -1), corner, -1), s = dot(inside, u) / dot(u, u), t = dot(inside, v) / dot(v, v);
            if (s >= 0 && s <= 1 && t >= 0 && t <= 1) nearest = depth;
        }
        return nearest === Infinity ? nearest : this.stored(nearest);
    }

    /** The map that a direction from the light meets. */
    private map_of(direction: Vector): number {
        let best = 0;
        this.frames.forEach(([, , z], map) => {
            if (dot(z, direction) < dot(this.frames[best]![2], direction)) best = map;
        });
        return best;
    }

    /** Texels and depth in a map. */
    private place(map: number, point: Vector): Vector {
        const [x, y, z] = in_frame(this.frames[map]!, point), { unit } = this.light;
        return [x / -z / unit + this.middle, y / -z / unit + this.middle, -z];
    }

    visibility(point: Vector, normal: Vector, turn: number): number {
        const map = this.map_of(point), frame = this.frames[map]!, { receiver } = this.moves(frame, point, normal);
        const moved = receiver ? plus(point, in_world(frame, receiver)) : point, [x, y, depth] = this.place(map, moved);
        if (this.light.kind === 'point' && this.facts.cube) return this.in_cube(moved, depth, -dot(frame[2], point) * this.facts.cube.scale, turn);
        return filtered(this.light, (i, j) => this.fetch(map, i, j), x, y, depth, turn);
    }

    /** A filter of points across the ray, each in the map that it meets, all with one depth. */
    private in_cube(moved: Vector, depth: number, scale: number, turn: number): number {
        const [right, up] = across(this.to_light(moved));
        let sum = 0;
        for (const [x, y, weight] of cube_points[this.light.filter.name]!(turn)) {
            const point = plus(plus(moved, right, x * scale), up, y * scale), map = this.map_of(point), at = this.place(map, point);
            sum += weight * bilinear((i, j) => this.fetch(map, i, j), at[0], at[1], depth);
        }
        return sum;
    }
}

/** A receiver on a plane, seen from the light. */
interface Receiver {
    point: Vector;
    normal: Vector;
}

/** Falsely dark share of receivers of lone planes, which nothing else shades.
 *  @param receiver   draws one, of a number between 0 and 1 */
export function falsely_dark_in_cone(engine: EngineFacts, facts: LightFacts, light: ConeLight, settings: Settings, frames: readonly Frame[],
    receiver: (at: number, random: () => number) => Receiver, count = 2000): number {
    const random = random_from(1);
    let dark = 0;
    for (let k = 0; k < count; ++k) {
        const { point, normal } = receiver((k + 0.5) / count, random), side = 100 * light.range;
        const [u, v] = across(normal).map(axis => scaled(axis, side)) as [Vector, Vector];
        const plane = { corner: plus(plus(point, u, -0.5), v, -0.5), u, v, normal };
        const shadow = new ConeShadow(engine, facts, light, settings, frames, [plane]);
        if (shadow.visibility(point, normal, 2 * Math.PI * random()) < 0.9999) ++dark;
    }
    return dark / count;
}

/** A receiver anywhere in what the first map shows, an eighth of the range away or farther, whose plane is tilted by up to
 *  89 degrees. */
export function any_receiver({ kind, tangent, range }: ConeLight, [x, y, z]: Frame) {
    return (at: number, random: () => number): Receiver => {
        for (;;) {
            const turn = 2 * Math.PI * random(), out = tangent * Math.sqrt(random()), depth = range * (1 + 7 * random()) / 8;
            const [right, up] = kind === 'point' ? [2 * random() - 1, 2 * random() - 1] : [out * Math.cos(turn), out * Math.sin(turn)];
            const point = scaled(plus(plus(scaled(x, right), y, up), z, -1), depth);
            if (Math.hypot(...point) > range && kind === 'point') continue;  // beyond the light
            const to_light = normalized(scaled(point, -1)), [a, b] = across(to_light), tilt = (at * 89 * Math.PI) / 180, way = 2 * Math.PI * random();
            const sine = Math.sin(tilt), normal = plus(plus(scaled(to_light, Math.cos(tilt)), a, sine * Math.cos(way)), b, sine * Math.sin(way));
            return { point, normal };
        }
    };
}
