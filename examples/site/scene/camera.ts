// SPDX-License-Identifier: MIT
//
// The visitor's camera. Angles are in degrees: azimuth 0 is +z, 90 is +x; elevation 90 is +y.
import { mat4, vec3 } from 'gl-matrix';

import type { Scene } from './mesh';
import type { State } from './state';

export interface Camera {
    view: mat4;
    projection: mat4;
    to_clip: mat4;
    position: vec3;
    z_near: number;
    z_far: number;
}

const radians = (degrees: number) => degrees * Math.PI / 180;

/** Unit vector at the given angles. */
export function direction_at(azimuth: number, elevation: number): [number, number, number] {
    const a = radians(azimuth), e = radians(elevation);
    return [Math.cos(e) * Math.sin(a), Math.sin(e), Math.cos(e) * Math.cos(a)];
}

export function make_camera(scene: Scene, state: State, aspect: number): Camera {
    const back = direction_at(state.yaw, state.pitch), distance = state.distance * scene.camera_distance;
    const position = vec3.scaleAndAdd(vec3.create(), scene.target as vec3, back, distance);
    const view = mat4.lookAt(mat4.create(), position, scene.target as vec3, direction_at(state.yaw, state.pitch + 90));
    const { low, high } = scene.box, corners = [0, 1, 2, 3, 4, 5, 6, 7].map(n => [0, 1, 2].map(axis => (n >> axis & 1 ? high : low)[axis]!));
    const deepest = Math.max(...corners.map(corner => corner.reduce((sum, c, axis) => sum - (c - position[axis]!) * back[axis]!, 0)));
    const z_near = 0.15 * distance, z_far = Math.max(deepest * 1.01, 2 * z_near);
    // a narrow window sees as much sideways as one of 3:2
    const vertical = radians(scene.view_degrees), wide = Math.max(1, 1.5 / aspect);
    const projection = mat4.perspective(mat4.create(), 2 * Math.atan(Math.tan(vertical / 2) * wide), aspect, z_near, z_far);
    return { view, projection, to_clip: mat4.multiply(mat4.create(), projection, view), position, z_near, z_far };
}
