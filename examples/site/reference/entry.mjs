// SPDX-License-Identifier: MIT
//
// An entry of the reference as HTML: a name's declarations, the parts of their docstrings, and its shader text.
import { escape } from '../context.mjs';
import { declaration } from './headers.mjs';
import { formula, prose } from './prose.mjs';

const tier_words = {
    A: 'the same bits everywhere',
    B: 'the same bits where sums keep their order',
    C: 'within a bound',
};

/// @param to   {name: address of a name's entry, page: address of a page of the site}, both relative to this page
export function entry_html(context, entry, header, texts, uses, to) {
    const tier = entry.tier?.toLowerCase(),
        why = to.page('tests/index.html');
    const badge = tier
        ? ` <a class="tier ${tier}" href="${why}" title="${tier_words[entry.tier]}">tier ${entry.tier}</a>`
        : '';
    const name = escape(entry.name);
    return `<section class="entry" id="${name}">
<h2><a href="#${name}">${name}</a>${badge}</h2>
${described(context, entry, header, to)}
${shader_html(context, entry, texts, to)}${uses_html(entry, uses, to)}</section>`;
}

/// The C++ declarations with their docstrings; of a shader function without a C++ version, what it does.
function described(context, entry, header, to) {
    const items = entry.items.filter(item => !is_text(item));
    if (items.length > 0) return items.map(item => item_html(context, item, header, to.name)).join('\n');
    return `<p>${prose(entry.items[0].brief, to.name)} A shader function alone.</p>`;
}

const is_text = item =>
    item.scope.startsWith('umbrage::glsl') && item.kind === 'variable' && /\bsnippet$/.test(item.type);

function item_html(context, item, header, to) {
    const text = declaration(header, item.line, item.kind).replace(/UMBRAGE_(INLINE|STRICT_MATH) /g, '');
    const where = item.scope === 'umbrage' ? '' : ` <span class="faint">(in <code>${item.scope}</code>)</span>`;
    const brief = item.brief ? `<p>${prose(item.brief, to)}${where}</p>` : where && `<p>${where}</p>`;
    return `${brief}
<pre tabindex="0"><code>${context.highlight(text, 'cpp')}</code></pre>
${item.paragraphs.map(part => paragraph(context, part, to)).join('')}${parts(item, to)}${members(item, header, to)}`;
}

/// A part of a comment: code, a text, rows of terms with their texts, or a list.
export function paragraph(context, part, to) {
    if (part.kind === 'code') {
        const text = part.text.replace(/^\n+|\s+$/g, '');
        return `<pre tabindex="0"><code>${context.highlight(text, 'cpp')}</code></pre>`;
    }
    if (part.kind === 'text') return `<p>${prose(part.text, to)}</p>`;
    if (part.kind === 'rows') {
        const rows = part.rows.map(({ term, text }) => `<dt><code>${escape(term)}</code></dt><dd>${prose(text, to)}</dd>`);
        return `<dl class="parts">${rows.join('')}</dl>`;
    }
    const list = part.kind === 'orderedlist' ? 'ol' : 'ul';
    return `<${list}>${part.items.map(each => `<li>${prose(each, to)}</li>`).join('')}</${list}>`;
}

/// The parts of a docstring, in the order of its template, as a list of terms.
function parts(item, to) {
    const rows = [];
    const add = (term, html) => rows.push(`<dt>${term}</dt><dd>${html}</dd>`);
    const { tags } = item;
    for (const { name, text } of [...item.tparam, ...item.param]) add(`<code>${escape(name)}</code>`, prose(text, to));
    for (const text of tags.return ?? []) add('returns', prose(text, to));
    for (const text of tags.edge ?? []) add('edge cases', prose(text, to));
    for (const { name, text } of item.throws) add('errors', `<code>${escape(name)}</code>: ${prose(text, to)}`);
    for (const text of tags.formula ?? []) add('formula', `<span class="formula">${formula(text, to)}</span>`);
    for (const text of tags.accuracy ?? []) add('accuracy', prose(text, to));
    for (const text of tags.exactness ?? []) add('exactness', prose(text, to));
    for (const text of tags.detaches ?? []) add('detaches', prose(text, to));
    for (const text of tags.cite ?? []) add('paper', `<cite>${escape(text)}</cite>`);
    return rows.length ? `<dl class="parts">${rows.join('')}</dl>\n` : '';
}

