// SPDX-License-Identifier: MIT
//
// Shader texts of random lists, maps and names: refused by a clear message, or whole, with each function once.
#include <set>
#include <string>
#include <vector>

#include <umbrage/registry.hpp>
#include <umbrage/shader/glsl.hpp>
#include <umbrage/shader/hlsl.hpp>
#include <umbrage/shader/msl.hpp>
#include <umbrage/shader/wgsl.hpp>

#include "input.hpp"

namespace {

using namespace umbrage;

std::string words(fuzz::input& in) {
    static constexpr std::array all{"",     "sun", "a_b",   "a__b", "_a", "1",  "vec2(5.0, 3.0)", "value.xy",
                                    "x; y", "(",   "sun\n", "\"",   "é",  "//", "texel.x",        "receiver < stored",
                                    "map",  "if"};
    std::string text = all[in.bits() % all.size()];
    if (in.chance(8)) text += static_cast<char>(in.within(0, 255));
    return text;
}

void must_be_whole(const std::string& text) {
    int depth = 0;
    for (const char c : text) {
        depth += (c == '{') - (c == '}');
        fuzz::must(depth >= 0, "braces open before they close");
    }
    fuzz::must(depth == 0, "every brace closes");
    fuzz::must(text.find("UMBRAGE_MAP ") == text.npos, "no map is left to fill in");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    fuzz::input in(bytes, size);
    std::vector<glsl::bound> items;
    for (int i = in.within(0, 4); i > 0; --i) {
        const auto& all = glsl::registry();
        const glsl::snippet& what = *all[in.bits() % all.size()];
        glsl::binding map;
        map.texture = static_cast<glsl::texture>(in.within(0, 9));
        map.gather = in.chance(3);
        map.direction = in.chance(2) ? depth_direction::forward : depth_direction::reversed;
        map.receiver_plane = in.chance(4);
        if (in.chance(2)) map.outside = in.chance(2) ? outside_map::bordered : outside_map::clamped;
        if (in.chance(4)) map.depth = words(in), map.channels = in.within(-1, 5);
        if (in.chance(4)) map.compare = words(in);
        if (in.chance(4)) map.origin = words(in);
        if (in.chance(4)) map.texture_size = words(in);
        if (in.chance(8)) map.parameters = words(in), map.arguments = words(in), map.texel = words(in);
        fuzz::answered([&] { items.push_back(in.chance(3) ? glsl::bound(what) : glsl::bind(what, words(in), map)); });
    }
    const glsl::version version = glsl::versions[in.bits() % std::size(glsl::versions)];
    fuzz::answered([&] { must_be_whole(glsl::text(items, version)); });
    fuzz::answered([&] { must_be_whole(hlsl::text(items)); });
    fuzz::answered([&] { must_be_whole(msl::text(items)); });
    fuzz::answered([&] { must_be_whole(wgsl::text(items)); });
    return 0;
}
