// SPDX-License-Identifier: MIT
//
// Ranks what fits the words of a search.

/// Title, kind, address from the site's root, further words.
export type Item = readonly [title: string, kind: number, address: string, words: string];

const ignored = new Set(
    'a an and are be do does for from how i in is it my of on or the this to was what when where which why with'.split(
        ' ',
    ),
);

/// The words of a text, in lower case: identifiers whole and in their parts.
export function words_of(text: string): string[] {
    const words = text
        .toLowerCase()
        .replace(/['’]/g, '')
        .split(/[^\p{L}\d_.]+/u)
        .flatMap(word => {
            const whole = word.replace(/^\.+|\.+$/g, '');
            return /[_.]/.test(whole) ? [whole, ...whole.split(/[_.]/)] : [whole];
        });
    return words.filter(word => word !== '');
}

/// Words that a reader typed, without those that say nothing where others are left.
export function asked(query: string): string[] {
    const all = query
        .toLowerCase()
        .replace(/['’]/g, '')
        .split(/[^\p{L}\d_.]+/u)
        .map(word => word.replace(/^\.+|\.+$/g, ''))
        .filter(word => word !== '');
    const telling = all.filter(word => !ignored.has(word));
    return telling.length > 0 ? telling : all;
}

/// Fit of one asked word: whole words before beginnings, those before insides; 0 for not at all.
function fit(word: string, words: readonly string[]): number {
    if (words.includes(word)) return 3;
    if (
        words.some(
            each =>
                each.startsWith(word) || (each.length > 3 && word.startsWith(each) && word.length < each.length + 4),
        )
    )
        return 2;
    return word.length > 2 && words.some(each => each.includes(word)) ? 1 : 0;
}

const of_kind = [3, 2, 1.5, 1];

function score([title, kind, , more]: Item, query: string, wanted: readonly string[]): number {
    const names = title.split(', ').map(name => asked(name).join(' ')),
        in_title = words_of(title),
        in_more = words_of(more);
    let sum = 0,
        matched = 0;
    for (const word of wanted) {
        const best = Math.max(fit(word, in_title) * 2, fit(word, in_more));
        sum += best;
        matched += best > 0 ? 1 : 0;
    }
    if (matched === 0) return 0;
    if (names.includes(query)) sum += 20;
    else if (names.some(name => name.startsWith(query))) sum += 6;
    return 100 * (matched / wanted.length) + sum + (of_kind[kind] ?? 0) - in_title.length * 0.05;
}

/// The items that fit best, at most `count`. Those that have all words come before those that have some.
export function find(items: readonly Item[], query: string, count = 12): Item[] {
    const wanted = asked(query),
        whole = wanted.join(' ');
    if (wanted.length === 0) return [];
    const scored = items.map(item => ({ item, score: score(item, whole, wanted) })).filter(each => each.score > 0);
    scored.sort((a, b) => b.score - a.score);
    const all_words = scored.filter(each => each.score > 100);
    return (all_words.length > 0 ? all_words : scored).slice(0, count).map(each => each.item);
}
