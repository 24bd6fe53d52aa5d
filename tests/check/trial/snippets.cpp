// SPDX-License-Identifier: MIT
//
// The library's own shaders are what their names say, with the same bits.
#include <umbrage/depth/encodings.hpp>
#include <umbrage/filter/filters.hpp>
#include <umbrage/shader/glsl.hpp>

#include "on_software.hpp"

using namespace check;

namespace {

constexpr auto version = umbrage::glsl::version::v330;

std::string expression(const std::string& value, int channels) {
    return channels == 4 ? value
                         : "vec4(" + value +
                               (channels == 1   ? ", 0.0, 0.0, 0.0)"
                                : channels == 2 ? ", 0.0, 0.0)"
                                                : ", 0.0)");
}

}  // namespace

TEST_CASE("own filters have their bits") {
    if (!llvmpipe()) return;
    umbrage::for_each_filter([](const auto& filter) {
        if constexpr (requires { filter.offsets; }) return;  // its coordinates are four
        const std::string name(filter.name);
        const bool box = name == "box", disc = name.starts_with("disc"), sdk = name == "pcf_2x2_dx_sdk";
        const std::string call = "umbrage_" + name + "(map, size, coord, z" +
                                 (box    ? ", 1"
                                  : disc ? ", 2.0, vec4(64.0, 0.0, 0.0, 64.0)"
                                  : sdk  ? ", 0.0"
                                         : "") +
                                 ")";
        const verdict v = of_glsl(source(version, {*filter.snippet}), call);
        CAPTURE(call);
        CAPTURE(check::text(v));
        CHECK(v.how == agreement::same_bits);
        CHECK(v.function == name + (box ? "(1)" : disc ? "(2)" : ""));
    });
}

TEST_CASE("own encodings have their bits") {
    if (!llvmpipe()) return;
    umbrage::for_each_encoding([]<class Encoding>(const Encoding& encoding) {
        if constexpr (Encoding::target::to_unorm != nullptr) {
            using target = typename Encoding::target;
            const std::string name(encoding.name);
            if (name == "float_bits") return;  // of 32 bits any float may come: its own entry in the parity suite
            const bool integers = Encoding::writes == umbrage::store_format::integers;
            std::string write = "umbrage_" + std::string(Encoding::writer->name) + "(z)";
            if (integers) write = "umbrage_" + std::string(target::to_unorm->name) + '(' + write + ')';
            const std::string written = source(version, {*target::to_unorm, *Encoding::writer});
            const verdict pack = of_glsl(written, expression(write, target::channels), name);
            CAPTURE(name);
            CAPTURE(check::text(pack));
            CHECK(pack.how == agreement::same_bits);

            constexpr const char* swizzles[]{"", ".x", ".xy", ".xyz", ""};
            const std::string read = "umbrage_" + std::string(Encoding::reader->name) + "(c" +
                                     swizzles[target::channels] + (umbrage::has_edge<Encoding> ? ", 1.0)" : ")");
            const verdict unpack = of_glsl(source(version, {*Encoding::reader}), read, name);
            CAPTURE(check::text(unpack));
            CHECK(unpack.how == agreement::same_bits);
        }
    });
}
