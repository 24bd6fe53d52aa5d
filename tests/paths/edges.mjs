// SPDX-License-Identifier: MIT
//
// Where the edges of shadows stand in a picture, against rays. A judge of single pixels leaves out edges, as far as the
// filter reaches, and so it misses maps that are a texel aside. A right filter is off by as much on either side of an
// edge, and on the mean over many pixels by nothing. Maps that are a texel aside are off by a texel.
import { cross, dot, first_hit, plus, unit } from '../hosts/fit_verdict.mjs';

const rays = 48;
/** Offsets in a disc of radius 1, evenly spread, and some on its rim. */
const disc = Array.from({ length: rays }, (_, i) => {
    const away = Math.sqrt((i + 0.5) / rays), turn = i * Math.PI * (3 - Math.sqrt(5));
    return [away * Math.cos(turn), away * Math.sin(turn)];
});
const rim = Array.from({ length: 8 }, (_, i) => [Math.cos(i * Math.PI / 4), Math.sin(i * Math.PI / 4)]);

/** Two directions across a light's. They change little with it, as long as it is near another direction. */
function across(light, near) {
    const least = Math.min(...near.map(Math.abs)), axis = near.map(v => (Math.abs(v) === least ? 1 : 0));
    const right = unit(cross(light, axis));
    return [right, cross(right, light)];
}

/** A straight edge among rays around a pixel, {darkness, slope}: the share of blocked rays is the plane
 *  darkness + slope . offset in texels, by least squares.
 *  @param met   by each ray of `disc`, undefined: nothing */
function straight_edge(met, radius) {
    const sum = [0, 0];
    met.forEach((found, i) => { if (found) sum[0] += disc[i][0], sum[1] += disc[i][1]; });
    const length = Math.hypot(...sum), along = disc.map(([u, v]) => (u * sum[0] + v * sum[1]) / length);
    const blocked = along.filter((_, i) => met[i]), free = along.filter((_, i) => !met[i]);
    if (!(Math.max(...free) - Math.min(...blocked) < 0.2)) return undefined;  // a corner
    return { darkness: blocked.length / rays, slope: sum.map(v => 4 * v / rays / radius) };
}

/** By how much edges are off along their normals, in texels: {pixels, off}, a root mean square over all casters.
 *  A shadow that is shifted by d is darkness - slope . d in a pixel. So a caster's d is the least-squares solution of
 *  slope . d = darkness - seen over the pixels at its edges, and slope . d / |slope| is what an edge is off by there.
 *  @param view   as judge of fit_verdict.mjs takes it, with `surface` of a pixel and `finest` texel of a point */
export function edges_off({ width, height, objects, surface, ray, visibility, to_light, finest, reach, detachment }) {
    const caster_of = new Map(objects.flatMap(({ faces }, i) => faces.map(face => [face, i])));
    const radius = reach + 0.5;
    const casters = objects.map(({ low, high }) => {
        const center = low.map((v, i) => (v + high[i]) / 2);
        return { toward: to_light(center)[0], pixels: 0, a: 0, b: 0, c: 0, u: 0, v: 0 };
    });
    for (let y = 1; y < height - 1; ++y)
        for (let x = 1; x < width - 1; ++x) {
            const hit = surface(x, y);
            if (!hit) continue;
            const at = plus(...ray(x, y), hit.t), { normal } = hit.face, [light, distance] = to_light(at);
            const facing = dot(normal, light), size = radius * finest(at);
            if (facing < 0.1) continue;
            const meet = (offsets, [right, up]) => offsets.map(([u, v]) => {
                const offset = plus(right.map(c => c * u * size), up, v * size);
                const from = plus(plus(at, offset, 1), light, -dot(normal, offset) / facing);
                return first_hit(objects, from, light, 1e-5, distance);
            });
            const around = meet(rim, across(light, light)).filter(Boolean);
            if (around.length === 0 || around.length === rim.length) continue;
            const number = caster_of.get(around[0].face), caster = casters[number];
            const met = meet(disc, across(light, caster.toward));
            const is_other = ({ t, face }) => caster_of.get(face) !== number || t * facing < 2 * detachment;
            if (met.some(found => found && is_other(found))) continue;  // two casters, or a shadow that a bias detaches
            const edge = straight_edge(met, radius);
            if (!edge) continue;
            const [g, h] = edge.slope, off = edge.darkness - (1 - visibility(x, y));
            ++caster.pixels, caster.a += g * g, caster.b += g * h, caster.c += h * h;
            caster.u += g * off, caster.v += h * off;
        }
    let [pixels, squares, weights] = [0, 0, 0];
    for (const { pixels: own, a, b, c, u, v } of casters) {
        const determinant = a * c - b * b;
        if (!(determinant > 1e-6 * a * c)) continue;  // no edge, or all along one line
        pixels += own, weights += a + c, squares += (u * (c * u - b * v) + v * (a * v - b * u)) / determinant;
    }
    return { pixels, off: Math.sqrt(squares / weights) };
}
