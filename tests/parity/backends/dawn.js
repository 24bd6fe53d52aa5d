// SPDX-License-Identifier: MIT
//
// WebGPU in this process, by Dawn on the driver that a description for the Vulkan loader names.
'use strict';
const os = require('os');
const path = require('path');
const { pathToFileURL } = require('url');

const kept = [];  // Dawn aborts when its instance is collected

async function open(modules, driver) {
    process.env.VK_ICD_FILENAMES = driver;
    process.env.XDG_RUNTIME_DIR ||= os.tmpdir();
    const { create, globals } = await import(pathToFileURL(path.join(modules, 'webgpu/index.js')));
    Object.assign(globalThis, globals);
    const gpu = create(['backend=vulkan']);
    kept.push(gpu);
    const adapter = await gpu.requestAdapter();
    if (!adapter) throw new Error('Dawn finds no adapter');
    return { gpu, adapter, device: await adapter.requestDevice() };
}

module.exports = { open };
