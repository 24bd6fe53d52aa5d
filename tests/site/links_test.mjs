// SPDX-License-Identifier: MIT
//
// Every link of every page leads to a file of the site, and every fragment to an element of it. No page loads anything
// from another host. No heading has the name of an element that the style sheet lays out. The site stays small.
//
//     node links_test.mjs SITE
import { existsSync, readFileSync, readdirSync, statSync } from 'node:fs';
import { dirname, join, relative } from 'node:path';
import { brotliCompressSync, constants } from 'node:zlib';

const [site] = process.argv.slice(2);
if (!existsSync(join(site, 'index.html'))) {
    console.log('SKIPPED: the site was not built');
    process.exit(77);
}
const failed = [];
const check = (good, what) => {
    if (!good) failed.push(what);
};
const files = readdirSync(site, { recursive: true })
    .map(name => join(site, name))
    .filter(name => statSync(name).isFile());
const pages = new Map(
    files.filter(name => name.endsWith('.html')).map(name => [name, read_page(readFileSync(name, 'utf8'))]),
);

/// Links of a page, files that it loads, and its fragments. Scripts are no part of it.
function read_page(text) {
    const html = text.replace(/<script type="application\/json"[^]*?<\/script>/g, '');
    const all = (pattern, from = html) =>
        Array.from(from.matchAll(pattern), match => match[1].replace(/&amp;/g, '&').replace(/&#39;/g, "'"));
    return {
        links: all(/<a\b[^>]*\shref="([^"]*)"/g),
        loads: all(/<(?:link|script|img|source|iframe)\b[^>]*\s(?:href|src)="([^"]*)"/g),
        ids: all(/\sid="([^"]*)"/g),
        headings: all(/<h[1-6]\b[^>]*\sid="([^"]*)"/g),
    };
}

/// Reason why a link of a page is dead, or nothing.
function dead(page, to) {
    if (/^(https?|mailto):/.test(to)) return '';
    const [path, fragment] = to.split('#');
    let target = path.replace(/\?.*/, '') === '' ? page : join(dirname(page), path.replace(/\?.*/, ''));
    if (existsSync(target) && statSync(target).isDirectory()) target = join(target, 'index.html');
    if (relative(site, target).startsWith('..') || !existsSync(target)) return 'leads nowhere';
    if (fragment && pages.has(target) && !pages.get(target).ids.includes(decodeURIComponent(fragment)))
        return 'has no such fragment';
    return '';
}

const style = readFileSync(join(site, 'style.css'), 'utf8');
const laid_out = new Set(Array.from(style.matchAll(/#([a-z_]+)(?=[^;{}]*\{)/g), match => match[1]));
check(laid_out.size > 5, `the style sheet lays out ${laid_out.size} elements by name`);
let links = 0;
for (const [page, { links: to, loads, ids, headings }] of pages) {
    const name = relative(site, page);
    for (const each of [...to, ...loads]) {
        const why = dead(page, each);
        check(why === '', `${name}: ${each} ${why}`);
        ++links;
    }
    for (const each of loads) check(!/^(https?:)?\/\//.test(each), `${name} loads ${each}`);
    for (const each of headings.filter(id => laid_out.has(id))) check(false, `${name} lays out the heading ${each}`);
    const twice = ids.filter((id, at) => ids.indexOf(id) !== at);
    check(twice.length === 0, `${name} has two elements called ${twice}`);
}
check(links > 5000, `few links: ${links}`);
for (const each of JSON.parse(readFileSync(join(site, 'search.json'), 'utf8'))) {
    const why = dead(join(site, 'index.html'), each[2]);
    check(why === '', `the search finds ${each[0]} at ${each[2]}, which ${why}`);
}
const front = join(site, 'index.html');
check(
    dead(front, 'reference/gone.html') !== '' && dead(front, 'museum.html#gone') !== '' && dead(front, '../x') !== '',
    'a dead link is not seen',
);

const compressed = file =>
    brotliCompressSync(readFileSync(file), { params: { [constants.BROTLI_PARAM_QUALITY]: 5 } }).length;
let size = 0,
    largest = ['', 0];
for (const file of files) {
    const bytes = compressed(file);
    size += bytes;
    if (relative(site, file).startsWith('reference/') && bytes > largest[1]) largest = [relative(site, file), bytes];
}
check(size < 8e6, `the site is ${size} bytes, compressed`);
check(largest[1] < 32e3, `${largest[0]} is ${largest[1]} bytes, compressed`);

for (const what of failed) console.log(`FAILED: ${what}`);
console.log(
    `${pages.size} pages, ${links} links; ${(size / 1e6).toFixed(2)} MB compressed, largest in reference: ${largest}`,
);
process.exitCode = failed.length ? 1 : 0;
