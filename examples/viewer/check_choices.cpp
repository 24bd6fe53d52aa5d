// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <names.hpp>
#include <soft.hpp>
#include <systems.hpp>

#include "check.hpp"

using namespace viewer_check;

namespace {

/// Pixels that see a texel with another comparison, as a multiple of those under a box of radius 1. At least 1.
int pixels_a_texel(const std::string& filter) {
    const float times = std::max(example::reach_of(filter) / 1.5f, 1.0f);
    return static_cast<int>(times * times);
}

/// Pixels that are neither lit nor dark.
int soft_pixels(const picture& mask) {
    return static_cast<int>(std::ranges::count_if(mask.texels(), [](glm::u8vec3 p) { return p.r > 8 && p.r < 247; }));
}

}  // namespace

TEST_CASE("choices: every filter draws, and every encoding; fine ones as floats do") {
    // an offset leaves room for what an encoding loses; the smallest bias shows it where things touch
    const std::string small = "--headless --mask --width 300 --height 200 --system dx_sdk --bias normal_offset ";
    for (const std::string& filter : example::filter_names()) {
        const std::string with_filter = small + "--filter " + filter;
        const picture floats = viewed(with_filter + " --encoding depth32f");
        CHECK(floats[{138, 86}] != floats[{120, 190}]);  // the ball's shadow on the box, the floor in front
        for (const std::string& encoding : example::encoding_names()) {
            const bool tried = filter == "pcf_2x2" || (filter == "disc16" && encoding == "rg11");
            if (!tried) continue;  // filters see depths alone
            const int other = differing(viewed(with_filter + " --encoding " + encoding), floats);
            CAPTURE(filter);
            CAPTURE(encoding);
            const bool coarse = encoding >= "rg10" && encoding <= "rg14";
            if (encoding == "rg9") CHECK(other > 150);
            else if (!coarse) CHECK(other < 15 * pixels_a_texel(filter));
        }
    }
}

TEST_CASE("choices: every bias on every system keeps what is lit lit, and shadows where they are") {
    for (const char* kind : {"", "--es2 "})
        for (const example::shadow_system& system : example::systems) {
            if (*kind && system.name != "radeon_8500") continue;
            const std::string small =
                std::string("--headless --mask --width 300 --height 200 --system ").append(system.name) + " " + kind;
            const picture usual = viewed(small + "--filter box");
            for (const std::string& bias : example::bias_names()) {
                CAPTURE(bias);
                CAPTURE(system.name);
                const picture mask = viewed(small + "--filter box --bias " + bias);
                CHECK(mask[{150, 195}] == glm::u8vec3(255));  // the floor in front
                CHECK(mask[{148, 82}] == glm::u8vec3(0));     // the ball's shadow on the box
                const int other = differing(mask, usual);
                CHECK((other > 0) == (bias != "acne_free"));
                CHECK(other < 0.08 * 300 * 200);
            }
        }
}

TEST_CASE("choices: soft shadows are where hard ones are, and soft") {
    const std::string small = "--headless --mask --width 300 --height 200 --system ";
    std::vector<std::string> filters = example::prefilter_names();
    filters.emplace_back("dpcf16");
    for (const char* size : {"0", "0.4"}) filters.push_back(std::string("pcss16 --light-size ") + size);
    for (const std::string system : {"radeon_8500 ", "dx_sdk "}) {
        const picture sharp = viewed(small + system + "--bias acne_free --filter pcf_2x2");
        for (const std::string& filter : filters) {
            if (system == "dx_sdk " && !filter.starts_with("pcss16") && filter != "evsm4") continue;
            const picture mask = viewed(small + system + "--bias acne_free --filter " + filter);
            CAPTURE(system);
            CAPTURE(filter);
            CHECK(mask[{150, 195}].r > 250);  // the floor in front
            CHECK(mask[{148, 82}].r < 40);    // the ball's shadow on the box
            int other = 0;
            for (glm::ivec2 p{0}; p.y < 200; ++p.y)
                for (p.x = 0; p.x < 300; ++p.x) other += std::abs(mask[p].r - sharp[p].r) > 128;
            CHECK(other < 300 * 200 / 100);
        }
    }
    for (const std::string dialect : {"radeon_8500 ", "radeon_8500 --es2 "}) {
        const std::string pcss = small + dialect + "--filter pcss32 --light-size ";
        CHECK(soft_pixels(viewed(pcss + "1.6")) > 1.5 * soft_pixels(viewed(pcss + "0.1")));
    }
    for (const std::string filter : {"vsm --radius ", "summed_variance --radius ", "summed_moments --radius "}) {
        const std::string with_filter = small + "dx_sdk --filter " + filter;
        CHECK(soft_pixels(viewed(with_filter + "3")) > 1.5 * soft_pixels(viewed(with_filter + "0")));
    }
}

TEST_CASE("choices: a disc's radius, and what a bias is to reach") {
    const std::string small = "--headless --mask --width 300 --height 200 --filter disc16 ";
    CHECK(differing(viewed(small + "--radius 6"), viewed(small)) > 500);
    CHECK(differing(viewed(small + "--radius 2"), viewed(small)) == 0);
    CHECK(differing(viewed(small + "--reach 0"), viewed(small)) > 500);
}

TEST_CASE("choices: a mesh from a file, a finer map, an epsilon that lights everything") {
    std::ofstream(folder / "tent.obj") << "v 0 0 0\nv 1 0 0\nv 0 0 1\nv 0.3 1 0.3\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    const std::string small = "--headless --mask --width 300 --height 200 ";
    const picture usual = viewed(small);
    CHECK(differing(viewed(small + "--mesh " + quoted(folder / "tent.obj")), usual) > 1000);
    CHECK(differing(viewed(small + "--map-size 64"), usual) > 100);
    const picture lit = viewed(small + "--epsilon 1 --system exercise");
    CHECK(differing(lit, picture(lit.size(), glm::u8vec3(255))) == 0);
}
