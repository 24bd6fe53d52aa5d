// SPDX-License-Identifier: MIT
//
// The two-channel encodings in mediump. llvmpipe really computes it at 16 bits in a GLES context, which is asked first;
// so is whether highp results come through that context whole.
//
//     mediump      prints a table; exit status 0 as expected, 1 otherwise, 77 no llvmpipe here
#include <array>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <stdexcept>

#include <umbrage/core/unorm.hpp>
#include <umbrage/depth/rg.hpp>

#include "backend.hpp"

namespace parity {
namespace {

// Snippets in mediump, what is around them in highp: positions in a texture of inputs need it.
const std::string low = "#define UMBRAGE_HIGHP mediump\n";
constexpr snippet high_again{
    .name = "high_again", .summary = {}, .source = "\n#undef UMBRAGE_HIGHP\n#define UMBRAGE_HIGHP highp\n"};

/// `call` over inputs x0, in mediump.
std::vector<vec4> run(backend& b, version v, const snippet& s, std::string call, std::vector<vec4> inputs,
                      target output = target::rgba32f) {
    return run_once(b, v,
                    {.primitive = &s,
                     .call = std::move(call),
                     .also = {&umbrage::glsl::to_unorm, &high_again},
                     .preamble = low,
                     .output = output},
                    {std::move(inputs)});
}

/// Every binary16 value in [0, 1].
std::vector<vec4> half_depths() {
    std::vector<vec4> all;
    for (int bits = 0; bits <= 0x3C00; ++bits) {
        const int exponent = bits >> 10, fraction = bits & 0x3FF;
        all.emplace_back(exponent ? std::ldexp(float(1024 + fraction), exponent - 25)
                                  : std::ldexp(float(fraction), -24));
    }
    return all;
}

bool computes_at_16_bits(backend& b, version v) {
    static constexpr snippet plus_one{
        .name = "plus_one", .summary = {}, .source = "\nmediump float plus_one(mediump float v) { return v + 1.0; }\n"};
    return run(b, v, plus_one, "vec4(plus_one(x0.x))", {vec4(2048.0f)}).front().x == 2048.0f;
}

/// True when results reach us with all their bits, out of branches too: gl_FragColor is mediump in GLSL ES 1.00.
bool results_are_whole(backend& b, version v) {
    static constexpr snippet thrice{.name = "thrice", .summary = {}, .source = R"(
highp float thrice(highp float v) {
    if (v > 1.0) return 1.0;
    highp float sum = 0.0;
    for (int i = 0; i < 3; i++) sum += v;
    return sum;
}
)"};
    const float third = 0x1.555554p-2f;
    return run(b, v, thrice, "vec4(thrice(x0.x))", {vec4(third)}).front().x == third + third + third;
}

/// Codes wrong at the lower edge, the center and the upper edge; half depths whose channels are wrong, as floats or as
/// bytes.
struct faults {
    std::array<int, 3> codes{};
    int depths = 0;
    bool operator==(const faults&) const = default;
};

template <int Bits>
faults look(backend& b, version v) {
    const std::string name = "rg" + std::to_string(Bits);
    faults f;

    std::vector<vec4> channels;
    for (int e = 0; e < 3; ++e)
        for (int x = 0; x < 1 << Bits; ++x) {
            const vec2 k = umbrage::encode_rg<Bits>(std::ldexp(float(x), -Bits));
            channels.push_back(vec4(k / 255.0f, 0.5f * float(e), 0.0f));
        }
    const auto decoded = run(b, v, umbrage::glsl::decode_rg<Bits>,
                             "vec4(umbrage_decode_" + name + "(vec2(x0.x, x0.y), x0.z))", channels);
    for (std::size_t i = 0; i < decoded.size(); ++i) {
        const std::size_t edge = i >> Bits, x = i & ((std::size_t(1) << Bits) - 1);
        f.codes[edge] += decoded[i].x != std::ldexp(float(x) + 0.5f * float(edge), -Bits);
    }

    const auto depths = half_depths();
    const std::string call = "vec4(umbrage_encode_" + name + "(x0.x), 0.0, 255.0)";
    const auto floats = run(b, v, umbrage::glsl::encode_rg<Bits>, call, depths);
    const auto bytes =
        run(b, v, umbrage::glsl::encode_rg<Bits>, "umbrage_to_unorm(" + call + ")", depths, target::rgba8);
    for (std::size_t i = 0; i < depths.size(); ++i) {
        const vec4 k(vec2(umbrage::encode_rg<Bits>(depths[i].x)), 0.0f, 255.0f);
        f.depths += floats[i] != k || bytes[i] != k;
    }
    std::cout << std::setw(4) << Bits << std::setw(8) << (1 << Bits) << std::setw(13) << f.codes[0] << std::setw(9)
              << f.codes[1] << std::setw(13) << f.codes[2] << std::setw(9) << f.depths << " of " << depths.size()
              << '\n';
    return f;
}

int look_at_all() {
    const backends all = egl_backends("llvmpipe");
    if (all.empty()) {
        std::cout << "SKIPPED: no llvmpipe through EGL here\n";
        return 77;
    }
    backend& b = *all.front();
    int wrong = 0;
    for (const dialect d : b.dialects()) {
        const version v = d.of_glsl;
        if (directive(v) != "100" && directive(v).find("es") == std::string_view::npos) continue;
        if (!computes_at_16_bits(b, v)) {
            ++wrong;
            std::cout << "GLSL " << directive(v) << ": 2048 + 1 is not 2048\n";
            continue;
        }
        if (!results_are_whole(b, v)) {
            ++wrong;
            std::cout << "GLSL " << directive(v) << ": a result of 24 bits is rounded on its way out\n";
        }
        std::cout << "GLSL " << directive(v) << ", mediump at 16 bits\n"
                  << "bits   codes   wrong: lower   center   upper edge   half depths wrong\n";
        wrong += look<9>(b, v) != faults{};
        wrong += look<10>(b, v) != faults{};
        wrong += look<11>(b, v) != faults{{0, 1024, 0}, 0};  // half of the centers need a twelfth bit
        wrong += look<12>(b, v).codes[0] == 0;               // one bit more does not fit
    }
    std::cout << wrong << " surprises\n";
    return wrong ? 1 : 0;
}

}  // namespace
}  // namespace parity

int main() try { return parity::look_at_all(); } catch (const std::exception& error) {
    std::cerr << "mediump: " << error.what() << '\n';
    return 2;
}
