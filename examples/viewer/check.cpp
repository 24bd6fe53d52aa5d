// SPDX-License-Identifier: MIT
//
// Runs the viewer, and holds its pictures against those that the CPU's programs draw of the same scene.
#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#include <cstdio>
#include <string>

#include <names.hpp>
#include <png.hpp>

#include "check.hpp"
#include "headless.hpp"
#include "session.hpp"
#include "silhouettes.hpp"

using namespace viewer_check;

namespace {

/// The CPU's program against the viewer, pixel by pixel.
void same_shadow(const example::shadow_system& system, int width, const std::string& viewer_only = {}) {
    const std::string name(system.name);
    const std::string light =
        " --azimuth " + std::to_string(system.azimuth) + " --elevation " + std::to_string(system.elevation);
    CAPTURE(light);
    const example::finished r =
        example::run_line(quoted(std::filesystem::path(ORIGINALS) / name) + "--output " + quoted(folder / name) +
                          "--size " + std::to_string(width) + light + (name == "exercise" ? " --frames 1" : ""));
    REQUIRE_MESSAGE(r.code == 0, r.said);
    const std::string arguments = "--headless --system " + name + " --width " + std::to_string(width) + " --height " +
                                  std::to_string(width * 2 / 3) + light + " " + viewer_only;

    const picture expected = example::read_png<glm::u8vec3>(folder / name / "visibility.png"),
                  got = viewed(arguments + " --mask");
    REQUIRE(expected.size() == got.size());
    const viewer::silhouettes silhouettes(system, got.size());
    int other = 0, astray = 0, near = 0;
    for (glm::ivec2 p{0}; p.y < got.size().y; ++p.y)
        for (p.x = 0; p.x < got.size().x; ++p.x)
            if (got[p] != expected[p]) {
                ++other;
                astray += !silhouettes.near(p);
            }
    for (int i = 0; i < 1000; ++i) near += silhouettes.near({i * 7919 % got.size().x, i * 104729 % got.size().y});

    const int pixels = got.size().x * got.size().y;
    std::printf(
        "%-15s light %4.0f %3.0f %s: of %d pixels %d (%.4f %%) other visibility, %d of them far from "
        "silhouettes (%d in 1000 pixels are near)\n",
        name.c_str(), static_cast<double>(system.azimuth), static_cast<double>(system.elevation), viewer_only.c_str(),
        pixels, other, 100.0 * other / pixels, astray, near);
    CHECK(other * 200 <= pixels);
    CHECK(astray == 0);
    CHECK(near < 300);  // `near` says no as well
    if (width < 500) return;

    // Colors, but for the corner where the map lies: its contrast is stretched after fewer texels.
    const picture colors = example::read_png<glm::u8vec3>(folder / name / "picture.png"), seen = viewed(arguments);
    const glm::ivec2 corner = example::overlay_size(system.map_size, got.size().y);
    int other_colors = 0;
    for (glm::ivec2 p{0}; p.y < got.size().y; ++p.y)
        for (p.x = 0; p.x < got.size().x; ++p.x) {
            const glm::ivec3 apart = glm::abs(glm::ivec3(colors[p]) - glm::ivec3(seen[p]));
            other_colors += (p.x >= corner.x || p.y >= corner.y) && glm::max(apart.x, glm::max(apart.y, apart.z)) > 2;
        }
    std::printf("%-15s %d of %d pixels of other colors\n", name.c_str(), other_colors, pixels);
    CHECK(other_colors * 200 <= pixels);
}

void same_shadow_everywhere(example::shadow_system system) {
    same_shadow(system, 960);
    for (float elevation : {20.0f, 50.0f, 90.0f})
        for (int i = 0; i < 8; ++i) {
            system.azimuth = 45.0f * static_cast<float>(i);
            system.elevation = elevation;
            same_shadow(system, 240);
        }
}

}  // namespace

