// SPDX-License-Identifier: MIT
//
// Messages of functions for bad input: the function, the argument, the condition, and the value.
#include <doctest/doctest.h>

#include <array>
#include <functional>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <umbrage/umbrage.hpp>

using namespace umbrage;

namespace {

std::string message_of(const std::function<void()>& call) {
    try {
        call();
    } catch (const std::invalid_argument& error) { return error.what(); }
    return "no error";
}

/// The function of the message is `function`, the argument `argument`, and there are a condition and a value.
void says(const std::string& function, const std::string& argument, const std::string& got,
          const std::function<void()>& call) {
    const std::string message = message_of(call), begin = "umbrage::" + function + ": " + argument + " must be ";
    CAPTURE(begin);
    CAPTURE(message);
    CHECK(message.starts_with(begin));
    const auto value = message.find("; got ");
    REQUIRE(value != message.npos);
    CHECK(value > begin.size());
    CHECK(message.substr(value + 6).starts_with(got));
}

constexpr float without_end = std::numeric_limits<float>::infinity();
constexpr clip_space any_clip = cpu_clip_space;
const bounding_box<float> unit_box{}, inverted_box{{1, 2, 3}, {1, 1, 3}};

}  // namespace

TEST_CASE("messages: of lights") {
    says("make_spot_light", "outer_angle_radians", "30. Is it in degrees?",
         [] { (void)make_spot_light({.outer_angle_radians = 30, .clip = any_clip}); });
    says("make_spot_light", "direction", "(0, 0, 0)",
         [] { (void)make_spot_light({.direction = {}, .clip = any_clip}); });
    says("make_spot_light", "clip", "unset. Use opengl_clip_space, ", [] { (void)make_spot_light({}); });
    says("make_spot_light", "position, outer_angle_radians, z_near and z_far", "((",
         [] { (void)make_spot_light({.position = glm::vec3(3e38f), .clip = any_clip}); });
    says("make_directional_light", "map_size", "1 x 0", [] {
        (void)make_directional_light({.map_size = {1, 0}, .clip = any_clip});
    });
    says("make_directional_light", "z_near and z_far", "(5, 1)",
         [] { (void)make_directional_light({.z_near = 5, .z_far = 1, .clip = any_clip}); });
    says("make_point_light", "border", "-1", [] { (void)make_point_light<float>({.border = -1, .clip = any_clip}); });
    says("make_dual_paraboloid_light", "map_size", "8",
         [] { (void)make_dual_paraboloid_light<float>({.map_size = 8, .clip = any_clip}); });
    says("fit_spot_light", "receivers", "none", [] { (void)fit_spot_light<float>({.clip = any_clip}); });
    says("fit_spot_light", "casters.low", "((1, 2, 3), (1, 1, 3))",
         [] { (void)fit_spot_light<float>({.receivers = unit_box, .casters = inverted_box, .clip = any_clip}); });
    says("fit_directional_light", "casters.low", "((1, 2, 3), (1, 1, 3))", [] {
        (void)fit_directional_light<float>({.receivers = unit_box, .casters = inverted_box, .clip = any_clip});
    });
    says("fit_directional_light", "snap_texels", "1 x 8", [] {
        (void)fit_directional_light<float>({.receivers = unit_box, .snap_texels = {1, 8}, .clip = any_clip});
    });
    says("make_page_root", "side", "-2",
         [] { (void)make_page_root<float>({.side = -2, .scene = unit_box, .clip = any_clip}); });
    says("texture_matrix", "map_size", "0 x 8", [] {
        (void)texture_matrix(make_spot_light({.clip = any_clip}), {0, 8});
    });
}

TEST_CASE("messages: a body that is none, in the name of the function called") {
    const frustum<float> camera{.tan_half_x = -1};
    const std::array splits{1.0f, 10.0f, 5.0f}, good{1.0f, 5.0f, 10.0f};
    const cascade_fit<float> fit{.camera = camera, .scene = unit_box, .clip = any_clip};
    says("corners", "box.low", "((1, 2, 3), (1, 1, 3))", [] { (void)corners(inverted_box); });
    says("polyhedron", "box.low", "((1, 2, 3), (1, 1, 3))", [] { (void)polyhedron(inverted_box); });
    says("fit_directional_light", "receivers.tan_half_x", "-1",
         [&] { (void)fit_directional_light<float>({.receivers = camera, .clip = any_clip}); });
    says("fit_directional_light", "receivers.low", "((1, 2, 3), (1, 1, 3))",
         [] { (void)fit_directional_light<float>({.receivers = inverted_box, .clip = any_clip}); });
    says("fit_trapezoidal", "receivers.low", "((1, 2, 3), (1, 1, 3))",
         [] { (void)fit_trapezoidal(warp_fit<float>{.receivers = inverted_box, .clip = any_clip}, 1.0f); });
    says("fit_spot_light", "receivers.low", "((1, 2, 3), (1, 1, 3))",
         [] { (void)fit_spot_light<float>({.receivers = inverted_box, .clip = any_clip}); });
    says("sphere_around", "frustum.tan_half_x", "-1", [&] { (void)sphere_around(camera); });
    says("make_stable_cascades", "camera.tan_half_x", "-1", [&] { (void)make_stable_cascades<2>(fit, good); });
    says("make_tight_cascades", "camera.tan_half_x", "-1", [&] { (void)make_tight_cascades<2>(fit, good); });
    says("make_stable_cascades", "splits", "(10, 5)", [&] { (void)make_stable_cascades<2>(fit, splits); });
    const warp_fit<float> warp{.camera = camera, .receivers = unit_box, .clip = any_clip};
    says("fit_trapezoidal", "camera.tan_half_x", "-1", [&] { (void)fit_trapezoidal(warp, 1.0f); });
    const warp_fit<float> nothing{.receivers = hull(), .clip = any_clip};
    says("fit_perspective", "from.z_near", "-1",
         [&] { (void)fit_perspective(nothing, light_position<float>{.z_near = -1}); });
    says("fit_perspective", "from.position", "(inf, 0, 0)", [&] {
        (void)fit_perspective(nothing, light_position<float>{.position = {without_end, 0, 0}});
    });
}

