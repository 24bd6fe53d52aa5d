// SPDX-License-Identifier: MIT
//
// Parts that an entry of the reference must have.

/// A sentence for each part that an entry's docstrings lack.
/// @param entry      from entries.mjs
/// @param snippets   of the npm package, by name
export function missing_parts(entry, snippets) {
    const wrong = [],
        where = `${entry.place}: ${entry.name}`;
    const { items } = entry,
        shader = snippets[entry.snippets[0]];
    if (!items.some(item => item.brief)) wrong.push(`${where} has no docstring`);
    for (const item of items.filter(each => each.kind === 'function')) {
        const described = item.param.flatMap(each => each.name.split(', ')),
            refers = refers_to_another(item);
        for (const name of described.filter(each => !item.arguments.includes(each)))
            wrong.push(`${where} describes ${name}, which is none of its parameters`);
        for (const name of item.arguments)
            if (described.length > 0 && !described.includes(name) && !refers)
                wrong.push(`${where} describes some parameters, not ${name}`);
    }
    const twin = items.some(item => item.kind === 'function' && item.scope === 'umbrage' && item.brief);
    if (shader && twin && !entry.tier && !items.some(item => refers_to_another(item)))
        wrong.push(`${where} has no @exactness that begins with a tier`);
    return wrong;
}

/// True for docstrings that say that the rest is as another function has it.
function refers_to_another(item) {
    const texts = [
        item.brief,
        ...item.paragraphs.map(part => part.text ?? ''),
        ...Object.values(item.tags).flat(),
        ...item.param.map(each => each.text),
    ];
    return /\b(parameters|arguments|and so are)\b/i.test(texts.join(' '));
}
