// SPDX-License-Identifier: MIT
//
// Writes what the npm package's texts must be, a case in JSON a line:  write_expected FILE
#include <fstream>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <vector>

#include <umbrage/light/spot_light.hpp>
#include <umbrage/shadow/depth_pass.hpp>

#include "languages.hpp"

namespace package {
namespace {

using glsl::bound;
using glsl::snippet;

std::string json(const glsl::binding& map) {
    std::string out = "{";
    const auto add = [&](std::string_view name, const std::string& value) {
        out += (out.size() > 1 ? "," : "") + literal(name) + ":" + value;
    };
    for (const named_texture& t : textures)
        if (t.kind == map.texture) add("texture", literal(t.name));
    add("direction", map.direction == umbrage::depth_direction::forward ? "\"forward\"" : "\"reversed\"");
    if (map.outside) add("outside", *map.outside == umbrage::outside_map::bordered ? "\"bordered\"" : "\"clamped\"");
    add("gather", map.gather ? "true" : "false");
    add("depth", literal(map.depth));
    add("channels", std::to_string(map.channels));
    add("compare", literal(map.compare));
    add("receiver_plane", map.receiver_plane ? "true" : "false");
    add("origin", literal(map.origin));
    add("texture_size", literal(map.texture_size));
    add("parameters", literal(map.parameters));
    add("arguments", literal(map.arguments));
    add("texel", literal(map.texel));
    std::string needs;
    for (const snippet& need : map.needs) needs += (needs.empty() ? "" : ",") + literal(need.name);
    add("needs", '[' + needs + ']');
    return out + '}';
}

std::string json(const std::vector<bound>& items) {
    std::string out;
    for (const bound& item : items) {
        out += (out.empty() ? "" : ",") + std::string("{\"what\":") + literal(item.what.name);
        if (!item.suffix.empty() || !(item.map == glsl::binding{}))
            out +=
                ",\"name\":" + literal(item.suffix.empty() ? "" : item.suffix.substr(1)) + ",\"map\":" + json(item.map);
        out += '}';
    }
    return '[' + out + ']';
}

/// Maps of every kind of texture, and of every encoding, in both directions, with and without what they can have.
std::vector<glsl::binding> maps() {
    std::vector<glsl::binding> all;
    for (const named_texture& t : textures)
        for (const auto direction : {umbrage::depth_direction::forward, umbrage::depth_direction::reversed})
            for (const std::optional<umbrage::outside_map> outside :
                 {std::optional<umbrage::outside_map>(), std::optional(umbrage::outside_map::bordered),
                  std::optional(umbrage::outside_map::clamped)})
                for (const bool gather : {false, true})
                    all.push_back({.texture = t.kind, .direction = direction, .outside = outside, .gather = gather});
    umbrage::for_each_encoding([&](const auto& encoding) { all.push_back(glsl::stored_as(encoding)); });
    all.push_back(glsl::stored_as(umbrage::rg<11>{}, {.outside = umbrage::outside_map::clamped, .gather = true}));
    all.push_back({.depth = "umbrage_level_rg11(value.xy)", .channels = 2, .needs = {glsl::level_rg<11>}});
    all.push_back({.compare = "exp(stored - receiver)"});
    all.push_back({.texture = glsl::texture::shadow, .compare = "exp(stored - receiver)"});
    for (const bool gather : {false, true}) all.push_back({.gather = gather, .depth = "value.x + texel.x"});
    all.push_back({.gather = true, .origin = "tile", .texture_size = "atlas_size"});
    for (const char* own : {"size * 2.0", "at + size", "vec2(64.0, 32.0)", "f(a)[1].xy", "(a) * (b)", "map.size"})
        for (const bool gather : {false, true}) all.push_back({.gather = gather, .origin = own, .texture_size = own});
    for (const char* own :
         {"value.x, extra", "f(value.x, extra)", "receiver = 1.0", "receiver += 1.0", "a == b ? 1.0 : 0.0",
          "float(a <= b && c >= d && e != f)", "a<b, c>(d)", "a,b", "=", "a=="}) {
        all.push_back({.depth = own});
        all.push_back({.compare = own});
        all.push_back({.origin = own, .texture_size = own, .texel = own});
    }
    all.push_back({.parameters = "int layer", .arguments = "layer", .texel = "fetch(maps, at, layer)"});
    all.push_back(
        {.parameters = "maps: array<texture_2d<f32>, 4>, map: i32", .arguments = "maps, map", .texel = "f(at)"});
    for (const char* own :
         {"int size", "int layer, int map", "map[4]", "a // b", "f(a", " ", "a; b", "metal::depth map"})
        for (const bool both : {false, true})
            all.push_back({.origin = both ? own : "", .parameters = own, .arguments = both ? own : ""});
    for (const named_texture& t : textures)
        for (const int channels : {0, 2, 3, 5})
            for (const bool gather : {false, true})
                all.push_back({.texture = t.kind, .gather = gather, .depth = "f(value)", .channels = channels});
    all.push_back({.texture = glsl::texture::shadow, .depth = "value.x"});
    all.push_back({.needs = {glsl::hard}});
    for (const named_texture& t : textures)
        for (const bool gather : {false, true})
            all.push_back({.texture = t.kind, .gather = gather, .receiver_plane = true});
    all.push_back(
        glsl::stored_as(umbrage::rg<11>{.direction = umbrage::depth_direction::reversed}, {.receiver_plane = true}));
    return all;
}

/// Result of text() and its exactness, or an error of text() or bind().
void add(std::ostream& out, const shader_language& l, const std::vector<bound>& items) {
    std::string text = "null", exactness = "null";
    try {
        for (const bound& item : items)
            (void)glsl::bind(item.what, item.suffix.substr(item.suffix.empty() ? 0 : 1), item.map);
        text = literal(l.text(items));
        const glsl::tier worst = glsl::detail::composition<>(*l.words, items).worst().exactness;
        exactness = literal(std::string_view("abc").substr(static_cast<std::size_t>(worst), 1));
    } catch (const std::invalid_argument&) {}
    out << "{\"language\":" << literal(l.name) << ",\"items\":" << json(items) << ",\"exactness\":" << exactness
        << ",\"text\":" << text << "}\n";
}

/// Expected encoding of the package: a filter's text, an empty map's texel, and the text of its depth pass.
void add_encoding(std::ostream& out, const auto& encoding, bool reversed) {
    using type = std::decay_t<decltype(encoding)>;
    std::string cleared;
    for (const cleared_channel& c : cleared_channels(encoding))
        cleared += (cleared.empty() ? "[" : ",[") + std::to_string(c.value) + ',' + std::to_string(c.most) + ']';
    const umbrage::clip_space clip = reversed ? umbrage::godot_clip_space : umbrage::cpu_clip_space;
    const umbrage::shadow of(
        umbrage::make_spot_light(
            {.position = {2, 6, 3}, .direction = {-2, -6, -3}, .z_near = 1, .z_far = 20, .clip = clip}),
        {64, 64}, umbrage::filters::hard{}, encoding);
    out << "{\"encoding\":" << literal(type::name) << ",\"reversed\":" << (reversed ? "true" : "false")
        << ",\"cleared\":[" << cleared
        << "],\"text\":" << literal(glsl::text({bind(glsl::hard, "a", glsl::stored_as(encoding))})) << ",\"passes\":{";
    for (const shader_language& l : languages)
        out << (&l == &languages[0] ? "" : ",") << literal(l.name) << ":"
            << literal(l.text({glsl::bind_depth_pass(of, "a")}));
    out << "}}\n";
}

void write(std::ostream& out) {
    umbrage::for_each_encoding([&](auto encoding) {
        add_encoding(out, encoding, false);
        encoding = {.direction = umbrage::depth_direction::reversed};
        add_encoding(out, encoding, true);
    });
    for (const shader_language& l : languages) {
        for (const snippet* s : glsl::registry()) add(out, l, {*s});
        for (const glsl::binding& map : maps())
            for (const snippet& s : {glsl::pcf_2x2, glsl::box, glsl::pcf_2x2_dx_sdk, glsl::lit_at})
                add(out, l, {bound(s, "sun", map)});
        const auto reversed = umbrage::depth_direction::reversed;  // four maps of four kinds in one shader
        add(out, l,
            {bind(glsl::pcf_2x2, "spot", glsl::stored_as(umbrage::rg<11>{})),
             bind(glsl::pcf_2x2, "cascades", {.texture = glsl::texture::array, .direction = reversed}),
             bind(glsl::box, "tile", {.texture = glsl::texture::atlas, .outside = umbrage::outside_map::bordered}),
             bind(glsl::hard, "lamp", {.texture = glsl::texture::cube}), glsl::cube_coordinate});
        add(out, l, {bind(glsl::hard, "", {})});
        add(out, l, {bind(glsl::hard, "", glsl::stored_as(umbrage::rg<11>{})), glsl::cube_coordinate});
        add(out, l, {glsl::hard, glsl::hard});
        add(out, l, {});
        add(out, l,
            {bind(glsl::hard, "a", {}), glsl::level_rg<11>, glsl::pcf_2x2,
             bind(glsl::box, "b", {.texture = glsl::texture::cube})});
        add(out, l, {bind(glsl::hard, "a", {}), bind(glsl::box, "a", {.outside = umbrage::outside_map::clamped})});
        add(out, l, {bind(glsl::hard, "a", {}), bind(glsl::box, "A", {})});
        add(out, l, {bind(glsl::hard, "", {}), glsl::box});
        add(out, l, {glsl::box, bind(glsl::hard, "", {})});
        add(out, l, {bind(glsl::pcf_2x2, "rg11", glsl::stored_as(umbrage::rg<11>{}, {.gather = true}))});
    }
    for (const glsl::version v : glsl::versions)
        for (const snippet* s : glsl::registry()) {
            if (v == glsl::version::vulkan) continue;
            const bound item(*s);
            out << "{\"version\":" << literal(directive(v)) << ",\"items\":" << json({item})
                << ",\"text\":" << (supports(item, v) ? literal(glsl::source(v, {item}, "#define A")) : "null")
                << "}\n";
        }
}

}  // namespace
}  // namespace package

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    std::ofstream file(argv[1], std::ios::binary);
    package::write(file);
    if (file) return 0;
    std::cerr << "write_expected: cannot write " << argv[1] << '\n';
    return 1;
}
