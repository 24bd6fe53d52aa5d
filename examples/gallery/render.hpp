// SPDX-License-Identifier: MIT
//
// Any system with any encoding, step by step, with a stopwatch. With a system's own encoding the visibility is, bit for
// bit, what its program in examples/originals gives.
//
//     const stored_depth map = store(depth, umbrage::rg<11>{});
//     const umbrage::image<float> visibility = visibility_of(system, stage, light, map.depth);
//
#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>
#include <vector>

#include <umbrage/depth/foreign/ps14.hpp>
#include <umbrage/filter/pcf/four_tap.hpp>
#include <umbrage/filter/pcf/pcf_2x2.hpp>
#include <umbrage/depth/encodings.hpp>
#include <umbrage/images/encode.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include <stage.hpp>

namespace gallery {

/// Runs the work, adds the milliseconds that it took.
template <class Work>
auto timed(double& ms, Work&& work) {
    struct watch {
        double& sum;
        std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
        ~watch() { sum += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count(); }
    } running{ms};
    return work();
}

/// Milliseconds of the fastest of five runs.
template <class Work>
double best_of_5(Work&& work) {
    double best = std::numeric_limits<double>::infinity();
    for (int run = 0; run < 5; ++run) {
        double ms = 0;
        timed(ms, work);
        best = std::min(best, ms);
    }
    return best;
}

/// One channel of 8 bits: what there was before the tricks.
struct eight_bits {
    using texel = std::uint8_t;
    [[nodiscard]] texel encode(float depth) const { return umbrage::store_unorm8(depth); }
    [[nodiscard]] float decode(texel t) const { return static_cast<float>(t) / 255.0f; }
    [[nodiscard]] texel cleared() const { return 255; }
};

/// A depth image that went through an encoding.
struct stored_depth {
    umbrage::image<float> depth{};                         ///< decoded
    std::vector<umbrage::image<std::uint8_t>> channels{};  ///< as stored; none for floats
    std::size_t codes = 0;                                 ///< different texels
    double encode_ms = 0, decode_ms = 0;
    double error = 0;  ///< worst |decoded - depth|
};

/// @param empty  what `depth` holds where nothing was drawn
template <class Encoding>
[[nodiscard]] stored_depth store(const umbrage::image<float>& depth, const Encoding& encoding, float empty) {
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

/// @param encoding  by name
[[nodiscard]] inline stored_depth stored(const umbrage::image<float>& depth, std::string_view encoding, float empty) {
    stored_depth out;
    umbrage::with_encoding(encoding, [&](const auto& as) { out = store(depth, as, empty); });
    return out;
}

/// The map as pixel shader 1.x read it back: red shifted right by three, green added.
[[nodiscard]] inline umbrage::image<float> decoded_ps14(const stored_depth& map) {
    umbrage::image<float> out(map.depth.size());
    for (std::size_t i = 0; i < out.texels().size(); ++i)
        out.texels()[i] = umbrage::decode_ps14(
            umbrage::load_unorm8(glm::u8vec2(map.channels[0].texels()[i], map.channels[1].texels()[i])));
    return out;
}

/// A depth as what the system compares with the map.
[[nodiscard]] inline float receiver_of(const example::shadow_system& s, float depth) {
    switch (s.receiver) {
        case example::receiver_kind::scaled: return umbrage::receiver_ps14(depth);
        case example::receiver_kind::encoded:
            return umbrage::decode_ps14(umbrage::load_unorm8(umbrage::encode_rg<11>(depth)));
        case example::receiver_kind::plain: break;
    }
    return depth;
}

/// Fetch, compare and filter, wherever the camera sees something.
/// @param map  decoded
[[nodiscard]] inline umbrage::image<float> visibility_of(const example::shadow_system& s, const example::stage& stage,
                                                         const example::light& light,
                                                         const umbrage::image<float>& map) {
    using umbrage::project_coordinate, umbrage::shadow_coordinate;
    const glm::mat4 to_texels = umbrage::texture_matrix(light.space, map.size());
    const auto taps = umbrage::tap_matrices(to_texels);
    const auto fetch = umbrage::clamped(map);
    const auto outside_lit = umbrage::bordered(map, 1.0f);
    return stage.visibility([&](const example::surface& at) {
        const glm::vec3 point = example::lifted(s, light, at.position, at.normal, map.size().x);
        const glm::vec3 p = project_coordinate(shadow_coordinate(to_texels, point));
        const float depth = light.depth(s, p.z);
        if (s.test == example::test_kind::exercise)
            return umbrage::compare_exercise(depth, outside_lit(glm::ivec2(glm::floor(glm::vec2(p)))), s.bias);
        const float cone = light.cone(at.position);
        if (s.filter == "pcf_2x2_dx_sdk") return cone * umbrage::pcf_2x2_dx_sdk(fetch, glm::vec2(p), depth, s.bias);
        if (s.filter == "hard") return cone * umbrage::hard(fetch, glm::vec2(p), receiver_of(s, depth - s.bias));
        std::array<glm::vec3, 4> tap;
        for (std::size_t i = 0; i < 4; ++i) tap[i] = project_coordinate(shadow_coordinate(taps[i], point));
        return cone * umbrage::four_tap(fetch, glm::vec2(tap[0]), glm::vec2(tap[1]), glm::vec2(tap[2]),
                                        glm::vec2(tap[3]), receiver_of(s, light.depth(s, tap[0].z) - s.bias));
    });
}

}  // namespace gallery
