// SPDX-License-Identifier: MIT
//
// values() and fit_shadow of the npm package with each number of a program changed: to twice, half, a thousandth, zero,
// negative and NaN. What comes back is right by rays - a point and a caster between it and the light share a place in the map,
// the caster before the point, and the maps hold what their light promises - or the number is refused by its name.
//     node values_test.mjs PACKAGE FOLDER NODE_MODULES
import { cpSync, existsSync, mkdirSync, rmSync, symlinkSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { turned_programs } from './turns.mjs';

const [umbrage, folder, node_modules] = process.argv.slice(2).map(path => resolve(path));
const modules = join(folder, 'node_modules');
rmSync(folder, { recursive: true, force: true });
mkdirSync(modules, { recursive: true });
cpSync(umbrage, join(modules, 'umbrage'), { recursive: true });
const load = path => import(pathToFileURL(join(modules, path)).href);
const package_of = await load('umbrage/umbrage.mjs'), { load_values, ...clips } = await load('umbrage/values.mjs');
const values = await load_values(), { shadow } = package_of;

const scene = { low: [-20, -1, -20], high: [20, 5, 20] };
const camera = { view: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -2, -8, 1], z_near: 0.5, z_far: 60,
    projection: [1, 0, 0, 0, 0, 1.5, 0, 0, 0, 0, -1.01, -1, 0, 0, -0.5, 0] };
const sun = { direction: [-2, -6, -3] }, bulb = { position: [0.3, 3, 0.2], z_near: 0.1, z_far: 40, border: 4 };
/** A program for each kind of light: its numbers are those of `light`, and the map's size. */
const programs = {
    spot_light: { position: [2, 6, 3], direction: [-2, -6, -3], up: [0, 1, 0], outer_angle_radians: 0.5, aspect: 1, z_near: 1, z_far: 20 },
    directional_light: { ...sun, up: [0, 1, 0], receivers: scene, margin: 0.01 },
    cascades: { ...sun, up: [0, 1, 0], scene, camera, cascades: 4, lambda: 0.9, overlap: 0.1, blend_texels: 16 },
    cascades_8: { ...sun, up: [0, 1, 0], scene, camera, cascades: 6, lambda: 0.9, overlap: 0.1, blend_texels: 16 },
    warped_cascades: { ...sun, scene, camera, cascades: 3, lambda: 0.9, overlap: 0.1 },
    point_light: bulb, tetrahedron_light: bulb, dual_paraboloid_light: { position: [0.3, 3, 0.2], range: 40, border: 4 },
};
/** Where twice or half may be refused, and the page that says so. */
const limits = [
    [/^warped_cascades cascades twice/, 'warped_maps takes 1 to 4 cascades (include/umbrage/shadow/README.md)'],
    [/^cascades(_8)? cascades twice/, 'a setup has 1 to 4, or 1 to 8 cascades (include/umbrage/shadow/README.md)'],
    [/^cascades_8 cascades half/, 'five to eight cascades are this setup, and fewer the other (include/umbrage/shadow/README.md)'],
    [/^(point|tetrahedron|dual_paraboloid)_light map_size/, 'all maps around a point are square'],
    [/lambda twice/, 'practical_splits: lambda is from 0 to 1 (include/umbrage/light/cascades/README.md)'],
    [/camera.(view|projection)/, "the matrix of no camera, or of another one than its distances say (single_include/README.md)"],
];

const sum = (a, b, t = 1) => a.map((v, i) => v + t * b[i]), dot = (a, b) => a.reduce((s, v, i) => s + v * b[i], 0);
const placed = (m, p) => [0, 1, 2, 3].map(row => m[row] * p[0] + m[row + 4] * p[1] + m[row + 8] * p[2] + m[row + 12]);
const length = v => Math.hypot(...v);
let seed = 57;
const random = () => (seed = (seed * 1103515245 + 12345) % 2147483648) / 2147483648;
const within = ({ low, high }) => low.map((v, i) => v + random() * (high[i] - v));

