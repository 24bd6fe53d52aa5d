// SPDX-License-Identifier: MIT
//
// Writes the shaders of Direct3D 12 and Metal for their compilers:  recipes_write_shaders FOLDER
#include <filesystem>
#include <fstream>

#include "../../examples/recipes/shaders.hpp"

int main(int argc, char** argv) {
    const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "direct3d12.hlsl") << shaders::direct3d12();
    std::ofstream(folder / "metal.metal") << shaders::metal();
    return 0;
}
