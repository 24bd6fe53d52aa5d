// SPDX-License-Identifier: MIT
//
// Computes the shadow of a frame in C++, beside the page.
import { encodings, filters, kinds } from '../../../single_include/module/names.mjs';

import { start, type Program } from '../wasm';
import type { Frame } from './picture';

/** What C++ computed of a frame, and at how many pixels the GPU had another value. */
export interface Answer {
    visibility: Float32Array<ArrayBuffer>;
    places: Float32Array<ArrayBuffer>;
    receivers: number;
    different: number;
    worst: number;
    milliseconds: number;
}

interface Check extends Program {
    site_room(what: number, count: number): number;
    site_block(): number;
    site_map(encoding: number, reversed: number, width: number, height: number): void;
    site_visibility(kind: number, filter: number, reversed: number, width: number): void;
}

const fetched = fetch(new URL('check.wasm', self.location.href)).then(answer => answer.arrayBuffer());
const started = fetched.then(bytes => WebAssembly.compile(bytes)).then(module => start<Check>(module));

function answer(c: Check, frame: Frame): Answer {
    const begin = performance.now(), pixels = frame.width * frame.height, texels = frame.map_size[0] * frame.map_size[1];
    const is_bytes = frame.map instanceof Uint8Array;
    // all rooms first: memory that grows moves
    const points = c.site_room(0, pixels), normals = c.site_room(1, pixels);
    const map = is_bytes ? c.site_room(2, texels) : c.site_room(3, texels);
    const visibility = c.site_room(4, pixels), places = c.site_room(5, pixels), block = c.site_block();
    const { buffer } = c.memory;
    new Float32Array(buffer, points, 4 * pixels).set(frame.points);
    new Float32Array(buffer, normals, 4 * pixels).set(frame.normals);
    if (is_bytes) new Uint8Array(buffer, map, 4 * texels).set(frame.map);
    else new Float32Array(buffer, map, 4 * texels).set(frame.map);
    new Float32Array(buffer, block, frame.block.length).set(frame.block);
    const { kind, filter, encoding, direction } = frame.asked, reversed = direction === 'reversed' ? 1 : 0;
    c.site_map(encodings.indexOf(encoding), reversed, ...frame.map_size);
    c.site_visibility(kinds.indexOf(kind), filters.indexOf(filter), reversed, frame.width);

    const result = { visibility: new Float32Array(c.memory.buffer, visibility, pixels).slice(),
        places: new Float32Array(c.memory.buffer, places, 4 * pixels).slice(), receivers: 0, different: 0, worst: 0, milliseconds: 0 };
    for (let i = 0; i < pixels; ++i) {
        if (frame.points[4 * i + 3] === 0) continue;
        ++result.receivers;
        const off = Math.abs(result.visibility[i]! - frame.visibility[4 * i]!);
        if (off !== 0) ++result.different;  // NaN is different too
        if (off > result.worst) result.worst = off;
    }
    result.milliseconds = performance.now() - begin;
    return result;
}

self.onmessage = async ({ data }: MessageEvent<Frame>) => {
    try {
        const found = answer(await started, data);
        self.postMessage(found, { transfer: [found.visibility.buffer, found.places.buffer] });
    } catch (error) {
        self.postMessage({ error: error instanceof Error ? error.message : String(error) });
    }
};
