// SPDX-License-Identifier: MIT
import { readFileSync } from 'node:fs';

/** Floats of a text of bits, 8 hexadecimal digits each. */
const floats = digits => digits.match(/.{8}/g).map(bits => Buffer.from(bits, 'hex').readFloatBE());

/** The vectors of the function `name` in a file: what goes in, what comes out, and the map that it reads, if any. */
export function vectors(path, name) {
    const { maps, functions } = JSON.parse(readFileSync(path, 'utf8'));
    return functions.filter(f => f.name === name).flatMap(f => f.vectors.map(vector => {
        const [inputs, outputs] = vector.split(' ').map(floats);
        return { inputs, outputs, map: maps[f.map] && { size: maps[f.map].size, texels: floats(maps[f.map].texels) } };
    }));
}
