// A light's shadow as functions of a shader, its maps' target, and its depth pass. The texts are those of C++'s bind() and
// bind_depth_pass(); the values of its uniforms are those of values.mjs.
import { bound, calls as calls_hook, check, complete, plane_needs } from './bind.mjs';
import { given_as_encoding, must_be_clip_space, must_in } from './check.mjs';
import { all_fields, frame_in, vertex_in } from './frame.mjs';

const must = /*#__PURE__*/ must_in('shadow');
const defaults = { kind: undefined, filter: undefined, encoding: undefined, map_size: undefined, direction: 'forward', map: undefined,
    gather: false, linear: undefined, derivatives: false, block: 0, texture: 1, sampler: 2, set: 0, debug: undefined };
const terms = [{ name: 'terms', matrix: false }, { name: 'filter_terms', matrix: false }];  // what every block ends with

/** shadow() of a language. */
export const shadow_in = (hooks, calls, words, depth32f, declare) => (name, options) => {
    const { language } = hooks;
    must(typeof name === 'string' && /^[A-Za-z0-9]+(_[A-Za-z0-9]+)*$/.test(name),
        'name must be letters, digits and single underscores between them', name);
    must(typeof options === 'object' && options !== null, 'options must be an object', options);
    for (const key of Object.keys(options))
        must(key in defaults, `options must have no properties but ${Object.keys(defaults).join(', ')}`, key);
    const { kind, filter, encoding = depth32f, map_size, direction, gather, linear, derivatives, block, texture, sampler, set, debug, ...rest }
        = { ...defaults, ...options };
    must(kind?.language === language && kind.maps !== undefined, `kind must be a light of ${language.name}, as spot_light`, kind);
    must(filter?.language === language && filter.filter?.in_shadow === true, `filter must be one that a shadow takes, of ${language.name}`, filter);
    const is_moments = filter.filter.reads === 'moments', reversed = direction === 'reversed';
    must(!('encoding' in options && options.encoding === undefined) && encoding?.write?.language === language,
        `encoding must be one of ${language.name}`, given_as_encoding(options.encoding));
    must(encoding.reversed !== undefined, `encoding must be ${encoding.name} itself, whose reversed depth comes of direction`,
        `${encoding.name}.reversed`);
    must(!is_moments || options.encoding === undefined, 'encoding must be left out for a filter of moments', filter.name);
    must(direction === 'forward' || reversed, 'direction must be forward or reversed', direction);
    const size = typeof map_size === 'number' ? [map_size, map_size] : map_size;
    must(Array.isArray(size) && size.length === 2 && size.every(n => Number.isInteger(n) && n >= 1 && n <= 2 ** 15),
        'map_size must be whole texels from 1 to 32768, or two of them', map_size);
    for (const [key, slot] of Object.entries({ block, texture, sampler, set }))
        must(slot === (slot | 0) && slot >= 0, `${key} must be a whole number, 0 or above`, slot);
    must(debug === undefined || debug?.language === language && debug.read_map !== undefined, `debug must be debug of ${language.name}`, debug);
    const hardens = filter.filter.arguments.some(argument => argument.name === 'softness');
    const along_plane = !is_moments && !kind.maps.bends;  // each texel is compared along the receiver's plane
    must(!hardens || !kind.maps.bends, 'filter must be none of contact hardening for paraboloids, which bend planes', filter.name);

    const { grid: [columns, rows], outside } = kind.maps, several = columns * rows > 1;
    const lies_in = rest.map === undefined ? (several ? 'atlas' : 'texture_2d') : rest.map;
    const fitting = several ? ['atlas', 'array', 'depth_array', 'shadow_array'] : ['texture_2d', 'depth', 'shadow'];
    must(fitting.includes(lies_in), `map must be one of ${fitting.join(', ')} for this kind`, lies_in);
    const layers = lies_in.includes('array'), compares = lies_in.startsWith('shadow'), of_depth = compares || lies_in.startsWith('depth');
    must(!is_moments || !of_depth, 'map must be a color texture for a filter of moments', lies_in);
    for (const [key, value] of Object.entries({ gather, derivatives })) must(typeof value === 'boolean', `${key} must be true or false`, value);
    must(!compares || is_moments || !encoding.depth, 'encoding must be depth32f, depth24 or depth16, as map is a comparison sampler', encoding.name);
    must(!of_depth || is_moments || encoding.channels === 1, 'encoding must be of one channel, as map is a depth texture', encoding.name);
    must(!hardens || !compares, 'filter must be one that needs no depths, as map is a comparison sampler', filter.name);
    must(!gather || !compares, 'gather must be false where map is a comparison sampler', gather);
    must(!gather || calls_hook(filter, ['lit_2x2']), 'filter must be pcf_2x2 or a kernel, as gather is true', filter.name);
    if (linear !== undefined) {
        must(compares && along_plane, 'linear must be left out where map is no comparison sampler, and for paraboloids', linear?.name ?? linear);
        const form = filter.filter.linear?.name;
        must(form !== undefined, 'filter must be pcf_2x2, a disc, or a kernel of 3, 5 or 7 weights, as linear is given', filter.name);
        must(linear?.language === language && linear.name === form, `linear must be ${form}, the form of ${filter.name}`, linear?.name ?? linear);
    }
    const whole = [size[0] * columns, size[1] * rows];
    const stored = reversed ? encoding.reversed : encoding;
    const map = complete(hooks, { texture: lies_in, direction, outside, depth: stored.depth, channels: stored.channels,
        receiver_plane: along_plane, needs: stored.needs, gather,
        texture_size: lies_in === 'atlas' ? `vec2(${whole[0]}.0, ${whole[1]}.0)` : '' });
    if (along_plane) map.needs = [...map.needs, ...plane_needs(hooks, map)];

    const turns = filter.filter.arguments.some(argument => argument.name === 'rotation');
    const own = ({ name, text, needs }) => ({ language, name, exactness: 'a', lowest: '100', role: 'none', needs, text });
    const frame = frame_in(words, calls, { snippet: filter, maps: kind.maps, along_plane, turns, hardens, layers, linear });
    const umbrage_shadow = own(frame.shadow()), texts = [own(frame.look()), umbrage_shadow];
    const tolerance = is_moments ? 'moments' : encoding.name;
    if (debug) texts.push(...frame.debug(debug, debug[kind.maps.bends ? 'parts_of_bent' : 'parts'][tolerance]).map(own));
    texts.forEach((text, i) => text.needs.push(...texts.slice(0, i)));  // each may call those before it
    for (const text of texts) check(hooks, text, map);
    const item = bound(hooks, umbrage_shadow, name, map, texts);
    const fields = [...all_fields(kind.maps, hardens), ...terms];
    const declares = { name, fields, block, texture, sampler, set, functions: functions_of(turns, debug, derivatives) };
    const texel = is_moments ? filter.filter : encoding;
    return {
        ...item,
        declared: { name, text: version => declare(declares, item.declarations(), version) },
        depth_pass: bound(hooks, texel.write, name, complete(hooks, { direction })),
        vertex_pass: clip => {
            must_be_clip_space(must, 'clip', clip, ['direction', 'range']);
            must(clip.direction === direction, `clip must be a clip space whose depth is ${direction}`, clip.direction);
            const at_near = reversed ? '1.0' : clip.range === 'zero_to_one' ? '0.0' : '-1.0';
            return bound(hooks, own(vertex_in(words, calls, { vertex: kind.maps.vertex, pancakes: kind.pancakes }, at_near)), name,
                complete(hooks, { direction }));
        },
        cleared: is_moments ? filter.filter[reversed ? 'cleared_reversed' : 'cleared'] : stored.cleared,
        target: { format: of_depth && !is_moments ? encoding.depth_format : texel.format, size: layers ? size : whole, layers: layers ? columns * rows : 1,
            grid: layers ? [1, 1] : [columns, rows], map_size: size },
        settings: { kind: kind.name, filter, encoding: is_moments ? '' : encoding.name, direction, map_size: size },
        bytes: fields.reduce((sum, field) => sum + (field.matrix ? 64 : 16), 0),
    };
};

/** The functions that a text declares for a shadow. */
const functions_of = (turns, debug, derived) => [
    { name: '', calls: 'shadow', components: 1,
        says: `visibility of a point of the world, 1.0 is lit; ${derived ? 'outside branches' : 'a normal of zero is none'}`,
        reads_map: true, reads_fields: true, arguments: [['world', 3], ['normal', 3, derived], ...turns ? [['pixel', 2]] : []] },
    ...debug ? [
        { name: 'probe', calls: 'point_color', says: 'debug color of a point of the world, as umbrage_probe_color says', components: 3,
            reads_map: false, reads_fields: true, arguments: [['world', 3], ['normal', 3, derived]] },
        { name: 'calibrate', calls: 'reading', components: 1, reads_map: true, reads_fields: false, arguments: [['number', 1]],
            says: 'what a calibration map is read as: 0.0 right, 1.0 empty, 2.0 dark, 3.0 upside down,\n'
                + '//   4.0 another map, 5.0 compared the wrong way round, 6.0 too coarse, 7.0 other depths' }] : []];
