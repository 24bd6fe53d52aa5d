// SPDX-License-Identifier: MIT
//
// Whole shadows of three.js, Babylon.js and PlayCanvas, from a point x0 of the world with normal x2 to visibility. The
// functions are the packages' own. All of it is in the fragment shader, even if the engine has it in the vertex shader.
// An engine's uniforms are uniforms.
#include "jobs.hpp"

namespace bench {

namespace {

/// Adds shaders of one engine.
struct engine {
    std::string folder, name;
    whole_shaders& all;

    [[nodiscard]] std::string text(const std::string& file) const { return read(folder + '/' + file + ".glsl"); }
    void add(const std::string& job, const std::string& function, const std::string& preamble,
             const std::string& result) const {
        all.emplace(job, shader{name + ' ' + read(folder + '/' + name + ".version"), function, preamble, {}, result});
    }
};

std::string define(const std::vector<std::string>& words) {
    std::string all;
    for (const std::string& word : words) all += "#define " + word + '\n';
    return all;
}

// Its bias moves the point along the normal, in the vertex shader, and the depth.
void add_three(const engine& three) {
    const std::string functions = R"GLSL(
#define texture2D texture
#define textureCube texture
#define PI2 6.283185307179586
#define USE_SHADOWMAP
#define NUM_SUN_LIGHT_SHADOWS 1
#define NUM_POINT_LIGHT_SHADOWS 1
layout(binding = 7) uniform lights {
    mat4 view, matrix, sunShadowMatrix[2];
    vec4 sunShadowCascade[2];
    vec2 size;
    float intensity, bias, normal_bias, radius, z_near, z_far;
};
vec4 vSunShadowWorldPosition;
vec3 vSunShadowWorldNormal;
)GLSL" + three.text("three_shadow");
    const std::string hard = define({"SHADOWMAP_TYPE_BASIC"}) + functions,
                      five_taps = define({"SHADOWMAP_TYPE_PCF"}) + functions,
                      place = ", size, intensity, bias, radius, matrix * vec4(x0.xyz + x2.xyz * normal_bias, 1.0)";
    for (const std::string light : {"spot light", "directional light"}) {
        three.add(light + ", hard", "getShadow, basic", hard, "vec4(getShadow(map" + place + "))");
        three.add(light + ", tent<3>", "getShadow, 5 taps", five_taps, "vec4(getShadow(depth_map" + place + "))");
    }
    three.add("four cascades, tent<3>", "getSunShadow, 2 cascades, 5 taps", five_taps, R"GLSL(vec4(0.0);
    vSunShadowWorldPosition = vec4(x0.xyz, -(view * vec4(x0.xyz, 1.0)).z);
    vSunShadowWorldNormal = x2.xyz;
    SunLightShadow sun = SunLightShadow(intensity, bias, normal_bias, radius, size);
    result = vec4(getSunShadow(depth_map, sun, 0)))GLSL");
    const std::string in_cube = "vec4(getPointShadow(cube" + place + ", z_near, z_far))";
    three.add("cube, hard", "getPointShadow, basic", hard + "layout(binding = 5) uniform samplerCube cube;\n", in_cube);
    three.add("cube, tent<3>", "getPointShadow, 5 taps",
              five_taps + "layout(binding = 6) uniform samplerCubeShadow cube;\n", in_cube);
}

// Its bias is in the casters' depths.
void add_babylon(const engine& babylon) {
    const std::string functions = R"GLSL(
#define texture2D texture
#define textureCube texture
#define texture2DLodEXT textureLod
#define WEBGL2
#define SHADOWFLOAT
#define SHADOWS
#define SHADOW0
#define SHADOWONLY
#define LIGHT0
#define SHADOWCSMNUM_CASCADES0 4
struct light { vec4 vLightData, shadowsInfo; vec2 depthValues; };
layout(binding = 7) uniform lights {
    light light0;
    mat4 view, lightMatrix, lightMatrices[4];
    vec2 lightSizeUVCorrection0[4];
    float viewFrustumZ0[4], frustumLengths0[4], depthCorrection0[4], cascadeBlendFactor0, penumbraDarkness0;
};
)GLSL" + babylon.text("babylon_helpers") +
                                  babylon.text("babylon_shadow"),
                      result = R"GLSL(vec4(0.0);
    vec4 worldPos = vec4(x0.xyz, 1.0), vPositionFromCamera0 = view * worldPos;
    vec3 vPositionW = x0.xyz;
    float diff0 = 0.0, shadow = 1.0, globalShadow = 0.0, aggShadow = 0.0, shadowLightCount = 0.0, numLights = 0.0;
    int index0 = SHADOWCSMNUM_CASCADES0 - 1;
)GLSL" + babylon.text("babylon_light") +
                               "    result = vec4(shadow)";
    const auto add = [&](const std::string& job, const std::string& function, const std::string& textures,
                         std::vector<std::string> words) {
        if (job.starts_with("four cascades"))
            words.insert(words.end(), {"SHADOWCSM0", "vPositionFromLight0_at(i) (lightMatrices[i] * worldPos)",
                                       "vDepthMetric0_at(i) metric(vPositionFromLight0_at(i))"});
        else
            words.insert(words.end(),
                         {"vPositionFromLight0 (lightMatrix * worldPos)", "vDepthMetric0 metric(vPositionFromLight0)"});
        words.push_back("metric(at) ((at.z + light0.depthValues.x) / light0.depthValues.y)");
        babylon.add(job, function, define(words) + textures + functions, result);
    };
    const std::string map = "layout(binding = 0) uniform sampler2D shadowTexture0;\n",
                      compared = "layout(binding = 2) uniform sampler2DShadow shadowTexture0;\n",
                      depths = "layout(binding = 0) uniform sampler2D depthTexture0;\n",
                      layers = "layout(binding = 4) uniform sampler2DArrayShadow shadowTexture0;\n",
                      depth_layers = "layout(binding = 3) uniform sampler2DArray depthTexture0;\n",
                      cube = "layout(binding = 5) uniform samplerCube shadowTexture0;\n";
    const std::vector<std::string> one{"SHADOWPCF0", "SHADOWLOWQUALITY0"}, four{"SHADOWPCF0", "SHADOWMEDIUMQUALITY0"},
        nine{"SHADOWPCF0"}, soft{"SHADOWPCSS0", "SHADOWLOWQUALITY0"};
    for (const std::string light : {"spot light", "directional light"}) {
        add(light + ", hard", "computeShadow", map, {});
        add(light + ", hard", "computeShadowWithPCF1", compared, one);
        add(light + ", tent<3>", "computeShadowWithPCF3", compared, four);
        add(light + ", castano<5>", "computeShadowWithPCF5", compared, nine);
        add(light + ", pcss<16>", "computeShadowWithPCSS16", compared + depths, soft);
    }
    add("four cascades, hard", "computeShadowWithCSMPCF1", layers, one);
    add("four cascades, tent<3>", "computeShadowWithCSMPCF3", layers, four);
    add("four cascades, castano<5>", "computeShadowWithCSMPCF5", layers, nine);
    add("four cascades, pcss<16>", "computeShadowWithCSMPCSS16", layers + depth_layers, soft);
    add("cube, hard", "computeShadowCube", cube, {"SHADOWCUBE0"});
    add("cube, tent<3>", "computeShadowWithPoissonSamplingCube", cube, {"SHADOWCUBE0", "SHADOWPOISSON0"});
}

