// SPDX-License-Identifier: MIT

/** Floats of a text of bits, 8 hexadecimal digits each. */
const floats = digits => digits.match(/.{8}/g).map(bits => new Float32Array(Uint32Array.of(parseInt(bits, 16)).buffer)[0]);

/** The vectors of the function `name` in a parsed file: inputs, outputs, and the map that it reads, if any. */
export function vectors({ maps, functions }, name) {
    return functions.filter(f => f.name === name).flatMap(f => {
        const map = f.map === undefined ? null : { size: maps[f.map].size, texels: floats(maps[f.map].texels) };
        return f.vectors.map(vector => vector.split(' ').map(floats)).map(([inputs, outputs]) => ({ inputs, outputs, map }));
    });
}
