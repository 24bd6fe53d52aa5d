// SPDX-License-Identifier: MIT
//
// Runs the four programs, holds their shadows against rays, and looks at what comes out.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <string>

#include <glm/gtc/type_precision.hpp>

#include <umbrage/core/image.hpp>

#include <png.hpp>

namespace {

const std::filesystem::path folder = std::filesystem::path(PROGRAMS) / "check";

bool runs(const std::string& program, const std::string& arguments, int size = 150) {
    const std::string command = "'" PROGRAMS "/" + program + "' --output '" + (folder / program).string() + "' --size ";
    return std::system((command + std::to_string(size) + " " + arguments).c_str()) == 0;
}

umbrage::image<glm::u8vec3> picture(const std::string& program, const char* file) {
    return example::read_png<glm::u8vec3>(folder / program / file);
}

/// Share of the pixels that `is` says yes to.
template <class Is>
double share(const umbrage::image<glm::u8vec3>& p, Is&& is) {
    double count = 0;
    for (glm::u8vec3 pixel : p.texels()) count += is(pixel);
    return count / static_cast<double>(p.texels().size());
}
bool black(glm::u8vec3 p) { return p == glm::u8vec3(0); }
bool white(glm::u8vec3 p) { return p == glm::u8vec3(255); }

/// The default light; every program draws the same scene from the same place.
void draws(const std::string& program, const std::string& arguments = {}) {
    std::filesystem::remove_all(folder / program);
    REQUIRE(runs(program, "--rays " + arguments));
    const auto shaded = picture(program, "picture.png"), mask = picture(program, "visibility.png");
    CHECK(shaded.size() == glm::ivec2(150, 100));
    CHECK(share(mask, black) > 0.04);
    CHECK(share(mask, black) < 0.3);
    CHECK(share(mask, white) > 0.6);
    CHECK(black(mask[{69, 43}]));                      // the ball's shadow on the box
    CHECK(white(mask[{60, 95}]));                      // the floor in front
    CHECK(shaded[{2, 2}] != shaded[{148, 2}]);         // the map over the sky
    const auto depth = picture(program, "depth.png");  // stretched: from black to white
    CHECK(share(depth, black) > 0);
    CHECK(share(depth, white) > 0);
    CHECK(share(depth, [](glm::u8vec3 p) { return !black(p) && !white(p); }) > 0.05);
}

/// Shadows attached and no acne, wherever the light is.
void stands_all_lights(const std::string& program) {
    for (int elevation : {20, 50, 90})
        for (int azimuth = elevation; azimuth < 360; azimuth += 90) {
            CAPTURE(elevation);
            CAPTURE(azimuth);
            CHECK(runs(program,
                       "--rays --azimuth " + std::to_string(azimuth) + " --elevation " + std::to_string(elevation),
                       96));
        }
}

}  // namespace

TEST_CASE("radeon_8500: 11 bits do what exact depth does, 8 bits do not") {
    draws("radeon_8500");
    CHECK(picture("radeon_8500", "map.png").size() == glm::ivec2(1024));
    CHECK(picture("radeon_8500", "comparison.png").size() == glm::ivec2(600, 100));
    const auto masks = picture("radeon_8500", "comparison_visibility.png");  // 8 bits, 11, 11 in s3.12, exact
    int wrong[3] = {};
    for (int way = 0; way < 3; ++way)
        for (int y = 0; y < 100; ++y)
            for (int x = 0; x < 150; ++x) wrong[way] += masks[{way * 150 + x, y}] != masks[{450 + x, y}];
    CHECK(wrong[0] > 150);
    CHECK(wrong[1] < 15);
    CHECK(wrong[2] < 15);
    stands_all_lights("radeon_8500");
}

TEST_CASE("dx_sdk: a cone, and soft edges") {
    draws("dx_sdk");
    const auto mask = picture("dx_sdk", "visibility.png");
    CHECK(black(mask[{147, 75}]));  // outside the cone
    CHECK(share(mask, [](glm::u8vec3 p) { return !black(p) && !white(p); }) > 0.005);
    stands_all_lights("dx_sdk");
}

TEST_CASE("dx_sdk: ambient light has a color, and a pane lets light through and takes shadows") {
    REQUIRE(runs("dx_sdk", "", 960));
    const auto shaded = picture("dx_sdk", "picture.png");
    const auto bluer = [&](glm::ivec2 at) { return shaded[at].b - shaded[at].r; };
    CHECK(bluer({930, 480}) > 10);                            // a gray floor outside the cone
    CHECK(std::abs(bluer({400, 600})) < 6);                   // a lit one
    CHECK(bluer({190, 410}) > 10);                            // the pane, lit, before a lit floor
    CHECK(shaded[{190, 410}].g > shaded[{250, 410}].g + 20);  // the ring's shadow on it, before a lit floor too
    CHECK(shaded[{170, 380}].g != shaded[{150, 380}].g);      // the floor's pattern, through it
}

TEST_CASE("exercise: the light moves, and each of its shadows is where rays say") {
    draws("exercise", "--frames 8");
    const auto frames = picture("exercise", "frames.png");
    CHECK(frames.size() == glm::ivec2(8 * 150, 100));
    for (int i = 1; i < 8; ++i) {
        int moved = 0;
        for (int y = 0; y < 100; ++y)
            for (int x = 0; x < 150; ++x) moved += frames[{i * 150 + x, y}] != frames[{(i - 1) * 150 + x, y}];
        CHECK(moved > 750);
    }
    for (const char* elevation : {"20", "50", "90"})
        CHECK(runs("exercise", std::string("--frames 4 --rays --elevation ") + elevation));
}

