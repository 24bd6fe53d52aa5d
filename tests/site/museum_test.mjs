// SPDX-License-Identifier: MIT
//
// The museum's page: every exhibit has its two drawings, dividers move, and old and new formula look different.
import { visit } from './visit.mjs';

await visit(async ({ open, check, picture, axe }) => {
    for (const [width, dark] of [[1280, false], [390, true]]) {
        const page = await open('museum.html', { width, dark });
        const room = await page.evaluate(() => document.documentElement.scrollWidth);
        check(room <= width, `the museum is ${room} pixels wide in a window of ${width}`);
        const [loaded, pictures] = await page.evaluate(() => [[...document.images].filter(i => i.naturalWidth).length, document.images.length]);
        check(loaded < pictures / 2, `${loaded} of ${pictures} pictures are loaded before one scrolls`);
        await page.evaluate(async () => {  // pictures wait until they are seen
            for (const image of document.images) image.loading = 'eager', await image.decode();
        });
        await picture(page, `museum_${width}${dark ? '_dark' : ''}`);
        await axe(page);
        if (width < 600) continue;
        const exhibits = await page.locator('.exhibit').count();
        check(exhibits === await page.locator('h2').filter({ hasText: /^\d+\. / }).count(), 'each exhibit has drawings');
        const same = await page.evaluate(() => [...document.querySelectorAll('.exhibit')].filter(figure => {
            const [then, ours] = [...figure.querySelectorAll('img')].map(image => {
                const canvas = Object.assign(document.createElement('canvas'), { width: image.naturalWidth, height: image.naturalHeight });
                canvas.getContext('2d').drawImage(image, 0, 0);
                return canvas.toDataURL();
            });
            return then === ours;
        }).length);
        check(same === 0, `${same} exhibits look the same then and now`);
        const divider = page.locator('.exhibit input').first(), edge = page.locator('.exhibit .pair span').nth(1);
        const before = (await edge.boundingBox()).x;
        await divider.press('PageUp');
        check((await edge.boundingBox()).x > before, 'a divider moves');
    }
});
