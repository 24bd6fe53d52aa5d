// SPDX-License-Identifier: MIT
//
// umbrage/values against the C++ library of this machine, float by float: to the bit where no function of the C library
// is called, else within `bound` of the largest float of a column.  node values_test.mjs PACKAGE EXPECTED
import { createReadStream } from 'node:fs';
import { resolve } from 'node:path';
import { createInterface } from 'node:readline';
import { pathToFileURL } from 'node:url';

const [folder, expected] = process.argv.slice(2), load = name => import(pathToFileURL(resolve(folder, name)).href);
const { load_values, ...clips } = await load('values.mjs'), { shadow, snippets, encodings, ...umbrage } = await load('umbrage.mjs');
const values = await load_values(), bound = 2 ** -22;

const floats = words => new Float32Array(new Uint32Array(words).buffer);
/** The greatest difference, as a share of the greatest of the four floats that stand together. */
function difference(got, wanted) {
    let most = got.length === wanted.length ? 0 : Infinity;
    for (let i = 0; i < wanted.length; ++i) {
        const four = wanted.slice(i - i % 4, i - i % 4 + 4), size = Math.max(...four.map(Math.abs));
        if (!Object.is(got[i], wanted[i])) most = Math.max(most, Math.abs(got[i] - wanted[i]) / size || 2 ** -149);
    }
    return most;
}

const worst = {}, counts = {};
let failed = 0;
for await (const line of createInterface({ input: createReadStream(expected) })) {
    const test = JSON.parse(line), { kind, filter, encoding, calls, light } = test, clip = clips[test.clip];
    const of = shadow('sun', { kind: umbrage[kind], filter: snippets[filter], map_size: 256, direction: clip.direction,
        ...encoding && { encoding: encodings[encoding] } });
    const { block, matrices, views, edge_angle = 0 } = values(of, { clip, ...light });
    const all = list => Float32Array.from(list.flatMap(part => [...part]));
    const most = Math.max(difference(block, floats(test.block)), difference(all(matrices), floats(test.matrices)));
    // What is left of an offset that cancels is the last bits of doubles.
    const off = difference(all(views.flatMap(view => [view.to_clip, view.anchor])), floats(test.views));
    const key = calls || 'none';
    counts[key] = (counts[key] ?? 0) + 1;
    worst[key] = Math.max(worst[key] ?? 0, most);
    if (block.byteLength === of.bytes && Math.abs(edge_angle - test.edge_angle) <= 2 ** -52 && most <= (calls ? bound : 0) && off <= (calls ? bound : 2 ** -38)) continue;
    if (++failed < 5) console.log(`FAILED: ${line.slice(0, 160)}: ${most}, ${off}`);
}
for (const key in counts) console.log(`${counts[key]} cases that call ${key}: at most ${worst[key]} off`);

// The empty texel follows the filter's arguments, where a map holds moments.
for (const [filter, argument, wanted] of [['evsm4', { exponents: [42, 12] }, [2 ** 42, 2 ** 84, -(2 ** -12), 2 ** -24]], ['esm', { exponent: 60 }, [2 ** 60, 0, 0, 0]],
    ['evsm2', { exponent: 55 }, [2 ** 55, 2 ** 110, 0, 0]], ['evsm4', {}, [2 ** 40, 2 ** 80, -(2 ** -8), 2 ** -16]], ['tent3', {}, [1, 0, 0, 0]]]) {
    const { cleared } = values(shadow('a', { kind: umbrage.spot_light, filter: umbrage[filter], map_size: 64 }), { clip: clips.opengl_clip_space, filter: argument });
    if (cleared.join() !== wanted.join() && ++failed) console.log(`FAILED: ${filter} is cleared to ${cleared}, not ${wanted}`);
}

