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
#include <cstdint>

#include <umbrage/bias/acne_free.hpp>
#include <umbrage/bias/constant.hpp>
#include <umbrage/bias/kernel.hpp>
#include <umbrage/bias/light_units.hpp>
#include <umbrage/bias/normal_offset.hpp>
#include <umbrage/bias/receiver_plane.hpp>
#include <umbrage/bias/slope.hpp>
#include <umbrage/clip_space.hpp>
#include <umbrage/compare.hpp>
#include <umbrage/depth/encodings.hpp>
#include <umbrage/depth/foreign/ps14.hpp>
#include <umbrage/depth/kinds.hpp>
#include <umbrage/depth/rg_level.hpp>
#include <umbrage/depth/rg_table.hpp>
#include <umbrage/filter/blocker/pcss_hardware.hpp>
#include <umbrage/filter/bounds_lit.hpp>
#include <umbrage/filter/filters.hpp>
#include <umbrage/filter/pcf/disc_hardware.hpp>
#include <umbrage/filter/pcf/four_tap_hardware.hpp>
#include <umbrage/filter/pcf/pcf_2x2_cube.hpp>
#include <umbrage/filter/pcf/pcf_2x2_hardware.hpp>
#include <umbrage/filter/pcf/window_hardware.hpp>
#include <umbrage/filter/prefiltered/chebyshev.hpp>
#include <umbrage/filter/prefiltered/decode_hardware.hpp>
#include <umbrage/filter/prefiltered/esm.hpp>
#include <umbrage/filter/prefiltered/evsm.hpp>
#include <umbrage/filter/prefiltered/exp2.hpp>
#include <umbrage/filter/prefiltered/hausdorff.hpp>
#include <umbrage/filter/prefiltered/look_up.hpp>
#include <umbrage/filter/prefiltered/msm.hpp>
#include <umbrage/filter/prefiltered/reduce.hpp>
#include <umbrage/filter/prefiltered/vsm.hpp>
#include <umbrage/filter/table/summed_moments.hpp>
#include <umbrage/filter/table/summed_variance.hpp>
#include <umbrage/floor_divide.hpp>
#include <umbrage/image.hpp>
#include <umbrage/light/adaptive/page_table.hpp>
#include <umbrage/light/cascades/blend.hpp>
#include <umbrage/light/cascades/select.hpp>
#include <umbrage/light/cube_atlas.hpp>
#include <umbrage/light/cube_map.hpp>
#include <umbrage/light/dual_paraboloid.hpp>
#include <umbrage/light/pancake.hpp>
#include <umbrage/light/tetrahedron.hpp>
#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/shade/lighting.hpp>
#include <umbrage/unorm.hpp>
#include <umbrage/view/false_colour.hpp>
#include <umbrage/view/overlay_texel.hpp>

namespace umbrage::glsl {

namespace detail {

/// Snippets in order, each once, what it needs before it.
struct collection {
    std::array<const snippet*, 512> members{};
    std::array<std::uint32_t, 512> hashes{};
    std::size_t size = 0;

    [[nodiscard]] constexpr const snippet* const* begin() const { return members.data(); }
    [[nodiscard]] constexpr const snippet* const* end() const { return members.data() + size; }

    constexpr void add(const snippet* s) {
        // By name: where null may be an address (as GCC's -fsanitize=undefined has it), addresses are no constants.
        std::uint32_t hash = 2166136261;  // FNV-1a
        for (char letter : s->name) hash = (hash ^ static_cast<unsigned char>(letter)) * 16777619;
        for (std::size_t i = 0; i < size; ++i)
            if (hashes[i] == hash && members[i]->name == s->name) return;
        for (const snippet* need : s->needs) add(need);
        members[size] = s;
        hashes[size++] = hash;
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

// What the types of a list name.
template <class... Encodings>
consteval auto writers_of(const list_of<Encodings...>*) {
    return std::array{Encodings::writer...};
}
template <class... Encodings>
consteval auto readers_of(const list_of<Encodings...>*) {
    return std::array{(Encodings::writes == written::depth ? Encodings::writer : Encodings::reader)...};
}
/// One for each of the filter's values.
template <class Filter>
consteval auto snippets_of_filter() {
    if constexpr (requires { Filter::values; }) {
        std::array<const snippet*, Filter::values.size()> all{};
        for (std::size_t i = 0; i < all.size(); ++i) all[i] = Filter::values[i].snippet;
        return all;
    } else return std::array{Filter::snippet};
}
template <class... Filters>
consteval auto snippets_of(const list_of<Filters...>*) {
    return collect(snippets_of_filter<Filters>()...);
}
inline constexpr auto writers = writers_of(static_cast<const encodings*>(nullptr));
inline constexpr auto readers = readers_of(static_cast<const encodings*>(nullptr));
inline constexpr auto filters = snippets_of(static_cast<const umbrage::filters::all*>(nullptr));

// The rooms.
inline constexpr auto light =
    collect(texture_matrix_snippets, select_snippets, blend_snippets, cube_map_snippets, cube_atlas_snippets,
            dual_paraboloid_snippets, tetrahedron_snippets, pancake_snippets, page_table_snippets);
inline constexpr auto kinds = collect(kinds_snippets);
inline constexpr auto codes = collect(scalar_snippets, floor_divide_snippets, unorm_snippets, writers,
                                      rg_table_snippets<9, 10, 11, 12, 13, 14, 15, 16>, readers);
inline constexpr auto levels = collect(rg_level_snippets<9, 10, 11, 12, 13, 14, 15, 16>, ps14_snippets);
inline constexpr auto maps =
    collect(clip_space_snippets, image_snippets, texel_space_snippets, compare_snippets, window_snippets, disc_snippets,
            filters, pcf_2x2_cube_snippets, four_tap_hardware_snippets, pcf_2x2_hardware_snippets,
            window_hardware_snippets, disc_hardware_snippets, bounds_lit_snippets, penumbra_snippets, pcss_snippets,
            pcss_hardware_snippets, dpcf_snippets, summed_variance_snippets, summed_moments_snippets);
inline constexpr auto prefiltered =
    collect(exp2_snippets, chebyshev_snippets, vsm_snippets, esm_snippets, evsm_snippets, msm_snippets,
            hausdorff_snippets, look_up_snippets, decode_hardware_snippets, reduce_snippets);
inline constexpr auto bias = collect(light_units_snippets, constant_snippets, slope_snippets, normal_offset_snippets,
                                     kernel_snippets, receiver_plane_snippets, acne_free_snippets);
inline constexpr auto shade = collect(lighting_snippets);
inline constexpr auto view = collect(false_colour_snippets, overlay_texel_snippets);
inline constexpr auto everything = collect(light, kinds, codes, levels, maps, prefiltered, bias, shade, view);

}  // namespace detail

inline constexpr auto registry = [] {
    std::array<const snippet*, detail::everything.size> all{};
    std::copy_n(detail::everything.begin(), all.size(), all.begin());
    return all;
}();

}  // namespace umbrage::glsl
