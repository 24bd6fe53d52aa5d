// SPDX-License-Identifier: MIT
//
// three.js' own lights, fitted by one call: what it draws, judged by rays, beside three.js' defaults and numbers that people
// copy. Each renderer's page gives how to draw and what to try.
import { judge, minus, traced, unit } from '/fit_verdict.mjs';
import { height, make_yard, map_size, triangles_of, width } from '/fit_scene.mjs';

/** What users set today: a box or planes by hand, with a bias that is copied. */
const copied = {
    directional: ({ light, scale }) => Object.assign(light.shadow.camera, {
        left: -20 * scale, right: 20 * scale, bottom: -20 * scale, top: 20 * scale, near: 0.5 * scale, far: 100 * scale }),
    spot() {}, point() {}, sun() {},
};

/** The light's texel in world units at a point, as three.js has set its camera; a SunLight's largest. */
function texel_of({ light }, THREE) {
    const { shadow } = light, { camera } = shadow, at = new THREE.Vector3(), to = new THREE.Vector3();
    if (light.isDirectionalLight) return () => (camera.right - camera.left) / map_size;
    if (light.isSunLight) {
        const texels = Array.from({ length: shadow.getViewportCount() }, (_, i) => {
            const { left, right } = shadow.getCamera(i);
            return (right - left) / (shadow.getViewport(i).z * map_size);
        });
        return () => Math.max(...texels);
    }
    const from = at.setFromMatrixPosition(light.matrixWorld).toArray();
    const axis = light.isSpotLight ? unit(minus(to.setFromMatrixPosition(light.target.matrixWorld).toArray(), from)) : undefined;
    const half = light.isSpotLight ? Math.tan(light.angle * light.shadow.focus) : 1;
    return p => {
        const q = minus(p, from), depth = axis ? q.reduce((sum, x, i) => sum + x * axis[i], 0) : Math.max(...q.map(Math.abs));
        return 2 * depth * half / map_size;
    };
}

function to_light_of({ light }, THREE) {
    const from = new THREE.Vector3().setFromMatrixPosition(light.matrixWorld).toArray();
    if (light.isDirectionalLight || light.isSunLight) {
        const to = light.isSunLight ? [0, 0, 0] : new THREE.Vector3().setFromMatrixPosition(light.target.matrixWorld).toArray();
        const along = unit(minus(from, to));
        return () => [along, Infinity];
    }
    return p => { const q = minus(from, p); return [unit(q), Math.hypot(...q)]; };
}

/** Rays of pixels from above, as the camera sees. */
function rays(camera, THREE) {
    const from = new THREE.Vector3().setFromMatrixPosition(camera.matrixWorld).toArray(), half = Math.tan(camera.fov * Math.PI / 360);
    return (x, y) => [from, new THREE.Vector3((2 * (x + 0.5) / width - 1) * half * camera.aspect, (1 - 2 * (y + 0.5) / height) * half, -1)
        .transformDirection(camera.matrixWorld).toArray()];
}

/** Grays of a picture, with a display's curve. */
function picture(radiance) {
    const canvas = Object.assign(document.createElement('canvas'), { width, height }), context = canvas.getContext('2d');
    const image = context.createImageData(width, height);
    radiance.forEach((value, i) => image.data.set([...Array(3).fill(255 * Math.min(value, 1) ** (1 / 2.2)), 255], 4 * i));
    context.putImageData(image, 0, 0);
    return canvas.toDataURL();
}

/** Cases of a SunLight.
 *  @param reach   texels, of three.js' own filter */
export function sun_cases(SunLight, reach) {
    const sun = { light: 'sun', camera: true, yard: { SunLight } };
    return { ...Object.fromEntries(['fit', 'default', 'copied'].map(setting => [`sun.${setting}`, { ...sun, setting, reach }])),
        'sun.castano': { ...sun, filter: 'castano_dyadic5' } };
}

/** Tries cases: {light, setting: fit, default or copied, options of fit_shadow, reach, yard, install, ...of the page}.
 *  @param begin   makes what draws a case: {radiance(): floats of red from above, renderer, end()} */
export async function try_all(THREE, fit_shadow, begin, cases) {
    const pictures = {}, said = {}, wrong = [], striped = [];
    for (const [name, { light, setting = 'fit', options = {}, yard: make = {}, camera = false, reach = 0, ...own }] of Object.entries(cases)) {
        const yard = make_yard(THREE, light, make), { scene } = yard, { shadow } = yard.light, { scale } = yard;
        const page = await begin(yard, own);
        let fitted;
        if (setting === 'fit')
            fitted = fit_shadow(yard.light, { receivers: scene, renderer: page.renderer, ...options, ...(camera && { camera: yard.camera }) });
        if (setting === 'copied') {
            copied[light](yard);
            Object.assign(shadow, { bias: -0.0001, normalBias: 0.03 * scale });
            shadow.camera.updateProjectionMatrix();
        }
        const shadowed = await page.radiance();
        pictures[name] = picture(shadowed);
        shadow.intensity = 0;
        const bare = await page.radiance();
        const count = judge({ width, height, scale, objects: triangles_of(yard, THREE).map(traced), ray: rays(yard.camera, THREE),
            visibility: (x, y) => (bare[y * width + x] > 1e-3 ? shadowed[y * width + x] / bare[y * width + x] : undefined),
            to_light: to_light_of(yard, THREE), texel: texel_of(yard, THREE), reach: fitted?.reach ?? reach, detachment: fitted?.detachment,
            shift: shadow.normalBias });
        const share = (part, all) => `${part} of ${all} (${(100 * part / all).toFixed(2)} %)`;
        said[name] = `dark: ${share(count.falsely_dark, count.lit)}; lit: ${share(count.falsely_lit, count.dark)};`
            + ` up to ${count.detached.toFixed(2)} texels`
            + (fitted ? `; ${fitted.texels_per_unit.toFixed(2)} texels per unit, reach ${fitted.reach.toFixed(2)},`
                + ` detachment ${fitted.detachment.toFixed(4)} or ${(fitted.detachment * fitted.texels_per_unit).toFixed(2)} texels` : '');
        const few = count.lit < 1500 || count.dark < 100;
        const far = fitted && fitted.detachment * fitted.texels_per_unit > fitted.reach + 2;
        if (fitted && (count.falsely_dark || count.lost || few || far)) wrong.push(`${name}, ${count.lost} lost: ${said[name]}`);
        if (setting === 'default' && count.falsely_dark > 0.01 * count.lit) striped.push(name);
        page.end();
    }
    return { pictures, floats: {}, said: { ...said, wrong: wrong.join('\n') || 'none', striped: striped.join(' ') } };
}
