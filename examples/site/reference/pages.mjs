// SPDX-License-Identifier: MIT
//
// The reference: a page a header, a page a folder, the repository's own pages, and the sources that they link to.
import { readdirSync } from 'node:fs';
import { dirname, join, relative } from 'node:path';
import { pathToFileURL } from 'node:url';

import { escape } from '../context.mjs';
import { page } from '../page.mjs';
import { documented } from './doxygen.mjs';
import { entries } from './entries.mjs';
import { entry_html } from './entry.mjs';
import { files_below, read_headers } from './headers.mjs';
import { Addresses, header_page, link } from './links.mjs';
import { render } from './markdown.mjs';
import { prose } from './prose.mjs';
import { exhibits, programs } from './uses.mjs';

const languages = { glsl: ['umbrage', 'GLSL'], hlsl: ['hlsl', 'HLSL'], wgsl: ['wgsl', 'WGSL'], msl: ['msl', 'Metal'] };

/// What all pages of the reference are made of, read once; the search and the snippets' page use it too.
export async function model(context) {
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
    const markdown = markdown_files(context.root);
    const addresses = new Addresses(context.root, headers);
    const entry_of = name => places.has(name) ? `${header_page(places.get(name).place)}#${name}` : undefined;
    return { headers, by_place, entries: all, places, texts, addresses,
        pages: markdown.map(path => ({ ...render(context, path, addresses, entry_of), source: path })),
        uses: { exhibits: exhibits(context.read('MUSEUM.md')), programs: programs(context.root, new Set(all.flatMap(each => [each.name, ...each.snippets]))) } };
}

/// The repository's Markdown, in its root and in the folders that it consists of.
const markdown_files = root => [...readdirSync(root).filter(name => name.endsWith('.md')),
    ...['include', 'examples', 'tests', 'single_include'].flatMap(folder =>
        files_below(join(root, folder), '.md').map(file => relative(root, file)))].sort();

/// Of two entries of one name, links lead to the function of the primitives.
const weight = entry => (entry.items.some(item => item.scope === 'umbrage') ? 0 : 2) + (/^(images|shadow|shader)\//.test(entry.place) ? 1 : 0);

export async function pages(context) {
    const all = context.model ??= await model(context);
    const made = [...all.headers.values()].map(header => header_html(context, all, header));
    for (const each of all.pages) made.push(markdown_html(all, each));
    for (const folder of folders_without_page(all)) made.push(folder_html(all, folder));
    for (const path of all.addresses.sources) made.push(source_html(context, path));
    return made;
}

/// Addresses as seen from a page.
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

function header_html(context, all, header) {
    const path = header_page(header.place), to = seen_from(all, path), here = all.by_place.get(header.place);
    const opening = header.paragraphs.map(part => part.kind === 'code' ? `<pre tabindex="0"><code>${context.highlight(part.text, 'cpp')}</code></pre>`
        : `<p>${prose(part.text, to.name)}</p>`).join('\n');
    const contents = here.length < 2 ? '' : `<nav class="contents" aria-label="Names of this header"><ul>${
        here.map(each => `<li><a href="#${each.name}">${each.name}</a></li>`).join('')}</ul></nav>`;
    const body = `${way(all, path, header.place)}
<h1>${escape(header.place.split('/').pop())}</h1>
<div class="prose opening">${opening}</div>
<pre tabindex="0"><code>${context.highlight(`#include <umbrage/${header.place}>`, 'cpp')}</code></pre>
${contents}
${here.map(each => entry_html(context, each, header, all.texts, all.uses, to)).join('\n')}`;
    return framed(path, header.place, header.paragraphs[0]?.text ?? '', body);
}

/// The way from the reference down to a page.
function way(all, path, place) {
    const parts = place.split('/').slice(0, -1);
    const links = parts.map((part, at) => `<a href="${link(path, `reference/${parts.slice(0, at + 1).join('/')}/index.html`)}">${part}</a>`);
    return `<nav class="way" aria-label="Way to this page">${[`<a href="${link(path, 'reference/index.html')}">Reference</a>`, ...links].join(' / ')}</nav>`;
}

const framed = (path, title, description, body) => ({ path, html: page({ path, title, description: description.slice(0, 200), body }) });

const folder_of = path => /^reference\/(?:(.*)\/)?index\.html$/.exec(path);

function markdown_html(all, each) {
    const folder = folder_of(each.path);
    const more = folder ? headers_of(all, each.path, folder[1] ?? '') : '';
    const top = folder?.[1] === undefined && folder ? '<p class="way">Reference: the rooms below, then <a href="#headers">all headers and names</a></p>' : '';
    return framed(each.path, each.title, each.description,
        `${top}${folder?.[1] ? way(all, each.path, `${folder[1]}/`.replace(/[^/]*\/$/, '')) : ''}<div class="prose">${each.body}</div>${more}`);
}

const folders_of = all => new Set([...all.headers.keys()].flatMap(place => {
    const parts = place.split('/').slice(0, -1);
    return parts.map((_, at) => parts.slice(0, at + 1).join('/'));
}));

function folders_without_page(all) {
    const have = new Set(all.pages.map(each => folder_of(each.path)?.[1]));
    return [...folders_of(all)].filter(folder => !have.has(folder));
}

const folder_html = (all, folder) => framed(`reference/${folder}/index.html`, folder, `Headers of ${folder}`,
    `${way(all, `reference/${folder}/index.html`, folder)}<h1>${folder}/</h1>${headers_of(all, `reference/${folder}/index.html`, folder)}`);

/// The folders and headers below a folder, each header with its first sentence and its names. The root lists all of them.
function headers_of(all, path, folder) {
    const to = seen_from(all, path);
    const below = [...all.headers.keys()].filter(place => folder === '' || place.startsWith(`${folder}/`));
    const groups = new Map();
    for (const place of below) groups.set(dirname(place), [...groups.get(dirname(place)) ?? [], place]);
    const lists = [...groups].map(([name, places]) => `<h3><a href="${link(path, `reference/${name}/index.html`)}">${name === '.' ? 'umbrage' : name}/</a></h3>
<dl class="headers">${places.map(place => `<dt><a href="${link(path, header_page(place))}"><code>${place.split('/').pop()}</code></a></dt>
<dd>${first_sentence(all.headers.get(place), to)}<br>${all.by_place.get(place).map(each =>
        `<a href="${link(path, header_page(place))}#${each.name}"><code>${each.name}</code></a>`).join(' ')}</dd>`).join('\n')}</dl>`);
    return `<section class="below"><h2 id="headers">${folder === '' ? 'All headers and names' : 'Headers'}</h2>${lists.join('\n').replace('/index.html"><code>.', '')}</section>`;
}

const first_sentence = (header, to) => prose(/^.*?[\w)\]]\.(?=\s|$)/.exec(header.paragraphs[0]?.text ?? '')?.[0] ?? '', to.name);

function source_html(context, path) {
    const address = `source/${path}.html`, language = { hpp: 'cpp', cpp: 'cpp', mjs: 'js', cmake: 'cmake' }[path.split('.').pop()] ?? path.split('.').pop();
    return framed(address, path, `The file ${path} of umbrage`,
        `<h1 class="file">${escape(path)}</h1><pre tabindex="0"><code>${context.highlight(context.read(path).trimEnd(), language)}</code></pre>`);
}
