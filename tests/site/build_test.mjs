// SPDX-License-Identifier: MIT
//
// Builds the site, as `make site` does:  node build_test.mjs SOURCES OUT NODE_MODULES WORK MUSEUM
import { execFileSync } from 'node:child_process';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

const [sources, out, node_modules, work, museum] = process.argv.slice(2);
const { missing } = await import(pathToFileURL(join(sources, 'context.mjs')));
const what = missing(node_modules);
if (what) {
    console.log(`SKIPPED: ${what}`);
    process.exit(77);
}
execFileSync(process.execPath, [join(sources, 'build.mjs'), out, node_modules, work, museum], { stdio: 'inherit' });
