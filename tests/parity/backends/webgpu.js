// SPDX-License-Identifier: MIT
//
// Draws for remote.cpp with Dawn, without a browser:  node webgpu.js NODE_MODULES DRIVER
//
// DRIVER is the Vulkan loader's description of a driver. Jobs are between block.cpp and webgpu_draw.mjs.
'use strict';
const dawn = require('./dawn.js');
const { serve } = require('./frames.js');
const [modules, driver] = process.argv.slice(2);

(async () => {
    const { webgpu } = await import('./webgpu_draw.mjs');
    const draw = webgpu(await dawn.open(modules, driver));
    await serve(async block => Buffer.from(await draw(block)));
})().then(() => process.exit(0), error => {
    console.error('webgpu.js: ' + error.message);
    process.exit(1);
});
