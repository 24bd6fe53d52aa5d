// SPDX-License-Identifier: MIT
//
// Bias of lights in engines that fit their own shadow maps: numbers for the settings that they have. Directional lights are in
// here, spot lights and point lights in engine_cones.mjs.
//
//     import { engine_bias } from 'umbrage/engines';
//     engine_bias({ engine: 'godot', map_size: 2048, width: 40, range: 100 }).settings;
//
// An engine moves a receiver, or the triangles that cast, before it compares depths: `moves`. On a plane that is tilted by t
// against the light, the receiver then lies `height` above the plane, along its normal. The farthest texel of a filter is r
// texels away, where the plane is r texel tan t nearer to the light: r texel sin t along the normal. Rounding by e along the
// light is e cos t there. So a plane is free of acne where
//
//     height(t) >= r texel sin t + e cos t
import { cone_of, cones, judged_in_cone } from './engine_cones.mjs';
import { dot, parallel_parts } from './fit.mjs';
import { above_zero, check_options, must } from './options.mjs';

const where = 'engines: engine_bias';

/** A disc of rotated points, each of which compares four texels; the farthest point lies at `farthest`. Or a square of texels
 *  around the receiver. */
const disc = (points, radius, farthest = radius * Math.sqrt(1 - 0.5 / points)) => ({ points, radius, farthest });
const square = half => ({ half });
const sixteen_bits = 2 ** -16;

/** Along-light part of Godot's bias that its sideways part leaves: the largest tan t (1 - sin t), at the golden ratio. */
const left_by_sideways = ((Math.sqrt(5) - 1) / 2) ** 2.5;

/** Texels' slope that Unity's rasterizer adds to casters: the larger of both axes, of which a diagonal has the least. */
const unity_slope = 2.5;

const scaled = (vector, factor) => vector.map(value => value * factor);
const sum = (...vectors) => vectors.reduce((all, vector) => all.map((value, i) => value + vector[i]));

/** Each engine: where its formula is, its filters (the first is its default), its settings with defaults and the largest
 *  value that they take, and:
 *    moves     vectors by which settings move a receiver, or the triangle of a caster. The plane has a normal, to_light (both
 *              of length 1), their cosine, and slope: of its depth, along that of the map's axes where it is larger
 *    numbers   settings that free all planes; offset is (r + snapping) texel
 *    by_slope  whether a caster moves by its own slope, so that the face beside a steep one moves by less */
