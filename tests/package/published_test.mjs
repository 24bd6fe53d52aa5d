// SPDX-License-Identifier: MIT
//
// The package as others find it: publint and arethetypeswrong look at it, for ES modules; and CommonJS takes it, by the require
// that Node has for ES modules. That gives the module of import, so that snippets of the one are snippets of the other.
//     node published_test.mjs PACKAGE NODE_MODULES
import { spawnSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const [folder, node_modules] = process.argv.slice(2).map(path => resolve(path));
const tools = { publint: ['publint', folder, '--strict'], attw: ['@arethetypeswrong/cli', '--pack', folder, '--profile', 'esm-only', '--format', 'ascii'] };
const left_out = [];
let failed = 0;
for (const [name, [module, ...options]] of Object.entries(tools)) {
    const file = join(node_modules, module, 'package.json');
    const { bin, engines, version } = existsSync(file) ? JSON.parse(readFileSync(file, 'utf8')) : {};
    const [least] = engines?.node.match(/\d+/) ?? [Infinity];
    if (parseInt(process.versions.node) < least) {
        left_out.push(bin ? `${module}, for Node ${least} and later,` : `${module} in ${node_modules}`);
        continue;
    }
    const program = join(node_modules, module, typeof bin === 'string' ? bin : bin[name]);
    const { status, stdout, stderr } = spawnSync(process.execPath, [program, ...options], { encoding: 'utf8' });
    const good = status === 0;
    console.log(`${good ? 'ok' : 'FAILED'}: ${module} ${version}${good ? '' : `\n${stdout}${stderr}`}`);
    failed += !good;
}

const check = (good, what) => { if (!good) ++failed, console.log(`FAILED: ${what}`); };
async function required() {
    const require = createRequire(join(folder, 'x.cjs'));

    // By its name, as users write it: a package finds itself.
    const entries = ['umbrage', 'umbrage/hlsl', 'umbrage/msl', 'umbrage/wgsl', 'umbrage/values', 'umbrage/engines', 'umbrage/three', 'umbrage/three/webgpu',
        'umbrage/babylon', 'umbrage/playcanvas'], all = {}, without = [];
    for (const entry of entries) {
        const file = require.resolve(entry);
        let imported;
        try { imported = await import(pathToFileURL(file).href); } catch (error) {
            if (error.code !== 'ERR_MODULE_NOT_FOUND' || /umbrage/.test(error.message.split(' imported from ')[0])) throw error;
            without.push(`${entry} (${error.message.split("'")[1]})`);
            continue;
        }
        const required = require(entry);
        check(required === imported, `${entry}: require gives another module than import`);
        all[entry] = required;
    }
    const { bind, hard, pcf_2x2, rg11, source } = all.umbrage, wgsl = all['umbrage/wgsl'], { load_values, webgpu_clip_space } = all['umbrage/values'];
    const imported = await import(pathToFileURL(join(folder, 'umbrage.mjs')).href);
    check(imported.text([pcf_2x2]).includes('umbrage_pcf_2x2'), 'text of import takes a snippet of require');
    check(source('300 es', [imported.bind(hard, 'sun', rg11)]).includes('umbrage_hard_sun'), 'source of require takes what bind of import made');
    check(bind(imported.hard, 'sun', imported.rg11).what === hard, 'bind of require takes a snippet and a map of import');
    const lamp = wgsl.shadow('lamp', { kind: wgsl.spot_light, filter: wgsl.hard, map_size: 64 });
    check((await load_values())(lamp, { clip: webgpu_clip_space }).block.byteLength === lamp.bytes, 'values of a shadow');
    check(Object.keys(all).length >= 5, `${Object.keys(all).length} entries by require`);
    console.log(`${Object.keys(all).length} entries by require${without.length ? `; without their engine: ${without.join(', ')}` : ''}`);
}
if (process.features.require_module) await required();
else left_out.push(`require of ES modules, which begins with Node 20.19,`);

if (!failed && left_out.length) console.log(`SKIPPED: no ${left_out.join(' no ')} here`);
process.exitCode = failed ? 1 : left_out.length ? 77 : 0;
