// SPDX-License-Identifier: MIT
//
// PlayCanvas with WebGPU or WebGL 2: discs that rotate from frame to frame, and stand still without frame.
import * as pc from 'playcanvas';
import { disc16 } from '/package/umbrage.mjs';
import { disc16 as in_wgsl } from '/package/wgsl.mjs';
import { install, uninstall } from '/package/npm/playcanvas.mjs';
import { tried_turns } from '/frames.mjs';

const in_webgl = location.hash === '#webgl', side = 96;
const filter = { glsl: disc16, wgsl: in_wgsl, arguments: { radius: 5 } };

async function started(canvas) {
    const graphicsDevice = await pc.createGraphicsDevice(canvas, { antialias: false, preserveDrawingBuffer: true,
        deviceTypes: [in_webgl ? pc.DEVICETYPE_WEBGL2 : pc.DEVICETYPE_WEBGPU] });
    const app = new pc.AppBase(canvas);
    app.init(Object.assign(new pc.AppOptions(), { graphicsDevice,
        componentSystems: [pc.RenderComponentSystem, pc.CameraComponentSystem, pc.LightComponentSystem] }));
    app.scene.clusteredLightingEnabled = app.scene.lighting.shadowsEnabled = false;
    app.autoRender = false;
    app.start();
    return app;
}

/** A box over a floor, in materials whose programs no other scene has. */
function make_scene(app, name) {
    for (const entity of [...app.root.children]) entity.destroy();
    const add = (component, options, at) => {
        const entity = new pc.Entity();
        entity.addComponent(component, options);
        entity.setPosition(...at);
        app.root.addChild(entity);
        return entity;
    };
    for (const [type, at, size] of [['plane', [0, 0, 0], 4], ['box', [0, 1.5, 0], 1]]) {
        const material = new pc.StandardMaterial();
        material.setDefine(`SCENE_${name}`, true);
        add('render', { type, material }, at).setLocalScale(size, size, size);
    }
    add('camera', { fov: 30 }, [0, 8, 0]).setEulerAngles(-90, 0, 0);
    add('light', { type: 'directional', castShadows: true, shadowResolution: 64, shadowDistance: 20, normalOffsetBias: 0.1,
        shadowType: pc.SHADOW_PCF5_32F }, [0, 0, 0]).setEulerAngles(20, 30, 0);
}

export const done = (async () => {
    const canvas = Object.assign(document.createElement('canvas'), { width: side, height: side });
    document.body.append(canvas);
    const app = await started(canvas), device = app.graphicsDevice, said = {};
    const copy = Object.assign(document.createElement('canvas'), { width: side, height: side }).getContext('2d', { willReadFrequently: true });
    const pixels = async () => {
        app.renderNextFrame = true;
        await new Promise(drawn => { app.once('postrender', drawn); });
        copy.drawImage(device.canvas, 0, 0, side, side);
        return Array.from(copy.getImageData(0, 0, side, side).data.filter((_, i) => i % 4 === 1));
    };
    for (const [name, options] of Object.entries({ still: {}, frames: { frame: true }, still_again: {} })) {
        install(device, { ...filter, ...options });
        make_scene(app, name);
        await pixels();
        said[name] = await tried_turns(pixels);
    }
    uninstall(device);
    return { pictures: { frames: canvas.toDataURL() }, floats: {}, said };
})();
