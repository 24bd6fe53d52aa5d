// SPDX-License-Identifier: MIT
//
// A recipe's picture against C++: each pixel's lights, lit or not, looked up in maps that C++ drew, or in one read
// back. With casters elsewhere they must differ.
//
//     recipes_compare RECIPE PICTURE.png [MAP.floats]
//
// Exit status 1 when more than 0.5 % of pixels differ, or one farther than two texels from a shadow's edge.
#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#define STB_IMAGE_IMPLEMENTATION
#include <stb/stb_image.h>

#include <umbrage/umbrage.hpp>

#include "../../examples/recipes/scene.hpp"

namespace {

using namespace umbrage;

/// The scene's triangles; in `casters` the fence is cut into its pickets, as the rasterizer here knows no holes.
struct geometry {
    std::vector<scene::vertex> corners = scene::make_mesh();
    std::vector<glm::vec3> positions;
    std::vector<glm::uvec3> triangles;

    geometry() {
        for (std::size_t i = 0; i < corners.size(); i += 3) {
            const bool fence = corners[i + 1].uv.x > 0 || corners[i + 2].uv.x > 0;
            if (!fence) add(corners[i].position, corners[i + 1].position, corners[i + 2].position);
        }
        const scene::vertex *first = &corners[corners.size() - 6], *right = first + 1, *up = first + 5;
        for (float begin = 0; begin < right->uv.x; ++begin) {
            const auto at = [&](float along) {
                return first->position + (right->position - first->position) * (along / right->uv.x);
            };
            const glm::vec3 a = at(begin), b = at(begin + 0.5f), rise = up->position - first->position;
            add(a, b, b + rise), add(a, b + rise, a + rise);
        }
    }

