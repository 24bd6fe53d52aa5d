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
    const { block, matrices } = values(of, { clip, ...light });
    const all = matrices.reduce((list, m) => [...list, ...m], []);
    const most = Math.max(difference(block, floats(test.block)), difference(Float32Array.from(all), floats(test.matrices)));
    const key = calls || 'none';
    counts[key] = (counts[key] ?? 0) + 1;
    worst[key] = Math.max(worst[key] ?? 0, most);
    if (block.byteLength === of.bytes && most <= (calls ? bound : 0)) continue;
    if (++failed < 5) console.log(`FAILED: ${line.slice(0, 160)}: ${most}`);
}
for (const key in counts) console.log(`${counts[key]} cases that call ${key}: at most ${worst[key]} off`);

// Errors come as the library words them, and leave it able to go on.
const spot = shadow('a', { kind: umbrage.spot_light, filter: umbrage.tent3, map_size: 64 }), clip = clips.opengl_clip_space;
const before = values(spot, { clip }).block.join();
for (const [light, message] of [
    [{ outer_angle_radians: 30 }, 'umbrage::make_spot_light: outer_angle_radians must be above 0 and below pi / 2; got 30. Is it in degrees?'],
    [{ direction: [0, 0, 0] }, 'umbrage::make_spot_light: direction must be'], [{ outer_angle: 1 }, 'umbrage: values: light must have no properties but'],
    [{ clip: clips.godot_clip_space }, 'umbrage: values: light.clip must have the direction of the shadow, forward; got reversed'],
    [{ clip: undefined }, 'umbrage: values: light.clip must be given'], [{ position: [0, 0] }, 'umbrage: values: light.position must be 3 numbers'],
    [{ position: [0, 0, NaN] }, 'umbrage: values: light must hold numbers'], [{ filter: { radius: 3 } }, 'umbrage: values: light.filter must have no properties but']])
    for (let i = 0; i < 300; ++i) {
        let got = 'no error';
        try { values(spot, { clip, ...light }); } catch (error) { got = error.message; }
        if (got.startsWith(message)) continue;
        console.log(`FAILED: ${JSON.stringify(light)}: ${got}`);
        ++failed;
        break;
    }
const pages = shadow('b', { kind: umbrage.adaptive_pages, filter: umbrage.tent3, map_size: 136 });
const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
const seen = { clip, scene: { low: [-1, -1, -1], high: [1, 1, 1] }, camera: { view: identity, projection: identity, z_near: 1, z_far: 2 },
    picture: [64, 64], points: [0, 0, 0, 1], normals: [0, 1, 0, 0] };
for (const [part, message] of [
    [{ points: [0, 0, 0] }, 'umbrage: values: light.points must be four floats each; got 3'], [{ normals: [] }, 'umbrage: values: light.normals must be as many'],
    [{ gutter: 5 }, 'umbrage::page_light: texels must be a power of two; got 126'], [{ gutter: 60 }, 'umbrage::page_light: gutter must be'], [{ target: 0 }, 'umbrage::page_cache: target must be'],
    [{ points: undefined }, 'umbrage: values: light.points must be given']]) {
    let got = 'no error';
    try { values(pages, { ...seen, ...part }); } catch (error) { got = error.message; }
    if (!got.startsWith(message)) ++failed, console.log(`FAILED: ${JSON.stringify(part)}: ${got}`);
}
if (values(spot, { clip }).block.join() !== before) ++failed, console.log('FAILED: other values after errors');
process.exitCode = failed || counts.none < 500 ? 1 : 0;
