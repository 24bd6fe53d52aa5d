// SPDX-License-Identifier: MIT
//
// The page that proves the shaders on the visitor's GPU.
import { join } from 'node:path';

import { page } from '../page.mjs';

/// True for a page that tries a sample of the functions, as tests build it: in a fraction of the time.
const is_sample = process.env.UMBRAGE_PROOF_SAMPLE === '1';

const box = (id, name, words) => `<label class="box"><input type="checkbox" id="${id}" checked> <span>${name} <small>${words}</small></span></label>`;

const controls = `
<form class="card controls" onsubmit="return false">
<fieldset><legend>Run on</legend>
${box('webgl2', 'WebGL 2', 'GLSL 300 es')}${box('webgpu', 'WebGPU', 'WGSL')}${box('webgl1', 'WebGL 1', 'GLSL 100')}
</fieldset>
<label class="slide" for="inputs"><span>Inputs of each function: <output id="inputs_shown" for="inputs">4,096</output></span>
<input type="range" id="inputs" min="8" max="18" step="1" value="12"></label>
<p class="bar"><button class="main" id="prove" type="button">Prove it on this GPU</button>
<span id="status" class="faint" role="status"></span></p>
<progress id="progress" aria-label="Functions tried" hidden></progress>
</form>
<noscript><p class="notice">The proof is a script. This browser runs none.</p></noscript>
<div id="notices"></div>`;

const body = `
<h1>Prove it on your GPU</h1>
<p class="lead">Your GPU runs each shader function beside its C++ version, which is WebAssembly here. The page compares the bits.</p>
${controls}
${is_sample ? '<p class="faint">This copy of the site tries a sample of the functions.</p>' : ''}
<div id="results"></div>
<section id="report" class="prose" hidden>
<h2>Keep or send the report</h2>
<p>The report has the device, its arithmetic, and every difference with an input. It is what <code>make gpu</code> writes.
The issue form “What my GPU computes” takes it. A report without differences is welcome too.</p>
<p class="bar"><button type="button" id="copy">Copy the report</button> <button type="button" id="download">Download it</button>
<button type="button" id="link">Copy an address that runs this again</button> <span id="told" class="faint" role="status"></span></p>
</section>
<section class="prose">
<h2>How to read it</h2>
<ul>
<li><b>Tier A</b> promises the bits of C++ on any GPU with 32-bit floats, however the compiler reorders.</li>
<li><b>Tier B</b> promises them where sums are computed as written. In any other order it keeps a bound.</li>
<li><b>Tier C</b> uses division, roots or hardware filters. It keeps a bound.</li>
<li>A denormal may count as zero, and -0 as 0. Many GPUs do both.</li>
<li>NaN inputs are outside the promise where a language assumes that NaN never occurs, such as WGSL.</li>
</ul>
<p>Nothing leaves your browser. The first run compiles about 400 shaders, which takes most of the time.
See the proof fail: <a href="?fault=floor(=ceil(&amp;only=encode&amp;run">each <code>floor</code> replaced by <code>ceil</code></a>.</p>
</section>`;

export async function pages(context) {
    const [sample, level] = is_sample ? ['ON', '-O1'] : ['OFF', '-O2'];
    const built = context.wasm('proof/wasm', `sample_of_entries=${sample}`, `CMAKE_CXX_FLAGS_RELEASE=${level}`);
    context.copy(join(built, 'proof.wasm'), 'proof/proof.wasm');
    for (const script of ['main', 'worker']) await context.bundle(`proof/${script}.ts`, `proof/${script}.js`);
    return [{ path: 'proof/index.html', html: page({
        path: 'proof/index.html', title: 'Prove it on your GPU', body, scripts: ['proof/main.js'],
        description: 'Runs every shader function of umbrage on your GPU beside its C++ version, and compares the bits.' }) }];
}
