// SPDX-License-Identifier: MIT
//
// Runs the viewer, and holds its pictures against those that the CPU's programs draw of the same scene.
#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include <sys/wait.h>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#include <stb/stb_image.h>

#include <umbrage/filter/pcf/hard.hpp>
#include <umbrage/images/rasterize.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include "headless.hpp"
#include "session.hpp"

namespace {

using picture = umbrage::image<glm::u8vec3>;

const std::filesystem::path folder = std::filesystem::current_path();  // each test's own: they run side by side

std::string quoted(const std::filesystem::path& path) { return std::string("'").append(path.string()).append("' "); }

struct result {
    int code;
    std::string said;  ///< on either stream
};

result run(const std::string& command) {
    FILE* pipe = popen((command + " 2>&1").c_str(), "r");
    REQUIRE(pipe);
    result out{0, {}};
    for (int c; (c = std::fgetc(pipe)) != EOF;) out.said += static_cast<char>(c);
    const int status = pclose(pipe);
    out.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return out;
}

picture load(const std::filesystem::path& file) {
    int width = 0, height = 0, channels = 0;
    const std::unique_ptr<stbi_uc, void (*)(void*)> data(
        stbi_load(file.string().c_str(), &width, &height, &channels, 3), stbi_image_free);
    REQUIRE_MESSAGE(data, file.string());
    picture out({width, height});
    for (std::size_t i = 0; i < out.texels().size(); ++i)
        out.texels()[i] = {data.get()[3 * i], data.get()[3 * i + 1], data.get()[3 * i + 2]};
    return out;
}

/// What the viewer draws.
picture viewed(const std::string& arguments, const std::string& in = {}) {
    const std::filesystem::path file = folder / "viewed.png";
    std::filesystem::remove(file);
    const result r = run(in + quoted(VIEWER) + "--screenshot " + quoted(file) + arguments);
    CAPTURE(arguments);
    REQUIRE_MESSAGE(r.code == 0, r.said);
    return load(file);
}

int differing(const picture& a, const picture& b) {
    REQUIRE(a.size() == b.size());
    int count = 0;
    for (std::size_t i = 0; i < a.texels().size(); ++i) count += a.texels()[i] != b.texels()[i];
    return count;
}

/// Where shadows begin and end, after the CPU's map with exact depth.
class silhouettes {
public:
    silhouettes(const example::shadow_system& s, glm::ivec2 size)
        : system_(s),
          scene_(example::make_scene(s)),
          camera_(example::make_camera(
              example::make_camera_setup(s, scene_, static_cast<float>(size.x) / static_cast<float>(size.y)))),
          seen_(example::camera_pass(scene_.geometry, camera_, size)),
          light_(example::make_light(s, scene_, s.azimuth, s.elevation, s.map_size)),
          to_texels_(umbrage::texture_matrix(light_.space, glm::ivec2(s.map_size))),
          map_(glm::ivec2(s.map_size), umbrage::cleared_depth(light_.space.clip)) {
        umbrage::rasterize_depth(map_, example::view_of(scene_.geometry), light_.world_to_clip(), light_.space.clip);
        for (float& z : map_.texels()) z = light_.depth(s, z);
    }

    /// Whether shadow takes another value somewhere within two texels of a pixel's surface, measured across the light
    /// and in the surface's own plane.
    [[nodiscard]] bool near(glm::ivec2 pixel) const {
        if (seen_[pixel] == example::nothing) return false;
        const example::surface at = example::surface_at(scene_, camera_, seen_, pixel);
        const glm::vec3 way = light_.spot ? glm::normalize(at.position - light_.position) : light_.direction;
        const float texel = light_.texel_world(at.position, system_.map_size);
        const glm::vec3 up(0, 1, 0);
        const glm::vec3 side = glm::normalize(glm::cross(way, glm::abs(way.y) < 0.9f ? up : glm::vec3(1, 0, 0)));
        const glm::vec3 above = glm::cross(side, way);
        const bool here = lit(at, at.position);
        for (int j = -2; j <= 2; ++j)
            for (int i = -2; i <= 2; ++i) {
                const glm::vec3 aside = texel * (static_cast<float>(i) * side + static_cast<float>(j) * above);
                const float along = -glm::dot(at.face_normal, aside) / glm::dot(at.face_normal, way);
                if (lit(at, at.position + aside + along * way) != here) return true;
            }
        return false;
    }

private:
    [[nodiscard]] bool lit(const example::surface& s, glm::vec3 position) const {
        const glm::vec3 point = example::lifted(system_, light_, position, s.normal, system_.map_size);
        const glm::vec3 p = umbrage::project_coordinate(umbrage::shadow_coordinate(to_texels_, point));
        const float receiver = light_.depth(system_, p.z) - system_.bias;
        return light_.cone(position) * umbrage::hard(umbrage::clamped(map_), glm::vec2(p), receiver) > 0;
    }

