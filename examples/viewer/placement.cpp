// SPDX-License-Identifier: MIT
#include "placement.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#include <umbrage/light/point/dual_paraboloid.hpp>
#include <umbrage/light/point/point_light.hpp>
#include <umbrage/light/point/tetrahedron_light.hpp>
#include <umbrage/light/warp/light_space_perspective.hpp>
#include <umbrage/light/warp/perspective.hpp>
#include <umbrage/light/warp/plane_optimal.hpp>
#include <umbrage/light/warp/trapezoidal.hpp>

namespace viewer {
namespace {

using fit = umbrage::warp_fit<double>;

struct warped {
    umbrage::warped_light<double> map;
    std::string_view seen_as{};  ///< of a light in the camera's perspective; what came of a ground
};

warped tight(const fit& f) {
    return {umbrage::fit_light_space_perspective<double>(f, std::numeric_limits<double>::infinity())};
}
warped light_space(const fit& f) { return {umbrage::fit_light_space_perspective(f)}; }
warped trapezoidal(const fit& f) { return {umbrage::fit_trapezoidal(f, std::sqrt(f.camera.z_near * f.camera.z_far))}; }
warped perspective(const fit& f) {
    constexpr std::array images{"light a source", "light a sink", "light abreast", "light-space in its place"};
    const auto map = umbrage::fit_perspective(f);
    return {map, images[static_cast<std::size_t>(map.seen_as)]};
}
/// Warp of the scene's lowest plane, and of the casters for the part of it on the screen.
warped plane_optimal(const fit& f) {
    const auto ground = umbrage::fit_plane_optimal(f, glm::dvec4(0, 1, 0, -f.casters->low.y));
    return ground ? warped{*ground, "the ground alone"} : warped{tight(f).map, "tight, as no ground is seen"};
}

struct placement {
    std::string_view name;
    warped (*place)(const fit&);
    bool holds_all = true;  ///< that the camera sees
};
constexpr std::array placements{placement{"tight", tight}, placement{"light-space", light_space},
                                placement{"trapezoidal", trapezoidal}, placement{"perspective", perspective},
                                placement{"plane-optimal", plane_optimal, false}};
constexpr std::string_view the_best = "best";

sun_map described(std::string_view name, const warped& w) {
    std::array<char, 80> text{};
    std::snprintf(text.data(), text.size(), "%.*s, strength %.3f", static_cast<int>(name.size()), name.data(),
                  w.map.strength);
    std::string note(text.data());
    if (!w.seen_as.empty()) note.append(", ").append(w.seen_as);
    return {w.map.light, note};
}

}  // namespace

const std::vector<std::string>& placement_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all{std::string(in_cascades)};
        for (const placement& p : placements) all.emplace_back(p.name);
        all.emplace_back(the_best);
        all.emplace_back(in_pages);
        all.insert(all.end(), lamp_placements.begin(), lamp_placements.end());
        return all;
    }();
    return names;
}

bool is_lamp(std::string_view placement) {
    return std::ranges::find(lamp_placements, placement) != lamp_placements.end();
}

bool has_parts(std::string_view placement) {
    return placement == in_cascades || placement == in_pages || is_lamp(placement);
}

sun_map place_map(std::string_view name, const fit& f, std::span<const umbrage::seen_point> seen,
                  const umbrage::choice_terms& terms, std::size_t& kept) {
    if (name != the_best) {
        const auto* const only = std::ranges::find(placements, name, &placement::name);
        return described(name, only->place(f));
    }
    std::vector<warped> all;
    std::vector<umbrage::light_space<double>> lights;
    for (const placement& p : placements) {
        if (!p.holds_all) continue;
        all.push_back(p.place(f));
        lights.push_back(all.back().map.light);
    }
    kept = umbrage::choose_light<double>(lights, seen, terms, kept).kept;
    sun_map best = described(placements[kept].name, all[kept]);
    best.note.insert(0, "best: ");
    return best;
}

lamp_maps place_lamp(std::string_view placement, glm::dvec3 position, double range, int texels, float reach) {
    lamp_maps maps{};
    maps.layers = placement == in_cube ? 6 : placement == in_paraboloids ? 2 : 1;
    maps.size = static_cast<int>(texels / std::sqrt(maps.layers));
    maps.border = std::min(static_cast<int>(std::ceil(reach)) + 1, maps.size / 8);
    constexpr auto clip = umbrage::opengl_clip_space;
    const double z_near = range / 1024;
    const auto take = [&](const auto& faces) { maps.passes.assign(faces.begin(), faces.end()); };
    if (placement == in_cube)
        take(umbrage::make_point_light<double>({position, z_near, range, maps.size, maps.border, clip}));
    else if (placement == in_tetrahedron)
        take(umbrage::make_tetrahedron_light<double>({position, z_near, range, maps.size, maps.border, clip}));
    else
        maps.passes.assign(
            2, umbrage::make_dual_paraboloid_light<double>({position, range, maps.size, maps.border, clip}));
    return maps;
}

}  // namespace viewer
