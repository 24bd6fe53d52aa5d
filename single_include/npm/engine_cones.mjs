// SPDX-License-Identifier: MIT
//
// Bias of spot lights and point lights in engines that fit their own shadow maps: what engines.mjs is for directional lights.
//
// A map's texel grows with depth: it is unit wide at depth 1. A receiver is moved to depth z' there, and its plane, as casters
// have it, moves too: `height` is how far above that plane it then lies, along the normal n. The farthest texel of a filter is
// r units away, where the plane is nearer by r z' |n across the map's axis|. Stored depths are wrong by e, which is e cos t /
// cos a along the normal, t between normal and light, a between light and axis. So a plane is free of acne where
//
//     height >= r z' |n across the axis| + e cos t / cos a
//
// Away from the axis a plane that faces the light has a slope in the map, too: what moves by sin t alone does not serve it.
import { dot, roundings, snapping } from './fit.mjs';

const scaled = (vector, factor) => vector.map(value => value * factor);
const sum = (...vectors) => vectors.reduce((all, vector) => all.map((value, i) => value + vector[i]));
const axis = [0, 0, 1], sixteen_bits = 2 ** -16, nearest = 1 / 8;  // of the farthest receiver's depth: settings serve what lies between

/** Edge of a projection's depths: a receiver at depth z has scale / z, and a constant. */
const scale_of = (near, far) => near * far / (far - near);

/** What the nearest of 16 bits is off by, in world units. Coordinates round as they are far from the origin. */
const error_of = ({ depth, scale, extent }) => (sixteen_bits / 2 * depth + roundings * extent) * depth / scale;

/** Unity's rasterizer adds texels' slope to casters: the larger of both axes, of which a diagonal has the least. */
const unity_slope = 2.5;

const filament_defaults = { normalBias: 1, constantBias: 0.001, polygonOffsetSlope: 2, polygonOffsetConstant: 0.5 };

/** Each engine: of which lights it has numbers, the near plane, and
 *    initial   of its settings for a kind of light, and most: the largest value, where there is one
 *    error     of a stored depth, world units along the map's axis
 *    numbers   settings that free all planes; offset serves a plane along the axis, secant is that of the widest angle between
 *              light and axis
 *    moves     as in engines.mjs; a plane has its receiver's depth and distance to the light
 *    texel     that its filters by world units take, whatever the light
 *    cube      of an engine that looks a cube up: its filters' points are shares of the distance apart, across the ray, scale times
 *              their coordinates; the farthest by filter. A cube's corners see that sqrt(3) times */
