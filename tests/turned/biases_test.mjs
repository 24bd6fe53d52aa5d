// SPDX-License-Identifier: MIT
//
// fit_bias of Babylon.js and PlayCanvas, and engine_bias, with each number and flag of a program changed: what they set frees a
// plane of acne, by the texels that points take in the engine's own map, or the number is refused by its name.
//     node biases_test.mjs PACKAGE FOLDER NODE_MODULES
import { cpSync, existsSync, mkdirSync, rmSync, symlinkSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { turned_programs } from './turns.mjs';

const [umbrage, folder, node_modules] = process.argv.slice(2).map(path => resolve(path));
const modules = join(folder, 'node_modules');
rmSync(folder, { recursive: true, force: true });
mkdirSync(modules, { recursive: true });
cpSync(umbrage, join(modules, 'umbrage'), { recursive: true });
for (const host of ['@babylonjs', 'playcanvas'])
    if (existsSync(join(node_modules, host))) symlinkSync(join(node_modules, host), join(modules, host));
const load = path => import(pathToFileURL(join(modules, path)).href);
const glsl = await load('umbrage/umbrage.mjs');

const programs = new turned_programs([]);
/** Mistakes after a fit, each of which must be seen. */
const spoiled = (what, wrong) => wrong() ?? programs.fails(`${what}: not seen`);
const is_finite = all => Object.values(all).every(v => typeof v !== 'number' || Number.isFinite(v));

async function babylon() {
    const names = ['Engines/nullEngine', 'Cameras/freeCamera', 'Lights/directionalLight', 'Lights/pointLight', 'Lights/spotLight',
        'Lights/Shadows/shadowGenerator', 'Lights/Shadows/shadowGeneratorSceneComponent', 'Maths/math.vector',
        'Meshes/Builders/boxBuilder', 'scene'];
    const { NullEngine, FreeCamera, DirectionalLight, PointLight, SpotLight, ShadowGenerator, Vector3, CreateBox, Scene } =
        Object.assign({}, ...await Promise.all(names.map(name => load(`@babylonjs/core/${name}.js`))));
    const { fit_bias, install, uninstall } = await load('umbrage/npm/babylon.mjs');
    const engine = new NullEngine(), at = v => new Vector3(...v);
    engine._features.supportShadowSamplers = true;  // as engines have it
    engine.createDepthStencilTexture = () => null;  // which this engine has not
    Object.defineProperty(engine, 'version', { value: 2 });
    const lights = {
        directional: (all, scene) => new DirectionalLight('', at(all.direction), scene),
        spot: (all, scene) => new SpotLight('', at(all.position), at(all.direction), all.angle, 1, scene),
        point: (all, scene) => new PointLight('', at(all.position), scene),
    };
    /** What is wrong with a fit: corners of receivers that the map has not, or casters that move by too little for a filter. */
    const wrong = (kind, all, filter, spoil = () => {}) => {
        const scene = new Scene(engine), light = lights[kind](all, scene);
        try {
            new FreeCamera('', new Vector3(0, 5, -20), scene);
            light.position = at(all.position);
            if (all.range !== undefined) light.range = all.range;
            const generator = new ShadowGenerator(all.map_size, light), mesh = CreateBox('', { size: all.size }, scene);
            mesh.position = at(all.place);
            mesh.receiveShadows = true;
            const size = { width: all.map_size, height: all.map_size };
            if (kind === 'point') generator.getShadowMap().getSize = () => size;  // a cube has none in this engine
            generator[filter] = true;
            generator.addShadowCaster(mesh);
            const fitted = fit_bias(generator, { steady: all.steady });
            spoil(generator, light);
            if (!is_finite(fitted)) return `a number that is not finite: ${JSON.stringify(fitted)}`;
            const { bias, normalBias } = generator;
            if (!(bias >= 0 && normalBias > 0)) return `bias ${bias} and normalBias ${normalBias}`;
            if (kind === 'point') return undefined;
            const matrix = generator.getTransformMatrix(), project = p => Vector3.TransformCoordinates(p, matrix);
            const along = light.getShadowDirection().normalizeToNew();
            const across = Vector3.Cross(along, at([0.3, 0.5, 0.7])).normalize();
            let largest = 0;
            for (const corner of mesh.getBoundingInfo().boundingBox.vectorsWorld) {
                const ray = corner.subtract(light.getAbsolutePosition());
                const angle = Math.acos(Vector3.Dot(ray, along) / ray.length());
                if (kind === 'spot' && (ray.length() > all.range || angle > light.angle / 2)) continue;
                const { x, y, z } = project(corner), step = 1e-4 * all.size;
                if (Math.max(Math.abs(x), Math.abs(y), Math.abs(z)) > 1 + 1e-6) return `no map holds (${corner.asArray()})`;
                const moved = project(corner.add(across.scale(step)));
                largest = Math.max(largest, step / (Math.hypot(moved.x - x, moved.y - y) * all.map_size / 2));  // of texels
            }
            // a caster that moves by n sin t along its normal is n tan t farther away, where a filter needs reach texel tan t
            if (normalBias < fitted.reach * largest * 0.999) return `normalBias ${normalBias} for ${fitted.reach} texels of ${largest}`;
            return undefined;
        } finally { scene.dispose(); }
    };
    const common = { position: [3, 20, -4], place: [1, 2, 0.5], size: 6, map_size: 512, steady: false };
    const kinds = {
        directional: { ...common, direction: [-2, -6, 1] }, spot: { ...common, direction: [-2, -18, 4.5], angle: 0.9, range: 60 },
        point: { ...common, range: 60 },
    };
    for (const filter of ['usePercentageCloserFiltering', 'usePoissonSampling'])
        for (const [kind, program] of Object.entries(kinds))
            programs.run_all(`babylon ${kind} ${filter}`, program, all => wrong(kind, all, filter), path => path[0] === 'map_size');
    for (const kind of ['directional', 'spot']) {
        const wrong_with = spoil => wrong(kind, kinds[kind], 'usePercentageCloserFiltering', spoil);
        spoiled(`babylon ${kind}: half of normalBias`, () => wrong_with(generator => { generator.normalBias *= 0.5; }));
        spoiled(`babylon ${kind}: planes moved`, () => wrong_with((_, light) => {
            light.shadowMinZ += 2;
            light.forceProjectionMatrixCompute();
        }));
    }
    // filters of this package, whose arguments say how far they reach
    for (const [name, options] of Object.entries({ box: { radius: 2 }, disc16: { radius: 3 } }))
        programs.run_all(`babylon directional ${name}`, { arguments: options }, all => {
            try {
                install(engine, { glsl: glsl[name], ...all });
                return wrong('directional', kinds.directional, 'usePercentageCloserFiltering');
            } finally { uninstall(engine); }
        }, () => name === 'box');
    engine.dispose();
}

async function playcanvas() {
    const pc = await load('playcanvas/build/playcanvas/src/index.js'), { fit_bias } = await load('umbrage/npm/playcanvas_fit.mjs');
    const common = { size: [10, 2, 10], position: [0, 12, 0], shadowResolution: 1024, range: 30 };
    const camera = { nearClip: 0.1, farClip: 1000, fov: 45, aspectRatio: 1.5 };
    const kinds = {
        directional: { ...common, camera, numCascades: 2, cascadeDistribution: 0.5, shadowDistance: 40 },
        spot: { ...common, outerConeAngle: 40 }, omni: common,
    };
    const wrong = (kind, { size, position, camera: own, ...numbers }, spoil = () => {}) => {
        const box = { aabb: new pc.BoundingBox(new pc.Vec3(0, 0, 0), new pc.Vec3(...size)) }, root = new pc.Entity(), entity = new pc.Entity();
        root.findComponents = () => [{ enabled: true, entity: { enabled: true }, meshInstances: [box] }];
        entity.setPosition(...position);
        const app = { root, scene: { clusteredLightingEnabled: false }, graphicsDevice: {} };
        const light = { type: kind, entity, system: { app }, shadowType: pc.SHADOW_PCF5_32F, normalOffsetBias: 0, shadowBias: 0,
            ...numbers };
        const viewer = own && { ...own, aspectRatioMode: pc.ASPECT_MANUAL, projection: pc.PROJECTION_PERSPECTIVE,
            calculateAspectRatio: () => own.aspectRatio };
        const fitted = fit_bias(light, viewer && { camera: viewer });
        spoil(light);
        if (!is_finite(fitted)) return `a number that is not finite: ${JSON.stringify(fitted)}`;
        const { normalOffsetBias, shadowBias } = light, { texels_per_unit, lacks, reach, detachment } = fitted;
        if (![normalOffsetBias, shadowBias].every(bias => bias >= 0 && bias <= 1)) return `biases ${normalOffsetBias}, ${shadowBias}`;
        if (kind === 'omni') return lacks > 0 || detachment > 0 ? undefined : 'no detachment';
        // the texel of a map that holds the widest part of the view, or the cone at the farthest receiver
        const texel = kind === 'spot'
            ? 2 * Math.tan(numbers.outerConeAngle * Math.PI / 180) * Math.min(farthest(size, position), numbers.range) / numbers.shadowResolution
            : 2 * last_half_width(own, numbers) / (numbers.shadowResolution * (numbers.numCascades > 1 ? 0.5 : 1));
        if (kind === 'directional' && Math.abs(texel * texels_per_unit - 1) > 1e-6) return `${texels_per_unit} texels per unit, of ${texel}`;
        if (texel * texels_per_unit > 1.3) return `${texels_per_unit} texels per unit, of ${texel}`;
        return normalOffsetBias + lacks >= reach / texels_per_unit ? undefined : `normalOffsetBias ${normalOffsetBias} for ${reach} texels`;
    };
    for (const [kind, program] of Object.entries(kinds)) {
        programs.run_all(`playcanvas ${kind}`, program, all => wrong(kind, all), path => ['numCascades', 'shadowResolution'].includes(path[0]));
        if (kind !== 'omni')
            spoiled(`playcanvas ${kind}: half of normalOffsetBias`, () => wrong(kind, program, light => { light.normalOffsetBias *= 0.5; }));
    }
}
/** The depth of a box's farthest point below a light, and half the map's width that the last part of a view takes. */
const farthest = ([, height], [, from]) => from + height;
function last_half_width({ nearClip: near, farClip, fov, aspectRatio }, { numCascades: count, cascadeDistribution, shadowDistance }) {
    const far = Math.min(farClip, shadowDistance), share = (count - 1) / count, even = near + (far - near) * share;
    const first = even + (near * (far / near) ** share - even) * cascadeDistribution, height = far * Math.tan(fov * Math.PI / 360);
    return Math.hypot(height, height * aspectRatio, (far - first) / 2);
}

/** Numbers for engines' settings: enough at each tilt, as their formulas have it, and the same for lengths of another unit. */
async function engines() {
    const { engine_bias, engines, lights_of } = await load('umbrage/npm/engines.mjs');
    for (const [engine, { filters, radius }] of Object.entries(engines))
        for (const light of lights_of(engine)) {
            const sizes = light === 'directional' ? { width: 40, extent: 40 } : { distance: 8, near: 0.3, extent: 10, ...light === 'spot' && { angle: 60 } };
            const program = { map_size: 1024, range: light === 'directional' ? 100 : 10, ...sizes, ...radius && { radius: 1 } };
            for (const filter of Object.keys(filters).slice(0, light === 'directional' ? undefined : 1))  // cones take long
                programs.run_all(`${engine} ${light} ${filter}`, program, all => {
                    const { settings, lacking, striped, texel, reach, detachment } = engine_bias({ engine, light, filter, ...all });
                    if (!is_finite({ ...settings, lacking, texel, reach, detachment })) return `a number that is not finite: ${JSON.stringify(settings)}`;
                    const ends = Object.values(settings).includes(10), has_none = engine === 'unity_urp' && light === 'point';
                    const blurless = engine === 'godot' && all.radius === 0;
                    if (light === 'directional' && Math.abs(texel * (all.map_size - 2 * (engines[engine].border ?? 0)) / all.width - 1) > 1e-9)
                        return `a texel of ${texel}`;
                    if (lacking > 0 ? !(ends || has_none || blurless) || !striped : striped) return `lacks ${lacking} texels, ${striped}`;
                    return detachment >= 0 && reach > 0 ? undefined : `detachment ${detachment}, reach ${reach}`;
                }, path => path[0] === 'map_size');
        }
}

await engines();
for (const [module, run] of Object.entries({ '@babylonjs': babylon, playcanvas })) {
    if (existsSync(join(modules, module))) await run();
    else console.log(`no ${module} in ${node_modules}: its biases are left out`);
}
console.log(programs.summary('right by their formula'));
process.exit(programs.failed ? 1 : 0);
