// SPDX-License-Identifier: MIT
//
// List of every encoding in this library, for tools, tables, proofs and examples.
//
//     umbrage::for_each_encoding([](auto encoding) { std::puts(encoding.name.data()); });
//     bool found = umbrage::with_encoding("rg11", [&](auto encoding) { umbrage::encode(depth, map, encoding); });
//
#pragma once

#include <string_view>

#include <umbrage/core/list.hpp>
#include <umbrage/depth/depth16.hpp>
#include <umbrage/depth/depth24.hpp>
#include <umbrage/depth/depth32f.hpp>
#include <umbrage/depth/encoding.hpp>
#include <umbrage/depth/float_bits.hpp>
#include <umbrage/depth/foreign/base255.hpp>
#include <umbrage/depth/foreign/threejs.hpp>
#include <umbrage/depth/foreign/threejs_legacy.hpp>
#include <umbrage/depth/r16.hpp>
#include <umbrage/depth/rg.hpp>
#include <umbrage/depth/rgb10.hpp>
#include <umbrage/depth/rgb24.hpp>

namespace umbrage {

/// List of all encodings.
using encodings = list_of<depth32f, depth24, depth16, rg<9>, rg<10>, rg<11>, rg<12>, rg<13>, rg<14>, rg<15>, rg<16>,
                          rgb24, rgb10, r16, float_bits, threejs_rgba, threejs_rgb, threejs_rg, threejs_legacy,
                          threejs_legacy_repaired, base255, base255_repaired>;

/// Calls use(encoding) once for each encoding of the list, in order.
template <class Use>
constexpr void for_each_encoding(Use&& use) {
    encodings::for_each(use);
}

/// Calls use(encoding) with the encoding of that name.
/// @return   false when no encoding has that name
template <class Use>
constexpr bool with_encoding(std::string_view name, Use&& use) {
    return encodings::with(name, use);
}

}  // namespace umbrage
