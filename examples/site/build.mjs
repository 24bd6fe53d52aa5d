// SPDX-License-Identifier: MIT
//
// Builds the site:  node build.mjs OUT NODE_MODULES WORK
//
// OUT is emptied first. WORK keeps what is slow to make again: WebAssembly, the XML of Doxygen. Each part of the site is a
// folder here with a module pages.mjs, whose function pages(context) returns [{path, html}].
import { rmSync } from 'node:fs';
import { resolve } from 'node:path';

import { make_context } from './context.mjs';

const [out, node_modules, work] = process.argv.slice(2).map(path => resolve(path));
const parts = ['front', 'proof'];

rmSync(out, { recursive: true, force: true });
const context = await make_context({ out, node_modules, work });
for (const part of parts) {
    const { pages } = await import(`./${part}/pages.mjs`);
    for (const { path, html } of await pages(context)) context.write(path, html);
}
context.copy('examples/site/style.css', 'style.css');
context.copy('examples/site/icon.svg', 'icon.svg');
console.log(`site: ${context.written.length} files in ${out}`);
