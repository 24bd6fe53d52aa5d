// SPDX-License-Identifier: MIT
//
// How near the bound of rounding in a place's slack comes to be needed. A search looks for the worst receiver and the
// worst triangle around it: it climbs over lights, places in their maps and planes, and at each of these it takes the
// vertices that round most to one side, and the receiver of that texel that rounds most to the other.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <umbrage/light/directional_fit.hpp>
#include <umbrage/light/spot_light.hpp>
#include <umbrage/light/warp/light_space_perspective.hpp>
#include <umbrage/shadow/cascaded_maps.hpp>
#include <umbrage/shadow/cube_maps.hpp>
#include <umbrage/shadow/shadow.hpp>

using namespace umbrage;
using glm::dmat4, glm::dvec2, glm::dvec3, glm::dvec4, glm::vec3;

namespace {

constexpr int map_side = 512;

/// A light, a place in its map and a plane there: numbers from -1 to 1 that the search changes.
struct candidate {
    std::array<double, 16> x{};
    std::uint32_t seed = 0;

    [[nodiscard]] dvec3 way(std::size_t first) const {
        return glm::normalize(dvec3(x[first], x[first + 1], x[first + 2]) + dvec3(0, 0, 1e-9));
    }
    /// From low to high, by a number's place between its ends.
    [[nodiscard]] double between(std::size_t i, double low, double high) const {
        return low + (high - low) * (0.5 + 0.5 * std::clamp(x[i], -1.0, 1.0));
    }
};

struct tightness {
    double need = 0, bound = 1;  ///< depth in 2^-24; a share of it where depth is reversed
    [[nodiscard]] double share() const { return need / bound; }
};

class search {
public:
    search(bool faces, int points) : faces_(faces), points_(points) {}

