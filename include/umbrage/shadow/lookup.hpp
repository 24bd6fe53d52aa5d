// SPDX-License-Identifier: MIT
//
// Lookup of a filter in one map of a shadow, in C++ and in GLSL: the receiver's bias, and the filter's call.
//
// Percentage-closer filters (PCF) and contact hardening (PCSS, DPCF) compare along the receiver's plane, with the slack
// of its place as bias. Maps that bend planes take one bias for the filter's whole reach. So do prefiltered maps (VSM,
// ESM, EVSM, MSM), which have texels of their own.
#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/bias/acne_free.hpp>
#include <umbrage/bias/constant.hpp>
#include <umbrage/bias/receiver_plane.hpp>
#include <umbrage/core/image.hpp>
#include <umbrage/depth/depth32f.hpp>
#include <umbrage/filter/filters.hpp>
#include <umbrage/filter/pcf/linear_form.hpp>
#include <umbrage/filter/prefiltered/prefilters.hpp>
#include <umbrage/images/visibility.hpp>
#include <umbrage/shader/bind.hpp>
#include <umbrage/shadow/setup.hpp>

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
    std::same_as<decltype(Filter::direction), depth_direction> && requires(const Filter& f, const any_fetch& fetch) {
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
                  "a shadow's filter has `name`, `snippet`, `float reach() const` and a depth_direction "
                  "`direction`, or it is a prefilter with `snippet`, `writer` and `writer_numbers`");
    static_assert(shadow_encoding<Encoding, Filter>,
                  "a shadow's encoding is one of depths; a prefilter's map has no other than its moments");
    return true;
}

/// Component of filter_terms behind a filter's numbers. A disc stores its farthest point there, for the bias.
template <class Filter>
inline constexpr glm::length_t component_for_disc = width_of_numbers<Filter>;

/// Filter parameters as stored in the uniform block.
/// @param more   texels that the rasterizer and rounding add to a reach
template <class Filter>
[[nodiscard]] constexpr glm::vec4 terms_of(const Filter& filter, float more) {
    glm::vec4 all = packed_numbers(filter);
    if constexpr (disc_filter<Filter>) all[component_for_disc<Filter>] = filter.farthest_point() + more;
    return all;
}

/// True where a shadow compares along the receiver's plane.
template <class Setup, class Filter>
inline constexpr bool along_plane = point_filter<Filter> && !has_bent_lines<Setup>;

/// Bias of a receiver for a filter's whole reach, in depth.
template <class Filter>
[[nodiscard]] float kernel_bias_of(const shadow_terms& terms, const map_place& place) {
    const float error = terms.error + place.slack;
    if constexpr (disc_filter<Filter>)
        return acne_free_disc_bias(place.slope, terms.filter_terms[component_for_disc<Filter>], error);
    else return acne_free_bias(place.slope, terms.reach, error);
}

/// True for a plane that filters compare along. False where the light sees it edge-on: there the slopes in x and y add
/// up to 2 or more, or are NaN.
[[nodiscard]] inline bool is_seen(const map_place& place) {
    const float steep = glm::abs(place.slope.x) + glm::abs(place.slope.y);
    return !is_nan(steep) && steep < 2.0f;
}

/// Bias of a receiver, in depth: 1 on planes that the light sees edge-on.
template <class Setup, class Filter>
[[nodiscard]] float bias_of(const shadow_terms& terms, const map_place& place) {
    if constexpr (along_plane<Setup, Filter>) {
        return is_seen(place) ? glm::clamp(terms.error + place.slack, 0.0f, 1.0f) : 1.0f;
    } else return kernel_bias_of<Filter>(terms, place);
}

/// True for a receiver that filters compare. Others are lit: beyond the far plane, from where no bias brings them back,
/// and on planes that the light sees edge-on.
template <class Setup, class Filter>
[[nodiscard]] bool is_compared(const map_place& place, depth_direction direction) {
    const bool beyond = comparison{direction}.beyond_far_plane(place.at.z);
    return !beyond && (!along_plane<Setup, Filter> || is_seen(place));
}

/// Coordinate of a place, in texels, and its depth with the bias applied. What is not compared lies outside all maps.
template <class Setup, class Filter>
[[nodiscard]] glm::vec3 receiver_of(const shadow_terms& terms, const map_place& place, depth_direction direction) {
    const float x = is_compared<Setup, Filter>(place, direction) ? place.at.x : 65536.0f;
    return {x, place.at.y, biased(place.at.z, bias_of<Setup, Filter>(terms, place), direction)};
}

