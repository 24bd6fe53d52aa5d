// SPDX-License-Identifier: MIT
//
// Elements of a page, made by scripts.

/** An element with a class, and text or children. */
export function element<K extends keyof HTMLElementTagNameMap>(
    tag: K,
    name = '',
    ...inside: (string | Node)[]
): HTMLElementTagNameMap[K] {
    const made = document.createElement(tag);
    if (name) made.className = name;
    made.append(...inside);
    return made;
}

/** An integer as readers write it: 4,096. */
export const number = (n: number) => n.toLocaleString('en-US');
