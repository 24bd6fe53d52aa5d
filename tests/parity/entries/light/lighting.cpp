// SPDX-License-Identifier: MIT
#include <limits>

#include <glm/geometric.hpp>

#include <umbrage/light/lighting.hpp>

#include "../entries.hpp"

namespace parity {
namespace {

using namespace umbrage;

/// Direction in x0.xyz, cosine in x0.w, point in x1.xyz; in "ties" the point lies on the cone as near as floats can.
std::vector<input_class> cones() {
    auto classes = spread({{-1, 1}, {-1, 1}, {-1, 1}, {0, 1}, {-9, 9}, {-9, 9}, {-9, 9}}, special_values());
    classes.push_back({"ties", [](auto, random& r, sample& s) {
                           const vec3 point{r.between(-9, 9), r.between(-9, 9), r.between(-9, 9)};
                           const vec3 axis = glm::normalize(vec3{r.between(-9, 9), r.between(-9, 9), r.between(-9, 9)});
                           s.x[0] = vec4(axis, glm::dot(axis, glm::normalize(point)));
                           s.x[1] = vec4(point, 0.0f);
                       }});
    return classes;
}

}  // namespace

void add_light_lighting(std::vector<entry>& all) {
    namespace glsl = umbrage::glsl;

    all.push_back({.primitive = &glsl::spot_cone,
                   .classes = cones(),
                   .twin = [](const sample& s) { return vec4(spot_cone(vec3(s.x[0]), vec3(s.x[1]), s.x[0].w)); },
                   .call = "vec4(umbrage_spot_cone(vec3(x0.x, x0.y, x0.z), vec3(x1.x, x1.y, x1.z), x0.w))"});
    // Albedo in x0.xyz, cosine in x0.w, ambient light in x1.xyz, visibility in x1.w.
    auto surfaces = spread({{0, 1}, {0, 1}, {0, 1}, {-1, 1}, {0, 1}, {0, 1}, {0, 1}, {0, 1}}, special_values());
    surfaces.push_back({"grazing, no ambient", [](std::uint64_t i, random& r, sample& s) {
                            const float least = std::numeric_limits<float>::min();
                            s.x[0] = vec4{r.unit(), r.unit(), 1.0f, std::array{0.0f, least, -least, 2 * least}[i % 4]};
                            s.x[1] = vec4(0.0f, 0.0f, 0.0f, 1.0f);
                        }});
    surfaces.push_back({"grazing, visibility infinite", [](std::uint64_t i, random& r, sample& s) {
                            const float infinity = std::numeric_limits<float>::infinity();
                            s.x[0] = vec4{r.unit(), r.unit(), 1.0f, 0.0f};
                            s.x[1] = vec4{r.unit(), r.unit(), r.unit(), i % 2 ? infinity : -infinity};
                        }});
    all.push_back(
        {.primitive = &glsl::diffuse_ambient,
         .classes = surfaces,
         .twin =
             [](const sample& s) {
                 return vec4(diffuse_ambient(vec3(s.x[0]), vec3(s.x[1]), s.x[0].w, s.x[1].w), 1.0f);
             },
         .call = "vec4(umbrage_diffuse_ambient(vec3(x0.x, x0.y, x0.z), vec3(x1.x, x1.y, x1.z), x0.w, x1.w), 1.0)"});
}

}  // namespace parity
