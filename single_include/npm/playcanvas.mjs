// SPDX-License-Identifier: MIT
//
// PlayCanvas: the filters of this package on its own shadow maps, for every material that receives shadows. Its shadowBias,
// normalOffsetBias and penumbraSize keep their meaning. One filter for each kind of shadow: filters that compare replace
// SHADOW_PCF3_* and SHADOW_PCF5_*, those that search for blockers replace SHADOW_PCSS_32F of directional lights.
//
//     import { castano_dyadic5 } from 'umbrage';
//     import * as wgsl from 'umbrage/wgsl';
//     import { install } from 'umbrage/playcanvas';
//     install(app.graphicsDevice, { glsl: castano_dyadic5, wgsl: wgsl.castano_dyadic5 });  // before the first frame
import {
    AppBase, GraphicsDevice, ShaderChunks, SHADERLANGUAGE_GLSL, SHADERLANGUAGE_WGSL,
    SHADOW_PCF3_16F, SHADOW_PCF3_32F, SHADOW_PCF5_16F, SHADOW_PCF5_32F, SHADOW_PCSS_32F,
} from 'playcanvas';
import { checked_options, filtered, globals, languages, light_radius, with_body } from './engine_text.mjs';
import { further_arguments, must, turn_of_frame } from './options.mjs';
import { in_use } from './playcanvas_fit.mjs';

export { fit_bias } from './playcanvas_fit.mjs';

const where = 'playcanvas: install', known = 'playcanvas must have the shadow chunks of 2.23';
const lights_of_entities = ['an array of light components, such as [entity.light]',
    value => Array.isArray(value) && Array.from(value).every(light => light?.shadowType !== undefined && light.system?.app?.scene)];
const installed = new WeakMap();  // device -> PlayCanvas' own chunks, and the options of each kind
const turned = new WeakMap();  // device -> the handle of what turns its discs in each frame

/** Shadow types of each kind. */
const types = { pcf: { SHADOW_PCF3_16F, SHADOW_PCF3_32F, SHADOW_PCF5_16F, SHADOW_PCF5_32F }, pcss: { SHADOW_PCSS_32F } };
const reached = {
    pcf: 'directional lights, spot lights or clustered lights with SHADOW_PCF3_* or SHADOW_PCF5_*',
    pcss: 'directional lights with SHADOW_PCSS_32F',
};

/** The function of each chunk that is replaced, by its head as PlayCanvas writes it. */
const heads = {
    glsl: {
        pcf: {
            shadowPCF3PS: 'float _getShadowPCF3x3(SHADOWMAP_ACCEPT(shadowMap), vec3 shadowCoord, vec3 shadowParams) {',
            shadowPCF5PS: 'float _getShadowPCF5x5(SHADOWMAP_ACCEPT(shadowMap), vec3 shadowCoord, vec3 shadowParams) {',
        },
        pcss: {
            shadowSoftPS: 'float PCSSDirectional(TEXTURE_ACCEPT(shadowMap), vec3 shadowCoords, vec4 cameraParams, '
                + 'vec4 softShadowParams) {',
        },
    },
    wgsl: {
        pcf: {
            shadowPCF3PS: 'fn _getShadowPCF3x3(shadowMap: texture_depth_2d, shadowMapSampler: sampler_comparison, '
                + 'shadowCoord: vec3f, shadowParams: vec3f) -> f32 {',
            shadowPCF5PS: 'fn _getShadowPCF5x5(shadowMap: texture_depth_2d, shadowMapSampler: sampler_comparison, '
                + 'shadowCoord: vec3f, shadowParams: vec3f) -> f32 {',
        },
        pcss: {
            shadowSoftPS: 'fn PCSSDirectional(shadowMap: texture_2d<f32>, shadowMapSampler: sampler, shadowCoords: vec3f, '
                + 'cameraParams: vec4f, softShadowParams: vec4f) -> f32 {',
        },
    },
};
const bindings = { pcf: { texture: 'shadow', outside: 'bordered' }, pcss: { texture: 'texture_2d', outside: 'bordered' } };
const words = {
    glsl: {
        size: 'vec2(textureSize(shadowMap, 0))', sampler: '', pixel: 'gl_FragCoord.xy', turn: 'umbrage_turn',
        uniform: 'uniform highp vec2 umbrage_turn;\n',
        color: 'gl_FragColor = vec4(umbrage_color, 1.0);',
    },
    wgsl: {
        size: 'vec2f(textureDimensions(shadowMap))', sampler: ', shadowMapSampler', pixel: 'pcPosition.xy',
        turn: 'uniform.umbrage_turn', uniform: 'uniform umbrage_turn: vec2f;\n',
        color: 'output.color = vec4f(umbrage_color, 1.0);',
    },
};

function body_of(name, kind, asked) {
    const language = languages[name], word = words[name], pcss = kind === 'pcss', at = pcss ? 'shadowCoords' : 'shadowCoord';
    // a caster as far from its receiver as the planes are apart has a penumbra of penumbraSize times that distance;
    // cameraParams: half a map's width, far, near
    const radius = pcss ? light_radius(language,
        'softShadowParams.z * (cameraParams.y - cameraParams.z) / (2.0 * cameraParams.x) * size.x') : undefined;
    return `${language.local('vec2')} size = ${word.size};
    ${filtered(language, asked, {
        map: `playcanvas_${kind}`, maps: `shadowMap${pcss ? '' : word.sampler}`,
        size: 'size', at: `${at}.xy * size`, z: `${at}.z`,
        further: further_arguments(asked.filter, asked.given,
            { rotation: `umbrage_disc_rotation(${word.pixel}${asked.frame ? ` + ${word.turn}` : ''})`, radius, vec4: language.vec4 }),
    })}    return umbrage_receiver.w;\n`;
}

