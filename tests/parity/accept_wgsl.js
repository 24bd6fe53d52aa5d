// SPDX-License-Identifier: MIT
//
// Whether Tint and naga accept WGSL:  node accept_wgsl.js NODE_MODULES DRIVER SHADER...
//
// DRIVER is the Vulkan loader's description of a driver, for Dawn. A folder is one shader in many files. Exit status: 0 they do, 1 one does not, 77 neither is
// here.
'use strict';
const fs = require('fs');
const path = require('path');
const { pathToFileURL } = require('url');
const dawn = require('./dawn.js');
const [modules, driver, ...shaders] = process.argv.slice(2);

let opened;  // Dawn ends when nothing refers to it
async function tint() {
    const { device } = opened = await dawn.open(modules, driver);
    return async code => {
        device.pushErrorScope('validation');
        device.createShaderModule({ code });
        const error = await device.popErrorScope();
        if (error) throw error;
    };
}

async function naga() {
    const { translate } = await import(pathToFileURL(path.join(modules, 'naga-wasm/dist/node.js')));
    return async source => { translate({ from: 'wgsl', to: 'spirv', source }); };
}

function read(shader) {
    if (!fs.statSync(shader).isDirectory()) return fs.readFileSync(shader, 'utf8');
    return fs.readdirSync(shader).map(file => read(path.join(shader, file))).join('');
}

(async () => {
    const here = name => fs.existsSync(path.join(modules, name));
    const compilers = {};
    if (here('webgpu') && fs.existsSync(driver)) compilers.tint = await tint();
    if (here('naga-wasm')) compilers.naga = await naga();
    let refused = 0;
    for (const [name, accept] of Object.entries(compilers))
        for (const shader of shaders) {
            const text = read(shader);
            try {
                await accept(text);
                console.log(`${name} accepts ${text.match(/^fn /gm).length} functions of ${shader}`);
            } catch (error) {
                ++refused;
                console.log(`${name} refuses ${shader}: ${error.formatted || error.message}`);
            }
        }
    if (!Object.keys(compilers).length) console.log('SKIPPED: neither webgpu nor naga-wasm in ' + modules);
    process.exit(refused ? 1 : Object.keys(compilers).length ? 0 : 77);
})();
