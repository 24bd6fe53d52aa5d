// SPDX-License-Identifier: MIT
//
// Setting up a frame's cascades.
#include <array>
#include <cmath>
#include <memory>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

#include <umbrage/light/cascades/cascades.hpp>
#include <umbrage/light/cascades/splits.hpp>

#include "bench.hpp"
#include "peers/glm.hpp"

namespace {

struct state {
    umbrage::cascade_fit<float> fit{.camera = {.position = {0, 2, 0}, .tan_half_x = 1.03f, .tan_half_y = 0.577f},
                                    .direction = glm::normalize(glm::vec3(0.3f, -1, 0.2f)),
                                    .scene = {{-600, 0, -1000}, {600, 10, 200}},
                                    .clip = umbrage::cpu_clip_space};
    std::array<float, 5> splits = umbrage::practical_splits<4>(0.5f, 1000.0f, 0.9f);
    std::array<umbrage::cascade<float>, 4> ours;
    std::array<glm::mat4, 4> theirs;
};

const bench::registration rows([] {
    const auto s = std::make_shared<state>();
    bench::add({.work = "set up four stable cascades",
                .peer = "GLM code, in floats",
                .ours =
                    [s] {
                        s->fit.camera.position.x += 0.1f;
                        s->ours = umbrage::make_stable_cascades<4>(s->fit, s->splits);
                    },
                .theirs =
                    [s] {
                        const umbrage::frustum<float>& c = s->fit.camera;
                        const auto view =
                            umbrage::look_along(c.position, c.direction, c.up, umbrage::handedness::right);
                        s->theirs = peers::glm_code::cascades(view, c.tan_half_x, c.tan_half_y, s->splits,
                                                              s->fit.direction, s->fit.map_size.x);
                    },
                .agree = [s] {  // theirs around the corners' mean, which is no better a middle
                    for (std::size_t i = 0; i < 4; ++i) {
                        const float ours = s->ours[i].scale.x / 512.0f;
                        const float theirs = glm::length(glm::vec3(glm::transpose(s->theirs[i])[0]));
                        if (!(ours > 0.95f * theirs && ours < 1.5f * theirs)) return false;
                    }
                    return true;
                }});
});

}  // namespace
