// SPDX-License-Identifier: MIT
//
// GLSL twins: what a snippet is. Texts are made of them in glsl.hpp.
//
#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

namespace umbrage::glsl {

/// How exactly a snippet and its C++ twin agree.
///   a  bit for bit on every implementation with 32-bit floats: no grouping of a sum rounds, or what it rounds is less
///      than the margin of the floor or comparison that follows
///   b  bit for bit where + - * round to nearest in written order; in any order, fused or not, within the bound
///   c  within the bound on every implementation, or within snippet::within of C++
/// The bound is n 2^-23 S from the result in real arithmetic. n is snippet::operations. S is the formula with every
/// value's magnitude and every minus a plus; a quotient a / b has S(a) S(b) / b^2, a root of a has S(a) / sqrt(a), and
/// min and max have the greater S. A C++ function's comment spells S out where its formula does not show it. Where
/// denormals are flushed, a product counts at least 2^-103 times its factors above 1. Where a comparison or floor
/// decides, the bound is on what it decides about, and inside it either side is promised. There is no bound where S is
/// above the greatest float.
enum class tier { a, b, c };

/// A GLSL dialect. `vulkan` is GLSL 450 with GL_KHR_vulkan_glsl.
enum class version { v100, v110, v120, v130, v150, v300_es, v310_es, v320_es, v330, v430, v450, v460, vulkan };

inline constexpr std::array versions{version::v100,    version::v110,    version::v120,    version::v130, version::v150,
                                     version::v300_es, version::v310_es, version::v320_es, version::v330, version::v430,
                                     version::v450,    version::v460,    version::vulkan};

/// What follows `#version`, e.g. "300 es".
[[nodiscard]] constexpr std::string_view directive(version v) {
    switch (v) {
        case version::v100: return "100";
        case version::v110: return "110";
        case version::v120: return "120";
        case version::v130: return "130";
        case version::v150: return "150";
        case version::v300_es: return "300 es";
        case version::v310_es: return "310 es";
        case version::v320_es: return "320 es";
        case version::v330: return "330";
        case version::v430: return "430";
        case version::v450: return "450";
        case version::v460: return "460";
        case version::vulkan: return "450";
    }
    return "";
}

/// Part that a map decides for itself. Such a snippet's own text is that of a plain map, a 2D texture of depths;
/// bind() puts another in its place for other maps.
enum class hook {
    none,
    map_covers,
    cleared_depth,
    beyond_far_plane,
    within_far_plane,
    compare,
    texel,
    fetch_depth,
    lit,
    lit_2x2,
    gather_lit,
    lit_filtered,
    lit_at,
    depth_at,
    chosen
};

struct snippet;

/// A snippet's GLSL: as it is written down, or what a function puts together each time it is asked for, which spares
/// whoever includes the header the work.
class snippet_text {
public:
    constexpr snippet_text(const char* written) : written_(written) {}
    constexpr snippet_text(std::string (*make)()) : make_(make) {}
    /// Of several snippets, one for each number.
    constexpr snippet_text(std::string (*make)(int), int number) : make_of_(make), number_(number) {}

    [[nodiscard]] std::string str() const { return make_of_ ? make_of_(number_) : (make_ ? make_() : written_); }

private:
    const char* written_ = "";
    std::string (*make_)() = nullptr;
    std::string (*make_of_)(int) = nullptr;
    int number_ = 0;
};

/// One GLSL function (with its overloads) and what is known of it.
struct snippet {
    std::string_view name;       ///< of the C++ twin; the GLSL function is umbrage_<name>
    std::string_view summary{};  ///< one line
    tier exactness = tier::a;
    int operations = 0;       ///< tiers b and c: n of the bound; a division counts 2.5, a root 4.5
    float within = 0.0f;      ///< tier c without n: greatest difference from C++; above 1 a share of it
    bool as_written = false;  ///< `within` holds where + - * round to nearest in written order, no bound elsewhere
    version lowest = version::v100;           ///< v100: every dialect; v300_es: 300 es and 330 upwards
    std::span<const snippet* const> needs{};  ///< a list<>
    hook role = hook::none;
    bool scaled = false;  ///< makes depths on a scale of their own, on which 1.0 is not the far plane
    snippet_text source;

    /// No two have one name.
    friend constexpr bool operator==(const snippet& a, const snippet& b) { return a.name == b.name; }
};

/// Short form of a snippet's promise, e.g. "A", "B, n = 6", "C, within 1/128".
[[nodiscard]] inline std::string promise(const snippet& s) {
    if (s.exactness == tier::a) return "A";
    std::string text = s.exactness == tier::b ? "B, " : "C, ";
    if (s.within > 0.0f)
        text += "within 1/" + std::to_string(static_cast<int>(1.0f / s.within)) + (s.as_written ? " as written" : "");
    else text += "n = " + std::to_string(s.operations);
    return text;
}

/// The bound of tiers B and C in words.
[[nodiscard]] inline std::string bound_in_words(const snippet& s) {
    if (s.within == 0.0f) return "within " + std::to_string(s.operations) + " x 2^-23 x S of the exact result.";
    return "within 1/" + std::to_string(static_cast<int>(1.0f / s.within)) + " of C++" +
           (s.as_written ? " as written. Reordered: no bound, but a visibility is in [0, 1]." : ".");
}

/// Those that one needs.
template <const snippet*... Snippets>
inline constexpr const snippet* list[sizeof...(Snippets)]{Snippets...};

/// True when `s` compiles in dialect `v`.
[[nodiscard]] constexpr bool supports(const snippet& s, version v) {
    return s.lowest == version::v100 || v >= version::v300_es;
}

namespace detail {

struct constant {
    char key;  ///< `$key` in the text
    int value;
    std::string_view text{};  ///< in place of the value's digits, though it be ""
};

/// Appends `text` with each `$key` replaced by the decimal digits of its value, or its text.
template <class Text>
constexpr void append(Text& out, std::string_view text, std::initializer_list<constant> constants) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '$') {
            out.push_back(text[i]);
            continue;
        }
        ++i;
        for (const constant& c : constants) {
            if (c.key != text[i]) continue;
            for (char letter : c.text) out.push_back(letter);
            if (c.text.data() != nullptr) continue;
            if (c.value < 0) out.push_back('-');
            const int digits = c.value < 0 ? -c.value : c.value;
            int unit = 1;
            while (digits / unit >= 10) unit *= 10;
            for (; unit > 0; unit /= 10) out.push_back(static_cast<char>('0' + digits / unit % 10));
        }
    }
}

/// Of a family's member: its text.
[[nodiscard]] inline std::string filled(std::string_view text, std::initializer_list<constant> constants) {
    std::string out;
    append(out, text, constants);
    return out;
}

/// Its name, at compile time.
struct short_name {
    char data[24]{};
    std::size_t size = 0;

    constexpr short_name(std::string_view text, std::initializer_list<constant> constants) {
        append(*this, text, constants);
    }
    constexpr void push_back(char letter) { data[size++] = letter; }
    [[nodiscard]] constexpr std::string_view view() const { return {data, size}; }
};

}  // namespace detail
}  // namespace umbrage::glsl
