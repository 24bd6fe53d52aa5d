// SPDX-License-Identifier: MIT
#include "png.hpp"

#include <cstring>
#include <memory>
#include <stdexcept>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#include <stb/stb_image.h>

namespace example {

template <class Texel>
umbrage::image<Texel> read_png(const std::filesystem::path& path) {
    int width = 0, height = 0, channels = 0;
    const std::unique_ptr<stbi_uc, void (*)(void*)> data(
        stbi_load(path.string().c_str(), &width, &height, &channels, Texel::length()), stbi_image_free);
    if (!data) throw std::runtime_error("cannot read " + path.string());
    umbrage::image<Texel> out({width, height});
    std::memcpy(out.texels().data(), data.get(), out.texels().size_bytes());
    return out;
}

template umbrage::image<glm::u8vec3> read_png(const std::filesystem::path&);
template umbrage::image<glm::u8vec4> read_png(const std::filesystem::path&);

}  // namespace example
