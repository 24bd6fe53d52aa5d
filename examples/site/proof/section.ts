// SPDX-License-Identifier: MIT
//
// The results of one API: the probe's line, the headline, and a table for each verdict.
import { element, number } from '../elements';
import { api_names } from './gpu';
import type { Row } from './run';
import type { Api } from './state';
import type { Sum, Verdict } from './suite';

/** Lines of the probe that decide which results can differ. */
const first_lines = ['a * b + c', '(a + b) - a', 'denormals', 'NaN seen by', 'infinity', '-0'];

const columns = ['function', 'tier', 'inputs', 'identical', 'as promised', 'different', 'worst distance'];
const headings: Record<Verdict, string> = {
    different: 'Different', 'not run': 'Not run', 'as promised': 'As promised', identical: 'Identical',
};

function worst(row: Row): string {
    if (row.tier !== 'C' || !row.inputs) return '';
    return row.worst_distance ? row.worst_distance.toPrecision(2) : `${number(row.worst_ulp)} ulp`;
}

class Group {
    private readonly body = element('tbody');
    private readonly count = element('span', 'faint');
    readonly element = element('details', 'group');

    constructor(readonly verdict: Verdict, explanation: string) {
        const head = element('tr', '', ...columns.map(name => Object.assign(element('th', '', name), { scope: 'col' })));
        const table = element('table', '', element('thead', '', head), this.body);
        const scroll = element('div', 'scroll', table);
        scroll.tabIndex = 0;
        scroll.setAttribute('role', 'region');
        scroll.setAttribute('aria-label', headings[verdict]);
        this.element.append(element('summary', '', `${headings[verdict]} `, this.count), element('p', 'faint', explanation), scroll);
        this.element.open = verdict === 'different';
        this.element.hidden = true;
    }
    add(row: Row): void {
        const cells = row.inputs ? [row.inputs, row.identical, row.inputs - row.identical - row.different, row.different].map(number)
            : ['', '', '', ''];
        const name = Object.assign(element('th', 'name', row.name), { scope: 'row' });
        const tier = element('td', '', element('span', `tier ${row.tier.toLowerCase()}`, row.tier), row.promise.slice(1));
        this.body.append(element('tr', '', name, tier, ...cells.map(text => element('td', 'count', text)), element('td', 'count', worst(row))));
        if (row.example) this.body.append(this.example_of(row.example.trimEnd()));
        this.count.textContent = number(this.body.querySelectorAll('th.name').length);
        this.element.hidden = false;
    }
    /** The first one is open. */
    private example_of(text: string): HTMLElement {
        const words = this.verdict === 'different' ? 'An input' : 'The browser\'s words';
        const inside = element('details', '', element('summary', '', words), element('pre', '', text));
        inside.open = !this.body.querySelector('.example');
        const cell = element('td', '', inside);
        cell.colSpan = columns.length;
        return element('tr', 'example', cell);
    }
}

export class Section {
    readonly element: HTMLElement;
    private readonly said = element('p', 'faint');
    private readonly probe = element('div', 'probe');
    private readonly tiles = element('div', 'tiles');
    private readonly groups = [
        new Group('different', 'Results that the tier does not allow, with the first input of each function.'),
        new Group('not run', 'Functions whose shader this browser refused, with its words.'),
        new Group('as promised', 'Within the bound of tiers B and C. A denormal may be zero, and -0 may be 0.'),
        new Group('identical', 'Every result has the bits of C++. NaN equals NaN.'),
    ];

    constructor(readonly api: Api) {
        this.element = element('section', 'api', element('h2', '', api_names[api]), this.said, this.probe, this.tiles,
            ...this.groups.map(group => group.element));
        this.element.dataset.api = api;
    }
    missing(why: string): void { this.said.textContent = `Not tried: this browser offers ${why}.`; }

    begun(device: string, entries: number, probe: string[]): void {
        this.said.textContent = `${device}. ${number(entries)} functions run in this language here.`;
        const is_first = (line: string) => first_lines.some(start => line.startsWith(start));
        const list = (lines: string[]) => element('ul', '', ...lines.map(line => element('li', '', line)));
        if (!probe.length) this.probe.append(element('p', 'amber', 'The probe of its arithmetic did not run.'));
        else this.probe.append(list(probe.filter(is_first)),
            element('details', '', element('summary', '', 'More of its arithmetic'), list(probe.filter(line => !is_first(line)))));
    }
    row(row: Row, sums: Sum[]): void {
        this.groups.find(group => group.verdict === row.verdict)?.add(row);
        this.show(sums);
    }
    lost(): void {
        this.element.insertBefore(element('p', 'notice', 'The browser took the GPU away during this run. The results up to then stand below.'), this.tiles);
    }

    /** The headline: what tier A does, and B and C beside it. */
    private show(sums: Sum[]): void {
        const promises = ['to the bit', 'as promised', 'within bounds'];
        this.tiles.replaceChildren(...sums.flatMap((sum, i) => {
            const all = sum.identical + sum.as_promised + sum.different, good = all - sum.different, letter = 'ABC'.charAt(i);
            if (!all && !sum.not_run) return [];
            const notes = [`${number(sum.inputs)} inputs`];
            if (i === 0 && sum.as_promised) notes.push(`only denormals, NaN or the sign of zero differ: ${sum.as_promised}`);
            if (i > 0) notes.push(`to the bit: ${sum.identical}`);
            if (sum.not_run) notes.push(`did not run: ${sum.not_run}`);
            return [element('div', `card ${sum.different ? 'bad' : 'good'}`,
                element('p', 'headline', `${letter}: ${number(good)} of ${number(all)} ${promises[i] ?? ''}`),
                element('p', 'faint', `${notes.join(' · ')}`))];
        }));
    }
}
