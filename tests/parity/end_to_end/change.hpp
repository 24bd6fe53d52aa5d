// SPDX-License-Identifier: MIT
//
// Receivers that change their visibility against C++, and the distance from what changes them.
#pragma once

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <string>

#include "../arithmetic/trial.hpp"
#include "from_world.hpp"

namespace parity::arithmetic {

/// Changes of one cause: a coordinate beyond a border of the filter's steps, or a depth beyond a stored one.
struct cause {
    std::uint64_t changed = 0;
    double largest = 0.0;   ///< change, in steps of the filter
    double farthest = 0.0;  ///< from the border in texels, or from the stored depth
    double share = 0.0;     ///< largest, of a changed receiver's bound that its distance is
    double allowed = 0.0;   ///< largest bound of a receiver, changed or not

    void add(const cause& o) {
        changed += o.changed;
        for (auto member : {&cause::largest, &cause::farthest, &cause::share, &cause::allowed})
            this->*member = std::max(this->*member, o.*member);
    }
};

struct changes {
    std::uint64_t receivers = 0, told = 0, told_changed = 0;
    std::uint64_t outside = 0;  ///< changed, and farther than its bound from the border or depth
    cause border{}, tie{};
    std::string example{};

    [[nodiscard]] std::uint64_t changed() const { return border.changed + tie.changed; }

    /// One receiver's result, which holds visibility, coordinate and receiver.
    /// @param is_told  rays decide what it has to be
    /// @param share   of the bound; 0: nothing is promised, and distances are C++'s
    void add(const call& got, const vec4& twin, const filter_steps& filter, const texels& map, bool is_told,
             double share) {
        ++receivers, told += is_told;
        const knowledge& depth = got.results[3];
        for (const int c : {1, 2}) border.allowed = std::max(border.allowed, got.results[std::size_t(c)].bound());
        tie.allowed = std::max(tie.allowed, depth.bound());
        if (got.value(0) == twin[0]) return;
        told_changed += is_told;
        const bool promised = share > 0.0;
        const gap from_depth{distance_to_depth(got, filter, map, promised ? depth.real : double(twin[3])),
                             depth.bound()};
        const gap crossed = to_border(got, twin, filter.steps, promised, true);
        // A coordinate may be evaluated once more for the filter: the one that is returned need not have crossed.
        const bool at_border = crossed.bound > 0.0 || (promised && from_depth.distance > from_depth.bound);
        const gap from = !at_border            ? from_depth
                         : crossed.bound > 0.0 ? crossed
                                               : to_border(got, twin, filter.steps, promised, false);
        cause& why = at_border ? border : tie;
        ++why.changed;
        why.farthest = std::max(why.farthest, from.distance);
        why.share = std::max(why.share, from.share());
        why.largest = std::max(why.largest, std::abs(double(got.value(0)) - double(twin[0])) * filter.steps);
        if (!promised || from.share() <= share || outside++ > 0) return;
        std::ostringstream text;
        text << "  " << filter.name << ", " << (at_border ? "border" : "depth") << ' ' << from.distance
             << " away, bound " << from.bound * share << ", at (" << std::setprecision(9) << twin[1] << ", " << twin[2]
             << "), receiver " << twin[3] << ": visibility " << got.value(0) << ", C++ " << twin[0] << '\n';
        example = text.str();
    }
    void add(const changes& o) {
        for (auto member : {&changes::receivers, &changes::told, &changes::told_changed, &changes::outside})
            this->*member += o.*member;
        border.add(o.border), tie.add(o.tie);
        if (example.empty()) example = o.example;
    }

private:
    struct gap {
        double distance = 0.0, bound = 0.0;
        [[nodiscard]] double share() const { return distance / bound; }
    };
    /// From a coordinate to the nearest border of a step: in the direction with the greatest share of those that
    /// crossed one, or with the least share of both.
    [[nodiscard]] static gap to_border(const call& got, const vec4& twin, int steps, bool promised, bool crossed) {
        gap found{};
        for (const int c : {1, 2}) {
            const knowledge& k = got.results[std::size_t(c)];
            const auto step = [&](double at) { return std::floor(at * steps); };
            if (crossed && step(double(k.value)) == step(double(twin[c]))) continue;
            const double at = (promised ? k.real : double(twin[c])) * steps;
            const gap one{std::abs(at - std::round(at)) / steps, k.bound()};
            if (found.bound == 0.0 || (one.share() > found.share()) == crossed) found = one;
        }
        return found;
    }
    /// From a receiver to the nearest depth that it is compared with; the far plane is one.
    [[nodiscard]] static double distance_to_depth(const call& got, const filter_steps& filter, const texels& map,
                                                  double receiver) {
        double nearest = std::abs(receiver - 1.0);
        const auto texel = [&](int c, double by) {  // clamped to the map, as fetches are
            const knowledge& k = got.results[std::size_t(c)];
            const double at = k.real + std::copysign(double(filter.reach) - 0.5 + k.bound(), by);
            return int(std::clamp(std::floor(at), 0.0, double(map.size()[c - 1] - 1)));
        };
        for (int y = texel(2, -1.0); y <= texel(2, 1.0); ++y)
            for (int x = texel(1, -1.0); x <= texel(1, 1.0); ++x)
                nearest = std::min(nearest, std::abs(receiver - double(map[{x, y}].x)));
        return nearest;
    }
};

inline void write_head(const char* what, std::ostream& out) {
    const auto of_cause = [&](const char* why, const char* in) {
        out << " | changed at a " << why << " | largest change, steps | farthest, " << in
            << " | worst share of the bound | largest bound, " << in;
    };
    out << "| " << what << " | receivers | changed | where rays decide | of which changed";
    of_cause("border", "texels");
    of_cause("stored depth", "depth");
    out << " |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";
}

/// @param promised   that changed receivers lie within their bounds
inline void write_row(const std::string& name, const changes& c, bool promised, std::ostream& out) {
    out << "| " << name << " | " << c.receivers << " | " << c.changed() << " | " << c.told << " | " << c.told_changed;
    for (const cause& why : {c.border, c.tie}) {
        out << std::setprecision(2) << " | " << why.changed << " | " << why.largest << " | " << why.farthest;
        if (promised) out << " | " << why.share << " | " << why.allowed;
        else out << " | not promised | ";
    }
    out << " |\n";
}

}  // namespace parity::arithmetic
