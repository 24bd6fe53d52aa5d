// SPDX-License-Identifier: MIT
//
// Other libraries' shader functions as npm has them: the newest of November 2026. Nothing of their text is kept here.
import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { pathToFileURL } from 'node:url';

/** A module's export in a package. */
const exported = async (file, name = 'default') => (await import(pathToFileURL(file).href))[name];

/** A file of GLSL with what it includes, each file once. */
function included(file, seen = new Set()) {
    if (seen.has(file)) return '';
    seen.add(file);
    return readFileSync(file, 'utf8').replace(/^#include "(.*)"/gm, (_, path) => included(join(dirname(file), path), seen)) + '\n';
}

const three = chunk => folder => exported(join(folder, `src/renderers/shaders/ShaderChunk/${chunk}.glsl.js`));
const babylon = (...includes) => async folder => (await Promise.all(includes.map(include =>
    exported(join(folder, `Shaders/ShadersInclude/${include}.js`), include)))).map(each => each.shader).join('\n');
const playcanvas = chunk => folder =>
    exported(join(folder, `build/playcanvas/src/scene/shader-lib/glsl/chunks/${chunk}.js`));
const lygia = path => folder => included(join(folder, path));
const cesium = (...names) => folder =>
    names.map(name => readFileSync(join(folder, `Source/Shaders/Builtin/Functions/${name}.glsl`), 'utf8')).join('\n');

/** What the engines' own preambles define for WebGL 2, where a text needs it. */
const counts = ['SPOT_LIGHT_COORDS', 'SPOT_LIGHT_MAPS', 'DIR_LIGHT_SHADOWS', 'SPOT_LIGHT_SHADOWS', 'POINT_LIGHT_SHADOWS'];
const three_defines = type => `#define USE_SHADOWMAP\n#define SHADOWMAP_TYPE_${type}\n#define texture2D texture\n` +
    counts.map(name => `#define NUM_${name} 0\n`).join('');
/** Functions that take one size for both sides of a map: to them it is the first rows of a square one. */
const of_square = `vec3 of_square(sampler2DShadow map) {
    vec2 size = vec2(textureSize(map, 0));
    return vec3(1.0, size.x / size.y, 1.0);
}\n`;
const square_uv = 'vec2(uv.x, uv.y * size.y / size.x)';
const babylon_defines = `#define SHADOWS\n#define WEBGL2\n#define inline\n#define SHADOWFLOAT
#define IS_NDC_HALF_ZRANGE\n#define texture2D texture\n#define textureCube texture
`;
const babylon_square = `${babylon_defines}${of_square}float texture2DLodEXT(sampler2DShadow map, vec3 at, float level) { return texture(map, at * of_square(map)); }
vec4 texture2DLodEXT(sampler2D map, vec2 at, float level) { return textureLod(map, at, level); }\n`;
const playcanvas_defines = `#define SHADOWMAP_ACCEPT(name) sampler2DShadow name\n#define SHADOWMAP_PASS(name) name
${of_square}#define textureShadow(map, coord) texture(map, (coord) * of_square(map))\n#define saturate(x) clamp(x, 0.0, 1.0)\n`;
const cesium_defines = `struct czm_shadowParameters {
    vec2 texelStepSize; float depthBias; float depth; float nDotL; vec2 texCoords; float normalShadingSmooth; float darkness;
};\n#define czm_textureCube texture\n#define USE_SHADOW_DEPTH_TEXTURE\n`;
const cesium_call = 'czm_shadowVisibility(map, czm_shadowParameters(1.0 / size, 0.0, z, 1.0, uv, 0.0, 0.0))';
const soft = '#define USE_SOFT_SHADOWS\n';
const clip = `vec4(${square_uv} * 2.0 - 1.0, z, 1.0)`;

/** A function of a package: what the authors say of it, where it matters, and what it should be, where its name says so. */
const f = (title, text, call, { before = '', promise = '', is = '', kind = '' } = {}) =>
    ({ title, text, call, before, promise, is, kind });
const babylon_pcf = babylon('helperFunctions', 'shadowsFragmentFunctions'), inverse = 'vec2(size.x, 1.0 / size.x)';
const playcanvas_pcf = (side, promise) => f(`getShadowPCF${side}x${side}`, playcanvas(`lit/frag/lighting/shadowPCF${side}`),
    `getShadowPCF${side}x${side}(shadow_map, vec3(${square_uv}, z), vec4(size.x))`, { before: playcanvas_defines, promise });
const cesium_visibility = cesium('unpackDepth', 'shadowDepthCompare', 'shadowVisibility');

export const packages = [
    { name: 'three', version: '0.187.0', functions: [
        f('packDepthToRGBA', three('packing'), 'packDepthToRGBA(z)', { is: 'threejs_rgba' }),
        f('packDepthToRGB', three('packing'), 'vec4(packDepthToRGB(z), 0.0)', { is: 'threejs_rgb' }),
        f('packDepthToRG', three('packing'), 'vec4(packDepthToRG(z), 0.0, 0.0)', { is: 'threejs_rg' }),
        f('unpackRGBAToDepth', three('packing'), 'unpackRGBAToDepth(c)'),
        f('unpackRGBToDepth', three('packing'), 'unpackRGBToDepth(c.xyz)'),
        f('unpackRGToDepth', three('packing'), 'unpackRGToDepth(c.xy)'),
        f('getShadow, BasicShadowMap', three('shadowmap_pars_fragment'), 'getShadow(map, size, 1.0, 0.0, 1.0, vec4(uv, z, 1.0))',
            { before: three_defines('BASIC'), promise: 'unfiltered' }),
        f('getShadow, VSMShadowMap', three('shadowmap_pars_fragment'), 'getShadow(map, size, 1.0, 0.0, 1.0, vec4(uv, z, 1.0))',
            { before: three_defines('VSM'), promise: 'mean and deviation', kind: 'bound' }),
    ] },
    { name: '@babylonjs/core', version: '9.35.0', functions: [
        f('pack', babylon('packingFunctions'), 'pack(z)'),
        f('unpack', babylon('packingFunctions'), 'unpack(c)'),
        f('computeShadowWithPCF1', babylon_pcf, 'computeShadowWithPCF1(vec4(uv * 2.0 - 1.0, z, 1.0), z, shadow_map, 0.0, 0.0)',
            { before: `${babylon_defines}#define texture2DLodEXT textureLod\n` }),
        f('computeShadowWithPCF3', babylon_pcf, `computeShadowWithPCF3(${clip}, z, shadow_map, ${inverse}, 0.0, 0.0)`,
            { before: babylon_square }),
        f('computeShadowWithPCF5', babylon_pcf, `computeShadowWithPCF5(${clip}, z, shadow_map, ${inverse}, 0.0, 0.0)`,
            { before: babylon_square }),
    ] },
    { name: 'playcanvas', version: '2.23.3', functions: [
        f('float2uint', playcanvas('common/frag/float-as-uint'), 'float2uint(z)'),
        playcanvas_pcf(1), playcanvas_pcf(3), playcanvas_pcf(5),
        f('chebyshevUpperBound', playcanvas('lit/frag/lighting/shadowEVSM'), 'chebyshevUpperBound(texture(map, uv).xy, z, 0.0001, 0.1)',
            { kind: 'bound', before: `${playcanvas_defines}#define TEXTURE_ACCEPT(name) sampler2D name\n#define TEXTURE_PASS(name) name
#define texture2DLod textureLod\n` }),
    ] },
    { name: '@cesium/engine', version: '26.3.0', functions: [
        f('czm_packDepth', cesium('packDepth'), 'czm_packDepth(z)', { promise: 'unsigned bytes' }),
        f('czm_unpackDepth', cesium('unpackDepth'), 'czm_unpackDepth(c)', { promise: 'depths in [0, 1)' }),
        f('czm_shadowVisibility', cesium_visibility, cesium_call, { before: cesium_defines }),
        f('czm_shadowVisibility, soft', cesium_visibility, cesium_call, { before: cesium_defines + soft }),
    ] },
    { name: 'lygia', version: '1.4.1', functions: [
        f('pack', lygia('math/pack.glsl'), 'pack(z)', { promise: "three.js' of then" }),
        f('unpack', lygia('math/unpack.glsl'), 'unpack(c)', { promise: "three.js' of then" }),
        f('sampleShadow', lygia('sample/shadow.glsl'), 'sampleShadow(map, uv, z)'),
        f('sampleShadowLerp', lygia('sample/shadowLerp.glsl'), 'sampleShadowLerp(map, size, uv, z)', { promise: 'PCF' }),
        f('sampleShadowPCF', lygia('sample/shadowPCF.glsl'), 'sampleShadowPCF(map, size, uv, z)', { promise: 'PCF' }),
    ] },
];
