// SPDX-License-Identifier: MIT
//
// The npm package's engine_bias against rays: engines as emulated, with the settings that it gives, with too little of
// them, and with the engines' defaults. Prints a table. Returns 1 where a lit receiver is dark under the settings that
// it gives, or under others that it calls free of acne, and where too little is enough.
//
//     engine_bias NUMBERS RESULTS
//
// NUMBERS has the lines that tests/package/engines_test.mjs wrote. RESULTS gets the shares of lone planes that are
// dark by default, for the emulation of the site.
//
// Lone planes, tilted by up to 89 degrees, which nothing else shades: every receiver must be lit. Houses with eaves,
// where a receiver must be lit if 33 rays reach the light, from its plane as far around as the filter looks.
#include <cstdio>
#include <fstream>
#include <map>
#include <memory>
#include <random>
#include <string>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/trigonometric.hpp>

#include <umbrage/core/image.hpp>
#include <umbrage/light/directional_light.hpp>
#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/shadow/shadow.hpp>

#include "discs.hpp"
#include "engine_rows.hpp"
#include "light_maps.hpp"
#include "receivers.hpp"
#include "scenes.hpp"

namespace proof::picture {
namespace {

constexpr float lit = 0.9999f;  // every texel that a filter compares is, but for the rounding of its weights' sum

struct count {
    double all = 0, dark = 0;
    double dark_at_edges = 0;  ///< steeper than the settings serve where a filter sees the next face
    [[nodiscard]] double percent() const { return all > 0 ? 100 * (dark + dark_at_edges) / all : 0; }
};

[[nodiscard]] umbrage::light_space<double> light_for(const engine_row& r, glm::dvec3 direction, glm::dvec3 target) {
    return umbrage::make_directional_light<double>({.direction = direction,
                                                    .target = target,
                                                    .offset = 1 + r.range / 2,
                                                    .map_size = glm::ivec2(r.map_size),
                                                    .texels_per_unit = r.map_size / r.width,
                                                    .z_near = 1,
                                                    .z_far = 1 + r.range,
                                                    .clip = umbrage::cpu_clip_space});
}

[[nodiscard]] map_axes axes_of(const glm::dmat4& to_texels) {
    const auto row = [&](int i) {
        return glm::normalize(glm::dvec3(to_texels[0][i], to_texels[1][i], to_texels[2][i]));
    };
    return {row(0), row(1), -row(2)};
}

/// Receivers of lone planes under one engine. Positions and the matrix are floats, as in a shader; vertices lie on a
/// grid of 1/16 texel.
[[nodiscard]] count lone_planes(const engine_row& r, std::mt19937& random) {
    const auto real = [&](double low, double high) { return low + (high - low) * 0x1p-32 * double(random()); };
    const auto direction = [&] {
        const double z = real(-1, 1), angle = real(0, 2 * std::numbers::pi), out = std::sqrt(1 - z * z);
        return glm::dvec3(out * std::cos(angle), out * std::sin(angle), z);
    };
    count found;
    for (int k = 0; k < 40; ++k) {
        const glm::dvec3 target(real(-1, 1) * r.width / 4, real(-1, 1) * r.width / 4, real(-1, 1) * r.width / 4);
        const glm::dmat4 exact = umbrage::texture_matrix(light_for(r, direction(), target), glm::ivec2(r.map_size));
        const glm::mat4 to_texels(exact);
        const map_axes axes = axes_of(exact);
        for (int i = 0; i < 200; ++i) {
            const double tilt = real(0, 89) / 180 * std::numbers::pi, turn = real(0, 2 * std::numbers::pi);
            const glm::dvec3 normal =
                std::cos(tilt) * axes.to_light + std::sin(tilt) * (std::cos(turn) * axes.x + std::sin(turn) * axes.y);
            const glm::dvec3 p = target + (real(-1, 1) * axes.x + real(-1, 1) * axes.y) * r.width / 8.0;
            const engine_moves moves = moves_of(r, axes, normal);
            const glm::dvec3 place = glm::dvec3(exact * glm::dvec4(p, 1.0));
            const glm::dvec2 slope =
                glm::dvec2(glm::dot(normal, axes.x), glm::dot(normal, axes.y)) / std::cos(tilt) * r.texel() / r.range;
            const double moved = -glm::dot(normal, moves.caster) / std::cos(tilt) / r.range;
            const glm::dvec2 snapped(real(-1, 1) / 32, real(-1, 1) / 32);
            const auto fetch = [&](glm::ivec2 texel) {
                const glm::dvec2 away = glm::dvec2(texel) + 0.5 + snapped - glm::dvec2(place);
                return stored_depth(r, place.z + glm::dot(slope, away) + moved);
            };
            const glm::vec3 receiver = glm::vec3(p) + glm::vec3(moves.receiver);
            const glm::dvec3 at(to_texels * glm::vec4(receiver, 1.0f));
            found.all += 1;
            found.dark += filtered(r, fetch, at, turn) < lit;
        }
    }
    return found;
}

/// Houses with eaves, seen by a camera.
struct street {
    scene houses = boxes_with_eaves(1, glm::dvec3(0));
    ray_tree tree{houses.mesh};
};

/// Receivers of the street that are lit as far around as the engine looks.
[[nodiscard]] count houses(const engine_row& r, const street& s) {
    using namespace umbrage;
    const shadow maps_of(single_map(light_for(r, s.houses.sun, glm::dvec3(0))), glm::ivec2(r.map_size),
                         filters::pcf_2x2{});
    const light_maps maps(light_kind::sun, maps_of, {false, -s.houses.sun}, 0.0);
    const map_axes axes = axes_of(texture_matrix(maps.light(0), glm::ivec2(r.map_size)));
    ray_mesh casters;
    for (std::size_t k = 0; k < s.houses.mesh.triangles.size(); ++k) {
        const glm::dvec3 move = moves_of(r, axes, glm::normalize(glm::dvec3(s.houses.mesh.normal(k)))).caster;
        for (const glm::dvec3& corner : s.houses.mesh.corners(k)) casters.positions.emplace_back(corner + move);
        const auto first = static_cast<unsigned>(3 * k);
        casters.triangles.emplace_back(first, first + 1, first + 2);
    }
    const image<float> drawn = maps.draw([&](int) -> const ray_mesh& { return casters; }, cull_mode::none);
    const auto fetch = [map = bordered(maps.map_of(drawn, 0)), &r](glm::ivec2 texel) {
        return stored_depth(r, double(map(texel)));
    };
    const auto place_of = [&](glm::vec3 p, glm::vec3 n) {
        const auto& u = maps_of.uniforms();
        return std::remove_cvref_t<decltype(maps_of.setup())>::places(u.maps, u.terms, p, n)[0];
    };
    const double around = 2 * r.reach + 1;  // a receiver may be moved sideways by as much as the filter reaches
    count found;
    for (const receiver& each :
         visible_receivers(s.houses, s.tree, maps, place_of, 6, {around / 4, around / 2, 3 * around / 4, around})) {
        if (!each.disc_lit) continue;
        const glm::dvec3 normal(each.normal), moved = each.exact + moves_of(r, axes, normal).receiver;
        found.all += 1;
        if (filtered(r, fetch, maps.at(0, moved), noise_rotation(each.pixel)) >= lit) continue;
        ++(std::acos(each.cosine) > glm::radians(r.edges) ? found.dark_at_edges : found.dark);
    }
    return found;
}

int run(const std::string& path, const std::string& results) {
    std::mt19937 random(7);
    std::ofstream shares(results);
    const street s;
    std::map<std::string, count> short_of;  // engine -> lone planes with too little
    bool good = true;
    std::printf(
        "| engine | filter | map, width, range | settings | dark planes %% | dark houses %% | lacks, texels |\n"
        "|---|---|---|---|--:|--:|--:|\n");
    for (const engine_row& r : read_rows(path)) {
        const count planes = lone_planes(r, random);
        const bool has_houses = r.range < 100 && r.kind != "too_little";
        const count seen = has_houses ? houses(r, s) : count{};
        if (r.kind == "too_little") {
            short_of[r.engine].all += planes.all, short_of[r.engine].dark += planes.dark;
            continue;
        }
        std::printf("| %s | %s | %d, %g, %g | %s: %g, %g | %.2f | %.2f | %.2f |\n", r.engine.c_str(), r.filter.c_str(),
                    r.map_size, r.width, r.range, r.kind.c_str(), r.first, r.second, planes.percent(), seen.percent(),
                    r.lacking);
        if (has_houses && seen.all < 500) good = false, std::printf("only %.0f receivers of houses\n", seen.all);
        if (r.kind == "defaults")
            shares << r.engine << '\t' << r.filter << '\t' << r.map_size << '\t' << r.width << '\t' << r.range << '\t'
                   << planes.percent() / 100 << '\n';
        if (r.lacking == 0 && planes.dark + seen.dark > 0)
            good = false, std::printf("WRONG: %.0f planes, %.0f houses are dark\n", planes.dark, seen.dark);
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
    if (count != 3) return std::fprintf(stderr, "usage: engine_bias NUMBERS RESULTS\n"), 2;
    return proof::picture::run(arguments[1], arguments[2]);
}
