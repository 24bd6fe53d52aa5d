// SPDX-License-Identifier: MIT
//
// three.js with WebGPURenderer, or with its WebGL 2 fallback: pictures of each filter; receivers, visibilities and the map
// as floats for C++.
import * as THREE from 'three/webgpu';
import * as TSL from 'three/tsl';
import * as glsl from '/package/umbrage.mjs';
import * as wgsl from '/package/wgsl.mjs';
import { shadow_filter } from '/package/npm/three_webgpu.mjs';
import { base64, directional, height, make_scene, map_size, width } from '/scene.mjs';

const sun = {};  // SunLight and its node, where three has them
const fallback = location.hash === '#webgl';
const both = name => ({ wgsl: wgsl[name], glsl: glsl[name] });
const softness = { softness: [0.0234375, 0.0234375, 16, 256] };
const float_target = (w, h) => new THREE.RenderTarget(w, h, {
    type: THREE.FloatType, minFilter: THREE.NearestFilter, magFilter: THREE.NearestFilter });

async function picture(renderer, { scene, camera }) {
    renderer.setRenderTarget(null);
    renderer.render(scene, camera);
    const canvas = Object.assign(document.createElement('canvas'), { width, height });
    canvas.getContext('2d').drawImage(renderer.domElement, 0, 0);
    return canvas.toDataURL();
}

/** The scene with materials that show a property of the filter node. */
function showing(property, light, filter) {
    const made = make_scene(THREE, light);
    made.light.shadow.filterNode = filter;
    made.scene.background = null;
    made.scene.traverse(object => {
        if (!object.material) return;
        object.material = new THREE.MeshStandardNodeMaterial();
        object.material.outputNode = property;
        object.material.blending = THREE.NoBlending;
    });
    return made;
}

async function floats_of(renderer, filter, light, radius) {
    const property = TSL.property('vec4', 'umbrage_receiver');
    const made = showing(property, light, shadow_filter({ ...filter, receiver: property }));
    made.light.shadow.radius = radius;
    const target = float_target(width, height);
    renderer.setClearColor(0, 0);
    renderer.setRenderTarget(target);
    renderer.render(made.scene, made.camera);
    const receivers = await renderer.readRenderTargetPixelsAsync(target, 0, 0, width, height);
    const quad = new THREE.QuadMesh(new THREE.NodeMaterial()), map = float_target(map_size, map_size);
    quad.material.depthTest = false;
    quad.material.fragmentNode = TSL.vec4(TSL.textureLoad(made.light.shadow.map.depthTexture, TSL.ivec2(TSL.screenCoordinate.xy)).x);
    renderer.setRenderTarget(map);
    quad.render(renderer);
    const depths = await renderer.readRenderTargetPixelsAsync(map, 0, 0, map_size, map_size);
    return { receivers, depths: depths.filter((_, i) => i % 4 === 0) };
}

/** Rows the other way up: the fallback counts pixels from above and reads them from below. */
const flipped = (floats, row) => Float32Array.from(floats, (_, i) => {
    const y = Math.floor(i / row), rows = floats.length / row;
    return floats[(rows - 1 - y) * row + i % row];
});

async function drawn(reversed = false) {
    const renderer = new THREE.WebGPURenderer({ antialias: false, forceWebGL: fallback, reversedDepthBuffer: reversed });
    await renderer.init();
    const { library } = renderer;
    if (sun.SunLight) library.addLight(sun.SunLightNode, sun.SunLight);
    renderer.setSize(width, height);
    renderer.shadowMap.enabled = true;
    return renderer;
}

/** An error while three builds a shader, which it writes to the console. */
async function refusal_in_console(renderer, light) {
    const made = make_scene(THREE, light), { error } = console;
    let said = 'accepted';
    made.light.shadow.filterNode = shadow_filter(both('hard'));
    console.error = text => { said = text; };
    try { await picture(renderer, made); } catch (refused) { said = refused.message; }
    console.error = error;
    return said;
}

