// SPDX-License-Identifier: MIT
#include "letters.hpp"

#include <cstddef>

#include <stb/stb_easy_font.h>

namespace example {

std::vector<rectangle> letters(std::string text) {
    struct corner {
        float x, y, z;
        unsigned char color[4];
    };
    std::vector<corner> quads(64 * text.size() + 4);  // a letter has up to 16 of them
    const int count =
        stb_easy_font_print(0, 0, text.data(), nullptr, quads.data(), static_cast<int>(quads.size() * sizeof(corner)));
    std::vector<rectangle> out;
    for (std::size_t first = 0; first < 4 * static_cast<std::size_t>(count); first += 4)
        out.push_back({{quads[first].x, quads[first].y}, {quads[first + 2].x, quads[first + 2].y}});
    return out;
}

}  // namespace example
