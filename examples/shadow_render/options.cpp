// SPDX-License-Identifier: MIT
#include "options.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include <choices.hpp>
#include <command_line.hpp>

#include "filter.hpp"
#include "troubles.hpp"

namespace shadow_render {
namespace {

template <class Kind>
using choices = std::vector<std::pair<std::string, Kind>>;

const choices<light_kind> light_kinds{
    {"spot", light_kind::spot}, {"directional", light_kind::directional}, {"cascades", light_kind::cascades}};
const choices<built_in> scenes{{"garden", built_in::garden},
                               {"solids", built_in::solids},
                               {"outdoor", built_in::outdoor},
                               {"plain", built_in::plain}};
const choices<float> edges{
    {"lower", umbrage::lower_edge<float>}, {"center", umbrage::center<float>}, {"upper", umbrage::upper_edge<float>}};
const choices<example::up_axis> axes{{"y", example::up_axis::y}, {"z", example::up_axis::z}};

template <class Kind>
CLI::Option* add_choice(CLI::App& app, const std::string& name, Kind& value, const choices<Kind>& all,
                        const std::string& text) {
    std::vector<std::string> names;
    std::string chosen;
    for (const auto& [key, kind] : all) {
        names.push_back(key);
        if (kind == value) chosen = key;
    }
    const auto choose = [&](const std::string& key) {
        for (const auto& [candidate, kind] : all)
            if (candidate == key) value = kind;
    };
    return app.add_option_function<std::string>(name, choose, text)
        ->check(CLI::IsMember(names).description(""))
        ->type_name(CLI::detail::join(names, "|"))
        ->default_str(chosen);
}

}  // namespace

std::optional<options> parse_options(int argc, const char* const* argv) {
    using example::within;
    options o;
    CLI::App app{
        "Renders a scene with shadow maps: picture.png, map.png, depth.png and visibility.png; or compares filters "
        "or set-ups of the light.",
        "shadow_render"};
    app.option_defaults()->always_capture_default()->take_last();

    CLI::Option* mesh = example::add_mesh(app, "mesh", o.mesh);
    add_choice(app, "--scene", o.scene, scenes,
               "built-in scene: a garden, a few solids on a floor, a kilometer of hills, or one of plain")
        ->excludes(mesh);
    add_choice(app, "--up", o.up, axes, "axis of the mesh that points up");
    app.add_option("-o,--output", o.output, "folder for the pictures, made when missing");

    const auto group = [&](const char* name) { app.option_defaults()->group(name); };
    group("Light");
    add_choice(app, "--light", o.light, light_kinds, "kind of light; cascades: a directional light with four maps");
    app.add_option("--azimuth", o.azimuth, "where it stands, degrees")->check(within(-360, 360));
    app.add_option("--elevation", o.elevation, "90 is straight above")->check(within(1, 90));
    app.add_option("--distance", o.distance, "of the spot from the scene's middle")->check(within(4, 100));
    app.add_option("--cone", o.cone, "full angle of the spot, degrees")->check(within(1, 150));

    app.add_option("--light-size", o.light_size, "its diameter, world units: of pcss and dpcf, and of --compare")
        ->check(within(0, 4));

    group("Shadow map");
    app.add_option("--map-size", o.map_size, "texels along an edge; cascades have a quarter of it each")
        ->check(within(1, 8192));
    app.add_flag("--draw-all", o.draw_all, "draws instances that lie beside a cascade's map as well: the same picture");
    example::add_encoding(app, o.encoding)->type_name("NAME");
    add_choice(app, "--edge", o.edge, edges, "of a code's interval, that decoding answers");

    group("Filter");
    example::add_filter(app, o.filter, filter_names());
    app.add_option("--radius", o.radius, "of a disc, or, whole, a box or a filtered map's blur, texels")
        ->check(within(0, 8));
    app.add_option("--max-radius", o.max_radius, "radius of the widest penumbra of pcss and dpcf, texels")
        ->check(within(0, 15));

    group("Bias");
    example::add_bias(app, o.bias);
    app.add_option("--reach", o.reach, "texels that it covers; without it, what the filter's own asks for")
        ->check(within(0, 16));

    group("Picture");
    app.add_option("--width", o.width, "pixels")->check(within(1, 8192));
    app.add_option("--height", o.height, "pixels")->check(within(1, 8192));
    app.add_option("--samples", o.samples, "per pixel, along an edge")->check(within(1, 4));
    app.add_option("--camera-azimuth", o.camera_azimuth, "degrees")->check(within(-360, 360));
    app.add_option("--camera-elevation", o.camera_elevation, "degrees")->check(within(1, 90));
    app.add_option("--camera-distance", o.camera_distance, "from the scene's middle")->check(within(3, 100));
    app.add_option("--fov", o.fov, "vertical field of view, degrees")->check(within(1, 120));

    std::vector<std::string> names_of_troubles;
    for (const trouble& t : troubles()) names_of_troubles.emplace_back(t.name);
    example::add_choice(app, "--break", o.trouble, names_of_troubles,
                        "what can go wrong, made on purpose: wrong.png and cured.png")
        ->excludes(mesh);

    group("Comparison");
    CLI::Option* compare =
        app.add_flag("--compare", o.compare,
                     "every filter against rays to an area light: compare.png alone, a contact sheet; "
                     "pictures of 480 x 320 without --width and --height");
    app.add_option("--shaders", o.shaders,
                   "shaders.tsv of make bench-shaders, for what filters cost on RDNA2; without it "
                   "the one in build/bench-shaders, if any");
    CLI::Option* light_report =
        app.add_flag("--light-report", o.light_report,
                     "pixels a texel of every set-up of the light, spots and directional: light-report.png alone, a "
                     "contact sheet, and a table")
            ->excludes(compare);
    app.add_flag("--stability-report", o.stability_report,
                 "how still cascades stand and pages stay while the camera moves: film strips and tables")
        ->excludes(compare)
        ->excludes(light_report);

    group("Run");
    app.add_flag("-q,--quiet", o.quiet, "no progress, no timings");

    std::string names = "Encodings:";
    for (const std::string& name : example::encoding_names()) names += " " + name;
    app.footer(names);

    if (!example::parse(app, argc, argv)) return std::nullopt;
    const auto unless_given = [&](const char* name, auto& value, auto usual) {
        if (app.count(name) == 0) value = usual;
    };
    const bool plain = o.scene == built_in::plain;
    if (o.scene == built_in::solids) {
        unless_given("--light", o.light, light_kind::spot);
        unless_given("--azimuth", o.azimuth, 60.0f);
        unless_given("--elevation", o.elevation, 40.0f);
        unless_given("--map-size", o.map_size, 1024);
        unless_given("--camera-elevation", o.camera_elevation, 30.0f);
        unless_given("--fov", o.fov, 35.0f);
    } else if (o.scene != built_in::garden) {
        unless_given("--light", o.light, light_kind::cascades);
        unless_given("--azimuth", o.azimuth, 60.0f);
        unless_given("--map-size", o.map_size, plain ? 2048 : 4096);
        unless_given("--camera-elevation", o.camera_elevation, plain ? 0.0f : 4.0f);
        unless_given("--camera-distance", o.camera_distance, plain ? 100.0f : 64.0f);
        unless_given("--distance", o.distance, 100.0f);
        unless_given("--fov", o.fov, plain ? 60.0f : 50.0f);
    }
    if (o.scene != built_in::garden) {
        unless_given("--filter", o.filter, "pcf_2x2");
        unless_given("--max-radius", o.max_radius, 8.0f);
    }
    const bool sheet_of_pictures = o.compare || o.stability_report;
    if (sheet_of_pictures && app.count("--width") == 0) o.width = 480;
    if (sheet_of_pictures && app.count("--height") == 0) o.height = 320;
    const bool cascades = o.light == light_kind::cascades;
    if (cascades && o.compare) throw example::usage_error("--compare is of one map: --light spot or directional");
    if (cascades && o.map_size < 32) throw example::usage_error("--light cascades needs a --map-size of 32 or above");
    if (o.draw_all && !cascades) throw example::usage_error("--draw-all is for --light cascades");
    if ((o.light_report || o.stability_report) && o.map_size < 16)
        throw example::usage_error("reports on the light need a --map-size of 16 or above");
    if (1.0 * o.width * o.height * o.samples * o.samples > 64e6 || std::max(o.width, o.height) * o.samples > 16384)
        throw example::usage_error("too large a picture: at most 64 million samples, 16384 along an edge");
    return o;
}

}  // namespace shadow_render
