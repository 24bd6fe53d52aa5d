// SPDX-License-Identifier: MIT
#include "check.hpp"

#include <cstdio>
#include <memory>

#include <sys/wait.h>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#include <stb/stb_image.h>

namespace viewer_check {

std::string quoted(const std::filesystem::path& path) { return std::string("'").append(path.string()).append("' "); }

result run(const std::string& command) {
    FILE* pipe = popen((command + " 2>&1").c_str(), "r");
    REQUIRE(pipe);
    result out{0, {}};
    for (int c; (c = std::fgetc(pipe)) != EOF;) out.said += static_cast<char>(c);
    const int status = pclose(pipe);
    out.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return out;
}

picture load(const std::filesystem::path& file) {
    int width = 0, height = 0, channels = 0;
    const std::unique_ptr<stbi_uc, void (*)(void*)> data(
        stbi_load(file.string().c_str(), &width, &height, &channels, 3), stbi_image_free);
    REQUIRE_MESSAGE(data, file.string());
    picture out({width, height});
    for (std::size_t i = 0; i < out.texels().size(); ++i)
        out.texels()[i] = {data.get()[3 * i], data.get()[3 * i + 1], data.get()[3 * i + 2]};
    return out;
}

picture viewed(const std::string& arguments, const std::string& in) {
    const std::filesystem::path file = folder / "viewed.png";
    std::filesystem::remove(file);
    const result r = run(in + quoted(VIEWER) + "--screenshot " + quoted(file) + arguments);
    CAPTURE(arguments);
    REQUIRE_MESSAGE(r.code == 0, r.said);
    return load(file);
}

int differing(const picture& a, const picture& b) {
    REQUIRE(a.size() == b.size());
    int count = 0;
    for (std::size_t i = 0; i < a.texels().size(); ++i) count += a.texels()[i] != b.texels()[i];
    return count;
}

}  // namespace viewer_check
