// SPDX-License-Identifier: MIT
//
// State of the viewer: the picture on show, and the keys and mouse moves that change it. Independent of OpenGL.
//
//     viewer::session session(options);
//     session.press('F');  // the next filter
//
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <umbrage/filter/pcf/pcf_2x2.hpp>

#include <camera.hpp>
#include <systems.hpp>

#include "options.hpp"
#include "placement.hpp"

namespace viewer {

inline constexpr float lowest_light = 5;
inline constexpr float largest_radius = 8;  ///< largest radius of a box or a disc, texels
inline constexpr float largest_light = 4;   ///< across, world units
inline constexpr int smallest_map = 16, largest_map = 8192;

/// Keys that stand for no letter.
namespace key {
inline constexpr int left = 256, right = 257, up = 258, down = 259;
}

inline constexpr std::string_view keys =
    "drag  camera, wheel  distance\n"
    "right drag, arrows  light\n"
    "L  light goes round\n"
    "1 2 3 4  system, 5  outdoors\n"
    "O  its maps' placement, C  its parts\n"
    "E  encoding, F  filter, B  bias\n"
    "J K  radius, S D  light's size\n"
    "+ -  epsilon, M N  map size\n"
    "T  map, V  visibility alone\n"
    "H  this text, R  reset\n"
    "P  screenshot, Esc  quit\n";

/// Cascades over a kilometre, beside the original systems: a directional light, depths as they are, a filter over
/// layers.
inline constexpr example::shadow_system outdoor_system{
    .name = "outdoor",
    .title = "Outdoors",
    .light = example::light_kind::fitted,
    .elevation = 30,
    .map_size = glm::ivec2(1024),
    .depth = example::depth_kind::projected,
    .filter = "pcf_2x2",
    .epsilon = 0x1p-16f,
    .bias = "acne_free",
    .reach = example::covered(umbrage::filters::pcf_2x2{}.reach()),
};

/// Scenes for it.
[[nodiscard]] const std::vector<std::string>& ground_names();

[[nodiscard]] const std::vector<std::string>& filter_names();

/// True when the filter of this name takes only a map and a position in it.
[[nodiscard]] bool filters_layers(std::string_view filter);

class session {
public:
    explicit session(const options& o);

    example::shadow_system system;  ///< with every change made to it
    example::scene scene;
    example::camera_setup camera;
    std::string placement;  ///< outdoors, one of placement_names()
    bool es2, mask, tint, text, map, turning = false;
    int scenes = 0;  ///< counts them: a renderer uploads each once

    /// Goes over to a system as it is by itself.
    /// @throws example::usage_error  it does not run on OpenGL ES 2
    void select(const example::shadow_system& s);
    /// @param name  one of example::encoding_names()
    /// @throws example::usage_error  it does not run on OpenGL ES 2
    void encode(std::string_view name);
    /// @param name  one of filter_names(); the bias covers its reach, and is its usual one unless bias() chose another
    /// @throws example::usage_error  it does not run on OpenGL ES 2
    void filter(std::string_view name);
    void radius(float texels);  ///< sets the radius of a box, a disc or a blur
    /// @param name  one of example::bias_names()
    void bias(std::string_view name);

    /// A letter, a digit, '+', '-' or one of viewer::key. Others are ignored.
    void press(int pressed);
    void turn_camera(float azimuth, float elevation);  ///< by degrees
    void turn_light(float azimuth, float elevation);
    void zoom(float steps);
    void resize(glm::ivec2 size);

    [[nodiscard]] bool outdoor() const { return system.name == outdoor_system.name; }
    [[nodiscard]] bool cascaded() const { return placement == in_cascades; }
    [[nodiscard]] bool paged() const { return placement == in_pages; }
    [[nodiscard]] bool lamp() const { return is_lamp(placement); }
    [[nodiscard]] glm::vec3 lamp_position() const;
    [[nodiscard]] std::string describe() const;  ///< a few lines for people

private:
    void next_encoding();
    void next_filter();
    [[nodiscard]] example::camera_setup usual_camera() const;
    void settle_receiver();

    std::string ground_;
    std::filesystem::path mesh_file_;
    example::up_axis up_;
    bool bias_chosen_ = false;
};

}  // namespace viewer
