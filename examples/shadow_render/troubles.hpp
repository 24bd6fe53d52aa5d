// SPDX-License-Identifier: MIT
//
// Troubles of shadow maps, made on purpose and cured: the pictures of the pages.
//
//     const auto t = std::ranges::find(troubles(), "acne", &trouble::name);
//     const auto wrong = photograph(t->wrong(options), example::default_scene());
//
#pragma once

#include <array>
#include <string_view>

#include "options.hpp"

namespace shadow_render {

struct trouble {
    std::string_view name, cause, cure;
    void (*look)(options&);      ///< where it is seen
    void (*break_it)(options&);  ///< on top of that
    void (*cure_it)(options&);

    [[nodiscard]] options wrong(options o) const {
        look(o), break_it(o);
        return o;
    }
    [[nodiscard]] options cured(options o) const {
        look(o), cure_it(o);
        return o;
    }
};

/// In the order of the page.
[[nodiscard]] const std::array<trouble, 9>& troubles();

}  // namespace shadow_render