    /// First triangle on a ray.
    struct hit {
        float distance = INFINITY;
        std::size_t triangle = 0;
    };
    [[nodiscard]] hit trace(glm::vec3 from, glm::vec3 along) const {
        hit nearest;
        for (std::size_t i = 0; i < corners.size(); i += 3) {
            const scene::vertex* v = &corners[i];
            const glm::vec3 a = v[1].position - v->position, b = v[2].position - v->position, p = glm::cross(along, b),
                            s = from - v->position, q = glm::cross(s, a);
            const float d = glm::dot(a, p), x = glm::dot(s, p) / d, y = glm::dot(along, q) / d, t = glm::dot(b, q) / d;
            if (!(x >= 0 && y >= 0 && x + y <= 1 && t > 0 && t < nearest.distance)) continue;
            const glm::vec2 uv = v->uv + (v[1].uv - v->uv) * x + (v[2].uv - v->uv) * y;
            if (glm::fract(uv.x) <= 0.5f) nearest = {t, i};
        }
        return nearest;
    }

private:
    void add(glm::vec3 a, glm::vec3 b, glm::vec3 c) {
        const auto k = static_cast<unsigned>(positions.size());
        positions.insert(positions.end(), {a, b, c}), triangles.push_back({k, k + 1, k + 2});
    }
};

/// Colors of the picture's shading. The spot light has no blue, so blue is the other light's alone.
constexpr glm::vec3 ambient_color(0.2f, 0.22f, 0.27f), spot_color(0.3f, 0.17f, 0), other_color(0.52f, 0.46f, 0.36f);

/// A light as the picture shows it.
struct light {
    const char* name;
    bool is_spot;
    std::function<float(glm::vec3 world, glm::vec3 normal)> brightness;  ///< of a lit pixel, before its color
    std::function<glm::vec3(glm::vec3 world)> towards;
    std::function<float(glm::vec3 world, glm::vec3 normal)> visibility;
    std::function<float(glm::vec3 world)> texel;  ///< width across the light, world units
};

void read_floats(const char* file, image<float>& map) {
    const auto bytes = std::streamsize(map.texels().size_bytes());
    std::ifstream stream(file, std::ios::binary);
    stream.read(reinterpret_cast<char*>(map.texels().data()), bytes);
    if (!stream || stream.peek() != EOF) throw std::runtime_error(std::string(file) + ": not a map of this size");
}

/// Looks the light up as its shadow does.
/// @param file   a map that the recipe drew; null: C++ draws it
template <class Shadow>
void look_up(light& l, const Shadow& shadow, const geometry& scene, const char* file) {
    image<float> depths(shadow.size(), cleared_depth(shadow.setup().clip()));
    if (file != nullptr) read_floats(file, depths);
    else shadow.draw(depths, {scene.positions, scene.triangles});
    image<typename Shadow::texel> map(shadow.size(), shadow.cleared());
    shadow.store(depths, map);
    l.visibility = [shadow, map](glm::vec3 world, glm::vec3 normal) { return shadow(map, world, normal); };
    l.texel = [shadow](glm::vec3 world) {
        float width = 0;
        for (const auto& space : shadow.setup().lights()) {
            const glm::dvec4 at = space.projection * space.view * glm::dvec4(world, 1.0);
            width = float(2.0 * at.w / (space.projection[0][0] * shadow.map_size().x));
            if (at.w > 0 && glm::abs(at.x) < 0.95 * at.w && glm::abs(at.y) < 0.95 * at.w) break;
        }
        return width;
    };
}

light spot_light() {
    const auto towards = [](glm::vec3 world) { return glm::normalize(glm::vec3(5, 8, 4) - world); };
    return {"spot light",
            true,
            [=](glm::vec3 world, glm::vec3 normal) {
                const float cone = glm::dot(towards(world), glm::normalize(glm::vec3(5, 8, 4)));
                return glm::smoothstep(0.88f, 0.9f, cone) * glm::dot(normal, towards(world));
            },
            towards,
            {},
            {}};
}
light sun_light() {
    const glm::vec3 to_sun = glm::normalize(glm::vec3(-1, 1.2f, 0.7f));
    return {"sun",
            false,
            [=](glm::vec3, glm::vec3 normal) { return glm::dot(normal, to_sun); },
            [=](glm::vec3) { return to_sun; },
            {},
            {}};
}

light lamp_light(glm::vec3 position) {
    const auto towards = [=](glm::vec3 world) { return glm::normalize(position - world); };
    return {"lamp",  false, [=](glm::vec3 world, glm::vec3 normal) { return glm::dot(normal, towards(world)); },
            towards, {},    {}};
}

/// The lights of a recipe.
std::vector<light> lights_of(const std::string& recipe, const geometry& scene, const char* file) {
    std::vector<light> all{spot_light(), sun_light()};
    const auto both = [&](clip_space clip, const auto&... encoding) {
        look_up(all[0], shadow(scene::make_spot(clip), {1024, 1024}, filters::tent<3>, encoding...), scene, file);
        look_up(all[1], shadow(scene::make_cascades(clip), {1024, 1024}, filters::tent<3>, encoding...), scene,
                nullptr);
    };
    const auto reversed = [](clip_space clip) {
        clip.direction = depth_direction::reversed;
        return clip;
    };
    if (recipe == "opengl" || recipe == "webgl2" || recipe == "with_moderngl") both(opengl_clip_space);
    else if (recipe == "webgpu") both(reversed(webgpu_clip_space));
    else if (recipe == "vulkan") both(reversed(vulkan_clip_space));
    else if (recipe == "opengl_es2") both(opengl_clip_space, rgb24{});
    else if (recipe == "webgl") {
        const point_light<float> lamp{
            .position = {-1.5f, 2.6f, 1.8f}, .z_far = 50, .map_size = 512, .border = 3, .clip = opengl_clip_space};
        both(opengl_clip_space, rgb24{});
        all[1] = lamp_light(lamp.position);
        look_up(all[1], shadow(lamp, {512, 512}, filters::tent<3>, rgb24{}), scene, nullptr);
    } else throw std::invalid_argument("no recipe " + recipe);
    return all;
}

/// Surfaces that the camera sees, in each pixel where no rasterizer takes another for them.
class pixels {
public:
    struct pixel {
        glm::ivec2 at;
        glm::vec3 world, normal;
    };

    explicit pixels(const geometry& scene) : scene_(scene) {
        for (glm::ivec2 p(0); p.y < scene::picture_size.y; ++p.y)
            for (p.x = 0; p.x < scene::picture_size.x; ++p.x) {
                const glm::vec2 center = glm::vec2(p) + 0.5f;
                const auto [distance, triangle] = scene.trace(scene::camera.position, ray(center));
                if (!(distance < INFINITY) || at_border(center, triangle)) continue;
                all_.push_back({p, scene::camera.position + ray(center) * distance, scene.corners[triangle].normal});
            }
    }
    [[nodiscard]] const std::vector<pixel>& all() const { return all_; }

private:
    [[nodiscard]] glm::vec3 ray(glm::vec2 on_picture) const {
        const glm::vec2 at = (2.0f * on_picture / glm::vec2(scene::picture_size) - 1.0f) *
                             glm::vec2(scene::camera.tan_half_x, -scene::camera.tan_half_y);
        return axes_ * glm::vec3(at, -1);
    }
    [[nodiscard]] bool at_border(glm::vec2 center, std::size_t triangle) const {
        const scene::vertex& first = scene_.corners[triangle];
        for (const glm::vec2 off : {glm::vec2(-1, -1), {1, -1}, {-1, 1}, {1, 1}}) {
            const auto [distance, other] = scene_.trace(scene::camera.position, ray(center + off * 0.125f));
            const scene::vertex& v = scene_.corners[other];
            const float apart = glm::dot(v.position - first.position, first.normal);
            if (!(distance < INFINITY) || v.normal != first.normal || glm::abs(apart) > 1e-4f) return true;
        }
        return false;
    }

