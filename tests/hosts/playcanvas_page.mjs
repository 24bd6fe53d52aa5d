// SPDX-License-Identifier: MIT
//
// PlayCanvas with WebGPU or WebGL 2: pictures of each filter; receivers, visibilities and the map as floats for C++.
import * as pc from 'playcanvas';
import * as glsl from '/package/umbrage.mjs';
import * as wgsl from '/package/wgsl.mjs';
import { install, set_light_size, uninstall } from '/package/npm/playcanvas.mjs';
import { depths_in_webgl, depths_in_webgpu } from '/engine_maps.mjs';
import { base64, height, map_size, width } from '/scene.mjs';
import { edge_height, half, light_at, rows_of, softened } from '/soft_edge.mjs';

const in_webgl = location.hash === '#webgl';
const filters = name => ({ glsl: glsl[name], wgsl: wgsl[name] });
const soft = { arguments: { softness: [0.0625, 0.0625, 16, 256] } };
const spot = { light: 'spot', range: 20, outerConeAngle: 35, innerConeAngle: 30, shadowBias: 0.05, intensity: 30 };
const point = { light: 'omni', range: 20, type: pc.SHADOW_PCF3_32F, intensity: 30 };

async function started() {
    const canvas = Object.assign(document.createElement('canvas'), { width, height });
    document.body.append(canvas);
    const device = await pc.createGraphicsDevice(canvas, { antialias: false, preserveDrawingBuffer: true,
        deviceTypes: [in_webgl ? pc.DEVICETYPE_WEBGL2 : pc.DEVICETYPE_WEBGPU] });
    if (device.isWebGPU === in_webgl) throw new Error(`the device is ${device.deviceType}`);
    const options = new pc.AppOptions();
    options.graphicsDevice = device;
    options.componentSystems = [pc.RenderComponentSystem, pc.CameraComponentSystem, pc.LightComponentSystem];
    const app = new pc.AppBase(canvas);
    app.init(options);
    app.autoRender = false;
    app.start();
    return app;
}

/** Pillars, a ball and a fence on a floor under a light. Programs are kept by their defines: name tells those of scenes apart. */
function make_scene(app, name, { type = pc.SHADOW_PCF5_32F, light: kind = 'directional', clustered = false, ...further } = {}) {
    // WebGPU has clusters always. Their shadows are two calls more of a filter in each shader: off where none are drawn
    app.scene.clusteredLightingEnabled = clustered;
    Object.assign(app.scene.lighting, { shadowsEnabled: clustered, shadowAtlasResolution: map_size });
    if (clustered) app.scene.lighting.shadowType = type;
    app.scene.ambientLight = new pc.Color(0.35, 0.35, 0.35);
    const add = (type, color, position, scale) => {
        const entity = new pc.Entity(), material = new pc.StandardMaterial();
        material.diffuse = new pc.Color(...color);
        material.setDefine(`SCENE_${name.toUpperCase().replaceAll('.', '_')}`, true);
        material.update();
        entity.addComponent('render', { type, material, castShadows: type !== 'plane' });
        entity.setPosition(...position);
        entity.setLocalScale(...scale);
        app.root.addChild(entity);
    };
    add('plane', [0.85, 0.85, 0.85], [0, 0, 0], [14, 1, 14]);
    add('box', [0.8, 0.5, 0.4], [-1.6, 1.5, -0.6], [0.5, 3, 0.5]);
    add('sphere', [0.4, 0.6, 0.8], [1.2, 0.8, 1], [1.2, 1.2, 1.2]);
    for (let i = 0; i < 7; ++i) add('box', [0.6, 0.6, 0.6], [-2.5 + i * 0.35, 0.6, 2.2], [0.06, 1.2, 0.06]);
    const camera = new pc.Entity(), light = new pc.Entity();
    camera.addComponent('camera', { clearColor: new pc.Color(0.5, 0.6, 0.7), fov: 40,
        nearClip: further.numCascades ? 5 : 0.1, farClip: 60 });
    camera.setPosition(5, 4.5, 7);
    camera.lookAt(0, 0.6, 0);
    app.root.addChild(camera);
    light.addComponent('light', { type: kind, castShadows: true, shadowResolution: map_size, shadowDistance: 25, shadowType: type,
        shadowBias: 0.2, normalOffsetBias: 0.05, intensity: 1.3, ...further });
    if (kind === 'directional') light.setEulerAngles(40, 60, 0);
    else {
        light.setPosition(-4, 6, -2.5);
        light.lookAt(0, 0, 0);
        light.rotateLocal(90, 0, 0);
    }
    app.root.addChild(light);
    return { app, camera, light };
}

