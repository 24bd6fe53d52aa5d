// SPDX-License-Identifier: MIT
//
// Starts a C++ program of this site, WebAssembly without JavaScript, with the little that its C library needs of a host.

/** What every program exports. Pointers are numbers. */
export interface Program {
    memory: WebAssembly.Memory;
    _initialize(): void;
}

/** Functions of WASI that a module imports. Output, which only an abort writes, is refused. */
function host(memory: () => WebAssembly.Memory, imports: WebAssembly.ModuleImportDescriptor[]): WebAssembly.Imports {
    const refused = 52, view = () => new DataView(memory().buffer);
    const known: Record<string, (...all: never[]) => number> = {
        clock_time_get: (_id: number, _precision: bigint, at: number) =>
            (view().setBigUint64(at, BigInt(Date.now()) * 1_000_000n, true), 0),
        environ_sizes_get: (count: number, size: number) => (view().setUint32(count, 0, true), view().setUint32(size, 0, true), 0),
        environ_get: () => 0,
        proc_exit: () => { throw new Error('The C++ side stopped.'); },
    };
    const all: Record<string, Record<string, (...all: never[]) => number>> = {};
    for (const { module, name } of imports) (all[module] ??= {})[name] = known[name] ?? (() => refused);
    return all;
}

export async function start<Exports extends Program>(module: WebAssembly.Module): Promise<Exports> {
    let exports: Exports;
    const instance = await WebAssembly.instantiate(module, host(() => exports.memory, WebAssembly.Module.imports(module)));
    exports = instance.exports as unknown as Exports;
    exports._initialize();
    return exports;
}
