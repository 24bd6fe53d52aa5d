// SPDX-License-Identifier: MIT
//
// The browser's ways to its GPU. What draws is the parity suite's own.
import { webgl } from '../../../tests/parity/backends/webgl_draw.mjs';
import { webgpu } from '../../../tests/parity/backends/webgpu_draw.mjs';
import type { Api } from './state';

export interface Gpu {
    /** Number and name of the API, as suite.ts has them. */
    number: 1 | 2 | 3;
    name: string;
    device: string;
    draw(block: Uint8Array): Uint8Array | Promise<Uint8Array>;
    /** True when the browser has taken the GPU away. */
    is_lost(): boolean;
}

export const api_names: Record<Api, string> = { webgl1: 'WebGL 1', webgl2: 'WebGL 2', webgpu: 'WebGPU' };

const canvas = () => typeof document === 'undefined' ? new OffscreenCanvas(1, 1) : document.createElement('canvas');

/** Block that asks what draws for its name. */
function hello(version: number): Uint8Array {
    const words = new TextEncoder().encode(JSON.stringify({ hello: true, version }));
    const block = new Uint8Array(4 + Math.ceil(words.length / 4) * 4);
    new DataView(block.buffer).setUint32(0, words.length, true);
    block.set(words, 4);
    return block;
}

async function open_webgl(number: 1 | 2, name: string): Promise<Gpu> {
    let context: WebGLRenderingContext | undefined;
    const draw = webgl(() => {
        const made = canvas(), get = made.getContext.bind(made) as (...all: unknown[]) => unknown;
        return { getContext: (...all: unknown[]) => (context = get(...all) as WebGLRenderingContext) };
    });
    const device = new TextDecoder().decode(draw(hello(number)));
    return { number, name, device, draw, is_lost: () => context?.isContextLost() ?? false };
}

interface Device { lost: Promise<unknown> }
interface Adapter { requestDevice(): Promise<Device> }

async function open_webgpu(name: string): Promise<Gpu> {
    const { gpu } = navigator as unknown as { gpu?: { requestAdapter(): Promise<Adapter | null> } };
    if (!gpu) throw new Error('no WebGPU');
    const adapter = await gpu.requestAdapter();
    if (!adapter) throw new Error('WebGPU, but no adapter');
    const device = await adapter.requestDevice(), draw = webgpu({ adapter, device });
    let lost = false;
    void device.lost.then(() => { lost = true; });
    return { number: 3, name, device: new TextDecoder().decode(await draw(hello(3))), draw, is_lost: () => lost };
}

/** @throws Error   that says what is missing */
export function open_gpu(api: Api): Promise<Gpu> {
    return api === 'webgpu' ? open_webgpu(api_names[api]) : open_webgl(api === 'webgl1' ? 1 : 2, api_names[api]);
}
