// SPDX-License-Identifier: MIT
//
// The front page and the frame that all pages share: no page is wider than a phone, and axe finds nothing serious.
import { visit } from './visit.mjs';

await visit(async ({ open, check, picture, axe }) => {
    for (const width of [1280, 390])
        for (const dark of [false, true]) {
            const page = await open('', { width, dark });
            const room = await page.evaluate(() => document.documentElement.scrollWidth);
            check(room <= width, `the front page is ${room} pixels wide in a window of ${width}`);
            check(await page.locator('nav a').count() >= 4, 'the front page has a navigation');
            await picture(page, `front_${width}${dark ? '_dark' : ''}`);
            await axe(page);
        }
});
