// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <string>

#include <against_rays.hpp>
#include <camera.hpp>
#include <scene.hpp>

#include "cascades.hpp"
#include "check.hpp"
#include "render.hpp"
#include "scenes.hpp"

using namespace shadow_render_check;

TEST_CASE("shadow_render: a kilometre under cascades, whose shadows are those of rays") {
    const example::finished r = run("--output " + quoted(folder / "outdoor") + "--scene outdoor --size 240x160");
    REQUIRE_MESSAGE(r.code == 0, r.said);
    CHECK(r.said.find("cascade       from") != std::string::npos);
    CHECK(picture("outdoor", "cascades.png").size() == picture("outdoor", "picture.png").size());

    shadow_render::options o = usual(shadow_render::built_in::outdoor);
    o.width = 240, o.height = 160, o.samples = 1, o.map_size = 2048, o.filter = "hard";
    const example::scene scene = example::outdoor_scene();
    const umbrage::image<float> mask = visibility(o, scene);
    const example::camera camera = example::make_camera({.target = scene.target,
                                                         .elevation = 4,
                                                         .distance = 64,
                                                         .fov = 50,
                                                         .aspect = 1.5f,
                                                         .z_near = scene.z_near,
                                                         .z_far = scene.z_far});
    const example::against_rays rays(scene, example::ray_tracer(scene.geometry), camera, mask.size(),
                                     {example::direction_at(60, 30), 0}, 200,
                                     [&](glm::ivec2 p) { return mask[p] >= 0.5f; });
    MESSAGE("lit ", rays.lit, ", dark ", rays.dark, ", other: near ", rays.other_near, ", far ", rays.other_far);
    CHECK(rays.shadowed_sky == 0);
    CHECK(rays.lit > 8000);
    CHECK(rays.dark > 1500);
    CHECK(rays.other_near * 100 < rays.lit + rays.dark);
    CHECK(rays.other_far * 50 < rays.lit + rays.dark);
}

TEST_CASE("shadow_render: culled per cascade, maps have the bits of all instances") {
    shadow_render::options o = usual(shadow_render::built_in::outdoor);
    o.width = 60, o.height = 40, o.samples = 1, o.map_size = 256;
    const example::scene scene = scene_of(o);
    const auto drawn = [&](bool all) {
        o.draw_all = all;
        example::progress progress(20, true);
        shadow_render::view v = make_view(o, scene, progress);
        return look_up_cascades(o, v, v.camera, progress);
    };
    const auto culled = drawn(false), all = drawn(true);
    CHECK(culled.drawn[0].instances < all.drawn[0].instances);
    CHECK(std::ranges::equal(culled.map.depth.texels(), all.map.depth.texels()));
    CHECK(std::ranges::equal(culled.visibility.texels(), all.visibility.texels()));
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
    fails("--light cascades --map-size 31", 2, "--map-size");
}

TEST_CASE("shadow_render: contact hardening keeps the shadow under eaves, which a bias for its widest radius cuts") {
    shadow_render::options o = usual(shadow_render::built_in::outdoor);
    o.width = 480, o.height = 320, o.samples = 1;
    const example::scene scene = scene_of(o);
    const auto dark = [&] {  // on the wall of the house in the middle
        const umbrage::image<float> mask = visibility(o, scene);
        int count = 0;
        for (int y = 180; y < 192; ++y)
            for (int x = 240; x < 286; ++x) count += mask[{x, y}] < 0.25f;
        return count;
    };
    o.filter = "pcss32";
    const int usual = dark();
    o.bias = "acne_free";
    const int cut = dark();
    o.filter = "hard", o.bias = {}, o.map_size = 8192;
    const int sharp = dark();
    CHECK(4 * usual > 3 * sharp);
    CHECK(4 * cut < 3 * sharp);
}
