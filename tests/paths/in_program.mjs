// SPDX-License-Identifier: MIT
//
// Programs in C++ that draw paths: each frame is a file of lines, which job.hpp reads.
import { execFileSync } from 'node:child_process';
import { readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

import { light_from, light_values } from './light.mjs';
import { camera, picture, vertices } from './scene.mjs';

/** Position and normal of each point that the camera sees, six floats. */
const seen_floats = ({ points, normals }) => new Float32Array(points.flatMap((w, i) =>
    (i % 4 === 3 && w ? [...points.slice(i - 3, i), ...normals.slice(i - 3, i)] : [])));

/** What a program is told of a frame. */
function job_of(frame, { shadow, clip, seen, edge_angle }, at) {
    const { camera: range, scene, receivers, clip: _clip, points: _points, normals: _normals, ...light } =
        light_values(frame, shadow, clip, seen);
    const files = { casters: vertices(light_from(frame), edge_angle), receivers: vertices(), seen: seen_floats(seen) };
    const world = camera(clip, frame.origin);
    const { low, high } = scene ?? receivers ?? { low: [], high: [] };
    const lines = { ...light, along: light.direction, ...frame, low, high, picture, view: world.view,
        projection: world.projection, camera_near: world.z_near, camera_far: world.z_far, to_clip: camera({ ...clip, direction: 'forward' }).to_clip };
    for (const [name, floats] of Object.entries(files)) writeFileSync(`${at}.${name}`, floats), lines[name] = `${at}.${name}`;
    return Object.entries(lines).filter(([, value]) => value !== undefined)
        .map(([name, value]) => `${name} ${Array.isArray(value) ? value.join(' ') : value}\n`).join('');
}

/** Draws a path's frames by a program.
 *  @param told   of each frame: {shadow, clip, seen, edge_angle}
 *  @return       for each frame, visibility of each pixel from above, 255 is lit */
export function in_program([program, ...options], { frames }, told, folder) {
    const drawn = join(folder, 'drawn.bytes'), size = picture[0] * picture[1];
    rmSync(drawn, { force: true });
    const jobs = frames.map((frame, i) => {
        const at = join(folder, `job-${i}`);
        writeFileSync(at, job_of(frame, told[i], at));
        return at;
    });
    execFileSync(program, [...options, drawn, ...jobs], { encoding: 'utf8', stdio: 'pipe' });
    const bytes = readFileSync(drawn);
    return frames.map((_, i) => [...bytes.subarray(i * size, (i + 1) * size)]);
}
