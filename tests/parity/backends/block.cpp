// SPDX-License-Identifier: MIT
#include "block.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <sstream>

#include "../shader.hpp"
#include "../texture.hpp"

namespace parity {

std::string joined_parts(const std::vector<std::string>& parts) {
    std::string all;
    for (const std::string& p : parts) {
        const auto length = static_cast<std::uint32_t>(p.size());
        all.append(reinterpret_cast<const char*>(&length), sizeof length);
        all += p;
        all.append((4 - p.size() % 4) % 4, '\0');
    }
    return all;
}

std::string block_of(dialect d, const job& j, std::size_t count, bool with_textures) {
    const bool bytes = j.what->output == target::rgba8;
    const vec2 map_size(j.map ? j.map->size() : ivec2(0));
    const shader text = make_shader(*j.what, d, d == version::v300_es ? shader_stage::bits : shader_stage::fragment);

    std::ostringstream head;
    std::vector<std::string> parts{"", text.vertex, text.fragment};
    head << "{\"version\": " << web_version(d) << ", \"bytes\": " << (bytes ? "true" : "false") << ", \"size\": ["
         << width << ", " << rows(j.count) << "], \"rows\": " << rows(count) << ", \"map_size\": [" << map_size.x
         << ", " << map_size.y << "], \"spare_unit\": " << max_textures;
    if (with_textures) {
        head << ", \"textures\": [";
        const auto names = uniforms(*j.what);
        for (const filled_texture& t : textures(j)) {
            head << (parts.size() > 3 ? ", " : "") << "{\"name\": \"" << names[t.unit].name
                 << "\", \"unit\": " << t.unit
                 << ", \"sampler\": " << (t.unit < max_inputs ? 0 : sampler_binding(t.unit))
                 << ", \"shape\": " << t.image.shape << ", \"format\": " << t.image.format
                 << ", \"compare\": " << t.image.compare << ", \"linear\": " << (t.image.linear ? "true" : "false")
                 << ", \"size\": [" << t.image.size.x << ", " << t.image.size.y << "], \"layers\": " << t.image.layers
                 << '}';
            parts.push_back(t.bytes());
        }
        head << ']';
    }
    head << '}';
    parts.front() = head.str();
    return joined_parts(parts);
}

std::vector<vec4> results_of(const job& j, std::size_t count, const char* pixels) {
    std::vector<vec4> results(count);
    if (j.what->output == target::rgba8) {
        const auto* read = reinterpret_cast<const glm::vec<4, std::uint8_t>*>(pixels);
        std::copy(read, read + count, results.begin());
    } else {
        std::memcpy(results.data(), pixels, count * sizeof(vec4));
    }
    return results;
}

}  // namespace parity