export const engines = {
    three: {
        title: 'three.js',
        version: 'r182 to r187, WebGL',
        sources: ['src/renderers/shaders/ShaderChunk/shadowmap_vertex.glsl.js', 'shadowmap_pars_fragment.glsl.js, of r187'],
        formula: 'receiver + normal * normalBias; bias is added to its depth',
        filters: { PCFShadowMap: disc(5, 1), BasicShadowMap: square(0.5) },
        radius: 'light.shadow.radius',
        settings: { normalBias: { initial: 0 }, bias: { initial: 0 } },
        numbers: ({ offset, error }) => ({ normalBias: offset + error, bias: 0 }),
        moves: ({ normalBias, bias }, { range }, { normal, to_light }) =>
            ({ receiver: sum(scaled(normal, normalBias), scaled(to_light, -bias * range)) }),
    },
    godot: {
        title: 'Godot 4',
        version: 'Forward+, commit 006f0390',
        sources: ['servers/rendering/renderer_rd/storage_rd/light_storage.cpp', 'servers/rendering/renderer_scene_cull.cpp',
            'servers/rendering/renderer_rd/shaders/forward_clustered/scene_forward_clustered.glsl'],
        formula: 'receiver + (normal - light (normal . light)) * shadow_normal_bias * texel + light * shadow_bias / 100 * range * blur',
        filters: { 'Soft Low': disc(4, 2), Hard: square(1), 'Soft Very Low': disc(1, 1.5), 'Soft Medium': disc(8, 2),
            'Soft High': disc(16, 3), 'Soft Ultra': disc(32, 4) },
        radius: 'shadow_blur',
        stored: sixteen_bits,
        settings: { shadow_normal_bias: { initial: 2, most: 10 }, shadow_bias: { initial: 0.1, most: 10 } },
        numbers({ offset, error, texel, range, blur }) {
            const sideways = Math.min(offset, 10 * texel), tilt = 75 * Math.PI / 180;  // beyond, a slider that ends too early has lost
            const along = Math.max(left_by_sideways * offset, Math.tan(tilt) * (offset - sideways * Math.sin(tilt)));
            return { shadow_normal_bias: sideways / texel, shadow_bias: (along + error) / (range * blur) * 100 };
        },
        moves({ shadow_normal_bias, shadow_bias }, { texel, range, blur }, { normal, to_light, cosine }) {
            const sideways = sum(normal, scaled(to_light, -cosine));
            return { receiver: sum(scaled(sideways, shadow_normal_bias * texel), scaled(to_light, shadow_bias / 100 * range * blur)) };
        },
    },
    unity_urp: {
        title: 'Unity URP',
        version: '17, commit 00706100',
        sources: ['Packages/com.unity.render-pipelines.universal/Runtime/ShadowUtils.cs', 'ShaderLibrary/Shadows.hlsl there'],
        formula: 'caster - (light * depthBias + normal * (1 - normal . light) * normalBias) * kernel * texel, and 2.5 texels of slope',
        filters: { 'Soft Medium': { ...square(3), kernel: 2.5 }, Hard: { ...square(1), kernel: 1 },
            'Soft Low': { ...square(1.5), kernel: 1.5 }, 'Soft High': { ...square(4), kernel: 3.5 } },
        stored: sixteen_bits,
        settings: { depthBias: { initial: 1, most: 10 }, normalBias: { initial: 1, most: 10 } },
        numbers({ offset, error, texel, filter: { kernel } }) {  // the depth bias serves edges up to 45 degrees
            const left = Math.max(offset - unity_slope * Math.SQRT1_2 * texel, 0);
            return { depthBias: (offset + error) / (kernel * texel), normalBias: left / (kernel * texel) };
        },
        by_slope: true,
        moves({ depthBias, normalBias }, { texel, filter: { kernel } }, { normal, to_light, cosine, slope }) {
            const along = depthBias * kernel * texel + unity_slope * slope * texel;
            return { caster: sum(scaled(to_light, -along), scaled(normal, -normalBias * (1 - cosine) * kernel * texel)) };
        },
    },
    bevy: {
        title: 'Bevy',
        version: '0.20.0-dev, commit 4805ca79',
        sources: ['crates/bevy_pbr/src/render/shadows.wesl', 'crates/bevy_pbr/src/render/shadow_sampling.wesl',
            'crates/bevy_pbr/src/render/light.rs'],
        formula: 'receiver + normal * shadow_normal_bias * sqrt(2) * texel + light * shadow_depth_bias',
        filters: { Gaussian: square(3), Hardware2x2: square(1),
            // a spiral, whose width in the world grows by a line in the texel's
            Temporal(texel) {
                const radius = (0.015 + (texel - 0.00390625) * 0.02 / (0.022949219 - 0.00390625)) / texel;
                return { ...disc(8, radius, radius), spiral: true };
            } },
        settings: { shadow_normal_bias: { initial: 1.8 }, shadow_depth_bias: { initial: 0.02 } },
        numbers: ({ offset, error, texel }) => ({ shadow_normal_bias: offset / (Math.SQRT2 * texel), shadow_depth_bias: error }),
        moves: ({ shadow_normal_bias, shadow_depth_bias }, { texel }, { normal, to_light }) => ({ receiver:
            sum(scaled(normal, shadow_normal_bias * Math.SQRT2 * texel), scaled(to_light, shadow_depth_bias)) }),
    },
    filament: {
        title: 'filament',
        version: 'commit 003e5005, ShadowType PCF, lispsm off',
        sources: ['filament/src/ShadowMapManager.cpp', 'filament/src/ShadowMap.cpp', 'shaders/src/common_shadowing.glsl',
            'shaders/src/surface_shadowing.fs'],
        formula: 'receiver + normal * sin(normal, light) * normalBias * texel / 2; the light\'s camera moves back by constantBias, casters by polygonOffsetSlope texels of slope',
        filters: { PCF: square(2) },
        border: 1,
        stored: sixteen_bits,
        settings: { normalBias: { initial: 1 }, constantBias: { initial: 0.001 }, polygonOffsetSlope: { initial: 2 }, polygonOffsetConstant: { initial: 0.5 } },
        // an offset by slope fails beside edges, and would only detach what normalBias frees
        numbers: ({ offset, error, texel }) =>
            ({ normalBias: 2 * offset / texel, constantBias: error, polygonOffsetSlope: 0, polygonOffsetConstant: 0 }),
        moves({ normalBias, constantBias, polygonOffsetSlope, polygonOffsetConstant }, { texel, range }, { normal, to_light, cosine, slope }) {
            const along = constantBias + polygonOffsetSlope * slope * texel + polygonOffsetConstant * sixteen_bits * range;
            return { receiver: scaled(normal, normalBias / 2 * texel * Math.sqrt(Math.max(1 - cosine * cosine, 0))),
                caster: scaled(to_light, -along) };
        },
    },
};

