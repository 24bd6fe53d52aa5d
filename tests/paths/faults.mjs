// SPDX-License-Identifier: MIT
//
// Mistakes that a page or the package could make between values() and the GPU. The judge has to see each.
const several = ({ setup }) => /cascades|pages|point/.test(setup);  // paraboloids share a view
const bulb = ({ setup }) => /point|tetrahedron|paraboloid/.test(setup);
const transposed = m => m.map((_, i) => m[i % 4 * 4 + (i >> 2)]);
const each_view = (given, change) =>
    ({ ...given, views: given.views.map(({ to_clip, anchor }) => change(to_clip.slice(), anchor.slice())) });
/** The block of a light that differs, with the views of the right one. */
const other_block = change => (given, all) => ({ ...given, block: all.values(...change(all)).block });
/** A value of the light that was left out, so that its default took its place. */
const defaults = { spot_light: 'outer_angle_radians', directional_light: 'margin', cascades: 'lambda',
    point_light: 'z_near', tetrahedron_light: 'z_near', dual_paraboloid_light: 'range' };
const values_of = { outer_angle_radians: Math.PI / 6, margin: 0.1, lambda: 0.5, z_near: 0.1, range: 100 };

/** By name: which paths have it, and how it changes what the page has of values(). */
export const faults = {
    'a block without the map\'s size': { fits: ({ setup }) => setup === 'spot_light',
        make: given => ({ ...given, block: given.block.map((x, i, { length }) => (i === length - 8 || i === length - 7 ? 0 : x)) }) },
    'a transposed matrix of a depth pass': { fits: ({ setup }) => setup !== 'dual_paraboloid_light',
        make: given => each_view(given, (to_clip, anchor) => ({ to_clip: transposed(to_clip), anchor })) },
    'a transposed matrix in the block': { fits: ({ setup }) => ['spot_light', 'directional_light'].includes(setup),
        make: given => ({ ...given, block: Float32Array.from([...transposed(given.block.slice(0, 16)), ...given.block.slice(16)]) }) },
    'a block of the size before': { fits: ({ setup }) => setup !== 'adaptive_pages',
        make: other_block(({ glsl, path, light, options }) =>
            [glsl.shadow('sun', options({ ...path, map_size: path.map_size / 2 })), light]) },
    'views of the light before': { fits: path => path.setup !== 'adaptive_pages',
        make: (given, { values, sun, before }) => ({ ...given, views: values(sun, before).views }) },
    'a border of one texel more': { fits: bulb,
        make: other_block(({ sun, light }) => [sun, { ...light, border: light.border + 1 }]) },
    'a default in place of a value': { fits: ({ setup }) => setup in defaults,
        make: other_block(({ sun, light, path }) =>
            [sun, { ...light, [defaults[path.setup]]: values_of[defaults[path.setup]] }]) },
    'an origin left out of the block': { fits: ({ origin }) => origin.some(x => x),
        make: other_block(({ sun, light }) => [sun, { ...light, origin: [0, 0, 0] }]) },
    'an anchor of zero': { fits: ({ setup }) => setup !== 'dual_paraboloid_light',
        make: given => each_view(given, to_clip => ({ to_clip, anchor: new Float32Array(4) })) },
    'maps in the wrong order': { fits: several, make: given => ({ ...given, views: given.views.slice().reverse() }) },
    'maps that are one texel aside': { fits: ({ setup }) => setup !== 'dual_paraboloid_light',
        make: (given, { sun }) => each_view(given, (to_clip, anchor) => {
            for (let column = 0; column < 4; ++column) to_clip[4 * column] += 2 / sun.target.map_size[0] * to_clip[4 * column + 3];
            return { to_clip, anchor };
        }) },
    'a comparison the wrong way round': { fits: ({ map }) => map.startsWith('shadow'),
        make: (given, { path }) => ({ ...given, compare: path.direction === 'reversed' ? 'LEQUAL' : 'GEQUAL' }) },
};
