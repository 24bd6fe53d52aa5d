// SPDX-License-Identifier: MIT
//
// three.js with WebGLRenderer: pictures of each filter; receivers, visibilities and the map as floats for C++.
import * as THREE from 'three';
import { castano_dyadic5, disc16, hard, pcss16, vsm } from '/package/umbrage.mjs';
import { install, uninstall } from '/package/npm/three.mjs';
import { base64, directional, height, make_scene, map_size, width } from '/scene.mjs';

const float_target = (w, h) => new THREE.WebGLRenderTarget(w, h, {
    type: THREE.FloatType, format: THREE.RGBAFormat, minFilter: THREE.NearestFilter, magFilter: THREE.NearestFilter });

function drawn(reversed = false) {
    const renderer = new THREE.WebGLRenderer({ antialias: false, preserveDrawingBuffer: true, reversedDepthBuffer: reversed });
    renderer.setSize(width, height);
    renderer.shadowMap.enabled = true;
    return renderer;
}

/** (x, y) in texels, depth and visibility of each pixel, as the addon's own function saw them. */
function receivers(renderer, { scene, camera }) {
    scene.background = null;
    scene.traverse(({ material }) => {
        if (!material) return;
        material.onBeforeCompile = shader => {
            shader.fragmentShader = shader.fragmentShader.replace(/}\s*$/,
                '#if defined( USE_SHADOWMAP )\ngl_FragColor = umbrage_receiver;\n#endif\n}');
        };
        material.needsUpdate = true;
    });
    const target = float_target(width, height), pixels = new Float32Array(width * height * 4);
    renderer.setRenderTarget(target);
    renderer.setClearColor(0, 0);
    renderer.clear();
    renderer.render(scene, camera);
    renderer.readRenderTargetPixels(target, 0, 0, width, height, pixels);
    return pixels;
}

function depths_of(renderer, { light, camera }) {
    const quad = new THREE.Mesh(new THREE.PlaneGeometry(2, 2), new THREE.ShaderMaterial({
        uniforms: { map: { value: light.shadow.map.depthTexture } }, depthTest: false,
        vertexShader: 'void main() { gl_Position = vec4(position, 1.0); }',
        fragmentShader: 'uniform highp sampler2D map;\n'
            + 'void main() { gl_FragColor = vec4(texelFetch(map, ivec2(gl_FragCoord.xy), 0).x); }' }));
    quad.frustumCulled = false;
    const target = float_target(map_size, map_size), pixels = new Float32Array(map_size * map_size * 4);
    renderer.shadowMap.autoUpdate = false;
    renderer.setRenderTarget(target);
    renderer.render(quad, camera);
    renderer.readRenderTargetPixels(target, 0, 0, map_size, map_size, pixels);
    return pixels.filter((_, i) => i % 4 === 0);
}

const picture = renderer => renderer.domElement.toDataURL();
const chunks = () => THREE.ShaderChunk.shadowmap_pars_fragment + THREE.ShaderChunk.dithering_fragment;
const refusal = call => { try { call(); return 'accepted'; } catch (error) { return error.message; } };