/** PlayCanvas' chunks with the given filters. A shader may include several of them. */
function with_filters(name, own, asked) {
    const language = languages[name], items = [language.rotation], chunks = { ...own };
    for (const [kind, { filter, probe }] of Object.entries(asked)) {
        items.push(language.bind(filter, `playcanvas_${kind}`, bindings[kind]));
        if (probe) items.push(language.bind(language.probe_color, `playcanvas_${kind}`, bindings[kind]));
    }
    const [probe, frame] = ['probe', 'frame'].map(flag => Object.values(asked).some(options => options[flag]));
    const once = '\n#ifndef UMBRAGE_PLAYCANVAS\n#define UMBRAGE_PLAYCANVAS\n'
        + `${frame ? words[name].uniform : ''}${globals(language, probe)}${language.text(items)}\n#endif\n`;
    for (const [kind, options] of Object.entries(asked))
        for (const [chunk, head] of Object.entries(heads[name][kind]))
            chunks[chunk] = once + with_body(where, own[chunk], head, body_of(name, kind, options), known);
    if (probe) chunks.outputPS += `\n#ifdef UMBRAGE_PLAYCANVAS\n${words[name].color}\n#endif\n`;
    return chunks;
}

/** A light's shadow type, which clusters have in common. */
function shadow_of(light) {
    const { scene } = light.system.app, clustered = scene.clusteredLightingEnabled && light.type !== 'directional';
    return { clustered, type: clustered ? scene.lighting.shadowType : light.shadowType };
}

/** Lights of a device's app whose shadows are of a kind. */
function lights_of(device, kind) {
    const app = AppBase.getApplication();
    if (app?.graphicsDevice !== device) return [];
    return app.root.findComponents('light').filter(
        light => light.castShadows && Object.values(types[kind]).includes(shadow_of(light).type));
}

/** Refuses lights whose shadows PlayCanvas computes by functions that are not replaced. */
function must_reach(lights, kind, filter) {
    for (const light of lights) {
        const { clustered, type } = shadow_of(light);
        const [name = type] = Object.entries({ ...types.pcf, ...types.pcss }).find(([, value]) => value === type) ?? [];
        const good = Object.values(types[kind]).includes(type)
            && (light.type === 'directional' || (kind === 'pcf' && (clustered || light.type === 'spot')));
        must(where, good, `lights must be ${reached[kind]} for ${filter.name}`,
            `${clustered ? 'clustered ' : ''}${light.type} with shadow type ${name}`);
    }
}

/** Sets a uniform of all materials before each frame of an app. */
function turn_by_frame(app, device) {
    if (turned.has(device)) return;
    const turn = device.scope.resolve('umbrage_turn');
    let frame = 0;
    turned.set(device, app.on('prerender', () => turn.setValue([0, turn_of_frame(frame++)])));
}

function stop_turning(device) {
    turned.get(device)?.off();
    turned.delete(device);
}

/** Puts a filter in place of PlayCanvas' own, for all lights and materials of a device. */
export function install(device, options = {}) {
    check_device(where, device);
    const name = device.isWebGPU ? 'wgsl' : 'glsl', chunks = chunks_of(device);
    const asked = checked_options(where, name, options, { lights: lights_of_entities });
    const kind = asked.filter.filter.reads === 'depths' ? 'pcss' : 'pcf';
    must_reach(options.lights ?? lights_of(device, kind), kind, asked.filter);
    must(where, chunks.has('shadowPCF3PS'), 'device must belong to an app that was initialized', 'no chunks');
    const names = ['shadowPCF3PS', 'shadowPCF5PS', 'shadowSoftPS', 'outputPS'];
    const { own, kinds } = installed.get(device)
        ?? { own: Object.fromEntries(names.map(key => [key, chunks.get(key) ?? ''])), kinds: {} };
    const all = { ...kinds, [kind]: asked }, app = AppBase.getApplication();
    must(where, !asked.frame || app?.graphicsDevice === device, 'device must be that of the current app for frame', app?.graphicsDevice);
    chunks.add(with_filters(name, own, all));
    installed.set(device, { own, kinds: all });
    in_use.set(device, all);
    if (Object.values(all).some(({ frame }) => frame)) turn_by_frame(app, device);
    else stop_turning(device);
}

/** Restores PlayCanvas' own text, byte for byte. */
export function uninstall(device) {
    check_device('playcanvas: uninstall', device);
    chunks_of(device).add(installed.get(device)?.own ?? {});
    installed.delete(device);
    in_use.delete(device);
    stop_turning(device);
}

/** Gives a directional light a size in the world: our filters take penumbraSize as the tangent of half its angle. */
export function set_light_size(light, size) {
    const where = 'playcanvas: set_light_size';
    const good = light?.type === 'directional' && 'penumbraSize' in light;
    must(where, good, 'light must be the component of a directional light', light?.type ?? light);
    must(where, Number.isFinite(size) && size >= 0, 'light_size must be finite, 0 or more', size);
    light.penumbraSize = size;
}

function check_device(where, device) {
    must(where, device instanceof GraphicsDevice, 'device must be a graphics device of this copy of playcanvas', device);
}

function chunks_of(device) {
    return ShaderChunks.get(device, device.isWebGPU ? SHADERLANGUAGE_WGSL : SHADERLANGUAGE_GLSL);
}
