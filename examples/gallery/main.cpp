// SPDX-License-Identifier: MIT
//
// Renders the systems, encodings, biases, filters, soft shadows and setups of lights of the library into one page.
//
//     gallery --output build/gallery/index.html
//
#include <cstdio>
#include <filesystem>
#include <string>

#include <command_line.hpp>
#include <processor.hpp>

#include "sections.hpp"

namespace gallery {
namespace {

void run(const settings& o) {
    std::filesystem::path folder = o.output;  // for pictures on their way into the page
    folder += ".pictures";
    std::filesystem::create_directories(folder);
    page page(folder);
    add_systems(page, o, folder);
    add_encodings(page, o, folder);
    add_biases(page, o, folder);
    add_filters(page, o, folder);
    add_soft_shadows(page, o, folder);
    add_lights(page, o);
    page.write(o.output, "Times are of one run on one thread of " + example::processor() + " unless said otherwise.");
    std::filesystem::remove_all(folder);
    std::printf("%s, %.1f MB\n", o.output.string().c_str(), double(std::filesystem::file_size(o.output)) / 1e6);
}

}  // namespace
}  // namespace gallery

int main(int argc, char** argv) {
    return example::run("gallery", [&] {
        gallery::settings o;
        CLI::App app{"Makes one page of every system, encoding, bias, filter and setup of a light.", "gallery"};
        app.option_defaults()->always_capture_default();
        app.add_option("-o,--output", o.output, "the page; its folder is made when missing");
        app.add_option("--viewer", o.viewer, "the viewer, for pictures by OpenGL; left out where it cannot run");
        app.add_option("--size", o.size, "width of the systems' pictures, pixels")->check(example::within(30, 2000));
        if (example::parse(app, argc, argv)) gallery::run(o);
    });
}
