// SPDX-License-Identifier: MIT
//
// The page's controls: they show a plan.
import { element } from '../elements';
import { examples } from './examples';
import { subjects, words, type Subject } from './guess';
import type { Plan } from './plan';
import { languages, signature } from './read';
import { apis, apis_of, type State } from './state';

export const by_id = <T extends HTMLElement>(id: string): T => document.getElementById(id) as T;
export const text = by_id<HTMLTextAreaElement>('text'),
    form = by_id<HTMLFormElement>('call'),
    status = by_id('status'),
    answer = by_id('answer');
export const button = by_id<HTMLButtonElement>('check'),
    link = by_id<HTMLButtonElement>('link'),
    needs = by_id('needs');
export const choices = {
    example: by_id<HTMLSelectElement>('example'),
    language: by_id<HTMLSelectElement>('language'),
    api: by_id<HTMLSelectElement>('api'),
    of: by_id<HTMLSelectElement>('of'),
    subject: by_id<HTMLSelectElement>('subject'),
    is: by_id<HTMLSelectElement>('is'),
};

function fill(
    select: HTMLSelectElement,
    options: readonly (readonly [value: string, words: string])[],
    value: string,
): void {
    const all = options.map(([value, words]) => Object.assign(element('option', '', words), { value }));
    if (all.map(each => each.outerHTML).join() !== Array.from(select.options, each => each.outerHTML).join())
        select.replaceChildren(...all);
    select.value = value;
}

/** A row for each value that the call needs. Rows that are still right stay, so that a cursor in one does too. */
function show_needs(plan: Plan): void {
    const {
        call: { arguments: all, textures, uniforms },
    } = plan;
    const rows = [
        ...all.map(each => ({ each, kind: 'argument' })),
        ...[...textures, ...uniforms].map(each => ({ each, kind: 'uniform' })),
    ];
    const key = JSON.stringify(rows.map(({ each, kind }) => [kind, each.type, each.name]));
    if (needs.dataset['key'] !== key) {
        needs.dataset['key'] = key;
        needs.replaceChildren(
            ...rows.map(({ each, kind }) => {
                const input = Object.assign(element('input'), {
                    name: each.name,
                    spellcheck: false,
                    autocomplete: 'off',
                });
                return element(
                    'label',
                    'field',
                    element(
                        'span',
                        '',
                        element('code', '', `${each.type} ${each.name}`),
                        kind === 'uniform' ? ' (uniform)' : '',
                    ),
                    input,
                );
            }),
        );
    }
    needs.querySelectorAll('input').forEach((input, i) => {
        if (input.value !== rows[i]!.each.expression) input.value = rows[i]!.each.expression;
    });
    by_id('given').hidden = rows.length === 0;
}

/** @param names   functions that a function can be, once they have arrived */
export function show_controls(plan: Plan, state: State, names: Record<Subject, string[]> | null): void {
    const { reading, of, call, api } = plan,
        { language, subject } = call;
    if (text.value !== state.text) text.value = state.text;
    const example = Object.keys(examples).find(each => examples[each]!.text === state.text) ?? '';
    fill(
        choices.example,
        [
            ...(example ? [] : [['', 'yours'] as const]),
            ...Object.entries(examples).map(([value, { name }]) => [value, name] as const),
        ],
        example,
    );
    fill(choices.language, Object.entries(languages), language);
    fill(
        choices.api,
        apis_of[language].map(each => [each, apis[each]]),
        api,
    );
    fill(
        choices.of,
        reading.functions.length
            ? reading.functions.map(each => [signature(each), signature(each)])
            : [['', 'No function yet']],
        of ? signature(of) : '',
    );
    fill(choices.subject, Object.entries(subjects), subject);
    const known = names?.[subject] ?? [],
        other = state.is !== '' && !known.includes(state.is) ? [state.is] : [];
    fill(choices.is, [['', 'Tell me'], ...[...other, ...known].map(each => [each, each] as const)], state.is);
    show_needs(plan);
    by_id('words').replaceChildren(
        ...words[subject]
            .filter(({ only }) => !only || only.includes(language))
            .flatMap(({ word, means }) => [element('dt', '', element('code', '', word)), element('dd', '', means)]),
    );
}
