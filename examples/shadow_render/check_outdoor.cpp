// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <string>

#include <against_rays.hpp>
#include <camera.hpp>
#include <scene.hpp>

#include "check.hpp"

using namespace shadow_render_check;

TEST_CASE("shadow_render: a kilometre under cascades, whose shadows are those of rays") {
    const std::string options =
        "--scene outdoor --width 240 --height 160 --samples 1 --map-size 2048 --azimuth 60 --elevation 30 "
        "--camera-azimuth 0 --camera-elevation 4 --camera-distance 64 --fov 50 --filter hard ";
    const example::finished r = run("--output " + quoted(folder / "outdoor") + options);
    REQUIRE_MESSAGE(r.code == 0, r.said);
    CHECK(r.said.find("cascade       from") != std::string::npos);
    const auto mask = picture("outdoor", "visibility.png"), colors = picture("outdoor", "picture.png"),
               cascades = picture("outdoor", "cascades.png");
    CHECK(cascades.size() == colors.size());

    const example::scene scene = example::outdoor_scene();
    const example::camera camera = example::make_camera({.target = scene.target,
                                                         .elevation = 4,
                                                         .distance = 64,
                                                         .fov = 50,
                                                         .aspect = 1.5f,
                                                         .z_near = scene.z_near,
                                                         .z_far = scene.z_far});
    const example::against_rays rays(scene, example::ray_tracer(scene.geometry), camera, mask.size(),
                                     {example::direction_at(60, 30), 0}, 200,
                                     [&](glm::ivec2 p) { return mask[p].r >= 128; });
    MESSAGE("lit ", rays.lit, ", dark ", rays.dark, ", other: near ", rays.other_near, ", far ", rays.other_far);
    CHECK(rays.shadowed_sky == 0);
    CHECK(rays.lit > 8000);
    CHECK(rays.dark > 1500);
    CHECK(rays.other_near * 100 < rays.lit + rays.dark);
    CHECK(rays.other_far * 50 < rays.lit + rays.dark);
}

TEST_CASE("shadow_render: culled per cascade, maps have the bits of all instances") {
    const std::string options = "--scene outdoor --width 60 --height 40 --samples 1 --map-size 256 ";
    REQUIRE(run(output("culled") + options).code == 0);
    REQUIRE(run(output("all") + options + "--draw-all").code == 0);
    for (const char* file : {"map.png", "visibility.png"}) {
        const auto culled = picture("culled", file), all = picture("all", file);
        CHECK(std::ranges::equal(culled.texels(), all.texels()));
    }
}

TEST_CASE("shadow_render: cascades over the solids light what one map lights") {
    REQUIRE(run(output("one") + solids + "--light directional").code == 0);
    REQUIRE(run(output("four") + solids + "--light cascades --map-size 512").code == 0);
    const auto one = picture("one", "visibility.png"), four = picture("four", "visibility.png");
    int differ = 0;
    for (std::size_t i = 0; i < one.texels().size(); ++i)
        differ += std::abs(one.texels()[i].r - four.texels()[i].r) > 64;
    CHECK(differ < 0.03 * 240 * 160);
}

TEST_CASE("shadow_render: impossible cascades") {
    fails("--scene nowhere", 2, "--scene");
    fails("--scene outdoor one.obj", 2, "--scene");
    fails("--scene outdoor --compare", 2, "--compare");
    fails("--light cascades --map-size 31", 2, "--map-size");
    fails("--light spot --draw-all", 2, "--draw-all");
}

TEST_CASE("shadow_render: contact hardening keeps the shadow under eaves, which a bias for its widest radius cuts") {
    const auto dark = [](const std::string& options) {  // on the wall of the house in the middle
        REQUIRE(run(output("eaves") + "--scene outdoor --width 480 --height 320 --samples 1 " + options).code == 0);
        const auto mask = picture("eaves", "visibility.png");
        int count = 0;
        for (int y = 180; y < 192; ++y)
            for (int x = 240; x < 286; ++x) count += mask[{x, y}].r < 64;
        return count;
    };
    const int sharp = dark("--filter hard --map-size 8192"), usual = dark("--filter pcss32");
    CHECK(4 * usual > 3 * sharp);
    CHECK(4 * dark("--filter pcss32 --bias acne_free") < 3 * sharp);
}