export const done = (async () => {
    const pictures = {}, floats = {}, said = {};
    const own_text = chunks();
    const lights = { directional: () => directional(THREE), spot: () => new THREE.SpotLight(0xffffff, 200, 0, 0.6) };
    const scenes = {  // filter, light, reversed depth
        own: [null, 'directional'],
        hard: [hard, 'directional'],
        castano_dyadic5: [castano_dyadic5, 'directional'],
        disc16: [disc16, 'directional'],
        pcss16: [pcss16, 'directional'],
        'castano_dyadic5.spot': [castano_dyadic5, 'spot'],
        'pcss16.spot': [pcss16, 'spot'],
        'castano_dyadic5.reversed': [castano_dyadic5, 'directional', true],
        'pcss16.reversed': [pcss16, 'directional', true],
        'castano_dyadic5.reversed_spot': [castano_dyadic5, 'spot', true],
        'pcss16.reversed_spot': [pcss16, 'spot', true],
    };
    if (Number(THREE.REVISION) >= 186) {  // the first that has this light
        const { SunLight } = await import('/modules/three/examples/jsm/lights/SunLight.js');
        lights.sun = () => new SunLight(0xffffff, 2.2);
        Object.assign(scenes, {  // not pcss16, which SwiftShader compiles for minutes: three has two calls for this light
            'own.sun': [null, 'sun'], 'castano_dyadic5.sun': [castano_dyadic5, 'sun'], 'disc16.sun': [disc16, 'sun'],
            'castano_dyadic5.reversed_sun': [castano_dyadic5, 'sun', true] });
    }
    for (const [name, [filter, light, reversed]] of Object.entries(scenes)) {
        const renderer = drawn(reversed), made = make_scene(THREE, lights[light]());
        made.light.shadow.radius = filter === disc16 ? 3 : 1;
        if (filter) install(THREE, renderer, { filter, arguments: filter === pcss16 ? { softness: [0.0234375, 0.0234375, 16, 256] } : {} });
        renderer.render(made.scene, made.camera);
        pictures[name] = picture(renderer);
        if (filter) {
            floats[`${name}.receivers`] = base64(receivers(renderer, made));
            floats[`${name}.map`] = base64(depths_of(renderer, made));
            if (reversed) said[`${name}.compare`] = 'greater_equal';
            uninstall(THREE);
        }
        renderer.dispose();
        renderer.forceContextLoss();
    }
    said.restored = chunks() === own_text;

    const renderer = drawn(true), spot = make_scene(THREE, new THREE.SpotLight(0xffffff, 200, 0, 0.6));
    said.reversed = renderer.state.buffers.depth.getReversed();
    install(THREE, renderer, { filter: castano_dyadic5 });
    renderer.render(spot.scene, spot.camera);
    pictures.reversed_spot = picture(renderer);
    install(THREE, renderer, { filter: castano_dyadic5, probe: true, scene: spot.scene });  // another filter, at run time
    renderer.render(spot.scene, spot.camera);
    pictures.probe = picture(renderer);
    uninstall(THREE, { scene: spot.scene });

    for (const keyed of [false, true]) {  // at run time, with the default of one's own in place of the light's radius too
        const renderer = drawn(), made = make_scene(THREE, directional(THREE)), { scene } = made;
        made.light.shadow.radius = 3;
        if (keyed) scene.traverse(({ material }) => { if (material) material.customProgramCacheKey = () => 'own'; });
        const [before, with_3, with_2] = [{ filter: hard }, { filter: disc16 }, { filter: disc16, arguments: { radius: 2 } }].map(options => {
            install(THREE, renderer, { ...options, scene });
            renderer.render(scene, made.camera);
            return picture(renderer);
        });
        said[keyed ? 'later.keyed' : 'later'] = before === pictures.hard && with_3 === pictures.disc16 && with_2 !== with_3;
        uninstall(THREE, { scene });
        renderer.dispose();
    }
    const pair = [drawn(), drawn()], scenes_of_pair = pair.map(() => make_scene(THREE, directional(THREE)));
    const both = () => pair.map((renderer, i) => {
        renderer.render(scenes_of_pair[i].scene, scenes_of_pair[i].camera);
        return picture(renderer);
    });
    for (const renderer of pair) install(THREE, renderer, { filter: castano_dyadic5 });
    said.two_renderers = both().every(drawn => drawn === pictures.castano_dyadic5);
    uninstall(THREE);
    said.two_restored = both().every(drawn => drawn === pictures.own);

    said.moments = refusal(() => install(THREE, renderer, { filter: vsm }));
    said.no_filter = refusal(() => install(THREE, renderer, { filter: 'pcss16' }));
    said.argument = refusal(() => install(THREE, renderer, { filter: pcss16, arguments: { softnes: 1 } }));
    said.number = refusal(() => install(THREE, renderer, { filter: pcss16, arguments: { softness: [1, 2] } }));
    said.renderer = refusal(() => install(THREE, { shadowMap: {} }, { filter: hard }));
    said.text = refusal(() => {
        const other = { ...THREE, ShaderChunk: { ...THREE.ShaderChunk, shadowmap_pars_fragment: 'float getShadow() {}' } };
        install(other, renderer, { filter: hard });
    });
    said.old = refusal(() => install({ ...THREE, REVISION: '176' }, renderer, { filter: hard }));
    said.untouched = chunks() === own_text;
    return { pictures, floats, said };
})();
