// SPDX-License-Identifier: MIT
//
// three.js with WebGPURenderer, or with its WebGL 2 fallback: fit_shadow on each kind of light.
import * as THREE from 'three/webgpu';
import * as glsl from '/package/umbrage.mjs';
import * as wgsl from '/package/wgsl.mjs';
import { fit_shadow, set_light_size, shadow_filter } from '/package/npm/three_webgpu.mjs';
import { sun_cases, try_all } from '/fit_page.mjs';
import { height, width } from '/fit_scene.mjs';
import { try_softness } from '/soft_edge.mjs';

const fallback = location.hash === '#webgl';

async function begin({ scene, camera, light }, { type = THREE.PCFShadowMap, filter, reversed = false, logarithmic = false, ...given }) {
    const renderer = new THREE.WebGPURenderer({ antialias: false, forceWebGL: fallback,
        reversedDepthBuffer: reversed, logarithmicDepthBuffer: logarithmic });
    await renderer.init();
    renderer.setSize(width, height);
    Object.assign(renderer.shadowMap, { enabled: true, type });
    if (filter) light.shadow.filterNode = shadow_filter({ wgsl: wgsl[filter], glsl: glsl[filter], ...given });
    const target = new THREE.RenderTarget(width, height, { type: THREE.FloatType });
    return {
        renderer,
        async radiance() {
            renderer.setRenderTarget(target);
            renderer.render(scene, camera);
            const pixels = await renderer.readRenderTargetPixelsAsync(target, 0, 0, width, height);
            return Float32Array.from({ length: width * height }, (_, i) => {
                const row = Math.floor(i / width);  // the fallback reads from below
                return pixels[4 * ((fallback ? height - 1 - row : row) * width + i % width)];
            });
        },
        end() { renderer.dispose(); },
    };
}

const cases = {}, pcf_reach = Math.sqrt(0.9) + Math.SQRT2;
for (const light of ['directional', 'spot', 'point']) {
    for (const setting of ['fit', 'default', 'copied']) cases[`${light}.${setting}`] = { light, setting, reach: pcf_reach };
    cases[`${light}.basic`] = { light, type: THREE.BasicShadowMap };
    cases[`${light}.parent`] = { light, yard: { parent: true, scale: 20 } };
    if (Number(THREE.REVISION) >= 187) cases[`${light}.reversed`] = { light, reversed: true };
    if (light !== 'point' || Number(THREE.REVISION) >= 187) cases[`${light}.logarithmic`] = { light, logarithmic: true };
}
Object.assign(cases, {
    'directional.castano': { light: 'directional', filter: 'castano_dyadic5' },
    'spot.castano': { light: 'spot', filter: 'castano_dyadic5' },
});

export const done = (async () => {
    if (Number(THREE.REVISION) >= 187) {  // before, this light is registered in another way
        const lights = '/modules/three/examples/jsm/lights';
        const { SunLight } = await import(`${lights}/SunLight.js`), { SunLightNode } = await import(`${lights}/SunLightNode.js`);
        SunLight.registerNode(SunLightNode);
        Object.assign(cases, sun_cases(SunLight, pcf_reach));
    }
    const { pictures, floats, said } = await try_all(THREE, fit_shadow, begin, cases);
    return { pictures, floats, said: { ...said, ...await try_softness(THREE, set_light_size, begin) } };
})();
