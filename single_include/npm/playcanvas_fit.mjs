// SPDX-License-Identifier: MIT
//
// PlayCanvas: shadowBias and normalOffsetBias of a light component for its map and filter. PlayCanvas fits the box itself.
//
//     import { fit_bias } from 'umbrage/playcanvas';
//     fit_bias(entity.light, { camera: viewer.camera });     // again when a field of view or the scene changes
import {
    ASPECT_AUTO, PROJECTION_PERSPECTIVE, SHADOW_PCF1_16F, SHADOW_PCF1_32F, SHADOW_PCF3_16F, SHADOW_PCF3_32F, SHADOW_PCF5_16F,
    SHADOW_PCF5_32F, SHADOW_PCSS_32F,
} from 'playcanvas';
import { bias_of_distances } from './bias.mjs';
import {
    depth_error, fit_cone, largest, longest, parallel_offset, perspective_offset, reach_of, roundings, snapping, solid,
} from './fit.mjs';
import { above_zero, check_numbers, check_options, check_places, must } from './options.mjs';

const where = 'playcanvas: fit_bias', kinds = { directional: 'directional', spot: 'spot', omni: 'point', point: 'point' };

/** The filters that this package's addon has given to PlayCanvas, by device and kind. */
export const in_use = new WeakMap();

/** Half widths in texels of PlayCanvas' own filters, and what a stored depth of each map is off by. */
const own_pcf = new Map([
    [SHADOW_PCF1_16F, [1, 2 ** -16]], [SHADOW_PCF3_16F, [2, 2 ** -16]], [SHADOW_PCF5_16F, [3, 2 ** -16]],
    [SHADOW_PCF1_32F, [1, depth_error]], [SHADOW_PCF3_32F, [2, depth_error]], [SHADOW_PCF5_32F, [3, depth_error]],
]);

/** normalOffsetBias and shadowBias end at 1. The latter moves a point light's receivers by 1/100 of its range then. */
const largest_bias = 1, share_of_range = 0.01;
/** What PlayCanvas takes off each receiver's depth under a directional light. */
const built_in = 1e-4;

const is_entity = value => typeof value?.findComponents === 'function';
const known = {
    camera: ['the camera component of an entity', value => typeof value?.calculateAspectRatio === 'function'],
    receivers: ['an entity of PlayCanvas, or an array of them',
        value => [value].flat().length > 0 && [value].flat().every(is_entity)],
};

/** What a light's numbers must be, of those that its kind has. */
const degrees = most => [`degrees above 0 and below ${most}`, value => value > 0 && value < most];
const numbers_of_light = {
    directional: { numCascades: ['an integer from 1 to 4', value => [1, 2, 3, 4].includes(value)],
        cascadeDistribution: ['a number from 0 to 1', value => value >= 0 && value <= 1] },
    spot: { range: above_zero, outerConeAngle: degrees(90) },
    point: { range: above_zero },
};

/** What a camera's numbers must be, of those that its projection has. */
function check_camera(camera, { shadowDistance }) {
    const perspective = camera.projection === PROJECTION_PERSPECTIVE, auto = camera.aspectRatioMode === ASPECT_AUTO, { nearClip } = camera;
    const beyond = [`a finite number above nearClip, ${nearClip}`, value => Number.isFinite(value) && value > nearClip];
    check_numbers(where, 'camera', camera, { nearClip: above_zero, farClip: beyond, ...(perspective ? { fov: degrees(180) } : { orthoHeight: above_zero }),
        ...(!auto && { aspectRatio: above_zero }) });
    check_numbers(where, 'light', { shadowDistance }, { shadowDistance: beyond });
}

/** Texels that a tile of the clusters' atlas leaves free around a spot light's map, and around each face of a point light. */
const free_of_tile = { spot: 4, point: 3 };

const array_of = ({ x, y, z }) => [x, y, z], identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

/** Solids of what is drawn under entities. */
const solids = entities => [entities].flat().flatMap(entity => entity.findComponents('render'))
    .filter(({ enabled, entity }) => enabled && entity.enabled).flatMap(render => render.meshInstances)
    .map(({ aabb }) => solid(array_of(aabb.getMin()), array_of(aabb.getMax()), identity));

/** Half the widths of the squares that PlayCanvas puts around the parts of the camera's frustum, one for each cascade. */
function half_widths({ numCascades: count, cascadeDistribution, shadowDistance }, camera) {
    const { nearClip, farClip, fov, horizontalFov, orthoHeight, projection, aspectRatioMode, renderTarget } = camera;
    const aspect = aspectRatioMode === ASPECT_AUTO ? camera.calculateAspectRatio(renderTarget) : camera.aspectRatio;
    const tangent = Math.tan(fov * Math.PI / 360) / (horizontalFov ? aspect : 1), end = Math.min(farClip, shadowDistance);
    const splits = Array.from({ length: count + 1 }, (_, i) => {
        const even = nearClip + (end - nearClip) * i / count, growing = nearClip * (end / nearClip) ** (i / count);
        return even + (growing - even) * cascadeDistribution;
    });
    const height = depth => (projection === PROJECTION_PERSPECTIVE ? depth * tangent : orthoHeight);
    return splits.slice(1).map((far, i) => Math.max(...[splits[i], far].map(
        depth => Math.hypot(height(depth), height(depth) * aspect, (far - splits[i]) / 2))));
}

/** Texels of a light's map or face, and its shadow type. Under clusters both are those of its tile in their atlas, which the first
 *  frame gives it. */
