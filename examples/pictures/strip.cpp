// SPDX-License-Identifier: MIT
#include "pages.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/common.hpp>

#include <umbrage/core/unorm.hpp>

#include <names.hpp>
#include <progress.hpp>
#include <scene.hpp>
#include <text.hpp>

#include <area_light.hpp>
#include <options.hpp>
#include <render.hpp>
#include <shade.hpp>

namespace pictures {
namespace {

using example::text, shadow_render::by_rays, shadow_render::options;

constexpr int gap = 8;

/// Error against rays in one hue, on white.
picture error_of(const by_rays& expected, const umbrage::image<float>& visibility, int samples) {
    constexpr glm::vec3 none{1, 1, 1}, hue{0.62f, 0.05f, 0.30f};
    picture out(visibility.size() / samples);
    for (glm::ivec2 p{0}; p.y < out.size().y; ++p.y)
        for (p.x = 0; p.x < out.size().x; ++p.x) {
            const float off = std::abs(shadow_render::mean<float>(p.x, samples, [&](int x, int row) {
                const glm::ivec2 at(x, p.y * samples + row);
                return static_cast<float>(expected.counted[at]) * (visibility[at] - expected.visibility[at]);
            }));
            out[p] = umbrage::store_unorm(glm::mix(none, hue, std::min(1.5f * off, 1.0f)));
        }
    return out;
}

/// Two places of the scene, by rays: the ball's shadow above the steps, and the fence's shadow.
class parts {
public:
    explicit parts(int side) : scene_(example::default_scene()) {
        options o;
        o.quiet = true;
        o.samples = 3;
        o.map_size = 1024;
        o.width = o.height = side;
        o.target = {1.82f, 0.74f, -1.6f};
        o.fov = 10.5f;
        looks_.push_back({o, make_view(o, scene_, progress_), {}});
        o.height = side / 2;
        o.target = {-0.75f, 0, -0.35f};
        o.fov = 6.5f;
        looks_.push_back({o, make_view(o, scene_, progress_), {}});
        for (look& l : looks_) l.expected = traced(l.o, l.v, progress_);
    }

    /// Pictures and errors under a filter and a bias.
    struct result {
        std::vector<picture> shaded{}, errors{};
        double rms = 0;  ///< per cent
    };
    [[nodiscard]] result under(const std::string& filter, const std::string& bias) {
        return judge([&](look& l) {
            options o = l.o;
            o.filter = filter;
            o.bias = bias;
            return visibility_of(o, l.v, l.v.camera, progress_);
        });
    }
    [[nodiscard]] result by_rays_alone() {
        return judge([](look& l) { return l.expected.visibility; });
    }

private:
    struct look {
        options o;
        shadow_render::view v;
        by_rays expected;
    };

    template <class Visibility>
    result judge(const Visibility& visibility_of_look) {
        result out;
        double sum = 0, count = 0;
        for (look& l : looks_) {
            const umbrage::image<float> visibility = visibility_of_look(l);
            const auto [squares, pixels] = squared_error(l.expected, visibility, l.o.samples);
            sum += squares, count += pixels;
            out.shaded.push_back(shade(l.v, visibility, l.o.samples, progress_.bands()));
            out.errors.push_back(error_of(l.expected, visibility, l.o.samples));
        }
        out.rms = 100 * std::sqrt(sum / count);
        return out;
    }

    example::scene scene_;
    example::progress progress_{100, true};
    std::vector<look> looks_;
};

/// Cells in rows, each of a result with three lines of text.
class strip {
public:
    strip(int side, int columns, int cells)
        : side_(side),
          columns_(columns),
          cell_(side + gap, 3 * side + 3 * gap + 3 * canvas::line),
          page_({columns * cell_.x + gap, (cells + columns - 1) / columns * cell_.y + gap}) {}

    void add(const parts::result& r, const std::vector<std::string>& lines) {
        glm::ivec2 at = next();
        for (const std::string& line : lines) {
            page_.write(line, at, &line == &lines.front() ? ink : pale_ink);
            at.y += canvas::line;
        }
        for (const auto* pictures : {&r.shaded, &r.errors})
            for (const picture& p : *pictures) page_.paste(p, at), at.y += p.size().y + gap / 2;
    }

    void explain(const std::vector<std::string>& lines) {
        glm::ivec2 at = next();
        for (const std::string& line : lines) page_.write(line, at, pale_ink), at.y += canvas::line;
    }

    [[nodiscard]] const picture& pixels() const { return page_.pixels(); }

private:
    glm::ivec2 next() {
        const glm::ivec2 at = glm::ivec2(next_ % columns_, next_ / columns_) * cell_ + gap;
        ++next_;
        return at;
    }

    int side_, columns_, next_ = 0;
    glm::ivec2 cell_;
    canvas page_;
};

}  // namespace

picture filter_strip(int side) {
    parts of(side);
    strip out(side, 5, 10);
    out.add(of.by_rays_alone(), {"rays", "the reference", ""});
    for (const std::string filter : {"hard", "pcf_2x2", "castano7", "disc16", "pcss16", "vsm", "evsm4", "msm"}) {
        parts::result best{.rms = std::numeric_limits<double>::infinity()};
        std::string named;
        for (const std::string& bias : example::bias_names()) {
            parts::result r = of.under(filter, bias);
            if (r.rms < best.rms) best = std::move(r), named = bias;
        }
        out.add(best, {filter, text("RMS %.1f %%", best.rms), named});
    }
    out.explain({"map: 1024", "texels, 93", "per unit", "", "light: a disc", "0.4 wide,", "8 away", "", "RMS error",
                 "over both", "crops, with", "the best of", "six biases", "", "purple: error", "against rays"});
    return out.pixels();
}

picture bias_strip(int side) {
    parts of(side);
    strip out(side, 3, 6);
    for (const std::string& bias : example::bias_names()) {
        const parts::result r = of.under("castano7", bias);
        out.add(r, {bias, text("RMS %.1f %%", r.rms), "castano7"});
    }
    return out.pixels();
}

}  // namespace pictures