/** Draws frames, and no others. */
async function frames(app, count) {
    for (let frame = 0; frame < count; ++frame) {
        app.renderNextFrame = true;
        await new Promise(done => { app.once('postrender', done); });
    }
}

async function picture({ app }) {
    await frames(app, 2);
    const canvas = Object.assign(document.createElement('canvas'), { width, height });
    canvas.getContext('2d').drawImage(app.graphicsDevice.canvas, 0, 0);
    return canvas.toDataURL();
}

/** Receivers as the addon's own function saw them, as the color of each pixel. */
async function floats_of({ app, camera, light }) {
    const device = app.graphicsDevice;
    for (const { material } of app.root.findComponents('render')) {
        material.shaderChunks.glsl.set('outputPS', '#ifdef UMBRAGE_PLAYCANVAS\ngl_FragColor = umbrage_receiver;\n#endif\n');
        material.shaderChunks.wgsl.set('outputPS', '#ifdef UMBRAGE_PLAYCANVAS\noutput.color = umbrage_receiver;\n#endif\n');
        material.update();
    }
    const texture = new pc.Texture(device, { width, height, format: pc.PIXELFORMAT_RGBA32F, mipmaps: false });
    camera.camera.renderTarget = new pc.RenderTarget({ colorBuffer: texture, depth: true });
    camera.camera.clearColor = new pc.Color(0, 0, 0, 0);
    await frames(app, 2);
    const receivers = await texture.read(0, 0, width, height, { renderTarget: camera.camera.renderTarget, immediate: true });
    const directional = light.light.type === 'directional';
    const shadowBuffer = app.scene.clusteredLightingEnabled && !directional ? app.renderer.lightTextureAtlas.shadowAtlas.texture
        : light.light.light.getRenderData(directional ? camera.camera.camera : null, 0).shadowBuffer;
    return { receivers, depths: in_webgl ? depths_in_webgl(device.gl, shadowBuffer.impl._glTexture, map_size)
        : await depths_in_webgpu(device.wgpu, shadowBuffer.impl.gpuTexture, map_size) };
}

/** The first number of a softness as the addon makes it of each cascade, in floats. */
function per_code({ light }) {
    const { numCascades, penumbraSize, _shadowCascadeParams } = light.light.light;
    return Array.from({ length: numCascades }, (_, i) => {
        const [half_width, far, near] = _shadowCascadeParams.slice(4 * i), float = new Float32Array(1);
        float[0] = penumbraSize * (far - near) / (2 * half_width) * map_size / 256;
        new Uint32Array(float.buffer)[0] &= 0xffff0000;
        return float[0] * soft.arguments.softness[0];
    }).join();
}

/** The cascade of each receiver: each has a quarter of the map. */
const cascades_of = receivers => Float32Array.from({ length: width * height }, (_, i) =>
    2 * (receivers[4 * i] >= map_size / 2) + (receivers[4 * i + 1] >= map_size / 2));

const pcss = { type: pc.SHADOW_PCSS_32F }, clustered = true;
const cascades = { numCascades: 4, cascadeDistribution: 0, shadowDistance: 17 };

/** Scenes by name: filter, its further options, light. A scene with PlayCanvas' own shadows has no filter. */
const scenes = {
    own_pcf: [null, {}, {}],
    hard: ['hard', {}, {}],
    castano_dyadic5: ['castano_dyadic5', {}, {}],
    disc16: ['disc16', { arguments: { radius: 3 } }, { type: pc.SHADOW_PCF3_32F }],
    own_pcss: [null, {}, pcss],
    pcss16: ['pcss16', soft, pcss],
    'own.cascades': [null, {}, cascades],
    'castano_dyadic5.cascades': ['castano_dyadic5', {}, cascades],
    'own_pcss.cascades': [null, {}, { ...cascades, ...pcss }],
    'pcss16.cascades': ['pcss16', soft, { ...cascades, ...pcss }],
    'disc16.clustered': ['disc16', { arguments: { radius: 3 } }, { ...spot, clustered }],
    'disc16.clustered_point': ['disc16', { arguments: { radius: 3 } }, { ...point, clustered }],
    probe: ['hard', { probe: true }, {}],
    ...(in_webgl && {  // without clusters, and more texels of them than SwiftShader's compiler of Vulkan takes in a minute
        'own.clustered': [null, {}, { ...spot, clustered }],
        'castano_dyadic5.clustered': ['castano_dyadic5', {}, { ...spot, clustered }],
        'own.clustered_point': [null, {}, { ...point, clustered }],
        'castano_dyadic5.clustered_point': ['castano_dyadic5', {}, { ...point, clustered }],
        'own.spot': [null, {}, spot],
        'castano_dyadic5.spot': ['castano_dyadic5', {}, spot],
        'own.point': [null, {}, point],
        'hard.own.point': ['hard', { lights: [] }, point],
        'own_pcss.spot': [null, {}, { ...spot, ...pcss }],
        'pcss16.own_pcss.spot': ['pcss16', { lights: [] }, { ...spot, ...pcss }],
        'own_pcss.point': [null, {}, { ...point, ...pcss }],
        'pcss16.own_pcss.point': ['pcss16', { lights: [] }, { ...point, ...pcss }],
    }),
};

