// SPDX-License-Identifier: MIT
//
// Babylon.js with WebGPU or WebGL 2: pictures of each filter; receivers, visibilities and the map as floats for C++.
import * as BABYLON from '@babylonjs/core';
import * as glsl from '/package/umbrage.mjs';
import * as wgsl from '/package/wgsl.mjs';
import { install, set_light_size, uninstall } from '/package/npm/babylon.mjs';
import { depths_in_webgl, depths_in_webgpu } from '/engine_maps.mjs';
import { base64, height, map_size, width } from '/scene.mjs';
import { edge_height, half, light_at, rows_of, softened } from '/soft_edge.mjs';

const in_webgl = location.hash === '#webgl', { Vector3, MeshBuilder } = BABYLON;
const filters = name => ({ glsl: glsl[name], wgsl: wgsl[name] });
const soft = { arguments: { softness: [0.0625, 0.0625, 16, 256] } };

async function started(reversed = false) {
    const canvas = Object.assign(document.createElement('canvas'), { width, height });
    const engine = in_webgl ? new BABYLON.Engine(canvas, false, { preserveDrawingBuffer: true })
        : new BABYLON.WebGPUEngine(canvas, { antialias: false });
    if (!in_webgl) await engine.initAsync();
    engine.useReverseDepthBuffer = reversed;
    return engine;
}

/** Pillars, a ball and a fence on a floor under a light with a shadow generator. */
function make_scene(engine, { soft, cascades, spot, size = 96 } = {}) {
    const scene = new BABYLON.Scene(engine);
    scene.clearColor = new BABYLON.Color4(0.5, 0.6, 0.7, 1);
    scene.useRightHandedSystem = true;
    const camera = new BABYLON.FreeCamera('camera', new Vector3(5, 4.5, 7), scene);
    camera.setTarget(new Vector3(0, 0.6, 0));
    camera.fov = 0.7;
    camera.minZ = cascades ? 5 : 0.1;  // so that each cascade has receivers
    camera.maxZ = 60;
    new BABYLON.HemisphericLight('sky', new Vector3(0, 1, 0), scene).intensity = 0.5;
    const position = new Vector3(-4, 6, -2.5), direction = new Vector3(4, -6, 2.5);
    const light = spot ? new BABYLON.SpotLight('spot', position, direction, 1.2, 2, scene)
        : new BABYLON.DirectionalLight('sun', direction, scene);
    light.position = position;
    light.intensity = spot ? 200 : 0.8;
    light.autoUpdateExtends = false;
    Object.assign(light, { orthoLeft: -6, orthoRight: 6, orthoBottom: -6, orthoTop: 6, shadowMinZ: 1, shadowMaxZ: 16 });
    const generator = cascades ? new BABYLON.CascadedShadowGenerator(map_size, light, true)
        : new BABYLON.ShadowGenerator(map_size, light, true);
    generator.bias = 0.002;
    generator.normalBias = 0.01;
    if (cascades) Object.assign(generator, { numCascades: 3, lambda: 0, shadowMaxZ: 17, cascadeBlendPercentage: 0 });
    if (soft) {
        generator.useContactHardeningShadow = true;
        generator.contactHardeningLightSizeUVRatio = size / map_size;
    } else generator.usePercentageCloserFiltering = true;
    const add = (mesh, color, x, y, z) => {
        mesh.material = new BABYLON.PBRMaterial('paint', scene);
        Object.assign(mesh.material, { albedoColor: new BABYLON.Color3(...color), metallic: 0, roughness: 1 });
        mesh.position.set(x, y, z);
        mesh.receiveShadows = true;
        if (y > 0) generator.addShadowCaster(mesh);
    };
    add(MeshBuilder.CreateGround('floor', { width: 14, height: 14 }, scene), [0.85, 0.85, 0.85], 0, 0, 0);
    add(MeshBuilder.CreateBox('pillar', { width: 0.5, height: 3, depth: 0.5 }, scene), [0.8, 0.5, 0.4], -1.6, 1.5, -0.6);
    add(MeshBuilder.CreateSphere('ball', { diameter: 1.2 }, scene), [0.4, 0.6, 0.8], 1.2, 0.8, 1);
    for (let i = 0; i < 7; ++i)
        add(MeshBuilder.CreateBox('rail', { width: 0.06, height: 1.2, depth: 0.06 }, scene), [0.6, 0.6, 0.6],
            -2.5 + i * 0.35, 0.6, 2.2);
    return { engine, scene, camera, generator };
}

