// SPDX-License-Identifier: MIT
//
// The packing and shadow shaders of the npm packages under PREFIX, as they are, into FOLDER/*.glsl, and the packages'
// versions into FOLDER/*.version.
//
//     node peers.mjs PREFIX FOLDER
import {mkdirSync, readFileSync, writeFileSync} from 'node:fs';
import {resolve} from 'node:path';
import {pathToFileURL} from 'node:url';

const [prefix, folder] = process.argv.slice(2);
const modules = resolve(prefix, 'node_modules');
const load = path => import(pathToFileURL(resolve(modules, path)));

const {ShaderChunk} = await load('three/build/three.module.js');
// Vulkan has uniforms in blocks and no varyings: the caller of these functions declares them.
const without_declarations = text => text.replace(/^\s*(uniform|varying) .*;$/gm, '');
const of_light_0 = text => text.replaceAll(/\{[Xi]\}/g, '0');
// Varyings for all cascades, of which one is used, become calls.
const in_fragment = text => text.replaceAll(/(vPositionFromLight0|vDepthMetric0)\[(\w+)\]/g, '$1_at($2)');
const babylon = async name => (await load(`@babylonjs/core/Shaders/ShadersInclude/${name}.js`))[name].shader;
const playcanvas = async path =>
    (await load(`playcanvas/build/playcanvas/src/scene/shader-lib/glsl/chunks/${path}.js`)).default;

const packages = {three: 'three', babylon: '@babylonjs/core', playcanvas: 'playcanvas'};
const texts = {
    three: ShaderChunk.packing,
    three_shadow: without_declarations(ShaderChunk.shadowmap_pars_fragment),
    babylon: await babylon('packingFunctions'),
    babylon_helpers: await babylon('helperFunctions'),
    babylon_shadow: await babylon('shadowsFragmentFunctions'),
    babylon_light: in_fragment(of_light_0(await babylon('lightFragment'))),
    playcanvas: await playcanvas('common/frag/float-as-uint'),
    playcanvas_shadow: (await Promise.all(['PCF1', 'PCF3', 'PCF5'].map(
        name => playcanvas(`lit/frag/lighting/shadow${name}`)))).join('\n'),
    playcanvas_evsm: await playcanvas('lit/frag/lighting/shadowEVSM'),
    playcanvas_light: of_light_0(await playcanvas('lit/frag/lighting/shadowCascades') +
        await playcanvas('lit/frag/lighting/lightFunctionShadow')),
    playcanvas_pcss: await playcanvas('lit/frag/lighting/shadowSoft'),
};

mkdirSync(folder, {recursive: true});
for (const [name, text] of Object.entries(texts)) {
    if (!text) throw new Error(`${name}: no shader where it used to be`);
    writeFileSync(resolve(folder, `${name}.glsl`), text + '\n');
}
for (const [name, path] of Object.entries(packages)) {
    const {version} = JSON.parse(readFileSync(resolve(modules, path, 'package.json')));
    writeFileSync(resolve(folder, `${name}.version`), version);
}
