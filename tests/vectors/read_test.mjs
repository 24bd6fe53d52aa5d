// SPDX-License-Identifier: MIT
//
// Two functions written in JavaScript against the vectors: as they are, none differs, and with a slip some do.
//     node read_test.mjs FILE
import { readFileSync } from 'node:fs';

import { vectors } from './read.mjs';

const file = JSON.parse(readFileSync(process.argv[2], 'utf8'));

/** Depth to two bytes. `codes` is the slip: 2^11 of them are right. */
const encode_rg11 = codes => ([depth]) => {
    const code = !(depth < 1) ? 2047 : depth > 0 ? Math.min(Math.floor(depth * codes), 2047) : 0;
    return [code % 256, Math.floor(code / 256) * 32, 0, 255];
};

/** Percentage-closer filtering of 2 x 2 texels, whose weights are multiples of 1/256. `half`, in texels: 0.5 is right. */
const pcf_2x2 = half => ([x, y, receiver], { size, texels }) => {
    if (!(Math.abs(x) < 32768 && Math.abs(y) < 32768) || receiver > 1) return [1];
    const lit = (i, j) => {
        const column = Math.min(Math.max(i, 0), size[0] - 1), row = Math.min(Math.max(j, 0), size[1] - 1);
        return receiver <= texels[4 * (row * size[0] + column)] ? 1 : 0;
    };
    const [u, v] = [x, y].map(c => Math.floor(c * 256) / 256 - half), i = Math.floor(u), j = Math.floor(v);
    const mix = (a, b, weight) => a * (1 - weight) + b * weight;
    return [mix(mix(lit(i, j), lit(i + 1, j), u - i), mix(lit(i, j + 1), lit(i + 1, j + 1), u - i), v - j)];
};

/** How many of a function's vectors differ. Every NaN is one, and -0 is 0. */
function different(name, mine) {
    const all = vectors(file, name);
    if (all.length < 20) throw new Error(`${all.length} vectors of ${name}`);
    const same = (a, b) => a === b || (Number.isNaN(a) && Number.isNaN(b));
    return all.filter(({ inputs, outputs, map }) => !mine(inputs, map).every((v, i) => same(v, outputs[i]))).length;
}

let failed = 0;
for (const [name, mine, is_right] of [['encode_rg11', encode_rg11(2048), true], ['encode_rg11', encode_rg11(2047), false],
    ['pcf_2x2', pcf_2x2(0.5), true], ['pcf_2x2', pcf_2x2(0), false]]) {
    const wrong = different(name, mine);
    if ((wrong === 0) !== is_right) ++failed, console.error(`FAILED: ${name}: ${wrong} vectors differ`);
}
process.exit(failed ? 1 : 0);
