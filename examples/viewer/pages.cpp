// SPDX-License-Identifier: MIT
#include "pages.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include <umbrage/images/page_atlas.hpp>

#include <sun_pages.hpp>

namespace viewer {
namespace {

constexpr int deepest_level = 10;  // a table of a megatexel; a centimetre of a kilometre

/// 128 x 128 texels, less where an atlas has no place for a few of these.
umbrage::page_size size_for(int texels, float reach) {
    umbrage::page_size size{.gutter = std::max(4, static_cast<int>(std::ceil(reach)))};
    while (texels / size.pitch() < 6 && size.texels >= 4 * size.gutter) size.texels /= 2;
    return size;
}

}  // namespace

sun_pages::sun_pages(int texels, float reach)
    : size_(size_for(texels, reach)),
      cache_({.slots = glm::ivec2(std::clamp(texels / size_.pitch(), 1, 256)), .deepest_level = deepest_level}) {}

void sun_pages::shine(glm::dvec3 direction, glm::dvec3 up, const umbrage::bounding_box<double>& scene) {
    if (direction_ == direction) return;
    direction_ = direction;
    cache_.forget();
    root_ = example::page_root_around(scene.low, scene.high, direction, up, umbrage::opengl_clip_space);
}

umbrage::page_update sun_pages::update(std::span<const umbrage::seen_point> seen, glm::dvec3 eye,
                                       const glm::dmat4& to_pixels) {
    example::page_wishes wishes(root_, *direction_, size_.texels, to_pixels);
    for (const umbrage::seen_point& s : seen)
        wishes.add(s.position, glm::dot(s.normal, eye - s.position) < 0 ? -s.normal : s.normal);
    return cache_.update(wishes.all());
}

umbrage::light_space<double> sun_pages::light(const umbrage::page& p) const {
    return umbrage::page_light(root_, p, size_);
}

umbrage::image<glm::u8vec4> sun_pages::table() const {
    umbrage::image<glm::u8vec4> table(umbrage::page_table_size(cache_));
    umbrage::write_page_table(cache_, table);
    return table;
}

std::string sun_pages::describe(const umbrage::page_update& u) const {
    const glm::ivec2 slots = cache_.budget().slots;
    std::array<char, 160> text{};
    std::snprintf(text.data(), text.size(),
                  "%zu of %d pages, %zu drawn, a texel %.2f pixels\n%zu given up, %zu of these pop", cache_.size(),
                  slots.x * slots.y, u.drawn.size(), u.target, u.given_up, u.forced);
    return text.data();
}

}  // namespace viewer
