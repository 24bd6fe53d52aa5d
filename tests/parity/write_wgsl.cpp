// SPDX-License-Identifier: MIT
//
// One shader in WGSL with every filter over every kind of map, each bound under a name of its own:  write_wgsl FILE
#include <algorithm>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include <umbrage/depth/rg.hpp>
#include <umbrage/filter/filters.hpp>
#include <umbrage/shader/wgsl.hpp>

using namespace umbrage;
using glsl::bound;
using glsl::texture;

namespace {

/// Filters that compare on their own ask a map for depths, which a comparison sampler does not give.
bool reads_depths(const glsl::snippet& filter) {
    return std::find(filter.needs.begin(), filter.needs.end(), &glsl::fetch_depth) != filter.needs.end();
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc != 2) throw std::invalid_argument("one argument");
    using enum texture;
    constexpr texture kinds[]{texture_2d, atlas, array,       cube,   cube_faces,
                              integer,    depth, depth_array, shadow, shadow_array};
    std::vector<bound> all;
    for (const texture kind : kinds)
        for (const bool gather : {false, true}) {
            if (gather && !glsl::detail::gathers(kind)) continue;
            for (const bool packed : {false, true}) {
                const bool has_channels =
                    kind == texture::texture_2d || kind == texture::atlas || kind == texture::array;
                if (packed && !has_channels) continue;
                const glsl::binding plain{.texture = kind,
                                          .direction = depth_direction::reversed,
                                          .outside = gather != packed ? outside_map::bordered : outside_map::clamped,
                                          .gather = gather};
                const std::string name = "kind" + std::to_string(static_cast<int>(kind)) + (gather ? "_gathered" : "") +
                                         (packed ? "_packed" : "");
                const bool compares = kind == texture::shadow || kind == texture::shadow_array;
                for_each_filter([&](const auto& filter) {
                    if (!compares || !reads_depths(*filter.snippet))
                        all.push_back(bind(*filter.snippet, name, packed ? glsl::stored_as(rg<11>{}, plain) : plain));
                });
            }
        }
    std::ofstream(argv[1]) << wgsl::text(all);
} catch (const std::exception& error) {
    std::cerr << "write_wgsl: " << error.what() << '\n';
    return 2;
}
