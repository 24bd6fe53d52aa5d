// SPDX-License-Identifier: MIT
//
// The npm package's engine_bias for spot lights and point lights: lone planes, tilted by up to 89 degrees, which
// nothing else shades, so that every receiver must be lit. A texel's depth is that of the ray through it. Prints a
// table, and writes the dark shares of settings that are not enough into a file, for tests/site/engines_test.mjs.
// Returns 1 where a receiver is dark under settings that engine_bias calls free of acne, and where too little of them
// is enough.
//
//     engine_cones NUMBERS RESULTS        the lines that tests/package/engines_test.mjs wrote
#include <cstdio>
#include <fstream>
#include <map>
#include <random>
#include <string>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/trigonometric.hpp>

#include "engine_cone_rows.hpp"

namespace proof::picture {
namespace {

constexpr float lit = 0.9999f;  // every texel that a filter compares is, but for the rounding of its weights' sum

struct count {
    double all = 0, dark = 0;
    [[nodiscard]] double percent() const { return all > 0 ? 100 * dark / all : 0; }
};

class draws {
public:
    [[nodiscard]] double real(double low, double high) { return low + (high - low) * 0x1p-32 * double(random_()); }
    [[nodiscard]] glm::dvec3 direction() {
        const double z = real(-1, 1), angle = real(0, 2 * std::numbers::pi), out = std::sqrt(1 - z * z);
        return {out * std::cos(angle), out * std::sin(angle), z};
    }
    /// Ray to a receiver, in a map whose axis is z: in a spot light's cone, or anywhere on a face of a cube.
    [[nodiscard]] glm::dvec3 ray(const cone_row& r) {
        if (r.light == "point") return {real(-1, 1), real(-1, 1), 1};
        const double out = r.tangent() * std::sqrt(real(0, 1)), angle = real(0, 2 * std::numbers::pi);
        return {out * std::cos(angle), out * std::sin(angle), 1};
    }
    /// Direction at an angle to another.
    [[nodiscard]] glm::dvec3 tilted(glm::dvec3 from, double tilt) {
        const glm::dvec3 x = glm::normalize(glm::cross(from, direction()));
        return std::cos(tilt) * from + std::sin(tilt) * x;
    }

private:
    std::mt19937 random_{7};
};

[[nodiscard]] count lone_planes(const cone_row& r, draws& random) {
    count found;
    for (int k = 0; k < 20; ++k) {
        const glm::dvec3 z = random.direction(), x = glm::normalize(glm::cross(z, random.direction()));
        const glm::dmat3 to_world(x, glm::cross(z, x), z);
        const glm::dvec3 origin = random.direction() * (r.range / 4);
        const cone_map map(r, to_world, origin);
        for (int i = 0; i < 100; ++i) {
            const glm::dvec3 ray = random.ray(r);
            const double depth = random.real(0.125, 1) * r.range;
            if (glm::length(ray) * depth > r.range && r.light == "point") continue;  // beyond the light
            const lone_plane plane{.receiver = ray * depth,
                                   .normal = random.tilted(-glm::normalize(ray), glm::radians(random.real(0, 89)))};
            const glm::dvec2 snapped(random.real(-1, 1) / 32, random.real(-1, 1) / 32);
            found.all += 1;
            found.dark += map.visibility(plane, snapped, random.real(0, 2 * std::numbers::pi)) < lit;
        }
    }
    return found;
}

int run(const std::string& path, const std::string& results) {
    draws random;
    std::ofstream shares(results);
    std::map<std::string, count> short_of;  // engine -> planes with too little
    bool good = true;
    std::printf(
        "| engine | light | filter | map, range | settings | dark planes %% | lacks, texels |\n"
        "|---|---|---|---|--:|--:|--:|\n");
    for (const cone_row& r : read_cone_rows(path)) {
        const count planes = lone_planes(r, random);
        if (r.kind != "ours" && planes.dark > 0)
            shares << r.light << '\t' << r.engine << '\t' << r.filter << '\t' << r.map_size << '\t' << r.width << '\t'
                   << r.range << '\t' << r.first << '\t' << r.second << '\t' << r.third << '\t' << r.fourth << '\t'
                   << planes.percent() / 100 << '\n';
        if (r.kind == "too_little") {
            short_of[r.engine].all += planes.all, short_of[r.engine].dark += planes.dark;
            continue;
        }
        std::printf("| %s | %s | %s | %d, %g | %s: %g, %g | %.2f | %.2f |\n", r.engine.c_str(), r.light.c_str(),
                    r.filter.c_str(), r.map_size, r.range, r.kind.c_str(), r.first, r.second, planes.percent(),
                    r.lacking);
        if (r.lacking == 0 && planes.dark > 0) good = false, std::printf("WRONG: %.0f planes are dark\n", planes.dark);
    }
    for (const auto& [engine, planes] : short_of) {
        std::printf("%s with too little of the settings: %.3f %% of the planes dark%s\n", engine.c_str(),
                    planes.percent(), planes.dark > 0 ? "" : ": it is enough");
        good = good && planes.dark > 0;
    }
    if (!shares.flush()) good = false, std::printf("cannot write %s\n", results.c_str());
    return good ? 0 : 1;
}

}  // namespace
}  // namespace proof::picture

int main(int count, char** arguments) {
    if (count != 3) return std::fprintf(stderr, "usage: engine_cones NUMBERS RESULTS\n"), 2;
    return proof::picture::run(arguments[1], arguments[2]);
}
