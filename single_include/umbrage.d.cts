// umbrage 0.1.0, MIT License. Types of the texts in one language.
import type { BindingOf, BoundOf, DebugOf, EncodingName, EncodingOf, Exactness, Filter, FilterArgument, LightOf, ShadowOf,
    ShadowOptionsOf, SnippetOf, Texture, WithReversed } from './module/types.cjs';

export type { Exactness, Filter, FilterArgument, Texture };
export type Snippet = SnippetOf<'glsl'>;
export type Binding = BindingOf<'glsl'>;
export type Bound = BoundOf<'glsl'>;
export type Encoding = WithReversed<EncodingOf<'glsl'>>;
export type Light = LightOf<'glsl'>;
export type ShadowOptions = ShadowOptionsOf<'glsl'>;
export type Shadow = ShadowOf<'glsl'>;

/** The snippet as functions for one map: umbrage_<what>_<name>, or without a suffix when the name is empty. */
export function bind(what: Snippet, name: string, map?: Binding): Bound;
/** The worst tier of a text: of the snippets, of all they need, and of the hooks of the maps they are bound to. What a
 *  binding says in the shader's own language has no tier. */
export function exactness(items: readonly (Snippet | Bound)[]): Exactness;
/** For an option of shadow(). */
export const debug: DebugOf<'glsl'>;
/** A light's shadow as functions of a shader, its maps' target and its depth pass. */
export function shadow(name: string, options: ShadowOptions): Shadow;
export type Version =
    '100' | '110' | '120' | '130' | '150' | '300 es' | '310 es' | '320 es' | '330' | '430' | '450' | '460';
export const versions: readonly Version[];
/** True when the snippet, or the snippet bound to its map, compiles in a dialect of GLSL.
 *  @throws Error   another version */
export function supports(item: Snippet | Bound, version: Version): boolean;
/** The beginning of a GLSL shader: #version, preamble, the snippets and all they need. A preamble brings `precise` to
 *  310 es by `#extension GL_EXT_gpu_shader5 : require` and `#define UMBRAGE_PRECISE precise`. */
export function source(version: Version, items: readonly (Snippet | Bound)[], preamble?: string): string;
/** A GLSL text of the snippets and all they need, to paste into any shader; or into one of the version, for engines whose
 *  preprocessors do not know __VERSION__. */
