// SPDX-License-Identifier: MIT
//
// The packing shaders of the npm packages under PREFIX, as they are, into FOLDER/<package>.glsl, and their versions
// into FOLDER/<package>.version.
//
//     node peers.mjs PREFIX FOLDER
import {mkdirSync, readFileSync, writeFileSync} from 'node:fs';
import {resolve} from 'node:path';
import {pathToFileURL} from 'node:url';

const [prefix, folder] = process.argv.slice(2);
const modules = resolve(prefix, 'node_modules');
const load = path => import(pathToFileURL(resolve(modules, path)));

const playcanvas_chunks = 'playcanvas/build/playcanvas/src/scene/shader-lib/glsl/chunks/';
const texts = {
    three: ['three', (await load('three/build/three.module.js')).ShaderChunk.packing],
    babylon: ['@babylonjs/core',
              (await load('@babylonjs/core/Shaders/ShadersInclude/packingFunctions.js')).packingFunctions.shader],
    playcanvas: ['playcanvas', (await load(playcanvas_chunks + 'common/frag/float-as-uint.js')).default],
};

mkdirSync(folder, {recursive: true});
for (const [name, [pkg, text]] of Object.entries(texts)) {
    if (!text) throw new Error(`${pkg}: no packing shader where it used to be`);
    writeFileSync(resolve(folder, `${name}.glsl`), text + '\n');
    const {version} = JSON.parse(readFileSync(resolve(modules, pkg, 'package.json')));
    writeFileSync(resolve(folder, `${name}.version`), version);
}
