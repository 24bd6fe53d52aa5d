// SPDX-License-Identifier: MIT
//
// The back ends that run the snippets' text as C++. Their 8-bit target rounds and truncates in turn.
#include "cpp_text.hpp"

#include <umbrage/core/unorm.hpp>

#include "../shader.hpp"

namespace parity {

namespace glsl_as_fused {
extern const std::vector<glsl_as_cpp::function> functions;
}

namespace {

class cpp_text final : public backend {
public:
    cpp_text(std::string name, const std::vector<glsl_as_cpp::function>& functions)
        : name_(std::move(name)), functions_(functions) {}
    [[nodiscard]] std::string name() const override { return name_; }
    [[nodiscard]] std::vector<dialect> dialects() const override { return {version::v460}; }
    [[nodiscard]] std::string label(dialect) const override { return "C++"; }
    [[nodiscard]] bool has_compiler() const override { return false; }
    [[nodiscard]] std::vector<vec4> run(dialect, const job& j, std::size_t count) override {
        using namespace umbrage;
        const auto call = functions_.at(static_cast<std::size_t>(j.what - entries().data()));
        const std::vector<filled_texture> all = textures(j);
        std::array<const filled_texture*, max_textures> by_unit{};
        for (const filled_texture& t : all) by_unit[t.unit] = &t;
        std::vector<vec4> results;
        results.reserve(count);
        const bool bytes = j.what->output == target::rgba8;
        for (std::size_t i = 0; i < count; ++i) {
            const vec4 c = call(j.at(i), by_unit.data());
            results.push_back(bytes ? vec4(store_unorm(c, i % 2 ? unorm_store::truncates : unorm_store::rounds)) : c);
        }
        return results;
    }

private:
    std::string name_;
    const std::vector<glsl_as_cpp::function>& functions_;
};

}  // namespace

backends cpp_backends() {
    backends all;
    all.push_back(std::make_unique<cpp_text>("text as C++", glsl_as_cpp::functions));
    return all;
}

backends fused_backends() {
    backends all;
#ifdef UMBRAGE_FUSED
    if (__builtin_cpu_supports("fma"))
        all.push_back(std::make_unique<cpp_text>("text as C++, fused", glsl_as_fused::functions));
#endif
    return all;
}

}  // namespace parity
