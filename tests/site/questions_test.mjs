// SPDX-License-Identifier: MIT
//
// Each question of questions.txt is answered within two clicks or one search from the front page, by keyboard alone.
import { readFileSync } from 'node:fs';

import { address_of, visit } from './visit.mjs';

const questions = readFileSync(new URL('questions.txt', import.meta.url), 'utf8')
    .split('\n')
    .filter(line => line !== '' && !line.startsWith('#'))
    .map(line => line.split('|').map(part => part.trim()));

await visit(async ({ open, check, picture, axe }) => {
    check(questions.length >= 10, 'few questions');
    const page = await open(''),
        front = page.url();
    for (const [question, way, answer] of questions) {
        await page.goto(front);
        const clicks = way.startsWith('click ') ? way.slice(6).split(' > ') : [];
        check(clicks.length <= 2, `${question} More than two clicks.`);
        for (const words of clicks) await page.getByRole('link', { name: words, exact: true }).first().click();
        if (way.startsWith('search ')) {
            await page.keyboard.press('/');
            await page.keyboard.type(way.slice(7));
            await page.waitForSelector('.find.open a');
            await page.keyboard.press('Enter');
            await page.waitForURL(url => url.pathname !== '/' || url.search !== '');
        }
        const text = page.locator('main').getByText(answer).first();
        await text.waitFor().catch(() => check(false, `${question} No answer at ${page.url()}: ${answer}`));
        const address = await address_of(page),
            target = new URL(address).hash.slice(1);
        check(
            target === '' || (await page.evaluate(id => document.getElementById(id) !== null, target)),
            `${question} ${address}`,
        );
    }

    await page.goto(front);
    await page.keyboard.press('/');
    await page.keyboard.type('pcss');
    await page.waitForSelector('.find.open a');
    await picture(page, 'search');
    await axe(page);
    await page.keyboard.press('ArrowDown');
    await page.keyboard.press('ArrowDown');
    check(
        await page.evaluate(() => document.activeElement === document.querySelectorAll('.found a')[1]),
        'arrows walk through what was found',
    );
    await page.keyboard.press('Escape');
    check(!(await page.locator('.find.open').count()), 'Escape closes what was found');
    await page.fill('.find input', 'zzqx');
    await page.waitForFunction(() => document.querySelector('.found output').textContent.startsWith('Nothing'));
});
