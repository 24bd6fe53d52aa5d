// SPDX-License-Identifier: MIT
//
// Cost of every snippet on AMD RDNA2 in each language that compiles to SPIR-V, compared with its GLSL.
//
//     languages FILE.tsv [NODE NAGA.JS NODE_MODULES]   without the latter no WGSL
//
// The shaders are the parity tests': inputs fetched from textures, the call, the result written. WGSL through naga
// checks the bounds of every fetch: a snippet without a map shows what the language costs apart from that.
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iostream>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>

#include <backends/child.hpp>
#include <shader.hpp>
#include <backends/spirv.hpp>

#include "vulkan.hpp"

namespace {

struct cost {
    double instructions = NAN, inverse_throughput = NAN;
};

struct sum {
    double ours = 0, theirs = 0;
    int shaders = 0, within = 0;
    void add(const cost& glsl, const cost& other) {
        if (std::isnan(other.instructions)) return;
        ours += glsl.instructions;
        theirs += other.instructions;
        ++shaders;
        within += other.instructions <= glsl.instructions * 1.03;
    }
    void print(const char* what) const {
        if (shaders == 0) return;
        std::printf("%-28s %4d shaders, %6.0f instructions against %6.0f in GLSL: %.3f; %d within 3 %%\n", what,
                    shaders, theirs, ours, theirs / ours, within);
    }
};

class compilers {
public:
    compilers(bench::device& amd, std::unique_ptr<parity::child> naga)
        : amd_(amd),
          naga_(std::move(naga)),
          vertex_(glslang_.compile("vert",
                                   parity::make_shader(parity::entries().front(), parity::version::vulkan).vertex)) {}

    [[nodiscard]] cost glsl(const parity::entry& e) {
        return of(glslang_.compile("frag", parity::make_shader(e, parity::version::vulkan).fragment));
    }
    [[nodiscard]] cost hlsl(const parity::entry& e) {
        return of(glslang_.compile("frag", parity::make_hlsl(e), parity::spirv_compiler::hlsl));
    }
    [[nodiscard]] cost wgsl(const parity::entry& e) {
        if (!naga_) return {};
        const std::string module = naga_->answer(parity::make_wgsl(e));
        bench::spirv code(module.size() / 4);
        std::memcpy(code.data(), module.data(), module.size());
        return of(code);
    }

private:
    [[nodiscard]] cost of(const bench::spirv& fragment) {
        cost found;
        for (const bench::statistic& s : amd_.statistics(vertex_, fragment)) {
            if (s.name == "Instructions") found.instructions = static_cast<double>(s.value);
            if (s.name == "Inverse Throughput") found.inverse_throughput = static_cast<double>(s.value);
        }
        return found;
    }

    bench::device& amd_;
    std::unique_ptr<parity::child> naga_;
    parity::spirv_compiler glslang_;
    bench::spirv vertex_;
};

}  // namespace

int main(int argc, char** argv) try {
    if (argc != 2 && argc != 5) throw std::runtime_error("usage: languages FILE.tsv [NODE NAGA.JS NODE_MODULES]");
    bench::device* const amd = bench::rdna2();
    if (!amd) throw std::runtime_error("Mesa's driver for AMD is not here");
    compilers in(*amd, argc == 5 ? std::make_unique<parity::child>(std::vector<std::string>{argv[2], argv[3], argv[4]})
                                 : nullptr);
    std::ofstream tsv(argv[1]);
    tsv << "snippet\tGLSL instructions\tinv. thrpt\tHLSL instructions\tinv. thrpt\tWGSL instructions\tinv. thrpt\n";
    std::printf("Compiled for %s: instructions, inverse throughput\n%-28s %14s %14s %14s\n", amd->name().c_str(), "",
                "GLSL", "HLSL", "WGSL, naga");
    sum hlsl, wgsl_plain, wgsl_map;
    std::set<std::string> done;
    for (const parity::entry& e : parity::entries()) {
        if (!e.runs_in(parity::version::vulkan) || !e.variant.empty() || !done.insert(e.name()).second) continue;
        const cost costs[] = {in.glsl(e), in.hlsl(e), in.wgsl(e)};
        std::printf("%-28s", e.name().c_str());
        tsv << e.name();
        for (const cost& c : costs) {
            std::printf(" %7.0f %6.0f", c.instructions, c.inverse_throughput);
            tsv << '\t' << c.instructions << '\t' << c.inverse_throughput;
        }
        std::puts("");
        tsv << '\n';
        hlsl.add(costs[0], costs[1]);
        (e.maps.empty() && e.table.empty() ? wgsl_plain : wgsl_map).add(costs[0], costs[2]);
    }
    hlsl.print("HLSL");
    wgsl_plain.print("WGSL, snippets without a map");
    wgsl_map.print("WGSL, bounds checks included");
} catch (const std::exception& e) {
    std::cerr << e.what() << '\n';
    return 1;
}
