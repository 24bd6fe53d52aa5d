// SPDX-License-Identifier: MIT
//
// Pages in Chromium that draw paths in WebGL and WebGPU, on SwiftShader.
import { createRequire } from 'node:module';
import { join, resolve } from 'node:path';

import { serve } from '../serve.mjs';

const software = ['--no-sandbox', '--disable-gpu-watchdog', '--no-first-run', '--disable-background-networking'];
// No set of flags gives WebGL and WebGPU together.
const flags = {
    webgl: [...software, '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist'],
    webgpu: [...software, '--enable-unsafe-webgpu', '--enable-features=Vulkan', '--use-vulkan=swiftshader', '--use-angle=swiftshader'],
};

/** Browsers, each started when a path needs it. */
export class browsers {
    static async open(root, node_modules, chromium_path) {
        const made = new browsers();
        made.chromium = createRequire(join(resolve(node_modules), 'x.js'))('playwright-core').chromium;
        const site = await serve({ '/package/': join(root, 'single_include'), '/': join(root, 'tests') }, '<!doctype html>');
        return Object.assign(made, site, { chromium_path, running: {} });
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
        await page.goto(`${this.address}/`);
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
