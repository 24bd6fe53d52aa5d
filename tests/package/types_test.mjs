// SPDX-License-Identifier: MIT
//
// The package's types, by TypeScript at its strictest: what is right compiles, what is wrong does not.
//     node types_test.mjs PACKAGE FOLDER NODE_MODULES
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';

const [umbrage, folder, node_modules] = process.argv.slice(2).map(path => resolve(path));
const tsc = join(node_modules, 'typescript/bin/tsc');
if (!existsSync(tsc)) {
    console.log(`SKIPPED: no typescript in ${node_modules}`);
    process.exit(77);
}
rmSync(folder, { recursive: true, force: true });
mkdirSync(join(folder, 'node_modules'), { recursive: true });
symlinkSync(umbrage, join(folder, 'node_modules/umbrage'));

const program = `
import { adaptive_pages, bind, box, cascades, debug, encodings, exactness, pcf_2x2, pcss16, rg11, shadow, snippets, source, supports, text, versions } from 'umbrage';
import type { Binding, Bound, Encoding, Exactness, Filter, Shadow, Snippet, SnippetName, Texture, Version } from 'umbrage';
import * as hlsl from 'umbrage/hlsl';
import * as msl from 'umbrage/msl';
import { load_values, webgpu_clip_space } from 'umbrage/values';
import * as wgsl from 'umbrage/wgsl';

const version: Version = versions[0] ?? '300 es', texture: Texture = 'array', map: Binding = { texture, gather: true };
const item: Bound = bind(pcf_2x2, 'sun', map), packed: Encoding = encodings.rg11, tier: Exactness = exactness([item, box]);
const name: SnippetName = 'box', by_name: Snippet = snippets[name], cleared: number = rg11.reversed.cleared[0];
export const all: string[] = [source(version, [item]), text([bind(box, '', packed)], '450'), tier, String(cleared),
    String(by_name.needs.length), String(supports(item, version))];
const in_wgsl: wgsl.Bound = wgsl.bind(wgsl.box, 'sun', wgsl.rg11.reversed);
all.push(wgsl.text([wgsl.pcf_2x2, in_wgsl]), hlsl.text([hlsl.pcf_2x2]), msl.text([]), wgsl.exactness([wgsl.box]));
const soft: Filter | undefined = pcss16.filter, first: wgsl.WgslFunction | undefined = wgsl.functions([wgsl.box, in_wgsl])[0];
all.push(text([bind(rg11.write, 'sun', { direction: 'reversed' })]), String(soft?.reach), ...first?.needs ?? []);
const sun: Shadow = shadow('sun', { kind: cascades, filter: pcss16, encoding: rg11, map_size: [512, 512], direction: 'reversed' });
all.push(source('300 es', [sun]), text([sun.depth_pass], '450'), String(sun.cleared[0]), sun.target.format, String(sun.bytes));
const debugged: Shadow = shadow('lit', { kind: cascades, filter: pcss16, map_size: 512, debug });
all.push(text([debugged], '450'), text([debugged.vertex_pass(webgpu_clip_space)], '450'));
export async function floats(): Promise<Float32Array> {
    const values = await load_values();
    const { block, matrices } = values(sun, { clip: webgpu_clip_space, scene: { low: [-9, 0, -9], high: [9, 3, 9] }, camera:
        { view: new Float32Array(16), projection: new Float64Array(16), z_near: 1, z_far: 9 }, filter: { light_size: 0.1, max_radius: 6 } });
    const pages: Shadow = shadow('pages', { kind: adaptive_pages, filter: box, map_size: 136 }), camera =
        { view: new Float32Array(16), projection: new Float32Array(16), z_near: 1, z_far: 9 };
    values(pages, { clip: webgpu_clip_space, scene: { low: [-9, 0, -9], high: [9, 3, 9] }, camera, picture: [640, 360],
        points: new Float32Array(4), normals: [0, 1, 0, 0] });
    // @ts-expect-error no clip space
    values(sun, { position: [0, 0, 0] });
    return matrices[0] ?? block;
}

// @ts-expect-error another language's kind
shadow('sun', { kind: wgsl.cascades, filter: pcss16, map_size: 512 });
// @ts-expect-error another language's debug functions
shadow('sun', { kind: cascades, filter: pcss16, map_size: 512, debug: wgsl.debug });
// @ts-expect-error no clip space
sun.vertex_pass('webgpu');
// @ts-expect-error no size
shadow('sun', { kind: cascades, filter: pcss16 });
// @ts-expect-error another language's
wgsl.text([pcf_2x2]);
// @ts-expect-error another language's, bound
text([in_wgsl]);
// @ts-expect-error another language's encoding
bind(pcf_2x2, 'sun', wgsl.rg11);
// @ts-expect-error no such texture
bind(pcf_2x2, 'sun', { texture: '3d' });
// @ts-expect-error no such property
bind(pcf_2x2, 'sun', { size: 3 });
// @ts-expect-error no such version
source('200', [pcf_2x2]);
// @ts-expect-error WGSL has no versions
wgsl.text([wgsl.pcf_2x2], '450');
// @ts-expect-error constants
rg11.format = 'R8';
// @ts-expect-error no such encoding
encodings.rg17;
// @ts-expect-error no such snippet
bind(snippets.pcf_3x3, 'sun');
// @ts-expect-error no such snippet
wgsl.snippets['pcf_3x3'];
`;
const addons = `
import { pcss16 } from 'umbrage';
import * as babylon from 'umbrage/babylon';
import { engine_bias, engines, type Bias } from 'umbrage/engines';
import * as playcanvas from 'umbrage/playcanvas';
import { fit_shadow, install, set_light_size, uninstall, type Fitted } from 'umbrage/three';
import { fit_shadow as fit_in_webgpu, shadow_filter } from 'umbrage/three/webgpu';
import * as wgsl from 'umbrage/wgsl';

declare const THREE: import('umbrage/three').Three, renderer: object;
install(THREE, renderer, { filter: pcss16, arguments: { softness: [0.0625, 0.0625, 16, 96] }, probe: true, frame: true });
uninstall(THREE);
const low = { x: 0, y: 0, z: 0 }, fitted: Fitted = fit_shadow({}, { receivers: { min: low, max: low }, steady: true });
export const numbers: number[] = [fitted.texels_per_unit, fitted.detachment ?? 0, fitted.cascades?.finer ?? 1];
set_light_size({}, 0.1);
// @ts-expect-error no size
set_light_size({});
const bias: Bias = engine_bias({ engine: 'godot', map_size: 2048, width: 40, range: 100 });
numbers.push(bias.settings['shadow_bias'] ?? 0, bias.detachment, bias.striped?.[0] ?? 0, bias.defaults.lacking);
export const title: string = engines.bevy.title;
numbers.push(engine_bias({ engine: 'bevy', light: 'spot', map_size: 1024, angle: 60, range: 10 }).detachment);
// @ts-expect-error no angle
engine_bias({ engine: 'bevy', light: 'spot', map_size: 1024, range: 10 });
// @ts-expect-error no such engine
engine_bias({ engine: 'unreal', map_size: 2048, width: 40, range: 100 });
// @ts-expect-error no range
engine_bias({ engine: 'godot', map_size: 2048, width: 40 });
// @ts-expect-error no receivers
fit_in_webgpu({}, { casters: [{ min: low, max: low }] });
// @ts-expect-error no such option
fit_shadow({}, { receivers: [{ min: low, max: low }], bias: 0 });
shadow_filter({ wgsl: wgsl.pcss16, glsl: pcss16, frame: true });
// @ts-expect-error a filter in another language
install(THREE, renderer, { filter: wgsl.pcss16 });
// @ts-expect-error no filter
shadow_filter({});
declare const engine: babylon.Engine, scene: babylon.Scene, device: playcanvas.Device, light: playcanvas.Light;
babylon.install(engine, { glsl: pcss16, wgsl: wgsl.pcss16, arguments: { softness: [0.0625, 0.0625, 16, 96] }, probe: true, frame: true, scene });
babylon.uninstall(engine, { scene });
babylon.set_light_size({}, 0.1);
export const of_babylon: babylon.Fitted = babylon.fit_bias({}, { receivers: scene.meshes as never[], steady: true });
// @ts-expect-error no such option
babylon.fit_bias({}, { camera: {} });
playcanvas.set_light_size(light, 0.1);
export const of_playcanvas: number[] = (playcanvas.fit_bias(light, { camera: {} }).cascades ?? []).map(({ texels_per_unit }) => texels_per_unit);
// @ts-expect-error no light
playcanvas.fit_bias();
playcanvas.install(device, { glsl: pcss16, wgsl: wgsl.pcss16, frame: true, lights: [light] });
playcanvas.uninstall(device);
// @ts-expect-error a filter in another language
babylon.install(engine, { wgsl: pcss16 });
// @ts-expect-error a filter in another language
playcanvas.install(device, { glsl: wgsl.pcss16 });
`;
for (const file of ['addons.mts', 'addons.cts']) writeFileSync(join(folder, file), addons);
writeFileSync(join(folder, 'import.mts'), program);
writeFileSync(join(folder, 'require.cts'), program);
writeFileSync(join(folder, 'bundled.ts'), program);
let failed = false;
for (const [module, resolution, files] of [['nodenext', 'nodenext', ['import.mts', 'require.cts', 'addons.mts', 'addons.cts']], ['esnext', 'bundler', ['bundled.ts']]]) {
    const options = ['--noEmit', '--strict', '--noUncheckedIndexedAccess', '--exactOptionalPropertyTypes', '--target', 'es2022',
        '--module', module, '--moduleResolution', resolution];
    try {
        execFileSync(process.execPath, [tsc, ...options, ...files], { cwd: folder, encoding: 'utf8' });
        console.log(`ok: ${files.join(', ')}, module resolution of ${resolution}`);
    } catch (error) {
        console.log(`FAILED: ${files.join(', ')}\n${error.stdout}`);
        failed = true;
    }
}
process.exitCode = failed ? 1 : 0;
