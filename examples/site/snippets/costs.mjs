// SPDX-License-Identifier: MIT
//
// Writes rdna2.tsv, what each snippet costs on AMD RDNA2, from the table of `tests/bench/shaders/run`:
//
//     node costs.mjs build/bench-shaders/shaders.tsv
import { readFileSync, writeFileSync } from 'node:fs';

const [head, ...lines] = readFileSync(process.argv[2], 'utf8')
    .trim()
    .split('\n')
    .map(line => line.split('\t'));
const column = name => head.indexOf(name);
const costs = lines
    .filter(([job, , shader]) => job === 'every snippet' || shader === 'nothing')
    .map(line => [line[column('shader')], line[column('instructions')], line[column('inv. thrpt')]]);
if (costs.length < 200) throw new Error(`few snippets in ${process.argv[2]}`);
const text = [
    '# Written by tests/bench/shaders/run. Snippet, instructions, inverse throughput in cycles: a whole fragment shader.',
    ...costs.map(line => line.join('\t')),
].join('\n');
writeFileSync(new URL('rdna2.tsv', import.meta.url), `${text}\n`);
