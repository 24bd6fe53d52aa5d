// SPDX-License-Identifier: MIT
//
// Docstrings of the headers, as data: Doxygen parses, this file reads its XML.
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, readdirSync, rmSync } from 'node:fs';
import { join } from 'node:path';

/// Declarations of the headers outside namespace detail, as items. Writes below context.work.
export function documented(context) {
    const { DOMParser } = context.load('@xmldom/xmldom');
    const xml = run_doxygen(context.root, join(context.work, 'doxygen'));
    const items = [];
    for (const file of readdirSync(xml)) {
        if (!/^(namespace|class|struct|concept)/.test(file)) continue;
        const document = new DOMParser().parseFromString(readFileSync(join(xml, file), 'utf8'), 'text/xml');
        const compound = child(document.documentElement, 'compounddef');
        const scope = text_of(child(compound, 'compoundname'));
        const members = children(compound, 'sectiondef')
            .flatMap(section => children(section, 'memberdef'))
            .filter(member => member.getAttribute('prot') !== 'private')
            .map(member => item(member, scope));
        if (file.startsWith('namespace')) items.push(...members);
        else items.push({ ...item(compound, ''), ...named(scope), members });
    }
    return items;
}

function run_doxygen(root, work) {
    rmSync(work, { recursive: true, force: true });
    mkdirSync(work, { recursive: true });
    const settings = readFileSync(new URL('Doxyfile', import.meta.url), 'utf8');
    execFileSync('doxygen', ['-'], {
        cwd: root,
        input: `${settings}\nOUTPUT_DIRECTORY = "${work}"\nWARN_LOGFILE = "${work}/warnings.txt"\n`,
    });
    return join(work, 'xml');
}

const children = (node, name) => Array.from(node?.childNodes ?? []).filter(each => each.nodeName === name);
const child = (node, name) => children(node, name)[0];
const one_line = text => text.replace(/\s+/g, ' ').trim();
const text_of = node => one_line(node?.textContent ?? '');

function named(qualified) {
    const parts = qualified.replace(/<.*/, '').split('::');
    return { name: parts.pop().trim(), scope: parts.join('::') };
}

/// One function, variable, type or concept.
function item(node, scope) {
    const location = child(node, 'location');
    return {
        name: text_of(child(node, 'name')).replace(/ ?<.*/, ''),
        scope,
        kind: node.getAttribute('kind'),
        place: location?.getAttribute('file') ?? '',
        line: Number(location?.getAttribute('line')),
        type: text_of(child(node, 'type')),
        arguments: children(node, 'param')
            .map(each => text_of(child(each, 'declname')))
            .filter(name => name !== ''),
        values: children(node, 'enumvalue').map(each => text_of(child(each, 'name'))),
        ...described(node),
    };
}

/// The docstring's parts; of a snippet without one its summary, as a sentence.
function described(node) {
    const doc = docstring(node),
        summary = /\.summary = "([^"]*)"/.exec(text_of(child(node, 'initializer')))?.[1];
    if (doc.brief === '' && summary) doc.brief = `${summary[0].toUpperCase()}${summary.slice(1)}.`;
    return doc;
}

/// The parts of a docstring: a brief sentence, paragraphs, lists of parameters, and texts by their tags.
function docstring(node) {
    const doc = {
        brief: text_of(child(node, 'briefdescription')),
        paragraphs: [],
        param: [],
        tparam: [],
        throws: [],
        tags: {},
    };
    const walk = para => {
        let prose = '';
        const flush = () => {
            if (one_line(prose) !== '') doc.paragraphs.push({ kind: 'text', text: one_line(prose) });
            prose = '';
        };
        for (const part of Array.from(para.childNodes))
            switch (part.nodeName) {
                case 'parameterlist':
                    add_list(doc, part);
                    break;
                case 'simplesect':
                    add_tag(doc, part);
                    break;
                case 'orderedlist':
                case 'itemizedlist':
                    flush();
                    doc.paragraphs.push(list(part.nodeName, children(part, 'listitem').map(text_of)));
                    break;
                case 'verbatim':
                    flush();
                    doc.paragraphs.push({ kind: 'code', text: part.textContent });
                    break;
                default:
                    prose += part.textContent;
            }
        flush();
    };
    children(child(node, 'detaileddescription'), 'para').forEach(walk);
    return doc;
}

/// A list, or the rows "term :: text" that rows.sed makes items of.
function list(kind, items) {
    const rows = items.map(each => each.split(' :: '));
    if (!rows.every(row => row.length === 2)) return { kind, items };
    return { kind: 'rows', rows: rows.map(([term, text]) => ({ term, text })) };
}

const lists = { param: 'param', templateparam: 'tparam', exception: 'throws' };

function add_list(doc, list) {
    for (const each of children(list, 'parameteritem'))
        doc[lists[list.getAttribute('kind')]].push({
            name: children(child(each, 'parameternamelist'), 'parametername').map(text_of).join(', '),
            text: text_of(child(each, 'parameterdescription')),
        });
}

function add_tag(doc, section) {
    const tag = text_of(child(section, 'title')) || section.getAttribute('kind');
    (doc.tags[tag] ??= []).push(children(section, 'para').map(text_of).join(' '));
}
