// SPDX-License-Identifier: MIT
//
// Types of umbrage/three. three.js itself comes with no types; @types/three fits.
import type { Snippet } from '../umbrage.mjs';

export { fit_shadow } from './three_fit.mjs';
export { set_light_size } from './three_light_size.mjs';
export type { Box, Fit, Fitted, Part, Parts } from './three_fit.mjs';

/** What the addon uses of three.js: pass the whole module. */
export interface Three {
    readonly REVISION: string;
    readonly ShaderChunk: object;
    readonly BasicShadowMap: number;
    readonly WebGLRenderer: Function;
    readonly Material: { readonly prototype: object };
}

export interface Scene { traverse(use: (object: any) => void): void }

export interface Options {
    /** A filter that reads depths: hard, castano_dyadic5, disc16, pcss16, ... A light's shadow.radius is a disc's radius in
     *  texels, and scales the softness of pcss and dpcf. */
    readonly filter: Snippet;
    /** In place of the filter's defaults, see filter.filter.arguments; but for rotation, of which each pixel has its own. */
    readonly arguments?: Readonly<Record<string, number | readonly number[]>>;
    /** Discs, and what searches by them, rotate from frame to frame of this renderer, for temporal antialiasing (TAA): each
     *  pixel has all 16 rotations in 16 frames. THREE must have ShaderLib. */
    readonly frame?: boolean;
    /** Colors that say what is wrong with a receiver, as umbrage_probe_color has them; gray: no light reached it. */
    readonly probe?: boolean;
    /** A scene that was drawn before: its materials are compiled again. Those with a customProgramCacheKey of their own may
     *  share programs: give a scene that holds all of them. Their dispose() is called, and three.js draws them as new ones. */
    readonly scene?: Scene;
}

/** Puts a filter in place of three.js' own, for all lights but point lights, and for all materials of a page. Sets the
 *  renderer's shadowMap.type: call it for each renderer. All renderers share the last call's filter, and have one direction
 *  of depth. Materials that were drawn before get it with their scene alone.
 *  @throws Error   another copy of three.js than the renderer's, one older than r182, one whose shader text is not known,
 *                  a renderer of another direction of depth, options that do not fit. Nothing is changed then */
export function install(THREE: Three, renderer: object, options: Options): void;

/** Restores three.js' own text, byte for byte, and all renderers' types of shadow maps.
 *  @throws Error   options that do not fit */
export function uninstall(THREE: Three, options?: { readonly scene?: Scene }): void;
