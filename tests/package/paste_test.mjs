// SPDX-License-Identifier: MIT
//
// The files to paste, and the headers to include: each says what it is and what its map must be, and compiles alone.
//     node paste_test.mjs ROOT GLSLANG FOLDER NODE_MODULES CLANG
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const [root, glslang, folder, node_modules, clang] = process.argv.slice(2);
const load = path => import(pathToFileURL(resolve(path)).href);
const { encodings, snippets } = await load(join(root, 'single_include/umbrage.mjs'));
const hlsl = await load(join(root, 'single_include/hlsl.mjs'));
const shaders = join(root, 'single_include/shaders');
const copyright = readFileSync(join(root, 'LICENSE'), 'utf8').match(/^Copyright.*/m)[0];
mkdirSync(folder, { recursive: true });

let failed = 0, compiled = 0;
const check = (good, file, what) => { if (!good && ++failed < 20) console.log(`FAILED: ${file}: ${what}`); };
const files = ['glsl', 'wgsl'].flatMap(language => readdirSync(join(shaders, language)).map(file => {
    const text = readFileSync(join(shaders, language, file), 'utf8'), name = file.slice(0, file.indexOf('.'));
    const lines = text.slice(0, text.indexOf('\n\n')), head = lines.replace(/\n\/\/   /g, ' ');
    return { language, file: `${language}/${file}`, name, text, lines, head };
}));
const of = (language, name) => files.find(f => f.language === language && f.name === name);
check(readdirSync(shaders).sort().join() === 'glsl,umbrage.hlsl,umbrage.metal,wgsl', 'shaders', readdirSync(shaders));

