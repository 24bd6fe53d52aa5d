// SPDX-License-Identifier: MIT
//
// What the addons share: options are checked before a host's text is touched, whose functions are found by their braces.
import { shown } from './compose/check.mjs';

export function must(where, holds, condition, got) {
    if (!holds) throw new Error(`umbrage/${where}: ${condition}; got ${shown(got)}`);
}

const is_object = value => typeof value === 'object' && value !== null && !Array.isArray(value);

/** What an option must be: words and a test. */
export const flag = ['true or false', value => typeof value === 'boolean'];
export const checked_later = ['', () => true];

/** What a number must be: words and a test. */
export const above_zero = ['a finite number above 0', value => Number.isFinite(value) && value > 0];

/** Refuses numbers of an engine's object that its user set to what no shadow has. */
export function check_numbers(where, name, object, known) {
    for (const [key, [words, holds]] of Object.entries(known)) must(where, holds(object[key]), `${name}.${key} must be ${words}`, object[key]);
}

/** Refuses points that lie nowhere. */
export function check_places(where, name, points) {
    for (const point of points) must(where, point.every(Number.isFinite), `${name} must be at a finite place in the world`, point);
}

/** Refuses options that an addon does not have, and values of another kind.
 *  @param known   what each option must be */
export function check_options(where, options, known) {
    must(where, is_object(options), 'options must be an object', options);
    for (const [key, value] of Object.entries(options)) {
        must(where, Object.hasOwn(known, key), `options must have no properties but ${Object.keys(known).join(', ')}`, key);
        const [words, holds] = known[key];
        must(where, value === undefined || holds(value), `${key} must be ${words}`, value);
    }
}

/** Refuses an option that is no filter in the language, or one that engines' maps do not suit. */
export function check_filter(where, option, filter, language) {
    must(where, typeof filter?.text === 'string' && filter.filter,
        `${option} must be a filter of this package, such as pcss16`, filter?.name ?? filter);
    must(where, filter.language?.name === language, `${option} must be a filter in ${language}`, filter.language?.name);
    must(where, filter.filter.reads !== 'moments' && !filter.filter.offsets,
        `${option} must read depths through one coordinate`, filter.name);
}

const is_float = value => Number.isFinite(value) && Number.isFinite(Math.fround(value));

/** What an argument must be, by its default. */
function of_default({ type, value }) {
    if (type === 'int') return ['an integer of 32 bits', given => Number.isInteger(given) && (given | 0) === given];
    if (type === 'float') return ['a finite float of 32 bits', is_float];
    return [`${value.length} finite floats of 32 bits`,
        given => Array.isArray(given) && given.length === value.length && Array.from(given).every(is_float)];
}

const is_radius = value => Number.isInteger(value) && value >= 0 && value <= 4095;

/** What a softness must be, as the C++ library has it of penumbra_params. */
const softness = ['[per_code_x, per_code_y, min_radius, max_radius], the first two from 0 to 4096, the others integers in order '
    + 'from 0 to 4095',
    ([x, y, min, max]) => [x, y].every(per_code => per_code >= 0 && per_code <= 4096) && is_radius(min) && is_radius(max) && min <= max];

/** A filter's arguments behind the receiver: defaults, and those that the user gave. */
export function checked_arguments(where, filter, given = {}) {
    must(where, is_object(given), 'arguments must be an object', given);
    const known = filter.filter.arguments.filter(({ name }) => name !== 'rotation');  // each pixel has its own
    const own = {}, all = {};
    for (const [name, value] of Object.entries(given)) {
        must(where, known.some(a => a.name === name),
            `arguments must be among (${known.map(a => a.name).join(', ')}) of ${filter.name}`, name);
        if (value !== undefined) own[name] = value;
    }
    for (const argument of known) {
        const { name, value } = argument, [words, holds] = of_default(argument);
        all[name] = name in own ? own[name] : value;
        must(where, holds(all[name]), `arguments.${name} must be ${words}`, all[name]);
        if (name === 'softness') must(where, softness[1](all[name]), `arguments.softness must be ${softness[0]}`, all[name]);
    }
    return { own, all };
}

/** Numbers as a shader writes them; type is GLSL's or WGSL's. */
function literal(type, value) {
    if (type === 'int') return String(value);
    const float = number => (Number.isInteger(number) ? number.toFixed(1) : String(number));
    return type === 'float' ? float(value) : `${type}(${value.map(float).join(', ')})`;
}

/** A filter's arguments behind the receiver, in a shader: the light's radius is a disc's radius, and scales a softness.
 *  @param words   rotation and radius as the host's shader has them, the latter if it has one, and the language's vec4 */
export function further_arguments(filter, given, { rotation, radius, vec4 }) {
    return filter.filter.arguments.map(({ name, type }) => ', ' + (
        name === 'rotation' ? rotation
        : name === 'radius' && type === 'float' && radius && !(name in given.own) ? radius
        : name === 'softness' ? `(${literal(vec4, given.all[name])} * ${vec4}(${radius}, ${radius}, 1.0, 1.0))`
        : literal(type, given.all[name]))).join('');
}

/** What a frame adds to a pixel's y for its rotation: the frame's four bits reversed, so that any few frames in a row have
 *  rotations far apart, and 16 frames have all of them once. */
export const turn_of_frame = frame => [8, 4, 2, 1].reduce((turn, bit, i) => turn + ((frame >> i) & 1) * bit, 0);

/** Where a body ends, behind its closing brace; begin lies behind the opening one. */
export function end_of_body(text, begin) {
    let depth = 1, end = begin;
    for (; depth > 0 && end < text.length; ++end) depth += { '{': 1, '}': -1 }[text[end]] ?? 0;
    return end;
}
