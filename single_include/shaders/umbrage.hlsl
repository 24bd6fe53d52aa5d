// umbrage 0.1.0: all functions in HLSL, to include.
// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the umbrage authors. License text: LICENSE in the umbrage repository.
//
// Each function is guarded, and costs nothing where it is not called. Coordinates are in texels, not UV. Visibility
//   is 1.0 when lit.
// Maps: `Texture2D<float4> map`, read unfiltered: a depth in .x, 0.0 near and 1.0 far, or what the function's comment
//   names.
// Names with _shadow: `Texture2D<float> map, SamplerComparisonState map_sampler`, a depth texture. Its sampler passes
//   receiver <= depth, clamps to the edge, and filters linearly for names with _hardware, else nearest.
// Other maps: bind() of the library or of its npm package prints a function for an array, an atlas, a cube, packed or
//   reversed depths, under a name of its own.
//
// Render target of rg9: RG8 UNORM, not sRGB, no blending, one sample. Clear to (255, 128) / 255, with reversed depth
//   to (0, 0) / 255. Write umbrage_to_unorm of umbrage_encode_rg9.
// Render target of rg10: RG8 UNORM, not sRGB, no blending, one sample. Clear to (255, 192) / 255, with reversed depth
//   to (0, 0) / 255. Write umbrage_to_unorm of umbrage_encode_rg10.
// Render target of rg11: RG8 UNORM, not sRGB, no blending, one sample. Clear to (255, 224) / 255, with reversed depth
//   to (0, 0) / 255. Write umbrage_to_unorm of umbrage_encode_rg11.
// Render target of rg12: RG8 UNORM, not sRGB, no blending, one sample. Clear to (255, 240) / 255, with reversed depth
//   to (0, 0) / 255. Write umbrage_to_unorm of umbrage_encode_rg12.
// Render target of rg13: RG8 UNORM, not sRGB, no blending, one sample. Clear to (255, 248) / 255, with reversed depth
//   to (0, 0) / 255. Write umbrage_to_unorm of umbrage_encode_rg13.
// Render target of rg14: RG8 UNORM, not sRGB, no blending, one sample. Clear to (255, 252) / 255, with reversed depth
//   to (0, 0) / 255. Write umbrage_to_unorm of umbrage_encode_rg14.
// Render target of rg15: RG8 UNORM, not sRGB, no blending, one sample. Clear to (255, 254) / 255, with reversed depth
//   to (0, 0) / 255. Write umbrage_to_unorm of umbrage_encode_rg15.
// Render target of rg16: RG8 UNORM, not sRGB, no blending, one sample. Clear to (255, 255) / 255, with reversed depth
//   to (0, 0) / 255. Write umbrage_to_unorm of umbrage_encode_rg16.
// Render target of rgb24: RGB8 UNORM, not sRGB, no blending, one sample. Clear to (255, 255, 255) / 255, with
//   reversed depth to (0, 0, 0) / 255. Write umbrage_to_unorm of umbrage_encode_rgb24.
// Render target of rgb10: RGB10_A2 UNORM, not sRGB, no blending, one sample. Clear to (1023, 1023, 960) / 1023, with
//   reversed depth to (0, 0, 0) / 1023. Write umbrage_to_unorm10 of umbrage_encode_rgb10.
// Render target of r16: R16 UNORM, not sRGB, no blending, one sample. Clear to (65535) / 65535, with reversed depth
//   to (0) / 65535. Write umbrage_to_unorm16 of umbrage_encode_r16.
// Render target of float_bits: RGBA8 UNORM, not sRGB, no blending, one sample. Clear to (0, 0, 128, 63) / 255, with
//   reversed depth to (0, 0, 0, 0) / 255. Write umbrage_to_unorm of umbrage_encode_float_bits.
// Render target of threejs_rgba: RGBA8 UNORM, not sRGB, no blending, one sample. Clear to (255, 255, 255, 255) / 255,
//   with reversed depth to (0, 0, 0, 0) / 255. Write umbrage_write_threejs_rgba.
// Render target of threejs_rgb: RGB8 UNORM, not sRGB, no blending, one sample. Clear to (255, 255, 255) / 255, with
//   reversed depth to (0, 0, 0) / 255. Write umbrage_write_threejs_rgb.
// Render target of threejs_rg: RG8 UNORM, not sRGB, no blending, one sample. Clear to (255, 255) / 255, with reversed
//   depth to (0, 0) / 255. Write umbrage_write_threejs_rg.
// Render target of threejs_legacy: RGBA8 UNORM, not sRGB, no blending, one sample. Clear to (255, 255, 255, 255) /
//   255, with reversed depth to (0, 0, 0, 0) / 255. Write umbrage_write_threejs_legacy.
// Render target of threejs_legacy_repaired: RGBA8 UNORM, not sRGB, no blending, one sample. Clear to (255, 255, 255,
//   255) / 255, with reversed depth to (0, 0, 0, 0) / 255. Write umbrage_to_unorm of
//   umbrage_encode_threejs_legacy_repaired.
// Render target of base255: RGBA8 UNORM, not sRGB, no blending, one sample. Clear to (255, 0, 0, 0) / 255, with
//   reversed depth to (0, 0, 0, 0) / 255. Write umbrage_write_base255.
// Render target of base255_repaired: RGBA8 UNORM, not sRGB, no blending, one sample. Clear to (255, 0, 0, 0) / 255,
//   with reversed depth to (0, 0, 0, 0) / 255. Write umbrage_to_unorm of umbrage_encode_base255_repaired.
// Render target of vsm: RG32F, not sRGB, no blending, one sample. Clear to umbrage_encode_vsm of the far plane's
//   depth.
// Render target of esm: R32F, not sRGB, no blending, one sample. Clear to umbrage_encode_esm of the far plane's
//   depth.
// Render target of evsm2: RG32F, not sRGB, no blending, one sample. Clear to umbrage_encode_evsm2 of the far plane's
//   depth.
// Render target of evsm4: RGBA32F, not sRGB, no blending, one sample. Clear to umbrage_encode_evsm4 of the far
//   plane's depth.
// Render target of msm: RGBA32F, not sRGB, no blending, one sample. Clear to umbrage_encode_msm of the far plane's
//   depth.
// Render target of msm_hausdorff: RGBA32F, not sRGB, no blending, one sample. Clear to umbrage_encode_msm of the far
//   plane's depth.
// Render target of msm_unorm16: RGBA16 UNORM, not sRGB, no blending, one sample. Clear to
//   umbrage_to_optimized_moments of umbrage_encode_msm of the far plane's depth.
//
// Functions are exact, tier A, but for these:
// shadow_coordinate, tier B: within 6 x 2^-23 x S of the exact result.
// tap_coordinate, tier B: within 2 x 2^-23 x S of the exact result.
// project_coordinate, tier C: within 3 x 2^-23 x S of the exact result.
// cascade_coordinate, tier B: within 2 x 2^-23 x S of the exact result.
// inside_cascade, tier B: within 2 x 2^-23 x S of the exact result.
// cascade_by_projection, tier B: within 4 x 2^-23 x S of the exact result.
// cascade_by_projection_8, tier B: within 5 x 2^-23 x S of the exact result.
// cascade_fade, tier B: within 3 x 2^-23 x S of the exact result.
// cascade_border_fade, tier B: within 8 x 2^-23 x S of the exact result.
// blend_cascades, tier B: within 3 x 2^-23 x S of the exact result.
// cube_coordinate, tier C: within 5 x 2^-23 x S of the exact result.
// cube_direction, tier B: within 2 x 2^-23 x S of the exact result.
// dual_paraboloid_coordinate, tier C: within 32 x 2^-23 x S of the exact result.
// dual_paraboloid_position, tier C: within 18 x 2^-23 x S of the exact result.
// tetrahedron_face, tier B: within 1 x 2^-23 x S of the exact result.
// tetrahedron_plane, tier B: within 1 x 2^-23 x S of the exact result.
// tetrahedron_view_z, tier B: within 3 x 2^-23 x S of the exact result.
// tetrahedron_coordinate, tier C: within 6 x 2^-23 x S of the exact result.
// tetrahedron_texel, tier B: within 9 x 2^-23 x S of the exact result.
// pancake, tier B: within 1 x 2^-23 x S of the exact result.
// linear_depth, tier B: within 1 x 2^-23 x S of the exact result.
// project_depth, tier C: within 3 x 2^-23 x S of the exact result.
// distance_depth, tier C: within 9 x 2^-23 x S of the exact result.
// reverse_depth, tier B: within 1 x 2^-23 x S of the exact result.
// depth_from_ndc, tier B: within 2 x 2^-23 x S of the exact result.
// view_z_from_depth, tier C: within 8 x 2^-23 x S of the exact result.
// depth_from_view_z, tier C: within 10 x 2^-23 x S of the exact result.
// view_z_from_reversed_depth, tier C: within 11 x 2^-23 x S of the exact result.
// reversed_depth_from_view_z, tier C: within 13 x 2^-23 x S of the exact result.
// view_z_from_orthographic_depth, tier B: within 3 x 2^-23 x S of the exact result.
// orthographic_depth_from_view_z, tier C: within 5 x 2^-23 x S of the exact result.
// write_threejs_rgba, tier B: within 5 x 2^-23 x S of the exact result.
// write_threejs_rgb, tier B: within 3 x 2^-23 x S of the exact result.
// write_threejs_rg, tier B: within 1 x 2^-23 x S of the exact result.
// write_threejs_legacy, tier B: within 7 x 2^-23 x S of the exact result.
// write_base255, tier B: within 6 x 2^-23 x S of the exact result.
// encode_base255_repaired, tier B: within 7 x 2^-23 x S of the exact result.
// decode_threejs_rgba, tier B: within 7 x 2^-23 x S of the exact result.
// decode_threejs_rgb, tier B: within 5 x 2^-23 x S of the exact result.
// decode_threejs_rg, tier B: within 3 x 2^-23 x S of the exact result.
// decode_threejs_legacy, tier B: within 7 x 2^-23 x S of the exact result.
// decode_base255, tier B: within 6 x 2^-23 x S of the exact result.
// level_rg9, tier B: within 4 x 2^-23 x S of the exact result.
// level_rg10, tier B: within 4 x 2^-23 x S of the exact result.
// level_rg11, tier B: within 4 x 2^-23 x S of the exact result.
// level_rg12, tier B: within 4 x 2^-23 x S of the exact result.
// level_rg13, tier B: within 4 x 2^-23 x S of the exact result.
// level_rg14, tier B: within 4 x 2^-23 x S of the exact result.
// level_rg15, tier B: within 4 x 2^-23 x S of the exact result.
// level_rg16, tier B: within 4 x 2^-23 x S of the exact result.
// receiver_rg9, tier B: within 2 x 2^-23 x S of the exact result.
// receiver_rg10, tier B: within 2 x 2^-23 x S of the exact result.
// receiver_rg11, tier B: within 2 x 2^-23 x S of the exact result.
// receiver_rg12, tier B: within 2 x 2^-23 x S of the exact result.
// receiver_rg13, tier B: within 2 x 2^-23 x S of the exact result.
// receiver_rg14, tier B: within 2 x 2^-23 x S of the exact result.
// receiver_rg15, tier B: within 2 x 2^-23 x S of the exact result.
// receiver_rg16, tier B: within 2 x 2^-23 x S of the exact result.
// decode_ps14, tier B: within 4 x 2^-23 x S of the exact result.
// receiver_ps14, tier B: within 1 x 2^-23 x S of the exact result.
// depth_at, tier C: within 4 x 2^-23 x S of the exact result.
// compare_dx_sdk, tier B: within 1 x 2^-23 x S of the exact result.
// compare_exercise, tier B: within 1 x 2^-23 x S of the exact result.
// sheared_rotation, tier B: within 2 x 2^-23 x S of the exact result.
// pcf_2x2_dx_sdk, tier B: within 20 x 2^-23 x S of the exact result.
// box, tier B: within 290 x 2^-23 x S of the exact result.
// castano5, tier B: within 80 x 2^-23 x S of the exact result.
// castano7, tier B: within 138 x 2^-23 x S of the exact result.
// pcf_2x2_cube, tier C: within 33 x 2^-23 x S of the exact result.
// four_tap_hardware, tier C: within 39 x 2^-23 x S of the exact result.
// lit_filtered, tier C: within 1/128 of C++.
// covered, tier C: within 6 x 2^-23 x S of the exact result.
// lit_between, tier C: within 1/128 of C++.
// lit_at, tier C: within 1/128 of C++.
// pcf_2x2_hardware, tier C: within 1/128 of C++.
// window_hardware3, tier C: within 1/128 of C++.
// window_hardware5, tier C: within 1/128 of C++.
// window_hardware7, tier C: within 1/128 of C++.
// ellipse_hardware8, tier C: within 1/128 of C++.
// ellipse_hardware16, tier C: within 1/128 of C++.
// ellipse_hardware32, tier C: within 1/128 of C++.
// disc_hardware8, tier C: within 1/128 of C++.
// disc_hardware16, tier C: within 1/128 of C++.
// disc_hardware32, tier C: within 1/128 of C++.
// blocker_at, tier C: within 4 x 2^-23 x S of the exact result.
// pcss_radius, tier C: within 1/1024 of C++.
// blockers_hardware8, tier C: within 24 x 2^-23 x S of the exact result.
// blockers_hardware16, tier C: within 24 x 2^-23 x S of the exact result.
// blockers_hardware32, tier C: within 24 x 2^-23 x S of the exact result.
// summed_variance, tier C: within 1/65536 of C++.
// box_mean, tier C: within 19 x 2^-23 x S of the exact result.
// from_optimized_moments, tier B: within 5 x 2^-23 x S of the exact result.
// bias_moments, tier B: within 3 x 2^-23 x S of the exact result.
// to_forward_depth, tier B: within 1 x 2^-23 x S of the exact result.
// moment_atoms, tier C: within 1/64 of C++ as written. Reordered: no bound, but a visibility is in [0, 1].
// decode_msm, tier C: within 1/64 of C++ as written. Reordered: no bound, but a visibility is in [0, 1].
// summed_moments, tier C: within 1/64 of C++ as written. Reordered: no bound, but a visibility is in [0, 1].
// exp2_polynomial, tier B: within 16 x 2^-23 x S of the exact result.
// chebyshev, tier C: within 11 x 2^-23 x S of the exact result.
// reduce_light_bleeding, tier C: within 5 x 2^-23 x S of the exact result.
// encode_vsm, tier B: within 3 x 2^-23 x S of the exact result.
// decode_vsm, tier C: within 13 x 2^-23 x S of the exact result.
// encode_deviation, tier C: within 7 x 2^-23 x S of the exact result.
// decode_deviation, tier B: within 5 x 2^-23 x S of the exact result.
// decode_deviation_rgba8, tier B: within 21 x 2^-23 x S of the exact result.
// exponential_warp, tier B: within 31 x 2^-23 x S of the exact result.
// encode_esm, tier B: within 36 x 2^-23 x S of the exact result.
// decode_esm, tier B: within 37 x 2^-23 x S of the exact result.
// encode_evsm2, tier B: within 73 x 2^-23 x S of the exact result.
// encode_evsm4, tier B: within 73 x 2^-23 x S of the exact result.
// decode_evsm2, tier C: within 229 x 2^-23 x S of the exact result.
// decode_evsm4, tier C: within 229 x 2^-23 x S of the exact result.
// encode_msm, tier B: within 15 x 2^-23 x S of the exact result.
// to_optimized_moments, tier B: within 4 x 2^-23 x S of the exact result.
// hausdorff_share, tier C: within 1/1048576 of C++ as written. Reordered: no bound, but a visibility is in [0, 1].
// decode_msm_hausdorff, tier C: within 1/64 of C++ as written. Reordered: no bound, but a visibility is in [0, 1].
// fetch_bilinear, tier B: within 19 x 2^-23 x S of the exact result.
// vsm, tier C: within 165 x 2^-23 x S of the exact result.
// esm, tier B: within 56 x 2^-23 x S of the exact result.
// evsm2, tier C: within 267 x 2^-23 x S of the exact result.
// evsm4, tier C: within 267 x 2^-23 x S of the exact result.
// msm, tier C: within 1/64 of C++ as written. Reordered: no bound, but a visibility is in [0, 1].
// msm_unorm16, tier C: within 1/64 of C++ as written. Reordered: no bound, but a visibility is in [0, 1].
// msm_hausdorff, tier C: within 1/64 of C++ as written. Reordered: no bound, but a visibility is in [0, 1].
// chebyshev_hardware, tier C: within 1/524288 of C++.
// decode_vsm_hardware, tier C: within 1/1024 of C++.
// decode_evsm2_hardware, tier C: within 1/64 of C++.
// decode_evsm4_hardware, tier C: within 1/64 of C++.
// blur_row3, tier B: within 7 x 2^-23 x S of the exact result.
// blur_row5, tier B: within 12 x 2^-23 x S of the exact result.
// blur_row7, tier B: within 17 x 2^-23 x S of the exact result.
// halve_texels, tier B: within 8 x 2^-23 x S of the exact result.
// texels_to_world, tier B: within 2 x 2^-23 x S of the exact result.
// world_to_depth, tier C: within 5 x 2^-23 x S of the exact result.
// biased, tier B: within 1 x 2^-23 x S of the exact result.
// plane_in_map, tier B: within 12 x 2^-23 x S of the exact result.
// plane_slope, tier C: within 27 x 2^-23 x S of the exact result.
// receiver_slope, tier C: within 27 x 2^-23 x S of the exact result.
// cascade_slope, tier C: within 6 x 2^-23 x S of the exact result.
// slope_bias, tier B: within 2 x 2^-23 x S of the exact result.
// dual_paraboloid_slope, tier C: within 41 x 2^-23 x S of the exact result.
// normal_offset, tier C: within 91 x 2^-23 x S of the exact result.
// kernel_bias, tier C: within 30 x 2^-23 x S of the exact result.
// receiver_plane_slope, tier C: within 31 x 2^-23 x S of the exact result.
// plane_reference, tier B: within 8 x 2^-23 x S of the exact result.
// bordered_plane_reference, tier B: within 8 x 2^-23 x S of the exact result.
// corner_reference, tier C: within 5 x 2^-23 x S of the exact result.
// apply_receiver_plane, tier B: within 8 x 2^-23 x S of the exact result.
// acne_free_bias, tier B: within 4 x 2^-23 x S of the exact result.
// acne_free_disc_bias, tier C: within 13 x 2^-23 x S of the exact result.
// peter_panning_distance, tier B: within 4 x 2^-23 x S of the exact result.
// spot_cone, tier B: within 11 x 2^-23 x S of the exact result.
// diffuse_ambient, tier B: within 5 x 2^-23 x S of the exact result.
// false_color, tier B: within 3 x 2^-23 x S of the exact result.
// anchored_vertex, tier B: within 20 x 2^-23 x S of the exact result.
// anchored_place, tier C: within 121 x 2^-23 x S of the exact result.
// single_map_places, tier C: within 121 x 2^-23 x S of the exact result.
// parallel_map_places, tier C: within 121 x 2^-23 x S of the exact result.
// cascade_edge, tier C: within 13 x 2^-23 x S of the exact result.
// cascade_edges, tier C: within 13 x 2^-23 x S of the exact result.
// next_cascade_weight, tier B: within 3 x 2^-23 x S of the exact result.
// cascaded_maps_choice, tier C: within 38 x 2^-23 x S of the exact result.
// cascaded_maps_choice_8, tier C: within 38 x 2^-23 x S of the exact result.
// cascade_place, tier C: within 14 x 2^-23 x S of the exact result.
// cascaded_maps_place, tier C: within 38 x 2^-23 x S of the exact result.
// cascaded_maps_place_8, tier C: within 38 x 2^-23 x S of the exact result.
// cube_maps_places, tier C: within 121 x 2^-23 x S of the exact result.
// tetrahedron_map_places, tier C: within 121 x 2^-23 x S of the exact result.
// paraboloid_maps_places, tier C: within 57 x 2^-23 x S of the exact result.
// paraboloid_vertex, tier C: within 51 x 2^-23 x S of the exact result.
// warped_maps_choice, tier C: within 12 x 2^-23 x S of the exact result.
// warped_maps_place, tier C: within 121 x 2^-23 x S of the exact result.
// adaptive_maps_places, tier C: within 68 x 2^-23 x S of the exact result.
// warp_shape, tier C: within 29 x 2^-23 x S of the exact result.
// shaped_softness, tier C: within 9 x 2^-23 x S of the exact result.
// box_shadow, tier B: within 290 x 2^-23 x S of the exact result.
// castano5_shadow, tier B: within 80 x 2^-23 x S of the exact result.
// castano7_shadow, tier B: within 138 x 2^-23 x S of the exact result.
// pcf_2x2_hardware_shadow, tier C: within 1/128 of C++.
// window_hardware3_shadow, tier C: within 1/128 of C++.
// window_hardware5_shadow, tier C: within 1/128 of C++.
// window_hardware7_shadow, tier C: within 1/128 of C++.
// disc_hardware16_shadow, tier C: within 1/128 of C++.
// blockers_hardware16_depths, tier C: within 24 x 2^-23 x S of the exact result.
// ellipse_hardware16_shadow, tier C: within 1/128 of C++.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.

#ifndef UMBRAGE_HAS_SHADOW_COORDINATE
#define UMBRAGE_HAS_SHADOW_COORDINATE
// umbrage_shadow_coordinate: texture matrix times world position: (x w, y w, depth w, w), x and y in texels
float4 umbrage_shadow_coordinate(float4x4 m, float3 world) {
    precise float4 c = transpose(m)[3] + transpose(m)[0] * world.x + transpose(m)[1] * world.y + transpose(m)[2] *
        world.z;
    return c;
}
#endif

#ifndef UMBRAGE_HAS_TAP_COORDINATE
#define UMBRAGE_HAS_TAP_COORDINATE
// umbrage_tap_coordinate: coordinate before the division by w, moved by offset texels
float4 umbrage_tap_coordinate(float4 coordinate, float2 offset) {
    precise float2 moved = float2(coordinate.x, coordinate.y) + offset * coordinate.w;
    return float4(moved.x, moved.y, coordinate.z, coordinate.w);
}
#endif

#ifndef UMBRAGE_HAS_PROJECT_COORDINATE
#define UMBRAGE_HAS_PROJECT_COORDINATE
// umbrage_project_coordinate: x and y in texels, and depth; w <= 0.0 gives a coordinate that every filter takes as lit
float3 umbrage_project_coordinate(float4 coordinate) {
    float3 p = float3(coordinate.x / coordinate.w, coordinate.y / coordinate.w, coordinate.z / coordinate.w);
    return coordinate.w > 0.0 ? p : float3(65536.0, 65536.0, 0.0);
}
#endif

#ifndef UMBRAGE_HAS_CASCADE_BY_DEPTH
#define UMBRAGE_HAS_CASCADE_BY_DEPTH
// umbrage_cascade_by_depth: cascade that contains a distance along the camera's axis, 0.0 to 3.0
//   ends  ends of the first three cascades, increasing
float umbrage_cascade_by_depth(float depth, float3 ends) {
    int reached = int(depth >= ends.x) + int(depth >= ends.y) + int(depth >= ends.z);
    return float(reached);
}
#endif

#ifndef UMBRAGE_HAS_CASCADE_COLUMN
#define UMBRAGE_HAS_CASCADE_COLUMN
// umbrage_cascade_column: column of a matrix by its index, 0.0 to 3.0, for languages without dynamic indexing
float4 umbrage_cascade_column(float4x4 columns, float number) {
    float4 low = number < 0.5 ? transpose(columns)[0] : transpose(columns)[1];
    float4 high = number < 2.5 ? transpose(columns)[2] : transpose(columns)[3];
    return number < 1.5 ? low : high;
}
#endif

#ifndef UMBRAGE_HAS_CASCADE_COLUMN_8
#define UMBRAGE_HAS_CASCADE_COLUMN_8
// umbrage_cascade_column_8: column of two matrices by its index, 0.0 to 7.0
float4 umbrage_cascade_column_8(float4x4 nearer, float4x4 farther, float number) {
    float4 low = umbrage_cascade_column(nearer, number);
    float4 high = umbrage_cascade_column(farther, number - 4.0);
    return number < 3.5 ? low : high;
}
#endif

#ifndef UMBRAGE_HAS_CASCADE_COORDINATE
#define UMBRAGE_HAS_CASCADE_COORDINATE
// umbrage_cascade_coordinate: position in a cascade's map, texels and depth, of a point rotated into the light's axes
float3 umbrage_cascade_coordinate(float3 light, float4 scale, float4 offset) {
    float3 start = float3(offset.x, offset.y, offset.z);
    precise float3 at = light * float3(scale.x, scale.y, scale.z) + start;
    return at;
}
#endif

#ifndef UMBRAGE_HAS_INSIDE_CASCADE
#define UMBRAGE_HAS_INSIDE_CASCADE
// umbrage_inside_cascade: true if a filter of radius reach at a coordinate stays inside a map of size texels
precise bool umbrage_inside_cascade(float3 coordinate, float2 size, float reach) {
    precise float2 end = size - reach;
    // y is doubled because Mesa turns two comparisons with one limit into min(x, y) >= reach, which loses a NaN
    bool in_x = coordinate.x >= reach && coordinate.x <= end.x;
    bool in_y = coordinate.y * 2.0 >= reach * 2.0 && coordinate.y * 2.0 <= end.y * 2.0;
    return in_x && in_y && coordinate.z >= 0.0 && coordinate.z <= 1.0;
}
#endif

#ifndef UMBRAGE_HAS_CASCADE_BY_PROJECTION
#define UMBRAGE_HAS_CASCADE_BY_PROJECTION
// umbrage_cascade_by_projection: (texels, texels, depth, index) in the first of four cascades that contains a point
//   and its filter; if there is none, index 4.0 and a coordinate that every filter takes as lit
//   light            the point, rotated into the light's axes
//   scales, offsets  scales and offsets of the cascades
//   size             size of each map, in texels
//   reach            filter radius, in texels
float4 umbrage_cascade_by_projection(float3 light, float4x4 scales, float4x4 offsets, float2 size, float reach) {
    float3 a = umbrage_cascade_coordinate(light, transpose(scales)[0], transpose(offsets)[0]);
    float3 b = umbrage_cascade_coordinate(light, transpose(scales)[1], transpose(offsets)[1]);
    float3 c = umbrage_cascade_coordinate(light, transpose(scales)[2], transpose(offsets)[2]);
    float3 d = umbrage_cascade_coordinate(light, transpose(scales)[3], transpose(offsets)[3]);
    float4 found = float4(65536.0, 65536.0, 0.0, 4.0);
    found = umbrage_inside_cascade(d, size, reach) ? float4(d, 3.0) : found;
    found = umbrage_inside_cascade(c, size, reach) ? float4(c, 2.0) : found;
    found = umbrage_inside_cascade(b, size, reach) ? float4(b, 1.0) : found;
    return umbrage_inside_cascade(a, size, reach) ? float4(a, 0.0) : found;
}
#endif

#ifndef UMBRAGE_HAS_CASCADE_BY_PROJECTION_8
#define UMBRAGE_HAS_CASCADE_BY_PROJECTION_8
// umbrage_cascade_by_projection_8: umbrage_cascade_by_projection for eight cascades, four and four; index 8.0 for none
float4 umbrage_cascade_by_projection_8(float3 light, float4x4 scales, float4x4 offsets, float4x4 farther_scales,
                                       float4x4 farther_offsets, float2 size, float reach) {
    float4 nearer = umbrage_cascade_by_projection(light, scales, offsets, size, reach);
    float4 farther = umbrage_cascade_by_projection(light, farther_scales, farther_offsets, size, reach);
    return nearer.w < 3.5 ? nearer : float4(farther.x, farther.y, farther.z, farther.w + 4.0);
}
#endif

#ifndef UMBRAGE_HAS_CASCADE_TILE
#define UMBRAGE_HAS_CASCADE_TILE
// umbrage_cascade_tile: first texel of a cascade in an atlas with two tiles of size texels per row
float2 umbrage_cascade_tile(float number, float2 size) {
    float row = floor(number * 0.5);
    return float2(number - row * 2.0, row) * size;
}
#endif

#ifndef UMBRAGE_HAS_CASCADE_WEIGHT
#define UMBRAGE_HAS_CASCADE_WEIGHT
// umbrage_cascade_weight: v rounded down to steps of 1/256, from 0.0 to 1.0; NaN gives 0.0
float umbrage_cascade_weight(float v) {
    return v > 0.0 ? min(floor(v * 256.0), 256.0) * (1.0 / 256.0) : 0.0;
}
#endif

#ifndef UMBRAGE_HAS_CASCADE_FADE
#define UMBRAGE_HAS_CASCADE_FADE
// umbrage_cascade_fade: weight of the next cascade at a distance along the camera's axis: depth * scale + offset
float umbrage_cascade_fade(float depth, float scale, float offset) {
    precise float v = depth * scale + offset;
    return umbrage_cascade_weight(v);
}
#endif

#ifndef UMBRAGE_HAS_CASCADE_BORDER_FADE
#define UMBRAGE_HAS_CASCADE_BORDER_FADE
// umbrage_cascade_border_fade: weight of the next cascade, 1.0 up to reach texels from the border of a map
//   coordinate  position in the map, in texels
//   size        size of the map, in texels
//   per_texel   weight per texel: 1.0 / width of the band along the border
float umbrage_cascade_border_fade(float2 coordinate, float2 size, float reach, float per_texel) {
    float2 half_size = size * 0.5;
    precise float2 beyond = abs(coordinate - half_size) - (half_size - reach);
    precise float2 v = beyond * per_texel + 1.0;
    float x = umbrage_cascade_weight(v.x);
    float y = umbrage_cascade_weight(v.y);
    return x > y ? x : y;
}
#endif

#ifndef UMBRAGE_HAS_BLEND_CASCADES
#define UMBRAGE_HAS_BLEND_CASCADES
// umbrage_blend_cascades: blend of the visibilities of a cascade and of the next one, by the next one's weight
float umbrage_blend_cascades(float nearer, float farther, float weight) {
    precise float sum = nearer + (farther - nearer) * weight;
    return weight < 1.0 ? sum : farther;
}
#endif

#ifndef UMBRAGE_HAS_INSIDE_TEXEL_SPACE
#define UMBRAGE_HAS_INSIDE_TEXEL_SPACE
// umbrage_inside_texel_space: true for coordinates in texels that a filter can take; others are lit, also NaN
precise bool umbrage_inside_texel_space(float2 coord) {
    // the float below 32768: of one limit for both Mesa makes max(x, y) < limit, which loses a NaN
    return abs(coord.x) < 32768.0 && abs(coord.y) <= 32767.998046875;
}
#endif

#ifndef UMBRAGE_HAS_DITHER_THRESHOLD
#define UMBRAGE_HAS_DITHER_THRESHOLD
// umbrage_dither_threshold: dither threshold of a position in pixels: 1/32 to 31/32, each once in 4x4 pixels
float umbrage_dither_threshold(float2 pixel) {
    float2 whole = umbrage_inside_texel_space(pixel) ? floor(pixel) : float2(0.0, 0.0);
    float2 high = floor(whole * 0.5);
    float2 above = floor(whole * 0.25);
    float2 b0 = whole - high * 2.0;
    float2 b1 = high - above * 2.0;
    float m = abs(b0.x - b0.y) * 8.0 + b0.y * 4.0 + abs(b1.x - b1.y) * 2.0 + b1.y;
    return (m + 0.5) * (1.0 / 16.0);
}
#endif

#ifndef UMBRAGE_HAS_DITHERED_CASCADE
#define UMBRAGE_HAS_DITHERED_CASCADE
// umbrage_dithered_cascade: index of a cascade, or of the next one if its weight is above the pixel's threshold
float umbrage_dithered_cascade(float number, float weight, float threshold) {
    return number + (weight > threshold ? 1.0 : 0.0);
}
#endif

#ifndef UMBRAGE_HAS_CUBE_FACE
#define UMBRAGE_HAS_CUBE_FACE
// umbrage_cube_face: face that a direction meets, 0.0 to 5.0: +x, -x, +y, -y, +z, -z
float umbrage_cube_face(float3 direction) {
    float3 m = abs(direction);
    float x = direction.x < 0.0 ? 1.0 : 0.0;
    float y = direction.y < 0.0 ? 3.0 : 2.0;
    float z = direction.z < 0.0 ? 5.0 : 4.0;
    // not m.x >= m.y && m.x >= m.z: Mesa turns it into one comparison with max(m.y, m.z), which loses a NaN
    return m.x >= m.y ? (m.x >= m.z ? x : z) : (m.y >= m.z ? y : z);
}
#endif

#ifndef UMBRAGE_HAS_CUBE_VIEW_Z
#define UMBRAGE_HAS_CUBE_VIEW_Z
// umbrage_cube_view_z: magnitude of the largest component, the input of per-face depths
float umbrage_cube_view_z(float3 direction) {
    float face = umbrage_cube_face(direction);
    float side = face < 1.5 ? direction.x : direction.y;
    return abs(face > 3.5 ? direction.z : side);
}
#endif

#ifndef UMBRAGE_HAS_CUBE_PLANE
#define UMBRAGE_HAS_CUBE_PLANE
// umbrage_cube_plane: (sc, tc, face) of a direction: its components across the axis of its face
float3 umbrage_cube_plane(float3 direction) {
    float face = umbrage_cube_face(direction);
    float3 x = float3(face < 0.5 ? -direction.z : direction.z, -direction.y, face);
    float3 y = float3(direction.x, face < 2.5 ? direction.z : -direction.z, face);
    float3 z = float3(face < 4.5 ? direction.x : -direction.x, -direction.y, face);
    return face < 1.5 ? x : (face < 3.5 ? y : z);
}
#endif

#ifndef UMBRAGE_HAS_CUBE_POINT
#define UMBRAGE_HAS_CUBE_POINT
// umbrage_cube_point: point from (sc, tc, distance along the axis) in a face, 0.0 to 5.0
float3 umbrage_cube_point(float face, float3 p) {
    float3 x = face < 0.5 ? float3(p.z, -p.y, -p.x) : float3(-p.z, -p.y, p.x);
    float3 y = face < 2.5 ? float3(p.x, p.z, p.y) : float3(p.x, -p.z, -p.y);
    float3 z = face < 4.5 ? float3(p.x, -p.y, p.z) : float3(-p.x, -p.y, -p.z);
    return face < 1.5 ? x : (face < 3.5 ? y : z);
}
#endif

#ifndef UMBRAGE_HAS_CUBE_FACE_POINT
#define UMBRAGE_HAS_CUBE_FACE_POINT
// umbrage_cube_face_point: (sc, tc, distance along the axis) in a face, 0.0 to 5.0, of a point from the cube's center
float3 umbrage_cube_face_point(float face, float3 p) {
    float3 x = face < 0.5 ? float3(-p.z, -p.y, p.x) : float3(p.z, -p.y, -p.x);
    float3 y = face < 2.5 ? float3(p.x, p.z, p.y) : float3(p.x, -p.z, -p.y);
    float3 z = face < 4.5 ? float3(p.x, -p.y, p.z) : float3(-p.x, -p.y, -p.z);
    return face < 1.5 ? x : (face < 3.5 ? y : z);
}
#endif

#ifndef UMBRAGE_HAS_CUBE_COORDINATE
#define UMBRAGE_HAS_CUBE_COORDINATE
// umbrage_cube_coordinate: (s, t, face) of a direction; s and t go from 0.0 to 1.0 over the face
float3 umbrage_cube_coordinate(float3 direction) {
    float3 p = umbrage_cube_plane(direction);
    float m = umbrage_cube_view_z(direction);
    return float3((p.x + m) / (m + m), (p.y + m) / (m + m), p.z);
}
#endif

#ifndef UMBRAGE_HAS_CUBE_DIRECTION
#define UMBRAGE_HAS_CUBE_DIRECTION
// umbrage_cube_direction: direction from a cube's center to a point of a face, 0.0 to 5.0; st is in [0.0, 1.0]
float3 umbrage_cube_direction(float face, float2 st) {
    precise float2 uv = st * 2.0 - 1.0;  // the product is exact: fused or not, it rounds once
    return umbrage_cube_point(face, float3(uv, 1.0));
}
#endif

#ifndef UMBRAGE_HAS_CUBE_NEIGHBOR
#define UMBRAGE_HAS_CUBE_NEIGHBOR
// umbrage_cube_neighbor: (s, t, face) of a texel that may lie beyond an edge of its face; face -1.0 beyond a corner
//   texel  (s, t, face), integers
//   size   size of a face, in texels
float3 umbrage_cube_neighbor(float3 texel, float size) {
    float2 uv = float2(texel.x, texel.y) * 2.0 + (1.0 - size);
    bool beyond_u = abs(uv.x) > size;
    bool beyond_v = abs(uv.y) > size;
    float m = beyond_u || beyond_v ? size - 1.0 : size;
    float3 p = umbrage_cube_plane(umbrage_cube_point(texel.z, float3(uv, m)));
    float2 inside = (float2(p.x, p.y) + (size - 1.0)) * 0.5;
    return beyond_u && beyond_v ? float3(0.0, 0.0, -1.0) : float3(inside, p.z);
}
#endif

#ifndef UMBRAGE_HAS_CUBE_TILE
#define UMBRAGE_HAS_CUBE_TILE
// umbrage_cube_tile: first texel of a face, 0.0 to 5.0, in an atlas of 3 x 2 tiles of size texels
float2 umbrage_cube_tile(float face, float size) {
    float row = face < 2.5 ? 0.0 : 1.0;
    return float2((face - row * 3.0) * size, row * size);
}
#endif

#ifndef UMBRAGE_HAS_CUBE_ATLAS_TEXEL
#define UMBRAGE_HAS_CUBE_ATLAS_TEXEL
// umbrage_cube_atlas_texel: (s, t, face) of a texel in an atlas of 3 x 2 tiles of size texels; integers
float3 umbrage_cube_atlas_texel(float2 texel, float size) {
    float column = texel.x < size ? 0.0 : (texel.x < size * 2.0 ? 1.0 : 2.0);
    float row = texel.y < size ? 0.0 : 1.0;
    return float3(texel - float2(column, row) * size, column + row * 3.0);
}
#endif

#ifndef UMBRAGE_HAS_CUBE_ATLAS_DIRECTION
#define UMBRAGE_HAS_CUBE_ATLAS_DIRECTION
// umbrage_cube_atlas_direction: direction from a cube's center to an atlas texel, for 3 x 2 tiles of size texels
float3 umbrage_cube_atlas_direction(float2 texel, float size) {
    float3 part = umbrage_cube_atlas_texel(texel, size);
    float2 uv = float2(part.x, part.y) * 2.0 + (1.0 - size);
    return umbrage_cube_point(part.z, float3(uv, size));
}
#endif

