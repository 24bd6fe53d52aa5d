// SPDX-License-Identifier: MIT
//
// Properties of the filters' values in JavaScript: arguments of their functions, reach, and texels that they read.
#pragma once

#include <algorithm>
#include <charconv>
#include <iterator>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <umbrage/filter/filters.hpp>
#include <umbrage/filter/prefiltered/prefilters.hpp>
#include <umbrage/shadow/depth_pass.hpp>
#include <umbrage/shadow/lookup.hpp>

#include "module_words.hpp"

namespace package {

/// A number, or an array of them.
inline std::string numbers(std::initializer_list<float> all) {
    std::string out;
    for (const float n : all) {
        char digits[32];
        const auto end = std::to_chars(std::begin(digits), std::end(digits), n).ptr;
        out += (out.empty() ? "" : ", ") + std::string(digits, end);
    }
    return all.size() == 1 ? out : '[' + out + ']';
}
inline std::string numbers(glm::vec2 v) { return numbers({v.x, v.y}); }
inline std::string numbers(glm::vec4 v) { return numbers({v.x, v.y, v.z, v.w}); }

inline std::string numbers(float v) { return numbers({v}); }
inline std::string numbers(int v) { return numbers({static_cast<float>(v)}); }
inline std::string numbers(const umbrage::penumbra_params& v) { return numbers(glm::vec4(v)); }

/// Defaults of what a filter's function takes behind coordinate and receiver.
template <umbrage::detail::with_numbers Filter>
[[nodiscard]] std::vector<std::string> defaults_of(const Filter& f) {
    std::vector<std::string> all;
    umbrage::detail::for_each_number(f, [&](const auto& number) { all.push_back(numbers(number)); });
    if constexpr (umbrage::detail::turning<Filter>) all.push_back(numbers(umbrage::disc_rotation(glm::vec2(0))));
    return all;
}
[[nodiscard]] inline std::vector<std::string> defaults_of(const umbrage::filters::four_tap&) { return {}; }

/// Kind of map that a filter needs. A comparison sampler is enough for filters that only compare.
template <class Filter>
[[nodiscard]] std::string_view reads(const Filter& f) {
    if (umbrage::prefilter<Filter>) return "moments";
    if (umbrage::detail::contact_hardening<Filter>) return "depths";
    try {
        (void)glsl::bind(*f.snippet, "a", {.texture = glsl::texture::shadow});
        return "comparisons";
    } catch (const std::invalid_argument&) { return "depths"; }
}

/// Parameters of a filter's function after coordinate and receiver, as its text declares them: type and name.
[[nodiscard]] inline std::vector<std::pair<std::string, std::string>> parameters_of(const snippet& s) {
    const std::string text = s.source.str(), start = "float umbrage_" + std::string(s.name) + '(';
    const auto begin = text.find(start) + start.size();
    const std::string parameters = text.substr(begin, text.find(") {", begin) - begin);
    constexpr std::string_view of_all[]{"map", "size", "coord", "receiver", "a", "b", "c", "d"};
    std::vector<std::pair<std::string, std::string>> further;
    for (const std::string_view member : glsl::detail::members(parameters)) {
        const auto words = glsl::detail::words_of(member);
        if (std::ranges::count(of_all, words.back()) == 0) further.emplace_back(words[words.size() - 2], words.back());
    }
    return further;
}
template <class Filter>
[[nodiscard]] std::vector<std::string> names_of_arguments(const Filter& f) {
    std::vector<std::string> names;
    for (const auto& [type, name] : parameters_of(*f.snippet)) names.push_back(name);
    return names;
}

/// The same with defaults.
template <class Filter>
[[nodiscard]] std::string arguments_of(const Filter& f) {
    const auto parameters = parameters_of(*f.snippet);
    const auto values = defaults_of(f);
    if (parameters.size() != values.size())
        throw std::runtime_error("defaults for other arguments than those of " + std::string(f.snippet->name));
    std::string out;
    for (std::size_t i = 0; i < values.size(); ++i)
        out += std::string(out.empty() ? "" : ", ") + "{ name: " + literal(parameters[i].second) +
               ", type: " + literal(parameters[i].first) + ", value: " + values[i] + " }";
    return '[' + out + ']';
}

/// The target of a prefiltered map, its empty texel, and what its depth pass calls.
template <class Filter>
[[nodiscard]] std::string target_of_moments(Filter f) {
    const auto cleared = [&](umbrage::depth_direction direction) {
        f.direction = direction;
        const auto texel = f.encode(umbrage::cleared_depth(direction));
        if constexpr (std::is_same_v<std::decay_t<decltype(texel)>, float>) return numbers({texel, 0, 0, 0});
        else if constexpr (Filter::texel::length() == 2) return numbers({texel.x, texel.y, 0, 0});
        else return numbers({texel.x, texel.y, texel.z, texel.w});
    };
    return ", format: " + literal(format_of_moments<Filter>()) +
           ", cleared: " + cleared(umbrage::depth_direction::forward) +
           ", cleared_reversed: " + cleared(umbrage::depth_direction::reversed) + ", write: write_" +
           std::string(Filter::name);
}

/// The property of a filter's snippet; of other snippets nothing.
inline std::string filter_of(const snippet& s) {
    static const std::map<std::string_view, std::string> all = [] {
        std::map<std::string_view, std::string> filters;
        const auto add = [&](const auto& f) {
            std::string out = " filter: { reads: " + literal(reads(f)) +
                              ", reach: " + numbers({umbrage::detail::reach_of(f)}) + ", arguments: " + arguments_of(f);
            using type = std::decay_t<decltype(f)>;
            if constexpr (umbrage::shadow_filter<type>) out += ", in_shadow: true";
            if constexpr (umbrage::detail::disc_filter<type>) out += ", disc: true";
            if constexpr (umbrage::shadow_filter<type> && !umbrage::prefilter<type>)
                if (const auto form = glsl::linear_form_of(f); form.what)
                    out +=
                        ", linear: { name: " + literal(form.what->name) + ", weights: " + literal(form.weights) + " }";
            if constexpr (std::is_same_v<type, umbrage::filters::four_tap>) {
                out += ", offsets: [";
                for (const glm::vec2 offset : f.offsets) out += (out.back() == '[' ? "" : ", ") + numbers(offset);
                out += ']';
            }
            if constexpr (umbrage::prefilter<type>) out += target_of_moments(f);
            filters[f.snippet->name] = out + " },";
        };
        umbrage::filters::all::for_each(add);
        umbrage::filters::soft::for_each(add);
        umbrage::prefilters::all::for_each(add);
        return filters;
    }();
    const auto found = all.find(s.name);
    return found == all.end() ? "" : found->second;
}

/// Texts that a prefilter's snippet refers to.
inline std::string before_filter(const shader_language& l, const snippet& s) {
    std::string out;
    umbrage::prefilters::all::for_each([&](const auto& f) {
        if (*f.snippet == s)
            out = "\nconst write_" + std::string(f.name) + " = " +
                  own_snippet(l, glsl::detail::write_moments_text<std::decay_t<decltype(f)>>(),
                              "texel of a depth, as a color", "") +
                  ";\n";
    });
    return out;
}

}  // namespace package
