// SPDX-License-Identifier: MIT
//
// The page of engines without a bundler, as pasted: its import map with its program for three.js draws a shadow, and each entry
// of the map leads to a module.
//     node import_map_test.mjs PACKAGE NODE_MODULES CHROMIUM FOLDER
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join, resolve } from 'node:path';

import { serve } from '../serve.mjs';

const [umbrage, node_modules, chromium_path, folder] = process.argv.slice(2).map(path => resolve(path));
for (const needed of ['playwright-core', 'three', 'pngjs'])
    if (!existsSync(join(node_modules, needed))) {
        console.log(`SKIPPED: no ${needed} in ${node_modules}`);
        process.exit(77);
    }
const load = createRequire(join(node_modules, 'x.js')), { PNG } = load('pngjs');
let failed = 0;
const check = (good, what) => { if (!good) ++failed, console.log(`FAILED: ${what}`); };

const [, section] = readFileSync(join(umbrage, 'npm/README.md'), 'utf8').split('## In three.js\n');
const [, program] = section.match(/```js\n([^]*?)```/), [, html] = section.match(/```html\n([^]*?)```/);
mkdirSync(folder, { recursive: true });
writeFileSync(join(folder, 'page.js'), program);
writeFileSync(join(folder, 'unshaded.js'), program.replace('= box.castShadow', ''));
writeFileSync(join(folder, 'index.html'), html);
writeFileSync(join(folder, 'unshaded.html'), html.replace('page.js', 'unshaded.js'));
const { server, address } = await serve({ '/node_modules/umbrage/': umbrage, '/node_modules/': node_modules, '/': folder });
const browser = await load('playwright-core').chromium.launch({ executablePath: chromium_path,
    args: ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'], timeout: 0 });

/** Green of each pixel of a page, once it has drawn. */
async function drawn(name) {
    const page = await browser.newPage({ viewport: { width: 500, height: 340 } });
    page.setDefaultTimeout(0);  // drivers in software may be slow
    page.on('console', m => check(m.type() !== 'error', `${name}: ${m.text()}`));
    page.on('pageerror', error => check(false, `${name}: ${error}`));
    await page.goto(`${address}/${name}`);
    await page.waitForSelector('canvas');
    await page.evaluate(() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done))));
    const { data } = PNG.sync.read(await page.screenshot({ path: join(folder, name.replace('html', 'png')) }));
    for (const [entry, path] of Object.entries(JSON.parse(html.match(/\{[^]*\}/)[0]).imports)) {
        const names = await page.evaluate(async entry => Object.keys(await import(entry)).length, entry).catch(error => String(error));
        check(names > 0, `${entry}, ${path}: ${names}`);
    }
    await page.close();
    return data.filter((_, i) => i % 4 === 1);
}
try {
    const shaded = await drawn('index.html'), unshaded = await drawn('unshaded.html');
    const in_shadow = shaded.filter((green, i) => green < unshaded[i] - 20).length;
    console.log(`${in_shadow} pixels in shadow`);
    check(in_shadow > 1000, `${in_shadow} pixels in shadow`);
} finally {
    await browser.close();
    server.close();
}
process.exitCode = failed ? 1 : 0;
