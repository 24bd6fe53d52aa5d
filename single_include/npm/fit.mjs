// SPDX-License-Identifier: MIT
//
// Where a shadow map lies and how far a receiver is moved along its normal, for any engine: no word of one is in here.
//
// A receiver that is moved by n is n / cos t nearer to the light, t between normal and light. A filter's farthest texel is
// r texels away, where the receiver's plane is r texel tan t nearer. So n = r texel sin t is enough at each t, and r texel
// at all of them. A perspective map's texel grows with depth: the farthest receiver needs the most.
//
// Points are arrays of three numbers. A solid is convex, its eight corners in the order of a box's: x, then y, then z.

/** Texels by which a rasterizer may move a triangle: 4 bits below a texel are all that OpenGL ES guarantees. */
export const snapping = 2 ** -3;
/** Rounding of one float of 32 bits. Positions go through some sixteen roundings on both ways into a map. */
const unit = 2 ** -24;
export const roundings = 16 * unit;
/** Steps of a stored depth of 24 bits, and of the arithmetic before it. */
export const depth_error = 2 ** -22;

const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const along = (a, b, t) => [a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t, a[2] + (b[2] - a[2]) * t];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const largest = (values, of) => values.reduce((most, value) => Math.max(most, of(value)), -Infinity);
const smallest = (values, of) => -largest(values, value => -of(value));
export const longest = p => Math.max(Math.abs(p[0]), Math.abs(p[1]), Math.abs(p[2]));

/** A point that a column-major matrix places. */
export function placed([x, y, z], matrix) {
    const [w, ...p] = [3, 0, 1, 2].map(row => matrix[row] * x + matrix[row + 4] * y + matrix[row + 8] * z + matrix[row + 12]);
    return p.map(value => value / w);
}

/** Corners of a box that a column-major matrix places. A flat box gets a thickness, so that all its faces have an area. */
export function solid(low, high, matrix) {
    const thin = Math.hypot(...minus(high, low)) * 2 ** -20, corners = [];
    for (let i = 0; i < 8; ++i) {
        corners.push(placed([0, 1, 2].map(axis => ((i >> axis) & 1 ? high[axis] + thin : low[axis] - thin)), matrix));
    }
    return corners;
}

const faces = [[0, 2, 6, 4], [1, 3, 7, 5], [0, 1, 5, 4], [2, 3, 7, 6], [0, 1, 3, 2], [4, 5, 7, 6]];
const polygons_of = corners => faces.map(face => face.map(i => corners[i]));

/** Planes of a solid, [normal, offset]: above 0 inside, however the solid is mirrored. */
function planes_of(corners) {
    const middle = along(along(corners[0], corners[7], 0.5), along(corners[3], corners[4], 0.5), 0.5);
    return polygons_of(corners).map(([a, b, c, d]) => {
        const normal = cross(minus(c, a), minus(d, b)), offset = -dot(normal, a);
        return dot(normal, middle) + offset < 0 ? [normal.map(value => -value), -offset] : [normal, offset];
    });
}

function cut(polygon, [normal, offset]) {
    const kept = [], heights = polygon.map(p => dot(normal, p) + offset);
    for (let i = 0, last = polygon.length - 1; i < polygon.length; last = i++) {
        if (heights[i] < 0 !== heights[last] < 0)
            kept.push(along(polygon[last], polygon[i], heights[last] / (heights[last] - heights[i])));
        if (heights[i] >= 0) kept.push(polygon[i]);
    }
    return kept;
}

/** Whether corners are all inside planes: 1; all outside of one: -1; else 0. */
function side_of(corners, planes) {
    let side = 1;
    for (const [normal, offset] of planes) {
        let outside = 0;
        for (const p of corners) if (dot(normal, p) + offset < 0) ++outside;
        if (outside === 8) return -1;
        if (outside > 0) side = 0;
    }
    return side;
}

/** Corners of what each of many solids has in common with all of a few. */
function parts_in(solids, ...views) {
    const planes = views.map(planes_of), all = planes.flat();
    return solids.flatMap(one => {
        const side = side_of(one, all);
        if (side !== 0) return side > 0 ? one : [];
        const own = planes_of(one), kept = polygons_of(one).flatMap(polygon => all.reduce(cut, polygon));
        return views.reduce((found, view, i) => found.concat(polygons_of(view).flatMap(polygon => own.concat(
            ...planes.filter((_, j) => j !== i)).reduce(cut, polygon))), kept);
    });
}

/** What a view sees of receivers, or all of them where it sees none. */
function seen_of(receivers, ...views) {
    const seen = views.length ? parts_in(receivers, ...views) : [];
    return seen.length ? seen : receivers.flat();
}

const bounds = (points, axes) => axes.map(axis => [smallest(points, p => dot(p, axis)), largest(points, p => dot(p, axis))]);
const extent = ([low, high]) => high - low;

/** Texel of a square map of points: their larger extent over the texels that a filter leaves. */
const texel_of = ([x, y], inner) => Math.max(extent(x) / inner[0], extent(y) / inner[1], Number.MIN_VALUE);

