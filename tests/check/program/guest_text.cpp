// SPDX-License-Identifier: MIT
#include "guest_text.hpp"

#include <algorithm>
#include <regex>
#include <sstream>

#include "inputs.hpp"
#include "shader.hpp"
#include "wrapper.hpp"

namespace check {
namespace {

using parity::dialect;
using parity::version;
using umbrage::glsl::texture;

constexpr std::array maps{"map", "linear_map", "shadow_map"};

bool uses(const std::string& text, const std::string& word) {
    return std::regex_search(text, std::regex("\\b" + word + "\\b"));
}

/// The text without a #version, whose place is elsewhere, and without its lines being moved.
std::string without_version(const std::string& text) {
    return std::regex_replace(text, std::regex("(^|\n)[ \t]*#[ \t]*version[^\n]*"), "$1");
}

/// As it stands in the shader.
std::string own_text(const guest_text& g) {
    const std::string text = without_version(g.text);
    return g.in.in == dialect::glsl ? with_uniform_inputs(text) : text;
}

std::string name_of(const guest_text& g, std::size_t map) {
    if (!g.uniforms[map].empty()) return g.uniforms[map];
    return (g.in.in == dialect::wgsl ? "" : "umbrage_") + std::string(maps[map]);  // map is a name that texts have
}

/// Parts between commas that no bracket encloses.
std::vector<std::string> split(const std::string& list) {
    std::vector<std::string> all;
    std::string part;
    int depth = 0;
    for (char c : list) {
        depth += c == '(' || c == '[' || c == '<' ? 1 : c == ')' || c == ']' || c == '>' ? -1 : 0;
        if (c == ',' && depth == 0) all.push_back(std::move(part)), part.clear();
        else part += c;
    }
    if (part.find_first_not_of(" \t\n") != part.npos) all.push_back(part);
    return all;
}

/// From an opening bracket to the one that closes it.
std::string enclosed(const std::string& text, std::size_t open) {
    int depth = 0;
    for (std::size_t i = open; i < text.size(); ++i) {
        depth += text[i] == '(' ? 1 : text[i] == ')' ? -1 : 0;
        if (depth == 0) return text.substr(open + 1, i - open - 1);
    }
    return text.substr(open + 1);
}

struct function {
    std::string name, parameters;
    std::size_t at;  ///< in the text
};

std::vector<function> functions_of(const std::string& text, dialect::language in) {
    const std::regex definition(in == dialect::wgsl ? R"(\bfn\s+(\w+)\s*(\())" : R"(\b[A-Za-z_]\w*\s+(\w+)\s*(\())");
    std::vector<function> all;
    for (std::sregex_iterator i(text.begin(), text.end(), definition), end; i != end; ++i) {
        const auto at = static_cast<std::size_t>(i->position(2));
        const std::string parameters = enclosed(text, at);
        const std::size_t behind = text.find_first_not_of(" \t\r\n", at + parameters.size() + 2);
        const bool has_body = in == dialect::wgsl || (behind != text.npos && text[behind] == '{');
        if (has_body && (*i)[1] != "main" && (*i)[1] != "if" && (*i)[1] != "for")
            all.push_back({(*i)[1], parameters, at});
    }
    return all;
}

/// Conditions of the preprocessor around a place in a text, as "line 3: #ifdef SHADOWS".
std::string conditions_around(const std::string& text, std::size_t at) {
    std::vector<std::string> open;
    std::istringstream lines(text.substr(0, at));
    const std::regex directive(R"(^[ \t]*#[ \t]*(if|el|endif)(.*))");
    std::smatch found;
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        if (!std::regex_search(line, found, directive)) continue;
        if (found[1] != "if" && !open.empty()) open.pop_back();
        if (found[1] != "endif") open.push_back("line " + std::to_string(number) + ": " + line);
    }
    std::string all;
    for (const std::string& each : open) all += (all.empty() ? "" : ", ") + each;
    return all;
}

/// What is wrong with the call, told by the text's functions.
std::string hints(const guest_text& g, const std::string& log) {
    std::string all;
    const auto functions = functions_of(g.text, g.in.in);
    std::string known;
    for (const function& f : functions)
        if (!uses(known, f.name)) known += (known.empty() ? "" : ", ") + f.name;
    std::smatch called;
    if (std::regex_search(g.call, called,
                          std::regex(R"(\b(?!(?:vec|float|half|int|bool)[0-9f]*\b)([A-Za-z_]\w*)\s*(\())"))) {
        const std::string name = called[1];
        const std::size_t given = split(enclosed(g.call, static_cast<std::size_t>(called.position(2)))).size();
        bool found = false, fits = false;
        std::string takes;
        for (const function& f : functions) {
            if (f.name != name) continue;
            const std::size_t wants = split(f.parameters).size();
            found = true, fits |= wants == given;
            takes = std::to_string(wants) + " arguments, (" + f.parameters + ")";
            if (const std::string around = conditions_around(g.text, f.at); uses(log, name) && !around.empty())
                all += "hint: " + name + " is compiled only if these hold, which --before can define: " + around + '\n';
        }
        if (fits && std::regex_search(log, std::regex("vec4|float4|4-component")) &&
            !std::regex_search(log, std::regex("no matching (overloaded )?function"))) {
            const char* four = g.in == dialect::wgsl ? "vec4f" : g.in.in == dialect::glsl ? "vec4" : "float4";
            all += "hint: the call must give one number or four. " + std::string(four) + '(' + g.call +
                   ", 0.0, 0.0) makes four of two\n";
        }
        if (!found && !known.empty())
            all += "hint: " + g.file + " has no function " + name + "; it has " + known + '\n';
        if (!found && known.empty()) all += "hint: no function was found in " + g.file + '\n';
        if (found && !fits)
            all += "hint: " + name + " takes " + takes + "; the call gives it " + std::to_string(given) + '\n';
    }
    if (std::ranges::count(g.call, '(') != std::ranges::count(g.call, ')'))
        all += "hint: the call's brackets do not match\n";
    for (std::size_t k = 0; k < maps.size() && g.in.in != dialect::glsl; ++k) {
        const std::string& name = g.uniforms[k];
        if (!name.empty() && std::regex_search(g.text, std::regex("\\bTexture2D\\b[^;]*\\b" + name +
                                                                  "\\b|\\bvar\\b[^;]*\\b" + name + "\\s*:")))
            all += "hint: delete the declarations of " + name +
                   " and of its sampler: they are declared ahead of the text, as " + name + " and " + name +
                   "_sampler\n";
    }
    if (g.in == dialect::msl && uses(log, "half"))
        all += "hint: half is not computed here. --before '#define half float' computes in floats instead\n";
    std::smatch include;
    const std::regex of_include(R"((?:^|\n)[ \t]*(#[ \t]*(?:include(?![ \t]*<metal_)|import|pragma glslify)\b[^\n]*))");
    if (std::regex_search(g.text, include, of_include)) {
        const auto line = std::count(g.text.begin(), include[1].first, '\n') + 1;
        all += "hint: line " + std::to_string(line) + " needs another text, " + include[1].str() +
               ": put that text in its place, or run its preprocessor first\n";
    }
    return all;
}

/// Line of `source` at which `part` begins, counted from 0.
long line_of(const std::string& source, const std::string& part) {
    const auto at = source.find(part);
    return at == source.npos ? -1 : std::count(source.begin(), source.begin() + static_cast<long>(at), '\n');
}

}  // namespace

