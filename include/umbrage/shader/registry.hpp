// SPDX-License-Identifier: MIT
//
// Every snippet there is, in the order of the data's way: what tests, tables and tools walk through.
//
//     for (const umbrage::glsl::snippet* s : umbrage::glsl::registry) std::puts(umbrage::glsl::text({*s}).c_str());
//
#pragma once

#include <array>

#include <umbrage/compare.hpp>
#include <umbrage/depth/foreign/base255.hpp>
#include <umbrage/depth/float_bits.hpp>
#include <umbrage/depth/kinds.hpp>
#include <umbrage/depth/foreign/ps14.hpp>
#include <umbrage/depth/rg.hpp>
#include <umbrage/depth/rg_level.hpp>
#include <umbrage/depth/rg_table.hpp>
#include <umbrage/depth/rgb24.hpp>
#include <umbrage/depth/foreign/threejs.hpp>
#include <umbrage/filter/pcf/box.hpp>
#include <umbrage/filter/pcf/four_tap.hpp>
#include <umbrage/filter/pcf/hard.hpp>
#include <umbrage/filter/pcf/pcf_2x2.hpp>
#include <umbrage/image.hpp>
#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/shade/lighting.hpp>
#include <umbrage/unorm.hpp>
#include <umbrage/view/false_colour.hpp>

namespace umbrage::glsl {

inline constexpr std::array registry{
    // vertex side
    &shadow_coordinate, &tap_coordinate, &project_coordinate,
    // kinds of depth
    &linear_depth, &project_depth, &distance_depth, &reverse_depth, &depth_from_ndc, &view_z_from_depth,
    &depth_from_view_z,
    // encodings
    &saturate, &to_unorm, &from_unorm,
    &encode_rg<9>, &encode_rg<10>, &encode_rg<11>, &encode_rg<12>, &encode_rg<13>, &encode_rg<14>, &encode_rg<15>,
    &encode_rg<16>,
    &encode_rg_table<9>, &encode_rg_table<10>, &encode_rg_table<11>, &encode_rg_table<12>, &encode_rg_table<13>,
    &encode_rg_table<14>, &encode_rg_table<15>, &encode_rg_table<16>,
    &decode_rg<9>, &decode_rg<10>, &decode_rg<11>, &decode_rg<12>, &decode_rg<13>, &decode_rg<14>, &decode_rg<15>,
    &decode_rg<16>,
    &level_rg<9>, &level_rg<10>, &level_rg<11>, &level_rg<12>, &level_rg<13>, &level_rg<14>, &level_rg<15>,
    &level_rg<16>,
    &receiver_rg<9>, &receiver_rg<10>, &receiver_rg<11>, &receiver_rg<12>, &receiver_rg<13>, &receiver_rg<14>,
    &receiver_rg<15>, &receiver_rg<16>,
    &decode_ps14, &receiver_ps14,
    &encode_rgb24, &decode_rgb24,
    &encode_float_bits, &decode_float_bits,
    &write_threejs_rgba, &decode_threejs_rgba, &write_threejs_rgb, &decode_threejs_rgb, &write_threejs_rg, &decode_threejs_rg,
    &write_threejs_legacy, &encode_threejs_legacy_repaired, &decode_threejs_legacy,
    &write_base255, &encode_base255_repaired, &decode_base255,
    // fetch, compare, filter
    &fetch_clamped, &fetch_bordered, &fetch_depth, &inside_texel_space, &compare, &compare_dx_sdk, &compare_exercise,
    &hard, &four_tap, &pcf_2x2, &pcf_2x2_dx_sdk, &box_count, &box_scale, &box,
    // shade, view
    &spot_cone, &diffuse_ambient, &false_colour};

}  // namespace umbrage::glsl
