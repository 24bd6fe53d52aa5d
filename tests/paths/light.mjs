// SPDX-License-Identifier: MIT
//
// A path's light, as a page has it: what shadow() and values() take.
import { camera, lights, picture, scene_box } from './scene.mjs';

const moved = (p, by) => p?.map((x, i) => x + by[i]);
const moved_box = (box, by) => ({ low: moved(box.low, by), high: moved(box.high, by) });

/** Of setups that C++ alone has: those whose texels are as large. */
const like = { tight_cascades: 'cascades', warped_light: 'directional_light' };

/** What shadow() takes, of a language's module. */
export const shadow_options = ({ shadow, encodings, snippets, ...all }, path) => ({
    kind: all[like[path.setup] ?? path.setup], filter: snippets[path.filter], map_size: path.map_size,
    direction: path.direction, map: path.map,
    ...path.encoding !== 'moments' && { encoding: encodings[path.encoding] } });

/** Where its light stands, relative to the origin; undefined of a sun. */
export const light_from = path => lights[path.setup].from && moved(lights[path.setup].from, path.shift);

/** What values() takes.
 *  @param seen   {points, normals} that the camera sees, for pages */
export function light_values(path, shadow, clip, seen) {
    const { given } = lights[path.setup], { origin, shift, setup } = path;
    const { view, projection, z_near, z_far } = camera(clip, origin);
    const far = origin.some(x => x);
    const border = Math.ceil(shadow.settings.filter.filter.reach) + 2, world = moved_box(scene_box, origin);
    return {
        clip, ...given, ...far && { origin },
        ...given.position && { position: moved(moved(given.position, shift), origin) },
        ...given.direction && !given.position && { direction: moved(given.direction, shift) },
        ...given.scene && { scene: world },
        ...given.receivers && { receivers: world, casters: world },
        ...given.scene && { camera: { view, projection, z_near, z_far } },
        ...setup === 'adaptive_pages' && { picture, gutter: border, normals: seen.normals,
            points: seen.points.map((x, i) => x + (i % 4 < 3 ? origin[i % 4] : 0)) },
        ...['point_light', 'tetrahedron_light', 'dual_paraboloid_light'].includes(setup) && { border },
        ...path.arguments && { filter: path.arguments },
    };
}