dialect dialect_of(const std::string& file, const std::string& text) {
    const auto ends = [&](const char* ending) { return file.ends_with(ending); };
    if (ends(".wgsl")) return dialect::wgsl;
    if (ends(".hlsl") || ends(".fx") || ends(".hlsli")) return dialect::hlsl;
    if (ends(".metal") || ends(".msl")) return dialect::msl;
    std::smatch said;
    if (std::regex_search(text, said, std::regex(R"((?:^|\n)[ \t]*#[ \t]*version[ \t]+(\d+)([ \t]+es)?)"))) {
        for (version v :
             {version::v100, version::v110, version::v120, version::v130, version::v150, version::v300_es,
              version::v310_es, version::v320_es, version::v330, version::v430, version::v450, version::v460})
            if (parity::name(v) == said[1].str() + (said[2].matched ? " es" : "")) return v;
        if (said[1] == "140") return version::v150;
        if (said[1] > "400") return version::v430;
    }
    return uses(text, "texture2D") || uses(text, "shadow2D") || uses(text, "varying") ? version::v120 : version::v330;
}

subject subject_of(const std::string& call) {
    for (const char* map : maps)
        if (uses(call, map)) return subject::filter;
    if (uses(call, "uv") || uses(call, "coord")) return subject::filter;
    return uses(call, "c") ? subject::unpack : subject::pack;
}

