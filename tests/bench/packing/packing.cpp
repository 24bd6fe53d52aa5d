// SPDX-License-Identifier: MIT
//
// Depth packers of three.js, Babylon.js and PlayCanvas, and ours, through the same 8-bit render target.
//
//     packing FOLDER swiftshader.js TABLE.tsv       FOLDER holds what peers.mjs writes
//
// Every depth k / 2^24, k = 0 .. 2^24, is written by a fragment shader to an RGBA8 texture and read back by another,
// with OpenGL ES 3 on Mesa's llvmpipe and with WebGL 2 on Chromium's SwiftShader, three ways:
//   rounds      the target's own store, which rounds to nearest on both
//   truncates   the writer's floats go to an RGBA32F texture, and floor(255 c) of them, c clamped, to the RGBA8 one:
//               a store that cuts off, as some hardware had, without any bias of the values written
//   mediump     the host shader says `precision mediump float`; llvmpipe computes that at 16 bits, SwiftShader at 32
#include <EGL/egl.h>
#include <EGL/eglext.h>
#define GL_GLES_PROTOTYPES 0
#include <GLES3/gl3.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <umbrage/shader/registry.hpp>

namespace {

constexpr int width = 4096, height = 1024;  // of the targets
constexpr int depths = 1 << 24;

// ---- what is compared ----------------------------------------------------------------------------------------------

struct codec {
    std::string name, writer, reader;  ///< whose each is
    std::string text;                  ///< GLSL functions
    std::string encode, decode;        ///< vec4 expression of `depth`; float expression of `c`
};

std::string read(const std::string& path) {
    std::ifstream file(path);
    std::stringstream text;
    text << file.rdbuf();
    if (!file || text.str().empty()) throw std::runtime_error("cannot read " + path);
    return text.str();
}

std::vector<codec> codecs(const std::string& folder) {
    namespace glsl = umbrage::glsl;
    const auto peer = [&](const std::string& name) { return read(folder + '/' + name + ".glsl"); };
    const auto version = [&](const std::string& name) { return name + ' ' + read(folder + '/' + name + ".version"); };
    const std::string three = version("three"), babylon = version("babylon"), playcanvas = version("playcanvas");
    const std::string us = "umbrage";
    const auto ours = [](std::initializer_list<glsl::snippet> s) { return glsl::text(s); };
    return {
        {"RGBA", three, three, peer("three"), "packDepthToRGBA(depth)", "unpackRGBAToDepth(c)"},
        {"RGB", three, three, peer("three"), "vec4(packDepthToRGB(depth), 1.0)", "unpackRGBToDepth(c.xyz)"},
        {"RG", three, three, peer("three"), "vec4(packDepthToRG(depth), 0.0, 1.0)", "unpackRGToDepth(c.xy)"},
        {"two halves", three, three, peer("three"), "pack2HalfToRGBA(vec2(depth))", "unpackRGBATo2Half(c).x"},
        {"base 255", babylon, babylon, peer("babylon"), "pack(depth)", "unpack(c)"},
        {"float bits", playcanvas, playcanvas, peer("playcanvas"), "float2uint(depth)", "uint2float(c)"},
        {"rg11", us, us, ours({glsl::to_unorm, glsl::encode_rg<11>, glsl::decode_rg<11>}),
         "vec4(umbrage_to_unorm(umbrage_encode_rg11(depth)), 0.0, 1.0)", "umbrage_decode_rg11(c.xy, 1.0)"},
        {"rg16", us, us, ours({glsl::to_unorm, glsl::encode_rg<16>, glsl::decode_rg<16>}),
         "vec4(umbrage_to_unorm(umbrage_encode_rg16(depth)), 0.0, 1.0)", "umbrage_decode_rg16(c.xy, 1.0)"},
        {"rg16, centre", us, us, ours({glsl::to_unorm, glsl::encode_rg<16>, glsl::decode_rg<16>}),
         "vec4(umbrage_to_unorm(umbrage_encode_rg16(depth)), 0.0, 1.0)", "umbrage_decode_rg16(c.xy, 0.5)"},
        {"rgb24", us, us, ours({glsl::to_unorm, glsl::encode_rgb24, glsl::decode_rgb24}),
         "vec4(umbrage_to_unorm(umbrage_encode_rgb24(depth)), 1.0)", "umbrage_decode_rgb24(c.xyz, 1.0)"},
        {"float bits", us, us, ours({glsl::to_unorm, glsl::encode_float_bits, glsl::decode_float_bits}),
         "umbrage_to_unorm(umbrage_encode_float_bits(depth))", "umbrage_decode_float_bits(c)"},
        {"RGBA", us, three, ours({glsl::write_threejs_rgba}) + peer("three"), "umbrage_write_threejs_rgba(depth)",
         "unpackRGBAToDepth(c)"},
        {"RGBA before r167, repaired", us, us,
         ours({glsl::to_unorm, glsl::encode_threejs_legacy_repaired, glsl::decode_threejs_legacy}),
         "umbrage_to_unorm(umbrage_encode_threejs_legacy_repaired(depth))", "umbrage_decode_threejs_legacy(c)"},
        {"base 255, repaired", us, babylon, ours({glsl::to_unorm, glsl::encode_base255_repaired}) + peer("babylon"),
         "umbrage_to_unorm(umbrage_encode_base255_repaired(depth)).wzyx", "unpack(c)"},
        {"base 255, repaired", us, us, ours({glsl::to_unorm, glsl::encode_base255_repaired, glsl::decode_base255}),
         "umbrage_to_unorm(umbrage_encode_base255_repaired(depth))", "umbrage_decode_base255(c)"},
        {"float bits", us, playcanvas, ours({glsl::to_unorm, glsl::encode_float_bits}) + peer("playcanvas"),
         "umbrage_to_unorm(umbrage_encode_float_bits(depth)).wzyx", "uint2float(c)"},
    };
}

/// What came back of all depths, in order.
struct result {
    double worst = 0.0;  ///< error of a depth below 1
    int breaks = 0;      ///< depths that decode below their predecessor
    float last = -INFINITY;
    int count = 0;

