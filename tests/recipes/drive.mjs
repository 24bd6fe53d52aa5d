// SPDX-License-Identifier: MIT
//
// Opens a recipe's page in Chromium and writes its window.picture:
//     node drive.mjs PAGE ROOT NODE_MODULES PICTURE.png
//
// Exit status 1 when the page complains; 77 without a browser that has the API.
import { existsSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join, resolve } from 'node:path';

import { serve } from '../serve.mjs';

const [page_name, root, node_modules, picture] = process.argv.slice(2);
const skip = why => { console.log(`SKIPPED: ${why}`), process.exit(77); };
if (!existsSync(join(node_modules, 'playwright-core'))) skip(`no playwright-core in ${node_modules}`);
const { chromium } = createRequire(join(resolve(node_modules), 'x.js'))('playwright-core');

const { server, address } = await serve({ '/': root });

// No set of flags gives WebGL and WebGPU together.
const flags = page_name.includes('webgpu')
    ? ['--enable-unsafe-webgpu', '--enable-features=Vulkan', '--use-vulkan=swiftshader', '--use-angle=swiftshader']
    : ['--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist'];
const browser = await chromium.launch({ executablePath: process.env.UMBRAGE_CHROMIUM || '/usr/bin/chromium',
    args: ['--no-sandbox', ...flags] }).catch(error => skip(error.message));
const page = await browser.newPage(), complaints = [];
page.on('console', m => { if (['error', 'warning'].includes(m.type())) complaints.push(m.text()); });
page.on('pageerror', e => complaints.push(String(e?.stack ?? e)));
page.on('response', r => { if (r.status() >= 400) complaints.push(`${r.status()} ${r.url()}`); });
await page.goto(`${address}/examples/recipes/${page_name}`);
await page.waitForFunction(() => window.picture, null, { timeout: 60000 }).catch(error => complaints.push(error.message));
if (!complaints.length) {
    const url = await page.evaluate(() => window.picture);
    writeFileSync(picture, Buffer.from(url.split(',')[1], 'base64'));
}
await browser.close();
server.close();
if (complaints.length) console.error(complaints.join('\n'));
process.exit(complaints.length ? 1 : 0);
