// SPDX-License-Identifier: MIT
//
// The proof page where something is missing: it says what, and shows the rest.
import { finished } from './proof.mjs';
import { address_of, visit, webgl_flags } from './visit.mjs';

await visit(async ({ open, check }) => {
    const shows = async (page, words) => check(await page.getByText(words).first().isVisible(), `${page.url()} does not say: ${words}`);

    // An address that is none.
    const wrong = await open('proof/?on=webgl9&inputs=100&every=0&fault=nothing&color=red');
    check(await wrong.locator('.notice').count() === 5, `${await wrong.locator('.notice').count()} of 5 complaints about the address`);
    check(await wrong.inputValue('#inputs') === '12' && await wrong.isChecked('#webgpu'), 'a wrong address does not give the defaults');

    // One that is, and follows the controls.
    const restored = await open('proof/?on=webgl2&inputs=1024');
    check(await restored.inputValue('#inputs') === '10' && !await restored.isChecked('#webgpu'), 'the address does not set the controls');
    check(await restored.locator('.notice').count() === 0, 'the page complains about its own address');
    await restored.focus('#inputs');
    await restored.keyboard.press('ArrowRight');
    const moved = await address_of(restored);
    check(moved.endsWith('?on=webgl2&inputs=2048'), `the slider makes the address ${moved}`);

    // No worker: the page draws itself. Its context is lost soon.
    const lost = await open('proof/?on=webgl2&inputs=256&run', { before: () => {
        delete window.Worker;
        const draw = WebGL2RenderingContext.prototype.drawArrays;
        let drawn = 0;
        WebGL2RenderingContext.prototype.drawArrays = function (...all) {
            draw.apply(this, all);
            if (++drawn === 40) this.getExtension('WEBGL_lose_context').loseContext();
        };
    } });
    const { webgl2 } = await finished(lost);
    await shows(lost, 'This browser runs no worker that draws');
    await shows(lost, 'The browser took the GPU away');
    check(webgl2.tiles.length > 0 && await lost.isVisible('#report'), 'a lost context hides the results before it');

    // No WebAssembly, no WebGL.
    const bare = before => open('proof/?on=webgl2&inputs=256&run', { before });
    const without = await bare(() => { delete window.Worker; delete window.WebAssembly; });
    await finished(without);
    await shows(without, 'This browser has no WebAssembly');
    const blind = await bare(() => { delete window.Worker; HTMLCanvasElement.prototype.getContext = OffscreenCanvas.prototype.getContext = () => null; });
    await finished(blind);
    await shows(blind, 'Not tried: this browser offers no WebGL 2.');

    // Stopped: the results up to then.
    const stopped = await open('proof/?on=webgl2&inputs=256&run');
    await stopped.waitForFunction(() => document.querySelector('.headline'));
    await stopped.click('#prove');
    await finished(stopped);
    check(await stopped.isVisible('#report'), 'a run that is stopped has no report');
}, webgl_flags);
