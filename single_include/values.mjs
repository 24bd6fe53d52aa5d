// umbrage 0.1.0, MIT License. Values of shadows' uniform blocks, and matrices of their maps.
//
//     import { load_values, webgpu_clip_space } from 'umbrage/values';
//     const values = await load_values();
//     const { block, views } = values(lamp, { clip: webgpu_clip_space, position: [2, 6, 3], direction: [-2, -6, -3] });
//
// It is the C++ library itself, as WebAssembly, of about 250 kB.
import { must_be_clip_space, must_in } from './npm/compose/check.mjs';
import { encodings, filters, kinds } from './module/names.mjs';

const must = must_in('values');

const point = { position: [0, 0, 0], z_near: 0.1, z_far: 100, border: 2 };
const cascaded = { direction: [0, -1, 0], up: [0, 1, 0], scene: undefined, camera: undefined, cascades: undefined, lambda: 0.9, splits: [],
    overlap: 0, blend_texels: 16 };
/** What each kind of light is told of, with defaults; undefined is required. */
const of_kinds = {
    spot_light: { position: [0, 0, 0], direction: [0, -1, 0], up: [0, 1, 0], outer_angle_radians: Math.PI / 6, aspect: 1, z_near: 0.1,
        z_far: 100 },
    directional_light: { direction: [0, -1, 0], up: [0, 1, 0], receivers: undefined, casters: null, margin: 0.01, snap: false },
    cascades: { ...cascaded, cascades: 4 },
    cascades_8: { ...cascaded, cascades: 8 },
    warped_cascades: { direction: [0, -1, 0], scene: undefined, camera: undefined, cascades: 4, lambda: 0.9, splits: [], overlap: 0.1 },
    adaptive_pages: { direction: [0, -1, 0], up: [0, 1, 0], scene: undefined, camera: undefined, picture: undefined, points: undefined,
        normals: undefined, gutter: 4, target: 1 },
    point_light: point,
    tetrahedron_light: point,
    dual_paraboloid_light: { position: [0, 0, 0], range: 100, border: 2 },
};
const of_all = { clip: undefined, origin: [0, 0, 0], filter: {} };

/** The light's properties with defaults. */
function complete(kind, light) {
    must(typeof light === 'object' && light !== null, 'light must be an object', light);
    const known = { ...of_kinds[kind], ...of_all }, all = { ...known, ...light };
    for (const key of Object.keys(light)) must(key in known, `light must have no properties but ${Object.keys(known).join(', ')}`, key);
    for (const [key, value] of Object.entries(all)) must(value !== undefined, `light.${key} must be given`, value);
    if (all.splits?.length && light.cascades !== undefined)
        must(light.cascades === all.splits.length - 1, 'light.cascades must be left out, or one less than light.splits', light.cascades);
    return all;
}

/** What numbers must be. The C++ library holds them in an int where they are whole, and says which range they have. */
const number = { says: 'number', holds: n => typeof n === 'number' && !Number.isNaN(n) };
const finite = { says: 'finite number', holds: Number.isFinite };
const whole = { says: 'whole number below 2^31', holds: n => n === (n | 0) };

/** A property's numbers, of which it must have as many as size; 1 is a number alone. */
function numbers(key, value, size, { says, holds } = number) {
    const all = size === 1 ? [value] : value;
    must(typeof all === 'object' && all?.length === size && Array.from(all).every(holds),
        `light.${key} must be ${size === 1 ? `a ${says}` : `${size} ${says.replace('number', 'numbers')}`}`, value);
    return Array.from(all);
}

/** What contact hardening is told of: the softness of each map follows from it. */
const hardening = [{ name: 'light_size', value: undefined }, { name: 'min_radius', value: 1 }, { name: 'max_radius', value: 16 }];

