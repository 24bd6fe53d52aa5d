// SPDX-License-Identifier: MIT
//
// The package's shadows against C++'s, character for character:  node shadows_test.mjs PACKAGE EXPECTED
import { createReadStream } from 'node:fs';
import { resolve } from 'node:path';
import { createInterface } from 'node:readline';
import { pathToFileURL } from 'node:url';

const [folder, expected] = process.argv.slice(2), umbrage = {};
for (const [language, entry] of Object.entries({ glsl: 'umbrage', hlsl: 'hlsl', msl: 'msl', wgsl: 'wgsl' }))
    umbrage[language] = await import(pathToFileURL(resolve(folder, `${entry}.mjs`)).href);

/** What a language makes of a shadow, or null where it refuses. */
function made(use) {
    try { return use(); } catch (error) {
        if (!error.message.startsWith('umbrage: ')) throw error;
        return null;
    }
}
function shadow_in(language, { kind, filter, encoding, direction, map, gather, linear, derivatives, debug, slots: [block, texture, sampler, set] }) {
    const { shadow, encodings, snippets, debug: debug_texts, ...all } = umbrage[language];
    return shadow('sun', { kind: all[kind], filter: snippets[filter], ...encoding && { encoding: encodings[encoding] },
        map_size: 256, direction, ...map && { map }, ...gather && { gather }, ...linear && { linear: snippets[linear] }, ...derivatives && { derivatives }, block, texture, sampler, set, ...debug && { debug: debug_texts } });
}

let tried = 0, refused = 0, different = 0;
function same(ours, theirs, what) {
    ++tried;
    refused += theirs === null;
    if (ours === theirs || ++different > 5) return;
    const a = (ours ?? 'refused').split('\n'), b = (theirs ?? 'refused').split('\n'), first = b.findIndex((line, i) => line !== a[i]);
    console.log(`differs: ${what}\n  line ${first + 1}: ${a[first]}\n   in C++: ${b[first]}`);
}
for await (const line of createInterface({ input: createReadStream(expected) })) {
    const test = JSON.parse(line);
    if (test.four) {
        for (const language in umbrage) same(four(umbrage[language], language), test.four[language], `four shadows in ${language}`);
        continue;
    }
    if (test.vertices) {
        for (const language in umbrage) {
            const pass = umbrage[language].text([shadow_in(language, test).vertex_pass(test)]);
            same(pass, test.vertices[language], `${test.kind}, ${test.direction}, ${test.range}, vertices in ${language}`);
        }
        continue;
    }
    const { kind, filter, encoding, direction, map, version, texts } = test, what = [kind, filter, encoding, direction, map, version, test.gather && 'gathered', test.linear, test.debug && 'debug'].join(' ');
    for (const language in umbrage) {
        const { source, text } = umbrage[language], all = items => language === 'glsl' ? source(version, items) : text(items);
        same(made(() => all([shadow_in(language, test)])), texts[language], `${what} in ${language}`);
        if (texts[language] === null) continue;
        const { cleared, depth_pass, target, bytes } = shadow_in(language, test), pass = { glsl: texts.pass, wgsl: texts.pass_wgsl }[language];
        if (pass) same(made(() => all([depth_pass])), pass, `${what} in ${language}, depth pass`);
        const size = target.layers > 1 ? test.size : target.grid.map((n, axis) => n * target.map_size[axis]);
        same(`${cleared} ${bytes} ${size} ${target.size} ${target.format}`,
            `${test.cleared} ${test.bytes} ${test.size} ${target.layers > 1 ? [256, 256] : test.size} ${test.format}`, `${what}, target`);
    }
}
function four({ cascades, depth_array, disc16, pcf_2x2, point_light, rg11, shadow, source, spot_light, tent3, text }, language) {
    const items = [shadow('packed', { kind: spot_light, filter: tent3, encoding: rg11, map_size: 256, block: 3, texture: 4 }),
        shadow('compared', { kind: spot_light, filter: tent3, map_size: 256, map: 'shadow', block: 5, texture: 6, sampler: 7 }),
        shadow('sun', { kind: cascades, filter: disc16, map_size: 256 }),
        shadow('cube', { kind: point_light, filter: pcf_2x2, map_size: 256, map: 'depth_array', block: 8, texture: 9 })];
    return language === 'glsl' ? source('450', items) : text(items);
}

