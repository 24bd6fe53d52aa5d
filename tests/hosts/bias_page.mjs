// SPDX-License-Identifier: MIT
//
// fit_bias of an engine on the quay, judged by rays, beside the engine's defaults and numbers that people copy. Each engine's
// page gives how to draw and what to try.
import { camera, height, lights, map_size, objects, width } from '/bias_scene.mjs';
import { cross, judge, minus, traced, unit } from '/fit_verdict.mjs';

/** Rays of pixels from above, as the camera sees. */
function ray(x, y) {
    const ahead = unit(minus(camera.to, camera.at)), right = unit(cross(ahead, [0, 1, 0])), up = cross(right, ahead);
    const high = Math.tan(camera.fov * Math.PI / 360);
    const u = (2 * (x + 0.5) / width - 1) * high * width / height, v = (1 - 2 * (y + 0.5) / height) * high;
    return [camera.at, unit(ahead.map((value, i) => value + u * right[i] + v * up[i]))];
}

/** Grays of a picture, with a display's curve. */
function picture(radiance) {
    const canvas = Object.assign(document.createElement('canvas'), { width, height }), context = canvas.getContext('2d');
    const image = context.createImageData(width, height);
    radiance.forEach((value, i) => image.data.set([...Array(3).fill(255 * Math.min(value, 1) ** (1 / 2.2)), 255], 4 * i));
    context.putImageData(image, 0, 0);
    return canvas.toDataURL();
}

/** A light's direction and distance, and its texel in world units at a point, of the cascade that the point is in. */
function light_of(kind, { texels, splits = [], tangent = 1 }) {
    const from = lights[kind], along = unit(from), ahead = unit(minus(camera.to, camera.at));
    const dot = (a, b) => a.reduce((sum, value, i) => sum + value * b[i], 0);
    if (kind === 'directional') {
        const cascade = p => Math.min(splits.filter(split => dot(minus(p, camera.at), ahead) > split).length, texels.length - 1);
        return { to_light: () => [along, Infinity], texel: p => texels[cascade(p)] };
    }
    const depth = q => (kind === 'spot' ? -dot(q, along) : Math.max(...q.map(Math.abs)));
    return { to_light: p => { const q = minus(from, p); return [unit(q), Math.hypot(...q)]; },
        texel: p => 2 * tangent * depth(minus(p, from)) / map_size };
}

/** Tries cases: {light, setting: fit, default or copied, ...of the page}.
 *  @param begin   makes what draws a case: {set(): what fit_bias returns; radiance(lit): floats of red from above, without shadows
 *                 if lit; texels(): of the map, in world units, with splits and tangent; shift(), of receivers along normals; end()} */
export async function try_all(begin, cases) {
    const pictures = {}, said = {}, wrong = [], striped = [], all = Object.values(objects).map(traced);
    for (const [name, { light, setting = 'fit', reach = 3 * Math.SQRT2, ...own }] of Object.entries(cases)) {
        const page = await begin(light, setting, own), fitted = await page.set();
        const shadowed = await page.radiance(false), bare = await page.radiance(true);
        pictures[name] = picture(shadowed);
        const count = judge({ width, height, scale: 1, objects: all, ray, ...light_of(light, page.texels()),
            visibility: (x, y) => (bare[y * width + x] > 1e-3 ? shadowed[y * width + x] / bare[y * width + x] : undefined),
            reach: fitted?.reach ?? reach, detachment: fitted?.detachment, shift: page.shift(),
            slip: fitted && !page.shift() ? fitted.detachment : 0, clear_angle: fitted?.clear_angle });
        const share = (part, all) => `${part} of ${all} (${(100 * part / all).toFixed(2)} %)`;
        said[name] = `dark: ${share(count.falsely_dark, count.lit)}; at steep edges: ${count.at_edges}, moved: ${count.moved};`
            + ` lit: ${share(count.falsely_lit, count.dark)}; up to ${count.detached.toFixed(2)} texels`
            + (fitted ? `; ${(fitted.cascades ?? [fitted]).map(map => map.texels_per_unit.toFixed(2)).join(', ')} texels per unit,`
                + ` reach ${fitted.reach.toFixed(2)}, detachment ${fitted.detachment.toFixed(4)} or ${(fitted.detachment * fitted.texels_per_unit).toFixed(2)} texels` : '');
        const few = count.lit < 1500 || count.dark < 100, beside = count.at_edges + count.moved > 0.01 * count.lit;
        const far = fitted && fitted.detachment * fitted.texels_per_unit > fitted.reach + 2.1;
        if (fitted && (count.falsely_dark || count.lost || few || beside || far)) wrong.push(`${name}, ${count.lost} lost: ${said[name]}`);
        if (setting === 'default' && count.falsely_dark > 0.01 * count.lit) striped.push(name);
        await page.end();
    }
    return { pictures, floats: {}, said: { ...said, wrong: wrong.join('\n') || 'none', striped: striped.join(' ') } };
}
