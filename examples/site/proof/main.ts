// SPDX-License-Identifier: MIT
//
// The page: its controls, its address, and a section for each API.
import { copy } from '../clipboard';
import { element, number } from '../elements';
import { start } from './runner';
import type { Run } from './runner';
import type { News } from './run';
import { Section } from './section';
import { apis, read_state, write_state } from './state';
import type { Api, Plan } from './state';

const find = <T extends HTMLElement>(selector: string): T => {
    const found = document.querySelector<T>(selector);
    if (!found) throw new Error(`the page has no ${selector}`);
    return found;
};
const button = find<HTMLButtonElement>('#prove'), slider = find<HTMLInputElement>('#inputs'), shown = find<HTMLOutputElement>('#inputs_shown');
const bar = find<HTMLProgressElement>('#progress'), status = find('#status'), notices = find('#notices'), results = find('#results');
const report = find('#report'), told = find('#told');
const boxes = Object.fromEntries(apis.map(api => [api, find<HTMLInputElement>(`#${api}`)])) as Record<Api, HTMLInputElement>;

const { plan, run: at_once, complaints } = read_state(location.search);
let run: Run | null = null, reports: string[] = [], sections: Partial<Record<Api, Section>> = {};

const notice = (words: string) => notices.append(element('p', 'notice', words));

function show_plan(): void {
    slider.value = String(Math.log2(plan.inputs));
    shown.textContent = number(plan.inputs);
    for (const api of apis) boxes[api].checked = plan.on.includes(api);
    button.disabled = !plan.on.length;
}
function read_plan(): void {
    plan.inputs = 2 ** Number(slider.value);
    plan.on = apis.filter(api => boxes[api].checked);
    history.replaceState(null, '', location.pathname + write_state(plan));
    show_plan();
}
/** Address that runs this plan at once. */
function address(of: Plan): string {
    const state = write_state(of);
    return `${location.origin}${location.pathname}${state}${state ? '&' : '?'}run`;
}

let tried = 0, of = 0;
const section = (api: Api): Section => {
    const known = sections[api];
    if (known) return known;
    const made = sections[api] = new Section(api);
    results.append(made.element);
    return made;
};
function take(news: News): void {
    const here = section(news.api);
    if (news.what === 'missing') here.missing(news.why);
    else if (news.what === 'begun') {
        tried = 0;
        of = news.entries;
        here.begun(news.device, news.entries, news.probe);
    } else if (news.what === 'row') {
        here.row(news.row, news.sums);
        bar.max = of;
        bar.value = ++tried;
        status.textContent = `${tried} of ${of}: ${news.row.name}`;
    } else {
        reports.push(news.report);
        if (news.lost) here.lost();
    }
}

function ended(failed: string | null): void {
    run = null;
    button.textContent = 'Prove it again';
    bar.hidden = true;
    status.textContent = failed ?? (reports.length ? 'Done.' : 'Nothing could run.');
    status.className = failed ? 'bad' : 'faint';
    document.body.dataset.state = 'done';
    report.hidden = !reports.length;
}

function begin(): void {
    reports = [];
    sections = {};
    results.replaceChildren();
    report.hidden = true;
    bar.hidden = false;
    bar.removeAttribute('value');
    button.textContent = 'Stop';
    status.className = 'faint';
    status.textContent = 'Loading the C++ versions.';
    document.body.dataset.state = 'running';
    if (plan.fault) {
        const [from, ...to] = plan.fault.split('=');
        results.append(element('p', 'notice', `A fault is planted: in every shader, ${from} becomes ${to.join('=')}. Differences are what this run should show.`));
    }
    run = start({ plan: structuredClone(plan), command: address(plan), system: navigator.userAgent }, { news: take, notice, ended });
}

async function tell_copied(text: string, name: string): Promise<void> {
    told.textContent = await copy(text) ? `${name} copied.` : 'The browser refused to copy.';
}

for (const words of complaints) notice(words);
show_plan();
slider.addEventListener('input', read_plan);
for (const api of apis) boxes[api].addEventListener('change', read_plan);
button.addEventListener('click', () => run ? run.stop() : begin());
find('#copy').addEventListener('click', () => tell_copied(reports.join('\n'), 'Report'));
find('#link').addEventListener('click', () => tell_copied(address(plan), 'Address'));
find('#download').addEventListener('click', () => {
    const link = element('a');
    link.href = URL.createObjectURL(new Blob([reports.join('\n')], { type: 'text/markdown' }));
    link.download = 'umbrage-report.md';
    link.click();
    URL.revokeObjectURL(link.href);
});
if (at_once) begin();
