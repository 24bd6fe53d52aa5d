// SPDX-License-Identifier: MIT
//
// The page's controls: made of the choices, changed by the visitor or by a state.
import { choices, ranges, systems } from './choices';
import { argument_of } from './light';
import { choice_names, range_names, type State } from './state';

const in_the_picture = new Set(['view', 'yaw', 'pitch', 'distance']);  // set by dragging, or by tabs of their own

export class Controls {
    private readonly inputs = new Map<string, HTMLInputElement | HTMLSelectElement>();

    /** @param changed  takes what the visitor changed */
    constructor(place: HTMLElement, private readonly changed: (part: Partial<State>) => void) {
        const system = this.row(place, 'system', 'Preset', document.createElement('select'));
        system.add(new Option('None of them', ''));
        systems.forEach(({ words }, i) => system.add(new Option(words, String(i))));
        system.onchange = () => {
            const chosen = systems[Number(system.value)];
            if (system.value !== '' && chosen) changed(chosen.set);
        };
        for (const name of choice_names) {
            if (in_the_picture.has(name)) continue;
            const select = this.row(place, name, choices[name].label, document.createElement('select'));
            for (const [value, words] of choices[name].options) select.add(new Option(words, value));
            if (name === 'scene') select.querySelector<HTMLOptionElement>('[value=dropped]')!.disabled = true;
            select.onchange = () => changed({ [name]: select.value } as Partial<State>);
        }
        for (const name of range_names) {
            if (in_the_picture.has(name)) continue;
            const { label, low, high, step } = ranges[name], input = this.row(place, name, label, document.createElement('input'));
            Object.assign(input, { type: 'range', min: low, max: high, step });
            input.oninput = () => changed({ [name]: Number(input.value) } as Partial<State>);
        }
    }

    show(state: State) {
        for (const name of [...choice_names, ...range_names]) {
            const input = this.inputs.get(name);
            if (input) input.value = String(state[name]);
        }
        for (const name of range_names) {
            const input = this.inputs.get(name), { label, unit } = ranges[name];
            if (input) input.labels![0]!.textContent = `${label}: ${state[name]}${unit}`;
        }
        this.inputs.get('softness')!.disabled = argument_of(state) === undefined;
        const system = systems.findIndex(({ set }) => Object.entries(set).every(([name, value]) => state[name as keyof State] === value));
        this.inputs.get('system')!.value = system < 0 ? '' : String(system);
        this.inputs.get('scene')!.querySelector<HTMLOptionElement>('[value=dropped]')!.disabled = state.scene !== 'dropped';
    }

    private row<T extends HTMLInputElement | HTMLSelectElement>(place: HTMLElement, name: string, label: string, input: T): T {
        const row = document.createElement('div'), words = document.createElement('label');
        input.id = `set-${name}`;
        words.htmlFor = input.id;
        words.textContent = label;
        row.append(words, input);
        place.append(row);
        this.inputs.set(name, input);
        return input;
    }
}
