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
    /** Discs, and what searches by them, rotate from frame to frame, for temporal antialiasing (TAA): each pixel has all 16
     *  rotations in 16 frames. In materials that are made later, and in those of a scene that is given: StandardMaterial, PBRMaterial
     *  and others that take plugins. */
    readonly frame?: boolean;
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
 *  Texels must be squares of the world. For others pass arguments: { softness: [x, y, min, max] }, with x and y in the ratio
 *  of the texels for each unit of the world.
 *  @param generator    a ShadowGenerator or CascadedShadowGenerator
 *  @param light_size   tangent of half the angle under which the light is seen: 0.00465 for the sun
 *  @throws Error       a generator of another light, or a size that is not finite or below 0 */
export function set_light_size(generator: object, light_size: number): void;

export interface FitOptions {
    /** Meshes that shadows fall on. Without it, those of the scene that have receiveShadows. */
    readonly receivers?: readonly { getBoundingInfo(): object }[];
    /** The map of a directional light moves by whole texels, so that edges do not shimmer. A spot light keeps its cone. */
    readonly steady?: boolean;
}

export interface Fitted {
    /** Texels in a world unit, of the widest cascade; of a spot or a point light, at the farthest receiver. */
    readonly texels_per_unit: number;
    /** World units by which casters move away from the light at most: a caster nearer than this over a receiver may cast
     *  nothing on it. Edges of shadows move by as much at most. undefined: see bias_is_set. */
    readonly detachment: number | undefined;
    /** Radians between normal and light. Steeper faces may be dark along a hard edge to a face that the light meets less
     *  steeply, in a strip as wide as reach at most. A larger bias narrows it, and detaches by as much. */
    readonly clear_angle: number | undefined;
    /** Texels from a receiver to the farthest texel that the filter compares. */
    readonly reach: number | undefined;
    /** The generator's bias and normalBias. */
    readonly bias: number;
    readonly normal_bias: number;
    /** false: exponential maps and Babylon.js' own contact hardening have no bias that ends acne, so both biases stay yours. */
    readonly bias_is_set: boolean;
    /** The light's shadowMinZ and shadowMaxZ; without cascades. */
    readonly near?: number;
    readonly far?: number;
    /** Casters reach nearer to a spot or point light than its near plane, at least 1/1024 of the far one, and are cut there. */
    readonly casters_are_cut?: boolean;
    /** Of each cascade. */
    readonly cascades?: readonly { readonly texels_per_unit: number }[];
}

/** Sets bias and normalBias of a shadow generator for its filter, Babylon.js' own or one of this package, and the box and the
 *  planes of its light. Planes are free of stripes then, whatever their tilt; for edges of solids see clear_angle. Call it again
 *  when the light, receivers, casters, map size or filter change. With cascades Babylon.js sets the box: the biases follow it
 *  from frame to frame, after a first frame was drawn.
 *  @param generator   a ShadowGenerator or CascadedShadowGenerator of a directional, spot or point light
 *  @throws Error      another light, no receivers, cascades that were not drawn, options that do not fit, a map of too few
 *                     texels for the filter */
export function fit_bias(generator: object, options?: FitOptions): Fitted;
