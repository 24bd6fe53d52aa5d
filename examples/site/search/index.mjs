// SPDX-License-Identifier: MIT
//
// Things that the search box finds: names people use, shader functions, public names, headings of pages. One JSON file.
import { known_as as known_as_bias } from '../bias/pages.mjs';
import { known_as as known_as_check } from '../check/words.mjs';
import { header_page } from '../reference/links.mjs';
import { anchor, plain } from '../reference/markdown.mjs';
import { model } from '../reference/model.mjs';
import { known_as } from '../start/text.mjs';

/// Kinds of what is found, as box.ts shows them. An item is [title, kind, address, words].
const kinds = { known: 0, shader: 1, name: 2, heading: 3 };

export async function search_index(context) {
    const { addresses, entries, pages, places, texts } = await model(context);
    const entry_address = name => `${header_page(places.get(name).place)}#${name}`;
    const known = known_names(context, addresses);
    const with_others = (words, name) => {
        const also = known.filter(({ here }) => here.includes(name)).flatMap(({ names }) => names);
        return also.length ? `${words.replace(/\.$/, '')}. Also called ${also.join(', ')}` : words;
    };
    return [
        ...known_as.map(names => [names, kinds.known, 'start.html', 'Start']),
        [known_as_bias, kinds.known, 'bias.html', 'Bias'],
        ...known_as_check.map(names => [names, kinds.known, 'check/', 'Check a shader']),
        ...known.map(({ names, here, address }) => [names.join(', '), kinds.known, address, here.join(', ')]),
        ...Object.values(texts.glsl.snippets).map(({ name, summary }) => [
            name,
            kinds.shader,
            `snippets/?snippet=${name}`,
            with_others(summary, name),
        ]),
        ...entries
            .filter(each => places.get(each.name) === each)
            .map(each => [
                each.name,
                kinds.name,
                entry_address(each.name),
                with_others(each.items.find(item => item.brief)?.brief ?? '', each.name),
            ]),
        ...pages.flatMap(page =>
            page.headings
                .filter(each => each.depth < 4)
                .map(each => [
                    each.text,
                    kinds.heading,
                    `${page.path.replace(/index\.html$/, '')}${each.depth > 1 ? `#${each.anchor}` : ''}`,
                    each.depth > 1 ? page.title : page.description,
                ]),
        ),
        ...pages.filter(page => page.source).flatMap(page =>  // the rows of Start are those of README.md
            situations(page).map(({ title, words, above }) => [
                title,
                kinds.heading,
                `${page.path.replace(/index\.html$/, '')}#${above}`,
                `${words}. ${page.title}`,
            ]),
        ),
    ];
}

/// The lines of INDEX.md: names people use, and the names here that they stand for, or the address of a page.
export function known_names(context, addresses) {
    return Array.from(context.read('INDEX.md').matchAll(/^- (.+?): (\[.+\))$/gm), ([, names, links]) => {
        const here = Array.from(links.matchAll(/\[`(\w+)/g), match => match[1]);
        const [, words, file, anchor] = /^\[(.+?)\]\((.+?)(#.+?)?\)/.exec(links);
        return {
            names: plain(names).split(', '),
            here: here.length ? here : [plain(words)],
            address: addresses.of(file).replace(/index\.html$/, '') + (anchor ?? ''),
        };
    });
}

/// Rows of tables in which a reader looks for a situation: first cell, second cell, and the heading above.
function situations(page) {
    const found = [];
    let above = page.headings[0]?.anchor,
        rows = false;
    for (const line of page.text.split('\n')) {
        if (/^#+ /.test(line)) above = anchor(line.replace(/^#+ /, ''));
        const cells = line.startsWith('| ') ? line.slice(2).split(' | ') : [];
        if (cells.length === 0) rows = rows && line.startsWith('|-');
        else if (
            /^(your situation|situation|you want|I want|you have|what you see|message or picture|engine|task)$/.test(
                cells[0],
            )
        )
            rows = true;
        else if (rows && !cells[0].startsWith('-'))
            found.push({ title: plain(cells[0]), words: plain(cells[1] ?? '').replace(/ \|$/, ''), above });
    }
    return found;
}
