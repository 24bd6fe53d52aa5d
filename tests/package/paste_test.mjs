// SPDX-License-Identifier: MIT
//
// The files to paste: each says what it is and what its map must be, and compiles alone.
//     node paste_test.mjs ROOT GLSLANG FOLDER NODE_MODULES
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const [root, glslang, folder, node_modules] = process.argv.slice(2);
const load = path => import(pathToFileURL(resolve(path)).href);
const { encodings, snippets } = await load(join(root, 'single_include/umbrage.mjs'));
const shaders = join(root, 'single_include/shaders');
const copyright = readFileSync(join(root, 'LICENSE'), 'utf8').match(/^Copyright.*/m)[0];
mkdirSync(folder, { recursive: true });

let failed = 0, compiled = 0;
const check = (good, file, what) => { if (!good && ++failed < 20) console.log(`FAILED: ${file}: ${what}`); };
const files = readdirSync(shaders).sort().flatMap(language => readdirSync(join(shaders, language)).map(file => {
    const text = readFileSync(join(shaders, language, file), 'utf8'), name = file.slice(0, file.indexOf('.'));
    const lines = text.slice(0, text.indexOf('\n\n')), head = lines.replace(/\n\/\/   /g, ' ');
    return { language, file: `${language}/${file}`, name, text, lines, head };
}));
const of = (language, name) => files.find(f => f.language === language && f.name === name);

for (const { language, file, name, text, lines, head } of files) {
    check(lines.split('\n').every(line => line.startsWith('//') && line.length <= 120), file, 'head in lines of comment');
    check(new RegExp(`^// umbrage \\d+\\.\\d+\\.\\d+, ${name}: `).test(head), file, 'its name');
    check(head.includes('\n// SPDX-License-Identifier: MIT\n') && head.includes(`\n// ${copyright}. License text: LICENSE`), file, 'license');
    check(!text.includes('://'), file, 'no address');
    const tier = snippets[name]?.exactness.toUpperCase();
    if (tier && language !== 'wgsl') check(head.includes(`Exactness: tier ${tier}.`), file, `tier ${tier}`);
    const reordered = { glsl: 'GLSL below 400 and 320 es', wgsl: 'WGSL', wgsl_joined: 'WGSL' }[language];
    const note = reordered && tier && tier !== 'A' ? 1 : 0;
    if (tier) check(text.split(`\n// ${reordered} lets compilers`).length === 1 + note, file, 'what is forbidden');
    const { operations, within } = snippets[name] ?? {};
    const bound = within ? `1/${1 / within} of C++` : `${operations} x 2^-23 x S of`;
    if (tier) check(head.includes(`\n// ${name}, tier ${tier}: within ${bound}`) === (tier !== 'A'), file, 'its bound');
    check(!/^#(ifn?def|define) (?!GL_ES$|UMBRAGE_(HAS_|HIGHP|PRECISE))/m.test(text), file, 'a macro to define');
    const options = { texture: /umbrage_(lit_)?texel(_shadow|_depths)?\(/, depth: /umbrage_fetch_depth(_depths)?\(/,
        compare: /umbrage_compare(_depths)?\(/, direction: /umbrage_(cleared_depth|beyond_far_plane)(_shadow|_depths)?\(/,
        outside: /umbrage_(map_covers|fetch_depth)(_depths)?\(/ };
    for (const [option, changes] of Object.entries(options))
        if (changes.test(text)) check(new RegExp(`^//   ${option} `, 'm').test(lines), file, `option ${option}`);
    const reads = ['fetch_depth', 'lit_texel'].some(hook => new RegExp(`umbrage_${hook}\\w*\\(`).test(text));
    if (reads && snippets[name]?.role === 'none') check(/^\/\/ Map: `.*map/m.test(head) && head.includes('one sample. Clear to'), file, 'its map');
    check(!file.includes('_shadow') || head.includes('receiver <= '), file, 'its comparison');
}
for (const [name, { write, format, channels, cleared }] of Object.entries(encodings)) {
    if (name === 'depth32f') continue;
    const writer = write.needs.find(s => s.name === `write_${name}` || s.name === `encode_${name}`).name;
    const most = { R16: 65535, RGB10_A2: 1023 }[format] ?? 255, integers = cleared.map(channel => Math.round(channel * most));
    check(of('glsl', writer).head.includes(
        `Render target of ${name}: ${format} UNORM, not sRGB, no blending, one sample. Clear to `
        + `(${integers.slice(0, channels).join(', ')}) / ${most},`), writer, `target of ${name}`);
}

function compile(file, text, ...options) {
    ++compiled;
    const path = join(folder, 'trial.frag');
    writeFileSync(path, text);
    try { execFileSync(glslang, [...options, path]); } catch (error) { check(false, file, error.stdout); }
}
const shadow = files.filter(f => f.name.endsWith('_shadow'));
for (const name of ['hard', 'pcf_2x2', 'box', 'tent3', 'castano5', 'disc16', 'pcf_2x2_hardware', 'pcss_hardware16'])
    for (const language of ['glsl', 'hlsl', 'msl', 'wgsl_joined']) check(of(language, `${name}_shadow`), name, `none in ${language}`);
for (const { language, file, text } of shadow) {
    if (language === 'glsl') {
        compile(file, `#version 330\n${text}\nvoid main() {}\n`);
        compile(file, `#version 300 es\nprecision mediump float;\n${text}\nvoid main() {}\n`);
    }
    if (language === 'hlsl')
        compile(file, `${text}\nfloat4 main() : SV_Target { return (float4)0; }\n`, '-D', '-V', '-e', 'main', '-o', join(folder, 'trial.spv'));
}
const joined = files.filter(f => f.language === 'wgsl_joined');
check(Object.keys(snippets).every(name => of('wgsl_joined', name)), 'wgsl_joined', 'a file a snippet');
if (existsSync(join(node_modules, 'naga-wasm'))) {
    const { translate } = await load(join(node_modules, 'naga-wasm/dist/node.js'));
    for (const { file, text } of joined) {
        ++compiled;
        try { translate({ from: 'wgsl', to: 'spirv', source: text }); } catch (error) { check(false, file, error.message); }
    }
} else console.log('no naga-wasm here: WGSL is not compiled');
console.log(`${files.length} files, ${compiled} compiled, ${failed} faults`);
process.exitCode = failed || files.length < 500 ? 1 : 0;
