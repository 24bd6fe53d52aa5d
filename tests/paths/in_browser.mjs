// SPDX-License-Identifier: MIT
//
// Pages in Chromium that draw paths in WebGL and WebGPU, on SwiftShader.
import { createReadStream, existsSync, statSync } from 'node:fs';
import { createServer } from 'node:http';
import { createRequire } from 'node:module';
import { extname, join, resolve } from 'node:path';

const software = ['--no-sandbox', '--disable-gpu-watchdog', '--no-first-run', '--disable-background-networking'];
// No set of flags gives WebGL and WebGPU together.
const flags = {
    webgl: [...software, '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist'],
    webgpu: [...software, '--enable-unsafe-webgpu', '--enable-features=Vulkan', '--use-vulkan=swiftshader', '--use-angle=swiftshader'],
};

/** Files of the package and of tests, as one site. */
async function serve(root) {
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

/** Browsers, each started when a path needs it. */
export class browsers {
    static async open(root, node_modules, chromium_path) {
        const made = new browsers();
        made.chromium = createRequire(join(resolve(node_modules), 'x.js'))('playwright-core').chromium;
        made.server = await serve(root);
        return Object.assign(made, { chromium_path, running: {} });
    }

    /** Draws a path's frames in a page of its own.
     *  @param seen    {points, normals} that the camera sees
     *  @param fault   a mistake of the page's, of faults.mjs
     *  @return        for each frame, visibility of each pixel from above, 255 is lit */
    async draw({ api, frames }, seen, fault) {
        const kind = api.replace(/[12]$/, ''), complaints = [];
        this.running[kind] ??= await this.chromium.launch({ executablePath: this.chromium_path, args: flags[kind] });
        const page = await this.running[kind].newPage();
        page.on('console', m => { if (['error', 'warning'].includes(m.type()) && !m.text().includes('ReadPixels')) complaints.push(m.text()); });
        await page.goto(`http://127.0.0.1:${this.server.address().port}/`);
        const drawn = await page.evaluate(async ([kind, version, frames, seen, fault]) => {
            const [{ page }, { load_values }, { faults }] = await Promise.all(
                [import(`/paths/${kind}.mjs`), import('/package/values.mjs'), import('/paths/faults.mjs')]);
            const values = await load_values(), made = await page.made(version), all = [];
            for (const path of frames) all.push(await made.frame(path, values, seen, fault && faults[fault]));
            return all;
        }, [kind, api === 'webgl1' ? 1 : 2, frames, seen, fault]);
        await page.close();
        if (complaints.length) throw new Error(complaints.join('\n'));
        return drawn;
    }

    async close() {
        for (const browser of Object.values(this.running)) await browser.close();
        this.server.close();
    }
}
