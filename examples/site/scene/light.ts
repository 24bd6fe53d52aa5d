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
    direction: State['depth'];
}

/** Maps of a kind share the memory of one map of the size that was chosen: four cascades have half its width. */
export function asked_of(state: State): Asked {
    const shares = state.light === 'spot_light' || state.light === 'directional_light' ? 1 : 2;
    return { kind: state.light, filter: state.filter, encoding: state.encoding, map_size: Number(state.size) / shares,
        direction: state.depth };
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

/** Properties of the light, as umbrage/values takes them. */
function properties(state: State, scene: Scene, camera: Camera): object {
    const { box } = scene, size = Math.hypot(...box.high.map((h, axis) => h - box.low[axis]!));
    const position = light_position(state, scene), direction = position.map((p, axis) => scene.target[axis]! - p);
    const to_light = direction_at(state.azimuth, state.elevation), up = direction_at(state.azimuth, state.elevation + 90);
    const of_sun = { direction: to_light.map(d => -d) };
    const of_cascades = { ...of_sun, scene: box, cascades: 4, lambda: 0.8, camera: { view: camera.view as Float32Array,
        projection: camera.projection as Float32Array, z_near: camera.z_near, z_far: camera.z_far } };
    switch (state.light) {
        case 'spot_light': return { position, direction, up, outer_angle_radians: 0.5, z_near: 0.05 * scene.camera_distance, z_far: 2 * size };
        case 'point_light': return { position, z_near: 0.02 * scene.camera_distance, z_far: 2 * size, border: 17 };
        case 'directional_light': return { ...of_sun, up, receivers: box, casters: box };
        case 'cascades': return { ...of_cascades, up };
        case 'warped_cascades': return of_cascades;
    }
}

/** Numbers of contact hardening: how many sixteenths of a texel a penumbra's radius grows by with each code of depth,
 *  smallest and largest radius. As make_penumbra_params of C++, for a light under whose half an angle of this tangent it
 *  is seen. */
function softness_of(to_clip: Float32Array, map_size: number, tangent: number): [number, number, number] {
    const row = (r: number) => Math.hypot(to_clip[r]!, to_clip[r + 4]!, to_clip[r + 8]!) / 2;
    const depth_a_world = row(2), texels_a_world = row(0) * map_size;
    return [Math.min(16 * tangent * texels_a_world / (65536 * depth_a_world), 255), 16, 255];
}

/** Block and matrices of a shadow for this light. */
export function values_of(values: ValuesOf, shadow: Shadow, state: State, scene: Scene, camera: Camera): Values {
    const light = { clip: clip_of(state), ...properties(state, scene, camera) } as Light;
    const argument = snippets[state.filter]?.filter?.arguments[0];
    if (argument?.name === 'radius') {
        const radius = 1 + 2 * state.softness;
        return values(shadow, { ...light, filter: { radius: argument.type === 'int' ? Math.round(radius) : radius } });
    }
    if (argument?.name !== 'softness') return values(shadow, light);
    const { matrices: [first] } = values(shadow, light);
    const softness = softness_of(first!, shadow.target.map_size[0], 0.12 * state.softness);
    return values(shadow, { ...light, filter: { softness } });
}