// Its bias moves the point along the normal.
void add_playcanvas(const engine& playcanvas) {
    const std::string functions = R"GLSL(
#define SHADOWMAP_ACCEPT(name) sampler2DShadow name
#define SHADOWMAP_PASS(name) name
#define textureShadow(name, at) texture(name, at)
#define saturate(v) clamp(v, 0.0, 1.0)
#define DIRECTIONAL 1
#define OMNI 2
#define SPOT 3
#define PUNCTUAL 4
#define PCF1_32F 5
#define PCF3_32F 6
#define PCF5_32F 7
#define LIGHT0SHAPE PUNCTUAL
#define LIGHT0CASTSHADOW
#define LIGHT0_SHADOW_SAMPLE_NORMAL_OFFSET
#define LIGHT0_SHADOW_SAMPLE_SOURCE_ZBUFFER
layout(binding = 7) uniform lights {
    mat4 light0_shadowMatrix, light0_shadowMatrixPalette[4];
    vec4 light0_shadowParams, light0_shadowCascadeDistances;
    vec3 light0_position, light0_direction;
    int light0_shadowCascadeCount;
    float light0_shadowCascadeBlend;
};
vec3 vPositionW, dLightDirNormW, dVertexNormalW;
)GLSL" + playcanvas.text("playcanvas_shadow") +
                                  playcanvas.text("playcanvas_light"),
                      result = R"GLSL(vec4(0.0);
    vPositionW = x0.xyz;
    dVertexNormalW = x2.xyz;
    vec3 way = vPositionW - light0_position;
    dLightDirNormW = normalize(way);
    result = vec4(getShadow0(way)))GLSL";
    const auto add = [&](const std::string& job, const std::string& function, const std::string& filter,
                         std::vector<std::string> words) {
        const std::string sampler = job.starts_with("cube") ? "samplerCubeShadow" : "sampler2DShadow",
                          binding = job.starts_with("cube") ? "6" : "2";
        words.push_back("LIGHT0SHADOWTYPE " + filter);
        playcanvas.add(
            job, function,
            define(words) + "layout(binding = " + binding + ") uniform " + sampler + " light0_shadowMap;\n" + functions,
            result);
    };
    const std::vector<std::string> spot{"LIGHT0TYPE SPOT"}, point{"LIGHT0TYPE OMNI", "LIGHT0_SHADOW_SAMPLE_POINT"},
        sun{"LIGHT0TYPE DIRECTIONAL", "LIGHT0_SHADOW_SAMPLE_ORTHO"};
    std::vector<std::string> cascades = sun, dithered = sun;
    cascades.push_back("LIGHT0_SHADOW_CASCADES");
    dithered.insert(dithered.end(), {"LIGHT0_SHADOW_CASCADES", "LIGHT0_SHADOW_CASCADE_BLEND"});
    const auto add_filter = [&](const std::string& filter, const std::string& size, const std::string& kind) {
        add("spot light, " + filter, "getShadowSpotPCF" + size, kind, spot);
        add("directional light, " + filter, "getShadowPCF" + size, kind, sun);
        add("four cascades, " + filter, "getShadowPCF" + size, kind, cascades);
        add("four cascades, " + filter, "getShadowPCF" + size + ", dithered", kind, dithered);
    };
    add_filter("hard", "1x1", "PCF1_32F");
    add_filter("tent<3>", "3x3", "PCF3_32F");
    add_filter("castano<5>", "5x5", "PCF5_32F");
    add("cube, hard", "getShadowOmniPCF1x1", "PCF1_32F", point);
    add("cube, tent<3>", "getShadowOmniPCF3x3, 4 taps", "PCF3_32F", point);
}

}  // namespace

whole_shaders engines(const std::string& folder) {
    whole_shaders all;
    add_three({folder, "three", all});
    add_babylon({folder, "babylon", all});
    add_playcanvas({folder, "playcanvas", all});
    return all;
}

}  // namespace bench
