// SPDX-License-Identifier: MIT
//
// Opens a page of a host in Chromium and hands what it drew to C++:
//     node drive.mjs NAME[#webgl] PACKAGE TWIN NODE_MODULES FOLDER
//
// NAME_page.mjs exports done, a promise of {pictures: {name: data URL}, floats: {name: base64}, said: {name: text}}. All of
// it goes to FOLDER. Exit status 1 when a receiver differs, or something was not said as expected; 77 without the host.
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

import { serve } from '../serve.mjs';
import { expected } from './expected.mjs';
import { height, map_size, width } from './scene.mjs';

const [page_name, umbrage, twin, node_modules, folder] = process.argv.slice(2);
const here = dirname(fileURLToPath(import.meta.url)), wants = expected[page_name];
for (const needed of ['playwright-core', wants.host])
    if (!existsSync(join(node_modules, needed))) {
        console.log(`SKIPPED: no ${needed} in ${node_modules}`);
        process.exit(77);
    }
const { chromium } = createRequire(join(resolve(node_modules), 'x.js'))('playwright-core');

const three = '/modules/three/build/three', imports = page_name.startsWith('three_webgpu')
    ? { three: `${three}.webgpu.js`, 'three/webgpu': `${three}.webgpu.js`, 'three/tsl': `${three}.tsl.js` }
    : { three: `${three}.module.js`, playcanvas: '/modules/playcanvas/build/playcanvas.mjs',
        '@babylonjs/core': '/modules/@babylonjs/core/index.js', '@babylonjs/core/': '/modules/@babylonjs/core/' };
const html = `<script type="importmap">${JSON.stringify({ imports })}</script>
<script type="module">window.done = import('/${page_name.split('#')[0]}_page.mjs').then(page => page.done);</script>\n`;
const { server, address } = await serve({ '/modules/': node_modules, '/package/': umbrage, '/': here }, html);

const browser = await chromium.launch({ executablePath: process.env.UMBRAGE_CHROMIUM ?? '/usr/bin/chromium',
    args: ['--no-sandbox', '--disable-gpu-watchdog', ...wants.flags], timeout: 0 });  // drivers in software may be slow
const page = await browser.newPage({ viewport: { width: 800, height: 600 } });
const complaints = [];
page.on('console', m => { if (m.type() === 'error') complaints.push(m.text().slice(0, 2000)); });
page.on('response', r => { if (r.status() >= 400) complaints.push(`${r.status()} ${r.url()}`); });
page.on('pageerror', e => complaints.push(String(e?.stack ?? e).slice(0, 2000)));
await page.goto(`${address}/#${page_name.split('#')[1] ?? ''}`, { timeout: 0 });
const { pictures, floats, said } = await page.evaluate(() => window.done).catch(error => {  // a crash rejects too
    console.log(complaints.join('\n'));
    throw error;
});
await browser.close();
server.close();

mkdirSync(folder, { recursive: true });
for (const [name, url] of Object.entries(pictures))
    writeFileSync(join(folder, `${name}.png`), Buffer.from(url.split(',')[1], 'base64'));
for (const [name, text] of Object.entries(floats)) writeFileSync(join(folder, name), Buffer.from(text, 'base64'));
writeFileSync(join(folder, 'said.json'), JSON.stringify(said, undefined, 4));
let failed = 0;
const check = (good, what) => { if (!good) ++failed, console.log(`FAILED: ${what}`); };
const compared = Object.keys(floats).filter(name => name.endsWith('.receivers')).map(name => name.replace(/\.receivers$/, ''));
for (const name of new Set([...wants.filters, ...compared])) {
    const [receivers, map, layers] = ['receivers', 'map', 'layers'].map(kind => join(folder, `${name}.${kind}`));
    try {
        const [per_code, compare] = [said[`${name}.per_code`] ?? 0.0234375, said[`${name}.compare`] ?? 'less_equal'];
        process.stdout.write(execFileSync(twin, [name, receivers, map, width, height, map_size, per_code, compare,
            ...(floats[`${name}.layers`] ? [layers] : [])], { encoding: 'utf8' }));
    } catch (error) { check(false, error.stdout || error.message); }
}
for (const [name, words] of Object.entries(said)) if (/^dark: /.test(words)) console.log(`${name}: ${words}`);
for (const [name, part] of Object.entries(wants.said)) check(String(said[name]).includes(part), `${name}: ${said[name]}`);
for (const complaint of complaints) check(false, complaint);
process.exit(failed ? 1 : 0);
