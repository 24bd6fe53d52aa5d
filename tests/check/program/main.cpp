// SPDX-License-Identifier: MIT
//
// umbrage-check: which function of umbrage a shader's function is, and with which slips. `usage` says how it is called.
#include <algorithm>
#include <charconv>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>

#include "runs.hpp"

namespace {

using namespace check;

constexpr const char* usage =
    R"(Says which function of umbrage a shader's function is, and with which slips, by its results.

    umbrage-check FILE --call EXPRESSION [--is NAME] [--exact] [--json] [--kind filter|pack|unpack|bound] [--on WHERE]
                  [--before TEXT] [--map UNIFORM] [--linear-map UNIFORM] [--shadow-map UNIFORM]
    umbrage-check FILE --call 'f(c.x, c.y)' --values TABLE [--ulps N] [--json] [--on WHERE] [--before TEXT]
    umbrage-check --list

  FILE           .wgsl, .hlsl, .metal or .msl, else GLSL, by its #version. Nothing here runs Metal: its text is compiled
                 as C++, which shows what it computes by IEEE's rules, not what a GPU makes of it
  --call         calls the function:  'shadow(map, uv, z)'  'pack(z)'  'unpack(c)'. It gives one number or four; a call
                 makes four of two: 'vec4(pack_rg(z), 0.0, 0.0)'. Its words:
                   map, linear_map    the shadow map, read as it is or filtered: sampler2D, Texture2D, texture_2d<f32>,
                                      texture2d<float>
                   shadow_map         with comparison: sampler2DShadow, Texture2D, texture_depth_2d, depth2d<float>
                   ..._sampler        their samplers, in HLSL, WGSL and Metal
                   size, coord, uv    size in texels; the place in the map, in texels and from 0 to 1
                   z                  depth of the receiver, or the depth to pack
                   c                  the four channels to unpack, as sampled
  --is           what the function should be, one of --list; without it the answer is what it is
  --exact        exit status 0 only for the same bits
  --json         one object in place of lines
  --kind         filter where the call uses a map or uv, unpack where it uses c, else pack. bound: a map's two channels
                 are moments of depths, as in a variance shadow map
  --values       any function against a table: rows of one to four arguments and what is expected, as CSV or JSON;
                 c.x, c.y, c.z and c.w are the arguments. 0x and eight digits are a float's bits
  --ulps         how far off a result may be, in units in the last place; 0
  --on           llvmpipe, softpipe or hardware for GLSL, lavapipe or hardware for HLSL, naga for WGSL; clang++ or g++,
                 which compiles Metal
  --before       text ahead of the file's, such as an engine's #defines
  --map, --linear-map, --shadow-map   the file's uniform that is to be this map, in GLSL, HLSL and WGSL

Exit status: 0 the same but for rounding and edges, 1 another function, 2 called wrongly or it does not compile.
)";

constexpr const char* metal_note = "  MSL was compiled as C++: by IEEE's arithmetic, not a GPU's\n";

struct options {
    guest_text guest{};
    expectation expected{};
    std::string on{}, kind{}, values{};
    std::uint64_t ulps = 0;
    bool json = false, exact = false, list = false;
};

std::string read(const std::string& file) {
    std::ifstream in(file);
    if (!in) throw cannot_run("cannot read " + file);
    std::stringstream all;
    all << in.rdbuf();
    return all.str();
}

std::uint64_t whole_number(const std::string& text) {
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size())
        throw cannot_run("--ulps must be a whole number, 0 or above; got " + text);
    return number;
}

subject kind_of(const std::string& word) {
    if (word == "filter") return subject::filter;
    if (word == "pack") return subject::pack;
    if (word == "unpack") return subject::unpack;
    if (word == "bound") return subject::bound;
    throw cannot_run("--kind must be one of: filter, pack, unpack, bound; got " + word);
}

