// SPDX-License-Identifier: MIT
//
// The picture of the bias page: a floor, a thin board and a thin post, some texels large, seen from above.
import type { Face, Shadow } from './emulate';
import { cross, dot, normalized, plus, scaled, type Vector } from './vector';

/** Units of the scene that the picture is wide: texels of a map, unless they are large. */
export const units_across = 48;

const floor_color: Vector = [222, 212, 192], wood_color: Vector = [196, 120, 56];

function face(corner: Vector, u: Vector, v: Vector, out: Vector): Face {
    const normal = normalized(cross(u, v));
    return { corner, u, v, normal: dot(normal, out) < 0 ? scaled(normal, -1) : normal };
}

/** A box that stands on the floor: its four sides and its top. */
function box([x, z]: [number, number], [wide, high, deep]: Vector, turn: number): Face[] {
    const a: Vector = [wide * Math.cos(turn), 0, wide * Math.sin(turn)], b: Vector = [-deep * Math.sin(turn), 0, deep * Math.cos(turn)];
    const up: Vector = [0, high, 0], corner: Vector = [x, 0, z], far = plus(plus(corner, a), b);
    return [face(corner, a, up, scaled(b, -1)), face(corner, b, up, scaled(a, -1)), face(far, scaled(a, -1), up, b),
        face(far, scaled(b, -1), up, a), face([x, high, z], a, b, [0, 1, 0])];
}

/** A part of the floor, more than the picture shows. */
const floor = face([-80, 0, -80], [160, 0, 0], [0, 0, 160], [0, 1, 0]);

/** What casts. */
const scene: Face[] = [floor, ...box([-13, -2], [18, 9, 1.5], 0.35),
    ...box([10, 5], [1.5, 16, 1.5], 0.6), ...box([-8, 9], [9, 1.2, 1.2], -0.5)];

const view: Vector = normalized([0.25, 0.8, 0.75]);  // from the scene to the eye
const right = normalized(cross([0, 1, 0], view)), above = cross(view, right);

/** A face as the camera's parallel rays meet it: linear functions of the picture's coordinates. */
interface Seen {
    face: Face;
    /** Depth towards the eye, and place on the face along u and v: at (0, 0), and what x and y add. */
    lines: Vector[];
}

function seen_by(face: Face): Seen[] {
    const facing = dot(face.normal, view), uu = dot(face.u, face.u), vv = dot(face.v, face.v);
    if (facing < 1e-9) return [];  // boxes are closed
    const [start, x_end, y_end] = ([[0, 0, 0], right, above] as const).map(from => {
        const at = dot(face.normal, plus(face.corner, from, -1)) / facing, inside = plus(plus(from, view, at), face.corner, -1);
        return [at, dot(inside, face.u) / uu, dot(inside, face.v) / vv] as const;
    });
    return [{ face, lines: [0, 1, 2].map(i => [start![i]!, x_end![i]! - start![i]!, y_end![i]! - start![i]!] as const) }];
}

/** The nearest face at a place of the picture. */
function hit(all: Seen[], x: number, y: number): { face: Face; point: Vector } | undefined {
    let best = -Infinity, found: Face | undefined;
    for (const { face, lines: [depth, s, t] } of all) {
        const at = depth![0] + depth![1] * x + depth![2] * y;
        if (at <= best) continue;
        const a = s![0] + s![1] * x + s![2] * y, b = t![0] + t![1] * x + t![2] * y;
        if (a >= 0 && a <= 1 && b >= 0 && b <= 1) (best = at), (found = face);
    }
    return found && { face: found, point: plus(plus(scaled(right, x), above, y), view, best) };
}

/** Noise that turns a disc from pixel to pixel, as engines have it. */
function noise(x: number, y: number): number {
    const fraction = (value: number) => value - Math.floor(value);
    return 2 * Math.PI * fraction(52.9829189 * fraction(0.06711056 * x + 0.00583715 * y));
}

/** Where the scene lies in the world of a light. */
export interface Place {
    /** Of the scene's units. */
    unit: number;
    middle: Vector;
}

const in_world = (v: Vector, { unit, middle }: Place): Vector => plus(middle, v, unit);

/** The scene's faces in the world: what casts. */
export const faces_at = (place: Place): Face[] =>
    scene.map(({ corner, u, v, normal }) => ({ corner: in_world(corner, place), u: scaled(u, place.unit), v: scaled(v, place.unit), normal }));

/** A point of the floor that the picture shows. */
export function on_floor(place: Place, random: () => number): { point: Vector; normal: Vector } {
    return { point: in_world([(random() - 0.5) * units_across, 0, (random() - 0.5) * units_across], place), normal: floor.normal };
}

const visible = scene.flatMap(seen_by);

/** Draws the scene under a light. */
export function draw(canvas: HTMLCanvasElement, shadow: Shadow, place: Place): void {
    const { width, height } = canvas, context = canvas.getContext('2d')!, image = context.createImageData(width, height);
    const pixel = units_across / width;
    for (let y = 0; y < height; ++y)
        for (let x = 0; x < width; ++x) {
            const seen = hit(visible, (x + 0.5 - width / 2) * pixel, (height / 2 - y - 0.5) * pixel);
            if (!seen) continue;
            const { normal } = seen.face, point = in_world(seen.point, place), cosine = dot(normal, shadow.to_light(point));
            const lit = cosine > 0 ? shadow.visibility(point, normal, noise(x, y)) : 0;
            const shade = 0.32 + 0.68 * lit * Math.min(Math.max(cosine, 0) * 0.6 + 0.4, 1);
            const color = seen.face === floor ? floor_color : wood_color, at = 4 * (y * width + x);
            for (let channel = 0; channel < 3; ++channel) image.data[at + channel] = color[channel]! * shade;
            image.data[at + 3] = 255;
        }
    context.putImageData(image, 0, 0);
}
