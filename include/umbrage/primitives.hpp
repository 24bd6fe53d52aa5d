// SPDX-License-Identifier: MIT
//
// The primitives of umbrage alone, for short compile times. Functions over whole images, the depth pass among them, and
// the texts of snippets come with <umbrage/umbrage.hpp>. Made by single_include/amalgamate.cmake.
#pragma once

#include <umbrage/bias/acne_free.hpp>
#include <umbrage/bias/constant.hpp>
#include <umbrage/bias/kernel.hpp>
#include <umbrage/bias/light_units.hpp>
#include <umbrage/bias/normal_offset.hpp>
#include <umbrage/bias/rasterizer.hpp>
#include <umbrage/bias/receiver_plane.hpp>
#include <umbrage/bias/slope.hpp>
#include <umbrage/clip_space.hpp>
#include <umbrage/compare.hpp>
#include <umbrage/config.hpp>
#include <umbrage/depth/code.hpp>
#include <umbrage/depth/depth32f.hpp>
#include <umbrage/depth/encoding.hpp>
#include <umbrage/depth/encodings.hpp>
#include <umbrage/depth/float_bits.hpp>
#include <umbrage/depth/foreign/base255.hpp>
#include <umbrage/depth/foreign/ps14.hpp>
#include <umbrage/depth/foreign/threejs.hpp>
#include <umbrage/depth/foreign/threejs_legacy.hpp>
#include <umbrage/depth/kinds.hpp>
#include <umbrage/depth/rg.hpp>
#include <umbrage/depth/rg_level.hpp>
#include <umbrage/depth/rg_table.hpp>
#include <umbrage/depth/rgb24.hpp>
#include <umbrage/filter/filter.hpp>
#include <umbrage/filter/pcf/box.hpp>
#include <umbrage/filter/pcf/disc.hpp>
#include <umbrage/filter/pcf/four_tap.hpp>
#include <umbrage/filter/pcf/hard.hpp>
#include <umbrage/filter/pcf/pcf_2x2.hpp>
#include <umbrage/filter/pcf/pcf_2x2_hardware.hpp>
#include <umbrage/filter/pcf/window.hpp>
#include <umbrage/filter/pcf/window_hardware.hpp>
#include <umbrage/filter/pcf/windows.hpp>
#include <umbrage/filter/texel_space.hpp>
#include <umbrage/image.hpp>
#include <umbrage/light/bounds.hpp>
#include <umbrage/light/cube_map.hpp>
#include <umbrage/light/directional_fit.hpp>
#include <umbrage/light/directional_light.hpp>
#include <umbrage/light/light_space.hpp>
#include <umbrage/light/spot_light.hpp>
#include <umbrage/light/sweep.hpp>
#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/list.hpp>
#include <umbrage/scalar.hpp>
#include <umbrage/shade/lighting.hpp>
#include <umbrage/unorm.hpp>
#include <umbrage/version.hpp>
#include <umbrage/view/false_colour.hpp>
#include <umbrage/view/overlay_texel.hpp>
