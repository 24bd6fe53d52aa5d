// SPDX-License-Identifier: MIT
#include "pages.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <umbrage/core/unorm.hpp>
#include <umbrage/debug/overlay.hpp>
#include <umbrage/filter/filters.hpp>
#include <umbrage/light/directional_fit.hpp>
#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/shadow/shadow.hpp>

#include <camera.hpp>
#include <depth_color.hpp>
#include <scene.hpp>
#include <srgb.hpp>
#include <surface.hpp>
#include <text.hpp>

#include <shade.hpp>

namespace pictures {
namespace {

using example::text;

constexpr glm::vec3 to_light{-0.663f, 0.5f, 0.557f};
constexpr glm::vec3 ball{0.5f, 2.436f, -0.35f};  ///< center, on the mast
constexpr int samples = 3;                       ///< a pixel's, along x and y
constexpr glm::vec3 mark{0.82f, 0.05f, 0.42f}, halo{1, 1, 1};

/// Blends a color over the pixels within a radius of a line.
void stroke(picture& on, glm::vec2 from, glm::vec2 to, float radius, glm::vec3 color) {
    const glm::vec2 along = to - from;
    const float squared = std::max(glm::dot(along, along), 1e-6f);
    for (glm::ivec2 p{0}; p.y < on.size().y; ++p.y)
        for (p.x = 0; p.x < on.size().x; ++p.x) {
            const glm::vec2 at = glm::vec2(p) + 0.5f - from;
            const float away = glm::length(at - along * glm::clamp(glm::dot(at, along) / squared, 0.0f, 1.0f));
            const float share = glm::clamp(radius + 0.5f - away, 0.0f, 1.0f);
            on[p] = umbrage::store_unorm(glm::mix(glm::vec3(on[p]) / 255.0f, color, share));
        }
}

void spot(picture& on, glm::vec2 at) {
    stroke(on, at, at, 7, halo);
    stroke(on, at, at, 5, mark);
}

/// A sun over the scene, by the library's defaults.
auto sun_over(const example::scene& scene) {
    const auto light =
        umbrage::fit_directional_light<float>({.direction = -to_light,
                                               .receivers = umbrage::bounding_box<float>{scene.low, scene.high},
                                               .clip = example::picture_clip});
    return umbrage::shadow(light, {2048, 2048}, umbrage::filters::tent<3>);
}

/// The garden, as its camera and its light see it.
class garden {
public:
    explicit garden(glm::ivec2 size)
        : size_(size),
          camera_(example::make_camera({.target = scene_.target,
                                        .elevation = 20,
                                        .fov = 37,
                                        .aspect = static_cast<float>(size.x) / static_cast<float>(size.y)})),
          seen_(example::camera_pass(scene_.geometry, camera_, size * samples)),
          sun_(sun_over(scene_)),
          map_(sun_.size(), sun_.cleared()),
          to_texels_(umbrage::texture_matrix(sun_.setup().lights()[0], sun_.map_size())) {
        sun_.draw(map_, example::view_of(scene_.geometry));
        const glm::vec2 target = in_map(ball);
        float nearest = 1e9f;
        each_sample([&](glm::ivec2 p) {
            const example::surface s = surface(p);
            const float apart = glm::distance(in_map(s.position), target);
            if (depth(s.position) > stored(target) + 0.02f && apart < nearest) nearest = apart, point_ = s.position;
        });
    }

    /// The camera's picture, and the way that light would take to the point.
    [[nodiscard]] picture from_camera() const {
        umbrage::image<glm::vec3> light(seen_.size());
        for (glm::ivec2 p{0}; p.y < light.size().y; ++p.y)
            for (p.x = 0; p.x < light.size().x; ++p.x)
                light[p] = shadow_render::sky(static_cast<float>(p.y) / static_cast<float>(light.size().y));
        each_sample([&](glm::ivec2 p) {
            const example::surface s = surface(p);
            light[p] = shadow_render::shaded(s.color, s.normal, glm::dot(s.normal, glm::normalize(to_light)),
                                             sun_(map_, s.position, s.face_normal));
        });
        picture out(size_);
        for (glm::ivec2 p{0}; p.y < size_.y; ++p.y)
            for (p.x = 0; p.x < size_.x; ++p.x)
                out[p] = example::to_srgb(shadow_render::mean<glm::vec3>(p.x, samples, [&](int x, int row) {
                    return light[{x, p.y * samples + row}];
                }));
        const glm::vec2 from = on_screen(point_), by = on_screen(ball),
                        to = on_screen(ball + 3.0f * glm::normalize(to_light));
        for (const auto& [radius, color] : {std::pair(2.5f, halo), std::pair(1.2f, mark)}) {
            stroke(out, from, by, radius, color);
            for (float t = 0.1f; t < 1; t += 0.1f)
                stroke(out, glm::mix(by, to, t), glm::mix(by, to, t + 0.04f), radius, color);
        }
        spot(out, from), spot(out, by);
        return out;
    }