export const cones = {
    godot: {
        initial: { spot: { shadow_normal_bias: 1, shadow_bias: 0.03 } },
        most: 10,
        near: range => Math.min(0.025, range / 2),
        formula: 'receiver + normal * shadow_normal_bias * 10 / map size * distance * (1 - normal . light); clip z + shadow_bias / 100 * blur',
        sources: ['servers/rendering/renderer_rd/storage_rd/light_storage.cpp', 'servers/rendering/renderer_scene_cull.cpp',
            'servers/rendering/renderer_rd/shaders/scene_forward_lights_inc.glsl'],
        error: error_of,
        numbers({ offset, error, depth, scale, size, blur }) {
            const share = (offset + error) / depth;  // of the distance, by which the clip bias moves towards the light
            return { shadow_normal_bias: offset / depth * size / 10, shadow_bias: share / (1 - share) * scale / blur * 100 };
        },
        moves({ shadow_normal_bias, shadow_bias }, { scale, size, blur }, { normal, to_light, cosine, distance }) {
            const bias = shadow_bias / 100 * blur;
            return { receiver: sum(scaled(normal, shadow_normal_bias * 10 / size * distance * (1 - cosine)),
                scaled(to_light, distance * bias / (scale + bias))) };
        },
    },
    unity_urp: {
        initial: { spot: { depthBias: 1, normalBias: 1 }, point: { depthBias: 1 } },
        most: 10,
        near: range => Math.min(0.2, range / 2),
        formula: 'caster - (light * depthBias + normal * (1 - normal . light) * normalBias) * kernel * texel at half the range, and 2.5 texels of slope; point lights have no normalBias',
        sources: ['Packages/com.unity.render-pipelines.universal/Runtime/ShadowUtils.cs', 'ShaderLibrary/Shadows.hlsl there'],
        error: error_of,
        numbers({ kind, offset, error, secant, depth, unit, range, filter: { kernel } }) {
            const texel = unit * range / 2, left = Math.max(offset - unity_slope * Math.SQRT1_2 * unit * depth, 0);
            return { depthBias: (offset + error * secant) / (kernel * texel), ...kind === 'spot' && { normalBias: left / (kernel * texel) } };
        },
        by_slope: true,
        moves({ depthBias, normalBias = 0 }, { unit, range, filter: { kernel } }, { normal, to_light, cosine, depth, slope }) {
            const texel = unit * range / 2, along = depthBias * kernel * texel + unity_slope * slope * unit * depth;
            return { caster: sum(scaled(to_light, -along), scaled(normal, -normalBias * (1 - cosine) * kernel * texel)) };
        },
    },
    bevy: {
        initial: { spot: { shadow_normal_bias: 1.8, shadow_depth_bias: 0.02 }, point: { shadow_normal_bias: 0.6, shadow_depth_bias: 0.08 } },
        near: () => 0.1,
        formula: 'receiver + normal * shadow_normal_bias * sqrt(2) * texel at the receiver\'s depth + light * shadow_depth_bias',
        sources: ['crates/bevy_pbr/src/render/shadows.wesl', 'crates/bevy_pbr/src/render/shadow_sampling.wesl',
            'crates/bevy_pbr/src/render/light.rs'],
        error: ({ depth, extent }) => (depth + extent) * roundings,  // reversed floats, of positions from the light
        texel: 0.0134277345,
        cube: { scale: 0.003, farthest: { Gaussian: 0.875 * Math.SQRT2, Temporal: 0.5, Hardware2x2: 0 } },
        numbers: ({ offset, error, secant, depth, unit }) =>
            ({ shadow_normal_bias: offset / (Math.SQRT2 * unit * depth), shadow_depth_bias: error * secant }),
        moves: ({ shadow_normal_bias, shadow_depth_bias }, { unit }, { normal, to_light, depth }) => ({ receiver:
            sum(scaled(normal, shadow_normal_bias * Math.SQRT2 * unit * depth), scaled(to_light, shadow_depth_bias)) }),
    },
    filament: {
        initial: { spot: filament_defaults, point: filament_defaults },
        near: () => 0.01,
        formula: 'receiver + normal * sin(normal, light) * normalBias * texel / 2 at the receiver\'s depth; the light\'s camera moves back by constantBias, casters by polygonOffsetSlope texels of slope',
        sources: ['filament/src/ShadowMapManager.cpp', 'filament/src/ShadowMap.cpp', 'shaders/src/common_shadowing.glsl',
            'shaders/src/surface_shadowing.fs'],
        error: error_of,
        // the slope serves what faces the light away from the axis, a normal bias edges; a step of depth grows as its error
        numbers: ({ offset, depth, unit, extent }) => ({ normalBias: 2 * offset / (unit * depth), constantBias: 0,
            polygonOffsetSlope: Math.SQRT2 * offset / (unit * depth), polygonOffsetConstant: 0.5 + roundings * extent / (sixteen_bits * depth * nearest) }),
        moves({ normalBias, constantBias, polygonOffsetSlope, polygonOffsetConstant }, { unit, scale }, { normal, to_light, cosine, depth, slope }) {
            const along = polygonOffsetSlope * slope * unit * depth + polygonOffsetConstant * sixteen_bits * depth * depth / scale / to_light[2];
            return { receiver: scaled(normal, normalBias / 2 * unit * depth * Math.sqrt(Math.max(1 - cosine * cosine, 0))),
                caster: sum(scaled(axis, -constantBias), scaled(to_light, -along)) };
        },
    },
};

/** A spot or point light as formulas see it.
 *  @param angle   of a spot light's cone from side to side, degrees; a point light's maps have 90
 *  @return        undefined: the map has too few texels for the filter */
