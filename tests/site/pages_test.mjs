// SPDX-License-Identifier: MIT
//
// Pages of the reference at two widths, dark and light: none is wider than its window, little shifts, and axe finds
// nothing serious.
import { layout_shift } from './shift.mjs';
import { visit } from './visit.mjs';

const views = [
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
});
