// SPDX-License-Identifier: MIT
//
// Planes in a map against receivers on them: with acne_free_bias, and acne_free_disc_bias under discs in every turn,
// none is dark, with 9/10 of it some are. A sample in the tests, all of it in `make prove`.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <random>
#include <string_view>
#include <vector>

#include <umbrage/bias/acne_free.hpp>
#include <umbrage/depth/encodings.hpp>
#include <umbrage/filter/filters.hpp>
#include <umbrage/images/visibility.hpp>

namespace proof {

/// Tilted against the light by up to 89 degrees, turned every way, before maps whose depth spans 2^11 to 2^17 texels.
inline constexpr double tilts[]{0, 1, 5, 15, 30, 45, 60, 75, 80, 85, 87, 88, 89};
inline constexpr std::uint64_t plane_count = std::size(tilts) * 3 * 4;

/// Change of the n-th plane's depth from one texel to the next.
[[nodiscard]] inline glm::vec2 nth_slope(std::uint64_t n) {
    constexpr double degree = std::numbers::pi / 180;
    const double tilt = std::tan(tilts[n % std::size(tilts)] * degree);
    const double texels = std::exp2(11.0 + 3.0 * double(n / std::size(tilts) % 3));
    const double turn = 90.0 * double(n / std::size(tilts) / 3) + (n % 2 ? 0.0 : 17.0);
    return glm::vec2(glm::dvec2(std::cos(turn * degree), std::sin(turn * degree)) * (tilt / texels));
}

/// A filter, whichever: what looks for acne is compiled once for all of them.
struct any_filter {
    std::string_view name;
    float reach;
    bool turned;  ///< by the pixel, otherwise in each place among 4 x 4
    umbrage::depth_direction direction;
    std::function<void(const umbrage::image<float>&, const umbrage::image<glm::vec3>&, umbrage::image<float>&)>
        visibility;

    template <class Filter>
    any_filter(const Filter& filter, umbrage::depth_direction toward)
        : name(filter.name),
          reach(filter.reach()),
          turned(requires { filter.points; }),
          direction(toward),
          visibility([=](auto& map, auto& seen, auto& lit) {
              umbrage::visibility(map, umbrage::depth32f{toward}, seen, filter, lit);
          }) {}
};

/// An encoding, whichever.
struct any_encoding {
    std::string_view name;
    std::function<float(float)> stored;  ///< what it makes of a depth

    template <class Encoding>
    explicit any_encoding(const Encoding& encoding)
        : name(encoding.name), stored([=](float d) { return encoding.decode(encoding.encode(d)); }) {}
};

/// A plane's map, and a receiver on it at every fraction k / 256 of a texel, in both directions.
struct plane {
    umbrage::image<float> depth;
    umbrage::image<glm::vec3> receivers{{256, 256}};

    /// @param reach  texels around each receiver that are the map's
    /// @param from   pixel of the receiver on the corner of a texel: where a filter turns, another turn from each
    plane(glm::vec2 slope, float reach, glm::ivec2 from, std::mt19937& random) : depth({1, 1}) {
        const auto margin = static_cast<int>(std::ceil(reach)) + 1;
        const double steep = std::abs(double(slope.x)) + std::abs(double(slope.y));
        const int side = 2 * margin + std::clamp(static_cast<int>(0.9 / std::max(steep, 1e-9)) - 2 * margin, 1, 32);
        const double extent = steep * side;
        const double low = std::uniform_real_distribution(0.0, 1.0 - std::min(extent, 1.0))(random);
        const double corner = low + side * (std::max(-double(slope.x), 0.0) + std::max(-double(slope.y), 0.0));
        const auto at = [&](glm::dvec2 p) {
            return static_cast<float>(corner + double(slope.x) * p.x + double(slope.y) * p.y);
        };
        depth = umbrage::image<float>(glm::ivec2(side));
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) depth[{x, y}] = at(glm::dvec2(x, y) + 0.5);
        std::uniform_int_distribution texel(margin, side - margin - 1);
        for (int y = 0; y < 256; ++y)
            for (int x = 0; x < 256; ++x) {
                const glm::dvec2 p = glm::dvec2(texel(random), texel(random)) + glm::dvec2(x, y) / 256.0;
                receivers[(glm::ivec2(x, y) + from) % 256] = {p.x, p.y, at(p)};
            }
    }

