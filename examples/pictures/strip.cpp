// SPDX-License-Identifier: MIT
#include "pages.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <glm/common.hpp>

#include <umbrage/core/unorm.hpp>
#include <umbrage/filter/blocker/penumbra.hpp>
#include <umbrage/filter/filters.hpp>

#include <filters.hpp>
#include <names.hpp>
#include <progress.hpp>
#include <scene.hpp>
#include <soft.hpp>
#include <text.hpp>

#include <area_light.hpp>
#include <filter.hpp>
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

/// A place of the scene, square or half as high.
struct place {
    glm::vec3 target;
    float fov;
    bool square = true;
};
constexpr place ball{{1.82f, 0.74f, -1.6f}, 10.5f}, fence{{-0.75f, 0, -0.35f}, 6.5f, false},
    mast{{1.36f, 0.62f, -0.95f}, 15.5f};

constexpr float widest = 8;  ///< radius of penumbras that contact hardening makes, texels: more than these have

/// Texels that a filter reads for one receiver in a penumbra; of a map that is filtered ahead the four of one sample.
int reads(const std::string& filter) {
    int count = 0;
    const auto fetch = [&](glm::ivec2 texel) { return ++count, (texel.x + texel.y) % 2 == 0 ? 0.25f : 1.0f; };
    const auto read = [&](const auto& by) { std::ignore = by(fetch, glm::vec2(100.3f), 0.5f); };
    if (example::filters_ahead(filter)) return 4;
    if (!example::hardens(filter)) return example::with_filter(filter, {}, read), count;
    umbrage::filters::soft::with(filter, [&](auto by) {
        by.softness.max_radius = 16 * widest;
        read(by);
    });
    return count;
}

/// Places of the scene, by rays.
class parts {
public:
    parts(int side, const std::vector<place>& places) : scene_(example::default_scene()) {
        for (const place& p : places) {
            options o;
            o.quiet = true;
            o.samples = 3;
            o.map_size = 1024;
            o.max_radius = widest;
            o.width = side, o.height = p.square ? side : side / 2;
            o.target = p.target, o.fov = p.fov;
            looks_.push_back({o, make_view(o, scene_, progress_), {}});
        }
        for (look& l : looks_) l.expected = traced(l.o, l.v, progress_);
    }

    /// Pictures and errors under a filter and a bias.
    struct result {
        std::vector<picture> shaded{}, errors{};
        double rms = 0;  ///< error of visibility, by which the best bias is chosen
    };
    [[nodiscard]] result under(const std::string& filter, const std::string& bias) {
        return judge([&](look& l) {
            options o = l.o;
            o.filter = filter;
            o.bias = bias;
            return visibility_of(o, l.v, l.v.camera, progress_);
        });
    }
    /// The lines of a filter under the bias that suits it best.
    struct judged {
        result best{};
        std::vector<std::string> lines{};
    };
    [[nodiscard]] judged best_of(const std::string& filter) {
        judged out{.best{.rms = std::numeric_limits<double>::infinity()}};
        std::string named;
        for (const std::string& bias : example::bias_names())
            if (result r = under(filter, bias); r.rms < out.best.rms) out.best = std::move(r), named = bias;
        options o = looks_.front().o;
        o.filter = filter;
        out.lines = {filter, text("%d B, %d read%s", bytes_read(o), reads(filter), reads(filter) == 1 ? "" : "s"),
                     named};
        return out;
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
        out.rms = std::sqrt(sum / count);
        return out;
    }

    example::scene scene_;
    example::progress progress_{100, true};
    std::vector<look> looks_;
};

/// Cells in rows, each of a result with lines of text.
class strip {
public:
    /// @param height   of a cell's pictures and errors, in sides
    strip(int side, int columns, int cells, int lines, int height)
        : columns_(columns),
          cell_(side + gap, height * side + 3 * gap + lines * canvas::line),
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

    int columns_, next_ = 0;
    glm::ivec2 cell_;
    canvas page_;
};

}  // namespace

picture filter_strip(int side) {
    parts of(side, {ball, fence});
    strip out(side, 5, 10, 3, 3);
    out.add(of.by_rays_alone(), {"rays", "the reference", ""});
    for (const std::string filter : {"hard", "pcf_2x2", "castano7", "disc16", "pcss16", "vsm", "evsm4", "msm"}) {
        const auto [best, lines] = of.best_of(filter);
        out.add(best, lines);
    }
    out.explain({"Above each:", "bytes per texel,", "texels read per", "receiver, and the", "bias with the",
                 "smallest error.", "", "Purple: the error", "against rays to a", "disc 0.4 wide,", "8 away.", "",
                 "The map has", "1024 x 1024 texels,", "93 per unit.", "", "pcss16 widens to", "at most 8 texels."});
    return out.pixels();
}

picture hardening_strip(int side) {
    parts of(side, {mast});
    strip out(side, 5, 5, 3, 2);
    for (const std::string filter : {"hard", "castano7", "pcss16", "dpcf16"}) {
        const auto [best, lines] = of.best_of(filter);
        out.add(best, lines);
    }
    out.add(of.by_rays_alone(), {"rays", "the reference", ""});
    return out.pixels();
}

picture bias_strip(int side) {
    parts of(side, {ball, fence});
    strip out(side, 3, 6, 1, 3);
    for (const std::string& bias : example::bias_names()) out.add(of.under("castano7", bias), {bias});
    return out.pixels();
}

}  // namespace pictures
