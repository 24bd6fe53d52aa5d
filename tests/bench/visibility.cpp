// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <umbrage/images/visibility.hpp>

#include "../forced_form.hpp"
#include "bench.hpp"
#include "data.hpp"
#include "solids.hpp"
#include "peers/glm.hpp"
#include "window_loads.hpp"
#ifdef UMBRAGE_BENCH_LLVMPIPE
#include "peers/llvmpipe.hpp"
#endif

namespace {

using umbrage::image;
using umbrage::filters::box;
using umbrage::filters::pcf_2x2;

struct state {
    image<float> map = bench::make_map(), decoded{bench::map_size}, ours{bench::screen}, other{bench::screen};
    image<glm::u8vec2> packed{bench::map_size};
    image<glm::vec3> coherent = bench::make_receivers(bench::order::coherent),
                     random = bench::make_receivers(bench::order::random);
    peers::glm_code::float_map glm_map{{map.texels().begin(), map.texels().end()}, bench::map_size};
    std::vector<glm::vec3> glm_receivers{coherent.texels().begin(), coherent.texels().end()};
    std::vector<float> theirs = std::vector<float>(glm_receivers.size());

    /// Weights are in steps of 1/256 here and in floats there.
    [[nodiscard]] bool close(double mean) const {
        double sum = 0;
        for (std::size_t i = 0; i < theirs.size(); ++i) sum += std::abs(double(ours.texels()[i]) - double(theirs[i]));
        return sum / bench::pixels < mean;
    }
};

const bench::registration rows([] {
    const auto s = std::make_shared<state>();
    umbrage::encode(s->map, s->packed, umbrage::rg<11>{.edge = umbrage::lower_edge<float>});
    const umbrage::rg<11> rg{.edge = umbrage::lower_edge<float>};
    const umbrage::depth32f f32;
    const auto on_floats = [=](const image<glm::vec3>& receivers, auto filter) {
        return [=, &receivers] {
            umbrage::visibility(s->map, f32, receivers, filter, s->ours, umbrage::serial{},
                                umbrage::outside_map::clamped);
        };
    };
    const auto on_packed = [=](const image<glm::vec3>& receivers, auto filter) {
        return [=, &receivers] {
            umbrage::visibility(s->packed, rg, receivers, filter, s->ours, umbrage::serial{},
                                umbrage::outside_map::clamped);
        };
    };
    const auto glm_2x2 = [s] { peers::glm_code::pcf_2x2(s->glm_map, s->glm_receivers, s->theirs); };
    const auto glm_5x5 = [s] { peers::glm_code::pcf_5x5(s->glm_map, s->glm_receivers, s->theirs); };
    const auto close = [s] { return s->close(1e-3); };

    bench::add({.work = "PCF 2x2, float map, coherent 1920 x 1080",
                .peer = "GLM code",
                .at_least = 10,
                .items = bench::pixels,
                .ours = on_floats(s->coherent, pcf_2x2{}),
                .theirs = glm_2x2,
                .agree = close});
    bench::add({.work = "PCF 2x2, 11-bit map, coherent 1920 x 1080",
                .peer = "GLM code, float map",
                .at_least = 13,
                .items = bench::pixels,
                .ours = on_packed(s->coherent, pcf_2x2{}),
                .theirs = glm_2x2,
                .agree = close});
    bench::add({.work = "PCF 5x5, float map, coherent 1920 x 1080",
                .peer = "GLM code",
                .at_least = 18,
                .items = bench::pixels,
                .ours = on_floats(s->coherent, box{2}),
                .theirs = glm_5x5,
                .agree = [s] { return s->close(1e-7); }});
    struct window_peer {
        const char* size;
        umbrage::filters::window filter;
        decltype(&peers::glm_code::window_3x3) with_glm;
    };
    const window_peer windows[]{{"3x3", umbrage::filters::tent<3>, &peers::glm_code::window_3x3},
                                {"5x5", umbrage::filters::castano<5>, &peers::glm_code::window_5x5},
                                {"7x7", umbrage::filters::castano<7>, &peers::glm_code::window_7x7}};
    for (const auto& [size, filter, with_glm] : windows) {
        const auto theirs = [s, with_glm] { with_glm(s->glm_map, s->glm_receivers, s->theirs); };
        bench::add({.work = std::string("window ") + size + ", float map, coherent 1920 x 1080",
                    .peer = "GLM code",
                    .at_least = 10,
                    .items = bench::pixels,
                    .ours = on_floats(s->coherent, filter),
                    .theirs = theirs,
                    .agree = close});
        bench::add({.work = std::string("window ") + size + ", 11-bit map, coherent 1920 x 1080",
                    .peer = "GLM code, float map",
                    .at_least = 10,
                    .items = bench::pixels,
                    .ours = on_packed(s->coherent, filter),
                    .theirs = theirs,
                    .agree = close});
        const auto loads = [s, row = filter.row](const image<float>& map) {
            bench::load_windows(map, s->coherent, row, s->other);
        };
        bench::add({.work = std::string("window ") + size + ", float map, coherent 1920 x 1080",
                    .peer = "its loads alone",
                    .items = bench::pixels,
                    .ours = on_floats(s->coherent, filter),
                    .theirs = [=] { loads(s->map); },
                    .agree = {}});
        bench::add({.work = std::string("window ") + size + ", 11-bit map, coherent 1920 x 1080",
                    .peer = "decoding, loads alone",
                    .items = bench::pixels,
                    .ours = on_packed(s->coherent, filter),
                    .theirs =
                        [=] {
                            umbrage::decode(s->packed, s->decoded, rg);
                            loads(s->decoded);
                        },
                    .agree = {}});
    }
    umbrage::filters::disc disc{.points = 16};
    disc.radius_texels = 3.0f;
    std::array<glm::vec2, 16> points;
    std::ranges::transform(umbrage::disc_points<16>, points.begin(), [](glm::ivec2 p) { return glm::vec2(p) / 16.0f; });
    const auto glm_disc = [=] {
        peers::glm_code::disc_16(s->glm_map, s->glm_receivers, bench::screen.x, disc.radius_texels, points, s->theirs);
    };
    bench::add({.work = "disc of 16, turned, float map, coherent 1920 x 1080",
                .peer = "GLM code",
                .at_least = 6,
                .items = bench::pixels,
                .ours = on_floats(s->coherent, disc),
                .theirs = glm_disc,
                .agree = [s] { return s->close(2e-3); }});
    bench::add({.work = "disc of 16, turned, 11-bit map, coherent 1920 x 1080",
                .peer = "GLM code, float map",
                .at_least = 6,
                .items = bench::pixels,
                .ours = on_packed(s->coherent, disc),
                .theirs = glm_disc,
                .agree = [s] { return s->close(2e-3); }});
    umbrage::filters::pcss soft;
    soft.softness = {.per_code_x = 1.0f / 64,
                     .per_code_y = 1.0f / 64,
                     .min_radius = 16,
                     .max_radius = 96};  // boxes are some 10000 codes high
    const auto glm_pcss = [=] {
        peers::glm_code::pcss_16(s->glm_map, s->glm_receivers, bench::screen.x, 64.0f, 1.0f, 6.0f, points, s->theirs);
    };
    bench::add({.work = "PCSS, 16 blockers and 16 taps, float map, coherent 1920 x 1080",
                .peer = "GLM code",
                .at_least = 5,
                .items = bench::pixels,
                .ours = on_floats(s->coherent, soft),
                .theirs = glm_pcss,
                .agree = [s] { return s->close(5e-3); }});
    bench::add({.work = "PCF 2x2, 11-bit map, random 1920 x 1080",
                .peer = "ours, float map",
                .at_least = 1.5,
                .items = bench::pixels,
                .ours = on_packed(s->random, pcf_2x2{}),
                .theirs =
                    [=] {
                        umbrage::visibility(s->map, f32, s->random, pcf_2x2{}, s->other, umbrage::serial{},
                                            umbrage::outside_map::clamped);
                    },
                .agree = [s] { return std::ranges::equal(s->ours.texels(), s->other.texels()); }});
    // A few of these receivers lie at the map's edge; all blocks ask whether theirs do.
    const auto against_clamped = [&](const std::string& what, const auto& filter) {
        bench::add({.work = what + ", outside the map lit, float map, coherent 1920 x 1080",
                    .peer = "ours, clamped",
                    .items = bench::pixels,
                    .ours = [=] { umbrage::visibility(s->map, f32, s->coherent, filter, s->ours); },
                    .theirs =
                        [=] {
                            umbrage::visibility(s->map, f32, s->coherent, filter, s->other, umbrage::serial{},
                                                umbrage::outside_map::clamped);
                        },
                    .agree = {}});
    };
    against_clamped("hard", umbrage::filters::hard{});
    against_clamped("PCF 2x2", pcf_2x2{});
    against_clamped("window 5x5", umbrage::filters::castano<5>);
    against_clamped("PCF 5x5", box{2});
    against_clamped("disc of 16, turned", disc);
    against_clamped("PCSS, 16 blockers and 16 taps", soft);
    const auto scene = std::make_shared<bench::shadowed_scene>(bench::solids_scene(8));
    bench::add({.work = "box 17 x 17, solids",
                .peer = "ours, every texel",
                .at_least = 6,
                .items = bench::pixels,
                .ours =
                    [=] {
                        umbrage::visibility(scene->map, f32, scene->receivers, box{8}, s->ours, umbrage::serial{},
                                            umbrage::outside_map::clamped);
                    },
                .theirs =
                    [=] {
                        umbrage::visibility(scene->map, f32, scene->receivers, forced::every_texel{box{8}}, s->other,
                                            umbrage::serial{}, umbrage::outside_map::clamped);
                    },
                .agree = [s] { return std::ranges::equal(s->ours.texels(), s->other.texels()); }});
#ifdef UMBRAGE_BENCH_LLVMPIPE
    if (const auto pipe = peers::llvmpipe::start(s->map, s->packed, s->coherent)) {
        const auto same = [s, pipe] {
            pipe->read(s->theirs);
            return std::ranges::equal(s->ours.texels(), s->theirs);
        };
        namespace glsl = umbrage::glsl;
        const auto against_pipe = [&](const std::string& what, const auto& filter, double at_least,
                                      const std::vector<glsl::snippet>& snippets, const std::string& arguments) {
            for (const bool packed : {false, true})
                bench::add(
                    {.work = what + (packed ? ", 11-bit map" : ", float map") + ", coherent 1920 x 1080",
                     .peer = "llvmpipe, one thread",
                     .at_least = at_least,
                     .items = bench::pixels,
                     .ours = packed ? std::function<void()>(on_packed(s->coherent, filter))
                                    : std::function<void()>(on_floats(s->coherent, filter)),
                     .theirs = [pipe, program = pipe->compile(snippets, arguments, packed)] { pipe->draw(program); },
                     .agree = same});
        };
        against_pipe("PCF 2x2", pcf_2x2{}, 8, {glsl::pcf_2x2}, "");
        for (const auto& [size, filter, with_glm] : windows)
            against_pipe(std::string("window ") + size, filter, 6, {*filter.snippet}, "");
        against_pipe("disc of 16, turned", disc, 6, {*disc.snippet, glsl::disc_rotation},
                     ", 3.0, umbrage_disc_rotation(gl_FragCoord.xy)");
    }
#endif
});

}  // namespace
