// SPDX-License-Identifier: MIT
//
// Types of umbrage/three/webgpu.
import type { Snippet as GlslSnippet } from '../umbrage.mjs';
import type { Snippet } from '../wgsl.mjs';

export { fit_shadow } from './three_fit.mjs';
export { set_light_size } from './three_light_size.mjs';
export type { Box, Fit, Fitted, Part, Parts } from './three_fit.mjs';

export interface Options {
    /** A filter that reads depths: wgsl.hard, wgsl.castano_dyadic5, wgsl.disc16, wgsl.pcss16, ... A light's shadow.radius is
     *  a disc's radius in texels, and scales the softness of pcss and dpcf. */
    readonly wgsl: Snippet;
    /** The same filter in GLSL, for the WebGL 2 fallback; without it that one throws. */
    readonly glsl?: GlslSnippet;
    /** In place of the filter's defaults, see wgsl.filter.arguments; but for rotation, of which each pixel has its own. */
    readonly arguments?: Readonly<Record<string, number | readonly number[]>>;
    /** Discs, and what searches by them, rotate from frame to frame, for temporal antialiasing (TAA): each pixel has all 16
     *  rotations in 16 frames. */
    readonly frame?: boolean;
    /** A TSL property('vec4', ...) that gets the debug color of umbrage_probe_color; WebGPU alone. */
    readonly probe?: any;
    /** A TSL property('vec4', ...) that gets the receiver: texels, texels, depth, visibility. */
    readonly receiver?: any;
}

/** A light's filter node: light.shadow.filterNode = shadow_filter({ wgsl: wgsl.pcss16 }). Maps are single textures: spot
 *  and directional lights. CSMShadowNode clones shadows without their filterNode.
 *  A point light keeps three.js' own filter, and a warning on the console says so.
 *  @throws Error   options that do not fit; while a shader is built: a missing glsl, compatibility mode,
 *                  reversed depth before r187 */
export function shadow_filter(options: Options): any;
