// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <umbrage/shadow/place_images.hpp>

#include "scene.hpp"

using namespace umbrage;

// Other filters and encodings: proof/every_shadow.
TEST_CASE("place_images: an image has the visibilities of its receivers alone, in every setup") {
    const glm::ivec2 size(100, 60);
    image<glm::vec3> points(size);
    for (glm::ivec2 p(0); p.y < size.y; ++p.y)
        for (p.x = 0; p.x < size.x; ++p.x) points[p] = {float(p.x) * 0.1f - 8, 0, float(p.y) * 0.1f - 4};
    const image<glm::vec3> normals(size, glm::vec3(0.1f, 1, 0.2f));
    shadow_scene::for_each_shadow(cpu_clip_space, filters::tent<3>, depth32f{}, [&](const auto& s) {
        const auto map = shadow_scene::drawn(s);
        image<float> out(size);
        s.visibility(map, points, normals, out);
        int wrong = 0, dark = 0;
        for (glm::ivec2 p(0); p.y < size.y; ++p.y)
            for (p.x = 0; p.x < size.x; ++p.x) {
                const float alone = s(map, points[p], normals[p]);
                wrong += out[p] != alone, dark += alone < 1;
            }
        CHECK(wrong == 0);
        CHECK(dark > 30);
    });
}
