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
const { end_of_body } = await load('umbrage/npm/options.mjs');
const glsl = await load('umbrage/umbrage.mjs'), wgsl = await load('umbrage/wgsl.mjs');

let failed = 0;
const check = (what, good) => {
    if (!good) ++failed;
    console.log(`${good ? 'ok' : 'FAILED'}: ${what}`);
};
const refusal = call => { try { call(); return 'accepted'; } catch (error) { return error.message; } };

/** Babylon.js itself gives point lights another filter, so that they never reach a function that is replaced. */
async function lights_of_babylon() {
    const modules = ['Engines/nullEngine', 'Lights/directionalLight', 'Lights/pointLight', 'Lights/spotLight',
        'Lights/Shadows/shadowGenerator', 'Maths/math.vector', 'scene'].map(name => load(`@babylonjs/core/${name}.js`));
    const { DirectionalLight, NullEngine, PointLight, Scene, ShadowGenerator, SpotLight, Vector3 } =
        Object.assign({}, ...await Promise.all(modules));
    const engine = new NullEngine(), scene = new Scene(engine), down = new Vector3(0, -1, 0);
    engine._features.supportShadowSamplers = true;  // as engines have it
    for (const [light, point] of [[new DirectionalLight('', down, scene)], [new SpotLight('', down, down, 1, 1, scene)],
        [new PointLight('', down, scene), true]])
        for (const [use, kind] of [['usePercentageCloserFiltering', 'PCF'], ['useContactHardeningShadow', 'PCSS']]) {
            const generator = new ShadowGenerator(64, light);
            generator[use] = true;
            check(`babylon, ${light.getClassName()}: ${use} ${point ? 'is Poisson sampling' : `is ${kind}`}`,
                generator.filter === ShadowGenerator[`FILTER_${point ? 'POISSONSAMPLING' : kind}`]);
        }
    scene.dispose();
}

/** Each light with each shadow type is reached by a filter, or refused. */
function lights_of_playcanvas(pc, addon, device_of) {
    const names = ['SHADOW_PCF1_32F', 'SHADOW_PCF3_16F', 'SHADOW_PCF3_32F', 'SHADOW_PCF5_16F', 'SHADOW_PCF5_32F', 'SHADOW_VSM_16F',
        'SHADOW_PCSS_32F'];
    const pcf = names.slice(1, 5).join();
    const lights = {  // clustered or not, type: shadow types that castano_dyadic5 reaches, and pcss16
        'false directional': [pcf, 'SHADOW_PCSS_32F'], 'true directional': [pcf, 'SHADOW_PCSS_32F'],
        'false spot': [pcf, ''], 'true spot': [pcf, ''],
        'false omni': ['', ''], 'true omni': [pcf, ''],
    };
    for (const [what, reached] of Object.entries(lights))
        for (const [i, filter] of [glsl.castano_dyadic5, glsl.pcss16].entries()) {
            const [clustered, type] = what.split(' '), said = [];
            const accepted = names.filter(name => {
                const scene = { clusteredLightingEnabled: clustered === 'true', lighting: { shadowType: pc[name] } };
                const light = { type, shadowType: pc[name], system: { app: { scene } } }, device = device_of(false);
                const refused = refusal(() => addon.install(device, { glsl: filter, lights: [light] }));
                if (refused !== 'accepted') said.push(refused);
                addon.uninstall(device);
                return refused === 'accepted';
            });
            check(`playcanvas, clustered ${what}: ${filter.name} reaches ${accepted.join(' ') || 'none'}`, accepted.join() === reached[i]
                && said.every(text => text.startsWith('umbrage/playcanvas: install: lights must be ') && text.includes(`${type} with `)));
            if (type !== 'directional') console.log(`    ${said.at(-1)}`);
        }
}

/** Functions in a text by their names, to their closing brace. */
const functions_of = (text, names) => names.map(name => {
    const [head] = text.match(new RegExp(`\\b${name}\\([^{;]*{`)) ?? [''], begin = text.indexOf(head);
    return head && text.slice(begin, end_of_body(text, begin + head.length));
});

