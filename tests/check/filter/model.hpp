// SPDX-License-Identifier: MIT
//
// A filter of umbrage with slips: what a shader's function may be.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

#include "../investigation.hpp"

namespace check {

/// What a lookup outside the map gives.
enum class outside { clamped, bordered, repeated, dark, lit_at_once };
inline constexpr outside outside_modes[]{outside::clamped, outside::bordered, outside::lit_at_once, outside::repeated,
                                         outside::dark};
[[nodiscard]] std::string_view name(outside);

/// How stored and receiver depth are compared. Lit if scale * receiver + offset <= stored.
struct compare_model {
    float scale = 1, offset = 0;
    bool reversed = false;      ///< >= in place of <=
    bool strict = false;        ///< < in place of <=, or >
    float lit = 1, shadow = 0;  ///< results
    [[nodiscard]] bool plain() const { return scale == 1.0f && offset == 0.0f; }
    /// Receiver that is compared as this depth.
    [[nodiscard]] float receiver_of(float depth) const { return (depth - offset) / scale; }
    [[nodiscard]] float result(float visibility) const;
};

/// Where the coordinate goes: first changes of UV, then of texels.
struct geometry_model {
    bool swap_uv = false, flip_x = false, flip_y = false;
    float zoom = 1;  ///< 2: uv * 2 - 1; 0.5: uv * 0.5 + 0.5
    bool swap_texel = false;
    glm::vec2 shift{0};
    [[nodiscard]] glm::vec2 operator()(glm::vec2 coord, glm::ivec2 size) const;
    /// The coordinate that goes there.
    [[nodiscard]] glm::vec2 source(glm::vec2 place, glm::ivec2 size) const;
    [[nodiscard]] bool plain() const {
        return !swap_uv && !flip_x && !flip_y && zoom == 1.0f && !swap_texel && shift == glm::vec2(0);
    }
};

/// A map as the library's filters fetch it, with one kind of outside. `strict` lowers each depth by one float, so that
/// <= compares as <; `reversed` negates, so that it compares as >=.
struct fetched_map {
    const batch* map;
    outside mode = outside::bordered;
    bool strict = false, reversed = false;
    [[nodiscard]] float operator()(glm::ivec2 texel) const;
};

/// One of the library's filters with fixed numbers.
struct reference {
    std::string name;
    std::function<float(const fetched_map&, glm::vec2 coord, float receiver)> call;
};

/// All filters of filters::all, in their order, each with a few numbers; then boxes of filtered comparisons, which are
/// window() with a row of equal weights.
[[nodiscard]] const std::vector<reference>& references();

struct filter_model {
    const reference* filter = nullptr;
    compare_model compare{};
    geometry_model geometry{};
    outside mode = outside::bordered;

    [[nodiscard]] float operator()(const batch&, const glm::vec4& input) const;
    /// True if no texel that the filter reads is outside the map.
    [[nodiscard]] bool inside(const batch&, const glm::vec4& input) const;
    [[nodiscard]] std::vector<finding> slips() const;
};

/// Greatest reach of references(), rounded up, in texels.
inline constexpr float largest_reach = 5;

/// Whether the result is that of an input that rounding, or a sampler's 8 bits, put beside this one.
[[nodiscard]] bool beside(const filter_model&, const batch&, const glm::vec4& input, float result);

}  // namespace check