    void add(float decoded) {
        const double error = std::abs(decoded - double(count) / depths);
        if (count < depths && !(error <= worst)) worst = std::isnan(error) ? INFINITY : error;
        if (!(decoded >= last)) ++breaks;
        last = decoded;
        ++count;
    }
    [[nodiscard]] std::string bits() const {
        char text[32];
        std::snprintf(text, sizeof text, "%.2f", -std::log2(worst));
        return worst == 0.0 ? "exact" : worst >= 0.5 ? "lost" : text;
    }
    [[nodiscard]] std::string one() const {
        char text[32];
        std::snprintf(text, sizeof text, "%.9g", double(last));
        return text;
    }
};

/// The ways a codec is run: the host shader's precision, and the store.
struct way {
    std::string name, precision;
    bool truncates;
};
const way ways[] = {{"rounds", "highp", false}, {"truncates", "highp", true}, {"mediump", "mediump", false}};

// ---- shaders -------------------------------------------------------------------------------------------------------

const std::string vertex_shader = R"GLSL(#version 300 es
void main() {
    gl_Position = vec4(float(gl_VertexID / 2) * 4.0 - 1.0, float(gl_VertexID % 2) * 4.0 - 1.0, 0.0, 1.0);
}
)GLSL";

/// Writes a vec4 expression of `depth`, or of `c`, the texel in the same place.
std::string fragment_shader(const std::string& precision, const std::string& text, const std::string& expression) {
    return "#version 300 es\nprecision " + precision + " float;\nprecision " + precision + " int;\n" + text + R"GLSL(
uniform highp int first;
uniform highp sampler2D texels;
out highp vec4 result;
void main() {
    highp ivec2 at = ivec2(gl_FragCoord.xy);
    highp vec4 c = texelFetch(texels, at, 0);
    highp float depth = float(first + at.y * 4096 + at.x) * (1.0 / 16777216.0);
    result = )GLSL" + expression + ";\n}\n";
}
std::string encoder(const codec& c, const way& w) { return fragment_shader(w.precision, c.text, c.encode); }
std::string decoder(const codec& c, const way& w) {
    return fragment_shader(w.precision, c.text, "vec4(" + c.decode + ')');
}
const std::string truncating = fragment_shader("highp", "", "floor(clamp(c, 0.0, 1.0) * 255.0) / 255.0");

