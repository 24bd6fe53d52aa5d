// SPDX-License-Identifier: MIT
//
// The front page: the live scene, one sentence, and the way to each part.
import { execFileSync } from 'node:child_process';
import { join } from 'node:path';

import { page } from '../page.mjs';

const ways = [
    ['proof/', 'Prove it on your GPU', 'Every shader function runs here beside its C++ version, and the page counts the results that differ.'],
    ['check/', 'Check your own shader', 'Paste a shadow function. Your GPU runs it beside C++, and the page names what is wrong with it.'],
    ['snippets/', 'Copy a shader function', 'Search by the name you know. GLSL, HLSL, WGSL and Metal.'],
    ['reference/', 'Read the reference', 'Every function with its units, edge cases, formula and source.'],
    ['museum.html', 'Visit the museum of bugs', 'Public shadow bugs, each beside the formula that passes.'],
];

const tabs = (name, of) => of.map(([value, words], i) =>
    `<label><input type="radio" name="${name}" value="${value}"${i ? '' : ' checked'}><span>${words}</span></label>`).join('');

const live = `
<section class="live" aria-label="Live scene">
<div class="stage">
<div class="tabs" role="group" aria-label="View">${tabs('view', [['both', 'GPU | C++'], ['difference', 'Difference'], ['texels', 'Texels'], ['map', 'Map']])}</div>
<div class="shown">
<div class="screen">
<canvas id="picture" tabindex="0" aria-label="The scene. Arrow keys turn the camera, with Shift the light; plus and minus zoom."></canvas>
<div id="divided" hidden><span>your GPU</span><span>C++</span></div>
</div>
<p class="line"><output id="verdict"></output> <span id="time" class="faint"></span></p>
</div>
<label class="wide">Divider between your GPU and C++ <input id="divider" type="range" min="0" max="1" step="0.001" value="0.5"></label>
<p id="said" role="status" hidden></p>
</div>
<div class="panel">
<div class="tabs" role="group" aria-label="What a drag moves">${tabs('drag', [['camera', 'Drag the camera'], ['light', 'Drag the light']]).replace('value="light"', 'value="light" id="drag-light"')}</div>
<div id="controls"></div>
<p><label class="button" for="file">Open an OBJ or glTF file</label><input id="file" class="unseen" type="file" accept=".obj,.gltf,.glb"></p>
</div>
<div class="text" id="lines">
<h2>This shadow in your shader</h2>
<div class="bar"><div class="tabs" role="group" aria-label="Language">${tabs('language', [['glsl', 'GLSL'], ['hlsl', 'HLSL'], ['wgsl', 'WGSL'], ['msl', 'Metal']])}</div>
<button type="button">Copy</button></div>
<details><summary></summary><pre tabindex="0"><code></code></pre></details>
<pre tabindex="0"><code></code></pre>
</div>
</section>`;

/// WebAssembly of the lookups, and the scenes as files.
function make_scene(context) {
    const work = context.wasm('scene');
    execFileSync('node', ['--no-experimental-fetch', join(work, 'write_scenes.js'), work]);  // its loader would fetch a file
    for (const file of ['check.wasm', 'garden.scene', 'outdoor.scene']) context.copy(join(work, file), `scene/${file}`);
}

export async function pages(context) {
    make_scene(context);
    for (const script of ['main', 'check_worker', 'load_worker']) await context.bundle(`scene/${script}.ts`, `scene/${script}.js`);
    context.copy('.media/hero.png', 'pictures/hero.png');
    const cards = ways.map(([to, name, words]) => `<li class="card"><h2><a href="${to}">${name}</a></h2><p>${words}</p></li>`);
    const body = `
<h1 class="front">Shadows that compute the same in C++ and in your shader</h1>
<p class="lead">Most functions of this header-only C++20 library for shadow maps return the same bits in a shader, and the rest
keep within <a href="tests/">a stated bound</a>. So far that is shown on software renderers.</p>
<p class="bar"><a class="button main" href="start.html">Start</a> <a class="button" href="proof/">Prove it on this GPU</a>
<a class="button" href="snippets/">Copy the shader</a></p>
${live}
<img class="instead" src="pictures/hero.png" width="1280" height="560" loading="lazy" alt="A garden in sunlight. A mast's shadow is sharp at its foot and soft on a wall.">
<ul class="cards">${cards.join('')}</ul>`;
    return [{ path: 'index.html', html: page({
        path: 'index.html', title: 'Shadow mapping functions', body, scripts: ['scene/main.js'],
        description: 'Shadow mapping functions that return the same value in C++ and in your shader.' }) }];
}
