// SPDX-License-Identifier: MIT
//
// Shaders of a path for Vulkan, in GLSL and in HLSL, around what the library prints.
#pragma once

#include <string>
#include <vector>

#include <umbrage/light/point/tetrahedron.hpp>
#include <umbrage/shader/glsl.hpp>
#include <umbrage/shader/hlsl.hpp>

#include "told.hpp"

namespace paths {

/// Texts of main and of all it needs. Vertices have position and normal at locations 0 and 1; a push constant holds the
/// matrix, the anchor and the number of the map. Block, map and sampler are bindings 0, 1 and 2 of set 0.
struct vulkan_texts {
    std::string depth_vertex, depth_fragment, view_vertex, view_fragment;
};

/// Statements of the depth pass' fragments, in both languages.
[[nodiscard]] inline std::string depth_statements(const job& j, const told& sun, const std::string& place,
                                                  const std::string& number) {
    std::string all;
    if (j.text("setup") == "tetrahedron_light")
        all = "if (umbrage_tetrahedron_face_of(floor(" + place + ".xy), " + std::to_string(sun.map_size.x) +
              ".0) != " + number + ") discard;";
    return is_depth(j) ? all : all + " color = umbrage_write_sun(" + place + ".z);";
}
[[nodiscard]] inline std::vector<umbrage::glsl::bound> depth_items(const job& j, const told& sun) {
    std::vector<umbrage::glsl::bound> all;
    if (j.text("setup") == "tetrahedron_light") all.emplace_back(umbrage::glsl::tetrahedron_face_of);
    if (!is_depth(j)) all.push_back(sun.write);
    return all;
}
[[nodiscard]] inline std::string vertex_call(const job& j, const std::string& from) {
    const std::string number = j.text("setup") == "dual_paraboloid_light" ? ", " + from + "number)" : ")";
    return "umbrage_vertex_sun(" + from + "to_clip, position, " + from + "anchor" + number;
}
[[nodiscard]] inline std::string view_call(const told& sun, const std::string& place) {
    const bool turns = sun.lookup.declared->functions[0].arguments.size() > 2;
    return "umbrage_sun(world, normal" + (turns ? ", " + place + ".xy)" : std::string(")"));
}

[[nodiscard]] inline vulkan_texts in_glsl(const job& j, const told& sun) {
    const auto text = [](const std::vector<umbrage::glsl::bound>& items) {
        return items.empty() ? std::string("#version 450\n")
                             : umbrage::glsl::source(umbrage::glsl::version::vulkan, items);
    };
    const std::string pass = "layout(push_constant) uniform pass_of { mat4 to_clip; vec4 anchor; float number; };\n",
                      in = "layout(location = 0) in vec3 position;\nlayout(location = 1) in vec3 vertex_normal;\n",
                      color = "layout(location = 0) out vec4 color;\n";
    return {
        text({sun.vertex}) + pass + in + "void main() { gl_Position = " + vertex_call(j, "") + "; }",
        text(depth_items(j, sun)) + pass + (is_depth(j) ? "" : color) + "void main() { " +
            depth_statements(j, sun, "gl_FragCoord", "number") + " }",
        text({}) + pass + in + "layout(location = 0) out vec3 world;\nlayout(location = 1) out vec3 normal;\n" +
            "void main() { gl_Position = to_clip * vec4(position, 1.0); world = position; normal = vertex_normal; }",
        text({sun.lookup}) + color + "layout(location = 0) in vec3 world;\nlayout(location = 1) in vec3 normal;\n" +
            "void main() { color = vec4(vec3(" + view_call(sun, "gl_FragCoord") + "), 1.0); }"};
}

[[nodiscard]] inline vulkan_texts in_hlsl(const job& j, const told& sun) {
    const auto text = [](const std::vector<umbrage::glsl::bound>& items) {
        return items.empty() ? std::string() : umbrage::hlsl::text(items);
    };
    const std::string pass =
                          "[[vk::push_constant]] cbuffer pass_of { column_major float4x4 to_clip; float4 anchor; "
                          "float number; };\n",
                      in = "(float3 position : POSITION, float3 vertex_normal : NORMAL)",
                      at = "float4 at : SV_Position", receiver = "float3 world : WORLD, float3 normal : NORMAL, ";
    return {text({sun.vertex}) + pass + "float4 main" + in + " : SV_Position { return " + vertex_call(j, "") + "; }",
            text(depth_items(j, sun)) + pass + "void main(" + at +
                (is_depth(j) ? "" : ", out float4 color : SV_Target") + ") { " +
                depth_statements(j, sun, "at", "number") + " }",
            pass + "struct corner { float3 world : WORLD; float3 normal : NORMAL; " + at + "; };\ncorner main" + in +
                " { corner c = { position, vertex_normal, mul(to_clip, float4(position, 1.0)) }; return c; }",
            text({sun.lookup}) + "float4 main(" + receiver + at +
                ") : SV_Target { float lit = " + view_call(sun, "at") + "; return float4(lit, lit, lit, 1.0); }"};
}

}  // namespace paths