/** A penumbra under a light with a size. */
async function edge(shadowDistance, size) {
    const app = await started(), device = app.graphicsDevice, [camera, light] = [new pc.Entity(), new pc.Entity()];
    app.scene.clusteredLightingEnabled = false;
    install(device, { ...filters('pcss16'), arguments: { softness: [0.0625, 0.0625, 16, 320] } });
    for (const [type, position, scale] of [['plane', [0, 0, 0], [12, 1, 12]], ['box', [0, edge_height + 0.005, -3], [12, 0.01, 6]]]) {
        const entity = new pc.Entity(), material = new pc.StandardMaterial();
        // a floor casts too: PlayCanvas ends its map at the lowest caster, and clamps receivers to it
        entity.addComponent('render', { type, material, receiveShadows: type === 'plane' });
        entity.setPosition(...position);
        entity.setLocalScale(...scale);
        app.root.addChild(entity);
    }
    camera.addComponent('camera', { projection: pc.PROJECTION_ORTHOGRAPHIC, orthoHeight: half, nearClip: 0.1, farClip: 3 });
    camera.setPosition(0, 1.5, 0);
    camera.setEulerAngles(-90, 0, 0);
    light.addComponent('light', { type: 'directional', castShadows: true, shadowResolution: map_size, shadowDistance,
        shadowType: pc.SHADOW_PCSS_32F, shadowBias: 0.2, normalOffsetBias: 0.05 });
    light.setPosition(...light_at);
    light.lookAt(0, 0, 0);
    light.rotateLocal(90, 0, 0);
    set_light_size(light.light, size);
    for (const entity of [camera, light]) app.root.addChild(entity);
    const { receivers } = await floats_of({ app, camera, light });
    uninstall(device);
    app.destroy();
    return softened(rows_of(i => receivers[4 * i + 3]), size);
}

const refusal = call => { try { call(); return 'accepted'; } catch (error) { return error.message; } };

export const done = (async () => {
    const pictures = {}, floats = {}, said = { restored: true };
    let app;
    for (const [name, [filter, options, scene]] of Object.entries(scenes)) {
        if (in_webgl) app?.destroy();  // its state was changed; several devices of WebGPU stop a page
        if (in_webgl || !app) app = await started();
        const device = app.graphicsDevice;
        const language = in_webgl ? pc.SHADERLANGUAGE_GLSL : pc.SHADERLANGUAGE_WGSL;
        const chunks = pc.ShaderChunks.get(device, language), own = new Map(chunks), made = make_scene(app, name, scene);
        const [, kept] = name.match(/^[^.]+[.](own.*)/) ?? [];  // the light keeps PlayCanvas' own filter
        if (kept) said[`${name}.refused`] = refusal(() => install(device, { ...filters(filter), ...options, lights: undefined }));
        if (filter) install(device, { ...filters(filter), ...options });
        pictures[name] = await picture(made);
        if (kept) said[`${name}.kept`] = pictures[name] === pictures[kept];
        else if (filter && name !== 'probe') {
            const { receivers, depths } = await floats_of(made);
            floats[`${name}.receivers`] = base64(receivers);
            floats[`${name}.map`] = base64(depths);
            if (scene.numCascades) floats[`${name}.layers`] = base64(cascades_of(receivers));
            if (scene.type === pc.SHADOW_PCSS_32F) said[`${name}.per_code`] = per_code(made);
            else said[`${name}.compare`] = 'less';  // as PlayCanvas sets its samplers
        }
        uninstall(device);
        said.restored &&= [...chunks].every(([key, text]) => own.get(key) === text);
        for (const entity of [...app.root.children]) entity.destroy();
    }
    if (in_webgl) {  // a second device of WebGPU stops a page
        app.destroy();
        const soft_edges = { wide: await edge(10, 0.05), narrow: await edge(60, 0.03) };
        said.soft = JSON.stringify(soft_edges);
        said.soft_wrong = Object.values(soft_edges).every(({ good }) => good) ? 'none' : said.soft;
    }
    return { pictures, floats, said };
})();
