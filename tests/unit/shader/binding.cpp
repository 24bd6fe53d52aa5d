// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <umbrage/shader/binding.hpp>

#include <string>

#include <umbrage/depth/encodings.hpp>
#include <umbrage/filter/pcf/hard.hpp>
#include <umbrage/shader/glsl.hpp>

using namespace umbrage;
using namespace umbrage::glsl;

TEST_CASE("stored_as: a texel of any encoding becomes the depth that its reader gives") {
    for_each_encoding([]<class Encoding>(const Encoding& encoding) {
        CAPTURE(Encoding::name);
        const binding map = stored_as(encoding, {.texture = texture::array, .outside = outside_map::clamped});
        CHECK(map.texture == texture::array);
        CHECK(map.outside == outside_map::clamped);
        CHECK(map.direction == encoding.direction);
        const snippet* reader = Encoding::reader;
        CHECK(map.depth.empty() == (reader == nullptr));
        CHECK(map.needs.size() == (reader ? 1u : 0u));
        if (!reader) return;
        const std::string text = glsl::text({bind(glsl::hard, "map", map)});
        const std::string name =
            "umbrage_" + std::string(reader->name) + (umbrage::glsl::detail::is_of_map(*reader) ? "_map(" : "(");
        CHECK(text.find(" " + name) < text.find("return " + name));  // defined, and before it is called
        CHECK(text.find("return " + name) != text.npos);
    });
    CHECK(stored_as(rg<11>{}).depth == "umbrage_decode_rg11(value.xy, 1.0)");
    CHECK(stored_as(rg<11>{.direction = depth_direction::reversed}).depth == "umbrage_decode_rg11(value.xy, 0.0)");
    CHECK(stored_as(rg<11>{.edge = 0.5f}).depth == "umbrage_decode_rg11(value.xy, 0.5)");
    CHECK(stored_as(rg<11>{}).channels == 2);
    CHECK(stored_as(depth32f{}) == binding{});
}
