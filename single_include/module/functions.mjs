// A text of WGSL as its functions, for hosts that take one at a time.
import { must_in } from './check.mjs';
import { as_items, for_each_body } from './compose.mjs';
import { language } from './wgsl/language.mjs';

/** The functions of a text of the items, in order, each with the names of those that it calls: they come before it. */
export function functions(items) {
    const all = [], must = must_in('functions');
    for (const { declared } of as_items(language, items))
        must(!declared, 'items must be snippets, bound or not, as a shadow declares a block and a map beside its functions', declared?.name);
    for_each_body(language, items, body => {
        for (const text of body.match(/^fn [^]*?^}$/gm)) all.push({ name: text.match(/^fn (\w+)/)[1], text });
    });
    const names = new Set(all.map(f => f.name));
    return all.map(({ name, text }) => {
        const words = new Set(text.replace(/\/\/.*/g, '').match(/\w+/g));
        return { name, text, needs: [...words].filter(word => word !== name && names.has(word)) };
    });
}
