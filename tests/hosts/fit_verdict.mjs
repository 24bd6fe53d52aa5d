// SPDX-License-Identifier: MIT
//
// Verdicts on pixels that an engine has drawn, by rays in doubles: which are dark where nothing shades them, and which are
// lit under a caster. No engine is in here.

const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const plus = (a, b, t) => [a[0] + b[0] * t, a[1] + b[1] * t, a[2] + b[2] * t];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = a => { const length = Math.hypot(...a); return a.map(x => x / length); };

/** Triangles of an object, [a, b, c] each, with a box around them. */
export function traced(triangles) {
    const corners = triangles.flat(), bound = pick => [0, 1, 2].map(axis => corners.reduce((v, p) => pick(v, p[axis]), corners[0][axis]));
    return { low: bound(Math.min), high: bound(Math.max), faces: triangles.map(([a, b, c]) => {
        const e = minus(b, a), f = minus(c, a);
        return { a, e, f, normal: unit(cross(e, f)) };
    }) };
}

/** Whether a ray meets a box between two distances. */
function meets(low, high, from, along, enter, leave) {
    for (let axis = 0; axis < 3; ++axis) {
        const s = (low[axis] - from[axis]) / along[axis], t = (high[axis] - from[axis]) / along[axis];
        if (s < t) {
            if (s > enter) enter = s;
            if (t < leave) leave = t;
        } else if (t <= s) {
            if (t > enter) enter = t;
            if (s < leave) leave = s;
        }
    }
    return enter <= leave + 1e-6;
}

/** The first face on a ray between two distances: {t, face}. */
function first_hit(objects, from, along, nearest, farthest, front = false) {
    let t_first = farthest, first;
    for (const { low, high, faces } of objects) {
        if (!meets(low, high, from, along, nearest, t_first)) continue;
        for (const face of faces) {
            const { a, e, f, normal } = face;
            if (front && dot(normal, along) >= 0) continue;
            const p = cross(along, f), scale = dot(e, p), q = minus(from, a), u = dot(q, p) / scale;
            if (!(u >= 0 && u <= 1)) continue;
            const r = cross(q, e), v = dot(along, r) / scale, t = dot(f, r) / scale;
            if (v >= 0 && u + v <= 1 && t > nearest && t < t_first) t_first = t, first = face;
        }
    }
    return first && { t: t_first, face: first };
}

/** The first face in a pixel, {t, face}; undefined at an edge, where the pixel may be another surface's. */
function surface_at(objects, ray, x, y, eps) {
    const hit_of = (i, j) => first_hit(objects, ...ray(x + i, y + j), 0, Infinity, true), hit = hit_of(0, 0);
    return hit && [[1, 0], [-1, 0], [0, 1], [0, -1]].every(([i, j]) => {
        const { face } = hit_of(i, j) ?? {};
        return face && dot(face.normal, hit.face.normal) >= 0.9999 && Math.abs(dot(minus(face.a, hit.face.a), hit.face.normal)) <= eps;
    }) ? hit : undefined;
}

/** Shares of pixels that are wrong.
 *  @param objects      of traced
 *  @param ray          of pixel (x, y) from above: [from, along]
 *  @param visibility   of pixel (x, y) from above: 0 dark, 1 lit; undefined without light
 *  @param to_light     of a point: [direction, distance]
 *  @param texel        of a point, in world units
 *  @param reach        of the filter, in texels
 *  @param detachment   that was promised, in world units; undefined: nothing was, and pixels are judged by fewer rays
 *  @param slip         by which the engine moves casters, and with them the edges of shadows: pixels so near to one are counted apart.
 *                      Under a spot or a point light casters are halfway to it at most
 *  @param clear_angle  between normal and light, beyond which pixels within the filter of a hard edge are counted apart
 *  @param shift        by which the engine moves a receiver along its normal, and with it the shadow's edge sidewards
 *  @param scale        of the world
 *  @return             {lit, falsely_dark, at_edges, moved, dark, falsely_lit, lost, detached}; lost: lit under casters above
 *                      twice the detachment; detached: the highest caster over a pixel that is lit under it, in texels */
export function judge({ width, height, objects, ray, visibility, to_light, texel, reach, detachment, shift, scale,
    slip = 0, clear_angle = Math.PI / 2 }) {
    const count = { lit: 0, falsely_dark: 0, at_edges: 0, moved: 0, dark: 0, falsely_lit: 0, lost: 0, detached: 0 }, step = 3, eps = 1e-5 * scale;
    for (let y = 1; y < height - 1; y += step)
        for (let x = 1; x < width - 1; x += step) {
            const hit = surface_at(objects, ray, x, y, eps);
            if (!hit) continue;
            const seen = visibility(x, y), at = plus(...ray(x, y), hit.t), [light, distance] = to_light(at), { normal } = hit.face;
            const facing = dot(normal, light);
            if (seen === undefined || facing < 0.02) continue;
            const right = unit(cross(light, Math.abs(light[1]) < 0.9 ? [0, 1, 0] : [1, 0, 0])), up = cross(right, light);
            const rings = (radii, directions, more = 0) => {
                let [blocked, tried, lowest, highest] = [0, 0, Infinity, 0];
                for (let k = 0; k <= radii; ++k)
                    for (let i = 0; i < (k ? directions : 1); ++i) {
                        const turn = i * 2 * Math.PI / directions + k, away = k / radii * ((reach + 1.5) * texel(at) + more);
                        const ring = plus(right.map(v => v * away * Math.cos(turn)), up, away * Math.sin(turn));
                        const offset = plus(ring, plus(normal, light, -facing), shift);
                        const from = plus(plus(at, offset, 1), light, -dot(normal, offset) / facing);
                        const found = first_hit(objects, from, light, eps, distance);
                        ++tried, blocked += found !== undefined, lowest = Math.min(lowest, (found?.t ?? 0) * facing);
                        highest = Math.max(highest, found?.t ?? 0);
                    }
                return { blocked, tried, lowest, highest };
            };
            const by_edge = () => [1, 2, 3, 4].some(k => Array.from({ length: 16 }, (_, i) => i * Math.PI / 8 + k).some(turn => {
                const away = k / 4 * (reach + 1.5) * texel(at), ring = plus(right.map(v => v * away * Math.cos(turn)), up, away * Math.sin(turn));
                const on_plane = plus(at, plus(ring, light, -dot(normal, ring) / facing), 1), above = plus(on_plane, normal, eps);
                return first_hit(objects, above, normal.map(v => -v), 0, 2 * eps) === undefined;
            }));
            const { blocked, tried, lowest, highest } = rings(2, 8), wider = distance < Infinity ? distance / (distance - highest) : 1;
            if (blocked === 0 && (seen > 0.99 || detachment === undefined || rings(8, 32).blocked === 0)) {
                const steep = Math.acos(facing) > clear_angle, wide = distance < Infinity ? 2 * slip : slip;
                ++count.lit;
                if (seen < 0.99)
                    ++count[steep && by_edge() ? 'at_edges' : slip && rings(8, 32, wide).blocked > 0 ? 'moved' : 'falsely_dark'];
            }
            if (blocked === tried && (seen < 0.01 || detachment === undefined || rings(8, 32, slip * wider).blocked === 257)) {
                ++count.dark, count.falsely_lit += seen > 0.01;
                if (seen > 0.01) count.detached = Math.max(count.detached, lowest / texel(at));
                count.lost += seen > 0.01 && detachment !== undefined && lowest > 2 * detachment + texel(at);
            }
        }
    return count;
}

export { cross, dot, first_hit, minus, plus, surface_at, unit };
