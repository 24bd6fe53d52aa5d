// SPDX-License-Identifier: MIT
//
// Babylon.js with WebGL 2 or WebGPU: fit_bias on each kind of light, with Babylon.js' own filters and with ours.
import { FreeCamera } from '@babylonjs/core/Cameras/freeCamera.js';
import { Constants } from '@babylonjs/core/Engines/constants.js';
import { Engine } from '@babylonjs/core/Engines/engine.js';
import { WebGPUEngine } from '@babylonjs/core/Engines/webgpuEngine.js';
import '@babylonjs/core/Engines/WebGPU/Extensions/index.js';
import { DirectionalLight } from '@babylonjs/core/Lights/directionalLight.js';
import { PointLight } from '@babylonjs/core/Lights/pointLight.js';
import { CascadedShadowGenerator } from '@babylonjs/core/Lights/Shadows/cascadedShadowGenerator.js';
import { ShadowGenerator } from '@babylonjs/core/Lights/Shadows/shadowGenerator.js';
import { SpotLight } from '@babylonjs/core/Lights/spotLight.js';
import '@babylonjs/core/Lights/Shadows/shadowGeneratorSceneComponent.js';
import { StandardMaterial } from '@babylonjs/core/Materials/standardMaterial.js';
import { RenderTargetTexture } from '@babylonjs/core/Materials/Textures/renderTargetTexture.js';
import { Color3, Color4 } from '@babylonjs/core/Maths/math.color.js';
import { Vector3 } from '@babylonjs/core/Maths/math.vector.js';
import { Mesh } from '@babylonjs/core/Meshes/mesh.js';
import { VertexData } from '@babylonjs/core/Meshes/mesh.vertexData.js';
import { Scene } from '@babylonjs/core/scene.js';
import * as glsl from '/package/umbrage.mjs';
import * as wgsl from '/package/wgsl.mjs';
import { fit_bias, install, uninstall } from '/package/npm/babylon.mjs';
import { try_all } from '/bias_page.mjs';
import { camera as view, cone, height, lights, map_size, mesh_of, objects, width } from '/bias_scene.mjs';

const in_webgl = location.hash !== '', few = location.hash === '#few';

async function started(reversed) {
    const canvas = Object.assign(document.createElement('canvas'), { width, height });
    const engine = in_webgl ? new Engine(canvas, false) : new WebGPUEngine(canvas, { antialias: false });
    if (!in_webgl) await engine.initAsync();
    engine.useReverseDepthBuffer = reversed;
    return engine;
}

async function begin(kind, setting, options) {
    const { filter, given, use = 'usePercentageCloserFiltering', cascades = false, reversed = false, quality = 0, further = {} } = options;
    const engine = await started(reversed);
    if (filter) install(engine, { glsl: glsl[filter], wgsl: wgsl[filter], ...given });
    const scene = new Scene(engine);
    scene.useRightHandedSystem = true;  // before the camera is
    const camera = new FreeCamera('camera', new Vector3(...view.at), scene);
    camera.setTarget(new Vector3(...view.to));
    Object.assign(camera, { fov: view.fov * Math.PI / 180, minZ: view.z_near, maxZ: view.z_far });
    const at = new Vector3(...lights[kind]), down = at.scale(-1);
    const light = kind === 'directional' ? new DirectionalLight('', down, scene)
        : kind === 'spot' ? new SpotLight('', at, down, 2 * cone, 0, scene) : new PointLight('', at, scene);
    Object.assign(light, { position: at, intensity: 1, specular: Color3.Black() });
    const generator = cascades ? new CascadedShadowGenerator(map_size, light, true) : new ShadowGenerator(map_size, light);
    generator[use] = true;
    Object.assign(generator, { filteringQuality: quality, ...further });
    if (cascades) Object.assign(generator, { numCascades: 3, cascadeBlendPercentage: 0 });
    const material = new StandardMaterial('', scene);
    material.specularColor = Color3.Black();
    for (const [name, triangles] of Object.entries(objects)) {
        const mesh = new Mesh(name, scene), { positions, normals, indices } = mesh_of(triangles);
        Object.assign(new VertexData(), { positions, normals, indices: indices.reverse() }).applyToMesh(mesh);
        Object.assign(mesh, { material, receiveShadows: true });
        generator.addShadowCaster(mesh);
    }
    const target = new RenderTargetTexture('', { width, height }, scene, { generateMipMaps: false, type: Constants.TEXTURETYPE_FLOAT });
    Object.assign(target, { renderList: scene.meshes, activeCamera: camera, clearColor: new Color4(0, 0, 0, 0) });
    scene.customRenderTargets.push(target);
    const draw = async () => {
        await scene.whenReadyAsync();
        for (let frame = 0; frame < 2; ++frame) {  // biases follow cascades by one
            engine.beginFrame();
            scene.render();
            engine.endFrame();
        }
    };
    return {
        async set() {
            if (setting === 'fit') {
                if (cascades) await draw();
                return fit_bias(generator);
            }
            if (setting === 'copied') Object.assign(generator, { bias: 0.001, normalBias: 0.02 });
        },
        async radiance(lit) {
            generator.darkness = lit ? 1 : 0;
            await draw();
            const pixels = await target.readPixels();
            return Float32Array.from({ length: width * height },
                (_, i) => pixels[4 * ((height - 1 - Math.floor(i / width)) * width + i % width)]);  // from above
        },
        texels() {
            const maps = cascades ? Array.from({ length: generator.numCascades }, (_, i) => generator.getCascadeTransformMatrix(i))
                : [generator.getTransformMatrix()];
            const texels = kind === 'directional'
                ? maps.map(({ m }) => 2 / (Math.min(Math.hypot(m[0], m[4], m[8]), Math.hypot(m[1], m[5], m[9])) * map_size)) : [];
            return { texels, splits: cascades ? generator._viewSpaceFrustumsZ : [],
                tangent: kind === 'spot' ? Math.tan(cone * (light.shadowAngleScale || 1)) : 1 };
        },
        shift: () => 0,
        end() {
            if (filter) uninstall(engine);
            engine.dispose();
        },
    };
}

const settings = ['fit', 'default', 'copied'], cases = {};
for (const light of ['directional', 'spot', 'point'])
    for (const setting of settings) cases[`${light}.${setting}`] = { light, setting, ...(light === 'point' && { reach: 4 }) };
for (const setting of settings) cases[`cascades.${setting}`] = { light: 'directional', setting, cascades: true };
Object.assign(cases, {
    'directional.medium': { light: 'directional', quality: 1 },
    'directional.low': { light: 'directional', quality: 2 },
    'directional.hard': { light: 'directional', filter: 'hard' },
    'directional.disc': { light: 'directional', filter: 'disc16', given: { arguments: { radius: 4 } } },
    'directional.pcss': { light: 'directional', filter: 'pcss16', use: 'useContactHardeningShadow' },
    'directional.reversed': { light: 'directional', reversed: true },
    'spot.castano': { light: 'spot', filter: 'castano_dyadic5' },
    'spot.reversed': { light: 'spot', reversed: true },
    'point.none': { light: 'point', use: 'none' },
    'cascades.castano': { light: 'directional', filter: 'castano_dyadic5', cascades: true },
    'cascades.unclamped': { light: 'directional', cascades: true, further: { depthClamp: false } },
});

const chosen = name => !few || /[.](fit|hard)$/.test(name);
export const done = try_all(begin, Object.fromEntries(Object.entries(cases).filter(([name]) => chosen(name))));
