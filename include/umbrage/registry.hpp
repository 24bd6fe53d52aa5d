// SPDX-License-Identifier: MIT
//
// List of every snippet, in the order in which data flows, for tests, tables and tools.
//
//     for (const umbrage::glsl::snippet* s : umbrage::glsl::registry()) std::puts(umbrage::glsl::text({*s}).c_str());
//
#pragma once

#include <initializer_list>
#include <span>
#include <vector>

#include <umbrage/bias/acne_free.hpp>
#include <umbrage/bias/constant.hpp>
#include <umbrage/bias/distance_slope.hpp>
#include <umbrage/bias/kernel.hpp>
#include <umbrage/bias/light_units.hpp>
#include <umbrage/bias/normal_offset.hpp>
#include <umbrage/bias/receiver_plane.hpp>
#include <umbrage/bias/slope.hpp>
#include <umbrage/core/clip_space.hpp>
#include <umbrage/core/compare.hpp>
#include <umbrage/core/config.hpp>
#include <umbrage/core/floor_divide.hpp>
#include <umbrage/core/image.hpp>
#include <umbrage/core/unorm.hpp>
#include <umbrage/debug/false_color.hpp>
#include <umbrage/debug/overlay_texel.hpp>
#include <umbrage/debug/probe_color.hpp>
#include <umbrage/depth/conversions.hpp>
#include <umbrage/depth/encodings.hpp>
#include <umbrage/depth/foreign/ps14.hpp>
#include <umbrage/depth/rg_level.hpp>
#include <umbrage/depth/rg_table.hpp>
#include <umbrage/filter/blocker/pcss_hardware.hpp>
#include <umbrage/filter/bounds_lit.hpp>
#include <umbrage/filter/filters.hpp>
#include <umbrage/filter/pcf/disc_hardware.hpp>
#include <umbrage/filter/pcf/disc_tap.hpp>
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
#include <umbrage/light/adaptive/page_table.hpp>
#include <umbrage/light/cascades/blend.hpp>
#include <umbrage/light/cascades/select.hpp>
#include <umbrage/light/lighting.hpp>
#include <umbrage/light/pancake.hpp>
#include <umbrage/light/point/cube_atlas.hpp>
#include <umbrage/light/point/cube_map.hpp>
#include <umbrage/light/point/dual_paraboloid.hpp>
#include <umbrage/light/point/tetrahedron.hpp>
#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/shadow/anchored_map.hpp>
#include <umbrage/shadow/cascade_choice.hpp>
#include <umbrage/shadow/cascade_places.hpp>
#include <umbrage/shadow/cube_maps.hpp>
#include <umbrage/shadow/map_tile.hpp>
#include <umbrage/shadow/page_places.hpp>
#include <umbrage/shadow/paraboloid_maps.hpp>
#include <umbrage/shadow/penumbra_shape.hpp>
#include <umbrage/shadow/single_map.hpp>
#include <umbrage/shadow/softness.hpp>
#include <umbrage/shadow/tetrahedron_map.hpp>
#include <umbrage/shadow/warped_places.hpp>

namespace umbrage::glsl {

namespace detail {

/// Snippets in order, each once, after its needs.
template <class = umbrage::detail::on_use>
class collection {
public:
    collection& add(const snippet* s) {
        // Compares by name: a program and a library that it loads may each have a copy.
        for (const snippet* member : members_)
            if (*member == *s) return *this;
        for (const snippet* need : s->needs) add(need);
        members_.push_back(s);
        return *this;
    }
    collection& add_all(std::initializer_list<std::span<const snippet* const>> lists) {
        for (const auto& some : lists)
            for (const snippet* s : some) add(s);
        return *this;
    }
    template <class... Encodings>
    collection& add_writers(const list_of<Encodings...>*) {
        return (add(Encodings::writer), ..., *this);
    }
    template <class... Encodings>
    collection& add_readers(const list_of<Encodings...>*) {
        return (add(Encodings::writes == store_format::depth ? Encodings::writer : Encodings::reader), ..., *this);
    }
    template <class... Filters>
    collection& add_filters(const list_of<Filters...>*) {
        return (add_filter<Filters>(), ..., *this);
    }

    [[nodiscard]] const std::vector<const snippet*>& members() const { return members_; }

private:
    /// Adds the snippet of each of the filter's values.
    template <class Filter>
    void add_filter() {
        if constexpr (requires { Filter::values; }) {
            for (const Filter& value : Filter::values) add(value.snippet);
        } else add(Filter::snippet);
    }

    std::vector<const snippet*> members_;
};

}  // namespace detail

/// All snippets. The list is made on first use, so a program that does not call this carries no snippet for it.
template <class Use = umbrage::detail::on_use>
[[nodiscard]] std::span<const snippet* const> registry() {
    static const auto all = [] {
        const encodings* const every_encoding = nullptr;
        const umbrage::filters::all* const every_filter = nullptr;
        return detail::collection<Use>()
            // light
            .add_all({texture_matrix_snippets, select_snippets, blend_snippets, cube_map_snippets, cube_atlas_snippets,
                      dual_paraboloid_snippets, tetrahedron_snippets, pancake_snippets, page_table_snippets})
            // depth
            .add_all({conversions_snippets, scalar_snippets, floor_divide_snippets, unorm_snippets})
            .add_writers(every_encoding)
            .add_all({rg_table_snippets<9, 10, 11, 12, 13, 14, 15, 16>})
            .add_readers(every_encoding)
            .add_all({rg_level_snippets<9, 10, 11, 12, 13, 14, 15, 16>, ps14_snippets})
            // filter
            .add_all({clip_space_snippets, image_snippets, texel_space_snippets, compare_snippets, window_snippets,
                      disc_tap_snippets, disc_snippets})
            .add_filters(every_filter)
            .add_all({pcf_2x2_cube_snippets, four_tap_hardware_snippets, pcf_2x2_hardware_snippets,
                      window_hardware_snippets, disc_hardware_snippets, bounds_lit_snippets, penumbra_snippets,
                      pcss_snippets, pcss_hardware_snippets, dpcf_snippets, summed_variance_snippets,
                      summed_moments_snippets})
            .add_all({exp2_snippets, chebyshev_snippets, vsm_snippets, esm_snippets, evsm_snippets, msm_snippets,
                      hausdorff_snippets, look_up_snippets, decode_hardware_snippets, reduce_snippets})
            // bias, shade, view
            .add_all({light_units_snippets, constant_snippets, slope_snippets, distance_slope_snippets,
                      normal_offset_snippets, kernel_snippets, receiver_plane_snippets, acne_free_snippets})
            .add_all({lighting_snippets, false_color_snippets, overlay_texel_snippets, probe_color_snippets})
            // shadow
            .add_all({map_tile_snippets, anchored_map_snippets, single_map_snippets, cascade_choice_snippets,
                      cascade_places_snippets, cube_maps_snippets, tetrahedron_map_snippets, paraboloid_maps_snippets,
                      warped_places_snippets, page_places_snippets, softness_snippets, penumbra_shape_snippets})
            .members();
    }();
    return all;
}

}  // namespace umbrage::glsl