    example::shadow_system system_;
    example::scene scene_;
    example::camera camera_;
    umbrage::image<std::uint32_t> seen_;
    example::light light_;
    glm::mat4 to_texels_;
    umbrage::image<float> map_;
};

/// The CPU's program against the viewer, pixel by pixel.
void same_shadow(const example::shadow_system& system, int width, const std::string& viewer_only = {}) {
    const std::string name(system.name);
    const std::string light = " --azimuth " + std::to_string(system.azimuth) + " --elevation " +
                              std::to_string(system.elevation);
    CAPTURE(light);
    const result r = run(quoted(std::filesystem::path(ORIGINALS) / name) + "--output " + quoted(folder / name) +
                         "--size " + std::to_string(width) + light + (name == "exercise" ? " --frames 1" : ""));
    REQUIRE_MESSAGE(r.code == 0, r.said);
    const std::string arguments = "--headless --system " + name + " --width " + std::to_string(width) + " --height " +
                                  std::to_string(width * 2 / 3) + light + " " + viewer_only;

    const picture expected = load(folder / name / "visibility.png"), got = viewed(arguments + " --mask");
    REQUIRE(expected.size() == got.size());
    const silhouettes silhouettes(system, got.size());
    int other = 0, astray = 0, near = 0;
    for (glm::ivec2 p{0}; p.y < got.size().y; ++p.y)
        for (p.x = 0; p.x < got.size().x; ++p.x)
            if (got[p] != expected[p]) {
                ++other;
                astray += !silhouettes.near(p);
            }
    for (int i = 0; i < 1000; ++i) near += silhouettes.near({i * 7919 % got.size().x, i * 104729 % got.size().y});

    const int pixels = got.size().x * got.size().y;
    std::printf("%-15s light %4.0f %3.0f %s: of %d pixels %d (%.4f %%) other visibility, %d of them far from "
                "silhouettes (%d in 1000 pixels are near)\n",
                name.c_str(), static_cast<double>(system.azimuth), static_cast<double>(system.elevation),
                viewer_only.c_str(), pixels, other, 100.0 * other / pixels, astray, near);
    CHECK(other * 200 <= pixels);
    CHECK(astray == 0);
    CHECK(near < 300);  // `near` says no as well
    if (width < 500) return;

    // Colours, but for the corner where the map lies: its contrast is stretched after fewer texels.
    const picture colours = load(folder / name / "picture.png"), seen = viewed(arguments);
    const int edge = got.size().y * 3 / 10;
    int other_colours = 0;
    for (glm::ivec2 p{0}; p.y < got.size().y; ++p.y)
        for (p.x = 0; p.x < got.size().x; ++p.x) {
            const glm::ivec3 apart = glm::abs(glm::ivec3(colours[p]) - glm::ivec3(seen[p]));
            other_colours += (p.x >= edge || p.y >= edge) && glm::max(apart.x, glm::max(apart.y, apart.z)) > 2;
        }
    std::printf("%-15s %d of %d pixels of other colours\n", name.c_str(), other_colours, pixels);
    CHECK(other_colours * 200 <= pixels);
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

TEST_CASE("choices: every encoding and filter draws, fine encodings as floats do") {
    const std::string small = "--headless --mask --width 300 --height 200 --system dx_sdk ";
    for (const auto& named : viewer::filter_names) {
        const std::string filter(named.second);
        const std::string with_filter = small + "--filter " + filter;
        const picture floats = viewed(with_filter + " --encoding float");
        CHECK(floats[{138, 86}] != floats[{120, 190}]);  // the ball's shadow on the box, the floor in front
        for (const std::string& encoding : example::encoding_names) {
            const int other = differing(viewed(with_filter + " --encoding " + encoding), floats);
            CAPTURE(filter);
            CAPTURE(encoding);
            const bool faulty = encoding == "threejs_legacy" || encoding == "base255";  // decode the cleared 1 lower
            const bool coarse = encoding >= "rg10" && encoding <= "rg14";
            if (encoding == "rg9" || faulty)
                CHECK(other > 150);
            else if (!coarse)
                CHECK(other < 15);
        }
    }
}

TEST_CASE("choices: a mesh from a file, a finer map, a bias that lights everything") {
    std::ofstream(folder / "tent.obj") << "v 0 0 0\nv 1 0 0\nv 0 0 1\nv 0.3 1 0.3\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    const std::string small = "--headless --mask --width 300 --height 200 ";
    const picture usual = viewed(small);
    CHECK(differing(viewed(small + "--mesh " + quoted(folder / "tent.obj")), usual) > 1000);
    CHECK(differing(viewed(small + "--map-size 64"), usual) > 100);
    const picture lit = viewed(small + "--bias 1 --system exercise");
    CHECK(differing(lit, picture(lit.size(), glm::u8vec3(255))) == 0);
}

TEST_CASE("refusals: one line and an exit code") {
    const auto fails = [](const std::string& arguments, int code, const std::string& why, const std::string& in = {}) {
        const result r = run(in + quoted(VIEWER) + arguments);
        CAPTURE(arguments);
        CHECK_MESSAGE(r.code == code, r.said);
        CHECK_MESSAGE(r.said.find(why) != std::string::npos, r.said);
        CHECK_MESSAGE(r.said.find('\n') == r.said.size() - 1, r.said);
    };
    fails("--headless --system dx_sdk --es2", 2, "needs a float map");
    fails("--headless --es2 --encoding float-bits", 2, "float_bits");
    fails("--headless --system nothing", 2, "nothing");
    fails("--headless --map-size 0", 2, "0");
    fails("--headless --mesh no_such_file.obj", 1, "no_such_file.obj");
    fails("--headless --screenshot /no/such/folder/a.png", 1, "cannot write");
    fails("--frames 1", 1, "no window", "env -u DISPLAY -u WAYLAND_DISPLAY ");
}

TEST_CASE("keys: each changes what the text says it does") {
    viewer::options o;
    viewer::session s(o);
    s.press('F');
    CHECK(s.system.filter == example::filter_kind::pcf_2x2);
    s.press('E');
    CHECK(s.system.encoding == "rg12");
    CHECK(s.system.receiver == example::receiver_kind::plain);
    s.encode("rg11");
    CHECK(s.system.receiver == example::receiver_kind::scaled);
    const float bias = s.system.bias;
    s.press('+');
    CHECK(s.system.bias > bias);
    s.press('M');
    CHECK(s.system.map_size == 2048);
    s.press('N');
    CHECK(s.system.map_size == 1024);
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
    s.turn_camera(30, 200);
    CHECK(s.camera.elevation == 90);
    s.press('R');
    CHECK(s.camera.elevation == 30);

    o.es2 = true;
    viewer::session old(o);
    for (std::size_t i = 0; i < example::encoding_names.size(); ++i) {
        CHECK(old.system.encoding != "depth32f");
        old.press('E');
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
        CHECK(differing(window, viewed(small + "--headless")) == 0);
        CHECK(differing(viewed(small, in), window) > 500);
    }
}

int main(int argc, char** argv) {
    constexpr int skipped = 77;
    doctest::Context context(argc, argv);
    if (std::string(argc > 1 ? argv[1] : "").find("window") != std::string::npos && std::string(XVFB_RUN).empty()) {
        std::puts("skipped: no xvfb-run here");
        return skipped;
    }
    try {
        viewer::headless(false);
        viewer::headless(true);
    } catch (const viewer::no_context& error) {
        std::printf("skipped: %s\n", error.what());
        return skipped;
    }
    return context.run();
}
