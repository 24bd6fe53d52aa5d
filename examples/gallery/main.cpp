// SPDX-License-Identifier: MIT
//
// Renders the systems, the encodings and the filters of the library into one page.
//
//     gallery --output build/gallery/index.html
//
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <umbrage/images/visibility.hpp>
#include <umbrage/shader/registry.hpp>
#include <umbrage/view/false_colour.hpp>

#include <command_line.hpp>
#include <encodings.hpp>

#include "opengl.hpp"
#include "page.hpp"
#include "render.hpp"

namespace gallery {
namespace {

using namespace example;
namespace glsl = umbrage::glsl;

struct settings {
    std::filesystem::path output = "gallery/index.html", viewer{};
    int size = 564;
};

template <class... Values>
std::string text(const char* format, Values... values) {
    char out[400];
    std::snprintf(out, sizeof out, format, values...);
    return out;
}
std::string milliseconds(double ms) {
    return text("%.1f ms", ms);
}
std::string square(int size) {
    return text("%d × %d", size, size);
}
std::string depth_error(double error) {
    return error > 0 ? text("%.2e = 2^%.4g", error, std::log2(error)) : "0";
}

/// A map as people see it: nearest texels, near blue, far red.
picture coloured(const umbrage::image<float>& depth, int edge) {
    picture out{glm::ivec2(edge)};
    const auto stretch = umbrage::stretch(depth);
    umbrage::overlay(out, depth, {.size = out.size(), .map_origin = picture_clip.origin},
                     [&](float d) { return umbrage::false_colour(stretch(d)); });
    return out;
}

/// A map as it is stored: its channels from left to right. Of a float the depth, stretched.
picture packed(const stored_depth& map, const umbrage::image<float>& depth, int edge) {
    std::vector<picture> channels;
    const auto add = [&](const umbrage::image<float>& from, auto&& colour) {
        umbrage::overlay(channels.emplace_back(glm::ivec2(edge)), from,
                         {.size = glm::ivec2(edge), .map_origin = picture_clip.origin}, colour);
    };
    for (const auto& channel : map.channels) {
        umbrage::image<float> values(channel.size());
        std::ranges::transform(channel.texels(), values.texels().begin(),
                               [](std::uint8_t v) { return static_cast<float>(v) / 255.0f; });
        add(values, [](float v) { return v; });
    }
    if (channels.empty()) add(depth, umbrage::stretch(depth));
    return side_by_side(channels);
}

/// @param decode    GLSL function of the texels' channels, e.g. "umbrage_decode_rg11"
/// @param channels  what it takes, e.g. ".xy, 1.0"
std::string fetching(const std::string& decode, const std::string& channels) {
    return "#define UMBRAGE_FETCH(map, size, texel) " + decode + "(umbrage_fetch_clamped(map, size, texel)" + channels +
           ")\n";
}

// --- Systems -----------------------------------------------------------------------------------------------------

struct description {
    std::string text;
    std::vector<glsl::snippet> snippets;
    std::string preamble{};
};

/// Decoders come before the filters that fetch through them.
const std::map<std::string_view, description> descriptions{
    {"radeon_8500",
     {"The card of 2001 had 8 bits a channel. A look-up texture of 2048 texels spread 11 bits of depth over two of "
      "them; "
      "pixel shader 1.4 put them together again and compared, at four taps with a texture matrix each.",
      {glsl::shadow_coordinate, glsl::tap_coordinate, glsl::project_coordinate, glsl::linear_depth,
       glsl::encode_rg_table<11>, glsl::decode_ps14, glsl::receiver_ps14, glsl::four_tap, glsl::spot_cone,
       glsl::diffuse_ambient},
      fetching("umbrage_decode_ps14", ".xy")}},
    {"dx_sdk",
     {"Microsoft's sample: a spot light with a cone, z/w in a float texture, an epsilon, four comparisons and their "
      "bilinear "
      "mean, on diffuse and ambient light.",
      {glsl::shadow_coordinate, glsl::project_coordinate, glsl::project_depth, glsl::pcf_2x2_dx_sdk, glsl::spot_cone,
       glsl::diffuse_ambient}}},
    {"exercise",
     {"What graphics courses set: a directional light with ten texels to a world unit, depth over the far plane, one "
      "comparison "
      "with an epsilon.",
      {glsl::shadow_coordinate, glsl::project_coordinate, glsl::linear_depth, glsl::fetch_bordered,
       glsl::compare_exercise, glsl::diffuse_ambient}}},
    {"self_shadowing",
     {"A Direct3D 8 article: the look-up texture lies along an orthographic light's axis, the depth pass and the "
      "camera's pass "
      "both fetch from it, and equal texels mean light. Shadow darkens the lit picture.",
      {glsl::shadow_coordinate, glsl::project_coordinate, glsl::encode_rg_table<11>, glsl::decode_ps14, glsl::hard,
       glsl::diffuse_ambient},
      fetching("umbrage_decode_ps14", ".xy")}}};

void add_system(page& page, const settings& o, const std::filesystem::path& folder, const shadow_system& system) {
    const options with{.output = folder,
                       .azimuth = system.azimuth,
                       .elevation = system.elevation,
                       .size = o.size,
                       .map_size = system.map_size,
                       .lift = system.lift};
    double depth_ms = 0, camera_ms = 0, visibility_ms = 0, shade_ms = 0;
    const stage stage = timed(camera_ms, [&] { return example::stage(system, with); });
    const light light = make_light(system, stage.scene, system.azimuth, system.elevation, system.map_size);
    const auto depth = timed(depth_ms, [&] { return depth_pass(system, stage.scene, light, system.map_size); });
    const stored_depth map = with_encoding(system.encoding, umbrage::upper_edge<float>,
                                           [&](auto encoding, float) { return store(depth, encoding); });
    const bool ps14 = system.receiver != receiver_kind::plain;
    const auto visibility =
        timed(visibility_ms, [&] { return visibility_of(system, stage, light, ps14 ? decoded_ps14(map) : map.depth); });
    picture shaded = timed(shade_ms, [&] { return stage.shade(system, light, visibility); });
    show_map(shaded, depth);

    double surface = 0, shadow = 0;
    stage.for_each_surface([&](glm::ivec2 pixel, const example::surface&) {
        surface += 1;
        shadow += 1.0 - double(visibility[pixel]);
    });

    const int edge = shaded.size().y;
    std::vector<figure> figures{{page.picture(shaded), "On the CPU, the map in the corner"},
                                {page.picture(grey(visibility)), "Visibility, white is lit"}};
    std::vector<number> numbers{{"shadow map", square(system.map_size)},
                                {"bits of depth", map.channels.empty() ? "32, float"
                                                  : ps14               ? "11 in two channels"
                                                                       : std::string(system.encoding)},
                                {"depth pass", milliseconds(depth_ms)},
                                {"encode, best of 5", milliseconds(map.encode_ms)},
                                {"camera pass", milliseconds(camera_ms)},
                                {"fetch, compare, filter", milliseconds(visibility_ms)},
                                {"shade", milliseconds(shade_ms)},
                                {"in shadow", text("%.1f %% of what is seen", 100 * shadow / surface)}};

    if (const auto gl = run_viewer(o.viewer, system.name, shaded.size(), folder)) {
        std::size_t other = 0;
        for (std::size_t i = 0; i < visibility.texels().size(); ++i)
            other +=
                std::abs(int(gl->visibility.texels()[i].r) - int(umbrage::store_unorm8(visibility.texels()[i]))) > 64;
        figures.push_back({page::file(gl->picture), "On OpenGL, with the snippets below"});
        figures.push_back({page::file(gl->mask), "Visibility on OpenGL"});
        numbers.push_back({"OpenGL", gl->frame});
        numbers.push_back(
            {"OpenGL's visibility is another by more than 1/4",
             text("in %.2f %% of the pixels", 100.0 * double(other) / double(visibility.texels().size()))});
    }
    if (system.receiver == receiver_kind::scaled) {  // beside 8 bits and beside exact depth
        shadow_system plain = system;
        plain.receiver = receiver_kind::plain;
        const auto exact = visibility_of(plain, stage, light, depth);
        const auto coarse = visibility_of(plain, stage, light, store(depth, eight_bits{}).depth);
        const auto others = [&](const umbrage::image<float>& v) {
            std::size_t n = 0;
            for (std::size_t i = 0; i < v.texels().size(); ++i) n += v.texels()[i] != exact.texels()[i];
            return text("%.3f %% of the pixels", 100.0 * double(n) / double(v.texels().size()));
        };
        figures.push_back({page.picture(grey(coarse)), "Visibility with 8 bits, without the trick"});
        figures.push_back({page.picture(grey(exact)), "Visibility with exact depth"});
        numbers.push_back({"11 bits differ from exact depth in", others(visibility)});
        numbers.push_back({"8 bits differ in", others(coarse)});
    }
    figures.push_back({page.picture(coloured(depth, edge)), "The map, blue near, red far"});
    if (!map.channels.empty())
        figures.push_back({page.picture(packed(map, depth, edge / 2)), "The map as stored: R, G"});
    const description& d = descriptions.at(system.name);
    page.entry(system.name, system.title, d.text, figures, numbers, together_and_alone(d.snippets, d.preamble));
}

// --- Encodings ---------------------------------------------------------------------------------------------------

struct facts {
    double bound;  ///< on |decoded - depth|, stated by the library
    std::string codes;
    std::string text;
    std::vector<glsl::snippet> snippets;
    std::string preamble;  ///< for shaders whose filters read such a map
};

template <class Encoding>
facts facts_of(std::string text, std::vector<glsl::snippet> snippets, std::string preamble) {
    return {std::max(Encoding{}.error().below, Encoding{}.error().above), std::to_string(Encoding::codes), std::move(text), std::move(snippets),
            std::move(preamble)};
}

template <int Bits>
facts facts_of_rg() {
    return facts_of<umbrage::rg<Bits>>(
        std::to_string(Bits) + " bits in two channels: R the low byte, G the rest in its high bits.",
        {glsl::encode_rg<Bits>, glsl::encode_rg_table<Bits>, glsl::to_unorm, glsl::decode_rg<Bits>, glsl::fetch_depth},
        fetching("umbrage_decode_rg" + std::to_string(Bits), ".xy, 1.0"));
}

facts facts_of(std::string_view name) {
    using namespace umbrage::glsl;
    if (name == "depth32f")
        return {0.0,
                std::to_string(std::bit_cast<std::uint32_t>(1.0f) + 1),
                "A float texture: nothing to encode.",
                {fetch_clamped, fetch_depth},
                ""};
    if (name == "rg9") return facts_of_rg<9>();
    if (name == "rg10") return facts_of_rg<10>();
    if (name == "rg11") return facts_of_rg<11>();
    if (name == "rg12") return facts_of_rg<12>();
    if (name == "rg13") return facts_of_rg<13>();
    if (name == "rg14") return facts_of_rg<14>();
    if (name == "rg15") return facts_of_rg<15>();
    if (name == "rg16") return facts_of_rg<16>();
    if (name == "rgb24")
        return facts_of<umbrage::rgb24>("24 bits in three channels, R most significant.",
                                        {encode_rgb24, to_unorm, decode_rgb24, fetch_depth},
                                        fetching("umbrage_decode_rgb24", ".xyz, 1.0"));
    if (name == "float_bits")
        return facts_of<umbrage::float_bits>("The bit pattern of the float itself, R least significant.",
                                             {encode_float_bits, to_unorm, decode_float_bits, fetch_depth},
                                             fetching("umbrage_decode_float_bits", ""));
    if (name == "threejs_rgba")
        return facts_of<umbrage::threejs_rgba>("RGBA of three.js since r167: three whole bytes and the rest.",
                                             {write_threejs_rgba, decode_threejs_rgba, fetch_depth},
                                             fetching("umbrage_decode_threejs_rgba", ""));
    if (name == "threejs_rgb")
        return facts_of<umbrage::threejs_rgb>("RGB of three.js since r167: two whole bytes and the rest.",
                                            {write_threejs_rgb, decode_threejs_rgb, fetch_depth},
                                            fetching("umbrage_decode_threejs_rgb", ".xyz"));
    if (name == "threejs_rg")
        return facts_of<umbrage::threejs_rg>("RG of three.js since r167: one whole byte and the rest.",
                                           {write_threejs_rg, decode_threejs_rg, fetch_depth},
                                           fetching("umbrage_decode_threejs_rg", ".xy"));
    if (name == "threejs_legacy")
        return facts_of<umbrage::threejs_legacy>(
            "RGBA of three.js r73 to r166, its fault included: 1 reads back as 255/256.",
            {write_threejs_legacy, decode_threejs_legacy, fetch_depth}, fetching("umbrage_decode_threejs_legacy", ""));
    if (name == "threejs_legacy_repaired")
        return facts_of<umbrage::threejs_legacy_repaired>(
            "For readers of three.js r73 to r166, written without the fault.",
            {encode_threejs_legacy_repaired, to_unorm, decode_threejs_legacy, fetch_depth},
            fetching("umbrage_decode_threejs_legacy", ""));
    if (name == "base255")
        return facts_of<umbrage::base255>(
            "Base 255, as in Cesium, Babylon.js and bgfx, its fault included: 1 reads back as 0.",
            {write_base255, decode_base255, fetch_depth}, fetching("umbrage_decode_base255", ""));
    if (name == "base255_repaired")
        return facts_of<umbrage::base255_repaired>("For readers of base 255, written without the fault.",
                                                {encode_base255_repaired, to_unorm, decode_base255, fetch_depth},
                                                fetching("umbrage_decode_base255", ""));
    throw std::logic_error("nothing is known of the encoding " + std::string(name));
}

void add_encodings(page& page, const settings& o, const std::filesystem::path& folder) {
    shadow_system system = radeon_8500;
    system.receiver = receiver_kind::plain;
    system.filter = filter_kind::hard;
    constexpr float reach = 1000, rounding = 0x1p-18f;
    const stage stage(system, {.output = folder, .size = o.size * 3 / 4});
    light light = make_light(system, stage.scene, system.azimuth, system.elevation, system.map_size);
    light.z_far = reach;
    light.space = umbrage::make_spot_light<float>({.position = light.position,
                                                   .direction = light.direction,
                                                   .up = direction_at(system.azimuth, system.elevation + 90),
                                                   .outer_angle_radians = glm::radians(system.outer_angle),
                                                   .z_near = light.z_near,
                                                   .z_far = reach,
                                                   .clip = picture_clip});
    auto depth = depth_pass(system, stage.scene, light, system.map_size);
    const float cleared = light.depth(system, umbrage::cleared_depth(light.space.clip));
    for (float& d : depth.texels())
        if (d == cleared) d = 1;  // as a target holds it where nothing was drawn
    system.bias = rounding;
    const auto exact = visibility_of(system, stage, light, depth);

    page.section(
        "encodings", "Encodings",
        text("The same shadow from the same depths, stored in every way there is. The light reaches %g world units, "
             "a hundred times farther than the scene, so that bits are scarce; codes decode to their upper edge. What "
             "comes out otherwise than with exact depth is red.",
             double(reach)));
    for (const std::string& name : encoding_names) {
        float below_depth = 0;
        const stored_depth map = with_encoding(name, umbrage::upper_edge<float>, [&](auto encoding, float below) {
            below_depth = below;
            return store(depth, encoding);
        });
        const facts f = facts_of(name);
        if (map.error > f.bound) throw std::logic_error("the encoding " + name + " is worse than stated");
        system.bias = rounding + below_depth;
        const auto visibility = visibility_of(system, stage, light, map.depth);
        picture shaded = stage.shade(system, light, visibility);
        std::size_t other = 0;
        for (std::size_t i = 0; i < shaded.texels().size(); ++i)
            if (visibility.texels()[i] != exact.texels()[i]) {
                ++other;
                shaded.texels()[i] = {230, 20, 40};
            }
        const int edge = std::max(1, shaded.size().y / 2);
        page.entry(
            name, name, f.text,
            {{page.picture(shaded), "Red: not as with exact depth"},
             {page.picture(packed(map, depth, edge)),
              map.channels.empty() ? "The map, stretched"
                                   : text("The map's channels: %.*s", int(3 * map.channels.size()) - 2, "R, G, B, A")}},
            {{"error, stated", text("≤ %s", depth_error(f.bound).c_str())},
             {"error, worst in this map", depth_error(map.error)},
             {"codes", f.codes},
             {"codes in this map", std::to_string(map.codes)},
             {"pixels other than with exact depth", std::to_string(other)},
             {text("encode %s, best of 5", square(system.map_size).c_str()), text("%.2f ms", map.encode_ms)},
             {"decode, best of 5", text("%.2f ms", map.decode_ms)}},
            together_and_alone(f.snippets, f.preamble));
    }
}

// --- Filters -----------------------------------------------------------------------------------------------------

template <class Filter>
void add_filter(page& page, const settings& o, const std::filesystem::path& folder, std::string_view id,
                std::string_view title, std::string_view about, Filter filter, float reach,
                std::vector<glsl::snippet> snippets) {
    shadow_system system = radeon_8500;
    system.map_size = 256;
    system.lift = std::numbers::sqrt2_v<float> * (reach + 1.0f / 128);  // to the corner of what the filter reads
    stage stage(system, {.output = folder, .size = 3});
    const glm::ivec2 size(o.size * 2 / 3);
    stage.camera = make_camera({.target = {-1.75f, 0, 0.35f}, .elevation = 55, .distance = 7.5f, .fov = 10});
    stage.seen = camera_pass(stage.scene.geometry, stage.camera, size);

    const light light = make_light(system, stage.scene, system.azimuth, system.elevation, system.map_size);
    const auto map = depth_pass(system, stage.scene, light, system.map_size);
    const glm::mat4 to_texels = umbrage::texture_matrix(light.space, map.size());
    umbrage::image<glm::vec3> receivers(size, umbrage::project_coordinate(glm::vec4(0)));
    stage.for_each_surface([&](glm::ivec2 pixel, const surface& s) {
        const glm::vec3 point = lifted(system, light, s.position, s.normal, system.map_size);
        const glm::vec3 p = umbrage::project_coordinate(umbrage::shadow_coordinate(to_texels, point));
        receivers[pixel] = {p.x, p.y, light.depth(system, p.z) - 0x1p-18f};
    });

    umbrage::image<float> visibility(size);
    const double ms = best_of_5([&] {
        umbrage::visibility(map.view(), umbrage::depth32f{}, std::as_const(receivers).view(), filter,
                            visibility.view());
    });
    int most_taps = 0;
    for (glm::vec3 r : receivers.texels()) {
        int taps = 0;
        const auto fetch = [&, texel = umbrage::clamped(map)](glm::ivec2 t) { return ++taps, texel(t); };
        static_cast<void>(filter(fetch, glm::vec2(r), r.z));
        most_taps = std::max(most_taps, taps);
    }
    std::vector<float> levels(visibility.texels().begin(), visibility.texels().end());
    std::ranges::sort(levels);
    const auto different = std::ranges::unique(levels).begin() - levels.begin();
    const double count = double(receivers.texels().size());
    page.entry(id, title, about,
               {{page.picture(stage.shade(system, light, visibility)), "Shaded"},
                {page.picture(grey(visibility)), "Visibility"}},
               {{"fetches", std::to_string(most_taps)},
                {"levels in this picture", std::to_string(different)},
                {text("%.0f receivers, best of 5", count), text("%.3f ms", ms)},
                {"each", text("%.1f ns", ms * 1e6 / count)}},
               together_and_alone(std::move(snippets)));
}

void add_filters(page& page, const settings& o, const std::filesystem::path& folder) {
    using namespace umbrage;
    page.section("filters", "Filters",
                 "One edge of a shadow, from a map of 256 × 256 texels, seen from near. The smoother, the more texels "
                 "it takes.");
    const auto add = [&](auto... of) { add_filter(page, o, folder, of...); };
    using snippets = std::vector<glsl::snippet>;
    add("hard", "Hard", "One texel, one comparison.", filters::hard{}, 0.5f, snippets{glsl::hard});
    add("four_tap", "Four taps", "The mean of four comparisons, half a texel off in each direction.",
        filters::four_tap{}, 1.0f, snippets{glsl::four_tap, glsl::tap_coordinate});
    add("pcf_2x2", "2 × 2 PCF",
        "Four comparisons and their bilinear mean, in steps of 1/256 as texture hardware does it.", filters::pcf_2x2{},
        1.0f, snippets{glsl::pcf_2x2});
    add("pcf_2x2_dx_sdk", "2 × 2 PCF of the DirectX SDK", "The same with weights in full floats, the epsilon inside.",
        filters::pcf_2x2_dx_sdk{}, 1.0f, snippets{glsl::pcf_2x2_dx_sdk});
    for (const int radius : {1, 2, 4, 8}) {
        const int width = 2 * radius + 1;
        add("box_" + std::to_string(radius), text("Box %d × %d", width, width),
            text("The share of %d texels that are lit: radius %d.", width * width, radius), filters::box{radius},
            static_cast<float>(radius) + 0.5f, snippets{glsl::box});
    }
}

// --- The page ----------------------------------------------------------------------------------------------------

/// "AMD EPYC", where the system tells.
std::string processor() {
    std::ifstream in("/proc/cpuinfo");
    for (std::string line; std::getline(in, line);)
        if (line.starts_with("model name")) return line.substr(std::min(line.size(), line.find(':') + 2));
    return "an unnamed processor";
}

void run(const settings& o) {
    std::filesystem::path folder = o.output;  // for pictures on their way into the page
    folder += ".pictures";
    std::filesystem::create_directories(folder);
    page page(folder);
    page.section("systems", "Systems",
                 "The four that the library descends from, with their own light, encoding, bias and filter.");
    for (const shadow_system& system : systems) add_system(page, o, folder, system);
    add_encodings(page, o, folder);
    add_filters(page, o, folder);
    page.write(o.output, "Times are of one run on one thread of " + processor() + " unless said otherwise.");
    std::filesystem::remove_all(folder);
    std::printf("%s, %.1f MB\n", o.output.string().c_str(), double(std::filesystem::file_size(o.output)) / 1e6);
}

}  // namespace
}  // namespace gallery

int main(int argc, char** argv) {
    return example::run("gallery", [&] {
        gallery::settings o;
        CLI::App app{"Makes one page of every system, encoding and filter.", "gallery"};
        app.option_defaults()->always_capture_default();
        app.add_option("-o,--output", o.output, "the page; its folder is made when missing");
        app.add_option("--viewer", o.viewer, "the viewer, for pictures by OpenGL; left out where it cannot run");
        app.add_option("--size", o.size, "width of the systems' pictures, pixels")->check(example::within(30, 2000));
        if (example::parse(app, argc, argv)) gallery::run(o);
    });
}
