// SPDX-License-Identifier: MIT
//
// The back end that runs the snippets' text as C++. Its 8-bit target rounds and truncates in turn.
#include "cpp_text.hpp"

#include <umbrage/unorm.hpp>

#include "shader.hpp"

namespace parity {
namespace {

class cpp_text final : public backend {
public:
    [[nodiscard]] std::string name() const override { return "text as C++"; }
    [[nodiscard]] std::vector<dialect> dialects() const override { return {version::v460}; }
    [[nodiscard]] std::string label(dialect) const override { return "C++"; }
    [[nodiscard]] bool has_compiler() const override { return false; }
    [[nodiscard]] std::vector<vec4> run(dialect, const job& j, std::size_t count) override {
        using namespace umbrage;
        const auto call = glsl_as_cpp::functions.at(static_cast<std::size_t>(j.what - entries().data()));
        const std::vector<filled_texture> all = textures(j);
        std::array<const filled_texture*, max_textures> by_unit{};
        for (const filled_texture& t : all) by_unit[t.unit] = &t;
        std::vector<vec4> results;
        results.reserve(count);
        const bool bytes = j.what->output == target::rgba8;
        for (std::size_t i = 0; i < count; ++i) {
            const vec4 c = call(j.at(i), by_unit.data());
            results.push_back(bytes ? vec4(store_unorm8(c, i % 2 ? unorm_store::truncates : unorm_store::rounds)) : c);
        }
        return results;
    }
};

}  // namespace

backends cpp_backends() {
    backends all;
    all.push_back(std::make_unique<cpp_text>());
    return all;
}

}  // namespace parity
