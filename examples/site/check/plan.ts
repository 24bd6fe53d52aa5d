// SPDX-License-Identifier: MIT
//
// What the page knows of a text, with what it guesses where the reader has said nothing.
import { chosen, guess, subject_of, textures_of } from './guess';
import { settable_uniforms, uniforms_of, type Bound, type Call } from './program';
import { language_of, read, signature, type Needed, type Reading, type Signature } from './read';
import { apis_of, type Api, type State } from './state';

export interface Plan {
    reading: Reading;
    of: Signature | undefined;
    call: Call;
    api: Api;
}
export function make_plan(state: State): Plan {
    const language = state.language || language_of(state.text),
        reading = read(state.text, language),
        uniforms = uniforms_of(reading);
    const of = reading.functions.find(each => signature(each) === state.of) ?? chosen(reading.functions, state.text);
    const has_texture = uniforms.some(each => textures_of(each.type).length > 0);
    const subject = state.subject || (of ? subject_of(of, has_texture) : 'filter');
    const bound = (all: readonly Needed[]): Bound[] =>
        all.map(each => ({
            ...each,
            expression: state.given[each.name] ?? (of ? guess(each, of, subject, language, state.text) : ''),
        }));
    const call: Call = {
        language,
        text: state.text,
        subject,
        of: of ?? { name: '', returns: '', arguments: [], line: 0 },
        arguments: bound(of?.arguments ?? []),
        textures: bound(uniforms.filter(each => textures_of(each.type).length > 0)),
        uniforms: bound(uniforms.filter(each => settable_uniforms.includes(each.type))),
    };
    return {
        reading,
        of,
        call,
        api: state.api && apis_of[language].includes(state.api) ? state.api : apis_of[language][0],
    };
}
