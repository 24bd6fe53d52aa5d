// SPDX-License-Identifier: MIT
//
// Opens the page that compares a shader with C++ in Chromium: its function as it is, one with a slip, one misspelt.
//     node drive.mjs ROOT NODE_MODULES CHROMIUM
import { existsSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join, resolve } from 'node:path';

import { serve } from '../serve.mjs';

const [root, node_modules, executablePath] = process.argv.slice(2);
const skip = why => { console.log(`SKIPPED: ${why}`), process.exit(77); };
if (!existsSync(join(node_modules, 'playwright-core'))) skip(`no playwright-core in ${node_modules}`);
const { chromium } = createRequire(join(resolve(node_modules), 'x.js'))('playwright-core');

const { server, address } = await serve({ '/': root });

const browser = await chromium.launch({ executablePath,
    args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist'] })
    .catch(error => skip(error.message));
const page = await browser.newPage(), complaints = [];
page.on('pageerror', e => complaints.push(String(e?.stack ?? e)));
page.on('response', r => { if (r.status() >= 400) complaints.push(`${r.status()} ${r.url()}`); });
await page.goto(`${address}/examples/small/test_your_shader.html`);
await page.waitForFunction(() => document.querySelector('pre').textContent, null, { timeout: 60000 })
    .catch(error => complaints.push(error.message));

const text = await page.inputValue('textarea');
const answer = async (from, to) => {
    if (!text.includes(from)) complaints.push(`the page's function has no '${from}'`);
    await page.fill('textarea', text.replace(from, to));
    return page.textContent('pre');
};
const expect = (what, said, pattern) => { if (!pattern.test(said)) complaints.push(`${what}: ${said}`); };
const weights = /in the map +\d+ of \d+ same bits, largest difference 0\.00[0-9]+\n/;
expect('as it is', await answer('', ''), weights);
expect('as it is', await answer('', ''), /beyond the far plane +0 of \d+ same bits/);
expect('with what it lacks', await answer('return mix(bottom', 'return depth > 1.0 ? 1.0 : mix(bottom'), /far plane +(\d+) of \1 same bits/);
expect('half a texel off', await answer(' - 0.5', ''), /in the map +\d+ of \d+ same bits, largest difference 0\.[1-9]/);
expect('misspelt', await answer('weight = fract', 'wait = fract'), /does not compile:\nERROR: 0:\d+: 'weight'/);
await browser.close();
server.close();
if (complaints.length) console.error(complaints.join('\n'));
process.exit(complaints.length ? 1 : 0);