function members(item, header, to) {
    const shown = (item.members ?? [])
        .filter((each, at, all) => each.kind !== 'friend' && !shares_line(each, all))
        .map(each => ({ ...each, text: member_text(header, each) }))
        .filter(
            ({ text, brief, name }) =>
                !/= delete;?$/.test(text) && !(brief === '' && ['name', 'snippet'].includes(name)),
        );
    if (shown.length === 0) return '';
    if (!shown.some(each => words_of(each, to)))
        return `<pre tabindex="0"><code>${shown.map(each => escape(each.text)).join('\n')}</code></pre>`;
    const rows = shown.map(each => `<tr><td><code>${escape(each.text)}</code></td><td>${words_of(each, to)}</td></tr>`);
    return `<div class="scroll" tabindex="0" role="region" aria-label="Members of ${escape(item.name)}">
<table class="members"><thead><tr><th>member</th><th>what it is</th></tr></thead>
<tbody>${rows.join('')}</tbody></table></div>\n`;
}

/// True for the first of two variables that one line declares: its words stand behind the last.
const shares_line = (member, all) =>
    member.kind === 'variable' && all.filter(each => each.line === member.line).at(-1) !== member;

const member_text = (header, member) =>
    declaration(header, member.line, member.kind).replace(/\[\[nodiscard\]\] |UMBRAGE_(INLINE|STRICT_MATH) /g, '');

const words_of = (member, to) =>
    [
        prose(member.brief, to),
        ...member.paragraphs.map(part => prose(part.text ?? '', to)),
        ...member.param.map(each => `<br><code>${escape(each.name)}</code> ${prose(each.text, to)}`),
    ]
        .filter(words => words)
        .join(' ');

/// The function in four languages, each behind its name; of a family the second, which is neither smallest nor largest.
function shader_html(context, entry, texts, to) {
    if (entry.snippets.length === 0) return '';
    const shown = entry.snippets[entry.snippets.length > 1 ? 1 : 0];
    const page = (name, language = '') =>
        `${to.page('snippets/index.html')}?snippet=${name}${language && `&amp;language=${language}`}`;
    const family =
        entry.snippets.length === 1
            ? ''
            : `<p class="family">Also ${entry.snippets
                  .filter(name => name !== shown)
                  .map(name => `<a href="${page(name)}"><code>${name}</code></a>`)
                  .join(', ')}.</p>`;
    const languages = Object.entries(texts)
        .filter(([, { snippets }]) => snippets[shown])
        .map(
            ([id, { label, snippets }]) =>
                `<details name="${shown}"><summary>${label}</summary><pre tabindex="0"><code>${context.highlight(
                    snippets[shown].text.trim(),
                    id,
                )}</code></pre></details>`,
        );
    return `<div class="shader"><h3>In a shader: <code>umbrage_${shown}</code></h3>
<p><a href="${page(shown)}">Copy it with all that it needs</a>, for your map, in your language.</p>${family}
${languages.join('\n')}</div>\n`;
}

function uses_html(entry, uses, to) {
    const names = [entry.name, ...entry.snippets];
    const museum = new Map(names.flatMap(name => uses.exhibits.get(name) ?? []).map(each => [each.to, each.title]));
    const programs = [...new Set(names.flatMap(name => uses.programs.get(name) ?? []))].slice(0, 6);
    const list = (title, links) => (links.length ? `<p class="uses">${title}: ${links.join(', ')}</p>\n` : '');
    return (
        list(
            'Exhibits',
            [...museum].map(([address, title]) => `<a href="${to.page(address)}">${escape(title)}</a>`),
        ) +
        list(
            'Programs',
            programs.map(path => `<a href="${to.source(path)}">${escape(path.replace('examples/', ''))}</a>`),
        )
    );
}
