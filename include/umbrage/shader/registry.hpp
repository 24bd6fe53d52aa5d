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
#include <umbrage/depth/encodings.hpp>
#include <umbrage/depth/foreign/ps14.hpp>
#include <umbrage/depth/kinds.hpp>
#include <umbrage/depth/rg_level.hpp>
#include <umbrage/depth/rg_table.hpp>
#include <umbrage/filter/filters.hpp>
#include <umbrage/filter/texel_space.hpp>
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
        for (const snippet* s : some)
            if (s) all.add(s);
    };
    (add(lists), ...);
    return all;
}

inline constexpr collection everything = collect(
    // light
    texture_matrix_snippets,
    // depth
    kinds_snippets, scalar_snippets, unorm_snippets,
    encoding_snippets, rg_table_snippets, rg_level_snippets, ps14_snippets,
    // maps and filters
    image_snippets, texel_space_snippets, compare_snippets, filter_snippets,
    // shade, view
    lighting_snippets, false_colour_snippets);

}  // namespace detail

inline constexpr auto registry = [] {
    std::array<const snippet*, detail::everything.size> all{};
    std::copy_n(detail::everything.members.begin(), all.size(), all.begin());
    return all;
}();

}  // namespace umbrage::glsl
