// SPDX-License-Identifier: MIT
#include "remote.hpp"

#include <cstring>
#include <sstream>
#include <utility>

#include "shader.hpp"

namespace parity {
namespace {

constexpr int width = 1024;

}  // namespace

std::vector<vec4> remote::run(dialect d, const job& j, std::size_t count) {
    const int height = static_cast<int>((j.count + width - 1) / width);
    const int rows = static_cast<int>((count + width - 1) / width);
    const bool bytes = j.what->output == target::rgba8;
    const vec2 map_size(j.map ? j.map->size() : ivec2(0));
    const shader text = make_shader(*j.what, d);

    std::ostringstream head;
    std::vector<std::string> parts{"", text.vertex, text.fragment};
    head << "{\"version\": " << number(d) << ", \"bytes\": " << (bytes ? "true" : "false") << ", \"size\": [" << width
         << ", " << height << "], \"rows\": " << rows << ", \"map_size\": [" << map_size.x << ", " << map_size.y
         << "], \"spare_unit\": " << max_inputs + 2;
    if (serial_ != j.serial) {
        head << ", \"textures\": [";
        const auto names = samplers(*j.what);
        const auto add = [&](std::size_t unit, const auto& values, ivec2 size) {
            head << (parts.size() > 3 ? ", " : "") << "{\"name\": \"" << names[unit] << "\", \"unit\": " << unit
                 << ", \"size\": [" << size.x << ", " << size.y << "]}";
            std::string floats(static_cast<std::size_t>(size.x * size.y) * sizeof(vec4), '\0');
            std::memcpy(floats.data(), values.data(), values.size() * sizeof(vec4));
            parts.push_back(std::move(floats));
        };
        for (std::size_t k = 0; k < max_inputs; ++k)
            if (!j.x[k].empty()) add(k, j.x[k], {width, height});
        if (j.map) add(max_inputs, j.map->texels(), j.map->size());
        if (!j.what->table.empty()) add(max_inputs + 1, j.what->table.texels(), j.what->table.size());
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
