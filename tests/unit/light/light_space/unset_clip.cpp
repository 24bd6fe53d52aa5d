// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <array>
#include <string>

#include <umbrage/bias/light_units.hpp>
#include <umbrage/draw/instances.hpp>
#include <umbrage/draw/rasterize.hpp>
#include <umbrage/images/receivers.hpp>
#include <umbrage/light/adaptive/root.hpp>
#include <umbrage/light/pancake.hpp>

#include "../clip_spaces.hpp"
#include "../setups.hpp"

using namespace umbrage;

TEST_CASE("setups: a clip space that nobody gave is refused, and so are scene and receivers") {
    const std::string unset =
        "clip must be given; got unset. Use opengl_clip_space, vulkan_clip_space, direct3d_clip_space, "
        "webgpu_clip_space, metal_clip_space, unity_clip_space, unity_opengl_clip_space, unreal_clip_space, "
        "godot_clip_space, or cpu_clip_space where no API draws.";
    const auto refused = [&](const char* function, auto call) {
        CAPTURE(function);
        CHECK(complaint(call) == std::string("umbrage::") + function + ": " + unset);
    };
    const bounding_box<float> scene;
    const frustum<float> camera{.position = {0, 0, 4}};
    const warp_fit<float> warp{.camera = camera, .receivers = scene};
    const cascade_fit<float> cascades{.camera = camera, .scene = scene};
    const std::array splits{1.0f, 9.0f};
    refused("make_spot_light", [] { (void)make_spot_light({}); });
    refused("make_directional_light", [] { (void)make_directional_light({}); });
    refused("make_point_light", [] { (void)make_point_light<float>({}); });
    refused("make_tetrahedron_light", [] { (void)make_tetrahedron_light<float>({}); });
    refused("make_dual_paraboloid_light", [] { (void)make_dual_paraboloid_light<float>({}); });
    refused("make_page_root", [&] { (void)make_page_root<float>({.scene = scene}); });
    refused("fit_directional_light", [&] { (void)fit_directional_light<float>({.receivers = scene}); });
    refused("fit_spot_light", [&] { (void)fit_spot_light<float>({.receivers = hull()}); });
    refused("make_stable_cascades", [&] { (void)make_stable_cascades<1>(cascades, splits); });
    refused("make_tight_cascades", [&] { (void)make_tight_cascades<1>(cascades, splits); });
    refused("make_warped_cascades", [&] {
        (void)make_warped_cascades<1>(cascades, splits, [](const auto& f) { return fit_trapezoidal(f, 1.0f); });
    });
    refused("optimal_distance", [&] { (void)optimal_distance(warp); });
    refused("fit_light_space_perspective", [&] { (void)fit_light_space_perspective(warp); });
    refused("fit_trapezoidal", [&] { (void)fit_trapezoidal(warp, 1.0f); });
    refused("fit_perspective", [&] { (void)fit_perspective(warp); });
    refused("fit_perspective", [&] { (void)fit_perspective(warp, light_position<float>{}); });
    refused("fit_plane_optimal", [&] { (void)fit_plane_optimal(warp, {0, 1, 0, 0}); });
    refused("perspective", [] { (void)perspective(1.0f, 1.0f, 1.0f, 2.0f, {}); });
    refused("orthographic", [] { (void)orthographic(glm::vec2(0), glm::vec2(1), 1.0f, 2.0f, {}); });
    refused("near_depth", [] { (void)near_depth({}); });
    refused("receiver_matrix", [] { (void)receiver_matrix(glm::mat4(1), glm::mat4(1), {1, 1}, {}); });
    refused("may_mark", [&] { (void)may_mark(scene, glm::mat4(1), {}); });
    image<float> map({4, 4});
    refused("rasterize_depth", [&] { rasterize_depth(map, mesh_view{}, glm::mat4(1), {}); });
    CHECK(complaint([] {
              (void)texture_matrix(light_space<float>{}, {1, 1});
          }) == "umbrage::texture_matrix: light." + unset);
    CHECK(complaint([] {
              (void)make_light_units(light_space<float>{}, {1, 1});
          }) == "umbrage::make_light_units: light." + unset);

    const auto none = [](auto call) { return complaint(call).find("must be given") != std::string::npos; };
    const auto clip = cpu_clip_space;
    CHECK(none([&] { (void)make_stable_cascades<1>(cascade_fit<float>{.clip = clip}, splits); }));
    CHECK(none([&] { (void)make_tight_cascades<1>(cascade_fit<float>{.clip = clip}, splits); }));
    CHECK(none([&] { (void)make_page_root<float>({.clip = clip}); }));
    CHECK(none([&] { (void)fit_directional_light<float>({.clip = clip}); }));
    CHECK(none([&] { (void)fit_spot_light<float>({.clip = clip}); }));
    CHECK(none([&] { (void)fit_light_space_perspective(warp_fit<float>{.clip = clip}); }));
    CHECK(none([&] { (void)fit_perspective(warp_fit<float>{.clip = clip}, light_position<float>{}); }));
}
