// SPDX-License-Identifier: MIT
//
// Debug views of shadows in shaders: the colors of umbrage_probe_* are C++'s, and umbrage_calibrate_* tells what is
// wrong with a map that OpenGL was given as a host might give it.
//
//     shadows_debug_in_gl    prints how many receivers differ, and each wrong reading; 1 when there is one
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <functional>
#include <string>
#include <vector>

#include <umbrage/umbrage.hpp>

#include "../../examples/viewer/headless.hpp"
#include "../unit/shadow/scene.hpp"
#include "drawn_in_gl.hpp"

namespace {

using namespace shadows_in_gl;
using glsl::bind;

template <class Map>
texture_data floats(const Map& map, GLint stored = GL_R32F) {
    return {.internal = stored, .size = {map.size(), 1}, .texels = map.texels().data()};
}

/// Receivers that differ in a color's three channels.
template <class Shadow>
bool colors_agree(version v, const Shadow& s, const texture_data& map, const receivers& of) {
    std::vector<tried> channels;
    for (int i = 0; i < 3; ++i)
        channels.push_back(
            make("probed", s, bind(s, "probed", {.debug = true}), map,
                 std::string("umbrage_probe_probed(world, normal).") + "xyz"[i],
                 [&s, i](glm::vec3 world, glm::vec3 normal, glm::ivec2) { return probe(s, world, normal)[i]; }));
    const auto wrong = compare(v, channels, of.points, of.normals);
    std::printf("  colors: %d, %d, %d receivers differ\n", wrong[0], wrong[1], wrong[2]);
    return wrong == std::vector<int>{0, 0, 0};
}

/// True when OpenGL reads a map as expected, in each receiver's pixel.
template <class Shadow>
bool reads(version v, const Shadow& s, const texture_data& map, int number, map_reading expected, const receivers& of,
           glsl::shadow_slots slots = {}) {
    slots.debug = true;
    const std::string call = "umbrage_calibrate_tried(" + std::to_string(number) + ".0) / 255.0";
    const std::vector<tried> one{make("tried", s, bind(s, "tried", slots), map, call,
                                      [=](glm::vec3, glm::vec3, glm::ivec2) { return float(expected) / 255.0f; })};
    const int wrong = compare(v, one, of.points, of.normals)[0];
    if (wrong != 0) std::printf("  not read as: %s\n", explain(expected));
    return wrong == 0;
}

/// A matrix in GLSL, to the bit.
std::string literal(const glm::mat4& m) {
    std::string all = "mat4(";
    char number[32];
    for (glm::length_t c = 0; c < 4; ++c)
        for (glm::length_t r = 0; r < 4; ++r) {
            std::snprintf(number, sizeof number, "%.9e", double(m[c][r]));
            all.append(c + r == 0 ? "" : ", ").append(number);
        }
    return all + ")";
}

/// Vertices of the depth pass that differ from C++'s, in any component.
template <class Shadow, class Twin>
bool vertices_agree(version v, const Shadow& s, const texture_data& map, const std::string& arguments, const Twin& twin,
                    const receivers& of, const std::function<float(glm::vec3)>& within = {}) {
    std::vector<tried> components;
    for (glm::length_t i = 0; i < 4; ++i) {
        auto item = bind(s, "drawn");
        const auto vertex = glsl::bind_vertex_pass(s, "drawn");
        item.texts.insert(item.texts.end(), vertex.texts.begin(), vertex.texts.end());
        components.push_back(make("drawn", s, item, map, "umbrage_vertex_drawn(" + arguments + ")." + "xyzw"[i],
                                  [twin, i](glm::vec3 world, glm::vec3, glm::ivec2) { return twin(world)[i]; }));
        components.back().within = within;
    }
    const auto wrong = compare(v, components, of.points, of.normals);
    std::printf("  vertices: %d, %d, %d, %d differ\n", wrong[0], wrong[1], wrong[2], wrong[3]);
    return wrong == std::vector<int>(4);
}

}  // namespace

