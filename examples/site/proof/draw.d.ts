// SPDX-License-Identifier: MIT
//
// What draws in the parity suite is JavaScript.
declare module '*/webgl_draw.mjs' {
    export function webgl(make_canvas: () => { getContext(...all: unknown[]): unknown }): (block: Uint8Array) => Uint8Array;
}
declare module '*/webgpu_draw.mjs' {
    export function webgpu(of: { adapter: unknown; device: unknown }): (block: Uint8Array) => Promise<Uint8Array>;
}
