// Snippets bound to maps: which function a map has for each hook, and what cannot be. map_words.mjs makes the texts.
import { given_as_encoding, must_in } from './check.mjs';
import { is_of_map, is_snippet } from './compose.mjs';
import { declarations, for_map, has_region, is_bordered, is_expression, is_one_expression, laid_out, words_of } from './map_words.mjs';

const must = /*#__PURE__*/ must_in('bind');
export const calls = (s, roles) => roles.includes(s.role) || s.needs.some(need => calls(need, roles));
const reads_map = s => calls(s, ['texel', 'fetch_depth', 'lit', 'lit_2x2', 'gather_lit', 'gather_clamped', 'gather', 'lit_filtered', 'lit_between', 'depth_at']);

/** bind() of a language: snippet, name and map to an item of a text. */
export const bind_in = hooks => (what, name, ...rest) => {
    const map = complete(hooks, rest.length ? rest[0] : {});
    must(is_snippet(hooks.language, what), `what must be a snippet of ${hooks.language.name}`, what);
    must(typeof name === 'string', 'name must be a string', name);
    must(name === '' || /^[A-Za-z0-9]+(_[A-Za-z0-9]+)*$/.test(name),
        'name must be letters, digits and single underscores between them', name);
    check(hooks, what, map);
    if (map.receiver_plane) map.needs = [...map.needs, ...plane_needs(hooks, map)];
    return bound(hooks, what, name, map);
};

/** An item of what is known to go together; a shadow's has texts of its own in place of the snippet's. */
export function bound(hooks, what, name, map, own = [what]) {
    const suffix = name === '' ? '' : `_${name}`, words = { ...no_words, ...hooks.textures[map.texture] }, key = key_of(map);
    const fill = (s, plane) => laid_out(for_map(hooks, s, suffix, map, words, plane));
    return {
        what, suffix, map,
        parts: [...map.needs, ...words.needs, ...own],
        map_key: key === key_of(defaults) ? '' : key,
        chosen: s => chosen(hooks, s, map),
        fill: s => fill(s, map.receiver_plane && !(own.length > 1 && own.includes(s)) ? hooks.receiver_plane : ''),
        declarations: () => declarations(map, words),
    };
}

/** bind() without its checks, of what is known to go together: a page that has no other carries 3 kB less. */
export const bind_known = hooks => (what, name, map) => bound(hooks, what, name, { ...defaults, ...map });

const no_words = { texel: '', sampled: '', lit: '', gather_red: '', gather_green: '', gather_lit: '', lit_filtered: '', size: '',
    sampler: '', sampler_argument: '' };
const key_of = map => JSON.stringify(Object.keys(defaults).map(key => key === 'needs' ? map.needs.map(s => s.name) : map[key]));

/** Refuses what does not compile, whatever the language. */
export function check(hooks, what, map) {
    const one_channel = compares(map) || map.texture === 'depth' || map.texture === 'depth_array';
    must([1, 2, 3, 4].includes(map.channels), 'map.channels must be 1 to 4', map.channels);
    must(!one_channel || map.channels === 1, 'map.channels must be 1 for a depth texture', map.channels);
    must(!compares(map) || map.depth === '', 'map.depth must be empty for a comparison sampler', map.depth);
    must(!compares(map) || map.compare === '', 'map.compare must be empty for a comparison sampler', map.compare);
    for (const key of ['depth', 'compare', 'origin', 'texture_size', 'texel'])
        must(map[key] === '' || is_one_expression(map[key]), `map.${key} must be one expression on one line`, map[key]);
    must(map.parameters === '' || is_expression(map.parameters), 'map.parameters must be parameters on one line',
        map.parameters);
    must(map.arguments === '' || is_expression(map.arguments), 'map.arguments must be expressions on one line',
        map.arguments);
    for (const need of map.needs) must(!reads_map(need), 'map.needs must be snippets that read no map', need.name);
    must(!map.receiver_plane || map.compare === '' && !(map.gather && compares(map)),
        'map.receiver_plane must be false where a sampler gathers comparisons, or with an own comparison', true);
    check_hooks(hooks, what, what, map);
}

