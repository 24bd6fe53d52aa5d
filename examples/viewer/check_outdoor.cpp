// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>

#include <against_rays.hpp>
#include <camera.hpp>

#include "check.hpp"
#include "session.hpp"

using namespace viewer_check;

TEST_CASE(
    "outdoor: a sun's maps and a lamp's shadow as rays do, under other filters nearly the same, and have colours") {
    const std::string small = "--headless --system outdoor --width 240 --height 160 --map-size 1024 ";
    viewer::options o;
    o.system = "outdoor", o.width = 240, o.height = 160;
    const viewer::session s(o);
    const example::camera camera = example::make_camera(s.camera);
    const example::ray_tracer tracer(s.scene.geometry);
    const glm::vec3 sun = example::direction_at(s.system.azimuth, s.system.elevation);
    int near_in_cascades = 1 << 20;
    for (const std::string placement : {"cascades", "light-space", "perspective", "pages", "paraboloid"}) {
        const bool lamp = viewer::is_lamp(placement);
        const picture mask = viewed(small + "--mask --placement " + placement);
        const example::against_rays rays(s.scene, tracer, camera, mask.size(),
                                         lamp ? glm::vec4(s.lamp_position(), 1) : glm::vec4(sun, 0), 200,
                                         [&](glm::ivec2 p) { return mask[p].r >= 128; });
        MESSAGE(placement, ": lit ", rays.lit, ", dark ", rays.dark, ", other: near ", rays.other_near, ", far ",
                rays.other_far);
        CHECK(rays.shadowed_sky == 0);
        CHECK(rays.lit > 8000);
        CHECK(rays.dark > 1500);
        CHECK(rays.other_near * 50 < rays.lit + rays.dark);
        CHECK(rays.other_far * 25 < rays.lit + rays.dark);
        CHECK(rays.other_near < near_in_cascades);  // warps and pages give more texels to what is close
        if (placement == "cascades") near_in_cascades = rays.other_near;
    }

    const std::string lamp = small + "--mask --scene default --placement ";
    const picture faces = viewed(lamp + "cube");
    CHECK(std::ranges::count(faces.texels(), glm::u8vec3(0)) > 2000);
    CHECK(differing(viewed(lamp + "tetrahedron"), faces) < 0.02 * 240 * 160);

    const picture mask = viewed(small + "--mask");
    CHECK(differing(viewed(small + "--mask --filter box"), mask) < 0.2 * 240 * 160);
    const picture usual = viewed(small);
    CHECK(differing(viewed(small + "--tint"), usual) > 0.4 * 240 * 160);
    int mapped = 0;  // pixels in the corner, where the camera sees the sky
    for (glm::ivec2 p{0}; p.y < 30; ++p.y)
        for (p.x = 0; p.x < 48; ++p.x) mapped += usual[p] != usual[{60, 10}];
    CHECK(mapped > 1000);
}

TEST_CASE("outdoor: the best map is a warp across the light, and none along it") {
    const std::string small = quoted(VIEWER) + "--headless --system outdoor --width 240 --height 160 --placement best ";
    const std::string across = example::run_line(small).said;
    CHECK_MESSAGE(across.find("best: light-space, strength 0.9") != std::string::npos, across);
    const std::string along = example::run_line(small + "--azimuth 180 --elevation 5").said;
    CHECK_MESSAGE(along.find("best: tight, strength 0.000") != std::string::npos, along);
}
