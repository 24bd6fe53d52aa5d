// SPDX-License-Identifier: MIT
//
// What the addons share: options are checked before a host's text is touched, whose functions are found by their braces.

export function must(where, holds, condition, got) {
    if (!holds) throw new Error(`umbrage/${where}: ${condition}; got ${got}`);
}

/** A filter's arguments behind the receiver: defaults, and those that the user gave. */
export function checked_arguments(where, filter, own = {}) {
    must(where, typeof filter?.text === 'string' && filter.filter, 'filter must be a filter of this package, such as pcss16',
        filter?.name ?? filter);
    must(where, filter.filter.reads !== 'moments' && !filter.filter.offsets,
        'filter must read depths through one coordinate', filter.name);
    const known = filter.filter.arguments, all = {};
    for (const name of Object.keys(own))
        must(where, known.some(a => a.name === name),
            `arguments must be among (${known.map(a => a.name).join(', ')}) of ${filter.name}`, name);
    for (const { name, value } of known) {
        all[name] = own[name] ?? value;
        const same = [all[name]].flat().length === [value].flat().length;
        must(where, same && [all[name]].flat().every(Number.isFinite),
            `arguments.${name} must be ${[value].flat().length} finite numbers`, all[name]);
    }
    return { own, all };
}

/** Numbers as a shader writes them; type is GLSL's or WGSL's. */
function literal(type, value) {
    if (type === 'int') return String(Math.round(value));
    const float = number => (Number.isInteger(number) ? number.toFixed(1) : String(number));
    return type === 'float' ? float(value) : `${type}(${value.map(float).join(', ')})`;
}

/** A filter's arguments behind the receiver, in a shader: the light's radius is a disc's radius, and scales a softness.
 *  @param words   rotation and radius as the host's shader has them, the latter if it has one, and the language's vec3 */
export function further_arguments(filter, given, { rotation, radius, vec3 }) {
    return filter.filter.arguments.map(({ name, type }) => ', ' + (
        name === 'rotation' ? rotation
        : name === 'radius' && type === 'float' && radius && !(name in given.own) ? radius
        : name === 'softness' ? `(${literal(vec3, given.all[name])} * ${vec3}(${radius}, 1.0, 1.0))`
        : literal(type, given.all[name]))).join('');
}

/** Where a body ends, behind its closing brace; begin lies behind the opening one. */
export function end_of_body(text, begin) {
    let depth = 1, end = begin;
    for (; depth > 0 && end < text.length; ++end) depth += { '{': 1, '}': -1 }[text[end]] ?? 0;
    return end;
}
