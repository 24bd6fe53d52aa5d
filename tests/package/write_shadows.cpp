// SPDX-License-Identifier: MIT
//
// Expected shadows of the npm package, one case in JSON per line:  write_shadows FILE
#include <algorithm>
#include <array>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "languages.hpp"
#include "module_filters.hpp"
#include "shadows.hpp"

namespace package {
namespace {

constexpr glsl::version versions[]{glsl::version::v330, glsl::version::v300_es, glsl::version::v450,
                                   glsl::version::v100, glsl::version::v310_es};

#ifdef UMBRAGE_ALL_BUILDS
constexpr bool whole = true;
#else
constexpr bool whole = false;  // all types of shadows take a minute to compile
#endif

/// True for lights of one map alone: a sample has every filter and every encoding with them.
template <class Light>
constexpr bool has_one_map = std::is_same_v<std::decay_t<Light>, umbrage::light_space<float>>;

/// Result of text(), or null if it throws.
template <class Text>
std::string tried(const Text& text) {
    try {
        return literal(text());
    } catch (const std::invalid_argument&) { return "null"; }
}

/// An empty map's texel, as a color.
std::string cleared(const auto& of) {
    using texel = typename std::decay_t<decltype(of)>::texel;
    if constexpr (umbrage::known_encoding<std::decay_t<decltype(of.encoding())>>) {
        const auto channels = cleared_channels(of.encoding());
        std::string all;
        for (const cleared_channel& c : channels) all += (all.empty() ? "[" : ",") + quotient(c.value, c.most);
        return all + ']';
    } else if constexpr (std::is_same_v<texel, float>) return numbers({of.cleared(), 0, 0, 0});
    else if constexpr (texel::length() == 2) return numbers({of.cleared().x, of.cleared().y, 0, 0});
    else return numbers({of.cleared().x, of.cleared().y, of.cleared().z, of.cleared().w});
}

/// OpenGL's name of the format of a shadow's texture.
std::string format(const auto& of, const glsl::shadow_slots& slots) {
    using encoding = std::decay_t<decltype(of.encoding())>;
    if constexpr (umbrage::known_encoding<encoding>) {
        constexpr std::array depths{glsl::texture::depth, glsl::texture::depth_array, glsl::texture::shadow,
                                    glsl::texture::shadow_array};
        const bool is_depth = slots.map && std::ranges::find(depths, *slots.map) != depths.end();
        return std::string(is_depth ? encoding::target::depth_format : encoding::target::format);
    } else return format_of_moments<std::decay_t<decltype(of.filter())>>();
}

class writer {
public:
    explicit writer(std::ostream& out) : out_(out) {}

    /// One shadow: its texts, what its map is, and what its depth pass writes.
    void add(std::string_view kind, const auto& of, const glsl::shadow_slots& slots) {
        using encoding = std::decay_t<decltype(of.encoding())>;
        const glsl::version v = versions[count_++ % std::size(versions)];
        out_ << "{\"kind\":" << literal(kind) << ",\"filter\":" << literal(of.filter().snippet->name);
        if constexpr (umbrage::known_encoding<encoding>) out_ << ",\"encoding\":" << literal(encoding::name);
        const bool forward = of.encoding().direction == umbrage::depth_direction::forward;
        out_ << ",\"direction\":" << (forward ? "\"forward\"" : "\"reversed\"");
        for (const named_texture& t : textures)
            if (slots.map == t.kind) out_ << ",\"map\":" << literal(t.name);
        if (slots.debug) out_ << ",\"debug\":true";
        if (slots.derivatives) out_ << ",\"derivatives\":true";
        if (slots.gather) out_ << ",\"gather\":true";
        if (slots.linear) out_ << ",\"linear\":" << literal(glsl::linear_form_of(of.filter()).what->name);
        out_ << ",\"slots\":[" << slots.block << ',' << slots.texture << ',' << slots.sampler << ',' << slots.set
             << "],\"size\":[" << of.size().x << ',' << of.size().y << "],\"cleared\":" << cleared(of)
             << ",\"format\":" << literal(format(of, slots)) << ",\"bytes\":" << sizeof(of.uniforms())
             << ",\"version\":" << literal(directive(v))
             << ",\"texts\":{\"glsl\":" << tried([&] { return glsl::source(v, {glsl::bind(of, "sun", slots)}); })
             << ",\"pass\":" << tried([&] { return glsl::source(v, {glsl::bind_depth_pass(of, "sun")}); });
        for (const shader_language& l : languages)
            if (l.name != "glsl")
                out_ << ',' << literal(l.name) << ':' << tried([&] { return l.text({glsl::bind(of, "sun", slots)}); });
        out_ << ",\"pass_wgsl\":" << tried([&] { return umbrage::wgsl::text({glsl::bind_depth_pass(of, "sun")}); })
             << "}}\n";
    }

