// SPDX-License-Identifier: MIT
#include "options.hpp"

#include <map>
#include <vector>

#include <choices.hpp>
#include <command_line.hpp>

#include "session.hpp"

namespace viewer {

std::optional<options> parse_options(int argc, const char* const* argv) {
    using example::within;
    options o;
    CLI::App app{"Shows a shadow mapping system on OpenGL, live.", "viewer"};
    app.option_defaults()->always_capture_default();

    std::vector<std::string> systems;
    for (const example::shadow_system& s : example::systems) systems.emplace_back(s.name);
    systems.emplace_back(outdoor_system.name);
    const std::map<std::string, example::up_axis> axes{{"y", example::up_axis::y}, {"z", example::up_axis::z}};

    example::add_choice(app, "--system", o.system, systems, "what to show");
    example::add_mesh(app, "--mesh", o.mesh);
    app.add_option("--up", o.up, "axis of the mesh that points up")
        ->transform(CLI::CheckedTransformer(axes).description(""))
        ->type_name("y|z")
        ->default_str("y");

    app.option_defaults()->group("Shadow (without them, the system's own)");
    app.add_option("--azimuth", o.azimuth, "where the light stands, degrees")->check(within(-360, 360));
    app.add_option("--elevation", o.elevation, "90 is straight above")->check(within(lowest_light, 90));
    example::add_encoding(app, o.encoding)->type_name("NAME");
    example::add_filter(app, o.filter, filter_names());
    app.add_option("--radius", o.radius, "of a disc, or, whole, a box or a filtered map's blur, texels")
        ->check(within(0, largest_radius));
    app.add_option("--light-size", o.light_size, "diameter, of pcss and dpcf, world units")
        ->check(within(0, largest_light));
    example::add_size(app, "--map-size", o.map_size, "texels of the map: 512, or 480x320", smallest_map, largest_map)
        ->default_str("");
    example::add_bias(app, o.bias);
    app.add_option("--reach", o.reach, "texels that the bias covers; without it, what the filter's own asks for")
        ->check(within(0, 16));
    app.add_option("--epsilon", o.epsilon, "constant bias besides, in the map's depth from 0 to 1")
        ->check(within(-1, 1));

    example::add_choice(app, "--scene", o.ground, ground_names(),
                        "outdoor: a kilometre of hills, one of plain, or a few things on a floor");
    example::add_choice(
        app, "--placement", o.placement, placement_names(),
        "outdoor: of a sun four maps, or one of as many texels, or pages in one; of a lamp the last three");

    app.option_defaults()->group("Picture");
    app.add_option("--width", o.width, "pixels")->check(within(16, 8192));
    app.add_option("--height", o.height, "pixels")->check(within(16, 8192));
    app.add_flag("--es2", o.es2, "OpenGL ES 2 and GLSL 100: systems radeon_8500 and self_shadowing");
    app.add_flag("--mask", o.mask, "visibility alone, white is lit");
    app.add_flag("--tint", o.tint, "outdoor: each cascade, face or size of pages in a color");
    app.add_flag("!--no-text", o.text, "no text in the window");
    app.add_flag("!--no-map", o.map, "no shadow map in the corner");

    app.option_defaults()->group("Run");
    app.add_flag("--headless", o.headless, "without a window: the picture alone, no text");
    app.add_option("--frames", o.frames, "to draw before the end; says how long one took")->check(within(1, 1e6));
    app.add_option("--screenshot", o.screenshot, "PNG file for the last frame, and for the key P");

    std::string footer = "Encodings:";
    for (const std::string& name : example::encoding_names()) footer += " " + name;
    app.footer(footer + "\n" + std::string(keys));

    if (!example::parse(app, argc, argv)) return std::nullopt;
    const bool outdoor = o.system == outdoor_system.name;
    if (outdoor && o.es2) throw example::usage_error("--system outdoor needs OpenGL 3.3");
    for (const char* other : {"--mesh", "--encoding", "--bias"})
        if (outdoor && app.count(other) > 0)
            throw example::usage_error(std::string(other) + " is not for --system outdoor");
    if (outdoor && o.filter && !filters_layers(*o.filter))
        throw example::usage_error("--filter " + *o.filter + " is not for --system outdoor");
    for (const char* own : {"--placement", "--scene"})
        if (!outdoor && app.count(own) > 0) throw example::usage_error(std::string(own) + " is for --system outdoor");
    if (o.tint && !(outdoor && has_parts(o.placement)))
        throw example::usage_error("--tint is for --system outdoor, its cascades, pages and faces");
    if (o.headless && o.frames == 0) o.frames = 1;
    return o;
}

}  // namespace viewer
