// SPDX-License-Identifier: MIT
//
// What the visitor has set, and the part of the page's address that keeps it.
import { choices, ranges } from './choices';

type Choices = { [Name in keyof typeof choices]: (typeof choices)[Name]['options'][number][0] };
type Ranges = { [Name in keyof typeof ranges]: number };
export type State = Choices & Ranges;

export const choice_names = Object.keys(choices) as (keyof Choices)[];
export const range_names = Object.keys(ranges) as (keyof Ranges)[];

const usual = Object.fromEntries([...choice_names.map(name => [name, choices[name].options[0][0]]),
    ...range_names.map(name => [name, ranges[name].usual])]) as State;

/** Reads the part of an address behind '?'. What it cannot be is left at its default, and said in `refused`. */
export function read_state(query: string): { state: State; refused: string[] } {
    const state = { ...usual }, refused: string[] = [];
    for (const [name, text] of new URLSearchParams(query)) {
        if (name in choices) {
            const known = choices[name as keyof Choices].options.some(([value]) => value === text);
            if (known) Object.assign(state, { [name]: text });
            else refused.push(`${name}=${text}`);
        } else if (name in ranges) {
            const { low, high } = ranges[name as keyof Ranges], number = text.trim() === '' ? NaN : Number(text);
            if (number >= low && number <= high) Object.assign(state, { [name]: number });
            else refused.push(`${name}=${text}`);
        } else refused.push(name);
    }
    if (state.scene === 'dropped') {  // a file is not in the address
        state.scene = 'garden';
        refused.push('scene=dropped');
    }
    return { state, refused };
}

/** The part of the address behind '?' for a state: what differs from the defaults. */
export function write_state(state: State): string {
    const query = new URLSearchParams();
    for (const name of [...choice_names, ...range_names])
        if (state[name] !== usual[name] && state[name] !== 'dropped') query.set(name, String(state[name]));
    return query.toString();
}
