// SPDX-License-Identifier: MIT
//
// The back end that runs the snippets' Metal as C++.
#include "metal_text.hpp"

#include <stdexcept>

#include <umbrage/unorm.hpp>

#include "backend.hpp"
#include "shader.hpp"

namespace parity {
namespace {

class metal final : public backend {
public:
    [[nodiscard]] std::string name() const override { return "Metal as C++"; }
    [[nodiscard]] std::vector<dialect> dialects() const override { return {dialect::msl}; }
    [[nodiscard]] std::vector<vec4> run(dialect, const job& j, std::size_t count) override {
        using namespace umbrage;
        const auto call = function_of(static_cast<std::size_t>(j.what - entries().data()));
        const auto texture_of = [](const texels& t) {
            return metal_text::texture{t.texels().data(), static_cast<unsigned>(t.size().x),
                                       static_cast<unsigned>(t.size().y)};
        };
        const auto map = j.map ? texture_of(*j.map) : metal_text::texture(), table = texture_of(j.what->table);
        const bool bytes = j.what->output == target::rgba8;
        std::vector<vec4> results;
        results.reserve(count);
        for (std::size_t i = 0; i < count; ++i) {
            const vec4 c = call(j.at(i).x.data(), map, table);
            results.push_back(bytes ? vec4(store_unorm8(c, i % 2 ? unorm_store::truncates : unorm_store::rounds)) : c);
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
