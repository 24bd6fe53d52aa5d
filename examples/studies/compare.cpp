// SPDX-License-Identifier: MIT
#include "compare.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <biases.hpp>
#include <names.hpp>
#include <png.hpp>
#include <processor.hpp>

#include "area_light.hpp"
#include "filter.hpp"
#include "receivers.hpp"
#include "render.hpp"
#include "shade.hpp"
#include "sheet.hpp"

namespace shadow_render {
namespace {

/// What snippets cost on RDNA2, from the table that `tests/bench/shaders/run` writes; empty without one.
std::map<std::string, std::string> costs(const std::filesystem::path& shaders) {
    const std::filesystem::path made = "build/bench-shaders/shaders.tsv";
    if (shaders.empty() && !std::filesystem::exists(made)) return {};
    const std::filesystem::path& table = shaders.empty() ? made : shaders;
    std::map<std::string, std::string> all;
    std::ifstream file(table);
    for (std::string line; std::getline(file, line);) {
        std::istringstream columns(line);
        std::array<std::string, 5> of;  // job, whose, snippet, instructions, inverse throughput
        for (std::string& column : of) std::getline(columns, column, '\t');
        if (of[1] == "umbrage" && columns) all[of[2]] = of[3] + " instructions, " + of[4] + " cycles";
    }
    if (all.empty()) throw std::runtime_error(table.string() + ": not a table of tests/bench/shaders/run");
    return all;
}

/// Center of the part that has the most half-shadow.
glm::ivec2 softest(const by_rays& expected, int samples) {
    const glm::ivec2 size = expected.visibility.size() / samples, part = sheet::part(size);
    float most = -1;
    glm::ivec2 best(0);
    const glm::ivec2 step = glm::max(part / 4, 1);
    for (glm::ivec2 p{0}; p.y + part.y <= size.y; p.y += step.y)
        for (p.x = 0; p.x + part.x <= size.x; p.x += step.x) {
            float soft = 0;
            for (int y = 0; y < part.y; ++y)
                for (int x = 0; x < part.x; ++x) {
                    const glm::ivec2 at = (p + glm::ivec2(x, y)) * samples;
                    soft += expected.counted[at] * expected.visibility[at] * (1 - expected.visibility[at]);
                }
            if (soft > most) most = soft, best = p + part / 2;
        }
    return best;
}

/// Milliseconds of the fastest of five runs, of the processor's time: other programs do not count.
template <class Work>
double best_of_5(Work&& work) {
    double best = INFINITY;
    for (int i = 0; i < 5; ++i) {
        const std::clock_t start = std::clock();
        work();
        best = std::min(best, 1000.0 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    }
    return best;
}

}  // namespace

void compare(const options& o, const example::scene& scene, const std::filesystem::path& shaders) {
    example::progress progress(5 + filter_names().size(), o.quiet);
    const view v = make_view(o, scene, progress);
    const example::shadow_map map = draw_map(o, v, progress);
    const auto cost = costs(shaders);
    const auto& names = filter_names();
    const by_rays expected = progress.stage("rays", [&] { return traced(o, v, progress); });
    const std::vector<std::string> title{
        text("%s: every filter over one map of %d x %d texels, %s, each with the bias that it names",
             title_of(o).c_str(), o.map_size, o.map_size, o.encoding.c_str()),
        text(
            "Visibility against rays to a disc of light %g across, %g away: RMS error, and leak, its mean where no ray "
            "arrives",
            double(o.light_size), double(o.distance)),
        text("Boxes, discs and blurs of radius %g, penumbras of up to %g texels", double(o.radius),
             double(o.max_radius)),
        text("ms: to filter the map, and %d x %d pixels of %d x %d samples, one thread of %s", o.width, o.height,
             o.samples, o.samples, example::processor().c_str())};
    sheet page({o.width, o.height}, static_cast<int>(names.size()) + 1, title, softest(expected, o.samples));
    const auto add = [&](const umbrage::image<float>& visibility, const std::vector<std::string>& about) {
        page.add(shade(v, visibility, o.samples, progress.bands()), about);
    };
    add(expected.visibility, {"rays to the light", text("%d a sample", rays_a_sample)});

    if (!o.quiet) {
        for (const std::string& line : title) std::printf("%s\n", line.c_str());
        std::printf("\n%-20s %10s %10s %9s %9s %6s  %-14s  %s\n", "filter", "RMS error", "leak", "map ms", "ms",
                    "bytes", "bias", "RDNA2");
    }
    for (const std::string& name : names)
        progress.stage(name, [&] {
            options with = o;
            with.filter = name;
            const std::string snippet(example::snippet_of(name));
            const receivers receivers =
                receivers_of(v, with, reach_of(with), map.below, progress, compares_projected(with));
            look_up filter;
            umbrage::image<float> visibility;
            const double map_ms = best_of_5([&] { filter = prepare(with, map.depth, v.lamp, progress); });
            const double ms = best_of_5([&] { visibility = filter(receivers); });
            const double error = rms_error(expected, visibility, o.samples), leaks = leak(expected, visibility);
            const int bytes = bytes_read(with);
            const std::string bias(bias_of(with));
            const std::string on_gpu = cost.contains(snippet) ? cost.at(snippet) : "-";
            add(visibility, {text("%s: RMS error %.2f %%, leak %.2f %%", name.c_str(), error, leaks),
                             text("%.2f + %.2f ms, %d bytes a texel, bias %s", map_ms, ms, bytes, bias.c_str()),
                             on_gpu == "-" ? "" : "RDNA2 " + on_gpu});
            if (!o.quiet)
                std::printf("%-20s %8.2f %% %8.2f %% %9.2f %9.2f %6d  %-14s  %s\n", name.c_str(), error, leaks, map_ms,
                            ms, bytes, bias.c_str(), on_gpu.c_str());
        });
    progress.stage("write", [&] { example::write_png(o.output / "filters.png", page.pixels().view()); });
}

}  // namespace shadow_render
