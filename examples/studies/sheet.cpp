// SPDX-License-Identifier: MIT
#include "sheet.hpp"

#include <algorithm>

#include <glm/common.hpp>

#include <letters.hpp>

namespace shadow_render {
namespace {

constexpr int letter = 2, line = 12 * letter, margin = 8, zoom = 4;
constexpr glm::u8vec3 paper{24, 26, 30}, ink{235, 235, 230};

int height_of(std::size_t lines) { return static_cast<int>(lines) * line + 2 * margin; }

}  // namespace

glm::ivec2 sheet::part(glm::ivec2 size) { return glm::max(glm::ivec2(size.y / (2 * zoom), size.y / zoom), 1); }

sheet::sheet(glm::ivec2 size, int pictures, const std::vector<std::string>& title, std::optional<glm::ivec2> center)
    : size_(size),
      part_(center ? part(size) : glm::ivec2(0)),
      first_(glm::clamp(center.value_or(part_) - part_ / 2, glm::ivec2(0), size - part_)),
      cell_(size.x + part_.x * zoom, size.y + height_of(lines)),
      top_(height_of(title.size())),
      pixels_(glm::ivec2(columns, (pictures + columns - 1) / columns) * cell_ + glm::ivec2(0, top_), paper) {
    write(title, glm::ivec2(margin));
}

void sheet::add(const picture& p, const std::vector<std::string>& text) {
    const glm::ivec2 at = glm::ivec2(next_ % columns, next_ / columns) * cell_ + glm::ivec2(0, top_);
    ++next_;
    for (int y = 0; y < size_.y; ++y) {
        std::copy_n(p.view().row(y), size_.x, pixels_.view().row(at.y + y) + at.x);
        for (int x = 0; x < part_.x * zoom; ++x)
            pixels_[at + glm::ivec2(size_.x + x, y)] = p[first_ + glm::min(glm::ivec2(x, y) / zoom, part_ - 1)];
    }
    write(text, at + glm::ivec2(margin, size_.y + margin));
}

void sheet::write(const std::vector<std::string>& text, glm::ivec2 at) {
    std::string all;
    for (const std::string& of : text) all += of + '\n';
    for (const auto& [low, high] : example::letters(all)) {
        const glm::ivec2 from = at + glm::ivec2(low * float(letter)), to = at + glm::ivec2(high * float(letter));
        for (int y = std::max(from.y, 0); y < std::min(to.y, pixels_.size().y); ++y)
            for (int x = std::max(from.x, 0); x < std::min(to.x, pixels_.size().x); ++x) pixels_[{x, y}] = ink;
    }
}

}  // namespace shadow_render