async function draw({ engine, scene }) {
    await scene.whenReadyAsync();
    for (let frame = 0; frame < 3; ++frame) {
        engine.beginFrame();
        scene.render();
        engine.endFrame();
    }
}

async function picture(made) {
    await draw(made);
    const canvas = Object.assign(document.createElement('canvas'), { width, height });
    canvas.getContext('2d').drawImage(made.engine.getRenderingCanvas(), 0, 0);
    return canvas.toDataURL();
}

/** A plugin of materials: their color is a value of the shader, such as the receiver as the addon's own function saw it. */
class Shown extends BABYLON.MaterialPluginBase {
    constructor(material, value) {
        super(material, 'Shown', 200, { [`SHOWN_${value.length}`]: true }, true, true);  // programs are kept by their defines
        this.value = value;
    }
    getClassName() { return 'Shown'; }
    isCompatible() { return true; }
    getCustomCode(stage) {
        return stage !== 'fragment' ? null : { CUSTOM_FRAGMENT_MAIN_END:
            `#ifdef SHADOWS\n${in_webgl ? 'gl_FragColor' : 'fragmentOutputs.color'} = ${this.value};\n#endif` };
    }
}

/** The value of each pixel, four floats. */
async function shown(made, value) {
    const { scene, camera } = made;
    for (const mesh of scene.meshes) new Shown(mesh.material, value);
    const target = new BABYLON.RenderTargetTexture('shown', { width, height }, scene,
        { generateMipMaps: false, type: BABYLON.Constants.TEXTURETYPE_FLOAT });
    Object.assign(target, { renderList: scene.meshes, activeCamera: camera, clearColor: new BABYLON.Color4(0, 0, 0, 0) });
    scene.customRenderTargets.push(target);
    await draw(made);
    return target.readPixels();
}

async function floats_of(made) {
    const { engine, generator } = made, receivers = await shown(made, 'umbrage_receiver'), map = generator.getShadowMap();
    const texture = generator.useContactHardeningShadow ? map.getInternalTexture() : map.depthStencilTexture;
    const { underlyingResource } = texture._hardwareTexture;
    return { receivers, depths: in_webgl ? depths_in_webgl(engine._gl, underlyingResource, map_size, generator.numCascades)
        : await depths_in_webgpu(engine._device, underlyingResource, map_size, generator.numCascades) };
}

/** The first number of a softness as the addon makes it of each cascade, in floats. */
function per_code({ generator }) {
    const [float, bits] = [new Float32Array(1), new Uint32Array(1)];
    return Array.from({ length: generator.numCascades ?? 1 }, (_, i) => {
        float[0] = generator.contactHardeningLightSizeUVRatio * map_size;
        if (generator.numCascades) {
            float[0] *= Math.fround(generator._lightSizeUVCorrection[2 * i]);
            float[0] *= Math.fround(generator._depthCorrection[i]);
        }
        bits.set(new Uint32Array(float.buffer));
        bits[0] &= 0xffff0000;
        return new Float32Array(bits.buffer)[0] / 256 * soft.arguments.softness[0];
    }).join();
}

/** A penumbra under a light with a size, whatever its planes and cascades. */
async function edge({ far, cascades }, size) {
    const engine = await started();
    install(engine, { ...filters('pcss16'), arguments: { softness: [0.0625, 0.0625, 16, 320] } });
    const scene = new BABYLON.Scene(engine), camera = new BABYLON.FreeCamera('camera', new Vector3(0, 1.5, 0), scene);
    scene.useRightHandedSystem = true;
    camera.rotation.set(Math.PI / 2, 0, 0);  // down
    const side = half * width / height;
    Object.assign(camera, { mode: BABYLON.Camera.ORTHOGRAPHIC_CAMERA, orthoLeft: -side, orthoRight: side, orthoBottom: -half, orthoTop: half,
        minZ: 0.1, maxZ: 3 });
    const light = new BABYLON.DirectionalLight('sun', new Vector3(...light_at).scale(-1), scene);
    light.position = new Vector3(...light_at);
    Object.assign(light, { autoUpdateExtends: false, orthoLeft: -5, orthoRight: 5, orthoBottom: -5, orthoTop: 5, shadowMinZ: 1, shadowMaxZ: far });
    const generator = new BABYLON[cascades ? 'CascadedShadowGenerator' : 'ShadowGenerator'](1024, light, true);
    Object.assign(generator, { useContactHardeningShadow: true, bias: 0.05 / far, ...(cascades && { numCascades: 2, shadowMaxZ: 3 }) });
    set_light_size(generator, size);
    const floor = MeshBuilder.CreateGround('floor', { width: 12, height: 12 }, scene);
    const sheet = MeshBuilder.CreateBox('sheet', { width: 12, height: 0.01, depth: 6 }, scene);
    sheet.position.set(0, edge_height + 0.005, -3);
    generator.addShadowCaster(sheet);
    floor.receiveShadows = true;
    for (const mesh of [floor, sheet]) mesh.material = new BABYLON.PBRMaterial('paint', scene);
    const values = await shown({ engine, scene, camera, generator }, 'umbrage_receiver');
    uninstall(engine);
    engine.dispose();
    return softened(rows_of(i => values[4 * i + 3]), size);
}