/** Each host: its addon, an engine of it, its chunks as a map, names of replaced functions, and the reason of a refusal. */
const hosts = {
    async babylon() {
        const { AbstractEngine } = await load('@babylonjs/core/Engines/abstractEngine.js');
        const { ShaderStore } = await load('@babylonjs/core/Engines/shaderStore.js');
        const addon = await load('umbrage/npm/babylon.mjs');
        const engine = (isWebGPU, version = 2, reversed = false) => Object.create(AbstractEngine.prototype,
            { isWebGPU: { value: isWebGPU }, version: { value: version }, useReverseDepthBuffer: { value: reversed } });
        const old = refusal(() => addon.install(engine(false, 1), { glsl: glsl.hard }));
        check(`babylon, WebGL 1: ${old}`, old.endsWith('engine must have WebGL 2 or WebGPU; got WebGL 1'));
        await lights_of_babylon();
        return {
            addon, engine, first: 'shadowsFragmentFunctions', unknown: 'another text of computeShadowWithPCF3',
            replaced: { pcf: 'computeShadowWithPCF3', pcss: 'computeShadowWithCSMPCSS64' },
            further(language, made, say) {
                const { hard, pcss16 } = { glsl, wgsl }[language], other = engine(language === 'wgsl', 2, true);
                say('a scene', () => addon.install(made, { [language]: hard, scene: [] }), 'scene must be a scene of Babylon.js; got []');
                addon.install(made, { [language]: hard });
                say('another depth', () => addon.install(other, { [language]: pcss16 }),
                    "must be false, as at the page's first install: call uninstall(engine) before; got true");
                addon.uninstall(made);
                check(`babylon, ${language}: another depth afterwards`,
                    refusal(() => addon.install(other, { [language]: pcss16 })) === 'accepted');
                addon.uninstall(other);
            },
            kept: ['computeShadowCube', 'computeShadowWithPoissonSamplingCube', 'computeShadowWithPCF1', 'computeShadowWithCSMPCF1'],
            chunks: kept => {
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
        const engine = isWebGPU => {
            const device = bare(isWebGPU);
            chunks_of(device).add(chunks[isWebGPU ? 'wgsl' : 'glsl']);
            return device;
        };
        lights_of_playcanvas(pc, addon, engine);
        return {
            further(language, device, say) {
                for (const [lights, part] of [[new pc.Entity(), 'got Entity'], [[new pc.Entity()], 'got [Entity]'], [[undefined], 'got [undefined]'],
                    [null, 'got null']])
                    say('lights', () => addon.install(device, { [language]: { glsl, wgsl }[language].hard, lights }),
                        `lights must be an array of light components, such as [entity.light]; ${part}`);
                say('frame', () => addon.install(device, { [language]: { glsl, wgsl }[language].disc16, frame: true }),
                    'device must be that of the current app for frame; got undefined');
            },
            addon, kept: ['getShadowPCF1x1', 'getShadowVSM16'], first: 'shadowPCF3PS', unknown: 'another text of _getShadowPCF3x3', chunks: chunks_of,
            replaced: { pcf: '_getShadowPCF5x5', pcss: 'PCSSDirectional' }, engine,
        };
    },
};

/** Whether a host is there; if so, our modules find it. */
function found(needed) {
    if (!existsSync(join(node_modules, needed))) {
        console.log(`SKIPPED: no ${needed} in ${node_modules}`);
        return false;
    }
    mkdirSync(join(modules, needed, '..'), { recursive: true });
    symlinkSync(join(node_modules, needed), join(modules, needed));
    return true;
}

/** A call that is refused by the addon's words. */
const refused = (where, head, what, call, part) => {
    const said = refusal(call);
    check(`${where}, ${what}: ${said}`, said.startsWith(`umbrage/${head}: `) && said.includes(part));
};

/** Options that every addon refuses; filters are those of a language, option is the name that the addon has for one. */
function refuses_options(where, head, option, { box, disc16, pcss16, saturate, vsm }, call) {
    const floats = 'must be 4 finite floats of 32 bits; got', softness = 'in order from 0 to 4095; got';
    for (const [options, part] of [
        [null, 'options must be an object; got null'],
        [{ [option]: pcss16, argument: {} }, 'options must have no properties but '],
        [{ [option]: null }, `${option} must be a filter of this package, such as pcss16; got null`],
        [{ [option]: 'pcss16' }, `${option} must be a filter of this package, such as pcss16; got pcss16`],
        [{ [option]: saturate }, `${option} must be a filter of this package, such as pcss16; got saturate`],
        [{ [option]: vsm }, `${option} must read depths through one coordinate; got vsm`],
        [{ [option]: pcss16, probe: 1 }, 'probe must be '],
        [{ [option]: pcss16, frame: 1 }, 'frame must be true or false; got 1'],
        [{ [option]: pcss16, arguments: null }, 'arguments must be an object; got null'],
        [{ [option]: pcss16, arguments: { softnes: 1 } }, 'arguments must be among (softness) of pcss16; got softnes'],
        [{ [option]: pcss16, arguments: { rotation: [64, 0, 0, 64] } }, 'arguments must be among (softness) of pcss16; got rotation'],
        [{ [option]: pcss16, arguments: { softness: [1, 2] } }, `arguments.softness ${floats} [1, 2]`],
        [{ [option]: pcss16, arguments: { softness: [1, , 2, 3] } }, `arguments.softness ${floats} [1, undefined, 2, 3]`],
        [{ [option]: pcss16, arguments: { softness: [-1, -1, 16, 96] } }, `${softness} [-1, -1, 16, 96]`],
        [{ [option]: pcss16, arguments: { softness: [1, 5000, 16, 96] } }, `${softness} [1, 5000, 16, 96]`],
        [{ [option]: pcss16, arguments: { softness: [0.0625, 0.0625, 96, 16] } }, `${softness} [0.0625, 0.0625, 96, 16]`],
        [{ [option]: pcss16, arguments: { softness: [0.0625, 0.0625, 16, 96.5] } }, `${softness} [0.0625, 0.0625, 16, 96.5]`],
        [{ [option]: pcss16, arguments: { softness: [0.0625, 0.0625, -16, 96] } }, `${softness} [0.0625, 0.0625, -16, 96]`],
        [{ [option]: disc16, arguments: { radius: [3] } }, 'arguments.radius must be a finite float of 32 bits; got [3]'],
        [{ [option]: disc16, arguments: { radius: 1e39 } }, 'arguments.radius must be a finite float of 32 bits; got 1e+39'],
        [{ [option]: disc16, arguments: { radius: null } }, 'arguments.radius must be a finite float of 32 bits; got null'],
        [{ [option]: box, arguments: { radius: 2.7 } }, 'arguments.radius must be an integer of 32 bits; got 2.7'],
        [{ [option]: box, arguments: { radius: 1e10 } }, 'arguments.radius must be an integer of 32 bits; got 10000000000'],
    ]) refused(where, head, 'options', () => call(options), part);
}

/** three.js with fake renderers: their type of shadow map, and the keys that programs are cached by. */
async function three() {
    const THREE = await load('three/build/three.module.js'), { install, uninstall } = await load('umbrage/npm/three.mjs');
    const { disc16, hard, pcss16 } = glsl, head = 'three: install', basic = THREE.BasicShadowMap, own_type = THREE.PCFShadowMap;
    const renderer_of = direction => Object.create(THREE.WebGLRenderer.prototype, {
        state: { value: { buffers: { depth: { getReversed: () => direction === 'reversed' } } } },
        shadowMap: { value: { type: own_type } } });
    const [a, b, reversed] = ['forward', 'forward', 'reversed'].map(renderer_of);
    const texts = () => JSON.stringify(THREE.ShaderChunk), own = texts();
    const [plain, keyed] = [{}, { customProgramCacheKey: () => 'own' }].map(
        members => Object.assign(new THREE.MeshBasicMaterial(), members));
    const scene = new THREE.Scene(), disposed = [], key = () => plain.customProgramCacheKey();
    for (const material of [plain, keyed]) {
        scene.add(new THREE.Mesh(new THREE.BufferGeometry(), material));
        material.addEventListener('dispose', () => disposed.push(material));
    }

    refuses_options('three', head, 'filter', glsl, options => install(THREE, a, options));
    refused('three', head, 'a scene', () => install(THREE, a, { filter: hard, scene: {} }), 'scene must be a scene of three.js; got an object');
    refused('three', head, 'a part of it', () => install({ REVISION: '187' }, a, { filter: hard }),
        'THREE must have BasicShadowMap, Material, ShaderChunk, WebGLRenderer; got no BasicShadowMap');
    refused('three', 'three: uninstall', 'options', () => uninstall(THREE, { scenes: [] }), 'options must have no properties but scene');
    check('three: untouched by what is refused', texts() === own && a.shadowMap.type === own_type);

    install(THREE, a, { filter: disc16 });
    const [first, by_light] = [texts(), key()];
    refused('three', head, 'a second filter', () => install(THREE, a, { filter: wgsl.pcss16 }), 'filter must be a filter in GLSL; got WGSL');
    refused('three', head, 'a second depth', () => install(THREE, reversed, { filter: pcss16 }),
        "renderer must have the depth direction of the page's first, forward: call uninstall(THREE) before; got reversed");
    check('three: a refused second leaves the first', texts() === first && key() === by_light && a.shadowMap.type === basic);
    install(THREE, a, { filter: disc16, arguments: { radius: 2 } });
    check("three: the default of one's own is another program", texts() !== first && key() !== by_light);
    install(THREE, Object.assign(a, { info: { render: { frame: 5 } } }), { filter: disc16, frame: true });
    const turn = THREE.ShaderLib.physical.uniforms.umbrage_turn.value, turns = new Set(), { info: { render } } = a;
    check(`three: the turn of frame 5 is 5 in reverse, 10: ${turn.y}`, turn.y === 10 && turn.x === 0);
    for (render.frame = 0; render.frame < 16; ++render.frame) turns.add(turn.y);
    check('three: 16 frames have 16 turns', turns.size === 16);
    refused('three', head, 'no ShaderLib', () => install({ ...THREE, ShaderLib: undefined }, a, { filter: disc16, frame: true }),
        'THREE must have ShaderLib for frame; got no ShaderLib');
    install(THREE, b, { filter: disc16, scene });
    check('three: the same filter is the same program', texts() === first && key() === by_light);
    check('three: materials of a scene are compiled again, with keys of their own too',
        plain.version === 1 && keyed.version === 1 && disposed.length === 1 && disposed[0] === keyed);
    check('three: two renderers', a.shadowMap.type === basic && b.shadowMap.type === basic);
    uninstall(THREE, { scene });
    check('three: restored', !('umbrage_turn' in THREE.ShaderLib.physical.uniforms) && texts() === own && a.shadowMap.type === own_type && b.shadowMap.type === own_type
        && key() === new THREE.Material().customProgramCacheKey() && !key().includes('umbrage') && disposed.length === 2);
    install(THREE, reversed, { filter: hard });
    check('three: the other direction afterwards', reversed.shadowMap.type === basic && texts() !== own);
    uninstall(THREE);

    const { shadow_filter } = await load('umbrage/npm/three_webgpu.mjs'), where = 'three/webgpu', { pcss16: in_wgsl } = wgsl;
    refuses_options(where, `${where}: shadow_filter`, 'wgsl', wgsl, shadow_filter);
    for (const [options, part] of [
        [{ glsl: pcss16 }, 'wgsl must be a filter of this package, such as pcss16; got undefined'],
        [{ wgsl: pcss16 }, 'wgsl must be a filter in WGSL; got GLSL'],
        [{ wgsl: in_wgsl, glsl: in_wgsl }, 'glsl must be a filter in GLSL; got WGSL'],
        [{ wgsl: in_wgsl, glsl: null }, 'glsl must be a filter of this package, such as pcss16; got null'],
        [{ wgsl: in_wgsl, receiver: 'vec4' }, "receiver must be a property of TSL, such as property('vec4', 'color'); got vec4"],
    ]) refused(where, `${where}: shadow_filter`, 'languages', () => shadow_filter(options), part);
    check(`${where}: a filter node`, typeof shadow_filter({ wgsl: in_wgsl, glsl: pcss16 }) === 'function');
}

let tried = 0;
if (found('three')) {
    ++tried;
    await three();
}
for (const [name, needed] of [['babylon', '@babylonjs/core'], ['playcanvas', 'playcanvas']]) {
    if (!found(needed)) continue;
    const { addon, engine: made, first, further, unknown, replaced, kept, chunks: chunks_of } = await hosts[name]();
    for (const [language, { castano_dyadic5, pcss16, vsm, snippets }] of Object.entries({ glsl, wgsl })) {
        ++tried;
        const engine = made(language === 'wgsl'), chunks = chunks_of(engine), where = `${name}, ${language}`;
        const texts = () => JSON.stringify([...chunks.keys()].map(key => [key, chunks.get(key)])), own = texts();
        const body = called => texts().match(new RegExp(`${called}\\([^{]*{.*?umbrage_(\\w+)_${name}`))?.[1];
        const say = (what, call, part) => refused(where, `${name}: install`, what, call, part);
        addon.install(engine, { [language]: castano_dyadic5 });
        check(`${where}: PCF is replaced`, body(replaced.pcf) === 'castano_dyadic5');
        addon.install(engine, { [language]: pcss16, arguments: { softness: [0.125, 0.125, 16, 256] }, probe: true });
        check(`${where}: both kinds are replaced`, body(replaced.pcf) === 'castano_dyadic5' && body(replaced.pcss) === 'pcss16');
        const others = [own, texts()].map(text => functions_of(JSON.parse(text).map(([, chunk]) => chunk).join('\n'), kept));
        check(`${where}: ${kept.join(', ')} as before`, others[0].every((text, i) => text && text === others[1][i]));
        check(`${where}: softness and probe`, texts().includes('(0.125, 0.125, 16.0, 256.0)') && texts().includes('umbrage_color, 1.0'));
        addon.install(engine, { [language]: snippets.tent3 });
        check(`${where}: a second filter`, body(replaced.pcf) === 'tent3' && body(replaced.pcss) === 'pcss16');
        addon.uninstall(engine);
        check(`${where}: restored byte for byte`, texts() === own);

        const other = language === 'glsl' ? wgsl : glsl;
        say('no filter', () => addon.install(engine),
            `${language} must be given, a filter of this package, for this engine; got undefined`);
        say('another language', () => addon.install(engine, { [language]: other.pcss16 }),
            `${language} must be a filter in ${language.toUpperCase()}; got `);
        say('the other language', () => addon.install(engine, { [language]: pcss16, [language === 'glsl' ? 'wgsl' : 'glsl']: pcss16 }),
            `must be a filter in ${language === 'glsl' ? 'WGSL' : 'GLSL'}; got `);
        refuses_options(where, `${name}: install`, language, { glsl, wgsl }[language], options => addon.install(engine, options));
        further?.(language, engine, say);
        say('another engine', () => addon.install({}, { [language]: pcss16 }), 'of this copy of');
        refused(where, `${name}: uninstall`, 'no engine', () => addon.uninstall(), 'got undefined');
        refused(where, `${name}: set_light_size`, 'no light', () => addon.set_light_size({}, 1), 'must be ');
        check(`${where}: untouched by what is refused`, texts() === own);
        chunks.set(first, chunks.get(first).replace(unknown.split(' ').at(-1), 'renamed'));
        const changed = texts();
        say('another text', () => addon.install(engine, { [language]: castano_dyadic5 }), unknown);
        check(`${where}: another text is untouched`, texts() === changed);
    }
}
process.exitCode = failed ? 1 : tried ? 0 : 77;
