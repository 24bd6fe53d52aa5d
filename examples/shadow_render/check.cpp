// SPDX-License-Identifier: MIT
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>

#include <umbrage/depth/float_bits.hpp>
#include <umbrage/depth/rg.hpp>

#include <circle.hpp>
#include <names.hpp>
#include <scene.hpp>
#include <srgb.hpp>

#include "check.hpp"
#include "render.hpp"
#include "scenes.hpp"
#include "troubles.hpp"

using namespace shadow_render_check;

namespace {

/// Share of a mask's pixels that are in full shadow.
double dark(const umbrage::image<glm::u8vec4>& mask) {
    double count = 0;
    for (glm::u8vec4 p : mask.texels()) count += p.r == 0;
    return count / static_cast<double>(mask.texels().size());
}

/// FNV-1a over a scene's positions and normals.
std::uint64_t digest(const example::scene& s) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const auto* vectors : {&s.geometry.positions, &s.geometry.normals})
        for (const glm::vec3& v : *vectors)
            for (glm::length_t i = 0; i < 3; ++i) {
                auto bits = std::bit_cast<std::uint32_t>(v[i] + 0.0f);  // -0 as 0
                for (int byte = 0; byte < 4; ++byte, bits >>= 8) hash = (hash ^ (bits & 255)) * 0x100000001b3u;
            }
    return hash;
}

}  // namespace

TEST_CASE("scenes: the same floats, whatever the C library") {
    CHECK(digest(example::default_scene()) == 18330959378252233176u);
    CHECK(digest(example::solids_scene()) == 11057982306718786585u);
    CHECK(digest(example::outdoor_scene()) == 9255408022494688683u);
    CHECK(digest(example::plain_scene()) == 6500445417939563345u);
}

TEST_CASE("scenes: points on a circle are the rounded sines, and rotations GLM's") {
    int other = 0;
    for (int i = -5000; i <= 5000; ++i) {
        const double turns = i / 4096.0, angle = turns * 2 * std::numbers::pi;
        const glm::vec2 at = example::on_circle(turns);
        other +=
            std::abs(double(at.x) - std::cos(angle)) > 0x1p-24 || std::abs(double(at.y) - std::sin(angle)) > 0x1p-24;
    }
    CHECK(other == 0);
    CHECK(example::on_circle(0.25) == glm::vec2(0, 1));
    CHECK(example::on_circle(-0.5) == glm::vec2(-1, 0));
    for (int axis = 0; axis < 3; ++axis) {
        glm::vec3 about(0);
        about[axis] = 1;
        const glm::mat4 expected = glm::rotate(glm::mat4(1), 0.7f, about),
                        got = example::rotation_about(axis, 0.35 / std::numbers::pi);
        for (int i = 0; i < 4; ++i) CHECK(glm::length(got[i] - expected[i]) < 1e-6f);
    }
}

TEST_CASE("shadow_render: the default scene, from the camera and under the light that are the default") {
    const example::finished r = run(output("default") + "--size 240x160");
    REQUIRE_MESSAGE(r.code == 0, r.said);
    CHECK(r.said.empty());
    const auto colors = picture("default", "picture.png"), mask = picture("default", "visibility.png");
    CHECK(colors.size() == glm::ivec2(240, 160));
    CHECK(mask.size() == glm::ivec2(240, 160));
    CHECK(picture("default", "depth.png").size() == glm::ivec2(2048));
    CHECK(picture("default", "map.png").size() == glm::ivec2(2048));
    CHECK(dark(mask) > 0.03);
    CHECK(dark(mask) < 0.3);
    CHECK(mask[{5, 5}].r == 255);      // the sky
    CHECK(mask[{120, 155}].r == 255);  // the ground in front
    CHECK(mask[{215, 125}].r == 0);    // the plinth's shadow
    CHECK(mask[{174, 54}].r < 40);     // the ball's shadow on the wall, where it is darkest
    int soft = 0, sharp = 0;           // pixels of an edge that are neither lit nor dark
    for (int x = 160; x < 190; ++x) soft += mask[{x, 54}].r > 25 && mask[{x, 54}].r < 230;
    for (int y = 98; y < 110; ++y) sharp += mask[{130, y}].r > 25 && mask[{130, y}].r < 230;
    CHECK(soft > 5);
    CHECK(sharp < 3);                           // beside the mast's foot
    CHECK(colors[{0, 0}] == colors[{239, 0}]);  // nothing lies over the picture
    CHECK(colors[{0, 0}].b > colors[{0, 0}].r);
}

