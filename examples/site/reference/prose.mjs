// SPDX-License-Identifier: MIT
//
// Sentences of docstrings as HTML: code in backticks, links to the names that they mention, formulas.
import { escape } from '../context.mjs';

/// Text as HTML. Words with an underscore that are names, and headers' names, become links.
/// @param to   a name or a header's name to the address of its entry, or null
export function prose(text, to) {
    return text
        .split(/`([^`]*)`/)
        .map((part, at) => {
            if (at % 2 === 1) return `<code>${linked(part, to)}</code>`;
            return part
                .split(/(\b[\w/]+\.hpp\b|\b[a-z]\w*_\w+\b)/)
                .map((word, k) => {
                    if (k % 2 === 0) return raised(escape(word), k > 0);
                    const address = to(word);
                    return address
                        ? `<a href="${address}"><code>${word}</code></a>`
                        : word.includes('_')
                          ? `<code>${word}</code>`
                          : word;
                })
                .join('');
        })
        .join('');
}

/// Powers that stand in a sentence: 2^-24, (2r+1)^2, and right behind a name, map_size^2.
const raised = (html, behind_a_name) =>
    html.replace(behind_a_name ? /(?<=^|[\w)])\^(-?\([^()]*\)|-?\w+)/g : /(?<=[\w)])\^(-?\([^()]*\)|-?\w+)/g,
        (_, power) => `<sup>${power.replace('-', '−')}</sup>`);

function linked(code, to) {
    const address = /^[\w/.]+$/.test(code) ? to(code) : null;
    return address ? `<a href="${address}">${escape(code)}</a>` : escape(code);
}

const signs = {
    '<=': '≤',
    '>=': '≥',
    '->': '→',
    ' - ': ' − ',
    ' x ': ' × ',
    ' . ': ' · ',
    ' * ': ' · ',
    'sqrt(': '√(',
};
const token = new RegExp(
    [
        '(?<code>`[^`]*`)',
        '\\^(?<power>-?\\([^()]*\\)|-?\\w+)',
        '\\b(?<base>[A-Za-z])_(?<index>\\([^()]*\\)|\\w)(?!\\w)',
        '(?<name>\\b[a-z]\\w*_\\w+\\b)',
        "(?<!')\\b(?<letter>[A-Za-z])(?<digit>\\d?)\\b(?!'|(?<=\\b[Aa]) [a-z]{2})",
        '(?<sign><=|>=|->| - |(?<=\\b(?:[a-z]|normal)) x (?=(?:[a-z]|direction)\\b)| \\. | \\* |\\bsqrt\\()',
        '(?<minus>(?<=^|[\\s(,|])-(?=[\\w(]))',
    ].join('|'),
    'g',
);

/// A formula in ASCII as HTML: powers raised, indices lowered, letters in italics, signs in place of their spelling.
export function formula(text, to) {
    let html = '',
        done = 0;
    for (const found of text.matchAll(token)) {
        html += escape(text.slice(done, found.index));
        done = found.index + found[0].length;
        const { code, power, base, index, name, letter, digit, sign } = found.groups;
        const inner = part => formula(part.replace(/^\((.*)\)$/, '$1'), to);
        if (code) html += `<code>${linked(code.slice(1, -1), to)}</code>`;
        else if (power) html += `<sup>${inner(power)}</sup>`;
        else if (base) html += `<i>${base}</i><sub>${inner(index)}</sub>`;
        else if (name) html += `<code>${linked(name, to)}</code>`;
        else if (letter) html += `<i>${letter}</i>${digit ? `<sub>${digit}</sub>` : ''}`;
        else html += sign ? signs[sign] : '−';
    }
    return html + escape(text.slice(done));
}
