// SPDX-License-Identifier: MIT
//
// All of umbrage: the primitives, functions over whole images, the registry of snippets. Includes only.
#pragma once

#include <umbrage/umbrage.hpp>

#include <umbrage/image_ops/blur.hpp>
#include <umbrage/image_ops/box_blocks.hpp>
#include <umbrage/image_ops/clip.hpp>
#include <umbrage/image_ops/encode.hpp>
#include <umbrage/image_ops/filters.hpp>
#include <umbrage/image_ops/hierarchical.hpp>
#include <umbrage/image_ops/isa.hpp>
#include <umbrage/image_ops/parallel.hpp>
#include <umbrage/image_ops/projected_mesh.hpp>
#include <umbrage/image_ops/pyramid.hpp>
#include <umbrage/image_ops/rasterize.hpp>
#include <umbrage/image_ops/strict_math.hpp>
#include <umbrage/image_ops/summed_area.hpp>
#include <umbrage/image_ops/triangle_batch.hpp>
#include <umbrage/image_ops/visibility.hpp>
#include <umbrage/image_ops/visibility_blocks.hpp>
#include <umbrage/view/overlay.hpp>
#include <umbrage/registry.hpp>
