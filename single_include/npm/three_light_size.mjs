// SPDX-License-Identifier: MIT
//
// three.js: the size of a light in the world, for filters that search for blockers, whatever its shadow camera and map.
//
//     import { set_light_size } from 'umbrage/three';  // or 'umbrage/three/webgpu'
//     set_light_size(light, 0.02);
import { must } from './options.mjs';
import { in_use } from './three_fit.mjs';

const where = 'three: set_light_size';

/** What a softness of pcss and dpcf is for a light: 1/16 texel for each of 65536 distances between the planes. */
export function softness_of(light, size) {
    const { camera, mapSize, focus } = light.shadow;
    if (light.isSpotLight) {  // depths are linear in 1 / distance, and so is a penumbra's width in texels
        const far = light.distance || camera.far, texels = mapSize.y / (2 * Math.tan(light.angle * focus));
        return 16 * size * texels * (far - camera.near) / (far * camera.near) / 65536;
    }
    const texel = (camera.right - camera.left) / (camera.zoom * mapSize.x);
    return 16 * size * (camera.far - camera.near) / texel / 65536;
}

/** The first of the filter's softness, which a light's radius multiplies: that of its node, or of install. */
function softness_in_use({ shadow: { filterNode } }) {
    const { given } = (filterNode ? in_use.nodes.get(filterNode) : in_use.webgl) ?? {};
    return given?.all.softness?.[0];
}

/** Rounded to 8 bits, as C++ rounds it. */
function first_bits(value) {
    const scale = 2 ** (7 - Math.floor(Math.log2(value)));
    return value > 0 ? Math.round(value * scale) / scale : 0;
}

/** Gives a light a size in the world: three.js reads shadow.radius in each frame, which follows the camera and map from now on. */
export function set_light_size(light, size) {
    must(where, (light?.isDirectionalLight || light?.isSpotLight) && light.shadow,
        'light must be a DirectionalLight or a SpotLight', light);
    must(where, Number.isFinite(size) && size >= 0, 'light_size must be finite, 0 or more', size);
    const { shadow } = light;
    let own = shadow.radius;
    Object.defineProperty(shadow, 'radius', {
        configurable: true, enumerable: true,
        get() {
            const first = softness_in_use(light);  // of a filter without a search: a radius in texels
            return first > 0 ? first_bits(softness_of(light, size)) / first : own;
        },
        set(radius) { own = radius; },
    });
}
