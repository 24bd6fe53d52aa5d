// SPDX-License-Identifier: MIT
//
// umbrage-check: which function of umbrage a shader's function is, and with which slips. `usage` says how it is called.
#include <algorithm>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>

#include "backend.hpp"
#include "guest_text.hpp"

namespace {

using namespace check;

constexpr const char* usage =
    R"(Says which function of umbrage a shader's function is, and with which slips, by its results.

    umbrage-check FILE --call EXPRESSION [--is NAME] [--exact] [--json] [--kind filter|pack|unpack] [--on WHERE]
                  [--before TEXT] [--map UNIFORM] [--linear-map UNIFORM] [--shadow-map UNIFORM]
    umbrage-check --list

  FILE           .wgsl, .hlsl, else GLSL, by its #version
  --call         calls the function:  'shadow(map, uv, z)'  'pack(z)'  'vec4(pack_rg(z), 0.0, 0.0)'  'unpack(c)'
                   map, linear_map    the shadow map, read as it is or filtered: sampler2D, Texture2D, texture_2d<f32>
                   shadow_map         with comparison: sampler2DShadow, Texture2D, texture_depth_2d
                   ..._sampler        their samplers, in HLSL and WGSL
                   size, coord, uv    size in texels; the place in the map, in texels and from 0 to 1
                   z                  depth of the receiver, or the depth to pack
                   c                  the four channels to unpack, as sampled
  --is           what the function should be, one of --list; without it the answer is what it is
  --exact        exit status 0 only for the same bits
  --json         one object in place of lines
  --kind         filter where the call uses a map or uv, unpack where it uses c, else pack
  --on           llvmpipe, softpipe or hardware for GLSL, lavapipe for HLSL, naga for WGSL
  --before       text ahead of the file's, such as an engine's #defines
  --map and others   uniform of the file that is to be this map

Exit status: 0 the same but for rounding and edges, 1 another function, 2 called wrongly or it does not compile.
)";

struct options {
    guest_text guest{};
    expectation expected{};
    std::string on{}, kind{};
    bool json = false, exact = false, list = false;
};

/// Ends the program with status 2.
struct called_wrongly : std::runtime_error {
    using std::runtime_error::runtime_error;
};

std::string read(const std::string& file) {
    std::ifstream in(file);
    if (!in) throw called_wrongly("cannot read " + file);
    std::stringstream all;
    all << in.rdbuf();
    return all.str();
}

options parse(int argc, char** argv) {
    options o;
    for (int i = 1; i < argc; ++i) {
        const std::string_view word = argv[i];
        const auto value = [&]() -> std::string {
            if (++i == argc) throw called_wrongly(std::string(word) + " needs a value");
            return argv[i];
        };
        if (word == "--call") o.guest.call = value();
        else if (word == "--is") o.expected.is = value();
        else if (word == "--exact") o.exact = true;
        else if (word == "--json") o.json = true;
        else if (word == "--list") o.list = true;
        else if (word == "--kind") o.kind = value();
        else if (word == "--on") o.on = value();
        else if (word == "--before") o.guest.before = value();
        else if (word == "--map") o.guest.uniforms[0] = value();
        else if (word == "--linear-map") o.guest.uniforms[1] = value();
        else if (word == "--shadow-map") o.guest.uniforms[2] = value();
        else if (word.starts_with("--")) throw called_wrongly("there is no option " + std::string(word));
        else if (o.guest.file.empty()) o.guest.file = word;
        else throw called_wrongly("one file at a time, not " + std::string(word));
    }
    if (o.list) return o;
    if (o.guest.file.empty()) throw called_wrongly("which file?");
    if (o.guest.call.empty())
        throw called_wrongly("--call says how the function is called, such as 'shadow(map, uv, z)'");
    o.guest.text = read(o.guest.file);
    o.guest.in = dialect_of(o.guest.file, o.guest.text);
    o.guest.is = o.kind == "filter"   ? subject::filter
                 : o.kind == "pack"   ? subject::pack
                 : o.kind == "unpack" ? subject::unpack
                                      : subject_of(o.guest.call);
    const auto known = names(o.guest.is);
    if (const std::string& is = o.expected.is; !is.empty() && std::ranges::find(known, is) == known.end())
        throw called_wrongly("--is knows no " + is + " of this kind; --list has the names");
    return o;
}

void list() {
    for (const auto& [title, is] :
         {std::pair{"filters", subject::filter}, {"encodings, to pack and unpack", subject::pack}}) {
        std::cout << title << ":\n";
        for (const std::string& name : names(is)) std::cout << "    " << name << '\n';
    }
}

parity::backends backends_for(const options& o) {
    using parity::dialect;
    const auto or_else = [&](const char* usual) { return o.on.empty() ? std::string(usual) : o.on; };
    if (o.guest.in.in == dialect::hlsl) return parity::vulkan_backends(or_else("lavapipe"));
    if (o.guest.in.in == dialect::wgsl) return parity::vulkan_backends(or_else("naga"));
    if (o.guest.in.in == dialect::msl) throw called_wrongly("Metal cannot be run here");
    return parity::egl_backends(or_else("llvmpipe"));
}

verdict investigate(const options& o, parity::backend& on) {
    const parity::entry e = make_entry(o.guest);
    investigation question(o.guest.is, o.expected);
    std::uint64_t serial = 0;
    while (std::optional<batch> b = question.next()) {
        parity::texels map((glm::max)(b->size, glm::ivec2(1)));
        for (std::size_t i = 0; i < b->map.size(); ++i)
            map[{static_cast<int>(i) % b->size.x, static_cast<int>(i) / b->size.x}] = glm::vec4(b->map[i]);
        parity::job j{.what = &e, .classes = {}, .x = {}, .count = b->inputs.size(), .serial = ++serial};
        if (!e.maps.empty()) j.map = &map;
        j.x[0] = b->inputs;
        try {
            question.answer(on.run(o.guest.in, j, j.count));
        } catch (const std::runtime_error& error) { throw called_wrongly(explained(o.guest, e, error.what())); }
    }
    return question.result();
}

int run(const options& o) {
    const parity::backends all = backends_for(o);
    if (all.empty()) throw called_wrongly("nothing here runs " + parity::name(o.guest.in));
    parity::backend& on = *all.front();
    const auto dialects = on.dialects();
    if (std::ranges::find(dialects, o.guest.in) == dialects.end())
        throw called_wrongly(on.name() + " does not run " + parity::name(o.guest.in));
    const verdict v = investigate(o, on);
    if (o.json) std::cout << json(v) << '\n';
    else
        std::cout << o.guest.file << ": " << o.guest.call << "\n"
                  << text(v) << "  by " << on.name() << ", " << (o.guest.in.in == parity::dialect::glsl ? "GLSL " : "")
                  << parity::name(o.guest.in) << '\n';
    return v.how == agreement::same_bits || (v.how == agreement::same_but && !o.exact) ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const options o = parse(argc, argv);
        if (o.list) return list(), 0;
        return run(o);
    } catch (const called_wrongly& error) {
        std::cerr << "umbrage-check: " << error.what() << '\n';
        if (argc < 2) std::cerr << '\n' << usage;
        return 2;
    }
}
