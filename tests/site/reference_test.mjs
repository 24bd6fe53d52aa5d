// SPDX-License-Identifier: MIT
//
// The reference is complete: every public name that readme --public lists has an entry on its header's page, and no
// docstring lacks a part. Lists in comments stay lists.
//
//     node reference_test.mjs SITE NODE_MODULES SOURCES WORK README_TOOL
import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import { join, resolve } from 'node:path';

const [site, node_modules, sources, work, tool] = process.argv.slice(2).map(path => resolve(path));
if (!existsSync(join(site, 'reference/index.html'))) {
    console.log('SKIPPED: the site was not built');
    process.exit(77);
}
const { make_context, root } = await import(join(sources, 'context.mjs'));
const { model } = await import(join(sources, 'reference/model.mjs'));
const { missing_parts } = await import(join(sources, 'reference/complete.mjs'));
const { header_page } = await import(join(sources, 'reference/links.mjs'));

const all = await model(await make_context({ out: join(work, 'unused'), node_modules, work }));
const failed = [];
const check = (good, what) => {
    if (!good) failed.push(what);
};

/// Names without an entry, among lines "place name".
function without_entry(lines, page_of) {
    return lines
        .map(line => line.split(' '))
        .filter(([place, name]) => !page_of(place).includes(`<section class="entry" id="${name}">`));
}

const pages = new Map();
function built(place) {
    const file = join(site, header_page(place));
    if (!pages.has(place)) pages.set(place, existsSync(file) ? readFileSync(file, 'utf8') : '');
    return pages.get(place);
}
const lines = execFileSync(tool, ['--public', root], { encoding: 'utf8' }).trim().split('\n');
check(lines.length > 500, `readme --public lists ${lines.length} names`);
for (const [place, name] of without_entry(lines, built)) check(false, `${header_page(place)} has no entry of ${name}`);
for (const entry of all.entries) for (const wrong of missing_parts(entry, all.texts.glsl.snippets)) check(false, wrong);

// Lists stay lists: in a header's first comment, where one row has no room for a second space, and in a docstring.
const rows_of = parts => parts.filter(part => part.kind === 'rows').map(part => part.rows.map(row => row.term).join());
check(
    rows_of(all.headers.get('shader/hooks/fetch.hpp').paragraphs).join('; ') ===
        'UMBRAGE_MAP map,UMBRAGE_ORIGIN,UMBRAGE_DEPTH,UMBRAGE_STORED,UMBRAGE_REFERENCE,UMBRAGE_CORNER,UMBRAGE_BORDER,' +
            'UMBRAGE_COMPARE,UMBRAGE_UV',
    'the list of words at the head of fetch.hpp is another',
);
const texture = all.entries.find(each => each.name === 'texture' && each.place === 'shader/binding.hpp');
check(
    rows_of(texture.items[0].paragraphs).join('; ') ===
        'texture_2d,atlas,array,cube,cube_faces,integer,depth, depth_array,shadow, shadow_array',
    'the list of types in the docstring of texture is another',
);
check(built('core/parallel.hpp').includes('<dt><code>omission</code></dt><dd>a piece that never'), 'a list is not shown as one');

const kinds = all.headers.get('images/min_max.hpp').paragraphs.map(part => part.kind).join();
check(kinds === 'text,code,text,text', `code above a text in min_max.hpp is read as ${kinds}`);
const begins = [...all.headers.values()].flatMap(({ paragraphs }) => paragraphs.filter(part => /Also called: /.test(part.text ?? '')));
check(begins.length > 60 && begins.every(part => part.text.startsWith('Also called: ')), 'names elsewhere are no paragraph of their own');
check(built('draw/dual_paraboloid_pass.hpp').includes('map_size</code><sup>2</sup>'), 'a power of a name is not raised');
check(built('light/warp/light_space_perspective.hpp').includes('light_<wbr>space_'), 'a long title does not break');

// Faults that it must see.
check(
    without_entry(['filter/pcf/box.hpp box', 'filter/pcf/box.hpp box_count'], place =>
        built(place).replace('id="box"', ''),
    ).length === 1,
    'a missing entry is not seen',
);
const box = all.entries.find(each => each.name === 'box_count'),
    faulty = change =>
        missing_parts(
            { ...box, items: box.items.map(item => (item.kind === 'function' ? { ...item, ...change } : item)) },
            all.texts.glsl.snippets,
        );
check(faulty({ param: box.items[0].param.slice(1) }).length === 1, 'a parameter without a description is not seen');
check(
    faulty({ param: [...box.items[0].param, { name: 'gone', text: '' }] }).length === 1,
    'a description without a parameter is not seen',
);
check(missing_parts({ ...box, tier: null }, all.texts.glsl.snippets).length === 1, 'a missing tier is not seen');
check(
    missing_parts({ ...box, snippets: [], items: [{ ...box.items[0], brief: '' }] }, {}).length === 1,
    'a missing sentence is not seen',
);

for (const what of failed) console.log(`FAILED: ${what}`);
console.log(`${lines.length} public names, ${all.entries.length} entries of ${all.headers.size} headers`);
process.exitCode = failed.length ? 1 : 0;