TEST_CASE("messages: of images") {
    image<float> map({640, 480}), small({320, 240}), none;
    image<glm::vec3> receivers({640, 480});
    image<glm::u8vec2> texels({320, 240});
    image<glm::vec2> moments({640, 480});
    const char* const differ = "320 x 240";
    says("image", "size", "-1 x 2", [] { (void)image<float>({-1, 2}); });
    says("image_view", "stride_bytes", "4", [&] { (void)image_view<float>(&map[{0, 0}], {2, 2}, 4); });
    says("image_view", "pixels", "nullptr", [] { (void)image_view<float>(nullptr, {2, 2}); });
    says("image_view::region", "extent", "2 x 1", [&] { (void)map.view().region({639, 0}, {2, 1}); });
    says("clamped", "map.size", "0 x 0", [&] { (void)clamped(none); });
    says("encode", "texels.size", differ, [&] { encode(map.view(), texels.view(), rg<11>{}); });
    says("decode", "depth.size", "640 x 480", [&] { decode<rg<11>>(texels.view(), map.view(), rg<11>{}); });
    says("visibility", "out.size", differ,
         [&] { visibility(map.view(), depth32f{}, receivers.view(), filters::hard{}, small.view()); });
    says("visibility", "map.size", "0 x 0", [&] { visibility(image<glm::vec2>(), prefilters::vsm{}, receivers, map); });
    says("visibility", "out.size", differ, [&] { visibility(moments, prefilters::vsm{}, receivers, small); });
    says("visibility", "table.size", "0 x 0",
         [&] { visibility(image<glm::u16vec4>(), moment_table{}, receivers, 1, map); });
    says("visibility", "radius", "17", [&] {
        visibility(image<glm::u16vec4>({2, 2}), variance_table{}, receivers, 17, map);
    });
    says("summed_area", "sums.size", differ, [&] { summed_area(map.view(), small.view()); });
    says("blur", "to.size", differ, [&] { blur(map.view(), small.view(), make_gaussian_kernel(3, 1)); });
    says("blur", "kernel.weights", "none", [&] { blur(map.view(), map.view(), blur_kernel{}); });
    says("make_gaussian_kernel", "taps", "4", [] { (void)make_gaussian_kernel(4, 1); });
    says("make_filter_bounds", "reach", "-1", [&] { (void)make_filter_bounds(map.view(), -1); });
    says("make_mip_chain", "levels", "-1", [&] { (void)make_mip_chain(map, -1); });
    says("make_min_max_pyramid", "map.size", "0 x 0", [&] { (void)make_min_max_pyramid(none.view(), 1); });
    says("make_variance_table", "bits and radius", "(12, 400)",
         [&] { (void)make_variance_table(map.view(), {.bits = 12, .radius = 400}); });
    says("make_moment_table", "radius", "-1", [&] { (void)make_moment_table(map.view(), {.radius = -1}); });
    says("stretch", "outliers", "0.5", [&] { (void)stretch(map.view(), 1, 0.5); });
    const std::vector<glm::vec3> positions(2);
    const std::vector<glm::uvec3> triangles{{0, 1, 2}};
    says("rasterize_depth", "mesh.triangles", "2", [&] {
        rasterize_depth(map, mesh_view{positions, triangles}, glm::mat4(1), any_clip);
    });
    says("rasterize", "size", "-1 x 2", [&] {
        rasterize({-1, 2}, mesh_view{positions, triangles}, glm::mat4(1), any_clip, [](auto&&...) {});
    });
}

TEST_CASE("messages: of filters and shaders") {
    says("make_window_row", "size", "16", [] { (void)make_window_row(16, {1}); });
    says("make_window_row", "the sum of all weights times steps", "665.6", [] {
        (void)make_window_row(3, {0.3f, 2}, 256);
    });
    says("make_esm", "exponent", "80", [] { (void)make_esm({.exponent = 80}); });
    says("make_evsm", "least_deviation", "-1", [] { (void)make_evsm({.least_deviation = -1}); });
    says("glsl::bind", "name", "\"my-map\"", [] { (void)glsl::bind(glsl::hard, "my-map"); });
    const auto unnamed = [] {
        return std::vector{glsl::bind(glsl::hard, "", {.channels = 2}), glsl::bound(glsl::box)};
    };
    says("glsl::text", "name", "\"\"", [&] { (void)glsl::text(unnamed()); });
    says("hlsl::text", "name", "\"\"", [&] { (void)hlsl::text(unnamed()); });
    says("wgsl::text", "name", "\"\"", [&] { (void)wgsl::text(unnamed()); });
}
