// SPDX-License-Identifier: MIT
#include "lettering.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <vector>

#define STB_TRUETYPE_IMPLEMENTATION
#define STBTT_STATIC
#include <stb/stb_truetype.h>

namespace pictures {
namespace {

/// The font's file, read once.
class font {
public:
    font() {
        std::ifstream file(FONT, std::ios::binary);
        bytes_.assign(std::istreambuf_iterator<char>(file), {});
        if (bytes_.empty() || !stbtt_InitFont(&info_, bytes_.data(), 0))
            throw std::runtime_error("Cannot read the font " FONT ".");
        int descent = 0, gap = 0;
        stbtt_GetFontVMetrics(&info_, &ascent_, &descent, &gap);
        scale_ = stbtt_ScaleForPixelHeight(&info_, static_cast<float>(letter_height));
    }

    /// Calls use(letter, x) for each letter, with the pen's place in pixels; returns the width of all.
    template <class Use>
    float walk(std::string_view text, const Use& use) const {
        float x = 0;
        for (std::size_t i = 0; i < text.size(); ++i) {
            int advance = 0, bearing = 0;
            stbtt_GetCodepointHMetrics(&info_, text[i], &advance, &bearing);
            use(text[i], x);
            const int kern = i + 1 < text.size() ? stbtt_GetCodepointKernAdvance(&info_, text[i], text[i + 1]) : 0;
            x += scale_ * static_cast<float>(advance + kern);
        }
        return x;
    }

    /// Adds a letter's coverage, with its pen at a fraction of a pixel.
    void draw(umbrage::image_view<float> on, char letter, float x) const {
        const float whole = std::floor(x);
        int width = 0, height = 0, left = 0, top = 0;
        unsigned char* covered = stbtt_GetCodepointBitmapSubpixel(&info_, scale_, scale_, x - whole, 0, letter, &width,
                                                                  &height, &left, &top);
        const glm::ivec2 at(static_cast<int>(whole) + left,
                            top + static_cast<int>(std::lround(scale_ * static_cast<float>(ascent_))));
        for (glm::ivec2 p{0}; p.y < height; ++p.y)
            for (p.x = 0; p.x < width; ++p.x) {
                const glm::ivec2 to = at + p;
                if (to.x < 0 || to.y < 0 || to.x >= on.size.x || to.y >= on.size.y) continue;
                on[to] = std::min(on[to] + static_cast<float>(covered[p.y * width + p.x]) / 255.0f, 1.0f);
            }
        stbtt_FreeBitmap(covered, nullptr);
    }

private:
    std::vector<std::uint8_t> bytes_;
    stbtt_fontinfo info_{};
    int ascent_ = 0;
    float scale_ = 0;
};

}  // namespace

umbrage::image<float> lettering(std::string_view text) {
    static const font used;
    const float width = used.walk(text, [](char, float) {});
    umbrage::image<float> out({static_cast<int>(std::ceil(width)) + 2, line_height}, 0.0f);
    used.walk(text, [&](char letter, float x) { used.draw(out.view(), letter, x); });
    return out;
}

}  // namespace pictures
