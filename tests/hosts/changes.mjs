// SPDX-License-Identifier: MIT
//
// What users change after the first frame, in place: the next frame must be that of a page which had it from the start.
import { tried_turns } from '/frames.mjs';
import { directional, make_scene } from '/scene.mjs';

const spot = THREE => new THREE.SpotLight(0xffffff, 200, 0, 0.6);

/** A scene before and after: before(THREE) makes it, change(made, THREE) is what the user does. */
const changes = {
    map_size: { change: ({ light }) => light.shadow.mapSize.set(1024, 1024) },
    smaller_map_size: { change: ({ light }) => light.shadow.mapSize.set(256, 256) },
    spot_map_size: { light: spot, change: ({ light }) => light.shadow.mapSize.set(1024, 1024) },
    radius: { change: ({ light }) => { light.shadow.radius = 5; } },
    shadow_camera({ light }) {
        Object.assign(light.shadow.camera, { left: -4, right: 4, far: 20 });
        light.shadow.camera.updateProjectionMatrix();
    },
    view({ camera }) {
        camera.position.set(-3, 6, 6);
        camera.lookAt(0, 0, 0);
    },
    light_type(made, THREE, prepare) {
        const { position, shadow: { bias, normalBias } } = made.light, other = spot(THREE);
        made.scene.remove(made.light);
        made.light = other;
        other.position.copy(position);
        other.castShadow = true;
        Object.assign(other.shadow, { bias, normalBias });
        made.scene.add(other);
        prepare(other);
    },
    light_added(made, THREE, prepare) {
        const other = spot(THREE);
        other.position.set(5, 5, -1);
        other.castShadow = true;
        other.shadow.bias = -0.002;
        made.scene.add(other);
        prepare(other);
    },
    light_removed({ scene, light, other }) { scene.remove(other ?? light); },
};

/** Names of changes after which a page draws otherwise than one that had it from the start.
 *  @param draw      of (made): a picture
 *  @param prepare   gives a light its filter */
export async function tried_changes(THREE, draw, prepare = () => {}) {
    const wrong = [], resizes = Number(THREE.REVISION) >= 186;  // before, three.js' own maps stay as they were
    for (const [name, entry] of Object.entries(changes)) {
        if (name.endsWith('map_size') && !resizes) continue;
        const { light = directional, change = entry } = entry;
        const make = () => {
            const made = make_scene(THREE, light(THREE));
            made.light.shadow.radius = 3;
            prepare(made.light);
            return made;
        };
        const before = make(), from_start = make();
        const first = await draw(before);
        change(before, THREE, prepare);
        change(from_start, THREE, prepare);
        const then = await draw(before), wanted = await draw(from_start);
        if (then !== wanted) wrong.push(name);
        if (then === first) wrong.push(`${name} changes nothing`);
    }
    return wrong.join(', ') || 'none';
}

/** Frames of disc16 in three.js: see frames.mjs.
 *  @param pixels   draws a frame of (made): bytes */
export async function tried_frames(THREE, pixels, prepare) {
    const made = make_scene(THREE, directional(THREE));
    made.light.shadow.radius = 5;
    prepare(made.light);
    return tried_turns(() => pixels(made));
}