/** Whether a light's maps must hold a point, with some room; undefined where the light makes no promise. */
function promised(kind, light, p) {
    if (light.receivers || kind === 'directional_light') return true;
    if (light.camera) {
        const [x, y, , w] = placed(light.camera.projection, placed(light.camera.view, p));
        const ahead = -placed(light.camera.view, p)[2];
        return w > 0 && Math.max(Math.abs(x), Math.abs(y)) < 0.99 * w && ahead > 1.01 * light.camera.z_near && ahead < 0.99 * light.camera.z_far;
    }
    const from = sum(p, light.position, -1), away = length(from);
    if (kind !== 'spot_light') return away > 3.1 * light.z_near && away < 0.99 * light.z_far;
    const along = dot(from, light.direction) / length(light.direction);
    return along > 1.01 * light.z_near && along < 0.99 * light.z_far && along > away * Math.cos(0.98 * light.outer_angle_radians);
}

/** What is wrong with a light's matrices, by rays; undefined if nothing is. */
function wrong_by_rays(kind, light, { block, matrices, views }) {
    const floats = [...block, ...matrices.flatMap(m => [...m]), ...views.flatMap(v => [...v.to_clip, ...v.anchor])];
    if (!floats.every(Number.isFinite)) return 'a float that is not finite';
    let [held, tried] = [0, 0];
    const box = light.scene ?? light.receivers ?? scene;
    for (let i = 0; i < 400 && matrices.length; ++i) {
        const p = within(box), way = light.position ? sum(light.position, p, -1) : light.direction.map(v => -v);
        if (!promised(kind, light, p)) continue;
        ++tried;
        const q = sum(p, way, light.position ? 0.1 : 0.3 / length(way));  // a caster on the way to the light
        const maps = matrices.filter(m => {
            const [x, y, z, w] = placed(m, p);
            return w > 0 && Math.max(Math.abs(x), Math.abs(y)) <= w * 1.001 && z >= -w * 1.001 && z <= w * 1.001;
        });
        if (maps.length === 0) return `no map holds (${p})`;
        ++held;
        for (const m of maps) {
            const a = placed(m, p), b = placed(m, q), off = [0, 1].map(k => Math.abs(a[k] / a[3] - b[k] / b[3]));
            if (b[3] > 0 && Math.max(...off) > 2e-3) return `a caster is elsewhere in the map than (${p})`;
            if (b[3] > 0 && !(b[2] / b[3] < a[2] / a[3])) return `a caster is behind (${p})`;
        }
    }
    return undefined;
}

const programs_turned = new turned_programs(limits);
const is_whole = path => ['cascades', 'border'].includes(path.at(-1)) || path[0] === 'map_size';
for (const [kind, light] of Object.entries(programs))
    programs_turned.run_all(kind, { map_size: [512, 512], ...light }, ({ map_size, ...own }) => {
        const of_kind = shadow('sun', { kind: package_of[kind], filter: package_of.tent3, map_size });
        return wrong_by_rays(kind, own, values(of_kind, { clip: clips.opengl_clip_space, ...own }));
    }, is_whole);

