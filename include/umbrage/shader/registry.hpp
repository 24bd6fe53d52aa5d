// SPDX-License-Identifier: MIT
//
// Every snippet there is, in the order of the data's way: what tests, tables and tools walk through.
//
//     for (const umbrage::glsl::snippet* s : umbrage::glsl::registry) std::puts(umbrage::glsl::text({*s}).c_str());
//
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include <umbrage/compare.hpp>
#include <umbrage/depth/float_bits.hpp>
#include <umbrage/depth/foreign/base255.hpp>
#include <umbrage/depth/foreign/ps14.hpp>
#include <umbrage/depth/foreign/threejs.hpp>
#include <umbrage/depth/kinds.hpp>
#include <umbrage/depth/rg.hpp>
#include <umbrage/depth/rg_level.hpp>
#include <umbrage/depth/rg_table.hpp>
#include <umbrage/depth/rgb24.hpp>
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

namespace detail {

/// Snippets in order, each once, what it needs before it.
struct collection {
    std::array<const snippet*, 512> members{};
    std::size_t size = 0;

    constexpr void add(const snippet* s) {
        for (std::size_t i = 0; i < size; ++i)
            if (members[i] == s) return;
        for (const snippet* need : s->needs) add(need);
        members[size++] = s;
    }
};

template <class... Lists>
constexpr collection collect(const Lists&... lists) {
    collection all;
    const auto add = [&](const auto& some) {
        for (const snippet* s : some) all.add(s);
    };
    (add(lists), ...);
    return all;
}

inline constexpr collection everything = collect(
    // light
    texture_matrix_snippets,
    // depth
    kinds_snippets, scalar_snippets, unorm_snippets,
    list<&encode_rg<9>, &encode_rg<10>, &encode_rg<11>, &encode_rg<12>, &encode_rg<13>, &encode_rg<14>, &encode_rg<15>,
         &encode_rg<16>>,
    rg_table_snippets,
    list<&decode_rg<9>, &decode_rg<10>, &decode_rg<11>, &decode_rg<12>, &decode_rg<13>, &decode_rg<14>, &decode_rg<15>,
         &decode_rg<16>>,
    rg_level_snippets, ps14_snippets, list<&encode_rgb24, &decode_rgb24>, list<&encode_float_bits, &decode_float_bits>,
    list<&write_threejs_rgba, &decode_threejs_rgba, &write_threejs_rgb, &decode_threejs_rgb, &write_threejs_rg,
         &decode_threejs_rg, &write_threejs_legacy, &encode_threejs_legacy_repaired, &decode_threejs_legacy>,
    list<&write_base255, &encode_base255_repaired, &decode_base255>,
    // maps and filters
    image_snippets, texel_space_snippets, compare_snippets, list<&hard, &four_tap, &pcf_2x2, &pcf_2x2_dx_sdk, &box>,
    // shade, view
    lighting_snippets, false_colour_snippets);

}  // namespace detail

inline constexpr auto registry = [] {
    std::array<const snippet*, detail::everything.size> all{};
    std::copy_n(detail::everything.members.begin(), all.size(), all.begin());
    return all;
}();

}  // namespace umbrage::glsl
