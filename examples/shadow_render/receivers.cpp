// SPDX-License-Identifier: MIT
#include "receivers.hpp"

#include <algorithm>
#include <cstdint>

#include <umbrage/bias/constant.hpp>

#include <biases.hpp>
#include <names.hpp>
#include <surface.hpp>

namespace shadow_render {
namespace {

/// A row of samples under a bias. Lanes that are computed together, so that compilers can use vectors.
template <class Bias>
void place_row(const view& v, const example::bias_light& light, const Bias& bias, const glm::mat4& to_texels,
               float error, bool projected, int y, receivers& out) {
    float *const to_x = out.x.view().row(y), *const to_y = out.y.view().row(y),
                 *const to_depth = out.depth.view().row(y);
    example::for_each_run(v.seen, y, [&](int first, int last, std::uint32_t triangle) {
        const example::seen_triangle on = v.triangle(triangle);
        for (int x = first; x < last; x += lanes) {
            const int count = std::min(lanes, last - x);
            example::vectors weights, at;
            float off_depth[lanes], slope_x[lanes], slope_y[lanes];
            on.locate({x, y}, weights, at);
            for (int i = 0; i < lanes; ++i) {
                const glm::vec3 world = at[i];
                const float w = v.lamp.w(world);
                const example::receiver_bias by = bias(light, {world, on.face_normal(world), v.lamp.way(world, w), w});
                at.set(i, world + by.offset);
                off_depth[i] = by.depth;
                slope_x[i] = by.slope.x, slope_y[i] = by.slope.y;
            }
            for (int i = 0; i < lanes; ++i)
                at.set(i, umbrage::project_coordinate(umbrage::shadow_coordinate(to_texels, at[i])));
            for (int i = 0; i < lanes; ++i)
                at.z[i] = umbrage::biased(v.lamp.even_depth(umbrage::biased(at.z[i], off_depth[i])), error);
            if (projected)
                for (float& z : at.z) z = v.lamp.projected_depth(z);
            if (!out.slope_x.empty()) {
                std::copy_n(slope_x, count, out.slope_x.view().row(y) + x);
                std::copy_n(slope_y, count, out.slope_y.view().row(y) + x);
            }
            std::copy_n(at.x, count, to_x + x);
            std::copy_n(at.y, count, to_y + x);
            std::copy_n(at.z, count, to_depth + x);
        }
    });
}

}  // namespace

receivers receivers_of(const view& v, const options& o, float reach, float below, example::progress& progress,
                       bool projected) {
    constexpr float rounding = 0x1p-18f;  // the depth pass and we compute the same depth, in float
    const glm::ivec2 map_size(o.map_size);
    const glm::mat4 to_texels = umbrage::texture_matrix(v.lamp.space, map_size);
    const example::bias_light light =
        example::make_bias_light(v.lamp.space, v.lamp.direction, map_size, reach, v.lamp.w(v.scene.target));
    receivers out(v.seen.size());
    float error = rounding + below;
    if (projected && example::compares_along_plane(bias_of(o))) {
        out.slope_x = out.slope_y = umbrage::image<float>(v.seen.size());
        error *= 2;  // of texels nearer to the light than the receiver z/w has more a world unit
    }
    example::with_bias(bias_of(o), [&](const auto& bias) {
        progress.bands()(v.seen.size().y, [&](int first, int last) {
            for (int y = first; y < last; ++y) place_row(v, light, bias, to_texels, error, projected, y, out);
        });
    });
    return out;
}

}  // namespace shadow_render