const not_below_zero = ['a finite number, 0 or more', value => Number.isFinite(value) && value >= 0];
const known = {
    engine: [`one of ${Object.keys(engines).join(', ')}; engines.md says how to measure any other`, value => Object.hasOwn(engines, value)],
    map_size: ['an integer from 16 to 65536', value => Number.isInteger(value) && value >= 16 && value <= 65536],
    light: ['directional, spot or point', value => ['directional', 'spot', 'point'].includes(value)],
    width: above_zero,
    range: above_zero,
    angle: ['degrees above 0 and below 175', value => value > 0 && value < 175],
    distance: above_zero,
    near: above_zero,
    filter: ['a name', value => typeof value === 'string'],
    radius: not_below_zero,
    extent: not_below_zero,
};

/** Four digits, rounded up: what people copy must not be less than what is needed. */
function rounded_up(value) {
    if (!(value > 0 && value < Infinity)) return value;
    const digits = 10 ** (3 - Math.floor(Math.log10(value))), up = Math.ceil(value * digits * (1 - 1e-12)) / digits;
    return Number(up.toPrecision(4));
}

const nowhere = [0, 0, 0];

/** How far above a tilted plane its receivers are compared, along its normal.
 *  @param turn   of the plane's slope, from the map's x axis */
function height_of(engine, settings, light, tilt, turn) {
    const cosine = Math.cos(tilt), x = Math.sin(tilt) * Math.cos(turn), y = Math.sin(tilt) * Math.sin(turn);
    const plane = { normal: [x, y, cosine], to_light: [0, 0, 1], cosine, slope: Math.max(Math.abs(x), Math.abs(y)) / cosine };
    const { receiver = nowhere, caster = nowhere } = engine.moves(settings, light, plane);
    return dot(plane.normal, receiver) - dot(plane.normal, caster);
}

const degrees = Math.PI / 180, tilts = Array.from({ length: 357 }, (_, i) => i / 4);  // 0 to 89

/** What settings do to planes of all tilts. A slope along a diagonal needs the most, one along an axis may get the most. */
function judged(engine, settings, light) {
    const { texel, offset, error } = light;
    let lacking = 0, detachment = 0, striped;
    for (const tilt of tilts) {
        const height = turn => height_of(engine, settings, light, tilt * degrees, turn);
        const lacks = offset * Math.sin(tilt * degrees) + error * Math.cos(tilt * degrees) - height(Math.PI / 4);
        detachment = Math.max(detachment, height(0));
        if (lacks <= 1e-9 * texel) continue;
        lacking = Math.max(lacking, lacks);
        striped = [striped?.[0] ?? tilt, tilt];
    }
    const facing = height_of(engine, settings, light, 0, 0);  // what the next face has at least
    const edges = engine.by_slope ? Math.atan(Math.max(facing - error, 0) / offset) / degrees : 90;
    return { settings, detachment, lacking: lacking / texel, edges, ...striped && { striped } };
}

