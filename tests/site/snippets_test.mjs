// SPDX-License-Identifier: MIT
//
// The snippets' page: finds by names people use, composes what the npm package does, copies, downloads, keeps its state
// in the address, and says so where an address is wrong.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

import { layout_shift } from './shift.mjs';
import { address_of, copied, visit } from './visit.mjs';

const package_of = async name =>
    import(pathToFileURL(new URL(`../../single_include/${name}.mjs`, import.meta.url).pathname));
const copyright = readFileSync(new URL('../../LICENSE', import.meta.url), 'utf8').match(/^Copyright.*/m)[0];
const given = text => // the package's text as the site gives it away
    text.replace(/^.*, MIT License.*$/m, line => `${line}\n// ${copyright}. License text: LICENSE in the umbrage repository.`);
const [glsl, hlsl, wgsl, msl] = await Promise.all(['umbrage', 'hlsl', 'wgsl', 'msl'].map(package_of));

await visit(async ({ open, check, picture, axe }) => {
    const ready = page => page.waitForSelector('#detail:not(.loading)');
    const text = page => page.locator('#code').textContent();

    // Names people use.
    let page = await open('snippets/');
    await ready(page);
    check((await layout_shift(page)) === 0, 'the page shifts as it loads');
    check((await text(page)) === given(glsl.text([glsl.pcf_2x2])), 'the first text is not that of the package');
    for (const [query, name] of [
        ['CSM', 'cascade'],
        ['light bleeding', 'reduce_light_bleeding'],
        ['Poisson', 'disc16'],
        ['percentage-closer soft', 'pcss16'],
    ]) {
        await page.fill('#search', query);
        const found = await page.locator('#list button').evaluateAll(rows => rows.map(row => row.dataset.name));
        check(
            found.some(each => each.startsWith(name)),
            `"${query}" finds ${found.slice(0, 5)}`,
        );
    }
    await page.fill('#search', 'zzqx');
    check(
        (await page.locator('#count').textContent()) === 'No function has these words.',
        'a search without results says so',
    );

    // By keyboard: the first that is found, then copy.
    await page.fill('#search', 'pcss');
    await page.press('#search', 'Enter');
    await page.waitForFunction(() => document.getElementById('name').textContent.startsWith('pcss'));
    check((await copied(page, '#copy')) === (await text(page)), 'what was copied is not the text');
    const permalink = await copied(page, '#link');
    check(permalink.includes('?snippet=pcss'), `the link is ${permalink}`);
    const download = page.waitForEvent('download');
    await page.click('#download');
    check(/^pcss\w*\.glsl$/.test((await download).suggestedFilename()), 'the download has a name');
    check(
        readFileSync(await (await download).path(), 'utf8') === (await text(page)),
        'what was downloaded is not the text',
    );

    // Two maps in one text, chosen by hand; each language; the same again from the address.
    await page.fill('#map_name', 'sun');
    await page.selectOption('#texture', 'array');
    await page.selectOption('#direction', 'reversed');
    await page.click('#add');
    await page.fill('#search', 'pcf_2x2');
    await page.press('#search', 'Enter');
    await page.selectOption('#texture', 'atlas');
    await page.selectOption('#stored', 'rg16');
    const first = new URL(await address_of(page)).searchParams.get('snippet');
    for (const [id, from] of Object.entries({ glsl, hlsl, wgsl, msl })) {
        await page.click(`label:has(input[value=${id}])`);
        const wanted = given(
            from.text([
                from.bind(from.snippets[first], 'sun', { texture: 'array', direction: 'reversed' }),
                from.bind(from.pcf_2x2, 'map_2', { ...from.rg16.reversed, texture: 'atlas' }),
            ]),
        );
        check(wanted.includes(copyright), `the text in ${id} does not say whose it is`);
        await page
            .waitForFunction(wanted => document.getElementById('code').textContent === wanted, wanted)
            .catch(() => check(false, `two maps in ${id} are not as the package composes them`));
    }
    await page.click('label:has(input[value=glsl])');
    await page.selectOption('#version', '300 es');
    await page.waitForFunction(() => document.getElementById('code').textContent.startsWith('#version 300 es'));
    const before = await text(page),
        address = new URL(await address_of(page));
    page = await open(`snippets/${address.search}`);
    await ready(page);
    check((await text(page)) === before, 'the address does not restore the state');
    check((await layout_shift(page)) === 0, 'the page shifts as it restores a state');
    check(await page.locator('#notice').isHidden(), 'a right address is told to be wrong');
    await page.click('label:has(input[value=depth])');
    await page.waitForFunction(() => document.getElementById('code').textContent.includes('umbrage_write_map_2('));

    // Wrong addresses and maps that cannot be: all are told, some are seen.
    const { parse, print, choices } = await state_module();
    const is_snippet = name => name in glsl.snippets,
        told_of = query => parse(query, is_snippet).problems.join(' ');
    for (const [query, told] of [
        ['?snippet=gone', 'No function is called "gone"'],
        ['?language=cobol', 'No language is called "cobol"'],
        ['?version=7', 'No version of GLSL is called "7"'],
        ['?snippet=hard&texture=sponge', '"sponge" is no choice of "texture"'],
        ['?snippet=hard&map=a__b', 'single underscores'],
        ['?toString=1', 'does not know'],
        ['?pass=x', 'No pass is called'],
        ['?texture=array', 'does not know'],
    ])
        check(told_of(query).includes(told), `${query}: ${told_of(query)}`);
    for (const [key, values] of Object.entries(choices))
        for (const value of values) {
            const { state, problems } = parse(`?snippet=hard&map=a&${key}=${value}`, is_snippet);
            check(
                problems.length === 0 && parse(print(state), is_snippet).state.items[0][key] === value,
                `${key}=${value} is lost`,
            );
        }
    for (const [query, told] of [
        ['?snippet=gone', 'No function is called "gone"'],
        ['?snippet=pcf_2x2&texture=cube&gather=yes', 'map.gather must be false'],
        ['?version=100&snippet=hard&texture=array', 'version must be one that has'],
    ]) {
        const wrong = await open(`snippets/${query}`);
        await ready(wrong);
        check(
            (await wrong.locator('#notice').textContent()).includes(told),
            `${query}: ${await wrong.locator('#notice').textContent()}`,
        );
        check((await text(wrong)).includes('umbrage_'), `${query} shows no text`);
        check((await layout_shift(wrong)) === 0, `${query} shifts`);
        await wrong.context().close();
    }

    // Facts: the promise, the needs, the cost and whose estimate it is.
    const facts = await open('snippets/?snippet=pcf_2x2');
    await ready(facts);
    const list = await facts.locator('#fact_list').textContent();
    for (const part of ['tier A', 'in_filter_domain', "a compiler's estimate", 'instructions', 'bilinear PCF'])
        check(list.includes(part), `the facts lack ${part}: ${list}`);
    check(!list.includes('this text'), 'a text has another tier than its only function');
    const both = await open('snippets/?snippet=chebyshev&snippet=pcf_2x2');
    await ready(both);
    check(
        (await both.locator('#fact_list').textContent()).includes('this texttier C'),
        'the tier of a text with chebyshev is not C',
    );
    for (const [id, values] of Object.entries(choices))
        check(
            JSON.stringify(values) ===
                JSON.stringify(await facts.locator(`#${id} option`).evaluateAll(all => all.map(each => each.value))),
            `the page has other choices of ${id} than state.ts`,
        );
    for (const [width, dark] of [
        [1280, false],
        [390, true],
    ]) {
        const page = await open('snippets/?snippet=pcf_2x2&map=sun&snippet=disc16&map=spot', { width, dark });
        await ready(page);
        check(
            (await page.evaluate(() => document.documentElement.scrollWidth)) <= width,
            `the page is wider than ${width}`,
        );
        await picture(page, `snippets_${width}${dark ? '_dark' : ''}`);
        await axe(page);
    }
});

/// state.ts, which needs no browser.
async function state_module() {
    const load = createRequire(join(resolve(process.argv[3]), 'x.js')),
        source = new URL('../../examples/site/snippets/state.ts', import.meta.url);
    const { code } = load('esbuild').transformSync(readFileSync(source, 'utf8'), { loader: 'ts' });
    return import(`data:text/javascript,${encodeURIComponent(code)}`);
}
