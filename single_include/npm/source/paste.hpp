// SPDX-License-Identifier: MIT
//
// Files to paste, each with a head that says what its map must be, and headers to include:
//
// glsl/NAME.glsl, wgsl/NAME.wgsl   a snippet with all it needs
// NAME_shadow                      the same for a comparison sampler
// umbrage.hlsl, umbrage.metal      all of them in one header, each function guarded
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <umbrage/filter/prefiltered/prefilters.hpp>

#include "languages.hpp"

namespace package {

namespace fs = std::filesystem;
using glsl::snippet;

inline const std::string version = std::to_string(UMBRAGE_VERSION_MAJOR) + '.' + std::to_string(UMBRAGE_VERSION_MINOR) +
                                   '.' + std::to_string(UMBRAGE_VERSION_PATCH);

inline void write(const fs::path& path, const std::string& text) {
    fs::create_directories(path.parent_path());
    std::ofstream file(path, std::ios::binary);
    if (!(file << text)) throw std::runtime_error("cannot write " + path.string());
}

/// The line of LICENSE that says whose it is.
inline std::string copyright(const fs::path& license) {
    std::ifstream file(license);
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("Copyright")) return line;
    throw std::runtime_error("no copyright in " + license.string());
}

/// A line of comment, broken into several of at most 118 columns.
inline std::string comment(std::string text) {
    std::string out = "// ";
    for (std::size_t room = 115; text.size() > room; room = 113) {
        const auto end = text.rfind(' ', room);
        out += text.substr(0, end) + "\n//   ";
        text.erase(0, end + 1);
    }
    return out + text + '\n';
}

struct option {
    std::string_view field;
    glsl::hook first, last;  ///< the hooks of whose text it changes something
};
inline constexpr option options[]{{"texture", glsl::hook::texel, glsl::hook::depth_at},
                                  {"depth", glsl::hook::fetch_depth, glsl::hook::depth_at},
                                  {"outside", glsl::hook::fetch_depth, glsl::hook::depth_at},
                                  {"outside", glsl::hook::map_covers, glsl::hook::map_covers},
                                  {"compare", glsl::hook::compare, glsl::hook::compare},
                                  {"direction", glsl::hook::cleared_depth, glsl::hook::compare}};

/// Options of bind() that change the texts of items.
inline std::string options_of(const std::vector<glsl::bound>& items) {
    std::string out;
    for (const option& o : options)
        for (const glsl::bound& item : items) {
            const bool has_it =
                (o.field != "depth" && o.field != "compare") || !glsl::detail::compares(item.map.texture);
            if (has_it && glsl::detail::calls(item.what, o.first, o.last) && out.find(o.field) == out.npos)
                out += (out.empty() ? "" : ", ") + std::string(o.field);
        }
    return out.empty()
               ? out
               : comment("Other maps: bind() of the library or of its npm package prints this text, by " + out + '.');
}

inline const std::string target = " not sRGB, no blending, one sample. Clear to ";

/// The render targets of the encodings and prefiltered maps that a snippet writes or reads.
inline std::string targets_of(const snippet& s) {
    std::string out;
    umbrage::for_each_encoding([&](auto e) {
        using type = decltype(e);
        if constexpr (type::writes != umbrage::store_format::depth) {
            if (s != *type::writer && s != *type::reader) return;
            using kept = typename type::target;
            constexpr int most = (1 << kept::bits) - 1;
            const auto cleared = [&] {
                std::string all;
                const glm::vec4 values = kept::load(e.cleared());
                for (int c = 0; c < kept::channels; ++c)
                    all += (c > 0 ? ", " : "(") + std::to_string(std::lround(values[c] * most));
                return all + ") / " + std::to_string(most);
            };
            std::string line = "Render target of " + std::string(type::name) + ": " + std::string(kept::format) +
                               " UNORM," + target + cleared();
            e = {.direction = umbrage::depth_direction::reversed};
            line += ", with reversed depth to " + cleared() + ". Write ";
            const bool integers = type::writes == umbrage::store_format::integers;
            out += comment(line + (integers ? "umbrage_" + std::string(kept::to_unorm->name) + " of " : "") +
                           "umbrage_" + std::string(type::writer->name) + ".");
        }
    });
    umbrage::prefilters::all::for_each([&](const auto& p) {
        using type = std::decay_t<decltype(p)>;
        if (s != *type::writer && s != *type::snippet) return;
        const bool unorm = type::name == std::string_view("msm_unorm16");
        out += comment("Render target of " + std::string(type::name) + ": " + format_of_moments<type>() +
                       (unorm ? " UNORM," : ",") + target + "umbrage_" + std::string(type::writer->name) +
                       (unorm ? " of umbrage_encode_msm" : "") + " of the far plane's depth.");
    });
    return out;
}