TEST_CASE("shadow_render: without --quiet each stage's time is printed, and no bar when nobody watches") {
    const example::finished r = run(std::string("--output ").append(quoted(folder / "times")) + solids);
    REQUIRE(r.code == 0);
    for (const char* stage : {"depth pass", "encode", "camera pass", "visibility", "shade", "write", " ms\n"})
        CHECK_MESSAGE(r.said.find(stage) != std::string::npos, stage);
    CHECK(r.said.find("100%") == std::string::npos);
}

TEST_CASE("shadow_render: map.png holds the bytes of the encoding") {
    REQUIRE(run(output("bytes") + solids + "--encoding depth32f").code == 0);
    REQUIRE(run(output("rg11") + solids + "--encoding rg11").code == 0);
    const auto exact = picture("bytes", "map.png"), packed = picture("rg11", "map.png");
    const auto seen = picture("bytes", "depth.png");
    std::vector<std::pair<float, int>> brightness;
    int empty = 0;
    for (std::size_t i = 0; i < seen.texels().size(); ++i) {
        const float depth = umbrage::decode_float_bits(exact.texels()[i]);
        if (depth == 1) empty += seen.texels()[i] == glm::u8vec4(128, 128, 128, 255);
        else brightness.emplace_back(depth, seen.texels()[i].g);
    }
    std::ranges::sort(brightness);
    CHECK(std::ranges::is_sorted(brightness, {}, &std::pair<float, int>::second));  // the farther, the brighter
    CHECK(brightness.front().second < 30);
    CHECK(brightness.back().second > 220);
    CHECK(empty == 65536 - static_cast<int>(brightness.size()));
    int differ = 0;
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x) {
            const float depth = umbrage::decode_float_bits(exact[{x, y}]);
            const glm::u8vec2 expected = umbrage::encode_rg<11>(depth);
            const glm::u8vec4 texel = packed[{x, y}];
            differ += texel.r != expected.r || texel.g != expected.g || texel.b != 0;
        }
    CHECK(differ == 0);
}

TEST_CASE("shadow_render: every encoding and every filter shades alike") {
    REQUIRE(run(output("reference") + solids + "--encoding depth32f").code == 0);
    auto reference = picture("reference", "visibility.png");
    const auto agrees = [&](const std::string& options, double share) {
        CAPTURE(options);
        REQUIRE(run(output("other") + solids + options).code == 0);
        const auto other = picture("other", "visibility.png");
        double differ = 0;
        for (int y = 0; y < 160; ++y)
            for (int x = 0; x < 240; ++x) differ += std::abs(other[{x, y}].r - reference[{x, y}].r) > 64;
        CHECK(differ < share * 240 * 160);
    };
    for (const std::string& name : example::encoding_names()) agrees("--encoding " + name, name == "rg9" ? 0.02 : 0.01);
    for (const char* filter : {"hard", "four_tap", "pcf_2x2_dx_sdk", "box --radius 1"})
        agrees(std::string("--filter ") + filter, 0.03);
    // A wider box, which is filtered by bounds, against one that is not.
    REQUIRE(run(output("reference") + solids + "--filter box --radius 2").code == 0);
    reference = picture("reference", "visibility.png");
    agrees("--filter box --radius 4", 0.01);
}

