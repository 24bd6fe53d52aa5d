// SPDX-License-Identifier: MIT
//
// Words of the page that checks a shader: names under which the search finds it, and the slips that it explains.

export const known_as = [
    'check a shader, is my shader right, what is wrong with my shader',
    'shader unit test, test a shader online, compare my shader',
    'paste a shader, identify a PCF',
];

/// By the words of check::finding: the slip, what it is, and where it is explained. `exhibit`: words of that exhibit of
/// MUSEUM.md, whose title and number may change.
export const slips = {
    shift: {
        name: 'shifted by half a texel, or by one',
        words: 'Texel centers are at half texels. A filter without that half texel moves the shadow.',
        exhibit: 'subtracts the half texel',
    },
    flip: {
        name: 'upside down or mirrored',
        words: 'OpenGL has the first row at the bottom, Direct3D, Metal and WebGPU at the top.',
        exhibit: '`texture_origin` is part of',
    },
    swap: {
        name: 'x and y exchanged',
        words: 'A row was taken for a column, often in a matrix.',
        exhibit: 'transpose(M) * vec4',
    },
    z_range: {
        name: 'depth of another range',
        words: 'Depth from -1 to 1 was used as from 0 to 1, or halved twice.',
        exhibit: '`texture_matrix` reads it',
    },
    direction: {
        name: 'compared in the other direction',
        words: 'Reversed depth needs the other comparison.',
        exhibit: 'every filter takes `greater_equal`',
    },
    strict: {
        name: 'dark where the depths are equal',
        words: 'A receiver at the stored depth is lit here. With < for <=, flat surfaces flicker.',
        page: ['troubleshooting.html#1-shadow-acne', 'Shadow acne'],
    },
    bias: {
        name: 'a bias inside',
        words: 'The receiver is moved before it is compared. With the wrong sign, all surfaces get acne.',
        page: ['reference/bias/', 'Bias'],
    },
    in_shadow: {
        name: '1 in shadow',
        words: 'Tutorials often return the shadow, which is 1 - visibility.',
        page: ['reference/filter/', 'Choose a filter'],
    },
    base: {
        name: 'base 255 for 256, or the reverse',
        words: 'Packing and unpacking need the same base.',
        exhibit: '`encode_base255_repaired` writes digits',
    },
    truncation: {
        name: 'truncated',
        words: 'A store or a read that truncates loses a step.',
        exhibit: '`to_unorm` aims a quarter',
    },
    channels: {
        name: 'channels in another order',
        words: 'The most significant channel is first in one and last in the other.',
        exhibit: 'each format has its own name',
    },
    edges: {
        name: 'another answer at the edges',
        words: 'Outside of the map, or of depths from 0 to 1, a function can differ without being wrong.',
        page: ['troubleshooting.html#7-seams', 'Seams'],
    },
    nan: {
        name: 'another answer for NaN',
        words: 'What comes of a NaN differs from GPU to GPU.',
        exhibit: '`saturate` makes NaN',
    },
    beyond_far: {
        name: 'beyond the far plane',
        words: 'Nothing can be drawn behind the far plane, so nothing there is in shadow.',
        page: ['troubleshooting.html#3-everything-is-dark', 'Everything is dark'],
    },
    weights: {
        name: 'weights of a sampler',
        words: 'A sampler that filters has weights of few bits, usually 8.',
        page: ['tests/#what-is-not-promised', 'What is not promised'],
    },
    rounding: {
        name: 'rounded otherwise',
        words: 'A sum in another order, or a division, has another last bit.',
        page: ['tests/#why-tier-a-can-be-exact', 'Why tier A can be exact'],
    },
};
