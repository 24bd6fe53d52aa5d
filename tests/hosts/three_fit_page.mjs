// SPDX-License-Identifier: MIT
//
// three.js with WebGLRenderer: fit_shadow on each kind of light, with three.js' own filters and with ours.
import * as THREE from 'three';
import * as glsl from '/package/umbrage.mjs';
import { fit_shadow, install, set_light_size, uninstall } from '/package/npm/three.mjs';
import { sun_cases, try_all } from '/fit_page.mjs';
import { height, width } from '/fit_scene.mjs';
import { try_softness } from '/soft_edge.mjs';

async function begin({ scene, camera }, { type = THREE.PCFShadowMap, filter, reversed = false, ...given }) {
    const renderer = new THREE.WebGLRenderer({ antialias: false, preserveDrawingBuffer: true, reversedDepthBuffer: reversed });
    renderer.setSize(width, height);
    Object.assign(renderer.shadowMap, { enabled: true, type });
    if (filter) install(THREE, renderer, { filter: glsl[filter], ...given });
    const target = new THREE.WebGLRenderTarget(width, height, { type: THREE.FloatType });
    return {
        renderer,
        radiance() {
            const pixels = new Float32Array(width * height * 4);
            renderer.setRenderTarget(target);
            renderer.render(scene, camera);
            renderer.readRenderTargetPixels(target, 0, 0, width, height, pixels);
            return Float32Array.from({ length: width * height },
                (_, i) => pixels[4 * ((height - 1 - Math.floor(i / width)) * width + i % width)]);  // from above
        },
        end() {
            if (filter) uninstall(THREE);
            renderer.dispose();
            renderer.forceContextLoss();
        },
    };
}

const cases = {}, pcf_reach = Math.sqrt(0.9) + Math.SQRT2;
for (const light of ['directional', 'spot', 'point']) {
    for (const setting of ['fit', 'default', 'copied']) cases[`${light}.${setting}`] = { light, setting, reach: pcf_reach };
    cases[`${light}.basic`] = { light, type: THREE.BasicShadowMap };
    cases[`${light}.radius4`] = { light, yard: { radius: 4 } };
    cases[`${light}.parent`] = { light, yard: { parent: true, scale: 20 } };
    cases[`${light}.reversed`] = { light, reversed: true };
    cases[`${light}.camera`] = { light, camera: true };
}
Object.assign(cases, {
    'directional.steady': { light: 'directional', camera: true, options: { steady: true } },
    'directional.hard': { light: 'directional', filter: 'hard' },
    'directional.castano': { light: 'directional', filter: 'castano_dyadic5' },
    'directional.disc': { light: 'directional', filter: 'disc16', yard: { radius: 3 } },
    'spot.castano': { light: 'spot', filter: 'castano_dyadic5' },
});

export const done = (async () => {
    if (Number(THREE.REVISION) >= 186) {  // the first that has this light
        const { SunLight } = await import('/modules/three/examples/jsm/lights/SunLight.js');
        Object.assign(cases, sun_cases(SunLight, pcf_reach));
    }
    const { pictures, floats, said } = await try_all(THREE, fit_shadow, begin, cases);
    return { pictures, floats, said: { ...said, ...await try_softness(THREE, set_light_size, begin) } };
})();
