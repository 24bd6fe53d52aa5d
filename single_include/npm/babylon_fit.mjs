// SPDX-License-Identifier: MIT
//
// Babylon.js: bias and normalBias of a shadow generator for its map and filter, and its light's box and planes.
//
//     import { fit_bias } from 'umbrage/babylon';
//     fit_bias(generator);     // again when things move
import { bias_of_casters } from './bias.mjs';
import { depth_error, dot, fit_cone, fit_cube, fit_parallel, parallel_offset, reach_of, solid } from './fit.mjs';
import { above_zero, check_numbers, check_options, check_places, flag, must } from './options.mjs';

const where = 'babylon: fit_bias', kinds = ['point', 'directional', 'spot'];  // by Light.getTypeID
const filters = { none: 0, poisson: 2, pcf: 6, pcss: 7 }, half_float = 2;  // ShadowGenerator.FILTER_*; of a texture's type
const own_pcf = [3, 2, 1];  // half widths in texels, by filteringQuality
const poisson_radius = Math.hypot(0.94558609, 0.76890725);  // of the farthest of four points

/** The filters that this package's addon has given to Babylon.js, by language and kind. */
export const in_use = { glsl: {}, wgsl: {} };

const followed = new WeakMap();  // generator with cascades, whose biases follow the camera -> corners of what it draws

const is_mesh = value => typeof value?.getBoundingInfo === 'function';
const known = {
    receivers: ['an array of meshes of Babylon.js', value => Array.isArray(value) && Array.from(value).every(is_mesh)],
    steady: flag,
};

const array_of = ({ x, y, z }) => [x, y, z];

function solids(meshes) {
    return meshes.filter(mesh => mesh?.isEnabled() && mesh.isVisible && mesh.getTotalVertices() > 0).map(mesh => {
        const matrix = mesh.computeWorldMatrix(true).m, { minimum, maximum } = mesh.getBoundingInfo().boundingBox;
        const corners = solid(array_of(minimum), array_of(maximum), matrix);
        check_places(where, `mesh ${mesh.name}`, corners);
        return corners;
    });
}

/** The map's axes as Babylon.js looks along a light. */
function view_of(light) {
    const moved = light.computeTransformedInformation(), position = array_of(moved ? light.transformedPosition : light.position);
    const [x, y, z] = array_of(light.getShadowDirection(0).normalizeToNew()), across = Math.hypot(x, z);
    const right = across > 0 ? [z / across, 0, -x / across] : [1, 0, 0];
    const up = [y * right[2] - z * right[1], z * right[0] - x * right[2], x * right[1] - y * right[0]];
    check_places(where, 'light', [position]);
    must(where, [x, y, z].every(Number.isFinite), "the light's direction must be finite", [x, y, z]);
    return { position, axes: [right, up, [-x, -y, -z]] };
}

/** The filter in use: its reach in texels, and for a point light's cube by how much of its distance a point moves; whether
 *  it compares colors, which Babylon.js writes beside depths. undefined: no bias frees it. */
function filter_of(generator) {
    const { filter, filteringQuality, blurScale } = generator, engine = generator.getLight().getScene().getEngine();
    const { pcf, pcss } = in_use[engine.isWebGPU ? 'wgsl' : 'glsl'];
    const size = generator.getShadowMap().getSize().width, radius = ours => reach_of(ours.filter, ours.given.all);
    if (filter === filters.none) return { reach: [Math.SQRT1_2, 0], colors: true };
    if (filter === filters.poisson) {
        const cube = generator.getLight().needCube();
        return { reach: cube ? [Math.SQRT2, Math.sqrt(3) * blurScale / size] : [poisson_radius * blurScale + Math.SQRT2, 0],
            colors: true };
    }
    if (filter === filters.pcss) return pcss && { reach: [radius(pcss), 0], colors: true, twice: true };
    if (filter !== filters.pcf) return undefined;
    return { reach: [pcf && filteringQuality < 2 ? radius(pcf) : own_pcf[filteringQuality] * Math.SQRT2, 0], colors: false };
}

/** World units by which a bias of 1 moves a caster away from the light. Babylon.js adds the bias to clip space by a half, and
 *  again to what it writes as a color, or as a depth itself with clamped cascades. */
function world_of_bias(kind, { colors, twice }, { near, far, depth }, { half_range, clamped }) {
    if (kind === 'point') return near + far;
    if (kind === 'directional') return (far - near) * (colors ? (twice ? 1.5 : 1) : clamped ? 1.5 : 0.5);
    if (!colors) return depth * depth * (far - near) / (far * near) / 2;
    return (far - near) * (1 + (!twice ? 0 : half_range ? depth / (2 * far) : depth / (near + far)));
}

/** Sets the biases for what is known of a map; without a filter that they free, says what they are. */
function set_biases(generator, kind, { filter, texel, normal, planes, clamped, share = 1 }) {
    const engine = generator.getLight().getScene().getEngine(), said = { texels_per_unit: 1 / texel, bias_is_set: filter !== undefined };
    if (!filter)
        return { ...said, detachment: undefined, clear_angle: undefined, reach: undefined, bias: generator.bias,
            normal_bias: generator.normalBias };
    const { near, far, depth } = planes, map = generator.getShadowMap();
    const stored = filter.colors && map.textureType === half_float ? 2 ** -12 : depth_error;
    // a spot's depths grow by the inverse of its distances: a bias moves casters by their square, texels grow with them
    const inverse = kind === 'spot' && !filter.colors, size = map.getSize().width;
    const found = bias_of_casters(normal, texel, stored * (far - near) * (inverse ? depth * depth / (far * near) : 1));
    const unit = world_of_bias(kind, filter, planes, { half_range: engine.isNDCHalfZRange, clamped });
    Object.assign(generator, { bias: found.depth / unit, normalBias: normal });
    return { ...said, detachment: found.detachment, clear_angle: Math.atan(Math.tan(found.clear_angle) * (inverse ? near / depth : share)),
        reach: filter.reach[0] + filter.reach[1] * size * Math.sqrt(3) / 2,  // a point moves most at a corner of the cube
        bias: generator.bias, normal_bias: normal };
}

