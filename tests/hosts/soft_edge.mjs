// SPDX-License-Identifier: MIT
//
// The penumbra of a straight edge two units over a floor, under lights with a size in the world: its width as drawn,
// against rays to all parts of the light. A camera between both looks down at z from -1.5 to 1.5, the sheet is where z < 0.
import { height, width } from '/fit_scene.mjs';

export const edge_height = 2, half = 1.5, light_at = [0.6, 10, 0.4];

function make(THREE, { light: kind, far }) {
    const scene = new THREE.Scene(), camera = new THREE.OrthographicCamera(-half * width / height, half * width / height, half, -half, 0.1, 3);
    camera.position.set(0, 1.5, 0);  // under the sheet
    camera.up.set(0, 0, -1);
    camera.lookAt(0, 0, 0);
    const material = new THREE.MeshLambertMaterial({ color: 0xffffff, shadowSide: THREE.DoubleSide });
    const floor = new THREE.Mesh(new THREE.PlaneGeometry(12, 12), material), sheet = new THREE.Mesh(new THREE.BoxGeometry(12, 0.01, 6), material);
    floor.rotation.x = -Math.PI / 2;
    floor.receiveShadow = sheet.castShadow = true;
    sheet.position.set(0, edge_height + 0.005, -3);  // its lower edge is at z = 0
    const light = kind === 'spot' ? new THREE.SpotLight(0xffffff, 3, 0, 0.5, 0, 0) : new THREE.DirectionalLight(0xffffff, 3);
    light.position.set(...light_at);
    light.castShadow = true;
    light.shadow.mapSize.set(1024, 1024);
    light.shadow.normalBias = 0.05;
    if (far) light.shadow.camera.far = far;
    light.shadow.camera.updateProjectionMatrix();
    scene.add(floor, sheet, light, light.target);
    return { scene, camera, light };
}

/** Between 10 and 90 % of the light, along z. */
function width_of(profile) {
    const at = share => {
        const i = profile.findIndex(({ light }) => light >= share), [a, b] = [profile[i - 1], profile[i]];
        return a.z + (b.z - a.z) * (share - a.light) / (b.light - a.light);
    };
    return at(0.9) - at(0.1);
}

/** Visible parts of a round light of a size at light_at, by rays past the edge. */
function traced(size, spot) {
    const [x, y, z] = light_at, distance = Math.hypot(x, y, z), profile = [];
    const reach = spot ? size : size * distance;  // a directional light's disc as if it were there
    for (let i = 0; i < 400; ++i) {
        const at = (i / 400 - 0.5) * 2 * half;
        let seen = 0, tried = 0;
        for (let u = -20; u <= 20; ++u)
            for (let v = -20; v <= 20; ++v) {
                if (u * u + v * v > 400) continue;
                // a disc across the light's direction: along x, and along the rest
                const up = v / 20 * reach, to = spot ? [y - up * z / distance, z - at + up * y / distance]
                    : [y - up * z / distance, z + up * y / distance];
                ++tried, seen += at + to[1] / to[0] * edge_height > 0;
            }
        profile.push({ z: at, light: seen / tried });
    }
    return width_of(profile);
}

/** How wide a penumbra is for how wide it should be, from the share of light of each row of a picture. */
export function softened(rows, size, spot = false) {
    const profile = rows.map((light, row) => ({ z: ((row + 0.5) / rows.length - 0.5) * 2 * half, light }));
    if (rows[0] > rows.at(-1)) profile.reverse().forEach(part => { part.z = -part.z; });  // from below
    const [drawn, exact] = [width_of(profile), traced(size, spot)];
    return { words: `${drawn.toFixed(4)} for ${exact.toFixed(4)}`, good: Math.abs(drawn / exact - 1) < 0.1 };
}

/** Mean of each row. */
export const rows_of = (value, columns = width) => Array.from({ length: height }, (_, row) => {
    let sum = 0;
    for (let x = 0; x < columns; ++x) sum += value(row * columns + x);
    return sum / columns;
});

/** Widths of cases in words, and whether all are within 10 % of the traced ones.
 *  @param begin             as of try_all
 *  @param set_light_size    of the addon */
export async function try_softness(THREE, set_light_size, begin) {
    const found = {}, wrong = [];
    for (const [name, { size, ...own }] of Object.entries({
        'default camera': { size: 0.05 }, 'far 50': { size: 0.05, far: 50 }, 'far 12': { size: 0.05, far: 12 }, smaller: { size: 0.03 },
        spot: { size: 0.4, light: 'spot' }, 'spot, far 50': { size: 0.4, light: 'spot', far: 50 } })) {
        const made = make(THREE, own), page = await begin(made, { filter: 'pcss16', arguments: { softness: [0.0625, 0.0625, 16, 320] } });
        set_light_size(made.light, size);
        const shadowed = await page.radiance();
        made.light.shadow.intensity = 0;
        const bare = await page.radiance();
        page.end();
        const { words, good } = softened(rows_of(i => shadowed[i] / bare[i]), size, own.light === 'spot');
        found[name] = words;
        if (!good) wrong.push(`${name}: ${words}`);
    }
    return { soft: JSON.stringify(found), soft_wrong: wrong.join('; ') || 'none' };
}
