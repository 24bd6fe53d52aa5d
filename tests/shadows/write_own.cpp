// SPDX-License-Identifier: MIT
//
// Shadows with a filter and with a setup of a user's own, for a browser:  shadows_write_own FILE
//
// FILE holds, as JSON, receivers with what C++ says of each, and for each shadow its block, its map and its texts.
#include <charconv>
#include <cstring>
#include <fstream>
#include <iostream>
#include <span>
#include <string>
#include <vector>

#include <umbrage/umbrage.hpp>

#include "../unit/shadow/own_filter.hpp"
#include "../unit/shadow/own_setup.hpp"
#include "../unit/shadow/scene.hpp"
#include "receivers.hpp"

namespace {

using namespace umbrage;
using shadows_in_gl::receivers;

constexpr glm::ivec2 target(64, 64);

std::string numbers(std::span<const float> all) {
    std::string out;
    char digits[32];
    for (const float n : all)
        out.append(out.empty() ? "" : ",").append(digits, std::to_chars(digits, digits + 32, n).ptr);
    return '[' + out + ']';
}
std::string numbers(const image<glm::vec4>& all) { return numbers({&all.texels().data()->x, 4 * all.texels().size()}); }

std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        if (c == '\n') out += "\\n";
        else out += c;
    }
    return out + '"';
}

/// A shadow named `own`.
std::string written(std::string_view what, const auto& s, const receivers& of) {
    const auto map = shadow_scene::drawn(s);
    const auto uniforms = s.uniforms();
    std::vector<float> block(sizeof uniforms / sizeof(float)), seen;
    std::memcpy(block.data(), &uniforms, sizeof uniforms);
    for (glm::ivec2 p(0); p.y < target.y; ++p.y)
        for (p.x = 0; p.x < target.x; ++p.x) seen.push_back(s(map, glm::vec3(of.points[p]), glm::vec3(of.normals[p])));
    const auto text = [&](glsl::version v) {
        return quoted(glsl::source(v, {glsl::bind(s, "own")}, "precision highp float;\nprecision highp sampler2D;\n"));
    };
    return "{\"what\":" + quoted(std::string(what)) + ",\"block\":" + numbers(block) + ",\"size\":[" +
           std::to_string(map.size().x) + ',' + std::to_string(map.size().y) + "],\"map\":" + numbers(map.texels()) +
           ",\"seen\":" + numbers(seen) + ",\"texts\":[" + text(glsl::version::v100) + ',' +
           text(glsl::version::v300_es) + "]}";
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    const clip_space clip = opengl_clip_space;
    const receivers of(target);
    std::ofstream file(argv[1], std::ios::binary);
    file << "{\"size\":[" << target.x << ',' << target.y << "],\"points\":" << numbers(of.points)
         << ",\"normals\":" << numbers(of.normals) << ",\"shadows\":["
         << written("a filter", shadow(shadow_scene::cascades(clip), {256, 256}, own::two_taps{}), of) << ','
         << written("a setup", shadow(own::up_and_down{{0.5, 8, 0.25}, clip}, {256, 256}, filters::tent<3>), of)
         << "]}\n";
    if (file) return 0;
    std::cerr << "shadows_write_own: cannot write " << argv[1] << '\n';
    return 1;
}
