// SPDX-License-Identifier: MIT
//
// Options of the engines' addons with each of their numbers and flags changed: a filter's arguments in the shaders' texts, and
// the sizes of lights against rays through the engines' own matrices. What comes back is right, or the option is refused by its
// name.
//     node options_test.mjs PACKAGE FOLDER NODE_MODULES
import { cpSync, existsSync, mkdirSync, rmSync, symlinkSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { turned_programs } from './turns.mjs';

const [umbrage, folder, node_modules] = process.argv.slice(2).map(path => resolve(path));
const modules = join(folder, 'node_modules');
rmSync(folder, { recursive: true, force: true });
mkdirSync(modules, { recursive: true });
cpSync(umbrage, join(modules, 'umbrage'), { recursive: true });
for (const host of ['three', '@babylonjs', 'playcanvas'])
    if (existsSync(join(node_modules, host))) symlinkSync(join(node_modules, host), join(modules, host));
const load = path => import(pathToFileURL(join(modules, path)).href);
const glsl = await load('umbrage/umbrage.mjs'), wgsl = await load('umbrage/wgsl.mjs');

const programs = new turned_programs([]);

/** Filters with arguments that a program gives to install. */
const given = {
    box: { radius: 2 }, disc16: { radius: 3 }, disc32: { radius: 1.5 },
    pcss16: { softness: [0.0625, 0.0625, 16, 256] }, dpcf16: { softness: [0.125, 0.125, 32, 96] },
};
const numbers_of = values => [values].flat();

/** What is wrong with a filter's arguments in a shader: each of its calls must have them, as literals of their types. */
function wrong_in_text(text, name, options) {
    const calls = [...text.matchAll(new RegExp(`= umbrage_${name}_(three|babylon|playcanvas)\\w*\\(`, 'g'))];
    const [[key, value]] = Object.entries(options), { type } = glsl[name].filter.arguments.find(argument => argument.name === key);
    if (calls.length === 0) return 'no call';
    for (const { index } of calls) {
        const call = text.slice(index, text.indexOf(';', index));
        const literals = [...call.matchAll(/(?<![\w.])-?\d+(\.\d+)?(e[+-]\d+)?(?![\w.])/g)].map(([literal]) => literal);
        const own = numbers_of(value).every(number => literals.some(literal => Number(literal) === number
            && (type === 'int') === /^-?\d+$/.test(literal)));
        if (!own) return `${call} has not ${value}`;
    }
    return undefined;
}

/** Runs install of an addon with each filter's arguments. */
function turn_arguments(host, language, install, uninstall, text) {
    for (const [name, options] of Object.entries(given))
        programs.run_all(`${host} ${name}`, { arguments: options, probe: false, frame: false }, all => {
            try {
                install(language[name], all);
                return wrong_in_text(text(), name, all.arguments);
            } finally { uninstall(); }
        }, path => name === 'box' || path.at(-1) === '1' || path.at(-1) === '2');
}

const length = v => Math.hypot(...v), sum = (a, b, t) => a.map((v, i) => v + t * b[i]);

/** How far a light's size moves a shadow's edge, by rays: from a receiver to the edge of the light.
 *  @param light     { position, direction }, the first only of a spot light
 *  @param place     of a point in the map: [texels, depth]; texels along the side in which the light is wide
 *  @return          [texels, depth]: the width of the penumbra's half, and how far apart receiver and caster are */
function penumbra_of(size, { position, direction, side }, receiver, away, place) {
    const to_light = position ? sum(position, receiver, -1) : direction.map(v => -v / length(direction));
    const [t, to_edge] = position ? [away / length(to_light), sum(to_light, side, size)] : [away, sum(to_light, side, size)];
    const [a, b] = [to_light, to_edge].map(way => place(sum(receiver, way, t)));
    return [Math.abs(b[0] - a[0]), Math.abs(place(receiver)[1] - a[1])];
}
const differs = (a, b, by) => !(Math.abs(a - b) <= by * Math.abs(b));

async function three() {
    const THREE = await load('three/build/three.module.js');
    const { install, set_light_size, uninstall } = await load('umbrage/npm/three.mjs');
    const renderer = Object.create(THREE.WebGLRenderer.prototype, { state: { value: { buffers: { depth: { getReversed: () => false } } } },
        shadowMap: { value: { type: THREE.PCFShadowMap } }, info: { value: { render: { frame: 0 } } } });
    // three.js takes a disc's radius and the scale of a softness from the light, where install is given none
    turn_arguments('three', glsl, (filter, all) => install(THREE, renderer, { filter, ...all }), () => uninstall(THREE),
        () => THREE.ShaderChunk.shadowmap_pars_fragment);

    install(THREE, renderer, { filter: glsl.pcss16 });
    const at = v => new THREE.Vector3(...v);
    /** Rays through the map of a light whose shadow.radius scales a softness of 1/16: 256 texels across all depths. */
    const wrong = (light, size, receiver, source) => {
        light.position.set(0, 0, 10);
        light.updateMatrixWorld();
        set_light_size(light, size);
        light.shadow.updateMatrices(light);
        const place = p => {
            const { x, z } = at(p).applyMatrix4(light.shadow.matrix);  // in [0, 1]
            return [x * light.shadow.mapSize.x, z];
        };
        const [texels, depths] = penumbra_of(size, source, receiver, 2, place), own = 256 * light.shadow.radius * depths;
        return differs(own, texels, 2 / 256) ? `a penumbra of ${own} texels, ${texels} by rays` : undefined;
    };
    const right = [1, 0, 0];
    programs.run_all('three DirectionalLight', { light_size: 0.05, map_size: 512, far: 40, width: 20 }, all => {
        const light = new THREE.DirectionalLight(), { camera, mapSize } = light.shadow;
        mapSize.set(all.map_size, all.map_size);
        Object.assign(camera, { far: all.far, left: -all.width / 2, right: all.width / 2 });
        camera.updateProjectionMatrix();
        return wrong(light, all.light_size, [0.25, 0, 0], { direction: [0, 0, -1], side: right });
    }, path => path[0] === 'map_size', path => path[0] !== 'light_size');
    programs.run_all('three SpotLight', { light_size: 0.2, map_size: 512, distance: 20, angle: 0.5 }, all => {
        const light = new THREE.SpotLight(0xffffff, 1, all.distance, all.angle);
        light.shadow.mapSize.set(all.map_size, all.map_size);
        return wrong(light, all.light_size, [0, 0, 0], { position: [0, 0, 10], side: right });
    }, path => path[0] === 'map_size', path => path[0] !== 'light_size');
    uninstall(THREE);
}

async function babylon() {
    const names = ['Engines/abstractEngine', 'Engines/nullEngine', 'Engines/shaderStore', 'Cameras/freeCamera', 'Lights/directionalLight',
        'Lights/Shadows/shadowGenerator', 'Lights/Shadows/shadowGeneratorSceneComponent', 'Maths/math.vector', 'Meshes/Builders/boxBuilder', 'scene'];
    const { AbstractEngine, NullEngine, ShaderStore, FreeCamera, DirectionalLight, ShadowGenerator, Vector3, CreateBox, Scene } =
        Object.assign({}, ...await Promise.all(names.map(name => load(`@babylonjs/core/${name}.js`))));
    const { install, set_light_size, uninstall } = await load('umbrage/npm/babylon.mjs');
    for (const [language, module, is_webgpu] of [['glsl', glsl, false], ['wgsl', wgsl, true]]) {
        const stub = Object.create(AbstractEngine.prototype,
            { isWebGPU: { value: is_webgpu }, version: { value: 2 }, useReverseDepthBuffer: { value: false } });
        const store = is_webgpu ? ShaderStore.IncludesShadersStoreWGSL : ShaderStore.IncludesShadersStore;
        turn_arguments(`babylon ${language}`, module, (filter, all) => install(stub, { [language]: filter, ...all }), () => uninstall(stub),
            () => store.shadowsFragmentFunctions);
    }

    const engine = new NullEngine();
    engine._features.supportShadowSamplers = true;  // as engines have it
    engine.createDepthStencilTexture = () => null;  // which this engine has not
    programs.run_all('babylon DirectionalLight', { light_size: 0.05, map_size: 512, far: 40, width: 20 }, all => {
        const scene = new Scene(engine), light = new DirectionalLight('', new Vector3(0, 0, -1), scene), edge = all.width / 2;
        new FreeCamera('', new Vector3(0, 5, -20), scene);
        Object.assign(light, { position: new Vector3(0, 0, 10), autoUpdateExtends: false, autoCalcShadowZBounds: false, shadowMinZ: 1,
            shadowMaxZ: all.far, orthoLeft: -edge, orthoRight: edge, orthoBottom: -edge, orthoTop: edge, shadowFrustumSize: 0 });
        const generator = new ShadowGenerator(all.map_size, light), caster = CreateBox('', { size: 1 }, scene);
        generator.addShadowCaster(caster);
        try {
            set_light_size(generator, all.light_size);
            const matrix = generator.getTransformMatrix();
            scene.onAfterRenderTargetsRenderObservable.notifyObservers(scene);
            const place = p => {  // depths from 0 to 1, in clip space from -1 to 1
                const { x, z } = Vector3.TransformCoordinates(new Vector3(...p), matrix);
                return [(x / 2) * all.map_size, engine.isNDCHalfZRange ? z : z / 2];
            };
            const [texels, depths] = penumbra_of(all.light_size, { direction: [0, 0, -1], side: [1, 0, 0] }, [0.25, 0, 0], 2, place);
            const own = generator.contactHardeningLightSizeUVRatio * all.map_size * depths;
            return differs(own, texels, 1e-4) ? `a penumbra of ${own} texels, ${texels} by rays` : undefined;
        } finally { scene.dispose(); }
    }, path => path[0] === 'map_size', path => path[0] !== 'light_size');
    engine.dispose();
}

async function playcanvas() {
    const pc = await load('playcanvas/build/playcanvas/src/index.js'), source = 'playcanvas/build/playcanvas/src/scene/shader-lib';
    const { install, set_light_size, uninstall } = await load('umbrage/npm/playcanvas.mjs');
    for (const [language, module] of Object.entries({ glsl, wgsl })) {
        const chunks = Object.values(await load(`${source}/${language}/collections/shader-chunks-${language}.js`))[0];
        const device = Object.create(pc.GraphicsDevice.prototype, { isWebGPU: { value: language === 'wgsl' }, on: { value() {} } });
        const own = pc.ShaderChunks.get(device, language === 'wgsl' ? pc.SHADERLANGUAGE_WGSL : pc.SHADERLANGUAGE_GLSL);
        own.add(chunks);
        turn_arguments(`playcanvas ${language}`, module, (filter, { frame, ...all }) => install(device, { [language]: filter, ...all, lights: [] }),
            () => uninstall(device), () => own.get('shadowPCF5PS') + own.get('shadowSoftPS'));
    }
    programs.run_all('playcanvas directional', { light_size: 0.05 }, ({ light_size }) => {
        const light = { type: 'directional', penumbraSize: 1 };
        set_light_size(light, light_size);
        return light.penumbraSize === light_size ? undefined : `penumbraSize is ${light.penumbraSize}`;
    });
}

/** Mistakes of the addons, each of which must be seen. */
function plant_faults() {
    const texts = ['= umbrage_disc16_three(shadowMap, size, at.xy, at.z, 3.0);', '= umbrage_pcss16_babylon_pcss(map, vec4(0.0625, 0.0625, 16.0, 255.0));',
        '= umbrage_box_playcanvas_pcf(map, 2.0);', 'float umbrage_disc16_three();'];
    const asked = [['disc16', { radius: 2 }], ['pcss16', given.pcss16], ['box', given.box], ['disc16', given.disc16]];
    const seen = asked.filter(([name, options], i) => wrong_in_text(texts[i], name, options)).length;
    if (seen < texts.length || !wrong_in_text(texts[0], 'disc16', { radius: -3 }) || wrong_in_text(texts[0], 'disc16', { radius: 3 }))
        programs.fails('another argument in a text is not seen');
    if (!differs(2.56 * 1.02, 2.56, 2 / 256) || !differs(NaN, 1, 1)) programs.fails('another penumbra is not seen');
}

plant_faults();
for (const [module, run] of Object.entries({ three, '@babylonjs': babylon, playcanvas })) {
    if (existsSync(join(modules, module))) await run();
    else console.log(`no ${module} in ${node_modules}: its addon is left out`);
}
console.log(programs.summary('right by rays or by their formula'));
process.exit(programs.failed ? 1 : 0);
