// SPDX-License-Identifier: MIT
//
// Types of umbrage/playcanvas.
import type { Snippet as GlslSnippet } from '../umbrage.mjs';
import type { Snippet } from '../wgsl.mjs';

/** Members of a graphics device that the addon uses. */
export interface Device { readonly isWebGPU: boolean }

/** Members of a light component that the addon uses. */
export interface Light {
    readonly type: string;
    readonly shadowType: number;
    readonly system: { readonly app: { readonly scene: Scene } };
}

/** Members of a scene that the addon uses. */
export interface Scene {
    readonly clusteredLightingEnabled: boolean;
    readonly lighting: { readonly shadowType: number };
}

/** A filter that compares depths replaces SHADOW_PCF3_* and SHADOW_PCF5_*: hard, tent3, castano_dyadic5, disc16, ... One that
 *  searches for blockers replaces SHADOW_PCSS_32F of directional lights: pcss16, dpcf16, ... */
export interface Options {
    /** The filter for a device with WebGPU. */
    readonly wgsl?: Snippet;
    /** The filter for a device with WebGL 2. */
    readonly glsl?: GlslSnippet;
    /** In place of the filter's defaults, see glsl.filter.arguments; but for rotation, of which each pixel has its own. A
     *  light's penumbraSize scales the softness. */
    readonly arguments?: Readonly<Record<string, number | readonly number[]>>;
    /** Discs, and what searches by them, rotate from frame to frame, for temporal antialiasing (TAA): each pixel has all 16
     *  rotations in 16 frames. The device must be that of the current app. */
    readonly frame?: boolean;
    /** Colors that say what is wrong with a receiver, as umbrage_probe_color has them; gray: no light reached it. */
    readonly probe?: boolean;
    /** Lights that must get the filter, components of entities. Without it, those of the app that cast shadows of its kind.
     *  [] leaves all others with PlayCanvas' own filter. */
    readonly lights?: readonly Light[];
}

/** Puts a filter in place of PlayCanvas' own, for all materials that were not drawn before. A call for each kind; a second
 *  call of a kind changes its filter.
 *  @throws Error   a device of another copy of playcanvas, or of no app; chunks whose text is not known; options that do not
 *                  fit; a light that the filter does not reach. Nothing is changed then */
export function install(device: Device, options: Options): void;

/** Restores PlayCanvas' own text, byte for byte.
 *  @throws Error   a device of another copy of playcanvas */
export function uninstall(device: Device): void;

/** Gives a directional light a size in the world, for SHADOW_PCSS_32F by pcss and dpcf: penumbras are as wide as under a round
 *  light of that size. They end at the largest radius of the filter's softness.
 *  Texels must be squares of the world. For others pass arguments: { softness: [x, y, min, max] }, with x and y in the ratio
 *  of the texels for each unit of the world.
 *  @param light        the component of a directional light
 *  @param light_size   tangent of half the angle under which the light is seen: 0.00465 for the sun
 *  @throws Error       another light, or a size that is not finite or below 0 */
export function set_light_size(light: object, light_size: number): void;

export interface FitOptions {
    /** The component of the camera that sees the shadows. A directional light needs it. */
    readonly camera?: object;
    /** Entities that shadows fall on and that cast them. Without it, all of the app. */
    readonly receivers?: object | readonly object[];
}

export interface Fitted {
    /** Texels in a world unit, of the widest cascade; of a spot or a point light, at the farthest receiver. */
    readonly texels_per_unit: number;
    /** World units: a caster nearer than this over a receiver casts nothing on it. Across the light, edges move by as much at
     *  most. undefined: see bias_is_set. */
    readonly detachment: number | undefined;
    /** Texels from a receiver to the farthest texel that the filter compares. */
    readonly reach: number | undefined;
    /** The light's normalOffsetBias and shadowBias. */
    readonly normal_offset_bias: number;
    readonly shadow_bias: number;
    /** false: variance maps and PlayCanvas' own SHADOW_PCSS_32F have no bias that ends acne, so both biases stay yours. */
    readonly bias_is_set: boolean;
    /** By how much normalOffsetBias would have to be above 1, where PlayCanvas ends it. Above 0: surfaces have stripes. Make the
     *  map larger, shadowDistance shorter, or the world's units. */
    readonly lacks: number | undefined;
    /** Of each cascade of a directional light. */
    readonly cascades?: readonly { readonly texels_per_unit: number }[];
}

/** Sets normalOffsetBias and shadowBias of a light for its filter, PlayCanvas' own or one of this package. No receiver stripes
 *  itself then, whatever its tilt. Call it again when the light, the camera's field of view, the scene, map size or filter change.
 *  Clustered spot lights and point lights, as all are in WebGPU, need a first frame before, which gives each a tile of the atlas.
 *  @param light   the component of a directional, spot or point light
 *  @throws Error  another light, a directional one without a camera, a clustered one without a tile, no receivers, options that
 *                 do not fit, a map of too few texels for the filter */
export function fit_bias(light: object, options?: FitOptions): Fitted;
