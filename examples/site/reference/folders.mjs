// SPDX-License-Identifier: MIT
//
// The folders of headers: the way to a page, and what lies below.
import { dirname } from 'node:path';

import { header_page, link } from './links.mjs';
import { prose } from './prose.mjs';

export const folder_page = folder => `reference/${folder}/index.html`;

/// The folders on the way to a header, from the first: "filter", "filter/pcf".
const folders_to = place => {
    const parts = place.split('/').slice(0, -1);
    return parts.map((_, at) => parts.slice(0, at + 1).join('/'));
};

export const folders_of = headers => [...new Set([...headers.keys()].flatMap(folders_to))];

/// Links from the reference down to a page.
export function way(path, place) {
    const links = folders_to(place).map(
        folder => `<a href="${link(path, folder_page(folder))}">${folder.split('/').pop()}</a>`,
    );
    const all = [`<a href="${link(path, 'reference/index.html')}">Reference</a>`, ...links].join(' / ');
    return `<nav class="way" aria-label="Way to this page">${all}</nav>`;
}

/// The headers below a folder, each with its first sentence and its names. The root, '', lists all of them.
export function headers_below(all, path, folder, to) {
    const groups = new Map();
    for (const place of all.headers.keys())
        if (folder === '' || place.startsWith(`${folder}/`))
            groups.set(dirname(place), [...(groups.get(dirname(place)) ?? []), place]);
    const lists = [...groups].map(([name, places]) => {
        const title = name === '.' ? 'umbrage/' : `<a href="${link(path, folder_page(name))}">${name}/</a>`;
        const rows = places.map(place => row(all, path, place, to));
        return `<h3>${title}</h3>\n<dl class="headers">${rows.join('\n')}</dl>`;
    });
    const heading = folder === '' ? 'All headers and names' : 'Headers';
    return `<section class="below"><h2 id="headers">${heading}</h2>${lists.join('\n')}</section>`;
}

function row(all, path, place, to) {
    const address = link(path, header_page(place));
    const names = all.by_place.get(place).map(({ name }) => `<a href="${address}#${name}"><code>${name}</code></a>`);
    const sentence = /^.*?[\w)\]]\.(?=\s|$)/.exec(all.headers.get(place).paragraphs[0]?.text ?? '')?.[0] ?? '';
    return `<dt><a href="${address}"><code>${place.split('/').pop()}</code></a></dt>
<dd>${prose(sentence, to.name)}<br>${names.join(' ')}</dd>`;
}