// Bad input gets a clear answer, by name.
const { cascades, esm, pcf_2x2, rg11, shadow, spot_light, encodings } = umbrage.glsl, right = { kind: spot_light, filter: pcf_2x2, map_size: 64 };
for (const [options, message] of [
    [{ encoding: encodings.rg_11 }, 'encoding must be one of GLSL; got undefined. Is it of a name that no encoding has?'],
    [{ encoding: null }, 'encoding must be one of GLSL; got null'], [{ encoding: umbrage.wgsl.rg11 }, 'encoding must be one of GLSL; got rg11'],
    [{ encoding: rg11.reversed }, 'encoding must be rg11 itself, whose reversed depth comes of direction; got rg11.reversed'],
    [{ encoding: rg11.reversed, direction: 'reversed' }, 'encoding must be rg11 itself'], [{ filter: esm, encoding: rg11 }, 'encoding must be left out for a filter of moments'],
    [{ filter: esm, map: 'depth' }, 'map must be a color texture for a filter of moments; got depth'],
    [{ encoding: rg11, map: 'depth' }, 'encoding must be of one channel, as map is a depth texture; got rg11'],
    [{ encoding: rg11, map: 'shadow' }, 'encoding must be depth32f, depth24 or depth16, as map is a comparison sampler; got rg11'],
    [{ filter: umbrage.glsl.pcss16, map: 'shadow' }, 'filter must be one that needs no depths, as map is a comparison sampler; got pcss16'],
    [{ filter: null }, 'filter must be one that a shadow takes'], [{ map: null }, 'map must be one of texture_2d, depth, shadow for this kind; got null'],
    [{ kind: cascades, map: 5 }, 'map must be one of atlas, '], [{ map_size: 2 ** 40 }, 'map_size must be whole texels from 1 to 32768, or two of them; got 1099511627776'],
    [{ block: -1 }, 'block must be a whole number, 0 or above; got -1'], [{ texture: 1.5 }, 'texture must be a whole number, 0 or above; got 1.5'],
    [{ sampler: '2' }, 'sampler must be a whole number, 0 or above; got 2'], [{ set: NaN }, 'set must be a whole number, 0 or above; got NaN']])
    refused_by('shadow', `${Object.keys(options)}`, () => shadow('sun', { ...right, ...options }), message);
for (const [clip, message] of [
    [null, 'clip must be a clip space'], [{ direction: 'forward', range: '0_to_1' }, 'clip.range must be zero_to_one or minus_one_to_one; got 0_to_1'],
    [{ direction: 'FORWARD', range: 'zero_to_one' }, 'clip.direction must be forward or reversed; got FORWARD'],
    [{ direction: 'reversed', range: 'zero_to_one' }, 'clip must be a clip space whose depth is forward; got reversed']])
    refused_by('shadow', `vertex_pass, ${JSON.stringify(clip)}`, () => shadow('sun', right).vertex_pass(clip), message);
const two = (language, options, name = 'sun', more = []) => {
    const { text, source, shadow, spot_light, tent3, bind, hard } = umbrage[language], of = { kind: spot_light, filter: tent3, map_size: 64 };
    const items = [shadow('lamp', of), ...more.map(own => bind(hard, own)), shadow(name, { ...of, ...options })];
    return language === 'glsl' ? version => source(version, items) : () => text(items);
};
const slots = 'slots must be others for each block, texture and sampler of a text; got', name = "name must be another than a snippet's or shadow's of the text; got";
for (const [call, message] of [
    [() => two('glsl', {})('450'), `${slots} binding 0 of uniform blocks for lamp and sun`], [() => two('glsl', { block: 1 })('310 es'), `${slots} binding 1 of textures for lamp and sun`],
    [two('wgsl', {}), `${slots} binding 0 of group 0 for lamp and sun`], [two('wgsl', { block: 3 }), `${slots} binding 1 of group 0 for lamp and sun`],
    [two('hlsl', {}), `${slots} register b0 of space 0 for lamp and sun`], [two('wgsl', { block: 3, texture: 3 }), `${slots} binding 3 of group 0 for sun and sun`],
    [() => two('glsl', {}, 'lamp_block')('330'), `${name} lamp_block`], [two('msl', {}, 'hard', ['block']), `${name} hard_block`],
    [() => two('glsl', {}, 'lamp_terms')('330'), `${name} lamp_terms`]])
    refused_by('text', `${call}`, call, message);
two('glsl', {})('330'), two('glsl', {}, 'lamp_terms')('100'), two('msl', {})(), two('wgsl', { set: 1 })(), two('glsl', { block: 1, texture: 2 })('450');
function refused_by(where, what, call, message) {
    let got = 'taken without a word';
    try { call(); } catch (error) { got = error.message; }
    if (!got.startsWith(`umbrage: ${where}: ${message}`)) console.log(`${what}: ${got}`), ++different;
}

console.log(`${tried} tried, ${refused} refused by both, ${different} differ`);
process.exitCode = different || tried < 2000 || refused < 100 ? 1 : 0;
