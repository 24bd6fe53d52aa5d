// SPDX-License-Identifier: MIT
#include "shadow_map.hpp"

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

#include <umbrage/depth/encodings.hpp>
#include <umbrage/images/encode.hpp>

namespace example {
namespace {

/// The bytes of a texel as image viewers can show them, of wider channels the high ones.
glm::u8vec3 bytes(std::uint16_t texel) { return {texel >> 8, texel & 255, 0}; }
glm::u8vec3 bytes(glm::u8vec2 texel) { return {texel, 0}; }
glm::u8vec3 bytes(glm::u8vec3 texel) { return texel; }
glm::u8vec4 bytes(glm::u8vec4 texel) { return texel; }
glm::u8vec4 bytes(float texel) { return umbrage::encode_float_bits(texel); }
template <class Target>
auto bytes_of(typename Target::texel texel) {
    if constexpr (std::is_same_v<Target, umbrage::rgb10::target>)
        return glm::u8vec3(Target::unpacked(texel) >> std::uint16_t(2));
    else if constexpr (std::is_same_v<Target, umbrage::depth24::target>)
        return glm::u8vec3(texel >> 16, texel >> 8 & 255, texel & 255);
    else return bytes(texel);
}

}  // namespace

shadow_map store(std::string_view name, float edge, const umbrage::image<float>& depth, float empty) {
    shadow_map out{.depth = umbrage::image<float>(depth.size()), .bytes{}};
    const bool known = umbrage::with_encoding(name, [&](auto encoding) {
        if constexpr (umbrage::has_edge<decltype(encoding)>) encoding.edge = edge;
        using texel = typename decltype(encoding)::texel;
        umbrage::image<texel> map(depth.size());
        std::ranges::transform(depth.texels(), map.texels().begin(),
                               [&](float d) { return d == empty ? encoding.cleared() : encoding.encode(d); });
        umbrage::decode(std::as_const(map).view(), out.depth.view(), encoding);
        out.cleared = encoding.decode(encoding.cleared());
        out.below = static_cast<float>(encoding.error().below);
        using target = typename decltype(encoding)::target;
        umbrage::image<decltype(bytes_of<target>(texel{}))> shown(depth.size());
        std::ranges::transform(map.texels(), shown.texels().begin(), [](texel t) { return bytes_of<target>(t); });
        out.bytes = std::move(shown);
    });
    if (!known) throw std::invalid_argument("no encoding is called " + std::string(name));
    return out;
}

}  // namespace example