export function cone_of(facts, { light: kind, map_size, range, angle = 90, distance = range, near, extent, filter, reach, blur, border }) {
    const tangent_of_half = Math.tan(angle * Math.PI / 360), size = map_size - 2 * border, unit = 2 * tangent_of_half / size;
    const tangent = kind === 'point' ? Math.SQRT2 : tangent_of_half, secant = Math.hypot(1, tangent);  // a cube's corners are farthest off
    const depth = Math.min(distance, range), scale = scale_of(near ?? facts.near(range), range);
    const light = { kind, size, unit, range, depth, scale, secant, tangent, extent: Math.max(extent, depth), filter, blur };
    const own = facts.cube && kind === 'point' ? Math.SQRT2 + facts.cube.farthest[filter.name] * facts.cube.scale * Math.sqrt(3) * size / 2 : reach;
    const r = (own + snapping) * unit;
    if (r > 0.125) return undefined;
    return { ...light, reach: own, r, offset: r * depth / (1 - 2 * r), error: facts.error(light) };
}

const degrees = Math.PI / 180;
const turned = ([x, y, z], tilt, turn) => {  // a direction that is tilt away from (x, y, z)
    const side = Math.abs(z) < 0.9 ? [-y, x, 0] : [z, 0, -x], length = Math.hypot(...side), a = scaled(side, 1 / length);
    const b = [y * a[2] - z * a[1], z * a[0] - x * a[2], x * a[1] - y * a[0]];
    return sum(scaled([x, y, z], Math.cos(tilt)), scaled(a, Math.sin(tilt) * Math.cos(turn)), scaled(b, Math.sin(tilt) * Math.sin(turn)));
};

/** Directions to the light that a map has: along its axis, and up to its widest angle, along a row and a diagonal. */
const rays_of = ({ tangent }) => [0, 0.5, 1].flatMap(part => [0, Math.PI / 4].map(turn => {
    const along = part * tangent, length = Math.hypot(1, along);
    return [along * Math.cos(turn) / length, along * Math.sin(turn) / length, 1 / length];
}));

/** What settings do to planes of all tilts, whose receivers are as far as any, or nearer. */
export function judged_in_cone(facts, settings, light) {
    const { r, unit, offset, secant } = light, rays = rays_of(light), texel = unit * light.depth;
    const depths = [1, 0.5, 0.25, nearest].map(part => part * light.depth);
    const errors = depths.map(depth => facts.error({ ...light, depth }));
    const height_of = (to_light, normal, i) => {
        const depth = depths[i], cosine = dot(normal, to_light), slope = Math.max(Math.abs(normal[0]), Math.abs(normal[1])) / cosine;
        const plane = { normal, to_light, cosine, slope, depth, distance: depth / to_light[2] };
        const { receiver = [0, 0, 0], caster = [0, 0, 0] } = facts.moves(settings, light, plane);
        const lacks = (depth - receiver[2]) * r * Math.hypot(normal[0], normal[1]) + errors[i] * cosine / to_light[2];
        const height = dot(normal, receiver) - dot(normal, caster);
        return [height, lacks - height];
    };
    let lacking = 0, detachment = 0, striped;
    for (let tilt = 0; tilt <= 89; ++tilt) {
        let most = 0;
        for (const to_light of rays)
            for (let turn = 0; turn < 8; ++turn) {
                const normal = turned(to_light, tilt * degrees, turn * Math.PI / 4);
                for (let i = 0; i < depths.length; ++i) {
                    const [height, lacks] = height_of(to_light, normal, i);
                    detachment = Math.max(detachment, height);
                    most = Math.max(most, lacks);
                }
            }
        if (most <= 1e-9 * texel) continue;
        lacking = Math.max(lacking, most);
        striped = [striped?.[0] ?? tilt, tilt];
    }
    const edges = facts.by_slope ? Math.atan(Math.max(height_of(rays[0], rays[0], 0)[0] - errors[0] * secant, 0) / offset) / degrees : 90;
    return { settings, detachment, lacking: lacking / texel, edges, ...striped && { striped } };
}
