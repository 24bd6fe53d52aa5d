// SPDX-License-Identifier: MIT
//
// Reads back where WGSL has the members of a shadow's block:  node blocks.js NODE_MODULES DRIVER FOLDER
//
// The block's n-th float is n; a compute shader that shadows_write_texts wrote copies members in C++'s order.
'use strict';
const fs = require('fs');
const path = require('path');
const dawn = require('../parity/backends/dawn.js');
const [modules, driver, folder] = process.argv.slice(2);

/// The floats that each member is expected to hold, one after another.
function expected(file) {
    const members = fs.readFileSync(file, 'utf8').trim().split('\n').map(line => line.split(' '));
    return members.flatMap(([, offset, count]) => Array.from({ length: +count }, (_, i) => offset / 4 + i));
}

async function copied(device, code, count) {
    const module = device.createShaderModule({ code });
    const size = 4 * count;
    const pipeline = await device.createComputePipelineAsync({ layout: 'auto', compute: { module, entryPoint: 'copy' } });
    const block = device.createBuffer({ size, usage: GPUBufferUsage.UNIFORM | GPUBufferUsage.COPY_DST });
    const target = device.createBuffer({ size, usage: GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_SRC });
    const readable = device.createBuffer({ size, usage: GPUBufferUsage.MAP_READ | GPUBufferUsage.COPY_DST });
    device.queue.writeBuffer(block, 0, Float32Array.from({ length: count }, (_, i) => i));
    const commands = device.createCommandEncoder(), pass = commands.beginComputePass();
    pass.setPipeline(pipeline);
    [block, target].forEach((buffer, group) => pass.setBindGroup(group, device.createBindGroup({
        layout: pipeline.getBindGroupLayout(group), entries: [{ binding: 0, resource: { buffer } }] })));
    pass.dispatchWorkgroups(1);
    pass.end();
    commands.copyBufferToBuffer(target, 0, readable, 0, size);
    device.queue.submit([commands.finish()]);
    await readable.mapAsync(GPUMapMode.READ);
    return Array.from(new Float32Array(readable.getMappedRange()));
}

let opened;  // Dawn ends when nothing refers to it
(async () => {
    if (!fs.existsSync(path.join(modules, 'webgpu')) || !fs.existsSync(driver)) {
        console.log('SKIPPED: no webgpu in ' + modules + ', or no driver');
        process.exit(77);
    }
    const { device } = opened = await dawn.open(modules, driver);
    const blocks = path.join(folder, 'blocks'), files = fs.readdirSync(blocks).filter(name => name.endsWith('.offsets'));
    let floats = 0, wrong = 0;
    for (const file of files) {
        const wanted = expected(path.join(blocks, file));
        const code = fs.readFileSync(path.join(blocks, file.replace('.offsets', '.compute.wgsl')), 'utf8');
        const got = await copied(device, code, wanted.length);
        floats += got.length;
        wrong += got.filter((value, i) => value !== wanted[i]).length;
    }
    console.log(`${files.length} blocks, ${floats} floats, ${wrong} elsewhere than in C++`);
    process.exit(wrong || files.length < 6 ? 1 : 0);
})().catch(error => { console.error(error); process.exit(1); });
