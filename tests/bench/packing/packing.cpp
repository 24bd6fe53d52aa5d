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
#include <cstddef>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "codecs.hpp"
#include "mesa.hpp"

namespace {

using namespace packing;

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
    html << "<body><script>const programs = {vertex: " << quoted(vertex_shader) << ", truncate: " << quoted(truncating)
         << ", runs: [";
    for (const codec& c : all)
        for (const way& w : ways)
            html << "{truncates: " << w.truncates << ", encode: " << quoted(encoder(c, w))
                 << ", decode: " << quoted(decoder(c, w)) << "},";
    html << "]};\n" << read(script) << "</script></body>" << std::flush;

    const std::string command =
        "chromium --headless --no-sandbox --use-angle=swiftshader --enable-unsafe-swiftshader "
        "--disable-gpu-watchdog --dump-dom 'file://" +
        page + "' 2> swiftshader.log";
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
    std::puts(
        "Depths k / 2^24, k = 0 .. 2^24, through an 8-bit render target.\n"
        "bits: the worst error of a depth below 1 is 2^-bits; breaks: depths that decode below the one before.\n"
        "truncated: bits where the store cuts off, not rounds; mediump: bits where the host shader asks for it.");
    try {
        const mesa gl;
        std::vector<result> results;
        for (const codec& c : all)
            for (const way& w : ways) results.push_back(gl.run(c, w));
        print(gl.name(), all, results, tsv);
    } catch (const std::exception& e) { std::printf("\nllvmpipe is left out: %s\n", e.what()); }
    try {
        const auto [name, results] = swiftshader(all, argv[2]);
        print(name, all, results, tsv);
    } catch (const std::exception& e) { std::printf("\nSwiftShader is left out: %s\n", e.what()); }
} catch (const std::exception& e) {
    std::cerr << e.what() << '\n';
    return 1;
}