/** How much finer the nearest of four cascades would be than one map, and whether anyone would see it: a texel of the map
 *  covers two pixels or more of a picture of 1080 rows. */
function cascades_of({ receivers, view, inner, axes }, seen, texel) {
    const [near, far] = [0, 4].map(first => [0, 1, 2, 3].map(i => view[first + i]));
    const middle = quad => along(along(quad[0], quad[3], 0.5), along(quad[1], quad[2], 0.5), 0.5), from = middle(near);
    const ahead = minus(middle(far), from), length = Math.hypot(...ahead), axis = ahead.map(value => value / length);
    // rows of the picture are the frustum's heights, which grow evenly with depth
    const heights = [near, far].map(quad => Math.hypot(...minus(quad[2], quad[0])));
    const to_eye = heights[1] > heights[0] * (1 + 1e-9) ? length * heights[0] / (heights[1] - heights[0]) : Infinity;
    const depth_of = p => dot(minus(p, from), axis), perspective = to_eye < Infinity, eye = perspective ? to_eye : 0;
    const last = largest(seen, depth_of) + eye, first = Math.max(smallest(seen, depth_of) + eye, last / 256);
    const even = first + (last - first) / 4, split = perspective ? (first * (last / first) ** 0.25 + even) / 2 : even;
    const at = depth => near.map((corner, i) => along(corner, far[i], (depth - eye) / length));
    const part = seen_of(receivers, [...at(Math.max(first, eye)), ...at(split)]);
    const finer = Math.max(texel / texel_of(bounds(part, axes), inner), 1);
    const row = (perspective ? heights[0] * first / to_eye : heights[0]) / 1080;
    return { finer, pay: finer >= 2 && texel >= 2 * row };
}

/** The normal offset in a map of parallel light, in two parts: what the farthest texel of a filter needs on a plane along
 *  the light, and what rounding needs on one that faces it.
 *  @param range    between its planes
 *  @param points   of receivers and casters; how far they are from the origin tells how coarse their coordinates are
 *  @param step     of stored depths, as a share of the range */
export const parallel_parts = (reach, texel, range, points, step = depth_error) =>
    [(reach + snapping) * texel, range * step + largest(points, longest) * roundings];
export const parallel_offset = (...light) => parallel_parts(...light).reduce((sum, part) => sum + part);

/** Box, planes and normal offset of a map of parallel light.
 *  @param axes        the map's x, y and the direction to the light, of length 1
 *  @param receivers   solids, and casters too
 *  @param view        the solid that a camera sees; its receivers alone count
 *  @param size        of the map, in texels
 *  @param reach       texels from a receiver to the farthest texel that is compared
 *  @param steady      whether the map moves by whole texels, and keeps its size while the view turns
 *  @return            x, y: the map's box on its axes; z: the depths it holds, towards the light; texel, offset, cascades.
 *                     undefined: the map has too few texels for the filter */
export function fit_parallel({ axes, receivers, casters, view, size, reach, steady }) {
    const margin = Math.ceil(reach) + 1, inner = size.map(texels => texels - 2 * margin - (steady ? 1 : 0));
    if (Math.min(...inner) < 1) return undefined;
    const seen = view ? seen_of(receivers, view) : receivers.flat();
    const [x, y, z] = bounds(seen, axes), middle = [x, y].map(([low, high]) => (low + high) / 2);
    let texel = texel_of([x, y], inner);
    if (steady) {
        const across = view ? largest(view, p => largest(view, q => Math.hypot(...minus(p, q)))) : Infinity;
        const most = bounds(receivers.flat(), axes).map(side => [0, Math.min(extent(side), across)]);
        texel = 2 ** (Math.ceil(Math.log2(texel_of(most, inner)) * 4) / 4);
        for (const side of [0, 1]) middle[side] = Math.round(middle[side] / texel) * texel;
    }
    const [box_x, box_y] = middle.map((center, i) => [center - texel * size[i] / 2, center + texel * size[i] / 2]);
    const walls = [box_x, box_y].flatMap(([low, high], i) => [[axes[i], -low], [axes[i].map(value => -value), high]]);
    const over = casters.flatMap(one => {
        const side = side_of(one, walls);
        return side > 0 ? one : side < 0 ? [] : polygons_of(one).flatMap(polygon => walls.reduce(cut, polygon));
    });
    const top = Math.max(z[1], largest(over, p => dot(p, axes[2])));
    const offset = parallel_offset(reach, texel, top - z[0], [...receivers, ...casters].flat());
    const slack = 2 * offset + (top - z[0]) * 2 ** -10;
    return { x: box_x, y: box_y, z: [z[0] - slack, top + slack], texel, offset,
        cascades: view && cascades_of({ receivers, view, inner, axes }, seen, texel) };
}

/** Depths of a perspective map whose nearest plane keeps its precision: at least 1/1024 of the farthest. */
function planes(nearest, farthest) {
    const far = farthest * (1 + 2 ** -6), near = Math.max(nearest * (1 - 2 ** -6), far * 2 ** -10);
    return { near, far, is_cut: nearest < near };
}