    /// The light's picture, with the point's one texel.
    [[nodiscard]] picture from_light() const {
        constexpr float world_height = 3.9f;
        const float pixel = world_height / static_cast<float>(size_.y);
        const glm::mat4 rows = glm::transpose(to_texels_);
        const glm::vec2 step = pixel * glm::vec2(glm::length(glm::vec3(rows[0])), glm::length(glm::vec3(rows[1])));
        const glm::vec2 corner = in_map(scene_.target) - 0.5f * step * glm::vec2(size_);
        umbrage::image<float> depths(size_ * samples);
        float low = 1, high = 0;
        for (glm::ivec2 p{0}; p.y < depths.size().y; ++p.y)
            for (p.x = 0; p.x < depths.size().x; ++p.x) {
                const float v = stored(corner + (glm::vec2(p) + 0.5f) * step / static_cast<float>(samples));
                depths[p] = v;
                if (v < 1) low = std::min(low, v), high = std::max(high, v);
            }
        picture out(size_);
        for (glm::ivec2 p{0}; p.y < size_.y; ++p.y)
            for (p.x = 0; p.x < size_.x; ++p.x)
                out[p] = umbrage::store_unorm(shadow_render::mean<glm::vec3>(p.x, samples, [&](int x, int row) {
                    const float v = depths[{x, p.y * samples + row}];
                    return v < 1 ? example::depth_color((v - low) / (high - low)) : example::no_depth_color;
                }));
        spot(out, (in_map(point_) - corner) / step);
        return out;
    }

    [[nodiscard]] float stored_depth() const { return stored(in_map(point_)); }
    [[nodiscard]] float point_depth() const { return depth(point_); }

private:
    template <class Use>
    void each_sample(const Use& use) const {
        for (glm::ivec2 p{0}; p.y < seen_.size().y; ++p.y)
            for (p.x = 0; p.x < seen_.size().x; ++p.x)
                if (seen_[p] != example::nothing) use(p);
    }
    [[nodiscard]] example::surface surface(glm::ivec2 p) const {
        return example::surface_at(scene_, camera_, seen_, p);
    }
    [[nodiscard]] glm::vec3 placed(glm::vec3 world) const {
        return umbrage::project_coordinate(umbrage::shadow_coordinate(to_texels_, world));
    }
    [[nodiscard]] glm::vec2 in_map(glm::vec3 world) const { return glm::vec2(placed(world)); }
    [[nodiscard]] float depth(glm::vec3 world) const { return placed(world).z; }
    [[nodiscard]] float stored(glm::vec2 at) const {
        const glm::ivec2 texel(glm::floor(at));
        const bool inside = texel.x >= 0 && texel.y >= 0 && texel.x < map_.size().x && texel.y < map_.size().y;
        return inside ? map_[texel] : 1.0f;
    }
    [[nodiscard]] glm::vec2 on_screen(glm::vec3 world) const {
        const glm::vec4 clip = camera_.world_to_clip * glm::vec4(world, 1);
        return (glm::vec2(clip.x, -clip.y) / clip.w * 0.5f + 0.5f) * glm::vec2(size_);
    }

    glm::ivec2 size_;
    example::scene scene_ = example::default_scene();
    example::camera camera_;
    umbrage::image<std::uint32_t> seen_;
    decltype(sun_over(std::declval<example::scene>())) sun_;
    umbrage::image<float> map_;
    glm::mat4 to_texels_;
    glm::vec3 point_{0};
};

}  // namespace

picture two_views(int width) {
    constexpr int gap = 8;
    const int side = (width - gap) / 2;
    const glm::ivec2 size(side, side * 3 / 4);
    const garden of(size);
    canvas page({width, size.y + gap + 2 * canvas::line});
    page.paste(of.from_light(), {0, 0});
    page.paste(of.from_camera(), {side + gap, 0});
    const auto write = [&](int x, const std::array<std::string, 2>& lines) {
        for (int i = 0; i < 2; ++i)
            page.write(lines[std::size_t(i)], {x, size.y + gap + i * canvas::line}, i == 0 ? ink : pale_ink);
    };
    write(0, {"the light sees the ball", text("stored depth %.3f", double(of.stored_depth()))});
    write(side + gap, {"the camera sees the wall", text("its depth %.3f: in shadow", double(of.point_depth()))});
    return page.pixels();
}

}  // namespace pictures