#ifndef UMBRAGE_HAS_DUAL_PARABOLOID_COORDINATE
#define UMBRAGE_HAS_DUAL_PARABOLOID_COORDINATE
// umbrage_dual_paraboloid_coordinate: (s, t, map) of a direction: 0.0 to 1.0 over the map's square, map 0.0 or 1.0
float3 umbrage_dual_paraboloid_coordinate(float3 direction) {
    precise float square = direction.x * direction.x + direction.y * direction.y + direction.z * direction.z;
    bool behind = direction.z < 0.0;
    float m = sqrt(square) + (behind ? -direction.z : direction.z);
    float x = behind ? direction.x : -direction.x;
    return float3((x + m) / (m + m), (direction.y + m) / (m + m), behind ? 1.0 : 0.0);
}
#endif

#ifndef UMBRAGE_HAS_DUAL_PARABOLOID_POSITION
#define UMBRAGE_HAS_DUAL_PARABOLOID_POSITION
// umbrage_dual_paraboloid_position: (x w, y w, distance w, w) of a vertex, for the depth pass' projection
//   direction  from the light to the vertex
//   map        index of the map, 0.0 or 1.0
float4 umbrage_dual_paraboloid_position(float3 direction, float map) {
    bool behind = map > 0.5;
    precise float square = direction.x * direction.x + direction.y * direction.y + direction.z * direction.z;
    float distance_to = sqrt(square);
    float w = distance_to + (behind ? -direction.z : direction.z);
    return float4(behind ? direction.x : -direction.x, direction.y, distance_to * w, w);
}
#endif

#ifndef UMBRAGE_HAS_TETRAHEDRON_FACE
#define UMBRAGE_HAS_TETRAHEDRON_FACE
// umbrage_tetrahedron_face: face that a direction meets, 0.0 to 3.0: down and +z, down and -z, up and +x, up and -x
float umbrage_tetrahedron_face(float3 direction) {
    precise float beside = abs(direction.z) - abs(direction.x);
    precise float up = direction.y * 1.414213562;
    float z = direction.z < 0.0 ? 1.0 : 0.0;
    float x = direction.x < 0.0 ? 3.0 : 2.0;
    return beside >= up ? z : x;
}
#endif

#ifndef UMBRAGE_HAS_TETRAHEDRON_FACE_POINT
#define UMBRAGE_HAS_TETRAHEDRON_FACE_POINT
// umbrage_tetrahedron_face_point: (along the base, up, away) of a direction in the axes of a face, 0.0 to 3.0
float3 umbrage_tetrahedron_face_point(float face, float3 d) {
    float3 z = face < 0.5 ? float3(-d.x, d.y, d.z) : float3(d.x, d.y, -d.z);
    float3 x = face < 2.5 ? float3(-d.z, -d.y, d.x) : float3(d.z, -d.y, -d.x);
    return face < 1.5 ? z : x;
}
#endif

#ifndef UMBRAGE_HAS_TETRAHEDRON_PLANE
#define UMBRAGE_HAS_TETRAHEDRON_PLANE
// umbrage_tetrahedron_plane: (along the base, up, away) of a direction in the axes of the face that it meets
float3 umbrage_tetrahedron_plane(float3 direction) {
    return umbrage_tetrahedron_face_point(umbrage_tetrahedron_face(direction), direction);
}
#endif

#ifndef UMBRAGE_HAS_TETRAHEDRON_VIEW_Z
#define UMBRAGE_HAS_TETRAHEDRON_VIEW_Z
// umbrage_tetrahedron_view_z: distance along the face's normal, the input of per-face depths
float umbrage_tetrahedron_view_z(float3 direction) {
    float3 p = umbrage_tetrahedron_plane(direction);
    precise float z = p.z * 0.816496581 + p.y * -0.577350269;
    return z;
}
#endif

#ifndef UMBRAGE_HAS_TETRAHEDRON_COORDINATE
#define UMBRAGE_HAS_TETRAHEDRON_COORDINATE
// umbrage_tetrahedron_coordinate: (s, t, face) of a direction
//   s  -1.0 to 1.0 along the base
//   t  0.0 at the base to 1.0 at the apex
float3 umbrage_tetrahedron_coordinate(float3 direction) {
    float3 p = umbrage_tetrahedron_plane(direction);
    precise float d = p.z * 2.0 + p.y * -1.414213562;
    return float3(p.x / d, p.z / d, umbrage_tetrahedron_face(direction));
}
#endif

#ifndef UMBRAGE_HAS_TETRAHEDRON_TURNED
#define UMBRAGE_HAS_TETRAHEDRON_TURNED
// umbrage_tetrahedron_turned: vector from face 0's part of the map, rotated to the part of a face, 0.0 to 3.0
float2 umbrage_tetrahedron_turned(float face, float2 v) {
    float2 z = face < 0.5 ? v : float2(-v.x, -v.y);
    float2 x = face < 2.5 ? float2(-v.y, v.x) : float2(v.y, -v.x);
    return face < 1.5 ? z : x;
}
#endif

#ifndef UMBRAGE_HAS_TETRAHEDRON_TEXEL
#define UMBRAGE_HAS_TETRAHEDRON_TEXEL
// umbrage_tetrahedron_texel: position in a square map, in texels, from (s, t, face) on a tetrahedron
//   size    size of the map, in texels
//   border  border along the sides of each triangle, in texels
float2 umbrage_tetrahedron_texel(float3 at, float size, float border) {
    float half_size = size * 0.5;
    float scale = half_size - border * 3.0;
    precise float x = at.x * scale;
    precise float y = at.y * scale + (border - half_size);
    precise float2 texel = umbrage_tetrahedron_turned(at.z, float2(x, y)) + half_size;
    return texel;
}
#endif

#ifndef UMBRAGE_HAS_TETRAHEDRON_FACE_OF
#define UMBRAGE_HAS_TETRAHEDRON_FACE_OF
// umbrage_tetrahedron_face_of: face, 0.0 to 3.0, whose triangle contains a texel, in a map of size texels
float umbrage_tetrahedron_face_of(float2 texel, float size) {
    float2 off = texel * 2.0 + (1.0 - size);
    float column = off.y < 0.0 ? 0.0 : 1.0;
    float row = off.x < 0.0 ? 3.0 : 2.0;
    return abs(off.y) >= abs(off.x) ? column : row;
}
#endif

#ifndef UMBRAGE_HAS_PANCAKE
#define UMBRAGE_HAS_PANCAKE
// umbrage_pancake: clip space position, clamped to the near plane if it lies in front of it
//   at_near  z/w of the near plane: 0.0 or -1.0, or 1.0 for reversed depth
float4 umbrage_pancake(float4 position, float at_near) {
    precise float plane = at_near * position.w;
    bool before = at_near > 0.5 ? position.z > plane : position.z < plane;
    return float4(position.x, position.y, before ? plane : position.z, position.w);
}
#endif

#ifndef UMBRAGE_HAS_FROM_UNORM
#define UMBRAGE_HAS_FROM_UNORM
// umbrage_from_unorm: channel 0..255 of a value from an 8-bit texture, even if the division by 255 is inexact
float umbrage_from_unorm(float c) {
    return floor(c * 255.0 + 0.5);
}
float2 umbrage_from_unorm(float2 c) {
    return floor(c * 255.0 + 0.5);
}
float3 umbrage_from_unorm(float3 c) {
    return floor(c * 255.0 + 0.5);
}
float4 umbrage_from_unorm(float4 c) {
    return floor(c * 255.0 + 0.5);
}
#endif

#ifndef UMBRAGE_HAS_PAGE_TILE
#define UMBRAGE_HAS_PAGE_TILE
// umbrage_page_tile: first texel of a page, a whole number, in an atlas of pages of size texels, eight a row
float2 umbrage_page_tile(float number, float size) {
    float row = floor(number * 0.125);
    return float2(number - row * 8.0, row) * size;
}
#endif

#ifndef UMBRAGE_HAS_LINEAR_DEPTH
#define UMBRAGE_HAS_LINEAR_DEPTH
// umbrage_linear_depth: distance along the light's axis, positive in front of the light, times 1 / z_far
float umbrage_linear_depth(float z_view, float inv_z_far) {
    return z_view * inv_z_far;
}
#endif

#ifndef UMBRAGE_HAS_PROJECT_DEPTH
#define UMBRAGE_HAS_PROJECT_DEPTH
// umbrage_project_depth: z / w. Returns cleared for w <= 0.0: 1.0, or 0.0 where depth is reversed
float umbrage_project_depth(float z, float w, float cleared) {
    return w > 0.0 ? z / w : cleared;
}
#endif

#ifndef UMBRAGE_HAS_DISTANCE_DEPTH
#define UMBRAGE_HAS_DISTANCE_DEPTH
// umbrage_distance_depth: length of to_point, the vector from the light, times 1 / range
float umbrage_distance_depth(float3 to_point, float inv_range) {
    return sqrt(to_point.x * to_point.x + to_point.y * to_point.y + to_point.z * to_point.z) * inv_range;
}
#endif

#ifndef UMBRAGE_HAS_REVERSE_DEPTH
#define UMBRAGE_HAS_REVERSE_DEPTH
// umbrage_reverse_depth: forward depth from reversed depth, or reversed from forward
float umbrage_reverse_depth(float depth) {
    return 1.0 - depth;
}
#endif

#ifndef UMBRAGE_HAS_DEPTH_FROM_NDC
#define UMBRAGE_HAS_DEPTH_FROM_NDC
// umbrage_depth_from_ndc: depth in [0, 1] from z/w in [-1, 1]
float umbrage_depth_from_ndc(float ndc) {
    precise float depth = ndc * 0.5 + 0.5;
    return depth;
}
#endif

#ifndef UMBRAGE_HAS_VIEW_Z_FROM_DEPTH
#define UMBRAGE_HAS_VIEW_Z_FROM_DEPTH
// umbrage_view_z_from_depth: distance along the light's axis from perspective depth in [0, 1], 0.0 at z_near
float umbrage_view_z_from_depth(float depth, float z_near, float z_far) {
    return z_near / (1.0 - depth * (1.0 - z_near / z_far));
}
#endif

#ifndef UMBRAGE_HAS_DEPTH_FROM_VIEW_Z
#define UMBRAGE_HAS_DEPTH_FROM_VIEW_Z
// umbrage_depth_from_view_z: perspective depth in [0, 1], 0.0 at z_near, from the distance along the light's axis
float umbrage_depth_from_view_z(float z_view, float z_near, float z_far) {
    return (1.0 - z_near / z_view) / (1.0 - z_near / z_far);
}
#endif

#ifndef UMBRAGE_HAS_VIEW_Z_FROM_REVERSED_DEPTH
#define UMBRAGE_HAS_VIEW_Z_FROM_REVERSED_DEPTH
// umbrage_view_z_from_reversed_depth: distance along the light's axis from perspective depth in [0, 1], 1.0 at z_near
float umbrage_view_z_from_reversed_depth(float depth, float z_near, float z_far) {
    return z_near / (z_near / z_far + depth * (1.0 - z_near / z_far));
}
#endif

#ifndef UMBRAGE_HAS_REVERSED_DEPTH_FROM_VIEW_Z
#define UMBRAGE_HAS_REVERSED_DEPTH_FROM_VIEW_Z
// umbrage_reversed_depth_from_view_z: perspective depth in [0, 1], 1.0 at z_near, from the distance along the light's
// axis
float umbrage_reversed_depth_from_view_z(float z_view, float z_near, float z_far) {
    return z_near / z_view * (1.0 - z_view / z_far) / (1.0 - z_near / z_far);
}
#endif

#ifndef UMBRAGE_HAS_VIEW_Z_FROM_ORTHOGRAPHIC_DEPTH
#define UMBRAGE_HAS_VIEW_Z_FROM_ORTHOGRAPHIC_DEPTH
// umbrage_view_z_from_orthographic_depth: distance along the light's axis from orthographic depth in [0, 1]
// Depth is 0.0 at z_near. Exchange z_near and z_far where it is reversed
float umbrage_view_z_from_orthographic_depth(float depth, float z_near, float z_far) {
    precise float z_view = z_near + depth * (z_far - z_near);
    return z_view;
}
#endif

#ifndef UMBRAGE_HAS_ORTHOGRAPHIC_DEPTH_FROM_VIEW_Z
#define UMBRAGE_HAS_ORTHOGRAPHIC_DEPTH_FROM_VIEW_Z
// umbrage_orthographic_depth_from_view_z: orthographic depth in [0, 1] from the distance along the light's axis
// Depth is 0.0 at z_near. Exchange z_near and z_far where it is reversed
float umbrage_orthographic_depth_from_view_z(float z_view, float z_near, float z_far) {
    return (z_view - z_near) / (z_far - z_near);
}
#endif

#ifndef UMBRAGE_HAS_CORRECT_QUOTIENT
#define UMBRAGE_HAS_CORRECT_QUOTIENT
// umbrage_correct_quotient: floor(a / b) from a guess q, off by at most one
//   a   integer, 0 to 2^24 - 1
//   b   integer, 1 to 2^24
float umbrage_correct_quotient(float q, float a, float b) {
    float more = q + 1.0;
    float known = more * b <= a ? more : q;
    return q * b > a ? q - 1.0 : known;
}
#endif

#ifndef UMBRAGE_HAS_FLOOR_DIVIDE
#define UMBRAGE_HAS_FLOOR_DIVIDE
// umbrage_floor_divide: floor(a / b) of integers; the quotient is at most 2^18
//   a   integer, 0 to 2^24 - 1
//   b   integer, 1 to 2^24
float umbrage_floor_divide(float a, float b) {
    return umbrage_correct_quotient(floor(a / b), a, b);
}
#endif

#ifndef UMBRAGE_HAS_TO_UNORM
#define UMBRAGE_HAS_TO_UNORM
// umbrage_to_unorm: value that makes an 8-bit target store channel k, whether it rounds or truncates
// k * 257 / 65536 + 64 / 65536, in decimals because 65536.0 is infinite in mediump
float umbrage_to_unorm(float k) {
    return k * 0.0039215087890625 + 0.0009765625;
}
float2 umbrage_to_unorm(float2 k) {
    return k * 0.0039215087890625 + 0.0009765625;
}
float3 umbrage_to_unorm(float3 k) {
    return k * 0.0039215087890625 + 0.0009765625;
}
float4 umbrage_to_unorm(float4 k) {
    return k * 0.0039215087890625 + 0.0009765625;
}
#endif

#ifndef UMBRAGE_HAS_TO_UNORM10
#define UMBRAGE_HAS_TO_UNORM10
// umbrage_to_unorm10: value that makes a 10-bit target store channel k, whether it rounds or truncates
// k * 4099 / 4194304 + 1056 / 4194304
float umbrage_to_unorm10(float k) {
    return k * 0.0009772777557373046875 + 0.00025177001953125;
}
float2 umbrage_to_unorm10(float2 k) {
    return k * 0.0009772777557373046875 + 0.00025177001953125;
}
float3 umbrage_to_unorm10(float3 k) {
    return k * 0.0009772777557373046875 + 0.00025177001953125;
}
float4 umbrage_to_unorm10(float4 k) {
    return k * 0.0009772777557373046875 + 0.00025177001953125;
}
#endif

#ifndef UMBRAGE_HAS_FROM_UNORM10
#define UMBRAGE_HAS_FROM_UNORM10
// umbrage_from_unorm10: channel 0..1023 of a value from a 10-bit texture, even if the division by 1023 is inexact
float umbrage_from_unorm10(float c) {
    return floor(c * 1023.0 + 0.5);
}
float2 umbrage_from_unorm10(float2 c) {
    return floor(c * 1023.0 + 0.5);
}
float3 umbrage_from_unorm10(float3 c) {
    return floor(c * 1023.0 + 0.5);
}
float4 umbrage_from_unorm10(float4 c) {
    return floor(c * 1023.0 + 0.5);
}
#endif

#ifndef UMBRAGE_HAS_TO_UNORM16
#define UMBRAGE_HAS_TO_UNORM16
// umbrage_to_unorm16: value that makes a 16-bit target store channel k, whether it rounds or truncates
float umbrage_to_unorm16(float k) {
    return min(k + (floor(k * (1.0 / 256.0)) * (1.0 / 256.0) + 0.25), 65536.0) * (1.0 / 65536.0);
}
float2 umbrage_to_unorm16(float2 k) {
    return min(k + (floor(k * (1.0 / 256.0)) * (1.0 / 256.0) + 0.25), 65536.0) * (1.0 / 65536.0);
}
float3 umbrage_to_unorm16(float3 k) {
    return min(k + (floor(k * (1.0 / 256.0)) * (1.0 / 256.0) + 0.25), 65536.0) * (1.0 / 65536.0);
}
float4 umbrage_to_unorm16(float4 k) {
    return min(k + (floor(k * (1.0 / 256.0)) * (1.0 / 256.0) + 0.25), 65536.0) * (1.0 / 65536.0);
}
#endif

#ifndef UMBRAGE_HAS_FROM_UNORM16
#define UMBRAGE_HAS_FROM_UNORM16
// umbrage_from_unorm16: channel 0..65535 of a value from a 16-bit texture, even if the division by 65535 is inexact
float umbrage_from_unorm16(float c) {
    return floor(c * 65535.0 + 0.5);
}
float2 umbrage_from_unorm16(float2 c) {
    return floor(c * 65535.0 + 0.5);
}
float3 umbrage_from_unorm16(float3 c) {
    return floor(c * 65535.0 + 0.5);
}
float4 umbrage_from_unorm16(float4 c) {
    return floor(c * 65535.0 + 0.5);
}
#endif

#ifndef UMBRAGE_HAS_ENCODE_FLOAT_BITS
#define UMBRAGE_HAS_ENCODE_FLOAT_BITS
// umbrage_encode_float_bits: bit pattern of v as four channels, R least significant, integers 0..255
float4 umbrage_encode_float_bits(float v) {
    uint bits = asuint(v);
    return float4(float(bits & 255u), float((bits >> 8) & 255u), float((bits >> 16) & 255u), float(bits >> 24));
}
#endif

#ifndef UMBRAGE_HAS_DECODE_RG9
#define UMBRAGE_HAS_DECODE_RG9
// umbrage_decode_rg9: depth from the two channels of a 9-bit code, as sampled
//   edge   0.0, 0.5 or 1.0: lower edge, center or upper edge of the quantization step
float umbrage_decode_rg9(float2 c, float edge) {
    float2 k = umbrage_from_unorm(c);
    return (k.x + k.y * 2.0 + edge) * (1.0 / 512.0);
}
#endif

#ifndef UMBRAGE_HAS_DECODE_RG10
#define UMBRAGE_HAS_DECODE_RG10
// umbrage_decode_rg10: depth from the two channels of a 10-bit code, as sampled
//   edge   0.0, 0.5 or 1.0: lower edge, center or upper edge of the quantization step
float umbrage_decode_rg10(float2 c, float edge) {
    float2 k = umbrage_from_unorm(c);
    return (k.x + k.y * 4.0 + edge) * (1.0 / 1024.0);
}
#endif

#ifndef UMBRAGE_HAS_DECODE_RG11
#define UMBRAGE_HAS_DECODE_RG11
// umbrage_decode_rg11: depth from the two channels of a 11-bit code, as sampled
//   edge   0.0, 0.5 or 1.0: lower edge, center or upper edge of the quantization step
float umbrage_decode_rg11(float2 c, float edge) {
    float2 k = umbrage_from_unorm(c);
    return (k.x + k.y * 8.0 + edge) * (1.0 / 2048.0);
}
#endif

#ifndef UMBRAGE_HAS_DECODE_RG12
#define UMBRAGE_HAS_DECODE_RG12
// umbrage_decode_rg12: depth from the two channels of a 12-bit code, as sampled
//   edge   0.0, 0.5 or 1.0: lower edge, center or upper edge of the quantization step
float umbrage_decode_rg12(float2 c, float edge) {
    float2 k = umbrage_from_unorm(c);
    return (k.x + k.y * 16.0 + edge) * (1.0 / 4096.0);
}
#endif

#ifndef UMBRAGE_HAS_DECODE_RG13
#define UMBRAGE_HAS_DECODE_RG13
// umbrage_decode_rg13: depth from the two channels of a 13-bit code, as sampled
//   edge   0.0, 0.5 or 1.0: lower edge, center or upper edge of the quantization step
float umbrage_decode_rg13(float2 c, float edge) {
    float2 k = umbrage_from_unorm(c);
    return (k.x + k.y * 32.0 + edge) * (1.0 / 8192.0);
}
#endif

#ifndef UMBRAGE_HAS_DECODE_RG14
#define UMBRAGE_HAS_DECODE_RG14
// umbrage_decode_rg14: depth from the two channels of a 14-bit code, as sampled
//   edge   0.0, 0.5 or 1.0: lower edge, center or upper edge of the quantization step
float umbrage_decode_rg14(float2 c, float edge) {
    float2 k = umbrage_from_unorm(c);
    return (k.x + k.y * 64.0 + edge) * (1.0 / 16384.0);
}
#endif

#ifndef UMBRAGE_HAS_DECODE_RG15
#define UMBRAGE_HAS_DECODE_RG15
// umbrage_decode_rg15: depth from the two channels of a 15-bit code, as sampled
//   edge   0.0, 0.5 or 1.0: lower edge, center or upper edge of the quantization step
float umbrage_decode_rg15(float2 c, float edge) {
    float2 k = umbrage_from_unorm(c);
    return (k.x + k.y * 128.0 + edge) * (1.0 / 32768.0);
}
#endif

#ifndef UMBRAGE_HAS_DECODE_RG16
#define UMBRAGE_HAS_DECODE_RG16
// umbrage_decode_rg16: depth from the two channels of a 16-bit code, as sampled
//   edge   0.0, 0.5 or 1.0: lower edge, center or upper edge of the quantization step
float umbrage_decode_rg16(float2 c, float edge) {
    float2 k = umbrage_from_unorm(c);
    return (k.x + k.y * 256.0 + edge) * (1.0 / 65536.0);
}
#endif

#ifndef UMBRAGE_HAS_DECODE_RGB24
#define UMBRAGE_HAS_DECODE_RGB24
// umbrage_decode_rgb24: depth from three channels, as sampled
//   edge   0.0 or 1.0: lower or upper edge of the quantization step
float umbrage_decode_rgb24(float3 c, float edge) {
    float3 k = umbrage_from_unorm(c);
    return ((k.x * 256.0 + k.y) * 256.0 + k.z + edge) * (1.0 / 16777216.0);
}
#endif

#ifndef UMBRAGE_HAS_DECODE_RGB10
#define UMBRAGE_HAS_DECODE_RGB10
// umbrage_decode_rgb10: depth from three 10-bit channels, as sampled
//   edge   0.0 or 1.0: lower or upper edge of the quantization step
float umbrage_decode_rgb10(float3 c, float edge) {
    float3 k = umbrage_from_unorm10(c);
    return ((k.x * 1024.0 + k.y) * 16.0 + floor(k.z * (1.0 / 64.0)) + edge) * (1.0 / 16777216.0);
}
#endif

#ifndef UMBRAGE_HAS_DECODE_R16
#define UMBRAGE_HAS_DECODE_R16
// umbrage_decode_r16: depth from one 16-bit channel, as sampled
//   edge   0.0, 0.5 or 1.0: lower edge, center or upper edge of the quantization step
float umbrage_decode_r16(float c, float edge) {
    return (umbrage_from_unorm16(c) + edge) * (1.0 / 65536.0);
}
#endif

#ifndef UMBRAGE_HAS_DECODE_THREEJS_RGBA
#define UMBRAGE_HAS_DECODE_THREEJS_RGBA
// umbrage_decode_threejs_rgba: depth from the RGBA format of three.js r167 and later, as sampled
float umbrage_decode_threejs_rgba(float4 c) {
    precise float depth = c.x * (255.0 / 256.0) + c.y * (255.0 / 65536.0) + c.z * (255.0 / 16777216.0) + c.w *
        (1.0 / 16777216.0);
    return depth;
}
#endif

#ifndef UMBRAGE_HAS_DECODE_THREEJS_RGB
#define UMBRAGE_HAS_DECODE_THREEJS_RGB
// umbrage_decode_threejs_rgb: depth from the RGB format of three.js r167 and later, as sampled
float umbrage_decode_threejs_rgb(float3 c) {
    precise float depth = c.x * (255.0 / 256.0) + c.y * (255.0 / 65536.0) + c.z * (1.0 / 65536.0);
    return depth;
}
#endif

#ifndef UMBRAGE_HAS_DECODE_THREEJS_RG
#define UMBRAGE_HAS_DECODE_THREEJS_RG
// umbrage_decode_threejs_rg: depth from the RG format of three.js r167 and later, as sampled
float umbrage_decode_threejs_rg(float2 c) {
    precise float depth = c.x * (255.0 / 256.0) + c.y * (1.0 / 256.0);
    return depth;
}
#endif

#ifndef UMBRAGE_HAS_DECODE_THREEJS_LEGACY
#define UMBRAGE_HAS_DECODE_THREEJS_LEGACY
// umbrage_decode_threejs_legacy: depth from the RGBA format of three.js r73 to r166, as sampled
float umbrage_decode_threejs_legacy(float4 c) {
    precise float depth = c.x * (255.0 / 4294967296.0) + c.y * (255.0 / 16777216.0) + c.z * (255.0 / 65536.0) + c.w *
        (255.0 / 256.0);
    return depth;
}
#endif

#ifndef UMBRAGE_HAS_DECODE_BASE255
#define UMBRAGE_HAS_DECODE_BASE255
// umbrage_decode_base255: depth from base-255 RGBA, as sampled
float umbrage_decode_base255(float4 c) {
    precise float depth = c.x + c.y * 0.00392156886 + c.z * 0.0000153787005 + c.w * 0.0000000603086294;
    return depth;
}
#endif

#ifndef UMBRAGE_HAS_LEVEL_RG9
#define UMBRAGE_HAS_LEVEL_RG9
// umbrage_level_rg9: level of a texel from two channels of a 9-bit code, on the scale of umbrage_receiver_rg9
//   1.0 is not the far plane on this scale
float umbrage_level_rg9(float2 c) {
    return c.x + c.y * 2.0;  // an exact product: fused or not, it rounds once
}
#endif

#ifndef UMBRAGE_HAS_LEVEL_RG10
#define UMBRAGE_HAS_LEVEL_RG10
// umbrage_level_rg10: level of a texel from two channels of a 10-bit code, on the scale of umbrage_receiver_rg10
//   1.0 is not the far plane on this scale
float umbrage_level_rg10(float2 c) {
    return c.x + c.y * 4.0;  // an exact product: fused or not, it rounds once
}
#endif

#ifndef UMBRAGE_HAS_LEVEL_RG11
#define UMBRAGE_HAS_LEVEL_RG11
// umbrage_level_rg11: level of a texel from two channels of a 11-bit code, on the scale of umbrage_receiver_rg11
//   1.0 is not the far plane on this scale
float umbrage_level_rg11(float2 c) {
    return c.x + c.y * 8.0;  // an exact product: fused or not, it rounds once
}
#endif

#ifndef UMBRAGE_HAS_LEVEL_RG12
#define UMBRAGE_HAS_LEVEL_RG12
// umbrage_level_rg12: level of a texel from two channels of a 12-bit code, on the scale of umbrage_receiver_rg12
//   1.0 is not the far plane on this scale
float umbrage_level_rg12(float2 c) {
    return c.x + c.y * 16.0;  // an exact product: fused or not, it rounds once
}
#endif

#ifndef UMBRAGE_HAS_LEVEL_RG13
#define UMBRAGE_HAS_LEVEL_RG13
// umbrage_level_rg13: level of a texel from two channels of a 13-bit code, on the scale of umbrage_receiver_rg13
//   1.0 is not the far plane on this scale
float umbrage_level_rg13(float2 c) {
    return c.x + c.y * 32.0;  // an exact product: fused or not, it rounds once
}
#endif

#ifndef UMBRAGE_HAS_LEVEL_RG14
#define UMBRAGE_HAS_LEVEL_RG14
// umbrage_level_rg14: level of a texel from two channels of a 14-bit code, on the scale of umbrage_receiver_rg14
//   1.0 is not the far plane on this scale
float umbrage_level_rg14(float2 c) {
    return c.x + c.y * 64.0;  // an exact product: fused or not, it rounds once
}
#endif

#ifndef UMBRAGE_HAS_LEVEL_RG15
#define UMBRAGE_HAS_LEVEL_RG15
// umbrage_level_rg15: level of a texel from two channels of a 15-bit code, on the scale of umbrage_receiver_rg15
//   1.0 is not the far plane on this scale
float umbrage_level_rg15(float2 c) {
    return c.x + c.y * 128.0;  // an exact product: fused or not, it rounds once
}
#endif

#ifndef UMBRAGE_HAS_LEVEL_RG16
#define UMBRAGE_HAS_LEVEL_RG16
// umbrage_level_rg16: level of a texel from two channels of a 16-bit code, on the scale of umbrage_receiver_rg16
//   1.0 is not the far plane on this scale
float umbrage_level_rg16(float2 c) {
    return c.x + c.y * 256.0;  // an exact product: fused or not, it rounds once
}
#endif

#ifndef UMBRAGE_HAS_RECEIVER_RG9
#define UMBRAGE_HAS_RECEIVER_RG9
// umbrage_receiver_rg9: receiver depth on the scale of umbrage_level_rg9. It is <= a texel's level exactly when
//   depth <= umbrage_decode_rg9(texel, edge), or beyond the far plane
float umbrage_receiver_rg9(float depth, float edge) {
    precise float level = (ceil(depth * 512.0 - edge) - 0.5) * 0.00392156886;
    return depth > 1.0 ? -1.0 : level;
}
#endif

#ifndef UMBRAGE_HAS_RECEIVER_RG10
#define UMBRAGE_HAS_RECEIVER_RG10
// umbrage_receiver_rg10: receiver depth on the scale of umbrage_level_rg10. It is <= a texel's level exactly when
//   depth <= umbrage_decode_rg10(texel, edge), or beyond the far plane
float umbrage_receiver_rg10(float depth, float edge) {
    precise float level = (ceil(depth * 1024.0 - edge) - 0.5) * 0.00392156886;
    return depth > 1.0 ? -1.0 : level;
}
#endif

#ifndef UMBRAGE_HAS_RECEIVER_RG11
#define UMBRAGE_HAS_RECEIVER_RG11
// umbrage_receiver_rg11: receiver depth on the scale of umbrage_level_rg11. It is <= a texel's level exactly when
//   depth <= umbrage_decode_rg11(texel, edge), or beyond the far plane
float umbrage_receiver_rg11(float depth, float edge) {
    precise float level = (ceil(depth * 2048.0 - edge) - 0.5) * 0.00392156886;
    return depth > 1.0 ? -1.0 : level;
}
#endif

#ifndef UMBRAGE_HAS_RECEIVER_RG12
#define UMBRAGE_HAS_RECEIVER_RG12
// umbrage_receiver_rg12: receiver depth on the scale of umbrage_level_rg12. It is <= a texel's level exactly when
//   depth <= umbrage_decode_rg12(texel, edge), or beyond the far plane
float umbrage_receiver_rg12(float depth, float edge) {
    precise float level = (ceil(depth * 4096.0 - edge) - 0.5) * 0.00392156886;
    return depth > 1.0 ? -1.0 : level;
}
#endif

#ifndef UMBRAGE_HAS_RECEIVER_RG13
#define UMBRAGE_HAS_RECEIVER_RG13
// umbrage_receiver_rg13: receiver depth on the scale of umbrage_level_rg13. It is <= a texel's level exactly when
//   depth <= umbrage_decode_rg13(texel, edge), or beyond the far plane
float umbrage_receiver_rg13(float depth, float edge) {
    precise float level = (ceil(depth * 8192.0 - edge) - 0.5) * 0.00392156886;
    return depth > 1.0 ? -1.0 : level;
}
#endif

#ifndef UMBRAGE_HAS_RECEIVER_RG14
#define UMBRAGE_HAS_RECEIVER_RG14
// umbrage_receiver_rg14: receiver depth on the scale of umbrage_level_rg14. It is <= a texel's level exactly when
//   depth <= umbrage_decode_rg14(texel, edge), or beyond the far plane
float umbrage_receiver_rg14(float depth, float edge) {
    precise float level = (ceil(depth * 16384.0 - edge) - 0.5) * 0.00392156886;
    return depth > 1.0 ? -1.0 : level;
}
#endif

#ifndef UMBRAGE_HAS_RECEIVER_RG15
#define UMBRAGE_HAS_RECEIVER_RG15
// umbrage_receiver_rg15: receiver depth on the scale of umbrage_level_rg15. It is <= a texel's level exactly when
//   depth <= umbrage_decode_rg15(texel, edge), or beyond the far plane
float umbrage_receiver_rg15(float depth, float edge) {
    precise float level = (ceil(depth * 32768.0 - edge) - 0.5) * 0.00392156886;
    return depth > 1.0 ? -1.0 : level;
}
#endif

#ifndef UMBRAGE_HAS_RECEIVER_RG16
#define UMBRAGE_HAS_RECEIVER_RG16
// umbrage_receiver_rg16: receiver depth on the scale of umbrage_level_rg16. It is <= a texel's level exactly when
//   depth <= umbrage_decode_rg16(texel, edge), or beyond the far plane
float umbrage_receiver_rg16(float depth, float edge) {
    precise float level = (ceil(depth * 65536.0 - edge) - 0.5) * 0.00392156886;
    return depth > 1.0 ? -1.0 : level;
}
#endif

#ifndef UMBRAGE_HAS_DECODE_PS14
#define UMBRAGE_HAS_DECODE_PS14
// umbrage_decode_ps14: x / 2040 from the channels of an 11-bit code, as sampled. Compare with umbrage_receiver_ps14
//   1.0 is not the far plane on this scale
float umbrage_decode_ps14(float2 c) {
    return c.x * 0.125 + c.y;  // an exact product: fused or not, it rounds once
}
#endif

#ifndef UMBRAGE_HAS_RECEIVER_PS14
#define UMBRAGE_HAS_RECEIVER_PS14
// umbrage_receiver_ps14: depth * 256 / 255, the scale of umbrage_decode_ps14. Beyond the far plane every texel lights
// it
float umbrage_receiver_ps14(float depth) {
    return depth > 1.0 ? -1.0 : depth * 1.00392163;
}
#endif

#ifndef UMBRAGE_HAS_FIXED_PS14
#define UMBRAGE_HAS_FIXED_PS14
// umbrage_fixed_ps14: nearest multiple of 1 / 4096 from -8.0 to 8.0 - 1 / 4096; NaN becomes the last of them
float umbrage_fixed_ps14(float v) {
    // not v < 8.0 ? v : ...: Mesa turns it into min, and softpipe's min gives NaN
    float within = v > -8.0 && v < 7.999755859375 ? v : (v < 0.0 ? -8.0 : 7.999755859375);
    float steps = within * 4096.0;
    float below = floor(steps);
    return (steps - below < 0.5 ? below : below + 1.0) * 0.000244140625;
}
#endif

#ifndef UMBRAGE_HAS_DECODE_FIXED_PS14
#define UMBRAGE_HAS_DECODE_FIXED_PS14
// umbrage_decode_fixed_ps14: x / 2040 in steps of 1 / 4096 from the channels of an 11-bit code, as sampled
//   compare with umbrage_fixed_ps14(umbrage_receiver_ps14(depth)); 1.0 is not the far plane on this scale
float umbrage_decode_fixed_ps14(float2 c) {
    return floor(umbrage_fixed_ps14(c.x) * 512.0) * 0.000244140625 + umbrage_fixed_ps14(c.y);
}
#endif

#ifndef UMBRAGE_HAS_INSIDE_MAP
#define UMBRAGE_HAS_INSIDE_MAP
// umbrage_inside_map: true if a texel lies inside a map of size texels
precise bool umbrage_inside_map(float2 size, float2 texel) {
    return texel.x >= 0.0 && texel.y >= 0.0 && texel.x < size.x && texel.y < size.y;
}
#endif

