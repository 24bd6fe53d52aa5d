// SPDX-License-Identifier: MIT
//
// Builds the site, as `make site` does:  node build_test.mjs SOURCES OUT NODE_MODULES WORK
import { execFileSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { join } from 'node:path';

const [sources, out, node_modules, work] = process.argv.slice(2);
for (const needed of ['esbuild', 'marked', 'prismjs', '@xmldom/xmldom'])
    if (!existsSync(join(node_modules, needed))) {
        console.log(`SKIPPED: no ${needed} in ${node_modules}`);
        process.exit(77);
    }
try {
    execFileSync('doxygen', ['--version']);
} catch {
    console.log('SKIPPED: no doxygen');
    process.exit(77);
}
execFileSync(process.execPath, [join(sources, 'build.mjs'), out, node_modules, work], { stdio: 'inherit' });
