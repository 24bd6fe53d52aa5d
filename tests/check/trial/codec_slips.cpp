// SPDX-License-Identifier: MIT
//
// Slips of packing and unpacking functions that a generator plants are named: constants, offsets, orders of channels.
#include <algorithm>
#include <iterator>

#include "../numbers.hpp"
#include "codec_texts.hpp"
#include "on_software.hpp"

using namespace check;

namespace {

constexpr int texts = 60, with_two = 10;

/// One that can be planted in a codec beside what is planted.
const codec_slip& one_of(const std::vector<codec_slip>& all, std::string_view codec, int channels, dice& random,
                         const codec_slip* beside = nullptr) {
    for (;;) {
        const codec_slip& slip = all[random.below(static_cast<std::uint32_t>(all.size()))];
        if (slip.channels > channels || (!slip.of_codec.empty() && slip.of_codec != codec)) continue;
        if (!beside || beside->where != slip.where) return slip;
    }
}

std::vector<std::string> sorted(std::vector<std::string> kinds) {
    std::ranges::sort(kinds);
    return kinds;
}

/// The i-th text's. Few are in Metal, unless all rounds are taken: they compile longer.
const language& language_of(int i) {
    if (i % (all_rounds() ? 4 : 30) == 3) return msl;
    return i % 3 == 0 ? glsl : i % 3 == 1 ? hlsl : wgsl;
}

/// Texts of one kind, in all languages.
template <class Codecs, class Text>
void each_is_named(const Codecs& codecs, const std::vector<codec_slip>& slips, const Text& text_of, const char* call) {
    dice random(58);
    int right = 0, tried = 0, twice = 0;
    for (int i = 0; i < texts; ++i) {
        const language& in = language_of(i);
        if (!software(in.in)) continue;
        const bool two = i % (texts / with_two) == 0;
        auto codec = codecs[random.below(static_cast<std::uint32_t>(std::size(codecs)))];
        while (two && codec.channels == 1) codec = codecs[random.below(static_cast<std::uint32_t>(std::size(codecs)))];
        std::vector<const codec_slip*> planted{&one_of(slips, codec.name, codec.channels, random)};
        if (two) planted.push_back(&one_of(slips, codec.name, codec.channels, random, planted[0]));
        codec_parts parts;
        std::vector<std::string> expected, found;
        for (const codec_slip* slip : planted) {
            parts.*(slip->where) = slip->text;
            expected.emplace_back(slip->kind);
        }
        const std::string text = text_of(in, codec, parts);
        const verdict v = of_text(in.file, text, call + parts.order + (*call == 'p' ? "" : ")"));
        for (const finding& f : v.slips) found.push_back(f.kind);
        CAPTURE(text);
        CAPTURE(parts.order);
        CAPTURE(check::text(v));
        CHECK(v.function == codec.name);
        CHECK(sorted(found) == sorted(expected));
        CHECK(v.first.has_value());
        right += v.function == codec.name && sorted(found) == sorted(expected);
        ++tried, twice += two;
    }
    MESSAGE(right, " of ", tried, " named rightly, ", twice, " of them with two slips");
}

}  // namespace

TEST_CASE("slips of packing: each is named, two at once too") {
    each_is_named(written_packers, pack_slips, pack_text, "pack(z).");
}

TEST_CASE("slips of unpacking: each is named, two at once too") {
    each_is_named(written_unpackers, unpack_slips, unpack_text, "unpack(c.");
}

TEST_CASE("codecs that are none of ours: no name, and what they depend on") {
    if (!llvmpipe()) return;
    const verdict v = of_glsl("float unpack(vec4 c) { return dot(c.rg, vec2(1.0, 1.0 / 250.0)); }", "unpack(c)");
    CHECK(v.how == agreement::unknown);
    CHECK(check::text(v).find("add 1, 0.004, 0, 0") != std::string::npos);
    CHECK(of_glsl("vec4 pack(float z) { return vec4(z * z); }", "pack(z)").how == agreement::unknown);
}
