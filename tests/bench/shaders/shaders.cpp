// SPDX-License-Identifier: MIT
//
// Cost of every snippet on AMD RDNA2, by Mesa's compiler and without the hardware. Shaders of three.js, Babylon.js and
// PlayCanvas for the same job are measured beside them.
//
//     shaders FOLDER PREFIX [--software]   FOLDER: from packing/peers.mjs; writes PREFIX.tsv, PREFIX.json
//
// Where the machine has a GPU, each is also timed over 3840 x 2160 pixels; --software times fewer on the CPU's Vulkan,
// as a check that this works. All numbers are of a whole fragment shader: inputs interpolated, result written to RGBA8;
// the row "nothing" is that alone. Constants are constants: a peer's parameter that means "off" is given as such.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <umbrage/shader/glsl.hpp>

#include "jobs.hpp"
#include "vulkan.hpp"

namespace {

namespace glsl = umbrage::glsl;
using bench::job;
using bench::shader;

std::string inputs(const char* way) {
    std::string text;
    for (int i = 0; i < 6; ++i)
        text += "layout(location = " + std::to_string(i) + ") " + way + " vec4 x" + std::to_string(i) + ";\n";
    return text;
}

bench::spirv compile(const std::string& text, const std::string& stage) {
    std::ofstream("shader." + stage) << text << std::flush;
    if (std::system((GLSLANG " -V -w --quiet -o shader.spv shader." + stage).c_str()) != 0)
        throw std::runtime_error("see shader." + stage);
    const std::string bytes = bench::read("shader.spv");
    bench::spirv code(bytes.size() / 4);
    bytes.copy(reinterpret_cast<char*>(code.data()), bytes.size());
    return code;
}

/// x0 is (u, v, depth, 1) over the target, x1 to x5 the same in texels. No depth that is the same everywhere: the
/// compiler would take it for a constant, as it takes what is equal for one input.
/// @param apart   as of job
bench::spirv vertex(bool apart) {
    std::string unrelated;
    for (int i = 0; apart && i < 6; ++i)
        unrelated +=
            "    x" + std::to_string(i) + " += sin(vec4(1.0, 2.0, 3.0, 4.0) * (x0.z + " + std::to_string(i) + ".0));\n";
    return compile("#version 450\n" + inputs("out") + R"GLSL(
void main() {
    vec2 corner = vec2(float(gl_VertexIndex / 2) * 2.0, float(gl_VertexIndex % 2) * 2.0);
    x0 = vec4(corner, corner.x * 0.25 + 0.25, 1.0);
    x1 = x2 = x3 = x4 = x5 = vec4(corner * 2048.0, x0.z, 1.0);
    gl_Position = vec4(corner * 2.0 - 1.0, 0.0, 1.0);
)GLSL" + unrelated + "}\n",
                   "vert");
}

bench::spirv fragment(const shader& s) {
    std::vector<glsl::bound> snippets = s.snippets;
    for (glsl::bound& item : snippets)  // what a border costs is a job of its own
        if (!item.declared && item.map == glsl::binding{}) item.map.outside = umbrage::outside_map::clamped;
    return compile(glsl::source(glsl::version::vulkan, snippets, s.preamble) + inputs("in") + R"GLSL(
layout(binding = 0) uniform sampler2D map;
layout(binding = 1) uniform sampler2D table;
layout(binding = 2) uniform sampler2DShadow depth_map;
layout(push_constant) uniform constants { vec2 map_size; };
layout(location = 0) out vec4 result;
void main() {
    result = )GLSL" + s.result +
                       ";\n}\n",
                   "frag");
}

