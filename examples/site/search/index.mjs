// SPDX-License-Identifier: MIT
//
// What the search box finds: names people use, shader functions, public names, headings of pages. One JSON file.
import { header_page } from '../reference/links.mjs';
import { plain } from '../reference/markdown.mjs';

/// Kinds of what is found, as box.ts shows them. An item is [title, kind, address, words].
const kinds = { known: 0, shader: 1, name: 2, heading: 3 };

export function search_index(context) {
    const { entries, pages, places, texts } = context.model;
    const entry_address = name => `${header_page(places.get(name).place)}#${name}`;
    const known = context.known = known_names(context.read('INDEX.md'), name => places.has(name));
    return [
        ...known.map(({ names, here, address }) => [names.join(', '), kinds.known, address ?? entry_address(here[0]), here.join(', ')]),
        ...Object.values(texts.glsl.snippets).map(({ name, summary }) => [name, kinds.shader, `snippets/?snippet=${name}`, summary]),
        ...entries.filter(each => places.get(each.name) === each).map(each =>
            [each.name, kinds.name, entry_address(each.name), each.items.find(item => item.brief)?.brief ?? '']),
        ...pages.flatMap(page => page.headings.filter(each => each.depth < 4).map(each =>
            [each.text, kinds.heading, `${page.path.replace(/index\.html$/, '')}${each.depth > 1 ? `#${each.anchor}` : ''}`,
                each.depth > 1 ? page.title : page.description])),
    ];
}

/// The rows of INDEX.md: names people use, and the names here that they stand for, or the page's address.
export function known_names(text, is_name) {
    return Array.from(text.matchAll(/^\| (.+?) \| (.*)\[(.+?)\]\((.+?)\).*\|$/gm), ([, names, before, words, target]) => {
        const here = Array.from(`${before}${words}`.matchAll(/`(\w+)/g), match => match[1]);
        const found = here.filter(is_name);
        return { names: plain(names).split(', '), here: here.length ? here : [plain(words)],
            address: found.length ? undefined : target.replace(/^TROUBLESHOOTING\.md/, 'troubleshooting.html') };
    });
}