// Errors come as the library words them, and leave it able to go on.
const spot = shadow('a', { kind: umbrage.spot_light, filter: umbrage.tent3, map_size: 64 }), clip = clips.opengl_clip_space;
const before = values(spot, { clip }).block.join();
for (const [light, message] of [
    [{ outer_angle_radians: 30 }, 'umbrage::make_spot_light: outer_angle_radians must be above 0 and at most 1.5 (86 degrees); got 30. Is it in degrees?'],
    [{ direction: [0, 0, 0] }, 'umbrage::make_spot_light: direction must be'], [{ outer_angle: 1 }, 'umbrage: values: light must have no properties but'],
    [{ clip: clips.godot_clip_space }, 'umbrage: values: light.clip must have the direction of the shadow, forward; got reversed'],
    [{ clip: undefined }, 'umbrage: values: light.clip must be given'], [{ position: [0, 0] }, 'umbrage: values: light.position must be 3 numbers'],
    [{ position: [0, 0, NaN] }, 'umbrage: values: light.position must be 3 numbers; got [0, 0, NaN]'],
    [{ position: [1e300, 0, 0] }, 'umbrage::shadow: light and origin must be such that the map'], [{ filter: { radius: 3 } }, 'umbrage: values: light.filter must have no properties but']])
    for (let i = 0; i < 300; ++i) {
        let got = 'no error';
        try { values(spot, { clip, ...light }); } catch (error) { got = error.message; }
        if (got.startsWith(message)) continue;
        console.log(`FAILED: ${JSON.stringify(light)}: ${got}`);
        ++failed;
        break;
    }
const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1], box = { low: [-1, -1, -1], high: [1, 1, 1] };
const camera = { view: identity, projection: identity, z_near: 1, z_far: 2 };
const seen = { scene: box, camera, picture: [64, 64], points: [0, 0, 0, 1], normals: [0, 1, 0, 0] };
const with_filter = filter => shadow('c', { kind: umbrage.spot_light, filter, map_size: 64 }), must = 'umbrage: values: light.';
const size = 136, of = { pages: shadow('b', { kind: umbrage.adaptive_pages, filter: umbrage.tent3, map_size: size }), spot,
    cascades: shadow('b', { kind: umbrage.cascades, filter: umbrage.tent3, map_size: size }),
    sun: shadow('b', { kind: umbrage.directional_light, filter: umbrage.tent3, map_size: size }),
    ...Object.fromEntries(['point_light', 'tetrahedron_light', 'dual_paraboloid_light'].map(kind =>
        [kind, shadow('b', { kind: umbrage[kind], filter: umbrage.tent3, map_size: size })])),
    soft: shadow('b', { kind: umbrage.point_light, filter: umbrage.pcss16, map_size: size }),
    wide: shadow('b', { kind: umbrage.adaptive_pages, filter: umbrage.disc8, map_size: size }),
    disc: with_filter(umbrage.disc8), whole: with_filter(umbrage.box), evsm: with_filter(umbrage.evsm4) };