function map_of({ shadowResolution: size, shadowType: type, light, system: { app: { scene } } }, kind) {
    if (kind === 'directional' || !scene.clusteredLightingEnabled) return { size, type };
    must(where, light.atlasViewportAllocated, 'light must have a tile of the shadow atlas: enable castShadows and draw a frame before', 'none');
    const { shadowAtlasResolution, shadowType } = scene.lighting, tile = shadowAtlasResolution * light.atlasViewport.z;
    return { size: Math.floor(tile / (kind === 'point' ? 3 : 1)) - 2 * free_of_tile[kind], type: shadowType, clustered: true };
}

/** The filter in use: its reach in texels, for a point light's cube by how much of its distance a point moves, and what its
 *  map's depths are off by. undefined: no bias frees it. */
function filter_of({ system }, { size, type, clustered }, kind) {
    const { pcf, pcss } = in_use.get(system.app.graphicsDevice) ?? {}, radius = ours => reach_of(ours.filter, ours.given.all);
    if (type === SHADOW_PCSS_32F && pcss && kind === 'directional') return { reach: [radius(pcss), 0], error: depth_error };
    if (!own_pcf.has(type)) return undefined;
    const [width, error] = own_pcf.get(type);
    if (kind === 'point' && !clustered) return { reach: [Math.SQRT2, width > 1 ? Math.sqrt(3) / size : 0], error };
    return { reach: [pcf && width > 1 ? radius(pcf) : width * Math.SQRT2, 0], error };
}

/** What lights of each kind need: texels of the map in world units, normalOffsetBias, shadowBias, and the detachment. */
const needs = {
    directional(light, { camera }, { reach, error }, { points, size }) {
        const texels = half_widths(light, camera).map(half => 2 * half / (size * (light.numCascades > 1 ? 0.5 : 1)));
        const sides = [0, 1, 2].map(axis => largest(points, p => p[axis]) + largest(points, p => -p[axis])), range = Math.hypot(...sides);
        const offset = parallel_offset(reach[0], Math.max(...texels), range, points) + range * Math.max(error - depth_error, 0);
        return { texels, offset, bias: 0, detachment: offset + built_in * range };
    },
    /** The planes are a thousandth of the light's range, and its range. */
    spot(light, _, { reach, error }, { receivers, position, magnitude, size }) {
        const { entity, range } = light, tangent = Math.tan(light.outerConeAngle * Math.PI / 180);
        const cone = fit_cone({ position, axes: [entity.right, entity.forward, entity.up].map(array_of), receivers, casters: receivers,
            size: [size, size], reach: reach[0], tangents: [tangent, tangent], distance: range, narrow: false });
        must(where, cone !== undefined, `the light's map must be larger for a filter that reaches ${reach[0].toFixed(1)} texels`, size);
        const offset = perspective_offset((reach[0] + snapping) * 2 * tangent / size, cone.depth, { near: range / 1000, far: range },
            Math.hypot(1, tangent, tangent), error + roundings * magnitude / cone.depth) + roundings * magnitude;
        return { texels: [cone.texel], offset, bias: 0, detachment: offset };
    },
    point({ range }, _, { reach, error }, { points, position, magnitude, size }) {
        const farthest = Math.min(range, largest(points, p => Math.hypot(...p.map((value, i) => value - position[i]))));
        const radius = (reach[0] + snapping) * 2 / size + reach[1] + (range * error + roundings * magnitude) / farthest;
        const { factor, depth, detachment } = bias_of_distances(radius, farthest, range * share_of_range * largest_bias);
        return { texels: [2 * farthest / size], offset: factor, bias: depth / (range * share_of_range), detachment };
    },
};

/** Sets shadowBias and normalOffsetBias of a light for its filter. */
export function fit_bias(light, options = {}) {
    const kind = kinds[light?.type], app = light?.system?.app;
    must(where, kind && app?.root, 'light must be the light component of an entity in an app', light?.type ?? light);
    check_options(where, options, known);
    must(where, kind !== 'directional' || options.camera, 'camera must be given for a directional light', options.camera);
    const receivers = solids(options.receivers ?? app.root), points = receivers.flat(), position = array_of(light.entity.getPosition());
    must(where, points.length > 0, 'receivers must have an enabled render component', 'none');
    check_places(where, 'receivers', points);
    check_places(where, 'light', [position]);
    check_numbers(where, 'light', light, numbers_of_light[kind]);
    if (kind === 'directional') check_camera(options.camera, light);
    const map = map_of(light, kind), { size, clustered } = map, filter = filter_of(light, map, kind), magnitude = Math.max(largest(points, longest), longest(position));
    check_numbers(where, 'map', { size }, { size: above_zero });
    const needed = needs[kind](light, options, filter ?? { reach: [0, 0], error: depth_error },
        { receivers, points, position, magnitude, size });
    const half = clustered ? 1 + 2 ** -10 : 1, offset = needed.offset * half, bias = needed.bias * half;  // clusters have floats of 16 bits
    const { texels } = needed, detachment = needed.detachment * half;
    if (filter) Object.assign(light, { shadowBias: bias, normalOffsetBias: Math.min(offset, largest_bias) });
    const cascades = kind === 'directional' && { cascades: texels.map(texel => ({ texels_per_unit: 1 / texel })) };
    return { texels_per_unit: 1 / Math.max(...texels), detachment: filter && detachment,
        reach: filter && filter.reach[0] + filter.reach[1] * size * Math.sqrt(3) / 2,
        normal_offset_bias: light.normalOffsetBias, shadow_bias: light.shadowBias, bias_is_set: filter !== undefined,
        lacks: filter && Math.max(offset - largest_bias, 0), ...cascades };
}
