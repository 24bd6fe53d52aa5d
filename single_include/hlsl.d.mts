// umbrage 0.1.0, MIT License. Types of the texts in one language.
import type { BindingOf, BoundOf, EncodingName, EncodingOf, Exactness, Filter, FilterArgument, SnippetOf, Texture, WithReversed } from './module/types.mjs';

export type { Exactness, Filter, FilterArgument, Texture };
export type Snippet = SnippetOf<'hlsl'>;
export type Binding = BindingOf<'hlsl'>;
export type Bound = BoundOf<'hlsl'>;
export type Encoding = WithReversed<EncodingOf<'hlsl'>>;

/** The snippet as functions for one map: umbrage_<what>_<name>, or without a suffix when the name is empty. */
export function bind(what: Snippet, name: string, map?: Binding): Bound;
/** The worst tier of a text: of the snippets, of all they need, and of the hooks of the maps they are bound to. What a
 *  binding says in the shader's own language has no tier. */
export function exactness(items: readonly (Snippet | Bound)[]): Exactness;
/** The snippets, bound or not, and all they need, each once: text to paste into any shader. */
export function text(items: readonly (Snippet | Bound)[]): string;

/** All of them by name, for tools that walk them. */
export const snippets: Readonly<Record<string, Snippet>>;
export const encodings: Readonly<Record<EncodingName, Encoding>>;