options parse(int argc, char** argv) {
    options o;
    for (int i = 1; i < argc; ++i) {
        const std::string_view word = argv[i];
        const auto value = [&]() -> std::string {
            if (++i == argc) throw cannot_run(std::string(word) + " needs a value");
            return argv[i];
        };
        if (word == "--call") o.guest.call = value();
        else if (word == "--is") o.expected.is = value();
        else if (word == "--exact") o.exact = true;
        else if (word == "--json") o.json = true;
        else if (word == "--list") o.list = true;
        else if (word == "--kind") o.kind = value();
        else if (word == "--values") o.values = value();
        else if (word == "--ulps") o.ulps = whole_number(value());
        else if (word == "--on") o.on = value();
        else if (word == "--before") o.guest.before = value();
        else if (word == "--map") o.guest.uniforms[0] = value();
        else if (word == "--linear-map") o.guest.uniforms[1] = value();
        else if (word == "--shadow-map") o.guest.uniforms[2] = value();
        else if (word.starts_with("--"))
            throw cannot_run("there is no option " + std::string(word) + "; --help lists them");
        else if (o.guest.file.empty()) o.guest.file = word;
        else throw cannot_run("one file at a time, not " + std::string(word));
    }
    if (o.list) return o;
    if (o.guest.file.empty()) throw cannot_run("which file?");
    if (o.guest.call.empty()) throw cannot_run("--call says how the function is called, such as 'shadow(map, uv, z)'");
    o.guest.text = read(o.guest.file);
    o.guest.in = dialect_of(o.guest.file, o.guest.text);
    o.guest.is = o.kind.empty() ? subject_of(o.guest.call) : kind_of(o.kind);
    if (!o.values.empty()) o.guest.is = subject::unpack;  // four numbers in, no map
    const auto known = names(o.guest.is);
    if (const std::string& is = o.expected.is; !is.empty() && std::ranges::find(known, is) == known.end())
        throw cannot_run("--is knows no " + is + " of this kind; --list has the names");
    return o;
}

void list() {
    for (const auto& [title, is] : {std::pair{"filters", subject::filter},
                                    {"encodings, to pack and unpack", subject::pack},
                                    {"bounds by moments, of --kind bound", subject::bound}}) {
        std::cout << title << ":\n";
        for (const std::string& name : names(is)) std::cout << "    " << name << '\n';
    }
}

int compare(const options& o, parity::backend& on) {
    std::string error;
    const value_table table = read_table(read(o.values), error);
    if (!error.empty()) throw cannot_run(o.values + ": " + error);
    const value_verdict v = compare_values(o.guest, table, o.ulps, on);
    if (o.json) std::cout << json(v, o.ulps) << '\n';
    else
        std::cout << o.guest.file << ": " << o.guest.call << '\n'
                  << text(v, o.ulps) << (o.guest.in == parity::dialect::msl ? metal_note : "");
    return v.within == v.inputs ? 0 : 1;
}

int run(const options& o) {
    const auto implementation = check::implementation(o.guest.in, o.on);
    parity::backend& on = *implementation;
    if (!o.values.empty()) return compare(o, on);
    const verdict v = investigate(o.guest, o.expected, on);
    if (o.json) std::cout << json(v) << '\n';
    else
        std::cout << o.guest.file << ": " << o.guest.call << "\n"
                  << text(v) << "  by " << on.name() << ", " << (o.guest.in.in == parity::dialect::glsl ? "GLSL " : "")
                  << parity::name(o.guest.in) << '\n'
                  << (o.guest.in == parity::dialect::msl ? metal_note : "");
    return v.how == agreement::same_bits || (v.how == agreement::same_but && !o.exact) ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        if (argc == 2 && std::string_view(argv[1]) == "--help") return std::cout << usage, 0;
        const options o = parse(argc, argv);
        if (o.list) return list(), 0;
        return run(o);
    } catch (const cannot_run& error) {
        std::cerr << "umbrage-check: " << error.what() << '\n';
        if (argc < 2) std::cerr << '\n' << usage;
        return 2;
    }
}
