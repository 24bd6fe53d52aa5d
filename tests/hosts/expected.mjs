// SPDX-License-Identifier: MIT
//
// Of each page: its host, the flags that give a browser its API in software, filters that C++ computes again, and what
// the page must say. No set of flags gives WebGL and WebGPU together.
const webgl = ['--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist'];

const webgpu = ['--enable-unsafe-webgpu', '--enable-features=Vulkan', '--use-vulkan=swiftshader', '--use-angle=swiftshader'];
const three_webgpu = {
    host: 'three',
    filters: ['hard', 'castano_dyadic5', 'disc16', 'pcss16'],
    said: {
        moments: 'umbrage/three/webgpu: shadow_filter: filter must read depths through one coordinate; got ',
        other: 'glsl must be the same filter in GLSL; got pcss16',
        none: 'filter must be a filter of this package, such as pcss16; got undefined',
    },
};

const babylon = {
    host: '@babylonjs/core',
    filters: ['hard', 'castano_dyadic5', 'disc16', 'pcss16', 'castano_dyadic5.cascades', 'pcss16.cascades',
        'castano_dyadic5.reversed', 'pcss16.reversed', 'castano_dyadic5.spot', 'pcss16.spot'],
    said: { later: 'true', off: 'true', restored: 'true' },
};

const playcanvas = { host: 'playcanvas', filters: ['hard', 'disc16', 'pcss16'], said: { restored: 'true' } };

export const expected = {
    'three.html': {
        host: 'three',
        flags: webgl,
        filters: ['hard', 'castano_dyadic5', 'disc16', 'pcss16'],
        said: {
            restored: 'true',
            untouched: 'true',
            reversed: 'true',
            moments: 'umbrage/three: install: filter must read depths through one coordinate; got ',
            no_filter: 'umbrage/three: install: filter must be a filter of this package, such as pcss16; got pcss16',
            argument: 'arguments must be among (softness, rotation) of pcss16; got softnes',
            number: 'arguments.softness must be 3 finite numbers; got 1,2',
            renderer: 'renderer must be a WebGLRenderer of this copy of three.js; got Object',
            text: 'THREE must have the shadow shader of r182 or later; got another text of shadowmap_pars_fragment',
            old: 'THREE must be r182 or later; got 176',
        },
    },
    'babylon.html': { ...babylon, flags: webgpu },
    'babylon.html#webgl': { ...babylon, flags: webgl },
    'playcanvas.html': { ...playcanvas, flags: webgpu },
    'playcanvas.html#webgl': {
        ...playcanvas, flags: webgl,
        filters: [...playcanvas.filters, 'castano_dyadic5', 'castano_dyadic5.cascades', 'castano_dyadic5.spot'],
    },
    'three_webgpu.html': { ...three_webgpu, flags: webgpu, said: { ...three_webgpu.said, backend: 'webgpu' } },
    'three_webgpu.html#webgl': { ...three_webgpu, flags: webgl, said: { ...three_webgpu.said, backend: 'webgl' } },
};
