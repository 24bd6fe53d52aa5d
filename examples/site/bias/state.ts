// SPDX-License-Identifier: MIT
//
// State of the bias page, and the same as the part of an address behind '#': engine=godot&filter=Soft+High&map_size=2048&...
// What an address has wrong is left at its default and told.
import { engines, lights_of, type Engine, type LightKind } from '../../../single_include/npm/engines.mjs';

export const map_sizes = [256, 512, 1024, 2048, 4096, 8192];

export interface State {
    engine: Engine | 'other';
    light: LightKind;
    filter: string;
    radius: number;
    map_size: number;
    width: number;
    range: number;
    /** Degrees of a spot light's cone, from side to side. */
    angle: number;
    /** Degrees between the floor of the picture and the light. */
    sun: number;
}

/** Of a light that nobody has given one. */
export const usual_range = (light: LightKind): number => (light === 'directional' ? 100 : 10);
export const first_filter = (engine: Engine): string => Object.keys(engines[engine].filters)[0]!;
export const usual: State = { engine: 'godot', light: 'directional', filter: first_filter('godot'), radius: 1,
    map_size: 2048, width: 50, range: usual_range('directional'), angle: 60, sun: 30 };

/** Numbers that a state may have. */
export const limits = { radius: [0, 32], width: [0.001, 1e6], range: [0.001, 1e6], angle: [1, 170], sun: [2, 85] } as const;

export function read_state(hash: string): { state: State; refused: string[] } {
    const given = new URLSearchParams(hash.replace(/^#/, '')), state = { ...usual }, refused: string[] = [];
    const engine = given.get('engine');
    if (engine !== null) {
        if (engine === 'other' || Object.hasOwn(engines, engine)) state.engine = engine as State['engine'];
        else refused.push(`engine=${engine}`);
    }
    if (state.engine !== 'other') state.filter = first_filter(state.engine);
    for (const [name, text] of given) {
        const number = text.trim() === '' ? NaN : Number(text);
        if (name === 'engine') continue;
        else if (name === 'light' && state.engine !== 'other' && (lights_of(state.engine) as string[]).includes(text)) state.light = text as LightKind;
        else if (name === 'filter' && state.engine !== 'other' && Object.hasOwn(engines[state.engine].filters, text)) state.filter = text;
        else if (name === 'map_size' && map_sizes.includes(number)) state.map_size = number;
        else if (Object.hasOwn(limits, name) && number >= limits[name as keyof typeof limits][0] && number <= limits[name as keyof typeof limits][1])
            state[name as keyof typeof limits] = number;
        else refused.push(`${name}=${text}`);
    }
    if (!given.has('range')) state.range = usual_range(state.light);
    return { state, refused };
}

/** All that a state has, so that a link still means the same when a default changes. */
export function write_state({ engine, light, filter, radius, map_size, width, range, angle, sun }: State): string {
    if (engine === 'other') return '#engine=other';
    const own = { directional: { width, range, sun }, spot: { angle, range, sun }, point: { range, sun } }[light];
    const all = { engine, light, filter, ...(engines[engine].radius && { radius }), map_size, ...own };
    return `#${new URLSearchParams(Object.entries(all).map(([name, value]) => [name, String(value)]))}`;
}
