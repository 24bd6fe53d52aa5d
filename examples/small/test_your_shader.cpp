// SPDX-License-Identifier: MIT
//
// Compares a function of a shader on the GPU with C++:    test_your_shader [FILE.glsl], which has my_shadow as below
#include <cstdio>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include <umbrage/umbrage.hpp>

#include "on_gpu.hpp"

namespace {

// Percentage-closer filtering of 2 x 2 texels as one writes it by hand. It takes UV, and returns 1 when lit.
const char* const by_hand = R"GLSL(
float lit(sampler2D map, ivec2 texel, float depth) {
    return depth <= texelFetch(map, clamp(texel, ivec2(0), textureSize(map, 0) - 1), 0).x ? 1.0 : 0.0;
}
float my_shadow(sampler2D map, vec2 uv, float depth) {
    vec2 at = uv * vec2(textureSize(map, 0)) - 0.5, weight = fract(at);
    ivec2 low = ivec2(floor(at));
    float bottom = mix(lit(map, low, depth), lit(map, low + ivec2(1, 0), depth), weight.x);
    float top = mix(lit(map, low + ivec2(0, 1), depth), lit(map, low + ivec2(1, 1), depth), weight.x);
    return mix(bottom, top, weight.y);
}
)GLSL";

/// What it should be: your function's twin in C++.
float expected(const umbrage::image<float>& map, glm::vec3 receiver) {
    return umbrage::pcf_2x2(umbrage::clamped(map), glm::vec2(receiver), receiver.z);
}

constexpr int side = 64, count = 4096;  // texels of the map, receivers of each kind
constexpr const char* kinds[] = {"in the map", "texel centers", "as deep as it", "outside it", "beyond the far plane"};

}  // namespace

int main(int argc, char** argv) try {
    std::ostringstream function;
    if (argc > 1 && !(function << std::ifstream(argv[1]).rdbuf()))
        throw std::runtime_error("cannot read " + std::string(argv[1]));

    std::mt19937 random(2002);
    const auto number = [&] { return float(random() % 65536) / 65536; };
    umbrage::image<float> map({side, side});
    for (float& depth : map.texels()) depth = number();
    std::vector<glm::vec3> receivers;  // x and y in texels, and a depth
    for (int i = 0; i < 5 * count; ++i) {
        glm::vec3 r(number() * side, number() * side, number());
        if (i / count == 1) r = glm::vec3(glm::floor(glm::vec2(r)) + 0.5f, r.z);
        if (i / count == 2) r.z = map[glm::ivec2(glm::vec2(r))];
        if (i / count == 3) r.x += float(side) + 1;
        if (i / count == 4) r.z += 1;
        receivers.push_back(r);
    }

    const std::vector<float> visibility =
        on_gpu(argc > 1 ? function.str() : by_hand, "my_shadow(map, point.xy / vec2(textureSize(map, 0)), point.z)",
               map, receivers);

    std::puts("receivers               same bits    largest difference, at x, y, depth: the shader, C++");
    for (std::size_t kind = 0; kind < std::size(kinds); ++kind) {
        int same = 0;
        std::size_t worst = kind * count;
        const auto difference = [&](std::size_t i) { return std::abs(visibility[i] - expected(map, receivers[i])); };
        for (std::size_t i = kind * count; i < (kind + 1) * count; ++i) {
            same += difference(i) == 0;
            if (!(difference(i) <= difference(worst))) worst = i;
        }
        const glm::vec3 r = receivers[worst];
        std::printf("%-22s %9.2f %%    %.6f, at %.4f, %.4f, %.5f: %.6f, %.6f\n", kinds[kind], 100.0 * same / count,
                    difference(worst), r.x, r.y, r.z, visibility[worst], expected(map, r));
    }
} catch (const std::exception& error) {
    std::fprintf(stderr, "test_your_shader: %s\n", error.what());
    return 1;
}
