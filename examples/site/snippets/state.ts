// SPDX-License-Identifier: MIT
//
// State of the page, and the same as a URL: ?language=glsl&version=300+es&snippet=pcf_2x2&map=sun&texture=array&...
// Each `snippet` begins another item; what follows belongs to it. What a URL has wrong is left out and told.

export const languages = { glsl: 'GLSL', hlsl: 'HLSL', wgsl: 'WGSL', msl: 'Metal' } as const;
export type Language = keyof typeof languages;
export const passes = { lookup: 'the lookup', depth: 'the depth pass' } as const;
export type Pass = keyof typeof passes;
export const versions = [
    'any',
    '100',
    '110',
    '120',
    '130',
    '150',
    '300 es',
    '310 es',
    '320 es',
    '330',
    '430',
    '450',
    '460',
] as const;

/// A map's properties with their choices; the first of each is the default.
export const choices = {
    texture: [
        'texture_2d',
        'atlas',
        'array',
        'cube',
        'cube_faces',
        'integer',
        'depth',
        'depth_array',
        'shadow',
        'shadow_array',
    ],
    stored: [
        'depth32f',
        'depth24',
        'depth16',
        'rg9',
        'rg10',
        'rg11',
        'rg12',
        'rg13',
        'rg14',
        'rg15',
        'rg16',
        'rgb24',
        'rgb10',
        'r16',
        'float_bits',
        'threejs_rgba',
        'threejs_rgb',
        'threejs_rg',
        'threejs_legacy',
        'base255',
    ],
    direction: ['forward', 'reversed'],
    outside: ['default', 'bordered', 'clamped'],
    gather: ['no', 'yes'],
} as const;
export type Property = keyof typeof choices;
export const properties = Object.keys(choices) as Property[];

/// A function and the map that it reads.
export type Item = { snippet: string; map: string } & Record<Property, string>;
export interface State {
    language: Language;
    version: string;
    pass: Pass;
    items: Item[];
}

export const first_snippet = 'pcf_2x2';

export function new_item(snippet = first_snippet, map = ''): Item {
    return {
        snippet,
        map,
        texture: 'texture_2d',
        stored: 'depth32f',
        direction: 'forward',
        outside: 'default',
        gather: 'no',
    };
}

const is_map_name = (name: string): boolean => name === '' || /^[A-Za-z0-9]+(_[A-Za-z0-9]+)*$/.test(name);

/// The state of a URL's query, and a sentence for each thing in it that is not one.
export function parse(query: string, is_snippet: (name: string) => boolean): { state: State; problems: string[] } {
    const state: State = { language: 'glsl', version: 'any', pass: 'lookup', items: [] },
        problems: string[] = [];
    for (const [key, value] of new URLSearchParams(query)) {
        const item = state.items.at(-1);
        if (key === 'language') {
            if (Object.hasOwn(languages, value)) state.language = value as Language;
            else problems.push(`No language is called "${value}": shown in GLSL.`);
        } else if (key === 'version') {
            if ((versions as readonly string[]).includes(value)) state.version = value;
            else problems.push(`No version of GLSL is called "${value}": shown for any.`);
        } else if (key === 'pass') {
            if (Object.hasOwn(passes, value)) state.pass = value as Pass;
            else problems.push(`No pass is called "${value}": the lookup is shown.`);
        } else if (key === 'snippet') {
            if (!is_snippet(value)) problems.push(`No function is called "${value}".`);
            state.items.push(new_item(is_snippet(value) ? value : first_snippet));
        } else if (key === 'map' && item) {
            if (is_map_name(value)) item.map = value;
            else
                problems.push(
                    `A map's name has letters, digits and single underscores between them, unlike "${value}".`,
                );
        } else if (Object.hasOwn(choices, key) && item) {
            if ((choices[key as Property] as readonly string[]).includes(value)) item[key as Property] = value;
            else problems.push(`"${value}" is no choice of "${key}": the default is shown.`);
        } else problems.push(`The address has "${key}", which this page does not know.`);
    }
    if (state.items.length === 0) state.items.push(new_item());
    return { state, problems };
}

/// The query of a state, without what is left at its default.
export function print({ language, version, pass, items }: State): string {
    const query = new URLSearchParams();
    if (language !== 'glsl') query.append('language', language);
    if (version !== 'any' && language === 'glsl') query.append('version', version);
    if (pass !== 'lookup') query.append('pass', pass);
    for (const item of items) {
        query.append('snippet', item.snippet);
        if (item.map !== '') query.append('map', item.map);
        for (const key of properties) if (item[key] !== choices[key][0]) query.append(key, item[key]);
    }
    return `?${query}`;
}
