// SPDX-License-Identifier: MIT
#include "parts.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string_view>

#include <umbrage/bias/receiver_plane.hpp>
#include <umbrage/core/compare.hpp>
#include <umbrage/depth/conversions.hpp>
#include <umbrage/depth/foreign/ps14.hpp>
#include <umbrage/depth/rg_table.hpp>
#include <umbrage/filter/pcf/four_tap_hardware.hpp>
#include <umbrage/filter/prefiltered/prefilters.hpp>
#include <umbrage/images/moment_table.hpp>
#include <umbrage/images/variance_table.hpp>

#include <biases.hpp>
#include <filters.hpp>
#include <names.hpp>
#include <soft.hpp>

#include "stored_as.hpp"

namespace viewer {

using example::shadow_system;

storage storage_of(const shadow_system& s) {
    if (s.receiver != example::receiver_kind::plain)
        return {{glsl::encode_rg_table<11>, glsl::to_unorm},
                "vec4(umbrage_to_unorm(umbrage_encode_rg11_table(table, depth)), 0.0, 0.0)",
                {.depth = "umbrage_decode_ps14(value.xy)", .channels = 2, .needs = {glsl::decode_ps14}}};
    const stored_as e = encoding_called(s.encoding);
    return {e.writers(), e.write("depth"), e.map};
}

const snippets& depth_snippets() {
    static const snippets all{glsl::linear_depth, glsl::view_z_from_depth, glsl::view_z_from_orthographic_depth,
                              glsl::depth_from_view_z, glsl::orthographic_depth_from_view_z};
    return all;
}
std::string map_depth(const shadow_system& s) {
    std::string depth = "umbrage_linear_depth(umbrage_view_z_from_orthographic_depth(z, planes.x, planes.y), planes.z)";
    if (s.light == example::light_kind::spot)
        depth = "umbrage_linear_depth(umbrage_view_z_from_depth(z, planes.x, planes.y), planes.z)";
    if (s.depth == example::depth_kind::projected) depth = "z";
    return "float map_depth(float z) { return " + depth + "; }\n";
}

std::string projected(const shadow_system& s, const std::string& depth) {
    if (s.depth == example::depth_kind::projected) return depth;
    const std::string_view from = s.light == example::light_kind::spot ? "" : "orthographic_";
    return "umbrage_" + std::string(from) + "depth_from_view_z(" + depth + " * planes.y, planes.x, planes.y)";
}

std::string even(const shadow_system& s, const std::string& depth) {
    if (s.depth != example::depth_kind::projected || s.light != example::light_kind::spot) return depth;
    return "umbrage_linear_depth(umbrage_view_z_from_depth(" + depth + ", planes.x, planes.y), planes.z)";
}

bool compares_projected(const shadow_system& s) {
    return !example::filters_ahead(s.filter) &&
           (example::compares_along_plane(s.bias) ||
            (example::hardens(s.filter) && s.depth != example::depth_kind::projected));
}

bias bias_of(const shadow_system& s) {
    bias out{.uses{}, .statement{}, .ahead{planes}};
    example::with_bias(s.bias, [&](const auto& of) { out.uses = of.snippets(), out.statement = of.statement; });
    if (example::compares_along_plane(s.bias)) out.ahead += "vec2 plane;\nvec3 plane_at;\n";
    return out;
}

glsl::binding compared_map(const shadow_system& s, glsl::binding map) {
    map.outside = umbrage::outside_map::clamped;  // as the originals sampled
    if (!compares_projected(s)) return map;
    map.depth = projected(s, map.depth.empty() ? "value.x" : map.depth);
    map.needs.insert(map.needs.end(), depth_snippets().begin(), depth_snippets().end());
    if (!example::compares_along_plane(s.bias)) return map;
    map.depth = "umbrage_apply_receiver_plane(" + map.depth + ", plane, plane_at, texel)";
    map.needs.push_back(glsl::apply_receiver_plane);
    return map;
}

namespace {

std::string text(float v) {
    std::array<char, 32> out{};
    std::snprintf(out.data(), out.size(), "%.9e", double(v));
    return out.data();
}
std::string text(glm::vec2 v) { return "vec2(" + text(v.x) + ", " + text(v.y) + ")"; }

/// Arguments of a prefilter's writer after the depth, and of its lookup after the receiver.
struct parameters {
    std::string writer, look_up;
};
template <class Prefilter>
parameters parameters_of(const Prefilter& of) {
    if constexpr (requires { of.settings; })
        return {", " + text(of.settings.exponent), ", " + text(of.settings.exponent)};
    else if constexpr (requires { of.parameters; }) {
        const umbrage::evsm_parameters& p = of.parameters;
        if (Prefilter::texel::length() == 2)
            return {", " + text(p.exponents.x), ", " + text(p.exponents.x) + ", " + text(p.deviations.x)};
        return {", " + text(p.exponents), ", " + text(p.exponents) + ", " + text(p.deviations)};
    } else if constexpr (requires { of.bias; }) return {"", ", " + text(of.bias)};
    else return {"", ", " + text(of.min_variance)};
}

}  // namespace

std::optional<summed_table> summed_table_of(const shadow_system& s) {
    const int radius = static_cast<int>(s.radius.value_or(2));
    const std::string arguments = ", " + text(static_cast<float>(radius)) + ", ";
    if (s.filter == glsl::summed_variance.name) {
        const umbrage::variance_table of{.bits = example::variance_bits, .radius = radius};
        return summed_table{[=](auto map) { return umbrage::make_variance_table(map, of); }, &glsl::summed_variance,
                            arguments + text(static_cast<float>(1 << of.bits))};
    }
    if (s.filter == glsl::summed_moments.name) {
        const umbrage::moment_table of{.radius = radius};
        return summed_table{[=](auto map) { return umbrage::make_moment_table(map, of); }, &glsl::summed_moments,
                            arguments + text(umbrage::msm_bias_16)};
    }
    return std::nullopt;
}

std::optional<prefilter> prefilter_of(const shadow_system& s) {
    if (summed_table_of(s)) return prefilter{{}, "vec4(depth, 0.0, 0.0, 0.0)", 1};  // the renderer sums them
    std::optional<prefilter> out;
    umbrage::prefilters::all::with(s.filter, [&]<class Prefilter>(const Prefilter& of) {
        constexpr std::array zeros{"", ", 0.0, 0.0, 0.0", ", 0.0, 0.0", "", ""};
        std::string depth = "depth";
        snippets writers{*of.writer};
        if (of.writer == &glsl::to_optimized_moments) {
            depth = "umbrage_encode_msm(depth)";
            writers.push_back(glsl::encode_msm);
        }
        const std::string value = "umbrage_" + std::string(of.writer->name) + "(" + depth + parameters_of(of).writer;
        out = {writers, "vec4(" + value + ")" + zeros[sizeof(typename Prefilter::texel) / sizeof(float)] + ")",
               2 * std::clamp(static_cast<int>(s.radius.value_or(2)), 0, 3) + 1};
    });
    return out;
}

filter filter_of(const shadow_system& s) {
    const bool moved = example::compares_along_plane(s.bias);
    if (s.test == example::test_kind::exercise && s.filter == "hard" && !moved &&
        s.receiver == example::receiver_kind::plain)
        return {{glsl::compare_exercise, glsl::fetch_depth},
                "umbrage_compare_exercise(depth, umbrage_fetch_depth(map, map_size, floor(p.xy)), epsilon)"};
    const glsl::snippet* snippet = nullptr;
    std::string arguments = "p.xy, receiver", map = "map";
    snippets uses;
    umbrage::filters::soft::with(s.filter, [&](const auto& of) {
        snippet = of.snippet;
        arguments += ", softness, umbrage_disc_rotation(gl_FragCoord.xy)";
        uses.push_back(glsl::disc_rotation);
    });
    umbrage::prefilters::all::with(s.filter, [&](const auto& of) {
        snippet = of.snippet;
        arguments += parameters_of(of).look_up;
        map = "moments";
    });
    if (const auto table = summed_table_of(s)) {
        snippet = table->look_up;
        arguments += table->arguments;
        map = "moments";
    }
    example::with_filter(s.filter, s.radius, [&](const auto& of) {
        snippet = of.snippet;
        if constexpr (requires { of.radius_texels; }) {
            arguments += ", " + std::to_string(of.radius_texels) + ", umbrage_disc_rotation(gl_FragCoord.xy)";
            uses.push_back(glsl::disc_rotation);
        }
        if constexpr (requires { of.radius; }) arguments += ", " + std::to_string(of.radius);
    });
    if (has_tap_matrices(s)) {
        snippet = &glsl::four_tap_hardware;
        arguments = "tap(tap_0), tap(tap_1), tap(tap_2), tap(tap_3), receiver";
    }
    uses.push_back(*snippet);
    if (snippet == &glsl::pcf_2x2_dx_sdk) arguments = moved ? "p.xy, depth, depth - biased" : "p.xy, depth, epsilon";
    return {uses, "umbrage_" + std::string(snippet->name) + "(" + map + ", " + map + "_size, " + arguments + ")"};
}

std::string receiver_of(const shadow_system& s) {
    switch (s.receiver) {
        case example::receiver_kind::plain: break;
        case example::receiver_kind::scaled: return "umbrage_receiver_ps14(biased)";
        case example::receiver_kind::encoded:
            return "umbrage_decode_ps14(umbrage_encode_rg11_table(table, biased) / 255.0)";
    }
    return "biased";
}

}  // namespace viewer
