// SPDX-License-Identifier: MIT
//
// The search box in every page's header. "/" goes to it, arrows walk through what it found, Enter opens the first.
import { asked, find, type Item } from './find';

const kinds = ['also called', 'shader', 'C++', 'page'];
const languages = ['glsl', 'hlsl', 'wgsl', 'msl'];
const root = document.body.dataset['root'] ?? './';
const form = document.querySelector<HTMLFormElement>('.find')!;
const input = form.querySelector('input')!,
    list = form.querySelector('ul')!,
    status = form.querySelector('output')!;
let index: Promise<Item[]> | undefined;

const load = () =>
    (index ??= fetch(new URL('search.json', import.meta.url)).then(answer => answer.json() as Promise<Item[]>));

/// A language among the words is where the shader text is wanted in, not a word to find.
function split(query: string): { words: string; language: string | undefined } {
    const words = asked(query),
        language = words.map(word => (word === 'metal' ? 'msl' : word)).find(word => languages.includes(word));
    if (!language || words.length < 2) return { words: query, language: undefined };
    return {
        words: words.filter(word => word !== language && !(word === 'metal' && language === 'msl')).join(' '),
        language,
    };
}

async function show(): Promise<void> {
    const query = input.value,
        items = await load();
    if (query !== input.value) return;
    const { words, language } = split(query),
        found = find(items, words);
    list.replaceChildren(
        ...found.map(([title, kind, address, more]) => {
            const link = document.createElement('a');
            link.href = root + address + (language && address.includes('?snippet=') ? `&language=${language}` : '');
            link.append(
                part('b', title),
                part('span', kinds[kind] ?? ''),
                part('small', kind === 0 ? `→ ${more}` : more),
            );
            const row = document.createElement('li');
            row.append(link);
            return row;
        }),
    );
    const none = found.length === 0 && query.trim() !== '';
    status.textContent = none ? 'Nothing has these words.' : found.length > 0 ? `${found.length} found` : '';
    form.classList.toggle('open', found.length > 0 || none);
}

function part(name: string, text: string): HTMLElement {
    const made = document.createElement(name);
    made.textContent = text;
    return made;
}

const close = (): void => form.classList.remove('open');

function walk(event: KeyboardEvent): void {
    const links = [...list.querySelectorAll('a')],
        at = links.indexOf(document.activeElement as HTMLAnchorElement);
    if (event.key === 'Escape') {
        close();
        input.focus();
    } else if (event.key === 'ArrowDown') links[Math.min(at + 1, links.length - 1)]?.focus();
    else if (event.key === 'ArrowUp') (at > 0 ? links[at - 1]! : input).focus();
    else return;
    event.preventDefault();
}

input.addEventListener('focus', () => void load());
input.addEventListener('input', () => void show());
form.addEventListener('keydown', walk);
form.addEventListener('focusout', event => {
    if (!form.contains(event.relatedTarget as Node | null)) close();
});
form.addEventListener('submit', event => {
    event.preventDefault();
    void show().then(() => list.querySelector('a')?.click());
});
document.addEventListener('keydown', event => {
    const typing = event.target instanceof HTMLElement && event.target.closest('input, select, textarea');
    if (event.key !== '/' || typing || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    input.focus();
});
