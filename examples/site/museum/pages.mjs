// SPDX-License-Identifier: MIT
//
// The museum's page: MUSEUM.md with a drawing of each exhibit's test, then and ours, and what depth and filters look like.
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';

import { escape } from '../context.mjs';
import { page } from '../page.mjs';
import { plain } from '../reference/markdown.mjs';
import { model } from '../reference/model.mjs';
import { curves } from './curves.mjs';

/// Further pictures of the repository. Their words are those of the pages that show them.
const rooms = [
    ['Depth in few bits', ['depths', 'quantization']],
    ['Filters on one edge', ['filters', 'hardening']],
    ['Biases', ['biases']],
    ['Troubles, and their cures', ['acne', 'detached', 'aliasing', 'shimmer', 'leak', 'seams', 'thin', 'contact']],
];

/// What a page of the repository says of its picture .media/NAME.png.
function words_of(name, texts) {
    const shown = new RegExp(`!\\[([^\\]]*)\\]\\([./]*\\.media/${name}\\.png\\)`);
    const found = texts.map(text => shown.exec(text)).find(Boolean);
    if (!found) throw new Error(`No page shows .media/${name}.png`);
    return plain(found[1]);
}

const right = [24, 66, 54], slightly = [236, 190, 92], wrong = [222, 62, 44];

/// A drawing of tests/proof/museum as a PNG in color, and whether it is of one input alone.
function colored(context, file) {
    const { PNG } = context.load('pngjs'), bytes = readFileSync(file);
    const [, width, height] = /^P5\n(\d+) (\d+)\n255\n/.exec(bytes.subarray(0, 32).toString('latin1')), cells = bytes.subarray(-width * height);
    const png = new PNG({ width: Number(width), height: Number(height), colorType: 2 });
    cells.forEach((cell, i) => {
        const color = cell === 0 ? right : slightly.map((c, channel) => Math.round(c + (wrong[channel] - c) * cell / 255));
        png.data.set([...color, 255], 4 * i);
    });
    return { png: PNG.sync.write(png, { colorType: 2 }), is_one: cells.length === 1 };
}

const figure = (number, title, is_one) => `<figure class="exhibit${is_one ? ' one' : ''}">
<div class="pair"><img src="pictures/museum/${number}_then.png" alt="The old formula's test of exhibit ${number}" loading="lazy">
<img src="pictures/museum/${number}_ours.png" alt="The same test of umbrage" loading="lazy"><span>old formula</span><span>umbrage</span></div>
<input type="range" min="0" max="1" step="0.01" value="0.5" aria-label="Divider between the old formula and umbrage: ${title}">
</figure>
`;

export async function pages(context) {
    const drawn = join(context.work, 'museum');
    mkdirSync(drawn, { recursive: true });
    execFileSync(context.museum, ['--draw', drawn]);
    const all = (await model(context)).pages, texts = all.map(each => each.text);
    const { title, description, body } = all.find(each => each.source === 'MUSEUM.md');
    let exhibits = 0;
    const with_figures = body.replace(/(<h2 id="[^"]*">(\d+)\. (.*?)<\/h2>\n)([^]*?)(?=<h2|$)/g, (all, heading, number, name, words) => {
        ++exhibits;
        const [then, ours] = ['then', 'ours'].map(side => colored(context, join(drawn, `${number}_${side}.pgm`)));
        context.write(`pictures/museum/${number}_then.png`, then.png);
        context.write(`pictures/museum/${number}_ours.png`, ours.png);
        return `<section class="hung">\n${heading}${figure(number, name.replace(/<[^>]*>/g, ''), then.is_one)}<div>\n${words}</div>\n</section>\n`;
    });
    if (exhibits < 20) throw new Error(`MUSEUM.md shows ${exhibits} exhibits`);
    const pictures = rooms.map(([name, shown]) => `<h2 id="${name.toLowerCase().replace(/\W+/g, '-')}">${name}</h2>\n` + shown.map(file => {
        const words = words_of(file, texts), path = `.media/${file}.png`, head = readFileSync(join(context.root, path)).subarray(16, 24);
        if (!context.written.includes(`pictures/${file}.png`)) context.copy(path, `pictures/${file}.png`);
        return `<figure><img src="pictures/${file}.png" width="${head.readUInt32BE(0)}" height="${head.readUInt32BE(4)}" alt="${escape(words)}" loading="lazy">
<figcaption>${escape(words)}</figcaption></figure>`;
    }).join('\n'));
    await context.bundle('museum/divide.ts', 'museum.js');
    const how = `<p class="legend">Each drawing is the test itself: a point is a run of the inputs tried. <span class="right">Dark</span> is right,
<span class="wrong">bright</span> is wrong, redder for larger errors. Left of the divider is the old formula, right of it umbrage.</p>`;
    return [{ path: 'museum.html', html: page({ path: 'museum.html', title, description, scripts: ['museum.js'],
        body: `<div class="prose museum">${with_figures.replace('<section', `${how}\n<section`)}
<h2 id="error-over-depth">Error of every encoding over depth</h2>
${curves(readFileSync(join(drawn, 'encodings.tsv'), 'utf8'))}
${pictures.join('\n')}</div>` }) }];
}
