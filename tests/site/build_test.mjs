// SPDX-License-Identifier: MIT
//
// Builds the site, as `make site` does:  node build_test.mjs SOURCES OUT NODE_MODULES WORK
import { execFileSync, spawnSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { join } from 'node:path';

const [sources, out, node_modules, work] = process.argv.slice(2);
const skip = why => { console.log(`SKIPPED: ${why}`); process.exit(77); };
for (const needed of ['esbuild', 'marked', 'prismjs', 'gl-matrix', '@gltf-transform/core'])
    if (!existsSync(join(node_modules, needed))) skip(`no ${needed} in ${node_modules}`);
if (spawnSync('emcc', ['--version'], { env: { ...process.env, NODE_PATH: '/usr/share/nodejs' } }).status !== 0) skip('no emscripten');
execFileSync(process.execPath, [join(sources, 'build.mjs'), out, node_modules, work], { stdio: 'inherit' });
