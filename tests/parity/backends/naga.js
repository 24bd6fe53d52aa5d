// SPDX-License-Identifier: MIT
//
// WGSL to SPIR-V:  node naga.js NODE_MODULES
'use strict';
const path = require('path');
const { pathToFileURL } = require('url');
const { serve } = require('./frames.js');

(async () => {
    const { translate } = await import(pathToFileURL(path.join(process.argv[2], 'naga-wasm/dist/node.js')));
    const spirv = source => translate({ from: 'wgsl', to: 'spirv', source });
    await serve(block => Buffer.from(spirv(block.toString()).buffer));
})();