export function text(items: readonly (Snippet | Bound)[], version?: Version): string;

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
/** RGBA of three.js since r167: three bytes and a fraction. */
export const threejs_rgba: Encoding;
/** RGB of three.js since r167: two bytes and a fraction. */
export const threejs_rgb: Encoding;
/** RG of three.js since r167: one byte and a fraction. */
export const threejs_rg: Encoding;
/** RGBA of three.js r73 to r166, its fault included: 1 reads back as 255/256. */
export const threejs_legacy: Encoding;
/** For readers of three.js r73 to r166, written without the fault. */
export const threejs_legacy_repaired: Encoding;
/** Base 255, as in Cesium, Babylon.js and bgfx, its fault included: 1 reads back as 0. */
export const base255: Encoding;
/** For readers of base 255, written without the fault. */
export const base255_repaired: Encoding;
/** One map of a spot light. */
export const spot_light: Light;
/** One map of a directional light. */
export const directional_light: Light;
/** One to four cascades of a directional light. */
export const cascades: Light;
/** Five to eight cascades of a directional light. */
export const cascades_8: Light;
/** Six maps around a point light. */
export const point_light: Light;
/** Four maps around a point light in one square. */
export const tetrahedron_light: Light;
/** Two maps around a point light. */
export const dual_paraboloid_light: Light;
/** One to four cascades of a directional light, warped along the view (LiSPSM). */
export const warped_cascades: Light;
/** Up to 64 pages of a directional light's virtual shadow map (adaptive shadow map). */
export const adaptive_pages: Light;
/** world to texels and depth, before the division by w */
export const shadow_coordinate: Snippet;
/** coordinate of a tap from the center's, before division by w */
export const tap_coordinate: Snippet;
/** division by w; lit behind the light */
export const project_coordinate: Snippet;
/** cascade that contains a view depth */
export const cascade_by_depth: Snippet;
/** one of four columns, without dynamic indexing */
export const cascade_column: Snippet;
/** one of eight columns, without dynamic indexing */
export const cascade_column_8: Snippet;
/** position of a point in one cascade's map */
export const cascade_coordinate: Snippet;
/** true if a filter stays inside a cascade */
export const inside_cascade: Snippet;
/** first cascade that contains a point and its filter */
export const cascade_by_projection: Snippet;
/** first of eight cascades that contains a point and its filter */
export const cascade_by_projection_8: Snippet;
/** first texel of a cascade in an atlas */
export const cascade_tile: Snippet;
/** weight in steps of 1/256 */
export const cascade_weight: Snippet;
/** weight of the next cascade, by view depth */
export const cascade_fade: Snippet;
/** weight of the next cascade, by distance from the border */
export const cascade_border_fade: Snippet;
/** blend of two cascades' visibilities */
export const blend_cascades: Snippet;
/** true for coordinates that a filter can take */
export const inside_texel_space: Snippet;
/** one of 16 dither thresholds for a pixel */
export const dither_threshold: Snippet;
/** cascade of a pixel, or the next one, by its weight */
export const dithered_cascade: Snippet;
/** face of a cube that a direction meets */
export const cube_face: Snippet;
/** distance along the axis of a direction's face */
export const cube_view_z: Snippet;
/** direction in the axes of its face */
export const cube_plane: Snippet;
/** point from a face's axes */
export const cube_point: Snippet;
/** point in a face's axes */
export const cube_face_point: Snippet;
/** face of a direction, and the position on it */
export const cube_coordinate: Snippet;
/** direction to a point of a cube's face */
export const cube_direction: Snippet;
/** texel beyond an edge of a cube's face */
export const cube_neighbor: Snippet;
/** first texel of a face in an atlas */
export const cube_tile: Snippet;
/** face of an atlas texel, and the position on it */
export const cube_atlas_texel: Snippet;
/** direction that reads an atlas texel from a cube texture */
export const cube_atlas_direction: Snippet;
/** paraboloid map that sees a direction, and position in it */
export const dual_paraboloid_coordinate: Snippet;
/** position of a vertex in a paraboloid map's depth pass */
export const dual_paraboloid_position: Snippet;
/** face of a tetrahedron that a direction meets */
export const tetrahedron_face: Snippet;
/** direction in the axes of a tetrahedron's face */
export const tetrahedron_face_point: Snippet;
/** direction in the axes of its tetrahedron face */
export const tetrahedron_plane: Snippet;
/** distance along the normal of a direction's face */
export const tetrahedron_view_z: Snippet;
/** tetrahedron face of a direction, and the position on it */
export const tetrahedron_coordinate: Snippet;
/** vector rotated from face 0's part of the map to another's */
export const tetrahedron_turned: Snippet;
/** position in the map of a point on a tetrahedron's face */
export const tetrahedron_texel: Snippet;
/** face of a tetrahedron that contains a texel */
export const tetrahedron_face_of: Snippet;
/** casters clamped to the near plane (pancaking) */
export const pancake: Snippet;
/** texel inside a map */
export const texel: Snippet;
/** channel 0..255 of a value from an 8-bit texture */
export const from_unorm: Snippet;
/** position of a receiver in the atlas page that holds it */
export const page_coordinate: Snippet;
/** first texel of a page in an atlas of eight a row */
export const page_tile: Snippet;
/** view-space z over z_far */
export const linear_depth: Snippet;
/** z / w, and the far plane behind the light */
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
/** clamp to [0, 1]; NaN becomes the far plane */
export const saturate: Snippet;
/** floor of a quotient, from a guess off by at most one */
export const correct_quotient: Snippet;
/** integer division that rounds down, exact on any GPU */
export const floor_divide: Snippet;
/** value that makes an 8-bit target store channel 0..255 */
export const to_unorm: Snippet;
/** value that makes a 10-bit target store channel 0..1023 */
export const to_unorm10: Snippet;
/** channel 0..1023 of a value from a 10-bit texture */
export const from_unorm10: Snippet;
/** value that makes a 16-bit target store channel 0..65535 */
export const to_unorm16: Snippet;
/** channel 0..65535 of a value from a 16-bit texture */
export const from_unorm16: Snippet;
/** depth to two 8-bit channels, R the low byte */
export const encode_rg9: Snippet;
/** depth to two 8-bit channels, R the low byte */
export const encode_rg10: Snippet;
/** depth to two 8-bit channels, R the low byte */
export const encode_rg11: Snippet;
/** depth to two 8-bit channels, R the low byte */
export const encode_rg12: Snippet;
/** depth to two 8-bit channels, R the low byte */
export const encode_rg13: Snippet;
/** depth to two 8-bit channels, R the low byte */
export const encode_rg14: Snippet;
/** depth to two 8-bit channels, R the low byte */
export const encode_rg15: Snippet;
/** depth to two 8-bit channels, R the low byte */
export const encode_rg16: Snippet;
/** depth to three 8-bit channels, R most significant */
export const encode_rgb24: Snippet;
/** depth to three 10-bit channels, R most significant */
export const encode_rgb10: Snippet;
/** depth to one 16-bit channel */
export const encode_r16: Snippet;
/** bit pattern of a float to four channels, R least significant */
export const encode_float_bits: Snippet;
/** depth to three.js RGBA, r167 and later */
export const write_threejs_rgba: Snippet;
/** depth to three.js RGB, r167 and later */
export const write_threejs_rgb: Snippet;
/** depth to three.js RG, r167 and later */
export const write_threejs_rg: Snippet;
/** depth to three.js RGBA, r73 to r166 */
export const write_threejs_legacy: Snippet;
/** depth to three.js RGBA, r73 to r166, without its fault */
export const encode_threejs_legacy_repaired: Snippet;
/** depth to base-255 RGBA of Cesium, Babylon.js, bgfx */
export const write_base255: Snippet;
/** depth to base-255 RGBA without its faults */
export const encode_base255_repaired: Snippet;
/** texel of a map, clamped to the nearest one inside */
export const fetch_clamped: Snippet;
/** depth to two 8-bit channels through a lookup texture */
export const encode_rg9_table: Snippet;
/** depth to two 8-bit channels through a lookup texture */
export const encode_rg10_table: Snippet;
/** depth to two 8-bit channels through a lookup texture */
export const encode_rg11_table: Snippet;
/** depth to two 8-bit channels through a lookup texture */
export const encode_rg12_table: Snippet;
/** depth to two 8-bit channels through a lookup texture */
export const encode_rg13_table: Snippet;
/** depth to two 8-bit channels through a lookup texture */
export const encode_rg14_table: Snippet;
/** depth to two 8-bit channels through a lookup texture */
export const encode_rg15_table: Snippet;
/** depth to two 8-bit channels through a lookup texture */
export const encode_rg16_table: Snippet;
/** two 8-bit channels, R the low byte, to depth */
export const decode_rg9: Snippet;
/** two 8-bit channels, R the low byte, to depth */
export const decode_rg10: Snippet;
/** two 8-bit channels, R the low byte, to depth */
export const decode_rg11: Snippet;
/** two 8-bit channels, R the low byte, to depth */
export const decode_rg12: Snippet;
/** two 8-bit channels, R the low byte, to depth */
export const decode_rg13: Snippet;
/** two 8-bit channels, R the low byte, to depth */
export const decode_rg14: Snippet;
/** two 8-bit channels, R the low byte, to depth */
export const decode_rg15: Snippet;
/** two 8-bit channels, R the low byte, to depth */
export const decode_rg16: Snippet;
/** three 8-bit channels, R most significant, to depth */
export const decode_rgb24: Snippet;
/** three 10-bit channels, R most significant, to depth */
export const decode_rgb10: Snippet;
/** one 16-bit channel to depth */
export const decode_r16: Snippet;
/** four channels, R least significant, to the float they hold */
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
/** two channels to a level, for maps that are not decoded */
export const level_rg9: Snippet;
/** two channels to a level, for maps that are not decoded */
export const level_rg10: Snippet;
/** two channels to a level, for maps that are not decoded */
export const level_rg11: Snippet;
/** two channels to a level, for maps that are not decoded */
export const level_rg12: Snippet;
/** two channels to a level, for maps that are not decoded */
export const level_rg13: Snippet;
/** two channels to a level, for maps that are not decoded */
export const level_rg14: Snippet;
/** two channels to a level, for maps that are not decoded */
export const level_rg15: Snippet;
/** two channels to a level, for maps that are not decoded */
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
/** receiver depth on the scale of decode_ps14 */
export const receiver_ps14: Snippet;
/** number in a register of the Radeon 8500 */
export const fixed_ps14: Snippet;
/** r / 8 + g in the Radeon 8500's fixed point */
export const decode_fixed_ps14: Snippet;
/** true if a texel lies inside the map */
export const inside_map: Snippet;
/** texel of a map, or a border value outside it */
export const fetch_bordered: Snippet;
/** stored depth of a texel */
export const fetch_depth: Snippet;
/** stored depth at a point of the map */
export const depth_at: Snippet;
/** receivers beyond the far plane */
export const beyond_far_plane: Snippet;
/** true for receivers that a filter compares; others are lit */
export const in_filter_domain: Snippet;
/** visibility from one comparison */
export const compare: Snippet;
/** visibility from one comparison with a texel */
export const lit: Snippet;
/** visibility from comparisons with 2x2 texels */
export const lit_2x2: Snippet;
/** true if a receiver lies in a prefiltered map */
export const map_covers: Snippet;
/** receivers up to the far plane; NaN is not */
export const within_far_plane: Snippet;
/** shadow if stored + epsilon < receiver */
export const compare_dx_sdk: Snippet;
/** lit if current < stored + epsilon */
export const compare_exercise: Snippet;
/** weighted count of lit texels under a 3x3 kernel */
export const window_sum3: Snippet;
/** weighted count of lit texels under a 5x5 kernel */
export const window_sum5: Snippet;
/** weighted count of lit texels under a 7x7 kernel */
export const window_sum7: Snippet;
/** rotation of a disc for a pixel, one of 16 */
export const disc_rotation: Snippet;
/** texel that a point of a disc falls on */
export const disc_tap: Snippet;
/** radius of a disc, rounded down to 1/16 texel */
export const disc_radius: Snippet;
/** disc PCF, 8 points, rotated per pixel */
export const disc8: Snippet;
/** disc PCF, 16 points, rotated per pixel */
export const disc16: Snippet;
/** disc PCF, 32 points, rotated per pixel */
export const disc32: Snippet;
/** unfiltered shadow test of the nearest texel */
export const hard: Snippet;
/** mean of four taps, each with its own coordinates */
export const four_tap: Snippet;
/** bilinear 2x2 PCF, weights in steps of 1/256 */
export const pcf_2x2: Snippet;
/** bilinear 2x2 PCF of the DirectX SDK sample, plain floats */
export const pcf_2x2_dx_sdk: Snippet;
/** number of lit texels in a box of radius 0..8 */
export const box_count: Snippet;
/** 1 / (2r+1)^2 */
export const box_scale: Snippet;
/** lit fraction of a box of radius 0..8 (box PCF) */
export const box: Snippet;
/** PCF kernel 1 1 */
export const tent2: Snippet;
/** PCF kernel 1 2 1 */
export const tent3: Snippet;
/** PCF kernel of the quadratic B-spline, 3x3 texels */
export const quadratic_b_spline: Snippet;
/** PCF kernel 1 4 6 4 1 */
export const binomial5: Snippet;
/** PCF kernel 5 16 22 16 5 */
export const castano_dyadic5: Snippet;
/** PCF kernel 1 3 4 3 1 */
export const castano5: Snippet;
/** PCF kernel 1 6 15 20 15 6 1 */
export const binomial7: Snippet;
/** PCF kernel 1 2 3 4 3 2 1 */
export const tent7: Snippet;
/** PCF kernel 1 5 12 16 12 5 1 */
export const castano7: Snippet;
/** one comparison with a texel of a cube map */
export const cube_lit: Snippet;
/** bilinear 2x2 PCF of a cube map, across its edges */
export const pcf_2x2_cube: Snippet;
/** mean of four taps from a nearest-texel sampler */
export const four_tap_hardware: Snippet;
/** weighted comparisons around a point in texels */
export const lit_filtered: Snippet;
/** weighted comparisons around a point in [0, 1] */
export const lit_at: Snippet;
/** bilinear 2x2 PCF by a linear comparison sampler */
export const pcf_2x2_hardware: Snippet;
/** 3x3 kernel, 4 fetches from a linear comparison sampler */
export const window_hardware3: Snippet;
/** 5x5 kernel, 9 fetches from a linear comparison sampler */
export const window_hardware5: Snippet;
/** 7x7 kernel, 16 fetches from a linear comparison sampler */
export const window_hardware7: Snippet;
/** disc PCF, 8 fetches from a linear comparison sampler */
export const disc_hardware8: Snippet;
/** disc PCF, 16 fetches from a linear comparison sampler */
export const disc_hardware16: Snippet;
/** disc PCF, 32 fetches from a linear comparison sampler */
export const disc_hardware32: Snippet;
/** visibility from depth bounds, an early exit of a filter */
export const bounds_lit: Snippet;
/** distance of a depth from the near plane, 16 bits */
export const distance_code: Snippet;
/** radius of a penumbra from the distance to the blocker */
export const penumbra: Snippet;
/** count and distance code of one possible blocker */
export const blocker: Snippet;
/** blocker search over a disc's points */
export const blockers8: Snippet;
/** blocker search over a disc's points */
export const blockers16: Snippet;
/** blocker search over a disc's points */
export const blockers32: Snippet;
/** percentage-closer soft shadows (PCSS), 8 points twice */
export const pcss8: Snippet;
/** percentage-closer soft shadows (PCSS), 16 points twice */
export const pcss16: Snippet;
/** percentage-closer soft shadows (PCSS), 32 points twice */
export const pcss32: Snippet;
/** count and depth of one possible blocker */
export const blocker_at: Snippet;
/** penumbra radius from the mean depth of blockers */
export const pcss_radius: Snippet;
/** blocker search, 8 points of a nearest-texel sampler */
export const blockers_hardware8: Snippet;
/** blocker search, 16 points of a nearest-texel sampler */
export const blockers_hardware16: Snippet;
/** blocker search, 32 points of a nearest-texel sampler */
export const blockers_hardware32: Snippet;
/** fraction of a disc in shadow, steepened */
export const hardened_kernel8: Snippet;
/** fraction of a disc in shadow, steepened */
export const hardened_kernel16: Snippet;
/** fraction of a disc in shadow, steepened */
export const hardened_kernel32: Snippet;
/** contact hardening from one pass (DPCF), 8 points */
export const dpcf8: Snippet;
/** contact hardening from one pass (DPCF), 16 points */
export const dpcf16: Snippet;
/** contact hardening from one pass (DPCF), 32 points */
export const dpcf32: Snippet;
/** mean and squared distances over a box, from a SAT */
export const box_moments: Snippet;
/** variance shadow over a box of any size, from a SAT */
export const summed_variance: Snippet;
/** mean of four integers over a box, from a SAT in two halves */
export const box_mean: Snippet;
/** four 16-bit channels to four moments (MSM) */
export const from_optimized_moments: Snippet;
/** four moments (MSM) with a bias against rounding */
export const bias_moments: Snippet;
/** depth that grows with the distance from the light */
export const to_forward_depth: Snippet;
/** two depths that have the moments with the receiver's */
export const moment_atoms: Snippet;
/** mean of MSM texels to visibility */
export const decode_msm: Snippet;
/** moment shadow over a box of any size, from a SAT */
export const summed_moments: Snippet;
/** 2^n of integers n from -64 to 63 */
export const power_of_two: Snippet;
/** 2^y, off by at most 1.8e-7 of itself */
export const exp2_polynomial: Snippet;
/** 2^y in steps of 12 bits */
export const exp2_steps: Snippet;
/** upper bound on visibility from mean and variance */
export const chebyshev: Snippet;
/** visibility above a threshold, stretched to [0, 1] */
export const reduce_light_bleeding: Snippet;
/** depth to a texel of a variance shadow map (VSM) */
export const encode_vsm: Snippet;
/** mean of VSM texels to visibility */
export const decode_vsm: Snippet;
/** two moments of depth (VSM) to mean and deviation */
export const encode_deviation: Snippet;
/** mean and deviation to two moments of depth (VSM) */
export const decode_deviation: Snippet;
/** mean and deviation in RGBA8 to two moments (VSM) */
export const decode_deviation_rgba8: Snippet;
/** depth on the scale of exponential shadow maps */
export const exponential_warp: Snippet;
/** depth to a texel of an exponential shadow map (ESM) */
export const encode_esm: Snippet;
/** mean of ESM texels to visibility */
export const decode_esm: Snippet;
/** depth to an EVSM texel of two components */
export const encode_evsm2: Snippet;
/** depth to an EVSM texel of four components */
export const encode_evsm4: Snippet;
/** mean of EVSM texels of two components to visibility */
export const decode_evsm2: Snippet;
/** mean of EVSM texels of four components to visibility */
export const decode_evsm4: Snippet;
/** depth to a texel of a moment shadow map (MSM) */
export const encode_msm: Snippet;
/** four moments (MSM) to four 16-bit channels */
export const to_optimized_moments: Snippet;
/** smallest fraction of nearer depths, for depths on [-1, 1] */
export const hausdorff_share: Snippet;
/** mean of MSM texels to visibility, for depths on [-1, 1] */
export const decode_msm_hausdorff: Snippet;
/** bilinear mean of the four texels around a point */
export const fetch_bilinear: Snippet;
/** visibility from a blurred variance shadow map (VSM) */
export const vsm: Snippet;
/** visibility from a blurred exponential shadow map (ESM) */
export const esm: Snippet;
/** visibility from a blurred EVSM of two components */
export const evsm2: Snippet;
/** visibility from a blurred EVSM of four components */
export const evsm4: Snippet;
/** visibility from a blurred moment shadow map (MSM) */
export const msm: Snippet;
/** visibility from a blurred MSM of optimized moments */
export const msm_unorm16: Snippet;
/** visibility from a blurred MSM, for depths on [-1, 1] */
export const msm_hausdorff: Snippet;
/** Chebyshev bound with light bleeding reduced */
export const chebyshev_hardware: Snippet;
/** mean and deviation (VSM) to visibility, cheapest on GPUs */
export const decode_vsm_hardware: Snippet;
/** EVSM of two components to visibility, by the GPU's exp2 */
export const decode_evsm2_hardware: Snippet;
/** EVSM of four components to visibility, by the GPU's exp2 */
export const decode_evsm4_hardware: Snippet;
/** binomial mean of texels in a row, for blurs */
export const blur_row3: Snippet;
/** binomial mean of texels in a row, for blurs */
export const blur_row5: Snippet;
/** binomial mean of texels in a row, for blurs */
export const blur_row7: Snippet;
/** mean of 2x2 texels, for mip chains */
export const halve_texels: Snippet;
/** texels across a light to world units */
export const texels_to_world: Snippet;
/** clamp of a bias to [0, 1]; NaN becomes 1 */
export const clamp_bias: Snippet;
/** world units along a light to depth */
export const world_to_depth: Snippet;
/** receiver moved towards the light */
export const biased: Snippet;
/** clamp of a slope to [-2, 2]; NaN becomes 2 */
export const clamp_slope: Snippet;
/** change of a plane's depth per texel */
export const plane_slope: Snippet;
/** change of a receiver's depth per texel */
export const receiver_slope: Snippet;
/** change of a plane's depth per texel in a cascade */
export const cascade_slope: Snippet;
/** slope-scaled bias, as rasterizers compute it */
export const slope_bias: Snippet;
/** change of distance per texel in a dual paraboloid map */
export const dual_paraboloid_slope: Snippet;
/** offset along the normal to the point to look up */
export const normal_offset: Snippet;
/** bias from kernel width and angle of the light */
export const kernel_bias: Snippet;
/** slope of a receiver's plane from derivatives, and its error */
export const receiver_plane_slope: Snippet;
/** stored depth moved along the receiver's plane to it */
export const apply_receiver_plane: Snippet;
/** smallest bias without acne, from slope, reach and error */
export const acne_free_bias: Snippet;
/** smallest bias without acne, for filters that read a disc */
export const acne_free_disc_bias: Snippet;
/** depth within which a bias detaches shadows (peter-panning) */
export const peter_panning_distance: Snippet;
/** 1 inside a spot light's cone, else 0 */
export const spot_cone: Snippet;
/** diffuse plus ambient light of a surface */
export const diffuse_ambient: Snippet;
/** depth 0..1 as a color from blue over green to red */
export const false_color: Snippet;
/** texel under a pixel of a map drawn in the picture's corner */
export const overlay_texel: Snippet;
/** debug color of a lookup: its texels, or why it fails */
export const probe_color: Snippet;
/** debug color, unless position or normal is wrong */
export const probe_inputs: Snippet;