int main() try {
    const clip_space clip = opengl_clip_space;
    clip_space reversed_clip = clip;
    reversed_clip.direction = depth_direction::reversed;
    const shadow sun(shadow_scene::cascades(clip), {256, 256}, filters::tent<3>);
    const shadow spot(shadow_scene::spot(reversed_clip), {256, 128}, filters::pcf_2x2{});
    const shadow bulb(shadow_scene::bulb(clip), {256, 256}, filters::disc{});
    const shadow sides(shadow_scene::tetrahedron(clip), {512, 512}, filters::pcf_2x2{});
    const shadow halves(shadow_scene::paraboloids(clip), {512, 512}, filters::pcf_2x2{});
    const shadow soft(shadow_scene::fitted(clip), {200, 300}, shadow_scene::sized(filters::pcss{}));
    const shadow smooth(shadow_scene::fitted(clip), {200, 300}, prefilters::vsm{});
    const shadow sampled(shadow_scene::fitted(clip), {200, 300}, filters::box{.radius = 1});
    const receivers of(target_size);
    bool good = true;
    const auto check = [&](bool holds) { good = good && holds; };
    for (const version v : {version::v330, version::v100}) {
        const bool old = v == version::v100;
        const viewer::headless context(old);
        std::printf("GLSL %s, %s\n", std::string(directive(v)).c_str(), glGetString(GL_RENDERER));
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        const auto texture = [old](const image<float>& map, GLint stored = GL_R32F) {
            texture_data t = floats(map, old ? GLint(GL_LUMINANCE) : stored);
            if (old) t.format = GL_LUMINANCE;
            else t.format = GL_RED;
            return t;
        };
        const auto debugged = [&](const auto& s) {
            auto known = calibration_map(s);
            const int last = s.size().x / s.map_size().x * (s.size().y / s.map_size().y) - 1;
            if (!old) check(colors_agree(v, s, texture(known), of));
            check(reads(v, s, texture(known), last, map_reading::right, of));
            std::fill(known.texels().begin(), known.texels().end(), s.cleared());
            check(reads(v, s, texture(known), 0, map_reading::empty, of));
        };
        debugged(sun);
        debugged(spot);
        debugged(bulb);
        debugged(sides);
        debugged(halves);
        debugged(soft);

        const auto known = calibration_map(spot);
        image<float> flipped(known.size()), squared = known;
        for (glm::ivec2 p(0); p.y < known.size().y; ++p.y)
            for (p.x = 0; p.x < known.size().x; ++p.x) flipped[p] = known[{p.x, known.size().y - 1 - p.y}];
        for (float& depth : squared.texels()) depth *= depth;
        check(reads(v, spot, texture(flipped), 0, map_reading::upside_down, of));
        check(reads(v, spot, texture(squared), 0, map_reading::wrong, of));
        check(reads(v, spot, texture(image<float>(known.size(), 1.0f)), 0, map_reading::dark, of));
        check(reads(v, bulb, texture(calibration_map(bulb)), 5, map_reading::right, of));
        if (old) continue;  // whose textures are read by shares of their size, whatever it is
        for (const glm::ivec2 size : {glm::ivec2(128, 64), {512, 256}, {256, 120}, {244, 128}, {268, 128}}) {
            // not the block's size, as after a resize that reached the texture alone
            const shadow other(shadow_scene::spot(reversed_clip), size, filters::pcf_2x2{});
            check(reads(v, spot, texture(calibration_map(other)), 0, map_reading::wrong, of));
        }
        check(reads(v, spot, texture(known, GL_R16F), 0, map_reading::coarse, of));
        check(reads(v, spot, texture(known, GL_R8), 0, map_reading::coarse, of));
        const auto moments = calibration_map(smooth);
        texture_data two = floats(moments, GL_RG32F);
        two.format = GL_RG;
        check(reads(v, smooth, two, 0, map_reading::right, of));

        const auto literal_of = [](const glm::vec4& a) {
            char text[96];
            std::snprintf(text, sizeof text, "vec4(%.9e, %.9e, %.9e, %.9e)", double(a.x), double(a.y), double(a.z),
                          double(a.w));
            return std::string(text);
        };
        const depth_view to_sun = sampled.depth_views()[0], to_spot = spot.depth_views()[0],
                         to_halves = halves.depth_views()[0];
        const float at_near = near_depth(sampled.setup().clip());
        check(vertices_agree(
            v, sampled, texture(calibration_map(sampled)),
            literal(to_sun.to_clip) + ", world * 4.0, " + literal_of(to_sun.anchor),
            [&](glm::vec3 p) { return pancake(anchored_vertex(to_sun.to_clip, p * 4.0f, to_sun.anchor), at_near); },
            of));
        check(vertices_agree(
            v, spot, texture(known), literal(to_spot.to_clip) + ", world, " + literal_of(to_spot.anchor),
            [&](glm::vec3 p) { return anchored_vertex(to_spot.to_clip, p, to_spot.anchor); }, of));
        const glm::vec3 bulb_position(0.5f, 8.0f, 0.25f);
        const auto half_place = [&](glm::vec3 p) { return dual_paraboloid_position(p - bulb_position, 1.0f); };
        check(vertices_agree(
            v, halves, texture(calibration_map(halves)),
            literal(to_halves.to_clip) + ", world, vec4(0.5, 8.0, 0.25, 0.0), 1.0",
            [&](glm::vec3 p) {
                const glm::vec4 q = half_place(p);
                const glm::mat4& m = to_halves.to_clip;
                return m[3] * q.w + m[0] * q.x + m[1] * q.y + m[2] * q.z;
            },
            of,
            [&](glm::vec3 p) {  // its square root and 22 operations more, of what adds up to a component
                const glm::vec4 q = glm::abs(half_place(p));
                glm::vec4 s(0);
                for (glm::length_t c = 0; c < 4; ++c) s += glm::abs(to_halves.to_clip[c]) * q[c];
                return 0x1p-23f * 22.0f * std::max({s.x, s.y, s.z, s.w});
            }));

        const auto compared = calibration_map(sampled);
        texture_data depth = floats(compared, GL_DEPTH_COMPONENT32F);
        depth.format = GL_DEPTH_COMPONENT;
        depth.compares = GL_LEQUAL;
        check(reads(v, sampled, depth, 0, map_reading::right, of, {.map = glsl::texture::shadow}));
        depth.compares = GL_GEQUAL;
        check(reads(v, sampled, depth, 0, map_reading::reversed, of, {.map = glsl::texture::shadow}));
        image<float> one_layer({256, 256 * 4});
        const auto tiles = calibration_map(sun);
        for (int i = 0; i < 4; ++i)
            for (int y = 0; y < 256; ++y)
                for (int x = 0; x < 256; ++x)
                    one_layer[{x, y + 256 * i}] = tiles[cascade_tile((i + 1) % 3, glm::ivec2(256)) + glm::ivec2(x, y)];
        const texture_data turned{
            .kind = GL_TEXTURE_2D_ARRAY, .size = {256, 256, 4}, .texels = one_layer.texels().data()};
        check(reads(v, sun, turned, 1, map_reading::another_map, of, {.map = glsl::texture::array}));
    }
    std::puts(good ? "all as C++ says" : "something differs");
    return good ? 0 : 1;
} catch (const viewer::no_context& e) {
    std::puts(e.what());
    return 77;
} catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 1;
}