// ---- OpenGL ES 3 on llvmpipe --------------------------------------------------------------------------------------

#define PACKING_GL(X)                                                                                                 \
    X(ACTIVETEXTURE, ActiveTexture) X(ATTACHSHADER, AttachShader) X(BINDFRAMEBUFFER, BindFramebuffer)                  \
    X(BINDTEXTURE, BindTexture) X(CHECKFRAMEBUFFERSTATUS, CheckFramebufferStatus) X(COMPILESHADER, CompileShader)      \
    X(CREATEPROGRAM, CreateProgram) X(CREATESHADER, CreateShader) X(DELETEPROGRAM, DeleteProgram)                      \
    X(DISABLE, Disable) X(DRAWARRAYS, DrawArrays) X(FRAMEBUFFERTEXTURE2D, FramebufferTexture2D)                        \
    X(GENFRAMEBUFFERS, GenFramebuffers) X(GENTEXTURES, GenTextures) X(GETERROR, GetError)                              \
    X(GETPROGRAMINFOLOG, GetProgramInfoLog) X(GETPROGRAMIV, GetProgramiv) X(GETSHADERINFOLOG, GetShaderInfoLog)        \
    X(GETSHADERIV, GetShaderiv) X(GETSTRING, GetString) X(GETUNIFORMLOCATION, GetUniformLocation)                      \
    X(LINKPROGRAM, LinkProgram) X(READPIXELS, ReadPixels) X(SHADERSOURCE, ShaderSource) X(TEXIMAGE2D, TexImage2D)      \
    X(TEXPARAMETERI, TexParameteri) X(UNIFORM1I, Uniform1i) X(USEPROGRAM, UseProgram) X(VIEWPORT, Viewport)

class mesa {
public:
    mesa() {
        setenv("LIBGL_ALWAYS_SOFTWARE", "true", 1);
        setenv("GALLIUM_DRIVER", "llvmpipe", 1);
        setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
        const EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
        if (!display || !eglInitialize(display, nullptr, nullptr)) throw std::runtime_error("no EGL display");
        eglBindAPI(EGL_OPENGL_ES_API);
        const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_NONE};
        const EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, version);
        if (!context || eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) != EGL_TRUE)
            throw std::runtime_error("no OpenGL ES 3 context");
