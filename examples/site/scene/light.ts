// SPDX-License-Identifier: MIT
//
// The light of a state: the shadow that umbrage makes of it, its values, and where it shines from.
import { snippets, type Shadow } from 'umbrage';
import { opengl_clip_space, type Values, type ValuesOf } from 'umbrage/values';

import { direction_at, type Camera } from './camera';
import type { Scene } from './mesh';
import type { State } from './state';

/** Options of umbrage's shadow(), for any language: what to look up by name. */
export interface Asked {
    kind: State['light'];
    filter: State['filter'];
    encoding: State['encoding'];
    map_size: number;
    /** Texels around each page; 0 for other maps. */
    gutter: number;
    direction: State['depth'];
}

/** Argument of the filter that the size of the light sets, if it has one. */
export const argument_of = ({ filter }: State) => snippets[filter].filter?.arguments[0];

/** Maps of a kind share the memory of one map of the size that was chosen: four cascades have half its width. Pages have an
 *  eighth of it, and a gutter that holds all that the filter reads around them. */
export function asked_of(state: State): Asked {
    const shares = { spot_light: 1, directional_light: 1, cascades: 2, warped_cascades: 2, adaptive_pages: 8, point_light: 2 };
    const own = Number(state.size) / shares[state.light], widest = argument_of(state)?.name === 'softness' ? 17 : 8;
    const gutter = state.light === 'adaptive_pages' ? Math.min(widest, own / 2) : 0;
    return { kind: state.light, filter: state.filter, encoding: state.encoding, map_size: own + 2 * gutter, gutter, direction: state.depth };
}

/** Of the depth passes; the picture's camera is always forward. */
export const clip_of = (state: State) => ({ ...opengl_clip_space, direction: state.depth });

/** Where a spot light or a point light stands; of a sun, the direction to it. */
export function light_position(state: State, scene: Scene): [number, number, number] {
    const to_light = direction_at(state.azimuth, state.elevation);
    if (state.light !== 'spot_light' && state.light !== 'point_light') return to_light;
    const reach = scene.camera_distance * (state.light === 'spot_light' ? 1.1 : 0.45);
    return scene.target.map((t, axis) => t + reach * to_light[axis]!) as [number, number, number];
}

type Light = Parameters<ValuesOf>[1];

/** Pixels that the camera sees, as umbrage/values takes them for pages: four floats each. */
export interface Seen {
    picture: readonly [number, number];
    points: Float32Array;
    normals: Float32Array;
}

/** Properties of the light, as umbrage/values takes them. */
function properties(state: State, scene: Scene, camera: Camera, seen: Seen | undefined): object {
    const { box } = scene, size = Math.hypot(...box.high.map((h, axis) => h - box.low[axis]!));
    const position = light_position(state, scene), direction = position.map((p, axis) => scene.target[axis]! - p);
    const to_light = direction_at(state.azimuth, state.elevation), up = direction_at(state.azimuth, state.elevation + 90);
    const of_sun = { direction: to_light.map(d => -d) };
    const of_view = { ...of_sun, scene: box, camera: { view: camera.view as Float32Array,
        projection: camera.projection as Float32Array, z_near: camera.z_near, z_far: camera.z_far } };
    const of_cascades = { ...of_view, cascades: 4, lambda: 0.8 };
    switch (state.light) {
        case 'spot_light': return { position, direction, up, outer_angle_radians: 0.5, z_near: 0.05 * scene.camera_distance, z_far: 2 * size };
        case 'point_light': return { position, z_near: 0.02 * scene.camera_distance, z_far: 2 * size, border: 17 };
        case 'directional_light': return { ...of_sun, up, receivers: box, casters: box };
        case 'cascades': return { ...of_cascades, up };
        case 'warped_cascades': return of_cascades;
        case 'adaptive_pages': return { ...of_view, ...seen, up, gutter: asked_of(state).gutter };
    }
}

/** Size of the light for contact hardening: tangent of half the angle under which a sun is seen, or radius of a lamp. */
const light_size_of = (state: State, scene: Scene) =>
    Math.max(state.softness, 0.01) * (state.light === 'spot_light' || state.light === 'point_light' ? 0.04 * scene.camera_distance : 0.12);

/** Block and matrices of a shadow for this light; pages need what is seen. */
export function values_of(values: ValuesOf, shadow: Shadow, state: State, scene: Scene, camera: Camera, seen?: Seen): Values {
    const light = { clip: clip_of(state), ...properties(state, scene, camera, seen) } as Light, argument = argument_of(state);
    if (argument?.name === 'radius') {
        const radius = 1 + 2 * state.softness;
        return values(shadow, { ...light, filter: { radius: argument.type === 'int' ? Math.round(radius) : radius } });
    }
    if (argument?.name !== 'softness') return values(shadow, light);
    return values(shadow, { ...light, filter: { light_size: light_size_of(state, scene) } });
}
