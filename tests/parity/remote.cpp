// SPDX-License-Identifier: MIT
#include "remote.hpp"

#include <algorithm>
#include <cstring>
#include <sstream>
#include <utility>

#include "shader.hpp"
#include "texture.hpp"

namespace parity {

std::vector<vec4> remote::run(dialect d, const job& j, std::size_t count) {
    const bool bytes = j.what->output == target::rgba8;
    const vec2 map_size(j.map ? j.map->size() : ivec2(0));
    const shader text = make_shader(*j.what, d);

    std::ostringstream head;
    std::vector<std::string> parts{"", text.vertex, text.fragment};
    head << "{\"version\": " << number(d) << ", \"bytes\": " << (bytes ? "true" : "false") << ", \"size\": [" << width
         << ", " << rows(j.count) << "], \"rows\": " << rows(count) << ", \"map_size\": [" << map_size.x << ", "
         << map_size.y << "], \"spare_unit\": " << max_textures;
    if (serial_ != j.serial) {
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
        serial_ = j.serial;
    }
    head << '}';
    parts.front() = head.str();

    const std::string pixels = ask(parts);
    std::vector<vec4> result(count);
    if (bytes) {
        const auto* read = reinterpret_cast<const glm::vec<4, std::uint8_t>*>(pixels.data());
        std::copy(read, read + count, result.begin());
    } else {
        std::memcpy(result.data(), pixels.data(), count * sizeof(vec4));
    }
    return result;
}

std::string remote::ask(const std::vector<std::string>& parts) {
    std::string block;
    for (const std::string& p : parts) {
        const auto length = static_cast<std::uint32_t>(p.size());
        block.append(reinterpret_cast<const char*>(&length), sizeof length);
        block += p;
        block.append((4 - p.size() % 4) % 4, '\0');
    }
    return program_.answer(block);
}

}  // namespace parity
