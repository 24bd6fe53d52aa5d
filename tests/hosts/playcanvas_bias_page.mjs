// SPDX-License-Identifier: MIT
//
// PlayCanvas with WebGL 2 or WebGPU, which always has clusters: fit_bias on each kind of light, with PlayCanvas' own filters and with ours.
import * as pc from 'playcanvas';
import * as glsl from '/package/umbrage.mjs';
import * as wgsl from '/package/wgsl.mjs';
import { fit_bias, install, uninstall } from '/package/npm/playcanvas.mjs';
import { try_all } from '/bias_page.mjs';
import { camera as view, cone, height, lights, map_size, mesh_of, objects, width } from '/bias_scene.mjs';

const in_webgpu = location.hash === '';

async function started(clustered) {
    const canvas = Object.assign(document.createElement('canvas'), { width, height });
    const device = await pc.createGraphicsDevice(canvas, { antialias: false, deviceTypes: [in_webgpu ? pc.DEVICETYPE_WEBGPU : pc.DEVICETYPE_WEBGL2] });
    const options = new pc.AppOptions();
    options.graphicsDevice = device;
    options.componentSystems = [pc.RenderComponentSystem, pc.CameraComponentSystem, pc.LightComponentSystem];
    const app = new pc.AppBase(canvas);
    app.init(options);
    app.autoRender = false;
    app.start();
    app.scene.clusteredLightingEnabled = clustered;
    app.scene.lighting.shadowsEnabled = clustered;
    app.scene.ambientLight = pc.Color.BLACK;
    return app;
}

/** WebGL's pictures begin with their lowest row. */
const row_from_above = y => (in_webgpu ? y : height - 1 - y);

function next_frame(app) {
    app.renderNextFrame = true;
    return new Promise(done => { app.once('postrender', done); });
}

const names = { directional: 'directional', spot: 'spot', point: 'omni' };

async function begin(kind, setting, { filter, given, type = pc.SHADOW_PCF5_32F, cascades = false, clustered = false }) {
    const app = await started(clustered), device = app.graphicsDevice, entities = [new pc.Entity(), new pc.Entity()], [camera, light] = entities;
    const material = new pc.StandardMaterial();
    Object.assign(material, { diffuse: pc.Color.WHITE, specular: pc.Color.BLACK, useFog: false });
    material.update();
    for (const [name, triangles] of Object.entries(objects)) {
        const { positions, normals, indices } = mesh_of(triangles), entity = new pc.Entity(name), geometry = new pc.Geometry();
        Object.assign(geometry, { positions, normals, indices });
        entity.addComponent('render', { meshInstances: [new pc.MeshInstance(pc.Mesh.fromGeometry(device, geometry), material)] });
        app.root.addChild(entity);
    }
    const texture = new pc.Texture(device, { width, height, format: pc.PIXELFORMAT_RGBA32F, mipmaps: false });
    const renderTarget = new pc.RenderTarget({ colorBuffer: texture, depth: true });
    camera.addComponent('camera', { fov: view.fov, nearClip: view.z_near, farClip: view.z_far, clearColor: new pc.Color(0, 0, 0, 0), renderTarget,
        gammaCorrection: pc.GAMMA_NONE, toneMapping: pc.TONEMAP_NONE });
    const size = map_size * (cascades ? 2 : 1);
    light.addComponent('light', { type: names[kind], castShadows: true, shadowResolution: size, shadowType: type, shadowDistance: 40, range: 40,
        innerConeAngle: cone * 180 / Math.PI - 1, outerConeAngle: cone * 180 / Math.PI, falloffMode: pc.LIGHTFALLOFF_LINEAR, intensity: 1,
        ...(cascades && { numCascades: 3, cascadeDistribution: 0.5 }) });
    for (const entity of entities) app.root.addChild(entity);
    camera.setPosition(...view.at);
    camera.lookAt(...view.to);
    light.setPosition(...lights[kind]);
    light.lookAt(0, 0, 0);
    light.rotateLocal(90, 0, 0);
    if (filter) install(device, { glsl: glsl[filter], wgsl: wgsl[filter], ...given });
    const shadows = light.light;
    // one light has the whole atlas, and the map the same texels as without clusters
    Object.assign(app.scene.lighting, { shadowType: type, shadowAtlasResolution: kind === 'point' ? 3 * (map_size + 6) : map_size + 8 });
    if (clustered) await next_frame(app);
    return {
        set() {
            if (setting === 'fit') return fit_bias(shadows, kind === 'directional' ? { camera: camera.camera } : {});
            if (setting === 'copied') Object.assign(shadows, { shadowBias: 0.2, normalOffsetBias: 0.05 });
        },
        async radiance(lit) {
            shadows.shadowIntensity = lit ? 0 : 1;
            for (let frame = 0; frame < 2; ++frame) await next_frame(app);
            const pixels = await texture.read(0, 0, width, height, { renderTarget, immediate: true });
            return Float32Array.from({ length: width * height },
                (_, i) => pixels[4 * (row_from_above(Math.floor(i / width)) * width + i % width)]);
        },
        texels() {
            const { numCascades, _shadowCascadeDistances: splits } = shadows.light, maps = kind === 'directional' ? numCascades : 0;
            const of = i => 2 * shadows.light.getRenderData(camera.camera.camera, i).shadowCamera.orthoHeight / map_size;
            return { texels: Array.from({ length: maps }, (_, i) => of(i)), splits: cascades ? [...splits].slice(0, numCascades) : [],
                tangent: kind === 'spot' ? Math.tan(cone) : 1 };
        },
        shift: () => (kind === 'point' ? 0 : shadows.normalOffsetBias),
        end() {
            if (filter) uninstall(device);
            app.destroy();
        },
    };
}

