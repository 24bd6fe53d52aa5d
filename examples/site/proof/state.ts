// SPDX-License-Identifier: MIT
//
// What the page is to run, as its address says it: ?on=webgl2,webgpu&inputs=4096&only=pcf&every=1&fault=floor=ceil&run

export const apis = ['webgl2', 'webgpu', 'webgl1'] as const;
export type Api = (typeof apis)[number];

/** One run. */
export interface Plan {
    on: Api[];
    /** Inputs of an entry. */
    inputs: number;
    /** Only entries whose names have this in them. */
    only: string;
    /** One in so many of them. */
    every: number;
    /** A mistake to plant into the shaders, FROM=TO; empty: none. */
    fault: string;
}

export const lowest_inputs = 8, highest_inputs = 18;  // as powers of two
export const default_plan: Plan = { on: [...apis], inputs: 4096, only: '', every: 1, fault: '' };

const is_api = (word: string): word is Api => (apis as readonly string[]).includes(word);
const is_inputs = (n: number) => Number.isInteger(Math.log2(n)) && Math.log2(n) >= lowest_inputs && Math.log2(n) <= highest_inputs;

/** The plan of an address. `complaints` has a sentence for each value that is none, for which the default stands. */
export function read_state(search: string): { plan: Plan; run: boolean; complaints: string[] } {
    const plan = structuredClone(default_plan), complaints: string[] = [];
    let run = false;
    const refuse = (key: string, value: string, rule: string) =>
        complaints.push(`The address says ${key}=${value}. ${rule} The page takes its default.`);
    for (const [key, value] of new URLSearchParams(search)) {
        if (key === 'on') {
            const words = value.split(',');
            if (words.every(is_api)) plan.on = apis.filter(api => words.includes(api));
            else refuse(key, value, `It must be a list of ${apis.join(', ')}.`);
        } else if (key === 'inputs') {
            if (is_inputs(+value)) plan.inputs = +value;
            else refuse(key, value, `It must be a power of two from ${2 ** lowest_inputs} to ${2 ** highest_inputs}.`);
        } else if (key === 'every') {
            if (/^[1-9]\d{0,2}$/.test(value)) plan.every = +value;
            else refuse(key, value, 'It must be an integer from 1 to 999.');
        } else if (key === 'fault') {
            if (/^.+=/s.test(value)) plan.fault = value;
            else refuse(key, value, 'It must be FROM=TO, such as floor=ceil.');
        } else if (key === 'only') plan.only = value;
        else if (key === 'run') run = true;
        else complaints.push(`The address says ${key}, which this page does not know. It is ignored.`);
    }
    return { plan, run, complaints };
}

/** The shortest address that says a plan, from "?"; empty for the default. */
export function write_state(plan: Plan): string {
    const words: string[] = [];
    const say = (key: string, value: string, usual: string) => {
        if (value !== usual) words.push(`${key}=${encodeURIComponent(value).replaceAll('%2C', ',').replaceAll('%3D', '=')}`);
    };
    say('on', plan.on.join(','), default_plan.on.join(','));
    say('inputs', String(plan.inputs), String(default_plan.inputs));
    say('only', plan.only, '');
    say('every', String(plan.every), '1');
    say('fault', plan.fault, '');
    return words.length ? `?${words.join('&')}` : '';
}
