// SPDX-License-Identifier: MIT
//
// Headers as text: the comment that each opens with, and declarations as they stand in the source.
import { readFileSync, readdirSync } from 'node:fs';
import { join, relative } from 'node:path';

/// The headers, by their places below include/umbrage, less primitives.hpp, which is generated.
export function read_headers(root) {
    const include = join(root, 'include/umbrage');
    const places = files_below(include)
        .map(file => relative(include, file))
        .filter(place => place !== 'primitives.hpp')
        .sort();
    return new Map(places.map(place => [place, read_header(place, readFileSync(join(include, place), 'utf8'))]));
}

export function files_below(folder, ending = '.hpp') {
    return readdirSync(folder, { withFileTypes: true }).flatMap(entry => {
        const path = join(folder, entry.name);
        if (entry.isDirectory()) return files_below(path, ending);
        return path.endsWith(ending) ? [path] : [];
    });
}

/// A header's lines, and the paragraphs of its first comment, of which some are code.
function read_header(place, text) {
    const lines = text.split('\n');
    const end = lines.findIndex(line => !line.startsWith('//'));
    const comment = lines.slice(1, end).map(line => line.slice(3));
    const paragraphs = comment
        .join('\n')
        .split(/\n\s*\n/)
        .filter(block => block.trim() !== '')
        .flatMap(parts_of)
        .flatMap(other_names_apart);
    const also = /Also called: ([^]*?[\w)\]])\.(?:\s|$)/.exec(paragraphs.map(each => each.text ?? '').join('\n'));
    return { place, lines, paragraphs, also_called: also ? also_called(also[1].replace(/\s+/g, ' ')) : [] };
}

/// A text with its names elsewhere as a text of their own.
const other_names_apart = part =>
    part.kind === 'text' ? part.text.split(/ (?=Also called: )/).map(text => ({ ...part, text })) : part;

/// A block of a comment as texts, lists and code. A list's first row is "  term  text". The texts of all rows begin in one
/// column, and lines that are indented farther than terms continue them. Elsewhere four spaces begin code.
export function parts_of(block) {
    const parts = [];
    for (const line of block.split('\n').filter(each => each.trim() !== '')) {
        const last = parts.at(-1),
            words = line.trim().replace(/\s+/g, ' '),
            first = /^ {2}\S+(?: \S+)* {2,}(?=\S)/.exec(line);
        const row = column => ({ term: line.slice(0, column).trim(), text: line.slice(column).trim() });
        if (last?.kind === 'rows' && /^ {2}\S/.test(line)) last.rows.push(row(last.column));
        else if (last?.kind === 'rows' && line.startsWith('    ')) last.rows.at(-1).text += ` ${words}`;
        else if (line.startsWith('    ') && last?.kind === 'code') last.text += `\n${line.slice(4)}`;
        else if (line.startsWith('    ')) parts.push({ kind: 'code', text: line.slice(4) });
        else if (first) parts.push({ kind: 'rows', column: first[0].length, rows: [row(first[0].length)] });
        else if (last?.kind === 'text') last.text += ` ${words}`;
        else parts.push({ kind: 'text', text: words });
    }
    return parts;
}

/// "CSM, PSSM (make_stable_cascades, make_tight_cascades); practical splits" as [{names, here}].
const also_called = text =>
    text.split('; ').map(part => {
        const [, names, here] = /^(.*?)(?: \(([a-z]\w*(?:, [a-z]\w*)*)\))?$/.exec(part);
        return { names: names.split(', '), here: here ? here.split(', ') : [] };
    });

const opens_declaration = /^\s*(template|requires|\[\[nodiscard\]\])/;

/// A declaration as the header has it: from "template" to the body, the semicolon or the initial value's end.
/// @param line   of the name, from 1
export function declaration(header, line, kind) {
    let first = line - 1;
    while (first > 0 && opens_declaration.test(header.lines[first - 1]) && !/[;}]$/.test(header.lines[first - 1]))
        --first;
    const text = header.lines.slice(first, first + 40).join('\n');
    const whole = kind === 'enum' || kind === 'variable' || kind === 'typedef' || kind === 'concept';
    return unindented(text.slice(0, declaration_end(text, whole)).trimEnd());
}

/// The length of a declaration: up to its semicolon, or to what opens a body.
function declaration_end(text, whole) {
    for (let at = 0, depth = 0; at < text.length; ++at) {
        const c = text[at];
        if (text.startsWith('//', at)) at = text.indexOf('\n', at);
        else if (c === '(') ++depth;
        else if (c === ')') --depth;
        else if (c === '{' && depth === 0 && !whole && !is_requirement(text.slice(0, at))) return at;
        else if (c === '{') ++depth;
        else if (c === '}') --depth;
        else if (c === ';' && depth === 0) return at + 1;
        else if (!whole && depth === 0 && /^\) *\n? *: $/.test(text.slice(text.lastIndexOf(')', at), at + 2)))
            return at;
    }
    return text.length;
}

/// True where a brace opens what an expression requires, not a body behind a clause.
const is_requirement = before => /(\brequires|=|&&|\|\||\()\s*requires\s*(\([^()]*\))?\s*$/.test(before);

function unindented(text) {
    const indent = /^ */.exec(text)[0].length;
    return text
        .split('\n')
        .map(line => line.slice(Math.min(indent, /^ */.exec(line)[0].length)))
        .join('\n');
}
