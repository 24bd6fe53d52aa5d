// SPDX-License-Identifier: MIT
//
// A quay for engines other than three.js, as triangles: steps, a roofed shed, masts with a beam, a crate that is turned, a
// sheet over the ground, a ramp and a buoy. Hard edges of all angles, thin and flat casters; all of it casts and receives.

export const width = 480, height = 320, map_size = 1024;
export const camera = { at: [-5, 5.5, 10], to: [0.3, 0.6, 0], fov: 45, z_near: 0.5, z_far: 60 };

/** Where each kind of light is; all shine at the middle. */
export const lights = { directional: [-5, 8, 3.5], spot: [-4, 11, 3], point: [-1.8, 5, 1.2] };
export const cone = 0.75;  // half the spot light's angle

const minus = (a, b) => a.map((value, i) => value - b[i]);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

/** Triangles of a convex solid, outward, by its corners and polygons of them. */
const solid_of = (corners, polygons, place) => polygons.flatMap(polygon => polygon.slice(2).map(
    (_, i) => [polygon[0], polygon[i + 1], polygon[i + 2]].map(k => place(corners[k]))));

/** Turns about y, then tilts about x, then moves. */
function placing([x, y, z], turn = 0, tilt = 0) {
    const [c, s, d, t] = [Math.cos(turn), Math.sin(turn), Math.cos(tilt), Math.sin(tilt)];
    return ([a, b, e]) => {
        const [u, w] = [c * a + s * e, c * e - s * a];
        return [x + u, y + d * b - t * w, z + t * b + d * w];
    };
}

const corners_of = (w, h, d) => [0, 1, 2, 3, 4, 5, 6, 7].map(i => [(i & 1 ? 0.5 : -0.5) * w, (i & 2 ? 0.5 : -0.5) * h, (i & 4 ? 0.5 : -0.5) * d]);
const sides = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3]];
const box = (w, h, d, ...place) => solid_of(corners_of(w, h, d), sides, placing(...place));
const sheet = (w, d, ...place) => solid_of([[-w, 0, -d], [-w, 0, d], [w, 0, d], [w, 0, -d]].map(p => p.map(x => x / 2)), [[0, 1, 2, 3]],
    placing(...place));
const shed = (w, h, d, ridge, ...place) => solid_of([...corners_of(w, h, d), [0, h / 2 + ridge, -d / 2], [0, h / 2 + ridge, d / 2]],
    [[0, 2, 8, 3, 1], [4, 5, 7, 9, 6], [0, 4, 6, 2], [1, 3, 7, 5], [2, 6, 9, 8], [3, 8, 9, 7]], placing(...place));

function buoy(radius, place) {
    const ring = (y, r) => [0, 1, 2, 3, 4, 5, 6].map(i => [r * Math.cos(i * 2 * Math.PI / 7), y, r * Math.sin(i * 2 * Math.PI / 7)]);
    const corners = [[0, -radius, 0], ...ring(-0.4 * radius, 0.9 * radius), ...ring(0.4 * radius, 0.9 * radius), [0, radius, 0]];
    const around = [0, 1, 2, 3, 4, 5, 6].flatMap(i => {
        const [a, b] = [1 + i, 1 + (i + 1) % 7];
        return [[0, a, b], [a, a + 7, b + 7, b], [a + 7, 15, b + 7]];
    });
    return solid_of(corners, around, placing(place));
}

/** Objects by name, each with triangles of three points. */
export const objects = {
    ground: sheet(28, 28, [0, 0, 0]),
    ...Object.fromEntries([0, 1, 2, 3].map(i => [`step${i}`, box(3.2, 0.35 * (i + 1), 0.7, [-4, 0.175 * (i + 1), -1.5 - 0.7 * i])])),
    shed: shed(2.4, 1.6, 3, 0.9, [3.6, 0.8, -2], 0.5),
    ...Object.fromEntries([0, 1, 2, 3, 4].map(i => [`mast${i}`, box(0.07, 1.6, 0.07, [-3 + i * 1.1, 0.8, 3.2])])),
    beam: box(4.6, 0.06, 0.06, [-0.8, 1.4, 3.2]),
    crate: box(1.1, 1.1, 1.1, [0.4, 0.75, 0.6], 0.6, 0.35),
    sheet: sheet(3.6, 3, [3.6, 1.1, 2.8], 0.3),
    ramp: sheet(4, 3, [-1.2, 1, -3.4], 0, 0.45),
    buoy: buoy(0.8, [-2.4, 0.9, 0.9]),
};

/** Positions, normals and indices of an object, flat arrays as engines take them. */
export function mesh_of(triangles) {
    const normals = triangles.flatMap(([a, b, c]) => {
        const normal = cross(minus(b, a), minus(c, a)), length = Math.hypot(...normal);
        return Array(3).fill(normal.map(value => value / length)).flat();
    });
    return { positions: triangles.flat(2), normals, indices: triangles.flatMap((_, i) => [3 * i, 3 * i + 1, 3 * i + 2]) };
}
