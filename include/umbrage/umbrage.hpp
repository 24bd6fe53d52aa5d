// SPDX-License-Identifier: MIT
//
// All of umbrage: the primitives, functions over whole images, the texts of snippets. Includes only.
#pragma once

#include <umbrage/primitives.hpp>

#include <umbrage/debug/overlay.hpp>
#include <umbrage/draw/dual_paraboloid_pass.hpp>
#include <umbrage/draw/instances.hpp>
#include <umbrage/draw/mesh.hpp>
#include <umbrage/draw/rasterize.hpp>
#include <umbrage/draw/tessellate.hpp>
#include <umbrage/draw/tetrahedron_pass.hpp>
#include <umbrage/filter/filters.hpp>
#include <umbrage/images/blur.hpp>
#include <umbrage/images/depth_span.hpp>
#include <umbrage/images/encode.hpp>
#include <umbrage/images/filter_bounds.hpp>
#include <umbrage/images/min_max.hpp>
#include <umbrage/images/moment_table.hpp>
#include <umbrage/images/page_atlas.hpp>
#include <umbrage/images/plane_visibility.hpp>
#include <umbrage/images/prefilter.hpp>
#include <umbrage/images/summed_area.hpp>
#include <umbrage/images/variance_table.hpp>
#include <umbrage/images/visibility.hpp>
#include <umbrage/light/adaptive/pages.hpp>
#include <umbrage/light/adaptive/root.hpp>
#include <umbrage/light/bounds.hpp>
#include <umbrage/light/cascades/cascades.hpp>
#include <umbrage/light/cascades/warped.hpp>
#include <umbrage/light/directional_fit.hpp>
#include <umbrage/light/light_choice.hpp>
#include <umbrage/light/pixels_per_texel.hpp>
#include <umbrage/light/spot_fit.hpp>
#include <umbrage/light/sweep.hpp>
#include <umbrage/light/warp/light_position.hpp>
#include <umbrage/light/warp/light_space_perspective.hpp>
#include <umbrage/light/warp/perspective.hpp>
#include <umbrage/light/warp/plane_optimal.hpp>
#include <umbrage/light/warp/trapezoidal.hpp>
#include <umbrage/light/warp/warp_fit.hpp>
#include <umbrage/registry.hpp>
#include <umbrage/shader/glsl.hpp>
#include <umbrage/shader/hlsl.hpp>
#include <umbrage/shader/msl.hpp>
#include <umbrage/shader/wgsl.hpp>
#include <umbrage/shadow/adaptive_maps.hpp>
#include <umbrage/shadow/cascaded_maps.hpp>
#include <umbrage/shadow/cube_maps.hpp>
#include <umbrage/shadow/depth_pass.hpp>
#include <umbrage/shadow/in_shader.hpp>
#include <umbrage/shadow/paraboloid_maps.hpp>
#include <umbrage/shadow/shadow.hpp>
#include <umbrage/shadow/single_map.hpp>
#include <umbrage/shadow/tetrahedron_map.hpp>
#include <umbrage/shadow/warped_maps.hpp>
