// SPDX-License-Identifier: MIT
//
// Babylon.js: what a frame adds to the pixel by which discs rotate, as a uniform of each material that is made from now on.
// Materials of Babylon.js that take no plugins keep one rotation for each pixel: their shaders miss UMBRAGE_TURN.
import { MaterialPluginBase } from '@babylonjs/core/Materials/materialPluginBase.js';
import { RegisterMaterialPlugin, UnregisterMaterialPlugin } from '@babylonjs/core/Materials/materialPluginManager.js';
import { turn_of_frame } from './options.mjs';

const name = 'umbrage turn', uniform = 'umbrage_turn', wgsl = 1;  // of ShaderLanguage

/** The pixel in a frame, in both languages: a function behind the globals that the engine declares. */
export const turned_pixel = {
    glsl: pixel => `highp vec2 umbrage_turned() {
#ifdef UMBRAGE_TURN
    return ${pixel} + ${uniform};
#else
    return ${pixel};
#endif
}\n`,
    wgsl: pixel => `fn umbrage_turned() -> vec2f {
#ifdef UMBRAGE_TURN
    return ${pixel} + uniforms.${uniform};
#else
    return ${pixel};
#endif
}\n`,
};

class Turn extends MaterialPluginBase {
    constructor(material) {
        super(material, name, 500, { UMBRAGE_TURN: true });
        this.registerForExtraEvents = true;  // of frozen materials too
        this.doNotSerialize = true;
        this._enable(true);
    }

    getClassName() { return 'UmbrageTurn'; }

    isCompatible() { return true; }

    getUniforms(language) {
        return { ubo: [{ name: uniform, size: 2, type: 'vec2' }],
            ...(language !== wgsl && { fragment: `#ifdef UMBRAGE_TURN\nuniform highp vec2 ${uniform};\n#endif\n` }) };
    }

    hardBindForSubMesh(buffer, _, engine) { buffer.updateFloat2(uniform, 0, turn_of_frame(engine.frameId)); }
}

/** Gives all further materials a turn, and those that a scene has. */
export function turn_by_frame(scene) {
    RegisterMaterialPlugin(name, material => new Turn(material));
    for (const material of scene?.materials ?? []) if (!material.pluginManager?.getPlugin(name)) new Turn(material);
}

export const stop_turning = () => UnregisterMaterialPlugin(name);
