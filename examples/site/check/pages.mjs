// SPDX-License-Identifier: MIT
//
// The page that says which function a visitor's shader is, and what is wrong with it.
import { join } from 'node:path';

import { escape } from '../context.mjs';
import { page } from '../page.mjs';
import { anchor, plain } from '../reference/markdown.mjs';
import { header_page } from '../reference/links.mjs';
import { model } from '../reference/model.mjs';
import { slips } from './words.mjs';

const body = (rows, addresses) => `
<h1>Check a shader</h1>
<p class="lead">Paste a shadow function. Your GPU runs it beside C++, and the page says which function it is,
or what is wrong with it.</p>
<noscript><p class="notice">The check is a script. This browser runs none.</p></noscript>
<div id="notices"></div>
<div class="checker">
<div>
<label class="field">an example <select id="example"></select></label>
<label class="field" for="text">your function, in GLSL or WGSL, with everything that it calls</label>
<textarea id="text" spellcheck="false" autocomplete="off" autocapitalize="off" wrap="off"></textarea>
</div>
<form id="call">
<div class="two"><label class="field">language <select id="language"></select></label>
<label class="field">runs on <select id="api"></select></label></div>
<label class="field">function <select id="of"></select></label>
<label class="field">what it does <select id="subject"></select></label>
<fieldset id="given"><legend>what its arguments stand for</legend>
<div id="needs"></div>
<details><summary>Words for these expressions</summary><dl id="words"></dl></details>
</fieldset>
<label class="field">it should be <select id="is"></select></label>
<p class="bar"><button class="main" id="check">Check it</button>
<button type="button" id="link" hidden>Copy a link to this answer</button>
<span id="status" class="faint" role="status"></span></p>
</form>
</div>
<section id="answer" class="card" aria-label="Answer" aria-live="polite" hidden></section>
<section class="prose">
<h2>What it can tell you</h2>
<ul>
<li><b>The same bits</b>: your function gave the bits of the C++ function for every input.</li>
<li><b>The same, but for</b> map edges, NaN, or the weights of a sampler, which have few bits.</li>
<li><b>Another function</b>: which one, with which slips, and the smallest map that shows it.</li>
<li><b>No function</b>: the texels that yours reads, and their weights.</li>
</ul>
<h2>Slips that it names</h2>
<div class="scroll" tabindex="0" role="region" aria-label="Table of slips">
<table><thead><tr><th>slip</th><th>what it is</th></tr></thead>
<tbody>
${rows}
</tbody></table></div>
<p>Your text stays in your browser. It is also in the address, so that an answer is a link.
The same check is <a href="../tests/">a program</a> for your own tests.</p>
</section>
<script type="application/json" id="addresses">${JSON.stringify(addresses).replace(/</g, '\\u003c')}</script>`;

/// Address and title of the exhibit that has these words.
function exhibit_of(context, words) {
    const [found, second] = context
        .read('MUSEUM.md')
        .split(/^## /m)
        .slice(1)
        .filter(text => text.includes(words));
    if (!found || second) throw new Error(`MUSEUM.md has not one exhibit with "${words}", which the check page links`);
    const title = found.split('\n')[0];
    return [`museum.html#${anchor(title)}`, plain(title.replace(/^\d+\. /, ''))];
}

/// The rows of the table of slips.
const slip_rows = context =>
    Object.entries(slips).map(([kind, { name, words, exhibit, page }]) => {
        const [to, title] = page ?? exhibit_of(context, exhibit);
        return `<tr id="slip-${kind}"><td>${escape(name)}</td>
<td>${escape(words)} <a href="../${to}">${escape(title)}</a></td></tr>`;
    });

export async function pages(context) {
    const { places } = await model(context),
        path = 'check/index.html';
    const addresses = Object.fromEntries(
        Array.from(places)
            .filter(([, { place }]) => /^(filter|depth)\//.test(place))
            .map(([name, { place }]) => [name, `${header_page(place)}#${name}`]),
    );
    context.copy('examples/site/check/page.css', 'check/page.css');
    context.copy(join(context.wasm('check'), 'check.wasm'), 'check/check.wasm');
    for (const script of ['main', 'worker']) await context.bundle(`check/${script}.ts`, `check/${script}.js`);
    return [
        {
            path,
            html: page({
                path,
                title: 'Check a shader',
                body: body(slip_rows(context).join('\n'), addresses),
                scripts: ['check/main.js'],
                styles: ['check/page.css'], // which no other page has to load
                description:
                    'Paste a shadow function in GLSL or WGSL. Your GPU finds out which one it is, and what is wrong.',
            }),
        },
    ];
}
