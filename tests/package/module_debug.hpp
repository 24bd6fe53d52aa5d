// SPDX-License-Identifier: MIT
//
// Parts of a shadow's debug functions, in JavaScript. They are an object of their own, so programs without debugging
// carry none of it. shadow.mjs joins its texts.
#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include <string_view>

#include <umbrage/depth/encodings.hpp>

#include "module_shadows.hpp"

namespace package {

/// Places of the debug texts in those of a shadow.
enum own_texts { place_color = 2, channel_color, point_color, lit_at, reading };

/// 1 / tolerance of a reading, for every encoding; `moments` stands for all prefilters.
template <class SetUp>
[[nodiscard]] std::string parts_of_readings() {
    using filter = umbrage::filters::hard;
    const auto parts = [](float tolerance) { return std::to_string(static_cast<int>(1.0f / tolerance + 0.5f)); };
    std::string all = "{ moments: " + parts(umbrage::detail::coarse_tolerance);
    umbrage::for_each_encoding([&](auto encoding) {
        const auto in = [&](umbrage::depth_direction direction) {
            encoding = {.direction = direction};
            return parts(umbrage::detail::calibration_tolerance<SetUp, filter>(encoding));
        };
        const std::string forward = in(umbrage::depth_direction::forward);
        if (in(umbrage::depth_direction::reversed) != forward)
            throw std::runtime_error("a tolerance for each direction: " + std::string(encoding.name));
        all += ", " + std::string(encoding.name) + ": " + forward;
    });
    return all + " }";
}

/// The statement that chooses the map to read, ahead of the tolerance; a setup of one map lacks it.
template <class SetUp>
[[nodiscard]] std::string choice_of_reading(const shader_language& l, const glsl::map_choice& choice) {
    const std::string text = own_text<SetUp>(l, umbrage::filters::hard{}, choice, reading, true);
    const auto start = text.find("{\n") + 2;
    return text.substr(start, text.rfind('\n', text.find("tolerance")) + 1 - start);
}

template <class SetUp>
[[nodiscard]] std::string debug_of_maps(const shader_language& l, std::string_view name) {
    const umbrage::filters::hard filter;
    const auto text = [&](int which) {
        return template_literal(own_text<SetUp>(l, filter, SetUp::tiles, which, true));
    };
    return "        " + std::string(name) +
           ": {\n            choice: " + template_literal(choice_of_reading<SetUp>(l, SetUp::tiles)) +
           ",\n            channel_color: " + text(channel_color) + ",\n            point_color: " + text(point_color) +
           ",\n        },\n";
}

inline std::string debug_module(const shader_language& l) {
    namespace filters = umbrage::filters;
    using umbrage::single_map;
    const auto text = [&](const auto& filter, int which) {
        return template_literal(own_text<single_map>(l, filter, {}, which, true));
    };
    const auto place = [&](const auto& filter) {
        const snippet& bias = umbrage::detail::bias_snippet<std::decay_t<decltype(filter)>>();
        return "{ bias: snippets." + std::string(bias.name) + ", text: " + text(filter, place_color) + " },\n";
    };
    const std::string plain = own_text<single_map>(l, filters::hard{}, {}, reading, true);
    const auto number = plain.find("1.0 / ") + 6;
    return "import { language } from './language.mjs';\nimport * as snippets from './snippets.mjs';\n\n"
           "export const debug = {\n    language,\n    needs: { place: snippets.probe_color, point: "
           "[snippets.cleared_depth, snippets.probe_inputs] },\n    place_color: {\n        plain: " +
           place(filters::hard{}) + "        disc: " + place(filters::disc{}) +
           "        hardens: " + place(filters::pcss{}) + "    },\n    lit_at: " + text(filters::hard{}, lit_at) +
           ",\n    lit_at_turned: " + text(filters::disc{}, lit_at) + ",\n    reading: " +
           template_literal(with_word(plain, plain.substr(number, plain.find('.', number) - number), "PARTS")) +
           ",\n    layer: " + template_literal(choice_of_reading<umbrage::cascaded_maps<1>>(l, {})) +
           ",\n    parts: " + parts_of_readings<single_map>() +
           ",\n    parts_of_bent: " + parts_of_readings<umbrage::paraboloid_maps>() + ",\n    maps: {\n" +
           debug_of_maps<single_map>(l, "one_map") + debug_of_maps<umbrage::cascaded_maps<1>>(l, "cascaded_maps") +
           debug_of_maps<umbrage::cascaded_maps<2>>(l, "cascaded_maps_8") +
           debug_of_maps<umbrage::warped_maps>(l, "warped_maps") +
           debug_of_maps<umbrage::adaptive_maps>(l, "adaptive_maps") +
           debug_of_maps<umbrage::cube_maps>(l, "cube_maps") +
           debug_of_maps<umbrage::tetrahedron_map>(l, "tetrahedron_map") +
           debug_of_maps<umbrage::paraboloid_maps>(l, "paraboloid_maps") + "    },\n};\n";
}

}  // namespace package