async function all() {
    const pictures = {}, floats = {}, said = {};
    const lights = { directional: () => directional(THREE), spot: () => new THREE.SpotLight(0xffffff, 200, 0, 0.6) };
    const scenes = {  // light, reversed depth; a name begins with its filter's
        own: ['directional'],
        hard: ['directional'],
        castano_dyadic5: ['directional'],
        disc16: ['directional'],
        pcss16: ['directional'],
        'castano_dyadic5.spot': ['spot'],
        'pcss16.spot': ['spot'],
        ...(Number(THREE.REVISION) >= 187 && {  // the first whose renderer draws maps of reversed depth
            'castano_dyadic5.reversed': ['directional', true],
            'pcss16.reversed': ['directional', true],
            'castano_dyadic5.reversed_spot': ['spot', true],
            'pcss16.reversed_spot': ['spot', true],
        }),
    };
    if (Number(THREE.REVISION) >= 186) {  // the first that has this light
        const { SunLight } = await import('/modules/three/examples/jsm/lights/SunLight.js');
        Object.assign(sun, await import('/modules/three/examples/jsm/lights/SunLightNode.js'), { SunLight });
        lights.sun = () => new SunLight(0xffffff, 2.2);
        Object.assign(scenes, { 'own.sun': ['sun'], 'castano_dyadic5.sun': ['sun'], 'castano_dyadic5.reversed_sun': ['sun', true] });
    }
    for (const [name, [kind, reversed]] of Object.entries(scenes)) {
        const renderer = await drawn(reversed), light = lights[kind], [filter_name] = name.split('.');
        const made = make_scene(THREE, light()), radius = made.light.shadow.radius = filter_name === 'disc16' ? 3 : 1;
        said.backend = renderer.backend.isWebGPUBackend ? 'webgpu' : 'webgl';
        const filter = { ...both(filter_name), arguments: filter_name === 'pcss16' ? softness : {} };
        if (filter_name !== 'own') made.light.shadow.filterNode = shadow_filter(filter);
        pictures[name] = await picture(renderer, made);
        if (filter_name === 'own') continue;
        const { receivers, depths } = await floats_of(renderer, filter, light(), radius);
        floats[`${name}.receivers`] = base64(fallback ? flipped(receivers, 4 * width) : receivers);
        floats[`${name}.map`] = base64(depths);
        if (reversed) said[`${name}.compare`] = 'greater_equal';
        renderer.dispose();
    }
    const renderer = await drawn(), two = make_scene(THREE, directional(THREE));
    two.light.shadow.filterNode = shadow_filter({ ...both('pcss16'), arguments: softness });
    const other = new THREE.SpotLight(0xffffff, 120, 0, 0.6);
    other.position.set(5, 5, -1);
    other.castShadow = true;
    other.shadow.bias = -0.002;
    other.shadow.filterNode = shadow_filter(both('castano_dyadic5'));
    two.scene.add(other);
    pictures.two_lights = await picture(renderer, two);
    if (!fallback) {
        const color = TSL.property('vec4', 'umbrage_color');
        pictures.probe = await picture(renderer, showing(color, directional(THREE),
            shadow_filter({ wgsl: wgsl.hard, probe: color })));
    }
    const refusal = call => { try { call(); return 'accepted'; } catch (error) { return error.message; } };
    said.point = await refusal_in_console(await drawn(), new THREE.PointLight(0xffffff, 200));
    const turned = await drawn(true), reversed = await refusal_in_console(turned, directional(THREE));
    said.reversed = reversed.includes('three.js must be r187 or later for reversed depth')
        === (turned.reversedDepthBuffer === true && Number(THREE.REVISION) < 187);  // r182 knows no such depth
    said.moments = refusal(() => shadow_filter({ wgsl: wgsl.vsm }));
    said.other = refusal(() => shadow_filter({ wgsl: wgsl.hard, glsl: glsl.pcss16 }));
    said.none = refusal(() => shadow_filter());
    return { pictures, floats, said };
}

export const done = all();
