// SPDX-License-Identifier: MIT
//
// What every path draws: boards, blocks, a fence and a sheet over a floor, under a light of each kind, seen by one camera.
// Positions are relative to an origin, which may be far from the world's.
import { cross, dot, minus, plus, unit } from '../hosts/fit_verdict.mjs';

export const picture = [360, 240];

/** Triangles of a box, seen from outside counter-clockwise: turned about y, then about x. */
function box(middle, half, [about_x, about_y] = [0, 0]) {
    const turned = ([x, y, z]) => {
        const [u, w] = [Math.cos(about_y) * x + Math.sin(about_y) * z, Math.cos(about_y) * z - Math.sin(about_y) * x];
        return [u, Math.cos(about_x) * y - Math.sin(about_x) * w, Math.sin(about_x) * y + Math.cos(about_x) * w];
    };
    const corner = signs => plus(middle, turned(signs.map((s, i) => s * half[i])), 1).map(Math.fround);
    return [0, 1, 2].flatMap(axis => [-1, 1].flatMap(side => {
        const [a, b, c, d] = [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([u, v]) => {
            const signs = [0, 0, 0];
            signs[axis] = side, signs[(axis + 1) % 3] = side * u, signs[(axis + 2) % 3] = v;
            return corner(signs);
        });
        return [[a, b, c], [a, c, d]];
    }));
}

/** Triangles of each object. The fence and the column lean: an edge along a row of texels is off as a whole. */
export const objects = [
    box([0, -0.1, 0], [10, 0.1, 10]),
    box([-4, 1.7, -3], [2.6, 0.05, 2], [0.4, 0.3]),
    [0, 1, 2, 3, 4, 5].flatMap(i => box([-4 + 0.9 * i, 0.75, 3.5], [0.08, 0.75, 0.08], [0.1, 0])),
    box([3.2, 1.3, 2.4], [2, 0.04, 1.5], [0, 0.3]),
    box([-0.8, 1.4, 0.2], [0.9, 0.9, 0.9], [0.6, 0.5]),
    box([2.2, 1.5, -3], [0.6, 1.5, 0.6], [0.12, 0.4]),
    box([5.5, 0.5, -1], [0.8, 0.5, 1.4], [0, -0.3]),
];
export const scene_box = { low: [-10, -0.2, -10], high: [10, 3.1, 10] };

const middle = (a, b) => a.map((x, i) => Math.fround((x + b[i]) / 2));

/** Triangles cut until each edge spans at most an angle, seen from a point. */
function tessellated(triangles, from, angle) {
    const spans = (p, q) => dot(unit(minus(p, from)), unit(minus(q, from))) < Math.cos(angle);
    const done = [], left = [...triangles];
    while (left.length) {
        const [a, b, c] = left.pop(), edges = [[a, b, c], [b, c, a], [c, a, b]].filter(([p, q]) => spans(p, q));
        if (!edges.length) { done.push([a, b, c]); continue; }
        const length = ([p, q]) => Math.hypot(...minus(p, q)), [p, q, r] = edges.reduce((x, y) => (length(y) > length(x) ? y : x));
        const m = middle(p, q);
        left.push([p, m, r], [m, q, r]);
    }
    return done;
}

/** Position and normal of each vertex, six floats. Casters of paraboloids have short edges. */
export function vertices(from, edge_angle) {
    const all = objects.flatMap(triangles => (edge_angle ? tessellated(triangles, from, edge_angle) : triangles));
    return new Float32Array(all.flatMap(([a, b, c]) => {
        const normal = unit(cross(minus(b, a), minus(c, a)));
        return [a, b, c].flatMap(p => [...p, ...normal]);
    }));
}

/** Matrices column by column, for depths from zero or minus one to one, nearest at zero or at one. */
export function camera({ range, direction }, origin = [0, 0, 0]) {
    const from = [3, 6, 11], back = unit(minus(from, [0, 0.3, 0])), right = unit(cross([0, 1, 0], back)), up = cross(back, right);
    const [z_near, z_far, half] = [1, 40, Math.tan(0.42)], place = plus(from, origin, 1);
    const view_at = p => [...[0, 1, 2].flatMap(i => [right[i], up[i], back[i], 0]), -dot(right, p), -dot(up, p), -dot(back, p), 1];
    const [at_near, at_far] = direction === 'reversed' ? [1, 0] : [range === 'zero_to_one' ? 0 : -1, 1];
    const slope = (at_far * z_far - at_near * z_near) / (z_near - z_far), offset = z_near * z_far * (at_near - at_far) / (z_far - z_near);
    const aspect = picture[0] / picture[1];
    const projection = [1 / (half * aspect), 0, 0, 0, 0, 1 / half, 0, 0, 0, 0, slope, -1, 0, 0, offset, 0];
    const product = (a, b) => a.map((_, i) => [0, 1, 2, 3].reduce((sum, k) => sum + a[i % 4 + 4 * k] * b[k + (i & ~3)], 0));
    return {
        view: view_at(place), projection, z_near, z_far,
        to_clip: product(projection, view_at(from)),  // of positions relative to the origin
        ray: (x, y) => {  // of a pixel, from above
            const u = (2 * (x + 0.5) / picture[0] - 1) * half * aspect, v = (1 - 2 * (y + 0.5) / picture[1]) * half;
            return [from, unit(minus(plus(plus([0, 0, 0], right, u), up, v), back))];
        },
    };
}

const position = [0.7, 4.2, 1], direction = [-6, -8, -4], high = [5, 10, 4];
const cascaded = { direction, scene: scene_box, overlap: 0.1 };
/** Where the light is, and what values() takes of it. */
export const lights = {
    spot_light: { from: high, given: { position: high, direction: [-5, -10, -4], outer_angle_radians: 0.72, z_near: 3, z_far: 24 } },
    directional_light: { along: direction, given: { direction, receivers: scene_box, casters: scene_box } },
    cascades: { along: direction, given: { ...cascaded, cascades: 4 } },
    tight_cascades: { along: direction, given: cascaded },  // of C++ alone, as a warped light
    warped_light: { along: direction, given: { direction, receivers: scene_box, casters: scene_box } },
    cascades_8: { along: direction, given: { ...cascaded, cascades: 6 } },
    warped_cascades: { along: direction, given: { ...cascaded, cascades: 3 } },
    adaptive_pages: { along: direction, given: { direction, scene: scene_box } },
    point_light: { from: position, given: { position, z_near: 0.3, z_far: 25 } },
    tetrahedron_light: { from: position, given: { position, z_near: 0.3, z_far: 25 } },
    dual_paraboloid_light: { from: position, given: { position, range: 25 } },
};
