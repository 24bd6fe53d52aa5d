// SPDX-License-Identifier: MIT
//
// Types of engine_bias, which umbrage/engines exports.

export type Engine = 'three' | 'godot' | 'unity_urp' | 'bevy' | 'filament';

/** What the map of any light has. */
export interface EngineMap {
    readonly engine: Engine;
    /** Texels of the map's side: of one cascade, of a spot light's map, of a point light's face. In Godot with 4 splits half of
     *  directional_shadow/size, and of a spot light the side of its part of the atlas. */
    readonly map_size: number;
    /** As the engine calls it; engines[engine].filters has all. Without it, the engine's default. */
    readonly filter?: string;
    /** three.js' light.shadow.radius, Godot's shadow_blur. Without it, 1. */
    readonly radius?: number;
    /** Largest coordinate of what the map shows, in world units from the origin. Without it, width, or range. */
    readonly extent?: number;
}

/** A directional light's shadow map, or one of its cascades. */
export interface DirectionalMap extends EngineMap {
    readonly light?: 'directional';
    /** World units that the map covers from side to side. Of cascades, the coarsest one's. */
    readonly width: number;
    /** World units between the map's near and far plane. */
    readonly range: number;
}

/** A point light's map, of Unity URP, Bevy or filament. */
export interface PointMap extends EngineMap {
    readonly light: 'point';
    /** World units that the light reaches. */
    readonly range: number;
    /** Of the farthest receiver, world units along the axis of its map. Without it, range. */
    readonly distance?: number;
    /** The map's near plane. Without it, the engine's own, in Unity 0.2. */
    readonly near?: number;
}

/** A spot light's map, of Godot, Unity URP, Bevy or filament. */
export interface SpotMap extends Omit<PointMap, 'light'> {
    readonly light: 'spot';
    /** Of the cone from side to side, degrees: Unity's outer angle, twice Godot's spot_angle and Bevy's outer_angle. */
    readonly angle: number;
}

export type AnyMap = DirectionalMap | SpotMap | PointMap;

export interface Judged {
    /** Numbers by the names of the engine's settings. */
    readonly settings: { readonly [name: string]: number };
    /** World units: a caster nearer than this over a surface may cast no shadow on it. */
    readonly detachment: number;
    /** Texels by which the settings miss what a plane needs at its worst tilt. 0: no plane stripes itself. */
    readonly lacking: number;
    /** Degrees up to which a face is free beside its edges too, where the filter sees another face. 90, but for an engine that
     *  moves casters by their slope: there a steeper face can be dark as far from its edges as the filter reaches. */
    readonly edges: number;
    /** Degrees between a plane's normal and the light, the least and the most that lack some. */
    readonly striped?: readonly [number, number];
}

export interface Bias extends Judged {
    /** World units of a texel. */
    readonly texel: number;
    /** Texels from a receiver to the farthest texel that the filter compares. */
    readonly reach: number;
    /** The engine's defaults, judged alike. */
    readonly defaults: Judged;
}

export type Vector = readonly [number, number, number];

/** A map's light, as an engine's formula sees it. */
export interface Light {
    readonly texel: number;
    readonly range: number;
    readonly reach: number;
    /** A square of texels, half of whose side is given, or a disc of points. */
    readonly filter: { readonly name: string; readonly half?: number; readonly points?: number; readonly radius?: number; readonly spiral?: boolean };
}

/** A spot light's map or a point light's, as a formula sees it. Its space is (along its rows, along its columns, to the light). */
export interface ConeLight extends Light {
    readonly kind: 'spot' | 'point';
    /** Texels of its side that it draws to, and world units of a texel at depth 1. */
    readonly size: number;
    readonly unit: number;
    /** Near plane times far plane over their distance: a depth z is stored as a constant less scale / z. */
    readonly scale: number;
    /** Of the largest angle between light and axis. */
    readonly tangent: number;
}

/** A triangle's plane: normal and to_light have length 1, cosine is theirs, slope that of its depth along the map's axes,
 *  the larger one. Under a spot or point light also the receiver's depth and its distance to the light. */
export interface Plane {
    readonly normal: Vector;
    readonly to_light: Vector;
    readonly cosine: number;
    readonly slope: number;
    readonly depth?: number;
    readonly distance?: number;
}

/** What an engine does with settings of a light. */
export interface LightFacts {
    /** Public files that the formula is from. */
    readonly sources: readonly string[];
    readonly formula: string;
    /** World vectors by which settings move a receiver, or a triangle that casts, before depths are compared. Under a spot or
     *  point light they are in the map's space. */
    moves(settings: { readonly [name: string]: number }, light: Light, plane: Plane): { readonly receiver?: Vector; readonly caster?: Vector };
    /** Of an engine that looks point lights up in a cube: what coordinates of its filters' points are multiplied by, beside the
     *  distance. */
    readonly cube?: { readonly scale: number };
}

export interface EngineFacts extends LightFacts {
    readonly title: string;
    /** Of the engine, or the commit of the files that were read. */
    readonly version: string;
    /** By name, the engine's default first. */
    readonly filters: { readonly [name: string]: object };
    /** What the engine calls the radius of a filter, if it has one. */
    readonly radius?: string;
    readonly settings: { readonly [name: string]: { readonly initial: number; readonly most?: number } };
    /** Step of the depths that its maps hold, as a share of the range. Without it, floats. */
    readonly stored?: number;
}

export const engines: { readonly [engine in Engine]: EngineFacts };

export type LightKind = 'directional' | 'spot' | 'point';

/** The lights of an engine that engine_bias has numbers for. */
export function lights_of(engine: Engine): LightKind[];

/** What an engine does with a light's settings, and the public files that say so. */
export function formula_of(engine: Engine, light: LightKind): LightFacts;

/** What the formulas see of a map: for pictures of them.
 *  @throws Error  as engine_bias */
export function light_of(options: DirectionalMap): Light;
export function light_of(options: SpotMap | PointMap): ConeLight;

/** Numbers for the engine's own bias settings: the smallest of four digits with which no plane stripes itself, at any tilt
 *  up to 89 degrees. An engine whose settings end before that gets their ends, and `lacking` says what is missing.
 *  @throws Error  another engine, a number or a filter that it does not take */
export function engine_bias(options: AnyMap): Bias;
