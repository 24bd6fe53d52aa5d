// SPDX-License-Identifier: MIT
#include "pages.hpp"

#include <algorithm>
#include <string>
#include <string_view>

#include <scene.hpp>

#include <options.hpp>
#include <render.hpp>
#include <troubles.hpp>

namespace pictures {

picture trouble(std::string_view name, int side) {
    const auto& all = shadow_render::troubles();
    const shadow_render::trouble& shown = *std::ranges::find(all, name, &shadow_render::trouble::name);
    shadow_render::options o;
    o.quiet = true;
    o.width = side, o.height = side * 2 / 3, o.samples = 3;
    const example::scene scene =
        shown.cured(o).scene == shadow_render::built_in::outdoor ? example::outdoor_scene() : example::default_scene();
    constexpr int gap = 6;
    canvas page({2 * o.width + gap, o.height + gap + canvas::line});
    page.paste(photograph(shown.wrong(o), scene), {0, 0});
    page.paste(photograph(shown.cured(o), scene), {o.width + gap, 0});
    page.write(std::string(shown.cause), {0, o.height + gap});
    page.write(std::string(shown.cure), {o.width + gap, o.height + gap});
    return page.pixels();
}

}  // namespace pictures