const ordinary = { pages: seen, wide: seen, cascades: { scene: box, camera }, sun: { receivers: box } };
for (const [kind, part, message] of [
    ['pages', { points: [0, 0, 0] }, `${must}points must be four floats each; got 3`], ['pages', { normals: [] }, `${must}normals must be as many`],
    ['pages', { gutter: 5 }, 'umbrage::page_light: texels must be a power of two'], ['pages', { gutter: 60 }, 'umbrage::page_light: gutter must be'],
    ['pages', { target: 0 }, 'umbrage::page_cache: target must be'], ['pages', { points: undefined }, `${must}points must be given`],
    ['pages', { points: null }, `${must}points must be an array of floats; got null`], ['pages', { normals: 'none' }, `${must}normals must be an array of floats; got none`],
    ['wide', { filter: { radius: 8 } }, 'umbrage::shadow: light.size.gutter must be 8 or more; got 4. The filter reaches 7.0'],
    ['pages', { gutter: 4.5 }, `${must}gutter must be a whole number below 2^31; got 4.5`],
    ['pages', { picture: [64.5, 64] }, `${must}picture must be 2 whole numbers below 2^31; got [64.5, 64]`],
    ['spot', { clip: { ...clip, hand: 'LEFT' } }, `${must}clip.hand must be left or right; got LEFT`],
    ['spot', { clip: { ...clip, range: '0..1' } }, `${must}clip.range must be zero_to_one or minus_one_to_one; got 0..1`],
    ['spot', { clip: { ...clip, direction: 'Forward' } }, `${must}clip.direction must be forward or reversed; got Forward`],
    ['spot', { clip: { ...clip, origin: undefined } }, `${must}clip.origin must be bottom or top; got undefined`],
    ['spot', { clip: null }, `${must}clip must be a clip space`], ['spot', { outer_angle_radians: null }, `${must}outer_angle_radians must be a number; got null`],
    ['spot', { outer_angle_radians: '0.5' }, `${must}outer_angle_radians must be a number; got 0.5`], ['spot', { aspect: true }, `${must}aspect must be a number; got true`],
    ['spot', { position: null }, `${must}position must be 3 numbers; got null`], ['spot', { filter: null }, `${must}filter must be an object; got null`],
    ['spot', { filter: 5 }, `${must}filter must be an object; got 5`], ['spot', undefined, 'umbrage: values: light must be an object; got undefined'],
    ['cascades', { camera: null }, `${must}camera must be an object of view, projection, z_near, z_far; got null`],
    ['cascades', { scene: null }, `${must}scene must be an object of low, high; got null`],
    ['cascades', { scene: { low: [0, 0, 0] } }, `${must}scene.high must be 3 numbers; got undefined`],
    ['cascades', { cascades: 2.5 }, `${must}cascades must be a whole number below 2^31; got 2.5`],
    ['cascades', { cascades: 3e9 }, `${must}cascades must be a whole number below 2^31; got 3000000000`],
    ['cascades', { cascades: 5 }, 'umbrage::values: cascades must be 1 to 4; got 5'],
    ['cascades', { cascades: 3, splits: [1, 1.5, 2] }, `${must}cascades must be left out, or one less than light.splits; got 3`],
    ['cascades', { splits: [1] }, `${must}splits must be 2 to 9 distances, or none; got [1]`], ['cascades', { splits: null }, `${must}splits must be 2 to 9 distances`],
    ['cascades', { splits: [1, '2'] }, `${must}splits must be 2 numbers; got [1, 2]`],
    ['sun', { snap: 1 }, `${must}snap must be true or false; got 1`], ['sun', { casters: undefined }, `${must}casters must be given`],
    ...['point_light', 'tetrahedron_light', 'dual_paraboloid_light'].map(kind => [kind, { border: 1 },
        'umbrage::shadow: light.border must be 2 or more; got 1. The filter reaches 2 texels to each side.']),
    ['soft', { border: 5, filter: { light_size: 0.1, max_radius: 6 } }, 'umbrage::shadow: light.border must be 6 or more; got 5. The filter reaches'],
    ['point_light', { border: 2.7 }, `${must}border must be a whole number below 2^31; got 2.7`],
    ['disc', { filter: { radius: [] } }, `${must}filter.radius must be a finite number; got []`],
    ['disc', { filter: { radius: [3, 4] } }, `${must}filter.radius must be a finite number; got [3, 4]`],
    ['disc', { filter: { radius: Infinity } }, `${must}filter.radius must be a finite number; got Infinity`],
    ['disc', { filter: { radius: null } }, `${must}filter.radius must be a finite number; got null`],
    ['whole', { filter: { radius: 2.7 } }, `${must}filter.radius must be a whole number below 2^31; got 2.7`],
    ['evsm', { filter: { exponents: [20] } }, `${must}filter.exponents must be 2 finite numbers; got [20]`]]) {
    let got = 'no error';
    try { values(of[kind], part ? { clip, ...ordinary[kind], ...part } : undefined); } catch (error) { got = error.message; }
    if (!got.startsWith(message)) ++failed, console.log(`FAILED: ${kind}, ${JSON.stringify(part)}: ${got}`);
}
values(of.cascades, { clip, ...ordinary.cascades, cascades: 2, splits: new Float32Array([1, 1.5, 2]) });
values(of.sun, { clip, ...ordinary.sun, casters: null });
values(of.soft, { clip, border: 6, filter: { light_size: 0.1, max_radius: 6 } });
for (const kind of ['point_light', 'tetrahedron_light', 'dual_paraboloid_light']) {
    const [left_out, two] = [{}, { border: 2 }].map(given => values(of[kind], { clip, ...given }).block.join());
    if (left_out !== two) ++failed, console.log(`FAILED: ${kind}: another border than 2 by default`);
}
for (const [what, got] of [[undefined, 'undefined'], [umbrage.bind(umbrage.hard, 'a'), 'hard'], [umbrage.hard, 'hard']]) {
    let said = 'no error';
    try { values(what, { clip }); } catch (error) { said = error.message; }
    if (said !== `umbrage: values: shadow must be one that shadow() made; got ${got}`) ++failed, console.log(`FAILED: ${said}`);
}
if (values(spot, { clip }).block.join() !== before) ++failed, console.log('FAILED: other values after errors');
process.exitCode = failed || counts.none < 500 ? 1 : 0;