/// Writes the lines of every measure, by shader, and for each peer the ratio to ours.
class table {
public:
    table(const std::string& prefix, std::vector<std::string> columns)
        : tsv_(prefix + ".tsv"), json_(prefix + ".json"), columns_(std::move(columns)) {
        tsv_ << "job\twhose\tshader";
        for (const std::string& c : columns_) tsv_ << '\t' << c;
        tsv_ << '\n';
    }
    void begin(const std::string& job) {
        job_ = job;
        ours_.clear();
        std::printf("\n%-18s %-46s", "", job.c_str());
        for (const std::string& c : columns_) std::printf(" %12.12s", c.c_str());
        std::puts("");
    }
    void add(const shader& s, const std::vector<double>& values) {
        std::printf("%-18s %-46s", s.owner.c_str(), s.name.c_str());
        tsv_ << job_ << '\t' << s.owner << '\t' << s.name;
        for (std::size_t i = 0; i < values.size(); ++i) {
            std::printf(" %12.6g", values[i]);
            tsv_ << '\t' << values[i];
            if (s.owner == "umbrage" || ours_.empty()) continue;
            json_ << R"({"name": ")" << job_ << R"(", "ours": )" << ours_[i] << R"(, "peer": )" << values[i]
                  << R"(, "peer_name": ")" << s.owner << ' ' << s.name << R"(", "unit": ")" << columns_[i]
                  << R"(", "ratio": )" << values[i] / ours_[i] << "}\n";
        }
        std::puts("");
        std::fflush(stdout);
        tsv_ << '\n';
        if (ours_.empty()) ours_ = values;
    }

private:
    std::ofstream tsv_, json_;
    std::vector<std::string> columns_;
    std::string job_;
    std::vector<double> ours_;
};

}  // namespace

int main(int argc, char** argv) try {
    if (argc < 3) throw std::runtime_error("usage: shaders FOLDER PREFIX [--software]");
    bench::device* const amd = bench::rdna2();
    const bool software = argc > 3 && std::string(argv[3]) == "--software";
    const std::vector<bench::device*> clocks = bench::gpus(software);
    const std::uint32_t width = software ? 480 : 3840, height = software ? 270 : 2160;
    const std::string statistics[] = {"Instructions", "Inverse Throughput", "Latency", "VGPRs", "SGPRs", "Code size"};
    std::vector<std::string> columns;
    if (amd) columns = {"instructions", "inv. thrpt", "latency", "VGPRs", "SGPRs", "bytes"};
    std::puts(amd ? ("Compiled for " + amd->name() + ", by Mesa. Less is better in every column.").c_str()
                  : "Mesa's driver for AMD is not here: nothing is compiled for RDNA2.");
    for (const bench::device* d : clocks) {
        columns.push_back("ms, " + d->name());
        std::printf("ms: a pass over %u x %u pixels on %s.\n", width, height, d->name().c_str());
    }
    if (columns.empty()) throw std::runtime_error("no Vulkan device: nothing to measure with");

    std::vector<job> all = bench::jobs(argv[1]);
    for (job& j : bench::soft(argv[1])) all.push_back(std::move(j));
    for (job& j : bench::shadows()) all.push_back(std::move(j));
    for (job& j : bench::whole(argv[1])) all.push_back(std::move(j));
    all.push_back(bench::outside());
    all.push_back(bench::registry());
    table out(argv[2], columns);
    const bench::spirv alike = vertex(false), apart = vertex(true);
    for (const job& j : all) {
        out.begin(j.name);
        const bench::spirv& corners = j.apart ? apart : alike;
        for (const shader& s : j.shaders) {
            const bench::spirv code = fragment(s);
            std::vector<double> values;
            if (amd) {
                const auto found = amd->statistics(corners, code);
                for (const std::string& name : statistics) {
                    values.push_back(NAN);
                    for (const auto& line : found)
                        if (line.name == name) values.back() = double(line.value);
                }
            }
            for (bench::device* d : clocks) values.push_back(d->milliseconds(corners, code, width, height));
            out.add(s, values);
        }
    }
} catch (const std::exception& e) {
    std::cerr << e.what() << '\n';
    return 1;
}
