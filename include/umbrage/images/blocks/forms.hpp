// SPDX-License-Identifier: MIT
//
// List of every filter's fast form over images. `visibility()` finds them by the filter's type.
//
#pragma once

#include <umbrage/images/blocks/box.hpp>
#include <umbrage/images/blocks/disc.hpp>
#include <umbrage/images/blocks/four_tap.hpp>
#include <umbrage/images/blocks/hard.hpp>
#include <umbrage/images/blocks/hierarchical.hpp>
#include <umbrage/images/blocks/pcf_2x2.hpp>
#include <umbrage/images/blocks/soft.hpp>
#include <umbrage/images/blocks/window.hpp>