export const done = (async () => {
    const pictures = {}, floats = {}, said = {}, cascades = true, reversed = true;
    const stores = [BABYLON.ShaderStore.IncludesShadersStore, BABYLON.ShaderStore.IncludesShadersStoreWGSL];
    const texts = () => stores.map(store => store.shadowsFragmentFunctions + store.oitFragment).join('');
    const own_text = texts();
    for (const [name, filter, options, scene] of [
        ['own_pcf', null, {}, {}],
        ['hard', 'hard', {}, {}],
        ['castano_dyadic5', 'castano_dyadic5', {}, {}],
        ['disc16', 'disc16', { arguments: { radius: 3 } }, {}],
        ['own_pcss', null, {}, { soft: true }],
        ['pcss16', 'pcss16', soft, { soft: true }],
        ['own.cascades', null, {}, { cascades }],
        ['castano_dyadic5.cascades', 'castano_dyadic5', {}, { cascades }],
        ['own_pcss.cascades', null, {}, { soft: true, cascades }],
        ['pcss16.cascades', 'pcss16', soft, { soft: true, cascades }],
        ['own.spot', null, {}, { spot: true }],
        ['castano_dyadic5.spot', 'castano_dyadic5', {}, { spot: true }],
        ['pcss16.spot', 'pcss16', soft, { spot: true, soft: true }],
        ['own.reversed', null, {}, { reversed }],
        ['castano_dyadic5.reversed', 'castano_dyadic5', {}, { reversed }],
        ['pcss16.reversed', 'pcss16', soft, { soft: true, reversed }],
        ['castano_dyadic5.reversed_cascades', 'castano_dyadic5', {}, { cascades, reversed }],
        ['pcss16.reversed_cascades', 'pcss16', soft, { soft: true, cascades, reversed }],
        ['castano_dyadic5.reversed_spot', 'castano_dyadic5', {}, { spot: true, reversed }],
        ['pcss16.reversed_spot', 'pcss16', soft, { spot: true, soft: true, reversed }],
    ]) {
        const engine = await started(scene.reversed);
        if (filter) install(engine, { ...filters(filter), ...options });
        pictures[name] = await picture(make_scene(engine, scene));
        if (filter) {
            const made = make_scene(engine, scene), { receivers, depths } = await floats_of(made);
            floats[`${name}.receivers`] = base64(receivers);
            floats[`${name}.map`] = base64(depths);
            if (scene.cascades) {
                const layers = await shown(make_scene(engine, scene), in_webgl ? 'vec4(index1)' : 'vec4f(f32(index1))');
                floats[`${name}.layers`] = base64(layers.filter((_, i) => i % 4 === 0));
            }
            if (scene.soft) said[`${name}.per_code`] = per_code(made);
            else said[`${name}.compare`] = scene.reversed ? 'greater' : 'less';  // as Babylon.js sets its samplers
            uninstall(engine);
        }
        engine.dispose();
    }
    const engine = await started(), made = make_scene(engine), { scene } = made;
    const own = await picture(made);
    install(engine, { ...filters('hard'), scene });  // at run time
    said.later = await picture(made) === pictures.hard;
    install(engine, { ...filters('hard'), probe: true, scene });
    pictures.probe = await picture(made);
    uninstall(engine, { scene });
    said.off = await picture(made) === own;
    said.restored = texts() === own_text;
    const soft_edges = {};
    for (const [name, options] of Object.entries({ 'far 20': { far: 20 }, 'far 200': { far: 200 }, cascades: { far: 20, cascades } }))
        soft_edges[name] = await edge(options, 0.05);
    said.soft = JSON.stringify(soft_edges);
    said.soft_wrong = Object.values(soft_edges).every(({ good }) => good) ? 'none' : said.soft;
    return { pictures, floats, said };
})();
