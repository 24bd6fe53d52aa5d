// umbrage 0.1.0, MIT License. Shadow mapping primitives as shader texts in GLSL, HLSL, MSL and WGSL.
//
//     import { bind, pcf_2x2, source, wgsl } from 'umbrage';
//     const fragment = source('300 es', [bind(pcf_2x2, 'sun', { texture: 'array' })]) + my_main;
//     const module = wgsl.text([pcf_2x2]);
//
// Written by the C++ library's build, with which every text agrees to the character; the data stand at the end.

const calls = (s, roles) => roles(s.role) || s.needs.some(need => calls(need, roles));
const is_of_map = s => calls(s, role => role !== 'none');
const reads_map = s => calls(s, role => ['texel', 'fetch_depth', 'lit', 'lit_2x2', 'gather_lit', 'lit_filtered', 'lit_at',
    'depth_at'].includes(role));

/** The snippet as functions for one map: umbrage_<what>_<name>, or without a suffix when the name is empty. */
function bind(what, name, ...rest) {
    const map = complete(rest.length ? rest[0] : {});
    must(is_snippet(what), 'what must be a snippet', what);
    must(typeof name === 'string', 'name must be a string', name);
    must(name === '' || /^[A-Za-z0-9]+(_[A-Za-z0-9]+)*$/.test(name),
        'name must be letters, digits and single underscores between them', name);
    check(what, map);
    if (map.receiver_plane) map.needs = [...map.needs, snippets.apply_receiver_plane];
    return { what, suffix: name === '' ? '' : `_${name}`, map };
}

function must(holds, condition, got) {
    if (!holds) throw new Error(`umbrage: bind: ${condition}; got ${got === '' ? '""' : got}`);
}

/** Refuses what does not compile, whatever the language. */
function check(what, map) {
    const one_channel = compares(map) || map.texture === 'depth' || map.texture === 'depth_array';
    must([1, 2, 3, 4].includes(map.channels), 'map.channels must be 1 to 4', map.channels);
    must(!one_channel || map.channels === 1, 'map.channels must be 1 for a depth texture', map.channels);
    must(!compares(map) || map.depth === '', 'map.depth must be empty for a comparison sampler', map.depth);
    must(!compares(map) || map.compare === '', 'map.compare must be empty for a comparison sampler', map.compare);
    for (const key of ['depth', 'compare', 'origin', 'texture_size', 'texel'])
        must(map[key] === '' || is_expression(map[key]), `map.${key} must be one expression on one line`, map[key]);
    must(map.parameters === '' || is_expression(map.parameters), 'map.parameters must be parameters on one line',
        map.parameters);
    must(map.arguments === '' || is_expression(map.arguments), 'map.arguments must be expressions on one line',
        map.arguments);
    for (const need of map.needs) must(!reads_map(need), 'map.needs must be snippets that read no map', need.name);
    must(!map.receiver_plane || !(map.gather || compares(map)),
        'map.receiver_plane must be false where texels are gathered or compared by the sampler', true);
    check_hooks(what, what, map);
}

/** Every hook that the snippet calls is one that the map can have. */
function check_hooks(what, asked, map) {
    must(!compares(map) || !['texel', 'fetch_depth'].includes(asked.role),
        'what must be a snippet that reads no depths, as a comparison sampler gives none', what.name);
    must(asked.role !== 'gather_lit' || gathers(map),
        'map.gather must be false where texels of cubes or whole numbers are gathered', true);
    must(asked.role !== 'gather_lit' || map.channels <= 2, 'map.channels must be 1 or 2 where texels are gathered',
        map.channels);
    must(asked !== hooks.decode || !words_of(map.depth).includes('texel'), 'map.depth must be of value alone where texels are gathered',
        map.depth);
    for (const need of chosen(asked, map).needs) check_hooks(what, need, map);
}

/** Whether a text can stand in an expression: one line, brackets in pairs, no comment, no directive, no statement. */
function is_expression(text) {
    if (!/^[ -~]*[!-~][ -~]*$/.test(text) || /[;#\\"'`]|\/\/|\/\*/.test(text)) return false;
    const closing = [], pair = { '(': ')', '[': ']', '{': '}' };
    for (const c of text)
        if (c in pair) closing.push(pair[c]);
        else if (')]}'.includes(c) && closing.pop() !== c) return false;
    return closing.length === 0;
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

const of_encodings = ['writer', 'writes', 'format', 'to_unorm', 'cleared', 'reversed'];  // what they have beside a map's properties

function complete(map) {
    must(typeof map === 'object' && map !== null, 'map must be an object',
        `${map}. Is it of a name that encodings does not have?`);
    const all = { ...defaults };
    for (const [key, value] of Object.entries(map)) {
        if (of_encodings.includes(key)) continue;
        must(key in defaults, `map must have no properties but ${Object.keys(defaults).join(', ')}`, key);
        if (key in choices) must(choices[key].includes(value), `map.${key} must be one of ${choices[key].join(', ')}`, value);
        must(typeof value === typeof defaults[key], `map.${key} must be a ${typeof defaults[key]}`, value);
        all[key] = value;
    }
    must(Array.isArray(all.needs) && all.needs.every(is_snippet), 'map.needs must be snippets', all.needs);
    return all;
}

const is_snippet = what => what !== undefined && what !== null && snippets[what.name] === what;

function as_bound(item) {
    const what = item?.what ?? item;
    if (!is_snippet(what)) throw new Error(`umbrage: text: items must be snippets, bound or not; got ${item}`);
    return item === what ? { what, suffix: '', map: defaults } : item;
}

const has_region = map => map.texture === 'atlas' || map.origin !== '';
// By default whole maps and layers are bordered; tiles, regions and faces of cubes clamp.
const is_bordered = map =>
    map.outside === '' ? !has_region(map) && !['cube', 'cube_faces'].includes(map.texture) : map.outside === 'bordered';
const gathers = map => !['cube', 'cube_faces', 'integer'].includes(map.texture);
const compares = map => map.texture === 'shadow' || map.texture === 'shadow_array';

const is_scaled = map => map.needs.some(need => need.scaled);

/** The function that a map has in place of a hook's own text; other snippets as they are. */
function chosen(s, map) {
    switch (s.role) {
        case 'compare':
            if (map.compare !== '') return hooks['compare, own'];
            return map.direction === 'forward' ? s : hooks['compare, reversed'];
        case 'cleared_depth': return map.direction === 'forward' ? s : hooks['cleared_depth, reversed'];
        case 'beyond_far_plane':
        case 'within_far_plane':
            if (is_scaled(map) || map.compare !== '') return hooks[`${s.role}, without`];
            return map.direction === 'forward' ? s : hooks[`${s.role}, reversed`];
        case 'map_covers':
        case 'fetch_depth': return is_bordered(map) ? s : hooks[`${s.role}, clamped`];
        case 'lit': return compares(map) ? hooks[is_bordered(map) ? 'lit, bordered' : 'lit, clamped'] : s;
        case 'lit_2x2':
            if (!map.gather) return s;
            if (is_bordered(map))
                return hooks[`lit_2x2, gathered ${has_region(map) ? 'in a bordered region' : 'and bordered'}`];
            return hooks[has_region(map) ? 'lit_2x2, gathered in a region' : 'lit_2x2, gathered'];
        case 'gather_lit':
            if (compares(map)) return hooks['gather_lit, compared'];
            return hooks[map.channels === 2 ? 'gather_lit, two channels' : 'gather_lit, one channel'];
        case 'lit_filtered':
            return compares(map) ? hooks[`${s.role}, ${is_bordered(map) ? 'bordered' : 'clamped'}`] : s;
        case 'lit_at':
            if (!compares(map) || has_region(map)) return s;
            return hooks[is_bordered(map) ? 'lit_at, sampled and bordered' : 'lit_at, sampled'];
        case 'depth_at':
            if (!map.gather || !gathers(map) || compares(map) || has_region(map)) return s;
            return hooks[is_bordered(map) ? 'depth_at, sampled and bordered' : 'depth_at, sampled'];
        default: return s;
    }
}

/** The text with each word replaced by replacement(word, in_comment). */
function replace_words(text, replacement) {
    let comment = false;
    return text.replace(/\w+|\/\/|\n/g, part => {
        if (part === '\n') comment = false;
        else if (part === '//') comment = true;
        else return replacement(part, comment);
        return part;
    });
}

const words_of = text => text.replace(/\/\/.*/g, '').match(/\w+/g) ?? [];

/** A list's members: what commas part, but for those in brackets. */
function members(list) {
    const all = [''];
    let open = 0;
    for (const c of list) {
        if ('([{<'.includes(c)) ++open;
        if (')]}>'.includes(c)) --open;
        if (c === ',' && open <= 0) all.push('');
        else all[all.length - 1] += c;
    }
    return all;
}

/** The names that parameters declare. */
const declared = parameters => members(parameters).map(p => words_of(p.replace(/\[.*|(?<!:):(?!:).*/, '')).at(-1));

/** A snippet's text with what a map fills in. */
function for_map(text, s, item, words, receiver_plane) {
    const { map } = item;
    const origin = map.texture === 'atlas' ? map.origin || 'origin' : map.origin;
    const border = is_scaled(map) ? '65536.0' : map.direction === 'forward' ? '1.0' : '0.0';
    const texture_size = map.texture_size || (origin === '' ? 'size' : words.size);
    const texel = map.texel || words.texel;
    if (texel.startsWith('#')) text = text.replaceAll('    return UMBRAGE_TEXEL;\n', 'UMBRAGE_TEXEL');
    if (origin === '') text = text.replace(/\n.*UMBRAGE_ORIGIN.*/, '');
    const own_map = text.match(/UMBRAGE_MAP (\w+)/)?.[1] ?? 'map';
    text = text.replaceAll(`UMBRAGE_MAP ${own_map}`, 'UMBRAGE_PARAMETERS');
    const with_sampler = (ordinary, sampler) => map.gather ? ordinary.replace(/^[^,]*/, first => first + sampler) : ordinary;
    const ordinary = with_sampler(words.arguments, words.sampler_argument);
    const parameters = map.parameters || with_sampler(words.parameters, words.sampler);
    const all_arguments = map.arguments || ordinary;
    must(members(parameters).length === members(all_arguments).length, 'map.arguments must be as many as map.parameters',
        `"${all_arguments}" for "${parameters}"`);
    const names = declared(parameters);
    if (map.parameters !== '')
        for (const word of words_of(text))
            must(word === own_map || !names.includes(word),
                `map.parameters must be named otherwise than what umbrage_${s.name} names`, word);
    // A language's own words, whose arguments the map's own parameters declare too.
    const ours = expression => {
        for (const word of words_of(expression))
            must(!words_of(ordinary).includes(word) || names.includes(word), `map.parameters must declare ${word}`, parameters);
        return expression;
    };
    if (map.arguments === '') ours(all_arguments);
    const behind_map = map.receiver_plane ? `, ${receiver_plane}` : '', plane = map.receiver_plane ? ', receiver_slope, receiver_coord' : '';
    const depth = map.depth || 'value.x';
    const list = all => replace_words(all, word => word === 'map' ? own_map : word);

    const suffixed = word => {
        const name = word.slice(8), is_it = own => own.name === name && is_of_map(own);
        return name === s.name || map.needs.some(is_it) || s.needs.some(is_it) ? word + item.suffix : word;
    };
    const of_texture = expression => replace_words(expression, word => {
        if (word.startsWith('umbrage_')) return suffixed(word);
        if (word === 'at' && origin === '') return 'texel';
        if (word !== 'UMBRAGE_TEXTURE_SIZE') return word;
        must(texture_size !== '', "map.texture_size must be given for a region that this language's sampler reads", '');
        return texture_size;
    });
    return replace_words(text, (word, comment) => {
        if (word.startsWith('umbrage_')) return suffixed(word);
        if (word === own_map && !comment) return list(all_arguments) + plane;
        switch (word) {
            case 'UMBRAGE_PARAMETERS': return list(parameters) + behind_map;
            case 'UMBRAGE_BORDER': return border;
            case 'UMBRAGE_COMPARE': return of_texture(map.compare);
            case 'UMBRAGE_DEPTH': return of_texture(map.receiver_plane
                ? `umbrage_apply_receiver_plane(${depth}, receiver_slope, receiver_coord, texel)` : depth);
            case 'UMBRAGE_ORIGIN': return origin;
            case 'UMBRAGE_TEXEL': return of_texture(map.texel === '' ? ours(texel) : texel);
            case 'UMBRAGE_LIT_TEXEL': return of_texture(ours(words.lit));
            case 'UMBRAGE_GATHER_RED': return of_texture(ours(words.gather_red));
            case 'UMBRAGE_GATHER_GREEN': return of_texture(ours(words.gather_green));
            case 'UMBRAGE_GATHER_LIT': return of_texture(ours(words.gather_lit));
            case 'UMBRAGE_UV': return of_texture('at / UMBRAGE_TEXTURE_SIZE');
            case 'UMBRAGE_SAMPLED': return of_texture(ours(words.sampled));
            case 'UMBRAGE_LIT_FILTERED': return of_texture(ours(words.lit_filtered));
            default: return word;
        }
    });
}

/** One statement, or a function's head, in lines of at most 120 columns. */
function broken(statement) {
    const margin = statement.search(/[^ ]/);
    let out = '', brackets = [];  // columns behind those that are open where the line at work begins
    for (let begin = margin; statement.length > 120;) {
        const open = [...brackets];
        let end = 0, open_at_end = [];
        for (let i = begin; i <= 120; ++i) {
            const c = statement[i];
            if (c === '(' || c === '[') open.push(i + 1);
            if ((c === ')' || c === ']') && open.length) open.pop();
            const can_end = c === ' ' && i > begin && ',=+*/&|'.includes(statement[i - 1]);
            if (!can_end || (end > 0 && open.length > open_at_end.length)) continue;
            end = i;
            open_at_end = [...open];
        }
        if (end === 0) break;
        brackets = open_at_end;
        begin = brackets.length ? brackets.at(-1) : margin + 4;
        out += statement.slice(0, end) + '\n';
        statement = ' '.repeat(begin) + statement.slice(end + 1);
    }
    return out + statement;
}

/** The text with the lines of each statement joined and broken again; a comment or a directive stays as it is. */
function laid_out(text) {
    const lines = text.split('\n'), is_code = line => /^ *(?![ #]|\/\/)./.test(line ?? '');
    const ends_statement = line => line.includes('//') || /[;{}]$/.test(line);
    if (lines.at(-1) === '') lines.pop();
    let out = '';
    while (lines.length) {
        let line = lines.shift();
        if (is_code(line)) {
            let statement = line.replace(/\/\/.*/, '');
            while (!ends_statement(line) && is_code(lines[0])) {
                line = lines.shift();
                statement += (statement.endsWith('(') ? '' : ' ') + line.replace(/\/\/.*/, '').trimStart();
            }
            line = broken(statement) + (line.match(/\/\/.*/)?.[0] ?? '');
        }
        out += line + '\n';
    }
    return out;
}

const same = (a, b) => Object.keys(defaults).every(
    key => key === 'needs' ? a.needs.length === b.needs.length && a.needs.every((need, i) => need === b.needs[i])
        : a[key] === b[key]);

/** The items, each with its map. */
function with_maps(items) {
    items = items.map(as_bound);
    const has_map = ({ what, map }) => [what, ...map.needs].some(is_of_map);
    for (const item of items)
        if (has_map(item) && items.some(other => other.suffix === item.suffix && has_map(other) && !same(other.map, item.map)))
            throw new Error(`umbrage: text: name must be another for each map; got "${item.suffix.slice(1)}" for two`);
    return items;
}

/** What a text of the items holds, in order and each once: calls use(snippet, item, guard, whether a map fills it in). */
function for_each_part(language, items, use) {
    const done = new Map();
    const add = (asked, item, of_map) => {
        const s = chosen(asked, item.map);
        for (const need of s.needs) add(need, item, of_map);
        if (is_of_map(s) !== of_map) return;
        const suffix = of_map ? item.suffix : '', part = { what: s.name, suffix };
        const guard = `UMBRAGE_HAS_${s.name}${suffix}`.toUpperCase(), before = done.get(guard);
        if (before?.what === s.name && before.suffix === suffix) return;
        if (before)
            throw new Error('umbrage: text: names must keep functions apart, in capitals too; got '
                + `umbrage_${before.what}${before.suffix} and umbrage_${s.name}${suffix}`);
        done.set(guard, part);
        use(s, item, guard, of_map);
    };
    for (const of_map of [false, true])
        for (const item of items) {
            for (const need of item.map.needs) add(need, item, of_map);
            for (const need of language.textures[item.map.texture].needs) add(snippets[need], item, of_map);
            add(item.what, item, of_map);
        }
}

/** The worst promise of what a text of the items holds. */
function worst_promise(language, items) {
    const all = { exactness: 'a', operations: 0, within: 0, as_written: false };
    for_each_part(language, items, s => {
        for (const key in all) all[key] = s[key] > all[key] ? s[key] : all[key];
    });
    return all;
}

function bound_in_words(s) {
    if (s.within === 0) return `within ${s.operations} x 2^-23 x S of the exact result.`;
    return `within 1/${1 / s.within} of C++`
        + (s.as_written ? ' as written. Reordered: no bound, but a visibility is in [0, 1].' : '.');
}

/** Lines of comment that bound what each function returns; none for a text of tier A. */
function bounds_note(language, items) {
    const lines = new Set();
    for (const item of items) {
        const worst = worst_promise(language, with_maps([item]));
        if (worst.exactness !== 'a') lines.add(
            `// ${item.what.name}${item.suffix}, tier ${worst.exactness.toUpperCase()}: ${bound_in_words(worst)}\n`);
    }
    if ([...lines].some(line => line.includes(' x S ')))
        lines.add('// S is the formula with the magnitude of every value and a plus for every minus.\n'
            + '// Inside the bound, a comparison or floor may fall on either side.\n');
    const may_reorder = lines.size && language.may_reorder;
    return (may_reorder ? `// ${may_reorder} lets compilers fuse or reorder sums.\n` : '') + [...lines].join('');
}

/** The snippets and all they need, each once. */
function compose(language, items) {
    items = with_maps(items);
    const names = [...new Set(items.map(item => item.what.name + item.suffix))];
    let text = `// umbrage 0.1.0, MIT License${names.length ? ': ' : ''}${names.join(', ')}\n`
        + bounds_note(language, items) + language.prelude;
    for_each_part(language, items, (s, item, guard, of_map) => {
        const body = language.texts[s.id];
        if (language.preprocessor) text += `\n#ifndef ${guard}\n#define ${guard}`;
        text += of_map ? laid_out(for_map(body, s, item, language.textures[item.map.texture],
            language.receiver_plane)) : body;
        if (language.preprocessor) text += '#endif\n';
    });
    return text;
}

/** The worst tier of a text: of the snippets, of all they need, and of the hooks of the maps they are bound to. */
function exactness(items) { return worst_promise(languages.glsl, with_maps(items)).exactness; }

const es3 = ['300 es', '310 es', '320 es', '330', '430', '450', '460'];
const has_gathers = ['310 es', '320 es', '430', '450', '460'];

/** True when the snippet, or the snippet bound to its map, compiles in a dialect of GLSL. */
function supports(item, version) {
    const { what, map } = as_bound(item);
    const old_enough = s => s.lowest === '100' || es3.includes(version);
    if (!old_enough(what)) return false;
    if (!map.needs.every(old_enough)) return false;
    if (map.gather) return has_gathers.includes(version);
    if (has_region(map) && map.texture_size === '' && ['100', '110', '120'].includes(version)) return false;
    return ['texture_2d', 'depth', 'atlas', 'cube', 'cube_faces'].includes(map.texture) || es3.includes(version);
}

/** The text with what __VERSION__ decides decided. */
function resolved(text, number) {
    const open = [];  // 'kept': directive and all
    let out = '';
    for (const line of text.match(/.*\n/g)) {
        let shown = true;
        const least = line.match(/^#if __VERSION__ >= (\d+)/)?.[1];
        if (least) {
            open.push(number >= least ? 'taken' : 'left out');
            shown = false;
        } else if (line.startsWith('#if')) open.push('kept');
        else if (line.startsWith('#else') && open.at(-1) !== 'kept') {
            open.push(open.pop() === 'taken' ? 'left out' : 'taken');
            shown = false;
        } else if (line.startsWith('#endif')) shown = open.pop() === 'kept';
        if (shown && !open.includes('left out')) out += line;
    }
    return out;
}

/** A GLSL text of the snippets and all they need, to paste into any shader, or into one of the version. */
function text(items, version) {
    if (version === undefined) return compose(languages.glsl, items);
    if (!versions.includes(version)) throw new Error(`umbrage: text: version must be one of versions; got ${version}`);
    for (const item of items)
        if (!supports(item, version)) {
            const { what, suffix } = as_bound(item);
            throw new Error(`umbrage: text: version must be one that has ${what.name}${suffix}; got ${version}`);
        }
    const number = parseInt(version), es = version === '100' || version.endsWith('es'), has_precise = number >= (es ? 320 : 400);
    const prelude = `\n#ifndef UMBRAGE_HIGHP\n#define UMBRAGE_HIGHP${es ? ' highp' : ''}\n#endif\n`
        + `#ifndef UMBRAGE_PRECISE\n#define UMBRAGE_PRECISE${has_precise ? ' precise' : ''}\n#endif\n`;
    return resolved(compose({ ...languages.glsl, prelude, may_reorder: has_precise ? '' : `GLSL ${version}` }, items), number);
}

/** The beginning of a GLSL shader: #version, preamble, the snippets and all they need. */
function source(version, items, preamble = '') {
    if (preamble !== '' && !preamble.endsWith('\n')) preamble += '\n';
    return `#version ${version}\n${preamble}${text(items, version)}`;
}

const in_language = name => ({ text: name === 'glsl' ? text : items => compose(languages[name], items) });

const versions = ["100", "110", "120", "130", "150", "300 es", "310 es", "320 es", "330", "430", "450", "460"];

const languages = {
    glsl: {
        prelude: "\n#ifndef UMBRAGE_HIGHP\n#ifdef GL_ES\n#define UMBRAGE_HIGHP highp\n#else\n#define UMBRAGE_HIGHP\n#endif\n#endif\n#ifndef UMBRAGE_PRECISE\n#if (defined(GL_ES) && __VERSION__ >= 320) || (!defined(GL_ES) && __VERSION__ >= 400)\n#define UMBRAGE_PRECISE precise\n#else\n#define UMBRAGE_PRECISE\n#endif\n#endif\n",
        receiver_plane: "UMBRAGE_HIGHP vec2 receiver_slope, UMBRAGE_HIGHP vec2 receiver_coord",
        may_reorder: "GLSL below 400 and 320 es",
        preprocessor: true,
        textures: {
            texture_2d: { parameters: "UMBRAGE_HIGHP sampler2D map", arguments: "map", texel: "#if __VERSION__ >= 130\n    return texelFetch(map, ivec2(at), 0);\n#else\n    return texture2D(map, (at + 0.5) / UMBRAGE_TEXTURE_SIZE);\n#endif\n", sampled: "textureLod(map, uv, 0.0)", lit: "", gather_red: "textureGather(map, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, 0)", gather_green: "textureGather(map, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, 1)", gather_lit: "", lit_filtered: "", size: "vec2(textureSize(map, 0))", sampler: "", sampler_argument: "", needs: [] },
            atlas: { parameters: "UMBRAGE_HIGHP sampler2D map, UMBRAGE_HIGHP vec2 origin", arguments: "map, origin", texel: "#if __VERSION__ >= 130\n    return texelFetch(map, ivec2(at), 0);\n#else\n    return texture2D(map, (at + 0.5) / UMBRAGE_TEXTURE_SIZE);\n#endif\n", sampled: "textureLod(map, uv, 0.0)", lit: "", gather_red: "textureGather(map, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, 0)", gather_green: "textureGather(map, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, 1)", gather_lit: "", lit_filtered: "", size: "vec2(textureSize(map, 0))", sampler: "", sampler_argument: "", needs: [] },
            array: { parameters: "UMBRAGE_HIGHP sampler2DArray map, UMBRAGE_HIGHP float layer", arguments: "map, layer", texel: "texelFetch(map, ivec3(ivec2(at), int(layer)), 0)", sampled: "textureLod(map, vec3(uv, layer), 0.0)", lit: "", gather_red: "textureGather(map, vec3((at + 1.0) / UMBRAGE_TEXTURE_SIZE, layer), 0)", gather_green: "textureGather(map, vec3((at + 1.0) / UMBRAGE_TEXTURE_SIZE, layer), 1)", gather_lit: "", lit_filtered: "", size: "vec2(textureSize(map, 0))", sampler: "", sampler_argument: "", needs: [] },
            cube: { parameters: "UMBRAGE_HIGHP samplerCube map, UMBRAGE_HIGHP float face", arguments: "map, face", texel: "#if __VERSION__ >= 130\n    return textureLod(map, umbrage_cube_direction(face, (at + 0.5) / UMBRAGE_TEXTURE_SIZE), 0.0);\n#else\n    return textureCube(map, umbrage_cube_direction(face, (at + 0.5) / UMBRAGE_TEXTURE_SIZE));\n#endif\n", sampled: "", lit: "", gather_red: "", gather_green: "", gather_lit: "", lit_filtered: "", size: "vec2(textureSize(map, 0))", sampler: "", sampler_argument: "", needs: ["cube_direction"] },
            cube_faces: { parameters: "UMBRAGE_HIGHP samplerCube map", arguments: "map", texel: "#if __VERSION__ >= 130\n    return textureLod(map, umbrage_cube_atlas_direction(at, size.y * 0.5), 0.0);\n#else\n    return textureCube(map, umbrage_cube_atlas_direction(at, size.y * 0.5));\n#endif\n", sampled: "", lit: "", gather_red: "", gather_green: "", gather_lit: "", lit_filtered: "", size: "vec2(textureSize(map, 0))", sampler: "", sampler_argument: "", needs: ["cube_atlas_direction"] },
            integer: { parameters: "UMBRAGE_HIGHP usampler2D map", arguments: "map", texel: "vec4(texelFetch(map, ivec2(at), 0))", sampled: "", lit: "", gather_red: "", gather_green: "", gather_lit: "", lit_filtered: "", size: "vec2(textureSize(map, 0))", sampler: "", sampler_argument: "", needs: [] },
            depth: { parameters: "UMBRAGE_HIGHP sampler2D map", arguments: "map", texel: "#if __VERSION__ >= 130\n    return texelFetch(map, ivec2(at), 0);\n#else\n    return texture2D(map, (at + 0.5) / UMBRAGE_TEXTURE_SIZE);\n#endif\n", sampled: "textureLod(map, uv, 0.0)", lit: "", gather_red: "textureGather(map, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, 0)", gather_green: "textureGather(map, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, 1)", gather_lit: "", lit_filtered: "", size: "vec2(textureSize(map, 0))", sampler: "", sampler_argument: "", needs: [] },
            depth_array: { parameters: "UMBRAGE_HIGHP sampler2DArray map, UMBRAGE_HIGHP float layer", arguments: "map, layer", texel: "texelFetch(map, ivec3(ivec2(at), int(layer)), 0)", sampled: "textureLod(map, vec3(uv, layer), 0.0)", lit: "", gather_red: "textureGather(map, vec3((at + 1.0) / UMBRAGE_TEXTURE_SIZE, layer), 0)", gather_green: "textureGather(map, vec3((at + 1.0) / UMBRAGE_TEXTURE_SIZE, layer), 1)", gather_lit: "", lit_filtered: "", size: "vec2(textureSize(map, 0))", sampler: "", sampler_argument: "", needs: [] },
            shadow: { parameters: "UMBRAGE_HIGHP sampler2DShadow map", arguments: "map", texel: "", sampled: "", lit: "textureLod(map, vec3((at + 0.5) / UMBRAGE_TEXTURE_SIZE, receiver), 0.0)", gather_red: "", gather_green: "", gather_lit: "textureGather(map, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, receiver)", lit_filtered: "textureLod(map, vec3(uv, receiver), 0.0)", size: "vec2(textureSize(map, 0))", sampler: "", sampler_argument: "", needs: [] },
            shadow_array: { parameters: "UMBRAGE_HIGHP sampler2DArrayShadow map, UMBRAGE_HIGHP float layer", arguments: "map, layer", texel: "", sampled: "", lit: "textureGrad(map, vec4((at + 0.5) / UMBRAGE_TEXTURE_SIZE, layer, receiver), vec2(0.0, 0.0), vec2(0.0, 0.0))", gather_red: "", gather_green: "", gather_lit: "textureGather(map, vec3((at + 1.0) / UMBRAGE_TEXTURE_SIZE, layer), receiver)", lit_filtered: "textureGrad(map, vec4(uv, layer, receiver), vec2(0.0, 0.0), vec2(0.0, 0.0))", size: "vec2(textureSize(map, 0))", sampler: "", sampler_argument: "", needs: [] },
        },
        texts: {
            "shadow_coordinate": `
// umbrage_shadow_coordinate: texture matrix times world position; (x w, y w, depth w, w), x and y in texels
UMBRAGE_HIGHP vec4 umbrage_shadow_coordinate(UMBRAGE_HIGHP mat4 m, UMBRAGE_HIGHP vec3 world) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec4 c = m[3] + m[0] * world.x + m[1] * world.y + m[2] * world.z;
    return c;
}
`,
            "tap_coordinate": `
// umbrage_tap_coordinate: coordinate, before the division by w, moved by offset texels
UMBRAGE_HIGHP vec4 umbrage_tap_coordinate(UMBRAGE_HIGHP vec4 coordinate, UMBRAGE_HIGHP vec2 offset) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 moved = vec2(coordinate.x, coordinate.y) + offset * coordinate.w;
    return vec4(moved.x, moved.y, coordinate.z, coordinate.w);
}
`,
            "project_coordinate": `
// umbrage_project_coordinate: (x, y) in texels and depth; for w <= 0.0 a coordinate that every filter takes as lit
UMBRAGE_HIGHP vec3 umbrage_project_coordinate(UMBRAGE_HIGHP vec4 coordinate) {
    UMBRAGE_HIGHP vec3 p = vec3(coordinate.x / coordinate.w, coordinate.y / coordinate.w, coordinate.z / coordinate.w);
    return coordinate.w > 0.0 ? p : vec3(65536.0, 65536.0, 0.0);
}
`,
            "cascade_by_depth": `
// umbrage_cascade_by_depth: the cascade that a distance along the camera's axis falls into, 0.0 to 3.0
//   ends  of the first three cascades, ascending
UMBRAGE_HIGHP float umbrage_cascade_by_depth(UMBRAGE_HIGHP float depth, UMBRAGE_HIGHP vec3 ends) {
    UMBRAGE_HIGHP int reached = int(depth >= ends.x) + int(depth >= ends.y) + int(depth >= ends.z);
    return float(reached);
}
`,
            "cascade_column": `
// umbrage_cascade_column: a column of a matrix by its number, 0.0 to 3.0, for languages without dynamic indices
UMBRAGE_HIGHP vec4 umbrage_cascade_column(UMBRAGE_HIGHP mat4 columns, UMBRAGE_HIGHP float number) {
    UMBRAGE_HIGHP vec4 low = number < 0.5 ? columns[0] : columns[1];
    UMBRAGE_HIGHP vec4 high = number < 2.5 ? columns[2] : columns[3];
    return number < 1.5 ? low : high;
}
`,
            "cascade_column_8": `
// umbrage_cascade_column_8: a column of two matrices by its number, 0.0 to 7.0
UMBRAGE_HIGHP vec4 umbrage_cascade_column_8(UMBRAGE_HIGHP mat4 nearer, UMBRAGE_HIGHP mat4 farther,
                                            UMBRAGE_HIGHP float number) {
    UMBRAGE_HIGHP vec4 low = umbrage_cascade_column(nearer, number);
    UMBRAGE_HIGHP vec4 high = umbrage_cascade_column(farther, number - 4.0);
    return number < 3.5 ? low : high;
}
`,
            "cascade_coordinate": `
// umbrage_cascade_coordinate: a point, rotated into the light's directions, in a cascade's map: texels and depth
UMBRAGE_HIGHP vec3 umbrage_cascade_coordinate(UMBRAGE_HIGHP vec3 light, UMBRAGE_HIGHP vec4 scale,
                                              UMBRAGE_HIGHP vec4 offset) {
    UMBRAGE_HIGHP vec3 start = vec3(offset.x, offset.y, offset.z);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec3 at = light * vec3(scale.x, scale.y, scale.z) + start;
    return at;
}
`,
            "inside_cascade": `
// umbrage_inside_cascade: whether a filter of some reach around a coordinate stays inside a map of size texels
bool umbrage_inside_cascade(UMBRAGE_HIGHP vec3 coordinate, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP float reach) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 end = size - reach;
    // y doubled on purpose: Mesa makes min(x, y) >= reach of two comparisons with one limit, which loses a NaN
    bool in_x = coordinate.x >= reach && coordinate.x <= end.x;
    bool in_y = coordinate.y * 2.0 >= reach * 2.0 && coordinate.y * 2.0 <= end.y * 2.0;
    return in_x && in_y && coordinate.z >= 0.0 && coordinate.z <= 1.0;
}
`,
            "cascade_by_projection": `
// umbrage_cascade_by_projection: (texels, texels, depth, number) in the first of four cascades that holds a point and
//   its filter; where none does, number 4.0 and a coordinate that every filter takes as lit
//   light            the point, rotated into the light's directions
//   scales, offsets  of the cascades;   size  of each map;   reach  of the filter, in texels
UMBRAGE_HIGHP vec4 umbrage_cascade_by_projection(UMBRAGE_HIGHP vec3 light, UMBRAGE_HIGHP mat4 scales,
                                                 UMBRAGE_HIGHP mat4 offsets, UMBRAGE_HIGHP vec2 size,
                                                 UMBRAGE_HIGHP float reach) {
    UMBRAGE_HIGHP vec3 a = umbrage_cascade_coordinate(light, scales[0], offsets[0]);
    UMBRAGE_HIGHP vec3 b = umbrage_cascade_coordinate(light, scales[1], offsets[1]);
    UMBRAGE_HIGHP vec3 c = umbrage_cascade_coordinate(light, scales[2], offsets[2]);
    UMBRAGE_HIGHP vec3 d = umbrage_cascade_coordinate(light, scales[3], offsets[3]);
    UMBRAGE_HIGHP vec4 found = vec4(65536.0, 65536.0, 0.0, 4.0);
    found = umbrage_inside_cascade(d, size, reach) ? vec4(d, 3.0) : found;
    found = umbrage_inside_cascade(c, size, reach) ? vec4(c, 2.0) : found;
    found = umbrage_inside_cascade(b, size, reach) ? vec4(b, 1.0) : found;
    return umbrage_inside_cascade(a, size, reach) ? vec4(a, 0.0) : found;
}
`,
            "cascade_by_projection_8": `
// umbrage_cascade_by_projection_8: umbrage_cascade_by_projection of eight cascades, four and four; number 8.0 for none
UMBRAGE_HIGHP vec4 umbrage_cascade_by_projection_8(UMBRAGE_HIGHP vec3 light, UMBRAGE_HIGHP mat4 scales,
                                                   UMBRAGE_HIGHP mat4 offsets, UMBRAGE_HIGHP mat4 farther_scales,
                                                   UMBRAGE_HIGHP mat4 farther_offsets, UMBRAGE_HIGHP vec2 size,
                                                   UMBRAGE_HIGHP float reach) {
    UMBRAGE_HIGHP vec4 nearer = umbrage_cascade_by_projection(light, scales, offsets, size, reach);
    UMBRAGE_HIGHP vec4 farther = umbrage_cascade_by_projection(light, farther_scales, farther_offsets, size, reach);
    return nearer.w < 3.5 ? nearer : vec4(farther.x, farther.y, farther.z, farther.w + 4.0);
}
`,
            "cascade_tile": `
// umbrage_cascade_tile: first texel of a cascade, a whole number, in an atlas of tiles of size texels, two a row
UMBRAGE_HIGHP vec2 umbrage_cascade_tile(UMBRAGE_HIGHP float number, UMBRAGE_HIGHP vec2 size) {
    UMBRAGE_HIGHP float row = floor(number * 0.5);
    return vec2(number - row * 2.0, row) * size;
}
`,
            "cascade_weight": `
// umbrage_cascade_weight: v taken down to steps of 1/256, from 0.0 to 1.0; NaN is 0.0
UMBRAGE_HIGHP float umbrage_cascade_weight(UMBRAGE_HIGHP float v) {
    UMBRAGE_HIGHP float steps = v > 0.0 && v < 1.0 ? floor(v * 256.0) : (v >= 1.0 ? 256.0 : 0.0);
    return steps * (1.0 / 256.0);
}
`,
            "cascade_fade": `
// umbrage_cascade_fade: weight of the next cascade at a distance along the camera's axis; depth * scale + offset
UMBRAGE_HIGHP float umbrage_cascade_fade(UMBRAGE_HIGHP float depth, UMBRAGE_HIGHP float scale,
                                         UMBRAGE_HIGHP float offset) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float v = depth * scale + offset;
    return umbrage_cascade_weight(v);
}
`,
            "cascade_border_fade": `
// umbrage_cascade_border_fade: weight of the next cascade, 1.0 from reach texels off the border of a map on
//   coordinate, size  in texels;   per_texel  weight a texel, 1.0 / width of the band along the border
UMBRAGE_HIGHP float umbrage_cascade_border_fade(UMBRAGE_HIGHP vec2 coordinate, UMBRAGE_HIGHP vec2 size,
                                                UMBRAGE_HIGHP float reach, UMBRAGE_HIGHP float per_texel) {
    UMBRAGE_HIGHP vec2 half_size = size * 0.5;
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 beyond = abs(coordinate - half_size) - (half_size - reach);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 v = beyond * per_texel + 1.0;
    UMBRAGE_HIGHP float x = umbrage_cascade_weight(v.x);
    UMBRAGE_HIGHP float y = umbrage_cascade_weight(v.y);
    return x > y ? x : y;
}
`,
            "blend_cascades": `
// umbrage_blend_cascades: visibilities of a cascade and of the next one, which counts by weight, mixed
UMBRAGE_HIGHP float umbrage_blend_cascades(UMBRAGE_HIGHP float nearer, UMBRAGE_HIGHP float farther,
                                           UMBRAGE_HIGHP float weight) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float sum = nearer + (farther - nearer) * weight;
    return weight < 1.0 ? sum : farther;
}
`,
            "inside_texel_space": `
// umbrage_inside_texel_space: coordinates in texels that a filter can take; it takes all others, NaN included, as lit
bool umbrage_inside_texel_space(UMBRAGE_HIGHP vec2 coord) {
    // two limits on purpose: Mesa makes max(x, y) < limit of one, which loses a NaN
    return abs(coord.x) < 32768.0 && abs(coord.y) * 2.0 < 65536.0;
}
`,
            "dither_threshold": `
// umbrage_dither_threshold: one of 16 thresholds, 1/32 to 31/32, for a position in pixels; each once in 4 x 4 pixels
UMBRAGE_HIGHP float umbrage_dither_threshold(UMBRAGE_HIGHP vec2 pixel) {
    UMBRAGE_HIGHP vec2 whole = umbrage_inside_texel_space(pixel) ? floor(pixel) : vec2(0.0, 0.0);
    UMBRAGE_HIGHP vec2 high = floor(whole * 0.5);
    UMBRAGE_HIGHP vec2 above = floor(whole * 0.25);
    UMBRAGE_HIGHP vec2 b0 = whole - high * 2.0;
    UMBRAGE_HIGHP vec2 b1 = high - above * 2.0;
    UMBRAGE_HIGHP float m = abs(b0.x - b0.y) * 8.0 + b0.y * 4.0 + abs(b1.x - b1.y) * 2.0 + b1.y;
    return (m + 0.5) * (1.0 / 16.0);
}
`,
            "dithered_cascade": `
// umbrage_dithered_cascade: number of a cascade, or of the next one where its weight is above the pixel's threshold
UMBRAGE_HIGHP float umbrage_dithered_cascade(UMBRAGE_HIGHP float number, UMBRAGE_HIGHP float weight,
                                             UMBRAGE_HIGHP float threshold) {
    return number + (weight > threshold ? 1.0 : 0.0);
}
`,
            "cube_face": `
// umbrage_cube_face: the face that a direction meets, 0.0 to 5.0: +x, -x, +y, -y, +z, -z
UMBRAGE_HIGHP float umbrage_cube_face(UMBRAGE_HIGHP vec3 direction) {
    UMBRAGE_HIGHP vec3 m = abs(direction);
    UMBRAGE_HIGHP float x = direction.x < 0.0 ? 1.0 : 0.0;
    UMBRAGE_HIGHP float y = direction.y < 0.0 ? 3.0 : 2.0;
    UMBRAGE_HIGHP float z = direction.z < 0.0 ? 5.0 : 4.0;
    // not m.x >= m.y && m.x >= m.z, of which Mesa makes one with max(m.y, m.z), which loses a NaN
    return m.x >= m.y ? (m.x >= m.z ? x : z) : (m.y >= m.z ? y : z);
}
`,
            "cube_view_z": `
// umbrage_cube_view_z: the greatest component's magnitude, of which per-face depths are made
UMBRAGE_HIGHP float umbrage_cube_view_z(UMBRAGE_HIGHP vec3 direction) {
    UMBRAGE_HIGHP float face = umbrage_cube_face(direction);
    UMBRAGE_HIGHP float side = face < 1.5 ? direction.x : direction.y;
    return abs(face > 3.5 ? direction.z : side);
}
`,
            "cube_plane": `
// umbrage_cube_plane: (sc, tc, face) of a direction: its components to the sides of the face that it meets
UMBRAGE_HIGHP vec3 umbrage_cube_plane(UMBRAGE_HIGHP vec3 direction) {
    UMBRAGE_HIGHP float face = umbrage_cube_face(direction);
    UMBRAGE_HIGHP vec3 x = vec3(face < 0.5 ? -direction.z : direction.z, -direction.y, face);
    UMBRAGE_HIGHP vec3 y = vec3(direction.x, face < 2.5 ? direction.z : -direction.z, face);
    UMBRAGE_HIGHP vec3 z = vec3(face < 4.5 ? direction.x : -direction.x, -direction.y, face);
    return face < 1.5 ? x : (face < 3.5 ? y : z);
}
`,
            "cube_point": `
// umbrage_cube_point: from (sc, tc, distance along its axis) of a face, 0.0 to 5.0
UMBRAGE_HIGHP vec3 umbrage_cube_point(UMBRAGE_HIGHP float face, UMBRAGE_HIGHP vec3 p) {
    UMBRAGE_HIGHP vec3 x = face < 0.5 ? vec3(p.z, -p.y, -p.x) : vec3(-p.z, -p.y, p.x);
    UMBRAGE_HIGHP vec3 y = face < 2.5 ? vec3(p.x, p.z, p.y) : vec3(p.x, -p.z, -p.y);
    UMBRAGE_HIGHP vec3 z = face < 4.5 ? vec3(p.x, -p.y, p.z) : vec3(-p.x, -p.y, -p.z);
    return face < 1.5 ? x : (face < 3.5 ? y : z);
}
`,
            "cube_face_point": `
// umbrage_cube_face_point: (sc, tc, distance along its axis) in a face, 0.0 to 5.0, of a point from the cube's middle
UMBRAGE_HIGHP vec3 umbrage_cube_face_point(UMBRAGE_HIGHP float face, UMBRAGE_HIGHP vec3 p) {
    UMBRAGE_HIGHP vec3 x = face < 0.5 ? vec3(-p.z, -p.y, p.x) : vec3(p.z, -p.y, -p.x);
    UMBRAGE_HIGHP vec3 y = face < 2.5 ? vec3(p.x, p.z, p.y) : vec3(p.x, -p.z, -p.y);
    UMBRAGE_HIGHP vec3 z = face < 4.5 ? vec3(p.x, -p.y, p.z) : vec3(-p.x, -p.y, -p.z);
    return face < 1.5 ? x : (face < 3.5 ? y : z);
}
`,
            "cube_coordinate": `
// umbrage_cube_coordinate: (s, t, face) of a direction; s and t go from 0.0 to 1.0 over the face
UMBRAGE_HIGHP vec3 umbrage_cube_coordinate(UMBRAGE_HIGHP vec3 direction) {
    UMBRAGE_HIGHP vec3 p = umbrage_cube_plane(direction);
    UMBRAGE_HIGHP float m = umbrage_cube_view_z(direction);
    return vec3((p.x + m) / (m + m), (p.y + m) / (m + m), p.z);
}
`,
            "cube_direction": `
// umbrage_cube_direction: from a cube's middle to a point of a face, 0.0 to 5.0; st goes from 0.0 to 1.0 over the face
UMBRAGE_HIGHP vec3 umbrage_cube_direction(UMBRAGE_HIGHP float face, UMBRAGE_HIGHP vec2 st) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 uv = st * 2.0 - 1.0;  // an exact product: fused or not, it rounds once
    return umbrage_cube_point(face, vec3(uv, 1.0));
}
`,
            "cube_neighbor": `
// umbrage_cube_neighbor: (s, t, face) of a texel that may lie beyond an edge of its face; face -1.0 beyond a corner
//   texel  (s, t, face), whole numbers;   size  of a face, in texels
UMBRAGE_HIGHP vec3 umbrage_cube_neighbor(UMBRAGE_HIGHP vec3 texel, UMBRAGE_HIGHP float size) {
    UMBRAGE_HIGHP vec2 uv = vec2(texel.x, texel.y) * 2.0 + (1.0 - size);
    bool beyond_u = abs(uv.x) > size;
    bool beyond_v = abs(uv.y) > size;
    UMBRAGE_HIGHP float m = beyond_u || beyond_v ? size - 1.0 : size;
    UMBRAGE_HIGHP vec3 p = umbrage_cube_plane(umbrage_cube_point(texel.z, vec3(uv, m)));
    UMBRAGE_HIGHP vec2 inside = (vec2(p.x, p.y) + (size - 1.0)) * 0.5;
    return beyond_u && beyond_v ? vec3(0.0, 0.0, -1.0) : vec3(inside, p.z);
}
`,
            "cube_tile": `
// umbrage_cube_tile: first texel of a face, 0.0 to 5.0, in an atlas of 3 x 2 tiles of size texels
UMBRAGE_HIGHP vec2 umbrage_cube_tile(UMBRAGE_HIGHP float face, UMBRAGE_HIGHP float size) {
    UMBRAGE_HIGHP float row = face < 2.5 ? 0.0 : 1.0;
    return vec2((face - row * 3.0) * size, row * size);
}
`,
            "cube_atlas_texel": `
// umbrage_cube_atlas_texel: (s, t, face) of a texel of an atlas of 3 x 2 tiles of size texels; whole numbers
UMBRAGE_HIGHP vec3 umbrage_cube_atlas_texel(UMBRAGE_HIGHP vec2 texel, UMBRAGE_HIGHP float size) {
    UMBRAGE_HIGHP float column = texel.x < size ? 0.0 : (texel.x < size * 2.0 ? 1.0 : 2.0);
    UMBRAGE_HIGHP float row = texel.y < size ? 0.0 : 1.0;
    return vec3(texel - vec2(column, row) * size, column + row * 3.0);
}
`,
            "cube_atlas_direction": `
// umbrage_cube_atlas_direction: from a cube's middle to that of a texel of an atlas of 3 x 2 tiles of size texels
UMBRAGE_HIGHP vec3 umbrage_cube_atlas_direction(UMBRAGE_HIGHP vec2 texel, UMBRAGE_HIGHP float size) {
    UMBRAGE_HIGHP vec3 part = umbrage_cube_atlas_texel(texel, size);
    UMBRAGE_HIGHP vec2 uv = vec2(part.x, part.y) * 2.0 + (1.0 - size);
    return umbrage_cube_point(part.z, vec3(uv, size));
}
`,
            "dual_paraboloid_coordinate": `
// umbrage_dual_paraboloid_coordinate: (s, t, map) of a direction: 0.0 to 1.0 over the map's square, map 0.0 or 1.0
UMBRAGE_HIGHP vec3 umbrage_dual_paraboloid_coordinate(UMBRAGE_HIGHP vec3 direction) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float square =
        direction.x * direction.x + direction.y * direction.y + direction.z * direction.z;
    bool behind = direction.z < 0.0;
    UMBRAGE_HIGHP float m = sqrt(square) + (behind ? -direction.z : direction.z);
    UMBRAGE_HIGHP float x = behind ? direction.x : -direction.x;
    return vec3((x + m) / (m + m), (direction.y + m) / (m + m), behind ? 1.0 : 0.0);
}
`,
            "dual_paraboloid_position": `
// umbrage_dual_paraboloid_position: (x w, y w, distance w, w) of a vertex, for the depth pass' projection
//   direction  from the light to the vertex;   map  0.0 or 1.0
UMBRAGE_HIGHP vec4 umbrage_dual_paraboloid_position(UMBRAGE_HIGHP vec3 direction, UMBRAGE_HIGHP float map) {
    bool behind = map > 0.5;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float square =
        direction.x * direction.x + direction.y * direction.y + direction.z * direction.z;
    UMBRAGE_HIGHP float distance_to = sqrt(square);
    UMBRAGE_HIGHP float w = distance_to + (behind ? -direction.z : direction.z);
    return vec4(behind ? direction.x : -direction.x, direction.y, distance_to * w, w);
}
`,
            "tetrahedron_face": `
// umbrage_tetrahedron_face: the face that a direction meets, 0.0 to 3.0: down and +z, down and -z, up and +x, up and -x
UMBRAGE_HIGHP float umbrage_tetrahedron_face(UMBRAGE_HIGHP vec3 direction) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float beside = abs(direction.z) - abs(direction.x);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float up = direction.y * 1.414213562;
    UMBRAGE_HIGHP float z = direction.z < 0.0 ? 1.0 : 0.0;
    UMBRAGE_HIGHP float x = direction.x < 0.0 ? 3.0 : 2.0;
    return beside >= up ? z : x;
}
`,
            "tetrahedron_face_point": `
// umbrage_tetrahedron_face_point: (along the base, up, away) of a direction in the axes of a face, 0.0 to 3.0
UMBRAGE_HIGHP vec3 umbrage_tetrahedron_face_point(UMBRAGE_HIGHP float face, UMBRAGE_HIGHP vec3 d) {
    UMBRAGE_HIGHP vec3 z = face < 0.5 ? vec3(-d.x, d.y, d.z) : vec3(d.x, d.y, -d.z);
    UMBRAGE_HIGHP vec3 x = face < 2.5 ? vec3(-d.z, -d.y, d.x) : vec3(d.z, -d.y, -d.x);
    return face < 1.5 ? z : x;
}
`,
            "tetrahedron_plane": `
// umbrage_tetrahedron_plane: (along the base, up, away) of a direction in the axes of the face that it meets
UMBRAGE_HIGHP vec3 umbrage_tetrahedron_plane(UMBRAGE_HIGHP vec3 direction) {
    return umbrage_tetrahedron_face_point(umbrage_tetrahedron_face(direction), direction);
}
`,
            "tetrahedron_view_z": `
// umbrage_tetrahedron_view_z: distance along the face's normal, of which per-face depths are made
UMBRAGE_HIGHP float umbrage_tetrahedron_view_z(UMBRAGE_HIGHP vec3 direction) {
    UMBRAGE_HIGHP vec3 p = umbrage_tetrahedron_plane(direction);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float z = p.z * 0.816496581 + p.y * -0.577350269;
    return z;
}
`,
            "tetrahedron_coordinate": `
// umbrage_tetrahedron_coordinate: (s, t, face) of a direction: -1.0 to 1.0 along the base, 0.0 at it to 1.0 at the apex
UMBRAGE_HIGHP vec3 umbrage_tetrahedron_coordinate(UMBRAGE_HIGHP vec3 direction) {
    UMBRAGE_HIGHP vec3 p = umbrage_tetrahedron_plane(direction);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float d = p.z * 2.0 + p.y * -1.414213562;
    return vec3(p.x / d, p.z / d, umbrage_tetrahedron_face(direction));
}
`,
            "tetrahedron_turned": `
// umbrage_tetrahedron_turned: a vector of face 0's side of the map on that of a face, 0.0 to 3.0
UMBRAGE_HIGHP vec2 umbrage_tetrahedron_turned(UMBRAGE_HIGHP float face, UMBRAGE_HIGHP vec2 v) {
    UMBRAGE_HIGHP vec2 z = face < 0.5 ? v : vec2(-v.x, -v.y);
    UMBRAGE_HIGHP vec2 x = face < 2.5 ? vec2(-v.y, v.x) : vec2(v.y, -v.x);
    return face < 1.5 ? z : x;
}
`,
            "tetrahedron_texel": `
// umbrage_tetrahedron_texel: texels of a square map, from (s, t, face) on a tetrahedron
//   size  of the map, in texels;   border  along the sides of each triangle, in texels
UMBRAGE_HIGHP vec2 umbrage_tetrahedron_texel(UMBRAGE_HIGHP vec3 at, UMBRAGE_HIGHP float size,
                                             UMBRAGE_HIGHP float border) {
    UMBRAGE_HIGHP float half_size = size * 0.5;
    UMBRAGE_HIGHP float scale = half_size - border * 3.0;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float x = at.x * scale;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float y = at.y * scale + (border - half_size);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 texel = umbrage_tetrahedron_turned(at.z, vec2(x, y)) + half_size;
    return texel;
}
`,
            "tetrahedron_face_of": `
// umbrage_tetrahedron_face_of: the face, 0.0 to 3.0, whose triangle in a map of size texels a texel lies in
UMBRAGE_HIGHP float umbrage_tetrahedron_face_of(UMBRAGE_HIGHP vec2 texel, UMBRAGE_HIGHP float size) {
    UMBRAGE_HIGHP vec2 off = texel * 2.0 + (1.0 - size);
    UMBRAGE_HIGHP float column = off.y < 0.0 ? 0.0 : 1.0;
    UMBRAGE_HIGHP float row = off.x < 0.0 ? 3.0 : 2.0;
    return abs(off.y) >= abs(off.x) ? column : row;
}
`,
            "pancake": `
// umbrage_pancake: a clip space position, moved onto the near plane where it lies before it
//   at_near  z/w of the near plane: 0.0 or -1.0, or 1.0 for reversed depth
UMBRAGE_HIGHP vec4 umbrage_pancake(UMBRAGE_HIGHP vec4 position, UMBRAGE_HIGHP float at_near) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float plane = at_near * position.w;
    bool before = at_near > 0.5 ? position.z > plane : position.z < plane;
    return vec4(position.x, position.y, before ? plane : position.z, position.w);
}
`,
            "texel": `
// umbrage_texel: value of a texel inside the map
//   map    where its texels lie; a sampler that reads them filters by nearest
//   size   of the map in texels;   texel  whole numbers, (0, 0) is the first
UMBRAGE_HIGHP vec4 umbrage_texel(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel) {
    UMBRAGE_HIGHP vec2 at = texel + UMBRAGE_ORIGIN;
    return UMBRAGE_TEXEL;
}
`,
            "from_unorm": `
// umbrage_from_unorm: channel 0..255 behind a value read from an 8-bit texture, however the driver divides by 255
UMBRAGE_HIGHP float umbrage_from_unorm(UMBRAGE_HIGHP float c) {
    return floor(c * 255.0 + 0.5);
}
UMBRAGE_HIGHP vec2 umbrage_from_unorm(UMBRAGE_HIGHP vec2 c) {
    return floor(c * 255.0 + 0.5);
}
UMBRAGE_HIGHP vec3 umbrage_from_unorm(UMBRAGE_HIGHP vec3 c) {
    return floor(c * 255.0 + 0.5);
}
UMBRAGE_HIGHP vec4 umbrage_from_unorm(UMBRAGE_HIGHP vec4 c) {
    return floor(c * 255.0 + 0.5);
}
`,
            "page_coordinate": `
// umbrage_page_coordinate: a receiver in a page of an atlas: texels of the page with its gutter, the page's first texel
//   table, size   page table, RGBA8, nearest filter;   coord   receiver, from 1.0 to 2.0 across all but its border
//   page, gutter  side of a page and what it has around it, texels
UMBRAGE_HIGHP vec4 umbrage_page_coordinate(UMBRAGE_MAP table, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                           UMBRAGE_HIGHP float page, UMBRAGE_HIGHP float gutter) {
    // not negative already; compilers cannot regroup sums across max and clamp
    UMBRAGE_HIGHP vec2 sides = max(size - 2.0, vec2(1.0, 1.0));
    UMBRAGE_HIGHP vec2 before = max(size - 3.0, vec2(0.0, 0.0));
    UMBRAGE_HIGHP vec2 cell = min(max(vec2(0.0, 0.0), coord * sides - before), size - 1.0);
    UMBRAGE_HIGHP ivec2 texel = ivec2(cell);  // of a NaN the first
    UMBRAGE_HIGHP vec4 entry = umbrage_from_unorm(umbrage_texel(table, size, vec2(texel)));
    UMBRAGE_HIGHP vec2 slot = vec2(entry.x, entry.y);
    UMBRAGE_HIGHP float across = entry.z + entry.w * 256.0;
    UMBRAGE_HIGHP vec2 within = clamp(fract(coord * across), vec2(0.0, 0.0), vec2(1.0, 1.0));
    UMBRAGE_HIGHP vec2 at = within * page + (across > 0.0 ? gutter : 32768.0);
    return vec4(at, slot * (page + gutter * 2.0));
}
`,
            "linear_depth": `
// umbrage_linear_depth: distance along the light's axis, positive in front of it, times 1 / z_far
UMBRAGE_HIGHP float umbrage_linear_depth(UMBRAGE_HIGHP float z_view, UMBRAGE_HIGHP float inv_z_far) {
    return z_view * inv_z_far;
}
`,
            "project_depth": `
// umbrage_project_depth: z / w; for w <= 0.0 cleared, which is 1.0, or 0.0 when reversed
UMBRAGE_HIGHP float umbrage_project_depth(UMBRAGE_HIGHP float z, UMBRAGE_HIGHP float w, UMBRAGE_HIGHP float cleared) {
    return w > 0.0 ? z / w : cleared;
}
`,
            "distance_depth": `
// umbrage_distance_depth: length of to_point, from the light, times 1 / range
UMBRAGE_HIGHP float umbrage_distance_depth(UMBRAGE_HIGHP vec3 to_point, UMBRAGE_HIGHP float inv_range) {
    return sqrt(to_point.x * to_point.x + to_point.y * to_point.y + to_point.z * to_point.z) * inv_range;
}
`,
            "reverse_depth": `
// umbrage_reverse_depth: forward depth from reversed, or reversed from forward
UMBRAGE_HIGHP float umbrage_reverse_depth(UMBRAGE_HIGHP float depth) {
    return 1.0 - depth;
}
`,
            "depth_from_ndc": `
// umbrage_depth_from_ndc: depth in [0, 1] from z/w in [-1, 1]
UMBRAGE_HIGHP float umbrage_depth_from_ndc(UMBRAGE_HIGHP float ndc) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float depth = ndc * 0.5 + 0.5;
    return depth;
}
`,
            "view_z_from_depth": `
// umbrage_view_z_from_depth: perspective depth in [0, 1], 0.0 at z_near, to distance along the light's axis
UMBRAGE_HIGHP float umbrage_view_z_from_depth(UMBRAGE_HIGHP float depth, UMBRAGE_HIGHP float z_near,
                                              UMBRAGE_HIGHP float z_far) {
    return z_near / (1.0 - depth * (1.0 - z_near / z_far));
}
`,
            "depth_from_view_z": `
// umbrage_depth_from_view_z: distance along the light's axis to perspective depth in [0, 1], 0.0 at z_near
UMBRAGE_HIGHP float umbrage_depth_from_view_z(UMBRAGE_HIGHP float z_view, UMBRAGE_HIGHP float z_near,
                                              UMBRAGE_HIGHP float z_far) {
    return (1.0 - z_near / z_view) / (1.0 - z_near / z_far);
}
`,
            "view_z_from_reversed_depth": `
// umbrage_view_z_from_reversed_depth: perspective depth in [0, 1], 1.0 at z_near, to distance along the light's axis
UMBRAGE_HIGHP float umbrage_view_z_from_reversed_depth(UMBRAGE_HIGHP float depth, UMBRAGE_HIGHP float z_near,
                                                       UMBRAGE_HIGHP float z_far) {
    return z_near / (z_near / z_far + depth * (1.0 - z_near / z_far));
}
`,
            "reversed_depth_from_view_z": `
// umbrage_reversed_depth_from_view_z: distance along the light's axis to perspective depth in [0, 1], 1.0 at z_near
UMBRAGE_HIGHP float umbrage_reversed_depth_from_view_z(UMBRAGE_HIGHP float z_view, UMBRAGE_HIGHP float z_near,
                                                       UMBRAGE_HIGHP float z_far) {
    return z_near / z_view * (1.0 - z_view / z_far) / (1.0 - z_near / z_far);
}
`,
            "view_z_from_orthographic_depth": `
// umbrage_view_z_from_orthographic_depth: orthographic depth in [0, 1], 0.0 at z_near, to distance along the light's
// axis; when reversed, exchange z_near and z_far
UMBRAGE_HIGHP float umbrage_view_z_from_orthographic_depth(UMBRAGE_HIGHP float depth, UMBRAGE_HIGHP float z_near,
                                                           UMBRAGE_HIGHP float z_far) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float z_view = z_near + depth * (z_far - z_near);
    return z_view;
}
`,
            "orthographic_depth_from_view_z": `
// umbrage_orthographic_depth_from_view_z: distance along the light's axis to orthographic depth in [0, 1], 0.0 at
// z_near; when reversed, exchange z_near and z_far
UMBRAGE_HIGHP float umbrage_orthographic_depth_from_view_z(UMBRAGE_HIGHP float z_view, UMBRAGE_HIGHP float z_near,
                                                           UMBRAGE_HIGHP float z_far) {
    return (z_view - z_near) / (z_far - z_near);
}
`,
            "cleared_depth": `
// umbrage_cleared_depth: depth of the far plane
UMBRAGE_HIGHP float umbrage_cleared_depth() {
    return 1.0;
}
`,
            "saturate": `
// umbrage_saturate: v clamped to [0, 1]; NaN becomes the far plane's depth
UMBRAGE_HIGHP float umbrage_saturate(UMBRAGE_HIGHP float v) {
    // not v > 0.0 ? v : 0.0, of which Mesa makes max(v, 0.0): softpipe's gives NaN for a signalling one
    return v > 0.0 && v < 1.0 ? v : (v >= 1.0 ? 1.0 : (v <= 0.0 ? 0.0 : umbrage_cleared_depth()));
}
`,
            "correct_quotient": `
// umbrage_correct_quotient: floor(a / b) from q, at most one off;  whole numbers, a below 2^24, b from 1 to 2^24
UMBRAGE_HIGHP float umbrage_correct_quotient(UMBRAGE_HIGHP float q, UMBRAGE_HIGHP float a, UMBRAGE_HIGHP float b) {
    UMBRAGE_HIGHP float more = q + 1.0;
    UMBRAGE_HIGHP float known = more * b <= a ? more : q;
    return q * b > a ? q - 1.0 : known;
}
`,
            "floor_divide": `
// umbrage_floor_divide: floor(a / b) of whole numbers, a below 2^24, b from 1 to 2^24, the quotient at most 2^18
UMBRAGE_HIGHP float umbrage_floor_divide(UMBRAGE_HIGHP float a, UMBRAGE_HIGHP float b) {
    return umbrage_correct_quotient(floor(a / b), a, b);
}
`,
            "to_unorm": `
// umbrage_to_unorm: what to write so that an 8-bit target stores channel k, whether it rounds or truncates
// k * 257 / 65536 + 64 / 65536; not written so, since 65536.0 is infinite in mediump
UMBRAGE_HIGHP float umbrage_to_unorm(UMBRAGE_HIGHP float k) {
    return k * 0.0039215087890625 + 0.0009765625;
}
UMBRAGE_HIGHP vec2 umbrage_to_unorm(UMBRAGE_HIGHP vec2 k) {
    return k * 0.0039215087890625 + 0.0009765625;
}
UMBRAGE_HIGHP vec3 umbrage_to_unorm(UMBRAGE_HIGHP vec3 k) {
    return k * 0.0039215087890625 + 0.0009765625;
}
UMBRAGE_HIGHP vec4 umbrage_to_unorm(UMBRAGE_HIGHP vec4 k) {
    return k * 0.0039215087890625 + 0.0009765625;
}
`,
            "to_unorm10": `
// umbrage_to_unorm10: what to write so that a 10-bit target stores channel k, whether it rounds or truncates
// k * 4099 / 4194304 + 1056 / 4194304
UMBRAGE_HIGHP float umbrage_to_unorm10(UMBRAGE_HIGHP float k) {
    return k * 0.0009772777557373046875 + 0.00025177001953125;
}
UMBRAGE_HIGHP vec2 umbrage_to_unorm10(UMBRAGE_HIGHP vec2 k) {
    return k * 0.0009772777557373046875 + 0.00025177001953125;
}
UMBRAGE_HIGHP vec3 umbrage_to_unorm10(UMBRAGE_HIGHP vec3 k) {
    return k * 0.0009772777557373046875 + 0.00025177001953125;
}
UMBRAGE_HIGHP vec4 umbrage_to_unorm10(UMBRAGE_HIGHP vec4 k) {
    return k * 0.0009772777557373046875 + 0.00025177001953125;
}
`,
            "from_unorm10": `
// umbrage_from_unorm10: channel 0..1023 behind a value read from a 10-bit texture, however the driver divides by 1023
UMBRAGE_HIGHP float umbrage_from_unorm10(UMBRAGE_HIGHP float c) {
    return floor(c * 1023.0 + 0.5);
}
UMBRAGE_HIGHP vec2 umbrage_from_unorm10(UMBRAGE_HIGHP vec2 c) {
    return floor(c * 1023.0 + 0.5);
}
UMBRAGE_HIGHP vec3 umbrage_from_unorm10(UMBRAGE_HIGHP vec3 c) {
    return floor(c * 1023.0 + 0.5);
}
UMBRAGE_HIGHP vec4 umbrage_from_unorm10(UMBRAGE_HIGHP vec4 c) {
    return floor(c * 1023.0 + 0.5);
}
`,
            "to_unorm16": `
// umbrage_to_unorm16: what to write so that a 16-bit target stores channel k, whether it rounds or truncates
UMBRAGE_HIGHP float umbrage_to_unorm16(UMBRAGE_HIGHP float k) {
    return min(k + (floor(k * (1.0 / 256.0)) * (1.0 / 256.0) + 0.25), 65536.0) * (1.0 / 65536.0);
}
UMBRAGE_HIGHP vec2 umbrage_to_unorm16(UMBRAGE_HIGHP vec2 k) {
    return min(k + (floor(k * (1.0 / 256.0)) * (1.0 / 256.0) + 0.25), 65536.0) * (1.0 / 65536.0);
}
UMBRAGE_HIGHP vec3 umbrage_to_unorm16(UMBRAGE_HIGHP vec3 k) {
    return min(k + (floor(k * (1.0 / 256.0)) * (1.0 / 256.0) + 0.25), 65536.0) * (1.0 / 65536.0);
}
UMBRAGE_HIGHP vec4 umbrage_to_unorm16(UMBRAGE_HIGHP vec4 k) {
    return min(k + (floor(k * (1.0 / 256.0)) * (1.0 / 256.0) + 0.25), 65536.0) * (1.0 / 65536.0);
}
`,
            "from_unorm16": `
// umbrage_from_unorm16: channel 0..65535 behind a value read from a 16-bit texture, however the driver divides by 65535
UMBRAGE_HIGHP float umbrage_from_unorm16(UMBRAGE_HIGHP float c) {
    return floor(c * 65535.0 + 0.5);
}
UMBRAGE_HIGHP vec2 umbrage_from_unorm16(UMBRAGE_HIGHP vec2 c) {
    return floor(c * 65535.0 + 0.5);
}
UMBRAGE_HIGHP vec3 umbrage_from_unorm16(UMBRAGE_HIGHP vec3 c) {
    return floor(c * 65535.0 + 0.5);
}
UMBRAGE_HIGHP vec4 umbrage_from_unorm16(UMBRAGE_HIGHP vec4 c) {
    return floor(c * 65535.0 + 0.5);
}
`,
            "encode_rg9": `
// umbrage_encode_rg9: depth to the two channels of a 9-bit code, whole numbers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1], NaN counts as far
UMBRAGE_HIGHP vec2 umbrage_encode_rg9(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float x = min(floor(umbrage_saturate(depth) * 512.0), 511.0);
    UMBRAGE_HIGHP float high = floor(x * (1.0 / 256.0));
    return vec2(x - high * 256.0, high * 128.0);
}
`,
            "encode_rg10": `
// umbrage_encode_rg10: depth to the two channels of a 10-bit code, whole numbers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1], NaN counts as far
UMBRAGE_HIGHP vec2 umbrage_encode_rg10(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float x = min(floor(umbrage_saturate(depth) * 1024.0), 1023.0);
    UMBRAGE_HIGHP float high = floor(x * (1.0 / 256.0));
    return vec2(x - high * 256.0, high * 64.0);
}
`,
            "encode_rg11": `
// umbrage_encode_rg11: depth to the two channels of a 11-bit code, whole numbers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1], NaN counts as far
UMBRAGE_HIGHP vec2 umbrage_encode_rg11(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float x = min(floor(umbrage_saturate(depth) * 2048.0), 2047.0);
    UMBRAGE_HIGHP float high = floor(x * (1.0 / 256.0));
    return vec2(x - high * 256.0, high * 32.0);
}
`,
            "encode_rg12": `
// umbrage_encode_rg12: depth to the two channels of a 12-bit code, whole numbers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1], NaN counts as far
UMBRAGE_HIGHP vec2 umbrage_encode_rg12(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float x = min(floor(umbrage_saturate(depth) * 4096.0), 4095.0);
    UMBRAGE_HIGHP float high = floor(x * (1.0 / 256.0));
    return vec2(x - high * 256.0, high * 16.0);
}
`,
            "encode_rg13": `
// umbrage_encode_rg13: depth to the two channels of a 13-bit code, whole numbers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1], NaN counts as far
UMBRAGE_HIGHP vec2 umbrage_encode_rg13(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float x = min(floor(umbrage_saturate(depth) * 8192.0), 8191.0);
    UMBRAGE_HIGHP float high = floor(x * (1.0 / 256.0));
    return vec2(x - high * 256.0, high * 8.0);
}
`,
            "encode_rg14": `
// umbrage_encode_rg14: depth to the two channels of a 14-bit code, whole numbers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1], NaN counts as far
UMBRAGE_HIGHP vec2 umbrage_encode_rg14(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float x = min(floor(umbrage_saturate(depth) * 16384.0), 16383.0);
    UMBRAGE_HIGHP float high = floor(x * (1.0 / 256.0));
    return vec2(x - high * 256.0, high * 4.0);
}
`,
            "encode_rg15": `
// umbrage_encode_rg15: depth to the two channels of a 15-bit code, whole numbers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1], NaN counts as far
UMBRAGE_HIGHP vec2 umbrage_encode_rg15(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float x = min(floor(umbrage_saturate(depth) * 32768.0), 32767.0);
    UMBRAGE_HIGHP float high = floor(x * (1.0 / 256.0));
    return vec2(x - high * 256.0, high * 2.0);
}
`,
            "encode_rg16": `
// umbrage_encode_rg16: depth to the two channels of a 16-bit code, whole numbers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1], NaN counts as far
UMBRAGE_HIGHP vec2 umbrage_encode_rg16(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float x = min(floor(umbrage_saturate(depth) * 65536.0), 65535.0);
    UMBRAGE_HIGHP float high = floor(x * (1.0 / 256.0));
    return vec2(x - high * 256.0, high * 1.0);
}
`,
            "encode_rgb24": `
// umbrage_encode_rgb24: depth to three channels, R most significant, whole numbers 0..255 for umbrage_to_unorm
//   depth   clamped to [0, 1], NaN counts as far
UMBRAGE_HIGHP vec3 umbrage_encode_rgb24(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float x = min(floor(umbrage_saturate(depth) * 16777216.0), 16777215.0);
    UMBRAGE_HIGHP float high = floor(x * (1.0 / 65536.0));
    UMBRAGE_HIGHP float rest = x - high * 65536.0;
    UMBRAGE_HIGHP float middle = floor(rest * (1.0 / 256.0));
    return vec3(high, middle, min(rest - middle * 256.0, 255.0));  // below already: no sum is regrouped across the min
}
`,
            "encode_rgb10": `
// umbrage_encode_rgb10: depth to three channels, R most significant, whole numbers 0..1023 for umbrage_to_unorm10
// the last four bits are the high ones of B, so that a target cleared to white is at the far plane
//   depth   clamped to [0, 1], NaN counts as far
UMBRAGE_HIGHP vec3 umbrage_encode_rgb10(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float x = min(floor(umbrage_saturate(depth) * 16777216.0), 16777215.0);
    UMBRAGE_HIGHP float high = floor(x * (1.0 / 16384.0));
    UMBRAGE_HIGHP float rest = x - high * 16384.0;
    UMBRAGE_HIGHP float middle = floor(rest * (1.0 / 16.0));
    UMBRAGE_HIGHP float low = min(rest - middle * 16.0, 15.0);  // below already: no sum is regrouped across the min
    return vec3(high, middle, low * 64.0);
}
`,
            "encode_r16": `
// umbrage_encode_r16: depth to one channel, a whole number 0..65535 for umbrage_to_unorm16
//   depth   clamped to [0, 1], NaN counts as far
UMBRAGE_HIGHP float umbrage_encode_r16(UMBRAGE_HIGHP float depth) {
    return min(floor(umbrage_saturate(depth) * 65536.0), 65535.0);
}
`,
            "encode_float_bits": `
// umbrage_encode_float_bits: bit pattern of v as four channels, R least significant, whole numbers 0..255
UMBRAGE_HIGHP vec4 umbrage_encode_float_bits(UMBRAGE_HIGHP float v) {
    UMBRAGE_HIGHP uint bits = floatBitsToUint(v);
    return vec4(float(bits & 255u), float((bits >> 8) & 255u), float((bits >> 16) & 255u), float(bits >> 24));
}
`,
            "write_threejs_rgba": `
// umbrage_write_threejs_rgba: depth to the RGBA format of three.js r167 and later, values to write as they are
UMBRAGE_HIGHP vec4 umbrage_write_threejs_rgba(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float v = umbrage_saturate(depth);
    UMBRAGE_HIGHP float x = v * 16777216.0;
    UMBRAGE_HIGHP float whole = floor(x);
    UMBRAGE_HIGHP float high = floor(whole * (1.0 / 65536.0));
    UMBRAGE_HIGHP float rest = whole - high * 65536.0;
    UMBRAGE_HIGHP float middle = floor(rest * (1.0 / 256.0));
    UMBRAGE_HIGHP float low = rest - middle * 256.0;
    UMBRAGE_HIGHP vec4 c = vec4(high * 0.00392156886, middle * 0.00392156886, low * 0.00392156886, x - whole);
    return v < 1.0 ? c : vec4(1.0, 1.0, 1.0, 1.0);
}
`,
            "write_threejs_rgb": `
// umbrage_write_threejs_rgb: depth to the RGB format of three.js r167 and later, values to write as they are
UMBRAGE_HIGHP vec3 umbrage_write_threejs_rgb(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float v = umbrage_saturate(depth);
    UMBRAGE_HIGHP float x = v * 65536.0;
    UMBRAGE_HIGHP float whole = floor(x);
    UMBRAGE_HIGHP float high = floor(whole * (1.0 / 256.0));
    UMBRAGE_HIGHP vec3 c = vec3(high * 0.00392156886, (whole - high * 256.0) * 0.00392156886, x - whole);
    return v < 1.0 ? c : vec3(1.0, 1.0, 1.0);
}
`,
            "write_threejs_rg": `
// umbrage_write_threejs_rg: depth to the RG format of three.js r167 and later, values to write as they are
UMBRAGE_HIGHP vec2 umbrage_write_threejs_rg(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float v = umbrage_saturate(depth);
    UMBRAGE_HIGHP float x = v * 256.0;
    UMBRAGE_HIGHP float whole = floor(x);
    return v < 1.0 ? vec2(whole * 0.00392156886, x - whole) : vec2(1.0, 1.0);
}
`,
            "write_threejs_legacy": `
// umbrage_write_threejs_legacy: depth to the RGBA format of three.js r73 to r166, values to write as they are;
//   1.0 reads back as 255/256: umbrage_encode_threejs_legacy_repaired does not
UMBRAGE_HIGHP vec4 umbrage_write_threejs_legacy(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float v = umbrage_saturate(depth);
    UMBRAGE_HIGHP float x = v * 16777216.0 - floor(v * 16777216.0);
    UMBRAGE_HIGHP float y = v * 65536.0 - floor(v * 65536.0);
    UMBRAGE_HIGHP float z = v * 256.0 - floor(v * 256.0);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec4 c = vec4(x, y - x * (1.0 / 256.0), z - y * (1.0 / 256.0), v - z * (1.0 / 256.0));
    return c * 1.00392163;
}
`,
            "encode_threejs_legacy_repaired": `
// umbrage_encode_threejs_legacy_repaired: depth to channels that readers of three.js r73 to r166 decode, 1.0 to 1.0;
//   whole numbers 0..255 (umbrage_to_unorm writes them)
UMBRAGE_HIGHP vec4 umbrage_encode_threejs_legacy_repaired(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float v = umbrage_saturate(depth);
    UMBRAGE_HIGHP float x = floor(v * 16777216.0);
    UMBRAGE_HIGHP float high = floor(x * (1.0 / 65536.0));
    UMBRAGE_HIGHP float rest = x - high * 65536.0;
    UMBRAGE_HIGHP float middle = floor(rest * (1.0 / 256.0));
    UMBRAGE_HIGHP float low = min(rest - middle * 256.0, 255.0);  // below already: no sum is regrouped across the min
    return v < 1.0 ? vec4(0.0, low, middle, high) : vec4(255.0, 255.0, 255.0, 255.0);
}
`,
            "write_base255": `
// umbrage_write_base255: depth to base-255 RGBA, values to write as they are; 1.0 reads back as 0.0, and the store must
//   round: umbrage_encode_base255_repaired has neither fault
UMBRAGE_HIGHP vec4 umbrage_write_base255(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float v = umbrage_saturate(depth);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec4 e = vec4(v, v * 255.0, v * 65025.0, v * 16581375.0);
    e = e - floor(e);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec4 c =
        vec4(e.x - e.y * 0.00392156886, e.y - e.z * 0.00392156886, e.z - e.w * 0.00392156886, e.w);
    return c;
}
`,
            "encode_base255_repaired": `
// umbrage_encode_base255_repaired: depth to channels that readers of base-255 RGBA decode, 1.0 to 1.0;
//   whole numbers 0..255 (umbrage_to_unorm writes them)
UMBRAGE_HIGHP vec4 umbrage_encode_base255_repaired(UMBRAGE_HIGHP float depth) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float x = umbrage_saturate(depth) * 255.0;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float y = (x - floor(x)) * 255.0;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float z = (y - floor(y)) * 255.0;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float w = (z - floor(z)) * 255.0;
    return vec4(floor(x), floor(y), floor(z), floor(w));
}
`,
            "fetch_clamped": `
// umbrage_fetch_clamped: texel of a map; coordinates outside move to the nearest texel inside
UMBRAGE_HIGHP vec4 umbrage_fetch_clamped(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel) {
    return umbrage_texel(map, size, clamp(texel, vec2(0.0, 0.0), size - 1.0));
}
`,
            "encode_rg9_table": `
// umbrage_encode_rg9_table: depth to the two channels of a 9-bit code through a look-up table, whole numbers 0..255
//   table   512 x 1 texels, row after row, nearest filter;   depth   clamped to [0, 1], NaN counts as far
UMBRAGE_HIGHP vec2 umbrage_encode_rg9_table(UMBRAGE_MAP table, UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float x = min(floor(umbrage_saturate(depth) * 512.0), 511.0);
    UMBRAGE_HIGHP float row = floor(x * (1.0 / 512.0));
    UMBRAGE_HIGHP vec2 texel = vec2(x - row * 512.0, row);
    UMBRAGE_HIGHP vec4 k = umbrage_from_unorm(umbrage_fetch_clamped(table, vec2(512.0, 1.0), texel));
    return vec2(k.x, k.y);
}
`,
            "encode_rg10_table": `
// umbrage_encode_rg10_table: depth to the two channels of a 10-bit code through a look-up table, whole numbers 0..255
//   table   1024 x 1 texels, row after row, nearest filter;   depth   clamped to [0, 1], NaN counts as far
UMBRAGE_HIGHP vec2 umbrage_encode_rg10_table(UMBRAGE_MAP table, UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float x = min(floor(umbrage_saturate(depth) * 1024.0), 1023.0);
    UMBRAGE_HIGHP float row = floor(x * (1.0 / 1024.0));
    UMBRAGE_HIGHP vec2 texel = vec2(x - row * 1024.0, row);
    UMBRAGE_HIGHP vec4 k = umbrage_from_unorm(umbrage_fetch_clamped(table, vec2(1024.0, 1.0), texel));
    return vec2(k.x, k.y);
}
`,
            "encode_rg11_table": `
// umbrage_encode_rg11_table: depth to the two channels of a 11-bit code through a look-up table, whole numbers 0..255
//   table   2048 x 1 texels, row after row, nearest filter;   depth   clamped to [0, 1], NaN counts as far
UMBRAGE_HIGHP vec2 umbrage_encode_rg11_table(UMBRAGE_MAP table, UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float x = min(floor(umbrage_saturate(depth) * 2048.0), 2047.0);
    UMBRAGE_HIGHP float row = floor(x * (1.0 / 2048.0));
    UMBRAGE_HIGHP vec2 texel = vec2(x - row * 2048.0, row);
    UMBRAGE_HIGHP vec4 k = umbrage_from_unorm(umbrage_fetch_clamped(table, vec2(2048.0, 1.0), texel));
    return vec2(k.x, k.y);
}
`,
            "encode_rg12_table": `
// umbrage_encode_rg12_table: depth to the two channels of a 12-bit code through a look-up table, whole numbers 0..255
//   table   2048 x 2 texels, row after row, nearest filter;   depth   clamped to [0, 1], NaN counts as far
UMBRAGE_HIGHP vec2 umbrage_encode_rg12_table(UMBRAGE_MAP table, UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float x = min(floor(umbrage_saturate(depth) * 4096.0), 4095.0);
    UMBRAGE_HIGHP float row = floor(x * (1.0 / 2048.0));
    UMBRAGE_HIGHP vec2 texel = vec2(x - row * 2048.0, row);
    UMBRAGE_HIGHP vec4 k = umbrage_from_unorm(umbrage_fetch_clamped(table, vec2(2048.0, 2.0), texel));
    return vec2(k.x, k.y);
}
`,
            "encode_rg13_table": `
// umbrage_encode_rg13_table: depth to the two channels of a 13-bit code through a look-up table, whole numbers 0..255
//   table   2048 x 4 texels, row after row, nearest filter;   depth   clamped to [0, 1], NaN counts as far
UMBRAGE_HIGHP vec2 umbrage_encode_rg13_table(UMBRAGE_MAP table, UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float x = min(floor(umbrage_saturate(depth) * 8192.0), 8191.0);
    UMBRAGE_HIGHP float row = floor(x * (1.0 / 2048.0));
    UMBRAGE_HIGHP vec2 texel = vec2(x - row * 2048.0, row);
    UMBRAGE_HIGHP vec4 k = umbrage_from_unorm(umbrage_fetch_clamped(table, vec2(2048.0, 4.0), texel));
    return vec2(k.x, k.y);
}
`,
            "encode_rg14_table": `
// umbrage_encode_rg14_table: depth to the two channels of a 14-bit code through a look-up table, whole numbers 0..255
//   table   2048 x 8 texels, row after row, nearest filter;   depth   clamped to [0, 1], NaN counts as far
UMBRAGE_HIGHP vec2 umbrage_encode_rg14_table(UMBRAGE_MAP table, UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float x = min(floor(umbrage_saturate(depth) * 16384.0), 16383.0);
    UMBRAGE_HIGHP float row = floor(x * (1.0 / 2048.0));
    UMBRAGE_HIGHP vec2 texel = vec2(x - row * 2048.0, row);
    UMBRAGE_HIGHP vec4 k = umbrage_from_unorm(umbrage_fetch_clamped(table, vec2(2048.0, 8.0), texel));
    return vec2(k.x, k.y);
}
`,
            "encode_rg15_table": `
// umbrage_encode_rg15_table: depth to the two channels of a 15-bit code through a look-up table, whole numbers 0..255
//   table   2048 x 16 texels, row after row, nearest filter;   depth   clamped to [0, 1], NaN counts as far
UMBRAGE_HIGHP vec2 umbrage_encode_rg15_table(UMBRAGE_MAP table, UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float x = min(floor(umbrage_saturate(depth) * 32768.0), 32767.0);
    UMBRAGE_HIGHP float row = floor(x * (1.0 / 2048.0));
    UMBRAGE_HIGHP vec2 texel = vec2(x - row * 2048.0, row);
    UMBRAGE_HIGHP vec4 k = umbrage_from_unorm(umbrage_fetch_clamped(table, vec2(2048.0, 16.0), texel));
    return vec2(k.x, k.y);
}
`,
            "encode_rg16_table": `
// umbrage_encode_rg16_table: depth to the two channels of a 16-bit code through a look-up table, whole numbers 0..255
//   table   2048 x 32 texels, row after row, nearest filter;   depth   clamped to [0, 1], NaN counts as far
UMBRAGE_HIGHP vec2 umbrage_encode_rg16_table(UMBRAGE_MAP table, UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float x = min(floor(umbrage_saturate(depth) * 65536.0), 65535.0);
    UMBRAGE_HIGHP float row = floor(x * (1.0 / 2048.0));
    UMBRAGE_HIGHP vec2 texel = vec2(x - row * 2048.0, row);
    UMBRAGE_HIGHP vec4 k = umbrage_from_unorm(umbrage_fetch_clamped(table, vec2(2048.0, 32.0), texel));
    return vec2(k.x, k.y);
}
`,
            "decode_rg9": `
// umbrage_decode_rg9: two channels of a 9-bit code, as sampled, to depth
//   edge   0.0, 0.5, 1.0: lower edge, center, upper edge of the code's interval
UMBRAGE_HIGHP float umbrage_decode_rg9(UMBRAGE_HIGHP vec2 c, UMBRAGE_HIGHP float edge) {
    UMBRAGE_HIGHP vec2 k = umbrage_from_unorm(c);
    return (k.x + k.y * 2.0 + edge) * (1.0 / 512.0);
}
`,
            "decode_rg10": `
// umbrage_decode_rg10: two channels of a 10-bit code, as sampled, to depth
//   edge   0.0, 0.5, 1.0: lower edge, center, upper edge of the code's interval
UMBRAGE_HIGHP float umbrage_decode_rg10(UMBRAGE_HIGHP vec2 c, UMBRAGE_HIGHP float edge) {
    UMBRAGE_HIGHP vec2 k = umbrage_from_unorm(c);
    return (k.x + k.y * 4.0 + edge) * (1.0 / 1024.0);
}
`,
            "decode_rg11": `
// umbrage_decode_rg11: two channels of a 11-bit code, as sampled, to depth
//   edge   0.0, 0.5, 1.0: lower edge, center, upper edge of the code's interval
UMBRAGE_HIGHP float umbrage_decode_rg11(UMBRAGE_HIGHP vec2 c, UMBRAGE_HIGHP float edge) {
    UMBRAGE_HIGHP vec2 k = umbrage_from_unorm(c);
    return (k.x + k.y * 8.0 + edge) * (1.0 / 2048.0);
}
`,
            "decode_rg12": `
// umbrage_decode_rg12: two channels of a 12-bit code, as sampled, to depth
//   edge   0.0, 0.5, 1.0: lower edge, center, upper edge of the code's interval
UMBRAGE_HIGHP float umbrage_decode_rg12(UMBRAGE_HIGHP vec2 c, UMBRAGE_HIGHP float edge) {
    UMBRAGE_HIGHP vec2 k = umbrage_from_unorm(c);
    return (k.x + k.y * 16.0 + edge) * (1.0 / 4096.0);
}
`,
            "decode_rg13": `
// umbrage_decode_rg13: two channels of a 13-bit code, as sampled, to depth
//   edge   0.0, 0.5, 1.0: lower edge, center, upper edge of the code's interval
UMBRAGE_HIGHP float umbrage_decode_rg13(UMBRAGE_HIGHP vec2 c, UMBRAGE_HIGHP float edge) {
    UMBRAGE_HIGHP vec2 k = umbrage_from_unorm(c);
    return (k.x + k.y * 32.0 + edge) * (1.0 / 8192.0);
}
`,
            "decode_rg14": `
// umbrage_decode_rg14: two channels of a 14-bit code, as sampled, to depth
//   edge   0.0, 0.5, 1.0: lower edge, center, upper edge of the code's interval
UMBRAGE_HIGHP float umbrage_decode_rg14(UMBRAGE_HIGHP vec2 c, UMBRAGE_HIGHP float edge) {
    UMBRAGE_HIGHP vec2 k = umbrage_from_unorm(c);
    return (k.x + k.y * 64.0 + edge) * (1.0 / 16384.0);
}
`,
            "decode_rg15": `
// umbrage_decode_rg15: two channels of a 15-bit code, as sampled, to depth
//   edge   0.0, 0.5, 1.0: lower edge, center, upper edge of the code's interval
UMBRAGE_HIGHP float umbrage_decode_rg15(UMBRAGE_HIGHP vec2 c, UMBRAGE_HIGHP float edge) {
    UMBRAGE_HIGHP vec2 k = umbrage_from_unorm(c);
    return (k.x + k.y * 128.0 + edge) * (1.0 / 32768.0);
}
`,
            "decode_rg16": `
// umbrage_decode_rg16: two channels of a 16-bit code, as sampled, to depth
//   edge   0.0, 0.5, 1.0: lower edge, center, upper edge of the code's interval
UMBRAGE_HIGHP float umbrage_decode_rg16(UMBRAGE_HIGHP vec2 c, UMBRAGE_HIGHP float edge) {
    UMBRAGE_HIGHP vec2 k = umbrage_from_unorm(c);
    return (k.x + k.y * 256.0 + edge) * (1.0 / 65536.0);
}
`,
            "decode_rgb24": `
// umbrage_decode_rgb24: three channels, as sampled, to depth
//   edge   0.0 or 1.0: lower or upper edge of the code's interval
UMBRAGE_HIGHP float umbrage_decode_rgb24(UMBRAGE_HIGHP vec3 c, UMBRAGE_HIGHP float edge) {
    UMBRAGE_HIGHP vec3 k = umbrage_from_unorm(c);
    return ((k.x * 256.0 + k.y) * 256.0 + k.z + edge) * (1.0 / 16777216.0);
}
`,
            "decode_rgb10": `
// umbrage_decode_rgb10: three 10-bit channels, as sampled, to depth
//   edge   0.0 or 1.0: lower or upper edge of the code's interval
UMBRAGE_HIGHP float umbrage_decode_rgb10(UMBRAGE_HIGHP vec3 c, UMBRAGE_HIGHP float edge) {
    UMBRAGE_HIGHP vec3 k = umbrage_from_unorm10(c);
    return ((k.x * 1024.0 + k.y) * 16.0 + floor(k.z * (1.0 / 64.0)) + edge) * (1.0 / 16777216.0);
}
`,
            "decode_r16": `
// umbrage_decode_r16: one channel of 16 bits, as sampled, to depth
//   edge   0.0, 0.5 or 1.0: lower edge, center or upper edge of the code's interval
UMBRAGE_HIGHP float umbrage_decode_r16(UMBRAGE_HIGHP float c, UMBRAGE_HIGHP float edge) {
    return (umbrage_from_unorm16(c) + edge) * (1.0 / 65536.0);
}
`,
            "decode_float_bits": `
// umbrage_decode_float_bits: four channels of a bit pattern, as sampled, R least significant, to the float
UMBRAGE_HIGHP float umbrage_decode_float_bits(UMBRAGE_HIGHP vec4 c) {
    UMBRAGE_HIGHP uint r = uint(umbrage_saturate(c.x) * 255.0 + 0.5);
    UMBRAGE_HIGHP uint g = uint(umbrage_saturate(c.y) * 255.0 + 0.5);
    UMBRAGE_HIGHP uint b = uint(umbrage_saturate(c.z) * 255.0 + 0.5);
    UMBRAGE_HIGHP uint a = uint(umbrage_saturate(c.w) * 255.0 + 0.5);
    return uintBitsToFloat(r | (g << 8) | (b << 16) | (a << 24));
}
`,
            "decode_threejs_rgba": `
// umbrage_decode_threejs_rgba: the RGBA format of three.js r167 and later, as sampled, to depth
UMBRAGE_HIGHP float umbrage_decode_threejs_rgba(UMBRAGE_HIGHP vec4 c) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float depth = c.x * (255.0 / 256.0) + c.y * (255.0 / 65536.0) +
                                                c.z * (255.0 / 16777216.0) + c.w * (1.0 / 16777216.0);
    return depth;
}
`,
            "decode_threejs_rgb": `
// umbrage_decode_threejs_rgb: the RGB format of three.js r167 and later, as sampled, to depth
UMBRAGE_HIGHP float umbrage_decode_threejs_rgb(UMBRAGE_HIGHP vec3 c) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float depth =
        c.x * (255.0 / 256.0) + c.y * (255.0 / 65536.0) + c.z * (1.0 / 65536.0);
    return depth;
}
`,
            "decode_threejs_rg": `
// umbrage_decode_threejs_rg: the RG format of three.js r167 and later, as sampled, to depth
UMBRAGE_HIGHP float umbrage_decode_threejs_rg(UMBRAGE_HIGHP vec2 c) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float depth = c.x * (255.0 / 256.0) + c.y * (1.0 / 256.0);
    return depth;
}
`,
            "decode_threejs_legacy": `
// umbrage_decode_threejs_legacy: the RGBA format of three.js r73 to r166, as sampled, to depth
UMBRAGE_HIGHP float umbrage_decode_threejs_legacy(UMBRAGE_HIGHP vec4 c) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float depth = c.x * (255.0 / 4294967296.0) + c.y * (255.0 / 16777216.0) +
                                                c.z * (255.0 / 65536.0) + c.w * (255.0 / 256.0);
    return depth;
}
`,
            "decode_base255": `
// umbrage_decode_base255: base-255 RGBA, as sampled, to depth
UMBRAGE_HIGHP float umbrage_decode_base255(UMBRAGE_HIGHP vec4 c) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float depth =
        c.x + c.y * 0.00392156886 + c.z * 0.0000153787005 + c.w * 0.0000000603086294;
    return depth;
}
`,
            "level_rg9": `
// umbrage_level_rg9: two channels of a 9-bit code, as sampled, to the scale of umbrage_receiver_rg9, on which 1.0 is
//   not the far plane
UMBRAGE_HIGHP float umbrage_level_rg9(UMBRAGE_HIGHP vec2 c) {
    return c.x + c.y * 2.0;  // an exact product: fused or not, it rounds once
}
`,
            "level_rg10": `
// umbrage_level_rg10: two channels of a 10-bit code, as sampled, to the scale of umbrage_receiver_rg10, on which 1.0 is
//   not the far plane
UMBRAGE_HIGHP float umbrage_level_rg10(UMBRAGE_HIGHP vec2 c) {
    return c.x + c.y * 4.0;  // an exact product: fused or not, it rounds once
}
`,
            "level_rg11": `
// umbrage_level_rg11: two channels of a 11-bit code, as sampled, to the scale of umbrage_receiver_rg11, on which 1.0 is
//   not the far plane
UMBRAGE_HIGHP float umbrage_level_rg11(UMBRAGE_HIGHP vec2 c) {
    return c.x + c.y * 8.0;  // an exact product: fused or not, it rounds once
}
`,
            "level_rg12": `
// umbrage_level_rg12: two channels of a 12-bit code, as sampled, to the scale of umbrage_receiver_rg12, on which 1.0 is
//   not the far plane
UMBRAGE_HIGHP float umbrage_level_rg12(UMBRAGE_HIGHP vec2 c) {
    return c.x + c.y * 16.0;  // an exact product: fused or not, it rounds once
}
`,
            "level_rg13": `
// umbrage_level_rg13: two channels of a 13-bit code, as sampled, to the scale of umbrage_receiver_rg13, on which 1.0 is
//   not the far plane
UMBRAGE_HIGHP float umbrage_level_rg13(UMBRAGE_HIGHP vec2 c) {
    return c.x + c.y * 32.0;  // an exact product: fused or not, it rounds once
}
`,
            "level_rg14": `
// umbrage_level_rg14: two channels of a 14-bit code, as sampled, to the scale of umbrage_receiver_rg14, on which 1.0 is
//   not the far plane
UMBRAGE_HIGHP float umbrage_level_rg14(UMBRAGE_HIGHP vec2 c) {
    return c.x + c.y * 64.0;  // an exact product: fused or not, it rounds once
}
`,
            "level_rg15": `
// umbrage_level_rg15: two channels of a 15-bit code, as sampled, to the scale of umbrage_receiver_rg15, on which 1.0 is
//   not the far plane
UMBRAGE_HIGHP float umbrage_level_rg15(UMBRAGE_HIGHP vec2 c) {
    return c.x + c.y * 128.0;  // an exact product: fused or not, it rounds once
}
`,
            "level_rg16": `
// umbrage_level_rg16: two channels of a 16-bit code, as sampled, to the scale of umbrage_receiver_rg16, on which 1.0 is
//   not the far plane
UMBRAGE_HIGHP float umbrage_level_rg16(UMBRAGE_HIGHP vec2 c) {
    return c.x + c.y * 256.0;  // an exact product: fused or not, it rounds once
}
`,
            "receiver_rg9": `
// umbrage_receiver_rg9: receiver on the scale of umbrage_level_rg9: it is <= a texel's level exactly when
//   depth <= umbrage_decode_rg9(texel, edge), or beyond the far plane
UMBRAGE_HIGHP float umbrage_receiver_rg9(UMBRAGE_HIGHP float depth, UMBRAGE_HIGHP float edge) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float level = (ceil(depth * 512.0 - edge) - 0.5) * 0.00392156886;
    return depth > 1.0 ? -1.0 : level;
}
`,
            "receiver_rg10": `
// umbrage_receiver_rg10: receiver on the scale of umbrage_level_rg10: it is <= a texel's level exactly when
//   depth <= umbrage_decode_rg10(texel, edge), or beyond the far plane
UMBRAGE_HIGHP float umbrage_receiver_rg10(UMBRAGE_HIGHP float depth, UMBRAGE_HIGHP float edge) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float level = (ceil(depth * 1024.0 - edge) - 0.5) * 0.00392156886;
    return depth > 1.0 ? -1.0 : level;
}
`,
            "receiver_rg11": `
// umbrage_receiver_rg11: receiver on the scale of umbrage_level_rg11: it is <= a texel's level exactly when
//   depth <= umbrage_decode_rg11(texel, edge), or beyond the far plane
UMBRAGE_HIGHP float umbrage_receiver_rg11(UMBRAGE_HIGHP float depth, UMBRAGE_HIGHP float edge) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float level = (ceil(depth * 2048.0 - edge) - 0.5) * 0.00392156886;
    return depth > 1.0 ? -1.0 : level;
}
`,
            "receiver_rg12": `
// umbrage_receiver_rg12: receiver on the scale of umbrage_level_rg12: it is <= a texel's level exactly when
//   depth <= umbrage_decode_rg12(texel, edge), or beyond the far plane
UMBRAGE_HIGHP float umbrage_receiver_rg12(UMBRAGE_HIGHP float depth, UMBRAGE_HIGHP float edge) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float level = (ceil(depth * 4096.0 - edge) - 0.5) * 0.00392156886;
    return depth > 1.0 ? -1.0 : level;
}
`,
            "receiver_rg13": `
// umbrage_receiver_rg13: receiver on the scale of umbrage_level_rg13: it is <= a texel's level exactly when
//   depth <= umbrage_decode_rg13(texel, edge), or beyond the far plane
UMBRAGE_HIGHP float umbrage_receiver_rg13(UMBRAGE_HIGHP float depth, UMBRAGE_HIGHP float edge) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float level = (ceil(depth * 8192.0 - edge) - 0.5) * 0.00392156886;
    return depth > 1.0 ? -1.0 : level;
}
`,
            "receiver_rg14": `
// umbrage_receiver_rg14: receiver on the scale of umbrage_level_rg14: it is <= a texel's level exactly when
//   depth <= umbrage_decode_rg14(texel, edge), or beyond the far plane
UMBRAGE_HIGHP float umbrage_receiver_rg14(UMBRAGE_HIGHP float depth, UMBRAGE_HIGHP float edge) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float level = (ceil(depth * 16384.0 - edge) - 0.5) * 0.00392156886;
    return depth > 1.0 ? -1.0 : level;
}
`,
            "receiver_rg15": `
// umbrage_receiver_rg15: receiver on the scale of umbrage_level_rg15: it is <= a texel's level exactly when
//   depth <= umbrage_decode_rg15(texel, edge), or beyond the far plane
UMBRAGE_HIGHP float umbrage_receiver_rg15(UMBRAGE_HIGHP float depth, UMBRAGE_HIGHP float edge) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float level = (ceil(depth * 32768.0 - edge) - 0.5) * 0.00392156886;
    return depth > 1.0 ? -1.0 : level;
}
`,
            "receiver_rg16": `
// umbrage_receiver_rg16: receiver on the scale of umbrage_level_rg16: it is <= a texel's level exactly when
//   depth <= umbrage_decode_rg16(texel, edge), or beyond the far plane
UMBRAGE_HIGHP float umbrage_receiver_rg16(UMBRAGE_HIGHP float depth, UMBRAGE_HIGHP float edge) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float level = (ceil(depth * 65536.0 - edge) - 0.5) * 0.00392156886;
    return depth > 1.0 ? -1.0 : level;
}
`,
            "decode_ps14": `
// umbrage_decode_ps14: the channels of an 11-bit code, as sampled, to x / 2040; compare with umbrage_receiver_ps14;
//   1.0 is not the far plane on this scale
UMBRAGE_HIGHP float umbrage_decode_ps14(UMBRAGE_HIGHP vec2 c) {
    return c.x * 0.125 + c.y;  // an exact product: fused or not, it rounds once
}
`,
            "receiver_ps14": `
// umbrage_receiver_ps14: depth * 256 / 255, the scale of umbrage_decode_ps14; beyond the far plane what every texel
//   lights
UMBRAGE_HIGHP float umbrage_receiver_ps14(UMBRAGE_HIGHP float depth) {
    return depth > 1.0 ? -1.0 : depth * 1.00392163;
}
`,
            "inside_map": `
// umbrage_inside_map: whether a texel is one of a map's of size texels
bool umbrage_inside_map(UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel) {
    return texel.x >= 0.0 && texel.y >= 0.0 && texel.x < size.x && texel.y < size.y;
}
`,
            "fetch_bordered": `
// umbrage_fetch_bordered: texel of a map, or border outside of it
UMBRAGE_HIGHP vec4 umbrage_fetch_bordered(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                          UMBRAGE_HIGHP vec4 border) {
    UMBRAGE_HIGHP vec2 at = clamp(texel, vec2(0.0, 0.0), size - 1.0);
    UMBRAGE_HIGHP vec4 value = umbrage_texel(map, size, at);
    return at.x == texel.x && at.y == texel.y ? value : border;
}
`,
            "fetch_depth": `
// umbrage_fetch_depth: stored depth of a texel, outside the map that of the far plane
UMBRAGE_HIGHP float umbrage_fetch_depth(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel) {
    UMBRAGE_HIGHP vec2 inside = clamp(texel, vec2(0.0, 0.0), size - 1.0);
    UMBRAGE_HIGHP vec4 value = umbrage_texel(map, size, inside);
    UMBRAGE_HIGHP float depth = UMBRAGE_DEPTH;
    return inside.x == texel.x && inside.y == texel.y ? depth : UMBRAGE_BORDER;
}
`,
            "depth_at": `
// umbrage_depth_at: stored depth of the texel at a point; on a border it may be the texel beside
//   uv  over the map, (0.0, 0.0) to (1.0, 1.0), no NaN
UMBRAGE_HIGHP float umbrage_depth_at(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 uv) {
    return umbrage_fetch_depth(map, size, floor(uv * size));
}
`,
            "beyond_far_plane": `
// umbrage_beyond_far_plane: whether a receiver is behind the far plane
bool umbrage_beyond_far_plane(UMBRAGE_HIGHP float receiver) {
    return receiver > 1.0;
}
`,
            "in_filter_domain": `
// umbrage_in_filter_domain: whether a filter compares; outside texel space and beyond the far plane all is lit
bool umbrage_in_filter_domain(UMBRAGE_HIGHP vec2 coord, UMBRAGE_HIGHP float receiver) {
    // a choice, not a && !b: of !(receiver > 1.0) FXC makes receiver <= 1.0, which loses a NaN
    return umbrage_beyond_far_plane(receiver) ? false : umbrage_inside_texel_space(coord);
}
`,
            "compare": `
// umbrage_compare: 1.0 when the receiver is no farther than the stored depth
UMBRAGE_HIGHP float umbrage_compare(UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float stored) {
    return receiver <= stored ? 1.0 : 0.0;
}
`,
            "lit": `
// umbrage_lit: visibility of one comparison with a texel
UMBRAGE_HIGHP float umbrage_lit(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                UMBRAGE_HIGHP float receiver) {
    return umbrage_compare(receiver, umbrage_fetch_depth(map, size, texel));
}
`,
            "lit_2x2": `
// umbrage_lit_2x2: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1)
UMBRAGE_HIGHP vec4 umbrage_lit_2x2(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                   UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP float a = umbrage_lit(map, size, texel, receiver);
    UMBRAGE_HIGHP float b = umbrage_lit(map, size, texel + vec2(1.0, 0.0), receiver);
    UMBRAGE_HIGHP float c = umbrage_lit(map, size, texel + vec2(0.0, 1.0), receiver);
    UMBRAGE_HIGHP float d = umbrage_lit(map, size, texel + vec2(1.0, 1.0), receiver);
    return vec4(a, b, c, d);
}
`,
            "map_covers": `
// umbrage_map_covers: whether a receiver of a prefiltered map or a table lies in the map; elsewhere it is lit
bool umbrage_map_covers(UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord) {
    return coord.x >= 0.0 && coord.y >= 0.0 && coord.x < size.x && coord.y < size.y;
}
`,
            "within_far_plane": `
// umbrage_within_far_plane: whether a receiver is a number, and not behind the far plane
bool umbrage_within_far_plane(UMBRAGE_HIGHP float receiver) {
    return receiver <= 1.0;
}
`,
            "compare_dx_sdk": `
// umbrage_compare_dx_sdk: 0.0 when stored + epsilon < receiver, else 1.0
UMBRAGE_HIGHP float umbrage_compare_dx_sdk(UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float stored,
                                           UMBRAGE_HIGHP float epsilon) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float limit = stored + epsilon;
    return limit < receiver ? 0.0 : 1.0;
}
`,
            "compare_exercise": `
// umbrage_compare_exercise: 1.0 when current < stored + epsilon, else 0.0
UMBRAGE_HIGHP float umbrage_compare_exercise(UMBRAGE_HIGHP float current, UMBRAGE_HIGHP float stored,
                                             UMBRAGE_HIGHP float epsilon) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float limit = stored + epsilon;
    return current < limit ? 1.0 : 0.0;
}
`,
            "window_sum3": `
// umbrage_window_sum3: weighted count of the lit texels under weights that slide over the map, whole
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   steps  of a texel, a power of two up to 256
//   k0 .. k1   weights from the edge to the middle one; the others mirror them. Steps times their sum, a whole number
//              up to 4096, squared is what is wholly lit
UMBRAGE_HIGHP float umbrage_window_sum3(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                        UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float steps, UMBRAGE_HIGHP float k0,
                                        UMBRAGE_HIGHP float k1) {
    bool compared = umbrage_in_filter_domain(coord, receiver);  // no branch: fetches overlap
    UMBRAGE_HIGHP vec2 x = compared ? floor(coord * 256.0) - 128.0 : vec2(0.0, 0.0);
    UMBRAGE_HIGHP vec2 texel = floor(x * (1.0 / 256.0));
    UMBRAGE_HIGHP vec2 s = floor((x - texel * 256.0) * (1.0 / 256.0) * steps);
    UMBRAGE_HIGHP vec2 r = steps - s;
    UMBRAGE_HIGHP float whole = steps * (k0 + k1 + k0);
    UMBRAGE_HIGHP vec2 w0 = floor(r * k0);
    UMBRAGE_HIGHP vec2 w2 = floor(r * k0 + s * k1);
    UMBRAGE_HIGHP vec2 w3 = floor(s * k0);
    UMBRAGE_HIGHP vec2 w1 = max(whole - (w0 + w2 + w3), vec2(0.0, 0.0));
    UMBRAGE_HIGHP vec2 first = texel - 1.0;
    UMBRAGE_HIGHP float n = 0.0;
    UMBRAGE_HIGHP vec4 a = umbrage_lit_2x2(map, size, first + vec2(0.0, 0.0), receiver);
    UMBRAGE_HIGHP vec4 b = umbrage_lit_2x2(map, size, first + vec2(2.0, 0.0), receiver);
    n += w0.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y);
    n += w1.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w);
    a = umbrage_lit_2x2(map, size, first + vec2(0.0, 2.0), receiver);
    b = umbrage_lit_2x2(map, size, first + vec2(2.0, 2.0), receiver);
    n += w2.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y);
    n += w3.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w);
    return compared ? n : whole * whole;
}
`,
            "window_sum5": `
// umbrage_window_sum5: weighted count of the lit texels under weights that slide over the map, whole
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   steps  of a texel, a power of two up to 256
//   k0 .. k2   weights from the edge to the middle one; the others mirror them. Steps times their sum, a whole number
//              up to 4096, squared is what is wholly lit
UMBRAGE_HIGHP float umbrage_window_sum5(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                        UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float steps, UMBRAGE_HIGHP float k0,
                                        UMBRAGE_HIGHP float k1, UMBRAGE_HIGHP float k2) {
    bool compared = umbrage_in_filter_domain(coord, receiver);  // no branch: fetches overlap
    UMBRAGE_HIGHP vec2 x = compared ? floor(coord * 256.0) - 128.0 : vec2(0.0, 0.0);
    UMBRAGE_HIGHP vec2 texel = floor(x * (1.0 / 256.0));
    UMBRAGE_HIGHP vec2 s = floor((x - texel * 256.0) * (1.0 / 256.0) * steps);
    UMBRAGE_HIGHP vec2 r = steps - s;
    UMBRAGE_HIGHP float whole = steps * (k0 + k1 + k2 + k1 + k0);
    UMBRAGE_HIGHP vec2 w0 = floor(r * k0);
    UMBRAGE_HIGHP vec2 w1 = floor(r * k1 + s * k0);
    UMBRAGE_HIGHP vec2 w3 = floor(r * k1 + s * k2);
    UMBRAGE_HIGHP vec2 w4 = floor(r * k0 + s * k1);
    UMBRAGE_HIGHP vec2 w5 = floor(s * k0);
    UMBRAGE_HIGHP vec2 w2 = max(whole - (w0 + w1 + w3 + w4 + w5), vec2(0.0, 0.0));
    UMBRAGE_HIGHP vec2 first = texel - 2.0;
    UMBRAGE_HIGHP float n = 0.0;
    UMBRAGE_HIGHP vec4 a = umbrage_lit_2x2(map, size, first + vec2(0.0, 0.0), receiver);
    UMBRAGE_HIGHP vec4 b = umbrage_lit_2x2(map, size, first + vec2(2.0, 0.0), receiver);
    UMBRAGE_HIGHP vec4 c = umbrage_lit_2x2(map, size, first + vec2(4.0, 0.0), receiver);
    n += w0.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y);
    n += w1.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w);
    a = umbrage_lit_2x2(map, size, first + vec2(0.0, 2.0), receiver);
    b = umbrage_lit_2x2(map, size, first + vec2(2.0, 2.0), receiver);
    c = umbrage_lit_2x2(map, size, first + vec2(4.0, 2.0), receiver);
    n += w2.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y);
    n += w3.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w);
    a = umbrage_lit_2x2(map, size, first + vec2(0.0, 4.0), receiver);
    b = umbrage_lit_2x2(map, size, first + vec2(2.0, 4.0), receiver);
    c = umbrage_lit_2x2(map, size, first + vec2(4.0, 4.0), receiver);
    n += w4.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y);
    n += w5.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w);
    return compared ? n : whole * whole;
}
`,
            "window_sum7": `
// umbrage_window_sum7: weighted count of the lit texels under weights that slide over the map, whole
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   steps  of a texel, a power of two up to 256
//   k0 .. k3   weights from the edge to the middle one; the others mirror them. Steps times their sum, a whole number
//              up to 4096, squared is what is wholly lit
UMBRAGE_HIGHP float umbrage_window_sum7(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                        UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float steps, UMBRAGE_HIGHP float k0,
                                        UMBRAGE_HIGHP float k1, UMBRAGE_HIGHP float k2, UMBRAGE_HIGHP float k3) {
    bool compared = umbrage_in_filter_domain(coord, receiver);  // no branch: fetches overlap
    UMBRAGE_HIGHP vec2 x = compared ? floor(coord * 256.0) - 128.0 : vec2(0.0, 0.0);
    UMBRAGE_HIGHP vec2 texel = floor(x * (1.0 / 256.0));
    UMBRAGE_HIGHP vec2 s = floor((x - texel * 256.0) * (1.0 / 256.0) * steps);
    UMBRAGE_HIGHP vec2 r = steps - s;
    UMBRAGE_HIGHP float whole = steps * (k0 + k1 + k2 + k3 + k2 + k1 + k0);
    UMBRAGE_HIGHP vec2 w0 = floor(r * k0);
    UMBRAGE_HIGHP vec2 w1 = floor(r * k1 + s * k0);
    UMBRAGE_HIGHP vec2 w2 = floor(r * k2 + s * k1);
    UMBRAGE_HIGHP vec2 w4 = floor(r * k2 + s * k3);
    UMBRAGE_HIGHP vec2 w5 = floor(r * k1 + s * k2);
    UMBRAGE_HIGHP vec2 w6 = floor(r * k0 + s * k1);
    UMBRAGE_HIGHP vec2 w7 = floor(s * k0);
    UMBRAGE_HIGHP vec2 w3 = max(whole - (w0 + w1 + w2 + w4 + w5 + w6 + w7), vec2(0.0, 0.0));
    UMBRAGE_HIGHP vec2 first = texel - 3.0;
    UMBRAGE_HIGHP float n = 0.0;
    UMBRAGE_HIGHP vec4 a = umbrage_lit_2x2(map, size, first + vec2(0.0, 0.0), receiver);
    UMBRAGE_HIGHP vec4 b = umbrage_lit_2x2(map, size, first + vec2(2.0, 0.0), receiver);
    UMBRAGE_HIGHP vec4 c = umbrage_lit_2x2(map, size, first + vec2(4.0, 0.0), receiver);
    UMBRAGE_HIGHP vec4 d = umbrage_lit_2x2(map, size, first + vec2(6.0, 0.0), receiver);
    n += w0.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y + w6.x * d.x + w7.x * d.y);
    n += w1.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w + w6.x * d.z + w7.x * d.w);
    a = umbrage_lit_2x2(map, size, first + vec2(0.0, 2.0), receiver);
    b = umbrage_lit_2x2(map, size, first + vec2(2.0, 2.0), receiver);
    c = umbrage_lit_2x2(map, size, first + vec2(4.0, 2.0), receiver);
    d = umbrage_lit_2x2(map, size, first + vec2(6.0, 2.0), receiver);
    n += w2.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y + w6.x * d.x + w7.x * d.y);
    n += w3.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w + w6.x * d.z + w7.x * d.w);
    a = umbrage_lit_2x2(map, size, first + vec2(0.0, 4.0), receiver);
    b = umbrage_lit_2x2(map, size, first + vec2(2.0, 4.0), receiver);
    c = umbrage_lit_2x2(map, size, first + vec2(4.0, 4.0), receiver);
    d = umbrage_lit_2x2(map, size, first + vec2(6.0, 4.0), receiver);
    n += w4.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y + w6.x * d.x + w7.x * d.y);
    n += w5.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w + w6.x * d.z + w7.x * d.w);
    a = umbrage_lit_2x2(map, size, first + vec2(0.0, 6.0), receiver);
    b = umbrage_lit_2x2(map, size, first + vec2(2.0, 6.0), receiver);
    c = umbrage_lit_2x2(map, size, first + vec2(4.0, 6.0), receiver);
    d = umbrage_lit_2x2(map, size, first + vec2(6.0, 6.0), receiver);
    n += w6.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y + w6.x * d.x + w7.x * d.y);
    n += w7.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w + w6.x * d.z + w7.x * d.w);
    return compared ? n : whole * whole;
}
`,
            "disc_rotation": `
// umbrage_disc_rotation: (cos, sin) in 1/64 of one of 16 turns for a pixel, such as gl_FragCoord.xy: each once in 4 x 4
UMBRAGE_HIGHP vec2 umbrage_disc_rotation(UMBRAGE_HIGHP vec2 pixel) {
    UMBRAGE_HIGHP vec2 whole = umbrage_inside_texel_space(pixel) ? floor(pixel) : vec2(0.0, 0.0);
    UMBRAGE_HIGHP float v = whole.x * 4.0 + whole.y;
    v = v - floor(v * (1.0 / 16.0)) * 16.0;
    UMBRAGE_HIGHP float quarter = floor(v * 0.25);
    UMBRAGE_HIGHP float base = v - quarter * 4.0;
    UMBRAGE_HIGHP vec2 low = base < 0.5 ? vec2(64.0, 0.0) : vec2(59.0, 24.0);
    UMBRAGE_HIGHP vec2 high = base < 2.5 ? vec2(45.0, 45.0) : vec2(24.0, 59.0);
    UMBRAGE_HIGHP vec2 first = base < 1.5 ? low : high;
    UMBRAGE_HIGHP vec2 once = quarter < 0.5 ? first : vec2(0.0 - first.y, first.x);
    UMBRAGE_HIGHP vec2 twice = quarter < 2.5 ? vec2(0.0 - first.x, 0.0 - first.y) : vec2(first.y, 0.0 - first.x);
    return quarter < 1.5 ? once : twice;
}
`,
            "disc_tap": `
// umbrage_disc_tap: the texel that a point of a disc falls on
//   position  floor(256 coord) of the receiver;   p  point, in 1/16 of the radius;   rotation  of umbrage_disc_rotation
//   radius    in 1/16 texel, a whole number from 0 to 4095
UMBRAGE_HIGHP vec2 umbrage_disc_tap(UMBRAGE_HIGHP vec2 position, UMBRAGE_HIGHP vec2 p, UMBRAGE_HIGHP vec2 rotation,
                                    UMBRAGE_HIGHP float radius) {
    UMBRAGE_HIGHP vec2 at = position * (1.0 / 256.0);
    UMBRAGE_HIGHP vec2 texel = floor(at);
    UMBRAGE_HIGHP vec2 within = clamp(at - texel, vec2(0.0, 0.0), vec2(1.0, 1.0));  // no sum is regrouped across it
    UMBRAGE_HIGHP vec2 scaled = rotation * (radius * (1.0 / 16384.0));
    UMBRAGE_HIGHP float x = scaled.x * p.x + within.x - scaled.y * p.y;
    UMBRAGE_HIGHP float y = scaled.y * p.x + within.y + scaled.x * p.y;
    return texel + floor(vec2(x, y));
}
`,
            "disc_radius": `
// umbrage_disc_radius: a disc's radius in 1/16 texel, from one in texels: a whole number from 0 to 4095, of a NaN 0
UMBRAGE_HIGHP float umbrage_disc_radius(UMBRAGE_HIGHP float radius) {
    UMBRAGE_HIGHP float inside = radius > 0.0 ? floor(radius * 16.0) : 0.0;
    return radius >= 255.9375 ? 4095.0 : inside;
}
`,
            "disc8": `
// umbrage_disc8: lit share of 8 points of a disc; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   radius  in texels, at most 255.9375;   rotation  umbrage_disc_rotation of the pixel
UMBRAGE_HIGHP float umbrage_disc8(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                   UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float radius,
                                   UMBRAGE_HIGHP vec2 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    UMBRAGE_HIGHP vec2 at = compared ? floor(coord * 256.0) : vec2(0.0, 0.0);  // no branch: fetches overlap
    UMBRAGE_HIGHP float rho = umbrage_disc_radius(radius);
    UMBRAGE_HIGHP float n = 0.0;
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(3.0, -1.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(-4.0, 5.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(1.0, -11.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(-9.0, -8.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(-12.0, 3.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(11.0, 6.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(0.0, 13.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(11.0, -7.0), rotation, rho), receiver);
    return compared ? n * (1.0 / 8.0) : 1.0;
}
`,
            "disc16": `
// umbrage_disc16: lit share of 16 points of a disc; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   radius  in texels, at most 255.9375;   rotation  umbrage_disc_rotation of the pixel
UMBRAGE_HIGHP float umbrage_disc16(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                   UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float radius,
                                   UMBRAGE_HIGHP vec2 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    UMBRAGE_HIGHP vec2 at = compared ? floor(coord * 256.0) : vec2(0.0, 0.0);  // no branch: fetches overlap
    UMBRAGE_HIGHP float rho = umbrage_disc_radius(radius);
    UMBRAGE_HIGHP float n = 0.0;
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(1.0, -3.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(5.0, 2.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(-5.0, 2.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(0.0, 7.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(-6.0, -5.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(8.0, -5.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(0.0, -11.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(11.0, 5.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(-12.0, 4.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(-1.0, 13.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(7.0, 11.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(-9.0, 10.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(-13.0, -4.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(7.0, -12.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(-7.0, -12.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(14.0, -2.0), rotation, rho), receiver);
    return compared ? n * (1.0 / 16.0) : 1.0;
}
`,
            "disc32": `
// umbrage_disc32: lit share of 32 points of a disc; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   radius  in texels, at most 255.9375;   rotation  umbrage_disc_rotation of the pixel
UMBRAGE_HIGHP float umbrage_disc32(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                   UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float radius,
                                   UMBRAGE_HIGHP vec2 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    UMBRAGE_HIGHP vec2 at = compared ? floor(coord * 256.0) : vec2(0.0, 0.0);  // no branch: fetches overlap
    UMBRAGE_HIGHP float rho = umbrage_disc_radius(radius);
    UMBRAGE_HIGHP float n = 0.0;
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(-2.0, -1.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(3.0, 2.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(1.0, -4.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(-4.0, 3.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(0.0, 6.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(-5.0, -5.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(7.0, -2.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(-8.0, -1.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(8.0, 3.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(5.0, 7.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(1.0, -9.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(6.0, -7.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(-8.0, 5.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(0.0, 10.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(-3.0, -10.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(-6.0, 10.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(-9.0, -8.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(11.0, -5.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(5.0, -12.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(-13.0, -1.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(7.0, 11.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(13.0, 3.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(-13.0, 4.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(10.0, -10.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(14.0, -2.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(-11.0, 9.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(3.0, 14.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(-13.0, -6.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(12.0, 8.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(-4.0, 14.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(-7.0, -13.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2(0.0, -15.0), rotation, rho), receiver);
    return compared ? n * (1.0 / 32.0) : 1.0;
}
`,
            "hard": `
// umbrage_hard: unfiltered shadow test; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased
UMBRAGE_HIGHP float umbrage_hard(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                 UMBRAGE_HIGHP float receiver) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    UMBRAGE_HIGHP vec2 texel = compared ? floor(coord) : vec2(0.0, 0.0);  // no branch: fetches of several taps overlap
    UMBRAGE_HIGHP float lit = umbrage_lit(map, size, texel, receiver);
    return compared ? lit : 1.0;
}
`,
            "four_tap": `
// umbrage_four_tap: mean of the shadow test at four taps; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   a, b, c, d  taps in texels, all lit where their mean is 2^15
//   or more in a direction;   receiver  depth, biased
UMBRAGE_HIGHP float umbrage_four_tap(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 a,
                                     UMBRAGE_HIGHP vec2 b, UMBRAGE_HIGHP vec2 c, UMBRAGE_HIGHP vec2 d,
                                     UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 a_texel = floor(a);
    UMBRAGE_HIGHP vec2 b_texel = floor(b);
    UMBRAGE_HIGHP vec2 c_texel = floor(c);
    UMBRAGE_HIGHP vec2 d_texel = floor(d);
    UMBRAGE_HIGHP vec2 sum = abs(a_texel) + abs(b_texel) + abs(c_texel) + abs(d_texel);
    // two limits on purpose: Mesa makes max(x, y) < limit of one, which loses a NaN
    bool compared = umbrage_beyond_far_plane(receiver) ? false : sum.x < 131072.0 && sum.y * 2.0 < 262144.0;
    UMBRAGE_HIGHP float count = umbrage_lit(map, size, a_texel, receiver) + umbrage_lit(map, size, b_texel, receiver) +
                                umbrage_lit(map, size, c_texel, receiver) + umbrage_lit(map, size, d_texel, receiver);
    return compared ? count * 0.25 : 1.0;
}
`,
            "pcf_2x2": `
// umbrage_pcf_2x2: bilinear percentage-closer filtering; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased
UMBRAGE_HIGHP float umbrage_pcf_2x2(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                    UMBRAGE_HIGHP float receiver) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    UMBRAGE_HIGHP vec2 x = compared ? floor(coord * 256.0) - 128.0 : vec2(0.0, 0.0);  // no branch: fetches overlap
    UMBRAGE_HIGHP vec2 texel = floor(x * (1.0 / 256.0));
    // weights are in [0, 1) already; compilers cannot regroup sums across the clamp
    UMBRAGE_HIGHP vec2 hi = clamp(x * (1.0 / 256.0) - texel, vec2(0.0, 0.0), vec2(1.0, 1.0));
    UMBRAGE_HIGHP vec2 lo = 1.0 - hi;
    UMBRAGE_HIGHP vec4 lit = umbrage_lit_2x2(map, size, texel, receiver);
    UMBRAGE_HIGHP float visibility = lo.y * (lo.x * lit.x + hi.x * lit.y) + hi.y * (lo.x * lit.z + hi.x * lit.w);
    return compared ? visibility : 1.0;
}
`,
            "pcf_2x2_dx_sdk": `
// umbrage_pcf_2x2_dx_sdk: the DirectX SDK sample's 2x2 filter; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, not biased;   epsilon  in depth, added to the stored side
UMBRAGE_HIGHP float umbrage_pcf_2x2_dx_sdk(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                           UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float epsilon) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 x = compared ? coord - 0.5 : vec2(0.0, 0.0);  // no branch: fetches overlap
    UMBRAGE_HIGHP vec2 texel = floor(x);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 weight = x - texel;
    UMBRAGE_HIGHP float a = umbrage_compare_dx_sdk(receiver, umbrage_fetch_depth(map, size, texel), epsilon);
    UMBRAGE_HIGHP float right = umbrage_fetch_depth(map, size, texel + vec2(1.0, 0.0));
    UMBRAGE_HIGHP float above = umbrage_fetch_depth(map, size, texel + vec2(0.0, 1.0));
    UMBRAGE_HIGHP float beyond = umbrage_fetch_depth(map, size, texel + vec2(1.0, 1.0));
    UMBRAGE_HIGHP float b = umbrage_compare_dx_sdk(receiver, right, epsilon);
    UMBRAGE_HIGHP float c = umbrage_compare_dx_sdk(receiver, above, epsilon);
    UMBRAGE_HIGHP float d = umbrage_compare_dx_sdk(receiver, beyond, epsilon);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float low = a + weight.x * (b - a);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float high = c + weight.x * (d - c);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float visibility = low + weight.y * (high - low);
    return compared ? visibility : 1.0;
}
`,
            "box_count": `
// umbrage_box_count: lit texels in the (2r+1) x (2r+1) box around the receiver's own, a whole number
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   radius  r, clamped to 0..8, best a constant
UMBRAGE_HIGHP float umbrage_box_count(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                      UMBRAGE_HIGHP float receiver, int radius) {
    int r = radius < 0 ? 0 : (radius < 8 ? radius : 8);
    int width = 2 * r + 1;
    bool compared = umbrage_in_filter_domain(coord, receiver);
    UMBRAGE_HIGHP vec2 first = compared ? floor(coord) - float(r) : vec2(0.0, 0.0);
    UMBRAGE_HIGHP float count = 0.0;
    for (int j = 0; j < 17; j++) {
        if (j >= width) break;
        for (int i = 0; i < 17; i++) {
            if (i >= width) break;
            count += umbrage_lit(map, size, first + vec2(float(i), float(j)), receiver);
        }
    }
    return compared ? count : float(width * width);
}
`,
            "box_scale": `
// umbrage_box_scale: 1 / (2r+1)^2, rounded to nearest
UMBRAGE_HIGHP float umbrage_box_scale(int radius) {
    UMBRAGE_HIGHP float scale = 0.00346020772;  // not returned as a literal: that would have the host's precision
    if (radius < 8) scale = 0.00444444455;
    if (radius < 7) scale = 0.00591715984;
    if (radius < 6) scale = 0.00826446246;
    if (radius < 5) scale = 0.0123456791;
    if (radius < 4) scale = 0.0204081628;
    if (radius < 3) scale = 0.0399999991;
    if (radius < 2) scale = 0.111111112;
    if (radius < 1) scale = 1.0;
    return scale;
}
`,
            "box": `
// umbrage_box: lit share of a (2r+1) x (2r+1) box; visibility, 1.0 is lit; arguments as for umbrage_box_count
UMBRAGE_HIGHP float umbrage_box(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                UMBRAGE_HIGHP float receiver, int radius) {
    UMBRAGE_HIGHP float visibility = umbrage_box_count(map, size, coord, receiver, radius) * umbrage_box_scale(radius);
    return visibility < 0.999 ? visibility : 1.0;  // 121 times the rounded 1/121 is not 1
}
`,
            "tent2": `
// umbrage_tent2: lit share of 3 x 3 texels, the window 1 1; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased
UMBRAGE_HIGHP float umbrage_tent2(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                               UMBRAGE_HIGHP float receiver) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    UMBRAGE_HIGHP vec2 x = compared ? floor(coord * 256.0) : vec2(0.0, 0.0);  // no branch: fetches overlap
    UMBRAGE_HIGHP vec2 texel = floor(x * (1.0 / 256.0));
    // s is in [0, 256) already, w1 not negative; compilers cannot regroup sums across clamp and max
    UMBRAGE_HIGHP vec2 s = clamp(x * (1.0 / 256.0) - texel, vec2(0.0, 0.0), vec2(1.0, 1.0)) * 256.0;
    UMBRAGE_HIGHP vec2 r = 256.0 - s;
    UMBRAGE_HIGHP vec2 w0 = r * 8.0;
    UMBRAGE_HIGHP vec2 w2 = s * 8.0;
    UMBRAGE_HIGHP vec2 w1 = max(4096.0 - w0 - w2, vec2(0.0, 0.0));
    UMBRAGE_HIGHP vec4 a = umbrage_lit_2x2(map, size, texel - 1.0, receiver);
    UMBRAGE_HIGHP vec4 b = umbrage_lit_2x2(map, size, texel + vec2(1.0, -1.0), receiver);
    UMBRAGE_HIGHP vec4 c = umbrage_lit_2x2(map, size, texel + vec2(-1.0, 1.0), receiver);
    UMBRAGE_HIGHP vec4 d = umbrage_lit_2x2(map, size, texel + vec2(1.0, 1.0), receiver);
    UMBRAGE_HIGHP float n = w0.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x);
    n += w1.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z);
    n += w2.y * (w0.x * c.x + w1.x * c.y + w2.x * d.x);
    return compared ? n * (1.0 / 16777216.0) : 1.0;
}
`,
            "tent3": `
// umbrage_tent3: lit share under 3 x 3 weights, 1 2 1, that slide over the map; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased
UMBRAGE_HIGHP float umbrage_tent3(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                 UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP float n = umbrage_window_sum3(map, size, coord, receiver, 256.0, 4.0, 8.0);
    return clamp(n * (1.0 / 16777216.0), 0.0, 1.0);
}
`,
            "quadratic_b_spline": `
// umbrage_quadratic_b_spline: lit share of 3 x 3 texels, weighed by the quadratic B-spline; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased
UMBRAGE_HIGHP float umbrage_quadratic_b_spline(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                               UMBRAGE_HIGHP float receiver) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    UMBRAGE_HIGHP vec2 x = compared ? floor(coord * 256.0) : vec2(0.0, 0.0);  // no branch: fetches overlap
    UMBRAGE_HIGHP vec2 texel = floor(x * (1.0 / 256.0));
    // s is in [0, 256) already, w1 not negative; compilers cannot regroup sums across clamp and max
    UMBRAGE_HIGHP vec2 s = clamp(x * (1.0 / 256.0) - texel, vec2(0.0, 0.0), vec2(1.0, 1.0)) * 256.0;
    UMBRAGE_HIGHP vec2 r = 256.0 - s;
    UMBRAGE_HIGHP vec2 w0 = floor(r * r * (1.0 / 32.0));
    UMBRAGE_HIGHP vec2 w2 = floor(s * s * (1.0 / 32.0));
    UMBRAGE_HIGHP vec2 w1 = max(4096.0 - w0 - w2, vec2(0.0, 0.0));
    UMBRAGE_HIGHP vec4 a = umbrage_lit_2x2(map, size, texel - 1.0, receiver);
    UMBRAGE_HIGHP vec4 b = umbrage_lit_2x2(map, size, texel + vec2(1.0, -1.0), receiver);
    UMBRAGE_HIGHP vec4 c = umbrage_lit_2x2(map, size, texel + vec2(-1.0, 1.0), receiver);
    UMBRAGE_HIGHP vec4 d = umbrage_lit_2x2(map, size, texel + vec2(1.0, 1.0), receiver);
    UMBRAGE_HIGHP float n = w0.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x);
    n += w1.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z);
    n += w2.y * (w0.x * c.x + w1.x * c.y + w2.x * d.x);
    return compared ? n * (1.0 / 16777216.0) : 1.0;
}
`,
            "binomial5": `
// umbrage_binomial5: lit share under 5 x 5 weights, 1 4 6 4 1, that slide over the map; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased
UMBRAGE_HIGHP float umbrage_binomial5(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                 UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP float n = umbrage_window_sum5(map, size, coord, receiver, 256.0, 1.0, 4.0, 6.0);
    return clamp(n * (1.0 / 16777216.0), 0.0, 1.0);
}
`,
            "castano_dyadic5": `
// umbrage_castano_dyadic5: lit share under 5 x 5 weights, 5 16 22 16 5, that slide over the map; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased
UMBRAGE_HIGHP float umbrage_castano_dyadic5(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                 UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP float n = umbrage_window_sum5(map, size, coord, receiver, 256.0, 1.25, 4.0, 5.5);
    return clamp(n * (1.0 / 16777216.0), 0.0, 1.0);
}
`,
            "castano5": `
// umbrage_castano5: lit share under 5 x 5 weights, 1 3 4 3 1, that slide over the map; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased
UMBRAGE_HIGHP float umbrage_castano5(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                 UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP float n = umbrage_window_sum5(map, size, coord, receiver, 256.0, 1.0, 3.0, 4.0);
    return n < 9437184.0 ? n * (1.0 / 65536.0) * 0.00694444450 : 1.0;
}
`,
            "binomial7": `
// umbrage_binomial7: lit share under 7 x 7 weights, 1 6 15 20 15 6 1, that slide over the map; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased
UMBRAGE_HIGHP float umbrage_binomial7(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                 UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP float n = umbrage_window_sum7(map, size, coord, receiver, 256.0, 0.25, 1.5, 3.75, 5.0);
    return clamp(n * (1.0 / 16777216.0), 0.0, 1.0);
}
`,
            "tent7": `
// umbrage_tent7: lit share under 7 x 7 weights, 1 2 3 4 3 2 1, that slide over the map; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased
UMBRAGE_HIGHP float umbrage_tent7(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                 UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP float n = umbrage_window_sum7(map, size, coord, receiver, 256.0, 1.0, 2.0, 3.0, 4.0);
    return clamp(n * (1.0 / 16777216.0), 0.0, 1.0);
}
`,
            "castano7": `
// umbrage_castano7: lit share under 7 x 7 weights, 1 5 12 16 12 5 1, that slide over the map; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased
UMBRAGE_HIGHP float umbrage_castano7(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                 UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP float n = umbrage_window_sum7(map, size, coord, receiver, 64.0, 1.0, 5.0, 12.0, 16.0);
    return n < 11075584.0 ? n * (1.0 / 4096.0) * 0.000369822490 : 1.0;
}
`,
            "cube_lit": `
// umbrage_cube_lit: (visibility of one comparison, 1.0) with a texel of a cube, (0.0, 0.0) beyond a corner
//   map, size  atlas of 3 x 2 faces and its size in texels;   texel  (s, t, face), whole numbers
UMBRAGE_HIGHP vec2 umbrage_cube_lit(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec3 texel,
                                    UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP float side = size.y * 0.5;
    UMBRAGE_HIGHP vec3 n = umbrage_cube_neighbor(texel, side);
    UMBRAGE_HIGHP vec2 at = umbrage_cube_tile(n.z, side) + vec2(n.x, n.y);
    UMBRAGE_HIGHP float lit = umbrage_lit(map, size, at, receiver);
    return n.z < 0.0 ? vec2(0.0, 0.0) : vec2(lit, 1.0);
}
`,
            "pcf_2x2_cube": `
// umbrage_pcf_2x2_cube: bilinear percentage-closer filtering over a cube's edges; visibility, 1.0 is lit
//   map, size  atlas of 3 x 2 faces and its size in texels;   at  (s, t, face): texels of the face, from 0.0 on
//   receiver   distance from the light, biased
UMBRAGE_HIGHP float umbrage_pcf_2x2_cube(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec3 at,
                                         UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 coord = vec2(at.x, at.y);
    bool compared = umbrage_in_filter_domain(coord, receiver);
    UMBRAGE_HIGHP vec2 x = compared ? floor(coord * 256.0 + 0.5) - 128.0 : vec2(0.0, 0.0);
    UMBRAGE_HIGHP vec2 texel = floor(x * (1.0 / 256.0));
    // weights are in [0, 1) already; compilers cannot regroup sums across the clamp
    UMBRAGE_HIGHP vec2 hi = clamp(x * (1.0 / 256.0) - texel, vec2(0.0, 0.0), vec2(1.0, 1.0));
    UMBRAGE_HIGHP vec2 lo = 1.0 - hi;
    UMBRAGE_HIGHP vec2 sum = umbrage_cube_lit(map, size, vec3(texel, at.z), receiver) * (lo.x * lo.y);
    sum += umbrage_cube_lit(map, size, vec3(texel + vec2(1.0, 0.0), at.z), receiver) * (hi.x * lo.y);
    sum += umbrage_cube_lit(map, size, vec3(texel + vec2(0.0, 1.0), at.z), receiver) * (lo.x * hi.y);
    sum += umbrage_cube_lit(map, size, vec3(texel + vec2(1.0, 1.0), at.z), receiver) * (hi.x * hi.y);
    return compared && sum.y > 0.0 ? sum.x / sum.y : 1.0;
}
`,
            "four_tap_hardware": `
// umbrage_four_tap_hardware: mean of the shadow test at four taps of the sampler's; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   a, b, c, d  taps, (0.0, 0.0) to (1.0, 1.0) over the map, all lit
//   where the mean of |x| + |y| is 2^15 texels or more;   receiver  depth, biased
UMBRAGE_HIGHP float umbrage_four_tap_hardware(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 a,
                                              UMBRAGE_HIGHP vec2 b, UMBRAGE_HIGHP vec2 c, UMBRAGE_HIGHP vec2 d,
                                              UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 sum = (abs(a) + abs(b) + abs(c) + abs(d)) * size;
    bool compared = umbrage_beyond_far_plane(receiver) ? false : sum.x + sum.y < 131072.0;
    UMBRAGE_HIGHP float count = umbrage_compare(receiver, umbrage_depth_at(map, size, a)) +
                                umbrage_compare(receiver, umbrage_depth_at(map, size, b)) +
                                umbrage_compare(receiver, umbrage_depth_at(map, size, c)) +
                                umbrage_compare(receiver, umbrage_depth_at(map, size, d));
    return compared ? count * 0.25 : 1.0;
}
`,
            "lit_filtered": `
// umbrage_lit_filtered: 2x2 comparisons around a point; this map has no sampler to weigh them; visibility, 1.0 is lit
//   coord  in texels, no NaN; what is outside texel space counts as its border
UMBRAGE_HIGHP float umbrage_lit_filtered(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                         UMBRAGE_HIGHP float receiver) {
    return umbrage_pcf_2x2(map, size, clamp(coord, vec2(-32767.0, -32767.0), vec2(32767.0, 32767.0)), receiver);
}
`,
            "lit_at": `
// umbrage_lit_at: 2x2 comparisons around a point, weighted; visibility, 1.0 is lit
//   uv  over the map, (0.0, 0.0) to (1.0, 1.0), no NaN
UMBRAGE_HIGHP float umbrage_lit_at(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 uv,
                                   UMBRAGE_HIGHP float receiver) {
    return umbrage_lit_filtered(map, size, uv * size, receiver);
}
`,
            "pcf_2x2_hardware": `
// umbrage_pcf_2x2_hardware: 2x2 comparisons, weighted by the sampler; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased
UMBRAGE_HIGHP float umbrage_pcf_2x2_hardware(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                             UMBRAGE_HIGHP float receiver) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    UMBRAGE_HIGHP vec2 at = compared ? coord : vec2(0.0, 0.0);
    UMBRAGE_HIGHP float lit = umbrage_lit_at(map, size, at / size, receiver);
    UMBRAGE_HIGHP float visibility = umbrage_within_far_plane(receiver) ? lit : 0.0;
    return compared ? visibility : 1.0;
}
`,
            "window_hardware3": `
// umbrage_window_hardware3: lit share under weights that slide over the map, by the sampler; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   k0 .. k1  weights from the edge to the middle one; the others mirror them
UMBRAGE_HIGHP float umbrage_window_hardware3(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                             UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float k0,
                                             UMBRAGE_HIGHP float k1) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    UMBRAGE_HIGHP vec2 x = compared ? coord - 0.5 : vec2(0.0, 0.0);
    UMBRAGE_HIGHP vec2 texel = floor(x);
    UMBRAGE_HIGHP vec2 s = x - texel;
    UMBRAGE_HIGHP float whole = k0 + k1 + k0;
    UMBRAGE_HIGHP vec2 b0 = k1 + s * (k0 - k1);
    UMBRAGE_HIGHP vec2 w0 = k0 + k1 - s * k1;
    UMBRAGE_HIGHP vec2 p0 = (texel - 0.5 + b0 / w0) / size;
    UMBRAGE_HIGHP vec2 b1 = s * k0;
    UMBRAGE_HIGHP vec2 w1 = k0 + s * k1;
    UMBRAGE_HIGHP vec2 p1 = (texel + 1.5 + b1 / w1) / size;
    UMBRAGE_HIGHP float n = 0.0;
    UMBRAGE_HIGHP float row = 0.0;
    row += w0.x * umbrage_lit_at(map, size, vec2(p0.x, p0.y), receiver);
    row += w1.x * umbrage_lit_at(map, size, vec2(p1.x, p0.y), receiver);
    n += w0.y * row;
    row = 0.0;
    row += w0.x * umbrage_lit_at(map, size, vec2(p0.x, p1.y), receiver);
    row += w1.x * umbrage_lit_at(map, size, vec2(p1.x, p1.y), receiver);
    n += w1.y * row;
    UMBRAGE_HIGHP float share = clamp(n / (whole * whole), 0.0, 1.0);
    UMBRAGE_HIGHP float visibility = umbrage_within_far_plane(receiver) ? share : 0.0;
    return compared ? visibility : 1.0;
}
`,
            "window_hardware5": `
// umbrage_window_hardware5: lit share under weights that slide over the map, by the sampler; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   k0 .. k2  weights from the edge to the middle one; the others mirror them
UMBRAGE_HIGHP float umbrage_window_hardware5(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                             UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float k0,
                                             UMBRAGE_HIGHP float k1, UMBRAGE_HIGHP float k2) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    UMBRAGE_HIGHP vec2 x = compared ? coord - 0.5 : vec2(0.0, 0.0);
    UMBRAGE_HIGHP vec2 texel = floor(x);
    UMBRAGE_HIGHP vec2 s = x - texel;
    UMBRAGE_HIGHP float whole = k0 + k1 + k2 + k1 + k0;
    UMBRAGE_HIGHP vec2 b0 = k1 + s * (k0 - k1);
    UMBRAGE_HIGHP vec2 w0 = k0 + k1 - s * k1;
    UMBRAGE_HIGHP vec2 p0 = (texel - 1.5 + b0 / w0) / size;
    UMBRAGE_HIGHP vec2 b1 = k1 + s * (k2 - k1);
    UMBRAGE_HIGHP vec2 w1 = vec2(k2 + k1, k2 + k1);
    UMBRAGE_HIGHP vec2 p1 = (texel + 0.5 + b1 / w1) / size;
    UMBRAGE_HIGHP vec2 b2 = s * k0;
    UMBRAGE_HIGHP vec2 w2 = k0 + s * k1;
    UMBRAGE_HIGHP vec2 p2 = (texel + 2.5 + b2 / w2) / size;
    UMBRAGE_HIGHP float n = 0.0;
    UMBRAGE_HIGHP float row = 0.0;
    row += w0.x * umbrage_lit_at(map, size, vec2(p0.x, p0.y), receiver);
    row += w1.x * umbrage_lit_at(map, size, vec2(p1.x, p0.y), receiver);
    row += w2.x * umbrage_lit_at(map, size, vec2(p2.x, p0.y), receiver);
    n += w0.y * row;
    row = 0.0;
    row += w0.x * umbrage_lit_at(map, size, vec2(p0.x, p1.y), receiver);
    row += w1.x * umbrage_lit_at(map, size, vec2(p1.x, p1.y), receiver);
    row += w2.x * umbrage_lit_at(map, size, vec2(p2.x, p1.y), receiver);
    n += w1.y * row;
    row = 0.0;
    row += w0.x * umbrage_lit_at(map, size, vec2(p0.x, p2.y), receiver);
    row += w1.x * umbrage_lit_at(map, size, vec2(p1.x, p2.y), receiver);
    row += w2.x * umbrage_lit_at(map, size, vec2(p2.x, p2.y), receiver);
    n += w2.y * row;
    UMBRAGE_HIGHP float share = clamp(n / (whole * whole), 0.0, 1.0);
    UMBRAGE_HIGHP float visibility = umbrage_within_far_plane(receiver) ? share : 0.0;
    return compared ? visibility : 1.0;
}
`,
            "window_hardware7": `
// umbrage_window_hardware7: lit share under weights that slide over the map, by the sampler; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   k0 .. k3  weights from the edge to the middle one; the others mirror them
UMBRAGE_HIGHP float umbrage_window_hardware7(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                             UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float k0,
                                             UMBRAGE_HIGHP float k1, UMBRAGE_HIGHP float k2, UMBRAGE_HIGHP float k3) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    UMBRAGE_HIGHP vec2 x = compared ? coord - 0.5 : vec2(0.0, 0.0);
    UMBRAGE_HIGHP vec2 texel = floor(x);
    UMBRAGE_HIGHP vec2 s = x - texel;
    UMBRAGE_HIGHP float whole = k0 + k1 + k2 + k3 + k2 + k1 + k0;
    UMBRAGE_HIGHP vec2 b0 = k1 + s * (k0 - k1);
    UMBRAGE_HIGHP vec2 w0 = k0 + k1 - s * k1;
    UMBRAGE_HIGHP vec2 p0 = (texel - 2.5 + b0 / w0) / size;
    UMBRAGE_HIGHP vec2 b1 = k3 + s * (k2 - k3);
    UMBRAGE_HIGHP vec2 w1 = k2 + k3 + s * (k1 - k3);
    UMBRAGE_HIGHP vec2 p1 = (texel - 0.5 + b1 / w1) / size;
    UMBRAGE_HIGHP vec2 b2 = k1 + s * (k2 - k1);
    UMBRAGE_HIGHP vec2 w2 = k2 + k1 + s * (k3 - k1);
    UMBRAGE_HIGHP vec2 p2 = (texel + 1.5 + b2 / w2) / size;
    UMBRAGE_HIGHP vec2 b3 = s * k0;
    UMBRAGE_HIGHP vec2 w3 = k0 + s * k1;
    UMBRAGE_HIGHP vec2 p3 = (texel + 3.5 + b3 / w3) / size;
    UMBRAGE_HIGHP float n = 0.0;
    UMBRAGE_HIGHP float row = 0.0;
    row += w0.x * umbrage_lit_at(map, size, vec2(p0.x, p0.y), receiver);
    row += w1.x * umbrage_lit_at(map, size, vec2(p1.x, p0.y), receiver);
    row += w2.x * umbrage_lit_at(map, size, vec2(p2.x, p0.y), receiver);
    row += w3.x * umbrage_lit_at(map, size, vec2(p3.x, p0.y), receiver);
    n += w0.y * row;
    row = 0.0;
    row += w0.x * umbrage_lit_at(map, size, vec2(p0.x, p1.y), receiver);
    row += w1.x * umbrage_lit_at(map, size, vec2(p1.x, p1.y), receiver);
    row += w2.x * umbrage_lit_at(map, size, vec2(p2.x, p1.y), receiver);
    row += w3.x * umbrage_lit_at(map, size, vec2(p3.x, p1.y), receiver);
    n += w1.y * row;
    row = 0.0;
    row += w0.x * umbrage_lit_at(map, size, vec2(p0.x, p2.y), receiver);
    row += w1.x * umbrage_lit_at(map, size, vec2(p1.x, p2.y), receiver);
    row += w2.x * umbrage_lit_at(map, size, vec2(p2.x, p2.y), receiver);
    row += w3.x * umbrage_lit_at(map, size, vec2(p3.x, p2.y), receiver);
    n += w2.y * row;
    row = 0.0;
    row += w0.x * umbrage_lit_at(map, size, vec2(p0.x, p3.y), receiver);
    row += w1.x * umbrage_lit_at(map, size, vec2(p1.x, p3.y), receiver);
    row += w2.x * umbrage_lit_at(map, size, vec2(p2.x, p3.y), receiver);
    row += w3.x * umbrage_lit_at(map, size, vec2(p3.x, p3.y), receiver);
    n += w3.y * row;
    UMBRAGE_HIGHP float share = clamp(n / (whole * whole), 0.0, 1.0);
    UMBRAGE_HIGHP float visibility = umbrage_within_far_plane(receiver) ? share : 0.0;
    return compared ? visibility : 1.0;
}
`,
            "disc_hardware8": `
// umbrage_disc_hardware8: 8 points of a disc, each compared and weighted by the sampler; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   radius  in texels, at most 255.9375;   rotation  umbrage_disc_rotation of the pixel
UMBRAGE_HIGHP float umbrage_disc_hardware8(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                            UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float radius,
                                            UMBRAGE_HIGHP vec2 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    UMBRAGE_HIGHP vec2 center = (compared ? coord : vec2(0.0, 0.0)) / size;
    UMBRAGE_HIGHP vec2 scaled = rotation * ((radius > 0.0 ? min(radius, 255.9375) : 0.0) * (1.0 / 1024.0));
    UMBRAGE_HIGHP vec2 x = scaled / size;
    UMBRAGE_HIGHP vec2 y = vec2(0.0 - scaled.y, scaled.x) / size;
    UMBRAGE_HIGHP float n = 0.0;
    n += umbrage_lit_at(map, size, center + x * 3.0 - y * 1.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 4.0 + y * 5.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 1.0 - y * 11.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 9.0 - y * 8.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 12.0 + y * 3.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 11.0 + y * 6.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 0.0 + y * 13.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 11.0 - y * 7.0, receiver);
    UMBRAGE_HIGHP float visibility = umbrage_within_far_plane(receiver) ? n * (1.0 / 8.0) : 0.0;
    return compared ? visibility : 1.0;
}
`,
            "disc_hardware16": `
// umbrage_disc_hardware16: 16 points of a disc, each compared and weighted by the sampler; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   radius  in texels, at most 255.9375;   rotation  umbrage_disc_rotation of the pixel
UMBRAGE_HIGHP float umbrage_disc_hardware16(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                            UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float radius,
                                            UMBRAGE_HIGHP vec2 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    UMBRAGE_HIGHP vec2 center = (compared ? coord : vec2(0.0, 0.0)) / size;
    UMBRAGE_HIGHP vec2 scaled = rotation * ((radius > 0.0 ? min(radius, 255.9375) : 0.0) * (1.0 / 1024.0));
    UMBRAGE_HIGHP vec2 x = scaled / size;
    UMBRAGE_HIGHP vec2 y = vec2(0.0 - scaled.y, scaled.x) / size;
    UMBRAGE_HIGHP float n = 0.0;
    n += umbrage_lit_at(map, size, center + x * 1.0 - y * 3.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 5.0 + y * 2.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 5.0 + y * 2.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 0.0 + y * 7.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 6.0 - y * 5.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 8.0 - y * 5.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 0.0 - y * 11.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 11.0 + y * 5.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 12.0 + y * 4.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 1.0 + y * 13.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 7.0 + y * 11.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 9.0 + y * 10.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 13.0 - y * 4.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 7.0 - y * 12.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 7.0 - y * 12.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 14.0 - y * 2.0, receiver);
    UMBRAGE_HIGHP float visibility = umbrage_within_far_plane(receiver) ? n * (1.0 / 16.0) : 0.0;
    return compared ? visibility : 1.0;
}
`,
            "disc_hardware32": `
// umbrage_disc_hardware32: 32 points of a disc, each compared and weighted by the sampler; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   radius  in texels, at most 255.9375;   rotation  umbrage_disc_rotation of the pixel
UMBRAGE_HIGHP float umbrage_disc_hardware32(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                            UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float radius,
                                            UMBRAGE_HIGHP vec2 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    UMBRAGE_HIGHP vec2 center = (compared ? coord : vec2(0.0, 0.0)) / size;
    UMBRAGE_HIGHP vec2 scaled = rotation * ((radius > 0.0 ? min(radius, 255.9375) : 0.0) * (1.0 / 1024.0));
    UMBRAGE_HIGHP vec2 x = scaled / size;
    UMBRAGE_HIGHP vec2 y = vec2(0.0 - scaled.y, scaled.x) / size;
    UMBRAGE_HIGHP float n = 0.0;
    n += umbrage_lit_at(map, size, center - x * 2.0 - y * 1.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 3.0 + y * 2.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 1.0 - y * 4.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 4.0 + y * 3.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 0.0 + y * 6.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 5.0 - y * 5.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 7.0 - y * 2.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 8.0 - y * 1.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 8.0 + y * 3.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 5.0 + y * 7.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 1.0 - y * 9.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 6.0 - y * 7.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 8.0 + y * 5.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 0.0 + y * 10.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 3.0 - y * 10.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 6.0 + y * 10.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 9.0 - y * 8.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 11.0 - y * 5.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 5.0 - y * 12.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 13.0 - y * 1.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 7.0 + y * 11.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 13.0 + y * 3.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 13.0 + y * 4.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 10.0 - y * 10.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 14.0 - y * 2.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 11.0 + y * 9.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 3.0 + y * 14.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 13.0 - y * 6.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 12.0 + y * 8.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 4.0 + y * 14.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 7.0 - y * 13.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 0.0 - y * 15.0, receiver);
    UMBRAGE_HIGHP float visibility = umbrage_within_far_plane(receiver) ? n * (1.0 / 32.0) : 0.0;
    return compared ? visibility : 1.0;
}
`,
            "bounds_lit": `
// umbrage_bounds_lit: 1.0 where all texels of a filter are lit, 0.0 where none is, else -1.0: ask the filter
//   bounds, size  a map of the texels' least and greatest depths, and its size in texels;   place  what goes with it
//   coord, receiver  as the filter takes them
UMBRAGE_HIGHP float umbrage_bounds_lit(UMBRAGE_MAP bounds, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                       UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP vec2 place) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    UMBRAGE_HIGHP vec2 x = compared ? floor(coord * 256.0) : vec2(0.0, 0.0);
    UMBRAGE_HIGHP vec4 b = umbrage_fetch_clamped(bounds, size, floor((x + place.x) * place.y));
    UMBRAGE_HIGHP float all = umbrage_compare(receiver, b.x);
    UMBRAGE_HIGHP float some = umbrage_compare(receiver, b.y);
    UMBRAGE_HIGHP float known = b.x <= b.y && all == some ? all : -1.0;  // not of a NaN
    return compared ? known : 1.0;
}
`,
            "distance_code": `
// umbrage_distance_code: a depth as whole number from 0.0 at the near plane to 65535.0, also where depth is reversed
UMBRAGE_HIGHP float umbrage_distance_code(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float v = depth * 65536.0;
    UMBRAGE_HIGHP float forward = v < 65535.0 ? floor(max(v, 0.0)) : 65535.0;
    UMBRAGE_HIGHP float reversed = v > 0.0 ? floor(min(v, 65535.0)) : 0.0;
    return umbrage_cleared_depth() > 0.5 ? forward : 65535.0 - reversed;
}
`,
            "penumbra": `
// umbrage_penumbra: radius in 1/16 texel, a whole number
//   apart     umbrage_distance_code of the receiver less that of the blocker
//   softness  (1/16 texel a code, min_radius, max_radius), of make_penumbra_params
UMBRAGE_HIGHP float umbrage_penumbra(UMBRAGE_HIGHP float apart, UMBRAGE_HIGHP vec3 softness) {
    return min(max(floor(apart * softness.x), softness.y), softness.z);
}
`,
            "blocker": `
// umbrage_blocker: (1.0, umbrage_distance_code) of a texel before the receiver, of any other (0.0, 0.0)
UMBRAGE_HIGHP vec2 umbrage_blocker(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                   UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP float stored = umbrage_fetch_depth(map, size, texel);
    UMBRAGE_HIGHP float code = umbrage_distance_code(stored);
    return umbrage_compare(receiver, stored) > 0.5 ? vec2(0.0, 0.0) : vec2(1.0, code);
}
`,
            "blockers8": `
// umbrage_blockers8: how many of a disc's 8 points fall on texels before the receiver, and the sum of their codes
//   map, size  shadow map and its size in texels;   position  floor(256 coord) of the receiver;   receiver  biased
//   radius     in 1/16 texel, a whole number from 0 to 4095;   rotation  umbrage_disc_rotation of the pixel
UMBRAGE_HIGHP vec2 umbrage_blockers8(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 position,
                                      UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float radius,
                                      UMBRAGE_HIGHP vec2 rotation) {
    UMBRAGE_HIGHP vec2 n = vec2(0.0, 0.0);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(3.0, -1.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(-4.0, 5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(1.0, -11.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(-9.0, -8.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(-12.0, 3.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(11.0, 6.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(0.0, 13.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(11.0, -7.0), rotation, radius), receiver);
    return n;
}
`,
            "blockers16": `
// umbrage_blockers16: how many of a disc's 16 points fall on texels before the receiver, and the sum of their codes
//   map, size  shadow map and its size in texels;   position  floor(256 coord) of the receiver;   receiver  biased
//   radius     in 1/16 texel, a whole number from 0 to 4095;   rotation  umbrage_disc_rotation of the pixel
UMBRAGE_HIGHP vec2 umbrage_blockers16(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 position,
                                      UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float radius,
                                      UMBRAGE_HIGHP vec2 rotation) {
    UMBRAGE_HIGHP vec2 n = vec2(0.0, 0.0);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(1.0, -3.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(5.0, 2.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(-5.0, 2.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(0.0, 7.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(-6.0, -5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(8.0, -5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(0.0, -11.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(11.0, 5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(-12.0, 4.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(-1.0, 13.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(7.0, 11.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(-9.0, 10.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(-13.0, -4.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(7.0, -12.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(-7.0, -12.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(14.0, -2.0), rotation, radius), receiver);
    return n;
}
`,
            "blockers32": `
// umbrage_blockers32: how many of a disc's 32 points fall on texels before the receiver, and the sum of their codes
//   map, size  shadow map and its size in texels;   position  floor(256 coord) of the receiver;   receiver  biased
//   radius     in 1/16 texel, a whole number from 0 to 4095;   rotation  umbrage_disc_rotation of the pixel
UMBRAGE_HIGHP vec2 umbrage_blockers32(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 position,
                                      UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float radius,
                                      UMBRAGE_HIGHP vec2 rotation) {
    UMBRAGE_HIGHP vec2 n = vec2(0.0, 0.0);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(-2.0, -1.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(3.0, 2.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(1.0, -4.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(-4.0, 3.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(0.0, 6.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(-5.0, -5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(7.0, -2.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(-8.0, -1.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(8.0, 3.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(5.0, 7.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(1.0, -9.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(6.0, -7.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(-8.0, 5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(0.0, 10.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(-3.0, -10.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(-6.0, 10.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(-9.0, -8.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(11.0, -5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(5.0, -12.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(-13.0, -1.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(7.0, 11.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(13.0, 3.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(-13.0, 4.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(10.0, -10.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(14.0, -2.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(-11.0, 9.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(3.0, 14.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(-13.0, -6.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(12.0, 8.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(-4.0, 14.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(-7.0, -13.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2(0.0, -15.0), rotation, radius), receiver);
    return n;
}
`,
            "pcss8": `
// umbrage_pcss8: percentage-closer soft shadows, 8 points twice; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   softness  of make_penumbra_params;  rotation  umbrage_disc_rotation of the pixel
UMBRAGE_HIGHP float umbrage_pcss8(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                   UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP vec3 softness,
                                   UMBRAGE_HIGHP vec2 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    UMBRAGE_HIGHP vec2 at = compared ? floor(coord * 256.0) : vec2(0.0, 0.0);
    UMBRAGE_HIGHP float z = umbrage_distance_code(receiver);
    UMBRAGE_HIGHP float search_radius = umbrage_penumbra(z, softness);
    UMBRAGE_HIGHP vec2 found = umbrage_blockers8(map, size, at, receiver, search_radius, rotation);
    UMBRAGE_HIGHP float mean = umbrage_floor_divide(found.y, max(found.x, 1.0));
    UMBRAGE_HIGHP float radius = umbrage_penumbra(z - mean, softness);
    // without a blocker the radius is the search's, whose points are all lit
    return umbrage_disc8(map, size, coord, receiver, radius * (1.0 / 16.0), rotation);
}
`,
            "pcss16": `
// umbrage_pcss16: percentage-closer soft shadows, 16 points twice; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   softness  of make_penumbra_params;  rotation  umbrage_disc_rotation of the pixel
UMBRAGE_HIGHP float umbrage_pcss16(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                   UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP vec3 softness,
                                   UMBRAGE_HIGHP vec2 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    UMBRAGE_HIGHP vec2 at = compared ? floor(coord * 256.0) : vec2(0.0, 0.0);
    UMBRAGE_HIGHP float z = umbrage_distance_code(receiver);
    UMBRAGE_HIGHP float search_radius = umbrage_penumbra(z, softness);
    UMBRAGE_HIGHP vec2 found = umbrage_blockers16(map, size, at, receiver, search_radius, rotation);
    UMBRAGE_HIGHP float mean = umbrage_floor_divide(found.y, max(found.x, 1.0));
    UMBRAGE_HIGHP float radius = umbrage_penumbra(z - mean, softness);
    // without a blocker the radius is the search's, whose points are all lit
    return umbrage_disc16(map, size, coord, receiver, radius * (1.0 / 16.0), rotation);
}
`,
            "pcss32": `
// umbrage_pcss32: percentage-closer soft shadows, 32 points twice; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   softness  of make_penumbra_params;  rotation  umbrage_disc_rotation of the pixel
UMBRAGE_HIGHP float umbrage_pcss32(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                   UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP vec3 softness,
                                   UMBRAGE_HIGHP vec2 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    UMBRAGE_HIGHP vec2 at = compared ? floor(coord * 256.0) : vec2(0.0, 0.0);
    UMBRAGE_HIGHP float z = umbrage_distance_code(receiver);
    UMBRAGE_HIGHP float search_radius = umbrage_penumbra(z, softness);
    UMBRAGE_HIGHP vec2 found = umbrage_blockers32(map, size, at, receiver, search_radius, rotation);
    UMBRAGE_HIGHP float mean = umbrage_floor_divide(found.y, max(found.x, 1.0));
    UMBRAGE_HIGHP float radius = umbrage_penumbra(z - mean, softness);
    // without a blocker the radius is the search's, whose points are all lit
    return umbrage_disc32(map, size, coord, receiver, radius * (1.0 / 16.0), rotation);
}
`,
            "blocker_at": `
// umbrage_blocker_at: (1.0, depth) of the texel at a point where it is before the receiver, else (0.0, 0.0)
//   uv  over the map, (0.0, 0.0) to (1.0, 1.0), no NaN
UMBRAGE_HIGHP vec2 umbrage_blocker_at(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 uv,
                                      UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP float stored = umbrage_depth_at(map, size, uv);
    return umbrage_compare(receiver, stored) > 0.5 ? vec2(0.0, 0.0) : vec2(1.0, stored);
}
`,
            "pcss_radius": `
// umbrage_pcss_radius: radius of a penumbra in texels; without a blocker that of one at the near plane
//   found     (how many blockers, the sum of their depths);   receiver  depth, biased
//   softness  (1/16 texel a code, min_radius, max_radius), of make_penumbra_params
UMBRAGE_HIGHP float umbrage_pcss_radius(UMBRAGE_HIGHP vec2 found, UMBRAGE_HIGHP float receiver,
                                        UMBRAGE_HIGHP vec3 softness) {
    bool forward = umbrage_cleared_depth() > 0.5;
    UMBRAGE_HIGHP float mean = found.x > 0.5 ? found.y / found.x : (forward ? 0.0 : 1.0);
    UMBRAGE_HIGHP float radius = (forward ? receiver - mean : mean - receiver) * (softness.x * 4096.0);
    UMBRAGE_HIGHP float min_radius = softness.y * 0.0625;
    return radius > min_radius ? min(radius, softness.z * 0.0625) : min_radius;
}
`,
            "blockers_hardware8": `
// umbrage_blockers_hardware8: of the texels at 8 points of a disc those before the receiver: (how many, depths' sum)
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   radius  in texels, at most 255.9375;   rotation  umbrage_disc_rotation of the pixel
UMBRAGE_HIGHP vec2 umbrage_blockers_hardware8(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                               UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float radius,
                                               UMBRAGE_HIGHP vec2 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    UMBRAGE_HIGHP vec2 center = (compared ? coord : vec2(0.0, 0.0)) / size;
    UMBRAGE_HIGHP vec2 scaled = rotation * ((radius > 0.0 ? min(radius, 255.9375) : 0.0) * (1.0 / 1024.0));
    UMBRAGE_HIGHP vec2 x = scaled / size;
    UMBRAGE_HIGHP vec2 y = vec2(0.0 - scaled.y, scaled.x) / size;
    UMBRAGE_HIGHP vec2 n = vec2(0.0, 0.0);
    n += umbrage_blocker_at(map, size, center + x * 3.0 - y * 1.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 4.0 + y * 5.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 1.0 - y * 11.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 9.0 - y * 8.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 12.0 + y * 3.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 11.0 + y * 6.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 0.0 + y * 13.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 11.0 - y * 7.0, receiver);
    return compared ? n : vec2(0.0, 0.0);
}
`,
            "blockers_hardware16": `
// umbrage_blockers_hardware16: of the texels at 16 points of a disc those before the receiver: (how many, depths' sum)
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   radius  in texels, at most 255.9375;   rotation  umbrage_disc_rotation of the pixel
UMBRAGE_HIGHP vec2 umbrage_blockers_hardware16(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                               UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float radius,
                                               UMBRAGE_HIGHP vec2 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    UMBRAGE_HIGHP vec2 center = (compared ? coord : vec2(0.0, 0.0)) / size;
    UMBRAGE_HIGHP vec2 scaled = rotation * ((radius > 0.0 ? min(radius, 255.9375) : 0.0) * (1.0 / 1024.0));
    UMBRAGE_HIGHP vec2 x = scaled / size;
    UMBRAGE_HIGHP vec2 y = vec2(0.0 - scaled.y, scaled.x) / size;
    UMBRAGE_HIGHP vec2 n = vec2(0.0, 0.0);
    n += umbrage_blocker_at(map, size, center + x * 1.0 - y * 3.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 5.0 + y * 2.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 5.0 + y * 2.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 0.0 + y * 7.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 6.0 - y * 5.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 8.0 - y * 5.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 0.0 - y * 11.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 11.0 + y * 5.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 12.0 + y * 4.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 1.0 + y * 13.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 7.0 + y * 11.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 9.0 + y * 10.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 13.0 - y * 4.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 7.0 - y * 12.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 7.0 - y * 12.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 14.0 - y * 2.0, receiver);
    return compared ? n : vec2(0.0, 0.0);
}
`,
            "blockers_hardware32": `
// umbrage_blockers_hardware32: of the texels at 32 points of a disc those before the receiver: (how many, depths' sum)
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   radius  in texels, at most 255.9375;   rotation  umbrage_disc_rotation of the pixel
UMBRAGE_HIGHP vec2 umbrage_blockers_hardware32(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                               UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float radius,
                                               UMBRAGE_HIGHP vec2 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    UMBRAGE_HIGHP vec2 center = (compared ? coord : vec2(0.0, 0.0)) / size;
    UMBRAGE_HIGHP vec2 scaled = rotation * ((radius > 0.0 ? min(radius, 255.9375) : 0.0) * (1.0 / 1024.0));
    UMBRAGE_HIGHP vec2 x = scaled / size;
    UMBRAGE_HIGHP vec2 y = vec2(0.0 - scaled.y, scaled.x) / size;
    UMBRAGE_HIGHP vec2 n = vec2(0.0, 0.0);
    n += umbrage_blocker_at(map, size, center - x * 2.0 - y * 1.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 3.0 + y * 2.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 1.0 - y * 4.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 4.0 + y * 3.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 0.0 + y * 6.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 5.0 - y * 5.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 7.0 - y * 2.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 8.0 - y * 1.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 8.0 + y * 3.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 5.0 + y * 7.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 1.0 - y * 9.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 6.0 - y * 7.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 8.0 + y * 5.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 0.0 + y * 10.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 3.0 - y * 10.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 6.0 + y * 10.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 9.0 - y * 8.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 11.0 - y * 5.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 5.0 - y * 12.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 13.0 - y * 1.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 7.0 + y * 11.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 13.0 + y * 3.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 13.0 + y * 4.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 10.0 - y * 10.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 14.0 - y * 2.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 11.0 + y * 9.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 3.0 + y * 14.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 13.0 - y * 6.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 12.0 + y * 8.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 4.0 + y * 14.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 7.0 - y * 13.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 0.0 - y * 15.0, receiver);
    return compared ? n : vec2(0.0, 0.0);
}
`,
            "hardened_kernel8": `
// umbrage_hardened_kernel8: the share of 8 points in shadow, steepened
//   blocked  how many;   ratio  of the penumbra to the disc in 1/256, a whole number: 256.0 leaves the share as it is
UMBRAGE_HIGHP float umbrage_hardened_kernel8(UMBRAGE_HIGHP float blocked, UMBRAGE_HIGHP float ratio) {
    UMBRAGE_HIGHP float u = blocked * 2.0 - 8.0;
    UMBRAGE_HIGHP float d = max(8.0 - abs(u), 0.0);  // not negative already: no sum is regrouped across the max
    UMBRAGE_HIGHP float steep = 512.0 - d * d * d;
    UMBRAGE_HIGHP float hard = u < 0.0 ? 512.0 - steep : 512.0 + steep;
    return (hard * (256.0 - ratio) + blocked * ratio * 128.0) * (1.0 / 262144.0);
}
`,
            "hardened_kernel16": `
// umbrage_hardened_kernel16: the share of 16 points in shadow, steepened
//   blocked  how many;   ratio  of the penumbra to the disc in 1/256, a whole number: 256.0 leaves the share as it is
UMBRAGE_HIGHP float umbrage_hardened_kernel16(UMBRAGE_HIGHP float blocked, UMBRAGE_HIGHP float ratio) {
    UMBRAGE_HIGHP float u = blocked * 2.0 - 16.0;
    UMBRAGE_HIGHP float d = max(16.0 - abs(u), 0.0);  // not negative already: no sum is regrouped across the max
    UMBRAGE_HIGHP float steep = 4096.0 - d * d * d;
    UMBRAGE_HIGHP float hard = u < 0.0 ? 4096.0 - steep : 4096.0 + steep;
    return (hard * (256.0 - ratio) + blocked * ratio * 512.0) * (1.0 / 2097152.0);
}
`,
            "hardened_kernel32": `
// umbrage_hardened_kernel32: the share of 32 points in shadow, steepened
//   blocked  how many;   ratio  of the penumbra to the disc in 1/256, a whole number: 256.0 leaves the share as it is
UMBRAGE_HIGHP float umbrage_hardened_kernel32(UMBRAGE_HIGHP float blocked, UMBRAGE_HIGHP float ratio) {
    UMBRAGE_HIGHP float u = blocked * 2.0 - 32.0;
    UMBRAGE_HIGHP float d = max(32.0 - abs(u), 0.0);  // not negative already: no sum is regrouped across the max
    UMBRAGE_HIGHP float steep = 32768.0 - d * d * d;
    UMBRAGE_HIGHP float hard = u < 0.0 ? 32768.0 - steep : 32768.0 + steep;
    return (hard * (256.0 - ratio) + blocked * ratio * 2048.0) * (1.0 / 16777216.0);
}
`,
            "dpcf8": `
// umbrage_dpcf8: contact hardening by 8 points; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   softness  of make_penumbra_params;  rotation  umbrage_disc_rotation of the pixel
UMBRAGE_HIGHP float umbrage_dpcf8(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                   UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP vec3 softness,
                                   UMBRAGE_HIGHP vec2 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    UMBRAGE_HIGHP vec2 at = compared ? floor(coord * 256.0) : vec2(0.0, 0.0);
    UMBRAGE_HIGHP float z = umbrage_distance_code(receiver);
    UMBRAGE_HIGHP float search_radius = umbrage_penumbra(z, softness);
    UMBRAGE_HIGHP vec2 found = umbrage_blockers8(map, size, at, receiver, search_radius, rotation);
    UMBRAGE_HIGHP float mean = umbrage_floor_divide(found.y, max(found.x, 1.0));
    UMBRAGE_HIGHP float radius = umbrage_penumbra(z - mean, softness);
    UMBRAGE_HIGHP float ratio = umbrage_floor_divide(radius * 256.0, max(search_radius, 1.0));
    UMBRAGE_HIGHP float dark = umbrage_hardened_kernel8(found.x, ratio);
    return compared ? clamp(1.0 - dark, 0.0, 1.0) : 1.0;
}
`,
            "dpcf16": `
// umbrage_dpcf16: contact hardening by 16 points; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   softness  of make_penumbra_params;  rotation  umbrage_disc_rotation of the pixel
UMBRAGE_HIGHP float umbrage_dpcf16(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                   UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP vec3 softness,
                                   UMBRAGE_HIGHP vec2 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    UMBRAGE_HIGHP vec2 at = compared ? floor(coord * 256.0) : vec2(0.0, 0.0);
    UMBRAGE_HIGHP float z = umbrage_distance_code(receiver);
    UMBRAGE_HIGHP float search_radius = umbrage_penumbra(z, softness);
    UMBRAGE_HIGHP vec2 found = umbrage_blockers16(map, size, at, receiver, search_radius, rotation);
    UMBRAGE_HIGHP float mean = umbrage_floor_divide(found.y, max(found.x, 1.0));
    UMBRAGE_HIGHP float radius = umbrage_penumbra(z - mean, softness);
    UMBRAGE_HIGHP float ratio = umbrage_floor_divide(radius * 256.0, max(search_radius, 1.0));
    UMBRAGE_HIGHP float dark = umbrage_hardened_kernel16(found.x, ratio);
    return compared ? clamp(1.0 - dark, 0.0, 1.0) : 1.0;
}
`,
            "dpcf32": `
// umbrage_dpcf32: contact hardening by 32 points; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   softness  of make_penumbra_params;  rotation  umbrage_disc_rotation of the pixel
UMBRAGE_HIGHP float umbrage_dpcf32(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                   UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP vec3 softness,
                                   UMBRAGE_HIGHP vec2 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    UMBRAGE_HIGHP vec2 at = compared ? floor(coord * 256.0) : vec2(0.0, 0.0);
    UMBRAGE_HIGHP float z = umbrage_distance_code(receiver);
    UMBRAGE_HIGHP float search_radius = umbrage_penumbra(z, softness);
    UMBRAGE_HIGHP vec2 found = umbrage_blockers32(map, size, at, receiver, search_radius, rotation);
    UMBRAGE_HIGHP float mean = umbrage_floor_divide(found.y, max(found.x, 1.0));
    UMBRAGE_HIGHP float radius = umbrage_penumbra(z - mean, softness);
    UMBRAGE_HIGHP float ratio = umbrage_floor_divide(radius * 256.0, max(search_radius, 1.0));
    UMBRAGE_HIGHP float dark = umbrage_hardened_kernel32(found.x, ratio);
    return compared ? clamp(1.0 - dark, 0.0, 1.0) : 1.0;
}
`,
            "box_moments": `
// umbrage_box_moments: (mean, rest, high, low) of the codes in a box of n texels: their sum is n mean + rest, and
//   that of their squared distances from mean 4096 high + low;  whole numbers
//   map, size  a table of make_variance_table and its size;   first, end  of the box, first < end
UMBRAGE_HIGHP vec4 umbrage_box_moments(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 first,
                                       UMBRAGE_HIGHP vec2 end) {
    UMBRAGE_HIGHP vec4 a = umbrage_texel(map, size, end);
    UMBRAGE_HIGHP vec4 b = umbrage_texel(map, size, vec2(first.x, end.y));
    UMBRAGE_HIGHP vec4 c = umbrage_texel(map, size, vec2(end.x, first.y));
    UMBRAGE_HIGHP vec4 d = umbrage_texel(map, size, first);
    UMBRAGE_HIGHP vec4 part = (a - b) - (c - d);
    UMBRAGE_HIGHP vec2 low = vec2(part.x, part.z);
    UMBRAGE_HIGHP vec2 carry = floor(low * (1.0 / 65536.0));
    UMBRAGE_HIGHP vec2 above = vec2(part.y, part.w) + carry;
    // nothing below is negative; compilers cannot regroup sums across a max
    low = max(low - carry * 65536.0, vec2(0.0, 0.0));
    above = max(above - floor(above * (1.0 / 65536.0)) * 65536.0, vec2(0.0, 0.0));
    UMBRAGE_HIGHP float sum = above.x * 65536.0 + low.x;
    UMBRAGE_HIGHP vec2 sides = max(end - first, vec2(1.0, 1.0));
    UMBRAGE_HIGHP float n = sides.x * sides.y;
    UMBRAGE_HIGHP float mean = umbrage_floor_divide(sum, n);
    UMBRAGE_HIGHP float rest = max(sum - mean * n, 0.0);
    UMBRAGE_HIGHP vec2 digits = vec2(sum + rest, low.y);
    UMBRAGE_HIGHP vec2 high = floor(digits * (1.0 / 4096.0));
    digits = max(digits - high * 4096.0, vec2(0.0, 0.0));
    UMBRAGE_HIGHP float below = digits.y - mean * digits.x;
    UMBRAGE_HIGHP float borrow = floor(below * (1.0 / 4096.0));
    UMBRAGE_HIGHP float wide = above.y * 16.0 + high.y - mean * high.x + borrow;
    wide = wide - floor(wide * (1.0 / 1048576.0)) * 1048576.0;
    return vec4(mean, rest, wide, below - borrow * 4096.0);
}
`,
            "summed_variance": `
// umbrage_summed_variance: variance shadow from a summed-area table; visibility, 1.0 is lit
//   map, size  the table, of make_variance_table, and its size: one more than the shadow map's
//   coord, receiver  in texels of the shadow map, first center at (0.5, 0.5), and depth, biased
//   radius     whole: the box has 2 radius + 1 texels a side;   codes  2^bits of the table
UMBRAGE_HIGHP float umbrage_summed_variance(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                            UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float radius,
                                            UMBRAGE_HIGHP float codes) {
    UMBRAGE_HIGHP vec2 last = size - 1.0;
    bool compared = umbrage_map_covers(last, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    UMBRAGE_HIGHP vec2 texel = compared ? clamp(floor(coord), vec2(0.0, 0.0), last - 1.0) : vec2(0.0, 0.0);
    UMBRAGE_HIGHP vec2 first = max(texel - radius, vec2(0.0, 0.0));
    UMBRAGE_HIGHP vec2 end = min(texel + radius + 1.0, last);
    UMBRAGE_HIGHP vec4 m = umbrage_box_moments(map, size, first, end);
    UMBRAGE_HIGHP vec2 sides = end - first;
    UMBRAGE_HIGHP float n = sides.x * sides.y;
    UMBRAGE_HIGHP float share = m.y / n;
    UMBRAGE_HIGHP float variance = (m.z * 4096.0 + (m.w - m.y)) / n + share * (1.0 - share);
    UMBRAGE_HIGHP float scaled = receiver * codes;
    UMBRAGE_HIGHP float t = umbrage_cleared_depth() > 0.5 ? scaled : codes - scaled;
    UMBRAGE_HIGHP float d = (t - 1.0 - m.x) - share;
    UMBRAGE_HIGHP float behind = d > 0.0 ? variance / (variance + d * d) : 0.0;
    return compared ? (d <= 0.0 ? 1.0 : behind) : 1.0;
}
`,
            "box_mean": `
// umbrage_box_mean: mean of four whole numbers below 65536.0 over a box
//   map, size  a table of make_moment_table and its size;   first, end  of the box, first < end
UMBRAGE_HIGHP vec4 umbrage_box_mean(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 first,
                                    UMBRAGE_HIGHP vec2 end) {
    UMBRAGE_HIGHP float right = size.x * 0.5;
    UMBRAGE_HIGHP vec4 a = umbrage_texel(map, size, end);
    UMBRAGE_HIGHP vec4 b = umbrage_texel(map, size, vec2(first.x, end.y));
    UMBRAGE_HIGHP vec4 c = umbrage_texel(map, size, vec2(end.x, first.y));
    UMBRAGE_HIGHP vec4 d = umbrage_texel(map, size, first);
    UMBRAGE_HIGHP vec4 low = (a - b) - (c - d);
    UMBRAGE_HIGHP vec4 carry = floor(low * (1.0 / 65536.0));
    a = umbrage_texel(map, size, vec2(right + end.x, end.y));
    b = umbrage_texel(map, size, vec2(right + first.x, end.y));
    c = umbrage_texel(map, size, vec2(right + end.x, first.y));
    d = umbrage_texel(map, size, vec2(right + first.x, first.y));
    UMBRAGE_HIGHP vec4 above = (a - b) - (c - d) + carry;
    UMBRAGE_HIGHP vec4 high = above - floor(above * (1.0 / 65536.0)) * 65536.0;
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec4 sum = high * 65536.0 + (low - carry * 65536.0);
    UMBRAGE_HIGHP vec2 sides = end - first;
    return sum / (sides.x * sides.y);
}
`,
            "from_optimized_moments": `
// umbrage_from_optimized_moments: four moments of what umbrage_to_optimized_moments made of them
UMBRAGE_HIGHP vec4 umbrage_from_optimized_moments(UMBRAGE_HIGHP vec4 o) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float x = o.x - 0.5;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float z = o.z - 0.5;
    UMBRAGE_HIGHP float eighth = o.y * 0.125;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float b1 = z * 1.73205078 - x * 0.333333343;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float b2 = o.w + eighth;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float b3 = z * 1.29903817 - x * 0.75;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float b4 = o.w - eighth;
    return vec4(b1, b2, b3, b4);
}
`,
            "bias_moments": `
// umbrage_bias_moments: moments moved by a share bias.x towards (0.0, bias.y, 0.0, bias.y)
UMBRAGE_HIGHP vec4 umbrage_bias_moments(UMBRAGE_HIGHP vec4 b, UMBRAGE_HIGHP vec2 bias) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float x = b.x - b.x * bias.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float y = b.y + (bias.y - b.y) * bias.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float z = b.z - b.z * bias.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float w = b.w + (bias.y - b.w) * bias.x;
    return vec4(x, y, z, w);
}
`,
            "to_forward_depth": `
// umbrage_to_forward_depth: depth that grows with distance, 1.0 - depth where the map's is reversed
UMBRAGE_HIGHP float umbrage_to_forward_depth(UMBRAGE_HIGHP float depth) {
    return umbrage_cleared_depth() < 0.5 ? 1.0 - depth : depth;
}
`,
            "moment_atoms": `
// umbrage_moment_atoms: the two depths that beside the receiver's have the same moments, less b.x, and their shares
//   b  moments, biased;   x  the receiver's depth on -1.0 to 1.0 less b.x
UMBRAGE_HIGHP vec4 umbrage_moment_atoms(UMBRAGE_HIGHP vec4 b, UMBRAGE_HIGHP float x) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float d = b.y - b.x * b.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float third = b.z - b.x * b.y;
    UMBRAGE_HIGHP float l = third / d;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float e = (b.w - b.y * b.y) - third * l;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float h = b.x * 2.0 - l;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float a = d * ((x + h) * x - d);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float m = x * e + h * a;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float c = d * (e - a);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float square = m * m - 4.0 * a * c;
    UMBRAGE_HIGHP float root = sqrt(square > 0.0 ? square : 0.0);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float w = (m < 0.0 ? root - m : -(m + root)) * 0.5;
    UMBRAGE_HIGHP vec2 t = vec2(w / a, c / w);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 q = (t + h) * t - d;
    UMBRAGE_HIGHP float least = d * e;
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 sum = least + (t * t * e + q * q * d);
    return vec4(t.x, t.y, least / sum.x, least / sum.y);
}
`,
            "decode_msm": `
// umbrage_decode_msm: visibility of a receiver, at least its lit share less bias.x; 1.0 is lit
//   b  mean of texels;   receiver  depth, biased
//   bias  (3e-6, 0.375) of floats of 32 bits, (6e-5, 0.628) of channels of 16
UMBRAGE_HIGHP float umbrage_decode_msm(UMBRAGE_HIGHP vec4 b, UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP vec2 bias) {
    UMBRAGE_HIGHP float d = umbrage_to_forward_depth(receiver);
    UMBRAGE_HIGHP vec4 m = umbrage_bias_moments(b, bias);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float x = ((d > 0.0 ? (d < 1.0 ? d : 1.0) : 0.0) * 2.0 - 1.0) - m.x;
    UMBRAGE_HIGHP vec4 atoms = umbrage_moment_atoms(m, x);
    UMBRAGE_HIGHP float first = atoms.x < x ? atoms.z : 0.0;
    UMBRAGE_HIGHP float second = atoms.y < x ? atoms.w : 0.0;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float lit = 1.0 - (first + second);
    bool known = abs(atoms.z + atoms.w) <= 4294967296.0;  // what is no NaN
    lit = known ? (lit > 0.0 ? (lit < 1.0 ? lit : 1.0) : 0.0) : (x <= 0.0 ? 1.0 : 0.0);
    return d > 0.0 ? lit : (d <= 0.0 ? lit : 0.0);
}
`,
            "summed_moments": `
// umbrage_summed_moments: moment shadow from a summed-area table; visibility, 1.0 is lit
//   map, size  the table, of make_moment_table, and its size: twice the shadow map's width and two, its height and one
//   coord, receiver  in texels of the shadow map, first center at (0.5, 0.5), and depth, biased
//   radius     whole: the box has 2 radius + 1 texels a side;   bias  (6e-5, 0.628)
UMBRAGE_HIGHP float umbrage_summed_moments(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                           UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float radius,
                                           UMBRAGE_HIGHP vec2 bias) {
    UMBRAGE_HIGHP vec2 last = vec2(size.x * 0.5, size.y) - 1.0;
    bool compared = umbrage_map_covers(last, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    UMBRAGE_HIGHP vec2 texel = compared ? clamp(floor(coord), vec2(0.0, 0.0), last - 1.0) : vec2(0.0, 0.0);
    UMBRAGE_HIGHP vec2 first = max(texel - radius, vec2(0.0, 0.0));
    UMBRAGE_HIGHP vec2 end = min(texel + radius + 1.0, last);
    UMBRAGE_HIGHP vec4 turned = umbrage_box_mean(map, size, first, end) * (1.0 / 65535.0);
    UMBRAGE_HIGHP float lit = umbrage_decode_msm(umbrage_from_optimized_moments(turned), receiver, bias);
    return compared ? lit : 1.0;
}
`,
            "power_of_two": `
// umbrage_power_of_two: 2^n of a whole number n, -64.0 to 63.0
UMBRAGE_HIGHP float umbrage_power_of_two(UMBRAGE_HIGHP float n) {
#if __VERSION__ >= 300
    UMBRAGE_HIGHP uint exponent = uint(n + 127.0);
    return uintBitsToFloat(exponent << 23);
#else
    UMBRAGE_HIGHP float x = n < 0.0 ? n + 64.0 : n;
    UMBRAGE_HIGHP float p = 1.0;
    p = n < 0.0 ? p * (1.0 / 4294967296.0) * (1.0 / 4294967296.0) : p;
    p = x >= 32.0 ? p * 4294967296.0 : p;
    x = x >= 32.0 ? x - 32.0 : x;
    p = x >= 16.0 ? p * 65536.0 : p;
    x = x >= 16.0 ? x - 16.0 : x;
    p = x >= 8.0 ? p * 256.0 : p;
    x = x >= 8.0 ? x - 8.0 : x;
    p = x >= 4.0 ? p * 16.0 : p;
    x = x >= 4.0 ? x - 4.0 : x;
    p = x >= 2.0 ? p * 4.0 : p;
    x = x >= 2.0 ? x - 2.0 : x;
    return x >= 1.0 ? p * 2.0 : p;
#endif
}
`,
            "exp2_polynomial": `
// umbrage_exp2_polynomial: 2^y, off by at most 1.8e-7 of it
//   y  outside of -64.0 to 63.0 the nearer end counts, of NaN -64.0
UMBRAGE_HIGHP float umbrage_exp2_polynomial(UMBRAGE_HIGHP float y) {
    UMBRAGE_HIGHP float x = y > -64.0 ? min(y, 63.0) : -64.0;
    UMBRAGE_HIGHP float n = floor(x);
    UMBRAGE_HIGHP float f = x - n;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float p = 0.00187931862 * f + 0.00899099465;
    p = p * f + 0.0558186769;
    p = p * f + 0.240159273;
    p = p * f + 0.693151712;
    p = p * f + 1.0;
    return p * umbrage_power_of_two(n);
}
`,
            "exp2_steps": `
// umbrage_exp2_steps: 2^y, a whole number below 2^12 times a power of two, y rounded down to 1/2048
//   y  outside of -64.0 to 63.0 the nearer end counts, of NaN -64.0
UMBRAGE_HIGHP float umbrage_exp2_steps(UMBRAGE_HIGHP float y) {
    UMBRAGE_HIGHP float x = floor((y > -64.0 ? min(y, 63.0) : -64.0) * 2048.0);
    UMBRAGE_HIGHP float n = floor(x * (1.0 / 2048.0));
    UMBRAGE_HIGHP float f = max(x - n * 2048.0, 0.0);  // not negative already: no sum is regrouped across the max
    UMBRAGE_HIGHP float g = floor(f * (2048.0 - f) * (1.0 / 256.0));
    UMBRAGE_HIGHP float r = 1251.0 + floor(f * 314.0 * (1.0 / 2048.0));
    UMBRAGE_HIGHP float m = 2048.0 + f - floor((g * r + 16384.0) * (1.0 / 32768.0));
    return m * (1.0 / 2048.0) * umbrage_power_of_two(n);
}
`,
            "chebyshev": `
// umbrage_chebyshev: share of depths that may be as far as the receiver or farther, at most; 0.0 where something is NaN
//   m  mean of the depths, mean of their squares;   receiver  on the same scale;   min_variance  0.0 or more
UMBRAGE_HIGHP float umbrage_chebyshev(UMBRAGE_HIGHP vec2 m, UMBRAGE_HIGHP float receiver,
                                      UMBRAGE_HIGHP float min_variance) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float difference = m.y - m.x * m.x;
    UMBRAGE_HIGHP float variance = difference > min_variance ? difference : min_variance;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float distance = receiver - m.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float sum = variance + distance * distance;
    UMBRAGE_HIGHP float p = variance / sum;
    return receiver <= m.x ? 1.0 : (p > 0.0 ? min(p, 1.0) : 0.0);  // a GPU's v / v may be more than 1.0
}
`,
            "reduce_light_bleeding": `
// umbrage_reduce_light_bleeding: visibility from amount to 1.0 stretched to 0.0 to 1.0: less light bleeds
UMBRAGE_HIGHP float umbrage_reduce_light_bleeding(UMBRAGE_HIGHP float visibility, UMBRAGE_HIGHP float amount) {
    UMBRAGE_HIGHP float stretched = (visibility - amount) / (1.0 - amount);
    return visibility > amount ? stretched : 0.0;
}
`,
            "encode_vsm": `
// umbrage_encode_vsm: depth and its square, of depth that grows with distance; NaN counts as far
UMBRAGE_HIGHP vec2 umbrage_encode_vsm(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float d = umbrage_to_forward_depth(umbrage_saturate(depth));
    return vec2(d, d * d);
}
`,
            "decode_vsm": `
// umbrage_decode_vsm: visibility of a receiver, at least its lit share; 1.0 is lit
//   m  mean of texels;   receiver  depth, biased;   min_variance  0.0 or more
UMBRAGE_HIGHP float umbrage_decode_vsm(UMBRAGE_HIGHP vec2 m, UMBRAGE_HIGHP float receiver,
                                       UMBRAGE_HIGHP float min_variance) {
    return umbrage_chebyshev(m, umbrage_to_forward_depth(receiver), min_variance);
}
`,
            "encode_deviation": `
// umbrage_encode_deviation: mean and mean square of depths to mean and twice the standard deviation, each 0.0 to 1.0
UMBRAGE_HIGHP vec2 umbrage_encode_deviation(UMBRAGE_HIGHP vec2 m) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float variance = m.y - m.x * m.x;
    return vec2(m.x, 2.0 * sqrt(variance > 0.0 ? variance : 0.0));
}
`,
            "decode_deviation": `
// umbrage_decode_deviation: mean and twice the standard deviation to mean and mean square of depths
UMBRAGE_HIGHP vec2 umbrage_decode_deviation(UMBRAGE_HIGHP vec2 held) {
    UMBRAGE_HIGHP float half_of_it = held.y * 0.5;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float square = held.x * held.x + half_of_it * half_of_it;
    return vec2(held.x, square);
}
`,
            "decode_deviation_rgba8": `
// umbrage_decode_deviation_rgba8: mean and deviation, two channels each, as sampled, to mean and mean square of depths
UMBRAGE_HIGHP vec2 umbrage_decode_deviation_rgba8(UMBRAGE_HIGHP vec4 c) {
    UMBRAGE_HIGHP float mean = umbrage_decode_rg16(vec2(c.x, c.y), 1.0);
    UMBRAGE_HIGHP float deviation = umbrage_decode_rg16(vec2(c.z, c.w), 1.0);
    return umbrage_decode_deviation(vec2(mean, deviation));
}
`,
            "exponential_warp": `
// umbrage_exponential_warp: 2^(exponent * (2.0 * depth - 1.0)) of a depth that grows with distance
UMBRAGE_HIGHP float umbrage_exponential_warp(UMBRAGE_HIGHP float depth, UMBRAGE_HIGHP float exponent) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float y = exponent * (depth * 2.0 - 1.0);
    return umbrage_exp2_polynomial(y);
}
`,
            "encode_esm": `
// umbrage_encode_esm: depth's power, of depth that grows with distance; NaN counts as far
UMBRAGE_HIGHP float umbrage_encode_esm(UMBRAGE_HIGHP float depth, UMBRAGE_HIGHP float exponent) {
    return umbrage_exponential_warp(umbrage_to_forward_depth(umbrage_saturate(depth)), exponent);
}
`,
            "decode_esm": `
// umbrage_decode_esm: visibility of a receiver, at least its lit share; 1.0 is lit
//   m  mean of texels;   receiver  depth, biased;   exponent  as of the texels
UMBRAGE_HIGHP float umbrage_decode_esm(UMBRAGE_HIGHP float m, UMBRAGE_HIGHP float receiver,
                                       UMBRAGE_HIGHP float exponent) {
    UMBRAGE_HIGHP float d = umbrage_to_forward_depth(receiver);
    UMBRAGE_HIGHP float p = m * umbrage_exponential_warp(d, -exponent);
    UMBRAGE_HIGHP float lit = p > 0.0 && p < 1.0 ? p : (p >= 1.0 ? 1.0 : 0.0);
    return d > 0.0 ? lit : (d <= 0.0 ? lit : 0.0);
}
`,
            "encode_evsm2": `
// umbrage_encode_evsm2: depth's power and its square, of depth that grows with distance; NaN counts as far
UMBRAGE_HIGHP vec2 umbrage_encode_evsm2(UMBRAGE_HIGHP float depth, UMBRAGE_HIGHP float exponent) {
    UMBRAGE_HIGHP float w = umbrage_exponential_warp(umbrage_to_forward_depth(umbrage_saturate(depth)), exponent);
    return vec2(w, w * w);
}
`,
            "encode_evsm4": `
// umbrage_encode_evsm4: depth's growing power, its square, the negative falling one, its square; NaN counts as far
UMBRAGE_HIGHP vec4 umbrage_encode_evsm4(UMBRAGE_HIGHP float depth, UMBRAGE_HIGHP vec2 exponents) {
    UMBRAGE_HIGHP float d = umbrage_to_forward_depth(umbrage_saturate(depth));
    UMBRAGE_HIGHP float w = umbrage_exponential_warp(d, exponents.x);
    UMBRAGE_HIGHP float n = -umbrage_exponential_warp(d, -exponents.y);
    return vec4(w, w * w, n, n * n);
}
`,
            "decode_evsm2": `
// umbrage_decode_evsm2: visibility of a receiver, at least its lit share; 1.0 is lit
//   m  mean of texels;   receiver  depth, biased;   exponent  as of the texels
//   deviation  least standard deviation, as a part of the receiver's power
UMBRAGE_HIGHP float umbrage_decode_evsm2(UMBRAGE_HIGHP vec2 m, UMBRAGE_HIGHP float receiver,
                                         UMBRAGE_HIGHP float exponent, UMBRAGE_HIGHP float deviation) {
    UMBRAGE_HIGHP float d = umbrage_to_forward_depth(umbrage_saturate(receiver));
    UMBRAGE_HIGHP float w = umbrage_exponential_warp(d, exponent);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float least = deviation * w;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float least_variance = least * least;
    UMBRAGE_HIGHP float lit = umbrage_chebyshev(m, w, least_variance);
    return receiver > 0.0 ? lit : (receiver <= 0.0 ? lit : 0.0);
}
`,
            "decode_evsm4": `
// umbrage_decode_evsm4: visibility of a receiver, at least its lit share; 1.0 is lit
//   m  mean of texels;   receiver  depth, biased;   exponents  as of the texels
//   deviations  least standard deviations, as parts of the receiver's powers
UMBRAGE_HIGHP float umbrage_decode_evsm4(UMBRAGE_HIGHP vec4 m, UMBRAGE_HIGHP float receiver,
                                         UMBRAGE_HIGHP vec2 exponents, UMBRAGE_HIGHP vec2 deviations) {
    UMBRAGE_HIGHP float d = umbrage_to_forward_depth(umbrage_saturate(receiver));
    UMBRAGE_HIGHP float w = umbrage_exponential_warp(d, exponents.x);
    UMBRAGE_HIGHP float n = -umbrage_exponential_warp(d, -exponents.y);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 least = deviations * vec2(w, n);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 least_variance = least * least;
    UMBRAGE_HIGHP float a = umbrage_chebyshev(vec2(m.x, m.y), w, least_variance.x);
    UMBRAGE_HIGHP float b = umbrage_chebyshev(vec2(m.z, m.w), n, least_variance.y);
    UMBRAGE_HIGHP float lit = a < b ? a : b;
    return receiver > 0.0 ? lit : (receiver <= 0.0 ? lit : 0.0);
}
`,
            "encode_msm": `
// umbrage_encode_msm: first four powers of depth on -1.0 to 1.0, of depth that grows with distance; NaN counts as far
UMBRAGE_HIGHP vec4 umbrage_encode_msm(UMBRAGE_HIGHP float depth) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float z = umbrage_to_forward_depth(umbrage_saturate(depth)) * 2.0 - 1.0;
    UMBRAGE_HIGHP float square = z * z;
    return vec4(z, square, square * z, square * square);
}
`,
            "to_optimized_moments": `
// umbrage_to_optimized_moments: four moments so that each takes 0.0 to 1.0 wholly, for four channels of 16 bits
UMBRAGE_HIGHP vec4 umbrage_to_optimized_moments(UMBRAGE_HIGHP vec4 b) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float x = (b.x * 0.75 - b.z) * 2.0 + 0.5;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float y = (b.y - b.w) * 4.0;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float z = (b.x * 2.25 - b.z) * 0.384900182 + 0.5;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float w = (b.y + b.w) * 0.5;
    return vec4(x, y, z, w);
}
`,
            "hausdorff_share": `
// umbrage_hausdorff_share: least share of depths on -1.0 to 1.0 before the receiver's, of four moments
//   b  moments, biased;   z  the receiver's depth on -1.0 to 1.0
//   negative where the share is that of umbrage_moment_atoms
UMBRAGE_HIGHP float umbrage_hausdorff_share(UMBRAGE_HIGHP vec4 b, UMBRAGE_HIGHP float z) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float variance = b.y - b.x * b.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float third = b.z - b.x * b.y;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float fourth = b.w - b.y * b.y;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float rest = 1.0 - b.y;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float x = z - b.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float d = third + rest * x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float g = (fourth - variance * rest) - (z + b.x) * third;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float p = d * (1.0 + b.x) + g;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float q = d * (1.0 - b.x) - g;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float k = rest * g + third * d;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float first = (1.0 + z) * (d * variance + g * (1.0 - b.x)) - k;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float last = (1.0 - z) * (d * variance - g * (1.0 + b.x)) + k;
    UMBRAGE_HIGHP float square = d * d;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float between = p * (q * (x * d - g));
    UMBRAGE_HIGHP float end = first / (2.0 * ((1.0 + z) * p));
    UMBRAGE_HIGHP float other = square * square / between;
    UMBRAGE_HIGHP float share = end + (d > 0.0 ? other : 0.0);
    bool four = first * p > 0.0 && last * q > 0.0 && p * q > 0.0 && share >= 0.0;
    return z <= -1.0 ? 0.0 : (four ? (share < 1.0 ? share : 1.0) : -1.0);
}
`,
            "decode_msm_hausdorff": `
// umbrage_decode_msm_hausdorff: visibility of a receiver, at least its lit share less bias.x; 1.0 is lit
//   b  mean of texels;   receiver  depth, biased;   bias  (3e-6, 0.375)
UMBRAGE_HIGHP float umbrage_decode_msm_hausdorff(UMBRAGE_HIGHP vec4 b, UMBRAGE_HIGHP float receiver,
                                                 UMBRAGE_HIGHP vec2 bias) {
    UMBRAGE_HIGHP float plain = umbrage_decode_msm(b, receiver, bias);
    UMBRAGE_HIGHP float d = umbrage_to_forward_depth(receiver);
    UMBRAGE_HIGHP float z = (d > 0.0 ? (d < 1.0 ? d : 1.0) : 0.0) * 2.0 - 1.0;
    UMBRAGE_HIGHP float share = umbrage_hausdorff_share(umbrage_bias_moments(b, bias), z);
    UMBRAGE_HIGHP float lit = share >= 0.0 ? 1.0 - share : plain;
    return d > 0.0 ? lit : (d <= 0.0 ? lit : 0.0);
}
`,
            "fetch_bilinear": `
// umbrage_fetch_bilinear: mean of the four texels around a point, weights in steps of 1/256
//   coord  in texels, first center at (0.5, 0.5)
UMBRAGE_HIGHP vec4 umbrage_fetch_bilinear(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord) {
    UMBRAGE_HIGHP vec2 x = floor(coord * 256.0) - 128.0;
    UMBRAGE_HIGHP vec2 texel = floor(x * (1.0 / 256.0));
    // weights are in [0, 256) already; compilers cannot regroup sums across the clamp
    UMBRAGE_HIGHP vec2 hi = clamp(x * (1.0 / 256.0) - texel, vec2(0.0, 0.0), vec2(1.0, 1.0)) * 256.0;
    UMBRAGE_HIGHP vec2 lo = 256.0 - hi;  // of 1.0 - hi compilers would make an interpolation, which rounds otherwise
    UMBRAGE_HIGHP vec4 a = umbrage_fetch_clamped(map, size, texel);
    UMBRAGE_HIGHP vec4 b = umbrage_fetch_clamped(map, size, texel + vec2(1.0, 0.0));
    UMBRAGE_HIGHP vec4 c = umbrage_fetch_clamped(map, size, texel + vec2(0.0, 1.0));
    UMBRAGE_HIGHP vec4 d = umbrage_fetch_clamped(map, size, texel + vec2(1.0, 1.0));
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec4 low = a * lo.x + b * hi.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec4 high = c * lo.x + d * hi.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec4 sum = low * lo.y + high * hi.y;
    return sum * (1.0 / 65536.0);
}
`,
            "vsm": `
// umbrage_vsm: visibility from a map of encode_vsm's texels, blurred; 1.0 is lit
//   map, size  prefiltered map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   min_variance  0.0 or more
UMBRAGE_HIGHP float umbrage_vsm(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float min_variance) {
    bool compared = umbrage_map_covers(size, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    UMBRAGE_HIGHP vec4 m = umbrage_fetch_bilinear(map, size, compared ? coord : vec2(0.0, 0.0));
    UMBRAGE_HIGHP float lit = umbrage_decode_vsm(vec2(m.x, m.y), receiver, min_variance);
    return compared ? lit : 1.0;
}
`,
            "esm": `
// umbrage_esm: visibility from a map of encode_esm's texels, blurred; 1.0 is lit
//   map, size  prefiltered map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   exponent  as of the texels
UMBRAGE_HIGHP float umbrage_esm(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float exponent) {
    bool compared = umbrage_map_covers(size, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    UMBRAGE_HIGHP vec4 m = umbrage_fetch_bilinear(map, size, compared ? coord : vec2(0.0, 0.0));
    UMBRAGE_HIGHP float lit = umbrage_decode_esm(m.x, receiver, exponent);
    return compared ? lit : 1.0;
}
`,
            "evsm2": `
// umbrage_evsm2: visibility from a map of encode_evsm2's texels, blurred; 1.0 is lit
//   map, size  prefiltered map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   exponent, deviation  as of decode_evsm2
UMBRAGE_HIGHP float umbrage_evsm2(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                  UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float exponent,
                                  UMBRAGE_HIGHP float deviation) {
    bool compared = umbrage_map_covers(size, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    UMBRAGE_HIGHP vec4 m = umbrage_fetch_bilinear(map, size, compared ? coord : vec2(0.0, 0.0));
    UMBRAGE_HIGHP float lit = umbrage_decode_evsm2(vec2(m.x, m.y), receiver, exponent, deviation);
    return compared ? lit : 1.0;
}
`,
            "evsm4": `
// umbrage_evsm4: visibility from a map of encode_evsm4's texels, blurred; 1.0 is lit
//   map, size  prefiltered map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   exponents, deviations  as of decode_evsm4
UMBRAGE_HIGHP float umbrage_evsm4(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                  UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP vec2 exponents,
                                  UMBRAGE_HIGHP vec2 deviations) {
    bool compared = umbrage_map_covers(size, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    UMBRAGE_HIGHP vec4 m = umbrage_fetch_bilinear(map, size, compared ? coord : vec2(0.0, 0.0));
    UMBRAGE_HIGHP float lit = umbrage_decode_evsm4(m, receiver, exponents, deviations);
    return compared ? lit : 1.0;
}
`,
            "msm": `
// umbrage_msm: visibility from a map of encode_msm's texels, blurred; 1.0 is lit
//   map, size  prefiltered map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   bias  as of decode_msm
UMBRAGE_HIGHP float umbrage_msm(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP vec2 bias) {
    bool compared = umbrage_map_covers(size, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    UMBRAGE_HIGHP vec4 m = umbrage_fetch_bilinear(map, size, compared ? coord : vec2(0.0, 0.0));
    UMBRAGE_HIGHP float lit = umbrage_decode_msm(m, receiver, bias);
    return compared ? lit : 1.0;
}
`,
            "msm_unorm16": `
// umbrage_msm_unorm16: visibility from a map of turned moments, blurred; 1.0 is lit
//   map, size  prefiltered map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   bias  as of decode_msm
UMBRAGE_HIGHP float umbrage_msm_unorm16(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                       UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP vec2 bias) {
    bool compared = umbrage_map_covers(size, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    UMBRAGE_HIGHP vec4 m = umbrage_fetch_bilinear(map, size, compared ? coord : vec2(0.0, 0.0));
    UMBRAGE_HIGHP float lit = umbrage_decode_msm(umbrage_from_optimized_moments(m), receiver, bias);
    return compared ? lit : 1.0;
}
`,
            "msm_hausdorff": `
// umbrage_msm_hausdorff: visibility from a map of encode_msm's texels, blurred; 1.0 is lit
//   map, size  prefiltered map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   bias  as of decode_msm
UMBRAGE_HIGHP float umbrage_msm_hausdorff(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                          UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP vec2 bias) {
    bool compared = umbrage_map_covers(size, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    UMBRAGE_HIGHP vec4 m = umbrage_fetch_bilinear(map, size, compared ? coord : vec2(0.0, 0.0));
    UMBRAGE_HIGHP float lit = umbrage_decode_msm_hausdorff(m, receiver, bias);
    return compared ? lit : 1.0;
}
`,
            "chebyshev_hardware": `
// umbrage_chebyshev_hardware: share of depths that may be as far as the receiver or farther, its least part cut
//   variance  above 0.0;   distance  from mean to receiver, no NaN;   amount  that is cut, 0.0 to 0.5
UMBRAGE_HIGHP float umbrage_chebyshev_hardware(UMBRAGE_HIGHP float variance, UMBRAGE_HIGHP float distance,
                                               UMBRAGE_HIGHP float amount) {
    UMBRAGE_HIGHP float beyond = max(distance, 0.0);
    UMBRAGE_HIGHP float p = variance / (variance + beyond * beyond);
    return clamp((p - amount) / (1.0 - amount), 0.0, 1.0);
}
`,
            "decode_vsm_hardware": `
// umbrage_decode_vsm_hardware: visibility of a receiver, less the light that bleeds; 1.0 is lit
//   held  mean and twice the standard deviation of depths, filtered;   receiver  depth, biased
//   min_variance  1e-7 or more;   amount  that is cut, 0.0 to 0.5
UMBRAGE_HIGHP float umbrage_decode_vsm_hardware(UMBRAGE_HIGHP vec2 held, UMBRAGE_HIGHP float receiver,
                                                UMBRAGE_HIGHP float min_variance, UMBRAGE_HIGHP float amount) {
    UMBRAGE_HIGHP float variance = max(held.y * held.y * 0.25, min_variance);
    UMBRAGE_HIGHP float distance = umbrage_to_forward_depth(receiver) - held.x;
    UMBRAGE_HIGHP float lit = umbrage_chebyshev_hardware(variance, distance, amount);
    return abs(receiver) < 1048576.0 ? lit : 0.0;
}
`,
            "decode_evsm2_hardware": `
// umbrage_decode_evsm2_hardware: visibility of a receiver, less the light that bleeds; 1.0 is lit
//   m  mean of texels;   receiver  depth, biased;   exponent  as of the texels
//   deviation  least standard deviation, as a part of the receiver's power;   amount  that is cut, 0.0 to 0.3
UMBRAGE_HIGHP float umbrage_decode_evsm2_hardware(UMBRAGE_HIGHP vec2 m, UMBRAGE_HIGHP float receiver,
                                                  UMBRAGE_HIGHP float exponent, UMBRAGE_HIGHP float deviation,
                                                  UMBRAGE_HIGHP float amount) {
    UMBRAGE_HIGHP float d = umbrage_to_forward_depth(clamp(receiver, 0.0, 1.0));
    UMBRAGE_HIGHP float w = exp2(exponent * (d * 2.0 - 1.0));
    UMBRAGE_HIGHP float least = deviation * w;
    UMBRAGE_HIGHP float variance = max(m.y - m.x * m.x, least * least);
    UMBRAGE_HIGHP float lit = umbrage_chebyshev_hardware(variance, w - m.x, amount);
    return abs(receiver) < 1048576.0 ? lit : 0.0;
}
`,
            "decode_evsm4_hardware": `
// umbrage_decode_evsm4_hardware: visibility of a receiver, less the light that bleeds; 1.0 is lit
//   m  mean of texels;   receiver  depth, biased;   exponents  as of the texels
//   deviations  least standard deviations, as parts of the receiver's powers;   amount  that is cut, 0.0 to 0.3
UMBRAGE_HIGHP float umbrage_decode_evsm4_hardware(UMBRAGE_HIGHP vec4 m, UMBRAGE_HIGHP float receiver,
                                                  UMBRAGE_HIGHP vec2 exponents, UMBRAGE_HIGHP vec2 deviations,
                                                  UMBRAGE_HIGHP float amount) {
    UMBRAGE_HIGHP float d = umbrage_to_forward_depth(clamp(receiver, 0.0, 1.0)) * 2.0 - 1.0;
    UMBRAGE_HIGHP float w = exp2(exponents.x * d);
    UMBRAGE_HIGHP float n = 0.0 - exp2((0.0 - exponents.y) * d);
    UMBRAGE_HIGHP vec2 least = deviations * vec2(w, n);
    UMBRAGE_HIGHP float growing = max(m.y - m.x * m.x, least.x * least.x);
    UMBRAGE_HIGHP float falling = max(m.w - m.z * m.z, least.y * least.y);
    UMBRAGE_HIGHP float a = umbrage_chebyshev_hardware(growing, w - m.x, amount);
    UMBRAGE_HIGHP float b = umbrage_chebyshev_hardware(falling, n - m.z, amount);
    return abs(receiver) < 1048576.0 ? min(a, b) : 0.0;
}
`,
            "blur_row3": `
// umbrage_blur_row3: mean of 3 texels in a row, weighed by a row of Pascal's triangle
//   map, size  read from, and its size in texels;   texel  whole numbers, (0, 0) is the first
//   along      (1.0, 0.0) or (0.0, 1.0)
UMBRAGE_HIGHP vec4 umbrage_blur_row3(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                     UMBRAGE_HIGHP vec2 along) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec4 sum = umbrage_fetch_clamped(map, size, texel) * (2.0 / 4.0);
    UMBRAGE_HIGHP vec4 before1 = umbrage_fetch_clamped(map, size, texel - along * 1.0);
    UMBRAGE_HIGHP vec4 after1 = umbrage_fetch_clamped(map, size, texel + along * 1.0);
    sum = sum + (before1 + after1) * (1.0 / 4.0);
    return sum;
}
`,
            "blur_row5": `
// umbrage_blur_row5: mean of 5 texels in a row, weighed by a row of Pascal's triangle
//   map, size  read from, and its size in texels;   texel  whole numbers, (0, 0) is the first
//   along      (1.0, 0.0) or (0.0, 1.0)
UMBRAGE_HIGHP vec4 umbrage_blur_row5(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                     UMBRAGE_HIGHP vec2 along) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec4 sum = umbrage_fetch_clamped(map, size, texel) * (6.0 / 16.0);
    UMBRAGE_HIGHP vec4 before1 = umbrage_fetch_clamped(map, size, texel - along * 1.0);
    UMBRAGE_HIGHP vec4 after1 = umbrage_fetch_clamped(map, size, texel + along * 1.0);
    sum = sum + (before1 + after1) * (4.0 / 16.0);
    UMBRAGE_HIGHP vec4 before2 = umbrage_fetch_clamped(map, size, texel - along * 2.0);
    UMBRAGE_HIGHP vec4 after2 = umbrage_fetch_clamped(map, size, texel + along * 2.0);
    sum = sum + (before2 + after2) * (1.0 / 16.0);
    return sum;
}
`,
            "blur_row7": `
// umbrage_blur_row7: mean of 7 texels in a row, weighed by a row of Pascal's triangle
//   map, size  read from, and its size in texels;   texel  whole numbers, (0, 0) is the first
//   along      (1.0, 0.0) or (0.0, 1.0)
UMBRAGE_HIGHP vec4 umbrage_blur_row7(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                     UMBRAGE_HIGHP vec2 along) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec4 sum = umbrage_fetch_clamped(map, size, texel) * (20.0 / 64.0);
    UMBRAGE_HIGHP vec4 before1 = umbrage_fetch_clamped(map, size, texel - along * 1.0);
    UMBRAGE_HIGHP vec4 after1 = umbrage_fetch_clamped(map, size, texel + along * 1.0);
    sum = sum + (before1 + after1) * (15.0 / 64.0);
    UMBRAGE_HIGHP vec4 before2 = umbrage_fetch_clamped(map, size, texel - along * 2.0);
    UMBRAGE_HIGHP vec4 after2 = umbrage_fetch_clamped(map, size, texel + along * 2.0);
    sum = sum + (before2 + after2) * (6.0 / 64.0);
    UMBRAGE_HIGHP vec4 before3 = umbrage_fetch_clamped(map, size, texel - along * 3.0);
    UMBRAGE_HIGHP vec4 after3 = umbrage_fetch_clamped(map, size, texel + along * 3.0);
    sum = sum + (before3 + after3) * (1.0 / 64.0);
    return sum;
}
`,
            "halve_texels": `
// umbrage_halve_texels: mean of the 2x2 texels that a texel of the next level of a mip chain is made of
//   map, size  read from, and its size in texels;   texel  of the next level, whole numbers
UMBRAGE_HIGHP vec4 umbrage_halve_texels(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel) {
    UMBRAGE_HIGHP vec2 at = texel * 2.0;
    UMBRAGE_HIGHP vec4 a = umbrage_fetch_clamped(map, size, at);
    UMBRAGE_HIGHP vec4 b = umbrage_fetch_clamped(map, size, at + vec2(1.0, 0.0));
    UMBRAGE_HIGHP vec4 c = umbrage_fetch_clamped(map, size, at + vec2(0.0, 1.0));
    UMBRAGE_HIGHP vec4 d = umbrage_fetch_clamped(map, size, at + vec2(1.0, 1.0));
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec4 sum = (a + b) + (c + d);
    return sum * 0.25;
}
`,
            "texels_to_world": `
// umbrage_texels_to_world: texels across a light as world units; 0.0 for w <= 0.0
//   units  (edge of a texel, depth a world unit) at w = 1.0;   w  of the point's shadow coordinate
UMBRAGE_HIGHP float umbrage_texels_to_world(UMBRAGE_HIGHP float texels, UMBRAGE_HIGHP vec2 units,
                                            UMBRAGE_HIGHP float w) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float world = texels * units.x * w;
    return world >= (1.0 / 18446744073709551616.0) && world < 18446744073709551616.0 ? world : 0.0;
}
`,
            "clamp_bias": `
// umbrage_clamp_bias: a bias in depth clamped to [0, 1], 0.0 below 2^-64; NaN becomes 1.0, and nothing is in shadow
UMBRAGE_HIGHP float umbrage_clamp_bias(UMBRAGE_HIGHP float bias) {
    UMBRAGE_HIGHP float least = (1.0 / 18446744073709551616.0);
    return bias >= least && bias < 1.0 ? bias : (bias < least ? 0.0 : 1.0);
}
`,
            "world_to_depth": `
// umbrage_world_to_depth: world units along a light as depth, 0.0 to 1.0
//   units  (edge of a texel, depth a world unit) at w = 1.0;   w  of the point's shadow coordinate, above 0.0
UMBRAGE_HIGHP float umbrage_world_to_depth(UMBRAGE_HIGHP float world, UMBRAGE_HIGHP vec2 units,
                                           UMBRAGE_HIGHP float w) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float along = world * units.y;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float square = w * w;
    return umbrage_clamp_bias(along / square);
}
`,
            "biased": `
// umbrage_biased: receiver moved towards the light by bias, in depth; 2^64 and more, and NaN, is none
UMBRAGE_HIGHP float umbrage_biased(UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float bias) {
    UMBRAGE_HIGHP float by = abs(bias) < 18446744073709551616.0 ? bias : 0.0;
    return umbrage_cleared_depth() > 0.5 ? receiver - by : receiver + by;
}
`,
            "clamp_slope": `
// umbrage_clamp_slope: change of depth a texel clamped to [-2, 2]; NaN becomes 2.0
UMBRAGE_HIGHP float umbrage_clamp_slope(UMBRAGE_HIGHP float slope) {
    return slope > -2.0 && slope < 2.0 ? slope : (slope <= -2.0 ? -2.0 : 2.0);
}
`,
            "plane_slope": `
// umbrage_plane_slope: change of depth from one texel to the next, in x and y, of the plane through a point
//   plane_matrix  transpose of the texture matrix' inverse;   normal  of any length;   world  point on the plane
UMBRAGE_HIGHP vec2 umbrage_plane_slope(UMBRAGE_HIGHP mat4 plane_matrix, UMBRAGE_HIGHP vec3 normal,
                                       UMBRAGE_HIGHP vec3 world) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float d = -(normal.x * world.x + normal.y * world.y + normal.z * world.z);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec4 q = plane_matrix[3] * d + plane_matrix[0] * normal.x +
                                           plane_matrix[1] * normal.y + plane_matrix[2] * normal.z;
    return vec2(umbrage_clamp_slope(-q.x / q.z), umbrage_clamp_slope(-q.y / q.z));
}
`,
            "receiver_slope": `
// umbrage_receiver_slope: umbrage_plane_slope, and (0.0, 0.0) for a normal of zero, of a caller who has none
UMBRAGE_HIGHP vec2 umbrage_receiver_slope(UMBRAGE_HIGHP mat4 plane_matrix, UMBRAGE_HIGHP vec3 normal,
                                          UMBRAGE_HIGHP vec3 world) {
    UMBRAGE_HIGHP vec2 slope = umbrage_plane_slope(plane_matrix, normal, world);
    bool none = normal.x == 0.0 && normal.y == 0.0 && normal.z == 0.0;
    return none ? vec2(0.0, 0.0) : slope;
}
`,
            "cascade_slope": `
// umbrage_cascade_slope: change of depth from one texel to the next; (0.0, 0.0) for a normal of zero
//   normal  of the surface, rotated into the light's directions;   scale  of the cascade
UMBRAGE_HIGHP vec2 umbrage_cascade_slope(UMBRAGE_HIGHP vec3 normal, UMBRAGE_HIGHP vec4 scale) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 up = vec2(normal.x, normal.y) * -scale.z;
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 across = vec2(scale.x, scale.y) * normal.z;
    bool none = normal.x == 0.0 && normal.y == 0.0 && normal.z == 0.0;
    UMBRAGE_HIGHP vec2 slope = vec2(umbrage_clamp_slope(up.x / across.x), umbrage_clamp_slope(up.y / across.y));
    return none ? vec2(0.0, 0.0) : slope;
}
`,
            "slope_bias": `
// umbrage_slope_bias: factor times the greater slope, and a base, 0.0 to 1.0
//   slope  change of depth from one texel to the next;   factor  in texels;   base  in depth
UMBRAGE_HIGHP float umbrage_slope_bias(UMBRAGE_HIGHP vec2 slope, UMBRAGE_HIGHP float factor,
                                       UMBRAGE_HIGHP float base) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 bias = abs(slope) * factor + base;
    UMBRAGE_HIGHP float x = umbrage_clamp_bias(bias.x);  // of both: a maximum of a NaN is what a GPU makes it
    UMBRAGE_HIGHP float y = umbrage_clamp_bias(bias.y);
    return x > y ? x : y;
}
`,
            "dual_paraboloid_slope": `
// umbrage_dual_paraboloid_slope: change of distance from one texel to the next, in x and y alike; 0.0 without a normal
//   way  from the light to the receiver;   normal  of its surface;   per_texel  2.0 / (range * (size - 2.0 * border))
UMBRAGE_HIGHP vec2 umbrage_dual_paraboloid_slope(UMBRAGE_HIGHP vec3 way, UMBRAGE_HIGHP vec3 normal,
                                                 UMBRAGE_HIGHP float per_texel) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float square = way.x * way.x + way.y * way.y + way.z * way.z;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float x = normal.y * way.z - normal.z * way.y;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float y = normal.z * way.x - normal.x * way.z;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float z = normal.x * way.y - normal.y * way.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float across = x * x + y * y + z * z;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float along = normal.x * way.x + normal.y * way.y + normal.z * way.z;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float wide = (sqrt(square) + abs(way.z)) * (per_texel * 0.707106781);
    UMBRAGE_HIGHP float slope = umbrage_clamp_slope(wide * sqrt(across) / abs(along));
    bool none = normal.x == 0.0 && normal.y == 0.0 && normal.z == 0.0;
    return none ? vec2(0.0, 0.0) : vec2(slope, slope);
}
`,
            "normal_offset": `
// umbrage_normal_offset: what to add to a surface's point, world units, before it is looked up
//   normal, direction  of the surface and the light, of length one;   way  from the light to the point over w; of a
//   directional light its direction;   width  sqrt(2) reach texel;   error_world  of the map's depths; world units
UMBRAGE_HIGHP vec3 umbrage_normal_offset(UMBRAGE_HIGHP vec3 normal, UMBRAGE_HIGHP vec3 direction,
                                         UMBRAGE_HIGHP vec3 way, UMBRAGE_HIGHP float width,
                                         UMBRAGE_HIGHP float error_world) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float x = normal.y * direction.z + normal.z * -direction.y;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float y = normal.z * direction.x + normal.x * -direction.z;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float z = normal.x * direction.y + normal.y * -direction.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float straight = normal.x * way.x + normal.y * way.y + normal.z * way.z;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float square = x * x + y * y + z * z;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float along = width * sqrt(square) + error_world * abs(straight);
    UMBRAGE_HIGHP vec3 offset = normal * along;
    return abs(offset.x) + abs(offset.y) + abs(offset.z) < 18446744073709551616.0 ? offset : vec3(0.0, 0.0, 0.0);
}
`,
            "kernel_bias": `
// umbrage_kernel_bias: how far along the light a kernel reaches before a surface's plane, in the units of width
//   normal  of the surface;   direction  of the light, of length one;   way  from the light to the point over w; of a
//   directional light its direction;   width  sqrt(2) reach texel;   greatest  tangent, where growth ends
UMBRAGE_HIGHP float umbrage_kernel_bias(UMBRAGE_HIGHP vec3 normal, UMBRAGE_HIGHP vec3 direction, UMBRAGE_HIGHP vec3 way,
                                        UMBRAGE_HIGHP float width, UMBRAGE_HIGHP float greatest) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float x = normal.y * direction.z + normal.z * -direction.y;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float y = normal.z * direction.x + normal.x * -direction.z;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float z = normal.x * direction.y + normal.y * -direction.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float square = x * x + y * y + z * z;
    UMBRAGE_HIGHP float sine = sqrt(square);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float cosine = -(normal.x * way.x + normal.y * way.y + normal.z * way.z);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float edge = cosine * greatest;
    UMBRAGE_HIGHP float tangent = edge > sine ? sine / cosine : greatest;
    UMBRAGE_HIGHP float bias = width * tangent;
    return bias >= (1.0 / 18446744073709551616.0) && bias < 18446744073709551616.0 ? bias : 0.0;
}
`,
            "receiver_plane_slope": `
// umbrage_receiver_plane_slope: change of a receiver's depth a texel in x and y, and by how much their sum may be off
//   dx, dy  dFdx and dFdy of (x and y in texels, depth); zero where they tell nothing of the plane
UMBRAGE_HIGHP vec3 umbrage_receiver_plane_slope(UMBRAGE_HIGHP vec3 dx, UMBRAGE_HIGHP vec3 dy) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float determinant = dx.x * dy.y + dx.y * -dy.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float sum = abs(dx.x) + abs(dx.y) + abs(dy.x) + abs(dy.y);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float along_x = dy.y * dx.z + dx.y * -dy.z;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float along_y = dx.x * dy.z + dy.x * -dx.z;
    UMBRAGE_HIGHP float a = umbrage_clamp_slope(along_x / determinant);
    UMBRAGE_HIGHP float b = umbrage_clamp_slope(along_y / determinant);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float off = ((1.0 / 33554432.0) + (abs(a) + abs(b)) * (1.0 / 8192.0)) * 3.3;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float error = off * (sum / abs(determinant));
    UMBRAGE_HIGHP float least = sum * (1.0 / 1024.0);
    bool known = abs(determinant) > least && sum < 18446744073709551616.0;
    return known ? vec3(a, b, umbrage_clamp_slope(error)) : vec3(0.0, 0.0, 0.0);
}
`,
            "apply_receiver_plane": `
// umbrage_apply_receiver_plane: a texel's depth as the receiver's own texel would hold it; a cleared one stays cleared
//   stored  depth of the texel;   slope  of the receiver's plane, a texel;   coord  receiver in texels
UMBRAGE_HIGHP float umbrage_apply_receiver_plane(UMBRAGE_HIGHP float stored, UMBRAGE_HIGHP vec2 slope,
                                              UMBRAGE_HIGHP vec2 coord, UMBRAGE_HIGHP vec2 texel) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 way = texel + 0.5 - coord;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float depth = stored - (slope.x * way.x + slope.y * way.y);
    bool cleared = abs(stored - umbrage_cleared_depth()) < (1.0 / 18446744073709551616.0);
    return cleared ? stored : depth;
}
`,
            "acne_free_bias": `
// umbrage_acne_free_bias: the smallest bias in depth with which no plane shadows itself, 0.0 to 1.0
//   slope  change of depth from one texel to the next;   reach  of the filter, texels
//   error  how far a decoded depth may lie before the true one
UMBRAGE_HIGHP float umbrage_acne_free_bias(UMBRAGE_HIGHP vec2 slope, UMBRAGE_HIGHP float reach,
                                           UMBRAGE_HIGHP float error) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float bias =
        reach * (abs(slope.x) + abs(slope.y)) + (error + (1.0 / 8388608.0));
    return umbrage_clamp_bias(bias);
}
`,
            "acne_free_disc_bias": `
// umbrage_acne_free_disc_bias: the smallest bias in depth with which no plane shadows itself, 0.0 to 1.0
//   slope   change of depth from one texel to the next;   radius  to the disc's farthest point, texels
//   error   how far a decoded depth may lie before the true one
UMBRAGE_HIGHP float umbrage_acne_free_disc_bias(UMBRAGE_HIGHP vec2 slope, UMBRAGE_HIGHP float radius,
                                                UMBRAGE_HIGHP float error) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float square = slope.x * slope.x + slope.y * slope.y;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float beside =
        (abs(slope.x) + abs(slope.y)) * 0.5078125 + (error + (1.0 / 8388608.0));
    UMBRAGE_PRECISE UMBRAGE_HIGHP float bias = radius * sqrt(square) + beside;
    return umbrage_clamp_bias(bias);
}
`,
            "peter_panning_distance": `
// umbrage_peter_panning_distance: a caster nearer to the receiver loses its shadow, or a part of it; depth, 0.0 to 1.0
//   bias   of the receiver, in depth;   caster_slope  change of the caster's depth from one texel to the next
//   reach  of the filter, texels
UMBRAGE_HIGHP float umbrage_peter_panning_distance(UMBRAGE_HIGHP float bias, UMBRAGE_HIGHP vec2 caster_slope,
                                       UMBRAGE_HIGHP float reach) {
    return umbrage_acne_free_bias(caster_slope, reach, bias);
}
`,
            "spot_cone": `
// umbrage_spot_cone: 1.0 inside the cone of a spot light, else 0.0
//   direction  of the light, unit length;   to_point  from the light, any length;   cos_outer  in [0, 1)
UMBRAGE_HIGHP float umbrage_spot_cone(UMBRAGE_HIGHP vec3 direction, UMBRAGE_HIGHP vec3 to_point,
                                      UMBRAGE_HIGHP float cos_outer) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float d =
        direction.x * to_point.x + direction.y * to_point.y + direction.z * to_point.z;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float length2 =
        to_point.x * to_point.x + to_point.y * to_point.y + to_point.z * to_point.z;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float edge2 = cos_outer * cos_outer * length2;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float d2 = d * d;
    return d > 0.0 && d2 > edge2 ? 1.0 : 0.0;
}
`,
            "diffuse_ambient": `
// umbrage_diffuse_ambient: albedo * (visibility * n_dot_l * (1 - ambient) + ambient); for n_dot_l <= 0, NaN: ambient
UMBRAGE_HIGHP vec3 umbrage_diffuse_ambient(UMBRAGE_HIGHP vec3 albedo, UMBRAGE_HIGHP float ambient,
                                           UMBRAGE_HIGHP float n_dot_l, UMBRAGE_HIGHP float visibility) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float light = visibility * n_dot_l * (1.0 - ambient) + ambient;
    return albedo * (n_dot_l > 0.0 ? light : ambient);  // a max of n_dot_l and 0.0 is NaN for a signalling one on Mesa
}
`,
            "false_color": `
// umbrage_false_color: blue for 0.0, through green, to red for 1.0
UMBRAGE_HIGHP vec3 umbrage_false_color(UMBRAGE_HIGHP float v) {
    UMBRAGE_HIGHP float x = umbrage_saturate(v) * 4.0;
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec3 ramp = 1.5 - abs(vec3(x - 3.0, x - 2.0, x - 1.0));
    return vec3(umbrage_saturate(ramp.x), umbrage_saturate(ramp.y), umbrage_saturate(ramp.z));
}
`,
            "overlay_texel": `
// umbrage_overlay_texel: texel under a pixel of a map stretched over the picture's corner; -1.0 outside the overlay
//   coord     center of the pixel, counted from the corner: 0.5, 1.5, ...;   size  of the overlay in pixels, whole
//   map_size  in texels, whole, at most 65536.0; times size at most 2^23;   texels_per_pixel  map_size / size
UMBRAGE_HIGHP float umbrage_overlay_texel(UMBRAGE_HIGHP float coord, UMBRAGE_HIGHP float size,
                                          UMBRAGE_HIGHP float map_size, UMBRAGE_HIGHP float texels_per_pixel) {
    UMBRAGE_HIGHP float texel = floor(coord * texels_per_pixel - 0.5);
    texel += (texel + 1.0) * size <= coord * map_size ? 1.0 : 0.0;
    return coord >= 0.0 && coord < size ? texel : -1.0;
}
`,
            "probe_color": `
// umbrage_probe_color: what a receiver's place in a map says, as a color
//   at    (x, y) in texels, z depth;   size  of the map;   bias  of the receiver;   number  of the map, whole
//   magenta  not a number;   black  behind the light, in no cascade;   white  outside the map
//   cyan  beyond the far plane;   blue  before the near plane;   red  bias at its limit;   else texels
UMBRAGE_HIGHP vec3 umbrage_probe_color(UMBRAGE_HIGHP vec3 at, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP float bias,
                                       UMBRAGE_HIGHP float number) {
    UMBRAGE_HIGHP float limit = 18446744073709551616.0;
    bool usable = abs(at.x) < limit && abs(at.y) < limit && abs(at.z) < limit;
    bool inside = at.x >= 0.0 && at.y >= 0.0 && at.x <= size.x && at.y <= size.y;
    bool forward = umbrage_cleared_depth() > 0.5;
    bool past_far = forward ? at.z > 1.0 : at.z < 0.0;
    bool past_near = forward ? at.z < 0.0 : at.z > 1.0;
    UMBRAGE_HIGHP float square = floor(at.x) + floor(at.y);
    UMBRAGE_HIGHP float shade = square - 2.0 * floor(square * 0.5) > 0.5 ? 0.75 : 1.0;
    UMBRAGE_HIGHP vec3 bits = floor(vec3(number + 1.0, (number + 1.0) * 0.5, (number + 1.0) * 0.25));
    bits = bits - 2.0 * floor(bits * 0.5);
    UMBRAGE_HIGHP vec3 color = (bits * 0.5 + 0.375) * shade;
    color = bias < 1.0 ? color : vec3(1.0, 0.0, 0.0);
    color = past_near ? vec3(0.0, 0.0, 1.0) : color;
    color = past_far ? vec3(0.0, 1.0, 1.0) : color;
    color = inside ? color : vec3(1.0, 1.0, 1.0);
    color = at.x < 65536.0 ? color : vec3(0.0, 0.0, 0.0);
    return usable ? color : vec3(1.0, 0.0, 1.0);
}
`,
            "probe_inputs": `
// umbrage_probe_inputs: color, unless the receiver is wrong; magenta  not a number;   yellow  a normal of zero
UMBRAGE_HIGHP vec3 umbrage_probe_inputs(UMBRAGE_HIGHP vec3 color, UMBRAGE_HIGHP vec3 world,
                                        UMBRAGE_HIGHP vec3 normal) {
    UMBRAGE_HIGHP float limit = 18446744073709551616.0;
    bool usable = abs(world.x) < limit && abs(world.y) < limit && abs(world.z) < limit;
    usable = usable && abs(normal.x) < limit && abs(normal.y) < limit && abs(normal.z) < limit;
    bool zero = normal.x == 0.0 && normal.y == 0.0 && normal.z == 0.0;
    UMBRAGE_HIGHP vec3 given = zero ? vec3(1.0, 1.0, 0.0) : color;
    return usable ? given : vec3(1.0, 0.0, 1.0);
}
`,
            "hooks/cleared_depth, reversed": `
// umbrage_cleared_depth: depth of the far plane
UMBRAGE_HIGHP float umbrage_cleared_depth() {
    return 0.0;
}
`,
            "hooks/map_covers, clamped": `
// umbrage_map_covers: always, as outside the map the nearest texel inside counts
bool umbrage_map_covers(UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord) {
    return true;
}
`,
            "hooks/beyond_far_plane, reversed": `
// umbrage_beyond_far_plane: whether a receiver is behind the far plane
bool umbrage_beyond_far_plane(UMBRAGE_HIGHP float receiver) {
    return receiver < 0.0;
}
`,
            "hooks/beyond_far_plane, without": `
// umbrage_beyond_far_plane: never for this map; receivers behind the far plane come in as what every texel lights
bool umbrage_beyond_far_plane(UMBRAGE_HIGHP float receiver) {
    return false;
}
`,
            "hooks/within_far_plane, reversed": `
// umbrage_within_far_plane: whether a receiver is a number, and not behind the far plane
bool umbrage_within_far_plane(UMBRAGE_HIGHP float receiver) {
    return receiver >= 0.0;
}
`,
            "hooks/within_far_plane, without": `
// umbrage_within_far_plane: whether a receiver is a number, as for this map none is behind the far plane
bool umbrage_within_far_plane(UMBRAGE_HIGHP float receiver) {
    // a sum of choices, not an or of comparisons, which compilers take for true
    UMBRAGE_HIGHP float number = (receiver > 0.0 ? 1.0 : 0.0) + (receiver <= 0.0 ? 1.0 : 0.0);
    return number > 0.5;
}
`,
            "hooks/compare, reversed": `
// umbrage_compare: 1.0 when the receiver is no farther than the stored depth, near is 1.0
UMBRAGE_HIGHP float umbrage_compare(UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float stored) {
    return receiver >= stored ? 1.0 : 0.0;
}
`,
            "hooks/compare, own": `
// umbrage_compare: visibility of one comparison, the map's own
UMBRAGE_HIGHP float umbrage_compare(UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float stored) {
    return UMBRAGE_COMPARE;
}
`,
            "hooks/decode": `
// umbrage_decode: depth of a value that the sampler gave
UMBRAGE_HIGHP float umbrage_decode(UMBRAGE_HIGHP vec4 value) {
    return UMBRAGE_DEPTH;
}
`,
            "hooks/fetch_depth, clamped": `
// umbrage_fetch_depth: stored depth of a texel, outside the map of the nearest one inside
UMBRAGE_HIGHP float umbrage_fetch_depth(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel) {
    UMBRAGE_HIGHP vec4 value = umbrage_fetch_clamped(map, size, texel);
    return UMBRAGE_DEPTH;
}
`,
            "hooks/lit_texel": `
// umbrage_lit_texel: the sampler's comparison with a texel inside the map; a NaN is in shadow
UMBRAGE_HIGHP float umbrage_lit_texel(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                      UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 at = texel + UMBRAGE_ORIGIN;
    UMBRAGE_HIGHP float lit = UMBRAGE_LIT_TEXEL;
    return (receiver > 0.0 ? lit : 0.0) + (receiver <= 0.0 ? lit : 0.0);
}
`,
            "hooks/lit, clamped": `
// umbrage_lit: visibility of one comparison with a texel, outside the map with the nearest one inside
UMBRAGE_HIGHP float umbrage_lit(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                UMBRAGE_HIGHP float receiver) {
    return umbrage_lit_texel(map, size, clamp(texel, vec2(0.0, 0.0), size - 1.0), receiver);
}
`,
            "hooks/lit, bordered": `
// umbrage_lit: visibility of one comparison with a texel, outside the map with the far plane
UMBRAGE_HIGHP float umbrage_lit(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 inside = clamp(texel, vec2(0.0, 0.0), size - 1.0);
    UMBRAGE_HIGHP float lit = umbrage_lit_texel(map, size, inside, receiver);
    UMBRAGE_HIGHP float outside = umbrage_compare(receiver, UMBRAGE_BORDER);
    return inside.x == texel.x && inside.y == texel.y ? lit : outside;
}
`,
            "hooks/gather_lit, compared": `
// umbrage_gather_lit: the sampler's comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1); a NaN is in shadow
UMBRAGE_HIGHP vec4 umbrage_gather_lit(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                      UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 at = texel + UMBRAGE_ORIGIN;
    UMBRAGE_HIGHP vec4 lit = UMBRAGE_GATHER_LIT;
    UMBRAGE_HIGHP float number = (receiver > 0.0 ? 1.0 : 0.0) + (receiver <= 0.0 ? 1.0 : 0.0);
    return vec4(lit.w, lit.z, lit.x, lit.y) * number;
}
`,
            "hooks/gather_lit, one channel": `
// umbrage_gather_lit: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1)
UMBRAGE_HIGHP vec4 umbrage_gather_lit(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                      UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 at = texel + UMBRAGE_ORIGIN;
    UMBRAGE_HIGHP vec4 r = UMBRAGE_GATHER_RED;
    UMBRAGE_HIGHP float a = umbrage_compare(receiver, umbrage_decode(vec4(r.w, 0.0, 0.0, 0.0)));
    UMBRAGE_HIGHP float b = umbrage_compare(receiver, umbrage_decode(vec4(r.z, 0.0, 0.0, 0.0)));
    UMBRAGE_HIGHP float c = umbrage_compare(receiver, umbrage_decode(vec4(r.x, 0.0, 0.0, 0.0)));
    UMBRAGE_HIGHP float d = umbrage_compare(receiver, umbrage_decode(vec4(r.y, 0.0, 0.0, 0.0)));
    return vec4(a, b, c, d);
}
`,
            "hooks/gather_lit, two channels": `
// umbrage_gather_lit: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1)
UMBRAGE_HIGHP vec4 umbrage_gather_lit(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                      UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 at = texel + UMBRAGE_ORIGIN;
    UMBRAGE_HIGHP vec4 r = UMBRAGE_GATHER_RED;
    UMBRAGE_HIGHP vec4 g = UMBRAGE_GATHER_GREEN;
    UMBRAGE_HIGHP float a = umbrage_compare(receiver, umbrage_decode(vec4(r.w, g.w, 0.0, 0.0)));
    UMBRAGE_HIGHP float b = umbrage_compare(receiver, umbrage_decode(vec4(r.z, g.z, 0.0, 0.0)));
    UMBRAGE_HIGHP float c = umbrage_compare(receiver, umbrage_decode(vec4(r.x, g.x, 0.0, 0.0)));
    UMBRAGE_HIGHP float d = umbrage_compare(receiver, umbrage_decode(vec4(r.y, g.y, 0.0, 0.0)));
    return vec4(a, b, c, d);
}
`,
            "hooks/lit_2x2, gathered": `
// umbrage_lit_2x2: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1); the sampler clamps
UMBRAGE_HIGHP vec4 umbrage_lit_2x2(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                   UMBRAGE_HIGHP float receiver) {
    return umbrage_gather_lit(map, size, texel, receiver);
}
`,
            "hooks/lit_2x2, gathered in a region": `
// umbrage_lit_2x2: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1), outside the map with
//   the nearest texel inside: the gather stays inside, and each comparison is taken from its row and column
UMBRAGE_HIGHP vec4 umbrage_lit_2x2(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                   UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 first = clamp(texel, vec2(0.0, 0.0), max(size - 2.0, vec2(0.0, 0.0)));
    UMBRAGE_HIGHP vec2 low = clamp(texel, vec2(0.0, 0.0), size - 1.0) - first;
    UMBRAGE_HIGHP vec2 high = clamp(texel + 1.0, vec2(0.0, 0.0), size - 1.0) - first;
    UMBRAGE_HIGHP vec4 lit = umbrage_gather_lit(map, size, first, receiver);
    UMBRAGE_HIGHP vec2 left = low.x > 0.5 ? vec2(lit.y, lit.w) : vec2(lit.x, lit.z);
    UMBRAGE_HIGHP vec2 right = high.x > 0.5 ? vec2(lit.y, lit.w) : vec2(lit.x, lit.z);
    UMBRAGE_HIGHP vec2 bottom = low.y > 0.5 ? vec2(left.y, right.y) : vec2(left.x, right.x);
    UMBRAGE_HIGHP vec2 top = high.y > 0.5 ? vec2(left.y, right.y) : vec2(left.x, right.x);
    return vec4(bottom.x, bottom.y, top.x, top.y);
}
`,
            "hooks/lit_2x2, gathered and bordered": `
// umbrage_lit_2x2: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1), outside the map with
//   the far plane, whatever the sampler has there
UMBRAGE_HIGHP vec4 umbrage_lit_2x2(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                   UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec4 lit = umbrage_gather_lit(map, size, texel, receiver);
    UMBRAGE_HIGHP float outside = umbrage_compare(receiver, UMBRAGE_BORDER);
    UMBRAGE_HIGHP float a = umbrage_inside_map(size, texel) ? lit.x : outside;
    UMBRAGE_HIGHP float b = umbrage_inside_map(size, texel + vec2(1.0, 0.0)) ? lit.y : outside;
    UMBRAGE_HIGHP float c = umbrage_inside_map(size, texel + vec2(0.0, 1.0)) ? lit.z : outside;
    UMBRAGE_HIGHP float d = umbrage_inside_map(size, texel + vec2(1.0, 1.0)) ? lit.w : outside;
    return vec4(a, b, c, d);
}
`,
            "hooks/lit_2x2, gathered in a bordered region": `
// umbrage_lit_2x2: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1), outside the map with
//   the far plane: the gather stays inside
UMBRAGE_HIGHP vec4 umbrage_lit_2x2(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                   UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 first = clamp(texel, vec2(0.0, 0.0), max(size - 2.0, vec2(0.0, 0.0)));
    UMBRAGE_HIGHP vec2 low = texel - first;
    UMBRAGE_HIGHP vec4 lit = umbrage_gather_lit(map, size, first, receiver);
    UMBRAGE_HIGHP vec2 left = low.x > 0.5 ? vec2(lit.y, lit.w) : vec2(lit.x, lit.z);
    UMBRAGE_HIGHP vec2 right = low.x < -0.5 ? vec2(lit.x, lit.z) : vec2(lit.y, lit.w);
    UMBRAGE_HIGHP vec2 bottom = low.y > 0.5 ? vec2(left.y, right.y) : vec2(left.x, right.x);
    UMBRAGE_HIGHP vec2 top = low.y < -0.5 ? vec2(left.x, right.x) : vec2(left.y, right.y);
    UMBRAGE_HIGHP float outside = umbrage_compare(receiver, UMBRAGE_BORDER);
    UMBRAGE_HIGHP float a = umbrage_inside_map(size, texel) ? bottom.x : outside;
    UMBRAGE_HIGHP float b = umbrage_inside_map(size, texel + vec2(1.0, 0.0)) ? bottom.y : outside;
    UMBRAGE_HIGHP float c = umbrage_inside_map(size, texel + vec2(0.0, 1.0)) ? top.x : outside;
    UMBRAGE_HIGHP float d = umbrage_inside_map(size, texel + vec2(1.0, 1.0)) ? top.y : outside;
    return vec4(a, b, c, d);
}
`,
            "hooks/lit_filtered, clamped": `
// umbrage_lit_filtered: 2x2 comparisons around a point, weighted by the sampler; a NaN is in shadow
//   coord  in texels, no NaN
UMBRAGE_HIGHP float umbrage_lit_filtered(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                         UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 texel = clamp(coord, vec2(0.5, 0.5), size - 0.5);
    UMBRAGE_HIGHP vec2 at = texel + UMBRAGE_ORIGIN;
    UMBRAGE_HIGHP vec2 uv = UMBRAGE_UV;
    UMBRAGE_HIGHP float lit = UMBRAGE_LIT_FILTERED;
    return umbrage_within_far_plane(receiver) ? lit : 0.0;
}
`,
            "hooks/lit_filtered, bordered": `
// umbrage_lit_filtered: 2x2 comparisons around a point, weighted by the sampler, outside the map with the far plane; a
//   NaN is in shadow
//   coord  in texels, no NaN
UMBRAGE_HIGHP float umbrage_lit_filtered(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                         UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 texel = clamp(coord, vec2(0.5, 0.5), size - 0.5);
    UMBRAGE_HIGHP vec2 at = texel + UMBRAGE_ORIGIN;
    UMBRAGE_HIGHP vec2 uv = UMBRAGE_UV;
    UMBRAGE_HIGHP float lit = UMBRAGE_LIT_FILTERED;
    UMBRAGE_HIGHP vec2 inside = clamp(min(coord, size - coord) + 0.5, vec2(0.0, 0.0), vec2(1.0, 1.0));
    UMBRAGE_HIGHP float outside = umbrage_compare(receiver, UMBRAGE_BORDER);
    return umbrage_within_far_plane(receiver) ? outside + inside.x * inside.y * (lit - outside) : 0.0;
}
`,
            "hooks/lit_at, sampled": `
// umbrage_lit_at: 2x2 comparisons around a point, weighted by the sampler
//   uv  over the map, (0.0, 0.0) to (1.0, 1.0);   receiver  no NaN
UMBRAGE_HIGHP float umbrage_lit_at(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 uv,
                                   UMBRAGE_HIGHP float receiver) {
    return UMBRAGE_LIT_FILTERED;
}
`,
            "hooks/lit_at, sampled and bordered": `
// umbrage_lit_at: 2x2 comparisons around a point, weighted by the sampler, outside the map with the far plane
//   uv  over the map, (0.0, 0.0) to (1.0, 1.0);   receiver  no NaN
UMBRAGE_HIGHP float umbrage_lit_at(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 uv,
                                   UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP float lit = UMBRAGE_LIT_FILTERED;
    UMBRAGE_HIGHP float outside = umbrage_compare(receiver, UMBRAGE_BORDER);
    UMBRAGE_HIGHP vec2 inside = clamp((0.5 - abs(uv - 0.5)) * size + 0.5, vec2(0.0, 0.0), vec2(1.0, 1.0));
    return outside + inside.x * inside.y * (lit - outside);
}
`,
            "hooks/depth_at, sampled": `
// umbrage_depth_at: stored depth of the texel at a point, by the sampler
//   uv  over the map, (0.0, 0.0) to (1.0, 1.0)
UMBRAGE_HIGHP float umbrage_depth_at(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 uv) {
    return umbrage_decode(UMBRAGE_SAMPLED);
}
`,
            "hooks/depth_at, sampled and bordered": `
// umbrage_depth_at: stored depth of the texel at a point, by the sampler, outside the map that of the far plane
//   uv  over the map, (0.0, 0.0) to (1.0, 1.0)
UMBRAGE_HIGHP float umbrage_depth_at(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 uv) {
    UMBRAGE_HIGHP float depth = umbrage_decode(UMBRAGE_SAMPLED);
    return abs(uv.x - 0.5) <= 0.5 && abs(uv.y - 0.5) <= 0.5 ? depth : UMBRAGE_BORDER;
}
`,
        },
    },
    hlsl: {
        prelude: "",
        receiver_plane: "float2 receiver_slope, float2 receiver_coord",
        may_reorder: "",
        preprocessor: true,
        textures: {
            texture_2d: { parameters: "Texture2D<float4> map", arguments: "map", texel: "map.Load(int3(int2(at), 0))", sampled: "map.SampleLevel(map_sampler, uv, 0.0)", lit: "", gather_red: "map.GatherRed(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE)", gather_green: "map.GatherGreen(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE)", gather_lit: "", lit_filtered: "", size: "", sampler: ", SamplerState map_sampler", sampler_argument: ", map_sampler", needs: [] },
            atlas: { parameters: "Texture2D<float4> map, float2 origin", arguments: "map, origin", texel: "map.Load(int3(int2(at), 0))", sampled: "map.SampleLevel(map_sampler, uv, 0.0)", lit: "", gather_red: "map.GatherRed(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE)", gather_green: "map.GatherGreen(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE)", gather_lit: "", lit_filtered: "", size: "", sampler: ", SamplerState map_sampler", sampler_argument: ", map_sampler", needs: [] },
            array: { parameters: "Texture2DArray<float4> map, float layer", arguments: "map, layer", texel: "map.Load(int4(int2(at), int(layer), 0))", sampled: "map.SampleLevel(map_sampler, float3(uv, layer), 0.0)", lit: "", gather_red: "map.GatherRed(map_sampler, float3((at + 1.0) / UMBRAGE_TEXTURE_SIZE, layer))", gather_green: "map.GatherGreen(map_sampler, float3((at + 1.0) / UMBRAGE_TEXTURE_SIZE, layer))", gather_lit: "", lit_filtered: "", size: "", sampler: ", SamplerState map_sampler", sampler_argument: ", map_sampler", needs: [] },
            cube: { parameters: "TextureCube<float4> map, SamplerState map_sampler, float face", arguments: "map, map_sampler, face", texel: "map.SampleLevel(map_sampler, umbrage_cube_direction(face, (at + 0.5) / UMBRAGE_TEXTURE_SIZE), 0.0)", sampled: "", lit: "", gather_red: "", gather_green: "", gather_lit: "", lit_filtered: "", size: "", sampler: "", sampler_argument: "", needs: ["cube_direction"] },
            cube_faces: { parameters: "TextureCube<float4> map, SamplerState map_sampler", arguments: "map, map_sampler", texel: "map.SampleLevel(map_sampler, umbrage_cube_atlas_direction(at, size.y * 0.5), 0.0)", sampled: "", lit: "", gather_red: "", gather_green: "", gather_lit: "", lit_filtered: "", size: "", sampler: "", sampler_argument: "", needs: ["cube_atlas_direction"] },
            integer: { parameters: "Texture2D<uint4> map", arguments: "map", texel: "float4(map.Load(int3(int2(at), 0)))", sampled: "", lit: "", gather_red: "", gather_green: "", gather_lit: "", lit_filtered: "", size: "", sampler: "", sampler_argument: "", needs: [] },
            depth: { parameters: "Texture2D<float> map", arguments: "map", texel: "(float4)map.Load(int3(int2(at), 0))", sampled: "(float4)map.SampleLevel(map_sampler, uv, 0.0)", lit: "", gather_red: "map.Gather(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE)", gather_green: "", gather_lit: "", lit_filtered: "", size: "", sampler: ", SamplerState map_sampler", sampler_argument: ", map_sampler", needs: [] },
            depth_array: { parameters: "Texture2DArray<float> map, float layer", arguments: "map, layer", texel: "(float4)map.Load(int4(int2(at), int(layer), 0))", sampled: "(float4)map.SampleLevel(map_sampler, float3(uv, layer), 0.0)", lit: "", gather_red: "map.Gather(map_sampler, float3((at + 1.0) / UMBRAGE_TEXTURE_SIZE, layer))", gather_green: "", gather_lit: "", lit_filtered: "", size: "", sampler: ", SamplerState map_sampler", sampler_argument: ", map_sampler", needs: [] },
            shadow: { parameters: "Texture2D<float> map, SamplerComparisonState map_sampler", arguments: "map, map_sampler", texel: "", sampled: "", lit: "map.SampleCmpLevelZero(map_sampler, (at + 0.5) / UMBRAGE_TEXTURE_SIZE, receiver)", gather_red: "", gather_green: "", gather_lit: "map.GatherCmp(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, receiver)", lit_filtered: "map.SampleCmpLevelZero(map_sampler, uv, receiver)", size: "", sampler: "", sampler_argument: "", needs: [] },
            shadow_array: { parameters: "Texture2DArray<float> map, SamplerComparisonState map_sampler, float layer", arguments: "map, map_sampler, layer", texel: "", sampled: "", lit: "map.SampleCmpLevelZero(map_sampler, float3((at + 0.5) / UMBRAGE_TEXTURE_SIZE, layer), receiver)", gather_red: "", gather_green: "", gather_lit: "map.GatherCmp(map_sampler, float3((at + 1.0) / UMBRAGE_TEXTURE_SIZE, layer), receiver)", lit_filtered: "map.SampleCmpLevelZero(map_sampler, float3(uv, layer), receiver)", size: "", sampler: "", sampler_argument: "", needs: [] },
        },
        texts: {
            "shadow_coordinate": `
// umbrage_shadow_coordinate: texture matrix times world position; (x w, y w, depth w, w), x and y in texels
float4 umbrage_shadow_coordinate(float4x4 m, float3 world) {
    precise float4 c = transpose(m)[3] + transpose(m)[0] * world.x + transpose(m)[1] * world.y + transpose(m)[2] *
        world.z;
    return c;
}
`,
            "tap_coordinate": `
// umbrage_tap_coordinate: coordinate, before the division by w, moved by offset texels
float4 umbrage_tap_coordinate(float4 coordinate, float2 offset) {
    precise float2 moved = float2(coordinate.x, coordinate.y) + offset * coordinate.w;
    return float4(moved.x, moved.y, coordinate.z, coordinate.w);
}
`,
            "project_coordinate": `
// umbrage_project_coordinate: (x, y) in texels and depth; for w <= 0.0 a coordinate that every filter takes as lit
float3 umbrage_project_coordinate(float4 coordinate) {
    float3 p = float3(coordinate.x / coordinate.w, coordinate.y / coordinate.w, coordinate.z / coordinate.w);
    return coordinate.w > 0.0 ? p : float3(65536.0, 65536.0, 0.0);
}
`,
            "cascade_by_depth": `
// umbrage_cascade_by_depth: the cascade that a distance along the camera's axis falls into, 0.0 to 3.0
//   ends  of the first three cascades, ascending
float umbrage_cascade_by_depth(float depth, float3 ends) {
    int reached = int(depth >= ends.x) + int(depth >= ends.y) + int(depth >= ends.z);
    return float(reached);
}
`,
            "cascade_column": `
// umbrage_cascade_column: a column of a matrix by its number, 0.0 to 3.0, for languages without dynamic indices
float4 umbrage_cascade_column(float4x4 columns, float number) {
    float4 low = number < 0.5 ? transpose(columns)[0] : transpose(columns)[1];
    float4 high = number < 2.5 ? transpose(columns)[2] : transpose(columns)[3];
    return number < 1.5 ? low : high;
}
`,
            "cascade_column_8": `
// umbrage_cascade_column_8: a column of two matrices by its number, 0.0 to 7.0
float4 umbrage_cascade_column_8(float4x4 nearer, float4x4 farther, float number) {
    float4 low = umbrage_cascade_column(nearer, number);
    float4 high = umbrage_cascade_column(farther, number - 4.0);
    return number < 3.5 ? low : high;
}
`,
            "cascade_coordinate": `
// umbrage_cascade_coordinate: a point, rotated into the light's directions, in a cascade's map: texels and depth
float3 umbrage_cascade_coordinate(float3 light, float4 scale, float4 offset) {
    float3 start = float3(offset.x, offset.y, offset.z);
    precise float3 at = light * float3(scale.x, scale.y, scale.z) + start;
    return at;
}
`,
            "inside_cascade": `
// umbrage_inside_cascade: whether a filter of some reach around a coordinate stays inside a map of size texels
precise bool umbrage_inside_cascade(float3 coordinate, float2 size, float reach) {
    precise float2 end = size - reach;
    // y doubled on purpose: Mesa makes min(x, y) >= reach of two comparisons with one limit, which loses a NaN
    bool in_x = coordinate.x >= reach && coordinate.x <= end.x;
    bool in_y = coordinate.y * 2.0 >= reach * 2.0 && coordinate.y * 2.0 <= end.y * 2.0;
    return in_x && in_y && coordinate.z >= 0.0 && coordinate.z <= 1.0;
}
`,
            "cascade_by_projection": `
// umbrage_cascade_by_projection: (texels, texels, depth, number) in the first of four cascades that holds a point and
//   its filter; where none does, number 4.0 and a coordinate that every filter takes as lit
//   light            the point, rotated into the light's directions
//   scales, offsets  of the cascades;   size  of each map;   reach  of the filter, in texels
float4 umbrage_cascade_by_projection(float3 light, float4x4 scales, float4x4 offsets, float2 size, float reach) {
    float3 a = umbrage_cascade_coordinate(light, transpose(scales)[0], transpose(offsets)[0]);
    float3 b = umbrage_cascade_coordinate(light, transpose(scales)[1], transpose(offsets)[1]);
    float3 c = umbrage_cascade_coordinate(light, transpose(scales)[2], transpose(offsets)[2]);
    float3 d = umbrage_cascade_coordinate(light, transpose(scales)[3], transpose(offsets)[3]);
    float4 found = float4(65536.0, 65536.0, 0.0, 4.0);
    found = umbrage_inside_cascade(d, size, reach) ? float4(d, 3.0) : found;
    found = umbrage_inside_cascade(c, size, reach) ? float4(c, 2.0) : found;
    found = umbrage_inside_cascade(b, size, reach) ? float4(b, 1.0) : found;
    return umbrage_inside_cascade(a, size, reach) ? float4(a, 0.0) : found;
}
`,
            "cascade_by_projection_8": `
// umbrage_cascade_by_projection_8: umbrage_cascade_by_projection of eight cascades, four and four; number 8.0 for none
float4 umbrage_cascade_by_projection_8(float3 light, float4x4 scales, float4x4 offsets, float4x4 farther_scales,
                                       float4x4 farther_offsets, float2 size, float reach) {
    float4 nearer = umbrage_cascade_by_projection(light, scales, offsets, size, reach);
    float4 farther = umbrage_cascade_by_projection(light, farther_scales, farther_offsets, size, reach);
    return nearer.w < 3.5 ? nearer : float4(farther.x, farther.y, farther.z, farther.w + 4.0);
}
`,
            "cascade_tile": `
// umbrage_cascade_tile: first texel of a cascade, a whole number, in an atlas of tiles of size texels, two a row
float2 umbrage_cascade_tile(float number, float2 size) {
    float row = floor(number * 0.5);
    return float2(number - row * 2.0, row) * size;
}
`,
            "cascade_weight": `
// umbrage_cascade_weight: v taken down to steps of 1/256, from 0.0 to 1.0; NaN is 0.0
float umbrage_cascade_weight(float v) {
    float steps = v > 0.0 && v < 1.0 ? floor(v * 256.0) : (v >= 1.0 ? 256.0 : 0.0);
    return steps * (1.0 / 256.0);
}
`,
            "cascade_fade": `
// umbrage_cascade_fade: weight of the next cascade at a distance along the camera's axis; depth * scale + offset
float umbrage_cascade_fade(float depth, float scale, float offset) {
    precise float v = depth * scale + offset;
    return umbrage_cascade_weight(v);
}
`,
            "cascade_border_fade": `
// umbrage_cascade_border_fade: weight of the next cascade, 1.0 from reach texels off the border of a map on
//   coordinate, size  in texels;   per_texel  weight a texel, 1.0 / width of the band along the border
float umbrage_cascade_border_fade(float2 coordinate, float2 size, float reach, float per_texel) {
    float2 half_size = size * 0.5;
    precise float2 beyond = abs(coordinate - half_size) - (half_size - reach);
    precise float2 v = beyond * per_texel + 1.0;
    float x = umbrage_cascade_weight(v.x);
    float y = umbrage_cascade_weight(v.y);
    return x > y ? x : y;
}
`,
            "blend_cascades": `
// umbrage_blend_cascades: visibilities of a cascade and of the next one, which counts by weight, mixed
float umbrage_blend_cascades(float nearer, float farther, float weight) {
    precise float sum = nearer + (farther - nearer) * weight;
    return weight < 1.0 ? sum : farther;
}
`,
            "inside_texel_space": `
// umbrage_inside_texel_space: coordinates in texels that a filter can take; it takes all others, NaN included, as lit
precise bool umbrage_inside_texel_space(float2 coord) {
    // two limits on purpose: Mesa makes max(x, y) < limit of one, which loses a NaN
    return abs(coord.x) < 32768.0 && abs(coord.y) * 2.0 < 65536.0;
}
`,
            "dither_threshold": `
// umbrage_dither_threshold: one of 16 thresholds, 1/32 to 31/32, for a position in pixels; each once in 4 x 4 pixels
float umbrage_dither_threshold(float2 pixel) {
    float2 whole = umbrage_inside_texel_space(pixel) ? floor(pixel) : float2(0.0, 0.0);
    float2 high = floor(whole * 0.5);
    float2 above = floor(whole * 0.25);
    float2 b0 = whole - high * 2.0;
    float2 b1 = high - above * 2.0;
    float m = abs(b0.x - b0.y) * 8.0 + b0.y * 4.0 + abs(b1.x - b1.y) * 2.0 + b1.y;
    return (m + 0.5) * (1.0 / 16.0);
}
`,
            "dithered_cascade": `
// umbrage_dithered_cascade: number of a cascade, or of the next one where its weight is above the pixel's threshold
float umbrage_dithered_cascade(float number, float weight, float threshold) {
    return number + (weight > threshold ? 1.0 : 0.0);
}
`,
            "cube_face": `
// umbrage_cube_face: the face that a direction meets, 0.0 to 5.0: +x, -x, +y, -y, +z, -z
float umbrage_cube_face(float3 direction) {
    float3 m = abs(direction);
    float x = direction.x < 0.0 ? 1.0 : 0.0;
    float y = direction.y < 0.0 ? 3.0 : 2.0;
    float z = direction.z < 0.0 ? 5.0 : 4.0;
    // not m.x >= m.y && m.x >= m.z, of which Mesa makes one with max(m.y, m.z), which loses a NaN
    return m.x >= m.y ? (m.x >= m.z ? x : z) : (m.y >= m.z ? y : z);
}
`,
            "cube_view_z": `
// umbrage_cube_view_z: the greatest component's magnitude, of which per-face depths are made
float umbrage_cube_view_z(float3 direction) {
    float face = umbrage_cube_face(direction);
    float side = face < 1.5 ? direction.x : direction.y;
    return abs(face > 3.5 ? direction.z : side);
}
`,
            "cube_plane": `
// umbrage_cube_plane: (sc, tc, face) of a direction: its components to the sides of the face that it meets
float3 umbrage_cube_plane(float3 direction) {
    float face = umbrage_cube_face(direction);
    float3 x = float3(face < 0.5 ? -direction.z : direction.z, -direction.y, face);
    float3 y = float3(direction.x, face < 2.5 ? direction.z : -direction.z, face);
    float3 z = float3(face < 4.5 ? direction.x : -direction.x, -direction.y, face);
    return face < 1.5 ? x : (face < 3.5 ? y : z);
}
`,
            "cube_point": `
// umbrage_cube_point: from (sc, tc, distance along its axis) of a face, 0.0 to 5.0
float3 umbrage_cube_point(float face, float3 p) {
    float3 x = face < 0.5 ? float3(p.z, -p.y, -p.x) : float3(-p.z, -p.y, p.x);
    float3 y = face < 2.5 ? float3(p.x, p.z, p.y) : float3(p.x, -p.z, -p.y);
    float3 z = face < 4.5 ? float3(p.x, -p.y, p.z) : float3(-p.x, -p.y, -p.z);
    return face < 1.5 ? x : (face < 3.5 ? y : z);
}
`,
            "cube_face_point": `
// umbrage_cube_face_point: (sc, tc, distance along its axis) in a face, 0.0 to 5.0, of a point from the cube's middle
float3 umbrage_cube_face_point(float face, float3 p) {
    float3 x = face < 0.5 ? float3(-p.z, -p.y, p.x) : float3(p.z, -p.y, -p.x);
    float3 y = face < 2.5 ? float3(p.x, p.z, p.y) : float3(p.x, -p.z, -p.y);
    float3 z = face < 4.5 ? float3(p.x, -p.y, p.z) : float3(-p.x, -p.y, -p.z);
    return face < 1.5 ? x : (face < 3.5 ? y : z);
}
`,
            "cube_coordinate": `
// umbrage_cube_coordinate: (s, t, face) of a direction; s and t go from 0.0 to 1.0 over the face
float3 umbrage_cube_coordinate(float3 direction) {
    float3 p = umbrage_cube_plane(direction);
    float m = umbrage_cube_view_z(direction);
    return float3((p.x + m) / (m + m), (p.y + m) / (m + m), p.z);
}
`,
            "cube_direction": `
// umbrage_cube_direction: from a cube's middle to a point of a face, 0.0 to 5.0; st goes from 0.0 to 1.0 over the face
float3 umbrage_cube_direction(float face, float2 st) {
    precise float2 uv = st * 2.0 - 1.0;  // an exact product: fused or not, it rounds once
    return umbrage_cube_point(face, float3(uv, 1.0));
}
`,
            "cube_neighbor": `
// umbrage_cube_neighbor: (s, t, face) of a texel that may lie beyond an edge of its face; face -1.0 beyond a corner
//   texel  (s, t, face), whole numbers;   size  of a face, in texels
float3 umbrage_cube_neighbor(float3 texel, float size) {
    float2 uv = float2(texel.x, texel.y) * 2.0 + (1.0 - size);
    bool beyond_u = abs(uv.x) > size;
    bool beyond_v = abs(uv.y) > size;
    float m = beyond_u || beyond_v ? size - 1.0 : size;
    float3 p = umbrage_cube_plane(umbrage_cube_point(texel.z, float3(uv, m)));
    float2 inside = (float2(p.x, p.y) + (size - 1.0)) * 0.5;
    return beyond_u && beyond_v ? float3(0.0, 0.0, -1.0) : float3(inside, p.z);
}
`,
            "cube_tile": `
// umbrage_cube_tile: first texel of a face, 0.0 to 5.0, in an atlas of 3 x 2 tiles of size texels
float2 umbrage_cube_tile(float face, float size) {
    float row = face < 2.5 ? 0.0 : 1.0;
    return float2((face - row * 3.0) * size, row * size);
}
`,
            "cube_atlas_texel": `
// umbrage_cube_atlas_texel: (s, t, face) of a texel of an atlas of 3 x 2 tiles of size texels; whole numbers
float3 umbrage_cube_atlas_texel(float2 texel, float size) {
    float column = texel.x < size ? 0.0 : (texel.x < size * 2.0 ? 1.0 : 2.0);
    float row = texel.y < size ? 0.0 : 1.0;
    return float3(texel - float2(column, row) * size, column + row * 3.0);
}
`,
            "cube_atlas_direction": `
// umbrage_cube_atlas_direction: from a cube's middle to that of a texel of an atlas of 3 x 2 tiles of size texels
float3 umbrage_cube_atlas_direction(float2 texel, float size) {
    float3 part = umbrage_cube_atlas_texel(texel, size);
    float2 uv = float2(part.x, part.y) * 2.0 + (1.0 - size);
    return umbrage_cube_point(part.z, float3(uv, size));
}
`,
            "dual_paraboloid_coordinate": `
// umbrage_dual_paraboloid_coordinate: (s, t, map) of a direction: 0.0 to 1.0 over the map's square, map 0.0 or 1.0
float3 umbrage_dual_paraboloid_coordinate(float3 direction) {
    precise float square = direction.x * direction.x + direction.y * direction.y + direction.z * direction.z;
    bool behind = direction.z < 0.0;
    float m = sqrt(square) + (behind ? -direction.z : direction.z);
    float x = behind ? direction.x : -direction.x;
    return float3((x + m) / (m + m), (direction.y + m) / (m + m), behind ? 1.0 : 0.0);
}
`,
            "dual_paraboloid_position": `
// umbrage_dual_paraboloid_position: (x w, y w, distance w, w) of a vertex, for the depth pass' projection
//   direction  from the light to the vertex;   map  0.0 or 1.0
float4 umbrage_dual_paraboloid_position(float3 direction, float map) {
    bool behind = map > 0.5;
    precise float square = direction.x * direction.x + direction.y * direction.y + direction.z * direction.z;
    float distance_to = sqrt(square);
    float w = distance_to + (behind ? -direction.z : direction.z);
    return float4(behind ? direction.x : -direction.x, direction.y, distance_to * w, w);
}
`,
            "tetrahedron_face": `
// umbrage_tetrahedron_face: the face that a direction meets, 0.0 to 3.0: down and +z, down and -z, up and +x, up and -x
float umbrage_tetrahedron_face(float3 direction) {
    precise float beside = abs(direction.z) - abs(direction.x);
    precise float up = direction.y * 1.414213562;
    float z = direction.z < 0.0 ? 1.0 : 0.0;
    float x = direction.x < 0.0 ? 3.0 : 2.0;
    return beside >= up ? z : x;
}
`,
            "tetrahedron_face_point": `
// umbrage_tetrahedron_face_point: (along the base, up, away) of a direction in the axes of a face, 0.0 to 3.0
float3 umbrage_tetrahedron_face_point(float face, float3 d) {
    float3 z = face < 0.5 ? float3(-d.x, d.y, d.z) : float3(d.x, d.y, -d.z);
    float3 x = face < 2.5 ? float3(-d.z, -d.y, d.x) : float3(d.z, -d.y, -d.x);
    return face < 1.5 ? z : x;
}
`,
            "tetrahedron_plane": `
// umbrage_tetrahedron_plane: (along the base, up, away) of a direction in the axes of the face that it meets
float3 umbrage_tetrahedron_plane(float3 direction) {
    return umbrage_tetrahedron_face_point(umbrage_tetrahedron_face(direction), direction);
}
`,
            "tetrahedron_view_z": `
// umbrage_tetrahedron_view_z: distance along the face's normal, of which per-face depths are made
float umbrage_tetrahedron_view_z(float3 direction) {
    float3 p = umbrage_tetrahedron_plane(direction);
    precise float z = p.z * 0.816496581 + p.y * -0.577350269;
    return z;
}
`,
            "tetrahedron_coordinate": `
// umbrage_tetrahedron_coordinate: (s, t, face) of a direction: -1.0 to 1.0 along the base, 0.0 at it to 1.0 at the apex
float3 umbrage_tetrahedron_coordinate(float3 direction) {
    float3 p = umbrage_tetrahedron_plane(direction);
    precise float d = p.z * 2.0 + p.y * -1.414213562;
    return float3(p.x / d, p.z / d, umbrage_tetrahedron_face(direction));
}
`,
            "tetrahedron_turned": `
// umbrage_tetrahedron_turned: a vector of face 0's side of the map on that of a face, 0.0 to 3.0
float2 umbrage_tetrahedron_turned(float face, float2 v) {
    float2 z = face < 0.5 ? v : float2(-v.x, -v.y);
    float2 x = face < 2.5 ? float2(-v.y, v.x) : float2(v.y, -v.x);
    return face < 1.5 ? z : x;
}
`,
            "tetrahedron_texel": `
// umbrage_tetrahedron_texel: texels of a square map, from (s, t, face) on a tetrahedron
//   size  of the map, in texels;   border  along the sides of each triangle, in texels
float2 umbrage_tetrahedron_texel(float3 at, float size, float border) {
    float half_size = size * 0.5;
    float scale = half_size - border * 3.0;
    precise float x = at.x * scale;
    precise float y = at.y * scale + (border - half_size);
    precise float2 texel = umbrage_tetrahedron_turned(at.z, float2(x, y)) + half_size;
    return texel;
}
`,
            "tetrahedron_face_of": `
// umbrage_tetrahedron_face_of: the face, 0.0 to 3.0, whose triangle in a map of size texels a texel lies in
float umbrage_tetrahedron_face_of(float2 texel, float size) {
    float2 off = texel * 2.0 + (1.0 - size);
    float column = off.y < 0.0 ? 0.0 : 1.0;
    float row = off.x < 0.0 ? 3.0 : 2.0;
    return abs(off.y) >= abs(off.x) ? column : row;
}
`,
            "pancake": `
// umbrage_pancake: a clip space position, moved onto the near plane where it lies before it
//   at_near  z/w of the near plane: 0.0 or -1.0, or 1.0 for reversed depth
float4 umbrage_pancake(float4 position, float at_near) {
    precise float plane = at_near * position.w;
    bool before = at_near > 0.5 ? position.z > plane : position.z < plane;
    return float4(position.x, position.y, before ? plane : position.z, position.w);
}
`,
            "texel": `
// umbrage_texel: value of a texel inside the map
//   map    where its texels lie; a sampler that reads them filters by nearest
//   size   of the map in texels;   texel  whole numbers, (0, 0) is the first
float4 umbrage_texel(UMBRAGE_MAP map, float2 size, float2 texel) {
    float2 at = texel + UMBRAGE_ORIGIN;
    return UMBRAGE_TEXEL;
}
`,
            "from_unorm": `
// umbrage_from_unorm: channel 0..255 behind a value read from an 8-bit texture, however the driver divides by 255
float umbrage_from_unorm(float c) {
    return floor(c * 255.0 + 0.5);
}
float2 umbrage_from_unorm(float2 c) {
    return floor(c * 255.0 + 0.5);
}
float3 umbrage_from_unorm(float3 c) {
    return floor(c * 255.0 + 0.5);
}
float4 umbrage_from_unorm(float4 c) {
    return floor(c * 255.0 + 0.5);
}
`,
            "page_coordinate": `
// umbrage_page_coordinate: a receiver in a page of an atlas: texels of the page with its gutter, the page's first texel
//   table, size   page table, RGBA8, nearest filter;   coord   receiver, from 1.0 to 2.0 across all but its border
//   page, gutter  side of a page and what it has around it, texels
float4 umbrage_page_coordinate(UMBRAGE_MAP table, float2 size, float2 coord, float page, float gutter) {
    // not negative already; compilers cannot regroup sums across max and clamp
    float2 sides = max(size - 2.0, float2(1.0, 1.0));
    float2 before = max(size - 3.0, float2(0.0, 0.0));
    float2 cell = min(max(float2(0.0, 0.0), coord * sides - before), size - 1.0);
    int2 texel = (int2)cell;  // of a NaN the first
    float4 entry = umbrage_from_unorm(umbrage_texel(table, size, (float2)texel));
    float2 slot = float2(entry.x, entry.y);
    float across = entry.z + entry.w * 256.0;
    float2 within = clamp(frac(coord * across), float2(0.0, 0.0), float2(1.0, 1.0));
    float2 at = within * page + (across > 0.0 ? gutter : 32768.0);
    return float4(at, slot * (page + gutter * 2.0));
}
`,
            "linear_depth": `
// umbrage_linear_depth: distance along the light's axis, positive in front of it, times 1 / z_far
float umbrage_linear_depth(float z_view, float inv_z_far) {
    return z_view * inv_z_far;
}
`,
            "project_depth": `
// umbrage_project_depth: z / w; for w <= 0.0 cleared, which is 1.0, or 0.0 when reversed
float umbrage_project_depth(float z, float w, float cleared) {
    return w > 0.0 ? z / w : cleared;
}
`,
            "distance_depth": `
// umbrage_distance_depth: length of to_point, from the light, times 1 / range
float umbrage_distance_depth(float3 to_point, float inv_range) {
    return sqrt(to_point.x * to_point.x + to_point.y * to_point.y + to_point.z * to_point.z) * inv_range;
}
`,
            "reverse_depth": `
// umbrage_reverse_depth: forward depth from reversed, or reversed from forward
float umbrage_reverse_depth(float depth) {
    return 1.0 - depth;
}
`,
            "depth_from_ndc": `
// umbrage_depth_from_ndc: depth in [0, 1] from z/w in [-1, 1]
float umbrage_depth_from_ndc(float ndc) {
    precise float depth = ndc * 0.5 + 0.5;
    return depth;
}
`,
            "view_z_from_depth": `
// umbrage_view_z_from_depth: perspective depth in [0, 1], 0.0 at z_near, to distance along the light's axis
float umbrage_view_z_from_depth(float depth, float z_near, float z_far) {
    return z_near / (1.0 - depth * (1.0 - z_near / z_far));
}
`,
            "depth_from_view_z": `
// umbrage_depth_from_view_z: distance along the light's axis to perspective depth in [0, 1], 0.0 at z_near
float umbrage_depth_from_view_z(float z_view, float z_near, float z_far) {
    return (1.0 - z_near / z_view) / (1.0 - z_near / z_far);
}
`,
            "view_z_from_reversed_depth": `
// umbrage_view_z_from_reversed_depth: perspective depth in [0, 1], 1.0 at z_near, to distance along the light's axis
float umbrage_view_z_from_reversed_depth(float depth, float z_near, float z_far) {
    return z_near / (z_near / z_far + depth * (1.0 - z_near / z_far));
}
`,
            "reversed_depth_from_view_z": `
// umbrage_reversed_depth_from_view_z: distance along the light's axis to perspective depth in [0, 1], 1.0 at z_near
float umbrage_reversed_depth_from_view_z(float z_view, float z_near, float z_far) {
    return z_near / z_view * (1.0 - z_view / z_far) / (1.0 - z_near / z_far);
}
`,
            "view_z_from_orthographic_depth": `
// umbrage_view_z_from_orthographic_depth: orthographic depth in [0, 1], 0.0 at z_near, to distance along the light's
// axis; when reversed, exchange z_near and z_far
float umbrage_view_z_from_orthographic_depth(float depth, float z_near, float z_far) {
    precise float z_view = z_near + depth * (z_far - z_near);
    return z_view;
}
`,
            "orthographic_depth_from_view_z": `
// umbrage_orthographic_depth_from_view_z: distance along the light's axis to orthographic depth in [0, 1], 0.0 at
// z_near; when reversed, exchange z_near and z_far
float umbrage_orthographic_depth_from_view_z(float z_view, float z_near, float z_far) {
    return (z_view - z_near) / (z_far - z_near);
}
`,
            "cleared_depth": `
// umbrage_cleared_depth: depth of the far plane
float umbrage_cleared_depth() {
    return 1.0;
}
`,
            "saturate": `
// umbrage_saturate: v clamped to [0, 1]; NaN becomes the far plane's depth
float umbrage_saturate(float v) {
    // not v > 0.0 ? v : 0.0, of which Mesa makes max(v, 0.0): softpipe's gives NaN for a signalling one
    return v > 0.0 && v < 1.0 ? v : (v >= 1.0 ? 1.0 : (v <= 0.0 ? 0.0 : umbrage_cleared_depth()));
}
`,
            "correct_quotient": `
// umbrage_correct_quotient: floor(a / b) from q, at most one off;  whole numbers, a below 2^24, b from 1 to 2^24
float umbrage_correct_quotient(float q, float a, float b) {
    float more = q + 1.0;
    float known = more * b <= a ? more : q;
    return q * b > a ? q - 1.0 : known;
}
`,
            "floor_divide": `
// umbrage_floor_divide: floor(a / b) of whole numbers, a below 2^24, b from 1 to 2^24, the quotient at most 2^18
float umbrage_floor_divide(float a, float b) {
    return umbrage_correct_quotient(floor(a / b), a, b);
}
`,
            "to_unorm": `
// umbrage_to_unorm: what to write so that an 8-bit target stores channel k, whether it rounds or truncates
// k * 257 / 65536 + 64 / 65536; not written so, since 65536.0 is infinite in mediump
float umbrage_to_unorm(float k) {
    return k * 0.0039215087890625 + 0.0009765625;
}
float2 umbrage_to_unorm(float2 k) {
    return k * 0.0039215087890625 + 0.0009765625;
}
float3 umbrage_to_unorm(float3 k) {
    return k * 0.0039215087890625 + 0.0009765625;
}
float4 umbrage_to_unorm(float4 k) {
    return k * 0.0039215087890625 + 0.0009765625;
}
`,
            "to_unorm10": `
// umbrage_to_unorm10: what to write so that a 10-bit target stores channel k, whether it rounds or truncates
// k * 4099 / 4194304 + 1056 / 4194304
float umbrage_to_unorm10(float k) {
    return k * 0.0009772777557373046875 + 0.00025177001953125;
}
float2 umbrage_to_unorm10(float2 k) {
    return k * 0.0009772777557373046875 + 0.00025177001953125;
}
float3 umbrage_to_unorm10(float3 k) {
    return k * 0.0009772777557373046875 + 0.00025177001953125;
}
float4 umbrage_to_unorm10(float4 k) {
    return k * 0.0009772777557373046875 + 0.00025177001953125;
}
`,
            "from_unorm10": `
// umbrage_from_unorm10: channel 0..1023 behind a value read from a 10-bit texture, however the driver divides by 1023
float umbrage_from_unorm10(float c) {
    return floor(c * 1023.0 + 0.5);
}
float2 umbrage_from_unorm10(float2 c) {
    return floor(c * 1023.0 + 0.5);
}
float3 umbrage_from_unorm10(float3 c) {
    return floor(c * 1023.0 + 0.5);
}
float4 umbrage_from_unorm10(float4 c) {
    return floor(c * 1023.0 + 0.5);
}
`,
            "to_unorm16": `
// umbrage_to_unorm16: what to write so that a 16-bit target stores channel k, whether it rounds or truncates
float umbrage_to_unorm16(float k) {
    return min(k + (floor(k * (1.0 / 256.0)) * (1.0 / 256.0) + 0.25), 65536.0) * (1.0 / 65536.0);
}
float2 umbrage_to_unorm16(float2 k) {
    return min(k + (floor(k * (1.0 / 256.0)) * (1.0 / 256.0) + 0.25), 65536.0) * (1.0 / 65536.0);
}
float3 umbrage_to_unorm16(float3 k) {
    return min(k + (floor(k * (1.0 / 256.0)) * (1.0 / 256.0) + 0.25), 65536.0) * (1.0 / 65536.0);
}
float4 umbrage_to_unorm16(float4 k) {
    return min(k + (floor(k * (1.0 / 256.0)) * (1.0 / 256.0) + 0.25), 65536.0) * (1.0 / 65536.0);
}
`,
            "from_unorm16": `
// umbrage_from_unorm16: channel 0..65535 behind a value read from a 16-bit texture, however the driver divides by 65535
float umbrage_from_unorm16(float c) {
    return floor(c * 65535.0 + 0.5);
}
float2 umbrage_from_unorm16(float2 c) {
    return floor(c * 65535.0 + 0.5);
}
float3 umbrage_from_unorm16(float3 c) {
    return floor(c * 65535.0 + 0.5);
}
float4 umbrage_from_unorm16(float4 c) {
    return floor(c * 65535.0 + 0.5);
}
`,
            "encode_rg9": `
// umbrage_encode_rg9: depth to the two channels of a 9-bit code, whole numbers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1], NaN counts as far
float2 umbrage_encode_rg9(float depth) {
    float x = min(floor(umbrage_saturate(depth) * 512.0), 511.0);
    float high = floor(x * (1.0 / 256.0));
    return float2(x - high * 256.0, high * 128.0);
}
`,
            "encode_rg10": `
// umbrage_encode_rg10: depth to the two channels of a 10-bit code, whole numbers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1], NaN counts as far
float2 umbrage_encode_rg10(float depth) {
    float x = min(floor(umbrage_saturate(depth) * 1024.0), 1023.0);
    float high = floor(x * (1.0 / 256.0));
    return float2(x - high * 256.0, high * 64.0);
}
`,
            "encode_rg11": `
// umbrage_encode_rg11: depth to the two channels of a 11-bit code, whole numbers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1], NaN counts as far
float2 umbrage_encode_rg11(float depth) {
    float x = min(floor(umbrage_saturate(depth) * 2048.0), 2047.0);
    float high = floor(x * (1.0 / 256.0));
    return float2(x - high * 256.0, high * 32.0);
}
`,
            "encode_rg12": `
// umbrage_encode_rg12: depth to the two channels of a 12-bit code, whole numbers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1], NaN counts as far
float2 umbrage_encode_rg12(float depth) {
    float x = min(floor(umbrage_saturate(depth) * 4096.0), 4095.0);
    float high = floor(x * (1.0 / 256.0));
    return float2(x - high * 256.0, high * 16.0);
}
`,
            "encode_rg13": `
// umbrage_encode_rg13: depth to the two channels of a 13-bit code, whole numbers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1], NaN counts as far
float2 umbrage_encode_rg13(float depth) {
    float x = min(floor(umbrage_saturate(depth) * 8192.0), 8191.0);
    float high = floor(x * (1.0 / 256.0));
    return float2(x - high * 256.0, high * 8.0);
}
`,
            "encode_rg14": `
// umbrage_encode_rg14: depth to the two channels of a 14-bit code, whole numbers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1], NaN counts as far
float2 umbrage_encode_rg14(float depth) {
    float x = min(floor(umbrage_saturate(depth) * 16384.0), 16383.0);
    float high = floor(x * (1.0 / 256.0));
    return float2(x - high * 256.0, high * 4.0);
}
`,
            "encode_rg15": `
// umbrage_encode_rg15: depth to the two channels of a 15-bit code, whole numbers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1], NaN counts as far
float2 umbrage_encode_rg15(float depth) {
    float x = min(floor(umbrage_saturate(depth) * 32768.0), 32767.0);
    float high = floor(x * (1.0 / 256.0));
    return float2(x - high * 256.0, high * 2.0);
}
`,
            "encode_rg16": `
// umbrage_encode_rg16: depth to the two channels of a 16-bit code, whole numbers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1], NaN counts as far
float2 umbrage_encode_rg16(float depth) {
    float x = min(floor(umbrage_saturate(depth) * 65536.0), 65535.0);
    float high = floor(x * (1.0 / 256.0));
    return float2(x - high * 256.0, high * 1.0);
}
`,
            "encode_rgb24": `
// umbrage_encode_rgb24: depth to three channels, R most significant, whole numbers 0..255 for umbrage_to_unorm
//   depth   clamped to [0, 1], NaN counts as far
float3 umbrage_encode_rgb24(float depth) {
    float x = min(floor(umbrage_saturate(depth) * 16777216.0), 16777215.0);
    float high = floor(x * (1.0 / 65536.0));
    float rest = x - high * 65536.0;
    float middle = floor(rest * (1.0 / 256.0));
    return float3(high, middle, min(rest - middle * 256.0, 255.0));  // below already: no sum is regrouped across the min
}
`,
            "encode_rgb10": `
// umbrage_encode_rgb10: depth to three channels, R most significant, whole numbers 0..1023 for umbrage_to_unorm10
// the last four bits are the high ones of B, so that a target cleared to white is at the far plane
//   depth   clamped to [0, 1], NaN counts as far
float3 umbrage_encode_rgb10(float depth) {
    float x = min(floor(umbrage_saturate(depth) * 16777216.0), 16777215.0);
    float high = floor(x * (1.0 / 16384.0));
    float rest = x - high * 16384.0;
    float middle = floor(rest * (1.0 / 16.0));
    float low = min(rest - middle * 16.0, 15.0);  // below already: no sum is regrouped across the min
    return float3(high, middle, low * 64.0);
}
`,
            "encode_r16": `
// umbrage_encode_r16: depth to one channel, a whole number 0..65535 for umbrage_to_unorm16
//   depth   clamped to [0, 1], NaN counts as far
float umbrage_encode_r16(float depth) {
    return min(floor(umbrage_saturate(depth) * 65536.0), 65535.0);
}
`,
            "encode_float_bits": `
// umbrage_encode_float_bits: bit pattern of v as four channels, R least significant, whole numbers 0..255
float4 umbrage_encode_float_bits(float v) {
    uint bits = asuint(v);
    return float4(float(bits & 255u), float((bits >> 8) & 255u), float((bits >> 16) & 255u), float(bits >> 24));
}
`,
            "write_threejs_rgba": `
// umbrage_write_threejs_rgba: depth to the RGBA format of three.js r167 and later, values to write as they are
float4 umbrage_write_threejs_rgba(float depth) {
    float v = umbrage_saturate(depth);
    float x = v * 16777216.0;
    float whole = floor(x);
    float high = floor(whole * (1.0 / 65536.0));
    float rest = whole - high * 65536.0;
    float middle = floor(rest * (1.0 / 256.0));
    float low = rest - middle * 256.0;
    float4 c = float4(high * 0.00392156886, middle * 0.00392156886, low * 0.00392156886, x - whole);
    return v < 1.0 ? c : float4(1.0, 1.0, 1.0, 1.0);
}
`,
            "write_threejs_rgb": `
// umbrage_write_threejs_rgb: depth to the RGB format of three.js r167 and later, values to write as they are
float3 umbrage_write_threejs_rgb(float depth) {
    float v = umbrage_saturate(depth);
    float x = v * 65536.0;
    float whole = floor(x);
    float high = floor(whole * (1.0 / 256.0));
    float3 c = float3(high * 0.00392156886, (whole - high * 256.0) * 0.00392156886, x - whole);
    return v < 1.0 ? c : float3(1.0, 1.0, 1.0);
}
`,
            "write_threejs_rg": `
// umbrage_write_threejs_rg: depth to the RG format of three.js r167 and later, values to write as they are
float2 umbrage_write_threejs_rg(float depth) {
    float v = umbrage_saturate(depth);
    float x = v * 256.0;
    float whole = floor(x);
    return v < 1.0 ? float2(whole * 0.00392156886, x - whole) : float2(1.0, 1.0);
}
`,
            "write_threejs_legacy": `
// umbrage_write_threejs_legacy: depth to the RGBA format of three.js r73 to r166, values to write as they are;
//   1.0 reads back as 255/256: umbrage_encode_threejs_legacy_repaired does not
float4 umbrage_write_threejs_legacy(float depth) {
    float v = umbrage_saturate(depth);
    float x = v * 16777216.0 - floor(v * 16777216.0);
    float y = v * 65536.0 - floor(v * 65536.0);
    float z = v * 256.0 - floor(v * 256.0);
    precise float4 c = float4(x, y - x * (1.0 / 256.0), z - y * (1.0 / 256.0), v - z * (1.0 / 256.0));
    return c * 1.00392163;
}
`,
            "encode_threejs_legacy_repaired": `
// umbrage_encode_threejs_legacy_repaired: depth to channels that readers of three.js r73 to r166 decode, 1.0 to 1.0;
//   whole numbers 0..255 (umbrage_to_unorm writes them)
float4 umbrage_encode_threejs_legacy_repaired(float depth) {
    float v = umbrage_saturate(depth);
    float x = floor(v * 16777216.0);
    float high = floor(x * (1.0 / 65536.0));
    float rest = x - high * 65536.0;
    float middle = floor(rest * (1.0 / 256.0));
    float low = min(rest - middle * 256.0, 255.0);  // below already: no sum is regrouped across the min
    return v < 1.0 ? float4(0.0, low, middle, high) : float4(255.0, 255.0, 255.0, 255.0);
}
`,
            "write_base255": `
// umbrage_write_base255: depth to base-255 RGBA, values to write as they are; 1.0 reads back as 0.0, and the store must
//   round: umbrage_encode_base255_repaired has neither fault
float4 umbrage_write_base255(float depth) {
    float v = umbrage_saturate(depth);
    precise float4 e = float4(v, v * 255.0, v * 65025.0, v * 16581375.0);
    e = e - floor(e);
    precise float4 c = float4(e.x - e.y * 0.00392156886, e.y - e.z * 0.00392156886, e.z - e.w * 0.00392156886, e.w);
    return c;
}
`,
            "encode_base255_repaired": `
// umbrage_encode_base255_repaired: depth to channels that readers of base-255 RGBA decode, 1.0 to 1.0;
//   whole numbers 0..255 (umbrage_to_unorm writes them)
float4 umbrage_encode_base255_repaired(float depth) {
    precise float x = umbrage_saturate(depth) * 255.0;
    precise float y = (x - floor(x)) * 255.0;
    precise float z = (y - floor(y)) * 255.0;
    precise float w = (z - floor(z)) * 255.0;
    return float4(floor(x), floor(y), floor(z), floor(w));
}
`,
            "fetch_clamped": `
// umbrage_fetch_clamped: texel of a map; coordinates outside move to the nearest texel inside
float4 umbrage_fetch_clamped(UMBRAGE_MAP map, float2 size, float2 texel) {
    return umbrage_texel(map, size, clamp(texel, float2(0.0, 0.0), size - 1.0));
}
`,
            "encode_rg9_table": `
// umbrage_encode_rg9_table: depth to the two channels of a 9-bit code through a look-up table, whole numbers 0..255
//   table   512 x 1 texels, row after row, nearest filter;   depth   clamped to [0, 1], NaN counts as far
float2 umbrage_encode_rg9_table(UMBRAGE_MAP table, float depth) {
    float x = min(floor(umbrage_saturate(depth) * 512.0), 511.0);
    float row = floor(x * (1.0 / 512.0));
    float2 texel = float2(x - row * 512.0, row);
    float4 k = umbrage_from_unorm(umbrage_fetch_clamped(table, float2(512.0, 1.0), texel));
    return float2(k.x, k.y);
}
`,
            "encode_rg10_table": `
// umbrage_encode_rg10_table: depth to the two channels of a 10-bit code through a look-up table, whole numbers 0..255
//   table   1024 x 1 texels, row after row, nearest filter;   depth   clamped to [0, 1], NaN counts as far
float2 umbrage_encode_rg10_table(UMBRAGE_MAP table, float depth) {
    float x = min(floor(umbrage_saturate(depth) * 1024.0), 1023.0);
    float row = floor(x * (1.0 / 1024.0));
    float2 texel = float2(x - row * 1024.0, row);
    float4 k = umbrage_from_unorm(umbrage_fetch_clamped(table, float2(1024.0, 1.0), texel));
    return float2(k.x, k.y);
}
`,
            "encode_rg11_table": `
// umbrage_encode_rg11_table: depth to the two channels of a 11-bit code through a look-up table, whole numbers 0..255
//   table   2048 x 1 texels, row after row, nearest filter;   depth   clamped to [0, 1], NaN counts as far
float2 umbrage_encode_rg11_table(UMBRAGE_MAP table, float depth) {
    float x = min(floor(umbrage_saturate(depth) * 2048.0), 2047.0);
    float row = floor(x * (1.0 / 2048.0));
    float2 texel = float2(x - row * 2048.0, row);
    float4 k = umbrage_from_unorm(umbrage_fetch_clamped(table, float2(2048.0, 1.0), texel));
    return float2(k.x, k.y);
}
`,
            "encode_rg12_table": `
// umbrage_encode_rg12_table: depth to the two channels of a 12-bit code through a look-up table, whole numbers 0..255
//   table   2048 x 2 texels, row after row, nearest filter;   depth   clamped to [0, 1], NaN counts as far
float2 umbrage_encode_rg12_table(UMBRAGE_MAP table, float depth) {
    float x = min(floor(umbrage_saturate(depth) * 4096.0), 4095.0);
    float row = floor(x * (1.0 / 2048.0));
    float2 texel = float2(x - row * 2048.0, row);
    float4 k = umbrage_from_unorm(umbrage_fetch_clamped(table, float2(2048.0, 2.0), texel));
    return float2(k.x, k.y);
}
`,
            "encode_rg13_table": `
// umbrage_encode_rg13_table: depth to the two channels of a 13-bit code through a look-up table, whole numbers 0..255
//   table   2048 x 4 texels, row after row, nearest filter;   depth   clamped to [0, 1], NaN counts as far
float2 umbrage_encode_rg13_table(UMBRAGE_MAP table, float depth) {
    float x = min(floor(umbrage_saturate(depth) * 8192.0), 8191.0);
    float row = floor(x * (1.0 / 2048.0));
    float2 texel = float2(x - row * 2048.0, row);
    float4 k = umbrage_from_unorm(umbrage_fetch_clamped(table, float2(2048.0, 4.0), texel));
    return float2(k.x, k.y);
}
`,
            "encode_rg14_table": `
// umbrage_encode_rg14_table: depth to the two channels of a 14-bit code through a look-up table, whole numbers 0..255
//   table   2048 x 8 texels, row after row, nearest filter;   depth   clamped to [0, 1], NaN counts as far
float2 umbrage_encode_rg14_table(UMBRAGE_MAP table, float depth) {
    float x = min(floor(umbrage_saturate(depth) * 16384.0), 16383.0);
    float row = floor(x * (1.0 / 2048.0));
    float2 texel = float2(x - row * 2048.0, row);
    float4 k = umbrage_from_unorm(umbrage_fetch_clamped(table, float2(2048.0, 8.0), texel));
    return float2(k.x, k.y);
}
`,
            "encode_rg15_table": `
// umbrage_encode_rg15_table: depth to the two channels of a 15-bit code through a look-up table, whole numbers 0..255
//   table   2048 x 16 texels, row after row, nearest filter;   depth   clamped to [0, 1], NaN counts as far
float2 umbrage_encode_rg15_table(UMBRAGE_MAP table, float depth) {
    float x = min(floor(umbrage_saturate(depth) * 32768.0), 32767.0);
    float row = floor(x * (1.0 / 2048.0));
    float2 texel = float2(x - row * 2048.0, row);
    float4 k = umbrage_from_unorm(umbrage_fetch_clamped(table, float2(2048.0, 16.0), texel));
    return float2(k.x, k.y);
}
`,
            "encode_rg16_table": `
// umbrage_encode_rg16_table: depth to the two channels of a 16-bit code through a look-up table, whole numbers 0..255
//   table   2048 x 32 texels, row after row, nearest filter;   depth   clamped to [0, 1], NaN counts as far
float2 umbrage_encode_rg16_table(UMBRAGE_MAP table, float depth) {
    float x = min(floor(umbrage_saturate(depth) * 65536.0), 65535.0);
    float row = floor(x * (1.0 / 2048.0));
    float2 texel = float2(x - row * 2048.0, row);
    float4 k = umbrage_from_unorm(umbrage_fetch_clamped(table, float2(2048.0, 32.0), texel));
    return float2(k.x, k.y);
}
`,
            "decode_rg9": `
// umbrage_decode_rg9: two channels of a 9-bit code, as sampled, to depth
//   edge   0.0, 0.5, 1.0: lower edge, center, upper edge of the code's interval
float umbrage_decode_rg9(float2 c, float edge) {
    float2 k = umbrage_from_unorm(c);
    return (k.x + k.y * 2.0 + edge) * (1.0 / 512.0);
}
`,
            "decode_rg10": `
// umbrage_decode_rg10: two channels of a 10-bit code, as sampled, to depth
//   edge   0.0, 0.5, 1.0: lower edge, center, upper edge of the code's interval
float umbrage_decode_rg10(float2 c, float edge) {
    float2 k = umbrage_from_unorm(c);
    return (k.x + k.y * 4.0 + edge) * (1.0 / 1024.0);
}
`,
            "decode_rg11": `
// umbrage_decode_rg11: two channels of a 11-bit code, as sampled, to depth
//   edge   0.0, 0.5, 1.0: lower edge, center, upper edge of the code's interval
float umbrage_decode_rg11(float2 c, float edge) {
    float2 k = umbrage_from_unorm(c);
    return (k.x + k.y * 8.0 + edge) * (1.0 / 2048.0);
}
`,
            "decode_rg12": `
// umbrage_decode_rg12: two channels of a 12-bit code, as sampled, to depth
//   edge   0.0, 0.5, 1.0: lower edge, center, upper edge of the code's interval
float umbrage_decode_rg12(float2 c, float edge) {
    float2 k = umbrage_from_unorm(c);
    return (k.x + k.y * 16.0 + edge) * (1.0 / 4096.0);
}
`,
            "decode_rg13": `
// umbrage_decode_rg13: two channels of a 13-bit code, as sampled, to depth
//   edge   0.0, 0.5, 1.0: lower edge, center, upper edge of the code's interval
float umbrage_decode_rg13(float2 c, float edge) {
    float2 k = umbrage_from_unorm(c);
    return (k.x + k.y * 32.0 + edge) * (1.0 / 8192.0);
}
`,
            "decode_rg14": `
// umbrage_decode_rg14: two channels of a 14-bit code, as sampled, to depth
//   edge   0.0, 0.5, 1.0: lower edge, center, upper edge of the code's interval
float umbrage_decode_rg14(float2 c, float edge) {
    float2 k = umbrage_from_unorm(c);
    return (k.x + k.y * 64.0 + edge) * (1.0 / 16384.0);
}
`,
            "decode_rg15": `
// umbrage_decode_rg15: two channels of a 15-bit code, as sampled, to depth
//   edge   0.0, 0.5, 1.0: lower edge, center, upper edge of the code's interval
float umbrage_decode_rg15(float2 c, float edge) {
    float2 k = umbrage_from_unorm(c);
    return (k.x + k.y * 128.0 + edge) * (1.0 / 32768.0);
}
`,
            "decode_rg16": `
// umbrage_decode_rg16: two channels of a 16-bit code, as sampled, to depth
//   edge   0.0, 0.5, 1.0: lower edge, center, upper edge of the code's interval
float umbrage_decode_rg16(float2 c, float edge) {
    float2 k = umbrage_from_unorm(c);
    return (k.x + k.y * 256.0 + edge) * (1.0 / 65536.0);
}
`,
            "decode_rgb24": `
// umbrage_decode_rgb24: three channels, as sampled, to depth
//   edge   0.0 or 1.0: lower or upper edge of the code's interval
float umbrage_decode_rgb24(float3 c, float edge) {
    float3 k = umbrage_from_unorm(c);
    return ((k.x * 256.0 + k.y) * 256.0 + k.z + edge) * (1.0 / 16777216.0);
}
`,
            "decode_rgb10": `
// umbrage_decode_rgb10: three 10-bit channels, as sampled, to depth
//   edge   0.0 or 1.0: lower or upper edge of the code's interval
float umbrage_decode_rgb10(float3 c, float edge) {
    float3 k = umbrage_from_unorm10(c);
    return ((k.x * 1024.0 + k.y) * 16.0 + floor(k.z * (1.0 / 64.0)) + edge) * (1.0 / 16777216.0);
}
`,
            "decode_r16": `
// umbrage_decode_r16: one channel of 16 bits, as sampled, to depth
//   edge   0.0, 0.5 or 1.0: lower edge, center or upper edge of the code's interval
float umbrage_decode_r16(float c, float edge) {
    return (umbrage_from_unorm16(c) + edge) * (1.0 / 65536.0);
}
`,
            "decode_float_bits": `
// umbrage_decode_float_bits: four channels of a bit pattern, as sampled, R least significant, to the float
float umbrage_decode_float_bits(float4 c) {
    uint r = uint(umbrage_saturate(c.x) * 255.0 + 0.5);
    uint g = uint(umbrage_saturate(c.y) * 255.0 + 0.5);
    uint b = uint(umbrage_saturate(c.z) * 255.0 + 0.5);
    uint a = uint(umbrage_saturate(c.w) * 255.0 + 0.5);
    return asfloat(r | (g << 8) | (b << 16) | (a << 24));
}
`,
            "decode_threejs_rgba": `
// umbrage_decode_threejs_rgba: the RGBA format of three.js r167 and later, as sampled, to depth
float umbrage_decode_threejs_rgba(float4 c) {
    precise float depth = c.x * (255.0 / 256.0) + c.y * (255.0 / 65536.0) + c.z * (255.0 / 16777216.0) + c.w *
        (1.0 / 16777216.0);
    return depth;
}
`,
            "decode_threejs_rgb": `
// umbrage_decode_threejs_rgb: the RGB format of three.js r167 and later, as sampled, to depth
float umbrage_decode_threejs_rgb(float3 c) {
    precise float depth = c.x * (255.0 / 256.0) + c.y * (255.0 / 65536.0) + c.z * (1.0 / 65536.0);
    return depth;
}
`,
            "decode_threejs_rg": `
// umbrage_decode_threejs_rg: the RG format of three.js r167 and later, as sampled, to depth
float umbrage_decode_threejs_rg(float2 c) {
    precise float depth = c.x * (255.0 / 256.0) + c.y * (1.0 / 256.0);
    return depth;
}
`,
            "decode_threejs_legacy": `
// umbrage_decode_threejs_legacy: the RGBA format of three.js r73 to r166, as sampled, to depth
float umbrage_decode_threejs_legacy(float4 c) {
    precise float depth = c.x * (255.0 / 4294967296.0) + c.y * (255.0 / 16777216.0) + c.z * (255.0 / 65536.0) + c.w *
        (255.0 / 256.0);
    return depth;
}
`,
            "decode_base255": `
// umbrage_decode_base255: base-255 RGBA, as sampled, to depth
float umbrage_decode_base255(float4 c) {
    precise float depth = c.x + c.y * 0.00392156886 + c.z * 0.0000153787005 + c.w * 0.0000000603086294;
    return depth;
}
`,
            "level_rg9": `
// umbrage_level_rg9: two channels of a 9-bit code, as sampled, to the scale of umbrage_receiver_rg9, on which 1.0 is
//   not the far plane
float umbrage_level_rg9(float2 c) {
    return c.x + c.y * 2.0;  // an exact product: fused or not, it rounds once
}
`,
            "level_rg10": `
// umbrage_level_rg10: two channels of a 10-bit code, as sampled, to the scale of umbrage_receiver_rg10, on which 1.0 is
//   not the far plane
float umbrage_level_rg10(float2 c) {
    return c.x + c.y * 4.0;  // an exact product: fused or not, it rounds once
}
`,
            "level_rg11": `
// umbrage_level_rg11: two channels of a 11-bit code, as sampled, to the scale of umbrage_receiver_rg11, on which 1.0 is
//   not the far plane
float umbrage_level_rg11(float2 c) {
    return c.x + c.y * 8.0;  // an exact product: fused or not, it rounds once
}
`,
            "level_rg12": `
// umbrage_level_rg12: two channels of a 12-bit code, as sampled, to the scale of umbrage_receiver_rg12, on which 1.0 is
//   not the far plane
float umbrage_level_rg12(float2 c) {
    return c.x + c.y * 16.0;  // an exact product: fused or not, it rounds once
}
`,
            "level_rg13": `
// umbrage_level_rg13: two channels of a 13-bit code, as sampled, to the scale of umbrage_receiver_rg13, on which 1.0 is
//   not the far plane
float umbrage_level_rg13(float2 c) {
    return c.x + c.y * 32.0;  // an exact product: fused or not, it rounds once
}
`,
            "level_rg14": `
// umbrage_level_rg14: two channels of a 14-bit code, as sampled, to the scale of umbrage_receiver_rg14, on which 1.0 is
//   not the far plane
float umbrage_level_rg14(float2 c) {
    return c.x + c.y * 64.0;  // an exact product: fused or not, it rounds once
}
`,
            "level_rg15": `
// umbrage_level_rg15: two channels of a 15-bit code, as sampled, to the scale of umbrage_receiver_rg15, on which 1.0 is
//   not the far plane
float umbrage_level_rg15(float2 c) {
    return c.x + c.y * 128.0;  // an exact product: fused or not, it rounds once
}
`,
            "level_rg16": `
// umbrage_level_rg16: two channels of a 16-bit code, as sampled, to the scale of umbrage_receiver_rg16, on which 1.0 is
//   not the far plane
float umbrage_level_rg16(float2 c) {
    return c.x + c.y * 256.0;  // an exact product: fused or not, it rounds once
}
`,
            "receiver_rg9": `
// umbrage_receiver_rg9: receiver on the scale of umbrage_level_rg9: it is <= a texel's level exactly when
//   depth <= umbrage_decode_rg9(texel, edge), or beyond the far plane
float umbrage_receiver_rg9(float depth, float edge) {
    precise float level = (ceil(depth * 512.0 - edge) - 0.5) * 0.00392156886;
    return depth > 1.0 ? -1.0 : level;
}
`,
            "receiver_rg10": `
// umbrage_receiver_rg10: receiver on the scale of umbrage_level_rg10: it is <= a texel's level exactly when
//   depth <= umbrage_decode_rg10(texel, edge), or beyond the far plane
float umbrage_receiver_rg10(float depth, float edge) {
    precise float level = (ceil(depth * 1024.0 - edge) - 0.5) * 0.00392156886;
    return depth > 1.0 ? -1.0 : level;
}
`,
            "receiver_rg11": `
// umbrage_receiver_rg11: receiver on the scale of umbrage_level_rg11: it is <= a texel's level exactly when
//   depth <= umbrage_decode_rg11(texel, edge), or beyond the far plane
float umbrage_receiver_rg11(float depth, float edge) {
    precise float level = (ceil(depth * 2048.0 - edge) - 0.5) * 0.00392156886;
    return depth > 1.0 ? -1.0 : level;
}
`,
            "receiver_rg12": `
// umbrage_receiver_rg12: receiver on the scale of umbrage_level_rg12: it is <= a texel's level exactly when
//   depth <= umbrage_decode_rg12(texel, edge), or beyond the far plane
float umbrage_receiver_rg12(float depth, float edge) {
    precise float level = (ceil(depth * 4096.0 - edge) - 0.5) * 0.00392156886;
    return depth > 1.0 ? -1.0 : level;
}
`,
            "receiver_rg13": `
// umbrage_receiver_rg13: receiver on the scale of umbrage_level_rg13: it is <= a texel's level exactly when
//   depth <= umbrage_decode_rg13(texel, edge), or beyond the far plane
float umbrage_receiver_rg13(float depth, float edge) {
    precise float level = (ceil(depth * 8192.0 - edge) - 0.5) * 0.00392156886;
    return depth > 1.0 ? -1.0 : level;
}
`,
            "receiver_rg14": `
// umbrage_receiver_rg14: receiver on the scale of umbrage_level_rg14: it is <= a texel's level exactly when
//   depth <= umbrage_decode_rg14(texel, edge), or beyond the far plane
float umbrage_receiver_rg14(float depth, float edge) {
    precise float level = (ceil(depth * 16384.0 - edge) - 0.5) * 0.00392156886;
    return depth > 1.0 ? -1.0 : level;
}
`,
            "receiver_rg15": `
// umbrage_receiver_rg15: receiver on the scale of umbrage_level_rg15: it is <= a texel's level exactly when
//   depth <= umbrage_decode_rg15(texel, edge), or beyond the far plane
float umbrage_receiver_rg15(float depth, float edge) {
    precise float level = (ceil(depth * 32768.0 - edge) - 0.5) * 0.00392156886;
    return depth > 1.0 ? -1.0 : level;
}
`,
            "receiver_rg16": `
// umbrage_receiver_rg16: receiver on the scale of umbrage_level_rg16: it is <= a texel's level exactly when
//   depth <= umbrage_decode_rg16(texel, edge), or beyond the far plane
float umbrage_receiver_rg16(float depth, float edge) {
    precise float level = (ceil(depth * 65536.0 - edge) - 0.5) * 0.00392156886;
    return depth > 1.0 ? -1.0 : level;
}
`,
            "decode_ps14": `
// umbrage_decode_ps14: the channels of an 11-bit code, as sampled, to x / 2040; compare with umbrage_receiver_ps14;
//   1.0 is not the far plane on this scale
float umbrage_decode_ps14(float2 c) {
    return c.x * 0.125 + c.y;  // an exact product: fused or not, it rounds once
}
`,
            "receiver_ps14": `
// umbrage_receiver_ps14: depth * 256 / 255, the scale of umbrage_decode_ps14; beyond the far plane what every texel
//   lights
float umbrage_receiver_ps14(float depth) {
    return depth > 1.0 ? -1.0 : depth * 1.00392163;
}
`,
            "inside_map": `
// umbrage_inside_map: whether a texel is one of a map's of size texels
precise bool umbrage_inside_map(float2 size, float2 texel) {
    return texel.x >= 0.0 && texel.y >= 0.0 && texel.x < size.x && texel.y < size.y;
}
`,
            "fetch_bordered": `
// umbrage_fetch_bordered: texel of a map, or border outside of it
float4 umbrage_fetch_bordered(UMBRAGE_MAP map, float2 size, float2 texel, float4 border) {
    float2 at = clamp(texel, float2(0.0, 0.0), size - 1.0);
    float4 value = umbrage_texel(map, size, at);
    return at.x == texel.x && at.y == texel.y ? value : border;
}
`,
            "fetch_depth": `
// umbrage_fetch_depth: stored depth of a texel, outside the map that of the far plane
float umbrage_fetch_depth(UMBRAGE_MAP map, float2 size, float2 texel) {
    float2 inside = clamp(texel, float2(0.0, 0.0), size - 1.0);
    float4 value = umbrage_texel(map, size, inside);
    float depth = UMBRAGE_DEPTH;
    return inside.x == texel.x && inside.y == texel.y ? depth : UMBRAGE_BORDER;
}
`,
            "depth_at": `
// umbrage_depth_at: stored depth of the texel at a point; on a border it may be the texel beside
//   uv  over the map, (0.0, 0.0) to (1.0, 1.0), no NaN
float umbrage_depth_at(UMBRAGE_MAP map, float2 size, float2 uv) {
    return umbrage_fetch_depth(map, size, floor(uv * size));
}
`,
            "beyond_far_plane": `
// umbrage_beyond_far_plane: whether a receiver is behind the far plane
precise bool umbrage_beyond_far_plane(float receiver) {
    return receiver > 1.0;
}
`,
            "in_filter_domain": `
// umbrage_in_filter_domain: whether a filter compares; outside texel space and beyond the far plane all is lit
precise bool umbrage_in_filter_domain(float2 coord, float receiver) {
    // a choice, not a && !b: of !(receiver > 1.0) FXC makes receiver <= 1.0, which loses a NaN
    return umbrage_beyond_far_plane(receiver) ? false : umbrage_inside_texel_space(coord);
}
`,
            "compare": `
// umbrage_compare: 1.0 when the receiver is no farther than the stored depth
float umbrage_compare(float receiver, float stored) {
    return receiver <= stored ? 1.0 : 0.0;
}
`,
            "lit": `
// umbrage_lit: visibility of one comparison with a texel
float umbrage_lit(UMBRAGE_MAP map, float2 size, float2 texel, float receiver) {
    return umbrage_compare(receiver, umbrage_fetch_depth(map, size, texel));
}
`,
            "lit_2x2": `
// umbrage_lit_2x2: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1)
float4 umbrage_lit_2x2(UMBRAGE_MAP map, float2 size, float2 texel, float receiver) {
    float a = umbrage_lit(map, size, texel, receiver);
    float b = umbrage_lit(map, size, texel + float2(1.0, 0.0), receiver);
    float c = umbrage_lit(map, size, texel + float2(0.0, 1.0), receiver);
    float d = umbrage_lit(map, size, texel + float2(1.0, 1.0), receiver);
    return float4(a, b, c, d);
}
`,
            "map_covers": `
// umbrage_map_covers: whether a receiver of a prefiltered map or a table lies in the map; elsewhere it is lit
precise bool umbrage_map_covers(float2 size, float2 coord) {
    return coord.x >= 0.0 && coord.y >= 0.0 && coord.x < size.x && coord.y < size.y;
}
`,
            "within_far_plane": `
// umbrage_within_far_plane: whether a receiver is a number, and not behind the far plane
precise bool umbrage_within_far_plane(float receiver) {
    return receiver <= 1.0;
}
`,
            "compare_dx_sdk": `
// umbrage_compare_dx_sdk: 0.0 when stored + epsilon < receiver, else 1.0
float umbrage_compare_dx_sdk(float receiver, float stored, float epsilon) {
    precise float limit = stored + epsilon;
    return limit < receiver ? 0.0 : 1.0;
}
`,
            "compare_exercise": `
// umbrage_compare_exercise: 1.0 when current < stored + epsilon, else 0.0
float umbrage_compare_exercise(float current, float stored, float epsilon) {
    precise float limit = stored + epsilon;
    return current < limit ? 1.0 : 0.0;
}
`,
            "window_sum3": `
// umbrage_window_sum3: weighted count of the lit texels under weights that slide over the map, whole
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   steps  of a texel, a power of two up to 256
//   k0 .. k1   weights from the edge to the middle one; the others mirror them. Steps times their sum, a whole number
//              up to 4096, squared is what is wholly lit
float umbrage_window_sum3(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float steps, float k0, float k1) {
    bool compared = umbrage_in_filter_domain(coord, receiver);  // no branch: fetches overlap
    float2 x = compared ? floor(coord * 256.0) - 128.0 : float2(0.0, 0.0);
    float2 texel = floor(x * (1.0 / 256.0));
    float2 s = floor((x - texel * 256.0) * (1.0 / 256.0) * steps);
    float2 r = steps - s;
    float whole = steps * (k0 + k1 + k0);
    float2 w0 = floor(r * k0);
    float2 w2 = floor(r * k0 + s * k1);
    float2 w3 = floor(s * k0);
    float2 w1 = max(whole - (w0 + w2 + w3), float2(0.0, 0.0));
    float2 first = texel - 1.0;
    float n = 0.0;
    float4 a = umbrage_lit_2x2(map, size, first + float2(0.0, 0.0), receiver);
    float4 b = umbrage_lit_2x2(map, size, first + float2(2.0, 0.0), receiver);
    n += w0.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y);
    n += w1.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w);
    a = umbrage_lit_2x2(map, size, first + float2(0.0, 2.0), receiver);
    b = umbrage_lit_2x2(map, size, first + float2(2.0, 2.0), receiver);
    n += w2.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y);
    n += w3.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w);
    return compared ? n : whole * whole;
}
`,
            "window_sum5": `
// umbrage_window_sum5: weighted count of the lit texels under weights that slide over the map, whole
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   steps  of a texel, a power of two up to 256
//   k0 .. k2   weights from the edge to the middle one; the others mirror them. Steps times their sum, a whole number
//              up to 4096, squared is what is wholly lit
float umbrage_window_sum5(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float steps, float k0, float k1,
                          float k2) {
    bool compared = umbrage_in_filter_domain(coord, receiver);  // no branch: fetches overlap
    float2 x = compared ? floor(coord * 256.0) - 128.0 : float2(0.0, 0.0);
    float2 texel = floor(x * (1.0 / 256.0));
    float2 s = floor((x - texel * 256.0) * (1.0 / 256.0) * steps);
    float2 r = steps - s;
    float whole = steps * (k0 + k1 + k2 + k1 + k0);
    float2 w0 = floor(r * k0);
    float2 w1 = floor(r * k1 + s * k0);
    float2 w3 = floor(r * k1 + s * k2);
    float2 w4 = floor(r * k0 + s * k1);
    float2 w5 = floor(s * k0);
    float2 w2 = max(whole - (w0 + w1 + w3 + w4 + w5), float2(0.0, 0.0));
    float2 first = texel - 2.0;
    float n = 0.0;
    float4 a = umbrage_lit_2x2(map, size, first + float2(0.0, 0.0), receiver);
    float4 b = umbrage_lit_2x2(map, size, first + float2(2.0, 0.0), receiver);
    float4 c = umbrage_lit_2x2(map, size, first + float2(4.0, 0.0), receiver);
    n += w0.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y);
    n += w1.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w);
    a = umbrage_lit_2x2(map, size, first + float2(0.0, 2.0), receiver);
    b = umbrage_lit_2x2(map, size, first + float2(2.0, 2.0), receiver);
    c = umbrage_lit_2x2(map, size, first + float2(4.0, 2.0), receiver);
    n += w2.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y);
    n += w3.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w);
    a = umbrage_lit_2x2(map, size, first + float2(0.0, 4.0), receiver);
    b = umbrage_lit_2x2(map, size, first + float2(2.0, 4.0), receiver);
    c = umbrage_lit_2x2(map, size, first + float2(4.0, 4.0), receiver);
    n += w4.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y);
    n += w5.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w);
    return compared ? n : whole * whole;
}
`,
            "window_sum7": `
// umbrage_window_sum7: weighted count of the lit texels under weights that slide over the map, whole
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   steps  of a texel, a power of two up to 256
//   k0 .. k3   weights from the edge to the middle one; the others mirror them. Steps times their sum, a whole number
//              up to 4096, squared is what is wholly lit
float umbrage_window_sum7(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float steps, float k0, float k1,
                          float k2, float k3) {
    bool compared = umbrage_in_filter_domain(coord, receiver);  // no branch: fetches overlap
    float2 x = compared ? floor(coord * 256.0) - 128.0 : float2(0.0, 0.0);
    float2 texel = floor(x * (1.0 / 256.0));
    float2 s = floor((x - texel * 256.0) * (1.0 / 256.0) * steps);
    float2 r = steps - s;
    float whole = steps * (k0 + k1 + k2 + k3 + k2 + k1 + k0);
    float2 w0 = floor(r * k0);
    float2 w1 = floor(r * k1 + s * k0);
    float2 w2 = floor(r * k2 + s * k1);
    float2 w4 = floor(r * k2 + s * k3);
    float2 w5 = floor(r * k1 + s * k2);
    float2 w6 = floor(r * k0 + s * k1);
    float2 w7 = floor(s * k0);
    float2 w3 = max(whole - (w0 + w1 + w2 + w4 + w5 + w6 + w7), float2(0.0, 0.0));
    float2 first = texel - 3.0;
    float n = 0.0;
    float4 a = umbrage_lit_2x2(map, size, first + float2(0.0, 0.0), receiver);
    float4 b = umbrage_lit_2x2(map, size, first + float2(2.0, 0.0), receiver);
    float4 c = umbrage_lit_2x2(map, size, first + float2(4.0, 0.0), receiver);
    float4 d = umbrage_lit_2x2(map, size, first + float2(6.0, 0.0), receiver);
    n += w0.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y + w6.x * d.x + w7.x * d.y);
    n += w1.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w + w6.x * d.z + w7.x * d.w);
    a = umbrage_lit_2x2(map, size, first + float2(0.0, 2.0), receiver);
    b = umbrage_lit_2x2(map, size, first + float2(2.0, 2.0), receiver);
    c = umbrage_lit_2x2(map, size, first + float2(4.0, 2.0), receiver);
    d = umbrage_lit_2x2(map, size, first + float2(6.0, 2.0), receiver);
    n += w2.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y + w6.x * d.x + w7.x * d.y);
    n += w3.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w + w6.x * d.z + w7.x * d.w);
    a = umbrage_lit_2x2(map, size, first + float2(0.0, 4.0), receiver);
    b = umbrage_lit_2x2(map, size, first + float2(2.0, 4.0), receiver);
    c = umbrage_lit_2x2(map, size, first + float2(4.0, 4.0), receiver);
    d = umbrage_lit_2x2(map, size, first + float2(6.0, 4.0), receiver);
    n += w4.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y + w6.x * d.x + w7.x * d.y);
    n += w5.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w + w6.x * d.z + w7.x * d.w);
    a = umbrage_lit_2x2(map, size, first + float2(0.0, 6.0), receiver);
    b = umbrage_lit_2x2(map, size, first + float2(2.0, 6.0), receiver);
    c = umbrage_lit_2x2(map, size, first + float2(4.0, 6.0), receiver);
    d = umbrage_lit_2x2(map, size, first + float2(6.0, 6.0), receiver);
    n += w6.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y + w6.x * d.x + w7.x * d.y);
    n += w7.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w + w6.x * d.z + w7.x * d.w);
    return compared ? n : whole * whole;
}
`,
            "disc_rotation": `
// umbrage_disc_rotation: (cos, sin) in 1/64 of one of 16 turns for a pixel, such as gl_FragCoord.xy: each once in 4 x 4
float2 umbrage_disc_rotation(float2 pixel) {
    float2 whole = umbrage_inside_texel_space(pixel) ? floor(pixel) : float2(0.0, 0.0);
    float v = whole.x * 4.0 + whole.y;
    v = v - floor(v * (1.0 / 16.0)) * 16.0;
    float quarter = floor(v * 0.25);
    float base = v - quarter * 4.0;
    float2 low = base < 0.5 ? float2(64.0, 0.0) : float2(59.0, 24.0);
    float2 high = base < 2.5 ? float2(45.0, 45.0) : float2(24.0, 59.0);
    float2 first = base < 1.5 ? low : high;
    float2 once = quarter < 0.5 ? first : float2(0.0 - first.y, first.x);
    float2 twice = quarter < 2.5 ? float2(0.0 - first.x, 0.0 - first.y) : float2(first.y, 0.0 - first.x);
    return quarter < 1.5 ? once : twice;
}
`,
            "disc_tap": `
// umbrage_disc_tap: the texel that a point of a disc falls on
//   position  floor(256 coord) of the receiver;   p  point, in 1/16 of the radius;   rotation  of umbrage_disc_rotation
//   radius    in 1/16 texel, a whole number from 0 to 4095
float2 umbrage_disc_tap(float2 position, float2 p, float2 rotation, float radius) {
    float2 at = position * (1.0 / 256.0);
    float2 texel = floor(at);
    float2 within = clamp(at - texel, float2(0.0, 0.0), float2(1.0, 1.0));  // no sum is regrouped across it
    float2 scaled = rotation * (radius * (1.0 / 16384.0));
    float x = scaled.x * p.x + within.x - scaled.y * p.y;
    float y = scaled.y * p.x + within.y + scaled.x * p.y;
    return texel + floor(float2(x, y));
}
`,
            "disc_radius": `
// umbrage_disc_radius: a disc's radius in 1/16 texel, from one in texels: a whole number from 0 to 4095, of a NaN 0
float umbrage_disc_radius(float radius) {
    float inside = radius > 0.0 ? floor(radius * 16.0) : 0.0;
    return radius >= 255.9375 ? 4095.0 : inside;
}
`,
            "disc8": `
// umbrage_disc8: lit share of 8 points of a disc; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   radius  in texels, at most 255.9375;   rotation  umbrage_disc_rotation of the pixel
float umbrage_disc8(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float radius, float2 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 at = compared ? floor(coord * 256.0) : float2(0.0, 0.0);  // no branch: fetches overlap
    float rho = umbrage_disc_radius(radius);
    float n = 0.0;
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(3.0, -1.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-4.0, 5.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(1.0, -11.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-9.0, -8.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-12.0, 3.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(11.0, 6.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(0.0, 13.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(11.0, -7.0), rotation, rho), receiver);
    return compared ? n * (1.0 / 8.0) : 1.0;
}
`,
            "disc16": `
// umbrage_disc16: lit share of 16 points of a disc; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   radius  in texels, at most 255.9375;   rotation  umbrage_disc_rotation of the pixel
float umbrage_disc16(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float radius, float2 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 at = compared ? floor(coord * 256.0) : float2(0.0, 0.0);  // no branch: fetches overlap
    float rho = umbrage_disc_radius(radius);
    float n = 0.0;
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(1.0, -3.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(5.0, 2.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-5.0, 2.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(0.0, 7.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-6.0, -5.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(8.0, -5.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(0.0, -11.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(11.0, 5.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-12.0, 4.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-1.0, 13.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(7.0, 11.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-9.0, 10.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-13.0, -4.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(7.0, -12.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-7.0, -12.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(14.0, -2.0), rotation, rho), receiver);
    return compared ? n * (1.0 / 16.0) : 1.0;
}
`,
            "disc32": `
// umbrage_disc32: lit share of 32 points of a disc; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   radius  in texels, at most 255.9375;   rotation  umbrage_disc_rotation of the pixel
float umbrage_disc32(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float radius, float2 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 at = compared ? floor(coord * 256.0) : float2(0.0, 0.0);  // no branch: fetches overlap
    float rho = umbrage_disc_radius(radius);
    float n = 0.0;
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-2.0, -1.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(3.0, 2.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(1.0, -4.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-4.0, 3.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(0.0, 6.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-5.0, -5.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(7.0, -2.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-8.0, -1.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(8.0, 3.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(5.0, 7.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(1.0, -9.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(6.0, -7.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-8.0, 5.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(0.0, 10.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-3.0, -10.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-6.0, 10.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-9.0, -8.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(11.0, -5.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(5.0, -12.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-13.0, -1.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(7.0, 11.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(13.0, 3.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-13.0, 4.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(10.0, -10.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(14.0, -2.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-11.0, 9.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(3.0, 14.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-13.0, -6.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(12.0, 8.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-4.0, 14.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-7.0, -13.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(0.0, -15.0), rotation, rho), receiver);
    return compared ? n * (1.0 / 32.0) : 1.0;
}
`,
            "hard": `
// umbrage_hard: unfiltered shadow test; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased
float umbrage_hard(UMBRAGE_MAP map, float2 size, float2 coord, float receiver) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 texel = compared ? floor(coord) : float2(0.0, 0.0);  // no branch: fetches of several taps overlap
    float lit = umbrage_lit(map, size, texel, receiver);
    return compared ? lit : 1.0;
}
`,
            "four_tap": `
// umbrage_four_tap: mean of the shadow test at four taps; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   a, b, c, d  taps in texels, all lit where their mean is 2^15
//   or more in a direction;   receiver  depth, biased
float umbrage_four_tap(UMBRAGE_MAP map, float2 size, float2 a, float2 b, float2 c, float2 d, float receiver) {
    float2 a_texel = floor(a);
    float2 b_texel = floor(b);
    float2 c_texel = floor(c);
    float2 d_texel = floor(d);
    float2 sum = abs(a_texel) + abs(b_texel) + abs(c_texel) + abs(d_texel);
    // two limits on purpose: Mesa makes max(x, y) < limit of one, which loses a NaN
    bool compared = umbrage_beyond_far_plane(receiver) ? false : sum.x < 131072.0 && sum.y * 2.0 < 262144.0;
    float count = umbrage_lit(map, size, a_texel, receiver) + umbrage_lit(map, size, b_texel, receiver) +
        umbrage_lit(map, size, c_texel, receiver) + umbrage_lit(map, size, d_texel, receiver);
    return compared ? count * 0.25 : 1.0;
}
`,
            "pcf_2x2": `
// umbrage_pcf_2x2: bilinear percentage-closer filtering; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased
float umbrage_pcf_2x2(UMBRAGE_MAP map, float2 size, float2 coord, float receiver) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 x = compared ? floor(coord * 256.0) - 128.0 : float2(0.0, 0.0);  // no branch: fetches overlap
    float2 texel = floor(x * (1.0 / 256.0));
    // weights are in [0, 1) already; compilers cannot regroup sums across the clamp
    float2 hi = clamp(x * (1.0 / 256.0) - texel, float2(0.0, 0.0), float2(1.0, 1.0));
    float2 lo = 1.0 - hi;
    float4 lit = umbrage_lit_2x2(map, size, texel, receiver);
    float visibility = lo.y * (lo.x * lit.x + hi.x * lit.y) + hi.y * (lo.x * lit.z + hi.x * lit.w);
    return compared ? visibility : 1.0;
}
`,
            "pcf_2x2_dx_sdk": `
// umbrage_pcf_2x2_dx_sdk: the DirectX SDK sample's 2x2 filter; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, not biased;   epsilon  in depth, added to the stored side
float umbrage_pcf_2x2_dx_sdk(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float epsilon) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    precise float2 x = compared ? coord - 0.5 : float2(0.0, 0.0);  // no branch: fetches overlap
    float2 texel = floor(x);
    precise float2 weight = x - texel;
    float a = umbrage_compare_dx_sdk(receiver, umbrage_fetch_depth(map, size, texel), epsilon);
    float right = umbrage_fetch_depth(map, size, texel + float2(1.0, 0.0));
    float above = umbrage_fetch_depth(map, size, texel + float2(0.0, 1.0));
    float beyond = umbrage_fetch_depth(map, size, texel + float2(1.0, 1.0));
    float b = umbrage_compare_dx_sdk(receiver, right, epsilon);
    float c = umbrage_compare_dx_sdk(receiver, above, epsilon);
    float d = umbrage_compare_dx_sdk(receiver, beyond, epsilon);
    precise float low = a + weight.x * (b - a);
    precise float high = c + weight.x * (d - c);
    precise float visibility = low + weight.y * (high - low);
    return compared ? visibility : 1.0;
}
`,
            "box_count": `
// umbrage_box_count: lit texels in the (2r+1) x (2r+1) box around the receiver's own, a whole number
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   radius  r, clamped to 0..8, best a constant
float umbrage_box_count(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, int radius) {
    int r = radius < 0 ? 0 : (radius < 8 ? radius : 8);
    int width = 2 * r + 1;
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 first = compared ? floor(coord) - float(r) : float2(0.0, 0.0);
    float count = 0.0;
    for (int j = 0; j < 17; j++) {
        if (j >= width) break;
        for (int i = 0; i < 17; i++) {
            if (i >= width) break;
            count += umbrage_lit(map, size, first + float2(float(i), float(j)), receiver);
        }
    }
    return compared ? count : float(width * width);
}
`,
            "box_scale": `
// umbrage_box_scale: 1 / (2r+1)^2, rounded to nearest
float umbrage_box_scale(int radius) {
    float scale = 0.00346020772;  // not returned as a literal: that would have the host's precision
    if (radius < 8) scale = 0.00444444455;
    if (radius < 7) scale = 0.00591715984;
    if (radius < 6) scale = 0.00826446246;
    if (radius < 5) scale = 0.0123456791;
    if (radius < 4) scale = 0.0204081628;
    if (radius < 3) scale = 0.0399999991;
    if (radius < 2) scale = 0.111111112;
    if (radius < 1) scale = 1.0;
    return scale;
}
`,
            "box": `
// umbrage_box: lit share of a (2r+1) x (2r+1) box; visibility, 1.0 is lit; arguments as for umbrage_box_count
float umbrage_box(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, int radius) {
    float visibility = umbrage_box_count(map, size, coord, receiver, radius) * umbrage_box_scale(radius);
    return visibility < 0.999 ? visibility : 1.0;  // 121 times the rounded 1/121 is not 1
}
`,
            "tent2": `
// umbrage_tent2: lit share of 3 x 3 texels, the window 1 1; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased
float umbrage_tent2(UMBRAGE_MAP map, float2 size, float2 coord, float receiver) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 x = compared ? floor(coord * 256.0) : float2(0.0, 0.0);  // no branch: fetches overlap
    float2 texel = floor(x * (1.0 / 256.0));
    // s is in [0, 256) already, w1 not negative; compilers cannot regroup sums across clamp and max
    float2 s = clamp(x * (1.0 / 256.0) - texel, float2(0.0, 0.0), float2(1.0, 1.0)) * 256.0;
    float2 r = 256.0 - s;
    float2 w0 = r * 8.0;
    float2 w2 = s * 8.0;
    float2 w1 = max(4096.0 - w0 - w2, float2(0.0, 0.0));
    float4 a = umbrage_lit_2x2(map, size, texel - 1.0, receiver);
    float4 b = umbrage_lit_2x2(map, size, texel + float2(1.0, -1.0), receiver);
    float4 c = umbrage_lit_2x2(map, size, texel + float2(-1.0, 1.0), receiver);
    float4 d = umbrage_lit_2x2(map, size, texel + float2(1.0, 1.0), receiver);
    float n = w0.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x);
    n += w1.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z);
    n += w2.y * (w0.x * c.x + w1.x * c.y + w2.x * d.x);
    return compared ? n * (1.0 / 16777216.0) : 1.0;
}
`,
            "tent3": `
// umbrage_tent3: lit share under 3 x 3 weights, 1 2 1, that slide over the map; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased
float umbrage_tent3(UMBRAGE_MAP map, float2 size, float2 coord, float receiver) {
    float n = umbrage_window_sum3(map, size, coord, receiver, 256.0, 4.0, 8.0);
    return clamp(n * (1.0 / 16777216.0), 0.0, 1.0);
}
`,
            "quadratic_b_spline": `
// umbrage_quadratic_b_spline: lit share of 3 x 3 texels, weighed by the quadratic B-spline; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased
float umbrage_quadratic_b_spline(UMBRAGE_MAP map, float2 size, float2 coord, float receiver) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 x = compared ? floor(coord * 256.0) : float2(0.0, 0.0);  // no branch: fetches overlap
    float2 texel = floor(x * (1.0 / 256.0));
    // s is in [0, 256) already, w1 not negative; compilers cannot regroup sums across clamp and max
    float2 s = clamp(x * (1.0 / 256.0) - texel, float2(0.0, 0.0), float2(1.0, 1.0)) * 256.0;
    float2 r = 256.0 - s;
    float2 w0 = floor(r * r * (1.0 / 32.0));
    float2 w2 = floor(s * s * (1.0 / 32.0));
    float2 w1 = max(4096.0 - w0 - w2, float2(0.0, 0.0));
    float4 a = umbrage_lit_2x2(map, size, texel - 1.0, receiver);
    float4 b = umbrage_lit_2x2(map, size, texel + float2(1.0, -1.0), receiver);
    float4 c = umbrage_lit_2x2(map, size, texel + float2(-1.0, 1.0), receiver);
    float4 d = umbrage_lit_2x2(map, size, texel + float2(1.0, 1.0), receiver);
    float n = w0.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x);
    n += w1.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z);
    n += w2.y * (w0.x * c.x + w1.x * c.y + w2.x * d.x);
    return compared ? n * (1.0 / 16777216.0) : 1.0;
}
`,
            "binomial5": `
// umbrage_binomial5: lit share under 5 x 5 weights, 1 4 6 4 1, that slide over the map; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased
float umbrage_binomial5(UMBRAGE_MAP map, float2 size, float2 coord, float receiver) {
    float n = umbrage_window_sum5(map, size, coord, receiver, 256.0, 1.0, 4.0, 6.0);
    return clamp(n * (1.0 / 16777216.0), 0.0, 1.0);
}
`,
            "castano_dyadic5": `
// umbrage_castano_dyadic5: lit share under 5 x 5 weights, 5 16 22 16 5, that slide over the map; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased
float umbrage_castano_dyadic5(UMBRAGE_MAP map, float2 size, float2 coord, float receiver) {
    float n = umbrage_window_sum5(map, size, coord, receiver, 256.0, 1.25, 4.0, 5.5);
    return clamp(n * (1.0 / 16777216.0), 0.0, 1.0);
}
`,
            "castano5": `
// umbrage_castano5: lit share under 5 x 5 weights, 1 3 4 3 1, that slide over the map; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased
float umbrage_castano5(UMBRAGE_MAP map, float2 size, float2 coord, float receiver) {
    float n = umbrage_window_sum5(map, size, coord, receiver, 256.0, 1.0, 3.0, 4.0);
    return n < 9437184.0 ? n * (1.0 / 65536.0) * 0.00694444450 : 1.0;
}
`,
            "binomial7": `
// umbrage_binomial7: lit share under 7 x 7 weights, 1 6 15 20 15 6 1, that slide over the map; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased
float umbrage_binomial7(UMBRAGE_MAP map, float2 size, float2 coord, float receiver) {
    float n = umbrage_window_sum7(map, size, coord, receiver, 256.0, 0.25, 1.5, 3.75, 5.0);
    return clamp(n * (1.0 / 16777216.0), 0.0, 1.0);
}
`,
            "tent7": `
// umbrage_tent7: lit share under 7 x 7 weights, 1 2 3 4 3 2 1, that slide over the map; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased
float umbrage_tent7(UMBRAGE_MAP map, float2 size, float2 coord, float receiver) {
    float n = umbrage_window_sum7(map, size, coord, receiver, 256.0, 1.0, 2.0, 3.0, 4.0);
    return clamp(n * (1.0 / 16777216.0), 0.0, 1.0);
}
`,
            "castano7": `
// umbrage_castano7: lit share under 7 x 7 weights, 1 5 12 16 12 5 1, that slide over the map; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased
float umbrage_castano7(UMBRAGE_MAP map, float2 size, float2 coord, float receiver) {
    float n = umbrage_window_sum7(map, size, coord, receiver, 64.0, 1.0, 5.0, 12.0, 16.0);
    return n < 11075584.0 ? n * (1.0 / 4096.0) * 0.000369822490 : 1.0;
}
`,
            "cube_lit": `
// umbrage_cube_lit: (visibility of one comparison, 1.0) with a texel of a cube, (0.0, 0.0) beyond a corner
//   map, size  atlas of 3 x 2 faces and its size in texels;   texel  (s, t, face), whole numbers
float2 umbrage_cube_lit(UMBRAGE_MAP map, float2 size, float3 texel, float receiver) {
    float side = size.y * 0.5;
    float3 n = umbrage_cube_neighbor(texel, side);
    float2 at = umbrage_cube_tile(n.z, side) + float2(n.x, n.y);
    float lit = umbrage_lit(map, size, at, receiver);
    return n.z < 0.0 ? float2(0.0, 0.0) : float2(lit, 1.0);
}
`,
            "pcf_2x2_cube": `
// umbrage_pcf_2x2_cube: bilinear percentage-closer filtering over a cube's edges; visibility, 1.0 is lit
//   map, size  atlas of 3 x 2 faces and its size in texels;   at  (s, t, face): texels of the face, from 0.0 on
//   receiver   distance from the light, biased
float umbrage_pcf_2x2_cube(UMBRAGE_MAP map, float2 size, float3 at, float receiver) {
    float2 coord = float2(at.x, at.y);
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 x = compared ? floor(coord * 256.0 + 0.5) - 128.0 : float2(0.0, 0.0);
    float2 texel = floor(x * (1.0 / 256.0));
    // weights are in [0, 1) already; compilers cannot regroup sums across the clamp
    float2 hi = clamp(x * (1.0 / 256.0) - texel, float2(0.0, 0.0), float2(1.0, 1.0));
    float2 lo = 1.0 - hi;
    float2 sum = umbrage_cube_lit(map, size, float3(texel, at.z), receiver) * (lo.x * lo.y);
    sum += umbrage_cube_lit(map, size, float3(texel + float2(1.0, 0.0), at.z), receiver) * (hi.x * lo.y);
    sum += umbrage_cube_lit(map, size, float3(texel + float2(0.0, 1.0), at.z), receiver) * (lo.x * hi.y);
    sum += umbrage_cube_lit(map, size, float3(texel + float2(1.0, 1.0), at.z), receiver) * (hi.x * hi.y);
    return compared && sum.y > 0.0 ? sum.x / sum.y : 1.0;
}
`,
            "four_tap_hardware": `
// umbrage_four_tap_hardware: mean of the shadow test at four taps of the sampler's; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   a, b, c, d  taps, (0.0, 0.0) to (1.0, 1.0) over the map, all lit
//   where the mean of |x| + |y| is 2^15 texels or more;   receiver  depth, biased
float umbrage_four_tap_hardware(UMBRAGE_MAP map, float2 size, float2 a, float2 b, float2 c, float2 d, float receiver) {
    float2 sum = (abs(a) + abs(b) + abs(c) + abs(d)) * size;
    bool compared = umbrage_beyond_far_plane(receiver) ? false : sum.x + sum.y < 131072.0;
    float count = umbrage_compare(receiver, umbrage_depth_at(map, size, a)) +
        umbrage_compare(receiver, umbrage_depth_at(map, size, b)) +
        umbrage_compare(receiver, umbrage_depth_at(map, size, c)) +
        umbrage_compare(receiver, umbrage_depth_at(map, size, d));
    return compared ? count * 0.25 : 1.0;
}
`,
            "lit_filtered": `
// umbrage_lit_filtered: 2x2 comparisons around a point; this map has no sampler to weigh them; visibility, 1.0 is lit
//   coord  in texels, no NaN; what is outside texel space counts as its border
float umbrage_lit_filtered(UMBRAGE_MAP map, float2 size, float2 coord, float receiver) {
    return umbrage_pcf_2x2(map, size, clamp(coord, float2(-32767.0, -32767.0), float2(32767.0, 32767.0)), receiver);
}
`,
            "lit_at": `
// umbrage_lit_at: 2x2 comparisons around a point, weighted; visibility, 1.0 is lit
//   uv  over the map, (0.0, 0.0) to (1.0, 1.0), no NaN
float umbrage_lit_at(UMBRAGE_MAP map, float2 size, float2 uv, float receiver) {
    return umbrage_lit_filtered(map, size, uv * size, receiver);
}
`,
            "pcf_2x2_hardware": `
// umbrage_pcf_2x2_hardware: 2x2 comparisons, weighted by the sampler; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased
float umbrage_pcf_2x2_hardware(UMBRAGE_MAP map, float2 size, float2 coord, float receiver) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 at = compared ? coord : float2(0.0, 0.0);
    float lit = umbrage_lit_at(map, size, at / size, receiver);
    float visibility = umbrage_within_far_plane(receiver) ? lit : 0.0;
    return compared ? visibility : 1.0;
}
`,
            "window_hardware3": `
// umbrage_window_hardware3: lit share under weights that slide over the map, by the sampler; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   k0 .. k1  weights from the edge to the middle one; the others mirror them
float umbrage_window_hardware3(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float k0, float k1) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 x = compared ? coord - 0.5 : float2(0.0, 0.0);
    float2 texel = floor(x);
    float2 s = x - texel;
    float whole = k0 + k1 + k0;
    float2 b0 = k1 + s * (k0 - k1);
    float2 w0 = k0 + k1 - s * k1;
    float2 p0 = (texel - 0.5 + b0 / w0) / size;
    float2 b1 = s * k0;
    float2 w1 = k0 + s * k1;
    float2 p1 = (texel + 1.5 + b1 / w1) / size;
    float n = 0.0;
    float row = 0.0;
    row += w0.x * umbrage_lit_at(map, size, float2(p0.x, p0.y), receiver);
    row += w1.x * umbrage_lit_at(map, size, float2(p1.x, p0.y), receiver);
    n += w0.y * row;
    row = 0.0;
    row += w0.x * umbrage_lit_at(map, size, float2(p0.x, p1.y), receiver);
    row += w1.x * umbrage_lit_at(map, size, float2(p1.x, p1.y), receiver);
    n += w1.y * row;
    float share = clamp(n / (whole * whole), 0.0, 1.0);
    float visibility = umbrage_within_far_plane(receiver) ? share : 0.0;
    return compared ? visibility : 1.0;
}
`,
            "window_hardware5": `
// umbrage_window_hardware5: lit share under weights that slide over the map, by the sampler; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   k0 .. k2  weights from the edge to the middle one; the others mirror them
float umbrage_window_hardware5(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float k0, float k1,
                               float k2) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 x = compared ? coord - 0.5 : float2(0.0, 0.0);
    float2 texel = floor(x);
    float2 s = x - texel;
    float whole = k0 + k1 + k2 + k1 + k0;
    float2 b0 = k1 + s * (k0 - k1);
    float2 w0 = k0 + k1 - s * k1;
    float2 p0 = (texel - 1.5 + b0 / w0) / size;
    float2 b1 = k1 + s * (k2 - k1);
    float2 w1 = float2(k2 + k1, k2 + k1);
    float2 p1 = (texel + 0.5 + b1 / w1) / size;
    float2 b2 = s * k0;
    float2 w2 = k0 + s * k1;
    float2 p2 = (texel + 2.5 + b2 / w2) / size;
    float n = 0.0;
    float row = 0.0;
    row += w0.x * umbrage_lit_at(map, size, float2(p0.x, p0.y), receiver);
    row += w1.x * umbrage_lit_at(map, size, float2(p1.x, p0.y), receiver);
    row += w2.x * umbrage_lit_at(map, size, float2(p2.x, p0.y), receiver);
    n += w0.y * row;
    row = 0.0;
    row += w0.x * umbrage_lit_at(map, size, float2(p0.x, p1.y), receiver);
    row += w1.x * umbrage_lit_at(map, size, float2(p1.x, p1.y), receiver);
    row += w2.x * umbrage_lit_at(map, size, float2(p2.x, p1.y), receiver);
    n += w1.y * row;
    row = 0.0;
    row += w0.x * umbrage_lit_at(map, size, float2(p0.x, p2.y), receiver);
    row += w1.x * umbrage_lit_at(map, size, float2(p1.x, p2.y), receiver);
    row += w2.x * umbrage_lit_at(map, size, float2(p2.x, p2.y), receiver);
    n += w2.y * row;
    float share = clamp(n / (whole * whole), 0.0, 1.0);
    float visibility = umbrage_within_far_plane(receiver) ? share : 0.0;
    return compared ? visibility : 1.0;
}
`,
            "window_hardware7": `
// umbrage_window_hardware7: lit share under weights that slide over the map, by the sampler; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   k0 .. k3  weights from the edge to the middle one; the others mirror them
float umbrage_window_hardware7(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float k0, float k1, float k2,
                               float k3) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 x = compared ? coord - 0.5 : float2(0.0, 0.0);
    float2 texel = floor(x);
    float2 s = x - texel;
    float whole = k0 + k1 + k2 + k3 + k2 + k1 + k0;
    float2 b0 = k1 + s * (k0 - k1);
    float2 w0 = k0 + k1 - s * k1;
    float2 p0 = (texel - 2.5 + b0 / w0) / size;
    float2 b1 = k3 + s * (k2 - k3);
    float2 w1 = k2 + k3 + s * (k1 - k3);
    float2 p1 = (texel - 0.5 + b1 / w1) / size;
    float2 b2 = k1 + s * (k2 - k1);
    float2 w2 = k2 + k1 + s * (k3 - k1);
    float2 p2 = (texel + 1.5 + b2 / w2) / size;
    float2 b3 = s * k0;
    float2 w3 = k0 + s * k1;
    float2 p3 = (texel + 3.5 + b3 / w3) / size;
    float n = 0.0;
    float row = 0.0;
    row += w0.x * umbrage_lit_at(map, size, float2(p0.x, p0.y), receiver);
    row += w1.x * umbrage_lit_at(map, size, float2(p1.x, p0.y), receiver);
    row += w2.x * umbrage_lit_at(map, size, float2(p2.x, p0.y), receiver);
    row += w3.x * umbrage_lit_at(map, size, float2(p3.x, p0.y), receiver);
    n += w0.y * row;
    row = 0.0;
    row += w0.x * umbrage_lit_at(map, size, float2(p0.x, p1.y), receiver);
    row += w1.x * umbrage_lit_at(map, size, float2(p1.x, p1.y), receiver);
    row += w2.x * umbrage_lit_at(map, size, float2(p2.x, p1.y), receiver);
    row += w3.x * umbrage_lit_at(map, size, float2(p3.x, p1.y), receiver);
    n += w1.y * row;
    row = 0.0;
    row += w0.x * umbrage_lit_at(map, size, float2(p0.x, p2.y), receiver);
    row += w1.x * umbrage_lit_at(map, size, float2(p1.x, p2.y), receiver);
    row += w2.x * umbrage_lit_at(map, size, float2(p2.x, p2.y), receiver);
    row += w3.x * umbrage_lit_at(map, size, float2(p3.x, p2.y), receiver);
    n += w2.y * row;
    row = 0.0;
    row += w0.x * umbrage_lit_at(map, size, float2(p0.x, p3.y), receiver);
    row += w1.x * umbrage_lit_at(map, size, float2(p1.x, p3.y), receiver);
    row += w2.x * umbrage_lit_at(map, size, float2(p2.x, p3.y), receiver);
    row += w3.x * umbrage_lit_at(map, size, float2(p3.x, p3.y), receiver);
    n += w3.y * row;
    float share = clamp(n / (whole * whole), 0.0, 1.0);
    float visibility = umbrage_within_far_plane(receiver) ? share : 0.0;
    return compared ? visibility : 1.0;
}
`,
            "disc_hardware8": `
// umbrage_disc_hardware8: 8 points of a disc, each compared and weighted by the sampler; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   radius  in texels, at most 255.9375;   rotation  umbrage_disc_rotation of the pixel
float umbrage_disc_hardware8(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float radius,
                             float2 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 center = (compared ? coord : float2(0.0, 0.0)) / size;
    float2 scaled = rotation * ((radius > 0.0 ? min(radius, 255.9375) : 0.0) * (1.0 / 1024.0));
    float2 x = scaled / size;
    float2 y = float2(0.0 - scaled.y, scaled.x) / size;
    float n = 0.0;
    n += umbrage_lit_at(map, size, center + x * 3.0 - y * 1.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 4.0 + y * 5.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 1.0 - y * 11.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 9.0 - y * 8.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 12.0 + y * 3.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 11.0 + y * 6.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 0.0 + y * 13.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 11.0 - y * 7.0, receiver);
    float visibility = umbrage_within_far_plane(receiver) ? n * (1.0 / 8.0) : 0.0;
    return compared ? visibility : 1.0;
}
`,
            "disc_hardware16": `
// umbrage_disc_hardware16: 16 points of a disc, each compared and weighted by the sampler; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   radius  in texels, at most 255.9375;   rotation  umbrage_disc_rotation of the pixel
float umbrage_disc_hardware16(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float radius,
                              float2 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 center = (compared ? coord : float2(0.0, 0.0)) / size;
    float2 scaled = rotation * ((radius > 0.0 ? min(radius, 255.9375) : 0.0) * (1.0 / 1024.0));
    float2 x = scaled / size;
    float2 y = float2(0.0 - scaled.y, scaled.x) / size;
    float n = 0.0;
    n += umbrage_lit_at(map, size, center + x * 1.0 - y * 3.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 5.0 + y * 2.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 5.0 + y * 2.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 0.0 + y * 7.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 6.0 - y * 5.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 8.0 - y * 5.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 0.0 - y * 11.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 11.0 + y * 5.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 12.0 + y * 4.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 1.0 + y * 13.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 7.0 + y * 11.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 9.0 + y * 10.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 13.0 - y * 4.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 7.0 - y * 12.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 7.0 - y * 12.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 14.0 - y * 2.0, receiver);
    float visibility = umbrage_within_far_plane(receiver) ? n * (1.0 / 16.0) : 0.0;
    return compared ? visibility : 1.0;
}
`,
            "disc_hardware32": `
// umbrage_disc_hardware32: 32 points of a disc, each compared and weighted by the sampler; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   radius  in texels, at most 255.9375;   rotation  umbrage_disc_rotation of the pixel
float umbrage_disc_hardware32(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float radius,
                              float2 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 center = (compared ? coord : float2(0.0, 0.0)) / size;
    float2 scaled = rotation * ((radius > 0.0 ? min(radius, 255.9375) : 0.0) * (1.0 / 1024.0));
    float2 x = scaled / size;
    float2 y = float2(0.0 - scaled.y, scaled.x) / size;
    float n = 0.0;
    n += umbrage_lit_at(map, size, center - x * 2.0 - y * 1.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 3.0 + y * 2.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 1.0 - y * 4.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 4.0 + y * 3.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 0.0 + y * 6.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 5.0 - y * 5.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 7.0 - y * 2.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 8.0 - y * 1.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 8.0 + y * 3.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 5.0 + y * 7.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 1.0 - y * 9.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 6.0 - y * 7.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 8.0 + y * 5.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 0.0 + y * 10.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 3.0 - y * 10.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 6.0 + y * 10.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 9.0 - y * 8.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 11.0 - y * 5.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 5.0 - y * 12.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 13.0 - y * 1.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 7.0 + y * 11.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 13.0 + y * 3.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 13.0 + y * 4.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 10.0 - y * 10.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 14.0 - y * 2.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 11.0 + y * 9.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 3.0 + y * 14.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 13.0 - y * 6.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 12.0 + y * 8.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 4.0 + y * 14.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 7.0 - y * 13.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 0.0 - y * 15.0, receiver);
    float visibility = umbrage_within_far_plane(receiver) ? n * (1.0 / 32.0) : 0.0;
    return compared ? visibility : 1.0;
}
`,
            "bounds_lit": `
// umbrage_bounds_lit: 1.0 where all texels of a filter are lit, 0.0 where none is, else -1.0: ask the filter
//   bounds, size  a map of the texels' least and greatest depths, and its size in texels;   place  what goes with it
//   coord, receiver  as the filter takes them
float umbrage_bounds_lit(UMBRAGE_MAP bounds, float2 size, float2 coord, float receiver, float2 place) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 x = compared ? floor(coord * 256.0) : float2(0.0, 0.0);
    float4 b = umbrage_fetch_clamped(bounds, size, floor((x + place.x) * place.y));
    float all = umbrage_compare(receiver, b.x);
    float some = umbrage_compare(receiver, b.y);
    float known = b.x <= b.y && all == some ? all : -1.0;  // not of a NaN
    return compared ? known : 1.0;
}
`,
            "distance_code": `
// umbrage_distance_code: a depth as whole number from 0.0 at the near plane to 65535.0, also where depth is reversed
float umbrage_distance_code(float depth) {
    float v = depth * 65536.0;
    float forward = v < 65535.0 ? floor(max(v, 0.0)) : 65535.0;
    float reversed = v > 0.0 ? floor(min(v, 65535.0)) : 0.0;
    return umbrage_cleared_depth() > 0.5 ? forward : 65535.0 - reversed;
}
`,
            "penumbra": `
// umbrage_penumbra: radius in 1/16 texel, a whole number
//   apart     umbrage_distance_code of the receiver less that of the blocker
//   softness  (1/16 texel a code, min_radius, max_radius), of make_penumbra_params
float umbrage_penumbra(float apart, float3 softness) {
    return min(max(floor(apart * softness.x), softness.y), softness.z);
}
`,
            "blocker": `
// umbrage_blocker: (1.0, umbrage_distance_code) of a texel before the receiver, of any other (0.0, 0.0)
float2 umbrage_blocker(UMBRAGE_MAP map, float2 size, float2 texel, float receiver) {
    float stored = umbrage_fetch_depth(map, size, texel);
    float code = umbrage_distance_code(stored);
    return umbrage_compare(receiver, stored) > 0.5 ? float2(0.0, 0.0) : float2(1.0, code);
}
`,
            "blockers8": `
// umbrage_blockers8: how many of a disc's 8 points fall on texels before the receiver, and the sum of their codes
//   map, size  shadow map and its size in texels;   position  floor(256 coord) of the receiver;   receiver  biased
//   radius     in 1/16 texel, a whole number from 0 to 4095;   rotation  umbrage_disc_rotation of the pixel
float2 umbrage_blockers8(UMBRAGE_MAP map, float2 size, float2 position, float receiver, float radius, float2 rotation) {
    float2 n = float2(0.0, 0.0);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(3.0, -1.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-4.0, 5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(1.0, -11.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-9.0, -8.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-12.0, 3.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(11.0, 6.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(0.0, 13.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(11.0, -7.0), rotation, radius), receiver);
    return n;
}
`,
            "blockers16": `
// umbrage_blockers16: how many of a disc's 16 points fall on texels before the receiver, and the sum of their codes
//   map, size  shadow map and its size in texels;   position  floor(256 coord) of the receiver;   receiver  biased
//   radius     in 1/16 texel, a whole number from 0 to 4095;   rotation  umbrage_disc_rotation of the pixel
float2 umbrage_blockers16(UMBRAGE_MAP map, float2 size, float2 position, float receiver, float radius,
                          float2 rotation) {
    float2 n = float2(0.0, 0.0);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(1.0, -3.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(5.0, 2.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-5.0, 2.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(0.0, 7.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-6.0, -5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(8.0, -5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(0.0, -11.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(11.0, 5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-12.0, 4.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-1.0, 13.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(7.0, 11.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-9.0, 10.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-13.0, -4.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(7.0, -12.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-7.0, -12.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(14.0, -2.0), rotation, radius), receiver);
    return n;
}
`,
            "blockers32": `
// umbrage_blockers32: how many of a disc's 32 points fall on texels before the receiver, and the sum of their codes
//   map, size  shadow map and its size in texels;   position  floor(256 coord) of the receiver;   receiver  biased
//   radius     in 1/16 texel, a whole number from 0 to 4095;   rotation  umbrage_disc_rotation of the pixel
float2 umbrage_blockers32(UMBRAGE_MAP map, float2 size, float2 position, float receiver, float radius,
                          float2 rotation) {
    float2 n = float2(0.0, 0.0);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-2.0, -1.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(3.0, 2.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(1.0, -4.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-4.0, 3.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(0.0, 6.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-5.0, -5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(7.0, -2.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-8.0, -1.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(8.0, 3.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(5.0, 7.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(1.0, -9.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(6.0, -7.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-8.0, 5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(0.0, 10.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-3.0, -10.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-6.0, 10.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-9.0, -8.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(11.0, -5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(5.0, -12.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-13.0, -1.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(7.0, 11.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(13.0, 3.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-13.0, 4.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(10.0, -10.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(14.0, -2.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-11.0, 9.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(3.0, 14.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-13.0, -6.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(12.0, 8.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-4.0, 14.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-7.0, -13.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(0.0, -15.0), rotation, radius), receiver);
    return n;
}
`,
            "pcss8": `
// umbrage_pcss8: percentage-closer soft shadows, 8 points twice; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   softness  of make_penumbra_params;  rotation  umbrage_disc_rotation of the pixel
float umbrage_pcss8(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float3 softness, float2 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 at = compared ? floor(coord * 256.0) : float2(0.0, 0.0);
    float z = umbrage_distance_code(receiver);
    float search_radius = umbrage_penumbra(z, softness);
    float2 found = umbrage_blockers8(map, size, at, receiver, search_radius, rotation);
    float mean = umbrage_floor_divide(found.y, max(found.x, 1.0));
    float radius = umbrage_penumbra(z - mean, softness);
    // without a blocker the radius is the search's, whose points are all lit
    return umbrage_disc8(map, size, coord, receiver, radius * (1.0 / 16.0), rotation);
}
`,
            "pcss16": `
// umbrage_pcss16: percentage-closer soft shadows, 16 points twice; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   softness  of make_penumbra_params;  rotation  umbrage_disc_rotation of the pixel
float umbrage_pcss16(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float3 softness, float2 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 at = compared ? floor(coord * 256.0) : float2(0.0, 0.0);
    float z = umbrage_distance_code(receiver);
    float search_radius = umbrage_penumbra(z, softness);
    float2 found = umbrage_blockers16(map, size, at, receiver, search_radius, rotation);
    float mean = umbrage_floor_divide(found.y, max(found.x, 1.0));
    float radius = umbrage_penumbra(z - mean, softness);
    // without a blocker the radius is the search's, whose points are all lit
    return umbrage_disc16(map, size, coord, receiver, radius * (1.0 / 16.0), rotation);
}
`,
            "pcss32": `
// umbrage_pcss32: percentage-closer soft shadows, 32 points twice; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   softness  of make_penumbra_params;  rotation  umbrage_disc_rotation of the pixel
float umbrage_pcss32(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float3 softness, float2 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 at = compared ? floor(coord * 256.0) : float2(0.0, 0.0);
    float z = umbrage_distance_code(receiver);
    float search_radius = umbrage_penumbra(z, softness);
    float2 found = umbrage_blockers32(map, size, at, receiver, search_radius, rotation);
    float mean = umbrage_floor_divide(found.y, max(found.x, 1.0));
    float radius = umbrage_penumbra(z - mean, softness);
    // without a blocker the radius is the search's, whose points are all lit
    return umbrage_disc32(map, size, coord, receiver, radius * (1.0 / 16.0), rotation);
}
`,
            "blocker_at": `
// umbrage_blocker_at: (1.0, depth) of the texel at a point where it is before the receiver, else (0.0, 0.0)
//   uv  over the map, (0.0, 0.0) to (1.0, 1.0), no NaN
float2 umbrage_blocker_at(UMBRAGE_MAP map, float2 size, float2 uv, float receiver) {
    float stored = umbrage_depth_at(map, size, uv);
    return umbrage_compare(receiver, stored) > 0.5 ? float2(0.0, 0.0) : float2(1.0, stored);
}
`,
            "pcss_radius": `
// umbrage_pcss_radius: radius of a penumbra in texels; without a blocker that of one at the near plane
//   found     (how many blockers, the sum of their depths);   receiver  depth, biased
//   softness  (1/16 texel a code, min_radius, max_radius), of make_penumbra_params
float umbrage_pcss_radius(float2 found, float receiver, float3 softness) {
    bool forward = umbrage_cleared_depth() > 0.5;
    float mean = found.x > 0.5 ? found.y / found.x : (forward ? 0.0 : 1.0);
    float radius = (forward ? receiver - mean : mean - receiver) * (softness.x * 4096.0);
    float min_radius = softness.y * 0.0625;
    return radius > min_radius ? min(radius, softness.z * 0.0625) : min_radius;
}
`,
            "blockers_hardware8": `
// umbrage_blockers_hardware8: of the texels at 8 points of a disc those before the receiver: (how many, depths' sum)
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   radius  in texels, at most 255.9375;   rotation  umbrage_disc_rotation of the pixel
float2 umbrage_blockers_hardware8(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float radius,
                                  float2 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 center = (compared ? coord : float2(0.0, 0.0)) / size;
    float2 scaled = rotation * ((radius > 0.0 ? min(radius, 255.9375) : 0.0) * (1.0 / 1024.0));
    float2 x = scaled / size;
    float2 y = float2(0.0 - scaled.y, scaled.x) / size;
    float2 n = float2(0.0, 0.0);
    n += umbrage_blocker_at(map, size, center + x * 3.0 - y * 1.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 4.0 + y * 5.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 1.0 - y * 11.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 9.0 - y * 8.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 12.0 + y * 3.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 11.0 + y * 6.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 0.0 + y * 13.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 11.0 - y * 7.0, receiver);
    return compared ? n : float2(0.0, 0.0);
}
`,
            "blockers_hardware16": `
// umbrage_blockers_hardware16: of the texels at 16 points of a disc those before the receiver: (how many, depths' sum)
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   radius  in texels, at most 255.9375;   rotation  umbrage_disc_rotation of the pixel
float2 umbrage_blockers_hardware16(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float radius,
                                   float2 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 center = (compared ? coord : float2(0.0, 0.0)) / size;
    float2 scaled = rotation * ((radius > 0.0 ? min(radius, 255.9375) : 0.0) * (1.0 / 1024.0));
    float2 x = scaled / size;
    float2 y = float2(0.0 - scaled.y, scaled.x) / size;
    float2 n = float2(0.0, 0.0);
    n += umbrage_blocker_at(map, size, center + x * 1.0 - y * 3.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 5.0 + y * 2.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 5.0 + y * 2.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 0.0 + y * 7.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 6.0 - y * 5.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 8.0 - y * 5.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 0.0 - y * 11.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 11.0 + y * 5.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 12.0 + y * 4.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 1.0 + y * 13.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 7.0 + y * 11.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 9.0 + y * 10.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 13.0 - y * 4.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 7.0 - y * 12.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 7.0 - y * 12.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 14.0 - y * 2.0, receiver);
    return compared ? n : float2(0.0, 0.0);
}
`,
            "blockers_hardware32": `
// umbrage_blockers_hardware32: of the texels at 32 points of a disc those before the receiver: (how many, depths' sum)
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   radius  in texels, at most 255.9375;   rotation  umbrage_disc_rotation of the pixel
float2 umbrage_blockers_hardware32(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float radius,
                                   float2 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 center = (compared ? coord : float2(0.0, 0.0)) / size;
    float2 scaled = rotation * ((radius > 0.0 ? min(radius, 255.9375) : 0.0) * (1.0 / 1024.0));
    float2 x = scaled / size;
    float2 y = float2(0.0 - scaled.y, scaled.x) / size;
    float2 n = float2(0.0, 0.0);
    n += umbrage_blocker_at(map, size, center - x * 2.0 - y * 1.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 3.0 + y * 2.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 1.0 - y * 4.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 4.0 + y * 3.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 0.0 + y * 6.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 5.0 - y * 5.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 7.0 - y * 2.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 8.0 - y * 1.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 8.0 + y * 3.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 5.0 + y * 7.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 1.0 - y * 9.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 6.0 - y * 7.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 8.0 + y * 5.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 0.0 + y * 10.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 3.0 - y * 10.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 6.0 + y * 10.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 9.0 - y * 8.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 11.0 - y * 5.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 5.0 - y * 12.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 13.0 - y * 1.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 7.0 + y * 11.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 13.0 + y * 3.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 13.0 + y * 4.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 10.0 - y * 10.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 14.0 - y * 2.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 11.0 + y * 9.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 3.0 + y * 14.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 13.0 - y * 6.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 12.0 + y * 8.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 4.0 + y * 14.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 7.0 - y * 13.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 0.0 - y * 15.0, receiver);
    return compared ? n : float2(0.0, 0.0);
}
`,
            "hardened_kernel8": `
// umbrage_hardened_kernel8: the share of 8 points in shadow, steepened
//   blocked  how many;   ratio  of the penumbra to the disc in 1/256, a whole number: 256.0 leaves the share as it is
float umbrage_hardened_kernel8(float blocked, float ratio) {
    float u = blocked * 2.0 - 8.0;
    float d = max(8.0 - abs(u), 0.0);  // not negative already: no sum is regrouped across the max
    float steep = 512.0 - d * d * d;
    float hard = u < 0.0 ? 512.0 - steep : 512.0 + steep;
    return (hard * (256.0 - ratio) + blocked * ratio * 128.0) * (1.0 / 262144.0);
}
`,
            "hardened_kernel16": `
// umbrage_hardened_kernel16: the share of 16 points in shadow, steepened
//   blocked  how many;   ratio  of the penumbra to the disc in 1/256, a whole number: 256.0 leaves the share as it is
float umbrage_hardened_kernel16(float blocked, float ratio) {
    float u = blocked * 2.0 - 16.0;
    float d = max(16.0 - abs(u), 0.0);  // not negative already: no sum is regrouped across the max
    float steep = 4096.0 - d * d * d;
    float hard = u < 0.0 ? 4096.0 - steep : 4096.0 + steep;
    return (hard * (256.0 - ratio) + blocked * ratio * 512.0) * (1.0 / 2097152.0);
}
`,
            "hardened_kernel32": `
// umbrage_hardened_kernel32: the share of 32 points in shadow, steepened
//   blocked  how many;   ratio  of the penumbra to the disc in 1/256, a whole number: 256.0 leaves the share as it is
float umbrage_hardened_kernel32(float blocked, float ratio) {
    float u = blocked * 2.0 - 32.0;
    float d = max(32.0 - abs(u), 0.0);  // not negative already: no sum is regrouped across the max
    float steep = 32768.0 - d * d * d;
    float hard = u < 0.0 ? 32768.0 - steep : 32768.0 + steep;
    return (hard * (256.0 - ratio) + blocked * ratio * 2048.0) * (1.0 / 16777216.0);
}
`,
            "dpcf8": `
// umbrage_dpcf8: contact hardening by 8 points; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   softness  of make_penumbra_params;  rotation  umbrage_disc_rotation of the pixel
float umbrage_dpcf8(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float3 softness, float2 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 at = compared ? floor(coord * 256.0) : float2(0.0, 0.0);
    float z = umbrage_distance_code(receiver);
    float search_radius = umbrage_penumbra(z, softness);
    float2 found = umbrage_blockers8(map, size, at, receiver, search_radius, rotation);
    float mean = umbrage_floor_divide(found.y, max(found.x, 1.0));
    float radius = umbrage_penumbra(z - mean, softness);
    float ratio = umbrage_floor_divide(radius * 256.0, max(search_radius, 1.0));
    float dark = umbrage_hardened_kernel8(found.x, ratio);
    return compared ? clamp(1.0 - dark, 0.0, 1.0) : 1.0;
}
`,
            "dpcf16": `
// umbrage_dpcf16: contact hardening by 16 points; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   softness  of make_penumbra_params;  rotation  umbrage_disc_rotation of the pixel
float umbrage_dpcf16(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float3 softness, float2 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 at = compared ? floor(coord * 256.0) : float2(0.0, 0.0);
    float z = umbrage_distance_code(receiver);
    float search_radius = umbrage_penumbra(z, softness);
    float2 found = umbrage_blockers16(map, size, at, receiver, search_radius, rotation);
    float mean = umbrage_floor_divide(found.y, max(found.x, 1.0));
    float radius = umbrage_penumbra(z - mean, softness);
    float ratio = umbrage_floor_divide(radius * 256.0, max(search_radius, 1.0));
    float dark = umbrage_hardened_kernel16(found.x, ratio);
    return compared ? clamp(1.0 - dark, 0.0, 1.0) : 1.0;
}
`,
            "dpcf32": `
// umbrage_dpcf32: contact hardening by 32 points; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   softness  of make_penumbra_params;  rotation  umbrage_disc_rotation of the pixel
float umbrage_dpcf32(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float3 softness, float2 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 at = compared ? floor(coord * 256.0) : float2(0.0, 0.0);
    float z = umbrage_distance_code(receiver);
    float search_radius = umbrage_penumbra(z, softness);
    float2 found = umbrage_blockers32(map, size, at, receiver, search_radius, rotation);
    float mean = umbrage_floor_divide(found.y, max(found.x, 1.0));
    float radius = umbrage_penumbra(z - mean, softness);
    float ratio = umbrage_floor_divide(radius * 256.0, max(search_radius, 1.0));
    float dark = umbrage_hardened_kernel32(found.x, ratio);
    return compared ? clamp(1.0 - dark, 0.0, 1.0) : 1.0;
}
`,
            "box_moments": `
// umbrage_box_moments: (mean, rest, high, low) of the codes in a box of n texels: their sum is n mean + rest, and
//   that of their squared distances from mean 4096 high + low;  whole numbers
//   map, size  a table of make_variance_table and its size;   first, end  of the box, first < end
float4 umbrage_box_moments(UMBRAGE_MAP map, float2 size, float2 first, float2 end) {
    float4 a = umbrage_texel(map, size, end);
    float4 b = umbrage_texel(map, size, float2(first.x, end.y));
    float4 c = umbrage_texel(map, size, float2(end.x, first.y));
    float4 d = umbrage_texel(map, size, first);
    float4 part = (a - b) - (c - d);
    float2 low = float2(part.x, part.z);
    float2 carry = floor(low * (1.0 / 65536.0));
    float2 above = float2(part.y, part.w) + carry;
    // nothing below is negative; compilers cannot regroup sums across a max
    low = max(low - carry * 65536.0, float2(0.0, 0.0));
    above = max(above - floor(above * (1.0 / 65536.0)) * 65536.0, float2(0.0, 0.0));
    float sum = above.x * 65536.0 + low.x;
    float2 sides = max(end - first, float2(1.0, 1.0));
    float n = sides.x * sides.y;
    float mean = umbrage_floor_divide(sum, n);
    float rest = max(sum - mean * n, 0.0);
    float2 digits = float2(sum + rest, low.y);
    float2 high = floor(digits * (1.0 / 4096.0));
    digits = max(digits - high * 4096.0, float2(0.0, 0.0));
    float below = digits.y - mean * digits.x;
    float borrow = floor(below * (1.0 / 4096.0));
    float wide = above.y * 16.0 + high.y - mean * high.x + borrow;
    wide = wide - floor(wide * (1.0 / 1048576.0)) * 1048576.0;
    return float4(mean, rest, wide, below - borrow * 4096.0);
}
`,
            "summed_variance": `
// umbrage_summed_variance: variance shadow from a summed-area table; visibility, 1.0 is lit
//   map, size  the table, of make_variance_table, and its size: one more than the shadow map's
//   coord, receiver  in texels of the shadow map, first center at (0.5, 0.5), and depth, biased
//   radius     whole: the box has 2 radius + 1 texels a side;   codes  2^bits of the table
float umbrage_summed_variance(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float radius, float codes) {
    float2 last = size - 1.0;
    bool compared = umbrage_map_covers(last, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    float2 texel = compared ? clamp(floor(coord), float2(0.0, 0.0), last - 1.0) : float2(0.0, 0.0);
    float2 first = max(texel - radius, float2(0.0, 0.0));
    float2 end = min(texel + radius + 1.0, last);
    float4 m = umbrage_box_moments(map, size, first, end);
    float2 sides = end - first;
    float n = sides.x * sides.y;
    float share = m.y / n;
    float variance = (m.z * 4096.0 + (m.w - m.y)) / n + share * (1.0 - share);
    float scaled = receiver * codes;
    float t = umbrage_cleared_depth() > 0.5 ? scaled : codes - scaled;
    float d = (t - 1.0 - m.x) - share;
    float behind = d > 0.0 ? variance / (variance + d * d) : 0.0;
    return compared ? (d <= 0.0 ? 1.0 : behind) : 1.0;
}
`,
            "box_mean": `
// umbrage_box_mean: mean of four whole numbers below 65536.0 over a box
//   map, size  a table of make_moment_table and its size;   first, end  of the box, first < end
float4 umbrage_box_mean(UMBRAGE_MAP map, float2 size, float2 first, float2 end) {
    float right = size.x * 0.5;
    float4 a = umbrage_texel(map, size, end);
    float4 b = umbrage_texel(map, size, float2(first.x, end.y));
    float4 c = umbrage_texel(map, size, float2(end.x, first.y));
    float4 d = umbrage_texel(map, size, first);
    float4 low = (a - b) - (c - d);
    float4 carry = floor(low * (1.0 / 65536.0));
    a = umbrage_texel(map, size, float2(right + end.x, end.y));
    b = umbrage_texel(map, size, float2(right + first.x, end.y));
    c = umbrage_texel(map, size, float2(right + end.x, first.y));
    d = umbrage_texel(map, size, float2(right + first.x, first.y));
    float4 above = (a - b) - (c - d) + carry;
    float4 high = above - floor(above * (1.0 / 65536.0)) * 65536.0;
    precise float4 sum = high * 65536.0 + (low - carry * 65536.0);
    float2 sides = end - first;
    return sum / (sides.x * sides.y);
}
`,
            "from_optimized_moments": `
// umbrage_from_optimized_moments: four moments of what umbrage_to_optimized_moments made of them
float4 umbrage_from_optimized_moments(float4 o) {
    precise float x = o.x - 0.5;
    precise float z = o.z - 0.5;
    float eighth = o.y * 0.125;
    precise float b1 = z * 1.73205078 - x * 0.333333343;
    precise float b2 = o.w + eighth;
    precise float b3 = z * 1.29903817 - x * 0.75;
    precise float b4 = o.w - eighth;
    return float4(b1, b2, b3, b4);
}
`,
            "bias_moments": `
// umbrage_bias_moments: moments moved by a share bias.x towards (0.0, bias.y, 0.0, bias.y)
float4 umbrage_bias_moments(float4 b, float2 bias) {
    precise float x = b.x - b.x * bias.x;
    precise float y = b.y + (bias.y - b.y) * bias.x;
    precise float z = b.z - b.z * bias.x;
    precise float w = b.w + (bias.y - b.w) * bias.x;
    return float4(x, y, z, w);
}
`,
            "to_forward_depth": `
// umbrage_to_forward_depth: depth that grows with distance, 1.0 - depth where the map's is reversed
float umbrage_to_forward_depth(float depth) {
    return umbrage_cleared_depth() < 0.5 ? 1.0 - depth : depth;
}
`,
            "moment_atoms": `
// umbrage_moment_atoms: the two depths that beside the receiver's have the same moments, less b.x, and their shares
//   b  moments, biased;   x  the receiver's depth on -1.0 to 1.0 less b.x
float4 umbrage_moment_atoms(float4 b, float x) {
    precise float d = b.y - b.x * b.x;
    precise float third = b.z - b.x * b.y;
    float l = third / d;
    precise float e = (b.w - b.y * b.y) - third * l;
    precise float h = b.x * 2.0 - l;
    precise float a = d * ((x + h) * x - d);
    precise float m = x * e + h * a;
    precise float c = d * (e - a);
    precise float square = m * m - 4.0 * a * c;
    float root = sqrt(square > 0.0 ? square : 0.0);
    precise float w = (m < 0.0 ? root - m : -(m + root)) * 0.5;
    float2 t = float2(w / a, c / w);
    precise float2 q = (t + h) * t - d;
    float least = d * e;
    precise float2 sum = least + (t * t * e + q * q * d);
    return float4(t.x, t.y, least / sum.x, least / sum.y);
}
`,
            "decode_msm": `
// umbrage_decode_msm: visibility of a receiver, at least its lit share less bias.x; 1.0 is lit
//   b  mean of texels;   receiver  depth, biased
//   bias  (3e-6, 0.375) of floats of 32 bits, (6e-5, 0.628) of channels of 16
float umbrage_decode_msm(float4 b, float receiver, float2 bias) {
    float d = umbrage_to_forward_depth(receiver);
    float4 m = umbrage_bias_moments(b, bias);
    precise float x = ((d > 0.0 ? (d < 1.0 ? d : 1.0) : 0.0) * 2.0 - 1.0) - m.x;
    float4 atoms = umbrage_moment_atoms(m, x);
    float first = atoms.x < x ? atoms.z : 0.0;
    float second = atoms.y < x ? atoms.w : 0.0;
    precise float lit = 1.0 - (first + second);
    bool known = abs(atoms.z + atoms.w) <= 4294967296.0;  // what is no NaN
    lit = known ? (lit > 0.0 ? (lit < 1.0 ? lit : 1.0) : 0.0) : (x <= 0.0 ? 1.0 : 0.0);
    return d > 0.0 ? lit : (d <= 0.0 ? lit : 0.0);
}
`,
            "summed_moments": `
// umbrage_summed_moments: moment shadow from a summed-area table; visibility, 1.0 is lit
//   map, size  the table, of make_moment_table, and its size: twice the shadow map's width and two, its height and one
//   coord, receiver  in texels of the shadow map, first center at (0.5, 0.5), and depth, biased
//   radius     whole: the box has 2 radius + 1 texels a side;   bias  (6e-5, 0.628)
float umbrage_summed_moments(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float radius, float2 bias) {
    float2 last = float2(size.x * 0.5, size.y) - 1.0;
    bool compared = umbrage_map_covers(last, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    float2 texel = compared ? clamp(floor(coord), float2(0.0, 0.0), last - 1.0) : float2(0.0, 0.0);
    float2 first = max(texel - radius, float2(0.0, 0.0));
    float2 end = min(texel + radius + 1.0, last);
    float4 turned = umbrage_box_mean(map, size, first, end) * (1.0 / 65535.0);
    float lit = umbrage_decode_msm(umbrage_from_optimized_moments(turned), receiver, bias);
    return compared ? lit : 1.0;
}
`,
            "power_of_two": `
// umbrage_power_of_two: 2^n of a whole number n, -64.0 to 63.0
float umbrage_power_of_two(float n) {
    uint exponent = uint(n + 127.0);
    return asfloat(exponent << 23);
}
`,
            "exp2_polynomial": `
// umbrage_exp2_polynomial: 2^y, off by at most 1.8e-7 of it
//   y  outside of -64.0 to 63.0 the nearer end counts, of NaN -64.0
float umbrage_exp2_polynomial(float y) {
    float x = y > -64.0 ? min(y, 63.0) : -64.0;
    float n = floor(x);
    float f = x - n;
    precise float p = 0.00187931862 * f + 0.00899099465;
    p = p * f + 0.0558186769;
    p = p * f + 0.240159273;
    p = p * f + 0.693151712;
    p = p * f + 1.0;
    return p * umbrage_power_of_two(n);
}
`,
            "exp2_steps": `
// umbrage_exp2_steps: 2^y, a whole number below 2^12 times a power of two, y rounded down to 1/2048
//   y  outside of -64.0 to 63.0 the nearer end counts, of NaN -64.0
float umbrage_exp2_steps(float y) {
    float x = floor((y > -64.0 ? min(y, 63.0) : -64.0) * 2048.0);
    float n = floor(x * (1.0 / 2048.0));
    float f = max(x - n * 2048.0, 0.0);  // not negative already: no sum is regrouped across the max
    float g = floor(f * (2048.0 - f) * (1.0 / 256.0));
    float r = 1251.0 + floor(f * 314.0 * (1.0 / 2048.0));
    float m = 2048.0 + f - floor((g * r + 16384.0) * (1.0 / 32768.0));
    return m * (1.0 / 2048.0) * umbrage_power_of_two(n);
}
`,
            "chebyshev": `
// umbrage_chebyshev: share of depths that may be as far as the receiver or farther, at most; 0.0 where something is NaN
//   m  mean of the depths, mean of their squares;   receiver  on the same scale;   min_variance  0.0 or more
float umbrage_chebyshev(float2 m, float receiver, float min_variance) {
    precise float difference = m.y - m.x * m.x;
    float variance = difference > min_variance ? difference : min_variance;
    precise float distance = receiver - m.x;
    precise float sum = variance + distance * distance;
    float p = variance / sum;
    return receiver <= m.x ? 1.0 : (p > 0.0 ? min(p, 1.0) : 0.0);  // a GPU's v / v may be more than 1.0
}
`,
            "reduce_light_bleeding": `
// umbrage_reduce_light_bleeding: visibility from amount to 1.0 stretched to 0.0 to 1.0: less light bleeds
float umbrage_reduce_light_bleeding(float visibility, float amount) {
    float stretched = (visibility - amount) / (1.0 - amount);
    return visibility > amount ? stretched : 0.0;
}
`,
            "encode_vsm": `
// umbrage_encode_vsm: depth and its square, of depth that grows with distance; NaN counts as far
float2 umbrage_encode_vsm(float depth) {
    float d = umbrage_to_forward_depth(umbrage_saturate(depth));
    return float2(d, d * d);
}
`,
            "decode_vsm": `
// umbrage_decode_vsm: visibility of a receiver, at least its lit share; 1.0 is lit
//   m  mean of texels;   receiver  depth, biased;   min_variance  0.0 or more
float umbrage_decode_vsm(float2 m, float receiver, float min_variance) {
    return umbrage_chebyshev(m, umbrage_to_forward_depth(receiver), min_variance);
}
`,
            "encode_deviation": `
// umbrage_encode_deviation: mean and mean square of depths to mean and twice the standard deviation, each 0.0 to 1.0
float2 umbrage_encode_deviation(float2 m) {
    precise float variance = m.y - m.x * m.x;
    return float2(m.x, 2.0 * sqrt(variance > 0.0 ? variance : 0.0));
}
`,
            "decode_deviation": `
// umbrage_decode_deviation: mean and twice the standard deviation to mean and mean square of depths
float2 umbrage_decode_deviation(float2 held) {
    float half_of_it = held.y * 0.5;
    precise float square = held.x * held.x + half_of_it * half_of_it;
    return float2(held.x, square);
}
`,
            "decode_deviation_rgba8": `
// umbrage_decode_deviation_rgba8: mean and deviation, two channels each, as sampled, to mean and mean square of depths
float2 umbrage_decode_deviation_rgba8(float4 c) {
    float mean = umbrage_decode_rg16(float2(c.x, c.y), 1.0);
    float deviation = umbrage_decode_rg16(float2(c.z, c.w), 1.0);
    return umbrage_decode_deviation(float2(mean, deviation));
}
`,
            "exponential_warp": `
// umbrage_exponential_warp: 2^(exponent * (2.0 * depth - 1.0)) of a depth that grows with distance
float umbrage_exponential_warp(float depth, float exponent) {
    precise float y = exponent * (depth * 2.0 - 1.0);
    return umbrage_exp2_polynomial(y);
}
`,
            "encode_esm": `
// umbrage_encode_esm: depth's power, of depth that grows with distance; NaN counts as far
float umbrage_encode_esm(float depth, float exponent) {
    return umbrage_exponential_warp(umbrage_to_forward_depth(umbrage_saturate(depth)), exponent);
}
`,
            "decode_esm": `
// umbrage_decode_esm: visibility of a receiver, at least its lit share; 1.0 is lit
//   m  mean of texels;   receiver  depth, biased;   exponent  as of the texels
float umbrage_decode_esm(float m, float receiver, float exponent) {
    float d = umbrage_to_forward_depth(receiver);
    float p = m * umbrage_exponential_warp(d, -exponent);
    float lit = p > 0.0 && p < 1.0 ? p : (p >= 1.0 ? 1.0 : 0.0);
    return d > 0.0 ? lit : (d <= 0.0 ? lit : 0.0);
}
`,
            "encode_evsm2": `
// umbrage_encode_evsm2: depth's power and its square, of depth that grows with distance; NaN counts as far
float2 umbrage_encode_evsm2(float depth, float exponent) {
    float w = umbrage_exponential_warp(umbrage_to_forward_depth(umbrage_saturate(depth)), exponent);
    return float2(w, w * w);
}
`,
            "encode_evsm4": `
// umbrage_encode_evsm4: depth's growing power, its square, the negative falling one, its square; NaN counts as far
float4 umbrage_encode_evsm4(float depth, float2 exponents) {
    float d = umbrage_to_forward_depth(umbrage_saturate(depth));
    float w = umbrage_exponential_warp(d, exponents.x);
    float n = -umbrage_exponential_warp(d, -exponents.y);
    return float4(w, w * w, n, n * n);
}
`,
            "decode_evsm2": `
// umbrage_decode_evsm2: visibility of a receiver, at least its lit share; 1.0 is lit
//   m  mean of texels;   receiver  depth, biased;   exponent  as of the texels
//   deviation  least standard deviation, as a part of the receiver's power
float umbrage_decode_evsm2(float2 m, float receiver, float exponent, float deviation) {
    float d = umbrage_to_forward_depth(umbrage_saturate(receiver));
    float w = umbrage_exponential_warp(d, exponent);
    precise float least = deviation * w;
    precise float least_variance = least * least;
    float lit = umbrage_chebyshev(m, w, least_variance);
    return receiver > 0.0 ? lit : (receiver <= 0.0 ? lit : 0.0);
}
`,
            "decode_evsm4": `
// umbrage_decode_evsm4: visibility of a receiver, at least its lit share; 1.0 is lit
//   m  mean of texels;   receiver  depth, biased;   exponents  as of the texels
//   deviations  least standard deviations, as parts of the receiver's powers
float umbrage_decode_evsm4(float4 m, float receiver, float2 exponents, float2 deviations) {
    float d = umbrage_to_forward_depth(umbrage_saturate(receiver));
    float w = umbrage_exponential_warp(d, exponents.x);
    float n = -umbrage_exponential_warp(d, -exponents.y);
    precise float2 least = deviations * float2(w, n);
    precise float2 least_variance = least * least;
    float a = umbrage_chebyshev(float2(m.x, m.y), w, least_variance.x);
    float b = umbrage_chebyshev(float2(m.z, m.w), n, least_variance.y);
    float lit = a < b ? a : b;
    return receiver > 0.0 ? lit : (receiver <= 0.0 ? lit : 0.0);
}
`,
            "encode_msm": `
// umbrage_encode_msm: first four powers of depth on -1.0 to 1.0, of depth that grows with distance; NaN counts as far
float4 umbrage_encode_msm(float depth) {
    precise float z = umbrage_to_forward_depth(umbrage_saturate(depth)) * 2.0 - 1.0;
    float square = z * z;
    return float4(z, square, square * z, square * square);
}
`,
            "to_optimized_moments": `
// umbrage_to_optimized_moments: four moments so that each takes 0.0 to 1.0 wholly, for four channels of 16 bits
float4 umbrage_to_optimized_moments(float4 b) {
    precise float x = (b.x * 0.75 - b.z) * 2.0 + 0.5;
    precise float y = (b.y - b.w) * 4.0;
    precise float z = (b.x * 2.25 - b.z) * 0.384900182 + 0.5;
    precise float w = (b.y + b.w) * 0.5;
    return float4(x, y, z, w);
}
`,
            "hausdorff_share": `
// umbrage_hausdorff_share: least share of depths on -1.0 to 1.0 before the receiver's, of four moments
//   b  moments, biased;   z  the receiver's depth on -1.0 to 1.0
//   negative where the share is that of umbrage_moment_atoms
float umbrage_hausdorff_share(float4 b, float z) {
    precise float variance = b.y - b.x * b.x;
    precise float third = b.z - b.x * b.y;
    precise float fourth = b.w - b.y * b.y;
    precise float rest = 1.0 - b.y;
    precise float x = z - b.x;
    precise float d = third + rest * x;
    precise float g = (fourth - variance * rest) - (z + b.x) * third;
    precise float p = d * (1.0 + b.x) + g;
    precise float q = d * (1.0 - b.x) - g;
    precise float k = rest * g + third * d;
    precise float first = (1.0 + z) * (d * variance + g * (1.0 - b.x)) - k;
    precise float last = (1.0 - z) * (d * variance - g * (1.0 + b.x)) + k;
    float square = d * d;
    precise float between = p * (q * (x * d - g));
    float end = first / (2.0 * ((1.0 + z) * p));
    float other = square * square / between;
    float share = end + (d > 0.0 ? other : 0.0);
    bool four = first * p > 0.0 && last * q > 0.0 && p * q > 0.0 && share >= 0.0;
    return z <= -1.0 ? 0.0 : (four ? (share < 1.0 ? share : 1.0) : -1.0);
}
`,
            "decode_msm_hausdorff": `
// umbrage_decode_msm_hausdorff: visibility of a receiver, at least its lit share less bias.x; 1.0 is lit
//   b  mean of texels;   receiver  depth, biased;   bias  (3e-6, 0.375)
float umbrage_decode_msm_hausdorff(float4 b, float receiver, float2 bias) {
    float plain = umbrage_decode_msm(b, receiver, bias);
    float d = umbrage_to_forward_depth(receiver);
    float z = (d > 0.0 ? (d < 1.0 ? d : 1.0) : 0.0) * 2.0 - 1.0;
    float share = umbrage_hausdorff_share(umbrage_bias_moments(b, bias), z);
    float lit = share >= 0.0 ? 1.0 - share : plain;
    return d > 0.0 ? lit : (d <= 0.0 ? lit : 0.0);
}
`,
            "fetch_bilinear": `
// umbrage_fetch_bilinear: mean of the four texels around a point, weights in steps of 1/256
//   coord  in texels, first center at (0.5, 0.5)
float4 umbrage_fetch_bilinear(UMBRAGE_MAP map, float2 size, float2 coord) {
    float2 x = floor(coord * 256.0) - 128.0;
    float2 texel = floor(x * (1.0 / 256.0));
    // weights are in [0, 256) already; compilers cannot regroup sums across the clamp
    float2 hi = clamp(x * (1.0 / 256.0) - texel, float2(0.0, 0.0), float2(1.0, 1.0)) * 256.0;
    float2 lo = 256.0 - hi;  // of 1.0 - hi compilers would make an interpolation, which rounds otherwise
    float4 a = umbrage_fetch_clamped(map, size, texel);
    float4 b = umbrage_fetch_clamped(map, size, texel + float2(1.0, 0.0));
    float4 c = umbrage_fetch_clamped(map, size, texel + float2(0.0, 1.0));
    float4 d = umbrage_fetch_clamped(map, size, texel + float2(1.0, 1.0));
    precise float4 low = a * lo.x + b * hi.x;
    precise float4 high = c * lo.x + d * hi.x;
    precise float4 sum = low * lo.y + high * hi.y;
    return sum * (1.0 / 65536.0);
}
`,
            "vsm": `
// umbrage_vsm: visibility from a map of encode_vsm's texels, blurred; 1.0 is lit
//   map, size  prefiltered map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   min_variance  0.0 or more
float umbrage_vsm(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float min_variance) {
    bool compared = umbrage_map_covers(size, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    float4 m = umbrage_fetch_bilinear(map, size, compared ? coord : float2(0.0, 0.0));
    float lit = umbrage_decode_vsm(float2(m.x, m.y), receiver, min_variance);
    return compared ? lit : 1.0;
}
`,
            "esm": `
// umbrage_esm: visibility from a map of encode_esm's texels, blurred; 1.0 is lit
//   map, size  prefiltered map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   exponent  as of the texels
float umbrage_esm(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float exponent) {
    bool compared = umbrage_map_covers(size, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    float4 m = umbrage_fetch_bilinear(map, size, compared ? coord : float2(0.0, 0.0));
    float lit = umbrage_decode_esm(m.x, receiver, exponent);
    return compared ? lit : 1.0;
}
`,
            "evsm2": `
// umbrage_evsm2: visibility from a map of encode_evsm2's texels, blurred; 1.0 is lit
//   map, size  prefiltered map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   exponent, deviation  as of decode_evsm2
float umbrage_evsm2(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float exponent, float deviation) {
    bool compared = umbrage_map_covers(size, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    float4 m = umbrage_fetch_bilinear(map, size, compared ? coord : float2(0.0, 0.0));
    float lit = umbrage_decode_evsm2(float2(m.x, m.y), receiver, exponent, deviation);
    return compared ? lit : 1.0;
}
`,
            "evsm4": `
// umbrage_evsm4: visibility from a map of encode_evsm4's texels, blurred; 1.0 is lit
//   map, size  prefiltered map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   exponents, deviations  as of decode_evsm4
float umbrage_evsm4(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float2 exponents, float2 deviations) {
    bool compared = umbrage_map_covers(size, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    float4 m = umbrage_fetch_bilinear(map, size, compared ? coord : float2(0.0, 0.0));
    float lit = umbrage_decode_evsm4(m, receiver, exponents, deviations);
    return compared ? lit : 1.0;
}
`,
            "msm": `
// umbrage_msm: visibility from a map of encode_msm's texels, blurred; 1.0 is lit
//   map, size  prefiltered map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   bias  as of decode_msm
float umbrage_msm(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float2 bias) {
    bool compared = umbrage_map_covers(size, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    float4 m = umbrage_fetch_bilinear(map, size, compared ? coord : float2(0.0, 0.0));
    float lit = umbrage_decode_msm(m, receiver, bias);
    return compared ? lit : 1.0;
}
`,
            "msm_unorm16": `
// umbrage_msm_unorm16: visibility from a map of turned moments, blurred; 1.0 is lit
//   map, size  prefiltered map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   bias  as of decode_msm
float umbrage_msm_unorm16(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float2 bias) {
    bool compared = umbrage_map_covers(size, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    float4 m = umbrage_fetch_bilinear(map, size, compared ? coord : float2(0.0, 0.0));
    float lit = umbrage_decode_msm(umbrage_from_optimized_moments(m), receiver, bias);
    return compared ? lit : 1.0;
}
`,
            "msm_hausdorff": `
// umbrage_msm_hausdorff: visibility from a map of encode_msm's texels, blurred; 1.0 is lit
//   map, size  prefiltered map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   bias  as of decode_msm
float umbrage_msm_hausdorff(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float2 bias) {
    bool compared = umbrage_map_covers(size, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    float4 m = umbrage_fetch_bilinear(map, size, compared ? coord : float2(0.0, 0.0));
    float lit = umbrage_decode_msm_hausdorff(m, receiver, bias);
    return compared ? lit : 1.0;
}
`,
            "chebyshev_hardware": `
// umbrage_chebyshev_hardware: share of depths that may be as far as the receiver or farther, its least part cut
//   variance  above 0.0;   distance  from mean to receiver, no NaN;   amount  that is cut, 0.0 to 0.5
float umbrage_chebyshev_hardware(float variance, float distance, float amount) {
    float beyond = max(distance, 0.0);
    float p = variance / (variance + beyond * beyond);
    return clamp((p - amount) / (1.0 - amount), 0.0, 1.0);
}
`,
            "decode_vsm_hardware": `
// umbrage_decode_vsm_hardware: visibility of a receiver, less the light that bleeds; 1.0 is lit
//   held  mean and twice the standard deviation of depths, filtered;   receiver  depth, biased
//   min_variance  1e-7 or more;   amount  that is cut, 0.0 to 0.5
float umbrage_decode_vsm_hardware(float2 held, float receiver, float min_variance, float amount) {
    float variance = max(held.y * held.y * 0.25, min_variance);
    float distance = umbrage_to_forward_depth(receiver) - held.x;
    float lit = umbrage_chebyshev_hardware(variance, distance, amount);
    return abs(receiver) < 1048576.0 ? lit : 0.0;
}
`,
            "decode_evsm2_hardware": `
// umbrage_decode_evsm2_hardware: visibility of a receiver, less the light that bleeds; 1.0 is lit
//   m  mean of texels;   receiver  depth, biased;   exponent  as of the texels
//   deviation  least standard deviation, as a part of the receiver's power;   amount  that is cut, 0.0 to 0.3
float umbrage_decode_evsm2_hardware(float2 m, float receiver, float exponent, float deviation, float amount) {
    float d = umbrage_to_forward_depth(clamp(receiver, 0.0, 1.0));
    float w = exp2(exponent * (d * 2.0 - 1.0));
    float least = deviation * w;
    float variance = max(m.y - m.x * m.x, least * least);
    float lit = umbrage_chebyshev_hardware(variance, w - m.x, amount);
    return abs(receiver) < 1048576.0 ? lit : 0.0;
}
`,
            "decode_evsm4_hardware": `
// umbrage_decode_evsm4_hardware: visibility of a receiver, less the light that bleeds; 1.0 is lit
//   m  mean of texels;   receiver  depth, biased;   exponents  as of the texels
//   deviations  least standard deviations, as parts of the receiver's powers;   amount  that is cut, 0.0 to 0.3
float umbrage_decode_evsm4_hardware(float4 m, float receiver, float2 exponents, float2 deviations, float amount) {
    float d = umbrage_to_forward_depth(clamp(receiver, 0.0, 1.0)) * 2.0 - 1.0;
    float w = exp2(exponents.x * d);
    float n = 0.0 - exp2((0.0 - exponents.y) * d);
    float2 least = deviations * float2(w, n);
    float growing = max(m.y - m.x * m.x, least.x * least.x);
    float falling = max(m.w - m.z * m.z, least.y * least.y);
    float a = umbrage_chebyshev_hardware(growing, w - m.x, amount);
    float b = umbrage_chebyshev_hardware(falling, n - m.z, amount);
    return abs(receiver) < 1048576.0 ? min(a, b) : 0.0;
}
`,
            "blur_row3": `
// umbrage_blur_row3: mean of 3 texels in a row, weighed by a row of Pascal's triangle
//   map, size  read from, and its size in texels;   texel  whole numbers, (0, 0) is the first
//   along      (1.0, 0.0) or (0.0, 1.0)
float4 umbrage_blur_row3(UMBRAGE_MAP map, float2 size, float2 texel, float2 along) {
    precise float4 sum = umbrage_fetch_clamped(map, size, texel) * (2.0 / 4.0);
    float4 before1 = umbrage_fetch_clamped(map, size, texel - along * 1.0);
    float4 after1 = umbrage_fetch_clamped(map, size, texel + along * 1.0);
    sum = sum + (before1 + after1) * (1.0 / 4.0);
    return sum;
}
`,
            "blur_row5": `
// umbrage_blur_row5: mean of 5 texels in a row, weighed by a row of Pascal's triangle
//   map, size  read from, and its size in texels;   texel  whole numbers, (0, 0) is the first
//   along      (1.0, 0.0) or (0.0, 1.0)
float4 umbrage_blur_row5(UMBRAGE_MAP map, float2 size, float2 texel, float2 along) {
    precise float4 sum = umbrage_fetch_clamped(map, size, texel) * (6.0 / 16.0);
    float4 before1 = umbrage_fetch_clamped(map, size, texel - along * 1.0);
    float4 after1 = umbrage_fetch_clamped(map, size, texel + along * 1.0);
    sum = sum + (before1 + after1) * (4.0 / 16.0);
    float4 before2 = umbrage_fetch_clamped(map, size, texel - along * 2.0);
    float4 after2 = umbrage_fetch_clamped(map, size, texel + along * 2.0);
    sum = sum + (before2 + after2) * (1.0 / 16.0);
    return sum;
}
`,
            "blur_row7": `
// umbrage_blur_row7: mean of 7 texels in a row, weighed by a row of Pascal's triangle
//   map, size  read from, and its size in texels;   texel  whole numbers, (0, 0) is the first
//   along      (1.0, 0.0) or (0.0, 1.0)
float4 umbrage_blur_row7(UMBRAGE_MAP map, float2 size, float2 texel, float2 along) {
    precise float4 sum = umbrage_fetch_clamped(map, size, texel) * (20.0 / 64.0);
    float4 before1 = umbrage_fetch_clamped(map, size, texel - along * 1.0);
    float4 after1 = umbrage_fetch_clamped(map, size, texel + along * 1.0);
    sum = sum + (before1 + after1) * (15.0 / 64.0);
    float4 before2 = umbrage_fetch_clamped(map, size, texel - along * 2.0);
    float4 after2 = umbrage_fetch_clamped(map, size, texel + along * 2.0);
    sum = sum + (before2 + after2) * (6.0 / 64.0);
    float4 before3 = umbrage_fetch_clamped(map, size, texel - along * 3.0);
    float4 after3 = umbrage_fetch_clamped(map, size, texel + along * 3.0);
    sum = sum + (before3 + after3) * (1.0 / 64.0);
    return sum;
}
`,
            "halve_texels": `
// umbrage_halve_texels: mean of the 2x2 texels that a texel of the next level of a mip chain is made of
//   map, size  read from, and its size in texels;   texel  of the next level, whole numbers
float4 umbrage_halve_texels(UMBRAGE_MAP map, float2 size, float2 texel) {
    float2 at = texel * 2.0;
    float4 a = umbrage_fetch_clamped(map, size, at);
    float4 b = umbrage_fetch_clamped(map, size, at + float2(1.0, 0.0));
    float4 c = umbrage_fetch_clamped(map, size, at + float2(0.0, 1.0));
    float4 d = umbrage_fetch_clamped(map, size, at + float2(1.0, 1.0));
    precise float4 sum = (a + b) + (c + d);
    return sum * 0.25;
}
`,
            "texels_to_world": `
// umbrage_texels_to_world: texels across a light as world units; 0.0 for w <= 0.0
//   units  (edge of a texel, depth a world unit) at w = 1.0;   w  of the point's shadow coordinate
float umbrage_texels_to_world(float texels, float2 units, float w) {
    precise float world = texels * units.x * w;
    return world >= (1.0 / 18446744073709551616.0) && world < 18446744073709551616.0 ? world : 0.0;
}
`,
            "clamp_bias": `
// umbrage_clamp_bias: a bias in depth clamped to [0, 1], 0.0 below 2^-64; NaN becomes 1.0, and nothing is in shadow
float umbrage_clamp_bias(float bias) {
    float least = (1.0 / 18446744073709551616.0);
    return bias >= least && bias < 1.0 ? bias : (bias < least ? 0.0 : 1.0);
}
`,
            "world_to_depth": `
// umbrage_world_to_depth: world units along a light as depth, 0.0 to 1.0
//   units  (edge of a texel, depth a world unit) at w = 1.0;   w  of the point's shadow coordinate, above 0.0
float umbrage_world_to_depth(float world, float2 units, float w) {
    precise float along = world * units.y;
    precise float square = w * w;
    return umbrage_clamp_bias(along / square);
}
`,
            "biased": `
// umbrage_biased: receiver moved towards the light by bias, in depth; 2^64 and more, and NaN, is none
float umbrage_biased(float receiver, float bias) {
    float by = abs(bias) < 18446744073709551616.0 ? bias : 0.0;
    return umbrage_cleared_depth() > 0.5 ? receiver - by : receiver + by;
}
`,
            "clamp_slope": `
// umbrage_clamp_slope: change of depth a texel clamped to [-2, 2]; NaN becomes 2.0
float umbrage_clamp_slope(float slope) {
    return slope > -2.0 && slope < 2.0 ? slope : (slope <= -2.0 ? -2.0 : 2.0);
}
`,
            "plane_slope": `
// umbrage_plane_slope: change of depth from one texel to the next, in x and y, of the plane through a point
//   plane_matrix  transpose of the texture matrix' inverse;   normal  of any length;   world  point on the plane
float2 umbrage_plane_slope(float4x4 plane_matrix, float3 normal, float3 world) {
    precise float d = -(normal.x * world.x + normal.y * world.y + normal.z * world.z);
    precise float4 q = transpose(plane_matrix)[3] * d + transpose(plane_matrix)[0] * normal.x +
        transpose(plane_matrix)[1] * normal.y + transpose(plane_matrix)[2] * normal.z;
    return float2(umbrage_clamp_slope(-q.x / q.z), umbrage_clamp_slope(-q.y / q.z));
}
`,
            "receiver_slope": `
// umbrage_receiver_slope: umbrage_plane_slope, and (0.0, 0.0) for a normal of zero, of a caller who has none
float2 umbrage_receiver_slope(float4x4 plane_matrix, float3 normal, float3 world) {
    float2 slope = umbrage_plane_slope(plane_matrix, normal, world);
    bool none = normal.x == 0.0 && normal.y == 0.0 && normal.z == 0.0;
    return none ? float2(0.0, 0.0) : slope;
}
`,
            "cascade_slope": `
// umbrage_cascade_slope: change of depth from one texel to the next; (0.0, 0.0) for a normal of zero
//   normal  of the surface, rotated into the light's directions;   scale  of the cascade
float2 umbrage_cascade_slope(float3 normal, float4 scale) {
    precise float2 up = float2(normal.x, normal.y) * -scale.z;
    precise float2 across = float2(scale.x, scale.y) * normal.z;
    bool none = normal.x == 0.0 && normal.y == 0.0 && normal.z == 0.0;
    float2 slope = float2(umbrage_clamp_slope(up.x / across.x), umbrage_clamp_slope(up.y / across.y));
    return none ? float2(0.0, 0.0) : slope;
}
`,
            "slope_bias": `
// umbrage_slope_bias: factor times the greater slope, and a base, 0.0 to 1.0
//   slope  change of depth from one texel to the next;   factor  in texels;   base  in depth
float umbrage_slope_bias(float2 slope, float factor, float base) {
    precise float2 bias = abs(slope) * factor + base;
    float x = umbrage_clamp_bias(bias.x);  // of both: a maximum of a NaN is what a GPU makes it
    float y = umbrage_clamp_bias(bias.y);
    return x > y ? x : y;
}
`,
            "dual_paraboloid_slope": `
// umbrage_dual_paraboloid_slope: change of distance from one texel to the next, in x and y alike; 0.0 without a normal
//   way  from the light to the receiver;   normal  of its surface;   per_texel  2.0 / (range * (size - 2.0 * border))
float2 umbrage_dual_paraboloid_slope(float3 way, float3 normal, float per_texel) {
    precise float square = way.x * way.x + way.y * way.y + way.z * way.z;
    precise float x = normal.y * way.z - normal.z * way.y;
    precise float y = normal.z * way.x - normal.x * way.z;
    precise float z = normal.x * way.y - normal.y * way.x;
    precise float across = x * x + y * y + z * z;
    precise float along = normal.x * way.x + normal.y * way.y + normal.z * way.z;
    precise float wide = (sqrt(square) + abs(way.z)) * (per_texel * 0.707106781);
    float slope = umbrage_clamp_slope(wide * sqrt(across) / abs(along));
    bool none = normal.x == 0.0 && normal.y == 0.0 && normal.z == 0.0;
    return none ? float2(0.0, 0.0) : float2(slope, slope);
}
`,
            "normal_offset": `
// umbrage_normal_offset: what to add to a surface's point, world units, before it is looked up
//   normal, direction  of the surface and the light, of length one;   way  from the light to the point over w; of a
//   directional light its direction;   width  sqrt(2) reach texel;   error_world  of the map's depths; world units
float3 umbrage_normal_offset(float3 normal, float3 direction, float3 way, float width, float error_world) {
    precise float x = normal.y * direction.z + normal.z * -direction.y;
    precise float y = normal.z * direction.x + normal.x * -direction.z;
    precise float z = normal.x * direction.y + normal.y * -direction.x;
    precise float straight = normal.x * way.x + normal.y * way.y + normal.z * way.z;
    precise float square = x * x + y * y + z * z;
    precise float along = width * sqrt(square) + error_world * abs(straight);
    float3 offset = normal * along;
    return abs(offset.x) + abs(offset.y) + abs(offset.z) < 18446744073709551616.0 ? offset : float3(0.0, 0.0, 0.0);
}
`,
            "kernel_bias": `
// umbrage_kernel_bias: how far along the light a kernel reaches before a surface's plane, in the units of width
//   normal  of the surface;   direction  of the light, of length one;   way  from the light to the point over w; of a
//   directional light its direction;   width  sqrt(2) reach texel;   greatest  tangent, where growth ends
float umbrage_kernel_bias(float3 normal, float3 direction, float3 way, float width, float greatest) {
    precise float x = normal.y * direction.z + normal.z * -direction.y;
    precise float y = normal.z * direction.x + normal.x * -direction.z;
    precise float z = normal.x * direction.y + normal.y * -direction.x;
    precise float square = x * x + y * y + z * z;
    float sine = sqrt(square);
    precise float cosine = -(normal.x * way.x + normal.y * way.y + normal.z * way.z);
    precise float edge = cosine * greatest;
    float tangent = edge > sine ? sine / cosine : greatest;
    float bias = width * tangent;
    return bias >= (1.0 / 18446744073709551616.0) && bias < 18446744073709551616.0 ? bias : 0.0;
}
`,
            "receiver_plane_slope": `
// umbrage_receiver_plane_slope: change of a receiver's depth a texel in x and y, and by how much their sum may be off
//   dx, dy  dFdx and dFdy of (x and y in texels, depth); zero where they tell nothing of the plane
float3 umbrage_receiver_plane_slope(float3 dx, float3 dy) {
    precise float determinant = dx.x * dy.y + dx.y * -dy.x;
    precise float sum = abs(dx.x) + abs(dx.y) + abs(dy.x) + abs(dy.y);
    precise float along_x = dy.y * dx.z + dx.y * -dy.z;
    precise float along_y = dx.x * dy.z + dy.x * -dx.z;
    float a = umbrage_clamp_slope(along_x / determinant);
    float b = umbrage_clamp_slope(along_y / determinant);
    precise float off = ((1.0 / 33554432.0) + (abs(a) + abs(b)) * (1.0 / 8192.0)) * 3.3;
    precise float error = off * (sum / abs(determinant));
    float least = sum * (1.0 / 1024.0);
    bool known = abs(determinant) > least && sum < 18446744073709551616.0;
    return known ? float3(a, b, umbrage_clamp_slope(error)) : float3(0.0, 0.0, 0.0);
}
`,
            "apply_receiver_plane": `
// umbrage_apply_receiver_plane: a texel's depth as the receiver's own texel would hold it; a cleared one stays cleared
//   stored  depth of the texel;   slope  of the receiver's plane, a texel;   coord  receiver in texels
float umbrage_apply_receiver_plane(float stored, float2 slope, float2 coord, float2 texel) {
    precise float2 way = texel + 0.5 - coord;
    precise float depth = stored - (slope.x * way.x + slope.y * way.y);
    bool cleared = abs(stored - umbrage_cleared_depth()) < (1.0 / 18446744073709551616.0);
    return cleared ? stored : depth;
}
`,
            "acne_free_bias": `
// umbrage_acne_free_bias: the smallest bias in depth with which no plane shadows itself, 0.0 to 1.0
//   slope  change of depth from one texel to the next;   reach  of the filter, texels
//   error  how far a decoded depth may lie before the true one
float umbrage_acne_free_bias(float2 slope, float reach, float error) {
    precise float bias = reach * (abs(slope.x) + abs(slope.y)) + (error + (1.0 / 8388608.0));
    return umbrage_clamp_bias(bias);
}
`,
            "acne_free_disc_bias": `
// umbrage_acne_free_disc_bias: the smallest bias in depth with which no plane shadows itself, 0.0 to 1.0
//   slope   change of depth from one texel to the next;   radius  to the disc's farthest point, texels
//   error   how far a decoded depth may lie before the true one
float umbrage_acne_free_disc_bias(float2 slope, float radius, float error) {
    precise float square = slope.x * slope.x + slope.y * slope.y;
    precise float beside = (abs(slope.x) + abs(slope.y)) * 0.5078125 + (error + (1.0 / 8388608.0));
    precise float bias = radius * sqrt(square) + beside;
    return umbrage_clamp_bias(bias);
}
`,
            "peter_panning_distance": `
// umbrage_peter_panning_distance: a caster nearer to the receiver loses its shadow, or a part of it; depth, 0.0 to 1.0
//   bias   of the receiver, in depth;   caster_slope  change of the caster's depth from one texel to the next
//   reach  of the filter, texels
float umbrage_peter_panning_distance(float bias, float2 caster_slope, float reach) {
    return umbrage_acne_free_bias(caster_slope, reach, bias);
}
`,
            "spot_cone": `
// umbrage_spot_cone: 1.0 inside the cone of a spot light, else 0.0
//   direction  of the light, unit length;   to_point  from the light, any length;   cos_outer  in [0, 1)
float umbrage_spot_cone(float3 direction, float3 to_point, float cos_outer) {
    precise float d = direction.x * to_point.x + direction.y * to_point.y + direction.z * to_point.z;
    precise float length2 = to_point.x * to_point.x + to_point.y * to_point.y + to_point.z * to_point.z;
    precise float edge2 = cos_outer * cos_outer * length2;
    precise float d2 = d * d;
    return d > 0.0 && d2 > edge2 ? 1.0 : 0.0;
}
`,
            "diffuse_ambient": `
// umbrage_diffuse_ambient: albedo * (visibility * n_dot_l * (1 - ambient) + ambient); for n_dot_l <= 0, NaN: ambient
float3 umbrage_diffuse_ambient(float3 albedo, float ambient, float n_dot_l, float visibility) {
    precise float light = visibility * n_dot_l * (1.0 - ambient) + ambient;
    return albedo * (n_dot_l > 0.0 ? light : ambient);  // a max of n_dot_l and 0.0 is NaN for a signalling one on Mesa
}
`,
            "false_color": `
// umbrage_false_color: blue for 0.0, through green, to red for 1.0
float3 umbrage_false_color(float v) {
    float x = umbrage_saturate(v) * 4.0;
    precise float3 ramp = 1.5 - abs(float3(x - 3.0, x - 2.0, x - 1.0));
    return float3(umbrage_saturate(ramp.x), umbrage_saturate(ramp.y), umbrage_saturate(ramp.z));
}
`,
            "overlay_texel": `
// umbrage_overlay_texel: texel under a pixel of a map stretched over the picture's corner; -1.0 outside the overlay
//   coord     center of the pixel, counted from the corner: 0.5, 1.5, ...;   size  of the overlay in pixels, whole
//   map_size  in texels, whole, at most 65536.0; times size at most 2^23;   texels_per_pixel  map_size / size
float umbrage_overlay_texel(float coord, float size, float map_size, float texels_per_pixel) {
    float texel = floor(coord * texels_per_pixel - 0.5);
    texel += (texel + 1.0) * size <= coord * map_size ? 1.0 : 0.0;
    return coord >= 0.0 && coord < size ? texel : -1.0;
}
`,
            "probe_color": `
// umbrage_probe_color: what a receiver's place in a map says, as a color
//   at    (x, y) in texels, z depth;   size  of the map;   bias  of the receiver;   number  of the map, whole
//   magenta  not a number;   black  behind the light, in no cascade;   white  outside the map
//   cyan  beyond the far plane;   blue  before the near plane;   red  bias at its limit;   else texels
float3 umbrage_probe_color(float3 at, float2 size, float bias, float number) {
    float limit = 18446744073709551616.0;
    bool usable = abs(at.x) < limit && abs(at.y) < limit && abs(at.z) < limit;
    bool inside = at.x >= 0.0 && at.y >= 0.0 && at.x <= size.x && at.y <= size.y;
    bool forward = umbrage_cleared_depth() > 0.5;
    bool past_far = forward ? at.z > 1.0 : at.z < 0.0;
    bool past_near = forward ? at.z < 0.0 : at.z > 1.0;
    float square = floor(at.x) + floor(at.y);
    float shade = square - 2.0 * floor(square * 0.5) > 0.5 ? 0.75 : 1.0;
    float3 bits = floor(float3(number + 1.0, (number + 1.0) * 0.5, (number + 1.0) * 0.25));
    bits = bits - 2.0 * floor(bits * 0.5);
    float3 color = (bits * 0.5 + 0.375) * shade;
    color = bias < 1.0 ? color : float3(1.0, 0.0, 0.0);
    color = past_near ? float3(0.0, 0.0, 1.0) : color;
    color = past_far ? float3(0.0, 1.0, 1.0) : color;
    color = inside ? color : float3(1.0, 1.0, 1.0);
    color = at.x < 65536.0 ? color : float3(0.0, 0.0, 0.0);
    return usable ? color : float3(1.0, 0.0, 1.0);
}
`,
            "probe_inputs": `
// umbrage_probe_inputs: color, unless the receiver is wrong; magenta  not a number;   yellow  a normal of zero
float3 umbrage_probe_inputs(float3 color, float3 world, float3 normal) {
    float limit = 18446744073709551616.0;
    bool usable = abs(world.x) < limit && abs(world.y) < limit && abs(world.z) < limit;
    usable = usable && abs(normal.x) < limit && abs(normal.y) < limit && abs(normal.z) < limit;
    bool zero = normal.x == 0.0 && normal.y == 0.0 && normal.z == 0.0;
    float3 given = zero ? float3(1.0, 1.0, 0.0) : color;
    return usable ? given : float3(1.0, 0.0, 1.0);
}
`,
            "hooks/cleared_depth, reversed": `
// umbrage_cleared_depth: depth of the far plane
float umbrage_cleared_depth() {
    return 0.0;
}
`,
            "hooks/map_covers, clamped": `
// umbrage_map_covers: always, as outside the map the nearest texel inside counts
precise bool umbrage_map_covers(float2 size, float2 coord) {
    return true;
}
`,
            "hooks/beyond_far_plane, reversed": `
// umbrage_beyond_far_plane: whether a receiver is behind the far plane
precise bool umbrage_beyond_far_plane(float receiver) {
    return receiver < 0.0;
}
`,
            "hooks/beyond_far_plane, without": `
// umbrage_beyond_far_plane: never for this map; receivers behind the far plane come in as what every texel lights
precise bool umbrage_beyond_far_plane(float receiver) {
    return false;
}
`,
            "hooks/within_far_plane, reversed": `
// umbrage_within_far_plane: whether a receiver is a number, and not behind the far plane
precise bool umbrage_within_far_plane(float receiver) {
    return receiver >= 0.0;
}
`,
            "hooks/within_far_plane, without": `
// umbrage_within_far_plane: whether a receiver is a number, as for this map none is behind the far plane
precise bool umbrage_within_far_plane(float receiver) {
    // a sum of choices, not an or of comparisons, which compilers take for true
    float number = (receiver > 0.0 ? 1.0 : 0.0) + (receiver <= 0.0 ? 1.0 : 0.0);
    return number > 0.5;
}
`,
            "hooks/compare, reversed": `
// umbrage_compare: 1.0 when the receiver is no farther than the stored depth, near is 1.0
float umbrage_compare(float receiver, float stored) {
    return receiver >= stored ? 1.0 : 0.0;
}
`,
            "hooks/compare, own": `
// umbrage_compare: visibility of one comparison, the map's own
float umbrage_compare(float receiver, float stored) {
    return UMBRAGE_COMPARE;
}
`,
            "hooks/decode": `
// umbrage_decode: depth of a value that the sampler gave
float umbrage_decode(float4 value) {
    return UMBRAGE_DEPTH;
}
`,
            "hooks/fetch_depth, clamped": `
// umbrage_fetch_depth: stored depth of a texel, outside the map of the nearest one inside
float umbrage_fetch_depth(UMBRAGE_MAP map, float2 size, float2 texel) {
    float4 value = umbrage_fetch_clamped(map, size, texel);
    return UMBRAGE_DEPTH;
}
`,
            "hooks/lit_texel": `
// umbrage_lit_texel: the sampler's comparison with a texel inside the map; a NaN is in shadow
float umbrage_lit_texel(UMBRAGE_MAP map, float2 size, float2 texel, float receiver) {
    float2 at = texel + UMBRAGE_ORIGIN;
    float lit = UMBRAGE_LIT_TEXEL;
    return (receiver > 0.0 ? lit : 0.0) + (receiver <= 0.0 ? lit : 0.0);
}
`,
            "hooks/lit, clamped": `
// umbrage_lit: visibility of one comparison with a texel, outside the map with the nearest one inside
float umbrage_lit(UMBRAGE_MAP map, float2 size, float2 texel, float receiver) {
    return umbrage_lit_texel(map, size, clamp(texel, float2(0.0, 0.0), size - 1.0), receiver);
}
`,
            "hooks/lit, bordered": `
// umbrage_lit: visibility of one comparison with a texel, outside the map with the far plane
float umbrage_lit(UMBRAGE_MAP map, float2 size, float2 texel, float receiver) {
    float2 inside = clamp(texel, float2(0.0, 0.0), size - 1.0);
    float lit = umbrage_lit_texel(map, size, inside, receiver);
    float outside = umbrage_compare(receiver, UMBRAGE_BORDER);
    return inside.x == texel.x && inside.y == texel.y ? lit : outside;
}
`,
            "hooks/gather_lit, compared": `
// umbrage_gather_lit: the sampler's comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1); a NaN is in shadow
float4 umbrage_gather_lit(UMBRAGE_MAP map, float2 size, float2 texel, float receiver) {
    float2 at = texel + UMBRAGE_ORIGIN;
    float4 lit = UMBRAGE_GATHER_LIT;
    float number = (receiver > 0.0 ? 1.0 : 0.0) + (receiver <= 0.0 ? 1.0 : 0.0);
    return float4(lit.w, lit.z, lit.x, lit.y) * number;
}
`,
            "hooks/gather_lit, one channel": `
// umbrage_gather_lit: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1)
float4 umbrage_gather_lit(UMBRAGE_MAP map, float2 size, float2 texel, float receiver) {
    float2 at = texel + UMBRAGE_ORIGIN;
    float4 r = UMBRAGE_GATHER_RED;
    float a = umbrage_compare(receiver, umbrage_decode(float4(r.w, 0.0, 0.0, 0.0)));
    float b = umbrage_compare(receiver, umbrage_decode(float4(r.z, 0.0, 0.0, 0.0)));
    float c = umbrage_compare(receiver, umbrage_decode(float4(r.x, 0.0, 0.0, 0.0)));
    float d = umbrage_compare(receiver, umbrage_decode(float4(r.y, 0.0, 0.0, 0.0)));
    return float4(a, b, c, d);
}
`,
            "hooks/gather_lit, two channels": `
// umbrage_gather_lit: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1)
float4 umbrage_gather_lit(UMBRAGE_MAP map, float2 size, float2 texel, float receiver) {
    float2 at = texel + UMBRAGE_ORIGIN;
    float4 r = UMBRAGE_GATHER_RED;
    float4 g = UMBRAGE_GATHER_GREEN;
    float a = umbrage_compare(receiver, umbrage_decode(float4(r.w, g.w, 0.0, 0.0)));
    float b = umbrage_compare(receiver, umbrage_decode(float4(r.z, g.z, 0.0, 0.0)));
    float c = umbrage_compare(receiver, umbrage_decode(float4(r.x, g.x, 0.0, 0.0)));
    float d = umbrage_compare(receiver, umbrage_decode(float4(r.y, g.y, 0.0, 0.0)));
    return float4(a, b, c, d);
}
`,
            "hooks/lit_2x2, gathered": `
// umbrage_lit_2x2: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1); the sampler clamps
float4 umbrage_lit_2x2(UMBRAGE_MAP map, float2 size, float2 texel, float receiver) {
    return umbrage_gather_lit(map, size, texel, receiver);
}
`,
            "hooks/lit_2x2, gathered in a region": `
// umbrage_lit_2x2: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1), outside the map with
//   the nearest texel inside: the gather stays inside, and each comparison is taken from its row and column
float4 umbrage_lit_2x2(UMBRAGE_MAP map, float2 size, float2 texel, float receiver) {
    float2 first = clamp(texel, float2(0.0, 0.0), max(size - 2.0, float2(0.0, 0.0)));
    float2 low = clamp(texel, float2(0.0, 0.0), size - 1.0) - first;
    float2 high = clamp(texel + 1.0, float2(0.0, 0.0), size - 1.0) - first;
    float4 lit = umbrage_gather_lit(map, size, first, receiver);
    float2 left = low.x > 0.5 ? float2(lit.y, lit.w) : float2(lit.x, lit.z);
    float2 right = high.x > 0.5 ? float2(lit.y, lit.w) : float2(lit.x, lit.z);
    float2 bottom = low.y > 0.5 ? float2(left.y, right.y) : float2(left.x, right.x);
    float2 top = high.y > 0.5 ? float2(left.y, right.y) : float2(left.x, right.x);
    return float4(bottom.x, bottom.y, top.x, top.y);
}
`,
            "hooks/lit_2x2, gathered and bordered": `
// umbrage_lit_2x2: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1), outside the map with
//   the far plane, whatever the sampler has there
float4 umbrage_lit_2x2(UMBRAGE_MAP map, float2 size, float2 texel, float receiver) {
    float4 lit = umbrage_gather_lit(map, size, texel, receiver);
    float outside = umbrage_compare(receiver, UMBRAGE_BORDER);
    float a = umbrage_inside_map(size, texel) ? lit.x : outside;
    float b = umbrage_inside_map(size, texel + float2(1.0, 0.0)) ? lit.y : outside;
    float c = umbrage_inside_map(size, texel + float2(0.0, 1.0)) ? lit.z : outside;
    float d = umbrage_inside_map(size, texel + float2(1.0, 1.0)) ? lit.w : outside;
    return float4(a, b, c, d);
}
`,
            "hooks/lit_2x2, gathered in a bordered region": `
// umbrage_lit_2x2: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1), outside the map with
//   the far plane: the gather stays inside
float4 umbrage_lit_2x2(UMBRAGE_MAP map, float2 size, float2 texel, float receiver) {
    float2 first = clamp(texel, float2(0.0, 0.0), max(size - 2.0, float2(0.0, 0.0)));
    float2 low = texel - first;
    float4 lit = umbrage_gather_lit(map, size, first, receiver);
    float2 left = low.x > 0.5 ? float2(lit.y, lit.w) : float2(lit.x, lit.z);
    float2 right = low.x < -0.5 ? float2(lit.x, lit.z) : float2(lit.y, lit.w);
    float2 bottom = low.y > 0.5 ? float2(left.y, right.y) : float2(left.x, right.x);
    float2 top = low.y < -0.5 ? float2(left.x, right.x) : float2(left.y, right.y);
    float outside = umbrage_compare(receiver, UMBRAGE_BORDER);
    float a = umbrage_inside_map(size, texel) ? bottom.x : outside;
    float b = umbrage_inside_map(size, texel + float2(1.0, 0.0)) ? bottom.y : outside;
    float c = umbrage_inside_map(size, texel + float2(0.0, 1.0)) ? top.x : outside;
    float d = umbrage_inside_map(size, texel + float2(1.0, 1.0)) ? top.y : outside;
    return float4(a, b, c, d);
}
`,
            "hooks/lit_filtered, clamped": `
// umbrage_lit_filtered: 2x2 comparisons around a point, weighted by the sampler; a NaN is in shadow
//   coord  in texels, no NaN
float umbrage_lit_filtered(UMBRAGE_MAP map, float2 size, float2 coord, float receiver) {
    float2 texel = clamp(coord, float2(0.5, 0.5), size - 0.5);
    float2 at = texel + UMBRAGE_ORIGIN;
    float2 uv = UMBRAGE_UV;
    float lit = UMBRAGE_LIT_FILTERED;
    return umbrage_within_far_plane(receiver) ? lit : 0.0;
}
`,
            "hooks/lit_filtered, bordered": `
// umbrage_lit_filtered: 2x2 comparisons around a point, weighted by the sampler, outside the map with the far plane; a
//   NaN is in shadow
//   coord  in texels, no NaN
float umbrage_lit_filtered(UMBRAGE_MAP map, float2 size, float2 coord, float receiver) {
    float2 texel = clamp(coord, float2(0.5, 0.5), size - 0.5);
    float2 at = texel + UMBRAGE_ORIGIN;
    float2 uv = UMBRAGE_UV;
    float lit = UMBRAGE_LIT_FILTERED;
    float2 inside = clamp(min(coord, size - coord) + 0.5, float2(0.0, 0.0), float2(1.0, 1.0));
    float outside = umbrage_compare(receiver, UMBRAGE_BORDER);
    return umbrage_within_far_plane(receiver) ? outside + inside.x * inside.y * (lit - outside) : 0.0;
}
`,
            "hooks/lit_at, sampled": `
// umbrage_lit_at: 2x2 comparisons around a point, weighted by the sampler
//   uv  over the map, (0.0, 0.0) to (1.0, 1.0);   receiver  no NaN
float umbrage_lit_at(UMBRAGE_MAP map, float2 size, float2 uv, float receiver) {
    return UMBRAGE_LIT_FILTERED;
}
`,
            "hooks/lit_at, sampled and bordered": `
// umbrage_lit_at: 2x2 comparisons around a point, weighted by the sampler, outside the map with the far plane
//   uv  over the map, (0.0, 0.0) to (1.0, 1.0);   receiver  no NaN
float umbrage_lit_at(UMBRAGE_MAP map, float2 size, float2 uv, float receiver) {
    float lit = UMBRAGE_LIT_FILTERED;
    float outside = umbrage_compare(receiver, UMBRAGE_BORDER);
    float2 inside = clamp((0.5 - abs(uv - 0.5)) * size + 0.5, float2(0.0, 0.0), float2(1.0, 1.0));
    return outside + inside.x * inside.y * (lit - outside);
}
`,
            "hooks/depth_at, sampled": `
// umbrage_depth_at: stored depth of the texel at a point, by the sampler
//   uv  over the map, (0.0, 0.0) to (1.0, 1.0)
float umbrage_depth_at(UMBRAGE_MAP map, float2 size, float2 uv) {
    return umbrage_decode(UMBRAGE_SAMPLED);
}
`,
            "hooks/depth_at, sampled and bordered": `
// umbrage_depth_at: stored depth of the texel at a point, by the sampler, outside the map that of the far plane
//   uv  over the map, (0.0, 0.0) to (1.0, 1.0)
float umbrage_depth_at(UMBRAGE_MAP map, float2 size, float2 uv) {
    float depth = umbrage_decode(UMBRAGE_SAMPLED);
    return abs(uv.x - 0.5) <= 0.5 && abs(uv.y - 0.5) <= 0.5 ? depth : UMBRAGE_BORDER;
}
`,
        },
    },
    msl: {
        prelude: "\n#include <metal_stdlib>\n#pragma METAL fp math_mode(safe)\n#pragma METAL fp contract(off)\n",
        receiver_plane: "float2 receiver_slope, float2 receiver_coord",
        may_reorder: "",
        preprocessor: true,
        textures: {
            texture_2d: { parameters: "metal::texture2d<float> map", arguments: "map", texel: "map.read(uint2(at))", sampled: "map.sample(map_sampler, uv, metal::level(0.0))", lit: "", gather_red: "map.gather(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE)", gather_green: "map.gather(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, int2(0), metal::component::y)", gather_lit: "", lit_filtered: "", size: "float2(map.get_width(), map.get_height())", sampler: ", metal::sampler map_sampler", sampler_argument: ", map_sampler", needs: [] },
            atlas: { parameters: "metal::texture2d<float> map, float2 origin", arguments: "map, origin", texel: "map.read(uint2(at))", sampled: "map.sample(map_sampler, uv, metal::level(0.0))", lit: "", gather_red: "map.gather(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE)", gather_green: "map.gather(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, int2(0), metal::component::y)", gather_lit: "", lit_filtered: "", size: "float2(map.get_width(), map.get_height())", sampler: ", metal::sampler map_sampler", sampler_argument: ", map_sampler", needs: [] },
            array: { parameters: "metal::texture2d_array<float> map, float layer", arguments: "map, layer", texel: "map.read(uint2(at), uint(layer))", sampled: "map.sample(map_sampler, uv, uint(layer), metal::level(0.0))", lit: "", gather_red: "map.gather(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, uint(layer))", gather_green: "map.gather(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, uint(layer), int2(0), metal::component::y)", gather_lit: "", lit_filtered: "", size: "float2(map.get_width(), map.get_height())", sampler: ", metal::sampler map_sampler", sampler_argument: ", map_sampler", needs: [] },
            cube: { parameters: "metal::texturecube<float> map, float face", arguments: "map, face", texel: "map.read(uint2(at), uint(face))", sampled: "", lit: "", gather_red: "", gather_green: "", gather_lit: "", lit_filtered: "", size: "float2(map.get_width(), map.get_height())", sampler: "", sampler_argument: "", needs: [] },
            cube_faces: { parameters: "metal::texturecube<float> map", arguments: "map", texel: "map.read(uint2(umbrage_cube_atlas_texel(at, size.y * 0.5).x, umbrage_cube_atlas_texel(at, size.y * 0.5).y), uint(umbrage_cube_atlas_texel(at, size.y * 0.5).z))", sampled: "", lit: "", gather_red: "", gather_green: "", gather_lit: "", lit_filtered: "", size: "float2(map.get_width(), map.get_height())", sampler: "", sampler_argument: "", needs: ["cube_atlas_texel"] },
            integer: { parameters: "metal::texture2d<uint> map", arguments: "map", texel: "float4(map.read(uint2(at)))", sampled: "", lit: "", gather_red: "", gather_green: "", gather_lit: "", lit_filtered: "", size: "float2(map.get_width(), map.get_height())", sampler: "", sampler_argument: "", needs: [] },
            depth: { parameters: "metal::depth2d<float> map", arguments: "map", texel: "float4(map.read(uint2(at)))", sampled: "float4(map.sample(map_sampler, uv, metal::level(0.0)))", lit: "", gather_red: "map.gather(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE)", gather_green: "", gather_lit: "", lit_filtered: "", size: "float2(map.get_width(), map.get_height())", sampler: ", metal::sampler map_sampler", sampler_argument: ", map_sampler", needs: [] },
            depth_array: { parameters: "metal::depth2d_array<float> map, float layer", arguments: "map, layer", texel: "float4(map.read(uint2(at), uint(layer)))", sampled: "float4(map.sample(map_sampler, uv, uint(layer), metal::level(0.0)))", lit: "", gather_red: "map.gather(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, uint(layer))", gather_green: "", gather_lit: "", lit_filtered: "", size: "float2(map.get_width(), map.get_height())", sampler: ", metal::sampler map_sampler", sampler_argument: ", map_sampler", needs: [] },
            shadow: { parameters: "metal::depth2d<float> map, metal::sampler map_sampler", arguments: "map, map_sampler", texel: "", sampled: "", lit: "map.sample_compare(map_sampler, (at + 0.5) / UMBRAGE_TEXTURE_SIZE, receiver, metal::level(0.0))", gather_red: "", gather_green: "", gather_lit: "map.gather_compare(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, receiver)", lit_filtered: "map.sample_compare(map_sampler, uv, receiver, metal::level(0.0))", size: "float2(map.get_width(), map.get_height())", sampler: "", sampler_argument: "", needs: [] },
            shadow_array: { parameters: "metal::depth2d_array<float> map, metal::sampler map_sampler, float layer", arguments: "map, map_sampler, layer", texel: "", sampled: "", lit: "map.sample_compare(map_sampler, (at + 0.5) / UMBRAGE_TEXTURE_SIZE, uint(layer), receiver, metal::level(0.0))", gather_red: "", gather_green: "", gather_lit: "map.gather_compare(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, uint(layer), receiver)", lit_filtered: "map.sample_compare(map_sampler, uv, uint(layer), receiver, metal::level(0.0))", size: "float2(map.get_width(), map.get_height())", sampler: "", sampler_argument: "", needs: [] },
        },
        texts: {
            "shadow_coordinate": `
// umbrage_shadow_coordinate: texture matrix times world position; (x w, y w, depth w, w), x and y in texels
inline float4 umbrage_shadow_coordinate(metal::float4x4 m, float3 world) {
    float4 c = m[3] + m[0] * world.x + m[1] * world.y + m[2] * world.z;
    return c;
}
`,
            "tap_coordinate": `
// umbrage_tap_coordinate: coordinate, before the division by w, moved by offset texels
inline float4 umbrage_tap_coordinate(float4 coordinate, float2 offset) {
    float2 moved = float2(coordinate.x, coordinate.y) + offset * coordinate.w;
    return float4(moved.x, moved.y, coordinate.z, coordinate.w);
}
`,
            "project_coordinate": `
// umbrage_project_coordinate: (x, y) in texels and depth; for w <= 0.0 a coordinate that every filter takes as lit
inline float3 umbrage_project_coordinate(float4 coordinate) {
    float3 p = float3(coordinate.x / coordinate.w, coordinate.y / coordinate.w, coordinate.z / coordinate.w);
    return coordinate.w > 0.0 ? p : float3(65536.0, 65536.0, 0.0);
}
`,
            "cascade_by_depth": `
// umbrage_cascade_by_depth: the cascade that a distance along the camera's axis falls into, 0.0 to 3.0
//   ends  of the first three cascades, ascending
inline float umbrage_cascade_by_depth(float depth, float3 ends) {
    int reached = int(depth >= ends.x) + int(depth >= ends.y) + int(depth >= ends.z);
    return float(reached);
}
`,
            "cascade_column": `
// umbrage_cascade_column: a column of a matrix by its number, 0.0 to 3.0, for languages without dynamic indices
inline float4 umbrage_cascade_column(metal::float4x4 columns, float number) {
    float4 low = number < 0.5 ? columns[0] : columns[1];
    float4 high = number < 2.5 ? columns[2] : columns[3];
    return number < 1.5 ? low : high;
}
`,
            "cascade_column_8": `
// umbrage_cascade_column_8: a column of two matrices by its number, 0.0 to 7.0
inline float4 umbrage_cascade_column_8(metal::float4x4 nearer, metal::float4x4 farther, float number) {
    float4 low = umbrage_cascade_column(nearer, number);
    float4 high = umbrage_cascade_column(farther, number - 4.0);
    return number < 3.5 ? low : high;
}
`,
            "cascade_coordinate": `
// umbrage_cascade_coordinate: a point, rotated into the light's directions, in a cascade's map: texels and depth
inline float3 umbrage_cascade_coordinate(float3 light, float4 scale, float4 offset) {
    float3 start = float3(offset.x, offset.y, offset.z);
    float3 at = light * float3(scale.x, scale.y, scale.z) + start;
    return at;
}
`,
            "inside_cascade": `
// umbrage_inside_cascade: whether a filter of some reach around a coordinate stays inside a map of size texels
inline bool umbrage_inside_cascade(float3 coordinate, float2 size, float reach) {
    float2 end = size - reach;
    // y doubled on purpose: Mesa makes min(x, y) >= reach of two comparisons with one limit, which loses a NaN
    bool in_x = coordinate.x >= reach && coordinate.x <= end.x;
    bool in_y = coordinate.y * 2.0 >= reach * 2.0 && coordinate.y * 2.0 <= end.y * 2.0;
    return in_x && in_y && coordinate.z >= 0.0 && coordinate.z <= 1.0;
}
`,
            "cascade_by_projection": `
// umbrage_cascade_by_projection: (texels, texels, depth, number) in the first of four cascades that holds a point and
//   its filter; where none does, number 4.0 and a coordinate that every filter takes as lit
//   light            the point, rotated into the light's directions
//   scales, offsets  of the cascades;   size  of each map;   reach  of the filter, in texels
inline float4 umbrage_cascade_by_projection(float3 light, metal::float4x4 scales, metal::float4x4 offsets, float2 size,
                                            float reach) {
    float3 a = umbrage_cascade_coordinate(light, scales[0], offsets[0]);
    float3 b = umbrage_cascade_coordinate(light, scales[1], offsets[1]);
    float3 c = umbrage_cascade_coordinate(light, scales[2], offsets[2]);
    float3 d = umbrage_cascade_coordinate(light, scales[3], offsets[3]);
    float4 found = float4(65536.0, 65536.0, 0.0, 4.0);
    found = umbrage_inside_cascade(d, size, reach) ? float4(d, 3.0) : found;
    found = umbrage_inside_cascade(c, size, reach) ? float4(c, 2.0) : found;
    found = umbrage_inside_cascade(b, size, reach) ? float4(b, 1.0) : found;
    return umbrage_inside_cascade(a, size, reach) ? float4(a, 0.0) : found;
}
`,
            "cascade_by_projection_8": `
// umbrage_cascade_by_projection_8: umbrage_cascade_by_projection of eight cascades, four and four; number 8.0 for none
inline float4 umbrage_cascade_by_projection_8(float3 light, metal::float4x4 scales, metal::float4x4 offsets,
                                              metal::float4x4 farther_scales, metal::float4x4 farther_offsets,
                                              float2 size, float reach) {
    float4 nearer = umbrage_cascade_by_projection(light, scales, offsets, size, reach);
    float4 farther = umbrage_cascade_by_projection(light, farther_scales, farther_offsets, size, reach);
    return nearer.w < 3.5 ? nearer : float4(farther.x, farther.y, farther.z, farther.w + 4.0);
}
`,
            "cascade_tile": `
// umbrage_cascade_tile: first texel of a cascade, a whole number, in an atlas of tiles of size texels, two a row
inline float2 umbrage_cascade_tile(float number, float2 size) {
    float row = metal::floor(number * 0.5);
    return float2(number - row * 2.0, row) * size;
}
`,
            "cascade_weight": `
// umbrage_cascade_weight: v taken down to steps of 1/256, from 0.0 to 1.0; NaN is 0.0
inline float umbrage_cascade_weight(float v) {
    float steps = v > 0.0 && v < 1.0 ? metal::floor(v * 256.0) : (v >= 1.0 ? 256.0 : 0.0);
    return steps * (1.0 / 256.0);
}
`,
            "cascade_fade": `
// umbrage_cascade_fade: weight of the next cascade at a distance along the camera's axis; depth * scale + offset
inline float umbrage_cascade_fade(float depth, float scale, float offset) {
    float v = depth * scale + offset;
    return umbrage_cascade_weight(v);
}
`,
            "cascade_border_fade": `
// umbrage_cascade_border_fade: weight of the next cascade, 1.0 from reach texels off the border of a map on
//   coordinate, size  in texels;   per_texel  weight a texel, 1.0 / width of the band along the border
inline float umbrage_cascade_border_fade(float2 coordinate, float2 size, float reach, float per_texel) {
    float2 half_size = size * 0.5;
    float2 beyond = metal::abs(coordinate - half_size) - (half_size - reach);
    float2 v = beyond * per_texel + 1.0;
    float x = umbrage_cascade_weight(v.x);
    float y = umbrage_cascade_weight(v.y);
    return x > y ? x : y;
}
`,
            "blend_cascades": `
// umbrage_blend_cascades: visibilities of a cascade and of the next one, which counts by weight, mixed
inline float umbrage_blend_cascades(float nearer, float farther, float weight) {
    float sum = nearer + (farther - nearer) * weight;
    return weight < 1.0 ? sum : farther;
}
`,
            "inside_texel_space": `
// umbrage_inside_texel_space: coordinates in texels that a filter can take; it takes all others, NaN included, as lit
inline bool umbrage_inside_texel_space(float2 coord) {
    // two limits on purpose: Mesa makes max(x, y) < limit of one, which loses a NaN
    return metal::abs(coord.x) < 32768.0 && metal::abs(coord.y) * 2.0 < 65536.0;
}
`,
            "dither_threshold": `
// umbrage_dither_threshold: one of 16 thresholds, 1/32 to 31/32, for a position in pixels; each once in 4 x 4 pixels
inline float umbrage_dither_threshold(float2 pixel) {
    float2 whole = umbrage_inside_texel_space(pixel) ? metal::floor(pixel) : float2(0.0, 0.0);
    float2 high = metal::floor(whole * 0.5);
    float2 above = metal::floor(whole * 0.25);
    float2 b0 = whole - high * 2.0;
    float2 b1 = high - above * 2.0;
    float m = metal::abs(b0.x - b0.y) * 8.0 + b0.y * 4.0 + metal::abs(b1.x - b1.y) * 2.0 + b1.y;
    return (m + 0.5) * (1.0 / 16.0);
}
`,
            "dithered_cascade": `
// umbrage_dithered_cascade: number of a cascade, or of the next one where its weight is above the pixel's threshold
inline float umbrage_dithered_cascade(float number, float weight, float threshold) {
    return number + (weight > threshold ? 1.0 : 0.0);
}
`,
            "cube_face": `
// umbrage_cube_face: the face that a direction meets, 0.0 to 5.0: +x, -x, +y, -y, +z, -z
inline float umbrage_cube_face(float3 direction) {
    float3 m = metal::abs(direction);
    float x = direction.x < 0.0 ? 1.0 : 0.0;
    float y = direction.y < 0.0 ? 3.0 : 2.0;
    float z = direction.z < 0.0 ? 5.0 : 4.0;
    // not m.x >= m.y && m.x >= m.z, of which Mesa makes one with max(m.y, m.z), which loses a NaN
    return m.x >= m.y ? (m.x >= m.z ? x : z) : (m.y >= m.z ? y : z);
}
`,
            "cube_view_z": `
// umbrage_cube_view_z: the greatest component's magnitude, of which per-face depths are made
inline float umbrage_cube_view_z(float3 direction) {
    float face = umbrage_cube_face(direction);
    float side = face < 1.5 ? direction.x : direction.y;
    return metal::abs(face > 3.5 ? direction.z : side);
}
`,
            "cube_plane": `
// umbrage_cube_plane: (sc, tc, face) of a direction: its components to the sides of the face that it meets
inline float3 umbrage_cube_plane(float3 direction) {
    float face = umbrage_cube_face(direction);
    float3 x = float3(face < 0.5 ? -direction.z : direction.z, -direction.y, face);
    float3 y = float3(direction.x, face < 2.5 ? direction.z : -direction.z, face);
    float3 z = float3(face < 4.5 ? direction.x : -direction.x, -direction.y, face);
    return face < 1.5 ? x : (face < 3.5 ? y : z);
}
`,
            "cube_point": `
// umbrage_cube_point: from (sc, tc, distance along its axis) of a face, 0.0 to 5.0
inline float3 umbrage_cube_point(float face, float3 p) {
    float3 x = face < 0.5 ? float3(p.z, -p.y, -p.x) : float3(-p.z, -p.y, p.x);
    float3 y = face < 2.5 ? float3(p.x, p.z, p.y) : float3(p.x, -p.z, -p.y);
    float3 z = face < 4.5 ? float3(p.x, -p.y, p.z) : float3(-p.x, -p.y, -p.z);
    return face < 1.5 ? x : (face < 3.5 ? y : z);
}
`,
            "cube_face_point": `
// umbrage_cube_face_point: (sc, tc, distance along its axis) in a face, 0.0 to 5.0, of a point from the cube's middle
inline float3 umbrage_cube_face_point(float face, float3 p) {
    float3 x = face < 0.5 ? float3(-p.z, -p.y, p.x) : float3(p.z, -p.y, -p.x);
    float3 y = face < 2.5 ? float3(p.x, p.z, p.y) : float3(p.x, -p.z, -p.y);
    float3 z = face < 4.5 ? float3(p.x, -p.y, p.z) : float3(-p.x, -p.y, -p.z);
    return face < 1.5 ? x : (face < 3.5 ? y : z);
}
`,
            "cube_coordinate": `
// umbrage_cube_coordinate: (s, t, face) of a direction; s and t go from 0.0 to 1.0 over the face
inline float3 umbrage_cube_coordinate(float3 direction) {
    float3 p = umbrage_cube_plane(direction);
    float m = umbrage_cube_view_z(direction);
    return float3((p.x + m) / (m + m), (p.y + m) / (m + m), p.z);
}
`,
            "cube_direction": `
// umbrage_cube_direction: from a cube's middle to a point of a face, 0.0 to 5.0; st goes from 0.0 to 1.0 over the face
inline float3 umbrage_cube_direction(float face, float2 st) {
    float2 uv = st * 2.0 - 1.0;  // an exact product: fused or not, it rounds once
    return umbrage_cube_point(face, float3(uv, 1.0));
}
`,
            "cube_neighbor": `
// umbrage_cube_neighbor: (s, t, face) of a texel that may lie beyond an edge of its face; face -1.0 beyond a corner
//   texel  (s, t, face), whole numbers;   size  of a face, in texels
inline float3 umbrage_cube_neighbor(float3 texel, float size) {
    float2 uv = float2(texel.x, texel.y) * 2.0 + (1.0 - size);
    bool beyond_u = metal::abs(uv.x) > size;
    bool beyond_v = metal::abs(uv.y) > size;
    float m = beyond_u || beyond_v ? size - 1.0 : size;
    float3 p = umbrage_cube_plane(umbrage_cube_point(texel.z, float3(uv, m)));
    float2 inside = (float2(p.x, p.y) + (size - 1.0)) * 0.5;
    return beyond_u && beyond_v ? float3(0.0, 0.0, -1.0) : float3(inside, p.z);
}
`,
            "cube_tile": `
// umbrage_cube_tile: first texel of a face, 0.0 to 5.0, in an atlas of 3 x 2 tiles of size texels
inline float2 umbrage_cube_tile(float face, float size) {
    float row = face < 2.5 ? 0.0 : 1.0;
    return float2((face - row * 3.0) * size, row * size);
}
`,
            "cube_atlas_texel": `
// umbrage_cube_atlas_texel: (s, t, face) of a texel of an atlas of 3 x 2 tiles of size texels; whole numbers
inline float3 umbrage_cube_atlas_texel(float2 texel, float size) {
    float column = texel.x < size ? 0.0 : (texel.x < size * 2.0 ? 1.0 : 2.0);
    float row = texel.y < size ? 0.0 : 1.0;
    return float3(texel - float2(column, row) * size, column + row * 3.0);
}
`,
            "cube_atlas_direction": `
// umbrage_cube_atlas_direction: from a cube's middle to that of a texel of an atlas of 3 x 2 tiles of size texels
inline float3 umbrage_cube_atlas_direction(float2 texel, float size) {
    float3 part = umbrage_cube_atlas_texel(texel, size);
    float2 uv = float2(part.x, part.y) * 2.0 + (1.0 - size);
    return umbrage_cube_point(part.z, float3(uv, size));
}
`,
            "dual_paraboloid_coordinate": `
// umbrage_dual_paraboloid_coordinate: (s, t, map) of a direction: 0.0 to 1.0 over the map's square, map 0.0 or 1.0
inline float3 umbrage_dual_paraboloid_coordinate(float3 direction) {
    float square = direction.x * direction.x + direction.y * direction.y + direction.z * direction.z;
    bool behind = direction.z < 0.0;
    float m = metal::sqrt(square) + (behind ? -direction.z : direction.z);
    float x = behind ? direction.x : -direction.x;
    return float3((x + m) / (m + m), (direction.y + m) / (m + m), behind ? 1.0 : 0.0);
}
`,
            "dual_paraboloid_position": `
// umbrage_dual_paraboloid_position: (x w, y w, distance w, w) of a vertex, for the depth pass' projection
//   direction  from the light to the vertex;   map  0.0 or 1.0
inline float4 umbrage_dual_paraboloid_position(float3 direction, float map) {
    bool behind = map > 0.5;
    float square = direction.x * direction.x + direction.y * direction.y + direction.z * direction.z;
    float distance_to = metal::sqrt(square);
    float w = distance_to + (behind ? -direction.z : direction.z);
    return float4(behind ? direction.x : -direction.x, direction.y, distance_to * w, w);
}
`,
            "tetrahedron_face": `
// umbrage_tetrahedron_face: the face that a direction meets, 0.0 to 3.0: down and +z, down and -z, up and +x, up and -x
inline float umbrage_tetrahedron_face(float3 direction) {
    float beside = metal::abs(direction.z) - metal::abs(direction.x);
    float up = direction.y * 1.414213562;
    float z = direction.z < 0.0 ? 1.0 : 0.0;
    float x = direction.x < 0.0 ? 3.0 : 2.0;
    return beside >= up ? z : x;
}
`,
            "tetrahedron_face_point": `
// umbrage_tetrahedron_face_point: (along the base, up, away) of a direction in the axes of a face, 0.0 to 3.0
inline float3 umbrage_tetrahedron_face_point(float face, float3 d) {
    float3 z = face < 0.5 ? float3(-d.x, d.y, d.z) : float3(d.x, d.y, -d.z);
    float3 x = face < 2.5 ? float3(-d.z, -d.y, d.x) : float3(d.z, -d.y, -d.x);
    return face < 1.5 ? z : x;
}
`,
            "tetrahedron_plane": `
// umbrage_tetrahedron_plane: (along the base, up, away) of a direction in the axes of the face that it meets
inline float3 umbrage_tetrahedron_plane(float3 direction) {
    return umbrage_tetrahedron_face_point(umbrage_tetrahedron_face(direction), direction);
}
`,
            "tetrahedron_view_z": `
// umbrage_tetrahedron_view_z: distance along the face's normal, of which per-face depths are made
inline float umbrage_tetrahedron_view_z(float3 direction) {
    float3 p = umbrage_tetrahedron_plane(direction);
    float z = p.z * 0.816496581 + p.y * -0.577350269;
    return z;
}
`,
            "tetrahedron_coordinate": `
// umbrage_tetrahedron_coordinate: (s, t, face) of a direction: -1.0 to 1.0 along the base, 0.0 at it to 1.0 at the apex
inline float3 umbrage_tetrahedron_coordinate(float3 direction) {
    float3 p = umbrage_tetrahedron_plane(direction);
    float d = p.z * 2.0 + p.y * -1.414213562;
    return float3(p.x / d, p.z / d, umbrage_tetrahedron_face(direction));
}
`,
            "tetrahedron_turned": `
// umbrage_tetrahedron_turned: a vector of face 0's side of the map on that of a face, 0.0 to 3.0
inline float2 umbrage_tetrahedron_turned(float face, float2 v) {
    float2 z = face < 0.5 ? v : float2(-v.x, -v.y);
    float2 x = face < 2.5 ? float2(-v.y, v.x) : float2(v.y, -v.x);
    return face < 1.5 ? z : x;
}
`,
            "tetrahedron_texel": `
// umbrage_tetrahedron_texel: texels of a square map, from (s, t, face) on a tetrahedron
//   size  of the map, in texels;   border  along the sides of each triangle, in texels
inline float2 umbrage_tetrahedron_texel(float3 at, float size, float border) {
    float half_size = size * 0.5;
    float scale = half_size - border * 3.0;
    float x = at.x * scale;
    float y = at.y * scale + (border - half_size);
    float2 texel = umbrage_tetrahedron_turned(at.z, float2(x, y)) + half_size;
    return texel;
}
`,
            "tetrahedron_face_of": `
// umbrage_tetrahedron_face_of: the face, 0.0 to 3.0, whose triangle in a map of size texels a texel lies in
inline float umbrage_tetrahedron_face_of(float2 texel, float size) {
    float2 off = texel * 2.0 + (1.0 - size);
    float column = off.y < 0.0 ? 0.0 : 1.0;
    float row = off.x < 0.0 ? 3.0 : 2.0;
    return metal::abs(off.y) >= metal::abs(off.x) ? column : row;
}
`,
            "pancake": `
// umbrage_pancake: a clip space position, moved onto the near plane where it lies before it
//   at_near  z/w of the near plane: 0.0 or -1.0, or 1.0 for reversed depth
inline float4 umbrage_pancake(float4 position, float at_near) {
    float plane = at_near * position.w;
    bool before = at_near > 0.5 ? position.z > plane : position.z < plane;
    return float4(position.x, position.y, before ? plane : position.z, position.w);
}
`,
            "texel": `
// umbrage_texel: value of a texel inside the map
//   map    where its texels lie; a sampler that reads them filters by nearest
//   size   of the map in texels;   texel  whole numbers, (0, 0) is the first
inline float4 umbrage_texel(UMBRAGE_MAP map, float2 size, float2 texel) {
    float2 at = texel + UMBRAGE_ORIGIN;
    return UMBRAGE_TEXEL;
}
`,
            "from_unorm": `
// umbrage_from_unorm: channel 0..255 behind a value read from an 8-bit texture, however the driver divides by 255
inline float umbrage_from_unorm(float c) {
    return metal::floor(c * 255.0 + 0.5);
}
inline float2 umbrage_from_unorm(float2 c) {
    return metal::floor(c * 255.0 + 0.5);
}
inline float3 umbrage_from_unorm(float3 c) {
    return metal::floor(c * 255.0 + 0.5);
}
inline float4 umbrage_from_unorm(float4 c) {
    return metal::floor(c * 255.0 + 0.5);
}
`,
            "page_coordinate": `
// umbrage_page_coordinate: a receiver in a page of an atlas: texels of the page with its gutter, the page's first texel
//   table, size   page table, RGBA8, nearest filter;   coord   receiver, from 1.0 to 2.0 across all but its border
//   page, gutter  side of a page and what it has around it, texels
inline float4 umbrage_page_coordinate(UMBRAGE_MAP table, float2 size, float2 coord, float page, float gutter) {
    // not negative already; compilers cannot regroup sums across max and clamp
    float2 sides = metal::max(size - 2.0, float2(1.0, 1.0));
    float2 before = metal::max(size - 3.0, float2(0.0, 0.0));
    float2 cell = metal::min(metal::max(float2(0.0, 0.0), coord * sides - before), size - 1.0);
    int2 texel = int2(cell);  // of a NaN the first
    float4 entry = umbrage_from_unorm(umbrage_texel(table, size, float2(texel)));
    float2 slot = float2(entry.x, entry.y);
    float across = entry.z + entry.w * 256.0;
    float2 within = metal::clamp(metal::fract(coord * across), float2(0.0, 0.0), float2(1.0, 1.0));
    float2 at = within * page + (across > 0.0 ? gutter : 32768.0);
    return float4(at, slot * (page + gutter * 2.0));
}
`,
            "linear_depth": `
// umbrage_linear_depth: distance along the light's axis, positive in front of it, times 1 / z_far
inline float umbrage_linear_depth(float z_view, float inv_z_far) {
    return z_view * inv_z_far;
}
`,
            "project_depth": `
// umbrage_project_depth: z / w; for w <= 0.0 cleared, which is 1.0, or 0.0 when reversed
inline float umbrage_project_depth(float z, float w, float cleared) {
    return w > 0.0 ? z / w : cleared;
}
`,
            "distance_depth": `
// umbrage_distance_depth: length of to_point, from the light, times 1 / range
inline float umbrage_distance_depth(float3 to_point, float inv_range) {
    return metal::sqrt(to_point.x * to_point.x + to_point.y * to_point.y + to_point.z * to_point.z) * inv_range;
}
`,
            "reverse_depth": `
// umbrage_reverse_depth: forward depth from reversed, or reversed from forward
inline float umbrage_reverse_depth(float depth) {
    return 1.0 - depth;
}
`,
            "depth_from_ndc": `
// umbrage_depth_from_ndc: depth in [0, 1] from z/w in [-1, 1]
inline float umbrage_depth_from_ndc(float ndc) {
    float depth = ndc * 0.5 + 0.5;
    return depth;
}
`,
            "view_z_from_depth": `
// umbrage_view_z_from_depth: perspective depth in [0, 1], 0.0 at z_near, to distance along the light's axis
inline float umbrage_view_z_from_depth(float depth, float z_near, float z_far) {
    return z_near / (1.0 - depth * (1.0 - z_near / z_far));
}
`,
            "depth_from_view_z": `
// umbrage_depth_from_view_z: distance along the light's axis to perspective depth in [0, 1], 0.0 at z_near
inline float umbrage_depth_from_view_z(float z_view, float z_near, float z_far) {
    return (1.0 - z_near / z_view) / (1.0 - z_near / z_far);
}
`,
            "view_z_from_reversed_depth": `
// umbrage_view_z_from_reversed_depth: perspective depth in [0, 1], 1.0 at z_near, to distance along the light's axis
inline float umbrage_view_z_from_reversed_depth(float depth, float z_near, float z_far) {
    return z_near / (z_near / z_far + depth * (1.0 - z_near / z_far));
}
`,
            "reversed_depth_from_view_z": `
// umbrage_reversed_depth_from_view_z: distance along the light's axis to perspective depth in [0, 1], 1.0 at z_near
inline float umbrage_reversed_depth_from_view_z(float z_view, float z_near, float z_far) {
    return z_near / z_view * (1.0 - z_view / z_far) / (1.0 - z_near / z_far);
}
`,
            "view_z_from_orthographic_depth": `
// umbrage_view_z_from_orthographic_depth: orthographic depth in [0, 1], 0.0 at z_near, to distance along the light's
// axis; when reversed, exchange z_near and z_far
inline float umbrage_view_z_from_orthographic_depth(float depth, float z_near, float z_far) {
    float z_view = z_near + depth * (z_far - z_near);
    return z_view;
}
`,
            "orthographic_depth_from_view_z": `
// umbrage_orthographic_depth_from_view_z: distance along the light's axis to orthographic depth in [0, 1], 0.0 at
// z_near; when reversed, exchange z_near and z_far
inline float umbrage_orthographic_depth_from_view_z(float z_view, float z_near, float z_far) {
    return (z_view - z_near) / (z_far - z_near);
}
`,
            "cleared_depth": `
// umbrage_cleared_depth: depth of the far plane
inline float umbrage_cleared_depth() {
    return 1.0;
}
`,
            "saturate": `
// umbrage_saturate: v clamped to [0, 1]; NaN becomes the far plane's depth
inline float umbrage_saturate(float v) {
    // not v > 0.0 ? v : 0.0, of which Mesa makes max(v, 0.0): softpipe's gives NaN for a signalling one
    return v > 0.0 && v < 1.0 ? v : (v >= 1.0 ? 1.0 : (v <= 0.0 ? 0.0 : umbrage_cleared_depth()));
}
`,
            "correct_quotient": `
// umbrage_correct_quotient: floor(a / b) from q, at most one off;  whole numbers, a below 2^24, b from 1 to 2^24
inline float umbrage_correct_quotient(float q, float a, float b) {
    float more = q + 1.0;
    float known = more * b <= a ? more : q;
    return q * b > a ? q - 1.0 : known;
}
`,
            "floor_divide": `
// umbrage_floor_divide: floor(a / b) of whole numbers, a below 2^24, b from 1 to 2^24, the quotient at most 2^18
inline float umbrage_floor_divide(float a, float b) {
    return umbrage_correct_quotient(metal::floor(a / b), a, b);
}
`,
            "to_unorm": `
// umbrage_to_unorm: what to write so that an 8-bit target stores channel k, whether it rounds or truncates
// k * 257 / 65536 + 64 / 65536; not written so, since 65536.0 is infinite in mediump
inline float umbrage_to_unorm(float k) {
    return k * 0.0039215087890625 + 0.0009765625;
}
inline float2 umbrage_to_unorm(float2 k) {
    return k * 0.0039215087890625 + 0.0009765625;
}
inline float3 umbrage_to_unorm(float3 k) {
    return k * 0.0039215087890625 + 0.0009765625;
}
inline float4 umbrage_to_unorm(float4 k) {
    return k * 0.0039215087890625 + 0.0009765625;
}
`,
            "to_unorm10": `
// umbrage_to_unorm10: what to write so that a 10-bit target stores channel k, whether it rounds or truncates
// k * 4099 / 4194304 + 1056 / 4194304
inline float umbrage_to_unorm10(float k) {
    return k * 0.0009772777557373046875 + 0.00025177001953125;
}
inline float2 umbrage_to_unorm10(float2 k) {
    return k * 0.0009772777557373046875 + 0.00025177001953125;
}
inline float3 umbrage_to_unorm10(float3 k) {
    return k * 0.0009772777557373046875 + 0.00025177001953125;
}
inline float4 umbrage_to_unorm10(float4 k) {
    return k * 0.0009772777557373046875 + 0.00025177001953125;
}
`,
            "from_unorm10": `
// umbrage_from_unorm10: channel 0..1023 behind a value read from a 10-bit texture, however the driver divides by 1023
inline float umbrage_from_unorm10(float c) {
    return metal::floor(c * 1023.0 + 0.5);
}
inline float2 umbrage_from_unorm10(float2 c) {
    return metal::floor(c * 1023.0 + 0.5);
}
inline float3 umbrage_from_unorm10(float3 c) {
    return metal::floor(c * 1023.0 + 0.5);
}
inline float4 umbrage_from_unorm10(float4 c) {
    return metal::floor(c * 1023.0 + 0.5);
}
`,
            "to_unorm16": `
// umbrage_to_unorm16: what to write so that a 16-bit target stores channel k, whether it rounds or truncates
inline float umbrage_to_unorm16(float k) {
    return metal::min(k + (metal::floor(k * (1.0 / 256.0)) * (1.0 / 256.0) + 0.25), 65536.0) * (1.0 / 65536.0);
}
inline float2 umbrage_to_unorm16(float2 k) {
    return metal::min(k + (metal::floor(k * (1.0 / 256.0)) * (1.0 / 256.0) + 0.25), 65536.0) * (1.0 / 65536.0);
}
inline float3 umbrage_to_unorm16(float3 k) {
    return metal::min(k + (metal::floor(k * (1.0 / 256.0)) * (1.0 / 256.0) + 0.25), 65536.0) * (1.0 / 65536.0);
}
inline float4 umbrage_to_unorm16(float4 k) {
    return metal::min(k + (metal::floor(k * (1.0 / 256.0)) * (1.0 / 256.0) + 0.25), 65536.0) * (1.0 / 65536.0);
}
`,
            "from_unorm16": `
// umbrage_from_unorm16: channel 0..65535 behind a value read from a 16-bit texture, however the driver divides by 65535
inline float umbrage_from_unorm16(float c) {
    return metal::floor(c * 65535.0 + 0.5);
}
inline float2 umbrage_from_unorm16(float2 c) {
    return metal::floor(c * 65535.0 + 0.5);
}
inline float3 umbrage_from_unorm16(float3 c) {
    return metal::floor(c * 65535.0 + 0.5);
}
inline float4 umbrage_from_unorm16(float4 c) {
    return metal::floor(c * 65535.0 + 0.5);
}
`,
            "encode_rg9": `
// umbrage_encode_rg9: depth to the two channels of a 9-bit code, whole numbers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1], NaN counts as far
inline float2 umbrage_encode_rg9(float depth) {
    float x = metal::min(metal::floor(umbrage_saturate(depth) * 512.0), 511.0);
    float high = metal::floor(x * (1.0 / 256.0));
    return float2(x - high * 256.0, high * 128.0);
}
`,
            "encode_rg10": `
// umbrage_encode_rg10: depth to the two channels of a 10-bit code, whole numbers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1], NaN counts as far
inline float2 umbrage_encode_rg10(float depth) {
    float x = metal::min(metal::floor(umbrage_saturate(depth) * 1024.0), 1023.0);
    float high = metal::floor(x * (1.0 / 256.0));
    return float2(x - high * 256.0, high * 64.0);
}
`,
            "encode_rg11": `
// umbrage_encode_rg11: depth to the two channels of a 11-bit code, whole numbers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1], NaN counts as far
inline float2 umbrage_encode_rg11(float depth) {
    float x = metal::min(metal::floor(umbrage_saturate(depth) * 2048.0), 2047.0);
    float high = metal::floor(x * (1.0 / 256.0));
    return float2(x - high * 256.0, high * 32.0);
}
`,
            "encode_rg12": `
// umbrage_encode_rg12: depth to the two channels of a 12-bit code, whole numbers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1], NaN counts as far
inline float2 umbrage_encode_rg12(float depth) {
    float x = metal::min(metal::floor(umbrage_saturate(depth) * 4096.0), 4095.0);
    float high = metal::floor(x * (1.0 / 256.0));
    return float2(x - high * 256.0, high * 16.0);
}
`,
            "encode_rg13": `
// umbrage_encode_rg13: depth to the two channels of a 13-bit code, whole numbers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1], NaN counts as far
inline float2 umbrage_encode_rg13(float depth) {
    float x = metal::min(metal::floor(umbrage_saturate(depth) * 8192.0), 8191.0);
    float high = metal::floor(x * (1.0 / 256.0));
    return float2(x - high * 256.0, high * 8.0);
}
`,
            "encode_rg14": `
// umbrage_encode_rg14: depth to the two channels of a 14-bit code, whole numbers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1], NaN counts as far
inline float2 umbrage_encode_rg14(float depth) {
    float x = metal::min(metal::floor(umbrage_saturate(depth) * 16384.0), 16383.0);
    float high = metal::floor(x * (1.0 / 256.0));
    return float2(x - high * 256.0, high * 4.0);
}
`,
            "encode_rg15": `
// umbrage_encode_rg15: depth to the two channels of a 15-bit code, whole numbers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1], NaN counts as far
inline float2 umbrage_encode_rg15(float depth) {
    float x = metal::min(metal::floor(umbrage_saturate(depth) * 32768.0), 32767.0);
    float high = metal::floor(x * (1.0 / 256.0));
    return float2(x - high * 256.0, high * 2.0);
}
`,
            "encode_rg16": `
// umbrage_encode_rg16: depth to the two channels of a 16-bit code, whole numbers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1], NaN counts as far
inline float2 umbrage_encode_rg16(float depth) {
    float x = metal::min(metal::floor(umbrage_saturate(depth) * 65536.0), 65535.0);
    float high = metal::floor(x * (1.0 / 256.0));
    return float2(x - high * 256.0, high * 1.0);
}
`,
            "encode_rgb24": `
// umbrage_encode_rgb24: depth to three channels, R most significant, whole numbers 0..255 for umbrage_to_unorm
//   depth   clamped to [0, 1], NaN counts as far
inline float3 umbrage_encode_rgb24(float depth) {
    float x = metal::min(metal::floor(umbrage_saturate(depth) * 16777216.0), 16777215.0);
    float high = metal::floor(x * (1.0 / 65536.0));
    float rest = x - high * 65536.0;
    float middle = metal::floor(rest * (1.0 / 256.0));
    return float3(high, middle, metal::min(rest - middle * 256.0, 255.0));  // below already: no sum is regrouped across the min
}
`,
            "encode_rgb10": `
// umbrage_encode_rgb10: depth to three channels, R most significant, whole numbers 0..1023 for umbrage_to_unorm10
// the last four bits are the high ones of B, so that a target cleared to white is at the far plane
//   depth   clamped to [0, 1], NaN counts as far
inline float3 umbrage_encode_rgb10(float depth) {
    float x = metal::min(metal::floor(umbrage_saturate(depth) * 16777216.0), 16777215.0);
    float high = metal::floor(x * (1.0 / 16384.0));
    float rest = x - high * 16384.0;
    float middle = metal::floor(rest * (1.0 / 16.0));
    float low = metal::min(rest - middle * 16.0, 15.0);  // below already: no sum is regrouped across the min
    return float3(high, middle, low * 64.0);
}
`,
            "encode_r16": `
// umbrage_encode_r16: depth to one channel, a whole number 0..65535 for umbrage_to_unorm16
//   depth   clamped to [0, 1], NaN counts as far
inline float umbrage_encode_r16(float depth) {
    return metal::min(metal::floor(umbrage_saturate(depth) * 65536.0), 65535.0);
}
`,
            "encode_float_bits": `
// umbrage_encode_float_bits: bit pattern of v as four channels, R least significant, whole numbers 0..255
inline float4 umbrage_encode_float_bits(float v) {
    uint bits = as_type<uint>(v);
    return float4(float(bits & 255u), float((bits >> 8) & 255u), float((bits >> 16) & 255u), float(bits >> 24));
}
`,
            "write_threejs_rgba": `
// umbrage_write_threejs_rgba: depth to the RGBA format of three.js r167 and later, values to write as they are
inline float4 umbrage_write_threejs_rgba(float depth) {
    float v = umbrage_saturate(depth);
    float x = v * 16777216.0;
    float whole = metal::floor(x);
    float high = metal::floor(whole * (1.0 / 65536.0));
    float rest = whole - high * 65536.0;
    float middle = metal::floor(rest * (1.0 / 256.0));
    float low = rest - middle * 256.0;
    float4 c = float4(high * 0.00392156886, middle * 0.00392156886, low * 0.00392156886, x - whole);
    return v < 1.0 ? c : float4(1.0, 1.0, 1.0, 1.0);
}
`,
            "write_threejs_rgb": `
// umbrage_write_threejs_rgb: depth to the RGB format of three.js r167 and later, values to write as they are
inline float3 umbrage_write_threejs_rgb(float depth) {
    float v = umbrage_saturate(depth);
    float x = v * 65536.0;
    float whole = metal::floor(x);
    float high = metal::floor(whole * (1.0 / 256.0));
    float3 c = float3(high * 0.00392156886, (whole - high * 256.0) * 0.00392156886, x - whole);
    return v < 1.0 ? c : float3(1.0, 1.0, 1.0);
}
`,
            "write_threejs_rg": `
// umbrage_write_threejs_rg: depth to the RG format of three.js r167 and later, values to write as they are
inline float2 umbrage_write_threejs_rg(float depth) {
    float v = umbrage_saturate(depth);
    float x = v * 256.0;
    float whole = metal::floor(x);
    return v < 1.0 ? float2(whole * 0.00392156886, x - whole) : float2(1.0, 1.0);
}
`,
            "write_threejs_legacy": `
// umbrage_write_threejs_legacy: depth to the RGBA format of three.js r73 to r166, values to write as they are;
//   1.0 reads back as 255/256: umbrage_encode_threejs_legacy_repaired does not
inline float4 umbrage_write_threejs_legacy(float depth) {
    float v = umbrage_saturate(depth);
    float x = v * 16777216.0 - metal::floor(v * 16777216.0);
    float y = v * 65536.0 - metal::floor(v * 65536.0);
    float z = v * 256.0 - metal::floor(v * 256.0);
    float4 c = float4(x, y - x * (1.0 / 256.0), z - y * (1.0 / 256.0), v - z * (1.0 / 256.0));
    return c * 1.00392163;
}
`,
            "encode_threejs_legacy_repaired": `
// umbrage_encode_threejs_legacy_repaired: depth to channels that readers of three.js r73 to r166 decode, 1.0 to 1.0;
//   whole numbers 0..255 (umbrage_to_unorm writes them)
inline float4 umbrage_encode_threejs_legacy_repaired(float depth) {
    float v = umbrage_saturate(depth);
    float x = metal::floor(v * 16777216.0);
    float high = metal::floor(x * (1.0 / 65536.0));
    float rest = x - high * 65536.0;
    float middle = metal::floor(rest * (1.0 / 256.0));
    float low = metal::min(rest - middle * 256.0, 255.0);  // below already: no sum is regrouped across the min
    return v < 1.0 ? float4(0.0, low, middle, high) : float4(255.0, 255.0, 255.0, 255.0);
}
`,
            "write_base255": `
// umbrage_write_base255: depth to base-255 RGBA, values to write as they are; 1.0 reads back as 0.0, and the store must
//   round: umbrage_encode_base255_repaired has neither fault
inline float4 umbrage_write_base255(float depth) {
    float v = umbrage_saturate(depth);
    float4 e = float4(v, v * 255.0, v * 65025.0, v * 16581375.0);
    e = e - metal::floor(e);
    float4 c = float4(e.x - e.y * 0.00392156886, e.y - e.z * 0.00392156886, e.z - e.w * 0.00392156886, e.w);
    return c;
}
`,
            "encode_base255_repaired": `
// umbrage_encode_base255_repaired: depth to channels that readers of base-255 RGBA decode, 1.0 to 1.0;
//   whole numbers 0..255 (umbrage_to_unorm writes them)
inline float4 umbrage_encode_base255_repaired(float depth) {
    float x = umbrage_saturate(depth) * 255.0;
    float y = (x - metal::floor(x)) * 255.0;
    float z = (y - metal::floor(y)) * 255.0;
    float w = (z - metal::floor(z)) * 255.0;
    return float4(metal::floor(x), metal::floor(y), metal::floor(z), metal::floor(w));
}
`,
            "fetch_clamped": `
// umbrage_fetch_clamped: texel of a map; coordinates outside move to the nearest texel inside
inline float4 umbrage_fetch_clamped(UMBRAGE_MAP map, float2 size, float2 texel) {
    return umbrage_texel(map, size, metal::clamp(texel, float2(0.0, 0.0), size - 1.0));
}
`,
            "encode_rg9_table": `
// umbrage_encode_rg9_table: depth to the two channels of a 9-bit code through a look-up table, whole numbers 0..255
//   table   512 x 1 texels, row after row, nearest filter;   depth   clamped to [0, 1], NaN counts as far
inline float2 umbrage_encode_rg9_table(UMBRAGE_MAP table, float depth) {
    float x = metal::min(metal::floor(umbrage_saturate(depth) * 512.0), 511.0);
    float row = metal::floor(x * (1.0 / 512.0));
    float2 texel = float2(x - row * 512.0, row);
    float4 k = umbrage_from_unorm(umbrage_fetch_clamped(table, float2(512.0, 1.0), texel));
    return float2(k.x, k.y);
}
`,
            "encode_rg10_table": `
// umbrage_encode_rg10_table: depth to the two channels of a 10-bit code through a look-up table, whole numbers 0..255
//   table   1024 x 1 texels, row after row, nearest filter;   depth   clamped to [0, 1], NaN counts as far
inline float2 umbrage_encode_rg10_table(UMBRAGE_MAP table, float depth) {
    float x = metal::min(metal::floor(umbrage_saturate(depth) * 1024.0), 1023.0);
    float row = metal::floor(x * (1.0 / 1024.0));
    float2 texel = float2(x - row * 1024.0, row);
    float4 k = umbrage_from_unorm(umbrage_fetch_clamped(table, float2(1024.0, 1.0), texel));
    return float2(k.x, k.y);
}
`,
            "encode_rg11_table": `
// umbrage_encode_rg11_table: depth to the two channels of a 11-bit code through a look-up table, whole numbers 0..255
//   table   2048 x 1 texels, row after row, nearest filter;   depth   clamped to [0, 1], NaN counts as far
inline float2 umbrage_encode_rg11_table(UMBRAGE_MAP table, float depth) {
    float x = metal::min(metal::floor(umbrage_saturate(depth) * 2048.0), 2047.0);
    float row = metal::floor(x * (1.0 / 2048.0));
    float2 texel = float2(x - row * 2048.0, row);
    float4 k = umbrage_from_unorm(umbrage_fetch_clamped(table, float2(2048.0, 1.0), texel));
    return float2(k.x, k.y);
}
`,
            "encode_rg12_table": `
// umbrage_encode_rg12_table: depth to the two channels of a 12-bit code through a look-up table, whole numbers 0..255
//   table   2048 x 2 texels, row after row, nearest filter;   depth   clamped to [0, 1], NaN counts as far
inline float2 umbrage_encode_rg12_table(UMBRAGE_MAP table, float depth) {
    float x = metal::min(metal::floor(umbrage_saturate(depth) * 4096.0), 4095.0);
    float row = metal::floor(x * (1.0 / 2048.0));
    float2 texel = float2(x - row * 2048.0, row);
    float4 k = umbrage_from_unorm(umbrage_fetch_clamped(table, float2(2048.0, 2.0), texel));
    return float2(k.x, k.y);
}
`,
            "encode_rg13_table": `
// umbrage_encode_rg13_table: depth to the two channels of a 13-bit code through a look-up table, whole numbers 0..255
//   table   2048 x 4 texels, row after row, nearest filter;   depth   clamped to [0, 1], NaN counts as far
inline float2 umbrage_encode_rg13_table(UMBRAGE_MAP table, float depth) {
    float x = metal::min(metal::floor(umbrage_saturate(depth) * 8192.0), 8191.0);
    float row = metal::floor(x * (1.0 / 2048.0));
    float2 texel = float2(x - row * 2048.0, row);
    float4 k = umbrage_from_unorm(umbrage_fetch_clamped(table, float2(2048.0, 4.0), texel));
    return float2(k.x, k.y);
}
`,
            "encode_rg14_table": `
// umbrage_encode_rg14_table: depth to the two channels of a 14-bit code through a look-up table, whole numbers 0..255
//   table   2048 x 8 texels, row after row, nearest filter;   depth   clamped to [0, 1], NaN counts as far
inline float2 umbrage_encode_rg14_table(UMBRAGE_MAP table, float depth) {
    float x = metal::min(metal::floor(umbrage_saturate(depth) * 16384.0), 16383.0);
    float row = metal::floor(x * (1.0 / 2048.0));
    float2 texel = float2(x - row * 2048.0, row);
    float4 k = umbrage_from_unorm(umbrage_fetch_clamped(table, float2(2048.0, 8.0), texel));
    return float2(k.x, k.y);
}
`,
            "encode_rg15_table": `
// umbrage_encode_rg15_table: depth to the two channels of a 15-bit code through a look-up table, whole numbers 0..255
//   table   2048 x 16 texels, row after row, nearest filter;   depth   clamped to [0, 1], NaN counts as far
inline float2 umbrage_encode_rg15_table(UMBRAGE_MAP table, float depth) {
    float x = metal::min(metal::floor(umbrage_saturate(depth) * 32768.0), 32767.0);
    float row = metal::floor(x * (1.0 / 2048.0));
    float2 texel = float2(x - row * 2048.0, row);
    float4 k = umbrage_from_unorm(umbrage_fetch_clamped(table, float2(2048.0, 16.0), texel));
    return float2(k.x, k.y);
}
`,
            "encode_rg16_table": `
// umbrage_encode_rg16_table: depth to the two channels of a 16-bit code through a look-up table, whole numbers 0..255
//   table   2048 x 32 texels, row after row, nearest filter;   depth   clamped to [0, 1], NaN counts as far
inline float2 umbrage_encode_rg16_table(UMBRAGE_MAP table, float depth) {
    float x = metal::min(metal::floor(umbrage_saturate(depth) * 65536.0), 65535.0);
    float row = metal::floor(x * (1.0 / 2048.0));
    float2 texel = float2(x - row * 2048.0, row);
    float4 k = umbrage_from_unorm(umbrage_fetch_clamped(table, float2(2048.0, 32.0), texel));
    return float2(k.x, k.y);
}
`,
            "decode_rg9": `
// umbrage_decode_rg9: two channels of a 9-bit code, as sampled, to depth
//   edge   0.0, 0.5, 1.0: lower edge, center, upper edge of the code's interval
inline float umbrage_decode_rg9(float2 c, float edge) {
    float2 k = umbrage_from_unorm(c);
    return (k.x + k.y * 2.0 + edge) * (1.0 / 512.0);
}
`,
            "decode_rg10": `
// umbrage_decode_rg10: two channels of a 10-bit code, as sampled, to depth
//   edge   0.0, 0.5, 1.0: lower edge, center, upper edge of the code's interval
inline float umbrage_decode_rg10(float2 c, float edge) {
    float2 k = umbrage_from_unorm(c);
    return (k.x + k.y * 4.0 + edge) * (1.0 / 1024.0);
}
`,
            "decode_rg11": `
// umbrage_decode_rg11: two channels of a 11-bit code, as sampled, to depth
//   edge   0.0, 0.5, 1.0: lower edge, center, upper edge of the code's interval
inline float umbrage_decode_rg11(float2 c, float edge) {
    float2 k = umbrage_from_unorm(c);
    return (k.x + k.y * 8.0 + edge) * (1.0 / 2048.0);
}
`,
            "decode_rg12": `
// umbrage_decode_rg12: two channels of a 12-bit code, as sampled, to depth
//   edge   0.0, 0.5, 1.0: lower edge, center, upper edge of the code's interval
inline float umbrage_decode_rg12(float2 c, float edge) {
    float2 k = umbrage_from_unorm(c);
    return (k.x + k.y * 16.0 + edge) * (1.0 / 4096.0);
}
`,
            "decode_rg13": `
// umbrage_decode_rg13: two channels of a 13-bit code, as sampled, to depth
//   edge   0.0, 0.5, 1.0: lower edge, center, upper edge of the code's interval
inline float umbrage_decode_rg13(float2 c, float edge) {
    float2 k = umbrage_from_unorm(c);
    return (k.x + k.y * 32.0 + edge) * (1.0 / 8192.0);
}
`,
            "decode_rg14": `
// umbrage_decode_rg14: two channels of a 14-bit code, as sampled, to depth
//   edge   0.0, 0.5, 1.0: lower edge, center, upper edge of the code's interval
inline float umbrage_decode_rg14(float2 c, float edge) {
    float2 k = umbrage_from_unorm(c);
    return (k.x + k.y * 64.0 + edge) * (1.0 / 16384.0);
}
`,
            "decode_rg15": `
// umbrage_decode_rg15: two channels of a 15-bit code, as sampled, to depth
//   edge   0.0, 0.5, 1.0: lower edge, center, upper edge of the code's interval
inline float umbrage_decode_rg15(float2 c, float edge) {
    float2 k = umbrage_from_unorm(c);
    return (k.x + k.y * 128.0 + edge) * (1.0 / 32768.0);
}
`,
            "decode_rg16": `
// umbrage_decode_rg16: two channels of a 16-bit code, as sampled, to depth
//   edge   0.0, 0.5, 1.0: lower edge, center, upper edge of the code's interval
inline float umbrage_decode_rg16(float2 c, float edge) {
    float2 k = umbrage_from_unorm(c);
    return (k.x + k.y * 256.0 + edge) * (1.0 / 65536.0);
}
`,
            "decode_rgb24": `
// umbrage_decode_rgb24: three channels, as sampled, to depth
//   edge   0.0 or 1.0: lower or upper edge of the code's interval
inline float umbrage_decode_rgb24(float3 c, float edge) {
    float3 k = umbrage_from_unorm(c);
    return ((k.x * 256.0 + k.y) * 256.0 + k.z + edge) * (1.0 / 16777216.0);
}
`,
            "decode_rgb10": `
// umbrage_decode_rgb10: three 10-bit channels, as sampled, to depth
//   edge   0.0 or 1.0: lower or upper edge of the code's interval
inline float umbrage_decode_rgb10(float3 c, float edge) {
    float3 k = umbrage_from_unorm10(c);
    return ((k.x * 1024.0 + k.y) * 16.0 + metal::floor(k.z * (1.0 / 64.0)) + edge) * (1.0 / 16777216.0);
}
`,
            "decode_r16": `
// umbrage_decode_r16: one channel of 16 bits, as sampled, to depth
//   edge   0.0, 0.5 or 1.0: lower edge, center or upper edge of the code's interval
inline float umbrage_decode_r16(float c, float edge) {
    return (umbrage_from_unorm16(c) + edge) * (1.0 / 65536.0);
}
`,
            "decode_float_bits": `
// umbrage_decode_float_bits: four channels of a bit pattern, as sampled, R least significant, to the float
inline float umbrage_decode_float_bits(float4 c) {
    uint r = uint(umbrage_saturate(c.x) * 255.0 + 0.5);
    uint g = uint(umbrage_saturate(c.y) * 255.0 + 0.5);
    uint b = uint(umbrage_saturate(c.z) * 255.0 + 0.5);
    uint a = uint(umbrage_saturate(c.w) * 255.0 + 0.5);
    return as_type<float>(r | (g << 8) | (b << 16) | (a << 24));
}
`,
            "decode_threejs_rgba": `
// umbrage_decode_threejs_rgba: the RGBA format of three.js r167 and later, as sampled, to depth
inline float umbrage_decode_threejs_rgba(float4 c) {
    float depth = c.x * (255.0 / 256.0) + c.y * (255.0 / 65536.0) + c.z * (255.0 / 16777216.0) + c.w *
        (1.0 / 16777216.0);
    return depth;
}
`,
            "decode_threejs_rgb": `
// umbrage_decode_threejs_rgb: the RGB format of three.js r167 and later, as sampled, to depth
inline float umbrage_decode_threejs_rgb(float3 c) {
    float depth = c.x * (255.0 / 256.0) + c.y * (255.0 / 65536.0) + c.z * (1.0 / 65536.0);
    return depth;
}
`,
            "decode_threejs_rg": `
// umbrage_decode_threejs_rg: the RG format of three.js r167 and later, as sampled, to depth
inline float umbrage_decode_threejs_rg(float2 c) {
    float depth = c.x * (255.0 / 256.0) + c.y * (1.0 / 256.0);
    return depth;
}
`,
            "decode_threejs_legacy": `
// umbrage_decode_threejs_legacy: the RGBA format of three.js r73 to r166, as sampled, to depth
inline float umbrage_decode_threejs_legacy(float4 c) {
    float depth = c.x * (255.0 / 4294967296.0) + c.y * (255.0 / 16777216.0) + c.z * (255.0 / 65536.0) + c.w *
        (255.0 / 256.0);
    return depth;
}
`,
            "decode_base255": `
// umbrage_decode_base255: base-255 RGBA, as sampled, to depth
inline float umbrage_decode_base255(float4 c) {
    float depth = c.x + c.y * 0.00392156886 + c.z * 0.0000153787005 + c.w * 0.0000000603086294;
    return depth;
}
`,
            "level_rg9": `
// umbrage_level_rg9: two channels of a 9-bit code, as sampled, to the scale of umbrage_receiver_rg9, on which 1.0 is
//   not the far plane
inline float umbrage_level_rg9(float2 c) {
    return c.x + c.y * 2.0;  // an exact product: fused or not, it rounds once
}
`,
            "level_rg10": `
// umbrage_level_rg10: two channels of a 10-bit code, as sampled, to the scale of umbrage_receiver_rg10, on which 1.0 is
//   not the far plane
inline float umbrage_level_rg10(float2 c) {
    return c.x + c.y * 4.0;  // an exact product: fused or not, it rounds once
}
`,
            "level_rg11": `
// umbrage_level_rg11: two channels of a 11-bit code, as sampled, to the scale of umbrage_receiver_rg11, on which 1.0 is
//   not the far plane
inline float umbrage_level_rg11(float2 c) {
    return c.x + c.y * 8.0;  // an exact product: fused or not, it rounds once
}
`,
            "level_rg12": `
// umbrage_level_rg12: two channels of a 12-bit code, as sampled, to the scale of umbrage_receiver_rg12, on which 1.0 is
//   not the far plane
inline float umbrage_level_rg12(float2 c) {
    return c.x + c.y * 16.0;  // an exact product: fused or not, it rounds once
}
`,
            "level_rg13": `
// umbrage_level_rg13: two channels of a 13-bit code, as sampled, to the scale of umbrage_receiver_rg13, on which 1.0 is
//   not the far plane
inline float umbrage_level_rg13(float2 c) {
    return c.x + c.y * 32.0;  // an exact product: fused or not, it rounds once
}
`,
            "level_rg14": `
// umbrage_level_rg14: two channels of a 14-bit code, as sampled, to the scale of umbrage_receiver_rg14, on which 1.0 is
//   not the far plane
inline float umbrage_level_rg14(float2 c) {
    return c.x + c.y * 64.0;  // an exact product: fused or not, it rounds once
}
`,
            "level_rg15": `
// umbrage_level_rg15: two channels of a 15-bit code, as sampled, to the scale of umbrage_receiver_rg15, on which 1.0 is
//   not the far plane
inline float umbrage_level_rg15(float2 c) {
    return c.x + c.y * 128.0;  // an exact product: fused or not, it rounds once
}
`,
            "level_rg16": `
// umbrage_level_rg16: two channels of a 16-bit code, as sampled, to the scale of umbrage_receiver_rg16, on which 1.0 is
//   not the far plane
inline float umbrage_level_rg16(float2 c) {
    return c.x + c.y * 256.0;  // an exact product: fused or not, it rounds once
}
`,
            "receiver_rg9": `
// umbrage_receiver_rg9: receiver on the scale of umbrage_level_rg9: it is <= a texel's level exactly when
//   depth <= umbrage_decode_rg9(texel, edge), or beyond the far plane
inline float umbrage_receiver_rg9(float depth, float edge) {
    float level = (metal::ceil(depth * 512.0 - edge) - 0.5) * 0.00392156886;
    return depth > 1.0 ? -1.0 : level;
}
`,
            "receiver_rg10": `
// umbrage_receiver_rg10: receiver on the scale of umbrage_level_rg10: it is <= a texel's level exactly when
//   depth <= umbrage_decode_rg10(texel, edge), or beyond the far plane
inline float umbrage_receiver_rg10(float depth, float edge) {
    float level = (metal::ceil(depth * 1024.0 - edge) - 0.5) * 0.00392156886;
    return depth > 1.0 ? -1.0 : level;
}
`,
            "receiver_rg11": `
// umbrage_receiver_rg11: receiver on the scale of umbrage_level_rg11: it is <= a texel's level exactly when
//   depth <= umbrage_decode_rg11(texel, edge), or beyond the far plane
inline float umbrage_receiver_rg11(float depth, float edge) {
    float level = (metal::ceil(depth * 2048.0 - edge) - 0.5) * 0.00392156886;
    return depth > 1.0 ? -1.0 : level;
}
`,
            "receiver_rg12": `
// umbrage_receiver_rg12: receiver on the scale of umbrage_level_rg12: it is <= a texel's level exactly when
//   depth <= umbrage_decode_rg12(texel, edge), or beyond the far plane
inline float umbrage_receiver_rg12(float depth, float edge) {
    float level = (metal::ceil(depth * 4096.0 - edge) - 0.5) * 0.00392156886;
    return depth > 1.0 ? -1.0 : level;
}
`,
            "receiver_rg13": `
// umbrage_receiver_rg13: receiver on the scale of umbrage_level_rg13: it is <= a texel's level exactly when
//   depth <= umbrage_decode_rg13(texel, edge), or beyond the far plane
inline float umbrage_receiver_rg13(float depth, float edge) {
    float level = (metal::ceil(depth * 8192.0 - edge) - 0.5) * 0.00392156886;
    return depth > 1.0 ? -1.0 : level;
}
`,
            "receiver_rg14": `
// umbrage_receiver_rg14: receiver on the scale of umbrage_level_rg14: it is <= a texel's level exactly when
//   depth <= umbrage_decode_rg14(texel, edge), or beyond the far plane
inline float umbrage_receiver_rg14(float depth, float edge) {
    float level = (metal::ceil(depth * 16384.0 - edge) - 0.5) * 0.00392156886;
    return depth > 1.0 ? -1.0 : level;
}
`,
            "receiver_rg15": `
// umbrage_receiver_rg15: receiver on the scale of umbrage_level_rg15: it is <= a texel's level exactly when
//   depth <= umbrage_decode_rg15(texel, edge), or beyond the far plane
inline float umbrage_receiver_rg15(float depth, float edge) {
    float level = (metal::ceil(depth * 32768.0 - edge) - 0.5) * 0.00392156886;
    return depth > 1.0 ? -1.0 : level;
}
`,
            "receiver_rg16": `
// umbrage_receiver_rg16: receiver on the scale of umbrage_level_rg16: it is <= a texel's level exactly when
//   depth <= umbrage_decode_rg16(texel, edge), or beyond the far plane
inline float umbrage_receiver_rg16(float depth, float edge) {
    float level = (metal::ceil(depth * 65536.0 - edge) - 0.5) * 0.00392156886;
    return depth > 1.0 ? -1.0 : level;
}
`,
            "decode_ps14": `
// umbrage_decode_ps14: the channels of an 11-bit code, as sampled, to x / 2040; compare with umbrage_receiver_ps14;
//   1.0 is not the far plane on this scale
inline float umbrage_decode_ps14(float2 c) {
    return c.x * 0.125 + c.y;  // an exact product: fused or not, it rounds once
}
`,
            "receiver_ps14": `
// umbrage_receiver_ps14: depth * 256 / 255, the scale of umbrage_decode_ps14; beyond the far plane what every texel
//   lights
inline float umbrage_receiver_ps14(float depth) {
    return depth > 1.0 ? -1.0 : depth * 1.00392163;
}
`,
            "inside_map": `
// umbrage_inside_map: whether a texel is one of a map's of size texels
inline bool umbrage_inside_map(float2 size, float2 texel) {
    return texel.x >= 0.0 && texel.y >= 0.0 && texel.x < size.x && texel.y < size.y;
}
`,
            "fetch_bordered": `
// umbrage_fetch_bordered: texel of a map, or border outside of it
inline float4 umbrage_fetch_bordered(UMBRAGE_MAP map, float2 size, float2 texel, float4 border) {
    float2 at = metal::clamp(texel, float2(0.0, 0.0), size - 1.0);
    float4 value = umbrage_texel(map, size, at);
    return at.x == texel.x && at.y == texel.y ? value : border;
}
`,
            "fetch_depth": `
// umbrage_fetch_depth: stored depth of a texel, outside the map that of the far plane
inline float umbrage_fetch_depth(UMBRAGE_MAP map, float2 size, float2 texel) {
    float2 inside = metal::clamp(texel, float2(0.0, 0.0), size - 1.0);
    float4 value = umbrage_texel(map, size, inside);
    float depth = UMBRAGE_DEPTH;
    return inside.x == texel.x && inside.y == texel.y ? depth : UMBRAGE_BORDER;
}
`,
            "depth_at": `
// umbrage_depth_at: stored depth of the texel at a point; on a border it may be the texel beside
//   uv  over the map, (0.0, 0.0) to (1.0, 1.0), no NaN
inline float umbrage_depth_at(UMBRAGE_MAP map, float2 size, float2 uv) {
    return umbrage_fetch_depth(map, size, metal::floor(uv * size));
}
`,
            "beyond_far_plane": `
// umbrage_beyond_far_plane: whether a receiver is behind the far plane
inline bool umbrage_beyond_far_plane(float receiver) {
    return receiver > 1.0;
}
`,
            "in_filter_domain": `
// umbrage_in_filter_domain: whether a filter compares; outside texel space and beyond the far plane all is lit
inline bool umbrage_in_filter_domain(float2 coord, float receiver) {
    // a choice, not a && !b: of !(receiver > 1.0) FXC makes receiver <= 1.0, which loses a NaN
    return umbrage_beyond_far_plane(receiver) ? false : umbrage_inside_texel_space(coord);
}
`,
            "compare": `
// umbrage_compare: 1.0 when the receiver is no farther than the stored depth
inline float umbrage_compare(float receiver, float stored) {
    return receiver <= stored ? 1.0 : 0.0;
}
`,
            "lit": `
// umbrage_lit: visibility of one comparison with a texel
inline float umbrage_lit(UMBRAGE_MAP map, float2 size, float2 texel, float receiver) {
    return umbrage_compare(receiver, umbrage_fetch_depth(map, size, texel));
}
`,
            "lit_2x2": `
// umbrage_lit_2x2: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1)
inline float4 umbrage_lit_2x2(UMBRAGE_MAP map, float2 size, float2 texel, float receiver) {
    float a = umbrage_lit(map, size, texel, receiver);
    float b = umbrage_lit(map, size, texel + float2(1.0, 0.0), receiver);
    float c = umbrage_lit(map, size, texel + float2(0.0, 1.0), receiver);
    float d = umbrage_lit(map, size, texel + float2(1.0, 1.0), receiver);
    return float4(a, b, c, d);
}
`,
            "map_covers": `
// umbrage_map_covers: whether a receiver of a prefiltered map or a table lies in the map; elsewhere it is lit
inline bool umbrage_map_covers(float2 size, float2 coord) {
    return coord.x >= 0.0 && coord.y >= 0.0 && coord.x < size.x && coord.y < size.y;
}
`,
            "within_far_plane": `
// umbrage_within_far_plane: whether a receiver is a number, and not behind the far plane
inline bool umbrage_within_far_plane(float receiver) {
    return receiver <= 1.0;
}
`,
            "compare_dx_sdk": `
// umbrage_compare_dx_sdk: 0.0 when stored + epsilon < receiver, else 1.0
inline float umbrage_compare_dx_sdk(float receiver, float stored, float epsilon) {
    float limit = stored + epsilon;
    return limit < receiver ? 0.0 : 1.0;
}
`,
            "compare_exercise": `
// umbrage_compare_exercise: 1.0 when current < stored + epsilon, else 0.0
inline float umbrage_compare_exercise(float current, float stored, float epsilon) {
    float limit = stored + epsilon;
    return current < limit ? 1.0 : 0.0;
}
`,
            "window_sum3": `
// umbrage_window_sum3: weighted count of the lit texels under weights that slide over the map, whole
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   steps  of a texel, a power of two up to 256
//   k0 .. k1   weights from the edge to the middle one; the others mirror them. Steps times their sum, a whole number
//              up to 4096, squared is what is wholly lit
inline float umbrage_window_sum3(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float steps, float k0,
                                 float k1) {
    bool compared = umbrage_in_filter_domain(coord, receiver);  // no branch: fetches overlap
    float2 x = compared ? metal::floor(coord * 256.0) - 128.0 : float2(0.0, 0.0);
    float2 texel = metal::floor(x * (1.0 / 256.0));
    float2 s = metal::floor((x - texel * 256.0) * (1.0 / 256.0) * steps);
    float2 r = steps - s;
    float whole = steps * (k0 + k1 + k0);
    float2 w0 = metal::floor(r * k0);
    float2 w2 = metal::floor(r * k0 + s * k1);
    float2 w3 = metal::floor(s * k0);
    float2 w1 = metal::max(whole - (w0 + w2 + w3), float2(0.0, 0.0));
    float2 first = texel - 1.0;
    float n = 0.0;
    float4 a = umbrage_lit_2x2(map, size, first + float2(0.0, 0.0), receiver);
    float4 b = umbrage_lit_2x2(map, size, first + float2(2.0, 0.0), receiver);
    n += w0.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y);
    n += w1.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w);
    a = umbrage_lit_2x2(map, size, first + float2(0.0, 2.0), receiver);
    b = umbrage_lit_2x2(map, size, first + float2(2.0, 2.0), receiver);
    n += w2.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y);
    n += w3.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w);
    return compared ? n : whole * whole;
}
`,
            "window_sum5": `
// umbrage_window_sum5: weighted count of the lit texels under weights that slide over the map, whole
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   steps  of a texel, a power of two up to 256
//   k0 .. k2   weights from the edge to the middle one; the others mirror them. Steps times their sum, a whole number
//              up to 4096, squared is what is wholly lit
inline float umbrage_window_sum5(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float steps, float k0,
                                 float k1, float k2) {
    bool compared = umbrage_in_filter_domain(coord, receiver);  // no branch: fetches overlap
    float2 x = compared ? metal::floor(coord * 256.0) - 128.0 : float2(0.0, 0.0);
    float2 texel = metal::floor(x * (1.0 / 256.0));
    float2 s = metal::floor((x - texel * 256.0) * (1.0 / 256.0) * steps);
    float2 r = steps - s;
    float whole = steps * (k0 + k1 + k2 + k1 + k0);
    float2 w0 = metal::floor(r * k0);
    float2 w1 = metal::floor(r * k1 + s * k0);
    float2 w3 = metal::floor(r * k1 + s * k2);
    float2 w4 = metal::floor(r * k0 + s * k1);
    float2 w5 = metal::floor(s * k0);
    float2 w2 = metal::max(whole - (w0 + w1 + w3 + w4 + w5), float2(0.0, 0.0));
    float2 first = texel - 2.0;
    float n = 0.0;
    float4 a = umbrage_lit_2x2(map, size, first + float2(0.0, 0.0), receiver);
    float4 b = umbrage_lit_2x2(map, size, first + float2(2.0, 0.0), receiver);
    float4 c = umbrage_lit_2x2(map, size, first + float2(4.0, 0.0), receiver);
    n += w0.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y);
    n += w1.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w);
    a = umbrage_lit_2x2(map, size, first + float2(0.0, 2.0), receiver);
    b = umbrage_lit_2x2(map, size, first + float2(2.0, 2.0), receiver);
    c = umbrage_lit_2x2(map, size, first + float2(4.0, 2.0), receiver);
    n += w2.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y);
    n += w3.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w);
    a = umbrage_lit_2x2(map, size, first + float2(0.0, 4.0), receiver);
    b = umbrage_lit_2x2(map, size, first + float2(2.0, 4.0), receiver);
    c = umbrage_lit_2x2(map, size, first + float2(4.0, 4.0), receiver);
    n += w4.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y);
    n += w5.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w);
    return compared ? n : whole * whole;
}
`,
            "window_sum7": `
// umbrage_window_sum7: weighted count of the lit texels under weights that slide over the map, whole
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   steps  of a texel, a power of two up to 256
//   k0 .. k3   weights from the edge to the middle one; the others mirror them. Steps times their sum, a whole number
//              up to 4096, squared is what is wholly lit
inline float umbrage_window_sum7(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float steps, float k0,
                                 float k1, float k2, float k3) {
    bool compared = umbrage_in_filter_domain(coord, receiver);  // no branch: fetches overlap
    float2 x = compared ? metal::floor(coord * 256.0) - 128.0 : float2(0.0, 0.0);
    float2 texel = metal::floor(x * (1.0 / 256.0));
    float2 s = metal::floor((x - texel * 256.0) * (1.0 / 256.0) * steps);
    float2 r = steps - s;
    float whole = steps * (k0 + k1 + k2 + k3 + k2 + k1 + k0);
    float2 w0 = metal::floor(r * k0);
    float2 w1 = metal::floor(r * k1 + s * k0);
    float2 w2 = metal::floor(r * k2 + s * k1);
    float2 w4 = metal::floor(r * k2 + s * k3);
    float2 w5 = metal::floor(r * k1 + s * k2);
    float2 w6 = metal::floor(r * k0 + s * k1);
    float2 w7 = metal::floor(s * k0);
    float2 w3 = metal::max(whole - (w0 + w1 + w2 + w4 + w5 + w6 + w7), float2(0.0, 0.0));
    float2 first = texel - 3.0;
    float n = 0.0;
    float4 a = umbrage_lit_2x2(map, size, first + float2(0.0, 0.0), receiver);
    float4 b = umbrage_lit_2x2(map, size, first + float2(2.0, 0.0), receiver);
    float4 c = umbrage_lit_2x2(map, size, first + float2(4.0, 0.0), receiver);
    float4 d = umbrage_lit_2x2(map, size, first + float2(6.0, 0.0), receiver);
    n += w0.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y + w6.x * d.x + w7.x * d.y);
    n += w1.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w + w6.x * d.z + w7.x * d.w);
    a = umbrage_lit_2x2(map, size, first + float2(0.0, 2.0), receiver);
    b = umbrage_lit_2x2(map, size, first + float2(2.0, 2.0), receiver);
    c = umbrage_lit_2x2(map, size, first + float2(4.0, 2.0), receiver);
    d = umbrage_lit_2x2(map, size, first + float2(6.0, 2.0), receiver);
    n += w2.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y + w6.x * d.x + w7.x * d.y);
    n += w3.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w + w6.x * d.z + w7.x * d.w);
    a = umbrage_lit_2x2(map, size, first + float2(0.0, 4.0), receiver);
    b = umbrage_lit_2x2(map, size, first + float2(2.0, 4.0), receiver);
    c = umbrage_lit_2x2(map, size, first + float2(4.0, 4.0), receiver);
    d = umbrage_lit_2x2(map, size, first + float2(6.0, 4.0), receiver);
    n += w4.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y + w6.x * d.x + w7.x * d.y);
    n += w5.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w + w6.x * d.z + w7.x * d.w);
    a = umbrage_lit_2x2(map, size, first + float2(0.0, 6.0), receiver);
    b = umbrage_lit_2x2(map, size, first + float2(2.0, 6.0), receiver);
    c = umbrage_lit_2x2(map, size, first + float2(4.0, 6.0), receiver);
    d = umbrage_lit_2x2(map, size, first + float2(6.0, 6.0), receiver);
    n += w6.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y + w6.x * d.x + w7.x * d.y);
    n += w7.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w + w6.x * d.z + w7.x * d.w);
    return compared ? n : whole * whole;
}
`,
            "disc_rotation": `
// umbrage_disc_rotation: (cos, sin) in 1/64 of one of 16 turns for a pixel, such as gl_FragCoord.xy: each once in 4 x 4
inline float2 umbrage_disc_rotation(float2 pixel) {
    float2 whole = umbrage_inside_texel_space(pixel) ? metal::floor(pixel) : float2(0.0, 0.0);
    float v = whole.x * 4.0 + whole.y;
    v = v - metal::floor(v * (1.0 / 16.0)) * 16.0;
    float quarter = metal::floor(v * 0.25);
    float base = v - quarter * 4.0;
    float2 low = base < 0.5 ? float2(64.0, 0.0) : float2(59.0, 24.0);
    float2 high = base < 2.5 ? float2(45.0, 45.0) : float2(24.0, 59.0);
    float2 first = base < 1.5 ? low : high;
    float2 once = quarter < 0.5 ? first : float2(0.0 - first.y, first.x);
    float2 twice = quarter < 2.5 ? float2(0.0 - first.x, 0.0 - first.y) : float2(first.y, 0.0 - first.x);
    return quarter < 1.5 ? once : twice;
}
`,
            "disc_tap": `
// umbrage_disc_tap: the texel that a point of a disc falls on
//   position  floor(256 coord) of the receiver;   p  point, in 1/16 of the radius;   rotation  of umbrage_disc_rotation
//   radius    in 1/16 texel, a whole number from 0 to 4095
inline float2 umbrage_disc_tap(float2 position, float2 p, float2 rotation, float radius) {
    float2 at = position * (1.0 / 256.0);
    float2 texel = metal::floor(at);
    float2 within = metal::clamp(at - texel, float2(0.0, 0.0), float2(1.0, 1.0));  // no sum is regrouped across it
    float2 scaled = rotation * (radius * (1.0 / 16384.0));
    float x = scaled.x * p.x + within.x - scaled.y * p.y;
    float y = scaled.y * p.x + within.y + scaled.x * p.y;
    return texel + metal::floor(float2(x, y));
}
`,
            "disc_radius": `
// umbrage_disc_radius: a disc's radius in 1/16 texel, from one in texels: a whole number from 0 to 4095, of a NaN 0
inline float umbrage_disc_radius(float radius) {
    float inside = radius > 0.0 ? metal::floor(radius * 16.0) : 0.0;
    return radius >= 255.9375 ? 4095.0 : inside;
}
`,
            "disc8": `
// umbrage_disc8: lit share of 8 points of a disc; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   radius  in texels, at most 255.9375;   rotation  umbrage_disc_rotation of the pixel
inline float umbrage_disc8(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float radius, float2 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 at = compared ? metal::floor(coord * 256.0) : float2(0.0, 0.0);  // no branch: fetches overlap
    float rho = umbrage_disc_radius(radius);
    float n = 0.0;
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(3.0, -1.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-4.0, 5.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(1.0, -11.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-9.0, -8.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-12.0, 3.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(11.0, 6.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(0.0, 13.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(11.0, -7.0), rotation, rho), receiver);
    return compared ? n * (1.0 / 8.0) : 1.0;
}
`,
            "disc16": `
// umbrage_disc16: lit share of 16 points of a disc; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   radius  in texels, at most 255.9375;   rotation  umbrage_disc_rotation of the pixel
inline float umbrage_disc16(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float radius, float2 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 at = compared ? metal::floor(coord * 256.0) : float2(0.0, 0.0);  // no branch: fetches overlap
    float rho = umbrage_disc_radius(radius);
    float n = 0.0;
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(1.0, -3.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(5.0, 2.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-5.0, 2.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(0.0, 7.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-6.0, -5.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(8.0, -5.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(0.0, -11.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(11.0, 5.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-12.0, 4.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-1.0, 13.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(7.0, 11.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-9.0, 10.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-13.0, -4.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(7.0, -12.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-7.0, -12.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(14.0, -2.0), rotation, rho), receiver);
    return compared ? n * (1.0 / 16.0) : 1.0;
}
`,
            "disc32": `
// umbrage_disc32: lit share of 32 points of a disc; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   radius  in texels, at most 255.9375;   rotation  umbrage_disc_rotation of the pixel
inline float umbrage_disc32(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float radius, float2 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 at = compared ? metal::floor(coord * 256.0) : float2(0.0, 0.0);  // no branch: fetches overlap
    float rho = umbrage_disc_radius(radius);
    float n = 0.0;
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-2.0, -1.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(3.0, 2.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(1.0, -4.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-4.0, 3.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(0.0, 6.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-5.0, -5.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(7.0, -2.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-8.0, -1.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(8.0, 3.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(5.0, 7.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(1.0, -9.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(6.0, -7.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-8.0, 5.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(0.0, 10.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-3.0, -10.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-6.0, 10.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-9.0, -8.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(11.0, -5.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(5.0, -12.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-13.0, -1.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(7.0, 11.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(13.0, 3.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-13.0, 4.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(10.0, -10.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(14.0, -2.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-11.0, 9.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(3.0, 14.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-13.0, -6.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(12.0, 8.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-4.0, 14.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-7.0, -13.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(0.0, -15.0), rotation, rho), receiver);
    return compared ? n * (1.0 / 32.0) : 1.0;
}
`,
            "hard": `
// umbrage_hard: unfiltered shadow test; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased
inline float umbrage_hard(UMBRAGE_MAP map, float2 size, float2 coord, float receiver) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 texel = compared ? metal::floor(coord) : float2(0.0, 0.0);  // no branch: fetches of several taps overlap
    float lit = umbrage_lit(map, size, texel, receiver);
    return compared ? lit : 1.0;
}
`,
            "four_tap": `
// umbrage_four_tap: mean of the shadow test at four taps; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   a, b, c, d  taps in texels, all lit where their mean is 2^15
//   or more in a direction;   receiver  depth, biased
inline float umbrage_four_tap(UMBRAGE_MAP map, float2 size, float2 a, float2 b, float2 c, float2 d, float receiver) {
    float2 a_texel = metal::floor(a);
    float2 b_texel = metal::floor(b);
    float2 c_texel = metal::floor(c);
    float2 d_texel = metal::floor(d);
    float2 sum = metal::abs(a_texel) + metal::abs(b_texel) + metal::abs(c_texel) + metal::abs(d_texel);
    // two limits on purpose: Mesa makes max(x, y) < limit of one, which loses a NaN
    bool compared = umbrage_beyond_far_plane(receiver) ? false : sum.x < 131072.0 && sum.y * 2.0 < 262144.0;
    float count = umbrage_lit(map, size, a_texel, receiver) + umbrage_lit(map, size, b_texel, receiver) +
        umbrage_lit(map, size, c_texel, receiver) + umbrage_lit(map, size, d_texel, receiver);
    return compared ? count * 0.25 : 1.0;
}
`,
            "pcf_2x2": `
// umbrage_pcf_2x2: bilinear percentage-closer filtering; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased
inline float umbrage_pcf_2x2(UMBRAGE_MAP map, float2 size, float2 coord, float receiver) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 x = compared ? metal::floor(coord * 256.0) - 128.0 : float2(0.0, 0.0);  // no branch: fetches overlap
    float2 texel = metal::floor(x * (1.0 / 256.0));
    // weights are in [0, 1) already; compilers cannot regroup sums across the clamp
    float2 hi = metal::clamp(x * (1.0 / 256.0) - texel, float2(0.0, 0.0), float2(1.0, 1.0));
    float2 lo = 1.0 - hi;
    float4 lit = umbrage_lit_2x2(map, size, texel, receiver);
    float visibility = lo.y * (lo.x * lit.x + hi.x * lit.y) + hi.y * (lo.x * lit.z + hi.x * lit.w);
    return compared ? visibility : 1.0;
}
`,
            "pcf_2x2_dx_sdk": `
// umbrage_pcf_2x2_dx_sdk: the DirectX SDK sample's 2x2 filter; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, not biased;   epsilon  in depth, added to the stored side
inline float umbrage_pcf_2x2_dx_sdk(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float epsilon) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 x = compared ? coord - 0.5 : float2(0.0, 0.0);  // no branch: fetches overlap
    float2 texel = metal::floor(x);
    float2 weight = x - texel;
    float a = umbrage_compare_dx_sdk(receiver, umbrage_fetch_depth(map, size, texel), epsilon);
    float right = umbrage_fetch_depth(map, size, texel + float2(1.0, 0.0));
    float above = umbrage_fetch_depth(map, size, texel + float2(0.0, 1.0));
    float beyond = umbrage_fetch_depth(map, size, texel + float2(1.0, 1.0));
    float b = umbrage_compare_dx_sdk(receiver, right, epsilon);
    float c = umbrage_compare_dx_sdk(receiver, above, epsilon);
    float d = umbrage_compare_dx_sdk(receiver, beyond, epsilon);
    float low = a + weight.x * (b - a);
    float high = c + weight.x * (d - c);
    float visibility = low + weight.y * (high - low);
    return compared ? visibility : 1.0;
}
`,
            "box_count": `
// umbrage_box_count: lit texels in the (2r+1) x (2r+1) box around the receiver's own, a whole number
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   radius  r, clamped to 0..8, best a constant
inline float umbrage_box_count(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, int radius) {
    int r = radius < 0 ? 0 : (radius < 8 ? radius : 8);
    int width = 2 * r + 1;
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 first = compared ? metal::floor(coord) - float(r) : float2(0.0, 0.0);
    float count = 0.0;
    for (int j = 0; j < 17; j++) {
        if (j >= width) break;
        for (int i = 0; i < 17; i++) {
            if (i >= width) break;
            count += umbrage_lit(map, size, first + float2(float(i), float(j)), receiver);
        }
    }
    return compared ? count : float(width * width);
}
`,
            "box_scale": `
// umbrage_box_scale: 1 / (2r+1)^2, rounded to nearest
inline float umbrage_box_scale(int radius) {
    float scale = 0.00346020772;  // not returned as a literal: that would have the host's precision
    if (radius < 8) scale = 0.00444444455;
    if (radius < 7) scale = 0.00591715984;
    if (radius < 6) scale = 0.00826446246;
    if (radius < 5) scale = 0.0123456791;
    if (radius < 4) scale = 0.0204081628;
    if (radius < 3) scale = 0.0399999991;
    if (radius < 2) scale = 0.111111112;
    if (radius < 1) scale = 1.0;
    return scale;
}
`,
            "box": `
// umbrage_box: lit share of a (2r+1) x (2r+1) box; visibility, 1.0 is lit; arguments as for umbrage_box_count
inline float umbrage_box(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, int radius) {
    float visibility = umbrage_box_count(map, size, coord, receiver, radius) * umbrage_box_scale(radius);
    return visibility < 0.999 ? visibility : 1.0;  // 121 times the rounded 1/121 is not 1
}
`,
            "tent2": `
// umbrage_tent2: lit share of 3 x 3 texels, the window 1 1; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased
inline float umbrage_tent2(UMBRAGE_MAP map, float2 size, float2 coord, float receiver) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 x = compared ? metal::floor(coord * 256.0) : float2(0.0, 0.0);  // no branch: fetches overlap
    float2 texel = metal::floor(x * (1.0 / 256.0));
    // s is in [0, 256) already, w1 not negative; compilers cannot regroup sums across clamp and max
    float2 s = metal::clamp(x * (1.0 / 256.0) - texel, float2(0.0, 0.0), float2(1.0, 1.0)) * 256.0;
    float2 r = 256.0 - s;
    float2 w0 = r * 8.0;
    float2 w2 = s * 8.0;
    float2 w1 = metal::max(4096.0 - w0 - w2, float2(0.0, 0.0));
    float4 a = umbrage_lit_2x2(map, size, texel - 1.0, receiver);
    float4 b = umbrage_lit_2x2(map, size, texel + float2(1.0, -1.0), receiver);
    float4 c = umbrage_lit_2x2(map, size, texel + float2(-1.0, 1.0), receiver);
    float4 d = umbrage_lit_2x2(map, size, texel + float2(1.0, 1.0), receiver);
    float n = w0.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x);
    n += w1.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z);
    n += w2.y * (w0.x * c.x + w1.x * c.y + w2.x * d.x);
    return compared ? n * (1.0 / 16777216.0) : 1.0;
}
`,
            "tent3": `
// umbrage_tent3: lit share under 3 x 3 weights, 1 2 1, that slide over the map; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased
inline float umbrage_tent3(UMBRAGE_MAP map, float2 size, float2 coord, float receiver) {
    float n = umbrage_window_sum3(map, size, coord, receiver, 256.0, 4.0, 8.0);
    return metal::clamp(n * (1.0 / 16777216.0), 0.0, 1.0);
}
`,
            "quadratic_b_spline": `
// umbrage_quadratic_b_spline: lit share of 3 x 3 texels, weighed by the quadratic B-spline; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased
inline float umbrage_quadratic_b_spline(UMBRAGE_MAP map, float2 size, float2 coord, float receiver) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 x = compared ? metal::floor(coord * 256.0) : float2(0.0, 0.0);  // no branch: fetches overlap
    float2 texel = metal::floor(x * (1.0 / 256.0));
    // s is in [0, 256) already, w1 not negative; compilers cannot regroup sums across clamp and max
    float2 s = metal::clamp(x * (1.0 / 256.0) - texel, float2(0.0, 0.0), float2(1.0, 1.0)) * 256.0;
    float2 r = 256.0 - s;
    float2 w0 = metal::floor(r * r * (1.0 / 32.0));
    float2 w2 = metal::floor(s * s * (1.0 / 32.0));
    float2 w1 = metal::max(4096.0 - w0 - w2, float2(0.0, 0.0));
    float4 a = umbrage_lit_2x2(map, size, texel - 1.0, receiver);
    float4 b = umbrage_lit_2x2(map, size, texel + float2(1.0, -1.0), receiver);
    float4 c = umbrage_lit_2x2(map, size, texel + float2(-1.0, 1.0), receiver);
    float4 d = umbrage_lit_2x2(map, size, texel + float2(1.0, 1.0), receiver);
    float n = w0.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x);
    n += w1.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z);
    n += w2.y * (w0.x * c.x + w1.x * c.y + w2.x * d.x);
    return compared ? n * (1.0 / 16777216.0) : 1.0;
}
`,
            "binomial5": `
// umbrage_binomial5: lit share under 5 x 5 weights, 1 4 6 4 1, that slide over the map; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased
inline float umbrage_binomial5(UMBRAGE_MAP map, float2 size, float2 coord, float receiver) {
    float n = umbrage_window_sum5(map, size, coord, receiver, 256.0, 1.0, 4.0, 6.0);
    return metal::clamp(n * (1.0 / 16777216.0), 0.0, 1.0);
}
`,
            "castano_dyadic5": `
// umbrage_castano_dyadic5: lit share under 5 x 5 weights, 5 16 22 16 5, that slide over the map; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased
inline float umbrage_castano_dyadic5(UMBRAGE_MAP map, float2 size, float2 coord, float receiver) {
    float n = umbrage_window_sum5(map, size, coord, receiver, 256.0, 1.25, 4.0, 5.5);
    return metal::clamp(n * (1.0 / 16777216.0), 0.0, 1.0);
}
`,
            "castano5": `
// umbrage_castano5: lit share under 5 x 5 weights, 1 3 4 3 1, that slide over the map; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased
inline float umbrage_castano5(UMBRAGE_MAP map, float2 size, float2 coord, float receiver) {
    float n = umbrage_window_sum5(map, size, coord, receiver, 256.0, 1.0, 3.0, 4.0);
    return n < 9437184.0 ? n * (1.0 / 65536.0) * 0.00694444450 : 1.0;
}
`,
            "binomial7": `
// umbrage_binomial7: lit share under 7 x 7 weights, 1 6 15 20 15 6 1, that slide over the map; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased
inline float umbrage_binomial7(UMBRAGE_MAP map, float2 size, float2 coord, float receiver) {
    float n = umbrage_window_sum7(map, size, coord, receiver, 256.0, 0.25, 1.5, 3.75, 5.0);
    return metal::clamp(n * (1.0 / 16777216.0), 0.0, 1.0);
}
`,
            "tent7": `
// umbrage_tent7: lit share under 7 x 7 weights, 1 2 3 4 3 2 1, that slide over the map; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased
inline float umbrage_tent7(UMBRAGE_MAP map, float2 size, float2 coord, float receiver) {
    float n = umbrage_window_sum7(map, size, coord, receiver, 256.0, 1.0, 2.0, 3.0, 4.0);
    return metal::clamp(n * (1.0 / 16777216.0), 0.0, 1.0);
}
`,
            "castano7": `
// umbrage_castano7: lit share under 7 x 7 weights, 1 5 12 16 12 5 1, that slide over the map; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased
inline float umbrage_castano7(UMBRAGE_MAP map, float2 size, float2 coord, float receiver) {
    float n = umbrage_window_sum7(map, size, coord, receiver, 64.0, 1.0, 5.0, 12.0, 16.0);
    return n < 11075584.0 ? n * (1.0 / 4096.0) * 0.000369822490 : 1.0;
}
`,
            "cube_lit": `
// umbrage_cube_lit: (visibility of one comparison, 1.0) with a texel of a cube, (0.0, 0.0) beyond a corner
//   map, size  atlas of 3 x 2 faces and its size in texels;   texel  (s, t, face), whole numbers
inline float2 umbrage_cube_lit(UMBRAGE_MAP map, float2 size, float3 texel, float receiver) {
    float side = size.y * 0.5;
    float3 n = umbrage_cube_neighbor(texel, side);
    float2 at = umbrage_cube_tile(n.z, side) + float2(n.x, n.y);
    float lit = umbrage_lit(map, size, at, receiver);
    return n.z < 0.0 ? float2(0.0, 0.0) : float2(lit, 1.0);
}
`,
            "pcf_2x2_cube": `
// umbrage_pcf_2x2_cube: bilinear percentage-closer filtering over a cube's edges; visibility, 1.0 is lit
//   map, size  atlas of 3 x 2 faces and its size in texels;   at  (s, t, face): texels of the face, from 0.0 on
//   receiver   distance from the light, biased
inline float umbrage_pcf_2x2_cube(UMBRAGE_MAP map, float2 size, float3 at, float receiver) {
    float2 coord = float2(at.x, at.y);
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 x = compared ? metal::floor(coord * 256.0 + 0.5) - 128.0 : float2(0.0, 0.0);
    float2 texel = metal::floor(x * (1.0 / 256.0));
    // weights are in [0, 1) already; compilers cannot regroup sums across the clamp
    float2 hi = metal::clamp(x * (1.0 / 256.0) - texel, float2(0.0, 0.0), float2(1.0, 1.0));
    float2 lo = 1.0 - hi;
    float2 sum = umbrage_cube_lit(map, size, float3(texel, at.z), receiver) * (lo.x * lo.y);
    sum += umbrage_cube_lit(map, size, float3(texel + float2(1.0, 0.0), at.z), receiver) * (hi.x * lo.y);
    sum += umbrage_cube_lit(map, size, float3(texel + float2(0.0, 1.0), at.z), receiver) * (lo.x * hi.y);
    sum += umbrage_cube_lit(map, size, float3(texel + float2(1.0, 1.0), at.z), receiver) * (hi.x * hi.y);
    return compared && sum.y > 0.0 ? sum.x / sum.y : 1.0;
}
`,
            "four_tap_hardware": `
// umbrage_four_tap_hardware: mean of the shadow test at four taps of the sampler's; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   a, b, c, d  taps, (0.0, 0.0) to (1.0, 1.0) over the map, all lit
//   where the mean of |x| + |y| is 2^15 texels or more;   receiver  depth, biased
inline float umbrage_four_tap_hardware(UMBRAGE_MAP map, float2 size, float2 a, float2 b, float2 c, float2 d,
                                       float receiver) {
    float2 sum = (metal::abs(a) + metal::abs(b) + metal::abs(c) + metal::abs(d)) * size;
    bool compared = umbrage_beyond_far_plane(receiver) ? false : sum.x + sum.y < 131072.0;
    float count = umbrage_compare(receiver, umbrage_depth_at(map, size, a)) +
        umbrage_compare(receiver, umbrage_depth_at(map, size, b)) +
        umbrage_compare(receiver, umbrage_depth_at(map, size, c)) +
        umbrage_compare(receiver, umbrage_depth_at(map, size, d));
    return compared ? count * 0.25 : 1.0;
}
`,
            "lit_filtered": `
// umbrage_lit_filtered: 2x2 comparisons around a point; this map has no sampler to weigh them; visibility, 1.0 is lit
//   coord  in texels, no NaN; what is outside texel space counts as its border
inline float umbrage_lit_filtered(UMBRAGE_MAP map, float2 size, float2 coord, float receiver) {
    return umbrage_pcf_2x2(map, size, metal::clamp(coord, float2(-32767.0, -32767.0), float2(32767.0, 32767.0)),
                           receiver);
}
`,
            "lit_at": `
// umbrage_lit_at: 2x2 comparisons around a point, weighted; visibility, 1.0 is lit
//   uv  over the map, (0.0, 0.0) to (1.0, 1.0), no NaN
inline float umbrage_lit_at(UMBRAGE_MAP map, float2 size, float2 uv, float receiver) {
    return umbrage_lit_filtered(map, size, uv * size, receiver);
}
`,
            "pcf_2x2_hardware": `
// umbrage_pcf_2x2_hardware: 2x2 comparisons, weighted by the sampler; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased
inline float umbrage_pcf_2x2_hardware(UMBRAGE_MAP map, float2 size, float2 coord, float receiver) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 at = compared ? coord : float2(0.0, 0.0);
    float lit = umbrage_lit_at(map, size, at / size, receiver);
    float visibility = umbrage_within_far_plane(receiver) ? lit : 0.0;
    return compared ? visibility : 1.0;
}
`,
            "window_hardware3": `
// umbrage_window_hardware3: lit share under weights that slide over the map, by the sampler; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   k0 .. k1  weights from the edge to the middle one; the others mirror them
inline float umbrage_window_hardware3(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float k0, float k1) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 x = compared ? coord - 0.5 : float2(0.0, 0.0);
    float2 texel = metal::floor(x);
    float2 s = x - texel;
    float whole = k0 + k1 + k0;
    float2 b0 = k1 + s * (k0 - k1);
    float2 w0 = k0 + k1 - s * k1;
    float2 p0 = (texel - 0.5 + b0 / w0) / size;
    float2 b1 = s * k0;
    float2 w1 = k0 + s * k1;
    float2 p1 = (texel + 1.5 + b1 / w1) / size;
    float n = 0.0;
    float row = 0.0;
    row += w0.x * umbrage_lit_at(map, size, float2(p0.x, p0.y), receiver);
    row += w1.x * umbrage_lit_at(map, size, float2(p1.x, p0.y), receiver);
    n += w0.y * row;
    row = 0.0;
    row += w0.x * umbrage_lit_at(map, size, float2(p0.x, p1.y), receiver);
    row += w1.x * umbrage_lit_at(map, size, float2(p1.x, p1.y), receiver);
    n += w1.y * row;
    float share = metal::clamp(n / (whole * whole), 0.0, 1.0);
    float visibility = umbrage_within_far_plane(receiver) ? share : 0.0;
    return compared ? visibility : 1.0;
}
`,
            "window_hardware5": `
// umbrage_window_hardware5: lit share under weights that slide over the map, by the sampler; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   k0 .. k2  weights from the edge to the middle one; the others mirror them
inline float umbrage_window_hardware5(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float k0, float k1,
                                      float k2) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 x = compared ? coord - 0.5 : float2(0.0, 0.0);
    float2 texel = metal::floor(x);
    float2 s = x - texel;
    float whole = k0 + k1 + k2 + k1 + k0;
    float2 b0 = k1 + s * (k0 - k1);
    float2 w0 = k0 + k1 - s * k1;
    float2 p0 = (texel - 1.5 + b0 / w0) / size;
    float2 b1 = k1 + s * (k2 - k1);
    float2 w1 = float2(k2 + k1, k2 + k1);
    float2 p1 = (texel + 0.5 + b1 / w1) / size;
    float2 b2 = s * k0;
    float2 w2 = k0 + s * k1;
    float2 p2 = (texel + 2.5 + b2 / w2) / size;
    float n = 0.0;
    float row = 0.0;
    row += w0.x * umbrage_lit_at(map, size, float2(p0.x, p0.y), receiver);
    row += w1.x * umbrage_lit_at(map, size, float2(p1.x, p0.y), receiver);
    row += w2.x * umbrage_lit_at(map, size, float2(p2.x, p0.y), receiver);
    n += w0.y * row;
    row = 0.0;
    row += w0.x * umbrage_lit_at(map, size, float2(p0.x, p1.y), receiver);
    row += w1.x * umbrage_lit_at(map, size, float2(p1.x, p1.y), receiver);
    row += w2.x * umbrage_lit_at(map, size, float2(p2.x, p1.y), receiver);
    n += w1.y * row;
    row = 0.0;
    row += w0.x * umbrage_lit_at(map, size, float2(p0.x, p2.y), receiver);
    row += w1.x * umbrage_lit_at(map, size, float2(p1.x, p2.y), receiver);
    row += w2.x * umbrage_lit_at(map, size, float2(p2.x, p2.y), receiver);
    n += w2.y * row;
    float share = metal::clamp(n / (whole * whole), 0.0, 1.0);
    float visibility = umbrage_within_far_plane(receiver) ? share : 0.0;
    return compared ? visibility : 1.0;
}
`,
            "window_hardware7": `
// umbrage_window_hardware7: lit share under weights that slide over the map, by the sampler; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   k0 .. k3  weights from the edge to the middle one; the others mirror them
inline float umbrage_window_hardware7(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float k0, float k1,
                                      float k2, float k3) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 x = compared ? coord - 0.5 : float2(0.0, 0.0);
    float2 texel = metal::floor(x);
    float2 s = x - texel;
    float whole = k0 + k1 + k2 + k3 + k2 + k1 + k0;
    float2 b0 = k1 + s * (k0 - k1);
    float2 w0 = k0 + k1 - s * k1;
    float2 p0 = (texel - 2.5 + b0 / w0) / size;
    float2 b1 = k3 + s * (k2 - k3);
    float2 w1 = k2 + k3 + s * (k1 - k3);
    float2 p1 = (texel - 0.5 + b1 / w1) / size;
    float2 b2 = k1 + s * (k2 - k1);
    float2 w2 = k2 + k1 + s * (k3 - k1);
    float2 p2 = (texel + 1.5 + b2 / w2) / size;
    float2 b3 = s * k0;
    float2 w3 = k0 + s * k1;
    float2 p3 = (texel + 3.5 + b3 / w3) / size;
    float n = 0.0;
    float row = 0.0;
    row += w0.x * umbrage_lit_at(map, size, float2(p0.x, p0.y), receiver);
    row += w1.x * umbrage_lit_at(map, size, float2(p1.x, p0.y), receiver);
    row += w2.x * umbrage_lit_at(map, size, float2(p2.x, p0.y), receiver);
    row += w3.x * umbrage_lit_at(map, size, float2(p3.x, p0.y), receiver);
    n += w0.y * row;
    row = 0.0;
    row += w0.x * umbrage_lit_at(map, size, float2(p0.x, p1.y), receiver);
    row += w1.x * umbrage_lit_at(map, size, float2(p1.x, p1.y), receiver);
    row += w2.x * umbrage_lit_at(map, size, float2(p2.x, p1.y), receiver);
    row += w3.x * umbrage_lit_at(map, size, float2(p3.x, p1.y), receiver);
    n += w1.y * row;
    row = 0.0;
    row += w0.x * umbrage_lit_at(map, size, float2(p0.x, p2.y), receiver);
    row += w1.x * umbrage_lit_at(map, size, float2(p1.x, p2.y), receiver);
    row += w2.x * umbrage_lit_at(map, size, float2(p2.x, p2.y), receiver);
    row += w3.x * umbrage_lit_at(map, size, float2(p3.x, p2.y), receiver);
    n += w2.y * row;
    row = 0.0;
    row += w0.x * umbrage_lit_at(map, size, float2(p0.x, p3.y), receiver);
    row += w1.x * umbrage_lit_at(map, size, float2(p1.x, p3.y), receiver);
    row += w2.x * umbrage_lit_at(map, size, float2(p2.x, p3.y), receiver);
    row += w3.x * umbrage_lit_at(map, size, float2(p3.x, p3.y), receiver);
    n += w3.y * row;
    float share = metal::clamp(n / (whole * whole), 0.0, 1.0);
    float visibility = umbrage_within_far_plane(receiver) ? share : 0.0;
    return compared ? visibility : 1.0;
}
`,
            "disc_hardware8": `
// umbrage_disc_hardware8: 8 points of a disc, each compared and weighted by the sampler; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   radius  in texels, at most 255.9375;   rotation  umbrage_disc_rotation of the pixel
inline float umbrage_disc_hardware8(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float radius,
                                    float2 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 center = (compared ? coord : float2(0.0, 0.0)) / size;
    float2 scaled = rotation * ((radius > 0.0 ? metal::min(radius, 255.9375) : 0.0) * (1.0 / 1024.0));
    float2 x = scaled / size;
    float2 y = float2(0.0 - scaled.y, scaled.x) / size;
    float n = 0.0;
    n += umbrage_lit_at(map, size, center + x * 3.0 - y * 1.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 4.0 + y * 5.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 1.0 - y * 11.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 9.0 - y * 8.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 12.0 + y * 3.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 11.0 + y * 6.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 0.0 + y * 13.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 11.0 - y * 7.0, receiver);
    float visibility = umbrage_within_far_plane(receiver) ? n * (1.0 / 8.0) : 0.0;
    return compared ? visibility : 1.0;
}
`,
            "disc_hardware16": `
// umbrage_disc_hardware16: 16 points of a disc, each compared and weighted by the sampler; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   radius  in texels, at most 255.9375;   rotation  umbrage_disc_rotation of the pixel
inline float umbrage_disc_hardware16(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float radius,
                                     float2 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 center = (compared ? coord : float2(0.0, 0.0)) / size;
    float2 scaled = rotation * ((radius > 0.0 ? metal::min(radius, 255.9375) : 0.0) * (1.0 / 1024.0));
    float2 x = scaled / size;
    float2 y = float2(0.0 - scaled.y, scaled.x) / size;
    float n = 0.0;
    n += umbrage_lit_at(map, size, center + x * 1.0 - y * 3.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 5.0 + y * 2.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 5.0 + y * 2.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 0.0 + y * 7.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 6.0 - y * 5.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 8.0 - y * 5.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 0.0 - y * 11.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 11.0 + y * 5.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 12.0 + y * 4.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 1.0 + y * 13.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 7.0 + y * 11.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 9.0 + y * 10.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 13.0 - y * 4.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 7.0 - y * 12.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 7.0 - y * 12.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 14.0 - y * 2.0, receiver);
    float visibility = umbrage_within_far_plane(receiver) ? n * (1.0 / 16.0) : 0.0;
    return compared ? visibility : 1.0;
}
`,
            "disc_hardware32": `
// umbrage_disc_hardware32: 32 points of a disc, each compared and weighted by the sampler; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   radius  in texels, at most 255.9375;   rotation  umbrage_disc_rotation of the pixel
inline float umbrage_disc_hardware32(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float radius,
                                     float2 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 center = (compared ? coord : float2(0.0, 0.0)) / size;
    float2 scaled = rotation * ((radius > 0.0 ? metal::min(radius, 255.9375) : 0.0) * (1.0 / 1024.0));
    float2 x = scaled / size;
    float2 y = float2(0.0 - scaled.y, scaled.x) / size;
    float n = 0.0;
    n += umbrage_lit_at(map, size, center - x * 2.0 - y * 1.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 3.0 + y * 2.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 1.0 - y * 4.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 4.0 + y * 3.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 0.0 + y * 6.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 5.0 - y * 5.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 7.0 - y * 2.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 8.0 - y * 1.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 8.0 + y * 3.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 5.0 + y * 7.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 1.0 - y * 9.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 6.0 - y * 7.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 8.0 + y * 5.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 0.0 + y * 10.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 3.0 - y * 10.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 6.0 + y * 10.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 9.0 - y * 8.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 11.0 - y * 5.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 5.0 - y * 12.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 13.0 - y * 1.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 7.0 + y * 11.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 13.0 + y * 3.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 13.0 + y * 4.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 10.0 - y * 10.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 14.0 - y * 2.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 11.0 + y * 9.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 3.0 + y * 14.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 13.0 - y * 6.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 12.0 + y * 8.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 4.0 + y * 14.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 7.0 - y * 13.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 0.0 - y * 15.0, receiver);
    float visibility = umbrage_within_far_plane(receiver) ? n * (1.0 / 32.0) : 0.0;
    return compared ? visibility : 1.0;
}
`,
            "bounds_lit": `
// umbrage_bounds_lit: 1.0 where all texels of a filter are lit, 0.0 where none is, else -1.0: ask the filter
//   bounds, size  a map of the texels' least and greatest depths, and its size in texels;   place  what goes with it
//   coord, receiver  as the filter takes them
inline float umbrage_bounds_lit(UMBRAGE_MAP bounds, float2 size, float2 coord, float receiver, float2 place) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 x = compared ? metal::floor(coord * 256.0) : float2(0.0, 0.0);
    float4 b = umbrage_fetch_clamped(bounds, size, metal::floor((x + place.x) * place.y));
    float all = umbrage_compare(receiver, b.x);
    float some = umbrage_compare(receiver, b.y);
    float known = b.x <= b.y && all == some ? all : -1.0;  // not of a NaN
    return compared ? known : 1.0;
}
`,
            "distance_code": `
// umbrage_distance_code: a depth as whole number from 0.0 at the near plane to 65535.0, also where depth is reversed
inline float umbrage_distance_code(float depth) {
    float v = depth * 65536.0;
    float forward = v < 65535.0 ? metal::floor(metal::max(v, 0.0)) : 65535.0;
    float reversed = v > 0.0 ? metal::floor(metal::min(v, 65535.0)) : 0.0;
    return umbrage_cleared_depth() > 0.5 ? forward : 65535.0 - reversed;
}
`,
            "penumbra": `
// umbrage_penumbra: radius in 1/16 texel, a whole number
//   apart     umbrage_distance_code of the receiver less that of the blocker
//   softness  (1/16 texel a code, min_radius, max_radius), of make_penumbra_params
inline float umbrage_penumbra(float apart, float3 softness) {
    return metal::min(metal::max(metal::floor(apart * softness.x), softness.y), softness.z);
}
`,
            "blocker": `
// umbrage_blocker: (1.0, umbrage_distance_code) of a texel before the receiver, of any other (0.0, 0.0)
inline float2 umbrage_blocker(UMBRAGE_MAP map, float2 size, float2 texel, float receiver) {
    float stored = umbrage_fetch_depth(map, size, texel);
    float code = umbrage_distance_code(stored);
    return umbrage_compare(receiver, stored) > 0.5 ? float2(0.0, 0.0) : float2(1.0, code);
}
`,
            "blockers8": `
// umbrage_blockers8: how many of a disc's 8 points fall on texels before the receiver, and the sum of their codes
//   map, size  shadow map and its size in texels;   position  floor(256 coord) of the receiver;   receiver  biased
//   radius     in 1/16 texel, a whole number from 0 to 4095;   rotation  umbrage_disc_rotation of the pixel
inline float2 umbrage_blockers8(UMBRAGE_MAP map, float2 size, float2 position, float receiver, float radius,
                                float2 rotation) {
    float2 n = float2(0.0, 0.0);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(3.0, -1.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-4.0, 5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(1.0, -11.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-9.0, -8.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-12.0, 3.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(11.0, 6.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(0.0, 13.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(11.0, -7.0), rotation, radius), receiver);
    return n;
}
`,
            "blockers16": `
// umbrage_blockers16: how many of a disc's 16 points fall on texels before the receiver, and the sum of their codes
//   map, size  shadow map and its size in texels;   position  floor(256 coord) of the receiver;   receiver  biased
//   radius     in 1/16 texel, a whole number from 0 to 4095;   rotation  umbrage_disc_rotation of the pixel
inline float2 umbrage_blockers16(UMBRAGE_MAP map, float2 size, float2 position, float receiver, float radius,
                                 float2 rotation) {
    float2 n = float2(0.0, 0.0);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(1.0, -3.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(5.0, 2.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-5.0, 2.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(0.0, 7.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-6.0, -5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(8.0, -5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(0.0, -11.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(11.0, 5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-12.0, 4.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-1.0, 13.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(7.0, 11.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-9.0, 10.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-13.0, -4.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(7.0, -12.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-7.0, -12.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(14.0, -2.0), rotation, radius), receiver);
    return n;
}
`,
            "blockers32": `
// umbrage_blockers32: how many of a disc's 32 points fall on texels before the receiver, and the sum of their codes
//   map, size  shadow map and its size in texels;   position  floor(256 coord) of the receiver;   receiver  biased
//   radius     in 1/16 texel, a whole number from 0 to 4095;   rotation  umbrage_disc_rotation of the pixel
inline float2 umbrage_blockers32(UMBRAGE_MAP map, float2 size, float2 position, float receiver, float radius,
                                 float2 rotation) {
    float2 n = float2(0.0, 0.0);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-2.0, -1.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(3.0, 2.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(1.0, -4.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-4.0, 3.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(0.0, 6.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-5.0, -5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(7.0, -2.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-8.0, -1.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(8.0, 3.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(5.0, 7.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(1.0, -9.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(6.0, -7.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-8.0, 5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(0.0, 10.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-3.0, -10.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-6.0, 10.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-9.0, -8.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(11.0, -5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(5.0, -12.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-13.0, -1.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(7.0, 11.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(13.0, 3.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-13.0, 4.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(10.0, -10.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(14.0, -2.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-11.0, 9.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(3.0, 14.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-13.0, -6.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(12.0, 8.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-4.0, 14.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-7.0, -13.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(0.0, -15.0), rotation, radius), receiver);
    return n;
}
`,
            "pcss8": `
// umbrage_pcss8: percentage-closer soft shadows, 8 points twice; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   softness  of make_penumbra_params;  rotation  umbrage_disc_rotation of the pixel
inline float umbrage_pcss8(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float3 softness,
                           float2 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 at = compared ? metal::floor(coord * 256.0) : float2(0.0, 0.0);
    float z = umbrage_distance_code(receiver);
    float search_radius = umbrage_penumbra(z, softness);
    float2 found = umbrage_blockers8(map, size, at, receiver, search_radius, rotation);
    float mean = umbrage_floor_divide(found.y, metal::max(found.x, 1.0));
    float radius = umbrage_penumbra(z - mean, softness);
    // without a blocker the radius is the search's, whose points are all lit
    return umbrage_disc8(map, size, coord, receiver, radius * (1.0 / 16.0), rotation);
}
`,
            "pcss16": `
// umbrage_pcss16: percentage-closer soft shadows, 16 points twice; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   softness  of make_penumbra_params;  rotation  umbrage_disc_rotation of the pixel
inline float umbrage_pcss16(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float3 softness,
                            float2 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 at = compared ? metal::floor(coord * 256.0) : float2(0.0, 0.0);
    float z = umbrage_distance_code(receiver);
    float search_radius = umbrage_penumbra(z, softness);
    float2 found = umbrage_blockers16(map, size, at, receiver, search_radius, rotation);
    float mean = umbrage_floor_divide(found.y, metal::max(found.x, 1.0));
    float radius = umbrage_penumbra(z - mean, softness);
    // without a blocker the radius is the search's, whose points are all lit
    return umbrage_disc16(map, size, coord, receiver, radius * (1.0 / 16.0), rotation);
}
`,
            "pcss32": `
// umbrage_pcss32: percentage-closer soft shadows, 32 points twice; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   softness  of make_penumbra_params;  rotation  umbrage_disc_rotation of the pixel
inline float umbrage_pcss32(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float3 softness,
                            float2 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 at = compared ? metal::floor(coord * 256.0) : float2(0.0, 0.0);
    float z = umbrage_distance_code(receiver);
    float search_radius = umbrage_penumbra(z, softness);
    float2 found = umbrage_blockers32(map, size, at, receiver, search_radius, rotation);
    float mean = umbrage_floor_divide(found.y, metal::max(found.x, 1.0));
    float radius = umbrage_penumbra(z - mean, softness);
    // without a blocker the radius is the search's, whose points are all lit
    return umbrage_disc32(map, size, coord, receiver, radius * (1.0 / 16.0), rotation);
}
`,
            "blocker_at": `
// umbrage_blocker_at: (1.0, depth) of the texel at a point where it is before the receiver, else (0.0, 0.0)
//   uv  over the map, (0.0, 0.0) to (1.0, 1.0), no NaN
inline float2 umbrage_blocker_at(UMBRAGE_MAP map, float2 size, float2 uv, float receiver) {
    float stored = umbrage_depth_at(map, size, uv);
    return umbrage_compare(receiver, stored) > 0.5 ? float2(0.0, 0.0) : float2(1.0, stored);
}
`,
            "pcss_radius": `
// umbrage_pcss_radius: radius of a penumbra in texels; without a blocker that of one at the near plane
//   found     (how many blockers, the sum of their depths);   receiver  depth, biased
//   softness  (1/16 texel a code, min_radius, max_radius), of make_penumbra_params
inline float umbrage_pcss_radius(float2 found, float receiver, float3 softness) {
    bool forward = umbrage_cleared_depth() > 0.5;
    float mean = found.x > 0.5 ? found.y / found.x : (forward ? 0.0 : 1.0);
    float radius = (forward ? receiver - mean : mean - receiver) * (softness.x * 4096.0);
    float min_radius = softness.y * 0.0625;
    return radius > min_radius ? metal::min(radius, softness.z * 0.0625) : min_radius;
}
`,
            "blockers_hardware8": `
// umbrage_blockers_hardware8: of the texels at 8 points of a disc those before the receiver: (how many, depths' sum)
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   radius  in texels, at most 255.9375;   rotation  umbrage_disc_rotation of the pixel
inline float2 umbrage_blockers_hardware8(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float radius,
                                         float2 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 center = (compared ? coord : float2(0.0, 0.0)) / size;
    float2 scaled = rotation * ((radius > 0.0 ? metal::min(radius, 255.9375) : 0.0) * (1.0 / 1024.0));
    float2 x = scaled / size;
    float2 y = float2(0.0 - scaled.y, scaled.x) / size;
    float2 n = float2(0.0, 0.0);
    n += umbrage_blocker_at(map, size, center + x * 3.0 - y * 1.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 4.0 + y * 5.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 1.0 - y * 11.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 9.0 - y * 8.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 12.0 + y * 3.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 11.0 + y * 6.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 0.0 + y * 13.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 11.0 - y * 7.0, receiver);
    return compared ? n : float2(0.0, 0.0);
}
`,
            "blockers_hardware16": `
// umbrage_blockers_hardware16: of the texels at 16 points of a disc those before the receiver: (how many, depths' sum)
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   radius  in texels, at most 255.9375;   rotation  umbrage_disc_rotation of the pixel
inline float2 umbrage_blockers_hardware16(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float radius,
                                          float2 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 center = (compared ? coord : float2(0.0, 0.0)) / size;
    float2 scaled = rotation * ((radius > 0.0 ? metal::min(radius, 255.9375) : 0.0) * (1.0 / 1024.0));
    float2 x = scaled / size;
    float2 y = float2(0.0 - scaled.y, scaled.x) / size;
    float2 n = float2(0.0, 0.0);
    n += umbrage_blocker_at(map, size, center + x * 1.0 - y * 3.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 5.0 + y * 2.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 5.0 + y * 2.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 0.0 + y * 7.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 6.0 - y * 5.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 8.0 - y * 5.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 0.0 - y * 11.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 11.0 + y * 5.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 12.0 + y * 4.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 1.0 + y * 13.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 7.0 + y * 11.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 9.0 + y * 10.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 13.0 - y * 4.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 7.0 - y * 12.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 7.0 - y * 12.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 14.0 - y * 2.0, receiver);
    return compared ? n : float2(0.0, 0.0);
}
`,
            "blockers_hardware32": `
// umbrage_blockers_hardware32: of the texels at 32 points of a disc those before the receiver: (how many, depths' sum)
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   radius  in texels, at most 255.9375;   rotation  umbrage_disc_rotation of the pixel
inline float2 umbrage_blockers_hardware32(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float radius,
                                          float2 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 center = (compared ? coord : float2(0.0, 0.0)) / size;
    float2 scaled = rotation * ((radius > 0.0 ? metal::min(radius, 255.9375) : 0.0) * (1.0 / 1024.0));
    float2 x = scaled / size;
    float2 y = float2(0.0 - scaled.y, scaled.x) / size;
    float2 n = float2(0.0, 0.0);
    n += umbrage_blocker_at(map, size, center - x * 2.0 - y * 1.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 3.0 + y * 2.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 1.0 - y * 4.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 4.0 + y * 3.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 0.0 + y * 6.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 5.0 - y * 5.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 7.0 - y * 2.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 8.0 - y * 1.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 8.0 + y * 3.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 5.0 + y * 7.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 1.0 - y * 9.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 6.0 - y * 7.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 8.0 + y * 5.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 0.0 + y * 10.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 3.0 - y * 10.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 6.0 + y * 10.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 9.0 - y * 8.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 11.0 - y * 5.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 5.0 - y * 12.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 13.0 - y * 1.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 7.0 + y * 11.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 13.0 + y * 3.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 13.0 + y * 4.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 10.0 - y * 10.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 14.0 - y * 2.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 11.0 + y * 9.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 3.0 + y * 14.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 13.0 - y * 6.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 12.0 + y * 8.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 4.0 + y * 14.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 7.0 - y * 13.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 0.0 - y * 15.0, receiver);
    return compared ? n : float2(0.0, 0.0);
}
`,
            "hardened_kernel8": `
// umbrage_hardened_kernel8: the share of 8 points in shadow, steepened
//   blocked  how many;   ratio  of the penumbra to the disc in 1/256, a whole number: 256.0 leaves the share as it is
inline float umbrage_hardened_kernel8(float blocked, float ratio) {
    float u = blocked * 2.0 - 8.0;
    float d = metal::max(8.0 - metal::abs(u), 0.0);  // not negative already: no sum is regrouped across the max
    float steep = 512.0 - d * d * d;
    float hard = u < 0.0 ? 512.0 - steep : 512.0 + steep;
    return (hard * (256.0 - ratio) + blocked * ratio * 128.0) * (1.0 / 262144.0);
}
`,
            "hardened_kernel16": `
// umbrage_hardened_kernel16: the share of 16 points in shadow, steepened
//   blocked  how many;   ratio  of the penumbra to the disc in 1/256, a whole number: 256.0 leaves the share as it is
inline float umbrage_hardened_kernel16(float blocked, float ratio) {
    float u = blocked * 2.0 - 16.0;
    float d = metal::max(16.0 - metal::abs(u), 0.0);  // not negative already: no sum is regrouped across the max
    float steep = 4096.0 - d * d * d;
    float hard = u < 0.0 ? 4096.0 - steep : 4096.0 + steep;
    return (hard * (256.0 - ratio) + blocked * ratio * 512.0) * (1.0 / 2097152.0);
}
`,
            "hardened_kernel32": `
// umbrage_hardened_kernel32: the share of 32 points in shadow, steepened
//   blocked  how many;   ratio  of the penumbra to the disc in 1/256, a whole number: 256.0 leaves the share as it is
inline float umbrage_hardened_kernel32(float blocked, float ratio) {
    float u = blocked * 2.0 - 32.0;
    float d = metal::max(32.0 - metal::abs(u), 0.0);  // not negative already: no sum is regrouped across the max
    float steep = 32768.0 - d * d * d;
    float hard = u < 0.0 ? 32768.0 - steep : 32768.0 + steep;
    return (hard * (256.0 - ratio) + blocked * ratio * 2048.0) * (1.0 / 16777216.0);
}
`,
            "dpcf8": `
// umbrage_dpcf8: contact hardening by 8 points; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   softness  of make_penumbra_params;  rotation  umbrage_disc_rotation of the pixel
inline float umbrage_dpcf8(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float3 softness,
                           float2 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 at = compared ? metal::floor(coord * 256.0) : float2(0.0, 0.0);
    float z = umbrage_distance_code(receiver);
    float search_radius = umbrage_penumbra(z, softness);
    float2 found = umbrage_blockers8(map, size, at, receiver, search_radius, rotation);
    float mean = umbrage_floor_divide(found.y, metal::max(found.x, 1.0));
    float radius = umbrage_penumbra(z - mean, softness);
    float ratio = umbrage_floor_divide(radius * 256.0, metal::max(search_radius, 1.0));
    float dark = umbrage_hardened_kernel8(found.x, ratio);
    return compared ? metal::clamp(1.0 - dark, 0.0, 1.0) : 1.0;
}
`,
            "dpcf16": `
// umbrage_dpcf16: contact hardening by 16 points; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   softness  of make_penumbra_params;  rotation  umbrage_disc_rotation of the pixel
inline float umbrage_dpcf16(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float3 softness,
                            float2 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 at = compared ? metal::floor(coord * 256.0) : float2(0.0, 0.0);
    float z = umbrage_distance_code(receiver);
    float search_radius = umbrage_penumbra(z, softness);
    float2 found = umbrage_blockers16(map, size, at, receiver, search_radius, rotation);
    float mean = umbrage_floor_divide(found.y, metal::max(found.x, 1.0));
    float radius = umbrage_penumbra(z - mean, softness);
    float ratio = umbrage_floor_divide(radius * 256.0, metal::max(search_radius, 1.0));
    float dark = umbrage_hardened_kernel16(found.x, ratio);
    return compared ? metal::clamp(1.0 - dark, 0.0, 1.0) : 1.0;
}
`,
            "dpcf32": `
// umbrage_dpcf32: contact hardening by 32 points; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   softness  of make_penumbra_params;  rotation  umbrage_disc_rotation of the pixel
inline float umbrage_dpcf32(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float3 softness,
                            float2 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 at = compared ? metal::floor(coord * 256.0) : float2(0.0, 0.0);
    float z = umbrage_distance_code(receiver);
    float search_radius = umbrage_penumbra(z, softness);
    float2 found = umbrage_blockers32(map, size, at, receiver, search_radius, rotation);
    float mean = umbrage_floor_divide(found.y, metal::max(found.x, 1.0));
    float radius = umbrage_penumbra(z - mean, softness);
    float ratio = umbrage_floor_divide(radius * 256.0, metal::max(search_radius, 1.0));
    float dark = umbrage_hardened_kernel32(found.x, ratio);
    return compared ? metal::clamp(1.0 - dark, 0.0, 1.0) : 1.0;
}
`,
            "box_moments": `
// umbrage_box_moments: (mean, rest, high, low) of the codes in a box of n texels: their sum is n mean + rest, and
//   that of their squared distances from mean 4096 high + low;  whole numbers
//   map, size  a table of make_variance_table and its size;   first, end  of the box, first < end
inline float4 umbrage_box_moments(UMBRAGE_MAP map, float2 size, float2 first, float2 end) {
    float4 a = umbrage_texel(map, size, end);
    float4 b = umbrage_texel(map, size, float2(first.x, end.y));
    float4 c = umbrage_texel(map, size, float2(end.x, first.y));
    float4 d = umbrage_texel(map, size, first);
    float4 part = (a - b) - (c - d);
    float2 low = float2(part.x, part.z);
    float2 carry = metal::floor(low * (1.0 / 65536.0));
    float2 above = float2(part.y, part.w) + carry;
    // nothing below is negative; compilers cannot regroup sums across a max
    low = metal::max(low - carry * 65536.0, float2(0.0, 0.0));
    above = metal::max(above - metal::floor(above * (1.0 / 65536.0)) * 65536.0, float2(0.0, 0.0));
    float sum = above.x * 65536.0 + low.x;
    float2 sides = metal::max(end - first, float2(1.0, 1.0));
    float n = sides.x * sides.y;
    float mean = umbrage_floor_divide(sum, n);
    float rest = metal::max(sum - mean * n, 0.0);
    float2 digits = float2(sum + rest, low.y);
    float2 high = metal::floor(digits * (1.0 / 4096.0));
    digits = metal::max(digits - high * 4096.0, float2(0.0, 0.0));
    float below = digits.y - mean * digits.x;
    float borrow = metal::floor(below * (1.0 / 4096.0));
    float wide = above.y * 16.0 + high.y - mean * high.x + borrow;
    wide = wide - metal::floor(wide * (1.0 / 1048576.0)) * 1048576.0;
    return float4(mean, rest, wide, below - borrow * 4096.0);
}
`,
            "summed_variance": `
// umbrage_summed_variance: variance shadow from a summed-area table; visibility, 1.0 is lit
//   map, size  the table, of make_variance_table, and its size: one more than the shadow map's
//   coord, receiver  in texels of the shadow map, first center at (0.5, 0.5), and depth, biased
//   radius     whole: the box has 2 radius + 1 texels a side;   codes  2^bits of the table
inline float umbrage_summed_variance(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float radius,
                                     float codes) {
    float2 last = size - 1.0;
    bool compared = umbrage_map_covers(last, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    float2 texel = compared ? metal::clamp(metal::floor(coord), float2(0.0, 0.0), last - 1.0) : float2(0.0, 0.0);
    float2 first = metal::max(texel - radius, float2(0.0, 0.0));
    float2 end = metal::min(texel + radius + 1.0, last);
    float4 m = umbrage_box_moments(map, size, first, end);
    float2 sides = end - first;
    float n = sides.x * sides.y;
    float share = m.y / n;
    float variance = (m.z * 4096.0 + (m.w - m.y)) / n + share * (1.0 - share);
    float scaled = receiver * codes;
    float t = umbrage_cleared_depth() > 0.5 ? scaled : codes - scaled;
    float d = (t - 1.0 - m.x) - share;
    float behind = d > 0.0 ? variance / (variance + d * d) : 0.0;
    return compared ? (d <= 0.0 ? 1.0 : behind) : 1.0;
}
`,
            "box_mean": `
// umbrage_box_mean: mean of four whole numbers below 65536.0 over a box
//   map, size  a table of make_moment_table and its size;   first, end  of the box, first < end
inline float4 umbrage_box_mean(UMBRAGE_MAP map, float2 size, float2 first, float2 end) {
    float right = size.x * 0.5;
    float4 a = umbrage_texel(map, size, end);
    float4 b = umbrage_texel(map, size, float2(first.x, end.y));
    float4 c = umbrage_texel(map, size, float2(end.x, first.y));
    float4 d = umbrage_texel(map, size, first);
    float4 low = (a - b) - (c - d);
    float4 carry = metal::floor(low * (1.0 / 65536.0));
    a = umbrage_texel(map, size, float2(right + end.x, end.y));
    b = umbrage_texel(map, size, float2(right + first.x, end.y));
    c = umbrage_texel(map, size, float2(right + end.x, first.y));
    d = umbrage_texel(map, size, float2(right + first.x, first.y));
    float4 above = (a - b) - (c - d) + carry;
    float4 high = above - metal::floor(above * (1.0 / 65536.0)) * 65536.0;
    float4 sum = high * 65536.0 + (low - carry * 65536.0);
    float2 sides = end - first;
    return sum / (sides.x * sides.y);
}
`,
            "from_optimized_moments": `
// umbrage_from_optimized_moments: four moments of what umbrage_to_optimized_moments made of them
inline float4 umbrage_from_optimized_moments(float4 o) {
    float x = o.x - 0.5;
    float z = o.z - 0.5;
    float eighth = o.y * 0.125;
    float b1 = z * 1.73205078 - x * 0.333333343;
    float b2 = o.w + eighth;
    float b3 = z * 1.29903817 - x * 0.75;
    float b4 = o.w - eighth;
    return float4(b1, b2, b3, b4);
}
`,
            "bias_moments": `
// umbrage_bias_moments: moments moved by a share bias.x towards (0.0, bias.y, 0.0, bias.y)
inline float4 umbrage_bias_moments(float4 b, float2 bias) {
    float x = b.x - b.x * bias.x;
    float y = b.y + (bias.y - b.y) * bias.x;
    float z = b.z - b.z * bias.x;
    float w = b.w + (bias.y - b.w) * bias.x;
    return float4(x, y, z, w);
}
`,
            "to_forward_depth": `
// umbrage_to_forward_depth: depth that grows with distance, 1.0 - depth where the map's is reversed
inline float umbrage_to_forward_depth(float depth) {
    return umbrage_cleared_depth() < 0.5 ? 1.0 - depth : depth;
}
`,
            "moment_atoms": `
// umbrage_moment_atoms: the two depths that beside the receiver's have the same moments, less b.x, and their shares
//   b  moments, biased;   x  the receiver's depth on -1.0 to 1.0 less b.x
inline float4 umbrage_moment_atoms(float4 b, float x) {
    float d = b.y - b.x * b.x;
    float third = b.z - b.x * b.y;
    float l = third / d;
    float e = (b.w - b.y * b.y) - third * l;
    float h = b.x * 2.0 - l;
    float a = d * ((x + h) * x - d);
    float m = x * e + h * a;
    float c = d * (e - a);
    float square = m * m - 4.0 * a * c;
    float root = metal::sqrt(square > 0.0 ? square : 0.0);
    float w = (m < 0.0 ? root - m : -(m + root)) * 0.5;
    float2 t = float2(w / a, c / w);
    float2 q = (t + h) * t - d;
    float least = d * e;
    float2 sum = least + (t * t * e + q * q * d);
    return float4(t.x, t.y, least / sum.x, least / sum.y);
}
`,
            "decode_msm": `
// umbrage_decode_msm: visibility of a receiver, at least its lit share less bias.x; 1.0 is lit
//   b  mean of texels;   receiver  depth, biased
//   bias  (3e-6, 0.375) of floats of 32 bits, (6e-5, 0.628) of channels of 16
inline float umbrage_decode_msm(float4 b, float receiver, float2 bias) {
    float d = umbrage_to_forward_depth(receiver);
    float4 m = umbrage_bias_moments(b, bias);
    float x = ((d > 0.0 ? (d < 1.0 ? d : 1.0) : 0.0) * 2.0 - 1.0) - m.x;
    float4 atoms = umbrage_moment_atoms(m, x);
    float first = atoms.x < x ? atoms.z : 0.0;
    float second = atoms.y < x ? atoms.w : 0.0;
    float lit = 1.0 - (first + second);
    bool known = metal::abs(atoms.z + atoms.w) <= 4294967296.0;  // what is no NaN
    lit = known ? (lit > 0.0 ? (lit < 1.0 ? lit : 1.0) : 0.0) : (x <= 0.0 ? 1.0 : 0.0);
    return d > 0.0 ? lit : (d <= 0.0 ? lit : 0.0);
}
`,
            "summed_moments": `
// umbrage_summed_moments: moment shadow from a summed-area table; visibility, 1.0 is lit
//   map, size  the table, of make_moment_table, and its size: twice the shadow map's width and two, its height and one
//   coord, receiver  in texels of the shadow map, first center at (0.5, 0.5), and depth, biased
//   radius     whole: the box has 2 radius + 1 texels a side;   bias  (6e-5, 0.628)
inline float umbrage_summed_moments(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float radius,
                                    float2 bias) {
    float2 last = float2(size.x * 0.5, size.y) - 1.0;
    bool compared = umbrage_map_covers(last, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    float2 texel = compared ? metal::clamp(metal::floor(coord), float2(0.0, 0.0), last - 1.0) : float2(0.0, 0.0);
    float2 first = metal::max(texel - radius, float2(0.0, 0.0));
    float2 end = metal::min(texel + radius + 1.0, last);
    float4 turned = umbrage_box_mean(map, size, first, end) * (1.0 / 65535.0);
    float lit = umbrage_decode_msm(umbrage_from_optimized_moments(turned), receiver, bias);
    return compared ? lit : 1.0;
}
`,
            "power_of_two": `
// umbrage_power_of_two: 2^n of a whole number n, -64.0 to 63.0
inline float umbrage_power_of_two(float n) {
    uint exponent = uint(n + 127.0);
    return as_type<float>(exponent << 23);
}
`,
            "exp2_polynomial": `
// umbrage_exp2_polynomial: 2^y, off by at most 1.8e-7 of it
//   y  outside of -64.0 to 63.0 the nearer end counts, of NaN -64.0
inline float umbrage_exp2_polynomial(float y) {
    float x = y > -64.0 ? metal::min(y, 63.0) : -64.0;
    float n = metal::floor(x);
    float f = x - n;
    float p = 0.00187931862 * f + 0.00899099465;
    p = p * f + 0.0558186769;
    p = p * f + 0.240159273;
    p = p * f + 0.693151712;
    p = p * f + 1.0;
    return p * umbrage_power_of_two(n);
}
`,
            "exp2_steps": `
// umbrage_exp2_steps: 2^y, a whole number below 2^12 times a power of two, y rounded down to 1/2048
//   y  outside of -64.0 to 63.0 the nearer end counts, of NaN -64.0
inline float umbrage_exp2_steps(float y) {
    float x = metal::floor((y > -64.0 ? metal::min(y, 63.0) : -64.0) * 2048.0);
    float n = metal::floor(x * (1.0 / 2048.0));
    float f = metal::max(x - n * 2048.0, 0.0);  // not negative already: no sum is regrouped across the max
    float g = metal::floor(f * (2048.0 - f) * (1.0 / 256.0));
    float r = 1251.0 + metal::floor(f * 314.0 * (1.0 / 2048.0));
    float m = 2048.0 + f - metal::floor((g * r + 16384.0) * (1.0 / 32768.0));
    return m * (1.0 / 2048.0) * umbrage_power_of_two(n);
}
`,
            "chebyshev": `
// umbrage_chebyshev: share of depths that may be as far as the receiver or farther, at most; 0.0 where something is NaN
//   m  mean of the depths, mean of their squares;   receiver  on the same scale;   min_variance  0.0 or more
inline float umbrage_chebyshev(float2 m, float receiver, float min_variance) {
    float difference = m.y - m.x * m.x;
    float variance = difference > min_variance ? difference : min_variance;
    float distance = receiver - m.x;
    float sum = variance + distance * distance;
    float p = variance / sum;
    return receiver <= m.x ? 1.0 : (p > 0.0 ? metal::min(p, 1.0) : 0.0);  // a GPU's v / v may be more than 1.0
}
`,
            "reduce_light_bleeding": `
// umbrage_reduce_light_bleeding: visibility from amount to 1.0 stretched to 0.0 to 1.0: less light bleeds
inline float umbrage_reduce_light_bleeding(float visibility, float amount) {
    float stretched = (visibility - amount) / (1.0 - amount);
    return visibility > amount ? stretched : 0.0;
}
`,
            "encode_vsm": `
// umbrage_encode_vsm: depth and its square, of depth that grows with distance; NaN counts as far
inline float2 umbrage_encode_vsm(float depth) {
    float d = umbrage_to_forward_depth(umbrage_saturate(depth));
    return float2(d, d * d);
}
`,
            "decode_vsm": `
// umbrage_decode_vsm: visibility of a receiver, at least its lit share; 1.0 is lit
//   m  mean of texels;   receiver  depth, biased;   min_variance  0.0 or more
inline float umbrage_decode_vsm(float2 m, float receiver, float min_variance) {
    return umbrage_chebyshev(m, umbrage_to_forward_depth(receiver), min_variance);
}
`,
            "encode_deviation": `
// umbrage_encode_deviation: mean and mean square of depths to mean and twice the standard deviation, each 0.0 to 1.0
inline float2 umbrage_encode_deviation(float2 m) {
    float variance = m.y - m.x * m.x;
    return float2(m.x, 2.0 * metal::sqrt(variance > 0.0 ? variance : 0.0));
}
`,
            "decode_deviation": `
// umbrage_decode_deviation: mean and twice the standard deviation to mean and mean square of depths
inline float2 umbrage_decode_deviation(float2 held) {
    float half_of_it = held.y * 0.5;
    float square = held.x * held.x + half_of_it * half_of_it;
    return float2(held.x, square);
}
`,
            "decode_deviation_rgba8": `
// umbrage_decode_deviation_rgba8: mean and deviation, two channels each, as sampled, to mean and mean square of depths
inline float2 umbrage_decode_deviation_rgba8(float4 c) {
    float mean = umbrage_decode_rg16(float2(c.x, c.y), 1.0);
    float deviation = umbrage_decode_rg16(float2(c.z, c.w), 1.0);
    return umbrage_decode_deviation(float2(mean, deviation));
}
`,
            "exponential_warp": `
// umbrage_exponential_warp: 2^(exponent * (2.0 * depth - 1.0)) of a depth that grows with distance
inline float umbrage_exponential_warp(float depth, float exponent) {
    float y = exponent * (depth * 2.0 - 1.0);
    return umbrage_exp2_polynomial(y);
}
`,
            "encode_esm": `
// umbrage_encode_esm: depth's power, of depth that grows with distance; NaN counts as far
inline float umbrage_encode_esm(float depth, float exponent) {
    return umbrage_exponential_warp(umbrage_to_forward_depth(umbrage_saturate(depth)), exponent);
}
`,
            "decode_esm": `
// umbrage_decode_esm: visibility of a receiver, at least its lit share; 1.0 is lit
//   m  mean of texels;   receiver  depth, biased;   exponent  as of the texels
inline float umbrage_decode_esm(float m, float receiver, float exponent) {
    float d = umbrage_to_forward_depth(receiver);
    float p = m * umbrage_exponential_warp(d, -exponent);
    float lit = p > 0.0 && p < 1.0 ? p : (p >= 1.0 ? 1.0 : 0.0);
    return d > 0.0 ? lit : (d <= 0.0 ? lit : 0.0);
}
`,
            "encode_evsm2": `
// umbrage_encode_evsm2: depth's power and its square, of depth that grows with distance; NaN counts as far
inline float2 umbrage_encode_evsm2(float depth, float exponent) {
    float w = umbrage_exponential_warp(umbrage_to_forward_depth(umbrage_saturate(depth)), exponent);
    return float2(w, w * w);
}
`,
            "encode_evsm4": `
// umbrage_encode_evsm4: depth's growing power, its square, the negative falling one, its square; NaN counts as far
inline float4 umbrage_encode_evsm4(float depth, float2 exponents) {
    float d = umbrage_to_forward_depth(umbrage_saturate(depth));
    float w = umbrage_exponential_warp(d, exponents.x);
    float n = -umbrage_exponential_warp(d, -exponents.y);
    return float4(w, w * w, n, n * n);
}
`,
            "decode_evsm2": `
// umbrage_decode_evsm2: visibility of a receiver, at least its lit share; 1.0 is lit
//   m  mean of texels;   receiver  depth, biased;   exponent  as of the texels
//   deviation  least standard deviation, as a part of the receiver's power
inline float umbrage_decode_evsm2(float2 m, float receiver, float exponent, float deviation) {
    float d = umbrage_to_forward_depth(umbrage_saturate(receiver));
    float w = umbrage_exponential_warp(d, exponent);
    float least = deviation * w;
    float least_variance = least * least;
    float lit = umbrage_chebyshev(m, w, least_variance);
    return receiver > 0.0 ? lit : (receiver <= 0.0 ? lit : 0.0);
}
`,
            "decode_evsm4": `
// umbrage_decode_evsm4: visibility of a receiver, at least its lit share; 1.0 is lit
//   m  mean of texels;   receiver  depth, biased;   exponents  as of the texels
//   deviations  least standard deviations, as parts of the receiver's powers
inline float umbrage_decode_evsm4(float4 m, float receiver, float2 exponents, float2 deviations) {
    float d = umbrage_to_forward_depth(umbrage_saturate(receiver));
    float w = umbrage_exponential_warp(d, exponents.x);
    float n = -umbrage_exponential_warp(d, -exponents.y);
    float2 least = deviations * float2(w, n);
    float2 least_variance = least * least;
    float a = umbrage_chebyshev(float2(m.x, m.y), w, least_variance.x);
    float b = umbrage_chebyshev(float2(m.z, m.w), n, least_variance.y);
    float lit = a < b ? a : b;
    return receiver > 0.0 ? lit : (receiver <= 0.0 ? lit : 0.0);
}
`,
            "encode_msm": `
// umbrage_encode_msm: first four powers of depth on -1.0 to 1.0, of depth that grows with distance; NaN counts as far
inline float4 umbrage_encode_msm(float depth) {
    float z = umbrage_to_forward_depth(umbrage_saturate(depth)) * 2.0 - 1.0;
    float square = z * z;
    return float4(z, square, square * z, square * square);
}
`,
            "to_optimized_moments": `
// umbrage_to_optimized_moments: four moments so that each takes 0.0 to 1.0 wholly, for four channels of 16 bits
inline float4 umbrage_to_optimized_moments(float4 b) {
    float x = (b.x * 0.75 - b.z) * 2.0 + 0.5;
    float y = (b.y - b.w) * 4.0;
    float z = (b.x * 2.25 - b.z) * 0.384900182 + 0.5;
    float w = (b.y + b.w) * 0.5;
    return float4(x, y, z, w);
}
`,
            "hausdorff_share": `
// umbrage_hausdorff_share: least share of depths on -1.0 to 1.0 before the receiver's, of four moments
//   b  moments, biased;   z  the receiver's depth on -1.0 to 1.0
//   negative where the share is that of umbrage_moment_atoms
inline float umbrage_hausdorff_share(float4 b, float z) {
    float variance = b.y - b.x * b.x;
    float third = b.z - b.x * b.y;
    float fourth = b.w - b.y * b.y;
    float rest = 1.0 - b.y;
    float x = z - b.x;
    float d = third + rest * x;
    float g = (fourth - variance * rest) - (z + b.x) * third;
    float p = d * (1.0 + b.x) + g;
    float q = d * (1.0 - b.x) - g;
    float k = rest * g + third * d;
    float first = (1.0 + z) * (d * variance + g * (1.0 - b.x)) - k;
    float last = (1.0 - z) * (d * variance - g * (1.0 + b.x)) + k;
    float square = d * d;
    float between = p * (q * (x * d - g));
    float end = first / (2.0 * ((1.0 + z) * p));
    float other = square * square / between;
    float share = end + (d > 0.0 ? other : 0.0);
    bool four = first * p > 0.0 && last * q > 0.0 && p * q > 0.0 && share >= 0.0;
    return z <= -1.0 ? 0.0 : (four ? (share < 1.0 ? share : 1.0) : -1.0);
}
`,
            "decode_msm_hausdorff": `
// umbrage_decode_msm_hausdorff: visibility of a receiver, at least its lit share less bias.x; 1.0 is lit
//   b  mean of texels;   receiver  depth, biased;   bias  (3e-6, 0.375)
inline float umbrage_decode_msm_hausdorff(float4 b, float receiver, float2 bias) {
    float plain = umbrage_decode_msm(b, receiver, bias);
    float d = umbrage_to_forward_depth(receiver);
    float z = (d > 0.0 ? (d < 1.0 ? d : 1.0) : 0.0) * 2.0 - 1.0;
    float share = umbrage_hausdorff_share(umbrage_bias_moments(b, bias), z);
    float lit = share >= 0.0 ? 1.0 - share : plain;
    return d > 0.0 ? lit : (d <= 0.0 ? lit : 0.0);
}
`,
            "fetch_bilinear": `
// umbrage_fetch_bilinear: mean of the four texels around a point, weights in steps of 1/256
//   coord  in texels, first center at (0.5, 0.5)
inline float4 umbrage_fetch_bilinear(UMBRAGE_MAP map, float2 size, float2 coord) {
    float2 x = metal::floor(coord * 256.0) - 128.0;
    float2 texel = metal::floor(x * (1.0 / 256.0));
    // weights are in [0, 256) already; compilers cannot regroup sums across the clamp
    float2 hi = metal::clamp(x * (1.0 / 256.0) - texel, float2(0.0, 0.0), float2(1.0, 1.0)) * 256.0;
    float2 lo = 256.0 - hi;  // of 1.0 - hi compilers would make an interpolation, which rounds otherwise
    float4 a = umbrage_fetch_clamped(map, size, texel);
    float4 b = umbrage_fetch_clamped(map, size, texel + float2(1.0, 0.0));
    float4 c = umbrage_fetch_clamped(map, size, texel + float2(0.0, 1.0));
    float4 d = umbrage_fetch_clamped(map, size, texel + float2(1.0, 1.0));
    float4 low = a * lo.x + b * hi.x;
    float4 high = c * lo.x + d * hi.x;
    float4 sum = low * lo.y + high * hi.y;
    return sum * (1.0 / 65536.0);
}
`,
            "vsm": `
// umbrage_vsm: visibility from a map of encode_vsm's texels, blurred; 1.0 is lit
//   map, size  prefiltered map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   min_variance  0.0 or more
inline float umbrage_vsm(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float min_variance) {
    bool compared = umbrage_map_covers(size, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    float4 m = umbrage_fetch_bilinear(map, size, compared ? coord : float2(0.0, 0.0));
    float lit = umbrage_decode_vsm(float2(m.x, m.y), receiver, min_variance);
    return compared ? lit : 1.0;
}
`,
            "esm": `
// umbrage_esm: visibility from a map of encode_esm's texels, blurred; 1.0 is lit
//   map, size  prefiltered map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   exponent  as of the texels
inline float umbrage_esm(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float exponent) {
    bool compared = umbrage_map_covers(size, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    float4 m = umbrage_fetch_bilinear(map, size, compared ? coord : float2(0.0, 0.0));
    float lit = umbrage_decode_esm(m.x, receiver, exponent);
    return compared ? lit : 1.0;
}
`,
            "evsm2": `
// umbrage_evsm2: visibility from a map of encode_evsm2's texels, blurred; 1.0 is lit
//   map, size  prefiltered map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   exponent, deviation  as of decode_evsm2
inline float umbrage_evsm2(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float exponent,
                           float deviation) {
    bool compared = umbrage_map_covers(size, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    float4 m = umbrage_fetch_bilinear(map, size, compared ? coord : float2(0.0, 0.0));
    float lit = umbrage_decode_evsm2(float2(m.x, m.y), receiver, exponent, deviation);
    return compared ? lit : 1.0;
}
`,
            "evsm4": `
// umbrage_evsm4: visibility from a map of encode_evsm4's texels, blurred; 1.0 is lit
//   map, size  prefiltered map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   exponents, deviations  as of decode_evsm4
inline float umbrage_evsm4(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float2 exponents,
                           float2 deviations) {
    bool compared = umbrage_map_covers(size, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    float4 m = umbrage_fetch_bilinear(map, size, compared ? coord : float2(0.0, 0.0));
    float lit = umbrage_decode_evsm4(m, receiver, exponents, deviations);
    return compared ? lit : 1.0;
}
`,
            "msm": `
// umbrage_msm: visibility from a map of encode_msm's texels, blurred; 1.0 is lit
//   map, size  prefiltered map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   bias  as of decode_msm
inline float umbrage_msm(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float2 bias) {
    bool compared = umbrage_map_covers(size, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    float4 m = umbrage_fetch_bilinear(map, size, compared ? coord : float2(0.0, 0.0));
    float lit = umbrage_decode_msm(m, receiver, bias);
    return compared ? lit : 1.0;
}
`,
            "msm_unorm16": `
// umbrage_msm_unorm16: visibility from a map of turned moments, blurred; 1.0 is lit
//   map, size  prefiltered map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   bias  as of decode_msm
inline float umbrage_msm_unorm16(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float2 bias) {
    bool compared = umbrage_map_covers(size, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    float4 m = umbrage_fetch_bilinear(map, size, compared ? coord : float2(0.0, 0.0));
    float lit = umbrage_decode_msm(umbrage_from_optimized_moments(m), receiver, bias);
    return compared ? lit : 1.0;
}
`,
            "msm_hausdorff": `
// umbrage_msm_hausdorff: visibility from a map of encode_msm's texels, blurred; 1.0 is lit
//   map, size  prefiltered map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   bias  as of decode_msm
inline float umbrage_msm_hausdorff(UMBRAGE_MAP map, float2 size, float2 coord, float receiver, float2 bias) {
    bool compared = umbrage_map_covers(size, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    float4 m = umbrage_fetch_bilinear(map, size, compared ? coord : float2(0.0, 0.0));
    float lit = umbrage_decode_msm_hausdorff(m, receiver, bias);
    return compared ? lit : 1.0;
}
`,
            "chebyshev_hardware": `
// umbrage_chebyshev_hardware: share of depths that may be as far as the receiver or farther, its least part cut
//   variance  above 0.0;   distance  from mean to receiver, no NaN;   amount  that is cut, 0.0 to 0.5
inline float umbrage_chebyshev_hardware(float variance, float distance, float amount) {
    float beyond = metal::max(distance, 0.0);
    float p = variance / (variance + beyond * beyond);
    return metal::clamp((p - amount) / (1.0 - amount), 0.0, 1.0);
}
`,
            "decode_vsm_hardware": `
// umbrage_decode_vsm_hardware: visibility of a receiver, less the light that bleeds; 1.0 is lit
//   held  mean and twice the standard deviation of depths, filtered;   receiver  depth, biased
//   min_variance  1e-7 or more;   amount  that is cut, 0.0 to 0.5
inline float umbrage_decode_vsm_hardware(float2 held, float receiver, float min_variance, float amount) {
    float variance = metal::max(held.y * held.y * 0.25, min_variance);
    float distance = umbrage_to_forward_depth(receiver) - held.x;
    float lit = umbrage_chebyshev_hardware(variance, distance, amount);
    return metal::abs(receiver) < 1048576.0 ? lit : 0.0;
}
`,
            "decode_evsm2_hardware": `
// umbrage_decode_evsm2_hardware: visibility of a receiver, less the light that bleeds; 1.0 is lit
//   m  mean of texels;   receiver  depth, biased;   exponent  as of the texels
//   deviation  least standard deviation, as a part of the receiver's power;   amount  that is cut, 0.0 to 0.3
inline float umbrage_decode_evsm2_hardware(float2 m, float receiver, float exponent, float deviation, float amount) {
    float d = umbrage_to_forward_depth(metal::clamp(receiver, 0.0, 1.0));
    float w = metal::exp2(exponent * (d * 2.0 - 1.0));
    float least = deviation * w;
    float variance = metal::max(m.y - m.x * m.x, least * least);
    float lit = umbrage_chebyshev_hardware(variance, w - m.x, amount);
    return metal::abs(receiver) < 1048576.0 ? lit : 0.0;
}
`,
            "decode_evsm4_hardware": `
// umbrage_decode_evsm4_hardware: visibility of a receiver, less the light that bleeds; 1.0 is lit
//   m  mean of texels;   receiver  depth, biased;   exponents  as of the texels
//   deviations  least standard deviations, as parts of the receiver's powers;   amount  that is cut, 0.0 to 0.3
inline float umbrage_decode_evsm4_hardware(float4 m, float receiver, float2 exponents, float2 deviations,
                                           float amount) {
    float d = umbrage_to_forward_depth(metal::clamp(receiver, 0.0, 1.0)) * 2.0 - 1.0;
    float w = metal::exp2(exponents.x * d);
    float n = 0.0 - metal::exp2((0.0 - exponents.y) * d);
    float2 least = deviations * float2(w, n);
    float growing = metal::max(m.y - m.x * m.x, least.x * least.x);
    float falling = metal::max(m.w - m.z * m.z, least.y * least.y);
    float a = umbrage_chebyshev_hardware(growing, w - m.x, amount);
    float b = umbrage_chebyshev_hardware(falling, n - m.z, amount);
    return metal::abs(receiver) < 1048576.0 ? metal::min(a, b) : 0.0;
}
`,
            "blur_row3": `
// umbrage_blur_row3: mean of 3 texels in a row, weighed by a row of Pascal's triangle
//   map, size  read from, and its size in texels;   texel  whole numbers, (0, 0) is the first
//   along      (1.0, 0.0) or (0.0, 1.0)
inline float4 umbrage_blur_row3(UMBRAGE_MAP map, float2 size, float2 texel, float2 along) {
    float4 sum = umbrage_fetch_clamped(map, size, texel) * (2.0 / 4.0);
    float4 before1 = umbrage_fetch_clamped(map, size, texel - along * 1.0);
    float4 after1 = umbrage_fetch_clamped(map, size, texel + along * 1.0);
    sum = sum + (before1 + after1) * (1.0 / 4.0);
    return sum;
}
`,
            "blur_row5": `
// umbrage_blur_row5: mean of 5 texels in a row, weighed by a row of Pascal's triangle
//   map, size  read from, and its size in texels;   texel  whole numbers, (0, 0) is the first
//   along      (1.0, 0.0) or (0.0, 1.0)
inline float4 umbrage_blur_row5(UMBRAGE_MAP map, float2 size, float2 texel, float2 along) {
    float4 sum = umbrage_fetch_clamped(map, size, texel) * (6.0 / 16.0);
    float4 before1 = umbrage_fetch_clamped(map, size, texel - along * 1.0);
    float4 after1 = umbrage_fetch_clamped(map, size, texel + along * 1.0);
    sum = sum + (before1 + after1) * (4.0 / 16.0);
    float4 before2 = umbrage_fetch_clamped(map, size, texel - along * 2.0);
    float4 after2 = umbrage_fetch_clamped(map, size, texel + along * 2.0);
    sum = sum + (before2 + after2) * (1.0 / 16.0);
    return sum;
}
`,
            "blur_row7": `
// umbrage_blur_row7: mean of 7 texels in a row, weighed by a row of Pascal's triangle
//   map, size  read from, and its size in texels;   texel  whole numbers, (0, 0) is the first
//   along      (1.0, 0.0) or (0.0, 1.0)
inline float4 umbrage_blur_row7(UMBRAGE_MAP map, float2 size, float2 texel, float2 along) {
    float4 sum = umbrage_fetch_clamped(map, size, texel) * (20.0 / 64.0);
    float4 before1 = umbrage_fetch_clamped(map, size, texel - along * 1.0);
    float4 after1 = umbrage_fetch_clamped(map, size, texel + along * 1.0);
    sum = sum + (before1 + after1) * (15.0 / 64.0);
    float4 before2 = umbrage_fetch_clamped(map, size, texel - along * 2.0);
    float4 after2 = umbrage_fetch_clamped(map, size, texel + along * 2.0);
    sum = sum + (before2 + after2) * (6.0 / 64.0);
    float4 before3 = umbrage_fetch_clamped(map, size, texel - along * 3.0);
    float4 after3 = umbrage_fetch_clamped(map, size, texel + along * 3.0);
    sum = sum + (before3 + after3) * (1.0 / 64.0);
    return sum;
}
`,
            "halve_texels": `
// umbrage_halve_texels: mean of the 2x2 texels that a texel of the next level of a mip chain is made of
//   map, size  read from, and its size in texels;   texel  of the next level, whole numbers
inline float4 umbrage_halve_texels(UMBRAGE_MAP map, float2 size, float2 texel) {
    float2 at = texel * 2.0;
    float4 a = umbrage_fetch_clamped(map, size, at);
    float4 b = umbrage_fetch_clamped(map, size, at + float2(1.0, 0.0));
    float4 c = umbrage_fetch_clamped(map, size, at + float2(0.0, 1.0));
    float4 d = umbrage_fetch_clamped(map, size, at + float2(1.0, 1.0));
    float4 sum = (a + b) + (c + d);
    return sum * 0.25;
}
`,
            "texels_to_world": `
// umbrage_texels_to_world: texels across a light as world units; 0.0 for w <= 0.0
//   units  (edge of a texel, depth a world unit) at w = 1.0;   w  of the point's shadow coordinate
inline float umbrage_texels_to_world(float texels, float2 units, float w) {
    float world = texels * units.x * w;
    return world >= (1.0 / 18446744073709551616.0) && world < 18446744073709551616.0 ? world : 0.0;
}
`,
            "clamp_bias": `
// umbrage_clamp_bias: a bias in depth clamped to [0, 1], 0.0 below 2^-64; NaN becomes 1.0, and nothing is in shadow
inline float umbrage_clamp_bias(float bias) {
    float least = (1.0 / 18446744073709551616.0);
    return bias >= least && bias < 1.0 ? bias : (bias < least ? 0.0 : 1.0);
}
`,
            "world_to_depth": `
// umbrage_world_to_depth: world units along a light as depth, 0.0 to 1.0
//   units  (edge of a texel, depth a world unit) at w = 1.0;   w  of the point's shadow coordinate, above 0.0
inline float umbrage_world_to_depth(float world, float2 units, float w) {
    float along = world * units.y;
    float square = w * w;
    return umbrage_clamp_bias(along / square);
}
`,
            "biased": `
// umbrage_biased: receiver moved towards the light by bias, in depth; 2^64 and more, and NaN, is none
inline float umbrage_biased(float receiver, float bias) {
    float by = metal::abs(bias) < 18446744073709551616.0 ? bias : 0.0;
    return umbrage_cleared_depth() > 0.5 ? receiver - by : receiver + by;
}
`,
            "clamp_slope": `
// umbrage_clamp_slope: change of depth a texel clamped to [-2, 2]; NaN becomes 2.0
inline float umbrage_clamp_slope(float slope) {
    return slope > -2.0 && slope < 2.0 ? slope : (slope <= -2.0 ? -2.0 : 2.0);
}
`,
            "plane_slope": `
// umbrage_plane_slope: change of depth from one texel to the next, in x and y, of the plane through a point
//   plane_matrix  transpose of the texture matrix' inverse;   normal  of any length;   world  point on the plane
inline float2 umbrage_plane_slope(metal::float4x4 plane_matrix, float3 normal, float3 world) {
    float d = -(normal.x * world.x + normal.y * world.y + normal.z * world.z);
    float4 q = plane_matrix[3] * d + plane_matrix[0] * normal.x + plane_matrix[1] * normal.y + plane_matrix[2] *
        normal.z;
    return float2(umbrage_clamp_slope(-q.x / q.z), umbrage_clamp_slope(-q.y / q.z));
}
`,
            "receiver_slope": `
// umbrage_receiver_slope: umbrage_plane_slope, and (0.0, 0.0) for a normal of zero, of a caller who has none
inline float2 umbrage_receiver_slope(metal::float4x4 plane_matrix, float3 normal, float3 world) {
    float2 slope = umbrage_plane_slope(plane_matrix, normal, world);
    bool none = normal.x == 0.0 && normal.y == 0.0 && normal.z == 0.0;
    return none ? float2(0.0, 0.0) : slope;
}
`,
            "cascade_slope": `
// umbrage_cascade_slope: change of depth from one texel to the next; (0.0, 0.0) for a normal of zero
//   normal  of the surface, rotated into the light's directions;   scale  of the cascade
inline float2 umbrage_cascade_slope(float3 normal, float4 scale) {
    float2 up = float2(normal.x, normal.y) * -scale.z;
    float2 across = float2(scale.x, scale.y) * normal.z;
    bool none = normal.x == 0.0 && normal.y == 0.0 && normal.z == 0.0;
    float2 slope = float2(umbrage_clamp_slope(up.x / across.x), umbrage_clamp_slope(up.y / across.y));
    return none ? float2(0.0, 0.0) : slope;
}
`,
            "slope_bias": `
// umbrage_slope_bias: factor times the greater slope, and a base, 0.0 to 1.0
//   slope  change of depth from one texel to the next;   factor  in texels;   base  in depth
inline float umbrage_slope_bias(float2 slope, float factor, float base) {
    float2 bias = metal::abs(slope) * factor + base;
    float x = umbrage_clamp_bias(bias.x);  // of both: a maximum of a NaN is what a GPU makes it
    float y = umbrage_clamp_bias(bias.y);
    return x > y ? x : y;
}
`,
            "dual_paraboloid_slope": `
// umbrage_dual_paraboloid_slope: change of distance from one texel to the next, in x and y alike; 0.0 without a normal
//   way  from the light to the receiver;   normal  of its surface;   per_texel  2.0 / (range * (size - 2.0 * border))
inline float2 umbrage_dual_paraboloid_slope(float3 way, float3 normal, float per_texel) {
    float square = way.x * way.x + way.y * way.y + way.z * way.z;
    float x = normal.y * way.z - normal.z * way.y;
    float y = normal.z * way.x - normal.x * way.z;
    float z = normal.x * way.y - normal.y * way.x;
    float across = x * x + y * y + z * z;
    float along = normal.x * way.x + normal.y * way.y + normal.z * way.z;
    float wide = (metal::sqrt(square) + metal::abs(way.z)) * (per_texel * 0.707106781);
    float slope = umbrage_clamp_slope(wide * metal::sqrt(across) / metal::abs(along));
    bool none = normal.x == 0.0 && normal.y == 0.0 && normal.z == 0.0;
    return none ? float2(0.0, 0.0) : float2(slope, slope);
}
`,
            "normal_offset": `
// umbrage_normal_offset: what to add to a surface's point, world units, before it is looked up
//   normal, direction  of the surface and the light, of length one;   way  from the light to the point over w; of a
//   directional light its direction;   width  sqrt(2) reach texel;   error_world  of the map's depths; world units
inline float3 umbrage_normal_offset(float3 normal, float3 direction, float3 way, float width, float error_world) {
    float x = normal.y * direction.z + normal.z * -direction.y;
    float y = normal.z * direction.x + normal.x * -direction.z;
    float z = normal.x * direction.y + normal.y * -direction.x;
    float straight = normal.x * way.x + normal.y * way.y + normal.z * way.z;
    float square = x * x + y * y + z * z;
    float along = width * metal::sqrt(square) + error_world * metal::abs(straight);
    float3 offset = normal * along;
    return metal::abs(offset.x) + metal::abs(offset.y) +
        metal::abs(offset.z) < 18446744073709551616.0 ? offset : float3(0.0, 0.0, 0.0);
}
`,
            "kernel_bias": `
// umbrage_kernel_bias: how far along the light a kernel reaches before a surface's plane, in the units of width
//   normal  of the surface;   direction  of the light, of length one;   way  from the light to the point over w; of a
//   directional light its direction;   width  sqrt(2) reach texel;   greatest  tangent, where growth ends
inline float umbrage_kernel_bias(float3 normal, float3 direction, float3 way, float width, float greatest) {
    float x = normal.y * direction.z + normal.z * -direction.y;
    float y = normal.z * direction.x + normal.x * -direction.z;
    float z = normal.x * direction.y + normal.y * -direction.x;
    float square = x * x + y * y + z * z;
    float sine = metal::sqrt(square);
    float cosine = -(normal.x * way.x + normal.y * way.y + normal.z * way.z);
    float edge = cosine * greatest;
    float tangent = edge > sine ? sine / cosine : greatest;
    float bias = width * tangent;
    return bias >= (1.0 / 18446744073709551616.0) && bias < 18446744073709551616.0 ? bias : 0.0;
}
`,
            "receiver_plane_slope": `
// umbrage_receiver_plane_slope: change of a receiver's depth a texel in x and y, and by how much their sum may be off
//   dx, dy  dFdx and dFdy of (x and y in texels, depth); zero where they tell nothing of the plane
inline float3 umbrage_receiver_plane_slope(float3 dx, float3 dy) {
    float determinant = dx.x * dy.y + dx.y * -dy.x;
    float sum = metal::abs(dx.x) + metal::abs(dx.y) + metal::abs(dy.x) + metal::abs(dy.y);
    float along_x = dy.y * dx.z + dx.y * -dy.z;
    float along_y = dx.x * dy.z + dy.x * -dx.z;
    float a = umbrage_clamp_slope(along_x / determinant);
    float b = umbrage_clamp_slope(along_y / determinant);
    float off = ((1.0 / 33554432.0) + (metal::abs(a) + metal::abs(b)) * (1.0 / 8192.0)) * 3.3;
    float error = off * (sum / metal::abs(determinant));
    float least = sum * (1.0 / 1024.0);
    bool known = metal::abs(determinant) > least && sum < 18446744073709551616.0;
    return known ? float3(a, b, umbrage_clamp_slope(error)) : float3(0.0, 0.0, 0.0);
}
`,
            "apply_receiver_plane": `
// umbrage_apply_receiver_plane: a texel's depth as the receiver's own texel would hold it; a cleared one stays cleared
//   stored  depth of the texel;   slope  of the receiver's plane, a texel;   coord  receiver in texels
inline float umbrage_apply_receiver_plane(float stored, float2 slope, float2 coord, float2 texel) {
    float2 way = texel + 0.5 - coord;
    float depth = stored - (slope.x * way.x + slope.y * way.y);
    bool cleared = metal::abs(stored - umbrage_cleared_depth()) < (1.0 / 18446744073709551616.0);
    return cleared ? stored : depth;
}
`,
            "acne_free_bias": `
// umbrage_acne_free_bias: the smallest bias in depth with which no plane shadows itself, 0.0 to 1.0
//   slope  change of depth from one texel to the next;   reach  of the filter, texels
//   error  how far a decoded depth may lie before the true one
inline float umbrage_acne_free_bias(float2 slope, float reach, float error) {
    float bias = reach * (metal::abs(slope.x) + metal::abs(slope.y)) + (error + (1.0 / 8388608.0));
    return umbrage_clamp_bias(bias);
}
`,
            "acne_free_disc_bias": `
// umbrage_acne_free_disc_bias: the smallest bias in depth with which no plane shadows itself, 0.0 to 1.0
//   slope   change of depth from one texel to the next;   radius  to the disc's farthest point, texels
//   error   how far a decoded depth may lie before the true one
inline float umbrage_acne_free_disc_bias(float2 slope, float radius, float error) {
    float square = slope.x * slope.x + slope.y * slope.y;
    float beside = (metal::abs(slope.x) + metal::abs(slope.y)) * 0.5078125 + (error + (1.0 / 8388608.0));
    float bias = radius * metal::sqrt(square) + beside;
    return umbrage_clamp_bias(bias);
}
`,
            "peter_panning_distance": `
// umbrage_peter_panning_distance: a caster nearer to the receiver loses its shadow, or a part of it; depth, 0.0 to 1.0
//   bias   of the receiver, in depth;   caster_slope  change of the caster's depth from one texel to the next
//   reach  of the filter, texels
inline float umbrage_peter_panning_distance(float bias, float2 caster_slope, float reach) {
    return umbrage_acne_free_bias(caster_slope, reach, bias);
}
`,
            "spot_cone": `
// umbrage_spot_cone: 1.0 inside the cone of a spot light, else 0.0
//   direction  of the light, unit length;   to_point  from the light, any length;   cos_outer  in [0, 1)
inline float umbrage_spot_cone(float3 direction, float3 to_point, float cos_outer) {
    float d = direction.x * to_point.x + direction.y * to_point.y + direction.z * to_point.z;
    float length2 = to_point.x * to_point.x + to_point.y * to_point.y + to_point.z * to_point.z;
    float edge2 = cos_outer * cos_outer * length2;
    float d2 = d * d;
    return d > 0.0 && d2 > edge2 ? 1.0 : 0.0;
}
`,
            "diffuse_ambient": `
// umbrage_diffuse_ambient: albedo * (visibility * n_dot_l * (1 - ambient) + ambient); for n_dot_l <= 0, NaN: ambient
inline float3 umbrage_diffuse_ambient(float3 albedo, float ambient, float n_dot_l, float visibility) {
    float light = visibility * n_dot_l * (1.0 - ambient) + ambient;
    return albedo * (n_dot_l > 0.0 ? light : ambient);  // a max of n_dot_l and 0.0 is NaN for a signalling one on Mesa
}
`,
            "false_color": `
// umbrage_false_color: blue for 0.0, through green, to red for 1.0
inline float3 umbrage_false_color(float v) {
    float x = umbrage_saturate(v) * 4.0;
    float3 ramp = 1.5 - metal::abs(float3(x - 3.0, x - 2.0, x - 1.0));
    return float3(umbrage_saturate(ramp.x), umbrage_saturate(ramp.y), umbrage_saturate(ramp.z));
}
`,
            "overlay_texel": `
// umbrage_overlay_texel: texel under a pixel of a map stretched over the picture's corner; -1.0 outside the overlay
//   coord     center of the pixel, counted from the corner: 0.5, 1.5, ...;   size  of the overlay in pixels, whole
//   map_size  in texels, whole, at most 65536.0; times size at most 2^23;   texels_per_pixel  map_size / size
inline float umbrage_overlay_texel(float coord, float size, float map_size, float texels_per_pixel) {
    float texel = metal::floor(coord * texels_per_pixel - 0.5);
    texel += (texel + 1.0) * size <= coord * map_size ? 1.0 : 0.0;
    return coord >= 0.0 && coord < size ? texel : -1.0;
}
`,
            "probe_color": `
// umbrage_probe_color: what a receiver's place in a map says, as a color
//   at    (x, y) in texels, z depth;   size  of the map;   bias  of the receiver;   number  of the map, whole
//   magenta  not a number;   black  behind the light, in no cascade;   white  outside the map
//   cyan  beyond the far plane;   blue  before the near plane;   red  bias at its limit;   else texels
inline float3 umbrage_probe_color(float3 at, float2 size, float bias, float number) {
    float limit = 18446744073709551616.0;
    bool usable = metal::abs(at.x) < limit && metal::abs(at.y) < limit && metal::abs(at.z) < limit;
    bool inside = at.x >= 0.0 && at.y >= 0.0 && at.x <= size.x && at.y <= size.y;
    bool forward = umbrage_cleared_depth() > 0.5;
    bool past_far = forward ? at.z > 1.0 : at.z < 0.0;
    bool past_near = forward ? at.z < 0.0 : at.z > 1.0;
    float square = metal::floor(at.x) + metal::floor(at.y);
    float shade = square - 2.0 * metal::floor(square * 0.5) > 0.5 ? 0.75 : 1.0;
    float3 bits = metal::floor(float3(number + 1.0, (number + 1.0) * 0.5, (number + 1.0) * 0.25));
    bits = bits - 2.0 * metal::floor(bits * 0.5);
    float3 color = (bits * 0.5 + 0.375) * shade;
    color = bias < 1.0 ? color : float3(1.0, 0.0, 0.0);
    color = past_near ? float3(0.0, 0.0, 1.0) : color;
    color = past_far ? float3(0.0, 1.0, 1.0) : color;
    color = inside ? color : float3(1.0, 1.0, 1.0);
    color = at.x < 65536.0 ? color : float3(0.0, 0.0, 0.0);
    return usable ? color : float3(1.0, 0.0, 1.0);
}
`,
            "probe_inputs": `
// umbrage_probe_inputs: color, unless the receiver is wrong; magenta  not a number;   yellow  a normal of zero
inline float3 umbrage_probe_inputs(float3 color, float3 world, float3 normal) {
    float limit = 18446744073709551616.0;
    bool usable = metal::abs(world.x) < limit && metal::abs(world.y) < limit && metal::abs(world.z) < limit;
    usable = usable && metal::abs(normal.x) < limit && metal::abs(normal.y) < limit && metal::abs(normal.z) < limit;
    bool zero = normal.x == 0.0 && normal.y == 0.0 && normal.z == 0.0;
    float3 given = zero ? float3(1.0, 1.0, 0.0) : color;
    return usable ? given : float3(1.0, 0.0, 1.0);
}
`,
            "hooks/cleared_depth, reversed": `
// umbrage_cleared_depth: depth of the far plane
inline float umbrage_cleared_depth() {
    return 0.0;
}
`,
            "hooks/map_covers, clamped": `
// umbrage_map_covers: always, as outside the map the nearest texel inside counts
inline bool umbrage_map_covers(float2 size, float2 coord) {
    return true;
}
`,
            "hooks/beyond_far_plane, reversed": `
// umbrage_beyond_far_plane: whether a receiver is behind the far plane
inline bool umbrage_beyond_far_plane(float receiver) {
    return receiver < 0.0;
}
`,
            "hooks/beyond_far_plane, without": `
// umbrage_beyond_far_plane: never for this map; receivers behind the far plane come in as what every texel lights
inline bool umbrage_beyond_far_plane(float receiver) {
    return false;
}
`,
            "hooks/within_far_plane, reversed": `
// umbrage_within_far_plane: whether a receiver is a number, and not behind the far plane
inline bool umbrage_within_far_plane(float receiver) {
    return receiver >= 0.0;
}
`,
            "hooks/within_far_plane, without": `
// umbrage_within_far_plane: whether a receiver is a number, as for this map none is behind the far plane
inline bool umbrage_within_far_plane(float receiver) {
    // a sum of choices, not an or of comparisons, which compilers take for true
    float number = (receiver > 0.0 ? 1.0 : 0.0) + (receiver <= 0.0 ? 1.0 : 0.0);
    return number > 0.5;
}
`,
            "hooks/compare, reversed": `
// umbrage_compare: 1.0 when the receiver is no farther than the stored depth, near is 1.0
inline float umbrage_compare(float receiver, float stored) {
    return receiver >= stored ? 1.0 : 0.0;
}
`,
            "hooks/compare, own": `
// umbrage_compare: visibility of one comparison, the map's own
inline float umbrage_compare(float receiver, float stored) {
    return UMBRAGE_COMPARE;
}
`,
            "hooks/decode": `
// umbrage_decode: depth of a value that the sampler gave
inline float umbrage_decode(float4 value) {
    return UMBRAGE_DEPTH;
}
`,
            "hooks/fetch_depth, clamped": `
// umbrage_fetch_depth: stored depth of a texel, outside the map of the nearest one inside
inline float umbrage_fetch_depth(UMBRAGE_MAP map, float2 size, float2 texel) {
    float4 value = umbrage_fetch_clamped(map, size, texel);
    return UMBRAGE_DEPTH;
}
`,
            "hooks/lit_texel": `
// umbrage_lit_texel: the sampler's comparison with a texel inside the map; a NaN is in shadow
inline float umbrage_lit_texel(UMBRAGE_MAP map, float2 size, float2 texel, float receiver) {
    float2 at = texel + UMBRAGE_ORIGIN;
    float lit = UMBRAGE_LIT_TEXEL;
    return (receiver > 0.0 ? lit : 0.0) + (receiver <= 0.0 ? lit : 0.0);
}
`,
            "hooks/lit, clamped": `
// umbrage_lit: visibility of one comparison with a texel, outside the map with the nearest one inside
inline float umbrage_lit(UMBRAGE_MAP map, float2 size, float2 texel, float receiver) {
    return umbrage_lit_texel(map, size, metal::clamp(texel, float2(0.0, 0.0), size - 1.0), receiver);
}
`,
            "hooks/lit, bordered": `
// umbrage_lit: visibility of one comparison with a texel, outside the map with the far plane
inline float umbrage_lit(UMBRAGE_MAP map, float2 size, float2 texel, float receiver) {
    float2 inside = metal::clamp(texel, float2(0.0, 0.0), size - 1.0);
    float lit = umbrage_lit_texel(map, size, inside, receiver);
    float outside = umbrage_compare(receiver, UMBRAGE_BORDER);
    return inside.x == texel.x && inside.y == texel.y ? lit : outside;
}
`,
            "hooks/gather_lit, compared": `
// umbrage_gather_lit: the sampler's comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1); a NaN is in shadow
inline float4 umbrage_gather_lit(UMBRAGE_MAP map, float2 size, float2 texel, float receiver) {
    float2 at = texel + UMBRAGE_ORIGIN;
    float4 lit = UMBRAGE_GATHER_LIT;
    float number = (receiver > 0.0 ? 1.0 : 0.0) + (receiver <= 0.0 ? 1.0 : 0.0);
    return float4(lit.w, lit.z, lit.x, lit.y) * number;
}
`,
            "hooks/gather_lit, one channel": `
// umbrage_gather_lit: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1)
inline float4 umbrage_gather_lit(UMBRAGE_MAP map, float2 size, float2 texel, float receiver) {
    float2 at = texel + UMBRAGE_ORIGIN;
    float4 r = UMBRAGE_GATHER_RED;
    float a = umbrage_compare(receiver, umbrage_decode(float4(r.w, 0.0, 0.0, 0.0)));
    float b = umbrage_compare(receiver, umbrage_decode(float4(r.z, 0.0, 0.0, 0.0)));
    float c = umbrage_compare(receiver, umbrage_decode(float4(r.x, 0.0, 0.0, 0.0)));
    float d = umbrage_compare(receiver, umbrage_decode(float4(r.y, 0.0, 0.0, 0.0)));
    return float4(a, b, c, d);
}
`,
            "hooks/gather_lit, two channels": `
// umbrage_gather_lit: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1)
inline float4 umbrage_gather_lit(UMBRAGE_MAP map, float2 size, float2 texel, float receiver) {
    float2 at = texel + UMBRAGE_ORIGIN;
    float4 r = UMBRAGE_GATHER_RED;
    float4 g = UMBRAGE_GATHER_GREEN;
    float a = umbrage_compare(receiver, umbrage_decode(float4(r.w, g.w, 0.0, 0.0)));
    float b = umbrage_compare(receiver, umbrage_decode(float4(r.z, g.z, 0.0, 0.0)));
    float c = umbrage_compare(receiver, umbrage_decode(float4(r.x, g.x, 0.0, 0.0)));
    float d = umbrage_compare(receiver, umbrage_decode(float4(r.y, g.y, 0.0, 0.0)));
    return float4(a, b, c, d);
}
`,
            "hooks/lit_2x2, gathered": `
// umbrage_lit_2x2: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1); the sampler clamps
inline float4 umbrage_lit_2x2(UMBRAGE_MAP map, float2 size, float2 texel, float receiver) {
    return umbrage_gather_lit(map, size, texel, receiver);
}
`,
            "hooks/lit_2x2, gathered in a region": `
// umbrage_lit_2x2: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1), outside the map with
//   the nearest texel inside: the gather stays inside, and each comparison is taken from its row and column
inline float4 umbrage_lit_2x2(UMBRAGE_MAP map, float2 size, float2 texel, float receiver) {
    float2 first = metal::clamp(texel, float2(0.0, 0.0), metal::max(size - 2.0, float2(0.0, 0.0)));
    float2 low = metal::clamp(texel, float2(0.0, 0.0), size - 1.0) - first;
    float2 high = metal::clamp(texel + 1.0, float2(0.0, 0.0), size - 1.0) - first;
    float4 lit = umbrage_gather_lit(map, size, first, receiver);
    float2 left = low.x > 0.5 ? float2(lit.y, lit.w) : float2(lit.x, lit.z);
    float2 right = high.x > 0.5 ? float2(lit.y, lit.w) : float2(lit.x, lit.z);
    float2 bottom = low.y > 0.5 ? float2(left.y, right.y) : float2(left.x, right.x);
    float2 top = high.y > 0.5 ? float2(left.y, right.y) : float2(left.x, right.x);
    return float4(bottom.x, bottom.y, top.x, top.y);
}
`,
            "hooks/lit_2x2, gathered and bordered": `
// umbrage_lit_2x2: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1), outside the map with
//   the far plane, whatever the sampler has there
inline float4 umbrage_lit_2x2(UMBRAGE_MAP map, float2 size, float2 texel, float receiver) {
    float4 lit = umbrage_gather_lit(map, size, texel, receiver);
    float outside = umbrage_compare(receiver, UMBRAGE_BORDER);
    float a = umbrage_inside_map(size, texel) ? lit.x : outside;
    float b = umbrage_inside_map(size, texel + float2(1.0, 0.0)) ? lit.y : outside;
    float c = umbrage_inside_map(size, texel + float2(0.0, 1.0)) ? lit.z : outside;
    float d = umbrage_inside_map(size, texel + float2(1.0, 1.0)) ? lit.w : outside;
    return float4(a, b, c, d);
}
`,
            "hooks/lit_2x2, gathered in a bordered region": `
// umbrage_lit_2x2: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1), outside the map with
//   the far plane: the gather stays inside
inline float4 umbrage_lit_2x2(UMBRAGE_MAP map, float2 size, float2 texel, float receiver) {
    float2 first = metal::clamp(texel, float2(0.0, 0.0), metal::max(size - 2.0, float2(0.0, 0.0)));
    float2 low = texel - first;
    float4 lit = umbrage_gather_lit(map, size, first, receiver);
    float2 left = low.x > 0.5 ? float2(lit.y, lit.w) : float2(lit.x, lit.z);
    float2 right = low.x < -0.5 ? float2(lit.x, lit.z) : float2(lit.y, lit.w);
    float2 bottom = low.y > 0.5 ? float2(left.y, right.y) : float2(left.x, right.x);
    float2 top = low.y < -0.5 ? float2(left.x, right.x) : float2(left.y, right.y);
    float outside = umbrage_compare(receiver, UMBRAGE_BORDER);
    float a = umbrage_inside_map(size, texel) ? bottom.x : outside;
    float b = umbrage_inside_map(size, texel + float2(1.0, 0.0)) ? bottom.y : outside;
    float c = umbrage_inside_map(size, texel + float2(0.0, 1.0)) ? top.x : outside;
    float d = umbrage_inside_map(size, texel + float2(1.0, 1.0)) ? top.y : outside;
    return float4(a, b, c, d);
}
`,
            "hooks/lit_filtered, clamped": `
// umbrage_lit_filtered: 2x2 comparisons around a point, weighted by the sampler; a NaN is in shadow
//   coord  in texels, no NaN
inline float umbrage_lit_filtered(UMBRAGE_MAP map, float2 size, float2 coord, float receiver) {
    float2 texel = metal::clamp(coord, float2(0.5, 0.5), size - 0.5);
    float2 at = texel + UMBRAGE_ORIGIN;
    float2 uv = UMBRAGE_UV;
    float lit = UMBRAGE_LIT_FILTERED;
    return umbrage_within_far_plane(receiver) ? lit : 0.0;
}
`,
            "hooks/lit_filtered, bordered": `
// umbrage_lit_filtered: 2x2 comparisons around a point, weighted by the sampler, outside the map with the far plane; a
//   NaN is in shadow
//   coord  in texels, no NaN
inline float umbrage_lit_filtered(UMBRAGE_MAP map, float2 size, float2 coord, float receiver) {
    float2 texel = metal::clamp(coord, float2(0.5, 0.5), size - 0.5);
    float2 at = texel + UMBRAGE_ORIGIN;
    float2 uv = UMBRAGE_UV;
    float lit = UMBRAGE_LIT_FILTERED;
    float2 inside = metal::clamp(metal::min(coord, size - coord) + 0.5, float2(0.0, 0.0), float2(1.0, 1.0));
    float outside = umbrage_compare(receiver, UMBRAGE_BORDER);
    return umbrage_within_far_plane(receiver) ? outside + inside.x * inside.y * (lit - outside) : 0.0;
}
`,
            "hooks/lit_at, sampled": `
// umbrage_lit_at: 2x2 comparisons around a point, weighted by the sampler
//   uv  over the map, (0.0, 0.0) to (1.0, 1.0);   receiver  no NaN
inline float umbrage_lit_at(UMBRAGE_MAP map, float2 size, float2 uv, float receiver) {
    return UMBRAGE_LIT_FILTERED;
}
`,
            "hooks/lit_at, sampled and bordered": `
// umbrage_lit_at: 2x2 comparisons around a point, weighted by the sampler, outside the map with the far plane
//   uv  over the map, (0.0, 0.0) to (1.0, 1.0);   receiver  no NaN
inline float umbrage_lit_at(UMBRAGE_MAP map, float2 size, float2 uv, float receiver) {
    float lit = UMBRAGE_LIT_FILTERED;
    float outside = umbrage_compare(receiver, UMBRAGE_BORDER);
    float2 inside = metal::clamp((0.5 - metal::abs(uv - 0.5)) * size + 0.5, float2(0.0, 0.0), float2(1.0, 1.0));
    return outside + inside.x * inside.y * (lit - outside);
}
`,
            "hooks/depth_at, sampled": `
// umbrage_depth_at: stored depth of the texel at a point, by the sampler
//   uv  over the map, (0.0, 0.0) to (1.0, 1.0)
inline float umbrage_depth_at(UMBRAGE_MAP map, float2 size, float2 uv) {
    return umbrage_decode(UMBRAGE_SAMPLED);
}
`,
            "hooks/depth_at, sampled and bordered": `
// umbrage_depth_at: stored depth of the texel at a point, by the sampler, outside the map that of the far plane
//   uv  over the map, (0.0, 0.0) to (1.0, 1.0)
inline float umbrage_depth_at(UMBRAGE_MAP map, float2 size, float2 uv) {
    float depth = umbrage_decode(UMBRAGE_SAMPLED);
    return metal::abs(uv.x - 0.5) <= 0.5 && metal::abs(uv.y - 0.5) <= 0.5 ? depth : UMBRAGE_BORDER;
}
`,
        },
    },
    wgsl: {
        prelude: "",
        receiver_plane: "receiver_slope: vec2f, receiver_coord: vec2f",
        may_reorder: "WGSL",
        preprocessor: false,
        textures: {
            texture_2d: { parameters: "map: texture_2d<f32>", arguments: "map", texel: "textureLoad(map, vec2i(at), 0)", sampled: "textureSampleLevel(map, map_sampler, uv, 0.0)", lit: "", gather_red: "textureGather(0, map, map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE)", gather_green: "textureGather(1, map, map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE)", gather_lit: "", lit_filtered: "", size: "vec2f(textureDimensions(map))", sampler: ", map_sampler: sampler", sampler_argument: ", map_sampler", needs: [] },
            atlas: { parameters: "map: texture_2d<f32>, origin: vec2f", arguments: "map, origin", texel: "textureLoad(map, vec2i(at), 0)", sampled: "textureSampleLevel(map, map_sampler, uv, 0.0)", lit: "", gather_red: "textureGather(0, map, map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE)", gather_green: "textureGather(1, map, map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE)", gather_lit: "", lit_filtered: "", size: "vec2f(textureDimensions(map))", sampler: ", map_sampler: sampler", sampler_argument: ", map_sampler", needs: [] },
            array: { parameters: "map: texture_2d_array<f32>, layer: f32", arguments: "map, layer", texel: "textureLoad(map, vec2i(at), i32(layer), 0)", sampled: "textureSampleLevel(map, map_sampler, uv, i32(layer), 0.0)", lit: "", gather_red: "textureGather(0, map, map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, i32(layer))", gather_green: "textureGather(1, map, map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, i32(layer))", gather_lit: "", lit_filtered: "", size: "vec2f(textureDimensions(map))", sampler: ", map_sampler: sampler", sampler_argument: ", map_sampler", needs: [] },
            cube: { parameters: "map: texture_cube<f32>, map_sampler: sampler, face: f32", arguments: "map, map_sampler, face", texel: "textureSampleLevel(map, map_sampler, umbrage_cube_direction(face, (at + 0.5) / UMBRAGE_TEXTURE_SIZE), 0.0)", sampled: "", lit: "", gather_red: "", gather_green: "", gather_lit: "", lit_filtered: "", size: "vec2f(textureDimensions(map))", sampler: "", sampler_argument: "", needs: ["cube_direction"] },
            cube_faces: { parameters: "map: texture_cube<f32>, map_sampler: sampler", arguments: "map, map_sampler", texel: "textureSampleLevel(map, map_sampler, umbrage_cube_atlas_direction(at, size.y * 0.5), 0.0)", sampled: "", lit: "", gather_red: "", gather_green: "", gather_lit: "", lit_filtered: "", size: "vec2f(textureDimensions(map))", sampler: "", sampler_argument: "", needs: ["cube_atlas_direction"] },
            integer: { parameters: "map: texture_2d<u32>", arguments: "map", texel: "vec4f(textureLoad(map, vec2i(at), 0))", sampled: "", lit: "", gather_red: "", gather_green: "", gather_lit: "", lit_filtered: "", size: "vec2f(textureDimensions(map))", sampler: "", sampler_argument: "", needs: [] },
            depth: { parameters: "map: texture_depth_2d", arguments: "map", texel: "vec4f(textureLoad(map, vec2i(at), 0))", sampled: "vec4f(textureSampleLevel(map, map_sampler, uv, 0))", lit: "", gather_red: "textureGather(map, map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE)", gather_green: "", gather_lit: "", lit_filtered: "", size: "vec2f(textureDimensions(map))", sampler: ", map_sampler: sampler", sampler_argument: ", map_sampler", needs: [] },
            depth_array: { parameters: "map: texture_depth_2d_array, layer: f32", arguments: "map, layer", texel: "vec4f(textureLoad(map, vec2i(at), i32(layer), 0))", sampled: "vec4f(textureSampleLevel(map, map_sampler, uv, i32(layer), 0))", lit: "", gather_red: "textureGather(map, map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, i32(layer))", gather_green: "", gather_lit: "", lit_filtered: "", size: "vec2f(textureDimensions(map))", sampler: ", map_sampler: sampler", sampler_argument: ", map_sampler", needs: [] },
            shadow: { parameters: "map: texture_depth_2d, map_sampler: sampler_comparison", arguments: "map, map_sampler", texel: "", sampled: "", lit: "textureSampleCompareLevel(map, map_sampler, (at + 0.5) / UMBRAGE_TEXTURE_SIZE, receiver)", gather_red: "", gather_green: "", gather_lit: "textureGatherCompare(map, map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, receiver)", lit_filtered: "textureSampleCompareLevel(map, map_sampler, uv, receiver)", size: "vec2f(textureDimensions(map))", sampler: "", sampler_argument: "", needs: [] },
            shadow_array: { parameters: "map: texture_depth_2d_array, map_sampler: sampler_comparison, layer: f32", arguments: "map, map_sampler, layer", texel: "", sampled: "", lit: "textureSampleCompareLevel(map, map_sampler, (at + 0.5) / UMBRAGE_TEXTURE_SIZE, i32(layer), receiver)", gather_red: "", gather_green: "", gather_lit: "textureGatherCompare(map, map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, i32(layer), receiver)", lit_filtered: "textureSampleCompareLevel(map, map_sampler, uv, i32(layer), receiver)", size: "vec2f(textureDimensions(map))", sampler: "", sampler_argument: "", needs: [] },
        },
        texts: {
            "shadow_coordinate": `
// umbrage_shadow_coordinate: texture matrix times world position; (x w, y w, depth w, w), x and y in texels
fn umbrage_shadow_coordinate(m: mat4x4f, world: vec3f) -> vec4f {
    let c: vec4f = m[3] + m[0] * world.x + m[1] * world.y + m[2] * world.z;
    return c;
}
`,
            "tap_coordinate": `
// umbrage_tap_coordinate: coordinate, before the division by w, moved by offset texels
fn umbrage_tap_coordinate(coordinate: vec4f, offset: vec2f) -> vec4f {
    let moved: vec2f = vec2f(coordinate.x, coordinate.y) + offset * coordinate.w;
    return vec4f(moved.x, moved.y, coordinate.z, coordinate.w);
}
`,
            "project_coordinate": `
// umbrage_project_coordinate: (x, y) in texels and depth; for w <= 0.0 a coordinate that every filter takes as lit
fn umbrage_project_coordinate(coordinate: vec4f) -> vec3f {
    let p: vec3f = vec3f(coordinate.x / coordinate.w, coordinate.y / coordinate.w, coordinate.z / coordinate.w);
    return select(vec3f(65536.0, 65536.0, 0.0), p, coordinate.w > 0.0);
}
`,
            "cascade_by_depth": `
// umbrage_cascade_by_depth: the cascade that a distance along the camera's axis falls into, 0.0 to 3.0
//   ends  of the first three cascades, ascending
fn umbrage_cascade_by_depth(depth: f32, ends: vec3f) -> f32 {
    let reached: i32 = i32(depth >= ends.x) + i32(depth >= ends.y) + i32(depth >= ends.z);
    return f32(reached);
}
`,
            "cascade_column": `
// umbrage_cascade_column: a column of a matrix by its number, 0.0 to 3.0, for languages without dynamic indices
fn umbrage_cascade_column(columns: mat4x4f, number: f32) -> vec4f {
    let low: vec4f = select(columns[1], columns[0], number < 0.5);
    let high: vec4f = select(columns[3], columns[2], number < 2.5);
    return select(high, low, number < 1.5);
}
`,
            "cascade_column_8": `
// umbrage_cascade_column_8: a column of two matrices by its number, 0.0 to 7.0
fn umbrage_cascade_column_8(nearer: mat4x4f, farther: mat4x4f, number: f32) -> vec4f {
    let low: vec4f = umbrage_cascade_column(nearer, number);
    let high: vec4f = umbrage_cascade_column(farther, number - 4.0);
    return select(high, low, number < 3.5);
}
`,
            "cascade_coordinate": `
// umbrage_cascade_coordinate: a point, rotated into the light's directions, in a cascade's map: texels and depth
fn umbrage_cascade_coordinate(light: vec3f, scale: vec4f, offset: vec4f) -> vec3f {
    let start: vec3f = vec3f(offset.x, offset.y, offset.z);
    let at: vec3f = light * vec3f(scale.x, scale.y, scale.z) + start;
    return at;
}
`,
            "inside_cascade": `
// umbrage_inside_cascade: whether a filter of some reach around a coordinate stays inside a map of size texels
fn umbrage_inside_cascade(coordinate: vec3f, size: vec2f, reach: f32) -> bool {
    let end: vec2f = size - reach;
    // y doubled on purpose: Mesa makes min(x, y) >= reach of two comparisons with one limit, which loses a NaN
    let in_x: bool = coordinate.x >= reach && coordinate.x <= end.x;
    let in_y: bool = coordinate.y * 2.0 >= reach * 2.0 && coordinate.y * 2.0 <= end.y * 2.0;
    return in_x && in_y && coordinate.z >= 0.0 && coordinate.z <= 1.0;
}
`,
            "cascade_by_projection": `
// umbrage_cascade_by_projection: (texels, texels, depth, number) in the first of four cascades that holds a point and
//   its filter; where none does, number 4.0 and a coordinate that every filter takes as lit
//   light            the point, rotated into the light's directions
//   scales, offsets  of the cascades;   size  of each map;   reach  of the filter, in texels
fn umbrage_cascade_by_projection(light: vec3f, scales: mat4x4f, offsets: mat4x4f, size: vec2f, reach: f32) -> vec4f {
    let a: vec3f = umbrage_cascade_coordinate(light, scales[0], offsets[0]);
    let b: vec3f = umbrage_cascade_coordinate(light, scales[1], offsets[1]);
    let c: vec3f = umbrage_cascade_coordinate(light, scales[2], offsets[2]);
    let d: vec3f = umbrage_cascade_coordinate(light, scales[3], offsets[3]);
    var found: vec4f = vec4f(65536.0, 65536.0, 0.0, 4.0);
    found = select(found, vec4f(d, 3.0), umbrage_inside_cascade(d, size, reach));
    found = select(found, vec4f(c, 2.0), umbrage_inside_cascade(c, size, reach));
    found = select(found, vec4f(b, 1.0), umbrage_inside_cascade(b, size, reach));
    return select(found, vec4f(a, 0.0), umbrage_inside_cascade(a, size, reach));
}
`,
            "cascade_by_projection_8": `
// umbrage_cascade_by_projection_8: umbrage_cascade_by_projection of eight cascades, four and four; number 8.0 for none
fn umbrage_cascade_by_projection_8(light: vec3f, scales: mat4x4f, offsets: mat4x4f, farther_scales: mat4x4f,
                                   farther_offsets: mat4x4f, size: vec2f, reach: f32) -> vec4f {
    let nearer: vec4f = umbrage_cascade_by_projection(light, scales, offsets, size, reach);
    let farther: vec4f = umbrage_cascade_by_projection(light, farther_scales, farther_offsets, size, reach);
    return select(vec4f(farther.x, farther.y, farther.z, farther.w + 4.0), nearer, nearer.w < 3.5);
}
`,
            "cascade_tile": `
// umbrage_cascade_tile: first texel of a cascade, a whole number, in an atlas of tiles of size texels, two a row
fn umbrage_cascade_tile(number: f32, size: vec2f) -> vec2f {
    let row: f32 = floor(number * 0.5);
    return vec2f(number - row * 2.0, row) * size;
}
`,
            "cascade_weight": `
// umbrage_cascade_weight: v taken down to steps of 1/256, from 0.0 to 1.0; NaN is 0.0
fn umbrage_cascade_weight(v: f32) -> f32 {
    let steps: f32 = select(select(0.0, 256.0, v >= 1.0), floor(v * 256.0), v > 0.0 && v < 1.0);
    return steps * (1.0 / 256.0);
}
`,
            "cascade_fade": `
// umbrage_cascade_fade: weight of the next cascade at a distance along the camera's axis; depth * scale + offset
fn umbrage_cascade_fade(depth: f32, scale: f32, offset: f32) -> f32 {
    let v: f32 = depth * scale + offset;
    return umbrage_cascade_weight(v);
}
`,
            "cascade_border_fade": `
// umbrage_cascade_border_fade: weight of the next cascade, 1.0 from reach texels off the border of a map on
//   coordinate, size  in texels;   per_texel  weight a texel, 1.0 / width of the band along the border
fn umbrage_cascade_border_fade(coordinate: vec2f, size: vec2f, reach: f32, per_texel: f32) -> f32 {
    let half_size: vec2f = size * 0.5;
    let beyond: vec2f = abs(coordinate - half_size) - (half_size - reach);
    let v: vec2f = beyond * per_texel + 1.0;
    let x: f32 = umbrage_cascade_weight(v.x);
    let y: f32 = umbrage_cascade_weight(v.y);
    return select(y, x, x > y);
}
`,
            "blend_cascades": `
// umbrage_blend_cascades: visibilities of a cascade and of the next one, which counts by weight, mixed
fn umbrage_blend_cascades(nearer: f32, farther: f32, weight: f32) -> f32 {
    let sum: f32 = nearer + (farther - nearer) * weight;
    return select(farther, sum, weight < 1.0);
}
`,
            "inside_texel_space": `
// umbrage_inside_texel_space: coordinates in texels that a filter can take; it takes all others, NaN included, as lit
fn umbrage_inside_texel_space(coord: vec2f) -> bool {
    // two limits on purpose: Mesa makes max(x, y) < limit of one, which loses a NaN
    return abs(coord.x) < 32768.0 && abs(coord.y) * 2.0 < 65536.0;
}
`,
            "dither_threshold": `
// umbrage_dither_threshold: one of 16 thresholds, 1/32 to 31/32, for a position in pixels; each once in 4 x 4 pixels
fn umbrage_dither_threshold(pixel: vec2f) -> f32 {
    let whole: vec2f = select(vec2f(0.0, 0.0), floor(pixel), umbrage_inside_texel_space(pixel));
    let high: vec2f = floor(whole * 0.5);
    let above: vec2f = floor(whole * 0.25);
    let b0: vec2f = whole - high * 2.0;
    let b1: vec2f = high - above * 2.0;
    let m: f32 = abs(b0.x - b0.y) * 8.0 + b0.y * 4.0 + abs(b1.x - b1.y) * 2.0 + b1.y;
    return (m + 0.5) * (1.0 / 16.0);
}
`,
            "dithered_cascade": `
// umbrage_dithered_cascade: number of a cascade, or of the next one where its weight is above the pixel's threshold
fn umbrage_dithered_cascade(number: f32, weight: f32, threshold: f32) -> f32 {
    return number + select(0.0, 1.0, weight > threshold);
}
`,
            "cube_face": `
// umbrage_cube_face: the face that a direction meets, 0.0 to 5.0: +x, -x, +y, -y, +z, -z
fn umbrage_cube_face(direction: vec3f) -> f32 {
    let m: vec3f = abs(direction);
    let x: f32 = select(0.0, 1.0, direction.x < 0.0);
    let y: f32 = select(2.0, 3.0, direction.y < 0.0);
    let z: f32 = select(4.0, 5.0, direction.z < 0.0);
    // not m.x >= m.y && m.x >= m.z, of which Mesa makes one with max(m.y, m.z), which loses a NaN
    return select(select(z, y, m.y >= m.z), select(z, x, m.x >= m.z), m.x >= m.y);
}
`,
            "cube_view_z": `
// umbrage_cube_view_z: the greatest component's magnitude, of which per-face depths are made
fn umbrage_cube_view_z(direction: vec3f) -> f32 {
    let face: f32 = umbrage_cube_face(direction);
    let side: f32 = select(direction.y, direction.x, face < 1.5);
    return abs(select(side, direction.z, face > 3.5));
}
`,
            "cube_plane": `
// umbrage_cube_plane: (sc, tc, face) of a direction: its components to the sides of the face that it meets
fn umbrage_cube_plane(direction: vec3f) -> vec3f {
    let face: f32 = umbrage_cube_face(direction);
    let x: vec3f = vec3f(select(direction.z, -direction.z, face < 0.5), -direction.y, face);
    let y: vec3f = vec3f(direction.x, select(-direction.z, direction.z, face < 2.5), face);
    let z: vec3f = vec3f(select(-direction.x, direction.x, face < 4.5), -direction.y, face);
    return select(select(z, y, face < 3.5), x, face < 1.5);
}
`,
            "cube_point": `
// umbrage_cube_point: from (sc, tc, distance along its axis) of a face, 0.0 to 5.0
fn umbrage_cube_point(face: f32, p: vec3f) -> vec3f {
    let x: vec3f = select(vec3f(-p.z, -p.y, p.x), vec3f(p.z, -p.y, -p.x), face < 0.5);
    let y: vec3f = select(vec3f(p.x, -p.z, -p.y), vec3f(p.x, p.z, p.y), face < 2.5);
    let z: vec3f = select(vec3f(-p.x, -p.y, -p.z), vec3f(p.x, -p.y, p.z), face < 4.5);
    return select(select(z, y, face < 3.5), x, face < 1.5);
}
`,
            "cube_face_point": `
// umbrage_cube_face_point: (sc, tc, distance along its axis) in a face, 0.0 to 5.0, of a point from the cube's middle
fn umbrage_cube_face_point(face: f32, p: vec3f) -> vec3f {
    let x: vec3f = select(vec3f(p.z, -p.y, -p.x), vec3f(-p.z, -p.y, p.x), face < 0.5);
    let y: vec3f = select(vec3f(p.x, -p.z, -p.y), vec3f(p.x, p.z, p.y), face < 2.5);
    let z: vec3f = select(vec3f(-p.x, -p.y, -p.z), vec3f(p.x, -p.y, p.z), face < 4.5);
    return select(select(z, y, face < 3.5), x, face < 1.5);
}
`,
            "cube_coordinate": `
// umbrage_cube_coordinate: (s, t, face) of a direction; s and t go from 0.0 to 1.0 over the face
fn umbrage_cube_coordinate(direction: vec3f) -> vec3f {
    let p: vec3f = umbrage_cube_plane(direction);
    let m: f32 = umbrage_cube_view_z(direction);
    return vec3f((p.x + m) / (m + m), (p.y + m) / (m + m), p.z);
}
`,
            "cube_direction": `
// umbrage_cube_direction: from a cube's middle to a point of a face, 0.0 to 5.0; st goes from 0.0 to 1.0 over the face
fn umbrage_cube_direction(face: f32, st: vec2f) -> vec3f {
    let uv: vec2f = st * 2.0 - 1.0;  // an exact product: fused or not, it rounds once
    return umbrage_cube_point(face, vec3f(uv, 1.0));
}
`,
            "cube_neighbor": `
// umbrage_cube_neighbor: (s, t, face) of a texel that may lie beyond an edge of its face; face -1.0 beyond a corner
//   texel  (s, t, face), whole numbers;   size  of a face, in texels
fn umbrage_cube_neighbor(texel: vec3f, size: f32) -> vec3f {
    let uv: vec2f = vec2f(texel.x, texel.y) * 2.0 + (1.0 - size);
    let beyond_u: bool = abs(uv.x) > size;
    let beyond_v: bool = abs(uv.y) > size;
    let m: f32 = select(size, size - 1.0, beyond_u || beyond_v);
    let p: vec3f = umbrage_cube_plane(umbrage_cube_point(texel.z, vec3f(uv, m)));
    let inside: vec2f = (vec2f(p.x, p.y) + (size - 1.0)) * 0.5;
    return select(vec3f(inside, p.z), vec3f(0.0, 0.0, -1.0), beyond_u && beyond_v);
}
`,
            "cube_tile": `
// umbrage_cube_tile: first texel of a face, 0.0 to 5.0, in an atlas of 3 x 2 tiles of size texels
fn umbrage_cube_tile(face: f32, size: f32) -> vec2f {
    let row: f32 = select(1.0, 0.0, face < 2.5);
    return vec2f((face - row * 3.0) * size, row * size);
}
`,
            "cube_atlas_texel": `
// umbrage_cube_atlas_texel: (s, t, face) of a texel of an atlas of 3 x 2 tiles of size texels; whole numbers
fn umbrage_cube_atlas_texel(texel: vec2f, size: f32) -> vec3f {
    let column: f32 = select(select(2.0, 1.0, texel.x < size * 2.0), 0.0, texel.x < size);
    let row: f32 = select(1.0, 0.0, texel.y < size);
    return vec3f(texel - vec2f(column, row) * size, column + row * 3.0);
}
`,
            "cube_atlas_direction": `
// umbrage_cube_atlas_direction: from a cube's middle to that of a texel of an atlas of 3 x 2 tiles of size texels
fn umbrage_cube_atlas_direction(texel: vec2f, size: f32) -> vec3f {
    let part: vec3f = umbrage_cube_atlas_texel(texel, size);
    let uv: vec2f = vec2f(part.x, part.y) * 2.0 + (1.0 - size);
    return umbrage_cube_point(part.z, vec3f(uv, size));
}
`,
            "dual_paraboloid_coordinate": `
// umbrage_dual_paraboloid_coordinate: (s, t, map) of a direction: 0.0 to 1.0 over the map's square, map 0.0 or 1.0
fn umbrage_dual_paraboloid_coordinate(direction: vec3f) -> vec3f {
    let square: f32 = direction.x * direction.x + direction.y * direction.y + direction.z * direction.z;
    let behind: bool = direction.z < 0.0;
    let m: f32 = sqrt(square) + select(direction.z, -direction.z, behind);
    let x: f32 = select(-direction.x, direction.x, behind);
    return vec3f((x + m) / (m + m), (direction.y + m) / (m + m), select(0.0, 1.0, behind));
}
`,
            "dual_paraboloid_position": `
// umbrage_dual_paraboloid_position: (x w, y w, distance w, w) of a vertex, for the depth pass' projection
//   direction  from the light to the vertex;   map  0.0 or 1.0
fn umbrage_dual_paraboloid_position(direction: vec3f, map: f32) -> vec4f {
    let behind: bool = map > 0.5;
    let square: f32 = direction.x * direction.x + direction.y * direction.y + direction.z * direction.z;
    let distance_to: f32 = sqrt(square);
    let w: f32 = distance_to + select(direction.z, -direction.z, behind);
    return vec4f(select(-direction.x, direction.x, behind), direction.y, distance_to * w, w);
}
`,
            "tetrahedron_face": `
// umbrage_tetrahedron_face: the face that a direction meets, 0.0 to 3.0: down and +z, down and -z, up and +x, up and -x
fn umbrage_tetrahedron_face(direction: vec3f) -> f32 {
    let beside: f32 = abs(direction.z) - abs(direction.x);
    let up: f32 = direction.y * 1.414213562;
    let z: f32 = select(0.0, 1.0, direction.z < 0.0);
    let x: f32 = select(2.0, 3.0, direction.x < 0.0);
    return select(x, z, beside >= up);
}
`,
            "tetrahedron_face_point": `
// umbrage_tetrahedron_face_point: (along the base, up, away) of a direction in the axes of a face, 0.0 to 3.0
fn umbrage_tetrahedron_face_point(face: f32, d: vec3f) -> vec3f {
    let z: vec3f = select(vec3f(d.x, d.y, -d.z), vec3f(-d.x, d.y, d.z), face < 0.5);
    let x: vec3f = select(vec3f(d.z, -d.y, -d.x), vec3f(-d.z, -d.y, d.x), face < 2.5);
    return select(x, z, face < 1.5);
}
`,
            "tetrahedron_plane": `
// umbrage_tetrahedron_plane: (along the base, up, away) of a direction in the axes of the face that it meets
fn umbrage_tetrahedron_plane(direction: vec3f) -> vec3f {
    return umbrage_tetrahedron_face_point(umbrage_tetrahedron_face(direction), direction);
}
`,
            "tetrahedron_view_z": `
// umbrage_tetrahedron_view_z: distance along the face's normal, of which per-face depths are made
fn umbrage_tetrahedron_view_z(direction: vec3f) -> f32 {
    let p: vec3f = umbrage_tetrahedron_plane(direction);
    let z: f32 = p.z * 0.816496581 + p.y * -0.577350269;
    return z;
}
`,
            "tetrahedron_coordinate": `
// umbrage_tetrahedron_coordinate: (s, t, face) of a direction: -1.0 to 1.0 along the base, 0.0 at it to 1.0 at the apex
fn umbrage_tetrahedron_coordinate(direction: vec3f) -> vec3f {
    let p: vec3f = umbrage_tetrahedron_plane(direction);
    let d: f32 = p.z * 2.0 + p.y * -1.414213562;
    return vec3f(p.x / d, p.z / d, umbrage_tetrahedron_face(direction));
}
`,
            "tetrahedron_turned": `
// umbrage_tetrahedron_turned: a vector of face 0's side of the map on that of a face, 0.0 to 3.0
fn umbrage_tetrahedron_turned(face: f32, v: vec2f) -> vec2f {
    let z: vec2f = select(vec2f(-v.x, -v.y), v, face < 0.5);
    let x: vec2f = select(vec2f(v.y, -v.x), vec2f(-v.y, v.x), face < 2.5);
    return select(x, z, face < 1.5);
}
`,
            "tetrahedron_texel": `
// umbrage_tetrahedron_texel: texels of a square map, from (s, t, face) on a tetrahedron
//   size  of the map, in texels;   border  along the sides of each triangle, in texels
fn umbrage_tetrahedron_texel(at: vec3f, size: f32, border: f32) -> vec2f {
    let half_size: f32 = size * 0.5;
    let scale: f32 = half_size - border * 3.0;
    let x: f32 = at.x * scale;
    let y: f32 = at.y * scale + (border - half_size);
    let texel: vec2f = umbrage_tetrahedron_turned(at.z, vec2f(x, y)) + half_size;
    return texel;
}
`,
            "tetrahedron_face_of": `
// umbrage_tetrahedron_face_of: the face, 0.0 to 3.0, whose triangle in a map of size texels a texel lies in
fn umbrage_tetrahedron_face_of(texel: vec2f, size: f32) -> f32 {
    let off: vec2f = texel * 2.0 + (1.0 - size);
    let column: f32 = select(1.0, 0.0, off.y < 0.0);
    let row: f32 = select(2.0, 3.0, off.x < 0.0);
    return select(row, column, abs(off.y) >= abs(off.x));
}
`,
            "pancake": `
// umbrage_pancake: a clip space position, moved onto the near plane where it lies before it
//   at_near  z/w of the near plane: 0.0 or -1.0, or 1.0 for reversed depth
fn umbrage_pancake(position: vec4f, at_near: f32) -> vec4f {
    let plane: f32 = at_near * position.w;
    let before: bool = select((position.z < plane), (position.z > plane), at_near > 0.5);
    return vec4f(position.x, position.y, select(position.z, plane, before), position.w);
}
`,
            "texel": `
// umbrage_texel: value of a texel inside the map
//   map    where its texels lie; a sampler that reads them filters by nearest
//   size   of the map in texels;   texel  whole numbers, (0, 0) is the first
fn umbrage_texel(UMBRAGE_MAP map, size: vec2f, texel: vec2f) -> vec4f {
    let at: vec2f = texel + UMBRAGE_ORIGIN;
    return UMBRAGE_TEXEL;
}
`,
            "from_unorm": `
// umbrage_from_unorm: channel 0..255 behind a value read from an 8-bit texture, however the driver divides by 255
fn umbrage_from_unorm(c: f32) -> f32 {
    return floor(c * 255.0 + 0.5);
}
fn umbrage_from_unorm_vec2f(c: vec2f) -> vec2f {
    return floor(c * 255.0 + 0.5);
}
fn umbrage_from_unorm_vec3f(c: vec3f) -> vec3f {
    return floor(c * 255.0 + 0.5);
}
fn umbrage_from_unorm_vec4f(c: vec4f) -> vec4f {
    return floor(c * 255.0 + 0.5);
}
`,
            "page_coordinate": `
// umbrage_page_coordinate: a receiver in a page of an atlas: texels of the page with its gutter, the page's first texel
//   table, size   page table, RGBA8, nearest filter;   coord   receiver, from 1.0 to 2.0 across all but its border
//   page, gutter  side of a page and what it has around it, texels
fn umbrage_page_coordinate(UMBRAGE_MAP table, size: vec2f, coord: vec2f, page: f32, gutter: f32) -> vec4f {
    // not negative already; compilers cannot regroup sums across max and clamp
    let sides: vec2f = max(size - 2.0, vec2f(1.0, 1.0));
    let before: vec2f = max(size - 3.0, vec2f(0.0, 0.0));
    let cell: vec2f = min(max(vec2f(0.0, 0.0), coord * sides - before), size - 1.0);
    let texel: vec2i = vec2i(cell);  // of a NaN the first
    let entry: vec4f = umbrage_from_unorm_vec4f(umbrage_texel(table, size, vec2f(texel)));
    let slot: vec2f = vec2f(entry.x, entry.y);
    let across: f32 = entry.z + entry.w * 256.0;
    let within: vec2f = clamp(fract(coord * across), vec2f(0.0, 0.0), vec2f(1.0, 1.0));
    let at: vec2f = within * page + select(32768.0, gutter, across > 0.0);
    return vec4f(at, slot * (page + gutter * 2.0));
}
`,
            "linear_depth": `
// umbrage_linear_depth: distance along the light's axis, positive in front of it, times 1 / z_far
fn umbrage_linear_depth(z_view: f32, inv_z_far: f32) -> f32 {
    return z_view * inv_z_far;
}
`,
            "project_depth": `
// umbrage_project_depth: z / w; for w <= 0.0 cleared, which is 1.0, or 0.0 when reversed
fn umbrage_project_depth(z: f32, w: f32, cleared: f32) -> f32 {
    return select(cleared, z / w, w > 0.0);
}
`,
            "distance_depth": `
// umbrage_distance_depth: length of to_point, from the light, times 1 / range
fn umbrage_distance_depth(to_point: vec3f, inv_range: f32) -> f32 {
    return sqrt(to_point.x * to_point.x + to_point.y * to_point.y + to_point.z * to_point.z) * inv_range;
}
`,
            "reverse_depth": `
// umbrage_reverse_depth: forward depth from reversed, or reversed from forward
fn umbrage_reverse_depth(depth: f32) -> f32 {
    return 1.0 - depth;
}
`,
            "depth_from_ndc": `
// umbrage_depth_from_ndc: depth in [0, 1] from z/w in [-1, 1]
fn umbrage_depth_from_ndc(ndc: f32) -> f32 {
    let depth: f32 = ndc * 0.5 + 0.5;
    return depth;
}
`,
            "view_z_from_depth": `
// umbrage_view_z_from_depth: perspective depth in [0, 1], 0.0 at z_near, to distance along the light's axis
fn umbrage_view_z_from_depth(depth: f32, z_near: f32, z_far: f32) -> f32 {
    return z_near / (1.0 - depth * (1.0 - z_near / z_far));
}
`,
            "depth_from_view_z": `
// umbrage_depth_from_view_z: distance along the light's axis to perspective depth in [0, 1], 0.0 at z_near
fn umbrage_depth_from_view_z(z_view: f32, z_near: f32, z_far: f32) -> f32 {
    return (1.0 - z_near / z_view) / (1.0 - z_near / z_far);
}
`,
            "view_z_from_reversed_depth": `
// umbrage_view_z_from_reversed_depth: perspective depth in [0, 1], 1.0 at z_near, to distance along the light's axis
fn umbrage_view_z_from_reversed_depth(depth: f32, z_near: f32, z_far: f32) -> f32 {
    return z_near / (z_near / z_far + depth * (1.0 - z_near / z_far));
}
`,
            "reversed_depth_from_view_z": `
// umbrage_reversed_depth_from_view_z: distance along the light's axis to perspective depth in [0, 1], 1.0 at z_near
fn umbrage_reversed_depth_from_view_z(z_view: f32, z_near: f32, z_far: f32) -> f32 {
    return z_near / z_view * (1.0 - z_view / z_far) / (1.0 - z_near / z_far);
}
`,
            "view_z_from_orthographic_depth": `
// umbrage_view_z_from_orthographic_depth: orthographic depth in [0, 1], 0.0 at z_near, to distance along the light's
// axis; when reversed, exchange z_near and z_far
fn umbrage_view_z_from_orthographic_depth(depth: f32, z_near: f32, z_far: f32) -> f32 {
    let z_view: f32 = z_near + depth * (z_far - z_near);
    return z_view;
}
`,
            "orthographic_depth_from_view_z": `
// umbrage_orthographic_depth_from_view_z: distance along the light's axis to orthographic depth in [0, 1], 0.0 at
// z_near; when reversed, exchange z_near and z_far
fn umbrage_orthographic_depth_from_view_z(z_view: f32, z_near: f32, z_far: f32) -> f32 {
    return (z_view - z_near) / (z_far - z_near);
}
`,
            "cleared_depth": `
// umbrage_cleared_depth: depth of the far plane
fn umbrage_cleared_depth() -> f32 {
    return 1.0;
}
`,
            "saturate": `
// umbrage_saturate: v clamped to [0, 1]; NaN becomes the far plane's depth
fn umbrage_saturate(v: f32) -> f32 {
    // not v > 0.0 ? v : 0.0, of which Mesa makes max(v, 0.0): softpipe's gives NaN for a signalling one
    return select(select(select(umbrage_cleared_depth(), 0.0, v <= 0.0), 1.0, v >= 1.0), v, v > 0.0 && v < 1.0);
}
`,
            "correct_quotient": `
// umbrage_correct_quotient: floor(a / b) from q, at most one off;  whole numbers, a below 2^24, b from 1 to 2^24
fn umbrage_correct_quotient(q: f32, a: f32, b: f32) -> f32 {
    let more: f32 = q + 1.0;
    let known: f32 = select(q, more, more * b <= a);
    return select(known, q - 1.0, q * b > a);
}
`,
            "floor_divide": `
// umbrage_floor_divide: floor(a / b) of whole numbers, a below 2^24, b from 1 to 2^24, the quotient at most 2^18
fn umbrage_floor_divide(a: f32, b: f32) -> f32 {
    return umbrage_correct_quotient(floor(a / b), a, b);
}
`,
            "to_unorm": `
// umbrage_to_unorm: what to write so that an 8-bit target stores channel k, whether it rounds or truncates
// k * 257 / 65536 + 64 / 65536; not written so, since 65536.0 is infinite in mediump
fn umbrage_to_unorm(k: f32) -> f32 {
    return k * 0.0039215087890625 + 0.0009765625;
}
fn umbrage_to_unorm_vec2f(k: vec2f) -> vec2f {
    return k * 0.0039215087890625 + 0.0009765625;
}
fn umbrage_to_unorm_vec3f(k: vec3f) -> vec3f {
    return k * 0.0039215087890625 + 0.0009765625;
}
fn umbrage_to_unorm_vec4f(k: vec4f) -> vec4f {
    return k * 0.0039215087890625 + 0.0009765625;
}
`,
            "to_unorm10": `
// umbrage_to_unorm10: what to write so that a 10-bit target stores channel k, whether it rounds or truncates
// k * 4099 / 4194304 + 1056 / 4194304
fn umbrage_to_unorm10(k: f32) -> f32 {
    return k * 0.0009772777557373046875 + 0.00025177001953125;
}
fn umbrage_to_unorm10_vec2f(k: vec2f) -> vec2f {
    return k * 0.0009772777557373046875 + 0.00025177001953125;
}
fn umbrage_to_unorm10_vec3f(k: vec3f) -> vec3f {
    return k * 0.0009772777557373046875 + 0.00025177001953125;
}
fn umbrage_to_unorm10_vec4f(k: vec4f) -> vec4f {
    return k * 0.0009772777557373046875 + 0.00025177001953125;
}
`,
            "from_unorm10": `
// umbrage_from_unorm10: channel 0..1023 behind a value read from a 10-bit texture, however the driver divides by 1023
fn umbrage_from_unorm10(c: f32) -> f32 {
    return floor(c * 1023.0 + 0.5);
}
fn umbrage_from_unorm10_vec2f(c: vec2f) -> vec2f {
    return floor(c * 1023.0 + 0.5);
}
fn umbrage_from_unorm10_vec3f(c: vec3f) -> vec3f {
    return floor(c * 1023.0 + 0.5);
}
fn umbrage_from_unorm10_vec4f(c: vec4f) -> vec4f {
    return floor(c * 1023.0 + 0.5);
}
`,
            "to_unorm16": `
// umbrage_to_unorm16: what to write so that a 16-bit target stores channel k, whether it rounds or truncates
fn umbrage_to_unorm16(k: f32) -> f32 {
    return min(k + (floor(k * (1.0 / 256.0)) * (1.0 / 256.0) + 0.25), 65536.0) * (1.0 / 65536.0);
}
fn umbrage_to_unorm16_vec2f(k: vec2f) -> vec2f {
    return min(k + (floor(k * (1.0 / 256.0)) * (1.0 / 256.0) + 0.25), vec2f(65536.0)) * (1.0 / 65536.0);
}
fn umbrage_to_unorm16_vec3f(k: vec3f) -> vec3f {
    return min(k + (floor(k * (1.0 / 256.0)) * (1.0 / 256.0) + 0.25), vec3f(65536.0)) * (1.0 / 65536.0);
}
fn umbrage_to_unorm16_vec4f(k: vec4f) -> vec4f {
    return min(k + (floor(k * (1.0 / 256.0)) * (1.0 / 256.0) + 0.25), vec4f(65536.0)) * (1.0 / 65536.0);
}
`,
            "from_unorm16": `
// umbrage_from_unorm16: channel 0..65535 behind a value read from a 16-bit texture, however the driver divides by 65535
fn umbrage_from_unorm16(c: f32) -> f32 {
    return floor(c * 65535.0 + 0.5);
}
fn umbrage_from_unorm16_vec2f(c: vec2f) -> vec2f {
    return floor(c * 65535.0 + 0.5);
}
fn umbrage_from_unorm16_vec3f(c: vec3f) -> vec3f {
    return floor(c * 65535.0 + 0.5);
}
fn umbrage_from_unorm16_vec4f(c: vec4f) -> vec4f {
    return floor(c * 65535.0 + 0.5);
}
`,
            "encode_rg9": `
// umbrage_encode_rg9: depth to the two channels of a 9-bit code, whole numbers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1], NaN counts as far
fn umbrage_encode_rg9(depth: f32) -> vec2f {
    let x: f32 = min(floor(umbrage_saturate(depth) * 512.0), 511.0);
    let high: f32 = floor(x * (1.0 / 256.0));
    return vec2f(x - high * 256.0, high * 128.0);
}
`,
            "encode_rg10": `
// umbrage_encode_rg10: depth to the two channels of a 10-bit code, whole numbers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1], NaN counts as far
fn umbrage_encode_rg10(depth: f32) -> vec2f {
    let x: f32 = min(floor(umbrage_saturate(depth) * 1024.0), 1023.0);
    let high: f32 = floor(x * (1.0 / 256.0));
    return vec2f(x - high * 256.0, high * 64.0);
}
`,
            "encode_rg11": `
// umbrage_encode_rg11: depth to the two channels of a 11-bit code, whole numbers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1], NaN counts as far
fn umbrage_encode_rg11(depth: f32) -> vec2f {
    let x: f32 = min(floor(umbrage_saturate(depth) * 2048.0), 2047.0);
    let high: f32 = floor(x * (1.0 / 256.0));
    return vec2f(x - high * 256.0, high * 32.0);
}
`,
            "encode_rg12": `
// umbrage_encode_rg12: depth to the two channels of a 12-bit code, whole numbers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1], NaN counts as far
fn umbrage_encode_rg12(depth: f32) -> vec2f {
    let x: f32 = min(floor(umbrage_saturate(depth) * 4096.0), 4095.0);
    let high: f32 = floor(x * (1.0 / 256.0));
    return vec2f(x - high * 256.0, high * 16.0);
}
`,
            "encode_rg13": `
// umbrage_encode_rg13: depth to the two channels of a 13-bit code, whole numbers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1], NaN counts as far
fn umbrage_encode_rg13(depth: f32) -> vec2f {
    let x: f32 = min(floor(umbrage_saturate(depth) * 8192.0), 8191.0);
    let high: f32 = floor(x * (1.0 / 256.0));
    return vec2f(x - high * 256.0, high * 8.0);
}
`,
            "encode_rg14": `
// umbrage_encode_rg14: depth to the two channels of a 14-bit code, whole numbers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1], NaN counts as far
fn umbrage_encode_rg14(depth: f32) -> vec2f {
    let x: f32 = min(floor(umbrage_saturate(depth) * 16384.0), 16383.0);
    let high: f32 = floor(x * (1.0 / 256.0));
    return vec2f(x - high * 256.0, high * 4.0);
}
`,
            "encode_rg15": `
// umbrage_encode_rg15: depth to the two channels of a 15-bit code, whole numbers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1], NaN counts as far
fn umbrage_encode_rg15(depth: f32) -> vec2f {
    let x: f32 = min(floor(umbrage_saturate(depth) * 32768.0), 32767.0);
    let high: f32 = floor(x * (1.0 / 256.0));
    return vec2f(x - high * 256.0, high * 2.0);
}
`,
            "encode_rg16": `
// umbrage_encode_rg16: depth to the two channels of a 16-bit code, whole numbers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1], NaN counts as far
fn umbrage_encode_rg16(depth: f32) -> vec2f {
    let x: f32 = min(floor(umbrage_saturate(depth) * 65536.0), 65535.0);
    let high: f32 = floor(x * (1.0 / 256.0));
    return vec2f(x - high * 256.0, high * 1.0);
}
`,
            "encode_rgb24": `
// umbrage_encode_rgb24: depth to three channels, R most significant, whole numbers 0..255 for umbrage_to_unorm
//   depth   clamped to [0, 1], NaN counts as far
fn umbrage_encode_rgb24(depth: f32) -> vec3f {
    let x: f32 = min(floor(umbrage_saturate(depth) * 16777216.0), 16777215.0);
    let high: f32 = floor(x * (1.0 / 65536.0));
    let rest: f32 = x - high * 65536.0;
    let middle: f32 = floor(rest * (1.0 / 256.0));
    return vec3f(high, middle, min(rest - middle * 256.0, 255.0));  // below already: no sum is regrouped across the min
}
`,
            "encode_rgb10": `
// umbrage_encode_rgb10: depth to three channels, R most significant, whole numbers 0..1023 for umbrage_to_unorm10
// the last four bits are the high ones of B, so that a target cleared to white is at the far plane
//   depth   clamped to [0, 1], NaN counts as far
fn umbrage_encode_rgb10(depth: f32) -> vec3f {
    let x: f32 = min(floor(umbrage_saturate(depth) * 16777216.0), 16777215.0);
    let high: f32 = floor(x * (1.0 / 16384.0));
    let rest: f32 = x - high * 16384.0;
    let middle: f32 = floor(rest * (1.0 / 16.0));
    let low: f32 = min(rest - middle * 16.0, 15.0);  // below already: no sum is regrouped across the min
    return vec3f(high, middle, low * 64.0);
}
`,
            "encode_r16": `
// umbrage_encode_r16: depth to one channel, a whole number 0..65535 for umbrage_to_unorm16
//   depth   clamped to [0, 1], NaN counts as far
fn umbrage_encode_r16(depth: f32) -> f32 {
    return min(floor(umbrage_saturate(depth) * 65536.0), 65535.0);
}
`,
            "encode_float_bits": `
// umbrage_encode_float_bits: bit pattern of v as four channels, R least significant, whole numbers 0..255
fn umbrage_encode_float_bits(v: f32) -> vec4f {
    let bits: u32 = bitcast<u32>(v);
    return vec4f(f32(bits & 255u), f32((bits >> 8) & 255u), f32((bits >> 16) & 255u), f32(bits >> 24));
}
`,
            "write_threejs_rgba": `
// umbrage_write_threejs_rgba: depth to the RGBA format of three.js r167 and later, values to write as they are
fn umbrage_write_threejs_rgba(depth: f32) -> vec4f {
    let v: f32 = umbrage_saturate(depth);
    let x: f32 = v * 16777216.0;
    let whole: f32 = floor(x);
    let high: f32 = floor(whole * (1.0 / 65536.0));
    let rest: f32 = whole - high * 65536.0;
    let middle: f32 = floor(rest * (1.0 / 256.0));
    let low: f32 = rest - middle * 256.0;
    let c: vec4f = vec4f(high * 0.00392156886, middle * 0.00392156886, low * 0.00392156886, x - whole);
    return select(vec4f(1.0, 1.0, 1.0, 1.0), c, v < 1.0);
}
`,
            "write_threejs_rgb": `
// umbrage_write_threejs_rgb: depth to the RGB format of three.js r167 and later, values to write as they are
fn umbrage_write_threejs_rgb(depth: f32) -> vec3f {
    let v: f32 = umbrage_saturate(depth);
    let x: f32 = v * 65536.0;
    let whole: f32 = floor(x);
    let high: f32 = floor(whole * (1.0 / 256.0));
    let c: vec3f = vec3f(high * 0.00392156886, (whole - high * 256.0) * 0.00392156886, x - whole);
    return select(vec3f(1.0, 1.0, 1.0), c, v < 1.0);
}
`,
            "write_threejs_rg": `
// umbrage_write_threejs_rg: depth to the RG format of three.js r167 and later, values to write as they are
fn umbrage_write_threejs_rg(depth: f32) -> vec2f {
    let v: f32 = umbrage_saturate(depth);
    let x: f32 = v * 256.0;
    let whole: f32 = floor(x);
    return select(vec2f(1.0, 1.0), vec2f(whole * 0.00392156886, x - whole), v < 1.0);
}
`,
            "write_threejs_legacy": `
// umbrage_write_threejs_legacy: depth to the RGBA format of three.js r73 to r166, values to write as they are;
//   1.0 reads back as 255/256: umbrage_encode_threejs_legacy_repaired does not
fn umbrage_write_threejs_legacy(depth: f32) -> vec4f {
    let v: f32 = umbrage_saturate(depth);
    let x: f32 = v * 16777216.0 - floor(v * 16777216.0);
    let y: f32 = v * 65536.0 - floor(v * 65536.0);
    let z: f32 = v * 256.0 - floor(v * 256.0);
    let c: vec4f = vec4f(x, y - x * (1.0 / 256.0), z - y * (1.0 / 256.0), v - z * (1.0 / 256.0));
    return c * 1.00392163;
}
`,
            "encode_threejs_legacy_repaired": `
// umbrage_encode_threejs_legacy_repaired: depth to channels that readers of three.js r73 to r166 decode, 1.0 to 1.0;
//   whole numbers 0..255 (umbrage_to_unorm writes them)
fn umbrage_encode_threejs_legacy_repaired(depth: f32) -> vec4f {
    let v: f32 = umbrage_saturate(depth);
    let x: f32 = floor(v * 16777216.0);
    let high: f32 = floor(x * (1.0 / 65536.0));
    let rest: f32 = x - high * 65536.0;
    let middle: f32 = floor(rest * (1.0 / 256.0));
    let low: f32 = min(rest - middle * 256.0, 255.0);  // below already: no sum is regrouped across the min
    return select(vec4f(255.0, 255.0, 255.0, 255.0), vec4f(0.0, low, middle, high), v < 1.0);
}
`,
            "write_base255": `
// umbrage_write_base255: depth to base-255 RGBA, values to write as they are; 1.0 reads back as 0.0, and the store must
//   round: umbrage_encode_base255_repaired has neither fault
fn umbrage_write_base255(depth: f32) -> vec4f {
    let v: f32 = umbrage_saturate(depth);
    var e: vec4f = vec4f(v, v * 255.0, v * 65025.0, v * 16581375.0);
    e = e - floor(e);
    let c: vec4f = vec4f(e.x - e.y * 0.00392156886, e.y - e.z * 0.00392156886, e.z - e.w * 0.00392156886, e.w);
    return c;
}
`,
            "encode_base255_repaired": `
// umbrage_encode_base255_repaired: depth to channels that readers of base-255 RGBA decode, 1.0 to 1.0;
//   whole numbers 0..255 (umbrage_to_unorm writes them)
fn umbrage_encode_base255_repaired(depth: f32) -> vec4f {
    let x: f32 = umbrage_saturate(depth) * 255.0;
    let y: f32 = (x - floor(x)) * 255.0;
    let z: f32 = (y - floor(y)) * 255.0;
    let w: f32 = (z - floor(z)) * 255.0;
    return vec4f(floor(x), floor(y), floor(z), floor(w));
}
`,
            "fetch_clamped": `
// umbrage_fetch_clamped: texel of a map; coordinates outside move to the nearest texel inside
fn umbrage_fetch_clamped(UMBRAGE_MAP map, size: vec2f, texel: vec2f) -> vec4f {
    return umbrage_texel(map, size, clamp(texel, vec2f(0.0, 0.0), size - 1.0));
}
`,
            "encode_rg9_table": `
// umbrage_encode_rg9_table: depth to the two channels of a 9-bit code through a look-up table, whole numbers 0..255
//   table   512 x 1 texels, row after row, nearest filter;   depth   clamped to [0, 1], NaN counts as far
fn umbrage_encode_rg9_table(UMBRAGE_MAP table, depth: f32) -> vec2f {
    let x: f32 = min(floor(umbrage_saturate(depth) * 512.0), 511.0);
    let row: f32 = floor(x * (1.0 / 512.0));
    let texel: vec2f = vec2f(x - row * 512.0, row);
    let k: vec4f = umbrage_from_unorm_vec4f(umbrage_fetch_clamped(table, vec2f(512.0, 1.0), texel));
    return vec2f(k.x, k.y);
}
`,
            "encode_rg10_table": `
// umbrage_encode_rg10_table: depth to the two channels of a 10-bit code through a look-up table, whole numbers 0..255
//   table   1024 x 1 texels, row after row, nearest filter;   depth   clamped to [0, 1], NaN counts as far
fn umbrage_encode_rg10_table(UMBRAGE_MAP table, depth: f32) -> vec2f {
    let x: f32 = min(floor(umbrage_saturate(depth) * 1024.0), 1023.0);
    let row: f32 = floor(x * (1.0 / 1024.0));
    let texel: vec2f = vec2f(x - row * 1024.0, row);
    let k: vec4f = umbrage_from_unorm_vec4f(umbrage_fetch_clamped(table, vec2f(1024.0, 1.0), texel));
    return vec2f(k.x, k.y);
}
`,
            "encode_rg11_table": `
// umbrage_encode_rg11_table: depth to the two channels of a 11-bit code through a look-up table, whole numbers 0..255
//   table   2048 x 1 texels, row after row, nearest filter;   depth   clamped to [0, 1], NaN counts as far
fn umbrage_encode_rg11_table(UMBRAGE_MAP table, depth: f32) -> vec2f {
    let x: f32 = min(floor(umbrage_saturate(depth) * 2048.0), 2047.0);
    let row: f32 = floor(x * (1.0 / 2048.0));
    let texel: vec2f = vec2f(x - row * 2048.0, row);
    let k: vec4f = umbrage_from_unorm_vec4f(umbrage_fetch_clamped(table, vec2f(2048.0, 1.0), texel));
    return vec2f(k.x, k.y);
}
`,
            "encode_rg12_table": `
// umbrage_encode_rg12_table: depth to the two channels of a 12-bit code through a look-up table, whole numbers 0..255
//   table   2048 x 2 texels, row after row, nearest filter;   depth   clamped to [0, 1], NaN counts as far
fn umbrage_encode_rg12_table(UMBRAGE_MAP table, depth: f32) -> vec2f {
    let x: f32 = min(floor(umbrage_saturate(depth) * 4096.0), 4095.0);
    let row: f32 = floor(x * (1.0 / 2048.0));
    let texel: vec2f = vec2f(x - row * 2048.0, row);
    let k: vec4f = umbrage_from_unorm_vec4f(umbrage_fetch_clamped(table, vec2f(2048.0, 2.0), texel));
    return vec2f(k.x, k.y);
}
`,
            "encode_rg13_table": `
// umbrage_encode_rg13_table: depth to the two channels of a 13-bit code through a look-up table, whole numbers 0..255
//   table   2048 x 4 texels, row after row, nearest filter;   depth   clamped to [0, 1], NaN counts as far
fn umbrage_encode_rg13_table(UMBRAGE_MAP table, depth: f32) -> vec2f {
    let x: f32 = min(floor(umbrage_saturate(depth) * 8192.0), 8191.0);
    let row: f32 = floor(x * (1.0 / 2048.0));
    let texel: vec2f = vec2f(x - row * 2048.0, row);
    let k: vec4f = umbrage_from_unorm_vec4f(umbrage_fetch_clamped(table, vec2f(2048.0, 4.0), texel));
    return vec2f(k.x, k.y);
}
`,
            "encode_rg14_table": `
// umbrage_encode_rg14_table: depth to the two channels of a 14-bit code through a look-up table, whole numbers 0..255
//   table   2048 x 8 texels, row after row, nearest filter;   depth   clamped to [0, 1], NaN counts as far
fn umbrage_encode_rg14_table(UMBRAGE_MAP table, depth: f32) -> vec2f {
    let x: f32 = min(floor(umbrage_saturate(depth) * 16384.0), 16383.0);
    let row: f32 = floor(x * (1.0 / 2048.0));
    let texel: vec2f = vec2f(x - row * 2048.0, row);
    let k: vec4f = umbrage_from_unorm_vec4f(umbrage_fetch_clamped(table, vec2f(2048.0, 8.0), texel));
    return vec2f(k.x, k.y);
}
`,
            "encode_rg15_table": `
// umbrage_encode_rg15_table: depth to the two channels of a 15-bit code through a look-up table, whole numbers 0..255
//   table   2048 x 16 texels, row after row, nearest filter;   depth   clamped to [0, 1], NaN counts as far
fn umbrage_encode_rg15_table(UMBRAGE_MAP table, depth: f32) -> vec2f {
    let x: f32 = min(floor(umbrage_saturate(depth) * 32768.0), 32767.0);
    let row: f32 = floor(x * (1.0 / 2048.0));
    let texel: vec2f = vec2f(x - row * 2048.0, row);
    let k: vec4f = umbrage_from_unorm_vec4f(umbrage_fetch_clamped(table, vec2f(2048.0, 16.0), texel));
    return vec2f(k.x, k.y);
}
`,
            "encode_rg16_table": `
// umbrage_encode_rg16_table: depth to the two channels of a 16-bit code through a look-up table, whole numbers 0..255
//   table   2048 x 32 texels, row after row, nearest filter;   depth   clamped to [0, 1], NaN counts as far
fn umbrage_encode_rg16_table(UMBRAGE_MAP table, depth: f32) -> vec2f {
    let x: f32 = min(floor(umbrage_saturate(depth) * 65536.0), 65535.0);
    let row: f32 = floor(x * (1.0 / 2048.0));
    let texel: vec2f = vec2f(x - row * 2048.0, row);
    let k: vec4f = umbrage_from_unorm_vec4f(umbrage_fetch_clamped(table, vec2f(2048.0, 32.0), texel));
    return vec2f(k.x, k.y);
}
`,
            "decode_rg9": `
// umbrage_decode_rg9: two channels of a 9-bit code, as sampled, to depth
//   edge   0.0, 0.5, 1.0: lower edge, center, upper edge of the code's interval
fn umbrage_decode_rg9(c: vec2f, edge: f32) -> f32 {
    let k: vec2f = umbrage_from_unorm_vec2f(c);
    return (k.x + k.y * 2.0 + edge) * (1.0 / 512.0);
}
`,
            "decode_rg10": `
// umbrage_decode_rg10: two channels of a 10-bit code, as sampled, to depth
//   edge   0.0, 0.5, 1.0: lower edge, center, upper edge of the code's interval
fn umbrage_decode_rg10(c: vec2f, edge: f32) -> f32 {
    let k: vec2f = umbrage_from_unorm_vec2f(c);
    return (k.x + k.y * 4.0 + edge) * (1.0 / 1024.0);
}
`,
            "decode_rg11": `
// umbrage_decode_rg11: two channels of a 11-bit code, as sampled, to depth
//   edge   0.0, 0.5, 1.0: lower edge, center, upper edge of the code's interval
fn umbrage_decode_rg11(c: vec2f, edge: f32) -> f32 {
    let k: vec2f = umbrage_from_unorm_vec2f(c);
    return (k.x + k.y * 8.0 + edge) * (1.0 / 2048.0);
}
`,
            "decode_rg12": `
// umbrage_decode_rg12: two channels of a 12-bit code, as sampled, to depth
//   edge   0.0, 0.5, 1.0: lower edge, center, upper edge of the code's interval
fn umbrage_decode_rg12(c: vec2f, edge: f32) -> f32 {
    let k: vec2f = umbrage_from_unorm_vec2f(c);
    return (k.x + k.y * 16.0 + edge) * (1.0 / 4096.0);
}
`,
            "decode_rg13": `
// umbrage_decode_rg13: two channels of a 13-bit code, as sampled, to depth
//   edge   0.0, 0.5, 1.0: lower edge, center, upper edge of the code's interval
fn umbrage_decode_rg13(c: vec2f, edge: f32) -> f32 {
    let k: vec2f = umbrage_from_unorm_vec2f(c);
    return (k.x + k.y * 32.0 + edge) * (1.0 / 8192.0);
}
`,
            "decode_rg14": `
// umbrage_decode_rg14: two channels of a 14-bit code, as sampled, to depth
//   edge   0.0, 0.5, 1.0: lower edge, center, upper edge of the code's interval
fn umbrage_decode_rg14(c: vec2f, edge: f32) -> f32 {
    let k: vec2f = umbrage_from_unorm_vec2f(c);
    return (k.x + k.y * 64.0 + edge) * (1.0 / 16384.0);
}
`,
            "decode_rg15": `
// umbrage_decode_rg15: two channels of a 15-bit code, as sampled, to depth
//   edge   0.0, 0.5, 1.0: lower edge, center, upper edge of the code's interval
fn umbrage_decode_rg15(c: vec2f, edge: f32) -> f32 {
    let k: vec2f = umbrage_from_unorm_vec2f(c);
    return (k.x + k.y * 128.0 + edge) * (1.0 / 32768.0);
}
`,
            "decode_rg16": `
// umbrage_decode_rg16: two channels of a 16-bit code, as sampled, to depth
//   edge   0.0, 0.5, 1.0: lower edge, center, upper edge of the code's interval
fn umbrage_decode_rg16(c: vec2f, edge: f32) -> f32 {
    let k: vec2f = umbrage_from_unorm_vec2f(c);
    return (k.x + k.y * 256.0 + edge) * (1.0 / 65536.0);
}
`,
            "decode_rgb24": `
// umbrage_decode_rgb24: three channels, as sampled, to depth
//   edge   0.0 or 1.0: lower or upper edge of the code's interval
fn umbrage_decode_rgb24(c: vec3f, edge: f32) -> f32 {
    let k: vec3f = umbrage_from_unorm_vec3f(c);
    return ((k.x * 256.0 + k.y) * 256.0 + k.z + edge) * (1.0 / 16777216.0);
}
`,
            "decode_rgb10": `
// umbrage_decode_rgb10: three 10-bit channels, as sampled, to depth
//   edge   0.0 or 1.0: lower or upper edge of the code's interval
fn umbrage_decode_rgb10(c: vec3f, edge: f32) -> f32 {
    let k: vec3f = umbrage_from_unorm10_vec3f(c);
    return ((k.x * 1024.0 + k.y) * 16.0 + floor(k.z * (1.0 / 64.0)) + edge) * (1.0 / 16777216.0);
}
`,
            "decode_r16": `
// umbrage_decode_r16: one channel of 16 bits, as sampled, to depth
//   edge   0.0, 0.5 or 1.0: lower edge, center or upper edge of the code's interval
fn umbrage_decode_r16(c: f32, edge: f32) -> f32 {
    return (umbrage_from_unorm16(c) + edge) * (1.0 / 65536.0);
}
`,
            "decode_float_bits": `
// umbrage_decode_float_bits: four channels of a bit pattern, as sampled, R least significant, to the float
fn umbrage_decode_float_bits(c: vec4f) -> f32 {
    let r: u32 = u32(umbrage_saturate(c.x) * 255.0 + 0.5);
    let g: u32 = u32(umbrage_saturate(c.y) * 255.0 + 0.5);
    let b: u32 = u32(umbrage_saturate(c.z) * 255.0 + 0.5);
    let a: u32 = u32(umbrage_saturate(c.w) * 255.0 + 0.5);
    return bitcast<f32>(r | (g << 8) | (b << 16) | (a << 24));
}
`,
            "decode_threejs_rgba": `
// umbrage_decode_threejs_rgba: the RGBA format of three.js r167 and later, as sampled, to depth
fn umbrage_decode_threejs_rgba(c: vec4f) -> f32 {
    let depth: f32 = c.x * (255.0 / 256.0) + c.y * (255.0 / 65536.0) + c.z * (255.0 / 16777216.0) + c.w *
        (1.0 / 16777216.0);
    return depth;
}
`,
            "decode_threejs_rgb": `
// umbrage_decode_threejs_rgb: the RGB format of three.js r167 and later, as sampled, to depth
fn umbrage_decode_threejs_rgb(c: vec3f) -> f32 {
    let depth: f32 = c.x * (255.0 / 256.0) + c.y * (255.0 / 65536.0) + c.z * (1.0 / 65536.0);
    return depth;
}
`,
            "decode_threejs_rg": `
// umbrage_decode_threejs_rg: the RG format of three.js r167 and later, as sampled, to depth
fn umbrage_decode_threejs_rg(c: vec2f) -> f32 {
    let depth: f32 = c.x * (255.0 / 256.0) + c.y * (1.0 / 256.0);
    return depth;
}
`,
            "decode_threejs_legacy": `
// umbrage_decode_threejs_legacy: the RGBA format of three.js r73 to r166, as sampled, to depth
fn umbrage_decode_threejs_legacy(c: vec4f) -> f32 {
    let depth: f32 = c.x * (255.0 / 4294967296.0) + c.y * (255.0 / 16777216.0) + c.z * (255.0 / 65536.0) + c.w *
        (255.0 / 256.0);
    return depth;
}
`,
            "decode_base255": `
// umbrage_decode_base255: base-255 RGBA, as sampled, to depth
fn umbrage_decode_base255(c: vec4f) -> f32 {
    let depth: f32 = c.x + c.y * 0.00392156886 + c.z * 0.0000153787005 + c.w * 0.0000000603086294;
    return depth;
}
`,
            "level_rg9": `
// umbrage_level_rg9: two channels of a 9-bit code, as sampled, to the scale of umbrage_receiver_rg9, on which 1.0 is
//   not the far plane
fn umbrage_level_rg9(c: vec2f) -> f32 {
    return c.x + c.y * 2.0;  // an exact product: fused or not, it rounds once
}
`,
            "level_rg10": `
// umbrage_level_rg10: two channels of a 10-bit code, as sampled, to the scale of umbrage_receiver_rg10, on which 1.0 is
//   not the far plane
fn umbrage_level_rg10(c: vec2f) -> f32 {
    return c.x + c.y * 4.0;  // an exact product: fused or not, it rounds once
}
`,
            "level_rg11": `
// umbrage_level_rg11: two channels of a 11-bit code, as sampled, to the scale of umbrage_receiver_rg11, on which 1.0 is
//   not the far plane
fn umbrage_level_rg11(c: vec2f) -> f32 {
    return c.x + c.y * 8.0;  // an exact product: fused or not, it rounds once
}
`,
            "level_rg12": `
// umbrage_level_rg12: two channels of a 12-bit code, as sampled, to the scale of umbrage_receiver_rg12, on which 1.0 is
//   not the far plane
fn umbrage_level_rg12(c: vec2f) -> f32 {
    return c.x + c.y * 16.0;  // an exact product: fused or not, it rounds once
}
`,
            "level_rg13": `
// umbrage_level_rg13: two channels of a 13-bit code, as sampled, to the scale of umbrage_receiver_rg13, on which 1.0 is
//   not the far plane
fn umbrage_level_rg13(c: vec2f) -> f32 {
    return c.x + c.y * 32.0;  // an exact product: fused or not, it rounds once
}
`,
            "level_rg14": `
// umbrage_level_rg14: two channels of a 14-bit code, as sampled, to the scale of umbrage_receiver_rg14, on which 1.0 is
//   not the far plane
fn umbrage_level_rg14(c: vec2f) -> f32 {
    return c.x + c.y * 64.0;  // an exact product: fused or not, it rounds once
}
`,
            "level_rg15": `
// umbrage_level_rg15: two channels of a 15-bit code, as sampled, to the scale of umbrage_receiver_rg15, on which 1.0 is
//   not the far plane
fn umbrage_level_rg15(c: vec2f) -> f32 {
    return c.x + c.y * 128.0;  // an exact product: fused or not, it rounds once
}
`,
            "level_rg16": `
// umbrage_level_rg16: two channels of a 16-bit code, as sampled, to the scale of umbrage_receiver_rg16, on which 1.0 is
//   not the far plane
fn umbrage_level_rg16(c: vec2f) -> f32 {
    return c.x + c.y * 256.0;  // an exact product: fused or not, it rounds once
}
`,
            "receiver_rg9": `
// umbrage_receiver_rg9: receiver on the scale of umbrage_level_rg9: it is <= a texel's level exactly when
//   depth <= umbrage_decode_rg9(texel, edge), or beyond the far plane
fn umbrage_receiver_rg9(depth: f32, edge: f32) -> f32 {
    let level: f32 = (ceil(depth * 512.0 - edge) - 0.5) * 0.00392156886;
    return select(level, -1.0, depth > 1.0);
}
`,
            "receiver_rg10": `
// umbrage_receiver_rg10: receiver on the scale of umbrage_level_rg10: it is <= a texel's level exactly when
//   depth <= umbrage_decode_rg10(texel, edge), or beyond the far plane
fn umbrage_receiver_rg10(depth: f32, edge: f32) -> f32 {
    let level: f32 = (ceil(depth * 1024.0 - edge) - 0.5) * 0.00392156886;
    return select(level, -1.0, depth > 1.0);
}
`,
            "receiver_rg11": `
// umbrage_receiver_rg11: receiver on the scale of umbrage_level_rg11: it is <= a texel's level exactly when
//   depth <= umbrage_decode_rg11(texel, edge), or beyond the far plane
fn umbrage_receiver_rg11(depth: f32, edge: f32) -> f32 {
    let level: f32 = (ceil(depth * 2048.0 - edge) - 0.5) * 0.00392156886;
    return select(level, -1.0, depth > 1.0);
}
`,
            "receiver_rg12": `
// umbrage_receiver_rg12: receiver on the scale of umbrage_level_rg12: it is <= a texel's level exactly when
//   depth <= umbrage_decode_rg12(texel, edge), or beyond the far plane
fn umbrage_receiver_rg12(depth: f32, edge: f32) -> f32 {
    let level: f32 = (ceil(depth * 4096.0 - edge) - 0.5) * 0.00392156886;
    return select(level, -1.0, depth > 1.0);
}
`,
            "receiver_rg13": `
// umbrage_receiver_rg13: receiver on the scale of umbrage_level_rg13: it is <= a texel's level exactly when
//   depth <= umbrage_decode_rg13(texel, edge), or beyond the far plane
fn umbrage_receiver_rg13(depth: f32, edge: f32) -> f32 {
    let level: f32 = (ceil(depth * 8192.0 - edge) - 0.5) * 0.00392156886;
    return select(level, -1.0, depth > 1.0);
}
`,
            "receiver_rg14": `
// umbrage_receiver_rg14: receiver on the scale of umbrage_level_rg14: it is <= a texel's level exactly when
//   depth <= umbrage_decode_rg14(texel, edge), or beyond the far plane
fn umbrage_receiver_rg14(depth: f32, edge: f32) -> f32 {
    let level: f32 = (ceil(depth * 16384.0 - edge) - 0.5) * 0.00392156886;
    return select(level, -1.0, depth > 1.0);
}
`,
            "receiver_rg15": `
// umbrage_receiver_rg15: receiver on the scale of umbrage_level_rg15: it is <= a texel's level exactly when
//   depth <= umbrage_decode_rg15(texel, edge), or beyond the far plane
fn umbrage_receiver_rg15(depth: f32, edge: f32) -> f32 {
    let level: f32 = (ceil(depth * 32768.0 - edge) - 0.5) * 0.00392156886;
    return select(level, -1.0, depth > 1.0);
}
`,
            "receiver_rg16": `
// umbrage_receiver_rg16: receiver on the scale of umbrage_level_rg16: it is <= a texel's level exactly when
//   depth <= umbrage_decode_rg16(texel, edge), or beyond the far plane
fn umbrage_receiver_rg16(depth: f32, edge: f32) -> f32 {
    let level: f32 = (ceil(depth * 65536.0 - edge) - 0.5) * 0.00392156886;
    return select(level, -1.0, depth > 1.0);
}
`,
            "decode_ps14": `
// umbrage_decode_ps14: the channels of an 11-bit code, as sampled, to x / 2040; compare with umbrage_receiver_ps14;
//   1.0 is not the far plane on this scale
fn umbrage_decode_ps14(c: vec2f) -> f32 {
    return c.x * 0.125 + c.y;  // an exact product: fused or not, it rounds once
}
`,
            "receiver_ps14": `
// umbrage_receiver_ps14: depth * 256 / 255, the scale of umbrage_decode_ps14; beyond the far plane what every texel
//   lights
fn umbrage_receiver_ps14(depth: f32) -> f32 {
    return select(depth * 1.00392163, -1.0, depth > 1.0);
}
`,
            "inside_map": `
// umbrage_inside_map: whether a texel is one of a map's of size texels
fn umbrage_inside_map(size: vec2f, texel: vec2f) -> bool {
    return texel.x >= 0.0 && texel.y >= 0.0 && texel.x < size.x && texel.y < size.y;
}
`,
            "fetch_bordered": `
// umbrage_fetch_bordered: texel of a map, or border outside of it
fn umbrage_fetch_bordered(UMBRAGE_MAP map, size: vec2f, texel: vec2f, border: vec4f) -> vec4f {
    let at: vec2f = clamp(texel, vec2f(0.0, 0.0), size - 1.0);
    let value: vec4f = umbrage_texel(map, size, at);
    return select(border, value, at.x == texel.x && at.y == texel.y);
}
`,
            "fetch_depth": `
// umbrage_fetch_depth: stored depth of a texel, outside the map that of the far plane
fn umbrage_fetch_depth(UMBRAGE_MAP map, size: vec2f, texel: vec2f) -> f32 {
    let inside: vec2f = clamp(texel, vec2f(0.0, 0.0), size - 1.0);
    let value: vec4f = umbrage_texel(map, size, inside);
    let depth: f32 = UMBRAGE_DEPTH;
    return select(UMBRAGE_BORDER, depth, inside.x == texel.x && inside.y == texel.y);
}
`,
            "depth_at": `
// umbrage_depth_at: stored depth of the texel at a point; on a border it may be the texel beside
//   uv  over the map, (0.0, 0.0) to (1.0, 1.0), no NaN
fn umbrage_depth_at(UMBRAGE_MAP map, size: vec2f, uv: vec2f) -> f32 {
    return umbrage_fetch_depth(map, size, floor(uv * size));
}
`,
            "beyond_far_plane": `
// umbrage_beyond_far_plane: whether a receiver is behind the far plane
fn umbrage_beyond_far_plane(receiver: f32) -> bool {
    return receiver > 1.0;
}
`,
            "in_filter_domain": `
// umbrage_in_filter_domain: whether a filter compares; outside texel space and beyond the far plane all is lit
fn umbrage_in_filter_domain(coord: vec2f, receiver: f32) -> bool {
    // a choice, not a && !b: of !(receiver > 1.0) FXC makes receiver <= 1.0, which loses a NaN
    return select(umbrage_inside_texel_space(coord), false, umbrage_beyond_far_plane(receiver));
}
`,
            "compare": `
// umbrage_compare: 1.0 when the receiver is no farther than the stored depth
fn umbrage_compare(receiver: f32, stored: f32) -> f32 {
    return select(0.0, 1.0, receiver <= stored);
}
`,
            "lit": `
// umbrage_lit: visibility of one comparison with a texel
fn umbrage_lit(UMBRAGE_MAP map, size: vec2f, texel: vec2f, receiver: f32) -> f32 {
    return umbrage_compare(receiver, umbrage_fetch_depth(map, size, texel));
}
`,
            "lit_2x2": `
// umbrage_lit_2x2: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1)
fn umbrage_lit_2x2(UMBRAGE_MAP map, size: vec2f, texel: vec2f, receiver: f32) -> vec4f {
    let a: f32 = umbrage_lit(map, size, texel, receiver);
    let b: f32 = umbrage_lit(map, size, texel + vec2f(1.0, 0.0), receiver);
    let c: f32 = umbrage_lit(map, size, texel + vec2f(0.0, 1.0), receiver);
    let d: f32 = umbrage_lit(map, size, texel + vec2f(1.0, 1.0), receiver);
    return vec4f(a, b, c, d);
}
`,
            "map_covers": `
// umbrage_map_covers: whether a receiver of a prefiltered map or a table lies in the map; elsewhere it is lit
fn umbrage_map_covers(size: vec2f, coord: vec2f) -> bool {
    return coord.x >= 0.0 && coord.y >= 0.0 && coord.x < size.x && coord.y < size.y;
}
`,
            "within_far_plane": `
// umbrage_within_far_plane: whether a receiver is a number, and not behind the far plane
fn umbrage_within_far_plane(receiver: f32) -> bool {
    return receiver <= 1.0;
}
`,
            "compare_dx_sdk": `
// umbrage_compare_dx_sdk: 0.0 when stored + epsilon < receiver, else 1.0
fn umbrage_compare_dx_sdk(receiver: f32, stored: f32, epsilon: f32) -> f32 {
    let limit: f32 = stored + epsilon;
    return select(1.0, 0.0, limit < receiver);
}
`,
            "compare_exercise": `
// umbrage_compare_exercise: 1.0 when current < stored + epsilon, else 0.0
fn umbrage_compare_exercise(current: f32, stored: f32, epsilon: f32) -> f32 {
    let limit: f32 = stored + epsilon;
    return select(0.0, 1.0, current < limit);
}
`,
            "window_sum3": `
// umbrage_window_sum3: weighted count of the lit texels under weights that slide over the map, whole
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   steps  of a texel, a power of two up to 256
//   k0 .. k1   weights from the edge to the middle one; the others mirror them. Steps times their sum, a whole number
//              up to 4096, squared is what is wholly lit
fn umbrage_window_sum3(UMBRAGE_MAP map, size: vec2f, coord: vec2f, receiver: f32, steps: f32, k0: f32, k1: f32) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);  // no branch: fetches overlap
    let x: vec2f = select(vec2f(0.0, 0.0), floor(coord * 256.0) - 128.0, compared);
    let texel: vec2f = floor(x * (1.0 / 256.0));
    let s: vec2f = floor((x - texel * 256.0) * (1.0 / 256.0) * steps);
    let r: vec2f = steps - s;
    let whole: f32 = steps * (k0 + k1 + k0);
    let w0: vec2f = floor(r * k0);
    let w2: vec2f = floor(r * k0 + s * k1);
    let w3: vec2f = floor(s * k0);
    let w1: vec2f = max(whole - (w0 + w2 + w3), vec2f(0.0, 0.0));
    let first: vec2f = texel - 1.0;
    var n: f32 = 0.0;
    var a: vec4f = umbrage_lit_2x2(map, size, first + vec2f(0.0, 0.0), receiver);
    var b: vec4f = umbrage_lit_2x2(map, size, first + vec2f(2.0, 0.0), receiver);
    n += w0.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y);
    n += w1.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w);
    a = umbrage_lit_2x2(map, size, first + vec2f(0.0, 2.0), receiver);
    b = umbrage_lit_2x2(map, size, first + vec2f(2.0, 2.0), receiver);
    n += w2.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y);
    n += w3.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w);
    return select(whole * whole, n, compared);
}
`,
            "window_sum5": `
// umbrage_window_sum5: weighted count of the lit texels under weights that slide over the map, whole
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   steps  of a texel, a power of two up to 256
//   k0 .. k2   weights from the edge to the middle one; the others mirror them. Steps times their sum, a whole number
//              up to 4096, squared is what is wholly lit
fn umbrage_window_sum5(UMBRAGE_MAP map, size: vec2f, coord: vec2f, receiver: f32, steps: f32, k0: f32, k1: f32,
                       k2: f32) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);  // no branch: fetches overlap
    let x: vec2f = select(vec2f(0.0, 0.0), floor(coord * 256.0) - 128.0, compared);
    let texel: vec2f = floor(x * (1.0 / 256.0));
    let s: vec2f = floor((x - texel * 256.0) * (1.0 / 256.0) * steps);
    let r: vec2f = steps - s;
    let whole: f32 = steps * (k0 + k1 + k2 + k1 + k0);
    let w0: vec2f = floor(r * k0);
    let w1: vec2f = floor(r * k1 + s * k0);
    let w3: vec2f = floor(r * k1 + s * k2);
    let w4: vec2f = floor(r * k0 + s * k1);
    let w5: vec2f = floor(s * k0);
    let w2: vec2f = max(whole - (w0 + w1 + w3 + w4 + w5), vec2f(0.0, 0.0));
    let first: vec2f = texel - 2.0;
    var n: f32 = 0.0;
    var a: vec4f = umbrage_lit_2x2(map, size, first + vec2f(0.0, 0.0), receiver);
    var b: vec4f = umbrage_lit_2x2(map, size, first + vec2f(2.0, 0.0), receiver);
    var c: vec4f = umbrage_lit_2x2(map, size, first + vec2f(4.0, 0.0), receiver);
    n += w0.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y);
    n += w1.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w);
    a = umbrage_lit_2x2(map, size, first + vec2f(0.0, 2.0), receiver);
    b = umbrage_lit_2x2(map, size, first + vec2f(2.0, 2.0), receiver);
    c = umbrage_lit_2x2(map, size, first + vec2f(4.0, 2.0), receiver);
    n += w2.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y);
    n += w3.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w);
    a = umbrage_lit_2x2(map, size, first + vec2f(0.0, 4.0), receiver);
    b = umbrage_lit_2x2(map, size, first + vec2f(2.0, 4.0), receiver);
    c = umbrage_lit_2x2(map, size, first + vec2f(4.0, 4.0), receiver);
    n += w4.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y);
    n += w5.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w);
    return select(whole * whole, n, compared);
}
`,
            "window_sum7": `
// umbrage_window_sum7: weighted count of the lit texels under weights that slide over the map, whole
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   steps  of a texel, a power of two up to 256
//   k0 .. k3   weights from the edge to the middle one; the others mirror them. Steps times their sum, a whole number
//              up to 4096, squared is what is wholly lit
fn umbrage_window_sum7(UMBRAGE_MAP map, size: vec2f, coord: vec2f, receiver: f32, steps: f32, k0: f32, k1: f32, k2: f32,
                       k3: f32) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);  // no branch: fetches overlap
    let x: vec2f = select(vec2f(0.0, 0.0), floor(coord * 256.0) - 128.0, compared);
    let texel: vec2f = floor(x * (1.0 / 256.0));
    let s: vec2f = floor((x - texel * 256.0) * (1.0 / 256.0) * steps);
    let r: vec2f = steps - s;
    let whole: f32 = steps * (k0 + k1 + k2 + k3 + k2 + k1 + k0);
    let w0: vec2f = floor(r * k0);
    let w1: vec2f = floor(r * k1 + s * k0);
    let w2: vec2f = floor(r * k2 + s * k1);
    let w4: vec2f = floor(r * k2 + s * k3);
    let w5: vec2f = floor(r * k1 + s * k2);
    let w6: vec2f = floor(r * k0 + s * k1);
    let w7: vec2f = floor(s * k0);
    let w3: vec2f = max(whole - (w0 + w1 + w2 + w4 + w5 + w6 + w7), vec2f(0.0, 0.0));
    let first: vec2f = texel - 3.0;
    var n: f32 = 0.0;
    var a: vec4f = umbrage_lit_2x2(map, size, first + vec2f(0.0, 0.0), receiver);
    var b: vec4f = umbrage_lit_2x2(map, size, first + vec2f(2.0, 0.0), receiver);
    var c: vec4f = umbrage_lit_2x2(map, size, first + vec2f(4.0, 0.0), receiver);
    var d: vec4f = umbrage_lit_2x2(map, size, first + vec2f(6.0, 0.0), receiver);
    n += w0.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y + w6.x * d.x + w7.x * d.y);
    n += w1.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w + w6.x * d.z + w7.x * d.w);
    a = umbrage_lit_2x2(map, size, first + vec2f(0.0, 2.0), receiver);
    b = umbrage_lit_2x2(map, size, first + vec2f(2.0, 2.0), receiver);
    c = umbrage_lit_2x2(map, size, first + vec2f(4.0, 2.0), receiver);
    d = umbrage_lit_2x2(map, size, first + vec2f(6.0, 2.0), receiver);
    n += w2.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y + w6.x * d.x + w7.x * d.y);
    n += w3.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w + w6.x * d.z + w7.x * d.w);
    a = umbrage_lit_2x2(map, size, first + vec2f(0.0, 4.0), receiver);
    b = umbrage_lit_2x2(map, size, first + vec2f(2.0, 4.0), receiver);
    c = umbrage_lit_2x2(map, size, first + vec2f(4.0, 4.0), receiver);
    d = umbrage_lit_2x2(map, size, first + vec2f(6.0, 4.0), receiver);
    n += w4.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y + w6.x * d.x + w7.x * d.y);
    n += w5.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w + w6.x * d.z + w7.x * d.w);
    a = umbrage_lit_2x2(map, size, first + vec2f(0.0, 6.0), receiver);
    b = umbrage_lit_2x2(map, size, first + vec2f(2.0, 6.0), receiver);
    c = umbrage_lit_2x2(map, size, first + vec2f(4.0, 6.0), receiver);
    d = umbrage_lit_2x2(map, size, first + vec2f(6.0, 6.0), receiver);
    n += w6.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y + w6.x * d.x + w7.x * d.y);
    n += w7.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w + w6.x * d.z + w7.x * d.w);
    return select(whole * whole, n, compared);
}
`,
            "disc_rotation": `
// umbrage_disc_rotation: (cos, sin) in 1/64 of one of 16 turns for a pixel, such as gl_FragCoord.xy: each once in 4 x 4
fn umbrage_disc_rotation(pixel: vec2f) -> vec2f {
    let whole: vec2f = select(vec2f(0.0, 0.0), floor(pixel), umbrage_inside_texel_space(pixel));
    var v: f32 = whole.x * 4.0 + whole.y;
    v = v - floor(v * (1.0 / 16.0)) * 16.0;
    let quarter: f32 = floor(v * 0.25);
    let base: f32 = v - quarter * 4.0;
    let low: vec2f = select(vec2f(59.0, 24.0), vec2f(64.0, 0.0), base < 0.5);
    let high: vec2f = select(vec2f(24.0, 59.0), vec2f(45.0, 45.0), base < 2.5);
    let first: vec2f = select(high, low, base < 1.5);
    let once: vec2f = select(vec2f(0.0 - first.y, first.x), first, quarter < 0.5);
    let twice: vec2f = select(vec2f(first.y, 0.0 - first.x), vec2f(0.0 - first.x, 0.0 - first.y), quarter < 2.5);
    return select(twice, once, quarter < 1.5);
}
`,
            "disc_tap": `
// umbrage_disc_tap: the texel that a point of a disc falls on
//   position  floor(256 coord) of the receiver;   p  point, in 1/16 of the radius;   rotation  of umbrage_disc_rotation
//   radius    in 1/16 texel, a whole number from 0 to 4095
fn umbrage_disc_tap(position: vec2f, p: vec2f, rotation: vec2f, radius: f32) -> vec2f {
    let at: vec2f = position * (1.0 / 256.0);
    let texel: vec2f = floor(at);
    let within: vec2f = clamp(at - texel, vec2f(0.0, 0.0), vec2f(1.0, 1.0));  // no sum is regrouped across it
    let scaled: vec2f = rotation * (radius * (1.0 / 16384.0));
    let x: f32 = scaled.x * p.x + within.x - scaled.y * p.y;
    let y: f32 = scaled.y * p.x + within.y + scaled.x * p.y;
    return texel + floor(vec2f(x, y));
}
`,
            "disc_radius": `
// umbrage_disc_radius: a disc's radius in 1/16 texel, from one in texels: a whole number from 0 to 4095, of a NaN 0
fn umbrage_disc_radius(radius: f32) -> f32 {
    let inside: f32 = select(0.0, floor(radius * 16.0), radius > 0.0);
    return select(inside, 4095.0, radius >= 255.9375);
}
`,
            "disc8": `
// umbrage_disc8: lit share of 8 points of a disc; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   radius  in texels, at most 255.9375;   rotation  umbrage_disc_rotation of the pixel
fn umbrage_disc8(UMBRAGE_MAP map, size: vec2f, coord: vec2f, receiver: f32, radius: f32, rotation: vec2f) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let at: vec2f = select(vec2f(0.0, 0.0), floor(coord * 256.0), compared);  // no branch: fetches overlap
    let rho: f32 = umbrage_disc_radius(radius);
    var n: f32 = 0.0;
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(3.0, -1.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-4.0, 5.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(1.0, -11.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-9.0, -8.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-12.0, 3.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(11.0, 6.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(0.0, 13.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(11.0, -7.0), rotation, rho), receiver);
    return select(1.0, n * (1.0 / 8.0), compared);
}
`,
            "disc16": `
// umbrage_disc16: lit share of 16 points of a disc; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   radius  in texels, at most 255.9375;   rotation  umbrage_disc_rotation of the pixel
fn umbrage_disc16(UMBRAGE_MAP map, size: vec2f, coord: vec2f, receiver: f32, radius: f32, rotation: vec2f) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let at: vec2f = select(vec2f(0.0, 0.0), floor(coord * 256.0), compared);  // no branch: fetches overlap
    let rho: f32 = umbrage_disc_radius(radius);
    var n: f32 = 0.0;
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(1.0, -3.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(5.0, 2.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-5.0, 2.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(0.0, 7.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-6.0, -5.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(8.0, -5.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(0.0, -11.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(11.0, 5.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-12.0, 4.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-1.0, 13.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(7.0, 11.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-9.0, 10.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-13.0, -4.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(7.0, -12.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-7.0, -12.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(14.0, -2.0), rotation, rho), receiver);
    return select(1.0, n * (1.0 / 16.0), compared);
}
`,
            "disc32": `
// umbrage_disc32: lit share of 32 points of a disc; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   radius  in texels, at most 255.9375;   rotation  umbrage_disc_rotation of the pixel
fn umbrage_disc32(UMBRAGE_MAP map, size: vec2f, coord: vec2f, receiver: f32, radius: f32, rotation: vec2f) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let at: vec2f = select(vec2f(0.0, 0.0), floor(coord * 256.0), compared);  // no branch: fetches overlap
    let rho: f32 = umbrage_disc_radius(radius);
    var n: f32 = 0.0;
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-2.0, -1.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(3.0, 2.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(1.0, -4.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-4.0, 3.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(0.0, 6.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-5.0, -5.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(7.0, -2.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-8.0, -1.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(8.0, 3.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(5.0, 7.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(1.0, -9.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(6.0, -7.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-8.0, 5.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(0.0, 10.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-3.0, -10.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-6.0, 10.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-9.0, -8.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(11.0, -5.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(5.0, -12.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-13.0, -1.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(7.0, 11.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(13.0, 3.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-13.0, 4.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(10.0, -10.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(14.0, -2.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-11.0, 9.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(3.0, 14.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-13.0, -6.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(12.0, 8.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-4.0, 14.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(-7.0, -13.0), rotation, rho), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2f(0.0, -15.0), rotation, rho), receiver);
    return select(1.0, n * (1.0 / 32.0), compared);
}
`,
            "hard": `
// umbrage_hard: unfiltered shadow test; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased
fn umbrage_hard(UMBRAGE_MAP map, size: vec2f, coord: vec2f, receiver: f32) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let texel: vec2f = select(vec2f(0.0, 0.0), floor(coord), compared);  // no branch: fetches of several taps overlap
    let lit: f32 = umbrage_lit(map, size, texel, receiver);
    return select(1.0, lit, compared);
}
`,
            "four_tap": `
// umbrage_four_tap: mean of the shadow test at four taps; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   a, b, c, d  taps in texels, all lit where their mean is 2^15
//   or more in a direction;   receiver  depth, biased
fn umbrage_four_tap(UMBRAGE_MAP map, size: vec2f, a: vec2f, b: vec2f, c: vec2f, d: vec2f, receiver: f32) -> f32 {
    let a_texel: vec2f = floor(a);
    let b_texel: vec2f = floor(b);
    let c_texel: vec2f = floor(c);
    let d_texel: vec2f = floor(d);
    let sum: vec2f = abs(a_texel) + abs(b_texel) + abs(c_texel) + abs(d_texel);
    // two limits on purpose: Mesa makes max(x, y) < limit of one, which loses a NaN
    let compared: bool = select(sum.x < 131072.0 && sum.y * 2.0 < 262144.0, false, umbrage_beyond_far_plane(receiver));
    let count: f32 = umbrage_lit(map, size, a_texel, receiver) + umbrage_lit(map, size, b_texel, receiver) +
        umbrage_lit(map, size, c_texel, receiver) + umbrage_lit(map, size, d_texel, receiver);
    return select(1.0, count * 0.25, compared);
}
`,
            "pcf_2x2": `
// umbrage_pcf_2x2: bilinear percentage-closer filtering; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased
fn umbrage_pcf_2x2(UMBRAGE_MAP map, size: vec2f, coord: vec2f, receiver: f32) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let x: vec2f = select(vec2f(0.0, 0.0), floor(coord * 256.0) - 128.0, compared);  // no branch: fetches overlap
    let texel: vec2f = floor(x * (1.0 / 256.0));
    // weights are in [0, 1) already; compilers cannot regroup sums across the clamp
    let hi: vec2f = clamp(x * (1.0 / 256.0) - texel, vec2f(0.0, 0.0), vec2f(1.0, 1.0));
    let lo: vec2f = 1.0 - hi;
    let lit: vec4f = umbrage_lit_2x2(map, size, texel, receiver);
    let visibility: f32 = lo.y * (lo.x * lit.x + hi.x * lit.y) + hi.y * (lo.x * lit.z + hi.x * lit.w);
    return select(1.0, visibility, compared);
}
`,
            "pcf_2x2_dx_sdk": `
// umbrage_pcf_2x2_dx_sdk: the DirectX SDK sample's 2x2 filter; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, not biased;   epsilon  in depth, added to the stored side
fn umbrage_pcf_2x2_dx_sdk(UMBRAGE_MAP map, size: vec2f, coord: vec2f, receiver: f32, epsilon: f32) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let x: vec2f = select(vec2f(0.0, 0.0), coord - 0.5, compared);  // no branch: fetches overlap
    let texel: vec2f = floor(x);
    let weight: vec2f = x - texel;
    let a: f32 = umbrage_compare_dx_sdk(receiver, umbrage_fetch_depth(map, size, texel), epsilon);
    let right: f32 = umbrage_fetch_depth(map, size, texel + vec2f(1.0, 0.0));
    let above: f32 = umbrage_fetch_depth(map, size, texel + vec2f(0.0, 1.0));
    let beyond: f32 = umbrage_fetch_depth(map, size, texel + vec2f(1.0, 1.0));
    let b: f32 = umbrage_compare_dx_sdk(receiver, right, epsilon);
    let c: f32 = umbrage_compare_dx_sdk(receiver, above, epsilon);
    let d: f32 = umbrage_compare_dx_sdk(receiver, beyond, epsilon);
    let low: f32 = a + weight.x * (b - a);
    let high: f32 = c + weight.x * (d - c);
    let visibility: f32 = low + weight.y * (high - low);
    return select(1.0, visibility, compared);
}
`,
            "box_count": `
// umbrage_box_count: lit texels in the (2r+1) x (2r+1) box around the receiver's own, a whole number
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   radius  r, clamped to 0..8, best a constant
fn umbrage_box_count(UMBRAGE_MAP map, size: vec2f, coord: vec2f, receiver: f32, radius: i32) -> f32 {
    let r: i32 = select(select(8, radius, radius < 8), 0, radius < 0);
    let width: i32 = 2 * r + 1;
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let first: vec2f = select(vec2f(0.0, 0.0), floor(coord) - f32(r), compared);
    var count: f32 = 0.0;
    for (var j: i32 = 0; j < 17; j++) {
        if (j >= width) { break; }
        for (var i: i32 = 0; i < 17; i++) {
            if (i >= width) { break; }
            count += umbrage_lit(map, size, first + vec2f(f32(i), f32(j)), receiver);
        }
    }
    return select(f32(width * width), count, compared);
}
`,
            "box_scale": `
// umbrage_box_scale: 1 / (2r+1)^2, rounded to nearest
fn umbrage_box_scale(radius: i32) -> f32 {
    var scale: f32 = 0.00346020772;  // not returned as a literal: that would have the host's precision
    if (radius < 8) { scale = 0.00444444455; }
    if (radius < 7) { scale = 0.00591715984; }
    if (radius < 6) { scale = 0.00826446246; }
    if (radius < 5) { scale = 0.0123456791; }
    if (radius < 4) { scale = 0.0204081628; }
    if (radius < 3) { scale = 0.0399999991; }
    if (radius < 2) { scale = 0.111111112; }
    if (radius < 1) { scale = 1.0; }
    return scale;
}
`,
            "box": `
// umbrage_box: lit share of a (2r+1) x (2r+1) box; visibility, 1.0 is lit; arguments as for umbrage_box_count
fn umbrage_box(UMBRAGE_MAP map, size: vec2f, coord: vec2f, receiver: f32, radius: i32) -> f32 {
    let visibility: f32 = umbrage_box_count(map, size, coord, receiver, radius) * umbrage_box_scale(radius);
    return select(1.0, visibility, visibility < 0.999);  // 121 times the rounded 1/121 is not 1
}
`,
            "tent2": `
// umbrage_tent2: lit share of 3 x 3 texels, the window 1 1; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased
fn umbrage_tent2(UMBRAGE_MAP map, size: vec2f, coord: vec2f, receiver: f32) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let x: vec2f = select(vec2f(0.0, 0.0), floor(coord * 256.0), compared);  // no branch: fetches overlap
    let texel: vec2f = floor(x * (1.0 / 256.0));
    // s is in [0, 256) already, w1 not negative; compilers cannot regroup sums across clamp and max
    let s: vec2f = clamp(x * (1.0 / 256.0) - texel, vec2f(0.0, 0.0), vec2f(1.0, 1.0)) * 256.0;
    let r: vec2f = 256.0 - s;
    let w0: vec2f = r * 8.0;
    let w2: vec2f = s * 8.0;
    let w1: vec2f = max(4096.0 - w0 - w2, vec2f(0.0, 0.0));
    let a: vec4f = umbrage_lit_2x2(map, size, texel - 1.0, receiver);
    let b: vec4f = umbrage_lit_2x2(map, size, texel + vec2f(1.0, -1.0), receiver);
    let c: vec4f = umbrage_lit_2x2(map, size, texel + vec2f(-1.0, 1.0), receiver);
    let d: vec4f = umbrage_lit_2x2(map, size, texel + vec2f(1.0, 1.0), receiver);
    var n: f32 = w0.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x);
    n += w1.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z);
    n += w2.y * (w0.x * c.x + w1.x * c.y + w2.x * d.x);
    return select(1.0, n * (1.0 / 16777216.0), compared);
}
`,
            "tent3": `
// umbrage_tent3: lit share under 3 x 3 weights, 1 2 1, that slide over the map; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased
fn umbrage_tent3(UMBRAGE_MAP map, size: vec2f, coord: vec2f, receiver: f32) -> f32 {
    let n: f32 = umbrage_window_sum3(map, size, coord, receiver, 256.0, 4.0, 8.0);
    return clamp(n * (1.0 / 16777216.0), 0.0, 1.0);
}
`,
            "quadratic_b_spline": `
// umbrage_quadratic_b_spline: lit share of 3 x 3 texels, weighed by the quadratic B-spline; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased
fn umbrage_quadratic_b_spline(UMBRAGE_MAP map, size: vec2f, coord: vec2f, receiver: f32) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let x: vec2f = select(vec2f(0.0, 0.0), floor(coord * 256.0), compared);  // no branch: fetches overlap
    let texel: vec2f = floor(x * (1.0 / 256.0));
    // s is in [0, 256) already, w1 not negative; compilers cannot regroup sums across clamp and max
    let s: vec2f = clamp(x * (1.0 / 256.0) - texel, vec2f(0.0, 0.0), vec2f(1.0, 1.0)) * 256.0;
    let r: vec2f = 256.0 - s;
    let w0: vec2f = floor(r * r * (1.0 / 32.0));
    let w2: vec2f = floor(s * s * (1.0 / 32.0));
    let w1: vec2f = max(4096.0 - w0 - w2, vec2f(0.0, 0.0));
    let a: vec4f = umbrage_lit_2x2(map, size, texel - 1.0, receiver);
    let b: vec4f = umbrage_lit_2x2(map, size, texel + vec2f(1.0, -1.0), receiver);
    let c: vec4f = umbrage_lit_2x2(map, size, texel + vec2f(-1.0, 1.0), receiver);
    let d: vec4f = umbrage_lit_2x2(map, size, texel + vec2f(1.0, 1.0), receiver);
    var n: f32 = w0.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x);
    n += w1.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z);
    n += w2.y * (w0.x * c.x + w1.x * c.y + w2.x * d.x);
    return select(1.0, n * (1.0 / 16777216.0), compared);
}
`,
            "binomial5": `
// umbrage_binomial5: lit share under 5 x 5 weights, 1 4 6 4 1, that slide over the map; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased
fn umbrage_binomial5(UMBRAGE_MAP map, size: vec2f, coord: vec2f, receiver: f32) -> f32 {
    let n: f32 = umbrage_window_sum5(map, size, coord, receiver, 256.0, 1.0, 4.0, 6.0);
    return clamp(n * (1.0 / 16777216.0), 0.0, 1.0);
}
`,
            "castano_dyadic5": `
// umbrage_castano_dyadic5: lit share under 5 x 5 weights, 5 16 22 16 5, that slide over the map; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased
fn umbrage_castano_dyadic5(UMBRAGE_MAP map, size: vec2f, coord: vec2f, receiver: f32) -> f32 {
    let n: f32 = umbrage_window_sum5(map, size, coord, receiver, 256.0, 1.25, 4.0, 5.5);
    return clamp(n * (1.0 / 16777216.0), 0.0, 1.0);
}
`,
            "castano5": `
// umbrage_castano5: lit share under 5 x 5 weights, 1 3 4 3 1, that slide over the map; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased
fn umbrage_castano5(UMBRAGE_MAP map, size: vec2f, coord: vec2f, receiver: f32) -> f32 {
    let n: f32 = umbrage_window_sum5(map, size, coord, receiver, 256.0, 1.0, 3.0, 4.0);
    return select(1.0, n * (1.0 / 65536.0) * 0.00694444450, n < 9437184.0);
}
`,
            "binomial7": `
// umbrage_binomial7: lit share under 7 x 7 weights, 1 6 15 20 15 6 1, that slide over the map; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased
fn umbrage_binomial7(UMBRAGE_MAP map, size: vec2f, coord: vec2f, receiver: f32) -> f32 {
    let n: f32 = umbrage_window_sum7(map, size, coord, receiver, 256.0, 0.25, 1.5, 3.75, 5.0);
    return clamp(n * (1.0 / 16777216.0), 0.0, 1.0);
}
`,
            "tent7": `
// umbrage_tent7: lit share under 7 x 7 weights, 1 2 3 4 3 2 1, that slide over the map; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased
fn umbrage_tent7(UMBRAGE_MAP map, size: vec2f, coord: vec2f, receiver: f32) -> f32 {
    let n: f32 = umbrage_window_sum7(map, size, coord, receiver, 256.0, 1.0, 2.0, 3.0, 4.0);
    return clamp(n * (1.0 / 16777216.0), 0.0, 1.0);
}
`,
            "castano7": `
// umbrage_castano7: lit share under 7 x 7 weights, 1 5 12 16 12 5 1, that slide over the map; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased
fn umbrage_castano7(UMBRAGE_MAP map, size: vec2f, coord: vec2f, receiver: f32) -> f32 {
    let n: f32 = umbrage_window_sum7(map, size, coord, receiver, 64.0, 1.0, 5.0, 12.0, 16.0);
    return select(1.0, n * (1.0 / 4096.0) * 0.000369822490, n < 11075584.0);
}
`,
            "cube_lit": `
// umbrage_cube_lit: (visibility of one comparison, 1.0) with a texel of a cube, (0.0, 0.0) beyond a corner
//   map, size  atlas of 3 x 2 faces and its size in texels;   texel  (s, t, face), whole numbers
fn umbrage_cube_lit(UMBRAGE_MAP map, size: vec2f, texel: vec3f, receiver: f32) -> vec2f {
    let side: f32 = size.y * 0.5;
    let n: vec3f = umbrage_cube_neighbor(texel, side);
    let at: vec2f = umbrage_cube_tile(n.z, side) + vec2f(n.x, n.y);
    let lit: f32 = umbrage_lit(map, size, at, receiver);
    return select(vec2f(lit, 1.0), vec2f(0.0, 0.0), n.z < 0.0);
}
`,
            "pcf_2x2_cube": `
// umbrage_pcf_2x2_cube: bilinear percentage-closer filtering over a cube's edges; visibility, 1.0 is lit
//   map, size  atlas of 3 x 2 faces and its size in texels;   at  (s, t, face): texels of the face, from 0.0 on
//   receiver   distance from the light, biased
fn umbrage_pcf_2x2_cube(UMBRAGE_MAP map, size: vec2f, at: vec3f, receiver: f32) -> f32 {
    let coord: vec2f = vec2f(at.x, at.y);
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let x: vec2f = select(vec2f(0.0, 0.0), floor(coord * 256.0 + 0.5) - 128.0, compared);
    let texel: vec2f = floor(x * (1.0 / 256.0));
    // weights are in [0, 1) already; compilers cannot regroup sums across the clamp
    let hi: vec2f = clamp(x * (1.0 / 256.0) - texel, vec2f(0.0, 0.0), vec2f(1.0, 1.0));
    let lo: vec2f = 1.0 - hi;
    var sum: vec2f = umbrage_cube_lit(map, size, vec3f(texel, at.z), receiver) * (lo.x * lo.y);
    sum += umbrage_cube_lit(map, size, vec3f(texel + vec2f(1.0, 0.0), at.z), receiver) * (hi.x * lo.y);
    sum += umbrage_cube_lit(map, size, vec3f(texel + vec2f(0.0, 1.0), at.z), receiver) * (lo.x * hi.y);
    sum += umbrage_cube_lit(map, size, vec3f(texel + vec2f(1.0, 1.0), at.z), receiver) * (hi.x * hi.y);
    return select(1.0, sum.x / sum.y, compared && sum.y > 0.0);
}
`,
            "four_tap_hardware": `
// umbrage_four_tap_hardware: mean of the shadow test at four taps of the sampler's; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   a, b, c, d  taps, (0.0, 0.0) to (1.0, 1.0) over the map, all lit
//   where the mean of |x| + |y| is 2^15 texels or more;   receiver  depth, biased
fn umbrage_four_tap_hardware(UMBRAGE_MAP map, size: vec2f, a: vec2f, b: vec2f, c: vec2f, d: vec2f,
                             receiver: f32) -> f32 {
    let sum: vec2f = (abs(a) + abs(b) + abs(c) + abs(d)) * size;
    let compared: bool = select((sum.x + sum.y < 131072.0), false, umbrage_beyond_far_plane(receiver));
    let count: f32 = umbrage_compare(receiver, umbrage_depth_at(map, size, a)) +
        umbrage_compare(receiver, umbrage_depth_at(map, size, b)) +
        umbrage_compare(receiver, umbrage_depth_at(map, size, c)) +
        umbrage_compare(receiver, umbrage_depth_at(map, size, d));
    return select(1.0, count * 0.25, compared);
}
`,
            "lit_filtered": `
// umbrage_lit_filtered: 2x2 comparisons around a point; this map has no sampler to weigh them; visibility, 1.0 is lit
//   coord  in texels, no NaN; what is outside texel space counts as its border
fn umbrage_lit_filtered(UMBRAGE_MAP map, size: vec2f, coord: vec2f, receiver: f32) -> f32 {
    return umbrage_pcf_2x2(map, size, clamp(coord, vec2f(-32767.0, -32767.0), vec2f(32767.0, 32767.0)), receiver);
}
`,
            "lit_at": `
// umbrage_lit_at: 2x2 comparisons around a point, weighted; visibility, 1.0 is lit
//   uv  over the map, (0.0, 0.0) to (1.0, 1.0), no NaN
fn umbrage_lit_at(UMBRAGE_MAP map, size: vec2f, uv: vec2f, receiver: f32) -> f32 {
    return umbrage_lit_filtered(map, size, uv * size, receiver);
}
`,
            "pcf_2x2_hardware": `
// umbrage_pcf_2x2_hardware: 2x2 comparisons, weighted by the sampler; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased
fn umbrage_pcf_2x2_hardware(UMBRAGE_MAP map, size: vec2f, coord: vec2f, receiver: f32) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let at: vec2f = select(vec2f(0.0, 0.0), coord, compared);
    let lit: f32 = umbrage_lit_at(map, size, at / size, receiver);
    let visibility: f32 = select(0.0, lit, umbrage_within_far_plane(receiver));
    return select(1.0, visibility, compared);
}
`,
            "window_hardware3": `
// umbrage_window_hardware3: lit share under weights that slide over the map, by the sampler; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   k0 .. k1  weights from the edge to the middle one; the others mirror them
fn umbrage_window_hardware3(UMBRAGE_MAP map, size: vec2f, coord: vec2f, receiver: f32, k0: f32, k1: f32) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let x: vec2f = select(vec2f(0.0, 0.0), coord - 0.5, compared);
    let texel: vec2f = floor(x);
    let s: vec2f = x - texel;
    let whole: f32 = k0 + k1 + k0;
    let b0: vec2f = k1 + s * (k0 - k1);
    let w0: vec2f = k0 + k1 - s * k1;
    let p0: vec2f = (texel - 0.5 + b0 / w0) / size;
    let b1: vec2f = s * k0;
    let w1: vec2f = k0 + s * k1;
    let p1: vec2f = (texel + 1.5 + b1 / w1) / size;
    var n: f32 = 0.0;
    var row: f32 = 0.0;
    row += w0.x * umbrage_lit_at(map, size, vec2f(p0.x, p0.y), receiver);
    row += w1.x * umbrage_lit_at(map, size, vec2f(p1.x, p0.y), receiver);
    n += w0.y * row;
    row = 0.0;
    row += w0.x * umbrage_lit_at(map, size, vec2f(p0.x, p1.y), receiver);
    row += w1.x * umbrage_lit_at(map, size, vec2f(p1.x, p1.y), receiver);
    n += w1.y * row;
    let share: f32 = clamp(n / (whole * whole), 0.0, 1.0);
    let visibility: f32 = select(0.0, share, umbrage_within_far_plane(receiver));
    return select(1.0, visibility, compared);
}
`,
            "window_hardware5": `
// umbrage_window_hardware5: lit share under weights that slide over the map, by the sampler; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   k0 .. k2  weights from the edge to the middle one; the others mirror them
fn umbrage_window_hardware5(UMBRAGE_MAP map, size: vec2f, coord: vec2f, receiver: f32, k0: f32, k1: f32,
                            k2: f32) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let x: vec2f = select(vec2f(0.0, 0.0), coord - 0.5, compared);
    let texel: vec2f = floor(x);
    let s: vec2f = x - texel;
    let whole: f32 = k0 + k1 + k2 + k1 + k0;
    let b0: vec2f = k1 + s * (k0 - k1);
    let w0: vec2f = k0 + k1 - s * k1;
    let p0: vec2f = (texel - 1.5 + b0 / w0) / size;
    let b1: vec2f = k1 + s * (k2 - k1);
    let w1: vec2f = vec2f(k2 + k1, k2 + k1);
    let p1: vec2f = (texel + 0.5 + b1 / w1) / size;
    let b2: vec2f = s * k0;
    let w2: vec2f = k0 + s * k1;
    let p2: vec2f = (texel + 2.5 + b2 / w2) / size;
    var n: f32 = 0.0;
    var row: f32 = 0.0;
    row += w0.x * umbrage_lit_at(map, size, vec2f(p0.x, p0.y), receiver);
    row += w1.x * umbrage_lit_at(map, size, vec2f(p1.x, p0.y), receiver);
    row += w2.x * umbrage_lit_at(map, size, vec2f(p2.x, p0.y), receiver);
    n += w0.y * row;
    row = 0.0;
    row += w0.x * umbrage_lit_at(map, size, vec2f(p0.x, p1.y), receiver);
    row += w1.x * umbrage_lit_at(map, size, vec2f(p1.x, p1.y), receiver);
    row += w2.x * umbrage_lit_at(map, size, vec2f(p2.x, p1.y), receiver);
    n += w1.y * row;
    row = 0.0;
    row += w0.x * umbrage_lit_at(map, size, vec2f(p0.x, p2.y), receiver);
    row += w1.x * umbrage_lit_at(map, size, vec2f(p1.x, p2.y), receiver);
    row += w2.x * umbrage_lit_at(map, size, vec2f(p2.x, p2.y), receiver);
    n += w2.y * row;
    let share: f32 = clamp(n / (whole * whole), 0.0, 1.0);
    let visibility: f32 = select(0.0, share, umbrage_within_far_plane(receiver));
    return select(1.0, visibility, compared);
}
`,
            "window_hardware7": `
// umbrage_window_hardware7: lit share under weights that slide over the map, by the sampler; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   k0 .. k3  weights from the edge to the middle one; the others mirror them
fn umbrage_window_hardware7(UMBRAGE_MAP map, size: vec2f, coord: vec2f, receiver: f32, k0: f32, k1: f32, k2: f32,
                            k3: f32) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let x: vec2f = select(vec2f(0.0, 0.0), coord - 0.5, compared);
    let texel: vec2f = floor(x);
    let s: vec2f = x - texel;
    let whole: f32 = k0 + k1 + k2 + k3 + k2 + k1 + k0;
    let b0: vec2f = k1 + s * (k0 - k1);
    let w0: vec2f = k0 + k1 - s * k1;
    let p0: vec2f = (texel - 2.5 + b0 / w0) / size;
    let b1: vec2f = k3 + s * (k2 - k3);
    let w1: vec2f = k2 + k3 + s * (k1 - k3);
    let p1: vec2f = (texel - 0.5 + b1 / w1) / size;
    let b2: vec2f = k1 + s * (k2 - k1);
    let w2: vec2f = k2 + k1 + s * (k3 - k1);
    let p2: vec2f = (texel + 1.5 + b2 / w2) / size;
    let b3: vec2f = s * k0;
    let w3: vec2f = k0 + s * k1;
    let p3: vec2f = (texel + 3.5 + b3 / w3) / size;
    var n: f32 = 0.0;
    var row: f32 = 0.0;
    row += w0.x * umbrage_lit_at(map, size, vec2f(p0.x, p0.y), receiver);
    row += w1.x * umbrage_lit_at(map, size, vec2f(p1.x, p0.y), receiver);
    row += w2.x * umbrage_lit_at(map, size, vec2f(p2.x, p0.y), receiver);
    row += w3.x * umbrage_lit_at(map, size, vec2f(p3.x, p0.y), receiver);
    n += w0.y * row;
    row = 0.0;
    row += w0.x * umbrage_lit_at(map, size, vec2f(p0.x, p1.y), receiver);
    row += w1.x * umbrage_lit_at(map, size, vec2f(p1.x, p1.y), receiver);
    row += w2.x * umbrage_lit_at(map, size, vec2f(p2.x, p1.y), receiver);
    row += w3.x * umbrage_lit_at(map, size, vec2f(p3.x, p1.y), receiver);
    n += w1.y * row;
    row = 0.0;
    row += w0.x * umbrage_lit_at(map, size, vec2f(p0.x, p2.y), receiver);
    row += w1.x * umbrage_lit_at(map, size, vec2f(p1.x, p2.y), receiver);
    row += w2.x * umbrage_lit_at(map, size, vec2f(p2.x, p2.y), receiver);
    row += w3.x * umbrage_lit_at(map, size, vec2f(p3.x, p2.y), receiver);
    n += w2.y * row;
    row = 0.0;
    row += w0.x * umbrage_lit_at(map, size, vec2f(p0.x, p3.y), receiver);
    row += w1.x * umbrage_lit_at(map, size, vec2f(p1.x, p3.y), receiver);
    row += w2.x * umbrage_lit_at(map, size, vec2f(p2.x, p3.y), receiver);
    row += w3.x * umbrage_lit_at(map, size, vec2f(p3.x, p3.y), receiver);
    n += w3.y * row;
    let share: f32 = clamp(n / (whole * whole), 0.0, 1.0);
    let visibility: f32 = select(0.0, share, umbrage_within_far_plane(receiver));
    return select(1.0, visibility, compared);
}
`,
            "disc_hardware8": `
// umbrage_disc_hardware8: 8 points of a disc, each compared and weighted by the sampler; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   radius  in texels, at most 255.9375;   rotation  umbrage_disc_rotation of the pixel
fn umbrage_disc_hardware8(UMBRAGE_MAP map, size: vec2f, coord: vec2f, receiver: f32, radius: f32,
                          rotation: vec2f) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let center: vec2f = select(vec2f(0.0, 0.0), coord, compared) / size;
    let scaled: vec2f = rotation * (select(0.0, min(radius, 255.9375), radius > 0.0) * (1.0 / 1024.0));
    let x: vec2f = scaled / size;
    let y: vec2f = vec2f(0.0 - scaled.y, scaled.x) / size;
    var n: f32 = 0.0;
    n += umbrage_lit_at(map, size, center + x * 3.0 - y * 1.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 4.0 + y * 5.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 1.0 - y * 11.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 9.0 - y * 8.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 12.0 + y * 3.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 11.0 + y * 6.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 0.0 + y * 13.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 11.0 - y * 7.0, receiver);
    let visibility: f32 = select(0.0, n * (1.0 / 8.0), umbrage_within_far_plane(receiver));
    return select(1.0, visibility, compared);
}
`,
            "disc_hardware16": `
// umbrage_disc_hardware16: 16 points of a disc, each compared and weighted by the sampler; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   radius  in texels, at most 255.9375;   rotation  umbrage_disc_rotation of the pixel
fn umbrage_disc_hardware16(UMBRAGE_MAP map, size: vec2f, coord: vec2f, receiver: f32, radius: f32,
                           rotation: vec2f) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let center: vec2f = select(vec2f(0.0, 0.0), coord, compared) / size;
    let scaled: vec2f = rotation * (select(0.0, min(radius, 255.9375), radius > 0.0) * (1.0 / 1024.0));
    let x: vec2f = scaled / size;
    let y: vec2f = vec2f(0.0 - scaled.y, scaled.x) / size;
    var n: f32 = 0.0;
    n += umbrage_lit_at(map, size, center + x * 1.0 - y * 3.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 5.0 + y * 2.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 5.0 + y * 2.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 0.0 + y * 7.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 6.0 - y * 5.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 8.0 - y * 5.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 0.0 - y * 11.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 11.0 + y * 5.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 12.0 + y * 4.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 1.0 + y * 13.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 7.0 + y * 11.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 9.0 + y * 10.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 13.0 - y * 4.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 7.0 - y * 12.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 7.0 - y * 12.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 14.0 - y * 2.0, receiver);
    let visibility: f32 = select(0.0, n * (1.0 / 16.0), umbrage_within_far_plane(receiver));
    return select(1.0, visibility, compared);
}
`,
            "disc_hardware32": `
// umbrage_disc_hardware32: 32 points of a disc, each compared and weighted by the sampler; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   radius  in texels, at most 255.9375;   rotation  umbrage_disc_rotation of the pixel
fn umbrage_disc_hardware32(UMBRAGE_MAP map, size: vec2f, coord: vec2f, receiver: f32, radius: f32,
                           rotation: vec2f) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let center: vec2f = select(vec2f(0.0, 0.0), coord, compared) / size;
    let scaled: vec2f = rotation * (select(0.0, min(radius, 255.9375), radius > 0.0) * (1.0 / 1024.0));
    let x: vec2f = scaled / size;
    let y: vec2f = vec2f(0.0 - scaled.y, scaled.x) / size;
    var n: f32 = 0.0;
    n += umbrage_lit_at(map, size, center - x * 2.0 - y * 1.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 3.0 + y * 2.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 1.0 - y * 4.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 4.0 + y * 3.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 0.0 + y * 6.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 5.0 - y * 5.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 7.0 - y * 2.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 8.0 - y * 1.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 8.0 + y * 3.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 5.0 + y * 7.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 1.0 - y * 9.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 6.0 - y * 7.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 8.0 + y * 5.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 0.0 + y * 10.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 3.0 - y * 10.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 6.0 + y * 10.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 9.0 - y * 8.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 11.0 - y * 5.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 5.0 - y * 12.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 13.0 - y * 1.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 7.0 + y * 11.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 13.0 + y * 3.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 13.0 + y * 4.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 10.0 - y * 10.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 14.0 - y * 2.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 11.0 + y * 9.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 3.0 + y * 14.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 13.0 - y * 6.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 12.0 + y * 8.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 4.0 + y * 14.0, receiver);
    n += umbrage_lit_at(map, size, center - x * 7.0 - y * 13.0, receiver);
    n += umbrage_lit_at(map, size, center + x * 0.0 - y * 15.0, receiver);
    let visibility: f32 = select(0.0, n * (1.0 / 32.0), umbrage_within_far_plane(receiver));
    return select(1.0, visibility, compared);
}
`,
            "bounds_lit": `
// umbrage_bounds_lit: 1.0 where all texels of a filter are lit, 0.0 where none is, else -1.0: ask the filter
//   bounds, size  a map of the texels' least and greatest depths, and its size in texels;   place  what goes with it
//   coord, receiver  as the filter takes them
fn umbrage_bounds_lit(UMBRAGE_MAP bounds, size: vec2f, coord: vec2f, receiver: f32, place: vec2f) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let x: vec2f = select(vec2f(0.0, 0.0), floor(coord * 256.0), compared);
    let b: vec4f = umbrage_fetch_clamped(bounds, size, floor((x + place.x) * place.y));
    let all: f32 = umbrage_compare(receiver, b.x);
    let some: f32 = umbrage_compare(receiver, b.y);
    let known: f32 = select(-1.0, all, b.x <= b.y && all == some);  // not of a NaN
    return select(1.0, known, compared);
}
`,
            "distance_code": `
// umbrage_distance_code: a depth as whole number from 0.0 at the near plane to 65535.0, also where depth is reversed
fn umbrage_distance_code(depth: f32) -> f32 {
    let v: f32 = depth * 65536.0;
    let forward: f32 = select(65535.0, floor(max(v, 0.0)), v < 65535.0);
    let reversed: f32 = select(0.0, floor(min(v, 65535.0)), v > 0.0);
    return select(65535.0 - reversed, forward, umbrage_cleared_depth() > 0.5);
}
`,
            "penumbra": `
// umbrage_penumbra: radius in 1/16 texel, a whole number
//   apart     umbrage_distance_code of the receiver less that of the blocker
//   softness  (1/16 texel a code, min_radius, max_radius), of make_penumbra_params
fn umbrage_penumbra(apart: f32, softness: vec3f) -> f32 {
    return min(max(floor(apart * softness.x), softness.y), softness.z);
}
`,
            "blocker": `
// umbrage_blocker: (1.0, umbrage_distance_code) of a texel before the receiver, of any other (0.0, 0.0)
fn umbrage_blocker(UMBRAGE_MAP map, size: vec2f, texel: vec2f, receiver: f32) -> vec2f {
    let stored: f32 = umbrage_fetch_depth(map, size, texel);
    let code: f32 = umbrage_distance_code(stored);
    return select(vec2f(1.0, code), vec2f(0.0, 0.0), umbrage_compare(receiver, stored) > 0.5);
}
`,
            "blockers8": `
// umbrage_blockers8: how many of a disc's 8 points fall on texels before the receiver, and the sum of their codes
//   map, size  shadow map and its size in texels;   position  floor(256 coord) of the receiver;   receiver  biased
//   radius     in 1/16 texel, a whole number from 0 to 4095;   rotation  umbrage_disc_rotation of the pixel
fn umbrage_blockers8(UMBRAGE_MAP map, size: vec2f, position: vec2f, receiver: f32, radius: f32,
                     rotation: vec2f) -> vec2f {
    var n: vec2f = vec2f(0.0, 0.0);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(3.0, -1.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-4.0, 5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(1.0, -11.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-9.0, -8.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-12.0, 3.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(11.0, 6.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(0.0, 13.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(11.0, -7.0), rotation, radius), receiver);
    return n;
}
`,
            "blockers16": `
// umbrage_blockers16: how many of a disc's 16 points fall on texels before the receiver, and the sum of their codes
//   map, size  shadow map and its size in texels;   position  floor(256 coord) of the receiver;   receiver  biased
//   radius     in 1/16 texel, a whole number from 0 to 4095;   rotation  umbrage_disc_rotation of the pixel
fn umbrage_blockers16(UMBRAGE_MAP map, size: vec2f, position: vec2f, receiver: f32, radius: f32,
                      rotation: vec2f) -> vec2f {
    var n: vec2f = vec2f(0.0, 0.0);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(1.0, -3.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(5.0, 2.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-5.0, 2.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(0.0, 7.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-6.0, -5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(8.0, -5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(0.0, -11.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(11.0, 5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-12.0, 4.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-1.0, 13.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(7.0, 11.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-9.0, 10.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-13.0, -4.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(7.0, -12.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-7.0, -12.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(14.0, -2.0), rotation, radius), receiver);
    return n;
}
`,
            "blockers32": `
// umbrage_blockers32: how many of a disc's 32 points fall on texels before the receiver, and the sum of their codes
//   map, size  shadow map and its size in texels;   position  floor(256 coord) of the receiver;   receiver  biased
//   radius     in 1/16 texel, a whole number from 0 to 4095;   rotation  umbrage_disc_rotation of the pixel
fn umbrage_blockers32(UMBRAGE_MAP map, size: vec2f, position: vec2f, receiver: f32, radius: f32,
                      rotation: vec2f) -> vec2f {
    var n: vec2f = vec2f(0.0, 0.0);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-2.0, -1.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(3.0, 2.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(1.0, -4.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-4.0, 3.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(0.0, 6.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-5.0, -5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(7.0, -2.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-8.0, -1.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(8.0, 3.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(5.0, 7.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(1.0, -9.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(6.0, -7.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-8.0, 5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(0.0, 10.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-3.0, -10.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-6.0, 10.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-9.0, -8.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(11.0, -5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(5.0, -12.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-13.0, -1.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(7.0, 11.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(13.0, 3.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-13.0, 4.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(10.0, -10.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(14.0, -2.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-11.0, 9.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(3.0, 14.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-13.0, -6.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(12.0, 8.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-4.0, 14.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(-7.0, -13.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2f(0.0, -15.0), rotation, radius), receiver);
    return n;
}
`,
            "pcss8": `
// umbrage_pcss8: percentage-closer soft shadows, 8 points twice; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   softness  of make_penumbra_params;  rotation  umbrage_disc_rotation of the pixel
fn umbrage_pcss8(UMBRAGE_MAP map, size: vec2f, coord: vec2f, receiver: f32, softness: vec3f, rotation: vec2f) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let at: vec2f = select(vec2f(0.0, 0.0), floor(coord * 256.0), compared);
    let z: f32 = umbrage_distance_code(receiver);
    let search_radius: f32 = umbrage_penumbra(z, softness);
    let found: vec2f = umbrage_blockers8(map, size, at, receiver, search_radius, rotation);
    let mean: f32 = umbrage_floor_divide(found.y, max(found.x, 1.0));
    let radius: f32 = umbrage_penumbra(z - mean, softness);
    // without a blocker the radius is the search's, whose points are all lit
    return umbrage_disc8(map, size, coord, receiver, radius * (1.0 / 16.0), rotation);
}
`,
            "pcss16": `
// umbrage_pcss16: percentage-closer soft shadows, 16 points twice; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   softness  of make_penumbra_params;  rotation  umbrage_disc_rotation of the pixel
fn umbrage_pcss16(UMBRAGE_MAP map, size: vec2f, coord: vec2f, receiver: f32, softness: vec3f, rotation: vec2f) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let at: vec2f = select(vec2f(0.0, 0.0), floor(coord * 256.0), compared);
    let z: f32 = umbrage_distance_code(receiver);
    let search_radius: f32 = umbrage_penumbra(z, softness);
    let found: vec2f = umbrage_blockers16(map, size, at, receiver, search_radius, rotation);
    let mean: f32 = umbrage_floor_divide(found.y, max(found.x, 1.0));
    let radius: f32 = umbrage_penumbra(z - mean, softness);
    // without a blocker the radius is the search's, whose points are all lit
    return umbrage_disc16(map, size, coord, receiver, radius * (1.0 / 16.0), rotation);
}
`,
            "pcss32": `
// umbrage_pcss32: percentage-closer soft shadows, 32 points twice; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   softness  of make_penumbra_params;  rotation  umbrage_disc_rotation of the pixel
fn umbrage_pcss32(UMBRAGE_MAP map, size: vec2f, coord: vec2f, receiver: f32, softness: vec3f, rotation: vec2f) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let at: vec2f = select(vec2f(0.0, 0.0), floor(coord * 256.0), compared);
    let z: f32 = umbrage_distance_code(receiver);
    let search_radius: f32 = umbrage_penumbra(z, softness);
    let found: vec2f = umbrage_blockers32(map, size, at, receiver, search_radius, rotation);
    let mean: f32 = umbrage_floor_divide(found.y, max(found.x, 1.0));
    let radius: f32 = umbrage_penumbra(z - mean, softness);
    // without a blocker the radius is the search's, whose points are all lit
    return umbrage_disc32(map, size, coord, receiver, radius * (1.0 / 16.0), rotation);
}
`,
            "blocker_at": `
// umbrage_blocker_at: (1.0, depth) of the texel at a point where it is before the receiver, else (0.0, 0.0)
//   uv  over the map, (0.0, 0.0) to (1.0, 1.0), no NaN
fn umbrage_blocker_at(UMBRAGE_MAP map, size: vec2f, uv: vec2f, receiver: f32) -> vec2f {
    let stored: f32 = umbrage_depth_at(map, size, uv);
    return select(vec2f(1.0, stored), vec2f(0.0, 0.0), umbrage_compare(receiver, stored) > 0.5);
}
`,
            "pcss_radius": `
// umbrage_pcss_radius: radius of a penumbra in texels; without a blocker that of one at the near plane
//   found     (how many blockers, the sum of their depths);   receiver  depth, biased
//   softness  (1/16 texel a code, min_radius, max_radius), of make_penumbra_params
fn umbrage_pcss_radius(found: vec2f, receiver: f32, softness: vec3f) -> f32 {
    let forward: bool = umbrage_cleared_depth() > 0.5;
    let mean: f32 = select(select(1.0, 0.0, forward), found.y / found.x, found.x > 0.5);
    let radius: f32 = select(mean - receiver, receiver - mean, forward) * (softness.x * 4096.0);
    let min_radius: f32 = softness.y * 0.0625;
    return select(min_radius, min(radius, softness.z * 0.0625), radius > min_radius);
}
`,
            "blockers_hardware8": `
// umbrage_blockers_hardware8: of the texels at 8 points of a disc those before the receiver: (how many, depths' sum)
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   radius  in texels, at most 255.9375;   rotation  umbrage_disc_rotation of the pixel
fn umbrage_blockers_hardware8(UMBRAGE_MAP map, size: vec2f, coord: vec2f, receiver: f32, radius: f32,
                              rotation: vec2f) -> vec2f {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let center: vec2f = select(vec2f(0.0, 0.0), coord, compared) / size;
    let scaled: vec2f = rotation * (select(0.0, min(radius, 255.9375), radius > 0.0) * (1.0 / 1024.0));
    let x: vec2f = scaled / size;
    let y: vec2f = vec2f(0.0 - scaled.y, scaled.x) / size;
    var n: vec2f = vec2f(0.0, 0.0);
    n += umbrage_blocker_at(map, size, center + x * 3.0 - y * 1.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 4.0 + y * 5.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 1.0 - y * 11.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 9.0 - y * 8.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 12.0 + y * 3.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 11.0 + y * 6.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 0.0 + y * 13.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 11.0 - y * 7.0, receiver);
    return select(vec2f(0.0, 0.0), n, compared);
}
`,
            "blockers_hardware16": `
// umbrage_blockers_hardware16: of the texels at 16 points of a disc those before the receiver: (how many, depths' sum)
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   radius  in texels, at most 255.9375;   rotation  umbrage_disc_rotation of the pixel
fn umbrage_blockers_hardware16(UMBRAGE_MAP map, size: vec2f, coord: vec2f, receiver: f32, radius: f32,
                               rotation: vec2f) -> vec2f {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let center: vec2f = select(vec2f(0.0, 0.0), coord, compared) / size;
    let scaled: vec2f = rotation * (select(0.0, min(radius, 255.9375), radius > 0.0) * (1.0 / 1024.0));
    let x: vec2f = scaled / size;
    let y: vec2f = vec2f(0.0 - scaled.y, scaled.x) / size;
    var n: vec2f = vec2f(0.0, 0.0);
    n += umbrage_blocker_at(map, size, center + x * 1.0 - y * 3.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 5.0 + y * 2.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 5.0 + y * 2.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 0.0 + y * 7.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 6.0 - y * 5.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 8.0 - y * 5.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 0.0 - y * 11.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 11.0 + y * 5.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 12.0 + y * 4.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 1.0 + y * 13.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 7.0 + y * 11.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 9.0 + y * 10.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 13.0 - y * 4.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 7.0 - y * 12.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 7.0 - y * 12.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 14.0 - y * 2.0, receiver);
    return select(vec2f(0.0, 0.0), n, compared);
}
`,
            "blockers_hardware32": `
// umbrage_blockers_hardware32: of the texels at 32 points of a disc those before the receiver: (how many, depths' sum)
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   radius  in texels, at most 255.9375;   rotation  umbrage_disc_rotation of the pixel
fn umbrage_blockers_hardware32(UMBRAGE_MAP map, size: vec2f, coord: vec2f, receiver: f32, radius: f32,
                               rotation: vec2f) -> vec2f {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let center: vec2f = select(vec2f(0.0, 0.0), coord, compared) / size;
    let scaled: vec2f = rotation * (select(0.0, min(radius, 255.9375), radius > 0.0) * (1.0 / 1024.0));
    let x: vec2f = scaled / size;
    let y: vec2f = vec2f(0.0 - scaled.y, scaled.x) / size;
    var n: vec2f = vec2f(0.0, 0.0);
    n += umbrage_blocker_at(map, size, center - x * 2.0 - y * 1.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 3.0 + y * 2.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 1.0 - y * 4.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 4.0 + y * 3.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 0.0 + y * 6.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 5.0 - y * 5.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 7.0 - y * 2.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 8.0 - y * 1.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 8.0 + y * 3.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 5.0 + y * 7.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 1.0 - y * 9.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 6.0 - y * 7.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 8.0 + y * 5.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 0.0 + y * 10.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 3.0 - y * 10.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 6.0 + y * 10.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 9.0 - y * 8.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 11.0 - y * 5.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 5.0 - y * 12.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 13.0 - y * 1.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 7.0 + y * 11.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 13.0 + y * 3.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 13.0 + y * 4.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 10.0 - y * 10.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 14.0 - y * 2.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 11.0 + y * 9.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 3.0 + y * 14.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 13.0 - y * 6.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 12.0 + y * 8.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 4.0 + y * 14.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 7.0 - y * 13.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 0.0 - y * 15.0, receiver);
    return select(vec2f(0.0, 0.0), n, compared);
}
`,
            "hardened_kernel8": `
// umbrage_hardened_kernel8: the share of 8 points in shadow, steepened
//   blocked  how many;   ratio  of the penumbra to the disc in 1/256, a whole number: 256.0 leaves the share as it is
fn umbrage_hardened_kernel8(blocked: f32, ratio: f32) -> f32 {
    let u: f32 = blocked * 2.0 - 8.0;
    let d: f32 = max(8.0 - abs(u), 0.0);  // not negative already: no sum is regrouped across the max
    let steep: f32 = 512.0 - d * d * d;
    let hard: f32 = select(512.0 + steep, 512.0 - steep, u < 0.0);
    return (hard * (256.0 - ratio) + blocked * ratio * 128.0) * (1.0 / 262144.0);
}
`,
            "hardened_kernel16": `
// umbrage_hardened_kernel16: the share of 16 points in shadow, steepened
//   blocked  how many;   ratio  of the penumbra to the disc in 1/256, a whole number: 256.0 leaves the share as it is
fn umbrage_hardened_kernel16(blocked: f32, ratio: f32) -> f32 {
    let u: f32 = blocked * 2.0 - 16.0;
    let d: f32 = max(16.0 - abs(u), 0.0);  // not negative already: no sum is regrouped across the max
    let steep: f32 = 4096.0 - d * d * d;
    let hard: f32 = select(4096.0 + steep, 4096.0 - steep, u < 0.0);
    return (hard * (256.0 - ratio) + blocked * ratio * 512.0) * (1.0 / 2097152.0);
}
`,
            "hardened_kernel32": `
// umbrage_hardened_kernel32: the share of 32 points in shadow, steepened
//   blocked  how many;   ratio  of the penumbra to the disc in 1/256, a whole number: 256.0 leaves the share as it is
fn umbrage_hardened_kernel32(blocked: f32, ratio: f32) -> f32 {
    let u: f32 = blocked * 2.0 - 32.0;
    let d: f32 = max(32.0 - abs(u), 0.0);  // not negative already: no sum is regrouped across the max
    let steep: f32 = 32768.0 - d * d * d;
    let hard: f32 = select(32768.0 + steep, 32768.0 - steep, u < 0.0);
    return (hard * (256.0 - ratio) + blocked * ratio * 2048.0) * (1.0 / 16777216.0);
}
`,
            "dpcf8": `
// umbrage_dpcf8: contact hardening by 8 points; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   softness  of make_penumbra_params;  rotation  umbrage_disc_rotation of the pixel
fn umbrage_dpcf8(UMBRAGE_MAP map, size: vec2f, coord: vec2f, receiver: f32, softness: vec3f, rotation: vec2f) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let at: vec2f = select(vec2f(0.0, 0.0), floor(coord * 256.0), compared);
    let z: f32 = umbrage_distance_code(receiver);
    let search_radius: f32 = umbrage_penumbra(z, softness);
    let found: vec2f = umbrage_blockers8(map, size, at, receiver, search_radius, rotation);
    let mean: f32 = umbrage_floor_divide(found.y, max(found.x, 1.0));
    let radius: f32 = umbrage_penumbra(z - mean, softness);
    let ratio: f32 = umbrage_floor_divide(radius * 256.0, max(search_radius, 1.0));
    let dark: f32 = umbrage_hardened_kernel8(found.x, ratio);
    return select(1.0, clamp(1.0 - dark, 0.0, 1.0), compared);
}
`,
            "dpcf16": `
// umbrage_dpcf16: contact hardening by 16 points; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   softness  of make_penumbra_params;  rotation  umbrage_disc_rotation of the pixel
fn umbrage_dpcf16(UMBRAGE_MAP map, size: vec2f, coord: vec2f, receiver: f32, softness: vec3f, rotation: vec2f) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let at: vec2f = select(vec2f(0.0, 0.0), floor(coord * 256.0), compared);
    let z: f32 = umbrage_distance_code(receiver);
    let search_radius: f32 = umbrage_penumbra(z, softness);
    let found: vec2f = umbrage_blockers16(map, size, at, receiver, search_radius, rotation);
    let mean: f32 = umbrage_floor_divide(found.y, max(found.x, 1.0));
    let radius: f32 = umbrage_penumbra(z - mean, softness);
    let ratio: f32 = umbrage_floor_divide(radius * 256.0, max(search_radius, 1.0));
    let dark: f32 = umbrage_hardened_kernel16(found.x, ratio);
    return select(1.0, clamp(1.0 - dark, 0.0, 1.0), compared);
}
`,
            "dpcf32": `
// umbrage_dpcf32: contact hardening by 32 points; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   softness  of make_penumbra_params;  rotation  umbrage_disc_rotation of the pixel
fn umbrage_dpcf32(UMBRAGE_MAP map, size: vec2f, coord: vec2f, receiver: f32, softness: vec3f, rotation: vec2f) -> f32 {
    let compared: bool = umbrage_in_filter_domain(coord, receiver);
    let at: vec2f = select(vec2f(0.0, 0.0), floor(coord * 256.0), compared);
    let z: f32 = umbrage_distance_code(receiver);
    let search_radius: f32 = umbrage_penumbra(z, softness);
    let found: vec2f = umbrage_blockers32(map, size, at, receiver, search_radius, rotation);
    let mean: f32 = umbrage_floor_divide(found.y, max(found.x, 1.0));
    let radius: f32 = umbrage_penumbra(z - mean, softness);
    let ratio: f32 = umbrage_floor_divide(radius * 256.0, max(search_radius, 1.0));
    let dark: f32 = umbrage_hardened_kernel32(found.x, ratio);
    return select(1.0, clamp(1.0 - dark, 0.0, 1.0), compared);
}
`,
            "box_moments": `
// umbrage_box_moments: (mean, rest, high, low) of the codes in a box of n texels: their sum is n mean + rest, and
//   that of their squared distances from mean 4096 high + low;  whole numbers
//   map, size  a table of make_variance_table and its size;   first, end  of the box, first < end
fn umbrage_box_moments(UMBRAGE_MAP map, size: vec2f, first: vec2f, end: vec2f) -> vec4f {
    let a: vec4f = umbrage_texel(map, size, end);
    let b: vec4f = umbrage_texel(map, size, vec2f(first.x, end.y));
    let c: vec4f = umbrage_texel(map, size, vec2f(end.x, first.y));
    let d: vec4f = umbrage_texel(map, size, first);
    let part: vec4f = (a - b) - (c - d);
    var low: vec2f = vec2f(part.x, part.z);
    let carry: vec2f = floor(low * (1.0 / 65536.0));
    var above: vec2f = vec2f(part.y, part.w) + carry;
    // nothing below is negative; compilers cannot regroup sums across a max
    low = max(low - carry * 65536.0, vec2f(0.0, 0.0));
    above = max(above - floor(above * (1.0 / 65536.0)) * 65536.0, vec2f(0.0, 0.0));
    let sum: f32 = above.x * 65536.0 + low.x;
    let sides: vec2f = max(end - first, vec2f(1.0, 1.0));
    let n: f32 = sides.x * sides.y;
    let mean: f32 = umbrage_floor_divide(sum, n);
    let rest: f32 = max(sum - mean * n, 0.0);
    var digits: vec2f = vec2f(sum + rest, low.y);
    let high: vec2f = floor(digits * (1.0 / 4096.0));
    digits = max(digits - high * 4096.0, vec2f(0.0, 0.0));
    let below: f32 = digits.y - mean * digits.x;
    let borrow: f32 = floor(below * (1.0 / 4096.0));
    var wide: f32 = above.y * 16.0 + high.y - mean * high.x + borrow;
    wide = wide - floor(wide * (1.0 / 1048576.0)) * 1048576.0;
    return vec4f(mean, rest, wide, below - borrow * 4096.0);
}
`,
            "summed_variance": `
// umbrage_summed_variance: variance shadow from a summed-area table; visibility, 1.0 is lit
//   map, size  the table, of make_variance_table, and its size: one more than the shadow map's
//   coord, receiver  in texels of the shadow map, first center at (0.5, 0.5), and depth, biased
//   radius     whole: the box has 2 radius + 1 texels a side;   codes  2^bits of the table
fn umbrage_summed_variance(UMBRAGE_MAP map, size: vec2f, coord: vec2f, receiver: f32, radius: f32, codes: f32) -> f32 {
    let last: vec2f = size - 1.0;
    let compared: bool = select(false, umbrage_in_filter_domain(coord, receiver), umbrage_map_covers(last, coord));
    let texel: vec2f = select(vec2f(0.0, 0.0), clamp(floor(coord), vec2f(0.0, 0.0), last - 1.0), compared);
    let first: vec2f = max(texel - radius, vec2f(0.0, 0.0));
    let end: vec2f = min(texel + radius + 1.0, last);
    let m: vec4f = umbrage_box_moments(map, size, first, end);
    let sides: vec2f = end - first;
    let n: f32 = sides.x * sides.y;
    let share: f32 = m.y / n;
    let variance: f32 = (m.z * 4096.0 + (m.w - m.y)) / n + share * (1.0 - share);
    let scaled: f32 = receiver * codes;
    let t: f32 = select(codes - scaled, scaled, umbrage_cleared_depth() > 0.5);
    let d: f32 = (t - 1.0 - m.x) - share;
    let behind: f32 = select(0.0, variance / (variance + d * d), d > 0.0);
    return select(1.0, select(behind, 1.0, d <= 0.0), compared);
}
`,
            "box_mean": `
// umbrage_box_mean: mean of four whole numbers below 65536.0 over a box
//   map, size  a table of make_moment_table and its size;   first, end  of the box, first < end
fn umbrage_box_mean(UMBRAGE_MAP map, size: vec2f, first: vec2f, end: vec2f) -> vec4f {
    let right: f32 = size.x * 0.5;
    var a: vec4f = umbrage_texel(map, size, end);
    var b: vec4f = umbrage_texel(map, size, vec2f(first.x, end.y));
    var c: vec4f = umbrage_texel(map, size, vec2f(end.x, first.y));
    var d: vec4f = umbrage_texel(map, size, first);
    let low: vec4f = (a - b) - (c - d);
    let carry: vec4f = floor(low * (1.0 / 65536.0));
    a = umbrage_texel(map, size, vec2f(right + end.x, end.y));
    b = umbrage_texel(map, size, vec2f(right + first.x, end.y));
    c = umbrage_texel(map, size, vec2f(right + end.x, first.y));
    d = umbrage_texel(map, size, vec2f(right + first.x, first.y));
    let above: vec4f = (a - b) - (c - d) + carry;
    let high: vec4f = above - floor(above * (1.0 / 65536.0)) * 65536.0;
    let sum: vec4f = high * 65536.0 + (low - carry * 65536.0);
    let sides: vec2f = end - first;
    return sum / (sides.x * sides.y);
}
`,
            "from_optimized_moments": `
// umbrage_from_optimized_moments: four moments of what umbrage_to_optimized_moments made of them
fn umbrage_from_optimized_moments(o: vec4f) -> vec4f {
    let x: f32 = o.x - 0.5;
    let z: f32 = o.z - 0.5;
    let eighth: f32 = o.y * 0.125;
    let b1: f32 = z * 1.73205078 - x * 0.333333343;
    let b2: f32 = o.w + eighth;
    let b3: f32 = z * 1.29903817 - x * 0.75;
    let b4: f32 = o.w - eighth;
    return vec4f(b1, b2, b3, b4);
}
`,
            "bias_moments": `
// umbrage_bias_moments: moments moved by a share bias.x towards (0.0, bias.y, 0.0, bias.y)
fn umbrage_bias_moments(b: vec4f, bias: vec2f) -> vec4f {
    let x: f32 = b.x - b.x * bias.x;
    let y: f32 = b.y + (bias.y - b.y) * bias.x;
    let z: f32 = b.z - b.z * bias.x;
    let w: f32 = b.w + (bias.y - b.w) * bias.x;
    return vec4f(x, y, z, w);
}
`,
            "to_forward_depth": `
// umbrage_to_forward_depth: depth that grows with distance, 1.0 - depth where the map's is reversed
fn umbrage_to_forward_depth(depth: f32) -> f32 {
    return select(depth, 1.0 - depth, umbrage_cleared_depth() < 0.5);
}
`,
            "moment_atoms": `
// umbrage_moment_atoms: the two depths that beside the receiver's have the same moments, less b.x, and their shares
//   b  moments, biased;   x  the receiver's depth on -1.0 to 1.0 less b.x
fn umbrage_moment_atoms(b: vec4f, x: f32) -> vec4f {
    let d: f32 = b.y - b.x * b.x;
    let third: f32 = b.z - b.x * b.y;
    let l: f32 = third / d;
    let e: f32 = (b.w - b.y * b.y) - third * l;
    let h: f32 = b.x * 2.0 - l;
    let a: f32 = d * ((x + h) * x - d);
    let m: f32 = x * e + h * a;
    let c: f32 = d * (e - a);
    let square: f32 = m * m - 4.0 * a * c;
    let root: f32 = sqrt(select(0.0, square, square > 0.0));
    let w: f32 = select(-(m + root), root - m, m < 0.0) * 0.5;
    let t: vec2f = vec2f(w / a, c / w);
    let q: vec2f = (t + h) * t - d;
    let least: f32 = d * e;
    let sum: vec2f = least + (t * t * e + q * q * d);
    return vec4f(t.x, t.y, least / sum.x, least / sum.y);
}
`,
            "decode_msm": `
// umbrage_decode_msm: visibility of a receiver, at least its lit share less bias.x; 1.0 is lit
//   b  mean of texels;   receiver  depth, biased
//   bias  (3e-6, 0.375) of floats of 32 bits, (6e-5, 0.628) of channels of 16
fn umbrage_decode_msm(b: vec4f, receiver: f32, bias: vec2f) -> f32 {
    let d: f32 = umbrage_to_forward_depth(receiver);
    let m: vec4f = umbrage_bias_moments(b, bias);
    let x: f32 = (select(0.0, select(1.0, d, d < 1.0), d > 0.0) * 2.0 - 1.0) - m.x;
    let atoms: vec4f = umbrage_moment_atoms(m, x);
    let first: f32 = select(0.0, atoms.z, atoms.x < x);
    let second: f32 = select(0.0, atoms.w, atoms.y < x);
    var lit: f32 = 1.0 - (first + second);
    let known: bool = abs(atoms.z + atoms.w) <= 4294967296.0;  // what is no NaN
    lit = select(select(0.0, 1.0, x <= 0.0), select(0.0, select(1.0, lit, lit < 1.0), lit > 0.0), known);
    return select(select(0.0, lit, d <= 0.0), lit, d > 0.0);
}
`,
            "summed_moments": `
// umbrage_summed_moments: moment shadow from a summed-area table; visibility, 1.0 is lit
//   map, size  the table, of make_moment_table, and its size: twice the shadow map's width and two, its height and one
//   coord, receiver  in texels of the shadow map, first center at (0.5, 0.5), and depth, biased
//   radius     whole: the box has 2 radius + 1 texels a side;   bias  (6e-5, 0.628)
fn umbrage_summed_moments(UMBRAGE_MAP map, size: vec2f, coord: vec2f, receiver: f32, radius: f32, bias: vec2f) -> f32 {
    let last: vec2f = vec2f(size.x * 0.5, size.y) - 1.0;
    let compared: bool = select(false, umbrage_in_filter_domain(coord, receiver), umbrage_map_covers(last, coord));
    let texel: vec2f = select(vec2f(0.0, 0.0), clamp(floor(coord), vec2f(0.0, 0.0), last - 1.0), compared);
    let first: vec2f = max(texel - radius, vec2f(0.0, 0.0));
    let end: vec2f = min(texel + radius + 1.0, last);
    let turned: vec4f = umbrage_box_mean(map, size, first, end) * (1.0 / 65535.0);
    let lit: f32 = umbrage_decode_msm(umbrage_from_optimized_moments(turned), receiver, bias);
    return select(1.0, lit, compared);
}
`,
            "power_of_two": `
// umbrage_power_of_two: 2^n of a whole number n, -64.0 to 63.0
fn umbrage_power_of_two(n: f32) -> f32 {
    let exponent: u32 = u32(n + 127.0);
    return bitcast<f32>(exponent << 23);
}
`,
            "exp2_polynomial": `
// umbrage_exp2_polynomial: 2^y, off by at most 1.8e-7 of it
//   y  outside of -64.0 to 63.0 the nearer end counts, of NaN -64.0
fn umbrage_exp2_polynomial(y: f32) -> f32 {
    let x: f32 = select(-64.0, min(y, 63.0), y > -64.0);
    let n: f32 = floor(x);
    let f: f32 = x - n;
    var p: f32 = 0.00187931862 * f + 0.00899099465;
    p = p * f + 0.0558186769;
    p = p * f + 0.240159273;
    p = p * f + 0.693151712;
    p = p * f + 1.0;
    return p * umbrage_power_of_two(n);
}
`,
            "exp2_steps": `
// umbrage_exp2_steps: 2^y, a whole number below 2^12 times a power of two, y rounded down to 1/2048
//   y  outside of -64.0 to 63.0 the nearer end counts, of NaN -64.0
fn umbrage_exp2_steps(y: f32) -> f32 {
    let x: f32 = floor(select(-64.0, min(y, 63.0), y > -64.0) * 2048.0);
    let n: f32 = floor(x * (1.0 / 2048.0));
    let f: f32 = max(x - n * 2048.0, 0.0);  // not negative already: no sum is regrouped across the max
    let g: f32 = floor(f * (2048.0 - f) * (1.0 / 256.0));
    let r: f32 = 1251.0 + floor(f * 314.0 * (1.0 / 2048.0));
    let m: f32 = 2048.0 + f - floor((g * r + 16384.0) * (1.0 / 32768.0));
    return m * (1.0 / 2048.0) * umbrage_power_of_two(n);
}
`,
            "chebyshev": `
// umbrage_chebyshev: share of depths that may be as far as the receiver or farther, at most; 0.0 where something is NaN
//   m  mean of the depths, mean of their squares;   receiver  on the same scale;   min_variance  0.0 or more
fn umbrage_chebyshev(m: vec2f, receiver: f32, min_variance: f32) -> f32 {
    let difference: f32 = m.y - m.x * m.x;
    let variance: f32 = select(min_variance, difference, difference > min_variance);
    let distance: f32 = receiver - m.x;
    let sum: f32 = variance + distance * distance;
    let p: f32 = variance / sum;
    return select(select(0.0, min(p, 1.0), p > 0.0), 1.0, receiver <= m.x);  // a GPU's v / v may be more than 1.0
}
`,
            "reduce_light_bleeding": `
// umbrage_reduce_light_bleeding: visibility from amount to 1.0 stretched to 0.0 to 1.0: less light bleeds
fn umbrage_reduce_light_bleeding(visibility: f32, amount: f32) -> f32 {
    let stretched: f32 = (visibility - amount) / (1.0 - amount);
    return select(0.0, stretched, visibility > amount);
}
`,
            "encode_vsm": `
// umbrage_encode_vsm: depth and its square, of depth that grows with distance; NaN counts as far
fn umbrage_encode_vsm(depth: f32) -> vec2f {
    let d: f32 = umbrage_to_forward_depth(umbrage_saturate(depth));
    return vec2f(d, d * d);
}
`,
            "decode_vsm": `
// umbrage_decode_vsm: visibility of a receiver, at least its lit share; 1.0 is lit
//   m  mean of texels;   receiver  depth, biased;   min_variance  0.0 or more
fn umbrage_decode_vsm(m: vec2f, receiver: f32, min_variance: f32) -> f32 {
    return umbrage_chebyshev(m, umbrage_to_forward_depth(receiver), min_variance);
}
`,
            "encode_deviation": `
// umbrage_encode_deviation: mean and mean square of depths to mean and twice the standard deviation, each 0.0 to 1.0
fn umbrage_encode_deviation(m: vec2f) -> vec2f {
    let variance: f32 = m.y - m.x * m.x;
    return vec2f(m.x, 2.0 * sqrt(select(0.0, variance, variance > 0.0)));
}
`,
            "decode_deviation": `
// umbrage_decode_deviation: mean and twice the standard deviation to mean and mean square of depths
fn umbrage_decode_deviation(held: vec2f) -> vec2f {
    let half_of_it: f32 = held.y * 0.5;
    let square: f32 = held.x * held.x + half_of_it * half_of_it;
    return vec2f(held.x, square);
}
`,
            "decode_deviation_rgba8": `
// umbrage_decode_deviation_rgba8: mean and deviation, two channels each, as sampled, to mean and mean square of depths
fn umbrage_decode_deviation_rgba8(c: vec4f) -> vec2f {
    let mean: f32 = umbrage_decode_rg16(vec2f(c.x, c.y), 1.0);
    let deviation: f32 = umbrage_decode_rg16(vec2f(c.z, c.w), 1.0);
    return umbrage_decode_deviation(vec2f(mean, deviation));
}
`,
            "exponential_warp": `
// umbrage_exponential_warp: 2^(exponent * (2.0 * depth - 1.0)) of a depth that grows with distance
fn umbrage_exponential_warp(depth: f32, exponent: f32) -> f32 {
    let y: f32 = exponent * (depth * 2.0 - 1.0);
    return umbrage_exp2_polynomial(y);
}
`,
            "encode_esm": `
// umbrage_encode_esm: depth's power, of depth that grows with distance; NaN counts as far
fn umbrage_encode_esm(depth: f32, exponent: f32) -> f32 {
    return umbrage_exponential_warp(umbrage_to_forward_depth(umbrage_saturate(depth)), exponent);
}
`,
            "decode_esm": `
// umbrage_decode_esm: visibility of a receiver, at least its lit share; 1.0 is lit
//   m  mean of texels;   receiver  depth, biased;   exponent  as of the texels
fn umbrage_decode_esm(m: f32, receiver: f32, exponent: f32) -> f32 {
    let d: f32 = umbrage_to_forward_depth(receiver);
    let p: f32 = m * umbrage_exponential_warp(d, -exponent);
    let lit: f32 = select(select(0.0, 1.0, p >= 1.0), p, p > 0.0 && p < 1.0);
    return select(select(0.0, lit, d <= 0.0), lit, d > 0.0);
}
`,
            "encode_evsm2": `
// umbrage_encode_evsm2: depth's power and its square, of depth that grows with distance; NaN counts as far
fn umbrage_encode_evsm2(depth: f32, exponent: f32) -> vec2f {
    let w: f32 = umbrage_exponential_warp(umbrage_to_forward_depth(umbrage_saturate(depth)), exponent);
    return vec2f(w, w * w);
}
`,
            "encode_evsm4": `
// umbrage_encode_evsm4: depth's growing power, its square, the negative falling one, its square; NaN counts as far
fn umbrage_encode_evsm4(depth: f32, exponents: vec2f) -> vec4f {
    let d: f32 = umbrage_to_forward_depth(umbrage_saturate(depth));
    let w: f32 = umbrage_exponential_warp(d, exponents.x);
    let n: f32 = -umbrage_exponential_warp(d, -exponents.y);
    return vec4f(w, w * w, n, n * n);
}
`,
            "decode_evsm2": `
// umbrage_decode_evsm2: visibility of a receiver, at least its lit share; 1.0 is lit
//   m  mean of texels;   receiver  depth, biased;   exponent  as of the texels
//   deviation  least standard deviation, as a part of the receiver's power
fn umbrage_decode_evsm2(m: vec2f, receiver: f32, exponent: f32, deviation: f32) -> f32 {
    let d: f32 = umbrage_to_forward_depth(umbrage_saturate(receiver));
    let w: f32 = umbrage_exponential_warp(d, exponent);
    let least: f32 = deviation * w;
    let least_variance: f32 = least * least;
    let lit: f32 = umbrage_chebyshev(m, w, least_variance);
    return select(select(0.0, lit, receiver <= 0.0), lit, receiver > 0.0);
}
`,
            "decode_evsm4": `
// umbrage_decode_evsm4: visibility of a receiver, at least its lit share; 1.0 is lit
//   m  mean of texels;   receiver  depth, biased;   exponents  as of the texels
//   deviations  least standard deviations, as parts of the receiver's powers
fn umbrage_decode_evsm4(m: vec4f, receiver: f32, exponents: vec2f, deviations: vec2f) -> f32 {
    let d: f32 = umbrage_to_forward_depth(umbrage_saturate(receiver));
    let w: f32 = umbrage_exponential_warp(d, exponents.x);
    let n: f32 = -umbrage_exponential_warp(d, -exponents.y);
    let least: vec2f = deviations * vec2f(w, n);
    let least_variance: vec2f = least * least;
    let a: f32 = umbrage_chebyshev(vec2f(m.x, m.y), w, least_variance.x);
    let b: f32 = umbrage_chebyshev(vec2f(m.z, m.w), n, least_variance.y);
    let lit: f32 = select(b, a, a < b);
    return select(select(0.0, lit, receiver <= 0.0), lit, receiver > 0.0);
}
`,
            "encode_msm": `
// umbrage_encode_msm: first four powers of depth on -1.0 to 1.0, of depth that grows with distance; NaN counts as far
fn umbrage_encode_msm(depth: f32) -> vec4f {
    let z: f32 = umbrage_to_forward_depth(umbrage_saturate(depth)) * 2.0 - 1.0;
    let square: f32 = z * z;
    return vec4f(z, square, square * z, square * square);
}
`,
            "to_optimized_moments": `
// umbrage_to_optimized_moments: four moments so that each takes 0.0 to 1.0 wholly, for four channels of 16 bits
fn umbrage_to_optimized_moments(b: vec4f) -> vec4f {
    let x: f32 = (b.x * 0.75 - b.z) * 2.0 + 0.5;
    let y: f32 = (b.y - b.w) * 4.0;
    let z: f32 = (b.x * 2.25 - b.z) * 0.384900182 + 0.5;
    let w: f32 = (b.y + b.w) * 0.5;
    return vec4f(x, y, z, w);
}
`,
            "hausdorff_share": `
// umbrage_hausdorff_share: least share of depths on -1.0 to 1.0 before the receiver's, of four moments
//   b  moments, biased;   z  the receiver's depth on -1.0 to 1.0
//   negative where the share is that of umbrage_moment_atoms
fn umbrage_hausdorff_share(b: vec4f, z: f32) -> f32 {
    let variance: f32 = b.y - b.x * b.x;
    let third: f32 = b.z - b.x * b.y;
    let fourth: f32 = b.w - b.y * b.y;
    let rest: f32 = 1.0 - b.y;
    let x: f32 = z - b.x;
    let d: f32 = third + rest * x;
    let g: f32 = (fourth - variance * rest) - (z + b.x) * third;
    let p: f32 = d * (1.0 + b.x) + g;
    let q: f32 = d * (1.0 - b.x) - g;
    let k: f32 = rest * g + third * d;
    let first: f32 = (1.0 + z) * (d * variance + g * (1.0 - b.x)) - k;
    let last: f32 = (1.0 - z) * (d * variance - g * (1.0 + b.x)) + k;
    let square: f32 = d * d;
    let between: f32 = p * (q * (x * d - g));
    let end: f32 = first / (2.0 * ((1.0 + z) * p));
    let other: f32 = square * square / between;
    let share: f32 = end + select(0.0, other, d > 0.0);
    let four: bool = first * p > 0.0 && last * q > 0.0 && p * q > 0.0 && share >= 0.0;
    return select(select(-1.0, select(1.0, share, share < 1.0), four), 0.0, z <= -1.0);
}
`,
            "decode_msm_hausdorff": `
// umbrage_decode_msm_hausdorff: visibility of a receiver, at least its lit share less bias.x; 1.0 is lit
//   b  mean of texels;   receiver  depth, biased;   bias  (3e-6, 0.375)
fn umbrage_decode_msm_hausdorff(b: vec4f, receiver: f32, bias: vec2f) -> f32 {
    let plain: f32 = umbrage_decode_msm(b, receiver, bias);
    let d: f32 = umbrage_to_forward_depth(receiver);
    let z: f32 = select(0.0, select(1.0, d, d < 1.0), d > 0.0) * 2.0 - 1.0;
    let share: f32 = umbrage_hausdorff_share(umbrage_bias_moments(b, bias), z);
    let lit: f32 = select(plain, 1.0 - share, share >= 0.0);
    return select(select(0.0, lit, d <= 0.0), lit, d > 0.0);
}
`,
            "fetch_bilinear": `
// umbrage_fetch_bilinear: mean of the four texels around a point, weights in steps of 1/256
//   coord  in texels, first center at (0.5, 0.5)
fn umbrage_fetch_bilinear(UMBRAGE_MAP map, size: vec2f, coord: vec2f) -> vec4f {
    let x: vec2f = floor(coord * 256.0) - 128.0;
    let texel: vec2f = floor(x * (1.0 / 256.0));
    // weights are in [0, 256) already; compilers cannot regroup sums across the clamp
    let hi: vec2f = clamp(x * (1.0 / 256.0) - texel, vec2f(0.0, 0.0), vec2f(1.0, 1.0)) * 256.0;
    let lo: vec2f = 256.0 - hi;  // of 1.0 - hi compilers would make an interpolation, which rounds otherwise
    let a: vec4f = umbrage_fetch_clamped(map, size, texel);
    let b: vec4f = umbrage_fetch_clamped(map, size, texel + vec2f(1.0, 0.0));
    let c: vec4f = umbrage_fetch_clamped(map, size, texel + vec2f(0.0, 1.0));
    let d: vec4f = umbrage_fetch_clamped(map, size, texel + vec2f(1.0, 1.0));
    let low: vec4f = a * lo.x + b * hi.x;
    let high: vec4f = c * lo.x + d * hi.x;
    let sum: vec4f = low * lo.y + high * hi.y;
    return sum * (1.0 / 65536.0);
}
`,
            "vsm": `
// umbrage_vsm: visibility from a map of encode_vsm's texels, blurred; 1.0 is lit
//   map, size  prefiltered map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   min_variance  0.0 or more
fn umbrage_vsm(UMBRAGE_MAP map, size: vec2f, coord: vec2f, receiver: f32, min_variance: f32) -> f32 {
    let compared: bool = select(false, umbrage_in_filter_domain(coord, receiver), umbrage_map_covers(size, coord));
    let m: vec4f = umbrage_fetch_bilinear(map, size, select(vec2f(0.0, 0.0), coord, compared));
    let lit: f32 = umbrage_decode_vsm(vec2f(m.x, m.y), receiver, min_variance);
    return select(1.0, lit, compared);
}
`,
            "esm": `
// umbrage_esm: visibility from a map of encode_esm's texels, blurred; 1.0 is lit
//   map, size  prefiltered map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   exponent  as of the texels
fn umbrage_esm(UMBRAGE_MAP map, size: vec2f, coord: vec2f, receiver: f32, exponent: f32) -> f32 {
    let compared: bool = select(false, umbrage_in_filter_domain(coord, receiver), umbrage_map_covers(size, coord));
    let m: vec4f = umbrage_fetch_bilinear(map, size, select(vec2f(0.0, 0.0), coord, compared));
    let lit: f32 = umbrage_decode_esm(m.x, receiver, exponent);
    return select(1.0, lit, compared);
}
`,
            "evsm2": `
// umbrage_evsm2: visibility from a map of encode_evsm2's texels, blurred; 1.0 is lit
//   map, size  prefiltered map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   exponent, deviation  as of decode_evsm2
fn umbrage_evsm2(UMBRAGE_MAP map, size: vec2f, coord: vec2f, receiver: f32, exponent: f32, deviation: f32) -> f32 {
    let compared: bool = select(false, umbrage_in_filter_domain(coord, receiver), umbrage_map_covers(size, coord));
    let m: vec4f = umbrage_fetch_bilinear(map, size, select(vec2f(0.0, 0.0), coord, compared));
    let lit: f32 = umbrage_decode_evsm2(vec2f(m.x, m.y), receiver, exponent, deviation);
    return select(1.0, lit, compared);
}
`,
            "evsm4": `
// umbrage_evsm4: visibility from a map of encode_evsm4's texels, blurred; 1.0 is lit
//   map, size  prefiltered map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   exponents, deviations  as of decode_evsm4
fn umbrage_evsm4(UMBRAGE_MAP map, size: vec2f, coord: vec2f, receiver: f32, exponents: vec2f,
                 deviations: vec2f) -> f32 {
    let compared: bool = select(false, umbrage_in_filter_domain(coord, receiver), umbrage_map_covers(size, coord));
    let m: vec4f = umbrage_fetch_bilinear(map, size, select(vec2f(0.0, 0.0), coord, compared));
    let lit: f32 = umbrage_decode_evsm4(m, receiver, exponents, deviations);
    return select(1.0, lit, compared);
}
`,
            "msm": `
// umbrage_msm: visibility from a map of encode_msm's texels, blurred; 1.0 is lit
//   map, size  prefiltered map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   bias  as of decode_msm
fn umbrage_msm(UMBRAGE_MAP map, size: vec2f, coord: vec2f, receiver: f32, bias: vec2f) -> f32 {
    let compared: bool = select(false, umbrage_in_filter_domain(coord, receiver), umbrage_map_covers(size, coord));
    let m: vec4f = umbrage_fetch_bilinear(map, size, select(vec2f(0.0, 0.0), coord, compared));
    let lit: f32 = umbrage_decode_msm(m, receiver, bias);
    return select(1.0, lit, compared);
}
`,
            "msm_unorm16": `
// umbrage_msm_unorm16: visibility from a map of turned moments, blurred; 1.0 is lit
//   map, size  prefiltered map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   bias  as of decode_msm
fn umbrage_msm_unorm16(UMBRAGE_MAP map, size: vec2f, coord: vec2f, receiver: f32, bias: vec2f) -> f32 {
    let compared: bool = select(false, umbrage_in_filter_domain(coord, receiver), umbrage_map_covers(size, coord));
    let m: vec4f = umbrage_fetch_bilinear(map, size, select(vec2f(0.0, 0.0), coord, compared));
    let lit: f32 = umbrage_decode_msm(umbrage_from_optimized_moments(m), receiver, bias);
    return select(1.0, lit, compared);
}
`,
            "msm_hausdorff": `
// umbrage_msm_hausdorff: visibility from a map of encode_msm's texels, blurred; 1.0 is lit
//   map, size  prefiltered map and its size in texels;   coord  receiver in texels, first center at (0.5, 0.5)
//   receiver   depth, biased;   bias  as of decode_msm
fn umbrage_msm_hausdorff(UMBRAGE_MAP map, size: vec2f, coord: vec2f, receiver: f32, bias: vec2f) -> f32 {
    let compared: bool = select(false, umbrage_in_filter_domain(coord, receiver), umbrage_map_covers(size, coord));
    let m: vec4f = umbrage_fetch_bilinear(map, size, select(vec2f(0.0, 0.0), coord, compared));
    let lit: f32 = umbrage_decode_msm_hausdorff(m, receiver, bias);
    return select(1.0, lit, compared);
}
`,
            "chebyshev_hardware": `
// umbrage_chebyshev_hardware: share of depths that may be as far as the receiver or farther, its least part cut
//   variance  above 0.0;   distance  from mean to receiver, no NaN;   amount  that is cut, 0.0 to 0.5
fn umbrage_chebyshev_hardware(variance: f32, distance: f32, amount: f32) -> f32 {
    let beyond: f32 = max(distance, 0.0);
    let p: f32 = variance / (variance + beyond * beyond);
    return clamp((p - amount) / (1.0 - amount), 0.0, 1.0);
}
`,
            "decode_vsm_hardware": `
// umbrage_decode_vsm_hardware: visibility of a receiver, less the light that bleeds; 1.0 is lit
//   held  mean and twice the standard deviation of depths, filtered;   receiver  depth, biased
//   min_variance  1e-7 or more;   amount  that is cut, 0.0 to 0.5
fn umbrage_decode_vsm_hardware(held: vec2f, receiver: f32, min_variance: f32, amount: f32) -> f32 {
    let variance: f32 = max(held.y * held.y * 0.25, min_variance);
    let distance: f32 = umbrage_to_forward_depth(receiver) - held.x;
    let lit: f32 = umbrage_chebyshev_hardware(variance, distance, amount);
    return select(0.0, lit, abs(receiver) < 1048576.0);
}
`,
            "decode_evsm2_hardware": `
// umbrage_decode_evsm2_hardware: visibility of a receiver, less the light that bleeds; 1.0 is lit
//   m  mean of texels;   receiver  depth, biased;   exponent  as of the texels
//   deviation  least standard deviation, as a part of the receiver's power;   amount  that is cut, 0.0 to 0.3
fn umbrage_decode_evsm2_hardware(m: vec2f, receiver: f32, exponent: f32, deviation: f32, amount: f32) -> f32 {
    let d: f32 = umbrage_to_forward_depth(clamp(receiver, 0.0, 1.0));
    let w: f32 = exp2(exponent * (d * 2.0 - 1.0));
    let least: f32 = deviation * w;
    let variance: f32 = max(m.y - m.x * m.x, least * least);
    let lit: f32 = umbrage_chebyshev_hardware(variance, w - m.x, amount);
    return select(0.0, lit, abs(receiver) < 1048576.0);
}
`,
            "decode_evsm4_hardware": `
// umbrage_decode_evsm4_hardware: visibility of a receiver, less the light that bleeds; 1.0 is lit
//   m  mean of texels;   receiver  depth, biased;   exponents  as of the texels
//   deviations  least standard deviations, as parts of the receiver's powers;   amount  that is cut, 0.0 to 0.3
fn umbrage_decode_evsm4_hardware(m: vec4f, receiver: f32, exponents: vec2f, deviations: vec2f, amount: f32) -> f32 {
    let d: f32 = umbrage_to_forward_depth(clamp(receiver, 0.0, 1.0)) * 2.0 - 1.0;
    let w: f32 = exp2(exponents.x * d);
    let n: f32 = 0.0 - exp2((0.0 - exponents.y) * d);
    let least: vec2f = deviations * vec2f(w, n);
    let growing: f32 = max(m.y - m.x * m.x, least.x * least.x);
    let falling: f32 = max(m.w - m.z * m.z, least.y * least.y);
    let a: f32 = umbrage_chebyshev_hardware(growing, w - m.x, amount);
    let b: f32 = umbrage_chebyshev_hardware(falling, n - m.z, amount);
    return select(0.0, min(a, b), abs(receiver) < 1048576.0);
}
`,
            "blur_row3": `
// umbrage_blur_row3: mean of 3 texels in a row, weighed by a row of Pascal's triangle
//   map, size  read from, and its size in texels;   texel  whole numbers, (0, 0) is the first
//   along      (1.0, 0.0) or (0.0, 1.0)
fn umbrage_blur_row3(UMBRAGE_MAP map, size: vec2f, texel: vec2f, along: vec2f) -> vec4f {
    var sum: vec4f = umbrage_fetch_clamped(map, size, texel) * (2.0 / 4.0);
    let before1: vec4f = umbrage_fetch_clamped(map, size, texel - along * 1.0);
    let after1: vec4f = umbrage_fetch_clamped(map, size, texel + along * 1.0);
    sum = sum + (before1 + after1) * (1.0 / 4.0);
    return sum;
}
`,
            "blur_row5": `
// umbrage_blur_row5: mean of 5 texels in a row, weighed by a row of Pascal's triangle
//   map, size  read from, and its size in texels;   texel  whole numbers, (0, 0) is the first
//   along      (1.0, 0.0) or (0.0, 1.0)
fn umbrage_blur_row5(UMBRAGE_MAP map, size: vec2f, texel: vec2f, along: vec2f) -> vec4f {
    var sum: vec4f = umbrage_fetch_clamped(map, size, texel) * (6.0 / 16.0);
    let before1: vec4f = umbrage_fetch_clamped(map, size, texel - along * 1.0);
    let after1: vec4f = umbrage_fetch_clamped(map, size, texel + along * 1.0);
    sum = sum + (before1 + after1) * (4.0 / 16.0);
    let before2: vec4f = umbrage_fetch_clamped(map, size, texel - along * 2.0);
    let after2: vec4f = umbrage_fetch_clamped(map, size, texel + along * 2.0);
    sum = sum + (before2 + after2) * (1.0 / 16.0);
    return sum;
}
`,
            "blur_row7": `
// umbrage_blur_row7: mean of 7 texels in a row, weighed by a row of Pascal's triangle
//   map, size  read from, and its size in texels;   texel  whole numbers, (0, 0) is the first
//   along      (1.0, 0.0) or (0.0, 1.0)
fn umbrage_blur_row7(UMBRAGE_MAP map, size: vec2f, texel: vec2f, along: vec2f) -> vec4f {
    var sum: vec4f = umbrage_fetch_clamped(map, size, texel) * (20.0 / 64.0);
    let before1: vec4f = umbrage_fetch_clamped(map, size, texel - along * 1.0);
    let after1: vec4f = umbrage_fetch_clamped(map, size, texel + along * 1.0);
    sum = sum + (before1 + after1) * (15.0 / 64.0);
    let before2: vec4f = umbrage_fetch_clamped(map, size, texel - along * 2.0);
    let after2: vec4f = umbrage_fetch_clamped(map, size, texel + along * 2.0);
    sum = sum + (before2 + after2) * (6.0 / 64.0);
    let before3: vec4f = umbrage_fetch_clamped(map, size, texel - along * 3.0);
    let after3: vec4f = umbrage_fetch_clamped(map, size, texel + along * 3.0);
    sum = sum + (before3 + after3) * (1.0 / 64.0);
    return sum;
}
`,
            "halve_texels": `
// umbrage_halve_texels: mean of the 2x2 texels that a texel of the next level of a mip chain is made of
//   map, size  read from, and its size in texels;   texel  of the next level, whole numbers
fn umbrage_halve_texels(UMBRAGE_MAP map, size: vec2f, texel: vec2f) -> vec4f {
    let at: vec2f = texel * 2.0;
    let a: vec4f = umbrage_fetch_clamped(map, size, at);
    let b: vec4f = umbrage_fetch_clamped(map, size, at + vec2f(1.0, 0.0));
    let c: vec4f = umbrage_fetch_clamped(map, size, at + vec2f(0.0, 1.0));
    let d: vec4f = umbrage_fetch_clamped(map, size, at + vec2f(1.0, 1.0));
    let sum: vec4f = (a + b) + (c + d);
    return sum * 0.25;
}
`,
            "texels_to_world": `
// umbrage_texels_to_world: texels across a light as world units; 0.0 for w <= 0.0
//   units  (edge of a texel, depth a world unit) at w = 1.0;   w  of the point's shadow coordinate
fn umbrage_texels_to_world(texels: f32, units: vec2f, w: f32) -> f32 {
    let world: f32 = texels * units.x * w;
    return select(0.0, world, world >= (1.0 / 18446744073709551616.0) && world < 18446744073709551616.0);
}
`,
            "clamp_bias": `
// umbrage_clamp_bias: a bias in depth clamped to [0, 1], 0.0 below 2^-64; NaN becomes 1.0, and nothing is in shadow
fn umbrage_clamp_bias(bias: f32) -> f32 {
    let least: f32 = (1.0 / 18446744073709551616.0);
    return select(select(1.0, 0.0, bias < least), bias, bias >= least && bias < 1.0);
}
`,
            "world_to_depth": `
// umbrage_world_to_depth: world units along a light as depth, 0.0 to 1.0
//   units  (edge of a texel, depth a world unit) at w = 1.0;   w  of the point's shadow coordinate, above 0.0
fn umbrage_world_to_depth(world: f32, units: vec2f, w: f32) -> f32 {
    let along: f32 = world * units.y;
    let square: f32 = w * w;
    return umbrage_clamp_bias(along / square);
}
`,
            "biased": `
// umbrage_biased: receiver moved towards the light by bias, in depth; 2^64 and more, and NaN, is none
fn umbrage_biased(receiver: f32, bias: f32) -> f32 {
    let by: f32 = select(0.0, bias, abs(bias) < 18446744073709551616.0);
    return select(receiver + by, receiver - by, umbrage_cleared_depth() > 0.5);
}
`,
            "clamp_slope": `
// umbrage_clamp_slope: change of depth a texel clamped to [-2, 2]; NaN becomes 2.0
fn umbrage_clamp_slope(slope: f32) -> f32 {
    return select(select(2.0, -2.0, slope <= -2.0), slope, slope > -2.0 && slope < 2.0);
}
`,
            "plane_slope": `
// umbrage_plane_slope: change of depth from one texel to the next, in x and y, of the plane through a point
//   plane_matrix  transpose of the texture matrix' inverse;   normal  of any length;   world  point on the plane
fn umbrage_plane_slope(plane_matrix: mat4x4f, normal: vec3f, world: vec3f) -> vec2f {
    let d: f32 = -(normal.x * world.x + normal.y * world.y + normal.z * world.z);
    let q: vec4f = plane_matrix[3] * d + plane_matrix[0] * normal.x + plane_matrix[1] * normal.y + plane_matrix[2] *
        normal.z;
    return vec2f(umbrage_clamp_slope(-q.x / q.z), umbrage_clamp_slope(-q.y / q.z));
}
`,
            "receiver_slope": `
// umbrage_receiver_slope: umbrage_plane_slope, and (0.0, 0.0) for a normal of zero, of a caller who has none
fn umbrage_receiver_slope(plane_matrix: mat4x4f, normal: vec3f, world: vec3f) -> vec2f {
    let slope: vec2f = umbrage_plane_slope(plane_matrix, normal, world);
    let none: bool = normal.x == 0.0 && normal.y == 0.0 && normal.z == 0.0;
    return select(slope, vec2f(0.0, 0.0), none);
}
`,
            "cascade_slope": `
// umbrage_cascade_slope: change of depth from one texel to the next; (0.0, 0.0) for a normal of zero
//   normal  of the surface, rotated into the light's directions;   scale  of the cascade
fn umbrage_cascade_slope(normal: vec3f, scale: vec4f) -> vec2f {
    let up: vec2f = vec2f(normal.x, normal.y) * -scale.z;
    let across: vec2f = vec2f(scale.x, scale.y) * normal.z;
    let none: bool = normal.x == 0.0 && normal.y == 0.0 && normal.z == 0.0;
    let slope: vec2f = vec2f(umbrage_clamp_slope(up.x / across.x), umbrage_clamp_slope(up.y / across.y));
    return select(slope, vec2f(0.0, 0.0), none);
}
`,
            "slope_bias": `
// umbrage_slope_bias: factor times the greater slope, and a base, 0.0 to 1.0
//   slope  change of depth from one texel to the next;   factor  in texels;   base  in depth
fn umbrage_slope_bias(slope: vec2f, factor: f32, base: f32) -> f32 {
    let bias: vec2f = abs(slope) * factor + base;
    let x: f32 = umbrage_clamp_bias(bias.x);  // of both: a maximum of a NaN is what a GPU makes it
    let y: f32 = umbrage_clamp_bias(bias.y);
    return select(y, x, x > y);
}
`,
            "dual_paraboloid_slope": `
// umbrage_dual_paraboloid_slope: change of distance from one texel to the next, in x and y alike; 0.0 without a normal
//   way  from the light to the receiver;   normal  of its surface;   per_texel  2.0 / (range * (size - 2.0 * border))
fn umbrage_dual_paraboloid_slope(way: vec3f, normal: vec3f, per_texel: f32) -> vec2f {
    let square: f32 = way.x * way.x + way.y * way.y + way.z * way.z;
    let x: f32 = normal.y * way.z - normal.z * way.y;
    let y: f32 = normal.z * way.x - normal.x * way.z;
    let z: f32 = normal.x * way.y - normal.y * way.x;
    let across: f32 = x * x + y * y + z * z;
    let along: f32 = normal.x * way.x + normal.y * way.y + normal.z * way.z;
    let wide: f32 = (sqrt(square) + abs(way.z)) * (per_texel * 0.707106781);
    let slope: f32 = umbrage_clamp_slope(wide * sqrt(across) / abs(along));
    let none: bool = normal.x == 0.0 && normal.y == 0.0 && normal.z == 0.0;
    return select(vec2f(slope, slope), vec2f(0.0, 0.0), none);
}
`,
            "normal_offset": `
// umbrage_normal_offset: what to add to a surface's point, world units, before it is looked up
//   normal, direction  of the surface and the light, of length one;   way  from the light to the point over w; of a
//   directional light its direction;   width  sqrt(2) reach texel;   error_world  of the map's depths; world units
fn umbrage_normal_offset(normal: vec3f, direction: vec3f, way: vec3f, width: f32, error_world: f32) -> vec3f {
    let x: f32 = normal.y * direction.z + normal.z * -direction.y;
    let y: f32 = normal.z * direction.x + normal.x * -direction.z;
    let z: f32 = normal.x * direction.y + normal.y * -direction.x;
    let straight: f32 = normal.x * way.x + normal.y * way.y + normal.z * way.z;
    let square: f32 = x * x + y * y + z * z;
    let along: f32 = width * sqrt(square) + error_world * abs(straight);
    let offset: vec3f = normal * along;
    return select(vec3f(0.0, 0.0, 0.0), offset, abs(offset.x) + abs(offset.y) + abs(offset.z) < 18446744073709551616.0);
}
`,
            "kernel_bias": `
// umbrage_kernel_bias: how far along the light a kernel reaches before a surface's plane, in the units of width
//   normal  of the surface;   direction  of the light, of length one;   way  from the light to the point over w; of a
//   directional light its direction;   width  sqrt(2) reach texel;   greatest  tangent, where growth ends
fn umbrage_kernel_bias(normal: vec3f, direction: vec3f, way: vec3f, width: f32, greatest: f32) -> f32 {
    let x: f32 = normal.y * direction.z + normal.z * -direction.y;
    let y: f32 = normal.z * direction.x + normal.x * -direction.z;
    let z: f32 = normal.x * direction.y + normal.y * -direction.x;
    let square: f32 = x * x + y * y + z * z;
    let sine: f32 = sqrt(square);
    let cosine: f32 = -(normal.x * way.x + normal.y * way.y + normal.z * way.z);
    let edge: f32 = cosine * greatest;
    let tangent: f32 = select(greatest, sine / cosine, edge > sine);
    let bias: f32 = width * tangent;
    return select(0.0, bias, bias >= (1.0 / 18446744073709551616.0) && bias < 18446744073709551616.0);
}
`,
            "receiver_plane_slope": `
// umbrage_receiver_plane_slope: change of a receiver's depth a texel in x and y, and by how much their sum may be off
//   dx, dy  dFdx and dFdy of (x and y in texels, depth); zero where they tell nothing of the plane
fn umbrage_receiver_plane_slope(dx: vec3f, dy: vec3f) -> vec3f {
    let determinant: f32 = dx.x * dy.y + dx.y * -dy.x;
    let sum: f32 = abs(dx.x) + abs(dx.y) + abs(dy.x) + abs(dy.y);
    let along_x: f32 = dy.y * dx.z + dx.y * -dy.z;
    let along_y: f32 = dx.x * dy.z + dy.x * -dx.z;
    let a: f32 = umbrage_clamp_slope(along_x / determinant);
    let b: f32 = umbrage_clamp_slope(along_y / determinant);
    let off: f32 = ((1.0 / 33554432.0) + (abs(a) + abs(b)) * (1.0 / 8192.0)) * 3.3;
    let error: f32 = off * (sum / abs(determinant));
    let least: f32 = sum * (1.0 / 1024.0);
    let known: bool = abs(determinant) > least && sum < 18446744073709551616.0;
    return select(vec3f(0.0, 0.0, 0.0), vec3f(a, b, umbrage_clamp_slope(error)), known);
}
`,
            "apply_receiver_plane": `
// umbrage_apply_receiver_plane: a texel's depth as the receiver's own texel would hold it; a cleared one stays cleared
//   stored  depth of the texel;   slope  of the receiver's plane, a texel;   coord  receiver in texels
fn umbrage_apply_receiver_plane(stored: f32, slope: vec2f, coord: vec2f, texel: vec2f) -> f32 {
    let way: vec2f = texel + 0.5 - coord;
    let depth: f32 = stored - (slope.x * way.x + slope.y * way.y);
    let cleared: bool = abs(stored - umbrage_cleared_depth()) < (1.0 / 18446744073709551616.0);
    return select(depth, stored, cleared);
}
`,
            "acne_free_bias": `
// umbrage_acne_free_bias: the smallest bias in depth with which no plane shadows itself, 0.0 to 1.0
//   slope  change of depth from one texel to the next;   reach  of the filter, texels
//   error  how far a decoded depth may lie before the true one
fn umbrage_acne_free_bias(slope: vec2f, reach: f32, error: f32) -> f32 {
    let bias: f32 = reach * (abs(slope.x) + abs(slope.y)) + (error + (1.0 / 8388608.0));
    return umbrage_clamp_bias(bias);
}
`,
            "acne_free_disc_bias": `
// umbrage_acne_free_disc_bias: the smallest bias in depth with which no plane shadows itself, 0.0 to 1.0
//   slope   change of depth from one texel to the next;   radius  to the disc's farthest point, texels
//   error   how far a decoded depth may lie before the true one
fn umbrage_acne_free_disc_bias(slope: vec2f, radius: f32, error: f32) -> f32 {
    let square: f32 = slope.x * slope.x + slope.y * slope.y;
    let beside: f32 = (abs(slope.x) + abs(slope.y)) * 0.5078125 + (error + (1.0 / 8388608.0));
    let bias: f32 = radius * sqrt(square) + beside;
    return umbrage_clamp_bias(bias);
}
`,
            "peter_panning_distance": `
// umbrage_peter_panning_distance: a caster nearer to the receiver loses its shadow, or a part of it; depth, 0.0 to 1.0
//   bias   of the receiver, in depth;   caster_slope  change of the caster's depth from one texel to the next
//   reach  of the filter, texels
fn umbrage_peter_panning_distance(bias: f32, caster_slope: vec2f, reach: f32) -> f32 {
    return umbrage_acne_free_bias(caster_slope, reach, bias);
}
`,
            "spot_cone": `
// umbrage_spot_cone: 1.0 inside the cone of a spot light, else 0.0
//   direction  of the light, unit length;   to_point  from the light, any length;   cos_outer  in [0, 1)
fn umbrage_spot_cone(direction: vec3f, to_point: vec3f, cos_outer: f32) -> f32 {
    let d: f32 = direction.x * to_point.x + direction.y * to_point.y + direction.z * to_point.z;
    let length2: f32 = to_point.x * to_point.x + to_point.y * to_point.y + to_point.z * to_point.z;
    let edge2: f32 = cos_outer * cos_outer * length2;
    let d2: f32 = d * d;
    return select(0.0, 1.0, d > 0.0 && d2 > edge2);
}
`,
            "diffuse_ambient": `
// umbrage_diffuse_ambient: albedo * (visibility * n_dot_l * (1 - ambient) + ambient); for n_dot_l <= 0, NaN: ambient
fn umbrage_diffuse_ambient(albedo: vec3f, ambient: f32, n_dot_l: f32, visibility: f32) -> vec3f {
    let light: f32 = visibility * n_dot_l * (1.0 - ambient) + ambient;
    return albedo * select(ambient, light, n_dot_l > 0.0);  // a max of n_dot_l and 0.0 is NaN for a signalling one on Mesa
}
`,
            "false_color": `
// umbrage_false_color: blue for 0.0, through green, to red for 1.0
fn umbrage_false_color(v: f32) -> vec3f {
    let x: f32 = umbrage_saturate(v) * 4.0;
    let ramp: vec3f = 1.5 - abs(vec3f(x - 3.0, x - 2.0, x - 1.0));
    return vec3f(umbrage_saturate(ramp.x), umbrage_saturate(ramp.y), umbrage_saturate(ramp.z));
}
`,
            "overlay_texel": `
// umbrage_overlay_texel: texel under a pixel of a map stretched over the picture's corner; -1.0 outside the overlay
//   coord     center of the pixel, counted from the corner: 0.5, 1.5, ...;   size  of the overlay in pixels, whole
//   map_size  in texels, whole, at most 65536.0; times size at most 2^23;   texels_per_pixel  map_size / size
fn umbrage_overlay_texel(coord: f32, size: f32, map_size: f32, texels_per_pixel: f32) -> f32 {
    var texel: f32 = floor(coord * texels_per_pixel - 0.5);
    texel += select(0.0, 1.0, (texel + 1.0) * size <= coord * map_size);
    return select(-1.0, texel, coord >= 0.0 && coord < size);
}
`,
            "probe_color": `
// umbrage_probe_color: what a receiver's place in a map says, as a color
//   at    (x, y) in texels, z depth;   size  of the map;   bias  of the receiver;   number  of the map, whole
//   magenta  not a number;   black  behind the light, in no cascade;   white  outside the map
//   cyan  beyond the far plane;   blue  before the near plane;   red  bias at its limit;   else texels
fn umbrage_probe_color(at: vec3f, size: vec2f, bias: f32, number: f32) -> vec3f {
    let limit: f32 = 18446744073709551616.0;
    let usable: bool = abs(at.x) < limit && abs(at.y) < limit && abs(at.z) < limit;
    let inside: bool = at.x >= 0.0 && at.y >= 0.0 && at.x <= size.x && at.y <= size.y;
    let forward: bool = umbrage_cleared_depth() > 0.5;
    let past_far: bool = select((at.z < 0.0), (at.z > 1.0), forward);
    let past_near: bool = select((at.z > 1.0), (at.z < 0.0), forward);
    let square: f32 = floor(at.x) + floor(at.y);
    let shade: f32 = select(1.0, 0.75, square - 2.0 * floor(square * 0.5) > 0.5);
    var bits: vec3f = floor(vec3f(number + 1.0, (number + 1.0) * 0.5, (number + 1.0) * 0.25));
    bits = bits - 2.0 * floor(bits * 0.5);
    var color: vec3f = (bits * 0.5 + 0.375) * shade;
    color = select(vec3f(1.0, 0.0, 0.0), color, bias < 1.0);
    color = select(color, vec3f(0.0, 0.0, 1.0), past_near);
    color = select(color, vec3f(0.0, 1.0, 1.0), past_far);
    color = select(vec3f(1.0, 1.0, 1.0), color, inside);
    color = select(vec3f(0.0, 0.0, 0.0), color, at.x < 65536.0);
    return select(vec3f(1.0, 0.0, 1.0), color, usable);
}
`,
            "probe_inputs": `
// umbrage_probe_inputs: color, unless the receiver is wrong; magenta  not a number;   yellow  a normal of zero
fn umbrage_probe_inputs(color: vec3f, world: vec3f, normal: vec3f) -> vec3f {
    let limit: f32 = 18446744073709551616.0;
    var usable: bool = abs(world.x) < limit && abs(world.y) < limit && abs(world.z) < limit;
    usable = usable && abs(normal.x) < limit && abs(normal.y) < limit && abs(normal.z) < limit;
    let zero: bool = normal.x == 0.0 && normal.y == 0.0 && normal.z == 0.0;
    let given: vec3f = select(color, vec3f(1.0, 1.0, 0.0), zero);
    return select(vec3f(1.0, 0.0, 1.0), given, usable);
}
`,
            "hooks/cleared_depth, reversed": `
// umbrage_cleared_depth: depth of the far plane
fn umbrage_cleared_depth() -> f32 {
    return 0.0;
}
`,
            "hooks/map_covers, clamped": `
// umbrage_map_covers: always, as outside the map the nearest texel inside counts
fn umbrage_map_covers(size: vec2f, coord: vec2f) -> bool {
    return true;
}
`,
            "hooks/beyond_far_plane, reversed": `
// umbrage_beyond_far_plane: whether a receiver is behind the far plane
fn umbrage_beyond_far_plane(receiver: f32) -> bool {
    return receiver < 0.0;
}
`,
            "hooks/beyond_far_plane, without": `
// umbrage_beyond_far_plane: never for this map; receivers behind the far plane come in as what every texel lights
fn umbrage_beyond_far_plane(receiver: f32) -> bool {
    return false;
}
`,
            "hooks/within_far_plane, reversed": `
// umbrage_within_far_plane: whether a receiver is a number, and not behind the far plane
fn umbrage_within_far_plane(receiver: f32) -> bool {
    return receiver >= 0.0;
}
`,
            "hooks/within_far_plane, without": `
// umbrage_within_far_plane: whether a receiver is a number, as for this map none is behind the far plane
fn umbrage_within_far_plane(receiver: f32) -> bool {
    // a sum of choices, not an or of comparisons, which compilers take for true
    let number: f32 = select(0.0, 1.0, receiver > 0.0) + select(0.0, 1.0, receiver <= 0.0);
    return number > 0.5;
}
`,
            "hooks/compare, reversed": `
// umbrage_compare: 1.0 when the receiver is no farther than the stored depth, near is 1.0
fn umbrage_compare(receiver: f32, stored: f32) -> f32 {
    return select(0.0, 1.0, receiver >= stored);
}
`,
            "hooks/compare, own": `
// umbrage_compare: visibility of one comparison, the map's own
fn umbrage_compare(receiver: f32, stored: f32) -> f32 {
    return UMBRAGE_COMPARE;
}
`,
            "hooks/decode": `
// umbrage_decode: depth of a value that the sampler gave
fn umbrage_decode(value: vec4f) -> f32 {
    return UMBRAGE_DEPTH;
}
`,
            "hooks/fetch_depth, clamped": `
// umbrage_fetch_depth: stored depth of a texel, outside the map of the nearest one inside
fn umbrage_fetch_depth(UMBRAGE_MAP map, size: vec2f, texel: vec2f) -> f32 {
    let value: vec4f = umbrage_fetch_clamped(map, size, texel);
    return UMBRAGE_DEPTH;
}
`,
            "hooks/lit_texel": `
// umbrage_lit_texel: the sampler's comparison with a texel inside the map; a NaN is in shadow
fn umbrage_lit_texel(UMBRAGE_MAP map, size: vec2f, texel: vec2f, receiver: f32) -> f32 {
    let at: vec2f = texel + UMBRAGE_ORIGIN;
    let lit: f32 = UMBRAGE_LIT_TEXEL;
    return select(0.0, lit, receiver > 0.0) + select(0.0, lit, receiver <= 0.0);
}
`,
            "hooks/lit, clamped": `
// umbrage_lit: visibility of one comparison with a texel, outside the map with the nearest one inside
fn umbrage_lit(UMBRAGE_MAP map, size: vec2f, texel: vec2f, receiver: f32) -> f32 {
    return umbrage_lit_texel(map, size, clamp(texel, vec2f(0.0, 0.0), size - 1.0), receiver);
}
`,
            "hooks/lit, bordered": `
// umbrage_lit: visibility of one comparison with a texel, outside the map with the far plane
fn umbrage_lit(UMBRAGE_MAP map, size: vec2f, texel: vec2f, receiver: f32) -> f32 {
    let inside: vec2f = clamp(texel, vec2f(0.0, 0.0), size - 1.0);
    let lit: f32 = umbrage_lit_texel(map, size, inside, receiver);
    let outside: f32 = umbrage_compare(receiver, UMBRAGE_BORDER);
    return select(outside, lit, inside.x == texel.x && inside.y == texel.y);
}
`,
            "hooks/gather_lit, compared": `
// umbrage_gather_lit: the sampler's comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1); a NaN is in shadow
fn umbrage_gather_lit(UMBRAGE_MAP map, size: vec2f, texel: vec2f, receiver: f32) -> vec4f {
    let at: vec2f = texel + UMBRAGE_ORIGIN;
    let lit: vec4f = UMBRAGE_GATHER_LIT;
    let number: f32 = select(0.0, 1.0, receiver > 0.0) + select(0.0, 1.0, receiver <= 0.0);
    return vec4f(lit.w, lit.z, lit.x, lit.y) * number;
}
`,
            "hooks/gather_lit, one channel": `
// umbrage_gather_lit: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1)
fn umbrage_gather_lit(UMBRAGE_MAP map, size: vec2f, texel: vec2f, receiver: f32) -> vec4f {
    let at: vec2f = texel + UMBRAGE_ORIGIN;
    let r: vec4f = UMBRAGE_GATHER_RED;
    let a: f32 = umbrage_compare(receiver, umbrage_decode(vec4f(r.w, 0.0, 0.0, 0.0)));
    let b: f32 = umbrage_compare(receiver, umbrage_decode(vec4f(r.z, 0.0, 0.0, 0.0)));
    let c: f32 = umbrage_compare(receiver, umbrage_decode(vec4f(r.x, 0.0, 0.0, 0.0)));
    let d: f32 = umbrage_compare(receiver, umbrage_decode(vec4f(r.y, 0.0, 0.0, 0.0)));
    return vec4f(a, b, c, d);
}
`,
            "hooks/gather_lit, two channels": `
// umbrage_gather_lit: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1)
fn umbrage_gather_lit(UMBRAGE_MAP map, size: vec2f, texel: vec2f, receiver: f32) -> vec4f {
    let at: vec2f = texel + UMBRAGE_ORIGIN;
    let r: vec4f = UMBRAGE_GATHER_RED;
    let g: vec4f = UMBRAGE_GATHER_GREEN;
    let a: f32 = umbrage_compare(receiver, umbrage_decode(vec4f(r.w, g.w, 0.0, 0.0)));
    let b: f32 = umbrage_compare(receiver, umbrage_decode(vec4f(r.z, g.z, 0.0, 0.0)));
    let c: f32 = umbrage_compare(receiver, umbrage_decode(vec4f(r.x, g.x, 0.0, 0.0)));
    let d: f32 = umbrage_compare(receiver, umbrage_decode(vec4f(r.y, g.y, 0.0, 0.0)));
    return vec4f(a, b, c, d);
}
`,
            "hooks/lit_2x2, gathered": `
// umbrage_lit_2x2: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1); the sampler clamps
fn umbrage_lit_2x2(UMBRAGE_MAP map, size: vec2f, texel: vec2f, receiver: f32) -> vec4f {
    return umbrage_gather_lit(map, size, texel, receiver);
}
`,
            "hooks/lit_2x2, gathered in a region": `
// umbrage_lit_2x2: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1), outside the map with
//   the nearest texel inside: the gather stays inside, and each comparison is taken from its row and column
fn umbrage_lit_2x2(UMBRAGE_MAP map, size: vec2f, texel: vec2f, receiver: f32) -> vec4f {
    let first: vec2f = clamp(texel, vec2f(0.0, 0.0), max(size - 2.0, vec2f(0.0, 0.0)));
    let low: vec2f = clamp(texel, vec2f(0.0, 0.0), size - 1.0) - first;
    let high: vec2f = clamp(texel + 1.0, vec2f(0.0, 0.0), size - 1.0) - first;
    let lit: vec4f = umbrage_gather_lit(map, size, first, receiver);
    let left: vec2f = select(vec2f(lit.x, lit.z), vec2f(lit.y, lit.w), low.x > 0.5);
    let right: vec2f = select(vec2f(lit.x, lit.z), vec2f(lit.y, lit.w), high.x > 0.5);
    let bottom: vec2f = select(vec2f(left.x, right.x), vec2f(left.y, right.y), low.y > 0.5);
    let top: vec2f = select(vec2f(left.x, right.x), vec2f(left.y, right.y), high.y > 0.5);
    return vec4f(bottom.x, bottom.y, top.x, top.y);
}
`,
            "hooks/lit_2x2, gathered and bordered": `
// umbrage_lit_2x2: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1), outside the map with
//   the far plane, whatever the sampler has there
fn umbrage_lit_2x2(UMBRAGE_MAP map, size: vec2f, texel: vec2f, receiver: f32) -> vec4f {
    let lit: vec4f = umbrage_gather_lit(map, size, texel, receiver);
    let outside: f32 = umbrage_compare(receiver, UMBRAGE_BORDER);
    let a: f32 = select(outside, lit.x, umbrage_inside_map(size, texel));
    let b: f32 = select(outside, lit.y, umbrage_inside_map(size, texel + vec2f(1.0, 0.0)));
    let c: f32 = select(outside, lit.z, umbrage_inside_map(size, texel + vec2f(0.0, 1.0)));
    let d: f32 = select(outside, lit.w, umbrage_inside_map(size, texel + vec2f(1.0, 1.0)));
    return vec4f(a, b, c, d);
}
`,
            "hooks/lit_2x2, gathered in a bordered region": `
// umbrage_lit_2x2: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1), outside the map with
//   the far plane: the gather stays inside
fn umbrage_lit_2x2(UMBRAGE_MAP map, size: vec2f, texel: vec2f, receiver: f32) -> vec4f {
    let first: vec2f = clamp(texel, vec2f(0.0, 0.0), max(size - 2.0, vec2f(0.0, 0.0)));
    let low: vec2f = texel - first;
    let lit: vec4f = umbrage_gather_lit(map, size, first, receiver);
    let left: vec2f = select(vec2f(lit.x, lit.z), vec2f(lit.y, lit.w), low.x > 0.5);
    let right: vec2f = select(vec2f(lit.y, lit.w), vec2f(lit.x, lit.z), low.x < -0.5);
    let bottom: vec2f = select(vec2f(left.x, right.x), vec2f(left.y, right.y), low.y > 0.5);
    let top: vec2f = select(vec2f(left.y, right.y), vec2f(left.x, right.x), low.y < -0.5);
    let outside: f32 = umbrage_compare(receiver, UMBRAGE_BORDER);
    let a: f32 = select(outside, bottom.x, umbrage_inside_map(size, texel));
    let b: f32 = select(outside, bottom.y, umbrage_inside_map(size, texel + vec2f(1.0, 0.0)));
    let c: f32 = select(outside, top.x, umbrage_inside_map(size, texel + vec2f(0.0, 1.0)));
    let d: f32 = select(outside, top.y, umbrage_inside_map(size, texel + vec2f(1.0, 1.0)));
    return vec4f(a, b, c, d);
}
`,
            "hooks/lit_filtered, clamped": `
// umbrage_lit_filtered: 2x2 comparisons around a point, weighted by the sampler; a NaN is in shadow
//   coord  in texels, no NaN
fn umbrage_lit_filtered(UMBRAGE_MAP map, size: vec2f, coord: vec2f, receiver: f32) -> f32 {
    let texel: vec2f = clamp(coord, vec2f(0.5, 0.5), size - 0.5);
    let at: vec2f = texel + UMBRAGE_ORIGIN;
    let uv: vec2f = UMBRAGE_UV;
    let lit: f32 = UMBRAGE_LIT_FILTERED;
    return select(0.0, lit, umbrage_within_far_plane(receiver));
}
`,
            "hooks/lit_filtered, bordered": `
// umbrage_lit_filtered: 2x2 comparisons around a point, weighted by the sampler, outside the map with the far plane; a
//   NaN is in shadow
//   coord  in texels, no NaN
fn umbrage_lit_filtered(UMBRAGE_MAP map, size: vec2f, coord: vec2f, receiver: f32) -> f32 {
    let texel: vec2f = clamp(coord, vec2f(0.5, 0.5), size - 0.5);
    let at: vec2f = texel + UMBRAGE_ORIGIN;
    let uv: vec2f = UMBRAGE_UV;
    let lit: f32 = UMBRAGE_LIT_FILTERED;
    let inside: vec2f = clamp(min(coord, size - coord) + 0.5, vec2f(0.0, 0.0), vec2f(1.0, 1.0));
    let outside: f32 = umbrage_compare(receiver, UMBRAGE_BORDER);
    return select(0.0, outside + inside.x * inside.y * (lit - outside), umbrage_within_far_plane(receiver));
}
`,
            "hooks/lit_at, sampled": `
// umbrage_lit_at: 2x2 comparisons around a point, weighted by the sampler
//   uv  over the map, (0.0, 0.0) to (1.0, 1.0);   receiver  no NaN
fn umbrage_lit_at(UMBRAGE_MAP map, size: vec2f, uv: vec2f, receiver: f32) -> f32 {
    return UMBRAGE_LIT_FILTERED;
}
`,
            "hooks/lit_at, sampled and bordered": `
// umbrage_lit_at: 2x2 comparisons around a point, weighted by the sampler, outside the map with the far plane
//   uv  over the map, (0.0, 0.0) to (1.0, 1.0);   receiver  no NaN
fn umbrage_lit_at(UMBRAGE_MAP map, size: vec2f, uv: vec2f, receiver: f32) -> f32 {
    let lit: f32 = UMBRAGE_LIT_FILTERED;
    let outside: f32 = umbrage_compare(receiver, UMBRAGE_BORDER);
    let inside: vec2f = clamp((0.5 - abs(uv - 0.5)) * size + 0.5, vec2f(0.0, 0.0), vec2f(1.0, 1.0));
    return outside + inside.x * inside.y * (lit - outside);
}
`,
            "hooks/depth_at, sampled": `
// umbrage_depth_at: stored depth of the texel at a point, by the sampler
//   uv  over the map, (0.0, 0.0) to (1.0, 1.0)
fn umbrage_depth_at(UMBRAGE_MAP map, size: vec2f, uv: vec2f) -> f32 {
    return umbrage_decode(UMBRAGE_SAMPLED);
}
`,
            "hooks/depth_at, sampled and bordered": `
// umbrage_depth_at: stored depth of the texel at a point, by the sampler, outside the map that of the far plane
//   uv  over the map, (0.0, 0.0) to (1.0, 1.0)
fn umbrage_depth_at(UMBRAGE_MAP map, size: vec2f, uv: vec2f) -> f32 {
    let depth: f32 = umbrage_decode(UMBRAGE_SAMPLED);
    return select(UMBRAGE_BORDER, depth, abs(uv.x - 0.5) <= 0.5 && abs(uv.y - 0.5) <= 0.5);
}
`,
        },
    },
};

// id, name, summary, exactness, operations, within, as_written, lowest, role, scaled, needs
const rows = [
    ["shadow_coordinate", "shadow_coordinate", "world to texels and depth, before the division", "b", 6, 0, false, "100", "none", false, []],
    ["tap_coordinate", "tap_coordinate", "a tap's coordinate from the middle's, before the division", "b", 2, 0, false, "100", "none", false, []],
    ["project_coordinate", "project_coordinate", "the division by w, lit behind the light", "c", 3, 0, false, "100", "none", false, []],
    ["cascade_by_depth", "cascade_by_depth", "cascade that a view depth falls into", "a", 0, 0, false, "100", "none", false, []],
    ["cascade_column", "cascade_column", "one of four columns, without an index", "a", 0, 0, false, "100", "none", false, []],
    ["cascade_column_8", "cascade_column_8", "one of eight columns, without an index", "a", 0, 0, false, "100", "none", false, ["cascade_column"]],
    ["cascade_coordinate", "cascade_coordinate", "a point in the map of one cascade", "b", 2, 0, false, "100", "none", false, []],
    ["inside_cascade", "inside_cascade", "coordinates whose filter stays inside a cascade", "b", 2, 0, false, "100", "none", false, []],
    ["cascade_by_projection", "cascade_by_projection", "first cascade that holds a point and its filter", "b", 4, 0, false, "100", "none", false, ["cascade_coordinate", "inside_cascade"]],
    ["cascade_by_projection_8", "cascade_by_projection_8", "first of eight cascades that holds a point and its filter", "b", 5, 0, false, "100", "none", false, ["cascade_by_projection"]],
    ["cascade_tile", "cascade_tile", "first texel of a cascade in an atlas", "a", 0, 0, false, "100", "none", false, []],
    ["cascade_weight", "cascade_weight", "a weight in steps of 1/256", "a", 0, 0, false, "100", "none", false, []],
    ["cascade_fade", "cascade_fade", "weight of the next cascade, by view depth", "b", 3, 0, false, "100", "none", false, ["cascade_weight"]],
    ["cascade_border_fade", "cascade_border_fade", "weight of the next cascade, by distance from the border", "b", 8, 0, false, "100", "none", false, ["cascade_weight"]],
    ["blend_cascades", "blend_cascades", "two cascades' visibilities, mixed", "b", 3, 0, false, "100", "none", false, []],
    ["inside_texel_space", "inside_texel_space", "coordinates a filter can take", "a", 0, 0, false, "100", "none", false, []],
    ["dither_threshold", "dither_threshold", "one of 16 thresholds for a pixel", "a", 0, 0, false, "100", "none", false, ["inside_texel_space"]],
    ["dithered_cascade", "dithered_cascade", "a cascade, or by its weight the next one", "a", 0, 0, false, "100", "none", false, []],
    ["cube_face", "cube_face", "face of a cube that a direction meets", "a", 0, 0, false, "100", "none", false, []],
    ["cube_view_z", "cube_view_z", "distance along the axis of the face that a direction meets", "a", 0, 0, false, "100", "none", false, ["cube_face"]],
    ["cube_plane", "cube_plane", "a direction in its face's axes", "a", 0, 0, false, "100", "none", false, ["cube_face"]],
    ["cube_point", "cube_point", "a point from a face's axes", "a", 0, 0, false, "100", "none", false, []],
    ["cube_face_point", "cube_face_point", "a point in a face's axes", "a", 0, 0, false, "100", "none", false, []],
    ["cube_coordinate", "cube_coordinate", "face, and where on it, that a direction meets", "c", 5, 0, false, "100", "none", false, ["cube_view_z", "cube_plane"]],
    ["cube_direction", "cube_direction", "direction to a point of a cube's face", "b", 2, 0, false, "100", "none", false, ["cube_point"]],
    ["cube_neighbor", "cube_neighbor", "texel beyond an edge of a cube's face", "a", 0, 0, false, "100", "none", false, ["cube_plane", "cube_point"]],
    ["cube_tile", "cube_tile", "first texel of a face in an atlas", "a", 0, 0, false, "100", "none", false, []],
    ["cube_atlas_texel", "cube_atlas_texel", "face that a texel of an atlas belongs to, and where on it", "a", 0, 0, false, "100", "none", false, []],
    ["cube_atlas_direction", "cube_atlas_direction", "direction that reads an atlas' texel from a texture of a cube", "a", 0, 0, false, "100", "none", false, ["cube_atlas_texel", "cube_point"]],
    ["dual_paraboloid_coordinate", "dual_paraboloid_coordinate", "paraboloid map, and where in it, that sees a direction", "c", 32, 0, false, "100", "none", false, []],
    ["dual_paraboloid_position", "dual_paraboloid_position", "a vertex of a paraboloid map's depth pass", "c", 18, 0, false, "100", "none", false, []],
    ["tetrahedron_face", "tetrahedron_face", "face of a tetrahedron that a direction meets", "b", 1, 0, false, "100", "none", false, []],
    ["tetrahedron_face_point", "tetrahedron_face_point", "a direction in the axes of a tetrahedron's face", "a", 0, 0, false, "100", "none", false, []],
    ["tetrahedron_plane", "tetrahedron_plane", "a direction in its tetrahedron face's axes", "b", 1, 0, false, "100", "none", false, ["tetrahedron_face", "tetrahedron_face_point"]],
    ["tetrahedron_view_z", "tetrahedron_view_z", "distance along the normal of the tetrahedron's face that a direction meets", "b", 3, 0, false, "100", "none", false, ["tetrahedron_plane"]],
    ["tetrahedron_coordinate", "tetrahedron_coordinate", "face of a tetrahedron, and where on it, that a direction meets", "c", 6, 0, false, "100", "none", false, ["tetrahedron_face", "tetrahedron_plane"]],
    ["tetrahedron_turned", "tetrahedron_turned", "a vector of a tetrahedron's first face on another face's side of the map", "a", 0, 0, false, "100", "none", false, []],
    ["tetrahedron_texel", "tetrahedron_texel", "a point of a tetrahedron's face in the map", "b", 9, 0, false, "100", "none", false, ["tetrahedron_turned"]],
    ["tetrahedron_face_of", "tetrahedron_face_of", "face of a tetrahedron that a texel belongs to", "a", 0, 0, false, "100", "none", false, []],
    ["pancake", "pancake", "casters before the near plane, onto it", "b", 1, 0, false, "100", "none", false, []],
    ["texel", "texel", "texel inside a map", "a", 0, 0, false, "100", "texel", false, []],
    ["from_unorm", "from_unorm", "value read from an 8-bit texture to channel 0..255", "a", 0, 0, false, "100", "none", false, []],
    ["page_coordinate", "page_coordinate", "a receiver in the page of an atlas that holds it", "a", 0, 0, false, "100", "none", false, ["texel", "from_unorm"]],
    ["linear_depth", "linear_depth", "view-space z over z_far", "b", 1, 0, false, "100", "none", false, []],
    ["project_depth", "project_depth", "z / w, far behind the light", "c", 3, 0, false, "100", "none", false, []],
    ["distance_depth", "distance_depth", "distance to the light over its range", "c", 9, 0, false, "100", "none", false, []],
    ["reverse_depth", "reverse_depth", "1 - depth", "b", 1, 0, false, "100", "none", false, []],
    ["depth_from_ndc", "depth_from_ndc", "z/w in [-1, 1] to depth in [0, 1]", "b", 2, 0, false, "100", "none", false, []],
    ["view_z_from_depth", "view_z_from_depth", "perspective depth to view-space z", "c", 8, 0, false, "100", "none", false, []],
    ["depth_from_view_z", "depth_from_view_z", "view-space z to perspective depth", "c", 10, 0, false, "100", "none", false, []],
    ["view_z_from_reversed_depth", "view_z_from_reversed_depth", "reversed perspective depth to view-space z", "c", 11, 0, false, "100", "none", false, []],
    ["reversed_depth_from_view_z", "reversed_depth_from_view_z", "view-space z to reversed perspective depth", "c", 13, 0, false, "100", "none", false, []],
    ["view_z_from_orthographic_depth", "view_z_from_orthographic_depth", "orthographic depth to view-space z", "b", 3, 0, false, "100", "none", false, []],
    ["orthographic_depth_from_view_z", "orthographic_depth_from_view_z", "view-space z to orthographic depth", "c", 5, 0, false, "100", "none", false, []],
    ["cleared_depth", "cleared_depth", "depth of the far plane", "a", 0, 0, false, "100", "cleared_depth", false, []],
    ["saturate", "saturate", "clamp to [0, 1], NaN to far", "a", 0, 0, false, "100", "none", false, ["cleared_depth"]],
    ["correct_quotient", "correct_quotient", "a quotient of whole numbers, from one at most one off", "a", 0, 0, false, "100", "none", false, []],
    ["floor_divide", "floor_divide", "whole numbers divided and rounded down, whatever the division's error", "a", 0, 0, false, "100", "none", false, ["correct_quotient"]],
    ["to_unorm", "to_unorm", "channel 0..255 to the value an 8-bit target stores as it", "a", 0, 0, false, "100", "none", false, []],
    ["to_unorm10", "to_unorm10", "channel 0..1023 to the value a 10-bit target stores as it", "a", 0, 0, false, "100", "none", false, []],
    ["from_unorm10", "from_unorm10", "value read from a 10-bit texture to channel 0..1023", "a", 0, 0, false, "100", "none", false, []],
    ["to_unorm16", "to_unorm16", "channel 0..65535 to the value a 16-bit target stores as it", "a", 0, 0, false, "100", "none", false, []],
    ["from_unorm16", "from_unorm16", "value read from a 16-bit texture to channel 0..65535", "a", 0, 0, false, "100", "none", false, []],
    ["encode_rg9", "encode_rg9", "depth to two channels, R the low byte", "a", 0, 0, false, "100", "none", false, ["saturate"]],
    ["encode_rg10", "encode_rg10", "depth to two channels, R the low byte", "a", 0, 0, false, "100", "none", false, ["saturate"]],
    ["encode_rg11", "encode_rg11", "depth to two channels, R the low byte", "a", 0, 0, false, "100", "none", false, ["saturate"]],
    ["encode_rg12", "encode_rg12", "depth to two channels, R the low byte", "a", 0, 0, false, "100", "none", false, ["saturate"]],
    ["encode_rg13", "encode_rg13", "depth to two channels, R the low byte", "a", 0, 0, false, "100", "none", false, ["saturate"]],
    ["encode_rg14", "encode_rg14", "depth to two channels, R the low byte", "a", 0, 0, false, "100", "none", false, ["saturate"]],
    ["encode_rg15", "encode_rg15", "depth to two channels, R the low byte", "a", 0, 0, false, "100", "none", false, ["saturate"]],
    ["encode_rg16", "encode_rg16", "depth to two channels, R the low byte", "a", 0, 0, false, "100", "none", false, ["saturate"]],
    ["encode_rgb24", "encode_rgb24", "depth to three channels, R most significant", "a", 0, 0, false, "100", "none", false, ["saturate"]],
    ["encode_rgb10", "encode_rgb10", "depth to three 10-bit channels, R most significant", "a", 0, 0, false, "100", "none", false, ["saturate"]],
    ["encode_r16", "encode_r16", "depth to one channel of 16 bits", "a", 0, 0, false, "100", "none", false, ["saturate"]],
    ["encode_float_bits", "encode_float_bits", "any float's bit pattern to four channels, R least significant", "a", 0, 0, false, "300 es", "none", false, []],
    ["write_threejs_rgba", "write_threejs_rgba", "depth to three.js RGBA, r167 and later", "b", 5, 0, false, "100", "none", false, ["saturate"]],
    ["write_threejs_rgb", "write_threejs_rgb", "depth to three.js RGB, r167 and later", "b", 3, 0, false, "100", "none", false, ["saturate"]],
    ["write_threejs_rg", "write_threejs_rg", "depth to three.js RG, r167 and later", "b", 1, 0, false, "100", "none", false, ["saturate"]],
    ["write_threejs_legacy", "write_threejs_legacy", "depth to three.js RGBA, r73 to r166", "b", 7, 0, false, "100", "none", false, ["saturate"]],
    ["encode_threejs_legacy_repaired", "encode_threejs_legacy_repaired", "depth for readers of three.js RGBA, r73 to r166, 1.0 repaired", "a", 0, 0, false, "100", "none", false, ["saturate"]],
    ["write_base255", "write_base255", "depth to the base-255 RGBA format of Cesium, Babylon.js, bgfx", "b", 6, 0, false, "100", "none", false, ["saturate"]],
    ["encode_base255_repaired", "encode_base255_repaired", "depth for readers of base-255 RGBA, 1.0 and truncation repaired", "b", 7, 0, false, "100", "none", false, ["saturate"]],
    ["fetch_clamped", "fetch_clamped", "texel of a map, outside the nearest one inside", "a", 0, 0, false, "100", "none", false, ["texel"]],
    ["encode_rg9_table", "encode_rg9_table", "depth to two channels through a look-up texture", "a", 0, 0, false, "100", "none", false, ["saturate", "from_unorm", "fetch_clamped"]],
    ["encode_rg10_table", "encode_rg10_table", "depth to two channels through a look-up texture", "a", 0, 0, false, "100", "none", false, ["saturate", "from_unorm", "fetch_clamped"]],
    ["encode_rg11_table", "encode_rg11_table", "depth to two channels through a look-up texture", "a", 0, 0, false, "100", "none", false, ["saturate", "from_unorm", "fetch_clamped"]],
    ["encode_rg12_table", "encode_rg12_table", "depth to two channels through a look-up texture", "a", 0, 0, false, "100", "none", false, ["saturate", "from_unorm", "fetch_clamped"]],
    ["encode_rg13_table", "encode_rg13_table", "depth to two channels through a look-up texture", "a", 0, 0, false, "100", "none", false, ["saturate", "from_unorm", "fetch_clamped"]],
    ["encode_rg14_table", "encode_rg14_table", "depth to two channels through a look-up texture", "a", 0, 0, false, "100", "none", false, ["saturate", "from_unorm", "fetch_clamped"]],
    ["encode_rg15_table", "encode_rg15_table", "depth to two channels through a look-up texture", "a", 0, 0, false, "100", "none", false, ["saturate", "from_unorm", "fetch_clamped"]],
    ["encode_rg16_table", "encode_rg16_table", "depth to two channels through a look-up texture", "a", 0, 0, false, "100", "none", false, ["saturate", "from_unorm", "fetch_clamped"]],
    ["decode_rg9", "decode_rg9", "two channels, R the low byte, to depth", "a", 0, 0, false, "100", "none", false, ["from_unorm"]],
    ["decode_rg10", "decode_rg10", "two channels, R the low byte, to depth", "a", 0, 0, false, "100", "none", false, ["from_unorm"]],
    ["decode_rg11", "decode_rg11", "two channels, R the low byte, to depth", "a", 0, 0, false, "100", "none", false, ["from_unorm"]],
    ["decode_rg12", "decode_rg12", "two channels, R the low byte, to depth", "a", 0, 0, false, "100", "none", false, ["from_unorm"]],
    ["decode_rg13", "decode_rg13", "two channels, R the low byte, to depth", "a", 0, 0, false, "100", "none", false, ["from_unorm"]],
    ["decode_rg14", "decode_rg14", "two channels, R the low byte, to depth", "a", 0, 0, false, "100", "none", false, ["from_unorm"]],
    ["decode_rg15", "decode_rg15", "two channels, R the low byte, to depth", "a", 0, 0, false, "100", "none", false, ["from_unorm"]],
    ["decode_rg16", "decode_rg16", "two channels, R the low byte, to depth", "a", 0, 0, false, "100", "none", false, ["from_unorm"]],
    ["decode_rgb24", "decode_rgb24", "three channels, R most significant, to depth", "a", 0, 0, false, "100", "none", false, ["from_unorm"]],
    ["decode_rgb10", "decode_rgb10", "three 10-bit channels, R most significant, to depth", "a", 0, 0, false, "100", "none", false, ["from_unorm10"]],
    ["decode_r16", "decode_r16", "one channel of 16 bits to depth", "a", 0, 0, false, "100", "none", false, ["from_unorm16"]],
    ["decode_float_bits", "decode_float_bits", "four channels, R least significant, to the float they are", "a", 0, 0, false, "300 es", "none", false, ["saturate"]],
    ["decode_threejs_rgba", "decode_threejs_rgba", "three.js RGBA, r167 and later, to depth", "b", 7, 0, false, "100", "none", false, []],
    ["decode_threejs_rgb", "decode_threejs_rgb", "three.js RGB, r167 and later, to depth", "b", 5, 0, false, "100", "none", false, []],
    ["decode_threejs_rg", "decode_threejs_rg", "three.js RG, r167 and later, to depth", "b", 3, 0, false, "100", "none", false, []],
    ["decode_threejs_legacy", "decode_threejs_legacy", "three.js RGBA, r73 to r166, to depth", "b", 7, 0, false, "100", "none", false, []],
    ["decode_base255", "decode_base255", "base-255 RGBA to depth", "b", 6, 0, false, "100", "none", false, []],
    ["level_rg9", "level_rg9", "two channels to a level to compare with", "b", 4, 0, false, "100", "none", true, []],
    ["level_rg10", "level_rg10", "two channels to a level to compare with", "b", 4, 0, false, "100", "none", true, []],
    ["level_rg11", "level_rg11", "two channels to a level to compare with", "b", 4, 0, false, "100", "none", true, []],
    ["level_rg12", "level_rg12", "two channels to a level to compare with", "b", 4, 0, false, "100", "none", true, []],
    ["level_rg13", "level_rg13", "two channels to a level to compare with", "b", 4, 0, false, "100", "none", true, []],
    ["level_rg14", "level_rg14", "two channels to a level to compare with", "b", 4, 0, false, "100", "none", true, []],
    ["level_rg15", "level_rg15", "two channels to a level to compare with", "b", 4, 0, false, "100", "none", true, []],
    ["level_rg16", "level_rg16", "two channels to a level to compare with", "b", 4, 0, false, "100", "none", true, []],
    ["receiver_rg9", "receiver_rg9", "receiver to a level, for maps that are not decoded", "b", 2, 0, false, "100", "none", false, []],
    ["receiver_rg10", "receiver_rg10", "receiver to a level, for maps that are not decoded", "b", 2, 0, false, "100", "none", false, []],
    ["receiver_rg11", "receiver_rg11", "receiver to a level, for maps that are not decoded", "b", 2, 0, false, "100", "none", false, []],
    ["receiver_rg12", "receiver_rg12", "receiver to a level, for maps that are not decoded", "b", 2, 0, false, "100", "none", false, []],
    ["receiver_rg13", "receiver_rg13", "receiver to a level, for maps that are not decoded", "b", 2, 0, false, "100", "none", false, []],
    ["receiver_rg14", "receiver_rg14", "receiver to a level, for maps that are not decoded", "b", 2, 0, false, "100", "none", false, []],
    ["receiver_rg15", "receiver_rg15", "receiver to a level, for maps that are not decoded", "b", 2, 0, false, "100", "none", false, []],
    ["receiver_rg16", "receiver_rg16", "receiver to a level, for maps that are not decoded", "b", 2, 0, false, "100", "none", false, []],
    ["decode_ps14", "decode_ps14", "r / 8 + g as the Radeon 8500 computed it", "b", 4, 0, false, "100", "none", true, []],
    ["receiver_ps14", "receiver_ps14", "receiver on the scale of decode_ps14", "b", 1, 0, false, "100", "none", false, []],
    ["inside_map", "inside_map", "whether a texel is one of the map's", "a", 0, 0, false, "100", "none", false, []],
    ["fetch_bordered", "fetch_bordered", "texel of a map, outside a border value", "a", 0, 0, false, "100", "none", false, ["texel"]],
    ["fetch_depth", "fetch_depth", "stored depth of a texel", "a", 0, 0, false, "100", "fetch_depth", false, ["texel"]],
    ["depth_at", "depth_at", "stored depth at a point of the map", "c", 4, 0, false, "100", "depth_at", false, ["fetch_depth"]],
    ["beyond_far_plane", "beyond_far_plane", "receivers behind the far plane", "a", 0, 0, false, "100", "beyond_far_plane", false, []],
    ["in_filter_domain", "in_filter_domain", "receivers that a filter compares; it takes the others as lit", "a", 0, 0, false, "100", "none", false, ["inside_texel_space", "beyond_far_plane"]],
    ["compare", "compare", "one comparison", "a", 0, 0, false, "100", "compare", false, []],
    ["lit", "lit", "one comparison with a texel", "a", 0, 0, false, "100", "lit", false, ["compare", "fetch_depth"]],
    ["lit_2x2", "lit_2x2", "comparisons with the 2x2 texels from one on", "a", 0, 0, false, "100", "lit_2x2", false, ["lit"]],
    ["map_covers", "map_covers", "whether a receiver of a prefiltered map lies in it", "a", 0, 0, false, "100", "map_covers", false, []],
    ["within_far_plane", "within_far_plane", "receivers up to the far plane, NaN is none", "a", 0, 0, false, "100", "within_far_plane", false, []],
    ["compare_dx_sdk", "compare_dx_sdk", "stored + epsilon < receiver is shadow", "b", 1, 0, false, "100", "none", false, []],
    ["compare_exercise", "compare_exercise", "current < stored + epsilon is lit", "b", 1, 0, false, "100", "none", false, []],
    ["window_sum3", "window_sum3", "weighted count of lit texels under a window of 3 x 3", "a", 0, 0, false, "100", "none", false, ["in_filter_domain", "lit_2x2"]],
    ["window_sum5", "window_sum5", "weighted count of lit texels under a window of 5 x 5", "a", 0, 0, false, "100", "none", false, ["in_filter_domain", "lit_2x2"]],
    ["window_sum7", "window_sum7", "weighted count of lit texels under a window of 7 x 7", "a", 0, 0, false, "100", "none", false, ["in_filter_domain", "lit_2x2"]],
    ["disc_rotation", "disc_rotation", "one of 16 turns for a pixel", "a", 0, 0, false, "100", "none", false, ["inside_texel_space"]],
    ["disc_tap", "disc_tap", "the texel that a point of a disc falls on", "a", 0, 0, false, "100", "none", false, []],
    ["disc_radius", "disc_radius", "radius of a disc, down to 1/16 texel", "a", 0, 0, false, "100", "none", false, []],
    ["disc8", "disc8", "disc of 8 points, turned by the pixel", "a", 0, 0, false, "100", "none", false, ["in_filter_domain", "disc_radius", "disc_tap", "lit"]],
    ["disc16", "disc16", "disc of 16 points, turned by the pixel", "a", 0, 0, false, "100", "none", false, ["in_filter_domain", "disc_radius", "disc_tap", "lit"]],
    ["disc32", "disc32", "disc of 32 points, turned by the pixel", "a", 0, 0, false, "100", "none", false, ["in_filter_domain", "disc_radius", "disc_tap", "lit"]],
    ["hard", "hard", "nearest texel, one test", "a", 0, 0, false, "100", "none", false, ["in_filter_domain", "lit"]],
    ["four_tap", "four_tap", "mean of four taps with coordinates of their own", "a", 0, 0, false, "100", "none", false, ["lit", "beyond_far_plane"]],
    ["pcf_2x2", "pcf_2x2", "bilinear 2x2, weights in steps of 1/256", "a", 0, 0, false, "100", "none", false, ["in_filter_domain", "lit_2x2"]],
    ["pcf_2x2_dx_sdk", "pcf_2x2_dx_sdk", "bilinear 2x2 as the DirectX SDK sample, plain floats", "b", 20, 0, false, "100", "none", false, ["compare_dx_sdk", "in_filter_domain", "fetch_depth"]],
    ["box_count", "box_count", "lit texels in a box of radius 0..8", "a", 0, 0, false, "100", "none", false, ["in_filter_domain", "lit"]],
    ["box_scale", "box_scale", "1 / (2r+1)^2", "a", 0, 0, false, "100", "none", false, []],
    ["box", "box", "lit share of a box of radius 0..8", "b", 290, 0, false, "100", "none", false, ["box_count", "box_scale"]],
    ["tent2", "tent2", "sliding window 1 1", "a", 0, 0, false, "100", "none", false, ["in_filter_domain", "lit_2x2"]],
    ["tent3", "tent3", "sliding window 1 2 1", "a", 0, 0, false, "100", "none", false, ["window_sum3"]],
    ["quadratic_b_spline", "quadratic_b_spline", "quadratic B-spline of 3 x 3 texels", "a", 0, 0, false, "100", "none", false, ["in_filter_domain", "lit_2x2"]],
    ["binomial5", "binomial5", "sliding window 1 4 6 4 1", "a", 0, 0, false, "100", "none", false, ["window_sum5"]],
    ["castano_dyadic5", "castano_dyadic5", "sliding window 5 16 22 16 5", "a", 0, 0, false, "100", "none", false, ["window_sum5"]],
    ["castano5", "castano5", "sliding window 1 3 4 3 1", "b", 80, 0, false, "100", "none", false, ["window_sum5"]],
    ["binomial7", "binomial7", "sliding window 1 6 15 20 15 6 1", "a", 0, 0, false, "100", "none", false, ["window_sum7"]],
    ["tent7", "tent7", "sliding window 1 2 3 4 3 2 1", "a", 0, 0, false, "100", "none", false, ["window_sum7"]],
    ["castano7", "castano7", "sliding window 1 5 12 16 12 5 1", "b", 138, 0, false, "100", "none", false, ["window_sum7"]],
    ["cube_lit", "cube_lit", "one comparison with a texel of a cube", "a", 0, 0, false, "100", "none", false, ["cube_neighbor", "cube_tile", "lit"]],
    ["pcf_2x2_cube", "pcf_2x2_cube", "2 x 2 comparisons of a cube, over its edges too, bilinear weights", "c", 33, 0, false, "100", "none", false, ["in_filter_domain", "cube_lit"]],
    ["four_tap_hardware", "four_tap_hardware", "mean of four taps that a sampler of the nearest texel takes", "c", 39, 0, false, "100", "none", false, ["beyond_far_plane", "compare", "depth_at"]],
    ["lit_filtered", "lit_filtered", "comparisons around a point, weighted", "c", 0, 1 / 128, false, "100", "lit_filtered", false, ["pcf_2x2"]],
    ["lit_at", "lit_at", "comparisons around a point of the map, weighted", "c", 0, 1 / 128, false, "100", "lit_at", false, ["lit_filtered"]],
    ["pcf_2x2_hardware", "pcf_2x2_hardware", "2x2 by a comparison sampler with a linear filter", "c", 0, 1 / 128, false, "100", "none", false, ["in_filter_domain", "within_far_plane", "lit_at"]],
    ["window_hardware3", "window_hardware3", "window of 3 x 3 by 4 look-ups of a comparison sampler with a linear filter", "c", 0, 1 / 128, false, "100", "none", false, ["in_filter_domain", "within_far_plane", "lit_at"]],
    ["window_hardware5", "window_hardware5", "window of 5 x 5 by 9 of them", "c", 0, 1 / 128, false, "100", "none", false, ["in_filter_domain", "within_far_plane", "lit_at"]],
    ["window_hardware7", "window_hardware7", "window of 7 x 7 by 16 of them", "c", 0, 1 / 128, false, "100", "none", false, ["in_filter_domain", "within_far_plane", "lit_at"]],
    ["disc_hardware8", "disc_hardware8", "disc of 8 points by a comparison sampler with a linear filter", "c", 0, 1 / 128, false, "100", "none", false, ["in_filter_domain", "within_far_plane", "lit_at"]],
    ["disc_hardware16", "disc_hardware16", "disc of 16 points by one", "c", 0, 1 / 128, false, "100", "none", false, ["in_filter_domain", "within_far_plane", "lit_at"]],
    ["disc_hardware32", "disc_hardware32", "disc of 32 points by one", "c", 0, 1 / 128, false, "100", "none", false, ["in_filter_domain", "within_far_plane", "lit_at"]],
    ["bounds_lit", "bounds_lit", "visibility where bounds of a filter's texels suffice", "a", 0, 0, false, "100", "none", false, ["in_filter_domain", "compare", "fetch_clamped"]],
    ["distance_code", "distance_code", "a depth as 16 bits of distance from the near plane", "a", 0, 0, false, "100", "none", false, ["cleared_depth"]],
    ["penumbra", "penumbra", "radius of a penumbra from the distance between blocker and receiver", "a", 0, 0, false, "100", "none", false, []],
    ["blocker", "blocker", "whether a texel lies before a receiver, and how far from the light", "a", 0, 0, false, "100", "none", false, ["fetch_depth", "compare", "distance_code"]],
    ["blockers8", "blockers8", "texels under a disc's points that lie before a receiver", "a", 0, 0, false, "100", "none", false, ["disc_tap", "blocker"]],
    ["blockers16", "blockers16", "texels under a disc's points that lie before a receiver", "a", 0, 0, false, "100", "none", false, ["disc_tap", "blocker"]],
    ["blockers32", "blockers32", "texels under a disc's points that lie before a receiver", "a", 0, 0, false, "100", "none", false, ["disc_tap", "blocker"]],
    ["pcss8", "pcss8", "percentage-closer soft shadows, 8 points twice", "a", 0, 0, false, "100", "none", false, ["in_filter_domain", "distance_code", "penumbra", "blockers8", "floor_divide", "disc8"]],
    ["pcss16", "pcss16", "percentage-closer soft shadows, 16 points twice", "a", 0, 0, false, "100", "none", false, ["in_filter_domain", "distance_code", "penumbra", "blockers16", "floor_divide", "disc16"]],
    ["pcss32", "pcss32", "percentage-closer soft shadows, 32 points twice", "a", 0, 0, false, "100", "none", false, ["in_filter_domain", "distance_code", "penumbra", "blockers32", "floor_divide", "disc32"]],
    ["blocker_at", "blocker_at", "whether what a point of the map holds lies before a receiver, and its depth", "c", 4, 0, false, "100", "none", false, ["depth_at", "compare"]],
    ["pcss_radius", "pcss_radius", "radius of a penumbra from the mean depth of blockers", "c", 0, 1 / 1024, false, "100", "none", false, ["cleared_depth"]],
    ["blockers_hardware8", "blockers_hardware8", "what lies before a receiver at 8 points of a disc, by a sampler of the nearest texel", "c", 24, 0, false, "100", "none", false, ["in_filter_domain", "blocker_at"]],
    ["blockers_hardware16", "blockers_hardware16", "the same at 16 points", "c", 24, 0, false, "100", "none", false, ["in_filter_domain", "blocker_at"]],
    ["blockers_hardware32", "blockers_hardware32", "the same at 32 points", "c", 24, 0, false, "100", "none", false, ["in_filter_domain", "blocker_at"]],
    ["hardened_kernel8", "hardened_kernel8", "a disc's share in shadow, steepened", "a", 0, 0, false, "100", "none", false, []],
    ["hardened_kernel16", "hardened_kernel16", "a disc's share in shadow, steepened", "a", 0, 0, false, "100", "none", false, []],
    ["hardened_kernel32", "hardened_kernel32", "a disc's share in shadow, steepened", "a", 0, 0, false, "100", "none", false, []],
    ["dpcf8", "dpcf8", "contact hardening by 8 points", "a", 0, 0, false, "100", "none", false, ["in_filter_domain", "distance_code", "penumbra", "blockers8", "floor_divide", "hardened_kernel8"]],
    ["dpcf16", "dpcf16", "contact hardening by 16 points", "a", 0, 0, false, "100", "none", false, ["in_filter_domain", "distance_code", "penumbra", "blockers16", "floor_divide", "hardened_kernel16"]],
    ["dpcf32", "dpcf32", "contact hardening by 32 points", "a", 0, 0, false, "100", "none", false, ["in_filter_domain", "distance_code", "penumbra", "blockers32", "floor_divide", "hardened_kernel32"]],
    ["box_moments", "box_moments", "mean and squared distances from it over a box, from a summed-area table", "a", 0, 0, false, "100", "none", false, ["texel", "floor_divide"]],
    ["summed_variance", "summed_variance", "variance shadow over a box of any size, from a summed-area table", "c", 0, 1 / 65536, false, "100", "none", false, ["in_filter_domain", "map_covers", "cleared_depth", "box_moments"]],
    ["box_mean", "box_mean", "mean of four whole numbers over a box, from a summed-area table in two halves", "c", 19, 0, false, "100", "none", false, ["texel"]],
    ["from_optimized_moments", "from_optimized_moments", "four channels of 16 bits to four moments", "b", 5, 0, false, "100", "none", false, []],
    ["bias_moments", "bias_moments", "four moments, moved a little towards those of spread depths", "b", 3, 0, false, "100", "none", false, []],
    ["to_forward_depth", "to_forward_depth", "depth that grows with distance", "b", 1, 0, false, "100", "none", false, ["cleared_depth"]],
    ["moment_atoms", "moment_atoms", "the two depths that make four moments beside a receiver's", "c", 0, 1 / 64, true, "100", "none", false, []],
    ["decode_msm", "decode_msm", "mean of four moments to visibility", "c", 0, 1 / 64, true, "100", "none", false, ["bias_moments", "to_forward_depth", "moment_atoms"]],
    ["summed_moments", "summed_moments", "moment shadow over a box of any size, from a summed-area table", "c", 0, 1 / 64, true, "100", "none", false, ["in_filter_domain", "map_covers", "box_mean", "from_optimized_moments", "decode_msm"]],
    ["power_of_two", "power_of_two", "2^n of whole numbers -64 to 63", "a", 0, 0, false, "100", "none", false, []],
    ["exp2_polynomial", "exp2_polynomial", "2^y to 1.8e-7 of it", "b", 16, 0, false, "100", "none", false, ["power_of_two"]],
    ["exp2_steps", "exp2_steps", "2^y in steps of 12 bits", "a", 0, 0, false, "100", "none", false, ["power_of_two"]],
    ["chebyshev", "chebyshev", "most that mean and variance let be lit", "c", 11, 0, false, "100", "none", false, []],
    ["reduce_light_bleeding", "reduce_light_bleeding", "visibility without its least values", "c", 5, 0, false, "100", "none", false, []],
    ["encode_vsm", "encode_vsm", "depth to a texel of a variance shadow map", "b", 3, 0, false, "100", "none", false, ["saturate", "to_forward_depth"]],
    ["decode_vsm", "decode_vsm", "mean of texels of a variance shadow map to visibility", "c", 13, 0, false, "100", "none", false, ["chebyshev", "to_forward_depth"]],
    ["encode_deviation", "encode_deviation", "depth's two moments to mean and deviation", "c", 7, 0, false, "100", "none", false, []],
    ["decode_deviation", "decode_deviation", "mean and deviation to depth's two moments", "b", 5, 0, false, "100", "none", false, []],
    ["decode_deviation_rgba8", "decode_deviation_rgba8", "mean and deviation in four channels to depth's two moments", "b", 21, 0, false, "100", "none", false, ["decode_deviation", "decode_rg16"]],
    ["exponential_warp", "exponential_warp", "depth on the scale of exponential shadow maps", "b", 31, 0, false, "100", "none", false, ["exp2_polynomial"]],
    ["encode_esm", "encode_esm", "depth to a texel of an exponential shadow map", "b", 36, 0, false, "100", "none", false, ["saturate", "to_forward_depth", "exponential_warp"]],
    ["decode_esm", "decode_esm", "mean of texels of an exponential shadow map to visibility", "b", 37, 0, false, "100", "none", false, ["to_forward_depth", "exponential_warp"]],
    ["encode_evsm2", "encode_evsm2", "depth to a texel of two components", "b", 73, 0, false, "100", "none", false, ["saturate", "to_forward_depth", "exponential_warp"]],
    ["encode_evsm4", "encode_evsm4", "depth to a texel of four components", "b", 73, 0, false, "100", "none", false, ["saturate", "to_forward_depth", "exponential_warp"]],
    ["decode_evsm2", "decode_evsm2", "mean of texels of two components to visibility", "c", 229, 0, false, "100", "none", false, ["chebyshev", "to_forward_depth", "saturate", "exponential_warp"]],
    ["decode_evsm4", "decode_evsm4", "mean of texels of four components to visibility", "c", 229, 0, false, "100", "none", false, ["chebyshev", "to_forward_depth", "saturate", "exponential_warp"]],
    ["encode_msm", "encode_msm", "depth to its first four powers on [-1, 1]", "b", 15, 0, false, "100", "none", false, ["saturate", "to_forward_depth"]],
    ["to_optimized_moments", "to_optimized_moments", "four moments to four channels of 16 bits", "b", 4, 0, false, "100", "none", false, []],
    ["hausdorff_share", "hausdorff_share", "least share of depths before a receiver, of depths on [-1, 1]", "c", 0, 1 / 1048576, true, "100", "none", false, []],
    ["decode_msm_hausdorff", "decode_msm_hausdorff", "mean of four moments of depths on [-1, 1] to visibility", "c", 0, 1 / 64, true, "100", "none", false, ["bias_moments", "decode_msm", "to_forward_depth", "hausdorff_share"]],
    ["fetch_bilinear", "fetch_bilinear", "mean of the four texels around a point", "b", 19, 0, false, "100", "none", false, ["fetch_clamped"]],
    ["vsm", "vsm", "visibility from a map of encode_vsm's texels", "c", 165, 0, false, "100", "none", false, ["in_filter_domain", "map_covers", "fetch_bilinear", "decode_vsm"]],
    ["esm", "esm", "visibility from a map of encode_esm's texels", "b", 56, 0, false, "100", "none", false, ["in_filter_domain", "map_covers", "fetch_bilinear", "decode_esm"]],
    ["evsm2", "evsm2", "visibility from a map of encode_evsm2's texels", "c", 267, 0, false, "100", "none", false, ["in_filter_domain", "map_covers", "fetch_bilinear", "decode_evsm2"]],
    ["evsm4", "evsm4", "visibility from a map of encode_evsm4's texels", "c", 267, 0, false, "100", "none", false, ["in_filter_domain", "map_covers", "fetch_bilinear", "decode_evsm4"]],
    ["msm", "msm", "visibility from a map of encode_msm's texels", "c", 0, 1 / 64, true, "100", "none", false, ["in_filter_domain", "map_covers", "fetch_bilinear", "decode_msm"]],
    ["msm_unorm16", "msm_unorm16", "visibility from a map of turned moments", "c", 0, 1 / 64, true, "100", "none", false, ["in_filter_domain", "map_covers", "fetch_bilinear", "decode_msm", "from_optimized_moments"]],
    ["msm_hausdorff", "msm_hausdorff", "visibility from a map of encode_msm's texels", "c", 0, 1 / 64, true, "100", "none", false, ["in_filter_domain", "map_covers", "fetch_bilinear", "decode_msm_hausdorff"]],
    ["chebyshev_hardware", "chebyshev_hardware", "most that a variance lets be lit, less the light that bleeds", "c", 0, 1 / 524288, false, "100", "none", false, []],
    ["decode_vsm_hardware", "decode_vsm_hardware", "mean and deviation to visibility, the cheapest way", "c", 0, 1 / 1024, false, "100", "none", false, ["chebyshev_hardware", "to_forward_depth"]],
    ["decode_evsm2_hardware", "decode_evsm2_hardware", "mean of texels of two components to visibility, by the GPU's own exp2", "c", 0, 1 / 64, false, "100", "none", false, ["chebyshev_hardware", "to_forward_depth"]],
    ["decode_evsm4_hardware", "decode_evsm4_hardware", "mean of texels of four components to visibility, by the GPU's own exp2", "c", 0, 1 / 64, false, "100", "none", false, ["chebyshev_hardware", "to_forward_depth"]],
    ["blur_row3", "blur_row3", "mean of texels in a row", "b", 7, 0, false, "100", "none", false, ["fetch_clamped"]],
    ["blur_row5", "blur_row5", "mean of texels in a row", "b", 12, 0, false, "100", "none", false, ["fetch_clamped"]],
    ["blur_row7", "blur_row7", "mean of texels in a row", "b", 17, 0, false, "100", "none", false, ["fetch_clamped"]],
    ["halve_texels", "halve_texels", "mean of 2x2 texels", "b", 8, 0, false, "100", "none", false, ["fetch_clamped"]],
    ["texels_to_world", "texels_to_world", "texels across a light as world units", "b", 2, 0, false, "100", "none", false, []],
    ["clamp_bias", "clamp_bias", "clamp of a bias to [0, 1], NaN to 1", "a", 0, 0, false, "100", "none", false, []],
    ["world_to_depth", "world_to_depth", "world units along a light as depth", "c", 5, 0, false, "100", "none", false, ["clamp_bias"]],
    ["biased", "biased", "receiver moved towards the light", "b", 1, 0, false, "100", "none", false, ["cleared_depth"]],
    ["clamp_slope", "clamp_slope", "clamp of a slope to [-2, 2], NaN to 2", "a", 0, 0, false, "100", "none", false, []],
    ["plane_slope", "plane_slope", "change of a plane's depth from texel to texel", "c", 27, 0, false, "100", "none", false, ["clamp_slope"]],
    ["receiver_slope", "receiver_slope", "change of a receiver's depth from texel to texel", "c", 27, 0, false, "100", "none", false, ["plane_slope"]],
    ["cascade_slope", "cascade_slope", "change of a plane's depth from texel to texel of a cascade", "c", 6, 0, false, "100", "none", false, ["clamp_slope"]],
    ["slope_bias", "slope_bias", "bias by the greater slope, as rasterizers have it", "b", 2, 0, false, "100", "none", false, ["clamp_bias"]],
    ["dual_paraboloid_slope", "dual_paraboloid_slope", "change of distance from texel to texel of a paraboloid's map", "c", 41, 0, false, "100", "none", false, ["clamp_slope"]],
    ["normal_offset", "normal_offset", "way off a surface to the point that is looked up in its place", "c", 91, 0, false, "100", "none", false, []],
    ["kernel_bias", "kernel_bias", "bias by the kernel's width and the angle at which light falls", "c", 30, 0, false, "100", "none", false, []],
    ["receiver_plane_slope", "receiver_plane_slope", "slope of a receiver's plane from derivatives, and how far it may be off", "c", 31, 0, false, "100", "none", false, ["clamp_slope"]],
    ["apply_receiver_plane", "apply_receiver_plane", "stored depth moved along the receiver's plane to the receiver", "b", 8, 0, false, "100", "none", false, ["cleared_depth"]],
    ["acne_free_bias", "acne_free_bias", "smallest bias without acne, for a slope, a reach and an encoding's error", "b", 4, 0, false, "100", "none", false, ["clamp_bias"]],
    ["acne_free_disc_bias", "acne_free_disc_bias", "smallest bias without acne, for filters that read a disc", "c", 13, 0, false, "100", "none", false, ["clamp_bias"]],
    ["peter_panning_distance", "peter_panning_distance", "depth before a receiver within which its bias loses a caster's shadow", "b", 4, 0, false, "100", "none", false, ["acne_free_bias"]],
    ["spot_cone", "spot_cone", "1 inside a spot light's cone", "b", 11, 0, false, "100", "none", false, []],
    ["diffuse_ambient", "diffuse_ambient", "diffuse plus ambient light of a surface", "b", 5, 0, false, "100", "none", false, []],
    ["false_color", "false_color", "0..1 to blue, green, red", "b", 3, 0, false, "100", "none", false, ["saturate"]],
    ["overlay_texel", "overlay_texel", "which texel of a map stretched over the picture's corner a pixel shows, along one side", "a", 0, 0, false, "100", "none", false, []],
    ["probe_color", "probe_color", "debug color of a place in a map: its texels, or why it cannot be shadowed", "a", 0, 0, false, "100", "none", false, ["cleared_depth"]],
    ["probe_inputs", "probe_inputs", "debug color, unless position or normal are wrong", "a", 0, 0, false, "100", "none", false, []],
    ["hooks/cleared_depth, reversed", "cleared_depth", "cleared_depth, reversed", "a", 0, 0, false, "100", "chosen", false, []],
    ["hooks/map_covers, clamped", "map_covers", "map_covers, clamped", "a", 0, 0, false, "100", "chosen", false, []],
    ["hooks/beyond_far_plane, reversed", "beyond_far_plane", "beyond_far_plane, reversed", "a", 0, 0, false, "100", "chosen", false, []],
    ["hooks/beyond_far_plane, without", "beyond_far_plane", "beyond_far_plane, without", "a", 0, 0, false, "100", "chosen", false, []],
    ["hooks/within_far_plane, reversed", "within_far_plane", "within_far_plane, reversed", "a", 0, 0, false, "100", "chosen", false, []],
    ["hooks/within_far_plane, without", "within_far_plane", "within_far_plane, without", "a", 0, 0, false, "100", "chosen", false, []],
    ["hooks/compare, reversed", "compare", "compare, reversed", "a", 0, 0, false, "100", "chosen", false, []],
    ["hooks/compare, own", "compare", "compare, own", "a", 0, 0, false, "100", "chosen", false, []],
    ["hooks/decode", "decode", "decode", "a", 0, 0, false, "100", "chosen", false, []],
    ["hooks/fetch_depth, clamped", "fetch_depth", "fetch_depth, clamped", "a", 0, 0, false, "100", "chosen", false, ["fetch_clamped"]],
    ["hooks/lit_texel", "lit_texel", "lit_texel", "a", 0, 0, false, "100", "chosen", false, []],
    ["hooks/lit, clamped", "lit", "lit, clamped", "a", 0, 0, false, "100", "chosen", false, ["hooks/lit_texel"]],
    ["hooks/lit, bordered", "lit", "lit, bordered", "a", 0, 0, false, "100", "chosen", false, ["hooks/lit_texel", "compare"]],
    ["hooks/gather_lit, compared", "gather_lit", "gather_lit, compared", "a", 0, 0, false, "100", "gather_lit", false, []],
    ["hooks/gather_lit, one channel", "gather_lit", "gather_lit, one channel", "a", 0, 0, false, "100", "chosen", false, ["hooks/decode", "compare"]],
    ["hooks/gather_lit, two channels", "gather_lit", "gather_lit, two channels", "a", 0, 0, false, "100", "chosen", false, ["hooks/decode", "compare"]],
    ["hooks/lit_2x2, gathered", "lit_2x2", "lit_2x2, gathered", "a", 0, 0, false, "100", "chosen", false, ["hooks/gather_lit, compared"]],
    ["hooks/lit_2x2, gathered in a region", "lit_2x2", "lit_2x2, gathered in a region", "a", 0, 0, false, "100", "chosen", false, ["hooks/gather_lit, compared"]],
    ["hooks/lit_2x2, gathered and bordered", "lit_2x2", "lit_2x2, gathered and bordered", "a", 0, 0, false, "100", "chosen", false, ["hooks/gather_lit, compared", "inside_map", "compare"]],
    ["hooks/lit_2x2, gathered in a bordered region", "lit_2x2", "lit_2x2, gathered in a bordered region", "a", 0, 0, false, "100", "chosen", false, ["hooks/gather_lit, compared", "inside_map", "compare"]],
    ["hooks/lit_filtered, clamped", "lit_filtered", "lit_filtered, clamped", "c", 0, 1 / 128, false, "100", "chosen", false, ["within_far_plane"]],
    ["hooks/lit_filtered, bordered", "lit_filtered", "lit_filtered, bordered", "c", 0, 1 / 128, false, "100", "chosen", false, ["within_far_plane", "compare"]],
    ["hooks/lit_at, sampled", "lit_at", "lit_at, sampled", "c", 0, 1 / 128, false, "100", "chosen", false, []],
    ["hooks/lit_at, sampled and bordered", "lit_at", "lit_at, sampled and bordered", "c", 0, 1 / 128, false, "100", "chosen", false, ["compare"]],
    ["hooks/depth_at, sampled", "depth_at", "depth_at, sampled", "c", 4, 0, false, "100", "chosen", false, ["hooks/decode"]],
    ["hooks/depth_at, sampled and bordered", "depth_at", "depth_at, sampled and bordered", "c", 4, 0, false, "100", "chosen", false, ["hooks/decode"]],
];
const all = new Map(rows.map(([id, name, summary, exactness, operations, within, as_written, lowest, role, scaled]) =>
    [id, { id, name, summary, exactness, operations, within, as_written, lowest, role, scaled, needs: [] }]));
for (const [id, , , , , , , , , , needs] of rows) all.get(id).needs.push(...needs.map(need => all.get(need)));
const part = variants => Object.fromEntries([...all]
    .filter(([id]) => id.startsWith('hooks/') === variants).map(([id, s]) => [id.replace('hooks/', ''), s]));
const hooks = part(true);
const snippets = part(false);
const encodings = {
    depth32f: { direction: "forward", depth: "", channels: 1, needs: [],
        writer: snippets.saturate, writes: "depth", format: "R32F", cleared: [1, 0, 0, 0],
        reversed: { direction: "reversed", depth: "", channels: 1, needs: [],
        writer: snippets.saturate, writes: "depth", format: "R32F", cleared: [0, 0, 0, 0] } },
    rg9: { direction: "forward", depth: "umbrage_decode_rg9(value.xy, 1.0)", channels: 2, needs: [snippets.decode_rg9],
        writer: snippets.encode_rg9, writes: "integers", format: "RG8", to_unorm: snippets.to_unorm, cleared: [255 / 255, 128 / 255, 0, 0],
        reversed: { direction: "reversed", depth: "umbrage_decode_rg9(value.xy, 0.0)", channels: 2, needs: [snippets.decode_rg9],
        writer: snippets.encode_rg9, writes: "integers", format: "RG8", to_unorm: snippets.to_unorm, cleared: [0 / 255, 0 / 255, 0, 0] } },
    rg10: { direction: "forward", depth: "umbrage_decode_rg10(value.xy, 1.0)", channels: 2, needs: [snippets.decode_rg10],
        writer: snippets.encode_rg10, writes: "integers", format: "RG8", to_unorm: snippets.to_unorm, cleared: [255 / 255, 192 / 255, 0, 0],
        reversed: { direction: "reversed", depth: "umbrage_decode_rg10(value.xy, 0.0)", channels: 2, needs: [snippets.decode_rg10],
        writer: snippets.encode_rg10, writes: "integers", format: "RG8", to_unorm: snippets.to_unorm, cleared: [0 / 255, 0 / 255, 0, 0] } },
    rg11: { direction: "forward", depth: "umbrage_decode_rg11(value.xy, 1.0)", channels: 2, needs: [snippets.decode_rg11],
        writer: snippets.encode_rg11, writes: "integers", format: "RG8", to_unorm: snippets.to_unorm, cleared: [255 / 255, 224 / 255, 0, 0],
        reversed: { direction: "reversed", depth: "umbrage_decode_rg11(value.xy, 0.0)", channels: 2, needs: [snippets.decode_rg11],
        writer: snippets.encode_rg11, writes: "integers", format: "RG8", to_unorm: snippets.to_unorm, cleared: [0 / 255, 0 / 255, 0, 0] } },
    rg12: { direction: "forward", depth: "umbrage_decode_rg12(value.xy, 1.0)", channels: 2, needs: [snippets.decode_rg12],
        writer: snippets.encode_rg12, writes: "integers", format: "RG8", to_unorm: snippets.to_unorm, cleared: [255 / 255, 240 / 255, 0, 0],
        reversed: { direction: "reversed", depth: "umbrage_decode_rg12(value.xy, 0.0)", channels: 2, needs: [snippets.decode_rg12],
        writer: snippets.encode_rg12, writes: "integers", format: "RG8", to_unorm: snippets.to_unorm, cleared: [0 / 255, 0 / 255, 0, 0] } },
    rg13: { direction: "forward", depth: "umbrage_decode_rg13(value.xy, 1.0)", channels: 2, needs: [snippets.decode_rg13],
        writer: snippets.encode_rg13, writes: "integers", format: "RG8", to_unorm: snippets.to_unorm, cleared: [255 / 255, 248 / 255, 0, 0],
        reversed: { direction: "reversed", depth: "umbrage_decode_rg13(value.xy, 0.0)", channels: 2, needs: [snippets.decode_rg13],
        writer: snippets.encode_rg13, writes: "integers", format: "RG8", to_unorm: snippets.to_unorm, cleared: [0 / 255, 0 / 255, 0, 0] } },
    rg14: { direction: "forward", depth: "umbrage_decode_rg14(value.xy, 1.0)", channels: 2, needs: [snippets.decode_rg14],
        writer: snippets.encode_rg14, writes: "integers", format: "RG8", to_unorm: snippets.to_unorm, cleared: [255 / 255, 252 / 255, 0, 0],
        reversed: { direction: "reversed", depth: "umbrage_decode_rg14(value.xy, 0.0)", channels: 2, needs: [snippets.decode_rg14],
        writer: snippets.encode_rg14, writes: "integers", format: "RG8", to_unorm: snippets.to_unorm, cleared: [0 / 255, 0 / 255, 0, 0] } },
    rg15: { direction: "forward", depth: "umbrage_decode_rg15(value.xy, 1.0)", channels: 2, needs: [snippets.decode_rg15],
        writer: snippets.encode_rg15, writes: "integers", format: "RG8", to_unorm: snippets.to_unorm, cleared: [255 / 255, 254 / 255, 0, 0],
        reversed: { direction: "reversed", depth: "umbrage_decode_rg15(value.xy, 0.0)", channels: 2, needs: [snippets.decode_rg15],
        writer: snippets.encode_rg15, writes: "integers", format: "RG8", to_unorm: snippets.to_unorm, cleared: [0 / 255, 0 / 255, 0, 0] } },
    rg16: { direction: "forward", depth: "umbrage_decode_rg16(value.xy, 1.0)", channels: 2, needs: [snippets.decode_rg16],
        writer: snippets.encode_rg16, writes: "integers", format: "RG8", to_unorm: snippets.to_unorm, cleared: [255 / 255, 255 / 255, 0, 0],
        reversed: { direction: "reversed", depth: "umbrage_decode_rg16(value.xy, 0.0)", channels: 2, needs: [snippets.decode_rg16],
        writer: snippets.encode_rg16, writes: "integers", format: "RG8", to_unorm: snippets.to_unorm, cleared: [0 / 255, 0 / 255, 0, 0] } },
    rgb24: { direction: "forward", depth: "umbrage_decode_rgb24(value.xyz, 1.0)", channels: 3, needs: [snippets.decode_rgb24],
        writer: snippets.encode_rgb24, writes: "integers", format: "RGB8", to_unorm: snippets.to_unorm, cleared: [255 / 255, 255 / 255, 255 / 255, 0],
        reversed: { direction: "reversed", depth: "umbrage_decode_rgb24(value.xyz, 0.0)", channels: 3, needs: [snippets.decode_rgb24],
        writer: snippets.encode_rgb24, writes: "integers", format: "RGB8", to_unorm: snippets.to_unorm, cleared: [0 / 255, 0 / 255, 0 / 255, 0] } },
    rgb10: { direction: "forward", depth: "umbrage_decode_rgb10(value.xyz, 1.0)", channels: 3, needs: [snippets.decode_rgb10],
        writer: snippets.encode_rgb10, writes: "integers", format: "RGB10_A2", to_unorm: snippets.to_unorm10, cleared: [1023 / 1023, 1023 / 1023, 960 / 1023, 0],
        reversed: { direction: "reversed", depth: "umbrage_decode_rgb10(value.xyz, 0.0)", channels: 3, needs: [snippets.decode_rgb10],
        writer: snippets.encode_rgb10, writes: "integers", format: "RGB10_A2", to_unorm: snippets.to_unorm10, cleared: [0 / 1023, 0 / 1023, 0 / 1023, 0] } },
    r16: { direction: "forward", depth: "umbrage_decode_r16(value.x, 1.0)", channels: 1, needs: [snippets.decode_r16],
        writer: snippets.encode_r16, writes: "integers", format: "R16", to_unorm: snippets.to_unorm16, cleared: [65535 / 65535, 0, 0, 0],
        reversed: { direction: "reversed", depth: "umbrage_decode_r16(value.x, 0.0)", channels: 1, needs: [snippets.decode_r16],
        writer: snippets.encode_r16, writes: "integers", format: "R16", to_unorm: snippets.to_unorm16, cleared: [0 / 65535, 0, 0, 0] } },
    float_bits: { direction: "forward", depth: "umbrage_decode_float_bits(value.xyzw)", channels: 4, needs: [snippets.decode_float_bits],
        writer: snippets.encode_float_bits, writes: "integers", format: "RGBA8", to_unorm: snippets.to_unorm, cleared: [0 / 255, 0 / 255, 128 / 255, 63 / 255],
        reversed: { direction: "reversed", depth: "umbrage_decode_float_bits(value.xyzw)", channels: 4, needs: [snippets.decode_float_bits],
        writer: snippets.encode_float_bits, writes: "integers", format: "RGBA8", to_unorm: snippets.to_unorm, cleared: [0 / 255, 0 / 255, 0 / 255, 0 / 255] } },
    threejs_rgba: { direction: "forward", depth: "umbrage_decode_threejs_rgba(value.xyzw)", channels: 4, needs: [snippets.decode_threejs_rgba],
        writer: snippets.write_threejs_rgba, writes: "values", format: "RGBA8", cleared: [255 / 255, 255 / 255, 255 / 255, 255 / 255],
        reversed: { direction: "reversed", depth: "umbrage_decode_threejs_rgba(value.xyzw)", channels: 4, needs: [snippets.decode_threejs_rgba],
        writer: snippets.write_threejs_rgba, writes: "values", format: "RGBA8", cleared: [0 / 255, 0 / 255, 0 / 255, 0 / 255] } },
    threejs_rgb: { direction: "forward", depth: "umbrage_decode_threejs_rgb(value.xyz)", channels: 3, needs: [snippets.decode_threejs_rgb],
        writer: snippets.write_threejs_rgb, writes: "values", format: "RGB8", cleared: [255 / 255, 255 / 255, 255 / 255, 0],
        reversed: { direction: "reversed", depth: "umbrage_decode_threejs_rgb(value.xyz)", channels: 3, needs: [snippets.decode_threejs_rgb],
        writer: snippets.write_threejs_rgb, writes: "values", format: "RGB8", cleared: [0 / 255, 0 / 255, 0 / 255, 0] } },
    threejs_rg: { direction: "forward", depth: "umbrage_decode_threejs_rg(value.xy)", channels: 2, needs: [snippets.decode_threejs_rg],
        writer: snippets.write_threejs_rg, writes: "values", format: "RG8", cleared: [255 / 255, 255 / 255, 0, 0],
        reversed: { direction: "reversed", depth: "umbrage_decode_threejs_rg(value.xy)", channels: 2, needs: [snippets.decode_threejs_rg],
        writer: snippets.write_threejs_rg, writes: "values", format: "RG8", cleared: [0 / 255, 0 / 255, 0, 0] } },
    threejs_legacy: { direction: "forward", depth: "umbrage_decode_threejs_legacy(value.xyzw)", channels: 4, needs: [snippets.decode_threejs_legacy],
        writer: snippets.write_threejs_legacy, writes: "values", format: "RGBA8", cleared: [255 / 255, 255 / 255, 255 / 255, 255 / 255],
        reversed: { direction: "reversed", depth: "umbrage_decode_threejs_legacy(value.xyzw)", channels: 4, needs: [snippets.decode_threejs_legacy],
        writer: snippets.write_threejs_legacy, writes: "values", format: "RGBA8", cleared: [0 / 255, 0 / 255, 0 / 255, 0 / 255] } },
    threejs_legacy_repaired: { direction: "forward", depth: "umbrage_decode_threejs_legacy(value.xyzw)", channels: 4, needs: [snippets.decode_threejs_legacy],
        writer: snippets.encode_threejs_legacy_repaired, writes: "integers", format: "RGBA8", to_unorm: snippets.to_unorm, cleared: [255 / 255, 255 / 255, 255 / 255, 255 / 255],
        reversed: { direction: "reversed", depth: "umbrage_decode_threejs_legacy(value.xyzw)", channels: 4, needs: [snippets.decode_threejs_legacy],
        writer: snippets.encode_threejs_legacy_repaired, writes: "integers", format: "RGBA8", to_unorm: snippets.to_unorm, cleared: [0 / 255, 0 / 255, 0 / 255, 0 / 255] } },
    base255: { direction: "forward", depth: "umbrage_decode_base255(value.xyzw)", channels: 4, needs: [snippets.decode_base255],
        writer: snippets.write_base255, writes: "values", format: "RGBA8", cleared: [255 / 255, 0 / 255, 0 / 255, 0 / 255],
        reversed: { direction: "reversed", depth: "umbrage_decode_base255(value.xyzw)", channels: 4, needs: [snippets.decode_base255],
        writer: snippets.write_base255, writes: "values", format: "RGBA8", cleared: [0 / 255, 0 / 255, 0 / 255, 0 / 255] } },
    base255_repaired: { direction: "forward", depth: "umbrage_decode_base255(value.xyzw)", channels: 4, needs: [snippets.decode_base255],
        writer: snippets.encode_base255_repaired, writes: "integers", format: "RGBA8", to_unorm: snippets.to_unorm, cleared: [255 / 255, 0 / 255, 0 / 255, 0 / 255],
        reversed: { direction: "reversed", depth: "umbrage_decode_base255(value.xyzw)", channels: 4, needs: [snippets.decode_base255],
        writer: snippets.encode_base255_repaired, writes: "integers", format: "RGBA8", to_unorm: snippets.to_unorm, cleared: [0 / 255, 0 / 255, 0 / 255, 0 / 255] } },
};
const glsl = in_language('glsl');
const hlsl = in_language('hlsl');
const msl = in_language('msl');
const wgsl = in_language('wgsl');
const { shadow_coordinate, tap_coordinate, project_coordinate, cascade_by_depth, cascade_column, cascade_column_8, cascade_coordinate, inside_cascade, cascade_by_projection, cascade_by_projection_8, cascade_tile, cascade_weight, cascade_fade, cascade_border_fade, blend_cascades, inside_texel_space, dither_threshold, dithered_cascade, cube_face, cube_view_z, cube_plane, cube_point, cube_face_point, cube_coordinate, cube_direction, cube_neighbor, cube_tile, cube_atlas_texel, cube_atlas_direction, dual_paraboloid_coordinate, dual_paraboloid_position, tetrahedron_face, tetrahedron_face_point, tetrahedron_plane, tetrahedron_view_z, tetrahedron_coordinate, tetrahedron_turned, tetrahedron_texel, tetrahedron_face_of, pancake, texel, from_unorm, page_coordinate, linear_depth, project_depth, distance_depth, reverse_depth, depth_from_ndc, view_z_from_depth, depth_from_view_z, view_z_from_reversed_depth, reversed_depth_from_view_z, view_z_from_orthographic_depth, orthographic_depth_from_view_z, cleared_depth, saturate, correct_quotient, floor_divide, to_unorm, to_unorm10, from_unorm10, to_unorm16, from_unorm16, encode_rg9, encode_rg10, encode_rg11, encode_rg12, encode_rg13, encode_rg14, encode_rg15, encode_rg16, encode_rgb24, encode_rgb10, encode_r16, encode_float_bits, write_threejs_rgba, write_threejs_rgb, write_threejs_rg, write_threejs_legacy, encode_threejs_legacy_repaired, write_base255, encode_base255_repaired, fetch_clamped, encode_rg9_table, encode_rg10_table, encode_rg11_table, encode_rg12_table, encode_rg13_table, encode_rg14_table, encode_rg15_table, encode_rg16_table, decode_rg9, decode_rg10, decode_rg11, decode_rg12, decode_rg13, decode_rg14, decode_rg15, decode_rg16, decode_rgb24, decode_rgb10, decode_r16, decode_float_bits, decode_threejs_rgba, decode_threejs_rgb, decode_threejs_rg, decode_threejs_legacy, decode_base255, level_rg9, level_rg10, level_rg11, level_rg12, level_rg13, level_rg14, level_rg15, level_rg16, receiver_rg9, receiver_rg10, receiver_rg11, receiver_rg12, receiver_rg13, receiver_rg14, receiver_rg15, receiver_rg16, decode_ps14, receiver_ps14, inside_map, fetch_bordered, fetch_depth, depth_at, beyond_far_plane, in_filter_domain, compare, lit, lit_2x2, map_covers, within_far_plane, compare_dx_sdk, compare_exercise, window_sum3, window_sum5, window_sum7, disc_rotation, disc_tap, disc_radius, disc8, disc16, disc32, hard, four_tap, pcf_2x2, pcf_2x2_dx_sdk, box_count, box_scale, box, tent2, tent3, quadratic_b_spline, binomial5, castano_dyadic5, castano5, binomial7, tent7, castano7, cube_lit, pcf_2x2_cube, four_tap_hardware, lit_filtered, lit_at, pcf_2x2_hardware, window_hardware3, window_hardware5, window_hardware7, disc_hardware8, disc_hardware16, disc_hardware32, bounds_lit, distance_code, penumbra, blocker, blockers8, blockers16, blockers32, pcss8, pcss16, pcss32, blocker_at, pcss_radius, blockers_hardware8, blockers_hardware16, blockers_hardware32, hardened_kernel8, hardened_kernel16, hardened_kernel32, dpcf8, dpcf16, dpcf32, box_moments, summed_variance, box_mean, from_optimized_moments, bias_moments, to_forward_depth, moment_atoms, decode_msm, summed_moments, power_of_two, exp2_polynomial, exp2_steps, chebyshev, reduce_light_bleeding, encode_vsm, decode_vsm, encode_deviation, decode_deviation, decode_deviation_rgba8, exponential_warp, encode_esm, decode_esm, encode_evsm2, encode_evsm4, decode_evsm2, decode_evsm4, encode_msm, to_optimized_moments, hausdorff_share, decode_msm_hausdorff, fetch_bilinear, vsm, esm, evsm2, evsm4, msm, msm_unorm16, msm_hausdorff, chebyshev_hardware, decode_vsm_hardware, decode_evsm2_hardware, decode_evsm4_hardware, blur_row3, blur_row5, blur_row7, halve_texels, texels_to_world, clamp_bias, world_to_depth, biased, clamp_slope, plane_slope, receiver_slope, cascade_slope, slope_bias, dual_paraboloid_slope, normal_offset, kernel_bias, receiver_plane_slope, apply_receiver_plane, acne_free_bias, acne_free_disc_bias, peter_panning_distance, spot_cone, diffuse_ambient, false_color, overlay_texel, probe_color, probe_inputs } = snippets;

module.exports = { bind, exactness, supports, text, source, versions, snippets, encodings, glsl, hlsl, msl, wgsl, shadow_coordinate, tap_coordinate, project_coordinate, cascade_by_depth, cascade_column, cascade_column_8, cascade_coordinate, inside_cascade, cascade_by_projection, cascade_by_projection_8, cascade_tile, cascade_weight, cascade_fade, cascade_border_fade, blend_cascades, inside_texel_space, dither_threshold, dithered_cascade, cube_face, cube_view_z, cube_plane, cube_point, cube_face_point, cube_coordinate, cube_direction, cube_neighbor, cube_tile, cube_atlas_texel, cube_atlas_direction, dual_paraboloid_coordinate, dual_paraboloid_position, tetrahedron_face, tetrahedron_face_point, tetrahedron_plane, tetrahedron_view_z, tetrahedron_coordinate, tetrahedron_turned, tetrahedron_texel, tetrahedron_face_of, pancake, texel, from_unorm, page_coordinate, linear_depth, project_depth, distance_depth, reverse_depth, depth_from_ndc, view_z_from_depth, depth_from_view_z, view_z_from_reversed_depth, reversed_depth_from_view_z, view_z_from_orthographic_depth, orthographic_depth_from_view_z, cleared_depth, saturate, correct_quotient, floor_divide, to_unorm, to_unorm10, from_unorm10, to_unorm16, from_unorm16, encode_rg9, encode_rg10, encode_rg11, encode_rg12, encode_rg13, encode_rg14, encode_rg15, encode_rg16, encode_rgb24, encode_rgb10, encode_r16, encode_float_bits, write_threejs_rgba, write_threejs_rgb, write_threejs_rg, write_threejs_legacy, encode_threejs_legacy_repaired, write_base255, encode_base255_repaired, fetch_clamped, encode_rg9_table, encode_rg10_table, encode_rg11_table, encode_rg12_table, encode_rg13_table, encode_rg14_table, encode_rg15_table, encode_rg16_table, decode_rg9, decode_rg10, decode_rg11, decode_rg12, decode_rg13, decode_rg14, decode_rg15, decode_rg16, decode_rgb24, decode_rgb10, decode_r16, decode_float_bits, decode_threejs_rgba, decode_threejs_rgb, decode_threejs_rg, decode_threejs_legacy, decode_base255, level_rg9, level_rg10, level_rg11, level_rg12, level_rg13, level_rg14, level_rg15, level_rg16, receiver_rg9, receiver_rg10, receiver_rg11, receiver_rg12, receiver_rg13, receiver_rg14, receiver_rg15, receiver_rg16, decode_ps14, receiver_ps14, inside_map, fetch_bordered, fetch_depth, depth_at, beyond_far_plane, in_filter_domain, compare, lit, lit_2x2, map_covers, within_far_plane, compare_dx_sdk, compare_exercise, window_sum3, window_sum5, window_sum7, disc_rotation, disc_tap, disc_radius, disc8, disc16, disc32, hard, four_tap, pcf_2x2, pcf_2x2_dx_sdk, box_count, box_scale, box, tent2, tent3, quadratic_b_spline, binomial5, castano_dyadic5, castano5, binomial7, tent7, castano7, cube_lit, pcf_2x2_cube, four_tap_hardware, lit_filtered, lit_at, pcf_2x2_hardware, window_hardware3, window_hardware5, window_hardware7, disc_hardware8, disc_hardware16, disc_hardware32, bounds_lit, distance_code, penumbra, blocker, blockers8, blockers16, blockers32, pcss8, pcss16, pcss32, blocker_at, pcss_radius, blockers_hardware8, blockers_hardware16, blockers_hardware32, hardened_kernel8, hardened_kernel16, hardened_kernel32, dpcf8, dpcf16, dpcf32, box_moments, summed_variance, box_mean, from_optimized_moments, bias_moments, to_forward_depth, moment_atoms, decode_msm, summed_moments, power_of_two, exp2_polynomial, exp2_steps, chebyshev, reduce_light_bleeding, encode_vsm, decode_vsm, encode_deviation, decode_deviation, decode_deviation_rgba8, exponential_warp, encode_esm, decode_esm, encode_evsm2, encode_evsm4, decode_evsm2, decode_evsm4, encode_msm, to_optimized_moments, hausdorff_share, decode_msm_hausdorff, fetch_bilinear, vsm, esm, evsm2, evsm4, msm, msm_unorm16, msm_hausdorff, chebyshev_hardware, decode_vsm_hardware, decode_evsm2_hardware, decode_evsm4_hardware, blur_row3, blur_row5, blur_row7, halve_texels, texels_to_world, clamp_bias, world_to_depth, biased, clamp_slope, plane_slope, receiver_slope, cascade_slope, slope_bias, dual_paraboloid_slope, normal_offset, kernel_bias, receiver_plane_slope, apply_receiver_plane, acne_free_bias, acne_free_disc_bias, peter_panning_distance, spot_cone, diffuse_ambient, false_color, overlay_texel, probe_color, probe_inputs };
