// SPDX-License-Identifier: MIT
//
// The live scene: the GPU's picture equals C++'s, controls and address change both, files are drawn or refused in words.
import { mkdtempSync, rmSync, truncateSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

import { copied, visit, webgl_flags } from './visit.mjs';

/** Waits for C++'s answer to what the page shows. */
const answer = page => page.waitForFunction(() => document.querySelector('#picture').dataset.compared)
    .catch(async () => { throw new Error(`${page.url()} says "${await page.textContent('#verdict')}" and "${await said(page)}"`); });
const forget = page => page.evaluate(() => { document.querySelector('#picture').dataset.compared = ''; });
const seen = page => page.evaluate(() => {
    const picture = document.querySelector('#picture');
    return { ...JSON.parse(picture.dataset.compared), picture: picture.toDataURL(), lines: document.querySelector('#lines pre').textContent };
});
const said = page => page.textContent('#said');
/** Number of hues, of twelve, that fill a hundredth of the picture each. */
const hues = page => page.evaluate(() => {
    const drawn = document.querySelector('#picture'), copy = document.createElement('canvas'), counts = new Array(12).fill(0);
    Object.assign(copy, { width: drawn.width, height: drawn.height });
    const context = copy.getContext('2d');
    context.drawImage(drawn, 0, 0);
    const { data } = context.getImageData(0, 0, copy.width, copy.height);
    for (let i = 0; i < data.length; i += 4) {
        const [r, g, b] = data.slice(i, i + 3), most = Math.max(r, g, b), range = most - Math.min(r, g, b);
        if (range < 24) continue;
        const sixth = most === r ? (g - b) / range + 6 : most === g ? (b - r) / range + 2 : (r - g) / range + 4;
        ++counts[Math.floor(2 * sixth) % 12];
    }
    return counts.filter(count => count > data.length / 400).length;
});

const cube = `${[0, 1, 2, 3, 4, 5, 6, 7].map(n => `v ${n & 1} ${n >> 1 & 1} ${n >> 2}`).join('\n')}
f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4\n`;

/** A binary glTF of a JSON text and one buffer. */
function glb(json, data = Buffer.alloc(0)) {
    const chunk = (kind, bytes, fill) => {
        const padded = Buffer.concat([bytes, Buffer.alloc((4 - bytes.length % 4) % 4, fill)]), head = Buffer.alloc(8);
        head.writeUInt32LE(padded.length, 0);
        head.writeUInt32LE(kind, 4);
        return Buffer.concat([head, padded]);
    };
    const chunks = [chunk(0x4e4f534a, Buffer.from(JSON.stringify(json)), ' ')], head = Buffer.alloc(12);
    if (data.length) chunks.push(chunk(0x004e4942, data, 0));
    head.writeUInt32LE(0x46546c67, 0);
    head.writeUInt32LE(2, 4);
    head.writeUInt32LE(12 + chunks.reduce((sum, c) => sum + c.length, 0), 8);
    return Buffer.concat([head, ...chunks]);
}
/** A glTF of three vertices and as many indices as asked for. */
function triangles(indices) {
    const data = Buffer.alloc(36 + 2 * indices);
    [0, 0, 0, 1, 0, 0, 0, 1, 0].forEach((v, i) => data.writeFloatLE(v, 4 * i));
    for (let i = 0; i < indices; ++i) data.writeUInt16LE(i % 3, 36 + 2 * i);
    return glb({ asset: { version: '2.0' }, scenes: [{ nodes: [0] }], nodes: [{ mesh: 0 }],
        meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }], buffers: [{ byteLength: data.length }],
        bufferViews: [{ buffer: 0, byteOffset: 0, byteLength: 36 }, { buffer: 0, byteOffset: 36, byteLength: 2 * indices }],
        accessors: [{ bufferView: 0, componentType: 5126, count: 3, type: 'VEC3', min: [0, 0, 0], max: [1, 1, 0] },
            { bufferView: 1, componentType: 5123, count: indices, type: 'SCALAR' }] }, data);
}

