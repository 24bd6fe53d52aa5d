// SPDX-License-Identifier: MIT
//
// The live scene's verdict is of the picture that is shown: gone at every change, never of an older picture, and green
// only where C++ has compared.
import { visit, webgl_flags } from './visit.mjs';

/** Lets the test stand between the page and C++: window.between(event, take) gets each answer. */
const stand_between = () => {
    window.Worker = class extends Worker {
        constructor(...all) {
            super(...all);
            if (all[0].includes('check_worker')) window.worker = this;
        }
        set onmessage(take) {
            super.onmessage = event => (window.between ?? ((e, f) => f(e)))(event, take);
        }
    };
};
const read = page => page.evaluate(() => {
    const verdict = document.querySelector('#verdict'), green = document.createElement('i');
    green.className = 'good';
    document.body.append(green);
    const is_green = getComputedStyle(verdict).color === getComputedStyle(green).color;
    green.remove();
    return { words: verdict.textContent, is_green, time: document.querySelector('#time').textContent };
});
const says = (page, words) => page.waitForFunction(part => document.querySelector('#verdict').textContent.includes(part), words);
const choose = (name, value) => [`#set-${name} to ${value}`, page => page.evaluate(([id, to]) => {
    const input = document.querySelector(id);
    input.value = to;
    input.dispatchEvent(new Event(input.type === 'range' ? 'input' : 'change'));
}, [`#set-${name}`, value])];
const cube = `${[0, 1, 2, 3, 4, 5, 6, 7].map(n => `v ${n & 1} ${n >> 1 & 1} ${n >> 2}`).join('\n')}\nf 1 2 4 3\nf 5 7 8 6\n`;

const changes = [
    choose('system', '0'),
    choose('filter', 'hard'),
    choose('light', 'cascades'),
    choose('size', '512'),
    choose('azimuth', '20'),
    choose('scene', 'outdoor'),
    ['another view', page => page.check('input[value=difference]')],
    ['a key', page => page.press('#picture', 'ArrowRight')],
    ['another size of the window', async page => {
        await page.setViewportSize({ width: 420, height: 844 });
        await page.evaluate(() => new Promise(resolve => requestAnimationFrame(() => requestAnimationFrame(resolve))));  // laid out
    }],
];

await visit(async ({ open, check }) => {
    const page = await open('', { width: 390, before: stand_between });
    const computing = async when => {
        const { words, is_green, time } = await read(page);
        check(words.includes('is computing') && !is_green && time === '',
            `${when}: the page says "${words}" ${time}${is_green ? ', in green' : ''}`);
    };
    const compared = async when => {
        await says(page, ' differ ');
        const { words, is_green } = await read(page);
        check(is_green && words.startsWith('0 of '), `${when}: the page says "${words}"`);
    };
    await page.route('**/outdoor.scene', async route => {  // a scene that takes its time
        await new Promise(resolve => setTimeout(resolve, 1000));
        await route.continue();
    });
    await compared('the default scene');
    for (const [what, change] of changes) {
        await change(page);
        await page.waitForTimeout(100);
        await computing(`100 ms after ${what}`);
        await compared(what);
    }
    // what is dropped is drawn once it is read
    await page.evaluate(() => { window.between = (event, take) => { take(event); window.between = undefined; window.taken = true; }; });
    await page.setInputFiles('#file', { name: 'cube.obj', mimeType: '', buffer: Buffer.from(cube) });
    await page.waitForFunction(() => window.taken);
    await page.waitForTimeout(100);
    await computing('100 ms after a file is read');
    await compared('a file');

    // an answer to a picture of before
    await page.evaluate(() => { window.between = (event, take) => { window.release = () => take(event); }; });
    await choose('filter', 'pcf_2x2')[1](page);
    await page.waitForFunction(() => window.release);
    await choose('filter', 'hard')[1](page);
    await page.evaluate(() => { window.between = undefined; window.release(); });
    await computing('an answer that comes late');
    await compared('a late answer');

    // what goes wrong is not green, and the next picture is computed again
    const failed = async when => {
        await says(page, 'no answer');
        const { words, is_green } = await read(page);
        check(!is_green, `${when}: the page says "${words}" in green`);
        await choose('azimuth', '30')[1](page);
        await computing(`after ${when}`);
        await compared(`after ${when}`);
        await choose('azimuth', '20')[1](page);
    };
    const answer = data => page.evaluate(given => {
        window.between = (_, take) => { window.between = undefined; take({ data: given }); };
    }, data);
    await answer({ error: 'out of memory' });
    await choose('filter', 'pcf_2x2')[1](page);
    await failed('an error of C++');
    await compared('the scene again');
    await page.evaluate(() => {
        window.between = () => {
            window.between = undefined;
            window.worker.terminate();
            window.worker.dispatchEvent(new ErrorEvent('error'));
        };
    });
    await choose('filter', 'hard')[1](page);
    await failed('an error of the browser');

    // without any receiver nothing was compared
    await page.evaluate(() => {
        window.between = ({ data }, take) => { window.between = undefined; take({ data: { ...data, receivers: 0, different: 0 } }); };
    });
    await choose('filter', 'pcf_2x2')[1](page);
    await page.waitForFunction(() => window.between === undefined);
    const { words, is_green } = await read(page);
    check(!is_green, `nothing was compared, and the page says "${words}" in green`);
}, webgl_flags);
