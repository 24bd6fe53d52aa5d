// SPDX-License-Identifier: MIT
//
// Builds the site:  node build.mjs OUT NODE_MODULES WORK MUSEUM
//
// OUT is emptied first. WORK keeps what is slow to make again: WebAssembly, the XML of Doxygen. MUSEUM is the program of
// tests/proof/museum, which draws the exhibits. Each part of the site is a folder here with a module pages.mjs, whose
// function pages(context) returns [{path, html}], and perhaps a style.css.
import { existsSync, rmSync } from 'node:fs';
import { join, resolve } from 'node:path';

import { make_context } from './context.mjs';

const [out, node_modules, work, museum] = process.argv.slice(2).map(path => resolve(path));
const parts = ['scene', 'start', 'proof', 'check', 'reference', 'museum', 'snippets', 'bias', 'search'];

rmSync(out, { recursive: true, force: true });
const context = await make_context({ out, node_modules, work, museum });
for (const part of parts) {
    const { pages } = await import(`./${part}/pages.mjs`);
    for (const { path, html } of await pages(context)) context.write(path, html);
}
const styles = ['', ...parts.map(part => `${part}/`)].map(folder => `examples/site/${folder}style.css`);
context.write('style.css', styles.filter(file => existsSync(join(context.root, file))).map(file => context.read(file)).join('\n'));
context.copy('examples/site/icon.svg', 'icon.svg');
console.log(`site: ${context.written.length} files in ${out}`);
