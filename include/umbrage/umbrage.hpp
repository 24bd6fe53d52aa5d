// SPDX-License-Identifier: MIT
//
// All of umbrage. Includes only; each header also stands alone.
#pragma once

#include <umbrage/clip_space.hpp>
#include <umbrage/glsl.hpp>
#include <umbrage/image.hpp>
#include <umbrage/scalar.hpp>
#include <umbrage/unorm.hpp>
#include <umbrage/version.hpp>
#include <umbrage/image_ops/clip.hpp>
#include <umbrage/image_ops/rasterize.hpp>
