// SPDX-License-Identifier: MIT
//
// fit_bias of Babylon.js and PlayCanvas without a browser: its formulas at every angle between a surface and the light, the
// box that it gives to Babylon.js' lights, and bad input, which is refused by a name.
//     node bias_test.mjs PACKAGE FOLDER NODE_MODULES
import { cpSync, existsSync, mkdirSync, rmSync, symlinkSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const [umbrage, folder, node_modules] = process.argv.slice(2).map(path => resolve(path));
for (const needed of ['@babylonjs/core', 'playcanvas'])
    if (!existsSync(join(node_modules, needed))) {
        console.log(`SKIPPED: no ${needed} in ${node_modules}`);
        process.exit(77);
    }
const modules = join(folder, 'node_modules');
rmSync(folder, { recursive: true, force: true });
mkdirSync(modules, { recursive: true });
cpSync(umbrage, join(modules, 'umbrage'), { recursive: true });
for (const host of ['@babylonjs', 'playcanvas']) symlinkSync(join(node_modules, host), join(modules, host));
const load = path => import(pathToFileURL(join(modules, path)).href);

let failed = 0;
const check = (what, good) => {
    if (!good) ++failed;
    console.log(`${good ? 'ok' : 'FAILED'}: ${what}`);
};
const refusal = call => { try { call(); return 'accepted'; } catch (error) { return error.message; } };
const refuses = (call, text) => check(`refused: ${text}`, refusal(call) === text || console.log(`    said: ${refusal(call)}`));

const { bias_of_casters, bias_of_distances } = await load('umbrage/npm/bias.mjs');
const angles = Array.from({ length: 900 }, (_, i) => i * Math.PI / 1800);

for (const radius of [0.71, 1.4, 4.2, 9]) {  // in texels: casters move by n sin t along the normal, and by b along the light
    const { depth, detachment, clear_angle } = bias_of_casters(radius, 1, 0);
    const planes = angles.every(t => radius * Math.tan(t) + depth > radius * Math.tan(t)), clear = radius * Math.tan(clear_angle) <= depth * (1 + 1e-12);
    const moved = Math.max(...angles.map(t => Math.hypot(radius * Math.sin(t) ** 2, radius * Math.sin(t) * Math.cos(t) + depth)));
    check(`casters, radius ${radius}: bias ${depth.toFixed(3)}, they move by ${moved.toFixed(3)} of ${detachment.toFixed(3)} texels`,
        planes && clear && moved <= detachment * (1 + 1e-12) && moved > 0.9999 * detachment && detachment <= radius + 2);
}
for (const [radius, most] of [[0.004, 1], [0.02, 1], [0.02, 0.05], [0.1, 0.2]]) {  // receivers move by n (1 - cos t) and by b
    const distance = 7, { factor, depth, detachment } = bias_of_distances(radius, distance, most);
    const spare = angles.map(t => factor * (1 - Math.cos(t)) + depth / distance * Math.cos(t) - radius * Math.sin(t));
    check(`distances, radius ${radius}: factor ${factor.toFixed(4)}, bias ${depth.toFixed(4)}`, Math.min(...spare) > -1e-9
        && Math.min(...spare) < 1e-4 && depth <= most && detachment >= radius * distance * (1 - 1e-12));
}

{  // Babylon.js: the box holds all that is drawn, and says what is wrong
    const [{ NullEngine }, { Scene }, { Vector3 }, { FreeCamera }, { DirectionalLight }, { SpotLight }, { HemisphericLight }, { ShadowGenerator },
        { CascadedShadowGenerator }, { CreateBox }, { TransformNode }] = await Promise.all(['Engines/nullEngine', 'scene', 'Maths/math.vector', 'Cameras/freeCamera',
        'Lights/directionalLight', 'Lights/spotLight', 'Lights/hemisphericLight', 'Lights/Shadows/shadowGenerator',
        'Lights/Shadows/cascadedShadowGenerator', 'Meshes/Builders/boxBuilder', 'Meshes/transformNode'].map(name => load(`@babylonjs/core/${name}.js`)));
    await load('@babylonjs/core/Lights/Shadows/shadowGeneratorSceneComponent.js');
    const { fit_bias } = await load('umbrage/npm/babylon.mjs'), engine = new NullEngine(), where = 'umbrage/babylon: fit_bias';
    engine._features.supportShadowSamplers = engine._features.supportCSM = true;  // as engines have it
    engine.createDepthStencilTexture = () => null;  // which this engine has not
    let seed = 5;
    const random = () => (seed = (seed * 1103515245 + 12345) % 2147483648) / 2147483648, anywhere = () => 40 * random() - 20;
    const tried = { directional: [0, 0], spot: [0, 0] };
    for (let k = 0; k < 60; ++k) {
        const scene = new Scene(engine), kind = k % 2 ? 'spot' : 'directional', high = new Vector3(anywhere(), 30, anywhere());
        scene.useRightHandedSystem = k % 3 === 0;
        new FreeCamera('', new Vector3(0, 5, -20), scene);
        const down = new Vector3(anywhere(), 0, anywhere()).subtract(high);
        const light = kind === 'spot' ? new SpotLight('', high, down, 0.3 + random(), 1, scene) : new DirectionalLight('', down, scene);
        const cart = k % 5 === 0 ? new TransformNode('', scene) : undefined;
        cart?.position.set(anywhere(), 0, anywhere());
        cart?.rotation.set(0.3 * random(), random(), 0);
        light.parent = cart ?? null;
        light.position = high;
        const generator = new ShadowGenerator(512, light), meshes = [0, 1, 2, 3].map(i => CreateBox(`${i}`, { size: 1 + 5 * random() }, scene));
        generator.usePercentageCloserFiltering = true;
        for (const mesh of meshes) {
            mesh.position.set(anywhere(), 3 * random(), anywhere());
            mesh.rotation.set(random(), random(), random());
            mesh.receiveShadows = true;
            generator.addShadowCaster(mesh);
        }
        fit_bias(generator, { steady: k % 4 > 1 });
        const matrix = generator.getTransformMatrix();
        for (const mesh of meshes)
            for (const corner of mesh.getBoundingInfo().boundingBox.vectorsWorld) {
                const ray = corner.subtract(light.getAbsolutePosition()), along = light.getShadowDirection();
                const angle = Math.acos(Vector3.Dot(ray, along) / (ray.length() * along.length()));
                if (kind === 'spot' && angle > light.angle / 2) continue;
                const { x, y, z } = Vector3.TransformCoordinates(corner, matrix);
                ++tried[kind][0], tried[kind][1] += Math.max(Math.abs(x), Math.abs(y), Math.abs(z)) > 1;
            }
        scene.dispose();
    }
    for (const [kind, [all, outside]] of Object.entries(tried))
        check(`babylon, ${kind}: ${outside} of ${all} corners outside the map`, outside === 0 && all > 100);

    const scene = new Scene(engine), sun = new DirectionalLight('', new Vector3(0, -1, 0.2), scene), generator = new ShadowGenerator(64, sun);
    new FreeCamera('', new Vector3(0, 5, -20), scene);
    refuses(() => fit_bias(sun), `${where}: generator must be a shadow generator of a DirectionalLight, SpotLight or PointLight; got DirectionalLight`);
    refuses(() => fit_bias({ getLight: () => new HemisphericLight('', Vector3.Up(), scene) }),
        `${where}: generator must be a shadow generator of a DirectionalLight, SpotLight or PointLight; got HemisphericLight`);
    refuses(() => fit_bias(generator, { receiver: [] }), `${where}: options must have no properties but receivers, steady; got receiver`);
    refuses(() => fit_bias(generator, { receivers: scene }), `${where}: receivers must be an array of meshes of Babylon.js; got Scene`);
    refuses(() => fit_bias(generator), `${where}: receivers must have a visible mesh; without them, one with receiveShadows; got none`);
    const floor = CreateBox('', { size: 4 }, scene), cascades = new CascadedShadowGenerator(64, sun), few = new ShadowGenerator(8, sun);
    refuses(() => fit_bias(cascades, { receivers: [floor] }),
        `${where}: generator must have drawn its cascades: call fit_bias after the first scene.render(); got none`);
    few.usePercentageCloserFiltering = true;
    refuses(() => fit_bias(few, { receivers: [floor] }), `${where}: the map must have more texels for a filter that reaches 4.2; got 8`);
    generator.useExponentialShadowMap = true;
    Object.assign(generator, { bias: 0.5, normalBias: 0.25 });
    const { bias_is_set, bias, normal_bias, detachment } = fit_bias(generator, { receivers: [floor] });
    check('babylon: exponential maps keep their biases', !bias_is_set && bias === 0.5 && normal_bias === 0.25 && detachment === undefined
        && generator.bias === 0.5 && generator.normalBias === 0.25 && sun.autoUpdateExtends === false);
}

{  // PlayCanvas
    const pc = await load('playcanvas/build/playcanvas/src/index.js'), { fit_bias } = await load('umbrage/npm/playcanvas_fit.mjs');
    const where = 'umbrage/playcanvas: fit_bias', root = new pc.Entity(), entity = new pc.Entity();
    const box = { aabb: new pc.BoundingBox(pc.Vec3.ZERO, new pc.Vec3(10, 2, 10)) }, drawn = { enabled: true, entity: { enabled: true }, meshInstances: [box] };
    const scene = { clusteredLightingEnabled: false }, app = { root, scene, graphicsDevice: {} };
    const light_of = (type, more) => ({ type, entity, system: { app }, shadowType: pc.SHADOW_PCF5_32F, shadowResolution: 1024, range: 30, outerConeAngle: 40,
        numCascades: 1, cascadeDistribution: 0.5, shadowDistance: 40, normalOffsetBias: 0, shadowBias: 0.05, ...more });
    const camera = { nearClip: 0.1, farClip: 1000, fov: 45, aspectRatioMode: pc.ASPECT_MANUAL, aspectRatio: 1.5, projection: pc.PROJECTION_PERSPECTIVE,
        calculateAspectRatio: () => 1.5 };
    entity.setPosition(0, 12, 0);
    refuses(() => fit_bias({ type: 'area' }), `${where}: light must be the light component of an entity in an app; got area`);
    refuses(() => fit_bias(light_of('directional')), `${where}: camera must be given for a directional light; got undefined`);
    refuses(() => fit_bias(light_of('directional'), { camera: 3 }), `${where}: camera must be the camera component of an entity; got 3`);
    refuses(() => fit_bias(light_of('spot'), { receivers: [3] }), `${where}: receivers must be an entity of PlayCanvas, or an array of them; got [3]`);
    refuses(() => fit_bias(light_of('spot')), `${where}: receivers must have an enabled render component; got none`);
    root.findComponents = () => [drawn];
    refuses(() => fit_bias(light_of('spot', { shadowResolution: 8 })),
        `${where}: the light's map must be larger for a filter that reaches 4.2 texels; got 8`);
    const wide = light_of('directional', { shadowDistance: 900 }), far = fit_bias(wide, { camera });
    check(`playcanvas: beyond 1 it says by how much, ${far.lacks.toFixed(2)}`, wide.normalOffsetBias === 1 && far.lacks > 1
        && Math.abs(far.lacks + 1 - far.detachment) < 0.01);
    const soft = light_of('spot', { shadowType: pc.SHADOW_VSM_16F }), kept = fit_bias(soft);
    check('playcanvas: variance maps keep their biases', !kept.bias_is_set && kept.detachment === undefined && soft.shadowBias === 0.05);
    const split = fit_bias(light_of('directional', { numCascades: 3 }), { camera });
    check(`playcanvas: ${split.cascades.length} cascades`, split.cascades.length === 3 && split.lacks === 0
        && split.cascades.every(({ texels_per_unit }, i) => i === 0 || texels_per_unit < split.cascades[i - 1].texels_per_unit));
    for (const type of ['omni', 'point']) {
        const lamp = light_of(type), { detachment, texels_per_unit } = fit_bias(lamp);
        check(`playcanvas: ${type}, ${lamp.normalOffsetBias.toFixed(4)} and ${lamp.shadowBias.toFixed(3)}`, lamp.shadowBias < 1
            && detachment * texels_per_unit < 3.5);
    }

    // Clusters have an atlas, of which a light has a tile: four texels on each side are free, or three around each face of a cube.
    const { texels_per_unit } = fit_bias(light_of('spot'));
    Object.assign(scene, { clusteredLightingEnabled: true, lighting: { shadowType: pc.SHADOW_PCF5_32F, shadowAtlasResolution: 4 * 1032 } });
    const tile = { atlasViewportAllocated: true, atlasViewport: new pc.Vec4(0, 0, 0.25, 0.25) };
    const clustered = fit_bias(light_of('spot', { light: tile, shadowResolution: 16 }));
    check(`playcanvas: a tile of 1032 texels is a map of 1024: ${clustered.texels_per_unit}`, clustered.texels_per_unit === texels_per_unit);
    scene.lighting.shadowAtlasResolution = 4 * 3 * 1030;
    const cube = fit_bias(light_of('omni', { light: tile }));
    check(`playcanvas: faces of clusters filter like maps, reach ${cube.reach}`, Math.abs(cube.reach - 3 * Math.SQRT2) < 1e-9 && cube.lacks === 0);
    refuses(() => fit_bias(light_of('spot', { light: { atlasViewportAllocated: false } })),
        `${where}: light must have a tile of the shadow atlas: enable castShadows and draw a frame before; got none`);
}
process.exitCode = failed ? 1 : 0;