    /// Number of receivers that any texel darkens.
    [[nodiscard]] int dark(const any_filter& filter, const any_encoding& encoding, float bias) const {
        umbrage::image<float> map(depth.size()), lit(receivers.size());
        std::ranges::transform(depth.texels(), map.texels().begin(), encoding.stored);
        umbrage::image<glm::vec3> seen = receivers;
        for (glm::vec3& r : seen.texels()) r.z = umbrage::biased(r.z, bias, filter.direction);
        filter.visibility(map, seen, lit);
        return static_cast<int>(std::ranges::count_if(lit.texels(), [](float v) { return v < 1.0f; }));
    }
};

/// The n-th plane, moved to and fro in depth.
class moved_plane {
public:
    moved_plane(std::uint64_t n, float reach)
        : slope(nth_slope(n)), reach_(reach), random_(static_cast<std::uint32_t>(n)) {}

    const glm::vec2 slope;

    [[nodiscard]] const plane& operator[](std::size_t move) {
        for (auto made = static_cast<int>(made_.size()); made_.size() <= move; ++made)
            made_.emplace_back(slope, reach_, glm::ivec2(made % 4, made / 4 % 4), random_);
        return made_[move];
    }

private:
    float reach_;
    std::mt19937 random_;
    std::vector<plane> made_;
};

struct acne {
    std::uint64_t dark = 0;  ///< receivers under the whole bias
    bool owed = false;       ///< 9/10 of the bias is to leave one dark
    bool loose = false;      ///< and does not
};

/// Looks at moves of a plane until 9/10 of the bias is too little, and until a filter that turns has had every turn at
/// every fraction of a texel. Of a plane that faces the light all receivers have one error of the encoding, and few
/// moves have nearly the greatest.
[[nodiscard]] inline acne look_for_acne(const any_filter& filter, const any_encoding& encoding, float bias,
                                        moved_plane& moved) {
    acne seen{.owed = bias - 0x1p-23f > 0x1p-16f};
    bool tight = false;
    const std::size_t turns = filter.turned ? 16 : 1;
    for (std::size_t move = 0; move < turns || (seen.owed && !tight && move < 512); ++move) {
        seen.dark += static_cast<std::uint64_t>(moved[move].dark(filter, encoding, bias));
        tight = tight || (seen.owed && moved[move].dark(filter, encoding, bias * 0.9f) > 0);
    }
    seen.loose = seen.owed && !tight;
    return seen;
}

/// Calls use(encoding) for every encoding there is, with every edge that its decoder can answer for.
template <class Use>
void for_each_decoder(umbrage::depth_direction direction, Use&& use) {
    umbrage::for_each_encoding([&](auto encoding) {
        encoding.direction = direction;
        if constexpr (umbrage::has_edge<decltype(encoding)>)
            for (float edge : {umbrage::lower_edge<float>, umbrage::center<float>, umbrage::upper_edge<float>}) {
                encoding.edge = edge;
                use(encoding);
            }
        else use(encoding);
    });
}

/// Radii of discs, in texels.
inline constexpr float disc_radii[]{0.5f, 2.0f, 12.0f};

/// Calls use(filter) for every filter there is, in every size that it is made for, of discs in some, and in either
/// direction that it takes.
template <class Use>
void for_each_percentage_closer(Use&& use) {
    umbrage::for_each_filter([&]<class Filter>(Filter filter) {
        for (auto direction : {umbrage::depth_direction::forward, umbrage::depth_direction::reversed}) {
            if constexpr (requires { filter.direction = direction; }) filter.direction = direction;
            else if (direction == umbrage::depth_direction::reversed) continue;
            if constexpr (std::is_same_v<Filter, umbrage::filters::box>)
                for (int radius = 0; radius <= umbrage::max_box_radius; ++radius) {
                    filter.radius = radius;
                    use(filter, direction);
                }
            else if constexpr (std::is_same_v<Filter, umbrage::filters::disc>)
                for (float radius : disc_radii) {
                    filter.radius_texels = radius;
                    use(filter, direction);
                }
            else use(filter, direction);
        }
    });
}

}  // namespace proof
