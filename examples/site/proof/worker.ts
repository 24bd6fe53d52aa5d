// SPDX-License-Identifier: MIT
//
// Runs away from the page's thread. It takes an order, or the word 'stop', and answers with news.
import { load_suite, prove } from './run';
import type { Plan } from './state';

export interface Order { plan: Plan; command: string; system: string }
export type Answer = { news: import('./run').News } | { done: true } | { failed: string };

let stopped = false;
const say = (answer: Answer) => postMessage(answer);

addEventListener('message', async ({ data }: MessageEvent<Order | 'stop'>) => {
    if (data === 'stop') {
        stopped = true;
        return;
    }
    try {
        const suite = await load_suite(new URL('proof.wasm', import.meta.url));
        for await (const news of prove(suite, data.plan, data.command, data.system, () => stopped)) say({ news });
        say({ done: true });
    } catch (error) {
        say({ failed: error instanceof Error ? error.message : String(error) });
    }
});