/** Cascades as Babylon.js has put them, or undefined before it has. The widest texel needs the largest normalBias, and a bias is
 *  a share of each cascade's own depths. */
function fit_cascades(generator, points) {
    const filter = filter_of(generator), { width } = generator.getShadowMap().getSize();
    const depths = generator.getLight().getScene().getEngine().isNDCHalfZRange ? 1 : 2;
    const scales = Array.from({ length: generator.numCascades }, (_, i) => {
        const { m } = generator.getCascadeTransformMatrix(i);
        return [0, 1, 2].map(axis => Math.hypot(m[axis], m[axis + 4], m[axis + 8]));
    });
    if (scales.some(([, , z]) => z === 0)) return undefined;
    const texels = scales.map(([x, y]) => 2 / (Math.min(x, y) * width)), ranges = scales.map(([, , z]) => depths / z);
    const texel = Math.max(...texels), far = Math.max(...ranges), normal = parallel_offset(filter?.reach[0] ?? 0, texel, far, points);
    return { ...set_biases(generator, 'directional', { filter, texel, normal, planes: { near: 0, far },
        clamped: generator.depthClamp && !filter?.colors, share: Math.min(...ranges) / far }),
        cascades: texels.map(width => ({ texels_per_unit: 1 / width })) };
}

/** Sets what Babylon.js does not fit to casters and receivers: a box that holds them and no more, and its planes. */
function fit_map(generator, light, kind, { receivers, casters, filter, steady }) {
    const map_size = generator.getShadowMap().getSize(), { width, height } = map_size, reach = filter?.reach ?? [Math.SQRT2, 0];
    check_numbers(where, 'map', map_size, { width: above_zero, height: above_zero });
    if (kind !== 'directional') check_numbers(where, 'light', light, { range: ['a number above 0', range => range > 0] });
    const { position, axes } = view_of(light), common = { receivers, casters, axes, position, size: [width, height], reach: reach[0] };
    const distance = light.range < Number.MAX_VALUE ? light.range : Infinity, tangent = Math.tan(light.angle / 2);
    must(where, kind !== 'spot' || (light.angle > 0 && light.angle < 3), "the light's angle must be above 0 and below 3 radians", light.angle);
    const fit = kind === 'directional' ? fit_parallel({ ...common, steady })
        : kind === 'spot' ? fit_cone({ ...common, tangents: [tangent, tangent], distance, narrow: !steady })
        : fit_cube({ ...common, size: width, reach, distance });
    must(where, fit !== undefined, `the map must have more texels for a filter that reaches ${reach[0].toFixed(1)}`, width);
    const [x, y, z] = axes.map(axis => dot(axis, position));
    const planes = kind === 'directional' ? { near: z - fit.z[1], far: z - fit.z[0] }
        : { near: fit.near, far: kind === 'point' ? Math.max(fit.far, fit.radial) : fit.far, depth: fit.depth };
    Object.assign(light, { shadowMinZ: planes.near, shadowMaxZ: planes.far });
    if (kind === 'directional')
        Object.assign(light, { autoUpdateExtends: false, autoCalcShadowZBounds: false, shadowFrustumSize: 0, shadowOrthoScale: 0,
            orthoLeft: fit.x[0] - x, orthoRight: fit.x[1] - x, orthoBottom: fit.y[0] - y, orthoTop: fit.y[1] - y });
    if (kind === 'spot') light.shadowAngleScale = 2 * Math.atan(tangent * fit.width) / light.angle;
    light.forceProjectionMatrixCompute();
    return { ...fit, planes };
}

/** Sets a shadow generator's bias and normalBias for its filter, and its light's box and planes. */
export function fit_bias(generator, options = {}) {
    const light = generator?.getLight?.(), kind = kinds[light?.getTypeID?.()];
    must(where, kind && typeof generator.getShadowMap === 'function',
        'generator must be a shadow generator of a DirectionalLight, SpotLight or PointLight', light?.getClassName?.() ?? generator);
    check_options(where, options, known);
    const map = generator.getShadowMap(), scene = light.getScene(), { steady = false } = options;
    must(where, map, 'generator must not be disposed', map);
    const receivers = solids(options.receivers ?? scene.meshes.filter(mesh => mesh.receiveShadows));
    must(where, receivers.length > 0, 'receivers must have a visible mesh; without them, one with receiveShadows', 'none');
    const casters = solids(map.renderList ?? scene.meshes);
    if (typeof generator.getCascadeTransformMatrix === 'function') {
        const points = [...receivers, ...casters].flat(), fitted = fit_cascades(generator, points);
        must(where, fitted, 'generator must have drawn its cascades: call fit_bias after the first scene.render()', 'none');
        if (!followed.has(generator))
            scene.onAfterRenderTargetsRenderObservable.add(
                () => generator.getShadowMap() && fit_cascades(generator, followed.get(generator)));
        followed.set(generator, points);
        return fitted;
    }
    const filter = filter_of(generator), fit = fit_map(generator, light, kind, { receivers, casters, filter, steady });
    return { ...set_biases(generator, kind, { filter, texel: fit.texel, normal: fit.offset, planes: fit.planes }),
        near: fit.planes.near, far: fit.planes.far, casters_are_cut: fit.is_cut ?? false };
}