TEST_CASE("to_srgb: the curve's bytes, on both sides of every step") {
    const example::srgb_table table;
    int differ = 0;
    for (float v = 0; v <= 1; v += 0x1p-20f) differ += table(v) != example::srgb_curve(v);
    for (int byte = 1; byte < 256; ++byte) {
        std::uint32_t below = 0, least = std::bit_cast<std::uint32_t>(1.0f);
        while (least - below > 1) {
            const std::uint32_t middle = (below + least) / 2;
            (example::srgb_curve(std::bit_cast<float>(middle)) < byte ? below : least) = middle;
        }
        for (std::uint32_t bits = below - 100; bits < least + 100 && bits <= std::bit_cast<std::uint32_t>(1.0f); ++bits)
            differ += table(std::bit_cast<float>(bits)) != example::srgb_curve(std::bit_cast<float>(bits));
    }
    CHECK(differ == 0);
    CHECK(table(-1) == 0);
    CHECK(table(2) == 255);
    CHECK(table(std::numeric_limits<float>::quiet_NaN()) == 0);
}

TEST_CASE("shadow_render: meshes of any unit, offset and up axis, in each format") {
    const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    REQUIRE(run(output("obj") + small + spot + file("tetrahedron.obj", obj)).code == 0);
    const auto mask = picture("obj", "visibility.png");
    CHECK(dark(mask) > 0.02);

    std::string far = obj;
    for (const auto& [from, to] : {std::pair{"v 0 0 0", "v 5000 8000 -3000"},
                                   {"v 1 0 0", "v 7048 8000 -3000"},
                                   {"v 0 1 0", "v 5000 10048 -3000"},
                                   {"v 0 0 1", "v 5000 8000 -952"}})
        far.replace(far.find(from), 7, to);
    REQUIRE(run(output("far") + small + spot + file("far.obj", far)).code == 0);
    const auto scaled = picture("far", "visibility.png");
    CHECK(std::ranges::equal(mask.texels(), scaled.texels()));

    const std::string ply =
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 4\nproperty list uchar int vertex_indices\nend_header\n"
        "0 0 0\n1 0 0\n0 0 1\n0 -1 0\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
    shadow_render::options o{.light = shadow_render::light_kind::spot, .quiet = true};
    o.width = 240, o.height = 160, o.map_size = 256;
    REQUIRE(run(output("ply") + small + spot + file("tetrahedron.ply", ply)).code == 0);
    const auto of = [&](const char* name, example::up_axis up) {
        return visibility(o, example::on_floor(example::load_mesh(folder / name), up));
    };
    const auto upright = of("tetrahedron.obj", example::up_axis::y),
               turned = of("tetrahedron.ply", example::up_axis::z);
    CHECK(std::ranges::equal(upright.texels(), turned.texels()));

    const std::string gltf = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
        "meshes":[{"primitives":[{"attributes":{"POSITION":1},"indices":0}]}],
        "buffers":[{"byteLength":44,"uri":
            "data:application/octet-stream;base64,AAABAAIAAAAAAAAAAAAAAAAAAAAAAIA/AAAAAAAAAAAAAAAAAACAPwAAAAA="}],
        "bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":6},{"buffer":0,"byteOffset":8,"byteLength":36}],
        "accessors":[{"bufferView":0,"componentType":5123,"count":3,"type":"SCALAR"},
                     {"bufferView":1,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}]})";
    REQUIRE(run(output("gltf") + small + spot + file("triangle.gltf", gltf)).code == 0);
    CHECK(dark(picture("gltf", "visibility.png")) > 0.009);
}