const settings = ['fit', 'default', 'copied'], cases = {};
for (const light of ['directional', 'spot', 'point']) for (const setting of settings) cases[`${light}.${setting}`] = { light, setting };
for (const setting of settings) cases[`cascades.${setting}`] = { light: 'directional', setting, cascades: true };
for (const light of ['spot', 'point'])
    for (const [end, setting] of [['', 'fit'], ['_default', 'default'], ['_copied', 'copied']])
        cases[`${light}.clustered${end}`] = { light, setting, clustered: true };
Object.assign(cases, {
    'directional.pcf1': { light: 'directional', type: pc.SHADOW_PCF1_32F },
    'directional.pcf3': { light: 'directional', type: pc.SHADOW_PCF3_32F },
    'directional.coarse': { light: 'directional', type: pc.SHADOW_PCF5_16F },
    'directional.hard': { light: 'directional', filter: 'hard' },
    'directional.disc': { light: 'directional', filter: 'disc16', given: { arguments: { radius: 4 } } },
    'directional.pcss': { light: 'directional', filter: 'pcss16', type: pc.SHADOW_PCSS_32F },
    'spot.castano': { light: 'spot', filter: 'castano_dyadic5' },
    'spot.pcf3': { light: 'spot', type: pc.SHADOW_PCF3_32F },
    'point.pcf1': { light: 'point', type: pc.SHADOW_PCF1_32F },
    'spot.clustered_pcf3': { light: 'spot', type: pc.SHADOW_PCF3_32F, clustered: true },
    'point.clustered_pcf1': { light: 'point', type: pc.SHADOW_PCF1_32F, clustered: true },
    'cascades.castano': { light: 'directional', filter: 'castano_dyadic5', cascades: true },
});

const of_webgpu = /^(directional|cascades)[.](fit|default|copied)$|[.]clustered(_default|_copied|)$/;
const chosen = name => ({ '': of_webgpu, '#few': /[.](fit|hard)$/ }[location.hash] ?? /./).test(name);
export const done = try_all(begin, Object.fromEntries(Object.entries(cases).filter(([name]) => chosen(name))));
