// SPDX-License-Identifier: MIT
//
// The bias page's emulation of engines against the one in C++, which rays judge: with the engines' defaults, alike shares of
// lone planes are falsely dark.
//     node engines_test.mjs ROOT NODE_MODULES SHARES
import { existsSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const [root, node_modules, shares] = process.argv.slice(2).map(path => resolve(path));
if (!existsSync(join(node_modules, 'esbuild'))) {
    console.log(`SKIPPED: no esbuild in ${node_modules}`);
    process.exit(77);
}
const load = createRequire(join(node_modules, 'x.js'));
const { outputFiles } = await load('esbuild').build({ entryPoints: [join(root, 'examples/site/bias/emulate.ts')], bundle: true, format: 'esm', write: false });
const { falsely_dark } = await import(`data:text/javascript,${encodeURIComponent(outputFiles[0].text)}`);
const { engine_bias, engines, light_of } = await import(pathToFileURL(join(root, 'single_include/npm/engines.mjs')).href);

const most = 0.03;  // of 8,000 receivers there and 4,000 here, a standard deviation is 0.01 at most
let failed = 0, worst = 0;
const lines = readFileSync(shares, 'utf8').trim().split('\n').map(line => line.split('\t'));
for (const [engine, filter, inner, width, range, wanted] of lines) {
    const { border = 0 } = engines[engine];
    const map = { engine, filter, map_size: Number(inner) + 2 * border, width: Number(width), range: Number(range) };
    const share = falsely_dark(engines[engine], light_of(map), engine_bias(map).defaults.settings, at => at * 89 * Math.PI / 180, 4000);
    const off = Math.abs(share - Number(wanted));
    worst = Math.max(worst, off);
    if (off <= most) continue;
    ++failed;
    console.log(`FAILED: ${engine}, ${filter}, ${width}: ${share}, in C++ ${wanted}`);
}
console.log(`${lines.length} shares, ${worst.toFixed(4)} off at most`);
process.exitCode = failed || lines.length < 40 ? 1 : 0;