/** Mistakes of a package, which the rays must see: what a program with none of its numbers changed would be told. */
const faults = {
    'matrices are transposed': ({ matrices, ...all }) => ({ ...all, matrices: matrices.map(m => m.map((_, i) => m[4 * (i % 4) + (i >> 2)])) }),
    'depth has the other direction': ({ matrices, ...all }) => ({ ...all, matrices: matrices.map(m => m.map((v, i) => (i % 4 === 2 ? -v : v))) }),
    'a float is NaN': ({ block, ...all }) => ({ ...all, block: block.map((v, i) => (i === 5 ? NaN : v)) }),
    'x and y are exchanged for a part of the scene': ({ matrices, ...all }) => ({ ...all, matrices: matrices.map(m => m.map((v, i) => (i === 0 ? 3 * v : v))) }),
};
let seen = 0;
for (const [what, plant] of Object.entries(faults)) {
    const found = Object.entries(programs).filter(([kind, light]) => {
        const of_kind = shadow('sun', { kind: package_of[kind], filter: package_of.tent3, map_size: 512 });
        return wrong_by_rays(kind, light, plant(values(of_kind, { clip: clips.opengl_clip_space, ...light }))) !== undefined;
    });
    if (found.length === 0) programs_turned.fails(`${what}: not seen`);
    else ++seen;
}
for (const drop of ['position', 'direction', 'outer_angle_radians', 'z_far']) {  // a default in place of what is given
    const { [drop]: _, ...rest } = programs.spot_light;
    const others = { z_far: { z_far: 3 }, outer_angle_radians: { outer_angle_radians: 0.1 } }[drop] ?? {};
    const of_kind = shadow('sun', { kind: package_of.spot_light, filter: package_of.tent3, map_size: 512 });
    const made = values(of_kind, { clip: clips.opengl_clip_space, ...rest, ...others });
    if (wrong_by_rays('spot_light', programs.spot_light, made) === undefined) programs_turned.fails(`the spot's ${drop} is dropped: not seen`);
    else ++seen;
}

/** fit_shadow of three.js: the fitted camera holds each receiver that the light reaches. */
async function fits() {
    symlinkSync(join(node_modules, 'three'), join(modules, 'three'));
    const THREE = await load('three/build/three.module.js'), { fit_shadow } = await load('umbrage/npm/three.mjs');
    const common = { position: [5, 12, 4], mapSize: [1024, 1024], radius: 2, reach: 2, receivers: { low: [-9, 0, -9], high: [9, 4, 9] } };
    const kinds = {
        DirectionalLight: { ...common, target: [1, 0, 1] }, PointLight: { ...common, distance: 60 },
        SpotLight: { ...common, target: [1, 0, 1], angle: 0.7, distance: 60 },
    };
    const at = v => new THREE.Vector3(...v);
    for (const [kind, program] of Object.entries(kinds))
        programs_turned.run_all(kind, program, all => {
            const light = new THREE[kind]();
            light.position.copy(at(all.position));
            if (all.target) light.target.position.copy(at(all.target));
            for (const key of ['angle', 'distance']) if (key in all) light[key] = all[key];
            light.shadow.mapSize.set(...all.mapSize);
            light.shadow.radius = all.radius;
            const { low, high } = all.receivers, receivers = new THREE.Box3(at(low), at(high));
            const fitted = fit_shadow(light, { receivers, reach: all.reach });
            if (!Object.values(fitted).every(v => typeof v !== 'number' || Number.isFinite(v))) return 'a number that is not finite';
            const range = all.distance > 0 ? all.distance : Infinity;  // as three.js reads it
            for (let i = 0; i < 60; ++i) {
                const p = at(within(all.receivers)), { camera, matrix } = light.shadow, from = p.clone().sub(light.position);
                if (kind === 'PointLight') {
                    const depth = Math.max(...from.toArray().map(Math.abs));
                    if (depth > camera.far * 1.001 && depth < range || depth < camera.near && !fitted.casters_are_cut)
                        return `no map holds (${p.toArray()})`;
                    continue;
                }
                const axis = light.target.position.clone().sub(light.position);
                if (kind === 'SpotLight' && (from.angleTo(axis) > 0.98 * all.angle || from.length() > range)) continue;
                light.shadow.updateMatrices(light);
                const place = new THREE.Vector4(...p.toArray(), 1).applyMatrix4(matrix);
                const { x, y, z } = place.divideScalar(place.w);
                const near = z >= -1e-5 || fitted.casters_are_cut;
                if (!(x > -1e-5 && x < 1 + 1e-5 && y > -1e-5 && y < 1 + 1e-5 && z < 1 + 1e-5 && near)) return `no map holds (${p.toArray()})`;
            }
            return undefined;
        });
}
if (existsSync(join(node_modules, 'three'))) await fits();
else console.log(`no three in ${node_modules}: its fits are left out`);

console.log(`${programs_turned.summary('right by rays')}; ${seen} faults seen`);
process.exit(programs_turned.failed ? 1 : 0);