std::string unread_map(const guest_text& g) {
    const bool given = std::ranges::any_of(g.uniforms, [](const std::string& name) { return !name.empty(); });
    const bool read = std::ranges::any_of(maps, [&](const char* map) { return uses(g.call, map); });
    if (g.in == dialect::msl && (given || (reads_map(g.is) && !read)))
        return "a function of Metal takes its map as an argument: map, linear_map or shadow_map, as in --call "
               "'shadow(map, uv, z)'";
    if (!reads_map(g.is) || given || read) return {};
    std::string samplers;
    const std::regex declared(R"(\buniform\s+(?:\w+\s+)?sampler2D(Shadow)?\s+(\w+))");
    for (std::sregex_iterator i(g.text.begin(), g.text.end(), declared), end; i != end; ++i)
        samplers += (samplers.empty() ? ": " : " or ") + std::string((*i)[1].matched ? "--shadow-map " : "--map ") +
                    (*i)[2].str();
    return "the call reads none of map, linear_map and shadow_map. Say which uniform of " + g.file + " is the map" +
           (samplers.empty() ? ", by --map" : samplers);
}

parity::entry make_entry(const guest_text& g) {
    static constexpr parity::snippet nothing{.name = "guest", .summary = {}, .source = "\n"};
    parity::entry e;
    e.primitive = &nothing;
    e.call = reads_map(g.is) ? "umbrage_call(x0, map_size)" : "umbrage_call(x0)";
    e.preamble = g.in.in == dialect::glsl && parity::name(g.in).ends_with("es")
                     ? "precision highp float;\nprecision highp int;\n"
                     : "";
    if (g.in == version::v100) e.preamble = "precision highp float;\nprecision highp int;\n";
    parity::guest text{.text = begins(g, "--before") + g.before + '\n'};
    if (g.in.in == dialect::glsl) text.text += "#define varying uniform\n#define main umbrage_main_of_guest\n";
    text.text += begins(g, g.file) + own_text(g) + '\n';
    if (g.in.in == dialect::glsl) text.text += "#undef varying\n#undef main\n";
    if (reads_map(g.is)) {
        constexpr std::array kinds{texture::texture_2d, texture::texture_2d, texture::shadow};
        for (std::size_t k = 0; k < maps.size(); ++k) {
            if (k == 2 && g.in == version::v100) break;  // which has no such samplers
            e.bound.push_back({.name = name_of(g, k), .as = {.texture = kinds[k], .gather = true}, .linear = k > 0});
            if (!g.uniforms[k].empty()) text.declares.push_back(g.uniforms[k]);
            if (g.in.in == dialect::wgsl || g.in.in == dialect::msl) continue;
            text.text += "#define " + std::string(maps[k]) + ' ' + name_of(g, k) + '\n';
            if (g.in.in == dialect::hlsl)
                text.text += "#define " + std::string(maps[k]) + "_sampler " + name_of(g, k) + "_sampler\n";
        }
        e.maps.emplace_back(glm::ivec2(1, 1));
    }
    text.text += wrapper(g);
    e.visitor = std::move(text);
    return e;
}

std::string explained(const guest_text& g, const parity::entry& e, const std::string& message) {
    if (g.in == dialect::msl) return message + hints(g, message);  // whose lines are the file's own
    const std::string source = parity::make_shader(e, g.in).fragment;
    const std::string log = message.substr(0, message.find(source));
    const long first = line_of(source, own_text(g)), last = first + std::count(g.text.begin(), g.text.end(), '\n');
    const long call = line_of(source, '\n' + g.call + '\n') + 1;
    const std::regex place(R"((?:0:|wgsl:)(\d+)(?=[:(]))");  // Mesa and glslang; naga
    std::string all;
    auto from = log.begin();
    for (std::sregex_iterator i(log.begin(), log.end(), place), end; i != end; ++i) {
        all.append(from, (*i)[0].first);
        const long line = std::stol((*i)[1]) - 1;
        all += line >= first && line <= last ? g.file + ':' + std::to_string(line - first + 1)
               : line == call                ? "the call, " + g.call
                                             : "the shader around it, line " + std::to_string(line + 1);
        from = (*i)[0].second;
    }
    all.append(from, log.end());
    while (!all.empty() && all.back() == '\n') all.pop_back();
    return all + '\n' + hints(g, log);
}

}  // namespace check