#define PACKING_LOAD(TYPE, NAME) NAME = reinterpret_cast<PFNGL##TYPE##PROC>(eglGetProcAddress("gl" #NAME));
        PACKING_GL(PACKING_LOAD)

        constexpr GLenum dither = 0x0BD0;  // on by default, would change bytes
        Disable(dither);
        GenTextures(3, textures_);
        GenFramebuffers(3, targets_);
        for (int i = 0; i < 3; ++i) {
            BindTexture(GL_TEXTURE_2D, textures_[i]);
            for (GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
                TexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
            TexImage2D(GL_TEXTURE_2D, 0, i == bytes ? GL_RGBA8 : GL_RGBA32F, width, height, 0, GL_RGBA,
                       i == bytes ? GL_UNSIGNED_BYTE : GL_FLOAT, nullptr);
            BindFramebuffer(GL_FRAMEBUFFER, targets_[i]);
            FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, textures_[i], 0);
            if (CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
                throw std::runtime_error("no float render targets");
        }
        Viewport(0, 0, width, height);
        truncate_ = link(truncating);
    }

    [[nodiscard]] std::string name() const { return reinterpret_cast<const char*>(GetString(GL_RENDERER)); }

    /// All depths through a codec.
    [[nodiscard]] result run(const codec& c, const way& w) const {
        const GLuint encode = link(encoder(c, w)), decode = link(decoder(c, w));
        std::vector<float> texels(std::size_t(4) * width * height);
        result all;
        for (int first = 0; first <= depths; first += width * height) {
            draw(encode, first, values, w.truncates ? written : bytes);
            if (w.truncates) draw(truncate_, first, written, bytes);
            draw(decode, first, bytes, values);
            const int count = std::min(width * height, depths + 1 - first);
            ReadPixels(0, 0, width, (count + width - 1) / width, GL_RGBA, GL_FLOAT, texels.data());
            if (const GLenum error = GetError()) throw std::runtime_error("GL error " + std::to_string(error));
            for (int i = 0; i < count; ++i) all.add(texels[std::size_t(4) * std::size_t(i)]);
        }
        DeleteProgram(encode);
        DeleteProgram(decode);
        return all;
    }

private:
    enum { bytes, written, values };  // targets

    void draw(GLuint program, int first, int from, int to) const {
        BindFramebuffer(GL_FRAMEBUFFER, targets_[to]);
        BindTexture(GL_TEXTURE_2D, textures_[from]);
        UseProgram(program);
        Uniform1i(GetUniformLocation(program, "first"), first);
        DrawArrays(GL_TRIANGLES, 0, 3);
    }

    [[nodiscard]] GLuint link(const std::string& fragment) const {
        const GLuint program = CreateProgram();
        char log[4096] = "";
        const std::pair<GLenum, const std::string*> stages[] = {{GL_VERTEX_SHADER, &vertex_shader},
                                                               {GL_FRAGMENT_SHADER, &fragment}};
        for (const auto& [kind, text] : stages) {
            const GLuint stage = CreateShader(kind);
            const char* source = text->c_str();
            GLint good = GL_FALSE;
            ShaderSource(stage, 1, &source, nullptr);
            CompileShader(stage);
            GetShaderiv(stage, GL_COMPILE_STATUS, &good);
            if (!good) GetShaderInfoLog(stage, sizeof log, nullptr, log);
            if (!good) throw std::runtime_error(log + *text);
            AttachShader(program, stage);
        }
        GLint good = GL_FALSE;
        LinkProgram(program);
        GetProgramiv(program, GL_LINK_STATUS, &good);
        if (!good) GetProgramInfoLog(program, sizeof log, nullptr, log);
        if (!good) throw std::runtime_error(log + fragment);
        return program;
    }

#define PACKING_DECLARE(TYPE, NAME) PFNGL##TYPE##PROC NAME = nullptr;
    PACKING_GL(PACKING_DECLARE)
    GLuint textures_[3]{}, targets_[3]{}, truncate_ = 0;
};

// ---- WebGL 2 on SwiftShader ----------------------------------------------------------------------------------------

std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (char c : text) {
        if (c == '\n') out += "\\n";
        else if (c == '\t') out += "\\t";
        else if (c == '"' || c == '\\') (out += '\\') += c;
        else if (c != '\r') out += c;
    }
    return out + '"';
}

