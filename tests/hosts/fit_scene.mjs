// SPDX-License-Identifier: MIT
//
// A yard for three.js whose casters and receivers are far from easy: two-sided in the map, flat, thin, low over the floor,
// tilted. The same for both renderers; lights are placed as users place them.

export const width = 480, height = 320, map_size = 1024;

/** Meshes in a group of a scale, a camera, and the light of a kind in a group of its own. */
export function make_yard(THREE, kind, { scale = 1, parent = false, radius = 1, SunLight } = {}) {
    const scene = new THREE.Scene(), yard = new THREE.Group(), meshes = [];
    yard.scale.setScalar(scale);
    scene.add(yard);
    const add = (geometry, x, y, z, turn = [0, 0, 0]) => {
        const flat = geometry.index ? geometry.toNonIndexed() : geometry;
        flat.computeVertexNormals();
        const mesh = new THREE.Mesh(flat, new THREE.MeshLambertMaterial({ color: 0xffffff, shadowSide: THREE.DoubleSide }));
        mesh.position.set(x, y, z);
        mesh.rotation.set(...turn);
        mesh.castShadow = mesh.receiveShadow = true;
        yard.add(mesh);
        meshes.push(mesh);
    };
    add(new THREE.PlaneGeometry(30, 30), 0, 0, 0, [-Math.PI / 2, 0, 0]);
    add(new THREE.PlaneGeometry(6, 5), -6, 1.6, -4, [-Math.PI / 2 + 0.5, 0, 0]);
    for (let i = 0; i < 8; ++i) add(new THREE.BoxGeometry(0.06, 1.4, 0.06), -4 + i * 0.8, 0.7, 3.5);
    add(new THREE.BoxGeometry(6.4, 0.08, 0.04), -1.2, 1.2, 3.5);
    add(new THREE.PlaneGeometry(2.5, 2), 3, 1.2, 2.5, [-Math.PI / 2, 0, 0.3]);  // a sheet above the floor
    for (let i = 0; i < 4; ++i) add(new THREE.BoxGeometry(3, 0.3, 0.6), 4, 0.15 + 0.3 * i, -2 - 0.6 * i);
    add(new THREE.IcosahedronGeometry(1.1, 1), -1.5, 1.3, 0);
    add(new THREE.BoxGeometry(1, 3, 1), 1.3, 1.5, -3, [0, 0.4, 0]);
    const camera = new THREE.PerspectiveCamera(45, width / height, 0.1 * scale, 80 * scale);
    camera.position.set(3 * scale, 6 * scale, 11 * scale);
    camera.lookAt(0, 0.5 * scale, 0);
    const light = {
        directional: () => new THREE.DirectionalLight(0xffffff, 3),
        spot: () => new THREE.SpotLight(0xffffff, 3, 0, 0.75, 0, 0),
        point: () => new THREE.PointLight(0xffffff, 3, 0, 0),
        sun: () => new SunLight(0xffffff, 3),
    }[kind]();
    const high = { directional: [6, 8, 4], sun: [6, 8, 4], spot: [5, 12, 3], point: [2.2, 5, 0.8] }[kind].map(x => x * scale);
    if (parent) {  // a lamp on a cart: turned, scaled and away from the origin
        const cart = new THREE.Group();
        cart.position.set(2 * scale, 0, -scale);
        cart.rotation.set(0.2, 1, -0.3);
        cart.scale.setScalar(3);
        scene.add(cart);
        cart.updateMatrixWorld(true);
        cart.add(light, ...(light.target ? [light.target] : []));
        light.position.copy(cart.worldToLocal(new THREE.Vector3(...high)));
        light.target?.position.copy(cart.worldToLocal(new THREE.Vector3(0, 0, 0)));
    } else {
        light.position.set(...high);
        scene.add(light, ...(light.target ? [light.target] : []));
    }
    light.castShadow = true;
    light.shadow.mapSize.set(map_size, map_size);
    light.shadow.radius = radius;
    scene.updateMatrixWorld(true);
    return { scene, camera, light, meshes, scale };
}

/** World triangles of each mesh. */
export const triangles_of = ({ meshes }, THREE) => meshes.map(mesh => {
    const { position } = mesh.geometry.attributes, corner = new THREE.Vector3(), corners = [];
    for (let i = 0; i < position.count; ++i) corners.push(corner.fromBufferAttribute(position, i).applyMatrix4(mesh.matrixWorld).toArray());
    return Array.from({ length: corners.length / 3 }, (_, i) => corners.slice(3 * i, 3 * i + 3));
});
