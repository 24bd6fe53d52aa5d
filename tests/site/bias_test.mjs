// SPDX-License-Identifier: MIT
//
// The bias page: its numbers are the package's, for each engine, light and filter; it copies them, keeps its state in the
// address, says what is wrong in one, and draws acne with engines' defaults and none with its settings.
import { createRequire } from 'node:module';
import { join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

import { layout_shift } from './shift.mjs';
import { address_of, copied, visit } from './visit.mjs';

const sources = path => fileURLToPath(new URL(`../../${path}`, import.meta.url));
const { engine_bias, engines } = await import(sources('single_include/npm/engines.mjs'));

await visit(async ({ open, check, picture, axe }) => {
    const ready = page => page.waitForSelector('#bias_page:not(.loading)');
    const cell = (page, name) => page.locator(`#${name}`).textContent();
    const shown = async (page, settings) => page.waitForFunction(text => document.getElementById('these_settings').textContent === text,
        Object.entries(settings).map(([name, value]) => `${name} ${value}`).join(', '));
    const none = ['three', 'godot', 'unity_urp', 'bevy', 'filament'];
    check(JSON.stringify(Object.keys(engines)) === JSON.stringify(none), `the engines are ${Object.keys(engines)}`);

    let page = await open('bias.html');
    await ready(page);
    check((await layout_shift(page)) < 0.05, 'the page shifts as it loads');
    await page.fill('#width', '12.5');
    for (const engine of none) {
        await page.selectOption('#engine', engine);
        await page.selectOption('#filter', Object.keys(engines[engine].filters).at(-1));
        const filter = await page.inputValue('#filter'), map = { engine, filter, map_size: 2048, width: 12.5, range: 100 };
        await shown(page, engine_bias(map).settings).catch(() => check(false, `${engine}, ${filter}: other numbers than the package's`));
        for (const share of ['these_all', 'these_floor'])
            check((await cell(page, share)) === '0 %', `${engine}, ${filter}: ${await cell(page, share)} are dark`);
    }
    for (const [engine, light, more] of [['godot', 'spot', { angle: 60 }], ['unity_urp', 'spot', { angle: 60 }], ['unity_urp', 'point', {}],
        ['filament', 'point', {}], ['bevy', 'point', {}]]) {
        await page.selectOption('#engine', engine);
        await page.selectOption('#kind', light);
        const filter = Object.keys(engines[engine].filters)[0], bias = engine_bias({ engine, light, filter, map_size: 2048, range: 10, ...more });
        await shown(page, bias.settings).catch(() => check(false, `${engine}, ${light}: other numbers than the package's`));
        const striped = await cell(page, 'these_striped');
        check((striped === 'none') === !bias.striped, `${engine}, ${light}: ${striped} may stripe`);
        for (const share of ['these_all', 'these_floor'])
            check(bias.striped || (await cell(page, share)) === '0 %', `${engine}, ${light}: ${await cell(page, share)} are dark`);
        check(!(await page.locator('#width').isVisible()) && (await page.locator('#angle').isVisible()) === (light === 'spot'),
            `${engine}, ${light}: fields of another light`);
    }
    await page.selectOption('#engine', 'filament');
    await page.waitForFunction(() => document.getElementById('code').textContent.includes('options.normalBias = '));
    const text = await copied(page, '#copy');
    check(text === (await cell(page, 'code')), `what was copied is ${text}`);
    const link = await copied(page, '#link');
    check(link === (await address_of(page)) && link.includes('#engine=filament') && link.includes('width=12.5'), `the link is ${link}`);
    await page.fill('#width', '-1');
    check((await address_of(page)) === link, 'a width below 0 is taken');

    // What an address has wrong is told, what is right is kept.
    page = await open('bias.html#engine=godot&filter=Soft+Ultra&radius=4&map_size=1000&width=nine&gone=1&sun=20');
    await ready(page);
    const told = await cell(page, 'notice');
    for (const part of ['"map_size=1000"', '"width=nine"', '"gone=1"', 'cannot end all acne', 'texels are missing'])
        check(told.includes(part), `the page does not say ${part}: ${told}`);
    check((await page.inputValue('#filter')) === 'Soft Ultra' && (await page.inputValue('#sun')) === '20', 'what was right is lost');
    const { limits, map_sizes, read_state, write_state } = await state_module();
    const sizes = await page.locator('#map_size option').evaluateAll(all => all.map(each => Number(each.value)));
    check(JSON.stringify(sizes) === JSON.stringify(map_sizes), `the page has maps of ${sizes}, state.ts of ${map_sizes}`);
    for (const [name, ends] of Object.entries(limits)) {
        const own = await page.locator(`#${name}`).evaluate(field => [Number(field.min), Number(field.max)]);
        check(JSON.stringify(own) === JSON.stringify(ends), `the page takes ${name} of ${own}, state.ts of ${ends}`);
    }
    await page.context().close();
    for (const engine of none) {
        const { state, refused } = read_state(`#engine=${engine}&width=3&range=7&sun=45&map_size=512`);
        check(refused.length === 0 && JSON.stringify(read_state(write_state(state)).state) === JSON.stringify(state), `${engine}: a state is lost`);
    }

    for (const light of ['spot', 'point']) {
        const { state, refused } = read_state(`#engine=unity_urp&light=${light}&range=7&map_size=512&sun=50${light === 'spot' ? '&angle=80' : ''}`);
        check(refused.length === 0 && JSON.stringify(read_state(write_state(state)).state) === JSON.stringify(state), `${light}: a state is lost`);
    }
    check(read_state('#engine=bevy&light=spot').state.range === 10, 'a spot light reaches as far as a directional one');
    check(read_state('#engine=godot&light=point').refused[0] === 'light=point', "Godot's point lights are taken");

    // Stripes of the defaults are in their picture, and not in the other. The light falls evenly, or nearly so.
    const steps = (page, side) => page.evaluate(side => {
        const canvas = document.getElementById(`picture_${side}`), size = 40;
        const { data } = canvas.getContext('2d').getImageData(canvas.width * 0.1, canvas.height * 0.75, size, size);  // the lit floor
        let most = 0;
        for (let i = 4; i < data.length; i += 4)
            if ((i / 4) % size > 0) most = Math.max(most, Math.abs(data[i] - data[i - 4]));
        return most;
    }, side);
    for (const [hash, all, floor] of [['three&map_size=1024&width=40&range=100&sun=40', 100, 100], ['bevy&light=point&range=100&sun=42', 60, 90],
        ['unity_urp&light=spot&range=100', 15, 20]]) {
        page = await open(`bias.html#engine=${hash}`);
        await ready(page);
        for (const [share, least] of [['defaults_all', all], ['defaults_floor', floor]])
            check(parseFloat(await cell(page, share)) >= least, `${hash}: the defaults' ${share} is ${await cell(page, share)}`);
        check((await steps(page, 'these')) <= 1, `${hash}: the lit floor has steps of ${await steps(page, 'these')}`);
        check((await steps(page, 'defaults')) > 3, `${hash}: the striped floor has steps of ${await steps(page, 'defaults')}`);
        await page.context().close();
    }
    page = await open('bias.html#engine=bevy&light=spot&angle=170&map_size=256');  // no numbers, and no error on the console
    await ready(page);
    const no_numbers = 'There are no numbers for this light: map_size must be larger for this filter; got 256.';
    check((await cell(page, 'notice')) === no_numbers && !(await page.locator('#found').isVisible()), `the page says ${await cell(page, 'notice')}`);
    await page.selectOption('#map_size', '8192');
    await page.waitForSelector('#found:not([hidden])');
    await page.context().close();

    for (const [hash, width, dark] of [['', 1280, false], ['', 390, false], ['#engine=unity_urp', 390, true], ['#engine=unity_urp&light=point', 390, false], ['#engine=other', 390, false]]) {
        page = await open(`bias.html${hash}`, { width, dark });
        await ready(page);
        const room = await page.evaluate(() => document.documentElement.scrollWidth);
        check(room <= width, `the page is ${room} pixels wide in a window of ${width}`);
        check((await page.locator('#no_numbers').isVisible()) === (hash === '#engine=other'), `${hash}: how to measure is shown wrongly`);
        await picture(page, `bias_${hash.slice(8) || 'godot'}_${width}`);
        await axe(page);
        await page.context().close();
    }
});

/// state.ts, which needs no browser.
async function state_module() {
    const load = createRequire(join(resolve(process.argv[3]), 'x.js'));
    const { outputFiles } = await load('esbuild').build({ entryPoints: [sources('examples/site/bias/state.ts')], bundle: true, format: 'esm', write: false });
    return import(`data:text/javascript,${encodeURIComponent(outputFiles[0].text)}`);
}
