// SPDX-License-Identifier: MIT
//
// Babylon.js with WebGPU or WebGL 2: discs that rotate from frame to frame, in materials that were made before and after install,
// frozen ones too; without frame they stand still.
import { FreeCamera } from '@babylonjs/core/Cameras/freeCamera.js';
import { Engine } from '@babylonjs/core/Engines/engine.js';
import { WebGPUEngine } from '@babylonjs/core/Engines/webgpuEngine.js';
import '@babylonjs/core/Engines/WebGPU/Extensions/index.js';
import { DirectionalLight } from '@babylonjs/core/Lights/directionalLight.js';
import { ShadowGenerator } from '@babylonjs/core/Lights/Shadows/shadowGenerator.js';
import '@babylonjs/core/Lights/Shadows/shadowGeneratorSceneComponent.js';
import { PBRMaterial } from '@babylonjs/core/Materials/PBR/pbrMaterial.js';
import { StandardMaterial } from '@babylonjs/core/Materials/standardMaterial.js';
import { Vector3 } from '@babylonjs/core/Maths/math.vector.js';
import { CreateBox } from '@babylonjs/core/Meshes/Builders/boxBuilder.js';
import { CreateGround } from '@babylonjs/core/Meshes/Builders/groundBuilder.js';
import { Scene } from '@babylonjs/core/scene.js';
import { disc16 } from '/package/umbrage.mjs';
import { disc16 as in_wgsl } from '/package/wgsl.mjs';
import { install, uninstall } from '/package/npm/babylon.mjs';
import { tried_turns } from '/frames.mjs';

const in_webgl = location.hash === '#webgl', side = 96;
const filter = { glsl: disc16, wgsl: in_wgsl, arguments: { radius: 5 } };

/** A box over a floor, whose two halves have materials of two kinds. */
function make_scene(engine) {
    const scene = new Scene(engine), light = new DirectionalLight('sun', new Vector3(0, -1, 0.5), scene);
    const camera = new FreeCamera('camera', new Vector3(0, 8, 0.01), scene);
    camera.setTarget(Vector3.Zero());
    camera.fov = 0.5;
    light.position = new Vector3(0, 6, -3);
    Object.assign(light, { intensity: 0.8, shadowMinZ: 1, shadowMaxZ: 12 });  // below white, which would hide turns
    const generator = new ShadowGenerator(64, light);
    generator.usePercentageCloserFiltering = true;
    generator.bias = 0.01;
    const box = CreateBox('box', { size: 1 }, scene);
    box.position.y = 1.5;
    generator.addShadowCaster(box);
    const materials = [StandardMaterial, PBRMaterial].map((Material, i) => {
        const floor = CreateGround('floor', { width: 2, height: 4 }, scene);
        floor.position.x = 2 * i - 1;
        floor.receiveShadows = true;
        floor.material = new Material('', scene);
        return Object.assign(floor.material, { metallic: 0, roughness: 1 });
    });
    return { scene, materials };
}

export const done = (async () => {
    const canvas = Object.assign(document.createElement('canvas'), { width: side, height: side });
    const engine = in_webgl ? new Engine(canvas, false, { preserveDrawingBuffer: true })
        : new WebGPUEngine(canvas, { antialias: false });
    if (!in_webgl) await engine.initAsync();
    const copy = Object.assign(document.createElement('canvas'), { width: side, height: side }).getContext('2d', { willReadFrequently: true });
    const pixels = scene => {
        engine.beginFrame();
        scene.render();
        engine.endFrame();
        copy.drawImage(canvas, 0, 0);
        return Array.from(copy.getImageData(0, 0, side, side).data.filter((_, i) => i % 4 === 1));
    };
    const said = {}, tried = async (name, { scene }) => {
        await scene.whenReadyAsync();
        pixels(scene);
        for (const [half, material] of ['standard', 'pbr'].entries())
            said[`${name}.${material}`] = await tried_turns(() => pixels(scene).filter((_, i) => (i % side < side / 2) === (half === 0)));
    };
    const before = make_scene(engine);
    install(engine, filter);
    await tried('still', before);
    install(engine, { ...filter, frame: true, scene: before.scene });
    await tried('before', before);
    const after = make_scene(engine);
    await tried('frames', after);
    for (const material of after.materials) material.freeze();
    await tried('frozen', after);
    for (const material of after.materials) material.unfreeze();
    uninstall(engine, { scene: after.scene });
    await tried('own', after);
    return { pictures: { frames: canvas.toDataURL() }, floats: {}, said };
})();
