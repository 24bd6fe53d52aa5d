// SPDX-License-Identifier: MIT
//
// What the page shows, as its address says it behind the #: a text is packed, the rest are words. An answer is a link.
import { languages, type Language } from './read';
import { subjects, type Subject } from './guess';

export const apis = { webgl2: 'WebGL 2', webgl1: 'WebGL 1', webgpu: 'WebGPU' } as const;
export type Api = keyof typeof apis;

/** APIs that run a language; the first is the usual one. */
export const apis_of: Record<Language, readonly [Api, ...Api[]]> = {
    glsl300: ['webgl2'],
    glsl100: ['webgl1', 'webgl2'],
    wgsl: ['webgpu'],
};

/** What a reader has chosen; '' where the page chooses. */
export interface State {
    text: string;
    language: Language | '';
    api: Api | '';
    /** A signature of the text: "shadow(sampler2D, vec2, float)". */
    of: string;
    subject: Subject | '';
    /** Expressions by the name of the argument or uniform, where they are not as guessed. */
    given: Record<string, string>;
    /** What the function should be; '': tell me. */
    is: string;
}
export const nothing: State = {
    text: '',
    language: '',
    api: '',
    of: '',
    subject: '',
    given: {},
    is: '',
};

async function through(
    stream: CompressionStream | DecompressionStream,
    bytes: Uint8Array<ArrayBuffer>,
): Promise<Uint8Array<ArrayBuffer>> {
    return new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer());
}
async function packed(text: string): Promise<string> {
    const bytes = await through(new CompressionStream('deflate-raw'), new TextEncoder().encode(text));
    return btoa(Array.from(bytes, byte => String.fromCharCode(byte)).join(''))
        .replaceAll('+', '-')
        .replaceAll('/', '_')
        .replaceAll('=', '');
}
async function unpacked(word: string): Promise<string> {
    const bytes = Uint8Array.from(atob(word.replaceAll('-', '+').replaceAll('_', '/')), c => c.charCodeAt(0));
    return new TextDecoder().decode(await through(new DecompressionStream('deflate-raw'), bytes));
}

/** The address of a state from "#", with `run` where the check is to run at once. */
export async function write_state(state: State, run: boolean): Promise<string> {
    const words = new URLSearchParams();
    for (const key of ['language', 'api', 'of', 'subject', 'is'] as const) if (state[key]) words.set(key, state[key]);
    for (const [name, expression] of Object.entries(state.given)) words.append('with', `${name}=${expression}`);
    if (run) words.set('run', '');
    if (state.text) words.set('text', await packed(state.text));
    return `#${String(words).replaceAll('=&', '&').replace(/=$/, '')}`;
}

/** The state of an address. `complaints` has a sentence for each thing in it that is not one. */
export async function read_state(hash: string): Promise<{ state: State; run: boolean; complaints: string[] }> {
    const state: State = { ...nothing, given: {} },
        complaints: string[] = [];
    let run = false;
    const one_of = <K extends string>(key: string, value: string, known: Record<K, unknown>): K | '' => {
        if (Object.hasOwn(known, value)) return value as K;
        complaints.push(`The address says ${key}=${value}. The page knows ${Object.keys(known).join(', ')}.`);
        return '';
    };
    for (const [key, value] of new URLSearchParams(hash.replace(/^#/, ''))) {
        if (key === 'text')
            state.text = await unpacked(value).catch(
                () => (complaints.push('The text in the address is cut off. Copy the whole link.'), ''),
            );
        else if (key === 'language') state.language = one_of(key, value, languages);
        else if (key === 'api') state.api = one_of(key, value, apis);
        else if (key === 'subject') state.subject = one_of(key, value, subjects);
        else if (key === 'of' || key === 'is') state[key] = value;
        else if (key === 'run') run = true;
        else if (key === 'with' && value.includes('='))
            state.given[value.slice(0, value.indexOf('='))] = value.slice(value.indexOf('=') + 1);
        else complaints.push(`The address says ${key}, which this page does not know. It is ignored.`);
    }
    return { state, run, complaints };
}
