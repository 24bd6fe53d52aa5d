// SPDX-License-Identifier: MIT
//
// Fast form of a filter, for blocks of 64 receivers. `visibility()` uses it where a filter has one, and calls other
// filters receiver by receiver.
//
// A form is a `plain_form`, or a form `without_tables`. It states its needs of a map, and the smallest width and height
// that it accepts. `blocks()` makes its blocks from a map, a filter and `tables()`. A form that needs texels gets the
// map as stored: `float_texels` or `rg_texels`. A form that needs floats gets `float_texels`. A form clamps texels to
// the map's edge. `visibility()` filters receivers within `reach()` of a bordered map's border again. A form may name
// another, `by_bounds`, which runs where `bounds_pay()`: see hierarchical.hpp.
//
// Blocks work in two steps, some blocks apart, so that texels have arrived from memory when they are needed. `place()`
// finds the texels and prefetches them. The second step loads, compares and weights them. A `place()` with a third
// argument gets the row of pixels of the block. Its column is a multiple of 64. A block has `count` receivers. Loops
// run to `block` nevertheless, a constant by which compilers vectorize, and results of the rest are ignored. `Isa` is
// the instruction set for which the code is compiled. All its functions and lambdas are UMBRAGE_INLINE: see
// dispatch.hpp.
//
// Blocks that leave work for later have a type `tile` with a number `rows`. They come tile by tile, that many rows
// above each other. The second step also gets the tile. finish(tile, set) is called after its last block, before
// results are taken. hierarchical.hpp does so.
//
// Tests: proof/blocks/every_path and coherent compare each form with its filter, bit by bit.
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

/// Map that the blocks of a filter read.
enum class map_need {
    texels,  ///< few texels per receiver: stored texels where a fast form reads them, else floats
    floats,  ///< many texels: decoding each per receiver would cost more than decoding the map once
};

template <class Filter>
struct block_form;

/// Form of a filter that compares every texel. hierarchical.hpp adds another one.
template <class Filter>
struct every_texel_form;

/// Base of every form, with the defaults of its members.
struct plain_form {
    using by_bounds = void;                ///< form that runs where bounds_pay(); void: none
    static constexpr bool rounds = false;  ///< true where results round, so that no product may be fused with a sum
};

/// Base of forms whose blocks use no tables.
struct no_tables {};
struct without_tables : plain_form {
    template <class Filter, class ParallelFor>
    [[nodiscard]] static no_tables tables(const auto&, const Filter&, ParallelFor&&) {
        return {};
    }
};

/// Tile of blocks that leave nothing for later: one row.
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
