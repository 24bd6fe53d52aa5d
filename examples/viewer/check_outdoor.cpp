// SPDX-License-Identifier: MIT
#include <string>

#include <against_rays.hpp>
#include <camera.hpp>

#include "check.hpp"
#include "session.hpp"

using namespace viewer_check;

TEST_CASE("outdoor: maps placed either way shadow as rays do, under other filters nearly the same, and have colors") {
    const std::string small = "--headless --system outdoor --width 240 --height 160 --map-size 1024 ";
    viewer::options o;
    o.system = "outdoor", o.width = 240, o.height = 160;
    const viewer::session s(o);
    const example::camera camera = example::make_camera(s.camera);
    const example::ray_tracer tracer(s.scene.geometry);
    const glm::vec3 sun = example::direction_at(s.system.azimuth, s.system.elevation);
    int near_in_cascades = 1 << 20;
    for (const std::string placement : {"cascades", "light-space", "perspective", "pages"}) {
        const picture mask = viewed(small + "--mask --placement " + placement);
        const example::against_rays rays(s.scene, tracer, camera, mask.size(), {sun, 0}, 200,
                                         [&](glm::ivec2 p) { return mask[p].r >= 128; });
        MESSAGE(placement, ": lit ", rays.lit, ", dark ", rays.dark, ", other: near ", rays.other_near, ", far ",
                rays.other_far);
        CHECK(rays.shadowed_sky == 0);
        CHECK(rays.lit > 8000);
        CHECK(rays.dark > 1500);
        CHECK(rays.other_near * 50 < rays.lit + rays.dark);
        CHECK(rays.other_far * 25 < rays.lit + rays.dark);
        // pages and this warp give more texels to what is close; the perspective warp errs as cascades do
        if (placement != "perspective") CHECK(rays.other_near < near_in_cascades);
        if (placement == "cascades") near_in_cascades = rays.other_near;
    }

    const picture mask = viewed(small + "--mask");
    CHECK(differing(viewed(small + "--mask --filter box"), mask) < 0.2 * 240 * 160);
    const picture usual = viewed(small);
    CHECK(differing(viewed(small + "--tint"), usual) > 0.4 * 240 * 160);
    int mapped = 0;  // pixels in the corner, where the camera sees the sky
    for (glm::ivec2 p{0}; p.y < 30; ++p.y)
        for (p.x = 0; p.x < 48; ++p.x) mapped += usual[p] != usual[{60, 10}];
    CHECK(mapped > 1000);
}

TEST_CASE("outdoor: a lamp's maps shadow as rays do, and a sun's on the ground") {
    viewer::options o;
    o.system = "outdoor", o.ground = "solids", o.width = 240, o.height = 160;
    const viewer::session s(o);
    const example::ray_tracer tracer(s.scene.geometry);
    const auto check = [&](std::string_view placement, const glm::vec4& light) {
        const picture mask = viewed(
            "--headless --system outdoor --scene solids --width 240 --height 160 --mask "
            "--placement " +
            std::string(placement));
        const example::against_rays rays(s.scene, tracer, example::make_camera(s.camera), mask.size(), light, 200,
                                         [&](glm::ivec2 p) { return mask[p].r >= 128; });
        MESSAGE(placement, ": lit ", rays.lit, ", dark ", rays.dark, ", other ", rays.other_near);
        CHECK(rays.shadowed_sky == 0);
        CHECK(rays.lit > 8000);
        CHECK(rays.dark > 1500);
        CHECK(rays.other_near * 100 < rays.lit + rays.dark);
    };
    for (const std::string_view placement : viewer::lamp_placements) check(placement, {s.lamp_position(), 1});
    check("plane-optimal", {example::direction_at(s.system.azimuth, s.system.elevation), 0});
}

TEST_CASE("outdoor: the best map is a warp across the light, and none along it") {
    const std::string small = quoted(VIEWER) + "--headless --system outdoor --width 240 --height 160 --placement best ";
    const std::string across = example::run_line(small).said;
    CHECK_MESSAGE(across.find("best: light-space, strength 0.9") != std::string::npos, across);
    const std::string along = example::run_line(small + "--azimuth 180 --elevation 5").said;
    CHECK_MESSAGE(along.find("best: tight, strength 0.000") != std::string::npos, along);
}
