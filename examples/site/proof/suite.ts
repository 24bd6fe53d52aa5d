// SPDX-License-Identifier: MIT
//
// The parity suite as WebAssembly: wasm/proof.cpp.
import { start, type Program } from '../wasm';

export type Verdict = 'identical' | 'as promised' | 'different' | 'not run';

export interface Entry {
    name: string;
    tier: 'A' | 'B' | 'C';
    /** The tier, and its bound. */
    promise: string;
    /** Jobs that its inputs come in. */
    parts: number;
}

/** An entry's results up to now. */
export interface Result {
    verdict: Verdict;
    inputs: number;
    identical: number;
    different: number;
    worst_ulp: number;
    worst_distance: number;
    /** The first result that differs, or why the entry did not run. */
    example: string;
}

/** Entries of a tier. */
export interface Sum {
    identical: number;
    as_promised: number;
    different: number;
    not_run: number;
    inputs: number;
}

/** Exports of proof.cpp. */
interface Exports extends Program {
    buffer(size: number): number;
    text_size(): number;
    entry_count(): number;
    entry_at(i: number): number;
    runs_in(i: number, implementation: number): number;
    plant(): void;
    begin(implementation: number): void;
    probe_count(): number;
    probe_block(k: number): number;
    probe_drawn(): void;
    probe_result(failed: boolean): number;
    block(i: number, part: number, count: number): number;
    judge(): number;
    not_run(i: number): number;
    sums(): number;
    report(): number;
    digest(i: number, count: number): number;
}

export class Suite {
    static async of(module: WebAssembly.Module): Promise<Suite> { return new Suite(await start<Exports>(module)); }
    private constructor(private readonly c: Exports) {}

    get count(): number { return this.c.entry_count(); }

    entry(i: number): Entry {
        const [name = '', tier, promise = '', parts] = this.text(this.c.entry_at(i)).split('\t');
        return { name, tier: tier as Entry['tier'], promise, parts: Number(parts) };
    }
    runs_in(i: number, implementation: number): boolean { return this.c.runs_in(i, implementation) !== 0; }

    /** Plants a mistake into the shaders that follow, FROM=TO; '' none. */
    plant(fault: string): void {
        this.put(fault);
        this.c.plant();
    }

    /** Begins the report of an implementation: 1 and 2 are WebGL's versions, 3 is WebGPU. */
    begin(implementation: number, api: string, device: string, system: string): void {
        this.put([api, device, system].map(line => line.replaceAll('\n', ' ')).join('\n'));
        this.c.begin(implementation);
    }

    /** What the arithmetic of an implementation does, in lines. `draw` gives the pixels of a block. */
    async probe(draw: (block: Uint8Array) => Uint8Array | Promise<Uint8Array>): Promise<string[]> {
        let failed = '';
        try {
            for (let k = 0, n = this.c.probe_count(); k < n; ++k) {
                this.put(await draw(this.bytes(this.c.probe_block(k))));
                this.c.probe_drawn();
            }
        } catch (error) {
            failed = String(error);
            this.put(failed);
        }
        return this.text(this.c.probe_result(failed !== '')).split('\n').filter(line => line !== '');
    }

    /** Job of an entry's part, as webgl_draw.mjs and webgpu_draw.mjs take it. */
    block(i: number, part: number, count: number): Uint8Array { return this.bytes(this.c.block(i, part, count)); }
    /** The entry's results with those of the last block. */
    judge(pixels: Uint8Array): Result {
        this.put(pixels);
        return this.result(this.c.judge());
    }
    not_run(i: number, why: string): Result {
        this.put(why);
        return this.result(this.c.not_run(i));
    }

    /** Sums of the tiers A, B and C. */
    sums(): Sum[] {
        return this.text(this.c.sums()).trim().split('\n').map(line => {
            const [identical = 0, as_promised = 0, different = 0, not_run = 0, inputs = 0] = line.split('\t').map(Number);
            return { identical, as_promised, different, not_run, inputs };
        });
    }
    /** The report in Markdown, as `make gpu` writes it. */
    report(command: string): string {
        this.put(command);
        return this.text(this.c.report());
    }
    /** A line of parity_digest. */
    digest(i: number, count: number): string { return this.text(this.c.digest(i, count)); }

    private result(at: number): Result {
        const [verdict, inputs, identical, different, worst_ulp, worst_distance, ...example] = this.text(at).split('\t');
        return { verdict: verdict as Verdict, inputs: Number(inputs), identical: Number(identical), different: Number(different),
            worst_ulp: Number(worst_ulp), worst_distance: Number(worst_distance), example: example.join('\t') };
    }
    private put(what: string | Uint8Array): void {
        const bytes = typeof what === 'string' ? new TextEncoder().encode(what) : what, at = this.c.buffer(bytes.length);
        new Uint8Array(this.c.memory.buffer, at, bytes.length).set(bytes);
    }
    private bytes(at: number): Uint8Array { return new Uint8Array(this.c.memory.buffer).slice(at, at + this.c.text_size()); }
    private text(at: number): string {
        const all = new Uint8Array(this.c.memory.buffer);
        return new TextDecoder().decode(all.subarray(at, all.indexOf(0, at)));
    }
}
