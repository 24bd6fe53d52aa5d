// SPDX-License-Identifier: MIT
//
// Babylon.js: the size of a directional light in the world, for contact hardening, whatever the light's box and planes.
//
//     import { set_light_size } from 'umbrage/babylon';
//     set_light_size(generator, 0.02);
import { must } from './options.mjs';

const where = 'babylon: set_light_size', directional = 1;  // of Light.getTypeID
const sizes = new WeakMap();  // generator -> its light's size

/** contactHardeningLightSizeUVRatio: a penumbra across all depths, over the map's width. */
function ratio_of(generator, size) {
    const { m } = generator.getCascadeTransformMatrix?.(0) ?? generator.getTransformMatrix();
    const [across, deep] = [0, 2].map(axis => Math.hypot(m[axis], m[axis + 4], m[axis + 8]));
    const depths = generator.getLight().getScene().getEngine().isNDCHalfZRange ? 1 : 2;
    return size * (across / 2) / (deep / depths);
}

/** Gives a generator's light a size in the world, from the next frame on. */
export function set_light_size(generator, size) {
    const light = generator?.getLight?.();
    must(where, light?.getTypeID?.() === directional && typeof generator.getTransformMatrix === 'function',
        'generator must be a shadow generator of a DirectionalLight', light ?? generator);
    must(where, Number.isFinite(size) && size >= 0, 'light_size must be finite, 0 or more', size);
    if (!sizes.has(generator))
        light.getScene().onAfterRenderTargetsRenderObservable.add(() => {  // boxes and cascades are those of this frame
            if (generator.getShadowMap()) generator.contactHardeningLightSizeUVRatio = ratio_of(generator, sizes.get(generator));
        });
    sizes.set(generator, size);
}
