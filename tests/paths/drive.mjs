// SPDX-License-Identifier: MIT
//
// Draws paths by their APIs, and judges their pictures by rays:
//     node drive.mjs sample|all|PART-OF-A-NAME ROOT NODE_MODULES FOLDER
//
// Writes the pictures to FOLDER. Exit status 1 when a receiver is falsely dark or lit; 77 without what draws.
import { createReadStream, existsSync, mkdirSync, statSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { createRequire } from 'node:module';
import { extname, join, resolve } from 'node:path';

import * as glsl from '../../single_include/umbrage.mjs';
import { load_values, opengl_clip_space } from '../../single_include/values.mjs';
import { judged, seen_by_camera } from './judge.mjs';
import { light_values, shadow_options } from './light.mjs';
import { picture } from './scene.mjs';
import { read_paths } from './table.mjs';

const [which, root, node_modules, folder] = process.argv.slice(2);
const skip = why => { console.log(`SKIPPED: ${why}`), process.exit(77); };
if (!existsSync(join(node_modules, 'playwright-core'))) skip(`no playwright-core in ${node_modules}`);
const { chromium } = createRequire(join(resolve(node_modules), 'x.js'))('playwright-core');
const paths = read_paths(join(root, 'tests/paths/paths.txt')).filter(path =>
    (which === 'sample' ? path.in_sample : which === 'all' || path.name.includes(which)));
const values = await load_values(), seen = seen_by_camera();

/** Pages, of one origin. */
async function serve() {
    const roots = { '/package/': join(root, 'single_include'), '/': join(root, 'tests') };
    const server = createServer((request, answer) => {
        const url = decodeURI(request.url.split('?')[0]), start = Object.keys(roots).find(r => url.startsWith(r));
        const file = join(roots[start], url.slice(start.length));
        if (url === '/favicon.ico') return answer.writeHead(204).end();
        if (url === '/') return answer.writeHead(200, { 'content-type': 'text/html' }).end('<!doctype html>');
        if (!existsSync(file) || !statSync(file).isFile()) return answer.writeHead(404).end();
        answer.writeHead(200, { 'content-type': extname(file) === '.mjs' ? 'text/javascript' : 'text/plain' });
        createReadStream(file).pipe(answer);
    }).listen(0, '127.0.0.1');
    await new Promise(ready => server.on('listening', ready));
    return server;
}
const software = ['--no-sandbox', '--disable-gpu-watchdog', '--no-first-run', '--disable-background-networking'];
const flags = {
    webgl: [...software, '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist'],
    webgpu: [...software, '--enable-unsafe-webgpu', '--enable-features=Vulkan', '--use-vulkan=swiftshader', '--use-angle=swiftshader'],
};
const server = await serve(), browsers = {};
async function page_of(kind) {
    browsers[kind] ??= await chromium.launch({ executablePath: process.env.UMBRAGE_CHROMIUM || '/usr/bin/chromium', args: flags[kind] })
        .catch(error => skip(error.message));
    const page = await browsers[kind].newPage();
    await page.goto(`http://127.0.0.1:${server.address().port}/`);
    return page;
}

/** Draws a path's frames in a page of its own. */
async function in_browser({ api, frames }) {
    const kind = api.replace(/[12]$/, ''), page = await page_of(kind), complaints = [];
    page.on('console', m => { if (['error', 'warning'].includes(m.type()) && !m.text().includes('ReadPixels')) complaints.push(m.text()); });
    const drawn = await page.evaluate(async ([kind, version, frames, seen]) => {
        const [{ page }, { load_values }] = await Promise.all([import(`/paths/${kind}.mjs`), import('/package/values.mjs')]);
        const values = await load_values(), made = await page.made(version), all = [];
        for (const path of frames) all.push(await made.frame(path, values, seen));
        return all;
    }, [kind, api === 'webgl1' ? 1 : 2, frames, seen]);
    await page.close();
    if (complaints.length) throw new Error(complaints.join('\n'));
    return drawn;
}

mkdirSync(folder, { recursive: true });
let wrong = 0;
for (const path of paths) {
    const start = performance.now();
    const pictures = await in_browser(path).catch(error => { console.log(`${path.name}: ${error.message}`); return []; });
    if (!pictures.length) ++wrong;
    for (const [i, pixels] of pictures.entries()) {
        const frame = path.frames[i], shadow = glsl.shadow('sun', shadow_options(glsl, frame)), clip = { ...opengl_clip_space, direction: frame.direction };
        const light = light_values(frame, shadow, clip, seen), count = judged(frame, shadow, values(shadow, light), light.border, pixels);
        const good = !count.falsely_dark && !count.falsely_lit && count.lit > 1000 && count.dark > 100;
        wrong += !good;
        console.log(`${path.name}${pictures.length > 1 ? `, frame ${i + 1}` : ''}: ${count.lit} lit, ${count.falsely_dark} falsely dark, `
            + `${count.dark} dark, ${count.falsely_lit} falsely lit${good ? '' : ': WRONG'}; ${(performance.now() - start).toFixed()} ms`);
        writeFileSync(join(folder, `${path.name.replaceAll(' ', '-')}-${i + 1}.pgm`), Buffer.concat([Buffer.from(`P5 ${picture.join(' ')} 255\n`), Buffer.from(pixels)]));
    }
}
for (const browser of Object.values(browsers)) await browser.close();
server.close();
console.log(`${paths.length} paths, ${wrong} wrong`);
process.exit(wrong || !paths.length ? 1 : 0);
