// SPDX-License-Identifier: MIT
//
// Addons of engines on the engines' own texts, without a browser: what install writes, what it refuses, and that uninstall
// restores the text byte for byte.
//     node addons_test.mjs PACKAGE FOLDER NODE_MODULES
import { cpSync, existsSync, mkdirSync, rmSync, symlinkSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const [umbrage, folder, node_modules] = process.argv.slice(2).map(path => resolve(path));
const modules = join(folder, 'node_modules');
rmSync(folder, { recursive: true, force: true });
mkdirSync(modules, { recursive: true });
cpSync(umbrage, join(modules, 'umbrage'), { recursive: true });
const load = path => import(pathToFileURL(join(modules, path)).href);
const glsl = await load('umbrage/umbrage.mjs'), wgsl = await load('umbrage/wgsl.mjs');

let failed = 0;
const check = (what, good) => {
    if (!good) ++failed;
    console.log(`${good ? 'ok' : 'FAILED'}: ${what}`);
};
const refusal = call => { try { call(); return 'accepted'; } catch (error) { return error.message; } };

/** Each host: its addon, an engine of it, its chunks as a map, names of replaced functions, and the reason of a refusal. */
const hosts = {
    async babylon() {
        const { AbstractEngine } = await load('@babylonjs/core/Engines/abstractEngine.js');
        const { ShaderStore } = await load('@babylonjs/core/Engines/shaderStore.js');
        const addon = await load('umbrage/npm/babylon.mjs');
        const engine = (isWebGPU, version = 2) => Object.create(AbstractEngine.prototype,
            { isWebGPU: { value: isWebGPU }, version: { value: version }, useReverseDepthBuffer: { value: false } });
        const old = refusal(() => addon.install(engine(false, 1), { glsl: glsl.hard }));
        check(`babylon, WebGL 1: ${old}`, old.endsWith('engine must have WebGL 2 or WebGPU; got WebGL 1'));
        return {
            addon, engine, first: 'shadowsFragmentFunctions', unknown: 'another text of computeShadowWithPCF3',
            replaced: { pcf: 'computeShadowWithPCF3', pcss: 'computeShadowWithCSMPCSS64' }, chunks: kept => {
                const store = kept.isWebGPU ? ShaderStore.IncludesShadersStoreWGSL : ShaderStore.IncludesShadersStore;
                return { get: name => store[name], set: (name, text) => { store[name] = text; }, keys: () => Object.keys(store) };
            },
        };
    },
    async playcanvas() {
        const pc = await load('playcanvas/build/playcanvas/src/index.js');
        const source = 'playcanvas/build/playcanvas/src/scene/shader-lib';
        const chunks = {
            wgsl: (await load(`${source}/wgsl/collections/shader-chunks-wgsl.js`)).shaderChunksWGSL,
            glsl: (await load(`${source}/glsl/collections/shader-chunks-glsl.js`)).shaderChunksGLSL,
        };
        const addon = await load('umbrage/npm/playcanvas.mjs');
        const language = ({ isWebGPU }) => (isWebGPU ? pc.SHADERLANGUAGE_WGSL : pc.SHADERLANGUAGE_GLSL);
        const chunks_of = device => pc.ShaderChunks.get(device, language(device));
        const bare = isWebGPU => Object.create(pc.GraphicsDevice.prototype, { isWebGPU: { value: isWebGPU }, on: { value() {} } });
        const early = refusal(() => addon.install(bare(false), { glsl: glsl.hard }));
        check(`playcanvas, before its app: ${early}`,
            early.endsWith('device must belong to an app that was initialized; got no chunks'));
        return {
            addon, first: 'shadowPCF3PS', unknown: 'another text of _getShadowPCF3x3', chunks: chunks_of,
            replaced: { pcf: '_getShadowPCF5x5', pcss: 'PCSSDirectional' }, engine: isWebGPU => {
                const device = bare(isWebGPU);
                chunks_of(device).add(chunks[isWebGPU ? 'wgsl' : 'glsl']);
                return device;
            },
        };
    },
};

let tried = 0;
for (const [name, needed] of [['babylon', '@babylonjs/core'], ['playcanvas', 'playcanvas']]) {
    if (!existsSync(join(node_modules, needed))) {
        console.log(`SKIPPED: no ${needed} in ${node_modules}`);
        continue;
    }
    mkdirSync(join(modules, needed, '..'), { recursive: true });
    symlinkSync(join(node_modules, needed), join(modules, needed));
    const { addon, engine: made, first, unknown, replaced, chunks: chunks_of } = await hosts[name]();
    for (const [language, { castano_dyadic5, pcss16, vsm, snippets }] of Object.entries({ glsl, wgsl })) {
        ++tried;
        const engine = made(language === 'wgsl'), chunks = chunks_of(engine), where = `${name}, ${language}`;
        const texts = () => JSON.stringify([...chunks.keys()].map(key => [key, chunks.get(key)])), own = texts();
        const body = called => texts().match(new RegExp(`${called}\\([^{]*{.*?umbrage_(\\w+)_${name}`))?.[1];
        const say = (what, call, part) => {
            const said = refusal(call);
            check(`${where}, ${what}: ${said}`, said.startsWith(`umbrage/${name}: install: `) && said.includes(part));
        };
        addon.install(engine, { [language]: castano_dyadic5 });
        check(`${where}: PCF is replaced`, body(replaced.pcf) === 'castano_dyadic5');
        addon.install(engine, { [language]: pcss16, arguments: { softness: [0.125, 16, 256] }, probe: true });
        check(`${where}: both kinds are replaced`, body(replaced.pcf) === 'castano_dyadic5' && body(replaced.pcss) === 'pcss16');
        check(`${where}: softness and probe`, texts().includes('(0.125, 16.0, 256.0)') && texts().includes('umbrage_color, 1.0'));
        addon.install(engine, { [language]: snippets.tent3 });
        check(`${where}: a second filter`, body(replaced.pcf) === 'tent3' && body(replaced.pcss) === 'pcss16');
        addon.uninstall(engine);
        check(`${where}: restored byte for byte`, texts() === own);

        const other = language === 'glsl' ? wgsl : glsl;
        say('no filter', () => addon.install(engine),
            `${language} must be given, a filter of this package, for this engine; got undefined`);
        say('another language', () => addon.install(engine, { [language]: other.pcss16 }),
            `${language} must be a filter in ${language.toUpperCase()}; got `);
        say('moments', () => addon.install(engine, { [language]: vsm }),
            'filter must read depths through one coordinate; got vsm');
        say('an argument', () => addon.install(engine, { [language]: pcss16, arguments: { softnes: 1 } }),
            'arguments must be among (softness, rotation)');
        say('another engine', () => addon.install({}, { [language]: pcss16 }), 'of this copy of');
        check(`${where}: untouched by what is refused`, texts() === own);
        chunks.set(first, chunks.get(first).replace(unknown.split(' ').at(-1), 'renamed'));
        const changed = texts();
        say('another text', () => addon.install(engine, { [language]: castano_dyadic5 }), unknown);
        check(`${where}: another text is untouched`, texts() === changed);
    }
}
process.exitCode = failed ? 1 : tried ? 0 : 77;
