// SPDX-License-Identifier: MIT
//
// Filters whose evaluation over images the caller chooses: visibility() by itself takes what is faster.
//
//     umbrage::visibility(map, encoding, receivers, forced::by_bounds{umbrage::filters::box{8}}, out);
//
#pragma once

#include <umbrage/images/blocks/forms.hpp>

namespace forced {

template <class Filter>
struct every_texel : Filter {};
template <class Filter>
every_texel(Filter) -> every_texel<Filter>;

template <class Filter>
struct by_bounds : Filter {};
template <class Filter>
by_bounds(Filter) -> by_bounds<Filter>;

/// Calls use(filter) with a filter in each evaluation that it has.
template <class Filter, class Use>
void each_evaluation(const Filter& filter, Use&& use) {
    if constexpr (requires { umbrage::detail::every_texel_form<Filter>::need; }) {
        use(every_texel{filter});
        use(by_bounds{filter});
    } else use(filter);
}

}  // namespace forced

namespace umbrage::detail {

template <class Filter>
struct block_form<forced::every_texel<Filter>> : every_texel_form<Filter> {};
template <class Filter>
struct block_form<forced::by_bounds<Filter>> : hierarchical_form<Filter> {};

}  // namespace umbrage::detail
