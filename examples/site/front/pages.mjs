// SPDX-License-Identifier: MIT
//
// The front page: what umbrage is, in one screen, and the way to each part.
import { page } from '../page.mjs';

const ways = [
    ['proof/', 'Prove it on your GPU', 'Every shader function runs here beside its C++ twin, and the page counts the bits that differ.'],
    ['snippets/', 'Copy a shader function', 'Search by the name you know. GLSL, HLSL, WGSL and Metal.'],
    ['reference/', 'Read the reference', 'Every function with its units, edge cases, formula and source.'],
    ['museum.html', 'Visit the museum of bugs', 'Public shadow bugs, each beside the formula that passes.'],
];

export async function pages(context) {
    context.copy('.media/hero.png', 'pictures/hero.png');
    const cards = ways.map(([to, name, words]) => `<li class="card"><h2><a href="${to}">${name}</a></h2><p>${words}</p></li>`);
    const body = `
<h1>Shadows that compute the same in C++ and in your shader</h1>
<p class="lead">umbrage is a header-only C++20 library of shadow mapping functions. Each has a shader twin, compared bit for bit.</p>
<p class="bar"><a class="button main" href="proof/">Prove it on your GPU</a> <a class="button" href="snippets/">Copy a shader function</a></p>
<img src="pictures/hero.png" width="1280" height="560" alt="A garden in sunlight. A mast's shadow is sharp at its foot and soft on a wall.">
<ul class="cards">${cards.join('')}</ul>`;
    return [{ path: 'index.html', html: page({
        path: 'index.html', title: 'Shadow mapping functions', body,
        description: 'Shadow mapping functions that return the same value in C++ and in your shader.' }) }];
}
