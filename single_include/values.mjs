// umbrage 0.1.0, MIT License. Values of shadows' uniform blocks, and matrices of their maps.
//
//     import { load_values, webgpu_clip_space } from 'umbrage/values';
//     const values = await load_values();
//     const { block, matrices } = values(sun, { clip: webgpu_clip_space, direction: [-2, -6, -3], receivers });
//
// It is the C++ library itself, as WebAssembly, of 197 kB.
import { encodings, filters, kinds } from './module/names.mjs';

function must(holds, condition, got) {
    if (!holds) throw new Error(`umbrage: values: ${condition}; got ${got}`);
}

const point = { position: [0, 0, 0], z_near: 0.1, z_far: 100, border: 0 };
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
    dual_paraboloid_light: { position: [0, 0, 0], range: 100, border: 0 },
};
const of_all = { clip: undefined, origin: [0, 0, 0], filter: {} };

/** The light's properties with defaults. */
function complete(kind, light) {
    must(typeof light === 'object' && light !== null, 'light must be an object', light);
    const known = { ...of_kinds[kind], ...of_all }, all = { ...known, ...light };
    for (const key of Object.keys(light)) must(key in known, `light must have no properties but ${Object.keys(known).join(', ')}`, key);
    for (const [key, value] of Object.entries(all)) must(value !== undefined, `light.${key} must be given`, value);
    return all;
}

/** Numbers of the filter's arguments but for a rotation, the given ones in place of defaults. */
function arguments_of({ name, filter }, given) {
    const known = filter.arguments.filter(argument => argument.name !== 'rotation');
    for (const key of Object.keys(given))
        must(known.some(argument => argument.name === key), `light.filter must have no properties but arguments of ${name}`, key);
    return known.flatMap(argument => given[argument.name] ?? argument.value);
}

/** The numbers in the order in which C++ reads them. */
function numbers_of({ kind, filter, direction, map_size }, light) {
    const { clip } = light, no_box = { low: [0, 0, 0], high: [0, 0, 0] }, identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
    must(clip.direction === direction, `light.clip must have the direction of the shadow, ${direction}`, clip.direction);
    const vector = (value, size, what) => {
        must(value?.length === size, `light.${what} must be ${size} numbers`, value);
        return value;
    };
    const box = (of, what) => [...vector(of.low, 3, `${what}.low`), ...vector(of.high, 3, `${what}.high`)];
    const camera = light.camera ?? { view: identity, projection: identity, z_near: 1, z_far: 2 };
    const splits = light.splits ?? [], count = splits.length ? splits.length - 1 : light.cascades ?? (kind === 'cascades_8' ? 8 : 1);
    const fill = (values, size) => [...values, ...new Array(size - values.length).fill(0)];
    must(splits.length <= 9, 'light.splits must be 9 distances at most', splits.length);
    return [clip.hand === 'left', clip.range === 'minus_one_to_one', direction === 'reversed', clip.origin === 'top', ...map_size,
        ...vector(light.origin, 3, 'origin'), ...vector(light.position ?? [0, 0, 0], 3, 'position'),
        ...vector(light.direction ?? [0, -1, 0], 3, 'direction'), ...vector(light.up ?? [0, 1, 0], 3, 'up'),
        light.outer_angle_radians ?? 0.5, light.aspect ?? 1, light.z_near ?? 0.1, light.range ?? light.z_far ?? 100, light.border ?? light.gutter ?? 0,
        ...box(light.scene ?? light.receivers ?? no_box, 'scene'), Boolean(light.casters), ...box(light.casters ?? no_box, 'casters'),
        light.margin ?? 0, light.snap ?? false, ...vector(camera.view, 16, 'camera.view'),
        ...vector(camera.projection, 16, 'camera.projection'), camera.z_near, camera.z_far, count, light.lambda ?? 0,
        light.overlap ?? 0, light.blend_texels ?? 0,
        ...vector(light.picture ?? [1, 1], 2, 'picture'), light.target ?? 1, splits.length > 0, ...fill(splits, 9), ...fill(arguments_of(filter, light.filter), 4),
    ].map((value, i) => {
        const number = Number(value);
        must(!Number.isNaN(number), 'light must hold numbers', `${value} as number ${i}`);
        return number;
    });
}

/** Points with their normals, eight floats each, as C++ reads them. */
function seen_of({ points = [], normals = [] }) {
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
        const { settings } = shadow, all = complete(settings.kind, light), numbers = numbers_of(settings, all);
        const seen = seen_of(all), room = c.umbrage_seen(seen.length / 8);
        new Float64Array(memory().buffer, c.umbrage_input(), numbers.length).set(numbers);
        new Float32Array(memory().buffer, room, seen.length).set(seen);
        const stack = c.stackSave();
        let floats;
        try {
            floats = c.umbrage_values(kinds.indexOf(settings.kind), filters.indexOf(settings.filter.name), encodings.indexOf(settings.encoding));
        } finally { c.stackRestore(stack); }
        const at = c.umbrage_output(), block = new Float32Array(memory().buffer, at, floats).slice(), matrices = [];
        for (let i = 0; i < c.umbrage_matrices(); i += 16)
            matrices.push(new Float32Array(memory().buffer, at + 4 * (floats + i), 16).slice());
        return { block, matrices };
    };
}
export * from './module/clip_spaces.mjs';
