// SPDX-License-Identifier: MIT
//
// A path's picture against rays: which pixels are dark though nothing shades them, and which are lit under a caster.
import { cross, dot, first_hit, judge, minus, plus, surface_at, traced, unit } from '../hosts/fit_verdict.mjs';
import { edges_off } from './edges.mjs';
import { light_from } from './light.mjs';
import { camera, lights, objects, picture } from './scene.mjs';

const all = objects.map(traced), [width, height] = picture, { ray } = camera({ range: 'zero_to_one', direction: 'forward' });

/** Points that a sixteenth of the picture sees, with their normals: four floats each. */
export function seen_by_camera() {
    const points = [], normals = [];
    for (let y = 2; y < height; y += 4)
        for (let x = 2; x < width; x += 4) {
            const [from, along] = ray(x, y), hit = first_hit(all, from, along, 0, Infinity, true);
            points.push(...hit ? [...plus(from, along, hit.t), 1] : [0, 0, 0, 0]);
            normals.push(...hit ? [...hit.face.normal, 0] : [0, 0, 0, 0]);
        }
    return { points, normals };
}

/** Texels of a map, in world units across the light, at a point that it holds. */
function texel_in(matrix, [columns, rows], p, light) {
    const at = q => {
        const [x, y, z, w] = [0, 1, 2, 3].map(i => matrix[i] * q[0] + matrix[4 + i] * q[1] + matrix[8 + i] * q[2] + matrix[12 + i]);
        const holds = w > 0 && Math.abs(x) < w && Math.abs(y) < w && Math.abs(z) <= w;
        return { u: (x / w + 1) / 2 * columns, v: (y / w + 1) / 2 * rows, holds };
    };
    const middle = at(p), step = 1e-3;
    const right = unit(cross(light, Math.abs(light[1]) < 0.9 ? [0, 1, 0] : [1, 0, 0])), up = cross(right, light);
    if (!middle.holds) return undefined;
    const [[a, b], [c, d]] = [right, up].map(way => {
        const q = at(plus(p, way, step));
        return [(q.u - middle.u) / step, (q.v - middle.v) / step];
    });
    const trace = a * a + b * b + c * c + d * d, determinant = a * d - b * c;
    return 1 / Math.sqrt((trace - Math.sqrt(Math.max(0, trace * trace - 4 * determinant * determinant))) / 2);
}

const surfaces = [];  // of pixels, which all paths share
const surface = (x, y) => {
    const i = y * width + x;
    if (!(i in surfaces)) surfaces[i] = surface_at(all, ray, x, y, 1e-5);
    return surfaces[i];
};

/** What rays say of a picture: judge's counts, and what edges are off by.
 *  @param values   of the path's light, by the package
 *  @param pixels   visibility from above, 255 is lit */
export function judged(path, shadow, { matrices }, border, pixels) {
    const from = light_from(path), along = lights[path.setup].along;
    const to_sun = along && unit(along.map((x, i) => -(x + path.shift[i])));
    const to_light = p => (from ? [unit(minus(from, p)), Math.hypot(...minus(from, p))] : [to_sun, Infinity]);
    const texels = p => {  // of the maps that hold a point, the finest first
        const [light, distance] = to_light(p);
        if (path.setup === 'dual_paraboloid_light')
            return [2 * (distance + Math.abs(from[2] - p[2])) / (path.map_size - 2 * border)];
        const held = matrices.map(m => texel_in(m, shadow.target.map_size, p, light)).filter(Boolean);
        return held.length ? held.sort((a, b) => a - b) : [Infinity];
    };
    const view = { width, height, scale: 1, objects: all, ray, visibility: (x, y) => pixels[y * width + x] / 255, to_light,
        texel: p => texels(p)[1] ?? texels(p)[0],  // two cascades are blended: the coarser one's
        reach: shadow.settings.filter.filter.reach, detachment: 0.1, shift: 0 };
    return { ...judge(view), at_edges: edges_off({ ...view, finest: p => texels(p)[0], surface }) };
}
