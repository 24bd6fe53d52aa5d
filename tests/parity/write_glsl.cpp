// SPDX-License-Identifier: MIT
//
// Writes NAME.glsl, ready to paste, for every snippet:  write_glsl FOLDER
#include <filesystem>
#include <fstream>
#include <iostream>

#include <umbrage/shader/glsl.hpp>
#include <umbrage/shader/registry.hpp>

int main(int argc, char** argv) try {
    if (argc != 2) return 2;
    const std::filesystem::path folder = argv[1];
    std::filesystem::create_directories(folder);
    for (const umbrage::glsl::snippet* s : umbrage::glsl::registry) {
        std::ofstream file(folder / (std::string(s->name) + ".glsl"));
        file << "// SPDX-License-Identifier: MIT\n// umbrage: " << s->summary << '\n' << umbrage::glsl::text({*s});
        if (!file) throw std::runtime_error("cannot write into " + folder.string());
    }
} catch (const std::exception& error) {
    std::cerr << "write_glsl: " << error.what() << '\n';
    return 1;
}
