// SPDX-License-Identifier: MIT
//
// Whether Tint and naga accept WGSL:  node accept_wgsl.js NODE_MODULES DRIVER SHADER...
//
// DRIVER is the Vulkan loader's description of a driver, for Dawn. Of a folder each file is a shader. Exit status: 0 they do, 1 one does not, 77 neither is
// here.
'use strict';
const fs = require('fs');
const path = require('path');
const { pathToFileURL } = require('url');
const dawn = require('./backends/dawn.js');
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

const files_of = shader => fs.statSync(shader).isDirectory() ? fs.readdirSync(shader).map(file => path.join(shader, file)) : [shader];

(async () => {
    const here = name => fs.existsSync(path.join(modules, name));
    const compilers = {};
    if (here('webgpu') && fs.existsSync(driver)) compilers.tint = await tint();
    if (here('naga-wasm')) compilers.naga = await naga();
    let refused = 0;
    for (const [name, accept] of Object.entries(compilers))
        for (const shader of shaders) {
            const files = files_of(shader);
            let functions = 0;
            for (const file of files) {
                const text = fs.readFileSync(file, 'utf8');
                functions += text.match(/^fn /gm).length;
                try { await accept(text); } catch (error) {
                    ++refused;
                    console.log(`${name} refuses ${file}: ${error.formatted || error.message}`);
                }
            }
            console.log(`${name} read ${functions} functions of ${shader}, in ${files.length} files`);
        }
    if (!Object.keys(compilers).length) console.log('SKIPPED: neither webgpu nor naga-wasm in ' + modules);
    process.exit(refused ? 1 : Object.keys(compilers).length ? 0 : 77);
})();
