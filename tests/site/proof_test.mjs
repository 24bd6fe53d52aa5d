// SPDX-License-Identifier: MIT
//
// The proof page in WebGL: its headline, its report, its address, a planted fault.
import { check_headline, finished, share } from './proof.mjs';
import { visit, webgl_flags } from './visit.mjs';

await visit(async ({ open, check, picture, axe }) => {
    const page = await open(`proof/?on=webgl2,webgpu,webgl1&${share}&run`);
    await page.waitForFunction(() => document.querySelector('.headline'));
    check(page.workers().length === 1, 'the run is not in a worker');
    const run = await finished(page);
    for (const api of ['webgl2', 'webgl1']) check_headline(check, api, run[api]);
    check(run.webgpu.said.includes('WebGPU'), `without WebGPU it says ${run.webgpu.said}`);

    await page.click('#copy');
    await page.getByText('Report copied.').waitFor();
    const report = await page.evaluate(() => navigator.clipboard.readText());
    for (const part of ['# umbrage on WebGL 2, ', '# umbrage on WebGL 1, ', '- a * b + c: not fused', '## Different\n\nNone.', share])
        check(report.includes(part), `the copied report lacks ${part}`);
    const [download] = await Promise.all([page.waitForEvent('download'), page.click('#download')]);
    check(download.suggestedFilename() === 'umbrage-report.md', `the report's file is ${download.suggestedFilename()}`);
    await page.click('#link');
    await page.getByText('Address copied.').waitFor();
    const link = new URL(await page.evaluate(() => navigator.clipboard.readText()));
    check(link.searchParams.has('run') && share.split('&').every(part => link.search.includes(part)), `the address is ${link}`);

    await page.locator('.group:not([hidden]) > summary').first().click();
    for (const width of [1280, 390])
        for (const dark of [false, true]) {
            await page.setViewportSize({ width, height: 844 });
            await page.emulateMedia({ colorScheme: dark ? 'dark' : 'light' });
            const room = await page.evaluate(() => document.documentElement.scrollWidth);
            check(room <= width, `the proof is ${room} pixels wide in a window of ${width}`);
            await picture(page, `proof_${width}${dark ? '_dark' : ''}`);
            await axe(page);
        }

    const faulty = await open('proof/?on=webgl2&inputs=256&only=encode&fault=floor(=ceil(&run');
    const red = await finished(faulty);
    check(red.webgl2.bad > 0, `with a fault it says ${red.webgl2.tiles}`);
    check(await faulty.getByText('differs: ').first().isVisible(), 'a difference is shown without its input');
    check(await faulty.getByText('A fault is planted').isVisible(), 'the page does not say that a fault is planted');
    await picture(faulty, 'proof_fault');
    await axe(faulty);
}, webgl_flags);