/** The filter that options name, with its own radius. */
function filter_of({ title, filters, radius: has_radius }, { filter: name = Object.keys(filters)[0], radius }, texel) {
    must(where, Object.hasOwn(filters, name), `filter must be one of ${Object.keys(filters).join(', ')}`, name);
    must(where, radius === undefined || has_radius, `radius must not be given for ${title}, whose filters have none`, radius);
    const made = filters[name], own = typeof made === 'function' ? made(texel) : made, scale = radius ?? 1;
    const filter = { name, ...own, ...own.points && { radius: own.radius * scale, farthest: own.farthest * scale } };
    const reach = filter.points ? filter.farthest + Math.SQRT2 : filter.half * Math.SQRT2;
    return { filter, reach, blur: filter.points ? filter.radius : scale };
}

function must_have(options, ...names) {
    for (const name of names) must(where, options[name] !== undefined, `${name} must be ${known[name][0]}`, undefined);
}

/** Refuses what a kind of light does not have. */
function must_not_have(options, kind, ...names) {
    for (const name of names) must(where, options[name] === undefined, `${name} must not be given for a ${kind} light`, options[name]);
}

/** A light as formulas see it: one place for what settings mean in it. */
export function light_of(options) {
    check_options(where, options, known);
    must_have(options, 'engine', 'map_size');
    const engine = engines[options.engine], { light: kind = 'directional', map_size, width, range } = options, { border = 0 } = engine;
    if (kind !== 'directional') return cone_light(engine, kind, options);
    must_have(options, 'width', 'range');
    must_not_have(options, kind, 'angle', 'distance', 'near');
    const { extent = width } = options, texel = width / (map_size - 2 * border), { filter, reach, blur } = filter_of(engine, options, texel);
    const [offset, error] = parallel_parts(reach, texel, range, [[extent, 0, 0]], engine.stored);
    return { texel, range, reach, offset, error, filter, blur };
}

function cone_light(engine, kind, options) {
    must_have(options, 'range', ...kind === 'spot' ? ['angle'] : []);
    must_not_have(options, kind, 'width', ...kind === 'point' ? ['angle'] : []);
    const facts = cones[options.engine], { range, distance = range, near, extent = range } = options;
    must(where, facts?.initial[kind], `light must be ${lights_of(options.engine).join(' or ')} for ${engine.title}`, kind);
    must(where, !(near >= distance), 'near must be below the distance', near);
    must(where, (near ?? facts.near(range)) < range, `range must be above the near plane, ${near ?? facts.near(range)}`, range);
    const light = cone_of(facts, { ...options, ...filter_of(engine, options, facts.texel ?? 1), extent, border: engine.border ?? 0 });
    must(where, light, 'map_size must be larger for this filter', options.map_size);
    return { ...light, texel: light.unit * light.depth };
}

/** Where the formula of an engine's light is, and what it says. */
export const formula_of = (engine, light) => (light === 'directional' ? engines : cones)[engine];

/** The lights of an engine that engine_bias has numbers for. */
export const lights_of = engine => ['directional', ...Object.keys(cones[engine]?.initial ?? {})];

/** Numbers for an engine's own settings, and what its defaults do. */
export function engine_bias(options = {}) {
    const light = light_of(options), engine = engines[options.engine], { kind } = light, facts = kind ? cones[options.engine] : engine;
    const all = kind ? Object.entries(facts.initial[kind]).map(([name, initial]) => [name, { initial, most: facts.most }]) : Object.entries(engine.settings);
    const numbers = facts.numbers(light), settings = {}, initial = {};
    for (const [name, { initial: value, most = Infinity }] of all) {
        settings[name] = Math.min(rounded_up(numbers[name]), most);
        initial[name] = value;
    }
    const judge = of => (kind ? judged_in_cone(facts, of, light) : judged(engine, of, light));
    return { ...judge(settings), texel: light.texel, reach: light.reach, defaults: judge(initial) };
}
