// SPDX-License-Identifier: MIT
//
// Shadows by a comparison sampler that filters linearly: each setup, in both directions of depth, under each filter
// that has such a form. Whatever a sampler's weights are, a receiver is lit where all texels that it may read show its
// own plane, and dark where all show the table above it.
#include <cstdio>
#include <exception>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <umbrage/umbrage.hpp>

#include "../../examples/viewer/headless.hpp"
#include "../unit/shadow/scene.hpp"
#include "drawn_in_gl.hpp"

namespace {

using namespace shadows_in_gl;

enum class wanted { dark, lit, either };

/// What the texels around a receiver say of it, in every map that it is looked up in.
template <class Shadow>
wanted judged(const Shadow& s, const image<float>& map, glm::vec3 world) {
    using Setup = std::remove_cvref_t<decltype(s.setup())>;
    const auto u = s.uniforms();
    const float nearer = s.encoding().direction == depth_direction::forward ? -1.0f : 1.0f;
    const int reach = static_cast<int>(glm::ceil(detail::reach_of(s.filter()))) + 1;
    bool all_own = true, all_nearer = true;
    for (const map_place& place : Setup::places(u.maps, u.terms, world, shadow_scene::up)) {
        if (place.weight == 0.0f) continue;
        const glm::ivec2 middle(glm::floor(glm::vec2(place.at))), last = s.map_size() - 1 - reach;
        if (!(place.at.z > 0.0f && place.at.z < 1.0f)) return wanted::either;
        if (glm::any(glm::lessThan(middle, glm::ivec2(reach))) || glm::any(glm::greaterThan(middle, last)))
            return wanted::either;
        const float steep = glm::abs(place.slope.x) + glm::abs(place.slope.y);
        const glm::ivec2 first = detail::first_texel(place.number, Setup::grid, s.map_size());
        for (glm::ivec2 t = middle - reach; t.y <= middle.y + reach; ++t.y)
            for (t.x = middle.x - reach; t.x <= middle.x + reach; ++t.x) {
                const glm::vec2 from = glm::vec2(t) + 0.5f - glm::vec2(place.at);
                const float apart = nearer * (map[first + t] - place.at.z - glm::dot(place.slope, from));
                all_own = all_own && glm::abs(apart) < steep / 64.0f + place.slack;
                all_nearer = all_nearer && apart > 4.0f * steep + 8.0f * place.slack;
            }
    }
    return all_own ? wanted::lit : all_nearer ? wanted::dark : wanted::either;
}

/// Draws a shadow's receivers and compares.
/// @return   false where one is wrong, or where the test says nothing
template <class Shadow>
bool agrees(const char* light, const char* filter, const Shadow& s, const receivers& of) {
    const map_grid grid = std::remove_cvref_t<decltype(s.setup())>::grid;
    const bool array = grid.columns * grid.rows > 1, reversed = s.encoding().direction == depth_direction::reversed;
    const image<float> map = shadow_scene::drawn(s), texels = layers_of(s, map);
    int lit = 0, dark = 0;
    for (const glm::vec4& p : of.points.texels()) {
        const wanted w = judged(s, map, glm::vec3(p));
        lit += w == wanted::lit, dark += w == wanted::dark;
    }
    tried one = make(
        "lamp", s,
        glsl::bind(s, "lamp",
                   {.map = array ? glsl::texture::shadow_array : glsl::texture::shadow, .linear = true, .debug = true}),
        {.kind = GLenum(array ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D),
         .internal = GL_DEPTH_COMPONENT32F,
         .format = GL_DEPTH_COMPONENT,
         .size = {s.map_size(), array ? grid.columns * grid.rows : 1},
         .texels = texels.texels().data(),
         .compares = GLenum(reversed ? GL_GEQUAL : GL_LEQUAL),
         .filter = GL_LINEAR},
        map);
    one.twin = [&](glm::vec3 world, glm::vec3, glm::ivec2) {
        const wanted w = judged(s, map, world);
        return w == wanted::lit ? 1.0f : w == wanted::dark ? 0.0f : 0.5f;
    };
    one.within = [&](glm::vec3 world) { return judged(s, map, world) == wanted::either ? 0.5f : 0.0f; };
    std::vector<tried> all;
    all.push_back(std::move(one));
    const int wrong = compare(version::v330, all, of.points, of.normals)[0];
    std::printf("%s, %s, %s depth: %d of %d lit and %d dark receivers are wrong\n", light, filter,
                reversed ? "reversed" : "forward", wrong, lit, dark);
    return wrong == 0 && lit > 1000 && dark > 20;
}

template <class Filter>
bool agrees(const char* name, const Filter& filter, const receivers& of) {
    bool good = true;
    for (const auto direction : {depth_direction::forward, depth_direction::reversed}) {
        clip_space clip = opengl_clip_space;
        clip.range = depth_range::zero_to_one, clip.direction = direction;
        const auto tried = [&](const char* light_name, const auto& light, glm::ivec2 size) {
            good = agrees(light_name, name, shadow(light, size, filter), of) && good;
        };
        tried("spot", shadow_scene::spot(clip), {512, 256});
        tried("sun", shadow_scene::fitted(clip), {600, 800});
        tried("cascades", shadow_scene::cascades(clip), {256, 256});
        tried("cube", shadow_scene::bulb(clip), {256, 256});
    }
    return good;
}

}  // namespace

int main() try {
    const viewer::headless context(false);
    // softpipe compares with a filtered depth, it does not filter comparisons
    if (std::string_view(reinterpret_cast<const char*>(glGetString(GL_RENDERER))).find("softpipe") == 0) return 77;
    receivers of(target_size);
    for (glm::vec4& n : of.normals.texels()) n = glm::vec4(shadow_scene::up, 0);
    for (glm::vec4& p : of.points.texels()) p.y = glm::max(p.y, 0.0f);  // where a bias ends, a sampler decides
    for (std::size_t i = 0; i < of.points.texels().size(); i += 3)      // more of them below the table
        of.points.texels()[i] *= glm::vec4(0.1f, 0, 0.1f, 1);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    bool good = agrees("pcf_2x2", filters::pcf_2x2{}, of);
    good = agrees("tent<3>", filters::tent<3>, of) && good;
    good = agrees("castano<5>", filters::castano<5>, of) && good;
    good = agrees("disc", filters::disc{}, of) && good;
    return good ? 0 : 1;
} catch (const viewer::no_context& e) {
    std::puts(e.what());
    return 77;
} catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 1;
}