/** A float texture: nothing to encode. */
export const depth32f: Encoding;
/** Two channels: R the low byte, G the rest in its high bits. */
export const rg9: Encoding;
/** Two channels: R the low byte, G the rest in its high bits. */
export const rg10: Encoding;
/** Two channels: R the low byte, G the rest in its high bits. */
export const rg11: Encoding;
/** Two channels: R the low byte, G the rest in its high bits. */
export const rg12: Encoding;
/** Two channels: R the low byte, G the rest in its high bits. */
export const rg13: Encoding;
/** Two channels: R the low byte, G the rest in its high bits. */
export const rg14: Encoding;
/** Two channels: R the low byte, G the rest in its high bits. */
export const rg15: Encoding;
/** Two channels: R the low byte, G the rest in its high bits. */
export const rg16: Encoding;
/** Three channels, R most significant. */
export const rgb24: Encoding;
/** Three 10-bit channels of R10G10B10A2, R most significant. */
export const rgb10: Encoding;
/** One channel of 16 bits. */
export const r16: Encoding;
/** The bit pattern of the float itself, R least significant. */
export const float_bits: Encoding;
/** RGBA of three.js since r167: three whole bytes and the rest. */
export const threejs_rgba: Encoding;
/** RGB of three.js since r167: two whole bytes and the rest. */
export const threejs_rgb: Encoding;
/** RG of three.js since r167: one whole byte and the rest. */
export const threejs_rg: Encoding;
/** RGBA of three.js r73 to r166, its fault included: 1 reads back as 255/256. */
export const threejs_legacy: Encoding;
/** For readers of three.js r73 to r166, written without the fault. */
export const threejs_legacy_repaired: Encoding;
/** Base 255, as in Cesium, Babylon.js and bgfx, its fault included: 1 reads back as 0. */
export const base255: Encoding;
/** For readers of base 255, written without the fault. */
export const base255_repaired: Encoding;
/** world to texels and depth, before the division */
export const shadow_coordinate: Snippet;
/** a tap's coordinate from the middle's, before the division */
export const tap_coordinate: Snippet;
/** the division by w, lit behind the light */
export const project_coordinate: Snippet;
/** cascade that a view depth falls into */
export const cascade_by_depth: Snippet;
/** one of four columns, without an index */
export const cascade_column: Snippet;
/** one of eight columns, without an index */
export const cascade_column_8: Snippet;
/** a point in the map of one cascade */
export const cascade_coordinate: Snippet;
/** coordinates whose filter stays inside a cascade */
export const inside_cascade: Snippet;
/** first cascade that holds a point and its filter */
export const cascade_by_projection: Snippet;
/** first of eight cascades that holds a point and its filter */
export const cascade_by_projection_8: Snippet;
/** first texel of a cascade in an atlas */
export const cascade_tile: Snippet;
/** a weight in steps of 1/256 */
export const cascade_weight: Snippet;
/** weight of the next cascade, by view depth */
export const cascade_fade: Snippet;
/** weight of the next cascade, by distance from the border */
export const cascade_border_fade: Snippet;
/** two cascades' visibilities, mixed */
export const blend_cascades: Snippet;
/** coordinates a filter can take */
export const inside_texel_space: Snippet;
/** one of 16 thresholds for a pixel */
export const dither_threshold: Snippet;
/** a cascade, or by its weight the next one */
export const dithered_cascade: Snippet;
/** face of a cube that a direction meets */
export const cube_face: Snippet;
/** distance along the axis of the face that a direction meets */
export const cube_view_z: Snippet;
/** a direction in its face's axes */
export const cube_plane: Snippet;
/** a point from a face's axes */
export const cube_point: Snippet;
/** a point in a face's axes */
export const cube_face_point: Snippet;
/** face, and where on it, that a direction meets */
export const cube_coordinate: Snippet;
/** direction to a point of a cube's face */
export const cube_direction: Snippet;
/** texel beyond an edge of a cube's face */
export const cube_neighbor: Snippet;
/** first texel of a face in an atlas */
export const cube_tile: Snippet;
/** face that a texel of an atlas belongs to, and where on it */
export const cube_atlas_texel: Snippet;
/** direction that reads an atlas' texel from a texture of a cube */
export const cube_atlas_direction: Snippet;
/** paraboloid map, and where in it, that sees a direction */
export const dual_paraboloid_coordinate: Snippet;
/** a vertex of a paraboloid map's depth pass */
export const dual_paraboloid_position: Snippet;
/** face of a tetrahedron that a direction meets */
export const tetrahedron_face: Snippet;
/** a direction in the axes of a tetrahedron's face */
export const tetrahedron_face_point: Snippet;
/** a direction in its tetrahedron face's axes */
export const tetrahedron_plane: Snippet;
/** distance along the normal of the tetrahedron's face that a direction meets */
export const tetrahedron_view_z: Snippet;
/** face of a tetrahedron, and where on it, that a direction meets */
export const tetrahedron_coordinate: Snippet;
/** a vector of a tetrahedron's first face on another face's side of the map */
export const tetrahedron_turned: Snippet;
/** a point of a tetrahedron's face in the map */
export const tetrahedron_texel: Snippet;
/** face of a tetrahedron that a texel belongs to */
export const tetrahedron_face_of: Snippet;
/** casters before the near plane, onto it */
export const pancake: Snippet;
/** texel inside a map */
export const texel: Snippet;
/** value read from an 8-bit texture to channel 0..255 */
export const from_unorm: Snippet;
/** a receiver in the page of an atlas that holds it */
export const page_coordinate: Snippet;
/** view-space z over z_far */
export const linear_depth: Snippet;
/** z / w, far behind the light */
export const project_depth: Snippet;
/** distance to the light over its range */
export const distance_depth: Snippet;
/** 1 - depth */
export const reverse_depth: Snippet;
/** z/w in [-1, 1] to depth in [0, 1] */
export const depth_from_ndc: Snippet;
/** perspective depth to view-space z */
export const view_z_from_depth: Snippet;
/** view-space z to perspective depth */
export const depth_from_view_z: Snippet;
/** reversed perspective depth to view-space z */
export const view_z_from_reversed_depth: Snippet;
/** view-space z to reversed perspective depth */
export const reversed_depth_from_view_z: Snippet;
/** orthographic depth to view-space z */
export const view_z_from_orthographic_depth: Snippet;
/** view-space z to orthographic depth */
export const orthographic_depth_from_view_z: Snippet;
/** depth of the far plane */
export const cleared_depth: Snippet;
/** clamp to [0, 1], NaN to far */
export const saturate: Snippet;
/** a quotient of whole numbers, from one at most one off */
export const correct_quotient: Snippet;
/** whole numbers divided and rounded down, whatever the division's error */
export const floor_divide: Snippet;
/** channel 0..255 to the value an 8-bit target stores as it */
export const to_unorm: Snippet;
/** channel 0..1023 to the value a 10-bit target stores as it */
export const to_unorm10: Snippet;
/** value read from a 10-bit texture to channel 0..1023 */
export const from_unorm10: Snippet;
/** channel 0..65535 to the value a 16-bit target stores as it */
export const to_unorm16: Snippet;
/** value read from a 16-bit texture to channel 0..65535 */
export const from_unorm16: Snippet;
/** depth to two channels, R the low byte */
export const encode_rg9: Snippet;
/** depth to two channels, R the low byte */
export const encode_rg10: Snippet;
/** depth to two channels, R the low byte */
export const encode_rg11: Snippet;
/** depth to two channels, R the low byte */
export const encode_rg12: Snippet;
/** depth to two channels, R the low byte */
export const encode_rg13: Snippet;
/** depth to two channels, R the low byte */
export const encode_rg14: Snippet;
/** depth to two channels, R the low byte */
export const encode_rg15: Snippet;
/** depth to two channels, R the low byte */
export const encode_rg16: Snippet;
/** depth to three channels, R most significant */
export const encode_rgb24: Snippet;
/** depth to three 10-bit channels, R most significant */
export const encode_rgb10: Snippet;
/** depth to one channel of 16 bits */
export const encode_r16: Snippet;
/** any float's bit pattern to four channels, R least significant */
export const encode_float_bits: Snippet;
/** depth to three.js RGBA, r167 and later */
export const write_threejs_rgba: Snippet;
/** depth to three.js RGB, r167 and later */
export const write_threejs_rgb: Snippet;
/** depth to three.js RG, r167 and later */
export const write_threejs_rg: Snippet;
/** depth to three.js RGBA, r73 to r166 */
export const write_threejs_legacy: Snippet;
/** depth for readers of three.js RGBA, r73 to r166, 1.0 repaired */
export const encode_threejs_legacy_repaired: Snippet;
/** depth to the base-255 RGBA format of Cesium, Babylon.js, bgfx */
export const write_base255: Snippet;
/** depth for readers of base-255 RGBA, 1.0 and truncation repaired */
export const encode_base255_repaired: Snippet;
/** texel of a map, outside the nearest one inside */
export const fetch_clamped: Snippet;
/** depth to two channels through a look-up texture */
export const encode_rg9_table: Snippet;
/** depth to two channels through a look-up texture */
export const encode_rg10_table: Snippet;
/** depth to two channels through a look-up texture */
export const encode_rg11_table: Snippet;
/** depth to two channels through a look-up texture */
export const encode_rg12_table: Snippet;
/** depth to two channels through a look-up texture */
export const encode_rg13_table: Snippet;
/** depth to two channels through a look-up texture */
export const encode_rg14_table: Snippet;
/** depth to two channels through a look-up texture */
export const encode_rg15_table: Snippet;
/** depth to two channels through a look-up texture */
export const encode_rg16_table: Snippet;
/** two channels, R the low byte, to depth */
export const decode_rg9: Snippet;
/** two channels, R the low byte, to depth */
export const decode_rg10: Snippet;
/** two channels, R the low byte, to depth */
export const decode_rg11: Snippet;
/** two channels, R the low byte, to depth */
export const decode_rg12: Snippet;
/** two channels, R the low byte, to depth */
export const decode_rg13: Snippet;
/** two channels, R the low byte, to depth */
export const decode_rg14: Snippet;
/** two channels, R the low byte, to depth */
export const decode_rg15: Snippet;
/** two channels, R the low byte, to depth */
export const decode_rg16: Snippet;
/** three channels, R most significant, to depth */
export const decode_rgb24: Snippet;
/** three 10-bit channels, R most significant, to depth */
export const decode_rgb10: Snippet;
/** one channel of 16 bits to depth */
export const decode_r16: Snippet;
/** four channels, R least significant, to the float they are */
export const decode_float_bits: Snippet;
/** three.js RGBA, r167 and later, to depth */
export const decode_threejs_rgba: Snippet;
/** three.js RGB, r167 and later, to depth */
export const decode_threejs_rgb: Snippet;
/** three.js RG, r167 and later, to depth */
export const decode_threejs_rg: Snippet;
/** three.js RGBA, r73 to r166, to depth */
export const decode_threejs_legacy: Snippet;
/** base-255 RGBA to depth */
export const decode_base255: Snippet;
/** two channels to a level to compare with */
export const level_rg9: Snippet;
/** two channels to a level to compare with */
export const level_rg10: Snippet;
/** two channels to a level to compare with */
export const level_rg11: Snippet;
/** two channels to a level to compare with */
export const level_rg12: Snippet;
/** two channels to a level to compare with */
export const level_rg13: Snippet;
/** two channels to a level to compare with */
export const level_rg14: Snippet;
/** two channels to a level to compare with */
export const level_rg15: Snippet;
/** two channels to a level to compare with */
export const level_rg16: Snippet;
/** receiver to a level, for maps that are not decoded */
export const receiver_rg9: Snippet;
/** receiver to a level, for maps that are not decoded */
export const receiver_rg10: Snippet;
/** receiver to a level, for maps that are not decoded */
export const receiver_rg11: Snippet;
/** receiver to a level, for maps that are not decoded */
export const receiver_rg12: Snippet;
/** receiver to a level, for maps that are not decoded */
export const receiver_rg13: Snippet;
/** receiver to a level, for maps that are not decoded */
export const receiver_rg14: Snippet;
/** receiver to a level, for maps that are not decoded */
export const receiver_rg15: Snippet;
/** receiver to a level, for maps that are not decoded */
export const receiver_rg16: Snippet;
/** r / 8 + g as the Radeon 8500 computed it */
export const decode_ps14: Snippet;
/** receiver on the scale of decode_ps14 */
export const receiver_ps14: Snippet;
/** whether a texel is one of the map's */
export const inside_map: Snippet;
/** texel of a map, outside a border value */
export const fetch_bordered: Snippet;
/** stored depth of a texel */
export const fetch_depth: Snippet;
/** stored depth at a point of the map */
export const depth_at: Snippet;
/** receivers behind the far plane */
export const beyond_far_plane: Snippet;
/** receivers that a filter compares; it takes the others as lit */
export const in_filter_domain: Snippet;
/** one comparison */
export const compare: Snippet;
/** one comparison with a texel */
export const lit: Snippet;
/** comparisons with the 2x2 texels from one on */
export const lit_2x2: Snippet;
/** whether a receiver of a prefiltered map lies in it */
export const map_covers: Snippet;
/** receivers up to the far plane, NaN is none */
export const within_far_plane: Snippet;
/** stored + epsilon < receiver is shadow */
export const compare_dx_sdk: Snippet;
/** current < stored + epsilon is lit */
export const compare_exercise: Snippet;
/** weighted count of lit texels under a window of 3 x 3 */
export const window_sum3: Snippet;
/** weighted count of lit texels under a window of 5 x 5 */
export const window_sum5: Snippet;
/** weighted count of lit texels under a window of 7 x 7 */
export const window_sum7: Snippet;
/** one of 16 turns for a pixel */
export const disc_rotation: Snippet;
/** the texel that a point of a disc falls on */
export const disc_tap: Snippet;
/** radius of a disc, down to 1/16 texel */
export const disc_radius: Snippet;
/** disc of 8 points, turned by the pixel */
export const disc8: Snippet;
/** disc of 16 points, turned by the pixel */
export const disc16: Snippet;
/** disc of 32 points, turned by the pixel */
export const disc32: Snippet;
/** nearest texel, one test */
export const hard: Snippet;
/** mean of four taps with coordinates of their own */
export const four_tap: Snippet;
/** bilinear 2x2, weights in steps of 1/256 */
export const pcf_2x2: Snippet;
/** bilinear 2x2 as the DirectX SDK sample, plain floats */
export const pcf_2x2_dx_sdk: Snippet;
/** lit texels in a box of radius 0..8 */
export const box_count: Snippet;
/** 1 / (2r+1)^2 */
export const box_scale: Snippet;
/** lit share of a box of radius 0..8 */
export const box: Snippet;
/** sliding window 1 1 */
export const tent2: Snippet;
/** sliding window 1 2 1 */
export const tent3: Snippet;
/** quadratic B-spline of 3 x 3 texels */
export const quadratic_b_spline: Snippet;
/** sliding window 1 4 6 4 1 */
export const binomial5: Snippet;
/** sliding window 5 16 22 16 5 */
export const castano_dyadic5: Snippet;
/** sliding window 1 3 4 3 1 */
export const castano5: Snippet;
/** sliding window 1 6 15 20 15 6 1 */
export const binomial7: Snippet;
/** sliding window 1 2 3 4 3 2 1 */
export const tent7: Snippet;
/** sliding window 1 5 12 16 12 5 1 */
export const castano7: Snippet;
/** one comparison with a texel of a cube */
export const cube_lit: Snippet;
/** 2 x 2 comparisons of a cube, over its edges too, bilinear weights */
export const pcf_2x2_cube: Snippet;
/** mean of four taps that a sampler of the nearest texel takes */
export const four_tap_hardware: Snippet;
/** comparisons around a point, weighted */
export const lit_filtered: Snippet;
/** comparisons around a point of the map, weighted */
export const lit_at: Snippet;
/** 2x2 by a comparison sampler with a linear filter */
export const pcf_2x2_hardware: Snippet;
/** window of 3 x 3 by 4 look-ups of a comparison sampler with a linear filter */
export const window_hardware3: Snippet;
/** window of 5 x 5 by 9 of them */
export const window_hardware5: Snippet;
/** window of 7 x 7 by 16 of them */
export const window_hardware7: Snippet;
/** disc of 8 points by a comparison sampler with a linear filter */
export const disc_hardware8: Snippet;
/** disc of 16 points by one */
export const disc_hardware16: Snippet;
/** disc of 32 points by one */
export const disc_hardware32: Snippet;
/** visibility where bounds of a filter's texels suffice */
export const bounds_lit: Snippet;
/** a depth as 16 bits of distance from the near plane */
export const distance_code: Snippet;
/** radius of a penumbra from the distance between blocker and receiver */
export const penumbra: Snippet;
/** whether a texel lies before a receiver, and how far from the light */
export const blocker: Snippet;
/** texels under a disc's points that lie before a receiver */
export const blockers8: Snippet;
/** texels under a disc's points that lie before a receiver */
export const blockers16: Snippet;
/** texels under a disc's points that lie before a receiver */
export const blockers32: Snippet;
/** percentage-closer soft shadows, 8 points twice */
export const pcss8: Snippet;
/** percentage-closer soft shadows, 16 points twice */
export const pcss16: Snippet;
/** percentage-closer soft shadows, 32 points twice */
export const pcss32: Snippet;
/** whether what a point of the map holds lies before a receiver, and its depth */
export const blocker_at: Snippet;
/** radius of a penumbra from the mean depth of blockers */
export const pcss_radius: Snippet;
/** what lies before a receiver at 8 points of a disc, by a sampler of the nearest texel */
export const blockers_hardware8: Snippet;
/** the same at 16 points */
export const blockers_hardware16: Snippet;
/** the same at 32 points */
export const blockers_hardware32: Snippet;
/** a disc's share in shadow, steepened */
export const hardened_kernel8: Snippet;
/** a disc's share in shadow, steepened */
export const hardened_kernel16: Snippet;
/** a disc's share in shadow, steepened */
export const hardened_kernel32: Snippet;
/** contact hardening by 8 points */
export const dpcf8: Snippet;
/** contact hardening by 16 points */
export const dpcf16: Snippet;
/** contact hardening by 32 points */
export const dpcf32: Snippet;
/** mean and squared distances from it over a box, from a summed-area table */
export const box_moments: Snippet;
/** variance shadow over a box of any size, from a summed-area table */
export const summed_variance: Snippet;
/** mean of four whole numbers over a box, from a summed-area table in two halves */
export const box_mean: Snippet;
/** four channels of 16 bits to four moments */
export const from_optimized_moments: Snippet;
/** four moments, moved a little towards those of spread depths */
export const bias_moments: Snippet;
/** depth that grows with distance */
export const to_forward_depth: Snippet;
/** the two depths that make four moments beside a receiver's */
export const moment_atoms: Snippet;
/** mean of four moments to visibility */
export const decode_msm: Snippet;
/** moment shadow over a box of any size, from a summed-area table */
export const summed_moments: Snippet;
/** 2^n of whole numbers -64 to 63 */
export const power_of_two: Snippet;
/** 2^y to 1.8e-7 of it */
export const exp2_polynomial: Snippet;
/** 2^y in steps of 12 bits */
export const exp2_steps: Snippet;
/** most that mean and variance let be lit */
export const chebyshev: Snippet;
/** visibility without its least values */
export const reduce_light_bleeding: Snippet;
/** depth to a texel of a variance shadow map */
export const encode_vsm: Snippet;
/** mean of texels of a variance shadow map to visibility */
export const decode_vsm: Snippet;
/** depth's two moments to mean and deviation */
export const encode_deviation: Snippet;
/** mean and deviation to depth's two moments */
export const decode_deviation: Snippet;
/** mean and deviation in four channels to depth's two moments */
export const decode_deviation_rgba8: Snippet;
/** depth on the scale of exponential shadow maps */
export const exponential_warp: Snippet;
/** depth to a texel of an exponential shadow map */
export const encode_esm: Snippet;
/** mean of texels of an exponential shadow map to visibility */
export const decode_esm: Snippet;
/** depth to a texel of two components */
export const encode_evsm2: Snippet;
/** depth to a texel of four components */
export const encode_evsm4: Snippet;
/** mean of texels of two components to visibility */
export const decode_evsm2: Snippet;
/** mean of texels of four components to visibility */
export const decode_evsm4: Snippet;
/** depth to its first four powers on [-1, 1] */
export const encode_msm: Snippet;
/** four moments to four channels of 16 bits */
export const to_optimized_moments: Snippet;
/** least share of depths before a receiver, of depths on [-1, 1] */
export const hausdorff_share: Snippet;
/** mean of four moments of depths on [-1, 1] to visibility */
export const decode_msm_hausdorff: Snippet;
/** mean of the four texels around a point */
export const fetch_bilinear: Snippet;
/** visibility from a map of encode_vsm's texels */
export const vsm: Snippet;
/** visibility from a map of encode_esm's texels */
export const esm: Snippet;
/** visibility from a map of encode_evsm2's texels */
export const evsm2: Snippet;
/** visibility from a map of encode_evsm4's texels */
export const evsm4: Snippet;
/** visibility from a map of encode_msm's texels */
export const msm: Snippet;
/** visibility from a map of turned moments */
export const msm_unorm16: Snippet;
/** visibility from a map of encode_msm's texels */
export const msm_hausdorff: Snippet;
/** most that a variance lets be lit, less the light that bleeds */
export const chebyshev_hardware: Snippet;
/** mean and deviation to visibility, the cheapest way */
export const decode_vsm_hardware: Snippet;
/** mean of texels of two components to visibility, by the GPU's own exp2 */
export const decode_evsm2_hardware: Snippet;
/** mean of texels of four components to visibility, by the GPU's own exp2 */
export const decode_evsm4_hardware: Snippet;
/** mean of texels in a row */
export const blur_row3: Snippet;
/** mean of texels in a row */
export const blur_row5: Snippet;
/** mean of texels in a row */
export const blur_row7: Snippet;
/** mean of 2x2 texels */
export const halve_texels: Snippet;
/** texels across a light as world units */
export const texels_to_world: Snippet;
/** clamp of a bias to [0, 1], NaN to 1 */
export const clamp_bias: Snippet;
/** world units along a light as depth */
export const world_to_depth: Snippet;
/** receiver moved towards the light */
export const biased: Snippet;
/** clamp of a slope to [-2, 2], NaN to 2 */
export const clamp_slope: Snippet;
/** change of a plane's depth from texel to texel */
export const plane_slope: Snippet;
/** change of a receiver's depth from texel to texel */
export const receiver_slope: Snippet;
/** change of a plane's depth from texel to texel of a cascade */
export const cascade_slope: Snippet;
/** bias by the greater slope, as rasterizers have it */
export const slope_bias: Snippet;
/** change of distance from texel to texel of a paraboloid's map */
export const dual_paraboloid_slope: Snippet;
/** way off a surface to the point that is looked up in its place */
export const normal_offset: Snippet;
/** bias by the kernel's width and the angle at which light falls */
export const kernel_bias: Snippet;
/** slope of a receiver's plane from derivatives, and how far it may be off */
export const receiver_plane_slope: Snippet;
/** stored depth moved along the receiver's plane to the receiver */
export const apply_receiver_plane: Snippet;
/** smallest bias without acne, for a slope, a reach and an encoding's error */
export const acne_free_bias: Snippet;
/** smallest bias without acne, for filters that read a disc */
export const acne_free_disc_bias: Snippet;
/** depth before a receiver within which its bias loses a caster's shadow */
export const peter_panning_distance: Snippet;
/** 1 inside a spot light's cone */
export const spot_cone: Snippet;
/** diffuse plus ambient light of a surface */
export const diffuse_ambient: Snippet;
/** 0..1 to blue, green, red */
export const false_color: Snippet;
/** which texel of a map stretched over the picture's corner a pixel shows, along one side */
export const overlay_texel: Snippet;
/** debug color of a place in a map: its texels, or why it cannot be shadowed */
export const probe_color: Snippet;
/** debug color, unless position or normal are wrong */
export const probe_inputs: Snippet;

