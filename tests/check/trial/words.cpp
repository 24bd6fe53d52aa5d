// SPDX-License-Identifier: MIT
//
// What a user reads who did something wrong, and what follows from a file.
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "../program/inputs.hpp"
#include "on_software.hpp"

using namespace check;

namespace {

std::string words_of(const std::string& text, const std::string& call) {
    try {
        return check::text(of_glsl(text, call));
    } catch (const cannot_run& error) { return error.what(); }
}

bool says(const std::string& text, const std::string& what) { return text.find(what) != std::string::npos; }

}  // namespace

TEST_CASE("messages: the user's own lines, and what helps") {
    if (!llvmpipe()) return;
    const std::string good =
        "float shadow(sampler2D m, vec2 uv, float z) {\n    return z <= texture(m, uv).r ? 1.0 : 0.0;\n}\n";
    CHECK(says(words_of(good, "shadow(map, uv, z)"), "is hard"));
    CHECK(says(words_of("\n\nfloat shadow(sampler2D m) { return tixture(m, vec2(0.0)).r; }\n", "shadow(map)"),
               "guest.frag:3"));
    CHECK(says(words_of(good, "shadow(map, uv)"),
               "shadow takes 3 arguments, (sampler2D m, vec2 uv, float z); the call gives it 2"));
    CHECK(says(words_of(good, "shadowed(map, uv, z)"), "guest.frag has no function shadowed; it has shadow"));
    CHECK(says(words_of("// a\n#include <common>\n" + good, "shadow(map, uv, z)"),
               "line 2 needs another text, #include <common>"));
    CHECK(says(words_of(good, "shadow(map, uv, z"), "the call's brackets do not match"));
    CHECK(!says(words_of("float pack(vec4 c) { return c.x; }\n", "pack(z)"), "makes four"));
    CHECK(says(words_of("vec2 pack(float z) { return vec2(z); }\n", "pack(z)"),
               "vec4(pack(z), 0.0, 0.0) makes four of two"));
}

TEST_CASE("messages: Metal, whose text is compiled as C++") {
    if (!software(parity::dialect::msl)) return;
    const auto words = [](const std::string& text, const std::string& call) -> std::string {
        try {
            return check::text(of_text("guest.metal", text, call));
        } catch (const cannot_run& error) { return error.what(); }
    };
    const std::string good =
        "#include <metal_stdlib>\nusing namespace metal;\n"
        "struct Vertex { float4 position [[position]]; };\n"
        "float shadow(depth2d<float> m, float2 uv, float z) {\n"
        "    constexpr sampler s(filter::linear, address::clamp_to_edge, compare_func::less_equal);\n"
        "    return m.sample_compare(s, uv.xy, z);\n}\n"
        "fragment float4 scene(Vertex v [[stage_in]], depth2d<float> m [[texture(0)]], constant float4& p "
        "[[buffer(0)]]) {\n"
        "    return v.position.xyzw * shadow(m, p.xy / p.w, p.z);\n}\n";
    CHECK(says(words(good, "shadow(shadow_map, uv, z)"), "is pcf_2x2"));
    const std::string few = words(good, "shadow(shadow_map, uv)");
    CHECK(says(few, "the call:1:1: error: no matching function for call to"));
    CHECK(says(few, "shadow takes 3 arguments, (depth2d<float> m, float2 uv, float z); the call gives it 2"));
    CHECK(
        says(words(good, "shadowed(shadow_map, uv, z)"), "guest.metal has no function shadowed; it has shadow, scene"));
    CHECK(says(words(good, "shadow(uv, z)"), "a function of Metal takes its map as an argument"));
    CHECK(says(words(good + "float pack(float z) {\n    return tixture;\n}\n", "pack(z)"), "guest.metal:12:12: error"));
    CHECK(says(words("#include <metal_stdlib>\n#include \"Types.h\"\nfloat pack(float z) { return z; }\n", "pack(z)"),
               "line 2 needs another text, #include \"Types.h\""));
    CHECK(
        says(words("float2 pack(float z) { return float2(z); }\n", "pack(z)"), "float4(pack(z), 0.0, 0.0) makes four"));
    CHECK(says(words("half pack(half z) { return z; }\n", "pack(z)"), "--before '#define half float'"));
    CHECK(says(words("int pack(float z) { return 5 / int(z * 0.0); }\n", "pack(z)"), "divides an integer by 0"));
}

