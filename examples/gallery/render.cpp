// SPDX-License-Identifier: MIT
#include "render.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstring>
#include <utility>

#include <umbrage/bias/constant.hpp>
#include <umbrage/core/compare.hpp>
#include <umbrage/depth/encodings.hpp>
#include <umbrage/depth/foreign/ps14.hpp>
#include <umbrage/filter/pcf/four_tap.hpp>
#include <umbrage/filter/pcf/hard.hpp>
#include <umbrage/filter/pcf/pcf_2x2.hpp>
#include <umbrage/images/encode.hpp>
#include <umbrage/light/texture_matrix.hpp>

namespace gallery {
namespace {

/// One channel of 8 bits: what there was before the tricks.
struct eight_bits {
    using texel = std::uint8_t;
    [[nodiscard]] texel encode(float depth) const { return umbrage::store_unorm(depth); }
    [[nodiscard]] float decode(texel t) const { return static_cast<float>(t) / 255.0f; }
    [[nodiscard]] texel cleared() const { return 255; }
};

template <class Encoding>
stored_depth store(const umbrage::image<float>& depth, const Encoding& encoding, float empty) {
    using texel = typename Encoding::texel;
    stored_depth out{.depth = umbrage::image<float>(depth.size())};
    umbrage::image<texel> map(depth.size());
    out.encode_ms = best_of_5([&] { umbrage::encode(depth.view(), map.view(), encoding); });
    std::ranges::transform(depth.texels(), map.texels(), map.texels().begin(),
                           [&](float d, texel t) { return d == empty ? encoding.cleared() : t; });
    out.decode_ms = best_of_5([&] { umbrage::decode(std::as_const(map).view(), out.depth.view(), encoding); });

    std::vector<std::uint32_t> codes(depth.texels().size());
    if constexpr (!std::same_as<texel, float>)
        out.channels.assign(sizeof(texel), umbrage::image<std::uint8_t>(depth.size()));
    for (std::size_t i = 0; i < codes.size(); ++i) {
        std::uint8_t bytes[sizeof(texel)];
        std::memcpy(bytes, &map.texels()[i], sizeof bytes);
        std::memcpy(&codes[i], bytes, sizeof bytes);
        for (std::size_t c = 0; c < out.channels.size(); ++c) out.channels[c].texels()[i] = bytes[c];
        out.error = std::max(out.error, std::abs(double(depth.texels()[i]) - double(out.depth.texels()[i])));
    }
    std::ranges::sort(codes);
    out.codes = static_cast<std::size_t>(std::ranges::unique(codes).begin() - codes.begin());
    return out;
}

/// A depth as what the system compares with the map.
float receiver_of(const example::shadow_system& s, float depth) {
    switch (s.receiver) {
        case example::receiver_kind::scaled: return umbrage::receiver_ps14(depth);
        case example::receiver_kind::encoded:
            return umbrage::decode_ps14(umbrage::load_unorm(umbrage::encode_rg<11>(depth)));
        case example::receiver_kind::plain: break;
    }
    return depth;
}

}  // namespace

stored_depth stored(const umbrage::image<float>& depth, std::string_view encoding, float empty) {
    stored_depth out;
    if (encoding == "8_bits") out = store(depth, eight_bits{}, empty);
    else umbrage::with_encoding(encoding, [&](const auto& as) { out = store(depth, as, empty); });
    return out;
}

umbrage::image<float> decoded_ps14(const stored_depth& map) {
    umbrage::image<float> out(map.depth.size());
    for (std::size_t i = 0; i < out.texels().size(); ++i)
        out.texels()[i] = umbrage::decode_ps14(
            umbrage::load_unorm(glm::u8vec2(map.channels[0].texels()[i], map.channels[1].texels()[i])));
    return out;
}

umbrage::image<float> visibility_of(const example::shadow_system& s, const example::stage& stage,
                                    const example::light& light, const umbrage::image<float>& map) {
    using umbrage::project_coordinate, umbrage::shadow_coordinate;
    const glm::mat4 to_texels = umbrage::texture_matrix(light.space, map.size());
    const auto taps = umbrage::tap_matrices(to_texels);
    const auto fetch = umbrage::clamped(map);
    const auto bordered = umbrage::bordered(map);
    return stage.visibility([&](const example::surface& at) {
        const glm::vec3 point = example::lifted(s, light, at.position, at.face_normal);
        const glm::vec3 p = project_coordinate(shadow_coordinate(to_texels, point));
        const float depth = light.depth(s, p.z);
        if (s.test == example::test_kind::exercise)
            return umbrage::compare_exercise(depth, bordered(glm::ivec2(glm::floor(glm::vec2(p)))), s.epsilon);
        const float cone = light.cone(at.position);
        if (s.filter == "pcf_2x2_dx_sdk") return cone * umbrage::pcf_2x2_dx_sdk(fetch, glm::vec2(p), depth, s.epsilon);
        if (s.filter == "hard")
            return cone * umbrage::hard(fetch, glm::vec2(p), receiver_of(s, umbrage::biased(depth, s.epsilon)));
        std::array<glm::vec3, 4> tap;
        for (std::size_t i = 0; i < 4; ++i) tap[i] = project_coordinate(shadow_coordinate(taps[i], point));
        return cone * umbrage::four_tap(fetch, glm::vec2(tap[0]), glm::vec2(tap[1]), glm::vec2(tap[2]),
                                        glm::vec2(tap[3]),
                                        receiver_of(s, umbrage::biased(light.depth(s, tap[0].z), s.epsilon)));
    });
}

}  // namespace gallery