    /// Function that a shadow's depth pass calls for its vertices.
    void add_vertices(std::string_view kind, const auto& of, const umbrage::clip_space& clip) {
        const bool forward = clip.direction == umbrage::depth_direction::forward;
        const bool from_zero = clip.range == umbrage::depth_range::zero_to_one;
        out_ << "{\"kind\":" << literal(kind) << ",\"filter\":" << literal(of.filter().snippet->name)
             << ",\"slots\":[0,1,2,0],\"direction\":" << (forward ? "\"forward\"" : "\"reversed\"")
             << ",\"range\":" << (from_zero ? "\"zero_to_one\"" : "\"minus_one_to_one\"") << ",\"vertices\":{";
        std::string_view comma = "";
        for (const shader_language& l : languages) {
            out_ << comma << literal(l.name) << ':' << literal(l.text({glsl::bind_vertex_pass(of, "sun")}));
            comma = ",";
        }
        out_ << "}}\n";
    }

private:
    std::ostream& out_;
    std::size_t count_ = 0;
};

/// Every light with every filter, and with every kind of map.
void of_filters(writer& out, const umbrage::clip_space& clip) {
    for_each_light(clip, [&](std::string_view kind, const auto& light) {
        if constexpr (whole || has_one_map<decltype(light)>)
            for_each_shadow_filter(light, [&](const auto& filter) {
                out.add(kind, umbrage::shadow(light, glm::ivec2(shadow_size), filter), {});
            });
        const umbrage::shadow tent(light, glm::ivec2(shadow_size), umbrage::filters::tent<3>);
        const umbrage::shadow disc(light, glm::ivec2(shadow_size), umbrage::filters::disc{});
        for (const named_texture& t : textures) {
            out.add(kind, tent, {.block = 4, .texture = 5, .sampler = 6, .set = 1, .map = t.kind});
            out.add(kind, disc, {.map = t.kind});
            out.add(kind, tent, {.map = t.kind, .gather = true});
            out.add(kind, tent, {.map = t.kind, .linear = true, .debug = true});
            out.add(kind, disc, {.map = t.kind, .linear = true, .derivatives = true});
        }
    });
}

/// Spot lights and cascades in every encoding. One map lies in depth textures, too.
void of_encodings(writer& out, const umbrage::clip_space& clip) {
    for_each_light(clip, [&](std::string_view kind, const auto& light) {
        const auto add = [&](const auto& encoding) {
            const umbrage::shadow tent(light, glm::ivec2(shadow_size), umbrage::filters::tent<3>, encoding);
            out.add(kind, tent, {});
            if constexpr (has_one_map<decltype(light)>)
                for (const glsl::texture map : {glsl::texture::depth, glsl::texture::shadow})
                    out.add(kind, tent, {.map = map});
        };
        if constexpr (!bends<std::decay_t<decltype(light)>>)
            if (kind != "spot_light" && kind != "cascades") return;
        if constexpr (whole || has_one_map<decltype(light)>) umbrage::for_each_encoding(add);
        else add(umbrage::rg<11>{});
    });
}

/// Debug functions: each light with a filter of each kind, in an atlas and in layers, and each encoding.
void of_debug(writer& out, const umbrage::clip_space& clip) {
    for_each_light(clip, [&](std::string_view kind, const auto& light) {
        constexpr bool bent = bends<std::decay_t<decltype(light)>>;
        const auto add = [&](const auto& filter) {
            const umbrage::shadow of(light, glm::ivec2(shadow_size), filter);
            out.add(kind, of, {.debug = true});
            out.add(kind, of, {.map = glsl::texture::array, .derivatives = true, .debug = true});
        };
        add(umbrage::filters::tent<3>);
        add(umbrage::filters::disc{});
        add(umbrage::prefilters::vsm{});
        if constexpr (!bent) add(umbrage::filters::pcss{.softness = umbrage::make_penumbra_params(0.25f, 1.0f, 6.0f)});
        if constexpr (has_one_map<decltype(light)> || (whole && bent))
            if (bent || kind == "spot_light")
                umbrage::for_each_encoding([&](const auto& encoding) {
                    out.add(kind, umbrage::shadow(light, glm::ivec2(shadow_size), umbrage::filters::tent<3>, encoding),
                            {.debug = true});
                });
    });
}

void of_vertices(writer& out) {
    for_each_clip_space([&](std::string_view, const umbrage::clip_space& clip) {
        for_each_light(clip, [&](std::string_view kind, const auto& light) {
            const umbrage::shadow of(light, glm::ivec2(shadow_size), umbrage::filters::tent<3>);
            out.add_vertices(kind, of, clip);
        });
    });
}

/// Four shadows in one shader: a cascaded sun, two spots, one packed and one by a comparison sampler, and a cube.
template <class Use>
void with_four(const Use& use) {
    const umbrage::filters::window tent = umbrage::filters::tent<3>;
    const glm::ivec2 size(shadow_size);
    std::vector<glsl::bound> items;
    for_each_light(umbrage::cpu_clip_space, [&](std::string_view kind, const auto& light) {
        if (kind == "cascades")
            items.push_back(glsl::bind(umbrage::shadow(light, size, umbrage::filters::disc{}), "sun"));
        if (kind == "spot_light") {
            items.push_back(glsl::bind(umbrage::shadow(light, size, tent, umbrage::rg<11>{}), "packed",
                                       {.block = 3, .texture = 4}));
            items.push_back(glsl::bind(umbrage::shadow(light, size, tent), "compared",
                                       {.block = 5, .texture = 6, .sampler = 7, .map = glsl::texture::shadow}));
        }
        if (kind == "point_light")
            items.push_back(glsl::bind(umbrage::shadow(light, size, umbrage::filters::pcf_2x2{}), "cube",
                                       {.block = 8, .texture = 9, .map = glsl::texture::depth_array}));
    });
    use(items);
}

}  // namespace
}  // namespace package

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    std::ofstream file(argv[1], std::ios::binary);
    package::writer out(file);
    for (const umbrage::clip_space& clip : {umbrage::cpu_clip_space, umbrage::godot_clip_space}) {
        package::of_filters(out, clip);
        package::of_encodings(out, clip);
        package::of_debug(out, clip);
    }
    package::of_vertices(out);
    package::with_four([&](const std::vector<package::glsl::bound>& items) {
        file << "{\"four\":{\"glsl\":" << package::literal(package::glsl::source(package::glsl::version::v450, items));
        for (const package::shader_language& l : package::languages)
            if (l.name != "glsl") file << ',' << package::literal(l.name) << ':' << package::literal(l.text(items));
        file << "}}\n";
    });
    if (file) return 0;
    std::cerr << "write_shadows: cannot write " << argv[1] << '\n';
    return 1;
}