TEST_CASE("messages: Metal that never ends, and no files left") {
    if (!software(parity::dialect::msl)) return;
    const auto own = std::filesystem::temp_directory_path() / ("check_words_" + std::to_string(getpid()));
    const char* before = std::getenv("TMPDIR");
    const std::string folder = before ? before : "/tmp";
    create_directory(own);
    setenv("TMPDIR", own.c_str(), 1);
    metal_files files = metal_here();
    files.seconds = 1;
    const guest_text g{.file = "guest.metal",
                       .text = "float pack(float z) { while (z < 2.0) z = z * 1.0; return z; }\n",
                       .call = "pack(z)",
                       .is = subject::pack,
                       .in = parity::dialect::msl};
    std::string words;
    try {
        (void)investigate(g, {}, *metal_as_cpp(files));
    } catch (const cannot_run& error) { words = error.what(); }
    CHECK(says(words, "Does each of its loops end?"));
    CHECK(is_empty(own));
    setenv("TMPDIR", folder.c_str(), 1);
    remove_all(own);
}

TEST_CASE("messages: an engine's text without the engine's macros") {
    const std::string text =
        "#ifdef OLD\n#else\n#endif\n#if defined(SHADOWS)\n#define OF(name) sampler2D name\n"
        "float shadow(OF(map), vec2 uv, float z) { return z; }\n#endif\n";
    const std::string words = words_of(text, "shadow(map, uv, z)");
    CHECK(
        says(words, "shadow is compiled only if these hold, which --before can define: line 4: #if defined(SHADOWS)"));
    CHECK(!says(words, "has no function"));
}

TEST_CASE("messages: a map that nobody names") {
    const std::string text =
        "uniform sampler2D depths;\nuniform highp sampler2DShadow compared;\n"
        "float shadow(vec2 uv, float z) { return z <= texture(depths, uv).r ? 1.0 : 0.0; }\n";
    CHECK(says(words_of(text, "shadow(uv, z)"), "--map depths or --shadow-map compared"));
}

TEST_CASE("inputs of a fragment shader: uniforms, on their own lines; parameters stay") {
    CHECK(with_uniform_inputs("// in\nlayout(location = 0)\n  flat in vec3 a; in B {\n vec2 c; } d;\n") ==
          "// in\n\nuniform vec3 a;uniform B {\n vec2 c; } d;\n");
    const std::string others = "#define x in\nfloat f(in vec2 inner) { return inner.x; }\nuniform vec2 v;\n";
    CHECK(with_uniform_inputs(others) == others);
    if (!llvmpipe()) return;
    CHECK(says(words_of("#version 330\nin Varyings { vec3 normal; } given;\nin vec2 at;\nuniform sampler2D shadowMap;\n"
                        "float shadow(vec2 uv, float z) {\n"
                        "    return z - 0.25 * given.normal.x <= texture(shadowMap, uv + at).r ? 1.0 : 0.0;\n}\n",
                        "shadow(uv, z)"),
               "is hard"));
}

TEST_CASE("implementations: what a language needs that runs on none") {
    const auto words = [](parity::dialect in, const char* on) -> std::string {
        try {
            return implementation(in, on)->name();
        } catch (const cannot_run& error) { return error.what(); }
    };
    CHECK(words(parity::dialect::msl, "clang") == "--on for Metal must be one of: clang++, clang++-14, g++; got clang");
    const std::string path = std::getenv("PATH");
    setenv("PATH", "/nowhere", 1);
    CHECK(words(parity::dialect::msl, "") ==
          "Metal runs here as C++, and needs a compiler of it: no folder of PATH has a program clang++ or g++. Install "
          "one (Debian: clang or g++)");
    setenv("PATH", path.c_str(), 1);
    CHECK(words(parity::dialect::hlsl, "llvmpipe") == "--on for HLSL must be one of: lavapipe, hardware; got llvmpipe");
}

TEST_CASE("languages: by ending and #version") {
    using parity::version;
    CHECK(dialect_of("a.wgsl", "") == parity::dialect::wgsl);
    CHECK(dialect_of("a.hlsl", "") == parity::dialect::hlsl);
    CHECK(dialect_of("a.metal", "") == parity::dialect::msl);
    CHECK(dialect_of("a.msl", "") == parity::dialect::msl);
    CHECK(dialect_of("a.frag", "// x\n#version 300 es\n") == version::v300_es);
    CHECK(dialect_of("a.frag", "#version 450 core\n") == version::v450);
    CHECK(dialect_of("a.glsl", "float f(sampler2D s) { return texture2D(s, vec2(0.0)).r; }") == version::v120);
    CHECK(dialect_of("a.glsl", "float f(float x) { return x; }") == version::v330);
}

TEST_CASE("kinds: by what the call uses") {
    CHECK(subject_of("shadow(map, uv, z)") == subject::filter);
    CHECK(subject_of("ShadowCalculation(vec4(uv, z, 1.0))") == subject::filter);
    CHECK(subject_of("pack(z)") == subject::pack);
    CHECK(subject_of("unpack(c.abgr)") == subject::unpack);
}
