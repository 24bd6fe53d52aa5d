// Snippets as one text: each once, after what it needs.
//
// The composer exists twice: here, and in C++ as include/umbrage/shader/compose.hpp. A page that composes its shaders would
// otherwise load the C++ one as WebAssembly, some 200 kB, and wait for it. This one needs no runtime, and a page with one
// function is a bundle of 10 kB. tests/package/texts_test.mjs holds the two together, character for character.
//
// A snippet is data of one language. bind() makes items of a snippet and a map; a snippet alone reads a 2D texture of
// depths, as its text stands. Nothing here knows how a map fills texts in, so that programs without bind() do without.

import { version as of_package } from '../../module/languages.mjs';
import { must_in } from './check.mjs';

const must = /*#__PURE__*/ must_in('text');

export const is_of_map = s => s.role !== 'none' || s.needs.some(is_of_map);

const alone = what => ({ what, suffix: '', map_key: '', parts: [what], chosen: s => s, fill: s => s.text });

/** Whether it is a snippet of the language; lights of a shadow have its name, too. */
export const is_snippet = (language, what) => what?.language === language && Array.isArray(what.needs);

/** An item as it is composed; refuses what is no item of the language. */
export function as_item(language, item) {
    const what = item?.what ?? item;
    must(is_snippet(language, what), `items must be snippets of ${language.name}, bound or not`,
        what?.language ? `${what.name} of ${what.language.name}` : what);
    return item === what ? alone(what) : item;
}

/** A list of items, as they are composed. */
export function as_items(language, items) {
    must(Array.isArray(items), 'items must be an array of snippets', items);
    return items.map(item => as_item(language, item));
}

/** The items, no two of which share a name and differ in their maps. */
function checked(language, given) {
    const items = as_items(language, given);
    const of_map = items.filter(item => item.parts.some(is_of_map));
    for (const item of of_map)
        must(of_map.every(other => other.suffix !== item.suffix || other.map_key === item.map_key), 'name must be another for each map',
            `"${item.suffix.slice(1)}" for two`);
    return items;
}

/** Calls use(snippet, item, guard) for each part of a text, in order. What belongs to no map comes first. */
function for_each_part(items, use) {
    const done = new Map();
    const add = (asked, item, of_map) => {
        const s = item.chosen(asked);
        for (const need of s.needs) add(need, item, of_map);
        if (is_of_map(s) !== of_map) return;
        const suffix = of_map ? item.suffix : '', guard = `UMBRAGE_HAS_${s.name}${suffix}`.toUpperCase(), before = done.get(guard);
        if (before?.s === s && before.suffix === suffix) return;
        must(!before, 'names must keep functions apart, in capitals too',
            `umbrage_${before?.s.name}${before?.suffix} and umbrage_${s.name}${suffix}`);
        use(s, item, guard);
        done.set(guard, { s, suffix });
    };
    for (const of_map of [false, true])
        for (const item of items)
            for (const part of item.parts) add(part, item, of_map);
}

/** The worst promise of what a text of the items holds. */
function worst_promise(items) {
    const all = { exactness: 'a', operations: 0, within: 0, as_written: false };
    for_each_part(items, s => {
        for (const key in all) if (s[key] > all[key]) all[key] = s[key];
    });
    return all;
}

/** The worst tier of a text: of the snippets, of all they need, and of the hooks of the maps they are bound to. */
export const exactness_in = (language, items) => worst_promise(checked(language, items)).exactness;

function bound_in_words(s) {
    if (s.within === 0) return `within ${s.operations} x 2^-23 x S of the exact result.`;
    return `within 1/${1 / s.within} of C++`
        + (s.as_written ? ' as written. Reordered: no bound, but a visibility is in [0, 1].' : '.');
}

/** Lines of comment that bound what each function returns; none for a text of tier A. */
function bounds_note(items, may_reorder) {
    const lines = new Set();
    const add = (name, s) => {
        if ((s.exactness ?? 'a') !== 'a') lines.add(`// ${name}, tier ${s.exactness.toUpperCase()}: ${bound_in_words(s)}\n`);
    };
    for (const item of items)
        if (item.declared) for_each_part([item], s => add(s.name, s));  // a chain, of which each part keeps its own bound
        else add(item.what.name + item.suffix, worst_promise([item]));
    const note = [...lines].join('');
    if (note === '') return '';
    return (may_reorder && `// ${may_reorder} lets compilers fuse or reorder sums.\n`) + note
        + (note.includes(' x S ') ? '// S is the formula with the magnitude of every value and a plus for every minus.\n'
            + '// Inside the bound, a comparison or floor may fall on either side.\n' : '');
}

/** The parts of a text in order, as use(body, guard, name). */
export function for_each_body(language, items, use) {
    for_each_part(checked(language, items), (s, item, guard) => {
        const of_map = is_of_map(s);
        use(of_map ? item.fill(s) : s.text, guard, s.name + (of_map ? item.suffix : ''));
    });
}

/** The items and all they need, each once. What is known of a dialect stands in place of the language's own. */
export function compose(language, items, { prelude, may_reorder, version } = language) {
    const all = checked(language, items), made = new Set();
    const names = [...new Set(all.map(item => item.declared?.name ?? item.what.name + item.suffix))];
    let text = `// umbrage ${of_package}, MIT License${names.length ? ': ' : ''}${names.join(', ')}\n`
        + bounds_note(all, may_reorder) + prelude;
    for_each_body(language, items, (body, guard, name) => {
        text += language.preprocessor ? `\n#ifndef ${guard}\n#define ${guard}${body}#endif\n` : body;
        made.add(name);
    });
    const taken = {};  // slots, by the shadows that have them
    for (const { declared } of all.filter(item => item.declared)) {
        const { names, slots, text: declaration } = declared.text(version);
        for (const name of names.filter(Boolean).map(name => name.slice(8))) {  // without umbrage_
            must(!made.has(name), "name must be another than a snippet's or shadow's of the text", name);
            made.add(name);
        }
        for (const slot of slots) {
            must(!taken[slot], 'slots must be others for each block, texture and sampler of a text', `${slot} for ${taken[slot]} and ${declared.name}`);
            taken[slot] = declared.name;
        }
        text += declaration;
    }
    return text;
}

/** The functions of a text of the items, in order, each with the names of those that it calls: they come before it. */
export function functions_in(language, items) {
    const all = [], must_be = must_in('functions');
    for (const { declared } of as_items(language, items))
        must_be(!declared, 'items must be snippets, bound or not, as a shadow declares a block and a map beside its functions', declared?.name);
    for_each_body(language, items, body => {
        for (const text of body.match(/^fn [^]*?^}$/gm)) all.push({ name: text.match(/^fn (\w+)/)[1], text });
    });
    const names = new Set(all.map(f => f.name));
    return all.map(({ name, text }) => {
        const words = new Set(text.replace(/\/\/.*/g, '').match(/\w+/g));
        return { name, text, needs: [...words].filter(word => word !== name && names.has(word)) };
    });
}
