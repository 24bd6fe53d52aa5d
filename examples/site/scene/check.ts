// SPDX-License-Identifier: MIT
//
// Has C++ compute a frame again, in a worker.
import type { Answer } from './check_worker';
import type { Frame } from './picture';

let worker: Worker | undefined = start();

function start(): Worker {
    const started = new Worker('scene/check_worker.js', { type: 'module' });
    started.onerror = () => { worker = undefined; };
    return started;
}

/** What C++ finds of a frame, one at a time. Throws an Error that says why there is no answer; the next call starts afresh. */
export function compare(frame: Frame): Promise<Answer> {
    const asked = worker ??= start();
    return new Promise((resolve, reject) => {
        asked.onmessage = ({ data }: MessageEvent<Answer | { error: string }>) =>
            'error' in data ? reject(new Error(data.error)) : resolve(data);
        asked.onerror = () => {
            worker = undefined;
            reject(new Error('this browser did not start its WebAssembly'));
        };
        asked.postMessage(frame, [frame.points.buffer, frame.normals.buffer, frame.map.buffer, frame.visibility.buffer]);
    });
}