for (const { language, file, name, text, lines, head } of files) {
    check(lines.split('\n').every(line => line.startsWith('//') && line.length <= 120), file, 'head in lines of comment');
    check(new RegExp(`^// umbrage \\d+\\.\\d+\\.\\d+, ${name}: `).test(head), file, 'its name');
    check(head.includes('\n// SPDX-License-Identifier: MIT\n') && head.includes(`\n// ${copyright}. License text: LICENSE`), file, 'license');
    check(!text.includes('://'), file, 'no address');
    const tier = snippets[name]?.exactness.toUpperCase();
    if (tier) check(head.includes(`Exactness: tier ${tier}.`), file, `tier ${tier}`);
    const reordered = { glsl: 'GLSL below 400 and 320 es', wgsl: 'WGSL' }[language];
    const note = tier && tier !== 'A' ? 1 : 0;
    if (tier) check(text.split(`\n// ${reordered} lets compilers`).length === 1 + note, file, 'what is forbidden');
    const { operations, within } = snippets[name] ?? {};
    const bound = within ? `1/${1 / within} of C++` : `${operations} x 2^-23 x S of`;
    if (tier) check(head.includes(`\n// ${name}, tier ${tier}: within ${bound}`) === (tier !== 'A'), file, 'its bound');
    check(!/^#(ifn?def|define) (?!GL_ES$|UMBRAGE_(HAS_|HIGHP|PRECISE))/m.test(text), file, 'a macro to define');
    const options = { texture: /umbrage_(lit_)?texel(_shadow|_depths)?\(/, depth: /umbrage_fetch_depth(_depths)?\(/,
        compare: /umbrage_compare(_depths)?\(/, direction: /umbrage_(cleared_depth|beyond_far_plane)(_shadow|_depths)?\(/,
        outside: /umbrage_(map_covers|fetch_depth)(_depths)?\(/ };
    for (const [option, changes] of Object.entries(options))
        if (changes.test(text)) check(new RegExp(`^// Other maps: bind\\(\\).* by .*${option}[,.]`, 'm').test(head), file, `option ${option}`);
    const reads = ['fetch_depth', 'lit_texel'].some(hook => new RegExp(`umbrage_${hook}\\w*\\(`).test(text));
    if (reads && snippets[name]?.role === 'none') check(/^\/\/ Map: `.*map/m.test(head) && head.includes('one sample. Clear to'), file, 'its map');
    check(!file.includes('_shadow') || head.includes('receiver <= '), file, 'its comparison');
}

/** A header of all functions: what its maps must be, its targets, and each function once. */
function header(file) {
    const text = readFileSync(join(shaders, file), 'utf8'), lines = text.slice(0, text.indexOf('\n\n')), head = lines.replace(/\n\/\/   /g, ' ');
    check(lines.split('\n').every(line => line.startsWith('//') && line.length <= 120), file, 'head in lines of comment');
    check(head.includes('\n// SPDX-License-Identifier: MIT\n') && head.includes(`\n// ${copyright}. License text: LICENSE`), file, 'license');
    check(head.includes('Its sampler passes receiver <= depth'), file, 'its comparison');
    const defined = [...text.matchAll(/^(?:[\w:]+ )+(umbrage_\w+)\(/gm)].map(match => match[1]), guards = text.match(/^#ifndef UMBRAGE_HAS_\w+$/gm);
    const signatures = text.match(/ umbrage_\w+\([^)]*\) \{$/gm);  // one text may define a name for several types
    check(new Set(signatures).size === signatures.length && new Set(guards).size === guards.length, file, 'two texts of one name');
    for (const { name, exactness } of Object.values(snippets)) {
        check(defined.includes(`umbrage_${name}`), file, `no ${name}`);
        check(head.includes(`\n// ${name}, tier ${exactness.toUpperCase()}: within `) === (exactness !== 'a'), file, `bound of ${name}`);
    }
    for (const f of files) check(defined.includes(`umbrage_${f.name}`) || f.name === 'pcss_hardware16_shadow', file, `no ${f.name}`);
    return { text, head, signatures };
}
const headers = { hlsl: header('umbrage.hlsl'), metal: header('umbrage.metal') };

for (const [name, { write, format, channels, cleared }] of Object.entries(encodings)) {
    if (name.startsWith('depth')) continue;
    const writer = write.needs.find(s => s.name === `write_${name}` || s.name === `encode_${name}`).name;
    const most = { R16: 65535, RGB10_A2: 1023 }[format] ?? 255, integers = cleared.map(channel => Math.round(channel * most));
    for (const { head } of [of('glsl', writer), headers.hlsl, headers.metal])
        check(head.includes(`Render target of ${name}: ${format} UNORM, not sRGB, no blending, one sample. Clear to `
            + `(${integers.slice(0, channels).join(', ')}) / ${most},`), writer, `target of ${name}`);
}

function compile(file, text, ...options) {
    ++compiled;
    const path = join(folder, 'trial.frag');
    writeFileSync(path, text);
    try { execFileSync(glslang, [...options, path]); } catch (error) { check(false, file, error.stdout); }
}
for (const name of ['hard', 'pcf_2x2', 'box', 'tent3', 'castano5', 'disc16', 'pcf_2x2_hardware', 'pcss_hardware16'])
    for (const language of ['glsl', 'wgsl']) check(of(language, `${name}_shadow`), name, `none in ${language}`);
for (const { language, file, text } of files.filter(f => f.name.endsWith('_shadow'))) {
    if (language !== 'glsl') continue;
    compile(file, `#version 330\n${text}\nvoid main() {}\n`);
    compile(file, `#version 300 es\nprecision mediump float;\n${text}\nvoid main() {}\n`);
}

// HLSL: a shader that includes the header twice and calls all functions (not optimized, which takes minutes); and one that
// calls a filter has the instructions of a shader with that function's text alone.
const spirv = join(folder, 'trial.spv'), in_hlsl = ['-D', '-V', '-e', 'main', '-S', 'frag', `-I${shaders}`, '-o', spirv];
/** Opcodes of all functions, in order. */
function instructions() {
    const bytes = readFileSync(spirv), words = new Uint32Array(bytes.buffer, bytes.byteOffset, bytes.length / 4), all = [];
    for (let at = 5; at < words.length; at += words[at] >>> 16) {
        const opcode = words[at] & 0xffff;
        if (opcode === 54 || all.length) all.push(opcode);  // OpFunction
    }
    return all.join(' ');
}
let inputs = '', calls = '';
for (const [i, signature] of headers.hlsl.signatures.entries()) {
    const [, name, parameters] = signature.match(/ (\w+)\(([^)]*)\)/), types = parameters.split(/,\s*/).filter(Boolean).map(parameter => parameter.split(' ')[0]);
    inputs += types.map((type, k) => `${type} of_${i}_${k};\n`).join('');
    calls += `    ${name}(${types.map((_, k) => `of_${i}_${k}`).join(', ')});\n`;
}
compile('umbrage.hlsl', `#include "umbrage.hlsl"\n#include "umbrage.hlsl"\n${inputs}float4 main() : SV_Target {\n${calls}    return (float4)0;\n}\n`, '-Od', ...in_hlsl);
check(instructions().length > 100000, 'umbrage.hlsl', 'its functions are left out');
for (const { name, filter } of Object.values(hlsl.snippets)) {
    if (!filter) continue;
    const text = hlsl.text([hlsl.snippets[name]]), [, parameters] = text.match(new RegExp(` umbrage_${name}\\(([^)]*)\\)`));
    const given = parameters.split(/,\s*/), names = given.map(parameter => parameter.split(' ').at(-1));
    const main = `${given.map(parameter => `${parameter};\n`).join('')}float4 main() : SV_Target { return umbrage_${name}(${names.join(', ')}); }\n`;
    compile('umbrage.hlsl', `#include "umbrage.hlsl"\n${main}`, ...in_hlsl);
    const included = instructions();
    compile(name, text + main, ...in_hlsl);
    check(included.length > 100 && included === instructions(), 'umbrage.hlsl', `a shader that calls ${name} has other instructions than with its text alone`);
}

// Metal as C++: all functions, twice, and a function of a user's shader that calls one.
if (clang && existsSync(clang)) {
    ++compiled;
    const lent = join(root, 'tests/parity/backends/metal'), path = join(folder, 'metal.cpp');
    writeFileSync(join(folder, 'umbrage.metal'), headers.metal.text);
    writeFileSync(path, '#include "umbrage.metal"\n#include "umbrage.metal"\nfloat4 lit(metal::texture2d<float> map, float4 at, float2 size) {\n'
        + '    float3 p = umbrage_project_coordinate(at);\n    return float4(umbrage_pcf_2x2(map, size, p.xy, p.z - 0.001f));\n}\n');
    try {
        execFileSync(clang, ['-std=c++20', '-fsyntax-only', '-w', '-cl-single-precision-constant', `-I${folder}`, `-I${lent}`, path], { encoding: 'utf8', stdio: 'pipe' });
    } catch (error) { check(false, 'umbrage.metal', error.stderr.slice(0, 2000)); }
} else console.log('no clang here: Metal is not compiled');

const of_wgsl = files.filter(f => f.language === 'wgsl');
check(Object.keys(snippets).every(name => of('wgsl', name)), 'wgsl', 'a file a snippet');
if (existsSync(join(node_modules, 'naga-wasm'))) {
    const { translate } = await load(join(node_modules, 'naga-wasm/dist/node.js'));
    for (const { file, text } of of_wgsl) {
        ++compiled;
        try { translate({ from: 'wgsl', to: 'spirv', source: text }); } catch (error) { check(false, file, error.message); }
    }
} else console.log('no naga-wasm here: WGSL is not compiled');
console.log(`${files.length} files, ${compiled} compiled, ${failed} faults`);
process.exitCode = failed || files.length < 500 ? 1 : 0;
