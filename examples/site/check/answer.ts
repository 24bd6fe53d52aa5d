// SPDX-License-Identifier: MIT
//
// The answer: what the function is, what is wrong with it, and one input that shows it.
import { element, number } from '../elements';
import { draw_footprint, draw_map, short } from './draw';
import type { Finding, Verdict } from './engine';
import type { Subject } from './guess';
import type { Found } from './run';

const root = document.body.dataset['root'] ?? './';
const addresses = JSON.parse(document.getElementById('addresses')!.textContent ?? '{}') as Record<string, string>;

const link = (to: string, ...inside: (string | Node)[]) => Object.assign(element('a', '', ...inside), { href: to });

/** A function's name, with a link to its entry: "box(2)" and "rg<11>" are those of box and rg. */
function named(name: string): HTMLElement {
    const code = element('code', '', name),
        to = addresses[/^\w*/.exec(name)![0]];
    return to ? link(root + to, code) : code;
}

/** What a slip is, from the page's table of them. */
function why(kind: string): Node[] {
    const row = document.getElementById(`slip-${kind}`);
    return row ? [new Text(' '), ...Array.from(row.lastElementChild!.cloneNode(true).childNodes)] : [];
}

function finding({ kind, says }: Finding): HTMLElement {
    const item = element('li', '', element('b', '', says), '.', ...why(kind));
    item.dataset['kind'] = kind;
    return item;
}

const listed = (title: string, all: readonly Finding[]) =>
    all.length === 0 ? [] : [element('h3', '', title), element('ul', '', ...all.map(finding))];

function headline({ how, function: is, expected, slips, but }: Verdict): HTMLElement {
    const slipped = () => slips.map(each => each.says).join(', ');
    if (how === 'same_bits') return element('h2', 'good', 'The same bits as ', named(is));
    if (how === 'same_but')
        return element('h2', 'good', 'The same as ', named(is), but.length ? ', but for what is listed below' : '');
    if (how === 'unknown') return element('h2', 'amber', 'No function that the page knows fits');
    const other = expected !== '' && expected !== is ? [', not ', named(expected)] : [];
    return element('h2', 'bad', 'This is ', named(is), slips.length ? `, ${slipped()}` : '', ...other);
}

/** How often the two agree. */
function counted({ how, expected, inputs, same_bits, explained, slips }: Verdict): Node[] {
    if (how === 'unknown' || inputs === 0) return [];
    const against = [`${number(same_bits)} of ${number(inputs)} inputs give the bits of `, named(expected)];
    if (how === 'same_bits' || slips.length === 0) return [element('p', '', ...against, '.')];
    const rest = explained === inputs ? 'all inputs' : `${number(explained)} inputs`;
    return [element('p', '', ...against, `. What is listed below explains ${rest}.`)];
}

const components = (values: readonly number[], many: number) => values.slice(0, many).map(short).join(', ');

function example({ first, expected, function: is }: Verdict, subject: Subject): Node[] {
    if (!first) return [];
    const row = (head: string | Node, value: string) =>
        element('tr', '', Object.assign(element('th', '', head), { scope: 'row' }), element('td', '', value));
    const outputs = subject === 'pack' ? 4 : 1;
    const rows =
        subject === 'filter'
            ? [row('receiver, in texels', components(first.input, 2)), row('its depth', short(first.input[2]))]
            : [row(subject === 'pack' ? 'depth' : 'channels', components(first.input, subject === 'pack' ? 1 : 4))];
    rows.push(
        row('your shader', components(first.got, outputs)),
        row(named(expected || is), components(first.expected, outputs)),
    );
    const table = element('table', '', element('tbody', '', ...rows));
    const words =
        'Dark texels are nearer to the light than the receiver, which is the circle. ' +
        'The first row of texels is at the top.';
    return [
        element('h3', '', 'Where they differ'),
        element(
            'div',
            'differ',
            ...(first.map.length ? [element('figure', '', draw_map(first), element('figcaption', '', words))] : []),
            element('div', 'scroll', table),
        ),
    ];
}

function footprint({ seen, how }: Verdict): Node[] {
    const drawn = seen && draw_footprint(seen);
    if (!drawn) return [];
    const figure = element(
        'figure',
        '',
        drawn,
        element(
            'figcaption',
            '',
            'How much a texel in shadow takes from the visibility, by its place from the receiver. ' +
                'A square is a texel, the circle is the receiver. Darker is more.',
        ),
    );
    if (how === 'unknown')
        return [
            element('h3', '', 'What it depends on'),
            element('p', '', 'No name, so here is what the function reads.'),
            figure,
        ];
    return [element('details', '', element('summary', '', 'Texels that it reads, and their weights'), figure)];
}

/** The whole answer. */
export function show_answer({ verdict, device, calls, seconds }: Found, subject: Subject): HTMLElement[] {
    const facts = `${number(calls)} calls in ${seconds.toFixed(1)} s on ${device}.`;
    return [
        headline(verdict),
        ...counted(verdict),
        ...listed('What is wrong', verdict.slips),
        ...listed(verdict.how === 'unknown' ? 'What was seen' : 'Differences that may be meant', verdict.but),
        ...(verdict.outside ? [element('p', '', `Outside of the map: ${verdict.outside}.`)] : []),
        ...example(verdict, subject),
        ...footprint(verdict),
        element('p', 'faint', facts),
    ] as HTMLElement[];
}

/** Why there is none. */
export function show_refusal(message: string, line: string | null, details: string): HTMLElement[] {
    const more =
        details && details.includes('\n')
            ? [element('details', '', element('summary', '', 'All messages'), element('pre', '', details))]
            : [];
    return [
        element('h2', 'bad', 'It does not run'),
        element('p', 'message', message),
        ...(line === null ? [] : [element('pre', '', element('code', '', line))]),
        ...more,
    ];
}