/** Numbers of the filter's arguments but for a rotation, the given ones in place of defaults. */
function arguments_of({ name, filter }, given) {
    must(typeof given === 'object' && given !== null, 'light.filter must be an object', given);
    const hardens = filter.arguments.some(argument => argument.name === 'softness');
    const known = hardens ? hardening : filter.arguments.filter(argument => argument.name !== 'rotation');
    must(!hardens || given.light_size !== undefined, 'light.filter.light_size must be given', given.light_size);
    for (const key of Object.keys(given))
        must(known.some(argument => argument.name === key), `light.filter must have no properties but arguments of ${name}`, key);
    return known.flatMap(({ name, type, value }) => numbers(`filter.${name}`, given[name] === undefined ? value : given[name],
        [value].flat().length, type === 'int' ? whole : finite));
}

const box = { low: 3, high: 3 }, camera = { view: 16, projection: 16, z_near: 1, z_far: 1 };

/** The numbers in the order in which C++ reads them; zeros where the kind has no such property. */
function numbers_of({ kind, filter, direction, map_size }, light) {
    const { clip, splits = [], casters } = light, zeros = size => new Array(size).fill(0), sum = sizes => sizes.reduce((a, b) => a + b);
    must_be_clip_space(must, 'light.clip', clip);
    const bits = clip.subpixel_bits ?? 4;
    must(Number.isInteger(bits) && bits >= 3 && bits <= 16, 'light.clip.subpixel_bits must be a whole number from 3 to 16', bits);
    must(clip.direction === direction, `light.clip must have the direction of the shadow, ${direction}`, clip.direction);
    const of = (key, size = 1, what = number) => key in light ? numbers(key, light[key], size, what) : zeros(size);
    const parts = (key, sizes) => {
        if (!(key in light)) return zeros(sum(Object.values(sizes)));
        must(typeof light[key] === 'object' && light[key] !== null, `light.${key} must be an object of ${Object.keys(sizes).join(', ')}`, light[key]);
        return Object.entries(sizes).flatMap(([part, size]) => numbers(`${key}.${part}`, light[key][part], size));
    };
    must(splits?.length === 0 || splits?.length >= 2 && splits.length <= 9, 'light.splits must be 2 to 9 distances, or none', splits);
    must(!('snap' in light) || typeof light.snap === 'boolean', 'light.snap must be true or false', light.snap);
    const distances = numbers('splits', splits, splits.length), given = arguments_of(filter, light.filter);
    return [clip.hand === 'left', clip.range === 'minus_one_to_one', direction === 'reversed', clip.origin === 'top', bits, ...map_size,
        ...of('origin', 3), ...of('position', 3), ...of('direction', 3), ...of('up', 3), ...of('outer_angle_radians'), ...of('aspect'),
        ...of('z_near'), ...of('range' in light ? 'range' : 'z_far'), ...of('gutter' in light ? 'gutter' : 'border', 1, whole),
        ...parts('receivers' in light ? 'receivers' : 'scene', box), Boolean(casters), ...casters === null ? zeros(6) : parts('casters', box),
        ...of('margin'), light.snap ?? false, ...parts('camera', camera), ...splits.length ? [splits.length - 1] : of('cascades', 1, whole),
        ...of('lambda'), ...of('overlap'), ...of('blend_texels'), ...of('picture', 2, whole), ...of('target'),
        splits.length > 0, ...distances, ...zeros(9 - splits.length), ...given, ...zeros(4 - given.length)].map(Number);
}

/** Points with their normals, eight floats each, as C++ reads them. */
function seen_of({ points = [], normals = [] }) {
    for (const [key, value] of Object.entries({ points, normals }))
        must(typeof value === 'object' && value?.length >= 0, `light.${key} must be an array of floats`, value);
    must(points.length % 4 === 0, 'light.points must be four floats each', `${points.length} floats`);
    must(normals.length === points.length, 'light.normals must be as many as light.points', `${normals.length} floats`);
    const seen = new Float32Array(2 * points.length);
    for (let i = 0; i < points.length; ++i) {
        const at = i + (i & ~3);  // four of a point, four of its normal
        seen[at] = points[i];
        seen[at + 4] = normals[i];
    }
    return seen;
}

