// SPDX-License-Identifier: MIT
//
// The package's texts against C++'s, character for character:  node texts_test.mjs FOLDER EXPECTED
import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const [folder, expected] = process.argv.slice(2);
const entries = { glsl: 'umbrage', hlsl: 'hlsl', msl: 'msl', wgsl: 'wgsl' }, umbrage = {};
for (const [language, entry] of Object.entries(entries))
    umbrage[language] = await import(pathToFileURL(resolve(folder, `${entry}.mjs`)).href);
const { snippets, bind, encodings, source } = umbrage.glsl;

const item = ({ snippets, bind }) => ({ what, name, map }) => map
    ? bind(snippets[what], name, { ...map, needs: map.needs.map(need => snippets[need]) })
    : snippets[what];

const encoding_of = (name, reversed) => reversed ? encodings[name].reversed : encodings[name];

function made({ language, version, items, encoding, reversed }) {
    try {
        if (encoding) return umbrage.glsl.text([bind(snippets.hard, 'a', encoding_of(encoding, reversed))]);
        const all = items.map(item(umbrage[language ?? 'glsl']));
        return version ? source(version, all, '#define A') : umbrage[language].text(all);
    } catch (error) {
        if (!error.message.startsWith('umbrage: ')) throw error;
        return null;
    }
}

const counts = {}, names = new Set(Object.keys(encodings));
let different = 0;
for (const line of readFileSync(expected, 'utf8').trimEnd().split('\n')) {
    const test = JSON.parse(line), kind = test.language ?? (test.encoding ? 'encodings' : 'versions'), text = made(test);
    if (test.encoding) {
        const { cleared } = encoding_of(test.encoding, test.reversed);
        const same = cleared.length === 4 && test.cleared.every(([value, most], i) => cleared[i] === value / most);
        if (!same) console.log(`encodings.${test.encoding}: cleared to ${cleared}`), ++different;
        for (const [language, pass] of Object.entries(test.passes)) {
            const { bind, encodings, text } = umbrage[language], { write } = encodings[test.encoding];
            if (text([bind(write, 'a', test.reversed ? { direction: 'reversed' } : {})]) === pass) continue;
            console.log(`encodings.${test.encoding}.write differs from the depth pass in ${language}`), ++different;
        }
        names.delete(test.encoding);
    }
    counts[kind] = (counts[kind] ?? 0) + 1;
    const tier = text !== null && test.exactness ? umbrage[test.language].exactness(test.items.map(item(umbrage[test.language]))) : test.exactness;
    if (tier !== test.exactness) console.log(`tier ${tier}, in C++ ${test.exactness}: ${JSON.stringify(test.items)}`), ++different;
    if (text === test.text) continue;
    if (++different > 3) continue;
    console.log(`differs: ${line.slice(0, 400)}`);
    const ours = (text ?? 'refused').split('\n'), theirs = (test.text ?? 'refused').split('\n');
    const first = ours.findIndex((l, i) => l !== theirs[i]);
    console.log(`  line ${first + 1}: ${ours[first]}\n   in C++: ${theirs[first]}`);
}

