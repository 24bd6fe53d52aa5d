// SPDX-License-Identifier: MIT
//
// Types of fit_shadow, which umbrage/three and umbrage/three/webgpu share.

interface Point { readonly x: number; readonly y: number; readonly z: number }

/** A box of the world, such as a Box3. */
export interface Box { readonly min: Point; readonly max: Point }

/** An object of three.js, such as a scene, a group or a mesh. */
export interface Part {
    traverse(use: (object: any) => void): void;
    readonly matrixWorld: object;
}

/** Objects or boxes, or several of them. */
export type Parts = Part | Box | readonly (Part | Box)[];

export interface Fit {
    /** What shadows fall on: of objects, the visible meshes that have receiveShadow. */
    readonly receivers: Parts;
    /** What casts them: of objects, the visible meshes that have castShadow. Without it, receivers. */
    readonly casters?: Parts;
    /** With a camera the map holds only the receivers that it sees: finer, but to be fitted again when the camera moves. */
    readonly camera?: object;
    /** The map of a DirectionalLight moves by whole texels and keeps its size while the camera turns, so that edges do not
     *  shimmer. A spot light keeps its cone. */
    readonly steady?: boolean;
    /** Its shadowMap.type is three.js' own filter in use. Without it, PCF. */
    readonly renderer?: { readonly shadowMap: { readonly type: number } };
    /** For a filter that is neither three.js' nor this package's: texels from a receiver to the farthest texel it compares. */
    readonly reach?: number;
}

export interface Fitted {
    /** Texels in a world unit; of a spot or a point light, at the farthest receiver. */
    readonly texels_per_unit: number;
    /** World units: a caster nearer than this over a receiver casts nothing on it, one at twice this its whole shadow.
     *  Across the light, edges move by as much at most. undefined: see bias_is_set. */
    readonly detachment: number | undefined;
    /** Texels from a receiver to the farthest texel that the filter compares. */
    readonly reach: number;
    /** The light's shadow.normalBias and shadow.bias. */
    readonly normal_bias: number;
    readonly bias: number;
    /** false: variance maps (VSM) have no bias that ends acne, so bias and normalBias stay yours. */
    readonly bias_is_set: boolean;
    /** Planes of the light's shadow camera. */
    readonly near: number;
    readonly far: number;
    /** Casters reach nearer to the light than its near plane, which is at least 1/1024 of the far one, and are cut there. */
    readonly casters_are_cut: boolean;
    /** Of a DirectionalLight with a camera: how many times finer the nearest of four cascades would be, and whether that
     *  pays: from 2 on, where a texel covers two rows or more of a picture of 1080. */
    readonly cascades?: { readonly finer: number; readonly pay: boolean };
}

/** Sets the box, the planes, normalBias and bias of a light's own shadow, for the filter in use: three.js' PCF or basic one,
 *  or one of this package. No receiver stripes itself then, whatever its tilt, and shadows lie as near as that allows. The
 *  light itself stays where it is. Call it again when the light, receivers, casters, map size, radius or filter change.
 *  @param light   a DirectionalLight, SpotLight, PointLight or SunLight
 *  @throws Error  another light, no receivers, options that do not fit, a map of too few texels for the filter */
export function fit_shadow(light: object, options: Fit): Fitted;
