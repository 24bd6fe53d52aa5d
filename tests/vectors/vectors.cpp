// SPDX-License-Identifier: MIT
//
// Test vectors: inputs of tier A functions and the bits that they return, from the parity suite's entries.
//
//     vectors FILE [COUNT]      writes them: COUNT inputs of each function and map, 48
//     vectors --check FILE      fails where FILE is not what it writes
//
// README.md beside it has the format.
#include <algorithm>
#include <bit>
#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iterator>
#include <regex>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "../parity/digest.hpp"
#include "../parity/domain.hpp"

namespace {

using namespace parity;

constexpr std::size_t default_count = 48;

/// Larger maps stay out, but for functions without a smaller one, and so do larger tables: the file is to be small.
constexpr std::size_t most_texels = 2048;

/// Hardware may read a denormal as 0, so no vector has one. NaN has one pattern, as its payload is nobody's promise.
float plain(float v) { return std::fpclassify(v) == FP_SUBNORMAL ? 0.0f : quiet(vec4(v)).x; }
vec4 plain(vec4 v) { return {plain(v.x), plain(v.y), plain(v.z), plain(v.w)}; }

std::string hex(float v) {
    char digits[9];
    std::snprintf(digits, sizeof digits, "%08" PRIx32, std::bit_cast<std::uint32_t>(v == 0.0f ? 0.0f : v));
    return digits;
}
std::string hex(const vec4& v) { return hex(v.x) + hex(v.y) + hex(v.z) + hex(v.w); }

std::string in_quotes(std::string_view text) { return '"' + std::string(text) + '"'; }

/// Components of x0 .. x5 that a call names: of a whole x0 all four. The x2 of pcf_2x2 is none of them.
std::vector<int> components(const std::string& call) {
    std::vector<int> named;
    for (int c = 0; c < 4 * max_inputs; ++c) {
        const std::string input = "\\bx" + std::to_string(c / 4);
        const std::regex used(input + "(\\." + "xyzw"[c % 4] + "|(?!\\.))\\b");
        if (std::regex_search(call, used)) named.push_back(c);
    }
    return named;
}

/// Maps of the file. Functions name them by their numbers.
class map_list {
public:
    std::size_t number_of(const texels& map) {
        const std::string wanted = line(map);
        const auto number = static_cast<std::size_t>(std::find(lines_.begin(), lines_.end(), wanted) - lines_.begin());
        if (number == lines_.size()) lines_.push_back(wanted);
        return number;
    }
    [[nodiscard]] const std::vector<std::string>& lines() const { return lines_; }

private:
    static std::string line(const texels& map) {
        std::string digits;
        for (const vec4& texel : map.texels()) digits += hex(texel);
        return "{\"size\": [" + std::to_string(map.size().x) + ", " + std::to_string(map.size().y) +
               "], \"texels\": " + in_quotes(digits) + "}";
    }
    std::vector<std::string> lines_;
};

/// True for functions whose vectors are in the file. A bound map returns what the plain one does, a target of bytes has
/// no floats to compare, and an own comparison is GLSL.
bool is_taken(const entry& e) {
    return e.exactness() == tier::a && e.bound.empty() && e.map_kind.compare.empty() && e.output == target::rgba32f &&
           e.table.texels().size() <= most_texels && !leaves_domain(e);
}

texels flushed(texels map) {
    for (vec4& texel : map.texels()) texel = plain(texel);
    return map;
}

std::vector<texels> maps_of(const entry& e) {
    std::vector<texels> kept;
    for (const texels& map : e.maps)
        if (map.texels().size() <= most_texels) kept.push_back(flushed(map));
    if (kept.empty() && !e.maps.empty())
        kept.push_back(flushed(*std::min_element(e.maps.begin(), e.maps.end(), [](const texels& a, const texels& b) {
            return a.texels().size() < b.texels().size();
        })));
    return kept;
}

struct result {
    std::string inputs;
    vec4 value;
};

/// What the entry's twin returns of a job's inputs.
void take(const job& j, const std::vector<int>& named, std::vector<result>& all) {
    for (std::size_t i = 0; i < j.count; ++i) {
        sample s = j.at(i);
        for (vec4& x : s.x) x = plain(x);
        const vec4 value = quiet(j.what->twin(s));
        bool subnormal = false;
        std::string inputs;
        for (int c = 0; c < 4; ++c) subnormal = subnormal || std::fpclassify(value[c]) == FP_SUBNORMAL;
        for (const int c : named) inputs += hex(s.x[static_cast<std::size_t>(c / 4)][c % 4]);
        if (!subnormal) all.push_back({inputs, value});
    }
}

std::string function(const entry& e, const texels* map, std::uint64_t serial, std::size_t count, map_list& maps) {
    const std::vector<int> named = components(e.call);
    std::vector<result> results;
    take(make_job(e, map, 0, count, serial), named, results);
    if (e.whole.count && serial == 0)
        take(make_whole_job(e, 0, std::min<std::size_t>(count, e.whole.count), 0), named, results);

    std::string arguments, vectors;
    for (const int c : named)
        arguments += (arguments.empty() ? "" : ", ") + in_quotes("x" + std::to_string(c / 4) + '.' + "xyzw"[c % 4]);
    const bool is_one = std::all_of(results.begin(), results.end(),
                                    [](const result& r) { return hex(r.value) == hex(vec4(r.value.x)); });
    for (const result& r : results)
        vectors += (vectors.empty() ? "" : ", ") + in_quotes(r.inputs + ' ' + (is_one ? hex(r.value.x) : hex(r.value)));

    std::string line = "{\"function\": " + in_quotes("umbrage_" + std::string(e.primitive->name)) +
                       ", \"name\": " + in_quotes(e.name()) + ", \"call\": " + in_quotes(e.call);
    if (e.map_kind.direction == umbrage::depth_direction::reversed) line += ", \"direction\": \"reversed\"";
    if (map)
        line += ", \"map\": " + std::to_string(maps.number_of(*map)) +
                ", \"outside\": " + (umbrage::glsl::detail::is_bordered(e.map_kind) ? "\"bordered\"" : "\"clamped\"");
    if (map && !e.map_kind.depth.empty()) line += ", \"depth\": " + in_quotes(e.map_kind.depth);
    if (e.table.size().x) line += ", \"table\": " + std::to_string(maps.number_of(e.table));
    return line + ", \"arguments\": [" + arguments + "],\n \"vectors\": [" + vectors + "]}";
}

std::string joined(const std::vector<std::string>& lines) {
    std::string all;
    for (const std::string& line : lines) all += (all.empty() ? "" : ",\n") + line;
    return all;
}

std::string file(std::size_t count) {
    map_list maps;
    std::vector<std::string> functions;
    for (entry e : entries()) {
        if (!is_taken(e)) continue;
        e.maps = maps_of(e);
        if (e.maps.empty()) functions.push_back(function(e, nullptr, 0, count, maps));
        for (const texels& map : e.maps)
            functions.push_back(function(e, &map, static_cast<std::uint64_t>(&map - e.maps.data()), count, maps));
    }
    return "{\"maps\": [\n" + joined(maps.lines()) + "\n],\n\"functions\": [\n" + joined(functions) + "\n]}\n";
}

}  // namespace

int main(int argc, char** argv) try {
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    if (arguments.empty() || arguments.size() > 2) throw std::runtime_error("usage: vectors [--check] FILE [COUNT]");
    if (arguments.front() == "--check") {
        std::ifstream in(arguments.back(), std::ios::binary);
        const std::string committed{std::istreambuf_iterator<char>(in), {}};
        if (committed == file(default_count)) return 0;
        std::fprintf(stderr, "vectors: %s is stale. Run: vectors %s\n", arguments.back().c_str(),
                     arguments.back().c_str());
        return 1;
    }
    std::ofstream out(arguments.front(), std::ios::binary);
    out << file(arguments.size() == 2 ? std::stoul(arguments.back()) : default_count);
    out.close();
    if (!out) throw std::runtime_error("cannot write " + arguments.front());
} catch (const std::exception& error) {
    std::fprintf(stderr, "vectors: %s\n", error.what());
    return 2;
}
