// SPDX-License-Identifier: MIT
//
// SPIR-V from the reference compiler.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

namespace parity {

/// Works in a folder that goes with it.
class spirv_compiler {
public:
    spirv_compiler() {
        std::string name = (std::filesystem::temp_directory_path() / "umbrage-XXXXXX").string();
        if (!mkdtemp(name.data())) throw std::runtime_error("no folder for SPIR-V");
        folder_ = name;
    }
    ~spirv_compiler() {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }
    spirv_compiler(const spirv_compiler&) = delete;
    spirv_compiler& operator=(const spirv_compiler&) = delete;

    enum language { glsl, hlsl };

    /// @throws std::runtime_error   with the compiler's words
    [[nodiscard]] std::vector<std::uint32_t> compile(const std::string& stage, const std::string& text,
                                                     language in = glsl) const {
        const std::string file = (folder_ / ("shader." + stage)).string(), module = file + ".spv", log = file + ".log";
        std::ofstream(file) << text;
        const std::string options = in == hlsl ? " -D -e main" : "";
        const std::string command =
            UMBRAGE_GLSLANG " -V --quiet" + options + " '" + file + "' -o '" + module + "' > '" + log + "' 2>&1";
        if (std::system(command.c_str()) != 0) {
            std::ifstream words(log);
            throw std::runtime_error(std::string(std::istreambuf_iterator<char>(words), {}) + '\n' + text);
        }
        std::vector<std::uint32_t> code(std::filesystem::file_size(module) / 4);
        std::ifstream(module, std::ios::binary)
            .read(reinterpret_cast<char*>(code.data()), static_cast<std::streamsize>(code.size() * 4));
        return code;
    }

private:
    std::filesystem::path folder_;
};

}  // namespace parity
