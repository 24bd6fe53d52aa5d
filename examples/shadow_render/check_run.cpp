// SPDX-License-Identifier: MIT
#include "check.hpp"

#include <cstdio>
#include <fstream>
#include <memory>

#include <sys/wait.h>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#include <stb/stb_image.h>

namespace shadow_render_check {

std::string quoted(const std::filesystem::path& path) { return std::string("'").append(path.string()).append("' "); }

result run(const std::string& arguments) {
    std::filesystem::create_directories(folder);
    const std::string command = quoted(PROGRAM) + arguments + " 2>&1";
    FILE* pipe = popen(command.c_str(), "r");
    REQUIRE(pipe);
    result out{0, {}};
    for (int c; (c = std::fgetc(pipe)) != EOF;) out.said += static_cast<char>(c);
    const int status = pclose(pipe);
    out.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return out;
}

void fails(const std::string& arguments, int code, const std::string& why) {
    CAPTURE(arguments);
    const result r = run(arguments);
    CHECK_MESSAGE(r.code == code, r.said);
    CHECK_MESSAGE(r.said.find(why) != std::string::npos, r.said);
    CHECK_MESSAGE(r.said.find('\n') == r.said.size() - 1, r.said);
}

std::string output(const std::string& name) { return std::string("--quiet --output ").append(quoted(folder / name)); }

umbrage::image<glm::u8vec4> picture(const std::string& name, const char* file) {
    int width = 0, height = 0, channels = 0;
    const std::unique_ptr<stbi_uc, void (*)(void*)> data(
        stbi_load((folder / name / file).string().c_str(), &width, &height, &channels, 4), stbi_image_free);
    REQUIRE(data);
    umbrage::image<glm::u8vec4> out({width, height});
    const stbi_uc* from = data.get();
    for (glm::u8vec4& texel : out.texels()) {
        texel = {from[0], from[1], from[2], from[3]};
        from += 4;
    }
    return out;
}

std::string file(const std::string& name, const std::string& content) {
    std::filesystem::create_directories(folder);
    std::ofstream(folder / name, std::ios::binary) << content;
    return quoted(folder / name);
}

}  // namespace shadow_render_check
