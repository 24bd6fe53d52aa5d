// SPDX-License-Identifier: MIT
//
// The snippets' page. The functions' facts are in it; the texts come with the language that is chosen.
import { dirname } from 'node:path';

import { escape } from '../context.mjs';
import { page } from '../page.mjs';
import { header_page } from '../reference/links.mjs';
import { model } from '../reference/model.mjs';
import { known_names } from '../search/index.mjs';

/// Choices in the order of state.ts, in a reader's words. tests/site/snippets_test.mjs holds that they are the same.
const languages = { glsl: 'GLSL', hlsl: 'HLSL', wgsl: 'WGSL', msl: 'Metal' };
const passes = { lookup: 'lookup', depth: 'depth pass' };
const versions = ['any', '100', '110', '120', '130', '150', '300 es', '310 es', '320 es', '330', '430', '450', '460'];
const ours = 'rg9 rg10 rg11 rg12 rg13 rg14 rg15 rg16 rgb24 rgb10 r16 float_bits'.split(' ');
const properties = {
    texture: [
        'kind of map',
        {
            texture_2d: '2D texture',
            atlas: 'tile of an atlas',
            array: 'layer of an array',
            cube: 'face of a cube',
            cube_faces: 'cube, all faces',
            integer: 'integer texture',
            depth: 'depth texture',
            depth_array: 'layer of a depth array',
            shadow: 'comparison sampler',
            shadow_array: 'comparison sampler, array',
        },
    ],
    stored: [
        'stored as',
        {
            depth32f: 'depth, or a float',
            depth24: 'depth texture of 24 bits',
            depth16: 'depth texture of 16 bits',
            ...Object.fromEntries(ours.map(name => [name, name])),
            threejs_rgba: 'three.js RGBA, r167 on',
            threejs_rgb: 'three.js RGB',
            threejs_rg: 'three.js RG',
            threejs_legacy: 'three.js, up to r166',
            base255: 'Cesium, Babylon.js (base 255)',
        },
    ],
    direction: ['depth', { forward: 'forward', reversed: 'reversed' }],
    outside: ['outside the map', { default: 'as the map has it', bordered: 'lit', clamped: 'nearest texel' }],
    gather: ['four texels at once', { no: 'no', yes: 'gather' }],
};

export async function pages(context) {
    await context.bundle('snippets/app.ts', 'snippets/app.js');
    for (const language of Object.keys(languages))  // the npm package's texts, loaded when a language is chosen
        await context.bundle(`../../single_include/${language === 'glsl' ? 'umbrage' : language}.mjs`, `snippets/${language}.js`);
    const path = 'snippets/index.html';
    return [
        {
            path,
            html: page({
                path,
                title: 'Snippets',
                scripts: ['snippets/app.js'],
                body: body(await facts(context)),
                description: 'Shadow mapping functions for your shader, in GLSL, HLSL, WGSL and Metal.',
            }),
        },
    ];
}

/// Facts of each function: its summary, names people use, the address of its entry, its cost.
async function facts(context) {
    const { entries, places, texts, addresses } = await model(context);
    const costs = read_costs(context), known = known_names(context, addresses), all = {};
    // A name that no shader function has, such as CSM, finds those of its folder.
    const is_of_room = (here, entry) =>
        here.every(name => !places.get(name)?.snippets.length) &&
        here.some(name => places.has(name) && dirname(places.get(name).place) === dirname(entry.place));
    for (const { name, summary } of Object.values(texts.glsl.snippets)) {
        const entry = entries.find(each => each.snippets.includes(name));
        const also = known
            .filter(({ here }) => here.includes(name) || here.includes(entry.name))
            .flatMap(({ names }) => names);
        const about = known.filter(({ here }) => is_of_room(here, entry)).flatMap(({ names }) => names);
        const [instructions = 0, cycles = 0] = costs.get(name) ?? [];
        all[name] = {
            summary,
            also: also.join(', '),
            about: about.join(' '),
            entry: `${header_page(entry.place)}#${entry.name}`,
            instructions,
            cycles,
            nothing: costs.get('nothing')?.[0] ?? 0,
        };
    }
    return all;
}

const read_costs = context =>
    new Map(
        context
            .read('examples/site/snippets/rdna2.tsv')
            .trim()
            .split('\n')
            .filter(line => !line.startsWith('#'))
            .map(line => line.split('\t'))
            .map(([name, ...values]) => [name, values.map(Number)]),
    );

const one_option = value => `<option>${value}</option>`;
const options = choices =>
    Object.entries(choices)
        .map(([value, words]) => `<option value="${value}">${escape(words)}</option>`)
        .join('');
const radios = (name, choices) =>
    Object.entries(choices)
        .map(
            ([value, words]) =>
                `<label><input type="radio" name="${name}" value="${value}"><span>${words}</span></label>`,
        )
        .join('');

const body = all => `
<h1>Snippets</h1>
<p class="lead">A shadow function for your shader, with all that it needs. Coordinates are in texels.
Visibility is 1 when lit.</p>
<noscript><p>This page composes texts by script. The repository has them as files too.</p></noscript>
<div class="snippets">
<div class="chooser">
<input id="search" type="search" aria-label="Search functions" placeholder="CSM, PCSS, Poisson ..." autocomplete="off"
spellcheck="false">
<p class="faint" id="count" role="status"></p>
<ul id="list" aria-label="Functions"></ul>
</div>
<div id="detail" class="loading">
<p id="notice" class="notice" role="status" hidden></p>
<h2 id="name"></h2>
<p id="summary"></p>
<div id="controls">
<div class="bar"><fieldset class="segments"><legend>language</legend>${radios('language', languages)}</fieldset>
<label class="field">version of GLSL <select id="version">${versions.map(one_option).join('')}</select></label>
<fieldset class="segments"><legend>text for the</legend>${radios('pass', passes)}</fieldset></div>
</div>
<div class="bar"><div id="tabs" class="segments"></div><button type="button" id="add">Add another map</button></div>
<fieldset id="map" class="bar"><legend>the map that it reads</legend>
<label class="field">name <input id="map_name" size="8" placeholder="none" spellcheck="false"></label>
${Object.entries(properties)
    .map(
        ([key, [label, choices]]) =>
            `<label class="field">${label} <select id="${key}">${options(choices)}</select></label>`,
    )
    .join('\n')}
</fieldset>
<div class="bar actions"><button type="button" class="main" id="copy">Copy</button>
<button type="button" id="download">Download</button>
<button type="button" id="link">Copy link</button><span class="faint" id="size"></span></div>
<pre tabindex="0" id="text"><code id="code"></code></pre>
<dl class="parts" id="fact_list"></dl>
</div>
</div>
<script type="application/json" id="facts">${JSON.stringify(all).replace(/</g, '\\u003c')}</script>`;
