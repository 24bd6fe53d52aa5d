// SPDX-License-Identifier: MIT
#include "shade.hpp"

#include <algorithm>
#include <cstdint>

#include <glm/geometric.hpp>

#include <surface.hpp>

namespace shadow_render {

void shade_row(const view& v, const umbrage::image<float>& visibility, int y, glm::vec3* out) {
    std::fill_n(out, v.seen.size().x, sky(static_cast<float>(y) / static_cast<float>(v.seen.size().y)));
    example::for_each_run(v.seen, y, [&](int first, int last, std::uint32_t triangle) {
        const example::seen_triangle on = v.triangle(triangle);
        const float* const visible = visibility.view().row(y);
        for (int x = first; x < last; x += lanes) {
            const int count = std::min(lanes, last - x);
            example::vectors weights, at, normals, colors;
            float lit[lanes]{}, n_dot_l[lanes];
            std::copy_n(visible + x, count, lit);
            on.locate({x, y}, weights, at);
            on.paint(weights, at, colors);
            for (int i = 0; i < lanes; ++i) normals.set(i, on.normal(weights[i], on.face_normal(at[i])));
            for (int i = 0; i < lanes; ++i) n_dot_l[i] = glm::dot(normals[i], v.lamp.to_light(at[i]));
            for (int i = 0; i < lanes; ++i) lit[i] *= v.lamp.cone(at[i]);
            for (int i = 0; i < lanes; ++i) colors.set(i, shaded(colors[i], normals[i], n_dot_l[i], lit[i]));
            for (int i = 0; i < count; ++i) out[x + i] = colors[i];
        }
    });
}

}  // namespace shadow_render
