// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <stdexcept>
#include <string>

#include <umbrage/registry.hpp>
#include <umbrage/shader/msl.hpp>

#include "parts_of_text.hpp"

using namespace umbrage;

TEST_CASE("msl: a snippet as one would have written it") {
    CHECK(msl::text({glsl::false_color})
              .starts_with("// umbrage 0.1.0, MIT License: false_color\n" + bounds_note(glsl::false_color) +
                           std::string(msl::prelude)));
    CHECK(function_with_comment(msl::text({glsl::false_color}), "umbrage_false_color") ==
          R"(// umbrage_false_color: blue for 0.0, through green, to red for 1.0
inline float3 umbrage_false_color(float v) {
    float x = umbrage_saturate(v) * 4.0;
    float3 ramp = 1.5 - metal::abs(float3(x - 3.0, x - 2.0, x - 1.0));
    return float3(umbrage_saturate(ramp.x), umbrage_saturate(ramp.y), umbrage_saturate(ramp.z));
}
)");
}

TEST_CASE("msl: a filter's map is a texture, and one with a sampler where samplers compare") {
    const std::string plain = msl::text({glsl::hard});
    CHECK(plain.find("inline float umbrage_hard(metal::texture2d<float> map, float2 size, float2 coord, "
                     "float receiver) {\n") != plain.npos);
    CHECK(plain.find("    return map.read(uint2(texel));\n") != plain.npos);
    const std::string sun = msl::text({glsl::bind(glsl::hard, "sun", {.texture = glsl::texture::shadow_array})});
    CHECK(sun.find("    float lit = umbrage_lit_sun(map, map_sampler, layer, size, texel, receiver);\n") != sun.npos);
    CHECK(sun.find("map.sample_compare(map_sampler, (texel + 0.5) / size, uint(layer), receiver, metal::level(0.0))") !=
          sun.npos);
    const std::string lamp = msl::text({glsl::bind(glsl::hard, "lamp", {.texture = glsl::texture::cube})});
    CHECK(lamp.find("    return map.read(uint2(texel), uint(face));\n") != lamp.npos);
    CHECK(lamp.find("cube_direction") == lamp.npos);  // which other languages need
}

TEST_CASE("msl: columns of a matrix, and bits") {
    const std::string matrix = msl::text({glsl::shadow_coordinate}), bits = msl::text({glsl::encode_float_bits});
    CHECK(matrix.find("(metal::float4x4 m, float3 world)") != matrix.npos);
    CHECK(matrix.find("m[3] + m[0] * world.x +") != matrix.npos);
    CHECK(bits.find("uint bits = as_type<uint>(v);") != bits.npos);
}

TEST_CASE("msl: every snippet") {
    for (const glsl::snippet* s : glsl::registry()) {
        CAPTURE(s->name);
        const std::string text = msl::text({*s});
        for (const char* word : {"UMBRAGE_HIGHP", "UMBRAGE_MAP", "UMBRAGE_PRECISE", "vec2", "vec3", "vec4", "mat4"})
            CHECK(text.find(word) == text.npos);
    }
}

TEST_CASE("msl: before the first function every text forbids fast math, fused and reordered sums") {
    for (const glsl::snippet* s : glsl::registry()) {
        CAPTURE(s->name);
        const std::string text = msl::text({*s});
        const auto function = text.find("\ninline ");
        CHECK(text.find("\n#pragma METAL fp math_mode(safe)\n") < function);
        CHECK(text.find("\n#pragma METAL fp contract(off)\n") < function);
        CHECK(second_line_on(text).starts_with(bounds_note(*s)));
        CHECK(text.find("lets compilers") == text.npos);
    }
}

TEST_CASE("msl: every kind of map, and nothing of it left open") {
    using enum glsl::texture;
    for (const auto kind :
         {texture_2d, atlas, array, cube, cube_faces, integer, depth, depth_array, shadow, shadow_array})
        for (const bool gather : {false, true}) {
            if (gather && !glsl::detail::gathers(kind)) continue;
            CAPTURE(static_cast<int>(kind));
            const glsl::binding map{.texture = kind, .gather = gather, .texture_size = "float2(64.0, 64.0)"};
            const std::string text = msl::text({glsl::bind(glsl::pcf_2x2, "a", map)});
            for (auto at = text.find("UMBRAGE_"); at != text.npos; at = text.find("UMBRAGE_", at + 1))
                CHECK(text.substr(at, 12) == "UMBRAGE_HAS_");
            CHECK((text.find("ather") != text.npos) == gather);
        }
}

TEST_CASE("msl: what it has no word for") {
    constexpr glsl::snippet swirl{.name = "swirl", .source = "\nfloat umbrage_swirl(float v) { return dFdx(v); }\n"};
    CHECK_THROWS_WITH_AS((void)msl::text({swirl}),
                         "umbrage::msl::text: source must be of words that the language has; got \"dFdx\"",
                         std::invalid_argument);
    constexpr glsl::snippet half{.name = "half", .source = "\nfloat umbrage_half(float half) { return half; }\n"};
    CHECK_THROWS_AS((void)msl::text({half}), std::invalid_argument);
}