/// Filters with a file for comparison samplers, which engines have.
inline constexpr std::array compared_by_samplers{&glsl::hard,
                                                 &glsl::pcf_2x2,
                                                 &glsl::box,
                                                 &glsl::tent<2>,
                                                 &glsl::tent<3>,
                                                 &glsl::castano<5>,
                                                 &glsl::castano<7>,
                                                 &glsl::disc<16>,
                                                 &glsl::pcf_2x2_hardware,
                                                 &glsl::window_hardware<3>,
                                                 &glsl::window_hardware<5>,
                                                 &glsl::window_hardware<7>,
                                                 &glsl::disc_hardware<16>};

/// Parameters of a function that stand for its map.
inline std::string parameters_of_map(const shader_language& l, glsl::texture kind) {
    std::string parameters(l.words->texture(kind).parameters);
    for (const std::string_view word : {"UMBRAGE_HIGHP ", "metal::"})
        for (auto at = parameters.find(word); at != parameters.npos; at = parameters.find(word))
            parameters.erase(at, word.size());
    return parameters;
}

/// Map that a snippet reads.
inline std::string map_of(const shader_language& l, const glsl::bound& item) {
    if (!glsl::detail::reads_map(item.what)) return "";
    const glsl::texture kind = item.map.texture;
    const std::string map = "Map: `" + parameters_of_map(l, kind) + "`, ";
    if (kind == glsl::texture::shadow) {
        const bool linear = item.what.name.find("hardware") != item.what.name.npos;
        return comment(map + "a depth texture. Its sampler passes receiver <= depth, clamps to the edge and filters " +
                       (linear ? "linearly." : "nearest.")) +
               comment("Render target of the map: depth attachment, one sample. Clear to 1.0.");
    }
    if (!glsl::detail::calls(item.what, glsl::hook::fetch_depth, glsl::hook::depth_at))
        return comment(map + "texels of the kind that the function's comment names, read unfiltered.");
    const bool has_file = std::ranges::count(compared_by_samplers, item.what.name, &snippet::name) > 0;
    const std::string file = " For a comparison sampler: " + std::string(item.what.name) + "_shadow.";
    return comment(map + "a depth in .x of each texel, 0.0 near and 1.0 far, read unfiltered." +
                   (has_file ? file : "")) +
           comment("Render target of the map: depth attachment, or R32F," + target +
                   "1.0, with reversed depth to 0.0.");
}

/// Text with a head in place of its first line.
inline std::string with_head(const shader_language& l, const std::string& copyright, const std::string& name,
                             std::string_view summary, const std::vector<glsl::bound>& items, const std::string& text) {
    const std::string note = glsl::detail::bounds_note(*l.words, items);
    std::string head = comment("umbrage " + version + ", " + name + ": " + std::string(summary) + ". Exactness: tier " +
                               "ABC"[static_cast<int>(glsl::exactness(items))] + '.');
    head += note;
    head += "// SPDX-License-Identifier: MIT\n";
    head += "// " + copyright + ". License text: LICENSE in the umbrage repository.\n";
    for (const glsl::bound& item : items) head += map_of(l, item) + targets_of(item.what);
    std::string rest = text.substr(text.find('\n') + 1);
    if (rest.starts_with(note)) rest.erase(0, note.size());
    return head + options_of(items) + rest;
}

