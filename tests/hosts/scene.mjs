// SPDX-License-Identifier: MIT
//
// What the pages draw: pillars, a knot, a ball and a fence on a floor, under a directional light, a spot or a sun.

export const width = 480, height = 320, map_size = 512;

export function make_scene(THREE, light) {
    const scene = new THREE.Scene();
    scene.background = new THREE.Color(0x8899aa);
    const [z_near, z_far] = light.isSunLight ? [5, 25] : [0.1, 60];  // its two cascades share what the camera sees
    const camera = new THREE.PerspectiveCamera(40, width / height, z_near, z_far);
    camera.position.set(5, 4.5, 7);
    camera.lookAt(0, 0.6, 0);
    const add = (geometry, color, x, y, z) => {
        const mesh = new THREE.Mesh(geometry, new THREE.MeshStandardMaterial({ color }));
        mesh.position.set(x, y, z);
        mesh.castShadow = mesh.receiveShadow = true;
        scene.add(mesh);
        return mesh;
    };
    add(new THREE.BoxGeometry(0.5, 3, 0.5), 0xcc8866, -1.6, 1.5, -0.6);
    add(new THREE.TorusKnotGeometry(0.55, 0.17, 96, 16), 0x6688cc, 0.6, 1.3, 0.2);
    add(new THREE.SphereGeometry(0.5, 32, 16), 0x88bb66, 2.2, 0.5, 1.3);
    for (let i = 0; i < 7; ++i) add(new THREE.BoxGeometry(0.06, 1.2, 0.06), 0x999999, -2.5 + i * 0.35, 0.6, 2.2);
    const floor = add(new THREE.PlaneGeometry(14, 14), 0xdddddd, 0, 0, 0);
    floor.rotation.x = -Math.PI / 2;
    floor.castShadow = false;
    scene.add(new THREE.HemisphereLight(0xffffff, 0x666666, 0.9));
    light.position.set(-4, 6, -2.5);
    light.castShadow = true;
    light.shadow.mapSize.set(light.isSunLight ? map_size / 2 : map_size, map_size);  // two maps in one texture, or one
    light.shadow.bias = -0.002;
    light.shadow.normalBias = 0.03;
    scene.add(light);
    return { scene, camera, light };
}

export function directional(THREE) {
    const light = new THREE.DirectionalLight(0xffffff, 2.2);
    Object.assign(light.shadow.camera, { left: -6, right: 6, bottom: -6, top: 6, near: 1, far: 16 });
    return light;
}

/** Bytes of floats as text, to leave the page. */
export function base64(floats) {
    const bytes = new Uint8Array(floats.buffer, floats.byteOffset, floats.byteLength);
    let text = '';
    for (let i = 0; i < bytes.length; i += 32768) text += String.fromCharCode(...bytes.subarray(i, i + 32768));
    return btoa(text);
}
