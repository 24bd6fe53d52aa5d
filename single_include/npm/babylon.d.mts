// SPDX-License-Identifier: MIT
//
// Types of umbrage/babylon.
import type { Snippet as GlslSnippet } from '../umbrage.mjs';
import type { Snippet } from '../wgsl.mjs';

/** Members of an engine that the addon uses. */
export interface Engine {
    readonly isWebGPU: boolean;
    readonly version: number;
    readonly useReverseDepthBuffer: boolean;
    releaseEffects(): void;
}

/** Members of a scene that the addon uses. */
export interface Scene { readonly meshes: readonly { resetDrawCache(): void }[] }

/** A filter that compares depths replaces PCF of medium and high quality: hard, tent3, castano_dyadic5, disc16, ... One that
 *  searches for blockers replaces PCSS: pcss16, dpcf16, ... */
export interface Options {
    /** The filter for an engine with WebGPU. */
    readonly wgsl?: Snippet;
    /** The filter for an engine with WebGL 2. */
    readonly glsl?: GlslSnippet;
    /** In place of the filter's defaults, see glsl.filter.arguments; but for rotation, of which each pixel has its own. A
     *  generator's contactHardeningLightSizeUVRatio scales the softness. */
    readonly arguments?: Readonly<Record<string, number | readonly number[]>>;
    /** Colors that say what is wrong with a receiver, as umbrage_probe_color has them; gray: no light reached it. */
    readonly probe?: boolean;
    /** A scene that was drawn before: its materials are compiled again. */
    readonly scene?: Scene;
}

/** Puts a filter in place of Babylon.js' own, for all spot and directional lights, with cascades or without, and for all
 *  materials. A call for each kind; a second call of a kind changes its filter. All engines of a page that compile the same
 *  language share the filters, and must have the first one's useReverseDepthBuffer.
 *  @throws Error   an engine of another copy of @babylonjs/core, with WebGL 1, or with depth of the other direction; a shader
 *                  text that is not known; options that do not fit. Nothing is changed then */
export function install(engine: Engine, options: Options): void;

/** Restores Babylon.js' own text, byte for byte.
 *  @throws Error   an engine of another copy of @babylonjs/core; options that do not fit */
export function uninstall(engine: Engine, options?: { readonly scene?: Scene }): void;

/** Gives the directional light of a shadow generator a size in the world, for contact hardening by pcss and dpcf: penumbras are
 *  as wide as under a round light of that size, whatever the light's box and planes are or become. Sets
 *  contactHardeningLightSizeUVRatio in each frame. Penumbras end at the largest radius of the filter's softness.
 *  @param generator    a ShadowGenerator or CascadedShadowGenerator
 *  @param light_size   tangent of half the angle under which the light is seen: 0.00465 for the sun
 *  @throws Error       a generator of another light, or a size that is not finite or below 0 */
export function set_light_size(generator: object, light_size: number): void;
