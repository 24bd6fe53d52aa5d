// SPDX-License-Identifier: MIT
//
// The page that checks a shader: it knows our own filter by its bits in each language, and names a slip that was
// planted. It gives a compiler's message by the reader's line, and an answer's link opens the same state.
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { gzipSync } from 'node:zlib';

import { layout_shift } from './shift.mjs';
import { address_of, visit, webgl_flags, webgpu_flags } from './visit.mjs';

const package_of = async name =>
    import(pathToFileURL(new URL(`../../single_include/${name}.mjs`, import.meta.url).pathname));
const glsl = await package_of('umbrage'),
    wgsl = await package_of('wgsl');
const folder = join(process.argv[2], 'check');

await visit(
    async ({ open, check, picture, axe }) => {
        const answered = page =>
            page.waitForFunction(() => document.body.dataset.state === 'done', null, { polling: 50 });
        const value = (page, id) => page.locator(`#${id}`).inputValue();
        const argument = (page, name) => page.locator(`#needs input[name="${name}"]`);

        /// Pastes a text, checks it, and gives the answer in words.
        async function ask(page, text, choose = async () => {}) {
            await page.fill('#text', text);
            await choose();
            await page.evaluate(() => {
                delete document.body.dataset.state;
            });
            await page.click('#check');
            await answered(page);
            return page.locator('#answer').innerText();
        }
        const says = (answer, words, what) => check(answer.includes(words), `${what}: ${answer.slice(0, 400)}`);

        const page = await open('check/');
        await page.waitForFunction(() => document.querySelectorAll('#is option').length > 10);
        check((await layout_shift(page)) < 0.05, 'the page shifts as it loads');
        check((await page.locator('#example option').count()) >= 4, 'there are few examples');

        // Our own filter, to the bit, in each language; its arguments are found.
        for (const [language, text] of [
            ['glsl300', glsl.source('300 es', [glsl.pcf_2x2])],
            ['glsl100', glsl.source('100', [glsl.pcf_2x2])],
            ['wgsl', wgsl.text([wgsl.pcf_2x2])],
        ]) {
            const answer = await ask(page, text);
            check(
                (await value(page, 'language')) === language,
                `the text in ${language} is taken for ${await value(page, 'language')}`,
            );
            for (const [name, expression] of [
                ['map', 'map'],
                ['size', 'size'],
                ['coord', 'coord'],
                ['receiver', 'z'],
            ])
                check(
                    (await argument(page, name).inputValue()) === expression,
                    `${name} is taken for ${await argument(page, name).inputValue()}`,
                );
            says(answer, 'The same bits as pcf_2x2', `pcf_2x2 in ${language}`);
        }

        // A filter whose name does not say so, below functions that it calls.
        for (const [language, text] of [
            ['glsl300', glsl.source('300 es', [glsl.hard])],
            ['wgsl', wgsl.text([wgsl.hard])],
        ])
            says(await ask(page, text), 'The same bits as hard', `hard in ${language}`);

        // Half a texel, planted into a call: named, with an exhibit, an input, and the inputs that agree.
        await ask(page, glsl.source('300 es', [glsl.pcf_2x2]), () => argument(page, 'coord').fill('coord + 0.5'));
        const slipped = await page.locator('#answer').innerText();
        says(slipped, 'This is pcf_2x2, shifted by (0.5, 0.5) texel', 'half a texel');
        says(slipped, 'your shader', 'an input on which they differ');
        check(
            (await page.locator('[data-kind=shift] a[href^="../museum.html#"]').count()) === 1,
            'the slip leads to no exhibit',
        );
        check(await page.locator('#answer svg').first().isVisible(), 'the map is not drawn');

        // The link of that answer opens the same state, and answers again.
        await page.click('#link');
        await page.getByText('Link copied.').waitFor();
        const link = await page.evaluate(() => navigator.clipboard.readText());
        check(link === (await address_of(page)), 'the link is not the address');
        const opened = await open(link.slice(link.indexOf('check/')));
        await answered(opened);
        check(
            (await opened.locator('#answer h2').innerText()) === (await page.locator('#answer h2').innerText()),
            'the link has another answer',
        );
        for (const id of ['text', 'language', 'api', 'of', 'subject', 'is'])
            check((await value(opened, id)) === (await value(page, id)), `the link has another ${id}`);
        check((await argument(opened, 'coord').inputValue()) === 'coord + 0.5', 'the link has another coordinate');
        await opened.context().close();

        // Expected to be another function; a uniform with a value; the answer of a text that has changed is pale.
        const tap = `uniform sampler2D depths;
uniform float bias;
float shadow(vec2 uv, float z) {
    return z - bias > texture(depths, uv).r ? 0.0 : 1.0;
}
`;
        says(
            await ask(page, tap, () => page.selectOption('#is', 'pcf_2x2')),
            'This is hard, not pcf_2x2',
            'another function',
        );
        says(
            await ask(page, tap, () => argument(page, 'bias').fill('0.125 / size.x * size.x')),
            'bias of 0.125',
            'a uniform',
        );
        await page.evaluate(() => {
            delete document.body.dataset.state;
        });
        await page.click('#check');
        await page.fill('#text', `${tap} `); // while it is checked, or soon after
        await answered(page);
        check((await page.locator('#answer.stale').count()) === 1, 'an old answer looks like one of the new text');

        // Packing, where targets take no floats.
        const plain = await open('check/', {
            before: () => {
                const get = WebGLRenderingContext.prototype.getExtension;
                WebGLRenderingContext.prototype.getExtension = function (name) {
                    return name === 'WEBGL_color_buffer_float' ? null : get.call(this, name);
                };
                delete window.OffscreenCanvas; // the page runs the check itself, with that change
            },
        });
        await plain.selectOption('#example', 'packing');
        says(await ask(plain, await value(plain, 'text')), 'base255', 'base 255 in bytes');
        await plain.context().close();

        // What users do wrong.
        for (const [text, words, choose] of [
            [
                'float shadow(sampler2D map, vec2 uv, float z) {\n\n    return z <= texture(map, uv) ? 1.0 : 0.0;\n}',
                'Line 3: ',
            ],
            [
                'float shadow(vec2 uv, float z) {\n    return texture(shadowMap, uv).r;\n}',
                'Declare shadowMap above the function',
            ],
            ['#include <packing>\nfloat shadow(vec2 uv, float z) { return 1.0; }', 'Line 1 includes <packing>'],
            ['float shadow(float2 uv, float z) { return z; }', 'looks like HLSL'],
            ['vec2 nothing;', 'The text has no function'],
            ['void shadow(vec2 uv) {}', 'shadow returns nothing'],
            ['float shadow(vec2 offsets[2], float z) { return z; }', 'Say what stands for offsets'],
            [tap, 'uv = uv * wrong: ', () => argument(page, 'uv').fill('uv * wrong')],
            [tap, 'vec3(uv, 1.0)', () => argument(page, 'uv').fill('vec3(uv, 1.0)')],
            [tap, 'it can be map or linear_map', () => argument(page, 'depths').fill('shadow_map')],
            [
                'fn shadow(map: texture_2d<f32>, uv: vec2f, z: f32) -> f32 {\n    return textureLoad(map, uv, 0).x;\n}',
                'Line 2: ',
            ],
        ])
            says(await ask(page, text, choose), words, text.slice(0, 40));
        const without = await open('check/#api=webgl9&color=red', {
            before: () => {
                delete window.OffscreenCanvas;
                Object.defineProperty(Navigator.prototype, 'gpu', { value: undefined });
            },
        });
        check(
            (await without.locator('.notice').count()) === 2,
            `${await without.locator('.notice').count()} of 2 complaints about the address`,
        );
        says(await ask(without, wgsl.text([wgsl.pcf_2x2])), 'This browser offers no WebGPU', 'without WebGPU');
        await without.context().close();

        // Two widths, dark and light.
        await ask(page, glsl.source('300 es', [glsl.pcf_2x2]), () => argument(page, 'coord').fill('coord + 0.5'));
        await page.locator('#answer details summary').first().click();
        for (const width of [1280, 390])
            for (const dark of [false, true]) {
                await page.setViewportSize({ width, height: 844 });
                await page.emulateMedia({ colorScheme: dark ? 'dark' : 'light' });
                const room = await page.evaluate(() => document.documentElement.scrollWidth);
                check(room <= width, `the page is ${room} pixels wide in a window of ${width}`);
                await picture(page, `check_${width}${dark ? '_dark' : ''}`);
                await axe(page);
            }

        const size = readdirSync(folder).reduce(
            (sum, name) => sum + gzipSync(readFileSync(join(folder, name))).length,
            0,
        );
        check(size < 1e6, `the page is ${size} bytes, compressed`);
        console.log(`${size} bytes, compressed`);
    },
    [...webgl_flags, ...webgpu_flags],
);
