// SPDX-License-Identifier: MIT
//
// Babylon.js: the filters of this package on its own shadow maps, for every material that receives shadows. Its bias,
// normalBias, darkness and frustumEdgeFalloff keep their meaning. One filter for each kind of shadow generator: filters that
// compare replace PCF of medium and high quality, those that search for blockers replace PCSS.
//
//     import { castano_dyadic5 } from 'umbrage';
//     import * as wgsl from 'umbrage/wgsl';
//     import { install } from 'umbrage/babylon';
//     install(engine, { glsl: castano_dyadic5, wgsl: wgsl.castano_dyadic5 });  // before the first material
import { AbstractEngine } from '@babylonjs/core/Engines/abstractEngine.js';
import { ShaderStore } from '@babylonjs/core/Engines/shaderStore.js';
import '@babylonjs/core/Shaders/ShadersInclude/oitFragment.js';
import '@babylonjs/core/Shaders/ShadersInclude/shadowsFragmentFunctions.js';
import '@babylonjs/core/ShadersWGSL/ShadersInclude/oitFragment.js';
import '@babylonjs/core/ShadersWGSL/ShadersInclude/shadowsFragmentFunctions.js';
import { in_use } from './babylon_fit.mjs';
import { stop_turning, turn_by_frame, turned_pixel } from './babylon_frame.mjs';
import { checked_options, filtered, globals, languages, light_radius, with_body } from './engine_text.mjs';
import { check_options, further_arguments, must } from './options.mjs';

export { fit_bias } from './babylon_fit.mjs';
export { set_light_size } from './babylon_light_size.mjs';

const where = 'babylon: install', known = '@babylonjs/core must have the shadow shader of 9.33';
const shadows = 'shadowsFragmentFunctions', last = 'oitFragment';  // the latter is included behind a material's color
const stores = { glsl: ShaderStore.IncludesShadersStore, wgsl: ShaderStore.IncludesShadersStoreWGSL };
const scene_of_babylon = ['a scene of Babylon.js', value => Array.isArray(value?.meshes)];
const installed = new Map();  // language -> Babylon.js' own texts, the depth's direction, and the options of each kind

/** Names of the functions of a kind, without and with cascades. */
const functions = { pcf: ['PCF3', 'PCF5'], pcss: ['PCSS16', 'PCSS32', 'PCSS64'] };

/** Their heads, as Babylon.js writes them. */
const heads = {
    glsl: (name, pcss, array) => `float computeShadowWith${array && 'CSM'}${name}(${array && 'float layer,'}`
        + `vec4 vPositionFromLight,float depthMetric,${pcss ? `${array && 'highp '}sampler2D${array} depthSampler,` : ''}`
        + `highp sampler2D${array}Shadow shadowSampler,`
        + `${pcss ? 'float shadowMapSizeInverse,float lightSizeUV' : 'vec2 shadowMapSizeAndInverse'},`
        + 'float darkness,float frustumEdgeFalloff'
        + `${pcss && array ? ',vec2 lightSizeUVCorrection,float depthCorrection,float penumbraDarkness' : ''})\n{`,
    wgsl: (name, pcss, array) => `fn computeShadowWith${array && 'CSM'}${name}(${array && 'layer: i32,'}`
        + 'vPositionFromLight: vec4f,depthMetric: f32,'
        + `${pcss ? `depthTexture: texture_2d${array && '_array'}<f32>,depthSampler: sampler,` : ''}`
        + `shadowTexture: texture_depth_2d${array && '_array'},shadowSampler: sampler_comparison,`
        + `${pcss ? 'shadowMapSizeInverse: f32,lightSizeUV: f32' : 'shadowMapSizeAndInverse: vec2f'},`
        + 'darkness: f32,frustumEdgeFalloff: f32'
        + `${pcss && array ? ',lightSizeUVCorrection: vec2f,depthCorrection: f32,penumbraDarkness: f32' : ''})->f32\n{`,
};

/** Words of Babylon.js' shaders in both languages: maps as arguments, depth in [0, 1], the pixel. */
const words = {
    glsl: {
        maps: pcss => (pcss ? 'depthSampler' : 'shadowSampler'), size: map => `vec2(textureSize(${map}, 0).xy)`, z: 'ZINCLIP',
        layer: 'layer', pixel: 'gl_FragCoord.xy', color: 'gl_FragColor = vec4(umbrage_color, 1.0);',
    },
    wgsl: {
        maps: pcss => (pcss ? 'depthTexture' : 'shadowTexture, shadowSampler'),
        size: map => `vec2f(textureDimensions(${map.split(',')[0]}))`, z: 'getZInClip(clipSpace, uvDepth)',
        layer: 'f32(layer)', pixel: 'fragmentInputs.position.xy', color: 'fragmentOutputs.color = vec4f(umbrage_color, 1.0);',
    },
};

function map_of(kind, array, reversed) {
    const name = `babylon_${kind}${array && '_csm'}`;
    const texture = kind === 'pcf' ? `shadow${array && '_array'}` : array ? 'array' : 'texture_2d';
    return { name, binding: { texture, outside: 'bordered', direction: reversed && kind === 'pcf' ? 'reversed' : 'forward' } };
}

