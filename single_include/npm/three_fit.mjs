// SPDX-License-Identifier: MIT
//
// three.js: box, planes and bias of a light's own shadow, in one call, for both renderers and three.js' own filters too.
//
//     import { fit_shadow } from 'umbrage/three';  // or 'umbrage/three/webgpu'
//     fit_shadow(light, { receivers: scene });     // again when things move
import { dot, fit_cone, fit_cube, fit_parallel, parallel_offset, placed, reach_of, solid } from './fit.mjs';
import { check_options, check_places, flag, must } from './options.mjs';

const where = 'three: fit_shadow', basic = 0, vsm = 3;  // of renderer.shadowMap.type; three's default is PCF
const webgpu_coordinates = 2001, identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

/** The filters that this package's addons have given to three.js: for WebGLRenderer, and by the filter nodes of lights. */
export const in_use = { webgl: undefined, nodes: new WeakMap() };

const is_object = value => typeof value?.traverse === 'function' && value.matrixWorld !== undefined;
const is_box = value => ['x', 'y', 'z'].every(axis => Number.isFinite(value?.min?.[axis]) && value.min[axis] <= value.max?.[axis]
    && Number.isFinite(value.max[axis]));
const is_part = value => is_object(value) || is_box(value);
const parts = ['objects of three.js, finite boxes, or an array of them', value => is_part(value)
    || (Array.isArray(value) && value.length > 0 && value.every(is_part))];
const known = {
    receivers: parts,
    casters: parts,
    camera: ['a camera of three.js', value => value?.isCamera === true && value.projectionMatrixInverse !== undefined],
    steady: flag,
    renderer: ['a renderer of three.js', value => Number.isInteger(value?.shadowMap?.type)],
    reach: ['a finite number of texels, 0 or more', value => Number.isFinite(value) && value >= 0],
};

const array_of = ({ x, y, z }) => [x, y, z];

/** Solids of boxes, and of the meshes in objects that have a flag. Geometry that moves is measured again. */
function solids(where_from, flag_name) {
    const found = [];
    for (const part of [where_from].flat()) {
        if (!is_object(part)) {
            found.push(solid(array_of(part.min), array_of(part.max), identity));
            continue;
        }
        part.updateWorldMatrix(true, true);
        part.traverseVisible(object => {
            if (!object.geometry || object[flag_name] !== true) return;
            const own = object.boundingBox !== undefined ? object : object.geometry;  // instances, skins and batches have one
            if (own === object || own.boundingBox === null) own.computeBoundingBox();
            const { min, max } = own.boundingBox;
            if (min.x <= max.x) found.push(solid(array_of(min), array_of(max), object.matrixWorld.elements));
        });
    }
    return found;
}

/** What a camera sees. */
function frustum(camera) {
    camera.updateWorldMatrix(true, false);
    const reversed = camera.reversedDepth === true, near = reversed ? 1 : camera.coordinateSystem === webgpu_coordinates ? 0 : -1;
    const world = multiply(camera.matrixWorld.elements, camera.projectionMatrixInverse.elements);
    return [0, 1, 2, 3, 4, 5, 6, 7].map(i => placed([i & 1 ? 1 : -1, i & 2 ? 1 : -1, i < 4 ? near : reversed ? 0 : 1], world));
}

const multiply = (a, b) => b.map((_, i) => [0, 1, 2, 3].reduce((sum, k) => sum + a[(i & 3) + 4 * k] * b[(i & 12) + k], 0));

/** The rotation that three.js gives a shadow's camera, as directions: it looks from the light to its target. */
function view_of(light) {
    light.updateWorldMatrix(true, false);
    light.target.updateWorldMatrix(true, false);
    const { camera } = light.shadow;
    camera.position.setFromMatrixPosition(light.matrixWorld);
    camera.lookAt(camera.position.clone().setFromMatrixPosition(light.target.matrixWorld));
    camera.updateMatrixWorld();
    const m = camera.matrixWorld.elements;
    return { axes: [0, 4, 8].map(i => [m[i], m[i + 1], m[i + 2]]), position: array_of(camera.position) };
}

/** The filter in use: its reach in texels, and for a point light's cube by how much of its distance a point moves. */
function filter_of(light, { renderer, reach }) {
    const { shadow } = light, { filterNode, radius, mapSize } = shadow, point = light.isPointLight === true;
    const by_node = filterNode && in_use.nodes.get(filterNode);
    const in_webgl = renderer === undefined || renderer.isWebGLRenderer === true;
    const ours = by_node ?? (in_webgl && !filterNode ? in_use.webgl : undefined);
    const disc = Math.sqrt(0.9) * Math.max(radius, 0);  // three's five points
    must(where, reach !== undefined || !filterNode || by_node,
        "reach must be given for a filterNode that is not this package's", filterNode);
    if (reach !== undefined) return { reach: [reach, 0] };
    if (ours && !point) {
        const { filter, given } = ours, { own, all } = given;
        const by_light = all.radius !== undefined && !('radius' in own)
            && filter.filter.arguments.some(({ name, type }) => name === 'radius' && type === 'float') ? { radius } : {};
        return { reach: [reach_of(filter, { ...all, ...by_light }), 0] };
    }
    const type = ours && !by_node ? basic : renderer?.shadowMap.type;  // a point light keeps three.js' own filter
    if (type === basic) return { reach: [Math.SQRT1_2, 0] };
    if (type === vsm) return { reach: [Math.max(radius, 0) + 1, 0], variance: true };
    return { reach: point ? [Math.SQRT2, disc / mapSize.x] : [disc + Math.SQRT2, 0] };
}

