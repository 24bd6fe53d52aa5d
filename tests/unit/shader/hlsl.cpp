// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <stdexcept>
#include <string>

#include <umbrage/registry.hpp>
#include <umbrage/shader/hlsl.hpp>

#include "parts_of_text.hpp"

using namespace umbrage;

TEST_CASE("hlsl: a snippet as one would have written it") {
    CHECK(hlsl::text({glsl::spot_cone}) == R"(// umbrage 0.1.0, MIT License: spot_cone
// spot_cone, tier B: within 11 x 2^-23 x S of the exact result.
// S is the formula with the magnitude of every value and a plus for every minus.
// Inside the bound, a comparison or floor may fall on either side.

#ifndef UMBRAGE_HAS_SPOT_CONE
#define UMBRAGE_HAS_SPOT_CONE
// umbrage_spot_cone: 1.0 inside the cone of a spot light, else 0.0
//   direction  of the light, unit length;   to_point  from the light, any length;   cos_outer  in [0, 1)
float umbrage_spot_cone(float3 direction, float3 to_point, float cos_outer) {
    precise float d = direction.x * to_point.x + direction.y * to_point.y + direction.z * to_point.z;
    precise float length2 = to_point.x * to_point.x + to_point.y * to_point.y + to_point.z * to_point.z;
    precise float edge2 = cos_outer * cos_outer * length2;
    precise float d2 = d * d;
    return d > 0.0 && d2 > edge2 ? 1.0 : 0.0;
}
#endif
)");
}

TEST_CASE("hlsl: a filter's map is a texture, and one with a sampler where samplers compare") {
    CHECK(function_with_comment(hlsl::text({glsl::hard}), "umbrage_hard") ==
          R"(// umbrage_hard: shadow test without a filter. Returns visibility, 1.0 = lit
//   map, size   shadow map and its size in texels
//   coord       receiver in texels. (0.5, 0.5) is the center of the first texel
//   receiver    receiver depth in [0, 1], bias applied
float umbrage_hard(Texture2D<float4> map, float2 size, float2 coord, float receiver) {
    bool compared = umbrage_in_filter_domain(coord, receiver);
    float2 texel = compared ? floor(coord) : float2(0.0, 0.0);  // no branch: fetches of several taps overlap
    float lit = umbrage_lit(map, size, texel, receiver);
    return compared ? lit : 1.0;
}
)");
    const std::string sun = hlsl::text({glsl::bind(glsl::hard, "sun", {.texture = glsl::texture::shadow_array})});
    CHECK(sun.find("    float lit = umbrage_lit_sun(map, map_sampler, layer, size, texel, receiver);\n") != sun.npos);
    CHECK(sun.find("float umbrage_hard_sun(Texture2DArray<float> map, SamplerComparisonState map_sampler, float layer, "
                   "float2 size,\n                       float2 coord, float receiver) {\n") != sun.npos);
}

TEST_CASE("hlsl: a column of a matrix, and bits") {
    const std::string matrix = hlsl::text({glsl::shadow_coordinate});
    CHECK(matrix.find("(float4x4 m, float3 world) {\n") != matrix.npos);
    CHECK(matrix.find("    precise float4 c = transpose(m)[3] + transpose(m)[0] * world.x +") != matrix.npos);
    const std::string bits = hlsl::text({glsl::encode_float_bits});
    CHECK(bits.find("uint bits = asuint(v);") != bits.npos);
}

TEST_CASE("hlsl: every snippet") {
    for (const glsl::snippet* s : glsl::registry()) {
        CAPTURE(s->name);
        const std::string text = hlsl::text({*s});
        for (const char* word : {"UMBRAGE_HIGHP", "UMBRAGE_MAP", "UMBRAGE_PRECISE", "vec2", "vec3", "vec4", "mat4"})
            CHECK(text.find(word) == text.npos);
    }
}

TEST_CASE("hlsl: precise stands wherever a snippet asks for it") {
    std::size_t variables = 0;
    for (const glsl::snippet* s : glsl::registry()) {
        CAPTURE(s->name);
        const auto asked = qualified(s->source.str(), "UMBRAGE_PRECISE ");
        if (!asked.empty()) CHECK(qualified(hlsl::detail::language<>.translate(*s), "    precise ") == asked);
        CHECK(second_line_on(hlsl::text({*s})).starts_with(bounds_note(*s) + "\n"));
        variables += asked.size();
    }
    CHECK(variables > 100);
}

TEST_CASE("hlsl: every kind of map, and nothing of it left open") {
    using enum glsl::texture;
    for (const auto kind :
         {texture_2d, atlas, array, cube, cube_faces, integer, depth, depth_array, shadow, shadow_array})
        for (const bool gather : {false, true}) {
            if (gather && !glsl::detail::gathers(kind)) continue;
            CAPTURE(static_cast<int>(kind));
            const glsl::binding map{.texture = kind, .gather = gather, .texture_size = "float2(64.0, 64.0)"};
            const std::string text = hlsl::text({glsl::bind(glsl::pcf_2x2, "a", map)});
            for (auto at = text.find("UMBRAGE_"); at != text.npos; at = text.find("UMBRAGE_", at + 1))
                CHECK(text.substr(at, 12) == "UMBRAGE_HAS_");
            CHECK((text.find("ather") != text.npos) == gather);
        }
}

TEST_CASE("hlsl: what it has no word for") {
    constexpr glsl::snippet swirl{.name = "swirl", .source = "\nfloat umbrage_swirl(float v) { return dFdx(v); }\n"};
    CHECK_THROWS_WITH_AS((void)hlsl::text({swirl}),
                         "umbrage::hlsl::text: source must be of words that the language has; got \"dFdx\"",
                         std::invalid_argument);
    constexpr glsl::snippet point{.name = "point", .source = "\nfloat umbrage_point(float point) { return point; }\n"};
    CHECK_THROWS_AS((void)hlsl::text({point}), std::invalid_argument);
    const glsl::binding tile{.texture = glsl::texture::shadow, .origin = "float2(64.0, 0.0)"};
    CHECK_THROWS_AS((void)hlsl::text({glsl::bind(glsl::hard, "tile", tile)}), std::invalid_argument);  // how large?
}
