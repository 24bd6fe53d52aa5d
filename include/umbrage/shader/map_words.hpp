// SPDX-License-Identifier: MIT
//
// Text of a snippet, in any language, with the words that a map fills in.
//
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/common.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/core/config.hpp>
#include <umbrage/shader/bind.hpp>
#include <umbrage/shader/hook_choice.hpp>

namespace umbrage::glsl::detail {

/// Words of a language for a texture type. Expressions read it at `at`, a vec2 of integers, or at `uv`, a vec2 from 0
/// to 1.
struct texture_words {
    std::string_view parameters, arguments;
    std::string_view texel{};                       ///< a vec4. Lines that begin with # replace the statement
    std::string_view sampled{};                     ///< vec4 at `uv`
    std::string_view lit{};                         ///< comparison of the sampler with `receiver`: float
    std::string_view gather_red{}, gather_green{};  ///< vec4
    std::string_view gather_lit{};                  ///< comparisons of the sampler with `receiver`: vec4
    std::string_view lit_filtered{};                ///< comparisons around `uv`, weighted by the sampler: float
    std::string_view size{};                        ///< size of the texture: vec2
    std::string_view sampler{},
        sampler_argument{};                   ///< sampler parameter after the first one, for gathers: ", sampler s"
    std::span<const snippet* const> needs{};  ///< snippets that these words call
};

/// Name of a text's map parameter: `map`, or `table`.
template <class = umbrage::detail::on_use>
[[nodiscard]] std::string name_of_map(std::string_view text) {
    const std::string_view type = "UMBRAGE_MAP ";
    const auto at = text.find(type);
    if (at == text.npos) return "map";
    text.remove_prefix(at + type.size());
    return std::string(text.substr(0, text.find_first_of(",)")));
}

/// Names that parameters declare: `map` for "sampler2D map", "map: texture_2d<f32>" and "sampler2D map[4]".
template <class = umbrage::detail::on_use>
[[nodiscard]] std::vector<std::string_view> declared(std::string_view parameters) {
    std::vector<std::string_view> names;
    for (const std::string_view parameter : members(parameters)) {
        std::size_t end = 0;  // end of the name: a type may follow, or a number of elements
        while (end < parameter.size() && parameter[end] != '[' && parameter[end] != ':')
            end += parameter.substr(end + 1).starts_with("::") ? 3u : 1u;
        const auto all = words_of(parameter.substr(0, end));
        if (!all.empty()) names.push_back(all.back());
    }
    return names;
}

/// Parameters that declare a map: the binding's own, or those of its texture type, with a sampler for gathers.
template <class = umbrage::detail::on_use>
[[nodiscard]] std::string parameters_of(const binding& map, const texture_words& words) {
    if (!map.parameters.empty()) return map.parameters;
    std::string all(words.parameters);
    if (map.gather) all.insert((glm::min)(all.find(','), all.size()), words.sampler);
    return all;
}

/// Parameters, without those that the text declares: the layer or the origin of a map that it chooses.
template <class = umbrage::detail::on_use>
[[nodiscard]] std::string not_declared_in(std::string_view text, const std::string& parameters) {
    std::string rest;
    for (const std::string_view parameter : members(parameters)) {
        const auto declares = [&](std::string_view name) {
            const std::string apart = ' ' + std::string(name);
            return text.find(apart + " = ") != text.npos || text.find(apart + ": ") != text.npos;
        };
        const std::vector<std::string_view> names = declared(parameter);  // none of a blank one
        const bool chosen = !names.empty() && declares(names.front());
        if (!chosen) rest.append(rest.empty() ? "" : ",").append(parameter);
    }
    return rest;
}

/// Text of a snippet with the words that a map fills in.
/// @param receiver_plane   declaration of the receiver's plane after the map
/// @throws std::invalid_argument   own parameters that lack one that is read, or use a name of the text
template <class = umbrage::detail::on_use>
[[nodiscard]] std::string for_map(std::string text, const snippet& s, const bound& item, const texture_words& words,
                                  std::string_view receiver_plane = {}) {
    const binding& map = item.map;
    const auto one_of = [](const std::string& own, std::string_view ordinary) {
        return own.empty() ? std::string(ordinary) : own;
    };
    const std::string origin = as_operand(map.texture == texture::atlas ? one_of(map.origin, "origin") : map.origin);
    // Farther than every depth where depths have their own scale.
    const std::string border = is_scaled(map) ? "65536.0" : map.direction == depth_direction::forward ? "1.0" : "0.0";
    const std::string texture_size = one_of(as_operand(map.texture_size), origin.empty() ? "size" : words.size);
    const auto replace = [&](std::string_view what, std::string_view with) {
        for (auto at = text.find(what); at != text.npos; at = text.find(what, at + with.size()))
            text.replace(at, what.size(), with);
    };
    const std::string texel = one_of(map.texel, words.texel);
    if (texel.starts_with('#')) replace("    return UMBRAGE_TEXEL;\n", "UMBRAGE_TEXEL");
    if (const auto at = text.find("UMBRAGE_ORIGIN"); at != text.npos && origin.empty()) {
        const auto begin = text.rfind('\n', at);
        text.erase(begin, text.find('\n', at) - begin);
    }
    const std::string own_map = name_of_map(text);
    replace("UMBRAGE_MAP " + own_map, "UMBRAGE_PARAMETERS");
    std::string ordinary(words.arguments);
    if (map.gather) ordinary.insert((glm::min)(ordinary.find(','), ordinary.size()), words.sampler_argument);
    const std::string parameters = parameters_of(map, words);
    const std::string arguments = one_of(map.arguments, ordinary);
    umbrage::detail::require(members(parameters).size() == members(arguments).size(), "glsl::bind", "map.arguments",
                             "as many as map.parameters", arguments, "The parameters are " + parameters + ".");
    const std::vector<std::string_view> names = declared(parameters);
    if (!map.parameters.empty())
        for (const std::string_view word : words_of(text))
            umbrage::detail::require(word == own_map || !contains(names, word), "glsl::bind", "map.parameters",
                                     "named otherwise than what umbrage_" + std::string(s.name) + " names", word);
    /// Words of the language. The map's own parameters must declare their arguments too.
    const auto ours = [&](std::string_view expression) {
        for (const std::string_view word : words_of(expression))
            umbrage::detail::require(!contains(words_of(ordinary), word) || contains(names, word), "glsl::bind",
                                     "map.parameters", "parameters that declare " + std::string(word), parameters);
        return expression;
    };
    if (map.arguments.empty()) ours(arguments);
    const bool passes_plane = !receiver_plane.empty() || contains(words_of(text), "receiver_slope");
    const std::string plane = map.receiver_plane && passes_plane ? ", receiver_slope, receiver_at" : "";
    const std::string depth = one_of(map.depth, "value.x");
    const auto list = [&](const std::string& all) {
        return replace_words(all,
                             [&](std::string_view word, bool) { return word == "map" ? own_map : std::string(word); });
    };

    const auto suffixed = [&](std::string_view word) {
        const auto is_it = [name = word.substr(8)](const snippet& own) { return own.name == name && is_of_map(own); };
        bool own = word.substr(8) == s.name;
        for (const snippet& need : map.needs) own = own || is_it(need);
        for (const snippet* need : s.needs) own = own || is_it(*need);
        return std::string(word) + (own ? item.suffix : std::string());
    };
    const auto of_texture = [&](std::string_view expression) {
        return replace_words(expression, [&](std::string_view word, bool) -> std::string {
            if (word.starts_with("umbrage_")) return suffixed(word);
            if (word == "at" && origin.empty()) return "texel";
            if (word != "UMBRAGE_TEXTURE_SIZE") return std::string(word);
            umbrage::detail::require(!texture_size.empty(), "glsl::bind", "map.texture_size",
                                     "given for a region that this language's sampler reads", "");
            return texture_size;
        });
    };
    return replace_words(text, [&](std::string_view word, bool comment) -> std::string {
        if (word.starts_with("umbrage_")) return suffixed(word);
        if (word == own_map && !comment) return list(arguments) + plane;
        if (word == "UMBRAGE_PARAMETERS") {
            const std::string_view comma = receiver_plane.empty() ? "" : ", ";
            return list(not_declared_in(text, parameters)).append(comma).append(receiver_plane);
        }
        if (word == "UMBRAGE_BORDER") return border;
        if (word == "UMBRAGE_COMPARE") return of_texture(map.compare);
        if (word == "UMBRAGE_DEPTH")
            return of_texture(map.receiver_plane
                                  ? "umbrage_apply_receiver_plane(" + depth + ", receiver_slope, receiver_at, texel)"
                                  : depth);
        if (word == "UMBRAGE_REFERENCE")
            return of_texture(is_bordered(map)
                                  ? "umbrage_bordered_plane_reference(receiver_slope, receiver_at, texel, inside)"
                                  : "umbrage_plane_reference(receiver_slope, receiver_at, texel)");
        if (word == "UMBRAGE_CORNER") return of_texture("umbrage_corner_reference(receiver_slope, way, receiver)");
        if (word == "UMBRAGE_STORED") return of_texture(depth);
        if (word == "UMBRAGE_ORIGIN") return origin;
        if (word == "UMBRAGE_TEXEL") return of_texture(map.texel.empty() ? ours(texel) : texel);
        if (word == "UMBRAGE_LIT_TEXEL") return of_texture(ours(words.lit));
        if (word == "UMBRAGE_UV") return of_texture("at / UMBRAGE_TEXTURE_SIZE");
        if (word == "UMBRAGE_SAMPLED") return of_texture(ours(words.sampled));
        if (word == "UMBRAGE_LIT_FILTERED") return of_texture(ours(words.lit_filtered));
        if (word == "UMBRAGE_GATHER_RED") return of_texture(ours(words.gather_red));
        if (word == "UMBRAGE_GATHER_GREEN") return of_texture(ours(words.gather_green));
        if (word == "UMBRAGE_GATHER_LIT") return of_texture(ours(words.gather_lit));
        return std::string(word);
    });
}

}  // namespace umbrage::glsl::detail
