// SPDX-License-Identifier: MIT
//
// The reference: a page a header, a page a folder, the repository's own pages, and the sources that they link to.
import { escape } from '../context.mjs';
import { page } from '../page.mjs';
import { entry_html, paragraph } from './entry.mjs';
import { folder_page, folders_of, headers_below, way } from './folders.mjs';
import { header_page, link } from './links.mjs';
import { breakable } from './markdown.mjs';
import { model } from './model.mjs';

export async function pages(context) {
    const all = await model(context);
    const have = new Set(all.pages.map(each => each.path));
    const others = folders_of(all.headers).filter(folder => !have.has(folder_page(folder)));
    return [
        ...[...all.headers.values()].map(header => of_header(context, all, header)),
        ...all.pages.filter(each => each.source !== 'MUSEUM.md').map(each => of_markdown(all, each)),  // that one has pictures: ../museum
        ...others.map(folder => of_folder(all, folder)),
        ...[...all.addresses.sources].map(path => of_source(context, path)),
    ];
}

function framed(path, title, description, body) {
    return { path, html: page({ path, title, description: description.slice(0, 200), body }) };
}

/// Addresses as seen from a page: of a name or a header, of a page, of a file of the repository.
const seen_from = (all, path) => ({
    name: word => {
        const header = [...all.headers.keys()].find(place => place === word || place.endsWith(`/${word}`));
        if (word.endsWith('.hpp')) return header ? link(path, header_page(header)) : null;
        const entry = all.places.get(word);
        return entry ? link(path, `${header_page(entry.place)}#${entry.name}`) : null;
    },
    page: address => link(path, address),
    source: file => link(path, all.addresses.of(file)),
});

function of_header(context, all, header) {
    const path = header_page(header.place),
        to = seen_from(all, path),
        here = all.by_place.get(header.place);
    const code = text => `<pre tabindex="0"><code>${context.highlight(text, 'cpp')}</code></pre>`;
    const opening = header.paragraphs.map(part => paragraph(context, part, to.name));
    const names = here.map(({ name }) => `<li><a href="#${name}">${name}</a></li>`).join('');
    const contents = `<nav class="contents" aria-label="Names of this header"><ul>${names}</ul></nav>`;
    const body = `${way(path, header.place)}
<h1>${breakable(header.place.split('/').pop())}</h1>
<div class="prose opening">${opening.join('\n')}</div>
${code(`#include <umbrage/${header.place}>`)}
${here.length > 1 ? contents : ''}
${here.map(each => entry_html(context, each, header, all.texts, all.uses, to)).join('\n')}`;
    return framed(path, header.place, header.paragraphs[0]?.text ?? '', body);
}

/// A page of the repository; that of a folder of headers lists them below.
function of_markdown(all, { path, title, description, body }) {
    const folder = /^reference\/(?:(.*)\/)?index\.html$/.exec(path);
    const prose_html = `<div class="prose">${body}</div>`;
    if (!folder) return framed(path, title, description, prose_html);
    const top = folder[1]
        ? way(path, folder[1])
        : '<p class="way">Reference: the folders below, then <a href="#headers">all headers and names</a></p>';
    return framed(
        path,
        title,
        description,
        top + prose_html + headers_below(all, path, folder[1] ?? '', seen_from(all, path)),
    );
}

function of_folder(all, folder) {
    const path = folder_page(folder),
        below = headers_below(all, path, folder, seen_from(all, path));
    return framed(path, folder, `Headers of ${folder}`, `${way(path, folder)}<h1>${folder}/</h1>${below}`);
}

const languages = { hpp: 'cpp', mjs: 'js' };

function of_source(context, path) {
    const ending = path.split('.').pop();
    const code = context.highlight(context.read(path).trimEnd(), languages[ending] ?? ending);
    const kind = /(LICENSE|\.txt)$/.test(path) ? ' class="wraps"' : ''; // its lines may break anywhere
    return framed(
        `source/${path}.html`,
        path,
        `The file ${path} of umbrage`,
        `<h1 class="file">${breakable(path)}</h1><pre tabindex="0"${kind}><code>${code}</code></pre>`,
    );
}