TEST_CASE("shadow_render: missing, empty and broken meshes") {
    fails("''", 2, "mesh");
    fails(quoted(folder / "none.obj"), 1, "no such file");
    fails(quoted(folder), 1, "not a file");
    fails(file("empty.obj", ""), 1, "the file is empty");
    fails(file("words.obj", "once upon a time\n"), 1, "words.obj: ");
    fails(file("words.ply", "once upon a time\n"), 1, "words.ply: ");
    fails(file("words.gltf", "once upon a time\n"), 1, "words.gltf: ");
    fails(file("words.txt", "once upon a time\n"), 1, "words.txt: ");
    fails(file("vertices.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n"), 1, "vertices.obj: ");
    fails(file("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\np 1 2 3\n"), 1,
          "points.obj: no triangles in it, only points and lines");
    fails(file("index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n"), 1, "index.obj: ");
    fails(file("line.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n"), 1, "line.obj: none of its triangles has an area");
    fails(file("nan.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), 1,
          "nan.obj: its triangles have coordinates that are infinite or no number");
    fails(std::string("--output ").append(quoted(folder / "empty.obj" / "below")), 1, "cannot make the folder");
}

TEST_CASE("shadow_render: each trouble is seen, and its cure is another picture") {
    for (const std::string name :
         {"detached", "acne", "leak", "aliasing", "seams", "contact", "shimmer", "quantization", "thin"}) {
        CAPTURE(name);
        const auto& all = shadow_render::troubles();
        const auto trouble = std::ranges::find(all, name, &shadow_render::trouble::name);
        REQUIRE(trouble != all.end());
        shadow_render::options o{.quiet = true};
        o.width = 96, o.height = 64, o.samples = 1;
        const auto scene = scene_of(trouble->cured(o));
        const auto wrong = photograph(trouble->wrong(o), scene), cured = photograph(trouble->cured(o), scene);
        REQUIRE(wrong.size() == glm::ivec2(96, 64));
        int differ = 0, marked = 0;
        for (std::size_t i = 0; i < wrong.texels().size(); ++i) {
            const glm::ivec3 apart = glm::abs(glm::ivec3(wrong.texels()[i]) - glm::ivec3(cured.texels()[i]));
            differ += apart.r + apart.g + apart.b > 24;
            marked += cured.texels()[i] == glm::u8vec3(214, 40, 40);
        }
        CHECK(differ > 60);
        CHECK(marked == 0);  // stable cascades do not change
    }
}

TEST_CASE("shadow_render: impossible options") {
    for (const char* value : {"0", "-1", "100000", "99999999999999999999", "nan", "1.5", "many"})
        fails(std::string("--map-size ") + value, 2, "--map-size");
    for (const char* option : {"--azimuth", "--elevation", "--light-size", "--radius"})
        for (const char* value : {"nan", "-nan", "inf", "1e30", "up"})
            fails(std::string(option) + " " + value, 2, option);
    fails("--elevation 0", 2, "--elevation");
    for (const char* size : {"0", "0x64", "64x8193", "64x", "x64", "64x64x64", "big"})
        fails(std::string("--size ") + size, 2, "--size");
    fails("--size 8192", 2, "too large");
    fails("--radius 9", 2, "--radius");
    fails("--light-size -1", 2, "--light-size");
    fails("--encoding none", 2, "--encoding");
    fails("--filter none", 2, "--filter");
    fails("--bias none", 2, "--bias");
    fails("--light none", 2, "--light");
    fails("--no-such-option", 2, "--no-such-option");
    fails("one.obj two.obj", 2, "two.obj");
}

TEST_CASE("shadow_render: --help") {
    const example::finished r = run("--help");
    CHECK(r.code == 0);
    for (const char* option : {"--light", "--azimuth", "--encoding", "--filter", "--bias", "--output"})
        CHECK_MESSAGE(r.said.find(option) != std::string::npos, option);
    int options = 0;
    for (std::size_t at = 0; (at = r.said.find("\n  ", at)) != std::string::npos; ++at)
        options += r.said[at + 3] != ' ';
    CHECK(options <= 15);  // what it measures is another program's: studies
    CHECK(options > 10);
}
