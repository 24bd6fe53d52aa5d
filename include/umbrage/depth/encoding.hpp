// SPDX-License-Identifier: MIT
//
// What an encoding is: a value that turns depths into texels and back, and knows what there is to know of itself.
//
//     umbrage::rg<11> encoding{.direction = light.clip.direction};
//     umbrage::image<glm::u8vec2> map(size, encoding.cleared());
//
// The library's own are listed in encodings.hpp. Functions over images take any type with texel, encode and decode.
#pragma once

#include <concepts>
#include <cstdint>
#include <string_view>
#include <type_traits>

#include <umbrage/core/clip_space.hpp>
#include <umbrage/core/snippet.hpp>
#include <umbrage/core/unorm.hpp>
#include <umbrage/depth/render_target.hpp>

namespace umbrage {

/// What the writer's snippet returns.
enum class store_format {
    depth,     ///< a float to write into a float target
    integers,  ///< integer channels: the target's to_unorm makes them the values to write
    values,    ///< values to write into a UNORM target as they are; what it makes of them is part of the format
};

/// How far a decoded depth may lie from the encoded one, for every depth in [0, 1).
struct decoding_error {
    double below = 0.0;  ///< what a receiver's bias has to cover where depth runs forward
    double above = 0.0;  ///< the same where it is reversed
};

/// Depths to texels and back: all that functions over images ask for.
template <class Encoding>
concept encoding = std::copyable<Encoding> && requires(const Encoding& e, float depth) {
    typename Encoding::texel;
    { e.encode(depth) } -> std::same_as<typename Encoding::texel>;
    { e.decode(typename Encoding::texel{}) } -> std::same_as<float>;
};

/// What an encoding of the library tells of itself, for tools, tables and shaders.
template <class Encoding>
concept known_encoding = encoding<Encoding> && requires(const Encoding& e) {
    { Encoding::name } -> std::convertible_to<std::string_view>;     // a C++ identifier, without the template
    { Encoding::summary } -> std::convertible_to<std::string_view>;  // one sentence
    { Encoding::writer } -> std::convertible_to<const glsl::snippet*>;
    { Encoding::reader } -> std::convertible_to<const glsl::snippet*>;  // null: the texel is the depth
    { Encoding::writes } -> std::convertible_to<store_format>;
    requires render_target<typename Encoding::target>;                    // what its texels lie in
    { Encoding::codes } -> std::convertible_to<std::uint64_t>;            // texels that the writer can give
    { e.direction } -> std::convertible_to<depth_direction>;              // far is 1 forward, 0 reversed
    { e.error(unorm_store::truncates) } -> std::same_as<decoding_error>;  // by default the store rounds
    { e.cleared() } -> std::same_as<typename Encoding::texel>;            // an empty map's: decodes to the far plane
};

/// Whether the reader asks which place of a code's interval it shall answer: lower_edge, center or upper_edge.
template <class Encoding>
concept has_edge = requires(Encoding e) {
    { e.edge } -> std::convertible_to<float>;
};

namespace detail {

/// Says in words what a type lacks that is used as an encoding.
template <class Encoding>
consteval bool is_encoding() {
    static_assert(
        requires { typename Encoding::texel; }, "an umbrage encoding needs a type `texel`");
    static_assert(
        requires(const Encoding& e, float d) { e.encode(d); }, "an umbrage encoding needs `texel encode(float) const`");
    static_assert(encoding<Encoding>,
                  "an umbrage encoding needs `float decode(texel) const`, and `encode` to return a texel");
    return true;
}

/// The edge on whose side no surface shadows itself through quantization alone.
[[nodiscard]] constexpr float safe_edge(depth_direction direction) {
    return direction == depth_direction::forward ? 1.0f : 0.0f;
}

}  // namespace detail
}  // namespace umbrage