    /// Need and bound at the middle of one texel of a light's first map.
    /// @param along   normal of the plane that faces the light
    /// @param depth   of the plane's middle: from 0 to 1 between the near and the far plane of its map
    template <class Shadow>
    [[nodiscard]] tightness at(const Shadow& s, const candidate& c, dvec3 along, double depth) {
        using Setup = std::remove_cvref_t<decltype(s.setup())>;
        random_.seed(c.seed);
        const clip_space clip = s.setup().clip();
        const double sign = clip.direction == depth_direction::forward ? 1 : -1;
        const dmat4 m = texture_matrix(s.setup().lights()[0], s.map_size()), back = glm::inverse(m);
        const dvec2 texel(std::floor(c.between(0, 8, map_side - 8)), std::floor(c.between(1, 8, map_side - 8)));
        const auto in_world = [](dvec4 h) { return dvec3(h) / h.w; };
        const dvec3 middle = in_world(back * dvec4(texel + 0.5, depth, 1));
        dvec3 normal = glm::normalize(along);
        const dvec3 side = glm::normalize(glm::cross(normal, c.way(2))), up = glm::cross(normal, side);
        if (!faces_) normal = glm::normalize(normal + side * c.between(5, -2, 2));
        dmat4 here = m;
        here[3] = here * dvec4(middle, 1);
        const dvec2 slope = plane_slope(plane_matrix(here), normal, dvec3(0));
        const double steep = std::abs(slope.x) + std::abs(slope.y);
        if (!(steep < 0.02)) return {};  // where the light grazes a plane its slope rounds too, which slack has apart
        const double wide = detail::units_at(here, dvec3(0)).x;
        const auto point = [&](double x, double y) {  // of the plane, texels from the middle
            dvec3 p = (side * x + up * y) * wide;
            p -= along * (glm::dot(normal, p) / glm::dot(normal, along));
            return vec3(middle + p);
        };
        const double reach = 1e3 * std::pow(10, c.between(6, -3, -0.8));  // texels to the vertices
        // The triangle: of three sectors, the vertices whose depths round most away from the receivers'.
        const depth_view view = s.depth_views()[0];
        std::array<dvec3, 3> corner{};
        std::array<double, 3> worst{-1e9, -1e9, -1e9};
        for (int i = 0; i < points_; ++i) {
            const auto k = std::size_t(i % 3);
            const double angle = (2 * double(k) + real(0, 1)) * 1.0471975512, r = reach * real(0.3, 1);
            const vec3 p = point(r * std::cos(angle), r * std::sin(angle));
            const dvec4 h(anchored_vertex(view.to_clip, p, view.anchor));
            dvec3 v((h.x / h.w * 0.5 + 0.5) * map_side, (h.y / h.w * 0.5 + 0.5) * map_side, h.z / h.w);
            if (clip.origin == texture_origin::top) v.y = map_side - v.y;
            if (clip.range == depth_range::minus_one_to_one) v.z = v.z * 0.5 + 0.5;
            const double off = -sign * (v.z - depth - glm::dot(slope, dvec2(v) - texel - 0.5));
            if (off > worst[k]) worst[k] = off, corner[k] = v;
        }
        const dvec3 q = glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
        const dvec2 to_middle = texel + 0.5 - dvec2(corner[0]);
        for (std::size_t k = 0; k < 3; ++k) {  // rounding may leave the middle outside
            const dvec2 edge(corner[(k + 1) % 3] - corner[k]), to = texel + 0.5 - dvec2(corner[k]);
            if (!((edge.x * to.y - edge.y * to.x) * q.z > 0)) return {};
        }
        const double stored = float(corner[0].z - (q.x * to_middle.x + q.y * to_middle.y) / q.z);
        tightness found;
        const auto uniforms = s.uniforms();
        const double width = detail::width_in_depth(here, s.map_size());
        for (int i = 0; i < points_; ++i) {
            const double x = real(-0.5, 0.5), y = real(-0.5, 0.5);
            const vec3 world = point(x, y);
            const map_place place = Setup::places(uniforms.maps, uniforms.terms, world, vec3(normal))[0];
            if (place.number != 0 || glm::length(dvec2(place.at) - texel - 0.5) > 1) continue;
            const dvec2 units = detail::units_at(here, dvec3(world) - middle);
            const double own_width = detail::is_lens(here) ? units.x * units.y : width;
            const double bound = place.slack - own_width - detail::texels_beside_plane(clip, s.map_size()) * steep;
            const double apart = place.at.z - stored - glm::dot(slope, dvec2(place.at) - texel - 0.5);
            const double need = sign * apart - 0x1p-21 * map_side * steep, unit = 0x1p-24 * (sign > 0 ? 1 : depth);
            if (need / bound > found.share()) found = {need / unit, bound / unit};
        }
        return found;
    }

private:
    [[nodiscard]] double real(double low, double high) { return low + (high - low) * (double(random_()) * 0x1p-32); }
    bool faces_;
    int points_;
    std::mt19937 random_{1};
};

/// A light of a kind and a plane before it, by a candidate.
/// @param away   from the origin, world units; the light covers some 6
tightness light_at(search& s, const std::string& kind, const clip_space& clip, double away, const candidate& c) {
    const dvec3 center = c.way(7) * away * c.between(15, 0.9, 1.1), axis = c.way(10);
    const double shift = 3 * c.x[13];
    const auto with = [&](const auto& light, dvec3 along, double depth) {
        return s.at(shadow(light, glm::ivec2(map_side), filters::hard{}), c, along, depth);
    };
    const dvec3 lamp = vec3(center + shift);
    const double z_near = 0.05, z_far = 30, t = std::exp(c.between(14, std::log(0.5), std::log(10)));
    if (kind == "spot") {
        const auto light = make_spot_light<double>({lamp, axis, {0.1, 1, 0.2}, 0.6, 1, z_near, z_far, clip});
        return with(light, -axis, (texture_matrix(light, {1, 1}) * dvec4(lamp + axis * t, 1)).z / t);
    }
    if (kind == "cube") {
        const point_light<double> light{lamp, z_near, z_far, map_side, 3, clip};
        const dmat4 m = texture_matrix(make_point_light(light)[0], {1, 1});
        const dvec3 ahead = glm::normalize(detail::row_of(m, 3));
        const dvec4 h = m * dvec4(lamp + ahead * t, 1);
        return with(light, -ahead, h.z / h.w);
    }
    if (kind == "directional")
        return with(
            fit_directional_light<double>(
                {.direction = axis, .receivers = bounding_box<double>{center - 3.0, center + 3.0}, .clip = clip}),
            -axis, c.between(14, 0.02, 0.98));
    cascade_fit<double> fit{
        {center, c.way(3)}, axis, {0.1, 1, 0.2}, {center - 12.0, center + 12.0}, glm::ivec2(map_side)};
    fit.clip = clip;
    const std::array<double, 2> splits{0.1, 4};
    if (kind == "stable cascades") return with(make_stable_cascades<1>(fit, splits), -axis, c.between(14, 0.1, 0.9));
    warp_fit<double> warp{.camera = fit.camera, .direction = axis, .clip = clip};
    warp.camera.z_near = 0.1, warp.camera.z_far = 6;
    warp.receivers = intersection(warp.camera, fit.scene);
    return with(fit_light_space_perspective(warp).light, -axis, c.between(14, 0.02, 0.98));
}

/// The tightest place of a kind's maps that climbs of some steps find.
tightness climb(const std::string& kind, const clip_space& clip, double away, bool faces, int climbs, int steps) {
    std::mt19937 random(7);
    const auto real = [&] { return 2 * double(random()) * 0x1p-32 - 1; };
    tightness best;
    search fine(faces, 64 * steps / 4);
    for (int i = 0; i < climbs; ++i) {
        search s(faces, 64);
        candidate at;
        tightness found;
        for (int step = 0; step < steps; ++step) {
            candidate next = at;
            const double size = std::pow(10, 2 * real() - 2);
            for (double& x : next.x)
                if (step < 8 || random() % 4 == 0) x = step < 8 ? real() : std::clamp(x + size * real(), -1.0, 1.0);
            next.seed = std::uint32_t(random());
            try {
                const tightness here = light_at(s, kind, clip, away, next);
                if (here.share() > found.share()) found = here, at = next;
            } catch (const std::invalid_argument&) {}  // a warp that has no such camera
        }
        const tightness polished = light_at(fine, kind, clip, away, at);
        if (polished.share() > found.share()) found = polished;
        if (found.share() > best.share()) best = found;
    }
    return best;
}

}  // namespace

