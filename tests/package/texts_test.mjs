// SPDX-License-Identifier: MIT
//
// The package's texts against C++'s, character for character:  node texts_test.mjs MODULE EXPECTED
import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const [module_path, expected] = process.argv.slice(2);
const umbrage = await import(pathToFileURL(resolve(module_path)).href);
const { snippets, bind, encodings, source } = umbrage;

const item = ({ what, name, map }) => map
    ? bind(snippets[what], name, { ...map, needs: map.needs.map(need => snippets[need]) })
    : snippets[what];

const encoding_of = (name, reversed) => reversed ? encodings[name].reversed : encodings[name];

function made({ language, version, items, encoding, reversed }) {
    try {
        if (encoding) return umbrage.glsl.text([bind(snippets.hard, 'a', encoding_of(encoding, reversed))]);
        return version ? source(version, items.map(item), '#define A') : umbrage[language].text(items.map(item));
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
        const { writer, writes, cleared } = encoding_of(test.encoding, test.reversed);
        const same = writer === snippets[test.writer] && writes === test.writes && cleared.length === 4
            && test.cleared.every((channel, i) => { const [n, d] = channel.split(' / '); return cleared[i] === n / (d ?? 1); });
        if (!same) console.log(`encodings.${test.encoding}: ${writer.name} ${writes} ${cleared}`), ++different;
        names.delete(test.encoding);
    }
    counts[kind] = (counts[kind] ?? 0) + 1;
    const tier = text !== null && test.exactness ? umbrage.exactness(test.items.map(item)) : test.exactness;
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
for (const [name, snippet] of Object.entries(snippets)) {
    named(snippet.name === name && umbrage[name] === snippet, `snippet ${name}`);
    for (const language of ['glsl', 'hlsl', 'msl', 'wgsl'])
        named(umbrage[language].text([snippet]).includes(` umbrage_${name}(`), `function ${name} in ${language}`);
}
for (const [name, { writer, writes, reversed, depth }] of Object.entries(encodings).filter(([, e]) => e.writes !== 'depth')) {
    named(writer === reversed.writer && writer.name === (writes === 'values' ? 'write_' : 'encode_') + name, `writer of ${name}`);
    const reader = depth.match(/^umbrage_decode_(\w+)\(value/)?.[1];  // one reader for a format and its repaired writer
    named(reader !== undefined && name.startsWith(reader) && snippets[`decode_${reader}`], `reader of ${name}`);
}
const others = Object.keys(umbrage).filter(name => !(name in snippets)).sort().join(' ');
named(others === 'bind encodings exactness glsl hlsl msl snippets source supports text versions wgsl', `exports ${others}`);

if (names.size) console.log(`in C++ no encoding is named ${[...names]}`), ++different;
const keys = readFileSync(module_path, 'utf8').match(/^export const encodings = {[^]*?^};/m)[0].match(/^    \w+(?=: {)/gm);
if (new Set(keys).size !== keys.length) console.log(`encodings twice of one name: ${keys}`), ++different;

// Bad input gets a clear answer, by name.
const wrong = 'umbrage: bind: map must be an object; got undefined. Is it of a name that encodings does not have?';
try { bind(snippets.hard, 'a', encodings.typo), ++different, console.log('undefined taken for a map'); } catch ({ message }) {
    if (message !== wrong) console.log(message), ++different;
}
for (const bad of [() => bind(snippets.hard, 'a b'), () => bind(undefined, 'a'), () => bind(snippets.hard), () => bind(snippets.hard, 'a', null),
    () => bind(snippets.hard, 'a', { needs: [undefined] }), () => bind(snippets.hard, 'a', { needs: ['hard'] }), () => bind(snippets.hard, '_a'), () => bind(snippets.hard, 'a', { texture: '3d' }),
    () => bind(snippets.hard, 'a', { size: 3 }), () => bind(snippets.hard, 'a', { outside: 'lit' }), () => bind(snippets.hard, 'a', { gather: 1 }), () => source('200', [snippets.hard]),
    () => source('300 es', [undefined])]) {
    let refused = false;
    try { bad(); } catch (error) { refused = error.message.startsWith('umbrage: '); }
    if (!refused) console.log(`taken without a word: ${bad}`), ++different;
}
console.log(`${Object.entries(counts).map(([kind, n]) => `${kind} ${n}`).join(', ')}: ${different} differ`);
process.exitCode = different || Object.keys(counts).length < 2 ? 1 : 0;
