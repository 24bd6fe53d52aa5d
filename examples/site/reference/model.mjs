// SPDX-License-Identifier: MIT
//
// Facts that all pages of the reference are made of, read once; the search and the snippets' page use them too.
import { readdirSync } from 'node:fs';
import { join, relative } from 'node:path';
import { pathToFileURL } from 'node:url';

import { start_text } from '../start/text.mjs';
import { documented } from './doxygen.mjs';
import { entries } from './entries.mjs';
import { files_below, read_headers } from './headers.mjs';
import { Addresses, header_page, page_of } from './links.mjs';
import { render } from './markdown.mjs';
import { exhibits, programs } from './uses.mjs';

const languages = { glsl: ['umbrage', 'GLSL'], hlsl: ['hlsl', 'HLSL'], wgsl: ['wgsl', 'WGSL'], msl: ['msl', 'Metal'] };

/// headers, by_place: headers with public names, and their entries. places: the entry that a name leads to.
/// texts: the npm package's snippets by language. pages: Start, then the repository's Markdown. uses: exhibits, programs by name.
export const model = context => (context.model ??= read(context));

async function read(context) {
    const texts = {};
    for (const [id, [file, label]] of Object.entries(languages)) {
        const { snippets } = await import(pathToFileURL(`${context.root}/single_include/${file}.mjs`));
        texts[id] = { label, snippets };
    }
    const all_headers = read_headers(context.root);
    const by_place = entries(all_headers, documented(context), texts.glsl.snippets);
    const headers = new Map([...all_headers].filter(([place]) => by_place.has(place)));
    const all = [...by_place.values()].flat();
    const places = new Map();
    for (const each of [...all].sort((a, b) => weight(b) - weight(a))) places.set(each.name, each);
    const addresses = new Addresses(context.root, headers);
    const entry_of = name => (places.has(name) ? `${header_page(places.get(name).place)}#${name}` : undefined);
    return {
        headers,
        by_place,
        entries: all,
        places,
        texts,
        addresses,
        pages: [
            render(context, { text: start_text(context), file: 'README.md', path: 'start.html' }, addresses, entry_of),
            ...markdown_files(context.root).map(file => {
                const text = context.read(file).replace(/^<!--.*?-->\n/gms, '');
                return { ...render(context, { text, file, path: page_of(file) }, addresses, entry_of), source: file };
            }),
        ],
        uses: {
            exhibits: exhibits(context.read('MUSEUM.md')),
            programs: programs(context.root, new Set(all.flatMap(each => [each.name, ...each.snippets]))),
        },
    };
}

/// The repository's Markdown, in its root and in the folders that it consists of.
const markdown_files = root =>
    [
        ...readdirSync(root).filter(name => name.endsWith('.md')),
        ...['include', 'examples', 'tests', 'single_include'].flatMap(folder =>
            files_below(join(root, folder), '.md').map(file => relative(root, file)),
        ),
    ].sort();

/// Weight of an entry among those of its name: links lead to the lightest, a function of the primitives.
const weight = entry =>
    (entry.items.some(item => item.scope === 'umbrage') ? 0 : 2) +
    (/^(draw|images|shadow|shader)\//.test(entry.place) ? 1 : 0);
