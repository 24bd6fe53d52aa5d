// SPDX-License-Identifier: MIT
//
// From an empty folder to a picture, as the package's page of engines says it: packed, installed beside a host, bundled, opened.
//     node from_npm.mjs PACKAGE NODE_MODULES FOLDER HOST...      for example playcanvas@2.23.3
//
// NODE_MODULES has playwright-core and esbuild. Prints what a page weighs without the addon and with it. Exit
// status 1: the picture has no shadow, or the addon changes nothing in it.
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join, resolve } from 'node:path';
import { gzipSync } from 'node:zlib';

const [umbrage, node_modules, folder, ...hosts] = process.argv.slice(2).map((argument, i) => (i < 3 ? resolve(argument) : argument));
const required = createRequire(join(node_modules, 'x.js')), { chromium } = required('playwright-core'), { build } = required('esbuild');
mkdirSync(folder, { recursive: true });
const readme = readFileSync(join(umbrage, 'npm/README.md'), 'utf8');
const run = (program, ...args) => execFileSync(program, args, { encoding: 'utf8', maxBuffer: 1 << 24 });
const [{ size }] = JSON.parse(run('npm', 'pack', umbrage, '--json', '--silent', '--pack-destination', folder));
const [, options] = readme.match(/`umbrage` is not on npm yet[^]*?give `(.*)<copy of the repository>\/single_include`/);
const titles = { three: 'three.js', '@babylonjs/core': 'Babylon.js', playcanvas: 'PlayCanvas' };

/** The README's page for a host, and the same without shadows, or without the addon. */
function programs(name) {
    const section = readme.split(`## In ${titles[name]}\n`)[1], [, program] = section.match(/```js\n([^]*?)```/);
    const lines = program.split('\n');
    return {
        'with the addon': program,
        'without shadows': program.replace(/(castShadow|receiveShadows|castShadows)( =|:) true/, '$1$2 false')
            .replace('= box.castShadow = floor.receiveShadow = true', '= false'),
        'without the addon': lines.filter(line => !/umbrage|^install\(/.test(line)).join('\n'),
    };
}

const browser = await chromium.launch({ executablePath: process.env.UMBRAGE_CHROMIUM ?? '/usr/bin/chromium',
    args: ['--no-sandbox', '--disable-gpu-watchdog', '--use-angle=swiftshader', '--enable-unsafe-swiftshader',
        '--ignore-gpu-blocklist'], timeout: 0 });
let failed = 0;
const check = (good, what) => { if (!good) ++failed, console.log(`FAILED: ${what}`); };

/** In a page before its own scripts: waits for each program, and counts frames in a row that draw as many meshes. */
function watch() {
    const { prototype } = WebGL2RenderingContext, { linkProgram } = prototype;
    prototype.linkProgram = function (program) {
        linkProgram.call(this, program);
        this.getProgramParameter(program, this.LINK_STATUS);
    };
    let draws = 0, last = 0;
    for (const name of ['drawArrays', 'drawElements', 'drawArraysInstanced', 'drawElementsInstanced']) {
        const own = prototype[name];
        prototype[name] = function (...given) {
            ++draws;
            return own.apply(this, given);
        };
    }
    window.equal_frames = 0;
    requestAnimationFrame(function next() {
        window.equal_frames = draws > 0 && draws === last ? window.equal_frames + 1 : 0;
        [last, draws] = [draws, 0];
        requestAnimationFrame(next);
    });
}

/** Gray of each pixel of a page's canvas, once it has drawn the same for ten frames. */
async function drawn(file, picture) {
    const page = await browser.newPage({ viewport: { width: 500, height: 340 } });
    page.on('console', m => { if (m.type() === 'error' && !m.text().includes('404')) check(false, `${file}: ${m.text()}`); });
    page.on('pageerror', error => check(false, `${file}: ${error}`));
    page.setDefaultTimeout(0);
    await page.addInitScript(watch);
    await page.goto(`file://${file}`);
    await page.waitForFunction(() => window.equal_frames >= 10);
    const png = await page.screenshot({ path: picture });
    const pixels = await page.evaluate(async url => {
        const image = Object.assign(new Image(), { src: url });
        await image.decode();
        const context = Object.assign(document.createElement('canvas'), { width: 480, height: 320 }).getContext('2d');
        context.drawImage(image, -8, -8);
        return [...context.getImageData(0, 0, 480, 320).data];
    }, `data:image/png;base64,${png.toString('base64')}`);
    await page.close();
    return pixels.filter((_, i) => i % 4 === 1);
}

const rows = [];
for (const host of hosts) {
    const name = host.slice(0, host.lastIndexOf('@')), empty = join(folder, name.replace('/', '_')), weights = {}, grays = {};
    rmSync(empty, { recursive: true, force: true });
    mkdirSync(empty, { recursive: true });
    run('npm', 'install', '--prefix', empty, '--silent', '--no-audit', '--no-fund',
        ...options.split(' ').filter(Boolean), umbrage, host);
    for (const [what, program] of Object.entries(programs(name))) {
        const at = part => join(empty, `${what.replaceAll(' ', '_')}.${part}`);
        writeFileSync(at('mjs'), program);
        await build({ entryPoints: [at('mjs')], outfile: at('js'), bundle: true, minify: true, format: 'iife', logLevel: 'error' });
        const bundle = readFileSync(at('js'));
        weights[what] = [bundle.length, gzipSync(bundle).length];
        writeFileSync(at('html'), `<!doctype html><body><script src="${at('js')}"></script>`);
        grays[what] = await drawn(at('html'), at('png'));
    }
    const all = grays['with the addon'];
    const shadowed = all.filter((gray, i) => gray < grays['without shadows'][i] - 20).length;
    const other = all.filter((gray, i) => gray !== grays['without the addon'][i]).length;
    check(shadowed > 1000, `${host}: ${shadowed} pixels in shadow`);
    check(other > 20, `${host}: the addon changes ${other} pixels`);
    rows.push([titles[name] + host.slice(host.lastIndexOf('@')).replace('@', ' '), ...[0, 1].flatMap(
        kind => [weights['without the addon'][kind], weights['with the addon'][kind] - weights['without the addon'][kind]])]);
}
await browser.close();
const kilobytes = bytes => `${(bytes / 1000).toFixed(1)} kB`;
console.log('| page for | minified | the addon adds | gzip | the addon adds |\n|---|---|---|---|---|');
for (const [name, ...bytes] of rows) console.log(`| ${[name, ...bytes.map(kilobytes)].join(' | ')} |`);
console.log(`The package has ${size} bytes.`);
process.exit(failed ? 1 : 0);
