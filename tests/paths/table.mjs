// SPDX-License-Identifier: MIT
//
// The paths of paths.txt: what each page or program draws, frame by frame.
import { readFileSync } from 'node:fs';

const sizes = { spot_light: 1024, directional_light: 1024, cascades: 512, tight_cascades: 512, warped_light: 1024,
    cascades_8: 512, warped_cascades: 512, adaptive_pages: 72, point_light: 512, tetrahedron_light: 1024, dual_paraboloid_light: 1024 };
const far = [650_000, 120, -3_000];

/** All paths: {name, api, in_sample, frames: [what a page is told of each frame]}. */
export function read_paths(file) {
    const lines = readFileSync(file, 'utf8').split('\n').filter(line => line && !line.startsWith('#'));
    return lines.flatMap(line => {
        const [setup, filter, encoding, map, direction, change, ...apis] = line.split(/ +/), map_size = sizes[setup];
        const last = { setup, filter, encoding, map, direction, map_size, origin: change === 'origin' ? far : [0, 0, 0], shift: [0, 0, 0] };
        const frames = {
            '-': [last], origin: [last], resized: [{ ...last, map_size: map_size / 2 }, last],
            moved: [last, { ...last, shift: [1.2, 0.3, -0.9] }], filtered: [last, { ...last, filter: 'tent7' }],
        }[change];
        if (!frames) throw new Error(`paths.txt: no path is with ${change}`);
        return apis.map(text => {
            const api = text.replace('*', '');
            const name = [api, setup, filter, encoding, map, direction, ...change === '-' ? [] : [change]].join(' ');
            return { name, api, in_sample: text.endsWith('*'), frames };
        });
    });
}

/** Some numbers from 0 to 1, of a seed. */
export function* dice(seed) {
    for (let state = seed; ;) yield (state = state * 48271 % 2147483647) / 2147483647;
}
