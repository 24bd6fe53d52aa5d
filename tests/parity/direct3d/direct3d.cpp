// SPDX-License-Identifier: MIT
//
// Microsoft's HLSL compilers accept every entry's shader, and every kind of map:
//
//     direct3d WINE COMPILE_EXE FOLDER_OF_DLLS FOLDER
//
// Exit status: 0 they do, 1 they do not, 77 something of it is missing.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include <umbrage/filter/pcf/pcf_2x2.hpp>
#include <umbrage/shader/hlsl.hpp>

#include "../shader.hpp"

namespace {

namespace fs = std::filesystem;
using namespace parity;

std::vector<std::string> shaders() {
    std::vector<std::string> all;
    for (const entry& e : entries())
        if (e.runs_in(dialect::hlsl)) all.push_back(make_hlsl(e));
    using enum umbrage::glsl::texture;
    for (const auto kind :
         {texture_2d, atlas, array, cube, cube_faces, integer, depth, depth_array, shadow, shadow_array})
        for (const bool gather : {false, true})
            for (const auto outside : {umbrage::outside_map::bordered, umbrage::outside_map::clamped}) {
                if (gather && !umbrage::glsl::detail::gathers(kind)) continue;
                const umbrage::glsl::binding map{.texture = kind,
                                                 .outside = outside,
                                                 .gather = gather,
                                                 .origin = "float2(64.0, 0.0)",
                                                 .texture_size = "float2(128.0, 64.0)"};
                all.push_back(umbrage::hlsl::text({bind(umbrage::glsl::pcf_2x2, "tile", map)}) +
                              "float4 main() : SV_Target0 { return 0; }\n");
            }
    return all;
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc != 5) throw std::invalid_argument("four arguments");
    const fs::path wine = argv[1], compile = argv[2], libraries = argv[3], folder = argv[4];
    for (const fs::path& need : {wine, compile, libraries / "d3dcompiler_47.dll", libraries / "dxcompiler.dll"})
        if (!fs::exists(need)) {
            std::cout << "SKIPPED: no " << need << '\n';
            return 77;
        }
    fs::remove_all(folder);
    fs::create_directories(folder);
    std::string names;
    std::size_t count = 0;
    for (const std::string& text : shaders()) {
        const std::string name = std::to_string(count++) + ".hlsl";
        std::ofstream(folder / name) << text;
        names += " " + name;
    }
    setenv("WINEPREFIX", (fs::absolute(folder) / "wine").c_str(), 1);
    setenv("WINEDEBUG", "-all", 1);
    int refused = 0;
    for (const char* library : {"d3dcompiler_47.dll", "dxcompiler.dll"}) {
        std::cout << library << std::endl;
        const std::string command = "cd '" + folder.string() + "' && '" + wine.string() + "' '" + compile.string() +
                                    "' 'Z:" + (fs::absolute(libraries) / library).string() + "'" + names;
        refused += std::system(command.c_str()) != 0;
    }
    return refused ? 1 : 0;
} catch (const std::exception& error) {
    std::cerr << "direct3d: " << error.what() << '\n';
    return 2;
}