#ifndef UMBRAGE_HAS_COMPARE_DX_SDK
#define UMBRAGE_HAS_COMPARE_DX_SDK
// umbrage_compare_dx_sdk: 0.0 when stored + epsilon < receiver, else 1.0
float umbrage_compare_dx_sdk(float receiver, float stored, float epsilon) {
    precise float limit = stored + epsilon;
    return limit < receiver ? 0.0 : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_COMPARE_EXERCISE
#define UMBRAGE_HAS_COMPARE_EXERCISE
// umbrage_compare_exercise: 1.0 when current < stored + epsilon, else 0.0
float umbrage_compare_exercise(float current, float stored, float epsilon) {
    precise float limit = stored + epsilon;
    return current < limit ? 1.0 : 0.0;
}
#endif

#ifndef UMBRAGE_HAS_DISC_ROTATION
#define UMBRAGE_HAS_DISC_ROTATION
// umbrage_disc_rotation: rotation of a disc for a pixel. Returns (cos, -sin, sin, cos) in 1/64
//   pixel   gl_FragCoord.xy, for example. Each of the 16 rotations is used once in every 4 x 4 pixels
float4 umbrage_disc_rotation(float2 pixel) {
    float2 whole = umbrage_inside_texel_space(pixel) ? floor(pixel) : float2(0.0, 0.0);
    float v = whole.x * 4.0 + whole.y;
    v = v - floor(v * (1.0 / 16.0)) * 16.0;
    float quarter = floor(v * 0.25);
    float base = v - quarter * 4.0;
    float2 low = base < 0.5 ? float2(64.0, 0.0) : float2(59.0, 24.0);
    float2 high = base < 2.5 ? float2(45.0, 45.0) : float2(24.0, 59.0);
    float2 first = base < 1.5 ? low : high;
    float2 once = quarter < 0.5 ? first : float2(0.0 - first.y, first.x);
    float2 twice = quarter < 2.5 ? float2(0.0 - first.x, 0.0 - first.y) : float2(first.y, 0.0 - first.x);
    float2 turned = quarter < 1.5 ? once : twice;
    return float4(turned.x, 0.0 - turned.y, turned.y, turned.x);
}
#endif

#ifndef UMBRAGE_HAS_SHEARED_ROTATION
#define UMBRAGE_HAS_SHEARED_ROTATION
// umbrage_sheared_rotation: rotation of a disc, and then a shear along x
//   rotation   from umbrage_disc_rotation
//   shear      by how much x grows with y, both in radii of the ellipse; -2.0 to 2.0
float4 umbrage_sheared_rotation(float4 rotation, float shear) {
    precise float x = rotation.x + shear * rotation.z;
    precise float y = rotation.y + shear * rotation.w;
    return float4(x, y, rotation.z, rotation.w);
}
#endif

#ifndef UMBRAGE_HAS_DISC_TAP
#define UMBRAGE_HAS_DISC_TAP
// umbrage_disc_tap: texel that a point of a disc falls on
//   position   floor(256 coord) of the receiver
//   p          point, in 1/16 of the radius
//   rotation   from umbrage_disc_rotation
//   radius     along x and y, in 1/16 texel, integers from 0 to 4095
float2 umbrage_disc_tap(float2 position, float2 p, float4 rotation, float2 radius) {
    float2 at = position * (1.0 / 256.0);
    float2 texel = floor(at);
    float2 within = clamp(at - texel, float2(0.0, 0.0), float2(1.0, 1.0));  // no sum is regrouped across it
    float2 wide = float2(rotation.x, rotation.y) * (radius.x * (1.0 / 16384.0));
    float2 high = float2(rotation.z, rotation.w) * (radius.y * (1.0 / 16384.0));
    float x = wide.x * p.x + within.x + wide.y * p.y;
    float y = high.x * p.x + within.y + high.y * p.y;
    return texel + floor(float2(x, y));
}
#endif

#ifndef UMBRAGE_HAS_DISC_RADIUS
#define UMBRAGE_HAS_DISC_RADIUS
// umbrage_disc_radius: radius of a disc in 1/16 texel, from one in texels
// Returns an integer from 0 to 4095, and 0 for NaN
float umbrage_disc_radius(float radius) {
    float inside = radius > 0.0 ? floor(radius * 16.0) : 0.0;
    return radius >= 255.9375 ? 4095.0 : inside;
}
#endif

#ifndef UMBRAGE_HAS_BOX_SCALE
#define UMBRAGE_HAS_BOX_SCALE
// umbrage_box_scale: 1 / (2r+1)^2, rounded to nearest
float umbrage_box_scale(int radius) {
    float scale = 0.00346020772;  // not returned as a literal: that would have the host's precision
    if (radius < 8) scale = 0.00444444455;
    if (radius < 7) scale = 0.00591715984;
    if (radius < 6) scale = 0.00826446246;
    if (radius < 5) scale = 0.0123456791;
    if (radius < 4) scale = 0.0204081628;
    if (radius < 3) scale = 0.0399999991;
    if (radius < 2) scale = 0.111111112;
    if (radius < 1) scale = 1.0;
    return scale;
}
#endif

#ifndef UMBRAGE_HAS_PENUMBRA
#define UMBRAGE_HAS_PENUMBRA
// umbrage_penumbra: radius of a penumbra along x and y in 1/16 texel, integers
//   apart      umbrage_distance_code of the receiver minus that of the blocker
//   softness   (1/16 texel per distance code along x and y, min_radius, max_radius), from make_penumbra_params
float2 umbrage_penumbra(float apart, float4 softness) {
    float2 radius = floor(float2(softness.x, softness.y) * apart);
    return min(max(radius, float2(softness.z, softness.z)), float2(softness.w, softness.w));
}
#endif

#ifndef UMBRAGE_HAS_HARDENED_KERNEL8
#define UMBRAGE_HAS_HARDENED_KERNEL8
// umbrage_hardened_kernel8: fraction of 8 points in shadow, steepened
//   blocked   number of blockers
//   ratio     width of the penumbra over that of the disc in 1/256, an integer. 256.0 changes nothing
float umbrage_hardened_kernel8(float blocked, float ratio) {
    float u = blocked * 2.0 - 8.0;
    float d = max(8.0 - abs(u), 0.0);  // not negative already: no sum is regrouped across the max
    float steep = 512.0 - d * d * d;
    float hard = u < 0.0 ? 512.0 - steep : 512.0 + steep;
    return (hard * (256.0 - ratio) + blocked * ratio * 128.0) * (1.0 / 262144.0);
}
#endif

#ifndef UMBRAGE_HAS_HARDENED_KERNEL16
#define UMBRAGE_HAS_HARDENED_KERNEL16
// umbrage_hardened_kernel16: fraction of 16 points in shadow, steepened
//   blocked   number of blockers
//   ratio     width of the penumbra over that of the disc in 1/256, an integer. 256.0 changes nothing
float umbrage_hardened_kernel16(float blocked, float ratio) {
    float u = blocked * 2.0 - 16.0;
    float d = max(16.0 - abs(u), 0.0);  // not negative already: no sum is regrouped across the max
    float steep = 4096.0 - d * d * d;
    float hard = u < 0.0 ? 4096.0 - steep : 4096.0 + steep;
    return (hard * (256.0 - ratio) + blocked * ratio * 512.0) * (1.0 / 2097152.0);
}
#endif

#ifndef UMBRAGE_HAS_HARDENED_KERNEL32
#define UMBRAGE_HAS_HARDENED_KERNEL32
// umbrage_hardened_kernel32: fraction of 32 points in shadow, steepened
//   blocked   number of blockers
//   ratio     width of the penumbra over that of the disc in 1/256, an integer. 256.0 changes nothing
float umbrage_hardened_kernel32(float blocked, float ratio) {
    float u = blocked * 2.0 - 32.0;
    float d = max(32.0 - abs(u), 0.0);  // not negative already: no sum is regrouped across the max
    float steep = 32768.0 - d * d * d;
    float hard = u < 0.0 ? 32768.0 - steep : 32768.0 + steep;
    return (hard * (256.0 - ratio) + blocked * ratio * 2048.0) * (1.0 / 16777216.0);
}
#endif

#ifndef UMBRAGE_HAS_FROM_OPTIMIZED_MOMENTS
#define UMBRAGE_HAS_FROM_OPTIMIZED_MOMENTS
// umbrage_from_optimized_moments: four moments from the result of umbrage_to_optimized_moments
float4 umbrage_from_optimized_moments(float4 o) {
    precise float x = o.x - 0.5;
    precise float z = o.z - 0.5;
    float eighth = o.y * 0.125;
    precise float b1 = z * 1.73205078 - x * 0.333333343;
    precise float b2 = o.w + eighth;
    precise float b3 = z * 1.29903817 - x * 0.75;
    precise float b4 = o.w - eighth;
    return float4(b1, b2, b3, b4);
}
#endif

#ifndef UMBRAGE_HAS_BIAS_MOMENTS
#define UMBRAGE_HAS_BIAS_MOMENTS
// umbrage_bias_moments: moments moved by a share bias.x towards (0.0, bias.y, 0.0, bias.y)
float4 umbrage_bias_moments(float4 b, float2 bias) {
    precise float x = b.x - b.x * bias.x;
    precise float y = b.y + (bias.y - b.y) * bias.x;
    precise float z = b.z - b.z * bias.x;
    precise float w = b.w + (bias.y - b.w) * bias.x;
    return float4(x, y, z, w);
}
#endif

#ifndef UMBRAGE_HAS_MOMENT_ATOMS
#define UMBRAGE_HAS_MOMENT_ATOMS
// umbrage_moment_atoms: the two depths that have the same moments with the receiver's, minus b.x, and their shares
//   b   moments, biased
//   x   the receiver's depth on -1.0 to 1.0 minus b.x
float4 umbrage_moment_atoms(float4 b, float x) {
    precise float d = b.y - b.x * b.x;
    precise float third = b.z - b.x * b.y;
    float l = third / d;
    precise float e = (b.w - b.y * b.y) - third * l;
    precise float h = b.x * 2.0 - l;
    precise float a = d * ((x + h) * x - d);
    precise float m = x * e + h * a;
    precise float c = d * (e - a);
    precise float square = m * m - 4.0 * a * c;
    float root = sqrt(square > 0.0 ? square : 0.0);
    precise float w = (m < 0.0 ? root - m : -(m + root)) * 0.5;
    float2 t = float2(w / a, c / w);
    precise float2 q = (t + h) * t - d;
    float least = d * e;
    precise float2 sum = least + (t * t * e + q * q * d);
    return float4(t.x, t.y, least / sum.x, least / sum.y);
}
#endif

#ifndef UMBRAGE_HAS_POWER_OF_TWO
#define UMBRAGE_HAS_POWER_OF_TWO
// umbrage_power_of_two: 2^n of an integer n, -64.0 to 63.0
float umbrage_power_of_two(float n) {
    uint exponent = uint(n + 127.0);
    return asfloat(exponent << 23);
}
#endif

#ifndef UMBRAGE_HAS_EXP2_POLYNOMIAL
#define UMBRAGE_HAS_EXP2_POLYNOMIAL
// umbrage_exp2_polynomial: 2^y, off by at most 1.8e-7 of itself
//   y   exponent, clamped to -64.0 to 63.0. NaN is -64.0
float umbrage_exp2_polynomial(float y) {
    float x = y > -64.0 ? min(y, 63.0) : -64.0;
    float n = floor(x);
    float f = x - n;
    precise float p = 0.00187931862 * f + 0.00899099465;
    p = p * f + 0.0558186769;
    p = p * f + 0.240159273;
    p = p * f + 0.693151712;
    p = p * f + 1.0;
    return p * umbrage_power_of_two(n);
}
#endif

#ifndef UMBRAGE_HAS_EXP2_STEPS
#define UMBRAGE_HAS_EXP2_STEPS
// umbrage_exp2_steps: 2^y, an integer below 2^12 times a power of two. y is rounded down to 1/2048
//   y   exponent, clamped to -64.0 to 63.0. NaN is -64.0
float umbrage_exp2_steps(float y) {
    float x = floor((y > -64.0 ? min(y, 63.0) : -64.0) * 2048.0);
    float n = floor(x * (1.0 / 2048.0));
    float f = max(x - n * 2048.0, 0.0);  // not negative already: no sum is regrouped across the max
    float g = floor(f * (2048.0 - f) * (1.0 / 256.0));
    float r = 1251.0 + floor(f * 314.0 * (1.0 / 2048.0));
    float m = 2048.0 + f - floor((g * r + 16384.0) * (1.0 / 32768.0));
    return m * (1.0 / 2048.0) * umbrage_power_of_two(n);
}
#endif

#ifndef UMBRAGE_HAS_CHEBYSHEV
#define UMBRAGE_HAS_CHEBYSHEV
// umbrage_chebyshev: upper bound on the fraction of depths at the receiver's depth or farther. 0.0 for NaN
//   m              mean of the depths, mean of their squares
//   receiver       receiver depth, on the same scale
//   min_variance   0.0 or more
float umbrage_chebyshev(float2 m, float receiver, float min_variance) {
    precise float difference = m.y - m.x * m.x;
    float variance = difference > min_variance ? difference : min_variance;
    precise float distance = receiver - m.x;
    precise float sum = variance + distance * distance;
    float p = variance / sum;
    return receiver <= m.x ? 1.0 : (p > 0.0 ? min(p, 1.0) : 0.0);  // a GPU's v / v may be more than 1.0
}
#endif

#ifndef UMBRAGE_HAS_REDUCE_LIGHT_BLEEDING
#define UMBRAGE_HAS_REDUCE_LIGHT_BLEEDING
// umbrage_reduce_light_bleeding: visibility from amount to 1.0, stretched to 0.0 to 1.0
float umbrage_reduce_light_bleeding(float visibility, float amount) {
    float stretched = (visibility - amount) / (1.0 - amount);
    return visibility > amount ? stretched : 0.0;
}
#endif

#ifndef UMBRAGE_HAS_ENCODE_DEVIATION
#define UMBRAGE_HAS_ENCODE_DEVIATION
// umbrage_encode_deviation: mean and mean square of depths to mean and twice the standard deviation, each 0.0 to 1.0
float2 umbrage_encode_deviation(float2 m) {
    precise float variance = m.y - m.x * m.x;
    return float2(m.x, 2.0 * sqrt(variance > 0.0 ? variance : 0.0));
}
#endif

#ifndef UMBRAGE_HAS_DECODE_DEVIATION
#define UMBRAGE_HAS_DECODE_DEVIATION
// umbrage_decode_deviation: mean and twice the standard deviation to mean and mean square of depths
float2 umbrage_decode_deviation(float2 held) {
    float half_of_it = held.y * 0.5;
    precise float square = held.x * held.x + half_of_it * half_of_it;
    return float2(held.x, square);
}
#endif

#ifndef UMBRAGE_HAS_DECODE_DEVIATION_RGBA8
#define UMBRAGE_HAS_DECODE_DEVIATION_RGBA8
// umbrage_decode_deviation_rgba8: RGBA8 mean and deviation to mean and mean square of depths
//   c   as sampled, mean in xy and deviation in zw
float2 umbrage_decode_deviation_rgba8(float4 c) {
    float mean = umbrage_decode_rg16(float2(c.x, c.y), 1.0);
    float deviation = umbrage_decode_rg16(float2(c.z, c.w), 1.0);
    return umbrage_decode_deviation(float2(mean, deviation));
}
#endif

#ifndef UMBRAGE_HAS_EXPONENTIAL_WARP
#define UMBRAGE_HAS_EXPONENTIAL_WARP
// umbrage_exponential_warp: 2^(exponent * (2.0 * depth - 1.0)) of a depth that grows with distance
float umbrage_exponential_warp(float depth, float exponent) {
    precise float y = exponent * (depth * 2.0 - 1.0);
    return umbrage_exp2_polynomial(y);
}
#endif

#ifndef UMBRAGE_HAS_TO_OPTIMIZED_MOMENTS
#define UMBRAGE_HAS_TO_OPTIMIZED_MOMENTS
// umbrage_to_optimized_moments: four moments for four 16-bit channels, each over all of 0.0 to 1.0
float4 umbrage_to_optimized_moments(float4 b) {
    precise float x = (b.x * 0.75 - b.z) * 2.0 + 0.5;
    precise float y = (b.y - b.w) * 4.0;
    precise float z = (b.x * 2.25 - b.z) * 0.384900182 + 0.5;
    precise float w = (b.y + b.w) * 0.5;
    return float4(x, y, z, w);
}
#endif

#ifndef UMBRAGE_HAS_HAUSDORFF_SHARE
#define UMBRAGE_HAS_HAUSDORFF_SHARE
// umbrage_hausdorff_share: smallest fraction of depths nearer than the receiver, from four moments of depths on [-1, 1]
// Returns a negative number where umbrage_moment_atoms gives the fraction
//   b   moments, biased
//   z   the receiver's depth on -1.0 to 1.0
float umbrage_hausdorff_share(float4 b, float z) {
    precise float variance = b.y - b.x * b.x;
    precise float third = b.z - b.x * b.y;
    precise float fourth = b.w - b.y * b.y;
    precise float rest = 1.0 - b.y;
    precise float x = z - b.x;
    precise float d = third + rest * x;
    precise float g = (fourth - variance * rest) - (z + b.x) * third;
    precise float p = d * (1.0 + b.x) + g;
    precise float q = d * (1.0 - b.x) - g;
    precise float k = rest * g + third * d;
    precise float first = (1.0 + z) * (d * variance + g * (1.0 - b.x)) - k;
    precise float last = (1.0 - z) * (d * variance - g * (1.0 + b.x)) + k;
    float square = d * d;
    precise float between = p * (q * (x * d - g));
    float end = first / (2.0 * ((1.0 + z) * p));
    float other = square * square / between;
    float share = end + (d > 0.0 ? other : 0.0);
    bool four = first * p > 0.0 && last * q > 0.0 && p * q > 0.0 && share >= 0.0;
    return z <= -1.0 ? 0.0 : (four ? (share < 1.0 ? share : 1.0) : -1.0);
}
#endif

#ifndef UMBRAGE_HAS_CHEBYSHEV_HARDWARE
#define UMBRAGE_HAS_CHEBYSHEV_HARDWARE
// umbrage_chebyshev_hardware: upper bound on visibility with light bleeding reduced
//   variance   above 0.0
//   distance   from the mean to the receiver, no NaN
//   amount     visibility that becomes 0.0, 0.0 to 0.5
float umbrage_chebyshev_hardware(float variance, float distance, float amount) {
    float beyond = max(distance, 0.0);
    float p = variance / (variance + beyond * beyond);
    return clamp((p - amount) / (1.0 - amount), 0.0, 1.0);
}
#endif

#ifndef UMBRAGE_HAS_TEXELS_TO_WORLD
#define UMBRAGE_HAS_TEXELS_TO_WORLD
// umbrage_texels_to_world: texels across a light as world units; 0.0 for w <= 0.0
//   units  (edge of a texel, depth per world unit) at w = 1.0
//   w      w of the point's shadow coordinate
float umbrage_texels_to_world(float texels, float2 units, float w) {
    precise float world = texels * units.x * w;
    return world >= (1.0 / 18446744073709551616.0) && world < 18446744073709551616.0 ? world : 0.0;
}
#endif

#ifndef UMBRAGE_HAS_CLAMP_BIAS
#define UMBRAGE_HAS_CLAMP_BIAS
// umbrage_clamp_bias: bias in depth clamped to [0, 1]; 0.0 below 2^-64, and 1.0 (no shadows) for NaN
float umbrage_clamp_bias(float bias) {
    float least = (1.0 / 18446744073709551616.0);
    return bias < 1.0 ? (bias >= least ? bias : 0.0) : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_WORLD_TO_DEPTH
#define UMBRAGE_HAS_WORLD_TO_DEPTH
// umbrage_world_to_depth: world units along a light as depth, 0.0 to 1.0
//   units  (edge of a texel, depth per world unit) at w = 1.0
//   w      w of the point's shadow coordinate, above 0.0
float umbrage_world_to_depth(float world, float2 units, float w) {
    precise float along = world * units.y;
    precise float square = w * w;
    return umbrage_clamp_bias(along / square);
}
#endif

#ifndef UMBRAGE_HAS_CLAMP_SLOPE
#define UMBRAGE_HAS_CLAMP_SLOPE
// umbrage_clamp_slope: change of depth per texel clamped to [-2, 2]; NaN becomes 2.0
float umbrage_clamp_slope(float slope) {
    return abs(slope) < 2.0 ? slope : (slope <= -2.0 ? -2.0 : 2.0);
}
#endif

#ifndef UMBRAGE_HAS_PLANE_IN_MAP
#define UMBRAGE_HAS_PLANE_IN_MAP
// umbrage_plane_in_map: normal, in texels, texels and depth, of the plane through a point
//   plane_matrix  transpose of the texture matrix' inverse
//   normal        normal of the plane, any length
//   world         point on the plane
float3 umbrage_plane_in_map(float4x4 plane_matrix, float3 normal, float3 world) {
    float d = -(normal.x * world.x + normal.y * world.y + normal.z * world.z);
    float4 q = transpose(plane_matrix)[3] * d + transpose(plane_matrix)[0] * normal.x + transpose(plane_matrix)[1] *
        normal.y + transpose(plane_matrix)[2] * normal.z;
    return float3(q.x, q.y, q.z);
}
#endif

#ifndef UMBRAGE_HAS_PLANE_SLOPE
#define UMBRAGE_HAS_PLANE_SLOPE
// umbrage_plane_slope: change of depth per texel, in x and y, of the plane through a point
//   plane_matrix, normal, world   as for umbrage_plane_in_map
float2 umbrage_plane_slope(float4x4 plane_matrix, float3 normal, float3 world) {
    float3 q = umbrage_plane_in_map(plane_matrix, normal, world);
    return float2(umbrage_clamp_slope(-q.x / q.z), umbrage_clamp_slope(-q.y / q.z));
}
#endif

#ifndef UMBRAGE_HAS_RECEIVER_SLOPE
#define UMBRAGE_HAS_RECEIVER_SLOPE
// umbrage_receiver_slope: umbrage_plane_slope without its clamps; (0.0, 0.0) for a normal of zero (the caller has none)
float2 umbrage_receiver_slope(float4x4 plane_matrix, float3 normal, float3 world) {
    float3 q = umbrage_plane_in_map(plane_matrix, normal, world);
    float depth = q.z == 0.0 ? 1.0e-30 : q.z;  // q is zero without a normal, and not where edge-on
    return float2(-q.x / depth, -q.y / depth);
}
#endif

#ifndef UMBRAGE_HAS_CASCADE_SLOPE
#define UMBRAGE_HAS_CASCADE_SLOPE
// umbrage_cascade_slope: change of depth per texel; (0.0, 0.0) for a normal of zero
//   normal  surface normal, rotated into the light's axes
//   scale   scale of the cascade
float2 umbrage_cascade_slope(float3 normal, float4 scale) {
    float2 up = float2(normal.x, normal.y) * -scale.z;
    float z = normal.z == 0.0 ? 1.0e-18 : normal.z;  // up is zero without a normal, and not where edge-on
    float2 across = float2(scale.x, scale.y) * z;
    return float2(up.x / across.x, up.y / across.y);
}
#endif

#ifndef UMBRAGE_HAS_SLOPE_BIAS
#define UMBRAGE_HAS_SLOPE_BIAS
// umbrage_slope_bias: factor times the larger slope, plus a base, 0.0 to 1.0
//   slope   change of depth per texel
//   factor  factor of the slope, in texels
//   base    constant bias, in depth
float umbrage_slope_bias(float2 slope, float factor, float base) {
    precise float2 bias = abs(slope) * factor + base;
    float x = umbrage_clamp_bias(bias.x);  // clamp first: GPUs differ in the maximum of a NaN
    float y = umbrage_clamp_bias(bias.y);
    return x > y ? x : y;
}
#endif

#ifndef UMBRAGE_HAS_DUAL_PARABOLOID_SLOPE
#define UMBRAGE_HAS_DUAL_PARABOLOID_SLOPE
// umbrage_dual_paraboloid_slope: change of distance per texel, the same in x and y; 0.0 without a normal
//   way        from the light to the receiver
//   normal     surface normal
//   per_texel  2.0 / (range * (size - 2.0 * border))
float2 umbrage_dual_paraboloid_slope(float3 way, float3 normal, float per_texel) {
    precise float square = way.x * way.x + way.y * way.y + way.z * way.z;
    precise float x = normal.y * way.z - normal.z * way.y;
    precise float y = normal.z * way.x - normal.x * way.z;
    precise float z = normal.x * way.y - normal.y * way.x;
    precise float across = x * x + y * y + z * z;
    precise float along = normal.x * way.x + normal.y * way.y + normal.z * way.z;
    precise float wide = (sqrt(square) + abs(way.z)) * (per_texel * 0.707106781);
    float slope = umbrage_clamp_slope(wide * sqrt(across) / abs(along));
    bool none = normal.x == 0.0 && normal.y == 0.0 && normal.z == 0.0;
    return none ? float2(0.0, 0.0) : float2(slope, slope);
}
#endif

#ifndef UMBRAGE_HAS_NORMAL_OFFSET
#define UMBRAGE_HAS_NORMAL_OFFSET
// umbrage_normal_offset: offset to add to a surface point before its lookup, world units
//   normal       surface normal, of length one
//   direction    direction of the light, of length one
//   way          from the light to the point over w; for a directional light its direction
//   width        sqrt(2) reach texel
//   error_world  error of the map's depths, world units
float3 umbrage_normal_offset(float3 normal, float3 direction, float3 way, float width, float error_world) {
    precise float x = normal.y * direction.z + normal.z * -direction.y;
    precise float y = normal.z * direction.x + normal.x * -direction.z;
    precise float z = normal.x * direction.y + normal.y * -direction.x;
    precise float straight = normal.x * way.x + normal.y * way.y + normal.z * way.z;
    precise float square = x * x + y * y + z * z;
    precise float along = width * sqrt(square) + error_world * abs(straight);
    float3 offset = normal * along;
    return abs(offset.x) + abs(offset.y) + abs(offset.z) < 18446744073709551616.0 ? offset : float3(0.0, 0.0, 0.0);
}
#endif

#ifndef UMBRAGE_HAS_KERNEL_BIAS
#define UMBRAGE_HAS_KERNEL_BIAS
// umbrage_kernel_bias: distance along the light that a kernel extends beyond a surface's plane, in width's unit
//   normal     surface normal
//   direction  direction of the light, of length one
//   way        from the light to the point over w; for a directional light its direction
//   width      sqrt(2) reach texel
//   greatest   limit of the tangent
float umbrage_kernel_bias(float3 normal, float3 direction, float3 way, float width, float greatest) {
    precise float x = normal.y * direction.z + normal.z * -direction.y;
    precise float y = normal.z * direction.x + normal.x * -direction.z;
    precise float z = normal.x * direction.y + normal.y * -direction.x;
    precise float square = x * x + y * y + z * z;
    float sine = sqrt(square);
    precise float cosine = -(normal.x * way.x + normal.y * way.y + normal.z * way.z);
    precise float edge = cosine * greatest;
    float tangent = edge > sine ? sine / cosine : greatest;
    float bias = width * tangent;
    return bias >= (1.0 / 18446744073709551616.0) && bias < 18446744073709551616.0 ? bias : 0.0;
}
#endif

#ifndef UMBRAGE_HAS_RECEIVER_PLANE_SLOPE
#define UMBRAGE_HAS_RECEIVER_PLANE_SLOPE
// umbrage_receiver_plane_slope: change of a receiver's depth per texel in x and y, and the largest error of their sum
//   dx, dy  dFdx and dFdy of (x and y in texels, depth); the result is zero where they do not give the plane
float3 umbrage_receiver_plane_slope(float3 dx, float3 dy) {
    precise float determinant = dx.x * dy.y + dx.y * -dy.x;
    precise float sum = abs(dx.x) + abs(dx.y) + abs(dy.x) + abs(dy.y);
    precise float along_x = dy.y * dx.z + dx.y * -dy.z;
    precise float along_y = dx.x * dy.z + dy.x * -dx.z;
    float a = umbrage_clamp_slope(along_x / determinant);
    float b = umbrage_clamp_slope(along_y / determinant);
    precise float off = ((1.0 / 33554432.0) + (abs(a) + abs(b)) * (1.0 / 8192.0)) * 3.3;
    precise float error = off * (sum / abs(determinant));
    float least = sum * (1.0 / 1024.0);
    bool known = abs(determinant) > least && sum < 18446744073709551616.0;
    return known ? float3(a, b, umbrage_clamp_slope(error)) : float3(0.0, 0.0, 0.0);
}
#endif

#ifndef UMBRAGE_HAS_ACNE_FREE_BIAS
#define UMBRAGE_HAS_ACNE_FREE_BIAS
// umbrage_acne_free_bias: bias in depth without shadow acne, 0.0 to 1.0
//   slope  change of depth per texel, in x and y
//   reach  filter radius, in texels
//   error  largest error of a decoded depth towards the light
float umbrage_acne_free_bias(float2 slope, float reach, float error) {
    precise float bias = reach * (abs(slope.x) + abs(slope.y)) + (error + (1.0 / 8388608.0));
    return umbrage_clamp_bias(bias);
}
#endif

#ifndef UMBRAGE_HAS_ACNE_FREE_DISC_BIAS
#define UMBRAGE_HAS_ACNE_FREE_DISC_BIAS
// umbrage_acne_free_disc_bias: bias in depth without shadow acne for a disc, 0.0 to 1.0
//   slope   change of depth per texel, in x and y
//   radius  distance to the disc's farthest point, in texels
//   error   largest error of a decoded depth towards the light
float umbrage_acne_free_disc_bias(float2 slope, float radius, float error) {
    precise float square = slope.x * slope.x + slope.y * slope.y;
    precise float beside = (abs(slope.x) + abs(slope.y)) * 0.5078125 + (error + (1.0 / 8388608.0));
    precise float bias = radius * sqrt(square) + beside;
    return umbrage_clamp_bias(bias);
}
#endif

#ifndef UMBRAGE_HAS_PETER_PANNING_DISTANCE
#define UMBRAGE_HAS_PETER_PANNING_DISTANCE
// umbrage_peter_panning_distance: depth, 0.0 to 1.0, within which casters lose their shadow or part of it
//   bias          bias of the receiver, in depth
//   caster_slope  change of the caster's depth per texel
//   reach         filter radius, in texels
float umbrage_peter_panning_distance(float bias, float2 caster_slope, float reach) {
    return umbrage_acne_free_bias(caster_slope, reach, bias);
}
#endif

#ifndef UMBRAGE_HAS_SPOT_CONE
#define UMBRAGE_HAS_SPOT_CONE
// umbrage_spot_cone: 1.0 inside the cone of a spot light, else 0.0
//   direction  of the light, unit length;   to_point  from the light, any length;   cos_outer  in [0, 1)
float umbrage_spot_cone(float3 direction, float3 to_point, float cos_outer) {
    precise float d = direction.x * to_point.x + direction.y * to_point.y + direction.z * to_point.z;
    precise float length2 = to_point.x * to_point.x + to_point.y * to_point.y + to_point.z * to_point.z;
    precise float edge2 = cos_outer * cos_outer * length2;
    precise float d2 = d * d;
    return d > 0.0 && d2 > edge2 ? 1.0 : 0.0;
}
#endif

#ifndef UMBRAGE_HAS_DIFFUSE_AMBIENT
#define UMBRAGE_HAS_DIFFUSE_AMBIENT
// umbrage_diffuse_ambient: albedo * (visibility * n_dot_l * (1 - ambient) + ambient)
//   for n_dot_l <= 0.0 and NaN: albedo * ambient
float3 umbrage_diffuse_ambient(float3 albedo, float3 ambient, float n_dot_l, float visibility) {
    precise float3 light = visibility * n_dot_l * (1.0 - ambient) + ambient;
    return albedo * (n_dot_l > 0.0 ? light : ambient);  // max gives NaN for a signalling NaN on Mesa
}
#endif

#ifndef UMBRAGE_HAS_OVERLAY_TEXEL
#define UMBRAGE_HAS_OVERLAY_TEXEL
// umbrage_overlay_texel: texel under a pixel of a map drawn in the picture's corner; -1.0 outside the overlay
//   coord             center of the pixel, counted from the corner: 0.5, 1.5, ...
//   size              size of the overlay in pixels, an integer
//   map_size          size of the map in texels, an integer, at most 65536.0; times size at most 2^23
//   texels_per_pixel  map_size / size
float umbrage_overlay_texel(float coord, float size, float map_size, float texels_per_pixel) {
    float texel = floor(coord * texels_per_pixel - 0.5);
    texel += (texel + 1.0) * size <= coord * map_size ? 1.0 : 0.0;
    return coord >= 0.0 && coord < size ? texel : -1.0;
}
#endif

#ifndef UMBRAGE_HAS_PROBE_INPUTS
#define UMBRAGE_HAS_PROBE_INPUTS
// umbrage_probe_inputs: color, unless the receiver is wrong
//   magenta  position or normal is not a number
//   yellow   a normal of zero
float3 umbrage_probe_inputs(float3 color, float3 world, float3 normal) {
    float limit = 18446744073709551616.0;
    // limits differ on purpose: Mesa makes max(x, y) < limit of equal ones, which loses a NaN
    bool usable = abs(world.x) < limit && abs(world.y) * 2.0 < limit * 2.0 && abs(world.z) * 4.0 < limit * 4.0;
    usable = usable && abs(normal.x) * 8.0 < limit * 8.0;
    usable = usable && abs(normal.y) * 16.0 < limit * 16.0 && abs(normal.z) * 32.0 < limit * 32.0;
    bool zero = normal.x == 0.0 && normal.y == 0.0 && normal.z == 0.0;
    float3 given = zero ? float3(1.0, 1.0, 0.0) : color;
    return usable ? given : float3(1.0, 0.0, 1.0);
}
#endif

#ifndef UMBRAGE_HAS_MAP_TILE
#define UMBRAGE_HAS_MAP_TILE
// umbrage_map_tile: first texel of a map in an atlas of maps of size texels, row by row
//   number    number of the map, a whole number
//   columns   maps per row, and 1.0 / their number
float2 umbrage_map_tile(float number, float2 columns, float2 size) {
    float row = floor((number + 0.5) * columns.y);
    return float2(number - row * columns.x, row) * size;
}
#endif

#ifndef UMBRAGE_HAS_ANCHORED_VERTEX
#define UMBRAGE_HAS_ANCHORED_VERTEX
// umbrage_anchored_vertex: clip space position of a vertex of a depth pass
//   to_clip, anchor   of a depth_view: anchor.xyz is subtracted from world, and anchor.w times w is added to z
float4 umbrage_anchored_vertex(float4x4 to_clip, float3 world, float4 anchor) {
    precise float3 way = world - float3(anchor.x, anchor.y, anchor.z);
    float4 c = umbrage_shadow_coordinate(to_clip, way);
    precise float depth = c.z + anchor.w * c.w;
    return float4(c.x, c.y, depth, c.w);
}
#endif

#ifndef UMBRAGE_HAS_ANCHORED_PLACE
#define UMBRAGE_HAS_ANCHORED_PLACE
// umbrage_anchored_place: place of a point in one map, and the slack of its plane
//   to_texels, planes   matrices from positions less the anchor to texels of the map, and to their planes
//   rounding, slack     of anchored_map; slack.w is added to depth
//   way                 position less the anchor
//   returns (texels, texels, depth, 0.0), (slope, slope, weight, slack); behind the light: a place taken as lit
float4x4 umbrage_anchored_place(float4x4 to_texels, float4x4 planes, float4 rounding, float4 slack, float3 way,
                                float3 normal) {
    float4 none = float4(0.0, 0.0, 0.0, 0.0);
    float4 c = transpose(to_texels)[3] + transpose(to_texels)[0] * way.x + transpose(to_texels)[1] * way.y +
        transpose(to_texels)[2] * way.z;
    float2 slope = umbrage_receiver_slope(planes, normal, way);
    bool before = c.w > 0.0;
    float i = before ? 1.0 / c.w : 0.0;
    float3 at = float3(c.x, c.y, c.z) * i;
    float steep = abs(slope.x) + abs(slope.y);
    float moves = rounding.x + rounding.y * i;
    float off = moves * (rounding.w + abs(at.z)) + (abs(at.z) * slack.y + slack.z);
    float all = (moves * rounding.z + slack.x) * steep + off;
    return transpose(float4x4(float4(before ? at.x : 65536.0, at.y, at.z + slack.w, 0.0), float4(slope, 1.0, all), none,
                              none));
}
#endif

#ifndef UMBRAGE_HAS_SINGLE_MAP_PLACES
#define UMBRAGE_HAS_SINGLE_MAP_PLACES
// umbrage_single_map_places: place of a point of the world in a light's one map
//   to_texels, planes, rounding, slack   of umbrage_anchored_place, which has what it returns
//   anchor                               position that is subtracted from world
float4x4 umbrage_single_map_places(float4x4 to_texels, float4x4 planes, float4 anchor, float4 rounding, float4 slack,
                                   float4 terms, float3 world, float3 normal) {
    precise float3 way = world - float3(anchor.x, anchor.y, anchor.z);
    return umbrage_anchored_place(to_texels, planes, rounding, slack, way, normal);
}
#endif

#ifndef UMBRAGE_HAS_PARALLEL_MAP_PLACES
#define UMBRAGE_HAS_PARALLEL_MAP_PLACES
// umbrage_parallel_map_places: umbrage_single_map_places under parallel rays, where w is 1
float4x4 umbrage_parallel_map_places(float4x4 to_texels, float4x4 planes, float4 anchor, float4 rounding, float4 slack,
                                     float4 terms, float3 world, float3 normal) {
    float4 none = float4(0.0, 0.0, 0.0, 0.0);
    float4 one = float4(1.0, 1.0, 1.0, 1.0);
    precise float3 way = world - float3(anchor.x, anchor.y, anchor.z);
    float4 c = transpose(to_texels)[3] + transpose(to_texels)[0] * way.x + transpose(to_texels)[1] * way.y +
        transpose(to_texels)[2] * way.z;
    float4 q = transpose(planes)[0] * normal.x + transpose(planes)[1] * normal.y + transpose(planes)[2] * normal.z;
    float2 slope = umbrage_cascade_slope(float3(q.x, q.y, q.z), one);
    float steep = abs(slope.x) + abs(slope.y);
    float off = abs(c.z) * slack.y + slack.z;
    return transpose(float4x4(float4(c.x, c.y, c.z + slack.w, 0.0), float4(slope, 1.0, slack.x * steep + off), none,
                              none));
}
#endif

#ifndef UMBRAGE_HAS_CASCADE_EDGE
#define UMBRAGE_HAS_CASCADE_EDGE
// umbrage_cascade_edge: texels beyond the part of a cascade's map where a filter stays inside, at most 0.0 inside
//   light          the point, rotated into the light's axes
//   scale, offset  those of the cascade
//   size, reach    size of the map and filter radius, in texels
// Returns 65536.0 for a depth outside [0, 1], and for NaN there
float umbrage_cascade_edge(float3 light, float4 scale, float4 offset, float2 size, float reach) {
    float3 at = light * float3(scale.x, scale.y, scale.z) + float3(offset.x, offset.y, offset.z);
    float2 half_size = size * 0.5;
    float2 beyond = abs(float2(at.x, at.y) - half_size) - (half_size - reach);
    return abs(at.z - 0.5) <= 0.5 ? max(beyond.x, beyond.y) : 65536.0;
}
#endif

#ifndef UMBRAGE_HAS_CASCADE_EDGES
#define UMBRAGE_HAS_CASCADE_EDGES
// umbrage_cascade_edges: umbrage_cascade_edge of four cascades
//   scales, offsets   one column per cascade
float4 umbrage_cascade_edges(float3 light, float4x4 scales, float4x4 offsets, float2 size, float reach) {
    return float4(umbrage_cascade_edge(light, transpose(scales)[0], transpose(offsets)[0], size, reach),
                  umbrage_cascade_edge(light, transpose(scales)[1], transpose(offsets)[1], size, reach),
                  umbrage_cascade_edge(light, transpose(scales)[2], transpose(offsets)[2], size, reach),
                  umbrage_cascade_edge(light, transpose(scales)[3], transpose(offsets)[3], size, reach));
}
#endif

#ifndef UMBRAGE_HAS_FIRST_CASCADE
#define UMBRAGE_HAS_FIRST_CASCADE
// umbrage_first_cascade: number of the first of four cascades that holds a point and its filter, its edge, and the edge
// of the next one; (4.0, 65536.0, 65536.0) for none
//   edges   umbrage_cascade_edge of each
float3 umbrage_first_cascade(float4 edges) {
    float3 found = edges.w <= 0.0 ? float3(3.0, edges.w, 65536.0) : float3(4.0, 65536.0, 65536.0);
    found = edges.z <= 0.0 ? float3(2.0, edges.z, edges.w) : found;
    found = edges.y <= 0.0 ? float3(1.0, edges.y, edges.z) : found;
    return edges.x <= 0.0 ? float3(0.0, edges.x, edges.y) : found;
}
#endif

#ifndef UMBRAGE_HAS_NEXT_CASCADE_WEIGHT
#define UMBRAGE_HAS_NEXT_CASCADE_WEIGHT
// umbrage_next_cascade_weight: weight of the next cascade, which grows towards the border of a cascade's map
//   found      of umbrage_first_cascade
//   blending   1.0 / width of the band in texels, or 0.0; number of the last cascade, after which comes light
float umbrage_next_cascade_weight(float3 found, float4 blending) {
    precise float2 v = float2(found.y, found.z) * blending.x + 1.0;
    float leaves = umbrage_cascade_weight(v.x);
    float held = found.z <= 0.0 ? 1.0 - umbrage_cascade_weight(v.y) : 0.0;
    float weight = found.x >= blending.y ? leaves : min(leaves, held);
    return blending.x > 0.0 && found.x <= blending.y ? weight : 0.0;
}
#endif

#ifndef UMBRAGE_HAS_CASCADED_MAPS_CHOICE
#define UMBRAGE_HAS_CASCADED_MAPS_CHOICE
// umbrage_cascaded_maps_choice: number of the first of up to four cascades that holds a point, and weight of the next
//   rotation          rotation from the world to the light's axes
//   scales, offsets   scales and offsets of the cascades
//   anchor            position that is subtracted from world
//   blending, terms   as for umbrage_next_cascade_weight; size of a map and reach of the filter
float2 umbrage_cascaded_maps_choice(float4x4 rotation, float4x4 scales, float4x4 offsets, float4 anchor,
                                    float4 blending, float4 terms, float3 world) {
    float2 size = float2(terms.x, terms.y);
    precise float3 way = world - float3(anchor.x, anchor.y, anchor.z);
    float4 turned = transpose(rotation)[3] + transpose(rotation)[0] * way.x + transpose(rotation)[1] * way.y +
        transpose(rotation)[2] * way.z;
    float3 light = float3(turned.x, turned.y, turned.z);
    float3 found = umbrage_first_cascade(umbrage_cascade_edges(light, scales, offsets, size, terms.z));
    return float2(found.x, umbrage_next_cascade_weight(found, blending));
}
#endif

#ifndef UMBRAGE_HAS_CASCADED_MAPS_CHOICE_8
#define UMBRAGE_HAS_CASCADED_MAPS_CHOICE_8
// umbrage_cascaded_maps_choice_8: umbrage_cascaded_maps_choice for up to eight cascades
//   farther_scales, farther_offsets   those of the fifth cascade and of those after it
float2 umbrage_cascaded_maps_choice_8(float4x4 rotation, float4x4 scales, float4x4 offsets, float4x4 farther_scales,
                                      float4x4 farther_offsets, float4 anchor, float4 blending, float4 terms,
                                      float3 world) {
    float2 size = float2(terms.x, terms.y);
    precise float3 way = world - float3(anchor.x, anchor.y, anchor.z);
    float4 turned = transpose(rotation)[3] + transpose(rotation)[0] * way.x + transpose(rotation)[1] * way.y +
        transpose(rotation)[2] * way.z;
    float3 light = float3(turned.x, turned.y, turned.z);
    float4 nearer = umbrage_cascade_edges(light, scales, offsets, size, terms.z);
    float4 farther = umbrage_cascade_edges(light, farther_scales, farther_offsets, size, terms.z);
    float3 found = umbrage_first_cascade(nearer);
    float3 after = umbrage_first_cascade(farther);
    float next = found.x == 3.0 ? farther.x : found.z;
    found = found.x < 3.5 ? float3(found.x, found.y, next) : float3(after.x + 4.0, after.y, after.z);
    return float2(found.x, umbrage_next_cascade_weight(found, blending));
}
#endif

#ifndef UMBRAGE_HAS_CASCADE_PLACE
#define UMBRAGE_HAS_CASCADE_PLACE
// umbrage_cascade_place: place of a point in one cascade
//   light, across   the point and its normal, rotated into the light's axes
//   scale, offset   those of the cascade. w: slack of a plane in texels of slope, and in depth
//   number, last    number of the cascade and of the last one; above it the place is outside all maps, where all is lit
//   returns (texels, texels, depth, number), (slope, slope, weight, slack)
float4x4 umbrage_cascade_place(float3 light, float3 across, float4 scale, float4 offset, float number, float last) {
    float4 none = float4(0.0, 0.0, 0.0, 0.0);
    float3 at = light * float3(scale.x, scale.y, scale.z) + float3(offset.x, offset.y, offset.z);
    float x = number <= last ? at.x : -65536.0;
    float2 slope = umbrage_cascade_slope(across, scale);
    float slack = (abs(slope.x) + abs(slope.y)) * scale.w + offset.w;
    return transpose(float4x4(float4(x, at.y, at.z, min(number, last)), float4(slope, 1.0, slack), none, none));
}
#endif

#ifndef UMBRAGE_HAS_CASCADED_MAPS_PLACE
#define UMBRAGE_HAS_CASCADED_MAPS_PLACE
// umbrage_cascaded_maps_place: umbrage_cascade_place of a point of the world, in one of up to four cascades
//   number   number of the cascade
//   the others as for umbrage_cascaded_maps_choice
float4x4 umbrage_cascaded_maps_place(float4x4 rotation, float4x4 scales, float4x4 offsets, float4 anchor,
                                     float4 blending, float4 terms, float3 world, float3 normal, float number) {
    precise float3 way = world - float3(anchor.x, anchor.y, anchor.z);
    float4 light = transpose(rotation)[3] + transpose(rotation)[0] * way.x + transpose(rotation)[1] * way.y +
        transpose(rotation)[2] * way.z;
    float4 across = transpose(rotation)[3] + transpose(rotation)[0] * normal.x + transpose(rotation)[1] * normal.y +
        transpose(rotation)[2] * normal.z;
    float own = min(number, blending.y);
    return umbrage_cascade_place(float3(light.x, light.y, light.z), float3(across.x, across.y, across.z),
                                 umbrage_cascade_column(scales, own), umbrage_cascade_column(offsets, own), number,
                                 blending.y);
}
#endif

#ifndef UMBRAGE_HAS_CASCADED_MAPS_PLACE_8
#define UMBRAGE_HAS_CASCADED_MAPS_PLACE_8
// umbrage_cascaded_maps_place_8: umbrage_cascaded_maps_place for up to eight cascades
//   farther_scales, farther_offsets   those of the fifth cascade and of those after it
float4x4 umbrage_cascaded_maps_place_8(float4x4 rotation, float4x4 scales, float4x4 offsets, float4x4 farther_scales,
                                       float4x4 farther_offsets, float4 anchor, float4 blending, float4 terms,
                                       float3 world, float3 normal, float number) {
    precise float3 way = world - float3(anchor.x, anchor.y, anchor.z);
    float4 light = transpose(rotation)[3] + transpose(rotation)[0] * way.x + transpose(rotation)[1] * way.y +
        transpose(rotation)[2] * way.z;
    float4 across = transpose(rotation)[3] + transpose(rotation)[0] * normal.x + transpose(rotation)[1] * normal.y +
        transpose(rotation)[2] * normal.z;
    float own = min(number, blending.y);
    return umbrage_cascade_place(float3(light.x, light.y, light.z), float3(across.x, across.y, across.z),
                                 umbrage_cascade_column_8(scales, farther_scales, own),
                                 umbrage_cascade_column_8(offsets, farther_offsets, own), number, blending.y);
}
#endif

#ifndef UMBRAGE_HAS_CUBE_MAPS_PLACES
#define UMBRAGE_HAS_CUBE_MAPS_PLACES
// umbrage_cube_maps_places: place of a point of the world in a cube's six maps
//   face              texels a unit across the face's axis, at distance 1 along it; middle of a map; depth over
//                     1.0 / distance, and that by texels
//   anchor            position of the light
//   rounding, slack   of umbrage_anchored_place, from a face's axes
//   returns (texels, texels, depth, number), (slope, slope, weight, slack)
float4x4 umbrage_cube_maps_places(float4 face, float4 anchor, float4 rounding, float4 slack, float4 terms, float3 world,
                                  float3 normal) {
    float4 none = float4(0.0, 0.0, 0.0, 0.0);
    precise float3 way = world - float3(anchor.x, anchor.y, anchor.z);
    float3 m = abs(way);
    bool on_x = m.x >= m.y ? m.x >= m.z : false;
    bool on_y = on_x ? false : m.y >= m.z;
    float along = on_x ? way.x : (on_y ? way.y : way.z);
    float flip = along < 0.0 ? -1.0 : 1.0;
    float number = (on_x ? 0.5 : (on_y ? 2.5 : 4.5)) - 0.5 * flip;
    float2 signs = float2(on_x ? -flip : (on_y ? 1.0 : flip), on_y ? flip : -1.0);
    float2 there = float2(on_x ? way.z : way.x, on_y ? way.z : way.y) * signs;
    float2 across = float2(on_x ? normal.z : normal.x, on_y ? normal.z : normal.y) * signs;
    float off_plane = normal.x * way.x + normal.y * way.y + normal.z * way.z;
    float rise = face.w / (off_plane == 0.0 ? 1.0e-30 : off_plane);  // as umbrage_receiver_slope
    float2 slope = across * rise;
    float i = 1.0 / max(abs(along), 1.0e-30);
    float z = face.z * i;
    float2 at = there * (face.x * i) + face.y;
    float steep = abs(slope.x) + abs(slope.y);
    float moves = rounding.x + rounding.y * i;
    float off = abs(z) * (moves + slack.y) + slack.z;  // a lens has no rounding.w
    float all = (moves * rounding.z + slack.x) * steep + off;
    return transpose(float4x4(float4(at, z + slack.w, number), float4(slope, 1.0, all), none, none));
}
#endif

#ifndef UMBRAGE_HAS_TETRAHEDRON_MAP_PLACES
#define UMBRAGE_HAS_TETRAHEDRON_MAP_PLACES
// umbrage_tetrahedron_map_places: place of a point of the world in a tetrahedron's map
//   to_texels, planes, rounding, slack   of umbrage_anchored_place, from a face's axes to texels of face 0, relative
//                                        to the center
//   anchor                               position of the light
//   center                               half the map's size in texels
//   returns (texels, texels, depth, 0.0), (slope, slope, weight, slack)
float4x4 umbrage_tetrahedron_map_places(float4x4 to_texels, float4x4 planes, float4 anchor, float4 rounding,
                                        float4 slack, float4 center, float4 terms, float3 world, float3 normal) {
    precise float3 way = world - float3(anchor.x, anchor.y, anchor.z);
    float face = umbrage_tetrahedron_face(way);
    float4x4 place =
        umbrage_anchored_place(to_texels, planes, rounding, slack, umbrage_tetrahedron_face_point(face, way),
                               umbrage_tetrahedron_face_point(face, normal));
    float2 at = umbrage_tetrahedron_turned(face, float2(transpose(place)[0].x, transpose(place)[0].y)) + center.x;
    float2 slope = umbrage_tetrahedron_turned(face, float2(transpose(place)[1].x, transpose(place)[1].y));
    return transpose(float4x4(float4(at, transpose(place)[0].z, 0.0),
                              float4(slope, transpose(place)[1].z, transpose(place)[1].w), transpose(place)[2],
                              transpose(place)[3]));
}
#endif

#ifndef UMBRAGE_HAS_TETRAHEDRON_SHAPE
#define UMBRAGE_HAS_TETRAHEDRON_SHAPE
// umbrage_tetrahedron_shape: shape of penumbras at a texel of a tetrahedron's map
//   center   x: half the map's size in texels
//   number   not read
//   at       place in the map, texels
//   returns factors of face 0's softness in x and y, and no shear
float3 umbrage_tetrahedron_shape(float4 center, float number, float2 at) {
    bool beside = abs(at.x - center.x) > abs(at.y - center.x);
    return beside ? float3(0.577350269, 1.73205081, 0.0) : float3(1.0, 1.0, 0.0);
}
#endif

#ifndef UMBRAGE_HAS_PARABOLOID_MAPS_PLACES
#define UMBRAGE_HAS_PARABOLOID_MAPS_PLACES
// umbrage_paraboloid_maps_places: place of a point of the world in two paraboloid maps
//   position   position of the light, and depth per world unit
//   halves     size of a paraboloid's image and its border in texels, slope of a depth per texel, depth at the light
//   rounding   error of a depth by rounding
//   returns (texels, texels, depth, number), (slope, slope, weight, slack)
float4x4 umbrage_paraboloid_maps_places(float4 position, float4 halves, float4 rounding, float4 terms, float3 world,
                                        float3 normal) {
    float4 none = float4(0.0, 0.0, 0.0, 0.0);
    precise float3 way = world - float3(position.x, position.y, position.z);
    float3 found = umbrage_dual_paraboloid_coordinate(way);
    precise float2 at = float2(found.x, found.y) * halves.x + halves.y;
    precise float depth = umbrage_distance_depth(way, position.w) + halves.w;
    float2 slope = umbrage_dual_paraboloid_slope(way, normal, halves.z);
    return transpose(float4x4(float4(at, depth, found.z), float4(slope, 1.0, rounding.x), none, none));
}
#endif

#ifndef UMBRAGE_HAS_PARABOLOID_VERTEX
#define UMBRAGE_HAS_PARABOLOID_VERTEX
// umbrage_paraboloid_vertex: clip space position of a vertex in a paraboloid map
//   to_clip    the light's projection
//   anchor     position of the light
//   number     0.0 or 1.0, the map
float4 umbrage_paraboloid_vertex(float4x4 to_clip, float3 world, float4 anchor, float number) {
    precise float3 way = world - float3(anchor.x, anchor.y, anchor.z);
    float4 p = umbrage_dual_paraboloid_position(way, number);
    precise float4 place = transpose(to_clip)[3] * p.w + transpose(to_clip)[0] * p.x + transpose(to_clip)[1] * p.y +
        transpose(to_clip)[2] * p.z;
    return place;
}
#endif

#ifndef UMBRAGE_HAS_WARPED_MAPS_CHOICE
#define UMBRAGE_HAS_WARPED_MAPS_CHOICE
// umbrage_warped_maps_choice: number of the warped cascade that holds a point of the world, and weight of the next one
//   fades    one column per map: scale and offset of the next one's weight
//   anchor   the one anchor of all maps
//   ahead    distance along the camera's axis: dot(ahead.xyz, world - anchor) + ahead.w
//   ends     ends of the first three cascades, number of the last one
float2 umbrage_warped_maps_choice(float4x4 fades, float4 anchor, float4 ahead, float4 ends, float3 world) {
    precise float3 way = world - float3(anchor.x, anchor.y, anchor.z);
    precise float depth = ahead.x * way.x + ahead.y * way.y + ahead.z * way.z + ahead.w;
    float number = umbrage_cascade_by_depth(depth, float3(ends.x, ends.y, ends.z));
    float4 own = umbrage_cascade_column(fades, number);
    return float2(number, umbrage_cascade_fade(depth, own.x, own.y));
}
#endif

#ifndef UMBRAGE_HAS_WARPED_MAPS_PLACE
#define UMBRAGE_HAS_WARPED_MAPS_PLACE
// umbrage_warped_maps_place: place of a point of the world in one of up to four warped cascades
//   to_texels_0 to planes_3   matrices of umbrage_anchored_place for each map
//   rounding, slack           one column per map: its rounding and slack there
//   fades, ahead              of umbrage_warped_maps_choice, not read
//   anchor                    the one anchor of all maps
//   ends                      w: number of the last cascade, after which the place is outside all maps, and lit
//   number                    number of the cascade
//   returns (texels, texels, depth, number), (slope, slope, weight, slack)
float4x4 umbrage_warped_maps_place(float4x4 to_texels_0, float4x4 to_texels_1, float4x4 to_texels_2,
                                   float4x4 to_texels_3, float4x4 planes_0, float4x4 planes_1, float4x4 planes_2,
                                   float4x4 planes_3, float4x4 rounding, float4x4 slack, float4x4 fades, float4 anchor,
                                   float4 ahead, float4 ends, float4 terms, float3 world, float3 normal, float number) {
    precise float3 way = world - float3(anchor.x, anchor.y, anchor.z);
    float own = min(number, ends.w);
    float4x4 to_texels = to_texels_0;
    float4x4 planes = planes_0;
    if (own > 0.5) {
        to_texels = to_texels_1;
        planes = planes_1;
    }
    if (own > 1.5) {
        to_texels = to_texels_2;
        planes = planes_2;
    }
    if (own > 2.5) {
        to_texels = to_texels_3;
        planes = planes_3;
    }
    float4x4 at =
        umbrage_anchored_place(to_texels, planes, umbrage_cascade_column(rounding, own),
                               umbrage_cascade_column(slack, own), way, normal);
    float x = number <= ends.w ? transpose(at)[0].x : -65536.0;
    return transpose(float4x4(float4(x, transpose(at)[0].y, transpose(at)[0].z, own), transpose(at)[1],
                              transpose(at)[2], transpose(at)[3]));
}
#endif

#ifndef UMBRAGE_HAS_ADAPTIVE_MAPS_PLACES
#define UMBRAGE_HAS_ADAPTIVE_MAPS_PLACES
// umbrage_adaptive_maps_places: place of a point of the world in the page that holds it
//   to_root              matrix from the world to 1.0 to 2.0 across the root page
//   planes               plane matrix in texels of the deepest level
//   cells_0 to cells_7   16 x 16 cells of that level, row by row, two in each number: first + 1024.0 second; a cell is
//                        slot + 64.0 (2^level - 1.0)
//   anchor               position that is subtracted from world
//   pages                size of a page and width of its gutter, in texels
//   slack                of a plane: texels of slope of the page and of the deepest level; depth, and depth there
//   returns (texels, texels, depth, number), (slope, slope, weight, slack)
float4x4 umbrage_adaptive_maps_places(float4x4 to_root, float4x4 planes, float4x4 cells_0, float4x4 cells_1,
                                      float4x4 cells_2, float4x4 cells_3, float4x4 cells_4, float4x4 cells_5,
                                      float4x4 cells_6, float4x4 cells_7, float4 anchor, float4 pages, float4 slack,
                                      float4 terms, float3 world, float3 normal) {
    float4 none = float4(0.0, 0.0, 0.0, 0.0);
    precise float3 way = world - float3(anchor.x, anchor.y, anchor.z);
    float4 in_root = umbrage_shadow_coordinate(to_root, way);
    bool inside = in_root.x >= 1.0 && in_root.x < 2.0 && in_root.y >= 1.0 && in_root.y < 2.0;
    float2 coord = inside ? float2(in_root.x, in_root.y) : float2(1.0, 1.0);
    float2 cell = floor(coord * 16.0 - 16.0);
    float right = floor(cell.x * 0.125);
    float column = cell.y * 2.0 + right;
    float4 a = umbrage_cascade_column_8(cells_0, cells_1, column);
    float4 b = umbrage_cascade_column_8(cells_2, cells_3, column - 8.0);
    float4 c = umbrage_cascade_column_8(cells_4, cells_5, column - 16.0);
    float4 d = umbrage_cascade_column_8(cells_6, cells_7, column - 24.0);
    float4 low = column < 7.5 ? a : b;
    float4 high = column < 23.5 ? c : d;
    float4 eight = column < 15.5 ? low : high;
    float along = cell.x - right * 8.0;
    float pair = floor(along * 0.5);
    float left_two = pair < 0.5 ? eight.x : eight.y;
    float right_two = pair < 2.5 ? eight.z : eight.w;
    float two = pair < 1.5 ? left_two : right_two;
    float second = floor(two * (1.0 / 1024.0));
    float code = along - pair * 2.0 < 0.5 ? two - second * 1024.0 : second;
    float before = floor(code * (1.0 / 64.0));
    float across = before + 1.0;
    float2 place = coord * across;
    float2 within = (place - floor(place)) * pages.x + pages.y;
    float2 at = inside ? within : float2(32768.0, 32768.0);
    float2 deepest = umbrage_receiver_slope(planes, normal, way);
    float larger = 16.0 / across;
    float steep = abs(deepest.x) + abs(deepest.y);
    float off = (slack.x * larger + slack.y) * steep + (slack.w * larger + slack.z);
    return transpose(float4x4(float4(at, in_root.z, code - before * 64.0), float4(deepest * larger, 1.0, off), none,
                              none));
}
#endif

#ifndef UMBRAGE_HAS_MAP_SOFTNESS
#define UMBRAGE_HAS_MAP_SOFTNESS
// umbrage_map_softness: one of eight pairs of a matrix, two a column, by its index, 0.0 to 7.0
float2 umbrage_map_softness(float4x4 eight, float number) {
    float column = floor(number * 0.5);
    float4 two = umbrage_cascade_column(eight, column);
    return number - 2.0 * column < 0.5 ? float2(two.x, two.y) : float2(two.z, two.w);
}
#endif

#ifndef UMBRAGE_HAS_WARP_SHAPE
#define UMBRAGE_HAS_WARP_SHAPE
// umbrage_warp_shape: shape of penumbras at a texel of a warped map
//   warps    one column per map: (change of w along both axes, shear, ratio) of its texel (0, 0)
//   number   number of the map
//   at       place in the map, texels
//   returns factors of the map's softness in x and y, and the shear
float3 umbrage_warp_shape(float4x4 warps, float number, float2 at) {
    float4 own = umbrage_cascade_column(warps, number);
    float2 a = float2(1.0 - at.x * own.x, own.z - at.x * own.y);
    float2 b = float2(-at.y * own.w * own.x, 1.0 - at.y * own.w * own.y);
    float area = abs(a.x * b.y - a.y * b.x);
    float rows = length(b);
    return float3(area / rows, rows, clamp(dot(a, b) / area, -8.0, 8.0));
}
#endif

#ifndef UMBRAGE_HAS_SHAPED_SOFTNESS
#define UMBRAGE_HAS_SHAPED_SOFTNESS
// umbrage_shaped_softness: softness of a place
//   softness   that of its map: (1/16 texel per distance code along x and y, min_radius, max_radius)
//   shape      factors in x and y, shear
float4 umbrage_shaped_softness(float4 softness, float3 shape) {
    float max_radius = softness.w / sqrt(1.0 + shape.z * shape.z);
    return float4(softness.x * shape.x, softness.y * shape.y, softness.z, max_radius);
}
#endif

#ifndef UMBRAGE_HAS_TEXEL
#define UMBRAGE_HAS_TEXEL
// umbrage_texel: value of a texel inside the map
//   map    texture with the texels; a sampler that reads them must filter by nearest
//   size   size of the map, in texels
//   texel  integers, (0, 0) is the first
float4 umbrage_texel(Texture2D<float4> map, float2 size, float2 texel) {
    return map.Load(int3(int2(texel), 0));
}
#endif

#ifndef UMBRAGE_HAS_PAGE_COORDINATE
#define UMBRAGE_HAS_PAGE_COORDINATE
// umbrage_page_coordinate: (x, y) of a receiver in an atlas page with its gutter, and (z, w) the page's first texel
//   table   page table, RGBA8, nearest filter
//   size    size of the table, in texels
//   coord   receiver position, 1.0 to 2.0 across the table without its border
//   page    side of a page, in texels
//   gutter  border around a page, in texels
float4 umbrage_page_coordinate(Texture2D<float4> table, float2 size, float2 coord, float page, float gutter) {
    // neither max changes a value; compilers cannot regroup sums across max and clamp
    float2 sides = max(size - 2.0, float2(1.0, 1.0));
    float2 before = max(size - 3.0, float2(0.0, 0.0));
    float2 cell = min(max(float2(0.0, 0.0), coord * sides - before), size - 1.0);
    int2 texel = (int2)cell;  // the first texel for a NaN
    float4 entry = umbrage_from_unorm(umbrage_texel(table, size, (float2)texel));
    float2 slot = float2(entry.x, entry.y);
    float across = entry.z + entry.w * 256.0;
    float2 within = clamp(frac(coord * across), float2(0.0, 0.0), float2(1.0, 1.0));
    float2 at = within * page + (across > 0.0 ? gutter : 32768.0);
    return float4(at, slot * (page + gutter * 2.0));
}
#endif

#ifndef UMBRAGE_HAS_CLEARED_DEPTH
#define UMBRAGE_HAS_CLEARED_DEPTH
// umbrage_cleared_depth: depth of the far plane
float umbrage_cleared_depth() {
    return 1.0;
}
#endif

#ifndef UMBRAGE_HAS_SATURATE
#define UMBRAGE_HAS_SATURATE
// umbrage_saturate: v clamped to [0, 1]; NaN becomes the far plane's depth
float umbrage_saturate(float v) {
    // not v > 0.0 ? v : 0.0: Mesa turns it into max(v, 0.0), and softpipe's max gives NaN for a signalling NaN
    return v > 0.0 && v < 1.0 ? v : (v >= 1.0 ? 1.0 : (v <= 0.0 ? 0.0 : umbrage_cleared_depth()));
}
#endif

#ifndef UMBRAGE_HAS_ENCODE_RG9
#define UMBRAGE_HAS_ENCODE_RG9
// umbrage_encode_rg9: two channels of a 9-bit depth code, integers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1]. NaN counts as far
float2 umbrage_encode_rg9(float depth) {
    float x = min(floor(umbrage_saturate(depth) * 512.0), 511.0);
    float high = floor(x * (1.0 / 256.0));
    return float2(x - high * 256.0, high * 128.0);
}
#endif

#ifndef UMBRAGE_HAS_ENCODE_RG10
#define UMBRAGE_HAS_ENCODE_RG10
// umbrage_encode_rg10: two channels of a 10-bit depth code, integers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1]. NaN counts as far
float2 umbrage_encode_rg10(float depth) {
    float x = min(floor(umbrage_saturate(depth) * 1024.0), 1023.0);
    float high = floor(x * (1.0 / 256.0));
    return float2(x - high * 256.0, high * 64.0);
}
#endif

#ifndef UMBRAGE_HAS_ENCODE_RG11
#define UMBRAGE_HAS_ENCODE_RG11
// umbrage_encode_rg11: two channels of a 11-bit depth code, integers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1]. NaN counts as far
float2 umbrage_encode_rg11(float depth) {
    float x = min(floor(umbrage_saturate(depth) * 2048.0), 2047.0);
    float high = floor(x * (1.0 / 256.0));
    return float2(x - high * 256.0, high * 32.0);
}
#endif

#ifndef UMBRAGE_HAS_ENCODE_RG12
#define UMBRAGE_HAS_ENCODE_RG12
// umbrage_encode_rg12: two channels of a 12-bit depth code, integers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1]. NaN counts as far
float2 umbrage_encode_rg12(float depth) {
    float x = min(floor(umbrage_saturate(depth) * 4096.0), 4095.0);
    float high = floor(x * (1.0 / 256.0));
    return float2(x - high * 256.0, high * 16.0);
}
#endif

#ifndef UMBRAGE_HAS_ENCODE_RG13
#define UMBRAGE_HAS_ENCODE_RG13
// umbrage_encode_rg13: two channels of a 13-bit depth code, integers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1]. NaN counts as far
float2 umbrage_encode_rg13(float depth) {
    float x = min(floor(umbrage_saturate(depth) * 8192.0), 8191.0);
    float high = floor(x * (1.0 / 256.0));
    return float2(x - high * 256.0, high * 8.0);
}
#endif

#ifndef UMBRAGE_HAS_ENCODE_RG14
#define UMBRAGE_HAS_ENCODE_RG14
// umbrage_encode_rg14: two channels of a 14-bit depth code, integers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1]. NaN counts as far
float2 umbrage_encode_rg14(float depth) {
    float x = min(floor(umbrage_saturate(depth) * 16384.0), 16383.0);
    float high = floor(x * (1.0 / 256.0));
    return float2(x - high * 256.0, high * 4.0);
}
#endif

#ifndef UMBRAGE_HAS_ENCODE_RG15
#define UMBRAGE_HAS_ENCODE_RG15
// umbrage_encode_rg15: two channels of a 15-bit depth code, integers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1]. NaN counts as far
float2 umbrage_encode_rg15(float depth) {
    float x = min(floor(umbrage_saturate(depth) * 32768.0), 32767.0);
    float high = floor(x * (1.0 / 256.0));
    return float2(x - high * 256.0, high * 2.0);
}
#endif

#ifndef UMBRAGE_HAS_ENCODE_RG16
#define UMBRAGE_HAS_ENCODE_RG16
// umbrage_encode_rg16: two channels of a 16-bit depth code, integers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1]. NaN counts as far
float2 umbrage_encode_rg16(float depth) {
    float x = min(floor(umbrage_saturate(depth) * 65536.0), 65535.0);
    float high = floor(x * (1.0 / 256.0));
    return float2(x - high * 256.0, high * 1.0);
}
#endif

#ifndef UMBRAGE_HAS_ENCODE_RGB24
#define UMBRAGE_HAS_ENCODE_RGB24
// umbrage_encode_rgb24: three channels of a depth, R most significant, integers 0..255 for umbrage_to_unorm
//   depth   clamped to [0, 1]. NaN counts as far
float3 umbrage_encode_rgb24(float depth) {
    float x = min(floor(umbrage_saturate(depth) * 16777216.0), 16777215.0);
    float high = floor(x * (1.0 / 65536.0));
    float rest = x - high * 65536.0;
    float middle = floor(rest * (1.0 / 256.0));
    return float3(high, middle, min(rest - middle * 256.0, 255.0));  // below already: no sum is regrouped across the min
}
#endif

#ifndef UMBRAGE_HAS_ENCODE_RGB10
#define UMBRAGE_HAS_ENCODE_RGB10
// umbrage_encode_rgb10: three channels of a depth, R most significant, integers 0..1023 for umbrage_to_unorm10
// The last four bits are the high ones of B, so a target cleared to white is at the far plane
//   depth   clamped to [0, 1]. NaN counts as far
float3 umbrage_encode_rgb10(float depth) {
    float x = min(floor(umbrage_saturate(depth) * 16777216.0), 16777215.0);
    float high = floor(x * (1.0 / 16384.0));
    float rest = x - high * 16384.0;
    float middle = floor(rest * (1.0 / 16.0));
    float low = min(rest - middle * 16.0, 15.0);  // below already: no sum is regrouped across the min
    return float3(high, middle, low * 64.0);
}
#endif

#ifndef UMBRAGE_HAS_ENCODE_R16
#define UMBRAGE_HAS_ENCODE_R16
// umbrage_encode_r16: 16-bit channel of a depth, an integer 0..65535 for umbrage_to_unorm16
//   depth   clamped to [0, 1]. NaN counts as far
float umbrage_encode_r16(float depth) {
    return min(floor(umbrage_saturate(depth) * 65536.0), 65535.0);
}
#endif

#ifndef UMBRAGE_HAS_WRITE_THREEJS_RGBA
#define UMBRAGE_HAS_WRITE_THREEJS_RGBA
// umbrage_write_threejs_rgba: RGBA of a depth, as in three.js r167 and later, values to write as they are
float4 umbrage_write_threejs_rgba(float depth) {
    float v = umbrage_saturate(depth);
    float x = v * 16777216.0;
    float whole = floor(x);
    float high = floor(whole * (1.0 / 65536.0));
    float rest = whole - high * 65536.0;
    float middle = floor(rest * (1.0 / 256.0));
    float low = rest - middle * 256.0;
    float4 c = float4(high * 0.00392156886, middle * 0.00392156886, low * 0.00392156886, x - whole);
    return v < 1.0 ? c : float4(1.0, 1.0, 1.0, 1.0);
}
#endif

#ifndef UMBRAGE_HAS_WRITE_THREEJS_RGB
#define UMBRAGE_HAS_WRITE_THREEJS_RGB
// umbrage_write_threejs_rgb: RGB of a depth, as in three.js r167 and later, values to write as they are
float3 umbrage_write_threejs_rgb(float depth) {
    float v = umbrage_saturate(depth);
    float x = v * 65536.0;
    float whole = floor(x);
    float high = floor(whole * (1.0 / 256.0));
    float3 c = float3(high * 0.00392156886, (whole - high * 256.0) * 0.00392156886, x - whole);
    return v < 1.0 ? c : float3(1.0, 1.0, 1.0);
}
#endif

#ifndef UMBRAGE_HAS_WRITE_THREEJS_RG
#define UMBRAGE_HAS_WRITE_THREEJS_RG
// umbrage_write_threejs_rg: RG of a depth, as in three.js r167 and later, values to write as they are
float2 umbrage_write_threejs_rg(float depth) {
    float v = umbrage_saturate(depth);
    float x = v * 256.0;
    float whole = floor(x);
    return v < 1.0 ? float2(whole * 0.00392156886, x - whole) : float2(1.0, 1.0);
}
#endif

#ifndef UMBRAGE_HAS_WRITE_THREEJS_LEGACY
#define UMBRAGE_HAS_WRITE_THREEJS_LEGACY
// umbrage_write_threejs_legacy: RGBA of a depth, as in three.js r73 to r166, values to write as they are
//   1.0 reads back as 255/256. umbrage_encode_threejs_legacy_repaired does not have this fault
float4 umbrage_write_threejs_legacy(float depth) {
    float v = umbrage_saturate(depth);
    float x = v * 16777216.0 - floor(v * 16777216.0);
    float y = v * 65536.0 - floor(v * 65536.0);
    float z = v * 256.0 - floor(v * 256.0);
    precise float4 c = float4(x, y - x * (1.0 / 256.0), z - y * (1.0 / 256.0), v - z * (1.0 / 256.0));
    return c * 1.00392163;
}
#endif

#ifndef UMBRAGE_HAS_ENCODE_THREEJS_LEGACY_REPAIRED
#define UMBRAGE_HAS_ENCODE_THREEJS_LEGACY_REPAIRED
// umbrage_encode_threejs_legacy_repaired: channels of a depth for readers of three.js r73 to r166. 1.0 decodes to 1.0
//   Returns integers 0..255 (umbrage_to_unorm writes them)
float4 umbrage_encode_threejs_legacy_repaired(float depth) {
    float v = umbrage_saturate(depth);
    float x = floor(v * 16777216.0);
    float high = floor(x * (1.0 / 65536.0));
    float rest = x - high * 65536.0;
    float middle = floor(rest * (1.0 / 256.0));
    float low = min(rest - middle * 256.0, 255.0);  // below already: no sum is regrouped across the min
    return v < 1.0 ? float4(0.0, low, middle, high) : float4(255.0, 255.0, 255.0, 255.0);
}
#endif

#ifndef UMBRAGE_HAS_WRITE_BASE255
#define UMBRAGE_HAS_WRITE_BASE255
// umbrage_write_base255: base-255 RGBA of a depth, values to write as they are. The store must round
// 1.0 reads back as 0.0. umbrage_encode_base255_repaired has neither fault
float4 umbrage_write_base255(float depth) {
    float v = umbrage_saturate(depth);
    precise float4 e = float4(v, v * 255.0, v * 65025.0, v * 16581375.0);
    e = e - floor(e);
    precise float4 c = float4(e.x - e.y * 0.00392156886, e.y - e.z * 0.00392156886, e.z - e.w * 0.00392156886, e.w);
    return c;
}
#endif

#ifndef UMBRAGE_HAS_ENCODE_BASE255_REPAIRED
#define UMBRAGE_HAS_ENCODE_BASE255_REPAIRED
// umbrage_encode_base255_repaired: channels of a depth for readers of base-255 RGBA. 1.0 decodes to 1.0
//   Returns integers 0..255 (umbrage_to_unorm writes them)
float4 umbrage_encode_base255_repaired(float depth) {
    precise float x = umbrage_saturate(depth) * 255.0;
    precise float y = (x - floor(x)) * 255.0;
    precise float z = (y - floor(y)) * 255.0;
    precise float w = (z - floor(z)) * 255.0;
    return float4(floor(x), floor(y), floor(z), floor(w));
}
#endif

#ifndef UMBRAGE_HAS_FETCH_CLAMPED
#define UMBRAGE_HAS_FETCH_CLAMPED
// umbrage_fetch_clamped: texel of a map, or the nearest one inside for coordinates outside
float4 umbrage_fetch_clamped(Texture2D<float4> map, float2 size, float2 texel) {
    return umbrage_texel(map, size, clamp(texel, float2(0.0, 0.0), size - 1.0));
}
#endif

#ifndef UMBRAGE_HAS_ENCODE_RG9_TABLE
#define UMBRAGE_HAS_ENCODE_RG9_TABLE
// umbrage_encode_rg9_table: two channels of a 9-bit depth code through a lookup table, integers 0..255
//   table   512 x 1 texels, row after row, nearest filter
//   depth   clamped to [0, 1]. NaN counts as far
float2 umbrage_encode_rg9_table(Texture2D<float4> table, float depth) {
    float x = min(floor(umbrage_saturate(depth) * 512.0), 511.0);
    float row = floor(x * (1.0 / 512.0));
    float2 texel = float2(x - row * 512.0, row);
    float4 k = umbrage_from_unorm(umbrage_fetch_clamped(table, float2(512.0, 1.0), texel));
    return float2(k.x, k.y);
}
#endif

#ifndef UMBRAGE_HAS_ENCODE_RG10_TABLE
#define UMBRAGE_HAS_ENCODE_RG10_TABLE
// umbrage_encode_rg10_table: two channels of a 10-bit depth code through a lookup table, integers 0..255
//   table   1024 x 1 texels, row after row, nearest filter
//   depth   clamped to [0, 1]. NaN counts as far
float2 umbrage_encode_rg10_table(Texture2D<float4> table, float depth) {
    float x = min(floor(umbrage_saturate(depth) * 1024.0), 1023.0);
    float row = floor(x * (1.0 / 1024.0));
    float2 texel = float2(x - row * 1024.0, row);
    float4 k = umbrage_from_unorm(umbrage_fetch_clamped(table, float2(1024.0, 1.0), texel));
    return float2(k.x, k.y);
}
#endif

#ifndef UMBRAGE_HAS_ENCODE_RG11_TABLE
#define UMBRAGE_HAS_ENCODE_RG11_TABLE
// umbrage_encode_rg11_table: two channels of a 11-bit depth code through a lookup table, integers 0..255
//   table   2048 x 1 texels, row after row, nearest filter
//   depth   clamped to [0, 1]. NaN counts as far
float2 umbrage_encode_rg11_table(Texture2D<float4> table, float depth) {
    float x = min(floor(umbrage_saturate(depth) * 2048.0), 2047.0);
    float row = floor(x * (1.0 / 2048.0));
    float2 texel = float2(x - row * 2048.0, row);
    float4 k = umbrage_from_unorm(umbrage_fetch_clamped(table, float2(2048.0, 1.0), texel));
    return float2(k.x, k.y);
}
#endif

#ifndef UMBRAGE_HAS_ENCODE_RG12_TABLE
#define UMBRAGE_HAS_ENCODE_RG12_TABLE
// umbrage_encode_rg12_table: two channels of a 12-bit depth code through a lookup table, integers 0..255
//   table   2048 x 2 texels, row after row, nearest filter
//   depth   clamped to [0, 1]. NaN counts as far
float2 umbrage_encode_rg12_table(Texture2D<float4> table, float depth) {
    float x = min(floor(umbrage_saturate(depth) * 4096.0), 4095.0);
    float row = floor(x * (1.0 / 2048.0));
    float2 texel = float2(x - row * 2048.0, row);
    float4 k = umbrage_from_unorm(umbrage_fetch_clamped(table, float2(2048.0, 2.0), texel));
    return float2(k.x, k.y);
}
#endif

#ifndef UMBRAGE_HAS_ENCODE_RG13_TABLE
#define UMBRAGE_HAS_ENCODE_RG13_TABLE
// umbrage_encode_rg13_table: two channels of a 13-bit depth code through a lookup table, integers 0..255
//   table   2048 x 4 texels, row after row, nearest filter
//   depth   clamped to [0, 1]. NaN counts as far
float2 umbrage_encode_rg13_table(Texture2D<float4> table, float depth) {
    float x = min(floor(umbrage_saturate(depth) * 8192.0), 8191.0);
    float row = floor(x * (1.0 / 2048.0));
    float2 texel = float2(x - row * 2048.0, row);
    float4 k = umbrage_from_unorm(umbrage_fetch_clamped(table, float2(2048.0, 4.0), texel));
    return float2(k.x, k.y);
}
#endif

#ifndef UMBRAGE_HAS_ENCODE_RG14_TABLE
#define UMBRAGE_HAS_ENCODE_RG14_TABLE
// umbrage_encode_rg14_table: two channels of a 14-bit depth code through a lookup table, integers 0..255
//   table   2048 x 8 texels, row after row, nearest filter
//   depth   clamped to [0, 1]. NaN counts as far
float2 umbrage_encode_rg14_table(Texture2D<float4> table, float depth) {
    float x = min(floor(umbrage_saturate(depth) * 16384.0), 16383.0);
    float row = floor(x * (1.0 / 2048.0));
    float2 texel = float2(x - row * 2048.0, row);
    float4 k = umbrage_from_unorm(umbrage_fetch_clamped(table, float2(2048.0, 8.0), texel));
    return float2(k.x, k.y);
}
#endif

#ifndef UMBRAGE_HAS_ENCODE_RG15_TABLE
#define UMBRAGE_HAS_ENCODE_RG15_TABLE
// umbrage_encode_rg15_table: two channels of a 15-bit depth code through a lookup table, integers 0..255
//   table   2048 x 16 texels, row after row, nearest filter
//   depth   clamped to [0, 1]. NaN counts as far
float2 umbrage_encode_rg15_table(Texture2D<float4> table, float depth) {
    float x = min(floor(umbrage_saturate(depth) * 32768.0), 32767.0);
    float row = floor(x * (1.0 / 2048.0));
    float2 texel = float2(x - row * 2048.0, row);
    float4 k = umbrage_from_unorm(umbrage_fetch_clamped(table, float2(2048.0, 16.0), texel));
    return float2(k.x, k.y);
}
#endif

#ifndef UMBRAGE_HAS_ENCODE_RG16_TABLE
#define UMBRAGE_HAS_ENCODE_RG16_TABLE
// umbrage_encode_rg16_table: two channels of a 16-bit depth code through a lookup table, integers 0..255
//   table   2048 x 32 texels, row after row, nearest filter
//   depth   clamped to [0, 1]. NaN counts as far
float2 umbrage_encode_rg16_table(Texture2D<float4> table, float depth) {
    float x = min(floor(umbrage_saturate(depth) * 65536.0), 65535.0);
    float row = floor(x * (1.0 / 2048.0));
    float2 texel = float2(x - row * 2048.0, row);
    float4 k = umbrage_from_unorm(umbrage_fetch_clamped(table, float2(2048.0, 32.0), texel));
    return float2(k.x, k.y);
}
#endif

#ifndef UMBRAGE_HAS_DECODE_FLOAT_BITS
#define UMBRAGE_HAS_DECODE_FLOAT_BITS
// umbrage_decode_float_bits: float from the four channels of its bit pattern, as sampled, R least significant
float umbrage_decode_float_bits(float4 c) {
    uint r = uint(umbrage_saturate(c.x) * 255.0 + 0.5);
    uint g = uint(umbrage_saturate(c.y) * 255.0 + 0.5);
    uint b = uint(umbrage_saturate(c.z) * 255.0 + 0.5);
    uint a = uint(umbrage_saturate(c.w) * 255.0 + 0.5);
    return asfloat(r | (g << 8) | (b << 16) | (a << 24));
}
#endif

#ifndef UMBRAGE_HAS_TEXEL_INSIDE
#define UMBRAGE_HAS_TEXEL_INSIDE
// umbrage_texel_inside: texel of the map, itself if the map has it; otherwise any, whose value does not count
float2 umbrage_texel_inside(float2 size, float2 texel) {
    return min(abs(texel), size - 1.0);
}
#endif

#ifndef UMBRAGE_HAS_FETCH_BORDERED
#define UMBRAGE_HAS_FETCH_BORDERED
// umbrage_fetch_bordered: texel of a map, or border outside it
float4 umbrage_fetch_bordered(Texture2D<float4> map, float2 size, float2 texel, float4 border) {
    float2 at = umbrage_texel_inside(size, texel);
    float4 value = umbrage_texel(map, size, at);
    return at.x == texel.x && at.y == texel.y ? value : border;
}
#endif

#ifndef UMBRAGE_HAS_FETCH_DEPTH
#define UMBRAGE_HAS_FETCH_DEPTH
// umbrage_fetch_depth: stored depth of a texel, or the far plane's depth outside the map
float umbrage_fetch_depth(Texture2D<float4> map, float2 size, float2 texel) {
    float2 inside = umbrage_texel_inside(size, texel);
    float4 value = umbrage_texel(map, size, inside);
    float depth = value.x;
    return inside.x == texel.x && inside.y == texel.y ? depth : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_DEPTH_AT
#define UMBRAGE_HAS_DEPTH_AT
// umbrage_depth_at: stored depth of the texel at a point; on a border it may be the neighbor's
//   uv  point on the map, (0.0, 0.0) to (1.0, 1.0), no NaN
float umbrage_depth_at(Texture2D<float4> map, float2 size, float2 uv) {
    return umbrage_fetch_depth(map, size, floor(uv * size));
}
#endif

#ifndef UMBRAGE_HAS_BEYOND_FAR_PLANE
#define UMBRAGE_HAS_BEYOND_FAR_PLANE
// umbrage_beyond_far_plane: true if a receiver is beyond the far plane
precise bool umbrage_beyond_far_plane(float receiver) {
    return receiver > 1.0;
}
#endif

#ifndef UMBRAGE_HAS_IN_FILTER_DOMAIN
#define UMBRAGE_HAS_IN_FILTER_DOMAIN
// umbrage_in_filter_domain: true if a filter compares; lit outside texel space and beyond the far plane
precise bool umbrage_in_filter_domain(float2 coord, float receiver) {
    // a choice, not a && !b: FXC turns !(receiver > 1.0) into receiver <= 1.0, which loses a NaN
    return umbrage_beyond_far_plane(receiver) ? false : umbrage_inside_texel_space(coord);
}
#endif

#ifndef UMBRAGE_HAS_COMPARE
#define UMBRAGE_HAS_COMPARE
// umbrage_compare: 1.0 when the receiver is no farther than the stored depth
float umbrage_compare(float receiver, float stored) {
    return receiver <= stored ? 1.0 : 0.0;
}
#endif

#ifndef UMBRAGE_HAS_LIT
#define UMBRAGE_HAS_LIT
// umbrage_lit: visibility from one comparison with a texel
float umbrage_lit(Texture2D<float4> map, float2 size, float2 texel, float receiver) {
    return umbrage_compare(receiver, umbrage_fetch_depth(map, size, texel));
}
#endif

#ifndef UMBRAGE_HAS_LIT_2X2
#define UMBRAGE_HAS_LIT_2X2
// umbrage_lit_2x2: visibility from the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1)
float4 umbrage_lit_2x2(Texture2D<float4> map, float2 size, float2 texel, float receiver) {
    float a = umbrage_lit(map, size, texel, receiver);
    float b = umbrage_lit(map, size, texel + float2(1.0, 0.0), receiver);
    float c = umbrage_lit(map, size, texel + float2(0.0, 1.0), receiver);
    float d = umbrage_lit(map, size, texel + float2(1.0, 1.0), receiver);
    return float4(a, b, c, d);
}
#endif

#ifndef UMBRAGE_HAS_MAP_COVERS
#define UMBRAGE_HAS_MAP_COVERS
// umbrage_map_covers: true if a receiver lies in a prefiltered map or a table; elsewhere it is lit
precise bool umbrage_map_covers(float2 size, float2 coord) {
    return coord.x >= 0.0 && coord.y >= 0.0 && coord.x < size.x && coord.y < size.y;
}
#endif

#ifndef UMBRAGE_HAS_WITHIN_FAR_PLANE
#define UMBRAGE_HAS_WITHIN_FAR_PLANE
// umbrage_within_far_plane: true if a receiver is a number and not beyond the far plane
precise bool umbrage_within_far_plane(float receiver) {
    return receiver <= 1.0;
}
#endif

#ifndef UMBRAGE_HAS_WINDOW_SUM3
#define UMBRAGE_HAS_WINDOW_SUM3
// umbrage_window_sum3: weighted count of the lit texels under a kernel that slides over the map, an integer
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   steps       per texel, a power of two up to 256
//   k0 .. k1    weights from the edge to the middle one. The others mirror them
// Steps times the sum of all weights must be an integer up to 4096. Its square is the count when all is lit
float umbrage_window_sum3(Texture2D<float4> map, float2 size, float2 coord, float receiver, float steps, float k0,
                          float k1) {
    bool compared = umbrage_in_filter_domain(coord, receiver);  // no branch: fetches overlap
    float2 x = compared ? floor(coord * 256.0) - 128.0 : float2(0.0, 0.0);
    float2 texel = floor(x * (1.0 / 256.0));
    float2 s = floor((x - texel * 256.0) * (1.0 / 256.0) * steps);
    float2 r = steps - s;
    float whole = steps * (k0 + k1 + k0);
    float2 w0 = floor(r * k0);
    float2 w2 = floor(r * k0 + s * k1);
    float2 w3 = floor(s * k0);
    float2 w1 = max(whole - (w0 + w2 + w3), float2(0.0, 0.0));
    float2 first = texel - 1.0;
    float n = 0.0;
    float4 a = umbrage_lit_2x2(map, size, first + float2(0.0, 0.0), receiver);
    float4 b = umbrage_lit_2x2(map, size, first + float2(2.0, 0.0), receiver);
    n += w0.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y);
    n += w1.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w);
    a = umbrage_lit_2x2(map, size, first + float2(0.0, 2.0), receiver);
    b = umbrage_lit_2x2(map, size, first + float2(2.0, 2.0), receiver);
    n += w2.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y);
    n += w3.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w);
    return compared ? n : whole * whole;
}
#endif

