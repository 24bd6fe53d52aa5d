// SPDX-License-Identifier: MIT
//
// three.js with WebGPURenderer: a light's filter node, of the filters of this package. Each light may have its own; three's
// bias, normalBias and intensity keep their meaning. Point lights keep three's own filter, with a warning.
//
//     import * as wgsl from 'umbrage/wgsl';
//     import { shadow_filter } from 'umbrage/three/webgpu';
//     light.shadow.filterNode = shadow_filter({ wgsl: wgsl.pcss16 });
import { BasicShadowMap, NearestFilter, REVISION } from 'three/webgpu';
import * as TSL from 'three/tsl';
import { bind as bind_glsl, disc_rotation as rotation_glsl, text } from '../umbrage.mjs';
import { bind, disc_rotation, functions, probe_color } from '../wgsl.mjs';
import { in_use } from './three_fit.mjs';
import {
    check_filter, check_options, checked_arguments, checked_later, flag, further_arguments, must, turn_of_frame,
} from './options.mjs';

export { fit_shadow } from './three_fit.mjs';
export { set_light_size } from './three_light_size.mjs';

const property_of_tsl = ["a property of TSL, such as property('vec4', 'color')", value => value?.isNode === true];
const known = {
    wgsl: checked_later, glsl: checked_later, arguments: checked_later, frame: flag, probe: property_of_tsl, receiver: property_of_tsl };
const where = 'three/webgpu: shadow_filter', made = new Map(), pieces = new Map();

/** A node for each function of WGSL: those of equal text are one node, so that several filters share a shader. */
function nodes_of(items) {
    return functions(items).map(({ text: piece }) => {
        if (!pieces.has(piece)) pieces.set(piece, TSL.wgsl(`${piece}\n`));
        return pieces.get(piece);
    });
}

/** A call of the filter is also its key: equal texts are one function. */
function call_of(filter, given, map, coord, vec4) {
    const further = further_arguments(filter, given, { rotation: 'umbrage_disc_rotation(pixel)', radius: 'radius', vec4 });
    return `umbrage_${filter.name}_${map}(map, size, ${coord}, receiver${further})`;
}

function function_of(filter, given, language, direction) {
    const map = `three_${direction}`, binding = { texture: 'depth', direction, outside: 'bordered' };
    const call = language === 'wgsl' ? call_of(filter, given, map, 'uv * size', 'vec4f')
        : call_of(filter, given, map, 'vec2(uv.x, 1.0 - uv.y) * size', 'vec4');
    if (made.has(call)) return made.get(call);
    const name = `umbrage_three_${filter.name}_${made.size}`;
    const node = language === 'wgsl'
        ? TSL.wgslFn(`fn ${name}(map: texture_depth_2d, size: vec2f, uv: vec2f, receiver: f32, radius: f32, `
            + `pixel: vec2f) -> f32 {\n    return ${call};\n}`, nodes_of([disc_rotation, bind(filter, map, binding)]))
        // TSL names a parameter of type sampler2D otherwise than it calls it: another word for the type helps
        : TSL.glslFn(`float ${name}(depthTexture map, vec2 size, vec2 uv, float receiver, float radius, `
            + `vec2 pixel) {\n    return ${call};\n}`,
            [TSL.glsl(`\n#define depthTexture highp sampler2D\n${text([rotation_glsl, bind_glsl(filter, map, binding)], '300 es')}`)]);
    made.set(call, node);
    return node;
}

/** What umbrage_probe_color says of a receiver, for a material's outputNode. */
function probe_of(at, size, bias, direction) {
    const map = `three_${direction}`, key = `probe ${direction}`;
    if (!made.has(key))
        made.set(key, TSL.wgslFn(`fn umbrage_three_probe_${direction}(at: vec3f, size: vec2f, bias: f32) -> vec3f {\n`
            + `    return umbrage_probe_color_${map}(at, size, bias, 0.0);\n}`,
            nodes_of([bind(probe_color, map, { texture: 'depth', direction })])));
    return made.get(key)({ at, size, bias });
}

