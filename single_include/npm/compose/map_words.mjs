// A snippet's text with the words that a map fills in, and where its lines end then.
import { must_in } from './check.mjs';
import { is_of_map } from './compose.mjs';

const must = /*#__PURE__*/ must_in('bind');

/** Whether a text can stand in an expression: one line, brackets in pairs, no comment, no directive, no statement. */
export function is_expression(text) {
    if (!/^[ -~]*[!-~][ -~]*$/.test(text) || /[;#\\"'`]|\/\/|\/\*/.test(text)) return false;
    const closing = [], pair = { '(': ')', '[': ']', '{': '}' };
    for (const c of text)
        if (c in pair) closing.push(pair[c]);
        else if (')]}'.includes(c) && closing.pop() !== c) return false;
    return closing.length === 0;
}

/** Whether it is one expression: no list, whose commas lie outside brackets, and no assignment. */
export const is_one_expression = text => is_expression(text) && members(text).length === 1 && !/(?<![=<>!])=(?!=)/.test(text);

/** An expression as an operand: in parentheses, unless it is a name, a number, a call or in brackets already. */
function as_operand(text) {
    let outside = text, before;
    do { before = outside; outside = outside.replace(/\([^()]*\)|\[[^[\]]*\]|\{[^{}]*\}/, ''); } while (outside !== before);
    return /^[\w.]*$/.test(outside) ? text : `(${text})`;
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

export const words_of = text => text.replace(/\/\/.*/g, '').match(/\w+/g) ?? [];

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

export const has_region = map => map.texture === 'atlas' || map.origin !== '';
/** By default whole maps and layers are bordered; tiles, regions and faces of cubes clamp. */
export const is_bordered = map =>
    map.outside === '' ? !has_region(map) && !['cube', 'cube_faces'].includes(map.texture) : map.outside === 'bordered';

/** A snippet's text before any map has filled it in: most stand as for a 2D texture of depths. */
function unfilled(hooks, s) {
    const parameters = new RegExp(hooks.textures.texture_2d.parameters.replace('map', '(\\w+)'), 'g');
    return (s.role !== 'chosen' && hooks.unfilled[s.name]) || s.text.replace(parameters, 'UMBRAGE_MAP $1');
}

const with_sampler = (map, ordinary, sampler) => map.gather ? ordinary.replace(/^[^,]*/, first => first + sampler) : ordinary;
/** Parameters that declare a map: its own, or those of its kind of texture, with a sampler for gathers. */
const parameters_of = (map, words) => map.parameters || with_sampler(map, words.parameters, words.sampler);

/** Those that stand for the map and its sampler, without what chooses one of several. */
export function declarations(map, words) {
    const all = members(parameters_of(map, words)).map(parameter => parameter.trim());
    const named = name => all.find(parameter => declared(parameter)[0] === name) ?? '';
    return { map: named('map'), sampler: named('map_sampler') };
}

/** The parameters but for those that a text declares itself: the layer, or the origin, of a map that it chooses. */
const not_declared_in = (text, parameters) => members(parameters)
    .filter(parameter => [' = ', ': '].every(sign => !text.includes(` ${declared(parameter)[0]}${sign}`))).join(',');

/** A snippet's text with what a map fills in; what declares the receiver's plane stands behind the map. */
export function for_map(hooks, s, suffix, map, words, receiver_plane) {
    let text = unfilled(hooks, s);
    const origin = as_operand(map.texture === 'atlas' ? map.origin || 'origin' : map.origin);
    const is_scaled = map.needs.some(need => need.scaled);
    const border = is_scaled ? '65536.0' : map.direction === 'forward' ? '1.0' : '0.0';
    const texture_size = as_operand(map.texture_size) || (origin === '' ? 'size' : words.size);
    const texel = map.texel || words.texel;
    if (texel.startsWith('#')) text = text.replaceAll('    return UMBRAGE_TEXEL;\n', 'UMBRAGE_TEXEL');
    if (origin === '') text = text.replace(/\n.*UMBRAGE_ORIGIN.*/, '');
    const own_map = text.match(/UMBRAGE_MAP (\w+)/)?.[1] ?? 'map';
    text = text.replaceAll(`UMBRAGE_MAP ${own_map}`, 'UMBRAGE_PARAMETERS');
    const ordinary = with_sampler(map, words.arguments, words.sampler_argument), parameters = parameters_of(map, words);
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
    const passes_plane = receiver_plane !== '' || words_of(text).includes('receiver_slope');
    const plane = map.receiver_plane && passes_plane ? ', receiver_slope, receiver_at' : '';
    const depth = map.depth || 'value.x';
    const list = all => replace_words(all, word => word === 'map' ? own_map : word);

    const suffixed = word => {
        const name = word.slice(8), is_it = own => own.name === name && is_of_map(own);
        return name === s.name || map.needs.some(is_it) || s.needs.some(is_it) ? word + suffix : word;
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
            case 'UMBRAGE_PARAMETERS': return list(not_declared_in(text, parameters)) + (receiver_plane && `, ${receiver_plane}`);
            case 'UMBRAGE_BORDER': return border;
            case 'UMBRAGE_COMPARE': return of_texture(map.compare);
            case 'UMBRAGE_REFERENCE':
                return of_texture(is_bordered(map)
                    ? 'umbrage_bordered_plane_reference(receiver_slope, receiver_at, texel, inside)'
                    : 'umbrage_plane_reference(receiver_slope, receiver_at, texel)');
            case 'UMBRAGE_CORNER': return of_texture('umbrage_corner_reference(receiver_slope, way, receiver)');
            case 'UMBRAGE_STORED': return of_texture(depth);
            case 'UMBRAGE_DEPTH': return of_texture(map.receiver_plane
                ? `umbrage_apply_receiver_plane(${depth}, receiver_slope, receiver_at, texel)` : depth);
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
export function laid_out(text) {
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