TEST_CASE("radeon_8500: the viewer's shadow is the CPU's") {
    same_shadow_everywhere(example::radeon_8500);
    same_shadow(example::radeon_8500, 960, "--es2");
}
TEST_CASE("dx_sdk: the viewer's shadow is the CPU's") { same_shadow_everywhere(example::dx_sdk); }
TEST_CASE("exercise: the viewer's shadow is the CPU's") { same_shadow_everywhere(example::exercise); }
TEST_CASE("self_shadowing: the viewer's shadow is the CPU's") {
    same_shadow_everywhere(example::self_shadowing);
    same_shadow(example::self_shadowing, 960, "--es2");
}

TEST_CASE("refusals: one line and an exit code") {
    const auto fails = [](const std::string& arguments, int code, const std::string& why, const std::string& in = {}) {
        const example::finished r = example::run_line(in + quoted(VIEWER) + arguments);
        CAPTURE(arguments);
        CHECK_MESSAGE(r.code == code, r.said);
        CHECK_MESSAGE(r.said.find(why) != std::string::npos, r.said);
        CHECK_MESSAGE(r.said.find('\n') == r.said.size() - 1, r.said);
    };
    fails("--headless --system dx_sdk --es2", 2, "needs a float map");
    fails("--headless --es2 --encoding float-bits", 2, "float_bits");
    fails("--headless --es2 --filter vsm", 2, "vsm");
    fails("--headless --es2 --filter summed_variance", 2, "summed_variance");
    fails("--headless --light-size 5", 2, "--light-size");
    fails("--headless --system nothing", 2, "nothing");
    fails("--headless --system outdoor --es2", 2, "OpenGL 3.3");
    fails("--headless --system outdoor --encoding rg11", 2, "--encoding");
    fails("--headless --system outdoor --filter four_tap", 2, "four_tap");
    fails("--headless --system outdoor --filter pcss16", 2, "pcss16");
    fails("--headless --tint", 2, "--tint");
    fails("--headless --system outdoor --placement tight --tint", 2, "--tint");
    fails("--headless --placement tight", 2, "--placement");
    fails("--headless --map-size 0", 2, "0");
    fails("--headless --bias none", 2, "--bias");
    fails("--headless --radius 9", 2, "--radius");
    fails("--headless --reach nan", 2, "--reach");
    fails("--headless --mesh no_such_file.obj", 1, "no_such_file.obj");
    fails("--headless --screenshot /no/such/folder/a.png", 1, "cannot write");
    fails("--frames 1", 1, "no window", "env -u DISPLAY -u WAYLAND_DISPLAY ");
}

