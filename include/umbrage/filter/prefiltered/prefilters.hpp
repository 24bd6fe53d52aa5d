// SPDX-License-Identifier: MIT
//
// Prefiltered maps (VSM, ESM, EVSM, MSM) as values, in one list. Each has its texel type, encodes depth and decodes
// visibility. Functions over images, tools and tables use the list.
//
//     umbrage::prefilters::evsm4 filter{umbrage::make_evsm({.exponent = 30.0f})};
//     glm::vec4 texel = filter.encode(depth);
//     float visibility = filter.decode(blurred, receiver);
//
#pragma once

#include <concepts>
#include <string_view>
#include <tuple>

#include <umbrage/core/check.hpp>
#include <umbrage/core/list.hpp>
#include <umbrage/depth/encoding.hpp>
#include <umbrage/filter/numbers.hpp>
#include <umbrage/filter/prefiltered/look_up.hpp>

namespace umbrage {

/// Value that encodes depths as texels, and decodes visibility from a mean of texels. Functions over images need no
/// more. They call the member check(std::string_view function) of a prefilter that has it, as of a filter.
template <class Prefilter>
concept prefilter = std::copyable<Prefilter> && requires(const Prefilter& p, float depth) {
    typename Prefilter::texel;
    { p.encode(depth) } -> std::same_as<typename Prefilter::texel>;
    { p.decode(typename Prefilter::texel{}, depth) } -> std::same_as<float>;
    { p.direction } -> std::convertible_to<depth_direction>;
};

namespace detail {

/// Checks that a type can be used as a prefilter, with a readable error message.
template <class Prefilter>
consteval bool is_prefilter() {
    static_assert(!encoding<Prefilter>, "visibility from a map of an encoding takes a filter before `out`");
    static_assert(encoding<Prefilter> || prefilter<Prefilter>,
                  "an umbrage prefilter needs a type `texel`, `texel encode(float) const`, "
                  "`float decode(texel, float receiver) const` and a `direction`");
    return true;
}

/// Refuses what make_evsm refuses, of the first `count` powers.
inline void require_evsm(std::string_view function, const evsm_parameters& parameters, glm::length_t count) {
    for (glm::length_t i = 0; i < count; ++i) {
        require_evsm_exponent(function, "filter.parameters.exponents", parameters.exponents[i]);
        require(holds_deviation(parameters.deviations[i], i == 0 ? 0.0f : parameters.exponents[i]), function,
                "filter.parameters.deviations", "finite, and large enough for the exponents", parameters.deviations[i],
                "make_evsm computes them.");
    }
}

/// Refuses a bias that moves moments away from those of depths in [-1, 1].
inline void require_msm_bias(std::string_view function, glm::vec2 bias) {
    require(all_finite(bias) && bias.x >= 0.0f && bias.x <= 1.0f && bias.y >= 0.0f && bias.y <= 1.0f, function,
            "filter.bias", "from 0 to 1", bias);
}

}  // namespace detail

namespace prefilters {

/// Depth and its square, in two 32-bit floats. Light bleeds behind casters that overlap at different depths.
struct vsm {
    using texel = glm::vec2;
    static constexpr std::string_view name = "vsm";
    static constexpr const glsl::snippet *writer = &glsl::encode_vsm, *snippet = &glsl::vsm;

    float min_variance = 1e-6f;
    depth_direction direction = depth_direction::forward;

    static constexpr auto numbers(auto& f) { return std::tie(f.min_variance); }
    static constexpr int writer_numbers = 0;  ///< how many of these, from the first on, the writer takes
    void check(std::string_view function) const {
        detail::require(is_finite(min_variance) && min_variance >= 0.0f, function, "filter.min_variance",
                        "finite, 0 or more", min_variance);
    }
    [[nodiscard]] UMBRAGE_INLINE texel encode(float depth) const { return encode_vsm(depth, cleared_depth(direction)); }
    [[nodiscard]] UMBRAGE_INLINE float decode(texel m, float receiver) const {
        return decode_vsm(m, receiver, min_variance, cleared_depth(direction));
    }
};

/// One power of depth. Light bleeds where a lit surface lies behind the receiver within the filter kernel.
struct esm {
    using texel = float;
    static constexpr std::string_view name = "esm";
    static constexpr const glsl::snippet *writer = &glsl::encode_esm, *snippet = &glsl::esm;

    esm_settings settings{};
    depth_direction direction = depth_direction::forward;

    static constexpr auto numbers(auto& f) { return std::tie(f.settings.exponent); }
    static constexpr int writer_numbers = 1;  ///< how many of these, from the first on, the writer takes
    void check(std::string_view function) const { detail::require_esm(function, "filter.settings.exponent", settings); }
    [[nodiscard]] UMBRAGE_INLINE texel encode(float depth) const {
        return encode_esm(depth, settings.exponent, cleared_depth(direction));
    }
    [[nodiscard]] UMBRAGE_INLINE float decode(texel m, float receiver) const {
        return decode_esm(m, receiver, settings.exponent, cleared_depth(direction));
    }
};

/// Power of depth and its square.
struct evsm2 {
    using texel = glm::vec2;
    static constexpr std::string_view name = "evsm2";
    static constexpr const glsl::snippet *writer = &glsl::encode_evsm2, *snippet = &glsl::evsm2;

    evsm_parameters parameters = make_evsm({});
    depth_direction direction = depth_direction::forward;

