// SPDX-License-Identifier: MIT

/** Parts of a block: each with its length before it and padded to four bytes. */
export function parts_of(block) {
    const view = new DataView(block.buffer, block.byteOffset, block.byteLength), parts = [];
    for (let at = 0; at < block.byteLength;) {
        const length = view.getUint32(at, true);
        parts.push(block.subarray(at + 4, at + 4 + length));
        at += 4 + length + (4 - length % 4) % 4;
    }
    return parts;
}
