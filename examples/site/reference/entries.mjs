// SPDX-License-Identifier: MIT
//
// Entries of the reference: each public name of a header once, with its overloads, value and snippets.

/// Entries by header, in the headers' order; headers of details alone have none.
/// An entry: {name, place, items, snippets, tier}.
export function entries(headers, items, snippets) {
    const by_place = new Map([...headers.keys()].map(place => [place, []]));
    const public_items = items.filter(
        each =>
            headers.has(each.place) &&
            !each.scope.includes('detail') &&
            !/_snippets$/.test(each.name) &&
            !is_nested(each, items),
    );
    for (const item of public_items.sort((a, b) => a.line - b.line)) {
        const here = by_place.get(item.place);
        const found = here.find(each => each.name === item.name);
        if (found) found.items.push(item);
        else here.push({ name: item.name, place: item.place, items: [item], snippets: [] });
    }
    add_snippets(by_place, public_items, snippets);
    for (const entry of [...by_place.values()].flat()) entry.tier = tier_of(entry);
    return new Map([...by_place].filter(([, here]) => here.length > 0));
}

const is_nested = (item, items) => items.some(each => each.members && `${each.scope}::${each.name}` === item.scope);

/// A number that ends a snippet's name, or stands before "_table", is a template argument of the C++ function.
const family = name => name.replace(/\d+(?=$|_table$)/, '');

function add_snippets(by_place, items, snippets) {
    const texts = items.filter(each => each.scope === 'umbrage::glsl' && each.kind === 'variable');
    for (const snippet of Object.values(snippets)) {
        const declared =
            texts.find(each => each.name === snippet.name) ?? texts.find(each => each.name === family(snippet.name));
        if (!declared) throw new Error(`the reference finds no header with the snippet ${snippet.name}`);
        const here = by_place.get(declared.place);
        const entry =
            here.find(each => each.name === snippet.name) ?? here.find(each => each.name === family(snippet.name));
        entry.snippets.push(snippet.name);
    }
}

/// The tier that a docstring's @exactness begins with.
export const tier_of = entry =>
    entry.items.map(each => /^([ABC])\b/.exec(each.tags.exactness?.[0] ?? '')?.[1]).find(tier => tier) ?? null;
