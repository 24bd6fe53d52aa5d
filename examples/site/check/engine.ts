// SPDX-License-Identifier: MIT
//
// What finds out which function a shader is: tests/check as WebAssembly, check.cpp.
import { start, type Program } from '../wasm';
import { subjects, type Subject } from './guess';
import type { Batch } from './run';

export interface Finding {
    kind: string;
    says: string;
}
type Four = [number, number, number, number];

/** Floats of the verdict, where JSON has NaN and infinities as words. */
const floats = <All extends number[]>(all: readonly (number | string)[]) =>
    all.map(each =>
        typeof each === 'number' ? each : each === 'inf' ? Infinity : each === '-inf' ? -Infinity : NaN,
    ) as All;

/** check::verdict. */
export interface Verdict {
    how: 'same_bits' | 'same_but' | 'other' | 'unknown';
    function: string;
    expected: string;
    /** What lookups outside of the map give; '' for codecs. */
    outside: string;
    slips: Finding[];
    but: Finding[];
    inputs: number;
    same_bits: number;
    explained: number;
    first?: { size: [number, number]; map: number[]; input: Four; got: Four; expected: Four };
    seen?: { steps: number; first: [number, number]; size: [number, number]; weights: number[] };
}

/** Exports of check.cpp. */
interface Exports extends Program {
    buffer(size: number): number;
    names(subject: number): number;
    begin(subject: number): void;
    next(): number;
    width(): number;
    height(): number;
    texels(): number;
    map(): number;
    inputs(): number;
    answer(): void;
    verdict(): number;
}

const number_of = (subject: Subject) => Object.keys(subjects).indexOf(subject);

export class Engine {
    /** @throws Error   that says what is missing */
    static async load(url: URL): Promise<Engine> {
        if (typeof WebAssembly === 'undefined')
            throw new Error('This browser has no WebAssembly, which the C++ versions run in.');
        const reply = await fetch(url);
        if (!reply.ok) throw new Error(`The C++ versions did not arrive: ${url.pathname}, status ${reply.status}.`);
        return new Engine(await start<Exports>(await WebAssembly.compile(await reply.arrayBuffer())));
    }
    private constructor(private readonly c: Exports) {}

    /** Names of all that a function can be. */
    names(subject: Subject): string[] {
        return this.text(this.c.names(number_of(subject)))
            .trim()
            .split('\n');
    }

    /** Begins. `is`: what the function should be; '' for "tell me". */
    begin(subject: Subject, is: string): void {
        this.put(new TextEncoder().encode(is));
        this.c.begin(number_of(subject));
    }
    /** The next inputs; null when there is a verdict. */
    next(): Batch | null {
        const { c } = this,
            count = c.next();
        if (count === 0) return null;
        const floats = (at: number, length: number) => new Float32Array(c.memory.buffer, at, length).slice();
        return {
            size: [c.width(), c.height()],
            map: floats(c.map(), c.texels()),
            inputs: floats(c.inputs(), count * 4),
        };
    }
    answer(outputs: Float32Array): void {
        this.put(new Uint8Array(outputs.buffer, outputs.byteOffset, outputs.byteLength));
        this.c.answer();
    }
    verdict(): Verdict {
        const found = JSON.parse(this.text(this.c.verdict())) as Verdict,
            { first, seen } = found;
        if (first)
            Object.assign(first, {
                map: floats(first.map),
                input: floats(first.input),
                got: floats(first.got),
                expected: floats(first.expected),
            });
        if (seen) Object.assign(seen, { first: floats(seen.first), weights: floats(seen.weights) });
        return found;
    }

    private put(bytes: Uint8Array): void {
        const at = this.c.buffer(bytes.length);
        new Uint8Array(this.c.memory.buffer, at, bytes.length).set(bytes);
    }
    private text(at: number): string {
        const all = new Uint8Array(this.c.memory.buffer);
        return new TextDecoder().decode(all.subarray(at, all.indexOf(0, at)));
    }
}
