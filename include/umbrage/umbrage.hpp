// SPDX-License-Identifier: MIT
//
// All primitives of umbrage. Includes only; each header also stands alone. Functions over whole images, the depth pass
// among them, and the registry of snippets are in <umbrage/images.hpp>: who needs none of them does not compile them.
#pragma once

#include <umbrage/clip_space.hpp>
#include <umbrage/compare.hpp>
#include <umbrage/glsl.hpp>
#include <umbrage/image.hpp>
#include <umbrage/scalar.hpp>
#include <umbrage/unorm.hpp>
#include <umbrage/version.hpp>
#include <umbrage/depth/aras.hpp>
#include <umbrage/depth/code.hpp>
#include <umbrage/depth/float_bits.hpp>
#include <umbrage/depth/linear.hpp>
#include <umbrage/depth/ps14.hpp>
#include <umbrage/depth/rg.hpp>
#include <umbrage/depth/rg_level.hpp>
#include <umbrage/depth/rg_table.hpp>
#include <umbrage/depth/rgb24.hpp>
#include <umbrage/depth/three.hpp>
#include <umbrage/filter/box.hpp>
#include <umbrage/filter/four_tap.hpp>
#include <umbrage/filter/hard.hpp>
#include <umbrage/filter/pcf_2x2.hpp>
#include <umbrage/filter/texel_space.hpp>
#include <umbrage/light/directional_light.hpp>
#include <umbrage/light/light_space.hpp>
#include <umbrage/light/spot_light.hpp>
#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/shade/lighting.hpp>
#include <umbrage/view/false_colour.hpp>
