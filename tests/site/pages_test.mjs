// SPDX-License-Identifier: MIT
//
// Pages of text at two widths, dark and light: none is wider than its window, little shifts, and axe finds nothing
// serious. On a phone every table of a page fits. Start is first in the navigation. It shows code in three ways, leads to every
// task of README.md, and has files.
import { readdirSync, readFileSync } from 'node:fs';

import { layout_shift } from './shift.mjs';
import { visit } from './visit.mjs';

const views = [
    ['start.html', 1280, true],
    ['start.html', 390, false],
    ['reference/', 1280, false],
    ['reference/filter/', 390, true],
    ['reference/filter/pcf/box.html', 1280, true],
    ['reference/shadow/shadow.html', 390, false],
];

await visit(async ({ open, check, picture, axe }) => {
    for (const [path, width, dark] of views) {
        const page = await open(path, { width, dark });
        const shift = await layout_shift(page); // tables settle while a page streams in
        check(shift < 0.05, `${path} shifts by ${shift} at ${width}`);
        const room = await page.evaluate(() => document.documentElement.scrollWidth);
        check(room <= width, `${path} is ${room} pixels wide in a window of ${width}`);
        await picture(page, `${path.replace(/\W+/g, '_')}${width}${dark ? '_dark' : ''}`, false); // they are long
        await axe(page);
        await page.context().close();
    }

    const narrow = await open('start.html', { width: 390 }), start = narrow.url();
    const texts = readdirSync(process.argv[2], { recursive: true }).filter(file => /^(?!source|museum)(?!reference.*(?<!index)\.html).*\.html$/.test(file));
    check(texts.length > 30, `the site has ${texts.length} pages of text`);
    let tables = 0;
    for (const path of texts) {
        await narrow.goto(new URL(path, start).href, { waitUntil: 'domcontentloaded' });
        const heads = await narrow.locator('.scroll > table').evaluateAll(all =>
            all.map(({ parentElement: { scrollWidth, clientWidth }, tHead }) => [scrollWidth - clientWidth, tHead?.textContent]));
        tables += heads.length;
        for (const [more, head] of heads) check(more <= 0, `${path}: a table is ${more} pixels wider than a phone: ${head}`);
    }
    check(tables > 50, `the pages have ${tables} tables`);
    await narrow.context().close();

    const page = await open('reference/filter/');
    check((await page.locator('nav a').first().textContent()) === 'Start', 'Start is not first in the navigation');
    await page.locator('nav a').first().click();
    await page.waitForURL(/start\.html$/);
    const tasks = readFileSync(new URL('../../README.md', import.meta.url), 'utf8')
        .split('\n## All pages\n')[1]
        .split('\n## ')[0]
        .split('\n')
        .filter(line => line.startsWith('| ') && !line.startsWith('| task |'))
        .map(line => ({ task: line.slice(2).split(' | ')[0], links: line.split('](').length - 1 }));
    check(tasks.length > 15, `README.md has ${tasks.length} tasks`);
    for (const { task, links } of tasks) {
        const row = page.locator('tr', { has: page.getByText(task, { exact: true }) });
        check((await row.locator('a').count()) === links, `Start does not lead to "${task}"`);
    }
    for (const way of ['In a C++ engine', 'As text in your shader', 'As a package for JavaScript']) {
        const code = page.locator(`h2:text-is("${way}") + p + pre`).first();
        check((await code.count()) === 1, `Start shows no code: ${way}`);
    }
    for (const [name, words] of [
        ['umbrage.hpp', 'namespace umbrage'],
        ['umbrage.tgz', '\x1f\x8b'],
    ]) {
        const download = page.waitForEvent('download');
        await page.getByRole('link', { name, exact: true }).click();
        check(readFileSync(await (await download).path(), 'latin1').includes(words), `${name} is another file`);
    }
});
