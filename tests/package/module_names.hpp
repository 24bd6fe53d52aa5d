// SPDX-License-Identifier: MIT
//
// Names in the order in which values.hpp counts, and clip spaces, in JavaScript.
#pragma once

#include <string>
#include <string_view>

#include <umbrage/core/clip_space.hpp>
#include <umbrage/depth/encodings.hpp>
#include <umbrage/filter/filters.hpp>
#include <umbrage/filter/prefiltered/prefilters.hpp>
#include <umbrage/shadow/look.hpp>

#include "languages.hpp"

namespace package {

inline std::string names_module() {
    std::string filters, encodings, of_kinds;
    const auto add = [](std::string& list, std::string_view name) {
        list += (list.empty() ? "" : ", ") + literal(name);
    };
    const auto filter = [&](const auto& f) {
        if constexpr (umbrage::shadow_filter<std::decay_t<decltype(f)>>) add(filters, f.snippet->name);
    };
    umbrage::filters::all::for_each(filter);
    umbrage::filters::soft::for_each(filter);
    umbrage::prefilters::all::for_each(filter);
    umbrage::for_each_encoding([&](const auto& e) { add(encodings, e.name); });
    for (const kind_of_light& kind : kinds) add(of_kinds, kind.name);
    return "export const kinds = [" + of_kinds + "];\nexport const filters = [" + filters +
           "];\nexport const encodings = [" + encodings + "];\n";
}

/// Calls use(name, value) for each clip space.
template <class Use>
void for_each_clip_space(const Use& use) {
    for (const umbrage::named_clip_space& each : umbrage::clip_spaces) use(each.name, each.value);
    use("cpu_clip_space", umbrage::cpu_clip_space);
}

inline std::string clip_spaces_module() {
    std::string out;
    for_each_clip_space([&](std::string_view name, const umbrage::clip_space& clip) {
        using namespace umbrage;
        out += "export const " + std::string(name) +
               " = { hand: " + literal(clip.hand == handedness::left ? "left" : "right") +
               ", range: " + literal(clip.range == depth_range::zero_to_one ? "zero_to_one" : "minus_one_to_one") +
               ", direction: " + literal(clip.direction == depth_direction::forward ? "forward" : "reversed") +
               ", origin: " + literal(clip.origin == texture_origin::top ? "top" : "bottom") + " };\n";
    });
    return out;
}

inline std::string types_of_clip_spaces() {
    std::string out;
    for_each_clip_space([&](std::string_view name, const umbrage::clip_space&) {
        out += "export const " + std::string(name) + ": ClipSpace;\n";
    });
    return out;
}

}  // namespace package
