// SPDX-License-Identifier: MIT
//
// The bias page: numbers for an engine's own shadow bias. The script computes them with the npm package.
import { engines } from '../../../single_include/npm/engines.mjs';
import { escape } from '../context.mjs';
import { page } from '../page.mjs';

/// Names of the page in the search.
export const known_as = 'bias calculator, normalBias, shadow_normal_bias, shadowNormalBias, constantBias';

const path = 'bias.html', sizes = [256, 512, 1024, 2048, 4096, 8192];
const option = (value, words) => `<option value="${value}">${escape(String(words))}</option>`;

export async function pages(context) {
    await context.bundle('bias/app.ts', 'bias.js');
    const title = 'Shadow bias calculator', description = 'Bias settings for the lights of three.js, Godot, Unity URP, Bevy and filament.';
    return [{ path, html: page({ path, title, description, scripts: ['bias.js'], body }) }];
}

const number = (name, words, low, high, of = 'of_engine') => `<label class="field ${of}">${words}
<input type="number" id="${name}" min="${low}" max="${high}" step="any" required></label>`;
const row = (name, words) => `<tr><th scope="row">${words}</th><td id="these_${name}"></td><td id="defaults_${name}"></td></tr>`;
const picture = (side, words) => `<figure><canvas id="picture_${side}" width="432" height="288" role="img" aria-label="A floor, a board and a post under the light, ${words}"></canvas>
<figcaption>${words}</figcaption></figure>`;

const body = `
<h1>Shadow bias calculator</h1>
<p class="lead">Numbers for a light of your engine, with which no plane stripes itself. Shadows stay as near to what
casts them as that allows.</p>
<noscript><p>This page computes by script. The numbers are also in the npm package, as <code>engine_bias</code>.</p></noscript>
<div id="bias_page" class="loading">
<form id="light" class="bar bias_form" aria-label="The light">
<label class="field">engine <select id="engine">${Object.entries(engines).map(([name, { title }]) => option(name, title)).join('')}${option('other', 'another')}</select></label>
<label class="field of_engine">light <select id="kind"></select></label>
<label class="field of_engine">filter <select id="filter"></select></label>
<label class="field" id="radius_field"><span id="radius_name">radius</span> <input type="number" id="radius" min="0" max="32" step="any" required></label>
<label class="field of_engine">texels of a map or cascade <select id="map_size">${sizes.map(size => option(size, size)).join('')}</select></label>
${number('width', 'it covers, world units', 0.001, 1e6, 'of_directional')}
${number('angle', 'cone from side to side, degrees', 1, 170, 'of_spot')}
${number('range', '<span id="range_words"></span>', 0.001, 1e6)}
<label class="field of_engine"><span>light over the floor, <span id="sun_degrees"></span></span> <input type="range" id="sun" min="2" max="85"></label>
</form>
<p id="notice" class="notice" role="status" hidden></p>
<div id="found">
<pre tabindex="0"><code id="code"></code></pre>
<div class="bar"><button type="button" class="main" id="copy">Copy</button> <button type="button" id="link">Copy link</button></div>
<div class="bias_pair">${picture('these', 'with these settings')}${picture('defaults', 'with the engine\'s defaults')}</div>
<p class="faint" id="scale"></p>
<div class="scroll" tabindex="0" role="region" aria-label="Table of these settings and the defaults"><table><thead><tr><td></td><th scope="col">these settings</th><th scope="col">the engine's defaults</th></tr></thead><tbody>
${row('settings', 'settings')}
${row('striped', 'planes that may stripe, by their tilt against the light')}
${row('all', 'falsely dark, on planes of all tilts')}
${row('floor', 'falsely dark, on this floor alone')}
${row('detachment', 'shadows are detached by up to')}
${row('edges', 'faces that are free beside their edges')}
</tbody></table></div>
<p>A lit face can be dark along its foot, where the filter sees the floor. A larger bias hides that, and detaches shadows.
Of a light with cascades, give the coarsest one. Settings in texels then suit all of them. Detachment under a spot light or point
light is that of the farthest receiver. Depths of 16 bits are coarse there, so a shorter range needs less bias.</p>
<h2>Where the formula is from</h2>
<p><span id="version"></span> does: <code id="formula"></code></p>
<ul id="sources"></ul>
<p>The pictures and the shares are emulations of it, with meshes that are drawn from both sides.
<a href="single_include/npm/engines.html">Limits, and the same in JavaScript</a>.</p>
</div>
<div id="no_numbers" hidden>
<h2>Measure your engine</h2>
<p>Without a public formula there is no number, but you can measure one.</p>
<ol>
<li>Turn off the light's filter. Let a straight edge cast a shadow on a floor, a few degrees off the map's axes.</li>
<li>Measure the height of the shadow's stair steps. That is a texel, in world units.</li>
<li>Raise a sheet over the floor, until it casts its whole shadow. Half that height is what your bias moves a receiver.</li>
<li>Set the bias, until that is the filter's reach times the texel. A filter of 3 x 3 texels reaches 2.8, one of 5 x 5 reaches 4.2.</li>
</ol>
</div>
</div>`;
