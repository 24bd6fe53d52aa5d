// SPDX-License-Identifier: MIT
//
// Opens the built site in Chromium, as every test of a page does.
import { existsSync, mkdirSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join, resolve } from 'node:path';

const [site, node_modules, chromium_path] = process.argv.slice(2).map(path => resolve(path));
const load = createRequire(join(node_modules, 'x.js'));

/// No GPU, not even one in software: the front page's scene would take a processor from tests that are not about it.
const no_gpu_flags = ['--disable-gpu', '--disable-software-rasterizer'];
export const webgl_flags = ['--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'];
export const webgpu_flags = ['--enable-unsafe-webgpu', '--use-webgpu-adapter=swiftshader'];

/// Milliseconds that a test waits for a page. They end a test that hangs; a slow machine never meets them.
const patience = 600_000;

/// The page's address as the page has it: page.url() hears of a replaced one later.
export const address_of = page => page.evaluate(() => location.href);

/// What a button copies. The wait begins before the click: the button says its work for a moment only.
export async function copied(page, button) {
    const says = button => /copied$/i.test(document.querySelector(button).textContent);
    await Promise.all([page.waitForFunction(says, button), page.click(button)]);
    return page.evaluate(() => navigator.clipboard.readText());
}

/// Calls trial(visit) with the site served and a browser open; exit status 77 where something is missing, 1 when a check
/// fails, a page says an error on its console, or asks another host.
///
/// visit.open(path, {width, dark, before}) gives a page, in which the function `before` runs first; visit.check(good, what)
/// counts; visit.picture(page, name) keeps a picture beside the site; visit.axe(page) checks that axe finds nothing serious.
export async function visit(trial, flags = no_gpu_flags) {
    for (const needed of ['playwright-core', 'esbuild', 'axe-core'])
        if (!existsSync(join(node_modules, needed))) skip(`no ${needed} in ${node_modules}`);
    if (!existsSync(chromium_path)) skip('no Chromium');
    if (!existsSync(join(site, 'index.html'))) skip('the site was not built');

    const server = await load('esbuild').context({});
    const { port } = await server.serve({ servedir: site, host: '127.0.0.1' });
    const origin = `http://127.0.0.1:${port}/`;
    const browser = await load('playwright-core').chromium.launch({ executablePath: chromium_path,
        args: ['--no-sandbox', '--disable-gpu-watchdog', ...flags] });
    let failed = 0;
    const check = (good, what) => { if (!good) ++failed, console.log(`FAILED: ${what}`); };

    async function open(path, { width = 1280, dark = false, before } = {}) {
        const context = await browser.newContext({ viewport: { width, height: width < 600 ? 844 : 800 },
            colorScheme: dark ? 'dark' : 'light', permissions: ['clipboard-read', 'clipboard-write'] });
        context.setDefaultTimeout(patience);
        const page = await context.newPage();
        page.on('console', m => check(m.type() !== 'error', `${path}: the console says ${m.text()}`));
        page.on('pageerror', e => check(false, `${path}: ${e.stack ?? e}`));
        page.on('request', r => check(/^(data|blob):/.test(r.url()) || r.url().startsWith(origin), `${path}: asks ${r.url()}`));
        if (before) await page.addInitScript(before);
        await page.goto(origin + path);
        return page;
    }
    async function picture(page, name, fullPage = true) {
        mkdirSync(join(site, '../pictures'), { recursive: true });
        await page.screenshot({ path: join(site, '../pictures', `${name}.png`), fullPage });
    }
    async function axe(page) {
        await page.addScriptTag({ content: load('axe-core').source });
        const { violations } = await page.evaluate(() => window.axe.run());
        for (const v of violations)
            check(!['serious', 'critical'].includes(v.impact), `${page.url()}: ${v.id}, ${v.nodes[0].html.slice(0, 200)}`);
    }
    try {
        await trial({ open, check, picture, axe });
    } finally {
        await browser.close();
        await server.dispose();
    }
    process.exitCode = failed ? 1 : 0;
}

function skip(why) {
    console.log(`SKIPPED: ${why}`);
    process.exit(77);
}