/** Every hook that the snippet calls is one that the map can have. */
function check_hooks(hooks, what, asked, map) {
    must(!compares(map) || !['texel', 'fetch_depth'].includes(asked.role),
        'what must be a snippet that reads no depths, as a comparison sampler gives none', what.name);
    must(asked.role !== 'gather' || gathers(map),
        'map.gather must be false where texels of cubes or whole numbers are gathered', true);
    must(asked.role !== 'gather' || map.channels <= 2, 'map.channels must be 1 or 2 where texels are gathered',
        map.channels);
    must(asked !== hooks.chosen.decode || !words_of(map.depth).includes('texel'),
        'map.depth must be of value alone where texels are gathered', map.depth);
    must(asked.role !== 'lit_filtered' || !map.receiver_plane || !compares(map),
        "map.receiver_plane must be false where a sampler weights a region's comparisons", true);
    for (const need of chosen(hooks, asked, map).needs) check_hooks(hooks, what, need, map);
}

const defaults = {
    texture: 'texture_2d', direction: 'forward', outside: '', gather: false, depth: '', channels: 1,
    compare: '', receiver_plane: false, origin: '', texture_size: '', parameters: '', arguments: '', texel: '', needs: [],
};
const choices = {
    texture: ['texture_2d', 'atlas', 'array', 'cube', 'cube_faces', 'integer', 'depth', 'depth_array', 'shadow', 'shadow_array'],
    direction: ['forward', 'reversed'],
    outside: ['bordered', 'clamped'],
};

const of_encodings = ['name', 'format', 'depth_format', 'cleared', 'write', 'reversed'];  // what they have beside a map's properties

/** A map's properties, those that are left out by default. */
export function complete(hooks, map) {
    must(typeof map === 'object' && map !== null && !Array.isArray(map), 'map must be an object', given_as_encoding(map));
    const all = { ...defaults };
    for (const [key, value] of Object.entries(map)) {
        if (of_encodings.includes(key)) continue;
        must(key in defaults, `map must have no properties but ${Object.keys(defaults).join(', ')}`, key);
        if (key in choices) must(choices[key].includes(value), `map.${key} must be one of ${choices[key].join(', ')}`, value);
        must(typeof value === typeof defaults[key], `map.${key} must be a ${typeof defaults[key]}`, value);
        all[key] = value;
    }
    must(Array.isArray(all.needs) && all.needs.every(need => is_snippet(hooks.language, need)), 'map.needs must be snippets', all.needs);
    return all;
}

const gathers = map => !['cube', 'cube_faces', 'integer'].includes(map.texture);
const compares = map => map.texture === 'shadow' || map.texture === 'shadow_array';
const samples = map => compares(map) && !has_region(map);

/** Snippets that compare along the receiver's plane. */
export function plane_needs(hooks, map) {
    const reference = is_bordered(map) ? hooks.bordered_plane_reference : hooks.plane_reference;
    return compares(map) ? [reference] : [reference, hooks.apply_receiver_plane];
}

/** The function that a map has in place of a hook's own text; other snippets as they are. */
function chosen(hooks, s, map) {
    const variant = which => hooks.chosen[`${s.role}, ${which}`];
    switch (s.role) {
        case 'compare':
            if (map.compare !== '') return variant('own');
            return map.direction === 'forward' ? s : variant('reversed');
        case 'cleared_depth': return map.direction === 'forward' ? s : variant('reversed');
        case 'beyond_far_plane':
        case 'within_far_plane':
            if (map.needs.some(need => need.scaled) || map.compare !== '') return variant('without');
            return map.direction === 'forward' ? s : variant('reversed');
        case 'map_covers':
        case 'texel_inside':
        case 'fetch_depth': return is_bordered(map) ? s : variant('clamped');
        case 'lit':
            if (map.receiver_plane) return variant(compares(map) ? 'compared along a plane' : 'along a plane');
            return compares(map) ? variant(is_bordered(map) ? 'bordered' : 'clamped') : s;
        case 'lit_filtered': return compares(map) ? variant(is_bordered(map) ? 'bordered' : 'clamped') : s;
        case 'lit_2x2':
            if (!map.gather) return s;
            return variant(is_bordered(map) && !map.receiver_plane ? 'gathered and bordered' : 'gathered');
        case 'gather_lit':
            if (compares(map)) return s;
            return variant(map.receiver_plane ? 'along a plane' : 'of depths');
        case 'gather_clamped': return has_region(map) ? variant('in a region') : s;
        case 'gather':
            if (compares(map)) return s;
            return variant(map.channels === 2 ? 'two channels' : 'one channel');
        case 'covered': return samples(map) && is_bordered(map) ? variant('bordered') : s;
        case 'lit_between':
            if (!samples(map)) return s;
            return variant(map.receiver_plane ? 'along a plane' : 'sampled');
        case 'depth_at':
            if (!map.gather || map.receiver_plane || !gathers(map) || compares(map) || has_region(map)) return s;
            return variant(is_bordered(map) ? 'sampled and bordered' : 'sampled');
        default: return s;
    }
}
