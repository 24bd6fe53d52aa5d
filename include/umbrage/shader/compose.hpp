// SPDX-License-Identifier: MIT
//
// Composition of bound snippets into one text, in any language: each part once, after its needs.
//
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/common.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/core/config.hpp>
#include <umbrage/shader/bind.hpp>
#include <umbrage/shader/hook_choice.hpp>
#include <umbrage/shader/map_words.hpp>
#include <umbrage/shader/translate/layout.hpp>
#include <umbrage/version.hpp>

namespace umbrage::glsl::detail {

/// Description of a shader language.
struct language {
    std::string_view prelude;  ///< first lines of every text
    texture_words (*texture)(glsl::texture kind);
    std::string (*translate)(const snippet& s);  ///< a snippet's text, with the words that a map fills in
    std::string_view receiver_plane;             ///< declarations of receiver_slope and receiver_at
    std::string_view may_reorder{};  ///< the language's name if compilers may fuse or reorder sums; else empty
    bool preprocessor = true;        ///< guards parts against being pasted twice
    std::string_view function = "glsl::text";  ///< function that the user called
    declaration (*declare)(const shader_interface& i, const map_parameter& map, version v) = nullptr;
    std::optional<version> dialect{};  ///< GLSL version, where it is known
};

/// Text under construction.
template <class = umbrage::detail::on_use>
class composition {
public:
    composition(const language& l, const std::vector<bound>& items) : language_(l), items_(items) {
        for (const bound& item : items_)
            for (const bound& other : items_)
                if (item.suffix == other.suffix && !(item.map == other.map) && has_map(item) && has_map(other))
                    umbrage::detail::refuse(language_.function, "name", "another for each map",
                                            std::string_view(item.suffix).substr(item.suffix.empty() ? 0 : 1),
                                            "It is the name of two maps.");
    }

    [[nodiscard]] std::string text() && {
        for_each([&](const snippet& s, const bound& item, const std::string& guard) {
            const bool of_map = is_of_map(s);
            const std::string body = language_.translate(s);
            if (language_.preprocessor) text_ += "\n#ifndef " + guard + "\n#define " + guard;
            text_ += of_map ? laid_out(for_map(body, s, item, language_.texture(item.map.texture), plane_of(s, item)))
                            : body;
            if (language_.preprocessor) text_ += "#endif\n";
        });
        for (const bound& item : items_)
            if (item.declared) declare(item);
        return std::move(text_);
    }

    /// Parts of the text below tier A, each with its own bound.
    [[nodiscard]] std::vector<snippet> inexact() && {
        std::vector<snippet> all;
        for_each([&](const snippet& s, const bound&, const std::string&) {
            if (s.exactness != tier::a) all.push_back(s);
        });
        return all;
    }

    /// Weakest guarantee of any part of the text.
    [[nodiscard]] snippet worst() && {
        snippet all{.name = {}, .source = ""};
        for_each([&](const snippet& s, const bound&, const std::string&) {
            if (all.exactness < s.exactness) all.exactness = s.exactness;
            all.operations = (glm::max)(all.operations, s.operations);
            all.within = (glm::max)(all.within, s.within);
            all.as_written = all.as_written || s.as_written;
        });
        return all;
    }

private:
    struct part {
        std::string what, suffix, guard;
        std::string_view summary{};  ///< tells apart functions of one name
    };

    struct slot_of {
        std::string slot, shadow;
    };

    /// Calls use(snippet, item, guard) for each part of the text, in order. Parts that belong to no map come first, in
    /// any order of the items, since hooks may call them.
    template <class Part>
    void for_each(const Part& use) {
        for (const bool of_map : {false, true})
            for (const bound& item : items_) {
                for (const snippet& need : item.map.needs) add(need, item, of_map, use);
                for (const snippet* need : language_.texture(item.map.texture).needs) add(*need, item, of_map, use);
                const own_snippets own(item.texts);
                for (const snippet& text : own) add(text, item, of_map, use);
                if (item.texts.empty()) add(item.what, item, of_map, use);
            }
    }

    template <class Part>
    void add(const snippet& asked, const bound& item, bool of_map, const Part& use) {
        const snippet& s = chosen(asked, item.map);
        for (const snippet* need : s.needs) add(*need, item, of_map, use);
        if (is_of_map(s) != of_map) return;
        const std::string suffix = of_map ? item.suffix : std::string(), function = std::string(s.name) + suffix;
        std::string guard = "UMBRAGE_HAS_" + function;
        for (char& c : guard) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
        for (const part& done : done_) {
            if (done.guard != guard) continue;
            if (done.what == s.name && done.suffix == suffix && done.summary == s.summary) return;
            umbrage::detail::refuse(language_.function, "name", "such that functions differ, in capitals too",
                                    ("umbrage_" + done.what + done.suffix + " and umbrage_" + function).c_str());
        }
        use(s, item, guard);
        done_.push_back({std::string(s.name), suffix, std::move(guard), s.summary});
    }

