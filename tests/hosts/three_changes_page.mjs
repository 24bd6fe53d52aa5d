// SPDX-License-Identifier: MIT
//
// three.js with WebGLRenderer: map size, radius, cameras, lights and the filter change after the first frame; a point light
// keeps three's own hard shadow beside a filter.
import * as THREE from 'three';
import { castano_dyadic5, disc16 } from '/package/umbrage.mjs';
import { install, uninstall } from '/package/npm/three.mjs';
import { tried_changes, tried_frames } from '/changes.mjs';
import { height, make_scene, width } from '/scene.mjs';

export const done = (async () => {
    const renderer = new THREE.WebGLRenderer({ antialias: false, preserveDrawingBuffer: true }), pictures = {};
    const draw = ({ scene, camera }) => {
        renderer.render(scene, camera);
        return renderer.domElement.toDataURL();
    };
    renderer.setSize(width, height);
    renderer.shadowMap.enabled = true;
    install(THREE, renderer, { filter: disc16 });
    const wrong = await tried_changes(THREE, draw);
    uninstall(THREE);

    install(THREE, renderer, { filter: disc16, frame: true });
    const bytes = new Uint8Array(width * height * 4), gl = renderer.getContext();
    const frames = await tried_frames(THREE, made => {
        draw(made);
        gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
        return Array.from(bytes.filter((_, i) => i % 4 === 1));
    }, () => {});
    uninstall(THREE);

    const lamp = () => make_scene(THREE, new THREE.PointLight(0xffffff, 200));
    renderer.shadowMap.type = THREE.BasicShadowMap;
    pictures.own_point = draw(lamp());
    install(THREE, renderer, { filter: castano_dyadic5 });
    pictures.point = draw(lamp());
    uninstall(THREE);
    return { pictures, floats: {}, said: { wrong, frames, point: pictures.point === pictures.own_point } };
})();
