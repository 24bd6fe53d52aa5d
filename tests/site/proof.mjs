// SPDX-License-Identifier: MIT
//
// A run of the proof page, as its tests look at it.

/// Inputs and sample of a run: every function with UMBRAGE_WHOLE=1, as make prove has it.
export const share = process.env.UMBRAGE_WHOLE === '1' ? 'inputs=65536' : 'inputs=256&every=4';

/// Waits for the end of a run, and gives its sections: {api: {said, probe, tiles, bad}}.
export async function finished(page) {
    await page.waitForFunction(() => document.body.dataset.state === 'done', null, { timeout: 1_800_000, polling: 200 });
    return page.evaluate(() => Object.fromEntries([...document.querySelectorAll('section.api')].map(section => {
        const texts = selector => [...section.querySelectorAll(selector)].map(one => one.textContent);
        return [section.dataset.api, { said: section.querySelector('p').textContent, probe: texts('.probe li'), tiles: texts('.headline'),
            bad: section.querySelectorAll('.tiles .bad').length, not_run: texts('.tiles p').filter(text => text.includes('did not run: ')) }];
    })));
}

/// Checks the headline of an API: A to the bit, B and C as promised, and all did run.
export function check_headline(check, api, section) {
    const all = section?.tiles.join(', ') ?? 'nothing';
    const same = /^A: ([1-9]\d*) of \1 to the bit, B: ([1-9]\d*) of \2 as promised, C: ([1-9]\d*) of \3 within bounds$/.test(all);
    check(same && section.bad === 0, `${api} says ${all}`);
    check(section?.not_run.length === 0, `${api}: ${section?.not_run}`);
    check(section?.probe.some(line => line === 'a * b + c: not fused'), `${api}: the probe says ${section?.probe}`);
    console.log(`${api}: ${all}`);
}
