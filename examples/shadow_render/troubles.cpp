// SPDX-License-Identifier: MIT
#include "troubles.hpp"

namespace shadow_render {
namespace {

void look_at(options& o, glm::vec3 target, float fov) { o.target = target, o.fov = fov; }

void look_at_knot(options& o) { look_at(o, {2.35f, 0.42f, 0.6f}, 10), o.filter = "pcf_2x2"; }
void look_at_fence(options& o) { look_at(o, {-1.15f, 0.12f, 0}, 9); }
void look_at_mast(options& o) { look_at(o, {0.8f, 0.12f, -0.45f}, 5.5f), o.filter = "pcf_2x2", o.map_size = 512; }

void look_outdoors(options& o) {
    o.scene = built_in::outdoor;
    o.light = light_kind::cascades;
    o.azimuth = 60;
    o.camera_elevation = 4, o.camera_distance = 64, o.fov = 14;
    o.map_size = 2048;
    o.filter = "pcf_2x2";
}

}  // namespace

const std::array<trouble, 9>& troubles() {
    static const std::array<trouble, 9> all{
        trouble{"detached", "a constant bias, too large", "acne_free, the smallest", look_at_mast,
                [](options& o) { o.bias = "constant", o.reach = 12.0f; }, [](options&) {}},
        trouble{"acne", "no bias", "acne_free", [](options& o) { look_at_knot(o), o.map_size = 512; },
                [](options& o) { o.reach = 0.0f; }, [](options&) {}},
        trouble{"leak", "esm where things are close", "evsm4",
                [](options& o) {
                    look_at(o, {2.3f, 0.72f, 0.7f}, 6.5f), o.map_size = 1024, o.radius = 3;
                },
                [](options& o) { o.filter = "esm"; }, [](options& o) { o.filter = "evsm4"; }},
        trouble{"aliasing", "one map for a kilometer", "four cascades in as many texels", look_outdoors,
                [](options& o) { o.light = light_kind::directional; }, [](options&) {}},
        trouble{"seams", "cascades that do not overlap", "a tenth of each fades",
                [](options& o) {
                    look_at(o, {-0.7f, 0, -0.12f}, 9);
                    o.light = light_kind::cascades, o.fixed_range = true;
                    o.camera_distance = 5.5f, o.camera_elevation = 45;
                    o.map_size = 400, o.filter = "pcf_2x2";
                },
                [](options& o) { o.broken.no_fade = true; }, [](options&) {}},
        trouble{"contact", "a wide disc and normal_offset", "pcss32 and receiver_plane",
                [](options& o) {
                    look_at(o, {2.35f, 0.2f, 0.6f}, 7), o.map_size = 1024;
                },
                [](options& o) { o.filter = "disc32", o.radius = 8, o.bias = "normal_offset"; }, [](options&) {}},
        trouble{"shimmer", "tight cascades, a step later", "stable ones",
                [](options& o) { look_outdoors(o), o.marks_changes = o.fixed_range = true; },
                [](options& o) { o.broken.tight = true; }, [](options&) {}},
        trouble{"quantization", "9 bits, left out of the bias", "16 bits", look_at_knot,
                [](options& o) { o.encoding = "rg9", o.edge = umbrage::center<float>, o.broken.no_error = true; },
                [](options&) {}},
        trouble{"thin", "a bias for the widest penumbra", "receiver_plane",
                [](options& o) { look_at_fence(o), o.map_size = 512; }, [](options& o) { o.bias = "acne_free"; },
                [](options&) {}},
    };
    return all;
}

}  // namespace shadow_render
