// SPDX-License-Identifier: MIT
//
// Properties that every encoding states, compared with its behavior.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <type_traits>

#include <umbrage/depth/encodings.hpp>

using namespace umbrage;

namespace {

template <class Encoding>
Encoding in_direction(depth_direction direction) {
    Encoding e;
    e.direction = direction;
    if constexpr (has_edge<Encoding>) e.edge = detail::safe_edge(direction);
    return e;
}

void check_snippets(const glsl::snippet* writer, const glsl::snippet* reader, store_format writes,
                    std::string_view name) {
    CHECK((reader == nullptr) == (writes == store_format::depth));
    if (!reader) return;
    CHECK(writer->name == (writes == store_format::values ? "write_" : "encode_") + std::string(name));
    CHECK(reader->name.starts_with("decode_"));
    CHECK(writer->name.find(reader->name.substr(7)) != std::string_view::npos);
}

}  // namespace

TEST_CASE("encodings: each knows itself, under a name of its own") {
    std::set<std::string_view> names;
    for_each_encoding([&]<class Encoding>(const Encoding&) {
        static_assert(known_encoding<Encoding>);
        CHECK(names.insert(Encoding::name).second);
        CHECK(Encoding::summary.ends_with('.'));
        CHECK((Encoding::writes != store_format::depth) == (Encoding::target::to_unorm != nullptr));
        check_snippets(Encoding::writer, Encoding::reader, Encoding::writes, Encoding::name);
    });
    CHECK(names.size() == encodings::size);
    CHECK(names.contains("rg11"));
}

TEST_CASE("encodings: with_encoding finds each by its name, and says when there is none") {
    for_each_encoding([&]<class Encoding>(const Encoding&) {
        bool same = false;
        CHECK(
            with_encoding(Encoding::name, [&]<class Found>(const Found&) { same = std::is_same_v<Found, Encoding>; }));
        CHECK(same);
    });
    CHECK_FALSE(with_encoding("rg8", [](const auto&) { FAIL("there is none of that name"); }));
}

TEST_CASE("encodings: an empty map decodes to the far plane, forward and reversed") {
    for_each_encoding([]<class Encoding>(const Encoding&) {
        CAPTURE(Encoding::name);
        for (const auto direction : {depth_direction::forward, depth_direction::reversed}) {
            const auto e = in_direction<Encoding>(direction);
            CHECK(e.decode(e.cleared()) == cleared_depth(direction));
        }
    });
}

TEST_CASE("encodings: NaN is far whichever way depth runs; bits of floats keep it") {
    for_each_encoding([]<class Encoding>(const Encoding&) {
        CAPTURE(Encoding::name);
        for (const float nan : {std::numeric_limits<float>::quiet_NaN(), -std::numeric_limits<float>::quiet_NaN()})
            for (const auto direction : {depth_direction::forward, depth_direction::reversed}) {
                const auto e = in_direction<Encoding>(direction);
                if constexpr (std::is_same_v<Encoding, float_bits>) CHECK(is_nan(e.decode(e.encode(nan))));
                else CHECK(e.encode(nan) == e.encode(cleared_depth(direction)));
            }
    });
}

TEST_CASE("encodings: decoded depths lie within the stated error on either side, at every edge") {
    for_each_encoding([]<class Encoding>(const Encoding& e) {
        CAPTURE(Encoding::name);
        const auto holds = [](const Encoding& encoding) {
            double below = 0, above = 0;
            for (int k = 0; k < 1 << 24; k += 97) {
                const float depth = static_cast<float>(k) / static_cast<float>(1 << 24);
                const double off = double(encoding.decode(encoding.encode(depth))) - double(depth);
                below = std::max(below, -off);
                above = std::max(above, off);
            }
            CHECK(below <= encoding.error().below);
            CHECK(above <= encoding.error().above);
        };
        holds(e);
        if constexpr (has_edge<Encoding>) {
            holds(Encoding{.edge = lower_edge<float>});
            if (Encoding::bits < 24) holds(Encoding{.edge = center<float>});
        }
    });
}

TEST_CASE("encodings: the edge that comes with a direction keeps a surface from shadowing itself") {
    CHECK(rg<11>{}.edge == upper_edge<float>);
    CHECK(rg<11>{.direction = depth_direction::reversed}.edge == lower_edge<float>);
    CHECK(rgb24{.direction = depth_direction::reversed}.edge == lower_edge<float>);
}