    static constexpr auto numbers(auto& f) { return std::tie(f.parameters.exponents.x, f.parameters.deviations.x); }
    static constexpr int writer_numbers = 1;  ///< how many of these, from the first on, the writer takes
    void check(std::string_view function) const { detail::require_evsm(function, parameters, 1); }
    [[nodiscard]] UMBRAGE_INLINE texel encode(float depth) const {
        return encode_evsm2(depth, parameters.exponents.x, cleared_depth(direction));
    }
    [[nodiscard]] UMBRAGE_INLINE float decode(texel m, float receiver) const {
        return decode_evsm2(m, receiver, parameters.exponents.x, parameters.deviations.x, cleared_depth(direction));
    }
};

/// Growing and falling power of depth, and their squares. Less light bleeding than vsm and evsm2.
struct evsm4 {
    using texel = glm::vec4;
    static constexpr std::string_view name = "evsm4";
    static constexpr const glsl::snippet *writer = &glsl::encode_evsm4, *snippet = &glsl::evsm4;

    evsm_parameters parameters = make_evsm({});
    depth_direction direction = depth_direction::forward;

    static constexpr auto numbers(auto& f) { return std::tie(f.parameters.exponents, f.parameters.deviations); }
    static constexpr int writer_numbers = 1;  ///< how many of these, from the first on, the writer takes
    void check(std::string_view function) const { detail::require_evsm(function, parameters, 2); }
    [[nodiscard]] UMBRAGE_INLINE texel encode(float depth) const {
        return encode_evsm4(depth, parameters.exponents, cleared_depth(direction));
    }
    [[nodiscard]] UMBRAGE_INLINE float decode(texel m, float receiver) const {
        return decode_evsm4(m, receiver, parameters.exponents, parameters.deviations, cleared_depth(direction));
    }
};

/// Four moments in 32-bit floats.
struct msm {
    using texel = glm::vec4;
    static constexpr std::string_view name = "msm";
    static constexpr const glsl::snippet *writer = &glsl::encode_msm, *snippet = &glsl::msm;

    glm::vec2 bias = msm_bias_32;
    depth_direction direction = depth_direction::forward;

    static constexpr auto numbers(auto& f) { return std::tie(f.bias); }
    static constexpr int writer_numbers = 0;  ///< how many of these, from the first on, the writer takes
    void check(std::string_view function) const { detail::require_msm_bias(function, bias); }
    [[nodiscard]] UMBRAGE_INLINE texel encode(float depth) const { return encode_msm(depth, cleared_depth(direction)); }
    [[nodiscard]] UMBRAGE_INLINE float decode(texel b, float receiver) const {
        return decode_msm(b, receiver, bias, cleared_depth(direction));
    }
    [[nodiscard]] UMBRAGE_INLINE glm::vec4 moments(texel b) const { return bias_moments(b, bias); }
};

/// Four optimized moments in 16-bit channels.
struct msm_unorm16 {
    using texel = glm::vec4;
    static constexpr std::string_view name = "msm_unorm16";
    static constexpr const glsl::snippet *writer = &glsl::to_optimized_moments, *snippet = &glsl::msm_unorm16;

    glm::vec2 bias = msm_bias_16;
    depth_direction direction = depth_direction::forward;

    static constexpr auto numbers(auto& f) { return std::tie(f.bias); }
    static constexpr int writer_numbers = 0;  ///< how many of these, from the first on, the writer takes
    void check(std::string_view function) const { detail::require_msm_bias(function, bias); }
    [[nodiscard]] UMBRAGE_INLINE texel encode(float depth) const {
        return to_optimized_moments(encode_msm(depth, cleared_depth(direction)));
    }
    [[nodiscard]] UMBRAGE_INLINE float decode(texel o, float receiver) const {
        return decode_msm(from_optimized_moments(o), receiver, bias, cleared_depth(direction));
    }
    [[nodiscard]] UMBRAGE_INLINE glm::vec4 moments(texel o) const {
        return bias_moments(from_optimized_moments(o), bias);
    }
};

/// Four moments in 32-bit floats, for depths known to lie in [0, 1].
struct msm_hausdorff {
    using texel = glm::vec4;
    static constexpr std::string_view name = "msm_hausdorff";
    static constexpr const glsl::snippet *writer = &glsl::encode_msm, *snippet = &glsl::msm_hausdorff;

    glm::vec2 bias = msm_bias_32;
    depth_direction direction = depth_direction::forward;

    static constexpr auto numbers(auto& f) { return std::tie(f.bias); }
    static constexpr int writer_numbers = 0;  ///< how many of these, from the first on, the writer takes
    void check(std::string_view function) const { detail::require_msm_bias(function, bias); }
    [[nodiscard]] UMBRAGE_INLINE texel encode(float depth) const { return encode_msm(depth, cleared_depth(direction)); }
    [[nodiscard]] UMBRAGE_INLINE float decode(texel b, float receiver) const {
        return decode_msm_hausdorff(b, receiver, bias, cleared_depth(direction));
    }
    [[nodiscard]] UMBRAGE_INLINE glm::vec4 moments(texel b) const { return bias_moments(b, bias); }
    /// Visibility from decode_msm's result.
    [[nodiscard]] UMBRAGE_INLINE static float within(float plain, const glm::vec4& moments, float forward) {
        return detail::lit_within(plain, moments, forward);
    }
};

/// List of the filters of prefiltered maps.
using all = list_of<vsm, esm, evsm2, evsm4, msm, msm_unorm16, msm_hausdorff>;

}  // namespace prefilters
}  // namespace umbrage
