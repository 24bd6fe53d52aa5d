// SPDX-License-Identifier: MIT
//
// The page's WebAssembly gives the bits of the native build:  node proof_digest_test.mjs SITE NODE_MODULES PARITY_DIGEST SOURCES
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const [site, node_modules, native, sources] = process.argv.slice(2).map(path => resolve(path));
const wasm = join(site, 'proof/proof.wasm'), count = process.env.UMBRAGE_WHOLE === '1' ? 65536 : 1024;
if (!existsSync(wasm)) {
    console.log('SKIPPED: the site was not built');
    process.exit(77);
}
const suite_module = join(mkdtempSync(join(tmpdir(), 'umbrage-')), 'suite.mjs');
await createRequire(join(node_modules, 'x.js'))('esbuild').build({ entryPoints: [join(sources, 'proof/suite.ts')], outfile: suite_module, bundle: true, format: 'esm' });
const { Suite } = await import(pathToFileURL(suite_module));
const suite = await Suite.of(await WebAssembly.compile(readFileSync(wasm)));

const expected = new Map(execFileSync(native, [String(count)], { encoding: 'utf8' }).trim().split('\n').map(line => [line.split('\t')[0], line]));
let different = 0;
for (let i = 0; i < suite.count; ++i) {
    const line = suite.digest(i, count), wanted = expected.get(line.split('\t')[0]);
    if (line !== wanted && ++different <= 5) console.log(`WebAssembly: ${line}\nnative:      ${wanted}`);
}
console.log(`${suite.count} entries of ${expected.size}, ${count} inputs a map, ${different} different`);
process.exitCode = different || suite.count < expected.size / 8 ? 1 : 0;
