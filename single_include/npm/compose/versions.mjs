// GLSL's dialects: which of them a text suits, and what it is in one.
import { has_region } from './map_words.mjs';
import { must_in } from './check.mjs';
import { as_item, as_items, compose } from './compose.mjs';
import { glsl as language } from '../../module/languages.mjs';

export const versions = ['100', '110', '120', '130', '150', '300 es', '310 es', '320 es', '330', '430', '450', '460'];

const must = /*#__PURE__*/ must_in('text');
const has_gathers = ['310 es', '320 es', '430', '450', '460'];
const in_every_dialect = ['texture_2d', 'depth', 'atlas', 'cube', 'cube_faces'];

function must_be_version(must, version) { must(versions.includes(version), `version must be one of ${versions.join(', ')}`, version); }

/** True when the snippet, or the snippet bound to its map, compiles in a dialect of GLSL. */
export function supports(item, version) {
    must_be_version(must_in('supports'), version);
    const { what, map } = as_item(language, item), is_new = versions.indexOf(version) >= versions.indexOf('300 es');
    if (![what, ...(map?.needs ?? [])].every(s => s.lowest === '100' || is_new)) return false;
    if (map === undefined) return true;
    if (map.gather) return has_gathers.includes(version);
    if (has_region(map) && map.texture_size === '' && ['100', '110', '120'].includes(version)) return false;
    return is_new || in_every_dialect.includes(map.texture);
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
export function text(items, version) {
    if (version === undefined) return compose(language, items);
    must_be_version(must, version);
    for (const item of as_items(language, items))
        must(supports(item, version), `version must be one that has ${item.what.name}${item.suffix}`, version);
    const number = parseInt(version), es = version === '100' || version.endsWith('es'), has_precise = number >= (es ? 320 : 400);
    const prelude = `\n#ifndef UMBRAGE_HIGHP\n#define UMBRAGE_HIGHP${es ? ' highp' : ''}\n#endif\n`
        + `#ifndef UMBRAGE_PRECISE\n#define UMBRAGE_PRECISE${has_precise ? ' precise' : ''}\n#endif\n`;
    return resolved(compose(language, items, { prelude, may_reorder: has_precise ? '' : `GLSL ${version}`, version }), number);
}

/** The beginning of a GLSL shader: #version, preamble, the snippets and all they need. */
export function source(version, items, preamble = '') {
    const must = must_in('source');
    must_be_version(must, version);
    must(typeof preamble === 'string', 'preamble must be a string', preamble);
    if (preamble !== '' && !preamble.endsWith('\n')) preamble += '\n';
    return `#version ${version}\n${preamble}${text(items, version)}`;
}
