// SPDX-License-Identifier: MIT
//
// The snippets' page: a list to search, a map's properties, the text. All that is shown is in the URL.
import { copy } from '../clipboard';
import { with_copyright } from '../copyright';
import { find, type Item as Found } from '../search/find';
import { compose, load, reads_map, type Package } from './compose';
import { show_facts, type Fact } from './facts';
import { highlight } from '../highlight';
import { new_item, parse, print, properties, type Language, type Pass, type State } from './state';

const root = document.body.dataset['root'] ?? './';
const by_id = <T extends HTMLElement>(id: string): T => document.getElementById(id) as T;
const facts = JSON.parse(by_id('facts').textContent ?? '{}') as Record<
    string,
    Fact & { summary: string; about: string }
>;
const items: Found[] = Object.entries(facts).map(([name, { summary, also, about }]) => [
    name,
    1,
    '',
    `${summary} ${also} ${about}`,
]);
const endings: Record<Language, string> = { glsl: 'glsl', hlsl: 'hlsl', wgsl: 'wgsl', msl: 'metal' };

const search = by_id<HTMLInputElement>('search'),
    list = by_id('list'),
    tabs = by_id('tabs'),
    notice = by_id('notice');
const map_form = by_id<HTMLFieldSetElement>('map'),
    map_name = by_id<HTMLInputElement>('map_name'),
    code = by_id('code');
let state: State,
    current = 0,
    problems: string[] = [],
    shown = '';

/// Reads the state from the address.
function read_address(): void {
    ({ state, problems } = parse(location.search, name => name in facts));
    current = state.items.length - 1;
}

/// Keeps the state in the address; a reader's choice ends what was wrong in it.
function changed(): void {
    problems = [];
    history.replaceState(null, '', print(state));
    void show();
}

async function show(): Promise<void> {
    const asked = state,
        from = await load(state.language);
    if (asked !== state) return;
    const item = state.items[current]!,
        snippet = from.snippets[item.snippet]!;
    show_controls(from);
    show_tabs();
    const tier = show_text(from);
    by_id('name').textContent = snippet.name;
    by_id('summary').textContent = snippet.summary;
    show_facts(by_id('fact_list'), snippet, tier, facts[item.snippet], root);
    mark_list(item.snippet);
    by_id('detail').classList.remove('loading');
}

/// Marks the function in the list, and scrolls the list alone to it.
function mark_list(name: string): void {
    for (const row of list.querySelectorAll('button')) {
        const here = row.dataset['name'] === name;
        row.setAttribute('aria-pressed', String(here));
        if (
            here &&
            (row.offsetTop < list.scrollTop || row.offsetTop + row.offsetHeight > list.scrollTop + list.clientHeight)
        )
            list.scrollTop = row.offsetTop - list.clientHeight / 3;
    }
}

function show_controls(from: Package): void {
    const item = state.items[current]!;
    for (const radio of document.querySelectorAll<HTMLInputElement>('input[name=language]'))
        radio.checked = radio.value === state.language;
    for (const radio of document.querySelectorAll<HTMLInputElement>('input[name=pass]'))
        radio.checked = radio.value === state.pass;
    by_id<HTMLSelectElement>('version').value = state.version;
    by_id<HTMLSelectElement>('version').disabled = state.language !== 'glsl';
    map_form.disabled = !reads_map(from.snippets[item.snippet]!) && state.pass === 'lookup';
    if (map_name.value !== item.map) map_name.value = item.map;
    for (const key of properties) by_id<HTMLSelectElement>(key).value = item[key];
}

function show_tabs(): void {
    const shown_tabs = state.items.map((item, at) => {
        const tab = document.createElement('span'),
            name = document.createElement('button');
        name.type = 'button';
        name.textContent = item.map ? `${item.snippet} · ${item.map}` : item.snippet;
        name.setAttribute('aria-pressed', String(at === current));
        name.onclick = () => {
            current = at;
            void show();
        };
        tab.append(name);
        if (state.items.length > 1) {
            const away = document.createElement('button');
            away.type = 'button';
            away.textContent = '×';
            away.setAttribute('aria-label', `Remove ${name.textContent}`);
            away.onclick = () => {
                state.items.splice(at, 1);
                current = 0;
                changed();
            };
            tab.append(away);
        }
        return tab;
    });
    tabs.replaceChildren(...shown_tabs);
}