/** three.js' own filter for a point light, with a word about it: its cube has no form of ours. */
function own_point_filter(of_light, { renderer }, name) {
    const own = renderer.shadowMap.type === BasicShadowMap ? TSL.BasicPointShadowFilter : TSL.PointShadowFilter;
    const known_filter = typeof own === 'function', words = 'the light must have one map: a spot, a directional light or a SunLight';
    must(where, known_filter, words, 'a point light');
    console.warn(`umbrage/${where}: ${words}; got a point light. It keeps three.js' own filter in place of ${name}.`);
    return own(of_light);
}

/** A filter node: light.shadow.filterNode = shadow_filter({ wgsl: wgsl.pcss16 }). */
export function shadow_filter(options = {}) {
    check_options(where, options, known);
    const { wgsl, glsl, frame = false, probe, receiver } = options;
    check_filter(where, 'wgsl', wgsl, 'WGSL');
    if (glsl !== undefined) check_filter(where, 'glsl', glsl, 'GLSL');
    must(where, glsl === undefined || glsl.name === wgsl.name, 'glsl must be the same filter in GLSL', glsl?.name);
    const given = checked_arguments(where, wgsl, options.arguments);
    const turn = TSL.uniform(0).setGroup(TSL.renderGroup).onRenderUpdate(({ frameId }) => turn_of_frame(frameId));
    const node = TSL.Fn(({ depthTexture, shadowCoord, shadow, bd3D, dp, distance, texelSize }, builder) => {
        const { renderer } = builder, in_wgsl = renderer.backend.isWebGPUBackend === true;
        must(where, in_wgsl || glsl !== undefined, 'glsl must be given for the WebGL 2 fallback', glsl);
        must(where, renderer.backend.compatibilityMode !== true,
            'the device must have core features: compatibility mode cannot load depths', 'compatibility mode');
        if (shadowCoord === undefined)
            return own_point_filter({ depthTexture, shadow, bd3D, dp, distance, texelSize }, builder, wgsl.name);
        must(where, !renderer.reversedDepthBuffer || shadow.camera?.reversedDepth !== false,
            'three.js must be r187 or later for reversed depth, as it drew maps of forward depth before', `r${REVISION}`);
        must(where, depthTexture.isArrayTexture !== true, 'the map must be one texture', 'an array');
        depthTexture.compareFunction = null;  // depths as they are
        depthTexture.minFilter = depthTexture.magFilter = NearestFilter;
        const of_shadow = (name, type) => TSL.reference(name, type, shadow).setGroup(TSL.renderGroup);
        // the map's own size: a light's mapSize may have changed before a uniform of it has
        const map = TSL.texture(depthTexture), size = TSL.vec2(TSL.textureSize(map)).toVar(), coord = shadowCoord.toVar();
        const direction = renderer.reversedDepthBuffer ? 'reversed' : 'forward';
        const lit = function_of(in_wgsl ? wgsl : glsl, given, in_wgsl ? 'wgsl' : 'glsl', direction)({
            map, size, uv: coord.xy, receiver: coord.z,
            radius: of_shadow('radius', 'float'), pixel: frame ? TSL.screenCoordinate.xy.add(TSL.vec2(0, turn)) : TSL.screenCoordinate.xy }).toVar();
        const at = TSL.vec3((in_wgsl ? coord.xy : TSL.vec2(coord.x, coord.y.oneMinus())).mul(size), coord.z);
        if (receiver) receiver.assign(TSL.vec4(at, lit));
        if (probe && in_wgsl) probe.assign(TSL.vec4(probe_of(at, size, of_shadow('bias', 'float').abs(), direction), 1));
        return lit;
    });
    in_use.nodes.set(node, { filter: wgsl, given });
    return node;
}