// files too large to be sent through the driver
const folder = mkdtempSync(join(tmpdir(), 'umbrage_')), large = join(folder, 'large.obj'), many = join(folder, 'many.glb');
writeFileSync(large, '');
truncateSync(large, 201e6);  // all holes
writeFileSync(many, triangles(15_000_003));
process.on('exit', () => rmSync(folder, { recursive: true }));
const refused = [
    [{ name: 'empty.obj', mimeType: '', buffer: Buffer.alloc(0) }, 'is empty'],
    [{ name: 'words.obj', mimeType: '', buffer: Buffer.from('hello\n') }, 'has no faces'],
    [{ name: 'infinite.obj', mimeType: '', buffer: Buffer.from(cube.replace('v 1 1 1', 'v 1 1e999 1')) }, 'line 8: "1e999" is not a finite number'],
    [{ name: 'missing.obj', mimeType: '', buffer: Buffer.from(`${cube}f 1 2 9\n`) }, 'there is no vertex "9"'],
    [{ name: 'flat.obj', mimeType: '', buffer: Buffer.from('v 1 1 1\nf 1 1 1\n') }, 'has no extent'],
    [{ name: 'picture.png', mimeType: '', buffer: Buffer.from('x') }, 'neither OBJ nor glTF'],
    [{ name: 'broken.glb', mimeType: '', buffer: Buffer.from('glTF????') }, 'is not a glTF file that can be read'],
    [{ name: 'draco.glb', mimeType: '', buffer: glb({ asset: { version: '2.0' }, extensionsRequired: ['KHR_draco_mesh_compression'] }) }, 'compressed by Draco'],
    [{ name: 'outside.gltf', mimeType: '', buffer: Buffer.from(JSON.stringify({ asset: { version: '2.0' }, buffers: [{ uri: 'a.bin', byteLength: 1 }] })) },
        'keeps its vertices in a.bin'],
    [many, 'more than 5 million triangles'],
    [large, 'has 201 MB'],
];