    const geometry& scene_;
    glm::mat3 axes_{glm::transpose(
        glm::mat3(look_along(scene::camera.position, scene::camera.direction, scene::camera.up, handedness::right)))};
    std::vector<pixel> all_;
};

/// A recipe's picture.
class picture {
public:
    explicit picture(const char* file) {
        glm::ivec2 size(0);
        int channels = 0;
        stbi_uc* bytes = stbi_load(file, &size.x, &size.y, &channels, 4);
        if (bytes == nullptr || size != scene::picture_size)
            throw std::runtime_error(std::string(file) + ": no picture of this size");
        bytes_.assign(bytes, bytes + 4 * size.x * size.y);
        stbi_image_free(bytes);
    }

    /// @return   false when too many pixels differ, or one that is farther than two texels from an edge
    [[nodiscard]] bool agrees(const light& l, const pixels& seen, const char* with) const {
        int compared = 0, dark = 0, differ = 0, astray = 0;
        for (const auto& [at, world, normal] : seen.all()) {
            const float full = l.brightness(world, normal);
            if (full < 0.11f) continue;
            const bool expected = l.visibility(world, normal) > 0.5f;
            ++compared, dark += !expected;
            if (lit(at, l.is_spot, full) == expected) continue;
            ++differ, astray += !near_edge(l, world, normal, expected);
        }
        std::printf("%s, %s: %d pixels, %d in shadow, %d differ, %d of them farther than two texels from an edge\n",
                    l.name, with, compared, dark, differ, astray);
        return compared > 10000 && dark > 500 && 200 * differ <= compared && astray == 0;
    }

private:
    [[nodiscard]] bool lit(glm::ivec2 p, bool by_spot, float full) const {
        const unsigned char* bytes = &bytes_[std::size_t(4 * (p.y * scene::picture_size.x + p.x))];
        const glm::vec3 light = glm::vec3(bytes[0], bytes[1], bytes[2]) / 255.0f - ambient_color;
        const float by_other = light.b / other_color.b, spot = (light.r - other_color.r * by_other) / spot_color.r;
        return (by_spot ? spot : by_other) > 0.5f * full;
    }
    [[nodiscard]] static bool near_edge(const light& l, glm::vec3 world, glm::vec3 normal, bool expected) {
        const glm::vec3 towards = l.towards(world),
                        across = glm::normalize(glm::cross(towards, glm::vec3(0.3f, 0.1f, 1)));
        for (int i = -4; i <= 4; ++i)
            for (int j = -4; j <= 4; ++j) {
                glm::vec3 off = (across * float(i) + glm::cross(towards, across) * float(j)) * (0.5f * l.texel(world));
                off -= towards * (glm::dot(normal, off) / glm::dot(normal, towards));
                if ((l.visibility(world + off, normal) > 0.5f) != expected) return true;
            }
        return false;
    }

    std::vector<unsigned char> bytes_;
};

}  // namespace

int main(int argc, char** argv) try {
    if (argc < 3) throw std::invalid_argument("RECIPE PICTURE.png [MAP.floats]");
    geometry scene;
    const pixels seen(scene);
    const picture drawn(argv[2]);
    bool good = true;
    for (const light& l : lights_of(argv[1], scene, nullptr)) good = drawn.agrees(l, seen, "own map") && good;
    if (argc > 3) good = drawn.agrees(lights_of(argv[1], scene, argv[3])[0], seen, "map read back") && good;
    for (glm::vec3& p : scene.positions) p.x += 0.1f;
    for (const light& l : lights_of(argv[1], scene, nullptr))
        good = !drawn.agrees(l, seen, "casters elsewhere") && good;
    return good ? 0 : 1;
} catch (const std::exception& error) {
    std::fprintf(stderr, "recipes_compare: %s\n", error.what());
    return 1;
}