    /// Declaration of the receiver's plane after the map. Empty in own texts, which compute it.
    [[nodiscard]] std::string_view plane_of(const snippet& s, const bound& item) const {
        bool given = item.map.receiver_plane;
        for (const own_text& own : item.texts) given = given && own.name != s.name;
        return given ? language_.receiver_plane : std::string_view();
    }

    /// Declares a shadow's block, map and function, after all that they call.
    void declare(const bound& item) {
        const shader_interface& i = *item.declared;
        umbrage::detail::require(language_.declare != nullptr, language_.function, "version",
                                 "given for a shadow's uniforms", "none");
        map_parameter map;
        const std::string parameters = parameters_of(item.map, language_.texture(item.map.texture));
        for (const std::string_view parameter : members(parameters)) {
            const std::string_view name = declared(parameter).front();
            std::string one(parameter.substr(parameter.find_first_not_of(' ')));
            if (name == "map") map.map = std::move(one);
            if (name == "map_sampler") map.sampler = std::move(one);
        }
        const declaration all = language_.declare(i, map, language_.dialect.value_or(version::vulkan));
        std::vector<std::string> names;
        for (const interface_function& f : i.functions) names.push_back(name_of(i, f));
        names.insert(names.end(), all.names.begin(), all.names.end());
        for (const std::string& name : names) {
            const std::string own = name.substr(8);  // without umbrage_
            for (const part& done : done_)
                umbrage::detail::require(done.what + done.suffix != own, language_.function, "name",
                                         "another than a snippet's or shadow's of the text", std::string_view(own));
            done_.push_back({own, {}, {}});
        }
        for (const std::string& slot : all.slots) {
            for (const slot_of& other : slots_)
                umbrage::detail::require(other.slot != slot, language_.function, "slots",
                                         "others for each block, texture and sampler of a text",
                                         (slot + " for " + other.shadow + " and " + i.name).c_str());
            slots_.push_back({slot, i.name});
        }
        text_ += all.text;
    }

    /// True when the item prints functions that belong to its map.
    [[nodiscard]] static bool has_map(const bound& item) {
        for (const snippet& need : item.map.needs)
            if (is_of_map(need)) return true;
        return !item.texts.empty() || is_of_map(item.what);
    }

    const language& language_;
    const std::vector<bound>& items_;
    std::string text_;
    std::vector<part> done_;
    std::vector<slot_of> slots_;
};

/// Comment lines that bound the result of each function. Empty for a text of tier A.
template <class Use = umbrage::detail::on_use>
[[nodiscard]] std::string bounds_note(const language& l, const std::vector<bound>& items) {
    std::string lines;
    for (const bound& item : items) {
        const auto add = [&](const std::string& name, const snippet& promise) {
            const std::string line = "// " + name + (promise.exactness == tier::b ? ", tier B: " : ", tier C: ") +
                                     bound_in_words(promise) + '\n';
            if (lines.find(line) == lines.npos) lines += line;
        };
        const snippet worst = composition<Use>(l, {item}).worst();
        if (item.declared)  // each part of a shadow's text keeps its own bound
            for (const snippet& part : composition<Use>(l, {item}).inexact()) add(std::string(part.name), part);
        else if (worst.exactness != tier::a) add(std::string(item.what.name) + item.suffix, worst);
    }
    if (lines.find(" x S ") != lines.npos)
        lines +=
            "// S is the formula with the magnitude of every value and a plus for every minus.\n"
            "// Inside the bound, a comparison or floor may fall on either side.\n";
    if (lines.empty() || l.may_reorder.empty()) return lines;
    return "// " + std::string(l.may_reorder) + " lets compilers fuse or reorder sums.\n" + lines;
}

/// Whole text: a title line with the names of its functions, then the functions.
template <class Use = umbrage::detail::on_use>
[[nodiscard]] std::string compose(const language& l, const std::vector<bound>& items) {
    std::string title = "// umbrage " + std::to_string(UMBRAGE_VERSION_MAJOR) + '.' +
                        std::to_string(UMBRAGE_VERSION_MINOR) + '.' + std::to_string(UMBRAGE_VERSION_PATCH) +
                        ", MIT License";
    std::string names = ": ";
    for (const bound& item : items) {
        const std::string name =
            (item.declared ? item.declared->name : std::string(item.what.name) + item.suffix) + ", ";
        if (names.find(' ' + name) == names.npos) names += name;
    }
    names.resize(names.size() - 2);
    return title + names + '\n' + bounds_note<Use>(l, items) + std::string(l.prelude) +
           composition<Use>(l, items).text();
}

}  // namespace umbrage::glsl::detail
