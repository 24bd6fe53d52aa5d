// SPDX-License-Identifier: MIT
//
// One check, wherever it runs: in a worker, or on the page's own thread.
import { Engine, type Verdict } from './engine';
import { subjects, type Subject } from './guess';
import { Refused, type Call } from './program';
import type { Reading } from './read';
import type { Api } from './state';
import { open_webgl } from './webgl';
import { open_webgpu } from './webgpu';

/** Inputs for one run: four floats each, and a map of that many texels. */
export interface Batch {
    size: [number, number];
    map: Float32Array<ArrayBuffer>;
    inputs: Float32Array<ArrayBuffer>;
}
/** A call that has been compiled. */
export interface Prepared {
    run(batch: Batch): Promise<Float32Array>;
}
export interface Gpu {
    name: string;
    device: string;
    /** @throws Refused   with the compiler's message */
    prepare(call: Call, reading: Reading): Promise<Prepared>;
}

export interface Order {
    call: Call;
    reading: Reading;
    api: Api;
    /** What the function should be; '': tell me. */
    is: string;
}
export interface Found {
    verdict: Verdict;
    device: string;
    calls: number;
    seconds: number;
}
export type Answer =
    | { names: Record<Subject, string[]> }
    | { calls: number }
    | { found: Found; subject: Subject }
    | { refused: { message: string; line: number | null; details: string } };

let engine: Promise<Engine> | undefined;
const gpus: Partial<Record<Api, Promise<Gpu>>> = {};

const load = () => (engine ??= Engine.load(new URL('check.wasm', import.meta.url)));
const open = (api: Api): Promise<Gpu> =>
    (gpus[api] ??= api === 'webgpu' ? open_webgpu() : (async () => open_webgl(api === 'webgl1' ? 1 : 2))());

async function check({ call, reading, api, is }: Order, progress: (calls: number) => void): Promise<Found> {
    const begin = performance.now(),
        gpu = await open(api),
        prepared = await gpu.prepare(call, reading),
        asking = await load();
    if (is !== '' && !asking.names(call.subject).includes(is))
        throw new Refused(`The library has no function ${is} that ${subjects[call.subject]}.`);
    let calls = 0;
    asking.begin(call.subject, is);
    for (let batch = asking.next(); batch; batch = asking.next()) {
        asking.answer(await prepared.run(batch));
        calls += batch.inputs.length / 4;
        progress(calls);
    }
    return {
        verdict: asking.verdict(),
        device: `${gpu.name}, ${gpu.device}`,
        calls,
        seconds: (performance.now() - begin) / 1000,
    };
}

/** Carries out an order. Without one it gives the names. */
export async function carry_out(order: Order | null, say: (answer: Answer) => void): Promise<void> {
    try {
        if (order) {
            say({ found: await check(order, calls => say({ calls })), subject: order.call.subject });
            return;
        }
        const asking = await load(),
            all = (Object.keys(subjects) as Subject[]).map(subject => [subject, asking.names(subject)]);
        say({ names: Object.fromEntries(all) as Record<Subject, string[]> });
    } catch (error) {
        if (order) delete gpus[order.api]; // it may be lost
        const message = error instanceof Error ? error.message : String(error);
        say({
            refused:
                error instanceof Refused
                    ? { message, line: error.line, details: error.details }
                    : { message, line: null, details: '' },
        });
    }
}