/** SunLight has a fit of its own; its planes and texels follow from it. */
function fit_sun(light, { receivers, casters, camera, reach }) {
    const { shadow } = light, eye = camera.matrixWorld.elements, ahead = [8, 9, 10].map(i => -eye[i]);
    const depth = Math.max(...receivers.flat().map(p => dot(p.map((value, i) => value - eye[12 + i]), ahead)));
    shadow.camera.far = Math.min(Math.max(depth, camera.near * 2), camera.far);
    light.updateWorldMatrix(true, false);
    shadow.updateMatrices(light, camera);
    const texels = [], ranges = [], { x, y } = shadow.mapSize;
    for (let i = 0; i < shadow.getViewportCount(); ++i) {
        const { left, right, bottom, top, near, far } = shadow.getCamera(i), part = shadow.getViewport(i);
        texels.push((right - left) / (part.z * x), (top - bottom) / (part.w * y));
        ranges.push(far - near);
    }
    const texel = Math.max(...texels);
    return { texel, offset: parallel_offset(reach, texel, Math.max(...ranges), [...receivers, ...casters].flat()) };
}

/** Refuses a light whose own numbers would make the map's matrix NaN. */
function check_light(light) {
    const { mapSize, radius } = light.shadow, size = [mapSize.x, mapSize.y];
    must(where, size.every(n => Number.isInteger(n) && n > 0), 'light.shadow.mapSize must be two integers above 0', size);
    must(where, Number.isFinite(radius), 'light.shadow.radius must be finite', radius);
    for (const [name, object] of [['light', light], ['light.target', light.target]]) {
        if (!object) continue;
        object.updateWorldMatrix(true, false);
        must(where, object.matrixWorld.elements.every(Number.isFinite), `${name} must be at a finite place in the world`,
            array_of(object.position));
    }
}

/** Sets the light's own shadow camera, normalBias and bias for the filter in use. */
export function fit_shadow(light, options = {}) {
    const kinds = ['isDirectionalLight', 'isSpotLight', 'isPointLight', 'isSunLight'];
    must(where, kinds.some(kind => light?.[kind]) && light.shadow,
        'light must be a DirectionalLight, SpotLight, PointLight or SunLight', light);
    check_options(where, options, known);
    must(where, options.receivers !== undefined, 'receivers must be objects of three.js, finite boxes, or an array of them', undefined);
    must(where, !light.isSunLight || options.camera, 'camera must be given for a SunLight', options.camera);
    const { shadow } = light, { camera: own, mapSize } = shadow, { steady = false, camera } = options;
    check_light(light);
    const distance = light.distance > 0 ? light.distance : Infinity;  // as three.js' shaders read it
    const receivers = solids(options.receivers, 'receiveShadow');
    must(where, receivers.length > 0, 'receivers must have a visible mesh with receiveShadow', 'none');
    const casters = solids(options.casters ?? options.receivers, 'castShadow');
    const { reach, variance = false } = filter_of(light, options), view = camera && frustum(camera);
    check_places(where, 'receivers', receivers.flat());
    check_places(where, 'casters', casters.flat());
    const common = { receivers, casters, view, size: [mapSize.x, mapSize.y], reach: reach[0] };
    const enough = fit => {
        must(where, fit !== undefined,
            `light.shadow.mapSize must have more texels for a filter that reaches ${reach[0].toFixed(1)}`, [mapSize.x, mapSize.y]);
        return fit;
    };
    const texels = reach[0] + reach[1] * mapSize.x * Math.sqrt(3) / 2;  // a point moves most at a corner of the cube
    let fit, set;
    if (light.isSunLight) {
        must(where, Math.min(mapSize.x, mapSize.y) > 8, 'light.shadow.mapSize must be above 8', [mapSize.x, mapSize.y]);
        fit = fit_sun(light, { ...common, camera });
        set = {};
    } else if (light.isPointLight) {
        light.updateWorldMatrix(true, false);
        const position = array_of(own.position.setFromMatrixPosition(light.matrixWorld));
        fit = enough(fit_cube({ ...common, size: mapSize.x, reach, position, distance }));
        set = { near: fit.near, far: distance < Infinity ? distance : fit.far };
    } else if (light.isSpotLight) {
        must(where, light.angle > 0 && light.angle <= 1.5, 'light.angle must be above 0 and at most 1.5 radians', light.angle);
        if (!light.map) shadow.aspect = mapSize.y / mapSize.x;  // else a map higher than wide cuts the cone's sides
        const tangent = Math.tan(light.angle), aspect = mapSize.x / mapSize.y * shadow.aspect;
        fit = enough(fit_cone({ ...common, ...view_of(light), tangents: [tangent * aspect, tangent],
            distance, narrow: !light.map && !steady }));
        shadow.focus = Math.atan(tangent * fit.width) / light.angle;
        set = { near: fit.near, far: distance < Infinity ? distance : fit.far, aspect,
            fov: 360 / Math.PI * light.angle * shadow.focus };
    } else {
        const { axes, position } = view_of(light);
        fit = enough(fit_parallel({ ...common, axes, steady }));
        const [x, y, z] = axes.map(axis => dot(axis, position));
        set = { left: fit.x[0] - x, right: fit.x[1] - x, bottom: fit.y[0] - y, top: fit.y[1] - y,
            near: z - fit.z[1], far: z - fit.z[0], zoom: 1 };
    }
    Object.assign(own, set);
    own.updateProjectionMatrix();
    if (!variance) Object.assign(shadow, { bias: 0, normalBias: fit.offset });
    shadow.needsUpdate = true;
    return { texels_per_unit: 1 / fit.texel, detachment: variance ? undefined : fit.offset, reach: texels, normal_bias: shadow.normalBias,
        bias: shadow.bias, bias_is_set: !variance, near: own.near, far: own.far, casters_are_cut: fit.is_cut ?? false,
        ...fit.cascades && { cascades: fit.cascades } };
}
