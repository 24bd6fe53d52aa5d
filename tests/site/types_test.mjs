// SPDX-License-Identifier: MIT
//
// The site's scripts, by TypeScript at its strictest:  node types_test.mjs SOURCES NODE_MODULES
import { execFileSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { join } from 'node:path';

const [sources, node_modules] = process.argv.slice(2), tsc = join(node_modules, 'typescript/bin/tsc');
if (!existsSync(tsc)) {
    console.log(`SKIPPED: no typescript in ${node_modules}`);
    process.exit(77);
}
try {
    execFileSync(process.execPath, [tsc, '-p', sources], { encoding: 'utf8' });
} catch (error) {
    console.log(error.stdout);
    process.exit(1);
}
