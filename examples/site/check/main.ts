// SPDX-License-Identifier: MIT
//
// The page that checks a shader: the text, the call, the answer. All that is chosen is in the address.
import { copy } from '../clipboard';
import { element, number } from '../elements';
import { show_answer, show_refusal } from './answer';
import { answer, button, by_id, choices, form, link, needs, show_controls, status, text } from './controls';
import { examples } from './examples';
import type { Subject } from './guess';
import { make_plan, type Plan } from './plan';
import { refuse_unfit, Refused } from './program';
import { signature, type Language } from './read';
import type { Answer, Order } from './run';
import { nothing, read_state, write_state, type Api, type State } from './state';

/** What the controls say, what is asked of it, and whether the answer that is shown is that of the controls. */
let state: State = nothing,
    asked: State | null = null,
    checked = false;
let names: Record<Subject, string[]> | null = null;
let plan: Plan;

function show(): void {
    plan = make_plan(state);
    show_controls(plan, state, names);
    answer.classList.toggle('stale', !checked && answer.childElementCount > 0);
    button.disabled = asked !== null || state.text.trim() === '';
}

let writing = 0;
/** Keeps the state in the address, packed: the newest wins. */
async function remember(): Promise<void> {
    const mine = ++writing,
        address = await write_state(state, checked);
    if (mine === writing) history.replaceState(null, '', address);
}
function changed(to: Partial<State>): void {
    state = { ...state, ...to };
    checked = false;
    status.textContent = '';
    show();
    void remember();
}

// ---- the check ----

let say: (order: Order | null) => void;

/** A worker that draws needs a canvas of its own. */
function can_draw_in_worker(): boolean {
    if (typeof OffscreenCanvas === 'undefined') return false;
    return 'gpu' in navigator || new OffscreenCanvas(1, 1).getContext('webgl2') !== null;
}

/** Sends orders to a worker, or carries them out here where a worker cannot draw. */
function start_worker(): void {
    const here = () => {
        say = order => void import('./run').then(({ carry_out }) => carry_out(order, take));
    };
    if (!can_draw_in_worker()) return here();
    const worker = new Worker(new URL('worker.js', import.meta.url), { type: 'module' });
    worker.addEventListener('message', ({ data }: MessageEvent<Answer>) => take(data));
    worker.addEventListener('error', event => {
        worker.terminate();
        start_worker();
        refused(`The check stopped: ${event.message || 'its script did not load'}.`, null, '');
    });
    say = order => worker.postMessage(order);
}

function refused(message: string, line: number | null, details: string): void {
    const lines = state.text.split('\n');
    done(
        'It does not run.',
        show_refusal(message, line === null ? null : `${line}  ${lines[line - 1] ?? ''}`, details),
    );
    if (line === null || !checked) return;
    const at = lines.slice(0, line - 1).reduce((sum, each) => sum + each.length + 1, 0);
    text.setSelectionRange(at, at + (lines[line - 1] ?? '').length);
    text.scrollTop = Math.max(0, (line - 6) * parseFloat(getComputedStyle(text).lineHeight));
}

function done(words: string, shown: HTMLElement[]): void {
    checked = asked === null || asked === state; // a reader may go on writing
    asked = null;
    status.textContent = checked ? words : 'The answer is to the text before your change.';
    answer.replaceChildren(...shown);
    answer.hidden = false;
    link.hidden = false;
    document.body.dataset['state'] = 'done';
    show();
    void remember();
}

function take(said: Answer): void {
    if ('names' in said) {
        names = said.names;
        show();
    } else if ('calls' in said) status.textContent = `${number(said.calls)} calls.`;
    else if ('found' in said) done('Done.', show_answer(said.found, said.subject));
    else refused(said.refused.message, said.refused.line, said.refused.details);
}

function check(): void {
    const { reading, of, call, api } = plan;
    document.body.dataset['state'] = 'running';
    try {
        refuse_unfit(reading, of, call);
    } catch (error) {
        if (!(error instanceof Refused)) throw error;
        return refused(error.message, error.line, error.details);
    }
    asked = state;
    status.textContent = 'Compiling.';
    show();
    say({ call, reading, api, is: state.is });
}

// ---- the page ----

function listen(): void {
    text.addEventListener('input', () => {
        const before = plan.of && signature(plan.of);
        changed({ text: text.value });
        if ((plan.of && signature(plan.of)) !== before) changed({ of: '', subject: '', given: {} });
    });
    choices.language.addEventListener('change', () =>
        changed({ language: choices.language.value as Language, api: '' }),
    );
    choices.api.addEventListener('change', () => changed({ api: choices.api.value as Api }));
    choices.of.addEventListener('change', () => changed({ of: choices.of.value, subject: '', given: {} }));
    choices.subject.addEventListener('change', () =>
        changed({ subject: choices.subject.value as Subject, is: '', given: {} }),
    );
    choices.is.addEventListener('change', () => changed({ is: choices.is.value }));
    needs.addEventListener('input', event => {
        const { name, value } = event.target as HTMLInputElement;
        changed({ given: { ...state.given, [name]: value } });
    });
    form.addEventListener('submit', event => {
        event.preventDefault();
        check();
    });
    choices.example.addEventListener('change', () => {
        const { name: _, ...example } = examples[choices.example.value]!;
        changed({ ...nothing, ...example });
    });
    link.addEventListener('click', async () => {
        const good = await copy(new URL(await write_state(state, true), location.href).href);
        status.textContent = good ? 'Link copied.' : 'The browser refused to copy.';
    });
    window.addEventListener('hashchange', () => void open_address());
}

async function open_address(): Promise<void> {
    const { state: read, run, complaints } = await read_state(location.hash);
    state = read.text === '' && location.hash.length < 2 ? { ...nothing, text: examples['half_texel']!.text } : read;
    by_id('notices').replaceChildren(...complaints.map(words => element('p', 'notice', words)));
    answer.hidden = true;
    link.hidden = true;
    answer.replaceChildren();
    show();
    if (run && state.text) check();
}

listen();
start_worker();
say!(null);
void open_address();
