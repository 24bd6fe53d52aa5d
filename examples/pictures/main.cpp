// SPDX-License-Identifier: MIT
//
// Makes the pictures that the pages show: the target draw_pictures writes them to .media.
#include <algorithm>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <command_line.hpp>
#include <png.hpp>
#include <run.hpp>

#include <troubles.hpp>

#include "pages.hpp"

namespace {

struct page {
    std::string name;
    std::function<pictures::picture(int size)> make;
    int size;  ///< as the pages show it
};

std::vector<page> pages() {
    std::vector<page> all{{"hero", pictures::hero, 1280},
                          {"two_views", pictures::two_views, 828},
                          {"filters", pictures::filter_strip, 156},
                          {"hardening", pictures::hardening_strip, 200},
                          {"biases", pictures::bias_strip, 156},
                          {"depths", pictures::depth_strip, 208},
                          {"cascades", pictures::cascade_ranges, 828},
                          {"pages", pictures::page_grid, 828},
                          {"originals", pictures::originals, 480}};
    for (const shadow_render::trouble& t : shadow_render::troubles())
        all.push_back({std::string(t.name), [name = t.name](int size) { return pictures::trouble(name, size); }, 300});
    return all;
}

void make(int argc, const char* const* argv) {
    std::filesystem::path folder = ".media";
    std::vector<std::string> names, chosen;
    const std::vector<page> all = pages();
    for (const page& p : all) names.push_back(p.name);
    int size = 0;
    CLI::App app{"Makes the pictures of the pages.", "pictures"};
    app.add_option("names", chosen, "pictures to make; without any, all")
        ->check(CLI::IsMember(names).description(""))
        ->type_name(CLI::detail::join(names, "|"));
    app.add_option("-o,--output", folder, "folder that they are written to");
    app.add_option("--size", size, "pixels of each picture's width or parts, in place of its own")
        ->check(example::within(16, 4096));
    if (!example::parse(app, argc, argv)) return;
    std::filesystem::create_directories(folder);
    for (const page& p : all)
        if (chosen.empty() || std::ranges::find(chosen, p.name) != chosen.end())
            example::write_png(folder / (p.name + ".png"), p.make(size > 0 ? size : p.size).view(),
                               example::file_size::smallest);
}

}  // namespace

int main(int argc, char** argv) {
    return example::run("pictures", [&] { make(argc, argv); });
}