TEST_CASE("self_shadowing: darkened, and every bit of the look-up texture is used") {
    draws("self_shadowing");
    const auto map = picture("self_shadowing", "map.png");
    for (int high = 1; high < 8; ++high) CHECK(share(map, [&](glm::u8vec3 texel) { return texel.g == high * 32; }) > 0);
    CHECK(share(map, [](glm::u8vec3 texel) { return texel.g % 32 != 0 || texel.b != 0; }) == 0);
    stands_all_lights("self_shadowing");
    CHECK(!runs("self_shadowing", "--rays --reach 0 2> /dev/null"));  // acne, which rays do notice
}

TEST_CASE("originals: a mesh from a file") {
    std::filesystem::create_directories(folder);
    const std::filesystem::path mesh = folder / "pyramid.obj";
    std::ofstream(mesh) << "v -1 0 1\nv 1 0 1\nv 0 0 -1\nv 0 2 0\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    for (const char* program : {"radeon_8500", "dx_sdk", "exercise", "self_shadowing"}) {
        CAPTURE(program);
        REQUIRE(runs(program, std::string("'").append(mesh.string()).append("'")));
        const auto mask = picture(program, "visibility.png");
        CHECK(share(mask, black) > 0.02);
        CHECK(share(mask, white) > 0.6);
    }
}

TEST_CASE("originals: maps of few texels pass the comparison with rays, or the programs say that it tells nothing") {
    std::filesystem::create_directories(folder);
    for (const char* program : {"radeon_8500", "dx_sdk", "exercise", "self_shadowing"})
        for (int map_size : {64, 256}) {
            CAPTURE(program);
            CAPTURE(map_size);
            const std::string said = (folder / "said.txt").string();
            const bool passed =
                runs(program, std::string(program == std::string("exercise") ? "--frames 1 " : "") +
                                  "--rays --map-size " + std::to_string(map_size) + " 2> '" + said + "'");
            std::string line;
            std::getline(std::ifstream(said), line);
            CHECK_MESSAGE((passed || (map_size < 256 && line.find("rays tell nothing") != std::string::npos)), line);
        }
}

TEST_CASE("originals: encodings, filters and biases are there to try") {
    struct other {
        const char *program, *encoding, *filter;  // that none of them has by itself
    };
    for (const auto& [program, encoding, filter] : {other{"radeon_8500", "depth32f", "pcf_2x2"},
                                                    {"dx_sdk", "rgb24", "four_tap"},
                                                    {"exercise", "threejs_rgba", "pcf_2x2_dx_sdk"},
                                                    {"self_shadowing", "depth32f", "pcf_2x2"}}) {
        CAPTURE(program);
        REQUIRE(runs(program, ""));
        const auto own = picture(program, "visibility.png");
        CHECK(runs(program, std::string("--rays --encoding ") + encoding));
        CHECK(runs(program, std::string("--rays --filter ") + filter));
        REQUIRE(runs(program, "--rays --filter box"));
        const auto soft = picture(program, "visibility.png");
        CHECK(share(soft, [](glm::u8vec3 p) { return !black(p) && !white(p); }) > 0.01);
        REQUIRE(runs(program, "--epsilon 0.5"));
        CHECK(share(picture(program, "visibility.png"), black) < 0.5 * share(own, black) + 0.05);
    }
}

TEST_CASE("originals: the exercise's light can be moved and its box changed") {
    REQUIRE(runs("exercise", "--frames 1"));
    const auto own = picture("exercise", "depth.png");
    for (const char* option : {"--texels-per-unit 20", "--offset 12", "--near -5", "--far 60"}) {
        CAPTURE(option);
        REQUIRE(runs("exercise", std::string("--frames 1 ") + option));
        const auto other = picture("exercise", "depth.png");
        CHECK(!std::ranges::equal(own.texels(), other.texels()));
    }
    CHECK(own.size() == glm::ivec2(480, 320));  // the shape of the screen
    CHECK(runs("exercise", "--frames 1 --rays --map-size 960x640 --texels-per-unit 20"));
    CHECK(picture("exercise", "depth.png").size() == glm::ivec2(960, 640));
    for (const char* program : {"radeon_8500", "dx_sdk", "self_shadowing"})
        for (const char* size : {"900x600", "600x900"}) {
            CAPTURE(program);
            CHECK(runs(program, std::string("--rays --map-size ") + size));
        }
    REQUIRE(runs("exercise", "--frames 1 --epsilon 0.5"));
    CHECK(share(picture("exercise", "visibility.png"), black) == 0);
    CHECK(!runs("exercise", "--near 5 --far 5 2> /dev/null"));
}

TEST_CASE("originals: what cannot be drawn is refused") {
    for (const char* program : {"radeon_8500", "dx_sdk", "exercise", "self_shadowing"})
        for (const char* arguments :
             {"--map-size 0", "--map-size 9x480", "--map-size 480x", "--map-size 480x320x2", "--elevation 0",
              "--size -1", "no_such_mesh.obj", "''", "--filter none", "--encoding none"}) {
            CAPTURE(program);
            CAPTURE(arguments);
            CHECK(!runs(program, std::string(arguments) + " 2> /dev/null"));
        }
}