/** The largest angle that a mesh's edge may span, as paraboloid_edge_angle of the C++ library gives it. */
function edge_angle_of([size], { border }) {
    const inner = size - 2 * border, rim = 1 + 2 * Math.SQRT2 * border / inner;
    return 2 * Math.sqrt(2 / inner) * 2 / (1 + rim * rim);
}

/** Starts the WebAssembly, once; what it resolves to gives a shadow's block and matrices for a light. */
export async function load_values() {
    const fail = message => {
        const bytes = new Uint8Array(memory().buffer, message);
        throw new Error(new TextDecoder().decode(bytes.slice(0, bytes.indexOf(0))));
    };
    const nothing = () => 0, memory = () => instance.exports.memory;
    const { wasm } = await import('./wasm/umbrage.mjs');  // by require, too
    const { instance } = await WebAssembly.instantiate(Uint8Array.from(atob(wasm), c => c.charCodeAt(0)), {
        umbrage: { fail }, env: { emscripten_notify_memory_growth: nothing },
        wasi_snapshot_preview1: { proc_exit: nothing, fd_close: nothing, fd_write: nothing, fd_seek: nothing },
    });
    const c = instance.exports;
    c._initialize();
    return (shadow, light) => {
        must(shadow?.settings !== undefined, 'shadow must be one that shadow() made', shadow);
        const { settings } = shadow, whole = complete(settings.kind, light), numbers = numbers_of(settings, whole);
        const seen = seen_of(whole), room = c.umbrage_seen(seen.length / 8);
        new Float64Array(memory().buffer, c.umbrage_input(), numbers.length).set(numbers);
        new Float32Array(memory().buffer, room, seen.length).set(seen);
        const stack = c.stackSave();
        let floats;
        try {
            floats = c.umbrage_values(kinds.indexOf(settings.kind), filters.indexOf(settings.filter.name), encodings.indexOf(settings.encoding));
        } finally { c.stackRestore(stack); }
        const maps = [...Array(c.umbrage_maps()).keys()], moments = c.umbrage_moments(), end = floats + 36 * maps.length;
        const all = new Float32Array(memory().buffer, c.umbrage_output(), end + moments).slice(), views = all.subarray(floats + 16 * maps.length);
        const bends = settings.kind === 'dual_paraboloid_light';
        return { block: all.slice(0, floats), ...bends && { edge_angle: edge_angle_of(settings.map_size, whole) },
            matrices: bends ? [] : maps.map(i => all.slice(floats + 16 * i, floats + 16 * i + 16)),
            cleared: moments ? [...all.subarray(end), 0, 0, 0].slice(0, 4) : shadow.cleared,
            views: maps.map(i => ({ to_clip: views.slice(20 * i, 20 * i + 16), anchor: views.slice(20 * i + 16, 20 * i + 20) })) };
    };
}
export const opengl_clip_space = { hand: "right", range: "minus_one_to_one", direction: "forward", origin: "bottom", subpixel_bits: 4 };
export const vulkan_clip_space = { hand: "right", range: "zero_to_one", direction: "forward", origin: "bottom", subpixel_bits: 4 };
export const direct3d_clip_space = { hand: "left", range: "zero_to_one", direction: "forward", origin: "top", subpixel_bits: 8 };
export const webgpu_clip_space = { hand: "right", range: "zero_to_one", direction: "forward", origin: "top", subpixel_bits: 4 };
export const metal_clip_space = { hand: "right", range: "zero_to_one", direction: "forward", origin: "top", subpixel_bits: 4 };
export const unity_clip_space = { hand: "left", range: "zero_to_one", direction: "reversed", origin: "top", subpixel_bits: 4 };
export const unity_opengl_clip_space = { hand: "left", range: "minus_one_to_one", direction: "forward", origin: "bottom", subpixel_bits: 4 };
export const unreal_clip_space = { hand: "left", range: "zero_to_one", direction: "reversed", origin: "top", subpixel_bits: 4 };
export const godot_clip_space = { hand: "right", range: "zero_to_one", direction: "reversed", origin: "bottom", subpixel_bits: 4 };
export const cpu_clip_space = { hand: "right", range: "zero_to_one", direction: "forward", origin: "bottom", subpixel_bits: 8 };
