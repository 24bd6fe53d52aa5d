// SPDX-License-Identifier: MIT
//
// Lookup of a filter in one map of a shadow, in C++ and in GLSL: the receiver's bias, and the filter's call.
//
// Percentage-closer filters (PCF) take the smallest bias for their reach. Contact hardening (PCSS, DPCF) compares along
// the receiver's plane, as its radius differs from receiver to receiver. Prefiltered maps (VSM, ESM, EVSM, MSM) have
// texels of their own.
#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/bias/acne_free.hpp>
#include <umbrage/bias/constant.hpp>
#include <umbrage/bias/receiver_plane.hpp>
#include <umbrage/core/image.hpp>
#include <umbrage/depth/depth32f.hpp>
#include <umbrage/filter/filters.hpp>
#include <umbrage/filter/prefiltered/prefilters.hpp>
#include <umbrage/images/visibility.hpp>
#include <umbrage/shader/bind.hpp>
#include <umbrage/shadow/set_up.hpp>

namespace umbrage {

/// Texels of a prefiltered map, used in place of an encoding.
template <prefilter Prefilter>
struct moment_texels {
    using texel = typename Prefilter::texel;

    depth_direction direction = depth_direction::forward;
    [[nodiscard]] constexpr decoding_error error() const { return {}; }
};

namespace detail {

/// Filter that takes a coordinate and a receiver, perhaps a pixel, and numbers of its own. It compares in either
/// direction of depth.
template <class Filter>
concept point_filter = known_filter<Filter> && with_numbers<Filter> &&
    std::same_as<decltype(Filter::is_lit), comparison> && requires(const Filter& f, const any_fetch& fetch) {
    f(fetch, glm::vec2(), 0.0f);
};

/// Filter whose radius differs from receiver to receiver. One bias for all receivers would be large.
template <class Filter>
concept contact_hardening =
    point_filter<Filter> && std::same_as<numbers_of<const Filter>, std::tuple<const penumbra_params&>>;

/// Prefilter whose texels a shader decodes and writes.
template <class Prefilter>
concept known_prefilter = prefilter<Prefilter> && with_numbers<Prefilter> && requires {
    { Prefilter::snippet } -> std::convertible_to<const glsl::snippet*>;
    { Prefilter::writer } -> std::convertible_to<const glsl::snippet*>;
    { Prefilter::writer_numbers } -> std::convertible_to<int>;  // of its numbers, how many the writer takes
};

/// Filter that reads a disc of one radius. Its bias is acne_free_disc_bias.
template <class Filter>
concept disc_filter =
    point_filter<Filter> && !contact_hardening<Filter> && width_of_numbers<Filter> < 4 && requires(const Filter& f) {
    f.farthest_point();
};

/// Filter whose disc has another rotation in each pixel.
template <class Filter>
concept turning = point_filter<Filter> && requires(const Filter& f, const any_fetch& fetch) {
    f(fetch, glm::vec2(), 0.0f, glm::ivec2());
};

template <class Filter>
struct encoding_for {
    using type = depth32f;
};
template <prefilter Prefilter>
struct encoding_for<Prefilter> {
    using type = moment_texels<Prefilter>;
};

}  // namespace detail

/// Filter that a shadow takes.
template <class Filter>
concept shadow_filter = detail::point_filter<Filter> || detail::known_prefilter<Filter>;

/// Encoding that a shadow takes: one of depths, or a prefilter's own moments.
template <class Encoding, class Filter>
concept shadow_encoding = (!prefilter<Filter> && known_encoding<Encoding>) ||
                          (prefilter<Filter> && std::same_as<Encoding, typename detail::encoding_for<Filter>::type>);

namespace detail {

/// Distance along an axis from a receiver to the farthest texel that counts, texels.
[[nodiscard]] constexpr float reach_of(const auto& filter) {
    if constexpr (requires { filter.reach(); }) return filter.reach();
    else return 1.0f;  // a prefilter reads the four texels around it
}

/// Checks that a shadow takes a filter and an encoding, with a readable error message.
template <class Filter, class Encoding>
consteval bool shadow_takes() {
    static_assert(
        with_numbers<Filter>,
        "a shadow's filter has `static constexpr auto numbers(auto& f) { return std::tie(...); }`: those that "
        "its snippet takes after the receiver, each int, float or a glm::vec, four floats at most");
    static_assert(!with_numbers<Filter> || shadow_filter<Filter>,
                  "a shadow's filter has `name`, `snippet`, `float reach() const` and an umbrage::comparison `is_lit`, "
                  "or it is a prefilter with `snippet`, `writer` and `writer_numbers`");
    static_assert(shadow_encoding<Encoding, Filter>,
                  "a shadow's encoding is one of depths; a prefilter's map has no other than its moments");
    return true;
}

/// Component of filter_terms behind a filter's numbers. That of a disc's filter is its farthest point, for the bias.
template <class Filter>
inline constexpr glm::length_t component_for_disc = width_of_numbers<Filter>;

/// Numbers of a filter, as the uniform block holds them.
/// @param more   texels that the rasterizer and rounding add to a reach
template <class Filter>
[[nodiscard]] constexpr glm::vec4 terms_of(const Filter& filter, float more) {
    glm::vec4 all = packed_numbers(filter);
    if constexpr (disc_filter<Filter>) all[component_for_disc<Filter>] = filter.farthest_point() + more;
    return all;
}

/// Bias of a receiver, in depth.
template <class Filter>
[[nodiscard]] float bias_of(const shadow_terms& terms, glm::vec2 slope) {
    if constexpr (contact_hardening<Filter>) return acne_free_bias(slope, 0.5f, terms.error);
    else if constexpr (disc_filter<Filter>)
        return acne_free_disc_bias(slope, terms.filter_terms[component_for_disc<Filter>], terms.error);
    else return acne_free_bias(slope, terms.reach, terms.error);
}

/// Visibility of a receiver in one map, by a filter.
/// @param own        this map alone
/// @param receiver   x and y in texels of the map, z depth with the bias already applied
template <outside_map Outside, class Filter, class Encoding>
[[nodiscard]] float look(image_view<const typename Encoding::texel> own, const Filter& filter, const Encoding& encoding,
                         glm::vec3 receiver, [[maybe_unused]] glm::vec2 slope, [[maybe_unused]] glm::ivec2 pixel) {
    const glm::vec2 coord(receiver);
    const auto on = [&](const auto& map) {
        if constexpr (prefilter<Filter>) {
            const auto decode = [&](const auto& texel) { return filter.decode(texel, receiver.z); };
            return look_up(map, coord, receiver.z, cleared_depth(encoding.direction), decode);
        } else if constexpr (contact_hardening<Filter>) {
            const auto along = apply_receiver_plane(decoded(map, encoding), slope, coord, encoding.direction);
            return filtered(filter, along, coord, receiver.z, pixel);
        } else return filtered(filter, decoded(map, encoding), coord, receiver.z, pixel);
    };
    if constexpr (Outside == outside_map::clamped) return on(clamped(own));
    else return on(bordered_texels<typename Encoding::texel>{own});
}

/// A component of filter_terms in GLSL.
[[nodiscard]] inline std::string filter_term(int component) { return std::string("filter_terms.") + "xyzw"[component]; }

/// GLSL version of terms_of: a filter's numbers, from the first on, as arguments after others.
/// @param count   how many of them
template <class Filter>
[[nodiscard]] std::string numbers_text(int count) {
    std::string all;
    int at = 0;
    const auto add = [&]<class Number>(std::type_identity<Number>) {
        if (count-- <= 0) return;
        const std::string_view type = glsl::number_type<Number>;
        std::string terms = filter_term(at++);
        for (int i = 1; i < width_of_number<Number>; ++i) terms += ", " + filter_term(at++);
        all += ", " + (type == "float" ? terms : std::string(type) + '(' + terms + ')');
    };
    [&]<class... Numbers>(std::type_identity<std::tuple<const Numbers&...>>) {
        (add(std::type_identity<Numbers>()), ...);
    }(std::type_identity<numbers_of<const Filter>>());
    return all;
}

/// Arguments of a filter's function after coordinate and receiver, in GLSL.
template <class Filter>
[[nodiscard]] std::string arguments_of() {
    return numbers_text<Filter>(4) + (turning<Filter> ? ", umbrage_disc_rotation(pixel)" : "");
}

/// Snippet that computes bias_of.
template <class Filter>
[[nodiscard]] constexpr const glsl::snippet& bias_snippet() {
    return disc_filter<Filter> ? glsl::acne_free_disc_bias : glsl::acne_free_bias;
}
/// GLSL version of bias_of: a statement that uses `slope` and `terms`.
template <class Filter>
[[nodiscard]] std::string bias_text() {
    std::string reach = "terms.z";
    if constexpr (contact_hardening<Filter>) reach = "0.5";
    else if constexpr (disc_filter<Filter>) reach = filter_term(component_for_disc<Filter>);
    return std::string("    UMBRAGE_HIGHP float bias = umbrage_") + std::string(bias_snippet<Filter>().name) +
           "(slope, " + reach + ", terms.w);\n";
}

/// GLSL version of look: umbrage_look, for one filter and its map.
/// @param terms          declaration of shadow_terms
/// @param pixel          declaration of a pixel, for filters with a rotated disc
template <class Filter>
[[nodiscard]] glsl::own_text look_text(const Filter& filter, const std::string& terms, const std::string& pixel) {
    std::string text =
        "\n// umbrage_look: visibility of a receiver in one map\n"
        "UMBRAGE_HIGHP float umbrage_look(UMBRAGE_MAP map, ";
    text.append(terms).append("UMBRAGE_HIGHP vec3 at, UMBRAGE_HIGHP vec2 slope").append(pixel).append(") {\n");
    if (contact_hardening<Filter>)
        text +=
            "    UMBRAGE_HIGHP vec2 receiver_slope = slope;\n"
            "    UMBRAGE_HIGHP vec2 receiver_coord = vec2(at.x, at.y);\n";
    text.append(bias_text<Filter>());
    text.append("    UMBRAGE_HIGHP float receiver = umbrage_biased(at.z, bias);\n    return umbrage_");
    text.append(filter.snippet->name).append("(map, vec2(terms.x, terms.y), vec2(at.x, at.y), receiver");
    text.append(arguments_of<Filter>()).append(");\n}\n");
    glsl::own_text look{"look", std::move(text), {&bias_snippet<Filter>(), &glsl::biased, filter.snippet}};
    if (turning<Filter>) look.needs.push_back(&glsl::disc_rotation);
    return look;
}

/// Text of a setup with one more argument in each call of umbrage_look.
[[nodiscard]] inline std::string with_argument(std::string text, std::string_view argument) {
    for (auto i = text.find("umbrage_look("); i != text.npos; i = text.find("umbrage_look(", i)) {
        i = text.find(";\n", i) - 1;
        text.insert(i, std::string(", ").append(argument));
    }
    return text;
}

/// Binding of a filter's map in a shader.
template <class Filter, class Encoding>
[[nodiscard]] glsl::binding binding_of(const Encoding& encoding) {
    glsl::binding map{.direction = encoding.direction, .receiver_plane = contact_hardening<Filter>};
    if constexpr (prefilter<Filter>) return map;
    else return glsl::stored_as(encoding, std::move(map));
}

}  // namespace detail
}  // namespace umbrage