/// Visibility of a receiver in one map, by a filter.
/// @param own        this map alone
/// @param filter     a Filter, or one that calls it
/// @param receiver   x and y in texels of the map, z depth with the bias already applied
template <class Setup, class Filter, class Encoding>
[[nodiscard]] float look(image_view<const typename Encoding::texel> own, const auto& filter, const Encoding& encoding,
                         glm::vec3 receiver, [[maybe_unused]] glm::vec2 slope, [[maybe_unused]] glm::ivec2 pixel) {
    const glm::vec2 coord(receiver);
    const auto on = [&](const auto& map) {
        if constexpr (prefilter<Filter>) {
            const auto decode = [&](const auto& texel) { return filter.decode(texel, receiver.z); };
            return look_up(map, coord, receiver.z, cleared_depth(encoding.direction), decode);
        } else if constexpr (along_plane<Setup, Filter>) {
            const auto along = apply_receiver_plane(decoded(map, encoding), slope, receiver, encoding.direction);
            return filtered(filter, along, coord, receiver.z, pixel);
        } else return filtered(filter, decoded(map, encoding), coord, receiver.z, pixel);
    };
    if constexpr (Setup::outside == outside_map::clamped) return on(clamped(own));
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
/// @param sheared   true where the rotation of a disc follows `shear`
template <class Filter>
[[nodiscard]] std::string arguments_of(bool sheared = false) {
    if (!turning<Filter>) return numbers_text<Filter>(4);
    const std::string rotation = "umbrage_disc_rotation(pixel)";
    return numbers_text<Filter>(4) + ", " + (sheared ? "umbrage_sheared_rotation(" + rotation + ", shear)" : rotation);
}

/// Snippet that computes the bias for a filter's whole reach.
template <class Filter>
[[nodiscard]] constexpr const glsl::snippet& kernel_bias_snippet() {
    return disc_filter<Filter> ? glsl::acne_free_disc_bias : glsl::acne_free_bias;
}
/// GLSL version of bias_of: statements that use `terms` and `slope`, whose third component is the place's slack. Along
/// planes `bias` counts where `is_seen` is true.
/// @param linear   true where a sampler weights comparisons: then texels lie half a texel beside the plane's depth
template <class Setup, class Filter>
[[nodiscard]] std::string bias_text(bool linear = false) {
    const std::string error =
        std::string(linear ? "    " : "    UMBRAGE_PRECISE ") + "UMBRAGE_HIGHP float error = terms.w + slope.z";
    if constexpr (along_plane<Setup, Filter>)
        return error + (linear ? " + 0.5 * (abs(slope.x) + abs(slope.y));\n" : ";\n") +
               "    bool is_seen = abs(slope.x) + abs(slope.y) < 2.0;  // not edge-on by the light\n"
               "    UMBRAGE_HIGHP float bias = clamp(error, 0.0, 1.0);\n";
    std::string reach = "terms.z";
    if constexpr (disc_filter<Filter>) reach = filter_term(component_for_disc<Filter>);
    return error + ";\n    UMBRAGE_HIGHP float bias = umbrage_" + std::string(kernel_bias_snippet<Filter>().name) +
           "(vec2(slope.x, slope.y), " + reach + ", error);\n";
}

/// GLSL version of look: umbrage_look, for one filter and its map.
/// @param terms          declaration of shadow_terms
/// @param pixel          declaration of a pixel, for filters with a rotated disc
/// @param sheared        true for a filter whose disc's rotation follows a shear, behind the pixel
/// @param linear         form of the filter for a linear comparison sampler; none: the filter itself
template <class Setup, class Filter>
[[nodiscard]] glsl::own_text look_text(const Filter& filter, const std::string& terms, const std::string& pixel,
                                       bool sheared = false, const glsl::linear_form& linear = {}) {
    const glsl::snippet& called = linear.what ? *linear.what : *filter.snippet;
    std::string text =
        "\n// umbrage_look: visibility of a receiver in one map\n"
        "UMBRAGE_HIGHP float umbrage_look(UMBRAGE_MAP map, ";
    text.append(terms).append("UMBRAGE_HIGHP vec3 at, UMBRAGE_HIGHP vec3 slope").append(pixel);
    text.append(sheared ? ", UMBRAGE_HIGHP float shear) {\n" : ") {\n");
    text.append(bias_text<Setup, Filter>(linear.what != nullptr));
    text.append("    bool is_compared = umbrage_beyond_far_plane(at.z) ? false : ");
    text.append(along_plane<Setup, Filter> ? "is_seen;\n" : "true;\n");
    text.append(
        "    UMBRAGE_HIGHP vec2 coord = vec2(is_compared ? at.x : 65536.0, at.y);  // outside all maps, where all is "
        "lit\n"
        "    UMBRAGE_HIGHP float receiver = umbrage_cleared_depth() > 0.5 ? at.z - bias : at.z + bias;\n");
    if (along_plane<Setup, Filter>)
        text +=
            "    UMBRAGE_HIGHP vec2 receiver_slope = vec2(slope.x, slope.y);\n"
            "    UMBRAGE_HIGHP vec3 receiver_at = vec3(at.x, at.y, receiver);\n";
    text.append("    return umbrage_").append(called.name);
    text.append("(map, vec2(terms.x, terms.y), coord, receiver").append(linear.weights);
    text.append(arguments_of<Filter>(sheared)).append(");\n}\n");
    glsl::own_text look{"look", std::move(text), {&glsl::beyond_far_plane, &glsl::cleared_depth, &called}};
    if (!along_plane<Setup, Filter>) look.needs.push_back(&kernel_bias_snippet<Filter>());
    if (turning<Filter>) look.needs.push_back(&glsl::disc_rotation);
    if (sheared) look.needs.push_back(&glsl::sheared_rotation);
    return look;
}

/// Binding of a filter's map in a shader.
template <class Setup, class Filter, class Encoding>
[[nodiscard]] glsl::binding binding_of(const Encoding& encoding) {
    glsl::binding map{.direction = encoding.direction, .receiver_plane = along_plane<Setup, Filter>};
    if constexpr (prefilter<Filter>) return map;
    else return glsl::stored_as(encoding, std::move(map));
}

}  // namespace detail
}  // namespace umbrage