await visit(async ({ open, check, picture, axe }) => {
    const page = await open('?pitch=30', { width: 390 });
    await answer(page);
    const first = await seen(page);
    check(first.receivers > 1e5 && first.different === 0, `${first.different} of ${first.receivers} pixels differ`);
    check(first.lines.includes('umbrage_tent3'), 'the lines are those of the default filter');

    // each change waits for C++, whose answer could else be taken for that of the next change
    const after = async change => {
        await forget(page);
        await change();
        await answer(page);
        return seen(page);
    };

    // a filter changes picture, lines and address; the address brings all of it back
    const hard = await after(() => page.selectOption('#set-filter', 'hard'));
    check(hard.different === 0 && hard.picture !== first.picture, 'another filter makes another picture');
    check(hard.lines.includes('umbrage_hard') && !hard.lines.includes('tent3'), 'and other lines');
    await page.waitForURL(/filter=hard/);
    await page.reload();
    await answer(page);
    const again = await seen(page);
    check(again.picture === hard.picture && again.lines === hard.lines, 'the address restores the picture');

    // languages and copying
    await page.check('input[value=wgsl]');
    await page.waitForFunction(() => document.querySelector('#lines pre').textContent.includes('fn umbrage_sun('));
    const shader = await copied(page, '#lines button');
    check(shader === (await page.locator('#lines pre').allTextContents()).join('\n'), 'copy copies the whole shader');
    check(/^\/\/ Copyright .* the umbrage authors/m.test(shader), 'what is copied says whose it is');
    check(await page.isVisible('#lines > pre') && !await page.isVisible('#lines details pre'), 'main() is shown, the library folded');
    await page.check('input[value=glsl]');
    await page.waitForFunction(() => document.querySelector('#lines > pre').textContent.includes('void main() {'));
    const complaint = await page.evaluate(text => {
        const gl = document.createElement('canvas').getContext('webgl2'), made = gl.createShader(gl.FRAGMENT_SHADER);
        gl.shaderSource(made, text);
        gl.compileShader(made);
        return gl.getShaderInfoLog(made);
    }, await copied(page, '#lines button'));
    check(complaint === '', `the shader does not compile: ${complaint}`);

    // the divider, and views
    const at = () => page.locator('#divided span').last().evaluate(span => span.getBoundingClientRect().left);
    const middle = await at();
    await page.locator('#divider').press('PageUp');
    check(await at() > middle, 'the divider moves');
    for (const view of ['difference', 'texels', 'map', 'both']) {
        const before = (await seen(page)).picture;
        check((await after(() => page.check(`input[value=${view}]`))).picture !== before, `another picture to see: ${view}`);
    }

    // pages: those that the view needs, in colors of their own, equal to C++
    check((await after(() => page.check('input[value=texels]'))).maps === 1, 'the sun has one map');
    const plain = await hues(page), pages = await after(() => page.selectOption('#set-light', 'adaptive_pages')), colored = await hues(page);
    check(pages.different === 0 && pages.maps > 20 && pages.maps <= 64, `${pages.maps} pages, ${pages.different} pixels differ`);
    check(colored > plain + 2, `pages have ${colored} colors, one map ${plain}`);
    check((await page.textContent('#time')).includes(`${pages.maps} of 64 pages`), 'the page says how many pages there are');
    for (const language of ['hlsl', 'msl', 'wgsl', 'glsl']) {
        await page.check(`input[value=${language}]`);
        await page.waitForFunction(() => document.querySelector('#lines pre').textContent.includes('umbrage_map_tile('));
    }
    await page.waitForURL(/light=adaptive_pages/);
    await page.reload();
    await answer(page);
    const restored = await seen(page);
    check(restored.picture === pages.picture && restored.maps === pages.maps, 'the address restores the pages');
    await page.focus('#picture');
    await page.hover('#picture');
    const closer = await after(() => page.mouse.wheel(0, -800));
    check(closer.different === 0 && closer.maps !== pages.maps, `a closer camera needs ${closer.maps} pages, not ${pages.maps}`);
    // hills far away have pixels without a normal
    const packed = await open('?scene=outdoor&light=adaptive_pages&depth=reversed&encoding=rg16&filter=pcf_2x2&bias=none&size=256' +
        '&yaw=-40&distance=1.3&azimuth=-40&elevation=33', { width: 390 });
    await answer(packed);
    check((await seen(packed)).different === 0, 'packed pages of reversed depth without a bias are equal to C++ too');
    await after(() => page.check('input[value=both]'));

    // keys turn camera and light
    await page.focus('#picture');
    await page.keyboard.press('ArrowRight');
    await page.keyboard.press('Shift+ArrowLeft');
    await page.waitForURL(url => url.search.includes('yaw=') && url.search.includes('azimuth='));

    // files
    for (const [file, words] of refused) {
        await page.setInputFiles('#file', file);
        await page.waitForFunction(part => document.querySelector('#said').textContent.includes(part), words)
            .catch(async () => check(false, `${file.name ?? file}: the page says "${await said(page)}", not "${words}"`));
        check(await page.inputValue('#set-scene') === 'garden', `${file.name ?? file}: the scene stays`);
    }
    for (const file of [{ name: 'cube.obj', mimeType: '', buffer: Buffer.from(cube) }, { name: 'one.glb', mimeType: '', buffer: triangles(3) }]) {
        const drawn = await after(() => page.setInputFiles('#file', file));
        check(drawn.different === 0 && await page.inputValue('#set-scene') === 'dropped', `${file.name} is drawn: ${await said(page)}`);
    }

    // a lost context comes back
    await forget(page);
    await page.evaluate(() => {
        const lost = document.querySelector('#picture').getContext('webgl2').getExtension('WEBGL_lose_context');
        lost.loseContext();
        setTimeout(() => lost.restoreContext(), 200);
    });
    await page.waitForFunction(() => document.querySelector('#said').textContent.includes('took the graphics away'));
    await answer(page);
    check((await seen(page)).different === 0 && await said(page) === '', 'the scene comes back');

    // what the address or the browser lacks is said
    const wrong = await open('?filter=blurry&azimuth=x', { width: 390 });
    await answer(wrong);
    check((await said(wrong)).includes('filter=blurry, azimuth=x'), 'a wrong address is said');
    check(await wrong.isDisabled('#set-softness'), 'a filter without a size does not take one');
    await wrong.selectOption('#set-filter', 'disc16');
    check(await wrong.isEnabled('#set-softness'), 'a filter with a size takes it');
    check(await wrong.getByText('Light above: 30°').isVisible(), 'a slider says its value');
    const without = await open('', { before: () => { HTMLCanvasElement.prototype.getContext = () => null; } });
    await without.waitForFunction(() => document.querySelector('#said').textContent.includes('no WebGL 2'));
    check(await without.isVisible('.instead'), 'without WebGL 2 there is a picture all the same');

    // the front page as a whole
    for (const [width, dark] of [[1280, false], [390, true]]) {
        const shown = await open('', { width, dark });
        await answer(shown);
        check(await shown.locator('nav a').count() >= 4, 'the front page has a navigation');
        const [sentence] = (await shown.textContent('.lead')).split(/\.\s/);
        check(/^Most\b.*\bsame bits\b.*\brest\b.*\bstated bound/s.test(sentence), `the first sentence promises "${sentence}"`);
        const [verdict, drawn] = await Promise.all(['.line', '#picture'].map(part => shown.locator(part).boundingBox()));
        const ends = verdict.y + verdict.height;
        check(width < 600 || ends <= Math.min(800, drawn.y + drawn.height), `the verdict ends at ${ends}, not on the picture`);
        const room = await shown.evaluate(() => document.documentElement.scrollWidth);
        check(room <= width, `the scene's page is ${room} pixels wide in a window of ${width}`);
        await picture(shown, `scene_${width}${dark ? '_dark' : ''}`);
        await axe(shown);
    }
}, webgl_flags);
