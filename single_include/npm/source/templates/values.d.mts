// umbrage @version@, MIT License. Types of values.mjs.
import type { Language, ShadowOf } from './module/types.mjs';

export type Vector = readonly [number, number, number] | Float32Array | Float64Array | readonly number[];
/** 4 x 4, column by column, as WebGL, WebGPU and three.js have it. */
export type Matrix = Float32Array | Float64Array | readonly number[];
export interface Box { low: Vector; high: Vector }

/** Conventions of an API or engine. */
export interface ClipSpace {
    readonly hand: 'right' | 'left';
    readonly range: 'zero_to_one' | 'minus_one_to_one';
    readonly direction: 'forward' | 'reversed';
    /** Of the map's first row. */
    readonly origin: 'bottom' | 'top';
    /** Bits of the grid within a texel to which the rasterizer moves vertices. 4, if left out, is what APIs promise. */
    readonly subpixel_bits?: number;
}
@clip_spaces@

interface OfAll {
    /** Of the depth pass and the camera; its direction is the shadow's. */
    clip: ClipSpace;
    /** Where the frame's world begins: points that the shader is given are less that. */
    origin?: Vector;
    /** The filter's arguments by their names, in place of defaults. Contact hardening has others: `light_size`, which must be given
     *  (the light's radius in world units, or for suns the tangent of half the angle under which they are seen), and `min_radius`
     *  and `max_radius` in texels, 1 and 16. */
    filter?: Readonly<Record<string, number | readonly number[]>>;
}
export interface SpotLight extends OfAll {
    position?: Vector;
    /** The way that light travels, of any length. */
    direction?: Vector;
    up?: Vector;
    /** Half the cone's angle, at most 1.5. */
    outer_angle_radians?: number;
    /** Width / height of the map, 1 by default: makes texels square. */
    aspect?: number;
    z_near?: number;
    z_far?: number;
}
export interface DirectionalLight extends OfAll {
    direction?: Vector;
    up?: Vector;
    /** What the map holds whole. */
    receivers: Box;
    /** Left out or null: the near plane stands at the receivers, for depth passes that clamp depths. */
    casters?: Box | null;
    /** On every side, as a share of the receivers' diameter. */
    margin?: number;
    /** Texels are squares of the world, and stay where they are while the receivers move. */
    snap?: boolean;
}
export interface Cascades extends OfAll {
    direction?: Vector;
    up?: Vector;
    /** All casters and receivers. */
    scene: Box;
    /** Its matrices, and between which distances shadows are cast. */
    camera: { view: Matrix; projection: Matrix; z_near: number; z_far: number };
    /** How many: up to 4, or 5 to 8 of cascades_8. */
    cascades?: number;
    /** 0: uniform splits, 1: logarithmic ones. */
    lambda?: number;
    /** Distances in place of those: one more than cascades, which may then be left out. */
    splits?: readonly number[];
    /** Share of a cascade that the next one holds too. */
    overlap?: number;
    /** Width of the band in which the next cascade takes over. */
    blend_texels?: number;
}
/** Cascades that follow the view, in maps stretched along it: fewer texels for the same detail, but texels that move. */
export interface WarpedCascades extends OfAll {
    direction?: Vector;
    scene: Box;
    camera: Cascades['camera'];
    /** How many: up to 4. */
    cascades?: number;
    lambda?: number;
    splits?: readonly number[];
    /** Share of a cascade over which the next one takes over. */
    overlap?: number;
}
/** Pages of a virtual shadow map (adaptive shadow map) that the points need, up to 64. Each has a matrix. Pages are finer where
 *  a texel would cover more pixels than `target`. If 64 do not suffice, texels cover more. */
export interface AdaptivePages extends OfAll {
    direction?: Vector;
    up?: Vector;
    /** All casters and receivers. The root page holds it whole. */
    scene: Box;
    camera: Cascades['camera'];
    /** Size of the camera's picture, pixels. */
    picture: readonly [number, number];
    /** Points that the camera sees, or some of them. Four floats each, as RGBA32F is read back: x, y, z, and 0 for no point. */
    points: ArrayLike<number>;
    /** Normal of the surface at each point, on the camera's side and of length one. Four floats each; the last does not count. */
    normals: ArrayLike<number>;
    /** Texels around each page, a whole number: the filter's reach or more, 4 by default. The others of `map_size` are a power of two. */
    gutter?: number;
    /** Pixels that a texel may cover. */
    target?: number;
}
export interface PointLight extends OfAll {
    position?: Vector;
    z_near?: number;
    z_far?: number;
    /** Texels around each map, a whole number: the filter's reach or more. 2 by default, which is enough for `tent3`. */
    border?: number;
}
export interface DualParaboloidLight extends OfAll { position?: Vector; range?: number; border?: number }

export interface Values {
    /** The uniform block: its bytes are those of a buffer, its floats those of glUniform4fv. */
    block: Float32Array;
    /** For each map, what the function of `vertex_pass` takes: umbrage_vertex_<name>(to_clip, world, anchor). It keeps its
     *  digits far from the origin. */
    views: { to_clip: Float32Array, anchor: Float32Array }[];
    /** What the depth pass' target is cleared to: `cleared` of the shadow, but for moments with the arguments given here. */
    cleared: readonly number[];
    /** For each map: world, less the origin, to clip space, for vertex shaders of your own near the origin. Dual paraboloids
     *  bend lines, so they have none. */
    matrices: Float32Array[];
    /** Of dual paraboloids: radians that an edge of a mesh may span, seen from the light. Cut longer ones: each edge is drawn
     *  straight, within half a texel of its true arc. */
    edge_angle?: number;
}
/** A shadow's values for a light of its kind.
 *  @throws Error   as the C++ library: function, argument, condition, value */
export type ValuesOf = (shadow: ShadowOf<Language>,
    light: SpotLight | DirectionalLight | Cascades | WarpedCascades | AdaptivePages | PointLight | DualParaboloidLight) => Values;

/** Starts the WebAssembly, once. */
export function load_values(): Promise<ValuesOf>;