TEST_CASE("keys: each changes what the text says it does") {
    viewer::options o;
    viewer::session s(o);
    CHECK(s.system.bias == "normal_offset");  // the system's own, for its own filter
    s.press('F');
    CHECK(s.system.filter == "pcf_2x2");
    CHECK(s.system.bias == "acne_free");
    s.filter("pcss32");
    CHECK(s.system.bias == "receiver_plane");
    s.filter("pcf_2x2");
    for (std::size_t i = 1; i < viewer::filter_names().size(); ++i) s.press('F');
    CHECK(s.system.filter == "four_tap");  // all the way round
    CHECK(s.system.bias == "normal_offset");
    s.press('E');
    CHECK(s.system.encoding == "rg12");
    CHECK(s.system.receiver == example::receiver_kind::plain);
    s.encode("rg11");
    CHECK(s.system.receiver == example::receiver_kind::scaled);
    const float epsilon = s.system.epsilon;
    s.press('+');
    CHECK(s.system.epsilon > epsilon);
    s.press('B');
    CHECK(s.system.bias == "acne_free");
    CHECK(s.system.receiver == example::receiver_kind::scaled);
    s.bias("receiver_plane");
    CHECK(s.system.receiver == example::receiver_kind::plain);
    s.press('B');
    CHECK(s.system.bias == "normal_offset");  // all the way round
    CHECK(s.system.receiver == example::receiver_kind::scaled);
    s.filter("pcss16");
    CHECK(s.system.receiver == example::receiver_kind::plain);
    CHECK(s.system.bias == "normal_offset");  // as the key chose it
    const float light_size = s.system.light_size;
    s.press('D');
    CHECK(s.system.light_size > light_size);
    s.press('S');
    CHECK(s.system.light_size == doctest::Approx(light_size));
    s.filter("disc16");
    CHECK(s.system.receiver == example::receiver_kind::scaled);
    const float reach = s.system.reach;
    s.press('K');
    CHECK(*s.system.radius == 3);
    CHECK(s.system.reach > reach);
    for (int i = 0; i < 20; ++i) s.press('J');
    CHECK(*s.system.radius == 0);
    s.press('M');
    CHECK(s.system.map_size == glm::ivec2(2048));
    s.press('N');
    CHECK(s.system.map_size == glm::ivec2(1024));
    s.press(viewer::key::right);
    CHECK(s.system.azimuth == 63);
    for (int i = 0; i < 100; ++i) s.press(viewer::key::up);
    CHECK(s.system.elevation == 90);
    s.press('V');
    CHECK(s.mask);
    s.press('2');
    CHECK(s.system.name == "dx_sdk");
    CHECK(s.scenes == 1);
    s.press('3');
    CHECK(s.scenes == 2);  // the exercise's scene is larger
    s.press('5');
    CHECK(s.outdoor());
    CHECK(s.scenes == 3);
    s.press('E');
    CHECK(s.system.encoding == "depth32f");
    for (std::size_t i = 2; i < example::filter_names().size(); ++i) s.press('F');
    CHECK(s.system.filter == "pcf_2x2");  // all the way round, but for those that take more than a layer
    s.press('C');
    CHECK(s.tint);
    s.press('O');
    CHECK(s.placement == "tight");
    CHECK_FALSE(s.cascaded());
    for (std::size_t i = 1; i < viewer::placement_names().size(); ++i) s.press('O');
    CHECK(s.cascaded());  // all the way round
    s.press('3');
    CHECK(s.scenes == 4);
    s.turn_camera(30, 200);
    CHECK(s.camera.elevation == 90);
    s.press('R');
    CHECK(s.camera.elevation == 30);

    o.es2 = true;
    viewer::session old(o);
    for (std::size_t i = 0; i < example::encoding_names().size(); ++i) {
        CHECK(old.system.encoding != "depth32f");
        old.press('E');
    }
    for (std::size_t i = 0; i < viewer::filter_names().size(); ++i) {
        CHECK(old.system.filter != "vsm");
        old.press('F');
    }
    old.press('2');  // has no float map there: stays
    CHECK(old.system.name == "radeon_8500");
    old.press('4');
    CHECK(old.system.name == "self_shadowing");
}

TEST_CASE("window: draws what the headless viewer draws, and text over it") {
    const std::string in = quoted(XVFB_RUN) + "-a -s '-screen 0 800x600x24' ";
    for (const char* kind : {"", "--es2 "}) {
        const std::string small = std::string(kind) + "--width 300 --height 200 --frames 3 ";
        const picture window = viewed(small + "--no-text", in);
        // of one pixel a channel is 163.50009 in floats: llvmpipe stores 164 in RGBA8 and 163 in the window's BGRX
        const picture alone = viewed(small + "--headless");
        CHECK(differing(window, alone) <= 2);
        CHECK(differing_by_levels(window, alone) <= 1);
        CHECK(differing(viewed(small, in), window) > 500);
    }
}

int main(int argc, char** argv) {
    constexpr int skipped = 77;
    doctest::Context context(argc, argv);
    if (std::string(argc > 1 ? argv[1] : "").find("window") != std::string::npos && std::string(XVFB_RUN).empty()) {
        std::puts("SKIPPED: no xvfb-run here");
        return skipped;
    }
    try {
        viewer::headless(false);
        viewer::headless(true);
    } catch (const viewer::no_context& error) {
        std::printf("SKIPPED: %s\n", error.what());
        return skipped;
    }
    return context.run();
}