/// The text, or for maps that cannot be, why not, beside the text of plain ones. Returns the text's tier.
function show_text(from: Package): string {
    const told = [...problems];
    let tier: string;
    try {
        ({ text: shown, tier } = compose(from, state));
    } catch (error) {
        told.push(`${(error as Error).message.replace(/^umbrage: \w+: /, '')}. The text is that of plain 2D maps.`);
        const plain = state.items.map(({ snippet }, at) => new_item(snippet, at > 0 ? `map_${at + 1}` : ''));
        ({ text: shown, tier } = compose(from, { ...state, version: 'any', items: plain }));
    }
    shown = with_copyright(shown);
    code.innerHTML = highlight(shown, state.language);
    by_id('size').textContent =
        `${shown.split('\n').length - 1} lines, ${(new TextEncoder().encode(shown).length / 1024).toFixed(1)} KiB`;
    notice.textContent = told.join(' ');
    notice.hidden = told.length === 0;
    return tier;
}

function show_list(): void {
    const names = search.value.trim() === '' ? Object.keys(facts) : find(items, search.value, 60).map(([name]) => name);
    list.replaceChildren(
        ...names.map(name => {
            const row = document.createElement('li'),
                button = document.createElement('button'),
                words = document.createElement('small');
            button.type = 'button';
            button.dataset['name'] = name;
            button.append(name, words);
            words.textContent = facts[name]!.summary;
            row.append(button);
            return row;
        }),
    );
    mark_list(state.items[current]!.snippet);
    by_id('count').textContent = names.length === 0 ? 'No function has these words.' : `${names.length} functions`;
}

/// Says on a button that it has done its work.
function done(button: HTMLButtonElement, words: string): void {
    const before = (button.dataset['words'] ??= button.textContent ?? '');
    button.textContent = words;
    setTimeout(() => {
        button.textContent = before;
    }, 1500);
}

function download(): void {
    const link = document.createElement('a');
    link.href = URL.createObjectURL(new Blob([shown], { type: 'text/plain' }));
    link.download = `${state.items.map(item => item.snippet).join('_')}.${endings[state.language]}`;
    link.click();
    URL.revokeObjectURL(link.href);
}

function listen(): void {
    search.addEventListener('input', show_list);
    search.addEventListener('keydown', event => {
        if (event.key === 'Enter') list.querySelector('button')?.click();
        else if (event.key === 'ArrowDown') list.querySelector('button')?.focus();
        else return;
        event.preventDefault();
    });
    list.addEventListener('keydown', event => {
        const rows = [...list.querySelectorAll('button')],
            at = rows.indexOf(document.activeElement as HTMLButtonElement);
        if (event.key === 'ArrowDown') rows[at + 1]?.focus();
        else if (event.key === 'ArrowUp') (rows[at - 1] ?? search).focus();
        else return;
        event.preventDefault();
    });
    list.addEventListener('click', event => {
        const name = (event.target as Element).closest('button')?.dataset['name'];
        if (!name) return;
        state.items[current]!.snippet = name;
        changed();
    });
    by_id('controls').addEventListener('change', event => {
        const control = event.target as HTMLInputElement | HTMLSelectElement;
        if (control.name === 'language') state = { ...state, language: control.value as Language };
        else if (control.name === 'pass') state.pass = control.value as Pass;
        else if (control.id === 'version') state.version = control.value;
        changed();
    });
    map_form.addEventListener('input', event => {
        const control = event.target as HTMLInputElement | HTMLSelectElement,
            item = state.items[current]!;
        if (control === map_name) item.map = map_name.value;
        else item[control.id as (typeof properties)[number]] = control.value;
        changed();
    });
    by_id('add').onclick = () => {
        const last = state.items[current]!;
        state.items.push({ ...last, map: `map_${state.items.length + 1}` });
        current = state.items.length - 1;
        changed();
    };
    const copies = (name: string, text: () => string, words: string) => {
        const button = by_id<HTMLButtonElement>(name);
        button.onclick = async () => done(button, (await copy(text())) ? words : 'Not allowed');
    };
    copies('copy', () => shown, 'Copied');
    copies('link', () => new URL(print(state), location.href).href, 'Link copied');
    by_id('download').onclick = download;
    window.addEventListener('popstate', () => {
        read_address();
        void show();
    });
}

read_address();
listen();
show_list();
void show();
