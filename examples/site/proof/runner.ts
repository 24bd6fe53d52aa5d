// SPDX-License-Identifier: MIT
//
// Starts runs: in a worker, or on the page's thread where the browser refuses one.
import { load_suite, prove } from './run';
import type { News } from './run';
import type { Answer, Order } from './worker';

export interface Listener {
    news(news: News): void;
    /** A sentence for the reader. */
    notice(words: string): void;
    /** `failed` says why there is nothing more; null where all is done. */
    ended(failed: string | null): void;
}

/** A run that can be stopped. It ends after the entry that is being tried. */
export interface Run { stop(): void }

async function run_here(order: Order, to: Listener, stopped: () => boolean): Promise<void> {
    try {
        const suite = await load_suite(new URL('proof.wasm', import.meta.url));
        for await (const news of prove(suite, order.plan, order.command, order.system, stopped)) to.news(news);
        to.ended(null);
    } catch (error) {
        to.ended(error instanceof Error ? error.message : String(error));
    }
}

/** A worker that draws needs a canvas of its own. */
function make_worker(): Worker | null {
    try {
        const drawn = new OffscreenCanvas(1, 1);
        if (!drawn.getContext('webgl2') && !drawn.getContext('webgl') && !('gpu' in navigator)) return null;
        return new Worker(new URL('worker.js', import.meta.url), { type: 'module' });
    } catch {
        return null;
    }
}

export function start(order: Order, to: Listener): Run {
    let stopped = false;
    const here = () => {
        to.notice('This browser runs no worker that draws, so the page draws itself. It may stutter until the run ends.');
        void run_here(order, to, () => stopped);
    };
    const worker = make_worker();
    if (!worker) {
        here();
        return { stop: () => { stopped = true; } };
    }
    let answered = false;
    worker.addEventListener('message', ({ data }: MessageEvent<Answer>) => {
        answered = true;
        if ('news' in data) to.news(data.news);
        else {
            worker.terminate();
            to.ended('failed' in data ? data.failed : null);
        }
    });
    worker.addEventListener('error', event => {
        worker.terminate();
        if (answered) to.ended(`The worker stopped: ${event.message}`);
        else here();
    });
    worker.postMessage(order);
    return { stop: () => { stopped = true; worker.postMessage('stop'); } };
}
