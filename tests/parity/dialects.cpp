// SPDX-License-Identifier: MIT
//
// Every snippet has an entry, and compiles in every dialect it claims:
//
//     dialects GLSLANG WEBGL1_CONF FOLDER
//
// GLSL 100 must also obey the limits of WebGL 1 (appendix A of the GLSL ES 1.00 specification): the reference compiler
// enforces them when the limits in WEBGL1_CONF say so. That it does is tested first, on shaders that break them.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <tuple>

#include <umbrage/registry.hpp>
#include <umbrage/shader/glsl.hpp>

#include "shader.hpp"
#include "backends/spirv.hpp"

namespace {

using namespace parity;
namespace fs = std::filesystem;

struct compiler {
    std::string glslang, webgl1;
    fs::path folder;

    static bool run(const std::string& command) { return std::system(command.c_str()) == 0; }
    static std::string quoted(const fs::path& path) { return "'" + path.string() + "'"; }

    static void write(const fs::path& path, const std::string& text) {
        std::ofstream file(path);
        if (!(file << text).flush()) throw std::runtime_error("cannot write " + path.string());
    }

    [[nodiscard]] bool accepts(const std::string& fragment, const std::string& limits = {}) const {
        const fs::path file = folder / "trial.frag";
        write(file, fragment);
        return run(quoted(glslang) + " " + limits + " " + quoted(file) + " > " + quoted(folder / "trial.log"));
    }

    /// All shaders of a dialect in one go; they share a vertex shader.
    [[nodiscard]] bool accepts(version v, const std::vector<const entry*>& all) const {
        const std::string dialect(directive(v));
        const fs::path place = folder / dialect;
        fs::remove_all(place);
        fs::create_directories(place);
        const fs::path vertex = place / "all.vert";
        write(vertex, make_shader(*all.front(), v).vertex);
        std::string files = quoted(vertex);
        for (const entry* e : all) {
            const fs::path file = place / (std::to_string(e - entries().data()) + ".frag");
            write(file, make_shader(*e, v).fragment);
            files += " " + quoted(file);
        }
        const fs::path script = place / "run.sh", log = place / "log.txt";
        const std::string limits = v == version::v100 ? quoted(webgl1) + " " : "";
        write(script, quoted(glslang) + " " + limits + files);
        if (run("sh " + quoted(script) + " > " + quoted(log) + " 2>&1")) return true;
        std::ifstream words(log);
        for (std::string line; std::getline(words, line);)
            if (line.find("ERROR") != std::string::npos || line.find("error") != std::string::npos)
                std::cout << line << '\n';
        std::cout << "REJECTED in " << dialect << "; numbers of files are those of entries, texts in " << place << '\n';
        return false;
    }
};

/// True when all entries compile to valid SPIR-V.
bool spirv_of(const std::vector<const entry*>& all) {
    const spirv_compiler c;
    bool good = true;
    const auto check = [&](const char* stage, const std::string& text) {
        try {
            std::ignore = c.compile(stage, text);
        } catch (const std::runtime_error& error) {
            good = false;
            std::cout << "REJECTED for Vulkan: " << error.what() << '\n';
        }
    };
    check("vert", make_shader(*all.front(), version::vulkan).vertex);
    for (const entry* e : all) check("frag", make_shader(*e, version::vulkan).fragment);
    return good;
}

/// Number of WebGL 1's rules that the compiler does not hold. The same body without a violation must pass.
int rules_without_teeth(const compiler& c) {
    const auto shader_of = [](const std::string& body) {
        return "#version 100\nprecision highp float;\nvarying vec2 p;\nuniform int n;\nvoid main() {\n    float s = "
               "0.0;\n"
               "    vec4 a = vec4(p, p);\n    " +
               body + "\n    gl_FragColor = vec4(s);\n}\n";
    };
    int wrong = 0;
    const auto expect = [&](bool good, const std::string& body) {
        if (c.accepts(shader_of(body), compiler::quoted(c.webgl1)) == good) return;
        ++wrong;
        std::cout << "WebGL 1's rules: should be " << (good ? "accepted: " : "rejected: ") << body << '\n';
    };
    expect(true, "for (int i = 0; i < 4; i++) { if (i >= n) break; s += a[i]; }");
    expect(false, "for (int i = 0; i < 4; ++i) s += a.x;");
    expect(false, "for (int i = 0; i < n; i++) s += a.x;");
    expect(false, "for (int i = n; i < 4; i++) s += a.x;");
    expect(false, "for (int i = 0; i < 4; i++) { s += a.x; i += 1; }");
    expect(false, "int i = 0; for (; i < 4; i++) s += a.x;");
    expect(false, "int i = 0; while (i < 4) { s += a.x; ++i; }");
    expect(false, "int i = 0; do { s += a.x; ++i; } while (i < 4);");
    expect(false, "float b[4]; b[0] = 1.0; s = b[n];");
    return wrong;
}

/// A preamble brings `precise` to GLSL 310 es by an extension, and by nothing else.
int precise_without_extension(const compiler& c) {
    int wrong = 0;
    for (const std::string extension : {"GL_EXT_gpu_shader5", "GL_OES_gpu_shader5", ""}) {
        const std::string asked = extension.empty() ? "" : "#extension " + extension + " : require\n";
        const std::string shader = source(version::v310_es, {umbrage::glsl::spot_cone},
                                          asked + "#define UMBRAGE_PRECISE precise\nprecision mediump float;\n");
        if (c.accepts(shader + "void main() {}\n") == !extension.empty()) continue;
        ++wrong;
        std::cout << "precise by \"" << extension << "\": should be " << (extension.empty() ? "rejected" : "accepted")
                  << '\n';
    }
    return wrong;
}

}  // namespace

int main(int argc, char** argv) try {
    int wrong = 0;
    for (const snippet* s : umbrage::glsl::registry()) {
        bool found = false;
        for (const entry& e : entries()) found = found || e.primitive == s || e.primitive->name == s->name;
        if (found) continue;
        ++wrong;
        std::cout << "no parity entry for " << s->name << '\n';
    }

    if (argc != 4) throw std::invalid_argument("three arguments");
    const compiler c{argv[1], argv[2], argv[3]};
    if (!fs::exists(c.glslang) || !spirv_compiler::is_here()) {
        std::cout << "SKIPPED: glslangValidator or glslang-dev is missing\n";
        return wrong ? 1 : 77;
    }
    fs::create_directories(c.folder);
    wrong += rules_without_teeth(c) + precise_without_extension(c);
    std::size_t shaders = 0;
    for (version v : umbrage::glsl::versions) {
        std::vector<const entry*> all;
        for (const entry& e : entries())
            if (e.runs_in(v)) all.push_back(&e);
        shaders += all.size();
        if (!(v == version::vulkan ? spirv_of(all) : c.accepts(v, all))) ++wrong;
    }
    std::cout << umbrage::glsl::registry().size() << " snippets, " << entries().size() << " entries, " << shaders
              << " shaders in " << umbrage::glsl::versions.size() << " dialects: " << wrong << " faults\n";
    return wrong ? 1 : 0;
} catch (const std::exception& error) {
    std::cerr << "dialects: " << error.what() << '\n';
    return 2;
}
