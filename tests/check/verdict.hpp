// SPDX-License-Identifier: MIT
//
// What was found out about a shader's function, as data, as text and as JSON.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace check {

/// How a function agrees with one of umbrage.
enum class agreement {
    same_bits,  ///< the same bits for all inputs
    same_but,   ///< the same but for what `but` lists: edges of the map, NaN, a sampler's weights
    other,      ///< that function with slips, or another function than the expected one
    unknown,    ///< no function fits: `seen` shows what it depends on
};

/// One thing that is wrong, or one way in which a result deviates without being wrong.
struct finding {
    std::string kind;  ///< a word for links: shift, flip, swap, z_range, direction, strict, bias, border, in_shadow,
                       ///< base, truncation, channels, nan, beyond_far, weights, outside, second, sides
    std::string says;  ///< for readers: "shifted by (0.5, 0.5) texel"
};

/// An input on which the two differ, as small and round as one was found.
struct difference {
    glm::ivec2 size{0, 0};  ///< of the map; 0 for codecs
    std::vector<float> map{};
    glm::vec4 input{0}, got{0}, expected{0};
};

/// Weights of the texels that a filter reads, by their offset from the coordinate: what one texel in shadow takes from
/// visibility. Sampled finer than texels, since weights depend on where in its texel the coordinate lies.
struct footprint {
    int steps = 8;       ///< samples to a texel
    glm::vec2 first{0};  ///< offset of the first sample, in texels
    glm::ivec2 size{0, 0};
    std::vector<float> weights{};  ///< row by row
};

struct verdict {
    agreement how = agreement::unknown;
    std::string function{};  ///< what it is: a name of names(); empty: unknown
    std::string expected{};  ///< what it should be; the same as function where nothing was said
    std::string outside{};   ///< what lookups outside the map give; empty for codecs
    std::vector<finding> slips{};
    std::vector<finding> but{};
    std::size_t inputs = 0;             ///< compared with `expected` as it is, without slips
    std::size_t same_bits = 0;          ///< of these, with the same bits
    std::size_t explained = 0;          ///< of these, as function and slips give them, but for what `but` lists
    std::optional<difference> first{};  ///< from `expected`
    footprint seen{};                   ///< of filters
};

/// Lines for people.
[[nodiscard]] std::string text(const verdict&);
/// One object with the members' names.
[[nodiscard]] std::string json(const verdict&);
/// Word of JSON: same_bits, same_but, other, unknown.
[[nodiscard]] std::string_view name(agreement);

}  // namespace check
