// SPDX-License-Identifier: MIT
//
// Every channel of 8, 10 and 16 bits through a real render target: to_unorm's values are stored as the channels they
// stand for. The one argument is a driver of Mesa's.
#include <iostream>
#include <string>
#include <vector>

#include <umbrage/core/unorm.hpp>

#include "backend.hpp"

namespace parity {
namespace {

/// Channels that come back as others.
int wrong(backend& b, dialect d, const umbrage::glsl::snippet& to_unorm, int bits, target to) {
    std::vector<vec4> channels;
    for (int k = 0; k < 1 << bits; ++k) channels.push_back(vec4(static_cast<float>(k)));
    const std::string call = "vec4(umbrage_" + std::string(to_unorm.name) + "(vec3(x0.x, x0.y, x0.z)), 1.0)";
    const auto stored = run_once(b, d, {.primitive = &to_unorm, .call = call, .output = to}, {channels});
    int count = 0;
    for (std::size_t k = 0; k < channels.size(); ++k) count += glm::vec3(stored[k]) != glm::vec3(channels[k]);
    return count;
}

int look_at_all(const char* driver) {
    int tried = 0, all_wrong = 0;
    for (const auto& b : egl_backends(driver))
        for (const dialect d : b->dialects()) {
            if (umbrage::glsl::directive(d.of_glsl) != "330") continue;
            const int of_8 = wrong(*b, d, umbrage::glsl::to_unorm, 8, target::rgba8),
                      of_10 = wrong(*b, d, umbrage::glsl::to_unorm10, 10, target::rgb10_a2),
                      of_16 = wrong(*b, d, umbrage::glsl::to_unorm16, 16, target::rgba16);
            std::cout << b->name() << ": wrong of 256 RGBA8 " << of_8 << ", of 1024 RGB10_A2 " << of_10
                      << ", of 65536 RGBA16 " << of_16 << '\n';
            all_wrong += of_8 + of_10 + of_16, ++tried;
        }
    if (tried == 0) std::cout << "SKIPPED: no Mesa through EGL here\n";
    return tried == 0 ? 77 : (all_wrong > 0 ? 1 : 0);
}

}  // namespace
}  // namespace parity

int main(int argc, char** argv) { return argc == 2 ? parity::look_at_all(argv[1]) : 2; }
