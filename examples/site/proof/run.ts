// SPDX-License-Identifier: MIT
//
// One run, wherever it runs: in a worker, or on the page's own thread.
import { api_names, open_gpu } from './gpu';
import type { Gpu } from './gpu';
import type { Api, Plan } from './state';
import { Suite } from './suite';
import type { Entry, Result, Sum } from './suite';

export type Row = Entry & Result;

/** What a run says, in this order for each API. */
export type News =
    | { what: 'missing'; api: Api; why: string }
    | { what: 'begun'; api: Api; device: string; entries: number; probe: string[] }
    | { what: 'row'; api: Api; row: Row; sums: Sum[] }
    | { what: 'ended'; api: Api; report: string; seconds: number; lost: boolean };

/** @throws Error   that says what is missing */
export async function load_suite(url: URL): Promise<Suite> {
    if (typeof WebAssembly === 'undefined') throw new Error('This browser has no WebAssembly, which the C++ versions run in.');
    const reply = await fetch(url);
    if (!reply.ok) throw new Error(`The C++ versions did not arrive: ${url.pathname}, status ${reply.status}.`);
    return Suite.of(await WebAssembly.compile(await reply.arrayBuffer()));
}

const words_of = (error: unknown) => error instanceof Error ? error.message : String(error);

/** Lets messages and pictures through. */
const pause = () => new Promise<void>(then => setTimeout(then));

async function try_entry(suite: Suite, gpu: Gpu, i: number, entry: Entry, inputs: number): Promise<Result | undefined> {
    let result: Result | undefined;
    for (let part = 0; part < entry.parts; ++part) {
        try {
            result = suite.judge(await gpu.draw(suite.block(i, part, inputs)));
        } catch (error) {
            return gpu.is_lost() ? undefined : suite.not_run(i, words_of(error));
        }
    }
    return result;
}

/** @param command   how to run it again, for the report */
export async function* prove(suite: Suite, plan: Plan, command: string, system: string, stopped: () => boolean): AsyncGenerator<News> {
    for (const api of plan.on) {
        const start = performance.now();
        let gpu: Gpu;
        try {
            gpu = await open_gpu(api);
        } catch (error) {
            yield { what: 'missing', api, why: words_of(error) };
            continue;
        }
        suite.plant('');
        suite.begin(gpu.number, api_names[api], gpu.device, system);
        const probe = await suite.probe(block => gpu.draw(block));
        suite.plant(plan.fault);
        const chosen = Array.from({ length: suite.count }, (_, i) => i)
            .filter(i => suite.runs_in(i, gpu.number) && suite.entry(i).name.includes(plan.only))
            .filter((_, k) => k % plan.every === 0);
        yield { what: 'begun', api, device: gpu.device, entries: chosen.length, probe };
        for (const i of chosen) {
            await pause();
            if (stopped() || gpu.is_lost()) break;
            const entry = suite.entry(i), result = await try_entry(suite, gpu, i, entry, plan.inputs);
            if (result) yield { what: 'row', api, row: { ...entry, ...result }, sums: suite.sums() };
        }
        yield { what: 'ended', api, report: suite.report(command), seconds: (performance.now() - start) / 1000, lost: gpu.is_lost() };
        if (stopped()) return;
    }
}