#ifndef UMBRAGE_HAS_WINDOW_SUM5
#define UMBRAGE_HAS_WINDOW_SUM5
// umbrage_window_sum5: weighted count of the lit texels under a kernel that slides over the map, an integer
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   steps       per texel, a power of two up to 256
//   k0 .. k2    weights from the edge to the middle one. The others mirror them
// Steps times the sum of all weights must be an integer up to 4096. Its square is the count when all is lit
float umbrage_window_sum5(Texture2D<float4> map, float2 size, float2 coord, float receiver, float steps, float k0,
                          float k1, float k2) {
    bool compared = umbrage_in_filter_domain(coord, receiver);  // no branch: fetches overlap
    float2 x = compared ? floor(coord * 256.0) - 128.0 : float2(0.0, 0.0);
    float2 texel = floor(x * (1.0 / 256.0));
    float2 s = floor((x - texel * 256.0) * (1.0 / 256.0) * steps);
    float2 r = steps - s;
    float whole = steps * (k0 + k1 + k2 + k1 + k0);
    float2 w0 = floor(r * k0);
    float2 w1 = floor(r * k1 + s * k0);
    float2 w3 = floor(r * k1 + s * k2);
    float2 w4 = floor(r * k0 + s * k1);
    float2 w5 = floor(s * k0);
    float2 w2 = max(whole - (w0 + w1 + w3 + w4 + w5), float2(0.0, 0.0));
    float2 first = texel - 2.0;
    float n = 0.0;
    float4 a = umbrage_lit_2x2(map, size, first + float2(0.0, 0.0), receiver);
    float4 b = umbrage_lit_2x2(map, size, first + float2(2.0, 0.0), receiver);
    float4 c = umbrage_lit_2x2(map, size, first + float2(4.0, 0.0), receiver);
    n += w0.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y);
    n += w1.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w);
    a = umbrage_lit_2x2(map, size, first + float2(0.0, 2.0), receiver);
    b = umbrage_lit_2x2(map, size, first + float2(2.0, 2.0), receiver);
    c = umbrage_lit_2x2(map, size, first + float2(4.0, 2.0), receiver);
    n += w2.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y);
    n += w3.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w);
    a = umbrage_lit_2x2(map, size, first + float2(0.0, 4.0), receiver);
    b = umbrage_lit_2x2(map, size, first + float2(2.0, 4.0), receiver);
    c = umbrage_lit_2x2(map, size, first + float2(4.0, 4.0), receiver);
    n += w4.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y);
    n += w5.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w);
    return compared ? n : whole * whole;
}
#endif

