// SPDX-License-Identifier: MIT
//
// The text of a state, by the npm package in the language that was chosen.
import type { Item, Language, State } from './state';

/// A function of the package, in any language.
export interface Snippet {
    readonly name: string;
    readonly summary: string;
    readonly exactness: 'a' | 'b' | 'c';
    readonly operations: number;
    readonly within: number;
    readonly as_written: boolean;
    readonly lowest: string;
    readonly role: string;
    readonly needs: readonly Snippet[];
}
interface Encoding {
    readonly reversed: Encoding;
    readonly write: Snippet;
}

/// Exports of the package's module of a language.
export interface Package {
    readonly snippets: Readonly<Record<string, Snippet>>;
    readonly encodings: Readonly<Record<string, Encoding>>;
    bind(what: Snippet, name: string, map?: object): object;
    text(items: readonly object[], version?: string): string;
    source?(version: string, items: readonly object[]): string;
    exactness(items: readonly object[]): 'a' | 'b' | 'c';
}

const loaded = new Map<Language, Promise<Package>>();

export function load(language: Language): Promise<Package> {
    let found = loaded.get(language);
    if (!found)
        loaded.set(language, (found = import(new URL(`./${language}.js`, import.meta.url).href) as Promise<Package>));
    return found;
}

export const reads_map = (s: Snippet): boolean => s.role !== 'none' || s.needs.some(reads_map);

const encoding_of = (from: Package, { stored, direction }: Item): Encoding =>
    direction === 'reversed' ? from.encodings[stored]!.reversed : from.encodings[stored]!;

/// The function bound to its map.
function lookup(from: Package, item: Item): object {
    const snippet = from.snippets[item.snippet];
    if (!snippet) throw new Error(`umbrage: no function of this language is called ${item.snippet}`);
    if (!reads_map(snippet)) return snippet;
    const map: Record<string, unknown> = { ...encoding_of(from, item), texture: item.texture };
    if (item.outside !== 'default') map['outside'] = item.outside;
    if (item.gather === 'yes') map['gather'] = true;
    return from.bind(snippet, item.map, map);
}

/// Function by which the depth pass writes the item's map.
const writer = (from: Package, item: Item): object =>
    from.bind(encoding_of(from, item).write, item.map, { direction: item.direction });

/// @throws Error   in the package's words, where a map cannot be
export function compose(
    from: Package,
    { version, language, pass, items }: State,
): { text: string; tier: 'a' | 'b' | 'c' } {
    const all = items.map(item => (pass === 'lookup' ? lookup(from, item) : writer(from, item)));
    const text = language === 'glsl' && version !== 'any' ? from.source!(version, all) : from.text(all);
    return { text, tier: from.exactness(all) };
}
