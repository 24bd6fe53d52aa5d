// SPDX-License-Identifier: MIT
//
// three.js with WebGPURenderer, or with its WebGL 2 fallback: map size, radius, cameras and lights change after the first
// frame; a point light with a filter node is drawn as three.js draws it alone.
import * as THREE from 'three/webgpu';
import * as glsl from '/package/umbrage.mjs';
import * as wgsl from '/package/wgsl.mjs';
import { shadow_filter } from '/package/npm/three_webgpu.mjs';
import { tried_changes, tried_frames } from '/changes.mjs';
import { directional, height, make_scene, width } from '/scene.mjs';

const both = name => shadow_filter({ wgsl: wgsl[name], glsl: glsl[name] });

export const done = (async () => {
    const renderer = new THREE.WebGPURenderer({ antialias: false, forceWebGL: location.hash === '#webgl' }), pictures = {}, said = {};
    await renderer.init();
    renderer.setSize(width, height);
    renderer.shadowMap.enabled = true;
    const draw = async ({ scene, camera }) => {
        await new Promise(requestAnimationFrame);  // three.js draws a light's map once a frame
        renderer.render(scene, camera);
        const canvas = Object.assign(document.createElement('canvas'), { width, height });
        canvas.getContext('2d').drawImage(renderer.domElement, 0, 0);
        return canvas.toDataURL();
    };
    said.wrong = await tried_changes(THREE, draw, light => { light.shadow.filterNode = both('disc16'); });

    const still = make_scene(THREE, directional(THREE));  // another map size before the map is drawn again
    still.light.shadow.filterNode = both('castano_dyadic5');
    pictures.still = await draw(still);
    still.light.shadow.autoUpdate = false;
    still.light.shadow.mapSize.set(2048, 2048);
    said.still = pictures.still === await draw(still);

    said.frames = await tried_frames(THREE, async made => {
        await new Promise(requestAnimationFrame);
        renderer.render(made.scene, made.camera);
        const context = Object.assign(document.createElement('canvas'), { width, height }).getContext('2d');
        context.drawImage(renderer.domElement, 0, 0);
        return Array.from(context.getImageData(0, 0, width, height).data.filter((_, i) => i % 4 === 1));
    }, light => { light.shadow.filterNode = shadow_filter({ wgsl: wgsl.disc16, glsl: glsl.disc16, frame: true }); });

    const { warn } = console, words = [];
    const lamp = () => make_scene(THREE, new THREE.PointLight(0xffffff, 200));
    pictures.own_point = await draw(lamp());
    const made = lamp();
    made.light.shadow.filterNode = both('castano_dyadic5');
    console.warn = text => words.push(text);
    pictures.point = await draw(made);
    console.warn = warn;
    said.point = pictures.point === pictures.own_point;
    said.words = words.join('\n');
    return { pictures, floats: {}, said };
})();
