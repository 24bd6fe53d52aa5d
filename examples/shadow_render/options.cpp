// SPDX-License-Identifier: MIT
#include "options.hpp"

#include <map>
#include <string>

#include <choices.hpp>
#include <command_line.hpp>

#include "filter.hpp"
#include "scenes.hpp"

namespace shadow_render {

std::optional<options> parse_options(int argc, const char* const* argv) {
    using example::within;
    static const std::map<std::string, light_kind> lights{
        {"cascades", light_kind::cascades}, {"directional", light_kind::directional}, {"spot", light_kind::spot}};
    options o;
    glm::ivec2 size(o.width, o.height);
    CLI::App app{"Renders a scene with a shadow map: picture.png, map.png, depth.png and visibility.png.",
                 "shadow_render"};
    app.option_defaults()->always_capture_default()->take_last();
    CLI::Option* scene = add_scene(app, o);
    example::add_mesh(app, "mesh", o.mesh)->excludes(scene);
    app.add_option("-o,--output", o.output, "folder for the pictures, made when missing");
    example::add_size(app, "--size", size, "pixels of the picture: 960x640", 1, 8192);
    app.add_option("--light", o.light, "kind of light; cascades: a directional light with four maps")
        ->transform(CLI::CheckedTransformer(lights).description(""))
        ->type_name("spot|directional|cascades")
        ->default_str("directional");
    app.add_option("--azimuth", o.azimuth, "where the light is, degrees; 90: to the right")->check(within(-360, 360));
    app.add_option("--elevation", o.elevation, "90 is straight above")->check(within(1, 90));
    app.add_option("--light-size", o.light_size, "its diameter, world units, for pcss and dpcf")->check(within(0, 4));
    app.add_option("--map-size", o.map_size, "texels along an edge; cascades have a quarter of it each")
        ->check(within(1, 8192));
    example::add_encoding(app, o.encoding)->type_name("NAME");
    example::add_filter(app, o.filter, filter_names())->type_name("NAME");
    app.add_option("--radius", o.radius, "of a disc, or, an integer, a box or a filtered map's blur, texels")
        ->check(within(0, 8));
    example::add_bias(app, o.bias);
    app.add_flag("-q,--quiet", o.quiet, "no progress, no timings");
    const auto all = [](const char* title, const std::vector<std::string>& names) {
        std::string line = title;
        for (const std::string& name : names) line += " " + name;
        return line + "\n";
    };
    app.footer(all("Encodings:", example::encoding_names()) + all("Filters:", filter_names()));

    if (!example::parse(app, argc, argv)) return std::nullopt;
    o.width = size.x, o.height = size.y;
    if (o.light == light_kind::cascades && o.map_size < 32)
        throw example::usage_error("--light cascades needs a --map-size of 32 or above");
    require_drawable(o);
    return o;
}

}  // namespace shadow_render