/** The normal offset at the farthest depth; r is the filter's reach there over that depth, c the light's angles' secant. */
export function perspective_offset(r, depth, { near, far }, secant, error) {
    const stored = depth * depth * (far - near) / (far * near);  // world units per stored depth
    return (r * depth + stored * error * secant) / (1 - r);
}

/** Planes, width and normal offset of a spot light's map.
 *  @param position    of the light; axes as above, the last away from where it shines
 *  @param tangents    of half the angles of the map's width and height
 *  @param distance    that the light reaches, or Infinity
 *  @param narrow      whether the map may be narrower than the light's cone
 *  @return            near, far, width: a factor of the tangents; depth and texel of the farthest receiver, offset, is_cut:
 *                     whether a caster lies before the near plane. undefined: the map has too few texels for the filter */
export function fit_cone({ position, axes, receivers, casters, view, size, reach, tangents, distance, narrow }) {
    const margin = Math.ceil(reach) + 1, inner = size.map(texels => texels - 2 * margin);
    if (Math.min(...inner) < 1) return undefined;
    const local = p => { const q = minus(p, position); return [dot(q, axes[0]), dot(q, axes[1]), -dot(q, axes[2])]; };
    const [sides, occluders] = [receivers, casters].map(all => all.map(one => one.map(local)));
    const end = Math.min(distance, largest(sides.flat(), longest) * 2);
    const pyramid = [end * 2 ** -16, end].flatMap(z => [-1, 1].flatMap(y => [-1, 1].map(
        x => [x * tangents[0] * z, y * tangents[1] * z, z])));
    const held = parts_in(sides, pyramid);
    const seen = view ? parts_in(sides, pyramid, view.map(local)) : held;
    const points = seen.length ? seen : held.length ? held : pyramid;
    const needed = largest(points, p => Math.max(...[0, 1].map(i => Math.abs(p[i]) / (p[2] * tangents[i]) * size[i] / inner[i])));
    const width = narrow ? Math.min(needed, 1) : 1;
    const depth = largest(points, p => p[2]);
    const near_points = [...parts_in(occluders, pyramid), ...points];
    const found = planes(smallest(near_points, p => p[2]), depth);
    const texel = Math.max(...[0, 1].map(i => 2 * width * tangents[i] / size[i]));
    const magnitude = largest([...receivers.flat(), ...casters.flat(), position], longest);
    // z and w of a product matrix round apart: what the world's coordinates lose is divided by the depth
    const offset = perspective_offset((reach + snapping) * texel, depth, found,
        Math.hypot(1, ...tangents), depth_error + roundings * magnitude / depth) + magnitude * roundings;
    return (reach + snapping) * texel < 0.25 ? { ...found, width, depth, texel: texel * depth, offset } : undefined;
}

/** Planes and normal offset of a point light's cube.
 *  @param reach    [texels of a face to the farthest texel, the light's distances by which the compared point moves]
 *  @return         as of fit_cone, without width and depth; radial: the farthest receiver's distance */
export function fit_cube({ position, receivers, casters, view, size, reach: [texels, moved], distance }) {
    const local = p => minus(p, position), seen = view ? seen_of(receivers, view) : receivers.flat();
    const farthest = Math.min(largest(seen, p => longest(local(p))), distance);
    const radial = Math.min(largest(seen, p => Math.hypot(...local(p))), farthest * Math.sqrt(3));
    // from the light to the box around a solid; 0 inside
    const gap = one => Math.max(...[0, 1, 2].map(axis => Math.max(0,
        smallest(one, p => p[axis]) - position[axis], position[axis] - largest(one, p => p[axis]))));
    // receivers before the near plane are lit, as no caster is nearer
    const found = planes(smallest(casters.length ? casters : receivers, gap), farthest);
    const texel = 2 / size, r = (texels + snapping) * texel + moved * radial / farthest;
    const magnitude = largest([...receivers.flat(), ...casters.flat(), position], longest);
    const offset = perspective_offset(r, farthest, found, Math.sqrt(3), depth_error) + magnitude * roundings;
    return r < 0.25 ? { ...found, radial, texel: texel * farthest, offset } : undefined;
}

/** Texels to which a box clamps its radius, as box.hpp has it. */
const largest_box = 8;

/** Texels from a receiver to the farthest texel that a filter of this package compares.
 *  @param values   its arguments */
export function reach_of({ filter }, values) {
    const { softness, radius } = values, half_texel = Math.SQRT1_2;
    if (softness !== undefined) return softness[3] / 16 + half_texel;
    if (radius === undefined) return filter.reach * Math.SQRT2;
    const is_disc = filter.arguments.some(({ name, type }) => name === 'radius' && type === 'float');
    return is_disc ? Math.max(radius, 0) + half_texel : (Math.min(Math.max(radius, 0), largest_box) + 0.5) * Math.SQRT2;
}
