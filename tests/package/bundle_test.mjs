// SPDX-License-Identifier: MIT
//
// What a page carries that calls one function: bundled and minified, its text twice and 2 kB at most. What the addon of three.js
// adds to a page that names what it uses, with gzip: 20 kB at most.
//     node bundle_test.mjs PACKAGE FOLDER NODE_MODULES
import { existsSync, mkdirSync, readFileSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { gzipSync } from 'node:zlib';

const [umbrage, folder, node_modules] = process.argv.slice(2).map(path => resolve(path));
const required = createRequire(join(node_modules, 'x.js'));
rmSync(folder, { recursive: true, force: true });
mkdirSync(join(folder, 'node_modules'), { recursive: true });
symlinkSync(umbrage, join(folder, 'node_modules/umbrage'));
const { exports } = JSON.parse(readFileSync(join(umbrage, 'package.json'), 'utf8'));

const programs = {
    one: [`import { pcf_2x2, source } from 'umbrage'; globalThis.text = source('300 es', [pcf_2x2]);`, 2],
    wgsl: [`import * as wgsl from 'umbrage/wgsl'; globalThis.text = wgsl.text([wgsl.pcf_2x2]);`, 2],
    hlsl: [`import { pcf_2x2, text } from 'umbrage/hlsl'; globalThis.text = text([pcf_2x2]);`, 2],
    // Which function a map has is known when the program runs: it carries those of every kind of map, along planes too.
    bound: [`import { bind, pcf_2x2, source } from 'umbrage';
        globalThis.text = source('300 es', [bind(pcf_2x2, 'sun', { texture: 'array' })]);`, 10],
    shadow: [`import { shadow, source, spot_light, tent3 } from 'umbrage';
        globalThis.text = source('300 es', [shadow('sun', { kind: spot_light, filter: tent3, map_size: 1024 })]);`, 5],
};

/** The bundle's text of each bundler. */
const bundlers = {
    async esbuild(input) {
        const { outputFiles } = await required('esbuild').build(
            { entryPoints: [input], bundle: true, minify: true, format: 'esm', write: false, logLevel: 'error' });
        return outputFiles[0].text;
    },
    async rollup(input) {
        const resolveId = id => id.startsWith('umbrage')
            ? { id: join(umbrage, exports[id.replace('umbrage', '.')].default), moduleSideEffects: false } : null;
        const bundle = await required('rollup').rollup({ input, plugins: [{ name: 'package', resolveId }] });
        const { output } = await bundle.generate({ format: 'es' });
        return (await required('terser').minify(output[0].code, { module: true })).code;
    },
    async webpack(input) {
        const output = { path: folder, filename: 'webpack.out.js' };
        const compiler = required('webpack')({ mode: 'production', entry: input, context: folder, output, performance: false });
        const stats = await new Promise((done, failed) => compiler.run((error, stats) => error ? failed(error) : done(stats)));
        if (stats.hasErrors()) throw new Error(stats.toString());
        return readFileSync(join(folder, output.filename), 'utf8');
    },
    async vite(input) {
        const { build } = await import(pathToFileURL(join(node_modules, 'vite/dist/node/index.js')).href);
        const { output } = await build({ root: folder, configFile: false, logLevel: 'error',
            build: { write: false, modulePreload: false, rollupOptions: { input } } });
        return output[0].code;
    },
};
const needs = { rollup: ['terser'] };

const left_out = [];
let failed = 0;
for (const [name, bundle] of Object.entries(bundlers)) {
    const missing = [name, ...needs[name] ?? []].filter(module => !existsSync(join(node_modules, module)));
    if (missing.length) {
        left_out.push(...missing);
        continue;
    }
    for (const [program, [code, times]] of Object.entries(programs)) {
        if (name !== 'esbuild' && !['one', 'bound'].includes(program)) continue;  // the others take their time
        const input = join(folder, `${program}.js`);
        writeFileSync(input, code);
        const bundled = await bundle(input), file = join(folder, `${name}.${program}.mjs`);
        writeFileSync(file, bundled);
        await import(pathToFileURL(file).href);
        const size = Buffer.byteLength(bundled), limit = times * globalThis.text.length + 2048;
        const good = /umbrage_(pcf_2x2|tent3)/.test(globalThis.text) && size <= limit;
        console.log(`${good ? 'ok' : 'FAILED'}: ${name}, ${program}: ${size} bytes for a text of ${globalThis.text.length}, at most ${limit}`);
        delete globalThis.text;
        failed += !good;
    }
}
/** A page of three.js, without the addon, with it, and with its fit. */
const names = '{ BasicShadowMap, Material, REVISION, ShaderChunk, WebGLRenderer }';
const page = `import ${names} from 'three'; globalThis.all = ${names};`;
const installed = `${page} import { castano_dyadic5 } from 'umbrage'; import { fit_shadow, install } from 'umbrage/three';
    install(all, new WebGLRenderer(), { filter: castano_dyadic5 });`;
const pages = { page, installed, fitted: `${installed} fit_shadow(globalThis.light, { receivers: globalThis.floor });` };
if (['esbuild', 'three'].every(module => existsSync(join(node_modules, module)))) {
    const bytes = {};
    symlinkSync(join(node_modules, 'three'), join(folder, 'node_modules/three'));
    for (const [name, code] of Object.entries(pages)) {
        writeFileSync(join(folder, `${name}.js`), code);
        bytes[name] = gzipSync(await bundlers.esbuild(join(folder, `${name}.js`))).length;
    }
    for (const name of ['installed', 'fitted']) {
        const added = bytes[name] - bytes.page, good = added > 10_000 && added <= 20_000;
        console.log(`${good ? 'ok' : 'FAILED'}: the addon of three.js, ${name}, adds ${added} bytes with gzip, at most 20000`);
        failed += !good;
    }
} else if (!existsSync(join(node_modules, 'three'))) left_out.push('three');

if (!failed && left_out.length) console.log(`SKIPPED: no ${left_out.join(', ')} in ${node_modules}`);
process.exitCode = failed ? 1 : left_out.length ? 77 : 0;