#ifndef UMBRAGE_HAS_WINDOW_SUM7
#define UMBRAGE_HAS_WINDOW_SUM7
// umbrage_window_sum7: weighted count of the lit texels under a kernel that slides over the map, an integer
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   steps       per texel, a power of two up to 256
//   k0 .. k3    weights from the edge to the middle one. The others mirror them
// Steps times the sum of all weights must be an integer up to 4096. Its square is the count when all is lit
float umbrage_window_sum7(Texture2D<float4> map, float2 size, float2 coord, float receiver, float steps, float k0,
                          float k1, float k2, float k3) {
    bool compared = umbrage_in_filter_domain(coord, receiver);  // no branch: fetches overlap
    float2 x = compared ? floor(coord * 256.0) - 128.0 : float2(0.0, 0.0);
    float2 texel = floor(x * (1.0 / 256.0));
    float2 s = floor((x - texel * 256.0) * (1.0 / 256.0) * steps);
    float2 r = steps - s;
    float whole = steps * (k0 + k1 + k2 + k3 + k2 + k1 + k0);
    float2 w0 = floor(r * k0);
    float2 w1 = floor(r * k1 + s * k0);
    float2 w2 = floor(r * k2 + s * k1);
    float2 w4 = floor(r * k2 + s * k3);
    float2 w5 = floor(r * k1 + s * k2);
    float2 w6 = floor(r * k0 + s * k1);
    float2 w7 = floor(s * k0);
    float2 w3 = max(whole - (w0 + w1 + w2 + w4 + w5 + w6 + w7), float2(0.0, 0.0));
    float2 first = texel - 3.0;
    float n = 0.0;
    float4 a = umbrage_lit_2x2(map, size, first + float2(0.0, 0.0), receiver);
    float4 b = umbrage_lit_2x2(map, size, first + float2(2.0, 0.0), receiver);
    float4 c = umbrage_lit_2x2(map, size, first + float2(4.0, 0.0), receiver);
    float4 d = umbrage_lit_2x2(map, size, first + float2(6.0, 0.0), receiver);
    n += w0.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y + w6.x * d.x + w7.x * d.y);
    n += w1.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w + w6.x * d.z + w7.x * d.w);
    a = umbrage_lit_2x2(map, size, first + float2(0.0, 2.0), receiver);
    b = umbrage_lit_2x2(map, size, first + float2(2.0, 2.0), receiver);
    c = umbrage_lit_2x2(map, size, first + float2(4.0, 2.0), receiver);
    d = umbrage_lit_2x2(map, size, first + float2(6.0, 2.0), receiver);
    n += w2.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y + w6.x * d.x + w7.x * d.y);
    n += w3.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w + w6.x * d.z + w7.x * d.w);
    a = umbrage_lit_2x2(map, size, first + float2(0.0, 4.0), receiver);
    b = umbrage_lit_2x2(map, size, first + float2(2.0, 4.0), receiver);
    c = umbrage_lit_2x2(map, size, first + float2(4.0, 4.0), receiver);
    d = umbrage_lit_2x2(map, size, first + float2(6.0, 4.0), receiver);
    n += w4.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y + w6.x * d.x + w7.x * d.y);
    n += w5.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w + w6.x * d.z + w7.x * d.w);
    a = umbrage_lit_2x2(map, size, first + float2(0.0, 6.0), receiver);
    b = umbrage_lit_2x2(map, size, first + float2(2.0, 6.0), receiver);
    c = umbrage_lit_2x2(map, size, first + float2(4.0, 6.0), receiver);
    d = umbrage_lit_2x2(map, size, first + float2(6.0, 6.0), receiver);
    n += w6.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y + w6.x * d.x + w7.x * d.y);
    n += w7.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w + w6.x * d.z + w7.x * d.w);
    return compared ? n : whole * whole;
}
#endif