TEST_CASE("rounding_need: matrices start at the anchor as binary32 holds it") {
    std::mt19937 random(1);
    for (int i = 0; i < 100; ++i) {
        candidate any;
        for (double& x : any.x) x = 2 * double(random()) * 0x1p-32 - 1;
        const dvec3 middle = any.way(0) * 600.0;
        cascade_fit<double> fit{
            {middle, any.way(3)}, any.way(6), {0.1, 1, 0.2}, {middle - 12.0, middle + 12.0}, glm::ivec2(map_side)};
        fit.clip = cpu_clip_space;
        const shadow sun(make_stable_cascades<1>(fit, {0.1, 4}), fit.map_size, filters::hard{});
        const auto start = [](const dmat4& m, const glm::vec4& anchor) {
            return m * dvec4(detail::in_binary32(dvec3(anchor)), 1);
        };
        const light_space<double> light = sun.setup().lights()[0];
        const depth_view view = sun.depth_views()[0];
        CHECK(glm::length(dvec4(view.to_clip[3]) - start(light.projection * light.view, view.anchor)) < 0x1p-22);
        const auto maps = sun.uniforms().maps;
        const dvec3 in_map(start(texture_matrix(light, fit.map_size), maps.anchor)), placed(maps.offsets[0]);
        CHECK(glm::length(dvec2(placed) - dvec2(in_map)) < 0x1p-22 * map_side);
        CHECK(std::abs(placed.z - in_map.z) < 0x1p-22);
    }
}

TEST_CASE("rounding_need: the bound holds at the worst places that a search finds, at most five times their need") {
    for (const char* kind : {"spot", "cube", "directional", "stable cascades", "warp"})
        for (const double away : {0.0, 600.0}) {
            const bool wide = std::string(kind) == "warp" && away == 0;  // there is more to vary
            CAPTURE(std::string(kind));
            CAPTURE(away);
            tightness tightest;
            for (const bool faces : {true, false}) {
                const tightness t = climb(kind, cpu_clip_space, away, faces, wide ? 12 : 6, wide ? 4000 : 2000);
                CHECK(t.share() <= 1);
                if (t.share() > tightest.share()) tightest = t;
            }
            CAPTURE(tightest.need);
            CAPTURE(tightest.bound);
            CHECK(tightest.share() * 5 >= 1);
        }
}
