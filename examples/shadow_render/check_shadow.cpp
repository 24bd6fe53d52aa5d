// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include <names.hpp>
#include <soft.hpp>

#include "check.hpp"
#include "scenes.hpp"

using namespace shadow_render_check;

namespace {

/// Pixels in shadow of the floor in front, which nothing stands before.
/// @param lit   least visibility of 255 that counts as none
int shadowed_floor(const std::string& options, int lit = 255) {
    CAPTURE(options);
    REQUIRE(run(output("lit") + solids + options).code == 0);
    const auto mask = picture("lit", "visibility.png");
    int shadowed = 0;
    for (int y = 145; y < 160; ++y)
        for (int x = 20; x < 220; ++x) shadowed += mask[{x, y}].r < lit;
    return shadowed;
}

/// The same without a bias, in samples.
int shadowed_without(std::string_view bias, float azimuth, float elevation, std::string_view encoding = "rg16") {
    shadow_render::options o = usual(shadow_render::built_in::solids);
    o.width = 240, o.height = 160, o.samples = 1, o.map_size = 256;
    o.azimuth = azimuth, o.elevation = elevation;
    o.bias = bias, o.encoding = encoding, o.reach = 0.0f;
    const umbrage::image<float> mask = visibility(o, scene_of(o));
    int shadowed = 0;
    for (int y = 145; y < 160; ++y)
        for (int x = 20; x < 220; ++x) shadowed += mask[{x, y}] < 1;
    return shadowed;
}

}  // namespace

TEST_CASE("shadow_render: no acne on what a light lights, from any side") {
    const auto shadowed_front = [](const std::string& options) { return shadowed_floor("--encoding rg9 " + options); };
    for (const char* light : {"--light spot ", "--light directional "})
        for (const char* filter :
             {"--filter hard ", "--filter four_tap ", "--filter pcf_2x2 ", "--filter box --radius 3 ",
              "--filter disc16 --radius 3 ", "--filter pcss16 ", "--filter dpcf16 "})
            for (const char* angles :
                 {"--azimuth 20 --elevation 20", "--azimuth 300 --elevation 50", "--elevation 90"}) {
                const std::string options = std::string(light) + filter + angles;
                CHECK_MESSAGE(shadowed_front(options) == 0, options);
            }
    CHECK(shadowed_without("acne_free", 20, 20, "rg9") > 100);  // without the bias there is plenty
}

TEST_CASE("shadow_render: no filtered map darkens a plane by a fiftieth") {
    for (const std::string& filter : example::prefilter_names())
        for (const char* light : {"--light spot ", "--light directional "}) {
            const std::string options = std::string(light) + "--azimuth 20 --elevation 20 --filter " + filter;
            CHECK_MESSAGE(shadowed_floor(options, 250) == 0, options);
        }
}

TEST_CASE("shadow_render: with every bias the floor is lit and shadows are where they belong") {
    REQUIRE(run(output("reference") + solids).code == 0);
    const auto reference = picture("reference", "visibility.png");
    for (const std::string& bias : example::bias_names()) {
        CAPTURE(bias);
        CHECK(shadowed_floor("--filter box --bias " + bias) == 0);
        REQUIRE(run(output("other") + solids + "--bias " + bias).code == 0);
        const auto mask = picture("other", "visibility.png");
        int differ = 0;
        for (int y = 0; y < 160; ++y)
            for (int x = 0; x < 240; ++x) differ += std::abs(mask[{x, y}].r - reference[{x, y}].r) > 64;
        CHECK(differ < 0.03 * 240 * 160);
        CHECK((differ > 0) == (bias != "acne_free"));
        CHECK(mask[{120, 65}].r == 0);  // the ball's shadow on the box
        // a plane of its own keeps a receiver lit without any bias
        CHECK((shadowed_without(bias, 60, 30) > 100) == !example::compares_along_plane(bias));
    }
}

TEST_CASE("shadow_render: edges get softer with a disc's radius, a map's blur and a light's size") {
    const auto soft = [](const std::string& options) {
        REQUIRE(run(output("soft") + solids + options).code == 0);
        const auto mask = picture("soft", "visibility.png");
        return std::ranges::count_if(mask.texels(), [](glm::u8vec4 p) { return p.r > 8 && p.r < 247; });
    };
    CHECK(soft("--filter disc32 --radius 6") > 2 * soft("--filter disc32 --radius 1.5"));
    for (const std::string filter : {"vsm", "msm", "summed_variance", "summed_moments"})
        CHECK(soft("--radius 6 --filter " + filter) > 1.5 * double(soft("--radius 1 --filter " + filter)));
    for (const std::string filter : {"pcss32", "dpcf32"})
        for (const std::string light : {"spot", "directional"}) {
            const std::string options = "--filter " + filter + " --light " + light + " --light-size ";
            CHECK(soft(options + "1.6") > 1.5 * double(soft(options + "0.1")));
        }
}
