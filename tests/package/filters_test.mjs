// SPDX-License-Identifier: MIT
//
// What the package knows of filters: calls made of it compile, and a comparison sampler serves where it says so.
// Functions of WGSL, one at a time, are the text.
//     node filters_test.mjs PACKAGE GLSLANG FOLDER NODE_MODULES
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const [umbrage, glslang, folder, node_modules] = process.argv.slice(2);
const load = path => import(pathToFileURL(resolve(path)).href);
const { bind, snippets, source } = await load(join(umbrage, 'umbrage.mjs')), wgsl = await load(join(umbrage, 'wgsl.mjs'));
mkdirSync(folder, { recursive: true });
let failed = 0;
const check = (good, what) => { if (!good) ++failed, console.log(`FAILED: ${what}`); };

const by_hand = { hard: ['comparisons', 0.5], pcf_2x2: ['comparisons', 1], tent3: ['comparisons', 2], castano7: ['comparisons', 4],
    box: ['comparisons', 1.5], pcss16: ['depths', (96 * 14.1422) / 256 + 0.5], msm: ['moments', 1] };
for (const [name, [reads, reach]] of Object.entries(by_hand)) {
    const { filter } = snippets[name];
    check(filter.reads === reads && Math.abs(filter.reach - reach) < 0.1, `${name} reads ${filter.reads}, reaches ${filter.reach}`);
}
check(snippets.disc16.filter.arguments.map(a => `${a.type} ${a.name} = ${a.value}`).join() === 'float radius = 2,vec4 rotation = 64,0,0,64',
    'arguments of disc16');

const filters = Object.values(snippets).filter(s => s.filter), number = value => String(value).includes('.') ? value : value.toFixed(1);
check(filters.length > 25 && !snippets.texel.filter, `${filters.length} filters`);
const calls = filters.map(({ name, filter }) => {
    const coords = (filter.offsets ?? [[0, 0]]).map(offset => `coord + vec2(${offset.map(number).join(', ')})`);
    const further = filter.arguments.map(({ type, value }) => type === 'int' ? value
        : type === 'float' ? number(value) : `${type}(${value.map(number).join(', ')})`);
    return `    visibility += umbrage_${name}(map, vec2(64.0), ${[...coords, '0.5', ...further].join(', ')});\n`;
});
const file = join(folder, 'calls.frag');
writeFileSync(file, source('300 es', filters, 'precision highp float;') + 'uniform highp sampler2D map;\nout vec4 color;\nvoid main() {\n'
    + `    vec2 coord = gl_FragCoord.xy;\n    float visibility = 0.0;\n${calls.join('')}    color = vec4(visibility);\n}\n`);
try { execFileSync(glslang, [file], { encoding: 'utf8' }); } catch (error) { check(false, `calls\n${error.stdout}`); }

for (const s of filters) {
    let serves = true;
    try { source('330', [bind(s, 'a', { texture: 'shadow' })]); } catch { serves = false; }
    check(s.filter.reads !== 'comparisons' || serves, `${s.name} and comparison samplers`);
    check(s.filter.reads === 'comparisons' || !serves || s.name.includes('pcss'), `${s.name} and depths`);
}

const all = Object.values(wgsl.snippets), functions = wgsl.functions(all), known = new Set();
for (const { name, text, needs } of functions) {
    check(text.startsWith(`fn ${name}(`) && text.endsWith('\n}') && text.match(/^fn /gm).length === 1, `one function: ${name}`);
    check(needs.every(need => known.has(need)) && !known.has(name), `${name} behind what it calls`);
    known.add(name);
}
const code = text => text.replace(/^\/\/.*/gm, '').replace(/\s+/g, ' ').trim();
check(code(functions.map(f => f.text).join('\n')) === code(wgsl.text(all)), 'functions are the text');
const { needs } = wgsl.functions([wgsl.bind(wgsl.pcf_2x2, 'sun', wgsl.rg11)]).at(-1);
check(needs.join() === 'umbrage_in_filter_domain_sun,umbrage_lit_2x2_sun', `needs of pcf_2x2_sun: ${needs}`);
if (existsSync(join(node_modules, 'naga-wasm'))) {
    const { translate } = await load(join(node_modules, 'naga-wasm/dist/node.js'));
    const by_name = new Map(functions.map(f => [f.name, f]));
    const collect = (name, names) => by_name.get(name).needs.forEach(need => collect(need, names)) ?? names.add(name);
    for (const { name } of functions) {
        const text = [...collect(name, new Set())].map(n => by_name.get(n).text).join('\n');
        try { translate({ from: 'wgsl', to: 'spirv', source: text }); } catch (error) { check(false, `${name}: ${error.message}`); }
    }
} else console.log('no naga-wasm here: functions of WGSL are not compiled');
console.log(`${filters.length} filters, ${functions.length} functions of WGSL, ${failed} faults`);
process.exitCode = failed ? 1 : 0;