/** A depth in a cascade, whose planes hold the casters beyond it. Nearer than an empty texel, as the sampler compares by less. */
const clamped = (z, pcss, reversed) => `clamp(${z}, ${reversed && !pcss ? '1.1754944e-38, 1.0' : '0.0, 0.99999994'})`;

function body_of(name, kind, array, asked) {
    const language = languages[name], { vec4 } = language, word = words[name], pcss = kind === 'pcss';
    const lit = map_of(kind, array, asked.reversed), maps = word.maps(pcss);
    const radius = pcss
        ? light_radius(language, `lightSizeUV${array && ' * lightSizeUVCorrection.x * depthCorrection'}`) : undefined;
    const z = pcss ? 'depthMetric' : word.z;
    return `${language.local('vec3')} clipSpace = vPositionFromLight.xyz / vPositionFromLight.w;
    ${language.local('vec3')} uvDepth = 0.5 * clipSpace + 0.5;
    ${language.local('vec2')} size = ${word.size(maps)};
    ${filtered(language, asked, {
        map: lit.name, maps, size: 'size', at: 'uvDepth.xy * size', layer: array ? word.layer : undefined,
        z: array ? clamped(z, pcss, asked.reversed) : z,
        further: further_arguments(asked.filter, asked.given,
            { rotation: `umbrage_disc_rotation(${asked.frame ? 'umbrage_turned()' : word.pixel})`, radius, vec4 }),
    })}    return computeFallOff(mix(darkness, 1.0, umbrage_receiver.w), clipSpace.xy, frustumEdgeFalloff);\n`;
}

/** Babylon.js' text with the given filters in place of its own. */
function with_filters(name, own, asked) {
    const language = languages[name], items = [language.rotation];
    let text = own;
    for (const [kind, options] of Object.entries(asked))
        for (const array of ['', 'Array']) {
            const { name: map, binding } = map_of(kind, array, options.reversed);
            items.push(language.bind(options.filter, map, binding));
            if (options.probe) items.push(language.bind(language.probe_color, map, binding));
            for (const called of functions[kind])
                text = with_body(where, text, heads[name](called, kind === 'pcss', array),
                    body_of(name, kind, array, options), known);
        }
    const place = '#ifdef SHADOWS\n', [probe, frame] = ['probe', 'frame'].map(flag => Object.values(asked).some(all => all[flag]));
    must(where, text.startsWith(place), known, `another beginning of ${shadows}`);
    const turned = frame ? turned_pixel[name](words[name].pixel) : '';
    return `${place}${globals(language, probe)}${turned}${language.text(items)}\n${text.slice(place.length)}`;
}

/** Puts a filter in place of Babylon.js' own, for all lights and materials of a page. */
export function install(engine, options = {}) {
    check_engine(where, engine);
    must(where, engine.isWebGPU || engine.version >= 2, 'engine must have WebGL 2 or WebGPU', `WebGL ${engine.version}`);
    const name = engine.isWebGPU ? 'wgsl' : 'glsl', store = stores[name];
    const asked = checked_options(where, name, options, { scene: scene_of_babylon });
    const kind = asked.filter.filter.reads === 'depths' ? 'pcss' : 'pcf';
    const { own, reversed, kinds } = installed.get(name) ?? {
        own: { [shadows]: store[shadows], [last]: store[last] }, reversed: engine.useReverseDepthBuffer, kinds: {} };
    must(where, engine.useReverseDepthBuffer === reversed,
        `engine.useReverseDepthBuffer must be ${reversed}, as at the page's first install: call uninstall(engine) before`,
        engine.useReverseDepthBuffer);
    const all = { ...kinds, [kind]: { ...asked, reversed } };
    store[shadows] = with_filters(name, own[shadows], all);
    store[last] = Object.values(all).some(({ probe }) => probe)
        ? `#if defined(SHADOWS)\n${words[name].color}\n#endif\n${own[last]}` : own[last];
    installed.set(name, { own, reversed, kinds: all });
    in_use[name] = all;
    if (turning()) turn_by_frame(options.scene);
    else stop_turning();
    compile_again(engine, options.scene);
}

/** Restores Babylon.js' own text, byte for byte. */
export function uninstall(engine, options = {}) {
    check_engine('babylon: uninstall', engine);
    check_options('babylon: uninstall', options, { scene: scene_of_babylon });
    const name = engine.isWebGPU ? 'wgsl' : 'glsl', { own } = installed.get(name) ?? {};
    Object.assign(stores[name], own);
    installed.delete(name);
    in_use[name] = {};
    if (!turning()) stop_turning();
    compile_again(engine, options.scene);
}

/** Whether a filter that is installed rotates from frame to frame. */
const turning = () => [...installed.values()].some(({ kinds }) => Object.values(kinds).some(({ frame }) => frame));

function check_engine(where, engine) {
    must(where, engine instanceof AbstractEngine, 'engine must be an engine of this copy of @babylonjs/core', engine);
}

function compile_again(engine, scene) {
    if (!scene) return;
    engine.releaseEffects();
    for (const mesh of scene.meshes) mesh.resetDrawCache();
}