// One name for one thing, README says: of snippet, export, function and file; of encoding, key, writer and reader.
const named = (good, what) => { if (!good) console.log(`named otherwise than the rule says: ${what}`), ++different; };
for (const [language, all] of Object.entries(umbrage)) {
    for (const [name, snippet] of Object.entries(all.snippets)) {
        named(snippet.name === name && all[name] === snippet, `snippet ${name}`);
        named(all.text([snippet]).includes(` umbrage_${name}(`), `function ${name} in ${language}`);
        named(all.text([snippet]).includes(snippet.text), `text of ${name} in ${language}`);
    }
    for (const [name, encoding] of Object.entries(all.encodings)) named(all[name] === encoding, `encoding ${name}`);
    const kinds = 'adaptive_pages cascades cascades_8 directional_light dual_paraboloid_light point_light spot_light tetrahedron_light warped_cascades';
    const others = { glsl: ' source supports versions', wgsl: ' functions' }[language] ?? '';
    const wanted = `bind debug encodings exactness shadow snippets text ${kinds}${others}`.split(' ').sort().join(' ');
    const got = Object.keys(all).filter(name => !(name in all.snippets) && !(name in all.encodings)).sort().join(' ');
    named(got === wanted, `exports of ${language}: ${got}`);
}
for (const [name, { write, reversed, depth }] of Object.entries(encodings).filter(([name]) => !name.startsWith('depth'))) {
    named(write === reversed.write && write.needs.some(s => s === snippets[`write_${name}`] || s === snippets[`encode_${name}`]),
        `writer of ${name}`);
    const reader = depth.match(/^umbrage_decode_(\w+)\(value/)?.[1];  // one reader for a format and its repaired writer
    named(reader !== undefined && name.startsWith(reader) && snippets[`decode_${reader}`], `reader of ${name}`);
}

if (names.size) console.log(`in C++ no encoding is named ${[...names]}`), ++different;

// Bad input gets a clear answer, by name.
const wrong = 'umbrage: bind: map must be an object; got undefined. Is it of a name that no encoding has?';
try { bind(snippets.hard, 'a', encodings.typo), ++different, console.log('undefined taken for a map'); } catch ({ message }) {
    if (message !== wrong) console.log(message), ++different;
}
for (const bad of [() => bind(snippets.hard, 'a b'), () => bind(undefined, 'a'), () => bind(snippets.hard), () => bind(snippets.hard, 'a', null),
    () => bind(snippets.hard, 'a', { needs: [undefined] }), () => bind(snippets.hard, 'a', { needs: ['hard'] }), () => bind(snippets.hard, '_a'), () => bind(snippets.hard, 'a', { texture: '3d' }),
    () => bind(snippets.hard, 'a', { size: 3 }), () => bind(snippets.hard, 'a', { outside: 'lit' }), () => bind(snippets.hard, 'a', { gather: 1 }), () => source('200', [snippets.hard]),
    () => source('300 es', [undefined]), () => source('300 es', [umbrage.wgsl.hard]), () => umbrage.msl.bind(snippets.hard, 'a'),
    () => source('300 es', [encodings.rg11.write, encodings.r16.write])]) {
    let refused = false;
    try { bad(); } catch (error) { refused = error.message.startsWith('umbrage: '); }
    if (!refused) console.log(`taken without a word: ${bad}`), ++different;
}
const { hard, pcf_2x2, rg11, spot_light, supports, text } = umbrage.glsl, { wgsl } = umbrage;
const sun = wgsl.shadow('sun', { kind: wgsl.spot_light, filter: wgsl.tent3, map_size: 64 });
for (const [call, message] of [
    [() => text(pcf_2x2), 'text: items must be an array of snippets; got pcf_2x2'], [() => text(), 'text: items must be an array of snippets; got undefined'],
    [() => wgsl.text(bind(hard, 'a')), 'text: items must be an array of snippets; got hard'], [() => source('330', hard), 'text: items must be an array'],
    [() => text([hard, null]), 'text: items must be snippets of GLSL, bound or not; got null'],
    [() => text([spot_light]), 'text: items must be snippets of GLSL, bound or not; got spot_light of GLSL'],
    [() => source(undefined, [hard]), `source: version must be one of ${umbrage.glsl.versions.join(', ')}; got undefined`],
    [() => source('200', [hard]), 'source: version must be one of 100, '], [() => text([hard], '200'), 'text: version must be one of 100, '],
    [() => source('330', [hard], null), 'source: preamble must be a string; got null'], [() => source('330', [hard], 5), 'source: preamble must be a string; got 5'],
    [() => supports(hard, '200'), 'supports: version must be one of 100, '], [() => supports(hard, 300), 'supports: version must be one of 100, '],
    [() => supports(hard), 'supports: version must be one of 100, '], [() => supports(undefined, '330'), 'text: items must be snippets'],
    [() => bind(hard, 'a', []), 'bind: map must be an object; got []'], [() => bind(hard, 'a', rg11.write), 'bind: map must have no properties but'],
    [() => bind(spot_light, 'a'), 'bind: what must be a snippet of GLSL; got spot_light'], [() => bind(bind(hard, 'a'), 'b'), 'bind: what must be a snippet of GLSL; got hard'],
    [() => wgsl.functions([sun]), 'functions: items must be snippets, bound or not, as a shadow declares a block and a map beside its functions; got sun'],
    [() => wgsl.functions(), 'text: items must be an array']]) {
    let got = 'taken without a word';
    try { call(); } catch (error) { got = error.message; }
    if (!got.startsWith(`umbrage: ${message}`)) console.log(`${call}: ${got}`), ++different;
}
console.log(`${Object.entries(counts).map(([kind, n]) => `${kind} ${n}`).join(', ')}: ${different} differ`);
process.exitCode = different || Object.keys(counts).length < 2 ? 1 : 0;
