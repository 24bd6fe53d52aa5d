// SPDX-License-Identifier: MIT
//
// Of each page: its host, the flags that give a browser its API in software, filters that C++ must compute again besides all
// that the page sends, and what the page must say. No set of flags gives WebGL and WebGPU together.
const webgl = ['--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist'];

const webgpu = ['--enable-unsafe-webgpu', '--enable-features=Vulkan', '--use-vulkan=swiftshader', '--use-angle=swiftshader'];
const three_filters = ['hard', 'castano_dyadic5', 'disc16', 'pcss16', 'castano_dyadic5.spot', 'pcss16.spot'];
const three_webgpu = {
    host: 'three',
    filters: three_filters,
    said: {
        reversed: 'true',
        point: 'accepted',
        moments: 'umbrage/three/webgpu: shadow_filter: wgsl must read depths through one coordinate; got ',
        other: 'glsl must be the same filter in GLSL; got pcss16',
        none: 'wgsl must be a filter of this package, such as pcss16; got undefined',
    },
};

const babylon = {
    host: '@babylonjs/core',
    filters: ['hard', 'castano_dyadic5', 'disc16', 'pcss16', 'castano_dyadic5.cascades', 'pcss16.cascades',
        'castano_dyadic5.reversed', 'pcss16.reversed', 'castano_dyadic5.spot', 'pcss16.spot', 'castano_dyadic5.reversed_cascades',
        'pcss16.reversed_cascades', 'castano_dyadic5.reversed_spot', 'pcss16.reversed_spot'],
    said: { later: 'true', off: 'true', restored: 'true', soft_wrong: 'none' },
};

const playcanvas = {
    host: 'playcanvas',
    filters: ['hard', 'castano_dyadic5', 'disc16', 'pcss16', 'castano_dyadic5.cascades', 'pcss16.cascades', 'disc16.clustered',
        'disc16.clustered_point'],
    said: { restored: 'true' },
};
const playcanvas_pcss = 'umbrage/playcanvas: install: lights must be directional lights with SHADOW_PCSS_32F for pcss16; got ';

/** fit_shadow: nothing is falsely dark, and no caster is lost; with three.js' defaults all lights have stripes. Penumbras of
 *  set_light_size are as wide as rays have them. */
const fits = { host: 'three', filters: [],
    said: { wrong: 'none', striped: 'directional.default spot.default point.default', soft_wrong: 'none' } };

/** fit_bias: nothing is falsely dark but what it says, and no caster is lost; with the engine's defaults lights have stripes. */
const few = { filters: [], said: { wrong: 'none' } };  // for each change; tests/hosts/run tries all
const biases = { ...few, said: { ...few.said, striped: 'directional.default spot.default point.default cascades.default' } };

/** What users change after the first frame, a point light, and discs that rotate from frame to frame. */
const changes = { host: 'three', filters: [], said: { wrong: 'none', point: 'true', frames: '0 differ, noise in one' } };
const changes_webgpu = { ...changes, said: { ...changes.said, still: 'true', words: 'umbrage/three/webgpu: shadow_filter: the light must have '
    + "one map: a spot, a directional light or a SunLight; got a point light. It keeps three.js' own filter in place of castano_dyadic5." } };

/** Discs that rotate from frame to frame, and others that stand still. */
const stand = '0 differ, no noise in one: 0.00', turn = '0 differ, noise in one';
const babylon_turns = Object.entries({ still: stand, before: turn, frames: turn, frozen: turn, own: stand });
const babylon_frames = { host: '@babylonjs/core', filters: [],
    said: Object.fromEntries(['standard', 'pbr'].flatMap(half => babylon_turns.map(([name, words]) => [`${name}.${half}`, words]))) };
const playcanvas_frames = { host: 'playcanvas', filters: [], said: { still: stand, frames: turn, still_again: stand } };

export const expected = {
    babylon_frames: { ...babylon_frames, flags: webgpu },
    'babylon_frames#webgl': { ...babylon_frames, flags: webgl },
    playcanvas_frames: { ...playcanvas_frames, flags: webgpu },
    'playcanvas_frames#webgl': { ...playcanvas_frames, flags: webgl },
    three_changes: { ...changes, flags: webgl },
    three_webgpu_changes: { ...changes_webgpu, flags: webgpu },
    'three_webgpu_changes#webgl': { ...changes_webgpu, flags: webgl },
    three: {
        host: 'three',
        flags: webgl,
        filters: [...three_filters, 'castano_dyadic5.reversed', 'pcss16.reversed', 'castano_dyadic5.reversed_spot',
            'pcss16.reversed_spot'],
        said: {
            restored: 'true',
            untouched: 'true',
            later: 'true',
            'later.keyed': 'true',
            two_renderers: 'true',
            two_restored: 'true',
            reversed: 'true',
            moments: 'umbrage/three: install: filter must read depths through one coordinate; got ',
            no_filter: 'umbrage/three: install: filter must be a filter of this package, such as pcss16; got pcss16',
            argument: 'arguments must be among (softness) of pcss16; got softnes',
            number: 'arguments.softness must be 4 finite floats of 32 bits; got [1, 2]',
            renderer: 'renderer must be a WebGLRenderer of this copy of three.js; got an object',
            text: 'THREE must have the shadow shader of r182 or later; got another text of shadowmap_pars_fragment',
            old: 'THREE must be r182 or later; got 176',
        },
    },
    three_fit: { ...fits, flags: webgl },
    three_webgpu_fit: { ...fits, flags: webgpu },
    'three_webgpu_fit#webgl': { ...fits, flags: webgl },
    babylon_bias: { ...biases, host: '@babylonjs/core', flags: webgpu },
    'babylon_bias#webgl': { ...biases, host: '@babylonjs/core', flags: webgl },
    'babylon_bias#few': { ...few, host: '@babylonjs/core', flags: webgl },
    babylon: { ...babylon, flags: webgpu },
    'babylon#webgl': { ...babylon, flags: webgl },
    playcanvas_bias: { host: 'playcanvas', filters: [], flags: webgpu,
        said: { ...few.said, striped: 'directional.default cascades.default spot.clustered_default point.clustered_default' } },
    'playcanvas_bias#webgl': { ...biases, host: 'playcanvas', flags: webgl },
    'playcanvas_bias#few': { ...few, host: 'playcanvas', flags: webgl },
    playcanvas: { ...playcanvas, flags: webgpu },
    'playcanvas#webgl': {
        ...playcanvas, flags: webgl,
        filters: [...playcanvas.filters, 'castano_dyadic5.clustered', 'castano_dyadic5.clustered_point', 'castano_dyadic5.spot'],
        said: {
            ...playcanvas.said,
            soft_wrong: 'none',
            'hard.own.point.refused': 'SHADOW_PCF3_* or SHADOW_PCF5_* for hard; got omni with shadow type SHADOW_PCF3_32F',
            'hard.own.point.kept': 'true',
            'pcss16.own_pcss.spot.refused': `${playcanvas_pcss}spot with shadow type SHADOW_PCSS_32F`,
            'pcss16.own_pcss.spot.kept': 'true',
            'pcss16.own_pcss.point.refused': `${playcanvas_pcss}omni with shadow type SHADOW_PCSS_32F`,
            'pcss16.own_pcss.point.kept': 'true',
        },
    },
    three_webgpu: { ...three_webgpu, flags: webgpu, said: { ...three_webgpu.said, backend: 'webgpu' } },
    'three_webgpu#webgl': { ...three_webgpu, flags: webgl, said: { ...three_webgpu.said, backend: 'webgl' } },
};
