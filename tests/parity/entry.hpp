// SPDX-License-Identifier: MIT
//
// Entry of the parity suite for a primitive: its inputs, the results of C++, and the call in GLSL.
// Back ends run entries without knowing any of them.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/core/image.hpp>
#include <umbrage/shader/bind.hpp>
#include <umbrage/shader/glsl.hpp>

#include "random.hpp"

namespace parity {

using glm::ivec2;
using glm::vec2;
using glm::vec3;
using glm::vec4;
using umbrage::glsl::snippet;
using umbrage::glsl::tier;
using umbrage::glsl::version;
using texels = umbrage::image<vec4>;

inline constexpr int max_inputs = 6;
inline constexpr int max_maps = 4;  ///< in one shader

/// Language of a shader: a dialect of GLSL, or a language that the snippets are printed in.
struct dialect {
    enum language { glsl, hlsl, msl, wgsl };

    language in = glsl;
    version of_glsl = version::v330;

    constexpr dialect(version v) : of_glsl(v) {}
    constexpr dialect(language other) : in(other) {}
    bool operator==(const dialect&) const = default;
};

[[nodiscard]] inline std::string name(dialect d) {
    constexpr std::string_view languages[]{"", "HLSL", "MSL", "WGSL"};
    return std::string(d.in == dialect::glsl ? directive(d.of_glsl) : languages[d.in]);
}

/// One call: the values of x0 .. x5 and the textures.
struct sample {
    std::array<vec4, max_inputs> x{};
    umbrage::image_view<const vec4> map{}, table{};

    /// The map's red channel as the callable that filters take.
    [[nodiscard]] auto depth() const {
        return [view = map](ivec2 texel) { return umbrage::fetch_clamped(view, texel).x; };
    }
    [[nodiscard]] auto bordered_depth(float border) const {
        return [view = map, border](ivec2 texel) { return umbrage::fetch_bordered(view, texel, vec4(border)).x; };
    }
};

/// Inputs of one kind; `fill` writes the i-th of them into a sample whose map is set.
struct input_class {
    std::string name;
    std::function<void(std::uint64_t i, random& r, sample& s)> fill;
};

/// A finite class, taken whole by `make prove`: `count`, a power of two, inputs, of which `fill` writes the i-th.
struct enumeration {
    input_class all;
    std::uint64_t count = 0;
};

/// Target of a shader: floats, or a real UNORM render target whose integer channels are read back. Only desktop OpenGL
/// has the last two.
enum class target { rgba32f, rgba8, rgb10_a2, rgba16 };

/// A map as bind() has it under a name: functions umbrage_..._<name>, a texture <name>, a sampler <name>_sampler.
struct bound_map {
    static constexpr ivec2 origin{5, 3}, margin{9, 7};  ///< texels around a region, before and after it
    static constexpr float whole = 65536.0f;            ///< the integer that stands for 1.0
    static constexpr float most_short = 65535.0f;       ///< and depths of 16 bits

    std::string name{};
    umbrage::glsl::binding as{};  ///< its texts are GLSL's
    bool linear = false;          ///< the sampler's filter; else the nearest texel
    std::string which{};          ///< an array's layer or an atlas's origin, of x0 .. x5 in GLSL; empty: a fixed one
    bool short_depths = false;    ///< a depth texture of 16 bits; else of floats
    bool bytes = false;           ///< a texture of 8 bits a channel; else of floats

    [[nodiscard]] bool is_region() const { return umbrage::glsl::detail::has_region(as); }
    [[nodiscard]] bool compares() const { return umbrage::glsl::detail::compares(as.texture); }
    /// True for a depth texture.
    [[nodiscard]] bool has_depths() const {
        using enum umbrage::glsl::texture;
        return compares() || as.texture == depth || as.texture == depth_array;
    }
    /// True when the sampler is an argument of its own.
    [[nodiscard]] bool has_sampler(dialect::language in) const;
    /// `as` with its texts in another language.
    [[nodiscard]] umbrage::glsl::binding binding(dialect::language in) const;
    /// First arguments of the map's functions.
    [[nodiscard]] std::string arguments(dialect::language in) const;
};

/// Somebody's text in place of snippets, in the shader's own language.
struct guest {
    std::string text{};
    std::vector<std::string> declares{};  ///< names of maps that the text itself declares
};

struct entry {
    const snippet* primitive = nullptr;
    std::string variant{};               ///< tells entries of one primitive apart; empty for the plain one
    std::vector<input_class> classes{};  ///< taken in turn
    enumeration whole{};
    std::function<vec4(const sample&)> twin{};
    std::string call{};                  ///< vec4 expression of x0 .. x5, map, map_size, table; GLSL and C++ alike
                                         ///< where several maps are bound, float: each is `map` to one component
    std::vector<texels> maps{};          ///< each gets its share of the inputs; none: no map
    std::vector<bound_map> bound{};      ///< as what shaders have it; to the k-th its k-th channel is the first
    texels table{};                      ///< values k / 255
    std::vector<const snippet*> also{};  ///< further snippets that `call` uses
    /// Binding of a map without a name. Its depth takes the first channels: "...(value.xy...)".
    umbrage::glsl::binding map_kind{.outside = umbrage::outside_map::clamped};
    std::string preamble{};          ///< ahead of the snippets
    std::optional<guest> visitor{};  ///< with it `call` is printed as it is, in every language
    target output = target::rgba32f;
    bool bits = false;      ///< a denormal must not act as zero
    std::size_t share = 1;  ///< takes one input of so many
    bool alike = false;     ///< the text is another entry's with other numbers: a sample of the dialects may do

    [[nodiscard]] std::string name() const {
        return std::string(primitive->name) + (variant.empty() ? "" : " (" + variant + ")");
    }
    [[nodiscard]] bool uses(int input) const { return call.find("x" + std::to_string(input)) != std::string::npos; }
    [[nodiscard]] std::vector<snippet> snippets() const {
        std::vector<snippet> all = map_kind.needs;
        all.push_back(*primitive);
        for (const snippet* s : also) all.push_back(*s);
        return all;
    }
    /// The snippets for the map without a name, or for each of those bound.
    [[nodiscard]] std::vector<umbrage::glsl::bound> items() const;
    /// The worst tier of what its shaders hold.
    [[nodiscard]] tier exactness() const { return umbrage::glsl::exactness(items()); }
    [[nodiscard]] bool runs_in(dialect d) const;
};

/// Every entry there is.
[[nodiscard]] const std::vector<entry>& entries();

}  // namespace parity
