// SPDX-License-Identifier: MIT
#include "placement.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#include <umbrage/light/warp/light_space_perspective.hpp>
#include <umbrage/light/warp/perspective.hpp>
#include <umbrage/light/warp/trapezoidal.hpp>

namespace viewer {
namespace {

using fit = umbrage::warp_fit<double>;

struct warped {
    umbrage::warped_light<double> map;
    std::string_view seen_as{};  ///< of a light in the camera's perspective
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

struct placement {
    std::string_view name;
    warped (*place)(const fit&);
};
constexpr std::array placements{placement{"tight", tight}, placement{"light-space", light_space},
                                placement{"trapezoidal", trapezoidal}, placement{"perspective", perspective}};
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
        return all;
    }();
    return names;
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
        all.push_back(p.place(f));
        lights.push_back(all.back().map.light);
    }
    kept = umbrage::choose_light<double>(lights, seen, terms, kept).kept;
    sun_map best = described(placements[kept].name, all[kept]);
    best.note.insert(0, "best: ");
    return best;
}

}  // namespace viewer