#ifndef UMBRAGE_HAS_ELLIPSE8
#define UMBRAGE_HAS_ELLIPSE8
// umbrage_ellipse8: PCF over a rotated ellipse of 8 points. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      along x and y, in 1/16 texel, integers from 0 to 4095
//   rotation    umbrage_disc_rotation of the pixel
float umbrage_ellipse8(Texture2D<float4> map, float2 size, float2 coord, float receiver, float2 radius,
                       float4 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 at = compared ? floor(coord * 256.0) : float2(0.0, 0.0);  // no branch: fetches overlap
    float n = 0.0;
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(3.0, -1.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-4.0, 5.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(1.0, -11.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-9.0, -8.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-12.0, 3.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(11.0, 6.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(0.0, 13.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(11.0, -7.0), rotation, radius), receiver);
    return compared ? n * (1.0 / 8.0) : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_ELLIPSE16
#define UMBRAGE_HAS_ELLIPSE16
// umbrage_ellipse16: PCF over a rotated ellipse of 16 points. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      along x and y, in 1/16 texel, integers from 0 to 4095
//   rotation    umbrage_disc_rotation of the pixel
float umbrage_ellipse16(Texture2D<float4> map, float2 size, float2 coord, float receiver, float2 radius,
                        float4 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 at = compared ? floor(coord * 256.0) : float2(0.0, 0.0);  // no branch: fetches overlap
    float n = 0.0;
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(1.0, -3.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(5.0, 2.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-5.0, 2.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(0.0, 7.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-6.0, -5.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(8.0, -5.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(0.0, -11.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(11.0, 5.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-12.0, 4.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-1.0, 13.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(7.0, 11.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-9.0, 10.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-13.0, -4.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(7.0, -12.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-7.0, -12.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(14.0, -2.0), rotation, radius), receiver);
    return compared ? n * (1.0 / 16.0) : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_ELLIPSE32
#define UMBRAGE_HAS_ELLIPSE32
// umbrage_ellipse32: PCF over a rotated ellipse of 32 points. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      along x and y, in 1/16 texel, integers from 0 to 4095
//   rotation    umbrage_disc_rotation of the pixel
float umbrage_ellipse32(Texture2D<float4> map, float2 size, float2 coord, float receiver, float2 radius,
                        float4 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 at = compared ? floor(coord * 256.0) : float2(0.0, 0.0);  // no branch: fetches overlap
    float n = 0.0;
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-2.0, -1.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(3.0, 2.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(1.0, -4.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-4.0, 3.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(0.0, 6.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-5.0, -5.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(7.0, -2.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-8.0, -1.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(8.0, 3.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(5.0, 7.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(1.0, -9.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(6.0, -7.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-8.0, 5.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(0.0, 10.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-3.0, -10.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-6.0, 10.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-9.0, -8.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(11.0, -5.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(5.0, -12.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-13.0, -1.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(7.0, 11.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(13.0, 3.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-13.0, 4.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(10.0, -10.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(14.0, -2.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-11.0, 9.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(3.0, 14.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-13.0, -6.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(12.0, 8.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-4.0, 14.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(-7.0, -13.0), rotation, radius), receiver);
    n += umbrage_lit(map, size, umbrage_disc_tap(at, float2(0.0, -15.0), rotation, radius), receiver);
    return compared ? n * (1.0 / 32.0) : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_DISC8
#define UMBRAGE_HAS_DISC8
// umbrage_disc8: PCF over a rotated disc of 8 points. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
float umbrage_disc8(Texture2D<float4> map, float2 size, float2 coord, float receiver, float radius, float4 rotation) {
    float rho = umbrage_disc_radius(radius);
    return umbrage_ellipse8(map, size, coord, receiver, float2(rho, rho), rotation);
}
#endif

#ifndef UMBRAGE_HAS_DISC16
#define UMBRAGE_HAS_DISC16
// umbrage_disc16: PCF over a rotated disc of 16 points. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
float umbrage_disc16(Texture2D<float4> map, float2 size, float2 coord, float receiver, float radius, float4 rotation) {
    float rho = umbrage_disc_radius(radius);
    return umbrage_ellipse16(map, size, coord, receiver, float2(rho, rho), rotation);
}
#endif

#ifndef UMBRAGE_HAS_DISC32
#define UMBRAGE_HAS_DISC32
// umbrage_disc32: PCF over a rotated disc of 32 points. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
float umbrage_disc32(Texture2D<float4> map, float2 size, float2 coord, float receiver, float radius, float4 rotation) {
    float rho = umbrage_disc_radius(radius);
    return umbrage_ellipse32(map, size, coord, receiver, float2(rho, rho), rotation);
}
#endif

#ifndef UMBRAGE_HAS_HARD
#define UMBRAGE_HAS_HARD
// umbrage_hard: shadow test without a filter. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
float umbrage_hard(Texture2D<float4> map, float2 size, float2 coord, float receiver) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 texel = compared ? floor(coord) : float2(0.0, 0.0);  // no branch: fetches of several taps overlap
    float lit = umbrage_lit(map, size, texel, receiver);
    return compared ? lit : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_FOUR_TAP
#define UMBRAGE_HAS_FOUR_TAP
// umbrage_four_tap: mean of the shadow test at four taps. Returns visibility, 1.0 = lit
//   map, size    shadow map and its size in texels
//   a, b, c, d   taps in texels. All are lit where their mean magnitude is 2^15 or more along an axis
//   receiver     receiver depth in [0, 1], bias applied
float umbrage_four_tap(Texture2D<float4> map, float2 size, float2 a, float2 b, float2 c, float2 d, float receiver) {
    float2 a_texel = floor(a);
    float2 b_texel = floor(b);
    float2 c_texel = floor(c);
    float2 d_texel = floor(d);
    float2 sum = abs(a_texel) + abs(b_texel) + abs(c_texel) + abs(d_texel);
    // two different limits on purpose: Mesa turns a single one into max(x, y) < limit, which loses a NaN
    bool compared = umbrage_beyond_far_plane(receiver) ? false : sum.x < 131072.0 && sum.y * 2.0 < 262144.0;
    float count = umbrage_lit(map, size, a_texel, receiver) + umbrage_lit(map, size, b_texel, receiver) +
        umbrage_lit(map, size, c_texel, receiver) + umbrage_lit(map, size, d_texel, receiver);
    return compared ? count * 0.25 : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_PCF_2X2
#define UMBRAGE_HAS_PCF_2X2
// umbrage_pcf_2x2: bilinear 2x2 PCF. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
float umbrage_pcf_2x2(Texture2D<float4> map, float2 size, float2 coord, float receiver) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 x = compared ? floor(coord * 256.0) - 128.0 : float2(0.0, 0.0);  // no branch: fetches overlap
    float2 texel = floor(x * (1.0 / 256.0));
    // weights are in [0, 1) already. The clamp keeps compilers from regrouping sums across it
    float2 hi = clamp(x * (1.0 / 256.0) - texel, float2(0.0, 0.0), float2(1.0, 1.0));
    float2 lo = 1.0 - hi;
    float4 lit = umbrage_lit_2x2(map, size, texel, receiver);
    float visibility = lo.y * (lo.x * lit.x + hi.x * lit.y) + hi.y * (lo.x * lit.z + hi.x * lit.w);
    return compared ? visibility : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_PCF_2X2_DX_SDK
#define UMBRAGE_HAS_PCF_2X2_DX_SDK
// umbrage_pcf_2x2_dx_sdk: 2x2 PCF of the DirectX SDK sample. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], no bias applied
//   epsilon     depth added to each stored depth
float umbrage_pcf_2x2_dx_sdk(Texture2D<float4> map, float2 size, float2 coord, float receiver, float epsilon) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    precise float2 x = compared ? coord - 0.5 : float2(0.0, 0.0);  // no branch: fetches overlap
    float2 texel = floor(x);
    precise float2 weight = x - texel;
    float a = umbrage_compare_dx_sdk(receiver, umbrage_fetch_depth(map, size, texel), epsilon);
    float right = umbrage_fetch_depth(map, size, texel + float2(1.0, 0.0));
    float above = umbrage_fetch_depth(map, size, texel + float2(0.0, 1.0));
    float beyond = umbrage_fetch_depth(map, size, texel + float2(1.0, 1.0));
    float b = umbrage_compare_dx_sdk(receiver, right, epsilon);
    float c = umbrage_compare_dx_sdk(receiver, above, epsilon);
    float d = umbrage_compare_dx_sdk(receiver, beyond, epsilon);
    precise float low = a + weight.x * (b - a);
    precise float high = c + weight.x * (d - c);
    precise float visibility = low + weight.y * (high - low);
    return compared ? visibility : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_BOX_COUNT
#define UMBRAGE_HAS_BOX_COUNT
// umbrage_box_count: number of lit texels in the (2r+1) x (2r+1) box around the receiver's texel, an integer
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      r, clamped to 0..8. Compilers unroll the loops if it is a constant
float umbrage_box_count(Texture2D<float4> map, float2 size, float2 coord, float receiver, int radius) {
    int r = radius < 0 ? 0 : (radius < 8 ? radius : 8);
    int width = 2 * r + 1;
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 first = compared ? floor(coord) - float(r) : float2(0.0, 0.0);
    float count = 0.0;
    for (int j = 0; j < 17; j++) {
        if (j >= width) break;
        for (int i = 0; i < 17; i++) {
            if (i >= width) break;
            count += umbrage_lit(map, size, first + float2(float(i), float(j)), receiver);
        }
    }
    return compared ? count : float(width * width);
}
#endif

#ifndef UMBRAGE_HAS_BOX
#define UMBRAGE_HAS_BOX
// umbrage_box: box PCF, the lit fraction of a (2r+1) x (2r+1) box. Returns visibility, 1.0 = lit
//   parameters as for umbrage_box_count
float umbrage_box(Texture2D<float4> map, float2 size, float2 coord, float receiver, int radius) {
    float visibility = umbrage_box_count(map, size, coord, receiver, radius) * umbrage_box_scale(radius);
    return visibility < 0.999 ? visibility : 1.0;  // 121 times the rounded 1/121 is not 1
}
#endif

#ifndef UMBRAGE_HAS_TENT2
#define UMBRAGE_HAS_TENT2
// umbrage_tent2: PCF over 3 x 3 texels, weights 1 1. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
float umbrage_tent2(Texture2D<float4> map, float2 size, float2 coord, float receiver) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 x = compared ? floor(coord * 256.0) : float2(0.0, 0.0);  // no branch: fetches overlap
    float2 texel = floor(x * (1.0 / 256.0));
    // s is in [0, 256) already, w1 not negative. clamp and max keep compilers from regrouping sums across them
    float2 s = clamp(x * (1.0 / 256.0) - texel, float2(0.0, 0.0), float2(1.0, 1.0)) * 256.0;
    float2 r = 256.0 - s;
    float2 w0 = r * 8.0;
    float2 w2 = s * 8.0;
    float2 w1 = max(4096.0 - w0 - w2, float2(0.0, 0.0));
    float4 a = umbrage_lit_2x2(map, size, texel - 1.0, receiver);
    float4 b = umbrage_lit_2x2(map, size, texel + float2(1.0, -1.0), receiver);
    float4 c = umbrage_lit_2x2(map, size, texel + float2(-1.0, 1.0), receiver);
    float4 d = umbrage_lit_2x2(map, size, texel + float2(1.0, 1.0), receiver);
    float n = w0.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x);
    n += w1.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z);
    n += w2.y * (w0.x * c.x + w1.x * c.y + w2.x * d.x);
    return compared ? n * (1.0 / 16777216.0) : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_TENT3
#define UMBRAGE_HAS_TENT3
// umbrage_tent3: PCF under 3 x 3 weights, 1 2 1, that slide over the map
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
float umbrage_tent3(Texture2D<float4> map, float2 size, float2 coord, float receiver) {
    float n = umbrage_window_sum3(map, size, coord, receiver, 256.0, 4.0, 8.0);
    return clamp(n * (1.0 / 16777216.0), 0.0, 1.0);
}
#endif

#ifndef UMBRAGE_HAS_QUADRATIC_B_SPLINE
#define UMBRAGE_HAS_QUADRATIC_B_SPLINE
// umbrage_quadratic_b_spline: PCF over 3 x 3 texels, weighted by the quadratic B-spline. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
float umbrage_quadratic_b_spline(Texture2D<float4> map, float2 size, float2 coord, float receiver) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 x = compared ? floor(coord * 256.0) : float2(0.0, 0.0);  // no branch: fetches overlap
    float2 texel = floor(x * (1.0 / 256.0));
    // s is in [0, 256) already, w1 not negative. clamp and max keep compilers from regrouping sums across them
    float2 s = clamp(x * (1.0 / 256.0) - texel, float2(0.0, 0.0), float2(1.0, 1.0)) * 256.0;
    float2 r = 256.0 - s;
    float2 w0 = floor(r * r * (1.0 / 32.0));
    float2 w2 = floor(s * s * (1.0 / 32.0));
    float2 w1 = max(4096.0 - w0 - w2, float2(0.0, 0.0));
    float4 a = umbrage_lit_2x2(map, size, texel - 1.0, receiver);
    float4 b = umbrage_lit_2x2(map, size, texel + float2(1.0, -1.0), receiver);
    float4 c = umbrage_lit_2x2(map, size, texel + float2(-1.0, 1.0), receiver);
    float4 d = umbrage_lit_2x2(map, size, texel + float2(1.0, 1.0), receiver);
    float n = w0.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x);
    n += w1.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z);
    n += w2.y * (w0.x * c.x + w1.x * c.y + w2.x * d.x);
    return compared ? n * (1.0 / 16777216.0) : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_BINOMIAL5
#define UMBRAGE_HAS_BINOMIAL5
// umbrage_binomial5: PCF under 5 x 5 weights, 1 4 6 4 1, that slide over the map
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
float umbrage_binomial5(Texture2D<float4> map, float2 size, float2 coord, float receiver) {
    float n = umbrage_window_sum5(map, size, coord, receiver, 256.0, 1.0, 4.0, 6.0);
    return clamp(n * (1.0 / 16777216.0), 0.0, 1.0);
}
#endif

#ifndef UMBRAGE_HAS_CASTANO_DYADIC5
#define UMBRAGE_HAS_CASTANO_DYADIC5
// umbrage_castano_dyadic5: PCF under 5 x 5 weights, 5 16 22 16 5, that slide over the map
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
float umbrage_castano_dyadic5(Texture2D<float4> map, float2 size, float2 coord, float receiver) {
    float n = umbrage_window_sum5(map, size, coord, receiver, 256.0, 1.25, 4.0, 5.5);
    return clamp(n * (1.0 / 16777216.0), 0.0, 1.0);
}
#endif

#ifndef UMBRAGE_HAS_CASTANO5
#define UMBRAGE_HAS_CASTANO5
// umbrage_castano5: PCF under 5 x 5 weights, 1 3 4 3 1, that slide over the map
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
float umbrage_castano5(Texture2D<float4> map, float2 size, float2 coord, float receiver) {
    float n = umbrage_window_sum5(map, size, coord, receiver, 256.0, 1.0, 3.0, 4.0);
    return n < 9437184.0 ? n * (1.0 / 65536.0) * 0.00694444450 : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_BINOMIAL7
#define UMBRAGE_HAS_BINOMIAL7
// umbrage_binomial7: PCF under 7 x 7 weights, 1 6 15 20 15 6 1, that slide over the map
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
float umbrage_binomial7(Texture2D<float4> map, float2 size, float2 coord, float receiver) {
    float n = umbrage_window_sum7(map, size, coord, receiver, 256.0, 0.25, 1.5, 3.75, 5.0);
    return clamp(n * (1.0 / 16777216.0), 0.0, 1.0);
}
#endif

#ifndef UMBRAGE_HAS_TENT7
#define UMBRAGE_HAS_TENT7
// umbrage_tent7: PCF under 7 x 7 weights, 1 2 3 4 3 2 1, that slide over the map
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
float umbrage_tent7(Texture2D<float4> map, float2 size, float2 coord, float receiver) {
    float n = umbrage_window_sum7(map, size, coord, receiver, 256.0, 1.0, 2.0, 3.0, 4.0);
    return clamp(n * (1.0 / 16777216.0), 0.0, 1.0);
}
#endif

#ifndef UMBRAGE_HAS_CASTANO7
#define UMBRAGE_HAS_CASTANO7
// umbrage_castano7: PCF under 7 x 7 weights, 1 5 12 16 12 5 1, that slide over the map
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
float umbrage_castano7(Texture2D<float4> map, float2 size, float2 coord, float receiver) {
    float n = umbrage_window_sum7(map, size, coord, receiver, 64.0, 1.0, 5.0, 12.0, 16.0);
    return n < 11075584.0 ? n * (1.0 / 4096.0) * 0.000369822490 : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_CUBE_LIT
#define UMBRAGE_HAS_CUBE_LIT
// umbrage_cube_lit: one comparison with a texel of a cube map
// Returns (visibility, 1.0), or (0.0, 0.0) beyond a corner
//   map, size   atlas of 3 x 2 faces and its size in texels
//   texel       (s, t, face), integers
//   receiver    distance from the light, bias applied
float2 umbrage_cube_lit(Texture2D<float4> map, float2 size, float3 texel, float receiver) {
    float side = size.y * 0.5;
    float3 n = umbrage_cube_neighbor(texel, side);
    float2 at = umbrage_cube_tile(n.z, side) + float2(n.x, n.y);
    float lit = umbrage_lit(map, size, at, receiver);
    return n.z < 0.0 ? float2(0.0, 0.0) : float2(lit, 1.0);
}
#endif

#ifndef UMBRAGE_HAS_PCF_2X2_CUBE
#define UMBRAGE_HAS_PCF_2X2_CUBE
// umbrage_pcf_2x2_cube: bilinear 2x2 PCF across the edges of a cube map. Returns visibility, 1.0 = lit
//   map, size   atlas of 3 x 2 faces and its size in texels
//   at          (s, t, face): s and t in texels of the face, from 0.0 on
//   receiver    distance from the light, bias applied
float umbrage_pcf_2x2_cube(Texture2D<float4> map, float2 size, float3 at, float receiver) {
    float2 coord = float2(at.x, at.y);
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 x = compared ? floor(coord * 256.0 + 0.5) - 128.0 : float2(0.0, 0.0);
    float2 texel = floor(x * (1.0 / 256.0));
    // weights are in [0, 1) already. The clamp keeps compilers from regrouping sums across it
    float2 hi = clamp(x * (1.0 / 256.0) - texel, float2(0.0, 0.0), float2(1.0, 1.0));
    float2 lo = 1.0 - hi;
    float2 sum = umbrage_cube_lit(map, size, float3(texel, at.z), receiver) * (lo.x * lo.y);
    sum += umbrage_cube_lit(map, size, float3(texel + float2(1.0, 0.0), at.z), receiver) * (hi.x * lo.y);
    sum += umbrage_cube_lit(map, size, float3(texel + float2(0.0, 1.0), at.z), receiver) * (lo.x * hi.y);
    sum += umbrage_cube_lit(map, size, float3(texel + float2(1.0, 1.0), at.z), receiver) * (hi.x * hi.y);
    return compared && sum.y > 0.0 ? sum.x / sum.y : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_FOUR_TAP_HARDWARE
#define UMBRAGE_HAS_FOUR_TAP_HARDWARE
// umbrage_four_tap_hardware: mean of the shadow test at four taps of a nearest-texel sampler
// Returns visibility, 1.0 = lit
//   map, size    shadow map and its size in texels
//   a, b, c, d   taps from (0.0, 0.0) to (1.0, 1.0) over the map
//                All are lit where the mean of |x| + |y| is 2^15 texels or more
//   receiver     receiver depth in [0, 1], bias applied
float umbrage_four_tap_hardware(Texture2D<float4> map, float2 size, float2 a, float2 b, float2 c, float2 d,
                                float receiver) {
    float2 sum = (abs(a) + abs(b) + abs(c) + abs(d)) * size;
    bool compared = umbrage_beyond_far_plane(receiver) ? false : sum.x + sum.y < 131072.0;
    float count = umbrage_compare(receiver, umbrage_depth_at(map, size, a)) +
        umbrage_compare(receiver, umbrage_depth_at(map, size, b)) +
        umbrage_compare(receiver, umbrage_depth_at(map, size, c)) +
        umbrage_compare(receiver, umbrage_depth_at(map, size, d));
    return compared ? count * 0.25 : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_LIT_FILTERED
#define UMBRAGE_HAS_LIT_FILTERED
// umbrage_lit_filtered: 2x2 comparisons around a point, weighted. Returns visibility, 1.0 = lit
// The sampler of this map cannot weight comparisons, so the shader does
//   coord   in texels, no NaN. Outside texel space it is clamped
float umbrage_lit_filtered(Texture2D<float4> map, float2 size, float2 coord, float receiver) {
    return umbrage_pcf_2x2(map, size, clamp(coord, float2(-32767.0, -32767.0), float2(32767.0, 32767.0)), receiver);
}
#endif

#ifndef UMBRAGE_HAS_COVERED
#define UMBRAGE_HAS_COVERED
// umbrage_covered: share of the texels around a point that lie in the map, along each axis. Here all of them count
//   uv   over the map, (0.0, 0.0) to (1.0, 1.0)
float2 umbrage_covered(float2 size, float2 uv) {
    return float2(1.0, 1.0);
}
#endif

#ifndef UMBRAGE_HAS_LIT_BETWEEN
#define UMBRAGE_HAS_LIT_BETWEEN
// umbrage_lit_between: 2x2 comparisons around a point, weighted. Returns visibility, 1.0 = lit
//   uv    over the map, (0.0, 0.0) to (1.0, 1.0), no NaN
//   way   from the receiver to where the four texels meet, in texels. Only a receiver's plane uses it
float umbrage_lit_between(Texture2D<float4> map, float2 size, float2 uv, float2 way, float receiver) {
    return umbrage_lit_filtered(map, size, uv * size, receiver);
}
#endif

#ifndef UMBRAGE_HAS_LIT_AT
#define UMBRAGE_HAS_LIT_AT
// umbrage_lit_at: 2x2 comparisons around a point, weighted. Returns visibility, 1.0 = lit
//   uv      over the map, (0.0, 0.0) to (1.0, 1.0), no NaN
//   coord   receiver in texels
float umbrage_lit_at(Texture2D<float4> map, float2 size, float2 uv, float2 coord, float receiver) {
    float2 way = floor(uv * size + 0.5) - coord;
    float2 inside = umbrage_covered(size, uv);
    float lit = umbrage_lit_between(map, size, uv, way, receiver);
    return 1.0 + inside.x * inside.y * (lit - 1.0);  // texels outside are lit
}
#endif

#ifndef UMBRAGE_HAS_PCF_2X2_HARDWARE
#define UMBRAGE_HAS_PCF_2X2_HARDWARE
// umbrage_pcf_2x2_hardware: bilinear 2x2 PCF by the sampler. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
float umbrage_pcf_2x2_hardware(Texture2D<float4> map, float2 size, float2 coord, float receiver) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 at = compared ? coord : float2(0.0, 0.0);
    float lit = umbrage_lit_at(map, size, at / size, at, receiver);
    float visibility = umbrage_within_far_plane(receiver) ? lit : 0.0;
    return compared ? visibility : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_WINDOW_HARDWARE3
#define UMBRAGE_HAS_WINDOW_HARDWARE3
// umbrage_window_hardware3: PCF under a kernel that slides over the map, by the sampler
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   k0 .. k1    weights from the edge to the middle one. The others mirror them
float umbrage_window_hardware3(Texture2D<float4> map, float2 size, float2 coord, float receiver, float k0, float k1) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 x = compared ? coord - 0.5 : float2(0.0, 0.0);
    float2 texel = floor(x);
    float2 s = x - texel;
    float whole = k0 + k1 + k0;
    float2 w0 = k0 + k1 + s * -k1;
    float2 p0 = (texel + (-k0 * 0.5 + k1 * 0.5 + s * (k0 - k1 * 0.5)) / w0) / size;
    float2 v0 = w0 * umbrage_covered(size, p0);
    float2 w1 = k0 + s * k1;
    float2 p1 = (texel + (k0 * 1.5 + s * (k0 + k1 * 1.5)) / w1) / size;
    float2 v1 = w1 * umbrage_covered(size, p1);
    float2 inside = v0 + v1;
    // ... - s: from the receiver to where the four texels of a fetch meet
    float n = 0.0;
    float row = 0.0;
    row += v0.x * umbrage_lit_between(map, size, float2(p0.x, p0.y), float2(-0.5, -0.5) - s, receiver);
    row += v1.x * umbrage_lit_between(map, size, float2(p1.x, p0.y), float2(1.5, -0.5) - s, receiver);
    n += v0.y * row;
    row = 0.0;
    row += v0.x * umbrage_lit_between(map, size, float2(p0.x, p1.y), float2(-0.5, 1.5) - s, receiver);
    row += v1.x * umbrage_lit_between(map, size, float2(p1.x, p1.y), float2(1.5, 1.5) - s, receiver);
    n += v1.y * row;
    n += whole * whole - inside.x * inside.y;  // texels outside are lit
    float share = clamp(n / (whole * whole), 0.0, 1.0);
    float visibility = umbrage_within_far_plane(receiver) ? share : 0.0;
    return compared ? visibility : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_WINDOW_HARDWARE5
#define UMBRAGE_HAS_WINDOW_HARDWARE5
// umbrage_window_hardware5: PCF under a kernel that slides over the map, by the sampler
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   k0 .. k2    weights from the edge to the middle one. The others mirror them
float umbrage_window_hardware5(Texture2D<float4> map, float2 size, float2 coord, float receiver, float k0, float k1,
                               float k2) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 x = compared ? coord - 0.5 : float2(0.0, 0.0);
    float2 texel = floor(x);
    float2 s = x - texel;
    float whole = k0 + k1 + k2 + k1 + k0;
    float2 w0 = k0 + k1 + s * -k1;
    float2 p0 = (texel + (-k0 * 1.5 - k1 * 0.5 + s * (k0 + k1 * 0.5)) / w0) / size;
    float2 v0 = w0 * umbrage_covered(size, p0);
    float2 w1 = float2(k1 + k2, k1 + k2);
    float2 p1 = (texel + (k1 * 1.5 + k2 * 0.5 + s * (-k1 + k2)) / w1) / size;
    float2 v1 = w1 * umbrage_covered(size, p1);
    float2 w2 = k0 + s * k1;
    float2 p2 = (texel + (k0 * 2.5 + s * (k0 + k1 * 2.5)) / w2) / size;
    float2 v2 = w2 * umbrage_covered(size, p2);
    float2 inside = v0 + v1 + v2;
    // ... - s: from the receiver to where the four texels of a fetch meet
    float n = 0.0;
    float row = 0.0;
    row += v0.x * umbrage_lit_between(map, size, float2(p0.x, p0.y), float2(-1.5, -1.5) - s, receiver);
    row += v1.x * umbrage_lit_between(map, size, float2(p1.x, p0.y), float2(0.5, -1.5) - s, receiver);
    row += v2.x * umbrage_lit_between(map, size, float2(p2.x, p0.y), float2(2.5, -1.5) - s, receiver);
    n += v0.y * row;
    row = 0.0;
    row += v0.x * umbrage_lit_between(map, size, float2(p0.x, p1.y), float2(-1.5, 0.5) - s, receiver);
    row += v1.x * umbrage_lit_between(map, size, float2(p1.x, p1.y), float2(0.5, 0.5) - s, receiver);
    row += v2.x * umbrage_lit_between(map, size, float2(p2.x, p1.y), float2(2.5, 0.5) - s, receiver);
    n += v1.y * row;
    row = 0.0;
    row += v0.x * umbrage_lit_between(map, size, float2(p0.x, p2.y), float2(-1.5, 2.5) - s, receiver);
    row += v1.x * umbrage_lit_between(map, size, float2(p1.x, p2.y), float2(0.5, 2.5) - s, receiver);
    row += v2.x * umbrage_lit_between(map, size, float2(p2.x, p2.y), float2(2.5, 2.5) - s, receiver);
    n += v2.y * row;
    n += whole * whole - inside.x * inside.y;  // texels outside are lit
    float share = clamp(n / (whole * whole), 0.0, 1.0);
    float visibility = umbrage_within_far_plane(receiver) ? share : 0.0;
    return compared ? visibility : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_WINDOW_HARDWARE7
#define UMBRAGE_HAS_WINDOW_HARDWARE7
// umbrage_window_hardware7: PCF under a kernel that slides over the map, by the sampler
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   k0 .. k3    weights from the edge to the middle one. The others mirror them
float umbrage_window_hardware7(Texture2D<float4> map, float2 size, float2 coord, float receiver, float k0, float k1,
                               float k2, float k3) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 x = compared ? coord - 0.5 : float2(0.0, 0.0);
    float2 texel = floor(x);
    float2 s = x - texel;
    float whole = k0 + k1 + k2 + k3 + k2 + k1 + k0;
    float2 w0 = k0 + k1 + s * -k1;
    float2 p0 = (texel + (-k0 * 2.5 - k1 * 1.5 + s * (k0 + k1 * 1.5)) / w0) / size;
    float2 v0 = w0 * umbrage_covered(size, p0);
    float2 w1 = k2 + k3 + s * (k1 - k3);
    float2 p1 = (texel + (-k2 * 0.5 + k3 * 0.5 + s * (-k1 * 0.5 + k2 - k3 * 0.5)) / w1) / size;
    float2 v1 = w1 * umbrage_covered(size, p1);
    float2 w2 = k1 + k2 + s * (-k1 + k3);
    float2 p2 = (texel + (k1 * 2.5 + k2 * 1.5 + s * (-k1 * 2.5 + k2 + k3 * 1.5)) / w2) / size;
    float2 v2 = w2 * umbrage_covered(size, p2);
    float2 w3 = k0 + s * k1;
    float2 p3 = (texel + (k0 * 3.5 + s * (k0 + k1 * 3.5)) / w3) / size;
    float2 v3 = w3 * umbrage_covered(size, p3);
    float2 inside = v0 + v1 + v2 + v3;
    // ... - s: from the receiver to where the four texels of a fetch meet
    float n = 0.0;
    float row = 0.0;
    row += v0.x * umbrage_lit_between(map, size, float2(p0.x, p0.y), float2(-2.5, -2.5) - s, receiver);
    row += v1.x * umbrage_lit_between(map, size, float2(p1.x, p0.y), float2(-0.5, -2.5) - s, receiver);
    row += v2.x * umbrage_lit_between(map, size, float2(p2.x, p0.y), float2(1.5, -2.5) - s, receiver);
    row += v3.x * umbrage_lit_between(map, size, float2(p3.x, p0.y), float2(3.5, -2.5) - s, receiver);
    n += v0.y * row;
    row = 0.0;
    row += v0.x * umbrage_lit_between(map, size, float2(p0.x, p1.y), float2(-2.5, -0.5) - s, receiver);
    row += v1.x * umbrage_lit_between(map, size, float2(p1.x, p1.y), float2(-0.5, -0.5) - s, receiver);
    row += v2.x * umbrage_lit_between(map, size, float2(p2.x, p1.y), float2(1.5, -0.5) - s, receiver);
    row += v3.x * umbrage_lit_between(map, size, float2(p3.x, p1.y), float2(3.5, -0.5) - s, receiver);
    n += v1.y * row;
    row = 0.0;
    row += v0.x * umbrage_lit_between(map, size, float2(p0.x, p2.y), float2(-2.5, 1.5) - s, receiver);
    row += v1.x * umbrage_lit_between(map, size, float2(p1.x, p2.y), float2(-0.5, 1.5) - s, receiver);
    row += v2.x * umbrage_lit_between(map, size, float2(p2.x, p2.y), float2(1.5, 1.5) - s, receiver);
    row += v3.x * umbrage_lit_between(map, size, float2(p3.x, p2.y), float2(3.5, 1.5) - s, receiver);
    n += v2.y * row;
    row = 0.0;
    row += v0.x * umbrage_lit_between(map, size, float2(p0.x, p3.y), float2(-2.5, 3.5) - s, receiver);
    row += v1.x * umbrage_lit_between(map, size, float2(p1.x, p3.y), float2(-0.5, 3.5) - s, receiver);
    row += v2.x * umbrage_lit_between(map, size, float2(p2.x, p3.y), float2(1.5, 3.5) - s, receiver);
    row += v3.x * umbrage_lit_between(map, size, float2(p3.x, p3.y), float2(3.5, 3.5) - s, receiver);
    n += v3.y * row;
    n += whole * whole - inside.x * inside.y;  // texels outside are lit
    float share = clamp(n / (whole * whole), 0.0, 1.0);
    float visibility = umbrage_within_far_plane(receiver) ? share : 0.0;
    return compared ? visibility : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_ELLIPSE_HARDWARE8
#define UMBRAGE_HAS_ELLIPSE_HARDWARE8
// umbrage_ellipse_hardware8: PCF over 8 points of an ellipse, compared and weighted by the sampler
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      along x and y, in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
float umbrage_ellipse_hardware8(Texture2D<float4> map, float2 size, float2 coord, float receiver, float2 radius,
                                float4 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 center = (compared ? coord : float2(0.0, 0.0)) / size;
    float wide = radius.x > 0.0 ? min(radius.x, 255.9375) : 0.0;
    float high = radius.y > 0.0 ? min(radius.y, 255.9375) : 0.0;
    float2 part = float2(wide, high) * (1.0 / 1024.0) / size;
    float2 x = float2(rotation.x, rotation.z) * part;
    float2 y = float2(rotation.y, rotation.w) * part;
    float n = 0.0;
    n += umbrage_lit_at(map, size, center + x * 3.0 - y * 1.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 4.0 + y * 5.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 1.0 - y * 11.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 9.0 - y * 8.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 12.0 + y * 3.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 11.0 + y * 6.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 0.0 + y * 13.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 11.0 - y * 7.0, coord, receiver);
    float visibility = umbrage_within_far_plane(receiver) ? n * (1.0 / 8.0) : 0.0;
    return compared ? visibility : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_ELLIPSE_HARDWARE16
#define UMBRAGE_HAS_ELLIPSE_HARDWARE16
// umbrage_ellipse_hardware16: PCF over 16 points of an ellipse, compared and weighted by the sampler
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      along x and y, in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
float umbrage_ellipse_hardware16(Texture2D<float4> map, float2 size, float2 coord, float receiver, float2 radius,
                                 float4 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 center = (compared ? coord : float2(0.0, 0.0)) / size;
    float wide = radius.x > 0.0 ? min(radius.x, 255.9375) : 0.0;
    float high = radius.y > 0.0 ? min(radius.y, 255.9375) : 0.0;
    float2 part = float2(wide, high) * (1.0 / 1024.0) / size;
    float2 x = float2(rotation.x, rotation.z) * part;
    float2 y = float2(rotation.y, rotation.w) * part;
    float n = 0.0;
    n += umbrage_lit_at(map, size, center + x * 1.0 - y * 3.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 5.0 + y * 2.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 5.0 + y * 2.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 0.0 + y * 7.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 6.0 - y * 5.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 8.0 - y * 5.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 0.0 - y * 11.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 11.0 + y * 5.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 12.0 + y * 4.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 1.0 + y * 13.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 7.0 + y * 11.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 9.0 + y * 10.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 13.0 - y * 4.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 7.0 - y * 12.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 7.0 - y * 12.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 14.0 - y * 2.0, coord, receiver);
    float visibility = umbrage_within_far_plane(receiver) ? n * (1.0 / 16.0) : 0.0;
    return compared ? visibility : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_ELLIPSE_HARDWARE32
#define UMBRAGE_HAS_ELLIPSE_HARDWARE32
// umbrage_ellipse_hardware32: PCF over 32 points of an ellipse, compared and weighted by the sampler
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      along x and y, in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
float umbrage_ellipse_hardware32(Texture2D<float4> map, float2 size, float2 coord, float receiver, float2 radius,
                                 float4 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 center = (compared ? coord : float2(0.0, 0.0)) / size;
    float wide = radius.x > 0.0 ? min(radius.x, 255.9375) : 0.0;
    float high = radius.y > 0.0 ? min(radius.y, 255.9375) : 0.0;
    float2 part = float2(wide, high) * (1.0 / 1024.0) / size;
    float2 x = float2(rotation.x, rotation.z) * part;
    float2 y = float2(rotation.y, rotation.w) * part;
    float n = 0.0;
    n += umbrage_lit_at(map, size, center - x * 2.0 - y * 1.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 3.0 + y * 2.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 1.0 - y * 4.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 4.0 + y * 3.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 0.0 + y * 6.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 5.0 - y * 5.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 7.0 - y * 2.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 8.0 - y * 1.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 8.0 + y * 3.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 5.0 + y * 7.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 1.0 - y * 9.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 6.0 - y * 7.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 8.0 + y * 5.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 0.0 + y * 10.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 3.0 - y * 10.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 6.0 + y * 10.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 9.0 - y * 8.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 11.0 - y * 5.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 5.0 - y * 12.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 13.0 - y * 1.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 7.0 + y * 11.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 13.0 + y * 3.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 13.0 + y * 4.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 10.0 - y * 10.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 14.0 - y * 2.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 11.0 + y * 9.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 3.0 + y * 14.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 13.0 - y * 6.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 12.0 + y * 8.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 4.0 + y * 14.0, coord, receiver);
    n += umbrage_lit_at(map, size, center - x * 7.0 - y * 13.0, coord, receiver);
    n += umbrage_lit_at(map, size, center + x * 0.0 - y * 15.0, coord, receiver);
    float visibility = umbrage_within_far_plane(receiver) ? n * (1.0 / 32.0) : 0.0;
    return compared ? visibility : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_DISC_HARDWARE8
#define UMBRAGE_HAS_DISC_HARDWARE8
// umbrage_disc_hardware8: PCF over 8 points of a disc, compared and weighted by the sampler
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
float umbrage_disc_hardware8(Texture2D<float4> map, float2 size, float2 coord, float receiver, float radius,
                             float4 rotation) {
    return umbrage_ellipse_hardware8(map, size, coord, receiver, float2(radius, radius), rotation);
}
#endif

#ifndef UMBRAGE_HAS_DISC_HARDWARE16
#define UMBRAGE_HAS_DISC_HARDWARE16
// umbrage_disc_hardware16: PCF over 16 points of a disc, compared and weighted by the sampler
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
float umbrage_disc_hardware16(Texture2D<float4> map, float2 size, float2 coord, float receiver, float radius,
                              float4 rotation) {
    return umbrage_ellipse_hardware16(map, size, coord, receiver, float2(radius, radius), rotation);
}
#endif

#ifndef UMBRAGE_HAS_DISC_HARDWARE32
#define UMBRAGE_HAS_DISC_HARDWARE32
// umbrage_disc_hardware32: PCF over 32 points of a disc, compared and weighted by the sampler
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
float umbrage_disc_hardware32(Texture2D<float4> map, float2 size, float2 coord, float receiver, float radius,
                              float4 rotation) {
    return umbrage_ellipse_hardware32(map, size, coord, receiver, float2(radius, radius), rotation);
}
#endif

#ifndef UMBRAGE_HAS_BOUNDS_LIT
#define UMBRAGE_HAS_BOUNDS_LIT
// umbrage_bounds_lit: early exit of a filter. Returns 1.0 where all texels are lit, 0.0 where none is
// Returns -1.0 where the bounds do not decide it: call the filter there
//   bounds, size      map of the texels' smallest and largest depths, and its size in texels
//   coord, receiver   as passed to the filter
//   place             maps a receiver to its bounds, from make_filter_bounds
float umbrage_bounds_lit(Texture2D<float4> bounds, float2 size, float2 coord, float receiver, float2 place) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 x = compared ? floor(coord * 256.0) : float2(0.0, 0.0);
    float4 b = umbrage_fetch_clamped(bounds, size, floor((x + place.x) * place.y));
    float all = umbrage_compare(receiver, b.x);
    float some = umbrage_compare(receiver, b.y);
    float known = b.x <= b.y && all == some ? all : -1.0;  // NaN bounds decide nothing
    return compared ? known : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_DISTANCE_CODE
#define UMBRAGE_HAS_DISTANCE_CODE
// umbrage_distance_code: distance of a depth from the near plane, an integer from 0.0 to 65535.0
// Returns 0.0 at the near plane, also where depth is reversed
float umbrage_distance_code(float depth) {
    float v = depth * 65536.0;
    float forward = v < 65535.0 ? floor(max(v, 0.0)) : 65535.0;
    float reversed = v > 0.0 ? floor(min(v, 65535.0)) : 0.0;
    return umbrage_cleared_depth() > 0.5 ? forward : 65535.0 - reversed;
}
#endif

#ifndef UMBRAGE_HAS_BLOCKER
#define UMBRAGE_HAS_BLOCKER
// umbrage_blocker: (1.0, umbrage_distance_code) of a texel nearer to the light than the receiver, else (0.0, 0.0)
float2 umbrage_blocker(Texture2D<float4> map, float2 size, float2 texel, float receiver) {
    float stored = umbrage_fetch_depth(map, size, texel);
    float code = umbrage_distance_code(stored);
    return umbrage_compare(receiver, stored) > 0.5 ? float2(0.0, 0.0) : float2(1.0, code);
}
#endif

#ifndef UMBRAGE_HAS_BLOCKERS8
#define UMBRAGE_HAS_BLOCKERS8
// umbrage_blockers8: (number of blockers, sum of their distance codes) at 8 points of an ellipse
//   map, size   shadow map and its size in texels
//   position    floor(256 coord) of the receiver
//   receiver    receiver depth in [0, 1], bias applied
//   radius      along x and y, in 1/16 texel, integers from 0 to 4095
//   rotation    umbrage_disc_rotation of the pixel
float2 umbrage_blockers8(Texture2D<float4> map, float2 size, float2 position, float receiver, float2 radius,
                         float4 rotation) {
    float2 n = float2(0.0, 0.0);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(3.0, -1.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-4.0, 5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(1.0, -11.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-9.0, -8.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-12.0, 3.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(11.0, 6.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(0.0, 13.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(11.0, -7.0), rotation, radius), receiver);
    return n;
}
#endif

#ifndef UMBRAGE_HAS_BLOCKERS16
#define UMBRAGE_HAS_BLOCKERS16
// umbrage_blockers16: (number of blockers, sum of their distance codes) at 16 points of an ellipse
//   map, size   shadow map and its size in texels
//   position    floor(256 coord) of the receiver
//   receiver    receiver depth in [0, 1], bias applied
//   radius      along x and y, in 1/16 texel, integers from 0 to 4095
//   rotation    umbrage_disc_rotation of the pixel
float2 umbrage_blockers16(Texture2D<float4> map, float2 size, float2 position, float receiver, float2 radius,
                          float4 rotation) {
    float2 n = float2(0.0, 0.0);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(1.0, -3.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(5.0, 2.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-5.0, 2.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(0.0, 7.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-6.0, -5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(8.0, -5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(0.0, -11.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(11.0, 5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-12.0, 4.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-1.0, 13.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(7.0, 11.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-9.0, 10.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-13.0, -4.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(7.0, -12.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-7.0, -12.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(14.0, -2.0), rotation, radius), receiver);
    return n;
}
#endif

#ifndef UMBRAGE_HAS_BLOCKERS32
#define UMBRAGE_HAS_BLOCKERS32
// umbrage_blockers32: (number of blockers, sum of their distance codes) at 32 points of an ellipse
//   map, size   shadow map and its size in texels
//   position    floor(256 coord) of the receiver
//   receiver    receiver depth in [0, 1], bias applied
//   radius      along x and y, in 1/16 texel, integers from 0 to 4095
//   rotation    umbrage_disc_rotation of the pixel
float2 umbrage_blockers32(Texture2D<float4> map, float2 size, float2 position, float receiver, float2 radius,
                          float4 rotation) {
    float2 n = float2(0.0, 0.0);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-2.0, -1.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(3.0, 2.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(1.0, -4.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-4.0, 3.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(0.0, 6.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-5.0, -5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(7.0, -2.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-8.0, -1.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(8.0, 3.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(5.0, 7.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(1.0, -9.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(6.0, -7.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-8.0, 5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(0.0, 10.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-3.0, -10.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-6.0, 10.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-9.0, -8.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(11.0, -5.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(5.0, -12.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-13.0, -1.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(7.0, 11.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(13.0, 3.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-13.0, 4.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(10.0, -10.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(14.0, -2.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-11.0, 9.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(3.0, 14.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-13.0, -6.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(12.0, 8.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-4.0, 14.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(-7.0, -13.0), rotation, radius), receiver);
    n += umbrage_blocker(map, size, umbrage_disc_tap(position, float2(0.0, -15.0), rotation, radius), receiver);
    return n;
}
#endif

#ifndef UMBRAGE_HAS_PCSS8
#define UMBRAGE_HAS_PCSS8
// umbrage_pcss8: percentage-closer soft shadows (PCSS), 8 points twice. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   softness    from make_penumbra_params
//   rotation    umbrage_disc_rotation of the pixel
float umbrage_pcss8(Texture2D<float4> map, float2 size, float2 coord, float receiver, float4 softness,
                    float4 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 at = compared ? floor(coord * 256.0) : float2(0.0, 0.0);
    float z = umbrage_distance_code(receiver);
    float2 search_radius = umbrage_penumbra(z, softness);
    float2 found = umbrage_blockers8(map, size, at, receiver, search_radius, rotation);
    float mean = umbrage_floor_divide(found.y, max(found.x, 1.0));
    float2 radius = umbrage_penumbra(z - mean, softness);
    // without a blocker the radius is that of the search, whose points are all lit
    return umbrage_ellipse8(map, size, coord, receiver, radius, rotation);
}
#endif

#ifndef UMBRAGE_HAS_PCSS16
#define UMBRAGE_HAS_PCSS16
// umbrage_pcss16: percentage-closer soft shadows (PCSS), 16 points twice. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   softness    from make_penumbra_params
//   rotation    umbrage_disc_rotation of the pixel
float umbrage_pcss16(Texture2D<float4> map, float2 size, float2 coord, float receiver, float4 softness,
                     float4 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 at = compared ? floor(coord * 256.0) : float2(0.0, 0.0);
    float z = umbrage_distance_code(receiver);
    float2 search_radius = umbrage_penumbra(z, softness);
    float2 found = umbrage_blockers16(map, size, at, receiver, search_radius, rotation);
    float mean = umbrage_floor_divide(found.y, max(found.x, 1.0));
    float2 radius = umbrage_penumbra(z - mean, softness);
    // without a blocker the radius is that of the search, whose points are all lit
    return umbrage_ellipse16(map, size, coord, receiver, radius, rotation);
}
#endif

#ifndef UMBRAGE_HAS_PCSS32
#define UMBRAGE_HAS_PCSS32
// umbrage_pcss32: percentage-closer soft shadows (PCSS), 32 points twice. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   softness    from make_penumbra_params
//   rotation    umbrage_disc_rotation of the pixel
float umbrage_pcss32(Texture2D<float4> map, float2 size, float2 coord, float receiver, float4 softness,
                     float4 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 at = compared ? floor(coord * 256.0) : float2(0.0, 0.0);
    float z = umbrage_distance_code(receiver);
    float2 search_radius = umbrage_penumbra(z, softness);
    float2 found = umbrage_blockers32(map, size, at, receiver, search_radius, rotation);
    float mean = umbrage_floor_divide(found.y, max(found.x, 1.0));
    float2 radius = umbrage_penumbra(z - mean, softness);
    // without a blocker the radius is that of the search, whose points are all lit
    return umbrage_ellipse32(map, size, coord, receiver, radius, rotation);
}
#endif

#ifndef UMBRAGE_HAS_BLOCKER_AT
#define UMBRAGE_HAS_BLOCKER_AT
// umbrage_blocker_at: (1.0, depth) of the texel at a point if it is nearer to the light, else (0.0, 0.0)
//   uv   over the map, (0.0, 0.0) to (1.0, 1.0), no NaN
float2 umbrage_blocker_at(Texture2D<float4> map, float2 size, float2 uv, float receiver) {
    float stored = umbrage_depth_at(map, size, uv);
    return umbrage_compare(receiver, stored) > 0.5 ? float2(0.0, 0.0) : float2(1.0, stored);
}
#endif

#ifndef UMBRAGE_HAS_PCSS_RADIUS
#define UMBRAGE_HAS_PCSS_RADIUS
// umbrage_pcss_radius: radius of a penumbra along x and y in texels
// Without a blocker it is the radius for one at the near plane
//   found      (number of blockers, sum of their depths)
//   receiver   receiver depth in [0, 1], bias applied
//   softness   (1/16 texel per distance code along x and y, min_radius, max_radius), from make_penumbra_params
float2 umbrage_pcss_radius(float2 found, float receiver, float4 softness) {
    bool forward = umbrage_cleared_depth() > 0.5;
    float mean = found.x > 0.5 ? found.y / found.x : (forward ? 0.0 : 1.0);
    float apart = forward ? receiver - mean : mean - receiver;
    float2 radius = float2(softness.x, softness.y) * 4096.0 * apart;
    float min_radius = softness.z * 0.0625;
    float max_radius = softness.w * 0.0625;
    return float2(radius.x > min_radius ? min(radius.x, max_radius) : min_radius,
                  radius.y > min_radius ? min(radius.y, max_radius) : min_radius);
}
#endif

#ifndef UMBRAGE_HAS_BLOCKERS_HARDWARE8
#define UMBRAGE_HAS_BLOCKERS_HARDWARE8
// umbrage_blockers_hardware8: (number of blockers, sum of their depths) at 8 points of an ellipse
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      along x and y, in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
float2 umbrage_blockers_hardware8(Texture2D<float4> map, float2 size, float2 coord, float receiver, float2 radius,
                                  float4 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 center = (compared ? coord : float2(0.0, 0.0)) / size;
    float wide = radius.x > 0.0 ? min(radius.x, 255.9375) : 0.0;
    float high = radius.y > 0.0 ? min(radius.y, 255.9375) : 0.0;
    float2 part = float2(wide, high) * (1.0 / 1024.0) / size;
    float2 x = float2(rotation.x, rotation.z) * part;
    float2 y = float2(rotation.y, rotation.w) * part;
    float2 n = float2(0.0, 0.0);
    n += umbrage_blocker_at(map, size, center + x * 3.0 - y * 1.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 4.0 + y * 5.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 1.0 - y * 11.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 9.0 - y * 8.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 12.0 + y * 3.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 11.0 + y * 6.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 0.0 + y * 13.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 11.0 - y * 7.0, receiver);
    return compared ? n : float2(0.0, 0.0);
}
#endif

#ifndef UMBRAGE_HAS_BLOCKERS_HARDWARE16
#define UMBRAGE_HAS_BLOCKERS_HARDWARE16
// umbrage_blockers_hardware16: (number of blockers, sum of their depths) at 16 points of an ellipse
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      along x and y, in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
float2 umbrage_blockers_hardware16(Texture2D<float4> map, float2 size, float2 coord, float receiver, float2 radius,
                                   float4 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 center = (compared ? coord : float2(0.0, 0.0)) / size;
    float wide = radius.x > 0.0 ? min(radius.x, 255.9375) : 0.0;
    float high = radius.y > 0.0 ? min(radius.y, 255.9375) : 0.0;
    float2 part = float2(wide, high) * (1.0 / 1024.0) / size;
    float2 x = float2(rotation.x, rotation.z) * part;
    float2 y = float2(rotation.y, rotation.w) * part;
    float2 n = float2(0.0, 0.0);
    n += umbrage_blocker_at(map, size, center + x * 1.0 - y * 3.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 5.0 + y * 2.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 5.0 + y * 2.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 0.0 + y * 7.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 6.0 - y * 5.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 8.0 - y * 5.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 0.0 - y * 11.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 11.0 + y * 5.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 12.0 + y * 4.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 1.0 + y * 13.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 7.0 + y * 11.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 9.0 + y * 10.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 13.0 - y * 4.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 7.0 - y * 12.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 7.0 - y * 12.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 14.0 - y * 2.0, receiver);
    return compared ? n : float2(0.0, 0.0);
}
#endif

#ifndef UMBRAGE_HAS_BLOCKERS_HARDWARE32
#define UMBRAGE_HAS_BLOCKERS_HARDWARE32
// umbrage_blockers_hardware32: (number of blockers, sum of their depths) at 32 points of an ellipse
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      along x and y, in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
float2 umbrage_blockers_hardware32(Texture2D<float4> map, float2 size, float2 coord, float receiver, float2 radius,
                                   float4 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 center = (compared ? coord : float2(0.0, 0.0)) / size;
    float wide = radius.x > 0.0 ? min(radius.x, 255.9375) : 0.0;
    float high = radius.y > 0.0 ? min(radius.y, 255.9375) : 0.0;
    float2 part = float2(wide, high) * (1.0 / 1024.0) / size;
    float2 x = float2(rotation.x, rotation.z) * part;
    float2 y = float2(rotation.y, rotation.w) * part;
    float2 n = float2(0.0, 0.0);
    n += umbrage_blocker_at(map, size, center - x * 2.0 - y * 1.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 3.0 + y * 2.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 1.0 - y * 4.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 4.0 + y * 3.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 0.0 + y * 6.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 5.0 - y * 5.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 7.0 - y * 2.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 8.0 - y * 1.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 8.0 + y * 3.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 5.0 + y * 7.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 1.0 - y * 9.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 6.0 - y * 7.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 8.0 + y * 5.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 0.0 + y * 10.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 3.0 - y * 10.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 6.0 + y * 10.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 9.0 - y * 8.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 11.0 - y * 5.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 5.0 - y * 12.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 13.0 - y * 1.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 7.0 + y * 11.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 13.0 + y * 3.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 13.0 + y * 4.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 10.0 - y * 10.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 14.0 - y * 2.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 11.0 + y * 9.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 3.0 + y * 14.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 13.0 - y * 6.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 12.0 + y * 8.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 4.0 + y * 14.0, receiver);
    n += umbrage_blocker_at(map, size, center - x * 7.0 - y * 13.0, receiver);
    n += umbrage_blocker_at(map, size, center + x * 0.0 - y * 15.0, receiver);
    return compared ? n : float2(0.0, 0.0);
}
#endif

#ifndef UMBRAGE_HAS_DPCF8
#define UMBRAGE_HAS_DPCF8
// umbrage_dpcf8: soft shadow with contact hardening from 8 points. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   softness    from make_penumbra_params
//   rotation    umbrage_disc_rotation of the pixel
float umbrage_dpcf8(Texture2D<float4> map, float2 size, float2 coord, float receiver, float4 softness,
                    float4 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 at = compared ? floor(coord * 256.0) : float2(0.0, 0.0);
    float z = umbrage_distance_code(receiver);
    float2 search_radius = umbrage_penumbra(z, softness);
    float2 found = umbrage_blockers8(map, size, at, receiver, search_radius, rotation);
    float mean = umbrage_floor_divide(found.y, max(found.x, 1.0));
    float2 radius = umbrage_penumbra(z - mean, softness);
    float searched = max(search_radius.x + search_radius.y, 1.0);
    float ratio = umbrage_floor_divide((radius.x + radius.y) * 256.0, searched);
    float dark = umbrage_hardened_kernel8(found.x, ratio);
    return compared ? clamp(1.0 - dark, 0.0, 1.0) : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_DPCF16
#define UMBRAGE_HAS_DPCF16
// umbrage_dpcf16: soft shadow with contact hardening from 16 points. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   softness    from make_penumbra_params
//   rotation    umbrage_disc_rotation of the pixel
float umbrage_dpcf16(Texture2D<float4> map, float2 size, float2 coord, float receiver, float4 softness,
                     float4 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 at = compared ? floor(coord * 256.0) : float2(0.0, 0.0);
    float z = umbrage_distance_code(receiver);
    float2 search_radius = umbrage_penumbra(z, softness);
    float2 found = umbrage_blockers16(map, size, at, receiver, search_radius, rotation);
    float mean = umbrage_floor_divide(found.y, max(found.x, 1.0));
    float2 radius = umbrage_penumbra(z - mean, softness);
    float searched = max(search_radius.x + search_radius.y, 1.0);
    float ratio = umbrage_floor_divide((radius.x + radius.y) * 256.0, searched);
    float dark = umbrage_hardened_kernel16(found.x, ratio);
    return compared ? clamp(1.0 - dark, 0.0, 1.0) : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_DPCF32
#define UMBRAGE_HAS_DPCF32
// umbrage_dpcf32: soft shadow with contact hardening from 32 points. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   softness    from make_penumbra_params
//   rotation    umbrage_disc_rotation of the pixel
float umbrage_dpcf32(Texture2D<float4> map, float2 size, float2 coord, float receiver, float4 softness,
                     float4 rotation) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 at = compared ? floor(coord * 256.0) : float2(0.0, 0.0);
    float z = umbrage_distance_code(receiver);
    float2 search_radius = umbrage_penumbra(z, softness);
    float2 found = umbrage_blockers32(map, size, at, receiver, search_radius, rotation);
    float mean = umbrage_floor_divide(found.y, max(found.x, 1.0));
    float2 radius = umbrage_penumbra(z - mean, softness);
    float searched = max(search_radius.x + search_radius.y, 1.0);
    float ratio = umbrage_floor_divide((radius.x + radius.y) * 256.0, searched);
    float dark = umbrage_hardened_kernel32(found.x, ratio);
    return compared ? clamp(1.0 - dark, 0.0, 1.0) : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_BOX_MOMENTS
#define UMBRAGE_HAS_BOX_MOMENTS
// umbrage_box_moments: (mean, rest, high, low) of the quantized depths in a box of n texels, integers
//   The sum of the depths is n mean + rest. The sum of their squared distances from mean is 4096 high + low
//   map, size    table from make_variance_table and its size
//   first, end   lowest texel of the box, and one past its highest. first < end
float4 umbrage_box_moments(Texture2D<float4> map, float2 size, float2 first, float2 end) {
    float4 a = umbrage_texel(map, size, end);
    float4 b = umbrage_texel(map, size, float2(first.x, end.y));
    float4 c = umbrage_texel(map, size, float2(end.x, first.y));
    float4 d = umbrage_texel(map, size, first);
    float4 part = (a - b) - (c - d);
    float2 low = float2(part.x, part.z);
    float2 carry = floor(low * (1.0 / 65536.0));
    float2 above = float2(part.y, part.w) + carry;
    // nothing below is negative. The maxima keep compilers from regrouping sums across them
    low = max(low - carry * 65536.0, float2(0.0, 0.0));
    above = max(above - floor(above * (1.0 / 65536.0)) * 65536.0, float2(0.0, 0.0));
    float sum = above.x * 65536.0 + low.x;
    float2 sides = max(end - first, float2(1.0, 1.0));
    float n = sides.x * sides.y;
    float mean = umbrage_floor_divide(sum, n);
    float rest = max(sum - mean * n, 0.0);
    float2 digits = float2(sum + rest, low.y);
    float2 high = floor(digits * (1.0 / 4096.0));
    digits = max(digits - high * 4096.0, float2(0.0, 0.0));
    float below = digits.y - mean * digits.x;
    float borrow = floor(below * (1.0 / 4096.0));
    float wide = above.y * 16.0 + high.y - mean * high.x + borrow;
    wide = wide - floor(wide * (1.0 / 1048576.0)) * 1048576.0;
    return float4(mean, rest, wide, below - borrow * 4096.0);
}
#endif

#ifndef UMBRAGE_HAS_SUMMED_VARIANCE
#define UMBRAGE_HAS_SUMMED_VARIANCE
// umbrage_summed_variance: variance shadow from a summed-area table. Returns visibility, 1.0 = lit
//   map, size   table from make_variance_table and its size: the shadow map's plus one
//   coord       receiver in texels of the shadow map. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      an integer. The box has 2 radius + 1 texels per side
//   codes       2^bits of the table
float umbrage_summed_variance(Texture2D<float4> map, float2 size, float2 coord, float receiver, float radius,
                              float codes) {
    float2 last = size - 1.0;
    bool compared = umbrage_map_covers(last, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    float2 texel = compared ? clamp(floor(coord), float2(0.0, 0.0), last - 1.0) : float2(0.0, 0.0);
    float2 first = max(texel - radius, float2(0.0, 0.0));
    float2 end = min(texel + radius + 1.0, last);
    float4 m = umbrage_box_moments(map, size, first, end);
    float2 sides = end - first;
    float n = sides.x * sides.y;
    float share = m.y / n;
    float variance = (m.z * 4096.0 + (m.w - m.y)) / n + share * (1.0 - share);
    float scaled = receiver * codes;
    float t = umbrage_cleared_depth() > 0.5 ? scaled : codes - scaled;
    float d = (t - 1.0 - m.x) - share;
    float behind = d > 0.0 ? variance / (variance + d * d) : 0.0;
    return compared ? (d <= 0.0 ? 1.0 : behind) : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_BOX_MEAN
#define UMBRAGE_HAS_BOX_MEAN
// umbrage_box_mean: mean over a box of four integers below 65536.0
//   map, size    table from make_moment_table and its size
//   first, end   lowest texel of the box, and one past its highest. first < end
float4 umbrage_box_mean(Texture2D<float4> map, float2 size, float2 first, float2 end) {
    float right = size.x * 0.5;
    float4 a = umbrage_texel(map, size, end);
    float4 b = umbrage_texel(map, size, float2(first.x, end.y));
    float4 c = umbrage_texel(map, size, float2(end.x, first.y));
    float4 d = umbrage_texel(map, size, first);
    float4 low = (a - b) - (c - d);
    float4 carry = floor(low * (1.0 / 65536.0));
    a = umbrage_texel(map, size, float2(right + end.x, end.y));
    b = umbrage_texel(map, size, float2(right + first.x, end.y));
    c = umbrage_texel(map, size, float2(right + end.x, first.y));
    d = umbrage_texel(map, size, float2(right + first.x, first.y));
    float4 above = (a - b) - (c - d) + carry;
    float4 high = above - floor(above * (1.0 / 65536.0)) * 65536.0;
    precise float4 sum = high * 65536.0 + (low - carry * 65536.0);
    float2 sides = end - first;
    return sum / (sides.x * sides.y);
}
#endif

#ifndef UMBRAGE_HAS_TO_FORWARD_DEPTH
#define UMBRAGE_HAS_TO_FORWARD_DEPTH
// umbrage_to_forward_depth: depth that grows with distance, 1.0 - depth where the map's depth is reversed
float umbrage_to_forward_depth(float depth) {
    return umbrage_cleared_depth() < 0.5 ? 1.0 - depth : depth;
}
#endif

#ifndef UMBRAGE_HAS_DECODE_MSM
#define UMBRAGE_HAS_DECODE_MSM
// umbrage_decode_msm: visibility of a receiver, at least its lit fraction minus bias.x. 1.0 = lit
//   b: mean of texels. receiver: depth in [0, 1], bias applied
//   bias: (3e-6, 0.375) for 32-bit floats, (6e-5, 0.628) for 16-bit channels
float umbrage_decode_msm(float4 b, float receiver, float2 bias) {
    float d = umbrage_to_forward_depth(receiver);
    float4 m = umbrage_bias_moments(b, bias);
    precise float x = ((d > 0.0 ? (d < 1.0 ? d : 1.0) : 0.0) * 2.0 - 1.0) - m.x;
    float4 atoms = umbrage_moment_atoms(m, x);
    float first = atoms.x < x ? atoms.z : 0.0;
    float second = atoms.y < x ? atoms.w : 0.0;
    precise float lit = 1.0 - (first + second);
    bool known = abs(atoms.z + atoms.w) <= 4294967296.0;  // false for NaN
    lit = known ? (lit > 0.0 ? (lit < 1.0 ? lit : 1.0) : 0.0) : (x <= 0.0 ? 1.0 : 0.0);
    return d > 0.0 ? lit : (d <= 0.0 ? lit : 0.0);
}
#endif

#ifndef UMBRAGE_HAS_SUMMED_MOMENTS
#define UMBRAGE_HAS_SUMMED_MOMENTS
// umbrage_summed_moments: moment shadow from a summed-area table. Returns visibility, 1.0 = lit
//   map, size   table from make_moment_table and its size: twice the shadow map's width plus two, its height plus one
//   coord       receiver in texels of the shadow map. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      an integer. The box has 2 radius + 1 texels per side
//   bias        (6e-5, 0.628)
float umbrage_summed_moments(Texture2D<float4> map, float2 size, float2 coord, float receiver, float radius,
                             float2 bias) {
    float2 last = float2(size.x * 0.5, size.y) - 1.0;
    bool compared = umbrage_map_covers(last, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    float2 texel = compared ? clamp(floor(coord), float2(0.0, 0.0), last - 1.0) : float2(0.0, 0.0);
    float2 first = max(texel - radius, float2(0.0, 0.0));
    float2 end = min(texel + radius + 1.0, last);
    float4 turned = umbrage_box_mean(map, size, first, end) * (1.0 / 65535.0);
    float lit = umbrage_decode_msm(umbrage_from_optimized_moments(turned), receiver, bias);
    return compared ? lit : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_ENCODE_VSM
#define UMBRAGE_HAS_ENCODE_VSM
// umbrage_encode_vsm: texel of a variance shadow map, depth and its square. NaN counts as far
float2 umbrage_encode_vsm(float depth) {
    float d = umbrage_to_forward_depth(umbrage_saturate(depth));
    return float2(d, d * d);
}
#endif

#ifndef UMBRAGE_HAS_DECODE_VSM
#define UMBRAGE_HAS_DECODE_VSM
// umbrage_decode_vsm: visibility of a receiver from a variance shadow map, at least its lit fraction. 1.0 = lit
//   m              mean of texels
//   receiver       receiver depth, bias applied
//   min_variance   0.0 or more
float umbrage_decode_vsm(float2 m, float receiver, float min_variance) {
    return umbrage_chebyshev(m, umbrage_to_forward_depth(receiver), min_variance);
}
#endif

#ifndef UMBRAGE_HAS_ENCODE_ESM
#define UMBRAGE_HAS_ENCODE_ESM
// umbrage_encode_esm: texel of an exponential shadow map, from depth in [0, 1]. NaN counts as far
float umbrage_encode_esm(float depth, float exponent) {
    return umbrage_exponential_warp(umbrage_to_forward_depth(umbrage_saturate(depth)), exponent);
}
#endif

#ifndef UMBRAGE_HAS_DECODE_ESM
#define UMBRAGE_HAS_DECODE_ESM
// umbrage_decode_esm: visibility of a receiver from an exponential shadow map, at least its lit fraction. 1.0 = lit
//   m          mean of texels
//   receiver   receiver depth, bias applied
//   exponent   same as for the texels
float umbrage_decode_esm(float m, float receiver, float exponent) {
    float d = umbrage_to_forward_depth(receiver);
    float p = m * umbrage_exponential_warp(d, -exponent);
    float lit = p > 0.0 && p < 1.0 ? p : (p >= 1.0 ? 1.0 : 0.0);
    return d > 0.0 ? lit : (d <= 0.0 ? lit : 0.0);
}
#endif

#ifndef UMBRAGE_HAS_ENCODE_EVSM2
#define UMBRAGE_HAS_ENCODE_EVSM2
// umbrage_encode_evsm2: texel of two components, a power of depth and its square. NaN counts as far
float2 umbrage_encode_evsm2(float depth, float exponent) {
    float w = umbrage_exponential_warp(umbrage_to_forward_depth(umbrage_saturate(depth)), exponent);
    return float2(w, w * w);
}
#endif

#ifndef UMBRAGE_HAS_ENCODE_EVSM4
#define UMBRAGE_HAS_ENCODE_EVSM4
// umbrage_encode_evsm4: texel of four components, a growing power, its square, a negative falling power, its square
// NaN counts as far
float4 umbrage_encode_evsm4(float depth, float2 exponents) {
    float d = umbrage_to_forward_depth(umbrage_saturate(depth));
    float w = umbrage_exponential_warp(d, exponents.x);
    float n = -umbrage_exponential_warp(d, -exponents.y);
    return float4(w, w * w, n, n * n);
}
#endif

#ifndef UMBRAGE_HAS_DECODE_EVSM2
#define UMBRAGE_HAS_DECODE_EVSM2
// umbrage_decode_evsm2: visibility of a receiver from a mean of texels, at least its lit fraction. 1.0 = lit
//   m           mean of texels
//   receiver    receiver depth in [0, 1], bias applied
//   exponent    same as for the texels
//   deviation   minimum standard deviation, relative to the receiver's power
float umbrage_decode_evsm2(float2 m, float receiver, float exponent, float deviation) {
    float d = umbrage_to_forward_depth(umbrage_saturate(receiver));
    float w = umbrage_exponential_warp(d, exponent);
    precise float least = deviation * w;
    precise float least_variance = least * least;
    float lit = umbrage_chebyshev(m, w, least_variance);
    return receiver > 0.0 ? lit : (receiver <= 0.0 ? lit : 0.0);
}
#endif

#ifndef UMBRAGE_HAS_DECODE_EVSM4
#define UMBRAGE_HAS_DECODE_EVSM4
// umbrage_decode_evsm4: visibility of a receiver from a mean of texels, at least its lit fraction. 1.0 = lit
//   m            mean of texels
//   receiver     receiver depth in [0, 1], bias applied
//   exponents    same as for the texels
//   deviations   minimum standard deviations, relative to the receiver's powers
float umbrage_decode_evsm4(float4 m, float receiver, float2 exponents, float2 deviations) {
    float d = umbrage_to_forward_depth(umbrage_saturate(receiver));
    float w = umbrage_exponential_warp(d, exponents.x);
    float n = -umbrage_exponential_warp(d, -exponents.y);
    precise float2 least = deviations * float2(w, n);
    precise float2 least_variance = least * least;
    float a = umbrage_chebyshev(float2(m.x, m.y), w, least_variance.x);
    float b = umbrage_chebyshev(float2(m.z, m.w), n, least_variance.y);
    float lit = a < b ? a : b;
    return receiver > 0.0 ? lit : (receiver <= 0.0 ? lit : 0.0);
}
#endif

#ifndef UMBRAGE_HAS_ENCODE_MSM
#define UMBRAGE_HAS_ENCODE_MSM
// umbrage_encode_msm: first four powers of depth on -1.0 to 1.0, the texel of a moment shadow map. NaN counts as far
float4 umbrage_encode_msm(float depth) {
    precise float z = umbrage_to_forward_depth(umbrage_saturate(depth)) * 2.0 - 1.0;
    float square = z * z;
    return float4(z, square, square * z, square * square);
}
#endif

#ifndef UMBRAGE_HAS_DECODE_MSM_HAUSDORFF
#define UMBRAGE_HAS_DECODE_MSM_HAUSDORFF
// umbrage_decode_msm_hausdorff: visibility of a receiver, at least its lit fraction minus bias.x. 1.0 = lit
//   b          mean of texels
//   receiver   receiver depth in [0, 1], bias applied
//   bias       (3e-6, 0.375)
float umbrage_decode_msm_hausdorff(float4 b, float receiver, float2 bias) {
    float plain = umbrage_decode_msm(b, receiver, bias);
    float d = umbrage_to_forward_depth(receiver);
    float z = (d > 0.0 ? (d < 1.0 ? d : 1.0) : 0.0) * 2.0 - 1.0;
    float share = umbrage_hausdorff_share(umbrage_bias_moments(b, bias), z);
    float lit = share >= 0.0 ? 1.0 - share : plain;
    return d > 0.0 ? lit : (d <= 0.0 ? lit : 0.0);
}
#endif

#ifndef UMBRAGE_HAS_FETCH_BILINEAR
#define UMBRAGE_HAS_FETCH_BILINEAR
// umbrage_fetch_bilinear: bilinear mean of the four texels around a point, weights in steps of 1/256
//   coord   in texels. (0.5, 0.5) is the center of the first texel
float4 umbrage_fetch_bilinear(Texture2D<float4> map, float2 size, float2 coord) {
    float2 x = floor(coord * 256.0) - 128.0;
    float2 texel = floor(x * (1.0 / 256.0));
    // weights are in [0, 256) already. The clamp keeps compilers from regrouping sums across it
    float2 hi = clamp(x * (1.0 / 256.0) - texel, float2(0.0, 0.0), float2(1.0, 1.0)) * 256.0;
    float2 lo = 256.0 - hi;  // 1.0 - hi would become an interpolation, which rounds differently
    float4 a = umbrage_fetch_clamped(map, size, texel);
    float4 b = umbrage_fetch_clamped(map, size, texel + float2(1.0, 0.0));
    float4 c = umbrage_fetch_clamped(map, size, texel + float2(0.0, 1.0));
    float4 d = umbrage_fetch_clamped(map, size, texel + float2(1.0, 1.0));
    precise float4 low = a * lo.x + b * hi.x;
    precise float4 high = c * lo.x + d * hi.x;
    precise float4 sum = low * lo.y + high * hi.y;
    return sum * (1.0 / 65536.0);
}
#endif

#ifndef UMBRAGE_HAS_VSM
#define UMBRAGE_HAS_VSM
// umbrage_vsm: visibility from a blurred map of encode_vsm's texels, 1.0 = lit
//   map, size, coord: prefiltered map, its size, and the receiver in texels. (0.5, 0.5) is the center of the first
//   texel receiver: depth in [0, 1], bias applied. min_variance: 0.0 or more
float umbrage_vsm(Texture2D<float4> map, float2 size, float2 coord, float receiver, float min_variance) {
    bool compared = umbrage_map_covers(size, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    float4 m = umbrage_fetch_bilinear(map, size, compared ? coord : float2(0.0, 0.0));
    float lit = umbrage_decode_vsm(float2(m.x, m.y), receiver, min_variance);
    return compared ? lit : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_ESM
#define UMBRAGE_HAS_ESM
// umbrage_esm: visibility from a blurred map of encode_esm's texels, 1.0 = lit
//   map, size, coord: prefiltered map, its size, and the receiver in texels. (0.5, 0.5) is the center of the first
//   texel receiver: depth in [0, 1], bias applied. exponent: same as for the texels
float umbrage_esm(Texture2D<float4> map, float2 size, float2 coord, float receiver, float exponent) {
    bool compared = umbrage_map_covers(size, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    float4 m = umbrage_fetch_bilinear(map, size, compared ? coord : float2(0.0, 0.0));
    float lit = umbrage_decode_esm(m.x, receiver, exponent);
    return compared ? lit : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_EVSM2
#define UMBRAGE_HAS_EVSM2
// umbrage_evsm2: visibility from a blurred map of encode_evsm2's texels, 1.0 = lit
//   map, size, coord: prefiltered map, its size, and the receiver in texels. (0.5, 0.5) is the center of the first
//   texel receiver: depth in [0, 1], bias applied. exponent, deviation: as for decode_evsm2
float umbrage_evsm2(Texture2D<float4> map, float2 size, float2 coord, float receiver, float exponent, float deviation) {
    bool compared = umbrage_map_covers(size, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    float4 m = umbrage_fetch_bilinear(map, size, compared ? coord : float2(0.0, 0.0));
    float lit = umbrage_decode_evsm2(float2(m.x, m.y), receiver, exponent, deviation);
    return compared ? lit : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_EVSM4
#define UMBRAGE_HAS_EVSM4
// umbrage_evsm4: visibility from a blurred map of encode_evsm4's texels, 1.0 = lit
//   map, size, coord: prefiltered map, its size, and the receiver in texels. (0.5, 0.5) is the center of the first
//   texel receiver: depth in [0, 1], bias applied. exponents, deviations: as for decode_evsm4
float umbrage_evsm4(Texture2D<float4> map, float2 size, float2 coord, float receiver, float2 exponents,
                    float2 deviations) {
    bool compared = umbrage_map_covers(size, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    float4 m = umbrage_fetch_bilinear(map, size, compared ? coord : float2(0.0, 0.0));
    float lit = umbrage_decode_evsm4(m, receiver, exponents, deviations);
    return compared ? lit : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_MSM
#define UMBRAGE_HAS_MSM
// umbrage_msm: visibility from a blurred map of encode_msm's texels, 1.0 = lit
//   map, size, coord: prefiltered map, its size, and the receiver in texels. (0.5, 0.5) is the center of the first
//   texel receiver: depth in [0, 1], bias applied. bias: as for decode_msm
float umbrage_msm(Texture2D<float4> map, float2 size, float2 coord, float receiver, float2 bias) {
    bool compared = umbrage_map_covers(size, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    float4 m = umbrage_fetch_bilinear(map, size, compared ? coord : float2(0.0, 0.0));
    float lit = umbrage_decode_msm(m, receiver, bias);
    return compared ? lit : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_MSM_UNORM16
#define UMBRAGE_HAS_MSM_UNORM16
// umbrage_msm_unorm16: visibility from a blurred map of optimized moments, 1.0 = lit
//   map, size, coord: prefiltered map, its size, and the receiver in texels. (0.5, 0.5) is the center of the first
//   texel receiver: depth in [0, 1], bias applied. bias: as for decode_msm
float umbrage_msm_unorm16(Texture2D<float4> map, float2 size, float2 coord, float receiver, float2 bias) {
    bool compared = umbrage_map_covers(size, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    float4 m = umbrage_fetch_bilinear(map, size, compared ? coord : float2(0.0, 0.0));
    float lit = umbrage_decode_msm(umbrage_from_optimized_moments(m), receiver, bias);
    return compared ? lit : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_MSM_HAUSDORFF
#define UMBRAGE_HAS_MSM_HAUSDORFF
// umbrage_msm_hausdorff: visibility from a blurred map of encode_msm's texels, for depths on [-1, 1]. 1.0 = lit
//   map, size, coord: prefiltered map, its size, and the receiver in texels. (0.5, 0.5) is the center of the first
//   texel receiver: depth in [0, 1], bias applied. bias: as for decode_msm
float umbrage_msm_hausdorff(Texture2D<float4> map, float2 size, float2 coord, float receiver, float2 bias) {
    bool compared = umbrage_map_covers(size, coord) ? umbrage_in_filter_domain(coord, receiver) : false;
    float4 m = umbrage_fetch_bilinear(map, size, compared ? coord : float2(0.0, 0.0));
    float lit = umbrage_decode_msm_hausdorff(m, receiver, bias);
    return compared ? lit : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_DECODE_VSM_HARDWARE
#define UMBRAGE_HAS_DECODE_VSM_HARDWARE
// umbrage_decode_vsm_hardware: visibility of a receiver with light bleeding reduced. 1.0 = lit
//   held           mean and twice the standard deviation of depths, filtered
//   receiver       receiver depth, bias applied
//   min_variance   1e-7 or more
//   amount         visibility that becomes 0.0, 0.0 to 0.5
float umbrage_decode_vsm_hardware(float2 held, float receiver, float min_variance, float amount) {
    float variance = max(held.y * held.y * 0.25, min_variance);
    float distance = umbrage_to_forward_depth(receiver) - held.x;
    float lit = umbrage_chebyshev_hardware(variance, distance, amount);
    return abs(receiver) < 1048576.0 ? lit : 0.0;
}
#endif

#ifndef UMBRAGE_HAS_DECODE_EVSM2_HARDWARE
#define UMBRAGE_HAS_DECODE_EVSM2_HARDWARE
// umbrage_decode_evsm2_hardware: visibility of a receiver with light bleeding reduced. 1.0 = lit
//   m           mean of texels
//   receiver    receiver depth in [0, 1], bias applied
//   exponent    same as for the texels
//   deviation   minimum standard deviation, relative to the receiver's power
//   amount      visibility that becomes 0.0, 0.0 to 0.3
float umbrage_decode_evsm2_hardware(float2 m, float receiver, float exponent, float deviation, float amount) {
    float d = umbrage_to_forward_depth(clamp(receiver, 0.0, 1.0));
    float w = exp2(exponent * (d * 2.0 - 1.0));
    float least = deviation * w;
    float variance = max(m.y - m.x * m.x, least * least);
    float lit = umbrage_chebyshev_hardware(variance, w - m.x, amount);
    return abs(receiver) < 1048576.0 ? lit : 0.0;
}
#endif

#ifndef UMBRAGE_HAS_DECODE_EVSM4_HARDWARE
#define UMBRAGE_HAS_DECODE_EVSM4_HARDWARE
// umbrage_decode_evsm4_hardware: visibility of a receiver with light bleeding reduced. 1.0 = lit
//   m            mean of texels
//   receiver     receiver depth in [0, 1], bias applied
//   exponents    same as for the texels
//   deviations   minimum standard deviations, relative to the receiver's powers
//   amount       visibility that becomes 0.0, 0.0 to 0.3
float umbrage_decode_evsm4_hardware(float4 m, float receiver, float2 exponents, float2 deviations, float amount) {
    float d = umbrage_to_forward_depth(clamp(receiver, 0.0, 1.0)) * 2.0 - 1.0;
    float w = exp2(exponents.x * d);
    float n = 0.0 - exp2((0.0 - exponents.y) * d);
    float2 least = deviations * float2(w, n);
    float growing = max(m.y - m.x * m.x, least.x * least.x);
    float falling = max(m.w - m.z * m.z, least.y * least.y);
    float a = umbrage_chebyshev_hardware(growing, w - m.x, amount);
    float b = umbrage_chebyshev_hardware(falling, n - m.z, amount);
    return abs(receiver) < 1048576.0 ? min(a, b) : 0.0;
}
#endif

#ifndef UMBRAGE_HAS_BLUR_ROW3
#define UMBRAGE_HAS_BLUR_ROW3
// umbrage_blur_row3: mean of 3 texels in a row, with the weights of a row of Pascal's triangle
//   map, size   map that is read, and its size in texels
//   texel       index of the texel, integers. (0, 0) is the first
//   along       (1.0, 0.0) or (0.0, 1.0)
float4 umbrage_blur_row3(Texture2D<float4> map, float2 size, float2 texel, float2 along) {
    precise float4 sum = umbrage_fetch_clamped(map, size, texel) * (2.0 / 4.0);
    float4 before1 = umbrage_fetch_clamped(map, size, texel - along * 1.0);
    float4 after1 = umbrage_fetch_clamped(map, size, texel + along * 1.0);
    sum = sum + (before1 + after1) * (1.0 / 4.0);
    return sum;
}
#endif

#ifndef UMBRAGE_HAS_BLUR_ROW5
#define UMBRAGE_HAS_BLUR_ROW5
// umbrage_blur_row5: mean of 5 texels in a row, with the weights of a row of Pascal's triangle
//   map, size   map that is read, and its size in texels
//   texel       index of the texel, integers. (0, 0) is the first
//   along       (1.0, 0.0) or (0.0, 1.0)
float4 umbrage_blur_row5(Texture2D<float4> map, float2 size, float2 texel, float2 along) {
    precise float4 sum = umbrage_fetch_clamped(map, size, texel) * (6.0 / 16.0);
    float4 before1 = umbrage_fetch_clamped(map, size, texel - along * 1.0);
    float4 after1 = umbrage_fetch_clamped(map, size, texel + along * 1.0);
    sum = sum + (before1 + after1) * (4.0 / 16.0);
    float4 before2 = umbrage_fetch_clamped(map, size, texel - along * 2.0);
    float4 after2 = umbrage_fetch_clamped(map, size, texel + along * 2.0);
    sum = sum + (before2 + after2) * (1.0 / 16.0);
    return sum;
}
#endif

#ifndef UMBRAGE_HAS_BLUR_ROW7
#define UMBRAGE_HAS_BLUR_ROW7
// umbrage_blur_row7: mean of 7 texels in a row, with the weights of a row of Pascal's triangle
//   map, size   map that is read, and its size in texels
//   texel       index of the texel, integers. (0, 0) is the first
//   along       (1.0, 0.0) or (0.0, 1.0)
float4 umbrage_blur_row7(Texture2D<float4> map, float2 size, float2 texel, float2 along) {
    precise float4 sum = umbrage_fetch_clamped(map, size, texel) * (20.0 / 64.0);
    float4 before1 = umbrage_fetch_clamped(map, size, texel - along * 1.0);
    float4 after1 = umbrage_fetch_clamped(map, size, texel + along * 1.0);
    sum = sum + (before1 + after1) * (15.0 / 64.0);
    float4 before2 = umbrage_fetch_clamped(map, size, texel - along * 2.0);
    float4 after2 = umbrage_fetch_clamped(map, size, texel + along * 2.0);
    sum = sum + (before2 + after2) * (6.0 / 64.0);
    float4 before3 = umbrage_fetch_clamped(map, size, texel - along * 3.0);
    float4 after3 = umbrage_fetch_clamped(map, size, texel + along * 3.0);
    sum = sum + (before3 + after3) * (1.0 / 64.0);
    return sum;
}
#endif

#ifndef UMBRAGE_HAS_HALVE_TEXELS
#define UMBRAGE_HAS_HALVE_TEXELS
// umbrage_halve_texels: mean of the 2x2 texels behind one texel of the next mip level
//   map, size   map that is read, and its size in texels
//   texel       index in the next level, integers
float4 umbrage_halve_texels(Texture2D<float4> map, float2 size, float2 texel) {
    float2 at = texel * 2.0;
    float4 a = umbrage_fetch_clamped(map, size, at);
    float4 b = umbrage_fetch_clamped(map, size, at + float2(1.0, 0.0));
    float4 c = umbrage_fetch_clamped(map, size, at + float2(0.0, 1.0));
    float4 d = umbrage_fetch_clamped(map, size, at + float2(1.0, 1.0));
    precise float4 sum = (a + b) + (c + d);
    return sum * 0.25;
}
#endif

#ifndef UMBRAGE_HAS_BIASED
#define UMBRAGE_HAS_BIASED
// umbrage_biased: receiver moved towards the light by bias, in depth; no move for NaN, or magnitudes of 2^64 or more
float umbrage_biased(float receiver, float bias) {
    float by = abs(bias) < 18446744073709551616.0 ? bias : 0.0;
    return umbrage_cleared_depth() > 0.5 ? receiver - by : receiver + by;
}
#endif

#ifndef UMBRAGE_HAS_PLANE_REFERENCE
#define UMBRAGE_HAS_PLANE_REFERENCE
// umbrage_plane_reference: depth of the receiver, or of its plane at a texel where that is nearer to the light
//   slope   slope of the receiver's plane, per texel, no NaN
//   at      receiver position in texels, and its depth, bias applied
//   texel   index of the texel
float umbrage_plane_reference(float2 slope, float3 at, float2 texel) {
    precise float2 way = texel - (float2(at.x, at.y) - 0.5);
    precise float plane = (at.z + slope.x * way.x) + slope.y * way.y;
    return umbrage_cleared_depth() > 0.5 ? min(plane, at.z) : max(plane, at.z);
}
#endif

#ifndef UMBRAGE_HAS_BORDERED_PLANE_REFERENCE
#define UMBRAGE_HAS_BORDERED_PLANE_REFERENCE
// umbrage_bordered_plane_reference: umbrage_plane_reference, but before every stored depth outside the map
//   slope, at, texel   as for umbrage_plane_reference
//   inside             texel if the map has it, otherwise any other
float umbrage_bordered_plane_reference(float2 slope, float3 at, float2 texel, float2 inside) {
    float lights = umbrage_cleared_depth() > 0.5 ? -16777216.0 : 16777216.0;
    precise float2 moves = slope * (texel - (float2(at.x, at.y) - 0.5));
    float x = inside.x == texel.x ? moves.x : lights;  // the same for all texels of a column
    float y = inside.y == texel.y ? moves.y : lights;
    precise float plane = (at.z + x) + y;
    return umbrage_cleared_depth() > 0.5 ? min(plane, at.z) : max(plane, at.z);
}
#endif

#ifndef UMBRAGE_HAS_CORNER_REFERENCE
#define UMBRAGE_HAS_CORNER_REFERENCE
// umbrage_corner_reference: depth of the receiver, or of its plane where four texels meet, the nearer to the light
//   slope      slope of the receiver's plane, per texel, no NaN
//   way        from the receiver to where the texels meet, in texels
//   receiver   depth, bias applied
float umbrage_corner_reference(float2 slope, float2 way, float receiver) {
    float plane = (receiver + slope.x * way.x) + slope.y * way.y;
    return umbrage_cleared_depth() > 0.5 ? min(plane, receiver) : max(plane, receiver);
}
#endif

#ifndef UMBRAGE_HAS_APPLY_RECEIVER_PLANE
#define UMBRAGE_HAS_APPLY_RECEIVER_PLANE
// umbrage_apply_receiver_plane: depth of a texel that shadows the receiver's plane; any other has the far plane's
//   stored  depth of the texel
//   slope   slope of the receiver's plane, per texel
//   at      receiver position in texels, and its depth, bias applied
//   texel   index of the texel
float umbrage_apply_receiver_plane(float stored, float2 slope, float3 at, float2 texel) {
    float lit = umbrage_compare(umbrage_plane_reference(slope, at, texel), stored);
    return lit > 0.5 ? umbrage_cleared_depth() : stored;
}
#endif

#ifndef UMBRAGE_HAS_FALSE_COLOR
#define UMBRAGE_HAS_FALSE_COLOR
// umbrage_false_color: blue for 0.0, through green, to red for 1.0
float3 umbrage_false_color(float v) {
    float x = umbrage_saturate(v) * 4.0;
    precise float3 ramp = 1.5 - abs(float3(x - 3.0, x - 2.0, x - 1.0));
    return float3(umbrage_saturate(ramp.x), umbrage_saturate(ramp.y), umbrage_saturate(ramp.z));
}
#endif

#ifndef UMBRAGE_HAS_PROBE_COLOR
#define UMBRAGE_HAS_PROBE_COLOR
// umbrage_probe_color: debug color of a receiver's position in a map
//   at      x and y in texels, z depth
//   size    size of the map, in texels
//   bias    bias of the receiver, in depth
//   number  index of the map, an integer
//   magenta  not a number
//   black    behind the light
//   white    outside the map, or all cascades
//   cyan     beyond the far plane
//   blue     in front of the near plane
//   red      bias at its limit of 1.0
//   else     squares of one texel, gray or in the map's color: all is well
float3 umbrage_probe_color(float3 at, float2 size, float bias, float number) {
    float limit = 18446744073709551616.0;
    // limits differ on purpose: Mesa makes max(x, y) < limit of equal ones, which loses a NaN
    bool usable = abs(at.x) < limit && abs(at.y) * 2.0 < limit * 2.0 && abs(at.z) * 4.0 < limit * 4.0;
    bool inside = at.x >= 0.0 && at.y >= 0.0 && at.x <= size.x && at.y <= size.y;
    bool forward = umbrage_cleared_depth() > 0.5;
    bool past_far = forward ? at.z > 1.0 : at.z < 0.0;
    bool past_near = forward ? at.z < 0.0 : at.z > 1.0;
    float2 place = clamp(float2(at.x, at.y), float2(0.0, 0.0), float2(65536.0, 65536.0));
    float square = floor(place.x) + floor(place.y);
    float shade = square - 2.0 * floor(square * 0.5) > 0.5 ? 0.75 : 1.0;
    float3 bits = floor(float3(number, number * 0.5, number * 0.25));
    bits = bits - 2.0 * floor(bits * 0.5);
    float3 color = (bits * 0.5 + 0.375) * shade;
    color = bias < 1.0 ? color : float3(1.0, 0.0, 0.0);
    color = past_near ? float3(0.0, 0.0, 1.0) : color;
    color = past_far ? float3(0.0, 1.0, 1.0) : color;
    color = inside ? color : float3(1.0, 1.0, 1.0);
    color = at.x < 65536.0 ? color : float3(0.0, 0.0, 0.0);
    return usable ? color : float3(1.0, 0.0, 1.0);
}
#endif

#ifndef UMBRAGE_HAS_BEYOND_FAR_PLANE_SHADOW
#define UMBRAGE_HAS_BEYOND_FAR_PLANE_SHADOW
// umbrage_beyond_far_plane_shadow: true if a receiver is beyond the far plane
precise bool umbrage_beyond_far_plane_shadow(float receiver) {
    return receiver > 1.0;
}
#endif

#ifndef UMBRAGE_HAS_IN_FILTER_DOMAIN_SHADOW
#define UMBRAGE_HAS_IN_FILTER_DOMAIN_SHADOW
// umbrage_in_filter_domain_shadow: true if a filter compares; lit outside texel space and beyond the far plane
precise bool umbrage_in_filter_domain_shadow(float2 coord, float receiver) {
    // a choice, not a && !b: FXC turns !(receiver > 1.0) into receiver <= 1.0, which loses a NaN
    return umbrage_beyond_far_plane_shadow(receiver) ? false : umbrage_inside_texel_space(coord);
}
#endif

#ifndef UMBRAGE_HAS_TEXEL_INSIDE_SHADOW
#define UMBRAGE_HAS_TEXEL_INSIDE_SHADOW
// umbrage_texel_inside_shadow: texel of the map, itself if the map has it; otherwise any, whose value does not count
float2 umbrage_texel_inside_shadow(float2 size, float2 texel) {
    return min(abs(texel), size - 1.0);
}
#endif

#ifndef UMBRAGE_HAS_LIT_TEXEL_SHADOW
#define UMBRAGE_HAS_LIT_TEXEL_SHADOW
// umbrage_lit_texel_shadow: the sampler's comparison with a texel inside the map. NaN is in shadow
float umbrage_lit_texel_shadow(Texture2D<float> map, SamplerComparisonState map_sampler, float2 size, float2 texel,
                               float receiver) {
    float lit = map.SampleCmpLevelZero(map_sampler, (texel + 0.5) / size, receiver);
    return (receiver > 0.0 ? lit : 0.0) + (receiver <= 0.0 ? lit : 0.0);
}
#endif

#ifndef UMBRAGE_HAS_COMPARE_SHADOW
#define UMBRAGE_HAS_COMPARE_SHADOW
// umbrage_compare_shadow: 1.0 when the receiver is no farther than the stored depth
float umbrage_compare_shadow(float receiver, float stored) {
    return receiver <= stored ? 1.0 : 0.0;
}
#endif

#ifndef UMBRAGE_HAS_LIT_SHADOW
#define UMBRAGE_HAS_LIT_SHADOW
// umbrage_lit_shadow: compares the receiver with one texel. Outside the map it compares with the far plane
float umbrage_lit_shadow(Texture2D<float> map, SamplerComparisonState map_sampler, float2 size, float2 texel,
                         float receiver) {
    float2 inside = umbrage_texel_inside_shadow(size, texel);
    float lit = umbrage_lit_texel_shadow(map, map_sampler, size, inside, receiver);
    float outside = umbrage_compare_shadow(receiver, 1.0);
    return inside.x == texel.x && inside.y == texel.y ? lit : outside;
}
#endif

#ifndef UMBRAGE_HAS_HARD_SHADOW
#define UMBRAGE_HAS_HARD_SHADOW
// umbrage_hard_shadow: shadow test without a filter. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
float umbrage_hard_shadow(Texture2D<float> map, SamplerComparisonState map_sampler, float2 size, float2 coord,
                          float receiver) {
    bool compared = umbrage_in_filter_domain_shadow(coord, receiver);
    float2 texel = compared ? floor(coord) : float2(0.0, 0.0);  // no branch: fetches of several taps overlap
    float lit = umbrage_lit_shadow(map, map_sampler, size, texel, receiver);
    return compared ? lit : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_LIT_2X2_SHADOW
#define UMBRAGE_HAS_LIT_2X2_SHADOW
// umbrage_lit_2x2_shadow: visibility from the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1)
float4 umbrage_lit_2x2_shadow(Texture2D<float> map, SamplerComparisonState map_sampler, float2 size, float2 texel,
                              float receiver) {
    float a = umbrage_lit_shadow(map, map_sampler, size, texel, receiver);
    float b = umbrage_lit_shadow(map, map_sampler, size, texel + float2(1.0, 0.0), receiver);
    float c = umbrage_lit_shadow(map, map_sampler, size, texel + float2(0.0, 1.0), receiver);
    float d = umbrage_lit_shadow(map, map_sampler, size, texel + float2(1.0, 1.0), receiver);
    return float4(a, b, c, d);
}
#endif

#ifndef UMBRAGE_HAS_PCF_2X2_SHADOW
#define UMBRAGE_HAS_PCF_2X2_SHADOW
// umbrage_pcf_2x2_shadow: bilinear 2x2 PCF. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
float umbrage_pcf_2x2_shadow(Texture2D<float> map, SamplerComparisonState map_sampler, float2 size, float2 coord,
                             float receiver) {
    bool compared = umbrage_in_filter_domain_shadow(coord, receiver);
    float2 x = compared ? floor(coord * 256.0) - 128.0 : float2(0.0, 0.0);  // no branch: fetches overlap
    float2 texel = floor(x * (1.0 / 256.0));
    // weights are in [0, 1) already. The clamp keeps compilers from regrouping sums across it
    float2 hi = clamp(x * (1.0 / 256.0) - texel, float2(0.0, 0.0), float2(1.0, 1.0));
    float2 lo = 1.0 - hi;
    float4 lit = umbrage_lit_2x2_shadow(map, map_sampler, size, texel, receiver);
    float visibility = lo.y * (lo.x * lit.x + hi.x * lit.y) + hi.y * (lo.x * lit.z + hi.x * lit.w);
    return compared ? visibility : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_BOX_COUNT_SHADOW
#define UMBRAGE_HAS_BOX_COUNT_SHADOW
// umbrage_box_count_shadow: number of lit texels in the (2r+1) x (2r+1) box around the receiver's texel, an integer
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      r, clamped to 0..8. Compilers unroll the loops if it is a constant
float umbrage_box_count_shadow(Texture2D<float> map, SamplerComparisonState map_sampler, float2 size, float2 coord,
                               float receiver, int radius) {
    int r = radius < 0 ? 0 : (radius < 8 ? radius : 8);
    int width = 2 * r + 1;
    bool compared = umbrage_in_filter_domain_shadow(coord, receiver);
    float2 first = compared ? floor(coord) - float(r) : float2(0.0, 0.0);
    float count = 0.0;
    for (int j = 0; j < 17; j++) {
        if (j >= width) break;
        for (int i = 0; i < 17; i++) {
            if (i >= width) break;
            count += umbrage_lit_shadow(map, map_sampler, size, first + float2(float(i), float(j)), receiver);
        }
    }
    return compared ? count : float(width * width);
}
#endif

#ifndef UMBRAGE_HAS_BOX_SHADOW
#define UMBRAGE_HAS_BOX_SHADOW
// umbrage_box_shadow: box PCF, the lit fraction of a (2r+1) x (2r+1) box. Returns visibility, 1.0 = lit
//   parameters as for umbrage_box_count_shadow
float umbrage_box_shadow(Texture2D<float> map, SamplerComparisonState map_sampler, float2 size, float2 coord,
                         float receiver, int radius) {
    float visibility = umbrage_box_count_shadow(map, map_sampler, size, coord, receiver, radius) *
        umbrage_box_scale(radius);
    return visibility < 0.999 ? visibility : 1.0;  // 121 times the rounded 1/121 is not 1
}
#endif

#ifndef UMBRAGE_HAS_TENT2_SHADOW
#define UMBRAGE_HAS_TENT2_SHADOW
// umbrage_tent2_shadow: PCF over 3 x 3 texels, weights 1 1. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
float umbrage_tent2_shadow(Texture2D<float> map, SamplerComparisonState map_sampler, float2 size, float2 coord,
                           float receiver) {
    bool compared = umbrage_in_filter_domain_shadow(coord, receiver);
    float2 x = compared ? floor(coord * 256.0) : float2(0.0, 0.0);  // no branch: fetches overlap
    float2 texel = floor(x * (1.0 / 256.0));
    // s is in [0, 256) already, w1 not negative. clamp and max keep compilers from regrouping sums across them
    float2 s = clamp(x * (1.0 / 256.0) - texel, float2(0.0, 0.0), float2(1.0, 1.0)) * 256.0;
    float2 r = 256.0 - s;
    float2 w0 = r * 8.0;
    float2 w2 = s * 8.0;
    float2 w1 = max(4096.0 - w0 - w2, float2(0.0, 0.0));
    float4 a = umbrage_lit_2x2_shadow(map, map_sampler, size, texel - 1.0, receiver);
    float4 b = umbrage_lit_2x2_shadow(map, map_sampler, size, texel + float2(1.0, -1.0), receiver);
    float4 c = umbrage_lit_2x2_shadow(map, map_sampler, size, texel + float2(-1.0, 1.0), receiver);
    float4 d = umbrage_lit_2x2_shadow(map, map_sampler, size, texel + float2(1.0, 1.0), receiver);
    float n = w0.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x);
    n += w1.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z);
    n += w2.y * (w0.x * c.x + w1.x * c.y + w2.x * d.x);
    return compared ? n * (1.0 / 16777216.0) : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_WINDOW_SUM3_SHADOW
#define UMBRAGE_HAS_WINDOW_SUM3_SHADOW
// umbrage_window_sum3_shadow: weighted count of the lit texels under a kernel that slides over the map, an integer
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   steps       per texel, a power of two up to 256
//   k0 .. k1    weights from the edge to the middle one. The others mirror them
// Steps times the sum of all weights must be an integer up to 4096. Its square is the count when all is lit
float umbrage_window_sum3_shadow(Texture2D<float> map, SamplerComparisonState map_sampler, float2 size, float2 coord,
                                 float receiver, float steps, float k0, float k1) {
    bool compared = umbrage_in_filter_domain_shadow(coord, receiver);  // no branch: fetches overlap
    float2 x = compared ? floor(coord * 256.0) - 128.0 : float2(0.0, 0.0);
    float2 texel = floor(x * (1.0 / 256.0));
    float2 s = floor((x - texel * 256.0) * (1.0 / 256.0) * steps);
    float2 r = steps - s;
    float whole = steps * (k0 + k1 + k0);
    float2 w0 = floor(r * k0);
    float2 w2 = floor(r * k0 + s * k1);
    float2 w3 = floor(s * k0);
    float2 w1 = max(whole - (w0 + w2 + w3), float2(0.0, 0.0));
    float2 first = texel - 1.0;
    float n = 0.0;
    float4 a = umbrage_lit_2x2_shadow(map, map_sampler, size, first + float2(0.0, 0.0), receiver);
    float4 b = umbrage_lit_2x2_shadow(map, map_sampler, size, first + float2(2.0, 0.0), receiver);
    n += w0.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y);
    n += w1.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w);
    a = umbrage_lit_2x2_shadow(map, map_sampler, size, first + float2(0.0, 2.0), receiver);
    b = umbrage_lit_2x2_shadow(map, map_sampler, size, first + float2(2.0, 2.0), receiver);
    n += w2.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y);
    n += w3.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w);
    return compared ? n : whole * whole;
}
#endif

#ifndef UMBRAGE_HAS_TENT3_SHADOW
#define UMBRAGE_HAS_TENT3_SHADOW
// umbrage_tent3_shadow: PCF under 3 x 3 weights, 1 2 1, that slide over the map
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
float umbrage_tent3_shadow(Texture2D<float> map, SamplerComparisonState map_sampler, float2 size, float2 coord,
                           float receiver) {
    float n = umbrage_window_sum3_shadow(map, map_sampler, size, coord, receiver, 256.0, 4.0, 8.0);
    return clamp(n * (1.0 / 16777216.0), 0.0, 1.0);
}
#endif

#ifndef UMBRAGE_HAS_WINDOW_SUM5_SHADOW
#define UMBRAGE_HAS_WINDOW_SUM5_SHADOW
// umbrage_window_sum5_shadow: weighted count of the lit texels under a kernel that slides over the map, an integer
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   steps       per texel, a power of two up to 256
//   k0 .. k2    weights from the edge to the middle one. The others mirror them
// Steps times the sum of all weights must be an integer up to 4096. Its square is the count when all is lit
float umbrage_window_sum5_shadow(Texture2D<float> map, SamplerComparisonState map_sampler, float2 size, float2 coord,
                                 float receiver, float steps, float k0, float k1, float k2) {
    bool compared = umbrage_in_filter_domain_shadow(coord, receiver);  // no branch: fetches overlap
    float2 x = compared ? floor(coord * 256.0) - 128.0 : float2(0.0, 0.0);
    float2 texel = floor(x * (1.0 / 256.0));
    float2 s = floor((x - texel * 256.0) * (1.0 / 256.0) * steps);
    float2 r = steps - s;
    float whole = steps * (k0 + k1 + k2 + k1 + k0);
    float2 w0 = floor(r * k0);
    float2 w1 = floor(r * k1 + s * k0);
    float2 w3 = floor(r * k1 + s * k2);
    float2 w4 = floor(r * k0 + s * k1);
    float2 w5 = floor(s * k0);
    float2 w2 = max(whole - (w0 + w1 + w3 + w4 + w5), float2(0.0, 0.0));
    float2 first = texel - 2.0;
    float n = 0.0;
    float4 a = umbrage_lit_2x2_shadow(map, map_sampler, size, first + float2(0.0, 0.0), receiver);
    float4 b = umbrage_lit_2x2_shadow(map, map_sampler, size, first + float2(2.0, 0.0), receiver);
    float4 c = umbrage_lit_2x2_shadow(map, map_sampler, size, first + float2(4.0, 0.0), receiver);
    n += w0.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y);
    n += w1.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w);
    a = umbrage_lit_2x2_shadow(map, map_sampler, size, first + float2(0.0, 2.0), receiver);
    b = umbrage_lit_2x2_shadow(map, map_sampler, size, first + float2(2.0, 2.0), receiver);
    c = umbrage_lit_2x2_shadow(map, map_sampler, size, first + float2(4.0, 2.0), receiver);
    n += w2.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y);
    n += w3.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w);
    a = umbrage_lit_2x2_shadow(map, map_sampler, size, first + float2(0.0, 4.0), receiver);
    b = umbrage_lit_2x2_shadow(map, map_sampler, size, first + float2(2.0, 4.0), receiver);
    c = umbrage_lit_2x2_shadow(map, map_sampler, size, first + float2(4.0, 4.0), receiver);
    n += w4.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y);
    n += w5.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w);
    return compared ? n : whole * whole;
}
#endif

#ifndef UMBRAGE_HAS_CASTANO5_SHADOW
#define UMBRAGE_HAS_CASTANO5_SHADOW
// umbrage_castano5_shadow: PCF under 5 x 5 weights, 1 3 4 3 1, that slide over the map
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
float umbrage_castano5_shadow(Texture2D<float> map, SamplerComparisonState map_sampler, float2 size, float2 coord,
                              float receiver) {
    float n = umbrage_window_sum5_shadow(map, map_sampler, size, coord, receiver, 256.0, 1.0, 3.0, 4.0);
    return n < 9437184.0 ? n * (1.0 / 65536.0) * 0.00694444450 : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_WINDOW_SUM7_SHADOW
#define UMBRAGE_HAS_WINDOW_SUM7_SHADOW
// umbrage_window_sum7_shadow: weighted count of the lit texels under a kernel that slides over the map, an integer
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   steps       per texel, a power of two up to 256
//   k0 .. k3    weights from the edge to the middle one. The others mirror them
// Steps times the sum of all weights must be an integer up to 4096. Its square is the count when all is lit
float umbrage_window_sum7_shadow(Texture2D<float> map, SamplerComparisonState map_sampler, float2 size, float2 coord,
                                 float receiver, float steps, float k0, float k1, float k2, float k3) {
    bool compared = umbrage_in_filter_domain_shadow(coord, receiver);  // no branch: fetches overlap
    float2 x = compared ? floor(coord * 256.0) - 128.0 : float2(0.0, 0.0);
    float2 texel = floor(x * (1.0 / 256.0));
    float2 s = floor((x - texel * 256.0) * (1.0 / 256.0) * steps);
    float2 r = steps - s;
    float whole = steps * (k0 + k1 + k2 + k3 + k2 + k1 + k0);
    float2 w0 = floor(r * k0);
    float2 w1 = floor(r * k1 + s * k0);
    float2 w2 = floor(r * k2 + s * k1);
    float2 w4 = floor(r * k2 + s * k3);
    float2 w5 = floor(r * k1 + s * k2);
    float2 w6 = floor(r * k0 + s * k1);
    float2 w7 = floor(s * k0);
    float2 w3 = max(whole - (w0 + w1 + w2 + w4 + w5 + w6 + w7), float2(0.0, 0.0));
    float2 first = texel - 3.0;
    float n = 0.0;
    float4 a = umbrage_lit_2x2_shadow(map, map_sampler, size, first + float2(0.0, 0.0), receiver);
    float4 b = umbrage_lit_2x2_shadow(map, map_sampler, size, first + float2(2.0, 0.0), receiver);
    float4 c = umbrage_lit_2x2_shadow(map, map_sampler, size, first + float2(4.0, 0.0), receiver);
    float4 d = umbrage_lit_2x2_shadow(map, map_sampler, size, first + float2(6.0, 0.0), receiver);
    n += w0.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y + w6.x * d.x + w7.x * d.y);
    n += w1.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w + w6.x * d.z + w7.x * d.w);
    a = umbrage_lit_2x2_shadow(map, map_sampler, size, first + float2(0.0, 2.0), receiver);
    b = umbrage_lit_2x2_shadow(map, map_sampler, size, first + float2(2.0, 2.0), receiver);
    c = umbrage_lit_2x2_shadow(map, map_sampler, size, first + float2(4.0, 2.0), receiver);
    d = umbrage_lit_2x2_shadow(map, map_sampler, size, first + float2(6.0, 2.0), receiver);
    n += w2.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y + w6.x * d.x + w7.x * d.y);
    n += w3.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w + w6.x * d.z + w7.x * d.w);
    a = umbrage_lit_2x2_shadow(map, map_sampler, size, first + float2(0.0, 4.0), receiver);
    b = umbrage_lit_2x2_shadow(map, map_sampler, size, first + float2(2.0, 4.0), receiver);
    c = umbrage_lit_2x2_shadow(map, map_sampler, size, first + float2(4.0, 4.0), receiver);
    d = umbrage_lit_2x2_shadow(map, map_sampler, size, first + float2(6.0, 4.0), receiver);
    n += w4.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y + w6.x * d.x + w7.x * d.y);
    n += w5.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w + w6.x * d.z + w7.x * d.w);
    a = umbrage_lit_2x2_shadow(map, map_sampler, size, first + float2(0.0, 6.0), receiver);
    b = umbrage_lit_2x2_shadow(map, map_sampler, size, first + float2(2.0, 6.0), receiver);
    c = umbrage_lit_2x2_shadow(map, map_sampler, size, first + float2(4.0, 6.0), receiver);
    d = umbrage_lit_2x2_shadow(map, map_sampler, size, first + float2(6.0, 6.0), receiver);
    n += w6.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x + w3.x * b.y + w4.x * c.x + w5.x * c.y + w6.x * d.x + w7.x * d.y);
    n += w7.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z + w3.x * b.w + w4.x * c.z + w5.x * c.w + w6.x * d.z + w7.x * d.w);
    return compared ? n : whole * whole;
}
#endif

#ifndef UMBRAGE_HAS_CASTANO7_SHADOW
#define UMBRAGE_HAS_CASTANO7_SHADOW
// umbrage_castano7_shadow: PCF under 7 x 7 weights, 1 5 12 16 12 5 1, that slide over the map
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
float umbrage_castano7_shadow(Texture2D<float> map, SamplerComparisonState map_sampler, float2 size, float2 coord,
                              float receiver) {
    float n = umbrage_window_sum7_shadow(map, map_sampler, size, coord, receiver, 64.0, 1.0, 5.0, 12.0, 16.0);
    return n < 11075584.0 ? n * (1.0 / 4096.0) * 0.000369822490 : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_ELLIPSE16_SHADOW
#define UMBRAGE_HAS_ELLIPSE16_SHADOW
// umbrage_ellipse16_shadow: PCF over a rotated ellipse of 16 points. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      along x and y, in 1/16 texel, integers from 0 to 4095
//   rotation    umbrage_disc_rotation of the pixel
float umbrage_ellipse16_shadow(Texture2D<float> map, SamplerComparisonState map_sampler, float2 size, float2 coord,
                               float receiver, float2 radius, float4 rotation) {
    bool compared = umbrage_in_filter_domain_shadow(coord, receiver);
    float2 at = compared ? floor(coord * 256.0) : float2(0.0, 0.0);  // no branch: fetches overlap
    float n = 0.0;
    n +=
        umbrage_lit_shadow(map, map_sampler, size, umbrage_disc_tap(at, float2(1.0, -3.0), rotation, radius), receiver);
    n += umbrage_lit_shadow(map, map_sampler, size, umbrage_disc_tap(at, float2(5.0, 2.0), rotation, radius), receiver);
    n +=
        umbrage_lit_shadow(map, map_sampler, size, umbrage_disc_tap(at, float2(-5.0, 2.0), rotation, radius), receiver);
    n += umbrage_lit_shadow(map, map_sampler, size, umbrage_disc_tap(at, float2(0.0, 7.0), rotation, radius), receiver);
    n +=
        umbrage_lit_shadow(map, map_sampler, size, umbrage_disc_tap(at, float2(-6.0, -5.0), rotation, radius),
                           receiver);
    n +=
        umbrage_lit_shadow(map, map_sampler, size, umbrage_disc_tap(at, float2(8.0, -5.0), rotation, radius), receiver);
    n +=
        umbrage_lit_shadow(map, map_sampler, size, umbrage_disc_tap(at, float2(0.0, -11.0), rotation, radius),
                           receiver);
    n +=
        umbrage_lit_shadow(map, map_sampler, size, umbrage_disc_tap(at, float2(11.0, 5.0), rotation, radius), receiver);
    n +=
        umbrage_lit_shadow(map, map_sampler, size, umbrage_disc_tap(at, float2(-12.0, 4.0), rotation, radius),
                           receiver);
    n +=
        umbrage_lit_shadow(map, map_sampler, size, umbrage_disc_tap(at, float2(-1.0, 13.0), rotation, radius),
                           receiver);
    n +=
        umbrage_lit_shadow(map, map_sampler, size, umbrage_disc_tap(at, float2(7.0, 11.0), rotation, radius), receiver);
    n +=
        umbrage_lit_shadow(map, map_sampler, size, umbrage_disc_tap(at, float2(-9.0, 10.0), rotation, radius),
                           receiver);
    n +=
        umbrage_lit_shadow(map, map_sampler, size, umbrage_disc_tap(at, float2(-13.0, -4.0), rotation, radius),
                           receiver);
    n +=
        umbrage_lit_shadow(map, map_sampler, size, umbrage_disc_tap(at, float2(7.0, -12.0), rotation, radius),
                           receiver);
    n +=
        umbrage_lit_shadow(map, map_sampler, size, umbrage_disc_tap(at, float2(-7.0, -12.0), rotation, radius),
                           receiver);
    n +=
        umbrage_lit_shadow(map, map_sampler, size, umbrage_disc_tap(at, float2(14.0, -2.0), rotation, radius),
                           receiver);
    return compared ? n * (1.0 / 16.0) : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_DISC16_SHADOW
#define UMBRAGE_HAS_DISC16_SHADOW
// umbrage_disc16_shadow: PCF over a rotated disc of 16 points. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
float umbrage_disc16_shadow(Texture2D<float> map, SamplerComparisonState map_sampler, float2 size, float2 coord,
                            float receiver, float radius, float4 rotation) {
    float rho = umbrage_disc_radius(radius);
    return umbrage_ellipse16_shadow(map, map_sampler, size, coord, receiver, float2(rho, rho), rotation);
}
#endif

#ifndef UMBRAGE_HAS_WITHIN_FAR_PLANE_SHADOW
#define UMBRAGE_HAS_WITHIN_FAR_PLANE_SHADOW
// umbrage_within_far_plane_shadow: true if a receiver is a number and not beyond the far plane
precise bool umbrage_within_far_plane_shadow(float receiver) {
    return receiver <= 1.0;
}
#endif

#ifndef UMBRAGE_HAS_COVERED_SHADOW
#define UMBRAGE_HAS_COVERED_SHADOW
// umbrage_covered_shadow: share of the texels around a point that lie in the map, along each axis
//   uv   over the map, (0.0, 0.0) to (1.0, 1.0)
float2 umbrage_covered_shadow(float2 size, float2 uv) {
    return clamp((0.5 + size * 0.5) - abs(uv - 0.5) * size, float2(0.0, 0.0), float2(1.0, 1.0));
}
#endif

#ifndef UMBRAGE_HAS_LIT_BETWEEN_SHADOW
#define UMBRAGE_HAS_LIT_BETWEEN_SHADOW
// umbrage_lit_between_shadow: 2x2 comparisons around a point, weighted by the sampler
//   uv         over the map, (0.0, 0.0) to (1.0, 1.0)
//   receiver   no NaN
float umbrage_lit_between_shadow(Texture2D<float> map, SamplerComparisonState map_sampler, float2 size, float2 uv,
                                 float2 way, float receiver) {
    return map.SampleCmpLevelZero(map_sampler, uv, receiver);
}
#endif

#ifndef UMBRAGE_HAS_LIT_AT_SHADOW
#define UMBRAGE_HAS_LIT_AT_SHADOW
// umbrage_lit_at_shadow: 2x2 comparisons around a point, weighted. Returns visibility, 1.0 = lit
//   uv      over the map, (0.0, 0.0) to (1.0, 1.0), no NaN
//   coord   receiver in texels
float umbrage_lit_at_shadow(Texture2D<float> map, SamplerComparisonState map_sampler, float2 size, float2 uv,
                            float2 coord, float receiver) {
    float2 way = floor(uv * size + 0.5) - coord;
    float2 inside = umbrage_covered_shadow(size, uv);
    float lit = umbrage_lit_between_shadow(map, map_sampler, size, uv, way, receiver);
    return 1.0 + inside.x * inside.y * (lit - 1.0);  // texels outside are lit
}
#endif

#ifndef UMBRAGE_HAS_PCF_2X2_HARDWARE_SHADOW
#define UMBRAGE_HAS_PCF_2X2_HARDWARE_SHADOW
// umbrage_pcf_2x2_hardware_shadow: bilinear 2x2 PCF by the sampler. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
float umbrage_pcf_2x2_hardware_shadow(Texture2D<float> map, SamplerComparisonState map_sampler, float2 size,
                                      float2 coord, float receiver) {
    bool compared = umbrage_in_filter_domain_shadow(coord, receiver);
    float2 at = compared ? coord : float2(0.0, 0.0);
    float lit = umbrage_lit_at_shadow(map, map_sampler, size, at / size, at, receiver);
    float visibility = umbrage_within_far_plane_shadow(receiver) ? lit : 0.0;
    return compared ? visibility : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_WINDOW_HARDWARE3_SHADOW
#define UMBRAGE_HAS_WINDOW_HARDWARE3_SHADOW
// umbrage_window_hardware3_shadow: PCF under a kernel that slides over the map, by the sampler
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   k0 .. k1    weights from the edge to the middle one. The others mirror them
float umbrage_window_hardware3_shadow(Texture2D<float> map, SamplerComparisonState map_sampler, float2 size,
                                      float2 coord, float receiver, float k0, float k1) {
    bool compared = umbrage_in_filter_domain_shadow(coord, receiver);
    float2 x = compared ? coord - 0.5 : float2(0.0, 0.0);
    float2 texel = floor(x);
    float2 s = x - texel;
    float whole = k0 + k1 + k0;
    float2 w0 = k0 + k1 + s * -k1;
    float2 p0 = (texel + (-k0 * 0.5 + k1 * 0.5 + s * (k0 - k1 * 0.5)) / w0) / size;
    float2 v0 = w0 * umbrage_covered_shadow(size, p0);
    float2 w1 = k0 + s * k1;
    float2 p1 = (texel + (k0 * 1.5 + s * (k0 + k1 * 1.5)) / w1) / size;
    float2 v1 = w1 * umbrage_covered_shadow(size, p1);
    float2 inside = v0 + v1;
    // ... - s: from the receiver to where the four texels of a fetch meet
    float n = 0.0;
    float row = 0.0;
    row += v0.x *
        umbrage_lit_between_shadow(map, map_sampler, size, float2(p0.x, p0.y), float2(-0.5, -0.5) - s, receiver);
    row += v1.x *
        umbrage_lit_between_shadow(map, map_sampler, size, float2(p1.x, p0.y), float2(1.5, -0.5) - s, receiver);
    n += v0.y * row;
    row = 0.0;
    row += v0.x *
        umbrage_lit_between_shadow(map, map_sampler, size, float2(p0.x, p1.y), float2(-0.5, 1.5) - s, receiver);
    row += v1.x *
        umbrage_lit_between_shadow(map, map_sampler, size, float2(p1.x, p1.y), float2(1.5, 1.5) - s, receiver);
    n += v1.y * row;
    n += whole * whole - inside.x * inside.y;  // texels outside are lit
    float share = clamp(n / (whole * whole), 0.0, 1.0);
    float visibility = umbrage_within_far_plane_shadow(receiver) ? share : 0.0;
    return compared ? visibility : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_WINDOW_HARDWARE5_SHADOW
#define UMBRAGE_HAS_WINDOW_HARDWARE5_SHADOW
// umbrage_window_hardware5_shadow: PCF under a kernel that slides over the map, by the sampler
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   k0 .. k2    weights from the edge to the middle one. The others mirror them
float umbrage_window_hardware5_shadow(Texture2D<float> map, SamplerComparisonState map_sampler, float2 size,
                                      float2 coord, float receiver, float k0, float k1, float k2) {
    bool compared = umbrage_in_filter_domain_shadow(coord, receiver);
    float2 x = compared ? coord - 0.5 : float2(0.0, 0.0);
    float2 texel = floor(x);
    float2 s = x - texel;
    float whole = k0 + k1 + k2 + k1 + k0;
    float2 w0 = k0 + k1 + s * -k1;
    float2 p0 = (texel + (-k0 * 1.5 - k1 * 0.5 + s * (k0 + k1 * 0.5)) / w0) / size;
    float2 v0 = w0 * umbrage_covered_shadow(size, p0);
    float2 w1 = float2(k1 + k2, k1 + k2);
    float2 p1 = (texel + (k1 * 1.5 + k2 * 0.5 + s * (-k1 + k2)) / w1) / size;
    float2 v1 = w1 * umbrage_covered_shadow(size, p1);
    float2 w2 = k0 + s * k1;
    float2 p2 = (texel + (k0 * 2.5 + s * (k0 + k1 * 2.5)) / w2) / size;
    float2 v2 = w2 * umbrage_covered_shadow(size, p2);
    float2 inside = v0 + v1 + v2;
    // ... - s: from the receiver to where the four texels of a fetch meet
    float n = 0.0;
    float row = 0.0;
    row += v0.x *
        umbrage_lit_between_shadow(map, map_sampler, size, float2(p0.x, p0.y), float2(-1.5, -1.5) - s, receiver);
    row += v1.x *
        umbrage_lit_between_shadow(map, map_sampler, size, float2(p1.x, p0.y), float2(0.5, -1.5) - s, receiver);
    row += v2.x *
        umbrage_lit_between_shadow(map, map_sampler, size, float2(p2.x, p0.y), float2(2.5, -1.5) - s, receiver);
    n += v0.y * row;
    row = 0.0;
    row += v0.x *
        umbrage_lit_between_shadow(map, map_sampler, size, float2(p0.x, p1.y), float2(-1.5, 0.5) - s, receiver);
    row += v1.x *
        umbrage_lit_between_shadow(map, map_sampler, size, float2(p1.x, p1.y), float2(0.5, 0.5) - s, receiver);
    row += v2.x *
        umbrage_lit_between_shadow(map, map_sampler, size, float2(p2.x, p1.y), float2(2.5, 0.5) - s, receiver);
    n += v1.y * row;
    row = 0.0;
    row += v0.x *
        umbrage_lit_between_shadow(map, map_sampler, size, float2(p0.x, p2.y), float2(-1.5, 2.5) - s, receiver);
    row += v1.x *
        umbrage_lit_between_shadow(map, map_sampler, size, float2(p1.x, p2.y), float2(0.5, 2.5) - s, receiver);
    row += v2.x *
        umbrage_lit_between_shadow(map, map_sampler, size, float2(p2.x, p2.y), float2(2.5, 2.5) - s, receiver);
    n += v2.y * row;
    n += whole * whole - inside.x * inside.y;  // texels outside are lit
    float share = clamp(n / (whole * whole), 0.0, 1.0);
    float visibility = umbrage_within_far_plane_shadow(receiver) ? share : 0.0;
    return compared ? visibility : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_WINDOW_HARDWARE7_SHADOW
#define UMBRAGE_HAS_WINDOW_HARDWARE7_SHADOW
// umbrage_window_hardware7_shadow: PCF under a kernel that slides over the map, by the sampler
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   k0 .. k3    weights from the edge to the middle one. The others mirror them
float umbrage_window_hardware7_shadow(Texture2D<float> map, SamplerComparisonState map_sampler, float2 size,
                                      float2 coord, float receiver, float k0, float k1, float k2, float k3) {
    bool compared = umbrage_in_filter_domain_shadow(coord, receiver);
    float2 x = compared ? coord - 0.5 : float2(0.0, 0.0);
    float2 texel = floor(x);
    float2 s = x - texel;
    float whole = k0 + k1 + k2 + k3 + k2 + k1 + k0;
    float2 w0 = k0 + k1 + s * -k1;
    float2 p0 = (texel + (-k0 * 2.5 - k1 * 1.5 + s * (k0 + k1 * 1.5)) / w0) / size;
    float2 v0 = w0 * umbrage_covered_shadow(size, p0);
    float2 w1 = k2 + k3 + s * (k1 - k3);
    float2 p1 = (texel + (-k2 * 0.5 + k3 * 0.5 + s * (-k1 * 0.5 + k2 - k3 * 0.5)) / w1) / size;
    float2 v1 = w1 * umbrage_covered_shadow(size, p1);
    float2 w2 = k1 + k2 + s * (-k1 + k3);
    float2 p2 = (texel + (k1 * 2.5 + k2 * 1.5 + s * (-k1 * 2.5 + k2 + k3 * 1.5)) / w2) / size;
    float2 v2 = w2 * umbrage_covered_shadow(size, p2);
    float2 w3 = k0 + s * k1;
    float2 p3 = (texel + (k0 * 3.5 + s * (k0 + k1 * 3.5)) / w3) / size;
    float2 v3 = w3 * umbrage_covered_shadow(size, p3);
    float2 inside = v0 + v1 + v2 + v3;
    // ... - s: from the receiver to where the four texels of a fetch meet
    float n = 0.0;
    float row = 0.0;
    row += v0.x *
        umbrage_lit_between_shadow(map, map_sampler, size, float2(p0.x, p0.y), float2(-2.5, -2.5) - s, receiver);
    row += v1.x *
        umbrage_lit_between_shadow(map, map_sampler, size, float2(p1.x, p0.y), float2(-0.5, -2.5) - s, receiver);
    row += v2.x *
        umbrage_lit_between_shadow(map, map_sampler, size, float2(p2.x, p0.y), float2(1.5, -2.5) - s, receiver);
    row += v3.x *
        umbrage_lit_between_shadow(map, map_sampler, size, float2(p3.x, p0.y), float2(3.5, -2.5) - s, receiver);
    n += v0.y * row;
    row = 0.0;
    row += v0.x *
        umbrage_lit_between_shadow(map, map_sampler, size, float2(p0.x, p1.y), float2(-2.5, -0.5) - s, receiver);
    row += v1.x *
        umbrage_lit_between_shadow(map, map_sampler, size, float2(p1.x, p1.y), float2(-0.5, -0.5) - s, receiver);
    row += v2.x *
        umbrage_lit_between_shadow(map, map_sampler, size, float2(p2.x, p1.y), float2(1.5, -0.5) - s, receiver);
    row += v3.x *
        umbrage_lit_between_shadow(map, map_sampler, size, float2(p3.x, p1.y), float2(3.5, -0.5) - s, receiver);
    n += v1.y * row;
    row = 0.0;
    row += v0.x *
        umbrage_lit_between_shadow(map, map_sampler, size, float2(p0.x, p2.y), float2(-2.5, 1.5) - s, receiver);
    row += v1.x *
        umbrage_lit_between_shadow(map, map_sampler, size, float2(p1.x, p2.y), float2(-0.5, 1.5) - s, receiver);
    row += v2.x *
        umbrage_lit_between_shadow(map, map_sampler, size, float2(p2.x, p2.y), float2(1.5, 1.5) - s, receiver);
    row += v3.x *
        umbrage_lit_between_shadow(map, map_sampler, size, float2(p3.x, p2.y), float2(3.5, 1.5) - s, receiver);
    n += v2.y * row;
    row = 0.0;
    row += v0.x *
        umbrage_lit_between_shadow(map, map_sampler, size, float2(p0.x, p3.y), float2(-2.5, 3.5) - s, receiver);
    row += v1.x *
        umbrage_lit_between_shadow(map, map_sampler, size, float2(p1.x, p3.y), float2(-0.5, 3.5) - s, receiver);
    row += v2.x *
        umbrage_lit_between_shadow(map, map_sampler, size, float2(p2.x, p3.y), float2(1.5, 3.5) - s, receiver);
    row += v3.x *
        umbrage_lit_between_shadow(map, map_sampler, size, float2(p3.x, p3.y), float2(3.5, 3.5) - s, receiver);
    n += v3.y * row;
    n += whole * whole - inside.x * inside.y;  // texels outside are lit
    float share = clamp(n / (whole * whole), 0.0, 1.0);
    float visibility = umbrage_within_far_plane_shadow(receiver) ? share : 0.0;
    return compared ? visibility : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_ELLIPSE_HARDWARE16_SHADOW
#define UMBRAGE_HAS_ELLIPSE_HARDWARE16_SHADOW
// umbrage_ellipse_hardware16_shadow: PCF over 16 points of an ellipse, compared and weighted by the sampler
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      along x and y, in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
float umbrage_ellipse_hardware16_shadow(Texture2D<float> map, SamplerComparisonState map_sampler, float2 size,
                                        float2 coord, float receiver, float2 radius, float4 rotation) {
    bool compared = umbrage_in_filter_domain_shadow(coord, receiver);
    float2 center = (compared ? coord : float2(0.0, 0.0)) / size;
    float wide = radius.x > 0.0 ? min(radius.x, 255.9375) : 0.0;
    float high = radius.y > 0.0 ? min(radius.y, 255.9375) : 0.0;
    float2 part = float2(wide, high) * (1.0 / 1024.0) / size;
    float2 x = float2(rotation.x, rotation.z) * part;
    float2 y = float2(rotation.y, rotation.w) * part;
    float n = 0.0;
    n += umbrage_lit_at_shadow(map, map_sampler, size, center + x * 1.0 - y * 3.0, coord, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center + x * 5.0 + y * 2.0, coord, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center - x * 5.0 + y * 2.0, coord, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center + x * 0.0 + y * 7.0, coord, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center - x * 6.0 - y * 5.0, coord, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center + x * 8.0 - y * 5.0, coord, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center + x * 0.0 - y * 11.0, coord, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center + x * 11.0 + y * 5.0, coord, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center - x * 12.0 + y * 4.0, coord, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center - x * 1.0 + y * 13.0, coord, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center + x * 7.0 + y * 11.0, coord, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center - x * 9.0 + y * 10.0, coord, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center - x * 13.0 - y * 4.0, coord, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center + x * 7.0 - y * 12.0, coord, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center - x * 7.0 - y * 12.0, coord, receiver);
    n += umbrage_lit_at_shadow(map, map_sampler, size, center + x * 14.0 - y * 2.0, coord, receiver);
    float visibility = umbrage_within_far_plane_shadow(receiver) ? n * (1.0 / 16.0) : 0.0;
    return compared ? visibility : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_DISC_HARDWARE16_SHADOW
#define UMBRAGE_HAS_DISC_HARDWARE16_SHADOW
// umbrage_disc_hardware16_shadow: PCF over 16 points of a disc, compared and weighted by the sampler
// Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
float umbrage_disc_hardware16_shadow(Texture2D<float> map, SamplerComparisonState map_sampler, float2 size,
                                     float2 coord, float receiver, float radius, float4 rotation) {
    return umbrage_ellipse_hardware16_shadow(map, map_sampler, size, coord, receiver, float2(radius, radius), rotation);
}
#endif

#ifndef UMBRAGE_HAS_BEYOND_FAR_PLANE_DEPTHS
#define UMBRAGE_HAS_BEYOND_FAR_PLANE_DEPTHS
// umbrage_beyond_far_plane_depths: true if a receiver is beyond the far plane
precise bool umbrage_beyond_far_plane_depths(float receiver) {
    return receiver > 1.0;
}
#endif

#ifndef UMBRAGE_HAS_IN_FILTER_DOMAIN_DEPTHS
#define UMBRAGE_HAS_IN_FILTER_DOMAIN_DEPTHS
// umbrage_in_filter_domain_depths: true if a filter compares; lit outside texel space and beyond the far plane
precise bool umbrage_in_filter_domain_depths(float2 coord, float receiver) {
    // a choice, not a && !b: FXC turns !(receiver > 1.0) into receiver <= 1.0, which loses a NaN
    return umbrage_beyond_far_plane_depths(receiver) ? false : umbrage_inside_texel_space(coord);
}
#endif

#ifndef UMBRAGE_HAS_TEXEL_DEPTHS
#define UMBRAGE_HAS_TEXEL_DEPTHS
// umbrage_texel_depths: value of a texel inside the map
//   map    texture with the texels; a sampler that reads them must filter by nearest
//   size   size of the map, in texels
//   texel  integers, (0, 0) is the first
float4 umbrage_texel_depths(Texture2D<float> map, float2 size, float2 texel) {
    return (float4)map.Load(int3(int2(texel), 0));
}
#endif

#ifndef UMBRAGE_HAS_TEXEL_INSIDE_DEPTHS
#define UMBRAGE_HAS_TEXEL_INSIDE_DEPTHS
// umbrage_texel_inside_depths: texel of the map, itself if the map has it; otherwise any, whose value does not count
float2 umbrage_texel_inside_depths(float2 size, float2 texel) {
    return min(abs(texel), size - 1.0);
}
#endif

#ifndef UMBRAGE_HAS_FETCH_DEPTH_DEPTHS
#define UMBRAGE_HAS_FETCH_DEPTH_DEPTHS
// umbrage_fetch_depth_depths: stored depth of a texel, or the far plane's depth outside the map
float umbrage_fetch_depth_depths(Texture2D<float> map, float2 size, float2 texel) {
    float2 inside = umbrage_texel_inside_depths(size, texel);
    float4 value = umbrage_texel_depths(map, size, inside);
    float depth = value.x;
    return inside.x == texel.x && inside.y == texel.y ? depth : 1.0;
}
#endif

#ifndef UMBRAGE_HAS_DEPTH_AT_DEPTHS
#define UMBRAGE_HAS_DEPTH_AT_DEPTHS
// umbrage_depth_at_depths: stored depth of the texel at a point; on a border it may be the neighbor's
//   uv  point on the map, (0.0, 0.0) to (1.0, 1.0), no NaN
float umbrage_depth_at_depths(Texture2D<float> map, float2 size, float2 uv) {
    return umbrage_fetch_depth_depths(map, size, floor(uv * size));
}
#endif

#ifndef UMBRAGE_HAS_COMPARE_DEPTHS
#define UMBRAGE_HAS_COMPARE_DEPTHS
// umbrage_compare_depths: 1.0 when the receiver is no farther than the stored depth
float umbrage_compare_depths(float receiver, float stored) {
    return receiver <= stored ? 1.0 : 0.0;
}
#endif

#ifndef UMBRAGE_HAS_BLOCKER_AT_DEPTHS
#define UMBRAGE_HAS_BLOCKER_AT_DEPTHS
// umbrage_blocker_at_depths: (1.0, depth) of the texel at a point if it is nearer to the light, else (0.0, 0.0)
//   uv   over the map, (0.0, 0.0) to (1.0, 1.0), no NaN
float2 umbrage_blocker_at_depths(Texture2D<float> map, float2 size, float2 uv, float receiver) {
    float stored = umbrage_depth_at_depths(map, size, uv);
    return umbrage_compare_depths(receiver, stored) > 0.5 ? float2(0.0, 0.0) : float2(1.0, stored);
}
#endif

#ifndef UMBRAGE_HAS_BLOCKERS_HARDWARE16_DEPTHS
#define UMBRAGE_HAS_BLOCKERS_HARDWARE16_DEPTHS
// umbrage_blockers_hardware16_depths: (number of blockers, sum of their depths) at 16 points of an ellipse
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
//   radius      along x and y, in texels, at most 255.9375
//   rotation    umbrage_disc_rotation of the pixel
float2 umbrage_blockers_hardware16_depths(Texture2D<float> map, float2 size, float2 coord, float receiver,
                                          float2 radius, float4 rotation) {
    bool compared = umbrage_in_filter_domain_depths(coord, receiver);
    float2 center = (compared ? coord : float2(0.0, 0.0)) / size;
    float wide = radius.x > 0.0 ? min(radius.x, 255.9375) : 0.0;
    float high = radius.y > 0.0 ? min(radius.y, 255.9375) : 0.0;
    float2 part = float2(wide, high) * (1.0 / 1024.0) / size;
    float2 x = float2(rotation.x, rotation.z) * part;
    float2 y = float2(rotation.y, rotation.w) * part;
    float2 n = float2(0.0, 0.0);
    n += umbrage_blocker_at_depths(map, size, center + x * 1.0 - y * 3.0, receiver);
    n += umbrage_blocker_at_depths(map, size, center + x * 5.0 + y * 2.0, receiver);
    n += umbrage_blocker_at_depths(map, size, center - x * 5.0 + y * 2.0, receiver);
    n += umbrage_blocker_at_depths(map, size, center + x * 0.0 + y * 7.0, receiver);
    n += umbrage_blocker_at_depths(map, size, center - x * 6.0 - y * 5.0, receiver);
    n += umbrage_blocker_at_depths(map, size, center + x * 8.0 - y * 5.0, receiver);
    n += umbrage_blocker_at_depths(map, size, center + x * 0.0 - y * 11.0, receiver);
    n += umbrage_blocker_at_depths(map, size, center + x * 11.0 + y * 5.0, receiver);
    n += umbrage_blocker_at_depths(map, size, center - x * 12.0 + y * 4.0, receiver);
    n += umbrage_blocker_at_depths(map, size, center - x * 1.0 + y * 13.0, receiver);
    n += umbrage_blocker_at_depths(map, size, center + x * 7.0 + y * 11.0, receiver);
    n += umbrage_blocker_at_depths(map, size, center - x * 9.0 + y * 10.0, receiver);
    n += umbrage_blocker_at_depths(map, size, center - x * 13.0 - y * 4.0, receiver);
    n += umbrage_blocker_at_depths(map, size, center + x * 7.0 - y * 12.0, receiver);
    n += umbrage_blocker_at_depths(map, size, center - x * 7.0 - y * 12.0, receiver);
    n += umbrage_blocker_at_depths(map, size, center + x * 14.0 - y * 2.0, receiver);
    return compared ? n : float2(0.0, 0.0);
}
#endif
