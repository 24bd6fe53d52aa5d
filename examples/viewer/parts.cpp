// SPDX-License-Identifier: MIT
#include "parts.hpp"

#include <string_view>

#include <umbrage/compare.hpp>
#include <umbrage/depth/foreign/ps14.hpp>
#include <umbrage/depth/kinds.hpp>
#include <umbrage/depth/rg_table.hpp>

#include <biases.hpp>
#include <filters.hpp>
#include <names.hpp>

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

bias bias_of(const shadow_system& s, const glsl::binding& map) {
    bias out{.uses{}, .statement{}, .ahead{planes}};
    example::with_bias(s.bias, [&](const auto& of) { out.uses = of.snippets(), out.statement = of.statement; });
    if (!example::moves_stored_depths(s.bias)) return out;
    out.uses.insert(out.uses.end(), map.needs.begin(), map.needs.end());
    std::string stored = map.depth.empty() ? "value.x" : map.depth;
    stored.replace(stored.find("value"), 5, "umbrage_fetch_clamped(map, size, texel)");
    out.ahead += "vec2 plane, plane_at;\n#define UMBRAGE_FETCH(map, size, texel) umbrage_on_receiver_plane(" +
                 projected(s, stored) + ", plane, plane_at, texel)\n";
    return out;
}

filter filter_of(const shadow_system& s) {
    const bool moved = example::moves_stored_depths(s.bias);
    if (s.test == example::test_kind::exercise && s.filter == "hard" && !moved &&
        s.receiver == example::receiver_kind::plain)
        return {{glsl::compare_exercise, glsl::fetch_depth},
                "umbrage_compare_exercise(depth, umbrage_fetch_depth(map, map_size, floor(p.xy)), epsilon)"};
    const glsl::snippet* snippet = nullptr;
    std::string arguments = "p.xy, receiver";
    snippets uses;
    example::with_filter(s.filter, s.radius, [&](const auto& of) {
        snippet = of.snippet;
        if constexpr (requires { of.radius_texels; }) {
            arguments += ", " + std::to_string(of.radius_texels) + ", umbrage_disc_turn(gl_FragCoord.xy)";
            uses.push_back(glsl::disc_turn);
        }
        if constexpr (requires { of.radius; }) arguments += ", " + std::to_string(of.radius);
    });
    uses.push_back(*snippet);
    if (snippet == &glsl::four_tap) arguments = "tap(0), tap(1), tap(2), tap(3), receiver";
    if (snippet == &glsl::pcf_2x2_dx_sdk) arguments = moved ? "p.xy, depth, depth - biased" : "p.xy, depth, epsilon";
    return {uses, "umbrage_" + std::string(snippet->name) + "(map, map_size, " + arguments + ")"};
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
