// SPDX-License-Identifier: MIT
//
// Markdown of the repository as pages: anchors as GitHub's, links to where the site has a file, pictures with sizes.
import { readFileSync } from 'node:fs';
import { posix } from 'node:path';

import { escape } from '../context.mjs';
import { link } from './links.mjs';

/// A heading as the anchor that links lead to.
export const anchor = heading =>
    heading
        .toLowerCase()
        .replace(/[`*]/g, '')
        .replace(/[^\w\- ]/g, '')
        .replace(/ /g, '-');

/// A page of Markdown as {path, title, description, body, headings, text}; copies the pictures that it shows.
/// @param page      {text, file, path}: the text, the file in the repository that its links start from, and its address
/// @param addresses of the repository's files
/// @param entry     a public name to the address of its entry, or undefined
export function render(context, { text, file: source, path: from }, addresses, entry) {
    const { Marked } = context.load('marked');
    const headings = [],
        mentioned = new Set();
    let inside_link = false;
    const target = to => {
        if (/^\w+:/.test(to)) return to;
        const [file, hash = ''] = to.split('#');
        if (file === '') return to;
        const address = addresses.of(posix.normalize(posix.join(posix.dirname(source), file)));
        return address && link(from, address) + (hash && `#${hash}`);
    };
    const renderer = {
        heading({ tokens, depth, text }) {
            headings.push({ depth, text: plain(text), anchor: anchor(text) });
            return `<h${depth} id="${anchor(text)}">${this.parser.parseInline(tokens)}</h${depth}>\n`;
        },
        link({ href, tokens }) {
            const to = target(href);
            inside_link = to !== null;
            const inner = this.parser.parseInline(tokens);
            inside_link = false;
            return to ? `<a href="${escape(to)}">${inner}</a>` : inner;
        },
        codespan({ text }) {
            // the first mention of each name leads to its entry
            const name = /^(?:(?:umbrage|glsl|filters|prefilters)::)*([a-z]\w*)(?:<\w+>)?(?:\(\))?$/.exec(text)?.[1];
            const to = name && !inside_link && !mentioned.has(name) && entry(name);
            if (!to) return `<code>${breakable(text)}</code>`;
            mentioned.add(name);
            return `<a href="${link(from, to)}"><code>${breakable(text)}</code></a>`;
        },
        image({ href, text }) {
            const file = posix.normalize(posix.join(posix.dirname(source), href)),
                to = addresses.of(file);
            if (!context.written.includes(to)) context.copy(file, to);
            const { width, height } = size_of_png(posix.join(context.root, file));
            const sizes = `width="${width}" height="${height}"`;
            return `<img src="${link(from, to)}" alt="${escape(text)}" ${sizes} loading="lazy">`;
        },
        code({ text, lang }) {
            const language = (lang ?? '').split(' ')[0];
            return `<pre tabindex="0"><code>${context.highlight(text, language)}</code></pre>\n`;
        },
        table(token) {
            const html = this.constructor.prototype.table.call(this, token);
            const named = html.replace(/<th[^>]*><\/th>/g, '<td></td>'); // a header cell has words
            return `<div class="scroll" tabindex="0" role="group" aria-label="Table">${named}</div>\n`;
        },
    };
    const body = new Marked({ renderer }).parse(text);
    const first = text.split('\n\n').find(block => /^[A-Z*]/.test(block)) ?? '';
    const title = headings[0]?.text ?? source;
    return { path: from, title, description: plain(first).slice(0, 200), body, headings, text };
}

/// Code that may go on in another line behind an underscore, a slash, a point or a bracket.
/// On narrow screens also before a capital of a long name, and behind a hyphen. On wide ones `--after` stays whole.
export const breakable = code => escape(code).replace(/(?:[_/(]|(?<=[a-z)])\.|::)(?=\w)/g, '$&<wbr>')
    .replace(/[A-Za-z]{12,}/g, name => name.replace(/(?<=[a-z])(?=[A-Z])/g, '<wbr class="narrow">'))
    .replace(/(?<![\w-])(?:--?|[A-Za-z0-9]+-)[\w-]*\w/g, '<span class="whole">$&</span>');

export const plain = text =>
    text
        .replace(/\[([^\]]*)\]\([^)]*\)/g, '$1')
        .replace(/[`*]/g, '')
        .replace(/\s+/g, ' ')
        .trim();

function size_of_png(file) {
    const bytes = readFileSync(file);
    return { width: bytes.readUInt32BE(16), height: bytes.readUInt32BE(20) };
}
