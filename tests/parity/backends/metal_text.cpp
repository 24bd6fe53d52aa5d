// SPDX-License-Identifier: MIT
//
// The back end that runs the snippets' Metal as C++.
#include "metal_text.hpp"

#include <array>
#include <stdexcept>

#include <umbrage/core/unorm.hpp>

#include "../backend.hpp"
#include "../shader.hpp"
#include "../texture.hpp"

namespace parity {
namespace {

class metal final : public backend {
public:
    [[nodiscard]] std::string name() const override { return "Metal as C++"; }
    [[nodiscard]] std::vector<dialect> dialects() const override { return {dialect::msl}; }
    [[nodiscard]] bool has_compiler() const override { return false; }
    [[nodiscard]] std::vector<vec4> run(dialect, const job& j, std::size_t count) override {
        using namespace umbrage;
        const auto call = function_of(static_cast<std::size_t>(j.what - entries().data()));
        std::array<metal_text::memory, max_bindings> units;
        std::vector<std::string> bytes_of;  // each lies where it is put
        std::vector<filled_texture> all = textures(j);
        bytes_of.reserve(all.size());
        for (filled_texture& t : all) {
            if (t.unit < max_inputs) continue;
            if (t.image.has_depths()) t.image.format = texture_image::depths;
            const glm::uvec2 size(t.image.size);
            bytes_of.push_back(t.bytes());
            units[t.unit] = units[sampler_binding(t.unit)] = {bytes_of.back().data(), size.x, size.y, t.image.compare,
                                                              t.image.linear};
        }
        const bool bytes = j.what->output == target::rgba8;
        std::vector<vec4> results;
        results.reserve(count);
        for (std::size_t i = 0; i < count; ++i) {
            const sample s = j.at(i);
            vec4 c;
            call(reinterpret_cast<const float(*)[4]>(s.x.data()), units.data(), &c.x);
            results.push_back(bytes ? vec4(store_unorm(c, i % 2 ? unorm_store::truncates : unorm_store::rounds)) : c);
        }
        return results;
    }

private:
    [[nodiscard]] static metal_text::function function_of(std::size_t entry) {
        if (planted.from.empty()) return metal_text::functions[entry];
        const metal_text::mistaken* m = metal_text::mistakes;
        while (m->call && !(m->from == planted.from && m->entry == entry)) ++m;
        if (!m->call) throw std::runtime_error("this mistake was not compiled");
        return m->call;
    }
};

}  // namespace

backends metal_backends() {
    backends all;
    all.push_back(std::make_unique<metal>());
    return all;
}

}  // namespace parity
