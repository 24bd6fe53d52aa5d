// SPDX-License-Identifier: MIT
//
// The form of a filter for blocks of 64 receivers: what visibility() runs where a filter has one. A filter that has
// none is called receiver by receiver.
//
// A form states what it needs of a map and the smallest width and height that it can take. blocks() makes its blocks,
// of a map, a filter and tables() that these look things up in. Where a form needs texels, the map is float_texels or
// rg_texels, as it is stored; where it needs floats, float_texels. A form clamps texels to the map's edge; visibility()
// filters again what may lie outside a bordered map, by the filter's reach(). A form may name another, by_bounds, which
// runs where bounds_pay(): see hierarchical.hpp.
//
// Blocks work in two steps, some blocks apart, so that texels have come from memory when they are needed: place() says
// where to look and prefetches it; the second step loads it, compares and weighs. A place() with a third argument gets
// the row of pixels that the block lies in; its column is a multiple of 64. `count` receivers of a block are there:
// loops go to `block` all the same, a number that compilers vectorise by, and what the rest gives is ignored. `Isa` is
// the instruction set that the code is compiled for. Every function and lambda of it is UMBRAGE_INLINE: dispatch.hpp
// says why.
//
// Blocks that leave work for later have a type `tile` with a number `rows`. They come tile by tile, so many above each
// other; the second step gets the tile besides, and finish(tile, set) is called behind its last block, before results
// are taken. hierarchical.hpp does so.
//
// unit/images/blocks/form and form/coherent hold each form to its filter, bit by bit.
//
//     template <>
//     struct block_form<filters::pcf_2x2> : without_tables {
//         static constexpr map_need need = map_need::texels;
//         static constexpr int least = 2;
//         template <depth_direction Direction, class Map>
//         static pcf_2x2_blocks<Direction, Map> blocks(const Map& map, const filters::pcf_2x2&, no_tables) {
//             return {map};
//         }
//     };
//
#pragma once

namespace umbrage::detail {

/// What the blocks of a filter read.
enum class map_need {
    texels,  ///< a few texels a receiver: as they are stored, where that has a fast form, or floats
    floats,  ///< many: decoding each for each receiver would cost more than decoding the map once
};

template <class Filter>
struct block_form;

/// The form of a filter that compares every texel, where hierarchical.hpp has another beside it.
template <class Filter>
struct every_texel_form;

/// Base of forms whose blocks look nothing up in tables.
struct no_tables {};
struct without_tables {
    template <class Filter, class ParallelFor>
    [[nodiscard]] static no_tables tables(const auto&, const Filter&, ParallelFor&&) {
        return {};
    }
};

/// Of blocks that leave nothing for later: a row.
struct one_row {
    static constexpr int rows = 1;
};
template <class Blocks>
struct tile_of {
    using type = one_row;
};
template <class Blocks>
requires requires { typename Blocks::tile; }
struct tile_of<Blocks> {
    using type = typename Blocks::tile;
};

template <class Filter>
concept has_block_form = requires {
    block_form<Filter>::need;
};

}  // namespace umbrage::detail
