// SPDX-License-Identifier: MIT
//
// Facts of a function: its promise, its needs, its cost, and where it is described.
import type { Snippet } from './compose';

/// Facts that the page holds of a function: names people use, address of its entry, instructions and cycles on RDNA2.
export interface Fact {
    also: string;
    entry: string;
    instructions: number;
    cycles: number;
    nothing: number;
}

/// A promise in words.
export function promise({ exactness, operations, within, as_written }: Snippet): string {
    if (exactness === 'a') return 'The same bits as C++, on every GPU with 32-bit floats, in any order of its sums.';
    const bound =
        within > 0
            ? `within 1/${Math.round(1 / within)} of C++`
            : `within ${operations} × 2⁻²³ × S of the exact result`;
    if (exactness === 'b') return `The same bits as C++ where the order of its sums is kept; elsewhere ${bound}.`;
    return `${bound[0]!.toUpperCase()}${bound.slice(1)}${as_written ? ', in the order that is written' : ''}.`;
}

function element(name: string, text: string, to?: string): HTMLElement {
    const made = document.createElement(name);
    if (to === undefined) made.textContent = text;
    else {
        const link = document.createElement('a');
        link.href = to;
        link.textContent = text;
        made.append(link);
    }
    return made;
}

function tier_badge(tier: string): HTMLElement {
    const made = element('span', `tier ${tier.toUpperCase()}`);
    made.className = `tier ${tier}`;
    return made;
}

/// Fills a list of terms with the facts of a function.
/// @param text_tier   of the whole text, with the maps that were chosen
export function show_facts(
    list: HTMLElement,
    snippet: Snippet,
    text_tier: string,
    fact: Fact | undefined,
    root: string,
): void {
    const rows: Node[] = [];
    const add = (term: string, ...what: (Node | string)[]): void => {
        const description = document.createElement('dd');
        description.append(...what);
        rows.push(element('dt', term), description);
    };
    add('promise', tier_badge(snippet.exactness), ' ', promise(snippet));
    if (text_tier !== snippet.exactness)
        add(
            'this text',
            tier_badge(text_tier),
            ' with the functions and maps that you chose. Its head has the bounds.',
        );
    if (fact?.also) add('also called', fact.also);
    if (snippet.needs.length > 0)
        add('needs', ...snippet.needs.flatMap(need => [element('code', need.name, `?snippet=${need.name}`), ' ']));
    if (fact && fact.instructions > 0)
        add(
            'cost on RDNA2',
            `${fact.instructions} instructions, ${fact.cycles} cycles of throughput: a compiler's estimate ` +
                `(Mesa, without the hardware) of a whole fragment shader, maps clamped. An empty one has ` +
                `${fact.nothing}.`,
        );
    if (snippet.lowest !== '100') add('lowest GLSL', `${snippet.lowest}, 130`);
    if (fact) add('in C++', element('span', 'signature, edge cases, formula', root + fact.entry));
    list.replaceChildren(...rows);
}
