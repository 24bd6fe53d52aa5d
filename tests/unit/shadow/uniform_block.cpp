// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cstddef>
#include <limits>
#include <vector>

#include <umbrage/shadow/shadow.hpp>
#include <umbrage/shadow/uniform_block.hpp>

#include "scene.hpp"

using namespace umbrage;

TEST_CASE("uniform_block: its fields are the setup's, softness and terms, one after the other") {
    using soft = shadow_uniforms<cascaded_maps<1>, 1>;
    using plain = shadow_uniforms<cascaded_maps<1>>;
    CHECK(offsetof(soft, softness) == sizeof(cascaded_maps<1>::uniforms));
    CHECK(offsetof(soft, terms) == sizeof(cascaded_maps<1>::uniforms) + sizeof(glm::mat4));
    CHECK(offsetof(plain, terms) == sizeof(cascaded_maps<1>::uniforms));
    CHECK(sizeof(soft) == sizeof(plain) + sizeof(glm::mat4));
    CHECK(sizeof(shadow<adaptive_maps, filters::pcss>::uniforms_type) ==
          sizeof(shadow_uniforms<adaptive_maps>) + 8 * sizeof(glm::mat4));
    CHECK(sizeof(shadow<cube_maps, filters::pcss>::uniforms_type) == sizeof(shadow_uniforms<cube_maps>));
}

TEST_CASE("uniform_block: each map has its softness, and terms have that of the first") {
    const shadow sun(shadow_scene::cascades<6>(cpu_clip_space), {256, 256}, shadow_scene::sized(filters::dpcf{}));
    const auto& u = sun.uniforms();
    CHECK(u.terms.filter_terms == glm::vec4(glm::vec2(u.softness[0][0]), 1, 64));  // radii in 1/16 texel
    for (int i = 0; i < 8; ++i) {
        const glm::vec4 column = u.softness[0][i / 2];
        const glm::vec2 of_map = i % 2 ? glm::vec2(column.z, column.w) : glm::vec2(column);
        CHECK((of_map.x > 0) == (i < 6));
        const penumbra_params own = detail::filter_of_map<cascaded_maps<2>>(sun.filter(), u, i).softness;
        CHECK(glm::vec2(own.per_code_x, own.per_code_y) == of_map);
        CHECK(own.light_size == 0);
    }
    CHECK(u.softness[0][0][0] > u.softness[0][2][2]);  // farther maps have larger texels
}

TEST_CASE("uniform_block: infinite or NaN numbers are refused") {
    const std::vector<float> good{1, 2}, infinite{1, std::numeric_limits<float>::infinity()};
    CHECK_NOTHROW(detail::require_finite_uniforms(good));
    CHECK_THROWS_WITH_AS(
        detail::require_finite_uniforms(infinite),
        "umbrage::shadow: light, filter and origin must be such that all uniforms are finite in float; "
        "got inf. Tiny near planes and huge coordinates overflow.",
        std::invalid_argument);
}
