// SPDX-License-Identifier: MIT
//
// Concepts of an encoding: a value that turns depths into texels and back.
//
//     umbrage::rg<11> encoding{.direction = light.clip.direction};
//     umbrage::image<glm::u8vec2> map(size, encoding.cleared());
//
// Functions over images take any type with texel, encode and decode.
// See also: encodings.hpp, the list of this library's encodings.
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

/// Kind of value that a writer's snippet returns.
enum class store_format {
    depth,     ///< float, written to a float target or a depth texture as it is
    integers,  ///< integer channels; the target's to_unorm turns them into values to write
    values,    ///< values, written to a UNORM target as they are; its rounding is part of the format
};

/// Largest distances from a depth in [0, 1) to its decoded value.
struct decoding_error {
    double below = 0.0;  ///< a receiver's bias must cover it where depth runs forward
    double above = 0.0;  ///< a receiver's bias must cover it where depth is reversed
};

/// Value that turns depths into texels and back. Functions over images need no more than this.
template <class Encoding>
concept encoding = std::copyable<Encoding> && requires(const Encoding& e, float depth) {
    typename Encoding::texel;
    { e.encode(depth) } -> std::same_as<typename Encoding::texel>;
    { e.decode(typename Encoding::texel{}) } -> std::same_as<float>;
};

/// Encoding with a name, snippets, a target and an error, for tools, tables and shaders.
template <class Encoding>
concept known_encoding = encoding<Encoding> && requires(const Encoding& e) {
    { Encoding::name } -> std::convertible_to<std::string_view>;     // a C++ identifier, without the template
    { Encoding::summary } -> std::convertible_to<std::string_view>;  // one sentence
    { Encoding::writer } -> std::convertible_to<const glsl::snippet*>;
    { Encoding::reader } -> std::convertible_to<const glsl::snippet*>;  // null if the texel is the depth
    { Encoding::writes } -> std::convertible_to<store_format>;
    requires render_target<typename Encoding::target>;          // format of its texels
    { Encoding::codes } -> std::convertible_to<std::uint64_t>;  // number of texels that the writer can return
    { e.direction } -> std::convertible_to<depth_direction>;    // the far plane is at 1 forward, at 0 reversed
    { e.error(unorm_store::truncates) } -> std::same_as<decoding_error>;  // the store rounds by default
    { e.cleared() } -> std::same_as<typename Encoding::texel>;  // texel of an empty map: decodes to the far plane
};

/// Encoding with a choice of the depth that a code decodes to: lower_edge, center or upper_edge. It has
/// `decode_sampled` too, the reader's snippet in C++.
template <class Encoding>
concept has_edge = requires(Encoding e) {
    { e.edge } -> std::convertible_to<float>;
};

namespace detail {

/// Checks that a type can be used as an encoding, with a readable error message.
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

/// Edge with which no surface shadows itself from quantization alone.
[[nodiscard]] constexpr float safe_edge(depth_direction direction) {
    return direction == depth_direction::forward ? 1.0f : 0.0f;
}

}  // namespace detail
}  // namespace umbrage
