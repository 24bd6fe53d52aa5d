// SPDX-License-Identifier: MIT
//
// Writes what umbrage-check says of other libraries' shader functions into README.md beside it.
//     node write_table.mjs UMBRAGE_CHECK PACKAGES FOLDER [--test]
//
// PACKAGES has each package unpacked in a folder of its name. FOLDER is for shaders. --test writes nothing: it fails where
// a row is not in the page, for a sample of the functions of those packages that are there.
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

import { packages } from './functions.mjs';

const [check, unpacked, folder, test] = process.argv.slice(2);
const page = join(dirname(fileURLToPath(import.meta.url)), 'README.md'), written = readFileSync(page, 'utf8');
mkdirSync(folder, { recursive: true });

function checked(file, { call, before, is, kind }) {
    const run = spawnSync(check, [file, '--call', call, '--json', ...(before ? ['--before', before] : []),
        ...(is ? ['--is', is] : []), ...(kind ? ['--kind', kind] : [])], { encoding: 'utf8' });
    if (run.status !== 0 && run.status !== 1) throw new Error(`${file}: ${(run.stderr || run.stdout).slice(0, 500)}`);
    return JSON.parse(run.stdout);
}

/** At most this many in a hundred: 99.99 is not 100. */
const percent = (part, all) => part === all ? '100 %' : `${(Math.floor(part / all * 10000) / 100).toFixed(2)} %`;
const differs = ({ slips, but }) =>
    [slips.map(each => each.says), but.map(each => `\`${each.kind}\``)].map(each => each.join(', ')).filter(Boolean).join('; ') || '-';

async function row({ name, version }, { title, text, promise, ...call }) {
    const file = join(folder, `${name} ${title}`.replace(/\W+/g, '_') + '.frag');
    writeFileSync(file, `#version 330\n${await text(join(unpacked, name))}`);
    const said = checked(file, call);
    return `| ${name} ${version} \`${title}\` | ${said.function ? `\`${said.function}\`` : 'none'}${promise ? `. They say: ${promise}` : ''} | ` +
        `${differs(said)} | ${percent(said.same_bits, said.inputs)}, ${percent(said.explained, said.inputs)} |`;
}

const rows = [];
for (const each of packages) {
    const manifest = join(unpacked, each.name, 'package.json');
    if (test && !existsSync(manifest)) continue;
    const { version } = JSON.parse(readFileSync(manifest, 'utf8'));
    if (version !== each.version) throw new Error(`${each.name}: version ${version}, and the list is of ${each.version}`);
    for (const one of each.functions) if (!test || one === each.functions.at(-1)) rows.push(await row(each, one));
}

if (test) {
    const stale = rows.filter(each => !written.includes(`\n${each}\n`));
    if (!rows.length) console.log('SKIPPED: none of the packages is here');
    for (const each of stale) console.log(`FAILED: the page lacks the row ${each}. Run: tests/check/published/run`);
    process.exit(stale.length ? 1 : 0);
}
const marks = /(<!-- table -->\n)[^]*?(<!-- table ends -->)/;
if (!marks.test(written)) throw new Error(`${page} has no place for the table`);
writeFileSync(page, written.replace(marks, (_, begin, end) => `${begin}| function | it is | slips; deviations | same bits, explained |
|---|---|---|--:|\n${rows.join('\n')}\n${end}`));
console.log(`${rows.length} functions`);
