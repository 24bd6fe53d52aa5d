// SPDX-License-Identifier: MIT
//
// What the four programs share around the shadow map: options, the camera's picture, files. The shadow map itself,
// from light to visibility, is written out in each program.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>

#include <glm/gtc/type_precision.hpp>

#include <umbrage/core/image.hpp>

#include <names.hpp>
#include <surface.hpp>
#include <systems.hpp>

namespace CLI {
class App;
}

namespace example {

struct options {
    std::filesystem::path output = "out", mesh{};
    float azimuth = 0, elevation = 0;
    int size = 960;
    glm::ivec2 map_size{0};
    std::optional<float> reach{};  ///< without one what the filter's own asks for
    float epsilon = 0;             ///< depth, from 0 to 1
    std::string encoding{}, filter{};
    bool rays = false;

    /// The system as these options want it.
    [[nodiscard]] shadow_system of(shadow_system s) const {
        s.reach = reach.value_or(covered(reach_of(filter)));
        s.epsilon = epsilon;
        s.azimuth = azimuth;
        s.elevation = elevation;
        s.map_size = map_size;
        s.encoding = encoding;
        s.filter = filter;
        return s;
    }
};

/// Nothing when only help was asked for. `more` may add options of the program's own.
[[nodiscard]] std::optional<options> read_options(const shadow_system& s, int argc, char** argv,
                                                  const std::function<void(CLI::App&)>& more = {});

/// Runs an original with its options; what it throws becomes one line and an exit code.
int run_original(const shadow_system& s, int argc, char** argv, const std::function<void(const options&)>& program);

using picture = umbrage::image<glm::u8vec3>;

/// The scene and what the camera sees of it.
struct stage {
    example::scene scene;
    example::camera camera;
    umbrage::image<std::uint32_t> seen;  ///< triangle behind each pixel

    stage(const shadow_system& s, const options& o);

    /// What else stands before it, where the camera sees that first.
    [[nodiscard]] stage before(example::scene front) const;

    /// Calls use(pixel, surface) wherever the camera sees one.
    template <class Use>
    void for_each_surface(Use&& use) const {
        for (int y = 0; y < seen.size().y; ++y)
            for_each_run(seen, y, [&](int first, int last, std::uint32_t triangle) {
                const seen_triangle on(scene, camera, seen.size(), triangle);
                for (int x = first; x < last; ++x) use(glm::ivec2(x, y), on.at({x, y}));
            });
    }

    /// An image of lit(surface); 1 where the camera sees nothing.
    template <class Lit>
    [[nodiscard]] umbrage::image<float> visibility(Lit&& lit) const {
        umbrage::image<float> out(seen.size(), 1.0f);
        for_each_surface([&](glm::ivec2 pixel, const surface& s) { out[pixel] = lit(s); });
        return out;
    }

    /// The surfaces' colors under the light.
    [[nodiscard]] picture shade(const shadow_system& s, const light& l, const umbrage::image<float>& visibility) const;
};

/// The depth pass: the distance to what the light sees first, in the system's kind of depth.
[[nodiscard]] umbrage::image<float> depth_pass(const shadow_system& s, const scene& scene, const light& l);

/// What the system's encoding keeps of a depth image.
[[nodiscard]] umbrage::image<float> stored(const shadow_system& s, const light& l, const umbrage::image<float>& depth);

/// Any of the filters, where a system's own does not do.
/// @param fetch  texel -> depth
[[nodiscard]] float filtered(const shadow_system& s, const std::function<float(glm::ivec2)>& fetch, glm::vec2 coord,
                             float receiver);

/// The map in the top left corner, its histogram stretched.
void show_map(picture& on, const umbrage::image<float>& depth);

/// Blends a picture over another wherever the camera sees something.
void blend(picture& over, const stage& seen, const picture& with, float alpha);

/// Draws the pane of a system that has one: alpha is its material's.
/// @param visibility   of a stage: image
template <class Visibility>
void draw_pane(picture& over, shadow_system s, const stage& behind, const light& l, Visibility&& visibility) {
    if (s.glass == 0) return;
    s.textured = false;
    const stage pane = behind.before(make_pane(s));
    blend(over, pane, pane.shade(s, l, visibility(pane)), s.glass);
}

/// Pictures of one size in a row.
[[nodiscard]] picture side_by_side(std::span<const picture> pictures);

[[nodiscard]] picture gray(const umbrage::image<float>& values);

void write(const options& o, const char* name, const picture& p);

/// picture.png, visibility.png and, its histogram stretched, depth.png.
void write(const options& o, const picture& p, const umbrage::image<float>& visibility, umbrage::image<float> depth);

}  // namespace example