struct pasted {
    std::string name;
    std::string_view summary;
    std::vector<glsl::bound> items;
};

/// Files for comparison samplers. A search for blockers reads depths of the same texture.
inline std::vector<pasted> for_comparison_samplers() {
    std::vector<pasted> all;
    const glsl::binding shadow{.texture = glsl::texture::shadow};
    for (const snippet* s : compared_by_samplers)
        all.push_back({std::string(s->name) + "_shadow", s->summary, {bind(*s, "shadow", shadow)}});
    all.push_back({"pcss_hardware16_shadow",
                   "percentage-closer soft shadows (PCSS) at 16 points, one texture bound to two samplers",
                   {glsl::disc_rotation, glsl::pcss_radius,
                    bind(glsl::blockers_hardware<16>, "depths", {.texture = glsl::texture::depth}),
                    bind(glsl::ellipse_hardware<16>, "shadow", shadow)}});
    return all;
}

/// Each function once, guarded: who includes it beside a pasted text, or one of bind(), has none twice.
inline std::string header_of(const shader_language& l, const std::string& copyright, const std::vector<pasted>& files) {
    std::vector<glsl::bound> items;
    std::string targets;
    for (const pasted& p : files) {
        items.insert(items.end(), p.items.begin(), p.items.end());
        for (const glsl::bound& item : p.items) {
            const std::string lines = targets_of(item.what);
            if (targets.find(lines) == targets.npos) targets += lines;
        }
    }
    const std::string text = l.text(items), note = glsl::detail::bounds_note(*l.words, items);
    const auto parameters = [&](glsl::texture kind) { return parameters_of_map(l, kind); };
    std::string head = comment("umbrage " + version + ": all functions in " + std::string(l.title) + ", to include.");
    head +=
        "// SPDX-License-Identifier: MIT\n// " + copyright + ". License text: LICENSE in the umbrage repository.\n//\n";
    head += comment(
        "Each function is guarded, and costs nothing where it is not called. Coordinates are in texels, not UV. "
        "Visibility is 1.0 when lit.");
    head += comment("Maps: `" + parameters(glsl::texture::texture_2d) +
                    "`, read unfiltered: a depth in .x, 0.0 near and 1.0 far, or what the function's comment names.");
    head +=
        comment("Names with _shadow: `" + parameters(glsl::texture::shadow) +
                "`, a depth texture. Its sampler passes receiver <= depth, clamps to the edge, and filters linearly "
                "for names with _hardware, else nearest.");
    head += comment(
        "Other maps: bind() of the library or of its npm package prints a function for an array, an atlas, a "
        "cube, packed or reversed depths, under a name of its own.");
    const std::string first = text.substr(0, text.find('\n') + 1);
    std::string rest = text.substr(first.size());
    if (rest.starts_with(note)) rest.erase(0, note.size());
    return head + "//\n" + targets + "//\n" + comment("Functions are exact, tier A, but for these:") + note + rest;
}

inline void write_shaders(const fs::path& folder, const std::string& copyright) {
    std::vector<pasted> files;
    for (const snippet* s : glsl::registry()) files.push_back({std::string(s->name), s->summary, {*s}});
    for (pasted& p : for_comparison_samplers()) files.push_back(std::move(p));
    for (const shader_language& l : languages) {
        const std::string extension(l.extension);
        if (l.of_headers) write(folder / ("umbrage" + extension), header_of(l, copyright, files));
        else
            for (const pasted& p : files)
                write(folder / l.name / (p.name + extension),
                      with_head(l, copyright, p.name, p.summary, p.items, l.text(p.items)));
    }
}

}  // namespace package
