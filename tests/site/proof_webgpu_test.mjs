// SPDX-License-Identifier: MIT
//
// The proof page in WebGPU: its headline, and a planted fault.
import { check_headline, finished, share } from './proof.mjs';
import { visit, webgl_flags, webgpu_flags } from './visit.mjs';

await visit(async ({ open, check }) => {
    check_headline(check, 'webgpu', (await finished(await open(`proof/?on=webgpu&${share}&run`))).webgpu);
    const red = await finished(await open('proof/?on=webgpu&inputs=256&only=encode&fault=floor(=ceil(&run'));
    check(red.webgpu.bad > 0, `with a fault it says ${red.webgpu.tiles}`);
}, [...webgl_flags, ...webgpu_flags]);