/// The renderer's name, and every codec in every way, by Chromium without a window.
std::pair<std::string, std::vector<result>> swiftshader(const std::vector<codec>& all, const std::string& script) {
    const std::string page = std::filesystem::absolute("swiftshader.html");
    std::ofstream html(page);
    html << "<body><script>const programs = {vertex: " << quoted(vertex_shader)
         << ", truncate: " << quoted(truncating) << ", runs: [";
    for (const codec& c : all)
        for (const way& w : ways)
            html << "{truncates: " << w.truncates << ", encode: " << quoted(encoder(c, w))
                 << ", decode: " << quoted(decoder(c, w)) << "},";
    html << "]};\n" << read(script) << "</script></body>" << std::flush;

    const std::string command = "chromium --headless --no-sandbox --use-angle=swiftshader --enable-unsafe-swiftshader "
                                "--disable-gpu-watchdog --dump-dom 'file://" + page + "' 2> swiftshader.log";
    FILE* pipe = popen(command.c_str(), "r");
    std::string dom;
    for (int c = 0; pipe && (c = std::fgetc(pipe)) != EOF;) dom += static_cast<char>(c);
    if (pipe) pclose(pipe);
    const std::size_t begin = dom.find("<body>"), end = dom.find("</body>");
    if (begin == std::string::npos || end == std::string::npos || dom.find("<script") != std::string::npos)
        throw std::runtime_error("no chromium, or its WebGL failed: see swiftshader.log");
    std::istringstream lines(dom.substr(begin + 6, end - begin - 6));
    std::string name;
    std::getline(lines, name);
    std::vector<result> results;
    for (std::string worst, breaks, last; lines >> worst >> breaks >> last;)  // strings: streams read no inf
        results.push_back({std::stod(worst), std::stoi(breaks), std::stof(last), depths + 1});
    if (results.size() != all.size() * std::size(ways)) throw std::runtime_error("the page stopped half way: " + dom);
    return {name, results};
}

// ---- the table -----------------------------------------------------------------------------------------------------

void print(const std::string& name, const std::vector<codec>& all, const std::vector<result>& results,
           std::ostream& tsv) {
    std::printf("\n%s\n%-18s %-27s %-18s | %6s %6s %12s | %9s %6s | %7s %12s\n", name.c_str(), "writer", "format",
                "reader", "bits", "breaks", "1.0 becomes", "truncated", "breaks", "mediump", "1.0 becomes");
    for (std::size_t i = 0; i < all.size(); ++i) {
        const result *rounded = &results[3 * i], *truncated = rounded + 1, *medium = rounded + 2;
        const codec& c = all[i];
        std::printf("%-18s %-27s %-18s | %6s %6d %12s | %9s %6d | %7s %12s\n", c.writer.c_str(), c.name.c_str(),
                    c.reader.c_str(), rounded->bits().c_str(), rounded->breaks, rounded->one().c_str(),
                    truncated->bits().c_str(), truncated->breaks, medium->bits().c_str(), medium->one().c_str());
        for (std::size_t w = 0; w < std::size(ways); ++w)
            tsv << name << '\t' << c.writer << '\t' << c.name << '\t' << c.reader << '\t' << ways[w].name << '\t'
                << rounded[w].bits() << '\t' << rounded[w].breaks << '\t' << rounded[w].one() << '\n';
    }
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc != 4) throw std::runtime_error("usage: packing FOLDER swiftshader.js TABLE.tsv");
    const std::vector<codec> all = codecs(argv[1]);
    std::ofstream tsv(argv[3]);
    tsv << "implementation\twriter\tformat\treader\tway\tbits\tbreaks\tof 1.0\n";
    std::puts("Depths k / 2^24, k = 0 .. 2^24, through an 8-bit render target.\n"
              "bits: the worst error of a depth below 1 is 2^-bits; breaks: depths that decode below the one before.\n"
              "truncated: bits where the store cuts off, not rounds; mediump: bits where the host shader asks for it.");
    try {
        const mesa gl;
        std::vector<result> results;
        for (const codec& c : all)
            for (const way& w : ways) results.push_back(gl.run(c, w));
        print(gl.name(), all, results, tsv);
    } catch (const std::exception& e) {
        std::printf("\nllvmpipe is left out: %s\n", e.what());
    }
    try {
        const auto [name, results] = swiftshader(all, argv[2]);
        print(name, all, results, tsv);
    } catch (const std::exception& e) {
        std::printf("\nSwiftShader is left out: %s\n", e.what());
    }
} catch (const std::exception& e) {
    std::cerr << e.what() << '\n';
    return 1;
}
